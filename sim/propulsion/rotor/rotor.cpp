#include "sim/propulsion/rotor/rotor.h"

#include <Eigen/Core>
#include <cmath>

namespace rotorbench {

RotorConstants::Static RotorConstants::atRest(double w, double density) const {
  if (model == nullptr) {
    const double square = density * w * std::abs(w);
    return {thrust * square, torque * square};
  }
  const auto load =
      model->load<double>(w, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 1, density);
  return {load.thrust, load.torque};
}

void RotorConstants::linearise(double w, double density) {
  if (model == nullptr) return;
  const Static at = atRest(w, density);
  thrust = at.thrust / (density * w * w);
  torque = at.torque / (density * w * w);
}

RotorConstants buildRotor(const RotorParameters& parameters) {
  RotorConstants c;
  std::visit(
      [&c](const auto& a) {
        if constexpr (requires { lumpedModel(a); })
          static_cast<RotorModel<double>&>(c) = lumpedModel(a);
      },
      parameters.aerodynamics);
  c.model = prepareRotor(parameters.aerodynamics);
  c.inertia = parameters.inertia;
  c.inverseInertia = 1 / parameters.inertia;
  return c;
}

void Describe<RotorParameters>::fields(schema::Builder<RotorParameters>& b) {
  using P = RotorParameters;
  b.title("rotor", "Rotor", "A propeller and the motor that turns it.");
  b.variant("aerodynamics", &P::aerodynamics, "Aerodynamics");
  b.number("inertia", &P::inertia, "Spinning inertia", "J", "kg*m^2")
      .range(schema::above(0), schema::upTo(10))
      .help("Of propeller and motor bell about the rotor axis.")
      .source("JSBSim aircraft F450, engine/DJI_9450.xml");
  b.number("mass", &P::mass, "Motor and propeller mass", "m_i", "kg")
      .range(schema::atLeast(0), schema::upTo(100))
      .shownIn("g")
      .help(
          "A point mass at the hub. With mass properties given directly it is part of them and "
          "matters only where an arm deviates.")
      .source("AirSim, MultiRotorParams.hpp: MT2212 motor of an F450 frame");
  b.integer("blades", &P::blades, "Blades", "N_b")
      .range(schema::atLeast(1), schema::upTo(12))
      .help("Only for drawing where the rotor is known by coefficients; a geometry has its own.");
  b.group("motor", &P::motor, "Motor");
  b.group("esc", &P::esc, "Speed controller (ESC)");
}

}  // namespace rotorbench
