// Room that text takes in a picture whose reader brings the font: widths of DejaVu Sans, the widest
// of the usual sans-serif faces, rounded up, so that a text fits with any of them.
#pragma once

#include <string>
#include <vector>

namespace rotorbench {

/// Most width of UTF-8 text, in the unit of the font's size.
double labelWidth(const std::string& text, double fontSize, bool bold = false);

/// The text in lines no wider than `room`, broken between words and, where a word is wider by
/// itself, inside it. At least one line, which may be empty.
std::vector<std::string> wrappedLabel(const std::string& text, double room, double fontSize,
                                      bool bold = false);

}  // namespace rotorbench
