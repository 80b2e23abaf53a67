// The thread behind a run: every order acts at once, pace is kept, and whatever goes wrong is a
// value.
#include <QElapsedTimer>
#include <QtTest>

#include "sim/run/run_worker.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/fake_simulation.h"

using namespace rotorbench;

namespace {

RunWorker::Factory fake(const FakePlan& plan) {
  return [plan] { return std::make_unique<FakeSimulation>(plan); };
}

/// Ten minutes of simulated time, 20 microseconds of wall time per tick: 12 s at full speed.
FakePlan longPlan() {
  FakePlan plan;
  plan.ticks = 600000;
  plan.tickCost = std::chrono::microseconds(20);
  return plan;
}

std::size_t rows(const RunWorker& worker) {
  return worker.status().outputs.at(0).recording->rows();
}

}  // namespace

class TestRunWorker : public QObject {
  Q_OBJECT

 private slots:
  void finishes();
  void buildErrorsAreValues();
  void failureKeepsRecording();
  void exceptionEndsAsFailure();
  void pauseStepResume();
  void stopKeepsRecording();
  void destroyedDuringRun();
  void paceIsKept_data();
  void paceIsKept();
  void paceChangesInFlight();
  void slicesStayShort();
  void tellsTimeLeft();
  void readersWhileWriting();
  void changesActAlsoInAPause();
  void changesFromOtherThreads();
};

void TestRunWorker::finishes() {
  FakePlan plan;
  plan.runs = 3;
  RunWorker worker(fake(plan), Pace{});
  QTRY_COMPARE(worker.status().state, RunState::Finished);
  const RunStatus status = worker.status();
  QCOMPARE(status.outputs.size(), std::size_t{3});
  QCOMPARE(status.outputs[2].recording->rows(), std::size_t{1000});
  QCOMPARE(status.progress.fraction, 1.0);
  QCOMPARE(status.metrics.at(0).metrics.at(0).value, 1000.0);
  QVERIFY(!status.secondsLeft);
  QVERIFY(!status.failure);
}

void TestRunWorker::buildErrorsAreValues() {
  RunWorker worker(
      []() -> std::unique_ptr<Simulation> {
        throw InputError("experiment", {{"setup.duration", "-1 s is too small", "above 0 s", false},
                                        {"seed", "missing", "a whole number", false}});
      },
      Pace{});
  QTRY_COMPARE(worker.status().state, RunState::Failed);
  QCOMPARE(worker.status().problems.size(), std::size_t{2});
  QCOMPARE(worker.status().problems[0].path, std::string("setup.duration"));
  QVERIFY(worker.status().outputs.empty());
}

void TestRunWorker::failureKeepsRecording() {
  FakePlan plan;
  plan.failAt = 400;
  RunWorker worker(fake(plan), Pace{});
  QTRY_COMPARE(worker.status().state, RunState::Failed);
  const RunStatus status = worker.status();
  QCOMPARE(status.failure->time, 0.4);
  QCOMPARE(status.failure->message, std::string("It failed."));
  QCOMPARE(status.outputs.at(0).recording->rows(), std::size_t{400});
  QCOMPARE(status.metrics.size(), std::size_t{1});
}

void TestRunWorker::exceptionEndsAsFailure() {
  FakePlan plan;
  plan.throwAt = 300;
  RunWorker worker(fake(plan), Pace{});
  QTRY_COMPARE(worker.status().state, RunState::Failed);
  QCOMPARE(worker.status().failure->message, std::string("A model broke its promise."));
  QVERIFY(worker.status().outputs.at(0).recording->finished());
}

void TestRunWorker::pauseStepResume() {
  RunWorker worker(fake(longPlan()), Pace{}, true);
  QTRY_COMPARE(worker.status().state, RunState::Paused);
  QCOMPARE(rows(worker), std::size_t{0});
  worker.step(0.005);
  QTRY_COMPARE(rows(worker), std::size_t{5});
  worker.step(1e-9);
  QTRY_COMPARE(rows(worker), std::size_t{6});
  QTRY_COMPARE(worker.status().metrics.at(0).metrics.at(0).value, 6.0);
  QCOMPARE(worker.status().state, RunState::Paused);
  worker.resume();
  QTRY_VERIFY(rows(worker) > 1000);
  QElapsedTimer clock;
  clock.start();
  worker.pause();
  QTRY_COMPARE_WITH_TIMEOUT(worker.status().state, RunState::Paused, 2000);
  const std::size_t still = rows(worker);
  worker.step(0.001);
  QTRY_COMPARE(rows(worker), still + 1);
}

void TestRunWorker::stopKeepsRecording() {
  RunWorker worker(fake(longPlan()), Pace{});
  QTRY_VERIFY(!worker.status().outputs.empty() && rows(worker) > 100);
  worker.stop();
  QTRY_COMPARE(worker.status().state, RunState::Stopped);
  QVERIFY(rows(worker) > 100);
  QVERIFY(rows(worker) < 600000);
  QVERIFY(worker.status().outputs[0].recording->finished());
  QCOMPARE(worker.status().metrics.at(0).metrics.at(0).value, static_cast<double>(rows(worker)));
}

void TestRunWorker::destroyedDuringRun() {
  std::shared_ptr<Recording> recording;
  QElapsedTimer clock;
  {
    RunWorker worker(fake(longPlan()), Pace{});
    QTRY_VERIFY(!worker.status().outputs.empty() && rows(worker) > 100);
    recording = worker.status().outputs[0].recording;
    clock.start();
  }
  QVERIFY2(clock.elapsed() < 2000, qPrintable(QString::number(clock.elapsed())));
  QVERIFY(recording->finished());
}

void TestRunWorker::paceIsKept_data() {
  QTest::addColumn<double>("factor");
  QTest::addColumn<double>("simulated");
  QTest::addRow("half speed") << 0.5 << 0.2;
  QTest::addRow("real time") << 1.0 << 0.4;
  QTest::addRow("ten times") << 10.0 << 4.0;
}

// Each case lasts 0.4 s of wall time; a run may never be early, and on a busy machine it may be
// late.
void TestRunWorker::paceIsKept() {
  QFETCH(double, factor);
  QFETCH(double, simulated);
  FakePlan plan;
  plan.ticks = std::llround(simulated / plan.tickSeconds);
  QElapsedTimer clock;
  clock.start();
  RunWorker worker(fake(plan), Pace{factor});
  QTRY_COMPARE(worker.status().state, RunState::Finished);
  const double spent = static_cast<double>(clock.elapsed()) / 1000;
  QVERIFY2(spent >= 0.395, qPrintable(QString::number(spent)));
  QVERIFY2(spent < 1.5, qPrintable(QString::number(spent)));
}

void TestRunWorker::paceChangesInFlight() {
  FakePlan plan;
  plan.ticks = 100000;  // 100 s: at real time the test would time out
  RunWorker worker(fake(plan), Pace{1});
  QTRY_VERIFY(!worker.status().outputs.empty() && rows(worker) > 10);
  QCOMPARE(worker.status().state, RunState::Running);
  worker.setPace(Pace{});
  QTRY_COMPARE(worker.status().state, RunState::Finished);
}

void TestRunWorker::slicesStayShort() {
  std::atomic<std::int64_t> longest{0};
  FakePlan plan = longPlan();
  plan.longestSlice = &longest;
  RunWorker worker(fake(plan), Pace{});
  QTRY_VERIFY(!worker.status().outputs.empty() && rows(worker) > 10000);
  worker.stop();
  worker.wait();
  // 10 ms by design; the rest is for a machine that is busy with other things.
  QVERIFY2(longest < 60000, qPrintable(QString::number(longest)));
}

void TestRunWorker::tellsTimeLeft() {
  RunWorker worker(fake(longPlan()), Pace{});
  QTRY_VERIFY(worker.status().secondsLeft.has_value() && worker.status().progress.fraction > 0.05);
  // 600000 ticks of 20 microseconds are 12 s, 95 % of it is left; a busy machine takes longer.
  QVERIFY(*worker.status().secondsLeft > 5);
  QVERIFY(*worker.status().secondsLeft < 120);
}

void TestRunWorker::readersWhileWriting() {
  FakePlan plan;
  plan.ticks = 50000;
  RunWorker worker(fake(plan), Pace{});
  QTRY_VERIFY(!worker.status().outputs.empty());
  const auto recording = worker.status().outputs[0].recording;
  while (!recording->finished()) {
    const std::size_t published = recording->rows();
    if (published > 0) {
      QCOMPARE(recording->value(1, published - 1), static_cast<double>(published));
    }
  }
  QCOMPARE(recording->rows(), std::size_t{50000});
}

void TestRunWorker::changesActAlsoInAPause() {
  FakePlan plan;
  plan.ticks = 20;
  RunWorker worker(fake(plan), Pace{}, true);
  worker.step(0.005);
  QTRY_COMPARE(worker.status().outputs.empty() ? std::size_t{0} : rows(worker), std::size_t{5});
  QTRY_COMPARE(worker.status().state, RunState::Paused);
  QVERIFY(worker.status().changes != nullptr && worker.status().changes->empty());
  worker.change({0, "weight", "10"});
  worker.change({0, "height", "10"});
  QTRY_COMPARE(worker.status().refused.size(), std::size_t{1});
  QCOMPARE(worker.status().refused.front().message(), std::string("height: is unknown; weight"));
  QCOMPARE(worker.status().state, RunState::Paused);
  QCOMPARE(worker.status().changes->size(), std::size_t{1});
  QCOMPARE(worker.status().changes->front().time, 0.005);
  worker.resume();
  worker.wait();
  const Recording& r = *worker.status().outputs.at(0).recording;
  QCOMPARE(r.value(1, 4), 5.0);
  QCOMPARE(r.value(1, 5), 15.0);
  QCOMPARE(r.value(1, 19), 155.0);
}

/// Two threads command, one reads, the worker counts: what it counted follows from its changes.
void TestRunWorker::changesFromOtherThreads() {
  FakePlan plan;
  plan.ticks = 30000;
  plan.tickCost = std::chrono::microseconds(10);
  RunWorker worker(fake(plan), Pace{});
  const auto command = [&worker](int seed) {
    for (int k = 0; isActive(worker.status().state); ++k) {
      worker.change({0, "weight", std::to_string((seed + 7 * k) % 10)});
      if (k % 5 == seed) worker.pause();
      if (k % 5 == seed) worker.step(0.003);
      worker.resume();
      worker.setPace({k % 3 == 0 ? 0.0 : 300.0});
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
  };
  std::thread one([&] { command(1); }), other([&] { command(2); });
  while (isActive(worker.status().state)) {
    const RunStatus status = worker.status();
    if (status.outputs.empty()) continue;
    const Recording& r = *status.outputs.front().recording;
    if (r.rows() > 0) QVERIFY(r.value(1, r.rows() - 1) >= 0);
  }
  one.join();
  other.join();
  worker.wait();
  const RunStatus status = worker.status();
  QCOMPARE(status.state, RunState::Finished);
  QVERIFY(status.changes->size() > 50);
  const Recording& r = *status.outputs.front().recording;
  double weight = 1, count = 0;
  std::size_t next = 0;
  for (std::size_t row = 0; row < r.rows(); ++row) {
    for (; next < status.changes->size(); ++next) {
      const Change& change = (*status.changes)[next];
      if (change.time > (static_cast<double>(row) + 0.5) * plan.tickSeconds) break;
      weight = std::stod(change.value);
    }
    QCOMPARE(r.value(1, row), count += weight);
  }
}

QTEST_GUILESS_MAIN(TestRunWorker)
#include "test_run_worker.moc"
