#include "sim/experiment/flight.h"

#include <algorithm>

#include "sim/core/schema_tree.h"
#include "sim/experiment/flight_simulation.h"
#include "sim/experiment/pid_pilot.h"
#include "sim/experiment/prescribed_pilots.h"
#include "sim/experiment/step_stability.h"

namespace rotorbench {

namespace {

/// The controller's or inputs' part of the build; every alternative of Flight::control has one.
struct FlightBuilder {
  const Flight& flight;
  const OutputSettings& outputs;
  const std::filesystem::path& directory;

  template <class Pilot>
  [[nodiscard]] std::unique_ptr<Simulation> fly(Pilot pilot) const {
    using Plant = typename Pilot::Plant;
    Plant plant(buildMultirotor<4>(flight.vehicle, flight.environment));
    return std::make_unique<FlightSimulation<Plant, Pilot>>(flight, outputs, std::move(plant),
                                                            std::move(pilot));
  }
  std::unique_ptr<Simulation> operator()(const PidControl& control) const {
    // The controller flies the vehicle as planned; deviations are what it does not know.
    const auto planned = buildMultirotor<4>(flight.vehicle, flight.environment, true);
    return fly(PidPilot(control, controlModel<4>(planned), flight.tick));
  }
  std::unique_ptr<Simulation> operator()(const SpeedInputs& inputs) const {
    return fly(SpeedPilot(loadInputs(inputs, directory)));
  }
  std::unique_ptr<Simulation> operator()(const VoltageInputs& inputs) const {
    return fly(VoltagePilot(loadInputs(inputs, directory)));
  }
};

constexpr int kRotors = 4;

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
    const double coupled = kRotors * supply.resistance;
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

/// Rules are asked of documents with faults too, and nothing can be built of a vehicle that has
/// some.
bool isSound(const VehicleParameters& vehicle) {
  return std::ranges::all_of(schema::validate(schema::ref(vehicle)),
                             [](const Problem& p) { return p.warning; });
}

}  // namespace

std::unique_ptr<Simulation> buildFlight(const Flight& flight, const OutputSettings& outputs,
                                        std::uint64_t /*seed*/,
                                        const std::filesystem::path& directory) {
  try {
    return std::visit(FlightBuilder{flight, outputs, directory}, flight.control);
  } catch (const InputError& error) {
    if (error.source() != "vehicle") throw;
    // What the vehicle's rooms refuse is named from the root of the document, so that the window
    // can jump there.
    auto problems = error.problems();
    for (Problem& problem : problems) {
      problem.path = problem.path.empty() ? "setup.vehicle" : "setup.vehicle." + problem.path;
    }
    throw InputError({}, std::move(problems));
  }
}

void Describe<Flight>::fields(schema::Builder<Flight>& b) {
  b.title("flight", "Flight",
          "A multirotor flown by a controller or by inputs laid down in advance.");
  b.group("vehicle", &Flight::vehicle, "Vehicle");
  b.variant("control", &Flight::control, "Control");
  b.variant("sensors", &Flight::sensors, "Sensors");
  b.group("environment", &Flight::environment, "Environment");
  b.group("start", &Flight::start, "Start");
  b.group("solver", &Flight::solver, "Solver");
  b.number("tick", &Flight::tick, "Tick", "", "s")
      .range(schema::atLeast(1e-6), schema::upTo(1))
      .shownIn("ms")
      .help(
          "Period of the fastest task: commands are held for this long, and the solver ends a step "
          "at its end.");
  b.number("duration", &Flight::duration, "Duration", "T", "s")
      .range(schema::above(0), schema::upTo(36000));
  b.check([](const Flight& f, std::vector<Problem>& problems) {
    if (f.tick > f.duration)
      problems.push_back({"tick", "is longer than the flight", "at most the duration"});
    if (std::holds_alternative<SpeedInputs>(f.control) || !isSound(f.vehicle)) return;
    if (const auto* pid = std::get_if<PidControl>(&f.control)) {
      for (const auto& [path, rotor] : describedRotors(f.vehicle))
        warnOfDelays(rotor.esc, path + ".esc", pid->controller.motors.rate, problems);
    }
    if (stabilityLimit(f.solver.method) > 0) warnOfUnstableStep(f, problems);
  });
}

}  // namespace rotorbench
