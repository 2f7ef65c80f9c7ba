#pragma once
// Any mechanism as a multibody system of Simbody: tree joints as its mobilizers, cut joints and rods as its
// constraints.

#include <memory>
#include <vector>

#include "bench/foreign/reference_mechanism.hpp"

namespace mbgen::foreign {

/// A Simbody system of one mechanism. Runs of freedoms of one joint become one mobilizer where Simbody has it
/// (cylinder, universal, gimbal, translation, planar, bushing), a chain of pins and sliders with massless bodies
/// elsewhere. A rod with mass is a thin body on a universal joint, held by a ball at its other end; a massless one a
/// distance constraint. Not for use by several threads at once.
class SimbodyMechanism {
 public:
  /// Whether mbgen was built with Simbody; without it the constructor throws std::logic_error.
  static bool is_available();
  /// Version of the library, "" without it.
  static std::string version();

  /// Fails: what Simbody throws for a system that it cannot take.
  explicit SimbodyMechanism(const ReferenceMechanism& mechanism);
  ~SimbodyMechanism();
  SimbodyMechanism(SimbodyMechanism&&) noexcept;

  /// All joint accelerations at a consistent state, in the order of the mechanism's bodies.
  std::vector<double> accelerations(const ForeignState& state);
  /// Keeps states in Simbody's own coordinates, for `run`.
  void load(const std::vector<ForeignState>& states);
  /// Accelerations at every loaded state, for whoever holds a clock.
  void run(int repetitions);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace mbgen::foreign
