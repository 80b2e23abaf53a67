#include "sim/sizing/figure.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "sim/core/units.h"

namespace rotorbench {

namespace {

/// Below and above these powers of ten digits are easier to read with an exponent.
constexpr int kLeastFixed = -4, kMostFixed = 6;

}  // namespace

const Figure& FigureSheet::at(const std::string& key) const {
  for (const auto& figure : figures) {
    if (figure.key == key) return figure;
  }
  throw std::out_of_range("no figure " + key);
}

std::string shortNumber(double value, int digits) {
  if (std::isnan(value)) return "\u2013";
  if (std::isinf(value)) return value > 0 ? "\u221e" : "-\u221e";
  const int power =
      value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-12));
  std::array<char, 64> text{};
  const bool fixed = power >= kLeastFixed && power <= kMostFixed;
  const auto end = fixed ? std::to_chars(text.data(), text.data() + text.size(), value,
                                         std::chars_format::fixed, std::max(0, digits - 1 - power))
                         : std::to_chars(text.data(), text.data() + text.size(), value,
                                         std::chars_format::scientific, digits - 1);
  std::string number(text.data(), end.ptr);
  if (fixed && number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
  }
  return number;
}

std::string figureNumber(const Figure& figure, int digits) {
  return shortNumber(fromSi(figure.value, unitFactor(figure.unit, figure.shownUnit)), digits);
}

std::string figureText(const Figure& figure, int digits) {
  const std::string number = figureNumber(figure, digits);
  if (std::isnan(figure.value) || figure.shownUnit == "1") return number;
  return number + " " + figure.shownUnit;
}

}  // namespace rotorbench
