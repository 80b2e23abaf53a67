// The lumped coefficients of a rotor at rest in the air from a stand: T = k_f w^2, Q = k_m w^2. SI
// units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/fitting/least_squares.h"
#include "sim/logs/measured_table.h"

namespace rotorbench {

struct RotorFitSetup {
  double thrustStart = 1e-5;      ///< k_f, N s^2, above 0
  double torqueStart = 1e-7;      ///< k_m, N m s^2, above 0
  bool startsAreGuesses = false;  ///< nobody gave them
  bool fitThrust = true, fitTorque = true;
  int rotors = 1;  ///< the thrust and torque columns are the sum of so many
};

std::vector<std::string> missingForRotorFit(const MeasuredTable& table, const RotorFitSetup& setup);
/// Throws InputError with those sentences. Keys of the parameters: "thrust" and "torque".
FitProblem rotorFitProblem(const MeasuredTable& table, const RotorFitSetup& setup);

/// CT of k_f and CP of k_m: k_f = CT rho D^4/(2 pi)^2, k_m = CP rho D^5/(2 pi)^3. Density in
/// kg/m^3, diameter in m.
double thrustCoefficientOf(double kf, double density, double diameter);
double powerCoefficientOf(double km, double density, double diameter);

}  // namespace rotorbench
