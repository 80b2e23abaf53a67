#include "ui/charts/run_arrivals.h"

#include <algorithm>

namespace rotorbench {

std::vector<std::shared_ptr<const Recording>> RunArrivals::take(const RunSet& runs) {
  std::vector<std::shared_ptr<const Recording>> arrived;
  std::vector<std::weak_ptr<const Recording>> present;
  for (const auto& run : runs.runs()) {
    if (!run.visible || !run.recording->finished()) continue;
    const bool known =
        std::ranges::any_of(present_, [&](const std::weak_ptr<const Recording>& before) {
          return before.lock() == run.recording;
        });
    if (!known) arrived.push_back(run.recording);
    present.emplace_back(run.recording);
  }
  present_ = std::move(present);
  return arrived;
}

}  // namespace rotorbench
