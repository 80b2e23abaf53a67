// A full-scale propeller with a known section, NACA TR-594 propeller C, against its wind-tunnel coefficients. Nothing
// is fitted to it: its own polar, the global momentum factor.
#include <QtTest>
#include <cmath>

#include "sim/io/csv.h"
#include "sim/propulsion/blade_element.h"

using namespace rotorbench;

class TestFullScalePropeller : public QObject {
  Q_OBJECT
 private slots:
  void coefficientsAreThoseOfTheTunnel();

 private:
  static CsvTable table(const char* name) {
    return readCsvFile(std::string(TEST_DATA_DIR "/naca_tr594/") + name);
  }
  static PropellerGeometry propeller();
};

PropellerGeometry TestFullScalePropeller::propeller() {
  PropellerGeometry g;
  g.diameter = 3.054;
  g.blades = 3;
  g.pitch = 0;
  g.line = BladeLine::Standard;
  g.rootRadius = 2 * 0.375 / g.diameter;
  g.stations.clear();
  const CsvTable blade = table("blade.csv"), polar = table("clark_y.csv");
  const auto radius = blade.values("radius", "m"), chord = blade.values("chord", "m");
  const auto twist = blade.values("twist", "rad");
  for (std::size_t i = 0; i < blade.rows(); ++i) {
    g.stations.push_back({2 * radius[i] / g.diameter, 2 * chord[i] / g.diameter, twist[i]});
  }
  PolarSection section;
  section.name = "Clark Y";
  section.polars = {{5e5, {}}};
  const auto alpha = polar.values("alpha", "rad"), lift = polar.values("cl", "1");
  const auto drag = polar.values("cd", "1");
  for (std::size_t i = 0; i < polar.rows(); ++i) {
    section.polars.front().points.push_back({alpha[i], lift[i], drag[i]});
  }
  g.sections = {{0, section}};
  return g;
}

/// Root of the mean square difference over all advance ratios, in percent of the measured static value: at most 4.
void TestFullScalePropeller::coefficientsAreThoseOfTheTunnel() {
  const BladeElementRotor rotor(propeller());
  const CsvTable measured = table("coefficients.csv");
  const auto advance = measured.values("J", "1"), thrust = measured.values("CT", "1");
  const auto power = measured.values("CP", "1");
  const AirState air{1.225, 1.81e-5};
  const double n = 1100.0 / 60, d = 2 * rotor.radius();
  const double scale = air.density * n * n * std::pow(d, 4);
  double thrustSquare = 0, powerSquare = 0;
  for (std::size_t i = 0; i < measured.rows(); ++i) {
    const AxialLoad load = rotor.axial(2 * M_PI * n, advance[i] * n * d, air);
    const double ct = load.thrust / scale, cp = load.torque * 2 * M_PI / (scale * d);
    qInfo("J %.2f  CT %.4f, measured %.4f  CP %.4f, measured %.4f", advance[i], ct, thrust[i], cp,
          power[i]);
    thrustSquare += std::pow(ct - thrust[i], 2);
    powerSquare += std::pow(cp - power[i], 2);
  }
  QCOMPARE(measured.rows(), std::size_t(17));
  const double rows = static_cast<double>(measured.rows());
  const double thrustError = 100 * std::sqrt(thrustSquare / rows) / thrust.front();
  const double powerError = 100 * std::sqrt(powerSquare / rows) / power.front();
  qInfo("rms: CT %.2f %%, CP %.2f %% of static", thrustError, powerError);
  QVERIFY(thrustError <= 4);
  QVERIFY(powerError <= 4);
}

QTEST_GUILESS_MAIN(TestFullScalePropeller)
#include "test_full_scale_propeller.moc"
