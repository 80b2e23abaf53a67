// Rows of a measured table in which everything a fit needs was measured.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/logs/measured_table.h"

namespace rotorbench {

/// One sentence for each quantity (key of quantity.h) the table has no column for.
std::vector<std::string> missingColumns(const MeasuredTable& table,
                                        std::span<const std::string_view> quantities);

/// The values of these quantities in each row where all of them are finite. A quantity without a
/// column gives no rows. Behind them the `also`, NaN where they were not measured.
std::vector<std::vector<double>> finiteRows(const MeasuredTable& table,
                                            std::span<const std::string_view> quantities,
                                            std::span<const std::string_view> also = {});

/// Throws InputError with the sentences, if there are any.
void throwIfAny(const MeasuredTable& table, const std::vector<std::string>& sentences);

}  // namespace rotorbench
