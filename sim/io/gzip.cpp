#define ZLIB_CONST  // zlib reads from constant memory
#include "sim/io/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "sim/core/error.h"

namespace rotorbench {

namespace {

constexpr int kGzipOnly = 16 + MAX_WBITS;  // as inflateInit2 wants it said
constexpr std::size_t kPiece = std::size_t{1} << 16;

/// A stream of zlib, closed at the end.
class Inflater {
 public:
  explicit Inflater(std::string_view bytes) : bytes_(bytes) {
    ready_ = inflateInit2(&stream_, kGzipOnly) == Z_OK;
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  [[nodiscard]] bool ready() const { return ready_; }

  /// Appends the next piece; the code of zlib.
  int next(std::string& text) {
    constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
    const std::size_t offered = std::min(bytes_.size(), kMost);
    stream_.next_in = reinterpret_cast<const Bytef*>(bytes_.data());
    stream_.avail_in = static_cast<uInt>(offered);
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    stream_.next_out = reinterpret_cast<Bytef*>(text.data() + before);
    stream_.avail_out = kPiece;
    const int code = inflate(&stream_, Z_NO_FLUSH);
    text.resize(before + kPiece - stream_.avail_out);
    bytes_.remove_prefix(offered - stream_.avail_in);
    return code;
  }

  /// After the end of a member: true, and ready for it, if another one follows.
  bool nextMember() { return isGzip(bytes_) && inflateReset(&stream_) == Z_OK; }

 private:
  std::string_view bytes_;
  z_stream stream_{};
  bool ready_ = false;
};

}  // namespace

bool isGzip(std::string_view bytes) {
  return bytes.starts_with("\x1F\x8B");
}

std::string unpackGzip(std::string_view bytes, std::size_t maxBytes, const std::string& source) {
  Inflater inflater(bytes);
  if (!inflater.ready()) refuse(source, "the file cannot be unpacked: out of memory");
  std::string text;
  while (true) {
    const int code = inflater.next(text);
    if (text.size() > maxBytes) {
      refuse(source, "the compressed file holds too much",
             "must be at most " + std::to_string(maxBytes >> 20) + " MiB when unpacked");
    }
    if (code == Z_STREAM_END) {
      if (!inflater.nextMember()) return text;
    } else if (code == Z_BUF_ERROR) {
      refuse(source, "the compressed file is cut off", "must be the whole gzip file");
    } else if (code != Z_OK) {
      refuse(source, "the compressed file is damaged", "must be an unharmed gzip file");
    }
  }
}

}  // namespace rotorbench
