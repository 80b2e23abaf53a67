// A propeller by measured coefficients from a table that has CT and CP: what an in-flight or a
// static table of a propeller becomes where it is to fly. SI units.
#pragma once

#include <string>
#include <vector>

#include "sim/logs/measured_table.h"
#include "sim/propulsion/rotor/measured_propeller.h"

namespace rotorbench {

/// What the table lacks, one sentence each; empty if a propeller can be made of it. The advance
/// ratio is its own column or, without one, 0 in each row, as of a static test.
std::vector<std::string> missingForCoefficients(const MeasuredTable& table);

/// One point for each row with both coefficients; speed 0 where the table has none. Diameter in m.
/// Throws InputError with those sentences, or with what is wrong with the points.
MeasuredPropeller propellerOfTable(const MeasuredTable& table, double diameter);

}  // namespace rotorbench
