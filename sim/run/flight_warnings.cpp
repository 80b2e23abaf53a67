#include "sim/run/flight_warnings.h"

#include <algorithm>
#include <string>

#include "sim/document/controlled_inputs.h"
#include "sim/run/drive_warnings.h"
#include "sim/run/hover_check.h"
#include "sim/run/step_stability.h"

namespace rotorbench {

namespace {

/// A rotor of a sound vehicle and where it is described; one stands for all that are alike.
struct DescribedRotor {
  std::string path;
  const RotorParameters& rotor;
};
std::vector<DescribedRotor> describedRotors(const VehicleParameters& vehicle) {
  if (const auto* equal = std::get_if<EqualRotors>(&vehicle.rotors))
    return {{"vehicle.rotors.rotor", equal->rotor}};
  std::vector<DescribedRotor> rotors;
  for (const RotorParameters& rotor : std::get<IndividualRotors>(vehicle.rotors).rotors) {
    rotors.push_back({"vehicle.rotors.rotors[" + std::to_string(rotors.size()) + "]", rotor});
  }
  return rotors;
}

/// Warns where a fixed step cannot be stable beside the fastest pole of motors and supply. All
/// motors at full duty feel the supply's resistance together. The exponential method solves motors
/// and lags exactly, but not what couples the motors.
void warnOfUnstableStep(const Flight& flight, std::vector<Problem>& problems) {
  const std::vector<DescribedRotor> rotors = describedRotors(flight.vehicle);
  const Supply supply(flight.vehicle.supply);
  const bool exponential = flight.solver.method == ode::Method::ExponentialRk4;
  double pole = 0, shared = 0, lag = 0;
  for (const auto& [path, rotor] : rotors) {
    const MotorConstants motor = buildMotor(rotor.motor);
    if (rotor.esc.responseTime > 0) lag = std::max(lag, 1 / rotor.esc.responseTime);
    const double coupled = rotorCount(flight.vehicle.layout) * supply.resistance;
    shared = std::max(shared, coupled * motor.inverseInductance);
    // Friction is steepest at rest.
    const double drag = motor.viscousFriction + motor.dryFriction / kFrictionSpeed;
    pole = std::max(pole, fastestPole(motor, motor.resistance + rotor.esc.resistance + coupled,
                                      drag, rotor.inertia));
  }
  if (!exponential && lag > pole) {
    addUnstableStep({"solver.step", kLagPole, "no response time"}, lag, flight.solver, flight.tick,
                    problems);
    return;
  }
  const char* name = exponential ? "the pole of motors and supply resistance together"
                                 : "the fastest pole of motors and supply";
  const char* remedy = exponential ? "a smaller supply resistance" : "exponential RK4";
  addUnstableStep({"solver.step", name, remedy}, exponential ? shared : pole, flight.solver,
                  flight.tick, problems);
}

/// Without a resistance a vehicle climbs and drifts at any speed.
void warnOfAirResistance(const VehicleParameters& vehicle, std::vector<Problem>& problems) {
  const AirResistance known = airResistanceOf(vehicle);
  if (known.described()) return;
  problems.push_back({"vehicle.drag",
                      "the resistance of the air is not described: there is " + known.missing() +
                          ", so speeds and powers in flight are too good",
                      "the vehicle's own drag and inflow", true});
}

}  // namespace

std::vector<Problem> flightWarnings(const Flight& flight) {
  std::vector<Problem> problems;
  if (!std::holds_alternative<SpeedInputs>(flight.control)) {
    if (const auto* inputs = alternativeIf<ControlledInputs>(flight.control)) {
      for (const auto& [path, rotor] : describedRotors(flight.vehicle))
        warnOfDelays(rotor.esc, path + ".esc", inputs->motors.rate, problems);
    }
    if (stabilityLimit(flight.solver.method) > 0) warnOfUnstableStep(flight, problems);
  }
  warnOfHover(flight, problems);
  warnOfAirResistance(flight.vehicle, problems);
  return problems;
}

}  // namespace rotorbench
