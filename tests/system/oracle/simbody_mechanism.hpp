#pragma once
// Any mechanism as a multibody system of Simbody: tree joints as its mobilizers, cut joints and rods as its
// constraints.

#include <memory>
#include <vector>

#include "tests/system/oracle/force_elements.hpp"

namespace mbgen::foreign {

struct SimbodySystem;

/// Force (N) and moment (N m), global axes.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
};

/// Wrenches that joints and rods transmit to their `to` bodies, about their points there.
struct ForeignReactions {
  /// per tree body: of its joint, where it is the last freedom of the joint; zero elsewhere
  std::vector<Wrench> joints;
  std::vector<Wrench> closures;  ///< a rod transmits no moment
  std::vector<double> drives;    ///< generalised force of each motion, N or N m
};

/// A Simbody system of one mechanism. Runs of freedoms of one joint become one mobilizer where Simbody has it
/// (cylinder, universal, gimbal, translation, planar, bushing), a chain of pins and sliders with massless bodies
/// elsewhere. A rod with mass is a thin body on a universal joint, held by a ball at its other end; a massless one a
/// distance constraint. Force elements are one custom force, motions prescribed coordinates. Not for use by several
/// threads at once.
class SimbodyMechanism {
 public:
  /// Whether mbgen was built with Simbody; without it the constructor throws std::logic_error.
  static bool is_available();
  /// Version of the library, "" without it.
  static std::string version();

  /// Fails: what Simbody throws for a system that it cannot take.
  explicit SimbodyMechanism(const ReferenceMechanism& mechanism, const ForceElements& elements = {});
  ~SimbodyMechanism();
  SimbodyMechanism(SimbodyMechanism&&) noexcept;

  /// All joint accelerations at a consistent state, in the order of the mechanism's bodies.
  std::vector<double> accelerations(const ForeignState& state);
  /// Reactions at the joints, with the springs, forces and drives of their coordinates.
  ForeignReactions reactions(const ForeignState& state);
  /// The motion from a consistent state without joint forces, at increasing times (s) from start.t on, by Simbody's
  /// Runge-Kutta-Merson method. accuracy: relative, of one step. Fails: what Simbody throws when it cannot go on.
  std::vector<ForeignState> motion(const ForeignState& start, const std::vector<double>& times, double accuracy);
  /// Keeps states in Simbody's own coordinates, for `run`.
  void load(const std::vector<ForeignState>& states);
  /// Accelerations at every loaded state, for whoever holds a clock.
  void run(int repetitions);

 private:
  std::unique_ptr<SimbodySystem> system_;
};

}  // namespace mbgen::foreign
