// Rows CT are those of published examples; each test names its source.
#include <Eigen/Cholesky>
#include <QtTest>

#include "sim/core/error.h"
#include "sim/design/discretise.h"
#include "sim/design/lqr.h"
#include "sim/design/riccati.h"
#include "tests/sim/design/plants.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

using Matrix = Eigen::MatrixXd;

const Matrix kIntegrators{{0, 1}, {0, 0}}, kForce{{0}, {1}}, kOne{{1}};

Matrix identity(Eigen::Index n) {
  return Matrix::Identity(n, n);
}

QuadraticCost unitCost(const DesignPlant& plant) {
  return {identity(plant.A.rows()), identity(plant.B.cols()), {}};
}

/// A random cost with a cross weight: [Q N; N' R] = W' W.
QuadraticCost randomCost(RandomStream& random, Eigen::Index n, Eigen::Index m) {
  const Matrix w = randomPlant(random, n + m, 1).A;
  const Matrix all = w.transpose() * w;
  return {all.topLeftCorner(n, n), all.bottomRightCorner(m, m) + identity(m),
          all.topRightCorner(n, m)};
}

template <class Design>
std::string refusal(const Design& design) {
  try {
    design();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool definite(const Matrix& P) {
  // In units in which the diagonal is one.
  const Eigen::VectorXd size = P.diagonal().cwiseSqrt().cwiseInverse();
  return Matrix(size.asDiagonal() * P * size.asDiagonal()).llt().info() == Eigen::Success;
}

}  // namespace

class TestLqr : public QObject {
  Q_OBJECT
 private slots:
  void publishedContinuous();
  void publishedSampled();
  void publishedFilterByDuality();
  void riccatiEquations();
  void theCostIsTheIntegral();
  void noOtherGainIsCheaper();
  void scaledCostsAndUnits();
  void fineSamplingIsContinuous();
  void lyapunovAndStein();
  void delaysAreStates();
  void integralAction();
  void refusalsSayWhy();
};

void TestLqr::publishedContinuous() {
  // CT05, SLICOT SB02MD.
  const LqrDesign care = lqr(kIntegrators, kForce, {Matrix{{1, 0}, {0, 2}}, kOne});
  QVERIFY(relativeError(care.P, Matrix{{2, 1}, {1, 2}}) < 1e-12);
  QVERIFY(care.residual < 1e-14);
  // CT06, octave-control 3.4.0, care.m: four decimals.
  const Matrix c{{1, -1}};
  const LqrDesign printed =
      lqr(Matrix{{-3, 2}, {1, 1}}, Matrix{{0}, {1}}, {c.transpose() * c, Matrix{{3}}});
  QVERIFY((printed.gain - Matrix{{0.6072, 2.9396}}).cwiseAbs().maxCoeff() < 5e-5);
  QVERIFY(poleError(printed.poles, poleList({-3.5026, -1.4370})) < 5e-5);
  // CT07, closed form.
  const LqrDesign closed = lqr(kIntegrators, kForce, {identity(2), kOne});
  const double root = std::sqrt(3.0);
  QVERIFY(relativeError(closed.gain, Matrix{{1, root}}) < 1e-12);
  QVERIFY(relativeError(closed.P, Matrix{{root, 1}, {1, root}}) < 1e-12);
  QVERIFY(poleError(closed.poles, poleList({{-root / 2, 0.5}, {-root / 2, -0.5}})) < 1e-12);
}

/// CT08, octave-control 3.4.0, dare.m: four decimals.
void TestLqr::publishedSampled() {
  const Matrix c{{1, -1}};
  const LqrDesign design = sampledLqr(Matrix{{0.4, 1.7}, {0.9, 3.8}}, Matrix{{0.8}, {2.1}},
                                      {c.transpose() * c, Matrix{{3}}});
  QVERIFY((design.gain - Matrix{{0.4092, 1.7283}}).cwiseAbs().maxCoeff() < 5e-5);
  // One state: p^2 - p - 1 = 0 for a = b = q = r = 1.
  const LqrDesign golden = sampledLqr(kOne, kOne, {kOne, kOne});
  QVERIFY(std::abs(golden.P(0, 0) - (1 + std::sqrt(5.0)) / 2) < 1e-14);
}

/// CT11, octave-control 3.4.0, kalman.m: x' = -2 x + w, y = x + 3 w + v, all covariances 1. The
/// gain of the filter is that of the regulator of the transposed plant, its noise in y the cost.
void TestLqr::publishedFilterByDuality() {
  const LqrDesign filter =
      lqr(Matrix{{-2}}, kOne, {kOne, Matrix{{1 + 3 + 3 + 9}}, Matrix{{3 + 1}}});
  QVERIFY(std::abs(filter.gain(0, 0) - 0.25) < 1e-12);
}

void TestLqr::riccatiEquations() {
  RandomStream random(12, "Riccati");
  std::vector<DesignPlant> plants = designPlants();
  for (int i = 0; i < 30; ++i) plants.push_back(randomPlant(random, 1 + i % 7, 1 + i % 3));
  for (const DesignPlant& plant : plants) {
    const QuadraticCost cost = unitCost(plant);
    const LqrDesign design = lqr(plant.A, plant.B, cost);
    QVERIFY2(design.residual < 1e-11, plant.name.c_str());
    QVERIFY2(definite(design.P), plant.name.c_str());
    QVERIFY2(design.poles.real().maxCoeff() < 0, plant.name.c_str());
    QVERIFY(design.P == design.P.transpose());
    const LinearSystem sampled = holdSampled(stateSystem(plant.A, plant.B), plant.period);
    const LqrDesign steps = sampledLqr(sampled.A, sampled.B, cost);
    // Lengths in nanometres beside angles in radians leave fewer digits.
    QVERIFY2(steps.residual < (plant.name == "badly-scaled" ? 1e-10 : 1e-11),
             qPrintable(QString("%1 %2").arg(plant.name.c_str()).arg(steps.residual)));
    QVERIFY2(definite(steps.P), plant.name.c_str());
    QVERIFY2(steps.poles.cwiseAbs().maxCoeff() < 1, plant.name.c_str());
  }
}

/// x' P x is what the closed loop will have cost, cross weights included.
void TestLqr::theCostIsTheIntegral() {
  RandomStream random(12, "cost");
  for (int i = 0; i < 20; ++i) {
    const DesignPlant plant = randomPlant(random, 2 + i % 4, 1 + i % 2);
    const QuadraticCost cost = randomCost(random, plant.A.rows(), plant.B.cols());
    const LqrDesign design = lqr(plant.A, plant.B, cost);
    const auto rate = [&](const Matrix& K) -> Matrix {
      return cost.Q + K.transpose() * cost.R * K - cost.N * K - K.transpose() * cost.N.transpose();
    };
    // Summed exactly over steps of the closed loop: Van Loan's integral by doubling.
    const Matrix closed = plant.A - plant.B * design.gain;
    const double h = 1e-3;
    const Matrix step = matrixExponential(closed * h);
    Matrix one = Matrix::Zero(plant.A.rows(), plant.A.rows());
    // Simpson's rule within a step.
    const Matrix half = matrixExponential(closed * (h / 2));
    const Matrix w = rate(design.gain);
    one = h / 6 * (w + 4 * half.transpose() * w * half + step.transpose() * w * step);
    const Matrix whole = solveStein(step, one);
    QVERIFY2((whole - design.P).norm() < 1e-6 * design.P.norm(), plant.name.c_str());
    const LinearSystem sampled = holdSampled(stateSystem(plant.A, plant.B), 0.1);
    const LqrDesign steps = sampledLqr(sampled.A, sampled.B, cost);
    Matrix sum = Matrix::Zero(plant.A.rows(), plant.A.rows()), power = identity(plant.A.rows());
    for (int k = 0; k < 20000 && power.norm() > 1e-9; ++k) {
      sum += power.transpose() * rate(steps.gain) * power;
      power = ((sampled.A - sampled.B * steps.gain) * power).eval();
    }
    QVERIFY2((sum - steps.P).norm() < 1e-9 * steps.P.norm(), plant.name.c_str());
  }
}

void TestLqr::noOtherGainIsCheaper() {
  RandomStream random(12, "neighbours");
  for (int i = 0; i < 20; ++i) {
    const DesignPlant plant = randomPlant(random, 2 + i % 4, 1 + i % 2);
    const LqrDesign design = lqr(plant.A, plant.B, unitCost(plant));
    for (int turn = 0; turn < 5; ++turn) {
      const Matrix off = randomPlant(random, design.gain.cols(), design.gain.rows()).B.transpose();
      const Matrix other = design.gain + 1e-3 * off;
      const Matrix price = solveLyapunov(plant.A - plant.B * other,
                                         identity(plant.A.rows()) + other.transpose() * other);
      QVERIFY(price.trace() > design.P.trace());
    }
  }
}

/// Twice the cost has the same gain and twice the P; other units of states and inputs change the
/// gain by their ratio.
void TestLqr::scaledCostsAndUnits() {
  for (const DesignPlant& plant : designPlants()) {
    const Eigen::Index n = plant.A.rows();
    const LqrDesign once = lqr(plant.A, plant.B, unitCost(plant));
    const LqrDesign twice = lqr(plant.A, plant.B, {2 * identity(n), 2 * identity(plant.B.cols())});
    QVERIFY2(relativeError(twice.gain, once.gain) < 1e-9, plant.name.c_str());
    QVERIFY2((twice.P - 2 * once.P).norm() < 1e-9 * twice.P.norm(), plant.name.c_str());
    const Eigen::VectorXd unit = Eigen::VectorXd::LinSpaced(n, -4, 5).unaryExpr(
        [](double power) { return std::pow(10, power); });
    const Matrix d = unit.asDiagonal(), back = unit.cwiseInverse().asDiagonal();
    const LqrDesign other =
        lqr(back * plant.A * d, back * plant.B, {d * d, identity(plant.B.cols())});
    const double off = relativeError(other.gain, once.gain * d);
    QVERIFY2(off < (plant.name == "badly-scaled" ? 1e-6 : 1e-8),
             qPrintable(QString("%1 %2").arg(plant.name.c_str()).arg(off)));
  }
}

/// With the cost over a short period the sampled regulator is the continuous one.
void TestLqr::fineSamplingIsContinuous() {
  const DesignPlant plant = designPlants()[0];
  const double T = 1e-5;
  const LinearSystem sampled = holdSampled(stateSystem(plant.A, plant.B), T);
  const LqrDesign steps = sampledLqr(sampled.A, sampled.B, {T * identity(2), T * kOne});
  QVERIFY(relativeError(steps.gain, lqr(plant.A, plant.B, unitCost(plant)).gain) < 5e-5);
}

void TestLqr::lyapunovAndStein() {
  RandomStream random(12, "Lyapunov");
  for (int i = 0; i < 20; ++i) {
    const Eigen::Index n = 1 + i % 6;
    const DesignPlant plant = randomPlant(random, n, 1);
    const double edge = poles(plant.A).real().maxCoeff();
    const Matrix stable = plant.A - (edge + 0.3) * identity(n);
    const Matrix q = plant.B * plant.B.transpose();
    const Matrix x = solveLyapunov(stable, q);
    QVERIFY((stable.transpose() * x + x * stable + q).norm() < 1e-12 * x.norm() * stable.norm());
    const Matrix inside = plant.A * (0.95 / poles(plant.A).cwiseAbs().maxCoeff());
    const Matrix y = solveStein(inside, q);
    QVERIFY((inside.transpose() * y * inside + q - y).norm() < 1e-12 * y.norm());
  }
}

/// A sampled plant with two and a half periods of delay: its model is singular.
void TestLqr::delaysAreStates() {
  for (const DesignPlant& plant : designPlants()) {
    const LinearSystem sampled =
        holdSampled(stateSystem(plant.A, plant.B), plant.period, 2.5 * plant.period);
    const Eigen::Index n = plant.A.rows(), all = sampled.A.rows();
    Matrix Q = Matrix::Zero(all, all);
    Q.topLeftCorner(n, n).setIdentity();
    const LqrDesign design = sampledLqr(sampled.A, sampled.B, {Q, identity(plant.B.cols())});
    QVERIFY2(design.residual < 1e-11, plant.name.c_str());
    QVERIFY2(design.poles.cwiseAbs().maxCoeff() < 1, plant.name.c_str());
  }
}

void TestLqr::integralAction() {
  const DesignPlant roll = designPlants()[1];
  LinearSystem plant = stateSystem(roll.A, roll.B);
  plant.C = Matrix{{1, 0, 0}};
  plant.D = Matrix{{0}};
  const QuadraticCost cost =
      brysonCost(Eigen::Vector4d(0.1, 1, 0.1, 0.02), Eigen::VectorXd::Constant(1, 0.1));
  QVERIFY(std::abs(cost.Q(3, 3) - 2500) < 1e-9);
  const LqiDesign design = lqi(plant, cost);
  QCOMPARE(design.gain.state.cols(), 3);
  // An integral of -y, fed back with a minus: its gain pushes towards the set-point.
  QVERIFY(design.gain.integral(0, 0) < 0);
  // Integral gain of a single integrator chain: sqrt(q / r).
  QVERIFY(std::abs(design.gain.integral(0, 0) + std::sqrt(2500 * 0.01)) < 1e-9);
  QVERIFY(design.all.poles.real().maxCoeff() < 0);
  const double T = 0.004;
  const LqiDesign steps = sampledLqi(holdSampled(plant, T), T, cost);
  QVERIFY(steps.all.poles.cwiseAbs().maxCoeff() < 1);
  QVERIFY(relativeError(steps.gain.state, design.gain.state) < 0.2);
}

void TestLqr::refusalsSayWhy() {
  const auto says = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  const Matrix A{{1, 0}, {0, -2}}, B{{1}, {0}}, stuck{{0}, {1}};
  const auto continuous = [&](const Matrix& a, const Matrix& b, const QuadraticCost& cost) {
    return refusal([&] { lqr(a, b, cost); });
  };
  QVERIFY(continuous(A, B, {identity(2), kOne}).empty());
  QVERIFY(says(continuous(A, stuck, {identity(2), kOne}), "no input stabilises the mode at 1"));
  QVERIFY(says(continuous(A, B, {Matrix{{0, 0}, {0, 1}}, kOne}), "does not see the mode at 1"));
  QVERIFY(says(continuous(kIntegrators, kForce, {Matrix{{0, 0}, {0, 1}}, kOne}),
               "does not see the mode at 0"));
  QVERIFY(says(continuous(A, B, {Matrix{{1, 2}, {2, 1}}, kOne}), "Q is not positive semidef"));
  QVERIFY(says(continuous(A, B, {Matrix{{1, 2}, {0, 1}}, kOne}), "Q is not symmetric"));
  QVERIFY(says(continuous(A, B, {identity(3), kOne}), "size"));
  QVERIFY(says(continuous(A, B, {identity(2), Matrix{{0}}}), "R is not positive definite"));
  QVERIFY(says(continuous(A, B, {identity(2), kOne, Matrix{{2}, {0}}}), "together"));
  QVERIFY(says(continuous(A, B, {identity(2), kOne, Matrix{{2, 0}}}), "as large as B"));
  QVERIFY(says(continuous(A, B, {Matrix::Constant(2, 2, NAN), kOne}), "no number"));
  const auto sampled = [&](const Matrix& b, const QuadraticCost& cost) {
    return refusal([&] { sampledLqr(Matrix{{1, 0}, {0, 0.5}}, b, cost); });
  };
  QVERIFY(sampled(B, {identity(2), kOne}).empty());
  QVERIFY(says(sampled(stuck, {identity(2), kOne}), "no input stabilises the mode at 1"));
  QVERIFY(says(sampled(B, {Matrix{{0, 0}, {0, 1}}, kOne}), "does not see the mode at 1"));
  QVERIFY_THROWS_EXCEPTION(InputError, brysonCost(Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1)));
}

QTEST_GUILESS_MAIN(TestLqr)
#include "test_lqr.moc"
