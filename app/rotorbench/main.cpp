// rotorbench: the window. Only wires; everything it shows lives in ui/.
#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QSurfaceFormat>

#include "sim/document/resources.h"
#include "ui/shell/main_window.h"

namespace {

// Qt 3D's shaders need an OpenGL core profile, which must be asked for before the application
// exists.
void askForCoreProfile() {
  QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
}

void describe(QCommandLineParser& parser) {
  parser.setApplicationDescription("Simulates and analyses quadrotors and their parts.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addOption({"reset-layout", "Put all panels where they were at first."});
  parser.addPositionalArgument("FILE", "Experiment to open.", "[FILE]");
}

/// --help and --version must work where there is no display.
bool asksForText(QCommandLineParser& parser, int argc, char** argv) {
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  return !parser.parse(arguments) || parser.isSet("help") || parser.isSet("version");
}

}  // namespace

int main(int argc, char** argv) {
  askForCoreProfile();
  QApplication::setOrganizationName("Rotorbench");
  QApplication::setApplicationName("Rotorbench");
  QApplication::setApplicationVersion(ROTORBENCH_VERSION);
  QApplication::setDesktopFileName("rotorbench");
  QCommandLineParser parser;
  describe(parser);
  if (asksForText(parser, argc, argv)) {
    const QCoreApplication app(argc, argv);
    parser.process(app);
    return 0;
  }
  const QApplication app(argc, argv);
  parser.process(app);

  const auto icon = rotorbench::resourceDirectory() / "icons" / "rotorbench.svg";
  QApplication::setWindowIcon(QIcon(QString::fromStdString(icon.string())));
  rotorbench::MainWindow window;
  if (parser.isSet("reset-layout")) window.resetLayout();
  window.show();
  if (!parser.positionalArguments().isEmpty()) {
    window.openFile(parser.positionalArguments().constFirst());
  }
  return QApplication::exec();
}
