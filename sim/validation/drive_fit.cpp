#include "sim/validation/drive_fit.h"

#include <algorithm>
#include <cmath>

#include "sim/core/error.h"
#include "sim/fitting/least_squares.h"
#include "sim/propulsion/drive/steady_motor.h"

namespace rotorbench::validation {

namespace {

struct FittedConstant {
  double DriveConstants::*member;
  const char* key;
};

std::vector<FittedConstant> fittedConstants(const DriveFitChoice& choice) {
  using C = DriveConstants;
  std::vector<FittedConstant> fitted{{&C::torqueConstant, "torqueConstant"},
                                     {&C::resistance, "resistance"},
                                     {&C::noLoadCurrent, "noLoadCurrent"},
                                     {&C::loadCurrent, "loadCurrent"}};
  if (choice.viscous) fitted.push_back({&C::viscousCurrent, "viscousCurrent"});
  if (choice.standby) fitted.push_back({&C::standbyCurrent, "standbyCurrent"});
  if (choice.throttleCurve) {
    fitted.push_back({&C::dutyGain, "dutyGain"});
    fitted.push_back({&C::dutyOffset, "dutyOffset"});
  }
  return fitted;
}

/// What a residual is a part of: the measured value, or `floor` where there is little of it.
double shareOf(double value, double measured, double floor) {
  return value / (measured + floor);
}

}  // namespace

DrivePrediction predicted(const DriveConstants& c, double duty, double voltage) {
  const double d = std::clamp(c.dutyGain * duty + c.dutyOffset, 0.0, 1.0);
  const SteadyCurrent current{c.noLoadCurrent, c.viscousCurrent, c.loadCurrent};
  const double w = std::max(0.0, steadySpeed(current, c.torqueConstant, c.resistance, d * voltage));
  return {w, d * current.at(w) + c.standbyCurrent};
}

DriveConstants fitDrive(const std::vector<LoggedPoint>& points, const DriveFitChoice& choice,
                        const DriveConstants& guess, double floor) {
  enum Output : std::size_t { kSpeed, kCurrent };
  double speed = 0, current = 0;
  for (const LoggedPoint& p : points) {
    speed = std::max(speed, p.speed);
    current = std::max(current, p.current);
  }
  speed *= floor, current *= floor;

  FitProblem problem;
  const std::vector<FittedConstant> fitted = fittedConstants(choice);
  for (const FittedConstant& constant : fitted) {
    FitParameter& p = problem.parameters.emplace_back();
    p.key = constant.key;
    p.start = guess.*constant.member;
    p.scale = p.start != 0 ? std::abs(p.start) : 0.1;
  }
  problem.outputs.resize(2);  // shares, 1 each
  for (const LoggedPoint& p : points) {
    problem.points.push_back({kSpeed, p.duty, shareOf(p.speed, p.speed, speed)});
    problem.points.push_back({kCurrent, p.duty, shareOf(p.current, p.current, current)});
  }
  const auto constantsAt = [&](const auto& valueAt) {
    DriveConstants c = guess;
    for (std::size_t i = 0; i < fitted.size(); ++i) c.*fitted[i].member = valueAt(i);
    return c;
  };
  problem.predict = [&](std::span<const double> values, std::span<double> shares) {
    const DriveConstants c = constantsAt([&](std::size_t i) { return values[i]; });
    auto share = shares.begin();
    for (const LoggedPoint& p : points) {
      const DrivePrediction model = predicted(c, p.duty, p.voltage);
      *share++ = shareOf(model.speed, p.speed, speed);
      *share++ = shareOf(model.current, p.current, current);
    }
    return std::ranges::all_of(shares, [](double x) { return std::isfinite(x); });
  };

  FitOptions options;
  options.weighByScatter = false;
  options.mostIterations = 400;
  const FitResult result = solveLeastSquares(problem, options);
  if (!result.usable()) refuse("points of a drive", result.sentence);
  return constantsAt([&](std::size_t i) { return result.parameters[i].value; });
}

}  // namespace rotorbench::validation
