// Every tableau satisfies the order conditions of all rooted trees up to its order, and fails one
// of the next. Conditions: Hairer, Norsett, Wanner, Solving ODEs I, section II.2.
#include <QtTest>
#include <cmath>
#include <functional>
#include <vector>

#include "sim/ode/tableau.h"

using namespace rotorbench::ode;

namespace {

struct Tree {
  std::vector<Tree> branches;
};

int orderOf(const Tree& t) {
  int order = 1;
  for (const Tree& b : t.branches) order += orderOf(b);
  return order;
}
/// Density gamma(t): the condition reads sum b_i Phi_i(t) = 1 / gamma(t).
double densityOf(const Tree& t) {
  double density = orderOf(t);
  for (const Tree& b : t.branches) density *= densityOf(b);
  return density;
}

/// All rooted trees of each order up to `most`, made by attaching multisets of smaller trees to a
/// root.
std::vector<std::vector<Tree>> treesUpTo(int most) {
  std::vector<std::vector<Tree>> byOrder(static_cast<std::size_t>(most) + 1);
  std::vector<Tree> all;
  for (int order = 1; order <= most; ++order) {
    auto& here = byOrder[static_cast<std::size_t>(order)];
    std::vector<Tree> chosen;
    const std::function<void(std::size_t, int)> attach = [&](std::size_t from, int left) {
      if (left == 0) here.push_back({chosen});
      for (std::size_t i = from; i < all.size(); ++i) {
        if (orderOf(all[i]) > left) continue;
        chosen.push_back(all[i]);
        attach(i, left - orderOf(all[i]));
        chosen.pop_back();
      }
    };
    attach(0, order - 1);
    all.insert(all.end(), here.begin(), here.end());
  }
  return byOrder;
}

template <class T>
struct Weights {
  static constexpr auto kCount = static_cast<std::size_t>(T::kStages);
  using Row = std::array<long double, kCount>;
  static Row elementary(const Tree& t) {
    Row product;
    product.fill(1.0L);
    for (const Tree& branch : t.branches) {
      const Row inner = elementary(branch);
      for (std::size_t i = 0; i < kCount; ++i) {
        long double sum = 0;
        for (std::size_t j = 0; j < kCount; ++j) sum += T::kA[i][j] * inner[j];
        product[i] *= sum;
      }
    }
    return product;
  }
  /// Largest defect of the conditions of one order.
  static double defect(const std::array<double, kCount>& b, const std::vector<Tree>& trees) {
    double worst = 0;
    for (const Tree& t : trees) {
      const Row phi = elementary(t);
      long double sum = 0;
      for (std::size_t i = 0; i < kCount; ++i) sum += b[i] * phi[i];
      worst = std::max(worst, std::abs(static_cast<double>(sum) - 1.0 / densityOf(t)));
    }
    return worst;
  }
};

constexpr double kRounding = 2e-14;

template <class T>
void checkSolution(const std::array<double, static_cast<std::size_t>(T::kStages)>& b, int order) {
  const auto trees = treesUpTo(order + 1);
  for (int p = 1; p <= order; ++p) {
    const double defect = Weights<T>::defect(b, trees[static_cast<std::size_t>(p)]);
    QVERIFY2(defect < kRounding, qPrintable(QString("order %1: %2").arg(p).arg(defect)));
  }
  QVERIFY(Weights<T>::defect(b, trees[static_cast<std::size_t>(order) + 1]) > 1e-6);
}

template <class T>
void checkRows() {
  for (std::size_t i = 0; i < Weights<T>::kCount; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < Weights<T>::kCount; ++j) {
      sum += T::kA[i][j];
      if (j >= i) QCOMPARE(T::kA[i][j], 0.0);
    }
    QVERIFY2(std::abs(sum - T::kC[i]) < kRounding, qPrintable(QString("row %1").arg(i)));
  }
}

template <class T>
void checkPair() {
  checkRows<T>();
  checkSolution<T>(T::kB, 5);
  checkSolution<T>(T::kB4, 4);
  double sum = 0;
  for (std::size_t i = 0; i < Weights<T>::kCount; ++i) {
    QVERIFY(std::abs(T::kError[i] - (T::kB4[i] - T::kB[i])) < kRounding);
    sum += T::kError[i];
    if (T::kFirstSameAsLast) QCOMPARE(T::kA[Weights<T>::kCount - 1][i], T::kB[i]);
  }
  QVERIFY(std::abs(sum) < kRounding);
}

}  // namespace

class TestOdeTableau : public QObject {
  Q_OBJECT
 private slots:
  void numberOfTrees() {
    // 1, 1, 2, 4, 9, 20 rooted trees: Hairer et al., table II.2.1.
    const std::vector<std::size_t> expected{0, 1, 1, 2, 4, 9, 20};
    const auto trees = treesUpTo(6);
    for (std::size_t p = 1; p < expected.size(); ++p) QCOMPARE(trees[p].size(), expected[p]);
  }
  void euler() {
    checkRows<EulerTableau>();
    checkSolution<EulerTableau>(EulerTableau::kB, 1);
  }
  void rk4() {
    checkRows<Rk4Tableau>();
    checkSolution<Rk4Tableau>(Rk4Tableau::kB, 4);
  }
  void rk547m() { checkPair<Rk547MTableau>(); }
  void rk546m() { checkPair<Rk546MTableau>(); }
  void rk547s() { checkPair<Rk547STableau>(); }
  void printedSignOf6MIsWrong() {
    // The 2014 thesis prints -189/55 in eq. (1.33): that row does not even sum to its stage time.
    double sum = 0;
    for (std::size_t j = 0; j < 5; ++j) sum += Rk546MTableau::kA[5][j];
    QVERIFY(std::abs(sum - 2.0 * 189.0 / 55.0 - 1.0) > 1.0);
  }
};

QTEST_APPLESS_MAIN(TestOdeTableau)
#include "test_ode_tableau.moc"
