#include <QTest>
#include <array>
#include <cmath>
#include <thread>

#include "sim/core/recording.h"

using namespace rotorbench;

namespace {

std::vector<Channel> channels(std::size_t count) {
  std::vector<Channel> list{{"time", "s", "Time"}};
  for (std::size_t i = 1; i < count; ++i)
    list.push_back({std::string("c").append(std::to_string(i)), "1", {}});
  return list;
}

constexpr std::size_t kChunkBytes(std::size_t channelCount) {
  return channelCount * (Recording::kChunkRows + 8) * sizeof(double);
}

}  // namespace

class TestRecording : public QObject {
  Q_OBJECT

 private slots:
  void rowsAppearWhenPublished();
  void valuesAndColumns();
  void searchByTime_data();
  void searchByTime();
  void emptyRecording();
  void stopsAtTheBound();
  void thinsForEver();
  void keepsRowsApartByTheStride();
  void pointersStayValid();
  void readerBesideWriter();
};

void TestRecording::rowsAppearWhenPublished() {
  Recording recording(channels(2));
  QVERIFY(recording.append(std::array{0.0, 1.0}));
  QCOMPARE(recording.rows(), std::size_t{0});
  recording.publish();
  QCOMPARE(recording.rows(), std::size_t{1});
  QVERIFY(!recording.finished());
  QVERIFY(recording.append(std::array{1.0, 2.0}));
  recording.finish();
  QCOMPARE(recording.rows(), std::size_t{2});
  QVERIFY(recording.finished());
  QVERIFY(!recording.append(std::array{2.0, 3.0}));
  QCOMPARE(recording.find("c1").value_or(99), std::size_t{1});
  QVERIFY(!recording.find("c2"));
}

void TestRecording::valuesAndColumns() {
  Recording recording(channels(3));
  constexpr std::size_t kRows = 3 * Recording::kChunkRows + 17;
  for (std::size_t i = 0; i < kRows; ++i) {
    const double t = static_cast<double>(i);
    QVERIFY(recording.append(std::array{t, 2 * t, -t}));
  }
  recording.publish();
  std::size_t seen = 0;
  for (std::size_t row = 0; row < recording.rows();) {
    const auto piece = recording.column(2, row);
    QVERIFY(!piece.empty());
    for (const double v : piece) QCOMPARE(v, -static_cast<double>(seen++));
    row += piece.size();
  }
  QCOMPARE(seen, kRows);
  QCOMPARE(recording.column(1, Recording::kChunkRows - 1).size(), std::size_t{1});
  QCOMPARE(recording.column(1, kRows).size(), std::size_t{0});
  QCOMPARE(recording.value(1, kRows - 1), 2.0 * (kRows - 1));
  QCOMPARE(recording.bytes(), 4 * kChunkBytes(3));
}

void TestRecording::searchByTime_data() {
  QTest::addColumn<double>("t");
  QTest::addColumn<int>("lower");
  QTest::addColumn<double>("sample");
  // Times 0, 1, 1, 2, 3 with values 10 to 14: the second of two equal times is the later sample.
  QTest::addRow("before") << -1.0 << 0 << 10.0;
  QTest::addRow("first") << 0.0 << 0 << 10.0;
  QTest::addRow("between") << 0.5 << 1 << 10.0;
  QTest::addRow("doubled") << 1.0 << 1 << 12.0;
  QTest::addRow("after doubled") << 1.5 << 3 << 12.0;
  QTest::addRow("last") << 3.0 << 4 << 14.0;
  QTest::addRow("after") << 9.0 << 5 << 14.0;
}

void TestRecording::searchByTime() {
  QFETCH(double, t);
  QFETCH(int, lower);
  QFETCH(double, sample);
  Recording recording(channels(2));
  double value = 10;
  for (const double time : {0.0, 1.0, 1.0, 2.0, 3.0}) {
    QVERIFY(recording.append(std::array{time, value}));
    ++value;
  }
  recording.publish();
  QCOMPARE(recording.lowerBound(t), static_cast<std::size_t>(lower));
  QCOMPARE(recording.sampleAt(1, t), sample);
}

void TestRecording::emptyRecording() {
  const Recording recording(channels(2));
  QCOMPARE(recording.lowerBound(0), std::size_t{0});
  QVERIFY(std::isnan(recording.sampleAt(1, 0)));
  QCOMPARE(recording.column(0, 0).size(), std::size_t{0});
  QCOMPARE(recording.bytes(), std::size_t{0});
}

void TestRecording::stopsAtTheBound() {
  Recording recording(channels(2), {2 * kChunkBytes(2), WhenFull::Stop});
  for (std::size_t i = 0; i < 2 * Recording::kChunkRows; ++i) {
    QVERIFY(recording.append(std::array{static_cast<double>(i), 0.0}));
  }
  QVERIFY(!recording.append(std::array{1e9, 0.0}));
  recording.finish();
  QCOMPARE(recording.rows(), 2 * Recording::kChunkRows);
  QCOMPARE(recording.stride(), std::size_t{1});
  QVERIFY(recording.bytes() <= 2 * kChunkBytes(2));
}

void TestRecording::thinsForEver() {
  constexpr std::size_t kBound = 3 * kChunkBytes(2);
  Recording recording(channels(2), {kBound, WhenFull::Thin});
  constexpr std::size_t kOffered = 20'000'000;
  for (std::size_t i = 0; i < kOffered; ++i) {
    if (!recording.append(std::array{static_cast<double>(i), 0.0}))
      QFAIL("a thinned recording refused a row");
  }
  recording.finish();
  QVERIFY(recording.bytes() <= kBound);
  QVERIFY(recording.rows() < 3 * Recording::kChunkRows);
  QVERIFY(recording.stride() > 1);
  // The end of the run is still covered: the last kept row is not further from the end than the
  // stride.
  QVERIFY(recording.value(0, recording.rows() - 1) + static_cast<double>(recording.stride()) >=
          kOffered);
}

void TestRecording::keepsRowsApartByTheStride() {
  Recording recording(channels(1), {2 * kChunkBytes(1), WhenFull::Thin});
  for (std::size_t i = 0; i < 5 * Recording::kChunkRows; ++i) {
    QVERIFY(recording.append(std::array{static_cast<double>(i)}));
  }
  recording.finish();
  double before = 0;
  double gap = 1;
  for (std::size_t row = 1; row < recording.rows(); ++row) {
    const double now = recording.value(0, row);
    QVERIFY(now - before == gap || now - before == 2 * gap);
    gap = now - before;
    before = now;
    // Half of the room, 4096 rows, is kept in full; half of the rest at every second row ...
    if (row < Recording::kChunkRows) QCOMPARE(gap, 1.0);
    if (row > Recording::kChunkRows && row < Recording::kChunkRows * 3 / 2) QCOMPARE(gap, 2.0);
  }
  // The stride may have doubled after the last row that was kept.
  QVERIFY(static_cast<double>(recording.stride()) == gap ||
          static_cast<double>(recording.stride()) == 2 * gap);
}

void TestRecording::pointersStayValid() {
  Recording recording(channels(2));
  QVERIFY(recording.append(std::array{0.0, 42.0}));
  recording.publish();
  const auto first = recording.column(1, 0);
  for (std::size_t i = 1; i < 10 * Recording::kChunkRows; ++i) {
    QVERIFY(recording.append(std::array{static_cast<double>(i), 0.0}));
  }
  recording.publish();
  QCOMPARE(first[0], 42.0);
  QCOMPARE(recording.column(1, 0).data(), first.data());
}

void TestRecording::readerBesideWriter() {
  Recording recording(channels(4));
  constexpr std::size_t kRows = 100 * Recording::kChunkRows;
  std::atomic<bool> torn{false};
  std::size_t checked = 0;
  std::thread reader([&] {
    std::size_t next = 0;
    while (next < kRows && !torn) {
      const std::size_t end = recording.rows();
      while (next < end) {
        const auto times = recording.column(0, next);
        const auto values = recording.column(3, next);
        const std::size_t count = std::min(times.size(), values.size());
        for (std::size_t k = 0; k < count; ++k, ++checked) {
          const double t = static_cast<double>(next + k);
          if (times[k] != t || values[k] != 3 * t + 1) torn = true;
        }
        next += count;
      }
      if (end > 0) {
        const double last = static_cast<double>(end - 1);
        if (recording.sampleAt(3, last) != 3 * last + 1) torn = true;
      }
    }
  });
  for (std::size_t i = 0; i < kRows; ++i) {
    const double t = static_cast<double>(i);
    recording.append(std::array{t, 0.0, 0.0, 3 * t + 1});
    if (i % 100 == 0) recording.publish();
  }
  recording.finish();
  reader.join();
  QVERIFY(!torn);
  QCOMPARE(checked, kRows);
}

QTEST_GUILESS_MAIN(TestRecording)
#include "test_recording.moc"
