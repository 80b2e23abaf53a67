#include "sim/vehicle/multirotor.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>

namespace rotorbench {

namespace {

/// Takes what evaluate() passes through into MultirotorForces.
template <int N>
struct ForcesSink {
  MultirotorForces<N>& out;
  using Lanes = Eigen::Array<double, N, 1>;
  void operator()(const Lanes& thrust, const Lanes& torque, const Lanes& voltage,
                  const Eigen::Vector3d& rates, const Eigen::Vector3d& specificForce, double bus,
                  double supplyCurrent) const {
    Eigen::Map<Lanes>(out.thrust.data()) = thrust;
    Eigen::Map<Lanes>(out.torque.data()) = torque;
    Eigen::Map<Lanes>(out.voltage.data()) = voltage;
    out.rates = rates;
    out.specificForce = specificForce;
    out.busVoltage = bus;
    out.supplyCurrent = supplyCurrent;
  }
};

template <int N>
RotorLanes<N> lanesOf(const std::array<typename MultirotorConstants<N>::Hub, N>& hubs) {
  RotorLanes<N> lanes;
  for (std::size_t i = 0; i < N; ++i) {
    const auto& hub = hubs[i];
    const auto lane = static_cast<int>(i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<int>(k);
      lanes.arm[k][lane] = hub.arm[axis];
      lanes.axis[k][lane] = hub.axis[axis];
      lanes.momentum[k][lane] = hub.momentum[axis];
    }
    lanes.spin[lane] = hub.spin;
    lanes.inverseInertia[lane] = hub.rotor.inverseInertia;
    lanes.rotor.thrust[lane] = hub.rotor.thrust;
    lanes.rotor.torque[lane] = hub.rotor.torque;
    lanes.rotor.drag[lane] = hub.rotor.drag;
    lanes.rotor.inflow[lane] = hub.rotor.inflow;
    lanes.rotor.lift[lane] = hub.rotor.lift;
    lanes.rotor.flapping[lane] = hub.rotor.flapping;
    lanes.motor.torqueConstant[lane] = hub.motor.torqueConstant;
    lanes.motor.resistance[lane] = hub.motor.resistance;
    lanes.motor.inverseInductance[lane] = hub.motor.inverseInductance;
    lanes.motor.viscousFriction[lane] = hub.motor.viscousFriction;
    lanes.motor.dryFriction[lane] = hub.motor.dryFriction;
  }
  return lanes;
}

}  // namespace

template <int N>
MultirotorConstants<N> buildMultirotor(const VehicleParameters& vehicle,
                                       const EnvironmentParameters& environment, bool asPlanned) {
  const std::vector<RotorAtHub> rotors = rotorsOf(vehicle, N, asPlanned);
  const MassProperties body = massOf(vehicle, N, asPlanned);
  MultirotorConstants<N> c;
  for (std::size_t i = 0; i < N; ++i) {
    auto& hub = c.hubs[i];
    hub.arm = rotors[i].placement.position - body.centre;
    hub.axis = rotors[i].placement.axis;
    hub.spin = spinSign(rotors[i].placement.spin);
    hub.rotor = buildRotor(rotors[i].rotor);
    hub.motor = buildMotor(rotors[i].rotor.motor);
    hub.momentum = hub.spin * hub.rotor.inertia * hub.axis;
  }
  c.lanes = lanesOf<N>(c.hubs);
  c.mass = body.mass;
  c.inverseMass = 1 / body.mass;
  c.centre = body.centre;
  c.inertia = body.inertia;
  c.inverseInertia = body.inertia.inverse();
  c.gravity = environment.gravity;
  c.air = buildAir(environment.air);
  c.drag = vehicle.drag;
  c.supply = vehicle.supply;
  return c;
}

template <int N, RotorDrive Drive>
void Multirotor<N, Drive>::derivativeAndForces(const State& y, State& dydt,
                                               MultirotorForces<N>& forces) const {
  evaluate(command_, y, dydt, ForcesSink<N>{forces});
  forces.acceleration = dydt.template segment<3>(Layout::kVelocity);
  forces.attitude = eulerAngles(y.template segment<4>(Layout::kAttitude));
}

template <int N, RotorDrive Drive>
void Multirotor<N, Drive>::updateCommand(const State& y, State& dydt,
                                         MultirotorForces<N>& forces) const {
  using L = Layout;
  if constexpr (Drive == RotorDrive::Motors) {
    const LanesOf<double> speed = y.template segment<N>(L::kSpeed).array();
    const LanesOf<double> current = y.template segment<N>(L::kCurrent).array();
    forces.supplyCurrent = LanesOf<double>(command_.array() * current).sum();
    forces.busVoltage =
        constants_.supply.voltage - constants_.supply.internalResistance * forces.supplyCurrent;
    const LanesOf<double> voltage = command_.array() * forces.busVoltage;
    dydt[L::kCharge] = forces.supplyCurrent;
    dydt.template segment<N>(L::kCurrent) =
        constants_.lanes.motor.currentRate(voltage, current, speed).matrix();
    Eigen::Map<LanesOf<double>>(forces.voltage.data()) = voltage;
  } else {
    dydt.template segment<N>(L::kSpeed) = command_;
  }
}

template <int N, RotorDrive Drive>
Eigen::Matrix2d Multirotor<N, Drive>::linear(int i) const {
  Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
  if constexpr (Drive == RotorDrive::Motors) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    const auto& m = hub.motor;
    a << -m.viscousFriction * hub.rotor.inverseInertia, m.torqueConstant * hub.rotor.inverseInertia,
        -m.torqueConstant * m.inverseInductance, -m.resistance * m.inverseInductance;
  }
  return a;
}

template <int N, RotorDrive Drive>
void Multirotor<N, Drive>::setBodyRates(State& y, const Eigen::Vector3d& rates) const {
  Eigen::Vector3d h = constants_.inertia * rates;
  for (int i = 0; i < N; ++i) {
    h += y[Layout::kSpeed + i] * constants_.hubs[static_cast<std::size_t>(i)].momentum;
  }
  y.template segment<3>(Layout::kMomentum) = h;
}

template <int N, RotorDrive Drive>
typename Multirotor<N, Drive>::State Multirotor<N, Drive>::initialState(
    const FlightStart& start) const {
  State y = State::Zero();
  if (start.rotors != RotorStart::Stopped) {
    const Command speeds = start.rotors == RotorStart::Hover
                               ? hoverSpeeds()
                               : Command(Command::Constant(start.rotorSpeed));
    setRotorSpeeds(y, speeds);
    if constexpr (Drive == RotorDrive::Motors) {
      for (int i = 0; i < N; ++i) {
        const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
        const double torque =
            hub.rotor.torque * constants_.air.density(start.position.z()) * speeds[i] * speeds[i];
        y[Layout::kCurrent + i] = hub.motor.steadyCurrent(speeds[i], torque);
      }
    }
  }
  y.template segment<4>(Layout::kAttitude) = quaternionOf(start.attitude);
  y.template segment<3>(Layout::kVelocity) = start.velocity;
  y.template segment<3>(Layout::kPosition) = start.position;
  setBodyRates(y, start.rates);
  return y;
}

template <int N, RotorDrive Drive>
typename Multirotor<N, Drive>::Command Multirotor<N, Drive>::hoverSpeeds() const {
  // Force up and moments of each rotor are linear in the square of its speed.
  Eigen::Matrix<double, 4, N> effect;
  const double density = constants_.air.density(0.0);
  for (int i = 0; i < N; ++i) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    const Eigen::Vector3d force = density * hub.rotor.thrust * hub.axis;
    effect(0, i) = force.z();
    effect.template block<3, 1>(1, i) =
        hub.arm.cross(force) - hub.spin * density * hub.rotor.torque * hub.axis;
  }
  const Eigen::Vector4d load(constants_.mass * constants_.gravity, 0, 0, 0);
  const Command squares = effect.completeOrthogonalDecomposition().solve(load);
  if (!(squares.minCoeff() >= 0) || !squares.allFinite()) {
    throw InputError("vehicle", {{"layout", "the rotors cannot hold the vehicle level",
                                  "rotors around the centre of mass, and air"}});
  }
  return squares.cwiseSqrt();
}

template <int N, RotorDrive Drive>
typename Multirotor<N, Drive>::Command Multirotor<N, Drive>::steadyDuties(
    const Command& speeds) const {
  const double density = constants_.air.density(0.0);
  Command current, voltage;
  for (int i = 0; i < N; ++i) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    current[i] = hub.motor.steadyCurrent(
        speeds[i], density * hub.rotor.torque * speeds[i] * std::abs(speeds[i]));
    voltage[i] = hub.motor.steadyVoltage(speeds[i], current[i]);
  }
  // Bus voltage b: b = V - R_s sum(d i) with d = v/b, so b^2 - V b + R_s P = 0; the upper root is
  // the stable one.
  const auto& s = constants_.supply;
  const double power = voltage.dot(current);
  const double root = s.voltage * s.voltage - 4 * s.internalResistance * power;
  const double bus = 0.5 * (s.voltage + std::sqrt(std::max(0.0, root)));
  return voltage / bus;
}

template <int N, RotorDrive Drive>
std::string Multirotor<N, Drive>::componentName(int index) {
  using L = Layout;
  const auto axis = [&](const char* name, int first) {
    return std::string(name) + "." + "xyz"[index - first];
  };
  const auto rotor = [&](int first, const char* name) {
    return "rotor" + std::to_string(index - first + 1) + "." + name;
  };
  if (index < L::kCurrent) return rotor(L::kSpeed, "speed");
  if (index < L::kAttitude) return rotor(L::kCurrent, "current");
  if (index < L::kMomentum) return std::string("attitude.") + "wxyz"[index - L::kAttitude];
  if (index < L::kVelocity) return axis("momentum", L::kMomentum);
  if (index < L::kPosition) return axis("velocity", L::kVelocity);
  if (index < L::kCharge) return axis("position", L::kPosition);
  return "supply.charge";
}

Eigen::Vector3d eulerAngles(const Eigen::Vector4d& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double sine = std::clamp(2 * (w * y - z * x), -1.0, 1.0);
  return {std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), std::asin(sine),
          std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))};
}

Eigen::Vector4d quaternionOf(const Eigen::Vector3d& a) {
  const Eigen::Quaterniond q = Eigen::AngleAxisd(a.z(), Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(a.y(), Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(a.x(), Eigen::Vector3d::UnitX());
  return {q.w(), q.x(), q.y(), q.z()};
}

template MultirotorConstants<4> buildMultirotor<4>(const VehicleParameters&,
                                                   const EnvironmentParameters&, bool);
template class Multirotor<4, RotorDrive::Motors>;
template class Multirotor<4, RotorDrive::PrescribedSpeeds>;

}  // namespace rotorbench
