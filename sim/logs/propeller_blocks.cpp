#include "sim/logs/propeller_blocks.h"

#include <algorithm>

#include "sim/core/number_text.h"
#include "sim/io/csv_cells.h"
#include "sim/logs/occurrences.h"
#include "sim/logs/text_lines.h"

namespace rotorbench {

namespace {

constexpr std::string_view kHeading = "PROP RPM";
constexpr std::string_view kNoNumber = "NaN";

/// A piece of a line between blanks, and where it stands.
struct Token {
  std::string_view text;
  std::size_t begin = 0;
  /// Twice the column of its middle.
  [[nodiscard]] std::size_t middle() const { return 2 * begin + text.size(); }
};

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Pieces between blanks; what stands in parentheses is one piece.
std::vector<Token> tokensOf(std::string_view line) {
  std::vector<Token> tokens;
  for (std::size_t at = 0; at < line.size();) {
    if (isBlank(line[at])) {
      ++at;
      continue;
    }
    std::size_t end = line[at] == '(' ? line.find(')', at) : std::string_view::npos;
    if (end == std::string_view::npos) end = at;
    while (end < line.size() && !isBlank(line[end])) ++end;
    tokens.push_back({line.substr(at, end - at), at});
    at = end;
  }
  return tokens;
}

/// The cells of a row: "0.69-NaN" is a number and none; a cell without a number is empty.
std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (const Token& token : tokensOf(line)) {
    std::string_view text = token.text;
    for (std::size_t nan = text.find(kNoNumber); nan != std::string_view::npos;
         nan = text.find(kNoNumber)) {
      const std::size_t start = nan > 0 && text[nan - 1] == '-' ? nan - 1 : nan;
      if (start > 0) cells.push_back(text.substr(0, start));
      cells.emplace_back();
      text.remove_prefix(nan + kNoNumber.size());
    }
    if (!text.empty()) cells.push_back(text);
  }
  return cells;
}

bool isHeading(std::string_view line) {
  line = trimmedCell(line);
  return line.starts_with(kHeading) && trimmedCell(line.substr(kHeading.size())).starts_with('=');
}

bool beginsWithNumber(std::string_view line) {
  const std::vector<Token> tokens = tokensOf(line);
  return !tokens.empty() && readNumber(tokens.front().text);
}

bool isUnits(std::string_view line) {
  return line.find('(') != std::string_view::npos && !beginsWithNumber(line);
}

/// As the mapping knows them: "mph"; nothing for "-" and "(Adv Ratio)".
std::string_view unitIn(std::string_view token) {
  if (token.size() < 2 || token.front() != '(' || token.back() != ')') return {};
  token = trimmedCell(token.substr(1, token.size() - 2));
  return token.starts_with("Adv") ? std::string_view() : token;
}

/// "PROP RPM [rpm]", "V [mph]", "J" ... of a line of names and one of units, in their order or by
/// what stands below.
std::string namesOf(std::string_view names, std::string_view units) {
  const std::vector<Token> columns = tokensOf(names);
  const std::vector<Token> written = tokensOf(units);
  std::vector<std::string_view> of(columns.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    const auto apart = [&](const Token& column) {
      const std::size_t a = column.middle(), b = written[i].middle();
      return a > b ? a - b : b - a;
    };
    const std::size_t at =
        written.size() == columns.size()
            ? i
            : static_cast<std::size_t>(std::ranges::min_element(columns, {}, apart) -
                                       columns.begin());
    of[at] = unitIn(written[i].text);
  }
  std::string text = std::string(kHeading) + " [rpm]";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    text.append("\t").append(columns[i].text);
    if (!of[i].empty()) text.append(" [").append(of[i]).append("]");
  }
  return text;
}

class BlockReader {
 public:
  explicit BlockReader(const TextLines& lines) : lines_(lines) {}

  PropellerBlocks read(std::size_t firstHeading) {
    for (at_ = 0; at_ < firstHeading; ++at_) put(lines_.line(at_));
    while (at_ < lines_.size()) {
      readHeading();
      readNames();
      while (at_ < lines_.size() && !isHeading(lines_.line(at_))) put(rowOf(lines_.line(at_++)));
    }
    note(tooShort_, " fewer cells than there are columns");
    note(unsolved_, " no numbers but NaN beside the air speed");
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& what, const char* allowed) const {
    throw InputError(lines_.source(),
                     {{"line " + std::to_string(line + 1), what, std::string(allowed)}});
  }

  void put(std::string_view line) { result_.text.append(line).append("\n"); }

  void note(const Occurrences& found, const char* what) {
    if (found.count == 0) return;
    result_.notes.push_back(
        {{},
         times(found.count, "row of the propeller table has", "rows of the propeller table have") +
             what + firstAt(found),
         "left out",
         true});
  }

  void skipBlank() {
    for (; at_ < lines_.size() && trimmedCell(lines_.line(at_)).empty(); ++at_) put({});
  }

  /// At a line "PROP RPM = 5000".
  void readHeading() {
    const std::string_view line = lines_.line(at_);
    const std::string_view value = trimmedCell(line.substr(line.find('=') + 1));
    const auto speed = readNumber(value);
    if (!speed || !(*speed > 0)) {
      fail(at_, "the block of the propeller table has no speed: " + inQuotes(trimmedCell(line)),
           "must be a number above 0, as in PROP RPM = 5000");
    }
    speed_ = value;
    put({});
    heading_ = at_++;
  }

  void readNames() {
    skipBlank();
    if (at_ >= lines_.size() || isHeading(lines_.line(at_)) || beginsWithNumber(lines_.line(at_))) {
      fail(heading_, "the block of the propeller table has no names of columns",
           "must be followed by a line such as V J Pe Ct Cp PWR Torque Thrust");
    }
    const std::size_t line = at_++;
    const bool units = at_ < lines_.size() && isUnits(lines_.line(at_));
    const std::string names =
        namesOf(lines_.line(line), units ? lines_.line(at_) : std::string_view());
    if (names_.empty()) {
      names_ = names;
      columns_ = static_cast<std::size_t>(std::ranges::count(names, '\t'));
      put(names);
    } else if (names != names_) {
      fail(line, "the columns of this block differ from those of the first",
           "must be the same in all blocks of a propeller table");
    } else {
      put({});
    }
    if (units) {
      put({});
      ++at_;
    }
  }

  /// With its speed; empty if it is left out.
  std::string rowOf(std::string_view line) {
    const std::vector<std::string_view> cells = cellsOf(line);
    if (cells.empty()) return {};
    const auto filled = std::ranges::count_if(cells, [](auto cell) { return !cell.empty(); });
    if (cells.size() < columns_) {
      tooShort_.add(at_, excerpt(trimmedCell(line)));
      return {};
    }
    constexpr auto kAirSpeedAndAdvance = 2;
    if (filled <= kAirSpeedAndAdvance && columns_ > kAirSpeedAndAdvance) {
      unsolved_.add(at_);
      return {};
    }
    std::string row(speed_);
    for (const std::string_view cell : cells) row.append("\t").append(cell);
    return row;
  }

  const TextLines& lines_;
  PropellerBlocks result_;
  std::size_t at_ = 0;  ///< index of the next line
  std::size_t heading_ = 0, columns_ = 0;
  std::string_view speed_;
  std::string names_;
  Occurrences tooShort_, unsolved_;
};

}  // namespace

std::optional<PropellerBlocks> tableOfPropellerBlocks(const TextLines& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (isHeading(lines.line(i))) return BlockReader(lines).read(i);
  }
  return {};
}

std::optional<double> diameterInName(std::string_view name) {
  constexpr double kInch = 0.0254;
  const auto isPart = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
  for (std::size_t x = name.find('x'); x != std::string_view::npos; x = name.find('x', x + 1)) {
    std::size_t begin = x;
    while (begin > 0 && isPart(name[begin - 1])) --begin;
    const auto inches = readNumber(name.substr(begin, x - begin));
    if (!inches || x + 1 >= name.size() || !isPart(name[x + 1])) continue;
    if (*inches >= 1 && *inches <= 100) return *inches * kInch;
  }
  return {};
}

}  // namespace rotorbench
