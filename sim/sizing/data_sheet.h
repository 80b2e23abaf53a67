// What data sheets say of a drive: motor, speed controller, battery and propeller, with the vehicle
// that all of its drives carry. The wizard's inputs; figuresOf() works out the rest. SI units.
#pragma once

#include <variant>
#include <vector>

#include "sim/core/schema.h"
#include "sim/document/drive_stand.h"
#include "sim/propulsion/drive/drive_train.h"

namespace rotorbench {

/// One row of a propeller's static table.
struct StaticTableRow {
  double speed = 0;   ///< rad/s, above 0
  double thrust = 0;  ///< N
  double torque = 0;  ///< N m on the shaft
  bool operator==(const StaticTableRow&) const = default;
};

/// A propeller by what was measured of it at rest; between the rows T/w^2 and Q/w^2 change
/// linearly, beyond them they stay. Defaults: three rows of an APC 10 x 4.7 SF.
struct StaticTable {
  double diameter = 0.254;         ///< m
  double measuredDensity = 1.225;  ///< kg/m^3 during the measurement
  double airDensity = 1.225;       ///< kg/m^3 in which it works now
  std::vector<StaticTableRow> rows = slowFlyer10x47();
  bool operator==(const StaticTable&) const = default;

  static std::vector<StaticTableRow> slowFlyer10x47();
};

using DataSheetPropeller = std::variant<PropellerLoad, BladeElementLoad, StaticTable>;

/// Inertia of all that spins, as known.
struct GivenInertia {
  double inertia = 6.05e-5;  ///< kg m^2
  bool operator==(const GivenInertia&) const = default;
};

/// Inertia from masses: the propeller as a slender rod across its diameter, the motor's bell as a
/// thin ring.
///   J = m D^2/12 + m_b r_b^2
struct EstimatedInertia {
  double propellerMass = 0.0126;  ///< kg
  double bellMass = 0.02;         ///< kg of the motor that spins
  double bellRadius = 0.0115;     ///< m
  bool operator==(const EstimatedInertia&) const = default;
};

struct CarriedVehicle {
  double mass = 1.4;  ///< kg, everything
  int rotors = 4;     ///< alike, all on one battery
  double gravity = 9.80665;
  bool operator==(const CarriedVehicle&) const = default;
};

/// Defaults: DJI F450 with E305 motors and 9450 propellers on three cells.
struct DataSheet {
  MotorParameters motor = djiE305();
  DataSheetPropeller propeller;
  SupplyModel supply = BatteryParameters{};
  EscParameters esc{.resistance = 0.005, .responseTime = 0.01};  ///< 420 LITE: both assumed
  std::variant<GivenInertia, EstimatedInertia> inertia;
  CarriedVehicle vehicle;
  bool operator==(const DataSheet&) const = default;
};

/// m of the propeller, kg/m^3 it works in, and kg m^2 of all that spins.
double diameterOf(const DataSheet& sheet);
double airDensityOf(const DataSheet& sheet);
double inertiaOf(const DataSheet& sheet);

/// One motor of the vehicle with its N-th of the battery. The sheet must satisfy its schema.
DriveTrain driveTrainOf(const DataSheet& sheet);

template <>
struct Describe<StaticTableRow> {
  static void fields(schema::Builder<StaticTableRow>& b);
};
template <>
struct Describe<StaticTable> {
  static void fields(schema::Builder<StaticTable>& b);
};
template <>
struct Describe<GivenInertia> {
  static void fields(schema::Builder<GivenInertia>& b);
};
template <>
struct Describe<EstimatedInertia> {
  static void fields(schema::Builder<EstimatedInertia>& b);
};
template <>
struct Describe<CarriedVehicle> {
  static void fields(schema::Builder<CarriedVehicle>& b);
};
template <>
struct Describe<DataSheet> {
  static void fields(schema::Builder<DataSheet>& b);
};

}  // namespace rotorbench
