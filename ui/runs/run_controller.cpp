#include "ui/runs/run_controller.h"

#include <utility>

namespace rotorbench {

namespace {
constexpr int kPollMilliseconds = 33;
}

RunController::RunController(RunList& runs, Builder builder, QObject* parent)
    : QObject(parent), runs_(runs), builder_(std::move(builder)) {
  timer_.setInterval(kPollMilliseconds);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &RunController::poll);
}

RunController::~RunController() = default;

int RunController::start(const Experiment& experiment, const std::filesystem::path& directory,
                         bool paused) {
  stopAndWait();
  current_ = runs_.add(experiment);
  rowSeconds_ = experiment.outputs.recordInterval;
  worker_ = std::make_unique<RunWorker>(
      [builder = builder_, experiment, directory] { return builder(experiment, directory); }, pace_,
      paused);
  timer_.start();
  takeStatus();
  return current_;
}

void RunController::pause() {
  if (worker_) worker_->pause();
}

void RunController::resume() {
  if (worker_) worker_->resume();
}

void RunController::step() {
  if (worker_) worker_->step(rowSeconds_);
}

void RunController::stop() {
  if (worker_) worker_->stop();
}

void RunController::stopAndWait() {
  if (!worker_) return;
  worker_->stop();
  worker_->wait();
  poll();
}

void RunController::setPace(Pace pace) {
  pace_ = pace;
  if (worker_) worker_->setPace(pace);
}

void RunController::change(const Change& change) {
  if (worker_) worker_->change(change);
}

void RunController::poll() {
  if (!worker_) return;
  takeStatus();
  if (isActive(status_.state)) return;
  timer_.stop();
  worker_.reset();
}

void RunController::takeStatus() {
  const RunState before = status_.state;
  status_ = worker_->status();
  runs_.setStatus(current_, status_);
  if (status_.state != before) emit stateChanged(status_.state);
  emit updated();
}

}  // namespace rotorbench
