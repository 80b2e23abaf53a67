#include "sim/sizing/data_sheet.h"

#include <algorithm>
#include <cmath>

#include "sim/core/rising.h"
#include "sim/run/drive_build.h"
#include "sim/sizing/drive_point.h"

namespace rotorbench {

namespace {

/// Points of a measured propeller's curve over the speed.
constexpr int kSpeedPoints = 256;

/// `coefficient(row)` between the rows at speed w, the end values beyond them.
template <class Coefficient>
double between(const std::vector<StaticTableRow>& rows, double w, const Coefficient& coefficient) {
  const auto above = std::ranges::upper_bound(rows, w, {}, &StaticTableRow::speed);
  if (above == rows.begin()) return coefficient(rows.front());
  if (above == rows.end()) return coefficient(rows.back());
  const StaticTableRow &a = *(above - 1), &b = *above;
  const double t = (w - a.speed) / (b.speed - a.speed);
  return coefficient(a) + t * (coefficient(b) - coefficient(a));
}

ShaftLoad loadOf(const StaticTable& p, double topSpeed) {
  const double scale = p.airDensity / p.measuredDensity;
  ShaftLoad load;
  load.quadratic = load.thrust = {topSpeed / kSpeedPoints, {}};
  for (int k = 0; k <= kSpeedPoints; ++k) {
    const double w = topSpeed * k / kSpeedPoints;
    load.quadratic.values.push_back(
        scale * between(p.rows, w, [](const auto& r) { return r.torque / (r.speed * r.speed); }));
    load.thrust.values.push_back(
        scale * between(p.rows, w, [](const auto& r) { return r.thrust / (r.speed * r.speed); }));
  }
  return load;
}

}  // namespace

std::vector<StaticTableRow> StaticTable::slowFlyer10x47() {
  return {{248.919, 0.8475, 0.013943}, {480.664, 3.5808, 0.058384}, {683.611, 7.8404, 0.129562}};
}

double diameterOf(const DataSheet& sheet) {
  if (const auto* blades = std::get_if<BladeElementLoad>(&sheet.propeller)) {
    return blades->propeller.diameter;
  }
  if (const auto* measured = std::get_if<StaticTable>(&sheet.propeller)) {
    return measured->diameter;
  }
  return std::get<PropellerLoad>(sheet.propeller).diameter;
}

double airDensityOf(const DataSheet& sheet) {
  return std::visit([](const auto& p) { return p.airDensity; }, sheet.propeller);
}

double inertiaOf(const DataSheet& sheet) {
  if (const auto* given = std::get_if<GivenInertia>(&sheet.inertia)) return given->inertia;
  const auto& e = std::get<EstimatedInertia>(sheet.inertia);
  const double diameter = diameterOf(sheet);
  return e.propellerMass * diameter * diameter / 12 + e.bellMass * e.bellRadius * e.bellRadius;
}

DriveTrain driveTrainOf(const DataSheet& sheet) {
  const SupplyModel supply = shareOf(sheet.supply, sheet.vehicle.rotors);
  const double inertia = inertiaOf(sheet);
  if (const auto* measured = std::get_if<StaticTable>(&sheet.propeller)) {
    const double topSpeed = Supply(supply).openCircuit(1.0) * sheet.motor.speedConstant;
    return DriveTrain({.supply = supply,
                       .esc = sheet.esc,
                       .motor = sheet.motor,
                       .load = loadOf(*measured, topSpeed),
                       .inertia = inertia});
  }
  DriveStand stand;
  stand.supply = supply;
  stand.esc = sheet.esc;
  stand.motor = sheet.motor;
  stand.inertia = inertia;
  if (const auto* blades = std::get_if<BladeElementLoad>(&sheet.propeller)) {
    stand.load = *blades;
  } else {
    stand.load = std::get<PropellerLoad>(sheet.propeller);
  }
  return buildDriveTrain(stand);
}

void Describe<StaticTableRow>::fields(schema::Builder<StaticTableRow>& b) {
  using P = StaticTableRow;
  b.title("static-row", "Row", "Thrust and torque at one speed.");
  b.number("speed", &P::speed, "Speed", "\u03a9", "rad/s")
      .range(schema::above(0), schema::upTo(1e5))
      .shownIn("rpm");
  b.number("thrust", &P::thrust, "Thrust", "T", "N").range(schema::atLeast(0), schema::upTo(1e5));
  b.number("torque", &P::torque, "Torque", "Q", "N*m").range(schema::atLeast(0), schema::upTo(1e5));
}

void Describe<StaticTable>::fields(schema::Builder<StaticTable>& b) {
  using P = StaticTable;
  b.title(
      "measured", "Propeller by a static table",
      "Thrust and torque as measured at rest; between the rows T/\u03a9\u00b2 and Q/\u03a9\u00b2 "
      "change linearly, beyond them they stay.",
      "Default: UIUC Propeller Data Site, volume 1, APC Slow Flyer 10 x 4.7, static");
  b.number("diameter", &P::diameter, "Diameter", "D", "m")
      .range(schema::above(0), schema::upTo(20))
      .shownIn("in");
  schema::risingList(b, "rows", &P::rows, "Table", &StaticTableRow::speed, {"speed", "speeds"})
      .items(1, 1000)
      .table();
  b.number("measuredDensity", &P::measuredDensity, "Measured at density", "\u03c1\u2080", "kg/m^3")
      .range(schema::above(0), schema::upTo(100))
      .help("Air density during the measurement.")
      .advanced();
  b.number("airDensity", &P::airDensity, "Air density", "\u03c1", "kg/m^3")
      .range(schema::above(0), schema::upTo(10))
      .source("International standard atmosphere at sea level");
}

void Describe<GivenInertia>::fields(schema::Builder<GivenInertia>& b) {
  b.title("given", "Given", "The moment of inertia of propeller and motor bell.");
  b.number("inertia", &GivenInertia::inertia, "Inertia", "J", "kg*m^2")
      .range(schema::above(0), schema::upTo(1e3))
      .shownIn("g*cm^2")
      .source("JSBSim aircraft F450, engine/DJI_9450.xml: propeller");
}

void Describe<EstimatedInertia>::fields(schema::Builder<EstimatedInertia>& b) {
  using P = EstimatedInertia;
  b.title("estimated", "From masses",
          "The propeller as a slender rod across its diameter, the motor's bell as a thin ring: J "
          "= m D\u00b2/12 + m_b r_b\u00b2.",
          "Moments of inertia of rod and ring, any textbook of mechanics");
  b.number("propellerMass", &P::propellerMass, "Propeller mass", "m", "kg")
      .range(schema::above(0), schema::upTo(100))
      .shownIn("g")
      .help("A real blade has more of its mass inboard: the rod is an upper estimate.")
      .source("As a rod it has the inertia published for the DJI 9450");
  b.number("bellMass", &P::bellMass, "Bell mass", "m_b", "kg")
      .range(schema::atLeast(0), schema::upTo(100))
      .shownIn("g")
      .help("The part of the motor that spins; 0 to leave it out.")
      .source("Assumption: a third of a 60 g motor");
  b.number("bellRadius", &P::bellRadius, "Bell radius", "r_b", "m")
      .range(schema::atLeast(0), schema::upTo(1))
      .shownIn("mm")
      .source("Assumption: a motor of the 2312 size");
}

void Describe<CarriedVehicle>::fields(schema::Builder<CarriedVehicle>& b) {
  using P = CarriedVehicle;
  b.title("carried", "Vehicle", "What the drives carry together, on one battery.");
  b.number("mass", &P::mass, "Take-off mass", "m", "kg")
      .range(schema::above(0), schema::upTo(1e4))
      .help("Everything: frame, drives, battery and payload.")
      .source("JSBSim aircraft F450");
  b.integer("rotors", &P::rotors, "Rotors", "N").range(schema::atLeast(1), schema::upTo(32));
  b.number("gravity", &P::gravity, "Gravity", "g", "m/s^2")
      .range(schema::above(0), schema::upTo(100))
      .advanced();
}

void Describe<DataSheet>::fields(schema::Builder<DataSheet>& b) {
  using P = DataSheet;
  b.title("data-sheet", "Data sheet",
          "Motor, propeller, battery and speed controller as their sellers describe them.");
  b.group("motor", &P::motor, "Motor");
  b.variant("propeller", &P::propeller, "Propeller");
  b.variant("supply", &P::supply, "Supply");
  b.group("esc", &P::esc, "Speed controller (ESC)");
  b.group("vehicle", &P::vehicle, "Vehicle");
  b.variant("inertia", &P::inertia, "Inertia of the rotor");
}

}  // namespace rotorbench
