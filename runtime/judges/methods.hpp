#pragma once
// The four formulations as functions of the terms of (5). M is block diagonal, six coordinates per body.

#include <Eigen/Dense>
#include <optional>

#include "runtime/judges/constraint_factors.hpp"
#include "runtime/judges/method.hpp"

namespace mbgen {

/// The equations (5) at one state: M qdd + Phi_q' lambda = F, Phi_q qdd = c.
struct CartesianEquations {
  const Eigen::MatrixXd& mass;       ///< M, n x n, positive semidefinite
  const Eigen::VectorXd& force;      ///< F, n
  const ConstraintFactors& factors;  ///< of Phi_q
  const ReducedBias& bias;           ///< c after elimination
};

struct CartesianSolution {
  Eigen::VectorXd qdd;     ///< n
  Eigen::VectorXd lambda;  ///< m, zero at redundant equations
};

/// Accelerations and multipliers.
/// Requires: rank [M; Phi_q] = n (9), see motion_without_inertia; without it the result is not finite or arbitrary.
/// Cost: augmented (n + r)^3, null_space n^3, range_space n^3 and n r^2, maggi as the elimination of Phi_q.
CartesianSolution solve(CartesianMethod method, const CartesianEquations& equations);

/// A motion allowed by the equations without inertia, n values; nothing if rank [M; Phi_q] = n (9). The magnitude of a
/// motion is the square root of its kinetic energy, relative to the same motion with typical masses instead of zeros:
/// rounding at a dead centre counts as zero, a small body of a heavy vehicle does not.
std::optional<Eigen::VectorXd> motion_without_inertia(const Eigen::MatrixXd& mass, const ConstraintFactors& factors);

/// The correction dq with least dq' M dq and Phi_q dq = c: the mass-orthogonal projections of Bayo and Ledesma, of
/// positions with c = -Phi and of velocities with c = -(Phi_q qd - b). Massless bodies follow the others exactly.
/// Requires: as solve.
Eigen::VectorXd mass_orthogonal_correction(const Eigen::MatrixXd& mass, const ConstraintFactors& factors,
                                           const Eigen::VectorXd& c);

}  // namespace mbgen
