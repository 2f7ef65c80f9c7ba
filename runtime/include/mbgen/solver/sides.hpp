#pragma once
// The way of the loops of a generated solver in a step: whether they reach another side of a singular position, where
// branches of their motion cross. `System` is described in blocks.hpp.

#include "mbgen/number.hpp"
#include "mbgen/solver/corrections.hpp"
#include "mbgen/solver/singular_step.hpp"

namespace mbgen {

namespace solver_detail {

/// Closure of one of two states that are compared, with the solution of one block at a time.
template <class System>
struct Side {
  using Real = RealOf<System>;
  typename System::ClosureTerms terms;
  ByFineBlocks<System> fine;
  int solved = -1;         ///< block of `fine`
  bool is_solved = false;  ///< fine block by fine block

  /// Whether block b is solved fine block by fine block: as small as its pivots are, they have their signs.
  bool solves([[maybe_unused]] int b) noexcept {
    if constexpr (kHasFineBlocks<System>) {
      if (solved != b) is_solved = fine.solves(b, terms, kRankTolerance<Real>, false);
      solved = b;
    }
    return is_solved;
  }
};

/// Two states, and whether blocks are on other sides of singular positions in them.
template <class System>
struct TwoSides {
  using Real = RealOf<System>;
  static constexpr int kPivots = most_of_blocks<System>(&BlockLayout::rank), kFree = most_free<System>();
  static constexpr int kMost = kPivots > kFree ? kPivots : kFree;
  Side<System> start, end;
  typename System::ClosureTerms factored;
  BlockFactors<System> factors;
  Real product[kMost * kMost];
  int rows[kMost], columns[kMost];

  TwoSides(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
           const typename System::State& from, const typename System::State& to) noexcept {
    System::closure_terms(parameters, inputs, from, start.terms);
    System::closure_terms(parameters, inputs, to, end.terms);
  }
  LoopFactorsOf<Real> factors_of(int b, const typename System::ClosureTerms& terms) noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    copy(terms.Jz + block.first_jacobian, factored.Jz + block.first_jacobian, block.equations * block.coordinates);
    return factors.factors_of(b, factored);
  }
  /// Whether the smallest pivot over a typical one is as large as `reach`.
  bool is_clear(int b, Side<System>& side, double reach) noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    if constexpr (kHasFineBlocks<System>) {
      if (side.solves(b)) return reach <= static_cast<double>(side.fine.smallest_pivot()) / block.pivot;
    }
    const LoopFactorsOf<Real> loop = factors_of(b, side.terms);
    return loop.rank == block.rank && reach <= static_cast<double>(smallest_pivot(loop)) / block.pivot;
  }
  bool differ(int b) noexcept {
    if constexpr (kHasFineBlocks<System>) {
      if (start.solves(b) && end.solves(b) && start.fine.solution.sign * end.fine.solution.sign != 0)
        return differ_finely(b);
    }
    const BlockLayout& block = System::kBlockLayout[b];
    const LoopFactorsOf<Real> loop = factors_of(b, start.terms);
    const unsigned char* const driven = System::kBlockDriven + block.first_coordinate;
    return changes_side(loop, start.terms.Jz + block.first_jacobian, end.terms.Jz + block.first_jacobian, driven,
                        SideWork<Real>{product, rows, columns});
  }

 private:
  /// The same of blocks with the same free coordinates in both states: det(J J'), by Jacobi's complementary minors, is
  /// det(Jd) det(Jd) det(Rz' Rz), with the columns d that depend and the motions Rz of the free ones.
  bool differ_finely(int b) noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    const unsigned char* const driven = System::kBlockDriven + block.first_coordinate;
    const FineSolution<Real>&from = start.fine.solution, &to = end.fine.solution;
    int free = 0;
    for (int q = 0; q < from.other_count; ++q) {
      if (driven[from.others[q]] == 0) columns[free++] = q;
    }
    for (int q = 0; q < free; ++q) {
      for (int p = 0; p < free; ++p) {
        Real sum = 0;
        for (int c = 0; c < block.coordinates; ++c)
          sum += driven[c] != 0 ? Real(0) : from.row(c)[columns[q]] * to.row(c)[columns[p]];
        product[q * free + p] = sum;
      }
    }
    return from.sign * to.sign * sign_of_determinant(free, product, rows, columns) < 0;
  }
};

template <class System>
LoopWay way_of(int b, const typename System::State& from, const typename System::State& to) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  LoopWay way;
  for (int c = block.first_coordinate; c < block.first_coordinate + block.coordinates; ++c) {
    const int i = System::kBlockCoordinate[c];
    way.add(static_cast<double>(from.zd[i]), static_cast<double>(to.zd[i]));
  }
  return way;
}

/// 1 for coordinates in loops, else 0.
template <class System, class Real>
struct InLoops {
  Real is[System::kCoordinates] = {};
  constexpr InLoops() noexcept {
    for (int c = 0; c < System::kBlockCoordinates; ++c) is[System::kBlockCoordinate[c]] = 1;
  }
};

}  // namespace solver_detail

/// Loop block that is on another side of a singular position at `to` than at `from`, or -1: see changes_side. inputs:
/// of the step between them. Requires: states that are finite and in the same charts.
template <class System>
int changed_side(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                 const typename System::State& from, const typename System::State& to) noexcept {
  solver_detail::TwoSides<System> sides(parameters, inputs, from, to);
  for (int b = 0; b < System::kBlocks; ++b) {
    if (sides.differ(b)) return b;
  }
  return -1;
}

/// Whether all loops together move far enough from one position to another for the ways of their coordinates to be
/// looked at. By the way, not by the rates at its end: a step that leaps can end at rest.
template <class System, class Real, std::size_t N>
[[gnu::always_inline]] inline bool moves_far(const Real (&from)[N], const Real (&to)[N], double least) noexcept {
  static constexpr solver_detail::InLoops<System, Real> kInLoops{};
  using namespace array_detail;
  constexpr int width = width_for<Real>(N);
  constexpr int whole = static_cast<int>(N) / width * width;
  LanesOf<width, Real> lanes = {};
  for (int i = 0; i < whole; i += width) {
    const LanesOf<width, Real> way =
        (lanes_at<width>(to + i) - lanes_at<width>(from + i)) * lanes_at<width>(kInLoops.is + i);
    lanes += way * way;
  }
  Real sum = 0;
  for (int lane = 0; lane < width; ++lane) sum += lane_of(lanes, lane);
  for (int i = whole; i < static_cast<int>(N); ++i) {
    const Real way = kInLoops.is[i] * (to[i] - from[i]);
    sum += way * way;
  }
  const auto limit = static_cast<Real>(least * least);
  return !(sum <= limit);
}

namespace solver_detail {

/// Whether one coordinate of a loop moves by more than `least`: many short ways make no long one.
template <class System>
bool one_moves_far(const typename System::State& from, const typename System::State& to, double least) noexcept {
  for (const int i : System::kBlockCoordinate) {
    if (!(magnitude(static_cast<double>(to.z[i] - from.z[i])) <= least)) return true;
  }
  return false;
}

/// watch_way of loops that move far: apart, for its frame.
template <class System>
[[gnu::noinline]] Status look_at_way(const typename System::Parameters& parameters,
                                     const typename System::Inputs& inputs, const typename System::State& from,
                                     const typename System::State& to, double h, const WayLimits& limits) noexcept {
  if (limits.least > 0 && !one_moves_far<System>(from, to, limits.least)) return {};
  TwoSides<System> sides(parameters, inputs, from, to);
  for (int b = 0; b < System::kBlocks; ++b) {
    const LoopWay way = way_of<System>(b, from, to);
    const double reach = h * way.fastest / limits.most;
    if (sides.is_clear(b, sides.end, reach) && sides.is_clear(b, sides.start, reach)) continue;
    // Where motions drive all of it, nothing is integrated: the end of its reach is told by the closure.
    const bool is_free = System::kBlockLayout[b].free > 0 || limits.aside == 0;
    if (is_free && way.turns(limits)) return {Code::loop_singular, b};
    if (sides.differ(b)) return {Code::singular_met, b};
  }
  return {};
}

}  // namespace solver_detail

/// The way of the loops in a step of h seconds, see WayLimits: singular_met for a block that is on another side than
/// before; loop_singular for one whose motion turned aside from a singular position that is nearer than the step is
/// long, as part of `most`. Requires as changed_side. Cost: two Jacobians where loops move by more than `least`.
template <class System>
Status watch_way(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                 const typename System::State& from, const typename System::State& to, double h,
                 const WayLimits& limits) noexcept {
  if (limits.least > 0 && !moves_far<System>(from.z, to.z, limits.least)) return {};
  return solver_detail::look_at_way<System>(parameters, inputs, from, to, h, limits);
}

/// Whether watch_way is to look at a step: of a solver of regular positions alone.
template <class System>
bool is_to_be_watched(const typename System::State& from, const typename System::State& to, double least) noexcept {
  if constexpr (System::kBlocks > 0) {
    return moves_far<System>(from.z, to.z, least) && solver_detail::one_moves_far<System>(from, to, least);
  } else {
    return false;
  }
}

}  // namespace mbgen
