#include "sim/core/recording.h"

#include <sys/mman.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace rotorbench {

namespace {

/// One cache line more per column: columns of 32 KiB exactly would all start in the same cache set.
constexpr std::size_t kPad = 8;

/// With less room than this, the stride doubles with each kept row: 62 doublings outlast any run.
constexpr std::size_t kLastRoom = 64;
constexpr std::size_t kLargestStride = std::size_t{1} << 62;

/// Chunks lie side by side in slabs of this many, large enough for huge pages: a fault and the
/// clearing of 4 KiB at a time would cost a quarter of a flight. Pages of a slab become memory
/// chunk by chunk.
constexpr std::size_t kSlabChunks = 8;
constexpr std::size_t kPage = 4096;
constexpr std::size_t kHugePage = std::size_t{2} << 20;

double* newSlab(std::size_t bytes) {
  const std::size_t page = bytes < kHugePage ? kPage : kHugePage;
  bytes = (bytes + page - 1) / page * page;
  void* memory = std::aligned_alloc(page, bytes);
#ifdef MADV_HUGEPAGE
  if (memory != nullptr && page == kHugePage) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  return static_cast<double*>(memory);
}

/// Asks the kernel for the pages of a chunk in one go, cheaper than one fault per page inside the
/// run; where it cannot, they come as they are touched.
void populate([[maybe_unused]] double* chunk, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_POPULATE_WRITE
  const std::size_t before = reinterpret_cast<std::uintptr_t>(chunk) % kPage;
  madvise(reinterpret_cast<char*>(chunk) - before, before + bytes, MADV_POPULATE_WRITE);
#endif
}

}  // namespace

Recording::Recording(std::vector<Channel> channels, RecordingLimits limits)
    : channels_(std::move(channels)),
      columnStride_(kChunkRows + kPad),
      maxRows_(0),
      whenFull_(limits.whenFull) {
  const std::size_t chunkBytes =
      std::max<std::size_t>(1, channels_.size()) * columnStride_ * sizeof(double);
  const std::size_t maxChunks = std::max<std::size_t>(1, limits.maxBytes / chunkBytes);
  maxRows_ = maxChunks * kChunkRows;
  nextThinning_ = maxRows_ / 2;
  chunks_ = std::make_unique<std::atomic<double*>[]>(maxChunks);
  group_.resize(kGroupRows * channels_.size());
}

Recording::~Recording() {
  for (std::size_t i = 0; i < maxRows_ / kChunkRows; i += kSlabChunks) {
    std::free(chunks_[i].load(std::memory_order_relaxed));
  }
}

bool Recording::append(std::span<const double> row) {
  assert(row.size() == channels_.size());
  if (finished_.load(std::memory_order_relaxed)) return false;
  const std::size_t stride = stride_.load(std::memory_order_relaxed);
  if ((offered_ & (stride - 1)) != 0) {  // the stride is a power of two
    ++offered_;
    return true;
  }
  if (appended_ == maxRows_) return whenFull_ == WhenFull::Thin;
  if (appended_ % kChunkRows == 0 && !provideChunk()) return false;
  std::copy(row.begin(), row.end(), group_.data() + appended_ % kGroupRows * row.size());
  ++appended_;
  if (appended_ % kGroupRows == 0) writeGroup();
  ++offered_;
  if (whenFull_ == WhenFull::Thin && appended_ >= nextThinning_) {
    const std::size_t room = maxRows_ - appended_;
    nextThinning_ = appended_ + (room > kLastRoom ? room / 2 : 1);
    if (stride < kLargestStride) stride_.store(2 * stride, std::memory_order_release);
  }
  return true;
}

bool Recording::provideChunk() {
  const std::size_t chunk = appended_ / kChunkRows;
  const std::size_t values = channels_.size() * columnStride_;
  double* data = nullptr;
  if (chunk % kSlabChunks == 0) {
    const std::size_t chunks = std::min(kSlabChunks, maxRows_ / kChunkRows - chunk);
    data = newSlab(chunks * values * sizeof(double));
    if (data == nullptr) return false;
  } else {
    data = chunks_[chunk - 1].load(std::memory_order_relaxed) + values;
  }
  populate(data, values * sizeof(double));
  chunks_[chunk].store(data, std::memory_order_release);
  return true;
}

void Recording::writeGroup() {
  if (written_ == appended_) return;
  const std::size_t columns = channels_.size();
  double* to =
      chunks_[written_ / kChunkRows].load(std::memory_order_relaxed) + written_ % kChunkRows;
  const double* from = group_.data() + written_ % kGroupRows * columns;
  const std::size_t rows = appended_ - written_;
  if (rows == kGroupRows) {  // the usual case, with a loop the compiler can unroll
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t r = 0; r < kGroupRows; ++r)
        to[c * columnStride_ + r] = from[r * columns + c];
    }
  } else {
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t r = 0; r < rows; ++r) to[c * columnStride_ + r] = from[r * columns + c];
    }
  }
  written_ = appended_;
}

void Recording::publish() {
  writeGroup();
  published_.store(appended_, std::memory_order_release);
}

void Recording::finish() {
  publish();
  finished_.store(true, std::memory_order_release);
}

std::optional<std::size_t> Recording::find(std::string_view channelName) const {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (channels_[i].name == channelName) return i;
  }
  return {};
}

double Recording::value(std::size_t channel, std::size_t row) const {
  const double* data = chunks_[row / kChunkRows].load(std::memory_order_acquire);
  return data[channel * columnStride_ + row % kChunkRows];
}

std::span<const double> Recording::column(std::size_t channel, std::size_t row) const {
  const std::size_t end = std::min(rows(), (row / kChunkRows + 1) * kChunkRows);
  if (row >= end) return {};
  const double* data = chunks_[row / kChunkRows].load(std::memory_order_acquire);
  return {data + channel * columnStride_ + row % kChunkRows, end - row};
}

namespace {

/// First row in [0, count) for which `before` is false.
template <class Before>
std::size_t partition(std::size_t count, Before before) {
  std::size_t low = 0;
  while (count > 0) {
    const std::size_t half = count / 2;
    if (before(low + half)) {
      low += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  return low;
}

}  // namespace

std::size_t Recording::lowerBound(double t) const {
  return partition(rows(), [&](std::size_t row) { return value(0, row) < t; });
}

double Recording::sampleAt(std::size_t channel, double t) const {
  const std::size_t count = rows();
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t after = partition(count, [&](std::size_t row) { return value(0, row) <= t; });
  return value(channel, after == 0 ? 0 : after - 1);
}

std::size_t Recording::bytes() const {
  std::size_t chunks = 0;
  while (chunks < maxRows_ / kChunkRows &&
         chunks_[chunks].load(std::memory_order_acquire) != nullptr) {
    ++chunks;
  }
  return chunks * channels_.size() * columnStride_ * sizeof(double);
}

}  // namespace rotorbench
