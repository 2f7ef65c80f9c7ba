#pragma once
// One loop block of a generated solver solved for its dependent coordinates, by the factors of all of it or fine block
// by fine block. `System` is described in blocks.hpp. Source: (60)-(62).

#include <type_traits>

#include "mbgen/blocks.hpp"
#include "mbgen/solver/fine.hpp"
#include "mbgen/solver/regular.hpp"

namespace mbgen {

/// Places of one loop block in the tables of fine blocks.
struct FineLayout {
  int first_block;  ///< into kFineBlock
  int count;
  int first_place;  ///< into kFineRow and kFineColumn
  int first_earlier;
  int first_other;
  int largest;
};

/// Smallest pivot of the fine blocks, over the typical one of the whole loop block, from which they serve. Below, the
/// block takes pivots anywhere, since a small one of a fine block multiplies the rounding of the later ones.
template <class Real>
inline constexpr Real kFinePivot = Real(0.1) * kSingular<Real>;

namespace solver_detail {

template <class System, class = void>
inline constexpr bool kHasFineBlocks = false;
template <class System>
inline constexpr bool kHasFineBlocks<System, std::void_t<decltype(System::kFineLayout)>> = true;

/// Solution by factors of the whole block.
template <class System>
struct ByFactors {
  using Real = RealOf<System>;
  int b;
  const LoopFactorsOf<Real>& loop;
  const typename System::ClosureTerms& terms;
  Real* work;             ///< a number per equation
  Real* right_hand_side;  ///< likewise; null where `open` and `moving` are not called

  /// Rz of the block.
  void directions(Real* rz) const noexcept {
    free_directions(loop, System::kBlockDriven + System::kBlockLayout[b].first_coordinate, rz, work);
  }
  /// Changes of the dependent coordinates that close the block, given those of the others in x.
  void closing(Real* x) const noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    for (int e = 0; e < block.equations; ++e) right_hand_side[e] = -terms.Phi[block.first_equation + e];
    solve_dependent(loop, right_hand_side, x, work);
  }
  /// Consistent velocities, likewise.
  void moving(Real* x) const noexcept {
    for (int e = 0; e < System::kBlockLayout[b].equations; ++e) right_hand_side[e] = 0;
    solve_dependent(loop, right_hand_side, x, work);
  }
  /// Accelerations, likewise.
  void accelerating(Real* x) const noexcept {
    solve_dependent(loop, terms.c + System::kBlockLayout[b].first_equation, x, work);
  }
  Real smallest_pivot() const noexcept { return mbgen::smallest_pivot(loop); }
};

/// Largest number over the loop blocks with fine blocks.
template <class System, class Number>
constexpr int most_of_fine(const Number& number) noexcept {
  int most = 1;
  for (int b = 0; b < System::kBlocks; ++b) {
    if (System::kFineLayout[b].count > 0 && number(b) > most) most = number(b);
  }
  return most;
}

template <class System>
constexpr int fine_others(int b) noexcept {
  return System::kBlockLayout[b].coordinates - System::kBlockLayout[b].rank;
}

/// A flag per column: no pivot is searched in it.
template <int N>
struct AllHeld {
  unsigned char is[N] = {};
  constexpr AllHeld() noexcept {
    for (unsigned char& flag : is) flag = 1;
  }
};

/// Solution fine block by fine block, of one loop block at a time.
template <class System, class = void>
struct ByFineBlocks {
  bool solves(int /*b*/, const typename System::ClosureTerms& /*terms*/) noexcept { return false; }
};
template <class System>
struct ByFineBlocks<System, std::enable_if_t<kHasFineBlocks<System>>> {
  using Real = RealOf<System>;
  static constexpr int kLargest = most_of_fine<System>([](int b) { return System::kFineLayout[b].largest; });
  static constexpr int kOthers = most_of_fine<System>([](int b) { return fine_others<System>(b); });
  static constexpr int kRows =
      most_of_fine<System>([](int b) { return System::kBlockLayout[b].coordinates * (fine_others<System>(b) + 2); });

  int b = 0;
  FineSolution<Real> solution;
  Real rows[kRows];
  Real work[fine_work(kLargest, kOthers)];
  int others[kOthers], places[2 * kLargest];
  unsigned char movable[kOthers];

  /// Solves block `block` of `terms`. Result: false where the factors of all of it are needed.
  bool solves(int block, const typename System::ClosureTerms& terms) noexcept {
    return solves(block, terms, kFinePivot<Real>, false);
  }
  /// The same with pivots from `least` on, over the typical one. holds: the free coordinates of the frozen partition
  /// stay free. told: velocities, see solve_finely; then the block is solved as far as its pivots go.
  bool solves(int block, const typename System::ClosureTerms& terms, Real least, bool holds,
              const Real* told = nullptr) noexcept {
    static constexpr AllHeld<System::kBlockCoordinates> kHeld;
    const FineLayout& fine = System::kFineLayout[block];
    if (fine.count == 0) return false;
    b = block;
    const BlockLayout& of = System::kBlockLayout[b];
    const FineStructure structure = {System::kFineBlock + fine.first_block,
                                     fine.count,
                                     System::kFineRow + fine.first_place,
                                     System::kFineColumn + fine.first_place,
                                     System::kFineEarlier + fine.first_earlier,
                                     System::kFineOther + fine.first_other,
                                     fine_others<System>(b),
                                     of.coordinates,
                                     fine.largest};
    solution.rows = rows;
    solution.others = others;
    return solve_finely(structure, terms.Jz + of.first_jacobian, terms.Phi + of.first_equation,
                        told == nullptr ? terms.c + of.first_equation : nullptr,
                        holds ? kHeld.is : System::kBlockDriven + of.first_coordinate,
                        least * static_cast<Real>(of.pivot), solution, work, places, movable, told);
  }

  bool is_driven(int column) const noexcept {
    return System::kBlockDriven[System::kBlockLayout[b].first_coordinate + column] != 0;
  }
  /// See ByFactors.
  void directions(Real* rz) const noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    for (int t = 0; t < solution.other_count; ++t) {
      if (is_driven(others[t])) continue;
      int q = 0;
      for (int s = 0; s < solution.other_count; ++s) q += others[s] < others[t] && !is_driven(others[s]) ? 1 : 0;
      for (int c = 0; c < block.coordinates; ++c) rz[c * block.free + q] = solution.row(c)[t];
    }
  }
  void closing(Real* x) const noexcept { put(solution.other_count, x); }
  void moving(Real* x) const noexcept { put(-1, x); }
  void accelerating(Real* x) const noexcept { put(solution.other_count + 1, x); }
  Real smallest_pivot() const noexcept { return solution.smallest_pivot; }
  /// The columns of the block, dependent ones first.
  void order(int* columns) const noexcept {
    const int coordinates = System::kBlockLayout[b].coordinates;
    int first = 0, last = coordinates - solution.other_count;
    for (int c = 0; c < coordinates; ++c) {
      bool is_other = false;
      for (int t = 0; t < solution.other_count; ++t) is_other = is_other || others[t] == c;
      columns[is_other ? last++ : first++] = c;
    }
  }

 private:
  /// x of all columns by those of the others, with a right-hand side unless it is -1.
  void put(int right_hand_side, Real* x) const noexcept {
    Real given[kOthers] = {};
    for (int t = 0; t < solution.other_count; ++t) given[t] = x[others[t]];
    for (int c = 0; c < System::kBlockLayout[b].coordinates; ++c) {
      const Real* const row = solution.row(c);
      x[c] = right_hand_side < 0 ? Real(0) : row[right_hand_side];
      for (int t = 0; t < solution.other_count; ++t) x[c] += row[t] * given[t];
    }
  }
};

/// Solves block b of `terms`, fine block by fine block where it has these, and calls use(solution). right_hand_side: a
/// number per equation, see ByFactors. Result: the notice of the block, see notice_of; loop_singular, without a call,
/// where it has lost its rank.
template <class System, class Use>
Status solve_block(int b, typename System::ClosureTerms& terms, RealOf<System> frozen_pivot,
                   BlockFactors<System>& factors, [[maybe_unused]] ByFineBlocks<System>& fine,
                   RealOf<System>* right_hand_side, const Use& use) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  if constexpr (kHasFineBlocks<System>) {
    if (fine.solves(b, terms)) {
      fine.order(factors.columns + block.first_coordinate);
      use(fine);
      return notice_of(b, block.pivot, fine.smallest_pivot(), frozen_pivot);
    }
  }
  const LoopFactorsOf<RealOf<System>> loop = factors.factors_of(b, terms);
  if (loop.rank < block.rank) return {Code::loop_singular, b};
  use(ByFactors<System>{b, loop, terms, factors.work, right_hand_side});
  return notice_of(b, block.pivot, smallest_pivot(loop), frozen_pivot);
}

/// The most important notice about the blocks at a position. pivot: of the frozen partition, per block. Fails:
/// loop_singular. No cost unless the frozen pivots are small.
template <class System>
Status notice_at(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                 const typename System::State& state, const RealOf<System>* pivot) noexcept {
  Status notice;
  if constexpr (kRegularOnly<System>) {
    if (!is_far<System>(pivot)) notice = {kNotRegular, -1};
  } else if constexpr (kChoosesAgain<System>) {
    if (is_far<System>(pivot)) return {};
    typename System::ClosureTerms terms;
    System::closure_terms(parameters, inputs, state, terms);
    BlockFactors<System> factors;
    [[maybe_unused]] ByFineBlocks<System> fine;
    for (int b = 0; b < System::kBlocks; ++b) {
      if (pivot[b] >= kNearSingular<RealOf<System>>) continue;
      const Status of_block = solve_block<System>(b, terms, pivot[b], factors, fine, nullptr, [](const auto&) {});
      if (!of_block.ok()) return of_block;
      notice = graver(notice, of_block);
    }
  } else {
    notice = frozen_status<System>(pivot);
  }
  return notice;
}

}  // namespace solver_detail

}  // namespace mbgen
