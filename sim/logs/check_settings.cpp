// What is wrong with the choices for a table of measurements, before it is read.
#include <algorithm>
#include <cmath>
#include <set>

#include "sim/core/number_text.h"
#include "sim/logs/csv_import.h"

namespace rotorbench {

namespace {

void checkColumn(const ColumnMapping& column, const CsvPreview& preview,
                 std::vector<Problem>& problems) {
  const std::string path = "column " + inQuotes(column.column);
  const auto at = std::ranges::find(preview.columns, column.column, &PreviewColumn::name);
  if (at == preview.columns.end()) {
    problems.push_back({path, "the table has no such column", {}});
  } else if (at->times > 0 && column.quantity == "time" && column.unit != "s") {
    problems.push_back(
        {path, "dates and times of day are counted in seconds", "the unit must be s"});
  }
  if (!std::isfinite(column.scale) || !std::isfinite(column.offset) || column.scale == 0) {
    problems.push_back(
        {path, "the scale or the offset cannot be used", "must be finite, the scale not 0"});
  }
  if (column.quantity == kOtherQuantity) return;
  const Quantity* quantity = findQuantity(column.quantity);
  if (quantity == nullptr) {
    problems.push_back({path, "the quantity " + excerpt(column.quantity) + " is not known", {}});
  } else if (!conversionOf(*quantity, column.unit)) {
    const std::string unit = column.unit.empty() ? "no unit" : "the unit " + excerpt(column.unit);
    problems.push_back({path, unit + " does not fit " + std::string(quantity->label),
                        "must convert to " + std::string(quantity->unit)});
  }
}

}  // namespace

std::vector<Problem> checkSettings(const ImportSettings& settings, const CsvPreview& preview) {
  std::vector<Problem> problems;
  if (preview.rows == 0) {
    problems.push_back(
        {{}, "there are no rows below the names", "check the line of names and the lines to skip"});
    return problems;
  }
  std::set<std::string> names;
  bool abscissa = settings.group == ChannelGroup::Run;
  for (const ColumnMapping& column : settings.columns) {
    if (column.quantity.empty()) continue;
    checkColumn(column, preview, problems);
    abscissa = abscissa || column.quantity == abscissaOf(settings.group).key;
    const std::string name = channelOf(column, settings.group).name;
    if (!names.insert(name).second) {
      problems.push_back({"column " + inQuotes(column.column), excerpt(name) + " is chosen twice",
                          "each quantity belongs to one column"});
    }
  }
  if (names.empty()) {
    problems.push_back({{}, "no column is chosen", "choose what at least one column is"});
  } else if (!abscissa) {
    const std::string label(abscissaOf(settings.group).label);
    problems.push_back({{},
                        "no column is chosen as " + label,
                        "it is the horizontal axis of what this is compared with"});
  }
  return problems;
}

}  // namespace rotorbench
