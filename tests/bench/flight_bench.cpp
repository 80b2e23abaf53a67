// How fast the flagship flies: simulated seconds per second on one core, everything recorded, and
// what the parts of a tick cost. CPU time of this thread, since the machine may be shared.
#include <benchmark/benchmark.h>

#include "sim/control/control_model.h"
#include "sim/control/pid_flight.h"
#include "sim/control/speed_controllers.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/run/plant_handle.h"
#include "sim/run/scheduler.h"
#include "sim/run/simulation.h"
#include "sim/sensing/sensor_tasks.h"
#include "sim/sensing/true_state.h"
#include "sim/vehicle/multirotor.h"

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
  const auto& flight = alternative<Flight>(flagship().setup);
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

/// All of a tick but the integration, recording and derivative included: what the tasks cost.
void controllerTick(benchmark::State& state) {
  Experiment experiment = flagship();
  auto& flight = alternative<Flight>(experiment.setup);
  const auto& inputs = alternative<ControlledInputs>(flight.control);
  const ControlModel model = controlModel(flight.vehicle, flight.environment, {});
  const auto plant = makePlant(flight, RotorDrive::Motors, {});
  std::vector<std::unique_ptr<Task>> tasks;
  tasks.push_back(makeSensors(flight.sensors, 1));
  tasks.push_back(std::make_unique<TrueState>());
  tasks.push_back(std::make_unique<PidFlight>(std::get<PidFlightParameters>(inputs.controller),
                                              model, Timing{2}));
  tasks.push_back(std::make_unique<SpeedControllers>(inputs.motors, model, Timing{}));
  Scheduler scheduler(std::move(tasks), Signal::Truth | Signal::SetPoint);
  std::vector<double> row(scheduler.channels().size());
  Board board;
  plant->observe(board.truth);
  ClockTick tick{0, flight.tick};
  for (auto _ : state) {
    scheduler.run(tick, board, row.data());
    plant->command(tick, board.command);
    tick.time += flight.tick;
    benchmark::DoNotOptimize(board);
  }
}
BENCHMARK(controllerTick);

}  // namespace
