// The notice of a step in which a body turns too far: given for those coordinates alone that are looked at.

#include "mbgen/turns.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mbgen {
namespace {

constexpr double kTurnStep = 1e-3;

TEST(Turns, AreToldOfTheFastestThatIsLookedAt) {
  // A vehicle at 40 m/s, a wheel that nothing depends on, and two shafts.
  const double turning[5] = {0, 0, 1, 1, 1};
  const auto of = [&](double wheel, double first, double second) {
    const double zd[5] = {40, wheel, first, second, 0};
    return with_turns({}, zd, turning, kTurnStep, kRk4Turn);
  };
  EXPECT_EQ(of(700, 10, -10).code, Code::ok) << "a wheel";
  EXPECT_EQ(of(0, 499, 499).code, Code::ok) << "each of them within the limit";
  EXPECT_EQ(of(0, 501, 0).code, Code::turned_far);
  EXPECT_EQ(of(0, 501, -600).index, 3);
  EXPECT_TRUE(of(0, 501, -600).ok());
  EXPECT_STREQ(text(of(0, 501, -600).code), "turns too far within a step");
  EXPECT_EQ(subject_of(Code::turned_far), Subject::coordinate);
}

TEST(Turns, LeaveFailuresAndOtherNotices) {
  const double turning[1] = {1}, zd[1] = {1e4};
  for (const Code code : {Code::loop_singular, Code::chosen_again, Code::singular_met}) {
    const Status status = with_turns({code, 7}, zd, turning, kTurnStep, kRk4Turn);
    EXPECT_EQ(status.code, code);
    EXPECT_EQ(status.index, 7);
  }
}

template <std::size_t N, class Real>
void expect_every_place_is_seen() {
  Real turning[N];
  for (Real& one : turning) one = 1;
  for (std::size_t i = 0; i < N; ++i) {
    Real zd[N] = {};
    zd[i] = -1000;
    const Status status = with_turns({}, zd, turning, kTurnStep, kRk4Turn);
    EXPECT_EQ(status.code, Code::turned_far) << i << " of " << N;
    EXPECT_EQ(status.index, static_cast<int>(i)) << N;
  }
}

TEST(Turns, AreSeenAtEveryPlaceOfEveryLength) {
  expect_every_place_is_seen<1, double>();
  expect_every_place_is_seen<2, double>();
  expect_every_place_is_seen<3, double>();
  expect_every_place_is_seen<7, double>();
  expect_every_place_is_seen<16, double>();
  expect_every_place_is_seen<27, double>();
  expect_every_place_is_seen<1, float>();
  expect_every_place_is_seen<5, float>();
  expect_every_place_is_seen<33, float>();
}

}  // namespace
}  // namespace mbgen
