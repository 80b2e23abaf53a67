#include "sim/sizing/apply_data_sheet.h"

#include "sim/document/kinds.h"
#include "sim/sizing/drive_point.h"

namespace rotorbench {

namespace {

const DriveStand* standOf(const Experiment& experiment) {
  if (const auto* bench = alternativeIf<MotorBench>(experiment.setup)) return &bench->stand;
  if (const auto* run = alternativeIf<MotorSpeedRun>(experiment.setup)) return &run->stand;
  if (const auto* stand = alternativeIf<ThrustStand>(experiment.setup)) return &stand->stand;
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

/// What moving air does to a lumped rotor; a model that works it out itself has nothing to hand on.
struct InflowOf {
  RotorInflow operator()(const PropellerCoefficients& a) const { return a.inflow; }
  RotorInflow operator()(const RotorCoefficients& a) const { return a.inflow; }
  RotorInflow operator()(const MeasuredPropeller& a) const {
    return {a.inPlane.drag, 0, a.inPlane.translationalLift, a.inPlane.flapping};
  }
  RotorInflow operator()(const MapPropeller& /*a*/) const { return {}; }
  RotorInflow operator()(const BladeElementPropeller& /*a*/) const { return {}; }
};

/// Effects of moving air stay those the vehicle had where the propeller is lumped: no data sheet
/// names them.
RotorAerodynamics aerodynamicsOf(const DataSheet& sheet, const RotorAerodynamics& before) {
  const RotorInflow inflow = std::visit(InflowOf{}, before);
  if (const auto* p = std::get_if<PropellerLoad>(&sheet.propeller)) {
    return PropellerCoefficients{p->thrustCoefficient, p->powerCoefficient, p->diameter, inflow};
  }
  if (const auto* p = std::get_if<BladeElementLoad>(&sheet.propeller)) {
    return MapPropeller{p->propeller, p->settings, {}};
  }
  const Coefficients c = coefficientsOf(sheet);
  const double scale = kStandardDensity / airDensityOf(sheet);
  return RotorCoefficients{c.thrust * scale, c.torque * scale, inflow, kStandardDensity,
                           diameterOf(sheet)};
}

/// Static coefficients of a rotor whose thrust and torque go with the square of its speed.
PropellerLoad staticLoadOf(const RotorAerodynamics& aerodynamics, double density) {
  RotorParameters rotor, unit;
  rotor.aerodynamics = aerodynamics;
  PropellerLoad load;
  load.airDensity = density;
  load.diameter = 2 * rotorRadius(aerodynamics);
  unit.aerodynamics = PropellerCoefficients{1, 1, load.diameter, {}};
  const RotorConstants c = buildRotor(rotor), one = buildRotor(unit);
  load.thrustCoefficient = c.thrust / one.thrust;
  load.powerCoefficient = c.torque / one.torque;
  return load;
}

/// Any other rotor at rest as a table up to a speed in rad/s.
StaticTable staticTableOf(const RotorAerodynamics& aerodynamics, double density, double topSpeed) {
  RotorParameters rotor;
  rotor.aerodynamics = aerodynamics;
  // For twenty states it does not pay to make a map.
  if (const auto* map = std::get_if<MapPropeller>(&aerodynamics))
    rotor.aerodynamics = BladeElementPropeller{map->propeller, map->settings};
  const RotorConstants c = buildRotor(rotor);
  StaticTable table{2 * rotorRadius(aerodynamics), density, density, {}};
  constexpr int kRows = 20;
  for (int k = 1; k <= kRows; ++k) {
    const double w = topSpeed * k / kRows;
    const auto at = c.atRest(w, density);
    table.rows.push_back({w, at.thrust, at.torque});
  }
  return table;
}

DataSheetPropeller propellerOf(const RotorAerodynamics& aerodynamics, double density,
                               double topSpeed) {
  const auto* map = std::get_if<MapPropeller>(&aerodynamics);
  const auto* blades = std::get_if<BladeElementPropeller>(&aerodynamics);
  if (map != nullptr || blades != nullptr) {
    BladeElementLoad load;
    load.propeller = map != nullptr ? map->propeller : blades->propeller;
    load.settings = map != nullptr ? map->settings : blades->settings;
    load.airDensity = density;
    return load;
  }
  if (std::holds_alternative<MeasuredPropeller>(aerodynamics) && density > 0) {
    return staticTableOf(aerodynamics, density, topSpeed);
  }
  return staticLoadOf(aerodynamics, density);
}

DataSheet sheetOf(const Flight& flight) {
  DataSheet sheet;
  const auto* own = std::get_if<IndividualRotors>(&flight.vehicle.rotors);
  const RotorParameters rotor =
      own != nullptr ? (own->rotors.empty() ? RotorParameters{} : own->rotors.front())
                     : std::get<EqualRotors>(flight.vehicle.rotors).rotor;
  sheet.motor = rotor.motor;
  sheet.esc = rotor.esc;
  sheet.supply = flight.vehicle.supply;
  sheet.inertia = GivenInertia{rotor.inertia};
  sheet.propeller = propellerOf(rotor.aerodynamics, buildAir(flight.environment).density(0.0),
                                Supply(sheet.supply).openCircuit(1.0) * rotor.motor.speedConstant);
  sheet.vehicle.gravity = flight.environment.gravity;
  sheet.vehicle.rotors = rotorCount(flight.vehicle.layout);
  try {
    sheet.vehicle.mass = massOf(flight.vehicle).mass;
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
  vehicle.supply = sheet.supply;
  rotor.esc = sheet.esc;
  rotor.motor = sheet.motor;
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
  if (holdsAlternative<Flight>(experiment.setup)) return "setup.vehicle";
  return standOf(experiment) != nullptr ? "setup.stand" : "";
}

std::optional<DataSheet> dataSheetOf(const Experiment& experiment) {
  if (const auto* flight = alternativeIf<Flight>(experiment.setup)) return sheetOf(*flight);
  if (const auto* stand = standOf(experiment)) return sheetOf(*stand);
  return std::nullopt;
}

void applyDataSheet(const DataSheet& sheet, Experiment& experiment) {
  if (auto* flight = alternativeIf<Flight>(experiment.setup)) return apply(sheet, *flight);
  if (auto* bench = alternativeIf<MotorBench>(experiment.setup)) return apply(sheet, bench->stand);
  if (auto* run = alternativeIf<MotorSpeedRun>(experiment.setup)) return apply(sheet, run->stand);
  if (auto* stand = alternativeIf<ThrustStand>(experiment.setup)) return apply(sheet, stand->stand);
}

}  // namespace rotorbench
