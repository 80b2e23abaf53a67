#include "sim/experiment/propeller_scene.h"

namespace rotorbench {

std::vector<DrawnStation> drawnBlade(const PropellerGeometry& geometry) {
  constexpr int kSteps = 24;
  const double tip = geometry.diameter / 2, blend = nominalPitchBlend(geometry);
  std::vector<DrawnStation> stations;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = geometry.rootRadius + (1 - geometry.rootRadius) * i / kSteps;
    const BladeShape shape = bladeShape(geometry, x, blend);
    stations.push_back({x * tip, shape.chord * tip, shape.twist});
  }
  return stations;
}

SceneModel propellerScene(const PropellerGeometry& geometry) {
  const double tip = geometry.diameter / 2;
  SceneRotor rotor;
  rotor.position.setZero();
  rotor.axis = Eigen::Vector3d::UnitZ();
  rotor.spin = 1;
  rotor.radius = tip;
  rotor.blades = geometry.blades;
  rotor.stations = drawnBlade(geometry);
  rotor.motorRadius = 0.8 * geometry.rootRadius * tip;
  rotor.motorHeight = 0.06 * tip;
  SceneModel model;
  model.rotors.push_back(std::move(rotor));
  return model;
}

}  // namespace rotorbench
