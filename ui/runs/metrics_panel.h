// The key figures of a run as a table: one row per figure, one column per run of the experiment,
// numbers in the reader's locale, SI units. Copies as aligned text or CSV (with '.' as decimal
// sign).
#pragma once

#include <QWidget>

#include "sim/core/metrics.h"

class QLabel;
class QStackedLayout;
class QTableWidget;

namespace rotorbench {

/// Figures side by side, matched by name; a figure a run does not have is "–".
void fillMetricsTable(QTableWidget& table, const MetricTable& metrics);

/// First line `metric,unit,RUN…`, then one line per figure with the shortest digits that read back
/// equal.
QString metricsCsv(const MetricTable& metrics);

class MetricsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MetricsPanel(QWidget* parent = nullptr);
  void setMetrics(const QString& runName, const MetricTable& metrics);

 public slots:
  void copyText();
  void copyCsv();

 private:
  MetricTable metrics_;
  QLabel* title_;
  QTableWidget* table_;
  QStackedLayout* pages_;
};

}  // namespace rotorbench
