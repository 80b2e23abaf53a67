// Units as people read them, with the signs of print instead of those a keyboard has. UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace rotorbench {

/// A unit as it is printed: "kg·m²" for "kg*m^2", "mΩ" for "mOhm", "°/s" for "deg/s", "µH" for
/// "uH", "T⁻¹" for "T^-1". Empty for plain numbers ("1" or nothing). What is no unit stays as it
/// is, so that a number may stand before the unit. canonicalUnit() is the way back.
std::string prettyUnit(std::string_view symbol);

/// A whole number as an exponent: "⁻⁹".
std::string superscript(int number);

}  // namespace rotorbench
