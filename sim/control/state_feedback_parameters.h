// Settings of the controllers that feed back the state (sim/control/state_feedback.h): controller 2
// of the thesis, whose gains come from poles, and the linear-quadratic one, whose gains come from
// what deviations cost.
#pragma once

#include <Eigen/Core>

#include "sim/control/pid_parameters.h"
#include "sim/core/schema.h"

namespace rotorbench {

/// The three stages of controller 2, figures 4.4 to 4.6 of the thesis.
enum class FeedbackStage {
  Plain,     ///< u = K (r - x)
  Integral,  ///< with the integral of the error
  Final      ///< and a demand within limits, whose excess does not wind the integral up
};

/// Poles of one axis, 1/s, all left of the imaginary axis.
template <PidUse Use>
struct AxisPoles {
  double frequency = 7;  ///< w of the pair, rad/s
  double damping = 0.8;  ///< its damping ratio
  double integral = 4;   ///< the integral's pole is -this, 1/s
  double limit = 100;    ///< largest demand of the final stage, m/s^2 or rad/s^2
  bool operator==(const AxisPoles&) const = default;
};

struct StateFeedbackParameters {
  double rate = 500;  ///< Hz
  FeedbackStage stage = FeedbackStage::Final;
  double thrustLag = 0;  ///< s, of the rotors' thrust behind its demand, in the design; 0: none
  AxisPoles<PidUse::Height> altitude{2, 0.9, 1.5, 6};
  AxisPoles<PidUse::Angle> roll{7, 0.8, 4, 100}, pitch{7, 0.8, 4, 100}, yaw{2, 0.9, 1.5, 10};
  bool operator==(const StateFeedbackParameters&) const = default;
};

/// The largest deviations of one axis that are acceptable (Bryson): each of this size costs as much
/// as the others, every second.
template <PidUse Use>
struct AxisWeights {
  double error = 0.1;      ///< m or rad
  double rate = 1;         ///< m/s or rad/s
  double integral = 0.05;  ///< m s or rad s
  double demand = 10;      ///< m/s^2 or rad/s^2
  double limit = 100;      ///< largest demand, the same
  bool operator==(const AxisWeights&) const = default;
};

struct LqrParameters {
  double rate = 500;     ///< Hz
  bool integral = true;  ///< with the integral of the error, and no wind-up of it
  double thrustLag = 0;  ///< s, as above
  AxisWeights<PidUse::Height> altitude{0.5, 1, 0.5, 3, 6};
  AxisWeights<PidUse::Angle> roll{0.1, 1, 0.05, 10, 100}, pitch{0.1, 1, 0.05, 10, 100},
      yaw{0.3, 1, 0.3, 2, 10};
  bool operator==(const LqrParameters&) const = default;
};

template <>
struct Describe<AxisPoles<PidUse::Height>> {
  static void fields(schema::Builder<AxisPoles<PidUse::Height>>& b);
};
template <>
struct Describe<AxisPoles<PidUse::Angle>> {
  static void fields(schema::Builder<AxisPoles<PidUse::Angle>>& b);
};
template <>
struct Describe<StateFeedbackParameters> {
  static void fields(schema::Builder<StateFeedbackParameters>& b);
};
template <>
struct Describe<AxisWeights<PidUse::Height>> {
  static void fields(schema::Builder<AxisWeights<PidUse::Height>>& b);
};
template <>
struct Describe<AxisWeights<PidUse::Angle>> {
  static void fields(schema::Builder<AxisWeights<PidUse::Angle>>& b);
};
template <>
struct Describe<LqrParameters> {
  static void fields(schema::Builder<LqrParameters>& b);
};

}  // namespace rotorbench
