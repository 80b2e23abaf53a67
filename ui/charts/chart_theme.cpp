#include "ui/charts/chart_theme.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rotorbench {
namespace {

QColor blend(const QColor& a, const QColor& b, double share) {
  const auto mix = [share](double x, double y) { return static_cast<float>(x + share * (y - x)); };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()),
                          mix(a.blueF(), b.blueF()));
}

/// Relative luminance and contrast ratio of WCAG 2.1.
double luminance(const QColor& color) {
  const auto linear = [](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

ChartTheme make(const QColor& ground, const QColor& text, const QColor& accent) {
  ChartTheme theme;
  theme.ground = ground;
  theme.text = text;
  theme.dimText = blend(text, ground, 0.35);
  theme.grid = blend(ground, text, 0.13);
  theme.frame = blend(ground, text, 0.45);
  theme.accent = accent;
  theme.dark = luminance(ground) < 0.18;
  return theme;
}

}  // namespace

ChartTheme ChartTheme::of(const QPalette& palette) {
  return make(palette.color(QPalette::Base), palette.color(QPalette::Text),
              palette.color(QPalette::Highlight));
}

ChartTheme ChartTheme::paper() {
  return make(Qt::white, QColor(0x20, 0x20, 0x20), QColor(0x00, 0x72, 0xb2));
}

QColor ChartTheme::readable(const QColor& color) const {
  // Graphics need 2:1 here and not the 3:1 of WCAG, so that the palette keeps its orange on white.
  constexpr double kContrast = 2.0;
  const double wanted = dark ? 4.0 : kContrast;
  QColor result = color;
  for (int i = 0; i < 8 && contrast(result, ground) < wanted; ++i)
    result = blend(result, text, 0.15);
  return result;
}

QPen curvePen(const CurveStyle& style, const ChartTheme& theme, qreal width) {
  if (!style.line) return QPen(Qt::NoPen);
  static const std::array<QList<qreal>, kDashCount> kDashes{
      QList<qreal>{}, {6, 3}, {2, 2}, {8, 3, 2, 3}, {12, 4}, {8, 2, 2, 2, 2, 2}};
  QPen pen(theme.readable(style.color), width);
  pen.setCapStyle(Qt::FlatCap);
  pen.setJoinStyle(Qt::RoundJoin);
  const auto& dash = kDashes.at(static_cast<std::size_t>(style.dash) % kDashes.size());
  if (!dash.isEmpty()) {
    QList<qreal> scaled = dash;
    for (qreal& length : scaled) length *= std::max(1.0, 1.3 / width);
    pen.setDashPattern(scaled);
  } else {
    pen.setCapStyle(Qt::RoundCap);
  }
  return pen;
}

int indexInName(const std::string& channelName) {
  // Digits count where they end a part of the path: in "rotor3.thrust", not in "x2y".
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t end = 1; end <= channelName.size(); ++end) {
    const bool partEnds = end == channelName.size() || channelName[end] == '.';
    if (!partEnds || !isDigit(channelName[end - 1])) continue;
    std::size_t begin = end - 1;
    while (begin > 0 && isDigit(channelName[begin - 1]) && end - begin < 6) --begin;
    return std::stoi(channelName.substr(begin, end - begin));
  }
  return 0;
}

}  // namespace rotorbench
