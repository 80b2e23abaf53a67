// Measured against computed, as a person reads it.
#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <QtTest>
#include <array>

#include "ui/charts/chart_pane.h"
#include "ui/measurement/residuals_dialog.h"

using namespace rotorbench;

namespace {

/// time, thrust = slope * time at 0, 1, 2, 3 s.
std::shared_ptr<Recording> line(double slope) {
  auto recording = std::make_shared<Recording>(
      std::vector<Channel>{{"time", "s", {}}, {"thrust", "N", {}}, {"throttle", "1", {}}});
  for (int i = 0; i < 4; ++i)
    if (!recording->append(std::array{1.0 * i, slope * i, 0.1 * i})) qFatal("no room");
  recording->publish();
  recording->finish();
  return recording;
}

void addComputed(RunList& runs, double slope) {
  RunStatus status;
  status.state = RunState::Finished;
  status.outputs.push_back({"stand", line(slope)});
  runs.setStatus(runs.add(Experiment{}), std::move(status));
}

}  // namespace

class TestResidualsDialog : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void showsFiguresAndResiduals();
  void saysWhatIsMissing();
};

/// Measured 2 t, computed t: residuals 0, 1, 2, 3; RMSE sqrt(14/4) = 1.871, mean 1.5.
void TestResidualsDialog::showsFiguresAndResiduals() {
  RunList runs;
  addComputed(runs, 1);
  runs.addMeasured("stand", "from a file", line(2));
  auto* dialog = new ResidualsDialog(runs);
  dialog->show();
  auto* table = dialog->findChild<QTableWidget*>("residualsTable");
  QCOMPARE(table->rowCount(), 2);
  QStringList row;
  for (int c = 0; c < table->columnCount(); ++c) row << table->item(0, c)->text();
  QCOMPARE(row, (QStringList{"thrust", "N", "4", "1.871", "1.5", "3", "0.3"}));
  const auto* chart = dialog->findChild<ChartPane*>("residualsChart");
  QCOMPARE(chart->curves().curves.size(), std::size_t{1});
  QVERIFY(!chart->curves().curves.front().style.line);
  QCOMPARE(chart->curves().curves.front().recording->value(1, 3), 3.0);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                    table->visualItemRect(table->item(1, 0)).center());
  QCOMPARE(chart->curves().curves.front().recording->value(1, 3), 0.0);
  const QString folder = qEnvironmentVariable("ROTORBENCH_PICTURES");
  if (!folder.isEmpty()) QVERIFY(dialog->grab().save(folder + "/residuals.png"));
  delete dialog;
}

void TestResidualsDialog::saysWhatIsMissing() {
  RunList runs;
  const auto sentence = [&runs] {
    const ResidualsDialog dialog(runs);
    return dialog.findChild<QLabel*>("residualsSentence")->text();
  };
  QCOMPARE(sentence(), QString("There are no measured data yet: import them first."));
  runs.addMeasured("stand", {}, line(2));
  QVERIFY(sentence().startsWith("No run has the horizontal axis"));
  addComputed(runs, 1);
  QCOMPARE(sentence(), QString());
}

QTEST_MAIN(TestResidualsDialog)
#include "test_residuals_dialog.moc"
