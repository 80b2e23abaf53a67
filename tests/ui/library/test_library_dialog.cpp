// The library as a person uses it: opened from the form, searched, used, undone; own components
// saved, copied, renamed, exported, imported and deleted.
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QtTest>
#include <fstream>

#include "sim/document/experiment.h"
#include "sim/document/flight.h"
#include "sim/document/motor_bench.h"
#include "sim/library/component_file.h"
#include "ui/forms/experiment_panel.h"
#include "ui/forms/parameter_form.h"
#include "ui/library/library_dialog.h"
#include "ui/library/library_forms.h"

using namespace rotorbench;

namespace {

Experiment benchExperiment() {
  Experiment experiment;
  experiment.setup = MotorBench();
  return experiment;
}

/// The form of an experiment with the library connected, in a folder of its own.
struct Bench {
  explicit Bench(Experiment experiment = benchExperiment())
      : model(makeDocument(std::move(experiment))),
        panel(std::make_unique<ExperimentPanel>(&model, nullptr)) {
    connectLibrary(*panel, model);
    panel->resize(420, 900);
    panel->show();
    panel->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel.get()));
  }

  /// Clicks the button beside the part at `path`, in the form that shows it.
  LibraryDialog* open(const QString& section, const QString& path) {
    panel->showSection(section);
    auto* button = panel->findChild<QToolButton*>(path + ".library");
    if (button == nullptr) return nullptr;
    QTest::mouseClick(button, Qt::LeftButton);
    auto* dialog = panel->findChild<LibraryDialog*>();
    return dialog != nullptr && QTest::qWaitForWindowExposed(dialog) ? dialog : nullptr;
  }
  const DriveStand& stand() const {
    return alternative<MotorBench>(model.as<Experiment>().setup).stand;
  }

  DocumentModel model;
  std::unique_ptr<ExperimentPanel> panel;
};

template <class W>
W* child(QWidget* parent, const char* name) {
  auto* found = parent->findChild<W*>(name);
  if (found == nullptr) qWarning("no %s", name);
  return found;
}

void click(QWidget* dialog, const char* name) {
  auto* button = child<QPushButton>(dialog, name);
  QVERIFY(button != nullptr && button->isEnabled());
  QTest::mouseClick(button, Qt::LeftButton);
}

void search(QWidget* dialog, const QString& words) {
  auto* edit = child<QLineEdit>(dialog, "librarySearch");
  edit->clear();
  QTest::keyClicks(edit, words);
}

/// Names a person reads in the list, headings left out.
QStringList names(QWidget* dialog) {
  QStringList found;
  for (QTreeWidgetItemIterator it(child<QTreeWidget>(dialog, "libraryList")); *it; ++it) {
    if ((*it)->parent() != nullptr) found << (*it)->text(0);
  }
  return found;
}

QString message(QWidget* dialog) {
  return child<QLabel>(dialog, "libraryMessage")->text();
}

/// Fills the dialog that asks for name and texts, and presses OK.
void giveName(LibraryDialog* dialog, const QString& name, const QString& source = {}) {
  ComponentInfoDialog* info = nullptr;
  QTRY_VERIFY((info = dialog->findChild<ComponentInfoDialog*>()) != nullptr && info->isVisible());
  auto* edit = child<QLineEdit>(info, "infoName");
  edit->selectAll();
  QTest::keyClicks(edit, name);
  if (!source.isEmpty()) QTest::keyClicks(child<QPlainTextEdit>(info, "infoSource"), source);
  QTest::mouseClick(child<QPushButton>(info, "infoOk"), Qt::LeftButton);
}

void giveFile(LibraryDialog* dialog, const char* name, const QString& file) {
  QFileDialog* files = nullptr;
  QTRY_VERIFY((files = dialog->findChild<QFileDialog*>(name)) != nullptr && files->isVisible());
  auto* edit = files->findChild<QLineEdit*>("fileNameEdit");
  QVERIFY(edit != nullptr);
  edit->setText(file);
  QTest::keyClick(edit, Qt::Key_Return);
  QTRY_VERIFY(dialog->findChild<QFileDialog*>(name) == nullptr);
}

}  // namespace

class TestLibraryDialog : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QApplication::setOrganizationName("Rotorbench");
    QApplication::setApplicationName("Rotorbench");
  }
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    qputenv("XDG_DATA_HOME", folder_->path().toUtf8());
  }
  void ownFolderIsWhereTheCommandLineLooks();
  void buttonsStandWhereComponentsFit_data();
  void buttonsStandWhereComponentsFit();
  void searchAndUse();
  void keyboardAlone();
  void detailsTellAll();
  void alternativesAreChosenToo();
  void airframeReplacesTheVehicle();
  void speedControllersOfAVehicle();
  void saveAndFindAgain();
  void nameTakenIsSaid();
  void shippedCannotBeChanged();
  void duplicateRenameDelete();
  void exportAndImport();
  void brokenImportIsSaid_data();
  void brokenImportIsSaid();
  void brokenFileInTheLibraryIsSaid();
  void browsingAllKinds();

 private:
  [[nodiscard]] QString path(const char* file) const { return folder_->filePath(file); }
  std::unique_ptr<QTemporaryDir> folder_;
};

void TestLibraryDialog::ownFolderIsWhereTheCommandLineLooks() {
  QCOMPARE(QString::fromStdString(ownLibraryDirectory().string()),
           path("Rotorbench/Rotorbench/library"));
}

void TestLibraryDialog::buttonsStandWhereComponentsFit_data() {
  QTest::addColumn<QString>("section");
  QTest::addColumn<bool>("there");
  QTest::addRow("setup.stand.motor") << "setup.stand" << true;
  QTest::addRow("setup.stand.esc") << "setup.stand" << true;
  QTest::addRow("setup.stand.load") << "setup.stand" << true;
  QTest::addRow("setup.stand") << "setup.stand" << false;
  QTest::addRow("setup.run") << "setup.run" << false;
  QTest::addRow("setup") << "setup" << false;
}

void TestLibraryDialog::buttonsStandWhereComponentsFit() {
  QFETCH(QString, section);
  QFETCH(bool, there);
  Bench bench;
  bench.panel->showSection(section);
  const auto* button =
      bench.panel->findChild<QToolButton*>(QString(QTest::currentDataTag()) + ".library");
  QCOMPARE(button != nullptr && button->isVisible(), there);
  if (there) QVERIFY(!button->accessibleName().isEmpty());
}

void TestLibraryDialog::searchAndUse() {
  Bench bench;
  const MotorParameters before = bench.stand().motor;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  QVERIFY(dialog != nullptr);
  QVERIFY(names(dialog).size() >= 12);
  search(dialog, "sunnysky terminals");
  QCOMPARE(names(dialog), QStringList{"SunnySky X2216 1100KV with ESC and leads"});
  click(dialog, "libraryUse");
  QTRY_VERIFY(bench.panel->findChild<LibraryDialog*>() == nullptr);
  QCOMPARE(bench.stand().motor.resistance, 0.148);
  auto* field = bench.panel->findChild<QLineEdit*>("setup.stand.motor.noLoadCurrent");
  QTRY_VERIFY((field = bench.panel->findChild<QLineEdit*>("setup.stand.motor.noLoadCurrent")) &&
              field->text() == QLocale().toString(0.8));
  QCOMPARE(bench.model.undoStack()->count(), 1);
  QVERIFY(bench.model.undoStack()->undoText().contains("SunnySky X2216"));
  bench.model.undoStack()->undo();
  QVERIFY(bench.stand().motor == before);
}

void TestLibraryDialog::keyboardAlone() {
  Bench bench;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  QVERIFY(dialog != nullptr);
  auto* edit = child<QLineEdit>(dialog, "librarySearch");
  QTRY_VERIFY(edit->hasFocus());
  QTest::keyClicks(edit, "t-motor f40");
  QTest::keyClick(edit, Qt::Key_Down);
  auto* list = child<QTreeWidget>(dialog, "libraryList");
  QVERIFY(list->hasFocus());
  QCOMPARE(list->currentItem()->text(0), QString("T-Motor F40 Pro III 1600KV"));
  QTest::keyClick(list, Qt::Key_Return);
  QTRY_COMPARE(bench.model.undoStack()->count(), 1);
}

void TestLibraryDialog::detailsTellAll() {
  Bench bench;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  QVERIFY(dialog != nullptr);
  search(dialog, "stampfly");
  QVERIFY(child<QLabel>(dialog, "componentSummary")->text().contains("35 g"));
  QVERIFY(child<QLabel>(dialog, "componentSource")->text().contains("K. Ito"));
  auto* warning = child<QLabel>(dialog, "componentWarning");
  QVERIFY(warning->isVisible() && warning->text().contains("do not fit together"));
  auto* values = child<QTreeWidget>(dialog, "componentValues");
  const auto rows = values->findItems("Resistance", Qt::MatchExactly);
  QCOMPARE(rows.size(), 1);
  QVERIFY(rows.front()->text(1).endsWith("Ω"));
  search(dialog, "no such motor");
  QVERIFY(names(dialog).isEmpty());
  QVERIFY(!child<QPushButton>(dialog, "libraryUse")->isEnabled());
}

/// A battery for a fixed supply, a propeller for a brake: the alternative comes with the component,
/// as one step.
void TestLibraryDialog::alternativesAreChosenToo() {
  Bench bench;
  const DriveStand before = bench.stand();
  QVERIFY(std::holds_alternative<SupplyParameters>(before.supply));
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.supply");
  QVERIFY(dialog != nullptr);
  search(dialog, "turnigy");
  click(dialog, "libraryUse");
  QTRY_COMPARE(bench.model.undoStack()->count(), 1);
  const auto* battery = std::get_if<BatteryParameters>(&bench.stand().supply);
  QVERIFY(battery != nullptr);
  QCOMPARE(battery->series, 3);
  QTRY_VERIFY(bench.panel->findChild<LibraryDialog*>() == nullptr);
  dialog = bench.open("setup.stand", "setup.stand.load");
  QVERIFY(dialog != nullptr);
  search(dialog, "apc slow 11");
  click(dialog, "libraryUse");
  QTRY_COMPARE(bench.model.undoStack()->count(), 2);
  const auto* load = std::get_if<BladeElementLoad>(&bench.stand().load);
  QVERIFY(load != nullptr);
  QCOMPARE(load->propeller.diameter, 11 * 0.0254);
  QVERIFY(load->settings == BladeElementSettings());
  bench.model.undoStack()->undo();
  bench.model.undoStack()->undo();
  QVERIFY(bench.stand() == before);
}

void TestLibraryDialog::airframeReplacesTheVehicle() {
  Bench bench{Experiment()};
  LibraryDialog* dialog = bench.open("setup.vehicle", "setup.vehicle");
  QVERIFY(dialog != nullptr);
  search(dialog, "quad-sim x");
  click(dialog, "libraryUse");
  QTRY_COMPARE(bench.model.undoStack()->count(), 1);
  const auto& vehicle = alternative<Flight>(bench.model.as<Experiment>().setup).vehicle;
  QCOMPARE(std::get<DirectMass>(vehicle.mass).mass, 1.023);
  QVERIFY(!bench.model.hasErrors());
}

/// Rotors fly with the speed controllers the stands have: picked, read in the form, changed, saved,
/// found again.
void TestLibraryDialog::speedControllersOfAVehicle() {
  Bench bench{Experiment()};
  const auto esc = [](Bench& b) -> const EscParameters& {
    const auto& vehicle = alternative<Flight>(b.model.as<Experiment>().setup).vehicle;
    return std::get<EqualRotors>(vehicle.rotors).rotor.esc;
  };
  const QString section = "setup.vehicle.rotors.rotor", place = "setup.vehicle.rotors.rotor.esc";
  LibraryDialog* dialog = bench.open(section, place);
  QVERIFY(dialog != nullptr);
  QVERIFY(names(dialog).size() >= 6);
  search(dialog, "dji 420");
  QCOMPARE(names(dialog), QStringList{"DJI 420 LITE"});
  click(dialog, "libraryUse");
  QTRY_VERIFY(bench.panel->findChild<LibraryDialog*>() == nullptr);
  QVERIFY(esc(bench) ==
          (EscParameters{.resistance = 0.005, .responseTime = 0.01, .maxCurrent = 20}));
  const auto shows = [&](const char* key, const QString& text) {
    auto* field = bench.panel->findChild<QLineEdit*>(place + "." + key);
    return field != nullptr && field->isVisible() && field->text() == text;
  };
  QTRY_VERIFY(shows("maxCurrent", QLocale().toString(20)));
  QVERIFY(shows("responseTime", QLocale().toString(10)));  // ms
  QVERIFY(shows("resistance", QLocale().toString(5)));     // mOhm
  QVERIFY(!bench.model.hasErrors());

  auto* field = bench.panel->findChild<QLineEdit*>(place + ".responseTime");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "4");
  QTest::keyClick(field, Qt::Key_Return);
  QTRY_COMPARE(esc(bench).responseTime, 0.004);
  dialog = bench.open(section, place);
  QVERIFY(dialog != nullptr);
  click(dialog, "librarySave");
  giveName(dialog, "Quick 420", "Timed with a scope");
  QTRY_COMPARE(names(dialog).value(0), QString("Quick 420"));
  QTest::keyClick(dialog, Qt::Key_Escape);

  Bench stand;  // what was saved from a vehicle fits a stand
  dialog = stand.open("setup.stand", "setup.stand.esc");
  QVERIFY(dialog != nullptr);
  search(dialog, "quick");
  click(dialog, "libraryUse");
  QTRY_VERIFY(stand.stand().esc == esc(bench));
}

void TestLibraryDialog::saveAndFindAgain() {
  Bench bench;
  bench.model.set("setup.stand.motor.resistance", 0.0815);
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  QVERIFY(dialog != nullptr);
  click(dialog, "librarySave");
  giveName(dialog, "Workshop motor", "Measured with a milliohm meter");
  QTRY_COMPARE(names(dialog).value(0), QString("Workshop motor"));
  QCOMPARE(child<QLabel>(dialog, "componentName")->text(), QString("Workshop motor"));
  QTest::keyClick(dialog, Qt::Key_Escape);
  bench.model.set("setup.stand.motor.resistance", 0.5);
  Bench another;
  dialog = another.open("setup.stand", "setup.stand.motor");
  search(dialog, "workshop");
  QVERIFY(child<QLabel>(dialog, "componentSource")->text().contains("milliohm"));
  click(dialog, "libraryUse");
  QTRY_COMPARE(another.stand().motor.resistance, 0.0815);
}

void TestLibraryDialog::nameTakenIsSaid() {
  Bench bench;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  click(dialog, "librarySave");
  giveName(dialog, "DJI E305 (2312E)");
  auto* info = dialog->findChild<ComponentInfoDialog*>();
  QVERIFY(info != nullptr && info->isVisible());
  QVERIFY(child<QLabel>(info, "infoMessage")->text().contains("already has"));
  giveName(dialog, "Mine");
  QTRY_COMPARE(names(dialog).value(0), QString("Mine"));
}

void TestLibraryDialog::shippedCannotBeChanged() {
  Bench bench;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  search(dialog, "e305");
  QVERIFY(!child<QPushButton>(dialog, "libraryDelete")->isEnabled());
  QVERIFY(!child<QPushButton>(dialog, "libraryRename")->isEnabled());
}

void TestLibraryDialog::duplicateRenameDelete() {
  Bench bench;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  search(dialog, "e305");
  click(dialog, "libraryDuplicate");
  giveName(dialog, "E305 rewound");
  QTRY_COMPARE(names(dialog).value(0), QString("E305 rewound"));
  click(dialog, "libraryRename");
  giveName(dialog, "E305 twice");
  QTRY_COMPARE(names(dialog).value(0), QString("E305 twice"));
  auto* list = child<QTreeWidget>(dialog, "libraryList");
  dialog->activateWindow();  // as a window manager does when the dialog above is closed
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualItemRect(list->currentItem()).center());
  QTRY_VERIFY(list->hasFocus() && dialog->isActiveWindow());
  QTest::keyClick(list, Qt::Key_Delete);
  QMessageBox* box = nullptr;
  QTRY_VERIFY((box = dialog->findChild<QMessageBox*>("libraryDeleteBox")) && box->isVisible());
  QVERIFY(box->text().contains("E305 twice"));
  QTest::mouseClick(child<QPushButton>(box, "libraryDeleteYes"), Qt::LeftButton);
  QTRY_VERIFY(!names(dialog).contains("E305 twice"));
  QVERIFY(names(dialog).contains("DJI E305 (2312E)"));
}

void TestLibraryDialog::exportAndImport() {
  Bench bench;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  search(dialog, "e305");
  const QString file = path("out.json");
  click(dialog, "libraryExport");
  giveFile(dialog, "libraryExportDialog", file);
  QTRY_VERIFY(QFile::exists(file));
  QCOMPARE(loadComponent(file.toStdString()).info.name, std::string("DJI E305 (2312E)"));
  click(dialog, "libraryImport");
  giveFile(dialog, "libraryImportDialog", file);
  QTRY_COMPARE(names(dialog).value(0), QString("DJI E305 (2312E) 2"));
  QVERIFY(message(dialog).contains("Imported"));
}

void TestLibraryDialog::brokenImportIsSaid_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("word");
  QTest::addRow("cut off") << QByteArray("{\"rotorbench-component\": 1, \"ki") << "line";
  QTest::addRow("empty") << QByteArray() << "cannot be imported";
  QTest::addRow("an experiment") << QByteArray("{\"rotorbench\": 1}") << "experiment";
  QTest::addRow("unknown kind")
      << QByteArray(R"({"rotorbench-component": 1, "kind": "wing", "name": "W"})") << "wing";
  QTest::addRow("out of range") << QByteArray(
                                       R"({"rotorbench-component": 1, "kind": "motor", "name": "M",
                        "value": {"resistance": -3}})")
                                << "value.resistance";
}

void TestLibraryDialog::brokenImportIsSaid() {
  QFETCH(QByteArray, text);
  QFETCH(QString, word);
  QFile file(path("bad.json"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(text);
  file.close();
  Bench bench;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  const QStringList before = names(dialog);
  click(dialog, "libraryImport");
  giveFile(dialog, "libraryImportDialog", file.fileName());
  QTRY_VERIFY(message(dialog).contains("bad.json cannot be imported"));
  QVERIFY2(message(dialog).contains(word), qPrintable(message(dialog)));
  QCOMPARE(names(dialog), before);
  QCOMPARE(bench.model.undoStack()->count(), 0);
}

void TestLibraryDialog::brokenFileInTheLibraryIsSaid() {
  const auto folder = ownLibraryDirectory() / "motors";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "spoilt.json") << "{";
  Bench bench;
  LibraryDialog* dialog = bench.open("setup.stand", "setup.stand.motor");
  QVERIFY(message(dialog).contains("spoilt.json cannot be read"));
  QVERIFY(names(dialog).size() >= 12);
}

void TestLibraryDialog::browsingAllKinds() {
  auto* dialog = new LibraryDialog(browseRequest(), nullptr);
  dialog->show();
  QVERIFY(QTest::qWaitForWindowExposed(dialog));
  QVERIFY(names(dialog).size() >= 100);
  QVERIFY(dialog->findChild<QPushButton*>("libraryUse") == nullptr);
  QVERIFY(dialog->findChild<QPushButton*>("librarySave") == nullptr);
  auto* kinds = child<QComboBox>(dialog, "libraryKind");
  kinds->setCurrentText("Battery");
  QVERIFY(names(dialog).contains("Turnigy 2200 mAh 3S 20C"));
  QVERIFY(!names(dialog).contains("DJI E305 (2312E)"));
  dialog->close();
}

QTEST_MAIN(TestLibraryDialog)
#include "test_library_dialog.moc"
