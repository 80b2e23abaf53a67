// Runs the registered Google benchmarks interleaved at random, so that a noisy machine disturbs
// both sides alike, and prints the ratio of the processor times of pairs of them, by median and by
// minimum over the repetitions.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace rotorbench::bench {

struct Pair {
  std::string title, ours, theirs;
};

class TimeCollector : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) {
        times_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
        unit_ = benchmark::GetTimeUnitString(run.time_unit);
      }
    }
  }
  void printTimes() {
    std::printf("%-42s %12s %12s\n", "processor time", "median", "minimum");
    for (auto& [name, times] : times_) {
      std::sort(times.begin(), times.end());
      std::printf("%-42s %9.1f %s %9.1f %s\n", name.c_str(), times[times.size() / 2], unit_.c_str(),
                  times[0], unit_.c_str());
    }
  }
  void print(const Pair& pair) {
    auto& ours = times_[pair.ours];
    auto& theirs = times_[pair.theirs];
    if (ours.empty() || theirs.empty()) return;
    std::printf("%-58s median %.3f  minimum %.3f\n", pair.title.c_str(),
                ours[ours.size() / 2] / theirs[theirs.size() / 2], ours[0] / theirs[0]);
  }

 private:
  std::map<std::string, std::vector<double>> times_;
  std::string unit_;
};

/// The main function of a benchmark program. Flags of Google Benchmark are understood.
inline int runWithRatios(int argc, char** argv, const std::vector<Pair>& pairs) {
  std::vector<char*> arguments(argv, argv + argc);
  std::vector<std::string> defaults{"--benchmark_enable_random_interleaving=true",
                                    "--benchmark_repetitions=21", "--benchmark_min_time=0.02"};
  std::size_t at = 1;  // before the user's own flags, which win
  for (std::string& flag : defaults) {
    arguments.insert(arguments.begin() + static_cast<std::ptrdiff_t>(at++), flag.data());
  }
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  TimeCollector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::Shutdown();
  collector.printTimes();
  std::printf("\nRatio of our processor time to theirs (below 1: we are faster)\n");
  for (const Pair& pair : pairs) collector.print(pair);
  return 0;
}

}  // namespace rotorbench::bench
