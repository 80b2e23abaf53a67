#include "ui/sizing/figure_table.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "sim/sizing/figure_output.h"
#include "ui/forms/form_style.h"

namespace rotorbench {

namespace {

constexpr int kKeyRole = Qt::UserRole;
constexpr int kLeastDetail = 26;  // characters of the last column, however small the dialog

QString text(const std::string& s) {
  return QString::fromStdString(s);
}

/// "1.5e-05" as "1.5·10⁻⁵".
QString withPower(QString number) {
  const qsizetype e = number.indexOf('e');
  if (e < 0) return number;
  QString power = QString::number(number.mid(e + 1).toInt());
  constexpr QStringView kRaised = u"\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
  for (QChar& c : power) c = c == '-' ? QChar(0x207b) : kRaised[c.digitValue()];
  return number.left(e) + "\u00b710" + power;
}

/// Numbers as the rest of the window writes them.
std::string localNumber(double value, int digits) {
  const QString number = text(shortNumber(value, digits));
  return withPower(number).replace('.', QLocale().decimalPoint()).toStdString();
}

QString read(const Sentence& sentence) {
  return text(sentence.text(localNumber));
}

QString valueText(const Figure& figure) {
  const QString number = text(figureNumber(figure, localNumber));
  if (std::isnan(figure.value) || figure.shownUnit == "1") return number;
  QString unit = text(figure.shownUnit);
  unit.replace("*", "\u00b7").replace("^2", "\u00b2").replace("Ohm", "\u03a9");
  if (unit == "deg") unit = QString(QChar(0xb0));
  if (unit == "us") unit = QString::fromUtf8("\u00b5s");
  return number + "\u00a0" + unit;
}

QTableWidgetItem* cell(Qt::Alignment alignment) {
  auto* item = new QTableWidgetItem;
  item->setTextAlignment(alignment | Qt::AlignVCenter);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  return item;
}

}  // namespace

FigureTable::FigureTable(Detail detail, QWidget* parent)
    : QWidget(parent), detail_(detail), table_(new QTableWidget), warnings_(new QLabel) {
  setObjectName("figureTable");
  table_->setObjectName("figures");
  table_->setAccessibleName(tr("Figures"));
  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels(
      {tr("Quantity"), tr("Symbol"), tr("Value"),
       detail == Detail::Formula ? tr("How it is worked out") : tr("What limits it")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kDetail, QHeaderView::Fixed);
  table_->viewport()->installEventFilter(this);
  table_->horizontalHeaderItem(kQuantity)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeaderItem(kDetail)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setMinimumSectionSize(table_->fontMetrics().height() + 6);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setWordWrap(true);
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setTabKeyNavigation(false);
  table_->setStyleSheet("QTableWidget::item { padding-left: 4px; padding-right: 4px; }");
  warnings_->setObjectName("sheetWarnings");
  warnings_->setAccessibleName(tr("Warnings"));
  warnings_->setWordWrap(true);
  warnings_->setTextFormat(Qt::PlainText);
  warnings_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  warnings_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(table_, 1);
  column->addWidget(warnings_);
}

void FigureTable::setSheet(const FigureSheet& sheet) {
  problem_.clear();
  const bool sameRows =
      std::ranges::equal(sheet.figures, sheet_.figures, {}, &Figure::key, &Figure::key);
  sheet_ = sheet;
  if (!sameRows) rebuild();
  updateRows();
  showWarnings();
  table_->setEnabled(true);
  emit filled(true);
}

void FigureTable::setProblem(const QString& sentence) {
  problem_ = sentence;
  sheet_ = {};
  rebuild();
  showWarnings();
  table_->setEnabled(false);
  emit filled(false);
}

void FigureTable::rebuild() {
  table_->clearSpans();
  table_->setRowCount(0);
  std::string group;
  for (const Figure& figure : sheet_.figures) {
    if (figure.group != group) {
      group = figure.group;
      const int row = table_->rowCount();
      table_->insertRow(row);
      auto* title = cell(Qt::AlignLeft);
      title->setText(text(group));
      QFont bold = table_->font();
      bold.setBold(true);
      title->setFont(bold);
      title->setFlags(Qt::ItemIsEnabled);
      table_->setItem(row, kQuantity, title);
      table_->setSpan(row, 0, 1, kColumns);
    }
    const int row = table_->rowCount();
    table_->insertRow(row);
    for (int c = 0; c < kColumns; ++c) {
      table_->setItem(row, c, cell(c == kValue ? Qt::AlignRight : Qt::AlignLeft));
    }
    table_->item(row, kQuantity)->setData(kKeyRole, text(figure.key));
  }
}

void FigureTable::updateRows() {
  std::size_t next = 0;
  for (int row = 0; row < table_->rowCount() && next < sheet_.figures.size(); ++row) {
    const Figure& figure = sheet_.figures[next];
    if (table_->item(row, kQuantity)->data(kKeyRole).toString() != text(figure.key)) continue;
    const QStringList texts{text(figure.label), text(figure.symbol), valueText(figure),
                            detailOf(figure)};
    for (int c = 0; c < kColumns; ++c) {
      table_->item(row, c)->setText(texts[c]);
      table_->item(row, c)->setToolTip(tipOf(figure));
    }
    table_->item(row, kDetail)->setForeground(form_style::dimmed(palette()));
    ++next;
  }
  fitLastColumn();
}

void FigureTable::fitLastColumn() {
  const int room = table_->viewport()->width();
  const int least = kLeastDetail * table_->fontMetrics().averageCharWidth();
  // The symbol is in the tool tip too; it goes first where there is no room.
  table_->setColumnHidden(kSymbol, room < 3 * least);
  int others = 0;
  for (int c = 0; c < kDetail; ++c) others += table_->columnWidth(c);
  const int width = std::max(least, room - others);
  if (width == table_->columnWidth(kDetail)) return;
  table_->setColumnWidth(kDetail, width);
  table_->resizeRowsToContents();
}

bool FigureTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) fitLastColumn();
  return QWidget::eventFilter(watched, event);
}

QString FigureTable::detailOf(const Figure& figure) const {
  // Why there is no value matters more than how it would be worked out.
  const bool note = detail_ == Detail::Note || std::isnan(figure.value);
  return read(note ? figure.note : figure.formula);
}

QString FigureTable::tipOf(const Figure& figure) const {
  QStringList lines{read(figure.symbol + ": " + figure.formula)};
  if (!figure.note.empty()) lines << read(figure.note);
  if (!figure.source.empty()) lines << text(figure.source);
  return lines.join('\n');
}

void FigureTable::showWarnings() {
  QStringList lines;
  if (!problem_.isEmpty()) lines << problem_;
  for (const auto& warning : sheet_.warnings) lines << "\u26a0 " + read(warning);
  warnings_->setText(lines.join('\n'));
  warnings_->setVisible(!lines.isEmpty());
  const auto severity =
      problem_.isEmpty() ? form_style::Severity::Warning : form_style::Severity::Error;
  form_style::setTextColour(warnings_, form_style::severityColour(severity, palette()));
}

void FigureTable::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  updateRows();
  showWarnings();
}

void FigureTable::copyText() const {
  QGuiApplication::clipboard()->setText(text(sheetText(sheet_, localNumber)));
}

void FigureTable::copyCsv() const {
  QGuiApplication::clipboard()->setText(text(sheetCsv(sheet_)));
}

}  // namespace rotorbench
