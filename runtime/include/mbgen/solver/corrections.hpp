#pragma once
// Corrections of one loop block of a generated solver: of its dependent coordinates, and the shortest ones. `System` is
// described in blocks.hpp. Source: theory.md section 4.

#include "mbgen/blocks.hpp"
#include "mbgen/solver/block_solution.hpp"
#include "mbgen/solver/shortest.hpp"

namespace mbgen {

namespace solver_detail {

/// Which of all corrections of a block is taken.
enum class Correction {
  of_dependents,  ///< independent coordinates and velocities stay; frozen partition where it is good
  in_steps,       ///< of dependents where the frozen choice is a fair one, else the shortest by its free directions
  shortest        ///< least sum of squares, which does not depend on a choice of coordinates
};

/// Largest of a number over the blocks, at least 1.
template <class System>
constexpr int most_of_blocks(int BlockLayout::*number) noexcept {
  int most = 1;
  for (int b = 0; b < System::kBlocks; ++b) {
    most = System::kBlockLayout[b].*number > most ? System::kBlockLayout[b].*number : most;
  }
  return most;
}

/// Largest number of free directions of a block, at least 1.
template <class System>
constexpr int most_free() noexcept {
  return most_of_blocks<System>(&BlockLayout::free);
}

/// Memory for the corrections of one block.
template <class System>
struct CorrectionWork {
  using Real = RealOf<System>;
  BlockFactors<System> factors;
  ByFineBlocks<System> fine;
  typename System::Projection projection;
  Real gram[most_free<System>() * most_free<System>()];
  Real along[most_free<System>()];
  Real right_hand_side[System::kEquations];
  Real solution[System::kBlockCoordinates];
  Real told[System::kBlockCoordinates];  ///< velocities of one block
};

/// dz and zd of block b by its solution (block_solution.hpp): of dependents, or else the shortest. Driven coordinates
/// take the position and velocity of their motions.
template <class System, Correction correction, class Solution>
void correct_block(int b, const Solution& solution, const typename System::State& state, CorrectionWork<System>& work,
                   typename System::Closure& closure) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
  constexpr bool is_shortest = correction != Correction::of_dependents;
  [[maybe_unused]] RealOf<System>* const rz = work.projection.Rz + block.first_projection;
  if constexpr (is_shortest) {
    solution.directions(rz);
    factorise_gram(block.coordinates, block.free, rz, work.gram);
  }
  const auto shortened = [&] {
    if constexpr (is_shortest) shorten(block.coordinates, block.free, rz, work.gram, work.along, work.solution);
  };
  for (int c = 0; c < block.coordinates; ++c) {
    work.solution[c] = System::kDriven[coordinate[c]] != 0 ? closure.dz[coordinate[c]] : RealOf<System>(0);
  }
  solution.closing(work.solution);
  shortened();
  for (int c = 0; c < block.coordinates; ++c) closure.dz[coordinate[c]] = work.solution[c];

  for (int c = 0; c < block.coordinates; ++c) {
    work.solution[c] = System::kDriven[coordinate[c]] != 0 ? closure.zd[coordinate[c]] : state.zd[coordinate[c]];
  }
  solution.moving(work.solution);
  for (int c = 0; c < block.coordinates; ++c) work.solution[c] -= state.zd[coordinate[c]];
  shortened();
  for (int c = 0; c < block.coordinates; ++c) closure.zd[coordinate[c]] = state.zd[coordinate[c]] + work.solution[c];
}

/// The same by the factors of the whole block.
template <class System, Correction correction>
void correct_block(int b, const LoopFactorsOf<RealOf<System>>& loop, const typename System::ClosureTerms& terms,
                   const typename System::State& state, CorrectionWork<System>& work,
                   typename System::Closure& closure) noexcept {
  const ByFactors<System> solution = {b, loop, terms, work.factors.work, work.right_hand_side};
  correct_block<System, correction>(b, solution, state, work, closure);
}

/// Shortens dz and zd of a block by the free directions of its frozen partition. put(value, to) stores a new value, for
/// rows in some of the lanes. Requires: pivots from kNearSingular on where it stores.
template <class System, class Put>
void shorten_block(int b, const typename System::State& state, typename System::Closure& closure,
                   const Put& put) noexcept {
  using Real = RealOf<System>;  // a row of lanes as well
  const BlockLayout& block = System::kBlockLayout[b];
  const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
  Real dz[System::kBlockCoordinates], dzd[System::kBlockCoordinates];
  for (int c = 0; c < block.coordinates; ++c) {
    dz[c] = closure.dz[coordinate[c]];
    dzd[c] = closure.zd[coordinate[c]] - state.zd[coordinate[c]];
  }
  const Real* rz = closure.Rz + block.first_projection;
  Real gram[most_free<System>() * most_free<System>()], along[most_free<System>()];
  gram[0] = Real{};  // of blocks without free directions g++ does not see that nothing is read
  factorise_gram(block.coordinates, block.free, rz, gram);
  shorten(block.coordinates, block.free, rz, gram, along, dz);
  shorten(block.coordinates, block.free, rz, gram, along, dzd);
  for (int c = 0; c < block.coordinates; ++c) {
    const int i = coordinate[c];
    if (System::kDriven[i] != 0) continue;
    put(dz[c], closure.dz[i]);
    put(state.zd[i] + dzd[c], closure.zd[i]);
  }
}

}  // namespace solver_detail

}  // namespace mbgen
