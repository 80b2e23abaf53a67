// What people measure on a stand or in a tunnel, under the names the computed runs use: the one
// table that import, comparison and fit agree on. SI units.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/channel.h"

namespace rotorbench {

/// The family of channel names measured data take, so that they meet the computed ones on a chart.
enum class ChannelGroup {
  Run,           ///< over time: "throttle", "motor.speed", "thrust"
  OverThrottle,  ///< steady points: "over_throttle.throttle", "over_throttle.thrust"
  OverAdvance,   ///< a propeller's coefficients: "over_advance.j", "over_advance.ct"
};

/// One kind of measured number.
struct Quantity {
  std::string_view key;       ///< in files: "motor.speed"
  std::string_view label;     ///< "Motor speed"
  std::string_view unit;      ///< SI
  std::string_view shown;     ///< unit a column most likely has
  std::string_view run;       ///< channel in ChannelGroup::Run
  std::string_view throttle;  ///< channel in ChannelGroup::OverThrottle; empty: the same as in Run
  std::string_view advance;   ///< channel in ChannelGroup::OverAdvance; empty: the same as in Run
};

/// All that can be chosen for a column, time first.
std::span<const Quantity> measurableQuantities();
/// The quantity with this key, or null.
const Quantity* findQuantity(std::string_view key);
std::string channelName(const Quantity& quantity, ChannelGroup group);
/// The quantity on the horizontal axis of a group.
const Quantity& abscissaOf(ChannelGroup group);
/// Where a quantity is among channels, under any of its names.
std::optional<std::size_t> findQuantity(const std::vector<Channel>& channels,
                                        std::string_view quantityKey);

/// SI value = factor * written value + offset.
struct UnitConversion {
  double factor = 1;
  double offset = 0;
  [[nodiscard]] double toSi(double written) const { return factor * written + offset; }
};

/// Units a column of this quantity may be in. Beside those of its dimension: "us" for a throttle,
/// the pulse from 1000 to 2000 microseconds; grams, kilograms, ounces and pounds for a thrust (of
/// force at standard gravity).
std::vector<std::string> unitsOf(const Quantity& quantity);
/// Empty if the quantity is not measured in this unit.
std::optional<UnitConversion> conversionOf(const Quantity& quantity, std::string_view unit);

}  // namespace rotorbench
