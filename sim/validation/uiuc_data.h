// Geometry and measured coefficients of the 101 propellers of the UIUC Propeller Data Site kept in
// resources/validation/uiuc (SOURCE.txt there names origin and format).
// CT = T/(rho n^2 D^4), CP = P/(rho n^3 D^5), J = V/(n D), n in revolutions per second.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/propulsion/rotor/blade.h"

namespace rotorbench::validation {

/// One measured point.
struct PropellerPoint {
  double speed = 0;    ///< rad/s
  double advance = 0;  ///< J
  double thrust = 0;   ///< CT
  double power = 0;    ///< CP
};

/// One static run and the runs in flight of its propeller; a propeller may have two sets.
struct PropellerSet {
  int volume = 0;
  std::string propeller;  ///< as in the database: "apcsf_10x4.7"
  std::string run;        ///< name of the static file
  double pitchRatio = 0;  ///< pitch over diameter as printed; 0: not printed
  PropellerGeometry geometry;
  std::vector<PropellerPoint> still;  ///< in the order of rising speed
  std::vector<std::vector<PropellerPoint>> flights;
};

/// All sets in `folder` (…/uiuc). Throws InputError naming file and fault.
std::vector<PropellerSet> readPropellerSets(const std::filesystem::path& folder);

}  // namespace rotorbench::validation
