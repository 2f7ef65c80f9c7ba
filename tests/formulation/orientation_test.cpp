// Angles, quaternions and rotation vectors of every rotation, at the singular positions of the sequences and near half
// a turn too: what they say makes up the rotation again.

#include "compiler/formulation/orientation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace mbgen {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Vector3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

using Sequence = std::array<int, 3>;
using Angles = std::array<double, 3>;

/// The twelve sequences: six of three axes, six that return to the first.
std::vector<Sequence> all_sequences() {
  std::vector<Sequence> result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        if (i != j && j != k) result.push_back({i, j, k});
  return result;
}

Matrix<double> turned(const Sequence& sequence, const Angles& angles) {
  Matrix<double> r = identity<double>();
  for (int turn = 0; turn < 3; ++turn) r = r * rotation<double>(kAxes[sequence[turn]], angles[turn]);
  return r;
}

Angles angles_of(const Matrix<double>& r, const Sequence& sequence) {
  Angles result{};
  for (int turn = 0; turn < 3; ++turn) result[turn] = angle_of_turn(r, sequence, turn);
  return result;
}

double largest_entry(const Matrix<double>& m) {
  double largest = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const double entry = std::abs(detail::entry(m, row, column));
      if (!(entry <= largest)) largest = entry;  // NaN stays
    }
  return largest;
}

Matrix<double> matrix_of(const Quaternion<double>& q) {
  const auto column = [&](const Vector<double>& axis) {
    const Vector<double> once = cross(q.v, axis);
    return axis + 2.0 * (q.w * once + cross(q.v, once));
  };
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

/// Angles that are random, and all that are next to a singular position of some sequence.
std::vector<Angles> many_angles() {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Angles> result;
  for (int i = 0; i < 50; ++i) result.push_back({kPi * unit(random), kPi * unit(random), kPi * unit(random)});
  for (const double quarter : {0.0, kPi / 2, kPi, -kPi / 2})
    for (const double off : {0.0, 1e-16, 1e-12, -1e-9, 1e-6, -1e-3})
      for (const double first : {0.0, 0.3, -kPi / 2}) result.push_back({first, quarter + off, first * 2.5});
  return result;
}

TEST(Orientation, AnglesOfEverySequenceMakeUpTheRotation) {
  ASSERT_EQ(all_sequences().size(), 12);
  for (const Sequence& made : all_sequences())
    for (const Angles& angles : many_angles()) {
      const Matrix<double> r = turned(made, angles);
      for (const Sequence& asked : all_sequences()) {
        const Angles found = angles_of(r, asked);
        EXPECT_LT(largest_entry(turned(asked, found) - r), 1e-14);
        const bool returns = asked[0] == asked[2];
        EXPECT_GE(found[1], returns ? 0 : -kPi / 2);
        EXPECT_LE(found[1], returns ? kPi : kPi / 2);
      }
    }
}

TEST(Orientation, AnglesWithinTheirRangesAreFoundAgain) {
  for (const Sequence& sequence : all_sequences()) {
    const Angles angles{0.4, 1.1, -2.9}, found = angles_of(turned(sequence, angles), sequence);
    for (int turn = 0; turn < 3; ++turn) EXPECT_NEAR(found[turn], angles[turn], 1e-15);
    for (const double angle : angles_of(identity<double>(), sequence)) EXPECT_NEAR(angle, 0, 1e-29) << "of no rotation";
  }
}

TEST(Orientation, QuaternionsMakeUpTheRotationAndAreNotNegative) {
  for (const Sequence& made : all_sequences())
    for (const Angles& angles : many_angles()) {
      const Matrix<double> r = turned(made, angles);
      const Quaternion<double> q = quaternion_of(r);
      EXPECT_LT(largest_entry(matrix_of(q) - r), 2e-15);
      EXPECT_GE(q.w, 0);
      EXPECT_NEAR(q.w * q.w + dot(q.v, q.v), 1, 1e-15);
    }
}

TEST(Orientation, RotationVectorsAreAxisTimesAngle) {
  for (const Vector3& direction : {Vector3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0.6, -0.64, 0.48}, {-0.8, 0, 0.6}})
    for (const double angle : {0.0, 1e-300, 1e-17, 1e-9, 1e-4, 0.5, 2.0, 3.1, kPi - 1e-6, kPi - 1e-9}) {
      const Vector<double> found = rotation_vector(rotation<double>(direction, angle));
      EXPECT_NEAR(found.x, angle * direction[0], 4e-16 + 1e-15 * angle) << angle;
      EXPECT_NEAR(found.y, angle * direction[1], 4e-16 + 1e-15 * angle) << angle;
      EXPECT_NEAR(found.z, angle * direction[2], 4e-16 + 1e-15 * angle) << angle;
      if (direction[0] == 1) {
        EXPECT_NEAR(found.x, angle, 1e-15 * angle) << "small angles keep their digits";
      }
    }
  const Vector<double> half = rotation_vector(rotation<double>({0.6, -0.64, 0.48}, kPi));
  EXPECT_NEAR(norm(half), kPi, 1e-15);
  EXPECT_NEAR(std::abs(dot(half, Vector<double>{0.6, -0.64, 0.48})), kPi, 1e-15);
}

}  // namespace
}  // namespace mbgen
