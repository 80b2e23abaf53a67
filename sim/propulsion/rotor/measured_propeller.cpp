#include "sim/propulsion/rotor/measured_propeller.h"

#include <algorithm>
#include <limits>
#include <string>

namespace rotorbench {

namespace {

constexpr double kSameSpeed = 0.02;    // of the slowest of a curve
constexpr double kSameAdvance = 1e-4;  // closer points are one, measured twice

using Points = std::vector<CoefficientPoint>;
using Knot = CoefficientTable::Knot;

/// The points of one speed each, by rising speed and advance ratio, repeated ones averaged.
std::vector<Points> groupsOf(Points points) {
  const auto mean = [](const Points& some) {
    CoefficientPoint sum{};
    for (const CoefficientPoint& p : some) {
      sum.speed += p.speed, sum.advanceRatio += p.advanceRatio;
      sum.thrustCoefficient += p.thrustCoefficient, sum.powerCoefficient += p.powerCoefficient;
    }
    const double share = 1 / static_cast<double>(some.size());
    return CoefficientPoint{sum.speed * share, sum.advanceRatio * share,
                            sum.thrustCoefficient * share, sum.powerCoefficient * share};
  };
  /// Cuts where `apart(first of the piece, point)` holds.
  const auto cut = [](const Points& sorted, const auto& apart) {
    std::vector<Points> pieces;
    for (const CoefficientPoint& p : sorted) {
      if (pieces.empty() || apart(pieces.back().front(), p)) pieces.emplace_back();
      pieces.back().push_back(p);
    }
    return pieces;
  };
  std::ranges::stable_sort(points, {}, &CoefficientPoint::speed);
  std::vector<Points> groups = cut(
      points, [](const auto& a, const auto& b) { return b.speed > a.speed * (1 + kSameSpeed); });
  for (Points& group : groups) {
    std::ranges::stable_sort(group, {}, &CoefficientPoint::advanceRatio);
    const auto repeated = cut(group, [](const auto& a, const auto& b) {
      return b.advanceRatio > a.advanceRatio + kSameAdvance;
    });
    const double speed = mean(group).speed;
    group.clear();
    for (const Points& some : repeated) {
      group.push_back(mean(some));
      group.back().speed = speed;
    }
  }
  return groups;
}

/// Straight between points sorted by `key`, the end values beyond them.
CoefficientPoint between(const Points& points, double CoefficientPoint::*key, double x) {
  if (x <= points.front().*key) return points.front();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const CoefficientPoint &a = points[i - 1], &b = points[i];
    if (x > b.*key) continue;
    const double t = (x - a.*key) / (b.*key - a.*key);
    const auto mix = [&](double CoefficientPoint::*m) { return a.*m + t * (b.*m - a.*m); };
    return {mix(&CoefficientPoint::speed), mix(&CoefficientPoint::advanceRatio),
            mix(&CoefficientPoint::thrustCoefficient), mix(&CoefficientPoint::powerCoefficient)};
  }
  return points.back();
}

/// The state at rest of a curve that begins above it.
CoefficientPoint restOf(const Points& curve, const Points& still) {
  const CoefficientPoint &a = curve[0], &b = curve[1];
  CoefficientPoint rest = a;
  rest.advanceRatio = 0;
  if (still.empty()) {
    const double t = a.advanceRatio / (b.advanceRatio - a.advanceRatio);
    rest.thrustCoefficient -= t * (b.thrustCoefficient - a.thrustCoefficient);
    rest.powerCoefficient -= t * (b.powerCoefficient - a.powerCoefficient);
  } else {
    const CoefficientPoint at = between(still, &CoefficientPoint::speed, a.speed);
    rest.thrustCoefficient = at.thrustCoefficient;
    rest.powerCoefficient = at.powerCoefficient;
  }
  return rest;
}

/// A speed known at rest only: the curve nearest in speed, moved at rest and less and less up to
/// its end.
Points movedCurve(const std::vector<Points>& curves, const CoefficientPoint& rest) {
  Points curve = *std::ranges::min_element(
      curves, {}, [&](const Points& c) { return std::abs(c.front().speed - rest.speed); });
  const CoefficientPoint old = between(curve, &CoefficientPoint::advanceRatio, 0);
  const double end = curve.back().advanceRatio;
  for (CoefficientPoint& p : curve) {
    const double share = end > 0 ? std::clamp(1 - p.advanceRatio / end, 0.0, 1.0) : 1.0;
    p.speed = rest.speed;
    p.thrustCoefficient += share * (rest.thrustCoefficient - old.thrustCoefficient);
    p.powerCoefficient += share * (rest.powerCoefficient - old.powerCoefficient);
  }
  return curve;
}

/// Fritsch and Butland's slope at a point between two secants of steps h and k; 0 at a turning
/// point.
double innerSlope(double h, double before, double k, double after) {
  if (!(before * after > 0)) return 0;
  const double a = 2 * k + h, b = k + 2 * h;
  return (a + b) / (a / before + b / after);
}

/// Slope at an end, of the parabola through three points, kept monotone (C. Moler, Numerical
/// Computing with MATLAB, section 3.6).
double endSlope(double h, double first, double k, double second) {
  const double slope = ((2 * h + k) * first - h * second) / (h + k);
  if (slope * first <= 0) return 0;
  if (first * second <= 0 && std::abs(slope) > std::abs(3 * first)) return 3 * first;
  return slope;
}

void setSlopes(std::vector<Knot>& knots, double Knot::*value, double Knot::*slope) {
  const std::size_t last = knots.size() - 1;
  const auto step = [&](std::size_t i) { return knots[i + 1].advance - knots[i].advance; };
  const auto secant = [&](std::size_t i) {
    return (knots[i + 1].*value - knots[i].*value) / step(i);
  };
  if (last == 1) {
    knots[0].*slope = knots[1].*slope = secant(0);
    return;
  }
  for (std::size_t i = 1; i < last; ++i) {
    knots[i].*slope = innerSlope(step(i - 1), secant(i - 1), step(i), secant(i));
  }
  knots[0].*slope = endSlope(step(0), secant(0), step(1), secant(1));
  knots[last].*slope = endSlope(step(last - 1), secant(last - 1), step(last - 2), secant(last - 2));
}

}  // namespace

CoefficientTable::Curve::Curve(double curveSpeed, std::vector<Knot> points, double leastAdvance)
    : speed(curveSpeed), knots(std::move(points)), leastMeasured(leastAdvance) {
  setSlopes(knots, &Knot::thrust, &Knot::thrustSlope);
  setSlopes(knots, &Knot::power, &Knot::powerSlope);
  first = endAt(knots.front());
  last = endAt(knots.back());
}

CoefficientTable::Curve::End CoefficientTable::Curve::endAt(const Knot& knot) {
  const double chi = std::atan(knot.advance / kAdvanceScale);
  const double square = std::cos(chi) * std::cos(chi), turn = std::sin(2 * chi);
  // dJ/dchi cos^2 chi is kAdvanceScale everywhere.
  return {chi, kThrustScale * square * knot.thrust, kTorqueScale * square * knot.power,
          kThrustScale * (kAdvanceScale * knot.thrustSlope - turn * knot.thrust),
          kTorqueScale * (kAdvanceScale * knot.powerSlope - turn * knot.power)};
}

CoefficientTable::CoefficientTable(const MeasuredPropeller& p)
    : radius_(p.diameter / 2),
      area_(std::numbers::pi * radius_ * radius_),
      drag_(p.inPlane.drag / kStandardDensity),
      lift_(p.inPlane.translationalLift / kStandardDensity),
      flapping_(p.inPlane.flapping / kStandardDensity) {
  std::vector<Points> measured;
  Points still;
  for (Points& group : groupsOf(p.points)) {
    if (group.size() > 1) {
      measured.push_back(std::move(group));
    } else {
      still.push_back(group.front());
    }
  }
  std::vector<double> continued;  // speeds of the curves whose state at rest nobody measured
  for (Points& curve : measured) {
    if (!(curve.front().advanceRatio > 0)) continue;
    curve.insert(curve.begin(), restOf(curve, still));
    if (still.empty()) continued.push_back(curve.front().speed);
  }
  std::vector<Points> all = measured;
  for (const CoefficientPoint& rest : still) all.push_back(movedCurve(measured, rest));
  std::ranges::stable_sort(all, {}, [](const Points& c) { return c.front().speed; });
  for (const Points& curve : all) {
    std::vector<Knot> knots;
    for (const CoefficientPoint& point : curve) {
      knots.push_back({point.advanceRatio, point.thrustCoefficient, point.powerCoefficient, 0, 0});
    }
    const double speed = curve.front().speed;
    const bool atRest = std::ranges::find(continued, speed) == continued.end();
    const double least = curve[atRest ? 0 : 1].advanceRatio;
    curves_.emplace_back(speed, std::move(knots), least);
  }
}

CoefficientTable::Limits CoefficientTable::limits(double speed) const {
  std::size_t i = 0;
  while (i + 1 < curves_.size() && speed >= curves_[i + 1].speed) ++i;
  const Curve& low = curves_[i];
  const Curve& high = i + 1 < curves_.size() && speed > low.speed ? curves_[i + 1] : low;
  Limits found{curves_.front().speed / (1 + kSameSpeed), curves_.back().speed * (1 + kSameSpeed),
               std::max(low.leastMeasured, high.leastMeasured),
               std::min(low.knots.back().advance, high.knots.back().advance)};
  if (curves_.back().speed == 0) found.mostSpeed = std::numeric_limits<double>::infinity();
  return found;
}

std::vector<Problem> pointProblems(const MeasuredPropeller& p) {
  const bool finite = std::ranges::all_of(p.points, [](const CoefficientPoint& point) {
    return std::isfinite(point.speed) && std::isfinite(point.advanceRatio);
  });
  if (!finite) return {};  // each such number is a problem of its own row
  const auto anySpeed = [](const CoefficientPoint& point) { return point.speed == 0; };
  const bool some = std::ranges::any_of(p.points, anySpeed);
  if (some && !std::ranges::all_of(p.points, anySpeed)) {
    return {{"points", "some points have a speed and some have none",
             "a speed in every row, or 0 in every row"}};
  }
  bool curve = false;
  for (const Points& group : groupsOf(p.points)) {
    curve = curve || group.size() > 1;
    if (group.size() == 1 && group.front().advanceRatio != 0 && p.points.size() > 1) {
      return {{"points", "a point in a stream stands alone at its speed",
               "several advance ratios at that speed, or only the one at rest"}};
    }
  }
  if (curve) return {};
  return {{"points", "there is no curve over the advance ratio",
           "two or more advance ratios at one speed at least"}};
}

std::vector<CoefficientPoint> MeasuredPropeller::slowFlyer10x47() {
  // 4014 and 6512 rpm in the tunnel (files kt0836, rd0841, rd0842), at rest from the static test
  // (kt0835).
  constexpr double kSlow = 420.3, kFast = 681.9;
  return {{kSlow, 0, 0.1158, 0.0466},      {kSlow, 0.142, 0.0994, 0.0451},
          {kSlow, 0.216, 0.0885, 0.0436},  {kSlow, 0.289, 0.0770, 0.0414},
          {kSlow, 0.361, 0.0652, 0.0392},  {kSlow, 0.438, 0.0502, 0.0352},
          {kSlow, 0.510, 0.0343, 0.0308},  {kSlow, 0.577, 0.0178, 0.0258},
          {kSlow, 0.647, -0.0011, 0.0199}, {kSlow, 0.719, -0.0218, 0.0130},
          {kFast, 0, 0.1299, 0.0531},      {kFast, 0.089, 0.1201, 0.0523},
          {kFast, 0.155, 0.1101, 0.0511},  {kFast, 0.225, 0.0974, 0.0483},
          {kFast, 0.287, 0.0865, 0.0460},  {kFast, 0.357, 0.0743, 0.0434},
          {kFast, 0.420, 0.0616, 0.0398},  {kFast, 0.486, 0.0469, 0.0351},
          {kFast, 0.551, 0.0306, 0.0302},  {kFast, 0.618, 0.0120, 0.0242},
          {kFast, 0.691, -0.0089, 0.0172}, {kFast, 0.755, -0.0281, 0.0106}};
}

void Describe<CoefficientPoint>::fields(schema::Builder<CoefficientPoint>& b) {
  using P = CoefficientPoint;
  using namespace schema;
  b.title("coefficient-point", "Measured point", "Coefficients at one advance ratio and speed.");
  b.number("speed", &P::speed, "Speed", "\u03a9", "rad/s")
      .range(atLeast(0), upTo(1e5))
      .shownIn("rpm")
      .help("0 in every row: the coefficients hold at every speed.");
  b.number("advanceRatio", &P::advanceRatio, "Advance ratio", "J", "1")
      .range(atLeast(-10), upTo(10))
      .help("V/(n D), n in turns per second; 0 at rest.");
  b.number("thrustCoefficient", &P::thrustCoefficient, "Thrust coefficient", "CT", "1")
      .range(atLeast(-10), upTo(10));
  b.number("powerCoefficient", &P::powerCoefficient, "Power coefficient", "CP", "1")
      .range(atLeast(-10), upTo(10));
}

void Describe<InPlaneFlow>::fields(schema::Builder<InPlaneFlow>& b) {
  using P = InPlaneFlow;
  using namespace schema;
  b.title("in-plane", "Air from the side",
          "In-plane drag, translational lift and flapping of a rotor, at 1.225 kg/m\u00b3.",
          "Svacha, Mohta, Kumar, ICUAS 2017; RotorPy");
  b.number("drag", &P::drag, "Rotor drag", "k_d", "N*s^2/m")
      .range(atLeast(0), upTo(1))
      .help("Force against in-plane motion: k_d times rotor speed times air speed.");
  b.number("translationalLift", &P::translationalLift, "Translational lift", "k_h", "N*s^2/m^2")
      .range(atLeast(0), upTo(10))
      .help("Thrust won in level flight: k_h times in-plane air speed squared.");
  b.number("flapping", &P::flapping, "Flapping", "k_flap", "N*s^2")
      .range(atLeast(0), upTo(1))
      .help("Moment at the hub from flapping blades.")
      .advanced();
}

void Describe<MeasuredPropeller>::fields(schema::Builder<MeasuredPropeller>& b) {
  using P = MeasuredPropeller;
  using namespace schema;
  b.title("measured", "Measured propeller",
          "Thrust and power coefficients over the advance ratio, from a wind tunnel or a stand. "
          "Beyond the measured range they are continued to a standing propeller.");
  b.number("diameter", &P::diameter, "Diameter", "D", "m").range(above(0), upTo(10)).shownIn("in");
  b.list("points", &P::points, "Measured points")
      .items(2, 20000)
      .table()
      .help("In any order. Rows whose speeds are within 2 % are one curve.")
      .source(
          "APC 10x4.7 SF: J. B. Brandt, M. S. Selig, UIUC Propeller Data Site, volume 1, files "
          "apcsf_10x4.7");
  b.group("inPlane", &P::inPlane, "Air from the side").advanced();
  b.check([](const P& p, std::vector<Problem>& problems) {
    for (Problem& problem : pointProblems(p)) problems.push_back(std::move(problem));
  });
}

}  // namespace rotorbench
