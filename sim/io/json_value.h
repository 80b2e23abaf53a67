// JSON text as a tree, read with care: hostile input (deep, huge, binary, doubled keys) ends in a
// sentence.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/core/error.h"

namespace rotorbench {

struct JsonMember;

struct JsonValue {
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;  // in order of the file
  /// monostate is null. Whole numbers beyond 64 bits are doubles.
  std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> value;

  [[nodiscard]] const Object* object() const { return std::get_if<Object>(&value); }
  [[nodiscard]] const Array* array() const { return std::get_if<Array>(&value); }
  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&value); }
  /// The value in short for a message: "true", "2.5", "\"abc\"", "a list", "an object".
  [[nodiscard]] std::string shown() const;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

constexpr std::size_t kMaxJsonBytes = std::size_t{16} << 20;
constexpr int kMaxJsonDepth = 64;
constexpr std::size_t kMaxJsonValues = 2'000'000;

/// Strict JSON (RFC 8259) in UTF-8. Throws InputError: a syntax error with line and column;
/// exceeded limits. A key given twice in one object is added to `problems` with its path; the first
/// value is kept.
JsonValue parseJson(std::string_view text, const std::string& source,
                    std::vector<Problem>& problems);

}  // namespace rotorbench
