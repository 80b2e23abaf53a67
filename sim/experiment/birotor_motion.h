// A birotor moved by constant forces, with one solver: chapter 2 of the 2014 thesis.
#pragma once

#include <memory>

#include "sim/core/schema.h"
#include "sim/experiment/simulation.h"
#include "sim/ode/solver_settings.h"
#include "sim/vehicle/birotor.h"

namespace rotorbench {

struct OutputSettings;

struct BirotorMotion {
  BirotorModel plant = SpringBarParameters{};
  ode::SolverSettings solver{.method = ode::Method::Rk4, .step = 0.05};
  double sampleInterval = 0.05;  ///< s between rows; the solver ends a step at each
  double duration = 24;          ///< s
  bool operator==(const BirotorMotion&) const = default;
};

/// Throws InputError where the solver does not fit.
std::unique_ptr<Simulation> buildBirotorMotion(const BirotorMotion& motion,
                                               const OutputSettings& outputs);

template <>
struct Describe<BirotorMotion> {
  static void fields(schema::Builder<BirotorMotion>& b);
};

}  // namespace rotorbench
