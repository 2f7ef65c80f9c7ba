#pragma once
// Checks of rolling contacts: the model cannot lose contact, so that a motion reports where a real disc or ball would
// lift off, and where a disc fell flat.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "workbench/motion/simulation.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {

/// Normal forces of rolling discs and balls along a motion, and the rolling directions of discs.
class ContactWatch {
 public:
  explicit ContactWatch(const Compilation& compilation);

  /// Whether the motion's samples need their multipliers.
  bool needs_multipliers() const { return !contacts_.empty(); }
  void add(const Sample& sample);
  /// Adds contacts that pulled, and discs that fell flat, to the findings about a motion.
  void judge(const SimulationSummary& summary, StepVerdict& verdict) const;

 private:
  struct Contact {
    const Loop* loop;
    std::size_t row;                                    ///< of the normal force among all multipliers
    double since = 0;                                   ///< s, when it first pulled
    double largest = 0;                                 ///< N, of pulling
    double scale = 0;                                   ///< N, the largest force of any sign
    Eigen::Vector3d forward = Eigen::Vector3d::Zero();  ///< of a disc, at the last sample
    double flat = -1;                                   ///< s, when a disc was first flat; -1: never
  };
  Eigen::Vector3d forward_of(const Contact& contact, const std::vector<Pose>& poses) const;
  /// A warning for each contact that pulled, with the first time and the largest force.
  std::vector<std::string> warnings() const;
  /// Reason why the motion is wrong: a disc fell flat, where its contact jumps to the other side; empty if none did.
  std::string failure() const;

  const Compilation& compilation_;
  std::optional<GenericSolver> solver_;  ///< for poses, where there are contacts
  std::vector<Contact> contacts_;
};

}  // namespace mbgen
