// Performance tables in blocks as APC publishes them, on made-up files of that layout (SOURCE.txt
// has the formula): one table with speeds, units of the unit line, a propeller that flies by it,
// and sentences for what is broken.
#include <QFile>
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/core/error.h"
#include "sim/fitting/coefficient_points.h"
#include "sim/logs/csv_import.h"
#include "sim/logs/propeller_blocks.h"
#include "sim/logs/speed_curves.h"

using namespace rotorbench;

namespace {

constexpr double kRpm = std::numbers::pi / 30, kDiameter = 8 * 0.0254;

QByteArray fileText(const char* name) {
  QFile file(QString(TEST_DATA_DIR "/measurement/") + name);
  if (!file.open(QIODevice::ReadOnly)) qFatal("no such file");
  return file.readAll();
}

ImportResult imported(const QByteArray& text) {
  const TextLines lines = TextLines::fromBytes(text.toStdString(), "PER3.dat");
  return importTable(lines, guessSettings(lines));
}

// The formula of SOURCE.txt.
double ct(double j, double rpm) {
  return (0.10 - 0.075 * j - 0.06 * j * j) * (0.96 + rpm / 2e5);
}
double cp(double j, double rpm) {
  return (0.045 + 0.012 * j - 0.055 * j * j) * (1.02 - rpm / 2e5);
}

}  // namespace

class TestPropellerBlocks : public QObject {
  Q_OBJECT
 private slots:
  void readsTheFile_data();
  void readsTheFile();
  void valuesAreSi();
  void leavesOutWhatIsUnsolved();
  void becomesAPropeller();
  void curvesOfOneSpeed();
  void saysWhatAPropellerNeeds();
  void broken_data();
  void broken();
  void randomTables();
  void diameters_data();
  void diameters();
};

void TestPropellerBlocks::readsTheFile_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("mapping");
  QTest::addColumn<int>("rows");
  // Of 3 blocks of 15 rows two have no solution.
  QTest::addRow("2014") << fileText("PER3_8x6S.dat")
                        << "motor.speed=PROP RPM [rpm] air_speed=V [mph] advance_ratio=J [1] "
                           "efficiency=Pe [1] ct=Ct [1] cp=Cp [1] power.shaft=PWR [hp] "
                           "motor.torque=Torque [lbf*in] thrust=Thrust [lbf]"
                        << 43;
  QTest::addRow("2022") << fileText("PER3_8x6S_wide.dat")
                        << "motor.speed=PROP RPM [rpm] air_speed=V [mph] advance_ratio=J [1] "
                           "efficiency=Pe [1] ct=Ct [1] cp=Cp [1] power.shaft=PWR [hp] "
                           "motor.torque=Torque [lbf*in] thrust=Thrust [lbf]"
                        << 24;
}

void TestPropellerBlocks::readsTheFile() {
  QFETCH(QByteArray, text);
  QFETCH(QString, mapping);
  QFETCH(int, rows);
  const TextLines lines = TextLines::fromBytes(text.toStdString(), "PER3.dat");
  const ImportSettings settings = guessSettings(lines);
  QStringList parts;
  for (const ColumnMapping& column : settings.columns) {
    if (!column.quantity.empty())
      parts << QString::fromStdString(column.quantity + "=" + column.column + " [" + column.unit +
                                      "]");
  }
  QCOMPARE(parts.join(' '), mapping);
  QCOMPARE(settings.group, ChannelGroup::OverAdvance);
  const ImportResult result = importTable(lines, settings);
  QVERIFY(result.usable());
  QCOMPARE(result.table.rows(), static_cast<std::size_t>(rows));
}

/// Against the formula, to the digits that are written: coefficients 4 places, J 2 places (of which
/// CT moves by at most 0.18 times as much), thrust 3 places of a pound.
void TestPropellerBlocks::valuesAreSi() {
  const MeasuredTable table = imported(fileText("PER3_8x6S.dat")).table;
  QCOMPARE(table.channels[0].name, std::string("over_advance.j"));
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const double j = (*table.find("advance_ratio"))[r], w = (*table.find("motor.speed"))[r];
    const double rpm = w / kRpm, turns = rpm / 60;
    QVERIFY(rpm == 2000 || rpm == 5000 || rpm == 9000);
    QVERIFY(std::abs((*table.find("ct"))[r] - ct(j, rpm)) < 1e-4 + 0.005 * 0.19);
    QVERIFY(std::abs((*table.find("cp"))[r] - cp(j, rpm)) < 1e-4 + 0.005 * 0.09);
    const double force = 1.225 * turns * turns * std::pow(kDiameter, 4);
    QVERIFY(std::abs((*table.find("thrust"))[r] - ct(j, rpm) * force) <
            0.0006 * 4.448 + 0.001 * force);
    QVERIFY(std::abs((*table.find("air_speed"))[r] - j * turns * kDiameter) <
            0.06 * 0.447 + 0.005 * turns * kDiameter);
    const double power = cp(j, rpm) * force * turns * kDiameter;
    QVERIFY(std::abs((*table.find("power.shaft"))[r] - power) <
            0.0006 * 745.7 + 0.0005 * force * turns * kDiameter);
  }
}

void TestPropellerBlocks::leavesOutWhatIsUnsolved() {
  const ImportResult result = imported(fileText("PER3_8x6S.dat"));
  QCOMPARE(result.problems.size(), std::size_t{2});
  QCOMPARE(result.problems[0].message(),
           std::string("1 row of the propeller table has fewer cells than there are columns (first "
                       "in line 76: \"57.3        0.84\"); left out"));
  QCOMPARE(result.problems[1].message(),
           std::string("1 row of the propeller table has no numbers but NaN beside the air speed "
                       "(first in line 75); left out"));
  QVERIFY(imported(fileText("PER3_8x6S_wide.dat")).problems.empty());
}

void TestPropellerBlocks::becomesAPropeller() {
  const MeasuredTable table = imported(fileText("PER3_8x6S_wide.dat")).table;
  const MeasuredPropeller propeller = propellerOfTable(table, kDiameter);
  QCOMPARE(propeller.points.size(), std::size_t{24});
  const CoefficientTable ready(propeller);
  // Between two points of one speed, and at the mean of the two speeds: the formula is linear in
  // the speed.
  for (const double rpm : {3000.0, 4500.0, 6000.0}) {
    const double turns = rpm / 60, j = 0.3;
    const auto load = ready.axialLoad(rpm * kRpm, j * turns * kDiameter, 1.225);
    const double force = 1.225 * turns * turns * std::pow(kDiameter, 4);
    QVERIFY(std::abs(load.thrust / force - ct(j, rpm)) < 3e-4);
    QVERIFY(std::abs(load.torque * 2 * std::numbers::pi / (force * kDiameter) - cp(j, rpm)) < 3e-4);
  }
}

void TestPropellerBlocks::curvesOfOneSpeed() {
  const MeasuredTable table = imported(fileText("PER3_8x6S.dat")).table;
  const std::vector<double> speeds = curveSpeeds(table);
  QCOMPARE(speeds.size(), std::size_t{3});
  QVERIFY(std::abs(speeds[1] / kRpm - 5000) < 1e-6);
  const MeasuredTable curve = curveAtSpeed(table, speeds[1]);
  QCOMPARE(curve.rows(), std::size_t{15});
  QVERIFY(std::ranges::is_sorted(curve.columns[0]));
  QVERIFY(curveSpeeds(curve).empty());  // one speed is no choice
  QVERIFY(curveSpeeds(imported("time [s],rpm\n0,1000\n1,1000\n2,3000\n3,3000\n").table).empty());
  QVERIFY(curveSpeeds(imported("J,rpm\n0,-1000\n0.1,-1000\n0.2,0\n0.3,0\n").table).empty());
}

void TestPropellerBlocks::saysWhatAPropellerNeeds() {
  const MeasuredTable stand = imported("time [s],thrust [N]\n0,1\n1,2\n").table;
  QCOMPARE(
      missingForCoefficients(stand),
      (std::vector<std::string>{"The measured data have no column for Thrust coefficient CT.",
                                "The measured data have no column for Power coefficient CP."}));
  QVERIFY_THROWS_EXCEPTION(InputError, propellerOfTable(stand, 0.2));
  const MeasuredTable table = imported("J,CT,CP\n0,0.1,0.05\n0.3,0.05,0.04\n").table;
  QCOMPARE(propellerOfTable(table, 0.2).points.size(), std::size_t{2});
  QVERIFY_THROWS_EXCEPTION(InputError, propellerOfTable(table, -1));
  const MeasuredTable single = imported("rpm,CT,CP\n1000,0.1,0.05\n2000,0.11,0.05\n").table;
  QVERIFY_THROWS_EXCEPTION(InputError, propellerOfTable(single, 0.2));  // no curve over J
}

void TestPropellerBlocks::broken_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("sentence");
  const QByteArray names = "\n   V     J      Ct     Cp\n (mph) (Adv Ratio)\n";
  const QByteArray rows = " 0.0  0.0  0.1  0.05\n 5.0  0.2  0.08  0.05\n";
  const QByteArray good = "8x6\n PROP RPM = 1000\n" + names + rows;
  QTest::addRow("no speed") << "8x6\n PROP RPM =\n" + names + rows
                            << "line 2: the block of the propeller table has no speed: \"PROP RPM "
                               "=\"; must be a number above 0, as in PROP RPM = 5000";
  QTest::addRow("a word for the speed")
      << good + "\n PROP RPM = fast\n" + names + rows
      << "line 9: the block of the propeller table has no speed: \"PROP RPM = fast\"; must be a "
         "number above 0, as in PROP RPM = 5000";
  QTest::addRow("speed 0") << "PROP RPM = 0\n" + names + rows
                           << "line 1: the block of the propeller table has no speed: \"PROP RPM = "
                              "0\"; must be a number above 0, as in PROP RPM = 5000";
  QTest::addRow("no names") << "PROP RPM = 1000\n" + rows
                            << "line 1: the block of the propeller table has no names of columns; "
                               "must be followed by a line such as V J Pe Ct Cp PWR Torque Thrust";
  QTest::addRow("heading alone") << good + "PROP RPM = 2000\n"
                                 << "line 8: the block of the propeller table has no names of "
                                    "columns; must be followed by a line such as V J Pe Ct Cp PWR "
                                    "Torque Thrust";
  QTest::addRow("other columns") << good + "PROP RPM = 2000\n V J Cp Ct\n" + rows
                                 << "line 9: the columns of this block differ from those of the "
                                    "first; must be the same in all blocks of a propeller table";
  QTest::addRow("row too short") << good + " 6.0 0.3\n"
                                 << "1 row of the propeller table has fewer cells than there are "
                                    "columns (first in line 8: \"6.0 0.3\"); left out";
  QTest::addRow("text in a number") << good + " 6.0 0.3 0.0x5 0.04\n"
                                    << "column \"Ct\": 1 cell is not a number (first in line 8: "
                                       "\"0.0x5\"); taken as empty";
  QTest::addRow("row too long") << good + " 6.0 0.3 0.05 0.04 0.9\n"
                                << "1 row has more cells than there are columns (first in line 8); "
                                   "the surplus is left out";
}

void TestPropellerBlocks::broken() {
  QFETCH(QByteArray, text);
  QFETCH(QString, sentence);
  QStringList said;
  try {
    for (const Problem& problem : imported(text).problems)
      said << QString::fromStdString(problem.message());
  } catch (const InputError& error) {
    said << QString::fromStdString(error.problems().front().message());
  }
  QCOMPARE(said, QStringList{sentence});
}

/// Pieces of such files in any order: one sentence or a table with columns of equal length, never a
/// crash.
void TestPropellerBlocks::randomTables() {
  const QByteArrayList pieces{"PROP RPM = 5000\n",
                              "PROP RPM =",
                              "\n",
                              " V J Pe Ct Cp\n",
                              "(mph) (Adv Ratio)",
                              " 1.0 0.2 0.5 0.1 0.05\n",
                              "-NaN",
                              "NaNNaN",
                              "0.69-NaN",
                              " ",
                              "\t",
                              "(",
                              ")",
                              "7",
                              "\r\n",
                              "\"",
                              "8x6 8x\n",
                              "\xFF"};
  std::mt19937 random(20261122);
  int refused = 0, tables = 0;
  for (int round = 0; round < 3000; ++round) {
    QByteArray text = round % 2 == 0 ? "8x6\nPROP RPM = 5000\n V J Pe Ct Cp\n" : "";
    const auto count = random() % 40;
    for (std::size_t i = 0; i < count; ++i)
      text += pieces[static_cast<qsizetype>(random() % static_cast<unsigned>(pieces.size()))];
    try {
      const ImportResult result = imported(text + "1");
      for (const auto& column : result.table.columns) QCOMPARE(column.size(), result.table.rows());
      ++tables;
    } catch (const InputError& error) {
      QCOMPARE(error.problems().size(), std::size_t{1});
      ++refused;
    }
  }
  QVERIFY(refused > 100 && tables > 100);
}

void TestPropellerBlocks::diameters_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("inches");  // 0: none
  QTest::addRow("APC") << "         10x4.5MR                 (10x45MR.dat)" << 10.0;
  QTest::addRow("small") << "4.2x2   (42x2.dat)" << 4.2;
  QTest::addRow("UIUC") << "apcsf_10.5x4.7_kt0836_4014" << 10.5;
  QTest::addRow("a word with x") << "exp 3 of axle" << 0.0;
  QTest::addRow("none") << "stand" << 0.0;
  QTest::addRow("too large") << "1024x768" << 0.0;
  QTest::addRow("at the end") << "10x" << 0.0;
}

void TestPropellerBlocks::diameters() {
  QFETCH(QString, name);
  QFETCH(double, inches);
  const auto diameter = diameterInName(name.toStdString());
  QCOMPARE(diameter.has_value(), inches > 0);
  if (diameter) QVERIFY(std::abs(*diameter - inches * 0.0254) < 1e-12);
}

QTEST_APPLESS_MAIN(TestPropellerBlocks)
#include "test_propeller_blocks.moc"
