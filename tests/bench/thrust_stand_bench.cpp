// A complete thrust-stand sweep as the window runs it: the propeller's curve by blade elements, the
// steady points over the throttle and the shipped procedure of steps in time; the same for the
// propeller bench; and what one check of the document costs, which a form makes after every key.
#include <benchmark/benchmark.h>

#include "sim/core/schema_tree.h"
#include "sim/document/experiment_file.h"
#include "sim/run/simulation.h"

namespace {

using namespace rotorbench;

Experiment shipped(const char* name) {
  return loadExperiment(std::string(EXPERIMENTS_DIR "/") + name + ".json");
}

void wholeRun(benchmark::State& bench, const char* name) {
  const Experiment experiment = shipped(name);
  for (auto _ : bench) {
    const auto simulation = buildSimulation(experiment);
    while (simulation->advance(1000) == SimulationState::Running) {
    }
    benchmark::DoNotOptimize(simulation->metrics());
  }
}
void build(benchmark::State& bench, const char* name) {
  const Experiment experiment = shipped(name);
  for (auto _ : bench) benchmark::DoNotOptimize(buildSimulation(experiment));
}
void check(benchmark::State& bench, const char* name) {
  const Experiment experiment = shipped(name);
  for (auto _ : bench) benchmark::DoNotOptimize(schema::validate(schema::ref(experiment)));
}

BENCHMARK_CAPTURE(wholeRun, stand, "thrust-stand-x2216")
    ->Name("thrust stand, complete")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, stand, "thrust-stand-x2216")
    ->Name("thrust stand, propeller curve and steady points")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check, stand, "thrust-stand-x2216")
    ->Name("thrust stand, check of the document")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wholeRun, propeller, "propeller-bench-10x47")
    ->Name("propeller bench, complete")
    ->Unit(benchmark::kMillisecond);

}  // namespace
