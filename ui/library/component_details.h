// All about one component: its name, summary, warning and source as text, and its values.
#pragma once

#include <QLocale>
#include <QScrollArea>

#include "sim/library/component.h"
#include "ui/forms/unit_preferences.h"

class QLabel;
class QTreeWidget;

namespace rotorbench {

class ComponentDetails : public QWidget {
  Q_OBJECT

 public:
  explicit ComponentDetails(const UnitPreferences& units, QWidget* parent = nullptr);
  /// Null: nothing is chosen.
  void show(const Component* component);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QLabel* addText(const char* name, const QString& accessibleName);
  void colour();

  const UnitPreferences& units_;
  QLocale locale_;
  QLabel *name_, *summary_, *warning_, *source_;
  QTreeWidget* values_;
};

}  // namespace rotorbench
