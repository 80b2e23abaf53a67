// Fits the open experiment's motor, propeller or lumped rotor to measured data: what is to be found
// at the left, values with their intervals and measured against fitted at the right, below the line
// that says whether they are in doubt. The fit runs on another thread and can be cancelled.
#pragma once

#include <QDialog>
#include <QFutureWatcher>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "sim/fitting/fit_request.h"
#include "sim/logs/measured_table.h"
#include "ui/charts/chart_link.h"
#include "ui/charts/run_set.h"
#include "ui/forms/document_model.h"
#include "ui/forms/form_context.h"
#include "ui/forms/unit_preferences.h"
#include "ui/measurement/fit_target.h"
#include "ui/runs/run_list.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace rotorbench {

class ChartPane;
class ParameterForm;

class FitDialog : public QDialog {
  Q_OBJECT

 public:
  FitDialog(DocumentModel& experiment, const RunList& runs, QWidget* parent = nullptr);
  ~FitDialog() override;

 signals:
  /// One sentence of what was done with the fit.
  void reported(const QString& sentence);

 private:
  struct Measured {
    QString name;
    std::shared_ptr<const Recording> recording;
  };
  /// Shared with the thread that fits.
  struct Progress {
    std::atomic<bool> cancel = false;
    std::atomic<int> iteration = 0;
  };
  struct Outcome {
    FitProblem problem;
    FitResult result;
  };

  void buildPanes();
  QWidget* buildResults();
  void buildButtons();
  [[nodiscard]] MeasuredTable table() const;
  /// Says what is missing, and whether a fit can begin.
  void check();
  void run();
  void finish();
  void showResult();
  void showOutput();
  /// Asks first where the fit is in doubt.
  void use();
  void takeIntoExperiment();
  void save();
  void say(const QString& sentence);

  DocumentModel& experiment_;
  FitTarget target_;
  std::vector<Measured> measured_;
  DocumentModel request_;
  UnitPreferences units_;
  FormContext context_;
  std::shared_ptr<Progress> progress_ = std::make_shared<Progress>();
  QFutureWatcher<Outcome> watcher_;
  QTimer clock_;
  FitRequest asked_;  ///< of the fit that runs or is shown
  FitStart start_;
  QString file_;
  std::optional<Outcome> outcome_;
  std::optional<Component> component_;
  RunSet chartRuns_;
  ChartLink link_;
  ParameterForm* form_;
  QComboBox *set_, *output_;
  QLabel* rows_;
  QLabel* verdict_;  ///< how the fit ended and what is doubtful of it
  QLabel* message_;
  QTableWidget* table_;
  ChartPane* chart_;
  QProgressBar* bar_;
  QWidget* pictures_ = nullptr;  ///< chart and its box
  QPushButton *run_ = nullptr, *cancel_ = nullptr, *use_ = nullptr, *save_ = nullptr;
};

}  // namespace rotorbench
