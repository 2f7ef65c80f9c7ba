#pragma once
// Loop closures whose independent coordinates the caller holds: an integrator outside of the solver that has them as
// its states, as an importer of an FMU does. `System` is described in blocks.hpp.

#include "mbgen/motion.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/independent_limits.hpp"

namespace mbgen {

namespace solver_detail {

/// Whether block b has the independent coordinates of the frozen partition. independent: per coordinate.
template <class System>
bool has_frozen_partition(int b, const unsigned char* independent) noexcept {
  for (int k = 0; k < System::kFreeDirections; ++k) {
    if (System::kFreeDirection[k].block == b && independent[System::kFreeDirection[k].coordinate] == 0) return false;
  }
  return true;
}

/// Factors of block b of `terms`, in place, with every coordinate dependent that is neither driven nor independent.
template <class System>
LoopFactorsOf<RealOf<System>> chosen_factors(int b, const unsigned char* independent,
                                             typename System::ClosureTerms& terms,
                                             BlockFactors<System>& factors) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  unsigned char fixed[System::kBlockCoordinates];
  for (int c = 0; c < block.coordinates; ++c) {
    const int place = block.first_coordinate + c;
    fixed[c] = System::kBlockDriven[place] != 0 || independent[System::kBlockCoordinate[place]] != 0 ? 1 : 0;
  }
  return factors.factors_of(b, terms, block.rank, fixed);
}

/// Factors of the loops at one position with the independent coordinates of the frozen partition, whatever its own
/// pivots are there.
template <class System>
struct FactorsOfFrozen {
  unsigned char independent[System::kCoordinates] = {};  ///< per coordinate
  typename System::ClosureTerms terms;
  BlockFactors<System> factors;

  void look(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
            const typename System::State& state) noexcept {
    for (const FreeDirection& direction : System::kFreeDirection) independent[direction.coordinate] = 1;
    System::closure_terms(parameters, inputs, state, terms);
  }

  /// Factors of block b. Fails: loop_singular where these coordinates do not determine it.
  Status factorise(int b, LoopFactorsOf<RealOf<System>>& loop) noexcept {
    using Real = RealOf<System>;
    const BlockLayout& block = System::kBlockLayout[b];
    loop = chosen_factors<System>(b, independent, terms, factors);
    const bool is_regular =
        loop.rank == block.rank && smallest_pivot(loop) >= kSingular<Real> * static_cast<Real>(block.pivot);
    return block.rank == 0 || is_regular ? Status{} : Status{Code::loop_singular, b};
  }
};

/// Corrections that leave the independent coordinates where they are. Fails: loop_singular.
template <class System>
Status correct_dependents(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                          const typename System::State& state, const unsigned char* independent,
                          typename System::Closure& closure) noexcept {
  const bool is_other = in_other_chart(state);  // which the frozen program does not know
  const auto is_frozen = [&](int b) {
    return !is_other && closure.pivot[b] >= kPivotThreshold<RealOf<System>> &&
           has_frozen_partition<System>(b, independent);
  };
  bool all_frozen = true;
  for (int b = 0; b < System::kBlocks; ++b) all_frozen = all_frozen && is_frozen(b);
  if (all_frozen) return {};
  typename System::ClosureTerms terms;
  System::closure_terms(parameters, inputs, state, terms);
  if (is_other) copy(terms.Phi, closure.residual, System::kEquations);
  CorrectionWork<System> work;
  for (int b = 0; b < System::kBlocks; ++b) {
    if (is_frozen(b)) continue;
    const LoopFactorsOf<RealOf<System>> loop = chosen_factors<System>(b, independent, terms, work.factors);
    if (loop.rank < System::kBlockLayout[b].rank) return {Code::loop_singular, b};
    correct_block<System, Correction::of_dependents>(b, loop, terms, state, work, closure);
  }
  return {};
}

/// Takes for block b the independent coordinates that full pivoting leaves.
template <class System>
void choose_best(int b, const LoopFactorsOf<RealOf<System>>& best, unsigned char* independent) noexcept {
  const BlockLayout& block = System::kBlockLayout[b];
  const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
  for (int c = 0; c < block.coordinates; ++c) {
    independent[coordinate[c]] = System::kBlockDriven[block.first_coordinate + c] != 0 ? 0 : 1;
  }
  for (int k = 0; k < best.rank; ++k) independent[coordinate[best.columns[k]]] = 0;
}

}  // namespace solver_detail

/// Closes every loop from a near guess: independent coordinates keep their positions and velocities.
/// independent: per coordinate, 1 for the independent ones.
/// Fails: as project_state; loop_not_closed also when a coordinate would move by more than kLargestCorrection; the
/// state is then unchanged.
template <class System>
Status project_from_independent(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                                const unsigned char* independent, typename System::State& state) noexcept {
  using namespace solver_detail;
  if constexpr (kChoosesAgain<System>) {
    const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
    if (!arguments.ok()) return arguments;
    typename System::State trial;
    copy_state<System>(state, trial);
    const auto correct = [&](typename System::Closure& closure) {
      return correct_dependents<System>(parameters, inputs, trial, independent, closure);
    };
    const Status status = close_loops<System>(parameters, inputs, trial, true, correct);
    if (!status.ok()) return status;
    const int block = moved_far<System>(state, trial);
    if (block >= 0) return {Code::loop_not_closed, block};
    copy_state<System>(trial, state);
    return {};
  } else {
    static_cast<void>(independent);
    return without_notice(project_motion<System>(parameters, inputs, state));
  }
}

namespace solver_detail {

/// Factors of one block at one position, of which one set at a time is alive.
template <class System>
struct FactorisedBlocks {
  typename System::ClosureTerms terms, factored;
  BlockFactors<System> factors;

  FactorisedBlocks(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                   const typename System::State& state) noexcept {
    System::closure_terms(parameters, inputs, state, terms);
  }
  /// With the independent coordinates that are chosen.
  LoopFactorsOf<RealOf<System>> chosen(int b, const unsigned char* independent) noexcept {
    take(b);
    return chosen_factors<System>(b, independent, factored, factors);
  }
  /// Factors with the pivots of full pivoting.
  LoopFactorsOf<RealOf<System>> best(int b) noexcept {
    take(b);
    return factors.factors_of(b, factored);
  }

 private:
  void take(int b) noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    const int entries = block.equations * block.coordinates;
    copy(terms.Jz + block.first_jacobian, factored.Jz + block.first_jacobian, entries);
  }
};

/// The smallest pivot of a factorised block, 0 where it lacks rank.
template <class System>
double pivot_of(int b, const LoopFactorsOf<RealOf<System>>& loop) noexcept {
  return loop.rank < System::kBlockLayout[b].rank ? 0 : static_cast<double>(smallest_pivot(loop));
}

/// Product of the pivots of a factorised block: zero at a dead point of its independent coordinates, and smooth there.
template <class System>
double product_of_pivots(int b, const LoopFactorsOf<RealOf<System>>& loop) noexcept {
  if (loop.rank < System::kBlockLayout[b].rank) return 0;
  double product = 1;
  for (int k = 0; k < loop.rank; ++k) product *= magnitude(static_cast<double>(loop_detail::row_of(loop, k)[k]));
  return product;
}

/// Ratio of a pivot to its former largest value, or to the largest available pivot: if all are small, other coordinates
/// are no better.
inline double share_of(double pivot, double reference, double largest) noexcept {
  const double least = largest < reference ? largest : reference;
  return least > 0 ? pivot / least : 1;
}

}  // namespace solver_detail

/// Condition of the independent coordinates of each block at a closed state: the ratio of their smallest pivot to its
/// largest value since their choice, or to the best pivot at this position if that is smaller. 0 at their dead points,
/// about 1 at their choice; 1 for a block without free coordinates. reference: per block, see choose_independent.
template <class System>
void independent_condition(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                           const typename System::State& state, const unsigned char* independent,
                           const double* reference, double* service) noexcept {
  for (int b = 0; b < System::kBlocks; ++b) service[b] = 1;
  if constexpr (kChoosesAgain<System>) {
    using namespace solver_detail;
    FactorisedBlocks<System> blocks(parameters, inputs, state);
    for (int b = 0; b < System::kBlocks; ++b) {
      if (System::kBlockLayout[b].free == 0) continue;
      const double pivot = pivot_of<System>(b, blocks.chosen(b, independent));
      service[b] = share_of(pivot, reference[b], pivot_of<System>(b, blocks.best(b)));
    }
  }
}

/// Seconds until, or since, a dead point of the independent coordinates of each block, by the motion at a closed state
/// to second order; infinite where it leads to none. direction: 1 into the future, -1 into the past.
template <class System>
void dead_point_times(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                      const typename System::State& state, const typename System::Derivative& derivative,
                      const unsigned char* independent, double direction, double* times) noexcept {
  for (int b = 0; b < System::kBlocks; ++b) times[b] = HUGE_VAL;
  if constexpr (kChoosesAgain<System>) {
    using namespace solver_detail;
    constexpr double kWay = 1e-4;  // rad or m: far above rounding, and short beside the curvature of a mechanism
    double fastest = 0;
    for (const auto rate : state.zd) fastest = std::fmax(fastest, magnitude(static_cast<double>(rate)));
    if (!(fastest > 0)) return;
    const double dt = kWay / fastest;
    double product[3][System::kBlocks];
    for (int side = 0; side < 3; ++side) {
      const double at = (side - 1) * direction * dt;
      typename System::State there;
      copy_state<System>(state, there);
      for (int i = 0; i < System::kCoordinates; ++i)
        there.z[i] +=
            static_cast<RealOf<System>>(at) * (state.zd[i] + static_cast<RealOf<System>>(0.5 * at) * derivative.zdd[i]);
      FactorisedBlocks<System> blocks(parameters, inputs, there);
      for (int b = 0; b < System::kBlocks; ++b)
        product[side][b] =
            System::kBlockLayout[b].free == 0 ? 1 : product_of_pivots<System>(b, blocks.chosen(b, independent));
    }
    for (int b = 0; b < System::kBlocks; ++b) {
      // now + rate s + half s^2 = 0
      const double now = product[1][b], rate = (product[2][b] - product[0][b]) / (2 * dt),
                   half = (product[2][b] - 2 * now + product[0][b]) / (2 * dt * dt);
      const double root = rate * rate - 4 * now * half;
      if (rate < 0 && root >= 0) times[b] = 2 * now / (std::sqrt(root) - rate);
    }
  }
}

namespace solver_detail {

/// Comparison of the Jacobians of block b by its dependent coordinates at two near positions, det(A' B): negative if a
/// dead point lies between them. Redundant rows do not affect the sign.
template <class System>
struct DependentJacobians {
  int columns[System::kBlockCoordinates];
  int count = 0;
  double product[System::kBlockCoordinates * System::kBlockCoordinates];

  DependentJacobians(int b, const unsigned char* independent) noexcept {
    const BlockLayout& block = System::kBlockLayout[b];
    for (int c = 0; c < block.coordinates; ++c) {
      const int place = block.first_coordinate + c;
      if (System::kBlockDriven[place] == 0 && independent[System::kBlockCoordinate[place]] == 0) columns[count++] = c;
    }
  }
  void multiply(const BlockLayout& block, const RealOf<System>* a, const RealOf<System>* b) noexcept {
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        double sum = 0;
        for (int row = 0; row < block.equations; ++row)
          sum += static_cast<double>(a[row * block.coordinates + columns[i]]) *
                 static_cast<double>(b[row * block.coordinates + columns[j]]);
        product[i * count + j] = sum;
      }
    }
  }
  bool has_negative_determinant() noexcept {
    bool is_negative = false;
    for (int k = 0; k < count; ++k) {
      int best = k;
      for (int i = k + 1; i < count; ++i)
        if (magnitude(product[i * count + k]) > magnitude(product[best * count + k])) best = i;
      for (int j = 0; j < count && best != k; ++j) loop_detail::swap(product[k * count + j], product[best * count + j]);
      const double pivot = product[k * count + k];
      is_negative = is_negative != ((best != k) != (pivot < 0));
      for (int i = k + 1; i < count && pivot != 0; ++i) {
        const double factor = product[i * count + k] / pivot;
        for (int j = k; j < count; ++j) product[i * count + j] -= factor * product[k * count + j];
      }
    }
    return is_negative;
  }
};

/// Whether block b has the first and the third angle of a ball among its dependents, and the second has passed a pole:
/// the determinant changes its sign there as well.
template <class System>
bool passes_pole([[maybe_unused]] int b, [[maybe_unused]] const unsigned char* independent,
                 [[maybe_unused]] const typename System::State& from,
                 [[maybe_unused]] const typename System::State& to) noexcept {
  bool passes = false;
  if constexpr (kChartsOf < typename System::State >> 0) {
    const BlockLayout& block = System::kBlockLayout[b];
    for (const Ball& ball : System::kBall) {
      int dependents = 0;
      for (int place = block.first_coordinate; place < block.first_coordinate + block.coordinates; ++place) {
        const int i = System::kBlockCoordinate[place];
        if (i == ball.coordinate[0] || i == ball.coordinate[2]) dependents += independent[i] == 0 ? 1 : 0;
      }
      const int second = ball.coordinate[1];
      if (dependents == 2 && (std::cos(from.z[second]) < 0) != (std::cos(to.z[second]) < 0)) passes = !passes;
    }
  }
  return passes;
}

}  // namespace solver_detail

/// The first block of which two near closed states lie on different sides of a dead point of the independent
/// coordinates: the second is closed another way. -1 where there is none.
template <class System>
int block_with_other_side(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                          const typename System::State& from, const typename System::State& to,
                          const unsigned char* independent) noexcept {
  if constexpr (kChoosesAgain<System>) {
    using namespace solver_detail;
    typename System::ClosureTerms before, after;
    System::closure_terms(parameters, inputs, from, before);
    System::closure_terms(parameters, inputs, to, after);
    for (int b = 0; b < System::kBlocks; ++b) {
      const BlockLayout& block = System::kBlockLayout[b];
      if (block.free == 0) continue;
      DependentJacobians<System> jacobians(b, independent);
      if (jacobians.count != block.rank) continue;
      jacobians.multiply(block, before.Jz + block.first_jacobian, after.Jz + block.first_jacobian);
      if (jacobians.has_negative_determinant() != passes_pole<System>(b, independent, from, to)) return b;
    }
  }
  return -1;
}

/// Chooses other independent coordinates for the blocks where they are ill-conditioned at a closed state. reference:
/// per block, the largest value of its smallest pivot since the choice; 0 at first. worn: condition below which others
/// are chosen. Result: whether a choice has changed. Singular blocks keep theirs.
template <class System>
bool choose_independent(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                        const typename System::State& state, unsigned char* independent, double* reference,
                        double worn) noexcept {
  bool has_changed = false;
  if constexpr (kChoosesAgain<System>) {
    using namespace solver_detail;
    FactorisedBlocks<System> blocks(parameters, inputs, state);
    for (int b = 0; b < System::kBlocks; ++b) {
      const BlockLayout& block = System::kBlockLayout[b];
      if (block.free == 0) continue;
      const double pivot = pivot_of<System>(b, blocks.chosen(b, independent));
      reference[b] = pivot > reference[b] ? pivot : reference[b];
      const LoopFactorsOf<RealOf<System>> best = blocks.best(b);
      if (best.rank < block.rank) continue;
      const double largest = static_cast<double>(smallest_pivot(best));
      if (share_of(pivot, reference[b], largest) >= worn && pivot >= kBadPivot * largest) continue;
      choose_best<System>(b, best, independent);
      reference[b] = largest;
      has_changed = true;
    }
  }
  return has_changed;
}

}  // namespace mbgen
