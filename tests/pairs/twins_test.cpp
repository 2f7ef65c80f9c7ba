// Twins: equal operations of parts that are no mirror images, in two lanes.

#include <gtest/gtest.h>

#include "compiler/pairs/pairs.hpp"
#include "compiler/pairs/twin_values.hpp"
#include "tests/pairs/small_programs.hpp"

namespace mbgen {
namespace {

/// z[0] and z[1] are inputs of twins, likewise z[2] and z[3]; z[4] and z[5] belong to both.
const std::vector<TwinInput> kTwins = {{{Array::z, 0}, {Array::z, 1}}, {{Array::z, 2}, {Array::z, 3}}};

void expect_values_and_bits(const Program& program, const Program& other) {
  for (const double scale : {0.17, -0.31}) {
    const std::vector<double> inputs = inputs_of(program, scale);
    expect_values(program, other, inputs, 1e-13);
    EXPECT_EQ(interpret(other, inputs), interpret(unfolded(other), inputs));
  }
}

/// Both parts in lanes, with nothing packed but two inputs.
Program expect_all_in_pairs(const Program& program) {
  Program folded = fold_twins(program, kTwins);
  expect_values_and_bits(program, folded);
  const Counts found = counts_of(folded);
  EXPECT_EQ(found.numbers, 0);
  EXPECT_EQ(2 * found.pairs, counts_of(program).numbers);
  EXPECT_EQ(found.packs, 2) << "of the inputs";
  return folded;
}

/// Enough operations of one part to be worth a pair; with numbers of its own, one of a sign of its own.
Expr part(const Expr& a, const Expr& b, double number, double offset) {
  Expr x = a * a + offset;
  for (int k = 0; k < 8; ++k) x = x * b + (x + number * (k + 1)) * (x - number * b + offset * a);
  return x;
}

TEST(FoldTwins, DoesBothPartsInLanesWithNumbersOfTheirOwn) {
  const Program program = program_of([](const auto& z) {
    return std::vector{part(z[0], z[2], 0.25, 1.5), part(z[1], z[3], 0.75, 2.5)};
  });
  const Program folded = expect_all_in_pairs(program);
  EXPECT_EQ(count_operations(folded).total(), count_operations(program).total());
}

/// A difference of which one part takes the negative.
Program program_of_signs() {
  return program_of([](const auto& z) {
    const auto one = [&](const Expr& difference, const Expr& b, double number) {
      Expr x = difference * b;
      for (int k = 0; k < 6; ++k) x = x * (difference * difference + number * (k + 1)) + difference * (b * b);
      return x * difference * z[4];
    };
    return std::vector{one(z[0] - 0.5, z[2], 0.25), one(0.75 - z[1], z[3], 0.5)};
  });
}

// The builder takes signs out of constants, so that one part adds where the other subtracts.
TEST(FoldTwins, TakesSignsIntoConstants) {
  const Program program = program_of([](const auto& z) {
    return std::vector{part(z[0], z[2], 0.25, 1.5), part(z[1], z[3], -0.75, -2.5)};
  });
  expect_all_in_pairs(program);
}

// -z1 for z1 turns signs round where no constant takes them up: squares do not mind, products carry them on.
TEST(FoldTwins, CarriesSignsOn) {
  const Program program = program_of_signs();
  const Program folded = fold_twins(program, kTwins);
  expect_values_and_bits(program, folded);
  EXPECT_EQ(counts_of(folded).numbers, 0);
}

TEST(FoldTwins, SumsBothPartsInLanesOnce) {
  const Program program = program_of([](const auto& z) {
    const Expr one = part(z[0], z[2], 0.25, 1.5), other = part(z[1], z[3], 0.75, 2.5);
    return std::vector{one + z[4] + other, one * z[2] - z[5] - other * z[3]};
  });
  const Program folded = fold_twins(program, kTwins);
  expect_values_and_bits(program, folded);
  EXPECT_EQ(counts_of(folded).lanes, 4) << "both of each sum";
}

// Each of two values of one part is alike to each of the other one; what one part takes of the other decides.
TEST(FoldTwins, PartsTwinsThatNeedOneAnother) {
  const Program program = program_of([](const auto& z) {
    const Expr one = part(z[0], z[2], 0.25, 1.5);
    const Expr other = part(z[1], z[3] + one, 0.75, 2.5);
    const Expr last = part(z[0] * other, z[2], 0.25, 1.5);
    return std::vector{one, other, last, part(z[1] * one, z[3] * last, 0.75, 2.5)};
  });
  const Program folded = fold_twins(program, kTwins);
  if (!folded.outputs.empty()) expect_values_and_bits(program, folded);
  const PairedValues values = twin_values(program, kTwins);
  for (ValueId v = 0; v < program.nodes.size(); ++v)
    if (values.images[v].kind == MirrorImage::Kind::paired && values.images[v].is_crossed) {
      std::vector<bool> needed(program.nodes.size(), false);
      needed[v] = true;
      for (ValueId u = v; u > values.images[v].first; --u)
        for (int k = 0; needed[u] && k < arity(program.nodes[u].op); ++k) needed[program.nodes[u].operands[k]] = true;
      EXPECT_FALSE(needed[values.images[v].first]) << v;
    }
}

TEST(FoldTwins, LeavesWhatDoesNotPayAndPartsThatDiffer) {
  const Program small = program_of([](const auto& z) { return std::vector{z[0] * z[2] + z[1] * z[3], z[4] * z[5]}; });
  EXPECT_TRUE(fold_twins(small, kTwins).outputs.empty());
  EXPECT_TRUE(fold_twins(small, {}).outputs.empty());
  const Program other = program_of([](const auto& z) {
    Expr x = z[1];
    for (int k = 0; k < 20; ++k) x = sqrt(x / (z[3] - x) + 2.0);
    return std::vector{part(z[0], z[2], 0.25, 1.5), x};
  });
  EXPECT_TRUE(fold_twins(other, kTwins).outputs.empty());
}

TEST(FoldTwins, PairsOnlyWhatIsEqualWhereOnePartHasMore) {
  const Program program = program_of([](const auto& z) {
    return std::vector{part(z[0], z[2], 0.25, 1.5), part(z[1] - 1.35, z[3], 0.75, 2.5) / z[3]};
  });
  const Program folded = fold_twins(program, kTwins);
  expect_values_and_bits(program, folded);
  const Counts found = counts_of(folded);
  EXPECT_EQ(found.numbers, 2) << "the shift and the division";
  EXPECT_EQ(2 * found.pairs + 2, counts_of(program).numbers);
}

TEST(FoldTwins, KeepsPassesAndLanesEqualToTheBit) {
  const Program program = program_of([](const auto& z) {
    return std::vector{part(z[0], sin(z[2]), 0.25, 1.5) / (z[4] * z[4] + 1.5),
                       part(z[1], sin(z[3]), 0.75, -2.5) / (z[4] * z[4] + 1.5)};
  });
  expect_values_and_bits(program, contract(factor_sums(fold_twins(program, kTwins))));
}

}  // namespace
}  // namespace mbgen
