// The unit beside a number: dimmed until the pointer is on it; a click offers the units of the same
// dimension.
#pragma once

#include <QToolButton>

#include "ui/forms/form_context.h"

class QMenu;

namespace rotorbench {

/// The units of a field as a menu that switches the preference; null if there is only one.
QMenu* makeUnitMenu(const FormContext& context, const schema::Field& field, QWidget* parent);

class UnitButton : public QToolButton {
  Q_OBJECT

 public:
  UnitButton(const FormContext& context, const schema::Field& field, QWidget* parent);
  /// Shows the unit of the preferences.
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showMenu();

  const FormContext& context_;
  const schema::Field& field_;
};

}  // namespace rotorbench
