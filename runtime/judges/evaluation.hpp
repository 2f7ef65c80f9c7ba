#pragma once
// The terms of (5) at one state, factored, with faults as a status.

#include <optional>
#include <vector>

#include "compiler/topology/topology.hpp"
#include "mbgen/status.hpp"
#include "runtime/judges/constraint_factors.hpp"
#include "runtime/judges/system.hpp"

namespace mbgen {

/// The mechanism, common to the parts of the solver.
struct Mechanics {
  const CartesianSystem& system;
  const Topology& topology;
};

/// State of a mechanism: positioned bodies, and the corresponding tree coordinates.
struct PlacedState {
  CartesianState bodies;
  GenericState z;
};

/// Terms of (5) with Phi_q factored.
struct Evaluation {
  CartesianTerms terms;
  std::optional<ConstraintFactors> factors;
};

/// Terms and factors of a configuration. equations: those kept at a closed configuration nearby, none to determine them
/// here. In this case a pivot counts as zero if it may result from open closures alone; otherwise redundant equations
/// would add rank by their residuals. Fails: no_inertia if (9) is violated, with the coordinate that moves most in the
/// motion without inertia, the lowest of equals.
Status evaluate(const Mechanics& mechanics, const PlacedState& at, const std::vector<double>& tau,
                const std::vector<int>& equations, Evaluation& evaluation);

/// Fails: loop_singular if redundant equations contradict (14) by more than the open closures explain, with the loop
/// block that has the largest part in it.
Status check_compatibility(const Mechanics& mechanics, const Evaluation& evaluation, const ReducedBias& bias);

/// Loop block with the largest weights of equations, -1 if they are zero in all loops.
int block_of(const Mechanics& mechanics, const Eigen::VectorXd& weights);

/// Projects the bodies' positions onto the constraints, within `tolerance` (m or 1) or as far as rounding permits, then
/// their velocities, both mass-orthogonally; the coordinates follow. Fails: loop_not_closed, no_inertia, not_a_number;
/// the configuration is then arbitrary. Source: Bayo, Ledesma, "Augmented Lagrangian and mass-orthogonal projection
/// methods for constrained multibody dynamics", 1996.
Status close(const Mechanics& mechanics, double tolerance, PlacedState& configuration);

}  // namespace mbgen
