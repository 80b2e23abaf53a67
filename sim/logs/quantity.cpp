#include "sim/logs/quantity.h"

#include <algorithm>
#include <array>

#include "sim/core/units.h"

namespace rotorbench {

namespace {

constexpr std::array kQuantities{
    Quantity{"time", "Time", "s", "s", "time", {}, {}},
    Quantity{"throttle", "Throttle", "1", "%", "throttle", "over_throttle.throttle", {}},
    Quantity{"motor.speed", "Motor speed", "rad/s", "rpm", "motor.speed", "over_throttle.speed",
             "over_advance.speed"},
    Quantity{"thrust", "Thrust", "N", "N", "thrust", "over_throttle.thrust", "over_advance.thrust"},
    Quantity{"motor.torque", "Torque", "N*m", "N*m", "motor.torque", "over_throttle.torque",
             "over_advance.torque"},
    Quantity{"supply.voltage",
             "Supply voltage",
             "V",
             "V",
             "supply.voltage",
             "over_throttle.supply_voltage",
             {}},
    Quantity{"supply.current",
             "Supply current",
             "A",
             "A",
             "supply.current",
             "over_throttle.supply_current",
             {}},
    Quantity{"motor.voltage",
             "Motor voltage",
             "V",
             "V",
             "motor.voltage",
             "over_throttle.motor_voltage",
             {}},
    Quantity{"motor.current",
             "Motor current",
             "A",
             "A",
             "motor.current",
             "over_throttle.motor_current",
             {}},
    Quantity{"power.electrical",
             "Electrical power",
             "W",
             "W",
             "power.electrical",
             "over_throttle.electrical_power",
             {}},
    Quantity{"power.shaft", "Shaft power", "W", "W", "power.shaft", "over_throttle.shaft_power",
             "over_advance.power"},
    Quantity{"efficiency", "Efficiency", "1", "%", "efficiency", "over_throttle.efficiency",
             "over_advance.efficiency"},
    Quantity{"thrust_per_power",
             "Thrust per power",
             "N/W",
             "gf/W",
             "thrust_per_power",
             "over_throttle.thrust_per_power",
             {}},
    Quantity{"advance_ratio", "Advance ratio J", "1", "1", "advance_ratio", {}, "over_advance.j"},
    Quantity{"ct", "Thrust coefficient CT", "1", "1", "ct", {}, "over_advance.ct"},
    Quantity{"cp", "Power coefficient CP", "1", "1", "cp", {}, "over_advance.cp"},
    Quantity{"air_speed", "Air speed", "m/s", "m/s", "air_speed", {}, "over_advance.air_speed"},
    Quantity{"supply.charge_drawn",
             "Charge drawn",
             "C",
             "mAh",
             "supply.charge_drawn",
             "over_throttle.charge_drawn",
             {}},
};

constexpr std::array<std::string_view, 4> kMasses{"g", "kg", "oz", "lb"};
constexpr double kGravity = 9.80665;  // m/s^2, standard
/// Pulses of a speed controller, us: 1000 is no throttle, 2000 full throttle.
constexpr UnitConversion kPulse{1e-3, -1};

}  // namespace

std::span<const Quantity> measurableQuantities() {
  return kQuantities;
}

const Quantity* findQuantity(std::string_view key) {
  const auto* const at = std::ranges::find(kQuantities, key, &Quantity::key);
  return at == kQuantities.end() ? nullptr : at;
}

std::string channelName(const Quantity& quantity, ChannelGroup group) {
  std::string_view name;
  if (group == ChannelGroup::OverThrottle) name = quantity.throttle;
  if (group == ChannelGroup::OverAdvance) name = quantity.advance;
  return std::string(name.empty() ? quantity.run : name);
}

const Quantity& abscissaOf(ChannelGroup group) {
  return *findQuantity(group == ChannelGroup::Run            ? "time"
                       : group == ChannelGroup::OverThrottle ? "throttle"
                                                             : "advance_ratio");
}

std::optional<std::size_t> findQuantity(const std::vector<Channel>& channels,
                                        std::string_view quantityKey) {
  const Quantity* quantity = findQuantity(quantityKey);
  if (quantity == nullptr) return {};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::string& name = channels[i].name;
    const bool is = name == quantity->run || (!name.empty() && name == quantity->throttle) ||
                    (!name.empty() && name == quantity->advance);
    if (is && channels[i].unit == quantity->unit) return i;
  }
  return {};
}

std::vector<std::string> unitsOf(const Quantity& quantity) {
  std::vector<std::string> units;
  for (const Unit* unit : unitsLike(quantity.unit)) units.emplace_back(unit->symbol);
  if (quantity.key == "throttle") units.emplace_back("us");
  if (quantity.unit == "N") units.insert(units.end(), kMasses.begin(), kMasses.end());
  return units;
}

std::optional<UnitConversion> conversionOf(const Quantity& quantity, std::string_view unit) {
  const Unit* written = findUnit(unit);
  if (written == nullptr) return {};
  if (quantity.key == "throttle" && written->symbol == "us") return kPulse;
  if (quantity.unit == "N" && written->dimension == "kg") {
    return UnitConversion{written->factor * kGravity, 0};
  }
  if (written->dimension != quantity.unit) return {};
  return UnitConversion{written->factor, 0};
}

}  // namespace rotorbench
