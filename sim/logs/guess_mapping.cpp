// What a column is, from its name, its unit and the size of its numbers.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "sim/core/units.h"
#include "sim/io/csv_cells.h"
#include "sim/logs/import_settings.h"
#include "sim/logs/time_text.h"

namespace rotorbench {

namespace {

/// A word that tells a quantity: the longer, the surer; a whole name is surest.
struct Hint {
  std::string_view word;
  std::string_view quantity;
  bool wholeName = false;
};

constexpr std::array kHints{
    Hint{"time", "time"},
    Hint{"idle time", {}},  // of a processor
    Hint{"seconds", "time"},
    Hint{"t", "time", true},
    Hint{"esc signal", "throttle"},
    Hint{"throttle", "throttle"},
    Hint{"duty", "throttle"},
    Hint{"pwm", "throttle"},
    Hint{"electrical speed", "motor.speed"},
    Hint{"motor speed", "motor.speed"},
    Hint{"rotation", "motor.speed"},
    Hint{"angular", "motor.speed"},
    Hint{"optical speed", "motor.speed"},
    Hint{"speed", "motor.speed"},
    Hint{"omega", "motor.speed"},
    Hint{"rpm", "motor.speed"},
    Hint{"thrust", "thrust"},
    Hint{"force", "thrust"},
    Hint{"weight", "thrust"},
    Hint{"torque", "motor.torque"},
    Hint{"voltage", "supply.voltage"},
    Hint{"volts", "supply.voltage"},
    Hint{"batt. volts", "supply.voltage"},
    Hint{"vbat", "supply.voltage"},
    Hint{"v", "supply.voltage", true},
    Hint{"motor volt", "motor.voltage"},
    Hint{"current", "supply.current"},
    Hint{"amps", "supply.current"},
    Hint{"i", "supply.current", true},
    Hint{"motor current", "motor.current"},
    Hint{"electrical power", "power.electrical"},
    Hint{"power", "power.electrical"},
    Hint{"p", "power.electrical", true},
    Hint{"mechanical power", "power.shaft"},
    Hint{"shaft power", "power.shaft"},
    Hint{"pwr", "power.shaft", true},
    Hint{"motor efficiency", "efficiency"},
    Hint{"efficiency", "efficiency"},
    Hint{"eta", "efficiency", true},
    Hint{"pe", "efficiency", true},
    Hint{"overall efficiency", "thrust_per_power"},
    Hint{"eff_g_per_w", "thrust_per_power"},
    Hint{"j", "advance_ratio", true},
    Hint{"advance", "advance_ratio"},
    Hint{"ct", "ct", true},
    Hint{"thrust coeff", "ct"},
    Hint{"cp", "cp", true},
    Hint{"power coeff", "cp"},
    Hint{"air speed", "air_speed"},
    Hint{"airspeed", "air_speed"},
    Hint{"v", "air_speed", true},
    Hint{"mah", "supply.charge_drawn"},
    Hint{"charge drawn", "supply.charge_drawn"},
};

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// 0 where the hint does not fit.
std::size_t fit(const Hint& hint, const std::string& name) {
  constexpr std::size_t kWholeName = 100;
  if (name == hint.word) return kWholeName;
  return !hint.wholeName && name.find(hint.word) != std::string::npos ? hint.word.size() : 0;
}

double largest(const PreviewColumn& column) {
  double most = 0;
  for (const std::string& cell : column.cells) {
    if (const auto value = readCell(cell, true)) most = std::max(most, std::abs(*value));
  }
  return most;
}

/// Units of numbers without one: a share by its size, anything else as it is mostly written.
void guessScale(const PreviewColumn& column, const Quantity& quantity, ColumnMapping& mapping) {
  constexpr double kShare = 1.5, kPercent = 150, kPulse = 3000;
  constexpr double kSixteenBits = 65535;
  mapping.unit = quantity.shown;
  if (quantity.unit != "1" || quantity.shown != "%") return;
  const double most = largest(column);
  const bool throttle = quantity.key == "throttle";
  mapping.unit = most > kPercent && most <= kPulse && throttle ? "us"
                 : most > kShare && most <= kPercent           ? "%"
                                                               : "1";
  if (throttle && most > kPulse) mapping.scale = 1 / kSixteenBits;
}

/// The unit in brackets, or behind the last underscore ("voltage_V"), or by the size of the
/// numbers. False if the column has a unit in which the quantity is not measured.
bool takeUnit(const PreviewColumn& column, const Quantity& quantity, ColumnMapping& mapping) {
  if (!column.unit.empty()) {
    mapping.unit = canonicalUnit(column.unit);
    return conversionOf(quantity, mapping.unit).has_value();
  }
  const std::size_t underscore = column.name.rfind('_');
  std::string tail = underscore == std::string::npos ? "" : column.name.substr(underscore + 1);
  if (!tail.empty() && tail != "1" && conversionOf(quantity, tail)) {
    mapping.unit = canonicalUnit(tail);
    return true;
  }
  guessScale(column, quantity, mapping);
  // A lone letter without a unit says too little, but for the coefficients.
  return column.name.size() > 1 || quantity.unit == "1" || quantity.key == "time";
}

struct Candidate {
  std::size_t fit = 0;
  ColumnMapping mapping;
};

/// Cells that are times as text, or are meant to be: a time, though any column of numbers is the
/// better one.
bool isTimeText(const PreviewColumn& column, const std::string& name) {
  if (column.numbers > 0) return false;
  const bool named = name.find("time") != std::string::npos || name == "t";
  return column.times > column.texts ||
         (named &&
          std::ranges::any_of(column.cells, [](const auto& c) { return resemblesTime(c); }));
}

Candidate bestFor(const PreviewColumn& column) {
  Candidate best;
  best.mapping.column = column.name;
  best.mapping.unit = column.unit;
  if (isTimeText(column, lowered(column.name))) return {1, {column.name, "time", "s", {}, 1, 0}};
  if (column.numbers == 0) return best;
  const std::string name = lowered(column.name);
  if (name.find("temp") != std::string::npos) {
    best.mapping.quantity = kOtherQuantity;
    best.mapping.channel = "temperature";
    return best;
  }
  for (const Hint& hint : kHints) {
    const std::size_t f = fit(hint, name);
    if (f <= best.fit) continue;
    Candidate candidate{f, {column.name, std::string(hint.quantity), column.unit, {}, 1, 0}};
    if (hint.quantity.empty()) {
      best = candidate;
      continue;
    }
    if (takeUnit(column, *findQuantity(hint.quantity), candidate.mapping)) best = candidate;
  }
  return best;
}

}  // namespace

std::vector<ColumnMapping> guessMapping(const CsvPreview& preview) {
  std::vector<Candidate> candidates;
  for (const PreviewColumn& column : preview.columns) candidates.push_back(bestFor(column));
  std::vector<ColumnMapping> mapping;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    ColumnMapping column = candidates[i].mapping;
    const bool better = std::ranges::any_of(candidates, [&](const Candidate& other) {
      const auto k = static_cast<std::size_t>(&other - candidates.data());
      return k != i && other.mapping.quantity == column.quantity &&
             (other.fit > candidates[i].fit || (other.fit == candidates[i].fit && k < i));
    });
    if (better) column.quantity.clear(), column.unit = preview.columns[i].unit;
    mapping.push_back(std::move(column));
  }
  return mapping;
}

}  // namespace rotorbench
