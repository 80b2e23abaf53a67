#include "sim/fitting/measured_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/logs/quantity.h"

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
                                            std::span<const std::string_view> quantities,
                                            std::span<const std::string_view> also) {
  std::vector<const std::vector<double>*> columns;
  for (const std::string_view key : quantities) {
    columns.push_back(table.find(key));
    if (columns.back() == nullptr) return {};
  }
  for (const std::string_view key : also) columns.push_back(table.find(key));
  std::vector<std::vector<double>> rows;
  std::vector<double> row(columns.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t r = 0; r < table.rows(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c] != nullptr) row[c] = (*columns[c])[r];
    }
    const auto needed = std::span(row).first(quantities.size());
    if (std::ranges::all_of(needed, [](double v) { return std::isfinite(v); })) rows.push_back(row);
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
