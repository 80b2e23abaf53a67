// Performance tables of propellers as APC Propellers publishes them (files PER3_*.dat): one block
// for each speed, with a line "PROP RPM = 5000", a line of names (V J Pe Ct Cp PWR Torque Thrust
// ...), a line of units ((mph) (Adv Ratio) ...) and one row for each air speed. The layout is known
// from the files; there is no published description of it:
//   - older files leave the units of plain numbers out, so that a unit belongs to the name it
//     stands below; newer ones
//     write "-" for them and have more columns;
//   - where the program behind them found no solution, a row holds "-NaN", grown together with the
//     number before it, or
//     ends after the first numbers.
// The numbers are computed by APC with blade elements, not measured.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/error.h"

namespace rotorbench {

class TextLines;

struct PropellerBlocks {
  std::string text;  ///< lines set apart by tabs, the speed as their first column, "PROP RPM [rpm]"
  std::vector<Problem> notes;  ///< warnings: which rows were left out
};

/// The blocks as one table in which each row keeps the number of its line; empty if there is no
/// line "PROP RPM =". Throws InputError where a block has no speed, no names, or other names than
/// the first.
std::optional<PropellerBlocks> tableOfPropellerBlocks(const TextLines& lines);

/// Diameter in m of a propeller named as its maker does, "10x4.5MR" or "PER3_10x45MR" in inches:
/// the number before the "x". Empty if there is none from 1 to 100.
std::optional<double> diameterInName(std::string_view name);

}  // namespace rotorbench
