// State feedback by poles and by weights: the gains, the loop they close, its limits, and flights.
#include <QTest>
#include <cmath>

#include "sim/control/state_feedback.h"
#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/run/plant_handle.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

double near(double value, double expected) {
  return std::abs(value / expected - 1);
}

/// Roll of a vehicle that is nothing but a double integrator, its thrust behind a lag.
struct RollAxis {
  ControlModel model = controlModel(VehicleParameters{}, {}, {});
  StateFeedback controller;
  double period, lag, disturbance = 0;  ///< rad/s^2
  double angle = 0, rate = 0, acceleration = 0, demand = 0;

  template <class P>
  explicit RollAxis(const P& p) : controller(p, model, {}), period(1 / p.rate), lag(p.thrustLag) {}

  void step(double wanted) {
    BodyMotion body;
    body.attitude[0] = angle;
    body.rates[0] = rate;
    SetPoint setPoint;
    setPoint.roll = wanted;
    controller.update(body, setPoint);
    demand = (model.inverseInertia * controller.wrench().tail<3>())[0];
    // Exact over a period: the lag, and what it and the disturbance do to rate and angle.
    const double h = period, decay = lag > 0 ? std::exp(-h / lag) : 0;
    const double gap = acceleration - demand, total = demand + disturbance;
    const double first = lag * (1 - decay);
    angle += rate * h + 0.5 * total * h * h + gap * lag * (h - first);
    rate += total * h + gap * first;
    acceleration = demand + gap * decay;
  }
};

StateFeedbackParameters slowLimits(FeedbackStage stage) {
  StateFeedbackParameters p;
  p.stage = stage;
  p.roll.limit = 2;
  return p;
}

Experiment flownBy(const ControllerParameters& controller) {
  Experiment e = shipped("f450-hover-and-steps");
  alternative<ControlledInputs>(alternative<Flight>(e.setup).control).controller = controller;
  return e;
}

}  // namespace

class TestStateFeedback : public QObject {
  Q_OBJECT
 private slots:
  /// The sampled loop has the poles that were asked for.
  void polesAreWherePlaced_data() {
    QTest::addColumn<double>("lag");
    QTest::addColumn<bool>("integral");
    QTest::addRow("plain") << 0.0 << false;
    QTest::addRow("integral") << 0.0 << true;
    QTest::addRow("lag") << 0.03 << false;
    QTest::addRow("lag and integral") << 0.03 << true;
  }
  void polesAreWherePlaced() {
    QFETCH(double, lag);
    QFETCH(bool, integral);
    const AxisModel model{0.002, lag};
    const AxisGains gains = placedGains(model, 7, 0.8, 4, integral);
    std::vector<std::complex<double>> wanted{{-5.6, 4.2}, {-5.6, -4.2}};
    if (lag > 0) wanted.emplace_back(-1 / lag, 0);
    if (integral) wanted.emplace_back(-4, 0);
    const Eigen::VectorXcd found = closedLoopPoles(model, gains);
    QCOMPARE(static_cast<std::size_t>(found.size()), wanted.size());
    for (const auto& pole : wanted) {
      double least = HUGE_VAL;
      for (const auto& one : found) least = std::min(least, std::abs(one - pole) / std::abs(pole));
      QVERIFY2(least < 1e-6, qPrintable(QString::number(least)));
    }
  }

  /// Fast sampling comes to the continuous gains: w^2 + 2 zeta w p, 2 zeta w + p, w^2 p; and for
  /// the regulator of a double integrator 1 and the root of 3 (closed form).
  void fastSamplingIsContinuous() {
    const AxisModel fast{1e-5, 0};
    const AxisGains g = placedGains(fast, 7, 0.8, 4, true);
    QVERIFY(near(g.position, 49 + 2 * 0.8 * 7 * 4) < 1e-3);
    QVERIFY(near(g.rate, 2 * 0.8 * 7 + 4) < 1e-3);
    QVERIFY(near(g.integral / fast.period, 49 * 4) < 1e-3);
    QVERIFY(near(g.reference, 49) < 1e-3);
    const AxisGains optimal = optimalGains({1e-4, 0}, 1, 1, 1, 1, false);
    QVERIFY(near(optimal.position, 1) < 1e-3);
    QVERIFY(near(optimal.rate, std::sqrt(3.0)) < 1e-3);
  }

  /// The loop runs as it was designed: the set-point's step is that of the pair alone, from the
  /// first update on; with a lag that of pair and lag.
  void stepIsThatOfThePair_data() {
    QTest::addColumn<double>("lag");
    QTest::addRow("at once") << 0.0;
    QTest::addRow("behind a lag") << 0.05;
  }
  void stepIsThatOfThePair() {
    QFETCH(double, lag);
    StateFeedbackParameters p;
    p.rate = 2000;
    p.thrustLag = lag;
    RollAxis axis(p);
    // w^2/(s^2 + 2 zeta w s + w^2) behind 1/(1 + T s), by fine steps.
    double q = 0, v = 0, filtered = 0, worst = 0;
    constexpr int kFine = 50;
    const double h = axis.period / kFine, wanted = 0.05;
    axis.step(0);
    for (int k = 0; k < 4000; ++k) {
      axis.step(wanted);
      for (int i = 0; i < kFine; ++i) {
        filtered = lag > 0 ? filtered + h * (wanted - filtered) / lag : wanted;
        v += h * (49 * (filtered - q) - 11.2 * v);
        q += h * v;
      }
      worst = std::max(worst, std::abs(q - axis.angle));
    }
    QVERIFY2(worst < 0.005 * wanted, qPrintable(QString::number(worst / wanted)));
    QVERIFY(std::abs(axis.angle - wanted) < 1e-6);
  }

  /// A lasting disturbance d leaves d/k without an integral and nothing with one.
  void disturbance() {
    for (const auto stage : {FeedbackStage::Plain, FeedbackStage::Integral, FeedbackStage::Final}) {
      StateFeedbackParameters p;
      p.stage = stage;
      RollAxis axis(p);
      axis.disturbance = 0.5;
      for (int k = 0; k < 5000; ++k) axis.step(0);
      const double left =
          stage == FeedbackStage::Plain ? 0.5 / axis.controller.gains().position[1] : 0.0;
      QVERIFY2(std::abs(axis.angle - left) < 1e-9, qPrintable(QString::number(axis.angle)));
    }
    LqrParameters lqr;
    RollAxis axis(lqr);
    axis.disturbance = 0.5;
    for (int k = 0; k < 20000; ++k) axis.step(0);
    QVERIFY(std::abs(axis.angle) < 1e-9);
  }

  /// A step far beyond the limit overshoots by half at most of what the same law does whose
  /// integral winds up, and a disturbance beyond the limit is forgotten: coming back, the angle
  /// swings less than it was pushed.
  void nothingWindsUp() {
    const StateFeedbackParameters p = slowLimits(FeedbackStage::Final);
    RollAxis held(p);
    const AxisGains g = placedGains({1 / p.rate, 0}, 7, 0.8, 4, true);
    double most = 0, angle = 0, rate = 0, integral = 0, wound = 0;
    for (int k = 0; k < 5000; ++k) {
      held.step(1);
      most = std::max(most, held.angle - 1);
      const double wish = g.reference - g.position * angle - g.rate * rate + integral;
      const double demand = std::clamp(wish, -2.0, 2.0), h = held.period;
      integral += g.integral * (1 - angle);
      angle += rate * h + 0.5 * demand * h * h;
      rate += demand * h;
      wound = std::max(wound, angle - 1);
    }
    QVERIFY2(most < 0.3 && most < 0.5 * wound, qPrintable(QString("%1 %2").arg(most).arg(wound)));
    QVERIFY(std::abs(held.angle - 1) < 1e-4);
    RollAxis axis(slowLimits(FeedbackStage::Final));
    axis.disturbance = 4;
    for (int k = 0; k < 200; ++k) axis.step(0);
    QVERIFY(std::abs(axis.demand) <= 2 + 1e-12);
    const double pushed = axis.angle;
    axis.disturbance = 0;
    double back = 0;
    for (int k = 0; k < 10000; ++k) {
      axis.step(0);
      back = std::min(back, axis.angle);
    }
    QVERIFY(std::abs(axis.angle) < 1e-4);
    QVERIFY2(back > -pushed, qPrintable(QString("%1 %2").arg(back).arg(pushed)));
  }

  /// Other gains in flight: the demand does not jump where an integral takes it up.
  void retuneIsBumpless() {
    StateFeedbackParameters p;
    RollAxis axis(p);
    for (int k = 0; k < 100; ++k) axis.step(0.1);
    const double before = axis.demand;
    axis.step(0.1);
    const double slope = std::abs(axis.demand - before);
    p.roll.frequency = 12;
    p.roll.integral = 6;
    axis.controller.retune(p);
    const double last = axis.demand;
    axis.step(0.1);
    // Its slope is another now; a jump of the proportional part would be five hundred times that.
    QVERIFY2(std::abs(axis.demand - last) < 10 * slope,
             qPrintable(QString("%1 %2").arg(axis.demand - last).arg(slope)));
  }

  /// The flagship's flight by each: it ends, holds what it should and settles where it was sent.
  void flights_data() {
    QTest::addColumn<int>("which");
    QTest::addRow("poles") << 0;
    QTest::addRow("poles with the lag of the motors") << 1;
    QTest::addRow("weights") << 2;
  }
  void flights() {
    QFETCH(int, which);
    StateFeedbackParameters poles;
    if (which == 1) poles.thrustLag = 0.03;
    const Experiment e =
        which == 2 ? flownBy(LqrParameters{}) : flownBy(ControllerParameters(poles));
    const auto simulation = runToEnd(e);
    QCOMPARE(simulation->state(), SimulationState::Finished);
    QVERIFY(simulation->verdicts().empty());
    const Recording& r = *simulation->runs().front().recording;
    const auto at = [&](const char* name) { return r.value(*r.find(name), r.rows() - 1); };
    QVERIFY2(std::abs(at("position.z") - at("setpoint.z")) < 0.01,
             qPrintable(QString::number(at("position.z"))));
    for (const char* angle : {"roll", "pitch", "yaw"}) {
      const std::string name = angle;
      const double off = at(("attitude." + name).c_str()) - at(("setpoint." + name).c_str());
      QVERIFY2(std::abs(std::remainder(off, 2 * M_PI)) < 0.01, angle);
    }
  }

  /// A file says which, and is read back.
  void files() {
    for (const ControllerParameters& c :
         {ControllerParameters(StateFeedbackParameters{.stage = FeedbackStage::Integral}),
          ControllerParameters(LqrParameters{.integral = false})}) {
      const Experiment e = flownBy(c);
      const std::string text = writeExperiment(e);
      QVERIFY(readExperiment(text, "again.json") == e);
    }
    QVERIFY(writeExperiment(flownBy(StateFeedbackParameters{})).find("\"state-feedback\"") !=
            std::string::npos);
    QVERIFY(writeExperiment(flownBy(LqrParameters{})).find("\"lqr\"") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(TestStateFeedback)
#include "test_state_feedback.moc"
