#include "ui/charts/export_figure.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QMimeData>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <cmath>

#include "ui/charts/chart_grid.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/figure_painter.h"
#include "ui/charts/visible_table.h"

namespace rotorbench {
namespace {

constexpr double kPngScale = 3;
/// 170 mm: the text width of an A4 page.
constexpr double kPdfWidthMm = 170;
constexpr double kSvgDotsPerInch = 96;
/// Table cells the clipboard takes; more would stop the window for too long.
constexpr std::size_t kMostClipboardCells = 300'000;

QString cannotWrite(const QString& path, const QString& reason) {
  return QObject::tr("The chart could not be saved as %1: %2")
      .arg(QDir::toNativeSeparators(path), reason);
}

QString writeBytes(const QString& path, const QByteArray& bytes) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
    return cannotWrite(path, file.errorString());
  }
  return {};
}

QString titleOf(const ChartPane& pane) {
  return QString::fromStdString(pane.spec().title);
}

QByteArray svgBytes(const ChartPane& pane) {
  const ChartFigure figure(pane);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(static_cast<int>(kSvgDotsPerInch));
  generator.setSize(figure.size().toSize());
  generator.setViewBox(QRectF({0, 0}, figure.size()));
  generator.setTitle(titleOf(pane));
  QPainter painter(&generator);
  figure.paint(painter);
  painter.end();
  return bytes;
}

QByteArray pdfBytes(const ChartPane& pane) {
  const ChartFigure figure(pane);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setTitle(titleOf(pane));
  writer.setCreator(QStringLiteral("Rotorbench"));
  const QSizeF page(kPdfWidthMm, kPdfWidthMm * figure.size().height() / figure.size().width());
  writer.setPageSize(QPageSize(page, QPageSize::Millimeter, {}, QPageSize::ExactMatch));
  writer.setPageMargins({});
  QPainter painter(&writer);
  const double scale = writer.width() / figure.size().width();
  painter.scale(scale, scale);
  figure.paint(painter);
  painter.end();
  return bytes;
}

QByteArray pngBytes(const ChartPane& pane) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  figureImage(pane, kPngScale).save(&buffer, "PNG");
  return bytes;
}

QString fileNamePart(const QString& title) {
  QString name;
  for (const QChar c : title) name += c.isLetterOrNumber() ? c.toLower() : QChar(u'-');
  return name.isEmpty() ? QStringLiteral("chart") : name;
}

}  // namespace

std::optional<FigureFormat> formatOf(const QString& path) {
  const QString ending = QFileInfo(path).suffix().toLower();
  if (ending == QLatin1String("png")) return FigureFormat::Png;
  if (ending == QLatin1String("svg")) return FigureFormat::Svg;
  if (ending == QLatin1String("pdf")) return FigureFormat::Pdf;
  if (ending == QLatin1String("csv")) return FigureFormat::Csv;
  return std::nullopt;
}

QImage figureImage(const ChartPane& pane, double scale) {
  const ChartFigure figure(pane);
  QImage image((figure.size() * scale).toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  image.setDotsPerMeterX(static_cast<int>(kSvgDotsPerInch * scale / 0.0254));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  QPainter painter(&image);
  painter.scale(scale, scale);
  figure.paint(painter);
  return image;
}

QString exportPane(const ChartPane& pane, const QString& path, FigureFormat format) {
  switch (format) {
    case FigureFormat::Png:
      return writeBytes(path, pngBytes(pane));
    case FigureFormat::Svg:
      return writeBytes(path, svgBytes(pane));
    case FigureFormat::Pdf:
      return writeBytes(path, pdfBytes(pane));
    case FigureFormat::Csv:
      return writeBytes(path, paneCsv(pane).toUtf8());
  }
  return {};
}

QString exportPane(const ChartPane& pane, const QString& path) {
  const auto format = formatOf(path);
  if (!format)
    return cannotWrite(path, QObject::tr("the name must end in .png, .svg, .pdf or .csv."));
  return exportPane(pane, path, *format);
}

QString exportAllPanes(const ChartGrid& grid, const QString& folder, FigureFormat format) {
  static constexpr const char* kEndings[] = {"png", "svg", "pdf", "csv"};
  if (!QDir().mkpath(folder)) return cannotWrite(folder, QObject::tr("the folder cannot be made."));
  int number = 0;
  for (const auto* pane : grid.panes()) {
    const QString name = QStringLiteral("%1-%2.%3")
                             .arg(++number)
                             .arg(fileNamePart(titleOf(*pane)),
                                  QLatin1String(kEndings[static_cast<std::size_t>(format)]));
    const QString error = exportPane(*pane, QDir(folder).filePath(name), format);
    if (!error.isEmpty()) return error;
  }
  return {};
}

QString copyPane(const ChartPane& pane) {
  auto* data = new QMimeData;
  data->setImageData(figureImage(pane, 2));
  const bool withTable = visibleCells(pane) <= kMostClipboardCells;
  if (withTable) data->setText(paneCsv(pane));
  QApplication::clipboard()->setMimeData(data);
  return withTable ? QObject::tr("The chart and its table were copied.")
                   : QObject::tr(
                         "The chart was copied; its table is too long for the clipboard, export it "
                         "as CSV.");
}

}  // namespace rotorbench
