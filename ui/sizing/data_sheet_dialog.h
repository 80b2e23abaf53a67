// Motor from a data sheet: what sellers print at the left, what follows from it at the right, at
// once, with formulas, warnings and a chart; and a button that puts the drive into the open
// experiment as one undo step.
#pragma once

#include <QDialog>
#include <QSettings>

#include "sim/sizing/data_sheet.h"
#include "sim/sizing/data_sheet_figures.h"
#include "ui/forms/document_model.h"
#include "ui/forms/form_context.h"
#include "ui/sizing/latest_result.h"

class QLabel;
class QPushButton;

namespace rotorbench {

class FigureTable;
class ParameterForm;
class ThrottleChart;

class DataSheetDialog : public QDialog {
  Q_OBJECT

 public:
  /// `experiment` holds the open experiment and outlives the dialog, which starts from its motor if
  /// it has one.
  explicit DataSheetDialog(DocumentModel& experiment, QWidget* parent = nullptr);
  ~DataSheetDialog() override;

  [[nodiscard]] DocumentModel& sheet() { return sheet_; }

 signals:
  /// The drive was put into the experiment; a sentence for the status bar.
  void applied(const QString& sentence);

 private:
  struct Result {
    FigureSheet figures;
    ThrottleCurve curve;
    QString problem;
  };

  void buildPanes();
  void buildButtons();
  void updateTarget();
  void readExperiment();
  void saveMotor();
  void apply();
  [[nodiscard]] LatestResult<Result>::Job prepare() const;
  void showResult(const Result& result);

  DocumentModel& experiment_;
  DocumentModel sheet_;
  QSettings unitSettings_;
  UnitPreferences units_;
  FormContext context_;
  ParameterForm* form_;
  FigureTable* table_;
  ThrottleChart* chart_;
  QPushButton* apply_ = nullptr;
  QPushButton* read_ = nullptr;
  QLabel* target_;
  LatestResult<Result> result_;
};

}  // namespace rotorbench
