// The data-sheet wizard and the performance sheet as a person uses them: from the menu, typing,
// reading, applying, undoing.
#include <QClipboard>
#include <QDialogButtonBox>
#include <QMenu>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QUndoStack>
#include <cmath>

#include "sim/document/experiment.h"
#include "sim/document/flight.h"
#include "sim/document/motor_bench.h"
#include "tests/ui/shell/shell_fixture.h"
#include "ui/charts/chart_pane.h"
#include "ui/forms/parameter_form.h"
#include "ui/sizing/data_sheet_dialog.h"
#include "ui/sizing/figure_table.h"
#include "ui/sizing/performance_dialog.h"
#include "ui/sizing/throttle_chart.h"

using namespace rotorbench;

namespace {

/// The value a person reads beside a quantity in a group; empty where there is none.
QString readValue(const QWidget& dialog, const QString& group, const QString& quantity,
                  int column = 2) {
  const auto* table = dialog.findChild<QTableWidget*>("figures");
  QString at;
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->columnSpan(row, 0) > 1) {
      at = table->item(row, 0)->text();
    } else if (at == group && table->item(row, 0)->text() == quantity) {
      return table->item(row, column)->text();
    }
  }
  return {};
}

double readNumber(const QWidget& dialog, const QString& group, const QString& quantity) {
  return readValue(dialog, group, quantity).section(QChar(0xa0), 0, 0).toDouble();
}

QString warnings(const QWidget& dialog) {
  const auto* label = dialog.findChild<QLabel*>("sheetWarnings");
  return label->isVisible() ? label->text() : QString();
}

/// Types into a field of a dialog's form and commits with Enter.
void typeField(QWidget& dialog, const QString& path, const QString& text) {
  dialog.findChild<ParameterForm*>()->focusPlace(path);
  QLineEdit* edit = nullptr;
  QTRY_VERIFY((edit = dialog.findChild<QLineEdit*>(path)) != nullptr && edit->isVisible());
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, text);
  QTest::keyClick(edit, Qt::Key_Return);
}

template <class Dialog>
Dialog* openTool(MainWindow& window, const char* action) {
  window.findChild<QAction*>(action)->trigger();
  auto* dialog = window.findChild<Dialog*>();
  if (dialog != nullptr && !QTest::qWaitForWindowExposed(dialog)) return nullptr;
  return dialog;
}

}  // namespace

class TestSizing : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { useSettingsIn(folder_.path()); }
  void dataSheetIsTypedAndRead();
  void dataSheetGoesIntoTheVehicleAndOut();
  void dataSheetGoesIntoAStand();
  void withoutAMotorTheButtonExplains();
  void wrongSheetSaysWhatIsWrong();
  void performanceFollowsTheDocument();
  void performanceIsCopied();
  void performanceWithoutAVehicleExplains();
  void lastColumnIsWholeInASmallDialog();
  void figuresFollowTheLocale_data();
  void figuresFollowTheLocale();

 private:
  QTemporaryDir folder_;
};

void TestSizing::dataSheetIsTypedAndRead() {
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  auto* dialog = openTool<DataSheetDialog>(window, "toolDataSheet");
  QVERIFY(dialog != nullptr);
  // Starts from the experiment's motor: 960 rpm/V.
  QTRY_COMPARE(readValue(*dialog, "Motor", "Torque constant"), QString("9.947\u00a0mN\u00b7m/A"));
  QCOMPARE(readValue(*dialog, "Motor", "Torque constant", 3),
           QString("60/(2\u03c0 Kv), Kv in rpm/V"));
  const double before = readNumber(*dialog, "Hover", "Throttle");
  QVERIFY(before > 0);
  typeField(*dialog, "motor.speedConstant", "920");
  QTRY_COMPARE(readValue(*dialog, "Motor", "Torque constant"), QString("10.38\u00a0mN\u00b7m/A"));
  QVERIFY(readNumber(*dialog, "Hover", "Throttle") > before);
  // The chart has the curves and the hover point.
  auto* chart = dialog->findChild<ThrottleChart*>();
  QTRY_COMPARE(chart->pane().curves().curves.size(), std::size_t(4));
  QTRY_VERIFY(chart->pane().plot()->pointCount() > 20);  // straight pieces are joined
  // Too heavy: no hover, and why.
  QVERIFY(warnings(*dialog).isEmpty());
  typeField(*dialog, "vehicle.mass", "9 kg");
  QTRY_VERIFY(warnings(*dialog).contains("cannot carry the vehicle"));
  QCOMPARE(readValue(*dialog, "Hover", "Throttle"), QString("\u2013"));
  QVERIFY(readValue(*dialog, "Hover", "Throttle", 3).startsWith("full throttle gives"));
}

void TestSizing::dataSheetGoesIntoTheVehicleAndOut() {
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  const Experiment before = window.documents().experiment();
  auto* dialog = openTool<DataSheetDialog>(window, "toolDataSheet");
  typeField(*dialog, "motor.speedConstant", "920");
  auto* use = dialog->findChild<QPushButton*>("useDataSheet");
  QTRY_VERIFY(use->isEnabled());
  QTest::mouseClick(use, Qt::LeftButton);
  const auto motorOf = [&] {
    const auto& flight = alternative<Flight>(window.documents().experiment().setup);
    return std::get<EqualRotors>(flight.vehicle.rotors).rotor.motor;
  };
  QVERIFY(std::abs(motorOf().speedConstant - 920 * 0.10471975511965977) < 1e-9);
  QVERIFY(dialog->findChild<QLabel*>("dataSheetTarget")->text().contains("Undo"));
  QUndoStack* undo = window.documents().model().undoStack();
  QCOMPARE(undo->count(), 1);
  QCOMPARE(undo->undoText(), QString("Drive from a data sheet"));
  QVERIFY(!window.documents().model().hasErrors());
  // The vehicle keeps its mass, layout and drag.
  const auto& now = alternative<Flight>(window.documents().experiment().setup);
  QVERIFY(now.vehicle.mass == alternative<Flight>(before.setup).vehicle.mass);
  undo->undo();
  QVERIFY(window.documents().experiment() == before);
}

void TestSizing::dataSheetGoesIntoAStand() {
  MainWindow window;
  showWindow(window);
  openCard(window, "motor-bench-e305");
  auto* dialog = openTool<DataSheetDialog>(window, "toolDataSheet");
  typeField(*dialog, "motor.resistance", "90 mOhm");
  QTRY_VERIFY(dialog->findChild<QPushButton*>("useDataSheet")->isEnabled());
  QTest::mouseClick(dialog->findChild<QPushButton*>("useDataSheet"), Qt::LeftButton);
  const auto& bench = alternative<MotorBench>(window.documents().experiment().setup);
  QCOMPARE(bench.stand.motor.resistance, 0.09);
  // What was typed into the sheet afterwards is dropped by reading the experiment again.
  typeField(*dialog, "motor.resistance", "1 Ohm");
  QCOMPARE(dialog->sheet().as<DataSheet>().motor.resistance, 1.0);
  QTest::mouseClick(dialog->findChild<QPushButton*>("readDataSheet"), Qt::LeftButton);
  QCOMPARE(dialog->sheet().as<DataSheet>().motor.resistance, 0.09);
}

void TestSizing::withoutAMotorTheButtonExplains() {
  MainWindow window;
  showWindow(window);
  openCard(window, "spring-bar-birotor");
  auto* dialog = openTool<DataSheetDialog>(window, "toolDataSheet");
  QVERIFY(!dialog->findChild<QPushButton*>("useDataSheet")->isEnabled());
  QVERIFY(!dialog->findChild<QPushButton*>("readDataSheet")->isEnabled());
  QVERIFY(dialog->findChild<QLabel*>("dataSheetTarget")->text().contains("has no motor"));
  QTRY_VERIFY(!readValue(*dialog, "Full throttle", "Thrust to weight").isEmpty());
}

void TestSizing::wrongSheetSaysWhatIsWrong() {
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  auto* dialog = openTool<DataSheetDialog>(window, "toolDataSheet");
  QTRY_VERIFY(!readValue(*dialog, "Motor", "Torque constant").isEmpty());
  typeField(*dialog, "motor.noLoadCurrent", "500");  // more than V0/R
  QTRY_VERIFY(warnings(*dialog).contains("could not turn"));
  QVERIFY(!dialog->findChild<QPushButton*>("useDataSheet")->isEnabled());
  typeField(*dialog, "motor.noLoadCurrent", "0.45");
  QTRY_COMPARE(readValue(*dialog, "Motor", "No-load torque"), QString("4.476\u00a0mN\u00b7m"));
  QVERIFY(dialog->findChild<QPushButton*>("useDataSheet")->isEnabled());
}

void TestSizing::performanceFollowsTheDocument() {
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  auto* dialog = openTool<PerformanceDialog>(window, "toolPerformance");
  QVERIFY(dialog != nullptr);
  QTRY_VERIFY(readNumber(*dialog, "Thrust", "Thrust to weight") > 0);
  QVERIFY(readValue(*dialog, "Thrust", "Thrust to weight", 3).contains("current limit of 20 A"));
  const double light = readNumber(*dialog, "Thrust", "Thrust to weight");
  const double payload = readNumber(*dialog, "Payload", "Largest payload");
  typeInto(window, "setup.vehicle.mass.mass", "2.8 kg");
  QTRY_VERIFY(std::abs(readNumber(*dialog, "Thrust", "Thrust to weight") - light / 2) < 2e-3);
  // Less throttle allowed is less payload.
  typeInto(window, "setup.vehicle.mass.mass", "1.4 kg");
  QTRY_COMPARE(readNumber(*dialog, "Payload", "Largest payload"), payload);
  typeField(*dialog, "payloadThrottle", "60");
  QTRY_VERIFY(readNumber(*dialog, "Payload", "Largest payload") < payload);
  QVERIFY(readValue(*dialog, "Payload", "Largest payload", 3).contains("60 % throttle"));
  // Nothing of that touches the experiment.
  QCOMPARE(window.documents().model().undoStack()->count(), 2);
}

void TestSizing::performanceIsCopied() {
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  auto* dialog = openTool<PerformanceDialog>(window, "toolPerformance");
  QTRY_VERIFY(readNumber(*dialog, "Thrust", "Thrust to weight") > 0);
  QTest::mouseClick(dialog->findChild<QPushButton*>("copyPerformanceCsv"), Qt::LeftButton);
  const QString csv = QGuiApplication::clipboard()->text();
  QVERIFY(csv.startsWith("group,quantity,symbol,value,unit,formula,note\n"));
  QVERIFY(csv.contains("Thrust,Thrust to weight,T/W,2.8"));
  QTest::mouseClick(dialog->findChild<QPushButton*>("copyPerformanceText"), Qt::LeftButton);
  QVERIFY(QGuiApplication::clipboard()->text().contains("Largest payload"));
}

void TestSizing::performanceWithoutAVehicleExplains() {
  MainWindow window;
  showWindow(window);
  openCard(window, "motor-bench-e305");
  auto* dialog = openTool<PerformanceDialog>(window, "toolPerformance");
  QTRY_VERIFY(warnings(*dialog).contains("has no vehicle"));
  QVERIFY(!dialog->findChild<QPushButton*>("copyPerformanceCsv")->isEnabled());
}

void TestSizing::lastColumnIsWholeInASmallDialog() {
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  auto* dialog = openTool<PerformanceDialog>(window, "toolPerformance");
  dialog->resize(640, 420);
  QTRY_VERIFY(readNumber(*dialog, "Thrust", "Thrust to weight") > 0);
  const auto* table = dialog->findChild<QTableWidget*>("figures");
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->columnSpan(row, 0) > 1) continue;
    const QString text = table->item(row, 3)->text();
    const int width = table->columnWidth(3) - 8;
    const QRect needed =
        table->fontMetrics().boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, text);
    QVERIFY2(needed.height() <= table->rowHeight(row) + 2, qPrintable(text));
  }
}

void TestSizing::figuresFollowTheLocale_data() {
  QTest::addColumn<QLocale>("locale");
  QTest::addRow("German") << QLocale(QLocale::German, QLocale::Germany);
  QTest::addRow("C") << QLocale::c();
}

/// Every number of both sheets, in cells, tool tips, warnings and the copied text, has the decimal
/// sign of the locale; the CSV has points whatever the locale.
void TestSizing::figuresFollowTheLocale() {
  QFETCH(QLocale, locale);
  const QLocale before;
  QLocale::setDefault(locale);
  const auto restore = qScopeGuard([&] { QLocale::setDefault(before); });
  const bool comma = locale.decimalPoint() == ",";
  const QRegularExpression wrong(comma ? "\\d\\.\\d" : "\\d,\\d");
  const QRegularExpression right(comma ? "\\d,\\d" : "\\d\\.\\d");
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  for (const char* action : {"toolDataSheet", "toolPerformance"}) {
    auto* dialog = openTool<QDialog>(window, action);
    QVERIFY(dialog != nullptr);
    const char* group = action == QByteArray("toolDataSheet") ? "Full throttle" : "Thrust";
    QTRY_VERIFY(!readValue(*dialog, group, "Thrust to weight").isEmpty());
    QVERIFY(readValue(*dialog, group, "Thrust to weight").contains(right));
    // Sentences with decimals are in no note of this vehicle until a limit has some.
    if (action == QByteArray("toolPerformance")) {
      typeField(*dialog, "payloadThrottle", comma ? "79,5" : "79.5");
      QTRY_VERIFY(
          readValue(*dialog, "Payload", "Largest payload", 3).contains(comma ? "79,5" : "79.5"));
    }
    const auto* table = dialog->findChild<QTableWidget*>("figures");
    int numbers = 0;
    for (int row = 0; row < table->rowCount(); ++row) {
      for (int c = 0; c < table->columnCount(); ++c) {
        const auto* item = table->item(row, c);
        if (item == nullptr) continue;
        // Sources name chapters and figures by numbers of their own.
        const QString tip = item->toolTip().section('\n', 0, 1).remove("figure 3.11");
        QVERIFY2(!item->text().contains(wrong), qPrintable(item->text()));
        QVERIFY2(!tip.contains(wrong), qPrintable(tip));
        if (c == 3 && item->text().contains(right)) ++numbers;
      }
    }
    QVERIFY(numbers > 0);
    auto* copy = dialog->findChild<QPushButton*>(
        action == QByteArray("toolDataSheet") ? "copyDataSheet" : "copyPerformanceText");
    QTest::mouseClick(copy, Qt::LeftButton);
    QVERIFY(QGuiApplication::clipboard()->text().contains(right));
    QVERIFY(!QGuiApplication::clipboard()->text().contains(wrong));
    if (auto* csv = dialog->findChild<QPushButton*>("copyPerformanceCsv")) {
      QTest::mouseClick(csv, Qt::LeftButton);
      QVERIFY(QGuiApplication::clipboard()->text().contains("Thrust,Thrust to weight,T/W,2.8"));
    } else {
      typeField(*dialog, "vehicle.mass", "3 kg");
      QTRY_VERIFY(warnings(*dialog).contains("Full throttle gives only"));
      QVERIFY2(warnings(*dialog).contains(right), qPrintable(warnings(*dialog)));
      QVERIFY2(!warnings(*dialog).contains(wrong), qPrintable(warnings(*dialog)));
    }
    const QPointer<QDialog> closing(dialog);
    dialog->close();
    QTRY_VERIFY(closing.isNull());
  }
}

QTEST_MAIN(TestSizing)
#include "test_sizing.moc"
