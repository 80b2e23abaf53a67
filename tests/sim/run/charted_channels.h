// What a chart finds in the recordings of an experiment, told from the description of the file
// format and without the window's code, which other tests hold against the same words.
#pragma once

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "sim/document/chart_spec.h"
#include "sim/run/simulation.h"

namespace rotorbench::test {

/// A * stands for any text without a dot.
inline QRegularExpression expressionOf(const QString& pattern) {
  return QRegularExpression(QRegularExpression::anchoredPattern(
      QRegularExpression::escape(pattern.trimmed()).replace("\\*", "([^.]*)")));
}

/// What a chart wants of a recording to be drawn.
enum class Wanted { Names, Values };

/// Whether `recording` has a channel of that pattern and, in a chart of kind xy, one to draw it
/// over.
inline bool draws(const ChartSpec& chart, const QString& pattern, const Recording& recording,
                  Wanted wanted) {
  const auto& channels = recording.channels();
  const auto drawn = [&](std::size_t x, std::size_t y) {
    if (wanted == Wanted::Names) return true;
    for (std::size_t row = 0; row < recording.rows(); ++row)
      if (std::isfinite(recording.value(x, row)) && std::isfinite(recording.value(y, row)))
        return true;
    return false;
  };
  const QRegularExpression yName = expressionOf(pattern);
  const QRegularExpression xName = expressionOf(QString::fromStdString(chart.x));
  for (std::size_t y = 0; y < channels.size(); ++y) {
    const auto ofY = yName.match(QString::fromStdString(channels[y].name));
    if (!ofY.hasMatch()) continue;
    if (chart.kind == ChartKind::Time && drawn(0, y)) return true;
    if (chart.kind == ChartKind::Time) continue;
    for (std::size_t x = 0; x < channels.size(); ++x) {
      const auto ofX = xName.match(QString::fromStdString(channels[x].name));
      const bool both = ofX.lastCapturedIndex() > 0 && ofY.lastCapturedIndex() > 0;
      if (ofX.hasMatch() && (!both || ofX.captured(1) == ofY.captured(1)) && drawn(x, y))
        return true;
    }
  }
  return false;
}

/// The patterns of a chart that no run draws.
inline QStringList undrawn(const ChartSpec& chart, const std::vector<RunOutput>& runs,
                           Wanted wanted) {
  QStringList missing;
  for (const QString& part : QString::fromStdString(chart.channels).split(',')) {
    const QString pattern = part.trimmed();
    if (!std::ranges::any_of(
            runs, [&](const auto& run) { return draws(chart, pattern, *run.recording, wanted); }))
      missing << pattern;
  }
  return missing;
}

}  // namespace rotorbench::test
