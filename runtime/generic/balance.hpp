#pragma once
// Forces of a model at rest along its free directions, and how they change: for the searches of an equilibrium.

#include <Eigen/Core>
#include <vector>

#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

/// Static forces of the free directions at a position that satisfies the closures; frozen partition. States of the
/// user's own have to stand still, too.
struct Balance {
  Eigen::VectorXd force;    ///< Rz' (tree forces at rest), then rates of the states over their magnitudes, 1/s
  Eigen::VectorXd inertia;  ///< diagonal of Rz' M Rz
  Eigen::MatrixXd rz;       ///< coordinates x free directions
};

Balance balance(GenericEquations& equations, const GenericState& state);

/// Closed, with driven coordinates at their motions, and at rest although those may have velocities.
Status brought_to_rest(const GenericSolver& solver, GenericState& state);

/// Unknowns of a search: the free directions, then the auxiliary states that move, in parts of their magnitudes.
Eigen::Index unknowns_of(const GenericEquations& equations, const Balance& b);

/// The state moved along the unknowns and brought to rest again.
Status moved(const GenericSolver& solver, const GenericEquations& equations, const GenericState& state,
             const Balance& b, const Eigen::VectorXd& change, GenericState& result);

/// Auxiliary states that stay where they are, in model order: turns, and bristles that do not hold.
using Pinned = std::vector<bool>;

/// d force / d unknowns along the closures by differentiation of the equations; columns of pinned states are zero.
/// Entries are not finite where a law has no slope.
Eigen::MatrixXd stiffness_by_slopes(GenericEquations& equations, const GenericState& state, const Balance& b,
                                    const Pinned& pinned);

/// The same by central differences. Fails: as moved.
Status stiffness_by_differences(const GenericSolver& solver, GenericEquations& equations, const GenericState& state,
                                const Balance& b, const Pinned& pinned, Eigen::MatrixXd& stiffness);

/// The same by slopes, by differences where a law has none. Fails: as moved.
Status stiffness_at(const GenericSolver& solver, GenericEquations& equations, const GenericState& state,
                    const Balance& b, const Pinned& pinned, Eigen::MatrixXd& stiffness);

/// Inertias of the free directions; a small one in place of none where a direction moves no mass.
Eigen::VectorXd effective_inertia(const Balance& b);

/// Largest acceleration of a coordinate that the forces would cause if every free direction moved alone.
double unbalanced_acceleration(const Balance& b);

}  // namespace mbgen
