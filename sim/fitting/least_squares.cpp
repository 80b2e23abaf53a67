#include "sim/fitting/least_squares.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

#include "sim/fitting/intervals.h"

namespace rotorbench {

namespace {

/// Beyond so many sigmas the soft L1 loss counts linearly.
constexpr double kOutlier = 2;
/// Step of the central differences, in parts of a parameter's scale.
constexpr double kStep = 1e-5;

/// The residuals of all points as one block over one vector of parameters in parts of their scales.
class Residuals : public ceres::CostFunction {
 public:
  Residuals(const FitProblem& problem, std::vector<double> sigma, bool robust)
      : problem_(problem), sigma_(std::move(sigma)), robust_(robust) {
    set_num_residuals(static_cast<int>(problem.points.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameters.size()));
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const std::size_t n = problem_.points.size(), k = problem_.parameters.size();
    const std::vector<double> x(parameters[0], parameters[0] + k);
    if (!at(x, {residuals, n})) return false;
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    std::vector<double> above(n), below(n);
    for (std::size_t c = 0; c < k; ++c) {
      const double low = unscaled(c, problem_.parameters[c].low);
      const double high = unscaled(c, problem_.parameters[c].high);
      const double step = kStep * std::max(1.0, std::abs(x[c]));
      std::vector<double> up = x, down = x;
      up[c] = std::min(x[c] + step, high);
      down[c] = std::max(x[c] - step, low);
      if (!(up[c] > down[c]) || !at(up, above) || !at(down, below)) return false;
      for (std::size_t i = 0; i < n; ++i) {
        jacobians[0][i * k + c] = (above[i] - below[i]) / (up[c] - down[c]);
      }
    }
    return true;
  }

  [[nodiscard]] double unscaled(std::size_t parameter, double value) const {
    return value / problem_.parameters[parameter].scale;
  }

 private:
  bool at(const std::vector<double>& x, std::span<double> residuals) const {
    std::vector<double> p(x.size());
    for (std::size_t c = 0; c < x.size(); ++c) {
      const FitParameter& parameter = problem_.parameters[c];
      p[c] = std::clamp(x[c] * parameter.scale, parameter.low, parameter.high);
    }
    if (!problem_.predict(p, residuals)) return false;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      const FitPoint& point = problem_.points[i];
      double& r = residuals[i];
      r = (point.measured - r) / sigma_[point.output];
      // Squares of this sum to the soft L1 loss 2 c^2 (sqrt(1 + (r/c)^2) - 1).
      if (robust_) r *= std::sqrt(2 / (1 + std::sqrt(1 + r * r / (kOutlier * kOutlier))));
      if (!std::isfinite(r)) return false;
    }
    return true;
  }

  const FitProblem& problem_;
  std::vector<double> sigma_;
  bool robust_;
};

class Reporter : public ceres::IterationCallback {
 public:
  Reporter(const FitOptions& options, std::size_t points) : options_(options), points_(points) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    const double rmse = std::sqrt(2 * summary.cost / static_cast<double>(points_));
    const bool goOn = !options_.progress || options_.progress({summary.iteration, rmse});
    return goOn ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
  }

 private:
  const FitOptions& options_;
  std::size_t points_;
};

/// What one pass leaves behind.
struct Pass {
  ceres::Solver::Summary summary;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  ///< per unit of the parameters
};

Pass solveOnce(const FitProblem& problem, const FitOptions& options,
               const std::vector<double>& sigma, std::vector<double>& x) {
  ceres::Problem ceresProblem;
  auto* cost = new Residuals(problem, sigma, options.robust);  // the problem owns it
  ceresProblem.AddResidualBlock(cost, nullptr, x.data());
  for (std::size_t c = 0; c < x.size(); ++c) {
    const FitParameter& p = problem.parameters[c];
    const int index = static_cast<int>(c);
    if (std::isfinite(p.low))
      ceresProblem.SetParameterLowerBound(x.data(), index, cost->unscaled(c, p.low));
    if (std::isfinite(p.high))
      ceresProblem.SetParameterUpperBound(x.data(), index, cost->unscaled(c, p.high));
  }
  Reporter reporter(options, problem.points.size());
  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::DENSE_QR;
  settings.max_num_iterations = options.mostIterations;
  settings.function_tolerance = 1e-15;
  settings.parameter_tolerance = 1e-11;
  settings.gradient_tolerance = 1e-12;
  settings.num_threads = 1;
  settings.logging_type = ceres::SILENT;
  settings.callbacks.push_back(&reporter);
  Pass pass;
  ceres::Solve(settings, &ceresProblem, &pass.summary);

  const auto n = static_cast<Eigen::Index>(problem.points.size());
  const auto k = static_cast<Eigen::Index>(x.size());
  pass.residuals.resize(n);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(n, k);
  const double* block = x.data();
  double* jacobian = rows.data();
  if (!cost->Evaluate(&block, pass.residuals.data(), &jacobian)) return pass;
  pass.jacobian = rows;
  for (Eigen::Index c = 0; c < k; ++c) {
    pass.jacobian.col(c) /= problem.parameters[static_cast<std::size_t>(c)].scale;
  }
  return pass;
}

/// Root mean square of each output's residuals; robust: from the median of their sizes.
std::vector<double> scatterOf(const FitProblem& problem, const std::vector<double>& predicted,
                              bool robust) {
  constexpr double kMedianToSigma = 1.4826;  // of a normal distribution
  std::vector<double> sigma;
  for (std::size_t output = 0; output < problem.outputs.size(); ++output) {
    std::vector<double> sizes;
    double squares = 0;
    for (std::size_t i = 0; i < problem.points.size(); ++i) {
      if (problem.points[i].output != output) continue;
      sizes.push_back(std::abs(problem.points[i].measured - predicted[i]));
      squares += sizes.back() * sizes.back();
    }
    double scatter = problem.outputs[output].scale;
    if (!sizes.empty()) {
      scatter = std::sqrt(squares / static_cast<double>(sizes.size()));
      if (robust) {
        const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
        std::nth_element(sizes.begin(), middle, sizes.end());
        scatter = kMedianToSigma * *middle;
      }
    }
    // One output that happens to be met exactly must not push the others aside.
    constexpr double kLeast = 1e-4;
    sigma.push_back(std::max(scatter, kLeast * problem.outputs[output].scale));
  }
  return sigma;
}

FittedOutput figuresOf(const FitProblem& problem, std::size_t output,
                       const std::vector<double>& before, const std::vector<double>& after) {
  FittedOutput figures;
  figures.output = problem.outputs[output];
  double mean = 0, spread = 0, squaresBefore = 0, squaresAfter = 0;
  for (const FitPoint& point : problem.points) {
    if (point.output == output) mean += point.measured, ++figures.count;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(figures.count, 1));
  mean /= n;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const FitPoint& point = problem.points[i];
    if (point.output != output) continue;
    spread += std::pow(point.measured - mean, 2);
    squaresBefore += std::pow(point.measured - before[i], 2);
    squaresAfter += std::pow(point.measured - after[i], 2);
  }
  figures.rmseBefore = std::sqrt(squaresBefore / n);
  figures.rmseAfter = std::sqrt(squaresAfter / n);
  figures.rSquared =
      spread > 0 ? 1 - squaresAfter / spread : std::numeric_limits<double>::quiet_NaN();
  return figures;
}

void describeEnd(const ceres::Solver::Summary& summary, FitResult& result) {
  switch (summary.termination_type) {
    case ceres::CONVERGENCE:
    case ceres::USER_SUCCESS:
      result.end = FitEnd::Converged;
      result.sentence = "Converged.";
      break;
    case ceres::NO_CONVERGENCE:
      result.end = FitEnd::IterationsSpent;
      result.sentence = "Stopped after the allowed number of iterations; the values may move on.";
      break;
    case ceres::USER_FAILURE:
      result.end = FitEnd::Cancelled;
      result.sentence = "Cancelled.";
      break;
    case ceres::FAILURE:
      result.end = FitEnd::Failed;
      result.sentence = "The model could not be computed near the start values.";
      break;
  }
}

/// The faults of a problem that cannot be solved; empty if there are none.
std::string faultOf(const FitProblem& problem) {
  if (problem.parameters.empty()) return "No parameter is chosen to be fitted.";
  if (problem.points.empty()) return "There are no measured points to fit to.";
  if (problem.points.size() < problem.parameters.size()) {
    return "There are " + std::to_string(problem.points.size()) + " measured points for " +
           std::to_string(problem.parameters.size()) + " parameters; more points are needed.";
  }
  return {};
}

std::vector<double> startOf(const FitProblem& problem) {
  std::vector<double> start;
  for (const FitParameter& p : problem.parameters) {
    // Strictly inside: a difference at a bound would see one side only.
    const bool bounded = std::isfinite(p.low) && std::isfinite(p.high);
    const double margin = bounded ? 1e-3 * (p.high - p.low) : 1e-6 * p.scale;
    start.push_back(std::clamp(p.start, p.low + margin, p.high - margin));
  }
  return start;
}

}  // namespace

const FittedParameter* FitResult::find(const std::string& key) const {
  const auto at = std::ranges::find_if(
      parameters, [&](const FittedParameter& p) { return p.parameter.key == key; });
  return at == parameters.end() ? nullptr : &*at;
}

FitResult solveLeastSquares(const FitProblem& problem, const FitOptions& options) {
  FitResult result;
  result.confidence = options.confidence;
  result.sentence = faultOf(problem);
  if (!result.sentence.empty()) return result;

  const std::size_t n = problem.points.size();
  std::vector<double> values, before(n), sigma;
  for (const FitParameter& p : problem.parameters) values.push_back(p.start);
  result.predicted.resize(n);
  if (!problem.predict(values, before)) {
    result.sentence = "The model could not be computed near the start values.";
    return result;
  }
  for (const FitOutput& output : problem.outputs) sigma.push_back(output.scale);

  std::vector<double> x = startOf(problem);
  for (std::size_t c = 0; c < x.size(); ++c) x[c] /= problem.parameters[c].scale;
  const auto takeValues = [&] {
    for (std::size_t c = 0; c < x.size(); ++c) {
      const FitParameter& p = problem.parameters[c];
      values[c] = std::clamp(x[c] * p.scale, p.low, p.high);
    }
    return problem.predict(values, result.predicted);
  };
  Pass pass = solveOnce(problem, options, sigma, x);
  result.iterations = static_cast<int>(pass.summary.iterations.size());
  if (takeValues() && options.weighByScatter && pass.summary.IsSolutionUsable()) {
    sigma = scatterOf(problem, result.predicted, options.robust);
    pass = solveOnce(problem, options, sigma, x);
    result.iterations += static_cast<int>(pass.summary.iterations.size());
  }
  describeEnd(pass.summary, result);
  if (!result.usable()) return result;
  if (!takeValues() || pass.jacobian.size() == 0 || !pass.jacobian.allFinite()) {
    result.end = FitEnd::Failed;
    result.sentence = "The model cannot be computed with the values found.";
    return result;
  }
  for (std::size_t c = 0; c < values.size(); ++c) {
    result.parameters.push_back({problem.parameters[c], values[c], {}, true, {}});
  }
  for (std::size_t output = 0; output < problem.outputs.size(); ++output) {
    result.outputs.push_back(figuresOf(problem, output, before, result.predicted));
  }
  judgeParameters(pass.jacobian, pass.residuals, result);
  return result;
}

}  // namespace rotorbench
