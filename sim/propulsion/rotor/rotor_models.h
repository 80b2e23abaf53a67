// The rotor models an experiment can choose among, and each made ready to fly. All answer one
// question: force and moment on the hub at a rotor speed, a hub velocity against the air and an air
// density.
//   lumped         constants k_eta, k_m and what moving air does to them (rotor.h), by coefficients
//                  or by CT and CP
//   measured       CT and CP over advance ratio and speed (measured_propeller.h)
//   map            blade elements, tabulated once (propeller_map.h)
//   blade-element  blade elements, solved at every call (blade_element.h)
// SI units, body axes.
#pragma once

#include <memory>
#include <type_traits>
#include <variant>

#include "sim/propulsion/rotor/lumped_rotor.h"
#include "sim/propulsion/rotor/measured_propeller.h"
#include "sim/propulsion/rotor/propeller_map.h"

namespace rotorbench {

/// A propeller by its geometry, tabulated before the flight.
struct MapPropeller {
  PropellerGeometry propeller;
  BladeElementSettings settings;
  PropellerMapSettings map;
  bool operator==(const MapPropeller&) const = default;
};

/// A propeller by its geometry, solved at every evaluation.
struct BladeElementPropeller {
  PropellerGeometry propeller;
  BladeElementSettings settings;
  bool operator==(const BladeElementPropeller&) const = default;
};

using RotorAerodynamics = std::variant<PropellerCoefficients, RotorCoefficients, MeasuredPropeller,
                                       MapPropeller, BladeElementPropeller>;

/// Tip radius in m.
double rotorRadius(const RotorAerodynamics& aerodynamics);
/// The blades' shape where it is known, else null.
const PropellerGeometry* rotorGeometry(const RotorAerodynamics& aerodynamics);

/// A rotor model that is not lumped, made ready. No heap and no exception in load(), which many
/// threads may call.
class PreparedRotor {
 public:
  using Model = std::variant<CoefficientTable, PropellerMap, BladeElementRotor>;
  explicit PreparedRotor(Model model) : model_(std::move(model)) {}

  /// Speed w in rad/s, hub velocity against the air and unit axis in body axes, spin +1 or -1, air
  /// density in kg/m^3; viscosity kAirViscosity. Any scalar; blade elements carry derivatives by
  /// central differences.
  template <class S>
  [[nodiscard]] RotorLoad<S> load(const S& w, const Eigen::Matrix<S, 3, 1>& v,
                                  const Eigen::Vector3d& axis, double spin,
                                  const S& density) const {
    if (const auto* map = std::get_if<PropellerMap>(&model_))
      return map->load<S, Eigen::Matrix<S, 3, 1>>(w, v, axis, spin, density);
    if (const auto* table = std::get_if<CoefficientTable>(&model_))
      return table->load<S, Eigen::Matrix<S, 3, 1>>(w, v, axis, spin, density);
    const auto& rotor = std::get<BladeElementRotor>(model_);
    if constexpr (std::is_same_v<S, double>) {
      return rotor.load(w, v, axis, spin, {density, kAirViscosity});
    } else {
      return expanded(rotor, w, v, axis, spin, density);
    }
  }

  [[nodiscard]] const Model& model() const { return model_; }

 private:
  /// The load's value with its first derivatives along the inputs' own. The solver's tolerance,
  /// 1e-10 of a speed, and the third derivative set the steps.
  template <class S>
  static RotorLoad<S> expanded(const BladeElementRotor& rotor, const S& w,
                               const Eigen::Matrix<S, 3, 1>& v, const Eigen::Vector3d& axis,
                               double spin, const S& density) {
    const S* inputs[] = {&w, &v[0], &v[1], &v[2], &density};
    double x[5];
    for (std::size_t k = 0; k < 5; ++k) x[k] = valueOf(*inputs[k]);
    const auto at = [&] {
      return rotor.load(x[0], {x[1], x[2], x[3]}, axis, spin, {x[4], kAirViscosity});
    };
    const RotorLoad<double> centre = at();
    RotorLoad<S> l{centre.force.template cast<S>(), centre.moment.template cast<S>(),
                   S(centre.thrust), S(centre.torque)};
    const double speed = std::hypot(x[0] * rotor.radius(), std::hypot(x[1], x[2], x[3]));
    const double steps[] = {kStep * speed / rotor.radius(), kStep * speed, kStep * speed,
                            kStep * speed, kStep * x[4]};
    for (std::size_t k = 0; k < 5; ++k) {
      if (!(steps[k] > 0)) continue;
      const double here = x[k];
      x[k] = here + steps[k];
      const RotorLoad<double> up = at();
      x[k] = here - steps[k];
      const RotorLoad<double> down = at();
      x[k] = here;
      // Value 0, the input's derivatives.
      const S change = S((*inputs[k] - here) / (2 * steps[k]));
      for (int i = 0; i < 3; ++i) {
        l.force[i] += change * (up.force[i] - down.force[i]);
        l.moment[i] += change * (up.moment[i] - down.moment[i]);
      }
      l.thrust += change * (up.thrust - down.thrust);
      l.torque += change * (up.torque - down.torque);
    }
    return l;
  }
  static constexpr double kStep = 1e-4;

  Model model_;
};

/// The prepared rotor of a model; null for the lumped ones. Maps are kept, the last few of them:
/// equal rotors share one, and the next run with the same propeller finds it ready. May be called
/// from several threads.
std::shared_ptr<const PreparedRotor> prepareRotor(const RotorAerodynamics& aerodynamics);

template <>
struct Describe<MapPropeller> {
  static void fields(schema::Builder<MapPropeller>& b);
};
template <>
struct Describe<BladeElementPropeller> {
  static void fields(schema::Builder<BladeElementPropeller>& b);
};

}  // namespace rotorbench
