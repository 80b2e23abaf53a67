// Walking and editing any described struct by path, without knowing its C++ type.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench::schema {

/// A field found by path: the field and the address of the struct that owns it.
struct Location {
  const Field* field = nullptr;
  void* owner = nullptr;
  std::string path;
  /// Set when the path names a list element itself ("rotors[2]") and not a member of it.
  std::optional<std::size_t> element;
};

/// Finds "a.b[1].c". A path into an alternative that is not chosen is not found. Throws InputError with the
/// nearest existing key if there is no such parameter.
Location locate(Ref root, std::string_view path);

/// Reads a leaf, or the chosen alternative's key where the path ends in ".type" of a variant.
Value get(ConstRef root, std::string_view path);

/// Writes a leaf (or chooses an alternative by ".type"). Throws InputError if the value has the wrong kind, lies
/// outside its range or names no option; the document is then unchanged.
void set(Ref root, std::string_view path, const Value& value);

/// As set(), from text as a person types it after `--set path=`: "0.25", "25 cm", "true", "[1, 2, 3]".
void setFromText(Ref root, std::string_view path, std::string_view text);

/// Every violation of ranges, options, list sizes and struct rules below `root`.
std::vector<Problem> validate(ConstRef root);

/// Calls `visit` for each field below root in order of declaration (groups, variants and lists before their
/// members), chosen alternatives only.
void walk(ConstRef root, const std::function<void(const std::string& path, const Field&, const void* owner)>& visit);

/// What differs between two documents of one type: leaf paths with both values as shown to people ("—" where
/// one document has no such parameter).
struct Difference {
  std::string path, left, right;
};
std::vector<Difference> compare(ConstRef left, ConstRef right);

/// A value as a person reads it: "25 cm", "on", "RK4". In the display unit, C locale, shortest exact digits.
std::string toText(const Field& field, const Value& value);

/// The candidate closest in spelling, if close enough to be meant.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace rotorbench::schema
