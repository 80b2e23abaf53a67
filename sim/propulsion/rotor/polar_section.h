// Sections known by their polars: lift and drag coefficients against the angle of attack, measured
// or computed at one or several Reynolds numbers. Between polars the coefficients are linear in ln
// Re, between points in the angle; outside the range of Reynolds numbers the nearest polar holds. A
// single polar says nothing of that: its least drag then goes with Re^e, the rest of it stays.
// Beyond the last point the values glide to Hoerner's flat plate, so that all angles have an
// answer. Angles in rad. Also reads the text files XFOIL and XFLR5 write (M. Drela, XFOIL 6.9 User
// Guide, command PACC).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/propulsion/rotor/analytic_section.h"

namespace rotorbench {

/// One line of a polar.
struct PolarPoint {
  double alpha = 0;  ///< rad
  double lift = 0;
  double drag = 0.01;
  bool operator==(const PolarPoint&) const = default;
};

/// Lift and drag at one Reynolds number, the points in the order of rising angle.
struct Polar {
  double reynolds = 1e5;
  std::vector<PolarPoint> points;
  bool operator==(const Polar&) const = default;
};

/// A section given by polars, at least one. The stall delay of Snel moves the lift of the polar
/// towards the line of attached flow by stallDelay (c/r)^2 of the difference (Snel's own value is
/// 3; 0 leaves it out). The exponent of a single polar's drag: a laminar boundary layer's is -0.5
/// (Blasius); the least drag of the shipped aerofoils with several polars, XFOIL's of Clark-Y, E63,
/// NACA 0012 and 4412 and the measured Clark-Y, goes with -0.41 to -0.64 between 3e4 and 1e6.
struct PolarSection {
  std::string name = "flat plate";
  std::vector<Polar> polars = thinSection();
  double stallDelay = 0;
  double dragExponent = -0.5;  ///< of a single polar

  bool operator==(const PolarSection&) const = default;

  /// A flat plate in attached flow to +-10 degrees: what a new polar section holds until it is
  /// filled.
  static std::vector<Polar> thinSection();
};

/// A text polar of XFOIL or XFLR5: a header that says "Re = 0.100 e 6", a line of names with alpha,
/// CL and CD, a line of dashes, then one line of numbers per angle (degrees). Points are sorted by
/// angle. Throws InputError naming the line at fault if there is no Reynolds number, no table,
/// fewer than two angles, an angle twice, a number that cannot be read or a negative drag.
Polar readXfoilPolar(std::string_view text, const std::string& source);

/// One uniform table of a polar over the full circle, made once.
class PolarTable {
 public:
  explicit PolarTable(const Polar& polar);

  [[nodiscard]] double logReynolds() const { return logReynolds_; }
  [[nodiscard]] double zeroLift() const { return zeroLift_; }
  [[nodiscard]] double liftSlope() const { return liftSlope_; }
  [[nodiscard]] double leastDrag() const { return leastDrag_; }

  struct Position {
    std::size_t index;
    double fraction;
  };
  /// Place of an angle (rad, any) in the tables; the same for every polar.
  static Position locate(double alpha);
  [[nodiscard]] SectionCoefficients at(const Position& p) const {
    const SectionCoefficients &a = values_[p.index], &b = values_[p.index + 1];
    return {a.lift + p.fraction * (b.lift - a.lift), a.drag + p.fraction * (b.drag - a.drag)};
  }

 private:
  void findZeroLift(const Polar& polar);

  std::vector<SectionCoefficients> values_;
  double logReynolds_ = 0, zeroLift_ = 0, liftSlope_ = 0, leastDrag_ = 0;
};

/// The polars of a section at one place and one Reynolds number: two tables and a weight. Valid
/// while the prepared section lives.
class PolarCurve {
 public:
  PolarCurve() = default;
  PolarCurve(const PolarTable& low, const PolarTable& high, double weight, double delay,
             double moreDrag = 0);

  [[nodiscard]] double zeroLift() const { return zeroLift_; }
  [[nodiscard]] double lift(double alpha) const { return at(alpha).lift; }
  /// As AnalyticCurve's, which needs sine and cosine.
  [[nodiscard]] double lift(double alpha, double /*sine*/, double /*cosine*/) const {
    return at(alpha).lift;
  }
  [[nodiscard]] SectionCoefficients at(double alpha) const;

 private:
  const PolarTable *low_ = nullptr, *high_ = nullptr;
  double weight_ = 0, delay_ = 0, zeroLift_ = 0, slope_ = 0, moreDrag_ = 0;
};

/// A polar section made ready: its tables in the order of rising Reynolds number.
class PreparedPolars {
 public:
  explicit PreparedPolars(const PolarSection& section);
  [[nodiscard]] PolarCurve curve(const SectionPlace& place, double reynolds) const;

 private:
  std::vector<PolarTable> tables_;
  double stallDelay_ = 0, dragExponent_ = 0;
};

template <>
struct Describe<PolarPoint> {
  static void fields(schema::Builder<PolarPoint>& b);
};
template <>
struct Describe<Polar> {
  static void fields(schema::Builder<Polar>& b);
};
template <>
struct Describe<PolarSection> {
  static void fields(schema::Builder<PolarSection>& b);
};

}  // namespace rotorbench
