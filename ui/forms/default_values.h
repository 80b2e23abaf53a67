// What counts as the default of a place in a document: the value at the same place of a
// default-made document; inside an alternative or a list that differs from it, the value of a
// default-made struct.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "sim/core/schema_tree.h"

namespace rotorbench {

/// The default of the leaf at `path` of `document`, `defaults` being a default-made document of its
/// type. Empty if there is no such leaf.
std::optional<schema::Value> defaultValue(schema::ConstRef document, schema::ConstRef defaults,
                                          const QString& path);

/// True if anything at or below the field of `owner` differs from `defaultOwner`, a struct of the
/// same type.
bool differsFromDefault(const schema::Field& field, const void* owner, const void* defaultOwner);
bool differsFromDefault(schema::ConstRef object, const void* defaultObject);

/// A walk down one path in step with the defaults. Keeps default-made structs alive while it lives.
class DefaultsCursor {
 public:
  DefaultsCursor(schema::ConstRef document, schema::ConstRef defaults);
  /// Follows `path` from where the cursor stands; false if there is no such struct.
  bool descend(const QString& path);
  [[nodiscard]] schema::ConstRef object() const { return object_; }
  [[nodiscard]] const void* defaultObject() const { return defaultObject_; }

 private:
  bool enter(const schema::Field& field, std::size_t index);

  schema::ConstRef object_;
  const void* defaultObject_;
  std::vector<std::shared_ptr<void>> kept_;
};

}  // namespace rotorbench
