#include "sim/io/label_width.h"

#include <string_view>

namespace rotorbench {

namespace {

constexpr double kBoldFactor = 1.17;
constexpr double kNarrow = 0.43, kUsual = 0.65, kCapital = 0.79, kWide = 1.0;  // em

bool startsCharacter(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
}

/// Of the character that starts with this byte of UTF-8.
double emWidth(char c) {
  constexpr std::string_view narrow = " !'(),-./:;I[]fijlrt|";
  constexpr std::string_view wide = "%+<=>@MW^mw~#&";
  if (static_cast<unsigned char>(c) >= 0x80) return kWide;
  if (narrow.find(c) != narrow.npos) return kNarrow;
  if (wide.find(c) != wide.npos) return kWide;
  return c >= 'A' && c <= 'Z' ? kCapital : kUsual;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

/// As much of the beginning of `word` as has room, at least one character.
std::size_t fittingBytes(const std::string& word, double room, double fontSize, bool bold) {
  std::size_t fits = 0;
  for (std::size_t end = 1; end <= word.size(); ++end) {
    if (end < word.size() && !startsCharacter(word[end])) continue;
    if (fits > 0 && labelWidth(word.substr(0, end), fontSize, bold) > room) break;
    fits = end;
  }
  return fits;
}

}  // namespace

double labelWidth(const std::string& text, double fontSize, bool bold) {
  double width = 0;
  for (const char c : text)
    if (startsCharacter(c)) width += emWidth(c);
  return width * fontSize * (bold ? kBoldFactor : 1);
}

std::vector<std::string> wrappedLabel(const std::string& text, double room, double fontSize,
                                      bool bold) {
  std::vector<std::string> lines(1);
  for (std::string word : wordsOf(text)) {
    const std::string longer = lines.back().empty() ? word : lines.back() + ' ' + word;
    if (labelWidth(longer, fontSize, bold) <= room) {
      lines.back() = longer;
      continue;
    }
    if (!lines.back().empty()) lines.emplace_back();
    while (labelWidth(word, fontSize, bold) > room) {
      const std::size_t fits = fittingBytes(word, room, fontSize, bold);
      if (fits == word.size()) break;
      lines.back() = word.substr(0, fits);
      lines.emplace_back();
      word.erase(0, fits);
    }
    lines.back() = word;
  }
  return lines;
}

}  // namespace rotorbench
