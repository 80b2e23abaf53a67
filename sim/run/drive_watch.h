// Watches motors and supply of a flight for limits that act: full throttle, the limit of a current,
// a supply that gives out. It sees every tick, whatever is recorded. Limits act in good flights
// too, at the edge of a step: episodes, not verdicts; only a supply at 0 V is one.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "sim/core/run_summary.h"
#include "sim/signal/task.h"

namespace rotorbench {

/// Whiles in which something holds of some rotors, short gaps in them bridged.
class Episodes {
 public:
  /// s; what is shorter is the edge of a step and no episode, and so is a gap no gap.
  static constexpr double kLeast = 0.05, kGap = 0.1;
  /// Kept at most, so that a limit cycle does not fill the memory; the last one then goes on.
  static constexpr std::size_t kMost = 1000;

  /// A tick in which it holds of `rotors`, bit i for rotor i; bit 31 for no rotor in particular.
  void see(const ClockTick& tick, unsigned rotors) {
    if (rotors != 0) [[unlikely]]
      add(tick, rotors);
  }
  /// "motor 2 saturated", "motors 1 and 3 saturated" for "saturated".
  [[nodiscard]] std::vector<RunEvent> events(const std::string& name,
                                             const std::string& what) const;
  /// s, of all episodes together.
  [[nodiscard]] double seconds() const;

 private:
  struct Episode {
    double begin, end;
    unsigned rotors;
    [[nodiscard]] bool counts() const { return end - begin >= kLeast; }
  };
  void add(const ClockTick& tick, unsigned rotors);
  std::vector<Episode> all_;
};

class DriveWatch {
 public:
  struct Limits {
    int rotors = 0;
    /// A controller sets the throttle: full throttle is then more than was asked for.
    bool controlled = false;
    PerRotor current = PerRotor::Constant(std::numeric_limits<double>::infinity());  ///< A
  };

  /// Watches the signals of `board`, which stays where it is.
  DriveWatch(const Limits& limits, const Board& board) : limits_(limits), board_(board) {}

  /// One tick, its command given, at a voltage of the supply under load; `limited`: the controller
  /// asked for more than the rotors can give.
  void see(const ClockTick& tick, double bus, bool limited) {
    unsigned full = limited ? kNoRotor : 0, current = 0;
    for (int i = 0; i < limits_.rotors; ++i) {
      if (limits_.controlled && board_.command.value[i] >= kFull) full |= 1U << i;
      if (std::abs(board_.truth.drives.current[i]) >= kNear * limits_.current[i])
        current |= 1U << i;
    }
    full_.see(tick, full);
    current_.see(tick, current);
    if (bus <= 0 && !(gone_ <= tick.time)) [[unlikely]]
      gone_ = tick.time;
  }

  [[nodiscard]] std::vector<Verdict> verdicts() const;
  [[nodiscard]] std::vector<RunEvent> events() const;
  /// s in which some motor was at full throttle, or at the limit of its current.
  [[nodiscard]] double saturated() const { return full_.seconds(); }
  [[nodiscard]] double currentLimited() const { return current_.seconds(); }

 private:
  static constexpr unsigned kNoRotor = 1U << 31;
  static constexpr double kFull = 1 - 1e-9;
  /// The limit is kept by the voltage: the current comes near it and stays below.
  static constexpr double kNear = 0.99;

  Limits limits_;
  const Board& board_;
  Episodes full_, current_;
  double gone_ = std::numeric_limits<double>::quiet_NaN();  ///< s; NaN while it has not been
};

}  // namespace rotorbench
