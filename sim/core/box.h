// A value kept elsewhere: Box<T> copies, compares and moves like T, but a header that holds one
// only names T. What is in the box can then change without the headers around it being compiled
// again: the kinds of an experiment, the controllers of a flight.
//
//   flight.h:               struct ControlledInputs;
//                           extern template class Box<ControlledInputs>;
//                           ... std::variant<Box<ControlledInputs>, SpeedInputs> control;
//   controlled_inputs.cpp:  #include "sim/core/box_members.h"
//                           template class Box<ControlledInputs>;
//
// alternative<T>() and friends look into a variant without asking which alternatives are boxed.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

namespace rotorbench {

/// Owns one T. Members are defined in box_members.h, for the one source that instantiates them. A
/// box that was moved from may only be assigned to or destroyed.
template <class T>
class Box {
 public:
  Box();
  Box(const T& value);  // NOLINT: a value stands where its box is asked for
  Box(T&& value);       // NOLINT
  Box(const Box& other);
  Box(Box&& other) noexcept : value_(std::exchange(other.value_, nullptr)) {}
  Box& operator=(const Box& other);
  Box& operator=(Box&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Box();

  [[nodiscard]] T& operator*() { return *value_; }
  [[nodiscard]] const T& operator*() const { return *value_; }
  [[nodiscard]] T* operator->() { return value_; }
  [[nodiscard]] const T* operator->() const { return value_; }

  bool operator==(const Box& other) const;

 private:
  T* value_;
};

template <class T>
struct Unboxed {
  using Type = T;
};
template <class T>
struct Unboxed<Box<T>> {
  using Type = T;
};

template <class T>
T& unboxed(T& value) {
  return value;
}
template <class T>
T& unboxed(Box<T>& box) {
  return *box;
}
template <class T>
const T& unboxed(const Box<T>& box) {
  return *box;
}

namespace detail {

/// T itself where it is an alternative, else its box.
template <class T, class... A>
using Held = std::conditional_t<(std::is_same_v<T, A> || ...), T, Box<T>>;

}  // namespace detail

/// std::get of an alternative that may be boxed. Throws std::bad_variant_access.
template <class T, class... A>
T& alternative(std::variant<A...>& variant) {
  return unboxed(std::get<detail::Held<T, A...>>(variant));
}
template <class T, class... A>
const T& alternative(const std::variant<A...>& variant) {
  return unboxed(std::get<detail::Held<T, A...>>(variant));
}

/// std::get_if of an alternative that may be boxed.
template <class T, class... A>
T* alternativeIf(std::variant<A...>& variant) {
  auto* held = std::get_if<detail::Held<T, A...>>(&variant);
  return held == nullptr ? nullptr : &unboxed(*held);
}
template <class T, class... A>
const T* alternativeIf(const std::variant<A...>& variant) {
  const auto* held = std::get_if<detail::Held<T, A...>>(&variant);
  return held == nullptr ? nullptr : &unboxed(*held);
}

template <class T, class... A>
bool holdsAlternative(const std::variant<A...>& variant) {
  return std::holds_alternative<detail::Held<T, A...>>(variant);
}

/// std::visit of one variant, with what is in a box instead of the box.
template <class Visitor, class Variant>
decltype(auto) visitAlternative(Visitor&& visitor, Variant&& variant) {
  return std::visit([&](auto& held) -> decltype(auto) { return visitor(unboxed(held)); }, variant);
}

}  // namespace rotorbench
