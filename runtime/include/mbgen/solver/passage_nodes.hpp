#pragma once
// Nodes of a passage (passing.hpp): closed states of loop blocks on both sides of a singular position. `System` is
// described in blocks.hpp.

#include <limits>
#include <type_traits>

#include "mbgen/motion.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/passage.hpp"

namespace mbgen {

/// Way of the fastest coordinate from the middle of a singular position to the first nodes that are tried (rad or m):
/// twice as far as it reaches.
constexpr double kPassageReach = 0.02;
/// Pivot of the frozen partition below which a block may go by a passage: a little before it is no longer trusted.
template <class Real>
inline constexpr Real kPassagePivot = 2 * kPivotThreshold<Real>;

/// Way of the fastest coordinate to the nodes (rad or m), beside a singular position that is `distance` away. way: in
/// the step. It doubles while they are not clear.
constexpr double passage_reach(double distance, double way) noexcept {
  const double clear = 0.8 * kPassageReach, before = distance - clear;
  const double reach = before < kPassageReach ? before : kPassageReach;
  return reach >= clear && reach >= way ? reach : distance + kPassageReach > way ? distance + kPassageReach : way;
}
/// Closures of one node: Newton from a guess that is off by the square of the spacing, and the check.
constexpr int kNodeClosures = 8;
/// A correction that moves no coordinate of a node by more (rad or m), nor by its velocity, is the last: Newton squares
/// it, and the terms before it give z* and Rz as near as the polynomials are.
template <class Real>
inline constexpr Real kLastOfNode = Real(1e-11);
template <>
inline constexpr float kLastOfNode<float> = 1e-7f;
/// Largest share of the way to the first node that the term of degree four has in a motion that is followed: a
/// thousandth of a thousandth where it is smooth, and the error of the middle over the way.
template <class Real>
inline constexpr Real kPassageBend = Real(0.01);

template <class System>
constexpr int projection_entries() noexcept {
  int entries = 1;  // an array has one at least
  for (int b = 0; b < System::kBlocks; ++b)
    entries = System::kBlockLayout[b].first_projection +
              System::kBlockLayout[b].coordinates * System::kBlockLayout[b].free + 1;
  return entries;
}

namespace solver_detail {

/// Memory for the nodes around a singular position.
template <class System>
struct PassageWork {
  using Real = RealOf<System>;
  typename System::State state;
  typename System::ClosureTerms terms;
  typename System::Closure closure;
  BlockFactors<System> factors;
  unsigned char fixed[System::kBlockCoordinates];  ///< driven or free: not dependent at any node
  bool is_chosen = false;                          ///< `fixed` is known
  bool keeps_frozen = false;                       ///< the free coordinates of the frozen partition stay free
  Real solution[System::kBlockCoordinates];
  Real right_hand_side[System::kEquations];
  Real z[kPassageNodes][System::kCoordinates], zd[kPassageNodes][System::kCoordinates];
  Real zdd_star[kPassageNodes][System::kCoordinates];
  Real rz[kPassageNodes][projection_entries<System>()];
  LoopFactorsOf<Real> loop[System::kBlocks];  ///< of `terms`, in their place
  bool is_fine[System::kBlocks];              ///< or the block is solved fine block by fine block
  ByFineBlocks<System> fine;                  ///< the block that was solved last
  double clear[kPassageNodes];                ///< smallest pivot of the blocks that cross over a typical one
};

/// Whether block b has driven coordinates.
template <class System>
bool has_motion(int b) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  bool has = false;
  for (int c = 0; c < block.coordinates; ++c) has = has || System::kBlockDriven[block.first_coordinate + c] != 0;
  return has;
}

/// Columns of block b that get no pivots when its free coordinates are chosen: the driven ones, and the free ones of
/// the frozen partition where they stay. These move as they were integrated: others get the rounding of closures at the
/// singular position with their velocities, which single precision feels.
template <class System>
void hold_columns(int b, bool keeps_frozen, unsigned char* fixed) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  for (int c = 0; c < block.coordinates; ++c) fixed[c] = System::kBlockDriven[block.first_coordinate + c];
  if (!keeps_frozen) return;
  for (const FreeDirection& direction : System::kFreeDirection) {
    for (int c = 0; direction.block == b && c < block.coordinates; ++c) {
      if (System::kBlockCoordinate[block.first_coordinate + c] == direction.coordinate) fixed[c] = 1;
    }
  }
}

/// Solves a block of `terms` fine block by fine block. Result: false where it has none, or they are not clear of the
/// singular position.
template <class System>
bool solves_finely([[maybe_unused]] int b, [[maybe_unused]] PassageWork<System>& work) noexcept {
  if constexpr (kHasFineBlocks<System>) {
    return work.fine.solves(b, work.terms, kSingular<RealOf<System>>, true);
  } else {
    return false;
  }
}

/// Factors of a block of `terms` in place, or its fine blocks; its free coordinates are chosen at the first call: those
/// of the frozen partition where its fine blocks serve. Where these served on the other side, they are to serve here.
/// Result: false where it is not clear of the singular position.
template <class System>
bool factorise_node(int b, PassageWork<System>& work) noexcept {
  using Real = RealOf<System>;
  const BlockLayout& block = System::kBlockLayout[b];
  unsigned char* const fixed = work.fixed + block.first_coordinate;
  const bool was_fine = work.is_fine[b];
  if (!work.is_chosen || was_fine) work.is_fine[b] = solves_finely<System>(b, work);
  if (!work.is_chosen) hold_columns<System>(b, work.keeps_frozen || work.is_fine[b], fixed);
  if (was_fine || work.is_fine[b]) return work.is_fine[b];
  LoopFactorsOf<Real>& loop = work.loop[b];
  loop = work.factors.factors_of(b, work.terms, block.rank, fixed);
  if (!work.is_chosen) {
    for (int c = 0; c < block.coordinates; ++c) fixed[c] = 1;
    for (int k = 0; k < loop.rank; ++k) fixed[loop.columns[k]] = 0;
  }
  return loop.rank == block.rank && smallest_pivot(loop) >= kSingular<Real> * static_cast<Real>(block.pivot);
}

/// Calls use(solution) with the solution of block b of `terms`, which factorise_node found.
template <class System, class Use>
void with_solution(int b, PassageWork<System>& work, const Use& use) noexcept {
  if constexpr (kHasFineBlocks<System>) {
    if (work.is_fine[b]) {
      if (work.fine.b != b) solves_finely<System>(b, work);
      return use(work.fine);
    }
  }
  use(ByFactors<System>{b, work.loop[b], work.terms, work.factors.work, work.right_hand_side});
}

/// One Newton step of a block at a node, and its consistent velocities. time: from the middle. moved: raised to the
/// largest change of a coordinate, and of a velocity times `time`. Result: its largest residual, negative where the
/// node is not clear.
template <class System>
RealOf<System> close_node(int b, double time, PassageWork<System>& work, RealOf<System>& moved) noexcept {
  using Real = RealOf<System>;
  const BlockLayout& block = System::kBlockLayout[b];
  const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
  if (!factorise_node<System>(b, work)) return -1;
  Real size = 0;
  for (int e = 0; e < block.equations; ++e) {
    const Real open = work.terms.Phi[block.first_equation + e];
    if (System::kRedundant[block.first_equation + e] == 0 && !(magnitude(open) <= size)) size = magnitude(open);
  }
  Real* const solution = work.solution + block.first_coordinate;
  for (int c = 0; c < block.coordinates; ++c) {
    const int i = coordinate[c];
    solution[c] = System::kDriven[i] != 0 ? work.closure.dz[i] : Real(0);
    size = magnitude(solution[c]) > size ? magnitude(solution[c]) : size;
  }
  with_solution<System>(b, work, [&](const auto& of) { of.closing(solution); });
  const auto raise = [&moved](Real way) { moved = magnitude(way) <= moved ? moved : magnitude(way); };
  for (int c = 0; c < block.coordinates; ++c) {
    work.state.z[coordinate[c]] += solution[c];
    raise(solution[c]);
  }
  for (int c = 0; c < block.coordinates; ++c) {
    const int i = coordinate[c];
    solution[c] = System::kDriven[i] != 0 ? work.closure.zd[i] : work.state.zd[i];
  }
  with_solution<System>(b, work, [&](const auto& of) { of.moving(solution); });
  for (int c = 0; c < block.coordinates; ++c) {
    raise(static_cast<Real>(time) * (solution[c] - work.state.zd[coordinate[c]]));
    work.state.zd[coordinate[c]] = solution[c];
  }
  return size;
}

/// z* and Rz of a block at a closed node, by the solution of its terms.
template <class System>
void keep_node(int b, int node, PassageWork<System>& work) noexcept {
  using Real = RealOf<System>;
  const BlockLayout& block = System::kBlockLayout[b];
  const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
  Real* const solution = work.solution + block.first_coordinate;
  for (int c = 0; c < block.coordinates; ++c)
    solution[c] = System::kDriven[coordinate[c]] != 0 ? work.terms.driven_acceleration[coordinate[c]] : Real(0);
  Real pivot = 0;
  with_solution<System>(b, work, [&](const auto& of) {
    of.accelerating(solution);
    of.directions(work.rz[node] + block.first_projection);
    pivot = of.smallest_pivot();
  });
  const double clear = static_cast<double>(pivot) / block.pivot;
  work.clear[node] = clear < work.clear[node] ? clear : work.clear[node];
  for (int c = 0; c < block.coordinates; ++c) {
    const int i = coordinate[c];
    work.z[node][i] = work.state.z[i];
    work.zd[node][i] = work.state.zd[i];
    work.zdd_star[node][i] = solution[c];
  }
}

/// Whether nodes could be had.
enum class Reached { all, not_clear, nowhere };

/// Closes the guess in work.state for the blocks that cross, their free coordinates held, and keeps it as a node.
template <class System, class InputsAt>
Reached reach_node(const typename System::Parameters& parameters, const InputsAt& inputs_at,
                   const unsigned char* crosses, int node, double time, PassageWork<System>& work,
                   int& closures) noexcept {
  using Real = RealOf<System>;
  const auto& inputs = inputs_at(work.state.t);
  Real previous = std::numeric_limits<Real>::infinity();
  bool is_closed = false;
  work.clear[node] = HUGE_VAL;
  for (int k = 0; k < kNodeClosures && closures-- > 0; ++k) {
    if constexpr (System::kDrives > 0) System::closure(parameters, inputs, work.state, work.closure);
    System::closure_terms(parameters, inputs, work.state, work.terms);
    Real size = 0, moved = 0;
    for (int b = 0; b < System::kBlocks; ++b) {
      if (crosses[b] == 0) continue;
      const Real of_block = close_node<System>(b, time, work, moved);
      if (!(of_block >= 0)) return Reached::not_clear;
      size = of_block > size ? of_block : size;
    }
    work.is_chosen = true;
    if (is_closed || moved <= kLastOfNode<Real>) {
      for (int b = 0; b < System::kBlocks; ++b) {
        if (crosses[b] != 0) keep_node<System>(b, node, work);
      }
      return Reached::all;
    }
    is_closed = !(size > 0 && size < Real(0.5) * previous);
    if (is_closed && !(size <= kRoundingFloor<Real>)) return Reached::nowhere;
    previous = size;
  }
  return Reached::nowhere;
}

/// Guess of a node at `time` from the middle: straight, or beyond the first node by all that is known.
template <class System>
void guess_node(const typename System::State& middle, double time, PassageWork<System>& work) noexcept {
  copy_state<System>(middle, work.state);
  work.state.t = middle.t + time;
  for (int c = 0; c < System::kBlockCoordinates; ++c) {
    const int i = System::kBlockCoordinate[c];
    work.state.z[i] += static_cast<RealOf<System>>(time) * middle.zd[i];
  }
}

/// Guess of the node opposite of the first one: by the polynomial of degree four through that and the middle. Result:
/// false where it bends so much that nothing follows from it.
template <class System>
bool guess_opposite(const typename System::State& middle, double time, PassageWork<System>& work) noexcept {
  using Real = RealOf<System>;
  guess_node<System>(middle, -time, work);
  const auto h = static_cast<Real>(time);
  Real rough = 0, longest = 0;
  for (int c = 0; c < System::kBlockCoordinates; ++c) {
    const int i = System::kBlockCoordinate[c];
    if (work.fixed[c] != 0) continue;
    const Real start = h * middle.zd[i];
    const Real way = work.z[0][i] - middle.z[i] - start, rate = h * work.zd[0][i] - start;
    const Real bend = h * h * work.zdd_star[0][i];
    const Real second = 6 * way - 3 * rate + Real(0.5) * bend;  // of the powers of time / h
    const Real third = -8 * way + 5 * rate - bend, fourth = 3 * way - 2 * rate + Real(0.5) * bend;
    work.state.z[i] += second - third + fourth;
    work.state.zd[i] = (start - 2 * second + 3 * third - 4 * fourth) / h;
    rough = magnitude(fourth) > rough ? magnitude(fourth) : rough;
    longest = magnitude(h * work.zd[0][i]) > longest ? magnitude(h * work.zd[0][i]) : longest;
  }
  return rough <= kPassageBend<Real> * longest;
}

/// Smallest pivot of block b of `terms`, 0 of one without its rank: of its fine blocks where it has them.
template <class System>
RealOf<System> pivot_of(int b, PassageWork<System>& work) noexcept {
  using Real = RealOf<System>;
  if constexpr (kHasFineBlocks<System>) {
    if (System::kFineLayout[b].count > 0)
      return work.fine.solves(b, work.terms, kRankTolerance<Real>, false) ? work.fine.smallest_pivot() : Real(0);
  }
  const LoopFactorsOf<Real> loop = work.factors.factors_of(b, work.terms);
  return loop.rank == System::kBlockLayout[b].rank ? smallest_pivot(loop) : Real(0);
}

/// Blocks at or near a singular position at a state, whose frozen partition is bad there. Result: the first of them, or
/// -1. distance: of the nearest one, the smallest pivot over a typical one.
template <class System>
int blocks_that_cross(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      const typename System::State& state, PassageWork<System>& work, unsigned char* crosses,
                      double& distance) noexcept {
  using Real = RealOf<System>;
  System::closure(parameters, inputs, state, work.closure);
  System::closure_terms(parameters, inputs, state, work.terms);
  int first = -1;
  distance = 1;
  for (int b = 0; b < System::kBlocks; ++b) {
    crosses[b] = 0;
    if (work.closure.pivot[b] >= kPassagePivot<Real> && !in_other_chart(state)) continue;
    const auto typical = static_cast<Real>(System::kBlockLayout[b].pivot);
    const Real pivot = pivot_of<System>(b, work);
    crosses[b] = pivot < kNearSingular<Real> * typical ? 1 : 0;
    const double here = static_cast<double>(pivot / typical);
    distance = here < distance ? here : distance;
    first = crosses[b] != 0 && first < 0 ? b : first;
  }
  return first;
}

/// Whether a straight motion is clear of the singular position at `time` from the middle.
template <class System, class InputsAt>
bool is_clear_at(const typename System::Parameters& parameters, const InputsAt& inputs_at,
                 const typename System::State& middle, double time, const unsigned char* crosses,
                 PassageWork<System>& work) noexcept {
  guess_node<System>(middle, time, work);
  System::closure_terms(parameters, inputs_at(work.state.t), work.state, work.terms);
  bool clear = true;
  for (int b = 0; b < System::kBlocks; ++b) clear = clear && (crosses[b] == 0 || factorise_node<System>(b, work));
  return clear;
}

/// The nodes at a spacing, s.
template <class System, class InputsAt, class OfPassage>
Reached reach_nodes(const typename System::Parameters& parameters, const InputsAt& inputs_at,
                    const typename System::State& middle, double spacing, const OfPassage& passage,
                    PassageWork<System>& work, int& closures) noexcept {
  bool are_four = false;
  for (int b = 0; b < System::kBlocks; ++b) {
    const int free = System::kBlockLayout[b].free;
    are_four = are_four || (passage.crosses[b] != 0 && free > 0 && (free > 1 || has_motion<System>(b)));
  }
  for (int c = 0; c < System::kBlockCoordinates; ++c) work.fixed[c] = 1;
  for (bool& is_fine : work.is_fine) is_fine = false;
  work.is_chosen = false;
  // Before the node ahead is closed, which takes several evaluations.
  const auto is_clear = [&](bool keeps_frozen) {
    work.keeps_frozen = keeps_frozen;
    return is_clear_at<System>(parameters, inputs_at, middle, -spacing, passage.crosses, work);
  };
  if (closures-- <= 0) return Reached::nowhere;
  constexpr bool is_single = std::is_same_v<RealOf<System>, float>;
  if (!is_clear(is_single)) {
    if (!is_single) return Reached::not_clear;
    if (closures-- <= 0) return Reached::nowhere;
    if (!is_clear(false)) return Reached::not_clear;
  }
  constexpr double kPlaces[kPassageNodes] = {1, -1, 2, -2};
  for (int node = 0; node < (are_four ? kPassageNodes : 2); ++node) {
    const bool goes_on = node != 1 || guess_opposite<System>(middle, spacing, work);
    if (!goes_on) return Reached::nowhere;
    if (node != 1) guess_node<System>(middle, kPlaces[node] * spacing, work);
    const Reached reached = reach_node<System>(parameters, inputs_at, passage.crosses, node, spacing, work, closures);
    if (reached != Reached::all) return reached;
  }
  return Reached::all;
}

}  // namespace solver_detail

}  // namespace mbgen
