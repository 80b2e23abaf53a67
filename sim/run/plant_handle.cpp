#include "sim/run/plant_handle.h"

#include "sim/run/multirotor_plants.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

namespace {

template <int N>
ControlModel controlModelOf(const MultirotorConstants<N>& c) {
  ControlModel m;
  m.rotors = N;
  m.mass = c.mass;
  m.gravity = c.gravity;
  m.inertia = c.inertia;
  m.inverseInertia = c.inverseInertia;
  const double density = c.air.density(0.0);
  for (std::size_t i = 0; i < N; ++i) {
    const auto& hub = c.hubs[i];
    m.thrustFactor[i] = density * hub.rotor.thrust;
    m.torqueFactor[i] = density * hub.rotor.torque;
    m.rotorInertia[i] = hub.rotor.inertia;
    m.motors[i] = hub.drive();
    m.escs[i] = hub.esc;
    const double top = topSpeed(m.motors[i], m.torqueFactor[i], c.openCircuit);
    m.maxThrust[i] = m.thrustFactor[i] * top * top;
    const Eigen::Vector3d moment =
        hub.arm.cross(hub.axis) - hub.spin * (hub.rotor.torque / hub.rotor.thrust) * hub.axis;
    m.effect.col(static_cast<Eigen::Index>(i)) << hub.axis.z(), moment;
  }
  return m;
}

template <class Make>
auto at(const Place& place, Make&& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw place.error(error.problems());
  }
}

}  // namespace

std::unique_ptr<PlantHandle> makePlant(const Flight& flight, RotorDrive drive,
                                       const Place& vehicle) {
  return at(vehicle, [&] {
    return withRotorCount(rotorCount(flight.vehicle.layout),
                          [&](auto count) { return makeMultirotor<count>(flight, drive); });
  });
}

ControlModel controlModel(const VehicleParameters& vehicle,
                          const EnvironmentParameters& environment, const Place& place) {
  return at(place, [&] {
    return withRotorCount(rotorCount(vehicle.layout), [&](auto count) {
      return controlModelOf(buildMultirotor<count>(vehicle, environment, true));
    });
  });
}

}  // namespace rotorbench
