// How a Describe<T> names its members: the fluent builder behind schema.h. Include schema.h, not
// this.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>

#include "sim/core/box.h"
#include "sim/core/schema.h"

namespace rotorbench::schema {

template <class T>
const Type& typeOf();

template <class T>
Ref ref(T& object) {
  return {&typeOf<T>(), &object};
}
template <class T>
ConstRef ref(const T& object) {
  return {&typeOf<T>(), &object};
}

/// Sets the finer points of the field just added. Every call returns *this.
class FieldBuilder {
 public:
  explicit FieldBuilder(Field& field) : field_(&field) {}
  FieldBuilder& range(Bound low, Bound high) { return field_->range = {low, high}, *this; }
  FieldBuilder& positive() { return field_->range.low = above(0), *this; }
  FieldBuilder& notNegative() { return field_->range.low = atLeast(0), *this; }
  /// The unit a form shows first; must convert to the stored SI unit.
  FieldBuilder& shownIn(std::string unit) { return field_->displayUnit = std::move(unit), *this; }
  FieldBuilder& help(std::string text) { return field_->help = std::move(text), *this; }
  FieldBuilder& source(std::string text) { return field_->source = std::move(text), *this; }
  FieldBuilder& role(TextRole role) { return field_->role = role, *this; }
  FieldBuilder& components(std::vector<std::string> names) {
    return field_->componentNames = std::move(names), *this;
  }
  FieldBuilder& items(std::size_t least, std::size_t most) {
    return field_->minItems = least, field_->maxItems = most, *this;
  }
  FieldBuilder& table() { return field_->asTable = true, *this; }
  /// What was a group before it became a variant: files without a type mean the first alternative.
  FieldBuilder& untyped() { return field_->untyped = true, *this; }
  FieldBuilder& advanced() { return field_->advanced = true, *this; }
  /// No value is neutral: a file that describes the struct, which must stand alone, gives it.
  FieldBuilder& required() { return field_->required = true, *this; }
  /// Whoever uses the member takes a new value while a flight goes on.
  FieldBuilder& live() { return field_->live = true, *this; }

 private:
  Field* field_;
};

/// An enumerator with its option, for Builder::choice.
template <class E>
struct Named {
  E value;
  std::string key, label, help;
};

template <class T>
class Builder {
 public:
  explicit Builder(Type& type) : type_(type) {}

  /// The struct's own key (its name as an alternative of a variant), label, help and source.
  void title(std::string key, std::string label, std::string help, std::string source = {}) {
    type_.key = std::move(key);
    type_.label = std::move(label);
    type_.help = std::move(help);
    type_.source = std::move(source);
  }

  /// See Type::standsAlone.
  void standsAlone() { type_.standsAlone = true; }

  /// What files called this struct, as an alternative of a variant, before it had its key.
  void formerly(std::string key) { type_.formerKeys.push_back(std::move(key)); }
  /// Files used to have the member `key` at the path `from`, seen from this struct.
  void moved(std::string from, std::string key) {
    type_.moved.push_back({std::move(from), std::move(key)});
  }

  /// `unit` is the SI unit of the stored number.
  FieldBuilder number(std::string key, double T::*member, std::string label, std::string symbol,
                      std::string unit) {
    Field& f = add(Kind::Number, std::move(key), std::move(label), std::move(symbol));
    f.unit = f.displayUnit = std::move(unit);
    f.read = [member](const void* o) { return Value{self(o).*member}; };
    f.write = [member](void* o, const Value& v) {
      self(o).*member = std::holds_alternative<std::int64_t>(v)
                            ? static_cast<double>(std::get<std::int64_t>(v))
                            : std::get<double>(v);
    };
    return FieldBuilder(f);
  }

  template <class I>
  requires(std::is_integral_v<I> && !std::is_same_v<I, bool>) FieldBuilder
      integer(std::string key, I T::*member, std::string label, std::string symbol = {}) {
    Field& f = add(Kind::Integer, std::move(key), std::move(label), std::move(symbol));
    // 2^53: the largest integers every JSON reader keeps exact; or what the member can hold.
    constexpr double kExact = 9007199254740992.0;
    f.range = {atLeast(std::max(-kExact, static_cast<double>(std::numeric_limits<I>::min()))),
               upTo(std::min(kExact, static_cast<double>(std::numeric_limits<I>::max())))};
    f.read = [member](const void* o) { return Value{static_cast<std::int64_t>(self(o).*member)}; };
    f.write = [member](void* o, const Value& v) {
      self(o).*member = static_cast<I>(std::get<std::int64_t>(v));
    };
    return FieldBuilder(f);
  }

  FieldBuilder boolean(std::string key, bool T::*member, std::string label) {
    Field& f = add(Kind::Boolean, std::move(key), std::move(label), {});
    f.read = [member](const void* o) { return Value{self(o).*member}; };
    f.write = [member](void* o, const Value& v) { self(o).*member = std::get<bool>(v); };
    return FieldBuilder(f);
  }

  FieldBuilder text(std::string key, std::string T::*member, std::string label) {
    Field& f = add(Kind::Text, std::move(key), std::move(label), {});
    f.read = [member](const void* o) { return Value{self(o).*member}; };
    f.write = [member](void* o, const Value& v) { self(o).*member = std::get<std::string>(v); };
    return FieldBuilder(f);
  }

  template <class E>
  requires std::is_enum_v<E> FieldBuilder choice(std::string key, E T::*member, std::string label,
                                                 std::vector<Named<E>> named) {
    Field& f = add(Kind::Choice, std::move(key), std::move(label), {});
    for (const auto& n : named) f.options.push_back({n.key, n.label, n.help});
    f.read = [member, named](const void* o) {
      for (const auto& n : named) {
        if (n.value == self(o).*member) return Value{n.key};
      }
      return Value{std::string()};
    };
    f.write = [member, named](void* o, const Value& v) {
      for (const auto& n : named) {
        if (n.key == std::get<std::string>(v)) self(o).*member = n.value;
      }
    };
    return FieldBuilder(f);
  }

  /// A fixed-size Eigen column vector, one unit for all components.
  template <int N>
  FieldBuilder vector(std::string key, Eigen::Matrix<double, N, 1> T::*member, std::string label,
                      std::string symbol, std::string unit) {
    static_assert(N > 0);
    Field& f = add(Kind::Vector, std::move(key), std::move(label), std::move(symbol));
    f.unit = f.displayUnit = std::move(unit);
    f.size = f.leastSize = N;
    f.componentNames = {"x", "y", "z"};
    f.componentNames.resize(N);
    f.read = [member](const void* o) {
      const auto& v = self(o).*member;
      return Value{std::vector<double>(v.data(), v.data() + N)};
    };
    f.write = [member](void* o, const Value& value) {
      const auto& v = std::get<std::vector<double>>(value);
      for (int i = 0; i < N; ++i) (self(o).*member)[i] = v[static_cast<std::size_t>(i)];
    };
    return FieldBuilder(f);
  }

  /// A vector of as many components as its owner needs, from `least` to `most`, named by their
  /// numbers from 1; one unit for all.
  FieldBuilder vector(std::string key, std::vector<double> T::*member, std::size_t least,
                      std::size_t most, std::string label, std::string symbol, std::string unit) {
    Field& f = add(Kind::Vector, std::move(key), std::move(label), std::move(symbol));
    f.unit = f.displayUnit = std::move(unit);
    f.leastSize = least;
    f.size = most;
    for (std::size_t i = 1; i <= most; ++i) f.componentNames.push_back(std::to_string(i));
    f.read = [member](const void* o) { return Value{self(o).*member}; };
    f.write = [member](void* o, const Value& value) {
      self(o).*member = std::get<std::vector<double>>(value);
    };
    return FieldBuilder(f);
  }

  /// A nested described struct.
  template <class G>
  FieldBuilder group(std::string key, G T::*member, std::string label) {
    Field& f = add(Kind::Group, std::move(key), std::move(label), {});
    f.childType = [](const void*, std::size_t) -> const Type& { return typeOf<G>(); };
    f.child = [member](void* o, std::size_t) -> void* { return &(self(o).*member); };
    return FieldBuilder(f);
  }

  /// Exactly one of several described structs, boxed or not; their title() keys name them.
  template <class... A>
  FieldBuilder variant(std::string key, std::variant<A...> T::*member, std::string label) {
    using V = std::variant<A...>;
    Field& f = add(Kind::Variant, std::move(key), std::move(label), {});
    static constexpr std::array<const Type& (*)(), sizeof...(A)> kTypes{
        &typeOf<typename Unboxed<A>::Type>...};
    static constexpr std::array<void (*)(V&), sizeof...(A)> kMake{+[](V& v) { v = A{}; }...};
    for (const auto& t : kTypes) {
      f.options.push_back({t().key, t().label, t().help, t().formerKeys});
    }
    f.chosen = [member](const void* o) { return (self(o).*member).index(); };
    f.choose = [member](void* o, std::size_t i) {
      if ((self(o).*member).index() != i) kMake.at(i)(self(o).*member);
    };
    f.alternativeType = [](std::size_t i) -> const Type& { return kTypes.at(i)(); };
    f.childType = [member](const void* o, std::size_t) -> const Type& {
      return kTypes.at((self(o).*member).index())();
    };
    f.child = [member](void* o, std::size_t) -> void* {
      return std::visit([](auto& a) -> void* { return &unboxed(a); }, self(o).*member);
    };
    return FieldBuilder(f);
  }

  /// Any number of described structs.
  template <class E>
  FieldBuilder list(std::string key, std::vector<E> T::*member, std::string label) {
    Field& f = add(Kind::List, std::move(key), std::move(label), {});
    f.maxItems = 100000;
    f.childType = [](const void*, std::size_t) -> const Type& { return typeOf<E>(); };
    f.child = [member](void* o, std::size_t i) -> void* { return &(self(o).*member).at(i); };
    f.count = [member](const void* o) { return (self(o).*member).size(); };
    f.resize = [member](void* o, std::size_t n) { (self(o).*member).resize(n); };
    f.erase = [member](void* o, std::size_t i) {
      auto& v = self(o).*member;
      v.erase(v.begin() + static_cast<std::ptrdiff_t>(i));
    };
    f.insert = [member](void* o, std::size_t i) {
      auto& v = self(o).*member;
      v.insert(v.begin() + static_cast<std::ptrdiff_t>(i), E{});
    };
    return FieldBuilder(f);
  }

  /// `follow(object)` changes the member at the path `field`, a list, a group or a variant, so that
  /// `fits(object)` holds.
  void follows(std::string field, std::function<bool(const T&)> fits,
               std::function<void(T&)> follow) {
    type_.followers.push_back({[fits = std::move(fits)](const void* o) { return fits(self(o)); },
                               std::move(field),
                               [follow = std::move(follow)](void* o) { follow(self(o)); }});
  }

  /// A rule over several members: `rule(object, problems)` appends a Problem whose path is relative
  /// to the struct ("inertia.xx").
  void check(std::function<void(const T&, std::vector<Problem>&)> rule) {
    type_.checks.push_back([rule = std::move(rule)](const void* o, std::vector<Problem>& problems) {
      rule(self(o), problems);
    });
  }

 private:
  static T& self(void* o) { return *static_cast<T*>(o); }
  static const T& self(const void* o) { return *static_cast<const T*>(o); }

  Field& add(Kind kind, std::string key, std::string label, std::string symbol) {
    Field& f = type_.fields.emplace_back();
    f.kind = kind;
    f.key = std::move(key);
    f.label = std::move(label);
    f.symbol = std::move(symbol);
    return f;
  }

  Type& type_;
};

template <class T>
const Type& typeOf() {
  static const Type type = [] {
    Type t;
    Builder<T> builder(t);
    Describe<T>::fields(builder);
    t.make = [] { return std::static_pointer_cast<void>(std::make_shared<T>()); };
    return t;
  }();
  return type;
}

}  // namespace rotorbench::schema
