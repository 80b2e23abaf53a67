#include "ui/shell/schema_types.h"

#include <set>

namespace rotorbench {

namespace {

const schema::Type* search(const schema::Type& type, std::string_view key,
                           std::set<const schema::Type*>& seen) {
  if (type.key == key) return &type;
  if (!seen.insert(&type).second) return nullptr;
  for (const schema::Field& field : type.fields) {
    if (field.kind == schema::Kind::Variant) {
      for (std::size_t i = 0; i < field.options.size(); ++i) {
        if (const auto* found = search(field.alternativeType(i), key, seen)) return found;
      }
    } else if (!field.isLeaf()) {
      // The type of a group's or list's members does not depend on the object.
      if (const auto* found = search(field.childType(nullptr, 0), key, seen)) return found;
    }
  }
  return nullptr;
}

}  // namespace

const schema::Type* findType(const schema::Type& root, std::string_view key) {
  std::set<const schema::Type*> seen;
  return search(root, key, seen);
}

}  // namespace rotorbench
