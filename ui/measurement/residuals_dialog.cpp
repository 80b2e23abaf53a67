#include "ui/measurement/residuals_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "sim/logs/measured_table.h"
#include "sim/logs/residuals.h"
#include "sim/run/simulation.h"
#include "ui/charts/chart_pane.h"
#include "ui/forms/field_text.h"
#include "ui/measurement/table_cell.h"
#include "ui/runs/run_colors.h"

namespace rotorbench {

namespace {

Series seriesOf(const Recording& recording, std::size_t x, std::size_t y) {
  const MeasuredTable table = tableOf(recording, {});
  return {table.columns[x], table.columns[y]};
}

ResidualReport reportOf(const Recording& measured, const Recording& computed, std::size_t channel) {
  const std::string& x = measured.channels().front().name;
  const std::string& y = measured.channels()[channel].name;
  return compareSeries(seriesOf(measured, 0, channel),
                       seriesOf(computed, *computed.find(x), *computed.find(y)));
}

bool isCommon(const Recording& measured, const Recording& computed, std::size_t channel) {
  const Channel& y = measured.channels()[channel];
  const auto at = computed.find(y.name);
  return at && computed.channels()[*at].unit == y.unit;
}

}  // namespace

ResidualsDialog::ResidualsDialog(const RunList& runs, QWidget* parent) : QDialog(parent) {
  setObjectName("residualsDialog");
  setWindowTitle(tr("Compare with measurement"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(820, 640);
  for (const RunRecord& record : runs.records()) {
    for (const RunOutput& output : record.status.outputs) {
      const QString part = record.status.outputs.size() > 1
                               ? tr("%1, %2").arg(record.name, toQString(output.name))
                               : record.name;
      (record.measured ? measured_ : computed_).push_back({part, output.recording});
    }
  }
  build();
  fillComputed();
}

ResidualsDialog::~ResidualsDialog() {
  delete chart_;  // it looks at the runs and the link
}

void ResidualsDialog::build() {
  const auto box = [&](const char* name, const QString& label) {
    auto* combo = new QComboBox;
    combo->setObjectName(name);
    combo->setAccessibleName(label);
    return combo;
  };
  measuredBox_ = box("residualsMeasured", tr("Measured"));
  computedBox_ = box("residualsComputed", tr("Computed"));
  for (const Choice& choice : measured_) measuredBox_->addItem(choice.name);
  auto* form = new QFormLayout;
  form->addRow(tr("Measured:"), measuredBox_);
  form->addRow(tr("Computed:"), computedBox_);

  table_ = new QTableWidget(0, 7);
  table_->setObjectName("residualsTable");
  table_->setAccessibleName(tr("How far measured and computed are apart"));
  table_->setHorizontalHeaderLabels({tr("Channel"), tr("Unit"), tr("Points"), tr("RMSE"),
                                     tr("Mean error"), tr("Largest"), tr("R²")});
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  sentence_ = new QLabel;
  sentence_->setObjectName("residualsSentence");
  sentence_->setWordWrap(true);
  sentence_->setTextFormat(Qt::PlainText);
  chart_ = new ChartPane(&chartRuns_, &link_);
  chart_->setObjectName("residualsChart");
  auto* splitter = new QSplitter(Qt::Vertical);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(table_);
  splitter->addWidget(chart_);
  splitter->setSizes({220, 300});
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(sentence_);
  layout->addWidget(splitter, 1);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(measuredBox_, &QComboBox::currentIndexChanged, this, &ResidualsDialog::fillComputed);
  connect(computedBox_, &QComboBox::currentIndexChanged, this, &ResidualsDialog::compare);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &ResidualsDialog::showChannel);
}

void ResidualsDialog::fillComputed() {
  offered_.clear();
  const QSignalBlocker quiet(computedBox_);
  computedBox_->clear();
  if (measuredBox_->currentIndex() >= 0) {
    const Recording& measured =
        *measured_[static_cast<std::size_t>(measuredBox_->currentIndex())].recording;
    for (const Choice& choice : computed_) {
      if (!choice.recording->find(measured.channels().front().name)) continue;
      offered_.push_back(choice);
      computedBox_->addItem(choice.name);
    }
  }
  compare();
}

void ResidualsDialog::compare() {
  table_->setRowCount(0);
  chartRuns_.setRuns({});
  sentence_->setVisible(true);
  if (offered_.empty()) {
    sentence_->setText(
        measured_.empty()
            ? tr("There are no measured data yet: import them first.")
            : tr("No run has the horizontal axis of the measured data. Run the "
                 "experiment, or import the data to be compared with what it gives."));
    return;
  }
  const Recording& measured =
      *measured_[static_cast<std::size_t>(measuredBox_->currentIndex())].recording;
  const Recording& computed =
      *offered_[static_cast<std::size_t>(computedBox_->currentIndex())].recording;
  QStringList sentences;
  const QLocale locale;
  for (std::size_t c = 1; c < measured.channels().size(); ++c) {
    if (!isCommon(measured, computed, c)) continue;
    const ResidualReport report = reportOf(measured, computed, c);
    const ResidualFigures& f = report.figures;
    const Channel& channel = measured.channels()[c];
    for (const std::string& s : report.sentences)
      sentences << tr("%1: %2").arg(toQString(channel.name), toQString(s));
    const int row = table_->rowCount();
    table_->insertRow(row);
    table_->setItem(row, 0, tableCell(toQString(channel.name), false));
    table_->item(row, 0)->setData(Qt::UserRole, static_cast<int>(c));
    table_->setItem(row, 1, tableCell(prettyUnit(toQString(channel.unit)), false));
    table_->setItem(row, 2, tableCell(locale.toString(static_cast<int>(f.count)), true));
    const std::array figures{f.rmse, f.mean, f.mostApart, f.rSquared};
    for (int i = 0; i < 4; ++i) {
      const double value = figures[static_cast<std::size_t>(i)];
      const bool has = f.count > 0 && std::isfinite(value);
      table_->setItem(row, 3 + i, tableCell(has ? locale.toString(value, 'g', 4) : tr("–"), true));
    }
  }
  if (table_->rowCount() == 0) sentences << tr("The two have no other channel in common.");
  sentence_->setText(sentences.join('\n'));
  sentence_->setVisible(!sentences.isEmpty());
  table_->resizeColumnsToContents();
  table_->selectRow(0);
}

void ResidualsDialog::showChannel() {
  const QTableWidgetItem* item = table_->item(table_->currentRow(), 0);
  if (item == nullptr || offered_.empty()) return;
  const auto channel = static_cast<std::size_t>(item->data(Qt::UserRole).toInt());
  const Recording& measured =
      *measured_[static_cast<std::size_t>(measuredBox_->currentIndex())].recording;
  const Recording& computed =
      *offered_[static_cast<std::size_t>(computedBox_->currentIndex())].recording;
  const ResidualReport report = reportOf(measured, computed, channel);
  MeasuredTable table;
  table.channels = {measured.channels().front(), measured.channels()[channel]};
  table.channels[1].name = "residual";
  table.columns = {report.x, {}};
  for (std::size_t i = 0; i < report.x.size(); ++i) table.columns[1].push_back(report.residual(i));
  ChartSpec spec;
  spec.title = tr("Measured less computed: %1").arg(item->text()).toStdString();
  spec.kind = ChartKind::XY;
  spec.x = table.channels.front().name;
  spec.channels = "residual";
  chart_->setSpec(spec);
  chartRuns_.setRuns({{"residual", tr("Residual"), runColor(0), recordingOf(table), true, true}});
  chart_->refresh();
}

}  // namespace rotorbench
