// The validation: every limit of its cases, one row each, and what holds for the data and the
// report.
#include <QTest>
#include <cmath>
#include <map>
#include <set>

#include "sim/document/resources.h"
#include "sim/validation/cases.h"
#include "sim/validation/page.h"
#include "tests/full_set.h"
#include "tests/validation/uiuc_data.h"

using namespace rotorbench;
using namespace rotorbench::validation;

namespace {

/// Seven maps take 98 % of the time of all cases. They are made with the full set; the hardest of
/// them is held to the same limits by test_rotor_models and test_propeller_map. The fits without
/// each family take minutes: their fit is tested by test_section_fit.
bool leftOut(const std::string& key) {
  if (key == "uiuc-families") return true;
  return key == "map" && !test::fullSet();
}

/// Each case runs once, when it is first asked for; null if there is none or it is left out.
const CaseResult* find(const std::string& key) {
  static std::map<std::string, CaseResult> known;
  for (const Case& c : cases()) {
    if (key != c.key || leftOut(key)) continue;
    if (!known.contains(key)) known.emplace(key, c.run(EXPERIMENTS_DIR "/.."));
    return &known.at(key);
  }
  return nullptr;
}

std::vector<CaseResult> results() {
  std::vector<CaseResult> all;
  for (const Case& c : cases())
    if (!leftOut(c.key)) all.push_back(*find(c.key));
  return all;
}

/// NaN if there is no such figure.
double value(const QString& key, const QString& metric) {
  if (const CaseResult* result = find(key.toStdString())) {
    for (const ComparedFigure& f : result->figures) {
      if (f.metric == metric.toStdString()) return f.value;
    }
  }
  return std::nan("");
}

}  // namespace

class TestPublishedData : public QObject {
  Q_OBJECT

 private slots:
  /// The limits as the project promises them, written down a second time: a limit changed in the
  /// program fails here.
  void limits_data();
  void limits();
  void everyLimitIsListedHere();
  void dataIsComplete();
  void casesSayWhatTheyDid();
  void reportHoldsEveryFigure();
  void evidenceIsSaid();
  void constantsInDoubtAreCalledSo();
  void unknownCaseIsNamed();
};

void TestPublishedData::limits_data() {
  QTest::addColumn<QString>("key");
  QTest::addColumn<QString>("metric");
  QTest::addColumn<double>("most");
  const auto row = [](const char* key, const QString& metric, double most) {
    QTest::addRow("%s: %s", key, qPrintable(metric)) << key << metric << most;
  };
  const auto both = [&](const char* key, const QString& metric, double median, double most) {
    row(key, metric + ", median", median);
    row(key, metric + ", 90 % quantile", most);
  };
  both("uiuc-global", "static CT", 6.5, 18);
  both("uiuc-global", "static CP", 9.6, 25);
  both("uiuc-global", "CT/CT0 in flight", 8.2, 19);
  both("uiuc-global", "CP/CP0 in flight", 9.6, 28);
  both("uiuc-global", "peak efficiency", 4.1, 10.5);
  both("uiuc-global", "J at zero thrust", 5.2, 14.5);
  both("uiuc-offset", "static CT", 4.2, 7.5);
  both("uiuc-offset", "static CP", 3.1, 7.2);
  both("uiuc-offset", "CT/CT0 in flight", 5.6, 10);
  both("uiuc-offset", "CP/CP0 in flight", 6.4, 12.6);
  row("naca-tr594", "CT, rms over J", 4);
  row("naca-tr594", "CP, rms over J", 4);
  row("tmotor-28in", "shipped curve against this program, most", 0.1);
  for (const char* what : {"thrust", "speed", "current"}) {
    row("stand-x2216", QString("full throttle: ") + what, 8);
  }
  row("stand-throttle", "10 x 4.7, the drive: speed, most", 5);
  row("stand-throttle", "10 x 4.7, the drive: current, most", 12);
  row("stand-throttle", "10 x 4.7, the drive: thrust, most", 10);
  for (const char* motor : {"T-Motor F60 Pro II 1750 KV", "T-Motor F40 Pro III 1600 KV"}) {
    row("esc-test", QString(motor) + ": speed of the steps held out, most", 3);
    row("esc-test", QString(motor) + ": current of the steps held out, most", 6);
  }
  if (leftOut("map")) return;
  row("map", "thrust, most", 0.2);
  row("map", "torque, most", 1);
  row("map", "thrust edgewise, most", 0.2);
  row("map", "torque edgewise, most", 1);
  row("map", "in-plane force, most", 0.2);
  row("map", "hub moment, most", 0.2);
  row("map", "loads that are no finite number", 0);
}

void TestPublishedData::limits() {
  QFETCH(QString, key);
  QFETCH(QString, metric);
  QFETCH(double, most);
  const double found = value(key, metric);
  QVERIFY2(found <= most, qPrintable(QString("%1, at most %2").arg(found).arg(most)));
}

void TestPublishedData::everyLimitIsListedHere() {
  std::size_t count = 0;
  for (const CaseResult& r : results()) {
    for (const ComparedFigure& f : r.figures) count += f.limit ? 1 : 0;
  }
  QCOMPARE(count, std::size_t(leftOut("map") ? 33 : 40));
}

/// As many propellers and rows as the database gave.
void TestPublishedData::dataIsComplete() {
  std::size_t still = 0, flight = 0;
  std::set<std::string> names;
  for (const PropellerSet& set : uiuc::sets()) {
    names.insert(std::to_string(set.volume) + set.propeller + set.run);
    still += set.still.size();
    for (const auto& run : set.flights) flight += run.size();
    QVERIFY(set.geometry.stations.size() >= 17);
    QVERIFY(!set.flights.empty());
  }
  QCOMPARE(names.size(), std::size_t(101));
  QCOMPARE(still, std::size_t(1719));
  QCOMPARE(flight, std::size_t(8449));
}

void TestPublishedData::casesSayWhatTheyDid() {
  for (const CaseResult& r : results()) {
    QVERIFY2(!r.method.empty() && !r.sources.empty(), r.key.c_str());
    QVERIFY2(!r.figures.empty() && !r.charts.empty(), r.key.c_str());
    for (const ComparedFigure& f : r.figures) QVERIFY2(std::isfinite(f.value), f.metric.c_str());
    for (const Table& t : r.tables) {
      QVERIFY2(!t.rows.empty(), t.title.c_str());
      for (const auto& row : t.rows) QCOMPARE(row.size(), t.header.size());
    }
    // Fitted cases that miss no limit but have none say why they are as they are.
    bool limited = false;
    for (const ComparedFigure& f : r.figures) limited = limited || f.limit.has_value();
    QVERIFY2(limited || !r.verdict.empty(), r.key.c_str());
  }
}

void TestPublishedData::reportHoldsEveryFigure() {
  const std::vector<CaseResult> all = results();
  const QString page = QString::fromStdString(pageHtml(all));
  const QString csv = QString::fromStdString(resultsCsv(all));
  qsizetype figures = 0;
  for (const CaseResult& r : all) {
    QVERIFY(page.contains(QString("id=\"%1\"").arg(r.key.c_str())));
    for (const ComparedFigure& f : r.figures) {
      QVERIFY2(page.contains(QString::fromStdString(f.metric)), f.metric.c_str());
      ++figures;
    }
  }
  QCOMPARE(csv.count('\n'), figures + 1);
  QVERIFY(page.contains("<th>Figure</th><th>Evidence</th><th>Value</th><th>Limit</th>"));
  QVERIFY(!page.contains("http-equiv") && !page.contains("<script") && !page.contains("src="));
}

/// What was in view when constants were chosen is not called held out, and the program against
/// itself is no measurement.
void TestPublishedData::evidenceIsSaid() {
  const std::map<std::string, std::set<Evidence>> allowed{
      {"uiuc-global", {Evidence::Fitted}},
      {"uiuc-offset", {Evidence::Fitted}},
      {"naca-tr594", {Evidence::Fitted}},
      {"tmotor-28in", {Evidence::SelfCheck}},
      {"stand-x2216", {Evidence::Fitted}},
      {"stand-throttle", {Evidence::HeldOut, Evidence::Fitted}},
      {"esc-test", {Evidence::HeldOut}},
      {"racing-drives", {Evidence::HeldOut}},
      {"crazyflie", {Evidence::HeldOut}},
      {"map", {Evidence::SelfCheck}}};
  const std::vector<CaseResult> all = results();
  const std::string text = resultsText(all), csv = resultsCsv(all);
  for (const CaseResult& r : all) {
    for (const ComparedFigure& f : r.figures)
      QVERIFY2(allowed.at(r.key).contains(f.evidence), f.metric.c_str());
  }
  for (const char* word : {"fitted", "self-check", "held out"}) {
    QVERIFY2(text.find(word) != std::string::npos, word);
    QVERIFY2(csv.find(word) != std::string::npos, word);
  }
}

/// The plateaus of the nano quadrotor do not determine its motor's constants: nobody is to take
/// them for the motor's.
void TestPublishedData::constantsInDoubtAreCalledSo() {
  const CaseResult* nano = find("crazyflie");
  const CaseResult* steps = find("esc-test");
  QVERIFY(nano != nullptr && steps != nullptr);
  const Table& constants = nano->tables.front();
  QCOMPARE(constants.header.back(), std::string("Doubt"));
  const QString doubt = QString::fromStdString(constants.rows.front().back());
  QVERIFY2(doubt.contains("at a bound: not determined by the points"), qPrintable(doubt));
  for (const auto& row : steps->tables.front().rows) QCOMPARE(row.back(), std::string("none"));
}

void TestPublishedData::unknownCaseIsNamed() {
  try {
    runCase("uiuc", EXPERIMENTS_DIR "/..");
    QFAIL("accepted");
  } catch (const InputError& error) {
    QVERIFY(QString(error.what()).contains("uiuc-global"));
  }
}

QTEST_GUILESS_MAIN(TestPublishedData)
#include "test_published_data.moc"
