#pragma once
// Jumps of laws along a motion with derivatives: the instant of a jump moves with the parameters, and derivatives of
// steps do not know it.

#include <optional>
#include <string>
#include <vector>

#include "workbench/motion/corners.hpp"
#include "workbench/motion/simulation.hpp"

namespace mbgen {

/// Finds the first jump of the rates whose instant follows from the state or from these parameters.
class JumpWatch {
 public:
  /// Requires: the parameters are tunable.
  JumpWatch(const Compilation& compilation, const std::vector<std::string>& parameters);

  void add(const Sample& sample);
  /// Empty where no law jumped.
  std::string warning() const;

 private:
  /// Whether the accelerations jump where this condition changes its sign between both samples.
  bool jumps(std::size_t corner, const Sample& sample);

  const Compilation& compilation_;
  Corners corners_;
  std::vector<std::size_t> watched_;
  std::optional<GenericState> last_;
  std::vector<double> conditions_;  ///< at the last sample
  std::optional<double> first_;     ///< s, of the jump
  std::string coordinate_;          ///< that jumps
};

}  // namespace mbgen
