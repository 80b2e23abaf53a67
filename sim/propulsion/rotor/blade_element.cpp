#include "sim/propulsion/rotor/blade_element.h"

#include <algorithm>
#include <limits>

#include "sim/core/constants.h"
#include "sim/propulsion/rotor/inflow_root.h"
#include "sim/propulsion/rotor/momentum_inflow.h"

namespace rotorbench {

namespace {

constexpr double kWarmBracket = 0.003;  // of the section's speed, around the last solution
constexpr double kRingBegin = -0.5, kRingEnd = -2;  // of the hover induced velocity: Leishman 2.13

/// Air as a section meets it.
struct Flow {
  double axial, tangential, swirl, speedSquared, sine, cosine, angle;
};

/// Tangential velocity induced along with `induced`, which adds to the axial stream: together they
/// are normal to the resulting flow (QPROP), u (V_t - u) = v (V + v). A blade that drives the air
/// takes at most half the turning out of it; one that is driven adds no more than half of it, or
/// near a standstill the swirl would keep itself up.
double swirlOf(double induced, double axialStream, double turning) {
  const double square = turning * turning, product = 4 * induced * (axialStream + induced);
  if (product >= 0)
    return (turning - std::copysign(std::sqrt(std::max(0.0, square - product)), turning)) / 2;
  const double added =
      std::sqrt(square - product) - std::abs(turning);  // twice the swirl without a limit
  const double limit = std::abs(turning);
  return -0.5 * std::copysign(added * limit / std::hypot(added, limit), turning);
}

Flow flowAt(double induced, double swirl, double axialStream, double tangentialStream) {
  Flow f{};
  f.axial = axialStream + induced;
  f.swirl = swirl;
  f.tangential = tangentialStream - swirl;
  f.speedSquared = f.axial * f.axial + f.tangential * f.tangential;
  const double speed = std::sqrt(f.speedSquared);
  f.sine = speed > 0 ? f.axial / speed : 0;
  f.cosine = speed > 0 ? f.tangential / speed : 1;
  f.angle = std::atan2(f.axial, f.tangential);
  return f;
}

Flow axialFlow(double induced, double axialStream, double tangentialStream) {
  return flowAt(induced, swirlOf(induced, axialStream, tangentialStream), axialStream,
                tangentialStream);
}

/// Square of the induced velocity a section's lift would have in hover.
template <class Element, class Curve>
double hoverSquare(const Element& e, const Curve& curve, const Flow& f, double momentumFactor) {
  const double sine = e.twistSine * f.cosine - e.twistCosine * f.sine;
  const double cosine = e.twistCosine * f.cosine + e.twistSine * f.sine;
  return f.speedSquared * e.solidity * curve.lift(e.twist - f.angle, sine, cosine) * f.cosine /
         (4 * tipLoss(e.tipDistance, f.sine) * momentumFactor);
}

/// Two neighbouring sections of a blade, blended.
template <class Curve>
struct BlendedCurve {
  Curve a, b;
  double weight;
  [[nodiscard]] double zeroLift() const {
    return (1 - weight) * std::visit([](const auto& c) { return c.zeroLift(); }, a) +
           weight * std::visit([](const auto& c) { return c.zeroLift(); }, b);
  }
  [[nodiscard]] SectionCoefficients at(double alpha) const {
    const auto value = [alpha](const auto& c) { return c.at(alpha); };
    const SectionCoefficients p = std::visit(value, a), q = std::visit(value, b);
    return {p.lift + weight * (q.lift - p.lift), p.drag + weight * (q.drag - p.drag)};
  }
  [[nodiscard]] double lift(double alpha, double sine, double cosine) const {
    const auto value = [=](const auto& c) { return c.lift(alpha, sine, cosine); };
    const double p = std::visit(value, a);
    return p + weight * (std::visit(value, b) - p);
  }
};

}  // namespace

BladeElementRotor::BladeElementRotor(const PropellerGeometry& geometry,
                                     const BladeElementSettings& settings)
    : radius_(geometry.diameter / 2),
      blades_(geometry.blades),
      momentumFactor_(settings.momentumFactor) {
  for (const BladeSection& section : geometry.sections) {
    if (const auto* polars = std::get_if<PolarSection>(&section.model)) {
      sections_.emplace_back(PreparedPolars(*polars));
    } else {
      sections_.emplace_back(std::get<AnalyticSection>(section.model));
    }
  }
  const double blend = nominalPitchBlend(geometry);
  const double width = (1 - geometry.rootRadius) / settings.elements;
  for (int i = 0; i < settings.elements; ++i) {
    const double x = geometry.rootRadius + (i + 0.5) * width;
    const BladeShape shape = bladeShape(geometry, x, blend);
    Element e{};
    e.radius = x * radius_;
    e.width = width * radius_;
    e.chord = shape.chord * radius_;
    e.twist = shape.twist;
    e.twistSine = std::sin(shape.twist);
    e.twistCosine = std::cos(shape.twist);
    e.solidity = blades_ * shape.chord / (2 * kPi * x);
    e.tipDistance = blades_ * (1 - x) / (2 * x);
    e.place = {shape.chord, shape.chord / x, geometry.line == BladeLine::SlowFlyer};
    const auto& s = geometry.sections;
    while (e.section + 1 < s.size() && s[e.section + 1].radius <= x) ++e.section;
    if (e.section + 1 < s.size() && x > s[e.section].radius) {
      e.weight = (x - s[e.section].radius) / (s[e.section + 1].radius - s[e.section].radius);
    }
    elements_.push_back(e);
  }
  prepareDisc(geometry);
  const int half = (settings.azimuths + 1) / 2;
  for (int i = 0; i < half; ++i) azimuths_.push_back(std::sin(kPi * ((i + 0.5) / half - 0.5)));
}

void BladeElementRotor::prepareDisc(const PropellerGeometry& geometry) {
  constexpr double kPlace = 0.75;    // r/R of the section that stands for all
  constexpr double kReynolds = 1e5;  // at which its lift slope is taken
  constexpr double kSpan = 0.05;     // rad beyond the zero lift, short of every stall
  const auto nearest = std::ranges::min_element(
      elements_, {}, [this](const Element& e) { return std::abs(e.radius - kPlace * radius_); });
  double slope = 0;
  withCurve(*nearest, kReynolds, [&](const auto& curve) {
    const double zero = curve.zeroLift();
    slope = (curve.at(zero + kSpan).lift - curve.at(zero).lift) / kSpan;
  });
  disc_.radius = radius_;
  disc_.area = kPi * radius_ * radius_;
  disc_.momentumFactor = momentumFactor_;
  for (const Element& e : elements_) {
    const double strip = blades_ * slope * e.chord * e.width * e.radius;
    disc_.swayIntegral += strip;
    disc_.flapIntegral += strip * e.radius * e.radius;
  }
  if (const auto* flapping = std::get_if<FlappingBlades>(&geometry.root)) {
    disc_.flapping = true;
    disc_.stiffness = blades_ * flapping->stiffness / 2;
  }
}

template <class Use>
void BladeElementRotor::withCurve(const Element& e, double reynolds, const Use& use) const {
  const auto curve = [&](const auto& section) { return section.curve(e.place, reynolds); };
  if (e.weight == 0) {
    std::visit([&](const auto& section) { use(curve(section)); }, sections_[e.section]);
    return;
  }
  using Curve = std::variant<AnalyticCurve, PolarCurve>;
  const auto any = [&](const PreparedSection& section) {
    return std::visit([&](const auto& s) { return Curve(curve(s)); }, section);
  };
  use(BlendedCurve<Curve>{any(sections_[e.section]), any(sections_[e.section + 1]), e.weight});
}

double BladeElementRotor::sections(const Element& e, double reynolds, std::span<const double> alpha,
                                   std::span<SectionCoefficients> coefficients) const {
  double zero = 0;
  withCurve(e, reynolds, [&](const auto& curve) {
    std::ranges::transform(alpha, coefficients.begin(), [&](double a) { return curve.at(a); });
    zero = curve.zeroLift();
  });
  return zero;
}

template <class Curve>
double BladeElementRotor::solveAxial(const Element& e, const Curve& curve, double axial,
                                     double tangential, const double* guess) const {
  const double speed = std::hypot(axial, tangential);
  if (speed == 0 || e.solidity == 0) return 0;
  const auto residual = [&](double v) {
    const double h = hoverSquare(e, curve, axialFlow(v, axial, tangential), momentumFactor_);
    return v - axialInducedVelocity(h, axial);
  };
  const RootRule rule = RootRule::at(advanceRatio(axial * e.radius, tangential * radius_));
  if (guess && !rule.many) {
    const double a = *guess - kWarmBracket * speed, b = *guess + kWarmBracket * speed;
    const double fa = residual(a), fb = residual(b);
    if ((fa > 0) != (fb > 0))
      return bracketedRoot(residual, a, fa, b, fb, kInflowTolerance * speed);
  }
  constexpr double kSteepest = 1.5;  // rad, keeps the tangent finite
  const double free = std::clamp(e.twist - curve.zeroLift(), -kSteepest, kSteepest);
  return inflowRoot(residual, tangential * std::tan(free) - axial, speed, rule);
}

void BladeElementRotor::addAxial(const Element& e, double omega, double axialSpeed,
                                 const AirState& air, double* memory, bool warm, AxialLoad& load,
                                 ElementLoad* detail) const {
  const double tangential = omega * e.radius;
  const double reynolds =
      air.density * std::hypot(tangential, axialSpeed) * e.chord / air.viscosity;
  withCurve(e, reynolds, [&](const auto& curve) {
    const double v = solveAxial(e, curve, axialSpeed, tangential, warm ? memory : nullptr);
    if (memory) *memory = v;
    const Flow f = axialFlow(v, axialSpeed, tangential);
    const double alpha = e.twist - f.angle;
    const SectionCoefficients c = curve.at(alpha);
    const double pressure = 0.5 * air.density * f.speedSquared * blades_ * e.chord;
    const double thrust = pressure * (c.lift * f.cosine - c.drag * f.sine);
    const double torque = pressure * (c.lift * f.sine + c.drag * f.cosine) * e.radius;
    load.thrust += thrust * e.width;
    load.torque += torque * e.width;
    const double h = hoverSquare(e, curve, f, momentumFactor_);
    const double descent = h > 0 ? axialSpeed / std::sqrt(h) : 0;
    if (descent < kRingBegin && descent > kRingEnd) {
      load.vortexRingShare += 2 * e.radius * e.width / (radius_ * radius_);
    }
    if (detail) {
      *detail = {
          e.radius / radius_, f.angle, alpha, reynolds, c.lift, c.drag, v, f.swirl, thrust, torque};
    }
  });
}

AxialLoad BladeElementRotor::axial(double omega, double axialSpeed, const AirState& air,
                                   InflowMemory* memory,
                                   std::span<ElementLoad> distribution) const {
  const double sign = omega < 0 ? -1 : 1;
  const bool warm = memory && memory->valid && omega > 0;
  AxialLoad load;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    double* stored = memory && i < memory->velocity.size() ? &memory->velocity[i] : nullptr;
    addAxial(elements_[i], std::abs(omega), sign * axialSpeed, air, stored, warm, load,
             i < distribution.size() ? &distribution[i] : nullptr);
  }
  if (memory) memory->valid = omega > 0;
  load.thrust *= sign;
  load.torque *= sign;
  return load;
}

void BladeElementRotor::addOblique(const Element& e, double omega, double axialSpeed,
                                   double inPlaneSpeed, const AirState& air,
                                   ObliqueLoad& load) const {
  const double turning = omega * e.radius;
  // Mean square over the azimuth, so that one curve serves the annulus.
  const double speed =
      std::sqrt(turning * turning + axialSpeed * axialSpeed + inPlaneSpeed * inPlaneSpeed / 2);
  if (speed == 0 || e.solidity == 0) return;
  // The swirl is one for the annulus, like the induced velocity. Where the in-plane stream gives
  // most of the section's speed, what the blades turn cancels around the azimuth.
  const double square = turning * turning,
               turned = square > 0 ? square / (square + inPlaneSpeed * inPlaneSpeed / 2) : 0;
  const double tip = omega * radius_;
  const RootRule rule = RootRule::at(advanceRatio(axialSpeed, std::hypot(tip, inPlaneSpeed)),
                                     inPlaneSpeed / std::max(tip, 1e-9 * speed));
  const double share = 1 / static_cast<double>(azimuths_.size());
  withCurve(e, air.density * speed * e.chord / air.viscosity, [&](const auto& curve) {
    const auto flow = [&](double v, double swirl, double azimuth) {
      return flowAt(v, swirl, axialSpeed, turning - inPlaneSpeed * azimuth);
    };
    const auto residual = [&](double v) {
      const double swirl = turned * swirlOf(v, axialSpeed, turning);
      double h = 0;
      for (const double azimuth : azimuths_)
        h += hoverSquare(e, curve, flow(v, swirl, azimuth), momentumFactor_);
      return v - inducedVelocity(h * share, axialSpeed, inPlaneSpeed);
    };
    const double v = inflowRoot(
        residual, turning * std::tan(e.twist - curve.zeroLift()) - axialSpeed, speed, rule);
    const double swirl = turned * swirlOf(v, axialSpeed, turning);
    for (const double azimuth : azimuths_) {
      const Flow f = flow(v, swirl, azimuth);
      const SectionCoefficients c = curve.at(e.twist - f.angle);
      const double force = 0.5 * air.density * f.speedSquared * blades_ * e.chord * e.width * share;
      const double thrust = force * (c.lift * f.cosine - c.drag * f.sine);
      const double against = force * (c.lift * f.sine + c.drag * f.cosine);
      load.thrust += thrust;
      load.torque += against * e.radius;
      load.drag -= against * azimuth;
      load.rollMoment += thrust * e.radius * azimuth;
    }
  });
}

ObliqueLoad BladeElementRotor::oblique(double omega, double axialSpeed, double inPlaneSpeed,
                                       const AirState& air) const {
  ObliqueLoad load;
  for (const Element& e : elements_) {
    addOblique(e, omega, axialSpeed, inPlaneSpeed, air, load);
  }
  return load;
}

RotorLoad<double> BladeElementRotor::load(double w, const Eigen::Vector3d& v,
                                          const Eigen::Vector3d& axis, double spin,
                                          const AirState& air) const {
  // Turned over, a propeller that runs backwards runs forwards; see axial().
  const double sign = w < 0 ? -1 : 1;
  const Eigen::Vector3d front = sign * axis;
  const double axialSpeed = v.dot(front);
  const Eigen::Vector3d inPlane = v - axialSpeed * front;
  const double inPlaneSpeed = inPlane.norm();
  RotorLoad<double> l;
  // Below this the direction of the in-plane velocity is noise, and its effect too.
  if (inPlaneSpeed <= 1e-9 * (std::abs(w) * radius_ + std::abs(axialSpeed))) {
    const AxialLoad a = axial(std::abs(w), axialSpeed, air);
    l.force = a.thrust * front;
    l.moment = -spin * a.torque * front;
    l.thrust = sign * a.thrust;
    l.torque = sign * a.torque;
    return l;
  }
  const ObliqueLoad o = oblique(std::abs(w), axialSpeed, inPlaneSpeed, air);
  const EvenLoad<double> even{o.thrust, o.torque, o.drag / inPlaneSpeed,
                              o.rollMoment / inPlaneSpeed};
  const auto disc = air.density > 0 ? discResponse<double>(disc_, even, std::abs(w), axialSpeed,
                                                           inPlaneSpeed * inPlaneSpeed, air.density)
                                    : DiscLoad<double>{even, 0, 0};
  return bodyLoad<double, Eigen::Vector3d>(disc, inPlane, axis, spin, sign);
}

void Describe<BladeElementSettings>::fields(schema::Builder<BladeElementSettings>& b) {
  using S = BladeElementSettings;
  b.title("blade-elements", "Blade elements", "How finely the blade is cut.",
          "Glauert; Prandtl; Drela, QPROP");
  b.integer("elements", &S::elements, "Elements along the blade", "N")
      .range(schema::atLeast(4), schema::upTo(static_cast<double>(InflowMemory::kMostElements)));
  b.number("momentumFactor", &S::momentumFactor, "Momentum factor", "k", "1")
      .range(schema::atLeast(0.3), schema::upTo(1))
      .help("1 for ideal inflow; the induced power is larger by 1/sqrt(k).")
      .advanced();
  b.integer("azimuths", &S::azimuths, "Directions of a blade", "N_\u03c8")
      .range(schema::atLeast(4), schema::upTo(360))
      .help("Over which forward flight is averaged; an odd number counts as the next even one.")
      .advanced();
}

}  // namespace rotorbench
