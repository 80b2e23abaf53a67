// From the text of a log to a measured table, whatever the log is like: rows too short or too long,
// empty cells, words between numbers, time that runs backwards. What cannot be used is left out and
// said, with how often and where first.
//
//   const TextLines lines = TextLines::fromFile(path);
//   ImportSettings settings = guessSettings(lines);
//   const ImportResult result = importTable(lines, settings);
//   if (result.usable()) show(recordingOf(result.table));
#pragma once

#include <vector>

#include "sim/core/error.h"
#include "sim/logs/import_settings.h"
#include "sim/logs/measured_table.h"
#include "sim/logs/text_lines.h"

namespace rotorbench {

struct ImportResult {
  MeasuredTable table;
  std::vector<Problem>
      problems;  ///< warnings about what was left out; an error where nothing can be used
  [[nodiscard]] bool usable() const;
};

/// Layout, mapping and group guessed from the text.
ImportSettings guessSettings(const TextLines& lines);

/// What is wrong with the settings for this text: a column that is not there, a unit that does not
/// fit its quantity, a quantity chosen twice, a name missing.
std::vector<Problem> checkSettings(const ImportSettings& settings, const CsvPreview& preview);

/// Never throws. Rows are sorted by the abscissa of the group (time, throttle or advance ratio);
/// where time is not among the columns, rows are numbered instead.
ImportResult importTable(const TextLines& lines, const ImportSettings& settings);

}  // namespace rotorbench
