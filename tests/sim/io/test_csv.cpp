#include <QTest>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "sim/core/error.h"
#include "sim/io/csv.h"

using namespace rotorbench;

namespace {

std::string csv(const Recording& recording, const CsvSelection& selection = {}) {
  std::ostringstream out;
  writeCsv(out, recording, selection);
  return out.str();
}

}  // namespace

class TestCsv : public QObject {
  Q_OBJECT

 private slots:
  void writes();
  void writesPartOfARecording();
  void writtenReadsBackEqual();
  void reads_data();
  void reads();
  void columnsByName();
  void faults_data();
  void faults();
  void longLines();
};

void TestCsv::writes() {
  Recording recording({{"time", "s", {}}, {"rotor1.thrust", "N", {}}, {"odd, \"name\"", "1", {}}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QVERIFY(recording.append(std::array{0.0, 0.1, -nan}));
  QVERIFY(recording.append(std::array{0.001, 1e-9, std::numeric_limits<double>::infinity()}));
  QVERIFY(recording.append(std::array{9.0, 9.0, 9.0}));
  QCOMPARE(
      csv(recording),
      std::string("time [s],rotor1.thrust [N],\"odd, \"\"name\"\" [1]\"\n"));  // none published
  recording.publish();
  QCOMPARE(csv(recording), std::string("time [s],rotor1.thrust [N],\"odd, \"\"name\"\" [1]\"\n"
                                       "0,0.1,nan\n0.001,1e-09,inf\n9,9,9\n"));
}

void TestCsv::writesPartOfARecording() {
  Recording recording({{"time", "s", {}}, {"a", "1", {}}, {"b", "1", {}}});
  for (int i = 0; i < 10; ++i) QVERIFY(recording.append(std::array{0.5 * i, 1.0 * i, -1.0 * i}));
  recording.publish();
  QCOMPARE(csv(recording, {.from = 1.0, .to = 2.0, .channels = {0, 2}}),
           std::string("time [s],b [1]\n1,-2\n1.5,-3\n2,-4\n"));
  QCOMPARE(csv(recording, {.from = 99.0, .to = {}, .channels = {1}}), std::string("a [1]\n"));
}

void TestCsv::writtenReadsBackEqual() {
  Recording recording({{"time", "s", {}}, {"x", "rad/s", {}}});
  for (std::size_t i = 0; i < 3 * Recording::kChunkRows + 5; ++i) {
    const double t = static_cast<double>(i);
    QVERIFY(recording.append(std::array{t / 3, std::sin(t) * std::exp(t / 100 - 50)}));
  }
  recording.finish();
  const CsvTable table = readCsvTable(csv(recording), "a.csv");
  QCOMPARE(table.rows(), recording.rows());
  QCOMPARE(table.columns[1].unit, std::string("rad/s"));
  for (std::size_t i = 0; i < table.rows(); ++i) {
    QCOMPARE(table.columns[0].values[i], recording.value(0, i));
    if (table.columns[1].values[i] != recording.value(1, i)) QFAIL("a number changed");
  }
}

void TestCsv::reads_data() {
  QTest::addColumn<QByteArray>("text");
  // All say: time in s 0 and 0.5, speed in rpm 3000 and 3100.5.
  QTest::addRow("comma") << QByteArray("time [s],speed [rpm]\n0,3000\n0.5,3100.5\n");
  QTest::addRow("semicolon, decimal comma")
      << QByteArray("time [s];speed [rpm]\n0;3000\n0,5;3100,5\n");
  QTest::addRow("semicolon, decimal point") << QByteArray("time [s];speed [rpm]\n0;3e3\n.5;3100.5");
  QTest::addRow("tab") << QByteArray("time [s]\tspeed [rpm]\n0\t3000\n0,5\t3100.5\n");
  QTest::addRow("Windows") << QByteArray(
      "\xEF\xBB\xBFtime (s), speed (rpm)\r\n0, 3000\r\n+0.5 ,3100.5\r\n\r\n");
  QTest::addRow("quotes") << QByteArray(
      "\"time [s]\",\"speed [rpm]\"\n\"0\",\"3000\"\n\"0.5\", \"3100.5\"\n");
  QTest::addRow("comments") << QByteArray(
      "# speeds\n\ntime [s],speed [rpm]\n# start\n0,3000\n0.5,3100.5\n");
}

void TestCsv::reads() {
  QFETCH(QByteArray, text);
  const CsvTable table = readCsvTable(text.toStdString(), "a.csv");
  QCOMPARE(table.columns.size(), std::size_t{2});
  QCOMPARE(table.columns[0].name, std::string("time"));
  QCOMPARE(table.columns[0].unit, std::string("s"));
  QCOMPARE(table.columns[0].values, (std::vector<double>{0, 0.5}));
  QCOMPARE(table.columns[1].name, std::string("speed"));
  QCOMPARE(table.columns[1].unit, std::string("rpm"));
  QCOMPARE(table.columns[1].values, (std::vector<double>{3000, 3100.5}));
}

void TestCsv::columnsByName() {
  const CsvTable table = readCsvTable("time [ms],speed\n500,3\n", "a.csv");
  QCOMPARE(table.values("time", "s"), (std::vector<double>{0.5}));
  QCOMPARE(table.values("speed", "rad/s"), (std::vector<double>{3}));
  const auto messageOf = [&](const char* name, const char* unit) {
    try {
      (void)table.values(name, unit);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  QCOMPARE(messageOf("tiem", "s"),
           std::string("a.csv: there is no column called tiem; the nearest is time"));
  QCOMPARE(messageOf("voltage", "V"),
           std::string("a.csv: there is no column called voltage; the columns are time, speed"));
  QCOMPARE(messageOf("time", "V"),
           std::string("a.csv: column time: the unit ms is not allowed; must convert to V"));
}

void TestCsv::faults_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("message");
  QTest::addRow("empty") << QByteArray("\n \n")
                         << "the file is empty; must begin with a line of column names";
  QTest::addRow("no rows") << QByteArray("time\n") << "the table has no rows of numbers";
  QTest::addRow("no names")
      << QByteArray("0,1\n2,3\n")
      << "line 1: the first line holds the number 0; must hold the names of the columns, "
         "like \"time [s]\"";
  QTest::addRow("text") << QByteArray("t,x\n0,1\n1,fast\n")
                        << "line 3, column x: \"fast\" is not a number; must be a finite number";
  QTest::addRow("nan") << QByteArray("t,x\n0,nan\n")
                       << "line 2, column x: \"nan\" is not a number; must be a finite "
                          "number";
  QTest::addRow("too large")
      << QByteArray("t,x\n0,1e999\n")
      << "line 2, column x: \"1e999\" is not a number; must be a finite number";
  QTest::addRow("empty cell") << QByteArray("t,x\n0,\n")
                              << "line 2, column x: the cell is empty; must be a finite number";
  QTest::addRow("ragged")
      << QByteArray("t,x\n0,1\n2\n3,4,5\n")
      << "line 3: there are 1 cells; must be 2\na.csv: line 4: there are 3 cells; must be 2";
  QTest::addRow("thousands")
      << QByteArray("t;x\n0;1.000,5\n")
      << "line 2, column x: \"1.000,5\" is not a number; must be a finite number";
  QTest::addRow("same names") << QByteArray("t,t\n0,1\n")
                              << "line 1: there are two columns called t; names must differ";
  QTest::addRow("nameless") << QByteArray("t,\n0,1\n")
                            << "line 1: column 2 has no name; the first line must name each column";
  QTest::addRow("open quote") << QByteArray("t,x\n\"0,1\n")
                              << "line 2: a quotation mark is not closed in its line";
  QTest::addRow("binary") << QByteArray("t,x\n\0\0", 6) << "line 2: this is not text";
  QTest::addRow("not UTF-8") << QByteArray("t,\xFF\n0,1\n") << "line 1: this is not text in UTF-8";
}

void TestCsv::faults() {
  QFETCH(QByteArray, text);
  QFETCH(QString, message);
  try {
    (void)readCsvTable(text.toStdString(), "a.csv");
    QFAIL("the table was accepted");
  } catch (const InputError& error) {
    QCOMPARE(QString::fromUtf8(error.what()), "a.csv: " + message);
  }
}

void TestCsv::longLines() {
  const auto messageOf = [](const std::string& text) {
    try {
      (void)readCsvTable(text, "a.csv");
    } catch (const InputError& error) {
      return error.problems().front().message();
    }
    return std::string();
  };
  QCOMPARE(messageOf("t,x\n0," + std::string(2'000'000, '1')),
           std::string("line 2: the line is too long; must be at most 1 MiB"));
  QCOMPARE(messageOf(std::string(100'000'000, '1')),
           std::string("the file is too large; must be at most 64 MiB"));
  QCOMPARE(messageOf(std::string(1500, ',')),
           std::string("line 1: there are 1501 columns; must be at most 1000"));
}

QTEST_GUILESS_MAIN(TestCsv)
#include "test_csv.moc"
