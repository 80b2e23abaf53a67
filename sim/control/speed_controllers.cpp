#include "sim/control/speed_controllers.h"

#include <algorithm>

namespace rotorbench {

SpeedControllers::SpeedControllers(const MotorSpeedParameters& parameters,
                                   const ControlModel& model, Timing timing)
    : Task("speed controllers", timing) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.rotors); ++i) {
    motors_.emplace_back(parameters, model.motors[i], model.escs[i], model.rotorInertia[i],
                         model.torqueFactor[i]);
  }
}

void SpeedControllers::act(const ClockTick& /*tick*/, Board& board, double* /*row*/) {
  board.command.value = update(board.demand, board.measurement.drives);
}

PerRotor SpeedControllers::update(const RotorDemand& demand, const DriveReadings& drives) {
  PerRotor duties = PerRotor::Zero();
  const double bus = std::max(drives.busVoltage, 1e-3);
  for (std::size_t k = 0; k < motors_.size(); ++k) {
    const auto i = static_cast<int>(k);
    duties[i] = motors_[k].update(demand.speed[i], drives.speed[i], bus) / bus;
  }
  return duties;
}

}  // namespace rotorbench
