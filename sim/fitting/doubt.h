// When the values of a fit should not be used unseen: a parameter at the end of its range, far from
// where it started, or not determined by the data at all.
#pragma once

#include <string>
#include <vector>

#include "sim/fitting/least_squares.h"

namespace rotorbench {

/// Part of its start from which a value is far from it. Constants of a part that was measured, or
/// is in a data sheet, are known better than this.
inline constexpr double kFarFromStart = 0.3;

/// One sentence for each parameter in doubt, with its value and its start; empty where the fit has
/// no usable values. A start of zero, or one that was only guessed, is nothing to be far from.
std::vector<std::string> doubtsOf(const FitResult& result);

/// How the fit ended, in one line: that its values are in doubt and why, else what the solver says.
std::string verdictOf(const FitResult& result);

}  // namespace rotorbench
