#include "sim/run/vehicle_doubts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rotorbench {

namespace {

/// Null for a rotor whose own model says what moving air does.
const RotorInflow* lumpedInflow(const RotorAerodynamics& aerodynamics) {
  if (const auto* c = std::get_if<PropellerCoefficients>(&aerodynamics)) return &c->inflow;
  if (const auto* c = std::get_if<RotorCoefficients>(&aerodynamics)) return &c->inflow;
  return nullptr;
}

/// Whether some rotor meets a resistance of the air: in its plane, or along its axis.
bool someRotor(const VehicleParameters& vehicle, double RotorInflow::*resistance) {
  const auto resists = [resistance](const RotorParameters& rotor) {
    const RotorInflow* inflow = lumpedInflow(rotor.aerodynamics);
    return inflow == nullptr || inflow->*resistance > 0;
  };
  if (const auto* equal = std::get_if<EqualRotors>(&vehicle.rotors)) return resists(equal->rotor);
  return std::ranges::any_of(std::get<IndividualRotors>(vehicle.rotors).rotors, resists);
}

}  // namespace

std::vector<Problem> vehicleDoubts(const VehicleParameters& vehicle) {
  const BodyDrag& drag = vehicle.drag;
  const bool body = drag.linear > 0 || drag.quadratic.x() > 0;
  const bool along = drag.linear > 0 || drag.quadratic.z() > 0;
  std::vector<Problem> problems;
  if (!body && !someRotor(vehicle, &RotorInflow::drag)) {
    problems.push_back({"drag", "is not described: nothing but the rotors' tilt limits the speed",
                        "drag of the body or in-plane drag of the rotors", true});
  } else if (!along && !someRotor(vehicle, &RotorInflow::inflow)) {
    problems.push_back({"drag", "is not described along the vertical: nothing limits the climb",
                        "drag of the body or inflow of the rotors", true});
  }
  return problems;
}

double figureOfMeritAt(double thrust, double shaftPower, double radius, double density) {
  const double disc = std::numbers::pi * radius * radius;
  if (!(thrust > 0) || !(shaftPower > 0) || !(density * disc > 0)) return 0;
  return thrust * std::sqrt(thrust / (2 * density * disc)) / shaftPower;
}

}  // namespace rotorbench
