#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <numbers>

#include "sim/core/error.h"
#include "sim/document/prescribed_inputs.h"
#include "sim/run/load_inputs.h"
#include "sim/signal/input_signal.h"

using namespace rotorbench;
using Eigen::Vector4d;
using FourSignal = InputSignal<Vector4d>;

namespace {

FourSignal sampleSignal(Interpolation interpolation) {
  return {{{1.0, Vector4d(1, 2, 3, 4)},
           {2.0, Vector4d(3, 2, 1, 0)},
           {4.0, Vector4d(7, 2, 1, -4)},
           {4.5, Vector4d(0, 0, 0, 0)}},
          interpolation};
}

/// A source in a folder of its own.
template <class Inputs, class Csv>
RotorInputs load(const QByteArray& text, int rotors,
                 Interpolation interpolation = Interpolation::Linear) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("inputs.csv"));
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("no file");
  file.close();
  Inputs inputs;
  inputs.source = Csv{"inputs.csv", interpolation};
  return loadInputs(inputs, rotors, folder.path().toStdString());
}
RotorInputs loadSpeeds(const QByteArray& text, int rotors = 4) {
  return load<SpeedInputs, CsvInputs<RotorSpeedQuantity>>(text, rotors);
}
RotorInputs loadVoltages(const QByteArray& text) {
  return load<VoltageInputs, CsvInputs<MotorVoltageQuantity>>(text, 4, Interpolation::Hold);
}

/// The first four lanes; those beyond are nobody's.
void compare(const PerRotor& lanes, const Vector4d& expected) {
  const Vector4d actual = lanes.head<4>();
  QVERIFY2((actual - expected).norm() < 1e-12 * (1 + expected.norm()),
           qPrintable(
               QString("%1 %2 %3 %4").arg(actual[0]).arg(actual[1]).arg(actual[2]).arg(actual[3])));
}

}  // namespace

class TestPrescribedInputs : public QObject {
  Q_OBJECT

 private slots:
  void betweenSamples_data();
  void betweenSamples();
  void anyOrderOfTimes();
  void constantForAllTimes();
  void tableOfTheExperiment();
  void units_data();
  void units();
  void voltagesFromCsv();
  void sixAndEightRotors();
  void badCsv_data();
  void badCsv();
  void negativeVoltage();
  void missingFile();
  void noFileNamed();
};

void TestPrescribedInputs::betweenSamples_data() {
  QTest::addColumn<double>("time");
  QTest::addColumn<double>("held");
  QTest::addColumn<double>("straight");
  QTest::addRow("long before") << -100.0 << 1.0 << 1.0;
  QTest::addRow("just before") << 0.999 << 1.0 << 1.0;
  QTest::addRow("first sample") << 1.0 << 1.0 << 1.0;
  QTest::addRow("a quarter on") << 1.25 << 1.0 << 1.5;
  QTest::addRow("second sample") << 2.0 << 3.0 << 3.0;
  QTest::addRow("halfway") << 3.0 << 3.0 << 5.0;
  QTest::addRow("just before the third") << 3.999 << 3.0 << 6.998;
  QTest::addRow("going down") << 4.25 << 7.0 << 3.5;
  QTest::addRow("last sample") << 4.5 << 0.0 << 0.0;
  QTest::addRow("after") << 1e9 << 0.0 << 0.0;
}

void TestPrescribedInputs::betweenSamples() {
  QFETCH(double, time);
  QFETCH(double, held);
  QFETCH(double, straight);
  QCOMPARE(sampleSignal(Interpolation::Hold).at(time)[0], held);
  QVERIFY(std::abs(sampleSignal(Interpolation::Linear).at(time)[0] - straight) < 1e-12);
}

/// A signal asked forwards, backwards and to and fro says the same as one asked for the first time.
void TestPrescribedInputs::anyOrderOfTimes() {
  for (const auto interpolation : {Interpolation::Hold, Interpolation::Linear}) {
    FourSignal signal = sampleSignal(interpolation);
    for (const double t : {0.0, 1.5, 4.2, 5.0, 4.2, 3.0, 1.0, 0.5, 4.5, 1.99, 2.0, 1.99}) {
      QCOMPARE(signal.at(t), sampleSignal(interpolation).at(t));
    }
  }
}

void TestPrescribedInputs::constantForAllTimes() {
  SpeedInputs inputs;
  inputs.source = ConstantInputs<RotorSpeedQuantity>{{1, 2, 3, 4}};
  RotorInputs signal = loadInputs(inputs, 4, {});
  for (const double t : {0.0, 1e-3, 36000.0}) compare(signal.at(t), Vector4d(1, 2, 3, 4));
}

void TestPrescribedInputs::tableOfTheExperiment() {
  VoltageInputs inputs;
  TableInputs<MotorVoltageQuantity> table;
  table.rows = {{0, {2, 2, 2, 2}}, {1, {6, 6, 6, 6}}};
  table.interpolation = Interpolation::Linear;
  inputs.source = table;
  RotorInputs signal = loadInputs(inputs, 4, {});
  QCOMPARE(signal.interpolation(), Interpolation::Linear);
  compare(signal.at(0.75), Vector4d::Constant(5));
}

void TestPrescribedInputs::units_data() {
  QTest::addColumn<QByteArray>("header");
  QTest::addColumn<double>("time");    // of "100" in the file, s
  QTest::addColumn<double>("factor");  // of rotor 1 to rad/s
  const double rpm = 2 * std::numbers::pi / 60;
  QTest::addRow("none") << QByteArray("time,a,b,c,d") << 100.0 << 1.0;
  QTest::addRow("rad/s") << QByteArray("time [s],a [rad/s],b,c,d") << 100.0 << 1.0;
  QTest::addRow("rpm") << QByteArray("time [s],a [rpm],b,c,d") << 100.0 << rpm;
  QTest::addRow("round brackets") << QByteArray("time (s),a (rpm),b,c,d") << 100.0 << rpm;
  QTest::addRow("milliseconds") << QByteArray("t [ms],a [rpm],b,c,d") << 0.1 << rpm;
}

void TestPrescribedInputs::units() {
  QFETCH(QByteArray, header);
  QFETCH(double, time);
  QFETCH(double, factor);
  RotorInputs signal = loadSpeeds(header + "\n0,0,0,0,0\n100,3000,20,-30,40\n");
  compare(signal.at(time), Vector4d(3000 * factor, 20, -30, 40));
  compare(signal.at(time / 2), Vector4d(1500 * factor, 10, -15, 20));
}

void TestPrescribedInputs::voltagesFromCsv() {
  RotorInputs signal =
      loadVoltages("time [s];v1 [V];v2 [mV];v3 [V];v4 [V]\n0;5,5;6000;7;8\n1;1;1;1;1\n");
  compare(signal.at(0.5), Vector4d(5.5, 6, 7, 8));
}

/// As many columns as the vehicle has rotors, and one for the time.
void TestPrescribedInputs::sixAndEightRotors() {
  RotorInputs six = loadSpeeds("time,a,b,c,d,e,f\n0,1,2,3,4,5,6\n2,1,2,3,4,5,8\n", 6);
  compare(six.at(1), Vector4d(1, 2, 3, 4));
  QCOMPARE(six.at(1)[4], 5.0);
  QCOMPARE(six.at(1)[5], 7.0);
  QCOMPARE(loadSpeeds("time,a,b,c,d,e,f,g,h\n0,1,2,3,4,5,6,7,8\n", 8).at(0)[7], 8.0);
  try {
    loadSpeeds("time,a,b,c,d\n0,1,2,3,4\n", 6);
    QFAIL("four columns for six rotors");
  } catch (const InputError& error) {
    QVERIFY(error.problems().front().allowed.find("7: time") == 0);
  }
}

void TestPrescribedInputs::badCsv_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("named");
  const QByteArray header = "time [s],r1,r2,r3,r4\n";
  QTest::addRow("four columns") << QByteArray("time,a,b,c\n0,1,2,3\n") << "has 4 columns";
  QTest::addRow("six columns") << QByteArray("time,a,b,c,d,e\n0,1,2,3,4,5\n") << "has 6 columns";
  QTest::addRow("a short row") << header + "0,1,2,3,4\n1,2,3,4\n"
                               << "line 3";
  QTest::addRow("falling times") << header + "0,1,1,1,1\n2,1,1,1,1\n1,1,1,1,1\n"
                                 << "row 3";
  QTest::addRow("equal times") << header + "0,1,1,1,1\n0,1,1,1,1\n"
                               << "row 2";
  QTest::addRow("text in numbers") << header + "0,1,fast,1,1\n"
                                   << "fast";
  QTest::addRow("an empty cell") << header + "0,1,,1,1\n"
                                 << "r2";
  QTest::addRow("nan") << header + "0,nan,1,1,1\n"
                       << "nan";
  QTest::addRow("mass") << QByteArray("time [s],a [kg],b,c,d\n0,1,2,3,4\n") << "kg";
  QTest::addRow("time in metres") << QByteArray("time [m],a,b,c,d\n0,1,2,3,4\n") << "time";
  QTest::addRow("beyond the range") << header + "0,1,1,1,1e6\n"
                                    << "rotor 4";
  QTest::addRow("two columns alike") << QByteArray("time,a,a,b,c\n0,1,2,3,4\n") << "two columns";
  QTest::addRow("no rows") << header << "no rows";
  QTest::addRow("empty") << QByteArray() << "empty";
}

void TestPrescribedInputs::badCsv() {
  QFETCH(QByteArray, text);
  QFETCH(QString, named);
  try {
    loadSpeeds(text);
    QFAIL("the file was accepted");
  } catch (const InputError& error) {
    QVERIFY2(QString::fromStdString(error.source()).endsWith("inputs.csv"), error.what());
    QCOMPARE(error.problems().size(), std::size_t{1});
    const auto message = QString::fromStdString(error.problems().front().message());
    QVERIFY2(message.contains(named), qPrintable(message));
  }
}

void TestPrescribedInputs::negativeVoltage() {
  const QByteArray text = "time,a,b,c,d\n0,-1,2,3,4\n";
  // A rotor may turn backwards, and a reversible speed controller may turn it so.
  RotorInputs speeds = loadSpeeds(text), voltages = loadVoltages(text);
  QCOMPARE(speeds.at(0)[0], -1.0);
  QCOMPARE(voltages.at(0)[0], -1.0);
  QVERIFY_THROWS_EXCEPTION(InputError, loadVoltages("time,a,b,c,d\n0,-1001,2,3,4\n"));
}

void TestPrescribedInputs::missingFile() {
  const QTemporaryDir folder;
  SpeedInputs inputs;
  inputs.source = CsvInputs<RotorSpeedQuantity>{"nowhere.csv", Interpolation::Hold};
  try {
    loadInputs(inputs, 4, folder.path().toStdString());
    QFAIL("accepted");
  } catch (const InputError& error) {
    QVERIFY2(QString::fromStdString(error.source()).endsWith("nowhere.csv"), error.what());
    QCOMPARE(error.problems().front().what, std::string("there is no such file"));
  }
}

void TestPrescribedInputs::noFileNamed() {
  SpeedInputs inputs;
  inputs.source = CsvInputs<RotorSpeedQuantity>{};
  try {
    loadInputs(inputs, 4, {}, Place("setup") / "control");
    QFAIL("accepted");
  } catch (const InputError& error) {
    QCOMPARE(error.problems().front().path, std::string("setup.control.source.file"));
  }
}

QTEST_GUILESS_MAIN(TestPrescribedInputs)
#include "test_prescribed_inputs.moc"
