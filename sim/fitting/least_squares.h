// Parameters of a model from measured points by non-linear least squares (Levenberg-Marquardt,
// Ceres Solver: S. Agarwal, K. Mierle), with intervals. Nothing of Ceres is seen here. Parameters
// and predictions are in SI units.
//   residual   r = (measured - predicted) / sigma of its output
//   interval   p +- t(97.5 %, n - k) sqrt(s^2 [(J^T J)^-1]_pp),  s^2 = sum r^2 / (n - k)
//   G. A. F. Seber, C. J. Wild, Nonlinear Regression, 1989, ch. 5 (linear approximation)
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rotorbench {

/// Something to be found. Bounds may be infinite.
struct FitParameter {
  std::string key;    ///< "motor.resistance"
  std::string label;  ///< "Resistance"
  std::string unit;   ///< SI
  std::string shown;  ///< unit a person reads
  double start = 0;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  double scale = 1;           ///< typical size of a change, above 0
  bool startIsGuess = false;  ///< nobody gave the start; being far from it means nothing
};

/// A predicted quantity; residuals of different outputs are weighed against each other.
struct FitOutput {
  std::string label;  ///< "Motor speed"
  std::string unit;   ///< SI
  std::string shown;
  double scale = 1;  ///< residuals count in parts of this, above 0
};

/// One measured number of one output; `x` is only for drawing.
struct FitPoint {
  std::size_t output = 0;
  double x = 0;
  double measured = 0;
};

struct FitProblem {
  std::vector<FitParameter> parameters;
  std::vector<FitOutput> outputs;
  std::vector<FitPoint> points;
  std::string abscissa, abscissaUnit, abscissaShown;  ///< what x is: "Throttle"
  /// The points predicted with parameters p; false where the model has no answer.
  std::function<bool(std::span<const double> p, std::span<double> predicted)> predict;
};

struct FitProgress {
  int iteration = 0;
  double rmse = 0;  ///< over all outputs, in parts of their scales
};

struct FitOptions {
  bool robust = false;  ///< soft L1 loss: outliers beyond two sigma count linearly
  /// A second pass with the scatter each output had in the first as its scale.
  bool weighByScatter = true;
  int mostIterations = 100;
  double confidence = 0.95;
  /// Called at each iteration; false ends the fit.
  std::function<bool(const FitProgress&)> progress;
};

struct FittedParameter {
  FitParameter parameter;
  double value = 0;
  /// Half of the confidence interval; empty if the data do not determine the parameter or it stands
  /// at a bound.
  std::optional<double> halfWidth;
  bool determined = true;
  std::string remark;  ///< one sentence where there is something to say

  [[nodiscard]] bool atBound() const {
    const double near = 1e-8 * parameter.scale;
    return value <= parameter.low + near || value >= parameter.high - near;
  }
};

struct FittedOutput {
  FitOutput output;
  std::size_t count = 0;
  double rmseBefore = 0, rmseAfter = 0;  ///< in the output's unit
  double rSquared = 0;                   ///< NaN where the measured values do not vary
};

enum class FitEnd { Converged, IterationsSpent, Cancelled, Failed };

struct FitResult {
  FitEnd end = FitEnd::Failed;
  std::string sentence;  ///< how it ended
  std::vector<FittedParameter> parameters;
  std::vector<FittedOutput> outputs;
  std::vector<double> predicted;  ///< at the points, with the fitted parameters
  std::vector<std::vector<double>>
      correlation;  ///< of the parameters; NaN where one has no interval
  int iterations = 0;
  double confidence = 0.95;

  [[nodiscard]] bool usable() const {
    return end == FitEnd::Converged || end == FitEnd::IterationsSpent;
  }
  [[nodiscard]] const FittedParameter* find(const std::string& key) const;
};

/// Blocks until the fit has ended; never throws for what happens inside it.
FitResult solveLeastSquares(const FitProblem& problem, const FitOptions& options = {});

/// The value that Student's t with `degrees` of freedom (1 or more) stays below with probability p,
/// 0.5 <= p < 1.
double studentQuantile(double p, double degrees);

}  // namespace rotorbench
