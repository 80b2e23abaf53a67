// A propeller's map takes 24 s of a core, 20 of them for refining edgewise flow to its tolerance.
// Tests that look at something else fly a map without that; the full set flies what users fly.
#pragma once

#include "sim/document/experiment.h"
#include "sim/document/flight.h"
#include "sim/propulsion/rotor/rotor_models.h"
#include "tests/full_set.h"

namespace rotorbench::test {

inline MapPropeller quickMap(MapPropeller propeller = {}) {
  if (!fullSet()) propeller.map.sideRefinements = 0;
  return propeller;
}

/// A flight as its file has it, but for the maps of its rotors.
inline Experiment withQuickMaps(Experiment experiment) {
  if (auto* flight = alternativeIf<Flight>(experiment.setup)) {
    const auto quicken = [](RotorParameters& rotor) {
      if (auto* map = std::get_if<MapPropeller>(&rotor.aerodynamics)) *map = quickMap(*map);
    };
    auto& rotors = flight->vehicle.rotors;
    if (auto* equal = std::get_if<EqualRotors>(&rotors)) quicken(equal->rotor);
    if (auto* each = std::get_if<IndividualRotors>(&rotors))
      for (RotorParameters& rotor : each->rotors) quicken(rotor);
  }
  return experiment;
}

}  // namespace rotorbench::test
