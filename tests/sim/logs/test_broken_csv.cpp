// Logs that are broken: each class of fault has a sentence with its first line, the rest is kept,
// nothing crashes.
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <random>

#include "sim/logs/csv_import.h"

using namespace rotorbench;

class TestBrokenCsv : public QObject {
  Q_OBJECT
 private slots:
  void refused_data();
  void refused();
  void survives_data();
  void survives();
  void aVeryLongLine();
  void aFileOfAGigabyte();
  void missingFile();
  void randomBytes();
};

void TestBrokenCsv::refused_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("message");
  QTest::addRow("empty") << QByteArray() << "a.csv: the file is empty; must be a table of text";
  QTest::addRow("blank") << QByteArray(" \n\t\r\n")
                         << "a.csv: the file is empty; must be a table of text";
  QTest::addRow("zero bytes") << QByteArray("t,x\n0,\0\n", 8)
                              << "a.csv: this is not text: it holds zero bytes; must be a table of "
                                 "text";
  QTest::addRow("compressed")
      << QByteArray("BZh91AY&SY")
      << "a.csv: this file is compressed; must be unpacked first (a spreadsheet: saved as CSV)";
  QTest::addRow("spreadsheet")
      << QByteArray("PK\x03\x04rest")
      << "a.csv: this file is compressed; must be unpacked first (a spreadsheet: saved as CSV)";
}

void TestBrokenCsv::refused() {
  QFETCH(QByteArray, text);
  QFETCH(QString, message);
  try {
    (void)TextLines::fromBytes(text.toStdString(), "a.csv");
    QFAIL("must be refused");
  } catch (const InputError& error) {
    QCOMPARE(QString(error.what()), message);
  }
}

void TestBrokenCsv::survives_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<int>("rows");
  QTest::addColumn<QString>("sentence");
  const QByteArray head = "time [s],thrust [N],note\n";
  QTest::addRow("too short") << head + "0,1,a\n1\n2,3,b\n"
                             << 3
                             << "1 row has fewer cells than there are columns (first in line 3); "
                                "the missing cells are taken as empty";
  QTest::addRow("too wide") << head + "0,1,a\n1,2,3,4,5\n"
                            << 2
                            << "1 row has more cells than there are columns (first in line 3); "
                               "the surplus is left out";
  QTest::addRow("text in numbers")
      << head + "0,1,a\n1,overload,b\n2,n/a,c\n"
      << 3
      << "column \"thrust\": 2 cells are not a number (first in line 3: \"overload\"); taken as "
         "empty";
  QTest::addRow("nan and inf") << head + "0,nan,a\n1,inf,b\n2,3,c\n"
                               << 3
                               << "column \"thrust\": 2 cells are not a number (first in line 2: "
                                  "\"nan\"); taken as empty";
  QTest::addRow("decimal comma among points")
      << QByteArray("time [s];thrust [N]\n0.5;1.5\n1.5;2.5\n2.5;\"3,5\"\n") << 3
      << "column \"thrust\": 1 cell is not a number (first in line 4: \"3,5\"); taken as empty; "
         "is the decimal mark a comma?";
  QTest::addRow("no time") << head + "0,1,a\n,2,b\n2,3,c\n"
                           << 2
                           << "1 row has no value for the horizontal axis (first in line 3); left "
                              "out";
  QTest::addRow("a line of words")
      << head + "0,1,a\nstopped\n2,3,c\n"
      << 2
      << "1 row has no number in the chosen columns (first in line 3); "
         "left out";
  QTest::addRow("open quote") << head + "0,1,a\n1,2,\"b\n2,3,c\n"
                              << 2
                              << "1 line has a quotation mark that is not closed (first in line "
                                 "3); left out";
  QTest::addRow("time back")
      << head + "1,1,a\n0,2,b\n"
      << 2
      << "1 row goes back on the horizontal axis (first in line 3); rows are "
         "sorted by it";
  QTest::addRow("same names") << QByteArray("time [s],thrust [N],thrust [N]\n0,1,2\n1,2,3\n") << 2
                              << "";
  QTest::addRow("no names") << QByteArray("0,1\n1,2\n2,3\n") << -1
                            << "no column is chosen; choose "
                               "what at least one column is";
  QTest::addRow("only names") << QByteArray("time [s],thrust [N]\n") << -1
                              << "there are no rows below the names; check the line of names and "
                                 "the lines to skip";
  QTest::addRow("prose") << QByteArray("Once upon a time\nthere was a motor.\n") << -1
                         << "no column is chosen; choose what at least one column is";
  QTest::addRow("thousand columns") << QByteArray(3000, ',') + "1\n"
                                    << -1
                                    << "no column is chosen; "
                                       "choose what at least "
                                       "one column is";
}

void TestBrokenCsv::survives() {
  QFETCH(QByteArray, text);
  QFETCH(int, rows);
  QFETCH(QString, sentence);
  const TextLines lines = TextLines::fromBytes(text.toStdString(), "a.csv");
  const ImportResult result = importTable(lines, guessSettings(lines));
  QStringList said;
  for (const Problem& problem : result.problems) {
    said << QString::fromStdString(problem.message());
  }
  if (sentence.isEmpty()) {
    QCOMPARE(said, QStringList());
  } else {
    QVERIFY2(said.contains(sentence), qPrintable(said.join('\n')));
  }
  QCOMPARE(result.usable(), rows >= 0);
  if (rows >= 0) QCOMPARE(result.table.rows(), static_cast<std::size_t>(rows));
}

void TestBrokenCsv::aVeryLongLine() {
  std::string text = "time [s],thrust [N]\n0,1\n";
  text.append(std::size_t{3} << 20, '7');
  text += "\n1,2\n";
  const TextLines lines = TextLines::fromBytes(text, "a.csv");
  const ImportResult result = importTable(lines, guessSettings(lines));
  QVERIFY(result.usable());
  QCOMPARE(result.table.rows(), std::size_t{2});
  QCOMPARE(result.problems.at(0).message(),
           std::string("1 line is longer than 1 MiB (first in line 3); left out"));
}

/// One line of a gigabyte, as a file with holes: refused by its size, without being read into
/// memory.
void TestBrokenCsv::aFileOfAGigabyte() {
  const QTemporaryDir folder;
  const std::string path = folder.filePath("huge.csv").toStdString();
  std::ofstream(path) << "time [s],thrust [N]\n0,1\n";
  std::filesystem::resize_file(path, std::uintmax_t{1} << 30);
  try {
    (void)TextLines::fromFile(path);
    QFAIL("must be refused");
  } catch (const InputError& error) {
    QVERIFY2(QString(error.what()).contains("64 MiB"), error.what());
  }
}

void TestBrokenCsv::missingFile() {
  QVERIFY_THROWS_EXCEPTION(InputError, TextLines::fromFile("/no/such/file.csv"));
  QVERIFY_THROWS_EXCEPTION(InputError, TextLines::fromFile(QDir::tempPath().toStdString()));
}

/// Bytes of all kinds, mostly those tables are made of, in all layouts: no crash, and rows of equal
/// length.
void TestBrokenCsv::randomBytes() {
  std::mt19937 random(20261122);
  const std::string alphabet = "0123456789,;\t|. -+eE\"#\n\r\xC2\xB5\xFFtime[s]()";
  for (int round = 0; round < 3000; ++round) {
    std::string text = round % 2 == 0   ? "time [s],thrust [N],x\n"
                       : round % 3 == 0 ? "time\n12:00:00 2024-03-01T12:00:00\n"
                                        : "";
    const auto length = static_cast<std::size_t>(random() % 400);
    for (std::size_t i = 0; i < length; ++i) text += alphabet[random() % alphabet.size()];
    text += "1";
    const TextLines lines = TextLines::fromBytes(text, "a.csv");
    ImportSettings settings = guessSettings(lines);
    (void)importTable(lines, settings);
    settings.layout.separator = static_cast<Separator>(random() % 5);
    settings.layout.decimalMark = static_cast<DecimalMark>(random() % 2);
    settings.layout.headerLine = static_cast<int>(random() % 8);
    settings.layout.skippedLines = static_cast<int>(random() % 4);
    settings.columns = guessMapping(previewOf(lines, settings.layout));
    const ImportResult result = importTable(lines, settings);
    for (const auto& column : result.table.columns) {
      QCOMPARE(column.size(), result.table.rows());
    }
  }
}

QTEST_APPLESS_MAIN(TestBrokenCsv)
#include "test_broken_csv.moc"
