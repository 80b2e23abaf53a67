// Performance of the vehicle: what the open experiment's vehicle lifts, how long and how fast it
// flies, and which limit decides each figure. Follows the document while it is edited.
#pragma once

#include <QDialog>
#include <QLocale>
#include <QSettings>

#include "sim/sizing/figure.h"
#include "ui/forms/document_model.h"
#include "ui/forms/form_context.h"
#include "ui/sizing/latest_result.h"

class QLabel;

namespace rotorbench {

class FigureTable;
class ParameterForm;

class PerformanceDialog : public QDialog {
  Q_OBJECT

 public:
  /// `experiment` holds the open experiment and outlives the dialog.
  explicit PerformanceDialog(DocumentModel& experiment, QWidget* parent = nullptr);
  ~PerformanceDialog() override;

 private:
  struct Result {
    FigureSheet figures;
    QString problem;
  };

  void build();
  [[nodiscard]] LatestResult<Result>::Job prepare() const;
  void showResult(const Result& result);

  DocumentModel& experiment_;
  DocumentModel settings_;
  QSettings unitSettings_;
  UnitPreferences units_;
  FormContext context_;
  ParameterForm* form_;
  FigureTable* table_;
  QLabel* title_;
  LatestResult<Result> result_;
};

}  // namespace rotorbench
