#include "sim/propulsion/rotor/section_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/parallel.h"
#include "sim/propulsion/rotor/momentum_inflow.h"

namespace rotorbench {

namespace {

constexpr double kRowsPerLog = 10;

/// Unit vector (cosine, sine) at a place of the table, in cells.
std::array<double, 2> directionAt(int cell) {
  const double s = 4.0 * cell / SectionTable::kCells - 2;
  const double a = std::abs(s) <= 1 ? s : std::copysign(2, s) - s;
  const double t = std::abs(s) <= 1 ? 1 - std::abs(a) : std::abs(a) - 1;
  const double length = std::hypot(a, t);
  return {t / length, a / length};
}

}  // namespace

SectionTable::SectionTable(const BladeElementRotor& rotor, double leastReynolds,
                           double mostReynolds) {
  constexpr double kSlowest = 0.7;  // of the air speed: where all of it is in the plane
  const auto& annuli = rotor.annuli();
  double widest = 1;  // of the ratios between the fastest and the slowest flow of an annulus
  for (const auto& e : annuli) {
    const double turning = e.radius / (0.75 * rotor.radius());
    const double slowest = std::min(kSlowest, turning), fastest = std::max(1.0, turning);
    widest = std::max(widest, fastest / slowest);
    least_.push_back(std::log(leastReynolds * std::max(e.chord, 1e-9) / rotor.radius() * slowest));
  }
  rows_ = static_cast<std::size_t>(
              std::ceil(std::log(mostReynolds / leastReynolds * widest) * kRowsPerLog)) +
          1;
  lift_.resize(2 * annuli.size() * rows_ * kStride);
  loads_.resize(2 * lift_.size());
  freeSlope_.resize(annuli.size() * rows_);
  inParallel(annuli.size(), [&](std::size_t i) {
    const auto& e = annuli[i];
    // One cell before the circle begins and two after its end, which meet the other end.
    constexpr int kBefore = 1, kPoints = kCells + 4;
    std::array<double, kPoints> alpha{}, cosine{}, sine{}, loss{};
    std::array<SectionCoefficients, kPoints> c;
    for (int k = 0; k < kPoints; ++k) {
      const auto [cos, sin] = directionAt((k - kBefore + kCells) % kCells);
      const auto n = static_cast<std::size_t>(k);
      cosine[n] = cos, sine[n] = sin;
      alpha[n] = e.twist - std::atan2(sin, cos);
      loss[n] = tipLoss(e.tipDistance, sin);
    }
    for (std::size_t r = 0; r < rows_; ++r) {
      const std::size_t row = i * rows_ + r;
      const double zero =
          rotor.sections(e, std::exp(least_[i] + static_cast<double>(r) / kRowsPerLog), alpha, c);
      freeSlope_[row] = static_cast<float>(std::tan(e.twist - zero));
      // Every row is the first of its own pair and the second of the one before it.
      for (const std::size_t second : {std::size_t{0}, std::size_t{1}}) {
        if (second > r) continue;
        float* loads = &loads_[4 * (row - second) * kStride + 2 * second];
        for (std::size_t k = 0; k < kPoints; ++k) {
          loads[4 * k] = static_cast<float>(c[k].lift * cosine[k] - c[k].drag * sine[k]);
          loads[4 * k + 1] = static_cast<float>(c[k].lift * sine[k] + c[k].drag * cosine[k]);
        }
        float* lift = &lift_[2 * (row - second) * kStride + second];
        for (std::size_t k = kBefore; k < kPoints; ++k)
          lift[2 * (k - kBefore)] = static_cast<float>(c[k].lift * cosine[k] / loss[k]);
      }
    }
    return 0;
  });
}

SectionTable::Place SectionTable::at(std::size_t annulus, double logReynolds) const {
  const auto last = static_cast<double>(rows_ - 1);
  const double place = std::clamp((logReynolds - least_[annulus]) * kRowsPerLog, 0.0, last);
  const double row = std::min(std::floor(place), last - 1);
  return {annulus * rows_ + static_cast<std::size_t>(row), static_cast<float>(place - row)};
}

}  // namespace rotorbench
