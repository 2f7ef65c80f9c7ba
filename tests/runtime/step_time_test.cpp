// Steps of a run, as `simulate` and FMUs count them.
#include "mbgen/solver/step_time.hpp"

#include <gtest/gtest.h>

namespace mbgen {
namespace {

TEST(StepTime, WholeStepsKeepTheirSize) {
  for (const double count : {1.0, 3.0, 7.0, 700.0, 123457.0, 1e9}) {
    for (const double step : {1e-3, 1.0 / 3, 2.5e-4, 0.7}) {
      const Steps steps = steps_in(count * step, step);
      EXPECT_EQ(steps.count, count);
      EXPECT_EQ(steps.size, step);
    }
  }
  EXPECT_EQ(steps_in(10, 0.0003333333333).count, 30000);  // a step that was rounded to ten digits
}

TEST(StepTime, OtherTimesAreDividedIntoSmallerSteps) {
  const Steps half = steps_in(20.5e-3, 1e-3);
  EXPECT_EQ(half.count, 21);
  EXPECT_EQ(half.size, 20.5e-3 / 21);
  const Steps part = steps_in(0.4e-3, 1e-3);
  EXPECT_EQ(part.count, 1);
  EXPECT_EQ(part.size, 0.4e-3);
  EXPECT_EQ(steps_in(3.00001e-3, 1e-3).count, 4);
}

TEST(StepTime, TimesAreMultiplesAndNoSums) {
  const double start = 0.3, step = 1e-3;
  double t = start, sum = start;
  for (int i = 1; i <= 100000; ++i) {
    t = at_whole_steps(start, t + step, step);
    sum += step;
    ASSERT_EQ(t, time_after(start, i, step));
  }
  EXPECT_NE(sum, t);
  EXPECT_EQ(at_whole_steps(start, 0.3005, step), 0.3005);
}

}  // namespace
}  // namespace mbgen
