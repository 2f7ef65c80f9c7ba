#pragma once
// Interface of the linearisation room: equations of motion for small deviations from one state.

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

/// Number of states that are positions; they come first.
Eigen::Index position_count(const LinearSystem& system);

/// The programs of a model with their derivatives along a direction of states and inputs, by forward differentiation
/// (program.hpp).
struct DirectionalPrograms {
  std::vector<DirectionGroup> groups;
  Program closure, accelerations, multipliers, outputs;
  bool has_closure = false, has_multipliers = false;
};

/// programs: after the passes, complete. Points to linearise at share them.
DirectionalPrograms directional_programs(const Model& model, const Topology& topology, const Analysis& analysis,
                                         const Programs& programs);

/// Linearises by derivatives along each state and input. Fails: a loop block with a singular frozen partition at the
/// point (names its loop), derivatives that are not finite. Cost: one run of the programs per state and input.
Result<LinearSystem> linearise(const Model& model, const Topology& topology, const Analysis& analysis,
                               const DirectionalPrograms& programs, const OperatingPoint& point);

/// A solution s = Re(shape exp(eigenvalue t)) of s' = A s; of a conjugate pair the one with positive imaginary part.
struct Mode {
  std::complex<double> eigenvalue;                ///< 1/s
  std::vector<std::complex<double>> states;       ///< per state
  std::vector<std::complex<double>> coordinates;  ///< per tree coordinate, normalised to the largest
  int auxiliary = -1;        ///< the auxiliary state with the largest amplitude in a mode without coordinates
  bool is_neutral = false;   ///< eigenvalue zero up to rounding: indifferent equilibrium
  bool is_unstable = false;  ///< grows, by more than rounding

  bool oscillates() const { return eigenvalue.imag() > 0 && !is_neutral; }
  double frequency() const { return std::abs(eigenvalue.imag()) / 6.283185307179586; }    ///< Hz, damped
  double undamped_frequency() const { return std::abs(eigenvalue) / 6.283185307179586; }  ///< Hz
  /// Fraction of the critical damping; -1 to 1.
  double damping_ratio() const { return is_neutral ? 0.0 : -eigenvalue.real() / std::abs(eigenvalue); }
};

/// Modes of the system. The number of neutral ones, with the smallest eigenvalues, is the number of states that are
/// constant, or that drift at a constant rate along others, whatever their rounding errors. Oscillations first, by
/// decreasing frequency, then the others by decreasing rate.
std::vector<Mode> modes(const LinearSystem& system);

/// The other order: oscillations by increasing frequency, then the others by increasing rate, neutral ones last.
void put_slowest_first(std::vector<Mode>& list);

/// The coordinates with the largest amplitudes in a mode, with signs, or phases in degrees unless they are in phase or
/// in antiphase; independent ones first. Rotations and translations are relative to the first of their kind; the kind
/// with smaller amplitudes follows a semicolon, with the ratio of the two scales. For a mode without coordinates, the
/// auxiliary state.
std::string leading_coordinates(const Model& model, const Topology& topology, const Analysis& analysis,
                                const Mode& mode);

/// Independent coordinates that distinguish all positions with the same motion: chassis_tx, chassis_ty and chassis_rz
/// of a vehicle on the road.
std::vector<std::string> neutral_coordinates(const Topology& topology, const LinearSystem& system);

}  // namespace mbgen
