#include "sim/sizing/steady_flight.h"

#include <algorithm>
#include <cmath>

#include "sim/numerics/scalar_search.h"

namespace rotorbench {

namespace {

constexpr int kStaticSpeeds = 64;

}  // namespace

SteadyFlight::SteadyFlight(const VehicleParameters& vehicle,
                           const EnvironmentParameters& environment)
    : constants_(withRotorCount(
          rotorCount(vehicle.layout),
          [&](auto count) -> Constants { return buildMultirotor<count>(vehicle, environment); })),
      supply_(vehicle.supply) {
  const auto described = rotorsOf(vehicle);
  std::visit(
      [&](const auto& constants) {
        for (const RotorHub& hub : constants.hubs) {
          const RotorParameters& rotor = described[rotors_.size()].rotor;
          rotors_.push_back({hub, rotor.motor, rotor.esc,
                             std::min(rotor.motor.maxCurrent, rotor.esc.maxCurrent),
                             rotorRadius(rotor.aerodynamics)});
        }
      },
      constants_);
}

SteadyFlight SteadyFlight::withMass(double mass) const {
  SteadyFlight other = *this;
  std::visit([mass](auto& c) { c.mass = mass, c.inverseMass = 1 / mass; }, other.constants_);
  return other;
}

SteadyFlight SteadyFlight::withDensity(double density) const {
  SteadyFlight other = *this;
  std::visit([density](auto& c) { c.air.standard = false, c.air.uniform = density; },
             other.constants_);
  return other;
}

double SteadyFlight::mass() const {
  return std::visit([](const auto& c) { return c.mass; }, constants_);
}
double SteadyFlight::weight() const {
  return std::visit([](const auto& c) { return c.mass * c.gravity; }, constants_);
}
double SteadyFlight::avionicsPower() const {
  return std::visit([](const auto& c) { return c.avionicsPower; }, constants_);
}
double SteadyFlight::density() const {
  return std::visit([](const auto& c) { return c.air.density(0.0); }, constants_);
}

std::optional<Trim> SteadyFlight::trim(double speed, const Trim& near) const {
  return std::visit([&](const auto& c) { return trimmedFlight(c, speed, near); }, constants_);
}

std::optional<Trim> SteadyFlight::hover() const {
  return std::visit([](const auto& c) { return trimmedHover(c); }, constants_);
}

DriveDemand SteadyFlight::demand(const Trim& trim) const {
  DriveDemand d;
  d.current.resize(rotors());
  d.voltage.resize(rotors());
  for (int i = 0; i < rotors(); ++i) {
    const MotorConstants& motor = at(i).hub.motor;
    const double w = trim.speeds[i];
    d.current[i] = motor.steadyCurrent(w, trim.torque[i]);
    const double terminal = motor.steadyVoltage(w, d.current[i]);
    d.voltage[i] = terminal + at(i).esc.resistance * d.current[i];
    d.motorPower += terminal * d.current[i];
    d.shaftPower += trim.torque[i] * w;
  }
  d.power = d.voltage.dot(d.current) + avionicsPower();
  const double bus = supply_.openCircuit(supply_.charge);
  for (int i = 0; i < rotors(); ++i) {
    const EscConstants& esc = at(i).hub.esc;
    if (esc.lossy()) d.power += steadyLoss(esc, d.voltage[i] / bus, d.current[i], bus);
  }
  return d;
}

ShaftLoad SteadyFlight::Rotor::staticLoad(double topSpeed, double density) const {
  ShaftLoad load;
  load.quadratic = load.thrust = {topSpeed / kStaticSpeeds, {}};
  for (int k = 0; k <= kStaticSpeeds; ++k) {
    const double w = topSpeed * std::max(k, 1) / kStaticSpeeds;
    const RotorConstants::Static still = hub.rotor.atRest(w, density);
    load.quadratic.values.push_back(still.torque / (w * w));
    load.thrust.values.push_back(still.thrust / (w * w));
  }
  return load;
}

FullThrottle SteadyFlight::fullThrottle() const {
  const double inner = supply_.openCircuit(supply_.charge);
  std::vector<ShaftLoad> loads;
  for (const Rotor& rotor : rotors_)
    loads.push_back(rotor.staticLoad(inner * rotor.motor.speedConstant, density()));
  const auto under = [&](double bus) {
    FullThrottle f;
    f.busVoltage = bus;
    f.openCircuit = inner;
    f.speeds.resize(rotors());
    f.currents.resize(rotors());
    for (int i = 0; i < rotors(); ++i) {
      const Rotor& rotor = at(i);
      const ShaftLoad& load = loads[static_cast<std::size_t>(i)];
      const DriveTrain train({.supply = SupplyParameters{bus, 0},
                              .esc = rotor.esc,
                              .motor = rotor.motor,
                              .load = load,
                              .inertia = rotor.hub.rotor.inertia});
      const auto y = train.steadyState(1, 1, 0);
      const auto electrical = train.instant(y);
      f.speeds[i] = y[DriveTrain::kSpeed];
      f.currents[i] = electrical.current;
      f.currentLimited |= electrical.current >= train.maxCurrent() * (1 - 1e-12);
      f.current += electrical.busCurrent;
      f.thrust += load.thrustAt(f.speeds[i]) * rotor.hub.axis.z();
    }
    f.current += avionicsPower() / bus;
    f.power = bus * f.current;
    return f;
  };
  if (!(supply_.resistance > 0)) return under(inner);
  const auto surplus = [&](double bus) {
    return inner - supply_.resistance * under(bus).current - bus;
  };
  const double least = 1e-6 * inner, top = surplus(inner);
  if (!(top < 0)) return under(inner);
  return under(findRoot(surplus, least, surplus(least), inner, top, 1e-10 * inner));
}

}  // namespace rotorbench
