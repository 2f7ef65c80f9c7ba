// four_bar, content hash 96a2cec425b2f2a9
// Made by `mbgen generate four_bar.json`, mbgen 0.1.0. Change the model, not this file.
//
// Tree, each body with its coordinate, on the body before it:
//   crank: crank_pin, revolute, on ground
//   coupler: coupler_pin, revolute, on crank
//   rocker: rocker_pin, revolute, on ground
// Loop block 0, on ground:
//   rocker_tip: revolute between coupler and rocker
//   independent: coupler_pin
//   in the accelerations: crank_pin
//
// Frames: a body of a loop block is seen in the axes of the body that its block moves on, about that body's origin;
// every other body in its own axes. The origin of a body is the point of its joint.
//
// Names, followed by body, coordinate, loop or element:
//   m mass, h first moments about the origin; c centre of mass, I inertia about it
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

#include "four_bar.hpp"

#include "mbgen/elementary.hpp"
#include "mbgen/fma.hpp"
#include "mbgen/solver/passing.hpp"
#include "mbgen/scalar.hpp"
#include "mbgen/turns.hpp"
#include "mbgen/solver.hpp"

#include <cmath>

namespace four_bar {

using mbgen::fma;   // a b + c, rounded once
using mbgen::fms;   // a b - c
using mbgen::fnma;  // c - a b, of fnma(a, b, c)

namespace {

// Numbers of the model.
constexpr double p_coupler_pin_z = 0.05;
constexpr double p_coupler_pin_x = 0.1;
constexpr double p_rocker_S_x = 0.01;
constexpr double p_rocker_S_z = 0.15;
constexpr double p_rocker_pin_x = 0.4;
constexpr double p_ground_S_z = 0.1;
constexpr double l0_return_spring = 0.18;
constexpr double p_rocker_C_z = 0.25;
constexpr double p_rocker_C_x = 0.02;
constexpr double p_coupler_C_x = 0.32;
constexpr double p_coupler_C_z = 0.2;
constexpr double h_crank_z = 0.016;
constexpr double h_crank_x = 0.04;
constexpr double h_coupler_z = 0.165;
constexpr double h_coupler_x = 0.225;
constexpr double h_rocker_z = 0.132;
constexpr double h_rocker_x = 0.011;
constexpr double g_z = -9.81;
constexpr double m_coupler = 1.5;
constexpr double c_rocker_z = 0.12;
constexpr double m_rocker = 1.1;
constexpr double I_rocker_yy = 0.006;
constexpr double c_coupler_z = 0.11;
constexpr double c_coupler_x = 0.15;
constexpr double I_coupler_yy = 0.021;
constexpr double c_crank_z = 0.02;
constexpr double m_crank = 0.8;
constexpr double I_crank_yy = 7e-04;
constexpr double p_coupler_P_x = 0.2;
constexpr double p_coupler_P_z = 0.25;

/// Projection of the loop blocks, chosen at run time.
struct Projection {
  double Rz[3];  ///< of each block, row by row
  double zdd_star[3];  ///< accelerations of each block at zero independent ones
};

/// Result of compute_accelerations.
struct Accelerations {
  double zdd[3];  ///< accelerations
  double xd[1];  ///< rates of the auxiliary states
  double pivot[1];  ///< smallest pivot of each block over its reference
  double inertia[1];  ///< pivots of the final equations
};

/// All accelerations with the frozen partition of the loop blocks.
void compute_accelerations(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, Accelerations& __restrict result) noexcept {
  // --- step 1: poses and axes b ---
  // crank: crank_pin, revolute, ground
  const double z_crank_pin = state.z[Coordinate::crank_pin];
  double R_crank_x_x, R_crank_x_z;
  mbgen::sincos(z_crank_pin, R_crank_x_z, R_crank_x_x);
  // coupler: coupler_pin, revolute, crank
  const double s1_1 = z_crank_pin + state.z[Coordinate::coupler_pin];
  double R_coupler_x_x, R_coupler_x_z;
  mbgen::sincos(s1_1, R_coupler_x_z, R_coupler_x_x);
  const double r_coupler_x = fma(p_coupler_pin_z, R_crank_x_z, p_coupler_pin_x*R_crank_x_x);
  const double r_coupler_z = fnma(p_coupler_pin_x, R_crank_x_z, p_coupler_pin_z*R_crank_x_x);
  // rocker: rocker_pin, revolute, ground
  const double z_rocker_pin = state.z[Coordinate::rocker_pin];
  double R_rocker_x_x, R_rocker_x_z;
  mbgen::sincos(z_rocker_pin, R_rocker_x_z, R_rocker_x_x);
  // operations: 3 add, 4 multiply, 6 sin cos

  // --- step 4: velocities ---
  // coupler: coupler_pin, revolute, crank
  const double zd_crank_pin = state.zd[Coordinate::crank_pin];
  const double w_coupler_y = zd_crank_pin + state.zd[Coordinate::coupler_pin];
  // operations: 1 add

  // --- step 5: applied forces Q (48) ---
  // return_spring
  const double s5_1 = fma(p_rocker_S_z, R_rocker_x_z, p_rocker_S_x*R_rocker_x_x);
  const double s5_2 = fnma(p_rocker_S_x, R_rocker_x_z, p_rocker_S_z*R_rocker_x_x);
  const double s5_3 = 0.2 - s5_1;
  const double s5_4 = p_ground_S_z - s5_2;
  const double s5_5 = std::sqrt(fma(s5_4, s5_4, s5_3*s5_3));
  const double tension_return_spring = (s5_5 - l0_return_spring)*parameters.k;
  const double s5_6 = 1.0/s5_5*tension_return_spring;
  const double s5_7 = s5_4*s5_6;
  const double s5_8 = s5_3*s5_6;
  // operations: 6 add, 10 multiply, 1 divide, 1 sqrt

  // --- step 2: closure Jacobian Phi_z and its factors (60), rocker_tip ---
  // rocker_tip
  const double s2_1 = fnma(p_rocker_C_x, R_rocker_x_z, p_rocker_C_z*R_rocker_x_x);
  const double s2_2 = fma(p_coupler_C_z, R_coupler_x_z, p_coupler_C_x*R_coupler_x_x);
  const double s2_3 = fma(p_rocker_C_z, R_rocker_x_z, p_rocker_C_x*R_rocker_x_x);
  const double s2_4 = fnma(p_coupler_C_x, R_coupler_x_z, p_coupler_C_z*R_coupler_x_x);
  const double s2_5 = r_coupler_z + s2_4;
  const double s2_6 = 1.0/s2_1;
  const double s2_7 = s2_3*s2_6;
  const double pivot_coupler_pin = fms(s2_4, s2_7, s2_2);
  const double s2_8 = fms(s2_5, s2_7, r_coupler_x) - s2_2;
  const double s2_9 = 1.0/pivot_coupler_pin;
  const double s2_10 = 3.2894736842105265*std::abs(pivot_coupler_pin);
  result.pivot[0] = mbgen::min(3.999888870509994*std::abs(s2_1), s2_10);
  // operations: 8 add, 13 multiply, 2 divide, 3 other

  // --- step 3: Rz (61), rocker_tip ---
  const double s3_1 = s2_8*s2_9;
  const double s3_2 = s2_6*fms(s2_4, s3_1, s2_5);
  // operations: 1 add, 3 multiply

  // --- step 6: c and dRz/dt zd (62), rocker_tip ---
  const double s6_1 = zd_crank_pin*zd_crank_pin;
  // coupler: coupler_pin, revolute, crank
  const double s6_2 = r_coupler_x*s6_1;
  const double s6_3 = r_coupler_z*s6_1;
  const double s6_4 = w_coupler_y*w_coupler_y;
  const double zd_rocker_pin = state.zd[Coordinate::rocker_pin];
  // rocker_tip
  const double s6_5 = zd_rocker_pin*s2_1;
  const double s6_6 = fnma(s2_2, s6_4, fms(zd_rocker_pin, zd_rocker_pin*s2_3, s6_2));
  const double s6_7 = s2_9*fma(s2_7, s6_6, fnma(s2_4, s6_4, fms(zd_rocker_pin, s6_5, s6_3)));
  const double s6_8 = s2_6*fms(s2_4, s6_7, s6_6);
  // operations: 6 add, 14 multiply

  // --- step 7: inertias of the bodies and forces on joints, rocker_tip ---
  const double s7_1 = fma(h_crank_z, R_crank_x_z, h_crank_x*R_crank_x_x);
  // coupler: coupler_pin, revolute, crank
  const double s7_2 = fma(h_coupler_z, R_coupler_x_z, h_coupler_x*R_coupler_x_x);
  const double s7_3 = fnma(h_coupler_x, R_coupler_x_z, h_coupler_z*R_coupler_x_x);
  const double s7_4 = fma(h_rocker_z, R_rocker_x_z, h_rocker_x*R_rocker_x_x);
  // operations: 4 add, 8 multiply

  // --- step 8: elimination from the leaves to the root (63), rocker_tip ---
  const double s8_1 = 1.0 - s3_1;
  const double s8_2 = 0.02195*s3_2;
  // coupler: coupler_pin, revolute, crank
  const double s8_3 = fma(s6_7, s7_3, fma(s6_4, s7_2, m_coupler*s6_2));
  const double s8_4 = -g_z - s6_3;
  const double f_coupler_z = fma(m_coupler, s8_4, fnma(s6_4, s7_3, s6_7*s7_2));
  const double s8_5 = fma(s7_2, s8_4, fma(s6_2, s7_3, 0.0729*s6_7));
  const double s8_6 = fma(s7_2, s8_1, m_coupler*r_coupler_x);
  const double s8_7 = fma(s7_3, s8_1, m_coupler*r_coupler_z);
  const double s8_8 = fma(0.0729, s8_1, fma(r_coupler_z, s7_3, r_coupler_x*s7_2));
  const double s8_9 = fma(r_coupler_z, s8_7, fma(r_coupler_x, s8_6, fma(s3_2, s8_2, 0.00302)));
  const double pivot_crank_pin = fma(s8_1, s8_8, s8_9);
  const double s8_10 = tau[Coordinate::rocker_pin] + fnma(s5_1, s5_7, s5_2*s5_8);
  const double s8_11 = inputs.torque + tau[Coordinate::crank_pin];
  const double s8_12 = fnma(g_z, s7_1, fnma(tau[Coordinate::coupler_pin], s3_1, s8_11));
  const double s8_13 = fma(r_coupler_x, f_coupler_z, fma(r_coupler_z, s8_3, s8_12));
  const double s8_14 = fnma(g_z, s7_4, fma(0.02195, s6_8, s8_10));
  const double s8_15 = fnma(s3_2, s8_14, fma(s8_1, s8_5, s8_13));
  const double s8_16 = 1.0/pivot_crank_pin;
  result.inertia[0] = pivot_crank_pin - 5.44e-25;
  // operations: 28 add, 31 multiply, 1 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  // crank: crank_pin, revolute, ground
  const double alpha_crank_y = s8_15*s8_16;
  result.zdd[Coordinate::crank_pin] = alpha_crank_y;
  // rocker: rocker_pin, revolute, ground
  result.zdd[Coordinate::rocker_pin] = -fma(s3_2, alpha_crank_y, s6_8);
  result.zdd[Coordinate::coupler_pin] = -fma(s3_1, alpha_crank_y, s6_7);
  // operations: 2 add, 3 multiply
}

/// Result of compute_closure.
struct Closure {
  double residual[5];  ///< of every closure equation, block after block, then of every motion
  double dz[3];  ///< Newton correction; driven coordinates go to their motions
  double zd[3];  ///< consistent velocities
  double pivot[1];  ///< smallest pivot of each block over its reference
  double Rz[3];  ///< free directions of each block, row by row
};

/// One Newton step of the frozen partition, and consistent velocities.
void compute_closure(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    Closure& __restrict result) noexcept {
  // Results that need no operation.
  result.Rz[1] = 1.0;
  result.dz[Coordinate::coupler_pin] = 0.0;
  result.residual[1] = 0.0;
  result.residual[3] = 0.0;
  result.residual[4] = 0.0;
  result.zd[Coordinate::coupler_pin] = state.zd[Coordinate::coupler_pin];

  // --- step 1: poses and axes b ---
  // crank: crank_pin, revolute, ground
  const double z_crank_pin = state.z[Coordinate::crank_pin];
  double R_crank_x_x, R_crank_x_z;
  mbgen::sincos(z_crank_pin, R_crank_x_z, R_crank_x_x);
  // coupler: coupler_pin, revolute, crank
  const double s1_1 = z_crank_pin + state.z[Coordinate::coupler_pin];
  double R_coupler_x_x, R_coupler_x_z;
  mbgen::sincos(s1_1, R_coupler_x_z, R_coupler_x_x);
  const double r_coupler_x = fma(p_coupler_pin_z, R_crank_x_z, p_coupler_pin_x*R_crank_x_x);
  const double r_coupler_z = fnma(p_coupler_pin_x, R_crank_x_z, p_coupler_pin_z*R_crank_x_x);
  // rocker: rocker_pin, revolute, ground
  const double z_rocker_pin = state.z[Coordinate::rocker_pin];
  double R_rocker_x_x, R_rocker_x_z;
  mbgen::sincos(z_rocker_pin, R_rocker_x_z, R_rocker_x_x);
  // operations: 3 add, 4 multiply, 6 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  // rocker_tip
  const double s2_1 = fnma(p_rocker_C_x, R_rocker_x_z, p_rocker_C_z*R_rocker_x_x);
  const double s2_2 = fma(p_coupler_C_z, R_coupler_x_z, p_coupler_C_x*R_coupler_x_x);
  const double s2_3 = fma(p_rocker_C_z, R_rocker_x_z, p_rocker_C_x*R_rocker_x_x);
  const double s2_4 = fnma(p_coupler_C_x, R_coupler_x_z, p_coupler_C_z*R_coupler_x_x);
  const double s2_5 = r_coupler_x + s2_2;
  const double s2_6 = s2_5 - p_rocker_pin_x - s2_3;
  result.residual[0] = s2_6;
  const double s2_7 = r_coupler_z + s2_4;
  const double s2_8 = s2_7 - s2_1;
  result.residual[2] = s2_8;
  const double s2_9 = 1.0/s2_1;
  const double s2_10 = s2_3*s2_9;
  const double pivot_crank_pin = fms(s2_7, s2_10, s2_5);
  const double s2_11 = fms(s2_4, s2_10, s2_2);
  const double s2_12 = 1.0/pivot_crank_pin;
  const double s2_13 = 3.999888870509994*std::abs(s2_1);
  result.pivot[0] = mbgen::min(s2_13, 2.5*std::abs(pivot_crank_pin));
  // operations: 11 add, 13 multiply, 2 divide, 3 other

  // --- step 4: velocities ---
  // loop block 0
  const double s4_1 = s2_12*fma(s2_6, s2_10, s2_8);
  result.dz[Coordinate::crank_pin] = -s4_1;
  result.dz[Coordinate::rocker_pin] = -(s2_9*fms(s2_7, s4_1, s2_6));

  // --- step 3: Rz (61) ---
  const double s3_1 = s2_11*s2_12;
  // loop block 0
  result.Rz[0] = -s3_1;
  const double s3_2 = s2_9*fms(s2_7, s3_1, s2_4);
  result.Rz[2] = -s3_2;
  // operations: 1 add, 3 multiply
  const double zd_coupler_pin = state.zd[Coordinate::coupler_pin];
  result.zd[Coordinate::crank_pin] = -(zd_coupler_pin*s3_1);
  result.zd[Coordinate::rocker_pin] = -(zd_coupler_pin*s3_2);
  // operations: 2 add, 6 multiply
}

/// Result of compute_multipliers.
struct ConstraintForces {
  double lambda[5];  ///< multipliers, loop after loop
  double drive[1];  ///< generalised driving forces
  double missing[3];  ///< force that multipliers and drives must provide, block after block
  double pivot[1];  ///< smallest pivot of each block over its reference
};

/// Multipliers of the closures and generalised driving forces, at given accelerations.
void compute_multipliers(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, const Derivative& derivative, ConstraintForces& __restrict result) noexcept {
  // Results that need no operation.
  result.lambda[1] = 0.0;
  result.lambda[3] = 0.0;
  result.lambda[4] = 0.0;

  // --- step 1: poses and axes b ---
  // crank: crank_pin, revolute, ground
  const double z_crank_pin = state.z[Coordinate::crank_pin];
  double R_crank_x_x, R_crank_x_z;
  mbgen::sincos(z_crank_pin, R_crank_x_z, R_crank_x_x);
  // coupler: coupler_pin, revolute, crank
  const double s1_1 = z_crank_pin + state.z[Coordinate::coupler_pin];
  double R_coupler_x_x, R_coupler_x_z;
  mbgen::sincos(s1_1, R_coupler_x_z, R_coupler_x_x);
  const double s1_2 = p_coupler_pin_z*R_crank_x_z;
  const double r_coupler_x = fma(p_coupler_pin_x, R_crank_x_x, s1_2);
  const double s1_3 = p_coupler_pin_z*R_crank_x_x;
  const double r_coupler_z = fnma(p_coupler_pin_x, R_crank_x_z, s1_3);
  // rocker: rocker_pin, revolute, ground
  const double z_rocker_pin = state.z[Coordinate::rocker_pin];
  double R_rocker_x_x, R_rocker_x_z;
  mbgen::sincos(z_rocker_pin, R_rocker_x_z, R_rocker_x_x);
  // operations: 3 add, 4 multiply, 6 sin cos

  // --- step 4: velocities ---
  // coupler: coupler_pin, revolute, crank
  const double zd_crank_pin = state.zd[Coordinate::crank_pin];
  const double w_coupler_y = zd_crank_pin + state.zd[Coordinate::coupler_pin];
  // operations: 1 add

  // --- step 5: applied forces Q (48) ---
  // return_spring
  const double s5_1 = p_rocker_S_x*R_rocker_x_z;
  const double s5_2 = p_rocker_S_x*R_rocker_x_x;
  const double s5_3 = fma(p_rocker_S_z, R_rocker_x_z, s5_2);
  const double s5_4 = fms(p_rocker_S_z, R_rocker_x_x, s5_1);
  const double s5_5 = 0.2 - s5_3;
  const double s5_6 = p_ground_S_z - s5_4;
  const double s5_7 = std::sqrt(fma(s5_6, s5_6, s5_5*s5_5));
  const double tension_return_spring = (s5_7 - l0_return_spring)*parameters.k;
  const double s5_8 = 1.0/s5_7*tension_return_spring;
  const double s5_9 = s5_6*s5_8;
  const double s5_10 = s5_5*s5_8;
  // operations: 6 add, 10 multiply, 1 divide, 1 sqrt

  // --- step 7: inertias of the bodies and forces on joints ---
  const double s7_1 = zd_crank_pin*zd_crank_pin;
  const double zdd_crank_pin = derivative.zdd[Coordinate::crank_pin];
  // coupler: coupler_pin, revolute, crank
  const double a_coupler_x = fnma(r_coupler_x, s7_1, zdd_crank_pin*r_coupler_z);
  const double a_coupler_z = fnma(r_coupler_z, s7_1, fnma(zdd_crank_pin, r_coupler_x, -g_z));
  const double alpha_coupler_y = zdd_crank_pin + derivative.zdd[Coordinate::coupler_pin];
  const double s7_2 = w_coupler_y*w_coupler_y;
  // rocker: rocker_pin, revolute, ground
  const double zd_rocker_pin = state.zd[Coordinate::rocker_pin];
  const double s7_3 = zd_rocker_pin*zd_rocker_pin;
  const double s7_4 = fms(c_rocker_z, R_rocker_x_x, s5_1);
  const double s7_5 = fma(c_rocker_z, R_rocker_x_z, s5_2);
  const double zdd_rocker_pin = derivative.zdd[Coordinate::rocker_pin];
  const double s7_6 = fnma(s5_4, s5_10, fma(s5_3, s5_9, I_rocker_yy*zdd_rocker_pin));
  const double s7_7 = fma(s7_4, m_rocker*fnma(s7_3, s7_5, zdd_rocker_pin*s7_4), s7_6);
  const double s7_8 = m_rocker*fnma(zdd_rocker_pin, s7_5, fnma(s7_3, s7_4, -g_z));
  const double n_rocker_y = fnma(s7_5, s7_8, s7_7);
  const double Q_rocker_pin = tau[Coordinate::rocker_pin] - n_rocker_y;
  result.missing[2] = Q_rocker_pin;
  // coupler: coupler_pin, revolute, crank
  const double s7_9 = fnma(c_coupler_x, R_coupler_x_z, c_coupler_z*R_coupler_x_x);
  const double s7_10 = fma(c_coupler_z, R_coupler_x_z, c_coupler_x*R_coupler_x_x);
  const double f_coupler_x = m_coupler*fnma(s7_2, s7_10, fma(alpha_coupler_y, s7_9, a_coupler_x));
  const double f_coupler_z = m_coupler*fnma(alpha_coupler_y, s7_10, fnma(s7_2, s7_9, a_coupler_z));
  const double s7_11 = fma(s7_9, f_coupler_x, I_coupler_yy*alpha_coupler_y);
  const double n_coupler_y = fnma(s7_10, f_coupler_z, s7_11);
  const double Q_coupler_pin = tau[Coordinate::coupler_pin] - n_coupler_y;
  result.missing[1] = Q_coupler_pin;
  // crank: crank_pin, revolute, ground
  const double s7_12 = fms(c_crank_z, R_crank_x_x, s1_2);
  const double s7_13 = fma(c_crank_z, R_crank_x_z, s1_3);
  const double f_crank_x = m_crank*fnma(s7_1, s7_13, zdd_crank_pin*s7_12);
  const double f_crank_z = m_crank*fnma(zdd_crank_pin, s7_13, fnma(s7_1, s7_12, -g_z));
  const double n_crank_y = fnma(s7_13, f_crank_z, fma(s7_12, f_crank_x, I_crank_yy*zdd_crank_pin));
  const double s7_14 = inputs.torque + tau[Coordinate::crank_pin];
  const double s7_15 = fma(r_coupler_x, f_coupler_z, fnma(r_coupler_z, f_coupler_x, s7_14));
  result.missing[0] = s7_15 - n_coupler_y - n_crank_y;
  // operations: 35 add, 46 multiply

  // --- step 9: multipliers of the closures and driving forces ---
  // rocker_tip
  const double s9_1 = fnma(p_rocker_C_x, R_rocker_x_z, p_rocker_C_z*R_rocker_x_x);
  const double s9_2 = fma(p_rocker_C_z, R_rocker_x_z, p_rocker_C_x*R_rocker_x_x);
  const double s9_3 = fnma(p_coupler_C_x, R_coupler_x_z, p_coupler_C_z*R_coupler_x_x);
  const double s9_4 = 1.0/s9_1;
  const double s9_5 = s9_2*s9_4;
  const double s9_6 = fnma(p_coupler_C_x, R_coupler_x_x, s9_3*s9_5);
  const double pivot_coupler_pin = fnma(p_coupler_C_z, R_coupler_x_z, s9_6);
  const double s9_7 = 3.2894736842105265*std::abs(pivot_coupler_pin);
  result.pivot[0] = mbgen::min(3.999888870509994*std::abs(s9_1), s9_7);
  const double s9_8 = Q_rocker_pin*s9_4;
  const double s9_9 = 1.0/pivot_coupler_pin*fma(s9_3, s9_8, Q_coupler_pin);
  result.lambda[2] = s9_9;
  result.lambda[0] = fms(s9_5, s9_9, s9_8);
  // operations: 7 add, 16 multiply, 2 divide, 3 other
}

/// Result of compute_closure_terms.
struct ClosureTerms {
  double Phi[5];  ///< residuals
  double Jz[15];  ///< Jacobian of each block, row by row
  double c[5];  ///< right-hand side of the accelerations
  double driven_acceleration[3];  ///< of driven coordinates, by their motions; no others
};

/// Closure equations and their derivatives, for the pivoting factorisation.
void compute_closure_terms(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, ClosureTerms& __restrict result) noexcept {
  // Results that need no operation.
  for (int k = 0; k < 15; ++k) result.Jz[k] = 0.0;
  result.Phi[1] = 0.0;
  result.Phi[3] = 0.0;
  result.Phi[4] = 0.0;
  result.c[1] = 0.0;
  result.c[3] = 0.0;
  result.c[4] = 0.0;

  // --- step 1: poses and axes b ---
  // crank: crank_pin, revolute, ground
  const double z_crank_pin = state.z[Coordinate::crank_pin];
  double R_crank_x_x, R_crank_x_z;
  mbgen::sincos(z_crank_pin, R_crank_x_z, R_crank_x_x);
  // coupler: coupler_pin, revolute, crank
  const double s1_1 = z_crank_pin + state.z[Coordinate::coupler_pin];
  double R_coupler_x_x, R_coupler_x_z;
  mbgen::sincos(s1_1, R_coupler_x_z, R_coupler_x_x);
  const double r_coupler_x = fma(p_coupler_pin_z, R_crank_x_z, p_coupler_pin_x*R_crank_x_x);
  const double r_coupler_z = fnma(p_coupler_pin_x, R_crank_x_z, p_coupler_pin_z*R_crank_x_x);
  // rocker: rocker_pin, revolute, ground
  const double z_rocker_pin = state.z[Coordinate::rocker_pin];
  double R_rocker_x_x, R_rocker_x_z;
  mbgen::sincos(z_rocker_pin, R_rocker_x_z, R_rocker_x_x);
  // operations: 3 add, 4 multiply, 6 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  const double zd_crank_pin = state.zd[Coordinate::crank_pin];
  const double s2_1 = zd_crank_pin + state.zd[Coordinate::coupler_pin];
  const double s2_2 = zd_crank_pin*zd_crank_pin;
  // rocker_tip
  const double s2_3 = fma(p_coupler_C_z, R_coupler_x_z, p_coupler_C_x*R_coupler_x_x);
  result.Jz[7] = -s2_3;
  const double s2_4 = fma(p_rocker_C_z, R_rocker_x_z, p_rocker_C_x*R_rocker_x_x);
  result.Jz[8] = s2_4;
  const double s2_5 = fnma(p_coupler_C_x, R_coupler_x_z, p_coupler_C_z*R_coupler_x_x);
  result.Jz[1] = s2_5;
  const double s2_6 = fnma(p_rocker_C_x, R_rocker_x_z, p_rocker_C_z*R_rocker_x_x);
  result.Jz[2] = -s2_6;
  const double s2_7 = r_coupler_x + s2_3;
  result.Phi[0] = s2_7 - p_rocker_pin_x - s2_4;
  const double s2_8 = r_coupler_z + s2_5;
  result.Jz[0] = s2_8;
  result.Phi[2] = s2_8 - s2_6;
  result.Jz[6] = -s2_7;
  const double zd_rocker_pin = state.zd[Coordinate::rocker_pin];
  const double s2_9 = fnma(zd_rocker_pin, zd_rocker_pin*s2_4, r_coupler_x*s2_2);
  result.c[0] = fma(s2_1, s2_1*s2_3, s2_9);
  const double s2_10 = fnma(zd_rocker_pin, zd_rocker_pin*s2_6, r_coupler_z*s2_2);
  result.c[2] = fma(s2_1, s2_1*s2_5, s2_10);
  // operations: 14 add, 19 multiply
}

/// Result of compute_chosen_accelerations.
struct ChosenAccelerations {
  double zdd[3];  ///< accelerations
  double xd[1];  ///< rates of the auxiliary states
  double inertia[1];  ///< pivots of the final equations
};

/// All accelerations with a partition chosen at run time.
void compute_chosen_accelerations(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, const Projection& projection,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 1: poses and axes b ---
  // crank: crank_pin, revolute, ground
  const double z_crank_pin = state.z[Coordinate::crank_pin];
  double R_crank_x_x, R_crank_x_z;
  mbgen::sincos(z_crank_pin, R_crank_x_z, R_crank_x_x);
  // coupler: coupler_pin, revolute, crank
  const double s1_1 = z_crank_pin + state.z[Coordinate::coupler_pin];
  double R_coupler_x_x, R_coupler_x_z;
  mbgen::sincos(s1_1, R_coupler_x_z, R_coupler_x_x);
  const double r_coupler_x = fma(p_coupler_pin_z, R_crank_x_z, p_coupler_pin_x*R_crank_x_x);
  const double r_coupler_z = fnma(p_coupler_pin_x, R_crank_x_z, p_coupler_pin_z*R_crank_x_x);
  // rocker: rocker_pin, revolute, ground
  const double z_rocker_pin = state.z[Coordinate::rocker_pin];
  double R_rocker_x_x, R_rocker_x_z;
  mbgen::sincos(z_rocker_pin, R_rocker_x_z, R_rocker_x_x);
  // operations: 3 add, 4 multiply, 6 sin cos

  // --- step 4: velocities ---
  // coupler: coupler_pin, revolute, crank
  const double zd_crank_pin = state.zd[Coordinate::crank_pin];
  const double w_coupler_y = zd_crank_pin + state.zd[Coordinate::coupler_pin];
  // operations: 1 add

  // --- step 5: applied forces Q (48) ---
  // return_spring
  const double s5_1 = fma(p_rocker_S_z, R_rocker_x_z, p_rocker_S_x*R_rocker_x_x);
  const double s5_2 = fnma(p_rocker_S_x, R_rocker_x_z, p_rocker_S_z*R_rocker_x_x);
  const double s5_3 = 0.2 - s5_1;
  const double s5_4 = p_ground_S_z - s5_2;
  const double s5_5 = std::sqrt(fma(s5_4, s5_4, s5_3*s5_3));
  const double tension_return_spring = (s5_5 - l0_return_spring)*parameters.k;
  const double s5_6 = 1.0/s5_5*tension_return_spring;
  const double s5_7 = s5_4*s5_6;
  const double s5_8 = s5_3*s5_6;
  // operations: 6 add, 10 multiply, 1 divide, 1 sqrt

  // --- step 6: c and dRz/dt zd (62), rocker_tip ---
  const double s6_1 = zd_crank_pin*zd_crank_pin;
  const double s6_2 = w_coupler_y*w_coupler_y;
  // operations: 2 multiply

  // --- step 7: inertias of the bodies and forces on joints, rocker_tip ---
  const double s7_1 = fma(h_crank_z, R_crank_x_z, h_crank_x*R_crank_x_x);
  // coupler: coupler_pin, revolute, crank
  const double s7_2 = fma(h_coupler_z, R_coupler_x_z, h_coupler_x*R_coupler_x_x);
  const double s7_3 = fnma(h_coupler_x, R_coupler_x_z, h_coupler_z*R_coupler_x_x);
  const double s7_4 = fma(h_rocker_z, R_rocker_x_z, h_rocker_x*R_rocker_x_x);
  // operations: 4 add, 8 multiply

  // --- step 8: elimination from the leaves to the root (63), rocker_tip ---
  // coupler: coupler_pin, revolute, crank
  const double s8_1 = projection.Rz[0] + projection.Rz[1];
  const double s8_2 = r_coupler_z*projection.Rz[0];
  const double s8_3 = r_coupler_x*projection.Rz[0];
  const double s8_4 = projection.zdd_star[0] + projection.zdd_star[1];
  // rocker: rocker_pin, revolute, ground
  const double s8_5 = fma(0.02195, projection.zdd_star[2], fnma(s5_2, s5_8, s5_1*s5_7));
  const double n_rocker_y = fma(g_z, s7_4, s8_5);
  const double s8_6 = 0.02195*projection.Rz[2];
  // coupler: coupler_pin, revolute, crank
  const double s8_7 = fnma(r_coupler_x, s6_1, r_coupler_z*projection.zdd_star[0]);
  const double f_coupler_x = fma(m_coupler, s8_7, fnma(s6_2, s7_2, s7_3*s8_4));
  const double s8_8 = fnma(r_coupler_z, s6_1, fnma(r_coupler_x, projection.zdd_star[0], -g_z));
  const double f_coupler_z = fnma(s7_2, s8_4, fnma(s6_2, s7_3, m_coupler*s8_8));
  const double n_coupler_y = fnma(s7_2, s8_8, fma(s7_3, s8_7, 0.0729*s8_4));
  const double s8_9 = fma(m_coupler, s8_2, s7_3*s8_1);
  const double s8_10 = fma(m_coupler, s8_3, s7_2*s8_1);
  const double s8_11 = fma(s7_2, s8_3, fma(s7_3, s8_2, 0.0729*s8_1));
  // crank: crank_pin, revolute, ground
  const double n_crank_y = fma(g_z, s7_1, 0.00302*projection.zdd_star[0]);
  const double s8_12 = fnma(s8_2, f_coupler_x, projection.Rz[1]*tau[Coordinate::coupler_pin]);
  const double s8_13 = inputs.torque + tau[Coordinate::crank_pin] - n_crank_y;
  const double s8_14 = fnma(s8_1, n_coupler_y, fma(s8_3, f_coupler_z, s8_12));
  const double s8_15 = tau[Coordinate::rocker_pin] - n_rocker_y;
  const double s8_16 = fma(projection.Rz[2], s8_15, fma(projection.Rz[0], s8_13, s8_14));
  const double s8_17 = fma(s8_3, s8_10, fma(s8_2, s8_9, projection.Rz[2]*s8_6));
  const double s8_18 = fma(projection.Rz[0], 0.00302*projection.Rz[0], fma(s8_1, s8_11, s8_17));
  const double s8_19 = 1.0/s8_18;
  result.inertia[0] = s8_18 - 5.44e-25;
  // operations: 32 add, 41 multiply, 1 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  const double s9_1 = s8_16*s8_19;
  // crank: crank_pin, revolute, ground
  result.zdd[Coordinate::crank_pin] = fma(projection.Rz[0], s9_1, projection.zdd_star[0]);
  // rocker: rocker_pin, revolute, ground
  result.zdd[Coordinate::rocker_pin] = fma(projection.Rz[2], s9_1, projection.zdd_star[2]);
  result.zdd[Coordinate::coupler_pin] = fma(projection.Rz[1], s9_1, projection.zdd_star[1]);
  // operations: 3 add, 4 multiply
}

/// Outputs, energies and power, at given accelerations.
void compute_outputs(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, const Derivative& /*derivative*/, Outputs& __restrict result) noexcept {
  // Results that need no operation.
  result.crank_angle = state.z[Coordinate::crank_pin];

  // --- step 1: poses and axes b ---
  // crank: crank_pin, revolute, ground
  const double z_crank_pin = state.z[Coordinate::crank_pin];
  double R_crank_x_x, R_crank_x_z;
  mbgen::sincos(z_crank_pin, R_crank_x_z, R_crank_x_x);
  // coupler: coupler_pin, revolute, crank
  const double s1_1 = z_crank_pin + state.z[Coordinate::coupler_pin];
  double R_coupler_x_x, R_coupler_x_z;
  mbgen::sincos(s1_1, R_coupler_x_z, R_coupler_x_x);
  const double s1_2 = p_coupler_pin_z*R_crank_x_z;
  const double r_coupler_x = fma(p_coupler_pin_x, R_crank_x_x, s1_2);
  const double s1_3 = p_coupler_pin_z*R_crank_x_x;
  const double r_coupler_z = fnma(p_coupler_pin_x, R_crank_x_z, s1_3);
  // rocker: rocker_pin, revolute, ground
  const double z_rocker_pin = state.z[Coordinate::rocker_pin];
  double R_rocker_x_x, R_rocker_x_z;
  mbgen::sincos(z_rocker_pin, R_rocker_x_z, R_rocker_x_x);
  // operations: 3 add, 4 multiply, 6 sin cos

  // --- step 4: velocities ---
  // coupler: coupler_pin, revolute, crank
  const double zd_crank_pin = state.zd[Coordinate::crank_pin];
  const double v_coupler_x = zd_crank_pin*r_coupler_z;
  const double zd_coupler_pin = state.zd[Coordinate::coupler_pin];
  const double w_coupler_y = zd_crank_pin + zd_coupler_pin;
  // operations: 1 add, 1 multiply

  // --- step 5: applied forces Q (48) ---
  // return_spring
  const double s5_1 = p_rocker_S_x*R_rocker_x_z;
  const double s5_2 = p_rocker_S_x*R_rocker_x_x;
  const double s5_3 = fma(p_rocker_S_z, R_rocker_x_z, s5_2);
  const double s5_4 = fms(p_rocker_S_z, R_rocker_x_x, s5_1);
  const double s5_5 = 0.2 - s5_3;
  const double s5_6 = p_ground_S_z - s5_4;
  const double s5_7 = std::sqrt(fma(s5_6, s5_6, s5_5*s5_5));
  const double tension_return_spring = (s5_7 - l0_return_spring)*parameters.k;
  result.spring_force = tension_return_spring;
  const double s5_8 = 1.0/s5_7*tension_return_spring;
  const double s5_9 = s5_6*s5_8;
  const double s5_10 = s5_5*s5_8;
  // operations: 6 add, 10 multiply, 1 divide, 1 sqrt

  // --- step 7: inertias of the bodies and forces on joints ---
  // rocker: rocker_pin, revolute, ground
  const double s7_1 = fms(c_rocker_z, R_rocker_x_x, s5_1);
  const double s7_2 = fma(c_rocker_z, R_rocker_x_z, s5_2);
  const double zd_rocker_pin = state.zd[Coordinate::rocker_pin];
  const double s7_3 = I_rocker_yy*zd_rocker_pin;
  // coupler: coupler_pin, revolute, crank
  const double s7_4 = fnma(c_coupler_x, R_coupler_x_z, c_coupler_z*R_coupler_x_x);
  const double s7_5 = fma(c_coupler_z, R_coupler_x_z, c_coupler_x*R_coupler_x_x);
  const double s7_6 = I_coupler_yy*w_coupler_y;
  // crank: crank_pin, revolute, ground
  const double s7_7 = fms(c_crank_z, R_crank_x_x, s1_2);
  const double s7_8 = fma(c_crank_z, R_crank_x_z, s1_3);
  const double s7_9 = I_crank_yy*zd_crank_pin;
  const double s7_10 = inputs.torque + tau[Coordinate::crank_pin];
  // operations: 7 add, 11 multiply

  // --- step 9: outputs, energies, power ---
  // coupler_x
  const double s9_1 = fma(p_coupler_P_z, R_coupler_x_z, p_coupler_P_x*R_coupler_x_x);
  result.coupler_x = r_coupler_x + s9_1;
  const double s9_2 = fnma(p_coupler_P_x, R_coupler_x_z, p_coupler_P_z*R_coupler_x_x);
  result.coupler_z = r_coupler_z + s9_2;
  const double s9_3 = zd_crank_pin*s7_8;
  const double s9_4 = zd_rocker_pin*s7_2;
  const double s9_5 = fma(w_coupler_y, s7_5, zd_crank_pin*r_coupler_x);
  const double s9_6 = fma(zd_crank_pin, s7_10, zd_coupler_pin*tau[Coordinate::coupler_pin]);
  const double s9_7 = fma(s5_4, s5_10, fnma(s5_3, s5_9, tau[Coordinate::rocker_pin]));
  result.applied_power = fma(zd_rocker_pin, s9_7, s9_6);
  const double s9_8 = fma(m_coupler, r_coupler_z + s7_4, fma(m_crank, s7_7, m_rocker*s7_1));
  result.potential_energy = -g_z*s9_8;
  const double s9_9 = zd_rocker_pin*s7_1;
  const double s9_10 = zd_crank_pin*s7_7;
  const double s9_11 = fma(w_coupler_y, s7_4, v_coupler_x);
  const double s9_12 = fma(zd_crank_pin, s7_9, fma(w_coupler_y, s7_6, zd_rocker_pin*s7_3));
  const double s9_13 = fma(m_rocker, fma(s9_9, s9_9, s9_4*s9_4), s9_12);
  const double s9_14 = fma(m_crank, fma(s9_10, s9_10, s9_3*s9_3), s9_13);
  result.kinetic_energy = 0.5*fma(m_coupler, fma(s9_11, s9_11, s9_5*s9_5), s9_14);
  // operations: 21 add, 33 multiply
}


/// Sizes, tables and programs of this model for the runtime's algorithms; see mbgen/solver.hpp.
struct System {
  using Parameters = four_bar::Tuned;
  using Inputs = four_bar::Inputs;
  using State = four_bar::State;
  using Derivative = four_bar::Derivative;
  using Multipliers = four_bar::Multipliers;
  static constexpr int kCoordinates = 3;
  static constexpr int kAuxiliaryStates = 0;
  static constexpr int kBlocks = 1;
  static constexpr int kEquations = 5;
  static constexpr int kFreeDirections = 1;
  static constexpr bool kHasClosure = true;
  static constexpr int kDrives = 0;
  static constexpr double kClosureTolerance = 1e-12;
  static constexpr int kBlockCoordinates = 3;
  static constexpr mbgen::FreeDirection kFreeDirection[] = {{1, 0, 0}};
  static constexpr double Parameters::*kParameterMember[] = {&Parameters::k};
  static constexpr double Inputs::*kInputMember[] = {&Inputs::torque};
  static constexpr unsigned char kDriven[] = {0, 0, 0};
  static constexpr unsigned char kRedundant[] = {0, 1, 0, 1, 1};
  static constexpr int kDriveCoordinate[] = {0};
  static constexpr mbgen::BlockLayout kBlockLayout[] = {{5, 3, 2, 1, 0, 0, 0, 0, 0.24}};
  static constexpr int kBlockCoordinate[] = {0, 1, 2};
  static constexpr unsigned char kBlockDriven[] = {0, 0, 0};
  static constexpr int kMultiplierPlace[] = {0, 1, 2, 3, 4};
  using Accelerations = four_bar::Accelerations;
  static constexpr auto accelerations = &compute_accelerations;
  using Closure = four_bar::Closure;
  static constexpr auto closure = &compute_closure;
  using ConstraintForces = four_bar::ConstraintForces;
  static constexpr auto multipliers = &compute_multipliers;
  using ClosureTerms = four_bar::ClosureTerms;
  static constexpr auto closure_terms = &compute_closure_terms;
  using ChosenAccelerations = four_bar::ChosenAccelerations;
  static constexpr auto chosen_accelerations = &compute_chosen_accelerations;
  using Projection = four_bar::Projection;
  static double argument_sum(const Parameters& parameters, const Inputs& inputs) noexcept {
    return parameters.k + inputs.torque;
  }
};

}  // namespace

State initial_state() noexcept {
  static constexpr State start = {
      {0.0, 0.0, 0.0},
      {12.000000000000002, -15.789473684210527, -0.6315789473684219},
      {0.0},
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
constexpr double kTurning[] = {1.0, 1.0, 1.0};

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
  if (status.ok()) compute_outputs(parameters, inputs, state, tau, derivative, values);
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

}  // namespace four_bar
