// Times written as text in a log: what is understood, what is refused, and what an import makes of
// a column of them.
#include <QTest>
#include <cmath>

#include "sim/logs/csv_import.h"
#include "sim/logs/time_text.h"

using namespace rotorbench;

class TestTimeText : public QObject {
  Q_OBJECT
 private slots:
  void reads_data();
  void reads();
  void refuses_data();
  void refuses();
  void countsFromTheFirst_data();
  void countsFromTheFirst();
  void importsAColumn_data();
  void importsAColumn();
  void saysWhatIsNoTime_data();
  void saysWhatIsNoTime();
  void unitIsSeconds();
  void numbersAreTheBetterTime();
};

/// Days since 1970-01-01 by hand: 2024-03-01 is 54 years of 365 days, 13 leap days of 1972 to 2020,
/// and 60 days into the leap year 2024.
void TestTimeText::reads_data() {
  constexpr int kDay = 54 * 365 + 13 + 60;
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("day");
  QTest::addColumn<double>("seconds");
  QTest::addRow("ISO 8601") << "2024-03-01T12:00:00.250" << kDay << 43200.25;
  QTest::addRow("blank") << "2024-03-01 12:00:00.250" << kDay << 43200.25;
  QTest::addRow("decimal comma") << "2024-03-01 12:00:00,250" << kDay << 43200.25;
  QTest::addRow("colon before the milliseconds") << "2024-03-01 12:00:00:250" << kDay << 43200.25;
  QTest::addRow("without seconds") << "2024-03-01T12:30" << kDay << 45000.0;
  QTest::addRow("Z") << "2024-03-01T12:00:00Z" << kDay << 43200.0;
  QTest::addRow("ahead of UTC") << "2024-03-01T12:00:00+01:00" << kDay << 39600.0;
  QTest::addRow("behind UTC") << "2024-03-01T12:00:00-0530" << kDay << 63000.0;
  QTest::addRow("hours only") << "2024-03-01T12:00:00+01" << kDay << 39600.0;
  QTest::addRow("leap day") << "2024-02-29T00:00:00" << kDay - 1 << 0.0;
  QTest::addRow("first day") << "1970-01-01T00:00:00Z" << 0 << 0.0;
  QTest::addRow("time of day") << " 12:00:00.25 " << 0 << 43200.25;
  QTest::addRow("one digit") << "7:05:09" << 0 << 25509.0;
  QTest::addRow("leap second") << "23:59:60" << 0 << 86400.0;
}

void TestTimeText::reads() {
  QFETCH(QString, text);
  QFETCH(int, day);
  QFETCH(double, seconds);
  const auto time = readTimeText(text.toStdString());
  QVERIFY(time.has_value());
  QCOMPARE(time->day, day);
  QCOMPARE(time->seconds, seconds);
}

void TestTimeText::refuses_data() {
  QTest::addColumn<QString>("text");
  for (const char* text : {"",
                           "12",
                           "12:00",
                           "24:00:00",
                           "12:60:00",
                           "12:00:61",
                           "12:00:00.",
                           "12:00:00x",
                           "2024-03-01",
                           "2024-13-01T00:00:00",
                           "2023-02-29T00:00:00",
                           "2024-3-1T00:00:00",
                           "01.03.2024 12:00:00",
                           "03/01/2024 12:00",
                           "2024-03-01T12:00:00+25:00",
                           "2024-03-01T12:00:00 UTC",
                           "2024-03-01T12:00:00+01:0",
                           "-12:00:00",
                           "2024-03-01T",
                           "12:00:00Z"}) {
    QTest::addRow("%s", text) << text;
  }
}

void TestTimeText::refuses() {
  QFETCH(QString, text);
  QVERIFY(!readTimeText(text.toStdString()).has_value());
}

void TestTimeText::countsFromTheFirst_data() {
  QTest::addColumn<QStringList>("texts");
  QTest::addColumn<QList<double>>("seconds");
  QTest::addRow("dates") << QStringList{"2024-02-29T23:59:59.5", "2024-03-01T00:00:00.75"}
                         << QList<double>{0, 1.25};
  QTest::addRow("zones") << QStringList{"2024-03-01T12:00:00+01:00", "2024-03-01T11:00:01Z"}
                         << QList<double>{0, 1};
  QTest::addRow("midnight") << QStringList{"23:59:58", "23:59:59.5", "00:00:01", "00:00:03"}
                            << QList<double>{0, 1.5, 3, 5};
  QTest::addRow("late row of before midnight")
      << QStringList{"23:59:58", "00:00:01", "23:59:59", "00:00:02"} << QList<double>{0, 3, 1, 4};
  QTest::addRow("two midnights") << QStringList{"20:00:00", "04:00:00", "12:00:00", "20:00:00",
                                                "04:00:00"}
                                 << QList<double>{0, 28800, 57600, 86400, 115200};
  QTest::addRow("a little back") << QStringList{"12:00:01", "12:00:00"} << QList<double>{0, -1};
  QTest::addRow("a long pause") << QStringList{"06:00:00", "19:00:00"} << QList<double>{0, 46800};
}

void TestTimeText::countsFromTheFirst() {
  QFETCH(QStringList, texts);
  QFETCH(QList<double>, seconds);
  TimeLine line;
  for (qsizetype i = 0; i < texts.size(); ++i) {
    const auto at = line.read(texts[i].toStdString());
    QVERIFY(at.has_value());
    QCOMPARE(*at, seconds[i]);
  }
  QVERIFY(!line.read("no time"));
}

void TestTimeText::importsAColumn_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addRow("comma") << QByteArray(
      "Timestamp,thrust [N]\n2024-03-01T12:00:00.250,1\n2024-03-01T12:00:01.500,2\n");
  QTest::addRow("decimal comma") << QByteArray(
      "Zeit;thrust [N]\n12:00:00,250;1,5\n12:00:01,500;2,5\n");
  QTest::addRow("date and time of day apart")
      << QByteArray("Date,Time,thrust [N]\n2024-03-01,23:59:59.5,1\n2024-03-02,00:00:00.75,2\n");
  QTest::addRow("unit that is none")
      << QByteArray("time (hh:mm:ss)\tthrust [N]\n12:00:00\t1\n12:00:01.25\t2\n");
  QTest::addRow("no names") << QByteArray("12:00:00|1|3\n12:00:01.25|2|4\n");
}

void TestTimeText::importsAColumn() {
  QFETCH(QByteArray, text);
  const TextLines lines = TextLines::fromBytes(text.toStdString(), "a.csv");
  const ImportSettings settings = guessSettings(lines);
  QCOMPARE(settings.group, ChannelGroup::Run);
  const ImportResult result = importTable(lines, settings);
  for (const Problem& problem : result.problems) qInfo("%s", problem.message().c_str());
  QVERIFY(result.usable());
  QVERIFY(result.problems.empty());
  QCOMPARE(result.table.channels.front().name, std::string("time"));
  QCOMPARE(result.table.columns.front(), (std::vector<double>{0, 1.25}));
}

void TestTimeText::saysWhatIsNoTime_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("sentence");
  QTest::addColumn<bool>("usable");
  const QString hint = "taken as empty; times are read as 2024-03-01T12:00:00.25 or 12:00:00.25";
  QTest::addRow("another order")
      << QByteArray("time,thrust [N]\n03/01/2024 12:00:00,1\n03/01/2024 12:00:01,2\n")
      << "column \"time\": 2 cells are not a number (first in line 2: \"03/01/2024 12:00:00\"); " +
             hint
      << false;
  QTest::addRow("of another kind")
      << QByteArray("time,thrust [N]\n12:00:00,1\n2024-03-01T12:00:01,2\n12:00:02,3\n")
      << "column \"time\": 1 cell is not a time like the first one (first in line 3: "
         "\"2024-03-01T12:00:01\"); " +
             hint
      << true;
  QTest::addRow("a number among times")
      << QByteArray("time,thrust [N]\n12:00:00,1\n7,2\n12:00:02,3\n")
      << "column \"time\": 1 cell is not a time like the first one (first in line 3: \"7\"); taken "
         "as empty"
      << true;
  QTest::addRow("no such minute") << QByteArray(
                                         "time,thrust [N]\n12:00:00,1\n12:61:00,2\n12:00:02,3\n")
                                  << "column \"time\": 1 cell is not a time like the first one "
                                     "(first in line 3: \"12:61:00\"); " +
                                         hint
                                  << true;
}

void TestTimeText::saysWhatIsNoTime() {
  QFETCH(QByteArray, text);
  QFETCH(QString, sentence);
  QFETCH(bool, usable);
  const TextLines lines = TextLines::fromBytes(text.toStdString(), "a.csv");
  const ImportResult result = importTable(lines, guessSettings(lines));
  QStringList said;
  for (const Problem& problem : result.problems) said << QString::fromStdString(problem.message());
  QVERIFY2(said.contains(sentence), qPrintable(said.join('\n')));
  QCOMPARE(result.usable(), usable);
}

void TestTimeText::unitIsSeconds() {
  const TextLines lines =
      TextLines::fromBytes("time,thrust [N]\n12:00:00,1\n12:00:02,3\n", "a.csv");
  ImportSettings settings = guessSettings(lines);
  settings.columns[0].offset = 10;
  QCOMPARE(importTable(lines, settings).table.columns[0], (std::vector<double>{10, 12}));
  settings.columns[0].unit = std::string("ms");
  const ImportResult result = importTable(lines, settings);
  QVERIFY(!result.usable());
  QCOMPARE(result.problems[0].message(),
           std::string("column \"time\": dates and times of day are counted in seconds; the unit "
                       "must be s"));
}

void TestTimeText::numbersAreTheBetterTime() {
  const TextLines lines =
      TextLines::fromBytes("Timestamp,time [s],thrust [N]\n12:00:00,5,1\n12:00:02,7,3\n", "a.csv");
  const ImportSettings settings = guessSettings(lines);
  QCOMPARE(settings.columns[0].quantity, std::string());
  QCOMPARE(settings.columns[1].quantity, std::string("time"));
}

QTEST_APPLESS_MAIN(TestTimeText)
#include "test_time_text.moc"
