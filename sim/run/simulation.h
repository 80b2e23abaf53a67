// A running experiment, whatever its kind, behind one interface: the edge where types are erased.
// The window's worker thread and the command line both drive this and nothing else, so they compute
// the same bits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/metrics.h"
#include "sim/core/recording.h"
#include "sim/core/run_summary.h"

namespace rotorbench {

struct Change;
struct Experiment;

/// Channels that an experiment of this kind may have and this one has not, and a sentence that says
/// why.
struct AbsentChannels {
  std::string beginning;  ///< of their names
  std::string reason;
};

/// One curve set of an experiment: a flight has one run, a solver comparison one per method.
struct RunOutput {
  std::string name;
  std::shared_ptr<Recording> recording;  ///< readable from any thread while it grows
  std::vector<AbsentChannels> absent{};  ///< what another run of this kind may have
};

enum class SimulationState { Running, Finished, Failed };

struct Progress {
  double fraction = 0;   ///< 0..1 of the whole experiment
  double time = 0;       ///< simulated time in s of the run in progress
  std::string activity;  ///< "flying", "RK4 (2 of 6)"
};

class Simulation {
 public:
  virtual ~Simulation() = default;
  /// Computes at most `ticks` further ticks (one tick = tickSeconds() of simulated time) and
  /// publishes what was recorded. Never throws for what happens inside a run: a failure is kept and
  /// Failed returned.
  virtual SimulationState advance(std::int64_t ticks) = 0;
  /// Ends the run here as the user wishes: recordings are finished, metrics stay available.
  virtual void stop() = 0;
  [[nodiscard]] virtual SimulationState state() const = 0;
  [[nodiscard]] virtual Progress progress() const = 0;
  /// All runs, fixed from the start.
  [[nodiscard]] virtual const std::vector<RunOutput>& runs() const = 0;
  [[nodiscard]] virtual const std::optional<RunFailure>& failure() const = 0;
  /// Call from the driving thread; complete once the state is not Running.
  [[nodiscard]] virtual MetricTable metrics() const = 0;
  /// What the run came to that nobody asked for. From the driving thread, as metrics().
  [[nodiscard]] virtual std::vector<Verdict> verdicts() const { return {}; }
  /// What happened on the way, verdicts among it, in the order of time. From the driving thread.
  [[nodiscard]] virtual std::vector<RunEvent> events() const { return {}; }
  [[nodiscard]] virtual double tickSeconds() const = 0;

  /// Changes the experiment while it goes on, between two ticks: now, or when the change's time has
  /// come. Returns why not, where that cannot be. From the driving thread.
  virtual std::optional<Problem> change(const Change& change) = 0;
  /// All changes, laid down in the experiment or made since: the experiment with these repeats the
  /// run bit for bit. From the driving thread.
  [[nodiscard]] virtual const std::vector<Change>& changes() const = 0;
};

/// Builds the simulation an experiment describes. Throws InputError listing every problem. Files
/// the experiment names are looked for relative to `directory`.
std::unique_ptr<Simulation> buildSimulation(const Experiment& experiment,
                                            const std::filesystem::path& directory = {});

}  // namespace rotorbench
