#include "ui/runs/compare_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>

#include "sim/core/schema_tree.h"
#include "ui/runs/metrics_panel.h"

namespace rotorbench {

namespace {

QTableWidget* makeTable(const char* name, const QString& accessibleName) {
  auto* table = new QTableWidget;
  table->setObjectName(name);
  table->setAccessibleName(accessibleName);
  table->verticalHeader()->hide();
  table->setAlternatingRowColors(true);
  table->setShowGrid(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  return table;
}

QWidget* titled(const QString& title, QWidget* content) {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* label = new QLabel(title);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  layout->addWidget(label);
  layout->addWidget(content, 1);
  return box;
}

void fillDifferences(QTableWidget& table, const std::vector<schema::Difference>& differences,
                     const QString& left, const QString& right) {
  table.setColumnCount(3);
  table.setHorizontalHeaderLabels({CompareDialog::tr("Input"), left, right});
  table.setRowCount(static_cast<int>(differences.size()));
  for (int row = 0; row < table.rowCount(); ++row) {
    const schema::Difference& difference = differences[static_cast<std::size_t>(row)];
    table.setItem(row, 0, new QTableWidgetItem(QString::fromStdString(difference.path)));
    table.setItem(row, 1, new QTableWidgetItem(QString::fromStdString(difference.left)));
    table.setItem(row, 2, new QTableWidgetItem(QString::fromStdString(difference.right)));
  }
  table.resizeColumnsToContents();
}

/// The rows of both runs, named after the run and, where an experiment has several, the method or
/// case.
MetricTable sideBySide(const RunRecord& left, const RunRecord& right) {
  MetricTable table;
  for (const RunRecord* record : {&left, &right}) {
    for (MetricRow row : record->status.metrics) {
      const std::string name = record->name.toStdString();
      row.run = record->status.metrics.size() > 1 ? name + "\n" + row.run : name;
      table.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace

CompareDialog::CompareDialog(const RunRecord& left, const RunRecord& right, QWidget* parent)
    : QDialog(parent) {
  setObjectName("compareDialog");
  setWindowTitle(tr("Compare runs"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(760, 560);
  const auto differences =
      schema::compare(schema::ref(left.experiment), schema::ref(right.experiment));
  auto* inputs = makeTable("compareInputs", tr("Inputs that differ"));
  fillDifferences(*inputs, differences, left.name, right.name);
  auto* figures = makeTable("compareMetrics", tr("Key figures of both runs"));
  fillMetricsTable(*figures, sideBySide(left, right));

  auto* splitter = new QSplitter(Qt::Vertical);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(titled(
      differences.empty() ? tr("The inputs of both runs are the same.")
                          : tr("%n input(s) differ", nullptr, static_cast<int>(differences.size())),
      inputs));
  splitter->addWidget(titled(tr("Key figures"), figures));
  splitter->setSizes({220, 340});
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(splitter, 1);
  layout->addWidget(buttons);
}

}  // namespace rotorbench
