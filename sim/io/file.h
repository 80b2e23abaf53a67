// Whole files, read and written so that nothing half-done is ever seen.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace rotorbench {

/// The whole file. Throws InputError (source: the path) if it is missing, a directory, unreadable
/// or larger than maxBytes.
std::string readTextFile(const std::filesystem::path& path,
                         std::size_t maxBytes = std::size_t{16} << 20);

/// Writes a new file beside `path` and puts it in place of it only when all is on the disk:
/// whatever happens, `path` holds either the old or the new content. Throws InputError if the disk
/// is full, the folder missing ...
void writeFileAtomically(const std::filesystem::path& path, std::string_view text);

/// As above for content that is streamed.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

}  // namespace rotorbench
