#include "ui/shell/chart_binding.h"

#include "sim/experiment/experiment.h"

namespace rotorbench {

namespace {
const QString kCharts = QStringLiteral("outputs.charts");
}

ChartBinding::ChartBinding(DocumentModel& model, ChartGrid& charts, QObject* parent)
    : QObject(parent), model_(model), charts_(charts) {
  const auto follow = [this](const QString& path) {
    if (isAtOrBelow(path, kCharts) || isAtOrBelow(kCharts, path)) toCharts();
  };
  connect(&model_, &DocumentModel::valueChanged, this, follow);
  connect(&model_, &DocumentModel::structureChanged, this, follow);
  connect(&model_, &DocumentModel::documentReplaced, this, &ChartBinding::toCharts);
  connect(&charts_, &ChartGrid::specsChanged, this, &ChartBinding::toDocument);
  toCharts();
}

void ChartBinding::toCharts() {
  const auto& wanted = model_.as<Experiment>().outputs.charts;
  if (!writing_ && charts_.specs() != wanted) charts_.setSpecs(wanted);
}

void ChartBinding::toDocument() {
  OutputSettings outputs = model_.as<Experiment>().outputs;
  if (outputs.charts == charts_.specs()) return;
  outputs.charts = charts_.specs();
  const schema::Field* field = schema::typeOf<OutputSettings>().field("charts");
  writing_ = true;
  model_.replaceRows(kCharts, capture(*field, &outputs), tr("Edit charts"));
  writing_ = false;
}

}  // namespace rotorbench
