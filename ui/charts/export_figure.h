// Charts leaving the program: figures fit for a paper (light, with title, axis labels with units
// and a legend; text stays text in SVG and PDF), tables of the visible range, and the clipboard.
// Numbers with a decimal point whatever the locale.
#pragma once

#include <QImage>
#include <QString>
#include <optional>

namespace rotorbench {

class ChartGrid;
class ChartPane;

enum class FigureFormat { Png, Svg, Pdf, Csv };

/// By the ending of the file name.
std::optional<FigureFormat> formatOf(const QString& path);

/// Writes the chart as it is seen. Returns an empty text, or a sentence that says what went wrong.
QString exportPane(const ChartPane& pane, const QString& path, FigureFormat format);
QString exportPane(const ChartPane& pane, const QString& path);
/// Writes every pane into `folder` as "1-title.png", "2-title.png", ...
QString exportAllPanes(const ChartGrid& grid, const QString& folder, FigureFormat format);

/// Puts the figure and, if the visible range is not too long, its table on the clipboard. Returns a
/// sentence that says what was copied.
QString copyPane(const ChartPane& pane);

/// The figure with `scale` pixels per unit of length.
QImage figureImage(const ChartPane& pane, double scale);

/// All shown curves in the visible range, one column each: "time [s],rotor1.thrust [N]"; with
/// several runs each run has its own abscissa column and "run: " before the names.
QString paneCsv(const ChartPane& pane);

}  // namespace rotorbench
