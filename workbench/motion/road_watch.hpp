#pragma once
// Roads that have no height beyond their borders: a motion that ends there says which wheel left which road.

#include <optional>
#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {

/// Wheels that stand on such roads, along a motion.
class RoadWatch {
 public:
  explicit RoadWatch(const Compilation& compilation);

  void add(const GenericState& state);
  /// Which wheel was beyond a border after the last sample, or goes there by twice as far as it came from the
  /// one before; empty where none does.
  std::string departure() const;

 private:
  struct Wheel {
    const Tyre* tyre;
    const RoadGrid* grid;
    Vector3 last{}, before{};  ///< m, global, of its centre at the last two samples
  };

  const Compilation& compilation_;
  std::optional<GenericSolver> solver_;  ///< for poses, where there are wheels
  std::vector<Wheel> wheels_;
  long samples_ = 0;
};

/// Adds to the findings about a motion that ended with numbers that are none why they are.
void judge_roads(const RoadWatch& roads, const SimulationSummary& summary, StepVerdict& verdict);

}  // namespace mbgen
