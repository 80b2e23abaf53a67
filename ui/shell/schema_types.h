// Finds a described struct by its key anywhere below a type: members, alternatives and list
// elements.
#pragma once

#include <string_view>

#include "sim/core/schema.h"

namespace rotorbench {

/// Null if no type below `root` (or `root` itself) has this key.
const schema::Type* findType(const schema::Type& root, std::string_view key);

}  // namespace rotorbench
