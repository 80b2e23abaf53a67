// The shape of a propeller's blades: chord and twist along the radius, the number of blades, the
// diameter and what is printed on the propeller. Radii and chords are fractions of the tip radius
// R, angles in rad, measured from the plane of rotation to the chord line.
#pragma once

#include <variant>
#include <vector>

#include "sim/propulsion/rotor/polar_section.h"

namespace rotorbench {

/// Chord and twist at one radius.
struct BladeStation {
  double radius = 0;  ///< r/R
  double chord = 0;   ///< c/R
  double twist = 0;   ///< beta, rad
  bool operator==(const BladeStation&) const = default;
};

/// Slow-flyer lines (APC SF, GWS SF) are thin and strongly cambered for low speed.
enum class BladeLine { Standard, SlowFlyer };

using SectionModel = std::variant<AnalyticSection, PolarSection>;

/// The section from this radius on; between two of them coefficients are blended linearly.
struct BladeSection {
  double radius = 0;  ///< r/R
  SectionModel model;
  bool operator==(const BladeSection&) const = default;
};

/// Blades that do not bend.
struct RigidBlades {
  bool operator==(const RigidBlades&) const = default;
};

/// Blades on a hinge at the centre, or bending as if they were.
struct FlappingBlades {
  double stiffness = 0;  ///< N m/rad of one blade; 0: freely hinged, or teetering
  bool operator==(const FlappingBlades&) const = default;
};

using BladeRoot = std::variant<RigidBlades, FlappingBlades>;

/// Blades of a propeller. Default: a 10 x 4.7 inch slow-flyer propeller.
struct PropellerGeometry {
  double diameter = 0.254;  ///< m
  int blades = 2;
  double pitch = 0.11938;  ///< m, printed on the propeller; 0: none known
  BladeLine line = BladeLine::SlowFlyer;
  double twistOffset = 0;    ///< rad, added to the twist everywhere
  double rootRadius = 0.15;  ///< r/R inside which there is a hub but no blade
  std::vector<BladeStation> stations = slowFlyer10x47();
  std::vector<BladeSection> sections{BladeSection{}};
  BladeRoot root;
  bool operator==(const PropellerGeometry&) const = default;

  static std::vector<BladeStation> slowFlyer10x47();
};

/// Chord and twist of a geometry at any radius.
struct BladeShape {
  double chord;  ///< c/R
  double twist;  ///< rad, with offset and blend
};

/// Twist to take off everywhere, rad: 41 % of what the twist at 75 % radius differs from the
/// printed pitch, atan(P/(0.75 pi D)). Digitised twist and printed pitch are both uncertain by some
/// degrees; a mean of both was found to be the better guess, its weight fitted with the section's
/// constants (analytic_section.h). 0 where no pitch is known.
double nominalPitchBlend(const PropellerGeometry& geometry);

/// Linear between stations, the end values beyond them; `blend` from nominalPitchBlend().
BladeShape bladeShape(const PropellerGeometry& geometry, double radius, double blend);

template <>
struct Describe<BladeStation> {
  static void fields(schema::Builder<BladeStation>& b);
};
template <>
struct Describe<BladeSection> {
  static void fields(schema::Builder<BladeSection>& b);
};
template <>
struct Describe<RigidBlades> {
  static void fields(schema::Builder<RigidBlades>& b);
};
template <>
struct Describe<FlappingBlades> {
  static void fields(schema::Builder<FlappingBlades>& b);
};
template <>
struct Describe<PropellerGeometry> {
  static void fields(schema::Builder<PropellerGeometry>& b);
};

}  // namespace rotorbench
