// Every figure of every published problem within its bound.

#include "tests/system/published/published.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>

namespace mbgen::published {

void PrintTo(const Problem& problem, std::ostream* out) { *out << problem.title; }

namespace {

class Published : public ::testing::TestWithParam<Problem> {};

TEST_P(Published, IsReproduced) {
  for (const Figure& figure : GetParam().solve()) {
    std::printf("%s: %s: %.1e %s\n", GetParam().name.c_str(), figure.metric.c_str(), figure.error, figure.unit.c_str());
    EXPECT_LE(figure.error, figure.bound) << figure.metric;
  }
}

INSTANTIATE_TEST_SUITE_P(Problems, Published, ::testing::ValuesIn(problems()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace mbgen::published
