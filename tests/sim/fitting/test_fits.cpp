// Fits to tables whose truth is known: made by the models themselves, with noise of fixed seeds.
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/core/error.h"
#include "sim/fitting/motor_fit.h"
#include "sim/fitting/propeller_fit.h"
#include "sim/fitting/provenance.h"
#include "sim/fitting/rotor_fit.h"

using namespace rotorbench;

namespace {

constexpr double kRpm = std::numbers::pi / 30;
constexpr double kLoad = 2.2e-7;  // N m s^2

MotorParameters truth() {
  MotorParameters m = djiE305();
  m.speedConstant = 920 * kRpm;
  m.resistance = 0.13;
  m.noLoadCurrent = 0.6;
  m.viscousShare = 0.4;
  return m;
}

/// Steady points over the throttle, the speed by Newton's method on the equations of motor_fit.h.
MeasuredTable stand(double noise, unsigned seed, double supply = 15) {
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0, 1);
  MeasuredTable table;
  table.source = "stand";
  table.channels = {{"throttle", "1", {}},
                    {"motor.speed", "rad/s", {}},
                    {"supply.voltage", "V", {}},
                    {"supply.current", "A", {}},
                    {"motor.torque", "N*m", {}}};
  table.columns.resize(5);
  const MotorConstants m = buildMotor(truth());
  for (int step = 10; step <= 100; step += 3) {
    const double d = step / 100.0;
    double w = 0.5 * d * supply / m.torqueConstant;
    for (int i = 0; i < 60; ++i) {
      const double load = m.dryFriction + m.viscousFriction * w + kLoad * w * w;
      const double f = m.resistance * load / m.torqueConstant + m.torqueConstant * w - d * supply;
      const double slope =
          m.resistance * (m.viscousFriction + 2 * kLoad * w) / m.torqueConstant + m.torqueConstant;
      w -= f / slope;
    }
    const double i = (m.dryFriction + m.viscousFriction * w + kLoad * w * w) / m.torqueConstant;
    table.columns[0].push_back(d);
    table.columns[1].push_back(w + noise * 2 * scatter(random));
    table.columns[2].push_back(supply);
    table.columns[3].push_back(d * i + noise * 0.03 * scatter(random));
    table.columns[4].push_back(kLoad * w * w);
  }
  return table;
}

/// As above with a speed controller that lets no more than `limit` through the motor: there K i_max
/// = friction + k_m w^2, and the supply gives the power of the motor.
MeasuredTable limitedStand(double noise, unsigned seed, double limit, double supply = 15) {
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0, 1);
  MeasuredTable table = stand(0, 0, supply);
  table.channels.push_back({"motor.current", "A", {}});
  table.columns.emplace_back();
  const MotorConstants m = buildMotor(truth());
  const double b = m.viscousFriction, c = m.dryFriction - m.torqueConstant * limit;
  const double most = (-b + std::sqrt(b * b - 4 * kLoad * c)) / (2 * kLoad);
  for (std::size_t r = 0; r < table.rows(); ++r) {
    double &speed = table.columns[1][r], &current = table.columns[3][r];
    double motor = current / table.columns[0][r];
    if (speed > most) {
      speed = most, motor = limit;
      current = (m.resistance * limit + m.torqueConstant * most) * limit / supply;
    }
    speed += noise * 2 * scatter(random);
    current += noise * 0.03 * scatter(random);
    table.columns[5].push_back(motor);
  }
  return table;
}

MotorFitSetup setupFor(ShaftTorque torque) {
  MotorFitSetup setup;
  setup.start = djiE305();
  setup.torque = torque;
  setup.fitViscousShare = true;
  setup.torqueCoefficient = 1e-7;
  return setup;
}

}  // namespace

class TestFits : public QObject {
  Q_OBJECT
 private slots:
  void motorWithoutNoise_data();
  void motorWithoutNoise();
  void motorIntervalsCoverTheTruth();
  void limitedRowsAreLeftOut_data();
  void limitedRowsAreLeftOut();
  void motorByPower();
  void saysWhatIsMissing();
  void escResistanceIsTakenOff();
  void rotor();
  void propeller_data();
  void propeller();
};

void TestFits::motorWithoutNoise_data() {
  QTest::addColumn<ShaftTorque>("torque");
  QTest::addRow("measured torque") << ShaftTorque::Measured;
  QTest::addRow("propeller") << ShaftTorque::Propeller;
}

void TestFits::motorWithoutNoise() {
  QFETCH(ShaftTorque, torque);
  const MotorFitSetup setup = setupFor(torque);
  const FitResult result = solveLeastSquares(motorFitProblem(stand(0, 0), setup));
  QVERIFY2(result.usable(), result.sentence.c_str());
  const FittedMotor fitted = motorFrom(result, setup);
  const MotorParameters expected = truth();
  QVERIFY(std::abs(fitted.motor.speedConstant / expected.speedConstant - 1) < 1e-4);
  QVERIFY(std::abs(fitted.motor.resistance / expected.resistance - 1) < 1e-3);
  QVERIFY(std::abs(fitted.motor.noLoadCurrent / expected.noLoadCurrent - 1) < 1e-2);
  QVERIFY(std::abs(fitted.motor.viscousShare - expected.viscousShare) < 0.02);
  if (torque == ShaftTorque::Propeller)
    QVERIFY(std::abs(fitted.torqueCoefficient / kLoad - 1) < 1e-3);
  QVERIFY(result.outputs[0].rmseAfter < 1e-2 * result.outputs[0].rmseBefore);
}

/// Speed +-2 rad/s, current +-30 mA: the 95 % intervals of four constants in 150 stands. Three
/// standard deviations of the share are 5.3 points.
void TestFits::motorIntervalsCoverTheTruth() {
  constexpr int kStands = 150;
  const char* keys[] = {"speedConstant", "resistance", "noLoadCurrent", "torqueCoefficient"};
  const double values[] = {truth().speedConstant, truth().resistance, truth().noLoadCurrent, kLoad};
  int covered[4] = {};
  MotorFitSetup setup = setupFor(ShaftTorque::Propeller);
  setup.fitViscousShare = false;
  setup.start.viscousShare = truth().viscousShare;
  for (unsigned seed = 1; seed <= kStands; ++seed) {
    const FitResult result = solveLeastSquares(motorFitProblem(stand(1, seed), setup));
    QVERIFY2(result.usable(), result.sentence.c_str());
    for (int k = 0; k < 4; ++k) {
      const FittedParameter& p = *result.find(keys[k]);
      covered[k] += p.halfWidth && std::abs(p.value - values[k]) <= *p.halfWidth;
    }
  }
  for (int k = 0; k < 4; ++k) {
    qInfo("%s covered in %d of %d", keys[k], covered[k], kStands);
    QVERIFY(std::abs(covered[k] / double(kStands) - 0.95) < 0.055);
  }
}

void TestFits::limitedRowsAreLeftOut_data() {
  QTest::addColumn<bool>("measured");  // the motor current
  QTest::addColumn<int>("every");      // of the throttle steps of 3 %
  QTest::addRow("from supply current and duty") << false << 1;
  QTest::addRow("from supply current and duty, steps of 9 %%") << false << 3;
  QTest::addRow("from the motor current") << true << 1;
}

/// 12 A are reached at 61 % throttle. With the rows beyond it the constants are far outside their
/// 95 % intervals; without them the intervals cover the truth as often as they should: three
/// standard deviations of the share are 6.5 points.
void TestFits::limitedRowsAreLeftOut() {
  QFETCH(bool, measured);
  QFETCH(int, every);
  constexpr int kStands = 100;
  constexpr double kLimit = 12;
  const char* keys[] = {"speedConstant", "resistance", "noLoadCurrent", "torqueCoefficient"};
  const double values[] = {truth().speedConstant, truth().resistance, truth().noLoadCurrent, kLoad};
  MotorFitSetup setup = setupFor(ShaftTorque::Propeller);
  setup.fitViscousShare = false;
  setup.start.viscousShare = truth().viscousShare;
  int covered[4] = {}, coveredWithAll[4] = {};
  for (unsigned seed = 1; seed <= kStands; ++seed) {
    MeasuredTable table = limitedStand(1, seed, kLimit);
    if (!measured) table.channels.pop_back(), table.columns.pop_back();
    for (auto& column : table.columns) {
      std::vector<double> some;
      for (std::size_t r = 0; r < column.size(); r += static_cast<std::size_t>(every))
        some.push_back(column[r]);
      column = some;
    }
    for (const bool leaveOut : {false, true}) {
      setup.currentLimit = leaveOut ? kLimit : 0;
      const MotorFitRows rows = motorFitRows(table, setup);
      QCOMPARE(rows.used + rows.limited, table.rows());
      QCOMPARE(rows.limited > 0, leaveOut);
      for (std::size_t r = 0; leaveOut && r < rows.used; ++r) QVERIFY(table.columns[0][r] < 0.61);
      const FitResult result = solveLeastSquares(motorFitProblem(table, setup));
      QVERIFY2(result.usable(), result.sentence.c_str());
      for (int k = 0; k < 4; ++k) {
        const FittedParameter& p = *result.find(keys[k]);
        const bool inside = p.halfWidth && std::abs(p.value - values[k]) <= *p.halfWidth;
        (leaveOut ? covered : coveredWithAll)[k] += inside;
      }
    }
  }
  for (int k = 0; k < 4; ++k) {
    qInfo("%s: covered in %d of %d, with all rows in %d", keys[k], covered[k], kStands,
          coveredWithAll[k]);
    QVERIFY(std::abs(covered[k] / double(kStands) - 0.95) < 0.065);
  }
  QVERIFY(coveredWithAll[0] < kStands / 10 && coveredWithAll[1] < kStands / 10);
}

/// Without the duty only the power of the motor is known: K is needed from elsewhere, the fit says
/// so.
void TestFits::motorByPower() {
  MotorFitSetup setup = setupFor(ShaftTorque::Measured);
  setup.duty = DutyFrom::Unknown;
  setup.fitViscousShare = false;
  setup.start.viscousShare = truth().viscousShare;
  FitResult result = solveLeastSquares(motorFitProblem(stand(0.1, 1), setup));
  QVERIFY(result.usable());
  setup.start.speedConstant = truth().speedConstant;
  setup.fitSpeedConstant = false;
  result = solveLeastSquares(motorFitProblem(stand(0.1, 1), setup));
  QVERIFY(std::abs(result.find("resistance")->value / truth().resistance - 1) < 0.05);
  // Half the supply at one throttle only: friction and load look the same.
  MeasuredTable single = stand(0.1, 1);
  for (auto& column : single.columns) column.assign(6, column.back());
  setup = setupFor(ShaftTorque::Propeller);
  setup.fitViscousShare = false;
  const FitResult one = solveLeastSquares(motorFitProblem(single, setup));
  QVERIFY(one.usable());
  for (const FittedParameter& p : one.parameters) {
    QVERIFY2(!p.determined || !p.halfWidth, p.parameter.label.c_str());
  }
}

void TestFits::saysWhatIsMissing() {
  MeasuredTable table = stand(0, 0);
  table.channels.erase(table.channels.begin() + 3, table.channels.end());
  table.columns.resize(3);
  const auto missing = missingForMotorFit(table, setupFor(ShaftTorque::Measured));
  QCOMPARE(missing,
           (std::vector<std::string>{"The measured data have no column for Supply current.",
                                     "The measured data have no column for Torque."}));
  QVERIFY_THROWS_EXCEPTION(InputError, motorFitProblem(table, setupFor(ShaftTorque::Measured)));
  QCOMPARE(missingForRotorFit(table, {}),
           (std::vector<std::string>{"The measured data have no column for Thrust.",
                                     "The measured data have no column for Torque."}));
  QCOMPARE(
      missingForPropellerFit(table, {}),
      (std::vector<std::string>{"The measured data have neither CT or thrust nor CP or torque."}));
}

void TestFits::escResistanceIsTakenOff() {
  MotorFitSetup setup = setupFor(ShaftTorque::Propeller);
  setup.escResistance = 0.02;
  const FittedMotor fitted =
      motorFrom(solveLeastSquares(motorFitProblem(stand(0, 0), setup)), setup);
  QVERIFY(std::abs(fitted.motor.resistance - (truth().resistance - 0.02)) < 1e-4);
}

/// T = 1.3e-5 w^2 and Q = 2e-7 w^2 of four rotors together, exactly.
void TestFits::rotor() {
  MeasuredTable table{
      "rotor",
      {{"motor.speed", "rad/s", {}}, {"thrust", "N", {}}, {"motor.torque", "N*m", {}}},
      {{100, 300, 500}, {}, {}}};
  for (const double w : table.columns[0]) {
    table.columns[1].push_back(4 * 1.3e-5 * w * w);
    table.columns[2].push_back(-4 * 2e-7 * w * w);
  }
  RotorFitSetup setup;
  setup.rotors = 4;
  const FitResult result = solveLeastSquares(rotorFitProblem(table, setup));
  QVERIFY(std::abs(result.find("thrust")->value / 1.3e-5 - 1) < 1e-9);
  QVERIFY(std::abs(result.find("torque")->value / 2e-7 - 1) < 1e-9);
  // A 10 inch propeller with CT 0.1 at 1.2 kg/m^3: T = 0.1 * 1.2 * n^2 * 0.254^4.
  const double kf = 0.1 * 1.2 * std::pow(0.254, 4) / std::pow(2 * std::numbers::pi, 2);
  QVERIFY(std::abs(thrustCoefficientOf(kf, 1.2, 0.254) - 0.1) < 1e-12);
  const std::string said = provenanceText({"rotor.csv", "2026-11-22", "rotor"}, result);
  QVERIFY2(said.starts_with("Fitted (rotor) to rotor.csv on 2026-11-22, 6 measured values, by "
                            "non-linear least squares; 95 % intervals. Thrust coefficient k_f: "
                            "1.3e-05 "),
           said.c_str());
  QVERIFY2(said.find("RMSE of Torque: ") != std::string::npos && said.ends_with(")."),
           said.c_str());
  const double km = 0.05 * 1.2 * std::pow(0.254, 5) / std::pow(2 * std::numbers::pi, 3);
  QVERIFY(std::abs(powerCoefficientOf(km, 1.2, 0.254) - 0.05) < 1e-12);
}

void TestFits::propeller_data() {
  QTest::addColumn<bool>("flown");
  QTest::addRow("static") << false;
  QTest::addRow("in flight") << true;
}

/// Coefficients of the model itself with 1.5 degrees more twist and 1.3 times the profile drag are
/// found again.
void TestFits::propeller() {
  QFETCH(bool, flown);
  PropellerFitSetup setup;
  setup.fitDrag = true;
  setup.settings.elements = 12;
  PropellerGeometry real = setup.start;
  real.twistOffset = 1.5 * std::numbers::pi / 180;
  std::get<AnalyticSection>(real.sections.front().model).constants.profileDrag *= 1.3;
  const BladeElementRotor rotor(real, setup.settings);
  MeasuredTable table{
      "tunnel",
      {{"over_advance.j", "1", {}}, {"motor.speed", "rad/s", {}}, {"ct", "1", {}}, {"cp", "1", {}}},
      std::vector<std::vector<double>>(4)};
  for (int i = 0; i < 10; ++i) {
    const double j = flown ? 0.06 * i : 0, w = (flown ? 5000 : 2500 + 400 * i) * kRpm;
    const double n = w / (2 * std::numbers::pi), d = real.diameter;
    const AxialLoad load = rotor.axial(w, j * n * d, setup.air);
    const double force = setup.air.density * n * n * std::pow(d, 4);
    table.columns[0].push_back(j);
    table.columns[1].push_back(w);
    table.columns[2].push_back(load.thrust / force);
    table.columns[3].push_back(load.torque * 2 * std::numbers::pi / (force * d));
  }
  const FitResult result = solveLeastSquares(propellerFitProblem(table, setup));
  QVERIFY2(result.usable(), result.sentence.c_str());
  const PropellerGeometry fitted = propellerFrom(result, setup);
  QVERIFY(std::abs(fitted.twistOffset - real.twistOffset) < 1e-4);
  QVERIFY(std::abs(result.find("dragFactor")->value - 1.3) < 0.01);
}

QTEST_APPLESS_MAIN(TestFits)
#include "test_fits.moc"
