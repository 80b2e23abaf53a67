#include "sim/logs/csv_import.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sim/core/number_text.h"
#include "sim/io/csv_cells.h"
#include "sim/logs/table_rows.h"
#include "sim/logs/time_text.h"

namespace rotorbench {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

Problem warning(std::string path, std::string what, std::string then) {
  return {std::move(path), std::move(what), std::move(then), true};
}

/// One column on its way into the table.
struct Taken {
  std::size_t source = 0;  ///< column of the file
  std::string name;
  Channel channel;
  UnitConversion conversion;
  double scale = 1, offset = 0;
  bool isTime = false;
  TimeLine clock{};
  Occurrences texts{};
  std::size_t numbers = 0, times = 0;

  /// The number in a cell, or the seconds of a time as text; empty where the column holds the other
  /// of the two.
  std::optional<double> written(std::string_view cell, bool comma) {
    if (const auto number = readCell(cell, comma)) return times == 0 ? number : std::nullopt;
    if (!isTime || numbers > times) return {};
    const auto seconds = clock.read(cell);
    times += seconds ? 1 : 0;
    return seconds;
  }
  [[nodiscard]] double si(double value) const { return conversion.toSi(scale * value + offset); }
};

class Importer {
 public:
  Importer(const TextLines& lines, const ImportSettings& settings)
      : lines_(lines),
        rows_(lines, settings.layout),
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
                  column.quantity == "time"};
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

  [[nodiscard]] double numberIn(const std::vector<std::string>& cells, Taken& column,
                                std::size_t line) const {
    if (column.source >= cells.size()) return kNothing;
    const std::string_view cell = trimmedCell(cells[column.source]);
    if (cell.empty()) return kNothing;
    const auto written = column.written(cell, comma_);
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
    result_.problems = lines_.notes();
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
    // The rows of a propeller come in curves, one after the other.
    if (settings_.group != ChannelGroup::OverAdvance) {
      note(backwards_, "row goes back on the horizontal axis",
           "rows go back on the horizontal axis", "rows are sorted by it");
    }
    for (const Taken& column : taken_) reportColumn(column);
  }

  void reportColumn(const Taken& column) {
    const std::string path = "column " + inQuotes(column.name);
    const std::string& example = column.texts.example;
    if (column.texts.count > 0) {
      std::string then = "taken as empty";
      if (!comma_ && !readCell(example, false) && readCell(example, true)) {
        then += "; is the decimal mark a comma?";
      }
      if (column.isTime && resemblesTime(example)) {
        then += "; times are read as 2024-03-01T12:00:00.25 or 12:00:00.25";
      }
      const char* what = column.times > 0 ? " not a time like the first one" : " not a number";
      result_.problems.push_back(warning(
          path, times(column.texts.count, "cell is", "cells are") + what + firstAt(column.texts),
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

  const TextLines& lines_;
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

ImportResult importTable(const TextLines& lines, const ImportSettings& settings) {
  return Importer(lines, settings).run();
}

}  // namespace rotorbench
