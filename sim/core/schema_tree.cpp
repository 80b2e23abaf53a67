#include "sim/core/schema_tree.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sim/core/number_text.h"

namespace rotorbench::schema {

std::string joinPath(std::string_view path, std::string_view key) {
  std::string joined(path);
  if (!joined.empty() && !key.empty() && key.front() != '[') joined += '.';
  return joined.append(key);
}

std::optional<std::size_t> optionNamed(const std::vector<Option>& options, std::string_view key) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    const auto& former = options[i].formerKeys;
    if (options[i].key == key || std::ranges::find(former, key) != former.end()) return i;
  }
  return {};
}

namespace {

[[noreturn]] void fail(std::string path, std::string what, std::string allowed = {}) {
  throw InputError({}, {{std::move(path), std::move(what), std::move(allowed)}});
}

/// The alternative of the variant `parent` that would have `key`, for a hint.
std::string hintAboutAlternatives(const Field* parent, const std::string& path,
                                  std::string_view key) {
  if (parent == nullptr || parent->kind != Kind::Variant) return {};
  for (std::size_t i = 0; i < parent->options.size(); ++i) {
    if (parent->alternativeType(i).field(key) != nullptr) {
      return "it belongs to " + path + ".type = " + parent->options[i].key;
    }
  }
  return {};
}

/// Follows a path from struct to struct.
class PathFinder {
 public:
  PathFinder(Ref root, std::string_view path)
      : type_(root.type), owner_(root.object), whole_(path), rest_(path) {}

  Location find() {
    while (true) {
      const Field& field = takeKey();
      if (rest_.empty()) return {&field, owner_, path_, {}};
      if (field.isLeaf()) return component(field);
      std::size_t index = 0;
      if (field.kind == Kind::List) {
        index = takeIndex(field.count(owner_));
        if (rest_.empty()) return {&field, owner_, path_, index};
      }
      takeDot();
      if (field.kind == Kind::Variant && rest_ == "type") {
        return {&field, owner_, path_ + ".type", {}};
      }
      type_ = &field.childType(owner_, index);
      owner_ = field.child(owner_, index);
      parent_ = &field;
    }
  }

 private:
  const Field& takeKey() {
    const std::string_view key = rest_.substr(0, rest_.find_first_of(".["));
    if (key.empty()) failShape();
    const Field* field = type_->field(key);
    if (field == nullptr) failUnknown(key);
    rest_.remove_prefix(key.size());
    path_ = joinPath(path_, key);
    return *field;
  }

  std::size_t takeIndex(std::size_t count) {
    const std::size_t close = rest_.find(']');
    if (rest_.front() != '[' || close == std::string_view::npos) failShape();
    const std::string_view digits = rest_.substr(1, close - 1);
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error != std::errc() || end != digits.data() + digits.size()) failShape();
    if (index >= count) {
      fail(path_, "there is no element " + std::to_string(index),
           count == 0 ? "the list is empty" : "the elements are 0 to " + std::to_string(count - 1));
    }
    rest_.remove_prefix(close + 1);
    path_.append("[").append(std::to_string(index)).append("]");
    return index;
  }

  void takeDot() {
    if (rest_.front() != '.' || rest_.size() == 1) failShape();
    rest_.remove_prefix(1);
  }

  /// How many the vector has now.
  [[nodiscard]] std::size_t components(const Field& field) const {
    if (field.leastSize == field.size) return field.size;
    return std::get<std::vector<double>>(field.read(owner_)).size();
  }

  Location component(const Field& field) {
    if (field.kind != Kind::Vector) {
      takeDot();
      fail(joinPath(path_, excerpt(rest_)), "there is no such parameter",
           path_ + " is a single value");
    }
    const std::string path = path_;
    if (rest_.front() == '[') {
      const std::size_t index = takeIndex(components(field));
      if (!rest_.empty()) failShape();
      return {&field, owner_, path + "." + field.componentNames[index], index};
    }
    takeDot();
    std::vector<std::string> names = field.componentNames;
    names.resize(components(field));
    const auto found = std::find(names.begin(), names.end(), rest_);
    if (found == names.end()) failUnknownComponent(names);
    return {&field, owner_, joinPath(path, rest_), static_cast<std::size_t>(found - names.begin())};
  }

  [[noreturn]] void failUnknown(std::string_view key) const {
    std::vector<std::string> keys;
    for (const Field& field : type_->fields) keys.push_back(field.key);
    std::string hint = hintAboutAlternatives(parent_, path_, key);
    if (const auto near = nearest(key, keys); near && hint.empty()) {
      hint = "the nearest is " + joinPath(path_, *near);
    }
    fail(joinPath(path_, excerpt(key)), "there is no such parameter", hint);
  }

  [[noreturn]] void failUnknownComponent(const std::vector<std::string>& names) const {
    std::string list;
    for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
    fail(joinPath(path_, excerpt(rest_)), "there is no such component",
         "the components are " + list);
  }

  [[noreturn]] void failShape() const {
    fail(excerpt(whole_, 200), "this is not a path to a parameter",
         "paths look like vehicle.rotors[2].arm");
  }

  const Type* type_;
  void* owner_;
  std::string_view whole_, rest_;
  std::string path_;
  const Field* parent_ = nullptr;
};

bool isAlternative(const Location& location) {
  return location.field->kind == Kind::Variant && location.path.ends_with(".type");
}

[[noreturn]] void failNoValue(const Location& location) {
  fail(location.path, "this is not a single value", "name one of its members");
}

Problem problemWithOption(const Field& field, const std::string& path, const std::string& given) {
  return {path, inQuotes(given) + " is not allowed", allowedOptions(field.options, given)};
}

void choose(const Location& location, const Value& value) {
  const std::string* key = std::get_if<std::string>(&value);
  if (key == nullptr)
    fail(location.path, "this is not a name", allowedOptions(location.field->options, {}));
  const auto& options = location.field->options;
  const auto found = optionNamed(options, *key);
  if (!found) {
    throw InputError({}, {problemWithOption(*location.field, location.path, *key)});
  }
  location.field->choose(location.owner, *found);
}

/// The whole vector with one component replaced.
Value withComponent(const Location& location, const Value& value) {
  auto components = std::get<std::vector<double>>(location.field->read(location.owner));
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    components[*location.element] = static_cast<double>(*whole);
  } else if (const auto* number = std::get_if<double>(&value)) {
    components[*location.element] = *number;
  } else {
    fail(location.path, "this is not a number");
  }
  return components;
}

}  // namespace

Location locate(Ref root, std::string_view path) {
  if (path.empty()) fail({}, "the path is empty", "paths look like vehicle.rotors[2].arm");
  return PathFinder(root, path).find();
}

Value get(ConstRef root, std::string_view path) {
  const Location location = locate({root.type, const_cast<void*>(root.object)}, path);
  const Field& field = *location.field;
  if (isAlternative(location)) return field.options[field.chosen(location.owner)].key;
  if (!field.isLeaf()) failNoValue(location);
  Value value = field.read(location.owner);
  if (location.element) return std::get<std::vector<double>>(value)[*location.element];
  return value;
}

void set(Ref root, std::string_view path, const Value& value) {
  const Location location = locate(root, path);
  if (isAlternative(location)) return choose(location, value);
  if (!location.field->isLeaf()) failNoValue(location);
  const auto problem =
      assign(*location.field, location.owner,
             location.element ? withComponent(location, value) : value, location.path);
  if (problem) throw InputError({}, {*problem});
}

void setFromText(Ref root, std::string_view path, std::string_view text) {
  const Location location = locate(root, path);
  if (isAlternative(location)) return choose(location, std::string(text));
  if (!location.field->isLeaf()) failNoValue(location);
  Field number;  // what one component of a vector is
  if (location.element) {
    number.unit = location.field->unit;
    number.displayUnit = location.field->displayUnit;
  }
  const auto read = readText(location.element ? number : *location.field, text, location.path);
  if (const auto* problem = std::get_if<Problem>(&read)) throw InputError({}, {*problem});
  set(root, path, std::get<Value>(read));
}

std::optional<Problem> assign(const Field& field, void* owner, const Value& value,
                              std::string path) {
  if (auto problem = check(field, value, std::move(path))) return problem;
  const auto* number = std::get_if<double>(&value);
  if (field.kind == Kind::Integer && number != nullptr) {
    field.write(owner, static_cast<std::int64_t>(*number));
  } else {
    field.write(owner, value);
  }
  return {};
}

namespace {

void addLoose(Ref object, const std::string& path, std::vector<LooseFollower>& found) {
  for (const auto& follower : object.type->followers) {
    if (!follower.fits(object.object))
      found.push_back({object, joinPath(path, follower.field), &follower});
  }
  for (const Field& field : object.type->fields) {
    if (field.kind != Kind::Group && field.kind != Kind::Variant) continue;
    addLoose({&field.childType(object.object, 0), field.child(object.object, 0)},
             joinPath(path, field.key), found);
  }
}

}  // namespace

std::vector<LooseFollower> looseFollowers(Ref root) {
  std::vector<LooseFollower> found;
  addLoose(root, {}, found);
  return found;
}

}  // namespace rotorbench::schema
