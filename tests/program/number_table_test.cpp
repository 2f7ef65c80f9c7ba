#include "compiler/program/number_table.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "compiler/program/mixed_words.hpp"

namespace mbgen {
namespace {

TEST(NumberTable, FindsEachNumberByItsHash) {
  NumberTable table;
  constexpr std::uint32_t kCount = 100000;
  for (std::uint32_t i = 0; i < kCount; ++i) table.insert(random_word(i), i);
  for (std::uint32_t i = 0; i < kCount; ++i)
    ASSERT_EQ(table.find(random_word(i), [&](std::uint32_t number) { return number == i; }), i);
  int asked = 0;
  for (std::uint32_t i = kCount; i < 2 * kCount; ++i)
    ASSERT_EQ(table.find(random_word(i), [&](std::uint32_t) { return ++asked, false; }), NumberTable::kNone);
  EXPECT_LT(asked, 100);  // halves of hashes that are equal by chance: 2.3 are expected
}

// Hashes at the end of the array go on at its beginning, also when it grows.
TEST(NumberTable, TellsApartWhatHasOneHash) {
  NumberTable table;
  constexpr std::uint32_t kCount = 1000;
  for (const std::uint64_t hash : {~std::uint64_t{0}, std::uint64_t{0}})
    for (std::uint32_t i = 0; i < kCount; ++i) table.insert(hash, i);
  for (const std::uint64_t hash : {~std::uint64_t{0}, std::uint64_t{0}}) {
    std::vector<bool> met(kCount, false);
    EXPECT_EQ(table.find(hash, [&](std::uint32_t number) { return met[number] = true, false; }), NumberTable::kNone);
    for (std::uint32_t i = 0; i < kCount; ++i) EXPECT_TRUE(met[i]) << i;
  }
}

}  // namespace
}  // namespace mbgen
