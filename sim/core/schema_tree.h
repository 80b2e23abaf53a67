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
  /// Set when the path names a list element itself ("rotors[2]") and not a member of it, or a
  /// component of a vector.
  std::optional<std::size_t> element;
};

/// Finds "a.b[1].c". A path into an alternative that is not chosen is not found. A component of a
/// vector is found by name or index ("position.z", "position[2]") and given as `element`. Throws
/// InputError with the nearest existing key if there is no such parameter.
Location locate(Ref root, std::string_view path);

/// Reads a leaf, or the chosen alternative's key where the path ends in ".type" of a variant.
Value get(ConstRef root, std::string_view path);

/// Writes a leaf (or chooses an alternative by ".type"). Throws InputError if the value has the
/// wrong kind, lies outside its range or names no option; the document is then unchanged.
void set(Ref root, std::string_view path, const Value& value);

/// As set(), from text as a person types it after `--set path=`: "0.25", "25 cm", "true", "[1, 2,
/// 3]". Numbers without a unit are SI, as in files.
void setFromText(Ref root, std::string_view path, std::string_view text);

/// What is wrong with `value` for this leaf, if anything; `path` goes into the Problem. A whole
/// double is taken for an integer and an integer for a number.
std::optional<Problem> check(const Field& field, const Value& value, std::string path);

/// What is wrong with the number of elements of a list, if anything.
std::optional<Problem> checkCount(const Field& field, std::size_t count, std::string path);

/// Checks and, if nothing is wrong, writes a leaf of `owner`.
std::optional<Problem> assign(const Field& field, void* owner, const Value& value,
                              std::string path);

/// The text as a value of this leaf in SI, or the Problem. Ranges are not checked here.
std::variant<Value, Problem> readText(const Field& field, std::string_view text, std::string path);

/// Makes all described members of `to` equal to those of `from`; both of one type.
void copy(ConstRef from, Ref to);

/// Every violation of ranges, options, list sizes and struct rules below `root`.
std::vector<Problem> validate(ConstRef root);

/// Calls `visit` for each field below root in order of declaration (groups, variants and lists
/// before their members), chosen alternatives only.
void walk(
    ConstRef root,
    const std::function<void(const std::string& path, const Field&, const void* owner)>& visit);

/// A member that no longer fits the rest of its struct; see Type::Follower.
struct LooseFollower {
  Ref owner;
  std::string path;  ///< of the member
  const Type::Follower* follower;
};
/// All below `root`; the elements of lists are not searched.
std::vector<LooseFollower> looseFollowers(Ref root);

/// What differs between two documents of one type: leaf paths with both values as shown to people
/// ("—" where one document has no such parameter).
struct Difference {
  std::string path, left, right;
};
std::vector<Difference> compare(ConstRef left, ConstRef right);

/// A value as a person reads it: "25 cm", "on", "RK4". In the display unit, C locale, shortest
/// exact digits.
std::string toText(const Field& field, const Value& value);

/// "a.b" from "a" and "b"; just the key where the path is empty.
std::string joinPath(std::string_view path, std::string_view key);

/// "must be one of a, b, c; nearest is b" for a word that names none of the options.
std::string allowedOptions(const std::vector<Option>& options, std::string_view given);

/// The candidate closest in spelling, if close enough to be meant.
std::optional<std::string> nearest(std::string_view word,
                                   const std::vector<std::string>& candidates);

}  // namespace rotorbench::schema
