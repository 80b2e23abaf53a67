#include "app/rotorbench-report/window_picture.h"

#include <QAction>
#include <QDeadlineTimer>
#include <QEventLoop>
#include <QPixmap>
#include <QTimer>
#include <stdexcept>

#include "ui/scene/scene_panel.h"
#include "ui/shell/main_window.h"
#include "ui/shell/workbench.h"

namespace rotorbench {

namespace {

constexpr QSize kWindowSize{1600, 1000};
constexpr int kRunLimit = 60'000;  // ms
/// Time for the last rows to reach the charts and for the 3D view to draw its frames.
constexpr int kSettleTime = 3'000;  // ms
constexpr double kShownTime = 12;   // s, in the middle of the flagship's roll step

void letPass(int milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  loop.exec();
}

}  // namespace

void saveWindowPicture(const std::filesystem::path& experiment,
                       const std::filesystem::path& picture) {
  MainWindow window;
  window.resize(kWindowSize);
  window.show();
  window.openFile(QString::fromStdString(experiment.string()));
  window.findChild<QAction*>("actionRun")->trigger();
  const QDeadlineTimer limit(kRunLimit);
  while (window.controller().state() != RunState::Finished) {
    letPass(50);
    if (limit.hasExpired() || window.controller().state() == RunState::Failed) {
      throw std::runtime_error("The run in the window did not finish.");
    }
  }
  window.workbench().scene().setTime(kShownTime);
  letPass(kSettleTime);
  if (!window.grab().save(QString::fromStdString(picture.string()))) {
    throw std::runtime_error(picture.string() + " cannot be written.");
  }
}

}  // namespace rotorbench
