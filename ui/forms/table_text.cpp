#include "ui/forms/table_text.h"

namespace rotorbench {

namespace {

QChar separatorOf(const QString& text, bool commaIsDecimal) {
  if (text.contains(QLatin1Char('\t'))) return QLatin1Char('\t');
  if (text.contains(QLatin1Char(';'))) return QLatin1Char(';');
  return commaIsDecimal ? QLatin1Char('\t') : QLatin1Char(',');
}

}  // namespace

QList<QStringList> splitTable(const QString& text, bool commaIsDecimal) {
  const QChar separator = separatorOf(text, commaIsDecimal);
  QList<QStringList> rows;
  QStringList row;
  QString cell;
  bool quoted = false;
  const auto endRow = [&] {
    row += cell.trimmed();
    cell.clear();
    if (row.size() > 1 || !row.front().isEmpty()) rows += row;
    row.clear();
  };
  for (qsizetype i = 0; i < text.size(); ++i) {
    const QChar c = text[i];
    if (quoted) {
      if (c != QLatin1Char('"')) {
        cell += c;
      } else if (i + 1 < text.size() && text[i + 1] == QLatin1Char('"')) {
        cell += text[++i];
      } else {
        quoted = false;
      }
    } else if (c == QLatin1Char('"') && cell.trimmed().isEmpty()) {
      quoted = true;
    } else if (c == separator) {
      row += cell.trimmed();
      cell.clear();
    } else if (c == QLatin1Char('\n')) {
      endRow();
    } else if (c != QLatin1Char('\r')) {
      cell += c;
    }
  }
  endRow();
  return rows;
}

QString joinTable(const QList<QStringList>& rows) {
  QString text;
  for (const auto& row : rows) {
    QStringList cells;
    for (QString cell : row) {
      if (cell.contains(QLatin1Char('\t')) || cell.contains(QLatin1Char('"')) ||
          cell.contains(QLatin1Char('\n'))) {
        cell = QLatin1Char('"') + cell.replace(QLatin1Char('"'), QLatin1String("\"\"")) +
               QLatin1Char('"');
      }
      cells += cell;
    }
    text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
  }
  return text;
}

}  // namespace rotorbench
