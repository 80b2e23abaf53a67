// One line of a table of text cut into its cells, and cells read as numbers: what strict tables
// (csv.h) and the import of measured data have in common.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotorbench {

/// Largest table of text that is read, its longest line and its most columns.
inline constexpr std::size_t kMaxCsvBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxCsvLine = std::size_t{1} << 20;
inline constexpr std::size_t kMaxCsvColumns = 1000;

/// Separator that stands for any number of spaces and tabs in a row.
inline constexpr char kSpaces = ' ';

/// Without spaces, tabs and carriage returns at both ends.
std::string_view trimmedCell(std::string_view text);

enum class CellFault { None, OpenQuote, TextAfterQuote };

/// Replaces `cells` by the cells of a line: quotes taken off, doubled quotes made single. A line
/// with a fault leaves the cells before it.
CellFault splitCells(std::string_view line, char separator, std::vector<std::string>& cells);

/// A finite number with a decimal point or, where `commaToo`, with a comma instead; a leading + is
/// allowed. No signs between thousands.
std::optional<double> readCell(std::string_view cell, bool commaToo);

/// A column's name and unit: "rotor1 [rpm]" or "rotor1 (rpm)". The unit is empty where none is
/// written.
struct CellHeading {
  std::string name, unit;
};
CellHeading readHeading(std::string_view cell);

}  // namespace rotorbench
