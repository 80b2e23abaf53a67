// The legend of panes of every size a person can make: each curve can be told apart by what is
// painted, read-outs give way before names do, and the tool tip has everything.
#include <QApplication>
#include <QImage>
#include <QScrollBar>
#include <QTest>

#include "chart_fixture.h"
#include "ui/charts/chart_legend.h"
#include "ui/charts/chart_pane.h"

using namespace rotorbench;

namespace {

/// Curves with names as long as those of a propeller bench with two models.
std::shared_ptr<Recording> advanceRatios(double factor) {
  auto recording = std::make_shared<Recording>(
      std::vector<Channel>{{"over_advance.j", "1", "Advance ratio"},
                           {"over_advance.ct", "1", "Thrust coefficient"},
                           {"over_advance.cp", "1", "Power coefficient"},
                           {"over_advance.efficiency", "1", "Thrust times speed over power"}});
  for (int i = 0; i <= 100; ++i) {
    const double j = i / 100.0;
    recording->append(std::array{j, factor * (0.12345 - 0.1 * j), factor * (0.05432 - 0.02 * j),
                                 factor * 1e-5 * j});
  }
  recording->publish();
  recording->finish();
  return recording;
}

struct Bench {
  RunSet runs;
  ChartLink link;
  ChartPane pane{&runs, &link};
  explicit Bench(bool twoRuns) {
    runs.add({"1", "Over advance ratio, blade elements", QColor(0, 114, 178), advanceRatios(1)});
    if (twoRuns) {
      runs.add({"2", "Over advance ratio, measured propeller", QColor(213, 94, 0),
                advanceRatios(-1.01)});
    }
    pane.setSpec({"Coefficients", ChartKind::XY, "over_advance.j",
                  "over_advance.ct, over_advance.cp, over_advance.efficiency"});
    pane.show();
    if (!QTest::qWaitForWindowExposed(&pane)) qFatal("not shown");
  }
  [[nodiscard]] const std::vector<LegendItem*>& items() const { return pane.legend()->items(); }
};

QString paintedName(const LegendItem& item) {
  return item.place().lines.join(QString()).remove(u' ');
}

/// Whether anything is painted in this part of an item.
bool isPainted(const QImage& image, const QRect& part) {
  const QRgb ground = image.pixel(image.width() - 1, image.height() - 1);
  for (int y = part.top(); y <= part.bottom(); ++y) {
    for (int x = part.left(); x <= part.right(); ++x) {
      if (image.rect().contains(x, y) && image.pixel(x, y) != ground) return true;
    }
  }
  return false;
}

}  // namespace

class TestChartLegend : public QObject {
  Q_OBJECT

 private slots:
  void everyCurveCanBeToldApart_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("twoRuns");
    QTest::addColumn<int>("cursors");
    // 281 x 185: six panes in a window of 1200 x 800. 200 x 150: the smallest a pane can be.
    for (const QSize size : {QSize(200, 150), QSize(281, 185), QSize(240, 320), QSize(299, 199),
                             QSize(420, 260), QSize(700, 240), QSize(900, 600)}) {
      for (const bool twoRuns : {false, true}) {
        for (int cursors = 0; cursors <= 2; ++cursors) {
          QTest::addRow("%d x %d, %d run(s), %d cursor(s)", size.width(), size.height(),
                        twoRuns ? 2 : 1, cursors)
              << size << twoRuns << cursors;
        }
      }
    }
  }

  void everyCurveCanBeToldApart() {
    QFETCH(QSize, size);
    QFETCH(bool, twoRuns);
    QFETCH(int, cursors);
    Bench b(twoRuns);
    b.pane.resize(size);
    if (cursors > 0) b.link.setCursor(Cursor::A, 0.25);
    if (cursors > 1) b.link.setCursor(Cursor::B, 0.75);
    QTest::qWait(0);
    QCOMPARE(b.pane.size(), size);
    QCOMPARE(b.items().size(), twoRuns ? std::size_t{6} : std::size_t{3});
    QStringList names;
    int bottom = 0;
    for (LegendItem* item : b.items()) {
      const LegendPlace& place = item->place();
      const QString name = paintedName(*item);
      names << name;
      // The name is whole: the full one or the short one, nothing left out.
      QVERIFY2(name == item->entry().label.simplified().remove(u' ') ||
                   name == item->entry().shortLabel.simplified().remove(u' '),
               qPrintable(name));
      const QString channel = item->entry().channel.section('.', -1);
      QVERIFY2(name.contains(channel), qPrintable(name));
      if (twoRuns)
        QVERIFY2(name.contains("bladeelements") != name.contains("measuredpropeller"),
                 qPrintable(name));
      // Each line has room, and cells stand beside or below it.
      const int beside = place.cellsBelow ? 0 : place.cells * place.cellWidth;
      for (const QString& line : place.lines) {
        QVERIFY2(item->widthOf(line) <= item->width() - beside + 4, qPrintable(line));
      }
      QVERIFY(item->geometry().right() < item->parentWidget()->width());
      QVERIFY(item->parentWidget()->width() <= b.pane.legend()->viewport()->width());
      QVERIFY(item->y() >= (item->x() > 6 ? 0 : bottom));
      bottom = item->geometry().bottom();
      if (cursors == 0) {
        QCOMPARE(place.cells, 0);
      } else {
        QVERIFY(place.cells >= 1 && place.cells <= (cursors == 1 ? 1 : 3));
      }
      // What is there is painted, line by line and the last cell.
      const QImage image = item->grab().toImage();
      const int step = item->heightOf({});  // one line
      for (int i = 0; i < place.lines.size(); ++i)
        QVERIFY(isPainted(image, {28, i * step + 2, item->widthOf(place.lines[i]) - 34, step - 4}));
      if (place.cells > 0) {
        const int top = place.cellsBelow ? item->height() - step : 0;
        QVERIFY(isPainted(image, {item->width() - 20, top + 2, 16, step - 4}));
      }
    }
    QCOMPARE(QSet<QString>(names.begin(), names.end()).size(), names.size());
    // The first is in sight, and the last can be scrolled to.
    b.pane.legend()->ensureWidgetVisible(b.items().back());
    QVERIFY(!b.items().back()->visibleRegion().isEmpty());
    b.pane.legend()->ensureWidgetVisible(b.items().front());
    QVERIFY(!b.items().front()->visibleRegion().isEmpty());
  }

  /// The read-outs that have no room are in the tool tip, with the full name.
  void toolTipHasEverything() {
    Bench b(true);
    b.pane.resize(200, 150);
    b.link.setCursor(Cursor::A, 0.25);
    b.link.setCursor(Cursor::B, 0.75);
    for (const LegendItem* item : b.items()) {
      QVERIFY(item->toolTip().contains(item->entry().label));
      QCOMPARE(item->cells().size(), 3);
      for (const QString& cell : item->cells()) QVERIFY(item->toolTip().contains(cell));
      QVERIFY(item->toolTip().contains("B − A"));
      QVERIFY(item->place().cells < 3);
    }
  }

  /// Where there is room nothing is shortened.
  void wideLegendHasFullNames() {
    Bench b(true);
    b.pane.resize(1400, 600);
    b.link.setCursor(Cursor::A, 0.25);
    QTest::qWait(0);
    QCOMPARE(b.items().front()->place().lines,
             QStringList{"Over advance ratio, blade elements: over_advance.ct"});
    QVERIFY(!b.items().front()->place().cellsBelow);
  }

  void shortNames_data() {
    QTest::addColumn<QStringList>("channels");
    QTest::addColumn<QStringList>("wanted");
    QTest::addRow("common beginning")
        << QStringList{"along_blade.alpha", "along_blade.phi"} << QStringList{"alpha", "phi"};
    QTest::addRow("common end") << QStringList{"rotor1.thrust", "rotor2.thrust"}
                                << QStringList{"rotor1", "rotor2"};
    QTest::addRow("nothing common")
        << QStringList{"thrust", "torque"} << QStringList{"thrust", "torque"};
    QTest::addRow("one within the other")
        << QStringList{"speed", "speed.wanted"} << QStringList{"speed", "speed.wanted"};
    QTest::addRow("alone") << QStringList{"rotor1.thrust"} << QStringList{"rotor1.thrust"};
  }
  void shortNames() {
    QFETCH(QStringList, channels);
    QFETCH(QStringList, wanted);
    std::vector<Channel> all{{"time", "s", ""}};
    for (const QString& c : channels) all.push_back({c.toStdString(), "1", ""});
    RunSet runs;
    runs.add({"1", "Run 1", Qt::blue, std::make_shared<Recording>(all)});
    const CurveList list = chartCurves({"", ChartKind::Time, "", channels.join(", ").toStdString()},
                                       runs, HiddenCurves());
    QStringList found;
    for (const Curve& curve : list.curves) found << curve.shortLabel;
    QCOMPARE(found, wanted);
  }

  void shortRunNames() {
    RunSet runs;
    runs.add({"1", "Run 1: Thrust stand", Qt::blue, fixture::ramp(3)});
    runs.add({"2", "Run 2: Thrust stand", Qt::red, fixture::ramp(3)});
    const CurveList list =
        chartCurves({"", ChartKind::Time, "", "error, position.x"}, runs, HiddenCurves());
    QCOMPARE(list.curves.front().shortLabel, QString("Run 1: error"));
    QCOMPARE(list.curves.back().shortLabel, QString("Run 2: position.x"));
  }
};

QTEST_MAIN(TestChartLegend)
#include "test_chart_legend.moc"
