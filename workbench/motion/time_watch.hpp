#pragma once
// Inputs and laws of time that change too fast for the step: a method does not see changes between its points.

#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"

namespace mbgen {

/// Accelerations over the time of a step, at some hundred steps of a motion, with respect to the time in laws and to
/// each input. A method can resolve no more than a parabola through start, middle and end.
class TimeWatch {
 public:
  /// engine: of the motion, in relative coordinates; inputs: of the run, null where a manoeuvre moves them.
  TimeWatch(const Compilation& compilation, Engine engine, SolverSettings::Integrator integrator,
            const SimulationSettings& settings, const InputsOverTime* inputs);

  /// Requires: the engine has the inputs of the sample.
  void add(const Sample& sample);
  /// A warning for each input, and for laws of t, that changes too fast.
  std::vector<std::string> warnings() const;

 private:
  /// An argument that changes while the others are constant.
  struct Source {
    int input = -1;                               ///< -1: the time
    std::vector<std::vector<double>> deviations;  ///< per looked at step, per coordinate: from the parabola
  };
  void look(const Sample& sample, Source& source);

  const Compilation& compilation_;
  SolverSettings::Integrator integrator_;
  SimulationSettings settings_;
  const InputsOverTime* inputs_;
  long every_ = 1;  ///< steps from one that is looked at to the next
  Engine engine_;
  std::vector<Source> sources_;
  std::vector<double> smallest_, largest_;  ///< accelerations that were met, per coordinate
};

}  // namespace mbgen
