// What a flight controller is to the rest of the house: a task that reads the estimate and the
// set-point and asks rotor speeds of the speed controllers. A new one takes its own file, one
// alternative of ControllerParameters (sim/document/controlled_inputs.h) and one line in the
// factory (sim/run/controller_factory.cpp).
#pragma once

#include <string>
#include <vector>

#include "sim/signal/task.h"

namespace rotorbench {

/// A quantity that is to be at its set-point: metrics and charts find the pair by this, and the
/// flight is watched for leaving it.
struct HeldQuantity {
  std::string name;      ///< "altitude", begins the names of its figures
  std::string channel;   ///< "position.z"
  std::string setPoint;  ///< its set-point's channel: "setpoint.z"
  double limit = 0;      ///< how far it may move away from its set-point, in its unit
  bool turns = false;    ///< an angle given in (-pi, pi]: whole turns count
  /// Where both stand among the signals.
  const double& (*wanted)(const SetPoint&) = nullptr;
  const double& (*value)(const Truth&) = nullptr;
};

class Controller : public Task {
 public:
  using Task::Task;
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = Signal::Estimate | Signal::SetPoint,
            .writes = Signal::RotorDemand,
            .readsEarlier = {}};
  }
  [[nodiscard]] virtual std::vector<HeldQuantity> held() const = 0;
};

}  // namespace rotorbench
