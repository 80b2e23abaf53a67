// rotorbench-cli as a person or a script uses it: the real program, its output, its files, its exit
// codes.
#include <signal.h>

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/cli.h"

using namespace rotorbench::test;

class TestCli : public QObject {
  Q_OBJECT

 private slots:
  void helpAndVersion() {
    for (const char* word :
         {"run", "list", "schema", "set", "performance", "data-sheet", "lump", "validate"}) {
      QVERIFY(cli({"--help"}).out.contains(word));
      QCOMPARE(cli({word, "--help"}).code, 0);
    }
    const Outcome version = cli({"--version"});
    QCOMPARE(version.code, 0);
    QVERIFY(version.out.startsWith("rotorbench-cli "));
    QCOMPARE(cli({}).code, 2);
    QCOMPARE(cli({"fly"}).code, 2);
    QCOMPARE(cli({"run"}).code, 2);
  }

  void listComponents() {
    QTemporaryDir data;
    qputenv("XDG_DATA_HOME", data.path().toUtf8());
    const QString own = data.filePath("Rotorbench/Rotorbench/library/motors");
    QVERIFY(QDir().mkpath(own));
    const auto put = [&own](const char* name, const char* text) {
      QFile file(own + '/' + name);
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(text);
    };
    put("mine.json", R"({"rotorbench-component": 1, "kind": "motor", "name": "Bench motor"})");
    put("broken.json", R"({"rotorbench-component": 1, "kind": "motor"})");
    const Outcome all = cli({"list", "components"});
    QCOMPARE(all.code, 0);
    for (const char* line :
         {"motor: Bench motor (yours)", "battery: ", "airframe: DJI F450 (JSBSim)",
          "propeller: APC Slow Flyer 10 x 4.7", "Note: "}) {
      QVERIFY2(all.out.contains(line), line);
    }
    QVERIFY(all.err.contains("broken.json") && all.err.contains("name"));
    const Outcome motors = cli({"list", "components", "--kind", "motor"});
    QVERIFY(motors.out.contains("motor: DJI E305 (2312E)"));
    QVERIFY(!motors.out.contains("battery: "));
    const Outcome wrong = cli({"list", "components", "--kind", "moter"});
    QCOMPARE(wrong.code, 2);
    QVERIFY(wrong.err.contains("motor"));
    QCOMPARE(cli({"list", "nothing"}).code, 2);
  }

  void list() {
    const Outcome outcome = cli({"list"});
    QCOMPARE(outcome.code, 0);
    QVERIFY(outcome.out.contains("f450-hover-and-steps"));
    QVERIFY(outcome.out.contains("spring-bar-birotor"));
  }

  void schemaIsJson() {
    const Outcome outcome = cli({"schema"});
    QCOMPARE(outcome.code, 0);
    QVERIFY(QJsonDocument::fromJson(outcome.out).object().contains("$schema"));
  }

  /// A vehicle that cannot lift itself: said before the run, and what it came to after it, by exit
  /// code and JSON too.
  void overloadedVehicle() {
    const QStringList load{"--set", "setup.vehicle.mass.mass=6.4", "--set", "setup.duration=5"};
    const QString file = shipped("f450-hover-and-steps");
    const Outcome run = cli(QStringList{"run", file, "--format", "json"} + load);
    QCOMPARE(run.code, 1);
    QVERIFY2(run.err.contains("warning: setup.vehicle.rotors: cannot hold the vehicle in a hover"),
             run.err.constData());
    QVERIFY2(run.err.contains("below the ground at "), run.err.constData());
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    QStringList verdicts, warnings;
    for (const QJsonValue v : json["verdicts"].toArray()) verdicts << v["name"].toString();
    for (const QJsonValue w : json["warnings"].toArray()) warnings << w["path"].toString();
    QVERIFY(verdicts.contains("below_ground"));
    QVERIFY(json["metrics"][0]["below_ground"].toDouble() > 0);
    QVERIFY(warnings.contains("setup.vehicle.rotors") && warnings.contains("setup.start.rotors"));
    // Other commands that read the file say it as well, and write nothing of it where their result
    // goes.
    const Outcome set = cli(QStringList{"set", file, "setup.vehicle.mass.mass=6.4"});
    QCOMPARE(set.code, 0);
    QVERIFY(set.err.contains("cannot hold the vehicle"));
    QVERIFY(QJsonDocument::fromJson(set.out).isObject());
    const Outcome sound = cli({"run", file, "--set", "setup.duration=0.1"});
    QCOMPARE(sound.code, 0);
    QVERIFY2(sound.err.isEmpty(), sound.err.constData());
  }

  /// Warnings of the schema's own rules reach the terminal too.
  void warningsOfRules() {
    const Outcome run = cli({"run", shipped("motor-bench-e305"), "--format", "json", "--set",
                             "setup.run.solver.method=rk4", "--set", "setup.run.solver.step=5 ms",
                             "--set", "setup.run.tick=5 ms", "--set", "setup.run.duration=0.05"});
    QVERIFY2(run.err.contains("warning: setup.run.solver.step: "), run.err.constData());
    const QJsonArray kept = QJsonDocument::fromJson(run.out).object()["warnings"].toArray();
    QVERIFY2(kept.size() == 1, run.out.constData());
    QCOMPARE(kept[0]["path"].toString(), QString("setup.run.solver.step"));
  }

  /// Another model of the propeller, and a second one, by --set; a measured one tells its limits.
  void propellerBenchWithOtherModels() {
    const Outcome measured = cli({"run", shipped("propeller-bench-10x47"), "--set",
                                  "setup.propeller.type=measured", "--format", "json"});
    QCOMPARE(measured.code, 0);
    QVERIFY(measured.out.contains("most_measured_advance_ratio"));
    QVERIFY(measured.out.contains("beyond_measured_share"));
    const Outcome both =
        cli({"run", shipped("propeller-bench-10x47"), "--set", "setup.propeller.type=map", "--set",
             "setup.second.type=measured", "--set", "setup.propeller.map.sideRefinements=0"});
    QCOMPARE(both.code, 0);
    QVERIFY(both.out.contains("Run, propeller map"));
    QVERIFY(both.out.contains("Run, measured propeller"));
    const Outcome outside =
        cli({"run", shipped("propeller-bench-10x47"), "--set", "setup.propeller.type=measured",
             "--set", "setup.curves.topSpeed=1000 rpm"});
    QCOMPARE(outside.code, 2);
    QVERIFY(outside.err.contains("topSpeed"));
  }

  void metricsAsJson() {
    const Outcome outcome = cli({"run", shipped("thesis-experiment-1"), "--format", "json"});
    QCOMPARE(outcome.code, 0);
    const QJsonObject json = QJsonDocument::fromJson(outcome.out).object();
    QVERIFY(json["experiment"].toString().contains("Thesis experiment 1"));
    QStringList runs;
    for (const QJsonValue row : json["metrics"].toArray()) {
      runs << row["run"].toString();
      for (const char* name : {"max_error_norm", "steps", "evaluations", "rejected"}) {
        QVERIFY(row[name].isDouble());
        QVERIFY(json["units"].toObject().contains(name));
      }
    }
    QCOMPARE(runs, (QStringList{"Euler", "RK4", "ABM4", "RK5(4)7M", "RK5(4)6M", "RK5(4)7S"}));
  }

  void metricsAsText() {
    const Outcome outcome = cli({"run", shipped("thesis-experiment-2")});
    QCOMPARE(outcome.code, 0);
    const QList<QByteArray> lines = outcome.out.trimmed().split('\n');
    QCOMPARE(lines.size(), 7);
    QVERIFY(lines[0].startsWith("run "));
    QVERIFY(lines[4].startsWith("RK5(4)7M"));
    // Aligned: every line ends its second column at the same place.
    const auto end = lines[0].indexOf("max_error_norm") + QByteArray("max_error_norm").size();
    for (const QByteArray& line : lines) QCOMPARE(line[end], ' ');
  }

  void recordingAsCsv() {
    const Outcome outcome = cli(
        {"run", shipped("f450-hover-and-steps"), "--format", "csv", "--set", "setup.duration=0.1"});
    QCOMPARE(outcome.code, 0);
    const QList<QByteArray> lines = outcome.out.trimmed().split('\n');
    QCOMPARE(lines.size(), 102);
    QVERIFY(lines[0].startsWith("time [s],position.x [m],"));
    QCOMPARE(lines[1].split(',').size(), lines[0].split(',').size());
    const Outcome several = cli({"run", shipped("thesis-experiment-2"), "--format", "csv"});
    QVERIFY(several.out.startsWith("run,time [s],"));
    QVERIFY(several.out.contains("\nRK5(4)7S,"));
  }

  /// A bench keeps its series over time, not one of its curves.
  void benchAsCsv() {
    const Outcome bench = cli({"run", shipped("motor-bench-e305"), "--format", "csv", "--set",
                               "setup.run.duration=0.05"});
    QCOMPARE(bench.code, 0);
    QVERIFY2(bench.out.startsWith("time [s],"), bench.out.left(80).constData());
    const Outcome stand = cli({"run", shipped("thrust-stand-x2216"), "--format", "csv"});
    QVERIFY2(stand.out.startsWith("time [s],"), stand.out.left(80).constData());
  }

  /// What list prints is what the other commands take.
  void namesOfShippedExperiments() {
    const QString name = "f450-hover-and-steps";
    const QStringList brief{"--set", "setup.duration=0.1", "--format", "json"};
    const Outcome byName = cli(QStringList{"run", name} + brief);
    QCOMPARE(byName.code, 0);
    QCOMPARE(byName.out, cli(QStringList{"run", shipped(name)} + brief).out);
    QCOMPARE(cli({"set", name, "title=Mine"}).out, cli({"set", shipped(name), "title=Mine"}).out);
    QCOMPARE(cli({"performance", name}).out, cli({"performance", shipped(name)}).out);
    const Outcome wrong = cli({"run", "f450-hover-and-stepz"});
    QCOMPARE(wrong.code, 2);
    QVERIFY2(wrong.err.contains("nearest is f450-hover-and-steps"), wrong.err.constData());
  }

  /// A disk that takes no more, as a file and as the standard output: the input is right, so 1.
  void fullDisk() {
    const QString full = "/dev/full";
    if (!QFile::exists(full)) QSKIP("no /dev/full here");
    const Outcome set = cli({"set", shipped("spring-bar-birotor"), "title=x", "-o", full});
    QCOMPARE(set.code, 1);
    QVERIFY2(set.err.contains("cannot be written"), set.err.constData());
    QTemporaryDir directory;
    QVERIFY(QFile::link(full, directory.filePath("metrics.json")));
    const Outcome run = cli({"run", shipped("spring-bar-birotor"), "--set", "setup.duration=1",
                             "--output", directory.path()});
    QCOMPARE(run.code, 1);
    QVERIFY2(run.err.contains("cannot be written"), run.err.constData());
    for (const QStringList& arguments :
         {QStringList{"schema"}, QStringList{"list"}, QStringList{"performance", "battery-flight"},
          QStringList{"run", "spring-bar-birotor", "--format", "csv"}}) {
      QProcess process;
      process.setStandardOutputFile(full);
      process.start(ROTORBENCH_CLI, arguments);
      QVERIFY(process.waitForFinished(60000));
      QVERIFY2(process.exitCode() == 1, qPrintable(arguments.join(' ')));
    }
    // A folder that is not there is the input's fault.
    QCOMPARE(cli({"set", shipped("spring-bar-birotor"), "title=x", "-o", "/no/such/x.json"}).code,
             2);
  }

  /// No air, and rates that make no whole ticks: refused in one sentence; a file can be changed all
  /// the same.
  void refusedRuns() {
    const QString file = shipped("f450-hover-and-steps");
    const Outcome air = cli({"run", file, "--set", "setup.environment.air.density=0"});
    QCOMPARE(air.code, 2);
    QVERIFY2(air.err.contains("where there is no air"), air.err.constData());
    const Outcome rate = cli({"run", file, "--set", "setup.control.motors.rate=300"});
    QCOMPARE(rate.code, 2);
    QVERIFY2(rate.err.contains("does not fit the tick"), rate.err.constData());
    QCOMPARE(cli({"set", file, "setup.control.motors.rate=300"}).code, 0);
  }

  void setChangesTheRun() {
    const QString file = shipped("spring-bar-birotor");
    const Outcome outcome = cli({"run", file, "--set", "setup.duration=2 s", "--set",
                                 "setup.solver.step=25 ms", "--format", "json"});
    const QJsonObject row =
        QJsonDocument::fromJson(outcome.out).object()["metrics"].toArray()[0].toObject();
    QCOMPARE(row["end_time"].toDouble(), 2.0);
    QCOMPARE(row["steps"].toInt(), 80);
  }

  /// A page that stands for itself, the same figures as JSON and CSV; a resources folder without
  /// data is no crash.
  void validationReport() {
    QTemporaryDir directory;
    const QString folder = directory.filePath("report");
    const Outcome outcome =
        cli({"validate", "--output", folder, "--case", "esc-test", "--case", "naca-tr594"});
    QCOMPARE(outcome.code, 0);
    QVERIFY(outcome.out.contains("holds") && !outcome.out.contains("MISSED"));
    const QByteArray page = contents(folder + "/index.html");
    QVERIFY(page.startsWith("<!DOCTYPE html>") && page.contains("<svg") &&
            page.endsWith("</html>\n"));
    const QJsonObject json = QJsonDocument::fromJson(contents(folder + "/results.json")).object();
    QVERIFY(json["passed"].toBool());
    QCOMPARE(json["cases"].toArray().size(), 2);
    for (const QJsonValue entry : json["cases"].toArray()) {
      const QJsonObject c = entry.toObject();
      for (const QJsonValue figure : c["figures"].toArray()) {
        QVERIFY(figure.toObject()["value"].isDouble());
      }
      const QJsonObject chart = c["charts"].toArray()[0].toObject();
      QVERIFY(!chart["series"].toArray()[0].toObject()["points"].toArray().isEmpty());
    }
    QVERIFY(contents(folder + "/results.csv")
                .startsWith("case,metric,evidence,unit,value,limit,passed\n"));
  }

  void wrongValidationIsNamed() {
    QTemporaryDir directory;
    const Outcome unknown = cli({"validate", "--output", directory.path(), "--case", "everything"});
    QCOMPARE(unknown.code, 2);
    QVERIFY(unknown.err.contains("everything") && unknown.err.contains("uiuc-global"));
    QCOMPARE(cli({"validate"}).code, 2);
    QCOMPARE(cli({"validate", "--output", "/dev/null/report", "--case", "naca-tr594"}).code, 2);
    qputenv("ROTORBENCH_RESOURCES", directory.path().toUtf8());
    const Outcome empty = cli({"validate", "--output", directory.path(), "--case", "esc-test"});
    qunsetenv("ROTORBENCH_RESOURCES");
    QCOMPARE(empty.code, 2);
    QVERIFY(empty.err.contains("steps.csv"));
  }

  void outputDirectory() {
    QTemporaryDir directory;
    const QString out = directory.filePath("deep/er");
    QCOMPARE(
        cli({"run", shipped("thesis-experiment-1"), "--output", out, "--set", "setup.duration=1"})
            .code,
        0);
    for (const char* name :
         {"experiment.json", "metrics.json", "metrics.txt", "recording-RK5-4-7M.csv",
          "recording-Reference.csv", "recording-Work-precision.csv"}) {
      QVERIFY2(contents(out + "/" + name).size() > 10, name);
    }
    // The experiment written beside the results gives the same results.
    const QString again = directory.filePath("again");
    QCOMPARE(cli({"run", out + "/experiment.json", "--output", again}).code, 0);
    QCOMPARE(contents(again + "/recording-RK4.csv"), contents(out + "/recording-RK4.csv"));
  }

  void sameSeedSameBytes() {
    QTemporaryDir directory;
    const QStringList run{"run", shipped("f450-hover-and-steps"), "--set", "setup.duration=2",
                          "--output"};
    QCOMPARE(cli(run + QStringList{directory.filePath("a")}).code, 0);
    QCOMPARE(cli(run + QStringList{directory.filePath("b")}).code, 0);
    const QByteArray a = contents(directory.filePath("a/recording.csv"));
    QVERIFY(a.size() > 100000);
    QVERIFY(a == contents(directory.filePath("b/recording.csv")));
  }

  void wrongInput_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("says");
    const QString f450 = shipped("f450-hover-and-steps");
    QTest::addRow("missing file") << QStringList{"run", "no-such-file.json"} << "no-such-file.json";
    QTest::addRow("directory") << QStringList{"run", "/"} << "/";
    QTest::addRow("not an assignment")
        << QStringList{"run", f450, "--set", "duration"} << "path=value";
    QTest::addRow("unknown path") << QStringList{"run", f450, "--set", "setup.durration=3"}
                                  << "duration";
    QTest::addRow("wrong unit") << QStringList{"run", f450, "--set", "setup.duration=3 kg"} << "kg";
    QTest::addRow("out of range") << QStringList{"run", f450, "--set", "setup.duration=-3"}
                                  << "above 0";
    QTest::addRow("not a number") << QStringList{"run", f450, "--set", "setup.duration=nan"}
                                  << "setup.duration";
    QTest::addRow("unknown format") << QStringList{"run", f450, "--format", "xml"} << "format";
    QTest::addRow("impossible inertia")
        << QStringList{"run", f450, "--set", "setup.vehicle.mass.inertia.xx=1"} << "inertia";
    QTest::addRow("output is a file") << QStringList{"run", f450, "--output", f450} << "directory";
  }
  void wrongInput() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, says);
    const Outcome outcome = cli(arguments);
    QCOMPARE(outcome.code, 2);
    QVERIFY2(outcome.err.contains(says.toUtf8()), outcome.err.constData());
    QVERIFY(outcome.out.isEmpty());
  }

  void everyProblemIsReported() {
    QTemporaryDir directory;
    QFile file(directory.filePath("bad.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        R"({"rotorbench": 1, "titel": "x", "setup": {"type": "flight", "duration": -1, "tick": "3 kg"}})");
    file.close();
    const Outcome outcome = cli({"run", file.fileName()});
    QCOMPARE(outcome.code, 2);
    for (const char* word :
         {"bad.json:titel", "title", "bad.json:setup.duration", "bad.json:setup.tick"}) {
      QVERIFY2(outcome.err.contains(word), outcome.err.constData());
    }
  }

  void failedRunKeepsTheRecording() {
    QTemporaryDir directory;
    const Outcome outcome = cli({"run", shipped("f450-hover-and-steps"), "--output",
                                 directory.filePath("out"), "--set", "setup.solver.method=euler",
                                 "--set", "setup.vehicle.rotors.rotor.motor.inductance=1 uH"});
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.err.contains("t = ") && outcome.err.contains("rotor"),
             outcome.err.constData());
    QVERIFY(contents(directory.filePath("out/recording.csv")).count('\n') > 1);
  }

  void interruptKeepsWhatWasRecorded() {
    QTemporaryDir directory;
    QProcess process;
    process.start(ROTORBENCH_CLI,
                  {"run", shipped("f450-hover-and-steps"), "--set", "setup.duration=36000", "--set",
                   "outputs.recordInterval=1", "--output", directory.filePath("out")});
    QVERIFY(process.waitForStarted());
    QVERIFY(!process.waitForFinished(700));
    kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(20000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("nterrupted"));
    QVERIFY(contents(directory.filePath("out/recording.csv")).count('\n') > 2);
  }

  /// A program changes the flight by lines; what it wrote repeats by the plain command. Wrong lines
  /// are named and change nothing.
  void liveRunRepeats() {
    QTemporaryDir folder;
    const QString live = folder.filePath("live"), again = folder.filePath("again");
    QProcess process;
    process.start(ROTORBENCH_CLI, {"run", shipped("f450-hover-and-steps"), "--set",
                                   "setup.duration=3", "--live", "--pace", "4", "-o", live});
    process.write(
        "# a comment\nat 0.5 control.byHand.height=1.5\nat 0.5 control.byHand.heightByHand=on\n"
        "control.controller.rate=100\nstep back\nnonsense\n");
    QVERIFY(process.waitForBytesWritten());
    QTest::qWait(200);
    process.write("pause\ncontrol.controller.roll.kp=60\nstep 0.1\nresume\npace 0\n");
    process.closeWriteChannel();
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 2);
    const QByteArray said = process.readAllStandardError();
    QVERIFY2(said.contains("not changed: control.controller.rate: cannot change"), said);
    QVERIFY2(said.contains("stdin:5: \"back\" is not allowed; must be a number from 1e-06 to "),
             said);
    QVERIFY2(said.contains("stdin:6: \"nonsense\" is not a command"), said);
    const QByteArray experiment = contents(live + "/experiment.json");
    QVERIFY(experiment.contains(R"({"time": 0.5, "parameter": "control.byHand.height")"));
    QCOMPARE(experiment.count("\"parameter\""), qsizetype{3});
    QCOMPARE(cli({"run", live + "/experiment.json", "-o", again}).code, 0);
    QCOMPARE(contents(again + "/recording.csv"), contents(live + "/recording.csv"));
    QCOMPARE(contents(again + "/metrics.json"), contents(live + "/metrics.json"));
    QVERIFY(!contents(again + "/recording.csv").isEmpty());
    // Only flights; and a pace only with them.
    QCOMPARE(cli({"run", shipped("motor-bench-e305"), "--live"}).code, 2);
    QVERIFY(cli({"run", shipped("f450-hover-and-steps"), "--pace", "2"}).code != 0);
  }

  void setCommandWritesAFile() {
    QTemporaryDir directory;
    const QString file = directory.filePath("new.json");
    QCOMPARE(cli({"set", shipped("spring-bar-birotor"), "title=My bar",
                  "setup.plant.stiffness=2000", "-o", file})
                 .code,
             0);
    QVERIFY(contents(file).contains("\"title\": \"My bar\""));
    QCOMPARE(cli({"run", file, "--set", "setup.duration=1"}).code, 0);
  }
};

QTEST_GUILESS_MAIN(TestCli)
#include "test_cli.moc"
