#include "ui/forms/document_model.h"

#include <algorithm>
#include <utility>

#include "ui/forms/edit_commands.h"

namespace rotorbench {

using schema::Kind;

bool isAtOrBelow(const QString& path, const QString& prefix) {
  if (prefix.isEmpty() || path == prefix) return true;
  return path.startsWith(prefix) &&
         (path[prefix.size()] == QLatin1Char('.') || path[prefix.size()] == QLatin1Char('['));
}

QString joinPath(const QString& parent, const QString& key) {
  return parent.isEmpty() ? key : parent + QLatin1Char('.') + key;
}

QString elementPath(const QString& list, std::size_t index) {
  return QStringLiteral("%1[%2]").arg(list).arg(index);
}

DocumentModel::DocumentModel(Document document, QObject* parent)
    : QObject(parent), document_(std::move(document)), defaults_(document_.type->make()) {
  setValueText({});
  connect(&stack_, &QUndoStack::cleanChanged, this, &DocumentModel::cleanChanged);
  checkProblems();
}

DocumentModel::~DocumentModel() = default;

void DocumentModel::replaceDocument(Document document) {
  document_ = std::move(document);
  defaults_ = document_.type->make();
  invalid_.clear();
  stack_.clear();
  emit documentReplaced();
  checkProblems();
}

schema::ConstRef DocumentModel::root() const {
  return mutableRoot();
}

schema::Ref DocumentModel::mutableRoot() const {
  return {document_.type, document_.object.get()};
}

Document DocumentModel::copy() const {
  return {document_.copy(document_.object.get()), document_.type, document_.copy};
}

schema::ConstRef DocumentModel::defaults() const {
  return {document_.type, defaults_.get()};
}

std::optional<schema::Location> DocumentModel::find(const QString& path) const {
  if (path.isEmpty()) return std::nullopt;
  try {
    return schema::locate(mutableRoot(), path.toStdString());
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<schema::ConstRef> DocumentModel::object(const QString& path) const {
  if (path.isEmpty()) return root();
  const auto at = find(path);
  if (!at || at->field->isLeaf()) return std::nullopt;
  if (at->field->kind == Kind::List && !at->element) return std::nullopt;
  const std::size_t index = at->element.value_or(0);
  if (at->field->kind == Kind::List && index >= at->field->count(at->owner)) return std::nullopt;
  return schema::ConstRef(&at->field->childType(at->owner, index),
                          at->field->constChild(at->owner, index));
}

schema::Value DocumentModel::get(const QString& path) const {
  return schema::get(root(), path.toStdString());
}

std::optional<Problem> DocumentModel::set(const QString& path, const schema::Value& value,
                                          Edit edit) {
  const std::string key = path.toStdString();
  schema::Value before;
  try {
    before = get(path);
    schema::set(mutableRoot(), key, value);
  } catch (const InputError& error) {
    return error.problems().empty() ? Problem{key, error.what(), {}} : error.problems().front();
  }
  const schema::Location at = schema::locate(mutableRoot(), key);
  const schema::Value after = at.field->read(at.owner);
  clearInvalidText(path);
  if (after == before) return std::nullopt;
  const QString text =
      tr("Change %1 to %2")
          .arg(QString::fromStdString(at.field->label), valueText_(*at.field, after));
  stack_.push(new SetValue(*this, path, before, after, text, edit));
  return std::nullopt;
}

void DocumentModel::choose(const QString& path, std::size_t option) {
  const auto at = find(path);
  if (!at || at->field->chosen(at->owner) == option) return;
  const QString text = tr("Choose %1 for %2")
                           .arg(QString::fromStdString(at->field->options.at(option).label),
                                QString::fromStdString(at->field->label));
  stack_.push(new ChooseAlternative(*this, path, option, text));
}

QString DocumentModel::elementLabel(const QString& list) const {
  const auto at = find(list);
  return at ? QString::fromStdString(at->field->label) : list;
}

void DocumentModel::insertElement(const QString& list, std::size_t before) {
  stack_.push(new InsertElement(*this, list, before, std::nullopt,
                                tr("Add to %1").arg(elementLabel(list))));
}

void DocumentModel::duplicateElement(const QString& list, std::size_t index) {
  const auto source = object(elementPath(list, index));
  if (!source) return;
  stack_.push(new InsertElement(*this, list, index + 1, capture(*source),
                                tr("Duplicate %1 %2").arg(elementLabel(list)).arg(index + 1)));
}

void DocumentModel::removeElement(const QString& list, std::size_t index) {
  stack_.push(new RemoveElement(*this, list, index,
                                tr("Remove %1 %2").arg(elementLabel(list)).arg(index + 1)));
}

void DocumentModel::moveElement(const QString& list, std::size_t from, std::size_t to) {
  if (from == to) return;
  stack_.push(new MoveElement(*this, list, from, to,
                              tr("Move %1 %2").arg(elementLabel(list)).arg(from + 1)));
}

void DocumentModel::replaceRows(const QString& list, const FieldSnapshot& rows,
                                const QString& text) {
  stack_.push(new ReplaceRows(*this, list, rows, text));
}

void DocumentModel::replaceObject(const QString& path, const Snapshot& values,
                                  const QString& text) {
  stack_.push(new ReplaceObject(*this, path, values, text));
}

void DocumentModel::setInvalidText(const QString& path, const QString& text,
                                   const QString& sentence) {
  invalid_[path] = {text, sentence};
  checkProblems();
}

void DocumentModel::clearInvalidText(const QString& path) {
  if (invalid_.remove(path) > 0) checkProblems();
}

std::optional<InvalidText> DocumentModel::invalidText(const QString& path) const {
  const auto found = invalid_.constFind(path);
  if (found == invalid_.constEnd()) return std::nullopt;
  return *found;
}

void DocumentModel::setExtraValidator(Validator validator) {
  extraValidator_ = std::move(validator);
  checkProblems();
}

bool DocumentModel::hasErrors() const {
  return std::any_of(problems_.begin(), problems_.end(),
                     [](const Problem& problem) { return !problem.warning; });
}

void DocumentModel::setValueText(ValueText text) {
  valueText_ = std::move(text);
  if (valueText_) return;
  valueText_ = [](const schema::Field& field, const schema::Value& value) {
    return QString::fromStdString(schema::toText(field, value));
  };
}

void DocumentModel::commitPendingEdits() {
  emit commitRequested();
}

void DocumentModel::announceValue(const QString& path) {
  dropInvalidBelow(path);
  emit valueChanged(path);
  checkProblems();
}

void DocumentModel::announceStructure(const QString& path) {
  dropInvalidBelow(path);
  emit structureChanged(path);
  checkProblems();
}

void DocumentModel::dropInvalidBelow(const QString& path) {
  invalid_.removeIf([&](const std::pair<const QString&, InvalidText&>& entry) {
    return isAtOrBelow(entry.first, path);
  });
}

void DocumentModel::checkProblems() {
  std::vector<Problem> found;
  for (auto it = invalid_.constBegin(); it != invalid_.constEnd(); ++it) {
    found.push_back({it.key().toStdString(), it->sentence.toStdString(), {}});
  }
  const auto append = [&found](std::vector<Problem> more) {
    std::move(more.begin(), more.end(), std::back_inserter(found));
  };
  append(schema::validate(root()));
  if (extraValidator_) append(extraValidator_(root()));
  if (found == problems_) return;
  problems_ = std::move(found);
  emit problemsChanged();
}

}  // namespace rotorbench
