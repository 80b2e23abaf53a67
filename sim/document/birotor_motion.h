// A birotor moved by constant forces, with one solver: chapter 2 of the 2014 thesis.
#pragma once

#include "sim/core/schema.h"
#include "sim/ode/solver_settings.h"
#include "sim/vehicle/birotor.h"

namespace rotorbench {

struct BirotorMotion {
  BirotorModel plant = SpringBarParameters{};
  ode::SolverSettings solver{.method = ode::Method::Rk4, .step = 0.05};
  double sampleInterval = 0.05;  ///< s between rows; the solver ends a step at each
  double duration = 24;          ///< s
  bool operator==(const BirotorMotion&) const = default;
};

template <>
struct Describe<BirotorMotion> {
  static void fields(schema::Builder<BirotorMotion>& b);
};

}  // namespace rotorbench
