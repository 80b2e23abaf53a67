#include "ui/charts/axis_scale.h"

#include <algorithm>
#include <cmath>

#include "sim/core/axis_marks.h"
#include "sim/core/unit_text.h"

namespace rotorbench {
namespace {

/// Within this many decades plain numbers read better than a common power of ten.
constexpr int kPlainExponent = 4;
constexpr double kRounding = 1e-9;  // of a decade

Ticks linearTicks(const AxisScale& scale, int most, const QLocale& locale) {
  Ticks ticks;
  const double step = markStep(scale.span.width(), most);
  const double largest = std::max(std::abs(scale.span.low), std::abs(scale.span.high));
  const int magnitude = static_cast<int>(std::floor(std::log10(largest)));
  if (magnitude > kPlainExponent || magnitude < -kPlainExponent + 1) ticks.exponent = magnitude;
  const double unit = std::pow(10.0, ticks.exponent);
  const int decimals = std::min(12, markDecimals(step / unit));
  for (const double value : marksWithin(scale.span.low, scale.span.high, step)) {
    QString label = locale.toString(value / unit, 'f', decimals);
    ticks.major.push_back({value, label.replace(u'-', QChar(u'−'))});
  }
  return ticks;
}

QString logLabel(int exponent, bool plain, const QLocale& locale) {
  if (!plain) return powerOfTen(exponent);
  return locale.toString(std::pow(10.0, exponent), 'f', std::max(0, -exponent));
}

Ticks logTicks(const AxisScale& scale, int most, const QLocale& locale) {
  const int first = static_cast<int>(std::ceil(std::log10(scale.span.low) - kRounding));
  const int last = static_cast<int>(std::floor(std::log10(scale.span.high) + kRounding));
  if (last - first < 1) return linearTicks(scale, std::max(2, most / 2), locale);
  Ticks ticks;
  const int every = std::max(1, (last - first + most) / std::max(1, most));
  const bool plain = first >= -2 && last <= 3;
  for (int e = first; e <= last; ++e) {
    const double value = std::pow(10.0, e);
    if ((e - first) % every == 0) {
      ticks.major.push_back({value, logLabel(e, plain, locale)});
    } else {
      ticks.minor.push_back(value);
    }
  }
  for (int e = first - 1; every == 1 && e <= last; ++e) {
    for (int digit = 2; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, e);
      if (value > scale.span.low && value < scale.span.high) ticks.minor.push_back(value);
    }
  }
  return ticks;
}

}  // namespace

double AxisScale::toUnit(double value) const {
  if (!log) return (value - span.low) / (span.high - span.low);
  if (!(value > 0)) return std::nan("");
  return std::log(value / span.low) / std::log(span.high / span.low);
}

double AxisScale::fromUnit(double unit) const {
  if (log) return span.low * std::pow(span.high / span.low, unit);
  return span.low + unit * (span.high - span.low);
}

Ticks niceTicks(const AxisScale& scale, int most, const QLocale& locale) {
  if (!isUsable(scale.span, scale.log)) return {};
  return scale.log ? logTicks(scale, most, locale) : linearTicks(scale, most, locale);
}

Span niceSpan(Span data, bool log, int ticks) {
  if (log) {
    if (!(data.low > 0) || !(data.high >= data.low)) return {0.1, 1};
    const double low = std::pow(10.0, std::floor(std::log10(data.low) + kRounding));
    const double high = std::pow(10.0, std::ceil(std::log10(data.high) - kRounding));
    return {low, high > low ? high : 10 * low};
  }
  if (!(data.high >= data.low)) return {0, 1};
  if (data.width() <= 1e-12 * std::max(std::abs(data.low), std::abs(data.high))) {
    const double margin = data.high == 0 ? 1 : 0.1 * std::abs(data.high);
    data = {data.low - margin, data.high + margin};
  }
  const auto [low, high] = marksBeyond(data.low, data.high, markStep(data.width(), ticks));
  return {low, high};
}

double roomyEnd(double low, double high) {
  const double width = high - low;
  if (!(width > 0)) return low + 1;
  const double power = std::pow(10.0, std::floor(std::log10(width)));
  for (const double digit : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (digit * power >= width) return low + digit * power;
  }
  return low + 10 * power;
}

Span zoomed(const AxisScale& scale, double unit, double factor) {
  return part(scale, unit - unit * factor, unit + (1 - unit) * factor);
}

Span panned(const AxisScale& scale, double by) {
  return part(scale, by, 1 + by);
}

Span part(const AxisScale& scale, double unitA, double unitB) {
  return {scale.fromUnit(std::min(unitA, unitB)), scale.fromUnit(std::max(unitA, unitB))};
}

bool isUsable(Span span, bool log) {
  if (!std::isfinite(span.low) || !std::isfinite(span.high)) return false;
  if (log && !(span.low > 0)) return false;
  const double largest = std::max(std::abs(span.low), std::abs(span.high));
  return span.width() > 1e-12 * largest && largest < 1e300;
}

QString powerOfTen(int exponent) {
  return QStringLiteral("10") + QString::fromStdString(superscript(exponent));
}

QString axisTitle(const QString& quantity, const std::string& unit, int exponent) {
  QString bracket = QString::fromStdString(prettyUnit(unit));
  if (exponent != 0) bracket = (powerOfTen(exponent) + QChar(u' ') + bracket).trimmed();
  if (bracket.isEmpty()) return quantity;
  return (quantity + QStringLiteral(" [%1]").arg(bracket)).trimmed();
}

}  // namespace rotorbench
