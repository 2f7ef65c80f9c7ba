#pragma once
// The last step of the double-step Maggi solution, dense with every linear algebra before it.

#include <Eigen/Dense>
#include <vector>

#include "runtime/generic/loop_algebra.hpp"

namespace mbgen {

/// Rz of all joint groups as one matrix, coordinates x free directions.
Eigen::MatrixXd dense_rz(const Topology& topology, const std::vector<GroupProjection<double>>& projections);

/// Both triangles of the tree mass matrix, written over the triangles of `whole`, which is square and zero elsewhere.
void spread(const TreeMass& mass, Eigen::MatrixXd& whole);

/// Solves Rz' M Rz free = Rz' q (63) by LDL' with pivoting, scaled to a unit diagonal. Result: a direction that has no
/// inertia (free is then left alone), or -1.
int solve_free(const ReducedEquations& reduced, Eigen::VectorXd& free);

}  // namespace mbgen
