// One figure of a data sheet or a performance sheet: what it is, how large, how it was worked out
// and what limits it. Values are SI; the unit a person reads first stands beside.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/sentence.h"

namespace rotorbench {

struct Figure {
  std::string key;        ///< "hover.throttle"
  std::string group;      ///< "Hover"
  std::string label;      ///< "Throttle"
  std::string symbol;     ///< "d_h"
  double value = 0;       ///< SI; NaN where there is none, and `note` says why
  std::string unit;       ///< SI
  std::string shownUnit;  ///< converts to `unit`
  Sentence formula;       ///< in words and plain mathematics
  std::string source;     ///< of the formula; may be empty
  Sentence note;          ///< a sentence: what limits the value, or why there is none; may be empty
};

/// Figures in the order they are read, and sentences about what cannot be right or will not do.
struct FigureSheet {
  std::vector<Figure> figures;
  std::vector<Sentence> warnings;

  /// The figure named `key`; there must be one.
  [[nodiscard]] const Figure& at(const std::string& key) const;
};

/// Where there is no value.
inline constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

/// Writes the figures of one group: keys "group.key", one title.
class FigureGroup {
 public:
  FigureGroup(FigureSheet& sheet, std::string key, std::string title)
      : sheet_(sheet), key_(std::move(key)), title_(std::move(title)) {}
  /// The figure, for its note.
  Figure& add(const char* key, const char* label, const char* symbol, double value,
              const char* unit, const char* shown, Sentence formula, const char* source = "");

 private:
  FigureSheet& sheet_;
  std::string key_, title_;
};

/// "12.3 A" in the shown unit with four significant digits, in the C locale unless another writer
/// is given; "–" for NaN.
std::string figureText(const Figure& figure, const NumberWriter& write = shortNumber);
/// The number of figureText() alone.
std::string figureNumber(const Figure& figure, const NumberWriter& write = shortNumber);

}  // namespace rotorbench
