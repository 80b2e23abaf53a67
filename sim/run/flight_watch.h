// Watches a flight for what no one asked for: below the ground, over on its back, a set-point left
// for good. It sees every tick, whatever is recorded. The flight goes on: there is no contact with
// the ground, and a vehicle may recover; but its figures must not be read as if nothing had been.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "sim/control/controller.h"
#include "sim/core/constants.h"
#include "sim/core/run_summary.h"

namespace rotorbench {

class FlightWatch {
 public:
  /// m below z = 0. A controller that starts on the ground dips by some centimetres before it holds
  /// the weight.
  static constexpr double kGroundDepth = 0.1;
  /// s for which a set-point must have been left by the end of the run.
  static constexpr double kLeastAbsence = 1;

  /// Watches the signals of `board`, which stays where it is. `held` is empty where inputs were
  /// laid down in advance: then any attitude is what was asked for.
  FlightWatch(std::vector<HeldQuantity> held, const Board& board);

  /// One tick at a time in s.
  void see(double time) {
    time_ = time;
    if (truth_.body.position[2] < -kGroundDepth && !(belowGround_ <= time)) [[unlikely]]
      belowGround_ = time;
    if (truth_.tiltCosine > 0) [[likely]]
      hasBeenUpright_ = true;
    else if (truth_.tiltCosine < 0 && hasBeenUpright_ && !(overturned_ <= time))
      overturned_ = time;
    for (Held& held : held_) follow(held);
  }

  /// As of the last tick seen, in the order of time.
  [[nodiscard]] std::vector<Verdict> verdicts() const;

 private:
  /// A set-point is left when the quantity is farther from it than where it was nearest, by more
  /// than its limit. Every move of the set-point itself is added to what is allowed, so that a step
  /// or a ramp is no departure.
  struct Held {
    const double *wantedNow, *valueNow;
    double limit;
    bool turns;
    double wanted = std::numeric_limits<double>::quiet_NaN();  ///< at the last tick; NaN: none yet
    double value = 0;                                          ///< at the last tick
    double error = 0;    ///< wanted - value; through whole turns
    double nearest = 0;  ///< least distance since, and what the set-point moved after it
    double near = 0;     ///< s, last time at which it was not farther than allowed
    std::string name;
  };
  /// The shortest way between two angles; mostly they are near each other.
  static double shortWay(double angle) {
    return std::abs(angle) <= kPi ? angle : std::remainder(angle, kTurn);
  }
  void follow(Held& h) {
    const double wanted = *h.wantedNow, value = *h.valueNow;
    // At most ticks the set-point stays.
    if (wanted != h.wanted) [[unlikely]]
      move(h, wanted, value);
    h.error = h.turns ? h.error - shortWay(value - h.value) : wanted - value;
    h.value = value;
    const double distance = std::abs(h.error);
    h.nearest = std::min(h.nearest, distance);
    if (distance <= h.nearest + h.limit) h.near = time_;
  }
  /// The set-point of this tick is another than at the last.
  static void move(Held& h, double wanted, double value);

  const Truth& truth_;
  std::vector<Held> held_;
  double time_ = 0;
  double belowGround_, overturned_;  ///< s; NaN while they have not been
  bool hasBeenUpright_ = false;
};

}  // namespace rotorbench
