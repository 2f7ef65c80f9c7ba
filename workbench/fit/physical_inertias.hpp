#pragma once
// Inertias that stay those of bodies while they are searched. A body's second moments S = tr(J)/2 - J, the integrals of
// r r' dm, are positive semidefinite: then no principal moment exceeds the sum of the others. The search moves the
// Cholesky factor L of S = L L' in place of the entries of J, with a diagonal above zero.
// Source: P. M. Wensing, S. Kim, J.-J. E. Slotine, "Linear Matrix Inequalities for Physically Consistent Inertial
// Parameter Identification", IEEE Robotics and Automation Letters 3(1), 2018.

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "workbench/search/unknowns.hpp"

namespace mbgen::fit {

/// The unknowns that are the entries of a body's inertia.
struct FreeInertia {
  std::string body;
  std::array<int, 6> unknowns;  ///< xx yy zz xy xz yz; the last three -1 where they are zero
  double size = 1;              ///< root of half the trace at the start: unit of the factor's entries, kg^0.5 m
};

/// Least entry of the factor's diagonal, in parts of its size: the moments break the triangle's inequality by 1e-8 less
/// than they may.
constexpr double kLeastOfFactor = 1e-4;

/// The inertias of --free NAME=physical, and the scales of their unknowns. Requires: these are tunable parameters of
/// the model. Fails: UserError for one that belongs to no body all of whose entries are physical unknowns.
std::vector<FreeInertia> free_inertias(const Model& model, std::vector<Unknown>& unknowns);

/// The entries of the factor at entries of the inertia among `values`, in parts of its size, diagonal first:
/// 11 22 33 21 31 32.
std::array<double, 6> factor_of(const FreeInertia& inertia, const std::vector<double>& values);

/// Sets the entries of the inertia among `values`.
void set_inertia(const FreeInertia& inertia, const std::array<double, 6>& factor, std::vector<double>& values);

/// Its unknowns, in the order of the factor's entries.
std::vector<int> columns_of(const FreeInertia& inertia);

/// Derivatives of its unknowns (rows) by the entries of the factor.
Eigen::MatrixXd slopes_of_inertia(const FreeInertia& inertia, const std::array<double, 6>& factor);

/// The inertia that an unknown belongs to, null for none; entry: its place there.
const FreeInertia* inertia_of_unknown(const std::vector<FreeInertia>& inertias, std::size_t unknown,
                                      std::size_t& entry);

/// Whether the data pull an inertia beyond those of bodies.
bool is_at_limit(const FreeInertia& inertia, const std::vector<double>& values);

}  // namespace mbgen::fit
