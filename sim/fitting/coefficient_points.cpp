#include "sim/fitting/coefficient_points.h"

#include <cmath>

#include "sim/core/error.h"
#include "sim/core/schema_tree.h"
#include "sim/fitting/measured_rows.h"

namespace rotorbench {

std::vector<std::string> missingForCoefficients(const MeasuredTable& table) {
  constexpr std::string_view kNeeded[]{"ct", "cp"};
  std::vector<std::string> missing = missingColumns(table, kNeeded);
  if (missing.empty() && table.find("advance_ratio") == nullptr &&
      table.find("motor.speed") == nullptr) {
    missing.emplace_back(
        "The measured data have neither a column for Advance ratio J nor one for "
        "Motor speed.");
  }
  return missing;
}

MeasuredPropeller propellerOfTable(const MeasuredTable& table, double diameter) {
  throwIfAny(table, missingForCoefficients(table));
  const std::vector<double>&thrust = *table.find("ct"), &power = *table.find("cp");
  const auto* advance = table.find("advance_ratio");
  const auto* speed = table.find("motor.speed");
  MeasuredPropeller propeller;
  propeller.diameter = diameter;
  propeller.points.clear();
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const CoefficientPoint point{speed != nullptr ? (*speed)[r] : 0,
                                 advance != nullptr ? (*advance)[r] : 0, thrust[r], power[r]};
    if (std::isfinite(point.speed) && std::isfinite(point.advanceRatio) &&
        std::isfinite(point.thrustCoefficient) && std::isfinite(point.powerCoefficient)) {
      propeller.points.push_back(point);
    }
  }
  std::vector<Problem> problems = schema::validate(schema::ref(propeller));
  if (!problems.empty()) throw InputError(table.source, std::move(problems));
  return propeller;
}

}  // namespace rotorbench
