// Which runs have come into the charts complete: at their end, by import, or shown again.
#pragma once

#include <memory>
#include <vector>

#include "ui/charts/run_set.h"

namespace rotorbench {

class RunArrivals {
 public:
  /// Visible, finished recordings that were not there at the last call.
  std::vector<std::shared_ptr<const Recording>> take(const RunSet& runs);

 private:
  std::vector<std::weak_ptr<const Recording>> present_;
};

}  // namespace rotorbench
