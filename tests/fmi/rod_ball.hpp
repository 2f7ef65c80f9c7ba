#pragma once
// The motion of tests/data/fmi/rod_ball.json by equations of its own: the turn of the arm as a matrix, its angular
// velocity, and the force of the rod as the one multiplier. A thin rod with one end at rest adds to the arm a third of
// its mass, and half of its weight, at the other end.

#include <array>
#include <cmath>
#include <vector>

namespace rod_ball {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr double kMass = 2, kRodMass = 0.3, kGravity = 9.81;
constexpr Vector kCentre = {0, 0, -0.5}, kInertia = {0.28, 0.3, 0.05}, kEnd = {0.1, 0, -0.6}, kPost = {0.3, 0.2, 0.8},
                 kTip = {0.3, 0.1, -1};

struct Motion {
  std::array<Vector, 3> turn = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< rows: from the arm to the ground
  Vector rate{};                                                     ///< rad/s, in the arm

  Vector point(const Vector& p) const { return {dot(turn[0], p), dot(turn[1], p), dot(turn[2], p)}; }
};

/// Angular momentum about the ball of an angular velocity.
inline Vector momentum(const Vector& w) {
  Vector result = {kInertia[0] * w[0], kInertia[1] * w[1], kInertia[2] * w[2]};
  for (const auto& [mass, p] : {std::pair{kMass, kCentre}, std::pair{kRodMass / 3, kEnd}}) {
    const Vector of_point = cross(p, cross(w, p));
    for (int i = 0; i < 3; ++i) result[i] += mass * of_point[i];
  }
  return result;
}

/// The angular velocity of an angular momentum, by Cramer's rule.
inline Vector rate_of(const Vector& h) {
  const Vector a = momentum({1, 0, 0}), b = momentum({0, 1, 0}), c = momentum({0, 0, 1});
  const double d = dot(a, cross(b, c));
  return {dot(h, cross(b, c)) / d, dot(h, cross(c, a)) / d, dot(h, cross(a, b)) / d};
}

inline Motion rates(const Motion& at) {
  Vector down, post, torque, arm;
  for (int i = 0; i < 3; ++i) {
    down[i] = -kGravity * at.turn[2][i];
    post[i] = at.turn[0][i] * kPost[0] + at.turn[1][i] * kPost[1] + at.turn[2][i] * kPost[2];
    arm[i] = kMass * kCentre[i] + kRodMass / 2 * kEnd[i];
  }
  const Vector& w = at.rate;
  const Vector weight = cross(arm, down), gyro = cross(w, momentum(w)), speed = cross(w, kEnd);
  for (int i = 0; i < 3; ++i) torque[i] = weight[i] - gyro[i];
  const Vector along = {kEnd[0] - post[0], kEnd[1] - post[1], kEnd[2] - post[2]}, lever = cross(kEnd, along);
  // along . (w' x end + w x speed) + speed^2 = 0
  const Vector alone = rate_of(torque), by_force = rate_of(lever);
  const double force = -(dot(along, cross(w, speed)) + dot(speed, speed) + dot(lever, alone)) / dot(lever, by_force);
  Motion result;
  for (int k = 0; k < 3; ++k) {
    const Vector& row = at.turn[k];
    result.turn[k] = {row[1] * w[2] - row[2] * w[1], row[2] * w[0] - row[0] * w[2], row[0] * w[1] - row[1] * w[0]};
    result.rate[k] = alone[k] + force * by_force[k];
  }
  return result;
}

inline Motion moved(const Motion& from, const Motion& by, double h) {
  Motion result = from;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) result.turn[k][i] += h * by.turn[k][i];
    result.rate[k] += h * by.rate[k];
  }
  return result;
}

/// x, y and z of the tip in m, and the sine of the second angle, every `width` seconds: Runge-Kutta in steps of 1e-4 s,
/// which leaves 4e-9 m after 3 s. rate: rad/s, at the start, where the angles are zero.
inline std::vector<std::array<double, 4>> rows(const Vector& rate, double width, int count) {
  constexpr double h = 1e-4;
  Motion at;
  at.rate = rate;
  std::vector<std::array<double, 4>> result;
  const int steps = static_cast<int>(std::lround(width / h));
  for (int row = 0; row <= count; ++row) {
    const Vector tip = at.point(kTip);
    result.push_back({tip[0], tip[1], tip[2], -at.turn[0][1]});
    for (int i = 0; i < steps && row < count; ++i) {
      const Motion a = rates(at), b = rates(moved(at, a, h / 2)), c = rates(moved(at, b, h / 2)),
                   d = rates(moved(at, c, h));
      at = moved(moved(moved(moved(at, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
    }
  }
  return result;
}

}  // namespace rod_ball
