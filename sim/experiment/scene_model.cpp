#include "sim/experiment/scene_model.h"

#include <cmath>
#include <numbers>

#include "sim/experiment/experiment.h"
#include "sim/vehicle/vehicle_parameters.h"

namespace rotorbench {

namespace {

using std::numbers::pi;

/// Blade of a propeller known by its diameter only: the planform and constant geometric pitch of a typical
/// moulded 10x4.5 propeller, for drawing and nothing else.
std::vector<DrawnStation> typicalBlade(double radius) {
  constexpr double kPitchPerDiameter = 0.45;
  std::vector<DrawnStation> stations;
  for (int i = 0; i <= 12; ++i) {
    const double x = 0.12 + 0.88 * i / 12.0;
    const double chord = 0.18 * std::sqrt(std::max(0.0, 1 - std::pow((x - 0.35) / 0.68, 2)));
    stations.push_back(
        {x * radius, std::max(0.03, chord) * radius, std::atan(kPitchPerDiameter / (pi * x))});
  }
  return stations;
}

SceneRotor drawnRotor(const RotorPlacement& placement, double radius, int blades) {
  SceneRotor rotor;
  rotor.position = placement.position;
  rotor.axis = placement.axis.normalized();
  rotor.spin = spinSign(placement.spin);
  rotor.radius = radius;
  rotor.blades = blades;
  rotor.stations = typicalBlade(radius);
  rotor.motorRadius = 0.12 * radius;
  rotor.motorHeight = 0.2 * radius;
  return rotor;
}

std::optional<SceneModel> modelOf(const Flight& flight) {
  const MassProperties body = massOf(flight.vehicle, 4);
  SceneModel model;
  double reach = 0;
  for (const auto& hub : rotorsOf(flight.vehicle, 4)) {
    const double radius = rotorRadius(hub.rotor.aerodynamics);
    const PropellerGeometry* geometry = rotorGeometry(hub.rotor.aerodynamics);
    const int blades = geometry != nullptr ? geometry->blades : hub.rotor.blades;
    SceneRotor rotor = drawnRotor(hub.placement, radius, blades);
    // The recorded position is the centre of mass.
    rotor.position -= body.centre;
    reach = std::max(reach, rotor.position.norm());
    model.rotors.push_back(std::move(rotor));
  }
  const auto* parts = std::get_if<PartsMass>(&flight.vehicle.mass);
  model.bodyRadius = parts != nullptr ? parts->bodyRadius : 0.3 * reach;
  // An arrow of full length is twice the thrust that carries the vehicle.
  model.fullThrust = 2 * body.mass * flight.environment.gravity / 4;
  return model;
}

std::optional<SceneModel> modelOf(const BirotorModel& plant) {
  const auto& p = std::visit([](const auto& a) -> const BirotorParameters& { return a; }, plant);
  SceneModel model;
  model.elasticArms = std::holds_alternative<SpringBarParameters>(plant);
  model.fullThrust = std::max({std::abs(p.force1), std::abs(p.force2), 1e-3});
  for (const double side : {-1.0, 1.0}) {
    RotorPlacement placement;
    placement.position = {0, side * p.arm, 0};
    placement.spin = side < 0 ? Spin::CounterClockwise : Spin::Clockwise;
    model.rotors.push_back(drawnRotor(placement, 0.45 * p.arm, 2));
  }
  return model;
}
std::optional<SceneModel> modelOf(const SolverComparison& comparison) {
  return modelOf(comparison.plant);
}
/// A motor on its stand: nothing that flies.
std::optional<SceneModel> modelOf(const MotorBench& /*bench*/) {
  return std::nullopt;
}
std::optional<SceneModel> modelOf(const MotorSpeedRun& /*run*/) {
  return std::nullopt;
}
std::optional<SceneModel> modelOf(const BirotorMotion& motion) {
  return modelOf(motion.plant);
}

}  // namespace

std::optional<SceneModel> sceneModel(const Experiment& experiment) {
  try {
    auto model = std::visit([](const auto& setup) { return modelOf(setup); }, experiment.setup);
    if (model) model->title = experiment.title;
    return model;
  } catch (const InputError&) {
    return std::
        nullopt;  // parameters that no vehicle can have: nothing to draw until they are mended
  }
}

}  // namespace rotorbench
