#include "ui/forms/row_table_model.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"
#include "ui/forms/table_text.h"
#include "ui/forms/typed_value.h"

namespace rotorbench {

using schema::Kind;

namespace {

bool isNumeric(const schema::Field& field) {
  return field.kind == Kind::Number || field.kind == Kind::Integer || field.kind == Kind::Vector;
}

}  // namespace

RowTableModel::RowTableModel(const FormContext& context, QString listPath, QObject* parent)
    : QAbstractTableModel(parent), context_(context), list_(std::move(listPath)) {
  const auto at = context.model->find(list_);
  Q_ASSERT(at && at->field->kind == Kind::List);
  findColumns();
}

void RowTableModel::findColumns() {
  columns_.clear();
  const auto at = context_.model->find(list_);
  if (!at) return;
  const void* first =
      at->field->count(at->owner) > 0 ? at->field->constChild(at->owner, 0) : nullptr;
  addColumns({&at->field->childType(at->owner, 0), first}, {});
}

void RowTableModel::addColumns(schema::ConstRef row, const QString& prefix) {
  for (const auto& field : row.type->fields) {
    const QString key = joinPath(prefix, toQString(field.key));
    if (field.kind == Kind::Group) {
      addColumns({&field.childType(nullptr, 0),
                  row.object != nullptr ? field.constChild(row.object, 0) : nullptr},
                 key);
    } else if (field.kind == Kind::Vector) {
      // All rows are as long as the first.
      const std::size_t components =
          row.object == nullptr ? field.leastSize
                                : std::get<std::vector<double>>(field.read(row.object)).size();
      for (int i = 0; i < static_cast<int>(components); ++i) columns_.push_back({key, &field, i});
    } else if (field.isLeaf()) {
      columns_.push_back({key, &field, -1});
    }
  }
}

QString RowTableModel::leafPath(int row, const Column& column) const {
  return joinPath(elementPath(list_, static_cast<std::size_t>(row)), column.key);
}

QString RowTableModel::cellPath(int row, int column) const {
  const Column& c = this->column(column);
  const QString leaf = leafPath(row, c);
  return c.component < 0 ? leaf : elementPath(leaf, static_cast<std::size_t>(c.component));
}

QModelIndex RowTableModel::cellAt(const QString& path) const {
  if (!isAtOrBelow(path, list_)) return {};
  const qsizetype open = list_.size() + 1;
  const qsizetype close = path.indexOf(QLatin1Char(']'), open);
  bool ok = false;
  const int row = path.mid(open, close - open).toInt(&ok);
  if (!ok || row >= rowCount()) return {};
  for (int c = 0; c < columnCount(); ++c) {
    if (cellPath(row, c) == path || leafPath(row, column(c)) == path) return index(row, c);
  }
  return index(row, 0);
}

QString RowTableModel::title(int column) const {
  const Column& c = this->column(column);
  QString text = toQString(c.field->label);
  if (c.component >= 0) {
    text += QLatin1Char(' ') + componentName(*c.field, static_cast<std::size_t>(c.component));
  }
  const QString unit = prettyUnit(context_.units->shownUnit(*c.field));
  return unit.isEmpty() ? text : QStringLiteral("%1 [%2]").arg(text, unit);
}

void RowTableModel::reload() {
  beginResetModel();
  findColumns();
  endResetModel();
}

void RowTableModel::refresh() {
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

int RowTableModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid()) return 0;
  const auto at = context_.model->find(list_);
  return at ? static_cast<int>(at->field->count(at->owner)) : 0;
}

int RowTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

schema::Value RowTableModel::cellValue(int row, const Column& column) const {
  const schema::Value value = context_.model->get(leafPath(row, column));
  if (column.component < 0) return value;
  const auto& components = std::get<std::vector<double>>(value);
  const auto index = static_cast<std::size_t>(column.component);
  // A new row may be shorter until it has followed the others.
  return index < components.size() ? schema::Value{components[index]}
                                   : schema::Value{std::string()};
}

QString RowTableModel::cellText(int row, const Column& column) const {
  const schema::Value value = cellValue(row, column);
  if (const auto* number = std::get_if<double>(&value)) {
    return numberInUnit(*number, context_.units->shownUnit(*column.field), context_.locale);
  }
  if (column.field->kind == Kind::Text) return toQString(std::get<std::string>(value));
  if (std::holds_alternative<std::string>(value) && column.component >= 0) return {};
  return valueText(*column.field, value, QStringLiteral("1"), context_.locale);
}

QString RowTableModel::sentenceAt(const QString& cell) const {
  for (const Problem& problem : context_.model->problems()) {
    if (isAtOrBelow(toQString(problem.path), cell)) return problemSentence(problem);
  }
  return {};
}

QVariant RowTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Column& c = column(index.column());
  const QString cell = cellPath(index.row(), index.column());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      if (const auto invalid = context_.model->invalidText(cell)) return invalid->text;
      if (c.field->kind == Kind::Boolean) return {};
      return cellText(index.row(), c);
    case Qt::CheckStateRole:
      if (c.field->kind != Kind::Boolean) return {};
      return std::get<bool>(cellValue(index.row(), c)) ? Qt::Checked : Qt::Unchecked;
    case Qt::TextAlignmentRole:
      return static_cast<int>((isNumeric(*c.field) ? Qt::AlignRight : Qt::AlignLeft) |
                              Qt::AlignVCenter);
    case Qt::ForegroundRole:
      if (sentenceAt(cell).isEmpty()) return {};
      return form_style::severityColour(form_style::Severity::Error, QGuiApplication::palette());
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole: {
      const QString sentence = sentenceAt(cell);
      return sentence.isEmpty() ? toQString(c.field->help) : sentence;
    }
    default:
      return {};
  }
}

QVariant RowTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) {
    return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
  }
  const Column& c = column(section);
  if (role == Qt::DisplayRole) {
    const bool live = context_.flying && c.field->live;
    return live ? title(section) + QLatin1Char(' ') + form_style::kLiveMark : title(section);
  }
  if (role == Qt::ToolTipRole) {
    return toolTipHtml(*c.field, list_ + QStringLiteral("[…].") + c.key,
                       context_.units->shownUnit(*c.field), {}, context_.locale);
  }
  return {};
}

Qt::ItemFlags RowTableModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const bool box = column(index.column()).field->kind == Kind::Boolean;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable |
         (box ? Qt::ItemIsUserCheckable : Qt::ItemIsEditable);
}

bool RowTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const Column& c = column(index.column());
  const QString leaf = leafPath(index.row(), c);
  const QString cell = cellPath(index.row(), index.column());
  DocumentModel& model = *context_.model;
  if (role == Qt::CheckStateRole) {
    return !model.set(leaf, value.toInt() == Qt::Checked).has_value();
  }
  const QString text = value.toString();
  if (role != Qt::EditRole || text == data(index, Qt::EditRole).toString()) return false;
  TypedValue typed =
      readTyped(*c.field, text, context_.units->shownUnit(*c.field), context_.locale);
  if (typed.value && c.component >= 0) {
    auto components = std::get<std::vector<double>>(model.get(leaf));
    components[static_cast<std::size_t>(c.component)] = std::get<double>(*typed.value);
    typed.value = components;
  }
  if (typed.value) {
    model.clearInvalidText(cell);
    if (const auto problem = model.set(leaf, *typed.value)) {
      typed.sentence = problemSentence(*problem);
    }
  }
  if (!typed.sentence.isEmpty()) model.setInvalidText(cell, text, typed.sentence);
  return true;
}

bool RowTableModel::isHeader(const QStringList& cells, int column) const {
  for (qsizetype i = 0; i < cells.size(); ++i) {
    const int c = column + static_cast<int>(i);
    if (c >= columnCount()) return false;
    const QString label = toQString(this->column(c).field->label);
    if (!cells[i].startsWith(label, Qt::CaseInsensitive) &&
        !cells[i].startsWith(this->column(c).key, Qt::CaseInsensitive)) {
      return false;
    }
  }
  return true;
}

QString RowTableModel::pasteCell(schema::Ref scratch, const QString& text, int row,
                                 int column) const {
  const Column& c = this->column(column);
  TypedValue typed =
      readTyped(*c.field, text, context_.units->shownUnit(*c.field), context_.locale);
  if (!typed.value) return typed.sentence;
  const std::string path = leafPath(row, c).toStdString();
  if (c.component >= 0) {
    auto components = std::get<std::vector<double>>(schema::get(scratch, path));
    components[static_cast<std::size_t>(c.component)] = std::get<double>(*typed.value);
    typed.value = components;
  }
  try {
    schema::set(scratch, path, *typed.value);
  } catch (const InputError& error) {
    return error.problems().empty() ? asSentence(QString::fromUtf8(error.what()))
                                    : problemSentence(error.problems().front());
  }
  return {};
}

QString RowTableModel::pasteRows(schema::Ref scratch, const QList<QStringList>& rows, int row,
                                 int column, qsizetype headers) const {
  for (qsizetype r = headers; r < rows.size(); ++r) {
    if (column + rows[r].size() > columnCount()) {
      return tr("Row %1 has %2 cells; there is room for %3.")
          .arg(r + 1)
          .arg(rows[r].size())
          .arg(columnCount() - column);
    }
    for (qsizetype i = 0; i < rows[r].size(); ++i) {
      const int c = column + static_cast<int>(i);
      const QString why = pasteCell(scratch, rows[r][i], row + static_cast<int>(r - headers), c);
      if (why.isEmpty()) continue;
      return tr("Row %1, %2, “%3”: %4").arg(r + 1).arg(title(c), rows[r][i].left(30), why);
    }
  }
  return {};
}

QString RowTableModel::paste(const QString& text, int row, int column) {
  const bool commaIsDecimal = context_.locale.decimalPoint() == QLatin1String(",");
  const auto rows = splitTable(text, commaIsDecimal);
  if (rows.isEmpty()) return tr("There is no table on the clipboard.");
  const qsizetype headers = rows.size() > 1 && isHeader(rows.front(), column) ? 1 : 0;
  const auto needed =
      static_cast<std::size_t>(row) + static_cast<std::size_t>(rows.size() - headers);
  const Document scratch = context_.model->copy();
  const schema::Ref root{scratch.type, scratch.object.get()};
  const auto list = schema::locate(root, list_.toStdString());
  if (needed > list.field->maxItems) {
    return tr("There is room for %1 rows; the pasted table needs %2.")
        .arg(list.field->maxItems)
        .arg(needed);
  }
  if (needed > list.field->count(list.owner)) list.field->resize(list.owner, needed);
  const QString why = pasteRows(root, rows, row, column, headers);
  if (!why.isEmpty()) return why + QLatin1Char(' ') + tr("Nothing was pasted.");
  context_.model->replaceRows(
      list_, capture(*list.field, list.owner),
      tr("Paste %1 rows into %2").arg(rows.size() - headers).arg(toQString(list.field->label)));
  return {};
}

}  // namespace rotorbench
