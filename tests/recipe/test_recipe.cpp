// A controller added as README says: it is read, described, checked and flown, and no other file of
// the house was changed for it.
#include <QTest>

#include "sim/control/height_hold.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/flight.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

Experiment flight(const std::string& controller) {
  return readExperiment(R"({"rotorbench": 1, "setup": {"type": "flight",
    "vehicle": {"supply": {"type": "fixed", "voltage": "11.1 V"}},
    "control": {"type": "controlled", "controller": )" +
                            controller + R"(,
      "setPoints": [{"time": 0, "height": 0}, {"time": 1, "height": 2}]},
    "duration": 7}})",
                        "test");
}

}  // namespace

class TestRecipe : public QObject {
  Q_OBJECT
 private slots:
  void flies() {
    const auto run = runToEnd(flight(R"({"type": "height-hold", "stiffness": 9, "damping": 6})"));
    const Recording& r = *run->runs().front().recording;
    QVERIFY(run->verdicts().empty());
    // A double pole at -3 rad/s: 1 - (1 + 3t) exp(-3t) of the step, and the motors' lag.
    QVERIFY(std::abs(r.value(*r.find("position.z"), r.rows() - 1) - 2) < 1e-3);
    const double second = r.value(*r.find("position.z"), 2000), exact = 2 * (1 - 4 * std::exp(-3));
    QVERIFY2(std::abs(second - exact) < 0.2, qPrintable(QString::number(second - exact)));
    QVERIFY(r.find("controller.climb").has_value());
    QVERIFY(figure(run->metrics(), "Flight", "altitude_settling_time") > 1);
  }

  /// Its settings come through a file, and the form's choices name it.
  void isDescribed() {
    const Experiment e = flight(R"({"type": "height-hold", "damping": 5})");
    const Experiment again = readExperiment(writeExperiment(e), "again");
    QVERIFY(again == e);
    const auto& inputs = alternative<ControlledInputs>(alternative<Flight>(again.setup).control);
    QCOMPARE(std::get<HeightHoldParameters>(inputs.controller).damping, 5.0);
    QVERIFY(experimentJsonSchema().find("height-hold") != std::string::npos);
  }

  void faultsAreNamed() {
    try {
      buildSimulation(flight(R"({"type": "height-hold", "rate": 300})"));
      QFAIL("a rate that does not fit was taken");
    } catch (const InputError& error) {
      QCOMPARE(error.problems().front().path, std::string("setup.control.controller.rate"));
    }
  }

  /// The first controller is still there, and what a file means that names none.
  void theOthersStay() {
    const Experiment e = flight(R"({"altitude": {"kp": 9}})");
    const auto& inputs = alternative<ControlledInputs>(alternative<Flight>(e.setup).control);
    QCOMPARE(std::get<PidFlightParameters>(inputs.controller).altitude.kp, 9.0);
    const auto run = runToEnd(e);
    const Recording& r = *run->runs().front().recording;
    QVERIFY(r.find("control.momentX") && !r.find("controller.climb"));
    QCOMPARE(runToEnd(shipped("f450-hover-and-steps"))->verdicts().size(), std::size_t{0});
  }
};

QTEST_GUILESS_MAIN(TestRecipe)
#include "test_recipe.moc"
