#include <QtTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/io/json_document.h"
#include "sim/propulsion/rotor/blade.h"

using namespace rotorbench;

namespace {

constexpr double kDegree = M_PI / 180;

/// The layout XFOIL 6.9 writes with PACC; the numbers are made up.
const char* const kXfoilText = R"(
       XFOIL         Version 6.96

 Calculated polar for: NACA 0012

 1 1 Reynolds number fixed          Mach number fixed

 xtrf =   1.000 (top)        1.000 (bottom)
 Mach =   0.000     Re =     0.100 e 6     Ncrit =   9.000

   alpha    CL        CD       CDp       CM     Top_Xtr  Bot_Xtr
  ------ -------- --------- --------- -------- -------- --------
   0.000   0.0000   0.01470   0.00650   0.0000   0.8700   0.8700
   4.000   0.4300   0.01700   0.00800   0.0010   0.5200   0.9900
  -2.000  -0.2200   0.01550   0.00700  -0.0005   0.9500   0.7100
)";

QString faultOf(const QString& text) {
  try {
    readXfoilPolar(text.toStdString(), "polar.txt");
  } catch (const InputError& error) {
    return QString::fromUtf8(error.what());
  }
  return "read";
}

PolarSection twoPolars() {
  PolarSection section;
  section.polars = {{1e5, {{-0.1, -0.5, 0.02}, {0, 0.1, 0.01}, {0.15, 1.0, 0.04}}},
                    {4e5, {{-0.1, -0.6, 0.01}, {0, 0.1, 0.006}, {0.15, 1.2, 0.02}}}};
  return section;
}

}  // namespace

class TestSections : public QObject {
  Q_OBJECT
 private slots:
  void analyticSectionIsThinAerofoilBelowStall();
  void everySectionBecomesAPlate_data();
  void everySectionBecomesAPlate();
  void coefficientsAreContinuous();
  void rotationDelaysTheStall();
  void slowFlyersLiftMore();
  void polarsHoldAtTheirPoints();
  void dragOfASinglePolarFollowsReynolds();
  void polarsAreLinearInTheLogarithmOfReynolds();
  void xfoilPolarIsRead();
  void brokenXfoilPolarsAreNamed_data();
  void brokenXfoilPolarsAreNamed();
  void printedPitchIsBlendedIn();
  void shapeIsLinearBetweenStations();
  void geometryGoesThroughJson();
  void impossibleGeometryIsRefused_data();
  void impossibleGeometryIsRefused();
};

/// Far from stall, cl = cla (a - a0) and cd = cd0: the definition of the constants.
void TestSections::analyticSectionIsThinAerofoilBelowStall() {
  SectionConstants c;
  c.stallWidth = 0.01;  // a sharp stall leaves the attached flow alone
  const AnalyticCurve curve(c, {0.18, 0, false}, 1e5);
  QVERIFY(std::abs(curve.zeroLift() - c.zeroLift) < 1e-6);
  QVERIFY(std::abs(curve.lift(c.zeroLift)) < 1e-5);
  QVERIFY(std::abs(curve.lift(c.zeroLift + 0.05) / (0.05 * c.liftSlope) - 1) < 1e-4);
  QVERIFY(std::abs(curve.at(c.zeroLift + 0.05).drag / c.profileDrag - 1) < 1e-3);
  QCOMPARE(curve.lift(0.3), curve.at(0.3).lift);
}

void TestSections::everySectionBecomesAPlate_data() {
  QTest::addColumn<double>("alpha");
  QTest::addColumn<double>("normal");  // 2 sin a/(0.56 + 0.44 |sin a|): Hoerner
  QTest::addRow("broadside") << 90.0 << 2.0;
  QTest::addRow("from above") << -90.0 << -2.0;
  QTest::addRow("60 degrees") << 60.0 << 1.84055;
  QTest::addRow("from behind") << 150.0 << 1.28205;
}

/// Beyond stall a force along the plate's normal, and along the stream the drag of the section: of
/// the analytic one 5.3 profile drags, of a polar its least.
void TestSections::everySectionBecomesAPlate() {
  QFETCH(double, alpha);
  QFETCH(double, normal);
  const double a = alpha * kDegree;
  const SectionConstants constants;
  const AnalyticCurve analytic(constants, {0.2, 0, false}, 8e4);
  const PreparedPolars prepared(twoPolars());
  const PolarCurve polar = prepared.curve({0.2, 0, false}, 2e5);
  const auto isPlate = [&](const SectionCoefficients& c, double drag, double allowed) {
    const double lift = c.lift - normal * std::cos(a), rest = c.drag - normal * std::sin(a) - drag;
    QVERIFY2(std::abs(lift) < allowed && std::abs(rest) < allowed,
             qPrintable(QString("lift %1, drag %2 beside the plate's").arg(lift).arg(rest)));
  };
  // To the digits above: the stall is over e^-17 at 60 degrees.
  const double profile = constants.profileDrag * std::pow(0.8, constants.profileDragReynolds);
  isPlate(analytic.at(a), constants.separatedDragFactor * profile, 1e-5);
  // Half-way between the two in ln Re. At 60 degrees, 51 beyond the last point, the glide of 10 has
  // left e^-5.1 of what that point lifts more than a plate, 0.63.
  isPlate(polar.at(a), (0.01 + 0.006) / 2, 4e-3);
}

void TestSections::coefficientsAreContinuous() {
  const AnalyticCurve analytic({}, {0.2, 0.5, true}, 5e4);
  PolarSection section = twoPolars();
  section.stallDelay = 3;
  const PreparedPolars prepared(section);
  const PolarCurve polar = prepared.curve({0.2, 0.5, true}, 2e5);
  constexpr double kStep = 1e-4;
  for (double a = -M_PI; a < M_PI; a += kStep) {
    // The steepest slopes: attached lift, 2 pi, twice over in the drop behind stall.
    QVERIFY(std::abs(analytic.lift(a + kStep) - analytic.lift(a)) < 14 * kStep);
    QVERIFY(std::abs(polar.lift(a + kStep) - polar.lift(a)) < 14 * kStep);
    QVERIFY(polar.at(a).drag > 0 && analytic.at(a).drag > 0);
  }
  QVERIFY(std::abs(analytic.lift(M_PI) - analytic.lift(-M_PI)) < 1e-6);
}

void TestSections::rotationDelaysTheStall() {
  const double stalled = 0.35;  // rad, well behind the stall, before the delay fades
  const AnalyticCurve tip({}, {0.2, 0, false}, 8e4), root({}, {0.2, 0.6, false}, 8e4);
  QVERIFY(root.lift(stalled) > 1.5 * tip.lift(stalled));
  QVERIFY(std::abs(root.lift(1.4) - tip.lift(1.4)) < 0.01);
  PolarSection section = twoPolars();
  const double without = PreparedPolars(section).curve({0.2, 0.3, false}, 1e5).lift(stalled);
  section.stallDelay = 3;
  const double with = PreparedPolars(section).curve({0.2, 0.3, false}, 1e5).lift(stalled);
  QVERIFY(with > without + 0.1);
}

void TestSections::slowFlyersLiftMore() {
  const SectionConstants c;
  const AnalyticCurve plain(c, {0.18, 0, false}, 1e5), slow(c, {0.18, 0, true}, 1e5);
  QVERIFY(std::abs(plain.zeroLift() - slow.zeroLift() - c.slowFlyerCamber) < 1e-15);
}

/// The least drag as a laminar boundary layer's, the rest of the polar as it is; several polars say
/// themselves what their drag does.
void TestSections::dragOfASinglePolarFollowsReynolds() {
  PolarSection section;
  section.polars = {{1e5, {{-5 * kDegree, -0.4, 0.02}, {0, 0.1, 0.01}, {10 * kDegree, 1, 0.03}}}};
  const auto at = [&](double reynolds, double alpha) {
    return PreparedPolars(section).curve({0.2, 0.3, false}, reynolds).at(alpha);
  };
  QVERIFY(std::abs(at(4e5, 0).drag - 0.005) < 1e-12);
  QVERIFY(std::abs(at(2.5e4, 0).drag - 0.02) < 1e-12);
  QVERIFY(std::abs(at(2.5e4, 10 * kDegree).drag - 0.04) < 1e-12);
  QVERIFY(std::abs(at(1e3, 0).drag - at(1e4, 0).drag) < 1e-15);
  QVERIFY(std::abs(at(1e7, 0).drag - at(1e6, 0).drag) < 1e-15);
  QCOMPARE(at(4e5, 0.05).lift, at(1e5, 0.05).lift);
  section.dragExponent = 0;
  QVERIFY(std::abs(at(4e5, 0).drag - 0.01) < 1e-12);
  section = twoPolars();
  const double several = at(3e4, 0.05).drag;
  section.dragExponent = 0;
  QCOMPARE(at(3e4, 0.05).drag, several);
}

void TestSections::polarsHoldAtTheirPoints() {
  PolarSection section;
  section.polars = {{1e5, {{-5 * kDegree, -0.4, 0.02}, {0, 0.1, 0.01}, {10 * kDegree, 1, 0.03}}}};
  const PreparedPolars prepared(section);
  const PolarCurve curve = prepared.curve({0.2, 0.3, false}, 1e5);
  for (const PolarPoint& p : section.polars.front().points) {
    QVERIFY(std::abs(curve.at(p.alpha).lift - p.lift) < 1e-9);
    QVERIFY(std::abs(curve.at(p.alpha).drag - p.drag) < 1e-9);
  }
  QVERIFY(std::abs(curve.zeroLift() + 1 * kDegree) < 1e-12);
}

void TestSections::polarsAreLinearInTheLogarithmOfReynolds() {
  const PreparedPolars prepared(twoPolars());
  const double alpha = 3 * kDegree;
  const auto at = [&](double re) { return prepared.curve({0.2, 0, false}, re).at(alpha).lift; };
  QVERIFY(std::abs(at(2e5) - (at(1e5) + at(4e5)) / 2) < 1e-12);
  QCOMPARE(at(1e3), at(1e5));
  QCOMPARE(at(0), at(1e5));
  QCOMPARE(at(1e7), at(4e5));
}

void TestSections::xfoilPolarIsRead() {
  const Polar polar = readXfoilPolar(kXfoilText, "polar.txt");
  QCOMPARE(polar.reynolds, 1e5);
  QCOMPARE(polar.points.size(), std::size_t(3));
  QVERIFY((polar.points[0] == PolarPoint{-2 * kDegree, -0.22, 0.0155}));  // sorted by angle
  QVERIFY((polar.points[2] == PolarPoint{4 * kDegree, 0.43, 0.017}));
}

void TestSections::brokenXfoilPolarsAreNamed_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("fault");
  const QString good = kXfoilText;
  QTest::addRow("empty") << QString() << "polar.txt: no table of a polar is found";
  QTest::addRow("no Reynolds number")
      << QString(good).remove("Re =") << "polar.txt: the Reynolds number is missing";
  QTest::addRow("strange Reynolds number")
      << QString(good).replace("0.100 e", "lots e") << "line 9: the Reynolds number cannot be read";
  QTest::addRow("Reynolds number of nought")
      << QString(good).replace("0.100 e", "0.000 e") << "line 9: the Reynolds number cannot be";
  QTest::addRow("no drag") << QString(good).replace(" CD ", " CX ")
                           << "line 11: the table lacks a column";
  QTest::addRow("text in a number")
      << QString(good).replace("0.4300", "0.43oo") << "line 14: CL is \"0.43oo\"; a number from";
  QTest::addRow("decimal comma") << QString(good).replace("0.4300", "0,4300")
                                 << "line 14: CL is \"0,4300\"";
  QTest::addRow("not a number") << QString(good).replace("0.4300", "nan") << "line 14: CL is";
  QTest::addRow("negative drag") << QString(good).replace("0.01700", "-0.0170")
                                 << "line 14: CD is \"-0.0170\"";
  QTest::addRow("short line") << good + "  5.000 0.5\n"
                              << "line 16: the number for CD is missing";
  QTest::addRow("angle twice") << good + "  4.000 0.5 0.02\n"
                               << "line 16: this angle of attack";
  QTest::addRow("one angle") << good.section('\n', 0, 12) + '\n' << "fewer than two angles";
}

void TestSections::brokenXfoilPolarsAreNamed() {
  QFETCH(QString, text);
  QFETCH(QString, fault);
  const QString said = faultOf(text);
  QVERIFY2(said.contains(fault), qPrintable(said));
  QCOMPARE(said.count('\n'), 0);
}

/// Twist 20 degrees at 75 % against a pitch whose angle there is atan(0.5/(0.75 pi)) = 11.98
/// degrees.
void TestSections::printedPitchIsBlendedIn() {
  PropellerGeometry g;
  g.stations = {{0.2, 0.2, 20 * kDegree}, {1, 0.1, 20 * kDegree}};
  g.pitch = 0.5 * g.diameter;
  const double blended = bladeShape(g, 0.75, nominalPitchBlend(g)).twist / kDegree;
  QVERIFY(std::abs(blended - (0.59 * 20 + 0.41 * 11.98)) < 0.005);
  g.pitch = 0;
  QCOMPARE(nominalPitchBlend(g), 0.0);
}

void TestSections::shapeIsLinearBetweenStations() {
  PropellerGeometry g;
  g.stations = {{0.2, 0.2, 0.4}, {0.6, 0.3, 0.2}, {1, 0.1, 0.1}};
  g.twistOffset = 0.01;
  const BladeShape middle = bladeShape(g, 0.4, 0);
  QVERIFY(std::abs(middle.chord - 0.25) < 1e-15 && std::abs(middle.twist - 0.31) < 1e-15);
  QVERIFY(std::abs(bladeShape(g, 0.1, 0).chord - 0.2) < 1e-15);
  QVERIFY(std::abs(bladeShape(g, 1.0, 0).twist - 0.11) < 1e-15);
}

void TestSections::geometryGoesThroughJson() {
  PropellerGeometry g;
  g.sections.push_back({0.5, twoPolars()});
  g.line = BladeLine::Standard;
  const std::string text = writeDocument(schema::ref(std::as_const(g)));
  PropellerGeometry back;
  readDocument(schema::ref(back), text, "propeller.json");
  QVERIFY(back == g);
}

void TestSections::impossibleGeometryIsRefused_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("value");
  QTest::addColumn<QString>("fault");
  QTest::addRow("falling radii") << "stations[1].radius"
                                 << "0.1"
                                 << "stations[1].radius: is not above";
  QTest::addRow("no blades") << "blades"
                             << "0"
                             << "blades";
  QTest::addRow("negative chord") << "stations[3].chord"
                                  << "-0.1"
                                  << "stations[3].chord";
  QTest::addRow("twist past upright") << "stations[3].twist"
                                      << "100 deg"
                                      << "stations[3].twist";
  QTest::addRow("no diameter") << "diameter"
                               << "0"
                               << "diameter";
}

void TestSections::impossibleGeometryIsRefused() {
  QFETCH(QString, path);
  QFETCH(QString, value);
  QFETCH(QString, fault);
  PropellerGeometry g;
  QVERIFY(schema::validate(schema::ref(g)).empty());
  try {
    schema::setFromText(schema::ref(g), path.toStdString(), value.toStdString());
    const std::vector<Problem> problems = schema::validate(schema::ref(g));
    QCOMPARE(problems.size(), std::size_t(1));
    QVERIFY(QString::fromStdString(problems[0].message()).startsWith(fault));
  } catch (const InputError& error) {
    QVERIFY2(QString::fromUtf8(error.what()).startsWith(fault), error.what());
  }
}

QTEST_GUILESS_MAIN(TestSections)
#include "test_sections.moc"
