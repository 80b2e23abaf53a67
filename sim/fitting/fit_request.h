// What a person asks of a fit, described for forms and files: which component, which of its
// parameters, and what the columns mean. SI units.
#pragma once

#include <variant>

#include "sim/core/schema.h"
#include "sim/fitting/motor_fit.h"
#include "sim/fitting/propeller_fit.h"
#include "sim/fitting/rotor_fit.h"

namespace rotorbench {

/// Motor constants (motor_fit.h).
struct MotorFitRequest {
  bool speedConstant = true, resistance = true, noLoadCurrent = true;
  bool viscousShare = false;
  bool torqueCoefficient = true;
  ShaftTorque torque = ShaftTorque::Propeller;
  double torquePerThrust = 0.015;  ///< m
  DutyFrom duty = DutyFrom::Automatic;
  bool operator==(const MotorFitRequest&) const = default;
};

/// Twist offset and drag of a propeller (propeller_fit.h).
struct PropellerFitRequest {
  bool twistOffset = true, drag = false;
  double speed = 0;           ///< rad/s where the table has none
  double airDensity = 1.225;  ///< kg/m^3
  bool operator==(const PropellerFitRequest&) const = default;
};

/// Lumped coefficients (rotor_fit.h).
struct RotorFitRequest {
  bool thrust = true, torque = true;
  int rotors = 1;
  double airDensity = 1.225;  ///< kg/m^3 in which was measured
  bool operator==(const RotorFitRequest&) const = default;
};

/// Rows of a motor fit in which the current limit holds the motor back (motor_fit.h).
struct LimitedRows {
  bool leaveOut = false;
  double currentLimit = 0;  ///< A, of the motor; 0: that of the experiment
  double nearLimit = 0.9;   ///< part of the limit from which a row counts as limited
  bool operator==(const LimitedRows&) const = default;
};

struct FitRequest {
  std::variant<MotorFitRequest, PropellerFitRequest, RotorFitRequest> what;
  bool robust = false;
  LimitedRows limited;
  bool operator==(const FitRequest&) const = default;
};

/// What the experiment has now: where the fit starts, and what is not fitted.
struct FitStart {
  MotorParameters motor;
  double escResistance = 0;            ///< Ohm
  double currentLimit = 0;             ///< A, of the motor current; 0: not known
  double torqueCoefficient = 1e-7;     ///< k_m, N m s^2
  double thrustCoefficient = 1e-5;     ///< k_f, N s^2
  bool coefficientsAreGuesses = true;  ///< k_m and k_f are not of the experiment
  PropellerGeometry propeller;
  BladeElementSettings settings;
};

MotorFitSetup setupOf(const MotorFitRequest& request, const FitStart& start);
PropellerFitSetup setupOf(const PropellerFitRequest& request, const FitStart& start);
RotorFitSetup setupOf(const RotorFitRequest& request, const FitStart& start);

/// What the table lacks, one sentence each; empty if the fit can be done.
std::vector<std::string> missingFor(const FitRequest& request, const MeasuredTable& table,
                                    const FitStart& start);
/// How many rows a motor fit leaves out at the current limit, or could leave out; empty for other
/// fits, where a limit is not known, and where something is missing.
std::string limitedRowsText(const FitRequest& request, const MeasuredTable& table,
                            const FitStart& start);
/// What a motor fit makes of a throttle that cannot be the duty, where it is asked to decide; else
/// empty.
std::string dutyText(const FitRequest& request, const MeasuredTable& table, const FitStart& start);
/// Throws InputError with those sentences.
FitProblem problemOf(const FitRequest& request, const MeasuredTable& table, const FitStart& start);

template <>
struct Describe<MotorFitRequest> {
  static void fields(schema::Builder<MotorFitRequest>& b);
};
template <>
struct Describe<PropellerFitRequest> {
  static void fields(schema::Builder<PropellerFitRequest>& b);
};
template <>
struct Describe<RotorFitRequest> {
  static void fields(schema::Builder<RotorFitRequest>& b);
};
template <>
struct Describe<LimitedRows> {
  static void fields(schema::Builder<LimitedRows>& b);
};
template <>
struct Describe<FitRequest> {
  static void fields(schema::Builder<FitRequest>& b);
};

}  // namespace rotorbench
