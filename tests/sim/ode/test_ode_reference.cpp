// End values published for well-known problems: Toronto DETEST, Pleiades, and Hairer's dopri5 on
// the Arenstorf orbit (tests/data/ode/SOURCE.txt).
#include <QFile>
#include <QtTest>
#include <cmath>
#include <map>
#include <vector>

#include "tests/sim/ode/detest.h"

using namespace rotorbench::ode;
using namespace rotorbench::test;

namespace {

struct Published {
  std::vector<double> start, end;
};

QList<QByteArrayList> rowsOf(const char* file) {
  QFile f(QString(TEST_DATA_DIR "/ode/") + file);
  if (!f.open(QIODevice::ReadOnly)) qFatal("missing %s", file);
  QList<QByteArrayList> rows;
  for (const QByteArray& line : f.readAll().trimmed().split('\n').mid(1))
    rows.append(line.split(','));
  return rows;
}

std::map<std::string, Published> detest() {
  std::map<std::string, Published> problems;
  for (const auto& row : rowsOf("detest_nonstiff_reference.csv")) {
    Published& p = problems[row[0].toStdString()];
    p.start.push_back(row[3].toDouble());
    p.end.push_back(row[5].toDouble());
  }
  return problems;
}

/// Largest error in units of what is allowed: 1e-5 relative or 1e-8 absolute.
template <int N>
double solve(typename FunctionSystem<N>::Function f, Method method, const Published& p) {
  FunctionSystem<N> system{f};
  // Absolute error per step, as DETEST defines its tolerance (the relative part is at its least).
  // The Euclidean norm is blind to the zeros a small problem is padded with.
  SolverSettings settings = adaptive(method, 1e-9, Norm::Euclidean);
  std::get<ScaledErrorControl>(settings.errorControl).relativeTolerance = 1e-15;
  Solver<FunctionSystem<N>> solver(settings, system);
  typename FunctionSystem<N>::State y = FunctionSystem<N>::State::Zero();
  for (std::size_t i = 0; i < p.start.size(); ++i) y[static_cast<int>(i)] = p.start[i];
  if (solver.integrate(20.0, y) != Status::Done) return INFINITY;
  double worst = 0;
  for (std::size_t i = 0; i < p.end.size(); ++i) {
    const double allowed = std::max(1e-5 * std::abs(p.end[i]), 1e-8);
    worst = std::max(worst, std::abs(y[static_cast<int>(i)] - p.end[i]) / allowed);
  }
  return worst;
}

double solveNamed(const std::string& problem, Method m, const Published& p) {
  if (problem == "C1") return solve<10>(problemC1, m, p);
  if (problem == "C2") return solve<10>(problemC2, m, p);
  if (problem == "C3") return solve<10>(heat<State10>, m, p);
  if (problem == "C4") return solve<51>(heat<State51>, m, p);
  if (problem == "C5") return solve<30>(problemC5, m, p);
  for (const SmallProblem& s : kSmallProblems) {
    if (problem == s.name) return solve<4>(s.f, m, p);
  }
  return INFINITY;
}

using State28 = FunctionSystem<28>::State;
/// Pleiades: x and y of seven stars of mass j, then their velocities. Hairer et al. I, eq.
/// (II.10.3).
void pleiades(double, const State28& s, State28& d) {
  d.head<14>() = s.tail<14>();
  for (int i = 0; i < 7; ++i) {
    double ax = 0;
    double ay = 0;
    for (int j = 0; j < 7; ++j) {
      if (j == i) continue;
      const double dx = s[j] - s[i];
      const double dy = s[7 + j] - s[7 + i];
      const double factor = (j + 1) / std::pow(dx * dx + dy * dy, 1.5);
      ax += factor * dx;
      ay += factor * dy;
    }
    d[14 + i] = ax;
    d[21 + i] = ay;
  }
}

/// Restricted three-body problem; [x, y, x', y']. Hairer et al. I, eq. (II.0.1).
void arenstorf(double, const State4& y, State4& d) {
  constexpr double mu = 0.012277471;
  constexpr double nu = 1 - mu;
  const double d1 = std::pow((y[0] + mu) * (y[0] + mu) + y[1] * y[1], 1.5);
  const double d2 = std::pow((y[0] - nu) * (y[0] - nu) + y[1] * y[1], 1.5);
  d << y[2], y[3], y[0] + 2 * y[3] - nu * (y[0] + mu) / d1 - mu * (y[0] - nu) / d2,
      y[1] - 2 * y[2] - nu * y[1] / d1 - mu * y[1] / d2;
}

}  // namespace

class TestOdeReference : public QObject {
  Q_OBJECT
 private slots:
  void detestProblem_data() {
    QTest::addColumn<QString>("problem");
    QTest::addColumn<int>("method");
    for (const auto& [problem, values] : detest()) {
      for (const MethodInfo& m : kMethods) {
        if (!m.adaptive) continue;
        QTest::addRow("%s %s", problem.c_str(), m.name.data())
            << QString::fromStdString(problem) << static_cast<int>(m.method);
      }
    }
  }
  void detestProblem() {
    QFETCH(QString, problem);
    QFETCH(int, method);
    static const auto problems = detest();
    const double error = solveNamed(problem.toStdString(), static_cast<Method>(method),
                                    problems.at(problem.toStdString()));
    // F1 switches its forcing at every integer; the solvers step over the jumps unaware, at first
    // order.
    const double allowed = problem == "F1" ? 1000.0 : 1.0;
    QVERIFY2(error <= allowed, qPrintable(QString::number(error)));
  }

  void pleiadesEnd_data() {
    QTest::addColumn<int>("method");
    for (const MethodInfo& m : kMethods) {
      if (m.adaptive) QTest::addRow("%s", m.name.data()) << static_cast<int>(m.method);
    }
  }
  void pleiadesEnd() {
    QFETCH(int, method);
    const auto rows = rowsOf("plei_reference.csv");
    QCOMPARE(rows.size(), 28);
    State28 y;
    for (int i = 0; i < 28; ++i) y[i] = rows[i][1].toDouble();
    FunctionSystem<28> system{pleiades};
    Solver<FunctionSystem<28>> solver(adaptive(static_cast<Method>(method), 1e-11), system);
    QCOMPARE(solver.integrate(3.0, y), Status::Done);
    for (int i = 0; i < 28; ++i) {
      QVERIFY2(std::abs(y[i] - rows[i][2].toDouble()) < 1e-6, qPrintable(QString::number(i)));
    }
  }

  void arenstorfAsDopri5() {
    // dr_dopri5.f: RTOL = ATOL = 1e-7, PI controller, dense output at 0, 2, ..., 16; no step is
    // kept.
    FunctionSystem<4> system{arenstorf};
    SolverSettings settings =
        adaptive(Method::Rk547M, 1e-7, Norm::Rms, StepController::ProportionalIntegral);
    std::get<ScaledErrorControl>(settings.errorControl).keptChange = 0;
    Solver<FunctionSystem<4>> solver(settings, system);
    State4 y(0.994, 0, 0, -2.00158510637908252240537862224);
    const double expected[][2] = {{-0.5798781411, 0.6090775251},  {-0.1983335270, 1.137638086},
                                  {-0.4735743943, 0.2239068118},  {-1.174553350, -0.2759466982},
                                  {-0.8398073466, 0.4468302268},  {0.01314712468, -0.8385751499},
                                  {-0.6031129504, -0.9912598031}, {0.2427110999, -0.3899948833}};
    const int steps[] = {60, 73, 91, 110, 122, 145, 159, 177};
    int found = 0;
    int worstStep = 0;
    double worst = 0;
    Watch<State4> watch;
    watch.onStep = [&](const StepView<State4>& step) {
      for (; found < 8 && 2.0 * (found + 1) <= step.end; ++found) {
        const State4 at = step.dense.at(2.0 * (found + 1));
        worst = std::max(
            {worst, std::abs(at[0] - expected[found][0]), std::abs(at[1] - expected[found][1])});
        const auto count = static_cast<int>(solver.statistics().attempts());
        worstStep = std::max(worstStep, std::abs(count - steps[found]));
      }
      return true;
    };
    QCOMPARE(solver.integrate(17.0652165601579625588917206249, y, watch), Status::Done);
    QCOMPARE(found, 8);
    QVERIFY2(worst < 5e-8, qPrintable(QString::number(worst)));
    // Hairer's counter leaves out the two steps rejected before the first accepted one.
    QVERIFY2(worstStep <= 2, qPrintable(QString::number(worstStep)));
    QVERIFY(std::abs(y[0] - 0.9940021016) < 2e-8);
    QVERIFY(std::abs(y[1] - 0.8911185692e-5) < 2e-8);
    // fcn = 1442, step = 240, accepted = 216, rejected = 22 + 2.
    QCOMPARE(solver.statistics().steps, 216);
    QCOMPARE(solver.statistics().rejected, 24);
    QCOMPARE(solver.statistics().evaluations, 1442);
  }
};

QTEST_APPLESS_MAIN(TestOdeReference)
#include "test_ode_reference.moc"
