// A rotor: a propeller by one of several models, the motor that turns it and its speed controller.
// SI units.
#pragma once

#include <memory>

#include "sim/core/schema.h"
#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/drive/motor.h"
#include "sim/propulsion/rotor/rotor_models.h"

namespace rotorbench {

/// One rotor with its motor: that of the default vehicle, a DJI F450.
struct RotorParameters {
  RotorAerodynamics aerodynamics;
  double inertia = 6.05e-5;  ///< kg m^2 of all that spins, about the axis
  double mass = 0.055;       ///< kg of motor and propeller, a point at the hub
  int blades = 2;
  MotorParameters motor = djiE305();
  EscParameters esc;
  bool operator==(const RotorParameters&) const = default;
};

/// One rotor: its aerodynamics and its inertia. `thrust` and `torque` of the lumped base are what
/// controllers know of any model: k_eta and k_m per air density, of another model at one speed (see
/// linearise()).
struct RotorConstants : RotorModel<double> {
  double inertia = 1, inverseInertia = 1;
  std::shared_ptr<const PreparedRotor> model;  ///< null: lumped, the base holds all of it

  /// Thrust in N and torque in N m at rest in the air.
  struct Static {
    double thrust, torque;
  };
  [[nodiscard]] Static atRest(double w, double density) const;
  /// Takes thrust and torque per speed squared at speed w, rad/s, above 0, in air of a density
  /// above 0.
  void linearise(double w, double density);
};

/// Prepares the model: a map takes the time to be built, unless it was before.
RotorConstants buildRotor(const RotorParameters& parameters);

template <>
struct Describe<RotorParameters> {
  static void fields(schema::Builder<RotorParameters>& b);
};

}  // namespace rotorbench
