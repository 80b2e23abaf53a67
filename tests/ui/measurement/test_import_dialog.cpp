// The import as a person does it: a file is named, columns are chosen, sentences are read, a
// measured run appears.
#include <QSignalSpy>
#include <QSpinBox>
#include <cmath>
#include <filesystem>

#include "tests/ui/measurement/import_fixture.h"

using namespace rotorbench;

namespace {

const QString kLog = QStringLiteral(TEST_DATA_DIR "/measurement/strawson_a1_11.csv");

}  // namespace

class TestImportDialog : public QObject {
  Q_OBJECT
 private slots:
  void importsALog();
  void remembersTheMapping();
  void brokenFiles_data();
  void brokenFiles();
  void layoutIsCorrected();
  void quantityAndUnitAreChosen();
  void gigabyteLongLine();

 private:
  const ImportFolder folder_;
};

void TestImportDialog::importsALog() {
  Opened opened(kLog);
  QVERIFY2(opened.report().startsWith("11 row(s) of time, throttle, thrust, supply.voltage"),
           qPrintable(opened.report()));
  auto* name = opened.child<QLineEdit>("importName");
  QCOMPARE(name->text(), QString("strawson_a1_11"));
  name->selectAll();
  QTest::keyClicks(name, "EMAX on the stand");
  QSignalSpy said(opened.dialog, &ImportDialog::imported);
  QTest::mouseClick(opened.ok(), Qt::LeftButton);
  QCOMPARE(said.size(), 1);
  QCOMPARE(opened.runs.records().size(), std::size_t{1});
  const RunRecord& record = opened.runs.records().front();
  QVERIFY(record.measured && record.visible);
  QCOMPARE(record.name, QString("EMAX on the stand"));
  QCOMPARE(runDetail(record), QString("Measured, 11 row(s)"));
  QVERIFY(record.note.contains("strawson_a1_11.csv"));
  QCOMPARE(record.status.outputs.front().recording->rows(), std::size_t{11});
}

void TestImportDialog::remembersTheMapping() {
  const QString file = folder_.write("again.csv", "time [s],a [N]\n0,1\n1,2\n");
  {
    Opened first(file);
    first.choose("quantity1", "Thrust");
    QTRY_VERIFY(first.report().startsWith("2 row(s) of time, thrust"));
    QTest::mouseClick(first.ok(), Qt::LeftButton);
  }
  Opened second(folder_.write("other.csv", "time [s],a [N]\n0,5\n"));
  QVERIFY2(second.report().startsWith("1 row(s) of time, thrust"), qPrintable(second.report()));
}

void TestImportDialog::brokenFiles_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("sentence");
  QTest::addColumn<bool>("usable");
  QTest::addRow("empty") << QByteArray() << "The file is empty." << false;
  QTest::addRow("zero bytes") << QByteArray("a,b\n\0\n", 6) << "zero bytes" << false;
  QTest::addRow("cut off gzip") << QByteArray("\x1F\x8B\x08") << "is cut off" << false;
  QTest::addRow("damaged gzip") << QByteArray("\x1F\x8B\x08\xFF-----------") << "is damaged"
                                << false;
  QTest::addRow("spreadsheet") << QByteArray("PK\x03\x04") << "compressed" << false;
  QTest::addRow("propeller table without a speed")
      << QByteArray("8x6\nPROP RPM =\n V J Ct Cp\n 0 0 0.1 0.05\n")
      << "Line 2: the block of the propeller table has no speed" << false;
  QTest::addRow("time of another order")
      << QByteArray("time,thrust [N]\n03/01/2024 12:00:00,1\n")
      << "times are read as 2024-03-01T12:00:00.25 or 12:00:00.25" << false;
  QTest::addRow("no known columns") << QByteArray("a,b\n1,2\n") << "No column is chosen." << false;
  QTest::addRow("only names") << QByteArray("time,thrust\n") << "no rows below the names" << false;
  QTest::addRow("text in numbers") << QByteArray("time [s],thrust [N]\n0,1\n1,two\n2,3\n")
                                   << "1 cell is not a number (first in line 3: \"two\")" << true;
  QTest::addRow("missing cells") << QByteArray("time [s],thrust [N]\n0,1\n1\n2,3\n")
                                 << "1 row has fewer cells than there are columns" << true;
  QTest::addRow("long line") << "time [s],thrust [N]\n0,1\n" + QByteArray(2 << 20, '5') + "\n1,2\n"
                             << "1 line is longer than 1 MiB (first in line 3)" << true;
}

void TestImportDialog::brokenFiles() {
  QFETCH(QByteArray, text);
  QFETCH(QString, sentence);
  QFETCH(bool, usable);
  const Opened opened(folder_.write("broken.csv", text));
  QVERIFY2(opened.report().contains(sentence, Qt::CaseInsensitive), qPrintable(opened.report()));
  QCOMPARE(opened.ok()->isEnabled(), usable);
}

void TestImportDialog::layoutIsCorrected() {
  const QString file = folder_.write("comma.csv", "time [s];thrust [N]\n0;1,5\n1;2,5\n");
  const Opened opened(file);
  QCOMPARE(opened.child<QComboBox>("importSeparator")->currentText(), QString("Semicolon"));
  QCOMPARE(opened.child<QComboBox>("importDecimalMark")->currentText(), QString("Comma"));
  QVERIFY(opened.ok()->isEnabled());
  opened.choose("importDecimalMark", "Point");
  QTRY_VERIFY2(opened.report().contains("is the decimal mark a comma?"),
               qPrintable(opened.report()));
  opened.choose("importSeparator", "Tab");
  QTRY_VERIFY(!opened.ok()->isEnabled());
  opened.choose("importSeparator", "Semicolon");
  opened.choose("importDecimalMark", "Comma");
  QTRY_VERIFY(opened.ok()->isEnabled());
  QTRY_COMPARE(opened.report(), QString("2 row(s) of time, thrust will be imported."));
}

void TestImportDialog::quantityAndUnitAreChosen() {
  Opened opened(folder_.write("units.csv", "throttle,load\n20,100\n80,400\n"));
  QCOMPARE(opened.child<QComboBox>("importGroup")->currentText(),
           QString("Steady points over the throttle"));
  opened.choose("quantity1", "Thrust");
  opened.choose("unit1", "gf");
  QTRY_VERIFY(opened.report().contains("over_throttle.thrust"));
  opened.choose("quantity0", "Thrust");
  QTRY_VERIFY2(opened.report().contains("is chosen twice"), qPrintable(opened.report()));
  QVERIFY(!opened.ok()->isEnabled());
  opened.choose("quantity0", "Throttle");
  QTRY_VERIFY(opened.ok()->isEnabled());
  QTest::mouseClick(opened.ok(), Qt::LeftButton);
  const Recording& recording = *opened.runs.records().front().status.outputs.front().recording;
  QVERIFY(std::abs(recording.value(1, 1) - 0.4 * 9.80665) < 1e-12);
}

/// A line of a gigabyte is refused at once, and the dialog goes on with the next file.
void TestImportDialog::gigabyteLongLine() {
  const QString huge = folder_.write("huge.csv", "time [s],thrust [N]\n0,1\n");
  std::filesystem::resize_file(huge.toStdString(), std::uintmax_t{1} << 30);
  Opened opened(huge);
  QVERIFY2(opened.report().contains("64 MiB"), qPrintable(opened.report()));
  QVERIFY(!opened.ok()->isEnabled());
  opened.dialog->openFile(folder_.write("small.csv", "time [s],thrust [N]\n0,1\n1,2\n"));
  QTRY_VERIFY2(opened.ok()->isEnabled(), qPrintable(opened.report()));
}

QTEST_MAIN(TestImportDialog)
#include "test_import_dialog.moc"
