#pragma once
// Names for people: of methods, bodies, coordinates and programs.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/topology/topology.hpp"
#include "compiler/trace/trace.hpp"
#include "runtime/cartesian/cartesian.hpp"

namespace mbgen {

const char* name_of(SolverSettings::Integrator integrator);
const char* name_of(Stabilisation stabilisation);

/// Name of a tree body, "ground" for kGround.
std::string body_name(const Topology& topology, int body);

/// Names of the coordinates of these tree joints.
std::vector<std::string> coordinate_names(const Topology& topology, const std::vector<int>& joints);

/// Names of all coordinates, in the order of the tree.
std::vector<std::string> coordinate_names(const Topology& topology);

/// Names of the coordinates of these local columns of a block.
std::vector<std::string> local_names(const Topology& topology, const LoopBlock& block, const std::vector<int>& columns);

}  // namespace mbgen
