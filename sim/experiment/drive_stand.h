// What the experiments with a single motor share: supply, speed controller, motor and load as the
// user describes them, the plant built from that, and the channels it is recorded in.
#pragma once

#include <variant>
#include <vector>

#include "sim/core/channel.h"
#include "sim/core/schema.h"
#include "sim/ode/solver_settings.h"
#include "sim/propulsion/blade_element.h"
#include "sim/propulsion/drive_train.h"

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

struct DriveStand {
  SupplyModel supply;
  EscParameters esc;
  MotorParameters motor;
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

DriveTrain buildDriveTrain(const DriveStand& stand);
/// The same drive without saturation: an ideal supply of the voltage the real one has at first, any
/// duty, any current.
DriveTrain buildUnlimitedDriveTrain(const DriveStand& stand);

/// Time in s and everything that can be read on the stand.
std::vector<Channel> driveChannels();
/// The row that belongs to the channels; `asked` is the throttle commanded, which a dead time may
/// still hold back.
void driveRow(const DriveTrain& train, double time, double asked, const DriveTrain::State& y,
              double* out);

/// Refuses, at "solver.method", the method that is no use on a stand.
void checkDriveMethod(const ode::SolverSettings& solver, std::vector<Problem>& problems);

/// Warns, naming pole, method and largest stable step, where a fixed step cannot be stable. The
/// experiment holds its DriveRunSettings as "run". Says nothing of a stand with faults.
void warnOfUnstableStep(const DriveStand& stand, const ode::SolverSettings& solver, double tick,
                        std::vector<Problem>& problems);

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
