// Pilots without a controller: rotor speeds or motor voltages as laid down in advance.
#pragma once

#include <utility>
#include <vector>

#include "sim/core/metrics.h"
#include "sim/core/recording.h"
#include "sim/experiment/flight_watch.h"
#include "sim/experiment/prescribed_inputs.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

/// Sets the rotor speeds at each tick; between two ticks they run straight if the signal does. A
/// jump of a held signal leaves the angular momentum of the whole and so turns the body, as an
/// infinitely strong motor would.
class SpeedPilot {
 public:
  using Plant = Multirotor<4, RotorDrive::PrescribedSpeeds>;
  explicit SpeedPilot(InputSignal signal) : signal_(std::move(signal)) {}

  [[nodiscard]] static std::vector<Channel> channels() { return {}; }
  [[nodiscard]] static std::vector<HeldQuantity> held() { return {}; }
  template <class See>
  static void watch(const Plant::State& /*y*/, const MultirotorForces<4>& /*forces*/, See&& see) {
    see(nullptr, nullptr);
  }
  static void row(double* /*out*/) {}
  static void figures(const Recording& /*recording*/, std::vector<Metric>& /*metrics*/) {}

  bool act(double t, double h, Plant& plant, Plant::State& y, Plant::State& derivative,
           MultirotorForces<4>& forces) {
    const Plant::Command now = signal_.at(t);
    const bool straight = signal_.interpolation() == Interpolation::Linear;
    const Plant::Command rate =
        straight ? Plant::Command((signal_.at(t + h) - now) / h) : Plant::Command::Zero();
    const bool jumped = rate != plant.command() || now != y.segment<4>(Plant::Layout::kSpeed);
    plant.setCommand(rate);
    Plant::setRotorSpeeds(y, now);
    if (jumped) plant.derivativeAndForces(y, derivative, forces);
    return jumped;
  }

 private:
  InputSignal signal_;
};

/// Applies motor voltages as duties of the supply's open-circuit voltage, so an internal resistance
/// lowers them under load; what the supply cannot give is cut off.
class VoltagePilot {
 public:
  using Plant = Multirotor<4, RotorDrive::Motors>;
  explicit VoltagePilot(InputSignal signal) : signal_(std::move(signal)) {}

  [[nodiscard]] static std::vector<Channel> channels() { return {}; }
  [[nodiscard]] static std::vector<HeldQuantity> held() { return {}; }
  template <class See>
  static void watch(const Plant::State& /*y*/, const MultirotorForces<4>& /*forces*/, See&& see) {
    see(nullptr, nullptr);
  }
  static void row(double* /*out*/) {}
  static void figures(const Recording& /*recording*/, std::vector<Metric>& /*metrics*/) {}

  Plant::Command command(double t, const Plant& plant, const Plant::State& y,
                         const MultirotorForces<4>& /*forces*/) {
    return signal_.at(t) / plant.openCircuit(y);
  }

 private:
  InputSignal signal_;
};

}  // namespace rotorbench
