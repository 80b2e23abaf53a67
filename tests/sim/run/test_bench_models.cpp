// Every rotor model on the propeller bench: each gives what it is made of, keeps to what was
// measured, and stands beside a second one in the same run.
#include <QtTest>
#include <cmath>
#include <numbers>

#include "sim/document/experiment_file.h"
#include "sim/document/propeller_bench.h"
#include "sim/library/component_file.h"
#include "sim/run/simulation.h"
#include "sim/scene/scene_model.h"
#include "tests/sim/run/finished_run.h"
#include "tests/sim/run/quick_map.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

constexpr double kPi = std::numbers::pi;

Experiment experimentOf(const PropellerBench& bench) {
  Experiment experiment;
  experiment.setup = bench;
  return experiment;
}

double largest(const Recording& r, const std::string& channel) {
  double most = 0;
  for (std::size_t row = 0; row < r.rows(); ++row)
    most = std::max(most, std::abs(value(r, channel, row)));
  return most;
}

/// The largest difference of a channel between two runs of the same rows, over `scale`.
double difference(const Recording& a, const Recording& b, const std::string& channel,
                  double scale) {
  if (a.rows() != b.rows() || a.rows() < 2) qFatal("other rows");
  double most = 0;
  for (std::size_t row = 0; row < a.rows(); ++row)
    most = std::max(most, std::abs(value(a, channel, row) - value(b, channel, row)));
  return most / scale;
}

QStringList paths(const std::vector<Problem>& problems) {
  QStringList found;
  for (const Problem& p : problems) found << QString::fromStdString(p.path);
  found.sort();
  return found;
}

const MeasuredPropeller& shippedSlowFlyer() {
  static const Component component = loadComponent(
      std::filesystem::path(LIBRARY_DIR) / "measured-propellers" / "apc-slow-flyer-10-x-4-7.json");
  return *component.as<MeasuredPropeller>();
}

std::vector<CoefficientPoint> byAdvance(std::vector<CoefficientPoint> points) {
  std::ranges::sort(points, {}, &CoefficientPoint::advanceRatio);
  return points;
}

}  // namespace

class TestBenchModels : public QObject {
  Q_OBJECT
 private slots:
  /// The map stands for blade elements to 0.2 % of the static thrust and 1 % of the static torque,
  /// in every run.
  void mapIsBladeElements() {
    PropellerBench bench;
    bench.curves = {.airSpeed = 2,
                    .leastAdvanceRatio = -0.4,
                    .mostAdvanceRatio = 0.9,
                    .mostEdgewiseRatio = 0.2,
                    .points = 41};
    bench.speeds = {{0, 100}, {0.3, 800}};
    bench.stream = StreamProfile{{{0, 0}, {0.3, 5}}, Interpolation::Linear};
    bench.run = {.tick = 5e-3, .duration = 0.3};
    bench.second = quickMap();
    const auto simulation = finished(experimentOf(bench));
    const double thrust = figure(*simulation, "static_thrust");
    const double torque = figure(*simulation, "static_torque");
    QVERIFY(thrust > 1 && torque > 0.01);
    const auto both = [&](const std::string& name) {
      return std::pair<const Recording&, const Recording&>(
          run(*simulation, name + ", blade elements"), run(*simulation, name + ", propeller map"));
    };
    const auto [fast, fastMap] = both("Over speed");
    QVERIFY(difference(fast, fastMap, "over_speed.thrust", largest(fast, "over_speed.thrust")) <
            2e-3);
    QVERIFY(difference(fast, fastMap, "over_speed.torque", largest(fast, "over_speed.torque")) <
            1e-2);
    const auto [advance, advanceMap] = both("Over advance ratio");
    QVERIFY(difference(advance, advanceMap, "over_advance.thrust", thrust) < 2e-3);
    QVERIFY(difference(advance, advanceMap, "over_advance.torque", torque) < 1e-2);
    const auto [time, timeMap] = both("Run");
    QVERIFY(difference(time, timeMap, "thrust", largest(time, "thrust")) < 2e-3);
    QVERIFY(difference(time, timeMap, "torque", largest(time, "torque")) < 1e-2);
    // In-plane forces and moments come by the same signs; the coarse table holds them to a few per
    // cent.
    const auto [edge, edgeMap] = both("Edgewise");
    for (const char* channel : {"edgewise.thrust", "edgewise.drag", "edgewise.roll"})
      QVERIFY2(difference(edge, edgeMap, channel, largest(edge, channel)) < 0.05, channel);
  }

  void measuredGivesItsPointsBack_data() {
    QTest::addColumn<double>("speed");
    QTest::addRow("4014 rpm") << 420.3;
    QTest::addRow("6512 rpm") << 681.9;
  }
  /// Between two neighbouring points asked for, both ends are the points: UIUC volume 1,
  /// apcsf_10x4.7.
  void measuredGivesItsPointsBack() {
    QFETCH(double, speed);
    MeasuredPropeller propeller;
    std::vector<CoefficientPoint> points = byAdvance(propeller.points);
    std::erase_if(points, [&](const CoefficientPoint& p) { return p.speed != speed; });
    QVERIFY(points.size() >= 10);
    PropellerBench bench;
    bench.propeller = propeller;
    bench.run = {.tick = 0.01, .duration = 0.01};
    bench.curves.speed = speed;
    bench.curves.points = 2;
    for (std::size_t i = 1; i < points.size(); ++i) {
      bench.curves.leastAdvanceRatio = points[i - 1].advanceRatio;
      bench.curves.mostAdvanceRatio = points[i].advanceRatio;
      const auto simulation = finished(experimentOf(bench));
      const Recording& r = run(*simulation, "Over advance ratio");
      for (std::size_t row = 0; row < 2; ++row) {
        const CoefficientPoint& p = points[i - 1 + row];
        QCOMPARE(value(r, "over_advance.j", row), p.advanceRatio);
        QVERIFY(std::abs(value(r, "over_advance.ct", row) - p.thrustCoefficient) < 1e-12);
        QVERIFY(std::abs(value(r, "over_advance.cp", row) - p.powerCoefficient) < 1e-12);
      }
    }
  }

  /// The curves end where the measurement does, whatever was asked for; Problems and figures say
  /// where.
  void measuredKeepsToItsLimits() {
    PropellerBench bench;
    bench.propeller = MeasuredPropeller{};  // 420.3 and 681.9 rad/s, at the faster J = 0 to 0.755
    bench.speeds = {{0, 0}, {0.5, 900}};
    bench.run = {.tick = 0.01, .duration = 0.5};
    bench.curves.speed = 681.9;
    bench.curves.topSpeed = 900;
    bench.curves.leastAdvanceRatio = -0.3;
    bench.curves.mostAdvanceRatio = 1;
    QCOMPARE(paths(warningsOf(experimentOf(bench))),
             (QStringList{"setup.curves.leastAdvanceRatio", "setup.curves.mostAdvanceRatio",
                          "setup.curves.topSpeed", "setup.speeds[1].speed"}));
    const auto simulation = finished(experimentOf(bench));
    const Recording& advance = run(*simulation, "Over advance ratio");
    QCOMPARE(value(advance, "over_advance.j", 0), 0.0);
    QCOMPARE(value(advance, "over_advance.j", advance.rows() - 1), 0.755);
    const Recording& fast = run(*simulation, "Over speed");
    QVERIFY(std::abs(value(fast, "over_speed.speed", 0) - 420.3 / 1.02) < 1e-9);
    QVERIFY(std::abs(value(fast, "over_speed.speed", fast.rows() - 1) - 681.9 * 1.02) < 1e-9);
    QCOMPARE(figure(*simulation, "most_measured_advance_ratio"), 0.755);
    const Recording& time = run(*simulation, "Run");
    double beyond = 0;
    for (std::size_t row = 0; row < time.rows(); ++row) {
      const double w = value(time, "speed", row);
      const bool outside = w < 420.3 / 1.02 || w > 681.9 * 1.02;
      QCOMPARE(value(time, "beyond_measured", row), outside ? 1.0 : 0.0);
      QVERIFY(std::isfinite(value(time, "thrust", row)));
      beyond += outside;
    }
    QVERIFY(beyond > 10);
    QCOMPARE(figure(*simulation, "beyond_measured_share"), beyond / double(time.rows()));
  }

  /// In a stream the advance ratio falls with the speed: where it was not measured the curve over
  /// the speed has a gap.
  void measuredLeavesGaps() {
    PropellerBench bench;
    bench.propeller = MeasuredPropeller{};
    bench.curves.speed = 681.9;
    bench.curves.airSpeed = 14;  // J = 0.719 at 4815 rpm
    const auto simulation = finished(experimentOf(bench));
    const Recording& r = run(*simulation, "Over speed");
    int gaps = 0, known = 0;
    for (std::size_t row = 0; row < r.rows(); ++row) {
      const double j = 14 / (value(r, "over_speed.speed", row) / (2 * kPi) * 0.254);
      const bool finite = std::isfinite(value(r, "over_speed.thrust", row));
      if (j > 0.756) QVERIFY(!finite);
      if (j < 0.718) QVERIFY(finite);
      ++(finite ? known : gaps);
    }
    QVERIFY(gaps > 5 && known > 5);
  }

  void whatWasNotMeasuredIsRefused_data() {
    QTest::addColumn<double>("topSpeed");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    QTest::addColumn<QString>("path");
    QTest::addRow("only slower") << 300.0 << 0.0 << 0.7 << "setup.curves.topSpeed";
    QTest::addRow("only descent") << 600.0 << -0.5 << -0.1 << "setup.curves.mostAdvanceRatio";
    QTest::addRow("only faster air") << 600.0 << 0.8 << 1.0 << "setup.curves.mostAdvanceRatio";
  }
  void whatWasNotMeasuredIsRefused() {
    QFETCH(double, topSpeed);
    QFETCH(double, least);
    QFETCH(double, most);
    QFETCH(QString, path);
    PropellerBench bench;
    bench.second = MeasuredPropeller{};
    bench.curves.topSpeed = topSpeed;
    bench.curves.leastAdvanceRatio = least;
    bench.curves.mostAdvanceRatio = most;
    try {
      buildSimulation(experimentOf(bench));
      QFAIL("built");
    } catch (const InputError& error) {
      QCOMPARE(QString::fromStdString(error.problems().front().path), path);
    }
  }

  /// Points without a rest between them: nothing is known below the first of them.
  void continuationToRestIsNoMeasurement() {
    MeasuredPropeller propeller;
    propeller.points = {{500, 0.2, 0.1, 0.05}, {500, 0.4, 0.08, 0.045}, {500, 0.6, 0.04, 0.035}};
    const CoefficientTable::Limits limits = CoefficientTable(propeller).limits(500);
    QCOMPARE(limits.leastAdvance, 0.2);
    QCOMPARE(limits.mostAdvance, 0.6);
    PropellerBench bench;
    bench.propeller = propeller;
    bench.curves.speed = 500;
    const auto simulation = finished(experimentOf(bench));
    QCOMPARE(value(run(*simulation, "Over advance ratio"), "over_advance.j", 0), 0.2);
    QVERIFY(std::isnan(figure(*simulation, "static_thrust")));
    // Without speeds the points hold at every speed.
    for (CoefficientPoint& p : propeller.points) p.speed = 0;
    QVERIFY(std::isinf(CoefficientTable(propeller).limits(500).mostSpeed));
    QCOMPARE(CoefficientTable(propeller).limits(500).leastSpeed, 0.0);
  }

  /// A component of the library on the bench: tunnel runs at several speeds and a static test.
  void shippedComponentOnTheBench() {
    PropellerBench bench;
    bench.propeller = shippedSlowFlyer();
    bench.curves.speed = 4014 * kPi / 30;
    const auto simulation = finished(experimentOf(bench));
    const Recording& r = run(*simulation, "Over advance ratio");
    QVERIFY(r.rows() > 100);
    // UIUC kt0836: the thrust ends between J = 0.577 and 0.647.
    const double end = figure(*simulation, "zero_thrust_advance_ratio");
    QVERIFY2(end > 0.577 && end < 0.719, qPrintable(QString::number(end)));
    QVERIFY(figure(*simulation, "peak_efficiency") > 0.4);
    QVERIFY(figure(*simulation, "figure_of_merit") < 1);
  }

  /// T = CT rho n^2 D^4 and Q = CP rho n^2 D^5/(2 pi), at every J; k_eta w^2 and k_m w^2 less k_z w
  /// v.
  void lumpedAreTheirCoefficients() {
    PropellerBench bench;
    const PropellerCoefficients c;
    bench.propeller = c;
    RotorCoefficients k;
    k.inflow = {1.19e-4, 2.32e-4, 3.39e-3, 1e-6};
    bench.second = k;
    const auto simulation = finished(experimentOf(bench));
    const Recording& r = run(*simulation, "Over advance ratio, propeller coefficients");
    const Recording& s = run(*simulation, "Over advance ratio, lumped coefficients");
    const double w = bench.curves.speed;
    for (std::size_t row = 0; row < r.rows(); ++row) {
      QVERIFY(std::abs(value(r, "over_advance.ct", row) - c.thrustCoefficient) < 1e-12);
      QVERIFY(std::abs(value(r, "over_advance.cp", row) - c.powerCoefficient) < 1e-12);
      const double v = value(s, "over_advance.air_speed", row);
      const double thrust = k.thrust * w * w - k.inflow.inflow * w * v;
      QVERIFY(std::abs(value(s, "over_advance.thrust", row) - thrust) < 1e-9);
      QVERIFY(std::abs(value(s, "over_advance.torque", row) - k.torque * w * w) < 1e-12);
    }
    // In-plane drag k_d w v and translational lift k_h v^2.
    const Recording& edge = run(*simulation, "Edgewise, lumped coefficients");
    const std::size_t last = edge.rows() - 1;
    const double v = value(edge, "edgewise.air_speed", last);
    QVERIFY(std::abs(value(edge, "edgewise.drag", last) - k.inflow.drag * w * v) < 1e-9);
    QVERIFY(std::abs(value(edge, "edgewise.thrust", last) -
                     (k.thrust * w * w + k.inflow.translationalLift * v * v)) < 1e-9);
    // Flapping: k_flap w v about e2.
    QVERIFY(std::abs(value(edge, "edgewise.pitch", last) - k.inflow.flapping * w * v) < 1e-9);
    // Only the first has no inflow loss.
    QCOMPARE(paths(warningsOf(experimentOf(bench))), QStringList{"setup.propeller.inflow.inflow"});
  }

  void runsAreThoseOfTheModel_data() {
    QTest::addColumn<int>("model");
    QTest::addRow("blade elements") << 0;
    QTest::addRow("map") << 1;
    QTest::addRow("measured") << 2;
    QTest::addRow("propeller coefficients") << 3;
    QTest::addRow("lumped coefficients") << 4;
  }
  /// The same runs and channels for every model; what one has not it explains.
  void runsAreThoseOfTheModel() {
    QFETCH(int, model);
    PropellerBench bench;
    const BenchPropeller models[] = {BladeElementSpecimen{}, quickMap(), MeasuredPropeller{},
                                     PropellerCoefficients{}, RotorCoefficients{}};
    bench.propeller = models[model];
    const auto simulation = finished(experimentOf(bench));
    QStringList names;
    for (const RunOutput& r : simulation->runs()) {
      names << QString::fromStdString(r.name);
      QVERIFY2(r.recording->rows() > 10, r.name.c_str());
    }
    const bool blades = model == 0;
    QCOMPARE(names.contains("Along the blade"), blades);
    QCOMPARE(names.size(), blades ? 5 : 4);
    const Recording& time = run(*simulation, "Run");
    QCOMPARE(time.find("vortex_ring_share").has_value(), blades);
    QCOMPARE(time.find("beyond_measured").has_value(), model == 2);
    std::vector<AbsentChannels> absent;
    for (const RunOutput& r : simulation->runs())
      absent.insert(absent.end(), r.absent.begin(), r.absent.end());
    const auto explains = [&](const std::string& beginning) {
      return std::ranges::any_of(absent, [&](const AbsentChannels& a) {
        return a.beginning == beginning && !a.reason.empty();
      });
    };
    QCOMPARE(explains("along_blade."), !blades);
    QCOMPARE(explains("vortex_ring_share"), !blades);
    QCOMPARE(explains("beyond_measured"), model != 2);
    QVERIFY(figure(*simulation, "static_thrust") > 0);
    // The stand is drawn, with the propeller's own size.
    const auto scene = sceneModel(experimentOf(bench));
    QVERIFY(scene && scene->onStand && scene->rotors.size() == 1);
    QCOMPARE(scene->rotors.front().radius, rotorRadius(aerodynamicsOf(bench.propeller)));
    QVERIFY(!scene->rotors.front().stations.empty());
  }

  void twoOfAModelAreToldApart() {
    PropellerBench bench;
    BladeElementSpecimen small;
    small.geometry.diameter = 0.2;
    bench.second = small;
    const auto simulation = finished(experimentOf(bench));
    QCOMPARE(simulation->runs().size(), std::size_t{10});
    const MetricTable table = simulation->metrics();
    QCOMPARE(table.size(), std::size_t{2});
    QCOMPARE(QString::fromStdString(table[0].run), QString("Run, first"));
    QCOMPARE(QString::fromStdString(table[1].run), QString("Run, second"));
    QVERIFY(figure(*simulation, "static_thrust", 1) < 0.6 * figure(*simulation, "static_thrust"));
    // The first is as it is alone.
    bench.second = NoPropeller{};
    const auto alone = finished(experimentOf(bench));
    QCOMPARE(figure(*alone, "peak_efficiency"), figure(*simulation, "peak_efficiency"));
  }

  /// Documents from before there was a choice of models.
  void oldDocumentsLoad() {
    const Experiment old = readExperiment(
        R"({"rotorbench": 1, "setup": {"type": "propeller-bench",
            "propeller": {"type": "blade-element", "geometry": {"diameter": "9 in"},
                          "settings": {"elements": 30}}}})",
        "old.json");
    const auto& bench = alternative<PropellerBench>(old.setup);
    QCOMPARE(std::get<BladeElementSpecimen>(bench.propeller).geometry.diameter, 0.2286);
    QCOMPARE(std::get<BladeElementSpecimen>(bench.propeller).settings.elements, 30);
    QVERIFY(std::holds_alternative<NoPropeller>(bench.second));
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
    bench.propeller = quickMap();
    bench.second = MeasuredPropeller{};
    bench.airDensity = density;
    bench.speeds = {{0, speed}};
    bench.stream = SteadyStream{stream};
    bench.run = {.tick = 0.01, .duration = 0.1};
    const auto simulation = finished(experimentOf(bench));
    for (const RunOutput& r : simulation->runs())
      for (std::size_t c = 0; c < r.recording->channels().size(); ++c)
        for (std::size_t row = 0; row < r.recording->rows(); ++row)
          QVERIFY2(std::isfinite(r.recording->value(c, row)),
                   r.recording->channels()[c].name.c_str());
  }
};

QTEST_APPLESS_MAIN(TestBenchModels)
#include "test_bench_models.moc"
