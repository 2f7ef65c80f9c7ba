#pragma once
// The states that `evaluate` and `bench` read.

#include <string>
#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen {

/// One state of the file, in the order of the model.
struct FileState {
  LoadedState at;
  std::vector<double> inputs;
  std::vector<double> zdd;  ///< accelerations that the file expects, empty when it has none
  /// per coordinate, for inverse dynamics: the same, or of the names under "zdd"; NaN where the file gives none
  std::vector<double> given_zdd = {};
};

struct StatesFile {
  std::vector<std::string> joint_order;  ///< of the file
  std::vector<int> coordinate;           ///< tree coordinate of each name in joint_order
  std::vector<FileState> states;
};

/// Reads {"joint_order": [names], "states": [{"z", "zd", "tau", "x", "t", "inputs", "zdd"}]}. joint_order is any
/// permutation of all coordinates, by default the order of the model; missing zd, tau, x and t are zero, missing inputs
/// as in `default_inputs`; "zdd" may be {name: number} of some coordinates, for inverse
/// dynamics; null represents a number that is not finite; other fields are ignored, unless they are misspelt
/// ones of these. Fails: UserError that names the file, the place and the value.
StatesFile read_states(const std::string& path, const Compilation& compilation,
                       const std::vector<double>& default_inputs);

/// The same from the file's text; path: as messages name it.
StatesFile parse_states(const std::string& text, const std::string& path, const Compilation& compilation,
                        const std::vector<double>& default_inputs);

/// Values in the order of the model, put in the order of the file.
std::vector<double> in_file_order(const StatesFile& file, const std::vector<double>& values);

}  // namespace mbgen
