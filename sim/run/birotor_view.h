// How the two birotors appear in recordings: their channels, declared where they are computed.
// Inertial y-z plane, z up, SI.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "sim/core/channel.h"
#include "sim/core/metrics.h"
#include "sim/vehicle/birotor.h"

namespace rotorbench {

/// Channels after the time, and the row that belongs to them.
template <class Plant>
struct BirotorView;

template <>
struct BirotorView<RigidBarBirotor> {
  static std::vector<Channel> channels();
  void row(const RigidBarBirotor& plant, const RigidBarBirotor::State& y, double* out);
  /// How fast the bar turns at time t, and how fast it would with each damping law: what the choice
  /// between them changes.
  static std::vector<Metric> endMetrics(const RigidBarBirotor& plant, double t,
                                        const RigidBarBirotor::State& y);
};

/// The angle is unwrapped from row to row.
template <>
struct BirotorView<SpringBarBirotor> {
  static std::vector<Channel> channels();
  void row(const SpringBarBirotor& plant, const SpringBarBirotor::State& y, double* out);
  static std::vector<Metric> endMetrics(const SpringBarBirotor& plant, double t,
                                        const SpringBarBirotor::State& y);

 private:
  double angle_ = 0;
  bool started_ = false;
};

}  // namespace rotorbench
