// The fit of a twist offset that is offered to the user against the search of the validation.
#include <QtTest>
#include <numbers>

#include "sim/fitting/propeller_fit.h"
#include "sim/validation/propeller_scores.h"
#include "tests/validation/uiuc_data.h"

using namespace rotorbench;

class TestOffsetFit : public QObject {
  Q_OBJECT
 private slots:
  /// Static coefficients of an APC thin electric 10x5. The search takes logarithms of the ratios,
  /// the fit differences: within half a degree.
  void leastSquaresFindTheSameOffset() {
    constexpr double kDegree = std::numbers::pi / 180;
    const auto set =
        std::ranges::find(uiuc::sets(), "apce_10x5", &validation::PropellerSet::propeller);
    QVERIFY(set != uiuc::sets().end());
    MeasuredTable table{"tunnel",
                        {{"motor.speed", "rad/s", {}}, {"ct", "1", {}}, {"cp", "1", {}}},
                        std::vector<std::vector<double>>(3)};
    for (const auto& row : set->still) {
      table.columns[0].push_back(row.speed);
      table.columns[1].push_back(row.thrust);
      table.columns[2].push_back(row.power);
    }
    PropellerFitSetup setup;
    setup.start = set->geometry;
    setup.air = validation::kTunnelAir;
    FitOptions options;
    options.weighByScatter = false;
    const FitResult result = solveLeastSquares(propellerFitProblem(table, setup), options);
    QVERIFY2(result.usable(), result.sentence.c_str());
    const double searched = validation::fittedTwistOffset(*set);
    const FittedParameter& offset = *result.find("twistOffset");
    qInfo("searched %.2f, fitted %.2f +- %.2f degrees", searched / kDegree, offset.value / kDegree,
          offset.halfWidth.value_or(0) / kDegree);
    QVERIFY(std::abs(offset.value - searched) < 0.5 * kDegree);
  }
};

QTEST_GUILESS_MAIN(TestOffsetFit)
#include "test_offset_fit.moc"
