// The rows of a table of text in a given layout, one after the other, with a note of the lines that
// had to be left out.
#pragma once

#include <string>
#include <vector>

#include "sim/logs/import_settings.h"
#include "sim/logs/occurrences.h"
#include "sim/logs/text_lines.h"

namespace rotorbench {

class TableRows {
 public:
  /// Both outlive this.
  TableRows(const TextLines& lines, const CsvLayout& layout);

  /// Cells of the line of names; empty if the layout has none, or if the line is missing or broken.
  [[nodiscard]] std::vector<std::string> names() const;
  /// The cells of the next row; false at the end. Empty lines and comments are passed over.
  bool next(std::vector<std::string>& cells);
  /// Of the row given last, from 1.
  [[nodiscard]] std::size_t lineNumber() const { return at_; }

  [[nodiscard]] const Occurrences& tooLong() const { return tooLong_; }
  [[nodiscard]] const Occurrences& openQuotes() const { return openQuotes_; }

 private:
  const TextLines& lines_;
  const CsvLayout& layout_;
  char separator_;
  std::size_t at_;  ///< index of the next line
  Occurrences tooLong_, openQuotes_;
};

/// True for a line that holds no row: nothing, or a comment.
bool isPassedOver(std::string_view line, const std::string& comment);

}  // namespace rotorbench
