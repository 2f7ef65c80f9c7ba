#pragma once
// Random symbolic programs for tests of the program room and of its passes.

#include <cstdint>
#include <random>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// A random program of so many operations on six inputs.
inline Program random_program(std::uint64_t seed, int operations) {
  std::mt19937_64 random(seed);
  ProgramBuilder builder("random");
  std::vector<Expr> values;
  for (int i = 0; i < 6; ++i) values.emplace_back(builder, builder.input(Array::in, i));
  const auto any = [&] { return values[random() % values.size()]; };
  for (int i = 0; i < operations; ++i) {
    const Expr a = any(), b = any();
    switch (random() % 7) {
      case 0:
        values.push_back(a + b);
        break;
      case 1:
        values.push_back(a - b);
        break;
      case 2:
        values.push_back(tanh(a) * b);
        break;
      case 3:
        values.push_back(a / (2.0 + b * b));
        break;
      case 4:
        values.push_back(sin(a));
        break;
      case 5:
        values.push_back(select(a, a, -b));
        break;
      default:
        values.push_back(a * 0.5 - 1.0);
        break;
    }
  }
  for (int i = 0; i < 8; ++i) builder.output(Array::y, i, any().value(builder));
  return builder.finish();
}

}  // namespace mbgen
