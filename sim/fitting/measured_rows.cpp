#include "sim/fitting/measured_rows.h"

#include <algorithm>
#include <cmath>

#include "sim/core/error.h"
#include "sim/measurement/quantity.h"

namespace rotorbench {

std::vector<std::string> missingColumns(const MeasuredTable& table,
                                        std::span<const std::string_view> quantities) {
  std::vector<std::string> missing;
  for (const std::string_view key : quantities) {
    const Quantity* quantity = findQuantity(key);
    if (table.find(key) != nullptr || quantity == nullptr) continue;
    missing.push_back("The measured data have no column for " + std::string(quantity->label) + ".");
  }
  return missing;
}

std::vector<std::vector<double>> finiteRows(const MeasuredTable& table,
                                            std::span<const std::string_view> quantities) {
  std::vector<const std::vector<double>*> columns;
  for (const std::string_view key : quantities) {
    columns.push_back(table.find(key));
    if (columns.back() == nullptr) return {};
  }
  std::vector<std::vector<double>> rows;
  std::vector<double> row(columns.size());
  for (std::size_t r = 0; r < table.rows(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) row[c] = (*columns[c])[r];
    if (std::ranges::all_of(row, [](double v) { return std::isfinite(v); })) rows.push_back(row);
  }
  return rows;
}

void throwIfAny(const MeasuredTable& table, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  std::vector<Problem> problems;
  for (const std::string& sentence : sentences) problems.push_back({{}, sentence, {}});
  throw InputError(table.source, std::move(problems));
}

}  // namespace rotorbench
