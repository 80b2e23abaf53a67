// The panel at the left of the window: the tree of sections above the form of the chosen one. Give
// it a document model and it edits that document, whatever its type.
#pragma once

#include <QWidget>

#include "ui/forms/form_context.h"

class QLabel;
class QSettings;
class QSplitter;

namespace rotorbench {

class ParameterForm;
class SectionTree;

class ExperimentPanel : public QWidget {
  Q_OBJECT

 public:
  /// `model` must outlive the panel; `settings` keeps the chosen units and may be null.
  ExperimentPanel(DocumentModel* model, QSettings* settings, QWidget* parent = nullptr);
  ~ExperimentPanel() override;

  /// Names offered in fields that hold channel names.
  void setChannelNames(std::function<QStringList()> names);
  /// Whether a part of the document has ready components, and what opens the picker for it.
  void setComponents(std::function<bool(const QString& path)> has,
                     std::function<void(const QString& path)> pick);
  /// A flight of the document goes on under this name: says which fields act at once. Empty: none.
  void setFlying(const QString& run);
  [[nodiscard]] UnitPreferences* units() { return &units_; }
  [[nodiscard]] ParameterForm* form() { return form_; }
  [[nodiscard]] SectionTree* tree() { return tree_; }

 public slots:
  void showSection(const QString& path);
  /// Shows the section that holds `path` and puts the focus on its field.
  void jumpTo(const QString& path);
  /// Puts the focus into the search line.
  void findParameter();

 private:
  UnitPreferences units_;
  FormContext context_;
  SectionTree* tree_;
  ParameterForm* form_;
  QLabel* flying_;
};

}  // namespace rotorbench
