#include "sim/logs/text_lines.h"

#include <cstdint>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/io/csv_cells.h"
#include "sim/io/file.h"
#include "sim/io/gzip.h"
#include "sim/logs/propeller_blocks.h"

namespace rotorbench {

namespace {

void appendUtf8(std::string& out, std::uint32_t code) {
  const auto tail = [&](std::uint32_t bits) { out += static_cast<char>(0x80 | (bits & 0x3F)); };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | (code >> 6));
    tail(code);
  } else if (code < 0x10000) {
    out += static_cast<char>(0xE0 | (code >> 12));
    tail(code >> 6);
    tail(code);
  } else {
    out += static_cast<char>(0xF0 | (code >> 18));
    tail(code >> 12);
    tail(code >> 6);
    tail(code);
  }
}

/// Text of 16-bit units after the byte order mark; halves of pairs and an odd last byte become
/// U+FFFD.
std::string fromUtf16(std::string_view bytes, bool littleEndian) {
  constexpr std::uint32_t kReplacement = 0xFFFD;
  const auto unit = [&](std::size_t i) {
    const auto a = static_cast<unsigned char>(bytes[i]);
    const auto b = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<std::uint32_t>(littleEndian ? a | (b << 8) : b | (a << 8));
  };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    const bool high = code >= 0xD800 && code < 0xDC00;
    if (high && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    } else if (code >= 0xD800 && code < 0xE000) {
      code = kReplacement;
    }
    appendUtf8(out, code);
  }
  if (bytes.size() % 2 != 0) appendUtf8(out, kReplacement);
  return out;
}

std::string fromLatin1(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size());
  for (const char c : bytes) appendUtf8(out, static_cast<unsigned char>(c));
  return out;
}

std::string decoded(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xFF\xFE")) return fromUtf16(bytes.substr(2), true);
  if (bytes.starts_with("\xFE\xFF")) return fromUtf16(bytes.substr(2), false);
  return findInvalidUtf8(bytes) ? fromLatin1(bytes) : std::string(bytes);
}

void refuseWhatIsNoText(std::string_view bytes, const std::string& source) {
  if (isGzip(bytes) || bytes.starts_with("PK\x03\x04") || bytes.starts_with("BZh") ||
      bytes.starts_with("\xFD"
                        "7zXZ")) {
    refuse(source, "this file is compressed",
           "must be unpacked first (a spreadsheet: saved as CSV)");
  }
}

}  // namespace

TextLines TextLines::fromFile(const std::filesystem::path& path) {
  return fromBytes(readTextFile(path, kMaxCsvBytes), path.string());
}

TextLines TextLines::fromBytes(std::string_view bytes, std::string source) {
  if (bytes.size() > kMaxCsvBytes)
    refuse(source, "the file is too large", "must be at most 64 MiB");
  if (!isGzip(bytes)) return fromText(bytes, std::move(source));
  const std::string unpacked = unpackGzip(bytes, kMaxCsvBytes, source);
  return fromText(unpacked, std::move(source));
}

TextLines TextLines::fromText(std::string_view bytes, std::string source) {
  refuseWhatIsNoText(bytes, source);
  TextLines lines;
  lines.text_ = decoded(bytes);
  if (lines.text_.find('\0') != std::string::npos) {
    refuse(source, "this is not text: it holds zero bytes", "must be a table of text");
  }
  if (lines.text_.find_first_not_of(" \t\r\n") == std::string::npos) {
    refuse(source, "the file is empty", "must be a table of text");
  }
  lines.source_ = std::move(source);
  lines.split();
  if (auto blocks = tableOfPropellerBlocks(lines)) {
    lines.text_ = std::move(blocks->text);
    lines.notes_ = std::move(blocks->notes);
    lines.split();
  }
  return lines;
}

void TextLines::split() {
  starts_.clear();
  // "\r\n", "\n", and "\r" alone where there is no "\n" at all (old Macintosh).
  const char end = text_.find('\n') == std::string::npos ? '\r' : '\n';
  for (std::size_t at = 0; at < text_.size();) {
    starts_.push_back(at);
    const std::size_t next = text_.find(end, at);
    if (next == std::string::npos) break;
    at = next + 1;
  }
}

std::string_view TextLines::line(std::size_t index) const {
  const std::size_t begin = starts_[index];
  std::size_t end = index + 1 < starts_.size() ? starts_[index + 1] - 1 : text_.size();
  while (end > begin && (text_[end - 1] == '\r' || text_[end - 1] == '\n')) --end;
  return std::string_view(text_).substr(begin, end - begin);
}

bool TextLines::tooLong(std::size_t index) const {
  return line(index).size() > kMaxCsvLine;
}

}  // namespace rotorbench
