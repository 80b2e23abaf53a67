// A grid that is solved where it needs to be, and the table that reads it: against the functions
// they were made of.
#include <QtTest>
#include <atomic>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "sim/numerics/cubic_table.h"

using namespace rotorbench;

namespace {

constexpr GridValues kTolerance{1e-3, 1e-3, 1e-3, 1e-3};

/// Even in y; smooth, but for a stall-like switch of `steepness` in x in the last value.
GridValues sample(const GridPlace& p, double steepness) {
  const double x = p[0], y = p[1], z = p[2];
  return {std::sin(2 * x) * std::cos(y), 1 + x * x - y * y * z, std::exp(-x) * (1 + z),
          std::tanh(steepness * (x - 0.37)) * std::cos(y)};
}

std::array<GridAxis, kGridAxes> axes(int refinements) {
  return {GridAxis{9, refinements, false}, GridAxis{7, refinements, true}, GridAxis{9, 0, false}};
}

/// Largest difference of the table off its points.
double worstOf(const CubicTable& table, double steepness) {
  double worst = 0;
  for (int i = 1; i <= 4000; ++i) {
    const GridPlace p{std::fmod(0.5 + i * 0.8191725134, 1.0),
                      std::fmod(0.5 + i * 0.6710436067, 1.0),
                      std::fmod(0.5 + i * 0.5497004779, 1.0)};
    double read[kGridValues];
    table.at(p[0], p[1], p[2], read);
    const GridValues exact = sample(p, steepness);
    for (std::size_t q = 0; q < kGridValues; ++q)
      worst = std::max(worst, std::abs(read[q] - exact[q]));
  }
  return worst;
}

std::size_t pointsOf(const RefinedGrid& grid) {
  return grid.points()[0] * grid.points()[1] * grid.points()[2];
}

}  // namespace

class TestRefinedGrid : public QObject {
  Q_OBJECT
 private slots:
  /// Where the coarse grid will do, nothing more is solved; the rest is filled in from it.
  void smoothFunctionsAreNotRefined() {
    std::atomic<std::size_t> calls = 0;
    const RefinedGrid grid(axes(2), {1, 1, 1, 1}, [&](const GridPlace& p) {
      ++calls;
      return sample(p, 1);
    });
    QCOMPARE(grid.solved(), std::size_t(9 * 7 * 9));
    QCOMPARE(calls.load(), grid.solved());
    QCOMPARE(grid.points(), (RefinedGrid::Index{33, 25, 9}));
    QVERIFY(worstOf(CubicTable(grid), 1) < 3e-3);
  }

  /// A steep switch costs points where it is, and only there.
  void steepPlacesAreSolved() {
    constexpr double kSteepness = 30;
    const auto build = [&](int refinements) {
      return RefinedGrid(axes(refinements), kTolerance,
                         [&](const GridPlace& p) { return sample(p, kSteepness); });
    };
    const RefinedGrid coarse = build(0), fine = build(4);
    QVERIFY(worstOf(CubicTable(coarse), kSteepness) > 0.1);
    QVERIFY(worstOf(CubicTable(fine), kSteepness) < 4 * kTolerance[0]);
    QVERIFY(fine.solved() < pointsOf(fine) / 4);
    // Every point near the switch is the function itself.
    const auto column = static_cast<std::size_t>(std::lround(0.37 * 128));
    const RefinedGrid::Index i{column, 3, 4};
    QVERIFY(std::abs(fine.at(i)[3] - sample(fine.place(i), kSteepness)[3]) < 1e-14);
  }

  /// A parabola is given back to single precision, to the ends of every axis: mirrored ones, too,
  /// if it is even.
  void tableReadsParabolasExactly() {
    const auto parabola = [](const GridPlace& p) {
      return GridValues{p[0] * p[0] - p[2], p[1] * p[1] + 2, 3 * p[2] * p[2], p[0] * p[2]};
    };
    const CubicTable table(RefinedGrid(axes(0), kTolerance, parabola));
    for (const GridPlace& p : {GridPlace{0.01, 0.02, 0.03}, {0.5, 0.4, 0.3}, {0.99, 0.98, 0.97}}) {
      double read[kGridValues];
      table.at(p[0], p[1], p[2], read);
      const GridValues exact = parabola(p);
      for (std::size_t q = 0; q < kGridValues; ++q) QVERIFY(std::abs(read[q] - exact[q]) < 1e-6);
    }
  }

  void endsHoldOutside() {
    const CubicTable table(
        RefinedGrid(axes(0), kTolerance, [](const GridPlace& p) { return sample(p, 1); }));
    double inside[kGridValues], outside[kGridValues];
    table.at(1.0, 0.0, 1.0, inside);
    table.at(7.0, -3.0, 1e300, outside);
    for (std::size_t q = 0; q < kGridValues; ++q) QCOMPARE(outside[q], inside[q]);
    table.at(std::nan(""), 0.5, 0.5, outside);
    for (const double value : outside) QVERIFY(!std::isinf(value));
  }

  /// No slope along an even axis at 0; derivatives over a differentiating scalar are those of the
  /// table.
  void derivatives() {
    using Dual = Eigen::AutoDiffScalar<Eigen::Vector3d>;
    const CubicTable table(
        RefinedGrid(axes(1), kTolerance, [](const GridPlace& p) { return sample(p, 3); }));
    const auto slopes = [&](double x, double y, double z) {
      Dual read[kGridValues];
      table.at(Dual(x, 3, 0), Dual(y, 3, 1), Dual(z, 3, 2), read);
      return read[0].derivatives();
    };
    QVERIFY(std::abs(slopes(0.3, 0, 0.6)[1]) < 1e-12);
    const Eigen::Vector3d exact = slopes(0.31, 0.42, 0.6);
    constexpr double kStep = 1e-5;
    double up[kGridValues], down[kGridValues];
    table.at(0.31 + kStep, 0.42, 0.6, up);
    table.at(0.31 - kStep, 0.42, 0.6, down);
    QVERIFY(std::abs((up[0] - down[0]) / (2 * kStep) - exact[0]) < 1e-6);
    // The slopes of Catmull and Rom are central differences: h^2/6 of the third derivative, below 8
    // here, at 16 intervals.
    constexpr double kSlopeError = 8.0 / (6 * 16 * 16);
    QVERIFY(std::abs(exact[0] - 2 * std::cos(0.62) * std::cos(0.42)) < kSlopeError);
  }
};

QTEST_GUILESS_MAIN(TestRefinedGrid)
#include "test_refined_grid.moc"
