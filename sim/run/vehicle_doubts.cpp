#include "sim/run/vehicle_doubts.h"

#include <cmath>
#include <numbers>

namespace rotorbench {

std::vector<Problem> vehicleDoubts(const VehicleParameters& vehicle) {
  std::vector<Problem> problems;
  // Without a resistance a vehicle climbs and drifts at any speed.
  const AirResistance known = airResistanceOf(vehicle);
  if (!known.described())
    problems.push_back({"drag",
                        "the resistance of the air is not described: there is " + known.missing() +
                            ", so speeds and powers in flight are too good",
                        "the vehicle's own drag and inflow", true});
  return problems;
}

double figureOfMeritAt(double thrust, double shaftPower, double radius, double density) {
  const double disc = std::numbers::pi * radius * radius;
  if (!(thrust > 0) || !(shaftPower > 0) || !(density * disc > 0)) return 0;
  return thrust * std::sqrt(thrust / (2 * density * disc)) / shaftPower;
}

}  // namespace rotorbench
