// Definitions of what multirotor.h declares. Included by the one source of each rotor count.
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "sim/vehicle/multirotor.h"

namespace rotorbench {

namespace detail {

/// Takes what evaluate() passes through into MultirotorForces.
template <int N>
struct ForcesSink {
  MultirotorForces<N>& out;
  using Lanes = Eigen::Array<double, N, 1>;
  template <class Electrical, class Flow>
  void operator()(const Lanes& thrust, const Lanes& torque, const Electrical& power,
                  const Flow& flow, const Eigen::Vector3d& specificForce) const {
    Eigen::Map<Lanes>(out.thrust.data()) = thrust;
    Eigen::Map<Lanes>(out.torque.data()) = torque;
    Eigen::Map<Lanes>(out.duty.data()) = power.duty;
    Eigen::Map<Lanes>(out.voltage.data()) = power.voltage;
    out.rates = flow.rates;
    out.specificForce = specificForce;
    out.busVoltage = power.bus;
    out.supplyCurrent = power.supplyCurrent;
    out.wind = flow.air.velocity;
    out.density = flow.air.density;
  }
};

/// V below which a speed controller gives other than its duty asks for. A passive one that is
/// reversible has to look each time which way it drives.
inline double leastExcess(const EscConstants& esc, const MotorConstants& motor) {
  if (esc.activeBraking) return -motor.resistance * esc.maxCurrent;
  return esc.least < 0 ? std::numeric_limits<double>::infinity() : 0;
}

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
    lanes.escResistance[lane] = hub.esc.resistance;
    lanes.mostExcess[lane] = hub.motor.resistance * hub.esc.maxCurrent;
    lanes.leastExcess[lane] = leastExcess(hub.esc, hub.motor);
    lanes.duty.inverseResponse[lane] = hub.esc.inverseResponse;
    lanes.duty.direct[lane] = hub.esc.direct;
    lanes.duty.least[lane] = hub.esc.least;
    lanes.rotor.thrust[lane] = hub.rotor.thrust;
    lanes.rotor.torque[lane] = hub.rotor.torque;
    lanes.rotor.drag[lane] = hub.rotor.drag;
    lanes.rotor.inflow[lane] = hub.rotor.inflow;
    lanes.rotor.lift[lane] = hub.rotor.lift;
    lanes.rotor.flapping[lane] = hub.rotor.flapping;
    lanes.rotor.discs[lane] = hub.rotor.discs;
    lanes.rotor.lifting = lanes.rotor.lifting || hub.rotor.lifting;
    lanes.motor.torqueConstant[lane] = hub.motor.torqueConstant;
    lanes.motor.resistance[lane] = hub.motor.resistance;
    lanes.motor.inverseInductance[lane] = hub.motor.inverseInductance;
    lanes.motor.viscousFriction[lane] = hub.motor.viscousFriction;
    lanes.motor.dryFriction[lane] = hub.motor.dryFriction;
  }
  return lanes;
}

/// Squares of the rotor speeds that hover, which may be negative or no numbers where none do. Force
/// up and moments of each rotor are linear in the square of its speed, as far as its coefficients
/// are constant.
template <int N>
Eigen::Matrix<double, N, 1> hoverSquares(const MultirotorConstants<N>& c) {
  Eigen::Matrix<double, 4, N> effect;
  const double density = c.air.density(0.0);
  for (int i = 0; i < N; ++i) {
    const auto& hub = c.hubs[static_cast<std::size_t>(i)];
    const Eigen::Vector3d force = density * hub.rotor.thrust * hub.axis;
    effect(0, i) = force.z();
    effect.template block<3, 1>(1, i) =
        hub.arm.cross(force) - hub.spin * density * hub.rotor.torque * hub.axis;
  }
  const Eigen::Vector4d load(c.mass * c.gravity, 0, 0, 0);
  return effect.completeOrthogonalDecomposition().solve(load);
}

/// Brings the thrust and torque factors of all rotors to the speeds at which they hover:
/// coefficients and speeds are worked out in turn, which converges fast, the ones changing little
/// with the others. Where nothing hovers the factors are those of half the highest speed.
template <int N>
void lineariseAtHover(MultirotorConstants<N>& c) {
  const double sea = c.air.density(0.0), density = sea > 0 ? sea : kStandardDensity;
  std::array<double, N> half;
  for (std::size_t i = 0; i < N; ++i) {
    half[i] = 0.5 * c.openCircuit / c.hubs[i].motor.torqueConstant;
    c.hubs[i].rotor.linearise(half[i], density);
  }
  if (!(sea > 0)) return;
  constexpr int kMostRounds = 60;
  constexpr double kClose = 1e-14;
  std::array<double, N> speeds = half;
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::Matrix<double, N, 1> squares = hoverSquares(c);
    double change = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const double square = squares[static_cast<int>(i)];
      const bool hovers = square > 0 && std::isfinite(square);
      const double next = hovers ? std::sqrt(square) : half[i];
      change = std::max(change, std::abs(next / speeds[i] - 1));
      speeds[i] = next;
      c.hubs[i].rotor.linearise(next, density);
    }
    if (change < kClose) return;
  }
}

}  // namespace detail

template <int N>
MultirotorConstants<N> buildMultirotor(const VehicleParameters& vehicle,
                                       const EnvironmentParameters& environment, bool asPlanned) {
  const std::vector<RotorAtHub> rotors = rotorsOf(vehicle, asPlanned);
  if (rotors.size() != static_cast<std::size_t>(N)) {
    throw InputError({}, {{"layout", "has " + std::to_string(rotors.size()) + " rotors",
                           std::to_string(N) + " rotors"}});
  }
  const MassProperties body = massOf(vehicle, asPlanned);
  MultirotorConstants<N> c;
  for (std::size_t i = 0; i < N; ++i) {
    auto& hub = c.hubs[i];
    hub.arm = rotors[i].placement.position - body.centre;
    hub.axis = rotors[i].placement.axis;
    hub.spin = spinSign(rotors[i].placement.spin);
    hub.rotor = buildRotor(rotors[i].rotor);
    hub.motor = buildMotor(rotors[i].rotor.motor);
    hub.esc = buildEsc(rotors[i].rotor.esc, hub.motor);
    hub.motor.maxCurrent = hub.esc.maxCurrent;
    hub.deadTime = rotors[i].rotor.esc.deadTime;
    hub.momentum = hub.spin * hub.rotor.inertia * hub.axis;
  }
  c.mass = body.mass;
  c.inverseMass = 1 / body.mass;
  c.centre = body.centre;
  c.inertia = body.inertia;
  c.inverseInertia = body.inertia.inverse();
  c.gravity = environment.gravity;
  c.air = buildAir(environment);
  c.drag = vehicle.drag;
  c.supply = Supply(vehicle.supply);
  c.avionicsPower = vehicle.avionicsPower;
  c.openCircuit = c.supply.openCircuit(c.supply.charge);
  c.lumped =
      std::ranges::all_of(c.hubs, [](const auto& hub) { return hub.rotor.model == nullptr; });
  c.passive = std::ranges::any_of(c.hubs, [](const auto& hub) { return !hub.esc.activeBraking; });
  c.lossy = std::ranges::any_of(c.hubs, [](const auto& hub) { return hub.esc.lossy(); });
  if (!c.lumped) detail::lineariseAtHover(c);
  c.lanes = detail::lanesOf<N>(c.hubs);
  return c;
}

template <int N, RotorDrive Drive>
void Multirotor<N, Drive>::derivativeAndForces(double t, const State& y, State& dydt,
                                               MultirotorForces<N>& forces) const {
  evaluate(t, command_, y, dydt, detail::ForcesSink<N>{forces});
  forces.acceleration = dydt.template segment<3>(Layout::kVelocity);
  forces.attitude = eulerAngles(y.template segment<4>(Layout::kAttitude));
  forces.stateOfCharge = stateOfCharge(y);
}

template <int N, RotorDrive Drive>
void Multirotor<N, Drive>::updateCommand(const State& y, State& dydt,
                                         MultirotorForces<N>& forces) const {
  using L = Layout;
  if constexpr (Drive == RotorDrive::Motors) {
    const LanesOf<double> speed = y.template segment<N>(L::kSpeed).array();
    const LanesOf<double> current = y.template segment<N>(L::kCurrent).array();
    const Electrical<double> at = electrical<double>(command_, y);
    const Supply& supply = constants_.supply;
    forces.supplyCurrent = at.supplyCurrent;
    forces.busVoltage = at.bus;
    dydt[L::kCharge] = at.supplyCurrent;
    dydt[L::kPolarisation] = (supply.polarisation * at.supplyCurrent - y[L::kPolarisation]) *
                             supply.inversePolarisationTime;
    dydt[L::kEnergy] = at.bus * at.supplyCurrent;
    dydt.template segment<N>(L::kCurrent) =
        constants_.lanes.motor.currentRate(at.voltage, current, speed).matrix();
    const LanesOf<double> commanded = command_.array(),
                          follows = y.template segment<N>(L::kDuty).array();
    dydt.template segment<N>(L::kDuty) = constants_.lanes.duty.rate(commanded, follows).matrix();
    Eigen::Map<LanesOf<double>>(forces.voltage.data()) = at.voltage;
    Eigen::Map<LanesOf<double>>(forces.duty.data()) = at.duty;
  } else {
    dydt.template segment<N>(L::kSpeed) = command_;
  }
}

template <int N, RotorDrive Drive>
void Multirotor<N, Drive>::settle(State& y) const {
  if constexpr (Drive == RotorDrive::Motors) {
    for (int i = 0; i < N; ++i) {
      const EscConstants& esc = constants_.hubs[static_cast<std::size_t>(i)].esc;
      double& duty = y[Layout::kDuty + i];
      duty = esc.duty(command_[i], duty);
      esc.settle(duty, y[Layout::kCurrent + i]);
    }
  }
}

template <int N, RotorDrive Drive>
FlightPowers Multirotor<N, Drive>::powers(double t, const State& y) const {
  using L = Layout;
  State rate;
  MultirotorForces<N> forces{};
  derivativeAndForces(t, y, rate, forces);
  FlightPowers p{};
  const double i = forces.supplyCurrent;
  p.source = openCircuit(y) * i;
  p.supplyLoss = constants_.supply.resistance * i * i + y[L::kPolarisation] * i;
  if (Drive == RotorDrive::Motors && constants_.avionicsPower > 0) {
    // All of it, or what a supply too weak for it still gives.
    double delivered = forces.busVoltage * i;
    for (int k = 0; k < N; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double current = y[L::kCurrent + k];
      delivered -= converterPower(forces.voltage[at], constants_.hubs[at].esc.resistance, current);
    }
    p.avionics = std::min(constants_.avionicsPower, delivered);
  }
  if (constants_.lossy) p.escLoss = forces.busVoltage * i - p.avionics;
  for (int k = 0; k < N; ++k) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(k)];
    const double w = y[L::kSpeed + k], current = y[L::kCurrent + k];
    p.escLoss += constants_.lossy ? -forces.voltage[static_cast<std::size_t>(k)] * current
                                  : hub.esc.resistance * current * current;
    p.copperLoss += hub.motor.resistance * current * current;
    p.frictionLoss += hub.motor.friction(w) * w;
    p.shaft += forces.torque[static_cast<std::size_t>(k)] * w;
    p.magnetic += hub.motor.inductance * current * rate[L::kCurrent + k];
    p.kinetic += hub.rotor.inertia * w * rate[L::kSpeed + k];
  }
  return p;
}

template <int N, RotorDrive Drive>
Eigen::Matrix2d Multirotor<N, Drive>::linear(int i) const {
  Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
  if constexpr (Drive == RotorDrive::PrescribedSpeeds) return a;
  if (i >= N) {
    const auto& inverseResponse = constants_.lanes.duty.inverseResponse;
    a.diagonal() << -inverseResponse[2 * (i - N)], -inverseResponse[2 * (i - N) + 1];
    return a;
  }
  const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
  const auto& m = hub.motor;
  a << -m.viscousFriction * hub.rotor.inverseInertia, m.torqueConstant * hub.rotor.inverseInertia,
      -m.torqueConstant * m.inverseInductance,
      -(m.resistance + hub.esc.resistance) * m.inverseInductance;
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
  return initialState(start,
                      start.rotors == RotorStart::Hover ? hoverSpeeds() : Command(Command::Zero()));
}

template <int N, RotorDrive Drive>
typename Multirotor<N, Drive>::State Multirotor<N, Drive>::initialState(
    const FlightStart& start, const Command& hover) const {
  State y = State::Zero();
  if (start.rotors != RotorStart::Stopped) {
    const Command speeds =
        start.rotors == RotorStart::Hover ? hover : Command(Command::Constant(start.rotorSpeed));
    setRotorSpeeds(y, speeds);
    if constexpr (Drive == RotorDrive::Motors) {
      const double density = constants_.air.density(start.position.z());
      y.template segment<N>(Layout::kDuty) = allowed(steadyDuties(speeds, density));
      for (int i = 0; i < N; ++i) {
        const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
        const double torque = hub.rotor.atRest(speeds[i], density).torque;
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
  if (!(constants_.air.density(0.0) > 0) && constants_.gravity > 0) {
    throw InputError({}, {{{},
                           "cannot hover where there is no air",
                           "an air density above 0, or rotors that start stopped or at a speed"}});
  }
  const Command squares = detail::hoverSquares(constants_);
  if (!(squares.minCoeff() >= 0) || !squares.allFinite()) {
    throw InputError({}, {{"layout", "the rotors cannot hold the vehicle level",
                           "rotors around the centre of mass, and air"}});
  }
  return squares.cwiseSqrt();
}

template <int N, RotorDrive Drive>
typename Multirotor<N, Drive>::Command Multirotor<N, Drive>::steadyDuties(
    const Command& speeds) const {
  return steadyDuties(speeds, constants_.air.density(0.0));
}

template <int N, RotorDrive Drive>
typename Multirotor<N, Drive>::Command Multirotor<N, Drive>::steadyDuties(const Command& speeds,
                                                                          double density) const {
  Command current, voltage, duty;
  double losses = 0;
  for (int i = 0; i < N; ++i) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    current[i] = hub.motor.steadyCurrent(speeds[i], hub.rotor.atRest(speeds[i], density).torque);
    voltage[i] = hub.drive().steadyVoltage(speeds[i], current[i]);
  }
  const double power = voltage.dot(current) + constants_.avionicsPower;
  const double r = constants_.supply.resistance;
  const double bus = busVoltage(constants_.openCircuit, power, r);
  if (!constants_.lossy) return voltage / bus;
  for (int i = 0; i < N; ++i) {
    const EscConstants& esc = constants_.hubs[static_cast<std::size_t>(i)].esc;
    losses += steadyLoss(esc, voltage[i] / bus, current[i], bus);
  }
  const double under = busVoltage(constants_.openCircuit, power + losses, r);
  for (int i = 0; i < N; ++i) {
    const EscConstants& esc = constants_.hubs[static_cast<std::size_t>(i)].esc;
    duty[i] = dutyForShare(esc, voltage[i] / under, current[i], under);
  }
  return duty;
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
  if (index < L::kDuty) return rotor(L::kCurrent, "current");
  if (index < L::kAttitude) return rotor(L::kDuty, "duty");
  if (index < L::kMomentum) return std::string("attitude.") + "wxyz"[index - L::kAttitude];
  if (index < L::kVelocity) return axis("momentum", L::kMomentum);
  if (index < L::kPosition) return axis("velocity", L::kVelocity);
  if (index < L::kCharge) return axis("position", L::kPosition);
  if (index == L::kCharge) return "supply.charge";
  return index == L::kPolarisation ? "supply.polarisation" : "supply.energy";
}

}  // namespace rotorbench
