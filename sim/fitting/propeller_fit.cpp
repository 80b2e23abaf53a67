#include "sim/fitting/propeller_fit.h"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.h"
#include "sim/fitting/measured_rows.h"

namespace rotorbench {

namespace {

constexpr const char* kTwist = "twistOffset";
constexpr const char* kDrag = "dragFactor";
constexpr double kMostTwist = 20 * kPi / 180;

/// One measured state; a coefficient that was not measured is NaN.
struct StateRow {
  double speed = 0, advance = 0, thrust = 0, power = 0;
};

double valueOr(const std::vector<double>* column, std::size_t row, double otherwise) {
  return column == nullptr ? otherwise : (*column)[row];
}

std::vector<StateRow> rowsOf(const MeasuredTable& table, const PropellerFitSetup& setup) {
  const double nan = std::nan(""), diameter = setup.start.diameter;
  const auto *speed = table.find("motor.speed"), *advance = table.find("advance_ratio"),
             *airSpeed = table.find("air_speed"), *ct = table.find("ct"), *cp = table.find("cp"),
             *thrust = table.find("thrust"), *torque = table.find("motor.torque");
  std::vector<StateRow> rows;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    StateRow row{.speed = valueOr(speed, r, setup.speed)};
    if (!(row.speed > 0)) continue;
    const double turns = row.speed / kTurn;
    const double force = setup.air.density * turns * turns * std::pow(diameter, 4);
    row.advance = advance != nullptr    ? (*advance)[r]
                  : airSpeed != nullptr ? (*airSpeed)[r] / (turns * diameter)
                                        : 0;
    row.thrust = ct != nullptr ? (*ct)[r] : valueOr(thrust, r, nan) / force;
    row.power = cp != nullptr ? (*cp)[r] : valueOr(torque, r, nan) * kTurn / (force * diameter);
    if (std::isfinite(row.advance) && (std::isfinite(row.thrust) || std::isfinite(row.power)))
      rows.push_back(row);
  }
  return rows;
}

bool hasAnalyticSection(const PropellerGeometry& geometry) {
  return std::ranges::any_of(geometry.sections, [](const BladeSection& section) {
    return std::holds_alternative<AnalyticSection>(section.model);
  });
}

PropellerGeometry withValues(PropellerGeometry geometry, std::span<const FitParameter> parameters,
                             std::span<const double> p) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].key == kTwist) geometry.twistOffset = p[i];
    if (parameters[i].key != kDrag) continue;
    for (BladeSection& section : geometry.sections) {
      if (auto* analytic = std::get_if<AnalyticSection>(&section.model))
        analytic->constants.profileDrag *= p[i];
    }
  }
  return geometry;
}

std::vector<FitParameter> parametersOf(const PropellerFitSetup& setup) {
  std::vector<FitParameter> parameters;
  if (setup.fitTwistOffset) {
    parameters.push_back({kTwist, "Twist offset", "rad", "deg", setup.start.twistOffset,
                          -kMostTwist, kMostTwist, 0.02});
  }
  if (setup.fitDrag) parameters.push_back({kDrag, "Profile drag factor", "1", "1", 1, 0.05, 20, 1});
  return parameters;
}

double meanSize(const std::vector<StateRow>& rows, double StateRow::*member) {
  double sum = 0;
  std::size_t count = 0;
  for (const StateRow& row : rows) {
    if (std::isfinite(row.*member)) sum += std::abs(row.*member), ++count;
  }
  return sum > 0 ? sum / static_cast<double>(count) : 1;
}

enum CoefficientOutput : std::size_t { kThrust, kPower };

void predictRows(const std::vector<StateRow>& rows, const BladeElementRotor& rotor,
                 const AirState& air, std::span<double> predicted) {
  const double diameter = 2 * rotor.radius();
  InflowMemory memory;
  std::size_t i = 0;
  for (const StateRow& row : rows) {
    const double turns = row.speed / kTurn;
    const double force = air.density * turns * turns * std::pow(diameter, 4);
    const AxialLoad load = rotor.axial(row.speed, row.advance * turns * diameter, air, &memory);
    if (std::isfinite(row.thrust)) predicted[i++] = load.thrust / force;
    if (std::isfinite(row.power)) predicted[i++] = load.torque * kTurn / (force * diameter);
  }
}

}  // namespace

std::vector<std::string> missingForPropellerFit(const MeasuredTable& table,
                                                const PropellerFitSetup& setup) {
  std::vector<std::string> missing;
  const bool force = table.find("ct") != nullptr || table.find("thrust") != nullptr;
  const bool torque = table.find("cp") != nullptr || table.find("motor.torque") != nullptr;
  if (!force && !torque) {
    missing.emplace_back("The measured data have neither CT or thrust nor CP or torque.");
  }
  if (table.find("motor.speed") == nullptr && !(setup.speed > 0)) {
    missing.emplace_back("The measured data have no column for Motor speed; give the speed.");
  }
  if (!setup.fitTwistOffset && !setup.fitDrag) {
    missing.emplace_back("No parameter is chosen to be fitted.");
  }
  if (setup.fitDrag && !hasAnalyticSection(setup.start)) {
    missing.emplace_back("The blade has no analytic section whose drag could be fitted.");
  }
  if (missing.empty() && rowsOf(table, setup).size() < 2) {
    missing.emplace_back("Fewer than two rows hold a turning propeller with a coefficient.");
  }
  return missing;
}

FitProblem propellerFitProblem(const MeasuredTable& table, const PropellerFitSetup& setup) {
  throwIfAny(table, missingForPropellerFit(table, setup));
  const std::vector<StateRow> rows = rowsOf(table, setup);
  FitProblem problem;
  problem.parameters = parametersOf(setup);
  problem.outputs = {{"Thrust coefficient CT", "1", "1", meanSize(rows, &StateRow::thrust)},
                     {"Power coefficient CP", "1", "1", meanSize(rows, &StateRow::power)}};
  const bool flown =
      std::ranges::any_of(rows, [](const StateRow& row) { return row.advance != 0; });
  problem.abscissa = flown ? "Advance ratio J" : "Motor speed";
  problem.abscissaUnit = flown ? "1" : "rad/s";
  problem.abscissaShown = flown ? "1" : "rpm";
  for (const StateRow& row : rows) {
    const double x = flown ? row.advance : row.speed;
    if (std::isfinite(row.thrust)) problem.points.push_back({kThrust, x, row.thrust});
    if (std::isfinite(row.power)) problem.points.push_back({kPower, x, row.power});
  }
  problem.predict = [rows, setup, parameters = problem.parameters](std::span<const double> p,
                                                                   std::span<double> predicted) {
    const BladeElementRotor rotor(withValues(setup.start, parameters, p), setup.settings);
    predictRows(rows, rotor, setup.air, predicted);
    return true;
  };
  return problem;
}

PropellerGeometry propellerFrom(const FitResult& result, const PropellerFitSetup& setup) {
  std::vector<FitParameter> parameters;
  std::vector<double> values;
  for (const FittedParameter& fitted : result.parameters) {
    if (!fitted.determined) continue;
    parameters.push_back(fitted.parameter);
    values.push_back(fitted.value);
  }
  return withValues(setup.start, parameters, values);
}

}  // namespace rotorbench
