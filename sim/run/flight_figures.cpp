#include "sim/run/flight_figures.h"

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "sim/core/number_text.h"
#include "sim/run/timeline.h"

namespace rotorbench {

namespace {

/// Largest value of every channel "rotor<i>.<quantity>".
double peakOfRotors(const Recording& recording, const std::string& quantity) {
  double peak = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t c = 0; c < recording.channels().size(); ++c) {
    const std::string& name = recording.channels()[c].name;
    if (!name.starts_with("rotor") || !name.ends_with("." + quantity)) continue;
    for (std::size_t row = 0; row < recording.rows();) {
      const auto piece = recording.column(c, row);
      const Eigen::Map<const Eigen::ArrayXd> values(piece.data(),
                                                    static_cast<Eigen::Index>(piece.size()));
      peak = std::fmax(peak, values.maxCoeff());  // a recording holds no NaN of a rotor
      row += piece.size();
    }
  }
  return peak;
}

/// Energy, mean power and, of a battery, what is left.
void addEnergy(const Recording& recording, const Supply& supply, std::vector<Metric>& metrics) {
  const auto drawn = recording.find("supply.energy"),
             charge = recording.find("supply.stateOfCharge");
  if (!drawn || !charge) return;
  const std::size_t last = recording.rows() - 1;
  const double energy = recording.value(*drawn, last) - recording.value(*drawn, 0);
  const double time = recording.value(0, last) - recording.value(0, 0);
  metrics.push_back({"energy", "J", "Energy drawn from the supply", energy});
  if (time > 0)
    metrics.push_back({"mean_power", "W", "Mean power drawn from the supply", energy / time});
  if (!(supply.inverseCapacity > 0)) return;
  const double left = recording.value(*charge, last);
  metrics.push_back({"remaining_charge", "1", "State of charge of the battery at the end", left});
  const double seconds = time > 0 ? supply.secondsAt(energy / time, left) : 0;
  if (std::isfinite(seconds)) {
    metrics.push_back({"minutes_left", "min",
                       "Time the battery would last at the mean power of the flight",
                       seconds / 60});
  }
}

}  // namespace

void addStepFigures(const Recording& recording, const std::vector<HeldQuantity>& held,
                    const std::vector<SetPointRow>& timeline, std::vector<Metric>& metrics) {
  if (recording.rows() == 0) return;
  for (const HeldQuantity& quantity : held) {
    const auto channel = recording.find(quantity.channel);
    if (!channel) continue;
    const StepFigures worst =
        worstFigures(recording, *channel, changesOf(timeline, quantity.setPoint));
    metrics.push_back(
        {quantity.name + "_rest_error", recording.channels()[*channel].unit,
         "Largest distance from the set-point in the last tenth of any part of the timeline",
         worst.restError});
    metrics.push_back({quantity.name + "_overshoot", "1",
                       "Largest overshoot of a step, as a fraction of the step", worst.overshoot});
    metrics.push_back({quantity.name + "_settling_time", "s",
                       "Longest time to stay within 2 % of a step", worst.settlingTime});
  }
}

RunFailure emptyBattery(double time, double voltage, double cutOff) {
  return {time, "supply",
          "the battery is empty: " + numberText(std::round(voltage * 100) / 100) +
              " V under load is below its cut-off of " + numberText(cutOff) + " V"};
}

void addFlightFigures(const Recording& recording, const Supply& supply,
                      std::vector<Metric>& metrics) {
  const std::size_t rows = recording.rows();
  if (rows == 0) return;
  const auto peak = [&](const char* quantity, const char* name, const char* unit,
                        const char* text) {
    const double value = peakOfRotors(recording, quantity);
    if (std::isfinite(value)) metrics.push_back({name, unit, text, value});
  };
  peak("speed", "peak_rotor_speed", "rad/s", "Highest speed of any rotor");
  peak("thrust", "peak_rotor_thrust", "N", "Highest thrust of any rotor");
  peak("current", "peak_motor_current", "A", "Highest current of any motor");
  peak("voltage", "peak_motor_voltage", "V", "Highest voltage at any motor");
  addEnergy(recording, supply, metrics);
  for (const char* axis : {"x", "y", "z"}) {
    const auto channel = recording.find(std::string("position.") + axis);
    if (channel) {
      metrics.push_back({std::string("final_") + axis, "m", "Position at the end",
                         recording.value(*channel, rows - 1)});
    }
  }
}

}  // namespace rotorbench
