// The timeline of a flight as a task: set-points over time, or those a hand holds instead.
#pragma once

#include <string>
#include <vector>

#include "sim/analysis/step_response.h"
#include "sim/document/set_points.h"
#include "sim/signal/input_signal.h"
#include "sim/signal/task.h"

namespace rotorbench {

struct ControlledInputs;

class Timeline final : public Task {
 public:
  explicit Timeline(const ControlledInputs& inputs);
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = {}, .writes = Signal::SetPoint, .readsEarlier = {}};
  }
  [[nodiscard]] std::vector<Channel> channels() const override;
  void act(const ClockTick& tick, Board& board, double* row) override;

  /// Other rows and hands from the tick at `time` on.
  void take(const ControlledInputs& inputs, double time);
  /// What was asked in fact, as far as it is known now: rows with what hands made of them.
  [[nodiscard]] const std::vector<SetPointRow>& asked() const { return asked_; }

 private:
  /// Height, roll, pitch, yaw at a time.
  Eigen::Vector4d wantedAt(double time);
  void set(const ControlledInputs& inputs);
  [[nodiscard]] SetPointRow held(SetPointRow row) const;

  InputSignal<Eigen::Vector4d> signal_;
  HandSetPoints hand_;
  bool byHand_ = false;  ///< one of them is
  std::vector<SetPointRow> asked_;
};

/// When a set-point, named by its channel, changes, and to what.
std::vector<SetPointChange> changesOf(const std::vector<SetPointRow>& rows,
                                      const std::string& channel);

}  // namespace rotorbench
