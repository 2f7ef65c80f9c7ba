#pragma once
// The door of the linearisation room: the equations of motion for small deviations from one state.

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/linearisation/linear_system.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// How many states are positions; they come first.
Eigen::Index position_count(const LinearSystem& system);

/// Linearises by the symbolic program's derivatives, differentiated forward (program.hpp) along each state and input.
/// programs: after the passes, nothing taken out of them.
/// Fails: a loop block at whose position the frozen partition is singular (its loop named), derivatives that are not
/// finite (state or input named).
/// Cost: one run of the differentiated programs per state and input.
Result<LinearSystem> linearise(const Model& model, const Topology& topology, const Analysis& analysis,
                               const Programs& programs, const OperatingPoint& point);

/// A solution s = Re(shape exp(eigenvalue t)) of s' = A s; of a conjugate pair the one that turns forward.
struct Mode {
  std::complex<double> eigenvalue;                ///< 1/s
  std::vector<std::complex<double>> states;       ///< per state
  std::vector<std::complex<double>> coordinates;  ///< per tree coordinate, the largest of them 1
  int auxiliary = -1;                             ///< the auxiliary state that moves most where no coordinate does
  bool is_neutral = false;                        ///< eigenvalue zero but for rounding: the system may stay anywhere
  bool is_unstable = false;                       ///< grows, by more than rounding

  bool oscillates() const { return eigenvalue.imag() > 0 && !is_neutral; }
  double frequency() const { return std::abs(eigenvalue.imag()) / 6.283185307179586; }    ///< Hz, damped
  double undamped_frequency() const { return std::abs(eigenvalue) / 6.283185307179586; }  ///< Hz
  /// Fraction of the critical damping; -1 to 1.
  double damping_ratio() const { return is_neutral ? 0.0 : -eigenvalue.real() / std::abs(eigenvalue); }
};

/// Modes of the system; as many of the smallest eigenvalues are neutral as states stay, or drift at a constant rate
/// along others that do, whatever rounding makes of them. The fastest oscillations first, then the modes that do not
/// oscillate, the fastest first.
std::vector<Mode> modes(const LinearSystem& system);

/// The coordinates that move most in a mode, with signs, or phases in degrees where they are neither in step nor
/// against each other; independent ones first. Rotations and translations each over the first of their kind, and behind
/// a semicolon the kind that moves less, with the ratio of the two scales; where none moves, the auxiliary state.
std::string leading_coordinates(const Model& model, const Topology& topology, const Analysis& analysis,
                                const Mode& mode);

/// Independent coordinates that tell apart all places at which the system goes on as it does: chassis_tx, chassis_ty
/// and chassis_rz of a vehicle on the road.
std::vector<std::string> neutral_coordinates(const Topology& topology, const LinearSystem& system);

}  // namespace mbgen
