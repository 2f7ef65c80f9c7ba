#pragma once
// Bodies that turn far within a step: the method sees too few of the directions in which they act.

#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"

namespace mbgen {

/// Turns of all coordinates within a step. A coordinate whose turn changes no acceleration, as of a wheel that is
/// symmetric about its axis, may turn as it likes: that is tried at states along the motion.
class TurnWatch {
 public:
  /// step: s.
  TurnWatch(const Compilation& compilation, SolverSettings::Integrator integrator, double step);

  void add(const Sample& sample);
  /// A warning for the coordinate that turned farthest, with the first time and a step that would do.
  std::vector<std::string> warnings() const;
  /// s, the longest step that bears the turns; 0 where all are borne.
  double longest_step() const;

 private:
  struct Turn {
    double largest = 0;    ///< rad in a step, while the turn mattered
    double since = 0;      ///< s, when it first was too large
    long seen = 0;         ///< samples with too large a turn
    bool matters = false;  ///< known to change accelerations
  };
  bool matters(std::size_t coordinate, const Sample& sample) const;

  const Compilation& compilation_;
  SolverSettings::Integrator integrator_;
  double step_;
  mutable GenericSolver solver_;  ///< for its inputs
  std::vector<Turn> turns_;       ///< per tree coordinate
};

}  // namespace mbgen
