// The cases of the validation: models of this program against measurements of others, kept in
// resources/validation. One set of model constants serves all propellers; what is fitted in a case,
// it says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/validation/result.h"

namespace rotorbench::validation {

struct Case {
  const char* key;      ///< "uiuc-global"
  const char* subject;  ///< one line for lists
  CaseResult (*run)(const std::filesystem::path& resources);
  bool onDemand = false;  ///< takes minutes: only where it is named
};

/// All cases in the order of the report. `run` takes the resources folder and throws InputError
/// where its data cannot be read.
const std::vector<Case>& cases();

/// Runs the case of that key. Throws InputError naming the keys if there is none.
CaseResult runCase(const std::string& key, const std::filesystem::path& resources);

// The cases, one by one.
CaseResult propellersWithGlobalConstants(const std::filesystem::path& resources);
CaseResult propellersWithTwistOffset(const std::filesystem::path& resources);
CaseResult fullScalePropeller(const std::filesystem::path& resources);
CaseResult largePropellerPrediction(const std::filesystem::path& resources);
CaseResult propellersOfHeldOutFamilies(const std::filesystem::path& resources);
CaseResult standAtPartThrottle(const std::filesystem::path& resources);
CaseResult thrustStand(const std::filesystem::path& resources);
CaseResult drivesOnSteps(const std::filesystem::path& resources);
CaseResult racingDrives(const std::filesystem::path& resources);
CaseResult nanoQuadrotor(const std::filesystem::path& resources);
CaseResult mapAgainstBladeElements(const std::filesystem::path& resources);

}  // namespace rotorbench::validation
