#include "ui/forms/default_values.h"

#include <QStringList>

namespace rotorbench {

using schema::Kind;

namespace {

/// Where the child of a struct finds its defaults; `made` keeps a default-made struct alive if one
/// is needed.
const void* defaultChild(const schema::Field& field, const void* owner, const void* defaultOwner,
                         std::size_t index, std::shared_ptr<void>& made) {
  const bool sameShape =
      field.kind == Kind::Group ||
      (field.kind == Kind::Variant && field.chosen(owner) == field.chosen(defaultOwner)) ||
      (field.kind == Kind::List && field.count(owner) == field.count(defaultOwner));
  if (sameShape) return field.constChild(defaultOwner, index);
  made = field.childType(owner, index).make();
  return made.get();
}

}  // namespace

bool differsFromDefault(const schema::Field& field, const void* owner, const void* defaultOwner) {
  if (field.isLeaf()) return field.read(owner) != field.read(defaultOwner);
  std::size_t children = 1;
  if (field.kind == Kind::Variant && field.chosen(owner) != field.chosen(defaultOwner)) return true;
  if (field.kind == Kind::List) {
    children = field.count(owner);
    if (children != field.count(defaultOwner)) return true;
  }
  for (std::size_t i = 0; i < children; ++i) {
    const schema::ConstRef child(&field.childType(owner, i), field.constChild(owner, i));
    if (differsFromDefault(child, field.constChild(defaultOwner, i))) return true;
  }
  return false;
}

bool differsFromDefault(schema::ConstRef object, const void* defaultObject) {
  for (const auto& field : object.type->fields) {
    if (differsFromDefault(field, object.object, defaultObject)) return true;
  }
  return false;
}

DefaultsCursor::DefaultsCursor(schema::ConstRef document, schema::ConstRef defaults)
    : object_(document), defaultObject_(defaults.object) {}

bool DefaultsCursor::enter(const schema::Field& field, std::size_t index) {
  if (field.isLeaf()) return false;
  if (field.kind == Kind::List && index >= field.count(object_.object)) return false;
  std::shared_ptr<void> made;
  defaultObject_ = defaultChild(field, object_.object, defaultObject_, index, made);
  if (made) kept_.push_back(std::move(made));
  object_ = {&field.childType(object_.object, index), field.constChild(object_.object, index)};
  return true;
}

bool DefaultsCursor::descend(const QString& path) {
  for (const QString& segment : path.split(QLatin1Char('.'), Qt::SkipEmptyParts)) {
    const qsizetype bracket = segment.indexOf(QLatin1Char('['));
    const QString key = bracket < 0 ? segment : segment.left(bracket);
    const schema::Field* field = object_.type->field(key.toStdString());
    if (field == nullptr) return false;
    const std::size_t index =
        bracket < 0 ? 0 : segment.mid(bracket + 1, segment.size() - bracket - 2).toULongLong();
    if (!enter(*field, index)) return false;
  }
  return true;
}

std::optional<schema::Value> defaultValue(schema::ConstRef document, schema::ConstRef defaults,
                                          const QString& path) {
  DefaultsCursor cursor(document, defaults);
  const qsizetype dot = path.lastIndexOf(QLatin1Char('.'));
  if (dot > 0 && !cursor.descend(path.left(dot))) return std::nullopt;
  const schema::Field* field = cursor.object().type->field(path.mid(dot + 1).toStdString());
  if (field == nullptr || !field->isLeaf()) return std::nullopt;
  return field->read(cursor.defaultObject());
}

}  // namespace rotorbench
