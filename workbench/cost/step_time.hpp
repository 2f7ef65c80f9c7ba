#pragma once
// Time of one step on this machine, and of the sections that it consists of.

#include <string>
#include <vector>

#include "compiler/compile.hpp"

namespace mbgen {

/// A section of a step.
struct SectionTime {
  std::string title;
  double microseconds = 0;
};

/// Steps of the model's integrator and step size from its initial state on, at its default inputs.
struct StepTime {
  const char* integrator = "";
  double h = 0;         ///< s
  int steps = 0;        ///< of the motion that was measured
  double median = 0;    ///< microseconds, over the steps
  double slowest = 0;   ///< microseconds of the step that takes longest when nothing disturbs it: see measure_step
  int evaluations = 0;  ///< of the accelerations in a step
  std::vector<SectionTime> sections;  ///< of the median step, microseconds each
};

/// Compiles the solver and times it. The same motion is computed several times, and of each step the shortest time
/// counts: this excludes the time of interrupts and other programs, but not the step's own extra time.
/// Fails: UserError without a compiler, when the initial state does not close, or when the first step fails.
StepTime measure_step(const Compilation& compilation);

/// The section that takes most of a step.
const SectionTime& leading_section(const StepTime& time);

}  // namespace mbgen
