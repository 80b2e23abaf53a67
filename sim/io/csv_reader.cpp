#include <algorithm>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/core/units.h"
#include "sim/io/csv.h"
#include "sim/io/csv_cells.h"
#include "sim/io/file.h"

namespace rotorbench {

namespace {

constexpr std::size_t kMostCellProblems = 20;

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& source) : rest_(text), source_(source) {
    table_.source = source;
  }

  CsvTable read() {
    if (rest_.size() > kMaxCsvBytes) fail({}, "the file is too large", "must be at most 64 MiB");
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    readHeader();
    while (nextLine() && problems_.size() < kMostCellProblems) readRow();
    if (!problems_.empty()) throw InputError(source_, std::move(problems_));
    if (table_.rows() == 0) fail({}, "the table has no rows of numbers");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(std::string path, std::string what, std::string allowed = {}) const {
    throw InputError(source_, {{std::move(path), std::move(what), std::move(allowed)}});
  }

  [[nodiscard]] std::string linePath() const { return "line " + std::to_string(number_); }

  /// The next line that says something, in line_.
  bool nextLine() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      ++number_;
      if (end > kMaxCsvLine) fail(linePath(), "the line is too long", "must be at most 1 MiB");
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      if (line_.find('\0') != std::string_view::npos) fail(linePath(), "this is not text");
      if (const auto plain = trimmedCell(line_); !plain.empty() && plain.front() != '#')
        return true;
    }
    return false;
  }

  void readHeader() {
    if (!nextLine()) fail({}, "the file is empty", "must begin with a line of column names");
    separator_ = line_.find(';') != std::string_view::npos    ? ';'
                 : line_.find('\t') != std::string_view::npos ? '\t'
                                                              : ',';
    splitLine();
    if (cells_.size() > kMaxCsvColumns) {
      fail(linePath(), "there are " + std::to_string(cells_.size()) + " columns",
           "must be at most " + std::to_string(kMaxCsvColumns));
    }
    for (const std::string& cell : cells_) addColumn(cell);
  }

  /// "rotor1 [rpm]" -> name and unit.
  void addColumn(const std::string& cell) {
    if (findInvalidUtf8(cell)) fail(linePath(), "this is not text in UTF-8");
    const auto [name, unit] = readHeading(cell);
    if (name.empty()) {
      fail(linePath(), "column " + std::to_string(table_.columns.size() + 1) + " has no name",
           "the first line must name each column");
    }
    if (readCell(name, separator_ != ',')) {
      fail(linePath(), "the first line holds the number " + excerpt(name),
           "must hold the names of the columns, like \"time [s]\"");
    }
    if (table_.find(name) != nullptr) {
      fail(linePath(), "there are two columns called " + excerpt(name), "names must differ");
    }
    table_.columns.push_back({name, unit.empty() ? "1" : unit, {}});
  }

  void readRow() {
    splitLine();
    if (cells_.size() != table_.columns.size()) {
      problems_.push_back({linePath(), "there are " + std::to_string(cells_.size()) + " cells",
                           "must be " + std::to_string(table_.columns.size())});
      return;
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      CsvColumn& column = table_.columns[i];
      const std::string_view cell = trimmedCell(cells_[i]);
      const auto number = readCell(cell, separator_ != ',');
      if (!number && problems_.size() < kMostCellProblems) {
        problems_.push_back(
            {linePath() + ", column " + excerpt(column.name),
             cell.empty() ? std::string("the cell is empty") : inQuotes(cell) + " is not a number",
             "must be a finite number"});
      }
      column.values.push_back(number.value_or(0));
    }
  }

  /// Cells of line_.
  void splitLine() {
    switch (splitCells(line_, separator_, cells_)) {
      case CellFault::OpenQuote:
        fail(linePath(), "a quotation mark is not closed in its line");
      case CellFault::TextAfterQuote:
        fail(linePath(), "there is text after a closing quotation mark");
      case CellFault::None:
        return;
    }
  }

  std::string_view rest_, line_;
  const std::string& source_;
  std::size_t number_ = 0;
  char separator_ = ',';
  std::vector<std::string> cells_;
  CsvTable table_;
  std::vector<Problem> problems_;
};

}  // namespace

const CsvColumn* CsvTable::find(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const CsvColumn& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

std::vector<double> CsvTable::values(std::string_view name, std::string_view unit) const {
  const CsvColumn* column = find(name);
  if (column == nullptr) {
    std::vector<std::string> names;
    std::string list;
    for (const CsvColumn& c : columns) {
      names.push_back(c.name);
      if (names.size() <= kMostCellProblems) list += (list.empty() ? "" : ", ") + excerpt(c.name);
    }
    const auto near = schema::nearest(name, names);
    throw InputError(source, {{{},
                               "there is no column called " + excerpt(name),
                               near ? "the nearest is " + *near : "the columns are " + list}});
  }
  std::vector<double> converted = column->values;
  if (canonicalUnit(column->unit) == "1") return converted;
  if (!sameDimension(column->unit, unit)) {
    throw InputError(source, {{"column " + excerpt(column->name),
                               "the unit " + excerpt(column->unit) + " is not allowed",
                               "must convert to " + std::string(unit)}});
  }
  for (double& value : converted) value = convertUnit(value, column->unit, unit);
  return converted;
}

CsvTable readCsvTable(std::string_view text, const std::string& source) {
  return TableReader(text, source).read();
}

CsvTable readCsvFile(const std::filesystem::path& path) {
  return readCsvTable(readTextFile(path, kMaxCsvBytes), path.string());
}

}  // namespace rotorbench
