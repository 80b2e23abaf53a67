// A sheet of figures as people and programs read it: an aligned table, one JSON object, or CSV.
#pragma once

#include <string>

#include "sim/sizing/figure.h"

namespace rotorbench {

/// One block per group: quantity, symbol, value with unit, and in the next line what limits it;
/// warnings last. UTF-8, '\n'. Numbers in the C locale unless another writer is given.
std::string sheetText(const FigureSheet& sheet, const NumberWriter& write = shortNumber);

/// {"title": …, "figures": [{"key", "group", "label", "symbol", "value" (SI; null where there is
/// none), "unit", "formula", "source", "note"}], "warnings": […]}. Numbers have the shortest digits
/// that read back equal.
std::string sheetJson(const std::string& title, const FigureSheet& sheet);

/// First line `group,quantity,symbol,value,unit,formula,note`, then one line per figure, values in
/// SI with '.' as decimal sign; empty where there is none.
std::string sheetCsv(const FigureSheet& sheet);

}  // namespace rotorbench
