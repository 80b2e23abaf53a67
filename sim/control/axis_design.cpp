#include "sim/control/axis_design.h"

#include <algorithm>
#include <cmath>

#include "sim/design/discretise.h"
#include "sim/design/integral_action.h"
#include "sim/design/lqr.h"
#include "sim/design/placement.h"

namespace rotorbench {

namespace {

/// Position and rate, and behind a lag the acceleration; the position is the output.
LinearSystem sampledAxis(const AxisModel& model) {
  const Eigen::Index n = model.lag > 0 ? 3 : 2;
  LinearSystem axis;
  axis.A = Eigen::MatrixXd::Zero(n, n);
  axis.B = Eigen::MatrixXd::Zero(n, 1);
  axis.A(0, 1) = 1;
  if (model.lag > 0) {
    axis.A(1, 2) = 1;
    axis.A(2, 2) = -1 / model.lag;
    axis.B(2, 0) = 1 / model.lag;
  } else {
    axis.B(1, 0) = 1;
  }
  axis.C = Eigen::MatrixXd::Zero(1, n);
  axis.C(0, 0) = 1;
  axis.D = Eigen::MatrixXd::Zero(1, 1);
  return holdSampled(axis, model.period);
}

/// From the row K of the states, then of the integral q(k+1) = q(k) - T y(k) of withIntegrators().
AxisGains gainsFrom(const Eigen::MatrixXd& row, const AxisModel& model, bool withIntegral,
                    double integralPole) {
  AxisGains g;
  g.position = row(0, 0);
  g.rate = row(0, 1);
  if (model.lag > 0) g.acceleration = row(0, 2);
  g.reference = g.position;
  if (!withIntegral) return g;
  g.integral = -row(0, row.cols() - 1) * model.period;
  // The zero of N + g/(z - 1) upon the integral's pole.
  const double decay = 1 - std::exp(-integralPole * model.period);
  g.reference = std::min(g.integral / decay, g.position);
  g.bleeding = std::min(1.0, decay);
  return g;
}

LinearSystem designModel(const AxisModel& model, bool withIntegral) {
  const LinearSystem plant = sampledAxis(model);
  return withIntegral ? withIntegrators(plant, model.period) : plant;
}

}  // namespace

AxisGains placedGains(const AxisModel& model, double frequency, double damping, double integral,
                      bool withIntegral) {
  using Complex = std::complex<double>;
  const LinearSystem plant = designModel(model, withIntegral);
  const Complex root = std::sqrt(Complex(damping * damping - 1, 0));
  Eigen::VectorXcd wanted(plant.A.rows());
  Eigen::Index n = 0;
  wanted[n++] = frequency * (-damping + root);
  wanted[n++] = frequency * (-damping - root);
  if (model.lag > 0) wanted[n++] = -1 / model.lag;
  if (withIntegral) wanted[n++] = -integral;
  const Eigen::MatrixXd gain =
      placeSingleInput(plant.A, plant.B, sampledPoles(wanted, model.period));
  return gainsFrom(gain, model, withIntegral, integral);
}

AxisGains optimalGains(const AxisModel& model, double error, double rate, double integral,
                       double demand, bool withIntegral) {
  const LinearSystem plant = designModel(model, withIntegral);
  const Eigen::Index n = plant.A.rows();
  // The sampled cost of the sum over the instants, times the period.
  Eigen::MatrixXd states = Eigen::MatrixXd::Zero(n, n), inputs(1, 1);
  states(0, 0) = 1 / (error * error);
  states(1, 1) = 1 / (rate * rate);
  if (withIntegral) states(n - 1, n - 1) = 1 / (integral * integral);
  inputs(0, 0) = 1 / (demand * demand);
  const LqrDesign design = sampledLqr(plant.A, plant.B, {states, inputs, {}});
  // The slowest pole is taken for the integral's.
  double slowest = HUGE_VAL;
  for (const auto& pole : continuousPoles(design.poles, model.period))
    slowest = std::min(slowest, -pole.real());
  return gainsFrom(design.gain, model, withIntegral, slowest);
}

Eigen::VectorXcd closedLoopPoles(const AxisModel& model, const AxisGains& gains) {
  const bool withIntegral = gains.integral != 0;
  const LinearSystem plant = designModel(model, withIntegral);
  Eigen::RowVectorXd row(plant.A.rows());
  Eigen::Index n = 0;
  row[n++] = gains.position;
  row[n++] = gains.rate;
  if (model.lag > 0) row[n++] = gains.acceleration;
  if (withIntegral) row[n++] = -gains.integral / model.period;
  return continuousPoles(poles(plant.A - plant.B * row), model.period);
}

}  // namespace rotorbench
