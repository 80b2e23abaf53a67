#include <QTest>
#include <cmath>
#include <functional>
#include <numbers>

#include "sim/analysis/step_response.h"

using namespace rotorbench;

namespace {

using Signal = std::function<double(double)>;

constexpr double kInterval = 1e-3;  // s between rows

/// One signal over time, with the step at t = 0.
class Recorded {
 public:
  Recorded(const Signal& signal, std::size_t rows, double start = 0)
      : recording({{"time", "s", ""}, {"signal", "m", ""}}) {
    for (std::size_t row = 0; row < rows; ++row) {
      const double t = start + static_cast<double>(row) * kInterval;
      const std::array<double, 2> values{t, signal(t)};
      recording.append(values);
    }
    recording.publish();
  }
  [[nodiscard]] StepFigures figures(double before, double after) const {
    return stepFigures(recording, {1, 0, recording.rows(), before, after});
  }
  Recording recording;
};

/// Unit step response of a damped oscillator (Ogata, Modern Control Engineering, eq. 5-12).
struct SecondOrder {
  double zeta, omega;
  [[nodiscard]] double damped() const { return omega * std::sqrt(1 - zeta * zeta); }
  double operator()(double t) const {
    return 1 - std::exp(-zeta * omega * t) *
                   (std::cos(damped() * t) +
                    zeta / std::sqrt(1 - zeta * zeta) * std::sin(damped() * t));
  }
  /// Time in [from, to], where the response is monotonic, at which it has the value.
  [[nodiscard]] double timeOf(double value, double from, double to) const {
    const bool rising = (*this)(to) > (*this)(from);
    for (int i = 0; i < 100; ++i) {
      const double middle = (from + to) / 2;
      (((*this)(middle) < value) == rising ? from : to) = middle;
    }
    return (from + to) / 2;
  }
  /// The response turns at k pi / omega_d, exp(-zeta omega t) away from 1: it enters the band for
  /// good after the last turn outside.
  [[nodiscard]] double settlingTime(double band) const {
    const double half = std::numbers::pi / damped();
    int turn = 0;
    while (std::exp(-zeta * omega * (turn + 1) * half) > band) ++turn;
    const double edge = (*this)(turn * half) < 1 ? 1 - band : 1 + band;
    return timeOf(edge, turn * half, (turn + 1) * half);
  }
};

void compareTimes(double measured, double exact) {
  // Rows lie one interval apart, and a figure is at most the difference of two of them.
  QVERIFY2(std::abs(measured - exact) <= 1.001 * kInterval,
           qPrintable(QString("%1 s, exact %2 s").arg(measured).arg(exact)));
}

}  // namespace

class TestStepResponse : public QObject {
  Q_OBJECT

 private slots:
  void firstOrder_data();
  void firstOrder();
  void secondOrder_data();
  void secondOrder();
  void neverReached();
  void leavesTheBandAgain();
  void oneRow();
  void noRows();
  void noStep();
  void windowOfALongRecording();
};

void TestStepResponse::firstOrder_data() {
  QTest::addColumn<double>("tau");
  QTest::addColumn<double>("before");
  QTest::addColumn<double>("after");
  QTest::addRow("unit step") << 0.5 << 0.0 << 1.0;
  QTest::addRow("step down") << 0.5 << 2.0 << -3.0;
  QTest::addRow("small step far from zero") << 0.2 << 100.0 << 100.5;
  QTest::addRow("small step down") << 0.8 << 0.1 << 0.0;
}

/// y = 1 - exp(-t / tau): from 10 % to 90 % in tau ln 9, within 2 % after tau ln 50.
void TestStepResponse::firstOrder() {
  QFETCH(double, tau);
  QFETCH(double, before);
  QFETCH(double, after);
  const double size = after - before;
  const Recorded recorded([&](double t) { return after - size * std::exp(-t / tau); }, 10'001);
  const StepFigures figures = recorded.figures(before, after);
  compareTimes(figures.riseTime, tau * std::log(9.0));
  compareTimes(figures.settlingTime, tau * std::log(50.0));
  QVERIFY(figures.overshoot < 1e-12);
  QVERIFY(figures.overshoot >= 0);
  // The last tenth of 10,001 rows begins at row 9001.
  const double rest = std::abs(size) * std::exp(-9.001 / tau);
  QVERIFY(std::abs(figures.restError - rest) < 1e-12);
}

void TestStepResponse::secondOrder_data() {
  QTest::addColumn<double>("zeta");
  QTest::addColumn<double>("omega");
  QTest::addColumn<double>("before");
  QTest::addColumn<double>("after");
  QTest::addRow("lively") << 0.2 << 6.0 << 0.0 << 1.0;
  QTest::addRow("lively, down") << 0.2 << 6.0 << 1.0 << -1.0;
  QTest::addRow("usual") << 0.5 << 4.0 << 0.0 << 0.1745;
  QTest::addRow("well damped") << 0.7 << 3.0 << 2.0 << 5.0;
  QTest::addRow("hardly overshooting") << 0.9 << 5.0 << 0.0 << -2.0;
}

/// Overshoot exp(-pi zeta / sqrt(1 - zeta^2)) (Ogata, eq. 5-21).
void TestStepResponse::secondOrder() {
  QFETCH(double, zeta);
  QFETCH(double, omega);
  QFETCH(double, before);
  QFETCH(double, after);
  const SecondOrder unit{zeta, omega};
  const Recorded recorded([&](double t) { return before + (after - before) * unit(t); }, 20'001);
  const StepFigures figures = recorded.figures(before, after);
  const double overshoot = std::exp(-std::numbers::pi * zeta / std::sqrt(1 - zeta * zeta));
  // Between rows the peak is missed by at most the curvature omega^2 over half an interval.
  QVERIFY(figures.overshoot <= overshoot + 1e-12);
  QVERIFY(figures.overshoot >= overshoot - omega * omega * kInterval * kInterval / 8);
  const double peak = std::numbers::pi / unit.damped();
  compareTimes(figures.riseTime, unit.timeOf(0.9, 0, peak) - unit.timeOf(0.1, 0, peak));
  compareTimes(figures.settlingTime, unit.settlingTime(0.02));
}

void TestStepResponse::neverReached() {
  const Recorded half([](double t) { return 0.5 * (1 - std::exp(-t)); }, 20'001);
  const StepFigures figures = half.figures(0, 1);
  QVERIFY(std::isnan(figures.riseTime));
  QVERIFY(std::isnan(figures.settlingTime));
  QCOMPARE(figures.overshoot, 0.0);
  QVERIFY(std::abs(figures.restError - 0.5) < 1e-7);

  const Recorded away([](double t) { return -t; }, 1000);
  const StepFigures wrongWay = away.figures(0, 1);
  QVERIFY(std::isnan(wrongWay.riseTime));
  QVERIFY(std::isnan(wrongWay.settlingTime));
  QCOMPARE(wrongWay.overshoot, 0.0);
}

void TestStepResponse::leavesTheBandAgain() {
  const Recorded recorded([](double t) { return t < 0.5 ? 0.0 : t < 1.9985 ? 1.0 : 1.5; }, 2000);
  const StepFigures figures = recorded.figures(0, 1);
  QCOMPARE(figures.riseTime, 0.0);
  QCOMPARE(figures.overshoot, 0.5);
  QVERIFY(std::isnan(figures.settlingTime));
  QCOMPARE(figures.restError, 0.5);
}

void TestStepResponse::oneRow() {
  const Recorded recorded([](double) { return 0.25; }, 1);
  const StepFigures figures = recorded.figures(0, 1);
  QVERIFY(std::isnan(figures.riseTime));
  QVERIFY(std::isnan(figures.settlingTime));
  QCOMPARE(figures.restError, 0.75);
}

void TestStepResponse::noRows() {
  const Recorded recorded([](double) { return 1.0; }, 0);
  const StepFigures figures = recorded.figures(0, 1);
  QVERIFY(std::isnan(figures.riseTime));
  QVERIFY(std::isnan(figures.settlingTime));
  QVERIFY(std::isnan(figures.overshoot));
  QVERIFY(std::isnan(figures.restError));
}

/// Without a step nothing relative to it exists; how far off the signal rests does.
void TestStepResponse::noStep() {
  const Recorded recorded([](double t) { return 2 + 0.125 * std::exp(-t); }, 100);
  const StepFigures figures = recorded.figures(2, 2);
  QVERIFY(std::isnan(figures.riseTime));
  QVERIFY(std::isnan(figures.settlingTime));
  QVERIFY(std::isnan(figures.overshoot));
  QCOMPARE(figures.restError, 0.125 * std::exp(-0.09));
}

/// Of several steps in one recording only the rows of the window count, and times count from its
/// first row.
void TestStepResponse::windowOfALongRecording() {
  constexpr double kTau = 0.25;
  const Recorded recorded(
      [](double t) {
        if (t < 2.9995) return 50.0;
        if (t < 7.9995) return 1 - std::exp(-(t - 3) / kTau);
        return -50.0;
      },
      10'000);
  const StepFigures figures = stepFigures(recorded.recording, {1, 3000, 8000, 0, 1});
  compareTimes(figures.riseTime, kTau * std::log(9.0));
  compareTimes(figures.settlingTime, kTau * std::log(50.0));
  QVERIFY(figures.overshoot < 1e-12);
  QVERIFY(figures.restError < 1e-7);
}

QTEST_GUILESS_MAIN(TestStepResponse)
#include "test_step_response.moc"
