#include "ui/shell/run_desk.h"

#include <QLocale>
#include <algorithm>

#include "sim/document/flight.h"
#include "sim/run/preflight.h"
#include "sim/run/simulation.h"
#include "sim/scene/scene_model.h"
#include "ui/charts/chart_grid.h"
#include "ui/charts/signal_tree.h"
#include "ui/forms/experiment_panel.h"
#include "ui/forms/problems_panel.h"
#include "ui/forms/snapshot.h"
#include "ui/runs/metrics_panel.h"
#include "ui/runs/run_colors.h"
#include "ui/runs/run_marks.h"
#include "ui/runs/runs_panel.h"
#include "ui/scene/playback_bar.h"
#include "ui/scene/scene_panel.h"
#include "ui/shell/log_panel.h"

namespace rotorbench {

namespace {

constexpr int kRedrawMilliseconds = 150;

std::optional<SceneModel> vehicleOf(const Experiment& experiment) {
  try {
    return sceneModel(experiment);
  } catch (const InputError&) {
    return std::nullopt;  // Problems says why
  }
}

}  // namespace

RunDesk::RunDesk(DocumentController& documents, Workbench& bench, RunList& runs,
                 RunController& controller, QObject* parent)
    : QObject(parent),
      documents_(documents),
      bench_(bench),
      runs_(runs),
      controller_(controller),
      planned_(documents),
      live_(documents, bench, runs, controller) {
  DocumentModel& model = documents_.model();
  drawTimer_.setSingleShot(true);
  drawTimer_.setInterval(kRedrawMilliseconds);
  connect(&drawTimer_, &QTimer::timeout, this, &RunDesk::onDocumentChanged);
  connect(&model, &DocumentModel::valueChanged, &drawTimer_, qOverload<>(&QTimer::start));
  connect(&model, &DocumentModel::structureChanged, &drawTimer_, qOverload<>(&QTimer::start));
  connect(&documents_, &DocumentController::opened, this, &RunDesk::onDocumentOpened);
  model.setExtraValidator([this](schema::ConstRef) { return doubts(); });
  connect(&planned_, &PlannedChannels::found, this, [this](const std::vector<Channel>& channels) {
    bench_.signalTree().setPlanned(channels);
  });
  connect(&controller_, &RunController::updated, this, &RunDesk::onUpdated);
  connect(&controller_, &RunController::stateChanged, this, &RunDesk::onStateChanged);
  connect(&runs_, &RunList::runsChanged, this, &RunDesk::fillRunSet);
  connect(&bench_.runs(), &RunsPanel::duplicateRequested, this, &RunDesk::takeOver);
  connect(&bench_.runs(), &RunsPanel::selected, this, [this](int id) {
    showRun(id);
    showMetrics(id);
  });
  connect(&bench_.charts(), &ChartGrid::timeCursorMoved, &bench_.scene(), &ScenePanel::setTime);
  connect(&bench_.scene(), &ScenePanel::timeChanged, &bench_.charts(), &ChartGrid::setTimeCursor);
  connect(&bench_.signalTree(), &SignalTree::channelsActivated, &bench_.charts(),
          &ChartGrid::addChannels);
  connect(&bench_.charts(), &ChartGrid::message, this, &RunDesk::message);
  connect(&live_, &LiveFlight::message, this, &RunDesk::message);
  connect(&bench_.problems(), &ProblemsPanel::jumpTo, &bench_.experiment(),
          &ExperimentPanel::jumpTo);
  bench_.experiment().setChannelNames([this] {
    QStringList names;
    for (const Channel& channel : bench_.signalTree().offered())
      names << QString::fromStdString(channel.name);
    return names;
  });
}

RunDesk::~RunDesk() {
  documents_.model().setExtraValidator({});
}

bool RunDesk::isPaced(const Experiment& experiment) {
  return holdsAlternative<Flight>(experiment.setup);
}

void RunDesk::setPace(Pace pace) {
  pace_ = pace;
  if (isPaced(documents_.experiment())) controller_.setPace(pace_);
}

RunStatus RunDesk::status() const {
  return controller_.currentRun() > earlier_ ? controller_.status() : RunStatus{};
}

void RunDesk::run() {
  if (controller_.state() == RunState::Paused) return controller_.resume();
  if (!isActive(controller_.state())) start(false);
}

void RunDesk::step() {
  if (isActive(controller_.state())) return controller_.step();
  start(true);
  if (isActive(controller_.state())) controller_.step();
}

void RunDesk::start(bool paused) {
  documents_.model().commitPendingEdits();
  if (refuse()) return;
  controller_.setPace(isPaced(documents_.experiment()) ? pace_ : Pace{});
  const int id = controller_.start(documents_.experiment(), documents_.directory(), paused);
  bench_.log().add(tr("%1 started.").arg(runs_.find(id)->name));
  bench_.runs().select(id);
  showRun(id);
}

bool RunDesk::refuse() {
  if (!documents_.model().hasErrors()) return false;
  bench_.bringUp(bench_.problems());
  const auto& problems = documents_.model().problems();
  const auto first = std::ranges::find(problems, false, &Problem::warning);
  emit message(tr("Not run. %1").arg(QString::fromStdString(first->message())));
  return true;
}

void RunDesk::onDocumentOpened() {
  controller_.stop();
  earlier_ = controller_.currentRun();
  rejected_.reset();
  // Runs of another experiment stay in the list but leave the charts.
  for (const RunRecord& record : std::vector(runs_.records())) {
    if (!record.measured) runs_.setVisible(record.id, false);
  }
  runs_.setCurrentExperiment(documents_.experiment());
  shown_ = 0;
  bench_.metrics().setMetrics({}, {});
  drawDocument();
  fillRunSet();
  // How the other document was looked at is no view of this one. Last: the scene's time is a
  // cursor.
  bench_.scene().resetView();
  bench_.charts().resetView();
  bench_.signalTree().resetView();
  bench_.runs().clearSelection();
}

void RunDesk::onDocumentChanged() {
  runs_.setCurrentExperiment(documents_.experiment());
  if (shown_ == 0) drawDocument();
}

void RunDesk::onUpdated() {
  if (shown_ == controller_.currentRun() && !sceneBound_) showRun(shown_);
}

void RunDesk::onStateChanged(RunState state) {
  const int id = controller_.currentRun();
  const RunRecord* record = runs_.find(id);
  if (record == nullptr) return;
  if (state == RunState::Paused || !isActive(state)) {
    if (id == shown_) showMetrics(id);
    showMarks(*record);
  }
  if (!isActive(state)) noteEnd(*record);
}

void RunDesk::noteEnd(const RunRecord& record) {
  bench_.log().add(tr("%1: %2.").arg(record.name, runDetail(record)));
  const RunStatus& status = record.status;
  const QStringList verdicts = verdictTexts(status);
  // The first one is in the line above.
  for (const QString& verdict : verdicts.mid(1)) bench_.log().add(verdict);
  if (!verdicts.empty())
    emit message(tr("The run did not go as asked: %1.").arg(verdicts.join(", ")));
  if (status.failure) {
    const QString text = QString::fromStdString(status.failure->message);
    const QString part = QString::fromStdString(status.failure->component);
    bench_.log().add(part.isEmpty() ? text : tr("%1: %2").arg(part, text));
    emit message(text);
  }
  for (const Problem& problem : status.problems) {
    bench_.log().add(QString::fromStdString(problem.message()));
  }
  if (!status.problems.empty()) {
    reject(record);
    bench_.bringUp(bench_.problems());
  }
  if (status.changes && !status.changes->empty())
    bench_.log().add(tr("%1 changed %n time(s) while it went on; its experiment keeps them and "
                        "repeats it.",
                        nullptr, static_cast<int>(status.changes->size()))
                         .arg(record.name));
  for (const RunOutput& output : status.outputs) {
    if (output.recording->stride() > 1) {
      bench_.log().add(tr("%1 reached the memory limit: one row in %2 was kept at the end.")
                           .arg(QString::fromStdString(output.name))
                           .arg(output.recording->stride()));
    }
  }
}

// What only the build can find blocks the next run until an input changes.
void RunDesk::reject(const RunRecord& record) {
  rejected_ = {record.experiment, record.status.problems};
  documents_.model().recheck();
}

std::vector<Problem> RunDesk::doubts() const {
  const Experiment& experiment = documents_.experiment();
  if (rejected_ && sameInputs(rejected_->experiment, experiment)) return rejected_->problems;
  return runWarnings(experiment);
}

void RunDesk::showRun(int id) {
  const RunRecord* record = runs_.find(id);
  if (record == nullptr || record->measured) return;
  shown_ = id;
  sceneBound_ = !record->status.outputs.empty();
  bench_.scene().setModel(vehicleOf(record->experiment));
  if (!sceneBound_) return;
  bench_.scene().setRecording(record->status.outputs.front().recording);
  showMarks(*record);
  if (isActive(record->status.state)) bench_.scene().followLive(true);
}

// Each output has the marks of its run when the charts' runs are set; later ones come here.
void RunDesk::showMarks(const RunRecord& record) {
  const std::vector<RunMark> marks = marksOf(record);
  for (std::size_t i = 0; i < record.status.outputs.size(); ++i)
    bench_.runSet().setMarks(chartRunId(record.id, i), marks);
  if (record.id != shown_) return;
  std::vector<double> times;
  for (const RunMark& mark : marks) times.push_back(mark.time);
  bench_.scene().playback().setMarks(std::move(times));
}

void RunDesk::showMetrics(int id) {
  const RunRecord* record = runs_.find(id);
  if (record != nullptr && !record->measured)
    bench_.metrics().setMetrics(record->name, record->status.metrics);
}

// The runs of one experiment (the methods of a comparison) follow each other in the palette; the
// colour of the record is that of the first.
void RunDesk::fillRunSet() {
  std::vector<ChartRun> shown;
  const auto visible = std::ranges::count_if(runs_.records(), &RunRecord::visible);
  for (const RunRecord& record : runs_.records()) {
    // "RK4" alone, "RK4 (Run 2)" where another comparison is shown too.
    const QString whose = record.name.section(':', 0, 0);
    const auto& outputs = record.status.outputs;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      const QString part = QString::fromStdString(outputs[i].name);
      shown.push_back(
          {chartRunId(record.id, i),
           outputs.size() == 1 ? record.name
           : visible > 1       ? tr("%1 (%2)").arg(part, whose)
                               : part,
           outputs.size() > 1 ? runColor(record.id - 1 + static_cast<int>(i)) : record.color,
           outputs[i].recording, record.visible, record.measured, outputs[i].absent,
           marksOf(record)});
    }
  }
  // The oldest first, so that the newest is drawn on top.
  std::ranges::reverse(shown);
  bench_.runSet().setRuns(std::move(shown));
  if (shown_ != 0 && runs_.find(shown_) == nullptr) {
    shown_ = 0;
    drawDocument();
  }
}

void RunDesk::drawDocument() {
  bench_.scene().playback().setMarks({});
  bench_.scene().setRecording(nullptr);
  bench_.scene().setModel(vehicleOf(documents_.experiment()));
}

void RunDesk::takeOver(int id) {
  const RunRecord* record = runs_.find(id);
  if (record == nullptr) return;
  documents_.model().replaceObject({}, capture(schema::ref(record->experiment)),
                                   tr("Take over %1").arg(record->name));
  emit message(tr("The experiment of “%1” is in the editor.").arg(record->name));
}

}  // namespace rotorbench
