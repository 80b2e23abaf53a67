// A drive whose propeller is not known, in the steady state: constants fitted to some of its
// measured points, to predict the others. Speed controller as in drive_train.h, an averaged
// converter, its resistance together with the motor's; load torque by the square of the speed:
//   d V = R i + K w,   K i = K I0 + f w + kq w^2,   I = d i + I_s
// d: duty, V and I: voltage and current of the supply, R: winding and switches, I_s: what the
// electronics draw. Of the torques only their share of K can be seen, that is I0, f/K and kq/K. SI
// units.
#pragma once

#include <cstddef>
#include <vector>

namespace rotorbench::validation {

/// One measured steady point.
struct LoggedPoint {
  double duty = 0;     ///< 0..1
  double voltage = 0;  ///< V at the supply
  double current = 0;  ///< A from the supply
  double speed = 0;    ///< rad/s
  double thrust = 0;   ///< N; 0 where not measured
};

struct DriveConstants {
  double torqueConstant = 0;  ///< K, V s/rad
  double resistance = 0;      ///< R, Ohm
  double noLoadCurrent = 0;   ///< I0, A
  double viscousCurrent = 0;  ///< f/K, A s/rad
  double loadCurrent = 0;     ///< kq/K, A s^2/rad^2
  double standbyCurrent = 0;  ///< I_s, A
  double dutyGain = 1;        ///< of the duty that is commanded
  double dutyOffset = 0;      ///< added to it
};

/// Which of the constants are fitted beside K, R, I0 and kq/K.
struct DriveFitChoice {
  bool viscous = false;
  bool standby = false;
  bool throttleCurve = false;  ///< gain and offset of the duty
};

struct DrivePrediction {
  double speed = 0;    ///< rad/s
  double current = 0;  ///< A from the supply
};

/// The steady state at a commanded duty and a supply voltage.
DrivePrediction predicted(const DriveConstants& constants, double duty, double voltage);

/// Least squares of speed and current, each over its measured value with `floor` of the greatest
/// one added (solveLeastSquares()). `guess` for the start. Throws InputError where there are fewer
/// numbers measured than constants, or the fit finds no end.
DriveConstants fitDrive(const std::vector<LoggedPoint>& points, const DriveFitChoice& choice,
                        const DriveConstants& guess, double floor = 0.02);

}  // namespace rotorbench::validation
