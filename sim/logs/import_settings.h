// How a table of measurements is to be understood: where its cells end, which line names the
// columns, and what each column is. Guessed from the text, corrected by a person, remembered for
// the next file with the same columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/core/schema.h"
#include "sim/logs/quantity.h"

namespace rotorbench {

class TextLines;

enum class Separator { Comma, Semicolon, Tab, Spaces, Bar };
enum class DecimalMark { Point, Comma };

struct CsvLayout {
  Separator separator = Separator::Comma;
  DecimalMark decimalMark = DecimalMark::Point;
  int headerLine = 1;         ///< number of the line with the names; 0: there is none
  int skippedLines = 0;       ///< after the line of names (or from the top) before the first row
  std::string comment = "#";  ///< lines that begin with this are left out; empty: none are
  bool operator==(const CsvLayout&) const = default;
};

/// The character of a separator; kSpaces for Spaces.
char separatorSign(Separator separator);

/// The key of a column that is kept under a name of its own.
inline constexpr std::string_view kOtherQuantity = "other";

/// What one column is. SI value = conversion(scale * written + offset); of a time written as text,
/// the seconds since the first row are "written".
struct ColumnMapping {
  std::string column;    ///< its name in the file
  std::string quantity;  ///< key of a Quantity, kOtherQuantity, or empty: left out
  std::string unit;      ///< as written in the file
  std::string channel;   ///< for kOtherQuantity: the name it gets
  double scale = 1;
  double offset = 0;
  bool operator==(const ColumnMapping&) const = default;
};

struct ImportSettings {
  CsvLayout layout;
  ChannelGroup group = ChannelGroup::Run;
  std::vector<ColumnMapping> columns;
  bool operator==(const ImportSettings&) const = default;
};

/// The channel a column becomes.
Channel channelOf(const ColumnMapping& column, ChannelGroup group);
/// From scale * written + offset to SI; 1 where the unit does not fit.
UnitConversion conversionOf(const ColumnMapping& column);

/// Names under which a column was found; the first rows as they stand; and how many of the rows
/// looked at hold a number, a time written as text (time_text.h), another text, or nothing.
struct PreviewColumn {
  std::string name, unit;
  std::vector<std::string> cells;
  std::size_t numbers = 0, times = 0, texts = 0, empty = 0;
};

struct CsvPreview {
  std::vector<PreviewColumn> columns;
  std::size_t rows = 0;  ///< of the preview
};

/// The separator that cuts most lines alike, the line of names before the first rows of numbers,
/// the decimal mark.
CsvLayout guessLayout(const TextLines& lines);
/// The first rows in that layout. Never throws.
CsvPreview previewOf(const TextLines& lines, const CsvLayout& layout, std::size_t rows = 200);
/// What the names and units of the columns say. One column for each quantity, the one that fits
/// best.
std::vector<ColumnMapping> guessMapping(const CsvPreview& preview);
/// The group whose horizontal axis is among the mapped columns: time before throttle before advance
/// ratio.
ChannelGroup guessGroup(const std::vector<ColumnMapping>& columns);

/// The names of all columns as one text: what a remembered mapping is filed under.
std::string columnsKey(const CsvPreview& preview);

template <>
struct Describe<CsvLayout> {
  static void fields(schema::Builder<CsvLayout>& b);
};
template <>
struct Describe<ColumnMapping> {
  static void fields(schema::Builder<ColumnMapping>& b);
};
template <>
struct Describe<ImportSettings> {
  static void fields(schema::Builder<ImportSettings>& b);
};

}  // namespace rotorbench
