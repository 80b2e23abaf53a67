// How each kind of experiment becomes a simulation: one function a kind.
#pragma once

#include <filesystem>
#include <memory>

#include "sim/core/place.h"
#include "sim/document/experiment.h"
#include "sim/run/simulation.h"

namespace rotorbench {

/// What a kind's parameters do not hold themselves.
struct BuildContext {
  const OutputSettings& outputs;
  std::uint64_t seed;                      ///< of every random stream of the run
  const std::filesystem::path& directory;  ///< where files the experiment names are looked for
  Place place;                             ///< of the kind in the document: "setup"
};

// All throw InputError naming every problem, with paths from the context's place on.
std::unique_ptr<Simulation> build(const Flight& flight, const BuildContext& context);
std::unique_ptr<Simulation> build(const SolverComparison& comparison, const BuildContext& context);
std::unique_ptr<Simulation> build(const MotorBench& bench, const BuildContext& context);
std::unique_ptr<Simulation> build(const PropellerBench& bench, const BuildContext& context);
std::unique_ptr<Simulation> build(const ThrustStand& stand, const BuildContext& context);
std::unique_ptr<Simulation> build(const MotorSpeedRun& run, const BuildContext& context);
std::unique_ptr<Simulation> build(const BirotorMotion& motion, const BuildContext& context);

}  // namespace rotorbench
