// Thrust and current of one drive over the throttle, with the hover point, as one of the program's
// charts.
#pragma once

#include <QWidget>

#include "sim/sizing/data_sheet_figures.h"
#include "ui/charts/chart_link.h"
#include "ui/charts/run_set.h"

namespace rotorbench {

class ChartPane;

class ThrottleChart : public QWidget {
  Q_OBJECT

 public:
  explicit ThrottleChart(QWidget* parent = nullptr);
  ~ThrottleChart() override;

  void setCurve(const ThrottleCurve& curve);
  [[nodiscard]] ChartPane& pane() { return *pane_; }

 private:
  RunSet runs_;
  ChartLink link_;
  ChartPane* pane_;
};

}  // namespace rotorbench
