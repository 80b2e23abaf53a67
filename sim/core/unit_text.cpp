#include "sim/core/unit_text.h"

#include <array>
#include <charconv>

#include "sim/core/units.h"

namespace rotorbench {

namespace {

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// One word of a unit, a prefix with it.
std::string prettyWord(std::string_view word) {
  if (word.ends_with("Ohm")) return std::string(word.substr(0, word.size() - 3)) + "Ω";
  // Of an angle, or of a temperature.
  if (word == "deg" || word == "degC" || word == "degF") return "°" + std::string(word.substr(3));
  const bool micro = word.size() > 1 && word.front() == 'u' && findUnit(word.substr(1)) != nullptr;
  return micro ? "µ" + std::string(word.substr(1)) : std::string(word);
}

}  // namespace

std::string superscript(int number) {
  static constexpr std::array<std::string_view, 10> kDigits{"⁰", "¹", "²", "³", "⁴",
                                                            "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number))
    text += c == '-' ? "⁻" : kDigits.at(static_cast<std::size_t>(c - '0'));
  return text;
}

std::string prettyUnit(std::string_view symbol) {
  if (symbol == "1") return {};
  std::string text;
  while (!symbol.empty()) {
    std::size_t length = 1;
    if (isLetter(symbol.front())) {
      while (length < symbol.size() && isLetter(symbol[length])) ++length;
      text += prettyWord(symbol.substr(0, length));
    } else if (int exponent = 0; symbol.front() == '^') {
      const char* digits = symbol.data() + 1;
      const auto end = std::from_chars(digits, symbol.data() + symbol.size(), exponent).ptr;
      text += end == digits ? "^" : superscript(exponent);
      length += static_cast<std::size_t>(end - digits);
    } else {
      text += symbol.front() == '*' ? "·" : std::string(1, symbol.front());
    }
    symbol.remove_prefix(length);
  }
  return text;
}

}  // namespace rotorbench
