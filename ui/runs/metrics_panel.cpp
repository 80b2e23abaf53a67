#include "ui/runs/metrics_panel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QStackedLayout>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "sim/core/number_text.h"
#include "sim/io/metrics_output.h"

namespace rotorbench {

namespace {

/// Every figure once, in order of first appearance.
std::vector<const Metric*> figures(const MetricTable& metrics) {
  std::vector<const Metric*> found;
  for (const MetricRow& row : metrics) {
    for (const Metric& metric : row.metrics) {
      if (std::ranges::none_of(found, [&](const Metric* m) { return m->name == metric.name; })) {
        found.push_back(&metric);
      }
    }
  }
  return found;
}

const Metric* find(const MetricRow& row, const std::string& name) {
  const auto it = std::ranges::find(row.metrics, name, &Metric::name);
  return it == row.metrics.end() ? nullptr : &*it;
}

QString shown(const Metric* metric) {
  if (metric == nullptr || !std::isfinite(metric->value)) return QStringLiteral("–");
  if (metric->value == std::floor(metric->value) && std::abs(metric->value) < 1e9) {
    return QLocale().toString(metric->value, 'f', 0);
  }
  return QLocale().toString(metric->value, 'g', 6);
}

QTableWidgetItem* cell(const QString& text, Qt::Alignment alignment, const QString& tip = {}) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(alignment | Qt::AlignVCenter);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  item->setToolTip(tip);
  return item;
}

QString quoted(const std::string& text) {
  QString field = QString::fromStdString(text);
  if (field.contains(',') || field.contains('"') || field.contains('\n')) {
    field = '"' + field.replace('"', QStringLiteral("\"\"")) + '"';
  }
  return field;
}

}  // namespace

void fillMetricsTable(QTableWidget& table, const MetricTable& metrics) {
  const auto rows = figures(metrics);
  table.clear();
  table.setRowCount(static_cast<int>(rows.size()));
  table.setColumnCount(static_cast<int>(metrics.size()) + 2);
  QStringList headers{MetricsPanel::tr("Figure"), MetricsPanel::tr("Unit")};
  for (const MetricRow& run : metrics) headers << QString::fromStdString(run.run);
  table.setHorizontalHeaderLabels(headers);
  for (int r = 0; r < table.rowCount(); ++r) {
    const Metric& figure = *rows[static_cast<std::size_t>(r)];
    const QString tip = QString::fromStdString(figure.description);
    QString name = QString::fromStdString(figure.name);
    table.setItem(r, 0, cell(name.replace('_', ' '), Qt::AlignLeft, tip));
    const QString unit = figure.unit == "1" ? QString() : QString::fromStdString(figure.unit);
    table.setItem(r, 1, cell(unit, Qt::AlignLeft, tip));
    for (int c = 0; c < static_cast<int>(metrics.size()); ++c) {
      const Metric* metric = find(metrics[static_cast<std::size_t>(c)], figure.name);
      table.setItem(r, c + 2, cell(shown(metric), Qt::AlignRight, tip));
    }
  }
  table.resizeColumnsToContents();
}

QString metricsCsv(const MetricTable& metrics) {
  QString csv = QStringLiteral("metric,unit");
  for (const MetricRow& run : metrics) csv += ',' + quoted(run.run);
  csv += '\n';
  for (const Metric* figure : figures(metrics)) {
    csv += quoted(figure->name) + ',' + quoted(figure->unit);
    for (const MetricRow& run : metrics) {
      const Metric* metric = find(run, figure->name);
      csv += ',';
      if (metric != nullptr) csv += QString::fromStdString(numberText(metric->value));
    }
    csv += '\n';
  }
  return csv;
}

MetricsPanel::MetricsPanel(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel),
      table_(new QTableWidget),
      pages_(new QStackedLayout(this)) {
  setObjectName("metricsPanel");
  setAccessibleName(tr("Metrics"));
  auto* empty = new QLabel(tr("The key figures of a run appear here when it pauses or ends."));
  empty->setObjectName("metricsEmpty");
  empty->setAlignment(Qt::AlignCenter);
  empty->setWordWrap(true);
  empty->setForegroundRole(QPalette::PlaceholderText);

  auto* page = new QWidget;
  auto* text = new QPushButton(tr("Copy as text"));
  auto* csv = new QPushButton(tr("Copy as CSV"));
  text->setObjectName("copyMetricsText");
  csv->setObjectName("copyMetricsCsv");
  connect(text, &QPushButton::clicked, this, &MetricsPanel::copyText);
  connect(csv, &QPushButton::clicked, this, &MetricsPanel::copyCsv);
  auto* bar = new QHBoxLayout;
  bar->addWidget(title_, 1);
  bar->addWidget(text);
  bar->addWidget(csv);

  table_->setObjectName("metricsTable");
  table_->setAccessibleName(tr("Key figures"));
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->setSpacing(4);
  layout->addLayout(bar);
  layout->addWidget(table_, 1);

  pages_->addWidget(empty);
  pages_->addWidget(page);
}

void MetricsPanel::setMetrics(const QString& runName, const MetricTable& metrics) {
  metrics_ = metrics;
  title_->setText(runName);
  fillMetricsTable(*table_, metrics_);
  pages_->setCurrentIndex(metrics_.empty() ? 0 : 1);
}

void MetricsPanel::copyText() {
  QGuiApplication::clipboard()->setText(QString::fromStdString(metricsText(metrics_)));
}

void MetricsPanel::copyCsv() {
  QGuiApplication::clipboard()->setText(metricsCsv(metrics_));
}

}  // namespace rotorbench
