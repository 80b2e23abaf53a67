// The pilot of controller 1: sensors, set-points, controller; its channels and the figures of its
// step responses.
#pragma once

#include <string>
#include <vector>

#include "sim/control/pid_flight.h"
#include "sim/core/metrics.h"
#include "sim/core/recording.h"
#include "sim/experiment/flight_watch.h"
#include "sim/experiment/pid_control.h"
#include "sim/sensing/measurement.h"

namespace rotorbench {

class PidPilot {
 public:
  static constexpr int kRotors = 4;
  using Plant = Multirotor<kRotors, RotorDrive::Motors>;

  /// `planned`: the vehicle as the controller believes it to be, without deviations. Throws
  /// InputError if the rates do not fit the tick.
  PidPilot(const PidControl& control, const ControlModel<kRotors>& planned, double tick);

  [[nodiscard]] std::vector<Channel> channels() const;

  Plant::Command command(double t, const Plant& /*plant*/, const Plant::State& y,
                         const MultirotorForces<kRotors>& forces) {
    const Eigen::Vector4d wanted = signal_.at(t);
    setPoint_ = {wanted[0], wanted[1], wanted[2], wanted[3]};
    return controller_.update(sensors_.measure<kRotors>(y, forces), setPoint_);
  }

  void row(double* out) const {
    *out++ = setPoint_.height;
    *out++ = setPoint_.roll;
    *out++ = setPoint_.pitch;
    *out++ = setPoint_.yaw;
    controller_.visitOutputs(
        [&](int, const char*, const char*, const char*, double value) { *out++ = value; });
  }

  [[nodiscard]] static std::vector<HeldQuantity> held();
  /// Calls see(set-points, values) in the order of held(), for the plant as of the last command.
  template <class See>
  void watch(const Plant::State& y, const MultirotorForces<kRotors>& forces, See&& see) const {
    const double wanted[] = {setPoint_.height, setPoint_.roll, setPoint_.pitch, setPoint_.yaw};
    const double values[] = {y[Plant::Layout::kPosition + 2], forces.attitude[0],
                             forces.attitude[1], forces.attitude[2]};
    see(wanted, values);
  }

  /// Per axis the worst of all its steps: overshoot, settling time, error at rest.
  void figures(const Recording& recording, std::vector<Metric>& metrics) const;

 private:
  InputSignal signal_;  ///< height, roll, pitch, yaw
  std::vector<SetPointRow> rows_;
  PidFlightController<kRotors> controller_;
  IdealSensors sensors_;
  FlightSetPoint setPoint_;
};

}  // namespace rotorbench
