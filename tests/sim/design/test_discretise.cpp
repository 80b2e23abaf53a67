#include <Eigen/LU>
#include <QtTest>
#include <numbers>

#include "sim/core/error.h"
#include "sim/design/discretise.h"
#include "tests/sim/design/plants.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

/// x after t with u held, by `steps` steps of Runge and Kutta's method.
Eigen::VectorXd integrated(const DesignPlant& plant, Eigen::VectorXd x, const Eigen::VectorXd& u,
                           double t, int steps) {
  const auto rate = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    return plant.A * at + plant.B * u;
  };
  const double h = t / steps;
  for (int i = 0; i < steps; ++i) {
    const Eigen::VectorXd a = rate(x), b = rate(x + h / 2 * a), c = rate(x + h / 2 * b),
                          d = rate(x + h * c);
    x += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return x;
}

Eigen::MatrixXcd response(const LinearSystem& system, std::complex<double> s) {
  const Eigen::Index n = system.A.rows();
  using Complex = std::complex<double>;
  const Eigen::MatrixXcd resolvent =
      s * Eigen::MatrixXcd::Identity(n, n) - system.A.cast<Complex>();
  const Eigen::MatrixXcd states = resolvent.partialPivLu().solve(system.B.cast<Complex>());
  return system.C.cast<Complex>() * states + system.D.cast<Complex>();
}

}  // namespace

class TestDiscretise : public QObject {
  Q_OBJECT
 private slots:
  void exponentials();
  void closedForms();
  void heldInputsAgainstIntegration_data();
  void heldInputsAgainstIntegration();
  void twoPeriodsAreOneTwiceAsLong();
  void halfADelayIsAPeriodOfHalfTheLength();
  void wholeDelaysAreShifts();
  void directPathsAreDelayedToo();
  void polesGoThereAndBack();
  void tustinKeepsTheResponse();
  void nonsenseIsRefused();
};

void TestDiscretise::exponentials() {
  const double w = 3;
  const Eigen::MatrixXd turn = matrixExponential(Eigen::MatrixXd{{0, -w}, {w, 0}});
  QVERIFY(turn.isApprox(Eigen::MatrixXd{{std::cos(w), -std::sin(w)}, {std::sin(w), std::cos(w)}},
                        1e-14));
  // Units a thousand million apart: still to the last digits.
  const Eigen::MatrixXd alike{{-1, 1}, {1, -2}};
  const Eigen::Vector2d unit(1e9, 1);
  const Eigen::MatrixXd e = matrixExponential(unit.asDiagonal() * alike *
                                              unit.cwiseInverse().asDiagonal().toDenseMatrix());
  const Eigen::MatrixXd wanted = unit.asDiagonal() * matrixExponential(alike) *
                                 unit.cwiseInverse().asDiagonal().toDenseMatrix();
  const double off = relativeError(e, wanted);
  QVERIFY2(off < 1e-14, qPrintable(QString::number(off)));
  RandomStream random(12, "exponentials");
  for (int turn2 = 0; turn2 < 20; ++turn2) {
    const Eigen::MatrixXd A = randomPlant(random, 2 + turn2 % 6, 1).A;
    const Eigen::Index n = A.rows();
    QVERIFY(
        (matrixExponential(A) * matrixExponential(-A) - Eigen::MatrixXd::Identity(n, n)).norm() <
        1e-11 * matrixExponential(A).norm() * matrixExponential(-A).norm());
    QVERIFY(std::abs(std::log(matrixExponential(A).determinant()) - A.trace()) < 1e-8);
  }
}

/// Åström and Wittenmark: the double integrator, and a lag with a delay of a fraction of the
/// period.
void TestDiscretise::closedForms() {
  const double T = 0.3;
  const LinearSystem twice =
      holdSampled(stateSystem(Eigen::MatrixXd{{0, 1}, {0, 0}}, Eigen::MatrixXd{{0}, {1}}), T);
  QVERIFY(twice.A.isApprox(Eigen::MatrixXd{{1, T}, {0, 1}}, 1e-15));
  QVERIFY(twice.B.isApprox(Eigen::MatrixXd{{T * T / 2}, {T}}, 1e-15));
  const double delay = 0.1;
  const LinearSystem lag =
      holdSampled(stateSystem(Eigen::MatrixXd{{-1}}, Eigen::MatrixXd{{1}}), T, delay);
  const double older = std::exp(-(T - delay)) - std::exp(-T);
  QVERIFY(lag.A.isApprox(Eigen::MatrixXd{{std::exp(-T), older}, {0, 0}}, 1e-15));
  QVERIFY(lag.B.isApprox(Eigen::MatrixXd{{1 - std::exp(-(T - delay))}, {1}}, 1e-15));
}

void TestDiscretise::heldInputsAgainstIntegration_data() {
  QTest::addColumn<double>("delay");  // periods
  for (const double delay : {0.0, 0.001, 0.3, 0.999, 1.0, 1.25, 2.0, 3.7})
    QTest::addRow("%g periods", delay) << delay;
}

/// Ten periods of random inputs into the eight plants and random ones.
void TestDiscretise::heldInputsAgainstIntegration() {
  QFETCH(double, delay);
  RandomStream random(12, "held inputs");
  std::vector<DesignPlant> plants = designPlants();
  for (int i = 0; i < 8; ++i) plants.push_back(randomPlant(random, 2 + i % 5, 1 + i % 3));
  for (const DesignPlant& plant : plants) {
    const Eigen::Index n = plant.A.rows(), m = plant.B.cols();
    const double T = plant.period;
    const LinearSystem sampled = holdSampled(stateSystem(plant.A, plant.B), T, delay * T);
    const int onTheWay = static_cast<int>(std::ceil(delay));
    QCOMPARE(sampled.A.rows(), n + m * onTheWay);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n), all = Eigen::VectorXd::Zero(sampled.A.rows());
    Eigen::VectorXd size = Eigen::VectorXd::Zero(n);
    // inputs[k + onTheWay] is given at the instant k; nothing before.
    std::vector<Eigen::VectorXd> inputs(static_cast<std::size_t>(onTheWay),
                                        Eigen::VectorXd::Zero(m));
    const double late =
        onTheWay - delay;  // periods from which on the newer one is at work: 1 - this
    for (std::size_t k = 0; k < 10; ++k) {
      Eigen::VectorXd u(m);
      for (double& value : u) value = random.normal();
      inputs.push_back(u);
      x = integrated(plant, x, inputs[k], (onTheWay == 0 ? 1 : 1 - late) * T, 200);
      if (onTheWay > 0) x = integrated(plant, x, inputs[k + 1], late * T, 200);
      all = sampled.A * all + sampled.B * u;
      size = size.cwiseMax(x.cwiseAbs());
      QVERIFY2(((all.head(n) - x).array().abs() <= 1e-9 * size.array()).all(), plant.name.c_str());
    }
  }
}

void TestDiscretise::twoPeriodsAreOneTwiceAsLong() {
  for (const DesignPlant& plant : designPlants()) {
    const LinearSystem one = holdSampled(stateSystem(plant.A, plant.B), plant.period);
    const LinearSystem two = holdSampled(stateSystem(plant.A, plant.B), 2 * plant.period);
    QVERIFY2(relativeError(two.A, one.A * one.A) < 1e-11, plant.name.c_str());
    QVERIFY2(relativeError(two.B, one.A * one.B + one.B) < 1e-11, plant.name.c_str());
  }
}

void TestDiscretise::halfADelayIsAPeriodOfHalfTheLength() {
  for (const DesignPlant& plant : designPlants()) {
    const Eigen::Index n = plant.A.rows(), m = plant.B.cols();
    const LinearSystem late =
        holdSampled(stateSystem(plant.A, plant.B), plant.period, plant.period / 2);
    const LinearSystem half = holdSampled(stateSystem(plant.A, plant.B), plant.period / 2);
    QVERIFY(relativeError(late.A.block(0, n, n, m), half.A * half.B) < 1e-11);
    QVERIFY(relativeError(late.B.topRows(n), half.B) < 1e-11);
  }
}

/// Two periods of delay: the poles of the undelayed model and one at zero for each input on its
/// way.
void TestDiscretise::wholeDelaysAreShifts() {
  const DesignPlant plant = designPlants()[5];
  LinearSystem system = stateSystem(plant.A, plant.B);
  system.states = {"a", "b", "c", "d"};
  system.inputs = {"heat", "flow"};
  const LinearSystem now = holdSampled(system, 0.1);
  // As computed from two decimal numbers, so not quite whole.
  const LinearSystem later = holdSampled(system, 0.1, 0.1 + 0.1 + 1e-17);
  const std::complex<double> z = std::polar(1.0, 0.4);
  QVERIFY(response(later, z).isApprox(response(now, z) / (z * z), 1e-12));
  QCOMPARE(later.states.size(), 8U);
  QVERIFY(later.states[4] == "heat, 2 periods ago");
  QVERIFY(later.states[7] == "flow, 1 period ago");
}

void TestDiscretise::directPathsAreDelayedToo() {
  LinearSystem system = stateSystem(Eigen::MatrixXd{{-1}}, Eigen::MatrixXd{{0}});
  system.D = Eigen::MatrixXd{{5}};
  const std::complex<double> z = std::polar(1.0, 0.7);
  QCOMPARE(holdSampled(system, 0.2).D(0, 0), 5.0);
  QVERIFY(std::abs(response(holdSampled(system, 0.2, 0.1), z)(0, 0) - 5.0 / z) < 1e-14);
  QVERIFY(std::abs(response(holdSampled(system, 0.2, 0.5), z)(0, 0) - 5.0 / (z * z * z)) < 1e-14);
}

void TestDiscretise::polesGoThereAndBack() {
  for (const DesignPlant& plant : designPlants()) {
    const Eigen::VectorXcd wanted = plant.poles();
    QVERIFY(poleError(continuousPoles(sampledPoles(wanted, plant.period), plant.period), wanted) <
            1e-13);
  }
  const DesignPlant reactor = designPlants()[5];
  const LinearSystem sampled = holdSampled(stateSystem(reactor.A, reactor.B), reactor.period);
  QVERIFY(poleError(continuousPoles(poles(sampled.A), reactor.period), poles(reactor.A)) < 1e-12);
  const Eigen::VectorXcd none = continuousPoles(Eigen::VectorXcd::Zero(1), 0.1);
  QVERIFY(none[0].real() == -INFINITY);
  // Below zero: half the rate of sampling.
  const Eigen::VectorXcd ringing = continuousPoles(Eigen::VectorXcd::Constant(1, -0.5), 0.1);
  QVERIFY(std::abs(ringing[0] - std::complex(std::log(0.5), std::numbers::pi) / 0.1) < 1e-12);
}

void TestDiscretise::tustinKeepsTheResponse() {
  RandomStream random(12, "Tustin");
  for (int turn = 0; turn < 10; ++turn) {
    const DesignPlant plant = randomPlant(random, 2 + turn % 5, 2);
    LinearSystem system = stateSystem(plant.A, plant.B);
    system.D.setConstant(0.3);
    const double T = 0.17;
    const LinearSystem sampled = tustinSampled(system, T);
    for (const double angle : {0.1, 1.0, 2.5}) {
      const std::complex<double> z = std::polar(1.0, angle);
      QVERIFY(
          response(sampled, z).isApprox(response(system, 2 / T * (z - 1.0) / (z + 1.0)), 1e-10));
    }
  }
}

void TestDiscretise::nonsenseIsRefused() {
  const LinearSystem lag = stateSystem(Eigen::MatrixXd{{-1}}, Eigen::MatrixXd{{1}});
  QVERIFY_THROWS_EXCEPTION(InputError, holdSampled(lag, 0));
  QVERIFY_THROWS_EXCEPTION(InputError, holdSampled(lag, NAN));
  QVERIFY_THROWS_EXCEPTION(InputError, holdSampled(lag, 0.1, -0.01));
  QVERIFY_THROWS_EXCEPTION(InputError, holdSampled(lag, 1e-6, 1));
  QVERIFY_THROWS_EXCEPTION(InputError, holdSampled(lag, 0.1, INFINITY));
  QVERIFY_THROWS_EXCEPTION(InputError, continuousPoles(Eigen::VectorXcd::Zero(1), -1));
  const LinearSystem explosive = stateSystem(Eigen::MatrixXd{{1e4}}, Eigen::MatrixXd{{1}});
  QVERIFY_THROWS_EXCEPTION(InputError, holdSampled(explosive, 1));
  const LinearSystem mirrored = stateSystem(Eigen::MatrixXd{{20}}, Eigen::MatrixXd{{1}});
  QVERIFY_THROWS_EXCEPTION(InputError, tustinSampled(mirrored, 0.1));
}

QTEST_GUILESS_MAIN(TestDiscretise)
#include "test_discretise.moc"
