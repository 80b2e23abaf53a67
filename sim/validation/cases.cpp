#include "sim/validation/cases.h"

#include "sim/core/error.h"

namespace rotorbench::validation {

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"uiuc-families", "101 propellers, each family by constants fitted to the others",
       propellersOfHeldOutFamilies, true},
      {"uiuc-global", "101 propellers of the UIUC data site, one set of constants",
       propellersWithGlobalConstants},
      {"uiuc-offset", "the same with one twist offset per propeller", propellersWithTwistOffset},
      {"naca-tr594", "a full-scale propeller with its own polar", fullScalePropeller},
      {"tmotor-28in", "a 28 inch propeller, predicted", largePropellerPrediction},
      {"stand-x2216", "a motor and propeller on a thrust stand", thrustStand},
      {"stand-throttle", "the same stand at part throttle, one propeller from another's log",
       standAtPartThrottle},
      {"esc-test", "two motors on steps of duty", drivesOnSteps},
      {"racing-drives", "racing motors with five-inch propellers", racingDrives},
      {"crazyflie", "the drive of a nano quadrotor", nanoQuadrotor},
      {"map", "the propeller map against blade elements", mapAgainstBladeElements}};
  return all;
}

CaseResult runCase(const std::string& key, const std::filesystem::path& resources) {
  std::vector<std::string> keys;
  for (const Case& c : cases()) {
    if (key == c.key) return c.run(resources);
    keys.emplace_back(c.key);
  }
  std::string allowed = "one of";
  for (const std::string& k : keys) allowed += (allowed.size() > 6 ? ", " : " ") + k;
  throw InputError("", {{"case", "there is no case " + key, allowed}});
}

}  // namespace rotorbench::validation
