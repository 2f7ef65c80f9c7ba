#pragma once
// Names of the columns of a loop block's equations.

#include <string>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Names of the columns of a block.
struct ColumnNames {
  const Topology& topology;
  const std::vector<int>& joints;                    ///< of the columns
  const std::vector<std::string>* others = nullptr;  ///< per tree joint, in place of the coordinates; empty: none
  const std::string& operator()(std::size_t column) const {
    const auto joint = static_cast<std::size_t>(joints[column]);
    return others != nullptr && !others->empty() ? (*others)[joint] : topology.bodies[joint].coordinate;
  }
};

}  // namespace mbgen
