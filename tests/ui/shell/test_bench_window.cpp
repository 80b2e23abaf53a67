// The propeller bench in the window: another model chosen by keyboard or from the library and run,
// two models side by side, and what the charts say where a model has nothing to show.
#include <QComboBox>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "sim/document/experiment.h"
#include "sim/document/propeller_bench.h"
#include "tests/ui/shell/shell_fixture.h"
#include "ui/charts/chart_legend.h"
#include "ui/charts/chart_pane.h"
#include "ui/forms/problems_panel.h"
#include "ui/library/library_dialog.h"

using namespace rotorbench;

namespace {

/// Chooses an alternative by the arrow keys, as a person does who reads the box after each.
void chooseModel(MainWindow& window, const QString& path, const QString& wanted) {
  window.workbench().experiment().showSection(path);
  const auto box = [&] { return window.findChild<QComboBox*>(path); };
  QTRY_VERIFY(box() != nullptr && box()->isVisible());
  const int target = box()->findText(wanted);
  QVERIFY2(target >= 0, qPrintable(wanted));
  while (box()->currentIndex() != target) {
    const int next = box()->currentIndex() + (target > box()->currentIndex() ? 1 : -1);
    box()->setFocus();
    QTest::keyClick(box(), next > box()->currentIndex() ? Qt::Key_Down : Qt::Key_Up);
    QTRY_VERIFY(box() != nullptr && box()->currentIndex() == next);
  }
}

void runToTheEnd(MainWindow& window) {
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
}

ChartPane* paneTitled(MainWindow& window, const QString& title) {
  for (auto* pane : window.workbench().charts().panes()) {
    if (pane->spec().title == title.toStdString()) return pane;
  }
  return nullptr;
}

QStringList legendOf(const ChartPane* pane) {
  QStringList labels;
  for (const auto* item : pane->legend()->items()) labels << item->text();
  return labels;
}

QString problemsShown(MainWindow& window) {
  QString all;
  auto* list = window.workbench().problems().findChild<QTreeWidget*>("problems");
  for (QTreeWidgetItemIterator it(list); *it; ++it) {
    for (int column = 0; column < list->columnCount(); ++column) all += (*it)->text(column) + u'\n';
  }
  return all;
}

const PropellerBench& benchOf(MainWindow& window) {
  return alternative<PropellerBench>(window.documents().experiment().setup);
}

}  // namespace

class TestBenchWindow : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { useSettingsIn(folder_.path()); }

  void everyModelRuns_data() {
    QTest::addColumn<bool>("blades");
    QTest::addRow("Propeller map") << false;
    QTest::addRow("Measured propeller") << false;
    QTest::addRow("Propeller coefficients") << false;
    QTest::addRow("Lumped coefficients") << false;
    QTest::addRow("Blade elements") << true;
  }
  /// Charts fill for every model; along the blade they do, or say which model has it.
  void everyModelRuns() {
    QFETCH(bool, blades);
    MainWindow window;
    showWindow(window);
    openCard(window, "propeller-bench-10x47");
    chooseModel(window, "setup.propeller", QTest::currentDataTag());
    runToTheEnd(window);
    for (const char* title : {"Thrust and torque over time", "Thrust and torque over speed",
                              "CT, CP and efficiency over J", "Edgewise stream"}) {
      auto* pane = paneTitled(window, title);
      QVERIFY2(pane != nullptr, title);
      QTRY_VERIFY2(pane->plot()->pointCount() > 2, title);
      QVERIFY2(pane->plot()->hint().isEmpty(), qPrintable(pane->plot()->hint()));
    }
    auto* along = paneTitled(window, "Angles along the blade");
    if (blades) {
      QTRY_VERIFY(along->plot()->pointCount() > 2);
    } else {
      QCOMPARE(along->plot()->pointCount(), 0);
      QVERIFY2(along->plot()->hint().contains("by blade elements"),
               qPrintable(along->plot()->hint()));
    }
  }

  /// The measured component of the library, chosen as a person finds it; its limits stand in
  /// Problems.
  void measuredComponentFromTheLibrary() {
    MainWindow window;
    showWindow(window);
    openCard(window, "propeller-bench-10x47");
    window.workbench().experiment().showSection("setup.propeller");
    auto* button = window.findChild<QToolButton*>("setup.propeller.library");
    QVERIFY(button != nullptr && button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    LibraryDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = window.findChild<LibraryDialog*>()) != nullptr && dialog->isVisible());
    QTest::keyClicks(dialog->findChild<QLineEdit*>("librarySearch"),
                     "coefficients slow flyer 10 x 4.7 wind tunnel");
    QTest::mouseClick(dialog->findChild<QPushButton*>("libraryUse"), Qt::LeftButton);
    QTRY_VERIFY(std::holds_alternative<MeasuredPropeller>(benchOf(window).propeller));
    QVERIFY(std::get<MeasuredPropeller>(benchOf(window).propeller).points.size() > 50);
    QTRY_VERIFY2(problemsShown(window).contains("he curve of the measured propeller ends at J ="),
                 qPrintable(problemsShown(window)));
    QVERIFY(problemsShown(window).contains("ends at 66"));  // 6528 rpm and 2 %
    runToTheEnd(window);
    auto* pane = paneTitled(window, "CT, CP and efficiency over J");
    QTRY_VERIFY(pane->plot()->pointCount() > 10);
  }

  /// A geometry goes into the model that is chosen, not into the first that takes one.
  void geometryGoesIntoTheChosenModel() {
    MainWindow window;
    showWindow(window);
    openCard(window, "propeller-bench-10x47");
    chooseModel(window, "setup.propeller", "Propeller map");
    QTest::mouseClick(window.findChild<QToolButton*>("setup.propeller.library"), Qt::LeftButton);
    LibraryDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = window.findChild<LibraryDialog*>()) != nullptr && dialog->isVisible());
    QTest::keyClicks(dialog->findChild<QLineEdit*>("librarySearch"),
                     "slow-flyer blades of 11 in pitch 4.7");
    QTest::mouseClick(dialog->findChild<QPushButton*>("libraryUse"), Qt::LeftButton);
    QTRY_VERIFY(dialog == nullptr || !window.findChild<LibraryDialog*>());
    const auto* map = std::get_if<MapPropeller>(&benchOf(window).propeller);
    QVERIFY(map != nullptr);
    QCOMPARE(map->propeller.diameter, 11 * 0.0254);
  }

  void twoModelsSideBySide() {
    MainWindow window;
    showWindow(window);
    openCard(window, "propeller-bench-10x47");
    chooseModel(window, "setup.second", "Propeller map");
    runToTheEnd(window);
    auto* pane = paneTitled(window, "Thrust and torque over time");
    QTRY_COMPARE(legendOf(pane).size(), 4);
    QVERIFY(legendOf(pane).contains("Run, blade elements: thrust"));
    QVERIFY(legendOf(pane).contains("Run, propeller map: thrust"));
    // Along the blade the one is alone.
    auto* along = paneTitled(window, "Angles along the blade");
    QTRY_VERIFY(along->plot()->pointCount() > 2);
    QCOMPARE(legendOf(along).size(), 3);
    // The figures of both stand in the table.
    QString heads;
    for (auto* table : window.findChildren<QTableWidget*>()) {
      for (int c = 0; c < table->columnCount(); ++c) {
        if (table->horizontalHeaderItem(c) != nullptr)
          heads += table->horizontalHeaderItem(c)->text() + u'\n';
      }
    }
    QVERIFY2(heads.contains("blade elements") && heads.contains("propeller map"),
             qPrintable(heads));
  }

 private:
  QTemporaryDir folder_;
};

QTEST_MAIN(TestBenchWindow)
#include "test_bench_window.moc"
