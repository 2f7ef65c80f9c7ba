#pragma once
// Touches of contacts that a step does not resolve: their loads, and what bounces back, are then wrong, however little
// energy they have in the balance of the motion.

#include <optional>
#include <vector>

#include "workbench/motion/simulation.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {

/// Touches of each contact along a motion.
class TouchWatch {
 public:
  TouchWatch(const Compilation& compilation, const SimulationSettings& settings);

  void add(const Sample& sample);
  /// Warns of the contact with the hardest touch of fewer than kStepsOfTouch steps and no small load, and counts the
  /// others.
  void judge(const SimulationSummary& summary, StepVerdict& verdict) const;

 private:
  struct Contact {
    const std::string* name;
    long touches = 0;              ///< that ended
    long steps = 0;                ///< of the touch that lasts; -1 for one that the motion began in
    double load = 0;               ///< N, its largest
    double most = 0;               ///< N, the largest of all
    long brief = 0;                ///< touches with too few steps
    long fewest = 0;               ///< steps of the briefest
    double hardest = 0, time = 0;  ///< N, of brief touches, and s, when it ended
  };
  void end_touch(Contact& contact, double time);

  double step_;
  std::vector<Contact> contacts_;
  std::optional<GenericSolver> solver_;  ///< with deflection and load of each contact as outputs
};

/// A touch is half a swing. Runge-Kutta errs in one of so many steps by 2 to 5 % of its load and 0.3 to 1 % of its
/// energy, for exponents of 1 to 1.5.
constexpr long kStepsOfTouch = 6;
/// Part of the largest load of a contact below which a brief touch does not count.
constexpr double kGrazing = 0.1;

}  // namespace mbgen
