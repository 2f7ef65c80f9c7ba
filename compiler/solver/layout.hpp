#pragma once
// Sizes of a solver: the size of each array of its programs, and the share of each loop block.

#include <initializer_list>
#include <optional>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/program/program.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Sizes and places of one loop block in the flat arrays of the solver; see BlockLayout of mbgen/solver.hpp.
struct BlockPlaces {
  int equations = 0, coordinates = 0, rank = 0, free = 0;
  int first_equation = 0, first_coordinate = 0, first_jacobian = 0, first_projection = 0;
};

struct SolverLayout {
  int coordinates = 0, auxiliary_states = 0, equations = 0, drives = 0;
  int inputs = 0, parameters = 0, outputs = 0;  ///< of the model; the tunable parameters only
  int free_directions = 0;
  int actuators = 0;  ///< with inverse dynamics
  int actuated_directions = 0;
  bool maps_actuators = false;    ///< functions from motors to joints and back, see maps_actuators
  bool pivots_actuators = false;  ///< inverse dynamics may choose other pivots at run time
  int balls = 0;                  ///< with charts
  int own_states = 0;             ///< auxiliary states of the user's own
  int sampled = 0, held = 0;      ///< sampled values; the last auxiliary states, which these are and wait in
  int grounds = 0;                ///< wheels on ground of a host
  int holds = 0;                  ///< see hold_names
  int block_coordinates = 0, jacobian_entries = 0, projection_entries = 0;
  bool has_closure = false;   ///< loops or motions
  bool chooses_again = true;  ///< another partition at run time; see analysis.hpp
  std::vector<BlockPlaces> blocks;
};

SolverLayout solver_layout(const Model& model, const Topology& topology, const Analysis& analysis);

/// Size of an array of a program's spec, over all loop blocks if each has a share. Requires: not `derived`, `tangent`
/// or `seed`, whose sizes depend on the programs.
int size_of(const SolverLayout& layout, Array array);

/// First place and count.
struct ArrayShare {
  int first = 0, size = 0;
};

/// Share of a loop block in a flat array; none for an array without shares.
std::optional<ArrayShare> share_of(const BlockPlaces& block, Array array);

/// A direction that contains these arrays one after another.
std::vector<DirectionGroup> direction_of(const SolverLayout& layout, std::initializer_list<Array> arrays);

}  // namespace mbgen
