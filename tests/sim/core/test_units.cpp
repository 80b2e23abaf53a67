#include <QTest>
#include <cmath>
#include <numbers>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/core/units.h"

using namespace rotorbench;

class TestUnits : public QObject {
  Q_OBJECT

 private slots:
  void convert_data();
  void convert();
  void spellings_data();
  void spellings();
  void unlikeUnitsDoNotConvert();
  void everyUnitConvertsToItsDimension();
  void unknownUnits();
  void quantities_data();
  void quantities();
  void faults_data();
  void faults();
  void shownNumbersReadBack_data();
  void shownNumbersReadBack();
  void utf8_data();
  void utf8();
};

// Exact definitions: yard and pound agreement of 1959; g0 = 9.80665 m/s^2 (CGPM 1901); the rest by
// prefix.
void TestUnits::convert_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("from");
  QTest::addColumn<QString>("to");
  QTest::addColumn<double>("expected");
  const double pi = std::numbers::pi;
  QTest::addRow("inch") << 9.45 << "in"
                        << "m" << 0.24003;
  QTest::addRow("foot in inches") << 1.0 << "ft"
                                  << "in" << 12.0;
  QTest::addRow("pound in ounces") << 1.0 << "lb"
                                   << "oz" << 16.0;
  QTest::addRow("gram") << 117.0 << "g"
                        << "kg" << 0.117;
  QTest::addRow("rpm") << 60.0 << "rpm"
                       << "rad/s" << 2 * pi;
  QTest::addRow("rev/s in rpm") << 1.0 << "rev/s"
                                << "rpm" << 60.0;
  QTest::addRow("deg/s in rpm") << 360.0 << "deg/s"
                                << "rpm" << 60.0;
  QTest::addRow("kilogram-force") << 1.0 << "kgf"
                                  << "N" << 9.80665;
  QTest::addRow("gram-force") << 1000.0 << "gf"
                              << "kgf" << 1.0;
  QTest::addRow("pound-force") << 1.0 << "lbf"
                               << "N" << 4.4482216152605;
  QTest::addRow("Kv") << 960.0 << "rpm/V"
                      << "rad/s/V" << 960 * pi / 30;
  QTest::addRow("mAh") << 2200.0 << "mAh"
                       << "C" << 7920.0;
  QTest::addRow("inertia") << 1.0 << "g*cm^2"
                           << "kg*m^2" << 1e-7;
  QTest::addRow("thrust factor") << 1.0 << "N/rpm^2"
                                 << "N*s^2" << 900 / (pi * pi);
  QTest::addRow("speed") << 36.0 << "km/h"
                         << "m/s" << 10.0;
  QTest::addRow("milliohm") << 117.0 << "mOhm"
                            << "Ohm" << 0.117;
  QTest::addRow("percent") << 12.5 << "%"
                           << "1" << 0.125;
  QTest::addRow("hours in minutes") << 1.5 << "h"
                                    << "min" << 90.0;
  QTest::addRow("density") << 1.0 << "g/cm^3"
                           << "kg/m^3" << 1000.0;
}

void TestUnits::convert() {
  QFETCH(double, value);
  QFETCH(QString, from);
  QFETCH(QString, to);
  QFETCH(double, expected);
  const double there = convertUnit(value, from.toStdString(), to.toStdString());
  QVERIFY2(std::abs(there - expected) <= 4e-16 * std::abs(expected),
           qPrintable(QString::number(there, 'g', 17)));
  const double back = convertUnit(there, to.toStdString(), from.toStdString());
  QVERIFY(std::abs(back - value) <= 4e-16 * std::abs(value));
}

void TestUnits::spellings_data() {
  QTest::addColumn<QString>("written");
  QTest::addColumn<QString>("canonical");
  for (const auto& [written, canonical] :
       std::initializer_list<std::pair<const char*, const char*>>{
           {"Ω", "Ohm"},
           {"Ω", "Ohm"},
           {"mΩ", "mOhm"},
           {"ohm", "Ohm"},
           {"µs", "us"},
           {"μs", "us"},
           {"N m", "N*m"},
           {"N·m", "N*m"},
           {"Nm", "N*m"},
           {"N ⋅ m", "N*m"},
           {"kg m²", "kg*m^2"},
           {"kg·m^2", "kg*m^2"},
           {"g cm²", "g*cm^2"},
           {"m/s²", "m/s^2"},
           {"kg/m³", "kg/m^3"},
           {"°", "deg"},
           {"°/s", "deg/s"},
           {"rad/(V*s)", "rad/s/V"},
           {"rad/(V s)", "rad/s/V"},
           {"1/min", "rpm"},
           {"N/(rad/s)²", "N*s^2"},
           {"N·s²", "N*s^2"},
           {"V s", "V*s"},
           {"N m/A", "N*m/A"},
           {"", "1"},
           {" cm ", "cm"},
           {"1/s", "Hz"},
           {"N s/m", "N*s/m"},
           {"furlong  per²", "furlong*per^2"}}) {
    QTest::addRow("[%s]", written) << written << canonical;
  }
}

void TestUnits::spellings() {
  QFETCH(QString, written);
  QFETCH(QString, canonical);
  QCOMPARE(QString::fromStdString(canonicalUnit(written.toStdString())), canonical);
  QVERIFY(sameDimension(written.toStdString(), canonical.toStdString()));
}

void TestUnits::unlikeUnitsDoNotConvert() {
  QVERIFY_THROWS_EXCEPTION(InputError, convertUnit(1, "m", "kg"));
  QVERIFY_THROWS_EXCEPTION(InputError, convertUnit(1, "m", "furlong"));
  QVERIFY(!sameDimension("rad/s", "Hz"));
}

void TestUnits::everyUnitConvertsToItsDimension() {
  for (const char* si : {"m",       "kg",    "rad", "rad/s",   "s",   "N",      "N*m",     "V",
                         "A",       "Ohm",   "H",   "C",       "W",   "kg*m^2", "rad/s/V", "N*s^2",
                         "N*m*s^2", "N*s/m", "N/m", "N*m*s",   "V*s", "N*m/A",  "Hz",      "1",
                         "kg/m^3",  "m/s^2", "m/s", "rad/s^2", "Pa",  "K",      "J",       "B"}) {
    const auto units = unitsLike(si);
    QVERIFY2(!units.empty(), si);
    QCOMPARE(units.front()->symbol, std::string_view(si));
    QCOMPARE(units.front()->factor, 1.0);
    for (const Unit* unit : units) {
      QCOMPARE(findUnit(unit->symbol), unit);
      QVERIFY(unit->factor > 0 && std::isfinite(unit->factor));
    }
  }
}

void TestUnits::unknownUnits() {
  QVERIFY(findUnit("furlong") == nullptr);
  QVERIFY(unitsLike("furlong").empty());
  QCOMPARE(convertUnit(3.5, "N*m*s/furlong", "N m s/furlong"), 3.5);
  const auto parsed = parseQuantity("2.5 N*m/furlong", "N·m/furlong", "N·m/furlong");
  QCOMPARE(parsed.value.value_or(0), 2.5);
}

void TestUnits::quantities_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("unit");
  QTest::addColumn<double>("expected");
  QTest::addRow("inches") << "9.45 in"
                          << "m" << 9.45 * 0.0254;
  QTest::addRow("no space") << "250g"
                            << "kg" << 0.25;
  QTest::addRow("decimal comma") << "0,25"
                                 << "m" << 0.25;
  QTest::addRow("product") << "3*2"
                           << "m" << 6.0;
  QTest::addRow("precedence") << "1 + 2 * 3 - 4 / 2"
                              << "1" << 5.0;
  QTest::addRow("parentheses") << "-(1 + 2) * 3"
                               << "1" << -9.0;
  QTest::addRow("fraction of an inch") << "1/2 in"
                                       << "m" << 0.0127;
  QTest::addRow("radius from diameter") << "9.45 in / 2"
                                        << "m" << 9.45 / 2 * 0.0254;
  QTest::addRow("Kv") << "960 rpm/V"
                      << "rad/s/V" << 960 * std::numbers::pi / 30;
  QTest::addRow("exponent") << "1e-3"
                            << "m" << 1e-3;
  QTest::addRow("exponent with plus") << "1E+3 mm"
                                      << "m" << 1.0;
  QTest::addRow("percent") << "12.5 %"
                           << "1" << 0.125;
  QTest::addRow("ohm sign") << "117 mΩ"
                            << "Ohm" << 0.117;
  QTest::addRow("per second") << "4 1/s"
                              << "Hz" << 4.0;
  QTest::addRow("leading point") << ".5 m"
                                 << "m" << 0.5;
  QTest::addRow("spelled product") << "2 N m"
                                   << "N*m" << 2.0;
}

void TestUnits::quantities() {
  QFETCH(QString, text);
  QFETCH(QString, unit);
  QFETCH(double, expected);
  const auto parsed = parseQuantity(text.toStdString(), unit.toStdString(), unit.toStdString());
  QCOMPARE(parsed.error, std::string());
  QCOMPARE(*parsed.value, expected);
}

void TestUnits::faults_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("error");
  const char* units = "; must be a number in kg, g, lb, oz";
  for (const auto& [text, error] : std::initializer_list<std::pair<const char*, const char*>>{
           {"", "there is no number"},
           {"heavy", "\"heavy\" is not a number"},
           {"1 m", "\"1 m\" is in m"},
           {"1 stone", "\"1 stone\" has the unknown unit stone"},
           {"1 kg + 2 g", "\"1 kg + 2 g\" has more than one unit"},
           {"1.000,5", "\"1.000,5\" is not a number"},
           {"nan", "\"nan\" is not a number"},
           {"inf", "\"inf\" is not a number"},
           {"1e999", "\"1e999\" is not a finite number"},
           {"1/0", "\"1/0\" divides by zero"},
           {"(1", "\"(1\" lacks a closing parenthesis"},
           {"1 2", "\"1 2\" is not a number with a unit"},
           {"0x10", "\"0x10\" has the unknown unit x10"}}) {
    QTest::addRow("[%s]", text) << text << error + QString(units);
  }
  QTest::addRow("long") << QString(1000, '(')
                        << QString("\"%1...\" is too long%2").arg(QString(60, '('), units);
}

void TestUnits::faults() {
  QFETCH(QString, text);
  QFETCH(QString, error);
  const auto parsed = parseQuantity(text.toStdString(), "kg", "kg");
  QVERIFY(!parsed.value);
  QCOMPARE(QString::fromStdString(parsed.error), error);
}

void TestUnits::shownNumbersReadBack_data() {
  QTest::addColumn<double>("si");
  QTest::addColumn<double>("factor");
  QTest::addColumn<QString>("text");
  QTest::addRow("plain") << 0.1 << 1.0 << "0.1";
  QTest::addRow("inch") << 0.24003 << 0.0254 << "9.45";
  QTest::addRow("milliohm") << 0.117 << 0.001 << "117";
  QTest::addRow("degree") << 30 * (std::numbers::pi / 180) << std::numbers::pi / 180 << "30";
  QTest::addRow("zero") << 0.0 << 0.001 << "0";
  QTest::addRow("negative") << -0.05 << 0.01 << "-5";
}

void TestUnits::shownNumbersReadBack() {
  QFETCH(double, si);
  QFETCH(double, factor);
  QFETCH(QString, text);
  QCOMPARE(QString::fromStdString(numberTextIn(si, factor)), text);
}

void TestUnits::utf8_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<bool>("valid");
  // Table 3-7 of the Unicode standard: well-formed byte sequences.
  QTest::addRow("ascii") << QByteArray("abc") << true;
  QTest::addRow("two bytes") << QByteArray("\xC3\xA4") << true;
  QTest::addRow("three bytes") << QByteArray("\xE2\x82\xAC") << true;
  QTest::addRow("four bytes") << QByteArray("\xF0\x9F\x9A\x81") << true;
  QTest::addRow("overlong") << QByteArray("\xC0\xAF") << false;
  QTest::addRow("overlong in three") << QByteArray("\xE0\x80\xAF") << false;
  QTest::addRow("surrogate") << QByteArray("\xED\xA0\x80") << false;
  QTest::addRow("beyond") << QByteArray("\xF4\x90\x80\x80") << false;
  QTest::addRow("cut short") << QByteArray("a\xE2\x82") << false;
  QTest::addRow("stray") << QByteArray("a\x80") << false;
}

void TestUnits::utf8() {
  QFETCH(QByteArray, bytes);
  QFETCH(bool, valid);
  QCOMPARE(!findInvalidUtf8(bytes.toStdString()).has_value(), valid);
  QVERIFY(!findInvalidUtf8(excerpt(bytes.toStdString())).has_value());
}

QTEST_GUILESS_MAIN(TestUnits)
#include "test_units.moc"
