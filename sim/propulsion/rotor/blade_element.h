// A propeller by blade elements in momentum inflow: the blade is cut into annuli, each section
// meets the air at its own angle, and the induced velocity of each annulus is the one momentum
// theory gives for the thrust of its sections. Solved for the induced velocity v, which works alike
// in hover, climb, descent, as a windmill and standing still:
//   R(v) = v - v_momentum(h(v), V),  h = W^2 sigma c_l cos(phi)/(4 F k)
//   flow at the section: W_a = V + v, W_t = V_t - u, u = (V_t - sqrt(V_t^2 - 4 v W_a))/2
// The swirl u stays within half the turning, also where the air drives the blade. k: momentum
// factor (1/sqrt(k) is the induced-power factor), F: Prandtl's tip loss, sigma: solidity. Drag acts
// on thrust and torque, not on the induction. In the vortex ring state the inflow is empirical, and
// where stall leaves an annulus several solutions in descent, a mean of them is taken
// (inflow_root.h). In oblique flow the sections are averaged over the azimuth at one induced
// velocity and one swirl per annulus, the swirl going with the share of the turning in the mean
// square of the tangential speed (ours: QPROP's swirl is one of axial flow), blades being rigid.
// The skew of the inflow and flapping come in closed form afterwards (disc_response.h); radial flow
// and dynamic stall are left out.
//   axial:   H. Glauert, Airplane propellers, in Durand IV, 1935; M. Drela, QPROP formulation,
//            2006;
//            S. A. Ning, Wind Energy 17, 2014 (bracketing)
//   oblique: J. G. Leishman, Principles of Helicopter Aerodynamics, 2nd ed., ch. 3
// Frame: axis along the thrust; axial speed V positive in climb. SI; angles in rad.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/propulsion/rotor/blade.h"
#include "sim/propulsion/rotor/disc_response.h"
#include "sim/propulsion/rotor/rotor_load.h"

namespace rotorbench {

/// The air a propeller works in.
struct AirState {
  double density = 1.225;            ///< kg/m^3, not negative
  double viscosity = kAirViscosity;  ///< Pa s, dynamic, above 0
};

/// How finely and with which momentum factor a propeller is solved.
struct BladeElementSettings {
  int elements = 24;               ///< annuli of equal width
  double momentumFactor = 0.7423;  ///< k, 1: ideal inflow
  int azimuths = 12;  ///< directions of a blade in oblique flow; an odd number counts one more
  bool operator==(const BladeElementSettings&) const = default;
};

/// What one annulus does, all blades together.
struct ElementLoad {
  double radius = 0;           ///< r/R
  double inflowAngle = 0;      ///< phi, rad, from the plane of rotation
  double angleOfAttack = 0;    ///< alpha, rad
  double reynolds = 0;         ///< with the speeds Om r and V
  double lift = 0, drag = 0;   ///< section coefficients
  double inducedVelocity = 0;  ///< v, m/s
  double swirl = 0;            ///< u, m/s
  double thrustPerRadius = 0;  ///< dT/dr, N/m
  double torquePerRadius = 0;  ///< dQ/dr, N
};

/// Thrust along the axis, N; torque against the rotation, N m; and how much of the disc is in the
/// vortex ring state, between -0.5 and -2 hover induced velocities, where the inflow is empirical
/// (0 to 1).
struct AxialLoad {
  double thrust = 0;
  double torque = 0;
  double vortexRingShare = 0;
};

/// Loads in oblique flow, in the frame of the in-plane hub velocity: e1 along it, e2 = s (axis x
/// e1), s the spin. Of rigid blades in an even inflow: a blade ahead of the hub meets the air as
/// one behind it does, so there is neither a force along e2 nor a moment of thrust times distance
/// along e1.
struct ObliqueLoad {
  double thrust = 0;  ///< N along the axis
  double torque = 0;  ///< N m against the rotation
  double drag = 0;    ///< H, N along -e1
  double rollMoment =
      0;  ///< N m: sum of thrust times distance along e2; the advancing side is at -e2
};

/// Induced velocities of the last solution; given again, they make the next one faster. Not for use
/// by two threads at once. Only a start: the same inputs give the same loads to the solver's
/// tolerance.
struct InflowMemory {
  static constexpr std::size_t kMostElements = 200;
  std::array<double, kMostElements> velocity{};
  bool valid = false;
};

/// A propeller made ready to be solved. The geometry must satisfy its schema. The solve itself has
/// no heap, no virtual call and no exception, and gives finite loads for all finite speeds.
class BladeElementRotor {
 public:
  explicit BladeElementRotor(const PropellerGeometry& geometry,
                             const BladeElementSettings& settings = {});

  /// Loads at speed omega, rad/s, in an axial stream, m/s. Turning backwards (omega below 0)
  /// follows the rule of a section that is alike fore and aft, T(-omega, V) = -T(omega, -V), the
  /// same for Q: a real blade, with its sharp edge leading and its camber the wrong way, does less.
  /// `distribution` takes the first of its annuli.
  [[nodiscard]] AxialLoad axial(double omega, double axialSpeed, const AirState& air,
                                InflowMemory* memory = nullptr,
                                std::span<ElementLoad> distribution = {}) const;

  /// Loads with an in-plane speed of the hub, m/s, not negative, and omega not negative.
  [[nodiscard]] ObliqueLoad oblique(double omega, double axialSpeed, double inPlaneSpeed,
                                    const AirState& air) const;

  /// Force and moment about the hub in body axes, as RotorModel::load(): speed w in rad/s, hub
  /// velocity against the air and unit axis in body axes, spin +1 or -1 (counter-clockwise from
  /// above is +1).
  [[nodiscard]] RotorLoad<double> load(double w, const Eigen::Vector3d& v,
                                       const Eigen::Vector3d& axis, double spin,
                                       const AirState& air) const;

  /// What discResponse() takes of the propeller.
  [[nodiscard]] const DiscConstants& disc() const { return disc_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] int elements() const { return static_cast<int>(elements_.size()); }

  /// One annulus: lengths in m.
  struct Element {
    double radius, width, chord, twist, twistSine, twistCosine;
    double solidity;     // B c/(2 pi r)
    double tipDistance;  // B (R - r)/(2 r)
    SectionPlace place;
    std::size_t section;  // blended with the next by `weight`
    double weight;
  };
  [[nodiscard]] const std::vector<Element>& annuli() const { return elements_; }
  [[nodiscard]] double blades() const { return blades_; }
  [[nodiscard]] double momentumFactor() const { return momentumFactor_; }
  /// Sines of the azimuths oblique flow is averaged over.
  [[nodiscard]] const std::vector<double>& azimuthSines() const { return azimuths_; }
  /// Coefficients of an annulus at one Reynolds number and many angles of attack, rad; gives the
  /// angle without lift.
  double sections(const Element& element, double reynolds, std::span<const double> alpha,
                  std::span<SectionCoefficients> coefficients) const;

 private:
  using PreparedSection = std::variant<AnalyticSection, PreparedPolars>;

  void prepareDisc(const PropellerGeometry& geometry);
  template <class Use>
  void withCurve(const Element& element, double reynolds, const Use& use) const;
  template <class Curve>
  double solveAxial(const Element& element, const Curve& curve, double axial, double tangential,
                    const double* guess) const;
  void addAxial(const Element& element, double omega, double axialSpeed, const AirState& air,
                double* memory, bool warm, AxialLoad& load, ElementLoad* detail) const;
  void addOblique(const Element& element, double omega, double axialSpeed, double inPlaneSpeed,
                  const AirState& air, ObliqueLoad& load) const;

  std::vector<Element> elements_;
  std::vector<PreparedSection> sections_;
  std::vector<double>
      azimuths_;  // their sines, from the rear to the front: the other half of the circle is alike
  double radius_ = 0, blades_ = 2, momentumFactor_ = 1;
  DiscConstants disc_;
};

/// Force and moment in body axes of what discResponse() gives: `inPlane` velocity in m/s, unit
/// axis, spin +1 or -1; `front` is +1, or -1 where the propeller turns backwards.
template <class S, class Vector, class Axis>
RotorLoad<S, Vector> bodyLoad(const DiscLoad<S>& l, const Vector& inPlane, const Axis& axis,
                              double spin, double front) {
  RotorLoad<S, Vector> body;
  body.thrust = front * l.thrust;
  body.torque = front * l.torque;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    // e2 times the in-plane speed is spin times this; both turn over with the axis.
    const S across = front * (axis[i] * inPlane[j] - axis[j] * inPlane[i]);
    body.force[k] = body.thrust * axis[k] - l.drag * inPlane[k] + l.side * (spin * across);
    body.moment[k] = spin * (l.roll * inPlane[k] - body.torque * axis[k]) - l.pitch * across;
  }
  return body;
}

template <>
struct Describe<BladeElementSettings> {
  static void fields(schema::Builder<BladeElementSettings>& b);
};

}  // namespace rotorbench
