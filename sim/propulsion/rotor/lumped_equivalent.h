// Lumped coefficients that stand for a propeller of another model about one speed: what blade
// elements, a map or measured tables say at rest gives k_eta and k_m, and what they say in moving
// air gives k_z, k_h, k_d and k_flap, each the one of least squares over a grid of air speeds
//   T - k_eta w^2 = k_h u^2 - k_z w V,   H = k_d w u,   M_pitch = k_flap w u
// u in-plane, V axial. What the lumped model has no term for (force to the side, rolling moment,
// torque in moving air) is left out and told by its size. SI units.
#pragma once

#include "sim/propulsion/rotor/rotor_models.h"

namespace rotorbench {

/// About what the coefficients are to hold.
struct LumpingRange {
  double speed = 500;      ///< rad/s, above 0
  double density = 1.225;  ///< kg/m^3, above 0
  double inPlane = 5;      ///< m/s, the largest in-plane air speed; above 0
  double axial = 1;        ///< m/s, the largest climb and descent; above 0
};

/// About this speed, rad/s, in air of this density: in-plane up to a tenth of the blade tips'
/// speed, axial up to 0.4 of the induced velocity at rest, where no vortex ring forms.
LumpingRange lumpingRange(const RotorAerodynamics& rotor, double speed, double density);

/// Root mean squares over the grid, as parts of the static thrust T0 and of T0 R.
struct LumpingErrors {
  double thrust = 0;          ///< of the lumped against the model's
  double torque = 0;          ///< over the static torque
  double inPlane = 0;         ///< force along the in-plane stream
  double pitch = 0;           ///< moment about the axis across the stream
  double side = 0, roll = 0;  ///< all there is of them: the lumped model has none
};

struct LumpedEquivalent {
  RotorCoefficients coefficients;
  LumpingErrors errors;
};

/// k_z, k_h and k_d below 0 are not allowed and become 0: their part is then in the errors. A map
/// takes the time to be built, unless it was before. Throws InputError where the model has no
/// thrust or no finite load at rest.
LumpedEquivalent lumpedEquivalent(const RotorAerodynamics& rotor, const LumpingRange& range);

template <>
struct Describe<LumpingRange> {
  static void fields(schema::Builder<LumpingRange>& b);
};
}  // namespace rotorbench
