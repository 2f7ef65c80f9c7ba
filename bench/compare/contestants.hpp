#pragma once
// Who takes part in the comparison: mbgen's engines and other people's, behind one interface.

#include <string>
#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen::compare {

/// Instances in one batch of the row `batch8`.
inline constexpr int kLanes = 8;

/// An engine with what a reader of its figures must know.
struct Contestant {
  /// For machines: generated, batch8, other_form, generic, straightforward, straightforward_blocks, simbody, mujoco.
  std::string key;
  std::string name;    ///< for tables
  std::string remark;  ///< "" when there is nothing to say
  std::string absent;  ///< why there is no engine; "" when there is one
  bool exact = true;   ///< solves the equations of motion, and not something near them
  Engine engine;       ///< name, accelerations and time_accelerations are set
};

/// Everybody, mbgen's generated solver first. Fails: UserError when the generated code cannot be compiled.
std::vector<Contestant> contestants(const Compilation& compilation);

}  // namespace mbgen::compare
