// rotorbench-report: flies one experiment without anybody watching and leaves what a person would
// keep of it: recording, metrics, the charts and the 3D view. Exit codes as rotorbench-cli: 0 ok, 1
// the run failed, 2 the input is wrong.
#include <CLI/CLI.hpp>
#include <QApplication>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <iostream>

#include "app/rotorbench-cli/edits.h"
#include "app/rotorbench-report/window_picture.h"
#include "sim/document/resources.h"
#include "sim/io/metrics_output.h"
#include "sim/run/preflight.h"
#include "sim/run/run_files.h"
#include "sim/run/simulation.h"
#include "ui/shell/report.h"

namespace {

namespace fs = std::filesystem;
using namespace rotorbench;

constexpr int kOk = 0, kRunFailed = 1, kInputWrong = 2;

struct Options {
  std::string file, output = "rotorbench-output", window;
  std::vector<std::string> edits;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("FILE", options.file, "Experiment file; without one, the first of the gallery");
  app.add_option("--set", options.edits, "Change a parameter: path=value (repeatable)")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
  app.add_option("--output,-o", options.output, "Directory for the files")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--window", options.window, "Save only a picture of the window that flew FILE")
      ->type_name("PNG");
}

/// Settings, autosaved work and recent files of the user stay out of it. Before the QApplication.
void useOwnSettings(const QTemporaryDir& folder) {
  for (const char* name :
       {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"}) {
    qputenv(name, folder.filePath(name).toLocal8Bit());
  }
  QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setOrganizationName("Rotorbench");
  QApplication::setApplicationName("Rotorbench");
}

std::string flagship() {
  const auto shipped = shippedExperiments();
  if (shipped.empty()) throw std::runtime_error("The shipped experiments are missing.");
  return shipped.front().file.string();
}

int fly(const Options& options) {
  constexpr std::int64_t kSlice = 2000;
  const Experiment experiment = cli::loadEdited(options.file, options.edits);
  prepareRunDirectory(options.output);
  const auto simulation = buildSimulation(experiment, fs::path(options.file).parent_path());
  while (simulation->advance(kSlice) == SimulationState::Running) {
  }
  const RunSummary summary{simulation->metrics(), simulation->verdicts(), preflight(experiment),
                           simulation->events()};
  auto files = writeRunFiles(options.output, experiment, simulation->runs(), summary);
  for (auto& image : writeReportImages(experiment, simulation->runs(), options.output)) {
    files.push_back(std::move(image));
  }
  std::cout << experiment.title << "\n\n" << metricsText(summary.metrics) << "\nFiles:\n";
  for (const auto& file : files)
    std::cout << "  " << fs::absolute(file).lexically_normal().string() << '\n';
  if (simulation->failure()) {
    std::cerr << "The run failed at t = " << simulation->failure()->time
              << " s: " << simulation->failure()->message << '\n';
    return kRunFailed;
  }
  for (const Verdict& verdict : summary.verdicts)
    std::cerr << "The run did not go as asked: " << sentence(verdict) << '\n';
  return summary.verdicts.empty() ? kOk : kRunFailed;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App parser("Flies an experiment and leaves recording, metrics, charts and 3D view.",
                  "rotorbench-report");
  Options options;
  describe(parser, options);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parser.exit(error) == 0 ? kOk : kInputWrong;
  }
  const QTemporaryDir settings;
  useOwnSettings(settings);
  int qtArguments = 1;
  const QApplication app(qtArguments, argv);
  try {
    if (options.file.empty()) options.file = flagship();
    if (options.window.empty()) return fly(options);
    saveWindowPicture(options.file, options.window);
    return kOk;
  } catch (const InputError& error) {
    for (const auto& problem : error.problems()) {
      std::cerr << error.source() << (error.source().empty() ? "" : ":") << problem.message()
                << '\n';
    }
    return kInputWrong;
  } catch (const std::exception& error) {
    std::cerr << "rotorbench-report: " << error.what() << '\n';
    return kRunFailed;
  }
}
