// The fit dialog as a person uses it, on data made with a motor that is known: the values found,
// used in the experiment, undone, and saved.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/document/experiment.h"
#include "sim/document/thrust_stand.h"
#include "sim/library/component_library.h"
#include "sim/run/drive_build.h"
#include "ui/library/library_dialog.h"
#include "ui/measurement/fit_dialog.h"

using namespace rotorbench;

namespace {

constexpr double kRpm = std::numbers::pi / 30;

Experiment standWithMotor(const MotorParameters& motor) {
  Experiment experiment;
  ThrustStand stand;
  stand.stand.motor = motor;
  stand.stand.esc.resistance = 0;
  experiment.setup = stand;
  return experiment;
}

/// Steady points of the stand as a log would have them: what the fit has to find is in `motor`.
std::shared_ptr<const Recording> logOf(const MotorParameters& motor, int steps = 13) {
  const Experiment experiment = standWithMotor(motor);
  const DriveTrain train = buildDriveTrain(alternative<ThrustStand>(experiment.setup).stand);
  auto recording = std::make_shared<Recording>(std::vector<Channel>{{"throttle", "1", ""},
                                                                    {"motor.speed", "rad/s", ""},
                                                                    {"supply.voltage", "V", ""},
                                                                    {"supply.current", "A", ""}});
  // Beyond this throttle the current limit holds the motor back, which no constant of it explains.
  for (int k = 4; k <= steps; ++k) {
    const auto y = train.steadyState(k / 20.0, 1, 0);
    const auto at = train.instant(y);
    // A little scatter, always the same: 0.1 % of speed and current.
    const double wobble = 1 + 1e-3 * std::sin(7.0 * k);
    recording->append(std::array{k / 20.0, y[DriveTrain::kSpeed] * wobble, at.busVoltage,
                                 at.busCurrent / wobble});
  }
  recording->finish();
  return recording;
}

struct Fixture {
  MotorParameters truth = djiE305();
  DocumentModel model;
  RunList runs;
  QPointer<FitDialog> dialog;

  /// `start`: the motor the experiment has before.
  explicit Fixture(bool withData = true, int steps = 13, const MotorParameters& start = djiE305())
      : model(makeDocument(standWithMotor(start))) {
    truth.speedConstant = 1100 * kRpm;
    truth.resistance = 0.15;
    truth.noLoadCurrent = 0.8;
    if (withData) runs.addMeasured("stand.csv", {}, logOf(truth, steps));
    dialog = new FitDialog(model, runs);
    dialog->resize(1000, 680);
    dialog->show();
    dialog->activateWindow();
    if (!QTest::qWaitForWindowActive(dialog)) qFatal("the dialog does not come up");
  }
  ~Fixture() { delete dialog; }

  QPushButton* button(const char* name) { return dialog->findChild<QPushButton*>(name); }
  void click(const char* name) { QTest::mouseClick(button(name), Qt::LeftButton); }
  QString verdict() { return dialog->findChild<QLabel*>("fitVerdict")->text(); }
  /// The question about a doubtful fit, if it is asked.
  QMessageBox* question() {
    auto* box = dialog->findChild<QMessageBox*>("fitDoubtBox");
    return box != nullptr && box->isVisible() ? box : nullptr;
  }
  /// Into the experiment, doubtful or not.
  void use() {
    click("fitUse");
    if (question() != nullptr) click("fitUseAnyway");
  }
  QString message() { return dialog->findChild<QLabel*>("fitMessage")->text(); }
  /// The text in the row of the table that begins with these words.
  QString cell(const QString& first, int column) {
    auto* table = dialog->findChild<QTableWidget*>("fitTable");
    for (int row = 0; row < table->rowCount(); ++row) {
      if (table->item(row, 0)->text().startsWith(first)) return table->item(row, column)->text();
    }
    return {};
  }
  MotorParameters motor() {
    return alternative<ThrustStand>(model.as<Experiment>().setup).stand.motor;
  }
  void fit() {
    click("fitRun");
    QTRY_VERIFY_WITH_TIMEOUT(button("fitUse")->isEnabled(), 20000);
  }
};

}  // namespace

class TestFitDialog : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

 private slots:
  void initTestCase() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
    qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
  }

  void withoutDataSaysWhatToDo() {
    Fixture f(false);
    QVERIFY2(f.message().contains("import"), qPrintable(f.message()));
    QVERIFY(!f.button("fitRun")->isEnabled());
  }

  void findsTheMotor() {
    Fixture f;
    QVERIFY2(f.button("fitRun")->isEnabled(), qPrintable(f.message()));
    f.fit();
    QVERIFY2(f.cell("Resistance", 2).contains("\u00B1"), qPrintable(f.cell("Resistance", 2)));
    // The scatter of the log is a tenth of a percent.
    f.use();
    QVERIFY2(std::abs(f.motor().resistance / f.truth.resistance - 1) < 0.05,
             qPrintable(QString::number(f.motor().resistance)));
    QVERIFY(std::abs(f.motor().speedConstant / f.truth.speedConstant - 1) < 0.01);
    QVERIFY2(f.message().contains("Undo"), qPrintable(f.message()));
    QCOMPARE(f.model.undoStack()->count(), 1);
    f.model.undoStack()->undo();
    QVERIFY(f.motor() == djiE305());
    QCOMPARE(f.dialog->findChild<QComboBox*>("fitOutput")->count(), 2);
  }

  /// The no-load current is 78 % above that of the experiment: said in the line above the values,
  /// and asked about.
  void asksBeforeADoubtfulFitIsUsed() {
    Fixture f;
    QVERIFY(!f.dialog->findChild<QLabel*>("fitVerdict")->isVisible());
    f.fit();
    QVERIFY2(f.verdict().startsWith("Doubtful. ") && f.verdict().contains("No-load current: 0.8") &&
                 f.verdict().contains("% above its start of 0.45 A."),
             qPrintable(f.verdict()));
    QVERIFY(f.dialog->findChild<QLabel*>("fitVerdict")->isVisible());
    f.click("fitUse");
    QVERIFY(f.question() != nullptr);
    QVERIFY2(f.question()->informativeText().contains("No-load current: 0.8"),
             qPrintable(f.question()->informativeText()));
    QTest::mouseClick(f.question()->button(QMessageBox::Cancel), Qt::LeftButton);
    QTRY_VERIFY(f.question() == nullptr);
    QVERIFY(f.motor() == djiE305());
    f.click("fitUse");
    QTRY_VERIFY(f.question() != nullptr);
    f.click("fitUseAnyway");
    QTRY_VERIFY(f.motor() != djiE305());
    QVERIFY2(f.message().contains("Undo"), qPrintable(f.message()));
  }

  void trustsAFitNearItsStart() {
    MotorParameters start = djiE305();
    start.speedConstant = 1050 * kRpm;
    start.resistance = 0.14;
    start.noLoadCurrent = 0.75;
    Fixture f(true, 13, start);
    f.fit();
    QCOMPARE(f.verdict(), QString("Converged."));
    f.click("fitUse");
    QVERIFY(f.question() == nullptr);
    QVERIFY(f.motor() != start);
  }

  void savesWithItsSource() {
    Fixture f;
    f.fit();
    f.click("fitSave");
    QWidget* question = nullptr;
    QTRY_VERIFY((question = f.dialog->findChild<ComponentInfoDialog*>()) != nullptr);
    auto* name = question->findChild<QLineEdit*>();
    name->selectAll();
    QTest::keyClicks(name, "Fitted motor");
    QTest::keyClick(name, Qt::Key_Return);
    QTRY_VERIFY2(f.message().contains("Fitted motor"), qPrintable(f.message()));
    const ComponentLibrary library(shippedLibraryDirectory(), ownLibraryDirectory());
    const auto found = std::ranges::find_if(library.entries(), [](const LibraryEntry& e) {
      return e.own && e.component.info.name == "Fitted motor";
    });
    QVERIFY(found != library.entries().end());
    QVERIFY(found->component.info.source.find("stand.csv") != std::string::npos);
    QVERIFY(found->component.as<MotorParameters>() != nullptr);
    QCOMPARE(QString::fromStdString(found->component.info.warning), f.verdict());
  }

  /// The log has no thrust, so a lumped rotor cannot be found: the missing column is named.
  void namesWhatTheDataLack() {
    Fixture f;
    auto* model = f.dialog->findChild<QComboBox*>("what");
    QVERIFY(model != nullptr);
    const int row = model->findText("Lumped", Qt::MatchStartsWith);
    QVERIFY(row >= 0);
    model->setCurrentIndex(row);
    emit model->activated(row);
    QTRY_VERIFY(!f.button("fitRun")->isEnabled());
    QVERIFY2(f.message().contains("hrust"), qPrintable(f.message()));
  }

  /// A log to full throttle, of a stand whose motor takes at most 20 A: the dialog says how many
  /// rows that spoils, and leaves them out if asked to. With them the resistance is wrong by far
  /// more than its interval.
  void leavesOutRowsAtTheCurrentLimit() {
    Fixture f(true, 20);
    const auto* rows = f.dialog->findChild<QLabel*>("fitRows");
    QVERIFY(rows->isVisible());
    QVERIFY2(rows->text().endsWith("of 17 rows could be left out: they are at or near the current "
                                   "limit of 20 A."),
             qPrintable(rows->text()));
    f.fit();
    f.use();
    const double biased = f.motor().resistance;
    QVERIFY2(std::abs(biased / f.truth.resistance - 1) > 0.2, qPrintable(QString::number(biased)));
    f.model.undoStack()->undo();
    auto* box = f.dialog->findChild<QCheckBox*>("limited.leaveOut");
    QVERIFY(box != nullptr);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Space);
    QTRY_VERIFY2(rows->text().contains("of 17 rows are left out"), qPrintable(rows->text()));
    f.fit();
    f.use();
    QVERIFY2(std::abs(f.motor().resistance / f.truth.resistance - 1) < 0.05,
             qPrintable(QString::number(f.motor().resistance)));
    // A limit of one's own: above all currents nothing is left out.
    auto* limit = f.dialog->findChild<QLineEdit*>("limited.currentLimit");
    QVERIFY(limit != nullptr);
    limit->setFocus();
    limit->selectAll();
    QTest::keyClicks(limit, "60");
    QTest::keyClick(limit, Qt::Key_Return);
    QTRY_VERIFY2(rows->text().endsWith("0 of 17 rows are left out: they are at or near the current "
                                       "limit of 60 A."),
                 qPrintable(rows->text()));
  }

  void closesWhileItFits() {
    Fixture f;
    f.click("fitRun");
    f.dialog->close();
    QTRY_VERIFY(f.dialog.isNull());
  }
};

QTEST_MAIN(TestFitDialog)
#include "test_fit_dialog.moc"
