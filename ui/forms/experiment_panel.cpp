#include "ui/forms/experiment_panel.h"

#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"
#include "ui/forms/parameter_form.h"
#include "ui/forms/plain_locale.h"
#include "ui/forms/section_tree.h"
#include "ui/forms/sections.h"

namespace rotorbench {

ExperimentPanel::ExperimentPanel(DocumentModel* model, QSettings* settings, QWidget* parent)
    : QWidget(parent),
      units_(settings),
      context_{model, &units_, plainLocale(), {}, {}, {}},
      tree_(new SectionTree(context_, this)),
      form_(new ParameterForm(context_, this)),
      flying_(new QLabel(this)) {
  setObjectName(QStringLiteral("experimentPanel"));
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->setObjectName(QStringLiteral("experimentSplitter"));
  splitter->addWidget(tree_);
  splitter->addWidget(form_);
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 3);
  splitter->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(form_style::kGrid, form_style::kGrid, form_style::kGrid, 0);
  flying_->setObjectName(QStringLiteral("flyingNote"));
  flying_->setWordWrap(true);
  flying_->setTextFormat(Qt::PlainText);
  form_style::setFontScale(flying_, 0.92);
  flying_->hide();
  column->addWidget(flying_);
  column->addWidget(splitter, 1);
  model->setValueText([this](const schema::Field& field, const schema::Value& value) {
    return valueText(field, value, units_.shownUnit(field), context_.locale);
  });
  connect(tree_, &SectionTree::sectionSelected, form_, &ParameterForm::showSection);
  connect(tree_, &SectionTree::placeChosen, this, &ExperimentPanel::jumpTo);
  connect(form_, &ParameterForm::sectionRequested, this, &ExperimentPanel::showSection);
}

ExperimentPanel::~ExperimentPanel() {
  // The children read the units and the context to the end.
  delete form_;
  delete tree_;
  context_.model->setValueText({});
}

void ExperimentPanel::setChannelNames(std::function<QStringList()> names) {
  context_.channelNames = std::move(names);
}

void ExperimentPanel::setComponents(std::function<bool(const QString& path)> has,
                                    std::function<void(const QString& path)> pick) {
  context_.hasComponents = std::move(has);
  context_.pickComponent = std::move(pick);
  form_->rebuild();
}

void ExperimentPanel::setFlying(const QString& run) {
  flying_->setText(
      tr("%1 is under way. What is marked %2 acts in it at once, all else in the next run.")
          .arg(run.section(QLatin1Char(':'), 0, 0), form_style::kLiveMark));
  flying_->setVisible(!run.isEmpty());
  if (context_.flying == !run.isEmpty()) return;
  context_.flying = !run.isEmpty();
  form_->showLive();
}

void ExperimentPanel::showSection(const QString& path) {
  form_->showSection(path);
  tree_->showSection(form_->section());
}

void ExperimentPanel::jumpTo(const QString& path) {
  form_->focusPlace(path);
  tree_->showSection(form_->section());
}

void ExperimentPanel::findParameter() {
  tree_->focusSearch();
}

}  // namespace rotorbench
