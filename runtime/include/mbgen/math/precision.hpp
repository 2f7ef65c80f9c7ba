#pragma once
// Limits and types that depend on the precision of a solver: double, or float by `mbgen generate --scalar float`. Time
// and steps are double in both: a float has no place for a millisecond after four hours, and loses one in a thousand of
// it after ten seconds. See docs/use/targets.md.

#include <type_traits>
#include <utility>

namespace mbgen {

/// Type of the numbers of a generated solver, the type of its coordinates.
template <class System>
using RealOf = std::remove_all_extents_t<decltype(System::State::z)>;

/// The plain number that entries of an array or container are weighted by: float for floats, else double.
template <class Values>
using WeightOf =
    std::conditional_t<std::is_same_v<std::decay_t<decltype(std::declval<Values&>()[0])>, float>, float, double>;

/// Closure tolerance (m or 1) below which rounding of positions of some metres decides: a model's is held above it.
template <class Real>
inline constexpr Real kLeastClosureTolerance = 0;
template <>
inline constexpr float kLeastClosureTolerance<float> = 0x1p-20f;

/// A closure that stopped improving is accepted below this residual (m or 1): large mechanisms round above the
/// tolerance.
template <class Real>
inline constexpr Real kRoundingFloor = 1e-9;
template <>
inline constexpr float kRoundingFloor<float> = 1e-4f;

/// Residual (m or 1) above which a redundant equation contradicts the others.
template <class Real>
inline constexpr Real kRedundantTolerance = 1e-6;
template <>
inline constexpr float kRedundantTolerance<float> = 1e-3f;

/// A pivot below this part of the block's first one means a rank lower than the generic one.
template <class Real>
inline constexpr Real kRankTolerance = 1e-10;
template <>
inline constexpr float kRankTolerance<float> = 1e-5f;

/// Smallest pivot of full pivoting, over its typical value, below which a block is at a singular position: rounding of
/// the positions, divided by the third power of this number, is in the accelerations.
template <class Real>
inline constexpr Real kSingular = 0.01;
template <>
inline constexpr float kSingular<float> = 0.03f;

/// The same below which a block is near a singular position: Jacobians change much within one step there. Not below
/// kPivotThreshold (blocks.hpp).
template <class Real>
inline constexpr Real kNearSingular = Real(0.1);

/// Positions interpolated by polynomials of degree seven and of degree five agree to this part of the way to the outer
/// nodes; otherwise the nodes lie on different branches, or the motion does not lead through.
template <class Real>
inline constexpr Real kSmoothness = 1e-7;
template <>
inline constexpr float kSmoothness<float> = 1e-3f;

}  // namespace mbgen
