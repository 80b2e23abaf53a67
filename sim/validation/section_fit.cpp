#include "sim/validation/section_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/parallel.h"
#include "sim/validation/propeller_scores.h"

namespace rotorbench::validation {

namespace {

/// A constant that is fitted: where it starts, and how far books leave it open.
struct Constant {
  const char* key;
  double SectionConstants::*member;
  double textbook, doubt, low, high;
};

using C = SectionConstants;
constexpr std::array<Constant, 17> kConstants{
    Constant{"liftSlope", &C::liftSlope, 6.28, 0.4, 4, 9},
    Constant{"liftSlopeReynolds", &C::liftSlopeReynolds, 0, 0.05, -0.3, 0.3},
    Constant{"zeroLift", &C::zeroLift, -0.06, 0.03, -0.2, 0.1},
    Constant{"zeroLiftReynolds", &C::zeroLiftReynolds, 0, 0.015, -0.1, 0.1},
    Constant{"zeroLiftChord", &C::zeroLiftChord, 0, 0.2, -2, 2},
    Constant{"slowFlyerCamber", &C::slowFlyerCamber, 0, 0.05, -0.1, 0.2},
    Constant{"stallLift", &C::stallLift, 1.3, 0.3, 0.5, 3},
    Constant{"stallLiftReynolds", &C::stallLiftReynolds, 0.1, 0.1, -0.3, 0.6},
    Constant{"negativeStallLift", &C::negativeStallLift, 0.8, 0.3, 0.3, 2},
    Constant{"stallWidth", &C::stallWidth, 0.05, 0.02, 0.02, 0.2},
    Constant{"stallDelay", &C::stallDelay, 3, 3, 0, 20},
    Constant{"stallDelayLimit", &C::stallDelayLimit, 0.9, 0.1, 0, 0.99},
    Constant{"stallDelayFade", &C::stallDelayFade, 0.6, 0.15, 0.2, 1.5},
    Constant{"profileDrag", &C::profileDrag, 0.015, 0.005, 0.004, 0.06},
    Constant{"profileDragReynolds", &C::profileDragReynolds, -0.35, 0.15, -1, 0.3},
    Constant{"broadside", &C::broadside, kBroadside, 0.2, 1, 3},
    Constant{"separatedDragFactor", &C::separatedDragFactor, 2, 3, 0, 20}};
constexpr Constant kMomentum{"momentumFactor", nullptr, 0.8, 0.1, 0.4, 1.2};
constexpr Constant kPitch{"pitchWeight", nullptr, 1.2, 0.6, 0, 2.4};

/// Annuli of a fit: half as many move the coefficients by less than the fit leaves.
constexpr int kElements = 12;

/// Points of a run that are fitted to, spread over it.
constexpr std::size_t kStillPoints = 3, kFlightPoints = 8;

std::vector<std::size_t> spread(std::size_t size, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t count = std::min(size, most);
  for (std::size_t k = 0; k < count; ++k)
    chosen.push_back(count < 2 ? 0 : k * (size - 1) / (count - 1));
  return chosen;
}

/// What one set gives the fit: residuals, which are nought where model and measurement agree.
class FittedSet {
 public:
  explicit FittedSet(const PropellerSet& set) : set_(&set) {
    for (const std::size_t i : spread(set.still.size(), kStillPoints))
      still_.push_back(set.still[i]);
    for (const auto& run : set.flights) {
      for (const std::size_t i : spread(run.size(), kFlightPoints / 2 + 1))
        flight_.push_back(run[i]);
    }
    std::vector<PropellerPoint> few;
    for (const std::size_t i : spread(flight_.size(), kFlightPoints)) few.push_back(flight_[i]);
    flight_ = std::move(few);
    for (const PropellerPoint& p : set.still) {
      thrust_ += p.thrust / static_cast<double>(set.still.size());
      power_ += p.power / static_cast<double>(set.still.size());
    }
  }
  [[nodiscard]] std::size_t residuals() const { return 2 * (still_.size() + flight_.size()); }

  [[nodiscard]] std::vector<double> at(const BladeConstants& constants) const {
    constexpr double kStatic = 1, kFlight = 0.7, kLeast = 0.02;
    const BladeElementRotor rotor = rotorWith(set_->geometry, constants, kElements);
    std::vector<double> all;
    const double still = kStatic / std::sqrt(static_cast<double>(still_.size()));
    for (const PropellerPoint& p : still_) {
      const Coefficients c = coefficients(rotor, p.speed, 0);
      all.push_back(still * std::log(std::max(c.thrust / p.thrust, kLeast)));
      all.push_back(still * std::log(std::max(c.power / p.power, kLeast)));
    }
    const double flight = kFlight / std::sqrt(static_cast<double>(flight_.size()));
    for (const PropellerPoint& p : flight_) {
      const Coefficients c = coefficients(rotor, p.speed, p.advance);
      all.push_back(flight * (c.thrust - p.thrust) / thrust_);
      all.push_back(flight * (c.power - p.power) / power_);
    }
    return all;
  }

 private:
  const PropellerSet* set_;
  std::vector<PropellerPoint> still_, flight_;
  double thrust_ = 0, power_ = 0;  // static, mean over the speeds
};

BladeConstants constantsOf(std::span<const double> values) {
  BladeConstants constants;
  for (std::size_t i = 0; i < kConstants.size(); ++i)
    constants.section.*kConstants.at(i).member = values[i];
  constants.momentumFactor = values[kConstants.size()];
  constants.pitchWeight = values[kConstants.size() + 1];
  return constants;
}

std::vector<Constant> allConstants() {
  std::vector<Constant> all(kConstants.begin(), kConstants.end());
  all.push_back(kMomentum);
  all.push_back(kPitch);
  return all;
}

}  // namespace

BladeConstants textbookConstants() {
  std::vector<double> values;
  for (const Constant& c : allConstants()) values.push_back(c.textbook);
  return constantsOf(values);
}

BladeElementRotor rotorWith(const PropellerGeometry& geometry, const BladeConstants& constants,
                            int elements) {
  PropellerGeometry g = geometry;
  g.twistOffset += (1 - constants.pitchWeight) * nominalPitchBlend(geometry);
  for (BladeSection& section : g.sections) {
    if (auto* analytic = std::get_if<AnalyticSection>(&section.model))
      analytic->constants = constants.section;
  }
  return BladeElementRotor(g, {.elements = elements, .momentumFactor = constants.momentumFactor});
}

namespace {

/// Residuals of all sets and of the books over the constants, each in parts of its doubt.
class SectionProblem {
 public:
  explicit SectionProblem(const std::vector<const PropellerSet*>& sets) {
    for (const PropellerSet* set : sets) fitted_.emplace_back(*set);
    size_ = static_cast<Eigen::Index>(all_.size());
    for (const FittedSet& set : fitted_) size_ += static_cast<Eigen::Index>(set.residuals());
    const auto n = static_cast<Eigen::Index>(all_.size());
    start = low = high = Eigen::VectorXd(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Constant& c = all_[static_cast<std::size_t>(i)];
      start[i] = 0;
      low[i] = (c.low - c.textbook) / c.doubt, high[i] = (c.high - c.textbook) / c.doubt;
    }
  }
  [[nodiscard]] BladeConstants constants(const Eigen::VectorXd& p) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < all_.size(); ++i)
      values.push_back(all_[i].textbook + p[static_cast<Eigen::Index>(i)] * all_[i].doubt);
    return constantsOf(values);
  }
  [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& p) const {
    const BladeConstants at = constants(p);
    const auto measured =
        inParallel(fitted_.size(), [&](std::size_t i) { return fitted_[i].at(at); });
    Eigen::VectorXd r(size_);
    r.head(p.size()) = p;
    Eigen::Index k = p.size();
    for (const auto& some : measured)
      for (const double value : some) r[k++] = softened(value / kUsualMiss);
    return r;
  }
  /// By forward differences: a residual is smooth, and its scatter is far above their error.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& p, const Eigen::VectorXd& r) const {
    constexpr double kStep = 0.02;
    Eigen::MatrixXd j(size_, p.size());
    for (Eigen::Index i = 0; i < p.size(); ++i) {
      const double step = p[i] + kStep < high[i] ? kStep : -kStep;
      Eigen::VectorXd q = p;
      q[i] += step;
      j.col(i) = (residuals(q) - r) / step;
    }
    return j;
  }

  Eigen::VectorXd start, low, high;

 private:
  /// Squared, the soft L1 loss: beyond 1 a residual counts in proportion.
  static double softened(double r) {
    return std::copysign(std::sqrt(2 * (std::hypot(1.0, r) - 1)), r);
  }
  /// A residual counts in parts of what blade elements miss a propeller by that they do not know.
  static constexpr double kUsualMiss = 0.25;

  std::vector<Constant> all_ = allConstants();
  std::vector<FittedSet> fitted_;
  Eigen::Index size_ = 0;
};

}  // namespace

// Levenberg and Marquardt's method: J. Nocedal, S. J. Wright, Numerical Optimization, 2006, ch. 10.
BladeConstants fittedConstants(const std::vector<const PropellerSet*>& sets) {
  constexpr int kMostIterations = 30, kMostTries = 6;
  constexpr double kEnough = 1e-3;  // gain of an iteration that ends the fit
  const SectionProblem problem(sets);
  Eigen::VectorXd p = problem.start, r = problem.residuals(p);
  double damping = 1e-2, gain = 1;
  for (int i = 0; i < kMostIterations && gain > kEnough; ++i) {
    const Eigen::MatrixXd j = problem.jacobian(p, r);
    Eigen::MatrixXd normal = j.transpose() * j;
    const Eigen::VectorXd slope = j.transpose() * r, diagonal = normal.diagonal();
    gain = 0;
    for (int k = 0; k < kMostTries && !(gain > 0); ++k) {
      normal.diagonal() = (1 + damping) * diagonal;
      const Eigen::VectorXd next =
          (p - normal.ldlt().solve(slope)).cwiseMax(problem.low).cwiseMin(problem.high);
      const Eigen::VectorXd left = problem.residuals(next);
      gain = 1 - left.squaredNorm() / r.squaredNorm();
      damping *= gain > 0 ? 0.2 : 5;
      if (gain > 0) p = next, r = left;
    }
  }
  return problem.constants(p);
}

}  // namespace rotorbench::validation
