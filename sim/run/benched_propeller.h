// A propeller of the bench made ready: the loads of any rotor model in an axial and an edgewise
// stream, and where the model has something to say. Axial speed positive in climb; SI units.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "sim/propulsion/rotor/rotor_models.h"

namespace rotorbench {

/// Loads in an edgewise stream, in the frame of ObliqueLoad.
struct EdgewiseLoad : ObliqueLoad {
  double side = 0;         ///< N along e2
  double pitchMoment = 0;  ///< N m about e2
};

class BenchedPropeller {
 public:
  /// The propeller must satisfy its schema. A map takes the time to be built, unless it was before.
  explicit BenchedPropeller(const RotorAerodynamics& propeller);

  /// Loads at speed omega, rad/s, in an axial stream, m/s. `memory` and `distribution` are for
  /// blade elements, others leave them alone; the share of the vortex ring is theirs too.
  [[nodiscard]] AxialLoad axial(double omega, double axialSpeed, const AirState& air,
                                InflowMemory* memory = nullptr,
                                std::span<ElementLoad> distribution = {}) const;

  /// Loads with an in-plane speed of the hub, m/s, and omega, neither negative.
  [[nodiscard]] EdgewiseLoad oblique(double omega, double axialSpeed, double inPlaneSpeed,
                                     const AirState& air) const;

  /// Blade elements; null for other models.
  [[nodiscard]] const BladeElementRotor* bladeElements() const;

  /// What was measured near a speed, rad/s; none for a model that is not measured.
  [[nodiscard]] std::optional<CoefficientTable::Limits> limits(double omega) const;
  /// False where a measured propeller is asked for an advance ratio that was not measured.
  [[nodiscard]] bool knowsAdvance(double omega, double axialSpeed) const;
  /// False there, and at a speed outside the measured ones.
  [[nodiscard]] bool knows(double omega, double axialSpeed) const;

  [[nodiscard]] double radius() const { return radius_; }

 private:
  template <class Model>
  [[nodiscard]] const Model* prepared() const {
    return prepared_ ? std::get_if<Model>(&prepared_->model()) : nullptr;
  }
  [[nodiscard]] RotorLoad<double> load(double omega, const Eigen::Vector3d& v,
                                       const AirState& air) const;

  std::shared_ptr<const PreparedRotor> prepared_;  ///< null: lumped
  RotorModel<double> lumped_;
  double radius_;
};

}  // namespace rotorbench
