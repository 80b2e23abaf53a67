// One figure of a data sheet or a performance sheet: what it is, how large, how it was worked out and what limits it.
// Values are SI; the unit a person reads first stands beside.
#pragma once

#include <string>
#include <vector>

namespace rotorbench {

struct Figure {
  std::string key;        ///< "hover.throttle"
  std::string group;      ///< "Hover"
  std::string label;      ///< "Throttle"
  std::string symbol;     ///< "d_h"
  double value = 0;       ///< SI; NaN where there is none, and `note` says why
  std::string unit;       ///< SI
  std::string shownUnit;  ///< converts to `unit`
  std::string formula;    ///< in words and plain mathematics
  std::string source;     ///< of the formula; may be empty
  std::string note;       ///< a sentence: what limits the value, or why there is none; may be empty
};

/// Figures in the order they are read, and sentences about what cannot be right or will not do.
struct FigureSheet {
  std::vector<Figure> figures;
  std::vector<std::string> warnings;

  /// The figure named `key`; there must be one.
  [[nodiscard]] const Figure& at(const std::string& key) const;
};

/// "12.3 A" in the shown unit with `digits` significant digits, C locale; "–" for NaN.
std::string figureText(const Figure& figure, int digits = 4);
/// The number of figureText() alone.
std::string figureNumber(const Figure& figure, int digits = 4);

/// A number for a sentence: `digits` significant digits, C locale, no trailing zeros.
std::string shortNumber(double value, int digits = 3);

}  // namespace rotorbench
