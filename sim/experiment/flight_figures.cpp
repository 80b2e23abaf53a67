#include <algorithm>
#include <cmath>

#include "sim/experiment/flight_simulation.h"

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
      peak = std::fmax(peak, *std::max_element(piece.begin(), piece.end()));
      row += piece.size();
    }
  }
  return peak;
}

/// Integral of a channel over time by the trapezoidal rule.
double integral(const Recording& recording, std::size_t channel) {
  double sum = 0;
  for (std::size_t row = 1; row < recording.rows(); ++row) {
    sum += (recording.value(0, row) - recording.value(0, row - 1)) *
           (recording.value(channel, row) + recording.value(channel, row - 1)) / 2;
  }
  return sum;
}

}  // namespace

void addFlightFigures(const Recording& recording, std::vector<Metric>& metrics) {
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
  if (const auto power = recording.find("supply.power")) {
    const double energy = integral(recording, *power);
    metrics.push_back({"energy", "J", "Energy drawn from the supply", energy});
    const double time = recording.value(0, rows - 1) - recording.value(0, 0);
    if (time > 0)
      metrics.push_back({"mean_power", "W", "Mean power drawn from the supply", energy / time});
  }
  for (const char* axis : {"x", "y", "z"}) {
    const auto channel = recording.find(std::string("position.") + axis);
    if (channel) {
      metrics.push_back({std::string("final_") + axis, "m", "Position at the end",
                         recording.value(*channel, rows - 1)});
    }
  }
}

}  // namespace rotorbench
