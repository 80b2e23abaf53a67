// Figures read off a recorded curve: extremes, peaks, zeros. Columns are indices of the recording's
// channels; only published rows are looked at. Values have the channel's unit.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

#include "sim/core/recording.h"

namespace rotorbench {

/// The largest magnitude a channel takes; 0 where there is no such channel or row.
double largestMagnitude(const Recording& recording, std::string_view channel);

/// The largest value a channel takes; NaN where there is no such channel or row.
double largestValue(const Recording& recording, std::string_view channel);

/// A highest point of y over x; NaN where there is none.
struct CurvePeak {
  double x = std::numeric_limits<double>::quiet_NaN();
  double y = std::numeric_limits<double>::quiet_NaN();
};
/// By a parabola through the highest point and its two neighbours, x being evenly spaced; none
/// where the highest point is an end of the curve.
CurvePeak peakOf(const Recording& recording, std::size_t x, std::size_t y);

/// The first x at which y falls through zero, by a straight line between two points; NaN where it
/// does not.
double fallsThroughZero(const Recording& recording, std::size_t x, std::size_t y);

}  // namespace rotorbench
