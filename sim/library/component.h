// A component: one motor, battery, propeller, airframe ... with its name and where its numbers are
// from, kept apart from any experiment. The value is a plain described struct of the room that
// computes with it; which structs are components, and what they are called, is one table:
// componentKinds(). Values are SI.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench {

/// What a person reads about a component.
struct ComponentInfo {
  std::string name;
  std::string summary;  ///< what it is, one or two sentences
  std::string source;   ///< where the numbers are from, and how they were got from there
  std::string
      warning;  ///< what must be known before use: implausible or assumed values; may be empty
  bool operator==(const ComponentInfo&) const = default;
};

/// A component of any kind. Copies share the value: whoever wants another one makes another
/// component.
struct Component {
  ComponentInfo info;
  const schema::Type* type = nullptr;  ///< of `value`, one of componentKinds()
  std::shared_ptr<void> value;

  [[nodiscard]] schema::ConstRef ref() const { return {type, value.get()}; }
  /// The value as what it is, or null if it is of another kind.
  template <class T>
  [[nodiscard]] const T* as() const {
    return type == &schema::typeOf<T>() ? static_cast<const T*>(value.get()) : nullptr;
  }
};

template <class T>
Component makeComponent(ComponentInfo info, T value) {
  return {std::move(info), &schema::typeOf<T>(), std::make_shared<T>(std::move(value))};
}

/// As above for a struct of which only the type is known; the value is copied.
Component makeComponent(ComponentInfo info, schema::ConstRef value);

/// One kind of component.
struct ComponentKind {
  std::string key;     ///< in files: "motor"
  std::string label;   ///< for people: "Motor"
  std::string folder;  ///< of the library: "motors"
  const schema::Type* type;
  /// Paths of the leaves that tell components of this kind apart, most telling first. Those of an
  /// alternative that is not chosen are left out where they are shown.
  std::vector<std::string> keyFigures;

  /// Text of a component file of this kind and back; see component_file.h.
  std::function<std::string(const Component&)> write;
  std::function<Component(std::string_view text, const std::string& source)> read;
};

/// All kinds, in the order they are shown. Adding one is one line.
const std::vector<ComponentKind>& componentKinds();

/// The kind of a described struct or of a key; null if there is none.
const ComponentKind* kindOf(const schema::Type& type);
const ComponentKind* kindOf(std::string_view key);

template <>
struct Describe<ComponentInfo> {
  static void fields(schema::Builder<ComponentInfo>& b);
};

}  // namespace rotorbench
