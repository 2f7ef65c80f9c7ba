#pragma once
// Coordinates of balls as the model counts them, whichever chart the state is in: for expressions and outputs. The
// formulas of runtime/include/mbgen/charts.hpp over T.

#include <algorithm>
#include <iterator>
#include <utility>

#include "compiler/formulation/constants.hpp"

namespace mbgen {

/// Positions, rates and accelerations of all coordinates.
template <class T>
struct Coordinates {
  std::vector<T> z, zd, zdd;
};

namespace detail {

/// Angles of chart 0 of a ball that is in chart 1, with rates and accelerations, right-handed.
template <class T>
struct UsersAngles {
  T z[3], zd[3], zdd[3];
};

/// z, zd, zdd: angles, rad, rates and accelerations of chart 1, right-handed.
template <class T>
UsersAngles<T> users_angles(const T (&z)[3], const T (&zd)[3], const T (&zdd)[3]) {
  using std::atan2, std::cos, std::sin;
  const T tiny(1e-30);
  T s[3], c[3];
  for (int k = 0; k < 3; ++k) s[k] = sin(z[k]), c[k] = cos(z[k]);
  // The turn of chart 1 and its motion, in the axes that chart 1 starts from, then in those of chart 0: rows 3, 2, -1.
  const Vector<T> row1{c[1] * c[2], -(c[1] * s[2]), s[1]};
  const Vector<T> row2{c[0] * s[2] + s[0] * s[1] * c[2], c[0] * c[2] - s[0] * s[1] * s[2], -(s[0] * c[1])};
  const T row3_z = c[0] * c[1];
  const T along2 = c[1] * zd[2], change3 = c[1] * zdd[2] + zd[0] * zd[1] - s[1] * zd[1] * zd[2];
  const T change2 = zdd[1] - c[1] * zd[0] * zd[2];
  const Vector<T> v{s[0] * zd[1] + c[0] * along2, c[0] * zd[1] - s[0] * along2, -(zd[0] + s[1] * zd[2])};
  const Vector<T> w{s[0] * change2 + c[0] * change3, c[0] * change2 - s[0] * change3,
                    -(zdd[0] + s[1] * zdd[2] + c[1] * zd[1] * zd[2])};
  UsersAngles<T> u;
  u.z[0] = atan2(-row2.z, tiny - row1.z);
  const T us = sin(u.z[0]), uc = cos(u.z[0]);
  const T sine = row3_z, cosine = -(uc * row1.z + us * row2.z);
  u.z[1] = atan2(sine, cosine);
  u.z[2] = atan2(uc * row2.x - us * row1.x, uc * row2.y - us * row1.y);
  const T reciprocal = cosine / (cosine * cosine + tiny);
  u.zd[1] = uc * v.y + us * v.z;
  u.zd[2] = (uc * v.z - us * v.y) * reciprocal;
  u.zd[0] = v.x - sine * u.zd[2];
  u.zdd[1] = uc * w.y + us * w.z + cosine * u.zd[0] * u.zd[2];
  u.zdd[2] = (uc * w.z - us * w.y - u.zd[0] * u.zd[1] + sine * u.zd[1] * u.zd[2]) * reciprocal;
  u.zdd[0] = w.x - sine * u.zdd[2] - cosine * u.zd[1] * u.zd[2];
  return u;
}

}  // namespace detail

/// All coordinates, those of balls in chart 1 counted as the model counts them. Finite in every position.
template <class T>
Coordinates<T> users_coordinates(const Environment<T>& environment, const std::vector<T>& zdd) {
  Coordinates<T> all{environment.z, environment.zd, zdd};
  for (std::size_t b = 0; b < environment.charts.size(); ++b) {
    const Ball& ball = environment.topology->balls[b];
    T z[3], rate[3], change[3];
    const T sign[3] = {T(1.0), T(1.0), T(ball.hand)};
    for (int k = 0; k < 3; ++k) {
      const int i = ball.coordinate[k];
      z[k] = sign[k] * all.z[i];
      rate[k] = sign[k] * all.zd[i];
      change[k] = sign[k] * all.zdd[i];
    }
    const detail::UsersAngles<T> users = detail::users_angles(z, rate, change);
    const T is_other = environment.charts[b] - T(0.5);
    for (int k = 0; k < 3; ++k) {
      const int i = ball.coordinate[k];
      all.z[i] = select(is_other, sign[k] * users.z[k], all.z[i]);
      all.zd[i] = select(is_other, sign[k] * users.zd[k], all.zd[i]);
      all.zdd[i] = select(is_other, sign[k] * users.zdd[k], all.zdd[i]);
    }
  }
  return all;
}

/// Whether an expression of the model looks at an angle of a ball with charts.
inline bool looks_at_balls(const Model& model, const Topology& topology) {
  using Kind = ExpressionNode::Kind;
  const auto is_of_ball = [&](const ExpressionNode& node) {
    if (node.kind != Kind::position && node.kind != Kind::velocity) return false;
    const int i = tree_coordinate(topology, node.coordinate);
    return std::any_of(topology.balls.begin(), topology.balls.end(), [i](const Ball& ball) {
      return std::find(std::begin(ball.coordinate), std::end(ball.coordinate), i) != std::end(ball.coordinate);
    });
  };
  return std::any_of(model.expressions.begin(), model.expressions.end(), [&](const Expression& expression) {
    return std::any_of(expression.nodes.begin(), expression.nodes.end(), is_of_ball);
  });
}

/// Gives expressions the coordinates as the model counts them, where one looks at balls.
template <class T>
void count_as_the_model(const Model& model, Environment<T>& environment) {
  environment.users_z.clear();
  environment.users_zd.clear();
  if (environment.charts.empty() || !looks_at_balls(model, *environment.topology)) return;
  Coordinates<T> users = users_coordinates(environment, std::vector<T>(environment.z.size(), T(0.0)));
  environment.users_z = std::move(users.z);
  environment.users_zd = std::move(users.zd);
}

}  // namespace mbgen
