#include "ui/shell/chart_binding.h"

#include "sim/document/default_charts.h"
#include "sim/document/experiment.h"

namespace rotorbench {

namespace {
const QString kCharts = QStringLiteral("outputs.charts");
const QString kSetup = QStringLiteral("setup");
}  // namespace

ChartBinding::ChartBinding(DocumentModel& model, ChartGrid& charts, QObject* parent)
    : QObject(parent), model_(model), charts_(charts) {
  const auto follow = [this](const QString& path) {
    // Another kind of experiment has other charts, where the document names none.
    if (isAtOrBelow(path, kCharts) || isAtOrBelow(kCharts, path) || path == kSetup) toCharts();
  };
  connect(&model_, &DocumentModel::valueChanged, this, follow);
  connect(&model_, &DocumentModel::structureChanged, this, follow);
  connect(&model_, &DocumentModel::documentReplaced, this, &ChartBinding::toCharts);
  connect(&charts_, &ChartGrid::specsChanged, this, &ChartBinding::toDocument);
  toCharts();
}

void ChartBinding::toCharts() {
  const std::vector<ChartSpec> wanted = chartsOf(model_.as<Experiment>());
  if (!writing_ && charts_.specs() != wanted) charts_.setSpecs(wanted);
}

void ChartBinding::toDocument() {
  const auto& experiment = model_.as<Experiment>();
  if (chartsOf(experiment) == charts_.specs()) return;
  OutputSettings outputs = experiment.outputs;
  outputs.charts = charts_.specs();
  const schema::Field* field = schema::typeOf<OutputSettings>().field("charts");
  writing_ = true;
  model_.replaceRows(kCharts, capture(*field, &outputs), tr("Edit charts"));
  writing_ = false;
}

}  // namespace rotorbench
