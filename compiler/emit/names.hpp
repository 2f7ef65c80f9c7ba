#pragma once
// Names of the model as C++ identifiers.

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
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
  std::vector<std::string> parameters;  ///< tunable ones only
  std::vector<std::string> outputs;     ///< beside kinetic_energy, potential_energy, applied_power
  std::vector<std::string> actuators;
  std::vector<std::string> loop_blocks;  ///< first loop of the block
};

/// Members of Outputs that every solver has.
constexpr const char* kEnergyMembers[] = {"kinetic_energy", "potential_energy", "applied_power"};

/// The parameters that solvers take, in the order of the model.
std::vector<Parameter> tunable_parameters(const Model& model);

/// A name as an identifier that is no keyword: letters, digits, single underscores. Not unique.
std::string identifier_base(const std::string& name);

/// Whether a name is reserved: keywords, names of emitted code, and names that are or may be macros, such as every
/// UPPER_CASE name with an underscore.
bool is_reserved(std::string_view name);

/// Further names that the solver's namespace and build target cannot have: `main`, functions and types that C headers
/// declare in the global namespace, targets that CMake reserves.
bool is_reserved_for_solvers(std::string_view name);

/// Gives every name only once.
class UniqueNames {
 public:
  /// Reserves a name. Result: whether it was free.
  bool reserve(const std::string& name) { return taken_.insert(name).second; }
  /// `base`, or `base` with a number: "crank_2"; "class_2" for "class_".
  std::string unique(const std::string& base);
  /// The same of identifier_base.
  std::string identifier(const std::string& name) { return unique(identifier_base(name)); }

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_number_;  ///< by base
};

/// Name of the emitted files and of the namespace: the identifier of the model's name.
std::string solver_name(const Model& model);

/// Names that depend on the model alone; coordinates and loop_blocks remain empty.
SolverNames model_names(const Model& model);

/// All names.
SolverNames solver_names(const Model& model, const Topology& topology);

}  // namespace mbgen
