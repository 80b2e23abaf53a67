// The inflow of several annuli side by side, in single precision: momentum_inflow.h and
// inflow_root.h for loops that the compiler turns into vector code. No branch depends on a lane;
// what a lane does not need it works out all the same.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "sim/propulsion/rotor/inflow_root.h"
#include "sim/propulsion/rotor/momentum_inflow.h"

namespace rotorbench {

inline constexpr int kFloatLanes = 4;  ///< what every processor of ours has room for
using FloatLanes [[gnu::vector_size(16)]] = float;
using FloatMask [[gnu::vector_size(16)]] = std::int32_t;  ///< -1 where a comparison holds

namespace lane {

inline constexpr float kTiny = 1e-30F;

inline FloatLanes all(float x) {
  return FloatLanes{} + x;
}
inline FloatLanes least(FloatLanes a, FloatLanes b) {
  return a < b ? a : b;
}
inline FloatLanes most(FloatLanes a, FloatLanes b) {
  return a > b ? a : b;
}
inline FloatLanes size(FloatLanes x) {
  return reinterpret_cast<FloatLanes>(reinterpret_cast<FloatMask>(x) & 0x7FFFFFFF);
}
inline FloatLanes root(FloatLanes x) {
  FloatLanes r;
  for (int l = 0; l < kFloatLanes; ++l) r[l] = std::sqrt(x[l]);
  return r;
}
inline bool any(FloatMask b) {
  std::int32_t all = 0;
  for (int l = 0; l < kFloatLanes; ++l) all |= b[l];
  return all != 0;
}

/// Four numbers from each of four places, the first ones in out[0] and so on.
inline void gather(const std::array<const float*, kFloatLanes>& places, FloatLanes (&out)[4]) {
  FloatLanes r[kFloatLanes];
  for (std::size_t l = 0; l < kFloatLanes; ++l) std::memcpy(&r[l], places[l], sizeof r[l]);
  const FloatLanes a = __builtin_shufflevector(r[0], r[1], 0, 4, 1, 5),
                   b = __builtin_shufflevector(r[2], r[3], 0, 4, 1, 5),
                   c = __builtin_shufflevector(r[0], r[1], 2, 6, 3, 7),
                   d = __builtin_shufflevector(r[2], r[3], 2, 6, 3, 7);
  out[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
  out[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
  out[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
  out[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}

/// e^x for x from -80 to 0, to 2e-7 of it.
inline FloatLanes expDown(FloatLanes x) {
  constexpr float kLog2 = 1.44269504F, kHigh = 0.693359375F, kLow = -2.12194440e-4F;
  const FloatMask n = __builtin_convertvector(x * kLog2 - 0.5F, FloatMask);
  const FloatLanes k = __builtin_convertvector(n, FloatLanes), r = x - k * kHigh - k * kLow;
  const FloatLanes p =
      1.F + r * (1.F + r * (1.F / 2 +
                            r * (1.F / 6 + r * (1.F / 24 + r * (1.F / 120 + r * (1.F / 720))))));
  return p * reinterpret_cast<FloatLanes>((n + 127) << 23);
}

/// ln(1 + e^x).
inline FloatLanes softplus(FloatLanes x) {
  const FloatLanes y = expDown(-least(size(x), all(80))), z = y / (2.F + y), s = z * z;
  const FloatLanes log =
      2.F * z *
      (1.F + s * (1.F / 3 + s * (1.F / 5 + s * (1.F / 7 + s * (1.F / 9 + s * (1.F / 11))))));
  return most(x, FloatLanes{}) + log;
}

/// 1/(1 + e^-x).
inline FloatLanes logistic(FloatLanes x) {
  const FloatLanes y = expDown(-least(size(x), all(80))), part = 1.F / (1.F + y);
  return x > 0.F ? part : y * part;
}

/// swirlOf() of blade_element.cpp, `turning` not negative.
inline FloatLanes swirl(FloatLanes induced, FloatLanes axialStream, FloatLanes turning) {
  const FloatLanes square = turning * turning;
  const FloatLanes product = least(4.F * induced * (axialStream + induced), square);
  const FloatLanes taken = product / (turning + root(square - product) + kTiny);
  const FloatLanes limited = taken * turning / root(taken * taken + square + kTiny);
  return 0.5F * (taken > 0.F ? taken : limited);
}

/// inducedVelocity(), the in-plane speed above 0. All speeds of the order of 1.
inline FloatLanes momentum(FloatLanes hover, FloatLanes axialStream, FloatLanes inPlane) {
  constexpr float kLeast = 1e-20F;
  const FloatLanes h = most(size(hover), all(kLeast)),
                   axial = hover < 0.F ? -axialStream : axialStream;
  const FloatLanes q = root(h), inverse = 1.F / q;
  const FloatLanes x = axial * inverse, m = inPlane * inverse, half = 0.5F * size(x);
  const FloatLanes square = half * half, one = all(1), none = all(0);
  // Climb and slow descent; windmill brake state; the cubic between them.
  const FloatLanes far = half + root(square + 1.F);
  const FloatLanes brake = 1.F / (half + root(most(square - 1.F, none)));
  const FloatLanes climb = x > 0.F ? 1.F / far : far;
  constexpr float kBottom = static_cast<float>(kRingBottom), kTop = static_cast<float>(kRingTop);
  const FloatLanes t = least(most(x - kBottom, none), one), s = 1.F - t;
  const FloatLanes ring = (0.5F + t + t / 3.F) * s * s + t * t * (6.F - 4.F * t + 0.8F * s);
  const FloatLanes upper = x >= kTop ? climb : ring;
  const FloatLanes top = x <= kBottom ? brake : upper;
  const FloatLanes slope = 2.F * t * t * (3.F - 2.F * t) - 1.F, atTop = 1.F / top, across = m * m;
  // Halley's method for w^2 (m^2 + through^2) = 1, which needs no root.
  FloatLanes w = 1.F / root(across + atTop * atTop);
  constexpr int kSteps = 3;
  for (int i = 0; i < kSteps; ++i) {
    const FloatLanes through = atTop + slope * (w - top), fast = across + through * through;
    const FloatLanes bend = w * through * slope, f = w * w * fast - 1.F;
    const FloatLanes first = 2.F * w * (fast + bend);
    const FloatLanes second = 2.F * fast + 8.F * bend + 2.F * w * w * slope * slope;
    const FloatLanes next = w - 2.F * f * first / (2.F * first * first - f * second);
    w = least(next > 0.F ? next : 0.5F * w, top);
  }
  const FloatLanes v = w * q;
  return hover < 0.F ? -v : v;
}

}  // namespace lane

}  // namespace rotorbench
