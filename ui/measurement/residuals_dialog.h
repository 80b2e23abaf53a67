// A measured run against a computed one: for each channel both have, how far they are apart, and
// the residuals of one of them as a chart.
#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "sim/core/recording.h"
#include "ui/charts/chart_link.h"
#include "ui/charts/run_set.h"
#include "ui/runs/run_list.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace rotorbench {

class ChartPane;

class ResidualsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ResidualsDialog(const RunList& runs, QWidget* parent = nullptr);
  ~ResidualsDialog() override;

 private:
  struct Choice {
    QString name;
    std::shared_ptr<const Recording> recording;
  };

  void build();
  /// Computed recordings that have the abscissa of the chosen measured one.
  void fillComputed();
  void compare();
  void showChannel();

  std::vector<Choice> measured_, computed_;
  std::vector<Choice> offered_;  ///< of computed_, in the order of the box
  RunSet chartRuns_;
  ChartLink link_;
  QComboBox* measuredBox_ = nullptr;
  QComboBox* computedBox_ = nullptr;
  QTableWidget* table_ = nullptr;
  QLabel* sentence_ = nullptr;
  ChartPane* chart_ = nullptr;
};

}  // namespace rotorbench
