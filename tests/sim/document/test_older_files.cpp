// Files of earlier versions mean what they meant.
#include <QTest>

#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"

using namespace rotorbench;

namespace {

Experiment flight(const std::string& control) {
  return readExperiment(
      R"({"rotorbench": 1, "setup": {"type": "flight", "control": )" + control + "}}", "test");
}

const ControlledInputs& inputsOf(const Experiment& e) {
  return alternative<ControlledInputs>(alternative<Flight>(e.setup).control);
}

std::string refusal(const std::string& control) {
  try {
    flight(control);
  } catch (const InputError& error) {
    return error.problems().front().message();
  }
  return {};
}

}  // namespace

class TestOlderFiles : public QObject {
  Q_OBJECT
 private slots:
  /// The way of control was named for its one controller, and the motors' controllers were its own.
  void controllerOne() {
    const Experiment before = flight(
        R"({"type": "pid", "controller":
              {"rate": 250, "motors": {"rate": 500, "feedForward": false}}})");
    const Experiment now = flight(
        R"({"type": "controlled", "controller": {"type": "pid", "rate": 250},
            "motors": {"rate": 500, "feedForward": false}})");
    QVERIFY(before == now);
    QCOMPARE(std::get<PidFlightParameters>(inputsOf(before).controller).rate, 250.0);
    QCOMPARE(inputsOf(before).motors.rate, 500.0);
    QVERIFY(!inputsOf(before).motors.feedForward);
    const std::string written = writeExperiment(before);
    QVERIFY(written.find("\"controlled\"") != std::string::npos);
    QVERIFY(readExperiment(written, "again") == before);
  }

  void faultsInThemAreNamedWhereTheyBelongNow() {
    QVERIFY(refusal(R"({"type": "pid", "controller": {"motors": {"rate": -1}}})")
                .starts_with("setup.control.motors.rate: "));
    // Both places at once: the older one is unknown.
    QVERIFY(refusal(R"({"type": "controlled", "motors": {}, "controller": {"motors": {}}})")
                .starts_with("setup.control.controller.motors: "));
  }

  void commandsOfOldStillChoose() {
    Experiment e;
    schema::setFromText(schema::ref(e), "setup.control.type", "rotor-speeds");
    QVERIFY(!holdsAlternative<ControlledInputs>(alternative<Flight>(e.setup).control));
    schema::setFromText(schema::ref(e), "setup.control.type", "pid");
    QVERIFY(holdsAlternative<ControlledInputs>(alternative<Flight>(e.setup).control));
    QCOMPARE(std::get<std::string>(schema::get(schema::ref(e), "setup.control.type")),
             std::string("controlled"));
  }
};

QTEST_GUILESS_MAIN(TestOlderFiles)
#include "test_older_files.moc"
