#pragma once
// Tables of expressions whose arguments leave their points, where the model does not say how they go on.

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "workbench/motion/simulation.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {

/// Arguments of such tables along a motion, at some of its samples.
class TableWatch {
 public:
  TableWatch(const Compilation& compilation, const SimulationSettings& settings);

  void add(const Sample& sample);
  /// Warns once for each argument of each table, with the farthest place and its time.
  void judge(const SimulationSummary& summary, StepVerdict& verdict) const;

 private:
  /// An argument, an output of the solver.
  struct Argument {
    std::shared_ptr<const NamedTable> table;
    std::string_view name;  ///< x or y
    double first, last;     ///< of the points
    double beyond = 0;      ///< the farthest distance, in parts of last - first
    double at = 0, t = 0;   ///< there
  };

  long every_;
  std::vector<Argument> arguments_;
  std::optional<GenericSolver> solver_;  ///< where there are arguments
};

}  // namespace mbgen
