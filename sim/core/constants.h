// Factors between the units people speak in and SI.
#pragma once

#include <numbers>

namespace rotorbench {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2 * kPi;      ///< rad of a full turn
inline constexpr double kDegree = kPi / 180;  ///< rad of one degree
inline constexpr double kRpm = kPi / 30;      ///< rad/s of one revolution per minute

}  // namespace rotorbench
