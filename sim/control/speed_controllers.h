// The motor speed controllers of a vehicle as one task: they bring the rotors to the speeds a
// flight controller asks for.
#pragma once

#include <variant>

#include "sim/control/control_model.h"
#include "sim/control/motor_speed.h"
#include "sim/signal/task.h"

namespace rotorbench {

class SpeedControllers final : public Task {
 public:
  /// `timing` is that of parameters.rate.
  SpeedControllers(const MotorSpeedParameters& parameters, const ControlModel& model,
                   Timing timing);
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = Signal::Measurement | Signal::RotorDemand,
            .writes = Signal::RotorCommand,
            .readsEarlier = {}};
  }
  void act(const ClockTick& tick, Board& board, double* row) override;

  /// Other gains in the course of a flight, as BasicPid::retune(); rate and feed-forward stay.
  void retune(const MotorSpeedParameters& parameters);

  /// Duty of each motor, -1..1 where its speed controller is reversible, else 0..1.
  void update(const RotorDemand& demand, const DriveReadings& drives, PerRotor& duties);

 private:
  template <int N>
  using Bank = BasicMotorSpeedController<Lanes<N>>;
  std::variant<Bank<4>, Bank<6>, Bank<8>> motors_;
};

}  // namespace rotorbench
