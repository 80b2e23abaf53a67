// Sentences with figures: read with points, or as another writer has it; and how short numbers are
// written.
#include <QtTest>
#include <cmath>
#include <limits>

#include "sim/core/sentence.h"

using namespace rotorbench;

class TestSentence : public QObject {
  Q_OBJECT
 private slots:
  void wordsAndNumbers() {
    const Sentence limit = "limited by " + Sentence::number(12.345) + " V" + std::string(" at ") +
                           Sentence::number(0.98765, 4) + " of 1.5";
    QCOMPARE(limit.text(), std::string("limited by 12.3 V at 0.9877 of 1.5"));
    const auto comma = [](double value, int digits) {
      std::string text = shortNumber(value, digits);
      std::ranges::replace(text, '.', ',');
      return text;
    };
    // Only numbers are written anew; words stay.
    QCOMPARE(limit.text(comma), std::string("limited by 12,3 V at 0,9877 of 1.5"));
  }

  void emptyIsEmpty() {
    QVERIFY(Sentence().empty());
    QVERIFY(Sentence("").empty());
    QVERIFY(Sentence(std::string()).empty());
    QVERIFY(!Sentence("a").empty());
    QVERIFY(!Sentence::number(0).empty());
    QCOMPARE((Sentence() + "a").text(), std::string("a"));
  }

  void shortNumbers_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("digits");
    QTest::addColumn<QString>("text");
    QTest::addRow("rounded") << 12.345 << 3 << "12.3";
    QTest::addRow("no trailing zeros") << 12.0 << 3 << "12";
    QTest::addRow("all digits before the point") << 123456.0 << 3 << "123456";
    QTest::addRow("small") << 0.00012345 << 3 << "0.000123";
    QTest::addRow("smaller") << 0.000012345 << 3 << "1.23e-05";
    QTest::addRow("zero") << 0.0 << 3 << "0";
    QTest::addRow("none") << std::nan("") << 3 << "\u2013";
    QTest::addRow("no end") << -std::numeric_limits<double>::infinity() << 3 << "-\u221e";
  }
  void shortNumbers() {
    QFETCH(double, value);
    QFETCH(int, digits);
    QFETCH(QString, text);
    QCOMPARE(QString::fromStdString(shortNumber(value, digits)), text);
  }
};

QTEST_APPLESS_MAIN(TestSentence)
#include "test_sentence.moc"
