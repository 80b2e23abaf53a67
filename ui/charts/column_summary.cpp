#include "ui/charts/column_summary.h"

#include <algorithm>
#include <cmath>

namespace rotorbench {
namespace {

constexpr std::size_t kBlockRows = 64;
constexpr std::size_t kFanOut = 8;
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

double counted(double v, bool positiveOnly) {
  // v - v is 0 for finite values only.
  const bool counts = (v - v == 0.0) && (!positiveOnly || v > 0.0);
  return counts ? v : kMissing;
}

/// Comparisons with NaN are false, so missing values fall through.
template <bool kPositiveOnly>
void scanPiece(std::span<const double> piece, std::size_t firstRow, Extremes& extremes) {
  double low = extremes.min;
  double high = extremes.max;
  for (const double raw : piece) {
    const double v = counted(raw, kPositiveOnly);
    low = v < low ? v : low;
    high = v > high ? v : high;
  }
  const auto rowOf = [&](double wanted) {
    const auto at = std::find(piece.begin(), piece.end(), wanted);
    return static_cast<std::uint32_t>(firstRow + static_cast<std::size_t>(at - piece.begin()));
  };
  if (low < extremes.min) extremes.rowOfMin = rowOf(low);
  if (high > extremes.max) extremes.rowOfMax = rowOf(high);
  extremes.min = low;
  extremes.max = high;
}

}  // namespace

void Extremes::merge(const Extremes& later) {
  if (later.min < min) {
    min = later.min;
    rowOfMin = later.rowOfMin;
  }
  if (later.max > max) {
    max = later.max;
    rowOfMax = later.rowOfMax;
  }
}

ColumnSummary::ColumnSummary(std::shared_ptr<const Recording> recording, std::size_t channel,
                             Values values)
    : recording_(std::move(recording)), channel_(channel), values_(values) {}

double ColumnSummary::value(std::size_t row) const {
  return counted(recording_->value(channel_, row), values_ == Values::Positive);
}

Extremes ColumnSummary::scan(std::size_t first, std::size_t last) const {
  Extremes extremes;
  for (std::size_t row = first; row < last;) {
    auto piece = recording_->column(channel_, row);
    piece = piece.first(std::min(piece.size(), last - row));
    if (values_ == Values::Positive) {
      scanPiece<true>(piece, row, extremes);
    } else {
      scanPiece<false>(piece, row, extremes);
    }
    row += piece.size();
  }
  return extremes;
}

void ColumnSummary::addBlock(const Extremes& block, std::size_t level) {
  if (level == levels_.size()) levels_.emplace_back();
  auto& blocks = levels_[level];
  blocks.push_back(block);
  if (blocks.size() % kFanOut != 0) return;
  Extremes above;
  for (auto it = blocks.end() - kFanOut; it != blocks.end(); ++it) above.merge(*it);
  addBlock(above, level + 1);
}

std::size_t ColumnSummary::extend(std::size_t mostRows) {
  const std::size_t before = rows_;
  // `mostRows` may be the largest number there is.
  const std::size_t goal = rows_ + std::min(recording_->rows() - rows_, mostRows);
  std::size_t row = levels_.empty() ? 0 : levels_[0].size() * kBlockRows;
  for (; row + kBlockRows <= goal; row += kBlockRows) addBlock(scan(row, row + kBlockRows), 0);
  rows_ = goal;
  return rows_ - before;
}

Extremes ColumnSummary::extremes(std::size_t first, std::size_t last) const {
  Extremes result;
  for (std::size_t row = first; row < last;) {
    std::size_t block = kBlockRows;
    std::size_t best = 0;  // rows of the largest block that starts here and fits
    std::size_t bestLevel = 0;
    for (std::size_t level = 0; level < levels_.size(); ++level, block *= kFanOut) {
      if (row % block != 0 || row + block > last || row / block >= levels_[level].size()) break;
      best = block;
      bestLevel = level;
    }
    if (best == 0) {
      const std::size_t end = std::min(last, (row / kBlockRows + 1) * kBlockRows);
      result.merge(scan(row, end));
      row = end;
    } else {
      result.merge(levels_[bestLevel][row / best]);
      row += best;
    }
  }
  return result;
}

ColumnSummary& SummaryCache::summary(const std::shared_ptr<const Recording>& recording,
                                     std::size_t channel, ColumnSummary::Values values) {
  auto& slot = summaries_[Key{recording.get(), channel, values}];
  if (!slot) slot = std::make_unique<ColumnSummary>(recording, channel, values);
  return *slot;
}

void SummaryCache::forget(const Recording* recording) {
  std::erase_if(summaries_,
                [recording](const auto& entry) { return std::get<0>(entry.first) == recording; });
}

}  // namespace rotorbench
