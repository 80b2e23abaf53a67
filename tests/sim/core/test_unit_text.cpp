// Units as they are printed, and that what is printed is understood when it is typed.
#include <QtTest>
#include <set>

#include "sim/core/unit_text.h"
#include "sim/core/units.h"

using namespace rotorbench;

class TestUnitText : public QObject {
  Q_OBJECT
 private slots:
  /// Signs: SI brochure, 9th edition, section 5.4 and table 4.
  void prettyUnits_data() {
    QTest::addColumn<QString>("symbol");
    QTest::addColumn<QString>("pretty");
    const auto row = [](const char* symbol, const char* pretty) {
      QTest::addRow("%s", symbol) << symbol << pretty;
    };
    row("", "");
    row("1", "");
    row("%", "%");
    row("rpm", "rpm");
    row("rad/s^2", "rad/s²");
    row("kg*m^2", "kg·m²");
    row("kg/m^3", "kg/m³");
    row("T^-1", "T⁻¹");
    row("m^4", "m⁴");
    row("Ohm", "Ω");
    row("mOhm", "mΩ");
    row("J/(kg*K)", "J/(kg·K)");
    row("deg", "°");
    row("deg/s", "°/s");
    row("N*m/deg", "N·m/°");
    row("1/deg", "1/°");
    row("degC", "°C");
    row("uH", "µH");
    row("uN*m", "µN·m");
    row("us", "µs");
    // No micro and no degree: words that only begin like them.
    row("unit", "unit");
    row("u", "u");
    row("degree", "degree");
    row("^", "^");
    row("12.5 mOhm", "12.5 mΩ");
    row("-3e-05 kg*m^2", "-3e-05 kg·m²");
  }
  void prettyUnits() {
    QFETCH(QString, symbol);
    const std::string pretty = prettyUnit(symbol.toStdString());
    QTEST(QString::fromStdString(pretty), "pretty");
    QCOMPARE(prettyUnit(pretty), pretty);
  }

  void printedUnitsReadBack() {
    std::set<std::string> seen;
    for (const char* dimension :
         {"m",     "m^2",     "kg",    "s",        "Hz",    "rad",     "rad/s",  "rad/s^2",
          "m/s",   "m/s^2",   "N",     "N*m",      "Pa",    "K",       "V",      "A",
          "Ohm",   "H",       "C",     "W",        "J",     "kg*m^2",  "kg/m^3", "Pa*s",
          "m^2/s", "rad/s/V", "V*s",   "N*m/A",    "N*s^2", "N*m*s^2", "N*m*s",  "N*m/rad",
          "N/W",   "N*s/m",   "1/rad", "J/(kg*K)", "rad/m", "T"}) {
      QVERIFY2(!unitsLike(dimension).empty(), dimension);
      for (const Unit* unit : unitsLike(dimension)) {
        const std::string pretty = prettyUnit(unit->symbol);
        QCOMPARE(canonicalUnit(pretty), std::string(unit->symbol));
        QVERIFY2(seen.insert(pretty).second, pretty.c_str());
      }
    }
  }

  void superscripts() {
    QCOMPARE(superscript(-9), std::string("⁻⁹"));
    QCOMPARE(superscript(0), std::string("⁰"));
    QCOMPARE(superscript(1234567890), std::string("¹²³⁴⁵⁶⁷⁸⁹⁰"));
  }
};

QTEST_GUILESS_MAIN(TestUnitText)
#include "test_unit_text.moc"
