// Numbers as the report prints them.
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace rotorbench::validation {

/// A fixed number of decimals; "-" for what does not exist.
inline std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

}  // namespace rotorbench::validation
