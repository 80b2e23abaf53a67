// A newly made experiment of any kind has charts, and every one of them finds channels in it.
#include <QTest>

#include "sim/core/schema_tree.h"
#include "sim/document/default_charts.h"
#include "sim/document/experiment.h"
#include "tests/sim/run/charted_channels.h"

using namespace rotorbench;

namespace {

Experiment newOfKind(std::size_t kind) {
  Experiment experiment;
  schema::typeOf<Experiment>().field("setup")->choose(&experiment, kind);
  return experiment;
}

}  // namespace

class TestDefaultCharts : public QObject {
  Q_OBJECT

 private slots:
  void everyKindHasChartsThatFindTheirChannels_data();
  void everyKindHasChartsThatFindTheirChannels();
  void chartsOfTheFileComeFirst();
};

void TestDefaultCharts::everyKindHasChartsThatFindTheirChannels_data() {
  QTest::addColumn<std::size_t>("kind");
  const auto& kinds = schema::typeOf<Experiment>().field("setup")->options;
  for (std::size_t k = 0; k < kinds.size(); ++k) QTest::addRow("%s", kinds[k].key.c_str()) << k;
}

void TestDefaultCharts::everyKindHasChartsThatFindTheirChannels() {
  QFETCH(std::size_t, kind);
  const Experiment experiment = newOfKind(kind);
  QVERIFY(experiment.outputs.charts.empty());
  const std::vector<ChartSpec> charts = chartsOf(experiment);
  QVERIFY(charts.size() >= 3);
  const auto simulation = buildSimulation(experiment);
  for (const ChartSpec& chart : charts) {
    QVERIFY(!chart.title.empty());
    const QStringList missing = test::undrawn(chart, simulation->runs(), test::Wanted::Names);
    QVERIFY2(missing.empty(), qPrintable(missing.join(", ")));
  }
}

void TestDefaultCharts::chartsOfTheFileComeFirst() {
  Experiment experiment;
  ChartSpec own;
  own.title = "Own";
  own.channels = "position.z";
  experiment.outputs.charts = {own};
  QVERIFY(chartsOf(experiment) == experiment.outputs.charts);
}

QTEST_APPLESS_MAIN(TestDefaultCharts)
#include "test_default_charts.moc"
