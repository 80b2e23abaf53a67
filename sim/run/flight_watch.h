// Watches a flight for what no one asked for: below the ground, over on its back, a set-point left
// for good. It sees every tick, whatever is recorded. The flight goes on: there is no contact with
// the ground, and a vehicle may recover; but its figures must not be read as if nothing had been.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/control/controller.h"
#include "sim/core/run_summary.h"

namespace rotorbench {

class FlightWatch {
 public:
  /// m below z = 0. A controller that starts on the ground dips by some centimetres before it holds
  /// the weight.
  static constexpr double kGroundDepth = 0.1;
  /// s for which a set-point must have been left by the end of the run.
  static constexpr double kLeastAbsence = 1;

  /// `held` is empty where inputs were laid down in advance: then any attitude is what was asked
  /// for.
  explicit FlightWatch(std::vector<HeldQuantity> held);

  /// One tick at a time in s.
  void see(double time, const Truth& truth, const SetPoint& setPoint) {
    time_ = time;
    if (truth.body.position[2] < -kGroundDepth && !(belowGround_ <= time)) belowGround_ = time;
    if (truth.tiltCosine > 0) hasBeenUpright_ = true;
    if (truth.tiltCosine < 0 && hasBeenUpright_ && !(overturned_ <= time)) overturned_ = time;
    for (Held& held : held_)
      follow(held, held.quantity.wanted(setPoint), held.quantity.value(truth));
  }

  /// As of the last tick seen, in the order of time.
  [[nodiscard]] std::vector<Verdict> verdicts() const;

 private:
  /// A set-point is left when the quantity is farther from it than where it was nearest, by more
  /// than its limit. Every move of the set-point itself is added to what is allowed, so that a step
  /// or a ramp is no departure.
  struct Held {
    HeldQuantity quantity;
    bool started = false;
    double wanted = 0, value = 0;  ///< at the last tick
    double error = 0;              ///< wanted - value; through whole turns
    double nearest = 0;            ///< least distance since, and what the set-point moved after it
    double near = 0;               ///< s, last time at which it was not farther than allowed
  };
  /// The shortest way between two angles; mostly they are near each other.
  static double shortWay(double angle) {
    return std::abs(angle) <= std::numbers::pi ? angle
                                               : std::remainder(angle, 2 * std::numbers::pi);
  }
  void follow(Held& h, double wanted, double value) {
    const double moved = h.quantity.turns ? shortWay(wanted - h.wanted) : wanted - h.wanted;
    if (!h.started || !h.quantity.turns) {
      h.error = h.quantity.turns ? shortWay(wanted - value) : wanted - value;
    } else {
      h.error += moved - shortWay(value - h.value);
    }
    const double distance = std::abs(h.error);
    h.nearest = h.started ? std::min(h.nearest + std::abs(moved), distance) : distance;
    h.started = true;
    h.wanted = wanted;
    h.value = value;
    if (distance <= h.nearest + h.quantity.limit) h.near = time_;
  }

  std::vector<Held> held_;
  double time_ = 0;
  double belowGround_, overturned_;  ///< s; NaN while they have not been
  bool hasBeenUpright_ = false;
};

}  // namespace rotorbench
