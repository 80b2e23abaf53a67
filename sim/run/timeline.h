// The timeline of a flight as a task: set-points over time.
#pragma once

#include <string>
#include <vector>

#include "sim/analysis/step_response.h"
#include "sim/document/prescribed_inputs.h"
#include "sim/document/set_points.h"
#include "sim/signal/input_signal.h"
#include "sim/signal/task.h"

namespace rotorbench {

class Timeline final : public Task {
 public:
  Timeline(const std::vector<SetPointRow>& rows, Interpolation interpolation);
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = {}, .writes = Signal::SetPoint, .readsEarlier = {}};
  }
  [[nodiscard]] std::vector<Channel> channels() const override;
  void act(const ClockTick& tick, Board& board, double* row) override;

 private:
  InputSignal<Eigen::Vector4d> signal_;  ///< height, roll, pitch, yaw
};

/// When a set-point, named by its channel, changes, and to what.
std::vector<SetPointChange> changesOf(const std::vector<SetPointRow>& rows,
                                      const std::string& channel);

}  // namespace rotorbench
