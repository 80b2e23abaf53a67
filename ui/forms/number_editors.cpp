#include "ui/forms/number_editors.h"

#include <QGridLayout>
#include <QLabel>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"

namespace rotorbench {

namespace {

DocumentModel::Edit editKind(bool repeated) {
  return repeated ? DocumentModel::Edit::Repeated : DocumentModel::Edit::Single;
}

double asNumber(const schema::Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::get<double>(value);
}

}  // namespace

NumberEditor::NumberEditor(const FormContext& context, const schema::Field& field,
                           const QString& path, QWidget* parent)
    : FieldEditor(context, field, path, parent),
      edit_(new QuantityEdit(field, context.locale, this)) {
  edit_->setObjectName(path);
  fillWith(edit_);
  adopt(edit_);
  if (field.kind == schema::Kind::Number) unit_ = new UnitButton(context, field, parent);
  connect(edit_, &QuantityEdit::judged, this, &FieldEditor::judged);
  connect(edit_, &QuantityEdit::committed, this, [this](const schema::Value& value, bool repeated) {
    if (const auto problem = model().set(this->path(), value, editKind(repeated))) {
      model().setInvalidText(this->path(), edit_->text(), problemSentence(*problem));
      refresh();
    }
  });
  connect(edit_, &QuantityEdit::rejected, this, [this](const QString& text, const QString& why) {
    model().setInvalidText(this->path(), text, why);
  });
  connect(edit_, &CommitEdit::reverted, this, [this] {
    model().clearInvalidText(this->path());
    refresh();
  });
  NumberEditor::unitsChanged();
}

void NumberEditor::refresh() {
  if (const auto invalid = model().invalidText(path())) {
    edit_->setInvalidText(invalid->text);
  } else {
    edit_->setValue(asNumber(model().get(path())));
  }
}

void NumberEditor::unitsChanged() {
  edit_->setShownUnit(shownUnit());
  if (unit_ != nullptr) unit_->refresh();
}

VectorEditor::VectorEditor(const FormContext& context, const schema::Field& field,
                           const QString& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), unit_(new UnitButton(context, field, parent)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(form_style::kGrid);
  // A vector of another length is another structure: the form makes its editors anew.
  const auto components = std::get<std::vector<double>>(model().get(path));
  for (std::size_t i = 0; i < components.size(); ++i) addComponent(i);
  setFocusProxy(edits_.front());
  VectorEditor::unitsChanged();
}

QString VectorEditor::componentPath(std::size_t index) const {
  return elementPath(path(), index);
}

void VectorEditor::addComponent(std::size_t index) {
  constexpr std::size_t kPerLine = 3;
  const QString name = componentName(field(), index);
  auto* label = new QLabel(name, this);
  form_style::setDimmed(label);
  auto* edit = new QuantityEdit(field(), context().locale, this);
  edit->setObjectName(componentPath(index));
  edit->setAccessibleName(tr("%1, %2").arg(toQString(field().label), name));
  adopt(edit);
  edits_.push_back(edit);
  auto* grid = static_cast<QGridLayout*>(layout());
  const int row = static_cast<int>(index / kPerLine);
  const int column = static_cast<int>(index % kPerLine) * 2;
  grid->addWidget(label, row, column);
  grid->addWidget(edit, row, column + 1);
  grid->setColumnStretch(column + 1, 1);
  connect(edit, &QuantityEdit::judged, this, &FieldEditor::judged);
  connect(edit, &QuantityEdit::committed, this,
          [this, index](const schema::Value& value, bool repeated) {
            store(index, std::get<double>(value), repeated);
          });
  connect(edit, &QuantityEdit::rejected, this,
          [this, index](const QString& text, const QString& why) {
            model().setInvalidText(componentPath(index), text, why);
          });
  connect(edit, &CommitEdit::reverted, this, [this, index] {
    model().clearInvalidText(componentPath(index));
    refresh();
  });
}

void VectorEditor::store(std::size_t index, double value, bool repeated) {
  auto components = std::get<std::vector<double>>(model().get(path()));
  components[index] = value;
  // Storing the vector must not bless what stands in its other components.
  std::vector<std::pair<QString, InvalidText>> others;
  for (std::size_t i = 0; i < edits_.size(); ++i) {
    const auto invalid = model().invalidText(componentPath(i));
    if (i != index && invalid) others.emplace_back(componentPath(i), *invalid);
  }
  model().clearInvalidText(componentPath(index));
  const auto problem = model().set(path(), components, editKind(repeated));
  for (const auto& [place, invalid] : others) {
    model().setInvalidText(place, invalid.text, invalid.sentence);
  }
  if (problem) {
    model().setInvalidText(componentPath(index), edits_[index]->text(), problemSentence(*problem));
  }
  refresh();
}

void VectorEditor::refresh() {
  const auto components = std::get<std::vector<double>>(model().get(path()));
  for (std::size_t i = 0; i < edits_.size(); ++i) {
    if (const auto invalid = model().invalidText(componentPath(i))) {
      edits_[i]->setInvalidText(invalid->text);
    } else {
      edits_[i]->setValue(components[i]);
    }
  }
}

void VectorEditor::commit() {
  for (auto* edit : edits_) edit->commit();
}

void VectorEditor::unitsChanged() {
  for (auto* edit : edits_) edit->setShownUnit(shownUnit());
  unit_->refresh();
}

QWidget* VectorEditor::inputFor(const QString& place) {
  for (auto* edit : edits_) {
    if (edit->objectName() == place) return edit;
  }
  return edits_.front();
}

}  // namespace rotorbench
