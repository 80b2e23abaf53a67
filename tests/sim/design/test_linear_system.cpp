#include <QtTest>
#include <numbers>

#include "sim/core/error.h"
#include "sim/design/balancing.h"
#include "sim/design/linear_system.h"
#include "sim/design/polynomial.h"
#include "tests/sim/design/plants.h"

using namespace rotorbench;
using namespace rotorbench::test;

class TestLinearSystem : public QObject {
  Q_OBJECT
 private slots:
  void plantsAreControllable();
  void aModeNoInputReaches();
  void hiddenByATransformation();
  void observabilityIsTheDual();
  void farApartPolesAreNoLoss();
  void roundingIsNoReach();
  void everyInputIsAnAxis();
  void polesDoNotDependOnUnits();
  void polynomials();
  void conjugatesArePairs();
  void wrongShapesAreRefused();
};

/// All eight: the rank of S and the staircase agree.
void TestLinearSystem::plantsAreControllable() {
  for (const DesignPlant& plant : designPlants()) {
    const RankReport report = controllability(plant.A, plant.B);
    QVERIFY2(report.rank == plant.A.rows(), plant.name.c_str());
    QCOMPARE(report.matrix.cols(), plant.A.rows() * plant.B.cols());
    QVERIFY((report.matrix.leftCols(plant.B.cols()) - plant.B).isZero(0));
    QVERIFY2(uncontrollableModes(plant.A, plant.B).size() == 0, plant.name.c_str());
  }
}

void TestLinearSystem::aModeNoInputReaches() {
  const Eigen::MatrixXd A{{1, 1, 0}, {0, -2, 0}, {1, 0, 3}}, B{{1}, {0}, {0}};
  QCOMPARE(controllability(A, B).rank, 2);
  const Eigen::VectorXcd stuck = uncontrollableModes(A, B);
  QCOMPARE(stuck.size(), 1);
  QVERIFY(std::abs(stuck[0] + 2.0) < 1e-12);
}

/// Two stuck modes, a pair, of random plants seen through random coordinates.
void TestLinearSystem::hiddenByATransformation() {
  RandomStream random(12, "hidden modes");
  for (int turn = 0; turn < 40; ++turn) {
    const Eigen::Index n = 3 + turn % 5, m = 1 + turn % 2;
    DesignPlant plant = randomPlant(random, n, m);
    plant.A.bottomLeftCorner(2, n - 2).setZero();
    plant.A.bottomRightCorner(2, 2) = Eigen::Matrix2d{{-1, 4}, {-4, -1}};
    plant.B.bottomRows(2).setZero();
    const Eigen::MatrixXd t = randomPlant(random, n, 1).A + 3 * Eigen::MatrixXd::Identity(n, n);
    const Eigen::MatrixXd A = t * plant.A * t.inverse(), B = t * plant.B;
    const Eigen::VectorXcd stuck = uncontrollableModes(A, B);
    QCOMPARE(stuck.size(), 2);
    QVERIFY(poleError(stuck, poleList({{-1, 4}, {-1, -4}})) < 1e-8);
    QCOMPARE(unobservableModes(A.transpose(), B.transpose()).size(), 2);
  }
}

void TestLinearSystem::observabilityIsTheDual() {
  const Eigen::MatrixXd A{{0, 1}, {0, 0}};
  QCOMPARE(observability(A, Eigen::MatrixXd{{1, 0}}).rank, 2);
  QVERIFY(observability(A, Eigen::MatrixXd{{1, 0}}).matrix == Eigen::MatrixXd::Identity(2, 2));
  QCOMPARE(observability(A, Eigen::MatrixXd{{0, 1}}).rank, 1);
  const Eigen::VectorXcd hidden = unobservableModes(A, Eigen::MatrixXd{{0, 1}});
  QCOMPARE(hidden.size(), 1);
  QVERIFY(std::abs(hidden[0]) == 0);
}

/// Position over attitude over motor, winding and filter: poles from 0 to 10^5 1/s. The powers of A
/// alone span 10^25; S has full rank all the same.
void TestLinearSystem::farApartPolesAreNoLoss() {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(7, 7), B = Eigen::MatrixXd::Zero(7, 1);
  A.diagonal<1>() << 1, 9.81, 1, 200, 20, 1e5;
  A.diagonal() << 0, 0, 0, 0, -20, -3e3, -1e5;
  B(6) = 1e5;
  QCOMPARE(controllability(A, B).rank, 7);
  QCOMPARE(uncontrollableModes(A, B).size(), 0);
}

/// An arm at cos(pi/2) turns nothing.
void TestLinearSystem::roundingIsNoReach() {
  const double none = std::cos(std::numbers::pi / 2);
  QVERIFY(none != 0);
  const Eigen::MatrixXd A{{0, 1, 0}, {0, 0, 0}, {0, 0, -3}};
  const Eigen::MatrixXd B{{0, 0}, {none, -none}, {1, 1}};
  QCOMPARE(controllability(A, B).rank, 1);
  QCOMPARE(uncontrollableModes(A, B).size(), 2);
}

void TestLinearSystem::everyInputIsAnAxis() {
  // Height by thrust, roll by its moment, and an input that does nothing.
  LinearSystem system =
      stateSystem(Eigen::MatrixXd{{0, 0, 1, 0}, {0, 0, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}},
                  Eigen::MatrixXd{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0, 200, 0}});
  system.inputs = {"thrust", "roll moment", "nothing"};
  const auto axes = controllabilityByInput(system);
  QCOMPARE(axes.size(), 3U);
  QVERIFY((axes[0].states == std::vector<Eigen::Index>{0, 2}));
  QVERIFY((axes[1].states == std::vector<Eigen::Index>{1, 3}));
  for (int i : {0, 1}) {
    QVERIFY(axes[static_cast<std::size_t>(i)].controllable());
    QCOMPARE(axes[static_cast<std::size_t>(i)].kalman.rank, 2);
  }
  QVERIFY((axes[1].kalman.matrix == Eigen::MatrixXd{{0, 200}, {200, 0}}));
  QVERIFY(!axes[2].controllable());
  // Two like integrators behind one input: it reaches both and moves them together only.
  const auto twins =
      controllabilityByInput(stateSystem(Eigen::MatrixXd::Zero(2, 2), Eigen::MatrixXd{{1}, {1}}));
  QCOMPARE(twins[0].states.size(), 2U);
  QVERIFY(!twins[0].controllable());
  QCOMPARE(twins[0].kalman.rank, 1);
}

void TestLinearSystem::polesDoNotDependOnUnits() {
  RandomStream random(12, "units");
  for (int turn = 0; turn < 20; ++turn) {
    const Eigen::MatrixXd A = randomPlant(random, 5, 1).A;
    Eigen::VectorXd unit(5);
    for (double& u : unit) u = std::pow(10, 12 * random.uniform() - 6);
    const Eigen::MatrixXd other = unit.cwiseInverse().asDiagonal() * A * unit.asDiagonal();
    QVERIFY(poleError(poles(other), poles(A)) < 1e-11);
    QVERIFY(relativeError(characteristicPolynomial(other), characteristicPolynomial(A)) < 1e-11);
  }
  const Eigen::VectorXcd sorted = poles(Eigen::MatrixXd{{0, 1, 0}, {-4, -2, 0}, {0, 0, -9}});
  QVERIFY(std::abs(sorted[0] + 9.0) < 1e-12);
  QVERIFY(sorted[1].imag() > 0 && sorted[2] == std::conj(sorted[1]));
}

void TestLinearSystem::polynomials() {
  const Eigen::VectorXcd cube = poleList({-1, -1, -1});
  QVERIFY(polynomialOf(cube) == Eigen::Vector4d(1, 3, 3, 1));
  QVERIFY(polynomialOf(poleList({{-10, 1}, {-10, -1}})) == Eigen::Vector3d(1, 20, 101));
  // (s^2 + 3 s + 2)(s - 5)
  const Eigen::MatrixXd A{{0, 1, 7}, {-2, -3, 1}, {0, 0, 5}};
  QVERIFY(relativeError(characteristicPolynomial(A), Eigen::Vector4d(1, -2, -13, -10)) < 1e-14);
  RandomStream random(12, "polynomials");
  for (int turn = 0; turn < 30; ++turn) {
    const DesignPlant plant = randomPlant(random, 1 + turn % 9, 1);
    QVERIFY(polynomialError(plant.A, poles(plant.A)) < 1e-12);
    const Eigen::MatrixXd less =
        plant.A - 0.01 * Eigen::MatrixXd::Identity(turn % 9 + 1, turn % 9 + 1);
    QVERIFY(polynomialError(less, poles(plant.A)) > 1e-4);
  }
}

void TestLinearSystem::conjugatesArePairs() {
  const auto factors = factorsOf(poleList({{-1, 2}, -3, {-1, -2}, -3}));
  QCOMPARE(factors.size(), 3U);
  QVERIFY(factors[0].pair() && !factors[1].pair());
  try {
    factorsOf(poleList({{-1, 2}, {-1, 2}}));
    QFAIL("not refused");
  } catch (const InputError& error) {
    QVERIFY2(std::string(error.what()).find("-1 + 2i") != std::string::npos, error.what());
  }
  QVERIFY(poleListText(poleList({{-1, 2}, {-1, -2}, -3, 0})) == "-1 ± 2i, -3 and 0");
}

void TestLinearSystem::wrongShapesAreRefused() {
  const Eigen::MatrixXd square = Eigen::MatrixXd::Zero(2, 2), wide = Eigen::MatrixXd::Zero(1, 2);
  QVERIFY_THROWS_EXCEPTION(InputError, poles(wide));
  QVERIFY_THROWS_EXCEPTION(InputError, stateSystem(square, wide));
  QVERIFY_THROWS_EXCEPTION(InputError, controllability(square, wide));
  QVERIFY_THROWS_EXCEPTION(InputError, checkSystem({square, square, wide, square, {}, {}, {}}));
  QVERIFY_THROWS_EXCEPTION(InputError, checkSystem({square, square, wide, wide, {"one"}, {}, {}}));
  QVERIFY_THROWS_EXCEPTION(InputError, poles(Eigen::MatrixXd::Constant(2, 2, NAN)));
}

QTEST_GUILESS_MAIN(TestLinearSystem)
#include "test_linear_system.moc"
