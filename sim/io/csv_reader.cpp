#include <algorithm>
#include <cctype>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/core/units.h"
#include "sim/io/csv.h"
#include "sim/io/file.h"

namespace rotorbench {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxLine = std::size_t{1} << 20;
constexpr std::size_t kMaxColumns = 1000;
constexpr std::size_t kMostProblems = 20;

std::string_view trimmed(std::string_view text) {
  const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& source) : rest_(text), source_(source) {
    table_.source = source;
  }

  CsvTable read() {
    if (rest_.size() > kMaxBytes) fail({}, "the file is too large", "must be at most 64 MiB");
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    readHeader();
    while (nextLine() && problems_.size() < kMostProblems) readRow();
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
      if (end > kMaxLine) fail(linePath(), "the line is too long", "must be at most 1 MiB");
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      if (line_.find('\0') != std::string_view::npos) fail(linePath(), "this is not text");
      if (const auto plain = trimmed(line_); !plain.empty() && plain.front() != '#') return true;
    }
    return false;
  }

  void readHeader() {
    if (!nextLine()) fail({}, "the file is empty", "must begin with a line of column names");
    separator_ = line_.find(';') != std::string_view::npos    ? ';'
                 : line_.find('\t') != std::string_view::npos ? '\t'
                                                              : ',';
    splitLine();
    if (cells_.size() > kMaxColumns) {
      fail(linePath(), "there are " + std::to_string(cells_.size()) + " columns",
           "must be at most " + std::to_string(kMaxColumns));
    }
    for (const std::string& cell : cells_) addColumn(cell);
  }

  /// "rotor1 [rpm]" -> name and unit.
  void addColumn(const std::string& cell) {
    CsvColumn column;
    std::string_view name = trimmed(cell);
    if (findInvalidUtf8(name)) fail(linePath(), "this is not text in UTF-8");
    if (!name.empty() && (name.back() == ']' || name.back() == ')')) {
      const std::size_t open = name.rfind(name.back() == ']' ? '[' : '(');
      if (open != std::string_view::npos && open > 0) {
        column.unit = trimmed(name.substr(open + 1, name.size() - open - 2));
        name = trimmed(name.substr(0, open));
      }
    }
    if (name.empty()) {
      fail(linePath(), "column " + std::to_string(table_.columns.size() + 1) + " has no name",
           "the first line must name each column");
    }
    if (numberFrom(name)) {
      fail(linePath(), "the first line holds the number " + excerpt(name),
           "must hold the names of the columns, like \"time [s]\"");
    }
    if (table_.find(name) != nullptr) {
      fail(linePath(), "there are two columns called " + excerpt(name), "names must differ");
    }
    column.name = name;
    table_.columns.push_back(std::move(column));
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
      const std::string_view cell = trimmed(cells_[i]);
      const auto number = numberFrom(cell);
      if (!number && problems_.size() < kMostProblems) {
        problems_.push_back(
            {linePath() + ", column " + excerpt(column.name),
             cell.empty() ? std::string("the cell is empty") : inQuotes(cell) + " is not a number",
             "must be a finite number"});
      }
      column.values.push_back(number.value_or(0));
    }
  }

  /// A number with a point, or with a comma where columns are not separated by it.
  [[nodiscard]] std::optional<double> numberFrom(std::string_view cell) const {
    if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
    if (separator_ == ',' || cell.find(',') == std::string_view::npos) return readNumber(cell);
    if (cell.find('.') != std::string_view::npos) return {};
    std::string point(cell);
    std::replace(point.begin(), point.end(), ',', '.');
    return readNumber(point);
  }

  /// Cells of line_, quotes taken off, doubled quotes made single.
  void splitLine() {
    cells_.clear();
    std::string_view rest = line_;
    if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
    while (true) {
      cells_.emplace_back();
      while (rest.starts_with(' ')) rest.remove_prefix(1);
      if (rest.starts_with('"')) {
        rest = takeQuoted(rest.substr(1), cells_.back());
      } else {
        const std::size_t end = std::min(rest.find(separator_), rest.size());
        cells_.back() = rest.substr(0, end);
        rest.remove_prefix(end);
      }
      if (rest.empty()) return;
      rest.remove_prefix(1);
    }
  }

  /// Returns what follows the closing quote, beginning at the separator.
  std::string_view takeQuoted(std::string_view rest, std::string& cell) const {
    while (true) {
      const std::size_t end = rest.find('"');
      if (end == std::string_view::npos) {
        fail(linePath(), "a quotation mark is not closed in its line");
      }
      cell += rest.substr(0, end);
      rest.remove_prefix(end + 1);
      if (!rest.starts_with('"')) break;
      cell += '"';
      rest.remove_prefix(1);
    }
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    if (!rest.empty() && rest.front() != separator_) {
      fail(linePath(), "there is text after a closing quotation mark");
    }
    return rest;
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
      if (names.size() <= kMostProblems) list += (list.empty() ? "" : ", ") + excerpt(c.name);
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
  return readCsvTable(readTextFile(path, kMaxBytes), path.string());
}

}  // namespace rotorbench
