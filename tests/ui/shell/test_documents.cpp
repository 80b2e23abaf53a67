// Documents: open, save, recent files, drag and drop, the unsaved prompt, and work that survives a
// crash. The crash is real: a second process of this program edits an experiment in the real window
// and is killed.
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <csignal>
#include <iostream>

#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "tests/ui/shell/shell_fixture.h"
#include "ui/shell/autosave.h"

using namespace rotorbench;

namespace {

const QString kFlagship = "f450-hover-and-steps";
const QString kDuration = "setup.duration";

double duration(MainWindow& window) {
  return std::get<double>(window.documents().model().get(kDuration));
}

QMessageBox* boxNamed(MainWindow& window, const char* name) {
  auto* box = window.findChild<QMessageBox*>(name);
  return box != nullptr && box->isVisible() ? box : nullptr;
}

void press(QMessageBox* box, QMessageBox::StandardButton button) {
  QTest::mouseClick(box->button(button), Qt::LeftButton);
}

/// An own copy of the flagship in the sandbox.
QString copyOfFlagship(const QTemporaryDir& folder, const QString& name) {
  const QString file = folder.filePath(name);
  QFile::copy(QString(EXPERIMENTS_DIR) + '/' + kFlagship + ".json", file);
  return file;
}

void openAndWait(MainWindow& window, const QString& file) {
  window.openFile(file);
  QTRY_COMPARE(window.documents().file(), file);
}

}  // namespace

/// The process that will be killed: opens a file in the window, types an edit, says so when it is
/// on disk.
class EditThenWait : public QObject {
  Q_OBJECT

 public:
  EditThenWait(QString folder, QString file) : folder_(std::move(folder)), file_(std::move(file)) {}

 private slots:
  void edit();

 private:
  QString folder_, file_;
};

void EditThenWait::edit() {
  useSettingsIn(folder_);
  MainWindow window;
  showWindow(window);
  openAndWait(window, file_);
  typeInto(window, kDuration, "7 s");
  const QDir kept(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosave");
  QTRY_VERIFY_WITH_TIMEOUT(!kept.entryList({"*.json"}).isEmpty(), 30000);
  window.documents().autosave().flush();
  std::cout << "kept" << std::endl;
  QApplication::exec();
}

class TestDocuments : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void savesAndReadsBackEqual();
  void badFileIsExplained_data();
  void badFileIsExplained();
  void recentFiles();
  void droppedFileOpens();
  void droppedDataAreImported();
  void unsavedPrompt_data();
  void unsavedPrompt();
  void cleanEndLeavesNothing();
  void crashOffersRecovery();
  void discardedWorkIsGone();
  void runningWindowIsNotRecovered();

 private:
  [[nodiscard]] QString crashWithUnsavedWork();

  std::unique_ptr<QTemporaryDir> folder_;
};

void TestDocuments::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  QVERIFY(folder_->isValid());
  useSettingsIn(folder_->path());
  QLocale::setDefault(QLocale::c());
}

void TestDocuments::savesAndReadsBackEqual() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  typeInto(window, kDuration, "12 s");
  QVERIFY(window.isWindowModified());
  const QString file = folder_->filePath("mine.json");
  clickAction(window, "actionSave");
  QFileDialog* dialog = nullptr;
  QTRY_VERIFY((dialog = window.findChild<QFileDialog*>("saveDialog")) != nullptr);
  dialog->selectFile(file);
  QMetaObject::invokeMethod(dialog, "accept");
  QTRY_COMPARE(window.documents().file(), file);
  QVERIFY(!window.isWindowModified());
  QVERIFY(window.windowTitle().startsWith("mine.json"));
  QVERIFY(loadExperiment(file.toStdString()) == window.documents().experiment());
}

void TestDocuments::badFileIsExplained_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("expected");
  QTest::addRow("truncated") << QByteArray("{\"rotorbench\": 1, \"title\": ") << "";
  QTest::addRow("unknown key") << QByteArray("{\"rotorbench\": 1, \"titel\": \"x\"}") << "titel";
  QTest::addRow("binary") << QByteArray("\x00\xff\xfe\x01", 4) << "";
}

void TestDocuments::badFileIsExplained() {
  QFETCH(QByteArray, text);
  QFETCH(QString, expected);
  const QString path = folder_->filePath("bad.json");
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(text);
  file.close();
  MainWindow window;
  showWindow(window);
  window.openFile(path);
  QMessageBox* box = nullptr;
  QTRY_VERIFY((box = boxNamed(window, "problemBox")) != nullptr);
  QVERIFY(box->text().contains("bad.json"));
  QVERIFY(!box->informativeText().isEmpty());
  QVERIFY2(box->informativeText().contains(expected), qPrintable(box->informativeText()));
  press(box, QMessageBox::Ok);
  QVERIFY(window.documents().file().isEmpty());
}

void TestDocuments::recentFiles() {
  const QString first = copyOfFlagship(*folder_, "first.json");
  const QString second = copyOfFlagship(*folder_, "second.json");
  {
    MainWindow window;
    showWindow(window);
    openAndWait(window, first);
    openAndWait(window, second);
    QVERIFY(window.close());
  }
  MainWindow window;
  showWindow(window);
  QCOMPARE(window.documents().recentFiles().files(), QStringList({second, first}));
  auto* menu = window.findChild<QMenu*>("menuRecent");
  QVERIFY(menu->actions().at(1)->text().endsWith("first.json"));
  menu->actions().at(1)->trigger();
  QTRY_COMPARE(window.documents().file(), first);
  QCOMPARE(window.documents().recentFiles().files().front(), first);
}

void TestDocuments::droppedFileOpens() {
  const QString file = copyOfFlagship(*folder_, "dropped.json");
  MainWindow window;
  showWindow(window);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &drop);
  QTRY_COMPARE(window.documents().file(), file);
}

void TestDocuments::droppedDataAreImported() {
  QFile file(folder_->filePath("stand.csv"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("Time (s),Thrust (N)\n0,1\n1,2\n2,4\n");
  file.close();
  MainWindow window;
  showWindow(window);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file.fileName())});
  QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &drop);
  auto* dialog = window.findChild<QDialog*>("importDialog");
  QVERIFY(dialog != nullptr && dialog->isVisible());
  QPushButton* import = nullptr;
  for (auto* button : dialog->findChildren<QPushButton*>()) {
    if (button->text().contains("Import")) import = button;
  }
  QVERIFY(import != nullptr);
  QTRY_VERIFY(import->isEnabled());
  QTest::mouseClick(import, Qt::LeftButton);
  QCOMPARE(window.runs().records().size(), std::size_t{1});
  QVERIFY(window.runs().records().front().measured);
  // On the charts, beside whatever is computed.
  const auto& shown = window.workbench().runSet().runs();
  QCOMPARE(shown.size(), std::size_t{1});
  QVERIFY(shown.front().visible && shown.front().measured);
  const Recording& recording = *window.runs().records().front().status.outputs.front().recording;
  QVERIFY(recording.find("thrust").has_value());
  QCOMPARE(recording.value(*recording.find("thrust"), 2), 4.0);
}

void TestDocuments::unsavedPrompt_data() {
  QTest::addColumn<int>("answer");
  QTest::addColumn<bool>("closes");
  QTest::addColumn<double>("inFile");
  QTest::addRow("cancel") << int(QMessageBox::Cancel) << false << 40.0;
  QTest::addRow("discard") << int(QMessageBox::Discard) << true << 40.0;
  QTest::addRow("save") << int(QMessageBox::Save) << true << 9.0;
}

void TestDocuments::unsavedPrompt() {
  QFETCH(int, answer);
  QFETCH(bool, closes);
  QFETCH(double, inFile);
  const QString file = copyOfFlagship(*folder_, "own.json");
  MainWindow window;
  showWindow(window);
  openAndWait(window, file);
  QCOMPARE(duration(window), 40.0);
  typeInto(window, kDuration, "9 s");
  window.close();
  QVERIFY(window.isVisible());
  QMessageBox* box = nullptr;
  QTRY_VERIFY((box = boxNamed(window, "unsavedBox")) != nullptr);
  QVERIFY(box->text().contains("own.json"));
  press(box, static_cast<QMessageBox::StandardButton>(answer));
  QTRY_COMPARE(window.isVisible(), !closes);
  const Experiment saved = loadExperiment(file.toStdString());
  QCOMPARE(alternative<Flight>(saved.setup).duration, inFile);
}

void TestDocuments::cleanEndLeavesNothing() {
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosave";
  {
    MainWindow window;
    showWindow(window);
    openCard(window, kFlagship);
    typeInto(window, kDuration, "9 s");
    QTRY_VERIFY(!QDir(folder).entryList({"*.json"}).isEmpty());
    window.documents().save(folder_->filePath("saved.json"));
    QVERIFY(QDir(folder).entryList({"*.json"}).isEmpty());
  }
  QVERIFY(QDir(folder).entryList(QDir::Files).isEmpty());
}

QString TestDocuments::crashWithUnsavedWork() {
  const QString file = copyOfFlagship(*folder_, "crashed.json");
  QProcess process;
  process.start(QApplication::applicationFilePath(), {"--edit-then-wait", folder_->path(), file});
  while (process.waitForReadyRead(60000)) {
    if (process.readAllStandardOutput().contains("kept")) break;
  }
  ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
  process.waitForFinished();
  return process.exitStatus() == QProcess::CrashExit ? file : QString();
}

void TestDocuments::crashOffersRecovery() {
  const QString file = crashWithUnsavedWork();
  QVERIFY(!file.isEmpty());
  QCOMPARE(alternative<Flight>(loadExperiment(file.toStdString()).setup).duration, 40.0);
  MainWindow window;
  showWindow(window);
  QMessageBox* box = nullptr;
  QTRY_VERIFY((box = boxNamed(window, "recoveryBox")) != nullptr);
  QVERIFY(box->informativeText().contains("crashed.json"));
  QTest::mouseClick(box->findChild<QPushButton*>("recoverButton"), Qt::LeftButton);
  QTRY_COMPARE(window.documents().file(), file);
  QCOMPARE(duration(window), 7.0);
  QVERIFY(window.isWindowModified());
  clickAction(window, "actionSave");
  QTRY_VERIFY(!window.isWindowModified());
  QCOMPARE(alternative<Flight>(loadExperiment(file.toStdString()).setup).duration, 7.0);
}

void TestDocuments::discardedWorkIsGone() {
  QVERIFY(!crashWithUnsavedWork().isEmpty());
  for (const char* answer : {"laterButton", "discardButton"}) {
    MainWindow window;
    showWindow(window);
    QMessageBox* box = nullptr;
    QTRY_VERIFY((box = boxNamed(window, "recoveryBox")) != nullptr);
    QTest::mouseClick(box->findChild<QPushButton*>(answer), Qt::LeftButton);
    QTRY_VERIFY(boxNamed(window, "recoveryBox") == nullptr);
  }
  Autosave next(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosave");
  QVERIFY(next.takeLostWork().empty());
}

void TestDocuments::runningWindowIsNotRecovered() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  typeInto(window, kDuration, "9 s");
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosave";
  QTRY_VERIFY(!QDir(folder).entryList({"*.json"}).isEmpty());
  Autosave other(folder);
  QVERIFY(other.takeLostWork().empty());
}

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() == 4 && arguments.at(1) == "--edit-then-wait") {
    EditThenWait child(arguments.at(2), arguments.at(3));
    return QTest::qExec(&child, {arguments.front()});
  }
  TestDocuments test;
  return QTest::qExec(&test, argc, argv);
}

#include "test_documents.moc"
