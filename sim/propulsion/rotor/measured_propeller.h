// A propeller by measured coefficients, from a wind tunnel or a stand: T = CT rho n^2 D^4, P = CP
// rho n^3 D^5 against the advance ratio J = V/(n D) and, where it was measured, the speed. Between
// points of one speed a monotone cubic (F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5,
// 1984), between speeds straight lines, beyond the slowest and the fastest the nearest.
//
// Worked out in thrust and torque over 0.5 rho A U^2, U = hypot(V, 0.75 Om R), against the
// direction of the air at 75 % radius, chi = atan2(V, 0.75 Om R), as PropellerMap does: finite
// where the propeller stands in a stream. Beyond the measured J a cubic leads, with the slope of
// the last point, to a propeller that stands (kParkedThrust, kParkedTorque): past zero thrust it
// works as a windmill and brakes, below J = 0 it descends. That is a guess of the right kind and
// size, not a measurement. In-plane air speed acts by the coefficients of InPlaneFlow. SI, rad;
// frame as in rotor.h.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/core/scalar.h"
#include "sim/core/schema.h"
#include "sim/propulsion/rotor/hub_load.h"

namespace rotorbench {

/// One measured state.
struct CoefficientPoint {
  double speed = 0;  ///< rad/s; 0: holds at every speed, as do then all points
  double advanceRatio = 0;
  double thrustCoefficient = 0;
  double powerCoefficient = 0;
  bool operator==(const CoefficientPoint&) const = default;
};

/// What in-plane air speed does to a rotor whose axial flow is known, at an air density of 1.225
/// kg/m^3.
struct InPlaneFlow {
  double drag = 0;               ///< k_d, N s^2/m: in-plane force per rotor speed and air speed
  double translationalLift = 0;  ///< k_h, N s^2/m^2: thrust per in-plane air speed squared
  double flapping = 0;           ///< k_flap, N s^2: hub moment per rotor speed and air speed
  bool operator==(const InPlaneFlow&) const = default;
};

/// Points in any order. Speeds within 2 % of each other are one curve; a curve without a point at
/// rest takes it from the points measured at rest alone (a static test), or is continued straight
/// to it. Default: APC 10x4.7 slow flyer.
struct MeasuredPropeller {
  double diameter = 0.254;  ///< m
  std::vector<CoefficientPoint> points = slowFlyer10x47();
  InPlaneFlow inPlane;
  bool operator==(const MeasuredPropeller&) const = default;

  static std::vector<CoefficientPoint> slowFlyer10x47();
};

/// What no curve can be made of; empty if one can. Paths are relative to the propeller.
std::vector<Problem> pointProblems(const MeasuredPropeller& propeller);

/// Thrust and torque coefficients of a standing propeller in an axial stream from the front, over
/// 0.5 rho V^2 A and (the torque) R; against the thrust and with the rotation. The mean of the
/// blade-element solutions of 101 propellers.
inline constexpr double kParkedThrust = 0.2, kParkedTorque = 0.035;

/// The measured coefficients made ready. Any scalar; no heap and no exception in load().
class CoefficientTable {
 public:
  /// The propeller must satisfy its schema.
  explicit CoefficientTable(const MeasuredPropeller& propeller);

  /// Speed w in rad/s (turning backwards by the rule of BladeElementRotor::axial()), hub velocity
  /// against the air in m/s and unit axis in body axes, spin +1 or -1, density in kg/m^3. Finite
  /// for all finite numbers.
  template <class S, class Vector, class Axis>
  [[nodiscard]] RotorLoad<S, Vector> load(const S& w, const Vector& v, const Axis& axis,
                                          double spin, const S& density) const {
    using std::abs;
    const HubStream<S> stream = hubStream<S>(v, axis);
    const Coefficients<S> at = axialLoad(w, stream.axial, density);
    const S drive = density * abs(w);
    return hubLoad<S>(v, axis, spin, stream.axial,
                      S(at.thrust + lift_ * density * stream.acrossSquared), at.torque,
                      S(drag_ * drive), S(flapping_ * drive));
  }

  /// A thrust and a torque; in N and N m, or as coefficients.
  template <class S>
  struct Coefficients {
    S thrust = S(0.0), torque = S(0.0);
  };

  /// Thrust in N and torque in N m at speed w, rad/s, in an axial stream, m/s.
  template <class S>
  [[nodiscard]] Coefficients<S> axialLoad(const S& w, const S& axialSpeed, const S& density) const {
    using std::abs;
    using std::atan2;
    const double sign = valueOf(w) < 0 ? -1 : 1;
    const S along = sign * axialSpeed, across = kReferenceRadius * radius_ * abs(w);
    const S square = along * along + across * across;
    if (!(valueOf(square) > 0) || !(valueOf(density) > 0)) return {};
    const Coefficients<S> c = coefficients(S(atan2(along, across)), S(abs(w)));
    const S scale = sign * 0.5 * area_ * density * square;
    return {S(scale * c.thrust), S(scale * radius_ * c.torque)};
  }

  /// Over 0.5 rho A U^2 (and R), for a direction of the air in rad and a speed in rad/s, not
  /// negative.
  template <class S>
  [[nodiscard]] Coefficients<S> coefficients(const S& direction, const S& speed) const {
    std::size_t i = 0;
    while (i + 1 < curves_.size() && valueOf(speed) >= curves_[i + 1].speed) ++i;
    const Coefficients<S> low = curves_[i].at(direction);
    if (i + 1 == curves_.size() || !(valueOf(speed) > curves_[i].speed)) return low;
    const Coefficients<S> high = curves_[i + 1].at(direction);
    const S share = (speed - curves_[i].speed) / (curves_[i + 1].speed - curves_[i].speed);
    return {S(low.thrust + share * (high.thrust - low.thrust)),
            S(low.torque + share * (high.torque - low.torque))};
  }

  [[nodiscard]] double radius() const { return radius_; }

  /// What was measured. Speeds in rad/s, from 0 to infinity where the points hold at every speed; a
  /// speed within 2 % of a measured one counts as measured. Advance ratios are those known at the
  /// speed asked for and its neighbours.
  struct Limits {
    double leastSpeed, mostSpeed;
    double leastAdvance, mostAdvance;
  };
  /// The limits at a speed in rad/s, not negative; beyond the measured ones the nearest has a say.
  /// The least advance ratio may lie above the most where two neighbours have none in common.
  [[nodiscard]] Limits limits(double speed) const;

  /// CT and CP at one advance ratio, with their slopes against it.
  struct Knot {
    double advance, thrust, power, thrustSlope, powerSlope;
  };

 private:
  static constexpr double kReferenceRadius = 0.75;  // r/R
  // CT and CP over thrust and torque coefficients, per cos^2 chi.
  static constexpr double kThrustScale =
      8 / (std::numbers::pi * std::numbers::pi * std::numbers::pi * kReferenceRadius *
           kReferenceRadius);
  static constexpr double kTorqueScale = kThrustScale / std::numbers::pi;
  static constexpr double kAdvanceScale = kReferenceRadius * std::numbers::pi;  // J over tan chi

  /// From t = 0 to 1; slopes per t.
  template <class S>
  static S cubic(const S& t, double from, double fromSlope, double to, double toSlope) {
    const S s = 1.0 - t;
    return S(s * s * (from * (1.0 + 2.0 * t) + fromSlope * t) +
             t * t * (to * (1.0 + 2.0 * s) - toSlope * s));
  }

  /// The coefficients of one speed.
  struct Curve {
    /// A place beyond which nothing was measured: coefficients and their slopes against the
    /// direction.
    struct End {
      double direction, thrust, torque, thrustSlope, torqueSlope;
    };
    double speed = 0;
    std::vector<Knot> knots;
    End first{}, last{};
    double leastMeasured;  ///< J; the first knot may be a continuation to rest

    Curve(double curveSpeed, std::vector<Knot> points, double leastAdvance);

    template <class S>
    [[nodiscard]] Coefficients<S> at(const S& direction) const {
      const double chi = valueOf(direction);
      if (chi < first.direction) return beyond(direction, first, -1);
      if (!(chi < last.direction)) return beyond(direction, last, 1);
      using std::cos;
      using std::tan;
      const S advance = kAdvanceScale * tan(direction);
      std::size_t low = 0, high = knots.size() - 1;
      while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (valueOf(advance) < knots[middle].advance ? high : low) = middle;
      }
      const Knot &a = knots[low], &b = knots[high];
      const double width = b.advance - a.advance;
      const S t = (advance - a.advance) / width;
      const S cosine = cos(direction), square = cosine * cosine;
      const S thrust = cubic(t, a.thrust, a.thrustSlope * width, b.thrust, b.thrustSlope * width);
      const S power = cubic(t, a.power, a.powerSlope * width, b.power, b.powerSlope * width);
      return {S(kThrustScale * square * thrust), S(kTorqueScale * square * power)};
    }

   private:
    [[nodiscard]] static End endAt(const Knot& knot);
    template <class S>
    static Coefficients<S> beyond(const S& direction, const End& end, double side) {
      const double width = std::numbers::pi / 2 - side * end.direction;
      const S t = (side * direction - side * end.direction) / width;
      const double reach = side * width;
      return {cubic(t, end.thrust, end.thrustSlope * reach, -side * kParkedThrust, 0),
              cubic(t, end.torque, end.torqueSlope * reach, -side * kParkedTorque, 0)};
    }
  };

  std::vector<Curve> curves_;  // by rising speed
  double radius_ = 0, area_ = 0, drag_ = 0, lift_ = 0, flapping_ = 0;
};

template <>
struct Describe<CoefficientPoint> {
  static void fields(schema::Builder<CoefficientPoint>& b);
};
template <>
struct Describe<InPlaneFlow> {
  static void fields(schema::Builder<InPlaneFlow>& b);
};
template <>
struct Describe<MeasuredPropeller> {
  static void fields(schema::Builder<MeasuredPropeller>& b);
};

}  // namespace rotorbench
