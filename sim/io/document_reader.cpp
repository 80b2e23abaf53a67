#include <algorithm>
#include <unordered_set>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/core/units.h"
#include "sim/io/json_document.h"
#include "sim/io/json_value.h"

namespace rotorbench {

namespace {

using schema::Field;
using schema::Kind;
using schema::Ref;

/// A file of nothing but faults is not listed in full.
constexpr std::size_t kMostProblems = 1000;

std::string versionsRead(const DocumentFormat& format) {
  return "this program reads version " + std::to_string(format.oldest) +
         (format.oldest == format.newest ? "" : " to " + std::to_string(format.newest));
}

const JsonValue* member(const JsonValue::Object& object, std::string_view key) {
  const auto found = std::find_if(object.begin(), object.end(),
                                  [&](const auto& entry) { return entry.key == key; });
  return found == object.end() ? nullptr : &found->value;
}

/// The object with its member at `from`, two keys joined by a dot, as its own member `key`; nothing
/// where the file has no such member or has `key` already.
std::optional<JsonValue::Object> withMoved(const JsonValue::Object& object, std::string_view from,
                                           const std::string& key) {
  const std::size_t dot = from.find('.');
  const JsonValue* holder = member(object, from.substr(0, dot));
  if (holder == nullptr || holder->object() == nullptr || member(object, key) != nullptr) return {};
  const std::string_view inner = from.substr(dot + 1);
  if (member(*holder->object(), inner) == nullptr) return {};
  JsonValue::Object result = object;
  for (auto& [name, value] : result) {
    if (name != from.substr(0, dot)) continue;
    auto& members = std::get<JsonValue::Object>(value.value);
    const auto at = std::find_if(members.begin(), members.end(),
                                 [&](const auto& entry) { return entry.key == inner; });
    JsonMember taken{key, std::move(at->value)};
    members.erase(at);
    result.push_back(std::move(taken));
    break;
  }
  return result;
}

class DocumentReader {
 public:
  explicit DocumentReader(std::vector<Problem>& problems) : problems_(problems) {}

  /// Reads the members of one struct; `extraKey` is allowed besides the described ones.
  void readMembers(Ref node, const JsonValue::Object& object, const std::string& path,
                   std::string_view extraKey) {
    for (const auto& [from, key] : node.type->moved) {
      if (auto older = withMoved(object, from, key))
        return readMembers(node, *older, path, extraKey);
    }
    for (const auto& [key, value] : object) {
      if (problems_.size() >= kMostProblems) return;
      if (!extraKey.empty() && key == extraKey) continue;
      if (const Field* field = node.type->field(key)) {
        readField(*field, node.object, value, schema::joinPath(path, key));
      } else {
        reportUnknown(*node.type, key, path, extraKey);
      }
    }
  }

 private:
  void report(const std::string& path, std::string what, std::string allowed) {
    problems_.push_back({path, std::move(what), std::move(allowed)});
  }

  void reportUnknown(const schema::Type& type, const std::string& key, const std::string& path,
                     std::string_view extraKey) {
    std::vector<std::string> keys;
    if (!extraKey.empty()) keys.emplace_back(extraKey);
    for (const Field& field : type.fields) keys.push_back(field.key);
    std::string allowed;
    if (const auto near = schema::nearest(key, keys)) {
      allowed = "the nearest known key is " + *near;
    } else {
      for (const auto& known : keys)
        allowed += (allowed.empty() ? "must be one of " : ", ") + known;
    }
    report(schema::joinPath(path, excerpt(key)), "this key is unknown", std::move(allowed));
  }

  void readField(const Field& field, void* owner, const JsonValue& json, const std::string& path) {
    switch (field.kind) {
      case Kind::List:
        return readList(field, owner, json, path);
      case Kind::Variant:
        return readVariant(field, owner, json, path);
      case Kind::Group:
        if (const auto* object = json.object()) {
          return readStruct(field, owner, *object, path, {});
        }
        return report(path, json.shown() + " is not allowed", "must be an object { ... }");
      default:
        readLeaf(field, owner, json, path);
    }
  }

  /// A group or the chosen alternative of a variant.
  void readStruct(const Field& field, void* owner, const JsonValue::Object& object,
                  const std::string& path, std::string_view extraKey) {
    const Ref node{&field.childType(owner, 0), field.child(owner, 0)};
    if (node.type->standsAlone) {
      const std::shared_ptr<void> own = node.type->make();
      schema::copy(schema::ConstRef(node.type, own.get()), node);
    }
    readMembers(node, object, path, extraKey);
    for (const Field& inner : node.type->fields) {
      if (inner.required && member(object, inner.key) == nullptr)
        report(schema::joinPath(path, inner.key), "this key is missing",
               "must be given: no figure of another product stands in for it");
    }
  }

  void readList(const Field& field, void* owner, const JsonValue& json, const std::string& path) {
    const auto* array = json.array();
    if (array == nullptr) {
      return report(path, json.shown() + " is not allowed", "must be a list [ ... ]");
    }
    if (array->size() > field.maxItems) {
      problems_.push_back(*schema::checkCount(field, array->size(), path));
      return;
    }
    field.resize(owner, 0);  // so that every element starts from its own defaults
    field.resize(owner, array->size());
    for (std::size_t i = 0; i < array->size() && problems_.size() < kMostProblems; ++i) {
      std::string element = path;
      element.append("[").append(std::to_string(i)).append("]");
      if (const auto* object = (*array)[i].object()) {
        readMembers({&field.childType(owner, i), field.child(owner, i)}, *object, element, {});
      } else {
        report(element, (*array)[i].shown() + " is not allowed", "must be an object { ... }");
      }
    }
  }

  void readVariant(const Field& field, void* owner, const JsonValue& json,
                   const std::string& path) {
    const auto* object = json.object();
    if (object == nullptr) {
      return report(path, json.shown() + " is not allowed", "must be an object with \"type\"");
    }
    const JsonValue* type = member(*object, "type");
    const std::string* key = type == nullptr ? nullptr : type->text();
    const auto option = key == nullptr ? std::nullopt : schema::optionNamed(field.options, *key);
    if (type == nullptr && field.untyped) {
      field.choose(owner, 0);
      return readStruct(field, owner, *object, path, {});
    }
    if (!option) {
      return report(path + ".type",
                    type == nullptr ? "this key is missing" : type->shown() + " is not allowed",
                    schema::allowedOptions(field.options, key == nullptr ? "" : *key));
    }
    field.choose(owner, *option);
    readStruct(field, owner, *object, path, "type");
  }

  void readLeaf(const Field& field, void* owner, const JsonValue& json, const std::string& path) {
    const auto value = leafValue(field, json, path);
    if (!value) return;
    auto problem = schema::assign(field, owner, *value, path);
    if (!problem) return;
    problems_.push_back(std::move(*problem));
    // A number out of range is kept, so that rules over several members see what the file says.
    if (field.kind == Kind::Number) field.write(owner, *value);
  }

  /// The value of the right kind, or nothing after a report.
  std::optional<schema::Value> leafValue(const Field& field, const JsonValue& json,
                                         const std::string& path) {
    if (field.kind == Kind::Vector && json.array() != nullptr) {
      return vectorValue(field, *json.array(), path);
    }
    if (field.kind == Kind::Number) {
      if (const auto number = quantity(field, json, path)) return schema::Value{*number};
      return {};
    }
    if (const auto* flag = std::get_if<bool>(&json.value)) return schema::Value{*flag};
    if (const auto* whole = std::get_if<std::int64_t>(&json.value)) return schema::Value{*whole};
    if (const auto* number = std::get_if<double>(&json.value)) return schema::Value{*number};
    if (const auto* text = json.text()) return schema::Value{*text};
    report(path, json.shown() + " is not allowed", whatIsAllowed(field));
    return {};
  }

  static std::string whatIsAllowed(const Field& field) {
    switch (field.kind) {
      case Kind::Boolean:
        return "must be true or false";
      case Kind::Text:
        return "must be text in quotes";
      case Kind::Choice:
        return schema::allowedOptions(field.options, {});
      case Kind::Vector:
        return "must be a list of " + field.sizeText() + " numbers";
      default:
        return "must be " + field.range.sentence(field.unit, field.displayUnit);
    }
  }

  /// A number in SI, from a JSON number or a string with a unit.
  std::optional<double> quantity(const Field& field, const JsonValue& json,
                                 const std::string& path) {
    if (const auto* whole = std::get_if<std::int64_t>(&json.value)) {
      return static_cast<double>(*whole);
    }
    if (const auto* number = std::get_if<double>(&json.value)) return *number;
    if (const auto* text = json.text()) {
      const ParsedQuantity parsed = parseQuantity(*text, field.unit, "1");
      if (parsed.value) return parsed.value;
      const std::size_t cut = parsed.error.rfind("; ");
      report(path, parsed.error.substr(0, cut), parsed.error.substr(cut + 2));
      return {};
    }
    report(path, json.shown() + " is not allowed",
           "must be a number, " + field.range.sentence(field.unit, field.displayUnit));
    return {};
  }

  std::optional<schema::Value> vectorValue(const Field& field, const JsonValue::Array& array,
                                           const std::string& path) {
    if (array.size() < field.leastSize || array.size() > field.size) {
      report(path, "this list has " + std::to_string(array.size()) + " elements",
             whatIsAllowed(field));
      return {};
    }
    std::vector<double> numbers;
    for (std::size_t i = 0; i < array.size(); ++i) {
      const std::string component = schema::joinPath(path, field.componentNames[i]);
      if (const auto number = quantity(field, array[i], component)) numbers.push_back(*number);
    }
    if (numbers.size() != array.size()) return {};
    return schema::Value{std::move(numbers)};
  }

  std::vector<Problem>& problems_;
};

/// Throws unless the root says it is a file of a version this program reads.
const JsonValue::Object& checkHeader(const JsonValue& json, const std::string& source,
                                     const DocumentFormat& format) {
  const auto fail = [&](std::string path, std::string what) {
    throw InputError(source, {{std::move(path), std::move(what), versionsRead(format)}});
  };
  const auto* object = json.object();
  if (object == nullptr) fail({}, "the file is " + json.shown() + ", not an object { ... }");
  const JsonValue* version = member(*object, format.key);
  if (version == nullptr) fail(format.key, "the format version is missing");
  const auto* number = std::get_if<std::int64_t>(&version->value);
  if (number == nullptr) fail(format.key, version->shown() + " is not a format version");
  if (*number < format.oldest || *number > format.newest) {
    fail(format.key, "the format version " + std::to_string(*number) + " is unknown");
  }
  return *object;
}

/// Adds what validation finds, but for places already complained about.
void addRuleProblems(schema::ConstRef root, std::vector<Problem>& problems) {
  std::unordered_set<std::string> reported;
  for (const Problem& problem : problems) reported.insert(problem.path);
  for (Problem& problem : schema::validate(root)) {
    if (problem.warning || problems.size() >= kMostProblems) continue;
    if (!reported.contains(problem.path)) problems.push_back(std::move(problem));
  }
}

}  // namespace

void readDocument(Ref target, std::string_view text, const std::string& source,
                  const DocumentFormat& format) {
  std::vector<Problem> problems;
  const JsonValue json = parseJson(text, source, problems);
  const JsonValue::Object& object = checkHeader(json, source, format);
  const std::shared_ptr<void> fresh = target.type->make();
  const Ref document{target.type, fresh.get()};
  DocumentReader(problems).readMembers(document, object, {}, format.key);
  addRuleProblems(document, problems);
  if (problems.size() >= kMostProblems) {
    problems.push_back({{}, "there are more problems than are listed here", {}});
  }
  if (!problems.empty()) throw InputError(source, std::move(problems));
  schema::copy(document, target);
}

}  // namespace rotorbench
