// The values of one described struct, kept apart from it: what undo commands remember of a list
// element, an alternative or a whole group. Values are SI, as stored; the shape follows the order
// of schema::Type::fields.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench {

struct Snapshot;

/// What one field held: a leaf its value, a variant the chosen option, a list its length, and the
/// structs below.
struct FieldSnapshot {
  schema::Value value;
  std::size_t number = 0;
  std::vector<Snapshot> children;
  bool operator==(const FieldSnapshot&) const;
};

struct Snapshot {
  std::vector<FieldSnapshot> fields;
  bool operator==(const Snapshot&) const;
};

/// Copies every described value out of `object`.
Snapshot capture(schema::ConstRef object);
FieldSnapshot capture(const schema::Field& field, const void* owner);

/// Writes the values back; the struct must be of the type they were captured from.
void restore(schema::Ref object, const Snapshot& snapshot);
void restore(const schema::Field& field, void* owner, const FieldSnapshot& snapshot);

}  // namespace rotorbench
