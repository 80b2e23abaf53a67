// A newly made experiment of any kind has charts, and every one of them finds channels in it.
#include <QRegularExpression>
#include <QTest>

#include "sim/core/schema_tree.h"
#include "sim/document/default_charts.h"
#include "sim/document/experiment.h"
#include "sim/run/simulation.h"

using namespace rotorbench;

namespace {

Experiment newOfKind(std::size_t kind) {
  Experiment experiment;
  schema::typeOf<Experiment>().field("setup")->choose(&experiment, kind);
  return experiment;
}

QStringList channelsOf(const Experiment& experiment) {
  QStringList names;
  const auto simulation = buildSimulation(experiment);
  for (const RunOutput& run : simulation->runs()) {
    for (const Channel& channel : run.recording->channels())
      names << QString::fromStdString(channel.name);
  }
  return names;
}

/// A * stands for any text without a dot.
bool finds(const QStringList& channels, const QString& pattern) {
  const QString expression = QRegularExpression::escape(pattern.trimmed()).replace("\\*", "[^.]*");
  return !channels.filter(QRegularExpression(QRegularExpression::anchoredPattern(expression)))
              .isEmpty();
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
  const QStringList channels = channelsOf(experiment);
  for (const ChartSpec& chart : charts) {
    QVERIFY(!chart.title.empty());
    QStringList patterns = QString::fromStdString(chart.channels).split(',');
    if (chart.kind == ChartKind::XY) patterns << QString::fromStdString(chart.x);
    for (const QString& pattern : patterns)
      QVERIFY2(finds(channels, pattern), qPrintable(pattern + " of " + channels.join(", ")));
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
