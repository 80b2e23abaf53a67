#include <QTest>
#include <cmath>
#include <limits>

#include "sim/logs/residuals.h"

using namespace rotorbench;

class TestResiduals : public QObject {
  Q_OBJECT
 private slots:
  void figuresByHand();
  void computedLineIsMet();
  void saysWhatIsLeftOut_data();
  void saysWhatIsLeftOut();
};

/// Computed y = 2 x; residuals 1, -1, 2 by hand: RMSE = sqrt(6/3), mean 2/3; measured 1, 1, 6 about
/// 8/3 spread by 50/3, so R^2 = 1 - 6/(50/3).
void TestResiduals::figuresByHand() {
  const ResidualReport report = compareSeries({{0, 1, 2}, {1, 1, 6}}, {{2, 0}, {4, 0}});
  QCOMPARE(report.figures.count, std::size_t{3});
  QCOMPARE(report.figures.rmse, std::sqrt(2.0));
  QCOMPARE(report.figures.mean, 2.0 / 3);
  QCOMPARE(report.figures.mostApart, 2.0);
  QCOMPARE(report.figures.mostApartAt, 2.0);
  QCOMPARE(report.figures.rSquared, 1 - 6.0 / (50.0 / 3));
  QCOMPARE(report.figures.range, 5.0);
  QCOMPARE(report.computed, (std::vector<double>{0, 2, 4}));
  QVERIFY(report.sentences.empty());
}

void TestResiduals::computedLineIsMet() {
  Series measured, computed;
  for (int i = 0; i <= 100; ++i) {
    computed.x.push_back(0.01 * i);
    computed.y.push_back(std::sin(0.01 * i));
  }
  for (int i = 0; i < 40; ++i) {
    measured.x.push_back(0.0213 * i);
    measured.y.push_back(std::sin(0.0213 * i));
  }
  // Straight lines between points 0.01 apart are off by at most h^2/8.
  QVERIFY(compareSeries(measured, computed).figures.mostApart < 1e-4 / 8);
}

void TestResiduals::saysWhatIsLeftOut_data() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QTest::addColumn<QList<double>>("x");
  QTest::addColumn<QList<double>>("y");
  QTest::addColumn<int>("count");
  QTest::addColumn<QString>("sentence");
  QTest::addRow("outside")
      << QList<double>{-1, 0, 1, 5} << QList<double>{0, 0, 1, 5} << 2
      << "2 of 4 measured points lie outside the computed range 0 to 2 and are "
         "left out.";
  QTest::addRow("apart") << QList<double>{7, 8} << QList<double>{0, 1} << 0
                         << "The ranges do not overlap: measured 7 to 8, computed 0 to 2.";
  QTest::addRow("nothing measured") << QList<double>{1, nan} << QList<double>{nan, 1} << 0
                                    << "There are no measured numbers to compare.";
  QTest::addRow("one point") << QList<double>{1} << QList<double>{1} << 1 << "";
}

void TestResiduals::saysWhatIsLeftOut() {
  QFETCH(QList<double>, x);
  QFETCH(QList<double>, y);
  QFETCH(int, count);
  QFETCH(QString, sentence);
  const ResidualReport report =
      compareSeries({{x.begin(), x.end()}, {y.begin(), y.end()}}, {{0, 1, 2}, {0, 1, 2}});
  QCOMPARE(report.figures.count, static_cast<std::size_t>(count));
  QCOMPARE(report.sentences.empty() ? std::string() : report.sentences.front(),
           sentence.toStdString());
}

QTEST_APPLESS_MAIN(TestResiduals)
#include "test_residuals.moc"
