// The number of rotors chosen in the form: inputs and tables grow and shrink with it, in one step
// of undo.
#include <QComboBox>
#include <QLineEdit>
#include <QTableView>
#include <QtTest>

#include "sim/document/experiment.h"
#include "sim/document/kinds.h"
#include "ui/forms/experiment_panel.h"

using namespace rotorbench;

namespace {

Experiment prescribed(const SpeedInputs& inputs) {
  Experiment e;
  Flight flight;
  flight.control = inputs;
  e.setup = flight;
  return e;
}

class Form {
 public:
  explicit Form(const Experiment& e) : model(makeDocument(e)), panel(&model, nullptr) {
    panel.resize(480, 900);
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
  }
  template <class W = QLineEdit>
  W* at(const QString& path) {
    panel.jumpTo(path);
    return panel.findChild<W*>(path);
  }
  void chooseCount(int steps) {
    auto* box = at<QComboBox>("setup.vehicle.layout.count");
    QVERIFY(box != nullptr);
    box->setFocus();
    for (int i = 0; i < std::abs(steps); ++i)
      QTest::keyClick(box, steps > 0 ? Qt::Key_Down : Qt::Key_Up);
  }
  const Flight& flight() { return alternative<Flight>(model.as<Experiment>().setup); }

  DocumentModel model;
  ExperimentPanel panel;
};

}  // namespace

class TestRotorCountForm : public QObject {
  Q_OBJECT
 private slots:
  void boxesFollow() {
    SpeedInputs inputs;
    inputs.source = ConstantInputs<RotorSpeedQuantity>{{100, 200, 300, 400}};
    Form form(prescribed(inputs));
    const QString speeds = "setup.control.source.speeds";
    QVERIFY(form.at(speeds + "[3]") != nullptr);
    QVERIFY(form.at(speeds + "[4]") == nullptr);
    form.chooseCount(1);
    QCOMPARE(rotorCount(form.flight().vehicle.layout), 6);
    QVERIFY(!form.model.hasErrors());
    QTRY_VERIFY(form.at(speeds + "[5]") != nullptr);
    QVERIFY(form.at(speeds + "[6]") == nullptr);
    QCOMPARE(form.at(speeds + "[5]")->text(), form.at(speeds + "[3]")->text());
    QVERIFY(form.at(speeds + "[5]")->accessibleName().contains("6"));
    // One step back, not two.
    QCOMPARE(form.model.undoStack()->count(), 1);
    form.model.undoStack()->undo();
    QCOMPARE(rotorCount(form.flight().vehicle.layout), 4);
    QVERIFY(form.model.isClean() && !form.model.hasErrors());
    QTRY_VERIFY(form.at(speeds + "[4]") == nullptr);
    form.model.undoStack()->redo();
    QTRY_VERIFY(form.at(speeds + "[5]") != nullptr);
  }

  void columnsFollow() {
    SpeedInputs inputs;
    TableInputs<RotorSpeedQuantity> table;
    table.rows = {{0, {1, 2, 3, 4}}, {1, {5, 6, 7, 8}}};
    inputs.source = table;
    Form form(prescribed(inputs));
    const QString rows = "setup.control.source.rows";
    auto* view = form.at<QTableView>(rows);
    QVERIFY(view != nullptr);
    QCOMPARE(view->model()->columnCount(), 5);
    form.chooseCount(2);
    QCOMPARE(rotorCount(form.flight().vehicle.layout), 8);
    QTRY_VERIFY(form.at<QTableView>(rows) != nullptr &&
                form.at<QTableView>(rows)->model()->columnCount() == 9);
    // A row that is added is as long as the others.
    form.model.insertElement(rows, 2);
    QVERIFY(std::get<TableInputs<RotorSpeedQuantity>>(
                std::get<SpeedInputs>(form.flight().control).source)
                .rows[2]
                .values.size() == 8);
    view = form.at<QTableView>(rows);
    QCOMPARE(view->model()->rowCount(), 3);
    QVERIFY(!view->model()->data(view->model()->index(2, 8)).toString().isEmpty());
    while (form.model.undoStack()->canUndo()) form.model.undoStack()->undo();
    QTRY_VERIFY(form.at<QTableView>(rows)->model()->columnCount() == 5);
  }
};

QTEST_MAIN(TestRotorCountForm)
#include "test_rotor_count_form.moc"
