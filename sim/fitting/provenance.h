// Where the numbers of a fitted component are from, as the text its `source` holds.
#pragma once

#include <string>

#include "sim/fitting/least_squares.h"

namespace rotorbench {

struct FitProvenance {
  std::string file;   ///< of the measured data
  std::string date;   ///< of the fit, as written
  std::string model;  ///< what was fitted: "motor", "twist offset and drag"
};

/// "Fitted to stand.csv on 2026-11-22 (154 values) ...: Resistance 148 +- 3 mOhm ... (95 %
/// intervals). RMSE ...".
std::string provenanceText(const FitProvenance& provenance, const FitResult& result);

/// A number in the unit a person reads: "148 mOhm", five digits.
std::string numberIn(double value, const std::string& unit, const std::string& shown);

/// "148 +- 3 mOhm" in the unit a person reads, digits as the interval allows; "not determined"
/// without one.
std::string valueText(const FittedParameter& parameter);

}  // namespace rotorbench
