// Fits whose values should not be used unseen are called so, and a throttle that cannot be the duty
// is not taken for it.
#include <QTest>
#include <cmath>
#include <numbers>

#include "sim/fitting/doubt.h"
#include "sim/fitting/duty_source.h"
#include "sim/fitting/fit_request.h"
#include "sim/logs/csv_import.h"

using namespace rotorbench;

namespace {

constexpr double kRpm = std::numbers::pi / 30;

MeasuredTable x2216() {
  const TextLines lines =
      TextLines::fromFile(std::string(TEST_DATA_DIR "/measurement/x2216_10x4.7.csv"));
  return importTable(lines, guessSettings(lines)).table;
}

/// The label and what the authors of the log give, as the shipped thrust stand has it.
FitStart x2216Start() {
  FitStart start;
  start.motor = djiE305();
  start.motor.speedConstant = 1100 * kRpm;
  start.motor.resistance = 0.148;
  start.motor.noLoadCurrent = 0.8;
  return start;
}

FitResult fitted(const FitRequest& request, const FitStart& start, const MeasuredTable& table) {
  return solveLeastSquares(problemOf(request, table, start));
}

/// y = p x with p = 2 and a little scatter.
FitResult lineFrom(double start, double high, bool guess = false) {
  FitProblem problem;
  problem.parameters = {{"p", "Slope", "1", "1", start, 0, high, 1, guess}};
  problem.outputs = {{"y", "1", "1", 1}};
  for (int k = 1; k <= 10; ++k) problem.points.push_back({0, 1.0 * k, 2.0 * k + 1e-3 * (k % 3)});
  problem.predict = [points = problem.points](std::span<const double> p, std::span<double> y) {
    for (std::size_t i = 0; i < points.size(); ++i) y[i] = p[0] * points[i].x;
    return true;
  };
  return solveLeastSquares(problem);
}

/// Steady speeds of a motor with a propeller at `duty(throttle)` of 12 V: d V = R k w^2/K + w K.
std::vector<DutyRow> stand(double (*duty)(double), double most = 1) {
  const double k = 1 / (1000 * kRpm), a = 0.15 * 2e-7 / k;
  std::vector<DutyRow> rows;
  for (int step = 4; step <= 20; ++step) {
    const double v = 12 * duty(step / 20.0);
    rows.push_back({most * step / 20, (std::sqrt(k * k + 4 * a * v) - k) / (2 * a), 12});
  }
  return rows;
}

}  // namespace

class TestDoubt : public QObject {
  Q_OBJECT

 private slots:
  void saysWhatIsFarFromItsStart_data();
  void saysWhatIsFarFromItsStart();
  void saysWhatTheDataDoNotDetermine();
  void findsWhetherTheThrottleIsTheDuty_data();
  void findsWhetherTheThrottleIsTheDuty();
  void needsNoThrottle();
  void throttleTakenForTheDutyIsDoubted();
  void shippedLogGivesTheLabelledMotor();
};

void TestDoubt::saysWhatIsFarFromItsStart_data() {
  QTest::addColumn<double>("start");
  QTest::addColumn<double>("high");
  QTest::addColumn<bool>("guess");
  QTest::addColumn<QString>("expected");
  QTest::addRow("near") << 1.6 << 10.0 << false << "Converged.";
  QTest::addRow("above") << 1.5 << 10.0 << false
                         << "Doubtful. Slope: 2.0001 is 33 % above its start of 1.5.";
  QTest::addRow("below") << 3.0 << 10.0 << false
                         << "Doubtful. Slope: 2.0001 is 33 % below its start of 3.";
  QTest::addRow("many times") << 0.5 << 10.0 << false
                              << "Doubtful. Slope: 2.0001 is 4 times its start of 0.5.";
  QTest::addRow("guessed") << 0.5 << 10.0 << true << "Converged.";
  QTest::addRow("from zero") << 0.0 << 10.0 << false << "Converged.";
  QTest::addRow("at its end")
      << 1.0 << 1.2 << false
      << "Doubtful. Slope: 1.2 is the end of its range (start 1), the data do not determine it.";
  QTest::addRow("guessed, at its end")
      << 1.0 << 1.2 << true
      << "Doubtful. Slope: 1.2 is the end of its range, the data do not determine it.";
}

void TestDoubt::saysWhatIsFarFromItsStart() {
  QFETCH(double, start);
  QFETCH(double, high);
  QFETCH(bool, guess);
  QFETCH(QString, expected);
  const FitResult result = lineFrom(start, high, guess);
  QCOMPARE(QString::fromStdString(verdictOf(result)), expected);
  QCOMPARE(doubtsOf(result).empty(), expected == "Converged.");
}

/// Two factors of one product: only the product is seen.
void TestDoubt::saysWhatTheDataDoNotDetermine() {
  FitProblem problem;
  problem.parameters = {{"a", "First", "1", "1", 1, 0, 10, 1},
                        {"b", "Second", "1", "1", 2, 0, 10, 1}};
  problem.outputs = {{"y", "1", "1", 1}};
  for (int k = 1; k <= 10; ++k) problem.points.push_back({0, 1.0 * k, 2.0 * k});
  problem.predict = [points = problem.points](std::span<const double> p, std::span<double> y) {
    for (std::size_t i = 0; i < points.size(); ++i) y[i] = p[0] * p[1] * points[i].x;
    return true;
  };
  const FitResult result = solveLeastSquares(problem);
  QCOMPARE(QString::fromStdString(verdictOf(result)),
           QString("Doubtful. First: the data do not determine it (start 1). Second: the data do "
                   "not determine it (start 2)."));
}

void TestDoubt::findsWhetherTheThrottleIsTheDuty_data() {
  QTest::addColumn<std::vector<DutyRow>>("rows");
  QTest::addColumn<DutyFrom>("expected");
  QTest::addColumn<QString>("text");
  QTest::addRow("it is") << stand([](double t) { return t; }) << DutyFrom::Throttle << "";
  // Curved, but it rises to its end: nothing in throttle and speed contradicts.
  QTest::addRow("square") << stand([](double t) { return t * t; }) << DutyFrom::Throttle << "";
  QTest::addRow("full at 0.7")
      << stand([](double t) { return std::min(t / 0.7, 1.0); }) << DutyFrom::FullThrottle
      << "At 80 % throttle the motor turns as fast as at 100 %: the throttle is not the duty, "
         "which is taken as 1 at full throttle and as unknown below.";
  QTest::addRow("never full") << stand([](double d) { return std::min(1.3 * d, 0.8); }, 0.9)
                              << DutyFrom::Unknown
                              << "At 72 % throttle the motor turns as fast as at 90 %: the "
                                 "throttle is not the duty, which is taken as unknown.";
}

void TestDoubt::findsWhetherTheThrottleIsTheDuty() {
  QFETCH(std::vector<DutyRow>, rows);
  QFETCH(DutyFrom, expected);
  QFETCH(QString, text);
  QCOMPARE(dutySourceOf(rows), expected);
  QCOMPARE(QString::fromStdString(dutySourceText(rows)), text);
}

/// Without a column for it the duty is unknown, and the speed constant cannot be found.
void TestDoubt::needsNoThrottle() {
  MeasuredTable table = x2216();
  for (Channel& channel : table.channels) {
    if (channel.name == "throttle") channel.name = "servo";
  }
  QVERIFY(missingFor(FitRequest{}, table, x2216Start()).empty());
  QVERIFY(dutyText(FitRequest{}, table, x2216Start()).empty());
  const FitResult result = fitted(FitRequest{}, x2216Start(), table);
  QVERIFY2(
      verdictOf(result).find("Speed constant: the data do not determine it") != std::string::npos,
      verdictOf(result).c_str());
}

/// The controller of the log is fully on from about 72 % throttle. With the throttle as the duty
/// the speed constant runs to ten times its label, the end of its range.
void TestDoubt::throttleTakenForTheDutyIsDoubted() {
  MotorFitRequest motor;
  motor.duty = DutyFrom::Throttle;
  FitRequest request;
  request.what = motor;
  const FitResult result = fitted(request, x2216Start(), x2216());
  const QString verdict = QString::fromStdString(verdictOf(result));
  QVERIFY2(verdict.startsWith("Doubtful. Speed constant: 11000 rpm/V is the end of its range "
                              "(start 1100 rpm/V), the data do not determine it."),
           qPrintable(verdict));
}

/// As the dialog asks at first. Of a duty that is known at full throttle only, speed constant and
/// no-load current make up for each other in part: with the current of the data sheet the constant
/// is that of the label, without it the fit is doubtful.
void TestDoubt::shippedLogGivesTheLabelledMotor() {
  const MeasuredTable table = x2216();
  const FitRequest request;
  const QString text = QString::fromStdString(dutyText(request, table, x2216Start()));
  QVERIFY2(text.contains("the throttle is not the duty"), qPrintable(text));
  const FitResult result = fitted(request, x2216Start(), table);
  for (const FittedParameter& p : result.parameters)
    qInfo("%s %.5g +- %.2g %s", p.parameter.label.c_str(), p.value, p.halfWidth.value_or(0),
          p.remark.c_str());
  qInfo("%s", verdictOf(result).c_str());
  QVERIFY(result.find("speedConstant")->value < 1.35 * 1100 * kRpm);
  QVERIFY(verdictOf(result).find("% above its start of 0.8 A.") != std::string::npos);
  MotorFitRequest known;
  known.noLoadCurrent = false;
  FitRequest withSheet;
  withSheet.what = known;
  const FitResult better = fitted(withSheet, x2216Start(), table);
  qInfo("%s", verdictOf(better).c_str());
  QVERIFY(std::abs(better.find("speedConstant")->value / (1100 * kRpm) - 1) < 0.1);
}

QTEST_APPLESS_MAIN(TestDoubt)
#include "test_doubt.moc"
