// Orientations at the start: the angles and rates that they become make up the turn that was asked for.

#include <cmath>
#include <numbers>

#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

using Rows = std::array<std::array<double, 3>, 3>;

Rows product(const Rows& a, const Rows& b) {
  Rows c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

Rows about(std::size_t axis, double angle) {
  const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
  Rows r{};
  r[axis][axis] = 1;
  r[j][j] = r[k][k] = std::cos(angle);
  r[k][j] = std::sin(angle);
  r[j][k] = -r[k][j];
  return r;
}

double value_of(const std::vector<InitialValue>& values, int component) {
  for (const InitialValue& value : values)
    if (value.coordinate.component == component) return value.value;
  ADD_FAILURE() << "no value";
  return 0;
}

Model ball(const std::string& sequence, const std::string& orientation) {
  return read(R"({ "mbgen": 1,
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
                "top": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "ball": { "type": "spherical", "from": "ground.A", "to": "top.A", "sequence": ")" +
              sequence + R"(" } },
    "initial": { "orientations": { "ball": )" +
              orientation + " } } }");
}

// The rotation vector (a, b, c) by Rodrigues' formula, and the angular velocity by the axes that the turns before left.
TEST(Orientations, BecomeAnglesOfEverySequence) {
  const double v[3] = {0.7, -0.9, 1.1}, w[3] = {0.3, -2, 5};
  const double angle = std::hypot(v[0], v[1], v[2]), s = std::sin(angle) / angle,
               c = (1 - std::cos(angle)) / (angle * angle);
  const Rows cross{{{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}}}, square = product(cross, cross);
  for (const std::string sequence : {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"}) {
    const Model model = ball(sequence, R"({ "rotation_vector": [0.7, -0.9, 1.1], "angular_velocity": [0.3, -2, 5] })");
    Rows turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    double velocity[3] = {};
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(sequence[static_cast<std::size_t>(k)] - 'x');
      for (std::size_t i = 0; i < 3; ++i) velocity[i] += value_of(model.initial.velocities, k) * turn[i][axis];
      turn = product(turn, about(axis, value_of(model.initial.positions, k)));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(velocity[i], w[i], 1e-13) << sequence;
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_NEAR(turn[i][j], (i == j ? 1 : 0) + s * cross[i][j] + c * square[i][j], 1e-14) << sequence << i << j;
    }
  }
}

TEST(Orientations, TakeQuaternionsOfAnyLength) {
  const Model model = ball("zyx", R"({ "quaternion": [3, 0, 0, 3] })");
  EXPECT_NEAR(value_of(model.initial.positions, 0), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(value_of(model.initial.positions, 1), 0, 1e-15);
  EXPECT_NEAR(value_of(model.initial.positions, 2), 0, 1e-15);
}

}  // namespace
}  // namespace mbgen
