#include "sim/sizing/apply_data_sheet.h"

#include "sim/sizing/drive_point.h"
#include "sim/sizing/vehicle_drive.h"

namespace rotorbench {

namespace {

const DriveStand* standOf(const Experiment& experiment) {
  if (const auto* bench = std::get_if<MotorBench>(&experiment.setup)) return &bench->stand;
  if (const auto* run = std::get_if<MotorSpeedRun>(&experiment.setup)) return &run->stand;
  return nullptr;
}

/// T/w^2 and Q/w^2 where the vehicle hovers, or at full throttle where it cannot.
struct Coefficients {
  double thrust, torque;
};
Coefficients coefficientsOf(const DataSheet& sheet) {
  const DriveTrain train = driveTrainOf(sheet);
  const double weight = sheet.vehicle.mass * sheet.vehicle.gravity / sheet.vehicle.rotors;
  const DrivePoint p = pointWithThrust(train, weight).value_or(drivePoint(train, 1));
  return {train.load().thrust.at(p.speed), train.load().quadratic.at(p.speed)};
}

RotorInflow inflowOf(const RotorAerodynamics& aerodynamics) {
  return std::visit([](const auto& a) { return a.inflow; }, aerodynamics);
}

/// Effects of moving air stay those the vehicle had: no data sheet names them.
RotorAerodynamics aerodynamicsOf(const DataSheet& sheet, const RotorAerodynamics& before) {
  if (const auto* p = std::get_if<PropellerLoad>(&sheet.propeller)) {
    return PropellerCoefficients{p->thrustCoefficient, p->powerCoefficient, p->diameter,
                                 inflowOf(before)};
  }
  const Coefficients c = coefficientsOf(sheet);
  const double scale = kStandardDensity / airDensityOf(sheet);
  return RotorCoefficients{c.thrust * scale, c.torque * scale, inflowOf(before), kStandardDensity,
                           diameterOf(sheet)};
}

PropellerLoad staticLoadOf(const RotorAerodynamics& aerodynamics, double density) {
  PropellerLoad load;
  load.airDensity = density;
  RotorParameters rotor;
  rotor.aerodynamics = aerodynamics;
  const RotorConstants c = buildRotor(rotor);
  load.diameter = 2 * c.radius;
  // The inverse of PropellerCoefficients: per unit of density, speed in turns per second.
  const RotorConstants unit = [&] {
    RotorParameters one;
    one.aerodynamics = PropellerCoefficients{1, 1, load.diameter, {}};
    return buildRotor(one);
  }();
  load.thrustCoefficient = c.thrust / unit.thrust;
  load.powerCoefficient = c.torque / unit.torque;
  return load;
}

DataSheet sheetOf(const Flight& flight) {
  DataSheet sheet;
  const auto* own = std::get_if<IndividualRotors>(&flight.vehicle.rotors);
  const RotorParameters rotor =
      own != nullptr ? (own->rotors.empty() ? RotorParameters{} : own->rotors.front())
                     : std::get<EqualRotors>(flight.vehicle.rotors).rotor;
  sheet.motor = rotor.motor;
  sheet.esc = escOf(rotor);
  sheet.supply = supplyOf(flight.vehicle);
  sheet.inertia = GivenInertia{rotor.inertia};
  sheet.propeller = staticLoadOf(rotor.aerodynamics, buildAir(flight.environment.air).density(0.0));
  sheet.vehicle.gravity = flight.environment.gravity;
  try {
    sheet.vehicle.mass = massOf(flight.vehicle, sheet.vehicle.rotors).mass;
  } catch (const InputError&) {
    // A vehicle with faults keeps the sheet's own mass; the experiment shows its problems itself.
    sheet.vehicle.mass = CarriedVehicle{}.mass;
  }
  return sheet;
}

DataSheet sheetOf(const DriveStand& stand) {
  DataSheet sheet;
  sheet.motor = stand.motor;
  sheet.esc = stand.esc;
  sheet.supply = stand.supply;
  sheet.inertia = GivenInertia{stand.inertia};
  if (const auto* p = std::get_if<PropellerLoad>(&stand.load)) sheet.propeller = *p;
  if (const auto* p = std::get_if<BladeElementLoad>(&stand.load)) sheet.propeller = *p;
  return sheet;
}

void apply(const DataSheet& sheet, Flight& flight) {
  VehicleParameters& vehicle = flight.vehicle;
  if (!std::holds_alternative<EqualRotors>(vehicle.rotors)) {
    const auto rotors = std::get<IndividualRotors>(vehicle.rotors).rotors;
    vehicle.rotors = EqualRotors{rotors.empty() ? RotorParameters{} : rotors.front()};
  }
  RotorParameters& rotor = std::get<EqualRotors>(vehicle.rotors).rotor;
  rotor.aerodynamics = aerodynamicsOf(sheet, rotor.aerodynamics);
  rotor.inertia = inertiaOf(sheet);
  if (const auto* p = std::get_if<BladeElementLoad>(&sheet.propeller)) {
    rotor.blades = p->propeller.blades;
  }
  setDrive(vehicle, rotor, sheet.supply, sheet.esc, sheet.motor);
}

void apply(const DataSheet& sheet, DriveStand& stand) {
  stand.motor = sheet.motor;
  stand.esc = sheet.esc;
  stand.supply = sheet.supply;
  stand.inertia = inertiaOf(sheet);
  if (const auto* p = std::get_if<PropellerLoad>(&sheet.propeller)) {
    stand.load = *p;
  } else if (const auto* blades = std::get_if<BladeElementLoad>(&sheet.propeller)) {
    stand.load = *blades;
  } else {
    const Coefficients c = coefficientsOf(sheet);
    RotorCoefficients lumped{c.thrust, c.torque, {}, airDensityOf(sheet), diameterOf(sheet)};
    stand.load = staticLoadOf(lumped, airDensityOf(sheet));
  }
}

}  // namespace

std::string dataSheetTarget(const Experiment& experiment) {
  if (std::holds_alternative<Flight>(experiment.setup)) return "setup.vehicle";
  return standOf(experiment) != nullptr ? "setup.stand" : "";
}

std::optional<DataSheet> dataSheetOf(const Experiment& experiment) {
  if (const auto* flight = std::get_if<Flight>(&experiment.setup)) return sheetOf(*flight);
  if (const auto* stand = standOf(experiment)) return sheetOf(*stand);
  return std::nullopt;
}

void applyDataSheet(const DataSheet& sheet, Experiment& experiment) {
  if (auto* flight = std::get_if<Flight>(&experiment.setup)) return apply(sheet, *flight);
  if (auto* bench = std::get_if<MotorBench>(&experiment.setup)) return apply(sheet, bench->stand);
  if (auto* run = std::get_if<MotorSpeedRun>(&experiment.setup)) return apply(sheet, run->stand);
}

}  // namespace rotorbench
