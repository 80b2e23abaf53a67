#include "sim/run/drive_build.h"

#include <algorithm>
#include <cmath>

#include "sim/propulsion/rotor/lumped_rotor.h"

namespace rotorbench {

namespace {

/// Points of a propeller's curve over the speed; fewer do where only the step is judged.
constexpr int kSpeedPoints = 64, kFewSpeedPoints = 4;

struct LoadOf {
  double topSpeed;  ///< rad/s, never exceeded: the motor's speed at the full voltage of the supply
  int points;

  ShaftLoad operator()(const FreeShaft& /*load*/) const { return {}; }
  ShaftLoad operator()(const BrakeLoad& load) const { return {.constant = load.torque}; }
  ShaftLoad operator()(const PropellerLoad& p) const {
    const SquareFactors factors =
        squareFactors(p.thrustCoefficient, p.powerCoefficient, p.diameter);
    const double torque = p.airDensity * factors.torque, thrust = p.airDensity * factors.thrust;
    return {.quadratic = {1, {torque, torque}}, .thrust = {1, {thrust, thrust}}};
  }
  ShaftLoad operator()(const BladeElementLoad& p) const {
    const BladeElementRotor rotor(p.propeller, p.settings);
    const AirState air{p.airDensity, p.airViscosity};
    ShaftLoad load;
    load.quadratic = load.thrust = {topSpeed / points, {}};
    for (int k = 0; k <= points; ++k) {
      // At rest the coefficients are those of the slowest turning, which is a limit and no division
      // by zero.
      const double w = topSpeed * std::max(k, 1) / points;
      const AxialLoad at = rotor.axial(w, 0, air);
      load.quadratic.values.push_back(at.torque / (w * w));
      load.thrust.values.push_back(at.thrust / (w * w));
    }
    return load;
  }
};

DriveTrainSetup setupOf(const DriveStand& stand, int speedPoints) {
  const double topSpeed = Supply(stand.supply).openCircuit(1.0) * stand.motor.speedConstant;
  return {.supply = stand.supply,
          .esc = stand.esc,
          .motor = stand.motor,
          .load = std::visit(LoadOf{topSpeed, speedPoints}, stand.load),
          .inertia = stand.inertia,
          .quasiStaticCurrent = stand.quasiStaticCurrent};
}

}  // namespace

DriveTrain buildDriveTrain(const DriveStand& stand) {
  return DriveTrain(setupOf(stand, kSpeedPoints));
}

DriveTrain buildCoarseDriveTrain(const DriveStand& stand) {
  return DriveTrain(setupOf(stand, kFewSpeedPoints));
}

DriveTrain buildUnlimitedDriveTrain(const DriveStand& stand) {
  DriveTrainSetup setup = setupOf(stand, kSpeedPoints);
  const Supply supply(stand.supply);
  setup.supply = SupplyParameters{.voltage = supply.openCircuit(supply.charge)};
  setup.unlimited = true;
  return DriveTrain(setup);
}

std::vector<Channel> driveChannels() {
  return {{"time", "s", "Simulated time"},
          {"throttle", "1", "Throttle asked of the speed controller"},
          {"esc.duty", "1", "Share of the supply's voltage put on the motor"},
          {"supply.voltage", "V", "Voltage of the supply under load"},
          {"supply.current", "A", "Current drawn from the supply"},
          {"supply.charge", "1", "State of charge of the battery"},
          {"motor.voltage", "V", "Voltage at the motor's terminals"},
          {"motor.current", "A", "Current of the motor"},
          {"motor.speed", "rad/s", "Angular speed"},
          {"motor.torque", "N*m", "Torque of the load on the shaft"},
          {"thrust", "N", "Thrust of the propeller"},
          {"thrust_per_power", "N/W", "Thrust over electrical power"},
          {"power.electrical", "W", "Power drawn from the supply"},
          {"power.shaft", "W", "Power delivered to the load"},
          {"efficiency", "1", "Shaft power over electrical power"},
          {"power.residual", "W", "What the energy ledger leaves over: rounding"}};
}

void driveRow(const DriveTrain& train, double time, double asked, const DriveTrain::State& y,
              double* out) {
  const DriveInstant<double> at = train.instant(y);
  const DrivePowers powers = train.powers(y);
  const double w = y[DriveTrain::kSpeed];
  const double thrust = train.load().thrustAt(w);
  const double electrical = at.busVoltage * at.busCurrent;
  const double values[] = {
      time, asked, at.duty, at.busVoltage, at.busCurrent, y[DriveTrain::kCharge], at.motorVoltage,
      at.current, w, train.load().torque(w), thrust,
      // While the propeller drives the motor the ratio says nothing.
      electrical > 0 && powers.load <= electrical ? thrust / electrical : 0.0, electrical,
      powers.load,
      electrical > 0 && powers.load >= 0 ? std::min(powers.load / electrical, 1.0) : 0.0,
      powers.residual()};
  std::copy(std::begin(values), std::end(values), out);
}

}  // namespace rotorbench
