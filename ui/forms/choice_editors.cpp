#include "ui/forms/choice_editors.h"

#include <QHBoxLayout>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"

namespace rotorbench {

QComboBox* makeOptionBox(const schema::Field& field, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(6);
  for (const auto& option : field.options) {
    box->addItem(toQString(option.label), toQString(option.key));
    box->setItemData(box->count() - 1, toQString(option.help), Qt::ToolTipRole);
  }
  box->setMaxVisibleItems(20);
  form_style::WheelGuard::install(box);
  return box;
}

BooleanEditor::BooleanEditor(const FormContext& context, const schema::Field& field,
                             const QString& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), box_(new QCheckBox(this)) {
  box_->setObjectName(path);
  fillWith(box_);
  connect(box_, &QCheckBox::clicked, this, [this](bool on) { model().set(this->path(), on); });
}

void BooleanEditor::refresh() {
  box_->setChecked(std::get<bool>(model().get(path())));
}

void BooleanEditor::labelClicked() {
  box_->setFocus(Qt::MouseFocusReason);
  box_->click();
}

ChoiceEditor::ChoiceEditor(const FormContext& context, const schema::Field& field,
                           const QString& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), box_(makeOptionBox(field, this)) {
  box_->setObjectName(path);
  fillWith(box_);
  connect(box_, &QComboBox::activated, this, [this](int index) {
    model().set(this->path(), box_->itemData(index).toString().toStdString());
  });
}

void ChoiceEditor::refresh() {
  const QString key = toQString(std::get<std::string>(model().get(path())));
  box_->setCurrentIndex(box_->findData(key));
  const int current = box_->currentIndex();
  box_->setAccessibleDescription(current < 0 ? QString()
                                             : box_->itemData(current, Qt::ToolTipRole).toString());
}

VariantEditor::VariantEditor(const FormContext& context, const schema::Field& field,
                             const QString& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), box_(makeOptionBox(field, this)) {
  box_->setObjectName(path);
  fillWith(box_);
  connect(box_, &QComboBox::activated, this,
          [this](int index) { model().choose(this->path(), static_cast<std::size_t>(index)); });
}

void VariantEditor::refresh() {
  const auto at = model().find(path());
  if (at) box_->setCurrentIndex(static_cast<int>(at->field->chosen(at->owner)));
}

LinkEditor::LinkEditor(const FormContext& context, const schema::Field& field, const QString& path,
                       QWidget* parent)
    : FieldEditor(context, field, path, parent), button_(new QPushButton(this)) {
  button_->setObjectName(path);
  fillWith(button_);
  connect(button_, &QPushButton::clicked, this, [this] { emit openRequested(this->path()); });
}

void LinkEditor::refresh() {
  const auto at = model().find(path());
  if (!at) return;
  QString summary = tr("Open");
  if (field().kind == schema::Kind::List) {
    const auto count = at->field->count(at->owner);
    summary = count == 1 ? tr("1 item") : tr("%1 items").arg(count);
  } else if (field().kind == schema::Kind::Variant) {
    summary = toQString(field().options[at->field->chosen(at->owner)].label);
  }
  button_->setText(summary + QStringLiteral("  ›"));
}

}  // namespace rotorbench
