#pragma once
// Bodies that turn far within a step: the method resolves too few directions of their forces.

#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"

namespace mbgen {

/// Rotations of all coordinates within a step. A rotation that changes no acceleration, like the spin of an
/// axisymmetric wheel, is unlimited: this is tested at states along the motion.
class TurnWatch {
 public:
  /// step: s.
  TurnWatch(const Compilation& compilation, SolverSettings::Integrator integrator, double step);

  void add(const Sample& sample);
  /// A warning for the coordinate that turned farthest, with the first time and a suitable step.
  std::vector<std::string> warnings() const;
  /// The longest step that the rotations allow, s; 0 if all are allowed.
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
