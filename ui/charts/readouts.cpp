#include "ui/charts/readouts.h"

#include <cmath>

#include "sim/core/unit_text.h"

namespace rotorbench {

QString readoutText(double value, const std::string& unit, const QLocale& locale) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  QString text = locale.toString(value, 'g', 5);
  text.replace(u'-', QChar(u'−'));
  return (text + u' ' + QString::fromStdString(prettyUnit(unit))).trimmed();
}

Readouts makeReadouts(const std::vector<Curve>& curves, const ChartLink& link,
                      const QLocale& locale) {
  const auto a = link.cursor(Cursor::A);
  const auto b = link.cursor(Cursor::B);
  Readouts readouts;
  const std::string abscissa =
      curves.empty() ? "s" : curves.front().recording->channels().front().unit;
  if (a) readouts.heads += QStringLiteral("A  ") + readoutText(*a, abscissa, locale);
  if (b) readouts.heads += QStringLiteral("B  ") + readoutText(*b, abscissa, locale);
  if (a && b) readouts.heads += QStringLiteral("B − A  ") + readoutText(*b - *a, abscissa, locale);
  for (const auto& curve : curves) {
    QStringList cells;
    const std::string& unit = curve.y().unit;
    const auto at = [&](double time) {
      return curve.recording->rows() == 0 ? std::nan("")
                                          : curve.recording->sampleAt(curve.yChannel, time);
    };
    if (a) cells += readoutText(at(*a), unit, locale);
    if (b) cells += readoutText(at(*b), unit, locale);
    if (a && b) cells += readoutText(at(*b) - at(*a), unit, locale);
    readouts.cells.push_back(std::move(cells));
  }
  return readouts;
}

}  // namespace rotorbench
