// Pictures of the real window for the README and for the eye: opens an experiment from the gallery,
// flies it for a while and saves what the window shows. Not a test.
//   rotorbench-screenshot OUT.png [--experiment NAME] [--seconds S] [--theme light|dark] [--size
//     WxH] [--locale de]
//                        [--section PATH] [--tool NAME]
// Without --experiment the start page is shown. With a tool of the Tools menu the picture is of its
// dialog, of the given size.
#include <QCommandLineParser>
#include <QDialog>
#include <QSurfaceFormat>

#include "sim/document/resources.h"
#include "tests/ui/shell/shell_fixture.h"

using namespace rotorbench;

namespace {

void describe(QCommandLineParser& parser) {
  parser.addPositionalArgument("OUT.png", "Picture to write.");
  parser.addOption({"experiment", "Name of a ready experiment.", "NAME"});
  parser.addOption({"section", "Section of the form to show.", "PATH"});
  parser.addOption({"tool", "Object name of an action of the Tools menu.", "NAME"});
  parser.addOption({"seconds", "Simulated time at which the picture is taken.", "S", "12"});
  parser.addOption({"theme", "light or dark", "THEME", "light"});
  parser.addOption({"size", "Width and height of the window.", "WxH", "1600x1000"});
  parser.addOption({"locale", "Language of numbers.", "LOCALE", "C"});
}

void fly(MainWindow& window, const QCommandLineParser& options) {
  openCard(window, options.value("experiment"));
  if (options.isSet("section"))
    window.workbench().experiment().showSection(options.value("section"));
  const double until = options.value("seconds").toDouble();
  if (until <= 0) return;
  choosePace(window, "5 ×");
  clickAction(window, "actionRun");
  QTRY_VERIFY_WITH_TIMEOUT(
      !isActive(window.controller().state()) || window.controller().status().progress.time >= until,
      120000);
  if (isActive(window.controller().state())) clickAction(window, "actionPause");
  QTRY_VERIFY(window.controller().state() != RunState::Running);
}

/// The dialog that the action opens, at this size; the window itself if none comes.
QWidget* toolDialog(MainWindow& window, const QString& name, QSize size) {
  auto* action = window.findChild<QAction*>(name);
  if (action == nullptr) qFatal("There is no action of this name.");
  QTimer::singleShot(0, action, &QAction::trigger);
  QTest::qWait(500);
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (widget == &window || !widget->isVisible() || qobject_cast<QDialog*>(widget) == nullptr)
      continue;
    widget->resize(size);
    return widget;
  }
  return &window;
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  const QApplication app(argc, argv);
  QCommandLineParser options;
  describe(options);
  options.process(app);
  QTemporaryDir folder;
  useSettingsIn(folder.path());
  QSettings().setValue("window/theme", options.value("theme"));
  QLocale::setDefault(QLocale(options.value("locale")));
  const QStringList size = options.value("size").split('x');

  MainWindow window;
  window.show();
  const QSize wanted(size.value(0).toInt(), size.value(1).toInt());
  window.resize(wanted);
  if (options.isSet("experiment")) fly(window, options);
  QWidget* shown = &window;
  if (options.isSet("tool")) shown = toolDialog(window, options.value("tool"), wanted);
  QTest::qWait(1500);  // the picture of the 3D view arrives a few frames later
  return shown->grab().save(options.positionalArguments().value(0)) ? 0 : 1;
}
