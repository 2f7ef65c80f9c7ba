#pragma once
// Names of the model as C++ identifiers.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Identifiers by model index, unique within each list.
struct SolverNames {
  std::string solver;                    ///< files and namespace
  std::vector<std::string> coordinates;  ///< per tree coordinate
  std::vector<std::string> bodies;       ///< per model body
  std::vector<std::string> inputs;
  std::vector<std::string> parameters;   ///< tunable ones only
  std::vector<std::string> outputs;      ///< beside kinetic_energy, potential_energy, applied_power
  std::vector<std::string> loop_blocks;  ///< first loop of the block
};

/// Members of Outputs that every solver has.
constexpr const char* kEnergyMembers[] = {"kinetic_energy", "potential_energy", "applied_power"};

/// The parameters that solvers take, in the order of the model.
std::vector<Parameter> tunable_parameters(const Model& model);

/// A name as an identifier that is no keyword: letters, digits, single underscores. Not unique.
std::string identifier_base(const std::string& name);

/// The identifier for the second, third, .. use of a base: "crank_2"; "class_2" for "class_".
std::string numbered(const std::string& base, int number);

/// Name of the emitted files and of the namespace: the identifier of the model's name.
std::string solver_name(const Model& model);

/// C++ identifier for a model name: unique within `taken`, no keyword, ASCII. Adds the result to `taken`.
std::string identifier(const std::string& name, std::vector<std::string>& taken);

/// Names that a model alone decides; coordinates and loop_blocks stay empty.
SolverNames model_names(const Model& model);

/// All names.
SolverNames solver_names(const Model& model, const Topology& topology);

/// Loops of a block as people read them: "front_left, front_right".
std::string block_title(const Topology& topology, int block);

}  // namespace mbgen
