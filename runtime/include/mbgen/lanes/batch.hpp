#pragma once
// Accelerations, closures, multipliers and outputs of several instances in lanes, by the frozen programs alone. Each
// function says which lanes are good: there the scalar solver would have gone the same way, with the same bits.
// Numbers in the other lanes mean nothing; the caller solves them one by one.
//
// `System` is defined as in blocks.hpp, with rows (rows.hpp) in place of doubles: Row, Mask, kLanes, kGroups, tables
// and types. Its programs take structs of vectors, one a group, see run_groups; Parameters and Inputs belong to one
// group. Beyond it inputs_at(inputs, dt), the inputs of a group dt seconds later.

#include <limits>

#include "mbgen/batch_status.hpp"
#include "mbgen/blocks.hpp"
#include "mbgen/lanes.hpp"
#include "mbgen/motion.hpp"
#include "mbgen/solver/closure.hpp"
#include "mbgen/solver/rows.hpp"
#include "mbgen/solver/states.hpp"

namespace mbgen {

template <class System>
using ParametersOf = Grouped<typename System::Parameters, System::kGroups>;
template <class System>
using InputsOf = Grouped<typename System::Inputs, System::kGroups>;

namespace batch_detail {

template <class System>
constexpr typename System::Mask every_lane() noexcept {
  return ~typename System::Mask{};
}

/// Sum of the first `count` rows with four accumulators, to halve the waiting twice: each by its name, for compilers
/// keep an array of them in memory.
template <class Row>
[[gnu::always_inline]] inline Row sum(const Row* rows, int count) noexcept {
  Row a{}, b{}, c{}, d{};
  int i = 0;
  for (; i + 3 < count; i += 4) {
    a += rows[i];
    b += rows[i + 1];
    c += rows[i + 2];
    d += rows[i + 3];
  }
  for (; i < count; ++i) a += rows[i];
  return (a + b) + (c + d);
}

template <class Row>
[[gnu::always_inline]] inline MaskOf<Row> is_finite(const Row& value) noexcept {
  return value - value == 0.0;
}

/// Lanes whose arguments are surely finite; forces may be null.
template <class System>
typename System::Mask arguments_are_finite(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                           const typename System::State& state,
                                           const typename System::JointForces* forces) noexcept {
  typename System::Row total;
  for (int g = 0; g < System::kGroups; ++g)
    part_of(total, g) = System::argument_sum(parameters.group[g], inputs.group[g]);
  total += state.t;
  total += sum(state.z, System::kCoordinates) + sum(state.zd, System::kCoordinates);
  total += sum(state.x, System::kAuxiliaryStates);
  if (forces != nullptr) total += sum(forces->tau, System::kCoordinates);
  return is_finite(total);
}

/// Lanes in which every ball is in the chart that the frozen programs know.
template <class System>
typename System::Mask in_users_chart([[maybe_unused]] const typename System::State& state) noexcept {
  typename System::Mask good = every_lane<System>();
  if constexpr (kChartsOf < typename System::State >> 0) {
    for (int b = 0; b < System::kBalls; ++b) good &= state.charts[b] <= 0.5;
  }
  return good;
}

/// Lanes whose balls are far from their poles as well: no chart changes at the start of a step.
template <class System>
typename System::Mask keeps_charts([[maybe_unused]] const typename System::State& state) noexcept {
  typename System::Mask good = in_users_chart<System>(state);
  if constexpr (kChartsOf < typename System::State >> 0) {
    for (const Ball& ball : System::kBall) good &= mbgen::abs(state.z[ball.coordinate[1]]) < ball_detail::kFarFromPole;
  }
  return good;
}

/// Lanes in which every block has at least this pivot over its reference.
template <class System, class Row>
typename System::Mask pivots_reach(const Row* pivot, double threshold) noexcept {
  typename System::Mask good = every_lane<System>();
  for (int b = 0; b < System::kBlocks; ++b) good &= pivot[b] >= threshold;
  return good;
}

/// The larger, NaN counting as larger than every value before it.
template <class Row>
[[gnu::always_inline]] inline Row larger(const Row& size, const Row& largest) noexcept {
  return choose(size <= largest, largest, size);
}

/// Largest residual of the equations whose redundancy flag is `redundant`.
template <class System>
typename System::Row largest_residual(const typename System::Closure& closure, unsigned char redundant) noexcept {
  typename System::Row largest{};
  for (int e = 0; e < System::kEquations; ++e) {
    if (System::kRedundant[e] == redundant) largest = larger(mbgen::abs(closure.residual[e]), largest);
  }
  return largest;
}

template <class System>
typename System::Row largest_driven_step(const typename System::Closure& closure) noexcept {
  typename System::Row largest{};
  for (int i = 0; i < System::kCoordinates; ++i) {
    if (System::kDriven[i] != 0) largest = larger(mbgen::abs(closure.dz[i]), largest);
  }
  return largest;
}

/// z += dz in the lanes of the mask, shortened where a coordinate outside the motions would jump.
template <class System>
void apply_step(const typename System::Closure& closure, const typename System::Mask& mask,
                typename System::State& state) noexcept {
  using Row = typename System::Row;
  Row largest{};
  for (int i = 0; i < System::kCoordinates; ++i) {
    if (System::kDriven[i] != 0) continue;
    const Row size = mbgen::abs(closure.dz[i]);
    largest = choose(size > largest, size, largest);
  }
  const Row one = Row{} + 1.0;
  const Row factor = choose(largest > kLargestNewtonStep<double>, kLargestNewtonStep<double> / largest, one);
  for (int i = 0; i < System::kCoordinates; ++i) {
    const Row step = System::kDriven[i] != 0 ? closure.dz[i] : factor * closure.dz[i];
    take(mask, state.z[i] + step, state.z[i]);
  }
}

/// Accepts the closed positions in the lanes of the mask. Result: where that holds.
template <class System>
typename System::Mask accept(const typename System::Closure& closure, const typename System::Mask& mask,
                             typename System::State& trial) noexcept {
  for (int i = 0; i < System::kCoordinates; ++i) {
    if (System::kDriven[i] != 0) take(mask, trial.z[i] + closure.dz[i], trial.z[i]);
    take(mask, closure.zd[i], trial.zd[i]);
  }
  typename System::Row total = sum(closure.zd, System::kCoordinates);
  if constexpr (System::kDrives > 0) total += sum(trial.z, System::kCoordinates);
  return (largest_residual<System>(closure, 1) <= kRedundantTolerance<double>)&is_finite(total);
}

/// Lanes in which a block is hardly corrected, see is_slight of closure.hpp.
template <class System>
typename System::Mask is_slight(const BlockLayout& block, const typename System::State& state,
                                const typename System::Closure& closure) noexcept {
  constexpr double limit = kSlightCorrection<double> * System::kClosureTolerance;
  typename System::Mask slight = every_lane<System>();
  for (int c = block.first_coordinate; c < block.first_coordinate + block.coordinates; ++c) {
    const int i = System::kBlockCoordinate[c];
    slight &= (mbgen::abs(closure.dz[i]) <= limit) & (mbgen::abs(closure.zd[i] - state.zd[i]) <= limit);
  }
  return slight;
}

/// Shortens dz and zd of the blocks and lanes whose frozen partition is not a fair choice, see is_unfair of
/// closure.hpp. open: lanes that matter.
template <class System>
void shorten_unfair(const typename System::Mask& open, const typename System::State& state,
                    typename System::Closure& closure) noexcept {
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    typename System::Mask unfair = open & (closure.pivot[b] < kFairPivot<double>);
    if (block.free == 0 || bits_of(unfair) == 0) continue;
    unfair &= ~is_slight<System>(block, state, closure);
    if (bits_of(unfair) == 0) continue;
    solver_detail::shorten_block<System>(b, state, closure,
                                         [&](const auto& value, auto& to) { take(unfair, value, to); });
  }
}

/// Newton on z and t of `trial`, far from singular positions; at the end its velocities are consistent. wanted: lanes
/// that matter. Result: the lanes that came through.
template <class System, solver_detail::Correction correction>
typename System::Mask close_lanes(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                  const typename System::Mask& wanted, typename System::State& trial) noexcept {
  using Row = typename System::Row;
  using Mask = typename System::Mask;
  typename System::Closure closure;
  Mask open = wanted, done{};
  Row previous = Row{} + std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration <= kNewtonIterations && bits_of(open) != 0; ++iteration) {
    run_groups(System::closure, closure, parameters, inputs, trial);
    open &= pivots_reach<System>(closure.pivot, kNearSingular<double>);
    if constexpr (correction == solver_detail::Correction::in_steps && kChoosesAgain<System>)
      shorten_unfair<System>(open, trial, closure);
    const Row misfit = largest_residual<System>(closure, 0);
    const Row driven = largest_driven_step<System>(closure);
    const Row size = choose(driven > misfit, driven, misfit);
    const Mask may_gain = iteration < kNewtonIterations ? every_lane<System>() : Mask{};
    const Mask gains = (size > 0.0) & (size < 0.5 * previous) & may_gain;
    const Mask closed = open & ((size <= System::kClosureTolerance) | (~gains & (size <= kRoundingFloor<double>)));
    done |= closed & accept<System>(closure, closed, trial);
    open &= ~closed;
    previous = size;
    apply_step<System>(closure, open, trial);
    open &= is_finite(sum(trial.z, System::kCoordinates));
  }
  return done;
}

/// Lanes in which every coordinate without a motion is within kLargestCorrection of its former value.
template <class System>
typename System::Mask stayed_near(const typename System::State& from, const typename System::State& to) noexcept {
  typename System::Mask near = every_lane<System>();
  if constexpr (System::kBlocks > 0) {
    for (const int i : System::kBlockCoordinate) {
      if (System::kDriven[i] == 0) near &= mbgen::abs(to.z[i] - from.z[i]) <= kLargestCorrection<double>;
    }
  }
  return near;
}

}  // namespace batch_detail

/// The program of all accelerations at a state. forces: null for none. least_pivot: of every block over its reference.
/// Result: the good lanes.
template <class System>
typename System::Mask evaluate_lanes(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                     const typename System::State& state, const typename System::JointForces* forces,
                                     double least_pivot, typename System::Accelerations& values) noexcept {
  using namespace batch_detail;
  static constexpr typename System::JointForces kNoForces = {};
  // First of all: that brings the arguments near, for the program as well.
  typename System::Mask good = arguments_are_finite<System>(parameters, inputs, state, forces);
  run_groups(System::accelerations, values, parameters, inputs, state, forces != nullptr ? *forces : kNoForces);
  // The array of a solver without auxiliary states has one entry all the same, and integrators integrate it.
  if constexpr (System::kAuxiliaryStates == 0) values.xd[0] = typename System::Row{};
  good &= pivots_reach<System>(values.pivot, least_pivot);
  good &= in_users_chart<System>(state);
  for (int k = 0; k < System::kFreeDirections; ++k) good &= values.inertia[k] > 0.0;
  if constexpr (constexpr int places = kHoldsOf<System>; places > 0) {
    for (int place = 0; place < places; ++place) good &= values.hold[place] >= 0.0;
  }
  return good & is_finite(sum(values.zdd, System::kCoordinates) + sum(values.xd, System::kAuxiliaryStates));
}

/// Closes every loop from the state as a guess, as project_state. Result: the good lanes.
template <class System, solver_detail::Correction correction = solver_detail::Correction::of_dependents>
typename System::Mask project_lanes(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                    typename System::State& state) noexcept {
  using namespace batch_detail;
  const typename System::Mask finite = arguments_are_finite<System>(parameters, inputs, state, nullptr);
  static_assert(System::kHasClosure || System::kEquations == 0);  // else clang++ sees a constant that nobody uses
  if constexpr (System::kHasClosure) {
    return close_lanes<System, correction>(parameters, inputs, finite & in_users_chart<System>(state), state);
  }
  return finite;
}

/// The same from a good guess, as project_motion.
template <class System>
typename System::Mask project_lanes_in_motion(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                              typename System::State& state) noexcept {
  typename System::State guess;
  integrator_detail::copy_state(state, guess);
  constexpr auto in_steps = solver_detail::Correction::in_steps;
  const typename System::Mask good = project_lanes<System, in_steps>(parameters, inputs, state);
  return good & batch_detail::stayed_near<System>(guess, state);
}

/// Multipliers and driving forces at given accelerations, as solve_multipliers. Result: the good lanes.
template <class System>
typename System::Mask constrain_lanes(const ParametersOf<System>& parameters, const InputsOf<System>& inputs,
                                      const typename System::State& state, const typename System::JointForces* forces,
                                      const typename System::Derivative& derivative,
                                      typename System::Multipliers& multipliers) noexcept {
  using namespace batch_detail;
  typename System::Mask good = arguments_are_finite<System>(parameters, inputs, state, forces);
  if constexpr (System::kHasClosure) {
    typename System::ConstraintForces values;
    run_groups(System::multipliers, values, parameters, inputs, state, *forces, derivative);
    good &= pivots_reach<System>(values.pivot, kPivotThreshold<double>) &
            is_finite(sum(values.lambda, System::kEquations) + sum(values.drive, System::kDrives));
    for (int e = 0; e < System::kEquations; ++e) multipliers.lambda[e] = values.lambda[e];
    for (int g = 0; g < System::kDrives; ++g) multipliers.drive[g] = values.drive[g];
  }
  return good;
}

/// Statuses of a call: ok for the good lanes, the status of `alone` (int lane -> Status) for the others.
template <int W, class Mask, class Alone>
LaneStatuses<W> with_the_others_alone(const Mask& good, const Alone& alone) noexcept {
  LaneStatuses<W> statuses{};
  const unsigned bits = bits_of(good);
  for (int lane = 0; lane < W; ++lane) {
    if ((bits >> lane & 1u) == 0) statuses[lane] = alone(lane);
  }
  return statuses;
}

}  // namespace mbgen
