#pragma once
// Corrections of one loop block of a generated solver: of its dependent coordinates, and the shortest ones. `System` is
// described in blocks.hpp. Source: theory.md section 4.

#include "mbgen/blocks.hpp"

namespace mbgen {

namespace solver_detail {

/// Which of all corrections of a block is taken.
enum class Correction {
  of_dependents,  ///< independent coordinates and velocities stay; frozen partition where it is good
  in_steps,       ///< of dependents where the frozen choice is a fair one, else the shortest by its free directions
  shortest        ///< least sum of squares, which does not depend on a choice of coordinates
};

/// Largest number of free directions of a block, at least 1.
template <class System>
constexpr int most_free() noexcept {
  int most = 1;
  for (int b = 0; b < System::kBlocks; ++b) {
    most = System::kBlockLayout[b].free > most ? System::kBlockLayout[b].free : most;
  }
  return most;
}

/// Memory for the corrections of one block.
template <class System>
struct CorrectionWork {
  using Real = RealOf<System>;
  BlockFactors<System> factors;
  typename System::Projection projection;
  Real gram[most_free<System>() * most_free<System>()];
  Real along[most_free<System>()];
  Real right_hand_side[System::kEquations];
  Real solution[System::kBlockCoordinates];
};

/// dz and zd of block b by its factors: of dependents, or else the shortest. Driven coordinates take the position and
/// velocity of their motions.
template <class System, Correction correction>
void correct_block(int b, const LoopFactorsOf<RealOf<System>>& loop, const typename System::ClosureTerms& terms,
                   const typename System::State& state, CorrectionWork<System>& work,
                   typename System::Closure& closure) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
  constexpr bool is_shortest = correction != Correction::of_dependents;
  const auto shortened = [&] {
    if constexpr (is_shortest) {
      shorten(loop.coordinates, block.free, work.projection.Rz + block.first_projection, work.gram, work.along,
              work.solution);
    }
  };
  if constexpr (is_shortest) {
    free_directions(loop, System::kBlockDriven + block.first_coordinate, work.projection.Rz + block.first_projection,
                    work.factors.work);
  }
  for (int e = 0; e < block.equations; ++e) work.right_hand_side[e] = -terms.Phi[block.first_equation + e];
  for (int c = 0; c < block.coordinates; ++c) {
    work.solution[c] = System::kDriven[coordinate[c]] != 0 ? closure.dz[coordinate[c]] : RealOf<System>(0);
  }
  solve_dependent(loop, work.right_hand_side, work.solution, work.factors.work);
  shortened();
  for (int c = 0; c < block.coordinates; ++c) closure.dz[coordinate[c]] = work.solution[c];

  for (int c = 0; c < block.coordinates; ++c) {
    work.solution[c] = System::kDriven[coordinate[c]] != 0 ? closure.zd[coordinate[c]] : state.zd[coordinate[c]];
  }
  for (int e = 0; e < block.equations; ++e) work.right_hand_side[e] = 0;
  solve_dependent(loop, work.right_hand_side, work.solution, work.factors.work);
  for (int c = 0; c < block.coordinates; ++c) work.solution[c] -= state.zd[coordinate[c]];
  shortened();
  for (int c = 0; c < block.coordinates; ++c) closure.zd[coordinate[c]] = state.zd[coordinate[c]] + work.solution[c];
}

/// Shortest corrections of a block by the free directions of its frozen partition, per coordinate. Real: a row of lanes
/// as well.
template <class System>
struct ShortestCorrection {
  using Real = RealOf<System>;
  Real dz[System::kBlockCoordinates];
  Real dzd[System::kBlockCoordinates];  ///< of velocities

  /// Requires: pivots from kNearSingular on; of other lanes the numbers mean nothing.
  ShortestCorrection(int b, const typename System::State& state, const typename System::Closure& closure) noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
    for (int c = 0; c < block.coordinates; ++c) {
      dz[c] = closure.dz[coordinate[c]];
      dzd[c] = closure.zd[coordinate[c]] - state.zd[coordinate[c]];
    }
    const Real* rz = closure.Rz + block.first_projection;
    Real gram[most_free<System>() * most_free<System>()], along[most_free<System>()];
    shorten(block.coordinates, block.free, rz, gram, along, dz);
    shorten(block.coordinates, block.free, rz, gram, along, dzd);
  }
};

template <class System>
void shorten_block(int b, const typename System::State& state, typename System::Closure& closure) noexcept {
  const ShortestCorrection<System> shortest(b, state, closure);
  const BlockLayout& block = System::kBlockLayout[b];
  for (int c = 0; c < block.coordinates; ++c) {
    const int i = System::kBlockCoordinate[block.first_coordinate + c];
    if (System::kDriven[i] != 0) continue;
    closure.dz[i] = shortest.dz[c];
    closure.zd[i] = state.zd[i] + shortest.dzd[c];
  }
}

}  // namespace solver_detail

}  // namespace mbgen
