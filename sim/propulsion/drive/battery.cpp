#include "sim/propulsion/drive/battery.h"

#include <algorithm>
#include <limits>
#include <string>

#include "sim/core/rising.h"
#include "sim/propulsion/drive/bus.h"

namespace rotorbench {

namespace {

constexpr const char* kChen =
    "Chen, Rincon-Mora, IEEE Trans. Energy Conversion 21 (2006) 504: polymer lithium-ion cell of "
    "850 mAh";

/// Chen and Rincon-Mora, eq. (2), over the charge of their cell, which ends at 4.10 V.
double cellVoltage(double z) {
  return -1.031 * std::exp(-35 * z) + 3.685 + 0.2156 * z - 0.1178 * z * z + 0.3201 * z * z * z;
}

double interpolated(const std::vector<CellVoltage>& points, double z) {
  if (z <= points.front().charge) return points.front().voltage;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const CellVoltage &a = points[i - 1], &b = points[i];
    if (z <= b.charge)
      return a.voltage + (z - a.charge) / (b.charge - a.charge) * (b.voltage - a.voltage);
  }
  return points.back().voltage;
}

}  // namespace

std::vector<CellVoltage> lithiumPolymerVoltages() {
  // Chargers of lithium-polymer cells go on to 4.20 V, which the curve reaches with this much of
  // the charge it calls full.
  constexpr double kFull = 1.09499;
  std::vector<CellVoltage> points;
  // Close together where the curve bends: below a tenth of the charge.
  for (const double z : {0.0,  0.005, 0.01, 0.02, 0.03, 0.04, 0.05, 0.07, 0.1,  0.15, 0.2,
                         0.25, 0.3,   0.4,  0.5,  0.6,  0.7,  0.8,  0.9,  0.95, 1.0}) {
    points.push_back({z, std::round(cellVoltage(kFull * z) * 1e4) / 1e4});
  }
  return points;
}

Supply::Supply(const SupplyModel& model) {
  if (const auto* fixed = std::get_if<SupplyParameters>(&model)) {
    voltages_.fill(fixed->voltage);
    resistance = fixed->internalResistance;
    return;
  }
  const auto& b = std::get<BatteryParameters>(model);
  for (std::size_t i = 0; i < voltages_.size(); ++i) {
    const double z = static_cast<double>(i) / kCells;
    voltages_[i] = b.series * interpolated(b.openCircuit, z);
  }
  const double cells = static_cast<double>(b.series) / b.parallel;
  resistance = cells * b.resistance;
  polarisation = cells * b.polarisation;
  inversePolarisationTime = 1 / b.polarisationTime;
  inverseCapacity = 1 / (b.parallel * b.capacity);
  cutOff = b.series * b.cutOff;
  charge = b.charge;
}

double Supply::secondsAt(double power, double stateOfCharge) const {
  if (!(inverseCapacity > 0) || !(power > 0)) return std::numeric_limits<double>::infinity();
  constexpr int kParts = 1000;
  const double inner = resistance + polarisation, part = stateOfCharge / kParts;
  double time = 0;
  for (int i = 0; i < kParts; ++i) {
    const double open = openCircuit(stateOfCharge - (i + 0.5) * part);
    if (busReserve(open, power, inner) < 0) break;
    const double voltage = busVoltage(open, power, inner);
    if (voltage < cutOff) break;
    time += part / inverseCapacity * voltage / power;
  }
  return time;
}

void Describe<CellVoltage>::fields(schema::Builder<CellVoltage>& b) {
  b.title("point", "Point", "Open-circuit voltage of a cell at one state of charge.");
  b.number("charge", &CellVoltage::charge, "State of charge", "z", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .shownIn("%");
  b.number("voltage", &CellVoltage::voltage, "Cell voltage", "OCV", "V")
      .range(schema::above(0), schema::upTo(10));
}

void Describe<BatteryParameters>::fields(schema::Builder<BatteryParameters>& b) {
  using P = BatteryParameters;
  using namespace schema;
  b.title(
      "battery", "Battery",
      "Cells in series and parallel: open-circuit voltage over the charge, a series resistance and "
      "one RC pair. The voltage sags with the current of all motors together.",
      kChen);
  b.integer("series", &P::series, "Cells in series", "N_s").range(atLeast(1), upTo(100));
  b.integer("parallel", &P::parallel, "Cells in parallel", "N_p").range(atLeast(1), upTo(1000));
  b.number("capacity", &P::capacity, "Cell capacity", "Q", "C")
      .range(above(0), upTo(1e7))
      .shownIn("mAh")
      .help("Of one cell; cells in parallel add up.");
  b.number("resistance", &P::resistance, "Cell resistance", "R\u2080", "Ohm")
      .range(atLeast(0), upTo(10))
      .shownIn("mOhm")
      .help("Of one cell: the voltage lost at once when current flows.")
      .source("Assumption: the order of magnitude of a hobby cell of 2200 mAh");
  b.number("polarisation", &P::polarisation, "Polarisation resistance", "R\u2081", "Ohm")
      .range(atLeast(0), upTo(10))
      .shownIn("mOhm")
      .help("Of one cell: the voltage lost and regained over the polarisation time.")
      .source("Assumption: half of the series resistance");
  b.number("polarisationTime", &P::polarisationTime, "Polarisation time", "\u03c4\u2081", "s")
      .range(above(0), upTo(1e5))
      .source(kChen);
  b.number("cutOff", &P::cutOff, "Cut-off voltage", "V_min", "V")
      .range(atLeast(0), upTo(10))
      .help("Of one cell under load: the run ends when it is reached.")
      .source("The usual limit for lithium-polymer cells");
  b.number("charge", &P::charge, "Charge at the start", "z", "1")
      .range(above(0), upTo(1))
      .shownIn("%");
  risingList(b, "openCircuit", &P::openCircuit, "Open-circuit voltage", &CellVoltage::charge,
             {"charge", "charges"},
             "Voltage of one cell without load; straight lines between the points.")
      .items(2, 1000)
      .table()
      .source(kChen)
      .advanced();
  b.check([](const P& p, std::vector<Problem>& problems) {
    for (std::size_t i = 1; i < p.openCircuit.size(); ++i) {
      if (p.openCircuit[i].voltage < p.openCircuit[i - 1].voltage)
        problems.push_back({"openCircuit[" + std::to_string(i) + "].voltage",
                            "is below the row before",
                            "the voltage must not fall with the charge"});
    }
  });
}

}  // namespace rotorbench
