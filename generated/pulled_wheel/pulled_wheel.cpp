// pulled_wheel, content hash b0d917ec774bd98f
// Made by `mbgen generate pulled_wheel.json`, mbgen 0.1.0. Change the model, not this file.
//
// Tree, each body with its coordinate, on the body before it:
//   carriage: pull, prismatic, on ground
//   arm: lower, revolute, on carriage
//   knuckle: ball, revolute, on arm
//   wheel: wheel, revolute, on knuckle
// Loop block 0, on carriage:
//   upper: rod between carriage and knuckle
//   independent: ball
//   in the accelerations: lower
//
// Frames: a body of a loop block is seen in the axes of the body that its block moves on, about that body's origin;
// every other body in its own axes. The origin of a body is the point of its joint.
//
// Names, followed by body, coordinate, loop or element:
//   m mass, h first moments, K second moments about the origin; c centre of mass, I inertia about it
//   p_<coordinate> origin of a body from that of the body before it; p_<body>_<point> a point from its body's
//     origin; l length, g gravity: numbers of the model, or what its parameters make of them
//   l0 z0 free length, free coordinate, k stiffness, d damping, f0 preload of an element; its other numbers by their
//     fields, as area_<element>
//   z zd zdd coordinate, rate, acceleration; R_<body>_x_z component z of the body's axis x; r origin; u joint axis
//   v velocity of the origin, w angular velocity, a acceleration of the origin, alpha angular acceleration
//   f n force and moment that a body needs, Q force of a joint that its closures and drives must give
//   pivot of a coordinate: of its column of the closure Jacobian (60), or of its free direction (63)
//   J entry of the closure Jacobian; Rz projection (61); zdd_star accelerations at zero free ones (62)
//   s8_12 the 12th value without a name of step 8
//   a number without a name follows from several of the model, as an inertia about the origin, or bounds a pivot

#include "pulled_wheel.hpp"

#include "mbgen/elementary.hpp"
#include "mbgen/fma.hpp"
#include "mbgen/solver/passing.hpp"
#include "mbgen/scalar.hpp"
#include "mbgen/turns.hpp"
#include "mbgen/solver.hpp"

#include <cmath>

namespace pulled_wheel {

using mbgen::fma;   // a b + c, rounded once
using mbgen::fms;   // a b - c
using mbgen::fnma;  // c - a b, of fnma(a, b, c)

namespace {

// Numbers of the model.
constexpr double p_ball_z = 0.02;
constexpr double p_ball_x = -0.4;
constexpr double p_lower_z = -0.25;
constexpr double p_wheel_z = 0.04;
constexpr double p_arm_seat_x = -0.25;
constexpr double p_arm_seat_z = 0.03;
constexpr double p_carriage_seat_x = -0.22;
constexpr double l0_spring = 0.34132096331752027;
constexpr double f0_spring = -3000.0;
constexpr double p_pull_z = 0.5;
constexpr double radius_tyre = 0.32;
constexpr double k_tyre = 2e+05;
constexpr double d_tyre = 500.0;
constexpr double rolling_tyre = 0.007;
constexpr double m_wheel = 18.0;
constexpr double I_knuckle_zz = 0.26;
constexpr double p_upper_to_z = 0.2;
constexpr double p_upper_to_x = 0.03;
constexpr double p_upper_from_z = -0.02;
constexpr double p_upper_from_x = 0.05;
constexpr double l_upper = 0.4201190307520001;
constexpr double h_arm_x = -1.26;
constexpr double h_arm_z = 0.07;
constexpr double g_z = -9.81;
constexpr double c_arm_x = -0.18;
constexpr double c_arm_z = 0.01;
constexpr double m_arm = 7.0;
constexpr double I_arm_yy = 0.12;
constexpr double m_carriage = 320.0;

/// Projection of the loop blocks, chosen at run time.
struct Projection {
  double Rz[2];  ///< of each block, row by row
  double zdd_star[2];  ///< accelerations of each block at zero independent ones
};

/// Constants that follow from tunable parameters.
void compute_derived_constants(const Parameters& parameters, Tuned& __restrict result) noexcept {
  // --- step 1: poses and axes b ---
  const double m_knuckle = 22.0 + parameters.ballast;
  result.derived[4] = m_knuckle;
  const double s1_1 = parameters.ballast/m_knuckle;
  const double c_knuckle_z = 0.04 + 0.11*s1_1;
  result.derived[3] = c_knuckle_z;
  const double s1_2 = 0.0121*(22.0*s1_1);
  const double I_knuckle_xx = 0.31 + s1_2;
  const double I_knuckle_yy = 0.36 + s1_2;
  result.derived[5] = I_knuckle_yy;
  const double m_knuckle_2 = m_wheel + m_knuckle;
  result.derived[1] = m_knuckle_2;
  const double s1_3 = m_knuckle*c_knuckle_z;
  const double h_knuckle_z = 0.72 + s1_3;
  const double s1_4 = 0.5*(I_knuckle_yy + (I_knuckle_zz + I_knuckle_xx));
  const double K_knuckle_xx = s1_4 - I_knuckle_xx;
  const double K_knuckle_zz = s1_4 + (c_knuckle_z*s1_3 - 0.2312);
  // operations: 11 add, 6 multiply, 1 divide

  // --- step 8: elimination from the leaves to the root (63), upper ---
  // knuckle: ball, revolute, arm
  const double s8_1 = h_knuckle_z*(1.0/m_knuckle_2);
  result.derived[0] = s8_1;
  result.derived[2] = K_knuckle_xx + K_knuckle_zz - h_knuckle_z*s8_1;
  // operations: 2 add, 2 multiply, 1 divide

  // --- step 9: outputs, energies, power ---
  result.derived[6] = p_pull_z*(345.0 + m_knuckle);
  // operations: 1 add, 1 multiply
}

/// Result of compute_accelerations.
struct Accelerations {
  double zdd[4];  ///< accelerations
  double xd[2];  ///< rates of the auxiliary states
  double pivot[1];  ///< smallest pivot of each block over its reference
  double inertia[2];  ///< pivots of the final equations
};

/// All accelerations with the frozen partition of the loop blocks.
void compute_accelerations(const Tuned& parameters, const Inputs& /*inputs*/, const State& state,
    const double* tau, Accelerations& __restrict result) noexcept {
  // Results that need no operation.
  result.inertia[1] = 1.0;
  result.zdd[Coordinate::pull] = 0.0;

  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const double z_lower = state.z[Coordinate::lower];
  double R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);
  // knuckle: ball, revolute, arm
  const double s1_1 = z_lower + state.z[Coordinate::ball];
  double R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_1, R_knuckle_x_z, R_knuckle_x_x);
  const double r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const double s1_2 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const double r_knuckle_z = s1_2 + p_lower_z;
  // wheel: wheel, revolute, knuckle
  const double s1_3 = p_wheel_z*R_knuckle_x_z;
  const double s1_4 = p_wheel_z*R_knuckle_x_x;
  const double r_wheel_z = r_knuckle_z + s1_4;
  // operations: 5 add, 6 multiply, 4 sin cos

  // --- step 4: velocities ---
  // knuckle: ball, revolute, arm
  const double zd_lower = state.zd[Coordinate::lower];
  const double v_knuckle_x = fma(zd_lower, s1_2, state.zd[Coordinate::pull]);
  const double s4_1 = zd_lower*r_knuckle_x;
  const double w_knuckle_y = zd_lower + state.zd[Coordinate::ball];
  // wheel: wheel, revolute, knuckle
  const double v_wheel_x = fma(s1_4, w_knuckle_y, v_knuckle_x);
  const double s4_2 = fma(s1_3, w_knuckle_y, s4_1);
  const double w_wheel_y = state.zd[Coordinate::wheel] + w_knuckle_y;
  // operations: 5 add, 4 multiply

  // --- step 5: applied forces Q (48) ---
  // spring
  const double s5_1 = fma(p_arm_seat_x, R_arm_x_x, p_arm_seat_z*R_arm_x_z);
  const double s5_2 = s5_1 - p_carriage_seat_x;
  const double s5_3 = fnma(p_arm_seat_x, R_arm_x_z, p_arm_seat_z*R_arm_x_x);
  const double s5_4 = 0.37 - s5_3;
  const double s5_5 = std::sqrt(fma(s5_4, s5_4, s5_2*s5_2));
  const double s5_6 = 1.0/s5_5;
  const double s5_7 = fma(zd_lower*s5_1, s5_4, s5_2*(zd_lower*s5_3))*s5_6;
  const double s5_8 = s5_7 - 0.2;
  const double s5_9 = (0.2 + s5_7 >= 0.0 ? 1600.0*s5_7 : fms(725.0, 1.0 + s5_7, 900.0));
  const double s5_10 = (s5_7 >= 0.0 ? 3200.0*s5_7 : s5_9);
  const double s5_11 = (s5_8 >= 0.0 ? fma(1575.0, s5_8, 640.0) : s5_10);
  const double tension_spring = s5_11 + fma(s5_5 - l0_spring, parameters.k, f0_spring);
  const double s5_12 = s5_6*tension_spring;
  const double s5_13 = s5_2*s5_12;
  const double s5_14 = s5_4*s5_12;
  // tyre
  const double s5_15 = radius_tyre - (p_pull_z + r_wheel_z);
  const double s5_16 = mbgen::max(0.0, k_tyre*s5_15);
  const double load_tyre = mbgen::max(0.0, s5_16 + mbgen::min(s5_16, d_tyre*s4_2));
  const double s5_17 = mbgen::max(0.004, load_tyre);
  const double s5_18 = 1.1*s5_17;
  const double s5_19 = 1.6*s5_18;
  const double s5_20 = 1e-09*s5_17;
  const double s5_21 = (s5_19 >= 0.0 ? mbgen::max(s5_19, s5_20) : mbgen::min(s5_19, -s5_20));
  const double s5_22 = 3.3333333333333335*state.x[0];
  const double s5_23 = 1.6666666666666667*state.x[1];
  const double s5_24 = std::sqrt(fma(s5_23, s5_23, fma(s5_22, s5_22, 1e-30)));
  const double s5_25 = std::abs(v_wheel_x);
  const double s5_26 = fnma(0.3333333333333333, mbgen::max(0.0, s5_15), radius_tyre);
  const double s5_27 = w_wheel_y*s5_26;
  const double s5_28 = v_wheel_x - s5_27;
  const double s5_29 = std::sqrt(fma(s5_28, s5_28, 1e-30));
  const double s5_30 = mbgen::min(0.5, 0.1*fma(0.5, s5_25 + s5_29, 1.0));
  const double s5_31 = 1.0 - s5_24/s5_30;
  const double s5_32 = mbgen::cosine(3.141592653589793*mbgen::min(1.0, 0.5*s5_25));
  const double s5_33 = s5_22*(1.0/mbgen::max(0.6666666666666666*s5_24, s5_31));
  const double s5_34 = fnma(s5_28, 0.06*fma(0.5, s5_32, 0.5)*mbgen::max(0.0, s5_31), s5_33);
  const double s5_35 = s5_18*mbgen::sine(1.6*mbgen::arc_tangent(20.0*s5_17/s5_21*s5_34));
  const double fx_tyre = mbgen::max(0.0, load_tyre)/s5_17*s5_35;
  const double s5_36 = s5_25 + s5_29/s5_30;
  result.xd[1] = -(s5_23*s5_36);
  result.xd[0] = -fma(s5_22, s5_36, s5_28);
  const double s5_37 = mbgen::hyperbolic_tangent(0.5*s5_27);
  const double s5_38 = radius_tyre*(rolling_tyre*load_tyre);
  // operations: 29 add, 51 multiply, 6 divide, 3 sqrt, 3 sin cos, 18 other

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper ---
  // upper
  const double s2_1 = fma(p_upper_to_z, R_knuckle_x_z, p_upper_to_x*R_knuckle_x_x);
  const double s2_2 = fnma(p_upper_to_x, R_knuckle_x_z, p_upper_to_z*R_knuckle_x_x);
  const double s2_3 = s2_2 + (r_knuckle_z - p_upper_from_z);
  const double s2_4 = p_upper_from_x - r_knuckle_x - s2_1;
  const double s2_5 = fma(s2_2, s2_4, s2_1*s2_3);
  const double s2_6 = s2_5 + fma(s1_2, s2_4, r_knuckle_x*s2_3);
  result.pivot[0] = 12.094222040829795*std::abs(s2_5);
  const double s2_7 = 1.0/s2_5;
  // operations: 9 add, 9 multiply, 1 divide, 1 other

  // --- step 3: Rz (61), upper ---
  const double s3_1 = s2_6*s2_7;
  // operations: 1 multiply

  // --- step 6: c and dRz/dt zd (62), upper ---
  const double s6_1 = zd_lower*zd_lower;
  // knuckle: ball, revolute, arm
  const double s6_2 = s1_2*s6_1;
  const double s6_3 = r_knuckle_x*s6_1;
  const double s6_4 = w_knuckle_y*w_knuckle_y;
  // upper
  const double s6_5 = w_knuckle_y*s2_1;
  const double s6_6 = w_knuckle_y*s2_2;
  const double s6_7 = fma(zd_lower, s1_2, s6_6);
  const double s6_8 = s4_1 + s6_5;
  const double s6_9 = fnma(s2_3, fma(w_knuckle_y, s6_6, s6_2), fma(s6_8, s6_8, s6_7*s6_7));
  const double s6_10 = fma(s2_4, fma(w_knuckle_y, s6_5, s6_3), s6_9);
  const double zdd_star_ball = s2_7*s6_10;
  // operations: 7 add, 14 multiply

  // --- step 8: elimination from the leaves to the root (63), upper ---
  // knuckle: ball, revolute, arm
  const double s8_1 = 1.0 - s3_1;
  const double s8_2 = R_knuckle_x_x*parameters.derived[0];
  const double s8_3 = R_knuckle_x_z*parameters.derived[0];
  const double m_knuckle = parameters.derived[1];
  const double s8_4 = fnma(s6_4, s8_3, fms(zdd_star_ball, s8_2, s6_3));
  const double f_knuckle_x = fms(s8_4, m_knuckle, fx_tyre);
  const double s8_5 = fma(zdd_star_ball, s8_3, fma(s6_4, s8_2, s6_2));
  const double s8_6 = fma(m_knuckle, s8_5, load_tyre);
  const double tau_wheel = tau[Coordinate::wheel];
  const double s8_7 = fma(zdd_star_ball, parameters.derived[2], tau_wheel);
  const double n_knuckle_y = fma(fx_tyre, s8_2 - s1_4, fma(load_tyre, s1_3 - s8_3, s8_7));
  const double s8_8 = fma(s8_1, s8_3, r_knuckle_x);
  const double s8_9 = m_knuckle*s8_8;
  const double s8_10 = s8_1*parameters.derived[2];
  const double s8_11 = fma(s8_1, s8_2, s1_2);
  const double s8_12 = m_knuckle*s8_11;
  const double pivot_lower = fma(s8_11, s8_12, fma(s8_1, s8_10, fma(s8_8, s8_9, 0.3475)));
  const double s8_13 = s8_9 + fma(h_arm_x, R_arm_x_x, h_arm_z*R_arm_x_z);
  result.inertia[0] = pivot_lower - 5.52e-23;
  const double s8_14 = 1.0/pivot_lower;
  // operations: 20 add, 21 multiply, 1 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  const double s9_1 = fnma(s5_1, s5_14, fnma(s5_3, s5_13, tau[Coordinate::lower]));
  const double s9_2 = fnma(s8_1, n_knuckle_y, fnma(tau[Coordinate::ball], s3_1, s9_1));
  const double s9_3 = fnma(g_z, s8_13, fnma(f_knuckle_x, s8_11, fnma(s8_6, s8_8, s9_2)));
  // arm: lower, revolute, carriage
  const double alpha_arm_y = s8_14*s9_3;
  result.zdd[Coordinate::lower] = alpha_arm_y;
  const double s9_4 = fnma(s3_1, alpha_arm_y, zdd_star_ball);
  result.zdd[Coordinate::ball] = s9_4;
  // knuckle: ball, revolute, arm
  const double alpha_knuckle_y = alpha_arm_y + s9_4;
  result.zdd[Coordinate::wheel] = fnma(s5_37, s5_38, fnma(s5_26, fx_tyre,
      tau_wheel)) - alpha_knuckle_y;
  // operations: 12 add, 11 multiply
}

/// Result of compute_closure.
struct Closure {
  double residual[2];  ///< of every closure equation, block after block, then of every motion
  double dz[4];  ///< Newton correction; driven coordinates go to their motions
  double zd[4];  ///< consistent velocities
  double pivot[1];  ///< smallest pivot of each block over its reference
  double Rz[2];  ///< free directions of each block, row by row
};

/// One Newton step of the frozen partition, and consistent velocities.
void compute_closure(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    Closure& __restrict result) noexcept {
  // Results that need no operation.
  result.Rz[1] = 1.0;
  result.dz[Coordinate::ball] = 0.0;
  result.dz[Coordinate::wheel] = 0.0;
  result.zd[Coordinate::pull] = 15.0;
  result.zd[Coordinate::ball] = state.zd[Coordinate::ball];
  result.zd[Coordinate::wheel] = state.zd[Coordinate::wheel];

  // --- step 1: poses and axes b ---
  const double s1_1 = fms(15.0, state.t, state.z[Coordinate::pull]);
  result.residual[1] = s1_1;
  result.dz[Coordinate::pull] = s1_1;
  // arm: lower, revolute, carriage
  const double z_lower = state.z[Coordinate::lower];
  double R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);
  // knuckle: ball, revolute, arm
  const double s1_2 = z_lower + state.z[Coordinate::ball];
  double R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_2, R_knuckle_x_z, R_knuckle_x_x);
  const double r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const double s1_3 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const double r_knuckle_z = s1_3 + p_lower_z;
  // operations: 5 add, 5 multiply, 4 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  // upper
  const double s2_1 = fma(p_upper_to_z, R_knuckle_x_z, p_upper_to_x*R_knuckle_x_x);
  const double s2_2 = p_upper_from_x - r_knuckle_x - s2_1;
  const double s2_3 = 2.380277794628896*s2_2;
  const double s2_4 = fnma(p_upper_to_x, R_knuckle_x_z, p_upper_to_z*R_knuckle_x_x);
  const double s2_5 = s2_4 + (r_knuckle_z - p_upper_from_z);
  const double s2_6 = 2.380277794628896*s2_5;
  const double s2_7 = fma(s2_1, s2_6, s2_3*s2_4);
  const double s2_8 = s2_7 + fma(r_knuckle_x, s2_6, s1_3*s2_3);
  const double s2_9 = 0.5*fma(s2_5, s2_6, fms(s2_2, s2_3, l_upper));
  result.residual[0] = s2_9;
  result.pivot[0] = 4.409001792788769*std::abs(s2_8);
  const double s2_10 = 1.0/s2_8;
  // operations: 11 add, 14 multiply, 1 divide, 1 other

  // --- step 4: velocities ---
  result.dz[Coordinate::lower] = s2_9*s2_10;

  // --- step 3: Rz (61) ---
  const double s3_1 = s2_7*s2_10;
  // loop block 0
  result.Rz[0] = -s3_1;
  // operations: 1 multiply
  result.zd[Coordinate::lower] = -(state.zd[Coordinate::ball]*s3_1);
  // operations: 2 multiply
}

/// Result of compute_multipliers.
struct ConstraintForces {
  double lambda[1];  ///< multipliers, loop after loop
  double drive[1];  ///< generalised driving forces
  double missing[2];  ///< force that multipliers and drives must provide, block after block
  double pivot[1];  ///< smallest pivot of each block over its reference
};

/// Multipliers of the closures and generalised driving forces, at given accelerations.
void compute_multipliers(const Tuned& parameters, const Inputs& /*inputs*/, const State& state,
    const double* tau, const Derivative& derivative, ConstraintForces& __restrict result) noexcept {
  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const double z_lower = state.z[Coordinate::lower];
  double R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);
  // knuckle: ball, revolute, arm
  const double s1_1 = z_lower + state.z[Coordinate::ball];
  double R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_1, R_knuckle_x_z, R_knuckle_x_x);
  const double r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const double s1_2 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const double r_knuckle_z = s1_2 + p_lower_z;
  // wheel: wheel, revolute, knuckle
  const double s1_3 = p_wheel_z*R_knuckle_x_z;
  const double s1_4 = p_wheel_z*R_knuckle_x_x;
  const double r_wheel_z = r_knuckle_z + s1_4;
  // operations: 5 add, 6 multiply, 4 sin cos

  // --- step 4: velocities ---
  // knuckle: ball, revolute, arm
  const double zd_lower = state.zd[Coordinate::lower];
  const double v_knuckle_x = fma(zd_lower, s1_2, state.zd[Coordinate::pull]);
  const double w_knuckle_y = zd_lower + state.zd[Coordinate::ball];
  // wheel: wheel, revolute, knuckle
  const double v_wheel_x = fma(s1_4, w_knuckle_y, v_knuckle_x);
  const double s4_1 = fma(s1_3, w_knuckle_y, zd_lower*r_knuckle_x);
  const double w_wheel_y = state.zd[Coordinate::wheel] + w_knuckle_y;
  // operations: 5 add, 4 multiply

  // --- step 5: applied forces Q (48) ---
  // spring
  const double s5_1 = fma(p_arm_seat_x, R_arm_x_x, p_arm_seat_z*R_arm_x_z);
  const double s5_2 = s5_1 - p_carriage_seat_x;
  const double s5_3 = fnma(p_arm_seat_x, R_arm_x_z, p_arm_seat_z*R_arm_x_x);
  const double s5_4 = 0.37 - s5_3;
  const double s5_5 = std::sqrt(fma(s5_4, s5_4, s5_2*s5_2));
  const double s5_6 = 1.0/s5_5;
  const double s5_7 = fma(zd_lower*s5_1, s5_4, s5_2*(zd_lower*s5_3))*s5_6;
  const double s5_8 = s5_7 - 0.2;
  const double s5_9 = 0.2 + s5_7;
  const double s5_10 = (s5_9 >= 0.0 ? fms(1600.0, s5_9, 320.0) : fms(725.0, 1.0 + s5_7, 900.0));
  const double s5_11 = (s5_7 >= 0.0 ? 3200.0*s5_7 : s5_10);
  const double s5_12 = (s5_8 >= 0.0 ? fma(1575.0, s5_8, 640.0) : s5_11);
  const double tension_spring = s5_12 + fma(s5_5 - l0_spring, parameters.k, f0_spring);
  const double s5_13 = s5_6*tension_spring;
  const double s5_14 = s5_2*s5_13;
  const double s5_15 = s5_4*s5_13;
  // tyre
  const double s5_16 = radius_tyre - (p_pull_z + r_wheel_z);
  const double s5_17 = mbgen::max(0.0, k_tyre*s5_16);
  const double load_tyre = mbgen::max(0.0, s5_17 + mbgen::min(s5_17, d_tyre*s4_1));
  const double s5_18 = mbgen::max(0.004, load_tyre);
  const double s5_19 = 1.1*s5_18;
  const double s5_20 = 1.6*s5_19;
  const double s5_21 = 1e-09*s5_18;
  const double s5_22 = (s5_20 >= 0.0 ? mbgen::max(s5_20, s5_21) : mbgen::min(s5_20, -s5_21));
  const double s5_23 = 3.3333333333333335*state.x[0];
  const double s5_24 = 1.6666666666666667*state.x[1];
  const double s5_25 = std::sqrt(fma(s5_24, s5_24, fma(s5_23, s5_23, 1e-30)));
  const double s5_26 = std::abs(v_wheel_x);
  const double s5_27 = fnma(0.3333333333333333, mbgen::max(0.0, s5_16), radius_tyre);
  const double s5_28 = w_wheel_y*s5_27;
  const double s5_29 = v_wheel_x - s5_28;
  const double s5_30 = 0.1*fma(0.5, s5_26 + std::sqrt(fma(s5_29, s5_29, 1e-30)), 1.0);
  const double s5_31 = 1.0 - s5_25/mbgen::min(0.5, s5_30);
  const double s5_32 = mbgen::cosine(3.141592653589793*mbgen::min(1.0, 0.5*s5_26));
  const double s5_33 = s5_23*(1.0/mbgen::max(0.6666666666666666*s5_25, s5_31));
  const double s5_34 = fnma(s5_29, 0.06*fma(0.5, s5_32, 0.5)*mbgen::max(0.0, s5_31), s5_33);
  const double s5_35 = s5_19*mbgen::sine(1.6*mbgen::arc_tangent(20.0*s5_18/s5_22*s5_34));
  const double fx_tyre = mbgen::max(0.0, load_tyre)/s5_18*s5_35;
  const double s5_36 = mbgen::hyperbolic_tangent(0.5*s5_28);
  const double s5_37 = radius_tyre*(rolling_tyre*load_tyre);
  // operations: 28 add, 49 multiply, 5 divide, 3 sqrt, 3 sin cos, 18 other

  // --- step 7: inertias of the bodies and forces on joints ---
  const double s7_1 = zd_lower*zd_lower;
  const double zdd_lower = derivative.zdd[Coordinate::lower];
  const double zdd_pull = derivative.zdd[Coordinate::pull];
  // knuckle: ball, revolute, arm
  const double a_knuckle_x = fnma(r_knuckle_x, s7_1, fma(zdd_lower, s1_2, zdd_pull));
  const double a_knuckle_z = fnma(s1_2, s7_1, fnma(zdd_lower, r_knuckle_x, -g_z));
  const double alpha_knuckle_y = zdd_lower + derivative.zdd[Coordinate::ball];
  const double s7_2 = w_knuckle_y*w_knuckle_y;
  // wheel: wheel, revolute, knuckle
  const double a_wheel_x = fnma(s1_3, s7_2, fma(s1_4, alpha_knuckle_y, a_knuckle_x));
  const double a_wheel_z = fnma(s1_4, s7_2, fnma(s1_3, alpha_knuckle_y, a_knuckle_z));
  const double alpha_wheel_y = derivative.zdd[Coordinate::wheel] + alpha_knuckle_y;
  const double f_wheel_x = fms(m_wheel, a_wheel_x, fx_tyre);
  const double f_wheel_z = fms(m_wheel, a_wheel_z, load_tyre);
  const double n_wheel_y = alpha_wheel_y + fma(s5_36, s5_37, s5_27*fx_tyre);
  // knuckle: ball, revolute, arm
  const double c_knuckle_z = parameters.derived[3];
  const double s7_3 = R_knuckle_x_x*c_knuckle_z;
  const double s7_4 = R_knuckle_x_z*c_knuckle_z;
  const double m_knuckle_2 = parameters.derived[4];
  const double f_knuckle_x = fnma(s7_2, s7_4, fma(alpha_knuckle_y, s7_3, a_knuckle_x))*m_knuckle_2;
  const double f_knuckle_z = m_knuckle_2*fnma(alpha_knuckle_y, s7_4, fnma(s7_2, s7_3, a_knuckle_z));
  const double I_knuckle_yy = parameters.derived[5];
  const double s7_5 = fma(s7_3, f_knuckle_x, alpha_knuckle_y*I_knuckle_yy);
  const double n_knuckle_y = fnma(s7_4, f_knuckle_z, s7_5);
  const double s7_6 = n_knuckle_y + (n_wheel_y + fnma(s1_3, f_wheel_z, s1_4*f_wheel_x));
  const double Q_ball = tau[Coordinate::ball] - s7_6;
  result.missing[1] = Q_ball;
  const double s7_7 = f_wheel_x + f_knuckle_x;
  const double s7_8 = f_wheel_z + f_knuckle_z;
  // arm: lower, revolute, carriage
  const double s7_9 = fnma(c_arm_x, R_arm_x_z, c_arm_z*R_arm_x_x);
  const double s7_10 = fma(c_arm_x, R_arm_x_x, c_arm_z*R_arm_x_z);
  const double s7_11 = m_arm*fnma(s7_1, s7_10, fma(zdd_lower, s7_9, zdd_pull));
  const double f_arm_x = s5_14 + s7_11;
  const double s7_12 = fma(s7_9, s7_11, fma(s5_1, s5_15, fma(s5_3, s5_14, I_arm_yy*zdd_lower)));
  const double n_arm_y = fnma(s7_10, m_arm*fnma(zdd_lower, s7_10, fnma(s7_1, s7_9, -g_z)), s7_12);
  const double s7_13 = fma(r_knuckle_x, s7_8, fnma(s1_2, s7_7, tau[Coordinate::lower] - s7_6));
  result.missing[0] = s7_13 - n_arm_y;
  // carriage: pull, prismatic, ground
  const double f_carriage_x = fms(m_carriage, zdd_pull, s5_14);
  const double Q_pull = tau[Coordinate::pull] - s7_7 - f_arm_x - f_carriage_x;
  // operations: 45 add, 45 multiply

  // --- step 9: multipliers of the closures and driving forces ---
  // upper
  const double s9_1 = fma(p_upper_to_z, R_knuckle_x_z, p_upper_to_x*R_knuckle_x_x);
  const double s9_2 = fnma(p_upper_to_x, R_knuckle_x_z, p_upper_to_z*R_knuckle_x_x);
  const double s9_3 = s9_1*(s9_2 + (r_knuckle_z - p_upper_from_z));
  const double s9_4 = fma(s9_2, p_upper_from_x - r_knuckle_x - s9_1, s9_3);
  result.pivot[0] = 12.094222040829795*std::abs(s9_4);
  result.lambda[0] = -(l_upper*(Q_ball*(1.0/s9_4)));
  result.drive[0] = -Q_pull;
  // operations: 7 add, 9 multiply, 1 divide, 1 other
}

/// Result of compute_closure_terms.
struct ClosureTerms {
  double Phi[1];  ///< residuals
  double Jz[2];  ///< Jacobian of each block, row by row
  double c[1];  ///< right-hand side of the accelerations
  double driven_acceleration[4];  ///< of driven coordinates, by their motions; no others
};

/// Closure equations and their derivatives, for the pivoting factorisation.
void compute_closure_terms(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, ClosureTerms& __restrict result) noexcept {
  // Results that need no operation.
  result.driven_acceleration[Coordinate::pull] = 0.0;

  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const double z_lower = state.z[Coordinate::lower];
  double R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);
  // knuckle: ball, revolute, arm
  const double s1_1 = z_lower + state.z[Coordinate::ball];
  double R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_1, R_knuckle_x_z, R_knuckle_x_x);
  const double r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const double s1_2 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const double r_knuckle_z = s1_2 + p_lower_z;
  // operations: 4 add, 4 multiply, 4 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  const double zd_lower = state.zd[Coordinate::lower];
  const double s2_1 = zd_lower + state.zd[Coordinate::ball];
  const double s2_2 = zd_lower*zd_lower;
  // upper
  const double s2_3 = fma(p_upper_to_z, R_knuckle_x_z, p_upper_to_x*R_knuckle_x_x);
  const double s2_4 = s2_1*s2_3;
  const double s2_5 = fnma(p_upper_to_x, R_knuckle_x_z, p_upper_to_z*R_knuckle_x_x);
  const double s2_6 = s2_1*s2_5;
  const double s2_7 = fma(zd_lower, s1_2, s2_6);
  const double s2_8 = fma(zd_lower, r_knuckle_x, s2_4);
  const double s2_9 = s2_5 + (r_knuckle_z - p_upper_from_z);
  const double s2_10 = 2.380277794628896*s2_9;
  const double s2_11 = p_upper_from_x - r_knuckle_x - s2_3;
  const double s2_12 = 2.380277794628896*s2_11;
  const double s2_13 = fma(s2_5, s2_12, s2_3*s2_10);
  result.Jz[1] = -s2_13;
  result.Phi[0] = 0.5*fma(s2_11, s2_12, fms(s2_9, s2_10, l_upper));
  result.Jz[0] = -(s2_13 + fma(s1_2, s2_12, r_knuckle_x*s2_10));
  const double s2_14 = fma(s2_1, s2_4, r_knuckle_x*s2_2);
  const double s2_15 = fnma(s2_14, s2_12, fma(s2_1, s2_6, s1_2*s2_2)*s2_10);
  result.c[0] = fnma(2.380277794628896, fma(s2_8, s2_8, s2_7*s2_7), s2_15);
  // operations: 19 add, 27 multiply
}

/// Result of compute_chosen_accelerations.
struct ChosenAccelerations {
  double zdd[4];  ///< accelerations
  double xd[2];  ///< rates of the auxiliary states
  double inertia[2];  ///< pivots of the final equations
};

/// All accelerations with a partition chosen at run time.
void compute_chosen_accelerations(const Tuned& parameters, const Inputs& /*inputs*/,
    const State& state, const double* tau, const Projection& projection,
    ChosenAccelerations& __restrict result) noexcept {
  // Results that need no operation.
  result.inertia[1] = 1.0;
  result.zdd[Coordinate::pull] = 0.0;

  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const double z_lower = state.z[Coordinate::lower];
  double R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);
  // knuckle: ball, revolute, arm
  const double s1_1 = z_lower + state.z[Coordinate::ball];
  double R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_1, R_knuckle_x_z, R_knuckle_x_x);
  const double r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const double s1_2 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const double r_knuckle_z = s1_2 + p_lower_z;
  // wheel: wheel, revolute, knuckle
  const double s1_3 = p_wheel_z*R_knuckle_x_z;
  const double s1_4 = p_wheel_z*R_knuckle_x_x;
  const double r_wheel_z = r_knuckle_z + s1_4;
  // operations: 5 add, 6 multiply, 4 sin cos

  // --- step 4: velocities ---
  // knuckle: ball, revolute, arm
  const double zd_lower = state.zd[Coordinate::lower];
  const double v_knuckle_x = fma(zd_lower, s1_2, state.zd[Coordinate::pull]);
  const double w_knuckle_y = zd_lower + state.zd[Coordinate::ball];
  // wheel: wheel, revolute, knuckle
  const double v_wheel_x = fma(s1_4, w_knuckle_y, v_knuckle_x);
  const double s4_1 = fma(s1_3, w_knuckle_y, zd_lower*r_knuckle_x);
  const double w_wheel_y = state.zd[Coordinate::wheel] + w_knuckle_y;
  // operations: 5 add, 4 multiply

  // --- step 5: applied forces Q (48) ---
  // spring
  const double s5_1 = fma(p_arm_seat_x, R_arm_x_x, p_arm_seat_z*R_arm_x_z);
  const double s5_2 = s5_1 - p_carriage_seat_x;
  const double s5_3 = fnma(p_arm_seat_x, R_arm_x_z, p_arm_seat_z*R_arm_x_x);
  const double s5_4 = 0.37 - s5_3;
  const double s5_5 = std::sqrt(fma(s5_4, s5_4, s5_2*s5_2));
  const double s5_6 = 1.0/s5_5;
  const double s5_7 = fma(zd_lower*s5_1, s5_4, s5_2*(zd_lower*s5_3))*s5_6;
  const double s5_8 = s5_7 - 0.2;
  const double s5_9 = 0.2 + s5_7;
  const double s5_10 = (s5_9 >= 0.0 ? fms(1600.0, s5_9, 320.0) : fms(725.0, 1.0 + s5_7, 900.0));
  const double s5_11 = (s5_7 >= 0.0 ? 3200.0*s5_7 : s5_10);
  const double s5_12 = (s5_8 >= 0.0 ? fma(1575.0, s5_8, 640.0) : s5_11);
  const double tension_spring = s5_12 + fma(s5_5 - l0_spring, parameters.k, f0_spring);
  const double s5_13 = s5_6*tension_spring;
  const double s5_14 = s5_2*s5_13;
  const double s5_15 = s5_4*s5_13;
  // tyre
  const double s5_16 = radius_tyre - (p_pull_z + r_wheel_z);
  const double s5_17 = mbgen::max(0.0, k_tyre*s5_16);
  const double load_tyre = mbgen::max(0.0, s5_17 + mbgen::min(s5_17, d_tyre*s4_1));
  const double s5_18 = mbgen::max(0.004, load_tyre);
  const double s5_19 = 1.1*s5_18;
  const double s5_20 = 1.6*s5_19;
  const double s5_21 = 1e-09*s5_18;
  const double s5_22 = (s5_20 >= 0.0 ? mbgen::max(s5_20, s5_21) : mbgen::min(s5_20, -s5_21));
  const double s5_23 = 3.3333333333333335*state.x[0];
  const double s5_24 = 1.6666666666666667*state.x[1];
  const double s5_25 = std::sqrt(fma(s5_24, s5_24, fma(s5_23, s5_23, 1e-30)));
  const double s5_26 = std::abs(v_wheel_x);
  const double s5_27 = fnma(0.3333333333333333, mbgen::max(0.0, s5_16), radius_tyre);
  const double s5_28 = w_wheel_y*s5_27;
  const double s5_29 = v_wheel_x - s5_28;
  const double s5_30 = std::sqrt(fma(s5_29, s5_29, 1e-30));
  const double s5_31 = mbgen::min(0.5, 0.1*fma(0.5, s5_26 + s5_30, 1.0));
  const double s5_32 = 1.0 - s5_25/s5_31;
  const double s5_33 = mbgen::cosine(3.141592653589793*mbgen::min(1.0, 0.5*s5_26));
  const double s5_34 = s5_23*(1.0/mbgen::max(0.6666666666666666*s5_25, s5_32));
  const double s5_35 = fnma(s5_29, 0.06*fma(0.5, s5_33, 0.5)*mbgen::max(0.0, s5_32), s5_34);
  const double s5_36 = s5_19*mbgen::sine(1.6*mbgen::arc_tangent(20.0*s5_18/s5_22*s5_35));
  const double fx_tyre = mbgen::max(0.0, load_tyre)/s5_18*s5_36;
  const double s5_37 = s5_26 + s5_30/s5_31;
  result.xd[1] = -(s5_24*s5_37);
  result.xd[0] = -fma(s5_23, s5_37, s5_29);
  const double s5_38 = mbgen::hyperbolic_tangent(0.5*s5_28);
  const double s5_39 = fma(s5_38, radius_tyre*(rolling_tyre*load_tyre), s5_27*fx_tyre);
  // operations: 31 add, 53 multiply, 6 divide, 3 sqrt, 3 sin cos, 18 other

  // --- step 8: elimination from the leaves to the root (63) ---
  const double tau_wheel = tau[Coordinate::wheel];
  const double s8_1 = tau_wheel - s5_39;
  // operations: 1 add

  // --- step 6: c and dRz/dt zd (62), upper ---
  const double s6_1 = zd_lower*zd_lower;
  const double s6_2 = w_knuckle_y*w_knuckle_y;
  // operations: 2 multiply

  // --- step 7: inertias of the bodies and forces on joints, upper ---
  const double s7_1 = fma(h_arm_x, R_arm_x_x, h_arm_z*R_arm_x_z);
  // operations: 1 add, 2 multiply

  // --- step 8: elimination from the leaves to the root (63), upper ---
  // knuckle: ball, revolute, arm
  const double s8_2 = projection.Rz[0] + projection.Rz[1];
  const double s8_3 = projection.zdd_star[0] + projection.zdd_star[1];
  const double s8_4 = R_knuckle_x_x*parameters.derived[0];
  const double s8_5 = R_knuckle_x_z*parameters.derived[0];
  const double s8_6 = fma(s8_3, s8_4, fnma(r_knuckle_x, s6_1, s1_2*projection.zdd_star[0]));
  const double m_knuckle = parameters.derived[1];
  const double f_knuckle_x = fms(fnma(s6_2, s8_5, s8_6), m_knuckle, fx_tyre);
  const double s8_7 = fma(s6_2, s8_4, fma(s1_2, s6_1, r_knuckle_x*projection.zdd_star[0]));
  const double s8_8 = fma(m_knuckle, fma(s8_3, s8_5, s8_7), load_tyre);
  const double s8_9 = fma(load_tyre, s1_3 - s8_5, fma(s8_3, parameters.derived[2], tau_wheel));
  const double n_knuckle_y = fma(fx_tyre, s8_4 - s1_4, s8_9);
  const double s8_10 = fma(s8_2, s8_5, r_knuckle_x*projection.Rz[0]);
  const double s8_11 = m_knuckle*s8_10;
  const double s8_12 = s8_2*parameters.derived[2];
  const double s8_13 = fma(s8_2, s8_4, s1_2*projection.Rz[0]);
  const double s8_14 = m_knuckle*s8_13;
  // arm: lower, revolute, carriage
  const double s8_15 = fma(projection.Rz[0], s7_1, s8_11);
  const double s8_16 = fma(s8_13, s8_14, fma(s8_2, s8_12, s8_10*s8_11));
  const double s8_17 = fma(projection.Rz[0], 0.3475*projection.Rz[0], s8_16);
  result.inertia[0] = s8_17 - 5.52e-23;
  const double s8_18 = 1.0/s8_17;
  // operations: 22 add, 28 multiply, 1 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  const double s9_1 = fnma(s5_1, s5_15, fnma(s5_3, s5_14, tau[Coordinate::lower]));
  const double s9_2 = fnma(s8_2, n_knuckle_y, projection.Rz[1]*tau[Coordinate::ball]);
  const double s9_3 = fnma(g_z, s8_15, fnma(f_knuckle_x, s8_13, fnma(s8_8, s8_10, s9_2)));
  const double s9_4 = fma(projection.Rz[0], fnma(0.3475, projection.zdd_star[0], s9_1), s9_3);
  const double s9_5 = s8_18*s9_4;
  // arm: lower, revolute, carriage
  const double alpha_arm_y = fma(projection.Rz[0], s9_5, projection.zdd_star[0]);
  result.zdd[Coordinate::lower] = alpha_arm_y;
  const double s9_6 = fma(projection.Rz[1], s9_5, projection.zdd_star[1]);
  result.zdd[Coordinate::ball] = s9_6;
  // knuckle: ball, revolute, arm
  const double alpha_knuckle_y = alpha_arm_y + s9_6;
  result.zdd[Coordinate::wheel] = s8_1 - alpha_knuckle_y;
  // operations: 12 add, 12 multiply
}

/// Outputs, energies and power, at given accelerations.
void compute_outputs(const Tuned& parameters, const Inputs& /*inputs*/, const State& state,
    const double* tau, const Derivative& /*derivative*/, const Multipliers& multipliers,
    Outputs& __restrict result) noexcept {
  // Results that need no operation.
  result.wheel_speed = state.zd[Coordinate::wheel];

  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const double z_lower = state.z[Coordinate::lower];
  double R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);
  // knuckle: ball, revolute, arm
  const double s1_1 = z_lower + state.z[Coordinate::ball];
  double R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_1, R_knuckle_x_z, R_knuckle_x_x);
  const double r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const double s1_2 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const double r_knuckle_z = s1_2 + p_lower_z;
  // wheel: wheel, revolute, knuckle
  const double s1_3 = p_wheel_z*R_knuckle_x_z;
  const double s1_4 = p_wheel_z*R_knuckle_x_x;
  const double r_wheel_z = r_knuckle_z + s1_4;
  // operations: 5 add, 6 multiply, 4 sin cos

  // --- step 4: velocities ---
  // knuckle: ball, revolute, arm
  const double zd_lower = state.zd[Coordinate::lower];
  const double zd_pull = state.zd[Coordinate::pull];
  const double v_knuckle_x = fma(zd_lower, s1_2, zd_pull);
  const double s4_1 = zd_lower*r_knuckle_x;
  const double zd_ball = state.zd[Coordinate::ball];
  const double w_knuckle_y = zd_lower + zd_ball;
  // wheel: wheel, revolute, knuckle
  const double v_wheel_x = fma(s1_4, w_knuckle_y, v_knuckle_x);
  const double s4_2 = fma(s1_3, w_knuckle_y, s4_1);
  const double zd_wheel = state.zd[Coordinate::wheel];
  const double w_wheel_y = zd_wheel + w_knuckle_y;
  // operations: 5 add, 4 multiply

  // --- step 5: applied forces Q (48) ---
  // spring
  const double s5_1 = fma(p_arm_seat_x, R_arm_x_x, p_arm_seat_z*R_arm_x_z);
  const double s5_2 = s5_1 - p_carriage_seat_x;
  const double s5_3 = fnma(p_arm_seat_x, R_arm_x_z, p_arm_seat_z*R_arm_x_x);
  const double s5_4 = 0.37 - s5_3;
  const double s5_5 = std::sqrt(fma(s5_4, s5_4, s5_2*s5_2));
  const double s5_6 = 1.0/s5_5;
  const double s5_7 = fma(zd_lower*s5_1, s5_4, s5_2*(zd_lower*s5_3))*s5_6;
  const double s5_8 = s5_7 - 0.2;
  const double s5_9 = 0.2 + s5_7;
  const double s5_10 = (s5_9 >= 0.0 ? fms(1600.0, s5_9, 320.0) : fms(725.0, 1.0 + s5_7, 900.0));
  const double s5_11 = (s5_7 >= 0.0 ? 3200.0*s5_7 : s5_10);
  const double s5_12 = (s5_8 >= 0.0 ? fma(1575.0, s5_8, 640.0) : s5_11);
  const double tension_spring = s5_12 + fma(s5_5 - l0_spring, parameters.k, f0_spring);
  result.spring_force = tension_spring;
  const double s5_13 = s5_6*tension_spring;
  const double s5_14 = s5_2*s5_13;
  const double s5_15 = s5_4*s5_13;
  // tyre
  const double s5_16 = p_pull_z + r_wheel_z;
  result.hub_height = s5_16;
  const double s5_17 = radius_tyre - s5_16;
  const double s5_18 = mbgen::max(0.0, k_tyre*s5_17);
  const double load_tyre = mbgen::max(0.0, s5_18 + mbgen::min(s5_18, d_tyre*s4_2));
  result.load = load_tyre;
  const double s5_19 = mbgen::max(0.004, load_tyre);
  const double s5_20 = 1.1*s5_19;
  const double s5_21 = 1.6*s5_20;
  const double s5_22 = 1e-09*s5_19;
  const double s5_23 = (s5_21 >= 0.0 ? mbgen::max(s5_21, s5_22) : mbgen::min(s5_21, -s5_22));
  const double s5_24 = 3.3333333333333335*state.x[0];
  const double s5_25 = 1.6666666666666667*state.x[1];
  const double s5_26 = std::sqrt(fma(s5_25, s5_25, fma(s5_24, s5_24, 1e-30)));
  const double s5_27 = std::abs(v_wheel_x);
  const double s5_28 = fnma(0.3333333333333333, mbgen::max(0.0, s5_17), radius_tyre);
  const double s5_29 = w_wheel_y*s5_28;
  const double s5_30 = v_wheel_x - s5_29;
  const double s5_31 = 0.1*fma(0.5, s5_27 + std::sqrt(fma(s5_30, s5_30, 1e-30)), 1.0);
  const double s5_32 = 1.0 - s5_26/mbgen::min(0.5, s5_31);
  const double s5_33 = mbgen::cosine(3.141592653589793*mbgen::min(1.0, 0.5*s5_27));
  const double s5_34 = s5_24*(1.0/mbgen::max(0.6666666666666666*s5_26, s5_32));
  const double s5_35 = fnma(s5_30, 0.06*fma(0.5, s5_33, 0.5)*mbgen::max(0.0, s5_32), s5_34);
  const double s5_36 = s5_20*mbgen::sine(1.6*mbgen::arc_tangent(20.0*s5_19/s5_23*s5_35));
  const double fx_tyre = mbgen::max(0.0, load_tyre)/s5_19*s5_36;
  const double s5_37 = mbgen::hyperbolic_tangent(0.5*s5_29);
  const double s5_38 = fma(s5_37, radius_tyre*(rolling_tyre*load_tyre), s5_28*fx_tyre);
  // operations: 29 add, 51 multiply, 5 divide, 3 sqrt, 3 sin cos, 18 other

  // --- step 7: inertias of the bodies and forces on joints ---
  // knuckle: ball, revolute, arm
  const double c_knuckle_z = parameters.derived[3];
  const double s7_1 = R_knuckle_x_x*c_knuckle_z;
  const double s7_2 = R_knuckle_x_z*c_knuckle_z;
  const double I_knuckle_yy = parameters.derived[5];
  const double s7_3 = w_knuckle_y*I_knuckle_yy;
  // arm: lower, revolute, carriage
  const double s7_4 = fnma(c_arm_x, R_arm_x_z, c_arm_z*R_arm_x_x);
  const double s7_5 = fma(c_arm_x, R_arm_x_x, c_arm_z*R_arm_x_z);
  const double s7_6 = I_arm_yy*zd_lower;
  // operations: 2 add, 8 multiply

  // --- step 9: outputs, energies, power ---
  const double s9_1 = zd_lower*s7_5;
  const double s9_2 = fma(w_knuckle_y, s7_2, s4_1);
  const double m_knuckle_2 = parameters.derived[4];
  const double s9_3 = fma(m_wheel, r_wheel_z, parameters.derived[6]);
  const double s9_4 = fma(m_arm, s7_4 + p_lower_z, fma(r_knuckle_z + s7_1, m_knuckle_2, s9_3));
  result.potential_energy = -g_z*s9_4;
  const double s9_5 = fma(zd_wheel, tau[Coordinate::wheel], zd_ball*tau[Coordinate::ball]);
  const double s9_6 = fma(v_wheel_x, fx_tyre, fnma(s4_2, load_tyre, s9_5));
  const double s9_7 = tau[Coordinate::pull] + multipliers.drive[0];
  const double s9_8 = fnma(s5_1, s5_15, fnma(s5_3, s5_14, tau[Coordinate::lower]));
  result.applied_power = fma(zd_lower, s9_8, fma(zd_pull, s9_7, fnma(w_wheel_y, s5_38, s9_6)));
  const double s9_9 = fma(w_knuckle_y, s7_1, v_knuckle_x);
  const double s9_10 = fma(zd_lower, s7_4, zd_pull);
  const double s9_11 = fma(zd_lower, s7_6, fma(w_knuckle_y, s7_3, w_wheel_y*w_wheel_y));
  const double s9_12 = fma(m_wheel, fma(s4_2, s4_2, v_wheel_x*v_wheel_x), s9_11);
  const double s9_13 = fma(m_knuckle_2, fma(s9_9, s9_9, s9_2*s9_2), s9_12);
  const double s9_14 = fma(m_carriage, zd_pull*zd_pull, s9_13);
  result.kinetic_energy = 0.5*fma(m_arm, fma(s9_10, s9_10, s9_1*s9_1), s9_14);
  // operations: 26 add, 32 multiply
}


/// Sizes, tables and programs of this model for the runtime's algorithms; see mbgen/solver.hpp.
struct System {
  using Parameters = pulled_wheel::Tuned;
  using Inputs = pulled_wheel::Inputs;
  using State = pulled_wheel::State;
  using Derivative = pulled_wheel::Derivative;
  using Multipliers = pulled_wheel::Multipliers;
  static constexpr int kCoordinates = 4;
  static constexpr int kAuxiliaryStates = 2;
  static constexpr int kBlocks = 1;
  static constexpr int kEquations = 1;
  static constexpr int kFreeDirections = 2;
  static constexpr bool kHasClosure = true;
  static constexpr int kDrives = 1;
  static constexpr double kClosureTolerance = 1e-12;
  static constexpr int kBlockCoordinates = 2;
  static constexpr mbgen::FreeDirection kFreeDirection[] = {{2, 0, 0}, {3, -1, 0}};
  static constexpr double Parameters::*kParameterMember[] = {&Parameters::k, &Parameters::ballast};
  static constexpr double Inputs::*kInputMember[] = {nullptr};
  static constexpr unsigned char kDriven[] = {1, 0, 0, 0};
  static constexpr unsigned char kRedundant[] = {0};
  static constexpr int kDriveCoordinate[] = {0};
  static constexpr mbgen::BlockLayout kBlockLayout[] = {{1, 2, 1, 1, 0, 0, 0, 0, 0.23}};
  static constexpr int kBlockCoordinate[] = {1, 2};
  static constexpr unsigned char kBlockDriven[] = {0, 0};
  static constexpr int kMultiplierPlace[] = {0};
  using Accelerations = pulled_wheel::Accelerations;
  static constexpr auto accelerations = &compute_accelerations;
  using Closure = pulled_wheel::Closure;
  static constexpr auto closure = &compute_closure;
  using ConstraintForces = pulled_wheel::ConstraintForces;
  static constexpr auto multipliers = &compute_multipliers;
  using ClosureTerms = pulled_wheel::ClosureTerms;
  static constexpr auto closure_terms = &compute_closure_terms;
  using ChosenAccelerations = pulled_wheel::ChosenAccelerations;
  static constexpr auto chosen_accelerations = &compute_chosen_accelerations;
  using Projection = pulled_wheel::Projection;
  static double argument_sum(const Parameters& parameters, const Inputs& /*inputs*/) noexcept {
    return parameters.k + parameters.ballast;
  }
};

}  // namespace

Tuned::Tuned(const Parameters& parameters) noexcept : Parameters(parameters) {
  compute_derived_constants(parameters, *this);
}

State initial_state() noexcept {
  static constexpr State start = {
      {0.0, -0.00440901003487986, 0.0050617586630790305, 0.0},
      {15.0, 0.0, 0.0, 48.0},
      {2.1682291759457585e-18, 0.0},
      0.0};
  State state;
  mbgen::integrator_detail::copy_state(start, state);
  return state;
}

mbgen::Status assemble(const Tuned& parameters, const Inputs& inputs, State& state) noexcept {
  return mbgen::project_state<System>(parameters, inputs, state);
}

mbgen::Status accelerations(const Tuned& parameters, const Inputs& inputs, const State& state,
                            const double (&tau)[kCoordinates], Derivative& derivative) noexcept {
  return mbgen::solve_accelerations<System>(parameters, inputs, state, tau, derivative);
}

mbgen::Status Dynamics::derivative(const State& state, Derivative& derivative) const noexcept {
  return mbgen::solve_motion<System>(parameters, inputs, state, derivative);
}

mbgen::Status Dynamics::project(State& state) const noexcept {
  return mbgen::project_motion<System>(parameters, inputs, state);
}

mbgen::Status Dynamics::project_nearest(State& state) const noexcept {
  return mbgen::project_nearest<System>(parameters, inputs, state);
}

mbgen::Status Dynamics::project(State& state, int& closures) const noexcept {
  return mbgen::project_motion<System>(parameters, inputs, state, closures);
}

mbgen::Status Dynamics::project_nearest(State& state, int& closures) const noexcept {
  return mbgen::project_nearest<System>(parameters, inputs, state, closures);
}

mbgen::Status Dynamics::project_crossing(State& state, double& clearance, int& closures) const noexcept {
  return mbgen::project_crossing<System>(parameters, inputs, state, clearance, closures);
}

int Dynamics::changed_side(const State& from, const State& to) const noexcept {
  return mbgen::changed_side<System>(parameters, inputs, from, to);
}

mbgen::Status Dynamics::watch_way(const State& from, const State& to, double h,
                                  const mbgen::WayLimits& limits) const noexcept {
  return mbgen::watch_way<System>(parameters, inputs, from, to, h, limits);
}

mbgen::Status Dynamics::rates_near(const State& state, Derivative& derivative) const noexcept {
  return mbgen::solve_near<System>(parameters, inputs, state, derivative);
}

mbgen::Status Dynamics::look_across(const State& state, double h, Passage& passage) const noexcept {
  const auto inputs_at = [&](double) -> const Inputs& { return inputs; };
  return mbgen::look_across<System>(parameters, inputs_at, state, h, passage);
}

bool Dynamics::close_across(Passage& passage, State& state) const noexcept {
  return mbgen::close_across<System>(parameters, inputs, passage, state);
}

mbgen::Status Dynamics::rates_across(const Passage& passage, const State& state,
                                     Derivative& derivative) const noexcept {
  return mbgen::rates_across<System>(parameters, inputs, passage, state, derivative);
}

namespace {

/// 1 for coordinates whose turn changes accelerations or closures, else 0.
constexpr double kTurning[] = {0.0, 1.0, 1.0, 0.0};

}  // namespace

mbgen::Status step_rk4(const Tuned& parameters, const Inputs& inputs, State& state, double h) noexcept {
  const mbgen::Status stepped = mbgen::step_rk4(Dynamics{parameters, inputs}, state, h);
  return mbgen::with_turns(stepped, state.zd, kTurning, h, mbgen::kRk4Turn);
}

mbgen::Status step_abm4(const Tuned& parameters, const Inputs& inputs, State& state, History& history,
                        double h) noexcept {
  const mbgen::Status stepped = mbgen::step_abm4(Dynamics{parameters, inputs}, state, history, h);
  return mbgen::with_turns(stepped, state.zd, kTurning, h, mbgen::kAbm4Turn);
}

mbgen::Status accelerations_in_motion(const Tuned& parameters, const Inputs& inputs, const State& state, double h,
                                      Derivative& derivative) noexcept {
  return mbgen::without_notice(mbgen::rates_in_motion(Dynamics{parameters, inputs}, state, h, derivative));
}

mbgen::Status outputs(const Tuned& parameters, const Inputs& inputs, const State& state,
                      const double (&tau)[kCoordinates], const Derivative& derivative,
                      Outputs& values) noexcept {
  const mbgen::Status status = mbgen::solver_detail::check_arguments<System>(parameters, inputs, state, tau);
  if (status.ok()) {
    compute_outputs(parameters, inputs, state, tau, derivative,
                    mbgen::multipliers_or_nan<System>(parameters, inputs, state, tau, derivative), values);
  }
  return status;
}

mbgen::Status multipliers(const Tuned& parameters, const Inputs& inputs, const State& state,
                          const double (&tau)[kCoordinates], const Derivative& derivative,
                          Multipliers& values) noexcept {
  return mbgen::solve_multipliers<System>(parameters, inputs, state, tau, derivative, values);
}

mbgen::Status closure_residual(const Tuned& parameters, const Inputs& inputs, const State& state,
                               ClosureResidual& residual) noexcept {
  return mbgen::closure_residuals<System>(parameters, inputs, state, residual);
}

const char* describe(mbgen::Status status) noexcept {
  return mbgen::name_of(status, {kCoordinateNames, kCoordinates}, {kLoopBlockNames, kLoopBlocks},
                        {kInputNames, kInputs}, {kParameterNames, kParameters},
                        {kAuxiliaryStateNames, kAuxiliaryStates});
}

}  // namespace pulled_wheel
