#include "sim/scene/scene_model.h"

#include "sim/document/experiment.h"
#include "sim/document/kinds.h"
#include "sim/scene/propeller_scene.h"
#include "sim/vehicle/vehicle_parameters.h"

namespace rotorbench {

namespace {

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
  const MassProperties body = massOf(flight.vehicle);
  SceneModel model;
  double reach = 0;
  for (const auto& hub : rotorsOf(flight.vehicle)) {
    const double radius = rotorRadius(hub.rotor.aerodynamics);
    const PropellerGeometry* geometry = rotorGeometry(hub.rotor.aerodynamics);
    const int blades = geometry != nullptr ? geometry->blades : hub.rotor.blades;
    SceneRotor rotor = drawnRotor(hub.placement, radius, blades);
    if (geometry != nullptr) rotor.stations = drawnBlade(*geometry);
    // The recorded position is the centre of mass.
    rotor.position -= body.centre;
    reach = std::max(reach, rotor.position.norm());
    model.rotors.push_back(std::move(rotor));
  }
  const AirConstants air = buildAir(flight.environment);
  if (air.moving) model.wind = air.velocity(0.0, flight.start.position.z());
  const auto* parts = std::get_if<PartsMass>(&flight.vehicle.mass);
  model.bodyRadius = parts != nullptr ? parts->bodyRadius : 0.3 * reach;
  // An arrow of full length is twice the thrust that carries the vehicle.
  model.fullThrust =
      2 * body.mass * flight.environment.gravity / static_cast<double>(model.rotors.size());
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
/// The propeller of a stand; a brake or a free shaft is nothing to look at.
std::optional<SceneModel> modelOf(const DriveStand& stand) {
  if (const auto* load = std::get_if<BladeElementLoad>(&stand.load))
    return standScene(load->propeller);
  if (const auto* load = std::get_if<PropellerLoad>(&stand.load))
    return standScene(load->diameter / 2);
  return std::nullopt;
}
std::optional<SceneModel> modelOf(const MotorBench& bench) {
  return modelOf(bench.stand);
}
std::optional<SceneModel> modelOf(const ThrustStand& stand) {
  return modelOf(stand.stand);
}
std::optional<SceneModel> modelOf(const MotorSpeedRun& run) {
  return modelOf(run.stand);
}
std::optional<SceneModel> modelOf(const PropellerBench& bench) {
  const RotorAerodynamics propeller = aerodynamicsOf(bench.propeller);
  if (const PropellerGeometry* geometry = rotorGeometry(propeller)) return standScene(*geometry);
  return standScene(rotorRadius(propeller));
}
std::optional<SceneModel> modelOf(const BirotorMotion& motion) {
  return modelOf(motion.plant);
}

}  // namespace

std::optional<SceneModel> sceneModel(const Experiment& experiment) {
  try {
    auto model =
        visitAlternative([](const auto& setup) { return modelOf(setup); }, experiment.setup);
    if (model) model->title = experiment.title;
    return model;
  } catch (const InputError&) {
    return std::
        nullopt;  // parameters that no vehicle can have: nothing to draw until they are mended
  }
}

}  // namespace rotorbench
