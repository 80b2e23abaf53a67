// The bus between a supply and the converters it feeds, at one instant. SI units; any scalar.
//   supply     b = E - R_0 i_bus,   E = OCV - v_rc: what stands behind its resistance
//   converters b i_bus = P = sum (v + R_esc i) i: each keeps the power
//   so         b^2 - E b + R_0 P = 0, whose upper root is the stable one
// Converters that keep their duties d instead take i_bus = sum d i whatever b is, and can draw the
// bus below E/2 and down to 0, where the diodes of their bridges carry what the supply does not.
// battery.h has the supply, esc.h the converter with its source.
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/core/scalar.h"

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

/// Whether the bus of converters that draw a power in W, `bus` V with all duties kept, is on the
/// upper root.
[[nodiscard]] inline bool isStrongBus(double bus, double inner, double power, double resistance) {
  return inner > 0 && 2 * bus >= inner && busReserve(inner, power, resistance) >= 0;
}

/// Voltage in V and current in A of the supply.
template <class S>
struct BusPoint {
  S voltage, current;
};

/// The supply at 0 V.
template <class S>
[[nodiscard]] BusPoint<S> emptyBus(const S& inner, double resistance) {
  // What is no number stays one.
  const bool flows = resistance > 0 && !(valueOf(inner) <= 0);
  return {S(0.0), flows ? S(inner / resistance) : S(0.0)};
}

/// The highest voltage of a bus whose converters take drawn(b) A at b V, b above 0, and less of it
/// the higher b is; drawn() is called last with what holds.
template <class S, class Drawn>
[[nodiscard]] BusPoint<S> loadedBus(const S& inner, double resistance, const Drawn& drawn) {
  constexpr int kMostRounds = 60;
  constexpr double kClose = 1e-13;
  S bus = inner;
  for (int round = 0; round < kMostRounds && !(valueOf(bus) <= 0); ++round) {
    const S current = drawn(bus), next = S(inner - resistance * current);
    const double change = std::abs(valueOf(next) - valueOf(bus));
    bus = next;
    const bool settled = !(change > kClose * valueOf(inner)) || round + 1 == kMostRounds;
    if (settled && !(valueOf(bus) <= 0)) return {bus, current};
  }
  return emptyBus(inner, resistance);
}

}  // namespace rotorbench
