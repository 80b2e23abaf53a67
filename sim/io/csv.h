// Comma-separated values: recordings out, tables in.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/recording.h"

namespace rotorbench {

/// What part of a recording is written; by default all published rows and channels.
struct CsvSelection {
  std::optional<double> from, to;     ///< abscissa, both ends included
  std::vector<std::size_t> channels;  ///< indices, in the order of the columns; empty: all
};

/// A header line "name [unit],..." and one line per row; '.' and ',' whatever the locale, '\n',
/// numbers with the shortest digits that read back equal, "nan" and "inf" as such. The same
/// recording gives the same bytes.
void writeCsv(std::ostream& out, const Recording& recording, const CsvSelection& selection = {});

/// One column of a table that was read.
struct CsvColumn {
  std::string name;
  std::string unit = "1";      ///< from "name [unit]" or "name (unit)"
  std::vector<double> values;  ///< in `unit`, all finite
};

struct CsvTable {
  std::string source;
  std::vector<CsvColumn> columns;  ///< at least one, all of the same length

  [[nodiscard]] std::size_t rows() const { return columns.front().values.size(); }
  [[nodiscard]] const CsvColumn* find(std::string_view name) const;
  /// A column converted to `unit`; a column without a unit is taken to be in it. Throws InputError
  /// if there is no such column (naming the nearest) or its unit does not convert.
  [[nodiscard]] std::vector<double> values(std::string_view name, std::string_view unit) const;
};

/// Reads a table of numbers under one line of names. Columns are separated by comma, semicolon or
/// tab; with the latter two a decimal comma is understood. Names may be quoted; empty lines and
/// lines with # in front are left out. Throws InputError with the lines at fault (the first 20), or
/// if a limit is exceeded: 64 MiB, 1 MiB per line, 1000 columns.
CsvTable readCsvTable(std::string_view text, const std::string& source);
CsvTable readCsvFile(const std::filesystem::path& path);

}  // namespace rotorbench
