#include "sim/io/svg_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "sim/core/axis_marks.h"
#include "sim/io/label_width.h"

namespace rotorbench {

namespace {

constexpr std::array<const char*, 7> kColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#8c8c8c"};
constexpr double kFont = 12, kLine = 17;
constexpr double kLeastLeft = 62, kRight = 14, kTop = 30, kBottom = 44, kLegendName = 32,
                 kTickGap = 6;

std::string number(double value, const char* format) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}
std::string pixel(double value) {
  return number(value, "%.1f");
}

/// A range with a way to pictures' units; the ends are marks.
struct Scale {
  std::vector<double> ticks;
  double from = 0, to = 1;  // picture
  [[nodiscard]] double at(double value) const {
    return from + (value - ticks.front()) / (ticks.back() - ticks.front()) * (to - from);
  }
};

Scale scaleOf(const SvgChart& chart, const SvgAxis& axis, std::size_t index, double from,
              double to) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const SvgSeries& series : chart.series) {
    for (const auto& point : series.points) {
      if (!std::isfinite(point[0]) || !std::isfinite(point[1])) continue;
      least = std::min(least, point.at(index));
      most = std::max(most, point.at(index));
    }
  }
  if (!(least <= most)) least = 0, most = 1;
  return {axisTicks(axis.least.value_or(least), axis.most.value_or(most)), from, to};
}

std::string text(double x, double y, const char* anchor, const std::string& content,
                 const std::string& more = {}) {
  return "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" text-anchor=\"" + anchor + "\"" +
         more + ">" + escapedMarkup(content) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* kind) {
  return "<line class=\"" + std::string(kind) + "\" x1=\"" + pixel(x1) + "\" y1=\"" + pixel(y1) +
         "\" x2=\"" + pixel(x2) + "\" y2=\"" + pixel(y2) + "\"/>\n";
}

/// A mark with the digits its neighbours need.
std::string tickText(const std::vector<double>& ticks, double tick) {
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
  if (std::max(std::abs(ticks.front()), std::abs(ticks.back())) >= 1e6) {
    return number(tick, "%g");
  }
  const int decimals = std::min(markDecimals(step), 9);
  return number(std::abs(tick) < step / 1e6 ? 0 : tick,
                ("%." + std::to_string(decimals) + "f").c_str());
}

/// Lines of text, one below the other from `y` on.
std::string lines(double x, double y, const char* anchor, const std::vector<std::string>& content,
                  const std::string& more = {}) {
  std::string svg;
  for (const std::string& part : content) {
    svg += text(x, y, anchor, part, more);
    y += kLine;
  }
  return svg;
}

/// Where the parts of a chart stand: as much room as its texts take.
struct Layout {
  std::vector<std::string> title, xLabel, yLabel;
  std::vector<std::vector<std::string>> names;  // of the series in the legend
  Scale x, y;
  double legendTop = 0, height = 0;
};

bool inLegend(const SvgSeries& series) {
  return !series.name.empty() && !series.points.empty();
}

Layout layOut(const SvgChart& chart) {
  Layout l;
  l.title = wrappedLabel(chart.title, chart.width - kLeastLeft - kRight, kFont, true);
  const double top = kTop + kLine * static_cast<double>(l.title.size() - 1);
  const double bottom = top - kTop + chart.height - kBottom;
  l.y = scaleOf(chart, chart.y, 1, bottom, top);
  l.yLabel = wrappedLabel(chart.y.label, bottom - top, kFont);
  double tickWidth = 0;
  for (const double tick : l.y.ticks)
    tickWidth = std::max(tickWidth, labelWidth(tickText(l.y.ticks, tick), kFont));
  const double left =
      std::max(kLeastLeft, kLine * static_cast<double>(l.yLabel.size()) + kTickGap + tickWidth);
  l.x = scaleOf(chart, chart.x, 0, left, chart.width - kRight);
  // The last mark stands at the end of the axis and reaches beyond it by its half.
  const double beyond = labelWidth(tickText(l.x.ticks, l.x.ticks.back()), kFont) / 2;
  l.x.to = chart.width - std::max(kRight, beyond);
  l.xLabel = wrappedLabel(chart.x.label, l.x.to - l.x.from, kFont);
  l.legendTop = bottom + kBottom + 8 + kLine * static_cast<double>(l.xLabel.size() - 1);
  l.height = l.legendTop - 8;
  for (const SvgSeries& s : chart.series) {
    if (!inLegend(s)) continue;
    l.names.push_back(wrappedLabel(s.name, chart.width - left - kLegendName - kRight, kFont));
    l.height += kLine * static_cast<double>(l.names.back().size());
  }
  return l;
}

std::string axes(const Layout& l) {
  const Scale &x = l.x, &y = l.y;
  std::string svg;
  for (const double tick : x.ticks) {
    svg += line(x.at(tick), y.from, x.at(tick), y.to, "grid");
    svg += text(x.at(tick), y.from + 16, "middle", tickText(x.ticks, tick));
  }
  for (const double tick : y.ticks) {
    svg += line(x.from, y.at(tick), x.to, y.at(tick), "grid");
    svg += text(x.from - kTickGap, y.at(tick) + 4, "end", tickText(y.ticks, tick));
  }
  svg += line(x.from, y.from, x.to, y.from, "axis") + line(x.from, y.from, x.from, y.to, "axis");
  svg += lines((x.from + x.to) / 2, y.from + 34, "middle", l.xLabel);
  const double middle = (y.from + y.to) / 2;
  for (std::size_t i = 0; i < l.yLabel.size(); ++i) {
    const double at = 14 + kLine * static_cast<double>(i);
    svg += text(at, middle, "middle", l.yLabel[i],
                " transform=\"rotate(-90 " + pixel(at) + " " + pixel(middle) + ")\"");
  }
  return svg;
}

std::string curve(const SvgSeries& series, const Scale& x, const Scale& y) {
  const std::string color = kColors.at(static_cast<std::size_t>(series.color) % kColors.size());
  std::string path, dots;
  bool open = false;
  for (const auto& point : series.points) {
    if (!std::isfinite(point[0]) || !std::isfinite(point[1])) {
      open = false;
      continue;
    }
    const std::string px = pixel(x.at(point[0])), py = pixel(y.at(point[1]));
    if (series.style == SvgSeries::Style::Points) {
      dots.append("<circle cx=\"")
          .append(px)
          .append("\" cy=\"")
          .append(py)
          .append("\" r=\"2.4\"/>");
    } else {
      path.append(open ? " L" : " M").append(px).append(" ").append(py);
    }
    open = true;
  }
  if (series.style == SvgSeries::Style::Points) {
    return "<g fill=\"" + color + "\" fill-opacity=\"0.75\">" + dots + "</g>\n";
  }
  const char* dash = series.style == SvgSeries::Style::Dashed ? " stroke-dasharray=\"6 4\"" : "";
  return "<path fill=\"none\" stroke-width=\"1.8\" stroke=\"" + color + "\"" + dash + " d=\"" +
         path + "\"/>\n";
}

/// The named series under the plot, one below the other.
std::string legend(const std::vector<SvgSeries>& series, const Layout& layout) {
  std::string svg;
  const double x = layout.x.from;
  double y = layout.legendTop;
  auto names = layout.names.begin();
  for (const SvgSeries& s : series) {
    if (!inLegend(s)) continue;
    SvgSeries sample = s;
    sample.points = s.style == SvgSeries::Style::Points
                        ? std::vector<std::array<double, 2>>{{0.5, 0.5}}
                        : std::vector<std::array<double, 2>>{{0, 0.5}, {1, 0.5}};
    svg += curve(sample, {{0, 1}, x, x + 26}, {{0, 1}, y, y});
    svg += lines(x + kLegendName, y + 4, "start", *names);
    y += kLine * static_cast<double>(names->size());
    ++names;
  }
  return svg;
}

}  // namespace

std::vector<double> axisTicks(double least, double greatest, int most) {
  if (!std::isfinite(least) || !std::isfinite(greatest)) return {0, 1};
  if (least > greatest) std::swap(least, greatest);
  if (least == greatest) {
    const double reach = least == 0 ? 1 : std::abs(least) / 2;
    least -= reach, greatest += reach;
  }
  return marksAround(least, greatest, markStep(greatest - least, most - 1));
}

std::string svgChart(const SvgChart& chart) {
  const Layout layout = layOut(chart);
  std::string svg = "<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                    pixel(chart.width) + " " + pixel(layout.height) +
                    "\" role=\"img\" aria-label=\"" + escapedMarkup(chart.title) +
                    "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"currentColor\">\n";
  svg += lines(kLeastLeft, 17, "start", layout.title, " font-weight=\"600\"");
  svg += axes(layout);
  for (const SvgSeries& series : chart.series) {
    if (!series.points.empty()) svg += curve(series, layout.x, layout.y);
  }
  return svg + legend(chart.series, layout) + "</svg>\n";
}

std::string escapedMarkup(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

}  // namespace rotorbench
