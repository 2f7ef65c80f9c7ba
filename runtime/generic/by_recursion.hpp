#pragma once
// Accelerations by the recursive form, for models of many free directions: no matrix of them is made.

#include "runtime/generic/equations.hpp"

namespace mbgen {

/// Accelerations and rates of a state by the recursive form, each block projected over the coordinates that full
/// pivoting chooses there. Fails: as GenericSolver::accelerations.
/// Cost: linear in bodies, cubic in the equations of one block.
Status accelerations_by_recursion(GenericEquations& equations, const GenericState& state,
                                  const std::vector<double>& tau, GenericDerivative& derivative);

}  // namespace mbgen
