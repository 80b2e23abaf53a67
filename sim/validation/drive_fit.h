// A drive on a stand in the steady state, by the drive train that flies (drive_train.h): constants
// fitted to some of its measured points, to predict the others. The converter's resistance counts
// with the motor's. Where the propeller is not known its load goes with the square of the speed,
// and of the torques only their share of K can be seen:
//   K i = K I0 + f w + kq w^2:   I0, f/K and kq/K
// The ammeter reads I_s more than the drive takes. SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/propulsion/drive/drive_train.h"

namespace rotorbench::validation {

/// One measured steady point.
struct LoggedPoint {
  double throttle = 0;  ///< 0..1
  double voltage = 0;   ///< V at the supply
  double current = 0;   ///< A from the supply
  double speed = 0;     ///< rad/s
  double thrust = 0;    ///< N; 0 where not measured
};

struct DriveConstants {
  double torqueConstant = 0;  ///< K, V s/rad
  double resistance = 0;      ///< R, Ohm
  double noLoadCurrent = 0;   ///< I0, A
  double viscousCurrent = 0;  ///< f/K, A s/rad
  double loadCurrent = 0;     ///< kq/K, A s^2/rad^2; not used where there is a load
  double standbyCurrent = 0;  ///< I_s, A
  double throttleStart = 0;   ///< of no duty
  double throttleFull = 1;    ///< of full duty
  double ripple = 0;          ///< 1/(L f), A/V; 0: none
  double switchingLoss = 0;   ///< k_s
  bool activeBraking = true;
  std::optional<ShaftLoad> load;  ///< a propeller that is known
};

/// Which of the constants are fitted.
struct DriveFitChoice {
  bool motor = true;  ///< K, I0 and kq/K; R always is
  bool viscous = false;
  bool standby = false;
  bool throttleLine = false;  ///< its two ends
  bool chopping = false;      ///< ripple and switching loss
};

struct DrivePrediction {
  double speed = 0;    ///< rad/s
  double current = 0;  ///< A from the supply
  double thrust = 0;   ///< N, of a load that is known
};

struct DriveFit {
  DriveConstants constants;
  std::string atBound;  ///< names of those that the points push against a bound
};

/// The drive train of the constants on a supply of that voltage in V.
DriveTrain driveTrain(const DriveConstants& constants, double voltage);

/// The steady state at a throttle and a supply voltage.
DrivePrediction predicted(const DriveConstants& constants, double throttle, double voltage);

/// Least squares of speed and current, each over its measured value with `floor` of the greatest
/// one added (solveLeastSquares()). `guess` for the start and for what is not fitted. Throws
/// InputError where there are fewer numbers measured than constants, or the fit finds no end.
DriveFit fitDrive(const std::vector<LoggedPoint>& points, const DriveFitChoice& choice,
                  const DriveConstants& guess, double floor = 0.02);

}  // namespace rotorbench::validation
