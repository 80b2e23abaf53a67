// How text becomes a cell of a table.
#pragma once

#include <string>

namespace rotorbench {

/// In quotes where it would end the cell or begin a comment.
std::string csvCell(const std::string& text);

}  // namespace rotorbench
