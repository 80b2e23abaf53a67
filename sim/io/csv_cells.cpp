#include "sim/io/csv_cells.h"

#include <algorithm>

#include "sim/core/number_text.h"

namespace rotorbench {

namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t';
}

/// Appends what stands in quotes to `cell` and takes it off `rest`, which begins after the first
/// quote and ends at the separator.
CellFault takeQuoted(std::string_view& rest, char separator, std::string& cell) {
  while (true) {
    const std::size_t end = rest.find('"');
    if (end == std::string_view::npos) return CellFault::OpenQuote;
    cell += rest.substr(0, end);
    rest.remove_prefix(end + 1);
    if (!rest.starts_with('"')) break;
    cell += '"';
    rest.remove_prefix(1);
  }
  if (separator != kSpaces) {
    while (rest.starts_with(' ')) rest.remove_prefix(1);
  }
  const bool ends =
      rest.empty() || rest.front() == separator || (separator == kSpaces && isBlank(rest.front()));
  return ends ? CellFault::None : CellFault::TextAfterQuote;
}

/// Where the cell that begins here ends.
std::size_t endOfCell(std::string_view rest, char separator) {
  const std::size_t end = separator == kSpaces ? rest.find_first_of(" \t") : rest.find(separator);
  return std::min(end, rest.size());
}

}  // namespace

std::string_view trimmedCell(std::string_view text) {
  const auto isSpace = [](char c) { return isBlank(c) || c == '\r'; };
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

CellFault splitCells(std::string_view line, char separator, std::vector<std::string>& cells) {
  cells.clear();
  std::string_view rest = separator == kSpaces ? trimmedCell(line) : line;
  if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  while (true) {
    cells.emplace_back();
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    if (rest.starts_with('"')) {
      rest.remove_prefix(1);
      const CellFault fault = takeQuoted(rest, separator, cells.back());
      if (fault != CellFault::None) return fault;
    } else {
      const std::size_t end = endOfCell(rest, separator);
      cells.back() = rest.substr(0, end);
      rest.remove_prefix(end);
    }
    if (rest.empty()) return CellFault::None;
    rest.remove_prefix(1);
    while (separator == kSpaces && !rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
  }
}

std::optional<double> readCell(std::string_view cell, bool commaToo) {
  cell = trimmedCell(cell);
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  if (!commaToo || cell.find(',') == std::string_view::npos) return readNumber(cell);
  if (cell.find('.') != std::string_view::npos) return {};
  std::string point(cell);
  std::replace(point.begin(), point.end(), ',', '.');
  return readNumber(point);
}

CellHeading readHeading(std::string_view cell) {
  std::string_view name = trimmedCell(cell);
  std::string_view unit;
  if (!name.empty() && (name.back() == ']' || name.back() == ')')) {
    const std::size_t open = name.rfind(name.back() == ']' ? '[' : '(');
    if (open != std::string_view::npos && open > 0) {
      unit = trimmedCell(name.substr(open + 1, name.size() - open - 2));
      name = trimmedCell(name.substr(0, open));
    }
  }
  return {std::string(name), std::string(unit)};
}

}  // namespace rotorbench
