#include <algorithm>
#include <cmath>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/core/units.h"

namespace rotorbench::schema {

bool Range::contains(double v) const {
  const bool aboveLow = low.open ? v > low.value : v >= low.value;
  const bool belowHigh = high.open ? v < high.value : v <= high.value;
  return std::isfinite(v) && aboveLow && belowHigh;
}

namespace {

std::string withUnit(const std::string& number, std::string_view unit) {
  return unit == "1" || unit.empty() ? number : number + " " + std::string(unit);
}

std::string shown(const Field& field, double value) {
  return withUnit(numberTextIn(value, unitFactor(field.unit, field.displayUnit)),
                  field.displayUnit);
}

std::string allowedNumbers(const Field& field) {
  return std::string("must be ") + (field.kind == Kind::Integer ? "a whole number, " : "") +
         field.range.sentence(field.unit, field.displayUnit);
}

/// The value as a number, if it has the right kind.
std::optional<double> numberOf(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return {};
}

std::string given(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return inQuotes(*text);
  if (const auto number = numberOf(value)) return numberText(*number);
  return "a list of numbers";
}

using Found = std::optional<Problem>;

Found checkNumber(const Field& field, const Value& value, std::string& path) {
  const auto number = numberOf(value);
  if (!number) return Problem{path, given(value) + " is not a number", allowedNumbers(field)};
  if (field.kind == Kind::Integer && *number != std::floor(*number)) {
    return Problem{path, numberText(*number) + " is not a whole number", allowedNumbers(field)};
  }
  if (field.range.contains(*number)) return {};
  return Problem{path, shown(field, *number) + " is not allowed", allowedNumbers(field)};
}

Found checkVector(const Field& field, const Value& value, std::string& path) {
  const std::string need = "must be " + field.sizeText() + " numbers";
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (numbers == nullptr) return Problem{path, given(value) + " is not a list of numbers", need};
  if (numbers->size() < field.leastSize || numbers->size() > field.size) {
    return Problem{path, "this has " + std::to_string(numbers->size()) + " numbers", need};
  }
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    if (field.range.contains((*numbers)[i])) continue;
    return Problem{joinPath(path, field.componentNames[i]),
                   shown(field, (*numbers)[i]) + " is not allowed", allowedNumbers(field)};
  }
  return {};
}

Found checkText(const Field&, const Value& value, std::string& path) {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return Problem{path, given(value) + " is not text", "must be text"};
  if (!findInvalidUtf8(*text)) return {};
  return Problem{path, "the text \"" + excerpt(*text) + "\" is not valid UTF-8", "must be UTF-8"};
}

Found checkChoice(const Field& field, const Value& value, std::string& path) {
  const auto* key = std::get_if<std::string>(&value);
  const std::string word = key != nullptr ? *key : std::string();
  for (const Option& option : field.options) {
    if (key != nullptr && option.key == word) return {};
  }
  return Problem{path, given(value) + " is not allowed", allowedOptions(field.options, word)};
}

class Validator {
 public:
  void check(ConstRef node, const std::string& path) {
    for (const Field& field : node.type->fields) checkField(field, node.object, path);
    for (const auto& rule : node.type->checks) {
      const std::size_t first = problems.size();
      rule(node.object, problems);
      for (std::size_t i = first; i < problems.size(); ++i) {
        problems[i].path = joinPath(path, problems[i].path);
      }
    }
  }

  std::vector<Problem> problems;

 private:
  void checkField(const Field& field, const void* owner, const std::string& parent) {
    const std::string path = joinPath(parent, field.key);
    if (field.isLeaf()) {
      if (auto problem = schema::check(field, field.read(owner), path)) {
        problems.push_back(std::move(*problem));
      }
    } else if (field.kind == Kind::List) {
      const std::size_t count = field.count(owner);
      if (auto problem = checkCount(field, count, path)) problems.push_back(std::move(*problem));
      for (std::size_t i = 0; i < count; ++i) {
        check({&field.childType(owner, i), field.constChild(owner, i)},
              path + "[" + std::to_string(i) + "]");
      }
    } else {
      check({&field.childType(owner, 0), field.constChild(owner, 0)}, path);
    }
  }
};

}  // namespace

std::string Range::sentence(std::string_view siUnit, std::string_view shownUnit) const {
  const double factor = unitFactor(siUnit, shownUnit);
  const std::string_view unit =
      findUnit(shownUnit) == nullptr || sameDimension(siUnit, shownUnit) ? shownUnit : siUnit;
  std::string text;
  if (std::isfinite(low.value)) {
    text = (low.open ? "above " : "at least ") + numberTextIn(low.value, factor);
  }
  if (std::isfinite(high.value)) {
    text += (text.empty() ? "" : " and ") + std::string(high.open ? "below " : "at most ") +
            numberTextIn(high.value, factor);
  }
  return text.empty() ? "any finite number" : withUnit(text, unit);
}

std::string Field::sizeText() const {
  const std::string most = std::to_string(size);
  return leastSize == size ? most : std::to_string(leastSize) + " to " + most;
}

const Field* Type::field(std::string_view wanted) const {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == wanted; });
  return found == fields.end() ? nullptr : &*found;
}

std::string allowedOptions(const std::vector<Option>& options, std::string_view word) {
  std::string list;
  std::vector<std::string> keys;
  for (const Option& option : options) {
    list += (list.empty() ? "must be one of " : ", ") + option.key;
    keys.push_back(option.key);
  }
  if (const auto near = nearest(word, keys)) list += "; nearest is " + *near;
  return list;
}

std::optional<Problem> check(const Field& field, const Value& value, std::string path) {
  switch (field.kind) {
    case Kind::Number:
    case Kind::Integer:
      return checkNumber(field, value, path);
    case Kind::Boolean:
      if (std::holds_alternative<bool>(value)) return {};
      return Problem{std::move(path), given(value) + " is not allowed", "must be true or false"};
    case Kind::Text:
      return checkText(field, value, path);
    case Kind::Choice:
      return checkChoice(field, value, path);
    case Kind::Vector:
      return checkVector(field, value, path);
    default:
      return Problem{std::move(path), "this is not a single value", "name one of its members"};
  }
}

std::optional<Problem> checkCount(const Field& field, std::size_t count, std::string path) {
  if (count >= field.minItems && count <= field.maxItems) return {};
  const std::string need =
      field.minItems == field.maxItems
          ? "must be exactly " + std::to_string(field.minItems)
          : "must be " + std::to_string(field.minItems) + " to " + std::to_string(field.maxItems);
  return Problem{std::move(path),
                 "this list has " + std::to_string(count) + (count == 1 ? " element" : " elements"),
                 need};
}

std::vector<Problem> validate(ConstRef root) {
  Validator validator;
  validator.check(root, {});
  return std::move(validator.problems);
}

}  // namespace rotorbench::schema
