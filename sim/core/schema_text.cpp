// Leaf values as people read and type them.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/core/units.h"

namespace rotorbench::schema {

namespace {

double displayFactor(const Field& field) {
  return unitFactor(field.unit, field.displayUnit);
}

std::string unitSuffix(const Field& field) {
  const bool plain = field.displayUnit.empty() || field.displayUnit == "1";
  return plain ? "" : " " + field.displayUnit;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) {
    text.remove_prefix(1);
  }
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) {
    text.remove_suffix(1);
  }
  return text;
}

bool sameWord(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

/// parseQuantity says "what; what is allowed".
Problem problemFrom(const std::string& sentence, std::string path) {
  const std::size_t cut = sentence.rfind("; ");
  if (cut == std::string::npos) return {std::move(path), sentence, {}};
  return {std::move(path), sentence.substr(0, cut), sentence.substr(cut + 2)};
}

using Read = std::variant<Value, Problem>;

Read readNumberText(const Field& field, std::string_view text, std::string path) {
  const ParsedQuantity parsed = parseQuantity(text, field.unit, field.unit);
  if (!parsed.value) return problemFrom(parsed.error, std::move(path));
  return Value{*parsed.value};
}

Read readIntegerText(const Field& field, std::string_view text, std::string path) {
  Read read = readNumberText(field, text, path);
  if (const auto* value = std::get_if<Value>(&read)) {
    const double number = std::get<double>(*value);
    constexpr double kExact = 9007199254740992.0;
    if (number != std::floor(number) || std::abs(number) > kExact) {
      return Problem{std::move(path), inQuotes(text) + " is not a whole number",
                     "must be " + field.range.sentence(field.unit, field.unit)};
    }
    return Value{static_cast<std::int64_t>(number)};
  }
  return read;
}

Read readBooleanText(std::string_view text, std::string path) {
  for (const char* word : {"true", "on", "yes", "1"}) {
    if (sameWord(text, word)) return Value{true};
  }
  for (const char* word : {"false", "off", "no", "0"}) {
    if (sameWord(text, word)) return Value{false};
  }
  return Problem{std::move(path), inQuotes(text) + " is not allowed", "must be true or false"};
}

Read readChoiceText(const Field& field, std::string_view text, std::string path) {
  if (const auto option = optionNamed(field.options, text))
    return Value{field.options[*option].key};
  for (const Option& option : field.options) {
    if (sameWord(option.key, text) || sameWord(option.label, text)) return Value{option.key};
  }
  return Problem{std::move(path), inQuotes(text) + " is not allowed",
                 allowedOptions(field.options, text)};
}

/// "[1, 2, 3]", "1; 2; 3", "[1, 2, 3] cm", "[1 cm, 2 cm, 3 cm]".
Read readVectorText(const Field& field, std::string_view text, std::string path) {
  std::string common(field.unit);
  if (!text.empty() && text.front() == '[') {
    const std::size_t close = text.rfind(']');
    if (close == std::string_view::npos) {
      return Problem{std::move(path), inQuotes(text) + " lacks a closing bracket",
                     "must look like [1, 2, 3]"};
    }
    const std::string_view unit = trimmed(text.substr(close + 1));
    if (!unit.empty()) common = unit;
    text = text.substr(1, close - 1);
  }
  const char separator = text.find(';') != std::string_view::npos ? ';' : ',';
  std::vector<double> numbers;
  while (true) {
    const std::size_t end = text.find(separator);
    const ParsedQuantity parsed = parseQuantity(trimmed(text.substr(0, end)), field.unit, common);
    if (!parsed.value) return problemFrom(parsed.error, std::move(path));
    numbers.push_back(*parsed.value);
    if (end == std::string_view::npos) return Value{std::move(numbers)};
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::variant<Value, Problem> readText(const Field& field, std::string_view text, std::string path) {
  const std::string_view plain = trimmed(text);
  switch (field.kind) {
    case Kind::Number:
      return readNumberText(field, plain, std::move(path));
    case Kind::Integer:
      return readIntegerText(field, plain, std::move(path));
    case Kind::Boolean:
      return readBooleanText(plain, std::move(path));
    case Kind::Text:
      return Value{std::string(text)};
    case Kind::Choice:
    case Kind::Variant:
      return readChoiceText(field, plain, std::move(path));
    case Kind::Vector:
      return readVectorText(field, plain, std::move(path));
    default:
      return Problem{std::move(path), "this is not a single value", "name one of its members"};
  }
}

std::string toText(const Field& field, const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "on" : "off";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    return std::to_string(*whole) + unitSuffix(field);
  }
  if (const auto* number = std::get_if<double>(&value)) {
    return numberTextIn(*number, displayFactor(field)) + unitSuffix(field);
  }
  if (const auto* key = std::get_if<std::string>(&value)) {
    for (const Option& option : field.options) {
      if (option.key == *key) return option.label;
    }
    return *key;
  }
  std::string text = "[";
  for (const double component : std::get<std::vector<double>>(value)) {
    text += (text.size() == 1 ? "" : ", ") + numberTextIn(component, displayFactor(field));
  }
  return text + "]" + unitSuffix(field);
}

}  // namespace rotorbench::schema
