#include "sim/propulsion/rotor/blade.h"

#include "sim/core/constants.h"
#include "sim/core/rising.h"

namespace rotorbench {

namespace {

constexpr double kPitchRadius = 0.75;  // r/R at which pitch is measured
constexpr double kPitchWeight = 0.41;  // of the printed pitch against the digitised twist: fitted

BladeShape interpolated(const std::vector<BladeStation>& s, double radius) {
  if (radius <= s.front().radius) return {s.front().chord, s.front().twist};
  for (std::size_t i = 1; i < s.size(); ++i) {
    if (radius > s[i].radius) continue;
    const BladeStation &a = s[i - 1], &b = s[i];
    const double t = (radius - a.radius) / (b.radius - a.radius);
    return {a.chord + t * (b.chord - a.chord), a.twist + t * (b.twist - a.twist)};
  }
  return {s.back().chord, s.back().twist};
}

}  // namespace

std::vector<BladeStation> PropellerGeometry::slowFlyer10x47() {
  return {{0.15, 0.109, 21.11 * kDegree}, {0.2, 0.132, 23.9 * kDegree},
          {0.25, 0.156, 24.65 * kDegree}, {0.3, 0.176, 24.11 * kDegree},
          {0.35, 0.193, 22.78 * kDegree}, {0.4, 0.206, 21.01 * kDegree},
          {0.45, 0.216, 19.0 * kDegree},  {0.5, 0.223, 17.06 * kDegree},
          {0.55, 0.226, 15.33 * kDegree}, {0.6, 0.225, 13.82 * kDegree},
          {0.65, 0.219, 12.51 * kDegree}, {0.7, 0.21, 11.36 * kDegree},
          {0.75, 0.197, 10.27 * kDegree}, {0.8, 0.179, 9.32 * kDegree},
          {0.85, 0.157, 8.36 * kDegree},  {0.9, 0.13, 7.27 * kDegree},
          {0.95, 0.087, 6.15 * kDegree},  {1.0, 0.042, 5.04 * kDegree}};
}

double nominalPitchBlend(const PropellerGeometry& geometry) {
  if (geometry.pitch <= 0) return 0;
  const double nominal = std::atan(geometry.pitch / geometry.diameter / (kPitchRadius * kPi));
  return kPitchWeight * (interpolated(geometry.stations, kPitchRadius).twist - nominal);
}

BladeShape bladeShape(const PropellerGeometry& geometry, double radius, double blend) {
  BladeShape shape = interpolated(geometry.stations, radius);
  shape.twist += geometry.twistOffset - blend;
  return shape;
}

void Describe<BladeStation>::fields(schema::Builder<BladeStation>& b) {
  using S = BladeStation;
  b.title("station", "Blade station", "Chord and twist at one radius.");
  b.number("radius", &S::radius, "Radius", "r/R", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("As a fraction of the tip radius.");
  b.number("chord", &S::chord, "Chord", "c/R", "1")
      .range(schema::atLeast(0), schema::upTo(2))
      .help("As a fraction of the tip radius.");
  b.number("twist", &S::twist, "Twist", "\u03b2", "rad")
      .range(schema::atLeast(-kPi / 2), schema::upTo(kPi / 2))
      .shownIn("deg")
      .help("From the plane of rotation to the chord line.");
}

void Describe<BladeSection>::fields(schema::Builder<BladeSection>& b) {
  b.title("section", "Section", "The blade's section at one radius.");
  b.number("radius", &BladeSection::radius, "Radius", "r/R", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("Between two sections the coefficients are blended.");
  b.variant("model", &BladeSection::model, "Section");
}

void Describe<RigidBlades>::fields(schema::Builder<RigidBlades>& b) {
  b.title("rigid", "Rigid blades", "Blades that do not bend: all their moments reach the hub.");
}

void Describe<FlappingBlades>::fields(schema::Builder<FlappingBlades>& b) {
  b.title("flapping", "Flapping blades",
          "Blades on a hinge at the centre, or that bend as if they were: in forward flight the "
          "plane of their tips tilts, and the thrust with it.",
          "Leishman, Principles of Helicopter Aerodynamics, 2nd ed., sections 4.5 to 4.7");
  b.number("stiffness", &FlappingBlades::stiffness, "Flap stiffness", "k_\u03b2", "N*m/rad")
      .range(schema::atLeast(0), schema::upTo(1e6))
      .help("Moment at the root of one blade per angle; 0 for a free hinge or a teetering hub.");
}

void Describe<PropellerGeometry>::fields(schema::Builder<PropellerGeometry>& b) {
  using G = PropellerGeometry;
  b.title("geometry", "Propeller geometry", "Chord, twist and section along the blade.",
          "Default: UIUC Propeller Data Site, APC Slow Flyer 10 x 4.7, volume 1");
  b.number("diameter", &G::diameter, "Diameter", "D", "m")
      .range(schema::above(0), schema::upTo(30))
      .shownIn("in");
  b.integer("blades", &G::blades, "Blades", "N_b").range(schema::atLeast(1), schema::upTo(12));
  b.number("pitch", &G::pitch, "Printed pitch", "P", "m")
      .range(schema::atLeast(0), schema::upTo(30))
      .shownIn("in")
      .help("The second number of \"10 x 4.7\"; 0 where it is not known.");
  b.choice("line", &G::line, "Blade line",
           {{BladeLine::Standard, "standard", "Standard", "Sport, electric and folding blades."},
            {BladeLine::SlowFlyer, "slow-flyer", "Slow flyer",
             "Thin, strongly cambered blades (APC SF, GWS SF)."}});
  b.number("twistOffset", &G::twistOffset, "Twist offset", "\u0394\u03b2", "rad")
      .range(schema::atLeast(-0.5), schema::upTo(0.5))
      .shownIn("deg")
      .help("Added to the twist everywhere, for instance to meet a measurement.");
  b.number("rootRadius", &G::rootRadius, "Root cut-out", "x_0", "1")
      .range(schema::atLeast(0.01), schema::upTo(0.9))
      .help("The blade begins at this fraction of the tip radius.")
      .advanced();
  constexpr schema::RisingColumn kRadii{"radius", "radii"};
  schema::risingList(b, "stations", &G::stations, "Stations", &BladeStation::radius, kRadii)
      .items(1, 500)
      .table();
  b.variant("root", &G::root, "Blade roots")
      .untyped()
      .help("Where the blades are held: what forward flight does to them.")
      .advanced();
  schema::risingList(b, "sections", &G::sections, "Sections", &BladeSection::radius, kRadii)
      .items(1, 50);
}

}  // namespace rotorbench
