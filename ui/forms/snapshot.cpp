#include "ui/forms/snapshot.h"

namespace rotorbench {

using schema::Kind;

bool FieldSnapshot::operator==(const FieldSnapshot&) const = default;
bool Snapshot::operator==(const Snapshot&) const = default;

FieldSnapshot capture(const schema::Field& field, const void* owner) {
  FieldSnapshot kept;
  if (field.isLeaf()) {
    kept.value = field.read(owner);
    return kept;
  }
  std::size_t children = 1;
  if (field.kind == Kind::Variant) kept.number = field.chosen(owner);
  if (field.kind == Kind::List) children = kept.number = field.count(owner);
  kept.children.reserve(children);
  for (std::size_t i = 0; i < children; ++i) {
    kept.children.push_back(
        capture(schema::ConstRef(&field.childType(owner, i), field.constChild(owner, i))));
  }
  return kept;
}

Snapshot capture(schema::ConstRef object) {
  Snapshot snapshot;
  snapshot.fields.reserve(object.type->fields.size());
  for (const auto& field : object.type->fields) {
    snapshot.fields.push_back(capture(field, object.object));
  }
  return snapshot;
}

void restore(const schema::Field& field, void* owner, const FieldSnapshot& snapshot) {
  if (field.isLeaf()) {
    field.write(owner, snapshot.value);
    return;
  }
  if (field.kind == Kind::Variant) field.choose(owner, snapshot.number);
  if (field.kind == Kind::List) field.resize(owner, snapshot.number);
  for (std::size_t i = 0; i < snapshot.children.size(); ++i) {
    restore(schema::Ref{&field.childType(owner, i), field.child(owner, i)}, snapshot.children[i]);
  }
}

void restore(schema::Ref object, const Snapshot& snapshot) {
  for (std::size_t i = 0; i < snapshot.fields.size(); ++i) {
    restore(object.type->fields[i], object.object, snapshot.fields[i]);
  }
}

}  // namespace rotorbench
