// The estimator that knows: it passes the true motion on.
#pragma once

#include "sim/signal/task.h"

namespace rotorbench {

/// Reads Truth, writes Estimate.
class TrueState final : public Task {
 public:
  TrueState() : Task("estimator", {}) {}
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = Signal::Truth, .writes = Signal::Estimate, .readsEarlier = {}};
  }
  void act(const ClockTick& /*tick*/, Board& board, double* /*row*/) override {
    board.estimate.body = board.truth.body;
  }
};

}  // namespace rotorbench
