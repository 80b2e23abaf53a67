// A linear model in state space, and what can be told of it before a controller is designed.
// Continuous: x' = A x + B u, y = C x + D u. Sampled: x(k+1) = A x(k) + B u(k), y likewise.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace rotorbench {

/// n states, m inputs, p outputs: A n x n, B n x m, C p x n, D p x m. Units are those of the named
/// quantities, A and B per second where time is continuous. Names may be empty; where there are
/// any, there is one for each.
struct LinearSystem {
  Eigen::MatrixXd A, B, C, D;
  std::vector<std::string> states, inputs, outputs;
};

/// Throws an InputError if the shapes or the numbers of names disagree or an entry is not finite.
void checkSystem(const LinearSystem& system);

/// The system x' = A x + B u of which all states are outputs. Throws as checkSystem does.
LinearSystem stateSystem(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// Eigenvalues of A (n x n, finite), in its unit, from left to right; of a pair the one above the
/// real axis first. The states' units do not matter: A is balanced before.
Eigen::VectorXcd poles(const Eigen::MatrixXd& A);

/// A matrix and how many of its columns are independent.
struct RankReport {
  Eigen::MatrixXd matrix;          ///< in the units of the system
  Eigen::VectorXd singularValues;  ///< of the matrix with states and time in units that suit them
  double tolerance = 0;            ///< singular values above count; so many times the largest
  Eigen::Index rank = 0;
};

/// Kalman's controllability matrix S = [B, AB, ..., A^(n-1) B], n x n m. Source: Kalman,
/// "Contributions to the theory of optimal control" (1960). Powers of A with fast poles hide slow
/// ones, so the rank is taken with states balanced, time in units of 1 / |A| and rows and columns
/// of like length, none of which changes it in exact arithmetic; tolerance 1e-11 of the largest
/// singular value. Where it is less than n, uncontrollableModes says why.
RankReport controllability(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// The observability matrix [C; CA; ...; C A^(n-1)], n p x n, as above.
RankReport observability(const Eigen::MatrixXd& A, const Eigen::MatrixXd& C);

/// Eigenvalues of the part of A that no input reaches, empty if the pair is controllable. By
/// orthogonal staircase reduction, which needs no power of A: the decision that counts. Source:
/// Paige, "Properties of numerical algorithms related to computing controllability" (1981). A
/// coupling of the balanced, scaled pair counts above 1e-11; entries of A and B below 4 eps of the
/// largest in their column are zero, as cos(pi/2) of an arm should be.
Eigen::VectorXcd uncontrollableModes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// The eigenvalues of the part of A that no output shows.
Eigen::VectorXcd unobservableModes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& C);

/// One input and what it moves: an axis of a vehicle, if the input is the moment about it.
struct AxisControllability {
  Eigen::Index input = 0;
  std::vector<Eigen::Index> states;  ///< those the input reaches over entries that are not zero
  RankReport kalman;                 ///< S of these states and this input
  Eigen::VectorXcd stuck;            ///< modes among these states that it cannot move

  [[nodiscard]] bool controllable() const { return !states.empty() && stuck.size() == 0; }
};

/// For each input alone. Throws as checkSystem does.
std::vector<AxisControllability> controllabilityByInput(const LinearSystem& system);

}  // namespace rotorbench
