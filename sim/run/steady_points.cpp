#include "sim/run/steady_points.h"

namespace rotorbench {

std::vector<Channel> steadyChannels(const std::string& prefix) {
  std::vector<Channel> channels{{"throttle", "1", "Throttle"},
                                {"speed", "rad/s", "Angular speed"},
                                {"thrust", "N", "Thrust"},
                                {"torque", "N*m", "Torque of the load on the shaft"},
                                {"supply_voltage", "V", "Voltage of the supply under load"},
                                {"supply_current", "A", "Current drawn from the supply"},
                                {"motor_current", "A", "Current of the motor"},
                                {"electrical_power", "W", "Power drawn from the supply"},
                                {"shaft_power", "W", "Power delivered to the load"},
                                {"efficiency", "1", "Shaft power over electrical power"},
                                {"thrust_per_power", "N/W", "Thrust over electrical power"}};
  for (Channel& channel : channels) channel.name.insert(0, prefix + ".");
  return channels;
}

SteadyPoint readPoint(const DriveTrain& train, double throttle, const DriveTrain::State& y) {
  const DriveInstant<double> at = train.instant(y);
  const double w = y[DriveTrain::kSpeed];
  const double thrust = train.load().thrustAt(w), torque = train.load().torque(w);
  const double electrical = at.busVoltage * at.busCurrent, shaft = torque * w;
  const bool driven = electrical > 0;
  return {throttle,
          w,
          thrust,
          torque,
          at.busVoltage,
          at.busCurrent,
          at.current,
          electrical,
          shaft,
          driven ? shaft / electrical : 0,
          driven ? thrust / electrical : 0};
}

SteadyPoint steadyPoint(const DriveTrain& train, double throttle, double charge,
                        double polarisation) {
  return readPoint(train, throttle, train.steadyState(throttle, charge, polarisation));
}

std::array<double, kSteadyValues> rowOf(const SteadyPoint& p) {
  return {p.throttle,      p.speed,         p.thrust,        p.torque,
          p.supplyVoltage, p.supplyCurrent, p.motorCurrent,  p.electricalPower,
          p.shaftPower,    p.efficiency,    p.thrustPerPower};
}

void recordSteadyPoints(const DriveTrain& train, int points, Recording& recording) {
  for (int k = 0; k < points; ++k) {
    const double throttle = static_cast<double>(k) / (points - 1);
    recording.append(rowOf(steadyPoint(train, throttle, train.supply().charge, 0)));
  }
  recording.finish();
}

}  // namespace rotorbench
