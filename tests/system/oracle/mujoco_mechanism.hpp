#pragma once
// Any mechanism as a model of MuJoCo. Its constraints are springs and dampers that are very stiff, and it leaves out
// the velocity terms of constraint accelerations: with closed loops its answers are near, not equal.

#include <memory>
#include <string>
#include <vector>

#include "tests/system/oracle/reference_mechanism.hpp"

namespace mbgen::foreign {

/// A MuJoCo model of one mechanism: a body per rigid body with its freedoms as hinges and slides; a cut spherical joint
/// is one `connect`, a cut revolute joint two of them on its axis; a massless rod a tendon of constant length, one with
/// mass a thin body on two hinges with a `connect` at its other end. Newton's method, at most 100 iterations, tolerance
/// 1e-10, constraint impedance 0.9999 (the stiffest there is), no contacts.
class MujocoMechanism {
 public:
  /// Whether mbgen was built with MuJoCo; without it the constructor throws std::logic_error.
  static bool is_available();
  /// Version of the library, "" without it.
  static std::string version();

  /// Fails: std::invalid_argument for what has no form here (other cut joints, massless bodies with joints of their
  /// own); std::runtime_error with MuJoCo's message.
  explicit MujocoMechanism(const ReferenceMechanism& mechanism);
  ~MujocoMechanism();
  MujocoMechanism(MujocoMechanism&&) noexcept;

  /// All joint accelerations, in the order of the mechanism's bodies.
  std::vector<double> accelerations(const ForeignState& state);
  /// Forces on all joints that give these accelerations, both in the order of the mechanism's bodies (mj_inverse).
  /// state: its tau is left out. Requires: no closed loops.
  std::vector<double> inverse_forces(const ForeignState& state, const std::vector<double>& zdd);
  /// Keeps states in MuJoCo's own coordinates, for `run`.
  void load(const std::vector<ForeignState>& states);
  /// mj_forward at every loaded state, for whoever holds a clock.
  void run(int repetitions);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace mbgen::foreign
