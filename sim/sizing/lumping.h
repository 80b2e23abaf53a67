// Lumped coefficients in place of a rotor's own model, in any document: where such rotors are,
// about which speed they are lumped, and the sheet of what came of it. SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/core/schema.h"
#include "sim/document/experiment.h"
#include "sim/propulsion/rotor/lumped_equivalent.h"
#include "sim/sizing/figure.h"

namespace rotorbench {

/// A rotor of a document that is no lumped one, in a place where lumped coefficients may stand.
struct RotorModelAt {
  std::string path;  ///< of the model, a variant
  RotorAerodynamics model;
};
std::vector<RotorModelAt> rotorModelsIn(schema::ConstRef root);

/// About what a rotor of an experiment is lumped until something else is asked for: lumpingRange()
/// at its speed in hover and the density there. Nothing for what does not fly or cannot hover.
std::optional<LumpingRange> lumpingRangeOf(const Experiment& experiment, const RotorModelAt& rotor);

/// The coefficients with what they leave out, and sentences where they stand for little.
FigureSheet lumpingSheet(const LumpedEquivalent& lumped, const LumpingRange& range);

/// Lumped coefficients at the rotor's place, as one of its alternatives.
void useLumped(schema::Ref root, const std::string& path, const RotorCoefficients& coefficients);

}  // namespace rotorbench
