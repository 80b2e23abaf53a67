#include "sim/sizing/discharge.h"

#include <cmath>
#include <limits>
#include <optional>

#include "sim/numerics/scalar_search.h"
#include "sim/propulsion/drive/bus.h"
#include "sim/sizing/figure.h"

namespace rotorbench {

namespace {

/// Steps of an ideal discharge. Halving them changes the time by less than a part in a million.
constexpr int kSteps = 4000;

struct Cells {
  double charge, polarisation;
};

class Discharger {
 public:
  Discharger(const Supply& supply, const ConstantLoad& load) : supply_(supply), load_(load) {}

  [[nodiscard]] double voltage(const Cells& c) const {
    return voltageUnder(load_.power, supply_.openCircuit(c.charge) - c.polarisation,
                        supply_.resistance);
  }
  /// What ends the discharge in this state, if anything.
  [[nodiscard]] std::optional<DischargeEnd> end(const Cells& c) const {
    const double v = voltage(c);
    if (std::isnan(v)) return DischargeEnd::Collapse;
    if (v < supply_.cutOff) return DischargeEnd::CutOff;
    if (v < load_.leastVoltage) return DischargeEnd::Throttle;
    if (c.charge <= load_.reserve) return DischargeEnd::Reserve;
    return std::nullopt;
  }
  /// Midpoint rule for the charge; the polarisation follows a constant current exactly.
  [[nodiscard]] Cells after(const Cells& c, double dt) const {
    const Cells middle = moved(c, current(c), dt / 2);
    return moved(c, current(middle), dt);
  }

 private:
  [[nodiscard]] double current(const Cells& c) const {
    const double v = voltage(c);
    // Beyond collapse the state is only compared, never kept: any large current does.
    return load_.power / (std::isnan(v) ? 0.5 * supply_.openCircuit(c.charge) : v);
  }
  [[nodiscard]] Cells moved(const Cells& c, double i, double dt) const {
    const double settled = supply_.polarisation * i;
    const double decay = std::exp(-dt * supply_.inversePolarisationTime);
    return {c.charge - i * supply_.inverseCapacity * dt,
            settled + (c.polarisation - settled) * decay};
  }

  const Supply& supply_;
  const ConstantLoad& load_;
};

}  // namespace

double voltageUnder(double power, double inner, double resistance) {
  if (busReserve(inner, power, resistance) < 0) return std::numeric_limits<double>::quiet_NaN();
  return busVoltage(inner, power, resistance);
}

Discharge discharge(const Supply& supply, const ConstantLoad& load) {
  const Discharger run(supply, load);
  Cells cells{supply.charge, 0};
  if (const auto end = run.end(cells)) return {0, cells.charge, *end};
  if (!(supply.inverseCapacity > 0) || !(load.power > 0)) {
    return {std::numeric_limits<double>::infinity(), cells.charge, DischargeEnd::Never};
  }
  const double step =
      supply.openCircuit(supply.charge) / (load.power * supply.inverseCapacity) / kSteps;
  double time = 0;
  while (!run.end(run.after(cells, step))) {
    cells = run.after(cells, step);
    time += step;
  }
  DischargeEnd end = run.end(run.after(cells, step)).value_or(DischargeEnd::Reserve);
  const auto goesOn = [&](double dt) {
    const auto found = run.end(run.after(cells, dt));
    if (found) end = *found;
    return !found;
  };
  const double rest = findLast(goesOn, 0, step);
  return {time + rest, run.after(cells, rest).charge, end};
}

Sentence reasonOf(DischargeEnd end, const Supply& supply, const ConstantLoad& load) {
  switch (end) {
    case DischargeEnd::Reserve:
      return load.reserve > 0
                 ? "the reserve of " + Sentence::number(100 * load.reserve) + " % charge is reached"
                 : "the battery is empty";
    case DischargeEnd::CutOff:
      return "the battery's voltage under load falls to its cut-off of " +
             Sentence::number(supply.cutOff) + " V";
    case DischargeEnd::Throttle:
      return "full throttle no longer carries the vehicle: the battery's voltage under load falls "
             "to the " +
             Sentence::number(load.leastVoltage) + " V that the motors need";
    case DischargeEnd::Collapse:
      return "the battery's internal resistance no longer lets it give " +
             Sentence::number(load.power) + " W";
    case DischargeEnd::Never:
      return "a supply of fixed voltage never runs empty";
  }
  return {};
}

}  // namespace rotorbench
