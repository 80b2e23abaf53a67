#include "ui/forms/problems_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"

namespace rotorbench {

using form_style::Severity;

ProblemsPanel::ProblemsPanel(DocumentModel* model, QWidget* parent)
    : QWidget(parent), model_(model), list_(new QTreeWidget(this)), empty_(new QLabel(this)) {
  setObjectName(QStringLiteral("problemsPanel"));
  list_->setObjectName(QStringLiteral("problems"));
  list_->setAccessibleName(tr("Problems"));
  list_->setHeaderLabels({tr("Where"), tr("What")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setAllColumnsShowFocus(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->header()->setSectionResizeMode(0, QHeaderView::Interactive);
  list_->header()->resizeSection(0, 260);
  empty_->setObjectName(QStringLiteral("noProblems"));
  empty_->setText(tr("No problems. The experiment is ready to run."));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  form_style::setDimmed(empty_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(list_);
  column->addWidget(empty_, 1);
  connect(list_, &QTreeWidget::itemClicked, this, &ProblemsPanel::jump);
  connect(list_, &QTreeWidget::itemActivated, this, &ProblemsPanel::jump);
  connect(model_, &DocumentModel::problemsChanged, this, &ProblemsPanel::rebuild);
  connect(model_, &DocumentModel::documentReplaced, this, &ProblemsPanel::rebuild);
  rebuild();
}

void ProblemsPanel::rebuild() {
  list_->clear();
  for (const Problem& problem : model_->problems()) {
    const QString path = toQString(problem.path);
    auto* item = new QTreeWidgetItem(list_);
    item->setText(0, placeText(model_->root(), path));
    item->setText(1, problemSentence(problem));
    item->setToolTip(0, path);
    item->setToolTip(1, item->text(1));
    item->setData(0, Qt::UserRole, path);
    const Severity severity = problem.warning ? Severity::Warning : Severity::Error;
    item->setIcon(0, form_style::severityIcon(severity, palette()));
    item->setData(0, Qt::AccessibleDescriptionRole, problem.warning ? tr("Warning") : tr("Error"));
  }
  const bool any = list_->topLevelItemCount() > 0;
  list_->setVisible(any);
  empty_->setVisible(!any);
}

void ProblemsPanel::jump(const QTreeWidgetItem* item) {
  emit jumpTo(item->data(0, Qt::UserRole).toString());
}

void ProblemsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && empty_ != nullptr) {
    form_style::setDimmed(empty_);
    rebuild();
  }
}

}  // namespace rotorbench
