// Inputs laid down in advance as tasks: rotor speeds or motor voltages instead of a controller.
#pragma once

#include <utility>

#include "sim/run/load_inputs.h"
#include "sim/signal/task.h"

namespace rotorbench {

/// Prescribes the rotor speeds at each tick; between two ticks they run straight if the signal
/// does. A jump of a held signal leaves the angular momentum of the whole and so turns the body, as
/// an infinitely strong motor would.
class SpeedInputTask final : public Task {
 public:
  explicit SpeedInputTask(RotorInputs signal) : Task("inputs", {}), signal_(std::move(signal)) {}
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = {}, .writes = Signal::RotorCommand, .readsEarlier = {}};
  }
  void act(const ClockTick& tick, Board& board, double* /*row*/) override {
    const PerRotor now = signal_.at(tick.time);
    board.command.value = now;
    if (signal_.interpolation() == Interpolation::Linear)
      board.command.rate = (signal_.at(tick.time + tick.length) - now) / tick.length;
  }

 private:
  RotorInputs signal_;
};

/// Applies motor voltages as duties of the supply's open-circuit voltage, so an internal resistance
/// lowers them under load; what the supply cannot give is cut off.
class VoltageInputTask final : public Task {
 public:
  explicit VoltageInputTask(RotorInputs signal) : Task("inputs", {}), signal_(std::move(signal)) {}
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = Signal::Truth, .writes = Signal::RotorCommand, .readsEarlier = {}};
  }
  void act(const ClockTick& tick, Board& board, double* /*row*/) override {
    board.command.value = signal_.at(tick.time) / board.truth.openCircuit;
  }

 private:
  RotorInputs signal_;
};

}  // namespace rotorbench
