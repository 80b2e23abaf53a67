#include "sim/run/benched_propeller.h"

#include <cmath>
#include <numbers>

namespace rotorbench {

namespace {

RotorModel<double> lumpedOf(const RotorAerodynamics& propeller) {
  if (const auto* c = std::get_if<PropellerCoefficients>(&propeller)) return lumpedModel(*c);
  if (const auto* c = std::get_if<RotorCoefficients>(&propeller)) return lumpedModel(*c);
  return {};
}

}  // namespace

BenchedPropeller::BenchedPropeller(const RotorAerodynamics& propeller)
    : prepared_(prepareRotor(propeller)),
      lumped_(lumpedOf(propeller)),
      radius_(rotorRadius(propeller)) {}

RotorLoad<double> BenchedPropeller::load(double omega, const Eigen::Vector3d& v,
                                         const AirState& air) const {
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  if (const auto* map = prepared<PropellerMap>())
    return map->load(omega, v, axis, 1, air.density, air.viscosity);
  if (const auto* blades = bladeElements()) return blades->load(omega, v, axis, 1, air);
  if (const auto* table = prepared<CoefficientTable>())
    return table->load(omega, v, axis, 1, air.density);
  return lumped_.load<double>(omega, v, axis, 1.0, air.density);
}

AxialLoad BenchedPropeller::axial(double omega, double axialSpeed, const AirState& air,
                                  InflowMemory* memory, std::span<ElementLoad> distribution) const {
  if (const auto* blades = bladeElements())
    return blades->axial(omega, axialSpeed, air, memory, distribution);
  const RotorLoad<double> l = load(omega, {0, 0, axialSpeed}, air);
  return {l.thrust, l.torque, 0};
}

EdgewiseLoad BenchedPropeller::oblique(double omega, double axialSpeed, double inPlaneSpeed,
                                       const AirState& air) const {
  // e1 is the body's x, e2 its y.
  const RotorLoad<double> l = load(omega, {inPlaneSpeed, 0, axialSpeed}, air);
  return {{l.thrust, l.torque, -l.force.x(), l.moment.x()}, l.force.y(), l.moment.y()};
}

const BladeElementRotor* BenchedPropeller::bladeElements() const {
  return prepared<BladeElementRotor>();
}

std::optional<CoefficientTable::Limits> BenchedPropeller::limits(double omega) const {
  const auto* table = prepared<CoefficientTable>();
  if (table == nullptr) return std::nullopt;
  return table->limits(std::abs(omega));
}

bool BenchedPropeller::knowsAdvance(double omega, double axialSpeed) const {
  const auto measured = limits(omega);
  if (!measured) return true;
  constexpr double kSame = 1e-9;  // of J: a measured ratio that went through the air speed and back
  // Turned backwards, the air comes from the other side.
  const double path = std::abs(omega) * radius_ / std::numbers::pi;  // n D
  const double travel = omega < 0 ? -axialSpeed : axialSpeed;
  return travel >= (measured->leastAdvance - kSame) * path &&
         travel <= (measured->mostAdvance + kSame) * path;
}

bool BenchedPropeller::knows(double omega, double axialSpeed) const {
  const auto measured = limits(omega);
  const double speed = std::abs(omega);
  return !measured || (speed >= measured->leastSpeed && speed <= measured->mostSpeed &&
                       knowsAdvance(omega, axialSpeed));
}

}  // namespace rotorbench
