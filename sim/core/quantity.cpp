// The reader of typed quantities: numbers with + - * / and parentheses, and one unit.
#include <cmath>

#include "sim/core/number_text.h"
#include "sim/core/units.h"

namespace rotorbench {

namespace {

constexpr std::size_t kLongestText = 200;

struct Fault {
  std::string what;
};

class QuantityReader {
 public:
  QuantityReader(std::string_view text, std::string_view unit) : text_(text), wanted_(unit) {}

  double read() {
    const double value = sum();
    skipSpaces();
    if (at_ < text_.size()) throw Fault{inQuotes(text_) + " is not a number with a unit"};
    return value;
  }

  /// The unit written in the text; empty if there is none.
  [[nodiscard]] const std::string& unit() const { return unit_; }

 private:
  double sum() {
    double value = product();
    while (true) {
      if (take('+')) {
        value += product();
      } else if (take('-')) {
        value -= product();
      } else {
        return value;
      }
    }
  }

  double product() {
    double value = factor();
    while (true) {
      if (take('*')) {
        value *= factor();
      } else if (take('/')) {
        const double divisor = factor();
        if (divisor == 0) throw Fault{inQuotes(text_) + " divides by zero"};
        value /= divisor;
      } else {
        return value;
      }
    }
  }

  double factor() {
    if (take('-')) return -factor();
    if (take('+')) return factor();
    double value = 0;
    if (take('(')) {
      value = sum();
      if (!take(')')) throw Fault{inQuotes(text_) + " lacks a closing parenthesis"};
    } else {
      value = number();
    }
    takeUnit();
    return value;
  }

  double number() {
    skipSpaces();
    const std::size_t start = at_;
    std::string digits;
    int separators = 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '.' || c == ',') {
        ++separators;
        digits += '.';
      } else if (isDigit(c)) {
        digits += c;
      } else {
        break;
      }
      ++at_;
    }
    if (digits.empty() || separators > 1) {
      at_ = start;
      throw Fault{inQuotes(text_) + " is not a number"};
    }
    takeExponent(digits);
    const auto value = readNumber(digits);
    if (!value) throw Fault{inQuotes(text_) + " is not a finite number"};
    return *value;
  }

  void takeExponent(std::string& digits) {
    if (at_ >= text_.size() || (text_[at_] != 'e' && text_[at_] != 'E')) return;
    std::size_t next = at_ + 1;
    if (next < text_.size() && (text_[next] == '-' || text_[next] == '+')) ++next;
    if (next >= text_.size() || !isDigit(text_[next])) return;
    digits += 'e';
    if (text_[at_ + 1] == '-') digits += '-';
    for (at_ = next; at_ < text_.size() && isDigit(text_[at_]); ++at_) digits += text_[at_];
  }

  /// The longest text from here on that is a unit, if a unit begins here.
  void takeUnit() {
    skipSpaces();
    if (!unitBegins()) return;
    const std::string_view rest = text_.substr(at_);
    for (std::size_t length = rest.size(); length > 0; --length) {
      const std::string_view candidate = rest.substr(0, length);
      if (candidate.back() == ' ' || !endsHere(rest, length)) continue;
      if (findUnit(candidate) == nullptr && canonicalUnit(candidate) != wanted_) continue;
      if (!unit_.empty()) throw Fault{inQuotes(text_) + " has more than one unit"};
      unit_ = candidate;
      at_ += length;
      return;
    }
    throw Fault{inQuotes(text_) + " has the unknown unit " + excerpt(rest, 20)};
  }

  [[nodiscard]] bool unitBegins() const {
    if (at_ >= text_.size()) return false;
    const char c = text_[at_];
    const bool inverse = c == '1' && at_ + 1 < text_.size() && text_[at_ + 1] == '/';
    return inverse || isNamePart(c) || c == '"' || c == '\'';
  }

  /// A unit does not end inside a name or a power: "m" is not the unit of "mq" or "m^2".
  static bool endsHere(std::string_view rest, std::size_t length) {
    if (length == rest.size()) return true;
    const char next = rest[length];
    return !isNamePart(next) && next != '^' && !isDigit(next);
  }

  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  static bool isNamePart(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  }

  void skipSpaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }

  bool take(char c) {
    skipSpaces();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  std::string_view text_;
  std::string wanted_;
  std::size_t at_ = 0;
  std::string unit_;
};

std::string allowedUnits(std::string_view unit) {
  std::string list;
  for (const Unit* like : unitsLike(unit)) {
    if (like->symbol == "1") continue;
    if (!list.empty()) list += ", ";
    list += like->symbol;
  }
  if (unit == "1") return "must be a plain number or in " + list;
  return "must be a number in " + (list.empty() ? std::string(unit) : list);
}

}  // namespace

ParsedQuantity parseQuantity(std::string_view text, std::string_view unit,
                             std::string_view defaultUnit) {
  const std::string wanted = canonicalUnit(unit);
  const auto fail = [&](const std::string& what) {
    return ParsedQuantity{{}, what + "; " + allowedUnits(wanted)};
  };
  if (text.size() > kLongestText) return fail(inQuotes(text) + " is too long");
  if (text.find_first_not_of(" \t") == std::string_view::npos) return fail("there is no number");
  try {
    QuantityReader reader(text, wanted);
    const double number = reader.read();
    const std::string written = reader.unit().empty() ? std::string(defaultUnit) : reader.unit();
    if (!sameDimension(written, wanted)) {
      if (reader.unit().empty()) return fail(inQuotes(text) + " has no unit");
      return fail(inQuotes(text) + " is in " + canonicalUnit(written));
    }
    const double value = convertUnit(number, written, wanted);
    if (!std::isfinite(value)) return fail(inQuotes(text) + " is not a finite number");
    return {value, {}};
  } catch (const Fault& fault) {
    return fail(fault.what);
  }
}

}  // namespace rotorbench
