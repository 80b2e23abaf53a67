#include "sim/core/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "sim/core/units.h"

namespace rotorbench {

std::string numberText(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

namespace {

std::string withDigits(double value, int digits) {
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::scientific, digits - 1)
                       .ptr;
  return {buffer.data(), end};
}

double ulpsApart(double a, double b) {
  const double ulp = std::nextafter(std::abs(b), INFINITY) - std::abs(b);
  return std::abs(a - b) / ulp;
}

}  // namespace

std::string numberTextIn(double siValue, double factor) {
  if (factor == 1 || siValue == 0 || !std::isfinite(siValue)) return numberText(siValue);
  const double value = fromSi(siValue, factor);
  if (!std::isfinite(value)) return numberText(value);
  std::optional<double> close;
  for (int digits = 1; digits <= 17; ++digits) {
    const double rounded = *readNumber(withDigits(value, digits));
    const double back = toSi(rounded, factor);
    if (back == siValue && (digits <= 15 || !close)) return numberText(rounded);
    if (digits <= 15 && !close && ulpsApart(back, siValue) <= 2) close = rounded;
  }
  return numberText(close.value_or(value));
}

std::optional<double> readNumber(std::string_view text) {
  if (text.empty()) return {};
  const std::size_t first = text[0] == '-' ? 1 : 0;
  if (first == text.size() || ((text[first] < '0' || text[first] > '9') && text[first] != '.')) {
    return {};  // from_chars would take "inf" and "nan"
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

std::optional<std::size_t> findInvalidUtf8(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  for (std::size_t i = 0; i < text.size();) {
    const unsigned lead = byte(i);
    if (lead < 0x80) {
      ++i;
      continue;
    }
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || i + length > text.size()) return i;
    std::uint32_t code = lead & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k) {
      if ((byte(i + k) & 0xC0) != 0x80) return i;
      code = (code << 6) | (byte(i + k) & 0x3FU);
    }
    const bool overlong = code < (length == 3 ? 0x800U : length == 4 ? 0x10000U : 0x80U);
    if (overlong || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF) return i;
    i += length;
  }
  return {};
}

std::string excerpt(std::string_view text, std::size_t most) {
  std::string out;
  std::size_t end = std::min(text.size(), most);
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
    --end;
  }
  const std::string_view part = text.substr(0, end);
  const std::size_t valid = findInvalidUtf8(part).value_or(part.size());
  for (const char c : part.substr(0, valid)) {
    out += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  }
  for (const char c : part.substr(valid)) {
    out += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E ? '?' : c;
  }
  if (end < text.size()) out += "...";
  return out;
}

std::string inQuotes(std::string_view text) {
  std::string out(1, '"');
  out += excerpt(text);
  out += '"';
  return out;
}

std::string shortNumber(double value, int digits) {
  if (std::isnan(value)) return "\u2013";
  if (std::isinf(value)) return value > 0 ? "\u221e" : "-\u221e";
  // Below and above these powers of ten digits are easier to read with an exponent.
  constexpr int kLeastFixed = -4, kMostFixed = 6;
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

}  // namespace rotorbench
