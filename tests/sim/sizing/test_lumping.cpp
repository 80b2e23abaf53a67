// Lumped coefficients in place of the rotors of an experiment.
#include <QTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/document/flight.h"
#include "sim/document/propeller_bench.h"
#include "sim/document/thrust_stand.h"
#include "sim/sizing/lumping.h"
#include "sim/sizing/performance.h"

using namespace rotorbench;

namespace {

Experiment flightWith(RotorAerodynamics aerodynamics) {
  Experiment e;
  auto& rotors = std::get<EqualRotors>(alternative<Flight>(e.setup).vehicle.rotors);
  rotors.rotor.aerodynamics = std::move(aerodynamics);
  return e;
}

double figure(const Experiment& e, const char* key) {
  const auto& flight = alternative<Flight>(e.setup);
  return performanceSheet(flight.vehicle, flight.environment).at(key).value;
}

}  // namespace

class TestLumping : public QObject {
  Q_OBJECT
 private slots:
  void placesAreFound() {
    const auto one = rotorModelsIn(schema::ref(flightWith(BladeElementPropeller{})));
    QCOMPARE(one.size(), std::size_t{1});
    QCOMPARE(one.front().path, std::string("setup.vehicle.rotors.rotor.aerodynamics"));
    QVERIFY(rotorModelsIn(schema::ref(flightWith(RotorCoefficients{}))).empty());
    Experiment own;
    auto& vehicle = alternative<Flight>(own.setup).vehicle;
    IndividualRotors four;
    four.rotors.resize(4);
    four.rotors[2].aerodynamics = RotorCoefficients{};
    vehicle.rotors = four;
    const auto three = rotorModelsIn(schema::ref(own));
    QCOMPARE(three.size(), std::size_t{3});
    QCOMPARE(three.back().path, std::string("setup.vehicle.rotors.rotors[3].aerodynamics"));
    Experiment bench;
    bench.setup = PropellerBench{};
    QVERIFY(!rotorModelsIn(schema::ref(bench)).empty());
    QVERIFY(!lumpingRangeOf(bench, rotorModelsIn(schema::ref(bench)).front()));
  }

  /// Lumped about its hover a vehicle hovers as before: the same speed, power and throttle.
  void hoverStaysWhatItWas() {
    Experiment e = flightWith(BladeElementPropeller{});
    const auto rotor = rotorModelsIn(schema::ref(e)).front();
    const auto range = lumpingRangeOf(e, rotor);
    QVERIFY(range.has_value());
    QVERIFY(std::abs(range->speed / figure(e, "hover.speed") - 1) < 1e-9);
    const LumpedEquivalent lumped = lumpedEquivalent(rotor.model, *range);
    Experiment after = e;
    useLumped(schema::ref(after), rotor.path, lumped.coefficients);
    QVERIFY(rotorModelsIn(schema::ref(after)).empty());
    for (const char* key : {"hover.speed", "hover.throttle", "hover.power"})
      QVERIFY2(std::abs(figure(after, key) / figure(e, key) - 1) < 1e-6, key);
    const FigureSheet sheet = lumpingSheet(lumped, *range);
    QCOMPARE(sheet.at("lumped.thrust").value, lumped.coefficients.thrust);
    QCOMPARE(sheet.at("off.thrust").value, lumped.errors.thrust);
    QVERIFY_THROWS_EXCEPTION(InputError, useLumped(schema::ref(after), "setup.vehicle.drag", {}));
  }
};

QTEST_GUILESS_MAIN(TestLumping)
#include "test_lumping.moc"
