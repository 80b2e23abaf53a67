// The one description of every parameter. A parameter struct has plain members and, next to it, a
// specialisation of Describe<T> that names each member once: key, label, symbol, unit, display
// unit, range, help, source. Reading and writing files, JSON Schema, forms, `--set path=value`,
// sweeps and the help tables are all made from that description; nothing else lists parameters.
//
//   struct MotorParameters { double resistance = 0.117; ... bool operator==(...) const = default;
//     };
//   template <> struct Describe<MotorParameters> {
//     static void fields(schema::Builder<MotorParameters>& b) {
//       b.title("motor", "Motor", "A direct-current machine ...");
//       b.number("resistance", &MotorParameters::resistance, "Phase resistance", "R", "Ohm")
//           .range(schema::above(0), schema::upTo(100)).help("...").source("DJI E305 ...");
//     }
//   };
//
// Paths: members joined by dots, list elements by index: "vehicle.rotors[2].motor.resistance". The
// chosen alternative of a variant is transparent ("controller.roll.kp"); its name is
// "controller.type".
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/core/error.h"

namespace rotorbench::schema {

enum class Kind { Number, Integer, Boolean, Text, Choice, Vector, Group, Variant, List };

/// The value of one leaf parameter, SI units. Choice and the "type" of a variant are their key
/// text.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// Allowed numbers; an open end excludes the bound itself. NaN and infinity are never allowed.
struct Bound {
  double value;
  bool open;
};
inline Bound above(double v) {
  return {v, true};
}
inline Bound atLeast(double v) {
  return {v, false};
}
inline Bound below(double v) {
  return {v, true};
}
inline Bound upTo(double v) {
  return {v, false};
}

struct Range {
  Bound low{-std::numeric_limits<double>::infinity(), true};
  Bound high{std::numeric_limits<double>::infinity(), true};
  [[nodiscard]] bool contains(double v) const;
  /// "above 0 and at most 10 m", in the unit given (bounds are converted from SI).
  [[nodiscard]] std::string sentence(std::string_view siUnit, std::string_view shownUnit) const;
};

/// One value of a choice: what files hold, what a person reads, what it means.
struct Option {
  std::string key;
  std::string label;
  std::string help;
  std::vector<std::string> formerKeys{};  ///< read, never written
};

/// The index of the option named `key`, now or formerly; nothing if there is none.
std::optional<std::size_t> optionNamed(const std::vector<Option>& options, std::string_view key);

class Type;

/// What a string holds, so that an editor can offer the right tool.
enum class TextRole { Line, Paragraph, FilePath, Channels };

/// One described member. Access functions take the address of the owning struct; which of them are
/// set depends on the kind.
struct Field {
  std::string key, label, symbol, help, source;
  Kind kind = Kind::Number;
  std::string unit = "1";         ///< SI unit of the stored value
  std::string displayUnit = "1";  ///< unit a form shows first
  Range range;                    ///< Number, Integer, Vector components
  std::size_t size = 0;           ///< Vector: number of components, at most
  std::size_t leastSize = 0;      ///< Vector: at least; below `size` where the number is free
  std::vector<std::string> componentNames;  ///< Vector: "x", "y", "z"
  std::vector<Option> options;              ///< Choice; Variant: one per alternative
  TextRole role = TextRole::Line;           ///< Text
  std::size_t minItems = 0, maxItems = 0;   ///< List
  bool asTable = false;                     ///< List of plain rows, edited as a table
  bool untyped = false;   ///< Variant: a file may leave its type out, meaning the first
  bool advanced = false;  ///< shown behind "more" in a form
  bool required = false;  ///< of a struct that stands alone: a file must give it
  bool live = false;      ///< of a flight, may be changed while it goes on (document/changes.h)

  /// Number, Integer, Boolean, Text, Choice, Vector.
  std::function<Value(const void* owner)> read;
  /// Takes a value of the right alternative (Integer also for Number); the range is not checked
  /// here.
  std::function<void(void* owner, const Value&)> write;

  /// Group: the nested struct. Variant: the chosen alternative. List: element `index`.
  std::function<const Type&(const void* owner, std::size_t index)> childType;
  std::function<void*(void* owner, std::size_t index)> child;

  std::function<std::size_t(const void* owner)> chosen;  ///< Variant: index into options
  std::function<void(void* owner, std::size_t option)>
      choose;  ///< Variant: default-made alternative
  std::function<const Type&(std::size_t option)> alternativeType;  ///< Variant

  std::function<std::size_t(const void* owner)> count;        ///< List
  std::function<void(void* owner, std::size_t)> resize;       ///< List: new elements default-made
  std::function<void(void* owner, std::size_t index)> erase;  ///< List
  std::function<void(void* owner, std::size_t index)>
      insert;  ///< List: default-made element before index

  [[nodiscard]] const void* constChild(const void* owner, std::size_t index) const {
    return child(const_cast<void*>(owner), index);
  }
  [[nodiscard]] bool isLeaf() const { return kind < Kind::Group; }
  /// "4", or "4 to 8" where the number of components is free.
  [[nodiscard]] std::string sizeText() const;
};

/// One described struct. There is exactly one Type per struct, made on first use; it never changes.
class Type {
 public:
  std::string key, label, help, source;
  std::vector<std::string> formerKeys;  ///< of the key
  /// Where older files have a member of this struct: the path below the struct, and its key.
  struct Moved {
    std::string from, key;
  };
  std::vector<Moved> moved;
  std::vector<Field> fields;
  /// A rule over several members of this struct; the path of a problem is relative to the struct.
  std::vector<std::function<void(const void* object, std::vector<Problem>&)>> checks;
  /// Members whose shape follows from others of the struct (as many inputs as rotors). Whoever
  /// edits by hand lets them follow; a file must say what it means.
  struct Follower {
    std::function<bool(const void* object)> fits;
    std::string
        field;  ///< path below the struct: a list, a group or a variant that follow() changes
    std::function<void(void* object)> follow;
  };
  std::vector<Follower> followers;
  /// Where a file describes this struct, what it leaves out is the struct's own default, whatever
  /// the surroundings have there: a motor that is described has no figure of the default vehicle's.
  bool standsAlone = false;
  /// A default-made object of this struct.
  std::function<std::shared_ptr<void>()> make;

  [[nodiscard]] const Field* field(std::string_view key) const;
};

/// A struct and its description, seen through one pair of pointers.
struct Ref {
  const Type* type = nullptr;
  void* object = nullptr;
};
struct ConstRef {
  const Type* type = nullptr;
  const void* object = nullptr;
  ConstRef() = default;
  ConstRef(const Type* t, const void* o) : type(t), object(o) {}
  ConstRef(const Ref& r) : type(r.type), object(r.object) {}  // NOLINT: a Ref is a ConstRef
};

}  // namespace rotorbench::schema

namespace rotorbench {

/// Specialised next to each parameter struct: `static void fields(schema::Builder<T>&)`.
template <class T>
struct Describe;

}  // namespace rotorbench

#include "sim/core/schema_builder.h"
