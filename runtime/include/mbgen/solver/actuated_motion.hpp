#pragma once
// Free directions of a mechanism at one position, by pivots chosen there, and what actuators see of them. `System` is
// described in blocks.hpp; beyond it one with actuators offers the program `actuators` with its result ActuatorTerms,
// kActuators, kActuatorScale (one over the root of each weight) and kTypicalActuation.

#include "mbgen/blocks.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver.hpp"
#include "mbgen/solver/orthonormal.hpp"

namespace mbgen {

/// Smallest pivot of an actuator, over its median in the analysed configurations, with which forces are given: below it
/// they are fifty times what they usually are, and lose two digits. Of pivots chosen at run time the same share of the
/// smallest speed of the actuators.
template <class Real>
inline constexpr Real kLeastActuation = Real(0.02);

namespace solver_detail {

/// Factors of the loops and directions of the actuators at one position.
template <class System>
struct ActuatedMotion {
  using Real = RealOf<System>;
  static constexpr int n = System::kCoordinates, directions = System::kFreeDirections, count = System::kActuators;

  typename System::ActuatorTerms seen;
  Real basis[n * directions];       ///< orthonormal free directions, row by row
  Real speeds[count * directions];  ///< of the actuators along them, scaled by weights; then orthonormal
  Real r[directions * directions];
  int order[directions];
  Real work[directions];
  Real smallest;  ///< speed of the actuators along a free direction, over the typical one

  /// Factors of the blocks; empty without loops.
  struct Loops {
    typename System::ClosureTerms terms;
    BlockFactors<System> factors;
    LoopFactorsOf<Real> of_block[System::kBlocks > 0 ? System::kBlocks : 1];
    Real right_hand_side[System::kEquations > 0 ? System::kEquations : 1];
    ByFactors<System> solution(int b) noexcept { return {b, of_block[b], terms, factors.work, right_hand_side}; }
  };
  struct NoLoops {};
  std::conditional_t<(System::kBlocks > 0), Loops, NoLoops> loops;

  /// Everything at a position and its velocities. Fails: loop_singular.
  Status look(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
              const typename System::State& state) noexcept {
    System::actuators(parameters, inputs, state, seen);
    for (Real& entry : basis) entry = Real(0);
    if constexpr (System::kBlocks > 0) {
      System::closure_terms(parameters, inputs, state, loops.terms);
      for (int b = 0; b < System::kBlocks; ++b) {
        const Status status = factorise_block(b);
        if (!status.ok()) return status;
      }
    }
    for (int q = 0; q < directions; ++q)
      if (System::kFreeDirection[q].block < 0) basis[System::kFreeDirection[q].coordinate * directions + q] = Real(1);
    orthonormalise(n, directions, basis, r, order);
    for (int i = 0; i < count; ++i) {
      for (int q = 0; q < directions; ++q) {
        Real speed(0);
        for (int c = 0; c < n; ++c) speed += seen.direction[i * n + c] * basis[c * directions + q];
        speeds[i * directions + q] = System::kActuatorScale[i] * speed;
      }
    }
    smallest = orthonormalise(count, directions, speeds, r, order) / Real(System::kTypicalActuation);
    return {};
  }

  /// Fails: actuators_singular, where the actuators hardly move along a direction; its index names the coordinate that
  /// moves most.
  Status actuators_status() const noexcept {
    if (smallest >= kLeastActuation<Real>) return {};
    return {Code::actuators_singular, slowest_direction()};
  }

  /// Sets the dependent coordinates of x, driven and independent ones given, block by block: solve(solution, x of the
  /// block).
  template <class Solve>
  void each_block([[maybe_unused]] Real* x, [[maybe_unused]] const Solve& solve) noexcept {
    if constexpr (System::kBlocks > 0) {
      Real local[System::kBlockCoordinates];
      for (int b = 0; b < System::kBlocks; ++b) {
        const BlockLayout& block = System::kBlockLayout[b];
        const int* const coordinate = System::kBlockCoordinate + block.first_coordinate;
        for (int c = 0; c < block.coordinates; ++c) local[c] = x[coordinate[c]];
        solve(loops.solution(b), local);
        for (int c = 0; c < block.coordinates; ++c) x[coordinate[c]] = local[c];
      }
    }
  }

  /// Adds to x the free motion that lets the actuators move by `along`, less what they move by x: least weighted
  /// squares where they contradict one another.
  void add_along(const Real* along, Real* x) noexcept {
    Real missing[count], share[directions];
    for (int i = 0; i < count; ++i) {
      Real value = along[i];
      for (int c = 0; c < n; ++c) value -= seen.direction[i * n + c] * x[c];
      missing[i] = System::kActuatorScale[i] * value;
    }
    solve_least_squares(count, directions, speeds, r, order, missing, share, work);
    for (int c = 0; c < n; ++c)
      for (int q = 0; q < directions; ++q) x[c] += basis[c * directions + q] * share[q];
  }

  /// Least weighted forces of the actuators with the same virtual work as generalised forces tau on the coordinates.
  void forces_for(const Real* tau, Real* force) noexcept {
    Real along[directions];
    for (int q = 0; q < directions; ++q) {
      along[q] = Real(0);
      for (int c = 0; c < n; ++c) along[q] += basis[c * directions + q] * tau[c];
    }
    solve_least_norm(count, directions, speeds, r, order, along, force, work);
    for (int i = 0; i < count; ++i) force[i] *= System::kActuatorScale[i];
  }

 private:
  Status factorise_block([[maybe_unused]] int b) noexcept {
    if constexpr (System::kBlocks > 0) {
      const BlockLayout& block = System::kBlockLayout[b];
      loops.of_block[b] = loops.factors.factors_of(b, loops.terms);
      const LoopFactorsOf<Real>& loop = loops.of_block[b];
      const bool is_regular =
          loop.rank == block.rank && smallest_pivot(loop) >= kSingular<Real> * static_cast<Real>(block.pivot);
      if (block.rank > 0 && !is_regular) return {Code::loop_singular, b};
      if (block.free == 0) return {};
      Real rz[System::kBlockCoordinates * (directions > 0 ? directions : 1)];
      loops.solution(b).directions(rz);
      for (int q = 0; q < directions; ++q) {
        const FreeDirection& direction = System::kFreeDirection[q];
        if (direction.block != b) continue;
        for (int c = 0; c < block.coordinates; ++c)
          basis[System::kBlockCoordinate[block.first_coordinate + c] * directions + q] =
              rz[c * block.free + direction.place];
      }
    }
    return {};
  }

  /// The free direction whose coordinate moves most where the actuators move least.
  int slowest_direction() const noexcept {
    Real share[directions], motion[directions];
    constexpr int last = directions - 1;
    for (int k = last; k >= 0; --k) {
      Real value = k == last ? Real(1) : Real(0);
      for (int j = k + 1; j < last + 1 && k < last; ++j) value -= r[k * directions + j] * motion[j];
      motion[k] = k == last ? value : value / r[k * directions + k];
    }
    for (int k = 0; k < directions; ++k) share[order[k]] = motion[k];
    int most = 0;
    Real largest(-1);
    for (int q = 0; q < directions; ++q) {
      Real moved(0);
      for (int k = 0; k < directions; ++k)
        moved += basis[System::kFreeDirection[q].coordinate * directions + k] * share[k];
      if (magnitude(moved) > largest) largest = magnitude(moved), most = q;
    }
    return most;
  }
};

}  // namespace solver_detail

}  // namespace mbgen
