// The committed solvers, linked as a user links them: no allocation, energy and closure over long runs, bad arguments.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "coach_mechanism.hpp"
#include "four_bar.hpp"

/// Calls of the heap by this program so far, see tests/support/heap.cpp; null under sanitizers.
extern "C" [[gnu::weak]] long heap_calls();

namespace mbgen {
namespace {

TEST(CoachMechanism, TenThousandStepsAllocateNothing) {
  if (heap_calls == nullptr) GTEST_SKIP() << "the heap is not watched under sanitizers, which have their own";
  coach_mechanism::State state{};
  state.zd[coach_mechanism::Coordinate::chassis_rx] = 0.1;
  ASSERT_TRUE(coach_mechanism::assemble({}, {}, state).ok());
  coach_mechanism::History history{};
  const long before = heap_calls();
  int failures = 0;
  for (int step = 0; step < 5000; ++step) failures += !coach_mechanism::step_rk4({}, {}, state, 1e-5).ok();
  for (int step = 0; step < 5000; ++step) failures += !coach_mechanism::step_abm4({}, {}, state, history, 1e-5).ok();
  EXPECT_EQ(heap_calls() - before, 0);
  EXPECT_EQ(failures, 0);
  void* volatile block = std::malloc(1);  // volatile, or the compiler does without
  std::free(block);
  EXPECT_GT(heap_calls(), before) << "the trap itself must see allocations";
}

/// The linkage at rest in its reference position, but for the crank's velocity.
four_bar::State turning(double crank_velocity) {
  four_bar::State state{};
  state.zd[four_bar::Coordinate::crank_pin] = crank_velocity;
  EXPECT_TRUE(four_bar::assemble({}, {}, state).ok());
  return state;
}

four_bar::Outputs outputs_of(const four_bar::State& state) {
  const double tau[four_bar::kCoordinates] = {};
  four_bar::Derivative derivative{};
  four_bar::Outputs outputs{};
  EXPECT_TRUE(four_bar::accelerations({}, {}, state, tau, derivative).ok());
  EXPECT_TRUE(four_bar::outputs({}, {}, state, tau, derivative, outputs).ok());
  return outputs;
}

// 100 s of a conservative closed linkage at 1e-4 s; the figures are the issue's. Without its spring the linkage swings:
// the spring's energy is not among the outputs, its work is.
TEST(FourBar, KeepsEnergyAndClosureOverAMillionSteps) {
  four_bar::Parameters parameters;
  parameters.k = 0;
  four_bar::State state = turning(3.0);
  const four_bar::Outputs start = outputs_of(state);
  const double energy = start.kinetic_energy + start.potential_energy;
  double drift = 0, lowest = start.kinetic_energy, highest = start.kinetic_energy, open = 0;
  for (int step = 1; step <= 1000000; ++step) {
    ASSERT_TRUE(four_bar::step_rk4(parameters, {}, state, 1e-4).ok()) << "step " << step;
    if (step % 100 != 0) continue;
    const four_bar::Outputs now = outputs_of(state);
    drift = std::max(drift, std::abs(now.kinetic_energy + now.potential_energy - energy));
    lowest = std::min(lowest, now.kinetic_energy);
    highest = std::max(highest, now.kinetic_energy);
    four_bar::ClosureResidual residual{};
    ASSERT_TRUE(four_bar::closure_residual(parameters, {}, state, residual).ok());
    open = std::max(open, residual.largest_position);
  }
  const double exchanged = highest - lowest;  // J that pass between kinetic and potential energy
  std::printf("relative energy drift %.2e, largest closure residual %.2e m\n", drift / exchanged, open);
  EXPECT_GT(exchanged, 0.1 * highest);
  EXPECT_LT(drift / exchanged, 1e-8);
  EXPECT_LT(open, 1e-12);
}

TEST(FourBar, BadArgumentsGiveAStatusAndLeaveTheStateAlone) {
  const four_bar::State good = turning(1.0);
  four_bar::State state = good;
  for (double h : {0.0, -1e-3, std::nan("")}) EXPECT_EQ(four_bar::step_rk4({}, {}, state, h).code, Code::step_invalid);
  state.zd[four_bar::Coordinate::crank_pin] = std::nan("");
  const Status status = four_bar::step_rk4({}, {}, state, 1e-3);
  EXPECT_EQ(status.code, Code::not_a_number);
  EXPECT_STREQ(four_bar::describe(status), "crank_pin");
  for (int i = 0; i < four_bar::kCoordinates; ++i) EXPECT_EQ(state.z[i], good.z[i]);
}

}  // namespace
}  // namespace mbgen
