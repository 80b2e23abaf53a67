// Measured columns under our names, in SI units. What was not measured in a row is NaN.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/channel.h"
#include "sim/core/recording.h"

namespace rotorbench {

struct MeasuredTable {
  std::string source;             ///< the file it came from
  std::vector<Channel> channels;  ///< the first is the abscissa
  std::vector<std::vector<double>> columns;

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// The values of a quantity under any of its channel names, or null.
  [[nodiscard]] const std::vector<double>* find(std::string_view quantityKey) const;
};

/// As the charts show it. The abscissa of the table must not decrease.
std::shared_ptr<const Recording> recordingOf(const MeasuredTable& table);
/// All published rows of a recording.
MeasuredTable tableOf(const Recording& recording, std::string source);

}  // namespace rotorbench
