#pragma once
// Residuals of redundant equations along the freedoms of their block. The rule is in docs/method/redundancy.md.

#include <vector>

#include "compiler/analysis/part.hpp"

namespace mbgen {

/// Residuals of the redundant equations of a block while it moved with its kept equations closed.
struct RedundantResiduals {
  int steps = 0;             ///< finite steps whose kept equations could be closed
  Eigen::VectorXd residual;  ///< per row of the block: the largest, m or 1; zero for kept ones
  Diagnostics problems;      ///< one when a residual is more than rounding
};

/// Moves every block from its closed configurations by a finite step along its freedoms and closes its kept equations
/// alone. kept: local rows per block; blocks without redundant equations stay.
std::vector<RedundantResiduals> redundant_residuals(NumericSystem& numbers, const std::vector<PartView>& views,
                                                    const std::vector<std::vector<int>>& kept,
                                                    const std::vector<std::vector<ClosureEquation>>& equations,
                                                    const std::vector<Configuration>& configurations);

}  // namespace mbgen
