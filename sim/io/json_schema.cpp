#include "sim/io/json_schema.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "sim/core/schema_tree.h"
#include "sim/core/units.h"

namespace rotorbench {

namespace {

using nlohmann::ordered_json;
using schema::Field;
using schema::Kind;
using schema::Type;

/// `text` as a regular expression that matches only itself.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\^$.|?*+()[]{}/").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

/// One number and one unit that converts to `unit`.
std::string quantityPattern(const std::string& unit) {
  std::string units;
  for (const Unit* like : unitsLike(unit)) {
    if (like->symbol == "1") continue;
    if (!units.empty()) units += '|';
    units += escaped(like->symbol);
  }
  if (units.empty()) units = escaped(unit);
  const char* const plain = unit == "1" ? "?" : "";
  return R"(^[-+]?([0-9]+([.,][0-9]*)?|[.,][0-9]+)([eE][-+]?[0-9]+)? *()" + units + ")" + plain +
         "$";
}

void addRange(ordered_json& json, const schema::Range& range) {
  const auto add = [&](const schema::Bound& bound, const char* closed, const char* open) {
    if (std::isfinite(bound.value)) json[bound.open ? open : closed] = bound.value;
  };
  add(range.low, "minimum", "exclusiveMinimum");
  add(range.high, "maximum", "exclusiveMaximum");
}

ordered_json quantity(const Field& field) {
  ordered_json number{{"type", "number"}};
  addRange(number, field.range);
  ordered_json text{{"type", "string"}, {"pattern", quantityPattern(field.unit)}};
  return {{"anyOf", ordered_json::array({number, text})}};
}

std::string description(const Field& field) {
  std::string text = field.label;
  if (!field.symbol.empty()) text += " (" + field.symbol + ")";
  const bool measured = field.kind == Kind::Number || field.kind == Kind::Vector;
  if (measured && field.unit != "1") text += " in " + field.unit;
  if (!text.empty()) text += '.';
  if (!field.help.empty()) text.append(" ").append(field.help);
  if (!field.source.empty()) text.append(" Source: ").append(field.source);
  return text;
}

class SchemaWriter {
 public:
  ordered_json write(const Type& type, const DocumentFormat& format) {
    ordered_json root = objectOf(type, {}, type.make().get());
    ordered_json version{
        {"type", "integer"}, {"minimum", format.oldest}, {"maximum", format.newest}};
    version["description"] = "Version of the file format.";
    ordered_json properties{{format.key, std::move(version)}};
    properties.update(root["properties"]);
    ordered_json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"}};
    json["title"] = type.label;
    json.update(root);
    json["properties"] = std::move(properties);
    json["required"] = ordered_json::array({format.key});
    json["$defs"] = std::move(definitions_);
    return json;
  }

 private:
  /// A reference to the definition of a struct; `typeKey` is set for an alternative of a variant.
  /// Where a struct is part of another one that makes it with values of its own, these are its
  /// defaults and it has a definition of its own.
  ordered_json reference(const Type& type, const std::string& typeKey, const void* defaults) {
    if (type.standsAlone && defaults != nullptr) {
      const std::shared_ptr<void> own = type.make();
      if (own.get() != defaults && !ownDefaults(type, defaults).empty())
        return reference(type, typeKey, own.get());
    }
    const Definition definition{&type, typeKey, ownDefaults(type, defaults)};
    const auto [known, added] = names_.try_emplace(definition);
    if (added) {
      std::string name = typeKey.empty() ? (type.key.empty() ? "struct" : type.key) : typeKey;
      const std::string stem = name;
      for (int i = 2; definitions_.contains(name); ++i) name = stem + "-" + std::to_string(i);
      known->second = name;
      definitions_[name] = nullptr;  // taken, in case the struct contains itself
      ordered_json object = objectOf(type, typeKey, defaults);
      definitions_[name] = std::move(object);
    }
    return {{"$ref", "#/$defs/" + names_.at(definition)}};
  }
  /// A default-made struct: an element of a list, an alternative of a variant.
  ordered_json reference(const Type& type, const std::string& typeKey) {
    return reference(type, typeKey, type.make().get());
  }

  /// In what these defaults differ from those of the struct itself, as text.
  static std::string ownDefaults(const Type& type, const void* defaults) {
    const std::shared_ptr<void> made = type.make();
    std::string text;
    for (const auto& difference : schema::compare({&type, made.get()}, {&type, defaults}))
      text += difference.path + "=" + difference.right + ";";
    return text;
  }

  ordered_json objectOf(const Type& type, const std::string& typeKey, const void* defaults) {
    ordered_json json{{"type", "object"}};
    if (!type.help.empty()) json["description"] = type.help;
    ordered_json properties = ordered_json::object();
    if (!typeKey.empty()) {
      properties["type"] = {{"const", typeKey}};
      json["required"] = ordered_json::array({"type"});
    }
    for (const Field& field : type.fields) {
      ordered_json property = propertyOf(field, defaults);
      property["description"] = description(field);
      if (field.isLeaf()) addDefault(property, field.read(defaults));
      properties[field.key] = std::move(property);
    }
    for (const Field& field : type.fields) {
      if (field.required) json["required"].push_back(field.key);
    }
    json["properties"] = std::move(properties);
    json["additionalProperties"] = false;
    return json;
  }

  static void addDefault(ordered_json& property, const schema::Value& value) {
    std::visit([&](const auto& v) { property["default"] = v; }, value);
  }

  ordered_json propertyOf(const Field& field, const void* owner) {
    switch (field.kind) {
      case Kind::Number:
        return quantity(field);
      case Kind::Integer: {
        ordered_json json{{"type", "integer"}};
        addRange(json, field.range);
        return json;
      }
      case Kind::Boolean:
        return {{"type", "boolean"}};
      case Kind::Text:
        return {{"type", "string"}};
      case Kind::Choice: {
        ordered_json keys = ordered_json::array();
        for (const auto& option : field.options) keys.push_back(option.key);
        return {{"enum", std::move(keys)}};
      }
      case Kind::Vector:
        return {{"type", "array"},
                {"items", quantity(field)},
                {"minItems", field.leastSize},
                {"maxItems", field.size}};
      case Kind::Group:
        return reference(field.childType(owner, 0), {}, field.constChild(owner, 0));
      case Kind::Variant: {
        ordered_json alternatives = ordered_json::array();
        for (std::size_t i = 0; i < field.options.size(); ++i) {
          alternatives.push_back(reference(field.alternativeType(i), field.options[i].key));
        }
        if (field.untyped) alternatives.push_back(reference(field.alternativeType(0), {}));
        return {{"oneOf", std::move(alternatives)}};
      }
      case Kind::List:
        return {{"type", "array"},
                {"items", reference(field.childType(owner, 0), {})},
                {"minItems", field.minItems},
                {"maxItems", field.maxItems}};
    }
    return {};
  }

  /// Struct, key as an alternative, defaults of its own.
  using Definition = std::tuple<const Type*, std::string, std::string>;

  ordered_json definitions_ = ordered_json::object();
  std::map<Definition, std::string> names_;
};

}  // namespace

std::string jsonSchema(const Type& type, const DocumentFormat& format) {
  return SchemaWriter().write(type, format).dump(2) + "\n";
}

}  // namespace rotorbench
