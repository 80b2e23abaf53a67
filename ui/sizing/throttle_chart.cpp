#include "ui/sizing/throttle_chart.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

#include "ui/charts/chart_pane.h"
#include "ui/charts/export_figure.h"

namespace rotorbench {

namespace {

/// The curve as a recording; the hover is a sample of its own, in channels that have no other.
std::shared_ptr<const Recording> recorded(const ThrottleCurve& curve) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  auto recording =
      std::make_shared<Recording>(std::vector<Channel>{{"throttle", "1", "Throttle"},
                                                       {"thrust", "N", "Thrust of one rotor"},
                                                       {"current", "A", "Current of one motor"},
                                                       {"hover.thrust", "N", "Thrust in hover"},
                                                       {"hover.current", "A", "Current in hover"}});
  auto points = curve.points;
  points.insert(points.end(), curve.hover.begin(), curve.hover.end());
  std::ranges::sort(points, {}, &ThrottleCurve::Point::throttle);
  for (const auto& p : points) {
    const bool hover = !curve.hover.empty() && p.throttle == curve.hover.front().throttle;
    const double row[] = {p.throttle, p.thrust, p.current, hover ? p.thrust : kNone,
                          hover ? p.current : kNone};
    recording->append(row);
  }
  recording->publish();
  recording->finish();
  return recording;
}

/// A chart of its own has no others beside it.
void dropGridActions(ChartPane& pane) {
  for (const char* name : {"splitRight", "splitBelow", "maximizeChartAction", "removeChart",
                           "exportChart", "followNewest"}) {
    if (auto* action = pane.findChild<QAction*>(name)) {
      action->setVisible(false);
      action->setEnabled(false);
    }
  }
  if (auto* button = pane.findChild<QToolButton*>("maximizeChart")) button->hide();
}

}  // namespace

ThrottleChart::ThrottleChart(QWidget* parent)
    : QWidget(parent), pane_(new ChartPane(&runs_, &link_)) {
  setObjectName("throttleChart");
  setAccessibleName(tr("Thrust and current over throttle"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(pane_);
  pane_->setSpec({.title = tr("One drive over throttle").toStdString(),
                  .kind = ChartKind::XY,
                  .x = "throttle",
                  .channels = "thrust, current, hover.thrust, hover.current"});
  dropGridActions(*pane_);
  connect(pane_, &ChartPane::copyAsked, this, [this] { copyPane(*pane_); });
}

// The pane looks at runs and link to its end.
ThrottleChart::~ThrottleChart() {
  delete pane_;
}

void ThrottleChart::setCurve(const ThrottleCurve& curve) {
  runs_.setRuns({{.id = "drive",
                  .name = tr("drive"),
                  .color = palette().color(QPalette::Highlight),
                  .recording = recorded(curve)}});
  pane_->refresh();
}

}  // namespace rotorbench
