#include "ui/shell/live_flight.h"

#include "sim/core/schema_tree.h"
#include "sim/document/changes.h"
#include "sim/document/flight.h"
#include "ui/charts/run_set.h"
#include "ui/forms/experiment_panel.h"
#include "ui/runs/run_marks.h"
#include "ui/scene/hand_bar.h"
#include "ui/scene/playback_bar.h"
#include "ui/scene/scene_panel.h"
#include "ui/shell/document_controller.h"
#include "ui/shell/workbench.h"

namespace rotorbench {

LiveFlight::LiveFlight(DocumentController& documents, Workbench& bench, RunList& runs,
                       RunController& controller, QObject* parent)
    : QObject(parent), documents_(documents), bench_(bench), runs_(runs), controller_(controller) {
  DocumentModel& model = documents_.model();
  connect(&model, &DocumentModel::valueChanged, this, &LiveFlight::onDocumentChanged);
  connect(&model, &DocumentModel::structureChanged, this, &LiveFlight::onDocumentChanged);
  connect(&model, &DocumentModel::documentReplaced, this, &LiveFlight::end);
  connect(&controller_, &RunController::stateChanged, this, &LiveFlight::onStateChanged);
  connect(&controller_, &RunController::updated, this, &LiveFlight::onUpdated);
  connect(&runs_, &RunList::changesMade, this, &LiveFlight::showMarks);
  const HandBar& hand = bench_.scene().hand();
  connect(&hand, &HandBar::taken, this, [this](HandAxis axis, double value) {
    for (const Change& change : takenByHand(axis, value)) send(change);
  });
  connect(&hand, &HandBar::givenBack, this, [this](HandAxis axis) { send(givenBack(axis)); });
}

LiveFlight::~LiveFlight() = default;

void LiveFlight::onStateChanged(RunState state) {
  if (!isActive(state)) return end();
  if (run_ != controller_.currentRun()) begin();
}

void LiveFlight::begin() {
  end();
  run_ = controller_.currentRun();
  const RunRecord* record = runs_.find(run_);
  if (record == nullptr || !holdsAlternative<Flight>(record->experiment.setup)) return;
  const auto& flight = alternative<Flight>(record->experiment.setup);
  told_ = std::make_unique<Flight>(flight);
  refused_ = 0;
  bench_.experiment().setFlying(record->name);
  bench_.scene().hand().setFlying(hasSetPoints(flight));
}

void LiveFlight::end() {
  told_.reset();
  saidLater_.clear();
  bench_.experiment().setFlying({});
  bench_.scene().hand().setFlying(false);
}

void LiveFlight::onDocumentChanged() {
  if (!flies()) return;
  const Experiment& experiment = documents_.experiment();
  if (!holdsAlternative<Flight>(experiment.setup)) return;
  const auto& flight = alternative<Flight>(experiment.setup);
  LiveDifference difference = liveDifference(*told_, flight);
  for (const Change& change : difference.changes) {
    // A rule over several fields may hold again after the next edit.
    if (const auto problem = makeChange(*told_, change)) {
      emit message(
          tr("Not changed in the flight: %1").arg(QString::fromStdString(problem->message())));
    } else {
      send(change);
      // Text may be off by its last bit: told once is told.
      const auto value = schema::get(schema::ref(std::as_const(flight)), change.parameter);
      schema::set(schema::ref(*told_), change.parameter, value);
    }
  }
  const QString later = QString::fromStdString(difference.other);
  if (later == saidLater_) return;
  saidLater_ = later;
  if (!later.isEmpty()) emit message(tr("“%1” acts from the next run on.").arg(later));
}

void LiveFlight::send(const Change& change) {
  if (flies()) controller_.change(change);
}

void LiveFlight::onUpdated() {
  const RunStatus& status = controller_.status();
  if (status.refused.size() <= refused_) return;
  refused_ = status.refused.size();
  emit message(tr("Not changed in the flight: %1")
                   .arg(QString::fromStdString(status.refused.back().message())));
}

void LiveFlight::showMarks(int id) {
  const RunRecord* record = runs_.find(id);
  if (record == nullptr || !record->status.changes) return;
  bench_.runSet().setMarks(chartRunId(id, 0), marksOf(*record));
  if (id != run_) return;
  std::vector<double> times;
  for (const Change& change : *record->status.changes) times.push_back(change.time);
  bench_.scene().playback().setMarks(std::move(times));
}

}  // namespace rotorbench
