// The thesis' birotor: two bodies at the ends of a bar in the inertial y-z plane (z up), body 1 at
// -r and body 2 at +r along the angle alpha (from y towards z). Thrust acts square to the bar,
// along (-sin alpha, cos alpha). Thesis 2014, chapter 2. SI units.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <string_view>
#include <variant>

#include "sim/core/schema.h"

namespace rotorbench {

/// What both models share: bodies, forces and the start.
struct BirotorParameters {
  double mass1 = 1, mass2 = 1;                         ///< kg
  double arm = 0.25;                                   ///< r, m, half the bar
  double friction = 0.05;                              ///< D, N s/m, on each body or on the centre
  double gravity = 0;                                  ///< g, m/s^2
  double force1 = 0, force2 = 0;                       ///< N
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();    ///< y, z of the middle of the bar, m
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< m/s
  double angle = 0;                                    ///< alpha, rad
  double angularVelocity = 0;                          ///< rad/s
  bool operator==(const BirotorParameters&) const = default;
};

/// Bar as spring and damper, thesis (2.7)-(2.19). Defaults: table 2.1.
struct SpringBarParameters : BirotorParameters {
  SpringBarParameters() { force1 = 0.2, force2 = -0.2; }
  double stiffness = 1000;  ///< k, N/m
  double damping = 5;       ///< b, N s/m
  bool operator==(const SpringBarParameters&) const = default;
};

enum class BirotorDamping {
  Physical,   ///< moment -2 D r^2 alpha', as in (2.27)
  Thesis2014  ///< what the thesis' program computed: one more factor r
};

/// Rigid bar, thesis (2.25)-(2.32). Defaults: table 2.2.
struct RigidBarParameters : BirotorParameters {
  RigidBarParameters() {
    force1 = 1, force2 = 2;
    centre = {3, 2};
    velocity = {1, -1};
    angle = 5;
    angularVelocity = 2;
  }
  BirotorDamping angularDamping = BirotorDamping::Physical;
  bool operator==(const RigidBarParameters&) const = default;
};

using BirotorModel = std::variant<RigidBarParameters, SpringBarParameters>;

/// State [y1, y1', z1, z1', y2, y2', z2, z2'], (2.14).
class SpringBarBirotor {
 public:
  static constexpr int kStates = 8;
  template <class S>
  using StateOf = Eigen::Matrix<S, kStates, 1>;
  using State = StateOf<double>;
  static constexpr std::array<std::string_view, kStates> kStateNames{
      "body1.y", "body1.vy", "body1.z", "body1.vz", "body2.y", "body2.vy", "body2.z", "body2.vz"};

  explicit SpringBarBirotor(const SpringBarParameters& parameters) : p_(parameters) {}

  /// Angle, length and its rate, and the force of the bar (positive pushes the bodies apart).
  template <class S>
  struct Bar {
    S cosine, sine, length, rate, force;
  };

  /// Equations (2.18) and (2.19). Direction by components, as the arctangent of the thesis loses
  /// the quadrant.
  template <class S>
  [[nodiscard]] Bar<S> bar(const StateOf<S>& y) const {
    using std::sqrt;
    const S dy = y[4] - y[0], dz = y[6] - y[2];
    Bar<S> b;
    b.length = sqrt(dy * dy + dz * dz);
    b.cosine = dy / b.length;
    b.sine = dz / b.length;
    b.rate = (y[5] - y[1]) * b.cosine + (y[7] - y[3]) * b.sine;
    b.force = p_.stiffness * (2 * p_.arm - b.length) - p_.damping * b.rate;
    return b;
  }

  template <class S>
  void derivative(const StateOf<S>& y, StateOf<S>& dydt) const {
    const Bar<S> b = bar(y);
    dydt[0] = y[1];
    dydt[1] = (-p_.force1 * b.sine - b.force * b.cosine - p_.friction * y[1]) / p_.mass1;
    dydt[2] = y[3];
    dydt[3] =
        (p_.force1 * b.cosine - b.force * b.sine - p_.friction * y[3]) / p_.mass1 - p_.gravity;
    dydt[4] = y[5];
    dydt[5] = (-p_.force2 * b.sine + b.force * b.cosine - p_.friction * y[5]) / p_.mass2;
    dydt[6] = y[7];
    dydt[7] =
        (p_.force2 * b.cosine + b.force * b.sine - p_.friction * y[7]) / p_.mass2 - p_.gravity;
  }
  void operator()(double /*t*/, const State& y, State& dydt) const { derivative(y, dydt); }

  static std::string_view componentName(int index) {
    return kStateNames.at(static_cast<std::size_t>(index));
  }
  [[nodiscard]] State initialState() const;
  /// Bar angle in (-pi, pi] and its rate in rad/s.
  [[nodiscard]] static double angle(const State& y);
  [[nodiscard]] static double angularVelocity(const State& y);
  /// Kinetic, potential and spring energy, J.
  [[nodiscard]] double energy(const State& y) const;
  [[nodiscard]] const SpringBarParameters& parameters() const { return p_; }

 private:
  SpringBarParameters p_;
};

/// State [y, y', z, z', alpha, alpha'], (2.29); moment of inertia r^2 M.
/// Two signs of (2.31) are set right: body 2 is on the +alpha side (figure 2.1), so F2 - F1 turns
/// the bar, and the damping moment 2 D r^2 over r^2 M is 2 D r over r M. `Thesis2014` damping is
/// what the published tables were made with: 2 D r^2 over r M.
class RigidBarBirotor {
 public:
  static constexpr int kStates = 6;
  template <class S>
  using StateOf = Eigen::Matrix<S, kStates, 1>;
  using State = StateOf<double>;
  static constexpr std::array<std::string_view, kStates> kStateNames{
      "position.y", "velocity.y", "position.z", "velocity.z", "angle", "angularVelocity"};

  explicit RigidBarBirotor(const RigidBarParameters& parameters);

  template <class S>
  void derivative(const StateOf<S>& y, StateOf<S>& dydt) const {
    using std::cos;
    using std::sin;
    dydt[0] = y[1];
    dydt[1] = (-thrust_ * sin(y[4]) - p_.friction * y[1]) / mass_;
    dydt[2] = y[3];
    dydt[3] = (thrust_ * cos(y[4]) - p_.friction * y[3]) / mass_ - p_.gravity;
    dydt[4] = y[5];
    dydt[5] = (p_.force2 - p_.force1 - angularFriction_ * y[5]) / (p_.arm * mass_);
  }
  void operator()(double /*t*/, const State& y, State& dydt) const { derivative(y, dydt); }

  static std::string_view componentName(int index) {
    return kStateNames.at(static_cast<std::size_t>(index));
  }
  [[nodiscard]] State initialState() const;
  /// Kinetic and potential energy, J.
  [[nodiscard]] double energy(const State& y) const;
  /// Closed form of (2.27) with one of the two damping laws, whichever the parameters choose: the
  /// rotation is a linear equation of its own. rad/s at time t in s from the start.
  [[nodiscard]] double angularVelocityAt(double t, BirotorDamping damping) const;
  [[nodiscard]] const RigidBarParameters& parameters() const { return p_; }

 private:
  [[nodiscard]] static double angularFriction(const RigidBarParameters& p, BirotorDamping damping);

  RigidBarParameters p_;
  double mass_, thrust_, angularFriction_;
};

template <>
struct Describe<SpringBarParameters> {
  static void fields(schema::Builder<SpringBarParameters>& b);
};
template <>
struct Describe<RigidBarParameters> {
  static void fields(schema::Builder<RigidBarParameters>& b);
};

}  // namespace rotorbench
