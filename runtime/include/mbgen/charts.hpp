#pragma once
// Balls: three successive turns about axes through one point, each square to the one before. Their angles have a pole,
// where the second turn is a quarter and the first and third axes lie in one line. So a ball has two charts:
//   chart 0  R = R1(z1) R2(z2) R3(z3), the angles of the model
//   chart 1  R = K R1(z1) R2(z2) R3(z3), K a quarter turn about the second axis
// At the pole of one chart the other one is as far from its own as can be. Each chart has its own rates and
// accelerations; a change is exact but for rounding. Source: docs/method/theory.md, section 1.

#include <type_traits>

#include "mbgen/elementary.hpp"
#include "mbgen/number.hpp"
#include "mbgen/solver/ball.hpp"

namespace mbgen {

/// The other chart is taken where the cosine of the second angle of the model is below the first number, and left where
/// it is above the second. The cosine of chart 1 is then at least 0.66 wherever chart 1 is taken.
constexpr double kLeavesUsersChart = 0.65, kReturnsToUsersChart = 0.75;

namespace ball_detail {

/// Angles of a ball with rates and accelerations, the third counted positive in a right-handed order.
template <class Real>
struct Angles {
  Real z[3], zd[3], zdd[3];
};

/// Rotation of a ball with angular velocity and acceleration, in a right-handed frame before the rotation: the first
/// axis, the second, and their cross product.
template <class Real>
struct Turn {
  Real row[3][3];
  Real velocity[3], acceleration[3];
};

template <class Real>
Turn<Real> turn_of(const Angles<Real>& a) noexcept {
  Real s[3], c[3];
  for (int k = 0; k < 3; ++k) sincos(a.z[k], s[k], c[k]);
  const Real* zd = a.zd;
  // Angular motion along the first axis, the second, and their cross product.
  const Real v[3] = {zd[0] + s[1] * zd[2], zd[1], c[1] * zd[2]};
  const Real w[3] = {a.zdd[0] + s[1] * a.zdd[2] + c[1] * zd[1] * zd[2], a.zdd[1] - c[1] * zd[0] * zd[2],
                     c[1] * a.zdd[2] + zd[0] * zd[1] - s[1] * zd[1] * zd[2]};
  return {{{c[1] * c[2], -c[1] * s[2], s[1]},
           {c[0] * s[2] + s[0] * s[1] * c[2], c[0] * c[2] - s[0] * s[1] * s[2], -s[0] * c[1]},
           {s[0] * s[2] - c[0] * s[1] * c[2], s[0] * c[2] + c[0] * s[1] * s[2], c[0] * c[1]}},
          {v[0], c[0] * v[1] - s[0] * v[2], s[0] * v[1] + c[0] * v[2]},
          {w[0], c[0] * w[1] - s[0] * w[2], s[0] * w[1] + c[0] * w[2]}};
}

/// Angles of a turn, the second in [-pi/2, pi/2]. At the pole the first is any angle, the three make up the turn as
/// everywhere, and rates are the least that are finite.
template <class Real>
Angles<Real> angles_of(const Turn<Real>& turn) noexcept {
  constexpr Real kTiny = Real(1e-30);  // not an angle of pi where both numbers are zero and have a sign
  Angles<Real> a;
  a.z[0] = arc_tangent(Real(-turn.row[1][2]), Real(turn.row[2][2] + kTiny));
  Real s, c;
  sincos(a.z[0], s, c);
  const Real sine = turn.row[0][2], cosine = c * turn.row[2][2] - s * turn.row[1][2];
  a.z[1] = arc_tangent(sine, cosine);
  a.z[2] = arc_tangent(Real(c * turn.row[1][0] + s * turn.row[2][0]), Real(c * turn.row[1][1] + s * turn.row[2][1]));
  const Real reciprocal = cosine / (cosine * cosine + kTiny);
  const Real* v = turn.velocity;
  const Real* w = turn.acceleration;
  a.zd[1] = c * v[1] + s * v[2];
  a.zd[2] = (c * v[2] - s * v[1]) * reciprocal;
  a.zd[0] = v[0] - sine * a.zd[2];
  a.zdd[1] = c * w[1] + s * w[2] + cosine * a.zd[0] * a.zd[2];
  a.zdd[2] = (c * w[2] - s * w[1] - a.zd[0] * a.zd[1] + sine * a.zd[1] * a.zd[2]) * reciprocal;
  a.zdd[0] = w[0] - sine * a.zdd[2] - cosine * a.zd[1] * a.zd[2];
  return a;
}

/// A vector in the axes that the other chart starts from. sign: 1 from chart 0 to chart 1, -1 back.
template <class Real>
void take_over(Real (&v)[3], Real sign) noexcept {
  const Real first = v[0];
  v[0] = -sign * v[2];
  v[2] = sign * first;
}

template <class Real>
void take_over(Turn<Real>& turn, Real sign) noexcept {
  for (int column = 0; column < 3; ++column) {
    const Real first = turn.row[0][column];
    turn.row[0][column] = -sign * turn.row[2][column];
    turn.row[2][column] = sign * first;
  }
  take_over(turn.velocity, sign);
  take_over(turn.acceleration, sign);
}

/// Reads the numbers of a ball from arrays by coordinate; a null array is of zeros.
template <class Real>
Angles<Real> read(const Ball& ball, const Real* z, const Real* zd, const Real* zdd) noexcept {
  Angles<Real> a;
  for (int k = 0; k < 3; ++k) {
    const int i = ball.coordinate[k];
    const Real sign = k == 2 && ball.hand < 0 ? Real(-1) : Real(1);
    a.z[k] = sign * z[i];
    a.zd[k] = zd == nullptr ? Real(0) : sign * zd[i];
    a.zdd[k] = zdd == nullptr ? Real(0) : sign * zdd[i];
  }
  return a;
}

/// Inverse of `read`.
template <class Real>
void write(const Ball& ball, const Angles<Real>& a, Real* z, Real* zd, Real* zdd) noexcept {
  for (int k = 0; k < 3; ++k) {
    const int i = ball.coordinate[k];
    const Real sign = k == 2 && ball.hand < 0 ? Real(-1) : Real(1);
    z[i] = sign * a.z[k];
    if (zd != nullptr) zd[i] = sign * a.zd[k];
    if (zdd != nullptr) zdd[i] = sign * a.zdd[k];
  }
}

/// A second angle, rad, whose cosine is above kLeavesUsersChart, by a little.
constexpr double kFarFromPole = 0.863;

}  // namespace ball_detail

/// Takes the coordinates of a ball over to its other chart. to: 1 or 0, the chart that it goes to. zd, zdd: null where
/// they are not wanted; accelerations need rates.
template <class Real>
void change_chart(const Ball& ball, int to, Real* z, Real* zd, Real* zdd) noexcept {
  using namespace ball_detail;
  Turn<Real> turn = turn_of(read(ball, z, zd, zdd));
  take_over(turn, to == 1 ? Real(1) : Real(-1));
  write(ball, angles_of(turn), z, zd, zdd);
}

/// Whether a ball in `chart` should be in the other one.
template <class Real>
bool leaves_chart(const Ball& ball, Real chart, const Real* z) noexcept {
  const Real second = z[ball.coordinate[1]];
  Real s, c;
  if (!(chart > Real(0.5))) {
    if (magnitude(second) < Real(ball_detail::kFarFromPole)) return false;
    sincos(second, s, c);
    return magnitude(c) < Real(kLeavesUsersChart);
  }
  Real first_s, first_c;
  sincos(z[ball.coordinate[0]], first_s, first_c);
  sincos(second, s, c);
  const Real users_sine = c * first_c;
  return users_sine * users_sine < Real(1 - kReturnsToUsersChart * kReturnsToUsersChart);
}

/// Whether a ball should be in its other chart.
template <class Real>
bool any_leaves_chart(const Ball* balls, int count, const Real* charts, const Real* z) noexcept {
  for (int b = 0; b < count; ++b) {
    if (leaves_chart(balls[b], charts[b], z)) return true;
  }
  return false;
}

/// Puts each ball into the chart that suits its position. Result: whether one was changed. charts: per ball, 0 or 1.
template <class Real>
bool settle_balls(const Ball* balls, int count, Real* charts, Real* z, Real* zd) noexcept {
  bool changed = false;
  for (int b = 0; b < count; ++b) {
    if (!leaves_chart(balls[b], charts[b], z)) continue;
    const int to = charts[b] > Real(0.5) ? 0 : 1;
    change_chart(balls[b], to, z, zd, static_cast<Real*>(nullptr));
    charts[b] = Real(to);
    changed = true;
  }
  return changed;
}

/// Takes positions, rates and accelerations near by, as an integrator remembers them, from some charts to others.
template <class Real>
void change_charts(const Ball* balls, int count, const Real* from, const Real* to, Real* z, Real* zd,
                   Real* zdd) noexcept {
  for (int b = 0; b < count; ++b) {
    const bool is_other = to[b] > Real(0.5);
    if (is_other != (from[b] > Real(0.5))) change_chart(balls[b], is_other ? 1 : 0, z, zd, zdd);
  }
}

/// Coordinates, rates and accelerations in the angles of the model: balls in chart 1 are converted to chart 0. At the
/// pole rates are finite and without meaning. zdd: may be null.
template <class Real>
void to_users_angles(const Ball* balls, int count, const Real* charts, Real* z, Real* zd, Real* zdd) noexcept {
  for (int b = 0; b < count; ++b) {
    if (charts[b] > Real(0.5)) change_chart(balls[b], 0, z, zd, zdd);
  }
}

/// Number of charts that states have.
template <class State, class = void>
inline constexpr int kChartsOf = 0;
template <class State>
inline constexpr int kChartsOf<State, std::void_t<decltype(State::charts)>> =
    static_cast<int>(std::extent_v<decltype(State::charts)>);

/// Whether a ball of a state is not in the angles of the model.
template <class State>
bool in_other_chart([[maybe_unused]] const State& state) noexcept {
  if constexpr (kChartsOf < State >> 0) {
    using Real = std::remove_extent_t<decltype(State::charts)>;
    for (const Real chart : state.charts) {
      if (chart > Real(0.5)) return true;
    }
  }
  return false;
}

/// Charts from and to numbers that follow each other; none of a state without.
template <class Number, class State>
void read_charts([[maybe_unused]] const Number* values, [[maybe_unused]] State& state) noexcept {
  if constexpr (kChartsOf < State >> 0) {
    for (int b = 0; b < kChartsOf<State>; ++b) state.charts[b] = values[b];
  }
}
template <class State, class Number>
void write_charts([[maybe_unused]] const State& state, [[maybe_unused]] Number* values) noexcept {
  if constexpr (kChartsOf < State >> 0) {
    for (int b = 0; b < kChartsOf<State>; ++b) values[b] = state.charts[b];
  }
}

}  // namespace mbgen
