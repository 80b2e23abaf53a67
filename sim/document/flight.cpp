#include "sim/document/flight.h"

#include <algorithm>

#include "sim/document/controlled_inputs.h"

namespace rotorbench {

namespace {

/// Calls f(values, path below the flight) for every instant of inputs laid down in advance.
template <class AnyFlight, class F>
void forEachInput(AnyFlight& flight, F&& f) {
  const auto below = [&](auto& values, const std::string& path) { f(values, "control." + path); };
  if (auto* speeds = std::get_if<SpeedInputs>(&flight.control)) forEachInstant(*speeds, below);
  if (auto* voltages = std::get_if<VoltageInputs>(&flight.control))
    forEachInstant(*voltages, below);
}

/// Changes in the order of their times, each one possible after those before it.
void checkChanges(const Flight& flight, std::vector<Problem>& problems) {
  if (flight.changes.empty()) return;
  Flight changed = flight;
  double latest = 0;
  for (std::size_t i = 0; i < flight.changes.size(); ++i) {
    const Change& change = flight.changes[i];
    const std::string place = "changes[" + std::to_string(i) + "]";
    if (change.time < latest)
      problems.push_back({place + ".time", "is before that of the row before",
                          "times must not fall from row to row"});
    latest = std::max(latest, change.time);
    if (change.time >= flight.duration)
      problems.push_back({place + ".time", "is not before the end of the flight: nothing changes",
                          "a time before the end", true});
    if (const auto problem = makeChange(changed, change))
      problems.push_back({place, problem->message(), {}});
  }
}

bool hasInputsForEachRotor(const Flight& flight) {
  const auto rotors = static_cast<std::size_t>(rotorCount(flight.vehicle.layout));
  bool all = true;
  if (rotors == 0) return all;  // there is nothing to follow
  forEachInput(flight, [&](const auto& values, const auto&) { all &= values.size() == rotors; });
  return all;
}

}  // namespace

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
  b.boolean("endsAtGround", &Flight::endsAtGround, "Ends at the ground")
      .help(
          "The flight ends where the centre of mass comes down to height 0, once it has been 0.1 m "
          "above. Otherwise there is no ground, and a vehicle falls on.");
  b.list("changes", &Flight::changes, "Changes")
      .items(0, 100000)
      .table()
      .help(
          "Gains, set-points and wind that take another value during the flight. What is changed "
          "by "
          "hand while a run goes on is written here in the run's own experiment, which repeats it. "
          "Times must not fall from row to row.");
  b.follows("control", hasInputsForEachRotor, [](Flight& f) {
    const auto rotors = static_cast<std::size_t>(rotorCount(f.vehicle.layout));
    forEachInput(f, [&](auto& values, const auto&) { values.resize(rotors, values.back()); });
  });
  b.check([](const Flight& f, std::vector<Problem>& problems) {
    const int rotors = rotorCount(f.vehicle.layout);
    forEachInput(f, [&](const auto& values, const std::string& path) {
      if (static_cast<int>(values.size()) == rotors) return;
      problems.push_back({path, "has " + std::to_string(values.size()) + " values",
                          std::to_string(rotors) + ", one for each rotor of the layout"});
    });
    checkChanges(f, problems);
    if (f.tick > f.duration)
      problems.push_back({"tick", "is longer than the flight", "at most the duration"});
  });
}

}  // namespace rotorbench
