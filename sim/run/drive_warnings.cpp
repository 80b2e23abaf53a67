#include "sim/run/drive_warnings.h"

#include <algorithm>

#include "sim/control/pid.h"
#include "sim/run/drive_build.h"
#include "sim/run/step_stability.h"

namespace rotorbench {

void warnOfDelays(const EscParameters& esc, const std::string& path, double rate,
                  std::vector<Problem>& problems) {
  const auto warn = [&](double delay, const char* key) {
    if (delay > 10 / rate)
      problems.push_back({path + key,
                          "is longer than ten updates of the controller, which does not know of it",
                          "expect overshoot, or shorten it", true});
  };
  warn(esc.responseTime, ".responseTime");
  warn(esc.deadTime, ".deadTime");
}

void checkRate(double rate, double tick, const std::string& path, std::vector<Problem>& problems) {
  try {
    ticksBetween(rate, tick, Place(path));
  } catch (const InputError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
}

void warnOfUnstableStep(const DriveStand& stand, const ode::SolverSettings& solver, double tick,
                        std::vector<Problem>& problems) {
  if (!(stabilityLimit(solver.method) > 0)) return;
  // The motor makes the fast pole; the propeller's share of it changes little between few points.
  const DriveTrain train = buildCoarseDriveTrain(stand);
  const double top = train.steadySpeed(train.supply().openCircuit(1.0));
  const double pole = std::max(train.fastestPole(0), train.fastestPole(top));
  const double lag = train.esc().inverseResponse;
  StepWarning words{"run.solver.step", "the motor's fastest pole", "quasi-static current"};
  if (lag > pole) words = {"run.solver.step", kLagPole, "no response time"};
  addUnstableStep(words, std::max(pole, lag), solver, tick, problems);
}

}  // namespace rotorbench
