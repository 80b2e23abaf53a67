#include "sim/control/speed_controllers.h"

#include <algorithm>
#include <array>

namespace rotorbench {

namespace {

template <std::size_t N>
BasicMotorSpeedController<Lanes<static_cast<int>(N)>> bankOf(const MotorSpeedParameters& parameters,
                                                             const ControlModel& model) {
  std::array<ControlledMotor, N> motors;
  for (std::size_t i = 0; i < N; ++i)
    motors[i] = {model.motors[i], model.escs[i], model.rotorInertia[i], model.torqueFactor[i]};
  return {parameters, motors};
}

}  // namespace

SpeedControllers::SpeedControllers(const MotorSpeedParameters& parameters,
                                   const ControlModel& model, Timing timing)
    : Task("speed controllers", timing), motors_(bankOf<4>(parameters, model)) {
  if (model.rotors == 6) motors_ = bankOf<6>(parameters, model);
  if (model.rotors == 8) motors_ = bankOf<8>(parameters, model);
}

void SpeedControllers::act(const ClockTick& /*tick*/, Board& board, double* /*row*/) {
  update(board.demand, board.measurement.drives, board.command.value);
}

void SpeedControllers::retune(const MotorSpeedParameters& parameters) {
  std::visit([&](auto& bank) { bank.retune(parameters); }, motors_);
}

void SpeedControllers::update(const RotorDemand& demand, const DriveReadings& drives,
                              PerRotor& duties) {
  const double bus = std::max(drives.busVoltage, 1e-3);
  const auto act = [&]<int N>(BasicMotorSpeedController<Lanes<N>>& bank) {
    const Lanes<N> wanted = demand.speed.head<N>().array(), speed = drives.speed.head<N>().array();
    duties.head<N>() = (bank.update(wanted, speed, bus) / bus).matrix();
  };
  if (auto* four = std::get_if<Bank<4>>(&motors_)) return act(*four);
  if (auto* six = std::get_if<Bank<6>>(&motors_)) return act(*six);
  act(std::get<Bank<8>>(motors_));
}

}  // namespace rotorbench
