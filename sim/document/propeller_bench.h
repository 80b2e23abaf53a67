// Propeller bench: a propeller alone, by any of the rotor models a flight can use, turned at a
// speed laid down over time in an axial stream laid down over time (thesis 2014, figures
// 3.19-3.20), and beside the run in time its curves: over the speed, over the advance ratio, over
// an edgewise stream and, by blade elements, along the blade. A second propeller, or the same by
// another model, can go through the same. Loads are quasi-steady: the induced velocity follows at
// once. Axial speed positive in climb, m/s; speeds in rad/s; SI throughout.
#pragma once

#include <variant>
#include <vector>

#include "sim/core/schema.h"
#include "sim/propulsion/rotor/rotor_models.h"
#include "sim/signal/input_signal.h"

namespace rotorbench {

/// The propeller by blade elements.
struct BladeElementSpecimen {
  PropellerGeometry geometry;
  BladeElementSettings settings;
  bool operator==(const BladeElementSpecimen&) const = default;
};

/// Any propeller of the bench: the models of RotorAerodynamics.
using BenchPropeller = std::variant<BladeElementSpecimen, MapPropeller, MeasuredPropeller,
                                    PropellerCoefficients, RotorCoefficients>;

/// No second propeller beside the first.
struct NoPropeller {
  bool operator==(const NoPropeller&) const = default;
};

struct PropellerSpeedRow {
  double time = 0;   ///< s
  double speed = 0;  ///< rad/s, negative: turning backwards
  bool operator==(const PropellerSpeedRow&) const = default;
};

struct AirSpeedRow {
  double time = 0;   ///< s
  double speed = 0;  ///< m/s, against the thrust
  bool operator==(const AirSpeedRow&) const = default;
};

struct SteadyStream {
  double speed = 0;  ///< m/s
  bool operator==(const SteadyStream&) const = default;
};
struct StreamProfile {
  std::vector<AirSpeedRow> rows{1};
  Interpolation interpolation = Interpolation::Linear;
  bool operator==(const StreamProfile&) const = default;
};

/// Where the curves are taken.
struct PropellerCurves {
  double speed = 523.5987755982989;  ///< rad/s of all curves but the one over the speed: 5000 rpm
  double airSpeed = 0;               ///< m/s, axial, of all curves but the one over J
  double topSpeed = 837.7580409572781;  ///< rad/s, end of the curve over the speed: 8000 rpm
  double leastAdvanceRatio = 0, mostAdvanceRatio = 0.8;  ///< J = V/(n D)
  double mostEdgewiseRatio = 0.3;                        ///< in-plane speed over tip speed
  int points = 121;                                      ///< of each curve
  bool operator==(const PropellerCurves&) const = default;
};

struct PropellerRunSettings {
  double tick = 1e-3;   ///< s
  double duration = 2;  ///< s
  bool operator==(const PropellerRunSettings&) const = default;
};

struct PropellerBench {
  BenchPropeller propeller;
  std::variant<NoPropeller, BladeElementSpecimen, MapPropeller, MeasuredPropeller,
               PropellerCoefficients, RotorCoefficients>
      second;                     ///< in the same run, to be compared
  double airDensity = 1.225;      ///< kg/m^3
  double airViscosity = 1.81e-5;  ///< Pa s
  std::vector<PropellerSpeedRow> speeds{{0, 0}, {1.5, 837.7580409572781}};
  Interpolation interpolation = Interpolation::Linear;
  std::variant<SteadyStream, StreamProfile> stream;
  PropellerCurves curves;
  PropellerRunSettings run;
  bool operator==(const PropellerBench&) const = default;
};

/// The propellers on the bench, one or two.
std::vector<BenchPropeller> propellersOn(const PropellerBench& bench);
/// The same as a flight takes it.
RotorAerodynamics aerodynamicsOf(const BenchPropeller& propeller);

template <>
struct Describe<BladeElementSpecimen> {
  static void fields(schema::Builder<BladeElementSpecimen>& b);
};
template <>
struct Describe<NoPropeller> {
  static void fields(schema::Builder<NoPropeller>& b);
};
template <>
struct Describe<PropellerSpeedRow> {
  static void fields(schema::Builder<PropellerSpeedRow>& b);
};
template <>
struct Describe<AirSpeedRow> {
  static void fields(schema::Builder<AirSpeedRow>& b);
};
template <>
struct Describe<SteadyStream> {
  static void fields(schema::Builder<SteadyStream>& b);
};
template <>
struct Describe<StreamProfile> {
  static void fields(schema::Builder<StreamProfile>& b);
};
template <>
struct Describe<PropellerCurves> {
  static void fields(schema::Builder<PropellerCurves>& b);
};
template <>
struct Describe<PropellerRunSettings> {
  static void fields(schema::Builder<PropellerRunSettings>& b);
};
template <>
struct Describe<PropellerBench> {
  static void fields(schema::Builder<PropellerBench>& b);
};

}  // namespace rotorbench
