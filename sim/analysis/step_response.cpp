#include "sim/analysis/step_response.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rotorbench {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kSettlingBand = 0.02;

double worse(double a, double b) {
  return std::isnan(a) || a < b ? b : a;
}

/// Time of the first row at which the response has covered `fraction` of the step.
double firstCrossing(const Recording& recording, const StepWindow& w, double fraction) {
  const double size = w.after - w.before;
  for (std::size_t row = w.firstRow; row < w.endRow; ++row) {
    if ((recording.value(w.channel, row) - w.before) / size >= fraction)
      return recording.value(0, row);
  }
  return kNone;
}

/// Time of the first row after which the response stays in the band.
double settledSince(const Recording& recording, const StepWindow& w, double band) {
  for (std::size_t row = w.endRow; row > w.firstRow; --row) {
    if (std::abs(recording.value(w.channel, row - 1) - w.after) > band) {
      return row < w.endRow ? recording.value(0, row) : kNone;
    }
  }
  return recording.value(0, w.firstRow);
}

}  // namespace

StepFigures stepFigures(const Recording& recording, const StepWindow& w) {
  StepFigures figures{kNone, kNone, kNone, kNone};
  if (w.endRow <= w.firstRow) return figures;
  const std::size_t lastTenth = std::max<std::size_t>(1, (w.endRow - w.firstRow) / 10);
  figures.restError = 0;
  for (std::size_t row = w.endRow - lastTenth; row < w.endRow; ++row) {
    figures.restError =
        std::max(figures.restError, std::abs(recording.value(w.channel, row) - w.after));
  }
  const double size = w.after - w.before;
  if (size == 0 || w.endRow - w.firstRow < 2) return figures;
  figures.overshoot = 0;
  for (std::size_t row = w.firstRow; row < w.endRow; ++row) {
    figures.overshoot =
        std::max(figures.overshoot, (recording.value(w.channel, row) - w.after) / size);
  }
  figures.riseTime = firstCrossing(recording, w, 0.9) - firstCrossing(recording, w, 0.1);
  figures.settlingTime =
      settledSince(recording, w, kSettlingBand * std::abs(size)) - recording.value(0, w.firstRow);
  return figures;
}

StepFigures worstFigures(const Recording& recording, std::size_t channel,
                         const std::vector<SetPointChange>& changes) {
  StepFigures worst{kNone, kNone, kNone, kNone};
  if (recording.rows() == 0) return worst;
  bool settled = true;
  double before = recording.value(channel, 0);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const double after = changes[i].value;
    const std::size_t first = recording.lowerBound(changes[i].time);
    const std::size_t end =
        i + 1 < changes.size() ? recording.lowerBound(changes[i + 1].time) : recording.rows();
    if (first >= end) break;
    const StepFigures f = stepFigures(recording, {channel, first, end, before, after});
    worst.restError = worse(worst.restError, f.restError);
    if (std::abs(after - before) > 1e-9) {
      worst.riseTime = worse(worst.riseTime, f.riseTime);
      worst.overshoot = worse(worst.overshoot, f.overshoot);
      worst.settlingTime = worse(worst.settlingTime, f.settlingTime);
      settled = settled && !std::isnan(f.settlingTime);
    }
    before = after;
  }
  if (!settled) worst.settlingTime = kNone;
  return worst;
}

}  // namespace rotorbench
