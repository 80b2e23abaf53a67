// All 101 propellers of the UIUC Propeller Data Site kept here, static and in flight, with one set of model constants;
// then the same with one twist offset per propeller that is fitted to its static coefficients. Prints the errors by
// pitch class. Scores: propeller_scores.h.
#include <QtTest>

#include "sim/fitting/propeller_fit.h"
#include "tests/validation/propeller_scores.h"

using namespace rotorbench;
using namespace uiuc;

namespace {

/// The columns of the table.
struct Errors {
  std::vector<double> thrust, power, flightThrust, flightPower, peak, zeroThrust;

  void add(const Score& s) {
    thrust.push_back(s.thrust);
    power.push_back(s.power);
    const auto addIfAny = [](std::vector<double>& to, const std::optional<double>& value) {
      if (value) to.push_back(*value);
    };
    addIfAny(flightThrust, s.flightThrust);
    addIfAny(flightPower, s.flightPower);
    addIfAny(peak, s.peak);
    addIfAny(zeroThrust, s.zeroThrust);
  }
};

QString cell(const std::vector<double>& errors) {
  if (errors.empty()) return QString("-").rightJustified(13);
  return QString("%1/%2")
      .arg(quantile(errors, 0.5), 0, 'f', 2)
      .arg(quantile(errors, 0.9), 0, 'f', 2)
      .rightJustified(13);
}

void print(const QString& title, const Errors& e) {
  qInfo("%s",
        qPrintable(title.leftJustified(26) + QString::number(e.thrust.size()).rightJustified(4) +
                   cell(e.thrust) + cell(e.power) + cell(e.flightThrust) + cell(e.flightPower) +
                   cell(e.peak) + cell(e.zeroThrust)));
}

/// Pitch over diameter as printed.
struct PitchClass {
  const char* name;
  double low, high;
};
constexpr PitchClass kClasses[] = {{"P/D not printed", -1, 1e-9},
                                   {"P/D below 0.5", 1e-9, 0.5},
                                   {"P/D 0.5 to 0.7", 0.5, 0.7 + 1e-9},
                                   {"P/D above 0.7", 0.7 + 1e-9, 10}};

void printClasses(const QString& title, const std::vector<Set>& sets,
                  const std::vector<Score>& scores) {
  qInfo("%s, median/90 %% quantile", qPrintable(title));
  qInfo("%s",
        "                          sets  static CT %  static CP %    CT/CT0 %     CP/CP0 % "
        "   peak eta pt  J at CT = 0 %");
  Errors all;
  for (const PitchClass& c : kClasses) {
    Errors some;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (sets[i].pitchRatio >= c.low && sets[i].pitchRatio < c.high) some.add(scores[i]);
    }
    print(c.name, some);
  }
  for (const Score& s : scores) all.add(s);
  print("all", all);
}

/// Twist offset with the least error of static CT and CP, rad: the lowest of a coarse scan, then golden section.
double fittedOffset(Set set) {
  constexpr double kDegree = std::numbers::pi / 180, kMost = 12 * kDegree, kCoarse = 2 * kDegree;
  constexpr double kThrustWeight = 1.1, kExponent = 1.5;
  const auto error = [&set](double offset) {
    set.geometry.twistOffset = offset;
    const Score s = stillScore(set, BladeElementRotor(set.geometry));
    return kThrustWeight * std::pow(s.thrust, kExponent) + std::pow(s.power, kExponent);
  };
  double best = 0, least = error(0);
  for (double offset = -kMost; offset <= kMost; offset += kCoarse) {
    const double e = error(offset);
    if (e < least) least = e, best = offset;
  }
  constexpr double kGolden = 0.6180339887498949;
  double a = best - kCoarse, b = best + kCoarse;
  double p = b - kGolden * (b - a), q = a + kGolden * (b - a);
  double atP = error(p), atQ = error(q);
  while (b - a > 0.02 * kDegree) {
    if (atP < atQ) {
      b = q, q = p, atQ = atP;
      p = b - kGolden * (b - a), atP = error(p);
    } else {
      a = p, p = q, atP = atQ;
      q = a + kGolden * (b - a), atQ = error(q);
    }
  }
  return (a + b) / 2;
}

bool within(const char* what, const std::vector<double>& errors, double median, double most) {
  const double m = quantile(errors, 0.5), q = quantile(errors, 0.9);
  if (m <= median && q <= most) return true;
  qWarning("%s: %.3f/%.3f, allowed %.1f/%.1f", what, m, q, median, most);
  return false;
}

}  // namespace

class TestUiucPropellers : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void dataIsComplete();
  void globalConstantsPredictAllPropellers();
  void oneTwistOffsetPerPropellerFitsTheRest();
  void leastSquaresFindTheSameOffset();

 private:
  std::vector<Set> sets_;
};

void TestUiucPropellers::initTestCase() {
  sets_ = readSets();
}

void TestUiucPropellers::dataIsComplete() {
  std::size_t still = 0, flight = 0;
  QSet<QString> names;
  for (const Set& set : sets_) {
    names.insert(set.name);
    still += set.still.size();
    for (const auto& run : set.flights) flight += run.size();
    QVERIFY(set.geometry.stations.size() >= 17);
    QVERIFY(!set.flights.empty());
  }
  QCOMPARE(names.size(), 101);
  QCOMPARE(still, std::size_t(1719));
  QCOMPARE(flight, std::size_t(8449));
}

void TestUiucPropellers::globalConstantsPredictAllPropellers() {
  Errors errors;
  std::vector<Score> scores;
  for (const Set& set : sets_) {
    scores.push_back(score(set, BladeElementRotor(set.geometry)));
    errors.add(scores.back());
  }
  printClasses("one set of constants", sets_, scores);
  QVERIFY(within("static CT", errors.thrust, 6.5, 18));
  QVERIFY(within("static CP", errors.power, 9.6, 25));
  QVERIFY(within("CT/CT0 in flight", errors.flightThrust, 8.2, 19));
  QVERIFY(within("CP/CP0 in flight", errors.flightPower, 9.6, 28));
  QVERIFY(within("peak efficiency", errors.peak, 4.1, 10.5));
  QVERIFY(within("J at zero thrust", errors.zeroThrust, 5.2, 14.5));
}

void TestUiucPropellers::oneTwistOffsetPerPropellerFitsTheRest() {
  Errors errors;
  std::vector<Score> scores;
  for (Set set : sets_) {
    set.geometry.twistOffset = fittedOffset(set);
    scores.push_back(score(set, BladeElementRotor(set.geometry)));
    errors.add(scores.back());
  }
  printClasses("one twist offset per propeller", sets_, scores);
  QVERIFY(within("static CT", errors.thrust, 4.2, 7.5));
  QVERIFY(within("static CP", errors.power, 3.1, 7.2));
  QVERIFY(quantile(errors.flightThrust, 0.5) <= 5.6);
  QVERIFY(quantile(errors.flightThrust, 0.9) <= 11.5);
  QEXPECT_FAIL("", "Fitted at rest, very low and very high pitch miss the aim of 10 % in flight",
               Continue);
  QVERIFY(within("CT/CT0 in flight", errors.flightThrust, 5.6, 10));
  QVERIFY(within("CP/CP0 in flight", errors.flightPower, 6.4, 12.6));
}

/// The fit offered to the user against the search above, on the static coefficients of an APC thin electric 10x5. Squares
/// weigh the rows a little differently than mean sizes do: within half a degree.
void TestUiucPropellers::leastSquaresFindTheSameOffset() {
  constexpr double kDegree = std::numbers::pi / 180, kRpm = std::numbers::pi / 30;
  const auto set = std::find_if(sets_.begin(), sets_.end(), [](const Set& candidate) {
    return candidate.name.contains("apce_10x5 ");
  });
  QVERIFY(set != sets_.end());
  MeasuredTable table{"tunnel",
                      {{"motor.speed", "rad/s", {}}, {"ct", "1", {}}, {"cp", "1", {}}},
                      std::vector<std::vector<double>>(3)};
  for (const Row& row : set->still) {
    table.columns[0].push_back(row.rpm * kRpm);
    table.columns[1].push_back(row.thrust);
    table.columns[2].push_back(row.power);
  }
  PropellerFitSetup setup;
  setup.start = set->geometry;
  setup.air = kTunnelAir;
  FitOptions options;
  options.weighByScatter = false;
  const FitResult result = solveLeastSquares(propellerFitProblem(table, setup), options);
  QVERIFY2(result.usable(), result.sentence.c_str());
  const double searched = fittedOffset(*set);
  const FittedParameter& offset = *result.find("twistOffset");
  qInfo("searched %.2f, fitted %.2f +- %.2f degrees", searched / kDegree, offset.value / kDegree,
        offset.halfWidth.value_or(0) / kDegree);
  QVERIFY(std::abs(offset.value - searched) < 0.5 * kDegree);
}

QTEST_GUILESS_MAIN(TestUiucPropellers)
#include "test_uiuc_propellers.moc"
