// How fast the flagship flies: simulated seconds per second on one core, everything recorded, and
// what the parts of a tick cost. CPU time of this thread, since the machine may be shared.
#include <benchmark/benchmark.h>

#include "sim/control/control_model.h"
#include "sim/experiment/experiment_file.h"
#include "sim/experiment/pid_pilot.h"
#include "sim/experiment/simulation.h"

namespace {

using namespace rotorbench;

const Experiment& flagship() {
  static const Experiment experiment = loadExperiment(EXPERIMENTS_DIR "/f450-hover-and-steps.json");
  return experiment;
}

/// The whole flight, recording every tick, memory of the recording included.
void flyFlagship(benchmark::State& state) {
  double seconds = 0;
  for (auto _ : state) {
    const auto simulation = buildSimulation(flagship());
    while (simulation->advance(10000) == SimulationState::Running) {
    }
    seconds += simulation->progress().time;
  }
  state.counters["simulated_s_per_s"] = benchmark::Counter(seconds, benchmark::Counter::kIsRate);
}
BENCHMARK(flyFlagship)->Unit(benchmark::kMillisecond)->MinTime(2);

/// The same with one recorded row in a hundred: the cost of recording is the difference.
void flyHardlyRecording(benchmark::State& state) {
  double seconds = 0;
  Experiment experiment = flagship();
  experiment.outputs.recordInterval = 0.1;
  for (auto _ : state) {
    const auto simulation = buildSimulation(experiment);
    while (simulation->advance(10000) == SimulationState::Running) {
    }
    seconds += simulation->progress().time;
  }
  state.counters["simulated_s_per_s"] = benchmark::Counter(seconds, benchmark::Counter::kIsRate);
}
BENCHMARK(flyHardlyRecording)->Unit(benchmark::kMillisecond)->MinTime(1);

/// The floor: one derivative of the same vehicle; a tick cannot cost less than four.
void derivative(benchmark::State& state) {
  const auto& flight = std::get<Flight>(flagship().setup);
  using Plant = Multirotor<4>;
  Plant plant(buildMultirotor<4>(flight.vehicle, flight.environment));
  Plant::State y = plant.initialState(flight.start), dydt;
  plant.setCommand(plant.steadyDuties(plant.hoverSpeeds()));
  for (auto _ : state) {
    plant(0, y, dydt);
    y[0] += 1e-12 * dydt[0];  // the next call waits for this one, as in a Runge-Kutta step
    benchmark::DoNotOptimize(y);
  }
}
BENCHMARK(derivative);

/// The controller's part of a tick, sensors included.
void controllerTick(benchmark::State& state) {
  const auto& flight = std::get<Flight>(flagship().setup);
  PidPilot::Plant plant(buildMultirotor<4>(flight.vehicle, flight.environment));
  PidPilot pilot(std::get<PidControl>(flight.control), controlModel<4>(plant.constants()),
                 flight.tick);
  auto y = plant.initialState(flight.start), dydt = y;
  MultirotorForces<4> forces;
  plant.derivativeAndForces(y, dydt, forces);
  double t = 0;
  for (auto _ : state) {
    plant.setCommand(pilot.command(t, plant, y, forces), y);
    plant.updateCommand(y, dydt, forces);
    t += flight.tick;
    benchmark::DoNotOptimize(y);
  }
}
BENCHMARK(controllerTick);

}  // namespace
