// The rows of the shown curves of a chart that lie in its visible range.
#pragma once

#include <cstddef>

namespace rotorbench {

class ChartPane;

/// How many numbers paneCsv() would write.
std::size_t visibleCells(const ChartPane& pane);

}  // namespace rotorbench
