// Installs the build into an empty folder, as a package does, and looks at it as a desktop and a
// user do.
#include <QDir>
#include <QMimeDatabase>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

namespace {

struct Outcome {
  int code = -1;
  QString output, errors;
};

Outcome execute(const QString& program, const QStringList& arguments, const QString& directory) {
  QProcess process;
  process.setWorkingDirectory(directory);
  process.start(program, arguments);
  if (!process.waitForFinished(60000)) return {-1, {}, process.errorString()};
  return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
          QString::fromUtf8(process.readAllStandardError())};
}

}  // namespace

class TestInstall : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void shippedFilesAreThere_data();
  void shippedFilesAreThere();
  void versionIsTheProjects();
  void shippedExperimentsAreFound();
  void desktopFileIsValid();
  void experimentsHaveAType();
  void readmeExampleFlies();

 private:
  [[nodiscard]] QString path(const QString& relative) const { return folder_.filePath(relative); }
  QTemporaryDir folder_;
};

void TestInstall::initTestCase() {
  QVERIFY(folder_.isValid());
  qunsetenv("ROTORBENCH_RESOURCES");
  const auto done =
      execute(CMAKE_PROGRAM, {"--install", BUILD_DIR, "--prefix", folder_.path()}, BUILD_DIR);
  QVERIFY2(done.code == 0, qPrintable(done.errors));
  // Before the first use of QMimeDatabase, which reads these folders once.
  qputenv("XDG_DATA_DIRS", path("share").toUtf8());
  qputenv("XDG_DATA_HOME", path("home").toUtf8());
}

void TestInstall::shippedFilesAreThere_data() {
  QTest::addColumn<QString>("file");
  for (const char* file :
       {"bin/rotorbench", "bin/rotorbench-cli",
        "share/rotorbench/experiments/f450-hover-and-steps.json",
        "share/rotorbench/help/index.html", "share/rotorbench/library/motors/dji-e305-2312e.json",
        "share/applications/rotorbench.desktop", "share/icons/hicolor/scalable/apps/rotorbench.svg",
        "share/mime/packages/rotorbench.xml", "share/metainfo/rotorbench.metainfo.xml",
        "share/man/man1/rotorbench.1.gz", "share/man/man1/rotorbench-cli.1.gz",
        "share/doc/rotorbench/copyright"}) {
    QTest::addRow("%s", file) << QString(file);
  }
}

void TestInstall::shippedFilesAreThere() {
  QFETCH(QString, file);
  QVERIFY(QFileInfo(path(file)).size() > 0);
}

void TestInstall::versionIsTheProjects() {
  const auto done = execute(path("bin/rotorbench-cli"), {"--version"}, folder_.path());
  QCOMPARE(done.code, 0);
  QCOMPARE(done.output.trimmed(), QString("rotorbench-cli " PROJECT_VERSION_TEXT));
}

/// The program finds the installed experiments, not those of the sources.
void TestInstall::shippedExperimentsAreFound() {
  const QDir shipped(SOURCE_DIR "/resources/experiments");
  const auto files = shipped.entryList({"*.json"}, QDir::Files);
  QVERIFY(files.size() >= 6);
  const QString extra = path("share/rotorbench/experiments/only-installed.json");
  QVERIFY(QFile::copy(path("share/rotorbench/experiments/" + files.first()), extra));
  const auto done = execute(path("bin/rotorbench-cli"), {"list"}, folder_.path());
  QVERIFY(QFile::remove(extra));
  QVERIFY2(done.code == 0, qPrintable(done.errors));
  for (const QString& file : files) {
    QVERIFY2(done.output.contains(QFileInfo(file).completeBaseName()),
             qPrintable(file + "\n" + done.output));
  }
  QVERIFY(done.output.contains("only-installed"));
}

void TestInstall::desktopFileIsValid() {
  const QString validator = QStandardPaths::findExecutable("desktop-file-validate");
  if (validator.isEmpty()) QSKIP("desktop-file-validate is not installed");
  const auto done =
      execute(validator, {path("share/applications/rotorbench.desktop")}, folder_.path());
  QVERIFY2(done.code == 0 && done.output.isEmpty(), qPrintable(done.output));
}

void TestInstall::experimentsHaveAType() {
  const QMimeDatabase types;
  const auto type = types.mimeTypeForFile("hover.rotorbench.json", QMimeDatabase::MatchExtension);
  QCOMPARE(type.name(), QString("application/x-rotorbench-experiment+json"));
  QVERIFY(type.inherits("application/json"));
  QVERIFY(types.mimeTypeForFile("other.json", QMimeDatabase::MatchExtension).name() != type.name());
}

void TestInstall::readmeExampleFlies() {
  QFile readme(SOURCE_DIR "/README.md");
  QVERIFY(readme.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(readme.readAll());
  const QString example = text.section("```json\n", 1).section("```", 0, 0);
  QVERIFY(!example.isEmpty());
  QFile file(path("readme.json"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(example.toUtf8());
  file.close();
  const auto done = execute(path("bin/rotorbench-cli"), {"run", file.fileName()}, folder_.path());
  QVERIFY2(done.code == 0, qPrintable(done.errors));
  QVERIFY(done.output.contains("altitude_settling_time"));
}

QTEST_GUILESS_MAIN(TestInstall)
#include "test_install.moc"
