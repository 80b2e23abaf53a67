// A propeller's table holds one curve over the advance ratio for each speed; on a chart beside a
// computed run of one speed, only the curve of that speed is to be compared.
#pragma once

#include <vector>

#include "sim/logs/measured_table.h"

namespace rotorbench {

/// The speeds, rad/s and rising, that have two or more rows of a table over the advance ratio;
/// speeds within 2 % of the slowest are one, given as their mean. Empty where there are fewer than
/// two such speeds.
std::vector<double> curveSpeeds(const MeasuredTable& table);

/// The rows within 2 % of this speed.
MeasuredTable curveAtSpeed(const MeasuredTable& table, double speed);

}  // namespace rotorbench
