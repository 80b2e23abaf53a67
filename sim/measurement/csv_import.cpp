#include "sim/measurement/csv_import.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "sim/core/number_text.h"
#include "sim/core/units.h"
#include "sim/io/csv_cells.h"
#include "sim/measurement/table_rows.h"

namespace rotorbench {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

Problem warning(std::string path, std::string what, std::string then) {
  return {std::move(path), std::move(what), std::move(then), true};
}

std::string times(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string firstAt(const Occurrences& found) {
  std::string text = " (first in line " + std::to_string(found.firstLine);
  if (!found.example.empty()) text += ": " + inQuotes(found.example);
  return text + ")";
}

/// One column on its way into the table.
struct Taken {
  std::size_t source = 0;  ///< column of the file
  std::string name;
  Channel channel;
  UnitConversion conversion;
  double scale = 1, offset = 0;
  Occurrences texts;
  std::size_t numbers = 0;

  [[nodiscard]] double si(double written) const {
    return conversion.toSi(scale * written + offset);
  }
};

Channel channelOf(const ColumnMapping& column, ChannelGroup group) {
  if (const Quantity* quantity = findQuantity(column.quantity)) {
    return {channelName(*quantity, group), std::string(quantity->unit),
            std::string(quantity->label) + ", measured"};
  }
  const Unit* unit = findUnit(column.unit);
  const std::string si =
      unit != nullptr ? std::string(unit->dimension) : canonicalUnit(column.unit);
  return {column.channel.empty() ? column.column : column.channel, si, "Measured"};
}

UnitConversion conversionOf(const ColumnMapping& column) {
  if (const Quantity* quantity = findQuantity(column.quantity)) {
    return conversionOf(*quantity, column.unit).value_or(UnitConversion{});
  }
  const Unit* unit = findUnit(column.unit);
  return {unit != nullptr ? unit->factor : 1, 0};
}

class Importer {
 public:
  Importer(const TextLines& lines, const ImportSettings& settings)
      : rows_(lines, settings.layout),
        settings_(settings),
        comma_(settings.layout.decimalMark == DecimalMark::Comma) {
    result_.table.source = lines.source();
    preview_ = previewOf(lines, settings.layout);
    result_.problems = checkSettings(settings, preview_);
  }

  ImportResult run() {
    if (!result_.problems.empty()) return std::move(result_);
    chooseColumns();
    read();
    report();
    if (rowsRead_ > 0 && values_.front().empty()) {
      result_.problems.push_back({{},
                                  "no row holds a number in the chosen columns",
                                  "check separator, decimal mark and columns"});
    }
    if (result_.usable()) sort();
    return std::move(result_);
  }

 private:
  void chooseColumns() {
    const std::string abscissa(abscissaOf(settings_.group).key);
    for (const ColumnMapping& column : settings_.columns) {
      if (column.quantity.empty()) continue;
      const auto at = std::ranges::find(preview_.columns, column.column, &PreviewColumn::name);
      Taken taken{static_cast<std::size_t>(at - preview_.columns.begin()),
                  column.column,
                  channelOf(column, settings_.group),
                  conversionOf(column),
                  column.scale,
                  column.offset,
                  {},
                  0};
      taken_.insert(column.quantity == abscissa ? taken_.begin() : taken_.end(), std::move(taken));
      hasAbscissa_ = hasAbscissa_ || column.quantity == abscissa;
    }
    values_.resize(taken_.size());
  }

  void read() {
    std::vector<std::string> cells;
    std::vector<double> row(taken_.size());
    while (rows_.next(cells)) {
      ++rowsRead_;
      const std::size_t line = rows_.lineNumber();
      checkWidth(cells, line);
      std::size_t numbers = 0;
      for (std::size_t c = 0; c < taken_.size(); ++c) {
        row[c] = numberIn(cells, taken_[c], line);
        if (!std::isnan(row[c])) ++numbers, ++taken_[c].numbers;
      }
      if (numbers == 0) {
        withoutNumbers_.add(line);
      } else if (hasAbscissa_ && std::isnan(row[0])) {
        withoutAbscissa_.add(line);
      } else {
        keep(row, line);
      }
    }
  }

  void checkWidth(const std::vector<std::string>& cells, std::size_t line) {
    const std::size_t width = preview_.columns.size();
    if (cells.size() < width) tooShort_.add(line);
    if (cells.size() > width + 1 ||
        (cells.size() == width + 1 && !trimmedCell(cells.back()).empty())) {
      tooWide_.add(line);
    }
  }

  double numberIn(const std::vector<std::string>& cells, Taken& column, std::size_t line) const {
    if (column.source >= cells.size()) return kNothing;
    const std::string_view cell = trimmedCell(cells[column.source]);
    if (cell.empty()) return kNothing;
    const auto written = readCell(cell, comma_);
    const double value = written ? column.si(*written) : kNothing;
    if (!std::isfinite(value)) {
      column.texts.add(line, excerpt(cell));
      return kNothing;
    }
    return value;
  }

  void keep(const std::vector<double>& row, std::size_t line) {
    if (hasAbscissa_ && !values_[0].empty() && row[0] < values_[0].back()) backwards_.add(line);
    for (std::size_t c = 0; c < row.size(); ++c) values_[c].push_back(row[c]);
  }

  void note(const Occurrences& found, const char* one, const char* many, std::string then) {
    if (found.count == 0) return;
    result_.problems.push_back(
        warning({}, times(found.count, one, many) + firstAt(found), std::move(then)));
  }

  void report() {
    if (rowsRead_ == 0) {
      result_.problems.push_back({{},
                                  "there are no rows below the names",
                                  "check the line of names and the lines to skip"});
    }
    note(rows_.tooLong(), "line is longer than 1 MiB", "lines are longer than 1 MiB", "left out");
    note(rows_.openQuotes(), "line has a quotation mark that is not closed",
         "lines have a quotation mark that is not closed", "left out");
    note(tooShort_, "row has fewer cells than there are columns",
         "rows have fewer cells than there are columns", "the missing cells are taken as empty");
    note(tooWide_, "row has more cells than there are columns",
         "rows have more cells than there are columns", "the surplus is left out");
    note(withoutNumbers_, "row has no number in the chosen columns",
         "rows have no number in the chosen columns", "left out");
    note(withoutAbscissa_, "row has no value for the horizontal axis",
         "rows have no value for the horizontal axis", "left out");
    note(backwards_, "row goes back on the horizontal axis", "rows go back on the horizontal axis",
         "rows are sorted by it");
    for (const Taken& column : taken_) reportColumn(column);
  }

  void reportColumn(const Taken& column) {
    const std::string path = "column " + inQuotes(column.name);
    if (column.texts.count > 0) {
      std::string then = "taken as empty";
      if (!comma_ && readCell(column.texts.example, true)) then += "; is the decimal mark a comma?";
      result_.problems.push_back(warning(path,
                                         times(column.texts.count, "cell is", "cells are") +
                                             " not a number" + firstAt(column.texts),
                                         then));
    }
    if (column.numbers == 0 && rowsRead_ > 0) {
      result_.problems.push_back(warning(path, "no cell holds a number", {}));
    }
  }

  /// Rows in the order of the abscissa, or numbered where there is none.
  void sort() {
    MeasuredTable& table = result_.table;
    const std::size_t rows = values_.front().size();
    if (!hasAbscissa_) {
      table.channels.push_back({"row", "1", "Number of the row"});
      std::vector<double>& numbers = table.columns.emplace_back(rows);
      std::iota(numbers.begin(), numbers.end(), 1.0);
    }
    std::vector<std::size_t> order(rows);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (hasAbscissa_) {
      std::ranges::stable_sort(order, {}, [this](std::size_t row) { return values_[0][row]; });
    }
    for (std::size_t c = 0; c < taken_.size(); ++c) {
      table.channels.push_back(taken_[c].channel);
      std::vector<double>& column = table.columns.emplace_back();
      column.reserve(rows);
      for (const std::size_t row : order) column.push_back(values_[c][row]);
    }
  }

  TableRows rows_;
  const ImportSettings& settings_;
  bool comma_;
  CsvPreview preview_;
  ImportResult result_;
  std::vector<Taken> taken_;
  std::vector<std::vector<double>> values_;
  bool hasAbscissa_ = false;
  std::size_t rowsRead_ = 0;
  Occurrences tooShort_, tooWide_, withoutNumbers_, withoutAbscissa_, backwards_;
};

void checkColumn(const ColumnMapping& column, const CsvPreview& preview,
                 std::vector<Problem>& problems) {
  const std::string path = "column " + inQuotes(column.column);
  if (std::ranges::find(preview.columns, column.column, &PreviewColumn::name) ==
      preview.columns.end()) {
    problems.push_back({path, "the table has no such column", {}});
  }
  if (!std::isfinite(column.scale) || !std::isfinite(column.offset) || column.scale == 0) {
    problems.push_back(
        {path, "the scale or the offset cannot be used", "must be finite, the scale not 0"});
  }
  if (column.quantity == kOtherQuantity) return;
  const Quantity* quantity = findQuantity(column.quantity);
  if (quantity == nullptr) {
    problems.push_back({path, "the quantity " + excerpt(column.quantity) + " is not known", {}});
  } else if (!conversionOf(*quantity, column.unit)) {
    const std::string unit = column.unit.empty() ? "no unit" : "the unit " + excerpt(column.unit);
    problems.push_back({path, unit + " does not fit " + std::string(quantity->label),
                        "must convert to " + std::string(quantity->unit)});
  }
}

}  // namespace

bool ImportResult::usable() const {
  return std::ranges::all_of(problems, &Problem::warning);
}

ImportSettings guessSettings(const TextLines& lines) {
  ImportSettings settings;
  settings.layout = guessLayout(lines);
  settings.columns = guessMapping(previewOf(lines, settings.layout));
  settings.group = guessGroup(settings.columns);
  return settings;
}

std::vector<Problem> checkSettings(const ImportSettings& settings, const CsvPreview& preview) {
  std::vector<Problem> problems;
  if (preview.rows == 0) {
    problems.push_back(
        {{}, "there are no rows below the names", "check the line of names and the lines to skip"});
    return problems;
  }
  std::set<std::string> names;
  bool abscissa = settings.group == ChannelGroup::Run;
  for (const ColumnMapping& column : settings.columns) {
    if (column.quantity.empty()) continue;
    checkColumn(column, preview, problems);
    abscissa = abscissa || column.quantity == abscissaOf(settings.group).key;
    const std::string name = channelOf(column, settings.group).name;
    if (!names.insert(name).second) {
      problems.push_back({"column " + inQuotes(column.column), excerpt(name) + " is chosen twice",
                          "each quantity belongs to one column"});
    }
  }
  if (names.empty()) {
    problems.push_back({{}, "no column is chosen", "choose what at least one column is"});
  } else if (!abscissa) {
    const std::string label(abscissaOf(settings.group).label);
    problems.push_back({{},
                        "no column is chosen as " + label,
                        "it is the horizontal axis of what this is compared with"});
  }
  return problems;
}

ImportResult importTable(const TextLines& lines, const ImportSettings& settings) {
  return Importer(lines, settings).run();
}

}  // namespace rotorbench
