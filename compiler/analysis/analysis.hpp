#pragma once
// The door of the analysis room: decisions that need numbers, offline, over many closed configurations.

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// About the operations of the two forms of the equations of motion, from below, where one of their parts grows
/// faster than the model: the elimination of the free directions along a tree, and the directions of one large block.
struct LeastOperations {
  double matrix = 0, recursive = 0;
};
LeastOperations least_operations(const Topology& topology, const Analysis& analysis);

/// A form that takes so many operations more than the other one is not written: a chain of 74 joints in the matrix
/// form.
constexpr double kMostMoreOfAForm = 131072;
inline bool is_worth_writing(double least_of_form, double least_of_other) {
  return least_of_form <= least_of_other + kMostMoreOfAForm;
}

/// Whether every block of a mechanism gets another partition at run time.
inline bool chooses_again(const Topology& topology) {
  return std::all_of(topology.blocks.begin(), topology.blocks.end(),
                     [](const LoopBlock& block) { return chooses_again(block); });
}

/// Which coordinate names which free direction: the independent, undriven coordinates, group by group.
std::vector<int> free_coordinates(const Topology& topology, const Analysis& analysis);

/// The same for the directions that actuators move in inverse dynamics: with the coordinates of motions that actuators
/// give. Requires: the model has actuators.
std::vector<int> actuated_coordinates(const Topology& topology, const Analysis& analysis);

/// Whether the actuators of a model move all of these directions, so that inverse dynamics has a solution.
bool has_inverse_dynamics(const Model& model, const Topology& topology, const Analysis& analysis);

/// One diagnostic at the first actuator with the free directions that no actuator moves, none for a model without
/// actuators or with inverse dynamics.
Diagnostics unactuated_directions(const Model& model, const Topology& topology, const Analysis& analysis);

/// Per free direction: the actuator that moves it, and the coordinate that names it. Requires: has_inverse_dynamics.
std::vector<std::string> actuated_directions(const Model& model, const Topology& topology, const Analysis& analysis);

/// Decides rank, redundant equations, dependent coordinates and elimination order of each loop block.
/// Fails: a loop that cannot be closed near the reference, redundant equations that contradict (residual and joint
/// named; the rule is in docs/method/redundancy.md), motions that over-constrain a block, a direction of motion without
/// inertia (coordinate named). Source: theory.md sections 3 and 4, (9).
Result<Analysis> analyse(const Model& model, const Topology& topology);

}  // namespace mbgen
