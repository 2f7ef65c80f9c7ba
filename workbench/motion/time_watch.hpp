#pragma once
// Inputs and laws of time that change too fast for the step: what happens between the points of a step, no method sees.

#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"

namespace mbgen {

/// Accelerations over the time of a step, at some hundred steps of a motion: by the time that laws look at, and by each
/// input. A parabola through start, middle and end is what a method can know of them.
class TimeWatch {
 public:
  /// inputs: of the run, null where a manoeuvre moves them.
  TimeWatch(const Compilation& compilation, SolverSettings::Integrator integrator, const SimulationSettings& settings,
            const InputsOverTime* inputs);

  void add(const Sample& sample);
  /// A warning for each input, and for laws of t, that changes too fast.
  std::vector<std::string> warnings() const;

 private:
  /// An argument that moves while the others stand still.
  struct Source {
    int input = -1;                               ///< -1: the time
    std::vector<std::vector<double>> deviations;  ///< per looked at step, per coordinate: from the parabola
  };
  bool look(const Sample& sample, Source& source);

  const Compilation& compilation_;
  SolverSettings::Integrator integrator_;
  SimulationSettings settings_;
  const InputsOverTime* inputs_;
  long every_ = 1;  ///< steps from one that is looked at to the next
  GenericSolver solver_;
  std::vector<Source> sources_;
  std::vector<double> smallest_, largest_;  ///< accelerations that were met, per coordinate
};

}  // namespace mbgen
