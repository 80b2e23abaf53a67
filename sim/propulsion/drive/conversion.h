// What a converter of a real speed controller does beside sharing the voltage, at one instant: the
// ripple of the current, what chopping costs, the leads. SI units; any scalar.
//   V bus, d duty, i motor current, e back-EMF, R winding and switches, L inductance, f frequency
// Ripple. While the switch is on the current rises by D = (V - v) d/(L f), v the mean voltage at
// the motor. Where the other half of the bridge is a diode the current cannot turn round: below
// d (1 - d) V/(2 L f) it stops in every period, and the open motor shows its back-EMF for the rest
// of it. The mean current the diode leaves is then
//   h = d^2 V (V - v)/(2 L f v),   v = e + R h
// and v the voltage of the mean: more than d V. With s = d V/v, the part of a period in which
// current flows, its mean square exceeds the square of its mean by D^2 (s/3 - s^2/4), D^2/12 where
// it flows always. In periods long against L/R all of this is too much: h stays below d (V - e)/R,
// and the heat of the ripple below V^2 d (1 - d)/R, of a current that follows the switch at once.
//   R. W. Erickson, D. Maksimovic, Fundamentals of Power Electronics, chapter 5
// Switching and commutating cost k_s V |i| while the voltage is chopped and nothing at full duty:
// k_s V |i| (1 - d^2). The rise and fall of a switch cost in proportion to V i, so does the current
// that changes from phase to phase; k_s is found on a stand.
// Leads carry d i: R_l (d i)^2.
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/core/scalar.h"
#include "sim/propulsion/drive/esc.h"

namespace rotorbench {

template <class S>
struct Conversion {
  S duty{};     ///< share of the bus the motor gets, its way; more than asked for at little current
  S chopped{};  ///< A from the bus beside duty times current, whatever the bus
  S perVoltage{};  ///< A from the bus for each volt of it: the heat of the ripple
};

/// The current in A that a diode leaves of a duty d, 0..1, at a back-EMF and a bus in V.
template <class S>
[[nodiscard]] S interruptedCurrent(const EscConstants& esc, const S& d, const S& back,
                                   const S& bus) {
  using std::min;
  using std::sqrt;
  const S k = S(esc.ripple * d * d * bus);
  const S c = S(k * (bus - back));
  if (!(valueOf(c) > 0)) return S(0);
  const S b = S(2.0 * back + k * esc.pathResistance);
  const S held = S(2.0 * c / (b + sqrt(S(b * b + 8.0 * esc.pathResistance * c))));
  return min(held, S(d * (bus - back) / esc.pathResistance));
}

/// What the speed controller makes of a duty at a motor current in A, a back-EMF and a bus in V.
template <class S>
[[nodiscard]] Conversion<S> conversion(const EscConstants& esc, const S& duty, const S& current,
                                       const S& back, const S& bus) {
  using std::abs;
  using std::max;
  using std::min;
  const double way = valueOf(duty) < 0 ? -1 : 1;
  const S d = S(way * duty);
  S share = d;
  if (!esc.activeBraking && esc.ripple > 0 && valueOf(d) > 0 && valueOf(bus) > 0) {
    const S mean = S(way * back);
    const S held = S((mean + esc.pathResistance * interruptedCurrent(esc, d, mean, bus)) / bus);
    share = min(S(max(d, held)), S(max(d, S(1.0))));
  }
  Conversion<S> c;
  c.duty = S(way * share);
  c.chopped = S(esc.switchingLoss * abs(current) * max(S(1.0 - share * share), S(0.0)));
  if (esc.ripple > 0 && valueOf(share) > 0) {
    const S flows = S(d / share);
    const S swing = S((1.0 - share) * d * esc.ripple);
    c.perVoltage = min(S(esc.pathResistance * swing * swing * (flows / 3.0 - 0.25 * flows * flows)),
                       S(d * max(S(1.0 - d), S(0.0)) / esc.pathResistance));
  }
  return c;
}

/// W from the bus beside what goes through the switches to the motor. V bus, A motor current.
template <class S>
[[nodiscard]] S conversionLoss(const EscConstants& esc, const Conversion<S>& c, const S& current,
                               const S& bus) {
  const S drawn = S(c.duty * current);
  return S(esc.leadResistance * drawn * drawn + (c.chopped + c.perVoltage * bus) * bus);
}

/// The duty to ask for so that the motor gets the share `share`, 0..1, of the bus in V at a current
/// in A: less where the current is interrupted.
[[nodiscard]] inline double dutyForShare(const EscConstants& esc, double share, double current,
                                         double bus) {
  if (esc.activeBraking || !(esc.ripple > 0) || !(share > 0 && share < 1)) return share;
  const double interrupted = 2 * std::max(current, 0.0) * share / (esc.ripple * bus * (1 - share));
  return std::min(share, std::sqrt(interrupted));
}

/// W lost beside the switches' resistance where a motor holds the share `share` of the bus in V at
/// a current in A.
[[nodiscard]] inline double steadyLoss(const EscConstants& esc, double share, double current,
                                       double bus) {
  const double duty = dutyForShare(esc, share, current, bus);
  const double path = esc.pathResistance * current;
  return conversionLoss(esc, conversion(esc, duty, current, share * bus - path, bus), current, bus);
}

}  // namespace rotorbench
