#include <charconv>
#include <map>
#include <optional>

#include "sim/core/constants.h"
#include "sim/propulsion/rotor/polar_section.h"

namespace rotorbench {

namespace {

constexpr std::size_t kMostPoints = 2000;  // as the schema of Polar allows

std::vector<std::string_view> wordsOf(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r\f\v";
  std::vector<std::string_view> words;
  for (std::size_t from = line.find_first_not_of(kBlank); from != std::string_view::npos;) {
    const std::size_t to = std::min(line.find_first_of(kBlank, from), line.size());
    words.push_back(line.substr(from, to - from));
    from = line.find_first_not_of(kBlank, to);
  }
  return words;
}

std::optional<double> numberOf(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return {};
  return value;
}

bool sameName(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

/// Goes through the lines of one file and knows where it is.
class Reader {
 public:
  Reader(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  Polar read() {
    Polar polar;
    while (next()) {
      if (columns_.empty()) {
        readHeader();
      } else {
        readPoint();
      }
    }
    if (columns_.empty()) {
      fail({}, "no table of a polar is found", "a line that names the columns alpha, CL and CD");
    }
    if (!reynolds_) {
      fail({}, "the Reynolds number is missing", "a line such as \"Re = 0.100 e 6\"");
    }
    if (points_.size() < 2) fail({}, "the table has fewer than two angles", "two or more lines");
    polar.reynolds = *reynolds_;
    for (const auto& [alpha, point] : points_) polar.points.push_back(point);
    return polar;
  }

 private:
  struct Columns {
    std::optional<std::size_t> alpha, lift, drag;
    [[nodiscard]] bool empty() const { return !alpha || !lift || !drag; }
  };

  [[noreturn]] void fail(std::string path, std::string what, std::string allowed) const {
    throw InputError(source_, {{std::move(path), std::move(what), std::move(allowed)}});
  }
  [[nodiscard]] std::string here() const { return "line " + std::to_string(line_); }

  bool next() {
    if (text_.empty()) return false;
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    words_ = wordsOf(text_.substr(0, end));
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++line_;
    return true;
  }

  void readHeader() {
    for (std::size_t i = 0; i + 2 < words_.size(); ++i) {
      if (sameName(words_[i], "re") && words_[i + 1] == "=") readReynolds(i + 2);
    }
    if (words_.empty() || !sameName(words_.front(), "alpha")) return;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (sameName(words_[i], "alpha")) columns_.alpha = i;
      if (sameName(words_[i], "cl")) columns_.lift = i;
      if (sameName(words_[i], "cd")) columns_.drag = i;
    }
    if (columns_.empty()) {
      fail(here(), "the table lacks a column", "alpha, CL and CD must be there");
    }
  }

  /// "0.100 e 6", as XFOIL writes it with blanks, or a plain number.
  void readReynolds(std::size_t i) {
    auto value = numberOf(words_[i]);
    if (value && i + 2 < words_.size() && words_[i + 1] == "e") {
      const auto exponent = numberOf(words_[i + 2]);
      value = exponent ? std::optional(*value * std::pow(10.0, *exponent)) : std::nullopt;
    }
    if (!value || !(*value >= 1 && *value <= 1e9)) {
      fail(here(), "the Reynolds number cannot be read", "a number from 1 to 1e9");
    }
    reynolds_ = value;
  }

  void readPoint() {
    if (words_.empty() || words_.front().find_first_not_of('-') == std::string_view::npos) return;
    const double alpha = cell(*columns_.alpha, "alpha", -180, 180);
    const double lift = cell(*columns_.lift, "CL", -10, 10);
    const double drag = cell(*columns_.drag, "CD", 0, 10);
    if (!points_.emplace(alpha, PolarPoint{alpha * kDegree, lift, drag}).second) {
      fail(here(), "this angle of attack is given twice", "each angle once");
    }
    if (points_.size() > kMostPoints) fail(here(), "too many angles", "at most 2000");
  }

  [[nodiscard]] double cell(std::size_t column, const char* name, int low, int high) const {
    if (column >= words_.size()) {
      fail(here(), std::string("the number for ") + name + " is missing", "one number per column");
    }
    const auto value = numberOf(words_[column]);
    if (value && *value >= low && *value <= high) return *value;
    fail(here(), std::string(name) + " is \"" + std::string(words_[column].substr(0, 40)) + "\"",
         "a number from " + std::to_string(low) + " to " + std::to_string(high));
  }

  std::string_view text_;
  std::string source_;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
  Columns columns_;
  std::optional<double> reynolds_;
  std::map<double, PolarPoint> points_;
};

}  // namespace

Polar readXfoilPolar(std::string_view text, const std::string& source) {
  return Reader(text, source).read();
}

}  // namespace rotorbench
