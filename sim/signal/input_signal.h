// Values laid down over time, four of them at each instant: the inputs of rotors, a timeline of
// set-points, a throttle.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench {

/// Between two instants of a table: the earlier value, or a straight line.
enum class Interpolation { Hold, Linear };

/// The choice as documents offer it.
inline std::vector<schema::Named<Interpolation>> interpolations() {
  return {{Interpolation::Hold, "hold", "Hold", "Each value stays until the next instant."},
          {Interpolation::Linear, "linear", "Linear", "Straight lines between the instants."}};
}

/// A prescribed signal ready to be read in the order of time; no heap use in at().
class InputSignal {
 public:
  struct Sample {
    double time;
    Eigen::Vector4d values;
  };
  InputSignal() = default;
  /// `samples` in rising order of time, at least one.
  InputSignal(std::vector<Sample> samples, Interpolation interpolation);

  /// Values at time t; the first ones before the first instant, the last ones after the last. Fast
  /// for times that rise from call to call.
  Eigen::Vector4d at(double t);
  [[nodiscard]] Interpolation interpolation() const { return interpolation_; }

 private:
  std::vector<Sample> samples_;
  Interpolation interpolation_ = Interpolation::Hold;
  std::size_t index_ = 0;
  void seek(double t);
};

}  // namespace rotorbench
