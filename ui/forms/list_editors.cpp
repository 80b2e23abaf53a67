#include "ui/forms/list_editors.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/forms/choice_editors.h"
#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"
#include "ui/forms/table_text.h"
#include "ui/forms/unit_button.h"

namespace rotorbench {

namespace {

/// Cells are typed as text; choices get a combo box.
class CellDelegate : public QStyledItemDelegate {
 public:
  CellDelegate(const RowTableModel& rows, QObject* parent)
      : QStyledItemDelegate(parent), rows_(rows) {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override {
    const schema::Field& field = *rows_.column(index.column()).field;
    QWidget* editor = nullptr;
    if (field.kind == schema::Kind::Choice) {
      editor = makeOptionBox(field, parent);
    } else {
      editor = QStyledItemDelegate::createEditor(parent, option, index);
    }
    editor->setObjectName(QStringLiteral("cellEditor"));
    editor->setAccessibleName(rows_.title(index.column()));
    return editor;
  }

  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    if (auto* box = qobject_cast<QComboBox*>(editor)) {
      box->setCurrentIndex(box->findText(index.data(Qt::EditRole).toString()));
      return;
    }
    QStyledItemDelegate::setEditorData(editor, index);
  }

  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override {
    if (auto* box = qobject_cast<QComboBox*>(editor)) {
      model->setData(index, box->currentData().toString(), Qt::EditRole);
      return;
    }
    QStyledItemDelegate::setModelData(editor, model, index);
  }

 private:
  const RowTableModel& rows_;
};

}  // namespace

ListEditor::ListEditor(const FormContext& context, const schema::Field& field, QString path,
                       QWidget* parent)
    : QWidget(parent),
      context_(context),
      field_(field),
      path_(std::move(path)),
      tools_(new ListTools(toQString(field.label), this)) {
  connect(tools_, &ListTools::addClicked, this, &ListEditor::insertAfterCurrent);
  connect(tools_, &ListTools::removeClicked, this, &ListEditor::removeCurrent);
  connect(tools_, &ListTools::duplicateClicked, this, [this] {
    const int row = currentRow();
    model().duplicateElement(path_, static_cast<std::size_t>(row));
    setCurrentRow(row + 1);
  });
  connect(tools_, &ListTools::moveClicked, this, [this](int by) {
    const int row = currentRow();
    const int to = row + by;
    model().moveElement(path_, static_cast<std::size_t>(row), static_cast<std::size_t>(to));
    setCurrentRow(row + by);
  });
}

int ListEditor::count() const {
  const auto at = model().find(path_);
  return at ? static_cast<int>(at->field->count(at->owner)) : 0;
}

void ListEditor::updateTools() {
  tools_->setState(count(), currentRow(), field_.minItems, field_.maxItems);
}

void ListEditor::insertAfterCurrent() {
  const int row = currentRow() < 0 ? count() : currentRow() + 1;
  model().insertElement(path_, static_cast<std::size_t>(row));
  setCurrentRow(row);
}

void ListEditor::removeCurrent() {
  const int row = currentRow();
  if (row < 0 || static_cast<std::size_t>(count()) <= field_.minItems) return;
  model().removeElement(path_, static_cast<std::size_t>(row));
  setCurrentRow(std::min(row, count() - 1));
}

void ListEditor::arrange(QAbstractItemView* view) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(form_style::kGrid);
  column->addWidget(view);
  column->addWidget(tools_);
  setFocusProxy(view);
}

TableEditor::TableEditor(const FormContext& context, const schema::Field& field,
                         const QString& path, QWidget* parent)
    : ListEditor(context, field, path, parent),
      view_(new QTableView(this)),
      rows_(new RowTableModel(this->context(), path, this)),
      message_(new QLabel(this)) {
  view_->setObjectName(path);
  view_->setAccessibleName(toQString(field.label));
  view_->setModel(rows_);
  view_->setItemDelegate(new CellDelegate(*rows_, view_));
  view_->setAlternatingRowColors(true);
  view_->setTabKeyNavigation(false);
  view_->verticalHeader()->setDefaultSectionSize(view_->fontMetrics().height() + 8);
  view_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view_->horizontalHeader()->setStretchLastSection(true);
  view_->horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  view_->installEventFilter(this);
  arrange(view_);
  message_->setObjectName(path + QStringLiteral(".message"));
  message_->setWordWrap(true);
  message_->hide();
  layout()->addWidget(message_);
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this] { updateTools(); });
  connect(view_->horizontalHeader(), &QHeaderView::sectionClicked, this, [this](int section) {
    const int x = view_->horizontalHeader()->sectionViewportPosition(section);
    showUnitMenu({x, 0});
  });
  connect(view_->horizontalHeader(), &QHeaderView::customContextMenuRequested, this,
          &TableEditor::showUnitMenu);
  connect(view_, &QWidget::customContextMenuRequested, this, &TableEditor::showContextMenu);
  connect(&model(), &DocumentModel::commitRequested, this, &TableEditor::commitCell);
  fitHeight();
  updateTools();
}

void TableEditor::commitCell() {
  auto* editor = view_->findChild<QWidget*>(QStringLiteral("cellEditor"));
  if (editor == nullptr || !view_->currentIndex().isValid()) return;
  view_->itemDelegate()->setModelData(editor, rows_, view_->currentIndex());
  view_->closePersistentEditor(view_->currentIndex());
}

void TableEditor::fitHeight() {
  constexpr int kFewest = 4;
  constexpr int kMost = 16;
  const int shown = std::clamp(count() + 1, kFewest, kMost);
  const int bars = view_->horizontalHeader()->sizeHint().height() +
                   view_->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  view_->setFixedHeight(bars + shown * view_->verticalHeader()->defaultSectionSize() + 4);
}

void TableEditor::reload() {
  const QModelIndex current = view_->currentIndex();
  rows_->reload();
  fitHeight();
  if (current.isValid() && rows_->rowCount() > 0) {
    view_->setCurrentIndex(
        rows_->index(std::min(current.row(), rows_->rowCount() - 1), current.column()));
  }
  updateTools();
}

void TableEditor::refresh() {
  rows_->refresh();
}

int TableEditor::currentRow() const {
  return view_->currentIndex().row();
}

void TableEditor::setCurrentRow(int row) {
  const int column = std::max(0, view_->currentIndex().column());
  view_->setCurrentIndex(rows_->index(row, column));
  updateTools();
}

void TableEditor::focusPlace(const QString& place) {
  view_->setFocus(Qt::OtherFocusReason);
  const QModelIndex cell = rows_->cellAt(place);
  if (cell.isValid()) view_->setCurrentIndex(cell);
}

bool TableEditor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Copy)) return copySelection(), true;
    if (key->matches(QKeySequence::Paste)) return paste(), true;
    if (key->matches(QKeySequence::Undo)) return model().undoStack()->undo(), true;
    if (key->matches(QKeySequence::Redo)) return model().undoStack()->redo(), true;
    if (key->key() == Qt::Key_Delete) return removeCurrent(), true;
    if (key->key() == Qt::Key_Insert) return insertAfterCurrent(), true;
  }
  return ListEditor::eventFilter(watched, event);
}

void TableEditor::copySelection() {
  QModelIndexList cells = view_->selectionModel()->selectedIndexes();
  std::sort(cells.begin(), cells.end());
  QList<QStringList> rows;
  int row = -1;
  for (const QModelIndex& cell : cells) {
    if (cell.row() != row) rows.append(QStringList());
    row = cell.row();
    const QVariant box = cell.data(Qt::CheckStateRole);
    rows.last() += box.isValid()
                       ? (box.toInt() == Qt::Checked ? QStringLiteral("on") : QStringLiteral("off"))
                       : cell.data(Qt::DisplayRole).toString();
  }
  if (!rows.isEmpty()) QApplication::clipboard()->setText(joinTable(rows));
}

void TableEditor::paste() {
  const QModelIndex current = view_->currentIndex();
  const QString why =
      rows_->paste(QApplication::clipboard()->text(), current.isValid() ? current.row() : 0,
                   current.isValid() ? current.column() : 0);
  message_->setText(why);
  message_->setVisible(!why.isEmpty());
  form_style::setTextColour(message_,
                            form_style::severityColour(form_style::Severity::Error, palette()));
}

void TableEditor::showContextMenu(const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Copy"), QKeySequence::Copy, this, &TableEditor::copySelection);
  menu->addAction(tr("Paste"), QKeySequence::Paste, this, &TableEditor::paste);
  menu->addSeparator();
  menu->addAction(tr("Add row"), QKeySequence(Qt::Key_Insert), this,
                  [this] { insertAfterCurrent(); });
  menu->addAction(tr("Remove row"), QKeySequence::Delete, this, [this] { removeCurrent(); });
  menu->popup(view_->viewport()->mapToGlobal(at));
}

void TableEditor::showUnitMenu(const QPoint& at) {
  QHeaderView* header = view_->horizontalHeader();
  const int section = header->logicalIndexAt(at);
  if (section < 0) return;
  QMenu* menu = makeUnitMenu(context(), *rows_->column(section).field, this);
  if (menu == nullptr) return;
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(
      header->mapToGlobal(QPoint(header->sectionViewportPosition(section), header->height())));
}

EntryListEditor::EntryListEditor(const FormContext& context, const schema::Field& field,
                                 const QString& path, QWidget* parent)
    : ListEditor(context, field, path, parent), list_(new QListWidget(this)) {
  list_->setObjectName(path);
  list_->setAccessibleName(toQString(field.label));
  arrange(list_);
  connect(list_, &QListWidget::currentRowChanged, this, [this] { updateTools(); });
  connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
    emit openRequested(elementPath(this->path(), static_cast<std::size_t>(list_->row(item))));
  });
  reload();
}

void EntryListEditor::reload() {
  const int row = list_->currentRow();
  list_->clear();
  const auto at = model().find(path());
  if (!at) return;
  for (int i = 0; i < count(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    auto* item = new QListWidgetItem(elementTitle(*at->field, at->owner, index), list_);
    const QString place = elementPath(path(), index);
    for (const Problem& problem : model().problems()) {
      if (!isAtOrBelow(toQString(problem.path), place)) continue;
      item->setIcon(form_style::severityIcon(form_style::Severity::Error, palette()));
      item->setToolTip(problemSentence(problem));
      break;
    }
  }
  if (list_->count() > 0) list_->setCurrentRow(std::clamp(row, 0, list_->count() - 1));
  updateTools();
}

void EntryListEditor::focusPlace(const QString&) {
  list_->setFocus(Qt::OtherFocusReason);
}

ListEditor* makeListEditor(const FormContext& context, const schema::Field& field,
                           const QString& path, QWidget* parent) {
  if (field.asTable) return new TableEditor(context, field, path, parent);
  return new EntryListEditor(context, field, path, parent);
}

}  // namespace rotorbench
