// The curves of one chart: which channels of which runs it draws, how they are named, coloured and
// dashed, and on which axis they stand.
#pragma once

#include <QSet>
#include <QString>
#include <memory>
#include <vector>

#include "sim/core/recording.h"
#include "sim/document/chart_spec.h"
#include "ui/charts/chart_theme.h"
#include "ui/charts/run_set.h"

namespace rotorbench {

struct Curve {
  QString runId, runName;
  std::shared_ptr<const Recording> recording;
  std::size_t xChannel = 0, yChannel = 0;
  QString label;  ///< as in the legend: the channel, after the run's name if several runs are shown
  QString shortLabel;    ///< the same without what all curves of the chart have in common
  std::size_t axis = 0;  ///< index into the units of the chart
  CurveStyle style;
  bool hidden = false;

  [[nodiscard]] const Channel& y() const { return recording->channels()[yChannel]; }
  [[nodiscard]] const Channel& x() const { return recording->channels()[xChannel]; }
};

/// Which curves a person switched off in the legend. Curves of a single shown run are remembered by
/// channel, so that they stay off when the experiment runs again.
class HiddenCurves {
 public:
  [[nodiscard]] bool contains(const Curve& curve) const;
  /// `curves` are all curves of the chart.
  void toggle(const Curve& curve, const std::vector<Curve>& curves);
  void clear();

 private:
  QSet<QString> channels_;
  QSet<QString> runChannels_;
};

/// All curves of a chart and the units of its axes, in the order of appearance.
struct CurveList {
  std::vector<Curve> curves;
  std::vector<std::string> units;
};
CurveList chartCurves(const ChartSpec& spec, const RunSet& runs, const HiddenCurves& hidden);

/// What the curves on axis `axis` have in common, for its title: "thrust" of rotor1.thrust and
/// rotor2.thrust, "x, y, z" of position.x, position.y, position.z. Empty if they are too many.
QString axisQuantity(const CurveList& list, std::size_t axis);
/// The same for the horizontal axis.
QString abscissaQuantity(const CurveList& list);

}  // namespace rotorbench
