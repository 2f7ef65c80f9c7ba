#pragma once
// Double-step Maggi as one writes it down from theory.md: the baseline that generated code is compared with.

#include <memory>
#include <vector>

#include "tests/system/oracle/reference_mechanism.hpp"

namespace mbgen::foreign {

/// The equations of theory.md sections 1 to 5 on dense Eigen matrices of run-time size: world axes, every velocity and
/// inertia at the inertial origin, 6x6 inertias, one dense Jacobian and one factorisation by Gauss elimination with
/// full pivoting (Eigen::FullPivLU) per loop block in every evaluation, Rz and M dense. Written to be read and not to
/// be slow: what has a fixed size is a fixed-size matrix, memory is kept between calls where that is natural, sums run
/// along the paths of the tree, nothing is done twice. Knows cut spherical and revolute joints and rods.
class [[gnu::visibility("default")]] StraightforwardMaggi {
 public:
  /// topology: its loop blocks are what is factored at once; one block with all loops and joints factors Phi_z whole.
  /// Fails: std::invalid_argument for another closure.
  StraightforwardMaggi(const ReferenceMechanism& mechanism, const Topology& topology);
  ~StraightforwardMaggi();
  StraightforwardMaggi(StraightforwardMaggi &&) noexcept;

  /// All joint accelerations at a consistent state.
  std::vector<double> accelerations(const ForeignState& state);
  /// Keeps states as vectors of Eigen, for `run`.
  void load(const std::vector<ForeignState>& states);
  /// Accelerations at every loaded state, for whoever holds a clock.
  void run(int repetitions);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace mbgen::foreign
