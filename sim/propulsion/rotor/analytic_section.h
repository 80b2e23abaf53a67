// Lift and drag of a typical model-propeller section over the full circle of angles of attack,
// where the true section is unknown: a thin aerofoil whose constants follow the Reynolds number, a
// smooth stall, and a flat plate beyond it. The constants are global: they were fitted once to the
// static and in-flight coefficients of 101 propellers (UIUC Propeller Data Site: Brandt, Deters,
// Ananda, Selig), never to one propeller. Angles in rad. Valid for Reynolds numbers of about 1e4 to
// 3e5.
//   plate:       S. F. Hoerner, Fluid-Dynamic Drag, 1965, ch. 3
//   stall delay: H. Snel, R. Houwink, J. Bosschers, ECN-C-93-052, 1994
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/core/schema.h"

namespace rotorbench {

/// Lift and drag coefficients of a section.
struct SectionCoefficients {
  double lift = 0;
  double drag = 0;
};

/// Where on a blade a section works, as far as it changes the section's behaviour.
struct SectionPlace {
  double chordToTipRadius = 0;  ///< c/R
  double chordToRadius = 0;     ///< c/r
  bool slowFlyer = false;       ///< blade of a slow-flyer line: thin and strongly cambered
};

/// 1/(1 + e^-x), the smooth switch between the branches of a section.
inline double logistic(double x) {
  return 1 / (1 + std::exp(-x));
}

/// Normal force of a flat plate against the sine of the angle of attack, over that broadside
/// (Hoerner): sin a/(0.56 + 0.44 |sin a|), odd.
inline double plateNormalForce(double sine) {
  return sine / (0.56 + 0.44 * std::abs(sine));
}
/// Normal-force coefficient of a flat plate broadside to the flow without end effects (Hoerner).
inline constexpr double kBroadside = 2.0;

/// The constants of the analytic section, with L = ln(Re/1e5). Defaults: together with the momentum
/// factor and the weight of the printed pitch one fit to 101 propellers, by an evolution strategy
/// (CMA-ES, N. Hansen, 2006) for small medians and 90 % quantiles of the errors
/// sim/validation/propeller_scores.h describes, among those sets of constants that keep the thrust
/// stand and the full-scale propeller of sim/validation within their limits.
struct SectionConstants {
  double liftSlope = 6.53;             ///< 1/rad at Re 1e5
  double liftSlopeReynolds = 0.017;    ///< the slope goes with exp(this L)
  double zeroLift = -0.0584;           ///< rad, zero-lift angle at Re 1e5 of a blade of kChordOfFit
  double zeroLiftReynolds = -0.01394;  ///< rad per L
  double zeroLiftChord = 0.2457;       ///< rad per c/R beyond kChordOfFit
  double slowFlyerCamber = 0.0485;     ///< rad, taken off the zero-lift angle of slow-flyer blades
  double stallLift = 1.564;            ///< lift at positive stall and Re 1e5
  double stallLiftReynolds = 0.1724;   ///< the stall lift goes with exp(this L)
  double negativeStallLift = 0.7216;   ///< lift at negative stall, as a positive number
  double stallWidth = 0.0508;          ///< rad over which the flow separates
  double stallDelay = 6.859;           ///< times (c/r)^2: share of the lost lift won by rotation
  double stallDelayLimit = 0.95;       ///< largest such share
  double stallDelayFade = 0.7335;      ///< rad, angle at which the delay has faded to one half
  double profileDrag = 0.01633;        ///< drag of attached flow at Re 1e5
  double profileDragReynolds = -0.3188;  ///< the drag goes with exp(this L)
  double broadside = kBroadside;  ///< normal-force coefficient at 90 degrees, in separated flow
  double separatedDragFactor = 5.309;  ///< profile drags added to the plate's in separated flow
  bool operator==(const SectionConstants&) const = default;
};

/// The analytic section at one place and one Reynolds number, ready to be asked for many angles.
class AnalyticCurve {
 public:
  AnalyticCurve() = default;
  AnalyticCurve(const SectionConstants& c, const SectionPlace& place, double reynolds);

  /// Angle of attack without lift in attached flow, rad.
  [[nodiscard]] double zeroLift() const { return zeroLift_; }

  /// Lift coefficient; angle of attack within +-2 pi.
  [[nodiscard]] double lift(double alpha) const {
    return lift(alpha, std::sin(alpha), std::cos(alpha));
  }
  /// The same for whoever knows sine and cosine of the angle.
  [[nodiscard]] double lift(double alpha, double sine, double cosine) const {
    const double separated = separation(alpha);
    return (1 - separated) * attachedLift(alpha) +
           separated * broadside_ * plateNormalForce(sine) * cosine;
  }

  [[nodiscard]] SectionCoefficients at(double alpha) const {
    const double separated = separation(alpha), sine = std::sin(alpha);
    const double normal = broadside_ * plateNormalForce(sine);
    return {(1 - separated) * attachedLift(alpha) + separated * normal * std::cos(alpha),
            (1 - separated) * profileDrag_ + separated * (normal * sine + separatedDrag_)};
  }

 private:
  /// The attached branch ends here; beyond it the flow is separated anyway. rad from zero lift
  static constexpr double kAttachedLimit = 0.6;
  static constexpr double kFadeWidth = 0.1;  // rad, over which the stall delay fades

  [[nodiscard]] double attachedLift(double alpha) const {
    return slope_ * std::clamp(alpha - zeroLift_, -kAttachedLimit, kAttachedLimit);
  }
  /// Share of the flow that is separated: on the upper side, the lower one, or both.
  [[nodiscard]] double separation(double alpha) const {
    const double kept = delay_ * logistic((fade_ - std::abs(alpha)) / kFadeWidth);
    // 1 - (1 - upper)(1 - lower), each a switch over the same width: one exponential serves both.
    const double e = std::exp(std::clamp(alpha * inverseWidth_, -kMostExponent, kMostExponent));
    const double upper = (1 - kept) * e / (e + positiveStallPower_);
    const double lower = negativeStallPower_ / (e + negativeStallPower_);
    return upper + lower - upper * lower;
  }

  static constexpr double kMostExponent = 600;  // keeps the exponential finite and above 0

  double slope_ = 0, zeroLift_ = 0;
  double positiveStallPower_ = 1, negativeStallPower_ = 1;  // e^(angle of stall/width)
  double inverseWidth_ = 1, delay_ = 0, fade_ = 0, broadside_ = 0, profileDrag_ = 0,
         separatedDrag_ = 0;
};

/// The analytic section as a choice of an experiment.
struct AnalyticSection {
  SectionConstants constants;
  bool operator==(const AnalyticSection&) const = default;

  [[nodiscard]] AnalyticCurve curve(const SectionPlace& place, double reynolds) const {
    return {constants, place, reynolds};
  }
};

template <>
struct Describe<SectionConstants> {
  static void fields(schema::Builder<SectionConstants>& b);
};
template <>
struct Describe<AnalyticSection> {
  static void fields(schema::Builder<AnalyticSection>& b);
};

}  // namespace rotorbench
