#include "ui/shell/planned_channels.h"

#include <QtConcurrentRun>
#include <set>

#include "sim/core/error.h"
#include "sim/document/flight.h"
#include "sim/run/hover_check.h"
#include "sim/run/simulation.h"

namespace rotorbench {

namespace {

// Several changes in a row are one build.
constexpr int kSettleMilliseconds = 200;

std::optional<std::vector<Channel>> channelsOf(Experiment experiment,
                                               const std::filesystem::path& directory) {
  try {
    // A map takes seconds to be made and has no channels of its own.
    if (auto* flight = alternativeIf<Flight>(experiment.setup))
      flight->vehicle = withoutMaps(std::move(flight->vehicle));
    const auto simulation = buildSimulation(experiment, directory);
    std::vector<Channel> all;
    std::set<std::string> seen;
    for (const RunOutput& run : simulation->runs()) {
      for (const Channel& channel : run.recording->channels()) {
        if (seen.insert(channel.name).second) all.push_back(channel);
      }
    }
    return all;
  } catch (const std::exception&) {
    return std::nullopt;  // Problems, or the run, says why
  }
}

}  // namespace

PlannedChannels::PlannedChannels(DocumentController& documents, QObject* parent)
    : QObject(parent), documents_(documents) {
  timer_.setSingleShot(true);
  timer_.setInterval(kSettleMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &PlannedChannels::build);
  connect(&building_, &QFutureWatcherBase::finished, this, &PlannedChannels::finish);
  connect(&documents_, &DocumentController::opened, this, &PlannedChannels::onOpened);
  DocumentModel& model = documents_.model();
  connect(&model, &DocumentModel::structureChanged, &timer_, qOverload<>(&QTimer::start));
  connect(&model, &DocumentModel::valueChanged, this, &PlannedChannels::onValueChanged);
  timer_.start();  // for the document there is before any is opened
}

void PlannedChannels::onOpened() {
  buildable_ = false;
  emit found({});
  build();
}

void PlannedChannels::onValueChanged(const QString& path) {
  const auto at = documents_.model().find(path);
  const bool number =
      at && at->field->isLeaf() && std::holds_alternative<double>(documents_.model().get(path));
  if (!number || !buildable_) timer_.start();
}

void PlannedChannels::build() {
  outdated_ = building_.isRunning();
  if (outdated_) return;
  // The job holds copies only: it may end after the window.
  building_.setFuture(
      QtConcurrent::run([experiment = documents_.experiment(), directory = documents_.directory()] {
        return channelsOf(experiment, directory);
      }));
}

void PlannedChannels::finish() {
  if (outdated_) return build();
  const Channels channels = building_.result();
  buildable_ = channels.has_value();
  // While a value is wrong the channels known before stay.
  if (channels) emit found(*channels);
}

}  // namespace rotorbench
