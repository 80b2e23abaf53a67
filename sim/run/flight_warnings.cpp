#include "sim/run/flight_warnings.h"

#include <algorithm>
#include <string>

#include "sim/analysis/trim.h"
#include "sim/document/controlled_inputs.h"
#include "sim/run/body_poles.h"
#include "sim/run/drive_warnings.h"
#include "sim/run/hover_check.h"
#include "sim/run/step_stability.h"
#include "sim/run/vehicle_doubts.h"

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

/// What needs the vehicle built: the torque per speed with which a propeller brakes at the highest
/// speed its motor could have, N m s, of each rotor, and the fastest pole of the body where the
/// flight begins and in a hover.
struct InTheAir {
  std::vector<double> braking;
  BodyPole body;
};

template <int N>
InTheAir inTheAirOf(const MultirotorConstants<N>& c, const FlightStart& start) {
  InTheAir found;
  const double density = c.air.density(start.position.z());
  Eigen::Matrix<double, N, 1> speeds;
  for (const RotorHub& hub : c.hubs) {
    const double top = c.openCircuit / hub.motor.torqueConstant;
    speeds[static_cast<int>(found.braking.size())] = top / 2;
    found.braking.push_back(2 * density * hub.rotor.torque * top);
  }
  if (const auto hover = trimmedHover(c)) speeds = hover->speeds.template head<N>();
  for (const bool begins : {true, false}) {
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    const BodyPole pole =
        fastestBodyPole<N>(c, begins ? start.velocity : none, begins ? start.rates : none, speeds);
    if (pole.magnitude > found.body.magnitude) found.body = pole;
  }
  return found;
}

InTheAir inTheAir(const Flight& flight) {
  const auto count = static_cast<std::size_t>(rotorCount(flight.vehicle.layout));
  InTheAir found{std::vector<double>(count, 0.0), {}};
  try {
    withRotorCount(rotorCount(flight.vehicle.layout), [&](auto n) {
      found = inTheAirOf<n>(buildMultirotor<n>(withoutMaps(flight.vehicle), flight.environment),
                            flight.start);
    });
  } catch (const InputError&) {
    // What cannot be built is refused elsewhere.
  }
  return found;
}

/// A pole in 1/s and what helps against it besides a shorter step.
struct NamedPole {
  const char* name;
  const char* remedy;
  double value = 0;
  void raise(double other) { value = std::max(value, other); }
};

/// The fastest of motors and supply. All motors at full duty feel the supply's resistance together;
/// a propeller brakes most at the highest speed. The exponential method solves motors and lags
/// exactly, but not what couples the motors, nor the air.
NamedPole drivePole(const Flight& flight, const std::vector<double>& brakingOf) {
  const Supply supply(flight.vehicle.supply);
  const bool stopped = flight.start.rotors == RotorStart::Stopped;
  NamedPole all{"the fastest pole of motors and supply", "exponential RK4"},
      lag{kLagPole, "no response time"},
      shared{"the pole of motors and supply resistance together", "a smaller supply resistance"},
      air{"the pole of a rotor in the air", "a larger inertia of the rotor"};
  auto braking = brakingOf.begin();
  for (const auto& [path, rotor] : describedRotors(flight.vehicle)) {
    const MotorConstants motor = buildMotor(rotor.motor);
    if (rotor.esc.responseTime > 0) lag.raise(1 / rotor.esc.responseTime);
    const double coupled = rotorCount(flight.vehicle.layout) * supply.resistance;
    shared.raise(coupled * motor.inverseInductance);
    // Friction is steepest at rest.
    const double friction = motor.viscousFriction + motor.dryFriction / kFrictionSpeed;
    all.raise(fastestPole(motor, motor.resistance + rotor.esc.resistance + coupled,
                          friction + *braking, rotor.inertia));
    air.raise((*braking++ + (stopped ? friction : 0)) / rotor.inertia);
  }
  if (flight.solver.method == ode::Method::ExponentialRk4)
    return air.value > shared.value ? air : shared;
  return lag.value > all.value ? lag : all;
}

/// Warns where a fixed step cannot be stable beside the fastest pole of drives and body.
void warnOfUnstableStep(const Flight& flight, std::vector<Problem>& problems) {
  const InTheAir air = inTheAir(flight);
  NamedPole worst{air.body.turning ? "the fastest pole of the body's rotation"
                                   : "the fastest pole of the body's motion in the air",
                  "a method that chooses its step", air.body.magnitude};
  if (!std::holds_alternative<SpeedInputs>(flight.control)) {
    const NamedPole drive = drivePole(flight, air.braking);
    if (drive.value > worst.value) worst = drive;
  }
  addUnstableStep({"solver.step", worst.name, worst.remedy}, worst.value, flight.solver,
                  flight.tick, problems);
}

}  // namespace

std::vector<Problem> flightWarnings(const Flight& flight) {
  std::vector<Problem> problems;
  if (const auto* inputs = alternativeIf<ControlledInputs>(flight.control)) {
    for (const auto& [path, rotor] : describedRotors(flight.vehicle))
      warnOfDelays(rotor.esc, path + ".esc", inputs->motors.rate, problems);
    const auto rateOf = [](const auto& controller) { return controller.rate; };
    checkRate(std::visit(rateOf, inputs->controller), flight.tick, "control.controller.rate",
              problems);
    checkRate(inputs->motors.rate, flight.tick, "control.motors.rate", problems);
  }
  if (stabilityLimit(flight.solver.method) > 0) warnOfUnstableStep(flight, problems);
  warnOfHover(flight, problems);
  for (Problem& doubt : vehicleDoubts(flight.vehicle)) {
    doubt.path = "vehicle." + doubt.path;
    problems.push_back(std::move(doubt));
  }
  return problems;
}

}  // namespace rotorbench
