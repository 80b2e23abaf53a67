// Files compressed by gzip (RFC 1952), unpacked by zlib.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rotorbench {

/// True if the bytes begin as a gzip file does.
bool isGzip(std::string_view bytes);

/// What the members of a gzip file hold, one after the other. Throws InputError with this source if
/// the file is cut off, damaged, or holds more than maxBytes; no more than that is ever unpacked.
std::string unpackGzip(std::string_view bytes, std::size_t maxBytes, const std::string& source);

}  // namespace rotorbench
