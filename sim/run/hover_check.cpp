#include "sim/run/hover_check.h"

#include <algorithm>

#include "sim/analysis/trim.h"
#include "sim/core/number_text.h"
#include "sim/numerics/scalar_search.h"
#include "sim/propulsion/drive/bus.h"
#include "sim/run/vehicle_doubts.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

namespace {

std::string three(double value) {
  return shortNumber(value, 3);
}

void useBladeElements(RotorAerodynamics& aerodynamics) {
  if (const auto* map = std::get_if<MapPropeller>(&aerodynamics))
    aerodynamics = BladeElementPropeller{map->propeller, map->settings};
}

/// The first thing that is missing for a hover, or nothing.
template <int N>
std::string missingFor(const MultirotorConstants<N>& c, const Trim& hover) {
  double power = c.avionicsPower, mostVoltage = 0;
  int mostRotor = 0;
  for (int i = 0; i < N; ++i) {
    const auto& hub = c.hubs[static_cast<std::size_t>(i)];
    const double speed = hover.speeds[i];
    const double torque = hub.rotor.atRest(speed, c.air.density(0.0)).torque;
    const double current = hub.motor.steadyCurrent(speed, torque);
    const double voltage = hub.drive().steadyVoltage(speed, current);
    if (current > hub.motor.maxCurrent) {
      return "rotor " + std::to_string(i + 1) + " needs " + three(speed) + " rad/s and " +
             three(current) + " A, and its limit is " + three(hub.motor.maxCurrent) + " A";
    }
    power += voltage * current;
    if (voltage > mostVoltage) mostVoltage = voltage, mostRotor = i + 1;
  }
  if (busReserve(c.openCircuit, power, c.supply.resistance) < 0) {
    return "it takes " + three(power) + " W, and the supply gives at most " +
           three(c.openCircuit * c.openCircuit / (4 * c.supply.resistance)) + " W";
  }
  const double bus = busVoltage(c.openCircuit, power, c.supply.resistance);
  if (mostVoltage > bus) {
    return "rotor " + std::to_string(mostRotor) + " needs " + three(mostVoltage) +
           " V, and the supply has " + three(bus) + " V under that load";
  }
  if (bus < c.supply.cutOff) {
    return "under its load the supply falls to " + three(bus) + " V, below its cut-off of " +
           three(c.supply.cutOff) + " V";
  }
  return {};
}

/// N along the vehicle's vertical with every rotor at full throttle at rest. Torques at other
/// speeds than that of the hover are taken as its square.
template <int N>
double fullThrottleLift(const MultirotorConstants<N>& c) {
  const double density = c.air.density(0.0);
  struct Full {
    double lift = 0, current = 0;
  };
  const auto at = [&](double bus) {
    Full full;
    full.current = c.avionicsPower / bus;
    for (const auto& hub : c.hubs) {
      const MotorConstants drive = hub.drive();
      const double factor = density * hub.rotor.torque;
      const double w = topSpeed(drive, factor, bus);
      const double current = drive.steadyCurrent(w, factor * w * w);
      full.lift += density * hub.rotor.thrust * w * w * hub.axis.z();
      full.current += current * std::min(1.0, drive.steadyVoltage(w, current) / bus);
    }
    return full;
  };
  const double open = c.openCircuit;
  const auto surplus = [&](double bus) {
    return open - c.supply.resistance * at(bus).current - bus;
  };
  const double top = surplus(open), low = 0.01 * open;
  if (!(top < 0)) return at(open).lift;
  return at(findRoot(surplus, low, surplus(low), open, top, 1e-6 * open)).lift;
}

/// How a flight comes to need a hover.
struct Need {
  bool flown;       ///< a controller is to hold the vehicle
  bool starts;      ///< it begins in one
  double duration;  ///< s, of the flight
};

/// A hover whose battery is empty before the flight ends.
template <int N>
void warnOfEndurance(const MultirotorConstants<N>& c, const Trim& hover, double duration,
                     std::vector<Problem>& problems) {
  double power = 0;
  for (int i = 0; i < N; ++i) {
    const auto& hub = c.hubs[static_cast<std::size_t>(i)];
    const double torque = hub.rotor.atRest(hover.speeds[i], c.air.density(0.0)).torque;
    const double current = hub.motor.steadyCurrent(hover.speeds[i], torque);
    power += hub.drive().steadyVoltage(hover.speeds[i], current) * current;
  }
  const double seconds = c.supply.secondsAt(power, c.supply.charge);
  if (seconds >= duration) return;
  problems.push_back({"duration",
                      three(duration) + " s is longer than the battery holds a hover: about " +
                          three(seconds) + " s at " + three(power) + " W",
                      "a shorter flight, or more charge", true});
}

/// Rotors whose thrust would take less than the least power there is.
template <int N>
void warnOfMerit(const MultirotorConstants<N>& c, const Trim& hover,
                 const VehicleParameters& vehicle, std::vector<Problem>& problems) {
  const std::vector<RotorAtHub> rotors = rotorsOf(vehicle);
  const double density = c.air.density(0.0);
  for (std::size_t i = 0; i < N; ++i) {
    const double speed = hover.speeds[static_cast<int>(i)];
    const RotorConstants::Static still = c.hubs[i].rotor.atRest(speed, density);
    const double merit = figureOfMeritAt(still.thrust, still.torque * speed,
                                         rotorRadius(rotors[i].rotor.aerodynamics), density);
    if (!(merit > 1)) continue;
    problems.push_back({"vehicle.rotors",
                        "rotor " + std::to_string(i + 1) + " has a figure of merit of " +
                            three(merit) + " in hover, and no rotor is better than 1",
                        "thrust, torque and diameter that belong together", true});
    return;
  }
}

template <int N>
void warnOf(const MultirotorConstants<N>& c, const Need& need, const VehicleParameters& vehicle,
            std::vector<Problem>& problems) {
  const Trim hover = hoverToStartIn(c);
  warnOfMerit(c, hover, vehicle, problems);
  const std::string missing = missingFor(c, hover);
  if (missing.empty()) {
    if (need.flown) warnOfEndurance(c, hover, need.duration, problems);
    return;
  }
  if (need.flown) {
    const double lift = fullThrottleLift(c);
    problems.push_back({"vehicle.rotors",
                        "cannot hold the vehicle in a hover: " + missing +
                            "; at full throttle they lift about " + three(lift) + " N of its " +
                            three(c.mass * c.gravity) + " N",
                        "stronger rotors, or at most " + three(lift / c.gravity) + " kg", true});
  }
  if (need.starts) {
    problems.push_back({"start.rotors", "begins in a hover that the motors cannot hold: " + missing,
                        "rotors that stand still or turn at a given speed, or a vehicle that "
                        "can hover",
                        true});
  }
}

}  // namespace

VehicleParameters withoutMaps(VehicleParameters vehicle) {
  if (auto* equal = std::get_if<EqualRotors>(&vehicle.rotors)) {
    useBladeElements(equal->rotor.aerodynamics);
  } else {
    for (auto& rotor : std::get<IndividualRotors>(vehicle.rotors).rotors)
      useBladeElements(rotor.aerodynamics);
  }
  return vehicle;
}

void warnOfHover(const Flight& flight, std::vector<Problem>& problems) {
  if (std::holds_alternative<SpeedInputs>(flight.control)) return;
  // Whatever is not laid down in advance is a controller, which is to hold the vehicle.
  const bool flown = !std::holds_alternative<VoltageInputs>(flight.control);
  const bool starts = flight.start.rotors == RotorStart::Hover;
  if (!flown && !starts) return;
  try {
    withRotorCount(rotorCount(flight.vehicle.layout), [&](auto count) {
      auto there = buildMultirotor<count>(withoutMaps(flight.vehicle), flight.environment);
      there.air.elevation += flight.start.position.z();
      warnOf(there, {flown, starts, flight.duration}, flight.vehicle, problems);
    });
  } catch (const InputError& error) {
    // A start in a hover that does not exist, or a vehicle that cannot be built, is refused when
    // the run is built.
    if (starts) return;
    for (Problem problem : error.problems()) {
      problem.path = problem.path.empty() ? "vehicle" : "vehicle." + problem.path;
      problem.warning = true;
      problems.push_back(std::move(problem));
    }
  }
}

}  // namespace rotorbench
