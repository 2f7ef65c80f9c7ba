// Units of a model description in terms of the base units.

#include <gtest/gtest.h>

#include "compiler/emit/unit_exponents.hpp"

namespace mbgen {
namespace {

using Exponents = std::array<int, 8>;  // kg m s A K mol cd rad

void expect_unit(const char* unit, const Exponents& exponents, double factor = 1) {
  const std::optional<UnitExponents> meaning = unit_exponents(unit);
  ASSERT_TRUE(meaning.has_value()) << unit;
  EXPECT_EQ(meaning->exponents, exponents) << unit;
  EXPECT_DOUBLE_EQ(meaning->factor, factor) << unit;
}

TEST(UnitExponents, ReadsProductsAndQuotients) {
  expect_unit("m", {0, 1});
  expect_unit("N m", {1, 2, -2});
  expect_unit("N*m", {1, 2, -2});
  expect_unit("N.m", {1, 2, -2});
  expect_unit("N m s/rad", {1, 2, -1, 0, 0, 0, 0, -1});
  expect_unit("N/(m/s)", {1, 0, -1});
  expect_unit("kg m^2", {1, 2});
  expect_unit("1/s", {0, 0, -1});
  expect_unit("m s^-2", {0, 1, -2});
  expect_unit("rad/s^2", {0, 0, -2, 0, 0, 0, 0, 1});
  expect_unit("1", {});
}

TEST(UnitExponents, ScalesWhatIsNotSi) {
  expect_unit("km/h", {0, 1, -1}, 1000.0 / 3600);
  expect_unit("mm", {0, 1}, 1e-3);
  expect_unit("bar", {1, -1, -2}, 1e5);
  expect_unit("mm^2", {0, 2}, 1e-6);
}

TEST(UnitExponents, KnowsWhatItDoesNotKnow) {
  for (const char* unit : {"", "furlong", "N/", "N m)", "(N", "m^", "m^x", "/s", "^2"}) {
    EXPECT_FALSE(unit_exponents(unit).has_value()) << unit;
  }
}

}  // namespace
}  // namespace mbgen
