#include "sim/fitting/rotor_fit.h"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.h"
#include "sim/fitting/measured_rows.h"

namespace rotorbench {

namespace {

/// One square law of the speed and the column it is fitted to.
struct Law {
  const char* key;
  const char* label;
  const char* unit;
  std::string_view quantity;
  const char* output;
  const char* outputUnit;
  double start;
};

std::vector<Law> lawsOf(const RotorFitSetup& setup) {
  std::vector<Law> laws;
  if (setup.fitThrust) {
    laws.push_back(
        {"thrust", "Thrust coefficient k_f", "N*s^2", "thrust", "Thrust", "N", setup.thrustStart});
  }
  if (setup.fitTorque) {
    laws.push_back({"torque", "Torque coefficient k_m", "N*m*s^2", "motor.torque", "Torque", "N*m",
                    setup.torqueStart});
  }
  return laws;
}

/// (speed, value of one rotor) of the rows of a turning rotor; torque counts whatever its sign.
std::vector<std::pair<double, double>> pointsOf(const MeasuredTable& table, const Law& law,
                                                int rotors) {
  const std::string_view keys[] = {"motor.speed", law.quantity};
  std::vector<std::pair<double, double>> points;
  for (const std::vector<double>& row : finiteRows(table, keys)) {
    const bool torque = law.quantity == "motor.torque";
    const double value = (torque ? std::abs(row[1]) : row[1]) / rotors;
    if (row[0] > 0) points.emplace_back(row[0], value);
  }
  return points;
}

}  // namespace

std::vector<std::string> missingForRotorFit(const MeasuredTable& table,
                                            const RotorFitSetup& setup) {
  std::vector<std::string_view> keys{"motor.speed"};
  for (const Law& law : lawsOf(setup)) keys.push_back(law.quantity);
  std::vector<std::string> missing = missingColumns(table, keys);
  if (keys.size() == 1) missing.emplace_back("No parameter is chosen to be fitted.");
  if (!missing.empty()) return missing;
  for (const Law& law : lawsOf(setup)) {
    if (pointsOf(table, law, setup.rotors).empty()) {
      missing.push_back("No row holds both a speed and " + std::string(law.output) + ".");
    }
  }
  return missing;
}

FitProblem rotorFitProblem(const MeasuredTable& table, const RotorFitSetup& setup) {
  throwIfAny(table, missingForRotorFit(table, setup));
  FitProblem problem;
  problem.abscissa = "Motor speed", problem.abscissaUnit = "rad/s", problem.abscissaShown = "rpm";
  for (const Law& law : lawsOf(setup)) {
    problem.parameters.push_back({law.key, law.label, law.unit, law.unit, law.start, 0,
                                  std::numeric_limits<double>::infinity(), law.start,
                                  setup.startsAreGuesses});
    double most = 0;
    for (const auto& [speed, value] : pointsOf(table, law, setup.rotors)) {
      problem.points.push_back({problem.outputs.size(), speed, value});
      most = std::max(most, std::abs(value));
    }
    problem.outputs.push_back({law.output, law.outputUnit, law.outputUnit, most > 0 ? most : 1});
  }
  problem.predict = [points = problem.points](std::span<const double> p,
                                              std::span<double> predicted) {
    for (std::size_t i = 0; i < points.size(); ++i)
      predicted[i] = p[points[i].output] * points[i].x * points[i].x;
    return true;
  };
  return problem;
}

double thrustCoefficientOf(double kf, double density, double diameter) {
  return kf * kTurn * kTurn / (density * std::pow(diameter, 4));
}

double powerCoefficientOf(double km, double density, double diameter) {
  return km * kTurn * kTurn * kTurn / (density * std::pow(diameter, 5));
}

}  // namespace rotorbench
