// What the import makes of logs as real programs write them: layout and mapping guessed, values in
// SI.
#include <QTest>
#include <cmath>
#include <numbers>

#include "sim/io/json_document.h"
#include "sim/logs/csv_import.h"

using namespace rotorbench;

namespace {

constexpr double kRpm = std::numbers::pi / 30;
constexpr double kGravity = 9.80665;

TextLines file(const char* name) {
  return TextLines::fromFile(std::string(TEST_DATA_DIR "/measurement/") + name);
}

/// "time=Time [s] thrust=Thrust [gf]": what each quantity is taken from.
QString said(const ImportSettings& settings) {
  QStringList parts;
  for (const ColumnMapping& column : settings.columns) {
    if (column.quantity.empty()) continue;
    parts << QString::fromStdString(column.quantity + "=" + column.column + " [" + column.unit +
                                    "]");
  }
  return parts.join(' ');
}

double valueAt(const MeasuredTable& table, const char* quantity, std::size_t row) {
  const std::vector<double>* column = table.find(quantity);
  return column == nullptr ? -1 : column->at(row);
}

}  // namespace

class TestCsvImport : public QObject {
  Q_OBJECT
 private slots:
  void guessesRealLogs_data();
  void guessesRealLogs();
  void guessesLayouts_data();
  void guessesLayouts();
  void valuesAreSi();
  void emptyCellsAreNothing();
  void overThrottle();
  void unitsOfAThrottleAndAThrust_data();
  void unitsOfAThrottleAndAThrust();
  void scaleAndOtherName();
  void unsortedRowsAreSorted();
  void settingsAreRemembered();
  void checksSettings_data();
  void checksSettings();
};

void TestCsvImport::guessesRealLogs_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("mapping");
  QTest::addColumn<int>("rows");
  QTest::addRow("RCbenchmark 1520")
      << "strawson_a1_11.csv"
      << "time=Time [s] throttle=ESC signal [us] thrust=Thrust [gf] supply.voltage=Voltage [V] "
         "supply.current=Current [A] motor.speed=Motor Electrical Speed [rpm] "
         "power.electrical=Electrical Power [W] thrust_per_power=Overall Efficiency [gf/W]"
      << 11;
  QTest::addRow("AutoQuad")
      << "autoquad_log.csv"
      << "time=Timestamp [s] supply.current=Amps [A] supply.voltage=Batt. Volts [V] "
         "motor.voltage=Motor Volts [V] motor.speed=RPM [rpm] "
         "throttle=Duty [%]"
      << 59;
  QTest::addRow("Crazyflie") << "crazyflie_stock_prop.csv"
                             << "thrust=weight [g] throttle=pwm [1] supply.voltage=vbat [V] "
                                "motor.speed=rpm1 [rpm] supply.current=i [A] power.electrical=p [W]"
                             << 65;
  QTest::addRow("steady steps") << "autoquad_steady_steps.csv"
                                << "throttle=duty [1] motor.speed=rpm_median [rpm] "
                                   "supply.current=battery_current_A [A] "
                                   "supply.voltage=battery_voltage_V [V]"
                                << 38;
}

void TestCsvImport::guessesRealLogs() {
  QFETCH(QString, name);
  QFETCH(QString, mapping);
  QFETCH(int, rows);
  const TextLines lines = file(qPrintable(name));
  const ImportSettings settings = guessSettings(lines);
  QCOMPARE(said(settings), mapping);
  const ImportResult result = importTable(lines, settings);
  for (const Problem& problem : result.problems) qInfo("%s", problem.message().c_str());
  QVERIFY(result.usable());
  QCOMPARE(result.table.rows(), static_cast<std::size_t>(rows));
}

void TestCsvImport::guessesLayouts_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("mapping");
  QTest::addColumn<double>("last");  // of the first chosen column, last row, SI
  QTest::addRow("comma") << QByteArray("time [s],thrust [N]\n0,1\n0.5,2\n")
                         << "time=time [s] thrust=thrust [N]" << 0.5;
  QTest::addRow("semicolon, decimal comma") << QByteArray("Time (s);Thrust (gf)\n0;1,5\n0,5;2,5\n")
                                            << "time=Time [s] thrust=Thrust [gf]" << 0.5;
  QTest::addRow("tab") << QByteArray("time [ms]\tthrust [N]\n0\t1\n500\t2\n")
                       << "time=time [ms] thrust=thrust [N]" << 0.5;
  QTest::addRow("bar") << QByteArray("time [s]|thrust [N]\n0|1\n0.5|2\n")
                       << "time=time [s] thrust=thrust [N]" << 0.5;
  QTest::addRow("quoted decimal comma")
      << QByteArray("\"time [s]\",\"thrust [N]\"\n\"0,0\",\"1,5\"\n\"0,5\",\"2,5\"\n")
      << "time=time [s] thrust=thrust [N]" << 0.5;
  // UIUC Propeller Database, apce_10x5_kt0824_6018.txt, first rows.
  QTest::addRow("UIUC, spaces") << QByteArray(
                                       "J       CT       CP       eta\r\n"
                                       "0.406   0.0472   0.0304   0.631\r\n"
                                       "0.429   0.0431   0.0288   0.642\r\n")
                                << "advance_ratio=J [1] ct=CT [1] cp=CP [1] efficiency=eta [1]"
                                << 0.429;
  // APC performance file PER3_10x45MR.dat, head of its first block.
  QTest::addRow("APC, names, units, spaces")
      << QByteArray(
             "         10x4.5MR                 (10x45MR.dat)                12/19/14 \n   \n"
             "         PROP RPM =        1000\n\n"
             "         V          J           Pe         Ct          Cp          PWR     Thrust\n"
             "       (mph)     (Adv Ratio)                                       (Hp)    (Lbf)\n"
             "         0.0        0.00      0.0000      0.1102      0.0428       0.003   0.140\n"
             "         0.5        0.02      0.0621      0.1086      0.0432       0.003   0.138\n")
      << "motor.speed=PROP RPM [rpm] air_speed=V [mph] advance_ratio=J [1] efficiency=Pe [1] ct=Ct "
         "[1] cp=Cp [1] power.shaft=PWR [hp] thrust=Thrust [lbf]"
      << 0.02;
  QTest::addRow("preamble")
      << QByteArray("Log of stand 7\nOperator: K\n\ntime [s],thrust [N]\n0,1\n0.5,2\n")
      << "time=time [s] thrust=thrust [N]" << 0.5;
  QTest::addRow("names behind a comment mark")
      << QByteArray("# t thrust_N\n0 1\n0.5 2\n") << "" << 0.5;
  QTest::addRow("Latin-1") << QByteArray("Time (s),ESC signal (\xB5s)\n0,1000\n0.5,1500\n")
                           << "time=Time [s] throttle=ESC signal [us]" << 0.5;
  QTest::addRow("UTF-8 mark") << QByteArray("\xEF\xBB\xBFTime (s),Thrust (N)\r\n0,1\r\n0.5,2\r\n")
                              << "time=Time [s] thrust=Thrust [N]" << 0.5;
  QTest::addRow("old Macintosh") << QByteArray("Time (s),Thrust (N)\r0,1\r0.5,2\r")
                                 << "time=Time [s] thrust=Thrust [N]" << 0.5;
  const QString utf16 = "Time (s);Schub;Drehmoment \u00B5\n0;1;2\n0,5;2;2\n";
  QByteArray bytes("\xFF\xFE");
  bytes.append(reinterpret_cast<const char*>(utf16.utf16()), 2 * utf16.size());
  QTest::addRow("UTF-16") << bytes << "time=Time [s]" << 0.5;
}

void TestCsvImport::guessesLayouts() {
  QFETCH(QByteArray, text);
  QFETCH(QString, mapping);
  QFETCH(double, last);
  const TextLines lines = TextLines::fromBytes(text.toStdString(), "a.csv");
  const ImportSettings settings = guessSettings(lines);
  if (mapping.isEmpty()) {
    QCOMPARE(previewOf(lines, settings.layout).rows, std::size_t{2});
    return;
  }
  QCOMPARE(said(settings), mapping);
  const ImportResult result = importTable(lines, settings);
  for (const Problem& problem : result.problems) qInfo("%s", problem.message().c_str());
  QVERIFY(result.usable());
  QCOMPARE(result.table.columns.front().back(), last);
}

void TestCsvImport::valuesAreSi() {
  const TextLines lines = file("strawson_a1_11.csv");
  const MeasuredTable table = importTable(lines, guessSettings(lines)).table;
  // Second row of the file: 2.226 s, 1145 us, 37.1294592 gf, 11.0765386 V, 0.9908063 A, 5721 rpm,
  // 10.8567739 W.
  QCOMPARE(valueAt(table, "time", 1), 2.2259551369999935);
  QVERIFY(std::abs(valueAt(table, "throttle", 1) - 0.145) < 1e-12);
  QVERIFY(std::abs(valueAt(table, "thrust", 1) - 0.03712945921918086 * kGravity) < 1e-12);
  QCOMPARE(valueAt(table, "supply.current", 1), 0.9908062888267413);
  QVERIFY(std::abs(valueAt(table, "motor.speed", 1) - 5721 * kRpm) < 1e-9);
  const auto recording = recordingOf(table);
  QCOMPARE(recording->rows(), std::size_t{11});
  QCOMPARE(recording->channels().front().name, std::string("time"));
  QVERIFY(recording->finished());
  QCOMPARE(tableOf(*recording, table.source).columns, table.columns);
}

void TestCsvImport::emptyCellsAreNothing() {
  const TextLines lines = file("x2216_10x4.7.csv");
  const ImportResult result = importTable(lines, guessSettings(lines));
  QVERIFY(result.usable());
  QCOMPARE(result.problems.size(), std::size_t{0});
  const std::vector<double>& thrust = *result.table.find("thrust");
  QVERIFY(std::isnan(thrust[0]));  // the log has thrust at a lower rate
  const auto numbers = std::count_if(thrust.begin(), thrust.end(), [](double t) { return t == t; });
  QVERIFY(numbers > 20 && numbers < 100);
}

void TestCsvImport::overThrottle() {
  const TextLines lines = TextLines::fromBytes(
      "throttle,rpm,thrust [kg],volts\n80,6000,0.5,11\n20,2000,0.1,12\n", "a.csv");
  ImportSettings settings = guessSettings(lines);
  QCOMPARE(settings.group, ChannelGroup::OverThrottle);
  const ImportResult result = importTable(lines, settings);
  QVERIFY(result.usable());
  QCOMPARE(result.table.channels[0].name, std::string("over_throttle.throttle"));
  QCOMPARE(result.table.channels[1].name, std::string("over_throttle.speed"));
  QCOMPARE(result.table.columns[0], (std::vector<double>{0.2, 0.8}));
  QVERIFY(std::abs(valueAt(result.table, "thrust", 1) - 0.5 * kGravity) < 1e-12);
  settings.group = ChannelGroup::Run;  // no time: rows are numbered
  const MeasuredTable rows = importTable(lines, settings).table;
  QCOMPARE(rows.channels[0].name, std::string("row"));
  QCOMPARE(rows.columns[0], (std::vector<double>{1, 2}));
}

void TestCsvImport::unitsOfAThrottleAndAThrust_data() {
  QTest::addColumn<QString>("quantity");
  QTest::addColumn<QString>("unit");
  QTest::addColumn<double>("written");
  QTest::addColumn<double>("si");
  QTest::addRow("pulse") << "throttle"
                         << "us" << 1250.0 << 0.25;
  QTest::addRow("percent") << "throttle"
                           << "%" << 25.0 << 0.25;
  QTest::addRow("share") << "throttle"
                         << "1" << 0.25 << 0.25;
  QTest::addRow("grams") << "thrust"
                         << "g" << 1000.0 << kGravity;
  QTest::addRow("gram-force") << "thrust"
                              << "gf" << 1000.0 << kGravity;
  QTest::addRow("kilograms-force") << "thrust"
                                   << "kgf" << 1.0 << kGravity;
  QTest::addRow("ounces") << "thrust"
                          << "oz" << 16.0 << 0.45359237 * kGravity;
  QTest::addRow("inch-pounds") << "motor.torque"
                               << "In-Lbf" << 1.0 << 0.45359237 * kGravity * 0.0254;
  QTest::addRow("speed") << "motor.speed"
                         << "rpm" << 60.0 << 2 * std::numbers::pi;
  QTest::addRow("charge") << "supply.charge_drawn"
                          << "mAh" << 1000.0 << 3600.0;
  QTest::addRow("miles per hour") << "air_speed"
                                  << "mph" << 1.0 << 0.44704;
  QTest::addRow("horsepower") << "power.shaft"
                              << "Hp" << 1.0 << 745.69987158227022;
}

void TestCsvImport::unitsOfAThrottleAndAThrust() {
  QFETCH(QString, quantity);
  QFETCH(QString, unit);
  QFETCH(double, written);
  QFETCH(double, si);
  const auto conversion = conversionOf(*findQuantity(quantity.toStdString()), unit.toStdString());
  QVERIFY(conversion.has_value());
  QVERIFY(std::abs(conversion->toSi(written) - si) <= 1e-14 * std::abs(si));
  QVERIFY(!conversionOf(*findQuantity("torque" == quantity ? "thrust" : "supply.voltage"),
                        unit.toStdString()));
}

void TestCsvImport::scaleAndOtherName() {
  const TextLines lines = TextLines::fromBytes("t,pwm,temp\n0,0,20\n1,65535,30\n", "a.csv");
  ImportSettings settings = guessSettings(lines);
  const MeasuredTable table = importTable(lines, settings).table;
  QVERIFY(std::abs(valueAt(table, "throttle", 1) - 1) < 1e-15);
  QCOMPARE(table.channels[2].name, std::string("temperature"));
  QCOMPARE(table.columns[2], (std::vector<double>{20, 30}));
  settings.columns[2].channel = "winding.temperature";
  settings.columns[2].offset = 273.15;
  settings.columns[2].unit = std::string("K");
  const MeasuredTable kelvin = importTable(lines, settings).table;
  QCOMPARE(kelvin.channels[2].name, std::string("winding.temperature"));
  QCOMPARE(kelvin.channels[2].unit, std::string("K"));
  QCOMPARE(kelvin.columns[2], (std::vector<double>{293.15, 303.15}));
}

void TestCsvImport::unsortedRowsAreSorted() {
  const TextLines lines =
      TextLines::fromBytes("time [s],thrust [N]\n0,1\n2,3\n1,2\n3,4\n", "a.csv");
  const ImportResult result = importTable(lines, guessSettings(lines));
  QCOMPARE(result.table.columns[1], (std::vector<double>{1, 2, 3, 4}));
  QCOMPARE(result.problems.size(), std::size_t{1});
  QCOMPARE(result.problems[0].message(),
           std::string("1 row goes back on the horizontal axis (first in line 4); rows are sorted "
                       "by it"));
}

void TestCsvImport::settingsAreRemembered() {
  const TextLines lines = file("strawson_a1_11.csv");
  ImportSettings settings = guessSettings(lines);
  settings.columns[5].scale = 0.5;
  settings.group = ChannelGroup::OverThrottle;
  ImportSettings read;
  readDocument(schema::ref(read), writeDocument(schema::ref(std::as_const(settings))), "settings");
  QVERIFY(read == settings);
  const TextLines other = TextLines::fromBytes("Time (s),Thrust (gf)\n0,1\n", "b.csv");
  QVERIFY(columnsKey(previewOf(lines, settings.layout)) !=
          columnsKey(previewOf(other, settings.layout)));
}

void TestCsvImport::checksSettings_data() {
  QTest::addColumn<QString>("quantity");
  QTest::addColumn<QString>("unit");
  QTest::addColumn<QString>("column");
  QTest::addColumn<QString>("message");
  QTest::addRow("fits") << "thrust"
                        << "N"
                        << "b"
                        << "";
  QTest::addRow("unit") << "thrust"
                        << "V"
                        << "b"
                        << "column \"b\": the unit V does not fit Thrust; must convert to N";
  QTest::addRow("unknown unit")
      << "thrust"
      << "furlong"
      << "b"
      << "column \"b\": the unit furlong does not fit Thrust; must convert to N";
  QTest::addRow("twice")
      << "time"
      << "s"
      << "b"
      << "column \"b\": time is chosen twice; each quantity belongs to one column";
  QTest::addRow("no column") << "thrust"
                             << "N"
                             << "c"
                             << "column \"c\": the table has no such column";
}

void TestCsvImport::checksSettings() {
  QFETCH(QString, quantity);
  QFETCH(QString, unit);
  QFETCH(QString, column);
  QFETCH(QString, message);
  const TextLines lines = TextLines::fromBytes("a,b\n1,2\n", "a.csv");
  ImportSettings settings;
  settings.columns.resize(2);
  settings.columns[0].column = std::string("a");
  settings.columns[0].quantity = std::string("time");
  settings.columns[0].unit = std::string("s");
  settings.columns[1].column = column.toStdString();
  settings.columns[1].quantity = quantity.toStdString();
  settings.columns[1].unit = unit.toStdString();
  const ImportResult result = importTable(lines, settings);
  QCOMPARE(result.usable(), message.isEmpty());
  QCOMPARE(result.problems.empty() ? std::string() : result.problems[0].message(),
           message.toStdString());
}

QTEST_APPLESS_MAIN(TestCsvImport)
#include "test_csv_import.moc"
