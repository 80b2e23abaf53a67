// Evaluations of one propeller per second: blade elements from nothing, blade elements that start from the last
// solution, blade elements averaged over the azimuth, and the map. The states are those of a flight, 256 speeds and air
// speeds around hover, one after the other. "build map" is what the map costs once.
#include <benchmark/benchmark.h>

#include <array>

#include "sim/propulsion/propeller_map.h"

namespace {

using namespace rotorbench;

struct State {
  double omega, axial;
};

const std::array<State, 256>& states() {
  static const std::array<State, 256> all = [] {
    std::array<State, 256> s{};
    for (std::size_t i = 0; i < s.size(); ++i) {
      const double t = static_cast<double>(i) / 8;
      s[i] = {500 + 60 * std::sin(t), 3 * std::sin(0.37 * t)};
    }
    return s;
  }();
  return all;
}

const BladeElementRotor& rotor() {
  static const BladeElementRotor r{PropellerGeometry{}};
  return r;
}

/// `evaluate` takes a State and gives a thrust.
template <class Evaluate>
void run(benchmark::State& bench, const Evaluate& evaluate) {
  std::size_t i = 0;
  for (auto _ : bench) {
    State s = states()[i++ % states().size()];
    benchmark::DoNotOptimize(s);
    benchmark::DoNotOptimize(evaluate(s));
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()));
}

void bladeElement(benchmark::State& bench) {
  run(bench, [](const State& s) { return rotor().axial(s.omega, s.axial, {}).thrust; });
}
void bladeElementWarm(benchmark::State& bench) {
  InflowMemory memory;
  run(bench, [&](const State& s) { return rotor().axial(s.omega, s.axial, {}, &memory).thrust; });
}
void bladeElementOblique(benchmark::State& bench) {
  run(bench, [](const State& s) { return rotor().oblique(s.omega, s.axial, 5, {}).thrust; });
}
void map(benchmark::State& bench) {
  const PropellerMap m(rotor());
  run(bench, [&](const State& s) { return m.axial(s.omega, s.axial, {}).thrust; });
}
void buildMap(benchmark::State& bench) {
  for (auto _ : bench) benchmark::DoNotOptimize(PropellerMap(rotor()));
}

BENCHMARK(bladeElement)->Name("blade element");
BENCHMARK(bladeElementWarm)->Name("blade element, warm start");
BENCHMARK(bladeElementOblique)->Name("blade element, oblique flow");
BENCHMARK(map)->Name("map");
BENCHMARK(buildMap)->Name("build map")->Unit(benchmark::kMillisecond);

}  // namespace
