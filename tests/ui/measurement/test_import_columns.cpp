// The import's choices as a person makes them: scale, offset and comment mark are typed, the table
// and the sentences follow, times as text, compressed files and the tables of propellers are
// understood.
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "sim/library/component_library.h"
#include "sim/propulsion/rotor/measured_propeller.h"
#include "tests/ui/measurement/import_fixture.h"
#include "ui/library/component_info_dialog.h"
#include "ui/library/library_dialog.h"

using namespace rotorbench;

namespace {

const QString kLog = QStringLiteral(TEST_DATA_DIR "/measurement/strawson_a1_11.csv");
const QString kPropeller = QStringLiteral(TEST_DATA_DIR "/measurement/PER3_8x6S.dat");

}  // namespace

class TestImportColumns : public QObject {
  Q_OBJECT
 private slots:
  void scaleAndOffset();
  void scaleIsNoNumber_data();
  void scaleIsNoNumber();
  void commentMark();
  void choicesOfAnEditedLayoutAreRemembered();
  void tabGoesThroughTheChoices();
  void timesAsText();
  void compressedFile();
  void propellerTable();
  void propellerIsSaved();
  void propellerWithoutADiameter();
  void layoutOfLastTimeDoesNotFit();

 private:
  const ImportFolder folder_;
};

void TestImportColumns::scaleAndOffset() {
  const QString file = folder_.write("raw.csv", "time [s],load cell\n0,100\n1,300\n");
  {
    Opened opened(file);
    QVERIFY(!opened.child<QLineEdit>("scale1")->isEnabled());  // a column that is left out
    opened.choose("quantity1", "Thrust");
    opened.choose("unit1", "N");
    QTRY_COMPARE(opened.range(1), QString("100 … 300 N"));
    opened.type("scale1", "1/50");
    QTRY_COMPARE(opened.range(1), QString("2 … 6 N"));
    opened.type("offset1", "-0,5");
    QTRY_COMPARE(opened.range(1), QString("1.5 … 5.5 N"));
    // Enter takes the number over and leaves the dialog open.
    auto* scale = opened.child<QLineEdit>("scale0");
    scale->setFocus();
    scale->selectAll();
    QTest::keyClicks(scale, "2");
    QTest::keyClick(scale, Qt::Key_Return);
    QTRY_COMPARE(opened.range(0), QString("0 … 2 s"));
    QVERIFY(opened.dialog->isVisible());
    QTest::mouseClick(opened.ok(), Qt::LeftButton);
    const Recording& recording = *opened.runs.records().front().status.outputs.front().recording;
    QCOMPARE(recording.value(0, 1), 2.0);
    QVERIFY(std::abs(recording.value(1, 1) - 5.5) < 1e-12);
  }
  const Opened again(file);
  QCOMPARE(again.child<QLineEdit>("scale1")->text(), QString("0.02"));
  QCOMPARE(again.child<QLineEdit>("offset1")->text(), QString("-0.5"));
  QCOMPARE(again.range(1), QString("1.5 … 5.5 N"));
}

void TestImportColumns::scaleIsNoNumber_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("sentence");
  QTest::addRow("words") << "fast"
                         << "Column “thrust”, scale: \"fast\" is not a number";
  QTest::addRow("empty") << ""
                         << "Column “thrust”, scale: ";
  QTest::addRow("0")
      << "0"
      << "Column \"thrust\": the scale or the offset cannot be used. Must be finite, "
         "the scale not 0.";
  QTest::addRow("endless") << "1e999"
                           << "Column “thrust”, scale: ";
  QTest::addRow("a unit") << "3 kg"
                          << "Column “thrust”, scale: ";
}

void TestImportColumns::scaleIsNoNumber() {
  QFETCH(QString, text);
  QFETCH(QString, sentence);
  const Opened opened(folder_.write("scale.csv", "time [s],thrust [N]\n0,1\n1,2\n"));
  opened.type("scale1", text);
  QTRY_VERIFY(!opened.ok()->isEnabled());
  QVERIFY2(opened.report().startsWith(sentence), qPrintable(opened.report()));
  QCOMPARE(opened.report().count('\n'), 0);
  opened.type("scale1", "2");
  QTRY_VERIFY(opened.ok()->isEnabled());
  QCOMPARE(opened.range(1), QString("2 … 4 N"));
}

void TestImportColumns::commentMark() {
  const Opened opened(folder_.write("marks.csv", "time [s],thrust [N]\n0,1\n//1,50\n1,2\n"));
  QCOMPARE(opened.child<QLineEdit>("importComment")->text(), QString("#"));
  const auto firstCells = [&] {
    QStringList cells;
    const auto* table = opened.child<MappingTable>("importTable");
    for (int r = MappingTable::kFirstDataRow; r < table->rowCount(); ++r)
      cells << table->item(r, 0)->text();
    return cells;
  };
  QCOMPARE(firstCells(), QStringList({"0", "//1", "1"}));
  QVERIFY2(opened.report().contains("//1"), qPrintable(opened.report()));
  auto* edit = opened.child<QLineEdit>("importComment");
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, "//");
  QCOMPARE(firstCells(), QStringList({"0", "1"}));
  QTRY_COMPARE(opened.report(), QString("2 row(s) of time, thrust will be imported."));
  QTest::keyClick(edit, Qt::Key_Return);
  QVERIFY(opened.dialog->isVisible());  // Enter in a line does not import
}

/// What was chosen is found again although the guess for the next file is the same wrong one.
void TestImportColumns::choicesOfAnEditedLayoutAreRemembered() {
  const QByteArray text = "x,y\n%a,b\n0,1\n1,2\n";
  {
    Opened first(folder_.write("edited.csv", text));
    first.type("importComment", "%");
    first.child<QSpinBox>("importHeaderLine")->setValue(2);
    first.child<QSpinBox>("importSkippedLines")->setValue(0);
    first.choose("quantity0", "Time");
    first.choose("quantity1", "Thrust");
    QTRY_VERIFY2(first.report().startsWith("2 row(s) of time, thrust"), qPrintable(first.report()));
    QTest::mouseClick(first.ok(), Qt::LeftButton);
  }
  const Opened second(folder_.write("edited2.csv", text + "2,3\n"));
  QCOMPARE(second.child<QLineEdit>("importComment")->text(), QString("%"));
  QVERIFY2(second.report().startsWith("3 row(s) of time, thrust"), qPrintable(second.report()));
}

void TestImportColumns::tabGoesThroughTheChoices() {
  const Opened opened(folder_.write("tab.csv", "time [s],thrust [N]\n0,1\n1,2\n"));
  opened.child<QComboBox>("quantity0")->setFocus();
  QStringList names;
  for (int i = 0; i < 8; ++i) {
    const QWidget* focused = opened.dialog->focusWidget();
    QVERIFY2(!focused->accessibleName().isEmpty(), qPrintable(focused->objectName()));
    names << focused->objectName();
    QTest::keyClick(opened.dialog->focusWidget(), Qt::Key_Tab);
  }
  QCOMPARE(names, QStringList({"quantity0", "unit0", "scale0", "offset0", "quantity1", "unit1",
                               "scale1", "offset1"}));
}

void TestImportColumns::timesAsText() {
  Opened opened(folder_.write("times.csv",
                              "Timestamp,thrust [N]\n23:59:59.5,1\n00:00:00.75,2\n00:00:02,3\n"));
  QCOMPARE(opened.report(), QString("3 row(s) of time, thrust will be imported."));
  QCOMPARE(opened.range(0), QString("0 … 2.5 s"));
  opened.choose("unit0", "ms");
  QTRY_VERIFY2(opened.report().contains("The unit must be s."), qPrintable(opened.report()));
  opened.choose("unit0", "s");
  QTRY_VERIFY(opened.ok()->isEnabled());
}

/// "time [s],thrust [N]\n0,1\n1,2\n" as gzip 1.12 packs it with option -n.
void TestImportColumns::compressedFile() {
  const QByteArray packed = QByteArray::fromHex(
      "1f8b08000000000000032bc9cc4d55882e8ed529c9282a2d2e5188f68be532d031e432d431e202000b95b33d1c00"
      "0000");
  Opened opened(folder_.write("log.csv.gz", packed));
  QCOMPARE(opened.report(), QString("2 row(s) of time, thrust will be imported."));
  QCOMPARE(opened.child<QLineEdit>("importName")->text(), QString("log"));
}

void TestImportColumns::propellerTable() {
  Opened opened(kPropeller);
  QVERIFY2(opened.report().startsWith("43 row(s) of over_advance.j, over_advance.speed"),
           qPrintable(opened.report()));
  QVERIFY(opened.report().contains("in line 76"));
  QCOMPARE(opened.child<QComboBox>("importGroup")->currentText(),
           QString("Propeller over the advance ratio"));
  QVERIFY(opened.child<QComboBox>("importSpeed")->isVisible());
  QCOMPARE(opened.child<QComboBox>("importSpeed")->count(), 4);
  opened.choose("importSpeed", "Curve of 5000 rpm");
  QTRY_VERIFY2(opened.report().startsWith("15 row(s)"), qPrintable(opened.report()));
  QCOMPARE(opened.range(0), QString("523.6 … 523.6 rad/s"));
  QTest::mouseClick(opened.ok(), Qt::LeftButton);
  QCOMPARE(opened.runs.records().front().status.outputs.front().recording->rows(), std::size_t{15});
  // Tables without curves have nothing of this.
  const Opened other(kLog);
  QVERIFY(!other.child<QComboBox>("importSpeed")->isVisible());
  QVERIFY(!other.child<QPushButton>("importSavePropeller")->isVisible());
}

void TestImportColumns::propellerIsSaved() {
  Opened opened(kPropeller);
  opened.choose("importSpeed", "Curve of 9000 rpm");  // what is saved has all speeds
  QCOMPARE(opened.child<QLineEdit>("importDiameter")->text(), QString("8"));
  QTest::mouseClick(opened.child<QPushButton>("importSavePropeller"), Qt::LeftButton);
  QWidget* question = nullptr;
  QTRY_VERIFY((question = opened.dialog->findChild<ComponentInfoDialog*>()) != nullptr);
  auto* name = question->findChild<QLineEdit*>();
  QCOMPARE(name->text(), QString("8x6S"));
  QTest::keyClick(name, Qt::Key_Return);
  QTRY_COMPARE(opened.report(), QString("“8x6S” is in the component library."));
  const ComponentLibrary library(shippedLibraryDirectory(), ownLibraryDirectory());
  const auto found = std::ranges::find_if(library.entries(), [](const LibraryEntry& e) {
    return e.own && e.component.info.name == "8x6S";
  });
  QVERIFY(found != library.entries().end());
  const auto* propeller = found->component.as<MeasuredPropeller>();
  QVERIFY(propeller != nullptr);
  QCOMPARE(propeller->points.size(), std::size_t{43});
  QVERIFY(std::abs(propeller->diameter - 8 * 0.0254) < 1e-12);
  QVERIFY(QString::fromStdString(found->component.info.source).contains("PER3_8x6S.dat"));
}

void TestImportColumns::propellerWithoutADiameter() {
  Opened opened(folder_.write("tunnel.csv", "J,CT,CP\n0,0.1,0.05\n0.3,0.06,0.04\n"));
  QCOMPARE(opened.child<QLineEdit>("importDiameter")->text(), QString());
  QTest::mouseClick(opened.child<QPushButton>("importSavePropeller"), Qt::LeftButton);
  QVERIFY2(opened.report().startsWith("Give the diameter of the propeller: "),
           qPrintable(opened.report()));
  opened.type("importDiameter", "25.4 cm");
  QTest::mouseClick(opened.child<QPushButton>("importSavePropeller"), Qt::LeftButton);
  QTRY_VERIFY(opened.dialog->findChild<ComponentInfoDialog*>() != nullptr);
}

/// The same columns below a longer preamble: the choices hold, the lines are found anew.
void TestImportColumns::layoutOfLastTimeDoesNotFit() {
  const QByteArray table = "time [s],cell\n0,1\n1,2\n";
  {
    Opened first(folder_.write("short.csv", "Stand 7\n" + table));
    first.choose("quantity1", "Thrust");
    first.type("scale1", "3");
    QTRY_VERIFY(first.ok()->isEnabled());
    QTest::mouseClick(first.ok(), Qt::LeftButton);
  }
  const Opened second(folder_.write("long.csv", "Stand 7\nOperator K\nWindy\n" + table));
  QCOMPARE(second.report(), QString("2 row(s) of time, thrust will be imported."));
  QCOMPARE(second.child<QLineEdit>("scale1")->text(), QString("3"));
  QCOMPARE(second.range(1), QString("3 … 6 N"));
}

QTEST_MAIN(TestImportColumns)
#include "test_import_columns.moc"
