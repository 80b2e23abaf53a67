// Six live chart panes with four curves each on a recording of 1,000,000 rows, in a window of
// 1400x900: the time of one frame (new rows read, points replaced, everything painted) and the
// longest time the GUI thread is busy without a break. Bounds: 33 ms per frame, 50 ms without a
// break.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QStyleFactory>
#include <cmath>
#include <random>

#include "ui/charts/chart_grid.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/run_set.h"

using namespace rotorbench;

namespace {

constexpr int kRows = 1'000'000;
constexpr int kChannels = 24;
constexpr double kStep = 1e-3;  // s

/// Smooth curves as a flight has them, or noise that fills every pixel column.
class Source {
 public:
  explicit Source(bool noisy) : noisy_(noisy) {
    std::vector<Channel> channels{{"time", "s", ""}};
    for (int i = 0; i < kChannels; ++i) {
      const QString name = QStringLiteral("%1.c%2").arg(QChar(u'a' + i / 4)).arg(i % 4 + 1);
      channels.push_back({name.toStdString(), "N", ""});
    }
    recording_ = std::make_shared<Recording>(channels);
    row_.resize(channels.size());
  }
  void append(int rows) {
    for (int i = 0; i < rows; ++i, ++count_) {
      const double t = kStep * count_;
      row_[0] = t;
      const double noise = noisy_ ? normal_(random_) : 0;
      for (std::size_t c = 1; c < row_.size(); ++c) {
        row_[c] = std::sin(0.02 * t * static_cast<double>(c)) + noise * 0.3;
      }
      recording_->append(row_);
    }
    recording_->publish();
  }
  [[nodiscard]] const std::shared_ptr<Recording>& recording() const { return recording_; }

 private:
  bool noisy_;
  int count_ = 0;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
  std::vector<double> row_;
  std::shared_ptr<Recording> recording_;
};

struct Window {
  RunSet runs;
  ChartGrid grid{&runs};
  Window() {
    std::vector<ChartSpec> specs;
    for (int i = 0; i < 6; ++i) {
      const QString pattern = QStringLiteral("%1.*").arg(QChar(u'a' + i));
      specs.push_back({"Pane", ChartKind::Time, "", pattern.toStdString(), false, false, false});
    }
    grid.setSpecs(specs);
    grid.resize(1400, 900);
    grid.show();
    QApplication::processEvents();
  }
  /// One frame; returns the longest uninterrupted stretch in ms: reading and replacing, or
  /// painting.
  double frame() {
    QElapsedTimer clock;
    clock.start();
    for (auto* pane : grid.panes()) pane->refresh();
    const double read = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    clock.restart();
    grid.repaint();
    QApplication::processEvents();
    return std::max(read, static_cast<double>(clock.nsecsElapsed()) * 1e-6);
  }
};

void sixLivePanes(benchmark::State& state) {
  Source source(state.range(0) != 0);
  source.append(kRows);
  Window window;
  window.runs.add({"1", "Run 1", QColor(0, 114, 178), source.recording(), true});
  for (int i = 0; i < 40; ++i) window.frame();
  double longest = 0;
  for (auto _ : state) {
    state.PauseTiming();
    source.append(33);
    state.ResumeTiming();
    longest = std::max(longest, window.frame());
  }
  state.counters["longest_stretch_ms"] = longest;
}
BENCHMARK(sixLivePanes)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("noisy")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(100);

/// The run is 1,000,000 rows long when it is first shown; the grid's own clock brings it in piece
/// by piece.
void openLongRecording(benchmark::State& state) {
  Source source(false);
  source.append(kRows);
  source.recording()->finish();
  double longest = 0;
  for (auto _ : state) {
    Window window;
    window.runs.add({"1", "Run 1", QColor(0, 114, 178), source.recording(), true});
    const auto complete = [&] {
      for (auto* pane : window.grid.panes()) {
        if (pane->plot()->frame().curves.size() != 4) return false;
        for (const auto& curve : pane->plot()->frame().curves) {
          // The last pixel column has points: its extremes, wherever they lie in it.
          if (curve.points.isEmpty() || curve.points.last().x() < 0.99 * kStep * kRows)
            return false;
        }
      }
      return true;
    };
    QElapsedTimer clock;
    while (!complete()) {
      clock.restart();
      window.grid.refresh();
      longest = std::max(longest, static_cast<double>(clock.nsecsElapsed()) * 1e-6);
      clock.restart();
      QApplication::processEvents();
      longest = std::max(longest, static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    }
  }
  state.counters["longest_stretch_ms"] = longest;
}
BENCHMARK(openLongRecording)->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM",
          qgetenv("QT_QPA_PLATFORM").isEmpty() ? "offscreen" : qgetenv("QT_QPA_PLATFORM"));
  QApplication application(argc, argv);
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
