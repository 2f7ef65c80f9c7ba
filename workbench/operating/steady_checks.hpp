#pragma once
// Checks that a motion is steady and unique.

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "compiler/linearisation/bristles.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

constexpr double kSteady = 1e-7;  ///< rad/s^2 or m/s^2; for auxiliary states 1/s, relative to their magnitudes

/// Norms of columns, at least 1e-12, as scales: inputs have different units.
Eigen::VectorXd column_sizes(const Eigen::MatrixXd& matrix);

/// Linear equations whose columns have one size, and if asked their rows too: accelerations of stiff parts, as in
/// beams, would hide others; rounding of light parts would count as much as all the rest.
class ScaledSystem {
 public:
  ScaledSystem(const Eigen::MatrixXd& matrix, bool scales_rows);
  /// Of all scaled unknowns that meet the right-hand side best the smallest.
  Eigen::VectorXd correction(const Eigen::VectorXd& wanted) const;
  /// In their own units.
  Eigen::VectorXd unknowns(const Eigen::VectorXd& scaled) const { return scaled.cwiseQuotient(size_); }

 private:
  Eigen::VectorXd size_, weight_;
  Eigen::MatrixXd matrix_;
};

/// Whether the forces behind remaining accelerations are rounding errors: below 1e-8 of the model's weight, or of its
/// mass times 1 m/s^2 without gravity, at a lever of 1 m. left: accelerations of the independent coordinates, then
/// rates of auxiliary states relative to their magnitudes.
bool is_weighed_out(const Compilation& compilation, const GenericSolver& solver, const OperatingPoint& point,
                    const Eigen::VectorXd& left);

/// Requires that frictions of parts at rest hold. Fails: UserError that names the one beyond its limit.
void require_holding(const Model& model, const OperatingPoint& point, const std::vector<BristleEnd>& bristles);

/// An unknown of a steady motion that the user may prescribe: a rate or an input.
struct SteadyChoice {
  std::size_t column = 0;
  std::string name;
  bool is_rate = false;
};

/// Null space: directions of unknowns without effect on accelerations, as "zd.car_tx +1, drive +16"; the largest rate
/// is 1, or the largest input if no rate changes. derivatives: of the accelerations, by all unknowns. choices: rates
/// before inputs.
std::vector<std::string> free_directions(const Eigen::MatrixXd& derivatives, const std::vector<SteadyChoice>& choices);

/// The acceleration that arises along a motion where forces depend on the coordinates that move, in words; empty for a
/// steady motion. system: at the point, in the fixed frame; turning, across: see SteadyMotion.
std::string changes_along(const Compilation& compilation, const LinearSystem& system, const OperatingPoint& point,
                          double turning, const int (&across)[2]);

}  // namespace mbgen
