#include "sim/scene/propeller_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rotorbench {

using std::numbers::pi;

namespace {

SceneModel sceneOf(std::vector<DrawnStation> stations, double tip, int blades, double hubRadius) {
  SceneRotor rotor;
  rotor.position.setZero();
  rotor.axis = Eigen::Vector3d::UnitZ();
  rotor.spin = 1;
  rotor.radius = tip;
  rotor.blades = blades;
  rotor.stations = std::move(stations);
  rotor.motorRadius = 0.8 * hubRadius;
  rotor.motorHeight = 0.06 * tip;
  SceneModel model;
  model.rotors.push_back(std::move(rotor));
  return model;
}

SceneModel onStand(SceneModel model) {
  constexpr double kHeight = 0.7;                     // of the pole over the radius
  constexpr double kThrust = 0.1, kTipSpeed = 120.0;  // CT and m/s of an arrow of full length
  SceneRotor& rotor = model.rotors.front();
  rotor.position.z() = kHeight * rotor.radius;
  rotor.motorHeight *= 3;
  const double turns = kTipSpeed / (2 * pi * rotor.radius);
  model.fullThrust = kThrust * 1.225 * turns * turns * std::pow(2 * rotor.radius, 4);
  model.onStand = true;
  return model;
}

}  // namespace

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
  return sceneOf(drawnBlade(geometry), tip, geometry.blades, geometry.rootRadius * tip);
}

SceneModel standScene(const PropellerGeometry& geometry) {
  return onStand(propellerScene(geometry));
}

SceneModel standScene(double radius) {
  constexpr double kHub = 0.12;  // where the typical blade begins, r/R
  return onStand(sceneOf(typicalBlade(radius), radius, 2, kHub * radius));
}

}  // namespace rotorbench
