// Rows CT are those of published examples; each test names its source.
#include <Eigen/LU>
#include <QtTest>

#include "sim/core/error.h"
#include "sim/design/discretise.h"
#include "sim/design/integral_action.h"
#include "sim/design/placement.h"
#include "sim/design/polynomial.h"
#include "tests/sim/design/plants.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

/// What a placement says when it refuses; empty if it does not.
std::string refusal(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                    const Eigen::VectorXcd& wanted) {
  try {
    placePoles(A, B, wanted);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// The largest relative error of the coefficients of det(s I - A + B K).
double coefficientError(const DesignPlant& plant, const Eigen::MatrixXd& gain) {
  return relativeError(characteristicPolynomial(plant.A - plant.B * gain),
                       polynomialOf(plant.poles()));
}

}  // namespace

class TestPlacement : public QObject {
  Q_OBJECT
 private slots:
  void publishedGains_data();
  void publishedGains();
  void publishedPolesOfSeveralInputs();
  void polesAreWherePlaced_data();
  void polesAreWherePlaced();
  void randomPlants();
  void sampledPlants();
  void robustBeatsOneInputAlone();
  void inputsInOneDirection();
  void unusedInputs();
  void repeatedPoles();
  void integralActionHoldsTheOutput();
  void refusalsSayWhy();
};

void TestPlacement::publishedGains_data() {
  QTest::addColumn<Eigen::MatrixXd>("A");
  QTest::addColumn<Eigen::MatrixXd>("b");
  QTest::addColumn<Eigen::VectorXcd>("wanted");
  QTest::addColumn<Eigen::MatrixXd>("gain");
  QTest::addColumn<double>("tolerance");
  using Matrix = Eigen::MatrixXd;
  const double ixx = 4.856e-3;
  QTest::addRow("CT01, octave-control 3.4.0, place.m")
      << Matrix{{0, 1}, {3, 2}} << Matrix{{0}, {1}} << poleList({-1, -0.5}) << Matrix{{3.5, 3.5}}
      << 1e-12;
  QTest::addRow("CT02, octave-control 3.4.0, acker.m")
      << Matrix{{1, 1}, {1, 2}} << Matrix{{1}, {0}} << poleList({-5, -6}) << Matrix{{14, 57}}
      << 1e-12;
  QTest::addRow("CT03, SLICOT SB01MD")
      << Matrix{{-1, 0, 2, -3}, {1, -4, 3, -1}, {0, 2, 4, -5}, {0, 0, -1, -2}}
      << Matrix{{1}, {0}, {0}, {0}} << poleList({-1, -1, -1, -1}) << Matrix{{1, 29, 93, -76}}
      << 1e-12;
  QTest::addRow("CT12, closed form, inertia of Luukkonen")
      << Matrix{{0, 1}, {0, 0}} << Matrix{{0}, {1 / ixx}} << poleList({{-10, 1}, {-10, -1}})
      << Matrix{{0.490456, 0.09712}} << 1e-12;
}

void TestPlacement::publishedGains() {
  QFETCH(Eigen::MatrixXd, A);
  QFETCH(Eigen::MatrixXd, b);
  QFETCH(Eigen::VectorXcd, wanted);
  QFETCH(Eigen::MatrixXd, gain);
  QFETCH(double, tolerance);
  QVERIFY(relativeError(placeSingleInput(A, b, wanted), gain) < tolerance);
  QVERIFY(relativeError(ackermann(A, b, wanted), gain) < tolerance);
  QVERIFY(relativeError(placePoles(A, b, wanted).gain, gain) < tolerance);
}

/// CT04, SLICOT SB01BD: two poles of four moved. Gains are not unique: the published one leads to
/// the published poles, ours to the same.
void TestPlacement::publishedPolesOfSeveralInputs() {
  const Eigen::MatrixXd A{{-6.8, 0, -207, 0}, {1, 0, 0, 0}, {43.2, 0, 0, -4.2}, {0, 0, 1, 0}};
  const Eigen::MatrixXd B{{5.64, 0}, {0, 0}, {0, 1.18}, {0, 0}};
  const Eigen::MatrixXd F{{-0.0876, -4.2138, 0.0837, -18.1412},
                          {-0.0233, 18.2483, -0.4259, -4.8120}};
  const Eigen::VectorXcd wanted =
      poleList({{-3.3984, 94.5253}, {-3.3984, -94.5253}, {-0.5, 0.15}, {-0.5, -0.15}});
  for (const std::complex<double> pole : poles(A + B * F))
    QVERIFY((wanted.array() - pole).abs().minCoeff() < 2e-4);  // F has four decimals
  const Placement ours = placePoles(A, B, wanted);
  QVERIFY(poleError(ours.poles, wanted) < 1e-10);
  QVERIFY(relativeError(characteristicPolynomial(A - B * ours.gain), polynomialOf(wanted)) < 1e-10);
}

void TestPlacement::polesAreWherePlaced_data() {
  QTest::addColumn<int>("index");
  int index = 0;
  for (const DesignPlant& plant : designPlants())
    QTest::addRow("%s", plant.name.c_str()) << index++;
}

void TestPlacement::polesAreWherePlaced() {
  QFETCH(int, index);
  const DesignPlant plant = designPlants()[static_cast<std::size_t>(index)];
  const Placement placed = placePoles(plant.A, plant.B, plant.poles());
  QVERIFY(coefficientError(plant, placed.gain) < 1e-10);
  QVERIFY(poleError(placed.poles, plant.poles()) < 1e-7);
  QVERIFY(placed.error < 1e-10);
  QVERIFY(placed.condition >= 1);
  if (plant.B.cols() == 1 && plant.name != "badly-scaled")
    QVERIFY(relativeError(ackermann(plant.A, plant.B, plant.poles()), placed.gain) < 1e-8);
}

void TestPlacement::randomPlants() {
  RandomStream random(12, "placement");
  for (int turn = 0; turn < 60; ++turn) {
    const Eigen::Index n = 1 + turn % 8, m = std::min<Eigen::Index>(n, 1 + turn % 4);
    const DesignPlant plant = randomPlant(random, n, m);
    const Placement placed = placePoles(plant.A, plant.B, plant.poles());
    QVERIFY2(coefficientError(plant, placed.gain) < 1e-8, plant.name.c_str());
  }
}

void TestPlacement::sampledPlants() {
  for (const DesignPlant& plant : designPlants()) {
    // With half a period of delay: a state more for each input, its pole at zero.
    const LinearSystem sampled =
        holdSampled(stateSystem(plant.A, plant.B), plant.period, plant.period / 2);
    Eigen::VectorXcd wanted = Eigen::VectorXcd::Zero(sampled.A.rows());
    wanted.head(plant.A.rows()) = sampledPoles(plant.poles(), plant.period);
    const Placement placed = placePoles(sampled.A, sampled.B, wanted);
    QVERIFY2(placed.error < 1e-10, plant.name.c_str());
  }
}

/// Kautsky, Nichols and Van Dooren (1985), example 1: the condition of the eigenvectors by the
/// reactor's two inputs is a few units (3.23 in their units), far less than by one input alone.
void TestPlacement::robustBeatsOneInputAlone() {
  const DesignPlant reactor = designPlants()[5];
  const double both = placePoles(reactor.A, reactor.B, reactor.poles()).condition;
  const double one = placePoles(reactor.A, reactor.B.col(0), reactor.poles()).condition;
  QVERIFY2(both < 6, qPrintable(QString::number(both)));
  QVERIFY2(one > 2 * both, qPrintable(QString::number(one)));
}

/// Four rotors that all do the same to one axis.
void TestPlacement::inputsInOneDirection() {
  const DesignPlant roll = designPlants()[1];
  const Eigen::MatrixXd B = roll.B * Eigen::RowVector4d(1, -1, 2, 0.5);
  const Placement placed = placePoles(roll.A, B, roll.poles());
  QVERIFY(placed.error < 1e-10);
  QVERIFY(relativeError(roll.B * Eigen::RowVector4d(1, -1, 2, 0.5) * placed.gain,
                        roll.B * placeSingleInput(roll.A, roll.B, roll.poles())) < 1e-10);
}

void TestPlacement::unusedInputs() {
  const DesignPlant reactor = designPlants()[5];
  Eigen::MatrixXd B(4, 4);
  B << reactor.B, Eigen::Vector4d::Zero(), reactor.B.col(0) - reactor.B.col(1);
  const Placement placed = placePoles(reactor.A, B, reactor.poles());
  QVERIFY(placed.error < 1e-10);
  QVERIFY(placed.gain.row(2).isZero(0));
}

void TestPlacement::repeatedPoles() {
  const DesignPlant six = designPlants()[6];
  Eigen::VectorXcd wanted(6);
  wanted << -2, -2, -2, -4, -4, -4;
  const Placement thrice = placePoles(six.A, six.B, wanted);
  QVERIFY(relativeError(characteristicPolynomial(six.A - six.B * thrice.gain),
                        polynomialOf(wanted)) < 1e-10);
  QVERIFY(thrice.condition < 100);
  wanted << std::complex(-3.0, 1.0), std::complex(-3.0, -1.0), std::complex(-3.0, 1.0),
      std::complex(-3.0, -1.0), std::complex(-3.0, 1.0), std::complex(-3.0, -1.0);
  QVERIFY(placePoles(six.A, six.B, wanted).condition < 100);
  // As many inputs as states: every pole as often as there are states.
  RandomStream random(12, "square");
  const DesignPlant square = randomPlant(random, 4, 4);
  const double condition =
      placePoles(square.A, square.B, Eigen::VectorXcd::Constant(4, -3)).condition;
  // The best there is is 1, with all vectors at right angles; the search ends near it.
  QVERIFY2(condition < 10, qPrintable(QString::number(condition)));
}

/// The outputs of the closed loop come to rest at their set-points, whatever constant force there
/// is.
void TestPlacement::integralActionHoldsTheOutput() {
  for (const bool sampled : {false, true}) {
    const DesignPlant roll = designPlants()[1];
    const double T = 0.02;
    LinearSystem plant = stateSystem(roll.A, roll.B);
    plant.C = Eigen::MatrixXd{{1, 0, 0}};
    plant.D = Eigen::MatrixXd{{0}};
    plant.states = {"roll", "rate", "moment"};
    plant.outputs = {"roll"};
    if (sampled) plant = holdSampled(plant, T);
    const LinearSystem whole = withIntegrators(plant, sampled ? std::optional(T) : std::nullopt);
    QVERIFY(whole.states.back() == "integral of roll");
    Eigen::VectorXcd wanted = poleList({{-10, 1}, {-10, -1}, -30, -5});
    if (sampled) wanted = sampledPoles(wanted, T);
    const Placement placed = placePoles(whole.A, whole.B, wanted);
    QVERIFY(poleError(placed.poles, wanted) < 1e-9);
    const IntegralGain gain = splitGain(placed.gain, 3);
    QCOMPARE(gain.state.cols(), 3);
    QCOMPARE(gain.integral.cols(), 1);
    // At rest x' = 0 (x+ = x) with the set-point 0.2 and a disturbing moment.
    const Eigen::MatrixXd closed = whole.A - whole.B * placed.gain;
    Eigen::VectorXd push(4);
    push << plant.B * 0.7, (sampled ? T : 1) * 0.2;
    const Eigen::MatrixXd rest =
        sampled ? Eigen::MatrixXd(closed - Eigen::MatrixXd::Identity(4, 4)) : closed;
    QVERIFY(std::abs(rest.partialPivLu().solve(-push)[0] - 0.2) < 1e-12);
  }
  // A rate cannot be held by what drives the angle's second derivative through a zero at rest.
  LinearSystem blocked = stateSystem(Eigen::MatrixXd{{0, 1}, {-4, -1}}, Eigen::MatrixXd{{0}, {1}});
  blocked.C = Eigen::MatrixXd{{0, 1}};
  blocked.D = Eigen::MatrixXd{{0}};
  QVERIFY_THROWS_EXCEPTION(InputError, withIntegrators(blocked));
  QVERIFY_THROWS_EXCEPTION(InputError, withIntegrators(stateSystem(Eigen::MatrixXd{{0, 1}, {0, 0}},
                                                                   Eigen::MatrixXd{{0}, {1}})));
}

void TestPlacement::refusalsSayWhy() {
  const auto says = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  const Eigen::MatrixXd A{{1, 0}, {0, -2}}, B{{1}, {0}};
  const Eigen::VectorXcd fine = poleList({-1, -3});
  QVERIFY2(says(refusal(A, B, fine), "no input moves the mode at -2"), refusal(A, B, fine).c_str());
  const Eigen::MatrixXd both = Eigen::MatrixXd::Identity(2, 2);
  QVERIFY(refusal(A, both, fine).empty());
  QVERIFY(says(refusal(A, both, poleList({{-1, 2}, -3})), "lacks its conjugate"));
  QVERIFY(says(refusal(A, both, Eigen::VectorXcd::Constant(3, -1)), "3 poles"));
  QVERIFY(says(refusal(A, both, poleList({NAN, -1})), "no number"));
  const DesignPlant reactor = designPlants()[5];
  const std::string often = refusal(reactor.A, reactor.B, poleList({-1, -1, -1, -2}));
  QVERIFY2(says(often, "the pole -1 is wanted 3 times") && says(often, "at most 2 times"),
           often.c_str());
  QVERIFY_THROWS_EXCEPTION(InputError, ackermann(A, both, fine));
  QVERIFY_THROWS_EXCEPTION(InputError, placeSingleInput(A, B, fine));
  QVERIFY_THROWS_EXCEPTION(InputError, placeRobustly(A, B, fine));
  QVERIFY_THROWS_EXCEPTION(InputError, placePoles(A, Eigen::MatrixXd(2, 0), fine));
}

QTEST_GUILESS_MAIN(TestPlacement)
#include "test_placement.moc"
