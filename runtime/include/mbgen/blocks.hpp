#pragma once
// Common parts of a generated solver's runtime: the places of its loop blocks, checks of arguments, and the
// pivoting factorisation of its blocks. No heap, no exceptions.
//
// `System` is written by mbgen into the solver's source. It offers, all static:
//   types      Parameters Inputs State Derivative Multipliers, and the result of each program: Accelerations Closure
//              ClosureTerms ChosenAccelerations Projection ConstraintForces. State::z are double or float, and so is
//              every number but times and steps
//   sizes      kCoordinates kAuxiliaryStates kBlocks kEquations kDrives kBlockCoordinates kFreeDirections
//   decisions  kHasClosure (loops or motions), kClosureTolerance; kFrozenOnly = true where a block is too large for
//              another partition to be chosen at run time
//              kBalls of balls with charts, where there are any; then State has charts[kBalls]
//   tables     kBall[ball] kBlockLayout[block] kBlockCoordinate[] kBlockDriven[] kDriven[coordinate]
//   kRedundant[equation]
//              kLateEquation[equation] kEarlyRank[block] only where rows of velocities alone repeat others
//              kFineLayout[block] kFineBlock[] kFineRow[] kFineColumn[] kFineEarlier[] kFineOther[] only where a block
//              falls into fine blocks (solver/block_solution.hpp)
//              kFreeDirection[direction] kMultiplierPlace[equation] kDriveCoordinate[motion]; kParameterMember
//              kInputMember, null in place of none
//   programs   accelerations, argument_sum; with a closure: closure, multipliers; with loops: closure_terms,
//              chosen_accelerations. closure gives the free directions Rz of the frozen partition, too. With
//              kFrozenOnly there are no chosen_accelerations, no Projection and no Rz, and closure_terms gives
//              `rate` = Phi_z zd for Jz

#include <initializer_list>
#include <type_traits>

#include "mbgen/charts.hpp"
#include "mbgen/lanes/array_lanes.hpp"
#include "mbgen/math/precision.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/loop.hpp"
#include "mbgen/solver/states.hpp"
#include "mbgen/status.hpp"

namespace mbgen {

/// Place of one loop block in the flat arrays of a solver.
struct BlockLayout {
  int equations;  ///< all of them, redundant ones too
  int coordinates;
  int rank;              ///< generic rank of the Jacobian
  int free;              ///< coordinates - rank - driven ones
  int first_equation;    ///< into Phi, c and residual
  int first_coordinate;  ///< into kBlockCoordinate, kBlockDriven and zdd_star
  int first_jacobian;    ///< into Jz
  int first_projection;  ///< into Rz
  double pivot;          ///< smallest of full pivoting in a typical configuration
};

/// A free direction of the final equations.
struct FreeDirection {
  int coordinate;  ///< that names it in the frozen partition
  int block;       ///< loop block, -1 for a joint outside all blocks
  int place;       ///< q: place among the free directions of the block
};

/// Whether another partition is chosen at run time where the frozen one is bad.
template <class System, class = void>
inline constexpr bool kChoosesAgain = System::kBlocks > 0;
template <class System>
inline constexpr bool kChoosesAgain<System, std::void_t<decltype(System::kFrozenOnly)>> = !System::kFrozenOnly;

/// Number of the places at which elements hold, see hold_names of the compiler.
template <class System, class = void>
inline constexpr int kHoldsOf = 0;
template <class System>
inline constexpr int kHoldsOf<System, std::void_t<decltype(System::kHolds)>> = System::kHolds;

/// Smallest pivot of a block, over its median in the analysed configurations, with which the frozen order is trusted.
/// The analysis accepts ratios from 0.05; two digits of the answer are at stake here, where it is left. Accelerations
/// lose with the square of the pivot, and floats have no two digits to spare.
template <class Real>
inline constexpr Real kPivotThreshold = 0.02;
template <>
inline constexpr float kPivotThreshold<float> = 0.1f;
/// Smallest pivot of a block, over its median, for which dependent coordinates alone may correct the drift of a step:
/// the cosine of an eighth of a turn, at which the other of two coordinates becomes the better pivot. Below it such a
/// correction would move the mechanism along its free directions by more than the drift. It is then shortened by the
/// free directions of the frozen partition; below kNearSingular the partition is chosen again.
template <class Real>
inline constexpr Real kFairPivot = Real(0.7);
/// Corrections below this many closure tolerances are slight: so much the closures may be open.
template <class Real>
inline constexpr Real kSlightCorrection = Real(8);

namespace solver_detail {

template <class Real>
[[gnu::always_inline]] inline void copy(const Real* from, Real* to, int count) noexcept {
  using namespace array_detail;
  constexpr int width = kLanes<Real>;
  for (int i = 0; i + width <= count; i += width) put_lanes(lanes_at<width>(from + i), to + i);
  for (int i = count - count % width; i < count; ++i) to[i] = from[i];
}

template <class System>
void copy_state(const typename System::State& from, typename System::State& to) noexcept {
  copy_array(from.z, to.z);
  copy_array(from.zd, to.zd);
  copy_array(from.x, to.x);
  to.t = from.t;
  integrator_detail::copy_charts(from, to, 0);
}

/// Sum of entries, in no order that counts: not finite when an entry is not.
template <class Real>
[[gnu::always_inline]] inline Real sum(const Real* values, int count) noexcept {
  Total<Real> total(0);
  total.add(values, count);
  return total.value();
}

/// Largest absolute value, NaN if one is; 0 of an empty range.
template <class Real>
inline Real largest(const Real* values, int count) noexcept {
  Real result = 0;
  for (int i = 0; i < count; ++i) {
    if (is_nan(values[i])) return values[i];
    result = magnitude(values[i]) > result ? magnitude(values[i]) : result;
  }
  return result;
}

/// Place of the first entry that is not finite, or -1.
template <class Real>
inline int first_not_finite(const Real* values, int count) noexcept {
  for (int i = 0; i < count; ++i) {
    if (!is_finite(values[i])) return i;
  }
  return -1;
}

/// Place of the first member that is not finite, or -1; null stands in a table that would be empty.
template <class Struct, class Real, std::size_t N>
int first_not_finite(const Struct& values, Real Struct::*const (&members)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) {
    if (members[i] != nullptr && !is_finite(values.*members[i])) return static_cast<int>(i);
  }
  return -1;
}

/// Names the first argument that is not finite. A sum of large finite values can overflow, so ok is a possible answer.
template <class System>
Status find_not_finite(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const typename System::State& state, const RealOf<System>* tau) noexcept {
  using Real = RealOf<System>;
  for (const Real* values : {static_cast<const Real*>(state.z), static_cast<const Real*>(state.zd), tau}) {
    const int bad = values == nullptr ? -1 : first_not_finite(values, System::kCoordinates);
    if (bad >= 0) return {Code::not_a_number, bad};
  }
  if (!is_finite(state.t)) return {Code::time_not_a_number, -1};
  const int auxiliary = first_not_finite(state.x, System::kAuxiliaryStates);
  if (auxiliary >= 0) return {Code::auxiliary_not_a_number, auxiliary};
  const int input = first_not_finite(inputs, System::kInputMember);
  if (input >= 0) return {Code::input_not_a_number, input};
  const int parameter = first_not_finite(parameters, System::kParameterMember);
  return parameter < 0 ? Status{} : Status{Code::parameter_not_a_number, parameter};
}

/// Status of the arguments of a call; tau may be null.
template <class System>
Status check_arguments(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                       const typename System::State& state, const RealOf<System>* tau) noexcept {
  Total<RealOf<System>> total(static_cast<RealOf<System>>(state.t) + System::argument_sum(parameters, inputs));
  total.add(state.z, System::kCoordinates);
  total.add(state.zd, System::kCoordinates);
  total.add(state.x, System::kAuxiliaryStates);
  if (tau != nullptr) total.add(tau, System::kCoordinates);
  return is_finite(total.value()) ? Status{} : find_not_finite<System>(parameters, inputs, state, tau);
}

/// True when every monitor of the frozen partition is good; a NaN is not.
template <class System>
bool frozen_is_good(const RealOf<System>* pivot) noexcept {
  bool good = true;
  for (int b = 0; b < System::kBlocks; ++b) good = good && pivot[b] >= kPivotThreshold<RealOf<System>>;
  return good;
}

/// Status of a solver that only has the frozen partition. Fails: loop_singular where that is bad.
template <class System>
Status frozen_status(const RealOf<System>* pivot) noexcept {
  for (int b = 0; b < System::kBlocks; ++b) {
    if (!(pivot[b] >= kPivotThreshold<RealOf<System>>)) return {Code::loop_singular, b};
  }
  return {};
}

/// True when no frozen pivot is small enough to ask how near a singular position is; a NaN is.
template <class System>
bool is_far(const RealOf<System>* pivot) noexcept {
  bool far = true;
  for (int b = 0; b < System::kBlocks; ++b) far = far && pivot[b] >= kNearSingular<RealOf<System>>;
  return far;
}

/// Notice of block b by its smallest pivots: of full pivoting, typically and here, and of the frozen partition over its
/// median.
template <class Real>
inline Status notice_of(int b, double typical_pivot, Real pivot, Real frozen_pivot) noexcept {
  const Real typical = static_cast<Real>(typical_pivot);
  if (pivot < kSingular<Real> * typical) return {Code::singular_met, b};
  if (pivot < kNearSingular<Real> * typical) return {Code::near_singular, b};
  return frozen_pivot >= kPivotThreshold<Real> ? Status{} : Status{Code::chosen_again, b};
}

/// Which rows of block b get pivots last.
template <class System, class = void>
struct PivotOrder {
  static constexpr LatePivots of(int /*b*/) noexcept { return {}; }
};
template <class System>
struct PivotOrder<System, std::void_t<decltype(System::kLateEquation)>> {
  static constexpr LatePivots of(int b) noexcept {
    return {System::kLateEquation + System::kBlockLayout[b].first_equation, System::kEarlyRank[b]};
  }
};

/// Factors of the blocks with their permutations.
template <class System>
struct BlockFactors {
  using Real = RealOf<System>;
  int rows[System::kEquations > 0 ? System::kEquations : 1];
  int columns[System::kBlockCoordinates > 0 ? System::kBlockCoordinates : 1];
  Real work[System::kEquations > 0 ? System::kEquations : 1];
  Real largest[System::kEquations > 0 ? System::kEquations : 1];
  int largest_at[System::kEquations > 0 ? System::kEquations : 1];
  int places[System::kBlockCoordinates > 0 ? System::kBlockCoordinates : 1];

  /// Factorises block b of `terms` in place.
  LoopFactorsOf<Real> factors_of(int b, typename System::ClosureTerms& terms) noexcept {
    return factors_of(b, terms, System::kBlockLayout[b].rank);
  }
  /// The same with at most `rank_limit` pivots.
  LoopFactorsOf<Real> factors_of(int b, typename System::ClosureTerms& terms, int rank_limit) noexcept {
    constexpr bool has_driven = System::kDrives > 0;
    const unsigned char* const driven = System::kBlockDriven + System::kBlockLayout[b].first_coordinate;
    return factors_of(b, terms, rank_limit, has_driven ? driven : nullptr);
  }
  /// The same without pivots in the columns of the block that are `fixed`.
  LoopFactorsOf<Real> factors_of(int b, typename System::ClosureTerms& terms, int rank_limit,
                                 const unsigned char* fixed) noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    LoopFactorsOf<Real> loop;
    loop.equations = block.equations;
    loop.coordinates = block.coordinates;
    loop.matrix = terms.Jz + block.first_jacobian;
    loop.rows = rows + block.first_equation;
    loop.columns = columns + block.first_coordinate;
    loop.largest = largest + block.first_equation;
    loop.largest_at = largest_at + block.first_equation;
    loop.places = places;
    factorise(loop, rank_limit, fixed, kRankTolerance<Real>, PivotOrder<System>::of(b));
    return loop;
  }
};

}  // namespace solver_detail

}  // namespace mbgen
