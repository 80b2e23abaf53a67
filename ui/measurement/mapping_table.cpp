#include "ui/measurement/mapping_table.h"

#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "ui/forms/field_text.h"
#include "ui/forms/plain_locale.h"
#include "ui/forms/quantity_edit.h"

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
  setMinimumHeight(14 * fontMetrics().lineSpacing());  // the choices and a few rows
  verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void MappingTable::show(const CsvPreview& preview, const std::vector<ColumnMapping>& columns) {
  columns_.clear();
  faults_.clear();
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
  QStringList headings{tr("Quantity"), tr("Unit"), tr("Scale"), tr("Offset"), tr("Range")};
  for (int r = 1; r <= rows; ++r) headings << QString::number(r);
  setVerticalHeaderLabels(headings);
  verticalHeaderItem(kScaleRow)->setToolTip(
      toQString(schema::typeOf<ColumnMapping>().field("scale")->help));
  verticalHeaderItem(kOffsetRow)
      ->setToolTip(toQString(schema::typeOf<ColumnMapping>().field("offset")->help));
  verticalHeaderItem(kRangeRow)->setToolTip(
      tr("Least and largest value of what is imported, in SI units."));
  resizeColumnsToContents();
  resizeRowsToContents();
}

void MappingTable::place(QWidget* widget, int row, int column, const char* name,
                         const QString& accessibleName) {
  widget->setObjectName(name + QString::number(column));
  widget->setAccessibleName(accessibleName.arg(horizontalHeaderItem(column)->text()));
  // The wheel scrolls the table; a choice needs a click or a key.
  widget->setFocusPolicy(Qt::StrongFocus);
  widget->installEventFilter(this);
  widget->setProperty("column", column);
  setCellWidget(row, column, widget);
}

// Who comes by the Tab key sees where.
bool MappingTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn && watched->property("column").isValid()) {
    const int column = watched->property("column").toInt();
    for (int row = kQuantityRow; row <= kOffsetRow; ++row) {
      if (cellWidget(row, column) == watched) scrollTo(model()->index(row, column));
    }
  }
  return QTableWidget::eventFilter(watched, event);
}

void MappingTable::addChoices(int column) {
  const ColumnMapping& mapping = columns_[static_cast<std::size_t>(column)];
  auto* quantity = new QComboBox;
  quantity->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  place(quantity, kQuantityRow, column, "quantity", tr("What the column %1 is"));
  addQuantities(*quantity);
  quantity->setCurrentIndex(std::max(quantity->findData(toQString(mapping.quantity)), 0));
  connect(quantity, &QComboBox::currentIndexChanged, this,
          [this, quantity, column] { chooseQuantity(column, quantity->currentData().toString()); });
  auto* unit = new QComboBox;
  unit->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  place(unit, kUnitRow, column, "unit", tr("Unit of the column %1"));
  fillUnits(column);
  connect(unit, &QComboBox::currentTextChanged, this, [this, unit, column] {
    columns_[static_cast<std::size_t>(column)].unit =
        unit->currentData().isValid() ? unit->currentData().toString().toStdString()
                                      : unit->currentText().toStdString();
    emit mappingChanged();
  });
  addNumber(kScaleRow, column, &ColumnMapping::scale);
  addNumber(kOffsetRow, column, &ColumnMapping::offset);
  auto* range = new QTableWidgetItem;
  range->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setItem(kRangeRow, column, range);
  enableNumbers(column);
}

void MappingTable::addNumber(int row, int column, double ColumnMapping::*member) {
  const bool scale = row == kScaleRow;
  auto* edit = new QuantityEdit(*schema::typeOf<ColumnMapping>().field(scale ? "scale" : "offset"),
                                plainLocale());
  place(edit, row, column, scale ? "scale" : "offset",
        scale ? tr("Scale of the column %1") : tr("Offset of the column %1"));
  edit->setValue(columns_[static_cast<std::size_t>(column)].*member);
  const std::pair at{column, row};
  connect(edit, &QuantityEdit::committed, this, [this, at, member](const schema::Value& value) {
    faults_.erase(at);
    columns_[static_cast<std::size_t>(at.first)].*member = std::get<double>(value);
    emit mappingChanged();
  });
  connect(
      edit, &QuantityEdit::rejected, this, [this, at, scale](const QString&, const QString& why) {
        const QString name = toQString(columns_[static_cast<std::size_t>(at.first)].column);
        faults_[at] =
            (scale ? tr("Column “%1”, scale: %2") : tr("Column “%1”, offset: %2")).arg(name, why);
        emit mappingChanged();
      });
  connect(edit, &CommitEdit::reverted, this, [this, at] {
    if (faults_.erase(at) > 0) emit mappingChanged();
  });
}

QStringList MappingTable::faults() const {
  QStringList sentences;
  for (const auto& [at, sentence] : faults_) {
    if (!columns_[static_cast<std::size_t>(at.first)].quantity.empty()) sentences << sentence;
  }
  return sentences;
}

void MappingTable::showRanges(const MeasuredTable& table, ChannelGroup group) {
  const QLocale locale;
  for (int c = 0; c < columnCount(); ++c) {
    const ColumnMapping& mapping = columns_[static_cast<std::size_t>(c)];
    const std::string name = mapping.quantity.empty() ? "" : channelOf(mapping, group).name;
    QString text;
    for (std::size_t i = 0; i < table.channels.size() && !name.empty(); ++i) {
      if (table.channels[i].name != name) continue;
      double low = INFINITY, high = -INFINITY;
      for (const double value : table.columns[i]) {
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
      }
      if (!(low <= high)) continue;
      const QString unit =
          table.channels[i].unit == "1" ? QString() : toQString(table.channels[i].unit);
      text = tr("%1 … %2 %3")
                 .arg(locale.toString(low, 'g', 4), locale.toString(high, 'g', 4), prettyUnit(unit))
                 .trimmed();
    }
    item(kRangeRow, c)->setText(text);
  }
  resizeColumnsToContents();
}

void MappingTable::enableNumbers(int column) {
  const bool taken = !columns_[static_cast<std::size_t>(column)].quantity.empty();
  for (const int row : {kScaleRow, kOffsetRow}) cellWidget(row, column)->setEnabled(taken);
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
  enableNumbers(column);
  emit mappingChanged();
}

}  // namespace rotorbench
