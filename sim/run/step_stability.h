// Whether a fixed step can be stable beside the fastest pole of a plant, and the sentence that says
// it cannot.
#pragma once

#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/ode/solver_settings.h"

namespace rotorbench {

/// Where the region of absolute stability meets the negative real axis, h |pole|; 0 for methods
/// that choose their step. Hairer, Wanner, Solving ODEs II, IV.2 (Runge-Kutta) and V.1 (Adams
/// PECE). The exponential method is held to the limit of RK4 for what it does not solve exactly.
double stabilityLimit(ode::Method method);

/// The pole 1/T of a speed controller with the response time T, in words.
inline constexpr const char* kLagPole = "the pole of the speed controller's response time";

/// Words of the warning.
struct StepWarning {
  std::string path;    ///< of the step
  std::string pole;    ///< "the motor's fastest pole"
  std::string remedy;  ///< what helps besides a shorter step
};

/// Adds a warning that names pole, method and largest stable step where a fixed step cannot be
/// stable with a pole of this magnitude, 1/s.
void addUnstableStep(const StepWarning& words, double pole, const ode::SolverSettings& solver,
                     double tick, std::vector<Problem>& problems);

}  // namespace rotorbench
