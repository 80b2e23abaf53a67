// The members of a Box, for the source beside T's description that says `template class Box<T>;`.
#pragma once

#include "sim/core/box.h"

namespace rotorbench {

template <class T>
Box<T>::Box() : value_(new T()) {}
template <class T>
Box<T>::Box(const T& value) : value_(new T(value)) {}
template <class T>
Box<T>::Box(T&& value) : value_(new T(std::move(value))) {}
template <class T>
Box<T>::Box(const Box& other) : value_(new T(*other.value_)) {}
template <class T>
Box<T>& Box<T>::operator=(const Box& other) {
  if (this != &other) *this = Box(other);
  return *this;
}
template <class T>
Box<T>::~Box() {
  delete value_;
}
template <class T>
bool Box<T>::operator==(const Box& other) const {
  return *value_ == *other.value_;
}

}  // namespace rotorbench
