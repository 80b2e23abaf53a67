#include "sim/core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "sim/core/constants.h"
#include "sim/core/error.h"

namespace rotorbench {

namespace {

constexpr double kPound = 0.45359237;  // kg, exact (1959)
constexpr double kGravity = 9.80665;   // m/s^2, standard

/// Grouped by dimension, the SI unit of each group first.
constexpr std::array kUnits{
    Unit{"1", "1", 1},
    Unit{"%", "1", 0.01},
    Unit{"m", "m", 1},
    Unit{"cm", "m", 0.01},
    Unit{"mm", "m", 0.001},
    Unit{"um", "m", 1e-6},
    Unit{"km", "m", 1000},
    Unit{"in", "m", 0.0254},
    Unit{"ft", "m", 0.3048},
    Unit{"m^2", "m^2", 1},
    Unit{"cm^2", "m^2", 1e-4},
    Unit{"mm^2", "m^2", 1e-6},
    Unit{"in^2", "m^2", 0.0254 * 0.0254},
    Unit{"kg", "kg", 1},
    Unit{"g", "kg", 0.001},
    Unit{"lb", "kg", kPound},
    Unit{"oz", "kg", kPound / 16},
    Unit{"s", "s", 1},
    Unit{"ms", "s", 0.001},
    Unit{"us", "s", 1e-6},
    Unit{"min", "s", 60},
    Unit{"h", "s", 3600},
    Unit{"Hz", "Hz", 1},
    Unit{"kHz", "Hz", 1000},
    Unit{"rad", "rad", 1},
    Unit{"deg", "rad", kDegree},
    Unit{"rev", "rad", 2 * kPi},
    Unit{"rad/s", "rad/s", 1},
    Unit{"rpm", "rad/s", kRpm},
    Unit{"deg/s", "rad/s", kDegree},
    Unit{"rev/s", "rad/s", 2 * kPi},
    Unit{"rad/s^2", "rad/s^2", 1},
    Unit{"rpm/s", "rad/s^2", kRpm},
    Unit{"deg/s^2", "rad/s^2", kDegree},
    Unit{"m/s", "m/s", 1},
    Unit{"cm/s", "m/s", 0.01},
    Unit{"mm/s", "m/s", 0.001},
    Unit{"km/h", "m/s", 1 / 3.6},
    Unit{"ft/s", "m/s", 0.3048},
    Unit{"mph", "m/s", 0.44704},
    Unit{"m/s^2", "m/s^2", 1},
    Unit{"cm/s^2", "m/s^2", 0.01},
    Unit{"g0", "m/s^2", kGravity},
    Unit{"N", "N", 1},
    Unit{"mN", "N", 0.001},
    Unit{"kN", "N", 1000},
    Unit{"gf", "N", kGravity / 1000},
    Unit{"kgf", "N", kGravity},
    Unit{"lbf", "N", kPound* kGravity},
    Unit{"ozf", "N", kPound / 16 * kGravity},
    Unit{"N*m", "N*m", 1},
    Unit{"mN*m", "N*m", 0.001},
    Unit{"uN*m", "N*m", 1e-6},
    Unit{"N*cm", "N*m", 0.01},
    Unit{"lbf*ft", "N*m", kPound* kGravity * 0.3048},
    Unit{"lbf*in", "N*m", kPound* kGravity * 0.0254},
    Unit{"ozf*in", "N*m", kPound / 16 * kGravity * 0.0254},
    Unit{"kgf*cm", "N*m", kGravity * 0.01},
    Unit{"gf*cm", "N*m", kGravity * 1e-5},
    Unit{"Pa", "Pa", 1},
    Unit{"hPa", "Pa", 100},
    Unit{"kPa", "Pa", 1000},
    Unit{"MPa", "Pa", 1e6},
    Unit{"GPa", "Pa", 1e9},
    Unit{"K", "K", 1},
    Unit{"V", "V", 1},
    Unit{"mV", "V", 0.001},
    Unit{"A", "A", 1},
    Unit{"mA", "A", 0.001},
    Unit{"Ohm", "Ohm", 1},
    Unit{"mOhm", "Ohm", 0.001},
    Unit{"kOhm", "Ohm", 1000},
    Unit{"H", "H", 1},
    Unit{"mH", "H", 0.001},
    Unit{"uH", "H", 1e-6},
    Unit{"C", "C", 1},
    Unit{"Ah", "C", 3600},
    Unit{"mAh", "C", 3.6},
    Unit{"W", "W", 1},
    Unit{"mW", "W", 0.001},
    Unit{"kW", "W", 1000},
    Unit{"hp", "W", kPound* kGravity * 0.3048 * 550},
    Unit{"J", "J", 1},
    Unit{"kJ", "J", 1000},
    Unit{"Wh", "J", 3600},
    Unit{"kg*m^2", "kg*m^2", 1},
    Unit{"g*m^2", "kg*m^2", 0.001},
    Unit{"kg*cm^2", "kg*m^2", 1e-4},
    Unit{"g*cm^2", "kg*m^2", 1e-7},
    Unit{"kg*mm^2", "kg*m^2", 1e-6},
    Unit{"g*mm^2", "kg*m^2", 1e-9},
    Unit{"kg/m^3", "kg/m^3", 1},
    Unit{"g/cm^3", "kg/m^3", 1000},
    Unit{"g/L", "kg/m^3", 1},
    Unit{"kg/m", "kg/m", 1},
    Unit{"g/m", "kg/m", 0.001},
    Unit{"Pa*s", "Pa*s", 1},
    Unit{"m^2/s", "m^2/s", 1},
    Unit{"rad/s/V", "rad/s/V", 1},
    Unit{"rpm/V", "rad/s/V", kRpm},
    Unit{"V*s", "V*s", 1},
    Unit{"mV*s", "V*s", 0.001},
    Unit{"V/rpm", "V*s", 1 / kRpm},
    Unit{"mV/rpm", "V*s", 0.001 / kRpm},
    Unit{"N*m/A", "N*m/A", 1},
    Unit{"mN*m/A", "N*m/A", 0.001},
    Unit{"N*s^2", "N*s^2", 1},
    Unit{"N/rpm^2", "N*s^2", 1 / (kRpm * kRpm)},
    Unit{"N*m*s^2", "N*m*s^2", 1},
    Unit{"N*m/rpm^2", "N*m*s^2", 1 / (kRpm * kRpm)},
    Unit{"N*m*s", "N*m*s", 1},
    Unit{"mN*m*s", "N*m*s", 0.001},
    Unit{"N*m/rpm", "N*m*s", 1 / kRpm},
    Unit{"N*m/rad", "N*m/rad", 1},
    Unit{"N*m/deg", "N*m/rad", 1 / kDegree},
    Unit{"N/W", "N/W", 1},
    Unit{"gf/W", "N/W", kGravity / 1000},
    Unit{"N/m", "N/m", 1},
    Unit{"N/mm", "N/m", 1000},
    Unit{"N*s/m", "N*s/m", 1},
    Unit{"N*s", "N*s", 1},
    Unit{"N*m^2", "N*m^2", 1},
    Unit{"1/m", "1/m", 1},
    Unit{"1/rad", "1/rad", 1},
    Unit{"1/deg", "1/rad", 1 / kDegree},
    Unit{"1/s^2", "1/s^2", 1},
    Unit{"1/V", "1/V", 1},
    Unit{"rad/m", "rad/m", 1},
    Unit{"deg/m", "rad/m", kDegree},
    Unit{"K/m", "K/m", 1},
    Unit{"J/(kg*K)", "J/(kg*K)", 1},
    Unit{"B", "B", 1},
    Unit{"kB", "B", 1e3},
    Unit{"MB", "B", 1e6},
    Unit{"GB", "B", 1e9},
    Unit{"T", "T", 1},
    Unit{"uT", "T", 1e-6},
};

/// Other spellings people use, after the signs have been unified.
constexpr std::array<std::pair<std::string_view, std::string_view>, 67> kAliases{{
    {"", "1"},
    {"-", "1"},
    {"percent", "%"},
    {"inch", "in"},
    {"\"", "in"},
    {"'", "ft"},
    {"lbs", "lb"},
    {"sec", "s"},
    {"hour", "h"},
    {"1/s", "Hz"},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"turn", "rev"},
    {"turns", "rev"},
    {"rad*s^-1", "rad/s"},
    {"rad*s^-2", "rad/s^2"},
    {"RPM", "rpm"},
    {"1/min", "rpm"},
    {"rev/min", "rpm"},
    {"r/min", "rpm"},
    {"U/min", "rpm"},
    {"rps", "rev/s"},
    {"m*s^-1", "m/s"},
    {"m*s^-2", "m/s^2"},
    {"kph", "km/h"},
    {"kmh", "km/h"},
    {"p", "gf"},
    {"Nm", "N*m"},
    {"mNm", "mN*m"},
    {"in*lbf", "lbf*in"},
    {"In-Lbf", "lbf*in"},
    {"in-lbf", "lbf*in"},
    {"Lbf", "lbf"},
    {"Hp", "hp"},
    {"uNm", "uN*m"},
    {"Ncm", "N*cm"},
    {"m*N", "N*m"},
    {"N/m^2", "Pa"},
    {"ohm", "Ohm"},
    {"mohm", "mOhm"},
    {"kohm", "kOhm"},
    {"A*s", "C"},
    {"A*h", "Ah"},
    {"mA*h", "mAh"},
    {"W*h", "Wh"},
    {"kg*m^-3", "kg/m^3"},
    {"rad/(V*s)", "rad/s/V"},
    {"rad/(s*V)", "rad/s/V"},
    {"rad/V/s", "rad/s/V"},
    {"RPM/V", "rpm/V"},
    {"V/(rad/s)", "V*s"},
    {"V*s/rad", "V*s"},
    {"Nm/A", "N*m/A"},
    {"mNm/A", "mN*m/A"},
    {"N/(rad/s)^2", "N*s^2"},
    {"N*s^2/rad^2", "N*s^2"},
    {"kg*m", "N*s^2"},
    {"N*m/(rad/s)^2", "N*m*s^2"},
    {"N*m*s^2/rad^2", "N*m*s^2"},
    {"Nm*s^2", "N*m*s^2"},
    {"N*m/(rad/s)", "N*m*s"},
    {"N*m*s/rad", "N*m*s"},
    {"Nm*s", "N*m*s"},
    {"Nms", "N*m*s"},
    {"Nm/rad", "N*m/rad"},
    {"N/(m/s)", "N*s/m"},
    {"kg/s", "N*s/m"},
}};

struct Spelling {
  std::string_view from, to;
};
constexpr std::array kSigns{
    Spelling{"·", "*"},   Spelling{"⋅", "*"},      Spelling{"×", "*"},      Spelling{"²", "^2"},
    Spelling{"³", "^3"},  Spelling{"⁻¹", "^-1"},   Spelling{"⁻²", "^-2"},   Spelling{"Ω", "Ohm"},
    Spelling{"Ω", "Ohm"}, Spelling{"µ", "u"},      Spelling{"μ", "u"},      Spelling{"°", "deg"},
    Spelling{"″", "in"},  Spelling{"\u00A0", " "}, Spelling{"\u202F", " "}, Spelling{"−", "-"},
    Spelling{"**", "^"},
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::string unifySigns(std::string_view symbol) {
  std::string out;
  for (std::size_t i = 0; i < symbol.size();) {
    const auto found = std::find_if(kSigns.begin(), kSigns.end(), [&](const Spelling& s) {
      return symbol.substr(i).starts_with(s.from);
    });
    if (found == kSigns.end()) {
      out += symbol[i++];
    } else {
      out += found->to;
      i += found->from.size();
    }
  }
  return out;
}

bool isSign(char c) {
  return c == '*' || c == '/' || c == '^' || c == '(' || c == ')';
}

/// "N m / A" -> "N*m/A": a space between two names is a product, beside a sign it means nothing.
std::string withoutSpaces(std::string_view symbol) {
  std::string out;
  bool gap = false;
  for (const char c : symbol) {
    if (c == ' ' || c == '\t') {
      gap = true;
      continue;
    }
    if (gap && !out.empty() && !isSign(c) && !isSign(out.back())) out += '*';
    gap = false;
    out += c;
  }
  return out;
}

struct UnitIndex {
  std::unordered_map<std::string_view, const Unit*> bySymbol;
  UnitIndex() {
    for (const Unit& unit : kUnits) bySymbol.emplace(unit.symbol, &unit);
    for (const auto& [alias, symbol] : kAliases) bySymbol.emplace(alias, bySymbol.at(symbol));
  }
};

const Unit* lookUp(std::string_view symbol) {
  static const UnitIndex index;
  const auto found = index.bySymbol.find(symbol);
  return found == index.bySymbol.end() ? nullptr : found->second;
}

/// The whole number 1 / factor, or 0.
double wholeInverse(double factor) {
  if (factor >= 1) return 0;
  const double inverse = std::round(1 / factor);
  return 1 / inverse == factor ? inverse : 0;
}

}  // namespace

double toSi(double value, double factor) {
  const double inverse = wholeInverse(factor);
  return inverse != 0 ? value / inverse : value * factor;
}

double fromSi(double value, double factor) {
  const double inverse = wholeInverse(factor);
  return inverse != 0 ? value * inverse : value / factor;
}

const Unit* findUnit(std::string_view symbol) {
  constexpr std::size_t kLongestUnit = 60;
  if (symbol.size() > kLongestUnit) return nullptr;
  if (const Unit* unit = lookUp(symbol)) return unit;
  return lookUp(withoutSpaces(trimmed(unifySigns(symbol))));
}

std::string canonicalUnit(std::string_view symbol) {
  if (const Unit* unit = findUnit(symbol)) return std::string(unit->symbol);
  return withoutSpaces(trimmed(unifySigns(symbol)));
}

bool sameDimension(std::string_view a, std::string_view b) {
  const Unit* unitA = findUnit(a);
  const Unit* unitB = findUnit(b);
  if (unitA != nullptr && unitB != nullptr) return unitA->dimension == unitB->dimension;
  return unitA == unitB && canonicalUnit(a) == canonicalUnit(b);
}

std::vector<const Unit*> unitsLike(std::string_view symbol) {
  std::vector<const Unit*> units;
  if (const Unit* asked = findUnit(symbol)) {
    for (const Unit& unit : kUnits) {
      if (unit.dimension == asked->dimension) units.push_back(&unit);
    }
  }
  return units;
}

double unitFactor(std::string_view siUnit, std::string_view shown) {
  const Unit* si = findUnit(siUnit);
  const Unit* unit = findUnit(shown);
  const bool alike = si != nullptr && unit != nullptr && si->dimension == unit->dimension;
  return alike ? unit->factor / si->factor : 1.0;
}

double convertUnit(double value, std::string_view from, std::string_view to) {
  if (!sameDimension(from, to)) {
    throw InputError(
        {},
        {{{}, "the unit " + std::string(from) + " does not convert to " + std::string(to), {}}});
  }
  const Unit* unitFrom = findUnit(from);
  const Unit* unitTo = findUnit(to);
  if (unitFrom == unitTo) return value;  // also two equal names outside the table
  return fromSi(toSi(value, unitFrom->factor), unitTo->factor);
}

}  // namespace rotorbench
