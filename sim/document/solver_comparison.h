// The solver laboratory: one problem, several methods, one reference. Experiments 1 and 2 of the
// 2014 thesis are its two driving modes.
#pragma once

#include <vector>

#include "sim/core/schema.h"
#include "sim/ode/solver_settings.h"
#include "sim/vehicle/birotor.h"

namespace rotorbench {

/// Sampled: a step never crosses a sample instant, errors are taken at the instants. Free: each
/// method runs over the whole span in one go, errors are taken at its own steps.
enum class DrivingMode { Sampled, Free };

struct ComparedMethod {
  ode::Method method = ode::Method::Rk4;
  bool operator==(const ComparedMethod&) const = default;
};

struct SolverComparison {
  BirotorModel plant;
  DrivingMode mode = DrivingMode::Sampled;
  double sampleInterval = 0.01;  ///< s; step of the fixed-step methods too
  double duration = 60;          ///< s
  std::vector<ComparedMethod> methods{{ode::Method::Euler},  {ode::Method::Rk4},
                                      {ode::Method::Abm4},   {ode::Method::Rk547M},
                                      {ode::Method::Rk546M}, {ode::Method::Rk547S}};
  std::variant<ode::ScaledErrorControl, ode::ThesisErrorControl> errorControl =
      ode::ThesisErrorControl{};
  double referenceStep = 0.2e-3;  ///< s, RK4
  bool workPrecision = true;
  bool operator==(const SolverComparison&) const = default;
};

template <>
struct Describe<ComparedMethod> {
  static void fields(schema::Builder<ComparedMethod>& b);
};
template <>
struct Describe<SolverComparison> {
  static void fields(schema::Builder<SolverComparison>& b);
};

}  // namespace rotorbench
