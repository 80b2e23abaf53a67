// Colours and dashes of charts: a calm ground taken from the system's palette, curves in a
// colour-blind-safe palette, one dash per rotor.
#pragma once

#include <QColor>
#include <QPalette>
#include <QPen>

namespace rotorbench {

struct ChartTheme {
  QColor ground, text, dimText, grid, frame, accent;
  bool dark = false;

  static ChartTheme of(const QPalette& palette);
  /// Black on white, for figures that leave the program.
  static ChartTheme paper();

  /// `color` made light enough (or dark enough) to be told from the ground.
  [[nodiscard]] QColor readable(const QColor& color) const;
};

/// How a curve is drawn: the same dash index is the same dash everywhere.
struct CurveStyle {
  QColor color;
  int dash = 0;
  bool markers = false;
  bool line = true;  ///< else marks only, as for measured data
  bool operator==(const CurveStyle&) const = default;
};

inline constexpr int kDashCount = 6;
QPen curvePen(const CurveStyle& style, const ChartTheme& theme, qreal width);

/// The index in a channel name ("rotor3.thrust": 3), or 0 without one.
int indexInName(const std::string& channelName);

}  // namespace rotorbench
