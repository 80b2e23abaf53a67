// A cell of a result table.
#pragma once

#include <QString>
#include <QTableWidgetItem>

namespace rotorbench {

/// Numbers stand to the right. The table takes the cell.
inline QTableWidgetItem* tableCell(const QString& text, bool number) {
  auto* item = new QTableWidgetItem(text);
  if (number) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}

}  // namespace rotorbench
