#include "ui/shell/report.h"

#include <QDir>
#include <QFileInfo>

#include "sim/core/error.h"
#include "sim/document/default_charts.h"
#include "sim/scene/scene_model.h"
#include "ui/charts/chart_grid.h"
#include "ui/charts/export_figure.h"
#include "ui/runs/run_colors.h"
#include "ui/scene/scene_panel.h"

namespace rotorbench {

namespace {

constexpr QSize kGridSize{1400, 1000};
constexpr QSize kScenePicture{1280, 800};
/// The instant of the 3D picture, as part of the run: under way, where a flight is more than a dot
/// at rest.
constexpr double kSceneInstant = 0.4;

[[noreturn]] void fail(const QString& sentence) {
  throw InputError({}, {{"", sentence.toStdString(), "", false}});
}

void writeCharts(const Experiment& experiment, const std::vector<RunOutput>& runs,
                 const QString& folder) {
  RunSet set;
  std::vector<ChartRun> shown;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    shown.push_back({QString::number(i), QString::fromStdString(runs[i].name),
                     runColor(static_cast<int>(i)), runs[i].recording, true});
  }
  set.setRuns(std::move(shown));
  ChartGrid grid(&set);
  grid.resize(kGridSize);
  grid.setSpecs(chartsOf(experiment));
  grid.refresh();
  const QString problem = exportAllPanes(grid, folder, FigureFormat::Png);
  if (!problem.isEmpty()) fail(problem);
}

void writeScene(const SceneModel& model, const RunOutput& run, const QString& file) {
  ScenePanel panel;
  panel.resize(kScenePicture);
  panel.setModel(model);
  panel.setRecording(run.recording);
  const std::size_t rows = run.recording->rows();
  if (rows > 0) panel.setTime(kSceneInstant * run.recording->value(0, rows - 1));
  if (!panel.snapshot(kScenePicture).save(file)) fail(QString("“%1” cannot be written.").arg(file));
}

}  // namespace

std::vector<std::filesystem::path> writeReportImages(const Experiment& experiment,
                                                     const std::vector<RunOutput>& runs,
                                                     const std::filesystem::path& directory) {
  const QDir folder(QString::fromStdString(directory.string()));
  if (!folder.mkpath(".")) fail(QString("The folder “%1” cannot be made.").arg(folder.path()));
  const QDateTime begin = QDateTime::currentDateTime().addMSecs(-1000);
  writeCharts(experiment, runs, folder.path());
  const auto model = sceneModel(experiment);
  if (model && !runs.empty()) writeScene(*model, runs.front(), folder.filePath("scene.png"));
  std::vector<std::filesystem::path> files;
  for (const QFileInfo& info : folder.entryInfoList({"*.png"}, QDir::Files, QDir::Name)) {
    if (info.lastModified() >= begin) files.emplace_back(info.filePath().toStdString());
  }
  return files;
}

}  // namespace rotorbench
