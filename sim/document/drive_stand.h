// What the experiments with a single motor share: supply, speed controller, motor and load as the
// user describes them.
#pragma once

#include <variant>
#include <vector>

#include "sim/core/schema.h"
#include "sim/ode/solver_settings.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/drive/motor.h"
#include "sim/propulsion/rotor/blade_element.h"

namespace rotorbench {

/// Nothing on the shaft.
struct FreeShaft {
  bool operator==(const FreeShaft&) const = default;
};
/// A friction brake.
struct BrakeLoad {
  double torque = 0.05;  ///< N m
  bool operator==(const BrakeLoad&) const = default;
};
/// A propeller at rest in the air, by its static coefficients.
struct PropellerLoad {
  double thrustCoefficient = 0.1288;  ///< CT: T = CT rho n^2 D^4
  double powerCoefficient = 0.0666;   ///< CP: P = CP rho n^3 D^5
  double diameter = 0.24003;          ///< m
  double airDensity = 1.225;          ///< kg/m^3
  bool operator==(const PropellerLoad&) const = default;
};

/// A propeller at rest in the air, by blade elements: its coefficients change with the speed.
struct BladeElementLoad {
  PropellerGeometry propeller;
  BladeElementSettings settings;
  double airDensity = 1.225;      ///< kg/m^3
  double airViscosity = 1.81e-5;  ///< Pa s
  bool operator==(const BladeElementLoad&) const = default;
};

/// Defaults: the E305 set of the DJI F450.
struct DriveStand {
  SupplyModel supply;
  EscParameters esc{.resistance = 0.005, .responseTime = 0.01};  ///< 420 LITE: both assumed
  MotorParameters motor = djiE305();
  std::variant<PropellerLoad, BladeElementLoad, BrakeLoad, FreeShaft> load;
  double inertia = 6.05e-5;  ///< kg m^2 of all that spins
  bool quasiStaticCurrent = false;
  bool operator==(const DriveStand&) const = default;
};

/// What all experiments on the stand have besides the stand itself.
struct DriveRunSettings {
  ode::SolverSettings solver{.method = ode::Method::Rk4, .step = 1e-4};
  double tick = 1e-3;   ///< s, the throttle is held for this long
  double duration = 2;  ///< s
  bool operator==(const DriveRunSettings&) const = default;
};

/// Refuses, at "solver.method", the method that is no use on a stand.
void checkDriveMethod(const ode::SolverSettings& solver, std::vector<Problem>& problems);

template <>
struct Describe<FreeShaft> {
  static void fields(schema::Builder<FreeShaft>& b);
};
template <>
struct Describe<BrakeLoad> {
  static void fields(schema::Builder<BrakeLoad>& b);
};
template <>
struct Describe<PropellerLoad> {
  static void fields(schema::Builder<PropellerLoad>& b);
};
template <>
struct Describe<BladeElementLoad> {
  static void fields(schema::Builder<BladeElementLoad>& b);
};
template <>
struct Describe<DriveStand> {
  static void fields(schema::Builder<DriveStand>& b);
};

template <>
struct Describe<DriveRunSettings> {
  static void fields(schema::Builder<DriveRunSettings>& b);
};

}  // namespace rotorbench
