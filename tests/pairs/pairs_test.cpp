// Left and right as pairs of two lanes.

#include "compiler/pairs/pairs.hpp"

#include <gtest/gtest.h>

#include "compiler/pairs/least_cut.hpp"
#include "compiler/pairs/mirror_images.hpp"
#include "tests/pairs/small_programs.hpp"

namespace mbgen {
namespace {

using Kind = MirrorImage::Kind;

/// z[0] and z[1] are left and right, z[1] with the other sign at the image; likewise z[2] and z[3] with the same sign;
/// z[4] is on the plane and stays, z[5] turns round; z[6] is unknown to the mirror.
const std::vector<MirroredInput> kMirror = {{{Array::z, 0}, {Array::z, 1}, -1}, {{Array::z, 1}, {Array::z, 0}, -1},
                                            {{Array::z, 2}, {Array::z, 3}, 1},  {{Array::z, 3}, {Array::z, 2}, 1},
                                            {{Array::z, 4}, {Array::z, 4}, 1},  {{Array::z, 5}, {Array::z, 5}, -1}};

/// Mirror image of each output.
std::vector<MirrorImage> images_of_outputs(const Program& program) {
  const std::vector<MirrorImage> images = mirror_images(program, kMirror);
  std::vector<MirrorImage> result;
  for (const OutputValue& output : program.outputs) result.push_back(images[output.value]);
  return result;
}

void expect_same_values(const Program& program, const Program& other) {
  expect_values(program, other, inputs_of(program, 0.17), 1e-14);
}

/// Enough operations on one side to be worth a pair.
Expr side(const Expr& a, const Expr& b) {
  Expr x = a * a + b;
  for (int k = 0; k < 8; ++k) x = x * b + (x + 0.25 * k) * (x - 0.75 * b);
  return x;
}

TEST(MirrorImages, FindsPartnersWithTheirSignsHoweverTheyAreSpelled) {
  const Program program = program_of([](const auto& z) {
    return std::vector{z[0] * z[2] + z[2], z[3] - z[3] * z[1], z[2] * z[0] * z[4], z[1] * z[3] * z[4], z[0] + z[2]};
  });
  const std::vector<MirrorImage> found = images_of_outputs(program);
  EXPECT_EQ(found[0].kind, Kind::paired);
  EXPECT_EQ(found[1].kind, Kind::paired);
  EXPECT_EQ(found[0].first, found[1].first);
  EXPECT_NE(found[0].is_crossed, found[1].is_crossed);
  EXPECT_EQ(found[0].sign * found[1].sign, 1);
  EXPECT_EQ(found[2].first, found[3].first);
  EXPECT_EQ(found[2].sign * found[3].sign, -1);
  EXPECT_EQ(found[4].kind, Kind::lone) << "nothing is the image of z0 + z2";
}

TEST(MirrorImages, TellsWhatBothSidesShare) {
  const Program program = program_of([](const auto& z) {
    return std::vector{z[0] - z[1], z[0] + z[1], z[2] * z[3] * z[5], z[4] * z[6], z[2] - z[3] * 1.0000000000001};
  });
  const std::vector<MirrorImage> found = images_of_outputs(program);
  EXPECT_EQ(found[0].kind, Kind::shared);
  EXPECT_EQ(found[0].sign, 1);
  EXPECT_EQ(found[1].sign, -1);
  EXPECT_EQ(found[2].sign, -1);
  EXPECT_EQ(found[3].kind, Kind::unknown);
  EXPECT_NE(found[4].kind, Kind::shared) << "a number of one side differs in the thirteenth digit";
}

// The force of a spring beside a far larger one: sums with and without it are no twins however near they are.
TEST(MirrorImages, TellsASmallTermOfALargeSum) {
  const Program program = program_of([](const auto& z) {
    const Expr left = z[2] * z[2] * 1e14, right = z[3] * z[3] * 1e14;
    return std::vector{left, right, left + z[2], right + z[3]};
  });
  const std::vector<MirrorImage> found = images_of_outputs(program);
  EXPECT_EQ(found[0].first, found[1].first);
  EXPECT_EQ(found[2].first, found[3].first);
  EXPECT_NE(found[0].first, found[2].first);
}

// Rounding leaves nothing of a sine of a large number: what is known to no digit is another one's image by no chance.
TEST(MirrorImages, PairsNothingBecauseRoundingsAreLarge) {
  const Program program = program_of([](const auto& z) {
    std::vector<Expr> values;
    for (int k = 0; k < 40; ++k) {
      values.push_back(sin(z[2] * (2e13 + 1e12 * k)));
      values.push_back(sin(z[3] * (2.05e13 + 1e12 * k)));
    }
    return values;
  });
  for (const MirrorImage& image : images_of_outputs(program)) EXPECT_EQ(image.kind, Kind::lone);
}

// Both ends of a table are the same on either side: that the state is there now says nothing of other states.
TEST(MirrorImages, DoesNotTakeASaturatedValueForAConstant) {
  const Program program = program_of([](const auto& z) {
    return std::vector{min(z[2] + 100.0, 3.0) * z[4],
                       min(z[3] + 100.0, 3.0) * z[4],
                       max(z[2], -50.0),
                       sqrt(z[2] * z[2]),
                       abs(z[0]),
                       abs(z[1])};
  });
  const std::vector<MirrorImage> found = images_of_outputs(program);
  EXPECT_EQ(found[0].kind, Kind::paired);
  EXPECT_EQ(found[0].first, found[1].first);
  EXPECT_NE(found[0].is_crossed, found[1].is_crossed);
  EXPECT_EQ(found[2].kind, Kind::lone) << "it is z2 here, not everywhere";
  EXPECT_EQ(found[3].kind, Kind::lone);
  EXPECT_EQ(found[4].first, found[5].first);
  EXPECT_EQ(found[4].sign * found[5].sign, 1);
}

TEST(FoldPairs, DoesBothSidesInLanes) {
  const Program program = program_of([](const auto& z) {
    return std::vector{side(z[0], z[2]), side(-z[1], z[3]) * -1.0};
  });
  const Program folded = fold_pairs(program, kMirror);
  expect_same_values(program, folded);
  const Counts found = counts_of(folded);
  EXPECT_EQ(found.numbers, 0);
  EXPECT_EQ(2 * found.pairs, counts_of(program).numbers);
  EXPECT_EQ(count_operations(folded).total(), count_operations(program).total());
  EXPECT_EQ(count_operations(unfolded(folded)).total(), count_operations(program).total());
}

TEST(FoldPairs, SumsBothSidesInLanesOnce) {
  const Program program = program_of([](const auto& z) {
    const Expr left = side(z[0], z[2]), right = side(-z[1], z[3]);
    const Expr more_left = left * z[2], more_right = right * z[3];
    return std::vector{left + z[4] + right + more_right + more_left,
                       left - right + z[4] * more_left - more_right * z[4]};
  });
  const Program folded = fold_pairs(program, kMirror);
  expect_same_values(program, folded);
  long lanes = 0;
  for (const ValueId v : live_operations(folded)) lanes += folded.nodes[v].op == Op::second_lane;
  EXPECT_EQ(lanes, 2) << "one for each sum";
}

TEST(FoldPairs, LeavesWhatDoesNotPay) {
  const Program program = program_of([](const auto& z) { return std::vector{z[0] * z[2] + z[1] * z[3], z[4] * z[5]}; });
  EXPECT_TRUE(fold_pairs(program, kMirror).outputs.empty());
  EXPECT_TRUE(fold_pairs(program, {}).outputs.empty()) << "no mirror";
}

TEST(FoldPairs, LeavesASideAloneThatDiffersInANumber) {
  const Program program = program_of([](const auto& z) {
    return std::vector{side(z[0], z[2]), side(-z[1], 1.001 * z[3])};
  });
  EXPECT_TRUE(fold_pairs(program, kMirror).outputs.empty());
}

TEST(FoldPairs, KeepsPassesAndLanesEqualToTheBit) {
  const Program program = program_of([](const auto& z) {
    const Expr left = side(z[0], sin(z[2])), right = side(-z[1], sin(z[3]));
    return std::vector{left * z[4] + right * z[4], left / (z[4] * z[4] + 1.5), right / (1.5 + z[4] * z[4])};
  });
  const Program folded = contract(factor_sums(fold_pairs(program, kMirror)));
  expect_same_values(program, folded);
  const Program apart = unfolded(folded);
  EXPECT_FALSE(has_pairs(apart));
  const std::vector<double> inputs(program.inputs.size(), 0.375);
  EXPECT_EQ(interpret(folded, inputs), interpret(apart, inputs));
}

TEST(Decisions, TakeTheCheapestAnswers) {
  Decisions decisions;
  const auto a = decisions.add(5, 3), b = decisions.add(1, 4), c = decisions.add(2, 9);
  decisions.add_cost(c, a, 1);  // c without a
  decisions.add_cost(b, a, 7);  // b without a: dearer than a
  const std::vector<bool> answers = decisions.decided();
  EXPECT_TRUE(answers[a]);
  EXPECT_TRUE(answers[b]);
  EXPECT_TRUE(answers[c]);
}

}  // namespace
}  // namespace mbgen
