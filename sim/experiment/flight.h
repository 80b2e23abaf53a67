// A flight: a vehicle in its surroundings, flown by a controller or by inputs laid down in advance.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <variant>

#include "sim/core/schema.h"
#include "sim/environment/environment.h"
#include "sim/experiment/pid_control.h"
#include "sim/experiment/prescribed_inputs.h"
#include "sim/experiment/simulation.h"
#include "sim/ode/solver_settings.h"
#include "sim/sensing/measurement.h"
#include "sim/vehicle/vehicle_parameters.h"

namespace rotorbench {

struct OutputSettings;

struct Flight {
  VehicleParameters vehicle;
  std::variant<PidControl, SpeedInputs, VoltageInputs> control;
  SensorModel sensors;
  EnvironmentParameters environment;
  FlightStart start;
  ode::SolverSettings solver{.method = ode::Method::ExponentialRk4, .step = 1e-3};
  double tick = 1e-3;    ///< s, period of the fastest task
  double duration = 30;  ///< s
  bool operator==(const Flight&) const = default;
};

/// Throws InputError naming every problem.
std::unique_ptr<Simulation> buildFlight(const Flight& flight, const OutputSettings& outputs,
                                        std::uint64_t seed, const std::filesystem::path& directory);

template <>
struct Describe<Flight> {
  static void fields(schema::Builder<Flight>& b);
};

}  // namespace rotorbench
