// What was found amiss in a table of text: how often, where first, and how a sentence says so.
#pragma once

#include <string>
#include <string_view>

#include "sim/core/number_text.h"

namespace rotorbench {

/// How often something was found, and where first (line number from 1, 0: never).
struct Occurrences {
  std::size_t count = 0;
  std::size_t firstLine = 0;
  std::string example;  ///< of the first

  void add(std::size_t line, std::string_view text = {}) {
    if (count++ == 0) firstLine = line, example = text;
  }
};

/// "1 row has", "3 rows have".
inline std::string times(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// " (first in line 7: "n/a")".
inline std::string firstAt(const Occurrences& found) {
  std::string text = " (first in line " + std::to_string(found.firstLine);
  if (!found.example.empty()) text += ": " + inQuotes(found.example);
  return text + ")";
}

}  // namespace rotorbench
