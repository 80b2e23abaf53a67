// The page where experiments are worked on: charts in the middle, the other panels as docks round
// them that can be moved, floated, tabbed and closed. Owns the panels and their layout; what they
// show is wired elsewhere.
#pragma once

#include <QMainWindow>
#include <QSettings>

#include "ui/charts/run_set.h"
#include "ui/forms/document_model.h"
#include "ui/runs/run_list.h"

namespace rotorbench {

class ChartGrid;
class ExperimentPanel;
class LogPanel;
class MetricsPanel;
class ProblemsPanel;
class RunsPanel;
class ScenePanel;
class SignalTree;

class Workbench : public QMainWindow {
  Q_OBJECT

 public:
  Workbench(DocumentModel& model, RunList& runs, QWidget* parent = nullptr);
  ~Workbench() override;

  [[nodiscard]] RunSet& runSet() { return runSet_; }
  [[nodiscard]] ChartGrid& charts() { return *charts_; }
  [[nodiscard]] ExperimentPanel& experiment() { return *experiment_; }
  [[nodiscard]] ScenePanel& scene() { return *scene_; }
  [[nodiscard]] RunsPanel& runs() { return *runs_; }
  [[nodiscard]] SignalTree& signalTree() { return *signals_; }
  [[nodiscard]] ProblemsPanel& problems() { return *problems_; }
  [[nodiscard]] LogPanel& log() { return *log_; }
  [[nodiscard]] MetricsPanel& metrics() { return *metrics_; }

  /// Shows the dock that holds this panel and brings it to the front.
  void bringUp(QWidget& panel);
  /// Show and hide, one per dock.
  [[nodiscard]] QList<QAction*> panelActions() const;
  /// What the panel with the keyboard focus is about, most special first: topics of the help pages.
  [[nodiscard]] QStringList helpTopics(const DocumentModel& model) const;

  void saveLayout() const;
  void resetLayout();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void restoreLayout();
  QDockWidget* addPanel(QWidget* panel, const QString& title, Qt::DockWidgetArea area);
  void arrangeDefault();

  RunSet runSet_;
  QSettings unitSettings_;
  ChartGrid* charts_;
  ExperimentPanel* experiment_;
  ScenePanel* scene_;
  RunsPanel* runs_;
  SignalTree* signals_;
  ProblemsPanel* problems_;
  LogPanel* log_;
  MetricsPanel* metrics_;
  QList<QDockWidget*> docks_;
  bool laidOut_ = false;
};

}  // namespace rotorbench
