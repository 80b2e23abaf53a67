#include "sim/sizing/steady_flight.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "sim/numerics/bracketed_root.h"

namespace rotorbench {

namespace {

constexpr int kNewtonSteps = 30;
constexpr double kConverged = 1e-9;   // accelerations over g
constexpr double kDifference = 1e-6;  // of the scaled unknowns
constexpr int kTrimSpeeds = 64;

}  // namespace

double Trim::tilt() const {
  return std::acos(std::clamp(std::cos(roll) * std::cos(pitch), -1.0, 1.0));
}

SteadyFlight::SteadyFlight(const VehicleParameters& vehicle,
                           const EnvironmentParameters& environment)
    : constants_(buildMultirotor<kVehicleRotors>(vehicle, environment)), supply_(vehicle.supply) {
  const auto rotors = rotorsOf(vehicle, kVehicleRotors);
  arm_ = 0;
  for (std::size_t i = 0; i < kVehicleRotors; ++i) {
    motors_[i] = rotors[i].rotor.motor;
    escs_[i] = rotors[i].rotor.esc;
    currentLimits_[i] = std::min(motors_[i].maxCurrent, escs_[i].maxCurrent);
    radii_[i] = rotorRadius(rotors[i].rotor.aerodynamics);
    arm_ = std::max(arm_, constants_.hubs[i].arm.norm());
  }
}

SteadyFlight SteadyFlight::withMass(double mass) const {
  SteadyFlight other = *this;
  other.constants_.mass = mass;
  other.constants_.inverseMass = 1 / mass;
  return other;
}

SteadyFlight SteadyFlight::withDensity(double density) const {
  SteadyFlight other = *this;
  other.constants_.air.seaLevelDensity = density;
  return other;
}

SteadyFlight::Evaluated SteadyFlight::evaluate(const Unknowns& x, double speed) const {
  using L = Vehicle::Layout;
  const Vehicle vehicle(constants_);
  Vehicle::State y = Vehicle::State::Zero(), rate;
  y.segment<4>(L::kAttitude) = quaternionOf({x[4], x[5], 0});
  y[L::kVelocity] = speed;
  Vehicle::setRotorSpeeds(y, scale_ * x.head<4>());
  vehicle.setBodyRates(y, Eigen::Vector3d::Zero());
  Evaluated e;
  vehicle.derivativeAndForces(y, rate, e.forces);
  e.residual.head<3>() = rate.segment<3>(L::kVelocity) / constants_.gravity;
  e.residual.tail<3>() = rate.segment<3>(L::kMomentum) / (weight() * arm_);
  return e;
}

std::optional<Trim> SteadyFlight::trim(double speed, const Trim& near) const {
  SteadyFlight scaled = *this;
  scaled.scale_ = std::max(near.rotors.mean(), 1e-3);
  Unknowns x;
  x << near.rotors / scaled.scale_, near.roll, near.pitch;
  Evaluated at = scaled.evaluate(x, speed);
  for (int k = 0; k < kNewtonSteps && at.residual.cwiseAbs().maxCoeff() > kConverged; ++k) {
    Eigen::Matrix<double, 6, 6> jacobian;
    for (int c = 0; c < 6; ++c) {
      Unknowns moved = x;
      moved[c] += kDifference;
      jacobian.col(c) = (scaled.evaluate(moved, speed).residual - at.residual) / kDifference;
    }
    const Unknowns step = jacobian.completeOrthogonalDecomposition().solve(at.residual);
    double share = 1;
    Evaluated next = scaled.evaluate(x - step, speed);
    while (!(next.residual.norm() < at.residual.norm()) && share > 1e-3) {
      share /= 2;
      next = scaled.evaluate(x - share * step, speed);
    }
    if (!(next.residual.norm() < at.residual.norm())) break;
    x -= share * step;
    at = next;
  }
  const double left = at.residual.cwiseAbs().maxCoeff();
  if (!(left <= 1e3 * kConverged) || !(x.head<4>().minCoeff() >= 0)) return std::nullopt;
  return Trim{speed,
              scaled.scale_ * x.head<4>(),
              x[4],
              x[5],
              at.forces.thrust,
              at.forces.torque,
              left * constants_.gravity};
}

std::optional<Trim> SteadyFlight::hover() const {
  Trim start;
  try {
    start.rotors = Vehicle(constants_).hoverSpeeds();
  } catch (const InputError&) {
    // Tilted rotors may still hold it at an angle: Newton's method looks from equal speeds on.
    start.rotors.setConstant(std::sqrt(weight() / kVehicleRotors /
                                       std::max(1e-12, staticLoad(0, 1000).thrust.at(1000.0))));
  }
  return trim(0, start);
}

DriveDemand SteadyFlight::demand(const Trim& trim) const {
  DriveDemand d;
  for (int i = 0; i < kVehicleRotors; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const MotorConstants& motor = constants_.hubs[k].motor;
    const double w = trim.rotors[i];
    d.current[i] = motor.steadyCurrent(w, trim.torque[k]);
    const double terminal = motor.steadyVoltage(w, d.current[i]);
    d.voltage[i] = terminal + escs_[k].resistance * d.current[i];
    d.motorPower += terminal * d.current[i];
    d.shaftPower += trim.torque[k] * w;
  }
  d.power = d.voltage.dot(d.current);
  return d;
}

/// Thrust and torque at rest over the speed, read from the vehicle's equations with all rotors at
/// one speed.
ShaftLoad SteadyFlight::staticLoad(std::size_t rotor, double topSpeed) const {
  ShaftLoad load;
  load.quadratic = load.thrust = {topSpeed / kTrimSpeeds, {}};
  for (int k = 0; k <= kTrimSpeeds; ++k) {
    const double w = topSpeed * std::max(k, 1) / kTrimSpeeds;
    Unknowns x = Unknowns::Zero();
    x.head<4>().setConstant(w / scale_);
    const Evaluated at = evaluate(x, 0);
    load.quadratic.values.push_back(at.forces.torque[rotor] / (w * w));
    load.thrust.values.push_back(at.forces.thrust[rotor] / (w * w));
  }
  return load;
}

FullThrottle SteadyFlight::fullThrottle() const {
  const double inner = supply_.openCircuit(supply_.charge);
  std::array<ShaftLoad, kVehicleRotors> loads;
  for (std::size_t i = 0; i < kVehicleRotors; ++i) {
    loads[i] = staticLoad(i, inner * motors_[i].speedConstant);
  }
  const auto at = [&](double bus) {
    FullThrottle f;
    f.busVoltage = bus;
    f.openCircuit = inner;
    for (int i = 0; i < kVehicleRotors; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const DriveTrain train({.supply = SupplyParameters{bus, 0},
                              .esc = escs_[k],
                              .motor = motors_[k],
                              .load = loads[k],
                              .inertia = constants_.hubs[k].rotor.inertia});
      const auto y = train.steadyState(1, 1, 0);
      const auto electrical = train.instant(y);
      f.speeds[i] = y[DriveTrain::kSpeed];
      f.currents[i] = electrical.current;
      f.currentLimited |= electrical.current >= train.maxCurrent() * (1 - 1e-12);
      f.current += electrical.busCurrent;
      f.thrust += loads[k].thrustAt(f.speeds[i]) * constants_.hubs[k].axis.z();
    }
    f.power = bus * f.current;
    return f;
  };
  if (!(supply_.resistance > 0)) return at(inner);
  const auto surplus = [&](double bus) {
    return inner - supply_.resistance * at(bus).current - bus;
  };
  const double least = 1e-6 * inner, top = surplus(inner);
  if (!(top < 0)) return at(inner);
  return at(bracketedRoot(surplus, least, surplus(least), inner, top, 1e-10 * inner));
}

}  // namespace rotorbench
