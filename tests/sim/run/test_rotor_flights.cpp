// Flights with four, six and eight rotors by every way of control, in air that moves. A build with
// assertions fills the lanes beyond the last rotor with NaN: none of it may be seen.
#include <QTest>
#include <cmath>

#include "sim/document/experiment_file.h"
#include "tests/sim/run/finished_run.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

Experiment flight(const std::string& count, const std::string& control, const std::string& more) {
  return readExperiment(R"({"rotorbench": 1, "setup": {"type": "flight", "duration": 0.4,
    "vehicle": {"layout": {"type": "plus", "count": ")" +
                            count + R"("}}, "control": )" + control + more + "}}",
                        "flight.json");
}

std::string constant(const char* type, const char* key, int rotors, const char* value) {
  std::string values;
  for (int i = 0; i < rotors; ++i) values += (i == 0 ? "" : ", ") + std::string(value);
  return std::string(R"({"type": ")") + type + R"(", "source": {"type": "constant", ")" + key +
         R"(": [)" + values + "]}}";
}

}  // namespace

class TestRotorFlights : public QObject {
  Q_OBJECT
 private slots:
  void fly_data() {
    QTest::addColumn<std::string>("count");
    QTest::addColumn<int>("rotors");
    QTest::addColumn<std::string>("control");
    const std::pair<const char*, int> counts[] = {{"quad", 4}, {"hexa", 6}, {"octo", 8}};
    for (const auto& [count, rotors] : counts) {
      QTest::addRow("%s, controller", count)
          << std::string(count) << rotors
          << std::string(R"({"type": "controlled", "setPoints": [{"time": 0, "height": 1,
               "roll": 0.1, "pitch": -0.1, "yaw": 0.2}]})");
      QTest::addRow("%s, speeds", count)
          << std::string(count) << rotors << constant("rotor-speeds", "speeds", rotors, "480");
      QTest::addRow("%s, voltages", count)
          << std::string(count) << rotors << constant("motor-voltages", "voltages", rotors, "5");
    }
  }
  void fly() {
    QFETCH(std::string, count);
    QFETCH(int, rotors);
    QFETCH(std::string, control);
    const auto simulation = finished(flight(count, control,
                                            R"(, "environment": {"air": {"type": "standard"},
        "wind": {"type": "logarithmic", "velocity": [3, 2]}}, "start": {"position": [0, 0, 5]})"));
    const Recording& r = *simulation->runs().front().recording;
    QVERIFY(r.rows() > 300);
    for (std::size_t c = 0; c < r.channels().size(); ++c) {
      for (std::size_t row = 0; row < r.rows(); ++row)
        QVERIFY2(std::isfinite(r.value(c, row)), r.channels()[c].name.c_str());
    }
    const auto has = [&](int rotor) {
      return r.find("rotor" + std::to_string(rotor) + ".thrust").has_value();
    };
    QVERIFY(has(rotors) && !has(rotors + 1));
    QVERIFY(value(r, "wind.x", 1) > 2 && value(r, "air.density", 1) < 1.225);
    // Each rotor turns and lifts.
    for (int i = 1; i <= rotors; ++i)
      QVERIFY(value(r, "rotor" + std::to_string(i) + ".thrust", r.rows() - 1) > 0.5);
  }

  /// A hover begins in the air of its own height: thinner there, so faster, and balanced.
  void hoversWhereItBegins_data() {
    QTest::addColumn<double>("height");
    QTest::addRow("at sea level") << 0.0;
    QTest::addRow("high up") << 3000.0;
  }
  void hoversWhereItBegins() {
    QFETCH(double, height);
    const auto simulation = finished(
        flight("hexa",
               R"({"type": "controlled", "setPoints": [{"time": 0, "height": )" +
                   std::to_string(height) + "}]}",
               R"(, "environment": {"air": {"type": "standard"}}, "start": {"position": [0, 0, )" +
                   std::to_string(height) + "]}"));
    const Recording& r = *simulation->runs().front().recording;
    QVERIFY(std::abs(value(r, "acceleration.z", 0)) < 1e-9);
    const double density = value(r, "air.density", 0), speed = value(r, "rotor1.speed", 0);
    // Speed goes with the inverse root of the density.
    static double atSea = 0;
    if (height == 0) atSea = speed * std::sqrt(density);
    QVERIFY(std::abs(speed * std::sqrt(density) / atSea - 1) < 1e-5);
  }
};

QTEST_APPLESS_MAIN(TestRotorFlights)
#include "test_rotor_flights.moc"
