// Performance sheet of a vehicle in its surroundings: what it lifts, how long and how fast it
// flies, and which limit decides each figure. Steady flight from steady_flight.h, time from
// discharge.h. SI units.
#pragma once

#include "sim/environment/environment.h"
#include "sim/sizing/figure.h"
#include "sim/sizing/steady_flight.h"

namespace rotorbench {

/// What must be left of throttle, battery and tilt.
struct PerformanceSettings {
  double payloadThrottle = 0.8;  ///< of the largest throttle, with which the largest payload hovers
  double speedThrottle =
      1;  ///< of the largest throttle, in the fastest level flight and at the ceiling
  double tiltLimit = 0.7853981633974483;  ///< rad
  double reserveCharge = 0.2;             ///< state of charge at which a flight is over
  bool operator==(const PerformanceSettings&) const = default;
};

/// What ends a search for the largest mass, speed or altitude.
enum class FlightLimit {
  None,
  Throttle,  ///< a motor needs more of the supply's voltage
  Current,   ///< a motor's or speed controller's current limit
  Supply,    ///< the supply cannot give the power
  CutOff,    ///< the battery's voltage under load
  Tilt,
  Model,   ///< the air meets the blades too fast for any rotor model here
  NoTrim,  ///< the rotors find no balance of force and moment
};

/// Air speed over the speed of the blade tips up to which lumped coefficients and rigid blades
/// describe a rotor; helicopters stay below it too. J. G. Leishman, Principles of Helicopter
/// Aerodynamics, 2nd ed., ch. 5.
inline constexpr double kMostAdvance = 0.4;

/// How far a steady state is from its nearest limit: above 0 where none is broken.
struct Margin {
  double value = 0;
  FlightLimit limit = FlightLimit::None;
};
Margin marginOf(const SteadyFlight& flight, const Trim& trim, double throttleLimit,
                double tiltLimit);

struct LevelFlight {
  Trim fastest;
  FlightLimit limit = FlightLimit::None;
  Trim farthest;  ///< least electrical power per speed
};
/// The fastest level flight from the hover on, and that of the longest range; `hover` must be
/// within its limits.
LevelFlight levelFlight(const SteadyFlight& flight, const Trim& hover,
                        const PerformanceSettings& settings);

/// All figures with what limits them. Throws InputError as buildMultirotor().
FigureSheet performanceSheet(const VehicleParameters& vehicle,
                             const EnvironmentParameters& environment,
                             const PerformanceSettings& settings = {});

template <>
struct Describe<PerformanceSettings> {
  static void fields(schema::Builder<PerformanceSettings>& b);
};

}  // namespace rotorbench
