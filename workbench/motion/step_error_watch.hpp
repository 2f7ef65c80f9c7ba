#pragma once
// Error of linearly implicit steps along a motion, by two half steps in place of one. A fast part with a stiff
// direction that turns in the coordinates (a rod that rotates) errs by much more than the order of the method says, and
// has little energy in the balance of a heavy model.

#include <optional>
#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {

/// Errors of the rates of coordinates, at some steps of a motion.
class StepErrorWatch {
 public:
  /// engine: of the motion, in whose place the generic one is taken where it follows the motion; inputs: of the run,
  /// null where a manoeuvre moves them, which is not watched; nor are other integrators.
  StepErrorWatch(const Compilation& compilation, const Engine& engine, SolverSettings::Integrator integrator,
                 const SimulationSettings& settings, const InputsOverTime* inputs);

  void add(const Sample& sample);
  /// Warns of the coordinate whose rate may be off most, where that is more than kRateError and nothing else is told.
  void judge(const SimulationSummary& summary, StepVerdict& verdict) const;

 private:
  bool step(GenericState& state, double length, double end);

  const Compilation& compilation_;
  SimulationSettings settings_;
  const InputsOverTime* inputs_;
  long every_ = 1;  ///< steps from one that is looked at to the next
  std::optional<Engine> engine_;
  std::optional<GenericState> halved_;  ///< a motion with two half steps in place of one, beside the sample
  long since_ = 0;                      ///< steps since then
  long looks_ = 0;
  std::vector<double> errors_;  ///< per coordinate: sum over looks of |error of the rate|, rad/s or m/s
  std::vector<double> rates_;   ///< per coordinate: the largest
};

/// Largest error of a rate over a motion without a warning, in parts of its largest value: all errors of steps in one
/// sense.
constexpr double kRateError = 0.01;

}  // namespace mbgen
