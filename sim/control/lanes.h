// Controllers side by side: their equations are written once, over a number (Real is double) or
// over an Eigen::Array with one lane for each of several controllers, which a processor works
// through two at a time. Every lane gives the bits that the number alone would give.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <type_traits>

namespace rotorbench {

template <int N>
using Lanes = Eigen::Array<double, N, 1>;

/// std::clamp; lane by lane.
inline double clamped(double v, double low, double high) {
  return std::clamp(v, low, high);
}
template <int N>
Lanes<N> clamped(const Lanes<N>& v, const Lanes<N>& low, const Lanes<N>& high) {
  Lanes<N> result;
  for (int i = 0; i < N; ++i) result[i] = v[i] < low[i] ? low[i] : high[i] < v[i] ? high[i] : v[i];
  return result;
}

/// All lanes alike.
template <class Real>
Real allLanes(double value) {
  if constexpr (std::is_same_v<Real, double>) {
    return value;
  } else {
    return Real::Constant(value);
  }
}

/// `value` where `condition` is not 0, else 0; lane by lane.
inline double whereNot0(double condition, double value) {
  return condition != 0 ? value : 0;
}
template <int N>
Lanes<N> whereNot0(const Lanes<N>& condition, const Lanes<N>& value) {
  return (condition != 0).select(value, Lanes<N>::Zero());
}

inline bool differ(double a, double b) {
  return a != b;
}
template <int N>
bool differ(const Lanes<N>& a, const Lanes<N>& b) {
  return (a != b).any();
}

}  // namespace rotorbench
