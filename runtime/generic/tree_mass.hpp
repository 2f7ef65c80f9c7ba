#pragma once
// Mass matrix of the opened tree (49), as the list of its entries: the pattern of the path matrix.

#include <vector>

#include "compiler/formulation/formulation.hpp"

namespace mbgen {

/// Lower triangle of M: the entries that can differ from zero, in a fixed order.
struct TreeMass {
  std::vector<int> row, column;  ///< column <= row
  std::vector<double> value;
  std::vector<bool> all_with_all;  ///< per joint group: every joint is coupled with every other one of it
};

/// Rows and columns, values zero. Joints of a loop block with a rod that has mass are taken as coupled all with all: it
/// joins branches.
TreeMass tree_mass_pattern(const Model& model, const Topology& topology);

/// Fills in the values of a pattern of the same topology, which is made where there is none yet, rods' couplings
/// included. Cost: entries of the pattern.
void tree_mass_matrix(System<double>& system, const Kinematics<double>& kinematics, const Inertias<double>& inertias,
                      TreeMass& mass);

}  // namespace mbgen
