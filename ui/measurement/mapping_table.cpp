#include "ui/measurement/mapping_table.h"

#include <QComboBox>
#include <QHeaderView>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/forms/field_text.h"

namespace rotorbench {

namespace {

constexpr int kRowsShown = 30;

QString key(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

void addQuantities(QComboBox& box) {
  box.addItem(MappingTable::tr("(left out)"), QString());
  for (const Quantity& quantity : measurableQuantities()) {
    box.addItem(key(quantity.label), key(quantity.key));
  }
  box.addItem(MappingTable::tr("Other, under its own name"), key(kOtherQuantity));
}

}  // namespace

MappingTable::MappingTable(QWidget* parent) : QTableWidget(parent) {
  setObjectName("importTable");
  setAccessibleName(tr("First rows and what each column is"));
  setEditTriggers(NoEditTriggers);
  setSelectionMode(NoSelection);
  setTabKeyNavigation(false);
  setWordWrap(false);
  setMinimumHeight(9 * fontMetrics().lineSpacing());  // both choices and a few rows
  verticalHeader()->hide();
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void MappingTable::show(const CsvPreview& preview, const std::vector<ColumnMapping>& columns) {
  columns_.clear();
  clear();
  const int rows = std::min(static_cast<int>(preview.rows), kRowsShown);
  setRowCount(kFirstDataRow + rows);
  setColumnCount(static_cast<int>(preview.columns.size()));
  for (int c = 0; c < columnCount(); ++c) {
    const PreviewColumn& column = preview.columns[static_cast<std::size_t>(c)];
    const auto known = std::ranges::find(columns, column.name, &ColumnMapping::column);
    columns_.push_back(known != columns.end() ? *known : ColumnMapping{});
    columns_.back().column = column.name;
    setHorizontalHeaderItem(c, new QTableWidgetItem(toQString(column.name)));
    for (int r = 0; r < rows; ++r) {
      auto* item = new QTableWidgetItem(toQString(column.cells[static_cast<std::size_t>(r)]));
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      setItem(kFirstDataRow + r, c, item);
    }
    addChoices(c);
  }
  resizeColumnsToContents();
  resizeRowsToContents();
}

QComboBox* MappingTable::addBox(int row, int column, const QString& objectName,
                                const QString& accessibleName) {
  auto* box = new QComboBox;
  box->setObjectName(objectName + QString::number(column));
  box->setAccessibleName(accessibleName.arg(horizontalHeaderItem(column)->text()));
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  // The wheel scrolls the table; a choice needs a click or a key.
  box->setFocusPolicy(Qt::StrongFocus);
  setCellWidget(row, column, box);
  return box;
}

void MappingTable::addChoices(int column) {
  const ColumnMapping& mapping = columns_[static_cast<std::size_t>(column)];
  QComboBox* quantity = addBox(kQuantityRow, column, "quantity", tr("What the column %1 is"));
  addQuantities(*quantity);
  quantity->setCurrentIndex(std::max(quantity->findData(toQString(mapping.quantity)), 0));
  connect(quantity, &QComboBox::currentIndexChanged, this,
          [this, quantity, column] { chooseQuantity(column, quantity->currentData().toString()); });
  QComboBox* unit = addBox(kUnitRow, column, "unit", tr("Unit of the column %1"));
  fillUnits(column);
  connect(unit, &QComboBox::currentTextChanged, this, [this, unit, column] {
    columns_[static_cast<std::size_t>(column)].unit =
        unit->currentData().isValid() ? unit->currentData().toString().toStdString()
                                      : unit->currentText().toStdString();
    emit mappingChanged();
  });
}

void MappingTable::fillUnits(int column) {
  auto* unit = qobject_cast<QComboBox*>(cellWidget(kUnitRow, column));
  const ColumnMapping& mapping = columns_[static_cast<std::size_t>(column)];
  const QSignalBlocker quiet(unit);
  unit->clear();
  const Quantity* quantity = findQuantity(mapping.quantity);
  unit->setEnabled(!mapping.quantity.empty());
  unit->setEditable(mapping.quantity == kOtherQuantity);
  if (quantity != nullptr) {
    for (const std::string& symbol : unitsOf(*quantity)) {
      const QString pretty = symbol == "1" ? QStringLiteral("1") : prettyUnit(toQString(symbol));
      unit->addItem(pretty, toQString(symbol));
    }
    unit->setCurrentIndex(unit->findData(toQString(mapping.unit)));
  } else if (unit->isEditable()) {
    unit->setEditText(toQString(mapping.unit));
  } else {
    unit->addItem(toQString(mapping.unit));
  }
}

void MappingTable::chooseQuantity(int column, const QString& chosen) {
  ColumnMapping& mapping = columns_[static_cast<std::size_t>(column)];
  mapping.quantity = chosen.toStdString();
  const Quantity* quantity = findQuantity(mapping.quantity);
  if (quantity != nullptr && !conversionOf(*quantity, mapping.unit)) mapping.unit = quantity->shown;
  if (mapping.quantity == kOtherQuantity) mapping.channel = mapping.column;
  fillUnits(column);
  emit mappingChanged();
}

}  // namespace rotorbench
