// The propeller bench: its run and its curves against the propeller asked directly, sums, limits,
// odd states.
#include <QtTest>
#include <cmath>
#include <numbers>

#include "sim/document/experiment_file.h"
#include "sim/document/propeller_bench.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/finished_run.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

Experiment experimentOf(const PropellerBench& bench) {
  Experiment experiment;
  experiment.setup = bench;
  return experiment;
}

BladeElementRotor rotorOf(const PropellerBench& bench) {
  const auto& specimen = std::get<BladeElementSpecimen>(bench.propeller);
  return BladeElementRotor(specimen.geometry, specimen.settings);
}

bool near(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

}  // namespace

class TestPropellerBench : public QObject {
  Q_OBJECT
 private slots:
  /// Quasi-steady: at every instant the loads of the speed and air speed laid down for it.
  void followsTheProfiles() {
    PropellerBench bench;
    bench.speeds = {{0, 100}, {0.2, 700}, {0.4, 300}};
    bench.stream = StreamProfile{{{0, 0}, {0.3, 6}}, Interpolation::Linear};
    bench.run = {.tick = 5e-3, .duration = 0.5};
    const auto simulation = finished(experimentOf(bench));
    const Recording& r = run(*simulation, "Run");
    const BladeElementRotor rotor = rotorOf(bench);
    QCOMPARE(value(r, "time", r.rows() - 1), 0.5);
    for (std::size_t row = 0; row < r.rows(); ++row) {
      const double t = value(r, "time", row);
      const double w = t < 0.2 ? 100 + 3000 * t : std::max(300.0, 700 - 2000 * (t - 0.2));
      const double v = std::min(6.0, 20 * t);
      QVERIFY(near(value(r, "speed", row), w, 1e-12));
      QVERIFY(std::abs(value(r, "air_speed", row) - v) < 1e-12);
      const AxialLoad load = rotor.axial(w, v, {});
      QVERIFY(near(value(r, "thrust", row), load.thrust, 1e-6));
      QVERIFY(near(value(r, "torque", row), load.torque, 1e-6));
      QVERIFY(near(value(r, "power", row), load.torque * w, 1e-6));
    }
  }

  void heldRowsStep() {
    PropellerBench bench;
    bench.speeds = {{0, 200}, {0.1, 400}};
    bench.interpolation = Interpolation::Hold;
    bench.run = {.tick = 0.01, .duration = 0.2};
    const auto simulation = finished(experimentOf(bench));
    const Recording& r = run(*simulation, "Run");
    QCOMPARE(value(r, "speed", 9), 200.0);
    QCOMPARE(value(r, "speed", 11), 400.0);
  }

  /// Dimensions: T = CT rho n^2 D^4, P = CP rho n^3 D^5, efficiency J CT/CP; and what the propeller
  /// says itself.
  void curvesAreThePropellers() {
    PropellerBench bench;
    bench.curves.leastAdvanceRatio = -0.5;
    bench.curves.points = 27;
    const auto simulation = finished(experimentOf(bench));
    const Recording& r = run(*simulation, "Over advance ratio");
    QCOMPARE(r.rows(), std::size_t{27});
    const double n = bench.curves.speed / (2 * std::numbers::pi), d = 0.254;
    const BladeElementRotor rotor = rotorOf(bench);
    for (std::size_t row = 0; row < r.rows(); ++row) {
      const auto at = [&](const char* name) {
        return value(r, std::string("over_advance.") + name, row);
      };
      const AxialLoad load = rotor.axial(bench.curves.speed, at("air_speed"), {});
      QVERIFY(std::abs(at("air_speed") - at("j") * n * d) < 1e-9);
      QVERIFY(near(at("thrust"), load.thrust, 1e-9));
      QVERIFY(near(at("ct") * 1.225 * n * n * std::pow(d, 4), load.thrust, 1e-9));
      QVERIFY(near(at("cp") * 1.225 * std::pow(n, 3) * std::pow(d, 5),
                   load.torque * bench.curves.speed, 1e-9));
      QVERIFY(at("efficiency") >= 0 && at("efficiency") < 1);
      if (at("efficiency") > 0)
        QVERIFY(near(at("efficiency"), at("j") * at("ct") / at("cp"), 1e-9));
    }
    const Recording& speed = run(*simulation, "Over speed");
    const std::size_t last = speed.rows() - 1;
    QCOMPARE(value(speed, "over_speed.speed", last), bench.curves.topSpeed);
    QVERIFY(near(value(speed, "over_speed.thrust", last),
                 rotor.axial(bench.curves.topSpeed, 0, {}).thrust, 1e-9));
    QCOMPARE(value(speed, "over_speed.thrust", 0), 0.0);
  }

  /// The annuli add up to the whole; angle of attack and inflow angle to the pitch of the section.
  void alongTheBladeAddsUp() {
    PropellerBench bench;
    bench.curves.airSpeed = 3;
    const auto simulation = finished(experimentOf(bench));
    const Recording& r = run(*simulation, "Along the blade");
    QCOMPARE(r.rows(), std::size_t{24});
    const double width = 0.127 * (1 - 0.15) / 24;
    double thrust = 0, torque = 0, radius = 0;
    for (std::size_t row = 0; row < r.rows(); ++row) {
      thrust += value(r, "along_blade.dt_dr", row) * width;
      torque += value(r, "along_blade.dq_dr", row) * width;
      QVERIFY(value(r, "along_blade.radius", row) > radius);
      radius = value(r, "along_blade.radius", row);
      QVERIFY(near(value(r, "along_blade.twist", row),
                   value(r, "along_blade.alpha", row) + value(r, "along_blade.phi", row), 1e-12));
      QVERIFY(value(r, "along_blade.reynolds", row) > 1000);
    }
    QVERIFY(near(thrust, figure(*simulation, "chosen_thrust"), 1e-9));
    QVERIFY(near(torque, figure(*simulation, "chosen_torque"), 1e-9));
    QVERIFY(near(thrust, rotorOf(bench).axial(bench.curves.speed, 3, {}).thrust, 1e-9));
  }

  /// Without an edgewise stream it is the axial state; with it the thrust grows, drag acts against
  /// the motion.
  void edgewiseBeginsAxial() {
    PropellerBench bench;
    const auto simulation = finished(experimentOf(bench));
    const Recording& r = run(*simulation, "Edgewise");
    const AxialLoad axial = rotorOf(bench).axial(bench.curves.speed, 0, {});
    QVERIFY(near(value(r, "edgewise.thrust", 0), axial.thrust, 2e-3));
    QVERIFY(near(value(r, "edgewise.torque", 0), axial.torque, 2e-3));
    QVERIFY(std::abs(value(r, "edgewise.drag", 0)) < 1e-9);
    QVERIFY(std::abs(value(r, "edgewise.roll", 0)) < 1e-9);
    const std::size_t last = r.rows() - 1;
    QVERIFY(near(value(r, "edgewise.air_speed", last), 0.3 * bench.curves.speed * 0.127, 1e-12));
    QVERIFY(value(r, "edgewise.thrust", last) > 1.2 * axial.thrust);
    QVERIFY(value(r, "edgewise.drag", last) > 0);
    // The advancing side, at -e2, lifts more.
    QVERIFY(value(r, "edgewise.roll", last) < 0);
  }

  /// Glauert: no hover takes less than the ideal power; the peak and the end of the thrust are
  /// where the curve has them.
  void figures() {
    PropellerBench bench;
    bench.curves.leastAdvanceRatio = -0.6;
    bench.curves.points = 281;
    const auto simulation = finished(experimentOf(bench));
    const double merit = figure(*simulation, "figure_of_merit");
    QVERIFY2(merit > 0.5 && merit < 1, qPrintable(QString::number(merit)));
    const BladeElementRotor rotor = rotorOf(bench);
    const double w = bench.curves.speed, perRatio = 0.254 * w / (2 * std::numbers::pi);
    const double end = figure(*simulation, "zero_thrust_advance_ratio");
    const double nearby = rotor.axial(w, end * perRatio, {}).thrust;
    QVERIFY(std::abs(nearby) < 1e-4 * figure(*simulation, "static_thrust"));
    const double peak = figure(*simulation, "peak_efficiency_advance_ratio");
    const auto efficiency = [&](double j) {
      const AxialLoad load = rotor.axial(w, j * perRatio, {});
      return load.thrust * j * perRatio / (load.torque * w);
    };
    QVERIFY(std::abs(efficiency(peak) - figure(*simulation, "peak_efficiency")) < 1e-4);
    QVERIFY(efficiency(peak) > efficiency(peak - 0.02) &&
            efficiency(peak) > efficiency(peak + 0.02));
    QVERIFY(figure(*simulation, "vortex_ring_share") > 0.9);
    bench.curves.leastAdvanceRatio = 0;
    bench.curves.mostAdvanceRatio = 0.2;
    const auto cut = finished(experimentOf(bench));
    QVERIFY(std::isnan(figure(*cut, "zero_thrust_advance_ratio")));
    QVERIFY(std::isnan(figure(*cut, "peak_efficiency")));
    QCOMPARE(figure(*cut, "vortex_ring_share"), 0.0);
  }

  void oddStatesGiveNumbers_data() {
    QTest::addColumn<double>("density");
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("stream");
    QTest::addRow("no air") << 0.0 << 500.0 << 5.0;
    QTest::addRow("backwards") << 1.2 << -500.0 << 5.0;
    QTest::addRow("standing in the wind") << 1.2 << 0.0 << 10.0;
    QTest::addRow("fast descent") << 1.2 << 300.0 << -40.0;
    QTest::addRow("nothing at all") << 0.0 << 0.0 << 0.0;
  }
  void oddStatesGiveNumbers() {
    QFETCH(double, density);
    QFETCH(double, speed);
    QFETCH(double, stream);
    PropellerBench bench;
    bench.airDensity = density;
    bench.speeds = {{0, speed}};
    bench.stream = SteadyStream{stream};
    bench.curves.airSpeed = stream;
    bench.curves.leastAdvanceRatio = -2;
    bench.curves.mostAdvanceRatio = 2;
    bench.run = {.tick = 0.01, .duration = 0.1};
    const auto simulation = finished(experimentOf(bench));
    for (const RunOutput& r : simulation->runs()) {
      QVERIFY2(r.recording->rows() > 1, r.name.c_str());
      for (std::size_t c = 0; c < r.recording->channels().size(); ++c)
        for (std::size_t row = 0; row < r.recording->rows(); ++row)
          QVERIFY2(std::isfinite(r.recording->value(c, row)),
                   r.recording->channels()[c].name.c_str());
    }
  }

  /// However the work is sliced the rows are the same; stopped early, they are the first of them.
  void slicesAndStop() {
    PropellerBench bench;
    bench.run = {.tick = 0.01, .duration = 1};
    const auto whole = finished(experimentOf(bench));
    const auto part = buildSimulation(experimentOf(bench));
    for (int k = 0; k < 50; ++k) QCOMPARE(part->advance(1), SimulationState::Running);
    QVERIFY(std::abs(part->progress().fraction - 0.5) < 1e-12);
    part->stop();
    for (std::size_t i = 0; i < whole->runs().size(); ++i) {
      const Recording &a = *whole->runs()[i].recording, &b = *part->runs()[i].recording;
      QVERIFY(b.finished());
      QVERIFY2(b.rows() < a.rows() && b.rows() >= a.rows() / 3, whole->runs()[i].name.c_str());
      for (std::size_t c = 0; c < a.channels().size(); ++c)
        for (std::size_t row = 0; row < b.rows(); ++row) QCOMPARE(b.value(c, row), a.value(c, row));
    }
    QVERIFY(!part->metrics().front().metrics.empty());
  }

  void contradictionsAreRefused_data() {
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("path");
    QTest::addRow("times") << R"("speeds": [{"time": 1, "speed": 0}, {"time": 1, "speed": 1}])"
                           << "setup.speeds[1].time";
    QTest::addRow("air times")
        << R"("stream": {"type": "profile", "rows": [{"time": 1, "speed": 0}, {"time": 0, "speed": 1}]})"
        << "setup.stream.rows[1].time";
    QTest::addRow("advance ratios")
        << R"("curves": {"leastAdvanceRatio": 0.5, "mostAdvanceRatio": 0.5})"
        << "setup.curves.mostAdvanceRatio";
    QTest::addRow("tick") << R"("run": {"tick": 1, "duration": 0.5})"
                          << "setup.run.tick";
    QTest::addRow("no stations")
        << R"("propeller": {"type": "blade-element", "geometry": {"stations": []}})"
        << "setup.propeller.geometry.stations";
    QTest::addRow("no speeds") << R"("speeds": [])"
                               << "setup.speeds";
  }
  void contradictionsAreRefused() {
    QFETCH(QString, json);
    QFETCH(QString, path);
    const QString text = R"({"rotorbench": 1, "setup": {"type": "propeller-bench", )" + json + "}}";
    try {
      readExperiment(text.toStdString(), "x.json");
      QFAIL("accepted");
    } catch (const InputError& error) {
      QCOMPARE(QString::fromStdString(error.problems().front().path), path);
    }
  }
};

QTEST_APPLESS_MAIN(TestPropellerBench)
#include "test_propeller_bench.moc"
