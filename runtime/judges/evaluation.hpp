#pragma once
// The terms of (5) at one state, factored, and their faults as a status.

#include <optional>
#include <vector>

#include "compiler/topology/topology.hpp"
#include "mbgen/status.hpp"
#include "runtime/judges/constraint_factors.hpp"
#include "runtime/judges/system.hpp"

namespace mbgen {

/// The mechanism, as the solver's parts see it.
struct Mechanics {
  const CartesianSystem& system;
  const Topology& topology;
};

/// The state of a mechanism: its bodies where they are, and the tree coordinates that belong to them.
struct PlacedState {
  CartesianState bodies;
  GenericState z;
};

/// Terms of (5) with Phi_q factored.
struct Evaluation {
  CartesianTerms terms;
  std::optional<ConstraintFactors> factors;
};

/// Terms and factors of a configuration.
/// equations: those that a closed configuration nearby kept, none when that is to be found out here. A pivot then
/// counts as zero when the open closures alone could make it of a zero, else redundant equations would gain rank by
/// what is left of them. Fails: no_inertia when (9) does not hold, with the coordinate that moves most in the motion
/// without inertia, the lowest of equals.
Status evaluate(const Mechanics& mechanics, const PlacedState& at, const std::vector<double>& tau,
                const std::vector<int>& equations, Evaluation& evaluation);

/// Fails: loop_singular when redundant equations contradict (14) by more than the open closures explain, with the loop
/// block that has the largest part in it.
Status check_compatibility(const Mechanics& mechanics, const Evaluation& evaluation, const ReducedBias& bias);

/// Loop block with the largest share in weights of all equations, -1 when they are zero in all loops.
int block_of(const Mechanics& mechanics, const Eigen::VectorXd& weights);

/// Moves the bodies to where the equations hold within `tolerance` (m or 1) or as well as rounding lets them, then
/// corrects their velocities, both mass-orthogonally; the coordinates follow. Fails: loop_not_closed, no_inertia,
/// not_a_number; the configuration is then arbitrary. Source: Bayo, Ledesma, "Augmented Lagrangian and mass-orthogonal
/// projection methods for constrained multibody dynamics", 1996.
Status close(const Mechanics& mechanics, double tolerance, PlacedState& configuration);

}  // namespace mbgen
