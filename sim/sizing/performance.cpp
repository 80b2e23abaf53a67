#include "sim/sizing/performance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/numerics/scalar_search.h"
#include "sim/propulsion/drive/bus.h"
#include "sim/sizing/discharge.h"

namespace rotorbench {

namespace {

constexpr double kSpeedStep = 0.5;  // m/s
constexpr double kSpeedTolerance = 1e-7;
constexpr double kRangeTolerance = 1e-6;  // m/s, of the speed of longest range

double advanceRatio(const SteadyFlight& flight, const Trim& trim) {
  double most = 0;
  for (int i = 0; i < flight.rotors(); ++i) {
    most = std::max(most, trim.speed / (trim.speeds[i] * flight.radius(i)));
  }
  return most;
}

double powerPerSpeed(const SteadyFlight& flight, const Trim& trim) {
  return flight.demand(trim).power / trim.speed;
}

/// Least power per speed between two speeds, from a trim in between.
Trim farthestBetween(const SteadyFlight& flight, const Trim& best, double low, double high) {
  const auto cost = [&](double speed) {
    const auto trim = flight.trim(speed, best);
    return trim ? powerPerSpeed(flight, *trim) : HUGE_VAL;
  };
  return flight.trim(findMinimum(cost, low, high, kRangeTolerance).at, best).value_or(best);
}

}  // namespace

Margin marginOf(const SteadyFlight& flight, const Trim& trim, double throttleLimit,
                double tiltLimit) {
  const Supply& supply = flight.supply();
  const DriveDemand demand = flight.demand(trim);
  const double inner = supply.openCircuit(supply.charge);
  const double bus = voltageUnder(demand.power, inner, supply.resistance);
  if (std::isnan(bus)) {
    const double reserve = busReserve(inner, demand.power, supply.resistance);
    return {reserve / (inner * inner), FlightLimit::Supply};
  }
  Margin least{throttleLimit - demand.voltage.maxCoeff() / bus, FlightLimit::Throttle};
  const auto consider = [&least](double value, FlightLimit limit) {
    if (value < least.value) least = {value, limit};
  };
  for (int i = 0; i < flight.rotors(); ++i) {
    consider(1 - demand.current[i] / flight.currentLimit(i), FlightLimit::Current);
  }
  consider((bus - supply.cutOff) / inner, FlightLimit::CutOff);
  consider(tiltLimit - trim.tilt(), FlightLimit::Tilt);
  return least;
}

LevelFlight levelFlight(const SteadyFlight& flight, const Trim& hover,
                        const PerformanceSettings& settings) {
  const auto margin = [&](const std::optional<Trim>& trim) {
    if (!trim) return Margin{-1, FlightLimit::NoTrim};
    const Margin own = marginOf(flight, *trim, settings.speedThrottle, settings.tiltLimit);
    const double model = kMostAdvance - advanceRatio(flight, *trim);
    return model < own.value ? Margin{model, FlightLimit::Model} : own;
  };
  LevelFlight result{hover, FlightLimit::None, hover};
  double step = kSpeedStep, leastCost = 0, nextStep = 0;
  while (step > kSpeedTolerance) {
    const auto next = flight.trim(result.fastest.speed + step, result.fastest);
    const Margin left = margin(next);
    if (left.value < 0) {
      result.limit = left.limit;
      step /= 2;
      continue;
    }
    result.fastest = *next;
    const double cost = powerPerSpeed(flight, *next);
    if (leastCost == 0 || cost < leastCost) {
      leastCost = cost;
      result.farthest = *next;
      nextStep = step;
    }
    if (step < kSpeedStep) step /= 2;  // a bisection goes on, a march keeps its step
  }
  if (result.farthest.speed > 0) {
    const double low = std::max(0.1, result.farthest.speed - nextStep);
    const double high = std::min(result.fastest.speed, result.farthest.speed + kSpeedStep);
    if (high > low) result.farthest = farthestBetween(flight, result.farthest, low, high);
  }
  return result;
}

void Describe<PerformanceSettings>::fields(schema::Builder<PerformanceSettings>& b) {
  using P = PerformanceSettings;
  b.title("performance", "Limits of the sheet",
          "What must be left of throttle and battery, and how far the vehicle may tilt.");
  b.number("payloadThrottle", &P::payloadThrottle, "Throttle with the largest payload", "", "1")
      .range(schema::above(0), schema::upTo(1))
      .shownIn("%")
      .help("The largest payload hovers with this throttle; the rest is left for control.")
      .source("Convention of this sheet");
  b.number("speedThrottle", &P::speedThrottle, "Throttle in the fastest flight", "", "1")
      .range(schema::above(0), schema::upTo(1))
      .shownIn("%")
      .help("Largest throttle of any rotor in the fastest level flight and at the ceiling.")
      .source("Convention of this sheet");
  b.number("tiltLimit", &P::tiltLimit, "Tilt limit", "", "rad")
      .range(schema::above(0), schema::upTo(1.5))
      .shownIn("deg")
      .help("The vehicle never tilts further, whatever its rotors could do.")
      .source("PX4 parameter MPC_TILTMAX_AIR, default 45 degrees");
  b.number("reserveCharge", &P::reserveCharge, "Reserve of the battery", "", "1")
      .range(schema::atLeast(0), schema::below(1))
      .shownIn("%")
      .help("State of charge at which a flight is over.")
      .source("Common practice with lithium-polymer batteries: land with a fifth left");
}

}  // namespace rotorbench
