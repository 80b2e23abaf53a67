// The import as a person does it: a file is named, columns are chosen, sentences are read, a measured run appears.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sim/library/component_library.h"
#include "sim/propulsion/measured_propeller.h"
#include "ui/library/component_info_dialog.h"
#include "ui/library/library_dialog.h"
#include "ui/measurement/import_dialog.h"
#include "ui/measurement/mapping_table.h"

using namespace rotorbench;

namespace {

const QString kLog = QStringLiteral(TEST_DATA_DIR "/measurement/strawson_a1_11.csv");
const QString kPropeller = QStringLiteral(TEST_DATA_DIR "/measurement/PER3_8x6S.dat");

/// A dialog that a file was typed into.
struct Opened {
  RunList runs;
  QPointer<ImportDialog> dialog = new ImportDialog(runs);

  explicit Opened(const QString& file) {
    dialog->show();
    dialog->activateWindow();
    if (!QTest::qWaitForWindowActive(dialog)) qFatal("no active window");
    auto* edit = child<QLineEdit>("importFile");
    edit->setFocus();
    QTest::keyClicks(edit, file);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  ~Opened() { delete dialog; }

  template <class W>
  [[nodiscard]] W* child(const char* name) const {
    return dialog->findChild<W*>(name);
  }
  [[nodiscard]] QString report() const {
    return child<QPlainTextEdit>("importReport")->toPlainText();
  }
  [[nodiscard]] QPushButton* ok() const {
    return dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  }
  /// Types into a line as a person does, and leaves it by the Tab key.
  void type(const char* line, const QString& text) const {
    auto* edit = child<QLineEdit>(line);
    QVERIFY2(edit != nullptr && edit->isEnabled(), line);
    edit->setFocus();
    edit->selectAll();
    if (text.isEmpty()) QTest::keyClick(edit, Qt::Key_Delete);
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Tab);
  }
  /// What stands below a column's choices: "0.145 … 1".
  [[nodiscard]] QString range(int column) const {
    return child<MappingTable>("importTable")->item(MappingTable::kRangeRow, column)->text();
  }
  void choose(const char* box, const QString& text) const {
    auto* combo = child<QComboBox>(box);
    QVERIFY2(combo != nullptr, box);
    const int index = combo->findText(text);
    QVERIFY2(index >= 0, qPrintable(text));
    combo->setCurrentIndex(index);
  }
};

}  // namespace

class TestImportDialog : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void importsALog();
  void remembersTheMapping();
  void brokenFiles_data();
  void brokenFiles();
  void layoutIsCorrected();
  void quantityAndUnitAreChosen();
  void gigabyteLongLine();
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

 private:
  QString write(const QString& name, const QByteArray& text) const;
  QTemporaryDir folder_;
};

void TestImportDialog::initTestCase() {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
  qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
  QApplication::setOrganizationName("Rotorbench");
  QApplication::setApplicationName("Rotorbench");
}

QString TestImportDialog::write(const QString& name, const QByteArray& text) const {
  QFile file(folder_.filePath(name));
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("cannot write");
  return file.fileName();
}

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
  const QString file = write("again.csv", "time [s],a [N]\n0,1\n1,2\n");
  {
    Opened first(file);
    first.choose("quantity1", "Thrust");
    QTRY_VERIFY(first.report().startsWith("2 row(s) of time, thrust"));
    QTest::mouseClick(first.ok(), Qt::LeftButton);
  }
  Opened second(write("other.csv", "time [s],a [N]\n0,5\n"));
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
  const Opened opened(write("broken.csv", text));
  QVERIFY2(opened.report().contains(sentence, Qt::CaseInsensitive), qPrintable(opened.report()));
  QCOMPARE(opened.ok()->isEnabled(), usable);
}

void TestImportDialog::layoutIsCorrected() {
  const QString file = write("comma.csv", "time [s];thrust [N]\n0;1,5\n1;2,5\n");
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
  Opened opened(write("units.csv", "throttle,load\n20,100\n80,400\n"));
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
  const QString huge = write("huge.csv", "time [s],thrust [N]\n0,1\n");
  std::filesystem::resize_file(huge.toStdString(), std::uintmax_t{1} << 30);
  Opened opened(huge);
  QVERIFY2(opened.report().contains("64 MiB"), qPrintable(opened.report()));
  QVERIFY(!opened.ok()->isEnabled());
  opened.dialog->openFile(write("small.csv", "time [s],thrust [N]\n0,1\n1,2\n"));
  QTRY_VERIFY2(opened.ok()->isEnabled(), qPrintable(opened.report()));
}

void TestImportDialog::scaleAndOffset() {
  const QString file = write("raw.csv", "time [s],load cell\n0,100\n1,300\n");
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

void TestImportDialog::scaleIsNoNumber_data() {
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

void TestImportDialog::scaleIsNoNumber() {
  QFETCH(QString, text);
  QFETCH(QString, sentence);
  const Opened opened(write("scale.csv", "time [s],thrust [N]\n0,1\n1,2\n"));
  opened.type("scale1", text);
  QTRY_VERIFY(!opened.ok()->isEnabled());
  QVERIFY2(opened.report().startsWith(sentence), qPrintable(opened.report()));
  QCOMPARE(opened.report().count('\n'), 0);
  opened.type("scale1", "2");
  QTRY_VERIFY(opened.ok()->isEnabled());
  QCOMPARE(opened.range(1), QString("2 … 4 N"));
}

void TestImportDialog::commentMark() {
  const Opened opened(write("marks.csv", "time [s],thrust [N]\n0,1\n//1,50\n1,2\n"));
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
void TestImportDialog::choicesOfAnEditedLayoutAreRemembered() {
  const QByteArray text = "x,y\n%a,b\n0,1\n1,2\n";
  {
    Opened first(write("edited.csv", text));
    first.type("importComment", "%");
    first.child<QSpinBox>("importHeaderLine")->setValue(2);
    first.child<QSpinBox>("importSkippedLines")->setValue(0);
    first.choose("quantity0", "Time");
    first.choose("quantity1", "Thrust");
    QTRY_VERIFY2(first.report().startsWith("2 row(s) of time, thrust"), qPrintable(first.report()));
    QTest::mouseClick(first.ok(), Qt::LeftButton);
  }
  const Opened second(write("edited2.csv", text + "2,3\n"));
  QCOMPARE(second.child<QLineEdit>("importComment")->text(), QString("%"));
  QVERIFY2(second.report().startsWith("3 row(s) of time, thrust"), qPrintable(second.report()));
}

void TestImportDialog::tabGoesThroughTheChoices() {
  const Opened opened(write("tab.csv", "time [s],thrust [N]\n0,1\n1,2\n"));
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

void TestImportDialog::timesAsText() {
  Opened opened(
      write("times.csv", "Timestamp,thrust [N]\n23:59:59.5,1\n00:00:00.75,2\n00:00:02,3\n"));
  QCOMPARE(opened.report(), QString("3 row(s) of time, thrust will be imported."));
  QCOMPARE(opened.range(0), QString("0 … 2.5 s"));
  opened.choose("unit0", "ms");
  QTRY_VERIFY2(opened.report().contains("The unit must be s."), qPrintable(opened.report()));
  opened.choose("unit0", "s");
  QTRY_VERIFY(opened.ok()->isEnabled());
}

/// "time [s],thrust [N]\n0,1\n1,2\n" as gzip 1.12 packs it with option -n.
void TestImportDialog::compressedFile() {
  const QByteArray packed = QByteArray::fromHex(
      "1f8b08000000000000032bc9cc4d55882e8ed529c9282a2d2e5188f68be532d031e432d431e202000b95b33d1c00"
      "0000");
  Opened opened(write("log.csv.gz", packed));
  QCOMPARE(opened.report(), QString("2 row(s) of time, thrust will be imported."));
  QCOMPARE(opened.child<QLineEdit>("importName")->text(), QString("log"));
}

void TestImportDialog::propellerTable() {
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

void TestImportDialog::propellerIsSaved() {
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

void TestImportDialog::propellerWithoutADiameter() {
  Opened opened(write("tunnel.csv", "J,CT,CP\n0,0.1,0.05\n0.3,0.06,0.04\n"));
  QCOMPARE(opened.child<QLineEdit>("importDiameter")->text(), QString());
  QTest::mouseClick(opened.child<QPushButton>("importSavePropeller"), Qt::LeftButton);
  QVERIFY2(opened.report().startsWith("Give the diameter of the propeller: "),
           qPrintable(opened.report()));
  opened.type("importDiameter", "25.4 cm");
  QTest::mouseClick(opened.child<QPushButton>("importSavePropeller"), Qt::LeftButton);
  QTRY_VERIFY(opened.dialog->findChild<ComponentInfoDialog*>() != nullptr);
}

QTEST_MAIN(TestImportDialog)
#include "test_import_dialog.moc"
