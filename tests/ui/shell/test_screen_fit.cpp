// The window on a small screen, 1366 x 768 or one with a scale factor (the test's environment says
// which): it comes up within the screen, all of it can be reached, and so with every dialog.
#include <QDialog>
#include <QDirIterator>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>

#include "tests/ui/shell/shell_fixture.h"
#include "ui/charts/chart_pane.h"
#include "ui/runs/metrics_panel.h"
#include "ui/shell/screen_fit.h"

using namespace rotorbench;

namespace {

QRect room() {
  return QApplication::primaryScreen()->availableGeometry();
}

/// Where the widget is, seen in its window, as far as its parents let it be seen.
QRect shownRect(const QWidget& widget) {
  QRect rect = widget.rect();
  for (const QWidget* w = &widget; !w->isWindow(); w = w->parentWidget())
    rect = rect.translated(w->pos()) & w->parentWidget()->rect();
  return rect;
}

bool isSeenWhole(const QWidget& widget) {
  return widget.isVisible() && shownRect(widget).size() == widget.size();
}

QString sizeText(QSize size) {
  return QString("%1 x %2").arg(size.width()).arg(size.height());
}

QList<QWidget*> shownBeside(const QWidget& window) {
  QList<QWidget*> others;
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (widget != &window && widget->isVisible()) others << widget;
  return others;
}

void checkFits(const QWidget& window) {
  const QSize most = fittedSize({9999, 9999}, room().size());
  const QString name = window.objectName() + ' ';
  QVERIFY2(window.width() <= most.width() && window.height() <= most.height(),
           qPrintable(name + sizeText(window.size())));
}

}  // namespace

class TestScreenFit : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void fittedSizes_data();
  void fittedSizes();
  void firstSizeIsOfTheScreen();
  void sizeOfALargerScreenIsNotKept();
  void everyExperimentFits_data();
  void everyExperimentFits();
  void lowWindowScrollsToItsCharts();
  void dialogsFit_data();
  void dialogsFit();

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

void TestScreenFit::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  useSettingsIn(folder_->path());
  QLocale::setDefault(QLocale::c());
}

void TestScreenFit::fittedSizes_data() {
  QTest::addColumn<QSize>("screen");
  QTest::addColumn<QSize>("most");
  QTest::addRow("large") << QSize(2560, 1440) << QSize(1440, 900);
  QTest::addRow("laptop") << QSize(1366, 768) << QSize(1366, 768);
  QTest::addRow("1600 x 1000 at 1.5") << QSize(1066, 666) << QSize(1066, 666);
  QTest::addRow("tall") << QSize(1080, 1920) << QSize(1080, 900);
}

void TestScreenFit::fittedSizes() {
  QFETCH(QSize, screen);
  QFETCH(QSize, most);
  const QSize fitted = fittedSize({1440, 900}, screen);
  QCOMPARE(fitted, fitted.boundedTo(most));
  QVERIFY(fitted.width() > 0.95 * most.width() && fitted.height() > 0.9 * most.height());
}

void TestScreenFit::firstSizeIsOfTheScreen() {
  MainWindow window;
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  checkFits(window);
  QVERIFY2(window.width() > 0.95 * room().width() && window.height() > 0.9 * room().height(),
           qPrintable(sizeText(window.size())));
}

void TestScreenFit::sizeOfALargerScreenIsNotKept() {
  {
    MainWindow window;
    window.resize(2160, 1350);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.close();
  }
  MainWindow window;
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  QVERIFY2(window.width() <= room().width() && window.height() <= room().height(),
           qPrintable(sizeText(window.size())));
}

void TestScreenFit::everyExperimentFits_data() {
  QTest::addColumn<QString>("file");
  QDirIterator files(EXPERIMENTS_DIR, {"*.json"}, QDir::Files);
  while (files.hasNext()) {
    const QString file = files.next();
    QTest::newRow(QFileInfo(file).baseName().toUtf8()) << file;
  }
}

/// At its first size the window shows charts, metrics and status bar; it could be smaller still.
void TestScreenFit::everyExperimentFits() {
  QFETCH(QString, file);
  MainWindow window;
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  window.openFile(file);
  QTRY_VERIFY(window.workbench().isVisible());
  QTRY_VERIFY(!window.workbench().charts().panes().empty());
  QTest::qWait(100);  // the docks take their sizes
  checkFits(window);
  const QSize least = window.minimumSizeHint();
  QVERIFY2(least.width() <= 1024 && least.height() <= 620, qPrintable(sizeText(least)));
  const auto& metrics = window.workbench().metrics();
  QVERIFY(isSeenWhole(metrics));
  QVERIFY2(metrics.height() >= 90, qPrintable(sizeText(metrics.size())));
  QVERIFY(isSeenWhole(*window.findChild<QStatusBar*>("statusBar")));
  QVERIFY(isSeenWhole(*window.findChild<QToolBar*>("mainToolBar")));
  for (const ChartPane* pane : window.workbench().charts().panes()) {
    const QSize size = pane->size();
    QVERIFY2(size.width() >= 200 && size.height() >= 190, qPrintable(sizeText(size)));
    const QSizeF plot = pane->plot()->plotSize();
    QVERIFY2(plot.width() >= 90 && plot.height() >= 70, qPrintable(sizeText(plot.toSize())));
  }
}

void TestScreenFit::lowWindowScrollsToItsCharts() {
  MainWindow window;
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  window.openFile(EXPERIMENTS_DIR "/f450-hover-and-steps.json");
  QTRY_COMPARE(window.workbench().charts().panes().size(), std::size_t{7});
  QTest::qWait(100);
  auto* area = window.findChild<QScrollArea*>("chartArea");
  QVERIFY(area != nullptr);
  const ChartPane* last = window.workbench().charts().panes().back();
  QVERIFY(!isSeenWhole(*last));
  QTest::keyClick(area->verticalScrollBar(), Qt::Key_End);
  QTRY_VERIFY(isSeenWhole(*last));
}

void TestScreenFit::dialogsFit_data() {
  QTest::addColumn<QString>("action");
  for (const char* action :
       {"toolLibrary", "toolPropellerEditor", "toolDataSheet", "toolPerformance", "toolImport",
        "toolFit", "toolResiduals", "actionExport", "actionHelpContents", "actionAbout",
        "actionOpen", "actionSaveAs"})
    QTest::newRow(action) << action;
}

void TestScreenFit::dialogsFit() {
  QFETCH(QString, action);
  MainWindow window;
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  window.openFile(EXPERIMENTS_DIR "/f450-hover-and-steps.json");
  QTRY_VERIFY(window.workbench().isVisible());
  window.findChild<QAction*>(action)->trigger();
  QList<QWidget*> others;
  QTRY_VERIFY(!(others = shownBeside(window)).isEmpty());
  QTest::qWait(100);
  for (const QWidget* other : others) {
    checkFits(*other);
    const QRect frame = other->frameGeometry();
    QVERIFY2(
        room().contains(frame),
        qPrintable(
            QString("%1 at %2, %3").arg(sizeText(frame.size())).arg(frame.x()).arg(frame.y())));
  }
  for (QWidget* other : others) other->close();
}

QTEST_MAIN(TestScreenFit)
#include "test_screen_fit.moc"
