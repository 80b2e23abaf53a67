// The rows of a table of text in a given layout, one after the other, with a note of the lines that had to be left out.
#pragma once

#include <string>
#include <vector>

#include "sim/measurement/import_settings.h"
#include "sim/measurement/text_lines.h"

namespace rotorbench {

/// How often something was found, and where first (line number from 1, 0: never).
struct Occurrences {
  std::size_t count = 0;
  std::size_t firstLine = 0;
  std::string example;  ///< of the first

  void add(std::size_t line, std::string_view text = {}) {
    if (count++ == 0) firstLine = line, example = text;
  }
};

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
