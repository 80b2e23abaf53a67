#include "sim/fitting/intervals.h"

#include <Eigen/SVD>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

#include "sim/numerics/scalar_search.h"

namespace rotorbench {

namespace {

/// Singular values below this part of the largest are noise of the differences the Jacobian was
/// made with.
constexpr double kNoise = 1e-6;
/// Least part a parameter has in a direction the data do not see to be called undetermined by it.
constexpr double kPart = 0.05;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// P(T <= t) of Student's t for t >= 0, by the incomplete beta function (Abramowitz and Stegun
/// 26.7.1).
double studentProbability(double t, double degrees) {
  return 1 - 0.5 * Eigen::numext::betainc(0.5 * degrees, 0.5, degrees / (degrees + t * t));
}

/// Names of the parameters that go together with `part` in what the data do not see; `unseen`
/// projects onto that.
std::string companions(const Eigen::MatrixXd& unseen, Eigen::Index part,
                       const std::vector<std::size_t>& free, const FitResult& result) {
  std::string names;
  for (Eigen::Index other = 0; other < unseen.rows(); ++other) {
    if (other == part || std::abs(unseen(part, other)) < kPart * kPart) continue;
    const std::string& label =
        result.parameters[free[static_cast<std::size_t>(other)]].parameter.label;
    names += (names.empty() ? "" : " and ") + label;
  }
  return names;
}

/// Remarks on the parameters with a part in what the data do not see; `unseen` projects onto that.
void remarkUndetermined(const Eigen::MatrixXd& unseen, const std::vector<std::size_t>& free,
                        FitResult& result) {
  for (Eigen::Index i = 0; i < unseen.rows(); ++i) {
    if (unseen.row(i).norm() < kPart) continue;
    FittedParameter& p = result.parameters[free[static_cast<std::size_t>(i)]];
    const std::string others = companions(unseen, i, free, result);
    p.determined = false;
    p.remark =
        others.empty()
            ? "The data do not determine this: nothing that was measured depends on it."
            : "The data do not determine this: " + others + " can make up for any change of it.";
  }
}

}  // namespace

double studentQuantile(double p, double degrees) {
  const auto beyond = [&](double t) { return studentProbability(t, degrees) - p; };
  double high = 1;
  while (beyond(high) < 0 && high < 1e12) high *= 2;
  return findRoot(beyond, 0, high, 1e-13 * high);
}

void judgeParameters(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals,
                     FitResult& result) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    FittedParameter& p = result.parameters[i];
    if (p.atBound()) {
      p.remark = "This stands at the end of its range: the data ask for more.";
    } else {
      free.push_back(i);
    }
  }
  result.correlation.assign(result.parameters.size(),
                            std::vector<double>(result.parameters.size(), kNone));
  const auto count = static_cast<Eigen::Index>(free.size());
  if (count == 0) return;

  // Columns of equal length: what is compared is the direction, not the unit.
  Eigen::MatrixXd scaled(jacobian.rows(), count);
  Eigen::VectorXd length(count);
  for (Eigen::Index c = 0; c < count; ++c) {
    const auto column = jacobian.col(static_cast<Eigen::Index>(free[static_cast<std::size_t>(c)]));
    length[c] = column.norm();
    scaled.col(c) = length[c] > 0 ? Eigen::VectorXd(column / length[c])
                                  : Eigen::VectorXd::Zero(jacobian.rows());
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  Eigen::Index seen = 0;
  while (seen < values.size() && values[seen] > kNoise * values[0] && values[0] > 0) ++seen;
  // With fewer points than parameters the thin V lacks directions: they are what V leaves over.
  const Eigen::MatrixXd known = svd.matrixV().leftCols(seen);
  const Eigen::MatrixXd unseen =
      Eigen::MatrixXd::Identity(count, count) - known * known.transpose();
  remarkUndetermined(unseen, free, result);

  const auto degrees = static_cast<double>(jacobian.rows() - seen);
  if (degrees < 1) {
    for (const std::size_t i : free) {
      result.parameters[i].remark =
          "There are no more points than parameters: the scatter, and with it the interval, is not "
          "known.";
    }
    return;
  }
  const double variance = residuals.squaredNorm() / degrees;
  const Eigen::MatrixXd root =
      known * values.head(seen).cwiseInverse().asDiagonal();  // covariance = root root^T
  const Eigen::MatrixXd covariance = root * root.transpose();
  const double t = studentQuantile(0.5 + 0.5 * result.confidence, degrees);
  for (Eigen::Index a = 0; a < count; ++a) {
    const std::size_t i = free[static_cast<std::size_t>(a)];
    if (!result.parameters[i].determined) continue;
    result.parameters[i].halfWidth = t * std::sqrt(variance * covariance(a, a)) / length[a];
    for (Eigen::Index b = 0; b < count; ++b) {
      const std::size_t k = free[static_cast<std::size_t>(b)];
      if (!result.parameters[k].determined) continue;
      result.correlation[i][k] = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
    }
  }
}

}  // namespace rotorbench
