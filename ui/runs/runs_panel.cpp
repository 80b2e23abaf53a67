#include "ui/runs/runs_panel.h"

#include <QAction>
#include <QInputDialog>
#include <QLabel>
#include <QListView>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedLayout>
#include <QToolBar>
#include <algorithm>

#include "ui/runs/compare_dialog.h"
#include "ui/runs/run_delegate.h"

namespace rotorbench {

RunsPanel::RunsPanel(RunList& runs, QWidget* parent)
    : QWidget(parent), runs_(runs), view_(new QListView) {
  setObjectName("runsPanel");
  setAccessibleName(tr("Runs"));
  view_->setObjectName("runsView");
  view_->setAccessibleName(tr("Runs of this session"));
  view_->setModel(&runs_);
  view_->setItemDelegate(new RunDelegate(view_));
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  view_->setContextMenuPolicy(Qt::ActionsContextMenu);
  view_->setUniformItemSizes(true);
  view_->setFrameShape(QFrame::NoFrame);

  auto* empty = new QLabel(tr("No runs yet.\nPress F5 to run the experiment."));
  empty->setObjectName("runsEmpty");
  empty->setAlignment(Qt::AlignCenter);
  empty->setWordWrap(true);
  empty->setForegroundRole(QPalette::PlaceholderText);

  pages_ = new QStackedLayout;
  pages_->addWidget(empty);
  pages_->addWidget(view_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  buildActions();
  layout->addLayout(pages_, 1);

  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    updateActions();
    const auto ids = selection();
    if (ids.size() == 1) emit selected(ids.front());
  });
  connect(&runs_, &QAbstractItemModel::rowsInserted, this, &RunsPanel::updateActions);
  connect(&runs_, &QAbstractItemModel::rowsRemoved, this, &RunsPanel::updateActions);
  connect(&runs_, &QAbstractItemModel::dataChanged, this, &RunsPanel::updateActions);
  updateActions();
}

QAction* RunsPanel::addAction(const QString& icon, const QString& text, const QString& name,
                              void (RunsPanel::*slot)()) {
  auto* action = new QAction(QIcon::fromTheme(icon), text, this);
  action->setObjectName(name);
  connect(action, &QAction::triggered, this, slot);
  view_->addAction(action);
  return action;
}

void RunsPanel::buildActions() {
  rename_ = addAction("edit-rename", tr("Rename"), "renameRun", &RunsPanel::rename);
  note_ = addAction("edit-comment", tr("Note…"), "noteRun", &RunsPanel::editNote);
  duplicate_ = addAction("edit-copy", tr("Edit a copy of its experiment"), "duplicateRun",
                         &RunsPanel::duplicate);
  compare_ = addAction("view-split-left-right", tr("Compare two runs…"), "compareRuns",
                       &RunsPanel::compare);
  remove_ = addAction("edit-delete", tr("Delete…"), "deleteRun", &RunsPanel::removeSelected);
  rename_->setShortcut(Qt::Key_F2);
  remove_->setShortcut(QKeySequence::Delete);
  for (QAction* action : {rename_, remove_})
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  auto* bar = new QToolBar;
  bar->setObjectName("runsToolBar");
  bar->setIconSize({16, 16});
  bar->addActions({rename_, note_, duplicate_, compare_, remove_});
  layout()->addWidget(bar);
}

std::vector<int> RunsPanel::selection() const {
  QModelIndexList indexes = view_->selectionModel()->selectedIndexes();
  std::ranges::sort(indexes, {}, &QModelIndex::row);
  std::vector<int> ids;
  for (const QModelIndex& index : indexes) ids.push_back(index.data(RunList::IdRole).toInt());
  return ids;
}

void RunsPanel::select(int id) {
  view_->setCurrentIndex(runs_.index(runs_.rowOf(id)));
}

void RunsPanel::clearSelection() {
  view_->clearSelection();
  view_->setCurrentIndex({});
}

void RunsPanel::updateActions() {
  pages_->setCurrentIndex(runs_.records().empty() ? 0 : 1);
  const auto ids = selection();
  const bool one = ids.size() == 1;
  rename_->setEnabled(one);
  note_->setEnabled(one);
  const auto computed = std::ranges::none_of(ids, [this](int id) {
    const RunRecord* record = runs_.find(id);
    return record == nullptr || record->measured;
  });
  duplicate_->setEnabled(one && computed);
  compare_->setEnabled(ids.size() == 2 && computed);
  const bool active = std::ranges::any_of(ids, [this](int id) {
    const RunRecord* record = runs_.find(id);
    return record != nullptr && isActive(record->status.state);
  });
  remove_->setEnabled(!ids.empty() && !active);
}

void RunsPanel::rename() {
  view_->edit(view_->selectionModel()->selectedIndexes().value(0));
}

void RunsPanel::editNote() {
  const int id = selection().front();
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("noteDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Note"));
  dialog->setLabelText(tr("Note on this run:"));
  dialog->setOption(QInputDialog::UsePlainTextEditForTextInput);
  dialog->setTextValue(runs_.find(id)->note);
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, id](const QString& text) { runs_.setNote(id, text); });
  dialog->open();
}

void RunsPanel::duplicate() {
  emit duplicateRequested(selection().front());
}

void RunsPanel::compare() {
  const auto ids = selection();
  auto* dialog = new CompareDialog(*runs_.find(ids.at(0)), *runs_.find(ids.at(1)), this);
  dialog->open();
}

void RunsPanel::removeSelected() {
  const auto ids = selection();
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("Delete runs"),
      ids.size() == 1
          ? tr("Delete “%1” with its recording?").arg(runs_.find(ids.front())->name)
          : tr("Delete %n run(s) with their recordings?", nullptr, static_cast<int>(ids.size())),
      QMessageBox::Cancel, this);
  box->setObjectName("deleteRunsBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(tr("This cannot be undone. The experiment itself is kept."));
  const auto* confirm = box->addButton(tr("Delete"), QMessageBox::DestructiveRole);
  connect(box, &QMessageBox::finished, this, [this, ids, box, confirm] {
    if (box->clickedButton() != confirm) return;
    for (const int id : ids) runs_.remove(id);
  });
  box->open();
}

}  // namespace rotorbench
