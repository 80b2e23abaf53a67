// Where the four, six or eight rotors of a multirotor sit. Body axes: x forward (to the front rotor
// of a plus, between two of a cross), y left, z up. Numbered from the front, counter-clockwise seen
// from above; spin +1 turns counter-clockwise seen against the thrust axis (from above), neighbours
// turn oppositely: plus layout, first rotor +1: s = (+1, -1, +1, -1).
#pragma once

#include <Eigen/Core>
#include <numbers>
#include <variant>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench {

enum class Spin { CounterClockwise, Clockwise };

inline double spinSign(Spin spin) {
  return spin == Spin::CounterClockwise ? 1.0 : -1.0;
}

/// The numbers of rotors a ring can have, and a vehicle.
enum class RingCount { Four = 4, Six = 6, Eight = 8 };

/// First rotor ahead on the x axis.
struct PlusLayout {
  RingCount count = RingCount::Four;
  double arm = 0.225;  ///< m, centre to hub
  double height = 0;   ///< m, hub plane above the body origin
  Spin firstSpin = Spin::CounterClockwise;
  bool operator==(const PlusLayout&) const = default;
};

/// First rotor ahead to the left, x between the two front rotors. Defaults: DJI F450.
struct CrossLayout {
  RingCount count = RingCount::Four;
  double arm = 0.1651 * std::numbers::sqrt2;  ///< m, centre to hub: 0.1651 m along both axes
  double height = 0.025;                      ///< m
  Spin firstSpin = Spin::CounterClockwise;
  bool operator==(const CrossLayout&) const = default;
};

struct RotorPlacement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, hub in the body frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     ///< thrust direction, any length
  Spin spin = Spin::CounterClockwise;
  bool operator==(const RotorPlacement&) const = default;
};

/// Every hub placed by hand.
struct FreeLayout {
  std::vector<RotorPlacement> rotors{
      {{0.2, 0, 0}, Eigen::Vector3d::UnitZ(), Spin::CounterClockwise},
      {{0, 0.2, 0}, Eigen::Vector3d::UnitZ(), Spin::Clockwise},
      {{-0.2, 0, 0}, Eigen::Vector3d::UnitZ(), Spin::CounterClockwise},
      {{0, -0.2, 0}, Eigen::Vector3d::UnitZ(), Spin::Clockwise}};
  bool operator==(const FreeLayout&) const = default;
};

using RotorLayout = std::variant<CrossLayout, PlusLayout, FreeLayout>;

/// How many rotors a layout has.
int rotorCount(const RotorLayout& layout);

/// The hubs of a layout, axes of unit length.
std::vector<RotorPlacement> placeRotors(const RotorLayout& layout);

template <>
struct Describe<PlusLayout> {
  static void fields(schema::Builder<PlusLayout>& b);
};
template <>
struct Describe<CrossLayout> {
  static void fields(schema::Builder<CrossLayout>& b);
};
template <>
struct Describe<RotorPlacement> {
  static void fields(schema::Builder<RotorPlacement>& b);
};
template <>
struct Describe<FreeLayout> {
  static void fields(schema::Builder<FreeLayout>& b);
};

}  // namespace rotorbench
