// The constants of the analytic section fitted to measured propellers, so that some can be held out
// and predicted. One fit to all sets it is given, nothing for a single propeller: robust least
// squares (soft L1) of ln(computed/measured) at rest and of the difference over the static
// coefficient in flight, a few points of each run, every set with the same weight; textbook values
// are the start, and what the sets do not determine stays near them.
//   textbook   thin aerofoil: 2 pi per rad; I. H. Abbott, A. E. von Doenhoff, Theory of Wing
//              Sections, 1959: stall and drag of cambered sections; S. F. Hoerner, Fluid-Dynamic
//              Drag, 1965: friction of turbulent and laminar flow over the Reynolds number;
//              H. Snel, R. Houwink, J. Bosschers, ECN-C-93-052, 1994: stall delay 3 (c/r)^2
#pragma once

#include <vector>

#include "sim/propulsion/rotor/blade_element.h"
#include "sim/validation/uiuc_data.h"

namespace rotorbench::validation {

/// What is global to all propellers.
struct BladeConstants {
  SectionConstants section;
  double momentumFactor = BladeElementSettings{}.momentumFactor;
  /// Weight of the printed pitch in the twist, in parts of the program's own (nominalPitchBlend()).
  double pitchWeight = 1;
};

/// From books, none of it from these propellers.
BladeConstants textbookConstants();

/// A propeller with these constants.
BladeElementRotor rotorWith(const PropellerGeometry& geometry, const BladeConstants& constants,
                            int elements = BladeElementSettings{}.elements);

/// The constants that serve these sets best.
BladeConstants fittedConstants(const std::vector<const PropellerSet*>& sets);

}  // namespace rotorbench::validation
