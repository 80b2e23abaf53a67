// Numbers as text, independent of the locale, and the check that text is UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rotorbench {

/// The shortest digits that read back as the same double: "0.1", "1e-09", "nan", "inf".
std::string numberText(double value);

/// `siValue` in a unit of size `factor`, with the fewest digits that convert back to it. Where more
/// than 15 digits would be needed only because the conversion rounds, the digits may be 2 ulp off.
std::string numberTextIn(double siValue, double factor);

/// The whole text as a finite decimal number ("1", "-2.5e-3"), else empty. No spaces, no
/// hexadecimal.
std::optional<double> readNumber(std::string_view text);

/// Position of the first byte that is not part of valid UTF-8, or empty.
std::optional<std::size_t> findInvalidUtf8(std::string_view text);

/// Text made fit for one line of a message: control characters and broken UTF-8 replaced, long text
/// cut.
std::string excerpt(std::string_view text, std::size_t most = 60);

/// The excerpt in double quotes.
std::string inQuotes(std::string_view text);

/// For a person: `digits` significant digits, C locale, no trailing zeros; "–" for NaN, the sign of
/// infinity.
std::string shortNumber(double value, int digits);

}  // namespace rotorbench
