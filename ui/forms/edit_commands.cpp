#include "ui/forms/edit_commands.h"

#include <utility>

namespace rotorbench {

namespace {
constexpr int kSetValueId = 1;
}

EditCommand::EditCommand(DocumentModel& model, QString path, const QString& text)
    : QUndoCommand(text), model_(model), path_(std::move(path)) {}

void EditCommand::redo() {
  apply();
  followed_.clear();
  for (const auto& loose : schema::looseFollowers(rootRef())) {
    const schema::Location at = schema::locate(rootRef(), loose.path);
    followed_.push_back({QString::fromStdString(loose.path), capture(*at.field, at.owner)});
    loose.follower->follow(loose.owner.object);
    model_.announceStructure(followed_.back().path);
  }
}

void EditCommand::undo() {
  for (auto it = followed_.rbegin(); it != followed_.rend(); ++it) {
    const schema::Location at = schema::locate(rootRef(), it->path.toStdString());
    restore(*at.field, at.owner, it->before);
    model_.announceStructure(it->path);
  }
  revert();
}

schema::Location EditCommand::location() const {
  return schema::locate(rootRef(), path_.toStdString());
}

schema::Ref EditCommand::elementOf(const schema::Location& list, std::size_t index) const {
  return {&list.field->childType(list.owner, index), list.field->child(list.owner, index)};
}

SetValue::SetValue(DocumentModel& model, QString path, schema::Value before, schema::Value after,
                   const QString& text, DocumentModel::Edit edit)
    : EditCommand(model, std::move(path), text),
      before_(std::move(before)),
      after_(std::move(after)),
      edit_(edit) {}

void SetValue::revert() {
  write(before_);
}
void SetValue::apply() {
  write(after_);
}

void SetValue::write(const schema::Value& value) {
  const schema::Location at = location();
  at.field->write(at.owner, value);
  announceValue();
}

int SetValue::id() const {
  return edit_ == DocumentModel::Edit::Repeated ? kSetValueId : -1;
}

bool SetValue::mergeWith(const QUndoCommand* later) {
  const auto& next = static_cast<const SetValue&>(*later);
  if (next.path() != path() || hasFollowers() || next.hasFollowers()) return false;
  after_ = next.after_;
  setText(next.text());
  setObsolete(after_ == before_);
  return true;
}

ChooseAlternative::ChooseAlternative(DocumentModel& model, QString path, std::size_t option,
                                     const QString& text)
    : EditCommand(model, std::move(path), text), option_(option) {
  const schema::Location at = location();
  before_ = capture(*at.field, at.owner);
}

void ChooseAlternative::revert() {
  const schema::Location at = location();
  restore(*at.field, at.owner, before_);
  announceStructure();
}

void ChooseAlternative::apply() {
  const schema::Location at = location();
  at.field->choose(at.owner, option_);
  announceStructure();
}

InsertElement::InsertElement(DocumentModel& model, QString list, std::size_t index,
                             std::optional<Snapshot> values, const QString& text)
    : EditCommand(model, std::move(list), text), index_(index), values_(std::move(values)) {}

void InsertElement::revert() {
  const schema::Location list = location();
  list.field->erase(list.owner, index_);
  announceStructure();
}

void InsertElement::apply() {
  const schema::Location list = location();
  list.field->insert(list.owner, index_);
  if (values_) restore(elementOf(list, index_), *values_);
  announceStructure();
}

RemoveElement::RemoveElement(DocumentModel& model, QString list, std::size_t index,
                             const QString& text)
    : EditCommand(model, std::move(list), text),
      index_(index),
      values_(capture(elementOf(location(), index))) {}

void RemoveElement::revert() {
  const schema::Location list = location();
  list.field->insert(list.owner, index_);
  restore(elementOf(list, index_), values_);
  announceStructure();
}

void RemoveElement::apply() {
  const schema::Location list = location();
  list.field->erase(list.owner, index_);
  announceStructure();
}

MoveElement::MoveElement(DocumentModel& model, QString list, std::size_t from, std::size_t to,
                         const QString& text)
    : EditCommand(model, std::move(list), text), from_(from), to_(to) {}

void MoveElement::move(std::size_t from, std::size_t to) {
  const schema::Location list = location();
  const Snapshot values = capture(elementOf(list, from));
  list.field->erase(list.owner, from);
  list.field->insert(list.owner, to);
  restore(elementOf(list, to), values);
  announceStructure();
}

ReplaceRows::ReplaceRows(DocumentModel& model, QString list, FieldSnapshot rows,
                         const QString& text)
    : EditCommand(model, std::move(list), text), after_(std::move(rows)) {
  const schema::Location at = location();
  before_ = capture(*at.field, at.owner);
}

void ReplaceRows::write(const FieldSnapshot& rows) {
  const schema::Location at = location();
  restore(*at.field, at.owner, rows);
  announceStructure();
}

ReplaceObject::ReplaceObject(DocumentModel& model, QString path, Snapshot values,
                             const QString& text)
    : EditCommand(model, std::move(path), text),
      before_(capture(target())),
      after_(std::move(values)) {}

schema::Ref ReplaceObject::target() const {
  if (path().isEmpty()) return rootRef();
  const schema::Location at = location();
  return elementOf(at, at.element.value_or(0));
}

void ReplaceObject::write(const Snapshot& values) {
  restore(target(), values);
  announceStructure();
}

}  // namespace rotorbench
