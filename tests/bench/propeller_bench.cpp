// Evaluations of one propeller per second: blade elements from nothing, blade elements that start
// from the last solution, blade elements averaged over the azimuth, the map, and the four rotor
// models as a flight asks them. The states are those of a flight, 256 speeds and air speeds around
// hover, one after the other. "build map" is what the map costs once.
#include <benchmark/benchmark.h>

#include <array>

#include "sim/propulsion/rotor/rotor.h"

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
/// Force and moment of a rotor model as a flight asks for them, `side` m/s from the side.
void fly(benchmark::State& bench, const RotorAerodynamics& aerodynamics, double side) {
  RotorParameters parameters;
  parameters.aerodynamics = aerodynamics;
  const RotorConstants r = buildRotor(parameters);
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  run(bench, [&](const State& s) {
    const Eigen::Vector3d v(side, 0, s.axial);
    return r.model != nullptr ? r.model->load<double>(s.omega, v, axis, 1, 1.225).force
                              : r.load<double, Eigen::Vector3d>(s.omega, v, axis, 1, 1.225).force;
  });
}
void buildMap(benchmark::State& bench) {
  for (auto _ : bench) benchmark::DoNotOptimize(PropellerMap(rotor()));
}

BENCHMARK(bladeElement)->Name("blade element");
BENCHMARK(bladeElementWarm)->Name("blade element, warm start");
BENCHMARK(bladeElementOblique)->Name("blade element, oblique flow");
BENCHMARK(map)->Name("map");
BENCHMARK_CAPTURE(fly, lumped, PropellerCoefficients{}, 5)->Name("flight, lumped");
BENCHMARK_CAPTURE(fly, measured, MeasuredPropeller{}, 5)->Name("flight, measured");
BENCHMARK_CAPTURE(fly, mapStill, MapPropeller{}, 0)->Name("flight, map, axial flow");
BENCHMARK_CAPTURE(fly, map, MapPropeller{}, 5)->Name("flight, map");
BENCHMARK_CAPTURE(fly, bladeElementStill, BladeElementPropeller{}, 0)
    ->Name("flight, blade-element, axial flow");
BENCHMARK_CAPTURE(fly, bladeElement, BladeElementPropeller{}, 5)->Name("flight, blade-element");
BENCHMARK(buildMap)->Name("build map")->Unit(benchmark::kMillisecond);

}  // namespace
