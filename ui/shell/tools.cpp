#include "ui/shell/tools.h"

namespace rotorbench {

const std::vector<Tool>& tools() {
  static const std::vector<Tool> kTools{};
  return kTools;
}

}  // namespace rotorbench
