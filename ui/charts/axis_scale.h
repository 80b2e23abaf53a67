// The scale of one chart axis: data to 0..1 and back, linear or logarithmic, nice ticks and their
// labels, zooming and panning.
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

namespace rotorbench {

struct Span {
  double low = 0;
  double high = 1;
  bool operator==(const Span&) const = default;
  [[nodiscard]] double width() const { return high - low; }
};

struct AxisScale {
  Span span;
  bool log = false;
  bool operator==(const AxisScale&) const = default;

  /// 0 at the low end, 1 at the high end; NaN where a logarithm does not exist.
  [[nodiscard]] double toUnit(double value) const;
  [[nodiscard]] double fromUnit(double unit) const;
};

struct Tick {
  double value = 0;
  QString label;
};

/// Ticks at 1, 2 or 5 times a power of ten; at whole powers on a logarithmic scale where it spans
/// at least one decade. Labels leave out 10^exponent, which belongs beside the unit of the axis.
struct Ticks {
  std::vector<Tick> major;
  std::vector<double> minor;  ///< logarithmic scales only
  int exponent = 0;
};
/// At most about `most` ticks with labels.
Ticks niceTicks(const AxisScale& scale, int most, const QLocale& locale);

/// The smallest range with nice ends that holds `data`, for about `ticks` ticks. An empty or
/// reversed range gives the standard one (0 to 1, or 0.1 to 1 on a logarithmic scale).
Span niceSpan(Span data, bool log, int ticks);

/// The next rounder end for a range that starts at `low` and grows: it changes seldom.
double roomyEnd(double low, double high);

/// The scale seen after zooming by `factor` (below 1: closer) around the place `unit` of the axis.
Span zoomed(const AxisScale& scale, double unit, double factor);
/// The scale seen after moving by `by` axis lengths.
Span panned(const AxisScale& scale, double by);
/// The part between two places of the axis, in any order.
Span part(const AxisScale& scale, double unitA, double unitB);
/// False for ranges that are empty, not finite or beyond what doubles resolve.
bool isUsable(Span span, bool log);

/// "10⁻⁹"
QString powerOfTen(int exponent);
/// "thrust [N]", "error [10⁻⁹ m]", "duty".
QString axisTitle(const QString& quantity, const std::string& unit, int exponent);

}  // namespace rotorbench
