// Imported columns lie on the curves they belong to only if their names are those of the computed
// runs.
#include <QtTest>

#include "sim/document/experiment.h"
#include "sim/document/propeller_bench.h"
#include "sim/document/thrust_stand.h"
#include "sim/logs/quantity.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/finished_run.h"

using namespace rotorbench;

class TestQuantityNames : public QObject {
  Q_OBJECT

  static bool has(const Simulation& simulation, const std::string& name, std::string_view unit) {
    for (const RunOutput& run : simulation.runs()) {
      const auto at = run.recording->find(name);
      if (at && run.recording->channels()[*at].unit == unit) return true;
    }
    return false;
  }

 private slots:
  void measuredNamesAreComputedOnes_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("group");
    for (const char* key : {"throttle", "motor.speed", "thrust", "motor.torque", "supply.voltage",
                            "supply.current", "power.electrical", "power.shaft", "efficiency"}) {
      QTest::addRow("stand, over time: %s", key) << key << int(ChannelGroup::Run);
      QTest::addRow("stand, over throttle: %s", key) << key << int(ChannelGroup::OverThrottle);
    }
    for (const char* key : {"advance_ratio", "ct", "cp", "efficiency", "thrust", "motor.torque"})
      QTest::addRow("propeller: %s", key) << key << int(ChannelGroup::OverAdvance);
  }
  void measuredNamesAreComputedOnes() {
    QFETCH(QString, key);
    QFETCH(int, group);
    static const auto stand = [] {
      Experiment experiment;
      experiment.setup = ThrustStand{};
      return test::finished(experiment);
    }();
    static const auto bench = [] {
      Experiment experiment;
      experiment.setup = PropellerBench{};
      return test::finished(experiment);
    }();
    const auto family = static_cast<ChannelGroup>(group);
    const Quantity* quantity = findQuantity(key.toStdString());
    QVERIFY(quantity != nullptr);
    const std::string name = channelName(*quantity, family);
    QVERIFY2(has(family == ChannelGroup::OverAdvance ? *bench : *stand, name, quantity->unit),
             name.c_str());
  }
};

QTEST_APPLESS_MAIN(TestQuantityNames)
#include "test_quantity_names.moc"
