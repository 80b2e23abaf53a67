#include "ui/shell/workbench.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QTimer>
#include <algorithm>

#include "ui/charts/chart_grid.h"
#include "ui/charts/signal_tree.h"
#include "ui/forms/experiment_panel.h"
#include "ui/forms/parameter_form.h"
#include "ui/forms/problems_panel.h"
#include "ui/library/library_forms.h"
#include "ui/runs/metrics_panel.h"
#include "ui/runs/runs_panel.h"
#include "ui/scene/scene_panel.h"
#include "ui/shell/log_panel.h"

namespace rotorbench {

namespace {

constexpr auto kLayoutKey = "window/panels";
// Raised when docks are added or renamed, so that an old layout is not applied to new panels.
constexpr int kLayoutVersion = 1;
constexpr int kChartsAndForms = 1060, kLeastSceneWidth = 250;  // px

void appendTypeKeys(schema::ConstRef root, const DocumentModel& model, QString path,
                    QStringList& topics) {
  while (true) {
    if (const auto object = model.object(path)) topics << QString::fromStdString(object->type->key);
    const qsizetype dot = path.lastIndexOf('.');
    topics << path.mid(dot + 1).section('[', 0, 0);
    if (dot < 0) break;
    path.truncate(dot);
  }
  topics << QString::fromStdString(root.type->key);
}

}  // namespace

Workbench::Workbench(DocumentModel& model, RunList& runs, QWidget* parent)
    : QMainWindow(parent, Qt::Widget),
      charts_(new ChartGrid(&runSet_)),
      experiment_(new ExperimentPanel(&model, &unitSettings_)),
      scene_(new ScenePanel),
      runs_(new RunsPanel(runs)),
      signals_(new SignalTree(&runSet_)),
      problems_(new ProblemsPanel(&model)),
      log_(new LogPanel),
      metrics_(new MetricsPanel) {
  setObjectName("workbench");
  setDockOptions(AllowTabbedDocks | AllowNestedDocks | AnimatedDocks | GroupedDragging);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCentralWidget(charts_);
  connectLibrary(*experiment_, model);
  addPanel(experiment_, tr("Experiment"), Qt::LeftDockWidgetArea);
  addPanel(scene_, tr("3D scene"), Qt::RightDockWidgetArea);
  addPanel(runs_, tr("Runs"), Qt::RightDockWidgetArea);
  addPanel(signals_, tr("Signals"), Qt::RightDockWidgetArea);
  addPanel(problems_, tr("Problems"), Qt::BottomDockWidgetArea);
  addPanel(metrics_, tr("Metrics"), Qt::BottomDockWidgetArea);
  addPanel(log_, tr("Log"), Qt::BottomDockWidgetArea);
  arrangeDefault();
}

// Panels look at the run set until they are gone, so they go before it.
Workbench::~Workbench() {
  delete takeCentralWidget();
  qDeleteAll(docks_);
}

QDockWidget* Workbench::addPanel(QWidget* panel, const QString& title, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  if (panel->objectName().isEmpty())
    panel->setObjectName(QString(panel->metaObject()->className()));
  dock->setObjectName("dock:" + panel->objectName());
  dock->setWidget(panel);
  addDockWidget(area, dock);
  docks_ << dock;
  return dock;
}

void Workbench::arrangeDefault() {
  enum { Experiment, Scene, Runs, Signals, Problems, Metrics, Log };
  for (QDockWidget* dock : docks_) {
    dock->setFloating(false);
    dock->show();
  }
  addDockWidget(Qt::LeftDockWidgetArea, docks_[Experiment]);
  addDockWidget(Qt::RightDockWidgetArea, docks_[Scene]);
  splitDockWidget(docks_[Scene], docks_[Runs], Qt::Vertical);
  tabifyDockWidget(docks_[Runs], docks_[Signals]);
  addDockWidget(Qt::BottomDockWidgetArea, docks_[Problems]);
  tabifyDockWidget(docks_[Problems], docks_[Metrics]);
  tabifyDockWidget(docks_[Metrics], docks_[Log]);
  docks_[Runs]->raise();
  docks_[Metrics]->raise();
  // The charts need the width more than the scene does.
  const int scene = std::clamp(width() - kChartsAndForms, kLeastSceneWidth, 380);
  resizeDocks({docks_[Experiment], docks_[Scene]}, {scene > kLeastSceneWidth ? 330 : 300, scene},
              Qt::Horizontal);
  resizeDocks({docks_[Scene], docks_[Runs]}, {3, 2}, Qt::Vertical);
  resizeDocks({docks_[Metrics]}, {150}, Qt::Vertical);
}

void Workbench::bringUp(QWidget& panel) {
  for (QDockWidget* dock : docks_) {
    if (dock->widget() != &panel) continue;
    dock->show();
    dock->raise();
  }
}

QList<QAction*> Workbench::panelActions() const {
  QList<QAction*> actions;
  for (const QDockWidget* dock : docks_) actions << dock->toggleViewAction();
  return actions;
}

QStringList Workbench::helpTopics(const DocumentModel& model) const {
  QStringList topics;
  const QWidget* focus = QApplication::focusWidget();
  if (focus == nullptr || experiment_->isAncestorOf(focus)) {
    appendTypeKeys(model.root(), model, experiment_->form()->section(), topics);
    return topics;
  }
  for (const QWidget* widget = focus; widget != nullptr && widget != this;
       widget = widget->parentWidget()) {
    topics << widget->objectName();
  }
  return topics;
}

void Workbench::saveLayout() const {
  if (laidOut_) QSettings().setValue(kLayoutKey, saveState(kLayoutVersion));
}

// Sizes of docks can be given only once the page has its own.
void Workbench::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (laidOut_) return;
  laidOut_ = true;
  QTimer::singleShot(0, this, &Workbench::restoreLayout);
}

void Workbench::restoreLayout() {
  if (!restoreState(QSettings().value(kLayoutKey).toByteArray(), kLayoutVersion)) arrangeDefault();
}

void Workbench::resetLayout() {
  QSettings().remove(kLayoutKey);
  arrangeDefault();
}

}  // namespace rotorbench
