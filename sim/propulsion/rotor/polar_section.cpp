#include "sim/propulsion/rotor/polar_section.h"

#include "sim/core/constants.h"
#include "sim/core/rising.h"

namespace rotorbench {

namespace {

constexpr int kCells = 1440;  // of a quarter of a degree: finer than any polar is written
constexpr double kCell = 2 * kPi / kCells;
/// Angle over which a polar glides to the plate beyond its last point: about the width of the
/// drop of lift behind the stall in Hoerner's and Viterna's curves.
constexpr double kGlide = 10 * kPi / 180;
constexpr double kDelayLimit = 0.95;  // of the lift lost in stall, as in the analytic section
/// Reynolds numbers over which the drag of a single polar is carried: those of the aerofoils its
/// exponent was seen at, and a little below.
constexpr double kLeastCarried = 1e4, kMostCarried = 1e6;
constexpr double kDelayFade = 0.6, kDelayFadeWidth = 0.1;  // rad, likewise

SectionCoefficients plate(double alpha, double leastDrag) {
  const double sine = std::sin(alpha), normal = kBroadside * plateNormalForce(sine);
  return {normal * std::cos(alpha), normal * sine + leastDrag};
}

/// The polar itself within its points, beyond them a glide to the plate.
SectionCoefficients extended(const Polar& polar, double alpha, double leastDrag) {
  const auto& points = polar.points;
  const PolarPoint &first = points.front(), &last = points.back();
  if (alpha <= first.alpha || alpha >= last.alpha) {
    const PolarPoint& end = alpha <= first.alpha ? first : last;
    const SectionCoefficients here = plate(alpha, leastDrag), there = plate(end.alpha, leastDrag);
    const double left = std::exp(-std::abs(alpha - end.alpha) / kGlide);
    return {here.lift + left * (end.lift - there.lift),
            std::max(leastDrag, here.drag + left * (end.drag - there.drag))};
  }
  const auto above =
      std::upper_bound(points.begin(), points.end(), alpha,
                       [](double value, const PolarPoint& p) { return value < p.alpha; });
  const PolarPoint &b = *above, &a = *(above - 1);
  const double t = (alpha - a.alpha) / (b.alpha - a.alpha);
  return {a.lift + t * (b.lift - a.lift), a.drag + t * (b.drag - a.drag)};
}

}  // namespace

std::vector<Polar> PolarSection::thinSection() {
  constexpr double kEnd = 10 * kPi / 180;
  return {{1e5, {{-kEnd, -2 * kPi * kEnd, 0.02}, {0, 0, 0.01}, {kEnd, 2 * kPi * kEnd, 0.02}}}};
}

PolarTable::PolarTable(const Polar& polar) : logReynolds_(std::log(polar.reynolds)) {
  leastDrag_ = std::ranges::min_element(polar.points, {}, &PolarPoint::drag)->drag;
  values_.reserve(kCells + 1);
  for (int i = 0; i <= kCells; ++i) values_.push_back(extended(polar, i * kCell - kPi, leastDrag_));
  values_.back() = values_.front();
  findZeroLift(polar);
}

/// Lift zero nearest to no angle, and the slope of a straight line over the degrees around it.
void PolarTable::findZeroLift(const Polar& polar) {
  constexpr double kSpan = 4 * kPi / 180;
  const auto& p = polar.points;
  zeroLift_ = 0;
  double nearest = kPi;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    if ((p[i].lift < 0) == (p[i + 1].lift < 0)) continue;
    const double zero =
        p[i].alpha - p[i].lift * (p[i + 1].alpha - p[i].alpha) / (p[i + 1].lift - p[i].lift);
    if (std::abs(zero) < nearest) {
      nearest = std::abs(zero);
      zeroLift_ = zero;
    }
  }
  liftSlope_ = (at(locate(zeroLift_ + kSpan)).lift - at(locate(zeroLift_)).lift) / kSpan;
  liftSlope_ = std::clamp(liftSlope_, 0.0, 2.5 * kPi);
}

PolarTable::Position PolarTable::locate(double alpha) {
  const double turns = (alpha + kPi) / (2 * kPi);
  const double cells = (turns - std::floor(turns)) * kCells;
  const int index = std::clamp(static_cast<int>(cells), 0, kCells - 1);
  return {static_cast<std::size_t>(index), cells - index};
}

PolarCurve::PolarCurve(const PolarTable& low, const PolarTable& high, double weight, double delay,
                       double moreDrag)
    : low_(&low),
      high_(&high),
      weight_(weight),
      delay_(delay),
      zeroLift_((1 - weight) * low.zeroLift() + weight * high.zeroLift()),
      slope_((1 - weight) * low.liftSlope() + weight * high.liftSlope()),
      moreDrag_(moreDrag) {}

SectionCoefficients PolarCurve::at(double alpha) const {
  const PolarTable::Position place = PolarTable::locate(alpha);
  const SectionCoefficients a = low_->at(place), b = high_->at(place);
  SectionCoefficients c{a.lift + weight_ * (b.lift - a.lift),
                        a.drag + weight_ * (b.drag - a.drag) + moreDrag_};
  const double lost = slope_ * (alpha - zeroLift_) - c.lift;
  if (delay_ > 0 && alpha > zeroLift_ && lost > 0) {
    c.lift += delay_ * logistic((kDelayFade - std::abs(alpha)) / kDelayFadeWidth) * lost;
  }
  return c;
}

PreparedPolars::PreparedPolars(const PolarSection& section)
    : stallDelay_(section.stallDelay), dragExponent_(section.dragExponent) {
  std::vector<Polar> sorted = section.polars;
  std::sort(sorted.begin(), sorted.end(),
            [](const Polar& a, const Polar& b) { return a.reynolds < b.reynolds; });
  for (const Polar& polar : sorted) tables_.emplace_back(polar);
}

PolarCurve PreparedPolars::curve(const SectionPlace& place, double reynolds) const {
  const double delay =
      std::min(kDelayLimit, stallDelay_ * place.chordToRadius * place.chordToRadius);
  // Below a Reynolds number of 1 the logarithm is of no use; the lowest polar holds there anyway.
  const double wanted = std::log(std::max(reynolds, 1.0));
  if (tables_.size() == 1) {
    const PolarTable& only = tables_.front();
    const auto carried = [](double logReynolds) {
      return std::clamp(logReynolds, std::log(kLeastCarried), std::log(kMostCarried));
    };
    const double factor = std::exp(dragExponent_ * (carried(wanted) - carried(only.logReynolds())));
    return {only, only, 0, delay, only.leastDrag() * (factor - 1)};
  }
  std::size_t high = 0;
  while (high < tables_.size() && tables_[high].logReynolds() < wanted) ++high;
  if (high == 0) return {tables_.front(), tables_.front(), 0, delay};
  if (high == tables_.size()) return {tables_.back(), tables_.back(), 0, delay};
  const double a = tables_[high - 1].logReynolds(), b = tables_[high].logReynolds();
  return {tables_[high - 1], tables_[high], (wanted - a) / (b - a), delay};
}

void Describe<PolarPoint>::fields(schema::Builder<PolarPoint>& b) {
  using P = PolarPoint;
  b.title("point", "Point", "Lift and drag coefficient at one angle of attack.");
  b.number("alpha", &P::alpha, "Angle of attack", "\u03b1", "rad")
      .range(schema::atLeast(-kPi), schema::upTo(kPi))
      .shownIn("deg");
  b.number("lift", &P::lift, "Lift coefficient", "c_l", "1")
      .range(schema::atLeast(-10), schema::upTo(10));
  b.number("drag", &P::drag, "Drag coefficient", "c_d", "1")
      .range(schema::atLeast(0), schema::upTo(10));
}

void Describe<Polar>::fields(schema::Builder<Polar>& b) {
  b.title("polar", "Polar", "Lift and drag against the angle of attack at one Reynolds number.");
  b.number("reynolds", &Polar::reynolds, "Reynolds number", "Re", "1")
      .range(schema::atLeast(1), schema::upTo(1e9));
  schema::risingList(b, "points", &Polar::points, "Points", &PolarPoint::alpha,
                     {"alpha", "angles of attack"})
      .items(2, 2000)
      .table();
}

void Describe<PolarSection>::fields(schema::Builder<PolarSection>& b) {
  using P = PolarSection;
  b.title("polars", "Section with polars",
          "A section given by its polars; beyond them it behaves like a flat plate.",
          "Hoerner, Fluid-Dynamic Drag, 1965, ch. 3");
  b.text("name", &P::name, "Name");
  b.list("polars", &P::polars, "Polars")
      .items(1, 100)
      .help("One per Reynolds number. Between them the values are linear in ln Re.");
  b.number("stallDelay", &P::stallDelay, "Stall delay by rotation", "", "1")
      .range(schema::atLeast(0), schema::upTo(50))
      .help(
          "Times (c/r)\u00b2: the share of the lift lost in stall that rotation keeps; 0 for none.")
      .source("Snel, Houwink, Bosschers, ECN-C-93-052: 3 (c/r)\u00b2");
  b.number("dragExponent", &P::dragExponent, "Drag over Reynolds number", "e", "1")
      .range(schema::atLeast(-1), schema::upTo(0))
      .help(
          "Where there is one polar only, its least drag goes with Re to this power between 1e4 "
          "and 1e6; 0 keeps it as it is.")
      .source("Laminar flat plate, Blasius 1908: -0.5")
      .advanced();
  b.check([](const P& p, std::vector<Problem>& problems) {
    for (std::size_t i = 0; i < p.polars.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (p.polars[i].reynolds != p.polars[k].reynolds) continue;
        problems.push_back({"polars[" + std::to_string(i) + "].reynolds",
                            "this Reynolds number is given twice",
                            "one polar per Reynolds number"});
        return;
      }
    }
  });
}

}  // namespace rotorbench
