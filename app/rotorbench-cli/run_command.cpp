// run: flies an experiment to its end or to Ctrl-C, then prints and writes what came of it.
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>

#include "app/rotorbench-cli/commands.h"
#include "app/rotorbench-cli/edits.h"
#include "app/rotorbench-cli/live_run.h"
#include "sim/document/changes.h"
#include "sim/document/flight.h"
#include "sim/io/metrics_output.h"
#include "sim/run/preflight.h"
#include "sim/run/run_files.h"
#include "sim/run/simulation.h"

namespace rotorbench::cli {

namespace {

struct RunOptions {
  std::string file, output, format = "text";
  std::vector<std::string> edits;
  bool live = false;
  double pace = 1;
};

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "written by a signal handler");

void onInterrupt(int /*signal*/) {
  // A second Ctrl-C ends the program the ordinary way.
  std::signal(SIGINT, SIG_DFL);
  interrupted.store(true);
}

/// One line on a terminal, rewritten in place at most ten times a second; nothing if stderr is a
/// file or pipe.
class ProgressLine {
 public:
  void show(const Progress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, "\r%3.0f %%  t = %.2f s  %s\033[K", 100 * progress.fraction, progress.time,
                 progress.activity.c_str());
    std::fflush(stderr);
  }
  void clear() const {
    if (shown_) std::fputs("\r\033[K", stderr);
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

/// What came of a run.
struct Outcome {
  std::vector<RunOutput> runs;
  RunSummary summary;
  std::vector<Change> changes;
  std::optional<RunFailure> failure;
  double time = 0;  ///< s, at the end
  bool wrong = false;
};

Outcome drive(Simulation& simulation) {
  // Small enough for Ctrl-C and the progress line, large enough not to cost anything.
  constexpr std::int64_t kSlice = 2000;
  ProgressLine line;
  while (simulation.advance(kSlice) == SimulationState::Running) {
    line.show(simulation.progress());
    if (interrupted.load()) simulation.stop();
  }
  line.clear();
  return {simulation.runs(),
          {simulation.metrics(), simulation.verdicts(), {}, simulation.events()},
          simulation.changes(),
          simulation.failure(),
          simulation.progress().time};
}

Outcome driveLive(std::unique_ptr<Simulation> simulation, Pace pace) {
  ProgressLine line;
  LiveRun live = runLive(
      std::move(simulation), pace, [] { return interrupted.load(); },
      [&line](const Progress& progress) { line.show(progress); });
  line.clear();
  RunStatus& status = live.status;
  return {status.outputs,       {status.metrics, status.verdicts, {}, status.events},
          *status.changes,      status.failure,
          status.progress.time, live.wrong > 0};
}

int report(const Outcome& outcome) {
  for (const Verdict& verdict : outcome.summary.verdicts)
    std::fprintf(stderr, "The run did not go as asked: %s\n", sentence(verdict).c_str());
  // Limits act in good flights too, and the metrics tell of them; a recording of fewer rows than
  // asked for is another matter.
  for (const RunEvent& event : outcome.summary.events)
    if (event.name == "recording_thinned")
      std::fprintf(stderr, "Note: %s\n", sentence(event).c_str());
  if (outcome.failure) {
    const auto& failure = *outcome.failure;
    std::fprintf(stderr, "The run failed at t = %.6g s: %s: %s\n", failure.time,
                 failure.component.c_str(), failure.message.c_str());
    return kRunFailed;
  }
  if (interrupted.load()) {
    std::fprintf(stderr, "Interrupted at t = %.6g s; what was recorded until then is kept.\n",
                 outcome.time);
    return kRunFailed;
  }
  if (!outcome.summary.verdicts.empty()) return kRunFailed;
  return outcome.wrong ? kInputWrong : kOk;
}

int run(const RunOptions& options) {
  Experiment experiment = loadEdited(options.file, options.edits);
  const auto directory = experimentFile(options.file).parent_path();
  std::unique_ptr<Simulation> simulation;
  try {
    simulation = buildSimulation(experiment, directory);
  } catch (const InputError& error) {
    throw InputError(error.source().empty() ? options.file : error.source(), error.problems());
  }
  if (options.live && !holdsAlternative<Flight>(experiment.setup))
    throw InputError(options.file,
                     {{"setup.type", "is no flight", "only flights run with --live"}});
  if (!options.output.empty()) prepareRunDirectory(options.output);
  std::signal(SIGINT, onInterrupt);
  Outcome outcome =
      options.live ? driveLive(std::move(simulation), {options.pace}) : drive(*simulation);
  const int code = report(outcome);

  RunSummary& summary = outcome.summary;
  summary.warnings = preflight(experiment);
  setChanges(experiment, outcome.changes);
  if (!options.output.empty()) {
    for (const auto& file : writeRunFiles(options.output, experiment, outcome.runs, summary)) {
      std::cerr << "wrote " << file.string() << '\n';
    }
  }
  if (options.format == "json") {
    std::cout << metricsJson(experiment.title, summary);
  } else if (options.format == "csv") {
    writeRunsCsv(std::cout, outcome.runs);
  } else {
    std::cout << metricsText(summary.metrics);
  }
  std::cout.flush();
  return std::cout ? code : kRunFailed;
}

}  // namespace

void addRunCommand(CLI::App& app, int& code) {
  auto options = std::make_shared<RunOptions>();
  auto* command = app.add_subcommand("run", "Run an experiment file");
  command->add_option("FILE", options->file, kExperimentHelp)->required();
  command->add_option("--set", options->edits, "Change a parameter: path=value (repeatable)")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
  command
      ->add_option("--output,-o", options->output,
                   "Directory for experiment, recording (CSV) and metrics")
      ->type_name("DIR");
  command
      ->add_option("--format,-f", options->format,
                   "What to print: text or json metrics, or the recording as csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  auto* live = command->add_flag("--live", options->live, kLiveHelp);
  command
      ->add_option("--pace", options->pace,
                   "With --live: simulated seconds per second; 0 is as fast as possible")
      ->check(CLI::Range(kLeastPace, kMost) | CLI::IsMember({"0"}))
      ->needs(live)
      ->type_name("FACTOR");
  command->callback([options, &code] { code = run(*options); });
}

}  // namespace rotorbench::cli
