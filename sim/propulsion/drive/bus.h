// The bus between a supply and the converters it feeds, at one instant. SI units; any scalar.
//   supply     b = E - R_0 i_bus,   E = OCV - v_rc: what stands behind its resistance
//   converters b i_bus = P = sum (v + R_esc i) i: each keeps the power
//   so         b^2 - E b + R_0 P = 0, whose upper root is the stable one
// battery.h has the supply, esc.h the converter with its source.
#pragma once

#include <algorithm>
#include <cmath>

namespace rotorbench {

/// W that a converter takes from the bus to put a voltage v on a motor with current i, through
/// switches of a resistance in Ohm. S may be an array with one lane per motor, as `resistance`.
template <class S, class Resistance>
[[nodiscard]] S converterPower(const S& v, const Resistance& resistance, const S& i) {
  return S((v + resistance * i) * i);
}

/// E^2 - 4 R_0 P in V^2: below 0 the supply cannot give the power P in W.
template <class S>
[[nodiscard]] S busReserve(const S& inner, const S& power, double resistance) {
  return S(inner * inner - 4.0 * resistance * power);
}

/// The bus in V with `inner` = E, under the power P in W behind R_0 in Ohm; where the supply cannot
/// give it E/2, which goes with the greatest power there is.
template <class S>
[[nodiscard]] S busVoltage(const S& inner, const S& power, double resistance) {
  using std::max;
  using std::sqrt;
  return S(0.5 * (inner + sqrt(max(busReserve(inner, power, resistance), S(0.0)))));
}

}  // namespace rotorbench
