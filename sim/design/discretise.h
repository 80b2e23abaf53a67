// From a continuous model to what a controller of period T sees at its instants k T, and poles from
// one plane to the other.
#pragma once

#include "sim/design/linear_system.h"

namespace rotorbench {

/// exp(A) of a finite n x n matrix: balanced, then scaling and squaring with Padé's approximant of
/// degree 13. Source: Higham, "The scaling and squaring method for the matrix exponential
/// revisited" (2005). Throws an InputError if the result is beyond the range of double.
Eigen::MatrixXd matrixExponential(const Eigen::MatrixXd& A);

/// A^-1 (exp(A t) - I) B, also where A is singular: what inputs held for t (s, not negative) add to
/// the states; and exp(A t). Of the exponential of [A B; 0 0] t. Source: Van Loan, "Computing
/// integrals involving the matrix exponential" (1978).
struct HeldStep {
  Eigen::MatrixXd transition, input;
};
HeldStep heldStep(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double t);

/// The longest input delay that is taken, in periods.
inline constexpr int kMostDelayedPeriods = 1000;

/// The exact model at the instants k T (T = `period` in s, positive) of a system whose inputs are
/// held between them and arrive `inputDelay` (s, not negative, at most kMostDelayedPeriods periods)
/// after their instant. The delay may be any fraction of the period: each input of the past that is
/// still on its way is a state more, ceil(delay / T) of them a channel, behind the plant's states,
/// the oldest first; D acts through the delay too. Delays within 1e-9 T of a whole number of
/// periods count as whole. Source: Åström and Wittenmark, "Computer-Controlled Systems" (1997),
/// section 2.3.
LinearSystem holdSampled(const LinearSystem& continuous, double period, double inputDelay = 0);

/// The bilinear (trapezoidal) model, s = 2/T (z - 1)/(z + 1). The transfer function is what is
/// kept: its state is (I - A T/2) x - B u T/2, not x. Throws an InputError if A has an eigenvalue
/// at 2/T.
LinearSystem tustinSampled(const LinearSystem& continuous, double period);

/// s (1/s) of each pole z of a model of period T (s): log(z) / T, the imaginary part within
/// +-pi / T; minus infinity for z = 0, the pole of a pure delay.
Eigen::VectorXcd continuousPoles(const Eigen::VectorXcd& z, double period);

/// z = exp(s T) of each pole s (1/s).
Eigen::VectorXcd sampledPoles(const Eigen::VectorXcd& s, double period);

}  // namespace rotorbench
