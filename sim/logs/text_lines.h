// A file of measurements as lines of UTF-8 text, whatever program wrote it: byte order marks,
// UTF-16 and the line ends of all systems are understood, bytes that are no UTF-8 are taken for
// Latin-1, gzip is unpacked, the blocks of a propeller table become one table (propeller_blocks.h).
// What cannot be a table of text (other compressed files, zero bytes) is refused with a sentence.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/error.h"

namespace rotorbench {

class TextLines {
 public:
  /// Throws InputError if the file cannot be read, is larger than 64 MiB (unpacked, too), or no
  /// text.
  static TextLines fromFile(const std::filesystem::path& path);
  /// `source` names the text in messages.
  static TextLines fromBytes(std::string_view bytes, std::string source);

  [[nodiscard]] const std::string& source() const { return source_; }
  /// Warnings about what could not be taken into the lines.
  [[nodiscard]] const std::vector<Problem>& notes() const { return notes_; }
  [[nodiscard]] std::size_t size() const { return starts_.size(); }
  /// Line `index` from 0, without its end. Precondition: index < size().
  [[nodiscard]] std::string_view line(std::size_t index) const;
  /// Longer than the limit of a line, 1 MiB.
  [[nodiscard]] bool tooLong(std::size_t index) const;

 private:
  static TextLines fromText(std::string_view bytes, std::string source);
  /// Finds where the lines begin.
  void split();

  std::string source_, text_;
  std::vector<std::size_t> starts_;
  std::vector<Problem> notes_;
};

}  // namespace rotorbench
