// The propeller editor as a person uses it: points dragged, stations added and removed by keys,
// polars brought in, and the figures below read.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include "sim/document/experiment.h"
#include "sim/document/flight.h"
#include "sim/document/motor_bench.h"
#include "sim/propulsion/rotor/advance_sweep.h"
#include "ui/propeller/blade_curves.h"
#include "ui/propeller/propeller_editor.h"
#include "ui/propeller/propeller_figures.h"

using namespace rotorbench;

namespace {

Experiment stand() {
  Experiment experiment;
  MotorBench bench;
  bench.stand.load = BladeElementLoad{};
  experiment.setup = bench;
  return experiment;
}

Experiment flight() {
  Experiment experiment;
  auto& rotors = std::get<EqualRotors>(alternative<Flight>(experiment.setup).vehicle.rotors);
  rotors.rotor.aerodynamics = BladeElementPropeller{};
  return experiment;
}

struct Fixture {
  DocumentModel model;
  QPointer<PropellerEditor> editor = new PropellerEditor(model);

  explicit Fixture(const Experiment& experiment = stand()) : model(makeDocument(experiment)) {
    editor->resize(1100, 720);
    editor->show();
    editor->activateWindow();
    if (!QTest::qWaitForWindowActive(editor)) qFatal("the editor does not come up");
  }
  ~Fixture() { delete editor; }

  BladeCurves* curves() { return editor->findChild<BladeCurves*>("bladeCurves"); }
  QString figures() { return editor->findChild<QLabel*>("propellerText")->text(); }
  const BladeStation& station(std::size_t i) { return editor->geometry().stations[i]; }
};

QString writePolar(const QTemporaryDir& folder, const char* name, const char* text) {
  QFile file(folder.filePath(name));
  if (!file.open(QIODevice::WriteOnly)) qFatal("no temporary file");
  file.write(text);
  return file.fileName();
}

constexpr auto kPolar =
    " Calculated polar for: flat\n\n Mach =   0.000     Re =     0.100 e 6     Ncrit =   9.000\n\n"
    "   alpha    CL        CD       CDp       CM\n"
    "  ------ -------- --------- --------- --------\n"
    "  -5.000  -0.5000   0.02000   0.01000   0.0000\n"
    "   0.000   0.0500   0.01200   0.01000   0.0000\n"
    "   5.000   0.6000   0.02000   0.01000   0.0000\n";

}  // namespace

class TestPropellerEditor : public QObject {
  Q_OBJECT

 private slots:
  void findsThePropellerOfTheExperiment() {
    Fixture f;
    QCOMPARE(f.editor->path(), QString("setup.stand.load.propeller"));
    QVERIFY(f.editor->geometry() == PropellerGeometry{});
  }

  /// Figures are those of the blade elements at the speed in the box.
  void figuresFollowTheSpeed() {
    Fixture f;
    auto* speed = f.editor->findChild<QDoubleSpinBox*>("propellerSpeed");
    speed->selectAll();
    QTest::keyClicks(speed, "4800");
    QTest::keyClick(speed, Qt::Key_Return);
    const auto curves =
        advanceSweep(BladeElementRotor(PropellerGeometry{}), 4800 * 2 * M_PI / 60, AirState{});
    const QString expected =
        "CT " + QLocale().toString(curves.points.front().thrustCoefficient, 'f', 4);
    QTRY_VERIFY2(f.figures().contains(expected), qPrintable(f.figures()));
    QVERIFY(f.figures().contains("no thrust at J"));
  }

  void draggedPointChangesChordAsOneStep() {
    Fixture f;
    const QString before = f.figures();
    const double chord = f.station(5).chord;
    const QPoint from = f.curves()->handle(5, BladeCurves::Quantity::Chord).toPoint();
    QTest::mousePress(f.curves(), Qt::LeftButton, {}, from);
    for (int k = 1; k <= 5; ++k) QTest::mouseMove(f.curves(), from - QPoint(0, 4 * k));
    QTest::mouseRelease(f.curves(), Qt::LeftButton, {}, from - QPoint(0, 20));
    QVERIFY(f.station(5).chord > chord);
    QTRY_VERIFY(f.figures() != before);
    QCOMPARE(f.model.undoStack()->count(), 1);
    QTest::mouseClick(f.editor->findChild<QToolButton*>("propellerUndo"), Qt::LeftButton);
    QCOMPARE(f.station(5).chord, chord);
    QTRY_COMPARE(f.figures(), before);
  }

  void keysChooseAndChange() {
    Fixture f;
    f.curves()->setFocus();
    QTest::keyClick(f.curves(), Qt::Key_Right);
    QTest::keyClick(f.curves(), Qt::Key_Right);
    QTest::keyClick(f.curves(), Qt::Key_Space);
    const double twist = f.station(2).twist;
    QTest::keyClick(f.curves(), Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(qAbs(f.station(2).twist - twist - M_PI / 180) < 1e-9);
  }

  void stationsAreAddedAndRemoved() {
    Fixture f;
    const auto count = f.editor->geometry().stations.size();
    f.curves()->setFocus();
    QTest::keyClick(f.curves(), Qt::Key_Insert);
    QCOMPARE(f.editor->geometry().stations.size(), count + 1);
    // Halfway between two, on the straight line: the propeller is the same.
    QVERIFY(qAbs(f.station(1).chord - 0.5 * (f.station(0).chord + f.station(2).chord)) < 1e-12);
    QTest::keyClick(f.curves(), Qt::Key_Right);
    QTest::keyClick(f.curves(), Qt::Key_Delete);
    QVERIFY(f.editor->geometry() == PropellerGeometry{});
    QCOMPARE(f.model.undoStack()->count(), 2);
  }

  void faultIsSaidInsteadOfFigures() {
    Fixture f;
    f.model.set("setup.stand.load.propeller.stations[3].radius", 0.99);
    QTRY_VERIFY2(f.figures().contains("stations"), qPrintable(f.figures()));
  }

  void polarsBecomeASection() {
    Fixture f;
    const QTemporaryDir folder;
    const QString file = writePolar(folder, "flat.txt", kPolar);
    QVERIFY(f.editor->importPolars({file}, 0.5));
    const auto& sections = f.editor->geometry().sections;
    QCOMPARE(sections.size(), std::size_t{2});
    QCOMPARE(sections[1].radius, 0.5);
    const auto& section = std::get<PolarSection>(sections[1].model);
    QCOMPARE(QString::fromStdString(section.name), QString("flat"));
    QCOMPARE(section.polars.front().points.size(), std::size_t{3});
    QCOMPARE(f.model.undoStack()->count(), 1);
  }

  void brokenPolarLosesNothing() {
    Fixture f;
    const QTemporaryDir folder;
    const QString file = writePolar(folder, "broken.txt", "nothing of a polar\n");
    QVERIFY(!f.editor->importPolars({file}, 0.5));
    auto* message = f.editor->findChild<QLabel*>("propellerMessage");
    QVERIFY(message->isVisible());
    QVERIFY2(message->text().contains("broken.txt"), qPrintable(message->text()));
    QVERIFY(f.editor->geometry() == PropellerGeometry{});
  }

  /// The button, the sheet, its speed typed, and the coefficients in the propeller's place.
  void lumpedByAButton() {
    Fixture f(flight());
    const auto rotor = [&model = f.model]() -> const RotorAerodynamics& {
      const auto& vehicle = alternative<Flight>(model.as<Experiment>().setup).vehicle;
      return std::get<EqualRotors>(vehicle.rotors).rotor.aerodynamics;
    };
    auto* button = f.editor->findChild<QPushButton*>("lumpPropeller");
    QVERIFY(button->isEnabled());
    QTest::mouseClick(button, Qt::LeftButton);
    QPointer<QDialog> dialog = f.editor->findChild<QDialog*>("lumpedDialog");
    QVERIFY(dialog != nullptr && dialog->isVisible());
    auto* use = dialog->findChild<QPushButton*>("useLumped");
    QTRY_VERIFY(use->isEnabled());
    auto* speed = dialog->findChild<QLineEdit*>("speed");
    QVERIFY(speed != nullptr);
    speed->setFocus();
    speed->selectAll();
    QTest::keyClicks(speed, "4800");
    QTest::keyClick(speed, Qt::Key_Return);
    const auto* table = dialog->findChild<QTableWidget*>("figures");
    const auto reads = [table](const QString& text) {
      return !table->findItems(text, Qt::MatchContains).isEmpty();
    };
    QTRY_VERIFY(reads("4800"));
    QVERIFY(reads("Rolling moment, left out"));
    QTest::mouseClick(use, Qt::LeftButton);
    QTRY_VERIFY(dialog.isNull());
    const auto* lumped = std::get_if<RotorCoefficients>(&rotor());
    QVERIFY(lumped != nullptr);
    const BladeElementRotor blades{PropellerGeometry{}};
    const double w = 4800 * M_PI / 30, thrust = blades.axial(w, 0, {}).thrust;
    QVERIFY(std::abs(lumped->thrust * w * w / thrust - 1) < 1e-9);
    QTRY_VERIFY(f.editor.isNull());
    f.model.undoStack()->undo();
    QVERIFY(std::holds_alternative<BladeElementPropeller>(rotor()));
  }

  /// A load of a stand has no place for them, and the button says no.
  void noPlaceForLumped() {
    Fixture f;
    QVERIFY(!f.editor->findChild<QPushButton*>("lumpPropeller")->isEnabled());
  }

  void closesWhenThePropellerIsGone() {
    Fixture f;
    f.model.choose("setup.stand.load", 0);
    QTRY_VERIFY(f.editor.isNull());
  }
};

QTEST_MAIN(TestPropellerEditor)
#include "test_propeller_editor.moc"
