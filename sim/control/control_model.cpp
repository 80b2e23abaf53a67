#include "sim/control/control_model.h"

#include <cmath>

namespace rotorbench {

double topSpeed(const MotorConstants& motor, double torqueFactor, double voltage) {
  const auto holds = [&](double w) {
    const double current = motor.steadyCurrent(w, torqueFactor * w * w);
    return current <= motor.maxCurrent && motor.steadyVoltage(w, current) <= voltage;
  };
  // Demand grows with speed, and no motor turns faster than without load: halve that interval.
  double low = 0, high = voltage / motor.torqueConstant;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

template <int N>
ControlModel<N> controlModel(const MultirotorConstants<N>& c) {
  ControlModel<N> m;
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

template ControlModel<4> controlModel<4>(const MultirotorConstants<4>&);

}  // namespace rotorbench
