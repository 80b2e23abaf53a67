// Damages valid text files in the ways disks, networks, editors and hasty people do; the same seed
// damages the same way everywhere.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "sim/core/random.h"

namespace rotorbench {

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed, "mutator") {}

  /// The text with one to four random changes.
  std::string mutate(std::string text) {
    for (std::size_t n = 1 + below(4); n > 0; --n) change(text);
    return text;
  }

  /// A whole number in [0, n); 0 where n is 0.
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_.bits() % n; }

 private:
  static constexpr std::size_t kLongest = 200'000;  // repeated doubling must not run away

  void change(std::string& text) {
    switch (below(12)) {
      case 0:
        return flipBit(text);
      case 1:
        return insertByte(text);
      case 2:
        return void(text.erase(below(text.size()), 1 + below(8)));
      case 3:
        return swapTokens(text);
      case 4:
        return void(text.resize(below(text.size() + 1)));
      case 5:
      case 6:
        return replaceNumber(text);
      case 7:
        return doubleBlock(text);
      case 8:
        return nest(text);
      case 9:
        return insertToken(text);
      case 10:
        return changeLetter(text);
      default:
        return replaceToken(text);
    }
  }

  void flipBit(std::string& text) {
    if (text.empty()) return;
    char& c = text[below(text.size())];
    c = static_cast<char>(static_cast<unsigned char>(c) ^ (1U << below(8)));
  }

  void insertByte(std::string& text) {
    text.insert(text.begin() + static_cast<std::ptrdiff_t>(below(text.size() + 1)),
                static_cast<char>(below(256)));
  }

  void swapTokens(std::string& text) {
    auto a = token(text);
    auto b = token(text);
    if (a.at > b.at) std::swap(a, b);
    if (a.at + a.length > b.at) return;
    const std::string first = text.substr(a.at, a.length);
    const std::string second = text.substr(b.at, b.length);
    text.replace(b.at, b.length, first);
    text.replace(a.at, a.length, second);
  }

  void replaceNumber(std::string& text) {
    const Span span = number(text);
    if (span.length > 0) text.replace(span.at, span.length, pick(kNumbers));
  }

  void doubleBlock(std::string& text) {
    if (text.empty() || text.size() > kLongest) return;
    const std::size_t from = below(text.size());
    const std::size_t length = 1 + below(std::min<std::size_t>(400, text.size() - from));
    const std::string block = text.substr(from, length);
    text.insert(below(2) == 0 ? from : below(text.size()), block);
  }

  void nest(std::string& text) {
    const std::size_t depth = 1 + below(200);
    const char* const opening = below(2) == 0 ? "[" : "{\"a\":";
    std::string deep;
    for (std::size_t i = 0; i < depth; ++i) deep += opening;
    if (below(2) == 0) deep.append("1").append(depth, *opening == '[' ? ']' : '}');
    const Span span = token(text);
    text.replace(span.at, span.length, deep);
  }

  void insertToken(std::string& text) { text.insert(below(text.size() + 1), pick(kTokens)); }

  void replaceToken(std::string& text) {
    const Span span = token(text);
    text.replace(span.at, span.length, pick(kTokens));
  }

  /// A slip of the fingers in a word.
  void changeLetter(std::string& text) {
    for (int attempt = 0; attempt < 20 && !text.empty(); ++attempt) {
      char& c = text[below(text.size())];
      if (c < 'a' || c > 'z') continue;
      c = static_cast<char>('a' + below(26));
      return;
    }
  }

  struct Span {
    std::size_t at, length;
  };

  /// A word, string, number or sign somewhere in the text.
  Span token(const std::string& text) {
    if (text.empty()) return {0, 0};
    std::size_t at = below(text.size());
    while (at > 0 && isWord(text[at]) && isWord(text[at - 1])) --at;
    std::size_t end = at + 1;
    while (end < text.size() && isWord(text[at]) && isWord(text[end])) ++end;
    return {at, end - at};
  }

  Span number(const std::string& text) {
    for (int attempt = 0; attempt < 50; ++attempt) {
      const Span span = token(text);
      if (span.length > 0 && text[span.at] >= '0' && text[span.at] <= '9') return span;
    }
    return {0, 0};
  }

  static bool isWord(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
           c == '-' || c == '+' || c == '_' || c == '"';
  }

  template <std::size_t N>
  std::string pick(const std::array<const char*, N>& list) {
    return list[below(N)];
  }

  static constexpr std::array<const char*, 23> kNumbers{"NaN",
                                                        "Infinity",
                                                        "-Infinity",
                                                        "nan",
                                                        "1e999",
                                                        "-1e999",
                                                        "1e308",
                                                        "-1e308",
                                                        "1e-999",
                                                        "5e-324",
                                                        "-0",
                                                        "-0.0",
                                                        "0",
                                                        "-1",
                                                        "1.5",
                                                        "9223372036854775807",
                                                        "9223372036854775808",
                                                        "18446744073709551616",
                                                        "9007199254740993",
                                                        "0x10",
                                                        "1e",
                                                        "01",
                                                        "\"9.45 in\""};
  static constexpr std::array<const char*, 24> kTokens{
      "{",          "}",        "[",    "]",           ",",
      ":",          "\"",       "null", "true",        "false",
      "{}",         "[]",       "\"\"", "\"type\"",    "\"rotorbench\"",
      "-",          ".",        "\\",   "\\u0000",     "\\ud800",
      "\"1/2 ft\"", "\"3 kg\"", "\n",   "\xEF\xBB\xBF"};

  RandomStream random_;
};

}  // namespace rotorbench
