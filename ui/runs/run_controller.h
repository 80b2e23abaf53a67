// Starts runs from the window, one at a time, and keeps the run's record in the RunList current by
// polling the worker at display rate.
#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>

#include "sim/run/simulation.h"
#include "ui/runs/run_list.h"

namespace rotorbench {

class RunController : public QObject {
  Q_OBJECT

 public:
  /// How an experiment becomes a simulation; tests give their own.
  using Builder = std::function<std::unique_ptr<Simulation>(
      const Experiment&, const std::filesystem::path& directory)>;

  explicit RunController(RunList& runs, Builder builder = buildSimulation,
                         QObject* parent = nullptr);
  /// Stops a run in progress and waits for it.
  ~RunController() override;

  /// Runs the experiment; a run in progress is stopped first. Files the experiment names are looked
  /// for in `directory`. Returns the id of the new record.
  int start(const Experiment& experiment, const std::filesystem::path& directory = {},
            bool paused = false);
  void pause();
  void resume();
  /// One recorded row further; starts nothing.
  void step();
  /// Ends the run at its next slice, some milliseconds later; updated() then shows it stopped.
  void stop();
  /// Ends the run and returns when its thread has ended.
  void stopAndWait();
  void setPace(Pace pace);
  /// Changes the flight in progress before its next tick; see RunWorker::change().
  void change(const Change& change);

  [[nodiscard]] Pace pace() const { return pace_; }
  [[nodiscard]] RunState state() const { return status_.state; }
  [[nodiscard]] const RunStatus& status() const { return status_; }
  /// Id of the run in progress or, after it, of the last one; 0 before the first.
  [[nodiscard]] int currentRun() const { return current_; }

 signals:
  void stateChanged(rotorbench::RunState state);
  /// At display rate while a run is in progress, and once at its end.
  void updated();

 private:
  void poll();
  void takeStatus();

  RunList& runs_;
  Builder builder_;
  Pace pace_;
  RunStatus status_;
  int current_ = 0;
  double rowSeconds_ = 0;
  QTimer timer_;
  std::unique_ptr<RunWorker> worker_;
};

}  // namespace rotorbench
