// pulled_wheel, content hash b0d917ec774bd98f
// Made by `mbgen generate pulled_wheel.json`, mbgen 0.1.0. Change the model, not this file.
#include "pulled_wheel_batch.hpp"

#include "mbgen/batch_steps.hpp"
#include "mbgen/elementary.hpp"
#include "mbgen/lanes.hpp"

#include <cmath>

namespace pulled_wheel::batch {

using mbgen::fma;   // a b + c, rounded once
using mbgen::fms;   // a b - c
using mbgen::fnma;  // c - a b, of fnma(a, b, c)

namespace {

/// A row of kLanes numbers is cut into vectors of the processor, one a group of instances.
constexpr int kGroups = kLanes / mbgen::lanes_of_vectors(kLanes);
using Lanes = mbgen::LaneTypes<kLanes / kGroups>::Lanes;
using Row = mbgen::RowOf<Lanes, kGroups>;

/// The programs of the solver on vectors, and the structs that they take and give. A program takes one struct a group:
/// the code of a part serves all groups before that of the next part comes into the cache.
namespace lanes {

struct Parameters {
  Lanes k;
  Lanes ballast;
};
/// Tunable parameters with the 7 constants that follow from them. Functions take plain Parameters
/// as well, and then work these out each time: keep one of these, and assign Parameters to it where
/// they change, at the boundary of a step. Among them: [1] m_knuckle, [3] c_knuckle_z, [4]
/// m_knuckle_2, [5] I_knuckle_yy.
struct Tuned : Parameters {
  Lanes derived[7];
};
struct Inputs {
};
template <class Lanes>
struct StateOf {
  Lanes z[kCoordinates];
  Lanes zd[kCoordinates];
  Lanes x[2];
  Lanes t;
};
using State = StateOf<Lanes>;
template <class Lanes>
struct JointForcesOf {
  Lanes tau[kCoordinates];
};
using JointForces = JointForcesOf<Lanes>;
template <class Lanes>
struct DerivativeOf {
  Lanes zdd[kCoordinates];
  Lanes xd[2];
};
using Derivative = DerivativeOf<Lanes>;
template <class Lanes>
struct MultipliersOf {
  Lanes lambda[1];
  Lanes drive[1];
};
using Multipliers = MultipliersOf<Lanes>;
template <class Lanes>
struct OutputsOf {
  Lanes load;
  Lanes wheel_speed;
  Lanes hub_height;
  Lanes spring_force;
  Lanes kinetic_energy;
  Lanes potential_energy;
  Lanes applied_power;
};
using Outputs = OutputsOf<Lanes>;

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

/// Constants that follow from tunable parameters.
void compute_derived_constants(const Parameters& parameters, Tuned& __restrict result) noexcept {
  // --- step 1: poses and axes b ---
  const Lanes m_knuckle = 22.0 + parameters.ballast;
  result.derived[4] = m_knuckle;
  const Lanes s1_1 = parameters.ballast/m_knuckle;
  const Lanes s1_2 = 0.0121*(22.0*s1_1);
  const Lanes c_knuckle_z = 0.04 + 0.11*s1_1;
  result.derived[3] = c_knuckle_z;
  const Lanes I_knuckle_xx = 0.31 + s1_2;
  const Lanes I_knuckle_yy = 0.36 + s1_2;
  result.derived[5] = I_knuckle_yy;
  const Lanes s1_3 = 0.5*(I_knuckle_yy + (I_knuckle_zz + I_knuckle_xx));
  const Lanes K_knuckle_xx = s1_3 - I_knuckle_xx;
  const Lanes s1_4 = m_knuckle*c_knuckle_z;
  const Lanes h_knuckle_z = 0.72 + s1_4;
  const Lanes K_knuckle_zz = s1_3 + (c_knuckle_z*s1_4 - 0.2312);

  // --- step 8: elimination from the leaves to the root (63), upper ---
  const Lanes m_knuckle_2 = m_wheel + m_knuckle;
  result.derived[1] = m_knuckle_2;

  // --- step 9: outputs, energies, power ---
  const Lanes s8_1 = h_knuckle_z*(1.0/m_knuckle_2);
  result.derived[0] = s8_1;
  result.derived[6] = p_pull_z*(345.0 + m_knuckle);
  result.derived[2] = K_knuckle_xx + K_knuckle_zz - h_knuckle_z*s8_1;
  // operations of step 1: poses and axes b: 11 add, 6 multiply, 1 divide
  // operations of step 8: elimination from the leaves to the root (63), upper: 2 add, 2 multiply, 1
  // divide
  // operations of step 9: outputs, energies, power: 1 add, 1 multiply
}

/// Result of compute_accelerations.
template <class Lanes>
struct AccelerationsOf {
  Lanes zdd[4];  ///< accelerations
  Lanes xd[2];  ///< rates of the auxiliary states
  Lanes pivot[1];  ///< smallest pivot of each block over its reference
  Lanes inertia[2];  ///< pivots of the final equations
};
using Accelerations = AccelerationsOf<Lanes>;

/// Part 1 of compute_accelerations: step 1: poses and axes b; step 5: applied forces Q (48); step
/// 9: accelerations from the root to the leaves (63), (62); step 2: closure Jacobian Phi_z and its
/// factors (60), upper; step 4: velocities; step 6: c and dRz/dt zd (62), upper; step 3: Rz (61),
/// upper; step 8: elimination from the leaves to the root (63), upper.
[[gnu::noinline]] void compute_accelerations_1(const Tuned& parameters, const State& state,
    const Lanes* tau, Accelerations& __restrict result) noexcept {
  // Results that need no operation.
  result.inertia[1] = Lanes{} + 1.0;
  result.zdd[Coordinate::pull] = Lanes{} + 0.0;

  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const Lanes z_lower = state.z[Coordinate::lower];
  Lanes R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);

  // --- step 5: applied forces Q (48) ---
  // spring
  const Lanes s5_1 = fma(p_arm_seat_x, R_arm_x_x, p_arm_seat_z*R_arm_x_z);
  const Lanes s5_2 = fnma(p_arm_seat_x, R_arm_x_z, p_arm_seat_z*R_arm_x_x);
  const Lanes s5_3 = s5_1 - p_carriage_seat_x;
  const Lanes zd_lower = state.zd[Coordinate::lower];
  const Lanes s5_4 = 0.37 - s5_2;
  const Lanes s5_5 = mbgen::sqrt(fma(s5_4, s5_4, s5_3*s5_3));
  const Lanes s5_6 = 1.0/s5_5;
  const Lanes s5_7 = fma(zd_lower*s5_1, s5_4, s5_3*(zd_lower*s5_2))*s5_6;
  const Lanes s5_8 = mbgen::select(0.2 + s5_7, 1600.0*s5_7, fms(725.0, 1.0 + s5_7, 900.0));
  const Lanes s5_9 = s5_7 - 0.2;
  const Lanes s5_10 = mbgen::select(s5_7, 3200.0*s5_7, s5_8);
  const Lanes s5_11 = mbgen::select(s5_9, fma(1575.0, s5_9, 640.0), s5_10);
  const Lanes tension_spring = s5_11 + fma(s5_5 - l0_spring, parameters.k, f0_spring);
  const Lanes s5_12 = s5_6*tension_spring;

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  const Lanes s1_1 = z_lower + state.z[Coordinate::ball];
  // knuckle: ball, revolute, arm
  Lanes R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_1, R_knuckle_x_z, R_knuckle_x_x);
  const Lanes r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const Lanes s1_2 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const Lanes r_knuckle_z = s1_2 + p_lower_z;
  const Lanes s1_3 = p_wheel_z*R_knuckle_x_x;
  // wheel: wheel, revolute, knuckle
  const Lanes r_wheel_z = r_knuckle_z + s1_3;

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper ---
  const Lanes s5_13 = radius_tyre - (p_pull_z + r_wheel_z);
  const Lanes s5_14 = mbgen::max(0.0, k_tyre*s5_13);
  const Lanes s5_15 = fnma(0.3333333333333333, mbgen::max(0.0, s5_13), radius_tyre);
  const Lanes s1_4 = p_wheel_z*R_knuckle_x_z;

  // --- step 4: velocities ---
  const Lanes s4_1 = zd_lower*r_knuckle_x;
  // knuckle: ball, revolute, arm
  const Lanes w_knuckle_y = zd_lower + state.zd[Coordinate::ball];

  // --- step 5: applied forces Q (48), continued ---
  // tyre
  const Lanes s5_16 = s5_14 + mbgen::min(s5_14, d_tyre*fma(s1_4, w_knuckle_y, s4_1));
  const Lanes load_tyre = mbgen::max(0.0, s5_16);
  const Lanes s5_17 = mbgen::max(0.004, load_tyre);
  const Lanes s5_18 = 1.1*s5_17;
  const Lanes s5_19 = 1.6*s5_18;
  const Lanes s5_20 = 1e-09*s5_17;
  mbgen::read_back();
  const Lanes s5_21 = mbgen::min(s5_19, -s5_20);
  // knuckle: ball, revolute, arm
  const Lanes v_knuckle_x = fma(zd_lower, s1_2, state.zd[Coordinate::pull]);
  // wheel: wheel, revolute, knuckle
  const Lanes v_wheel_x = fma(s1_3, w_knuckle_y, v_knuckle_x);
  const Lanes s5_22 = 3.3333333333333335*state.x[0];
  const Lanes s5_23 = 1.6666666666666667*state.x[1];
  const Lanes s5_24 = mbgen::sqrt(fma(s5_23, s5_23, fma(s5_22, s5_22, 1e-30)));
  const Lanes w_wheel_y = state.zd[Coordinate::wheel] + w_knuckle_y;
  // tyre
  const Lanes s5_25 = w_wheel_y*s5_15;
  const Lanes s5_26 = mbgen::abs(v_wheel_x);
  const Lanes s5_27 = v_wheel_x - s5_25;
  const Lanes s5_28 = mbgen::sqrt(fma(s5_27, s5_27, 1e-30));
  const Lanes s5_29 = mbgen::min(0.5, 0.1*fma(0.5, s5_26 + s5_28, 1.0));
  const Lanes s5_30 = s5_26 + s5_28/s5_29;
  const Lanes s5_31 = 1.0 - s5_24/s5_29;
  result.xd[1] = -(s5_23*s5_30);
  result.xd[0] = -fma(s5_22, s5_30, s5_27);
  const Lanes s5_32 = mbgen::cosine(3.141592653589793*mbgen::min(1.0, 0.5*s5_26));
  const Lanes s5_33 = s5_22*(1.0/mbgen::max(0.6666666666666666*s5_24, s5_31));
  const Lanes s5_34 = fnma(s5_27, 0.06*fma(0.5, s5_32, 0.5)*mbgen::max(0.0, s5_31), s5_33);
  const Lanes s5_35 = 20.0*s5_17/mbgen::select(s5_19, mbgen::max(s5_19, s5_20), s5_21)*s5_34;
  const Lanes s5_36 = s5_18*mbgen::sine(1.6*mbgen::arc_tangent(s5_35));
  const Lanes fx_tyre = mbgen::max(0.0, load_tyre)/s5_17*s5_36;
  const Lanes tau_wheel = tau[Coordinate::wheel];
  const Lanes s2_1 = fma(p_upper_to_z, R_knuckle_x_z, p_upper_to_x*R_knuckle_x_x);
  const Lanes s2_2 = fnma(p_upper_to_x, R_knuckle_x_z, p_upper_to_z*R_knuckle_x_x);
  const Lanes s2_3 = s2_2 + (r_knuckle_z - p_upper_from_z);
  const Lanes s2_4 = p_upper_from_x - r_knuckle_x - s2_1;
  const Lanes s2_5 = fma(s2_2, s2_4, s2_1*s2_3);
  mbgen::read_back();

  // --- step 6: c and dRz/dt zd (62), upper ---
  const Lanes s6_1 = w_knuckle_y*s2_1;
  const Lanes s6_2 = w_knuckle_y*s2_2;
  const Lanes s6_3 = s4_1 + s6_1;
  const Lanes s6_4 = fma(zd_lower, s1_2, s6_2);
  const Lanes s6_5 = zd_lower*zd_lower;
  const Lanes s6_6 = s1_2*s6_5;
  const Lanes s6_7 = r_knuckle_x*s6_5;
  const Lanes s6_8 = w_knuckle_y*w_knuckle_y;
  const Lanes s6_9 = fnma(s2_3, fma(w_knuckle_y, s6_2, s6_6), fma(s6_3, s6_3, s6_4*s6_4));
  const Lanes s2_6 = 1.0/s2_5;

  // --- step 3: Rz (61), upper ---
  const Lanes s3_1 = (s2_5 + fma(s1_2, s2_4, r_knuckle_x*s2_3))*s2_6;
  const Lanes zdd_star_ball = s2_6*fma(s2_4, fma(w_knuckle_y, s6_1, s6_7), s6_9);
  result.pivot[0] = 12.094222040829795*mbgen::abs(s2_5);
  const Lanes s9_1 = fnma(s5_1, s5_4*s5_12, fnma(s5_2, s5_3*s5_12, tau[Coordinate::lower]));

  // --- step 8: elimination from the leaves to the root (63), upper ---
  // knuckle: ball, revolute, arm
  const Lanes s8_1 = R_knuckle_x_z*parameters.derived[0];
  const Lanes s8_2 = R_knuckle_x_x*parameters.derived[0];
  const Lanes m_knuckle = parameters.derived[1];
  const Lanes s8_3 = fnma(s6_8, s8_1, fms(zdd_star_ball, s8_2, s6_7));
  const Lanes f_knuckle_x = fms(s8_3, m_knuckle, fx_tyre);
  const Lanes s8_4 = fma(zdd_star_ball, s8_1, fma(s6_8, s8_2, s6_6));
  const Lanes s8_5 = fma(zdd_star_ball, parameters.derived[2], tau_wheel);
  const Lanes n_knuckle_y = fma(fx_tyre, s8_2 - s1_3, fma(load_tyre, s1_4 - s8_1, s8_5));
  const Lanes s5_37 = mbgen::hyperbolic_tangent(0.5*s5_25);
  const Lanes s5_38 = radius_tyre*(rolling_tyre*load_tyre);
  const Lanes s8_6 = 1.0 - s3_1;
  const Lanes s8_7 = fma(s8_6, s8_1, r_knuckle_x);
  const Lanes s8_8 = fma(s8_6, s8_2, s1_2);
  const Lanes s9_2 = fnma(s8_6, n_knuckle_y, fnma(tau[Coordinate::ball], s3_1, s9_1));
  const Lanes s9_3 = fnma(fma(m_knuckle, s8_4, load_tyre), s8_7, s9_2);
  const Lanes s8_9 = m_knuckle*s8_7;
  const Lanes s8_10 = fma(s8_6, s8_6*parameters.derived[2], fma(s8_7, s8_9, 0.3475));
  const Lanes pivot_lower = fma(s8_8, m_knuckle*s8_8, s8_10);
  const Lanes s8_11 = s8_9 + fma(h_arm_x, R_arm_x_x, h_arm_z*R_arm_x_z);
  result.inertia[0] = pivot_lower - 5.52e-23;
  // arm: lower, revolute, carriage
  const Lanes alpha_arm_y = 1.0/pivot_lower*fnma(g_z, s8_11, fnma(f_knuckle_x, s8_8, s9_3));
  result.zdd[Coordinate::lower] = alpha_arm_y;
  const Lanes s9_4 = fnma(s3_1, alpha_arm_y, zdd_star_ball);
  result.zdd[Coordinate::ball] = s9_4;
  // knuckle: ball, revolute, arm
  const Lanes alpha_knuckle_y = alpha_arm_y + s9_4;
  result.zdd[Coordinate::wheel] = fnma(s5_37, s5_38, fnma(s5_15, fx_tyre,
      tau_wheel)) - alpha_knuckle_y;
  // operations of step 1: poses and axes b: 5 add, 6 multiply, 4 sin cos
  // operations of step 4: velocities: 5 add, 4 multiply
  // operations of step 5: applied forces Q (48): 29 add, 51 multiply, 6 divide, 3 sqrt, 3 sin cos,
  // 18 other
  // operations of step 2: closure Jacobian Phi_z and its factors (60), upper: 9 add, 9 multiply, 1
  // divide, 1 other
  // operations of step 3: Rz (61), upper: 1 multiply
  // operations of step 6: c and dRz/dt zd (62), upper: 7 add, 14 multiply
  // operations of step 8: elimination from the leaves to the root (63), upper: 20 add, 21 multiply,
  // 1 divide
  // operations of step 9: accelerations from the root to the leaves (63), (62): 12 add, 11 multiply
}

/// All accelerations with the frozen partition of the loop blocks.
void compute_accelerations(const Tuned* parameters, const Inputs* /*inputs*/, const State* state,
    const JointForces* tau, Accelerations* __restrict result) noexcept {
  for (int g = 0; g < kGroups; ++g)
    compute_accelerations_1(parameters[g], state[g], tau[g].tau, result[g]);
}

/// Result of compute_closure.
template <class Lanes>
struct ClosureOf {
  Lanes residual[2];  ///< of every closure equation, block after block, then of every motion
  Lanes dz[4];  ///< Newton correction; driven coordinates go to their motions
  Lanes zd[4];  ///< consistent velocities
  Lanes pivot[1];  ///< smallest pivot of each block over its reference
  Lanes Rz[2];  ///< free directions of each block, row by row
};
using Closure = ClosureOf<Lanes>;

/// Part 1 of compute_closure: step 1: poses and axes b; step 2: closure Jacobian Phi_z and its
/// factors (60); step 4: velocities; step 3: Rz (61).
[[gnu::noinline]] void compute_closure_1(const State& state, Closure& __restrict result) noexcept {
  // Results that need no operation.
  result.Rz[1] = Lanes{} + 1.0;
  result.dz[Coordinate::ball] = Lanes{} + 0.0;
  result.dz[Coordinate::wheel] = Lanes{} + 0.0;
  result.zd[Coordinate::pull] = Lanes{} + 15.0;
  result.zd[Coordinate::ball] = state.zd[Coordinate::ball];
  result.zd[Coordinate::wheel] = state.zd[Coordinate::wheel];

  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const Lanes z_lower = state.z[Coordinate::lower];
  Lanes R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);
  // knuckle: ball, revolute, arm
  const Lanes r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const Lanes s1_1 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const Lanes s1_2 = z_lower + state.z[Coordinate::ball];
  Lanes R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_2, R_knuckle_x_z, R_knuckle_x_x);

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  const Lanes s2_1 = fma(p_upper_to_z, R_knuckle_x_z, p_upper_to_x*R_knuckle_x_x);
  const Lanes s2_2 = fnma(p_upper_to_x, R_knuckle_x_z, p_upper_to_z*R_knuckle_x_x);
  const Lanes s2_3 = p_upper_from_x - r_knuckle_x - s2_1;
  // knuckle: ball, revolute, arm
  const Lanes r_knuckle_z = s1_1 + p_lower_z;
  const Lanes s2_4 = s2_2 + (r_knuckle_z - p_upper_from_z);
  const Lanes s2_5 = 2.380277794628896*s2_3;
  const Lanes s2_6 = 2.380277794628896*s2_4;
  const Lanes s2_7 = fma(s2_1, s2_6, s2_5*s2_2);
  const Lanes s2_8 = s2_7 + fma(r_knuckle_x, s2_6, s1_1*s2_5);
  const Lanes s2_9 = 0.5*fma(s2_4, s2_6, fms(s2_3, s2_5, l_upper));
  result.residual[0] = s2_9;
  result.pivot[0] = 4.409001792788769*mbgen::abs(s2_8);
  const Lanes s2_10 = 1.0/s2_8;

  // --- step 4: velocities ---
  result.dz[Coordinate::lower] = s2_9*s2_10;

  // --- step 3: Rz (61) ---
  const Lanes s3_1 = s2_7*s2_10;
  // loop block 0
  result.Rz[0] = -s3_1;
  result.zd[Coordinate::lower] = -(state.zd[Coordinate::ball]*s3_1);
  const Lanes s1_3 = fms(15.0, state.t, state.z[Coordinate::pull]);
  result.residual[1] = s1_3;
  result.dz[Coordinate::pull] = s1_3;
  // operations of step 1: poses and axes b: 5 add, 5 multiply, 4 sin cos
  // operations of step 4: velocities: 2 multiply
  // operations of step 2: closure Jacobian Phi_z and its factors (60): 11 add, 14 multiply, 1
  // divide, 1 other
  // operations of step 3: Rz (61): 1 multiply
}

/// One Newton step of the frozen partition, and consistent velocities.
void compute_closure(const Tuned* /*parameters*/, const Inputs* /*inputs*/, const State* state,
    Closure* __restrict result) noexcept {
  for (int g = 0; g < kGroups; ++g)
    compute_closure_1(state[g], result[g]);
}

/// Result of compute_multipliers.
template <class Lanes>
struct ConstraintForcesOf {
  Lanes lambda[1];  ///< multipliers, loop after loop
  Lanes drive[1];  ///< generalised driving forces
  Lanes missing[2];  ///< force that multipliers and drives must provide, block after block
  Lanes pivot[1];  ///< smallest pivot of each block over its reference
};
using ConstraintForces = ConstraintForcesOf<Lanes>;

/// Part 1 of compute_multipliers: step 1: poses and axes b; step 5: applied forces Q (48); step 4:
/// velocities; step 9: multipliers of the closures and driving forces; step 7: inertias of the
/// bodies and forces on joints.
[[gnu::noinline]] void compute_multipliers_1(const Tuned& parameters, const State& state,
    const Lanes* tau, const Derivative& derivative, ConstraintForces& __restrict result) noexcept {
  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const Lanes z_lower = state.z[Coordinate::lower];
  Lanes R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);

  // --- step 5: applied forces Q (48) ---
  // spring
  const Lanes s5_1 = fma(p_arm_seat_x, R_arm_x_x, p_arm_seat_z*R_arm_x_z);
  const Lanes s5_2 = fnma(p_arm_seat_x, R_arm_x_z, p_arm_seat_z*R_arm_x_x);
  const Lanes s5_3 = s5_1 - p_carriage_seat_x;
  const Lanes zd_lower = state.zd[Coordinate::lower];
  const Lanes s5_4 = 0.37 - s5_2;
  const Lanes s5_5 = mbgen::sqrt(fma(s5_4, s5_4, s5_3*s5_3));
  const Lanes s5_6 = 1.0/s5_5;
  const Lanes s5_7 = fma(zd_lower*s5_1, s5_4, s5_3*(zd_lower*s5_2))*s5_6;
  const Lanes s5_8 = 0.2 + s5_7;
  const Lanes s5_9 = fms(725.0, 1.0 + s5_7, 900.0);
  const Lanes s5_10 = mbgen::select(s5_8, fms(1600.0, s5_8, 320.0), s5_9);
  const Lanes s5_11 = s5_7 - 0.2;
  const Lanes s5_12 = mbgen::select(s5_7, 3200.0*s5_7, s5_10);
  const Lanes s5_13 = mbgen::select(s5_11, fma(1575.0, s5_11, 640.0), s5_12);
  const Lanes tension_spring = s5_13 + fma(s5_5 - l0_spring, parameters.k, f0_spring);
  const Lanes s5_14 = s5_6*tension_spring;
  const Lanes s5_15 = s5_3*s5_14;
  const Lanes s1_1 = z_lower + state.z[Coordinate::ball];
  // knuckle: ball, revolute, arm
  Lanes R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_1, R_knuckle_x_z, R_knuckle_x_x);
  const Lanes r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);
  const Lanes s1_2 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  const Lanes s1_3 = p_wheel_z*R_knuckle_x_z;

  // --- step 4: velocities ---
  // knuckle: ball, revolute, arm
  const Lanes w_knuckle_y = zd_lower + state.zd[Coordinate::ball];
  const Lanes r_knuckle_z = s1_2 + p_lower_z;
  const Lanes s1_4 = p_wheel_z*R_knuckle_x_x;
  // wheel: wheel, revolute, knuckle
  const Lanes r_wheel_z = r_knuckle_z + s1_4;

  // --- step 9: multipliers of the closures and driving forces ---

  // --- step 5: applied forces Q (48), continued ---
  // tyre
  const Lanes s5_16 = radius_tyre - (p_pull_z + r_wheel_z);
  const Lanes s5_17 = mbgen::max(0.0, k_tyre*s5_16);
  const Lanes s5_18 = fnma(0.3333333333333333, mbgen::max(0.0, s5_16), radius_tyre);
  const Lanes s5_19 = mbgen::min(s5_17, d_tyre*fma(s1_3, w_knuckle_y, zd_lower*r_knuckle_x));
  const Lanes load_tyre = mbgen::max(0.0, s5_17 + s5_19);
  const Lanes s5_20 = mbgen::max(0.004, load_tyre);
  const Lanes s5_21 = 1.1*s5_20;
  const Lanes s5_22 = 1.6*s5_21;
  const Lanes s5_23 = 1e-09*s5_20;
  mbgen::read_back();
  const Lanes s5_24 = mbgen::min(s5_22, -s5_23);
  const Lanes s5_25 = 3.3333333333333335*state.x[0];
  const Lanes s5_26 = 1.6666666666666667*state.x[1];
  const Lanes s5_27 = mbgen::sqrt(fma(s5_26, s5_26, fma(s5_25, s5_25, 1e-30)));
  // knuckle: ball, revolute, arm
  const Lanes v_knuckle_x = fma(zd_lower, s1_2, state.zd[Coordinate::pull]);
  // wheel: wheel, revolute, knuckle
  const Lanes v_wheel_x = fma(s1_4, w_knuckle_y, v_knuckle_x);
  const Lanes w_wheel_y = state.zd[Coordinate::wheel] + w_knuckle_y;
  const Lanes s5_28 = w_wheel_y*s5_18;

  // --- step 7: inertias of the bodies and forces on joints ---
  const Lanes s7_1 = w_knuckle_y*w_knuckle_y;

  // --- step 5: applied forces Q (48), continued ---
  // tyre
  const Lanes s5_29 = mbgen::abs(v_wheel_x);
  const Lanes s5_30 = v_wheel_x - s5_28;
  const Lanes s5_31 = 0.1*fma(0.5, s5_29 + mbgen::sqrt(fma(s5_30, s5_30, 1e-30)), 1.0);
  const Lanes s5_32 = 1.0 - s5_27/mbgen::min(0.5, s5_31);
  const Lanes s5_33 = mbgen::cosine(3.141592653589793*mbgen::min(1.0, 0.5*s5_29));
  const Lanes s5_34 = s5_25*(1.0/mbgen::max(0.6666666666666666*s5_27, s5_32));
  const Lanes s5_35 = fnma(s5_30, 0.06*fma(0.5, s5_33, 0.5)*mbgen::max(0.0, s5_32), s5_34);
  const Lanes s5_36 = 20.0*s5_20/mbgen::select(s5_22, mbgen::max(s5_22, s5_23), s5_24)*s5_35;
  const Lanes s5_37 = s5_21*mbgen::sine(1.6*mbgen::arc_tangent(s5_36));
  const Lanes fx_tyre = mbgen::max(0.0, load_tyre)/s5_20*s5_37;

  // --- step 7: inertias of the bodies and forces on joints, continued ---
  const Lanes s5_38 = mbgen::hyperbolic_tangent(0.5*s5_28);
  const Lanes zdd_lower = derivative.zdd[Coordinate::lower];
  const Lanes s7_2 = fnma(c_arm_x, R_arm_x_z, c_arm_z*R_arm_x_x);
  const Lanes s7_3 = fma(c_arm_x, R_arm_x_x, c_arm_z*R_arm_x_z);
  const Lanes s7_4 = zd_lower*zd_lower;
  const Lanes zdd_pull = derivative.zdd[Coordinate::pull];
  const Lanes s7_5 = m_arm*fnma(s7_4, s7_3, fma(zdd_lower, s7_2, zdd_pull));
  const Lanes s7_6 = fma(s5_1, s5_4*s5_14, fma(s5_2, s5_15, I_arm_yy*zdd_lower));
  // arm: lower, revolute, carriage
  const Lanes f_arm_x = s5_15 + s7_5;
  mbgen::read_back();
  // carriage: pull, prismatic, ground
  const Lanes f_carriage_x = fms(m_carriage, zdd_pull, s5_15);
  // arm: lower, revolute, carriage
  const Lanes s7_7 = m_arm*fnma(zdd_lower, s7_3, fnma(s7_4, s7_2, -g_z));
  const Lanes n_arm_y = fnma(s7_3, s7_7, fma(s7_2, s7_5, s7_6));
  // knuckle: ball, revolute, arm
  const Lanes a_knuckle_x = fnma(r_knuckle_x, s7_4, fma(zdd_lower, s1_2, zdd_pull));
  const Lanes a_knuckle_z = fnma(s1_2, s7_4, fnma(zdd_lower, r_knuckle_x, -g_z));
  const Lanes alpha_knuckle_y = zdd_lower + derivative.zdd[Coordinate::ball];
  // wheel: wheel, revolute, knuckle
  const Lanes a_wheel_x = fnma(s1_3, s7_1, fma(s1_4, alpha_knuckle_y, a_knuckle_x));
  const Lanes f_wheel_x = fms(m_wheel, a_wheel_x, fx_tyre);
  const Lanes a_wheel_z = fnma(s1_4, s7_1, fnma(s1_3, alpha_knuckle_y, a_knuckle_z));
  const Lanes f_wheel_z = fms(m_wheel, a_wheel_z, load_tyre);
  const Lanes alpha_wheel_y = derivative.zdd[Coordinate::wheel] + alpha_knuckle_y;
  const Lanes s7_8 = fma(s5_38, radius_tyre*(rolling_tyre*load_tyre), s5_18*fx_tyre);
  const Lanes n_wheel_y = alpha_wheel_y + s7_8;
  // knuckle: ball, revolute, arm
  const Lanes c_knuckle_z = parameters.derived[3];
  const Lanes s7_9 = R_knuckle_x_x*c_knuckle_z;
  const Lanes s7_10 = R_knuckle_x_z*c_knuckle_z;
  const Lanes m_knuckle_2 = parameters.derived[4];
  const Lanes f_knuckle_x = fnma(s7_1, s7_10, fma(alpha_knuckle_y, s7_9, a_knuckle_x))*m_knuckle_2;
  const Lanes f_knuckle_z = m_knuckle_2*fnma(alpha_knuckle_y, s7_10, fnma(s7_1, s7_9, a_knuckle_z));
  const Lanes I_knuckle_yy = parameters.derived[5];
  const Lanes s7_11 = f_wheel_x + f_knuckle_x;
  const Lanes s7_12 = fma(s7_9, f_knuckle_x, alpha_knuckle_y*I_knuckle_yy);
  const Lanes n_knuckle_y = fnma(s7_10, f_knuckle_z, s7_12);
  const Lanes s7_13 = n_knuckle_y + (n_wheel_y + fnma(s1_3, f_wheel_z, s1_4*f_wheel_x));
  const Lanes Q_ball = tau[Coordinate::ball] - s7_13;
  result.missing[1] = Q_ball;
  const Lanes s7_14 = fnma(s1_2, s7_11, tau[Coordinate::lower] - s7_13);
  // arm: lower, revolute, carriage
  result.missing[0] = fma(r_knuckle_x, f_wheel_z + f_knuckle_z, s7_14) - n_arm_y;
  // carriage: pull, prismatic, ground
  const Lanes Q_pull = tau[Coordinate::pull] - s7_11 - f_arm_x - f_carriage_x;

  // --- step 9: multipliers of the closures and driving forces, continued ---
  result.drive[0] = -Q_pull;
  const Lanes s9_1 = fma(p_upper_to_z, R_knuckle_x_z, p_upper_to_x*R_knuckle_x_x);
  const Lanes s9_2 = fnma(p_upper_to_x, R_knuckle_x_z, p_upper_to_z*R_knuckle_x_x);
  const Lanes s9_3 = s9_1*(s9_2 + (r_knuckle_z - p_upper_from_z));
  const Lanes s9_4 = fma(s9_2, p_upper_from_x - r_knuckle_x - s9_1, s9_3);
  result.pivot[0] = 12.094222040829795*mbgen::abs(s9_4);
  result.lambda[0] = -(l_upper*(Q_ball*(1.0/s9_4)));
  // operations of step 1: poses and axes b: 5 add, 6 multiply, 4 sin cos
  // operations of step 4: velocities: 5 add, 4 multiply
  // operations of step 5: applied forces Q (48): 28 add, 49 multiply, 5 divide, 3 sqrt, 3 sin cos,
  // 18 other
  // operations of step 7: inertias of the bodies and forces on joints: 45 add, 45 multiply
  // operations of step 9: multipliers of the closures and driving forces: 7 add, 9 multiply, 1
  // divide, 1 other
}

/// Multipliers of the closures and generalised driving forces, at given accelerations.
void compute_multipliers(const Tuned* parameters, const Inputs* /*inputs*/, const State* state,
    const JointForces* tau, const Derivative* derivative,
    ConstraintForces* __restrict result) noexcept {
  for (int g = 0; g < kGroups; ++g)
    compute_multipliers_1(parameters[g], state[g], tau[g].tau, derivative[g], result[g]);
}

/// Part 1 of compute_outputs: step 1: poses and axes b; step 5: applied forces Q (48); step 9:
/// outputs, energies, power; step 4: velocities; step 7: inertias of the bodies and forces on
/// joints.
[[gnu::noinline]] void compute_outputs_1(const Tuned& parameters, const State& state,
    const Lanes* tau, const Multipliers& multipliers, Outputs& __restrict result) noexcept {
  // Results that need no operation.
  result.wheel_speed = state.zd[Coordinate::wheel];

  // --- step 1: poses and axes b ---
  // arm: lower, revolute, carriage
  const Lanes z_lower = state.z[Coordinate::lower];
  Lanes R_arm_x_x, R_arm_x_z;
  mbgen::sincos(z_lower, R_arm_x_z, R_arm_x_x);

  // --- step 5: applied forces Q (48) ---
  // spring
  const Lanes s5_1 = fma(p_arm_seat_x, R_arm_x_x, p_arm_seat_z*R_arm_x_z);
  const Lanes s5_2 = fnma(p_arm_seat_x, R_arm_x_z, p_arm_seat_z*R_arm_x_x);
  const Lanes s5_3 = s5_1 - p_carriage_seat_x;
  const Lanes zd_lower = state.zd[Coordinate::lower];
  const Lanes s5_4 = 0.37 - s5_2;
  const Lanes s5_5 = mbgen::sqrt(fma(s5_4, s5_4, s5_3*s5_3));
  const Lanes s5_6 = 1.0/s5_5;
  const Lanes s5_7 = fma(zd_lower*s5_1, s5_4, s5_3*(zd_lower*s5_2))*s5_6;
  const Lanes s5_8 = 0.2 + s5_7;
  const Lanes s5_9 = fms(725.0, 1.0 + s5_7, 900.0);
  const Lanes s5_10 = mbgen::select(s5_8, fms(1600.0, s5_8, 320.0), s5_9);
  const Lanes s5_11 = s5_7 - 0.2;
  const Lanes s5_12 = mbgen::select(s5_7, 3200.0*s5_7, s5_10);
  const Lanes s5_13 = mbgen::select(s5_11, fma(1575.0, s5_11, 640.0), s5_12);
  const Lanes tension_spring = s5_13 + fma(s5_5 - l0_spring, parameters.k, f0_spring);
  result.spring_force = tension_spring;
  const Lanes s5_14 = s5_6*tension_spring;

  // --- step 9: outputs, energies, power ---
  const Lanes s1_1 = z_lower + state.z[Coordinate::ball];
  // knuckle: ball, revolute, arm
  Lanes R_knuckle_x_x, R_knuckle_x_z;
  mbgen::sincos(s1_1, R_knuckle_x_z, R_knuckle_x_x);
  const Lanes r_knuckle_x = fma(p_ball_x, R_arm_x_x, p_ball_z*R_arm_x_z);

  // --- step 4: velocities ---
  const Lanes s4_1 = zd_lower*r_knuckle_x;
  const Lanes s1_2 = fnma(p_ball_x, R_arm_x_z, p_ball_z*R_arm_x_x);
  // knuckle: ball, revolute, arm
  const Lanes zd_ball = state.zd[Coordinate::ball];
  const Lanes w_knuckle_y = zd_lower + zd_ball;
  const Lanes s4_2 = fma(p_wheel_z*R_knuckle_x_z, w_knuckle_y, s4_1);
  const Lanes r_knuckle_z = s1_2 + p_lower_z;
  const Lanes zd_pull = state.zd[Coordinate::pull];
  const Lanes v_knuckle_x = fma(zd_lower, s1_2, zd_pull);
  const Lanes s1_3 = p_wheel_z*R_knuckle_x_x;
  // wheel: wheel, revolute, knuckle
  const Lanes r_wheel_z = r_knuckle_z + s1_3;
  const Lanes v_wheel_x = fma(s1_3, w_knuckle_y, v_knuckle_x);
  const Lanes s5_15 = p_pull_z + r_wheel_z;
  result.hub_height = s5_15;
  const Lanes s5_16 = radius_tyre - s5_15;

  // --- step 5: applied forces Q (48), continued ---
  // tyre
  const Lanes s5_17 = mbgen::max(0.0, k_tyre*s5_16);
  const Lanes s5_18 = fnma(0.3333333333333333, mbgen::max(0.0, s5_16), radius_tyre);
  const Lanes load_tyre = mbgen::max(0.0, s5_17 + mbgen::min(s5_17, d_tyre*s4_2));
  result.load = load_tyre;
  const Lanes s5_19 = mbgen::max(0.004, load_tyre);
  const Lanes s5_20 = 1.1*s5_19;
  mbgen::read_back();
  const Lanes s5_21 = 1.6*s5_20;
  const Lanes s5_22 = 1e-09*s5_19;
  const Lanes s5_23 = mbgen::min(s5_21, -s5_22);
  const Lanes s5_24 = 3.3333333333333335*state.x[0];
  const Lanes s5_25 = 1.6666666666666667*state.x[1];
  const Lanes s5_26 = mbgen::sqrt(fma(s5_25, s5_25, fma(s5_24, s5_24, 1e-30)));
  // wheel: wheel, revolute, knuckle
  const Lanes zd_wheel = state.zd[Coordinate::wheel];
  const Lanes w_wheel_y = zd_wheel + w_knuckle_y;
  // tyre
  const Lanes s5_27 = w_wheel_y*s5_18;
  const Lanes s5_28 = v_wheel_x - s5_27;
  const Lanes s5_29 = mbgen::abs(v_wheel_x);
  const Lanes s5_30 = 0.1*fma(0.5, s5_29 + mbgen::sqrt(fma(s5_28, s5_28, 1e-30)), 1.0);
  const Lanes s5_31 = 1.0 - s5_26/mbgen::min(0.5, s5_30);
  const Lanes s5_32 = mbgen::cosine(3.141592653589793*mbgen::min(1.0, 0.5*s5_29));
  const Lanes s5_33 = s5_24*(1.0/mbgen::max(0.6666666666666666*s5_26, s5_31));
  const Lanes s5_34 = fnma(s5_28, 0.06*fma(0.5, s5_32, 0.5)*mbgen::max(0.0, s5_31), s5_33);
  const Lanes s5_35 = 20.0*s5_19/mbgen::select(s5_21, mbgen::max(s5_21, s5_22), s5_23)*s5_34;
  const Lanes s5_36 = s5_20*mbgen::sine(1.6*mbgen::arc_tangent(s5_35));
  const Lanes fx_tyre = mbgen::max(0.0, load_tyre)/s5_19*s5_36;
  const Lanes s5_37 = mbgen::hyperbolic_tangent(0.5*s5_27);
  const Lanes s9_1 = fma(zd_wheel, tau[Coordinate::wheel], zd_ball*tau[Coordinate::ball]);
  const Lanes s5_38 = fma(s5_37, radius_tyre*(rolling_tyre*load_tyre), s5_18*fx_tyre);
  const Lanes s9_2 = fma(v_wheel_x, fx_tyre, fnma(s4_2, load_tyre, s9_1));
  const Lanes s9_3 = tau[Coordinate::pull] + multipliers.drive[0];
  const Lanes s9_4 = fnma(s5_1, s5_4*s5_14, fnma(s5_2, s5_3*s5_14, tau[Coordinate::lower]));
  result.applied_power = fma(zd_lower, s9_4, fma(zd_pull, s9_3, fnma(w_wheel_y, s5_38, s9_2)));

  // --- step 7: inertias of the bodies and forces on joints ---
  mbgen::read_back();
  const Lanes s7_1 = fnma(c_arm_x, R_arm_x_z, c_arm_z*R_arm_x_x);
  const Lanes s9_5 = zd_lower*fma(c_arm_x, R_arm_x_x, c_arm_z*R_arm_x_z);
  const Lanes c_knuckle_z = parameters.derived[3];
  const Lanes s7_2 = R_knuckle_x_x*c_knuckle_z;
  const Lanes s9_6 = fma(w_knuckle_y, R_knuckle_x_z*c_knuckle_z, s4_1);
  const Lanes s9_7 = fma(w_knuckle_y, s7_2, v_knuckle_x);
  const Lanes m_knuckle_2 = parameters.derived[4];
  const Lanes s9_8 = fma(m_wheel, r_wheel_z, parameters.derived[6]);
  const Lanes I_knuckle_yy = parameters.derived[5];
  const Lanes s9_9 = fma(zd_lower, s7_1, zd_pull);
  const Lanes s9_10 = fma(m_arm, s7_1 + p_lower_z, fma(r_knuckle_z + s7_2, m_knuckle_2, s9_8));
  result.potential_energy = -g_z*s9_10;
  const Lanes s9_11 = fma(w_knuckle_y, w_knuckle_y*I_knuckle_yy, w_wheel_y*w_wheel_y);
  const Lanes s9_12 = fma(zd_lower, I_arm_yy*zd_lower, s9_11);
  const Lanes s9_13 = fma(m_wheel, fma(s4_2, s4_2, v_wheel_x*v_wheel_x), s9_12);
  const Lanes s9_14 = fma(m_knuckle_2, fma(s9_7, s9_7, s9_6*s9_6), s9_13);
  const Lanes s9_15 = fma(m_carriage, zd_pull*zd_pull, s9_14);
  result.kinetic_energy = 0.5*fma(m_arm, fma(s9_9, s9_9, s9_5*s9_5), s9_15);
  // operations of step 1: poses and axes b: 5 add, 6 multiply, 4 sin cos
  // operations of step 4: velocities: 5 add, 4 multiply
  // operations of step 5: applied forces Q (48): 29 add, 51 multiply, 5 divide, 3 sqrt, 3 sin cos,
  // 18 other
  // operations of step 7: inertias of the bodies and forces on joints: 2 add, 8 multiply
  // operations of step 9: outputs, energies, power: 26 add, 32 multiply
}

/// Outputs, energies and power, at given accelerations.
void compute_outputs(const Tuned* parameters, const Inputs* /*inputs*/, const State* state,
    const JointForces* tau, const Derivative* /*derivative*/, const Multipliers* multipliers,
    Outputs* __restrict result) noexcept {
  for (int g = 0; g < kGroups; ++g)
    compute_outputs_1(parameters[g], state[g], tau[g].tau, multipliers[g], result[g]);
}

}  // namespace lanes

/// Sizes, tables and programs of this model for the runtime's algorithms; see mbgen/batch.hpp.
struct System {
  using Lanes = batch::Lanes;
  using Row = batch::Row;
  using Mask = mbgen::MaskOf<Row>;
  using Parameters = lanes::Tuned;
  using Inputs = lanes::Inputs;
  using State = lanes::StateOf<Row>;
  using JointForces = lanes::JointForcesOf<Row>;
  using Derivative = lanes::DerivativeOf<Row>;
  using Multipliers = lanes::MultipliersOf<Row>;
  static constexpr int kLanes = batch::kLanes;
  static constexpr int kGroups = batch::kGroups;
  static constexpr int kCoordinates = 4;
  static constexpr int kAuxiliaryStates = 2;
  static constexpr int kBlocks = 1;
  static constexpr int kEquations = 1;
  static constexpr int kFreeDirections = 2;
  static constexpr bool kHasClosure = true;
  static constexpr int kDrives = 1;
  static constexpr double kClosureTolerance = 1e-12;
  static constexpr int kBlockCoordinates = 2;
  static constexpr unsigned char kDriven[] = {1, 0, 0, 0};
  static constexpr unsigned char kRedundant[] = {0};
  static constexpr mbgen::BlockLayout kBlockLayout[] = {{1, 2, 1, 1, 0, 0, 0, 0, 0.23}};
  static constexpr int kBlockCoordinate[] = {1, 2};
  using Accelerations = lanes::AccelerationsOf<Row>;
  static constexpr auto accelerations = &lanes::compute_accelerations;
  using Closure = lanes::ClosureOf<Row>;
  static constexpr auto closure = &lanes::compute_closure;
  using ConstraintForces = lanes::ConstraintForcesOf<Row>;
  static constexpr auto multipliers = &lanes::compute_multipliers;
  static Lanes argument_sum(const Parameters& parameters, const Inputs& /*inputs*/) noexcept {
    return parameters.k + parameters.ballast;
  }
  static const Inputs& inputs_at(const Inputs& inputs, const Lanes& /*dt*/) noexcept { return inputs; }
};

using Mask = System::Mask;
using mbgen::as_rows;
using mbgen::load_group;
using mbgen::load_row;
using mbgen::batch_detail::load_rows;
using mbgen::batch_detail::store_rows;

/// Made in place: clang copies structs of this size by memcpy.
mbgen::ParametersOf<System> in_lanes([[maybe_unused]] const Parameters& batch) noexcept {
  mbgen::ParametersOf<System> values;
  for ([[maybe_unused]] int g = 0; g < kGroups; ++g) {
    [[maybe_unused]] lanes::Tuned& group = values.group[g];
    group.k = load_group<Lanes>(batch.k, g);
    group.ballast = load_group<Lanes>(batch.ballast, g);
    lanes::compute_derived_constants(group, group);
  }
  return values;
}

mbgen::InputsOf<System> in_lanes([[maybe_unused]] const Inputs& batch) noexcept {
  mbgen::InputsOf<System> values;
  return values;
}

/// To the caller's place: g++ copies returned structs of this size.
void in_lanes(const State& batch, System::State& values) noexcept {
  load_rows(batch.z, values.z);
  load_rows(batch.zd, values.zd);
  load_rows(batch.x, values.x);
  values.t = load_row<Row>(batch.t);
}

/// The lanes of the mask.
void store_row(const Mask& mask, const Row& values, double (&row)[kLanes]) noexcept {
  mbgen::store_row(mbgen::choose(mask, values, load_row<Row>(row)), row);
}

void store_state(const Mask& mask, const System::State& values, State& batch) noexcept {
  store_rows(mask, values.z, batch.z);
  store_rows(mask, values.zd, batch.zd);
  store_rows(mask, values.x, batch.x);
  store_row(mask, values.t, batch.t);
}

/// One number of every row.
template <int N>
void copy_lane(const double (&rows)[N][kLanes], int lane, double (&one)[N]) noexcept {
  for (int i = 0; i < N; ++i) one[i] = rows[i][lane];
}
template <int N>
void copy_lane(const double (&one)[N], int lane, double (&rows)[N][kLanes]) noexcept {
  for (int i = 0; i < N; ++i) rows[i][lane] = one[i];
}

pulled_wheel::History lane_of(const History& batch, int lane) noexcept {
  pulled_wheel::History one;
  for (int k = 0; k < 4; ++k) {
    copy_lane(batch.zd[k], lane, one.rates[k].zd);
    copy_lane(batch.zdd[k], lane, one.rates[k].derivative.zdd);
    copy_lane(batch.xd[k], lane, one.rates[k].derivative.xd);
  }
  one.count = batch.count[lane];
  one.h = batch.h[lane];
  one.t = batch.t[lane];
  return one;
}

void set_lane(History& batch, int lane, const pulled_wheel::History& one) noexcept {
  for (int k = 0; k < 4; ++k) {
    copy_lane(mbgen::past_rates(one, k).zd, lane, batch.zd[k]);
    copy_lane(mbgen::past_rates(one, k).derivative.zdd, lane, batch.zdd[k]);
    copy_lane(mbgen::past_rates(one, k).derivative.xd, lane, batch.xd[k]);
  }
  batch.count[lane] = one.count;
  batch.h[lane] = one.h;
  batch.t[lane] = one.t;
}

/// Statuses of a step whose size is none.
Statuses invalid_step() noexcept {
  Statuses statuses{};
  for (mbgen::Status& status : statuses.lane) status = {mbgen::Code::step_invalid, -1};
  return statuses;
}

/// 1 for coordinates whose turn changes accelerations or closures, else 0.
constexpr double kTurning[] = {0.0, 1.0, 1.0, 0.0};

/// Looks at the ways of the loops in steps of h seconds that began at `state`.
struct Ways {
  const Parameters& parameters;
  const Inputs& inputs;
  const State& state;
  double h, most;

  Mask operator()(const Mask& good, const System::State& result) const noexcept {
    const mbgen::WayLimits limits = mbgen::integrator_detail::way_limits<double>(most, false);
    return mbgen::look_at_ways<System>(good, as_rows<System::State>(state), result, limits.least, [&](int lane) {
      const pulled_wheel::State from = lane_of(state, lane);
      pulled_wheel::State to = lane_of(state, lane);
      for (int i = 0; i < kCoordinates; ++i) to.z[i] = result.z[i][lane];
      for (int i = 0; i < kCoordinates; ++i) to.zd[i] = result.zd[i][lane];
      to.t = result.t[lane];
      const mbgen::Status way = pulled_wheel::Dynamics{lane_of(parameters, lane), lane_of(inputs, lane)}.watch_way(from, to, h, limits);
      return way.code == mbgen::Code::ok;
    });
  }
};

}  // namespace

pulled_wheel::Parameters lane_of([[maybe_unused]] const Parameters& batch, [[maybe_unused]] int lane) noexcept {
  pulled_wheel::Parameters one;
  one.k = batch.k[lane];
  one.ballast = batch.ballast[lane];
  return one;
}

pulled_wheel::Inputs lane_of([[maybe_unused]] const Inputs& batch, [[maybe_unused]] int lane) noexcept {
  pulled_wheel::Inputs one;
  return one;
}

pulled_wheel::State lane_of(const State& batch, int lane) noexcept {
  pulled_wheel::State one;
  copy_lane(batch.z, lane, one.z);
  copy_lane(batch.zd, lane, one.zd);
  copy_lane(batch.x, lane, one.x);
  one.t = batch.t[lane];
  return one;
}

pulled_wheel::Derivative lane_of(const Derivative& batch, int lane) noexcept {
  pulled_wheel::Derivative one;
  copy_lane(batch.zdd, lane, one.zdd);
  copy_lane(batch.xd, lane, one.xd);
  return one;
}

pulled_wheel::Outputs lane_of(const Outputs& batch, int lane) noexcept {
  pulled_wheel::Outputs one;
  one.load = batch.load[lane];
  one.wheel_speed = batch.wheel_speed[lane];
  one.hub_height = batch.hub_height[lane];
  one.spring_force = batch.spring_force[lane];
  one.kinetic_energy = batch.kinetic_energy[lane];
  one.potential_energy = batch.potential_energy[lane];
  one.applied_power = batch.applied_power[lane];
  return one;
}

pulled_wheel::Multipliers lane_of(const Multipliers& batch, int lane) noexcept {
  pulled_wheel::Multipliers one;
  copy_lane(batch.lambda, lane, one.lambda);
  copy_lane(batch.drive, lane, one.drive);
  return one;
}

void set_lane([[maybe_unused]] Parameters& batch, [[maybe_unused]] int lane,
              [[maybe_unused]] const pulled_wheel::Parameters& one) noexcept {
  batch.k[lane] = one.k;
  batch.ballast[lane] = one.ballast;
}

void set_lane([[maybe_unused]] Inputs& batch, [[maybe_unused]] int lane,
              [[maybe_unused]] const pulled_wheel::Inputs& one) noexcept {
}

void set_lane(State& batch, int lane, const pulled_wheel::State& one) noexcept {
  copy_lane(one.z, lane, batch.z);
  copy_lane(one.zd, lane, batch.zd);
  copy_lane(one.x, lane, batch.x);
  batch.t[lane] = one.t;
}

void set_lane(Derivative& batch, int lane, const pulled_wheel::Derivative& one) noexcept {
  copy_lane(one.zdd, lane, batch.zdd);
  copy_lane(one.xd, lane, batch.xd);
}

void set_lane(Outputs& batch, int lane, const pulled_wheel::Outputs& one) noexcept {
  batch.load[lane] = one.load;
  batch.wheel_speed[lane] = one.wheel_speed;
  batch.hub_height[lane] = one.hub_height;
  batch.spring_force[lane] = one.spring_force;
  batch.kinetic_energy[lane] = one.kinetic_energy;
  batch.potential_energy[lane] = one.potential_energy;
  batch.applied_power[lane] = one.applied_power;
}

void set_lane(Multipliers& batch, int lane, const pulled_wheel::Multipliers& one) noexcept {
  copy_lane(one.lambda, lane, batch.lambda);
  copy_lane(one.drive, lane, batch.drive);
}

State initial_state() noexcept {
  State state;
  for (int lane = 0; lane < kLanes; ++lane) set_lane(state, lane, pulled_wheel::initial_state());
  return state;
}

Statuses assemble(const Parameters& parameters, const Inputs& inputs, State& state) noexcept {
  System::State values;
  in_lanes(state, values);
  const Mask good = mbgen::project_lanes<System>(in_lanes(parameters), in_lanes(inputs), values);
  store_state(good, values, state);
  return mbgen::with_the_others_alone<kLanes>(good, [&](int lane) {
    pulled_wheel::State one = lane_of(state, lane);
    const mbgen::Status status = pulled_wheel::assemble(lane_of(parameters, lane), lane_of(inputs, lane), one);
    if (status.ok()) set_lane(state, lane, one);
    return status;
  });
}

Statuses accelerations(const Parameters& parameters, const Inputs& inputs, const State& state,
                       const JointForces& forces, Derivative& derivative) noexcept {
  System::Accelerations values;
  const Mask good = mbgen::evaluate_lanes<System>(in_lanes(parameters), in_lanes(inputs), as_rows<System::State>(state),
                                                  &as_rows<System::JointForces>(forces), mbgen::kPivotThreshold<double>,
                                                  values);
  store_rows(good, values.zdd, derivative.zdd);
  store_rows(good, values.xd, derivative.xd);
  return mbgen::with_the_others_alone<kLanes>(good, [&](int lane) {
    double tau_of_lane[kCoordinates];
    copy_lane(forces.tau, lane, tau_of_lane);
    pulled_wheel::Derivative one = lane_of(derivative, lane);
    const mbgen::Status status = pulled_wheel::accelerations(lane_of(parameters, lane), lane_of(inputs, lane),
                                                           lane_of(state, lane), tau_of_lane, one);
    if (status.ok()) set_lane(derivative, lane, one);
    return status;
  });
}

Statuses step_rk4(const Parameters& parameters, const Inputs& inputs, State& state, double h) noexcept {
  if (!mbgen::is_step(h)) return invalid_step();
  System::State result;
  in_lanes(state, result);
  const Mask good = mbgen::step_lanes_rk4<System>(in_lanes(parameters), in_lanes(inputs),
                                                   as_rows<System::State>(state), h, result,
                                                   Ways{parameters, inputs, state, h, mbgen::kRk4Turn});
  store_state(good, result, state);
  const Statuses statuses = mbgen::with_the_others_alone<kLanes>(good, [&](int lane) {
    pulled_wheel::State one = lane_of(state, lane);
    const mbgen::Status status = pulled_wheel::step_rk4(lane_of(parameters, lane), lane_of(inputs, lane), one, h);
    if (status.ok()) set_lane(state, lane, one);
    return status;
  });
  return mbgen::with_turns_of_lanes<System>(statuses, good, result, kTurning, h, mbgen::kRk4Turn);
}

Statuses step_abm4(const Parameters& parameters, const Inputs& inputs, State& state, History& history,
                   double h) noexcept {
  if (!mbgen::is_step(h)) return invalid_step();
  System::State result;
  in_lanes(state, result);
  const Mask good = mbgen::step_rows_abm4<System>(in_lanes(parameters), in_lanes(inputs),
                                                  as_rows<System::State>(state), history, h, result,
                                                  Ways{parameters, inputs, state, h, mbgen::kAbm4Turn});
  store_state(good, result, state);
  const Statuses statuses = mbgen::with_the_others_alone<kLanes>(good, [&](int lane) {
    pulled_wheel::State one = lane_of(state, lane);
    pulled_wheel::History past = lane_of(history, lane);
    const mbgen::Status status =
        pulled_wheel::step_abm4(lane_of(parameters, lane), lane_of(inputs, lane), one, past, h);
    if (status.ok()) {
      set_lane(state, lane, one);
      set_lane(history, lane, past);
    }
    return status;
  });
  return mbgen::with_turns_of_lanes<System>(statuses, good, result, kTurning, h, mbgen::kAbm4Turn);
}

Statuses outputs(const Parameters& parameters, const Inputs& inputs, const State& state, const JointForces& forces,
                 const Derivative& derivative, Outputs& values) noexcept {
  const mbgen::ParametersOf<System> p = in_lanes(parameters);
  const mbgen::InputsOf<System> in = in_lanes(inputs);
  const auto& at = as_rows<System::State>(state);
  const auto& tau = as_rows<System::JointForces>(forces);
  const auto& rates = as_rows<System::Derivative>(derivative);
  lanes::OutputsOf<Row> result;
  System::Multipliers constraint;
  const Mask good = mbgen::constrain_lanes<System>(p, in, at, &tau, rates, constraint);
  mbgen::run_groups(&lanes::compute_outputs, result, p, in, at, tau, rates, constraint);
  store_row(good, result.load, values.load);
  store_row(good, result.wheel_speed, values.wheel_speed);
  store_row(good, result.hub_height, values.hub_height);
  store_row(good, result.spring_force, values.spring_force);
  store_row(good, result.kinetic_energy, values.kinetic_energy);
  store_row(good, result.potential_energy, values.potential_energy);
  store_row(good, result.applied_power, values.applied_power);
  return mbgen::with_the_others_alone<kLanes>(good, [&](int lane) {
    double tau_of_lane[kCoordinates];
    copy_lane(forces.tau, lane, tau_of_lane);
    pulled_wheel::Outputs one = lane_of(values, lane);
    const mbgen::Status status =
        pulled_wheel::outputs(lane_of(parameters, lane), lane_of(inputs, lane), lane_of(state, lane), tau_of_lane,
                            lane_of(derivative, lane), one);
    if (status.ok()) set_lane(values, lane, one);
    return status;
  });
}

Statuses multipliers(const Parameters& parameters, const Inputs& inputs, const State& state,
                     const JointForces& forces, const Derivative& derivative, Multipliers& values) noexcept {
  const auto& at = as_rows<System::State>(state);
  const auto& tau = as_rows<System::JointForces>(forces);
  const auto& rates = as_rows<System::Derivative>(derivative);
  System::Multipliers result;
  const Mask good =
      mbgen::constrain_lanes<System>(in_lanes(parameters), in_lanes(inputs), at, &tau, rates, result);
  for (int e = 0; e < kClosureEquations; ++e) store_row(good, result.lambda[e], values.lambda[e]);
  for (int g = 0; g < kMotions; ++g) store_row(good, result.drive[g], values.drive[g]);
  return mbgen::with_the_others_alone<kLanes>(good, [&](int lane) {
    double tau_of_lane[kCoordinates];
    copy_lane(forces.tau, lane, tau_of_lane);
    pulled_wheel::Multipliers one = lane_of(values, lane);
    const mbgen::Status status =
        pulled_wheel::multipliers(lane_of(parameters, lane), lane_of(inputs, lane), lane_of(state, lane), tau_of_lane,
                                lane_of(derivative, lane), one);
    if (status.ok()) set_lane(values, lane, one);
    return status;
  });
}

}  // namespace pulled_wheel::batch
