#include "sim/fitting/provenance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/core/units.h"

namespace rotorbench {

namespace {

std::string digits(double value, int significant) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", significant, value);
  return text;
}

std::string withUnit(const std::string& number, const std::string& unit) {
  return unit == "1" ? number : number + " " + unit;
}

}  // namespace

std::string numberIn(double value, const std::string& unit, const std::string& shown) {
  return withUnit(digits(value / unitFactor(unit, shown), 5), shown);
}

std::string valueText(const FittedParameter& p) {
  if (!p.determined) return "not determined";
  constexpr int kDigits = 5;
  const double factor = unitFactor(p.parameter.unit, p.parameter.shown);
  const double value = p.value / factor;
  if (!p.halfWidth) return withUnit(digits(value, kDigits), p.parameter.shown);
  const double half = *p.halfWidth / factor;
  // Two digits of the interval, and the value to the same place.
  const double ratio = half > 0 ? std::log10(std::max(std::abs(value) / half, 1.0)) : kDigits;
  const int significant = std::clamp(static_cast<int>(std::ceil(ratio)) + 2, 2, 9);
  return withUnit(digits(value, significant) + " \u00B1 " + digits(half, 2), p.parameter.shown);
}

std::string provenanceText(const FitProvenance& provenance, const FitResult& result) {
  std::string text = "Fitted (" + provenance.model + ") to " + provenance.file + " on " +
                     provenance.date + ", " + std::to_string(result.predicted.size()) +
                     " measured values, by non-linear least squares; " +
                     digits(100 * result.confidence, 3) + " % intervals. ";
  for (const FittedParameter& p : result.parameters) {
    text += p.parameter.label + ": " + valueText(p) + ". ";
  }
  for (const FittedOutput& output : result.outputs) {
    if (output.count == 0) continue;
    const double factor = unitFactor(output.output.unit, output.output.shown);
    text += "RMSE of " + output.output.label + ": " +
            withUnit(digits(output.rmseAfter / factor, 3), output.output.shown) + " (before " +
            digits(output.rmseBefore / factor, 3) + "). ";
  }
  text.pop_back();
  return text;
}

}  // namespace rotorbench
