// From recordings to the points, ranges and labels a chart draws. Expected extremes come from
// looking at every row; expected ticks are what a person would choose.
#include <QTest>
#include <QtMath>
#include <algorithm>
#include <atomic>
#include <random>
#include <thread>

#include "chart_fixture.h"
#include "sim/core/schema.h"
#include "sim/core/schema_tree.h"
#include "ui/charts/axis_scale.h"
#include "ui/charts/channel_pattern.h"
#include "ui/charts/chart_theme.h"
#include "ui/charts/curves.h"
#include "ui/charts/decimate.h"

using namespace rotorbench;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Extremes bruteForce(const Recording& recording, std::size_t channel, std::size_t first,
                    std::size_t last, bool positive) {
  Extremes e;
  for (std::size_t row = first; row < last; ++row) {
    const double v = recording.value(channel, row);
    if (!std::isfinite(v) || (positive && !(v > 0))) continue;
    if (v < e.min) e.min = v, e.rowOfMin = static_cast<std::uint32_t>(row);
    if (v > e.max) e.max = v, e.rowOfMax = static_cast<std::uint32_t>(row);
  }
  return e;
}

/// Noise with repeats, NaN, infinities and signs; time in irregular steps, some of them zero.
std::shared_ptr<Recording> noise(std::size_t rows, unsigned seed) {
  auto recording =
      std::make_shared<Recording>(std::vector<Channel>{{"time", "s", ""}, {"v", "1", ""}});
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> level(-50, 50), chance(0, 99);
  double t = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const int dice = chance(random);
    double v = level(random) * 0.25;
    if (dice == 0) v = kNan;
    if (dice == 1) v = kInf;
    if (dice == 2) v = -kInf;
    const double row[] = {t, v};
    recording->append(row);
    if (dice > 5) t += 0.001 * (1 + dice % 7);
  }
  recording->publish();
  return recording;
}

}  // namespace

class TestChartData : public QObject {
  Q_OBJECT

 private slots:
  void summaryEqualsBruteForce_data();
  void summaryEqualsBruteForce();
  void summaryGrowsInSmallPieces();
  void decimationKeepsExtremes_data();
  void decimationKeepsExtremes();
  void decimationWhileWriting();
  void xyTraceKeepsThePathWithinAPixel();
  void patterns_data();
  void patterns();
  void curvesOfSpec_data();
  void curvesOfSpec();
  void removingFromAWildcard();
  void ticks_data();
  void ticks();
  void niceRange_data();
  void niceRange();
  void zoomKeepsThePlaceUnderThePointer_data();
  void zoomKeepsThePlaceUnderThePointer();
  void stylesSingleAndSeveralRuns();
  void readableColours();
  void specIsDescribed();
};

void TestChartData::summaryEqualsBruteForce_data() {
  QTest::addColumn<int>("rows");
  QTest::addColumn<bool>("positive");
  for (const int rows : {0, 1, 63, 64, 65, 511, 513, 4095, 4096, 4097, 33000, 100000}) {
    for (const bool positive : {false, true})
      QTest::addRow("%d rows, positive %d", rows, positive) << rows << positive;
  }
}

void TestChartData::summaryEqualsBruteForce() {
  QFETCH(int, rows);
  QFETCH(bool, positive);
  const auto count = static_cast<std::size_t>(rows);
  const auto recording = noise(count, 7);
  ColumnSummary summary(recording, 1,
                        positive ? ColumnSummary::Values::Positive : ColumnSummary::Values::All);
  QCOMPARE(summary.extend(count + 10), count);
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> any(0, count);
  for (int i = 0; i < 200; ++i) {
    auto [first, last] = std::minmax({any(random), any(random)});
    if (i == 0) first = 0, last = count;
    const Extremes expected = bruteForce(*recording, 1, first, last, positive);
    const Extremes found = summary.extremes(first, last);
    QCOMPARE(found.min, expected.min);
    QCOMPARE(found.max, expected.max);
    if (expected.empty()) continue;
    QCOMPARE(found.rowOfMin, expected.rowOfMin);
    QCOMPARE(found.rowOfMax, expected.rowOfMax);
  }
}

void TestChartData::summaryGrowsInSmallPieces() {
  auto recording = std::make_shared<Recording>(fixture::channels());
  ColumnSummary summary(recording, 1, ColumnSummary::Values::All);
  std::mt19937 random(3);
  std::uniform_int_distribution<int> piece(1, 700);
  int rows = 0;
  while (rows < 30000) {
    for (int i = piece(random); i > 0; --i) fixture::appendRow(*recording, rows++ * 0.01);
    recording->publish();
    summary.extend(static_cast<std::size_t>(piece(random)));
    const std::size_t covered = summary.rows();
    QVERIFY(covered <= recording->rows());
    const Extremes e = summary.extremes(covered / 3, covered);
    const Extremes expected = bruteForce(*recording, 1, covered / 3, covered, false);
    QCOMPARE(e.max, expected.max);
    QCOMPARE(e.min, expected.min);
  }
}

void TestChartData::decimationKeepsExtremes_data() {
  QTest::addColumn<double>("low");
  QTest::addColumn<double>("high");
  QTest::addColumn<int>("columns");
  QTest::addRow("all") << 0.0 << 1000.0 << 300;
  QTest::addRow("part") << 20.0 << 90.0 << 777;
  QTest::addRow("few rows") << 20.0 << 20.2 << 500;
  QTest::addRow("between two rows") << 20.0001 << 20.0002 << 100;
  QTest::addRow("before the start") << -50.0 << -1.0 << 100;
  QTest::addRow("past the end") << 150.0 << 5000.0 << 100;
}

void TestChartData::decimationKeepsExtremes() {
  QFETCH(double, low);
  QFETCH(double, high);
  QFETCH(int, columns);
  const auto recording = noise(60000, 5);
  ColumnSummary summary(recording, 1, ColumnSummary::Values::All);
  summary.extend(100000);
  const AxisScale scale{{low, high}, false};
  ColumnBounds bounds;
  const auto points = TimeTrace().update(
      *recording, summary, scale, bounds.update(*recording, recording->rows(), scale, columns));
  QVERIFY(points.size() <= 4 * columns + 4);
  QVERIFY(
      std::is_sorted(points.begin(), points.end(), [](auto a, auto b) { return a.x() < b.x(); }));
  // Per pixel column, the extremes of the drawn points are those of all rows.
  std::vector<Extremes> expected(static_cast<std::size_t>(columns)), drawn = expected;
  const auto column = [&](double t) {
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>(scale.toUnit(t) * columns), 0, columns - 1));
  };
  const auto put = [](Extremes& e, double v) {
    e.min = std::min(e.min, v), e.max = std::max(e.max, v);
  };
  for (std::size_t row = 0; row < recording->rows(); ++row) {
    const double t = recording->value(0, row);
    const double v = recording->value(1, row);
    if (t >= low && t <= high && std::isfinite(v)) put(expected[column(t)], v);
  }
  for (const QPointF& p : points) {
    if (p.x() >= low && p.x() <= high) put(drawn[column(p.x())], p.y());
  }
  int differing = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    differing += expected[i].min != drawn[i].min || expected[i].max != drawn[i].max;
  }
  // A row on the very border of two columns may round either way.
  QVERIFY2(differing <= columns / 50, qPrintable(QString::number(differing)));
  const auto least = [](const auto& all) {
    return std::min_element(all.begin(), all.end(), [](auto& a, auto& b) { return a.min < b.min; })
        ->min;
  };
  QCOMPARE(least(drawn), least(expected));
}

void TestChartData::decimationWhileWriting() {
  auto recording = std::make_shared<Recording>(fixture::channels());
  std::thread writer([recording] {
    for (int i = 0; i < 200000; ++i) {
      fixture::appendRow(*recording, i * 0.001);
      if (i % 97 == 0) recording->publish();
    }
    recording->finish();
  });
  ColumnSummary summary(recording, 1, ColumnSummary::Values::All);
  bool sorted = true;
  bool onTheLine = true;
  bool done = false;
  const AxisScale scale{{0, 200}, false};
  ColumnBounds bounds;
  TimeTrace trace;
  QList<QPointF> points;
  while (!done) {
    done = recording->finished();
    summary.extend(1'000'000);
    points = trace.update(*recording, summary, scale,
                          bounds.update(*recording, recording->rows(), scale, 200));
    sorted = sorted && std::is_sorted(points.begin(), points.end(),
                                      [](auto a, auto b) { return a.x() < b.x(); });
    for (const QPointF& p : points) onTheLine = onTheLine && p.y() == 1 + p.x();
  }
  writer.join();
  QVERIFY(sorted);
  QVERIFY(onTheLine);
  QCOMPARE(summary.rows(), std::size_t{200000});
  QCOMPARE(summary.extremes(0, 200000).max, 1 + 199999 * 0.001);
  // What grew step by step is what one look at the whole gives.
  ColumnBounds fresh;
  QCOMPARE(points, TimeTrace().update(*recording, summary, scale,
                                      fresh.update(*recording, 200000, scale, 200)));
}

void TestChartData::xyTraceKeepsThePathWithinAPixel() {
  auto recording = std::make_shared<Recording>(
      std::vector<Channel>{{"time", "s", ""}, {"x", "m", ""}, {"y", "m", ""}});
  const AxisScale scale{{-1, 1}, false};
  XyTrace trace;
  for (int i = 0; i < 50000; ++i) {
    const double angle = i * 2 * M_PI / 25000;
    const double row[] = {i * 1e-3, std::cos(angle), std::sin(angle)};
    recording->append(row);
    if (i % 1000 != 0) continue;
    recording->publish();
    trace.update(*recording, 1, 2, scale, scale, 100, 100, 100000);
  }
  recording->finish();
  trace.update(*recording, 1, 2, scale, scale, 100, 100, 100000);
  QVERIFY(trace.complete(*recording));
  // Two turns through the cells of a 100 px circle: at most about 8 radii of cells, two points
  // each.
  QVERIFY(trace.points().size() < 1700);
  QVERIFY(trace.points().size() > 400);
  for (const QPointF& p : trace.points()) QVERIFY(std::abs(std::hypot(p.x(), p.y()) - 1) < 1e-12);
  QCOMPARE(trace.points().last(), QPointF(recording->value(1, 49999), recording->value(2, 49999)));
}

void TestChartData::patterns_data() {
  QTest::addColumn<QString>("pattern");
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("matches");
  QTest::addColumn<QString>("star");
  QTest::addRow("plain") << "position.z"
                         << "position.z" << true << "";
  QTest::addRow("prefix is not enough") << "position"
                                        << "position.z" << false << "";
  QTest::addRow("number") << "rotor*.thrust"
                          << "rotor3.thrust" << true << "3";
  QTest::addRow("not over a dot") << "rotor*.thrust"
                                  << "rotor3.motor.thrust" << false << "";
  QTest::addRow("method with brackets") << "*.evaluations"
                                        << "RK5(4)7M.evaluations" << true << "RK5(4)7M";
  QTest::addRow("empty star") << "rotor*"
                              << "rotor" << true << "";
  QTest::addRow("case counts") << "Rotor*"
                               << "rotor1" << false << "";
}

void TestChartData::patterns() {
  QFETCH(QString, pattern);
  QFETCH(QString, name);
  QFETCH(bool, matches);
  QFETCH(QString, star);
  const auto found = matchPattern(pattern.toStdString(), name.toStdString());
  QCOMPARE(found.has_value(), matches);
  if (matches && !found->empty()) QCOMPARE(QString::fromStdString(found->front()), star);
}

void TestChartData::curvesOfSpec_data() {
  QTest::addColumn<bool>("xy");
  QTest::addColumn<QString>("x");
  QTest::addColumn<QString>("y");
  QTest::addColumn<QString>("curves");  // "xIndex-yIndex"
  QTest::addRow("wildcard") << false << ""
                            << "rotor*.thrust"
                            << "0-1 0-2";
  QTest::addRow("no repeats") << false << ""
                              << "rotor1.thrust, rotor*.thrust"
                              << "0-1 0-2";
  QTest::addRow("x is unused over time") << false << "z"
                                         << "rotor1.thrust"
                                         << "0-1";
  QTest::addRow("paired by method") << true << "*.evaluations"
                                    << "*.max_error_norm"
                                    << "3-4 5-6";
  QTest::addRow("one x for all") << true << "rotor1.thrust"
                                 << "rotor2.thrust,euler.evaluations"
                                 << "1-2 1-5";
  QTest::addRow("x wildcard, y plain") << true << "*.evaluations"
                                       << "rotor1.thrust"
                                       << "3-1";
  QTest::addRow("no partner") << true << "*.evaluations"
                              << "*.thrust"
                              << "";
  QTest::addRow("nothing") << false << ""
                           << " , "
                           << "";
}

void TestChartData::curvesOfSpec() {
  QFETCH(bool, xy);
  QFETCH(QString, x);
  QFETCH(QString, y);
  QFETCH(QString, curves);
  std::vector<Channel> channels;
  for (const char* name : {"time", "rotor1.thrust", "rotor2.thrust", "rk4.evaluations",
                           "rk4.max_error_norm", "euler.evaluations", "euler.max_error_norm"}) {
    channels.push_back({name, "1", ""});
  }
  ChartSpec spec;
  spec.kind = xy ? ChartKind::XY : ChartKind::Time;
  spec.x = x.toStdString();
  spec.channels = y.toStdString();
  QStringList found;
  for (const auto& c : resolveCurves(spec, channels))
    found += QStringLiteral("%1-%2").arg(c.x).arg(c.y);
  QCOMPARE(found.join(u' '), curves);
}

void TestChartData::removingFromAWildcard() {
  ChartSpec spec;
  spec.channels = "rotor*.thrust, position.x";
  QCOMPARE(withChannel(spec, "rotor2.thrust"), spec);
  QCOMPARE(withChannel(spec, "error").channels, std::string("rotor*.thrust, position.x, error"));
  QCOMPARE(withoutChannel(spec, "rotor2.thrust", fixture::channels()).channels,
           std::string("rotor1.thrust, rotor3.thrust, rotor4.thrust, position.x"));
}

void TestChartData::ticks_data() {
  QTest::addColumn<double>("low");
  QTest::addColumn<double>("high");
  QTest::addColumn<bool>("log");
  QTest::addColumn<QString>("locale");
  QTest::addColumn<QString>("labels");
  QTest::addColumn<int>("exponent");
  QTest::addRow("0 to 10") << 0.0 << 10.0 << false << "C"
                           << "0 2 4 6 8 10" << 0;
  QTest::addRow("about zero") << -0.3 << 0.3 << false << "C"
                              << "−0.2 0.0 0.2" << 0;
  QTest::addRow("German comma") << 0.0 << 1.0 << false << "de_DE"
                                << "0,0 0,2 0,4 0,6 0,8 1,0" << 0;
  QTest::addRow("small numbers share a power") << 0.0 << 2e-9 << false << "C"
                                               << "0.0 0.5 1.0 1.5 2.0" << -9;
  QTest::addRow("large numbers share a power") << 0.0 << 4e6 << false << "C"
                                               << "0 1 2 3 4" << 6;
  QTest::addRow("decades") << 1e-9 << 1e-6 << true << "C"
                           << "10⁻⁹ 10⁻⁸ 10⁻⁷ 10⁻⁶" << 0;
  QTest::addRow("plain decades") << 0.1 << 100.0 << true << "C"
                                 << "0.1 1 10 100" << 0;
  QTest::addRow("within a decade") << 2.0 << 8.0 << true << "C"
                                   << "2 4 6 8" << 0;
}

void TestChartData::ticks() {
  QFETCH(double, low);
  QFETCH(double, high);
  QFETCH(bool, log);
  QFETCH(QString, locale);
  QFETCH(QString, labels);
  QFETCH(int, exponent);
  const AxisScale scale{{low, high}, log};
  const Ticks found = niceTicks(scale, log && high / low < 10 ? 8 : 5, QLocale(locale));
  QStringList texts;
  for (const auto& tick : found.major) {
    texts += tick.label;
    QVERIFY(scale.toUnit(tick.value) > -1e-9 && scale.toUnit(tick.value) < 1 + 1e-9);
  }
  QCOMPARE(texts.join(u' '), labels);
  QCOMPARE(found.exponent, exponent);
}

void TestChartData::niceRange_data() {
  QTest::addColumn<double>("low");
  QTest::addColumn<double>("high");
  QTest::addColumn<bool>("log");
  QTest::addColumn<double>("niceLow");
  QTest::addColumn<double>("niceHigh");
  QTest::addRow("rounded out") << 0.13 << 9.4 << false << 0.0 << 10.0;
  QTest::addRow("already nice") << 0.0 << 10.0 << false << 0.0 << 10.0;
  QTest::addRow("a constant") << 5.0 << 5.0 << false << 4.4 << 5.6;
  QTest::addRow("all zero") << 0.0 << 0.0 << false << -1.0 << 1.0;
  QTest::addRow("nothing") << kInf << -kInf << false << 0.0 << 1.0;
  QTest::addRow("decades") << 3e-7 << 0.2 << true << 1e-7 << 1.0;
  QTest::addRow("one decade at least") << 10.0 << 10.0 << true << 10.0 << 100.0;
  QTest::addRow("no logarithm") << -1.0 << 1.0 << true << 0.1 << 1.0;
}

void TestChartData::niceRange() {
  QFETCH(double, low);
  QFETCH(double, high);
  QFETCH(bool, log);
  QFETCH(double, niceLow);
  QFETCH(double, niceHigh);
  const Span span = niceSpan({low, high}, log, 5);
  QVERIFY2(qFuzzyCompare(1 + span.low, 1 + niceLow), qPrintable(QString::number(span.low)));
  QVERIFY2(qFuzzyCompare(span.high, niceHigh), qPrintable(QString::number(span.high)));
}

void TestChartData::zoomKeepsThePlaceUnderThePointer_data() {
  QTest::addColumn<bool>("log");
  QTest::addRow("linear") << false;
  QTest::addRow("logarithmic") << true;
}

void TestChartData::zoomKeepsThePlaceUnderThePointer() {
  QFETCH(bool, log);
  const AxisScale before{{1, 1000}, log};
  for (const double place : {0.0, 0.3, 1.0}) {
    const AxisScale after{zoomed(before, place, 0.5), log};
    QVERIFY(std::abs(after.toUnit(before.fromUnit(place)) - place) < 1e-12);
    const AxisScale back{zoomed(after, place, 2), log};
    QVERIFY(std::abs(back.span.high / 1000 - 1) < 1e-9);
  }
  const AxisScale moved{panned(before, 0.25), log};
  QVERIFY(std::abs(moved.toUnit(before.fromUnit(0.25))) < 1e-12);
}

void TestChartData::stylesSingleAndSeveralRuns() {
  RunSet runs;
  runs.add(fixture::run("1", fixture::ramp(10), Qt::red));
  ChartSpec spec;
  spec.channels = "rotor*.thrust, position.x";
  auto list = chartCurves(spec, runs, {});
  QCOMPARE(list.curves.size(), std::size_t{5});
  QCOMPARE(list.curves[0].label, QStringLiteral("rotor1.thrust"));
  QVERIFY(list.curves[0].style.color != list.curves[1].style.color);
  QCOMPARE(list.curves[2].style.dash, 2);
  QCOMPARE(list.units, (std::vector<std::string>{"N", "m"}));
  QCOMPARE(axisQuantity(list, 0), QStringLiteral("thrust"));
  QCOMPARE(axisQuantity(list, 1), QStringLiteral("position.x"));
  runs.add(fixture::run("2", fixture::ramp(10), Qt::blue));
  list = chartCurves(spec, runs, {});
  QCOMPARE(list.curves.size(), std::size_t{10});
  QCOMPARE(list.curves[7].label, QStringLiteral("Run 2: rotor3.thrust"));
  QCOMPARE(list.curves[7].style.color, QColor(Qt::blue));
  QCOMPARE(list.curves[7].style.dash, list.curves[2].style.dash);
  QCOMPARE(list.curves[0].style.color, QColor(Qt::red));
}

void TestChartData::readableColours() {
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(27, 30, 32));
  dark.setColor(QPalette::Text, Qt::white);
  const ChartTheme theme = ChartTheme::of(dark);
  QVERIFY(theme.dark);
  QVERIFY(theme.readable(QColor(0, 114, 178)).lightness() > QColor(0, 114, 178).lightness());
  QVERIFY(!ChartTheme::paper().dark);
  QCOMPARE(ChartTheme::paper().readable(QColor(0, 114, 178)), QColor(0, 114, 178));
}

void TestChartData::specIsDescribed() {
  ChartSpec spec;
  schema::setFromText(schema::ref(spec), "kind", "xy");
  schema::setFromText(schema::ref(spec), "channels", "rotor*.thrust");
  schema::setFromText(schema::ref(spec), "logY", "true");
  QCOMPARE(spec.kind, ChartKind::XY);
  QCOMPARE(spec.channels, std::string("rotor*.thrust"));
  QVERIFY(spec.logY);
}

QTEST_GUILESS_MAIN(TestChartData)
#include "test_chart_data.moc"
