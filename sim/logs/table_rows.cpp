#include "sim/logs/table_rows.h"

#include <algorithm>

#include "sim/io/csv_cells.h"

namespace rotorbench {

bool isPassedOver(std::string_view line, const std::string& comment) {
  const std::string_view plain = trimmedCell(line);
  return plain.empty() || (!comment.empty() && plain.starts_with(comment));
}

TableRows::TableRows(const TextLines& lines, const CsvLayout& layout)
    : lines_(lines),
      layout_(layout),
      separator_(separatorSign(layout.separator)),
      at_(static_cast<std::size_t>(std::max(layout.headerLine, 0)) +
          static_cast<std::size_t>(std::max(layout.skippedLines, 0))) {}

std::vector<std::string> TableRows::names() const {
  std::vector<std::string> cells;
  const auto line = static_cast<std::size_t>(std::max(layout_.headerLine, 0));
  if (line == 0 || line > lines_.size() || lines_.tooLong(line - 1)) return cells;
  std::string_view text = lines_.line(line - 1);
  // Names behind a comment mark are names all the same.
  if (const auto plain = trimmedCell(text);
      !layout_.comment.empty() && plain.starts_with(layout_.comment)) {
    text = trimmedCell(plain.substr(layout_.comment.size()));
  }
  if (splitCells(text, separator_, cells) != CellFault::None) cells.clear();
  return cells;
}

bool TableRows::next(std::vector<std::string>& cells) {
  while (at_ < lines_.size()) {
    const std::size_t line = at_++;
    if (lines_.tooLong(line)) {
      tooLong_.add(at_);
      continue;
    }
    const std::string_view text = lines_.line(line);
    if (isPassedOver(text, layout_.comment)) continue;
    if (splitCells(text, separator_, cells) == CellFault::None) return true;
    openQuotes_.add(at_);
  }
  return false;
}

}  // namespace rotorbench
