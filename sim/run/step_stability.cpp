#include "sim/run/step_stability.h"

#include <algorithm>
#include <cmath>

#include "sim/core/number_text.h"

namespace rotorbench {

double stabilityLimit(ode::Method method) {
  switch (method) {
    case ode::Method::Euler:
      return 2.0;
    case ode::Method::Rk4:
    case ode::Method::ExponentialRk4:
      return 2.785;
    case ode::Method::Abm4:
      return 1.25;
    default:
      return 0;
  }
}

void addUnstableStep(const StepWarning& words, double pole, const ode::SolverSettings& solver,
                     double tick, std::vector<Problem>& problems) {
  const double limit = stabilityLimit(solver.method);
  const double step = std::min(solver.step, tick);
  if (!(limit > 0) || !(step * pole > limit)) return;
  problems.push_back(
      {words.path,
       words.pole + ", " + numberText(std::round(pole)) + " 1/s, makes " +
           std::string(ode::name(solver.method)) + " unstable at this step",
       "at most " + numberText(std::floor(limit / pole * 1e8) * 1e-2) + " us, or " + words.remedy,
       true});
}

}  // namespace rotorbench
