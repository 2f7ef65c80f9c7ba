#pragma once
// Roads without height beyond their borders: a motion that ends there reports the wheel and the road.

#include <optional>
#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {

/// Wheels on such roads, along a motion.
class RoadWatch {
 public:
  /// start: of the motion, which may have no sample.
  RoadWatch(const Compilation& compilation, const GenericState& start);

  void add(const Sample& sample) { add(sample.state); }
  /// Adds the cause to the findings about a motion that ended with values that are not numbers.
  void judge(const SimulationSummary& summary, StepVerdict& verdict) const;

 private:
  void add(const GenericState& state);
  /// The wheel that was beyond a border at the last sample, or will be after twice its last displacement; empty if
  /// there is none.
  std::string departure() const;
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
