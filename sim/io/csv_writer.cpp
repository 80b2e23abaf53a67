#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <ostream>

#include "sim/io/csv.h"
#include "sim/io/csv_quoting.h"

namespace rotorbench {

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::size_t kLongestNumber = 32;

void writeHeader(std::ostream& out, const Recording& recording,
                 const std::vector<std::size_t>& channels) {
  std::string line;
  for (const std::size_t c : channels) {
    const Channel& channel = recording.channels()[c];
    if (!line.empty()) line += ',';
    line += csvCell(channel.name + " [" + channel.unit + "]");
  }
  line += '\n';
  out.write(line.data(), static_cast<std::streamsize>(line.size()));
}

class RowBuffer {
 public:
  explicit RowBuffer(std::ostream& out) : out_(out), buffer_(kBufferBytes, '\0') {}

  void add(double value, char after) {
    if (kBufferBytes - used_ <= kLongestNumber) flush();
    char* at = buffer_.data() + used_;
    // to_chars writes the sign of a NaN, which means nothing here.
    at = value != value ? std::copy_n("nan", 3, at)
                        : std::to_chars(at, at + kLongestNumber, value).ptr;
    *at++ = after;
    used_ = static_cast<std::size_t>(at - buffer_.data());
  }

  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

 private:
  std::ostream& out_;
  std::string buffer_;
  std::size_t used_ = 0;
};

}  // namespace

std::string csvCell(const std::string& text) {
  if (text.find_first_of(",;\"\n\r\t#") == std::string::npos) return text;
  std::string quoted(1, '"');
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  quoted += '"';
  return quoted;
}

void writeCsv(std::ostream& out, const Recording& recording, const CsvSelection& selection) {
  std::vector<std::size_t> channels = selection.channels;
  if (channels.empty()) {
    channels.resize(recording.channels().size());
    std::iota(channels.begin(), channels.end(), std::size_t{0});
  }
  if (channels.empty()) return;
  writeHeader(out, recording, channels);

  const std::size_t count = recording.rows();
  std::size_t row = selection.from ? recording.lowerBound(*selection.from) : 0;
  RowBuffer buffer(out);
  std::vector<const double*> columns(channels.size());
  while (row < count && out) {
    std::size_t length = count - row;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const std::span<const double> piece = recording.column(channels[i], row);
      columns[i] = piece.data();
      length = std::min(length, piece.size());
    }
    for (std::size_t k = 0; k < length; ++k) {
      if (selection.to && recording.value(0, row + k) > *selection.to) return buffer.flush();
      for (std::size_t i = 0; i + 1 < columns.size(); ++i) buffer.add(columns[i][k], ',');
      buffer.add(columns.back()[k], '\n');
    }
    row += length;
  }
  buffer.flush();
}

}  // namespace rotorbench
