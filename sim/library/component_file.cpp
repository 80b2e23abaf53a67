#include "sim/library/component_file.h"

#include <algorithm>

#include "sim/core/schema_tree.h"
#include "sim/io/file.h"
#include "sim/io/json_value.h"
#include "sim/library/component_kind.h"

namespace rotorbench {

namespace {

const JsonValue* member(const JsonValue::Object& object, std::string_view key) {
  const auto found = std::ranges::find(object, key, &JsonMember::key);
  return found == object.end() ? nullptr : &found->value;
}

std::vector<schema::Option> kindOptions() {
  std::vector<schema::Option> options;
  for (const auto& kind : componentKinds()) options.push_back({kind.key, kind.label, {}});
  return options;
}

/// The kind a file says it is of. Other faults of the file are left to the reader of that kind.
const ComponentKind& kindIn(std::string_view text, const std::string& source) {
  std::vector<Problem> ignored;
  const JsonValue json = parseJson(text, source, ignored);
  const auto* object = json.object();
  const std::string format = componentFormat().key;
  if (object == nullptr || member(*object, format) == nullptr) {
    const bool experiment = object != nullptr && member(*object, DocumentFormat().key) != nullptr;
    throw InputError(source, {{{},
                               experiment ? "this is an experiment, not a component"
                                          : "this is not a component file",
                               "a file that begins with the key " + format}});
  }
  const JsonValue* given = member(*object, "kind");
  const std::string* key = given == nullptr ? nullptr : given->text();
  const ComponentKind* kind = key == nullptr ? nullptr : kindOf(*key);
  if (kind != nullptr) return *kind;
  throw InputError(
      source,
      {{"kind", given == nullptr ? "this key is missing" : given->shown() + " is not allowed",
        schema::allowedOptions(kindOptions(), key == nullptr ? "" : *key)}});
}

}  // namespace

std::string writeComponent(const Component& component) {
  const ComponentKind* kind = component.type == nullptr ? nullptr : kindOf(*component.type);
  if (kind == nullptr) {
    throw InputError(component.info.name, {{{}, "this is no kind of component", {}}});
  }
  std::vector<Problem> problems = schema::validate(schema::ref(component.info));
  for (Problem& problem : schema::validate(component.ref())) {
    problem.path = schema::joinPath("value", problem.path);
    if (!problem.warning) problems.push_back(std::move(problem));
  }
  if (!problems.empty()) throw InputError(component.info.name, std::move(problems));
  return kind->write(component);
}

Component readComponent(std::string_view text, const std::string& source) {
  return kindIn(text, source).read(text, source);
}

Component loadComponent(const std::filesystem::path& file) {
  return readComponent(readTextFile(file), file.string());
}

}  // namespace rotorbench
