// The layout of a table that nobody described: tried on its first lines.
#include <algorithm>
#include <array>
#include <map>

#include "sim/core/number_text.h"
#include "sim/io/csv_cells.h"
#include "sim/logs/import_settings.h"
#include "sim/logs/table_rows.h"
#include "sim/logs/text_lines.h"
#include "sim/logs/time_text.h"

namespace rotorbench {

namespace {

constexpr std::size_t kLinesLookedAt = 400;

/// One line as a separator cuts it.
struct Cut {
  std::size_t line;  ///< index
  std::size_t cells = 0, numbers = 0, filled = 0;
  /// More numbers than words.
  [[nodiscard]] bool isRow() const { return filled > 0 && 2 * numbers >= filled; }
};

std::vector<Cut> cutsOf(const TextLines& lines, Separator separator) {
  std::vector<Cut> cuts;
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < std::min(lines.size(), kLinesLookedAt); ++i) {
    if (lines.tooLong(i) || isPassedOver(lines.line(i), "#")) continue;
    Cut cut{.line = i};
    if (splitCells(lines.line(i), separatorSign(separator), cells) != CellFault::None) continue;
    cut.cells = cells.size();
    for (const std::string& cell : cells) {
      if (trimmedCell(cell).empty()) continue;
      ++cut.filled;
      if (readCell(cell, true) || readTimeText(cell)) ++cut.numbers;
    }
    cuts.push_back(cut);
  }
  return cuts;
}

/// The number of cells most rows of numbers have.
std::size_t usualWidth(const std::vector<Cut>& cuts) {
  std::map<std::size_t, std::size_t> counts;
  for (const Cut& cut : cuts) {
    if (cut.isRow()) ++counts[cut.cells];
  }
  const auto most = std::ranges::max_element(
      counts, {}, [](const auto& widthAndCount) { return widthAndCount.second; });
  return most == counts.end() ? 0 : most->first;
}

/// How much of the text becomes rows of numbers; tables of one column count for little.
double score(const std::vector<Cut>& cuts) {
  const std::size_t width = usualWidth(cuts);
  double sum = 0;
  for (const Cut& cut : cuts) {
    if (!cut.isRow() || cut.cells != width) continue;
    sum += static_cast<double>(cut.numbers) / static_cast<double>(cut.filled);
  }
  constexpr double kOneColumn = 1e-3;
  return width >= 2 ? sum : kOneColumn * sum;
}

/// The line of names above the first row, and how far the row is below it.
void findNames(const std::vector<Cut>& cuts, CsvLayout& layout) {
  constexpr std::size_t kMostAbove = 3;
  const std::size_t width = usualWidth(cuts);
  const auto first =
      std::ranges::find_if(cuts, [&](const Cut& cut) { return cut.isRow() && cut.cells == width; });
  const auto row = static_cast<std::size_t>(first - cuts.begin());
  layout.headerLine = 0;
  layout.skippedLines = first == cuts.end() ? 0 : static_cast<int>(first->line);
  if (first == cuts.end() && !cuts.empty()) layout.headerLine = 1, layout.skippedLines = 0;
  std::size_t names = row;
  for (std::size_t i = row; i-- > 0 && row - i <= kMostAbove;) {
    if (cuts[i].cells == width && cuts[i].numbers == 0) names = i;
  }
  // Names of a table whose rows have surplus cells, or too few.
  if (names == row && row > 0 && cuts[row - 1].cells >= 2) names = row - 1;
  if (names == row) return;
  layout.headerLine = static_cast<int>(cuts[names].line) + 1;
  // Lines of words right below the names are units or dashes; a row with one number is a row.
  std::size_t start = names + 1;
  while (start < row && cuts[start].numbers == 0) ++start;
  // Where no row has the usual width, the table ends with the last line looked at.
  const std::size_t begins = start < cuts.size() ? cuts[start].line : cuts.back().line + 1;
  layout.skippedLines = static_cast<int>(begins - cuts[names].line) - 1;
}

/// A decimal comma where some cells are numbers only with it and none has a point.
DecimalMark guessMark(const TextLines& lines, const CsvLayout& layout) {
  TableRows rows(lines, layout);
  std::vector<std::string> cells;
  std::size_t commas = 0, points = 0;
  for (std::size_t i = 0; i < kLinesLookedAt && rows.next(cells); ++i) {
    for (const std::string& cell : cells) {
      if (!readCell(cell, true)) continue;
      if (cell.find(',') != std::string::npos) ++commas;
      if (cell.find('.') != std::string::npos) ++points;
    }
  }
  return commas > points ? DecimalMark::Comma : DecimalMark::Point;
}

void addColumns(std::vector<PreviewColumn>& columns, std::size_t count) {
  while (columns.size() < std::min(count, kMaxCsvColumns)) {
    columns.push_back({"column " + std::to_string(columns.size() + 1), {}, {}, 0, 0, 0, 0});
  }
}

/// A separator at the end of a line makes no column.
std::vector<std::string> withoutTail(std::vector<std::string> cells) {
  if (cells.size() > 1 && trimmedCell(cells.back()).empty()) cells.pop_back();
  return cells;
}

/// The number of cells most rows have.
std::size_t usualLength(const std::vector<std::vector<std::string>>& rows) {
  std::map<std::size_t, std::size_t> counts;
  for (const auto& row : rows) ++counts[row.size()];
  const auto most = std::ranges::max_element(
      counts, {}, [](const auto& lengthAndCount) { return lengthAndCount.second; });
  return most == counts.end() ? 0 : most->first;
}

/// "speed", "speed (2)".
std::string uniqueName(const std::vector<PreviewColumn>& columns, std::size_t index,
                       const std::string& name) {
  std::string unique = name;
  for (int copy = 2;; ++copy) {
    const auto end = columns.begin() + static_cast<std::ptrdiff_t>(index);
    if (std::find_if(columns.begin(), end,
                     [&](const PreviewColumn& c) { return c.name == unique; }) == end) {
      return unique;
    }
    unique = name + " (" + std::to_string(copy) + ")";
  }
}

void nameColumns(std::vector<PreviewColumn>& columns, const std::vector<std::string>& names) {
  constexpr std::size_t kLongestName = 100;
  for (std::size_t i = 0; i < std::min(names.size(), columns.size()); ++i) {
    const CellHeading heading = readHeading(names[i]);
    columns[i].unit = excerpt(heading.unit, kLongestName);
    if (!heading.name.empty()) {
      columns[i].name = uniqueName(columns, i, excerpt(heading.name, kLongestName));
    }
  }
}

}  // namespace

CsvLayout guessLayout(const TextLines& lines) {
  constexpr std::array kOrder{Separator::Semicolon, Separator::Tab, Separator::Comma,
                              Separator::Bar, Separator::Spaces};
  CsvLayout layout;
  double best = 0;
  for (const Separator separator : kOrder) {
    const double s = score(cutsOf(lines, separator));
    if (s > best) best = s, layout.separator = separator;
  }
  findNames(cutsOf(lines, layout.separator), layout);
  layout.decimalMark = guessMark(lines, layout);
  return layout;
}

CsvPreview previewOf(const TextLines& lines, const CsvLayout& layout, std::size_t rows) {
  TableRows table(lines, layout);
  std::vector<std::vector<std::string>> head;
  std::vector<std::string> cells;
  while (head.size() < rows && table.next(cells)) head.push_back(withoutTail(cells));
  const std::vector<std::string> names = withoutTail(table.names());

  CsvPreview preview;
  preview.rows = head.size();
  addColumns(preview.columns, std::max(names.size(), usualLength(head)));
  nameColumns(preview.columns, names);
  const bool comma = layout.decimalMark == DecimalMark::Comma;
  for (std::size_t c = 0; c < preview.columns.size(); ++c) {
    PreviewColumn& column = preview.columns[c];
    for (const std::vector<std::string>& row : head) {
      const std::string_view cell = c < row.size() ? trimmedCell(row[c]) : std::string_view();
      column.cells.push_back(excerpt(cell));
      ++(cell.empty()            ? column.empty
         : readCell(cell, comma) ? column.numbers
         : readTimeText(cell)    ? column.times
                                 : column.texts);
    }
  }
  return preview;
}

}  // namespace rotorbench
