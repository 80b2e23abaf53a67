// Fits to real logs: what they predict of rows they have not seen, and a twist offset found in
// another way.
#include <QTest>
#include <cmath>
#include <numbers>

#include "sim/fitting/motor_fit.h"
#include "sim/fitting/propeller_fit.h"
#include "sim/logs/csv_import.h"

using namespace rotorbench;

namespace {

constexpr double kRpm = std::numbers::pi / 30;

MeasuredTable read(const char* name) {
  const TextLines lines = TextLines::fromFile(std::string(TEST_DATA_DIR "/measurement/") + name);
  return importTable(lines, guessSettings(lines)).table;
}

MeasuredTable rowsOf(const MeasuredTable& table, std::size_t first, std::size_t end,
                     std::size_t step) {
  MeasuredTable some{table.source, table.channels, {}};
  for (const auto& column : table.columns) {
    auto& to = some.columns.emplace_back();
    for (std::size_t r = first; r < end; r += step) to.push_back(column[r]);
  }
  return some;
}

}  // namespace

class TestFitsReal : public QObject {
  Q_OBJECT
 private slots:
  void everySecondStepPredictsTheOthers();
  void sunnySky();
};

/// T-Motor F40 Pro III on an AutoQuad ESC32, 5 % duty steps: constants fitted to every second step
/// predict the speed of the others within 3 % and the current within 6 % (of full scale).
void TestFitsReal::everySecondStepPredictsTheOthers() {
  // Two motors in the file; rows come sorted by throttle, one of each motor in turn. The last row
  // of the F60 is below its current limit.
  const MeasuredTable both = read("autoquad_steady_steps.csv");
  const MeasuredTable f40 = rowsOf(both, 1, both.rows(), 2);
  QCOMPARE(f40.rows(), std::size_t{19});
  MotorFitSetup setup;
  setup.start = djiE305();
  setup.start.speedConstant = 1600 * kRpm;
  setup.start.resistance = 0.06;
  setup.torqueCoefficient = 1e-7;
  const FitResult fit = solveLeastSquares(motorFitProblem(rowsOf(f40, 0, 19, 2), setup));
  QVERIFY2(fit.usable(), fit.sentence.c_str());
  for (const FittedParameter& p : fit.parameters)
    qInfo("%s %.5g +- %.2g", p.parameter.label.c_str(), p.value, p.halfWidth.value_or(0));
  const MeasuredTable others = rowsOf(f40, 1, 19, 2);
  MotorFitSetup found = setup;
  const FittedMotor motor = motorFrom(fit, setup);
  found.start = motor.motor;
  found.torqueCoefficient = motor.torqueCoefficient;
  const FitProblem unseen = motorFitProblem(others, found);
  std::vector<double> predicted(unseen.points.size()), p;
  for (const FitParameter& parameter : unseen.parameters) p.push_back(parameter.start);
  QVERIFY(unseen.predict(p, predicted));
  double most[2] = {};
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const FitPoint& point = unseen.points[i];
    most[point.output] = std::max(most[point.output], std::abs(predicted[i] - point.measured) /
                                                          unseen.outputs[point.output].scale);
  }
  qInfo("unseen steps: speed within %.2f %%, current within %.2f %% of the largest", 100 * most[0],
        100 * most[1]);
  QVERIFY(most[0] < 0.03);
  QVERIFY(most[1] < 0.06);
}

/// SunnySky X2216 1100 KV with a 10x4.7: the speed controller has a curve of its own, so that the
/// duty is known at full throttle only. The authors give 1100 rpm/V, 148 mOhm for the whole
/// circuit, 0.8 A without load.
void TestFitsReal::sunnySky() {
  MotorFitSetup setup;
  setup.start = djiE305();
  setup.start.speedConstant = 1000 * kRpm;
  setup.start.resistance = 0.1;
  setup.start.noLoadCurrent = 0.8;
  setup.fitNoLoadCurrent = false;
  setup.duty = DutyFrom::FullThrottle;
  setup.torqueCoefficient = 1e-7;
  const FitResult fit = solveLeastSquares(motorFitProblem(read("x2216_10x4.7.csv"), setup));
  QVERIFY2(fit.usable(), fit.sentence.c_str());
  for (const FittedParameter& p : fit.parameters)
    qInfo("%s %.5g +- %.2g %s", p.parameter.label.c_str(), p.value, p.halfWidth.value_or(0),
          p.remark.c_str());
  for (const FittedOutput& o : fit.outputs)
    qInfo("%s: %zu points, RMSE %.4g -> %.4g, R2 %.4f", o.output.label.c_str(), o.count,
          o.rmseBefore, o.rmseAfter, o.rSquared);
  QVERIFY(std::abs(fit.find("speedConstant")->value / (1100 * kRpm) - 1) < 0.1);
  QVERIFY(std::abs(fit.find("resistance")->value / 0.148 - 1) < 0.35);
}

QTEST_APPLESS_MAIN(TestFitsReal)
#include "test_fits_real.moc"
