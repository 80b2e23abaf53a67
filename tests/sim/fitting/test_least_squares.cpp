// The solver and its intervals: closed forms, known noise, parameters that cannot be found.
#include <QTest>
#include <cmath>
#include <random>

#include "sim/fitting/least_squares.h"
#include "sim/fitting/provenance.h"

using namespace rotorbench;

namespace {

/// y = a + b x at the given points.
FitProblem line(const std::vector<double>& x, const std::vector<double>& y) {
  FitProblem problem;
  problem.parameters.push_back({"a", "Intercept", "1", "1", 0});
  problem.parameters.push_back({"b", "Slope", "1", "1", 0});
  problem.outputs.push_back({"y", "1", "1", 1});
  for (std::size_t i = 0; i < x.size(); ++i) problem.points.push_back({0, x[i], y[i]});
  problem.predict = [x](std::span<const double> p, std::span<double> predicted) {
    for (std::size_t i = 0; i < x.size(); ++i) predicted[i] = p[0] + p[1] * x[i];
    return true;
  };
  return problem;
}

}  // namespace

class TestLeastSquares : public QObject {
  Q_OBJECT
 private slots:
  void quantiles_data();
  void quantiles();
  void lineByHand();
  void intervalsCoverTheTruth();
  void robustAgainstOutliers();
  void whatTheDataDoNotDetermine();
  void bounds();
  void refuses_data();
  void refuses();
  void cancels();
  void saysValues();
};

void TestLeastSquares::quantiles_data() {
  QTest::addColumn<double>("p");
  QTest::addColumn<double>("degrees");
  QTest::addColumn<double>("t");
  // Student's t, table of Abramowitz and Stegun 26.10; the first two have closed forms.
  QTest::addRow("1") << 0.975 << 1.0 << std::tan(M_PI * 0.475);
  QTest::addRow("2") << 0.975 << 2.0 << 0.95 * std::sqrt(2 / (1 - 0.95 * 0.95));
  QTest::addRow("10") << 0.975 << 10.0 << 2.228;
  QTest::addRow("30") << 0.995 << 30.0 << 2.750;
  QTest::addRow("many") << 0.975 << 1e6 << 1.960;
}

void TestLeastSquares::quantiles() {
  QFETCH(double, p);
  QFETCH(double, degrees);
  QFETCH(double, t);
  QVERIFY(std::abs(studentQuantile(p, degrees) / t - 1) < 3e-4);
}

/// Ordinary regression of 5 points; slope, intercept and their standard errors by the textbook
/// formulas.
void TestLeastSquares::lineByHand() {
  const std::vector<double> x{0, 1, 2, 3, 4}, y{1, 3.2, 4.9, 7.1, 8.8};
  const FitResult result = solveLeastSquares(line(x, y));
  QCOMPARE(result.end, FitEnd::Converged);
  const double b = 1.95, a = 1.1;  // Sxy/Sxx = 19.5/10, mean y - 2 b = 5 - 3.9
  QVERIFY(std::abs(result.find("b")->value - b) < 1e-6);
  QVERIFY(std::abs(result.find("a")->value - a) < 1e-6);
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += std::pow(y[i] - a - b * x[i], 2);
  const double t = 3.18244630528371;  // 97.5 % at 3 degrees of freedom
  const double s = std::sqrt(squares / 3);
  QVERIFY(std::abs(*result.find("b")->halfWidth / (t * s / std::sqrt(10)) - 1) < 1e-5);
  QVERIFY(std::abs(*result.find("a")->halfWidth / (t * s * std::sqrt(0.2 + 4.0 / 10)) - 1) < 1e-5);
  // Correlation of slope and intercept: -mean x/sqrt(mean x^2).
  QVERIFY(std::abs(result.correlation[0][1] + 2 / std::sqrt(6.0)) < 1e-6);
  QVERIFY(std::abs(result.outputs[0].rmseAfter - std::sqrt(squares / 5)) < 1e-9);
}

/// 95 % intervals of a decay with known noise cover the truth in 95 % of 400 experiments; three
/// standard deviations of that count are 3.3 points.
void TestLeastSquares::intervalsCoverTheTruth() {
  constexpr int kExperiments = 400, kPoints = 25;
  constexpr double kA = 3, kRate = 0.7, kNoise = 0.05;
  int coveredA = 0, coveredRate = 0;
  for (int seed = 0; seed < kExperiments; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::normal_distribution<double> noise(0, kNoise);
    FitProblem problem;
    problem.parameters.push_back({"a", "A", "1", "1", 1, 0, 100, 1});
    problem.parameters.push_back({"r", "Rate", "1", "1", 0.2, 0, 100, 1});
    problem.outputs.push_back({"y", "1", "1", 1});
    for (int i = 0; i < kPoints; ++i) {
      const double x = 0.2 * i;
      problem.points.push_back({0, x, kA * std::exp(-kRate * x) + noise(random)});
    }
    problem.predict = [points = problem.points](std::span<const double> p,
                                                std::span<double> predicted) {
      for (std::size_t i = 0; i < points.size(); ++i)
        predicted[i] = p[0] * std::exp(-p[1] * points[i].x);
      return true;
    };
    const FitResult result = solveLeastSquares(problem);
    QCOMPARE(result.end, FitEnd::Converged);
    coveredA += std::abs(result.parameters[0].value - kA) <= *result.parameters[0].halfWidth;
    coveredRate += std::abs(result.parameters[1].value - kRate) <= *result.parameters[1].halfWidth;
  }
  qInfo("covered: %d and %d of %d", coveredA, coveredRate, kExperiments);
  for (const int covered : {coveredA, coveredRate})
    QVERIFY(std::abs(covered / double(kExperiments) - 0.95) < 0.033);
}

void TestLeastSquares::robustAgainstOutliers() {
  std::vector<double> x, y;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.1);
  for (int i = 0; i < 60; ++i) {
    x.push_back(0.1 * i);
    y.push_back(1 + 2 * x.back() + noise(random) + (i % 10 == 3 ? 20 : 0));
  }
  const FitResult plain = solveLeastSquares(line(x, y));
  FitOptions options;
  options.robust = true;
  const FitResult robust = solveLeastSquares(line(x, y), options);
  QVERIFY(std::abs(plain.find("a")->value - 1) > 1);
  QVERIFY(std::abs(robust.find("a")->value - 1) < 0.2);
  QVERIFY(std::abs(robust.find("b")->value - 2) < 0.05);
}

void TestLeastSquares::whatTheDataDoNotDetermine() {
  FitProblem problem = line({0, 1, 2, 3}, {1, 2, 3.1, 4});
  problem.parameters.push_back({"c", "Twin", "1", "1", 0});
  problem.parameters.push_back({"d", "Idle", "1", "1", 5});
  problem.points.push_back({0, 4, 5});
  problem.points.push_back({0, 5, 6});
  problem.predict = [](std::span<const double> p, std::span<double> predicted) {
    for (std::size_t i = 0; i < predicted.size(); ++i)
      predicted[i] = p[0] + (p[1] + p[2]) * static_cast<double>(i);
    return true;
  };
  const FitResult result = solveLeastSquares(problem);
  QVERIFY(result.usable());
  QVERIFY(result.find("a")->determined && result.find("a")->halfWidth.has_value());
  QVERIFY(!result.find("b")->determined && !result.find("b")->halfWidth.has_value());
  QCOMPARE(result.find("c")->remark,
           std::string("The data do not determine this: Slope can make up for any change of it."));
  QCOMPARE(result.find("d")->remark,
           std::string("The data do not determine this: nothing that was measured depends on it."));
  QVERIFY(std::isnan(result.correlation[1][2]));
  QVERIFY(!std::isnan(result.correlation[0][0]));
}

void TestLeastSquares::bounds() {
  FitProblem problem = line({0, 1, 2}, {0, 2, 4.1});
  problem.parameters[1].high = 1.5;
  const FitResult result = solveLeastSquares(problem);
  QVERIFY(result.usable());
  QVERIFY(std::abs(result.find("b")->value - 1.5) < 1e-6);
  QVERIFY(!result.find("b")->halfWidth.has_value());
  QCOMPARE(result.find("b")->remark,
           std::string("This stands at the end of its range: the data ask for more."));
}

void TestLeastSquares::refuses_data() {
  QTest::addColumn<int>("points");
  QTest::addColumn<bool>("computable");
  QTest::addColumn<QString>("sentence");
  QTest::addRow("no points") << 0 << true << "There are no measured points to fit to.";
  QTest::addRow("too few") << 1 << true
                           << "There are 1 measured points for 2 parameters; more points are "
                              "needed.";
  QTest::addRow("no answer") << 3 << false
                             << "The model could not be computed near the start values.";
}

void TestLeastSquares::refuses() {
  QFETCH(int, points);
  QFETCH(bool, computable);
  QFETCH(QString, sentence);
  FitProblem problem = line(std::vector<double>(static_cast<std::size_t>(points), 1),
                            std::vector<double>(static_cast<std::size_t>(points), 1));
  if (!computable) {
    problem.predict = [](std::span<const double>, std::span<double>) { return false; };
  }
  const FitResult result = solveLeastSquares(problem);
  QCOMPARE(result.end, FitEnd::Failed);
  QCOMPARE(QString::fromStdString(result.sentence), sentence);
}

void TestLeastSquares::cancels() {
  FitOptions options;
  options.progress = [](const FitProgress& progress) { return progress.iteration < 1; };
  const FitResult result = solveLeastSquares(line({0, 1, 2}, {0, 2, 5}), options);
  QCOMPARE(result.end, FitEnd::Cancelled);
  QVERIFY(!result.usable());
}

void TestLeastSquares::saysValues() {
  FittedParameter p;
  p.parameter = {"r", "Resistance", "Ohm", "mOhm", 0.1};
  p.value = 0.14812, p.halfWidth = 0.0031;
  QCOMPARE(valueText(p), std::string("148.1 \u00B1 3.1 mOhm"));
  p.halfWidth.reset();
  QCOMPARE(valueText(p), std::string("148.12 mOhm"));
  p.determined = false;
  QCOMPARE(valueText(p), std::string("not determined"));
}

QTEST_APPLESS_MAIN(TestLeastSquares)
#include "test_least_squares.moc"
