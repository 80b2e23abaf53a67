// Tables as plain text, as spreadsheets put them on the clipboard: tabs, semicolons or commas
// between cells, quoted cells allowed.
#pragma once

#include <QChar>
#include <QList>
#include <QStringList>

namespace rotorbench {

/// Splits text into rows of cells. The separator is a tab if there is one, else a semicolon, else a
/// comma unless `commaIsDecimal`. Empty lines are left out.
QList<QStringList> splitTable(const QString& text, bool commaIsDecimal);

/// Rows of cells with tabs between them; cells with tabs, quotes or line breaks are quoted.
QString joinTable(const QList<QStringList>& rows);

}  // namespace rotorbench
