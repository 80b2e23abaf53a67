// Changes as a document holds them: what can change during a flight, what is refused and in which
// words, and what differs between two flights.
#include <QTest>

#include "sim/core/schema_tree.h"
#include "sim/document/changes.h"
#include "tests/sim/run/hard_flight.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

std::string refusal(const Flight& flight, const char* parameter, const char* value) {
  Flight copy = flight;
  const auto problem = makeChange(copy, {0, parameter, value});
  if (problem && !(copy == flight)) return "the flight is another";
  return problem ? problem->message() : std::string();
}

}  // namespace

class TestChanges : public QObject {
  Q_OBJECT
 private slots:
  void refusals_data();
  void refusals();
  void changesAreChecked();
  void differencesOfTwoFlights();
};

void TestChanges::refusals_data() {
  QTest::addColumn<QString>("parameter");
  QTest::addColumn<QString>("value");
  QTest::addColumn<QString>("sentence");
  const QString live =
      ": cannot change during a flight; gains, set-points and the numbers of a wind may change "
      "during a flight; all else needs a new run";
  QTest::addRow("not live") << "duration"
                            << "3"
                            << "duration" + live;
  QTest::addRow("a model") << "environment.wind.type"
                           << "still"
                           << "environment.wind.type" + live;
  QTest::addRow("a group") << "control.controller.roll"
                           << "3"
                           << "control.controller.roll" + live;
  QTest::addRow("the changes") << "changes"
                               << "3"
                               << "changes" + live;
  QTest::addRow("rate") << "setup.control.controller.rate"
                        << "100"
                        << "control.controller.rate" + live;
  QTest::addRow("misspelt") << "control.controller.rol.kp"
                            << "3"
                            << "control.controller.rol: there is no such parameter; the nearest is "
                               "control.controller.roll";
  QTest::addRow("range") << "control.controller.roll.kp"
                         << "-3"
                         << "control.controller.roll.kp: -3 1/s^2 is not allowed; must be at least "
                            "0 and at most 1e+05 1/s^2";
  QTest::addRow("unit") << "control.byHand.height"
                        << "3 kg"
                        << "control.byHand.height: \"3 kg\" is in kg; must be a "
                           "number in m, cm, mm, um, km, in, ft";
  QTest::addRow("a rule") << "control.setPoints[1].time"
                          << "0"
                          << "setPoints[1].time: is not later than the row before; times must rise "
                             "from row to row";
  QTest::addRow("no row") << "control.setPoints[2].height"
                          << "0"
                          << "control.setPoints: there is no element 2; the elements are 0 to 1";
}

void TestChanges::refusals() {
  QFETCH(QString, parameter);
  QFETCH(QString, value);
  QFETCH(QString, sentence);
  Experiment e = hardFlight(kSteady);
  const std::string said = refusal(flightOf(e), qPrintable(parameter), qPrintable(value));
  QCOMPARE(QString::fromStdString(said), sentence);
}

/// What is laid down in a file is checked like all of it; each change after those before it.
void TestChanges::changesAreChecked() {
  Experiment e = hardFlight(kSteady);
  auto& changes = flightOf(e).changes;
  changes = {{0.5, "control.setPoints[1].time", "0.9"},
             {0.4, "control.controller.roll.kp", "50"},
             {0.6, "setup.control.controller.roll.kp", "-1"},
             {2, "control.setPoints[0].time", "0.5 s"}};
  const auto problems = schema::validate(schema::ref(std::as_const(e)));
  QCOMPARE(problems.size(), std::size_t{3});
  QCOMPARE(problems[0].path, std::string("setup.changes[1].time"));
  QCOMPARE(problems[1].path, std::string("setup.changes[2]"));
  QCOMPARE(problems[2].path, std::string("setup.changes[3].time"));
  QVERIFY(!problems[0].warning && !problems[1].warning && problems[2].warning);
  changes.resize(1);
  const Experiment again = readExperiment(writeExperiment(e), "again");
  QVERIFY(again == e);
}

void TestChanges::differencesOfTwoFlights() {
  Experiment e = hardFlight(kSteady);
  const Flight from = flightOf(e);
  auto& to = flightOf(e);
  auto& inputs = alternative<ControlledInputs>(to.control);
  std::get<PidFlightParameters>(inputs.controller).roll.kp = 31;
  inputs.setPoints[1].roll = 0.1;
  std::get<SteadyWind>(to.environment.wind).velocity = {0, 0, 1};
  auto difference = liveDifference(from, to);
  QCOMPARE(difference.other, std::string());
  QCOMPARE(difference.changes.size(), std::size_t{3});
  Flight made = from;
  for (const Change& change : difference.changes) QVERIFY(!makeChange(made, change));
  QVERIFY(made == to);
  to.duration = 3;
  QCOMPARE(liveDifference(from, to).other, std::string("Duration"));
  to = from;
  to.environment.wind = StillAir{};
  difference = liveDifference(from, to);
  QCOMPARE(difference.other, std::string("Wind"));
  QVERIFY(difference.changes.empty());
}

QTEST_APPLESS_MAIN(TestChanges)
#include "test_changes.moc"
