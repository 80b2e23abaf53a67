// Minima and maxima of one channel over any range of rows without reading those rows again: a
// pyramid of block extremes (blocks of 64 rows, each further level 8 times as long) that grows with
// the recording.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "sim/core/recording.h"

namespace rotorbench {

/// Smallest and largest value of some rows and the first rows that hold them. Values that are not
/// finite count as missing.
struct Extremes {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  std::uint32_t rowOfMin = 0;
  std::uint32_t rowOfMax = 0;
  [[nodiscard]] bool empty() const { return min > max; }
  /// Adds the extremes of later rows.
  void merge(const Extremes& later);
};

/// Used by one thread; the recording may grow meanwhile.
class ColumnSummary {
 public:
  enum class Values {
    All,
    Positive,  ///< zero and less count as missing: for logarithmic axes
  };

  ColumnSummary(std::shared_ptr<const Recording> recording, std::size_t channel, Values values);

  /// Takes in at most `mostRows` further published rows; returns how many it took.
  std::size_t extend(std::size_t mostRows);
  /// Rows taken in so far.
  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Precondition: first <= last <= rows().
  [[nodiscard]] Extremes extremes(std::size_t first, std::size_t last) const;
  /// A value as it counts here: NaN where missing.
  [[nodiscard]] double value(std::size_t row) const;

 private:
  [[nodiscard]] Extremes scan(std::size_t first, std::size_t last) const;
  void addBlock(const Extremes& block, std::size_t level);

  std::shared_ptr<const Recording> recording_;
  std::size_t channel_;
  Values values_;
  std::size_t rows_ = 0;
  std::vector<std::vector<Extremes>> levels_;
};

/// The summaries of all channels on show, shared by all panes. Forgets those of recordings that are
/// gone from everywhere else.
class SummaryCache {
 public:
  ColumnSummary& summary(const std::shared_ptr<const Recording>& recording, std::size_t channel,
                         ColumnSummary::Values values);
  void forget(const Recording* recording);

 private:
  using Key = std::tuple<const Recording*, std::size_t, ColumnSummary::Values>;
  std::map<Key, std::unique_ptr<ColumnSummary>> summaries_;
};

}  // namespace rotorbench
