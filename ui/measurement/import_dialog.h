// Import of measured data: the file, how its lines are cut, what each column is, and in sentences
// what will come of it. The result is a measured run beside the computed ones.
#pragma once

#include <QDialog>
#include <QTimer>
#include <optional>

#include "sim/logs/csv_import.h"
#include "ui/runs/run_list.h"

class QComboBox;
class QDialogButtonBox;
class QLineEdit;
class QPlainTextEdit;

namespace rotorbench {

class LayoutRow;
class MappingTable;
class PropellerRow;

class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ImportDialog(RunList& runs, QWidget* parent = nullptr);
  ~ImportDialog() override;

  /// Reads the file and guesses what it holds, or takes what was chosen for such a file before.
  void openFile(const QString& file);

 signals:
  /// A measured run was added, or a propeller was saved; one sentence about it.
  void imported(const QString& sentence);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void build();
  void browse();
  void takeSettings(const ImportSettings& settings);
  void layoutEdited();
  void mappingEdited();
  void check();
  void finish();
  void say(const QString& text, bool usable);

  RunList& runs_;
  std::optional<TextLines> lines_;
  ImportSettings settings_;
  CsvPreview preview_;
  CsvPreview guessed_;  ///< in the layout nobody changed yet: what the choices are remembered for
  QTimer checkTimer_;

  QLineEdit* file_ = nullptr;
  QLineEdit* name_ = nullptr;
  LayoutRow* layoutRow_ = nullptr;
  QComboBox* group_ = nullptr;
  MappingTable* table_ = nullptr;
  PropellerRow* propeller_ = nullptr;
  QPlainTextEdit* report_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace rotorbench
