// What a run leaves behind: columns of doubles that grow row by row. One writer; any number of
// readers without locks, who see the rows published so far and never a row in the making.
//
// Storage: chunks of kChunkRows rows, one padded column per channel inside a chunk (the pad keeps
// columns off the same cache set); chunks never move, so a reader may keep pointers into published
// rows. Rows are collected in groups of kGroupRows and written column by column, a whole cache line
// of each at a time.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/channel.h"

namespace rotorbench {

/// What happens when the memory bound is reached.
enum class WhenFull {
  Stop,  ///< append() returns false: the run ends with a clear message, the recording is kept
  Thin,  ///< each time half of the room left is used, only every second further row is kept
};

struct RecordingLimits {
  std::size_t maxBytes = std::size_t{2} << 30;
  WhenFull whenFull = WhenFull::Thin;
};

class Recording {
 public:
  static constexpr std::size_t kChunkRows = 4096;
  static constexpr std::size_t kGroupRows = 8;  ///< doubles of a cache line; divides kChunkRows

  /// `channels[0]` is the abscissa (time in s for a run), its values never decrease.
  explicit Recording(std::vector<Channel> channels, RecordingLimits limits = {});
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  // Writer side (one thread).
  /// Adds one row (as many values as channels) without publishing it. False if the bound is reached
  /// and rows are not thinned. No heap use but for a new chunk every kChunkRows rows.
  bool append(std::span<const double> row);
  /// Makes all appended rows visible to readers.
  void publish();
  /// After this no row is added.
  void finish();

  // Reader side (any thread).
  [[nodiscard]] const std::vector<Channel>& channels() const { return channels_; }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view channelName) const;
  /// Published rows.
  [[nodiscard]] std::size_t rows() const { return published_.load(std::memory_order_acquire); }
  [[nodiscard]] bool finished() const { return finished_.load(std::memory_order_acquire); }
  /// Precondition: channel < channels().size(), row < rows().
  [[nodiscard]] double value(std::size_t channel, std::size_t row) const;
  /// Published values of a channel from `row` to the end of its chunk (or of the published rows).
  /// Loop: for (row = a; row < b; row += piece.size()) piece = column(c, row).
  [[nodiscard]] std::span<const double> column(std::size_t channel, std::size_t row) const;
  /// First row in [0, rows()) whose abscissa is not less than t, else rows(). Binary search.
  [[nodiscard]] std::size_t lowerBound(double t) const;
  /// Value of a channel at abscissa t: the last sample not after t (the first one before the
  /// start).
  [[nodiscard]] double sampleAt(std::size_t channel, double t) const;
  /// Kept rows per offered row at the end: 1 where nothing was thinned, 2 for every second, ...
  [[nodiscard]] std::size_t stride() const { return stride_.load(std::memory_order_acquire); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// Makes sure that the chunk of the next row exists; false if there is no memory for it.
  bool provideChunk();
  /// Brings the collected rows into their columns.
  void writeGroup();

  std::vector<Channel> channels_;
  std::size_t columnStride_;
  std::size_t maxRows_;
  WhenFull whenFull_;
  std::unique_ptr<std::atomic<double*>[]>
      chunks_;                 // fixed directory: readers index it without a lock
  std::vector<double> group_;  // row after row; row r of the recording stands at r % kGroupRows
  std::size_t written_ = 0;    // rows in their columns; those up to appended_ are in group_
  std::size_t appended_ = 0;
  std::size_t offered_ = 0;
  std::size_t nextThinning_ = 0;
  std::atomic<std::size_t> published_{0};
  std::atomic<std::size_t> stride_{1};
  std::atomic<bool> finished_{false};
};

}  // namespace rotorbench
