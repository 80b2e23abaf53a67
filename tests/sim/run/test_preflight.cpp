// What can be known of a flight before it runs: poles beside the step, endurance, air resistance,
// figures of merit, rates, an inertia rounded.
#include <QTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/flight.h"
#include "sim/run/preflight.h"
#include "sim/run/step_stability.h"
#include "sim/run/vehicle_doubts.h"
#include "sim/sizing/performance.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

Flight& flightOf(Experiment& e) {
  return alternative<Flight>(e.setup);
}
RotorParameters& rotorOf(Experiment& e) {
  return std::get<EqualRotors>(flightOf(e).vehicle.rotors).rotor;
}
DirectMass& massOf(Experiment& e) {
  return std::get<DirectMass>(flightOf(e).vehicle.mass);
}

/// The problem at this path, or one without words.
Problem at(const std::vector<Problem>& problems, const std::string& path) {
  const auto found = std::ranges::find(problems, path, &Problem::path);
  return found == problems.end() ? Problem{} : *found;
}

bool says(const Problem& problem, const char* words) {
  return problem.message().find(words) != std::string::npos;
}

}  // namespace

class TestPreflight : public QObject {
  Q_OBJECT
 private slots:
  /// case 08 of the checks from outside: a square plate of 30 g and 75.7 mm, its moments rounded to
  /// three digits, is 0.35 % over the triangle inequality and flies; the Iris that is 21 % over
  /// does not.
  void roundedInertia() {
    Experiment e = shipped("f450-hover-and-steps");
    massOf(e).mass = 0.03;
    massOf(e).inertia = {1.43e-5, 1.43e-5, 2.87e-5, 0, 0, 0};
    flightOf(e).duration = 0.05;
    const auto problems = preflight(e);
    const Problem rounded = at(problems, "setup.vehicle.mass.inertia");
    QVERIFY(rounded.warning);
    QVERIFY2(says(rounded, "by 0.35 %"), rounded.message().c_str());
    QCOMPARE(std::ranges::count_if(problems, [](const Problem& p) { return says(p, "0.35 %"); }),
             std::ptrdiff_t{1});
    QCOMPARE(runToEnd(e)->state(), SimulationState::Finished);

    massOf(e).mass = 1.5;
    massOf(e).inertia = {0.0347563, 0.0458929, 0.0977, 0, 0, 0};
    const auto refused = schema::validate(schema::ref(e));
    const Problem iris = at(refused, "setup.vehicle.mass.inertia");
    QVERIFY(!iris.warning && says(iris, "no body has this inertia"));
    QVERIFY2(says(iris, "by 21 %"), iris.message().c_str());
    QVERIFY_THROWS_EXCEPTION(InputError, buildSimulation(e));
  }

  /// Poles that motors do not have: h |pole| against the limit of RK4, 2.785, and of Euler, 2.
  void poles_data() {
    QTest::addColumn<int>("change");
    QTest::addColumn<double>("pole");
    QTest::addColumn<QString>("named");
    // D/m = 1400 N s/m / 1.4 kg and c_q/I = 19 N m s/0.019 kg m^2, both 1000 1/s.
    QTest::addRow("drag") << 0 << 1000.0 << "the body's motion in the air";
    QTest::addRow("angular damping") << 1 << 1000.0 << "the body's rotation";
    // Inflow k_z w at a lever l: sum k_z w l^2/I, with w in hover and arms of 0.1651 m.
    QTest::addRow("rotor arm, tiny inertia") << 2 << 0.0 << "the body's rotation";
  }
  void poles() {
    QFETCH(int, change);
    QFETCH(double, pole);
    QFETCH(QString, named);
    Experiment e = shipped("f450-hover-and-steps");
    Flight& flight = flightOf(e);
    flight.vehicle.drag = {};
    std::get<PropellerCoefficients>(rotorOf(e).aerodynamics).inflow = {};
    if (change == 0) flight.vehicle.drag.linear = 1400;
    if (change == 1) flight.vehicle.drag.angular = Eigen::Vector3d::Constant(19);
    if (change == 2) {
      auto& propeller = std::get<PropellerCoefficients>(rotorOf(e).aerodynamics);
      propeller.inflow.inflow = 5e-3;
      massOf(e).inertia = {1e-4, 1e-4, 1.5e-4, 0, 0, 0};
      const double thrust = 1.4 * 9.80665 / 4, n2 = thrust / (propeller.thrustCoefficient * 1.225 *
                                                              std::pow(propeller.diameter, 4));
      const double speed = 2 * M_PI * std::sqrt(n2);
      pole = 4 * 5e-3 * speed * 0.1651 * 0.1651 / 1e-4;
    }
    for (const auto method : {ode::Method::ExponentialRk4, ode::Method::Rk4, ode::Method::Euler}) {
      flight.solver.method = method;
      const double limit = stabilityLimit(method) / pole;
      // The motors' own pole is faster than these where the method does not solve it.
      flight.solver.step = flight.tick =
          method == ode::Method::ExponentialRk4 ? 1.01 * limit : 1e-4;
      const bool beyond = flight.solver.step > limit;
      const Problem found = at(runWarnings(e), "setup.solver.step");
      QCOMPARE(!found.what.empty() && says(found, qPrintable(named)), beyond);
      if (!beyond) continue;
      QVERIFY2(says(found, qPrintable(QString::number(std::round(pole)))), found.message().c_str());
      flight.solver.step = flight.tick = 0.99 * limit;
      QVERIFY(at(runWarnings(e), "setup.solver.step").what.empty());
    }
  }

  /// A propeller's own pole: 2 k_m rho w/J at the highest speed the supply could give.
  void rotorInTheAir() {
    Experiment e = shipped("f450-hover-and-steps");
    rotorOf(e).inertia = 1e-7;
    const Problem found = at(runWarnings(e), "setup.solver.step");
    QVERIFY2(says(found, "the pole of a rotor in the air"), found.message().c_str());
    const auto& c = std::get<PropellerCoefficients>(rotorOf(e).aerodynamics);
    const double top = 11.1 * rotorOf(e).motor.speedConstant;
    const double torque =
        c.powerCoefficient * 1.225 * std::pow(c.diameter, 5) / (8 * M_PI * M_PI * M_PI);
    const auto expected = QString::number(std::round(2 * torque * top / 1e-7), 'f', 0);
    QVERIFY2(says(found, qPrintable(expected)), found.message().c_str());
  }

  void endurance() {
    Experiment e = shipped("f450-hover-and-steps");
    flightOf(e).vehicle.supply = BatteryParameters{};
    flightOf(e).duration = 60;
    QVERIFY(at(runWarnings(e), "setup.duration").what.empty());
    flightOf(e).duration = 3000;
    const Problem found = at(runWarnings(e), "setup.duration");
    QVERIFY2(found.warning && says(found, "3000 s is longer than the battery holds a hover"),
             found.message().c_str());
    // A supply that never empties, and inputs laid down in advance.
    flightOf(e).vehicle.supply = SupplyParameters{};
    QVERIFY(at(runWarnings(e), "setup.duration").what.empty());
  }

  /// One list: the sheet of the vehicle says it as the experiment does.
  void airResistanceNotDescribed() {
    Experiment e = shipped("f450-hover-and-steps");
    Flight& flight = flightOf(e);
    auto& inflow = std::get<PropellerCoefficients>(rotorOf(e).aerodynamics).inflow;
    flight.vehicle.drag = {};
    inflow = {};
    const Problem none = at(runWarnings(e), "setup.vehicle.drag");
    QVERIFY2(none.warning && says(none, "the resistance of the air is not described"),
             none.message().c_str());
    const FigureSheet sheet = performanceSheet(flight.vehicle, flight.environment);
    const auto told = [&](const FigureSheet& s) {
      return std::ranges::any_of(s.warnings, [](const Sentence& w) {
        return w.text().find("drag: the resistance of the air is not described") !=
               std::string::npos;
      });
    };
    QVERIFY(told(sheet));
    inflow.drag = 1e-5;
    QVERIFY(
        says(at(runWarnings(e), "setup.vehicle.drag"), "no loss of the rotors' thrust in climb"));
    inflow.inflow = 1e-4;
    QVERIFY(at(runWarnings(e), "setup.vehicle.drag").what.empty());
    QVERIFY(!told(performanceSheet(flight.vehicle, flight.environment)));
  }

  /// CT^1.5/(sqrt(2) CP) sqrt(8/pi)/2: the definition of the figure of merit in these coefficients.
  void meritAboveOne() {
    Experiment e = shipped("f450-hover-and-steps");
    auto& c = std::get<PropellerCoefficients>(rotorOf(e).aerodynamics);
    c.thrustCoefficient = 0.11;
    for (const double merit : {0.98, 1.02}) {
      c.powerCoefficient = std::pow(0.11, 1.5) * std::sqrt(2 / M_PI) / merit;
      const auto problems = runWarnings(e);
      QCOMPARE(std::ranges::any_of(
                   problems, [](const Problem& p) { return says(p, "figure of merit of 1.02"); }),
               merit > 1);
    }
  }

  /// Known before the run, and what the run is refused for.
  void ratesThatDoNotFit() {
    Experiment e = shipped("f450-hover-and-steps");
    alternative<ControlledInputs>(flightOf(e).control).motors.rate = 300;
    const Problem found = at(runWarnings(e), "setup.control.motors.rate");
    QVERIFY2(!found.warning && says(found, "does not fit the tick"), found.message().c_str());
    QVERIFY_THROWS_EXCEPTION(InputError, buildSimulation(e));
  }

  /// Neither air nor lift: a sentence each, from the list or from the build.
  void noAir() {
    Experiment e = shipped("f450-hover-and-steps");
    flightOf(e).environment.air = UniformAir{0};
    for (const auto start : {RotorStart::Hover, RotorStart::Stopped, RotorStart::Given}) {
      flightOf(e).start.rotors = start;
      runWarnings(e);
      try {
        buildSimulation(e);
        QFAIL("it was built");
      } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).contains("where there is no air"), error.what());
      }
    }
    // Without a controller it falls, and its rotors turn without a load.
    flightOf(e).control = VoltageInputs{};
    flightOf(e).duration = 1;
    const auto fell = runToEnd(e);
    QCOMPARE(fell->state(), SimulationState::Finished);
    const Recording& r = *fell->runs().front().recording;
    const double height = r.value(*r.find("position.z"), r.rows() - 1);
    QVERIFY(std::abs(height + 9.80665 / 2) < 0.05);
  }
};

QTEST_GUILESS_MAIN(TestPreflight)
#include "test_preflight.moc"
