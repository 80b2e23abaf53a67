#include "ui/forms/list_tools.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QToolButton>

#include "ui/forms/form_style.h"

namespace rotorbench {

ListTools::ListTools(const QString& listName, QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(form_style::kGrid / 2);
  add_ = add("add", "list-add", "+", tr("Add to %1").arg(listName));
  duplicate_ = add("duplicate", "edit-copy", "⧉", tr("Duplicate"));
  remove_ = add("remove", "list-remove", "−", tr("Remove"));
  up_ = add("up", "go-up", "↑", tr("Move up"));
  down_ = add("down", "go-down", "↓", tr("Move down"));
  row->addStretch(1);
  connect(add_, &QToolButton::clicked, this, &ListTools::addClicked);
  connect(duplicate_, &QToolButton::clicked, this, &ListTools::duplicateClicked);
  connect(remove_, &QToolButton::clicked, this, &ListTools::removeClicked);
  connect(up_, &QToolButton::clicked, this, [this] { emit moveClicked(-1); });
  connect(down_, &QToolButton::clicked, this, [this] { emit moveClicked(1); });
}

QToolButton* ListTools::add(const QString& name, const QString& icon, const QString& sign,
                            const QString& text) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setAutoRaise(true);
  button->setIcon(QIcon::fromTheme(icon));
  if (button->icon().isNull()) button->setText(sign);
  button->setToolTip(text);
  button->setAccessibleName(text);
  button->setFocusPolicy(Qt::TabFocus);
  layout()->addWidget(button);
  return button;
}

void ListTools::setState(int count, int current, std::size_t minItems, std::size_t maxItems) {
  const auto items = static_cast<std::size_t>(count);
  const bool chosen = current >= 0 && current < count;
  add_->setEnabled(items < maxItems);
  duplicate_->setEnabled(chosen && items < maxItems);
  remove_->setEnabled(chosen && items > minItems);
  up_->setEnabled(chosen && current > 0);
  down_->setEnabled(chosen && current + 1 < count);
}

}  // namespace rotorbench
