#include "ui/library/component_details.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"
#include "ui/library/component_text.h"

namespace rotorbench {

ComponentDetails::ComponentDetails(const UnitPreferences& units, QWidget* parent)
    : QWidget(parent), units_(units), values_(new QTreeWidget(this)) {
  auto* texts = new QWidget;
  auto* column = new QVBoxLayout(texts);
  column->setContentsMargins(form_style::kMargin, 0, form_style::kMargin, 0);
  name_ = addText("componentName", tr("Name"));
  form_style::setFontScale(name_, 1.15, true);
  summary_ = addText("componentSummary", tr("Summary"));
  warning_ = addText("componentWarning", tr("Warning"));
  source_ = addText("componentSource", tr("Source"));
  form_style::setFontScale(source_, 0.92);
  form_style::setFontScale(warning_, 0.92);
  for (QLabel* label : {name_, summary_, warning_, source_}) column->addWidget(label);
  column->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("componentTexts"));
  scroll->setWidget(texts);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  values_->setObjectName(QStringLiteral("componentValues"));
  values_->setAccessibleName(tr("Values of the component"));
  values_->setHeaderLabels({tr("Parameter"), tr("Value")});
  values_->header()->setStretchLastSection(false);
  values_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  values_->setIndentation(2 * form_style::kGrid);
  values_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  values_->setUniformRowHeights(true);
  values_->setAlternatingRowColors(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(form_style::kMargin);
  layout->addWidget(scroll, 1);
  layout->addWidget(values_, 1);
  colour();
}

QLabel* ComponentDetails::addText(const char* name, const QString& accessibleName) {
  auto* label = new QLabel;
  label->setObjectName(QString::fromLatin1(name));
  label->setAccessibleName(accessibleName);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

void ComponentDetails::colour() {
  form_style::setTextColour(warning_,
                            form_style::severityColour(form_style::Severity::Warning, palette()));
  form_style::setTextColour(source_, form_style::dimmed(palette()));
}

void ComponentDetails::show(const Component* component) {
  const ComponentInfo info = component == nullptr ? ComponentInfo() : component->info;
  name_->setText(component == nullptr ? tr("Choose a component.") : toQString(info.name));
  summary_->setText(toQString(info.summary));
  warning_->setText(info.warning.empty() ? QString() : tr("Note: %1").arg(toQString(info.warning)));
  source_->setText(info.source.empty() ? QString() : tr("Source: %1").arg(toQString(info.source)));
  for (QLabel* label : {summary_, warning_, source_}) label->setVisible(!label->text().isEmpty());
  values_->clear();
  if (component != nullptr) fillParameterTree(*values_, component->ref(), units_, locale_);
}

void ComponentDetails::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colour();
}

}  // namespace rotorbench
