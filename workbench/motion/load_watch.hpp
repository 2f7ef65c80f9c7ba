#pragma once
// Loads that press frictions are delayed by a period: a motion reports a load that jumps by more than this allows.

#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {

/// Changes of the reaction loads along a motion, from one row to the next.
class LoadWatch {
 public:
  explicit LoadWatch(const Model& model);

  void add(const Sample& sample);
  /// Adds a warning for each load that jumped to the findings about a motion, with the time and size of its largest
  /// jump.
  void judge(const SimulationSummary& summary, StepVerdict& verdict) const;

 private:
  struct Load {
    const SampledValue* value;
    std::size_t place;           ///< among the auxiliary states
    double last = 0, scale = 0;  ///< N or N m: of the last row, the largest
    double jump = 0, time = 0;   ///< the largest from row to row, and s, the time of the row after it
    long rows = 0;
  };
  std::vector<Load> loads_;
};

/// Largest change of a load within a period without a warning, in parts of its largest value.
constexpr double kLoadJump = 0.1;

}  // namespace mbgen
