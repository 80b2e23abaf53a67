#include "sim/validation/drive_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace rotorbench::validation {

namespace {

using Member = double DriveConstants::*;

std::vector<Member> fittedMembers(const DriveFitChoice& choice) {
  using C = DriveConstants;
  std::vector<Member> members{&C::torqueConstant, &C::resistance, &C::noLoadCurrent,
                              &C::loadCurrent};
  if (choice.viscous) members.push_back(&C::viscousCurrent);
  if (choice.standby) members.push_back(&C::standbyCurrent);
  if (choice.throttleCurve) {
    members.push_back(&C::dutyGain);
    members.push_back(&C::dutyOffset);
  }
  return members;
}

/// Residuals over constants in units of their guesses, so that all unknowns are of order 1.
struct Residuals {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const std::vector<LoggedPoint>& points;
  std::vector<Member> members;
  DriveConstants base;
  std::vector<double> scales;
  double speedFloor, currentFloor;

  [[nodiscard]] int inputs() const { return static_cast<int>(members.size()); }
  [[nodiscard]] int values() const { return 2 * static_cast<int>(points.size()); }
  [[nodiscard]] DriveConstants constantsAt(const Eigen::VectorXd& x) const {
    DriveConstants c = base;
    for (std::size_t i = 0; i < members.size(); ++i) {
      c.*members[i] = x[static_cast<Eigen::Index>(i)] * scales[i];
    }
    return c;
  }
  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& r) const {
    const DriveConstants c = constantsAt(x);
    Eigen::Index row = 0;
    for (const LoggedPoint& p : points) {
      const DrivePrediction model = predicted(c, p.duty, p.voltage);
      r[row++] = (model.speed - p.speed) / (p.speed + speedFloor);
      r[row++] = (model.current - p.current) / (p.current + currentFloor);
    }
    return 0;
  }
};

}  // namespace

DrivePrediction predicted(const DriveConstants& c, double duty, double voltage) {
  const double d = std::clamp(c.dutyGain * duty + c.dutyOffset, 0.0, 1.0);
  // R (kq/K) w^2 + (K + R f/K) w + R I0 - d V = 0
  const double square = c.resistance * c.loadCurrent;
  const double linear = c.torqueConstant + c.resistance * c.viscousCurrent;
  const double constant = c.resistance * c.noLoadCurrent - d * voltage;
  const double root = std::sqrt(std::max(0.0, linear * linear - 4 * square * constant));
  const double w = std::max(0.0, -2 * constant / (linear + root));
  const double i = c.noLoadCurrent + (c.viscousCurrent + c.loadCurrent * w) * w;
  return {w, d * i + c.standbyCurrent};
}

DriveConstants fitDrive(const std::vector<LoggedPoint>& points, const DriveFitChoice& choice,
                        const DriveConstants& guess, double floor) {
  double speed = 0, current = 0;
  for (const LoggedPoint& p : points) {
    speed = std::max(speed, p.speed);
    current = std::max(current, p.current);
  }
  Residuals residuals{points, fittedMembers(choice), guess, {}, floor * speed, floor * current};
  Eigen::VectorXd x(residuals.inputs());
  for (std::size_t i = 0; i < residuals.members.size(); ++i) {
    const double start = guess.*residuals.members[i];
    residuals.scales.push_back(start != 0 ? std::abs(start) : 0.1);
    x[static_cast<Eigen::Index>(i)] = start / residuals.scales.back();
  }
  Eigen::NumericalDiff<Residuals> slopes(residuals, 1e-12);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Residuals>> solver(slopes);
  solver.parameters.maxfev = 4000;
  solver.minimize(x);
  return residuals.constantsAt(x);
}

}  // namespace rotorbench::validation
