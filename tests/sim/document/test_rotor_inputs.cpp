// As many inputs and rotors as the layout has: said of a file, followed by an edit.
#include <QTest>

#include "sim/core/schema_tree.h"
#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/document/kinds.h"

using namespace rotorbench;

namespace {

std::string flight(const std::string& layout, const std::string& control) {
  return R"({"rotorbench": 1, "setup": {"type": "flight", "vehicle": {"layout": )" + layout +
         R"(}, "control": )" + control + "}}";
}

const std::string kHexa = R"({"type": "cross", "count": "hexa"})";

std::string speeds(const std::string& values) {
  return R"({"type": "rotor-speeds", "source": {"type": "constant", "speeds": )" + values + "}}";
}

const Flight& flightOf(const Experiment& e) {
  return alternative<Flight>(e.setup);
}

/// What an edit by hand does.
void letFollow(Experiment& e) {
  for (const auto& loose : schema::looseFollowers(schema::ref(e)))
    loose.follower->follow(loose.owner.object);
}

}  // namespace

class TestRotorInputs : public QObject {
  Q_OBJECT
 private slots:
  void oneValueEach() {
    const Experiment e = readExperiment(flight(kHexa, speeds("[1, 2, 3, 4, 5, 6]")), "test");
    const auto& inputs = std::get<SpeedInputs>(flightOf(e).control);
    const auto& values = std::get<ConstantInputs<RotorSpeedQuantity>>(inputs.source).values;
    QCOMPARE(values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
    QVERIFY(readExperiment(writeExperiment(e), "again") == e);
  }

  void aFileIsNotGuessed_data() {
    QTest::addColumn<std::string>("text");
    QTest::addColumn<std::string>("path");
    QTest::addColumn<std::string>("allowed");
    QTest::addRow("four for six") << flight(kHexa, speeds("[1, 2, 3, 4]"))
                                  << std::string("setup.control.source.speeds")
                                  << std::string("6, one for each rotor of the layout");
    QTest::addRow("too few for any")
        << flight(kHexa, speeds("[1, 2]")) << std::string("setup.control.source.speeds")
        << std::string("must be a list of 4 to 8 numbers");
    QTest::addRow("a row of a table")
        << flight(kHexa, R"({"type": "motor-voltages", "source": {"type": "table", "rows": [
               {"time": 0, "voltages": [1, 2, 3, 4, 5, 6]},
               {"time": 1, "voltages": [1, 2, 3, 4]}]}})")
        << std::string("setup.control.source.rows[1].voltages")
        << std::string("6, one for each rotor of the layout");
  }
  void aFileIsNotGuessed() {
    QFETCH(std::string, text);
    QFETCH(std::string, path);
    QFETCH(std::string, allowed);
    try {
      readExperiment(text, "test");
      QFAIL("was taken");
    } catch (const InputError& error) {
      QCOMPARE(error.problems().front().path, path);
      QCOMPARE(error.problems().front().allowed, allowed);
    }
  }

  void anEditIsFollowed() {
    Experiment e = readExperiment(flight(R"({"type": "plus"})", speeds("[1, 2, 3, 4]")), "test");
    QVERIFY(schema::looseFollowers(schema::ref(e)).empty());
    schema::set(schema::ref(e), "setup.vehicle.layout.count", schema::Value(std::string("octo")));
    letFollow(e);
    QVERIFY(schema::validate(schema::ref(std::as_const(e))).empty());
    const auto values = std::get<std::vector<double>>(
        schema::get(schema::ref(std::as_const(e)), "setup.control.source.speeds"));
    QCOMPARE(values, (std::vector<double>{1, 2, 3, 4, 4, 4, 4, 4}));
    schema::set(schema::ref(e), "setup.vehicle.layout.count", schema::Value(std::string("quad")));
    letFollow(e);
    QVERIFY(schema::validate(schema::ref(std::as_const(e))).empty());
  }

  void rotorsOfTheirOwnFollow() {
    Experiment e = readExperiment(flight(R"({"type": "plus"})", speeds("[1, 2, 3, 4]")), "test");
    schema::set(schema::ref(e), "setup.vehicle.rotors.type",
                schema::Value(std::string("individual")));
    schema::set(schema::ref(e), "setup.vehicle.rotors.rotors[3].mass", schema::Value(0.25));
    schema::set(schema::ref(e), "setup.vehicle.layout.count", schema::Value(std::string("hexa")));
    letFollow(e);
    const auto& own = std::get<IndividualRotors>(flightOf(e).vehicle.rotors).rotors;
    QCOMPARE(own.size(), std::size_t{6});
    QCOMPARE(own[5].mass, 0.25);
    QVERIFY(schema::validate(schema::ref(std::as_const(e))).empty());
  }

  /// A component is named by its number; beyond the last there is none.
  void componentsAreNamed() {
    Experiment e = readExperiment(flight(kHexa, speeds("[1, 2, 3, 4, 5, 6]")), "test");
    schema::setFromText(schema::ref(e), "setup.control.source.speeds.6", "100 rpm");
    const auto values = std::get<std::vector<double>>(
        schema::get(schema::ref(std::as_const(e)), "setup.control.source.speeds"));
    QVERIFY(std::abs(values[5] - 10.471975511966) < 1e-9);
    QVERIFY_THROWS_EXCEPTION(
        InputError, schema::setFromText(schema::ref(e), "setup.control.source.speeds.7", "1"));
  }

  void schemaTellsTheLengths() {
    const std::string text = experimentJsonSchema();
    QVERIFY(text.find("\"minItems\": 4") != std::string::npos);
    QVERIFY(text.find("\"hexa\"") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TestRotorInputs)
#include "test_rotor_inputs.moc"
