// Texts of an exported figure and where they stand, read back from its file.
#pragma once

#include <QFontMetricsF>
#include <QProcess>
#include <QRectF>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTransform>
#include <QXmlStreamReader>
#include <algorithm>
#include <utility>

namespace rotorbench::fixture {

struct PlacedText {
  QString text;
  QRectF box;
  bool upright = true;
};

struct Page {
  QRectF box;
  QList<PlacedText> texts;

  /// All text without blanks: a name is found whole even where it goes on in a line below.
  [[nodiscard]] QString joined() const {
    QString all;
    for (const PlacedText& placed : texts) all += placed.text;
    // In pages some letters are joined to one sign.
    return all.remove(u' ').normalized(QString::NormalizationForm_KC);
  }
};

inline QTransform matrixOf(QStringView attribute) {
  static const QRegularExpression numbers("matrix\\(([^)]*)\\)");
  const auto match = numbers.match(attribute.toString());
  if (!match.hasMatch()) return {};
  QList<double> m;
  for (const QString& part : match.captured(1).split(',')) m << part.toDouble();
  return m.size() == 6 ? QTransform(m[0], m[1], m[2], m[3], m[4], m[5]) : QTransform();
}

/// As a viewer places them: by position and font, and the transforms of the groups around.
inline Page svgPage(const QByteArray& bytes) {
  Page page;
  QXmlStreamReader xml(bytes);
  QList<QTransform> groups{QTransform()};
  while (!xml.atEnd()) {
    xml.readNext();
    const auto a = xml.attributes();
    if (xml.isEndElement() && xml.name() == QLatin1String("g")) groups.removeLast();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("svg")) {
      const auto view = a.value("viewBox").toString().split(' ');
      page.box = {0, 0, view.value(2).toDouble(), view.value(3).toDouble()};
    } else if (xml.name() == QLatin1String("g")) {
      groups << matrixOf(a.value("transform")) * groups.last();
    } else if (xml.name() == QLatin1String("text")) {
      QFont font(a.value("font-family").toString());
      font.setHintingPreference(QFont::PreferNoHinting);
      font.setPixelSize(qRound(a.value("font-size").toDouble()));
      font.setBold(a.value("font-weight").toInt() > 500);
      const QPointF at(a.value("x").toDouble(), a.value("y").toDouble());
      const QString text = xml.readElementText();
      const QFontMetricsF metrics(font);
      const QRectF box(at.x(), at.y() - metrics.ascent(), metrics.horizontalAdvance(text),
                       metrics.height());
      const QTransform& place = groups.last();
      page.texts.append({text, place.mapRect(box), qFuzzyIsNull(place.m12())});
    }
  }
  return page;
}

/// By pdftotext, word by word; without texts if the program is missing.
inline Page pdfPage(const QString& path) {
  Page page;
  QProcess process;
  process.start(QStandardPaths::findExecutable(QStringLiteral("pdftotext")),
                {QStringLiteral("-bbox"), path, QStringLiteral("-")});
  if (!process.waitForFinished()) return page;
  QXmlStreamReader xml(process.readAllStandardOutput());
  while (!xml.atEnd()) {
    xml.readNext();
    const auto a = xml.attributes();
    const auto number = [&a](const char* name) { return a.value(QLatin1String(name)).toDouble(); };
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("page")) page.box = {0, 0, number("width"), number("height")};
    if (xml.name() != QLatin1String("word")) continue;
    const QRectF box(QPointF(number("xMin"), number("yMin")),
                     QPointF(number("xMax"), number("yMax")));
    page.texts.append({xml.readElementText(), box, true});
  }
  // Line by line, as it is read.
  std::ranges::stable_sort(page.texts, {}, [](const PlacedText& placed) {
    return std::pair(qRound(2 * placed.box.bottom()), placed.box.left());
  });
  return page;
}

}  // namespace rotorbench::fixture
