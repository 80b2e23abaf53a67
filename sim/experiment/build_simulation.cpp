#include "sim/core/schema_tree.h"
#include "sim/experiment/experiment.h"
#include "sim/experiment/simulation.h"

namespace rotorbench {

namespace {

std::unique_ptr<Simulation> build(const Flight& flight, const Experiment& e,
                                  const std::filesystem::path& directory) {
  return buildFlight(flight, e.outputs, e.seed, directory);
}
std::unique_ptr<Simulation> build(const SolverComparison& comparison, const Experiment& e,
                                  const std::filesystem::path& /*directory*/) {
  return buildSolverComparison(comparison, e.outputs);
}
std::unique_ptr<Simulation> build(const MotorBench& bench, const Experiment& e,
                                  const std::filesystem::path& /*directory*/) {
  return buildMotorBench(bench, e.outputs);
}
std::unique_ptr<Simulation> build(const PropellerBench& bench, const Experiment& e,
                                  const std::filesystem::path& /*directory*/) {
  return buildPropellerBench(bench, e.outputs);
}
std::unique_ptr<Simulation> build(const ThrustStand& stand, const Experiment& e,
                                  const std::filesystem::path& /*directory*/) {
  return buildThrustStand(stand, e.outputs);
}
std::unique_ptr<Simulation> build(const MotorSpeedRun& run, const Experiment& e,
                                  const std::filesystem::path& /*directory*/) {
  return buildMotorSpeedRun(run, e.outputs);
}
std::unique_ptr<Simulation> build(const BirotorMotion& motion, const Experiment& e,
                                  const std::filesystem::path& /*directory*/) {
  return buildBirotorMotion(motion, e.outputs);
}

}  // namespace

std::unique_ptr<Simulation> buildSimulation(const Experiment& experiment,
                                            const std::filesystem::path& directory) {
  auto problems = schema::validate(schema::ref(experiment));
  std::erase_if(problems, [](const Problem& p) { return p.warning; });
  if (!problems.empty()) throw InputError({}, std::move(problems));
  return std::visit([&](const auto& setup) { return build(setup, experiment, directory); },
                    experiment.setup);
}

}  // namespace rotorbench
