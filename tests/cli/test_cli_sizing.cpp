// performance, data-sheet and lump: what the command line works out without flying.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/cli.h"

using namespace rotorbench::test;

class TestCliSizing : public QObject {
  Q_OBJECT

 private slots:
  void performanceOfAVehicle() {
    const Outcome text = cli({"performance", shipped("f450-hover-and-steps")});
    QCOMPARE(text.code, 0);
    QVERIFY(text.out.contains("Thrust to weight"));
    QVERIFY(text.out.contains("limited by a motor's current limit of 20 A"));
    const Outcome json = cli({"performance", shipped("f450-hover-and-steps"), "--json"});
    const double light = figure(json.out, "thrust.toWeight");
    QVERIFY(light > 2 && light < 4);
    const Outcome heavy = cli({"performance", shipped("f450-hover-and-steps"), "--set",
                               "setup.vehicle.mass.mass=2.8", "--json"});
    QVERIFY(std::abs(figure(heavy.out, "thrust.toWeight") - light / 2) < 1e-6);
    const Outcome none = cli({"performance", shipped("spring-bar-birotor")});
    QCOMPARE(none.code, 2);
    QVERIFY(none.err.contains("has no vehicle"));
  }

  void dataSheetOfADrive() {
    const Outcome outcome = cli({"data-sheet", "--json", "--set", "motor.speedConstant=920 rpm/V"});
    QCOMPARE(outcome.code, 0);
    // K_t = 60/(2 pi Kv).
    QVERIFY(std::abs(figure(outcome.out, "motor.torqueConstant") - 60 / (2 * M_PI * 920)) < 1e-12);
    QVERIFY(cli({"data-sheet"}).out.contains("Thrust to weight"));
    const Outcome wrong = cli({"data-sheet", "--set", "motor.speedConstant=-1"});
    QCOMPARE(wrong.code, 2);
    QVERIFY(wrong.err.contains("speedConstant"));
    const Outcome bench = cli({"data-sheet", "--experiment", shipped("thrust-stand-x2216")});
    QCOMPARE(bench.code, 0);
    QCOMPARE(cli({"data-sheet", "--experiment", shipped("spring-bar-birotor")}).code, 2);
    QTemporaryDir folder;
    QFile file(folder.filePath("sheet.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    // The limit and no-load figures of the default motor: a motor that is described has none of it.
    file.write(R"({"rotorbench": 1, "motor": {"speedConstant": "920 rpm/V", "resistance": 0.117,
                   "noLoadCurrent": 0.45, "maxCurrent": 20}})");
    file.close();
    const Outcome read = cli({"data-sheet", file.fileName(), "--json"});
    QCOMPARE(read.out, outcome.out);
  }

  /// CT rho D^4/(2 pi)^2 and CP rho D^5/(2 pi)^3 of a propeller by coefficients, and its inflow.
  void lumpedCoefficients() {
    const Outcome text = cli({"lump", "f450-hover-and-steps"});
    QCOMPARE(text.code, 0);
    QVERIFY2(text.out.contains("Thrust coefficient"), text.out);
    const QString set = "setup.vehicle.rotors.rotor.aerodynamics.";
    const QStringList given{"lump",
                            "f450-hover-and-steps",
                            "--json",
                            "--set",
                            set + "thrustCoefficient=0.1",
                            "--set",
                            set + "powerCoefficient=0.05",
                            "--set",
                            set + "diameter=0.25",
                            "--set",
                            set + "inflow.inflow=2e-4"};
    QTemporaryDir folder;
    const QString file = folder.filePath("lumped.json");
    const Outcome json = cli(given + QStringList{"--output", file});
    QVERIFY2(json.code == 0, json.err);
    const double turn = 2 * M_PI, kEta = 0.1 * 1.225 * std::pow(0.25, 4) / (turn * turn),
                 kM = 0.05 * 1.225 * std::pow(0.25, 5) / (turn * turn * turn);
    QVERIFY(std::abs(figure(json.out, "lumped.thrust") / kEta - 1) < 1e-9);
    QVERIFY(std::abs(figure(json.out, "lumped.torque") / kM - 1) < 1e-9);
    QVERIFY(std::abs(figure(json.out, "lumped.inflow") / 2e-4 - 1) < 1e-6);
    // The file flies with them, at the hover speed they are of.
    const Outcome sheet = cli({"performance", file, "--json"});
    QVERIFY2(sheet.code == 0, sheet.err);
    QVERIFY(std::abs(figure(sheet.out, "hover.speed") / figure(json.out, "at.speed") - 1) < 1e-6);
    // It is lumped now.
    const Outcome again = cli({"lump", file});
    QCOMPARE(again.code, 2);
    QVERIFY2(again.err.contains("has no propeller that could be lumped"), again.err);
  }

  void lumpSaysWhatIsWrong() {
    const Outcome path = cli({"lump", "f450-hover-and-steps", "--rotor", "setup.here"});
    QCOMPARE(path.code, 2);
    QVERIFY2(path.err.contains("setup.vehicle.rotors.rotor.aerodynamics"), path.err);
    for (const char* speed : {"-5", "0", "many", "3 m"}) {
      const Outcome wrong = cli({"lump", "f450-hover-and-steps", "--speed", speed});
      QCOMPARE(wrong.code, 2);
      QVERIFY2(wrong.err.contains("--speed"), wrong.err);
    }
    const Outcome none = cli({"lump", "spring-bar-birotor"});
    QCOMPARE(none.code, 2);
    const Outcome faster = cli({"lump", "f450-hover-and-steps", "--json", "--speed", "6000 rpm"});
    QVERIFY(std::abs(figure(faster.out, "at.speed") - 200 * M_PI) < 1e-9);
  }
};

QTEST_GUILESS_MAIN(TestCliSizing)
#include "test_cli_sizing.moc"
