#include "sim/validation/drive_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/fitting/least_squares.h"

namespace rotorbench::validation {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct FittedConstant {
  double DriveConstants::*member;
  const char* key;
  double low, high, scale;
};

/// What is positive may be off its guess by a factor of twenty.
std::vector<FittedConstant> fittedConstants(const DriveFitChoice& choice,
                                            const DriveConstants& guess) {
  using C = DriveConstants;
  constexpr double kFactor = 20;
  std::vector<FittedConstant> fitted;
  const auto positive = [&](double C::*member, const char* key) {
    const double start = guess.*member;
    fitted.push_back({member, key, start / kFactor, start * kFactor, start});
  };
  const auto fromZero = [&](double C::*member, const char* key, double scale) {
    fitted.push_back({member, key, 0, kInfinity, scale});
  };
  positive(&C::resistance, "R");
  if (choice.motor) {
    positive(&C::torqueConstant, "Kv");
    fromZero(&C::noLoadCurrent, "I0", std::max(guess.noLoadCurrent, 0.01));
    positive(&C::loadCurrent, "kq/K");
  }
  if (choice.viscous)
    fromZero(&C::viscousCurrent, "f/K", guess.noLoadCurrent * guess.torqueConstant);
  if (choice.standby) fitted.push_back({&C::standbyCurrent, "I_s", -kInfinity, kInfinity, 0.1});
  if (choice.throttleLine) {
    fitted.push_back({&C::throttleStart, "u0", -0.5, 0.5, 0.1});
    fitted.push_back({&C::throttleFull, "u1", 0.55, 2, 0.1});
  }
  if (choice.chopping) {
    positive(&C::ripple, "1/(L f)");
    fromZero(&C::switchingLoss, "k_s", 0.1);
  }
  return fitted;
}

/// What a residual is a part of: the measured value, or `floor` where there is little of it.
double shareOf(double value, double measured, double floor) {
  return value / (measured + floor);
}

/// A motor whose friction is I0 and f/K as its data sheet's no-load current and viscous share.
MotorParameters motorOf(const DriveConstants& c) {
  MotorParameters m;
  m.speedConstant = 1 / c.torqueConstant;
  m.resistance = c.resistance;
  m.maxCurrent = kMostCurrentLimit;
  const double slope = c.viscousCurrent * m.speedConstant;  // A/V of back-EMF
  m.noLoadCurrent = (c.noLoadCurrent + slope * m.noLoadVoltage) / (1 + slope * m.resistance);
  const double viscous = m.noLoadCurrent - c.noLoadCurrent;
  m.viscousShare = m.noLoadCurrent > 0 ? std::clamp(viscous / m.noLoadCurrent, 0.0, 1.0) : 0;
  return m;
}

}  // namespace

DriveTrain driveTrain(const DriveConstants& c, double voltage) {
  DriveTrainSetup setup;
  setup.supply = SupplyParameters{.voltage = voltage};
  setup.motor = motorOf(c);
  setup.esc = {.resistance = 0,
               .responseTime = 0,
               .activeBraking = c.activeBraking,
               .throttleStart = c.throttleStart,
               .throttleFull = c.throttleFull,
               .pwmFrequency = c.ripple > 0 ? 1 / (c.ripple * setup.motor.inductance) : 0,
               .switchingLoss = c.switchingLoss};
  const double k = c.loadCurrent * c.torqueConstant;
  setup.load = c.load ? *c.load : ShaftLoad{.quadratic = {1, {k, k}}};
  return DriveTrain(setup);
}

DrivePrediction predicted(const DriveConstants& c, double throttle, double voltage) {
  const DriveTrain train = driveTrain(c, voltage);
  const DriveTrain::State y = train.steadyState(throttle, 1, 0);
  const double speed = y[DriveTrain::kSpeed];
  return {speed, train.instant(y).busCurrent + c.standbyCurrent, train.load().thrustAt(speed)};
}

DriveFit fitDrive(const std::vector<LoggedPoint>& points, const DriveFitChoice& choice,
                  const DriveConstants& guess, double floor) {
  enum Output : std::size_t { kSpeed, kCurrent };
  double speed = 0, current = 0;
  for (const LoggedPoint& p : points) {
    speed = std::max(speed, p.speed);
    current = std::max(current, p.current);
  }
  speed *= floor, current *= floor;

  FitProblem problem;
  const std::vector<FittedConstant> fitted = fittedConstants(choice, guess);
  for (const FittedConstant& constant : fitted) {
    FitParameter& p = problem.parameters.emplace_back();
    p.key = p.label = constant.key;
    p.start = guess.*constant.member;
    p.low = constant.low, p.high = constant.high, p.scale = constant.scale;
  }
  problem.outputs.resize(2);  // shares, 1 each
  for (const LoggedPoint& p : points) {
    problem.points.push_back({kSpeed, p.throttle, shareOf(p.speed, p.speed, speed)});
    problem.points.push_back({kCurrent, p.throttle, shareOf(p.current, p.current, current)});
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
      const DrivePrediction model = predicted(c, p.throttle, p.voltage);
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
  DriveFit fit{constantsAt([&](std::size_t i) { return result.parameters[i].value; }), {}};
  for (const FittedParameter& p : result.parameters) {
    if (p.atBound()) fit.atBound += (fit.atBound.empty() ? "" : ", ") + p.parameter.key;
  }
  return fit;
}

}  // namespace rotorbench::validation
