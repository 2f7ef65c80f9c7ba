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
  /// start: of the motion, which may have no sample.
  RoadWatch(const Compilation& compilation, const GenericState& start);

  void add(const Sample& sample) { add(sample.state); }
  /// Adds to the findings about a motion that ended with numbers that are none why they are.
  void judge(const SimulationSummary& summary, StepVerdict& verdict) const;
  /// Which wheel was beyond a border after the last sample, or goes there by twice as far as it came from the
  /// one before; empty where none does.
  std::string departure() const;

 private:
  void add(const GenericState& state);
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

}  // namespace mbgen
