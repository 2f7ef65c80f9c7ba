// Values that one thread writes and another takes over whole.

#include "mbgen/exchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace mbgen {
namespace {

struct Many {
  long values[64] = {};
};

Many all(long value) {
  Many many;
  std::fill(std::begin(many.values), std::end(many.values), value);
  return many;
}

TEST(Exchange, GivesTheLastValueOnce) {
  Exchange<Many> exchange;
  Many taken = all(7);
  EXPECT_FALSE(exchange.take(taken));
  EXPECT_EQ(taken.values[0], 7);
  exchange.publish(all(1));
  exchange.publish(all(2));
  ASSERT_TRUE(exchange.take(taken));
  EXPECT_EQ(taken.values[63], 2);
  EXPECT_FALSE(exchange.take(taken));
  exchange.publish(all(3));
  ASSERT_TRUE(exchange.take(taken));
  EXPECT_EQ(taken.values[0], 3);
}

TEST(Exchange, NeverTearsAndNeverGoesBack) {
  constexpr long kLast = 200000;
  Exchange<Many> exchange;
  std::thread writer([&] {
    for (long value = 1; value <= kLast; ++value) exchange.publish(all(value));
  });
  Many taken;
  long before = 0, torn = 0, back = 0;
  while (before < kLast) {
    if (!exchange.take(taken)) continue;
    torn += std::count(std::begin(taken.values), std::end(taken.values), taken.values[0]) != 64 ? 1 : 0;
    back += taken.values[0] <= before ? 1 : 0;
    before = taken.values[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(back, 0);
}

}  // namespace
}  // namespace mbgen
