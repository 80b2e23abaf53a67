// Units of measurement: the simulator computes in SI, people read and type what suits them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotorbench {

/// SI value = factor * value. `dimension` is the SI symbol of the quantity ("m", "rad/s", "kg*m^2",
/// "1" for plain numbers); units convert only inside one dimension.
struct Unit {
  std::string_view symbol;     ///< as written in files and shown: "rpm", "deg", "g", "in"
  std::string_view dimension;  ///< SI symbol it converts to: "rad/s", "rad", "kg", "m"
  double factor;
};

/// value * factor and back. Where 1 / factor is a whole number (mm, g, deg is not) the division is
/// exact to the last bit: 117 mOhm is the double 0.117.
double toSi(double value, double factor);
double fromSi(double value, double factor);

/// The unit written `symbol`, or null. Common spellings ("Ohm", "Ω", "N m", "N*m") are accepted.
const Unit* findUnit(std::string_view symbol);

/// The one spelling of a unit: "N*m" for "N·m", "N m" and "Nm"; "kg*m^2" for "kg m²". Unknown units
/// keep their name, with the same signs for product and power.
std::string canonicalUnit(std::string_view symbol);

/// True if both convert into each other; a unit not in the table converts only to itself.
bool sameDimension(std::string_view a, std::string_view b);

/// All units that convert to the same dimension as `symbol`, the SI one first.
std::vector<const Unit*> unitsLike(std::string_view symbol);

/// Size of `shown` in `siUnit`; 1 where they do not convert.
double unitFactor(std::string_view siUnit, std::string_view shown);

/// Converts between two units of one dimension; both must exist and be alike (else InputError).
double convertUnit(double value, std::string_view from, std::string_view to);

/// What a person or a file wrote for a quantity.
struct ParsedQuantity {
  std::optional<double> value;  ///< in `unit` as asked for; empty if the text is not a quantity
  std::string error;            ///< one sentence, if there is no value
};

/// Reads "9.45 in", "0,25", "3*2", "960 rpm/V" or "1e-3" as a value in `unit`. Text without a unit
/// is taken to be in `defaultUnit`. Both decimal separators are understood; + - * / and parentheses
/// too. A unit is written once and belongs to the whole: "1/2 in", "9.45 in / 2". The error reads
/// "what; what is allowed".
ParsedQuantity parseQuantity(std::string_view text, std::string_view unit,
                             std::string_view defaultUnit);

}  // namespace rotorbench
