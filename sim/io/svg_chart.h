// A chart of curves and points as an SVG element, to stand inside a page. Text and axes take the
// colour of the page (currentColor), so that it can be light or dark; the curves have the colours
// of Okabe and Ito (2008), which stay distinct for colour-blind readers. Values in the units the
// labels name.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rotorbench {

struct SvgSeries {
  enum class Style { Line, Dashed, Points };
  std::string name;  ///< in the legend; empty: not named there
  Style style = Style::Line;
  int color = 0;  ///< number of the colour, 0 to 6; beyond that they repeat
  std::vector<std::array<double, 2>> points;  ///< a point that is not finite ends a line
};

struct SvgAxis {
  std::string label;                            ///< with its unit: "Speed, rpm"
  std::optional<double> least = {}, most = {};  ///< else from the points
};

struct SvgChart {
  std::string title;
  SvgAxis x, y;
  std::vector<SvgSeries> series;
  double width = 460, height = 300;  ///< of the picture, in its own units
};

/// Marks of an axis: at most about `most` round numbers (1, 2 or 5 times a power of ten apart) that
/// cover least to greatest, which may be equal or the wrong way round.
std::vector<double> axisTicks(double least, double greatest, int most = 7);

/// One <svg> element, with title, axes, marks, legend and all points. Series without points are
/// left out.
std::string svgChart(const SvgChart& chart);

/// Text made safe inside HTML and SVG.
std::string escapedMarkup(const std::string& text);

}  // namespace rotorbench
