// What a multirotor is made of, as a person enters it. SI units, body axes x forward, y left, z up.
#pragma once

#include <Eigen/Core>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "sim/core/schema.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/propulsion/rotor/rotor.h"
#include "sim/vehicle/geometry.h"
#include "sim/vehicle/mass_properties.h"

namespace rotorbench {

/// All rotors alike.
struct EqualRotors {
  RotorParameters rotor;
  bool operator==(const EqualRotors&) const = default;
};

/// Each rotor its own, in the order of their numbers.
struct IndividualRotors {
  std::vector<RotorParameters> rotors = std::vector<RotorParameters>(4);
  bool operator==(const IndividualRotors&) const = default;
};

using RotorSet = std::variant<EqualRotors, IndividualRotors>;

/// How one rotor differs from the plan: Delta r_i and Delta m_i of the thesis. Controllers do not
/// know of it.
struct RotorDeviation {
  int rotor = 1;                                       ///< number, from 1
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, added to the hub's place
  double mass = 0;                                     ///< kg, added to motor and propeller
  bool operator==(const RotorDeviation&) const = default;
};

/// Air resistance of the body, at the centre of mass, in body axes, in air of 1.225 kg/m^3; it goes
/// with the density.
struct BodyDrag {
  double linear = 0;                                    ///< D, N s/m
  Eigen::Vector3d quadratic = Eigen::Vector3d::Zero();  ///< c, N s^2/m^2: F_k = -c_k |v| v_k
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();    ///< N m s: M_k = -d_k w_k
  bool operator==(const BodyDrag&) const = default;
};

/// Defaults: DJI F450 with E305 motors and 9450 propellers on three cells. Its resistance against
/// the air is none until it is given, and no electronics draw power.
struct VehicleParameters {
  RotorLayout layout;
  RotorSet rotors;
  MassModel mass;
  std::vector<PointMass> payloads;
  std::vector<RotorDeviation> deviations;
  BodyDrag drag;
  SupplyModel supply;
  double avionicsPower = 0;  ///< W, drawn from the supply besides the motors
  bool operator==(const VehicleParameters&) const = default;
};

/// How a flight begins: state of the centre of mass.
enum class RotorStart { Hover, Stopped, Given };

struct FlightStart {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, inertial
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s, inertial
  Eigen::Vector3d attitude = Eigen::Vector3d::Zero();  ///< roll, pitch, yaw, rad
  Eigen::Vector3d rates = Eigen::Vector3d::Zero();     ///< body rates, rad/s
  RotorStart rotors = RotorStart::Hover;
  double rotorSpeed = 0;  ///< rad/s, with RotorStart::Given
  bool operator==(const FlightStart&) const = default;
};

/// A hub's place with its deviation applied, and the point mass there.
struct RotorAtHub {
  RotorPlacement placement;
  RotorParameters rotor;
};

/// Whether a vehicle says what ends its level flight and what ends its climb. All rotors but lumped
/// ones lose thrust in climb by themselves. The in-plane drag of lumped rotors may be that of the
/// whole vehicle, as it is where coefficients were identified in flight; blades never know of the
/// body.
struct AirResistance {
  bool level = true, climb = true;
  [[nodiscard]] bool described() const { return level && climb; }
  /// "no drag of body or rotors in level flight and no ..."; empty where all is described.
  [[nodiscard]] std::string missing() const;
};
AirResistance airResistanceOf(const VehicleParameters& vehicle);

/// Rotors of the vehicle in order; `asPlanned` leaves the deviations out. Throws InputError if the
/// layout and the rotor set disagree, a deviation names no rotor, or there are not 4, 6 or 8.
std::vector<RotorAtHub> rotorsOf(const VehicleParameters& vehicle, bool asPlanned = false);

/// Mass properties with payloads and (unless `asPlanned`) deviations. Throws InputError with
/// massProblems().
MassProperties massOf(const VehicleParameters& vehicle, bool asPlanned = false);

/// Calls f with the number of rotors as a constant: the one place where it becomes a template
/// parameter. Throws InputError if it is not 4, 6 or 8.
template <class F>
decltype(auto) withRotorCount(int count, F&& f) {
  switch (count) {
    case 4:
      return f(std::integral_constant<int, 4>{});
    case 6:
      return f(std::integral_constant<int, 6>{});
    case 8:
      return f(std::integral_constant<int, 8>{});
    default:
      throw InputError(
          {}, {{"layout", "has " + std::to_string(count) + " rotors", "4, 6 or 8 rotors"}});
  }
}

template <>
struct Describe<EqualRotors> {
  static void fields(schema::Builder<EqualRotors>& b);
};
template <>
struct Describe<IndividualRotors> {
  static void fields(schema::Builder<IndividualRotors>& b);
};
template <>
struct Describe<RotorDeviation> {
  static void fields(schema::Builder<RotorDeviation>& b);
};
template <>
struct Describe<BodyDrag> {
  static void fields(schema::Builder<BodyDrag>& b);
};
template <>
struct Describe<VehicleParameters> {
  static void fields(schema::Builder<VehicleParameters>& b);
};
template <>
struct Describe<FlightStart> {
  static void fields(schema::Builder<FlightStart>& b);
};

}  // namespace rotorbench
