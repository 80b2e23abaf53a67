#include "sim/fitting/motor_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/fitting/duty_source.h"
#include "sim/fitting/measured_rows.h"
#include "sim/propulsion/drive/steady_motor.h"

namespace rotorbench {

namespace {

/// Rows below this speed, rad/s, are a motor at rest.
constexpr double kTurning = 10;
constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

struct DriveRow {
  double throttle = 0, voltage = 0, current = 0, speed = 0;
  double torque = 0;  ///< N m that does not follow from the speed
  double motorCurrent = kNotMeasured;
  bool dutyKnown = false;

  /// A, of the motor, or the least it can be.
  [[nodiscard]] double leastMotorCurrent() const {
    if (std::isfinite(motorCurrent)) return std::abs(motorCurrent);
    return std::abs(dutyKnown ? current / throttle : current);
  }
};

/// A motor and the k_m of its load, as the fit moves them.
struct Candidate {
  MotorParameters motor;
  double torqueCoefficient = 0;
};

/// Parameters in the order of the problem, and where each goes.
struct Choice {
  FitParameter parameter;
  double Candidate::*coefficient = nullptr;
  double MotorParameters::*member = nullptr;
};

Candidate candidateOf(const MotorFitSetup& setup) {
  Candidate c{setup.start, setup.torque == ShaftTorque::Propeller ? setup.torqueCoefficient : 0};
  c.motor.resistance += setup.escResistance;
  return c;
}

std::vector<Choice> choicesOf(const MotorFitSetup& setup) {
  const Candidate start = candidateOf(setup);
  const MotorParameters& m = start.motor;
  std::vector<Choice> choices;
  if (setup.fitSpeedConstant) {
    choices.push_back({{"speedConstant", "Speed constant", "rad/s/V", "rpm/V", m.speedConstant,
                        0.1 * m.speedConstant, 10 * m.speedConstant, m.speedConstant},
                       nullptr,
                       &MotorParameters::speedConstant});
  }
  if (setup.fitResistance) {
    choices.push_back({{"resistance", "Resistance", "Ohm", "mOhm", m.resistance,
                        setup.escResistance + 1e-5, 100 * m.resistance, m.resistance},
                       nullptr,
                       &MotorParameters::resistance});
  }
  if (setup.fitNoLoadCurrent) {
    const double scale = std::max(m.noLoadCurrent, 0.1);
    choices.push_back(
        {{"noLoadCurrent", "No-load current", "A", "A", m.noLoadCurrent, 0, 100 * scale, scale},
         nullptr,
         &MotorParameters::noLoadCurrent});
  }
  if (setup.fitViscousShare) {
    choices.push_back(
        {{"viscousShare", "Viscous share of friction", "1", "%", m.viscousShare, 0, 1, 0.3},
         nullptr,
         &MotorParameters::viscousShare});
  }
  if (setup.fitTorqueCoefficient && setup.torque == ShaftTorque::Propeller) {
    const double k = start.torqueCoefficient;
    choices.push_back({{"torqueCoefficient", "Torque coefficient of the propeller", "N*m*s^2",
                        "N*m*s^2", k, 1e-3 * k, 1e3 * k, k, setup.torqueCoefficientIsGuess},
                       &Candidate::torqueCoefficient,
                       nullptr});
  }
  return choices;
}

Candidate apply(const std::vector<Choice>& choices, std::span<const double> p, Candidate c) {
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (choices[i].member != nullptr) c.motor.*choices[i].member = p[i];
    if (choices[i].coefficient != nullptr) c.*choices[i].coefficient = p[i];
  }
  return c;
}

std::vector<std::string_view> columnsFor(const MotorFitSetup& setup) {
  std::vector<std::string_view> keys{"motor.speed", "supply.voltage", "supply.current"};
  if (setup.duty != DutyFrom::Unknown) keys.emplace_back("throttle");
  if (setup.torque == ShaftTorque::Measured) keys.emplace_back("motor.torque");
  if (setup.torque == ShaftTorque::FromThrust) keys.emplace_back("thrust");
  return keys;
}

/// All rows of a turning motor.
std::vector<DriveRow> turningRows(const MeasuredTable& table, const MotorFitSetup& setup) {
  constexpr std::string_view kAlso[]{"motor.current"};
  std::vector<DriveRow> rows;
  for (const std::vector<double>& values : finiteRows(table, columnsFor(setup), kAlso)) {
    DriveRow row{.throttle = 1, .voltage = values[1], .current = values[2], .speed = values[0]};
    row.motorCurrent = values.back();
    std::size_t next = 3;
    if (setup.duty != DutyFrom::Unknown) row.throttle = values[next++];
    if (setup.torque == ShaftTorque::Measured) row.torque = std::abs(values[next]);
    if (setup.torque == ShaftTorque::FromThrust)
      row.torque = setup.torquePerThrust * std::abs(values[next]);
    row.dutyKnown = setup.duty == DutyFrom::Throttle ||
                    (setup.duty == DutyFrom::FullThrottle && row.throttle >= kFullThrottle);
    if (row.speed > kTurning && row.voltage > 0 && row.throttle > 0) rows.push_back(row);
  }
  return rows;
}

/// Without those at the current limit.
std::vector<DriveRow> rowsOf(const MeasuredTable& table, const MotorFitSetup& setup) {
  std::vector<DriveRow> rows = turningRows(table, setup);
  if (!(setup.currentLimit > 0)) return rows;
  const double least = setup.nearLimit * setup.currentLimit;
  double throttle = std::numeric_limits<double>::infinity();  // from which the limit acts
  for (const DriveRow& row : rows) {
    const bool derived = !std::isfinite(row.motorCurrent) && setup.duty != DutyFrom::Unknown;
    if (derived && row.leastMotorCurrent() >= least) throttle = std::min(throttle, row.throttle);
  }
  std::erase_if(rows, [&](const DriveRow& row) {
    return row.leastMotorCurrent() >= least ||
           (!std::isfinite(row.motorCurrent) && row.throttle >= throttle);
  });
  return rows;
}

/// Of a turning motor against torque + k w^2: its dry friction is constant.
SteadyCurrent currentOf(const MotorConstants& m, double k, const DriveRow& row) {
  return {(m.dryFriction + row.torque) / m.torqueConstant, m.viscousFriction / m.torqueConstant,
          k / m.torqueConstant};
}

/// Supply current without a duty: the power of the motor over the voltage.
double currentByPower(const MotorConstants& m, double k, const DriveRow& row) {
  const double i = currentOf(m, k, row).at(row.speed);
  return m.steadyVoltage(row.speed, i) * i / row.voltage;
}

enum DriveOutput : std::size_t { kSpeed, kCurrent };

FitProblem problemOf(std::vector<DriveRow> rows, const std::vector<Choice>& choices,
                     const Candidate& start) {
  FitProblem problem;
  for (const Choice& choice : choices) problem.parameters.push_back(choice.parameter);
  double mostSpeed = 0, mostCurrent = 0;
  for (const DriveRow& row : rows) {
    mostSpeed = std::max(mostSpeed, row.speed),
    mostCurrent = std::max(mostCurrent, std::abs(row.current));
    if (row.dutyKnown) problem.points.push_back({kSpeed, row.throttle, row.speed});
    problem.points.push_back({kCurrent, row.throttle, row.current});
  }
  problem.outputs = {{"Motor speed", "rad/s", "rpm", mostSpeed},
                     {"Supply current", "A", "A", std::max(mostCurrent, 1e-3)}};
  problem.abscissa = "Throttle";
  problem.abscissaUnit = std::string("1");  // GCC 12 takes an assigned "1" for an overflow
  problem.abscissaShown = std::string("%");
  problem.predict = [rows = std::move(rows), choices, start](std::span<const double> p,
                                                             std::span<double> predicted) {
    const Candidate at = apply(choices, p, start);
    const MotorConstants m = buildMotor(at.motor);
    std::size_t i = 0;
    for (const DriveRow& row : rows) {
      if (!row.dutyKnown) {
        predicted[i++] = currentByPower(m, at.torqueCoefficient, row);
        continue;
      }
      const SteadyCurrent current = currentOf(m, at.torqueCoefficient, row);
      const double speed =
          steadySpeed(current, m.torqueConstant, m.resistance, row.throttle * row.voltage);
      predicted[i++] = speed;
      predicted[i++] = row.throttle * current.at(speed);
    }
    return std::ranges::all_of(predicted, [](double value) { return std::isfinite(value); });
  };
  return problem;
}

/// The rows of the fit as far as they say what the throttle is: where a current limit acts, they do
/// not.
std::vector<DutyRow> dutyRows(const MeasuredTable& table, MotorFitSetup setup) {
  setup.duty = DutyFrom::Throttle;
  std::vector<DutyRow> rows;
  for (const DriveRow& row : rowsOf(table, setup))
    rows.push_back({row.throttle, row.speed, row.voltage});
  return rows;
}

/// With what an automatic choice comes to for this table.
MotorFitSetup decided(const MeasuredTable& table, MotorFitSetup setup) {
  if (setup.duty != DutyFrom::Automatic) return setup;
  const bool known = table.find("throttle") != nullptr;
  setup.duty = known ? dutySourceOf(dutyRows(table, setup)) : DutyFrom::Unknown;
  return setup;
}

}  // namespace

std::vector<std::string> missingForMotorFit(const MeasuredTable& table,
                                            const MotorFitSetup& asked) {
  const MotorFitSetup setup = decided(table, asked);
  std::vector<std::string> missing = missingColumns(table, columnsFor(setup));
  const std::vector<Choice> choices = choicesOf(setup);
  if (choices.empty()) missing.emplace_back("No parameter is chosen to be fitted.");
  if (!missing.empty()) return missing;
  const std::vector<DriveRow> rows = rowsOf(table, setup);
  if (rows.size() < choices.size()) {
    missing.push_back("Only " + std::to_string(rows.size()) +
                      " rows hold all the needed columns and a turning motor" +
                      (setup.currentLimit > 0 ? " below the current limit" : "") + "; at least " +
                      std::to_string(choices.size()) + " are needed.");
  }
  return missing;
}

MotorFitRows motorFitRows(const MeasuredTable& table, const MotorFitSetup& asked) {
  const MotorFitSetup setup = decided(table, asked);
  const std::size_t used = rowsOf(table, setup).size();
  return {used, turningRows(table, setup).size() - used};
}

std::string motorDutyText(const MeasuredTable& table, const MotorFitSetup& asked) {
  return asked.duty == DutyFrom::Automatic ? dutySourceText(dutyRows(table, asked)) : std::string();
}

FitProblem motorFitProblem(const MeasuredTable& table, const MotorFitSetup& asked) {
  const MotorFitSetup setup = decided(table, asked);
  throwIfAny(table, missingForMotorFit(table, setup));
  return problemOf(rowsOf(table, setup), choicesOf(setup), candidateOf(setup));
}

FittedMotor motorFrom(const FitResult& result, const MotorFitSetup& setup) {
  const std::vector<Choice> choices = choicesOf(setup);
  Candidate c = candidateOf(setup);
  for (const Choice& choice : choices) {
    const FittedParameter* found = result.find(choice.parameter.key);
    if (found == nullptr || !found->determined) continue;
    if (choice.member != nullptr) c.motor.*choice.member = found->value;
    if (choice.coefficient != nullptr) c.*choice.coefficient = found->value;
  }
  c.motor.resistance -= setup.escResistance;
  return {c.motor, c.torqueCoefficient};
}

}  // namespace rotorbench
