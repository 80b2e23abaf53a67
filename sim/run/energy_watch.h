// Whether a flight gains energy that nothing gave it. In still air body and rotors only lose to the
// air what the supply gives them: more than that is made by a step too long for the equations, or
// by a rotor model beyond what it describes, and the flight is none.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "sim/core/error.h"

namespace rotorbench {

/// J, of body, rotors and windings at an instant of a flight through still air.
struct EnergyBalance {
  double stored = 0;  ///< kinetic, potential and magnetic
  double moving = 0;  ///< the kinetic part of it
  double drawn = 0;   ///< taken from the supply since the start
  double mass = 0;    ///< kg, of the vehicle
};

class EnergyWatch {
 public:
  /// Part of what was drawn and of what moved at the start by which a sound step may be off, and
  /// J/kg that are too little to matter: a fall of a tenth of a metre.
  static constexpr double kShare = 0.25, kFloor = 1;

  /// Why the flight must end at `time`, s, if it must.
  std::optional<RunFailure> see(double time, const EnergyBalance& now) {
    if (!begun_) begun_ = now;
    most_ = std::max(most_, now.drawn);
    const double gained = now.stored - begun_->stored - now.drawn;
    if (!(gained > kShare * (most_ + begun_->moving) + kFloor * now.mass)) return {};
    return failure(time, gained, now.drawn);
  }

 private:
  static RunFailure failure(double time, double gained, double drawn);

  std::optional<EnergyBalance> begun_;
  double most_ = 0;  ///< J, drawn at most
};

}  // namespace rotorbench
