// How the two birotors appear in recordings: their channels, declared where they are computed. Inertial y-z plane, z up, SI.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "sim/core/channel.h"
#include "sim/vehicle/birotor.h"

namespace rotorbench {

/// Channels after the time, and the row that belongs to them.
template <class Plant>
struct BirotorView;

template <>
struct BirotorView<RigidBarBirotor> {
  static std::vector<Channel> channels();
  void row(const RigidBarBirotor& plant, const RigidBarBirotor::State& y, double* out);
};

/// The angle is unwrapped from row to row.
template <>
struct BirotorView<SpringBarBirotor> {
  static std::vector<Channel> channels();
  void row(const SpringBarBirotor& plant, const SpringBarBirotor::State& y, double* out);

 private:
  double angle_ = 0;
  bool started_ = false;
};

}  // namespace rotorbench
