// From the start of the process to the first paint of the window, as a person waits for it: under a
// display (Xvfb will do), with settings of its own. Prints milliseconds since the kernel started
// the process; exits then.
//   xvfb-run -a first_paint
#include <unistd.h>

#include <QApplication>
#include <QPaintEvent>
#include <QTemporaryDir>
#include <QTimer>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>

#include "ui/shell/main_window.h"

namespace {

/// Seconds since boot at which this process started: field 22 of /proc/self/stat (see proc(5)), in
/// clock ticks.
double processStart() {
  std::ifstream stat("/proc/self/stat");
  std::string line;
  std::getline(stat, line);
  line.erase(0, line.rfind(')') + 2);
  for (int field = 3; field < 22; ++field) line.erase(0, line.find(' ') + 1);
  return std::stod(line) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double sinceBoot() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class FirstPaint : public QObject {
 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint && !seen_) {
      seen_ = true;
      // After this paint and those of the children are done.
      QTimer::singleShot(0, qApp, [] {
        std::printf("first paint after %.0f ms\n", 1e3 * (sinceBoot() - processStart()));
        QApplication::quit();
      });
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  bool seen_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  const QTemporaryDir folder;
  for (const char* name :
       {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"}) {
    qputenv(name, folder.filePath(name).toLocal8Bit());
  }
  const QApplication app(argc, argv);
  rotorbench::MainWindow window;
  FirstPaint first;
  window.installEventFilter(&first);
  window.show();
  return QApplication::exec();
}
