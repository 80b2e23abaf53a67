#include "app/rotorbench-report/window_picture.h"

#include <QAction>
#include <QDeadlineTimer>
#include <QEventLoop>
#include <QPixmap>
#include <QTimer>
#include <functional>
#include <stdexcept>

#include "ui/scene/scene_panel.h"
#include "ui/shell/main_window.h"
#include "ui/shell/workbench.h"

namespace rotorbench {

namespace {

constexpr QSize kWindowSize{1600, 1000};
constexpr int kLongestWait = 60'000;  // ms
/// Time for the last rows to reach the charts and for the 3D view to draw its frames.
constexpr int kSettleTime = 3'000;  // ms
constexpr double kShownTime = 12;   // s, in the middle of the flagship's roll step

void letPass(int milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  loop.exec();
}

void waitUntil(const std::function<bool()>& done) {
  for (const QDeadlineTimer limit(kLongestWait); !done(); letPass(50)) {
    if (limit.hasExpired()) throw std::runtime_error("The run in the window did not finish.");
  }
}

}  // namespace

void saveWindowPicture(const std::filesystem::path& experiment,
                       const std::filesystem::path& picture) {
  MainWindow window;
  window.resize(kWindowSize);
  window.show();
  window.openFile(QString::fromStdString(experiment.string()));
  auto* run = window.findChild<QAction*>("actionRun");
  waitUntil([run] { return run->isEnabled(); });
  run->trigger();
  window.controller().setPace({});
  waitUntil([&window] { return window.controller().state() == RunState::Finished; });
  window.workbench().scene().setTime(kShownTime);
  letPass(kSettleTime);
  if (!window.grab().save(QString::fromStdString(picture.string()))) {
    throw std::runtime_error(picture.string() + " cannot be written.");
  }
}

}  // namespace rotorbench
