// All runs of an experiment as one table: which of them, and how their names are written.
#include <QTest>
#include <sstream>

#include "sim/run/run_files.h"

using namespace rotorbench;

namespace {

/// A run of one row of zeros.
RunOutput runOf(std::string name, const std::vector<std::string>& channels) {
  std::vector<Channel> described;
  for (const std::string& channel : channels) described.push_back({channel, "1", ""});
  auto recording = std::make_shared<Recording>(std::move(described));
  recording->append(std::vector<double>(channels.size(), 0.0));
  recording->finish();
  return {std::move(name), std::move(recording)};
}

std::string csvOf(const std::vector<RunOutput>& runs) {
  std::ostringstream out;
  writeRunsCsv(out, runs);
  return out.str();
}

}  // namespace

class TestRunFiles : public QObject {
  Q_OBJECT
 private slots:
  void oneRun() {
    QCOMPARE(csvOf({runOf("Flight", {"time", "x"})}), std::string("time [1],x [1]\n0,0\n"));
  }

  /// The methods of a comparison, wherever they stand, and not its reference and diagrams.
  void whatMostShare() {
    QCOMPARE(csvOf({runOf("Reference", {"time", "x"}), runOf("Work", {"step", "error", "cost"}),
                    runOf("RK4", {"time", "x", "e"}), runOf("Euler", {"time", "x", "e"})}),
             std::string("run,time [1],x [1],e [1]\nRK4,0,0,0\nEuler,0,0,0\n"));
    // One method only: it tells more than the reference.
    QCOMPARE(csvOf({runOf("Reference", {"time", "x"}), runOf("RK4", {"time", "x", "e"}),
                    runOf("Work", {"step", "error", "cost", "more"})}),
             std::string("time [1],x [1],e [1]\n0,0,0\n"));
  }

  /// Every curve of a bench has channels of its own; its series is the one over time, wherever it
  /// stands.
  void seriesOfABench() {
    const std::string series = "time [1],v [1]\n0,0\n";
    const RunOutput run = runOf("Run", {"time", "v"}), curve = runOf("Over speed", {"w", "q", "p"});
    QCOMPARE(csvOf({run, curve, runOf("Over voltage", {"v", "w"})}), series);
    QCOMPARE(csvOf({curve, run}), series);
  }

  /// "Run, propeller map" is one cell.
  void namesAreQuoted() {
    QCOMPARE(csvOf({runOf("Run, map", {"time"}), runOf("Run, \"old\"", {"time"})}),
             std::string("run,time [1]\n\"Run, map\",0\n\"Run, \"\"old\"\"\",0\n"));
  }
};

QTEST_GUILESS_MAIN(TestRunFiles)
#include "test_run_files.moc"
