// run --live: a flight that a program changes while it goes on, by lines on standard input.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "sim/run/run_worker.h"

namespace rotorbench::cli {

/// Help on the lines.
extern const char* const kLiveHelp;

/// Obeys lines for a worker; wrong ones are said on `errors` as "stdin:LINE: what; what is allowed"
/// and change nothing.
class LiveCommands {
 public:
  LiveCommands(RunWorker& worker, std::ostream& errors) : worker_(worker), errors_(errors) {}
  void obey(const std::string& line);
  [[nodiscard]] int wrong() const { return wrong_; }
  [[nodiscard]] bool paused() const { return paused_; }

 private:
  void refuse(const std::string& what, const std::string& allowed);
  /// A number from `least` to kMost, or 0 where `zero` is allowed; else the line is refused.
  bool number(const std::string& text, double least, bool zero, double& value);

  RunWorker& worker_;
  std::ostream& errors_;
  int line_ = 0, wrong_ = 0;
  bool paused_ = false;
};

/// Simulated seconds per second that can be kept at least and asked at most; times in s end there
/// too.
inline constexpr double kLeastPace = 1e-3, kMost = 1e6;

struct LiveRun {
  RunStatus status;
  int wrong = 0;  ///< lines and changes that could not be obeyed
};

/// Runs the simulation at `pace` under the lines of standard input, until it ends or `interrupted`
/// says so; `show` is called a few times a second.
LiveRun runLive(std::unique_ptr<Simulation> simulation, Pace pace,
                const std::function<bool()>& interrupted,
                const std::function<void(const Progress&)>& show);

}  // namespace rotorbench::cli
