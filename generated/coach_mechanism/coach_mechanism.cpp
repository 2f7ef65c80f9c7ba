// coach_mechanism, content hash f103c08ed05488f2
// Made by `mbgen generate coach_mechanism.json`, mbgen 0.1.0. Change the model, not this file.
//
// Tree, each body with its coordinate, on the body before it:
//   chassis_aux1: chassis_tx, prismatic, on ground
//   chassis_aux2: chassis_ty, prismatic, on chassis_aux1
//   chassis_aux3: chassis_tz, prismatic, on chassis_aux2
//   chassis_aux4: chassis_rz, revolute, on chassis_aux3
//   chassis_aux5: chassis_ry, revolute, on chassis_aux4
//   chassis: chassis_rx, revolute, on chassis_aux5
//   lower_arm_left: lower_arm_left, revolute, on chassis
//   carrier_left_aux1: carrier_left_rz, revolute, on lower_arm_left
//   carrier_left_aux2: carrier_left_rx, revolute, on carrier_left_aux1
//   carrier_left: carrier_left_ry, revolute, on carrier_left_aux2
//   wheel_front_left: wheel_front_left, revolute, on carrier_left
//   upper_arm_left: upper_arm_left, revolute, on chassis
//   arb_front_left: arb_front_left, revolute, on chassis
//   lower_arm_right: lower_arm_right, revolute, on chassis
//   carrier_right_aux1: carrier_right_rz, revolute, on lower_arm_right
//   carrier_right_aux2: carrier_right_rx, revolute, on carrier_right_aux1
//   carrier_right: carrier_right_ry, revolute, on carrier_right_aux2
//   wheel_front_right: wheel_front_right, revolute, on carrier_right
//   upper_arm_right: upper_arm_right, revolute, on chassis
//   arb_front_right: arb_front_right, revolute, on chassis
//   pitman_arm: pitman_arm, revolute, on chassis
//   bell_crank: bell_crank, revolute, on chassis
//   rear_axle_aux1: rear_axle_tx, prismatic, on chassis
//   rear_axle_aux2: rear_axle_ty, prismatic, on rear_axle_aux1
//   rear_axle_aux3: rear_axle_tz, prismatic, on rear_axle_aux2
//   rear_axle_aux4: rear_axle_rz, revolute, on rear_axle_aux3
//   rear_axle_aux5: rear_axle_ry, revolute, on rear_axle_aux4
//   rear_axle: rear_axle_rx, revolute, on rear_axle_aux5
//   wheel_rear_left: wheel_rear_left, revolute, on rear_axle
//   arb_rear_left: arb_rear_left, revolute, on chassis
//   wheel_rear_right: wheel_rear_right, revolute, on rear_axle
//   arb_rear_right: arb_rear_right, revolute, on chassis
// Loop block 0, on chassis:
//   upper_ball_left: spherical between carrier_left and upper_arm_left
//   upper_ball_right: spherical between carrier_right and upper_arm_right
//   arb_link_front_left: rod between arb_front_left and carrier_left
//   arb_link_front_right: rod between arb_front_right and carrier_right
//   drag_link: rod between pitman_arm and bell_crank
//   tie_rod_left: rod between bell_crank and carrier_left
//   tie_rod_right: rod between bell_crank and carrier_right
//   independent: lower_arm_left, lower_arm_right, bell_crank
// Loop block 1, on chassis:
//   long_rod_left: rod between chassis and rear_axle
//   diag_rod_left: rod between chassis and rear_axle
//   arb_link_rear_left: rod between arb_rear_left and rear_axle
//   long_rod_right: rod between chassis and rear_axle
//   diag_rod_right: rod between chassis and rear_axle
//   arb_link_rear_right: rod between arb_rear_right and rear_axle
//   independent: rear_axle_tz, rear_axle_rx
//   in the accelerations: arb_rear_left, arb_rear_right
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
//
// Pairs: values of a left and a right side, or of two equal parts, that do the same operations, one in each lane. The
// second lane holds the mirror image of its side's value, or that of the other part: of (a)_and_(b) the first lane is
// a, the second one b or, where a sign differs, -b. T[0] + T[1] sums both.

#include "coach_mechanism.hpp"

#include "mbgen/elementary.hpp"
#include "mbgen/fma.hpp"
#include "mbgen/solver/passing.hpp"
#include "mbgen/pair.hpp"
#include "mbgen/scalar.hpp"
#include "mbgen/turns.hpp"
#include "mbgen/solver.hpp"

#include <cmath>

// Compiled with -DMBGEN_PART=0 this file is what runs at every step, with -DMBGEN_PART=1 programs that run
// rarely; the 2 objects together are the solver. Compiled without MBGEN_PART it is the whole solver.
#ifdef MBGEN_PART
#define MBGEN_IS_PART(part) (MBGEN_PART == part)
#define MBGEN_BETWEEN_PARTS inline namespace between_parts
#else
#define MBGEN_IS_PART(part) 1
#define MBGEN_BETWEEN_PARTS namespace
#endif

namespace coach_mechanism {

using mbgen::fma;   // a b + c, rounded once
using mbgen::fms;   // a b - c
using mbgen::fnma;  // c - a b, of fnma(a, b, c)
using mbgen::Pair;  // left, and right as its mirror image; or a part and its twin

namespace {

// Numbers of the model.
constexpr double p_carrier_left_rz_z = -0.05;
constexpr double p_carrier_left_rz_y = 0.45;
constexpr double p_lower_arm_left_y = 0.4;
constexpr double p_lower_arm_left_z = -0.62;
constexpr double p_lower_arm_left_x = 3.6;
constexpr double p_wheel_front_left_z = 0.17;
constexpr double p_wheel_front_left_y = 0.175;
constexpr double p_carrier_right_rz_z = -0.05;
constexpr double p_carrier_right_rz_y = -0.45;
constexpr double p_lower_arm_right_y = -0.4;
constexpr double p_lower_arm_right_z = -0.62;
constexpr double p_lower_arm_right_x = 3.6;
constexpr double p_wheel_front_right_y = -0.175;
constexpr double p_wheel_front_right_z = 0.17;
constexpr double p_rear_axle_tx_x = -2.5;
constexpr double p_rear_axle_tx_z = -0.5;
constexpr double p_wheel_rear_left_y = 0.93;
constexpr double p_upper_arm_left_z = -0.28;
constexpr double p_upper_arm_left_y = 0.5;
constexpr double p_arb_front_left_z = -0.5;
constexpr double p_arb_front_left_y = 0.5244444444444444;
constexpr double p_arb_front_left_x = 3.95;
constexpr double p_pitman_arm_z = -0.4;
constexpr double p_pitman_arm_x = 4.4;
constexpr double p_bell_crank_z = -0.6;
constexpr double p_bell_crank_x = 3.25;
constexpr double p_arb_rear_left_z = -0.45;
constexpr double p_arb_rear_left_y = 0.5111111111111111;
constexpr double p_arb_rear_left_x = -3.3;
constexpr double I_wheel_rear_right_polar = 22.0;
constexpr double I_wheel_rear_left_polar = 22.0;
constexpr double p_long_rod_left_to_x = 0.05;
constexpr double p_long_rod_left_to_z = -0.08;
constexpr double p_long_rod_left_to_y = 0.55;
constexpr double p_long_rod_left_from_z = -0.55;
constexpr double p_long_rod_left_from_x = -1.6;
constexpr double p_long_rod_left_from_y = 0.55;
constexpr double l_long_rod_left = 0.8505292469985968;
constexpr double p_diag_rod_left_to_y = 0.1;
constexpr double p_diag_rod_left_to_z = 0.25;
constexpr double p_diag_rod_left_from_z = -0.15;
constexpr double p_diag_rod_left_from_x = -1.7;
constexpr double p_diag_rod_left_from_y = 0.4;
constexpr double l_diag_rod_left = 0.8602325267042626;
constexpr double p_arb_link_rear_left_to_x = -0.35;
constexpr double p_arb_link_rear_left_to_z = -0.15;
constexpr double p_arb_link_rear_left_from_x = 0.35;
constexpr double p_arb_link_rear_left_to_y = 0.6;
constexpr double p_arb_link_rear_left_from_y = 0.0888888888888889;
constexpr double l_arb_link_rear_left = 0.22360679774997896;
constexpr double p_long_rod_right_from_y = -0.55;
constexpr double l_long_rod_right = 0.8505292469985968;
constexpr double p_diag_rod_right_from_y = -0.4;
constexpr double l_diag_rod_right = 0.8602325267042626;
constexpr double p_arb_link_rear_right_from_x = 0.35;
constexpr double p_arb_rear_right_z = -0.45;
constexpr double p_arb_rear_right_x = -3.3;
constexpr double p_arb_rear_right_y = -0.5111111111111111;
constexpr double l_arb_link_rear_right = 0.22360679774997896;
constexpr double h_rear_axle_x = 0.2;
constexpr double h_rear_axle_z = 2.26;
constexpr double K_rear_axle_xx = 22.79;
constexpr double K_rear_axle_xz = 0.033;
constexpr double K_rear_axle_yy = 617.785;
constexpr double K_rear_axle_zz = 23.6602;
constexpr double K_rear_axle_trace = 664.2352;
constexpr double K_arb_rear_left_xy = 0.017777777777777837;
constexpr double h_arb_rear_left_x = 1.55;
constexpr double K_arb_rear_left_zz = 0.035;
constexpr double K_arb_rear_left_xx = 0.3875;
constexpr double K_arb_rear_right_xy = -0.017777777777777837;
constexpr double h_arb_rear_right_x = 1.55;
constexpr double K_arb_rear_right_zz = 0.035;
constexpr double K_arb_rear_right_xx = 0.3875;
constexpr double m_rear_axle = 1186.0;
constexpr double I_wheel_front_right_polar = 11.0;
constexpr double I_wheel_front_left_polar = 11.0;
constexpr double p_carrier_left_upper_ball_z = 0.37;
constexpr double p_carrier_left_upper_ball_y = -0.05;
constexpr double p_upper_arm_left_ball_z = -0.02;
constexpr double p_upper_arm_left_ball_y = 0.3;
constexpr double p_carrier_right_upper_ball_y = 0.05;
constexpr double p_carrier_right_upper_ball_z = 0.37;
constexpr double p_upper_arm_right_ball_y = -0.3;
constexpr double p_upper_arm_right_ball_z = -0.02;
constexpr double p_upper_arm_right_y = -0.5;
constexpr double p_upper_arm_right_z = -0.28;
constexpr double p_upper_arm_right_x = 3.6;
constexpr double p_arb_link_front_left_from_x = -0.25;
constexpr double p_arb_link_front_left_from_z = 0.1;
constexpr double p_arb_link_front_left_to_y = -0.03;
constexpr double p_arb_link_front_left_to_x = 0.1;
constexpr double p_arb_link_front_left_from_y = 0.1955555555555556;
constexpr double l_arb_link_front_left = 0.26;
constexpr double p_arb_link_front_right_from_x = -0.25;
constexpr double p_arb_link_front_right_from_z = 0.1;
constexpr double p_arb_front_right_x = 3.95;
constexpr double p_arb_link_front_right_to_x = 0.1;
constexpr double p_arb_front_right_z = -0.5;
constexpr double p_arb_front_right_y = -0.5244444444444444;
constexpr double l_arb_link_front_right = 0.26;
constexpr double p_drag_link_from_z = -0.22;
constexpr double p_drag_link_to_y = 0.3;
constexpr double p_pitman_arm_y = 0.5;
constexpr double l_drag_link = 1.167433081593973;
constexpr double p_tie_rod_left_to_x = -0.22;
constexpr double p_tie_rod_left_from_y = 0.08;
constexpr double p_tie_rod_left_from_x = -0.2;
constexpr double p_tie_rod_left_to_z = 0.07;
constexpr double l_tie_rod_left = 0.7920227269466451;
constexpr double p_tie_rod_right_to_x = -0.22;
constexpr double p_tie_rod_right_to_z = 0.07;
constexpr double l_tie_rod_right = 0.7920227269466451;
constexpr double h_lower_arm_left_z = -0.625;
constexpr double h_lower_arm_left_y = 5.5;
constexpr double K_lower_arm_left_zz = 0.040625;
constexpr double K_lower_arm_left_yz = -0.1375;
constexpr double K_lower_arm_left_yy = 1.785;
constexpr double K_carrier_left_xy = 0.0355;
constexpr double K_carrier_left_yz = 4.6066;
constexpr double K_carrier_left_yy = 11.679275;
constexpr double h_carrier_left_y = 26.97;
constexpr double K_carrier_left_xz = -0.0509;
constexpr double h_carrier_left_x = -0.67;
constexpr double h_carrier_left_z = 36.825;
constexpr double K_carrier_left_zz = 7.48155;
constexpr double K_carrier_left_xx = 1.4294;
constexpr double K_carrier_left_trace = 20.590225;
constexpr double h_upper_arm_left_z = -0.15;
constexpr double h_upper_arm_left_y = 2.25;
constexpr double K_upper_arm_left_zz = 0.0265;
constexpr double K_upper_arm_left_yz = -0.0225;
constexpr double K_upper_arm_left_yy = 0.5125;
constexpr double K_arb_front_left_xy = -0.023466666666666747;
constexpr double K_arb_front_left_yz = 0.00977777777777781;
constexpr double h_arb_front_left_x = -1.29;
constexpr double h_arb_front_left_z = 0.5;
constexpr double K_arb_front_left_xz = -0.077;
constexpr double K_arb_front_left_zz = 0.065;
constexpr double K_arb_front_left_xx = 0.2827;
constexpr double h_lower_arm_right_z = -0.625;
constexpr double h_lower_arm_right_y = -5.5;
constexpr double K_lower_arm_right_zz = 0.040625;
constexpr double K_lower_arm_right_yz = 0.1375;
constexpr double K_lower_arm_right_yy = 1.785;
constexpr double K_carrier_right_yy = 11.679275;
constexpr double h_carrier_right_y = -26.97;
constexpr double K_carrier_right_xy = -0.0355;
constexpr double K_carrier_right_yz = -4.6066;
constexpr double K_carrier_right_xz = -0.0509;
constexpr double h_carrier_right_x = -0.67;
constexpr double h_carrier_right_z = 36.825;
constexpr double K_carrier_right_zz = 7.48155;
constexpr double K_carrier_right_xx = 1.4294;
constexpr double K_carrier_right_trace = 20.590225;
constexpr double h_upper_arm_right_z = -0.15;
constexpr double h_upper_arm_right_y = -2.25;
constexpr double K_upper_arm_right_yz = 0.0225;
constexpr double K_upper_arm_right_zz = 0.0265;
constexpr double K_upper_arm_right_yy = 0.5125;
constexpr double h_arb_front_right_x = -1.29;
constexpr double h_arb_front_right_z = 0.5;
constexpr double K_arb_front_right_xy = 0.023466666666666747;
constexpr double K_arb_front_right_yz = -0.00977777777777781;
constexpr double K_arb_front_right_xz = -0.077;
constexpr double K_arb_front_right_zz = 0.065;
constexpr double K_arb_front_right_xx = 0.2827;
constexpr double h_pitman_arm_z = -1.65;
constexpr double K_pitman_arm_zz = 0.3304;
constexpr double K_pitman_arm_xx = 0.02;
constexpr double K_bell_crank_xx = 0.3741;
constexpr double K_bell_crank_xy = -0.0504;
constexpr double K_bell_crank_yy = 0.5774;
constexpr double h_bell_crank_y = 2.07;
constexpr double h_bell_crank_x = -2.03;
constexpr double m_upper_arm_right = 15.0;
constexpr double m_carrier_right = 219.5;
constexpr double m_lower_arm_right = 25.0;
constexpr double m_upper_arm_left = 15.0;
constexpr double m_carrier_left = 219.5;
constexpr double m_lower_arm_left = 25.0;
constexpr double K_chassis_xz = 19.92;
constexpr double g_z = -9.81;
constexpr double p_tie_rod_left_to_y = -0.05;
constexpr double p_tie_rod_right_to_y = 0.05;
constexpr double c_arb_rear_right_y = 0.003418803418803379;
constexpr double c_arb_rear_right_x = 0.16538461538461538;
constexpr double m_arb_rear_right_2 = 8.666666666666666;
constexpr double I_arb_rear_right_zz = 0.23076923076923078;
constexpr double I_arb_rear_right_yy = 0.14461538461538462;
constexpr double I_arb_rear_right_xy = 0.01230769230769231;
constexpr double I_arb_rear_right_xx = 0.15615384615384614;
constexpr double m_wheel_rear_right = 200.0;
constexpr double I_wheel_rear_right_yy = 22.0;
constexpr double I_wheel_rear_right_xx = 14.0;
constexpr double I_wheel_rear_right_zz = 14.0;
constexpr double c_arb_rear_left_y = -0.003418803418803379;
constexpr double c_arb_rear_left_x = 0.16538461538461538;
constexpr double m_arb_rear_left_2 = 8.666666666666666;
constexpr double I_arb_rear_left_zz = 0.23076923076923078;
constexpr double I_arb_rear_left_yy = 0.14461538461538462;
constexpr double I_arb_rear_left_xy = -0.01230769230769231;
constexpr double I_arb_rear_left_xx = 0.15615384615384614;
constexpr double m_wheel_rear_left = 200.0;
constexpr double I_wheel_rear_left_yy = 22.0;
constexpr double I_wheel_rear_left_xx = 14.0;
constexpr double I_wheel_rear_left_zz = 14.0;
constexpr double c_rear_axle_x = 0.0001722652885443584;
constexpr double c_rear_axle_z = 0.0019465977605512485;
constexpr double m_rear_axle_2 = 774.0;
constexpr double I_rear_axle_yy = 45.96384415733562;
constexpr double I_rear_axle_xx = 264.98720045937415;
constexpr double I_rear_axle_xz = -0.021740453631926497;
constexpr double I_rear_axle_zz = 264.4099770312949;
constexpr double c_bell_crank_y = 0.0972;
constexpr double c_bell_crank_x = -0.0938;
constexpr double m_bell_crank_2 = 16.666666666666668;
constexpr double I_bell_crank_xx = 0.28000266666666673;
constexpr double I_bell_crank_xy = -0.101556;
constexpr double I_bell_crank_zz = 0.4041286666666667;
constexpr double I_bell_crank_yy = 0.144126;
constexpr double c_pitman_arm_z = -0.14666666666666667;
constexpr double m_pitman_arm_2 = 9.0;
constexpr double I_pitman_arm_zz = 0.03;
constexpr double I_pitman_arm_yy = 0.0842;
constexpr double I_pitman_arm_xx = 0.0742;
constexpr double c_arb_front_right_y = 0.007521367521367457;
constexpr double c_arb_front_right_x = -0.13923076923076924;
constexpr double c_arb_front_right_z = 0.05384615384615385;
constexpr double m_arb_front_right_2 = 8.666666666666666;
constexpr double I_arb_front_right_yz = 0.00676923076923077;
constexpr double I_arb_front_right_xz = 0.0036923076923076927;
constexpr double I_arb_front_right_zz = 0.23864615384615384;
constexpr double I_arb_front_right_yy = 0.1304;
constexpr double I_arb_front_right_xy = -0.016246153846153848;
constexpr double I_arb_front_right_xx = 0.18132307692307692;
constexpr double c_upper_arm_right_z = -0.01;
constexpr double c_upper_arm_right_y = -0.15;
constexpr double I_upper_arm_right_xx = 0.2;
constexpr double I_upper_arm_right_zz = 0.25;
constexpr double I_upper_arm_right_yy = 0.1;
constexpr double m_wheel_front_right = 105.0;
constexpr double I_wheel_front_right_zz = 6.0;
constexpr double I_wheel_front_right_yy = 11.0;
constexpr double I_wheel_front_right_xx = 6.0;
constexpr double c_carrier_right_z = 0.16710914454277287;
constexpr double c_carrier_right_x = -0.003952802359882006;
constexpr double c_carrier_right_y = -0.07666666666666667;
constexpr double m_carrier_right_2 = 113.0;
constexpr double I_carrier_right_yz = 0.039511111111111115;
constexpr double I_carrier_right_zz = 3.1640788593903637;
constexpr double I_carrier_right_xz = -0.04070875122910522;
constexpr double I_carrier_right_yy = 2.6532900688298917;
constexpr double I_carrier_right_xy = 0.057911111111111115;
constexpr double I_carrier_right_xx = 3.081700098328417;
constexpr double c_lower_arm_right_z = -0.025;
constexpr double c_lower_arm_right_y = -0.22;
constexpr double I_lower_arm_right_xx = 0.6;
constexpr double I_lower_arm_right_zz = 0.8;
constexpr double I_lower_arm_right_yy = 0.25;
constexpr double c_arb_front_left_x = -0.13923076923076924;
constexpr double c_arb_front_left_z = 0.05384615384615385;
constexpr double c_arb_front_left_y = -0.007521367521367457;
constexpr double m_arb_front_left_2 = 8.666666666666666;
constexpr double I_arb_front_left_xz = 0.0036923076923076927;
constexpr double I_arb_front_left_zz = 0.23864615384615384;
constexpr double I_arb_front_left_yz = -0.00676923076923077;
constexpr double I_arb_front_left_yy = 0.1304;
constexpr double I_arb_front_left_xy = 0.016246153846153848;
constexpr double I_arb_front_left_xx = 0.18132307692307692;
constexpr double c_upper_arm_left_y = 0.15;
constexpr double c_upper_arm_left_z = -0.01;
constexpr double I_upper_arm_left_xx = 0.2;
constexpr double I_upper_arm_left_zz = 0.25;
constexpr double I_upper_arm_left_yy = 0.1;
constexpr double m_wheel_front_left = 105.0;
constexpr double I_wheel_front_left_zz = 6.0;
constexpr double I_wheel_front_left_yy = 11.0;
constexpr double I_wheel_front_left_xx = 6.0;
constexpr double c_carrier_left_y = 0.07666666666666667;
constexpr double c_carrier_left_z = 0.16710914454277287;
constexpr double c_carrier_left_x = -0.003952802359882006;
constexpr double m_carrier_left_2 = 113.0;
constexpr double I_carrier_left_zz = 3.1640788593903637;
constexpr double I_carrier_left_xz = -0.04070875122910522;
constexpr double I_carrier_left_yz = -0.039511111111111115;
constexpr double I_carrier_left_yy = 2.6532900688298917;
constexpr double I_carrier_left_xy = -0.057911111111111115;
constexpr double I_carrier_left_xx = 3.081700098328417;
constexpr double c_lower_arm_left_y = 0.22;
constexpr double c_lower_arm_left_z = -0.025;
constexpr double I_lower_arm_left_xx = 0.6;
constexpr double I_lower_arm_left_zz = 0.8;
constexpr double I_lower_arm_left_yy = 0.25;
constexpr double c_chassis_x = -0.0027607966870439754;
constexpr double c_chassis_z = 0.24897456123052653;
constexpr double m_chassis = 13522.666666666668;
constexpr double I_chassis_xx = 15014.70911391573;
constexpr double I_chassis_xz = -22.575050285939653;
constexpr double I_chassis_zz = 145066.78026359034;
constexpr double I_chassis_yy = 150070.8160441727;

#if MBGEN_IS_PART(0)

/// Result of compute_accelerations.
struct Accelerations {
  double zdd[32];  ///< accelerations
  double xd[1];  ///< rates of the auxiliary states
  double pivot[2];  ///< smallest pivot of each block over its reference
  double inertia[15];  ///< pivots of the final equations
};

/// Values of compute_accelerations that cross its parts.
struct AccelerationsWork1 {
  Pair
      s2_13, s2_40, r_carrier_left_aux1_z, R_carrier_left_and_right_aux2_y_y, s4_21, s4_29, s4_31,
      s2_76, s2_88, s1_19, s1_28, s1_30, s2_7, s2_27, s2_44, s2_78, s2_140, s2_26, s4_3, s4_7,
      s4_11, R_carrier_left_and_right_aux2_z_y, s0_14, s2_3, s2_6, s2_19, s2_23, s2_35, s2_39,
      s2_71, s2_75, s2_86, s2_131, s2_135, s2_139, s6_52, s0_12, s6_57, s7_42, s7_55, s7_59, s2_24,
      s2_56, pivot_carrier_left_and_right_rx, s2_28, s2_41, s2_46, s2_50, s6_12, s2_61, s1_11,
      R_carrier_left_and_right_aux1_y_x, R_carrier_left_and_right_aux1_z_x,
      R_carrier_left_and_right_z_z, s1_4, s2_8, s0_8, s1_5, s2_43, s2_48, s6_26, s2_62,
      R_carrier_left_and_right_z_x, s7_40, s2_25, s6_5, s6_7, s6_9, s6_13, s6_18, s6_20, s6_22,
      s2_58, s2_77, s2_87, s2_100, s2_115, s6_29, s6_33, s6_36, s6_63, s2_125, s2_128, s7_57, s4_26,
      s4_27, s6_70, s2_10, s0_9, s0_10, s0_11, s2_52, s2_98, s2_111, s2_116, s4_17, s1_21, s1_22,
      s1_23, s1_24, s1_25, s1_26, s4_18, s4_19, s4_20, s4_22, s4_23, s4_24, s4_25, s4_28, s4_30,
      s6_4, s6_6, s6_8, s6_17, s6_19, s6_21, s6_38, s2_121, s6_72, s8_1, s8_2, s8_3, s8_4, s8_5,
      s8_6, s8_7, s7_27;
};

/// Values of compute_accelerations that cross its parts.
struct AccelerationsWork2 {
  Pair
      Rz_rear_axle_rz_0, Rz_rear_axle_ry_1_and_0, Rz_rear_axle_rx_1_and_0,
      r_carrier_left_and_right_aux1_y, s8_86, s8_87, s3_1, s8_74, s8_82, Rz_rear_axle_tx_1_and_0,
      s2_141, s8_73, s8_76, s7_65, s7_62, s7_86, s2_142, w_carrier_left_and_right_z, s2_162, s2_165,
      s3_18, s2_168, s6_93, zdd_star_carrier_left_and_right_ry, s7_81,
      zdd_star_carrier_left_and_right_rx, s3_13, s7_82, s0_26, s6_92, s3_9, s8_152, s8_193, s8_196,
      s8_199, s8_92, s8_115, s8_157, s8_160, s8_165, s8_190, s8_198, s8_202, s8_203, s8_204, s8_205,
      s8_207, s8_208, s8_211, s8_212, s8_216, s8_227, s8_228, s2_170, s2_146, s0_22, s2_154, s2_156,
      s8_99, s8_100, s8_155, s8_219, s8_225, s4_32, s6_73, s4_33, s6_74, s6_76, s6_78, s2_147,
      s2_153, s8_96, s8_117, s8_123, s8_125, s7_66, s7_67, s3_23, s7_68, s8_174, s8_181, s8_187,
      s8_224, s7_77, s7_78, s7_79, s7_80, s2_145, s2_155, pivot_carrier_left_and_right_rz, s2_158,
      s8_85, s8_104, s8_105, s8_106, s8_107, s8_129, s8_132, s8_133, s8_135, s8_136, s8_141, s8_142,
      s7_83, s6_77, s6_79, s2_149, s2_157, s8_90, s8_91, s8_146, s8_148, s8_191, s2_159, s8_78,
      s8_80, s8_113, s8_139, s8_150, s8_169, s8_240, s8_247, s8_259, s8_261, s8_267, s8_268, s8_273,
      s8_275;
};

/// Values of compute_accelerations that cross its parts.
struct AccelerationsWork3 {
  Pair
      s3_30, s3_32, Rz_carrier_left_and_right_rz_2, s3_35, s2_174, s3_36, s2_175,
      Rz_arb_front_left_0_and_right_1, s8_345, s2_173, Rz_arb_front_left_and_right_2,
      zdd_star_arb_front_left_and_right, s7_98, s7_100, s3_28, s7_126, s7_117, s7_119, s7_124,
      s2_172, s7_94, s7_96, s3_29, s8_346, s8_348, s8_351, s8_352, s8_353, s8_354, s7_91, s7_92,
      s2_176, f_carrier_left_and_right_z, f_carrier_left_and_right_y, s8_302, s8_305, s8_311,
      s8_316, s8_322, s8_326, s7_106, s7_107, s7_112, s7_113, s8_728,
      pivot_arb_front_left_and_right, s2_177, s2_178, s2_179, s7_101, f_carrier_left_and_right_x,
      s7_114, s7_120, s7_127, s8_721, s8_736, n_carrier_left_and_right_z, s8_343, s8_344, s8_387,
      s8_411, s8_445, s8_449, s8_473, s8_484, s8_486, s8_488, s8_495, s8_676, s8_692, s8_807,
      s8_865, s8_867, s8_881, s8_286, s8_293, s8_294, s8_355, s8_369, s8_438, s8_451, s8_453,
      s8_467, s8_470, s8_475, s8_477, s8_479, s8_483, s8_515, s8_657, s8_662, s8_663, s8_664,
      s8_681, s8_682, s8_718, s8_723, s8_733, s8_737;
  double
      R_rear_axle_x_y, R_rear_axle_y_y, r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_z_y,
      R_rear_axle_y_z, R_rear_axle_aux5_y_x, R_rear_axle_x_z, R_rear_axle_aux5_x_x, R_rear_axle_z_z,
      s4_6, s4_10, s4_2, zdd_star_rear_axle_tz, zdd_star_rear_axle_rz, zdd_star_rear_axle_ry,
      R_rear_axle_aux5_x_z, R_rear_axle_aux5_y_z, s4_1, s4_4, s2_9, s2_30, s2_29, s9_1, s9_2, s2_65,
      s2_102, s2_119, s2_122;
};

/// Values of compute_accelerations that cross its parts.
struct AccelerationsWork4 {
  double
      s8_40, s8_46, s8_38, w_chassis_z, s8_18, s8_19, w_chassis_x, s8_20, s2_189, s2_187, s2_191,
      s7_10, s7_20, s7_22, s8_571, s8_35, s8_36, s8_44, s2_186, s3_34, s7_144, s8_564, s8_572,
      s8_575, s8_577, s6_122, s7_142, s7_143, s8_510, s8_573, s8_576, s8_578, s8_592, s7_6, s7_17,
      s7_19, s8_235, s8_512, s8_569, s8_574, s7_8, f_rear_axle_z, f_rear_axle_y, f_rear_axle_x,
      s2_185, s2_188, s8_505, s8_570, zdd_star_rear_axle_rx, s6_62, zdd_star_rear_axle_tx, s7_24,
      R_chassis_z_y, R_chassis_z_z, s7_26, s8_102, s8_114, s8_252, s2_190, s8_516, s8_566, s8_567,
      s8_613, s8_615, n_rear_axle_x, n_rear_axle_y, n_rear_axle_z, s3_21, s8_237, s8_336, s1_39,
      s1_41, s8_568, s8_586, s8_589, s8_590, s8_591, s8_601, s8_604, s8_21, s8_22, s8_23, s3_2,
      s3_3, s3_7, s3_8, s3_11, s3_12, s3_22, s3_25, s3_26, s1_32, s1_33, s1_34, s1_35, s2_193,
      s8_526, s8_529, s1_37, s1_40, s1_42, s1_43, s8_585, s8_587, s8_593, s8_595, s9_3, s9_4, s9_5,
      s8_162, s8_167, s8_409, s2_184, s2_192, s2_194, s2_195, s8_542, s8_544, s8_547, s8_549,
      s8_551, s8_554, s8_588, s8_600, s8_606, s8_612, s8_618, s8_619;
};

/// Values of compute_accelerations that cross its parts.
struct AccelerationsWork5 {
  double
      s8_688, s8_666, s8_704, s8_787, s8_792, s8_686, s8_794, s8_795, s8_798, s8_805, s8_793,
      s8_806, s8_808, s8_904, s8_977, s8_979, s8_981, s8_983, s8_984, s8_791, s8_804, s8_924,
      s8_936, s8_940, s8_964, s8_966, s8_968, s8_970, s8_971, s8_790, s8_803, s8_943, s8_944,
      s8_947, s8_948, s8_952, s8_954, s8_956, s8_958, s8_959, s8_785, s8_789, s8_801, s8_935,
      s8_950, s7_145, s8_786, s8_796, s8_802, s8_914, s8_938, pivot_bell_crank, s8_887, s8_903,
      s8_933, R_chassis_x_z, R_chassis_y_z, R_chassis_x_y, R_chassis_y_y, R_chassis_aux5_x_x,
      R_chassis_aux5_y_x, s8_988, s8_625, s8_695, s8_700, s8_701, s8_799, s8_905, s8_946, s8_962,
      s8_974, s8_987;
};

/// Values of compute_accelerations that cross its parts.
struct AccelerationsWork6 {
  double
      sines[22], cosines[22];
};

/// Part 1 of compute_accelerations: step 1: poses and axes b; step 2: closure Jacobian Phi_z and
/// its factors (60), long_rod_left .. arb_link_rear_right; step 4: velocities; step 6: c and dRz/dt
/// zd (62), long_rod_left .. arb_link_rear_right; step 9: accelerations from the root to the leaves
/// (63), (62).
[[gnu::noinline]] void compute_accelerations_1(const State& state,
    AccelerationsWork1& __restrict w1, AccelerationsWork3& __restrict w3,
    AccelerationsWork6& __restrict w6, Accelerations& __restrict result) noexcept {
  // Results that need no operation.
  result.inertia[9] = I_wheel_front_left_polar;
  result.inertia[10] = I_wheel_front_right_polar;
  result.inertia[13] = I_wheel_rear_left_polar;
  result.inertia[14] = I_wheel_rear_right_polar;

  const double s0_1 = -state.z[Coordinate::upper_arm_right];
  const Pair s0_2 = Pair{state.z[Coordinate::upper_arm_left], s0_1};
  const double s0_3 = -state.z[Coordinate::lower_arm_right];
  const Pair s0_4 = Pair{state.z[Coordinate::lower_arm_left], s0_3};
  const Pair s0_5 = Pair{state.z[Coordinate::arb_rear_left], state.z[Coordinate::arb_rear_right]};
  const Pair s0_6 = Pair{state.z[Coordinate::carrier_left_ry],
      state.z[Coordinate::carrier_right_ry]};
  const Pair s0_7 = Pair{state.z[Coordinate::arb_front_left], state.z[Coordinate::arb_front_right]};

  // --- step 1: poses and axes b ---
  const double angles[] = {
      state.z[Coordinate::chassis_rz], state.z[Coordinate::chassis_ry],
      state.z[Coordinate::chassis_rx], state.z[Coordinate::carrier_left_rz],
      state.z[Coordinate::carrier_left_rx], state.z[Coordinate::carrier_right_rz],
      state.z[Coordinate::carrier_right_rx], state.z[Coordinate::pitman_arm],
      state.z[Coordinate::bell_crank], state.z[Coordinate::rear_axle_rz],
      state.z[Coordinate::rear_axle_ry], state.z[Coordinate::rear_axle_rx], s0_5[0], s0_5[1],
      s0_2[0], s0_2[1], s0_4[0], s0_4[1], s0_6[0], s0_6[1], s0_7[0], s0_7[1]};
  mbgen::sincos(angles, w6.sines, w6.cosines);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = w6.cosines[9];
  const double s1_1 = w6.sines[10];
  w3.R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_1;
  const double s1_2 = w6.sines[11];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double R_rear_axle_aux4_y_x = w6.sines[9];
  const double s1_3 = w6.cosines[11];
  w3.R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_3, w3.R_rear_axle_aux5_x_z*s1_2);
  w3.R_rear_axle_x_z = fma(w3.R_rear_axle_aux5_x_z, s1_3, R_rear_axle_aux4_y_x*s1_2);

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right
  // ---
  const double s2_1 = p_diag_rod_left_to_z*w3.R_rear_axle_x_z;
  const double s2_2 = fnma(p_diag_rod_left_to_y, w3.R_rear_axle_x_y, s2_1);
  w1.s2_3 = Pair{fma(p_diag_rod_left_to_y, w3.R_rear_axle_x_y, s2_1), s2_2};
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  w3.R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_1;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  w3.R_rear_axle_y_y = fma(R_rear_axle_aux4_x_x, s1_3, w3.R_rear_axle_aux5_y_z*s1_2);
  w3.R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_2, w3.R_rear_axle_aux5_y_z*s1_3);
  const double s2_4 = p_diag_rod_left_to_y*w3.R_rear_axle_y_y;
  const double s2_5 = fnma(p_diag_rod_left_to_z, w3.R_rear_axle_y_z, s2_4);
  w1.s2_6 = Pair{fma(p_diag_rod_left_to_z, w3.R_rear_axle_y_z, s2_4), s2_5};
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  w3.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  w1.s1_4 = Pair{w3.r_rear_axle_aux1_x, w3.r_rear_axle_aux1_x};
  w1.s2_7 = w1.s2_3 + (w1.s1_4 - p_diag_rod_left_from_x);
  w1.s2_8 = 1.0/w1.s2_7;
  w3.s2_9 = w1.s2_8[1];
  w1.s2_10 = Pair{w3.s2_9, w1.s2_8[0]};
  const Pair s2_11 = w1.s2_7*w1.s2_10;
  const Pair s2_12 = Pair{s2_11[1], s2_11[0]};
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  w1.s0_8 = Pair{z_rear_axle_ty, -z_rear_axle_ty};
  w1.s2_13 = p_diag_rod_left_from_y - w1.s0_8 - w1.s2_6;
  const Pair s2_14 = w1.s2_13*s2_12;
  const Pair s2_15 = w1.s2_13 + Pair{s2_14[1], s2_14[0]};
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux5_z_z = w6.cosines[10];
  w3.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s2_16 = p_long_rod_left_to_x*w3.R_rear_axle_aux5_x_x;
  const double s2_17 = fma(p_long_rod_left_to_z, w3.R_rear_axle_x_z, s2_16);
  const double s2_18 = fnma(p_long_rod_left_to_y, w3.R_rear_axle_x_y, s2_17);
  w1.s2_19 = Pair{s2_18, fma(p_long_rod_left_to_y, w3.R_rear_axle_x_y, s2_17)};
  w3.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s2_20 = p_long_rod_left_to_x*w3.R_rear_axle_aux5_y_x;
  const double s2_21 = fma(p_long_rod_left_to_z, w3.R_rear_axle_y_z, s2_20);
  const double s2_22 = fms(p_long_rod_left_to_y, w3.R_rear_axle_y_y, s2_21);
  w1.s2_23 = Pair{s2_22, fma(p_long_rod_left_to_y, w3.R_rear_axle_y_y, s2_21)};
  w1.s2_24 = fma(w1.s2_3, w1.s2_13, w1.s2_7*w1.s2_6);
  w1.s2_25 = fma(s2_12, w1.s2_24, Pair{w1.s2_24[1], w1.s2_24[0]});
  w1.s2_26 = w1.s2_19 + (w1.s1_4 - p_long_rod_left_from_x);
  w1.s2_27 = w1.s0_8 + (p_long_rod_left_from_y - w1.s2_23);
  w1.s2_28 = 1.0/s2_15;
  w3.s2_29 = 1.665350081353039*std::abs(s2_15[0]);
  w3.s2_30 = w1.s2_28[0];
  const Pair s2_31 = w1.s2_8*w1.s2_26;
  const Pair s2_32 = fma(w1.s2_13, s2_31, w1.s2_27)*Pair{w1.s2_28[1], w3.s2_30};
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  w3.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_2;
  w3.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_3;
  const double s2_33 = p_diag_rod_left_to_y*w3.R_rear_axle_z_y;
  const double s2_34 = fma(p_diag_rod_left_to_z, w3.R_rear_axle_z_z, s2_33);
  w1.s2_35 = Pair{s2_34, fms(p_diag_rod_left_to_z, w3.R_rear_axle_z_z, s2_33)};
  const double s2_36 = p_long_rod_left_to_x*s1_1;
  const double s2_37 = fnma(p_long_rod_left_to_z, w3.R_rear_axle_z_z, s2_36);
  const double s2_38 = -fma(p_long_rod_left_to_y, w3.R_rear_axle_z_y, s2_37);
  w1.s2_39 = Pair{s2_38, fms(p_long_rod_left_to_y, w3.R_rear_axle_z_y, s2_37)};
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  w3.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] + p_rear_axle_tx_z;
  w1.s1_5 = Pair{w3.r_rear_axle_aux3_z, w3.r_rear_axle_aux3_z};
  w1.s2_40 = w1.s2_35 + (w1.s1_5 - p_diag_rod_left_from_z);
  w1.s2_41 = fma(w1.s2_6, w1.s2_40, w1.s2_13*w1.s2_35);
  const Pair s2_42 = s2_12*w1.s2_41;
  w1.s2_43 = w1.s2_41 + Pair{s2_42[1], s2_42[0]};
  w1.s2_44 = w1.s2_39 + (w1.s1_5 - p_long_rod_left_from_z);
  const Pair s2_45 = fma(s2_31, w1.s2_41, fma(w1.s2_23, w1.s2_44, w1.s2_27*w1.s2_39));
  w1.s2_46 = fnma(s2_32, Pair{w1.s2_43[1], w1.s2_43[0]}, s2_45);
  const Pair s2_47 = s2_12*w1.s2_40;
  w1.s2_48 = w1.s2_40 - Pair{s2_47[1], s2_47[0]};
  const Pair s2_49 = fnma(s2_31, w1.s2_40, w1.s2_44);
  w1.s2_50 = fnma(s2_32, Pair{w1.s2_48[1], w1.s2_48[0]}, s2_49);
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  w1.s0_9 = Pair{zd_rear_axle_ty, -zd_rear_axle_ty};

  // --- step 4: velocities ---
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  w3.s4_1 = zd_rear_axle_rx*s1_1;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  w3.s4_2 = zd_rear_axle_rz - w3.s4_1;
  w1.s4_3 = Pair{w3.s4_2, -w3.s4_2};
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  w3.s4_4 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  const double s4_5 = zd_rear_axle_rx*w3.R_rear_axle_aux5_x_x;
  w3.s4_6 = s4_5 - w3.s4_4;
  w1.s4_7 = Pair{w3.s4_6, -w3.s4_6};

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right ---
  const Pair s6_1 = fnma(w1.s2_35, w1.s4_7, w1.s2_3*w1.s4_3);
  const double s4_8 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  const double s4_9 = zd_rear_axle_rx*w3.R_rear_axle_aux5_y_x;
  w3.s9_1 = fma(w3.s4_4, s4_9, s4_8*s4_5);
  w3.s4_10 = s4_8 + s4_9;
  w3.s9_2 = fma(zd_rear_axle_rz, w3.s4_10, s4_8*w3.s4_1);
  w1.s4_11 = Pair{w3.s4_10, w3.s4_10};
  const Pair s6_2 = fnma(w1.s2_6, w1.s4_3, w1.s2_35*w1.s4_11);
  const Pair s6_3 = fnma(w1.s2_3, w1.s4_11, w1.s2_6*w1.s4_7);
  w1.s6_4 = fnma(w1.s4_3, s6_1, w1.s4_11*s6_3);
  w1.s6_5 = w1.s0_9 + s6_1;
  w1.s6_6 = fnma(w1.s4_11, s6_2, w1.s4_7*s6_1);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  w1.s0_10 = Pair{zd_rear_axle_tx, zd_rear_axle_tx};
  w1.s6_7 = w1.s0_10 + s6_2;
  w1.s6_8 = fnma(w1.s4_7, s6_3, w1.s4_3*s6_2);
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  w1.s0_11 = Pair{zd_rear_axle_tz, zd_rear_axle_tz};

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right, continued ---
  w1.s6_9 = w1.s0_11 + s6_3;
  const Pair s6_10 = fma(w1.s6_9, w1.s6_9, fma(w1.s6_7, w1.s6_7, w1.s6_5*w1.s6_5));
  const Pair s6_11 = fma(w1.s2_7, w1.s6_4, fma(w1.s2_40, w1.s6_6, s6_10));
  w1.s6_12 = fnma(w1.s2_13, w1.s6_8, s6_11);
  w1.s6_13 = fms(s2_11, Pair{w1.s6_12[1], w1.s6_12[0]}, w1.s6_12);
  // long_rod_right; and likewise long_rod_left
  const Pair s6_14 = fms(w1.s2_39, w1.s4_7, w1.s2_19*w1.s4_3);
  const Pair s6_15 = fma(w1.s2_23, w1.s4_3, w1.s2_39*w1.s4_11);
  const Pair s6_16 = fma(w1.s2_19, w1.s4_11, w1.s2_23*w1.s4_7);
  w1.s6_17 = fms(w1.s4_3, s6_14, w1.s4_11*s6_16);
  w1.s6_18 = s6_14 - w1.s0_9;
  w1.s6_19 = fma(w1.s4_11, s6_15, w1.s4_7*s6_14);
  w1.s6_20 = w1.s0_10 + s6_15;
  w1.s6_21 = fma(w1.s4_7, s6_16, w1.s4_3*s6_15);
  w1.s6_22 = w1.s0_11 - s6_16;
  const Pair s6_23 = fnma(w1.s6_20, w1.s6_20, fnma(w1.s6_18, w1.s6_18, s2_31*w1.s6_12));
  const Pair s6_24 = fma(w1.s2_44, w1.s6_19, fnma(w1.s6_22, w1.s6_22, s6_23));
  const Pair s6_25 = fnma(w1.s2_27, w1.s6_21, fnma(w1.s2_26, w1.s6_17, s6_24));
  w1.s6_26 = fnma(s2_32, Pair{w1.s6_13[1], w1.s6_13[0]}, s6_25);

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right,
  // continued ---
  const Pair s2_51 = fnma(w1.s2_26, w1.s2_23, fnma(w1.s2_24, s2_31, w1.s2_25*s2_32));
  w1.s2_52 = fnma(w1.s2_19, w1.s2_27, s2_51);
  const Pair s2_53 = w1.s2_10*w1.s2_26;
  const Pair s2_54 = Pair{s2_53[1], s2_53[0]};
  const Pair s2_55 = fnma(w1.s2_26, w1.s2_39, w1.s2_19*w1.s2_44);
  w1.s2_56 = fnma(w1.s2_7, w1.s2_35, w1.s2_3*w1.s2_40);
  const Pair s2_57 = w1.s2_13*s2_54;
  w1.s2_58 = fms(s2_12, w1.s2_56, Pair{w1.s2_56[1], w1.s2_56[0]});
  const Pair s2_59 = w1.s2_28*(w1.s2_27 - Pair{s2_57[1], s2_57[0]});
  const Pair s2_60 = fms(w1.s2_56, s2_54, Pair{s2_55[1], s2_55[0]});
  w1.s2_61 = fma(w1.s2_58, Pair{s2_59[1], s2_59[0]}, s2_60);
}

/// Part 2 of compute_accelerations: step 2: closure Jacobian Phi_z and its factors (60),
/// long_rod_left .. arb_link_rear_right; step 6: c and dRz/dt zd (62), long_rod_left ..
/// arb_link_rear_right; step 8: elimination from the leaves to the root (63), long_rod_left ..
/// arb_link_rear_right; step 7: inertias of the bodies and forces on joints, long_rod_left ..
/// arb_link_rear_right; step 8: elimination from the leaves to the root (63).
[[gnu::noinline]] void compute_accelerations_2(const State& state, const double* tau,
    AccelerationsWork1& __restrict w1, AccelerationsWork3& __restrict w3,
    AccelerationsWork4& __restrict w4, AccelerationsWork6& __restrict w6) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right,
  // continued ---
  w1.s2_62 = 1.0/w1.s2_52;
  const double s2_63 = w1.s2_62[1];
  const Pair s2_64 = w1.s2_52*Pair{s2_63, w1.s2_62[0]};
  w3.s2_65 = 2.1234888829989926*std::abs(w1.s2_52[1]);
  const Pair s2_66 = w1.s2_61*s2_64;
  const Pair s2_67 = w1.s2_61 + Pair{s2_66[1], s2_66[0]};
  const double s2_68 = -p_arb_link_rear_left_to_x*w3.R_rear_axle_aux5_y_x;
  const double s2_69 = fnma(p_arb_link_rear_left_to_z, w3.R_rear_axle_y_z, s2_68);
  const double s2_70 = fms(p_arb_link_rear_left_to_y, w3.R_rear_axle_y_y, s2_69);
  w1.s2_71 = Pair{s2_70, fma(p_arb_link_rear_left_to_y, w3.R_rear_axle_y_y, s2_69)};
  const double s2_72 = -p_arb_link_rear_left_to_x*w3.R_rear_axle_aux5_x_x;
  const double s2_73 = fnma(p_arb_link_rear_left_to_z, w3.R_rear_axle_x_z, s2_72);
  const double s2_74 = -fma(p_arb_link_rear_left_to_y, w3.R_rear_axle_x_y, s2_73);
  w1.s2_75 = Pair{fms(p_arb_link_rear_left_to_y, w3.R_rear_axle_x_y, s2_73), s2_74};
  w1.s2_76 = 0.6 - w1.s0_8 - w1.s2_71;
  w1.s2_77 = p_arb_link_rear_left_from_x*mbgen::pair_at(w6.cosines + 12);
  w1.s2_78 = w1.s2_77 + p_arb_rear_left_x - w1.s1_4 - w1.s2_75;
  const Pair s2_79 = w1.s2_10*w1.s2_78;
  const Pair s2_80 = w1.s2_8*w1.s2_78;
  const Pair s2_81 = fma(w1.s2_13, s2_80, w1.s2_76);
  const Pair s2_82 = w1.s2_28*Pair{s2_81[1], s2_81[0]};
  const double s1_1 = w6.sines[10];
  const double s2_83 = -p_arb_link_rear_left_to_x*s1_1;
  const double s2_84 = fma(p_arb_link_rear_left_to_z, w3.R_rear_axle_z_z, s2_83);
  const double s2_85 = fnma(p_arb_link_rear_left_to_y, w3.R_rear_axle_z_y, s2_84);
  w1.s2_86 = Pair{fma(p_arb_link_rear_left_to_y, w3.R_rear_axle_z_y, s2_84), s2_85};
  w1.s2_87 = p_arb_link_rear_left_from_x*mbgen::pair_at(w6.sines + 12);
  w1.s2_88 = w1.s2_86 + (w1.s2_87 + (w1.s1_5 - p_arb_rear_left_z));
  const Pair s2_89 = fma(w1.s2_71, w1.s2_88, fma(w1.s2_76, w1.s2_86, w1.s2_41*s2_80));
  const Pair s2_90 = Pair{s2_82[1], s2_82[0]};
  const Pair s2_91 = fma(w1.s2_24, s2_80, fnma(w1.s2_71, w1.s2_78, w1.s2_76*w1.s2_75));
  const Pair s2_92 = fnma(w1.s2_25, s2_90, s2_91);
  const Pair s2_93 = fnma(w1.s2_78, w1.s2_86, fnma(w1.s2_56, s2_80, w1.s2_58*s2_90));
  const Pair s2_94 = fnma(w1.s2_75, w1.s2_88, s2_93);
  const Pair s2_95 = w1.s2_62*s2_92;
  const Pair s2_96 = w1.s2_46*s2_95;
  const Pair s2_97 = fms(w1.s2_43, s2_82, Pair{s2_89[1], s2_89[0]});
  w1.s2_98 = fms(s2_64, Pair{w1.s2_46[1], w1.s2_46[0]}, w1.s2_46);
  const Pair s6_27 = s2_95*w1.s6_26;
  const Pair s2_99 = w1.s2_61*Pair{s2_95[1], s2_95[0]};
  w1.s2_100 = 1.0/s2_67;
  const Pair s2_101 = (s2_94 - Pair{s2_99[1], s2_99[0]})*w1.s2_100;
  w3.s2_102 = 1.7864443153153613*std::abs(s2_67[1]);
  const Pair s2_103 = s2_97 - Pair{s2_96[1], s2_96[0]};
  const Pair pivot_rear_axle_rz = fnma(w1.s2_98, Pair{s2_101[1], s2_101[0]}, s2_103);
  const Pair s2_104 = Pair{s2_79[1], s2_79[0]};
  const Pair s2_105 = w1.s2_40*s2_104;
  const Pair s2_106 = fms(w1.s2_13, s2_104, Pair{w1.s2_76[1], w1.s2_76[0]});
  const Pair s2_107 = w1.s2_88 + Pair{s2_105[1], s2_105[0]};
  const Pair s2_108 = w1.s2_62*Pair{s2_92[1], s2_92[0]};
  const Pair s2_109 = w1.s2_50*s2_108;
  const Pair s2_110 = fma(w1.s2_48, w1.s2_28*Pair{s2_106[1], s2_106[0]}, s2_107);
  w1.s2_111 = fma(s2_64, Pair{w1.s2_50[1], w1.s2_50[0]}, w1.s2_50);
  const Pair s2_112 = fma(w1.s2_61, Pair{s2_108[1], s2_108[0]}, s2_94);
  const Pair s2_113 = w1.s2_100*Pair{s2_112[1], s2_112[0]};
  const Pair s2_114 = Pair{s2_109[1], s2_109[0]} + s2_110;
  w1.s2_115 = fnma(w1.s2_111, Pair{s2_113[1], s2_113[0]}, s2_114);
  w1.s2_116 = 1.0/pivot_rear_axle_rz;
  const double s2_117 = w1.s2_116[0];
  const Pair s2_118 = pivot_rear_axle_rz*Pair{w1.s2_116[1], s2_117};
  w3.s2_119 = 8.176955428452642*std::abs(pivot_rear_axle_rz[0]);
  const Pair s2_120 = w1.s2_115*s2_118;
  const Pair pivot_rear_axle_tz = w1.s2_115 + Pair{s2_120[1], s2_120[0]};
  const Pair s6_28 = fnma(w1.s2_86, w1.s4_7, w1.s2_75*w1.s4_3);
  w1.s6_29 = w1.s0_9 + s6_28;
  w1.s0_12 = Pair{state.zd[Coordinate::arb_rear_left], state.zd[Coordinate::arb_rear_right]};

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right, continued ---
  // arb_link_rear_left; and likewise arb_link_rear_right
  const Pair s6_30 = w1.s2_87*w1.s0_12;
  const Pair s6_31 = w1.s2_77*w1.s0_12;
  const Pair s6_32 = fnma(w1.s2_71, w1.s4_3, w1.s2_86*w1.s4_11);
  w1.s6_33 = s6_32 + (w1.s0_10 + s6_30);
  const Pair s6_34 = fma(w1.s4_11, s6_32, fnma(w1.s4_7, s6_28, w1.s0_12*s6_30));
  const Pair s6_35 = fnma(w1.s2_75, w1.s4_11, w1.s2_71*w1.s4_7);
  w1.s6_36 = s6_35 + (w1.s0_11 + s6_31);
  const Pair s6_37 = fnma(w1.s4_7, s6_35, w1.s4_3*s6_32);
  w1.s6_38 = fma(w1.s4_11, s6_35, fnma(w1.s4_3, s6_28, w1.s0_12*s6_31));
  const Pair s6_39 = fma(w1.s6_33, w1.s6_33, fma(w1.s6_29, w1.s6_29, s2_80*w1.s6_12));
  const Pair s6_40 = fnma(w1.s2_76, s6_37, fma(w1.s6_36, w1.s6_36, s6_39));
  const Pair s6_41 = fnma(w1.s2_78, w1.s6_38, fnma(w1.s2_88, s6_34, s6_40));
  const Pair s6_42 = fms(s2_82, w1.s6_13, Pair{s6_41[1], s6_41[0]});
  const Pair s6_43 = fma(s2_64, Pair{w1.s6_26[1], w1.s6_26[0]}, w1.s6_26);
  const Pair s6_44 = s2_101*Pair{s6_43[1], s6_43[0]};
  const Pair s6_45 = s6_42 - Pair{s6_27[1], s6_27[0]} - Pair{s6_44[1], s6_44[0]};
  const Pair s6_46 = fma(s2_118, Pair{s6_45[1], s6_45[0]}, s6_45);
  w1.s2_121 = 1.0/pivot_rear_axle_tz;
  w3.s2_122 = 2.7700489841913827*std::abs(pivot_rear_axle_tz[0]);
  w3.zdd_star_rear_axle_tz = w1.s2_121[0]*s6_46[1];
  const Pair s6_47 = Pair{w3.zdd_star_rear_axle_tz, w3.zdd_star_rear_axle_tz};

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right
  // ---
  const Pair s6_48 = w1.s2_115*s6_47;
  const Pair s6_49 = s6_45 - Pair{s6_48[1], s6_48[0]};
  w3.zdd_star_rear_axle_rz = s2_117*s6_49[0];
  const Pair s6_50 = Pair{w3.zdd_star_rear_axle_rz, -w3.zdd_star_rear_axle_rz};
  const Pair s6_51 = fnma(w1.s2_98, s6_50, fnma(w1.s2_111, s6_47, s6_43));
  w1.s8_1 = fms(w1.s2_35, s6_50, w1.s6_8);
  w1.s8_2 = fms(w1.s2_86, s6_50, s6_37);
  w3.zdd_star_rear_axle_ry = w1.s2_100[1]*s6_51[0];
  w1.s6_52 = Pair{w3.zdd_star_rear_axle_ry, w3.zdd_star_rear_axle_ry};
  w1.s8_3 = fma(w1.s2_75, w1.s6_52, fnma(w1.s2_71, s6_50, s6_34 - s6_47));
  const Pair s6_53 = fnma(w1.s2_40, s6_47, fms(w1.s2_56, w1.s6_52, w1.s6_12));
  w1.s8_4 = fma(w1.s2_23, s6_50, fma(w1.s2_19, w1.s6_52, w1.s6_19) - s6_47);
  w1.s8_5 = fnma(w1.s2_6, s6_50, fms(w1.s2_3, w1.s6_52, w1.s6_6) - s6_47);
  const Pair s6_54 = w1.s2_61*w1.s6_52;
  const Pair s6_55 = fnma(w1.s2_50, s6_47, w1.s6_26) - Pair{s6_54[1], s6_54[0]};
  const Pair s6_56 = fma(w1.s2_46, s6_50, s6_55);
  w4.zdd_star_rear_axle_rx = s2_63*s6_56[1];
  w1.s6_57 = Pair{-w4.zdd_star_rear_axle_rx, w4.zdd_star_rear_axle_rx};
  w1.s8_6 = fnma(w1.s2_39, w1.s6_52, fms(w1.s2_23, w1.s6_57, w1.s6_17));

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right, continued ---
  const Pair s6_58 = w1.s2_25*w1.s6_57;
  const Pair s6_59 = fnma(w1.s2_43, s6_50, fnma(w1.s2_48, s6_47, w1.s6_13));
  const Pair s6_60 = w1.s2_58*w1.s6_52;
  const Pair s6_61 = Pair{s6_58[1], s6_58[0]} + s6_59 - Pair{s6_60[1], s6_60[0]};
  w4.s6_62 = w3.s2_30*s6_61[0];
  w1.s6_63 = Pair{-w4.s6_62, w4.s6_62};
  const Pair s6_64 = fnma(w1.s2_24, w1.s6_57, fnma(w1.s2_41, s6_50, s6_53));
  const Pair s6_65 = fma(w1.s2_13, w1.s6_63, s6_64);
  w1.s8_7 = w1.s6_63 + fnma(w1.s2_19, w1.s6_57, fnma(w1.s2_39, s6_50, w1.s6_21));
  w4.zdd_star_rear_axle_tx = w3.s2_9*s6_65[1];

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_1 = K_rear_axle_xx*w3.R_rear_axle_aux5_y_x;
  const double s7_2 = fma(K_rear_axle_xz, w3.R_rear_axle_y_z, s7_1);
  const double s7_3 = K_rear_axle_yy*w3.R_rear_axle_y_y;
  const double s7_4 = K_rear_axle_xz*w3.R_rear_axle_aux5_y_x;
  const double s7_5 = fma(K_rear_axle_zz, w3.R_rear_axle_y_z, s7_4);
  w4.s7_6 = fma(w3.R_rear_axle_z_z, s7_5, fnma(s1_1, s7_2, w3.R_rear_axle_z_y*s7_3));
  const double s7_7 = fma(w3.R_rear_axle_y_y, s7_3, w3.R_rear_axle_aux5_y_x*s7_2);
  w4.s7_8 = fma(w3.R_rear_axle_y_z, s7_5, s7_7);
  const double s7_9 = h_rear_axle_x*w3.R_rear_axle_aux5_y_x;
  w4.s7_10 = fma(h_rear_axle_z, w3.R_rear_axle_y_z, s7_9);
  const double s7_11 = K_rear_axle_xx*w3.R_rear_axle_aux5_x_x;
  const double s7_12 = fma(K_rear_axle_xz, w3.R_rear_axle_x_z, s7_11);
  const double s7_13 = K_rear_axle_xz*w3.R_rear_axle_aux5_x_x;
  const double s7_14 = fma(K_rear_axle_zz, w3.R_rear_axle_x_z, s7_13);
  const double s7_15 = K_rear_axle_yy*w3.R_rear_axle_x_y;
  const double s7_16 = fma(w3.R_rear_axle_y_y, s7_15, w3.R_rear_axle_aux5_y_x*s7_12);
  w4.s7_17 = fma(w3.R_rear_axle_y_z, s7_14, s7_16);
  const double s7_18 = fnma(s1_1, s7_12, w3.R_rear_axle_z_y*s7_15);
  w4.s7_19 = fma(w3.R_rear_axle_z_z, s7_14, s7_18);
  w4.s7_20 = fnma(h_rear_axle_x, s1_1, h_rear_axle_z*w3.R_rear_axle_z_z);
  const double s7_21 = h_rear_axle_x*w3.R_rear_axle_aux5_x_x;
  w4.s7_22 = fma(h_rear_axle_z, w3.R_rear_axle_x_z, s7_21);
  const double s7_23 = fma(w3.R_rear_axle_x_y, s7_15, w3.R_rear_axle_aux5_x_x*s7_12);
  w4.s7_24 = fma(w3.R_rear_axle_x_z, s7_14, s7_23);
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux5_z_z = w6.cosines[1];
  const double s1_6 = w6.sines[2];
  w4.R_chassis_z_y = R_chassis_aux5_z_z*s1_6;
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  const double s4_12 = zd_chassis_rz*w6.sines[1];
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  w4.w_chassis_x = zd_chassis_rx - s4_12;
  const double s4_13 = zd_chassis_rz*w4.R_chassis_z_y;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  const double s1_7 = w6.cosines[2];
  const double s4_14 = zd_chassis_ry*s1_7;
  const double w_chassis_y = s4_13 + s4_14;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double w_rear_axle_x = w4.w_chassis_x + w3.s4_6;
  const double w_rear_axle_y = w_chassis_y + w3.s4_10;

  // --- step 8: elimination from the leaves to the root (63) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  w4.R_chassis_z_z = R_chassis_aux5_z_z*s1_7;
  const double s4_15 = zd_chassis_rz*w4.R_chassis_z_z;
  const double s4_16 = zd_chassis_ry*s1_6;
  w4.w_chassis_z = s4_15 - s4_16;
  w4.s9_3 = fma(s4_13, s4_16, s4_14*s4_15);
  w4.s9_4 = fma(zd_chassis_rx, w_chassis_y, s4_12*s4_14);
  w4.s9_5 = fnma(zd_chassis_rx, w4.w_chassis_z, s4_12*s4_16);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double w_rear_axle_z = w4.w_chassis_z + w3.s4_2;
  const double s8_8 = fma(w3.R_rear_axle_y_y, w_rear_axle_y, w3.R_rear_axle_x_y*w_rear_axle_x);
  const double s8_9 = fma(w3.R_rear_axle_z_y, w_rear_axle_z, s8_8);
  const double s8_10 = state.zd[Coordinate::wheel_rear_right] + s8_9;
  const double s8_11 = s8_10 + (state.zd[Coordinate::wheel_rear_left] + s8_9);
  const double s8_12 = I_wheel_rear_right_polar*s8_11;
  const double s8_13 = w3.R_rear_axle_y_y*w_rear_axle_x;
  const double s8_14 = w3.R_rear_axle_x_y*w_rear_axle_z;
  const double s8_15 = w3.R_rear_axle_z_y*w_rear_axle_y;

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const double s8_16 = w_chassis_y*w_chassis_y;
  const double s8_17 = w4.w_chassis_x*w4.w_chassis_x;
  w4.s8_18 = s8_16 + s8_17;
  w4.s8_19 = fma(w4.w_chassis_z, w4.w_chassis_z, s8_16);
  w4.s8_20 = fma(w4.w_chassis_z, w4.w_chassis_z, s8_17);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  w4.s8_21 = fnma(w_chassis_y, w3.s4_6, w4.w_chassis_x*w3.s4_10);
  w4.s8_22 = fnma(w4.w_chassis_x, w3.s4_2, w4.w_chassis_z*w3.s4_6);
  w4.s8_23 = fnma(w4.w_chassis_z, w3.s4_10, w_chassis_y*w3.s4_2);
  const double s8_24 = w4.zdd_star_rear_axle_rx + w4.s8_21;
  const double s8_25 = fms(w_rear_axle_x, w_rear_axle_y, s8_24);
  const double s8_26 = fma(w_rear_axle_x, w_rear_axle_y, s8_24);
  const double s8_27 = w3.zdd_star_rear_axle_rz + w4.s8_23;
  const double s8_28 = fms(w_rear_axle_y, w_rear_axle_z, s8_27);
  const double s8_29 = fma(w_rear_axle_y, w_rear_axle_z, s8_27);
  const double s8_30 = w_rear_axle_y*w_rear_axle_y;
  const double s8_31 = w3.zdd_star_rear_axle_ry + w4.s8_22;
  const double s8_32 = fma(w_rear_axle_x, w_rear_axle_z, s8_31);
  const double s8_33 = fms(w_rear_axle_x, w_rear_axle_z, s8_31);
  const double s8_34 = w_rear_axle_z*w_rear_axle_z;
  w4.s8_35 = w4.w_chassis_x + w4.w_chassis_x;
  w4.s8_36 = w4.w_chassis_z + w4.w_chassis_z;
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s8_37 = fms(zd_rear_axle_tx, w4.s8_36, w4.s6_62);
  w4.s8_38 = w4.w_chassis_x*w_chassis_y;
  const double s8_39 = fnma(zd_rear_axle_tz, w4.s8_35, s8_37);
  w4.s8_40 = w_chassis_y*w4.w_chassis_z;
  const double s8_41 = fma(w3.r_rear_axle_aux1_x, w4.s8_38, s8_39);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_42 = fma(w3.r_rear_axle_aux3_z, w4.s8_40, s8_41);
  const double s8_43 = fnma(z_rear_axle_ty, w4.s8_20, s8_42);
  w4.s8_44 = w_chassis_y + w_chassis_y;
  w1.s4_17 = Pair{w_chassis_y, w_chassis_y};
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_45 = fnma(zd_rear_axle_tx, w4.s8_44, w3.zdd_star_rear_axle_tz);
  w4.s8_46 = w4.w_chassis_x*w4.w_chassis_z;
  const double s8_47 = fma(z_rear_axle_ty, w4.s8_40, fma(zd_rear_axle_ty, w4.s8_35, s8_45));
  const double s8_48 = fma(w3.r_rear_axle_aux1_x, w4.s8_46, s8_47);
  const double s8_49 = fnma(w3.r_rear_axle_aux3_z, w4.s8_18, s8_48);
  const double s8_50 = fma(w_rear_axle_x, w_rear_axle_x, s8_34);
  const double s8_51 = s8_30 + s8_34;
  const double s8_52 = fma(w_rear_axle_x, w_rear_axle_x, s8_30);
  const double s7_25 = K_rear_axle_trace - w4.s7_24;
  w4.s7_26 = s7_25 - w4.s7_8;
  const double s8_53 = fnma(w4.s7_19, s8_26, fnma(w4.s7_20, s8_43, w4.s7_10*s8_49));
  w1.s7_27 = Pair{s7_25, s7_25};
  const double s8_54 = fma(w4.s7_17, s8_33, fma(w4.s7_8, s8_29, fnma(w4.s7_26, s8_28, s8_53)));
  const double s8_55 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_56 = fma(w3.R_rear_axle_x_y, s8_55, fma(w4.s7_6, s8_50 - s8_52, s8_54));
  w4.n_rear_axle_x = fma(fnma(w3.R_rear_axle_y_y, w_rear_axle_z, s8_15), s8_12, s8_56);
  const double s8_57 = fma(zd_rear_axle_tz, w4.s8_44, w4.zdd_star_rear_axle_tx);
  const double s8_58 = fma(z_rear_axle_ty, w4.s8_38, fnma(zd_rear_axle_ty, w4.s8_36, s8_57));
  const double s8_59 = fma(w3.r_rear_axle_aux3_z, w4.s8_46, s8_58);
  const double s8_60 = fnma(w3.r_rear_axle_aux1_x, w4.s8_19, s8_59);
  const double s8_61 = fma(w4.s7_26, s8_32, fma(w4.s7_6, s8_25, w4.s7_20*s8_60));
  const double s8_62 = fnma(w4.s7_17, s8_29, fnma(w4.s7_22, s8_49, s8_61));
  const double s8_63 = fma(w4.s7_22, s8_33, fma(w4.s7_10, s8_29, m_rear_axle*s8_49));
  w4.f_rear_axle_z = fnma(w4.s7_20, s8_52, s8_63);
  const double s8_64 = fma(w3.R_rear_axle_y_y, s8_55, fnma(w4.s7_24, s8_33, s8_62));
  const double s8_65 = fma(fnma(w3.R_rear_axle_z_y, w_rear_axle_x, s8_14), s8_12, s8_64);
  w4.n_rear_axle_y = fma(w4.s7_19, s8_52 - s8_51, s8_65);
  const double s8_66 = fnma(w4.s7_8, s8_25, fnma(w4.s7_10, s8_60, w4.s7_22*s8_43));
  const double s8_67 = fma(w4.s7_20, s8_28, fma(w4.s7_22, s8_26, m_rear_axle*s8_43));
  w4.f_rear_axle_y = fnma(w4.s7_10, s8_50, s8_67);
  const double s8_68 = fma(w4.s7_20, s8_32, fma(w4.s7_10, s8_25, m_rear_axle*s8_60));
  w4.f_rear_axle_x = fnma(w4.s7_22, s8_51, s8_68);
  const double s8_69 = fma(w4.s7_19, s8_28, fma(w4.s7_24, s8_26, fnma(w4.s7_6, s8_32, s8_66)));
  const double s8_70 = fnma(w3.R_rear_axle_x_y, w_rear_axle_y, s8_13);
  const double s8_71 = fma(s8_70, s8_12, fma(w3.R_rear_axle_z_y, s8_55, s8_69));
  w4.n_rear_axle_z = fma(w4.s7_17, s8_51 - s8_50, s8_71);
}

/// Part 3 of compute_accelerations: step 2: closure Jacobian Phi_z and its factors (60),
/// upper_ball_left .. tie_rod_right; step 1: poses and axes b; step 7: inertias of the bodies and
/// forces on joints, upper_ball_left .. tie_rod_right; step 6: c and dRz/dt zd (62),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 3: Rz (61), long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_accelerations_3(const State& state, const double* tau,
    AccelerationsWork1& __restrict w1, AccelerationsWork2& __restrict w2,
    AccelerationsWork4& __restrict w4, AccelerationsWork6& __restrict w6) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right ---
  const double R_bell_crank_y_x = w6.sines[8];
  const double s2_123 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  const double R_bell_crank_x_x = w6.cosines[8];
  const double s2_124 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_123);
  w1.s2_125 = Pair{s2_124, fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_123)};
  const double s2_126 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_127 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_126);
  w1.s2_128 = Pair{s2_127, fms(-p_tie_rod_left_from_x, R_bell_crank_x_x, s2_126)};

  // --- step 1: poses and axes b, continued ---
  const Pair s1_8 = Pair{w6.sines[3], -w6.sines[5]};
  const Pair s1_9 = Pair{w6.sines[4], -w6.sines[6]};
  const Pair s1_10 = Pair{w6.cosines[4], w6.cosines[6]};
  w1.s1_11 = Pair{w6.cosines[3], w6.cosines[5]};
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left; and likewise carrier_right_aux1:
  // carrier_right_rz, revolute, lower_arm_right
  const Pair R_lower_arm_left_y_y = mbgen::pair_at(w6.cosines + 16);
  const Pair R_carrier_left_and_right_aux1_y_y = R_lower_arm_left_y_y*w1.s1_11;
  const Pair R_lower_arm_left_z_y = mbgen::pair_at(w6.sines + 16);
  const Pair s1_12 = fma(R_carrier_left_and_right_aux1_y_y, s1_9, R_lower_arm_left_z_y*s1_10);
  w1.R_carrier_left_and_right_aux1_y_x = R_lower_arm_left_y_y*s1_8;
  const Pair s1_13 = mbgen::pair_at(w6.sines + 18);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  const Pair s1_14 = mbgen::pair_at(w6.cosines + 18);
  const Pair R_carrier_left_and_right_y_z = fnma(s1_12, s1_14,
      w1.R_carrier_left_and_right_aux1_y_x*s1_13);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1; and likewise
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const Pair s1_15 = s1_10*R_carrier_left_and_right_aux1_y_y;
  w1.R_carrier_left_and_right_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_9, s1_15);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left; and likewise carrier_right_aux1:
  // carrier_right_rz, revolute, lower_arm_right
  const Pair R_carrier_left_and_right_aux1_z_y = R_lower_arm_left_z_y*w1.s1_11;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1; and likewise
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const Pair s1_16 = R_lower_arm_left_y_y*s1_10;
  const Pair R_carrier_left_and_right_aux2_z_z = fnma(s1_9, R_carrier_left_and_right_aux1_z_y,
      s1_16);
  w1.R_carrier_left_and_right_aux2_z_y = fma(s1_10, R_carrier_left_and_right_aux1_z_y,
      R_lower_arm_left_y_y*s1_9);
  const Pair R_carrier_left_and_right_aux2_x_z = s1_8*s1_9;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left; and likewise carrier_right_aux1:
  // carrier_right_rz, revolute, lower_arm_right
  w1.R_carrier_left_and_right_aux1_z_x = s1_8*R_lower_arm_left_z_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  const Pair s1_17 = s1_14*w1.R_carrier_left_and_right_aux1_z_x;
  w1.R_carrier_left_and_right_z_x = fnma(s1_13, R_carrier_left_and_right_aux2_z_z, s1_17);
  const Pair R_carrier_left_and_right_y_x = fma(w1.R_carrier_left_and_right_aux1_y_x, s1_14,
      s1_13*s1_12);

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  const Pair s7_28 = K_carrier_left_yz*R_carrier_left_and_right_y_z;
  const Pair s7_29 = fma(K_carrier_left_yy, w1.R_carrier_left_and_right_aux2_y_y, s7_28);
  const Pair s7_30 = fma(K_carrier_left_xy, R_carrier_left_and_right_y_x, s7_29);
  const Pair s7_31 = K_carrier_left_xy*w1.R_carrier_left_and_right_aux2_y_y;
  const Pair s7_32 = fma(K_carrier_left_xz, R_carrier_left_and_right_y_z, s7_31);
  const Pair s7_33 = fma(K_carrier_left_xx, R_carrier_left_and_right_y_x, s7_32);
  const Pair s7_34 = w1.R_carrier_left_and_right_aux2_y_y*s7_30;
  const Pair s7_35 = w1.R_carrier_left_and_right_aux2_z_y*s7_30;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  const Pair s1_18 = s1_13*w1.R_carrier_left_and_right_aux1_z_x;
  w1.R_carrier_left_and_right_z_z = fma(s1_14, R_carrier_left_and_right_aux2_z_z, s1_18);
  const Pair s7_36 = K_carrier_left_zz*R_carrier_left_and_right_y_z;
  const Pair s7_37 = fma(K_carrier_left_yz, w1.R_carrier_left_and_right_aux2_y_y, s7_36);
  const Pair s7_38 = fma(K_carrier_left_xz, R_carrier_left_and_right_y_x, s7_37);
  const Pair s7_39 = fma(R_carrier_left_and_right_y_x, s7_33, s7_34);
  w1.s7_40 = fma(R_carrier_left_and_right_y_z, s7_38, s7_39);
  const Pair s7_41 = fma(w1.R_carrier_left_and_right_z_x, s7_33, s7_35);
  w1.s7_42 = fma(w1.R_carrier_left_and_right_z_z, s7_38, s7_41);

  // --- step 1: poses and axes b, continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  const Pair R_carrier_left_and_right_x_z = fma(s1_14, R_carrier_left_and_right_aux2_x_z,
      s1_13*w1.s1_11);
  const Pair R_carrier_left_and_right_x_x = fnma(s1_13, R_carrier_left_and_right_aux2_x_z,
      w1.s1_11*s1_14);
  w1.s1_19 = s1_8*s1_10;
  const Pair s1_20 = 1.0/s1_10;
  w1.s1_21 = R_carrier_left_and_right_aux2_x_z*s1_20;
  w1.s1_22 = s1_8*s1_20;
  w1.s1_23 = R_carrier_left_and_right_aux1_y_y*s1_20;
  w1.s1_24 = s1_12*s1_20;
  w1.s1_25 = R_carrier_left_and_right_aux1_z_y*s1_20;
  w1.s1_26 = R_carrier_left_and_right_aux2_z_z*s1_20;

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  const Pair s7_43 = K_carrier_left_yz*R_carrier_left_and_right_x_z;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  const Pair s7_44 = fnma(K_carrier_left_yy, w1.s1_19, s7_43);
  const Pair s7_45 = fma(K_carrier_left_xy, R_carrier_left_and_right_x_x, s7_44);
  const Pair s7_46 = K_carrier_left_xx*R_carrier_left_and_right_x_x;
  const Pair s7_47 = fnma(K_carrier_left_xy, w1.s1_19, s7_46);
  const Pair s7_48 = fma(K_carrier_left_xz, R_carrier_left_and_right_x_z, s7_47);
  const Pair s7_49 = w1.R_carrier_left_and_right_aux2_y_y*s7_45;
  const Pair s7_50 = w1.R_carrier_left_and_right_aux2_z_y*s7_45;
  const Pair s7_51 = K_carrier_left_zz*R_carrier_left_and_right_x_z;
  const Pair s7_52 = fnma(K_carrier_left_yz, w1.s1_19, s7_51);
  const Pair s7_53 = fma(K_carrier_left_xz, R_carrier_left_and_right_x_x, s7_52);
  const Pair s7_54 = fma(R_carrier_left_and_right_y_x, s7_48, s7_49);
  w1.s7_55 = fma(R_carrier_left_and_right_y_z, s7_53, s7_54);
  const Pair s7_56 = fnma(w1.s1_19, s7_45, R_carrier_left_and_right_x_x*s7_48);
  w1.s7_57 = fma(R_carrier_left_and_right_x_z, s7_53, s7_56);
  const Pair s7_58 = fma(w1.R_carrier_left_and_right_z_x, s7_48, s7_50);
  w1.s7_59 = fma(w1.R_carrier_left_and_right_z_z, s7_53, s7_58);

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  const Pair s2_129 = -p_carrier_left_upper_ball_y*w1.R_carrier_left_and_right_aux2_z_y;
  w1.pivot_carrier_left_and_right_rx = fms(p_carrier_left_upper_ball_z,
      w1.R_carrier_left_and_right_z_z, s2_129);
  const Pair s2_130 = fms(p_tie_rod_left_to_z, w1.R_carrier_left_and_right_z_z, s2_129);
  w1.s2_131 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_and_right_z_x, s2_130);
  const Pair s2_132 = -p_carrier_left_upper_ball_y*w1.R_carrier_left_and_right_aux2_y_y;
  const Pair s2_133 = fms(p_carrier_left_upper_ball_z, R_carrier_left_and_right_y_z, s2_132);
  const Pair s2_134 = fms(p_tie_rod_left_to_z, R_carrier_left_and_right_y_z, s2_132);
  w1.s2_135 = fma(p_tie_rod_left_to_x, R_carrier_left_and_right_y_x, s2_134);
  const Pair s2_136 = -p_carrier_left_upper_ball_y*w1.s1_19;
  const Pair s2_137 = fma(p_carrier_left_upper_ball_z, R_carrier_left_and_right_x_z, s2_136);
  const Pair s2_138 = fma(p_tie_rod_left_to_z, R_carrier_left_and_right_x_z, s2_136);
  w1.s2_139 = fma(p_tie_rod_left_to_x, R_carrier_left_and_right_x_x, s2_138);
  const double s0_13 = -state.zd[Coordinate::lower_arm_right];
  w1.s0_14 = Pair{state.zd[Coordinate::lower_arm_left], s0_13};
  const double s0_15 = -state.zd[Coordinate::carrier_right_rx];
  const Pair s0_16 = Pair{state.zd[Coordinate::carrier_left_rx], s0_15};
  const double s0_17 = -state.zd[Coordinate::carrier_right_rz];
  const Pair s0_18 = Pair{state.zd[Coordinate::carrier_left_rz], s0_17};
  w1.s4_18 = w1.s1_11*s0_16;
  const Pair s0_19 = Pair{state.zd[Coordinate::carrier_left_ry],
      state.zd[Coordinate::carrier_right_ry]};
  w1.s4_19 = w1.s1_19*s0_19;
  w1.s4_20 = w1.s0_14 + w1.s4_18;
  w1.s4_21 = w1.s4_20 - w1.s4_19;
  w1.s4_22 = w1.R_carrier_left_and_right_aux2_y_y*s0_19;
  w1.s4_23 = w1.R_carrier_left_and_right_aux2_z_y*s0_19;
  w1.s4_24 = w1.R_carrier_left_and_right_aux1_y_x*s0_16;
  w1.s4_25 = w1.R_carrier_left_and_right_aux1_z_x*s0_16;
  w1.s4_26 = R_lower_arm_left_z_y*s0_18;
  w1.s4_27 = R_lower_arm_left_y_y*s0_18;
  w1.s4_28 = w1.s4_24 - w1.s4_26;
  w1.s4_29 = w1.s4_22 + w1.s4_28;

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  const Pair s6_66 = fnma(w1.s2_139, w1.s4_29, w1.s2_135*w1.s4_21);
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const Pair s0_20 = Pair{zd_bell_crank, -zd_bell_crank};
  w1.s4_30 = w1.s4_27 + w1.s4_25;
  w1.s4_31 = w1.s4_23 + w1.s4_30;
  // tie_rod_left; and likewise tie_rod_right
  const Pair s6_67 = fnma(w1.s2_135, w1.s4_31, w1.s2_131*w1.s4_29);
  const Pair s6_68 = fnma(w1.s2_131, w1.s4_21, w1.s2_139*w1.s4_31);
  const Pair s6_69 = w1.s2_125*s0_20;
  w1.s6_70 = s6_69 + s6_67;
  const Pair s6_71 = w1.s2_128*s0_20;
  w1.s6_72 = fma(w1.s4_31, s6_68, fnma(w1.s4_29, s6_66, s0_20*s6_71));
  const Pair s1_27 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  w1.s1_28 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_27);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left; and likewise carrier_right_aux1:
  // carrier_right_rz, revolute, lower_arm_right
  w1.r_carrier_left_aux1_z = w1.s1_28 + p_lower_arm_left_z;
  w1.s2_140 = w1.s2_131 + (w1.r_carrier_left_aux1_z - p_bell_crank_z);
  const Pair s1_29 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  w1.s1_30 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_29);
  w2.r_carrier_left_and_right_aux1_y = p_lower_arm_left_y + w1.s1_30;
  w2.s2_141 = w1.s2_125 - w1.s2_135 - w2.r_carrier_left_and_right_aux1_y;
  w2.s2_142 = w1.s2_128 + (0.35 + w1.s2_139);
  const Pair s2_143 = 1.0/w1.pivot_carrier_left_and_right_rx;
  const Pair s2_144 = s2_143*fnma(w1.s2_131, w2.s2_142, w1.s2_140*w1.s2_139);
  w2.s2_145 = fma(s2_133, s2_144, fma(w1.s2_135, w2.s2_142, w2.s2_141*w1.s2_139));
  w2.s4_32 = w1.s1_30*w1.s0_14;
  w2.s6_73 = w2.s4_32 + s6_66;
  w2.s4_33 = w1.s1_28*w1.s0_14;
  w2.s6_74 = s6_71 + s6_68 - w2.s4_33;
  const Pair s6_75 = w1.s0_14*w1.s0_14;
  w2.s6_76 = w1.s1_28*s6_75;
  w2.s6_77 = fnma(w1.s4_29, s6_67, w1.s4_21*s6_68) - w2.s6_76;
  w2.s6_78 = w1.s1_30*s6_75;
  w2.s6_79 = fma(w1.s4_31, s6_67, fnma(w1.s4_21, s6_66, s0_20*s6_69)) - w2.s6_78;
  const Pair s6_80 = fnma(s2_137, w1.s4_29, s2_133*w1.s4_21);
  const Pair s6_81 = fnma(w1.pivot_carrier_left_and_right_rx, w1.s4_21, s2_137*w1.s4_31);
  const Pair s6_82 = fnma(w1.s4_31, s6_81, w1.s4_29*s6_80);
  const Pair s6_83 = fma(w2.s6_74, w2.s6_74, fma(w1.s6_70, w1.s6_70, w2.s6_73*w2.s6_73));
  const Pair s6_84 = fnma(w2.s2_142, w1.s6_72, fma(w1.s2_140, w2.s6_77, s6_83));
  const Pair s6_85 = fma(s2_144, s6_82, fnma(w2.s2_141, w2.s6_79, s6_84));
  w2.s2_146 = 1.0/w2.s2_145;
  w2.s2_147 = s2_137*w2.s2_146;
  const Pair s2_148 = s2_143*s2_137;
  w2.s2_149 = w2.s2_146*(s2_133*s2_148);
  const Pair s6_86 = fnma(s2_148, s6_82, fnma(w1.s4_21, s6_81, w2.s6_76));
  const Pair R_upper_arm_left_z_y = mbgen::pair_at(w6.sines + 14);
  const Pair R_upper_arm_left_y_y = mbgen::pair_at(w6.cosines + 14);
  const Pair s2_150 = -p_upper_arm_left_ball_z*R_upper_arm_left_z_y;
  const Pair s2_151 = fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s2_150);
  const Pair s2_152 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  w2.s2_153 = fma(p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s2_152);
  const double s0_21 = -state.zd[Coordinate::upper_arm_right];
  w2.s0_22 = Pair{state.zd[Coordinate::upper_arm_left], s0_21};
  const Pair s6_87 = fnma(s2_133, w1.s4_31, w1.pivot_carrier_left_and_right_rx*w1.s4_29);
  const Pair s6_88 = w2.s0_22*w2.s0_22;
  const Pair s6_89 = fnma(w1.s4_21, s6_80, fms(w2.s2_147, s6_85, w2.s6_78));
  const Pair s6_90 = fma(w1.s4_31, s6_87, fma(s2_151, s6_88, s6_89));
  const Pair s6_91 = fnma(w2.s2_153, s6_88, fma(w2.s2_149, s6_85, s6_86));
  w2.s2_154 = s2_133*s2_143;
  w2.s2_155 = fms(w2.s2_153, w2.s2_154, s2_151);
  w2.s2_156 = fma(w1.s2_131, w2.s2_141, w1.s2_140*w1.s2_135);
  w2.s2_157 = 1.0/w2.s2_155;
  w2.s6_92 = w2.s2_157*fnma(w2.s2_154, s6_90, fma(w1.s4_29, s6_87, s6_91));
  w2.pivot_carrier_left_and_right_rz = fms(w2.s2_156, w2.s2_147,
      w1.pivot_carrier_left_and_right_rx);
  w2.s2_158 = 1.0/w2.pivot_carrier_left_and_right_rz;
  w2.s6_93 = w2.s2_158*fma(w2.s2_153, w2.s6_92, s6_90);
  w2.zdd_star_carrier_left_and_right_ry = w2.s2_146*fnma(w2.s2_156, w2.s6_93, s6_85);
  w2.zdd_star_carrier_left_and_right_rx = s2_143*fms(s2_133, w2.zdd_star_carrier_left_and_right_ry,
      s6_82);
  w2.s2_159 = s2_133 + w1.s1_30;
  const Pair s4_34 = Pair{w4.w_chassis_x, -w4.w_chassis_x};
  const Pair s4_35 = Pair{w4.w_chassis_z, -w4.w_chassis_z};
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  w2.w_carrier_left_and_right_z = w1.s4_31 + s4_35;
  const Pair w_carrier_left_and_right_x = w1.s4_21 + s4_34;
  const Pair s8_72 = w1.R_carrier_left_and_right_aux2_z_y*w2.w_carrier_left_and_right_z;
  const Pair s0_23 = Pair{state.zd[Coordinate::wheel_front_left],
      state.zd[Coordinate::wheel_front_right]};
  w2.s8_73 = Pair{-w4.s8_38, w4.s8_38};
  w2.s8_74 = Pair{-w4.s8_36, w4.s8_36};

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  const double s8_75 = p_upper_arm_right_x*w4.s8_19;
  w2.s8_76 = Pair{w4.s8_46, w4.s8_46};
  const Pair s8_77 = fma(w1.s2_86, w1.s6_52, fma(w1.s6_29, w2.s8_74, w1.s6_38));
  w2.s8_78 = fma(w1.s2_88, w2.s8_76, s8_77);
  const Pair s8_79 = fnma(w1.s2_44, w2.s8_76, fma(w1.s2_27, w2.s8_73, w1.s8_6));
  w2.s8_80 = fma(w1.s6_18, w2.s8_74, s8_79);
  const Pair s8_81 = w2.s8_76*w1.r_carrier_left_aux1_z;
  w2.s8_82 = Pair{w4.s8_44, w4.s8_44};
  const Pair s8_83 = fnma(w2.s8_73, w2.r_carrier_left_and_right_aux1_y, s8_81);
  const Pair s8_84 = fnma(w2.s8_74, w2.s4_33, fma(w2.s8_82, w2.s4_32, s8_83));
  w2.s8_85 = s8_84 - Pair{s8_75, s8_75};
  w2.s8_86 = Pair{-w4.s8_40, w4.s8_40};
  w2.s8_87 = Pair{-w4.s8_35, w4.s8_35};
  const Pair s8_88 = fnma(w1.s2_26, w2.s8_73, fnma(w1.s2_44, w2.s8_86, w1.s8_7));
  const Pair s8_89 = fnma(w1.s2_26, w2.s8_76, fma(w1.s2_27, w2.s8_86, w1.s8_4));
  w2.s8_90 = fnma(w2.s8_87, w2.s0_22, s6_88);
  w2.s8_91 = fnma(w2.s8_87, w1.s0_14, s6_75);

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  w2.s8_92 = Pair{w4.s8_18, w4.s8_18};
  const Pair s8_93 = fma(w1.s6_20, w2.s8_82, fnma(w1.s6_18, w2.s8_87, s8_89));
  const Pair s8_94 = fma(w1.s6_7, w2.s8_82, fnma(w1.s2_7, w2.s8_76, w1.s8_5));
  const Pair s8_95 = fma(w1.s6_33, w2.s8_82, fma(w1.s2_78, w2.s8_76, w1.s8_3));
  w2.s8_96 = 3.0*fma(w1.s2_44, w2.s8_92, s8_93);
  const Pair s8_97 = fma(w1.s6_5, w2.s8_87, fma(w1.s2_40, w2.s8_92, s8_94));
  const Pair s8_98 = fma(w1.s6_29, w2.s8_87, fma(w1.s2_88, w2.s8_92, s8_95));
  w2.s8_99 = 2.6666666666666665*fnma(w1.s2_13, w2.s8_86, s8_97);
  w2.s8_100 = 0.3333333333333333*fnma(w1.s2_76, w2.s8_86, s8_98);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const Pair s8_101 = fnma(w2.s8_92, w1.r_carrier_left_aux1_z, w2.s8_87*w2.s4_33);
  w4.s8_102 = p_upper_arm_right_x*w4.s8_46;
  const Pair s8_103 = fnma(w2.s8_86, w2.r_carrier_left_and_right_aux1_y, s8_101) - w2.s6_76;
  w2.s8_104 = Pair{w4.s8_102, w4.s8_102} + s8_103;
  w2.s8_105 = fnma(w1.s4_29, s4_34, w1.s4_21*w1.s4_17);
  w2.s8_106 = fms(w1.s4_21, s4_35, w1.s4_31*s4_34);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  const Pair w_carrier_left_and_right_y = w1.s4_29 + w1.s4_17;
  w2.s8_107 = fnma(w1.s4_29, s4_35, w1.s4_31*w1.s4_17);
  const Pair s8_108 = s0_23 + fnma(w1.s1_19, w_carrier_left_and_right_x, s8_72);
  const Pair s8_109 = fma(w1.R_carrier_left_and_right_aux2_y_y, w_carrier_left_and_right_y, s8_108);
  const Pair s8_110 = I_wheel_front_right_polar*s8_109;
  const Pair s8_111 = w1.s1_19*w2.w_carrier_left_and_right_z;
  const Pair s0_24 = Pair{tau[Coordinate::wheel_front_left], tau[Coordinate::wheel_front_right]};
  const Pair s8_112 = fma(w1.R_carrier_left_and_right_aux2_z_y, w_carrier_left_and_right_x, s8_111);
  w2.s8_113 = fnma(s8_112, s8_110, w1.R_carrier_left_and_right_aux2_y_y*s0_24);
  w4.s8_114 = p_upper_arm_right_x*w4.s8_38;

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  w2.s8_115 = Pair{w4.s8_20, w4.s8_20};
  const Pair s8_116 = fnma(w1.s6_20, w2.s8_74, fma(w1.s6_22, w2.s8_87, s8_88));
  w2.s8_117 = 3.0*fnma(w1.s2_27, w2.s8_115, s8_116);
  const Pair s8_118 = fnma(w1.s6_9, w2.s8_87, fnma(w1.s2_13, w2.s8_115, w1.s8_1));
  const Pair s8_119 = fnma(w1.s6_36, w2.s8_87, fnma(w1.s2_76, w2.s8_115, w1.s8_2));
  const Pair s8_120 = fma(w1.s2_3, w1.s6_57, fma(w1.s6_7, w2.s8_74, s8_118)) - w1.s6_63;
  const Pair s8_121 = fma(w1.s2_75, w1.s6_57, fma(w1.s6_33, w2.s8_74, s8_119)) - w1.s6_63;
  const Pair s8_122 = fma(w1.s2_7, w2.s8_73, fma(w1.s2_40, w2.s8_86, s8_120));
  w2.s8_123 = 2.6666666666666665*s8_122;
  const Pair s8_124 = fnma(w1.s2_78, w2.s8_73, fma(w1.s2_88, w2.s8_86, s8_121));
  w2.s8_125 = 0.3333333333333333*s8_124;
  const Pair s8_126 = w2.s8_86*w1.r_carrier_left_aux1_z;
  const Pair s8_127 = fma(w2.s8_115, w2.r_carrier_left_and_right_aux1_y, s8_126);
  const Pair s8_128 = w2.s6_78 + fnma(w2.s8_87, w2.s4_32, s8_127);
  w2.s8_129 = Pair{-w4.s8_114, w4.s8_114} + s8_128;
  const Pair s7_60 = h_carrier_left_z*R_carrier_left_and_right_y_z;
  const Pair s7_61 = fma(h_carrier_left_y, w1.R_carrier_left_and_right_aux2_y_y, s7_60);
  w2.s7_62 = fma(h_carrier_left_x, R_carrier_left_and_right_y_x, s7_61);
  const Pair s2_160 = R_carrier_left_and_right_y_z - w1.R_carrier_left_and_right_aux2_y_y;
  const Pair s2_161 = p_arb_link_front_left_to_x*R_carrier_left_and_right_y_x;
  w2.s2_162 = fnma(p_arb_link_front_left_to_y, s2_160, s2_161);
  const Pair s8_130 = w1.R_carrier_left_and_right_aux2_y_y*w2.w_carrier_left_and_right_z;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const Pair s8_131 = w2.zdd_star_carrier_left_and_right_rx + w2.s8_106;
  w2.s8_132 = fms(w2.w_carrier_left_and_right_z, w_carrier_left_and_right_x, s8_131);
  w2.s8_133 = fma(w2.w_carrier_left_and_right_z, w_carrier_left_and_right_x, s8_131);
  const Pair s8_134 = w2.s6_93 - w2.s8_107;
  w2.s8_135 = fnma(w2.w_carrier_left_and_right_z, w_carrier_left_and_right_y, s8_134);
  w2.s8_136 = fma(w2.w_carrier_left_and_right_z, w_carrier_left_and_right_y, s8_134);
  const Pair s8_137 = fnma(w1.s7_55, w2.s8_132, fnma(w2.s7_62, w2.s8_104, w1.s1_19*s0_24));
  const Pair s8_138 = fnma(w1.R_carrier_left_and_right_aux2_z_y, w_carrier_left_and_right_y,
      s8_130);
  w2.s8_139 = fma(s8_110, s8_138, fma(w1.s7_40, w2.s8_135, s8_137));
  const Pair s7_63 = h_carrier_left_z*R_carrier_left_and_right_x_z;
  const Pair s7_64 = fnma(h_carrier_left_y, w1.s1_19, s7_63);
  w2.s7_65 = fma(h_carrier_left_x, R_carrier_left_and_right_x_x, s7_64);
  const Pair s2_163 = p_arb_link_front_left_to_x*R_carrier_left_and_right_x_x;
  const Pair s2_164 = w1.s1_19 + R_carrier_left_and_right_x_z;
  w2.s2_165 = fnma(p_arb_link_front_left_to_y, s2_164, s2_163);
  const Pair s8_140 = w2.s8_105 - w2.zdd_star_carrier_left_and_right_ry;
  w2.s8_141 = fma(w_carrier_left_and_right_x, w_carrier_left_and_right_y, s8_140);
  w2.s8_142 = fnma(w_carrier_left_and_right_x, w_carrier_left_and_right_y, s8_140);
  const Pair s8_143 = fnma(w1.R_carrier_left_and_right_aux2_z_y, s0_24, w2.s7_62*w2.s8_85);
  const Pair s8_144 = fma(w1.s7_42, w2.s8_133, fma(w1.s7_40, w2.s8_141, s8_143));
  const Pair s8_145 = fnma(w1.s7_59, w2.s8_136, fma(w2.s7_65, w2.s8_129, s8_144));
  w2.s8_146 = w_carrier_left_and_right_x*w_carrier_left_and_right_x;
  const Pair s8_147 = w1.R_carrier_left_and_right_aux2_y_y*w_carrier_left_and_right_x;
  w2.s8_148 = w_carrier_left_and_right_y*w_carrier_left_and_right_y;
  const Pair s8_149 = fma(w1.s1_19, w_carrier_left_and_right_y, s8_147);
  w2.s8_150 = fnma(s8_110, s8_149, fma(w1.s7_57, w2.s8_142, s8_145));

  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  w2.s3_1 = w1.s2_121*fnma(w1.s2_78, w1.s2_87, w1.s2_77*w1.s2_88);
  w4.s3_2 = w2.s3_1[1];
  w4.s3_3 = w2.s3_1[0];
  const Pair s3_4 = Pair{w4.s3_2, w4.s3_3};
  const Pair s3_5 = w1.s2_115*s3_4;
  w2.Rz_rear_axle_rz_0 = w1.s2_116*Pair{s3_5[1], s3_5[0]};
  const Pair s3_6 = fnma(w1.s2_98, w2.Rz_rear_axle_rz_0, w1.s2_111*w2.s3_1);
  w2.Rz_rear_axle_ry_1_and_0 = w1.s2_100*Pair{s3_6[1], s3_6[0]};
  w4.s3_7 = w2.Rz_rear_axle_ry_1_and_0[1];
  w4.s3_8 = w2.Rz_rear_axle_ry_1_and_0[0];
  w2.s3_9 = Pair{w4.s3_7, w4.s3_8};
  const Pair s3_10 = w1.s2_61*w2.s3_9;
  const Pair s8_151 = fma(w1.s2_71, w2.Rz_rear_axle_rz_0, w1.s2_77 - w2.s3_1);
  w2.s8_152 = fnma(w1.s2_75, w2.s3_9, s8_151);
  w4.s3_11 = w2.Rz_rear_axle_rz_0[1];
  w4.s3_12 = w2.Rz_rear_axle_rz_0[0];
  w2.s3_13 = Pair{w4.s3_11, w4.s3_12};
  const Pair s3_14 = fnma(w1.s2_46, w2.s3_13, w1.s2_50*s3_4) - Pair{s3_10[1], s3_10[0]};
  w2.Rz_rear_axle_rx_1_and_0 = w1.s2_62*s3_14;
  const Pair s3_15 = w1.s2_58*w2.Rz_rear_axle_ry_1_and_0;
  const Pair s3_16 = fnma(w1.s2_25, w2.Rz_rear_axle_rx_1_and_0, s3_15);
  const Pair s3_17 = fnma(w1.s2_43, w2.Rz_rear_axle_rz_0, w1.s2_48*w2.s3_1);
  w2.s3_18 = w1.s2_28*(s3_17 - Pair{s3_16[1], s3_16[0]});
  w2.s7_66 = Pair{w4.s7_22, w4.s7_22};
  const Pair s8_153 = w2.Rz_rear_axle_rx_1_and_0*w2.s7_66;
  w2.s7_67 = Pair{w4.s7_20, w4.s7_20};
  const Pair s8_154 = fma(w2.Rz_rear_axle_rz_0, w2.s7_67, m_rear_axle*w2.s3_18);
  w2.s8_155 = s8_154 - Pair{s8_153[1], s8_153[0]};
  const Pair s3_19 = fma(w1.s2_56, w2.Rz_rear_axle_ry_1_and_0, w1.s2_40*s3_4);
  const Pair s8_156 = fms(w1.s2_23, w2.s3_13, s3_4);
  w2.s8_157 = fnma(w1.s2_19, w2.Rz_rear_axle_ry_1_and_0, s8_156);
  const Pair s3_20 = fma(w1.s2_41, w2.s3_13, s3_19);
  w4.s3_21 = w2.s3_18[0];
  w4.s3_22 = w2.s3_18[1];
  w2.s3_23 = Pair{w4.s3_22, w4.s3_21};
  const Pair s3_24 = fnma(w1.s2_24, w2.Rz_rear_axle_rx_1_and_0, s3_20);
  w2.Rz_rear_axle_tx_1_and_0 = w1.s2_8*fma(w1.s2_13, w2.s3_23, s3_24);
  w2.s7_68 = Pair{-w4.s7_10, w4.s7_10};

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const Pair s8_158 = w2.Rz_rear_axle_ry_1_and_0*w2.s7_67;
  const Pair s8_159 = fma(m_rear_axle, w2.Rz_rear_axle_tx_1_and_0, s8_158);
  w2.s8_160 = fnma(w2.Rz_rear_axle_rx_1_and_0, w2.s7_68, s8_159);
  const Pair s8_161 = w2.Rz_rear_axle_tx_1_and_0*Pair{w2.s8_160[1], w2.s8_160[0]};
  w4.s8_162 = s8_161[1];
  const Pair s8_163 = w2.Rz_rear_axle_ry_1_and_0*w2.s7_66;
  const Pair s8_164 = fma(w2.Rz_rear_axle_rz_0, w2.s7_68, m_rear_axle*w2.s3_1);
  w2.s8_165 = Pair{s8_163[1], s8_163[0]} + s8_164;
  const Pair s8_166 = w2.s3_1*Pair{w2.s8_165[1], w2.s8_165[0]};
  w4.s8_167 = s8_166[0];
  const Pair s8_168 = w2.s3_1*w2.s7_66;
  w2.s8_169 = fma(w2.s7_67, w2.Rz_rear_axle_tx_1_and_0, Pair{s8_168[1], s8_168[0]});
}

/// Part 4 of compute_accelerations: step 7: inertias of the bodies and forces on joints,
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 7: inertias of the bodies and forces on joints; step
/// 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right; step 8:
/// elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right; step 3: Rz (61),
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_4(const State& state, const double* tau,
    AccelerationsWork1& __restrict w1, AccelerationsWork2& __restrict w2,
    AccelerationsWork3& __restrict w3, AccelerationsWork4& __restrict w4,
    AccelerationsWork6& __restrict w6) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right,
  // continued ---
  const Pair s7_69 = Pair{-w4.s7_6, w4.s7_6};
  const Pair s8_170 = w2.Rz_rear_axle_rx_1_and_0*s7_69;
  const Pair s7_70 = Pair{w4.s7_17, -w4.s7_17};

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const Pair s8_171 = fma(w2.Rz_rear_axle_rz_0, s7_70, Pair{s8_170[1], s8_170[0]});
  const double s8_172 = K_rear_axle_trace - w4.s7_8;
  const Pair s8_173 = fma(w2.Rz_rear_axle_ry_1_and_0, Pair{s8_172, s8_172}, w2.s8_169);
  w2.s8_174 = s8_173 - Pair{s8_171[1], s8_171[0]};
  const Pair s8_175 = w2.Rz_rear_axle_ry_1_and_0*Pair{w2.s8_174[1], w2.s8_174[0]};
  const Pair s7_71 = Pair{w4.s7_19, w4.s7_19};
  const Pair s8_176 = w2.Rz_rear_axle_rx_1_and_0*s7_71;
  const Pair s8_177 = w2.Rz_rear_axle_rz_0*s7_71;
  const Pair s8_178 = fms(w2.Rz_rear_axle_rz_0, w1.s7_27, Pair{s8_176[1], s8_176[0]});
  const Pair s8_179 = fma(w2.Rz_rear_axle_ry_1_and_0, s7_70, Pair{s8_178[1], s8_178[0]});
  const Pair s8_180 = w2.Rz_rear_axle_tx_1_and_0*w2.s7_68;
  w2.s8_181 = Pair{s8_179[1], s8_179[0]} + fma(w2.s3_18, w2.s7_67, w2.s3_1*w2.s7_68);
  const Pair s8_182 = w2.Rz_rear_axle_rz_0*Pair{w2.s8_181[1], w2.s8_181[0]};
  const Pair s8_183 = fma(w2.s3_18, w2.s7_66, Pair{s8_180[1], s8_180[0]});
  const double s8_184 = K_rear_axle_trace - w4.s7_26;
  const Pair s8_185 = w2.Rz_rear_axle_rx_1_and_0*Pair{s8_184, s8_184};
  const Pair s8_186 = fnma(w2.Rz_rear_axle_ry_1_and_0, s7_69, s8_185);
  w2.s8_187 = s8_186 - Pair{s8_177[1], s8_177[0]} - Pair{s8_183[1], s8_183[0]};
  const Pair s8_188 = w2.Rz_rear_axle_rx_1_and_0*Pair{w2.s8_187[1], w2.s8_187[0]};
  w4.s3_25 = w2.Rz_rear_axle_rx_1_and_0[1];
  w4.s3_26 = w2.Rz_rear_axle_rx_1_and_0[0];
  const Pair s3_27 = Pair{w4.s3_25, w4.s3_26};
  const Pair s8_189 = fma(w1.s2_23, s3_27, w1.s2_39*w2.s3_9);
  w2.s8_190 = w2.Rz_rear_axle_tx_1_and_0 + Pair{s8_189[1], s8_189[0]};
  w2.s8_191 = Pair{w2.s8_190[1], w2.s8_190[0]};
  const Pair s8_192 = fnma(w1.s2_6, s3_27, w1.s2_35*w2.s3_9);
  w2.s8_193 = w2.Rz_rear_axle_tx_1_and_0 + Pair{s8_192[1], s8_192[0]};
  const Pair s8_194 = w1.s2_35*w2.Rz_rear_axle_ry_1_and_0;
  const Pair s8_195 = fma(w1.s2_6, w2.Rz_rear_axle_rx_1_and_0, s8_194);
  w2.s8_196 = w2.Rz_rear_axle_tx_1_and_0 + s8_195;
  const Pair s8_197 = fma(w1.s2_6, w2.s3_13, w1.s2_3*w2.Rz_rear_axle_ry_1_and_0);
  w2.s8_198 = w2.s3_1 + Pair{s8_197[1], s8_197[0]};
  w2.s8_199 = fnma(w1.s2_3, w2.s3_9, fms(w1.s2_6, w2.Rz_rear_axle_rz_0, w2.s3_1));
  const Pair s8_200 = w2.s8_193*Pair{w2.s8_196[1], w2.s8_196[0]};
  const Pair s8_201 = fnma(w2.s8_198, Pair{w2.s8_199[1], w2.s8_199[0]}, s8_200);
  w2.s8_202 = fnma(w1.s2_39, w2.s3_13, w1.s2_19*w2.Rz_rear_axle_rx_1_and_0) - w2.s3_23;
  w2.s8_203 = w2.s3_23 + fnma(w1.s2_3, w2.Rz_rear_axle_rx_1_and_0, w1.s2_35*w2.s3_13);
  w2.s8_204 = fnma(w1.s2_35, w2.Rz_rear_axle_rz_0, w1.s2_3*s3_27) - w2.s3_18;
  w2.s8_205 = w2.s3_23 + fnma(w1.s2_75, w2.Rz_rear_axle_rx_1_and_0, w1.s2_86*w2.s3_13);
  const Pair s8_206 = fma(w1.s2_71, w2.s3_13, w1.s2_75*w2.Rz_rear_axle_ry_1_and_0);
  w2.s8_207 = fnma(w1.s2_86, w2.Rz_rear_axle_rz_0, w1.s2_75*s3_27) - w2.s3_18;
  w2.s8_208 = fnma(w1.s2_19, s3_27, fma(w1.s2_39, w2.Rz_rear_axle_rz_0, w2.s3_18));
  const Pair s8_209 = w1.s2_39*w2.Rz_rear_axle_ry_1_and_0;
  const Pair s8_210 = fnma(w1.s2_23, w2.Rz_rear_axle_rx_1_and_0, s8_209);
  w2.s8_211 = w2.Rz_rear_axle_tx_1_and_0 + s8_210;
  w2.s8_212 = fma(w1.s2_19, w2.s3_9, fma(w1.s2_23, w2.Rz_rear_axle_rz_0, w2.s3_1));
  const Pair s8_213 = fnma(w1.s2_71, s3_27, w1.s2_86*w2.s3_9);
  const Pair s8_214 = w1.s2_86*w2.Rz_rear_axle_ry_1_and_0;
  const Pair s8_215 = fma(w1.s2_71, w2.Rz_rear_axle_rx_1_and_0, s8_214);
  w2.s8_216 = w2.Rz_rear_axle_tx_1_and_0 + s8_215;
  const Pair s8_217 = Pair{w4.s8_19, w4.s8_19};
  const Pair s8_218 = fnma(w1.s2_35, w1.s6_52, fms(w1.s2_7, s8_217, w1.s6_4));
  const Pair s6_94 = Pair{w4.zdd_star_rear_axle_tx, w4.zdd_star_rear_axle_tx};
  w2.s8_219 = 3.0*(fnma(w1.s6_22, w2.s8_82, fma(w1.s2_26, s8_217, w2.s8_80)) - s6_94);
  const Pair s8_220 = fnma(w1.s6_9, w2.s8_82, fnma(w1.s2_40, w2.s8_76, s8_218)) - s6_94;
  const Pair s8_221 = s6_94 + fma(w1.s6_36, w2.s8_82, fma(w1.s2_78, s8_217, w2.s8_78));
  const Pair s8_222 = fnma(w1.s2_6, w1.s6_57, fnma(w1.s6_5, w2.s8_74, s8_220));
  const Pair s8_223 = fma(w1.s2_76, w2.s8_73, fma(w1.s2_71, w1.s6_57, s8_221));
  w2.s8_224 = 0.3333333333333333*s8_223;
  w2.s8_225 = 2.6666666666666665*fnma(w1.s2_13, w2.s8_73, s8_222);
  const Pair s8_226 = w2.Rz_rear_axle_tx_1_and_0 + Pair{s8_213[1], s8_213[0]};
  w2.s8_227 = w1.s2_87 + Pair{s8_226[1], s8_226[0]};
  w2.s8_228 = w2.s3_1 + Pair{s8_206[1], s8_206[0]};
  const Pair s8_229 = w2.s8_228*Pair{w2.s8_152[1], w2.s8_152[0]};
  const Pair s8_230 = fma(w2.s8_216, w2.s8_227, w2.s8_205*w2.s8_207);
  const Pair s8_231 = fma(w2.s8_211, w2.s8_191, w2.s8_208*w2.s8_202);
  const Pair s8_232 = fma(w2.s8_203, w2.s8_204, Pair{s8_201[1], s8_201[0]});
  const Pair s8_233 = fma(2.6666666666666665, s8_232, 3.0*fnma(w2.s8_212, w2.s8_157, s8_231));
  const Pair s8_234 = fma(0.3333333333333333, s8_230 - Pair{s8_229[1], s8_229[0]}, s8_233);
  w4.s8_235 = w2.s8_155[1];
  const double s8_236 = s8_175[1] + (w4.s8_167 + fnma(w4.s3_21, w4.s8_235, w4.s8_162));
  w4.s8_237 = s8_236 - s8_182[0] - s8_188[1] - s8_234[0] - s8_234[1];
  const Pair s8_238 = w2.Rz_rear_axle_tx_1_and_0*w2.s8_160;
  const Pair s8_239 = w2.Rz_rear_axle_rz_0*w2.s8_181;
  w2.s8_240 = Pair{s8_239[1], s8_239[0]};
  const double s1_31 = 1.0/w6.cosines[10];
  w4.s1_32 = w3.R_rear_axle_aux5_y_z*s1_31;
  w4.s1_33 = w3.R_rear_axle_aux5_x_z*s1_31;
  w4.s1_34 = w6.cosines[9]*s1_31;
  const double R_rear_axle_aux4_y_x = w6.sines[9];
  w4.s1_35 = R_rear_axle_aux4_y_x*s1_31;

  // --- step 7: inertias of the bodies and forces on joints ---
  const double s7_72 = tau[Coordinate::rear_axle_rx]*w4.s1_34;
  const double s7_73 = fnma(R_rear_axle_aux4_y_x, tau[Coordinate::rear_axle_ry], s7_72);
  const double s7_74 = fma(tau[Coordinate::rear_axle_rz], w4.s1_33, s7_73);
  const double tau_rear_axle_ty = tau[Coordinate::rear_axle_ty];
  const Pair s8_241 = w2.s3_18*Pair{tau_rear_axle_ty, -tau_rear_axle_ty};
  const double tau_rear_axle_tz = tau[Coordinate::rear_axle_tz];
  const Pair s8_242 = w2.s3_1*Pair{tau_rear_axle_tz, tau_rear_axle_tz};
  const double tau_rear_axle_tx = tau[Coordinate::rear_axle_tx];
  const Pair s0_25 = Pair{tau_rear_axle_tx, tau_rear_axle_tx};
  const Pair s8_243 = fms(w2.Rz_rear_axle_tx_1_and_0, s0_25, Pair{s8_241[1], s8_241[0]});
  const Pair s8_244 = s8_243 - Pair{s8_242[1], s8_242[0]};
  const Pair s8_245 = Pair{s8_244[1], s8_244[0]};
  const Pair s8_246 = fma(w2.Rz_rear_axle_rz_0, Pair{s7_74, -s7_74}, s8_245);
  w2.s8_247 = Pair{s8_246[1], s8_246[0]};
  const Pair R_arb_rear_left_x_z = mbgen::pair_at(w6.sines + 12);
  const Pair s7_75 = K_arb_rear_left_zz*R_arb_rear_left_x_z;
  const Pair R_arb_rear_left_x_x = mbgen::pair_at(w6.cosines + 12);
  const Pair s7_76 = K_arb_rear_left_xx*R_arb_rear_left_x_x;
  w2.s7_77 = fma(R_arb_rear_left_x_x, s7_76, R_arb_rear_left_x_z*s7_75);
  w2.s7_78 = fnma(R_arb_rear_left_x_z, s7_76, R_arb_rear_left_x_x*s7_75);
  const double s8_248 = fma(p_arb_rear_right_z, w4.s8_46, -p_arb_rear_right_x*w4.s8_19);
  const double s8_249 = fnma(p_arb_rear_right_y, w4.s8_38, s8_248);
  const double s8_250 = fma(p_arb_rear_right_x, w4.s8_46, -p_arb_rear_right_z*w4.s8_18);
  const double s8_251 = fnma(p_arb_rear_right_y, w4.s8_40, s8_250);
  w2.s7_79 = K_arb_rear_left_xy*R_arb_rear_left_x_z;
  w2.s7_80 = K_arb_rear_left_xy*R_arb_rear_left_x_x;
  w4.s8_252 = w4.s8_18 - w4.s8_19;
  const Pair s8_253 = Pair{w4.s8_252, w4.s8_252};
  w2.s7_81 = h_arb_rear_left_x*R_arb_rear_left_x_z;
  const Pair s8_254 = fma(w2.s7_78, s8_253, fma(w2.s7_79, w2.s8_73, w2.s7_80*w2.s8_86));
  const Pair s8_255 = Pair{s8_249, fma(p_arb_rear_right_y, w4.s8_38, s8_248)};
  w2.s7_82 = h_arb_rear_left_x*R_arb_rear_left_x_x;
  const Pair s8_256 = Pair{s8_251, fma(p_arb_rear_right_y, w4.s8_40, s8_250)};
  w2.s7_83 = 0.4225 - w2.s7_77;

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const Pair s8_257 = fnma(w2.s7_82, s8_256, fnma(w2.s7_81, s8_255, s8_254));
  const Pair s8_258 = fma(w2.s8_76, w2.s7_83 - w2.s7_77, s8_257);
  w2.s8_259 = Pair{s8_258[1], s8_258[0]};
  const Pair s8_260 = w2.Rz_rear_axle_rz_0*Pair{-w4.n_rear_axle_x, w4.n_rear_axle_x};
  w2.s8_261 = Pair{s8_260[1], s8_260[0]};
  const Pair s8_262 = w2.Rz_rear_axle_tx_1_and_0*Pair{w4.f_rear_axle_x, w4.f_rear_axle_x};
  const Pair s8_263 = Pair{w4.f_rear_axle_z, w4.f_rear_axle_z};
  const Pair s8_264 = fnma(w2.s3_1, s8_263, Pair{s8_262[1], s8_262[0]});
  const Pair s8_265 = fnma(w2.s3_18, Pair{w4.f_rear_axle_y, -w4.f_rear_axle_y}, s8_264);
  const Pair s8_266 = fma(w2.s3_1, w2.s8_165, fma(w2.s3_18, w2.s8_155, 0.4225));
  w2.s8_267 = Pair{s8_238[1], s8_238[0]} + s8_266;
  w2.s8_268 = Pair{s8_265[1], s8_265[0]};
  const Pair s8_269 = w2.s8_212*w2.s8_96;
  const Pair s8_270 = Pair{w2.s8_219[1], w2.s8_219[0]};
  const Pair s8_271 = fms(w2.s8_190, s8_270, Pair{s8_269[1], s8_269[0]});
  const Pair s8_272 = fma(w2.s8_208, w2.s8_117, Pair{s8_271[1], s8_271[0]});
  w2.s8_273 = Pair{s8_272[1], s8_272[0]};
  const Pair s8_274 = w2.s8_198*Pair{w2.s8_99[1], w2.s8_99[0]};
  w2.s8_275 = Pair{s8_274[1], s8_274[0]};
  const Pair s7_84 = h_carrier_left_z*w1.R_carrier_left_and_right_z_z;
  const Pair s7_85 = fma(h_carrier_left_y, w1.R_carrier_left_and_right_aux2_z_y, s7_84);
  w2.s7_86 = fma(h_carrier_left_x, w1.R_carrier_left_and_right_z_x, s7_85);
  const Pair s2_166 = w1.R_carrier_left_and_right_z_z - w1.R_carrier_left_and_right_aux2_z_y;
  const Pair s2_167 = p_arb_link_front_left_to_x*w1.R_carrier_left_and_right_z_x;
  w2.s2_168 = fnma(p_arb_link_front_left_to_y, s2_166, s2_167);
  const Pair s8_276 = fnma(w2.s7_65, w2.s8_104, fma(w2.s7_86, w2.s8_85, w2.s8_113));
  const Pair R_arb_front_left_x_z = mbgen::pair_at(w6.sines + 20);
  const Pair R_arb_front_left_x_x = mbgen::pair_at(w6.cosines + 20);
  const Pair s2_169 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  w2.s2_170 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s2_169);
  const Pair s6_95 = fnma(w2.s2_168, w1.s4_21, w2.s2_165*w1.s4_31);
  const Pair s6_96 = s6_95 - w2.s4_33;
  const Pair s6_97 = fnma(w2.s2_162, w1.s4_31, w2.s2_168*w1.s4_29);
  w2.s0_26 = Pair{state.zd[Coordinate::arb_front_left], state.zd[Coordinate::arb_front_right]};
  const Pair s6_98 = w2.s2_170*w2.s0_26;
  const Pair s6_99 = fnma(w2.s2_165, w1.s4_29, w2.s2_162*w1.s4_21);
  const Pair s6_100 = s6_99 + (w2.s4_32 + s6_98);
  const Pair s6_101 = fnma(w1.s4_21, s6_99, fms(w1.s4_31, s6_97, w2.s6_78));
  const Pair s6_102 = fma(w1.s4_29, s6_99, fnma(w1.s4_31, s6_95, w2.s0_26*s6_98));
  const Pair s2_171 = -p_arb_link_front_left_from_x*R_arb_front_left_x_z;
  w3.s2_172 = fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s2_171);
  const Pair s6_103 = w3.s2_172*w2.s0_26;
  const Pair s6_104 = s6_103 - s6_97;
  const Pair s6_105 = fma(w2.s0_26, s6_103, fms(w1.s4_21, s6_95, w2.s6_76));
  const Pair s6_106 = fnma(w1.s4_29, s6_97, s6_105);
  const Pair s7_87 = K_arb_front_left_zz*R_arb_front_left_x_z;
  const Pair s7_88 = fma(K_arb_front_left_xz, R_arb_front_left_x_x, s7_87);
  const Pair s7_89 = K_arb_front_left_xx*R_arb_front_left_x_x;
  const Pair s7_90 = fma(K_arb_front_left_xz, R_arb_front_left_x_z, s7_89);
  w3.s7_91 = fnma(R_arb_front_left_x_z, s7_90, R_arb_front_left_x_x*s7_88);
  w3.s7_92 = fma(R_arb_front_left_x_x, s7_90, R_arb_front_left_x_z*s7_88);
  const double s8_277 = fma(p_arb_front_right_x, w4.s8_19, -p_rear_axle_tx_z*w4.s8_46);
  const double s8_278 = fnma(p_arb_front_right_y, w4.s8_38, s8_277);
  const double s8_279 = fnma(p_rear_axle_tx_z, w4.s8_18, p_arb_front_right_x*w4.s8_46);
  const double s8_280 = fnma(p_arb_front_right_y, w4.s8_40, s8_279);

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  w3.s2_173 = 0.35 + w2.s2_170 - w2.s2_165;
  w3.s2_174 = w3.s2_172 + p_arb_front_left_z - w1.r_carrier_left_aux1_z - w2.s2_168;
  w3.pivot_arb_front_left_and_right = fnma(w2.s2_170, w3.s2_174, w3.s2_172*w3.s2_173);
  w3.s2_175 = 0.72 - w2.r_carrier_left_and_right_aux1_y - w2.s2_162;
  w3.s2_176 = fnma(w2.s2_168, w3.s2_175, w3.s2_174*w2.s2_162);
  w3.s2_177 = fnma(w3.s2_173, w2.s2_162, w2.s2_165*w3.s2_175);
  w3.s2_178 = fnma(w2.s2_165, w3.s2_174, w3.s2_173*w2.s2_168);
  const Pair s7_93 = K_arb_front_left_yz*R_arb_front_left_x_z;
  w3.s7_94 = fma(K_arb_front_left_xy, R_arb_front_left_x_x, s7_93);
  const Pair s7_95 = -K_arb_front_left_xy*R_arb_front_left_x_z;
  w3.s7_96 = fma(K_arb_front_left_yz, R_arb_front_left_x_x, s7_95);
  const Pair s6_107 = w3.s2_177*w2.zdd_star_carrier_left_and_right_ry;
  const Pair s6_108 = fnma(w3.s2_176, w2.s6_93, s6_107);
  const Pair s6_109 = fma(w3.s2_178, w2.zdd_star_carrier_left_and_right_rx, s6_108);
  const Pair s6_110 = fnma(s6_100, s6_100, fnma(s6_104, s6_104, fnma(s6_96, s6_96, s6_109)));
  const Pair s6_111 = fma(w3.s2_173, s6_102, fma(w3.s2_175, s6_101, s6_110));
  w3.s2_179 = 1.0/w3.pivot_arb_front_left_and_right;
  w3.zdd_star_arb_front_left_and_right = w3.s2_179*fma(w3.s2_174, s6_106, s6_111);
  const Pair s8_281 = fnma(w2.s8_73, w3.s7_96, w2.s8_86*w3.s7_94);
  const Pair s8_282 = fma(0.3477, w3.zdd_star_arb_front_left_and_right, s8_281);
  const Pair s7_97 = -h_arb_front_left_x*R_arb_front_left_x_z;
  w3.s7_98 = fma(h_arb_front_left_z, R_arb_front_left_x_x, s7_97);
  const Pair s8_283 = Pair{fma(p_arb_front_right_y, w4.s8_38, s8_277), s8_278};
  const Pair s7_99 = h_arb_front_left_z*R_arb_front_left_x_z;
  w3.s7_100 = fma(h_arb_front_left_x, R_arb_front_left_x_x, s7_99);
  const Pair s8_284 = Pair{s8_280, fma(p_arb_front_right_y, w4.s8_40, s8_279)};
  const Pair s8_285 = fnma(w3.s7_98, s8_283, fma(s8_253, w3.s7_91, s8_282));
  w3.s7_101 = 0.3477 - w3.s7_92;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  w3.s8_286 = fma(w2.s8_76, w3.s7_101 - w3.s7_92, fnma(w3.s7_100, s8_284, s8_285));
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  const Pair s8_287 = w2.s8_148 + w2.s8_146;
  const Pair s8_288 = fma(w2.w_carrier_left_and_right_z, w2.w_carrier_left_and_right_z, w2.s8_148);
  const Pair s8_289 = fma(w2.w_carrier_left_and_right_z, w2.w_carrier_left_and_right_z, w2.s8_146);
  const Pair s8_290 = fma(w2.s7_62, w2.s8_141, m_carrier_right*w2.s8_85);
  const Pair s8_291 = fnma(w2.s7_86, s8_287, m_carrier_right*w2.s8_104);
  w3.f_carrier_left_and_right_x = fma(w2.s7_86, w2.s8_133, fnma(w2.s7_65, s8_288, s8_290));
  const Pair s8_292 = fma(w2.s7_62, s8_289, m_carrier_right*w2.s8_129);
  w3.f_carrier_left_and_right_z = fnma(w2.s7_62, w2.s8_135, fma(w2.s7_65, w2.s8_132, s8_291));
  w3.f_carrier_left_and_right_y = fma(w2.s7_65, w2.s8_142, fnma(w2.s7_86, w2.s8_136, s8_292));
  w3.s8_293 = fnma(w1.s7_42, s8_289 - s8_287, fnma(w2.s7_86, w2.s8_129, w2.s8_139));
  w3.s8_294 = fma(w1.s7_59, s8_287 - s8_288, fma(w1.s7_42, w2.s8_141, s8_276));
  w3.n_carrier_left_and_right_z = fnma(w1.s7_55, s8_288 - s8_289, w2.s8_150);
  const Pair s8_295 = fnma(w2.s8_86, w3.s2_175, fnma(w2.s8_92, w3.s2_174, w2.s8_76*w3.s2_173));
  const Pair s8_296 = fma(w2.s2_162, w2.s6_93, s8_295);
  const Pair s8_297 = fma(w2.s2_165, w2.zdd_star_carrier_left_and_right_rx, s8_296);
  const Pair s8_298 = fnma(w2.s8_76, w2.s2_142, fnma(w2.s8_86, w2.s2_141, w2.s8_92*w1.s2_140));
  const Pair s8_299 = fnma(w2.s8_82, s6_104, fma(w2.s8_87, s6_96, s8_297)) - s6_106;
  const Pair s8_300 = fma(w2.s8_87, w2.s6_74, fma(w2.s8_82, w1.s6_70, s8_298)) - w2.s6_77;
  const Pair s8_301 = fnma(w2.s2_170, w3.zdd_star_arb_front_left_and_right, s8_299);
  w3.s8_302 = 0.3333333333333333*s8_301;
  const Pair s8_303 = fma(w1.s2_135, w2.s6_93, s8_300);
  const Pair s8_304 = fma(w1.s2_139, w2.zdd_star_carrier_left_and_right_rx, s8_303);
  w3.s8_305 = 1.1666666666666667*s8_304;
  const Pair s8_306 = fnma(w2.s8_73, w3.s2_175, fnma(s8_217, w3.s2_173, w2.s8_76*w3.s2_174));
  const Pair s8_307 = fma(w2.s2_162, w2.zdd_star_carrier_left_and_right_ry, s8_306);
  const Pair s8_308 = fnma(w2.s2_168, w2.zdd_star_carrier_left_and_right_rx, s8_307);
  const Pair s8_309 = fnma(w2.s8_82, s6_100, fnma(w2.s8_74, s6_96, s8_308)) - s6_102;
  const Pair s8_310 = fma(w3.s2_172, w3.zdd_star_arb_front_left_and_right, s8_309);
  w3.s8_311 = 0.3333333333333333*s8_310;
  const Pair s8_312 = fma(w2.s8_115, w3.s2_175, fma(w2.s8_86, w3.s2_174, w2.s8_73*w3.s2_173));
  const Pair s8_313 = fma(w2.s2_168, w2.s6_93, s8_312);
  const Pair s8_314 = fma(w2.s2_165, w2.zdd_star_carrier_left_and_right_ry, s8_313);
  const Pair s8_315 = s6_101 + fma(w2.s8_87, s6_100, fma(w2.s8_74, s6_104, s8_314));
  w3.s8_316 = 0.3333333333333333*s8_315;
  const Pair s8_317 = fms(s8_217, w2.s2_142, fma(w2.s8_76, w1.s2_140, w2.s8_73*w2.s2_141));
  const Pair s8_318 = w1.s6_72 + fnma(w2.s8_74, w2.s6_74, fnma(w2.s8_82, w2.s6_73, s8_317));
  const Pair s8_319 = fma(w1.s2_135, w2.zdd_star_carrier_left_and_right_ry, s8_318);
  const Pair s8_320 = fnma(w2.s8_115, w2.s2_141, fms(w2.s8_86, w1.s2_140, w2.s8_87*w2.s6_73));
  const Pair s8_321 = fnma(w1.s2_131, w2.zdd_star_carrier_left_and_right_rx, s8_319);
  w3.s8_322 = 1.1666666666666667*s8_321;
  const Pair s8_323 = fma(w2.s8_74, w1.s6_70, fma(w2.s8_73, w2.s2_142, s8_320)) - w2.s6_79;
  const Pair s8_324 = fnma(w1.s2_131, w2.s6_93, s8_323);
  const Pair s8_325 = fnma(w1.s2_139, w2.zdd_star_carrier_left_and_right_ry, s8_324);
  w3.s8_326 = 1.1666666666666667*s8_325;
  const Pair s2_180 = w2.s2_156 + fma(w1.s1_28, w2.s2_141, w1.s2_140*w1.s1_30);
  const Pair s2_181 = fms(w2.s2_147, s2_180, w1.pivot_carrier_left_and_right_rx) - w1.s1_28;

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  w3.s3_28 = w2.s2_157*fma(w2.s2_154, s2_181, fnma(w2.s2_149, s2_180, w2.s2_159));
  w3.s3_29 = w2.s2_158*fnma(w2.s2_153, w3.s3_28, s2_181);
  w3.s3_30 = w2.s2_146*fms(w2.s2_156, w3.s3_29, s2_180);
}

/// Part 5 of compute_accelerations: step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63); step
/// 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_5(const double* tau, AccelerationsWork1& __restrict w1,
    AccelerationsWork2& __restrict w2, AccelerationsWork3& __restrict w3,
    AccelerationsWork4& __restrict w4, AccelerationsWork6& __restrict w6) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  const Pair R_upper_arm_left_z_y = mbgen::pair_at(w6.sines + 14);
  const Pair R_upper_arm_left_y_y = mbgen::pair_at(w6.cosines + 14);
  const Pair s7_102 = K_upper_arm_left_zz*R_upper_arm_left_z_y;
  const Pair s7_103 = fnma(K_upper_arm_left_yz, R_upper_arm_left_y_y, s7_102);
  const Pair s7_104 = -K_upper_arm_left_yz*R_upper_arm_left_z_y;
  const Pair s7_105 = fma(K_upper_arm_left_yy, R_upper_arm_left_y_y, s7_104);
  w3.s7_106 = fma(R_upper_arm_left_y_y, s7_105, R_upper_arm_left_z_y*s7_103);
  w3.s7_107 = fnma(R_upper_arm_left_y_y, s7_103, R_upper_arm_left_z_y*s7_105);
  const Pair R_lower_arm_left_y_y = mbgen::pair_at(w6.cosines + 16);
  const Pair R_lower_arm_left_z_y = mbgen::pair_at(w6.sines + 16);
  const Pair s7_108 = -K_lower_arm_left_yz*R_lower_arm_left_y_y;
  const Pair s7_109 = fma(K_lower_arm_left_zz, R_lower_arm_left_z_y, s7_108);
  const Pair s7_110 = K_lower_arm_left_yy*R_lower_arm_left_y_y;
  const Pair s7_111 = fnma(K_lower_arm_left_yz, R_lower_arm_left_z_y, s7_110);
  w3.s7_112 = fma(R_lower_arm_left_y_y, s7_111, R_lower_arm_left_z_y*s7_109);
  w3.s7_113 = fnma(R_lower_arm_left_y_y, s7_109, R_lower_arm_left_z_y*s7_111);
  const double s8_327 = fma(p_upper_arm_right_z, w4.s8_40, w4.s8_114);
  const double s8_328 = fma(p_lower_arm_right_z, w4.s8_40, w4.s8_114);
  const double s8_329 = fms(p_pitman_arm_y, w4.s8_20, s8_327);
  const double s8_330 = fnma(p_upper_arm_right_z, w4.s8_18, w4.s8_102);
  const double s8_331 = fnma(p_lower_arm_right_z, w4.s8_18, w4.s8_102);
  const double s8_332 = fnma(p_rear_axle_tx_z, w4.s8_40, s8_330);
  w3.s7_114 = K_carrier_left_trace - w1.s7_57;
  const Pair s7_115 = w3.s7_114 - w1.s7_40;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2; and likewise carrier_right:
  // carrier_right_ry, revolute, carrier_right_aux2
  const Pair n_carrier_left_and_right_x = fnma(w1.s7_59, w2.s8_142, fma(s7_115, w2.s8_136,
      w3.s8_293));
  const Pair s8_333 = fnma(w1.s7_57, w2.s8_132, fma(s7_115, w2.s8_133, w3.s8_294));
  const Pair n_carrier_left_and_right_y = fma(w1.s7_55, w2.s8_135, s8_333);
  const double s8_334 = fms(-p_lower_arm_right_y, w4.s8_20, s8_328);
  const double s8_335 = fnma(p_pitman_arm_z, w4.s8_40, s8_331);
  const Pair s7_116 = h_upper_arm_left_y*R_upper_arm_left_z_y;
  w3.s7_117 = fma(h_upper_arm_left_z, R_upper_arm_left_y_y, s7_116);
  const Pair s0_27 = Pair{tau[Coordinate::upper_arm_left], -tau[Coordinate::upper_arm_right]};
  w4.s8_336 = w4.s8_20 - w4.s8_18;
  const Pair s8_337 = Pair{w4.s8_336, w4.s8_336};
  const Pair s8_338 = fnma(w3.s7_107, s8_337, fnma(0.539, w2.s6_92, s0_27));
  const Pair s8_339 = Pair{s8_329, fma(p_pitman_arm_y, w4.s8_20, s8_327)};
  const Pair s7_118 = -h_upper_arm_left_z*R_upper_arm_left_z_y;
  w3.s7_119 = fma(h_upper_arm_left_y, R_upper_arm_left_y_y, s7_118);
  const Pair s8_340 = Pair{s8_332, fma(p_rear_axle_tx_z, w4.s8_40, s8_330)};
  w3.s7_120 = 0.539 - w3.s7_106;
  const Pair s8_341 = fnma(w3.s7_119, s8_340, fnma(w3.s7_117, s8_339, s8_338));
  const double s0_28 = -tau[Coordinate::carrier_right_rx];
  const Pair s0_29 = Pair{tau[Coordinate::carrier_left_rx], s0_28};
  const double s0_30 = -tau[Coordinate::carrier_right_rz];
  const Pair s0_31 = Pair{tau[Coordinate::carrier_left_rz], s0_30};
  const Pair s0_32 = Pair{tau[Coordinate::carrier_left_ry], tau[Coordinate::carrier_right_ry]};
  const Pair s7_121 = fnma(s0_32, w1.s1_22, fma(s0_31, w1.s1_21, w1.s1_11*s0_29));
  const Pair s8_342 = fma(s0_32, w1.s1_25, w1.R_carrier_left_and_right_aux1_z_x*s0_29);
  const Pair s7_122 = fma(s0_32, w1.s1_23, w1.R_carrier_left_and_right_aux1_y_x*s0_29);
  w3.s8_343 = w3.n_carrier_left_and_right_z + fma(s0_31, w1.s1_26, s8_342);
  w3.s8_344 = n_carrier_left_and_right_y - fnma(s0_31, w1.s1_24, s7_122);
  const Pair s3_31 = w3.s2_176 + fnma(w1.s1_28, w3.s2_175, w1.s1_30*w3.s2_174);
  w3.s3_32 = w2.s2_154*w3.s3_30;
  const Pair s3_33 = fnma(w3.s2_177, w3.s3_30, fnma(w3.s2_176, w3.s3_29, s3_31));
  w3.Rz_arb_front_left_0_and_right_1 = w3.s2_179*fnma(w3.s2_178, w3.s3_32, s3_33);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  w3.s8_345 = 1.0 - w3.s3_29;
  w3.s8_346 = fma(w2.s2_168, w3.s8_345, fma(w2.s2_165, w3.s3_30, w1.s1_28));
  const Pair s8_347 = fnma(w2.s2_162, w3.s3_30, w2.s2_168*w3.s3_32);
  w3.s8_348 = fma(w3.s2_172, w3.Rz_arb_front_left_0_and_right_1, s8_347);
  const Pair s8_349 = fma(w2.s2_165, w3.s3_32, w1.s1_30);
  const Pair s8_350 = fma(w2.s2_170, w3.Rz_arb_front_left_0_and_right_1, s8_349);
  w3.s8_351 = fma(w2.s2_162, w3.s8_345, s8_350);
  w3.s8_352 = fma(w1.s2_131, w3.s8_345, fma(w1.s2_139, w3.s3_30, w1.s1_28));
  w3.s8_353 = fma(w1.s2_135, w3.s8_345, fma(w1.s2_139, w3.s3_32, w1.s1_30));
  w3.s8_354 = fnma(w1.s2_131, w3.s3_32, w1.s2_135*w3.s3_30);
  w3.s8_355 = s7_121 + n_carrier_left_and_right_x;
  const Pair s8_356 = fma(w3.s8_343, w3.s3_30, s7_121*w3.s3_29);
  const Pair s8_357 = fnma(n_carrier_left_and_right_x, w3.s8_345, s8_356);
  const Pair s8_358 = fnma(w3.s8_311, w3.s8_348, fma(w3.s8_316, w3.s8_346, s8_357));
  const Pair s8_359 = fnma(w3.s8_326, w3.s8_352, fma(w3.s8_302, w3.s8_351, s8_358));
  const Pair s0_33 = Pair{tau[Coordinate::lower_arm_left], -tau[Coordinate::lower_arm_right]};
  const Pair s8_360 = fma(w3.s8_322, w3.s8_354, fma(w3.s8_305, w3.s8_353, s8_359)) - s0_33;
  const Pair s8_361 = fma(w3.s7_113, s8_337, s8_360);
  const Pair s8_362 = fma(w1.s1_28, w3.f_carrier_left_and_right_y, s8_361);
  const Pair s7_123 = h_lower_arm_left_y*R_lower_arm_left_z_y;
  w3.s7_124 = fma(h_lower_arm_left_z, R_lower_arm_left_y_y, s7_123);
  const Pair s8_363 = Pair{s8_334, fnma(p_lower_arm_right_y, w4.s8_20, s8_328)};
  const Pair s8_364 = fma(w1.s1_30, w3.f_carrier_left_and_right_z, s8_362);
  const Pair s7_125 = h_lower_arm_left_y*R_lower_arm_left_y_y;
  w3.s7_126 = fnma(h_lower_arm_left_z, R_lower_arm_left_z_y, s7_125);
  const Pair s8_365 = Pair{s8_335, fma(p_pitman_arm_z, w4.s8_40, s8_331)};
  w3.s7_127 = 1.825625 - w3.s7_112;
  const Pair s8_366 = fma(w3.s7_126, s8_365, fma(w3.s7_124, s8_363, s8_364));
  const Pair s8_367 = fma(w2.s8_86, w3.s7_106 - w3.s7_120, s8_341);
  const Pair s8_368 = fma(w3.s3_28, s8_367, fma(w2.s8_86, w3.s7_127 - w3.s7_112, s8_366));
  w3.s8_369 = fnma(w3.s8_344, w3.s3_32, s8_368);

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const Pair s8_370 = w2.s8_228*Pair{w2.s8_100[1], w2.s8_100[0]};
  const Pair s8_371 = w2.s8_199*w2.s8_99;
  const Pair s8_372 = Pair{w2.s8_225[1], w2.s8_225[0]};
  const Pair s8_373 = fma(w2.s8_193, s8_372, Pair{s8_371[1], s8_371[0]});
  const Pair s8_374 = fma(w2.s8_204, w2.s8_123, Pair{s8_373[1], s8_373[0]});
  const Pair s8_375 = fnma(w2.s8_227, w2.s8_224, w2.s8_207*w2.s8_125);
  const Pair s8_376 = fma(w2.s8_152, w2.s8_100, s8_375);
  const double s7_128 = w6.cosines[9]*tau[Coordinate::rear_axle_ry];
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s7_129 = fma(tau[Coordinate::rear_axle_rx], w4.s1_35, s7_128);
  const double s7_130 = fma(tau_rear_axle_rz, w4.s1_32, s7_129);
  const Pair s0_34 = Pair{-tau_rear_axle_rz, tau_rear_axle_rz};
  const Pair s0_35 = Pair{tau[Coordinate::arb_rear_right], tau[Coordinate::arb_rear_left]};
  const Pair s8_377 = w2.s8_261 + (s0_35 + w2.s8_247 - w2.s8_259) - w2.s8_268;
  const Pair s8_378 = fnma(w2.s8_211, w2.s8_219, fnma(w2.s8_202, w2.s8_117, s8_377));
  const Pair s8_379 = fnma(w2.s8_157, w2.s8_96, s8_378) - w2.s8_273;
  const Pair s8_380 = fnma(w2.s8_196, w2.s8_225, fnma(w2.s8_203, w2.s8_123, s8_379));
  const Pair s8_381 = fnma(w2.s8_205, w2.s8_125, w2.s8_275 + s8_380);
  const Pair s8_382 = Pair{s8_370[1], s8_370[0]} + fma(w2.s8_216, w2.s8_224, s8_381);
  const Pair s8_383 = s8_382 - Pair{s8_374[1], s8_374[0]} - Pair{s8_376[1], s8_376[0]};
  const Pair s8_384 = Pair{s7_130, s7_130} - Pair{w4.n_rear_axle_y, w4.n_rear_axle_y};
  const Pair s8_385 = s0_34 + Pair{w4.n_rear_axle_z, -w4.n_rear_axle_z};
  const Pair s8_386 = fma(w2.Rz_rear_axle_ry_1_and_0, s8_384, s8_383);
  w3.s8_387 = fma(w2.Rz_rear_axle_rx_1_and_0, s8_385, s8_386);
  const Pair s8_388 = w2.Rz_rear_axle_ry_1_and_0*w2.s8_174;
  const Pair s8_389 = w2.s8_240 + fma(w2.Rz_rear_axle_rx_1_and_0, w2.s8_187, s8_388);
  const Pair s8_390 = w1.s0_8*w2.s8_160;
  const Pair s8_391 = w2.s8_181 + fnma(w1.s0_8, w2.s8_165, w1.s1_5*w2.s8_155);
  const Pair s8_392 = w2.s8_212*w2.s8_212;
  const Pair s8_393 = fma(w2.s8_190, w2.s8_190, Pair{s8_392[1], s8_392[0]});
  const Pair s8_394 = fma(w2.s8_208, w2.s8_208, Pair{s8_393[1], s8_393[0]});
  const Pair s8_395 = w2.s8_198*w2.s8_198;
  const Pair s8_396 = fma(w2.s8_196, w2.s8_196, w2.s8_203*w2.s8_203);
  const Pair s8_397 = 2.6666666666666665*(Pair{s8_395[1], s8_395[0]} + s8_396);
  const Pair s8_398 = fnma(3.0, s8_394, Pair{s8_389[1], s8_389[0]} + w2.s8_267);
  const Pair s8_399 = w2.s8_228*w2.s8_228;
  const Pair s8_400 = fma(w2.s8_216, w2.s8_216, w2.s8_205*w2.s8_205);
  const Pair s8_401 = 0.3333333333333333*(Pair{s8_399[1], s8_399[0]} + s8_400);
  const Pair s8_402 = fma(w2.s8_211, w2.s8_211, w2.s8_202*w2.s8_202);
  const Pair s8_403 = 3.0*fma(w2.s8_157, w2.s8_157, s8_402);
  const Pair s8_404 = s8_398 - Pair{s8_397[1], s8_397[0]} - Pair{s8_401[1], s8_401[0]};
  const Pair s8_405 = w2.s8_199*w2.s8_199;
  const Pair s8_406 = fma(w2.s8_193, w2.s8_193, Pair{s8_405[1], s8_405[0]});
  const Pair s8_407 = fma(w2.s8_204, w2.s8_204, Pair{s8_406[1], s8_406[0]});
  const Pair s8_408 = fms(w1.s1_4, w2.s8_155, Pair{s8_390[1], s8_390[0]});
  w4.s8_409 = w2.s8_155[0];
  const Pair s8_410 = w1.s1_4*w2.s8_165;
  w3.s8_411 = w2.s8_165 + w2.s7_82;
  const Pair s8_412 = w2.s8_187 - Pair{s8_408[1], s8_408[0]};
  const Pair s8_413 = 3.0*w1.s2_26;
  const Pair s8_414 = 3.0*w1.s2_27;
  const Pair s8_415 = fma(w2.s8_211, s8_414, w2.s8_202*s8_413);
  const Pair s8_416 = fnma(p_arb_rear_right_y, w2.s7_81, w2.s7_79);
  const Pair s8_417 = fma(w2.s8_208, s8_413, Pair{s8_412[1], s8_412[0]} + s8_416);
  const Pair s8_418 = 2.6666666666666665*w1.s2_7;
  const Pair s8_419 = fma(w2.s8_191, s8_414, s8_417) - Pair{s8_415[1], s8_415[0]};
  const Pair s8_420 = 2.6666666666666665*w1.s2_13;
  const Pair s8_421 = Pair{w2.s8_193[1], w2.s8_193[0]};
  const Pair s8_422 = fma(w2.s8_212, s8_414, fma(p_arb_rear_right_y, w2.s7_82, s8_391));
  const Pair s8_423 = 3.0*w1.s2_44;
  const Pair s8_424 = fma(w2.s8_202, s8_423, w2.s8_157*s8_414);
  const Pair s8_425 = fnma(w2.s8_211, s8_423, w2.s8_157*s8_413);
  const Pair s8_426 = Pair{w2.s8_198[1], w2.s8_198[0]};
  const Pair s8_427 = Pair{w2.s8_228[1], w2.s8_228[0]};
  const Pair s8_428 = 0.3333333333333333*w1.s2_76;
  const Pair s8_429 = fma(w2.s8_152, s8_428, fma(w2.s8_199, s8_420, s8_422)) - w2.s7_80;
  const Pair s8_430 = 2.6666666666666665*w1.s2_40;
  const Pair s8_431 = Pair{s8_424[1], s8_424[0]} + fnma(w2.s8_208, s8_423, s8_429);
  const Pair s8_432 = fma(w2.s8_196, s8_420, w2.s8_203*s8_418);
  const Pair s8_433 = fnma(s8_420, s8_426, w2.s8_203*s8_430);
  const Pair s8_434 = fma(s8_418, s8_426, w2.s8_196*s8_430);
  const Pair s8_435 = 0.3333333333333333*w1.s2_78;
  const Pair s8_436 = fnma(s8_420, s8_421, fnma(w2.s8_204, s8_418, s8_419));
  const Pair s8_437 = fnma(w1.s2_7, s8_418, fnma(w1.s2_26, s8_413, w1.s7_57));
  w3.s8_438 = fnma(w1.s2_78, s8_435, s8_437);
  const Pair s8_439 = fnma(w2.s8_216, s8_428, w2.s8_205*s8_435);
  const Pair s8_440 = 0.3333333333333333*w1.s2_88;
  const Pair s8_441 = fnma(s8_428, s8_427, w2.s8_205*s8_440);
  const Pair s8_442 = fnma(s8_435, s8_427, w2.s8_216*s8_440);
  const Pair s8_443 = fma(w2.s8_227, w2.s8_227, w2.s8_207*w2.s8_207);
  const Pair s8_444 = fnma(2.6666666666666665, s8_407, s8_404 - Pair{s8_403[1], s8_403[0]});
  w3.s8_445 = fnma(0.3333333333333333, fma(w2.s8_152, w2.s8_152, s8_443), s8_444);
  const Pair s8_446 = fnma(p_arb_rear_right_z, w2.s7_81, 0.4225);
  const Pair s8_447 = fnma(w2.s8_212, s8_413, fma(p_arb_rear_right_x, w2.s7_82, s8_446));
  const Pair s8_448 = fnma(w2.s8_152, s8_435, fma(w2.s8_199, s8_418, s8_447));
  w3.s8_449 = K_carrier_right_trace - w1.s7_40;
  const Pair s8_450 = fnma(w1.s2_13, s8_420, fnma(w1.s2_27, s8_414, w1.s7_40));
  w3.s8_451 = fnma(w1.s2_76, s8_428, s8_450);

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const Pair s8_452 = fma(w1.s2_88, s8_428, fnma(w1.s2_44, s8_414, w1.s2_40*s8_420));
  w3.s8_453 = w1.s7_42 + s8_452;
  const Pair s8_454 = fnma(w1.s2_7, w2.s8_123, fma(w1.s2_27, w2.s8_219, w1.s2_26*w2.s8_117));
  const Pair s8_455 = fma(w1.s2_78, w2.s8_125, fnma(w1.s2_13, w2.s8_225, s8_454));
  const Pair s8_456 = fma(w1.s2_40, w2.s8_225, fnma(w1.s2_26, w2.s8_96, w1.s2_44*w2.s8_219));
  const Pair s8_457 = fma(w1.s2_76, w2.s8_224, s8_455);
  const Pair s8_458 = fnma(w1.s2_27, w2.s8_96, fnma(w1.s2_44, w2.s8_117, w1.s2_40*w2.s8_123));
  const Pair s8_459 = fma(w3.s7_96, w3.zdd_star_arb_front_left_and_right, s8_457);
  const Pair s8_460 = fnma(w1.s2_88, w2.s8_224, fnma(w1.s2_7, w2.s8_99, s8_456));
  const Pair s8_461 = fma(w1.s2_88, w2.s8_125, fma(w1.s2_13, w2.s8_99, s8_458));
  const Pair s8_462 = fma(w1.s2_78, w2.s8_100, s8_460);
  const Pair s8_463 = fnma(w3.s2_175, w3.s8_311, w3.n_carrier_left_and_right_z + s8_459);
  const Pair s8_464 = fma(w1.s2_76, w2.s8_100, s8_461);
  const Pair s8_465 = fma(0.3477, w3.zdd_star_arb_front_left_and_right, s8_462);
  const Pair s8_466 = fnma(w1.s2_76, s8_435, fnma(w1.s2_27, s8_413, w1.s2_13*s8_418));
  w3.s8_467 = w1.s7_55 + s8_466;
  const Pair s8_468 = fma(w3.s7_94, w3.zdd_star_arb_front_left_and_right, s8_464);
  const double s2_182 = mbgen::min(1.2494533266510743*std::abs(w1.s2_7[1]), w3.s2_29);
  const Pair s8_469 = fnma(w2.s2_141, w3.s8_322, fnma(w3.s2_173, w3.s8_316, s8_463));
  w3.s8_470 = fnma(w2.s2_142, w3.s8_326, s8_469);
  const Pair s8_471 = fma(w3.s2_173, w3.s8_302, n_carrier_left_and_right_y + s8_465);
  const Pair s8_472 = fma(w3.s2_175, w3.s8_302, n_carrier_left_and_right_x + s8_468);
  const double s2_183 = mbgen::min(mbgen::min(s2_182, w3.s2_65), w3.s2_102);
  w3.s8_473 = K_carrier_right_trace - s7_115;
  const Pair s8_474 = fnma(w1.s2_40, s8_418, fnma(w1.s2_44, s8_413, w1.s2_88*s8_435));
  w3.s8_475 = w1.s7_59 + s8_474;
  w4.s2_184 = mbgen::min(mbgen::min(s2_183, w3.s2_119), w3.s2_122);
  const Pair s8_476 = fnma(w2.s2_142, w3.s8_305, fnma(w3.s2_174, w3.s8_311, s8_471));
  w3.s8_477 = fma(w1.s2_140, w3.s8_322, s8_476);
  const Pair s8_478 = fnma(w1.s2_40, s8_430, fnma(w1.s2_44, s8_423, s7_115));
  w3.s8_479 = fnma(w1.s2_88, s8_440, s8_478);
  const Pair s8_480 = fma(w2.s2_141, w3.s8_305, fma(w3.s2_174, w3.s8_316, s8_472));
  const Pair s8_481 = fnma(0.539, w2.s6_92, fma(w1.s2_140, w3.s8_326, s8_480));
  const Pair s8_482 = fnma(w1.r_carrier_left_aux1_z, w3.f_carrier_left_and_right_y, s8_481);
  w3.s8_483 = fnma(w2.r_carrier_left_and_right_aux1_y, w3.f_carrier_left_and_right_z, s8_482);

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  w3.s8_484 = w2.s8_160 - Pair{w2.s7_81[1], w2.s7_81[0]};
  const Pair s8_485 = fnma(w2.s8_227, s8_428, fma(w2.s8_207, s8_435, s8_436));
  w3.s8_486 = Pair{s8_432[1], s8_432[0]} + s8_485 - Pair{s8_439[1], s8_439[0]};
  const Pair s8_487 = fma(w2.s8_207, s8_440, fma(w2.s8_204, s8_430, s8_431));
  w3.s8_488 = s8_487 - Pair{s8_433[1], s8_433[0]} - Pair{s8_441[1], s8_441[0]};
  const Pair s8_489 = Pair{s8_410[1], s8_410[0]} + fma(w1.s1_5, w2.s8_160, w2.s8_174);
  const Pair s8_490 = Pair{s8_489[1], s8_489[0]} + fnma(w2.s8_227, s8_440, s8_448);
  const Pair s8_491 = w2.s8_193*Pair{s8_430[1], s8_430[0]};
  const Pair s8_492 = w2.s8_190*Pair{s8_423[1], s8_423[0]};
  const Pair s8_493 = Pair{s8_425[1], s8_425[0]} + s8_490 - Pair{s8_491[1], s8_491[0]};
  const Pair s8_494 = s8_493 - Pair{s8_492[1], s8_492[0]} - Pair{s8_434[1], s8_434[0]};
  w3.s8_495 = s8_494 - Pair{s8_442[1], s8_442[0]};

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  w4.s2_185 = -p_drag_link_from_z*w6.sines[7];
  w4.s2_186 = p_drag_link_to_y*w6.sines[8];
  w4.s2_187 = w4.s2_186 + (1.15 - w4.s2_185);
  w4.s2_188 = -p_drag_link_from_z*w6.cosines[7];
  w4.s2_189 = h_rear_axle_x - w4.s2_188;
  const double pivot_pitman_arm = fnma(w4.s2_188, w4.s2_187, w4.s2_185*w4.s2_189);
  w4.s2_190 = p_drag_link_to_y*w6.cosines[8];
  w4.s2_191 = p_pitman_arm_y - w4.s2_190;
  w4.s2_192 = fma(w4.s2_186, w4.s2_191, w4.s2_187*w4.s2_190);
  w4.s2_193 = 1.0/pivot_pitman_arm;
  w4.s2_194 = std::abs(pivot_pitman_arm);
}

/// Part 6 of compute_accelerations: step 3: Rz (61), upper_ball_left .. tie_rod_right; step 6: c
/// and dRz/dt zd (62), upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces
/// on joints, upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root
/// (63), upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63).
[[gnu::noinline]] void compute_accelerations_6(const State& state, const double* tau,
    AccelerationsWork1& __restrict w1, AccelerationsWork2& __restrict w2,
    AccelerationsWork3& __restrict w3, AccelerationsWork4& __restrict w4,
    AccelerationsWork5& __restrict w5, AccelerationsWork6& __restrict w6,
    Accelerations& __restrict result) noexcept {
  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right, continued ---
  w4.s3_34 = w4.s2_192*w4.s2_193;
  w4.s2_195 = 3.9625229801272064*w4.s2_194;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s6_112 = zd_pitman_arm*w4.s2_188;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s6_113 = zd_bell_crank*w4.s2_190;
  const double s8_496 = fma(w4.s2_188, w4.s3_34, w4.s2_190);

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right, continued ---
  // drag_link
  const double s6_114 = zd_pitman_arm*s6_112;
  const double s6_115 = s6_113 - s6_112;
  const double s6_116 = zd_bell_crank*s6_113;
  const double s6_117 = zd_pitman_arm*w4.s2_185;
  const double s6_118 = zd_bell_crank*w4.s2_186;
  const double s6_119 = fnma(zd_bell_crank, s6_118, zd_pitman_arm*s6_117);
  const double s6_120 = fma(w4.s2_189, s6_114, fma(s6_118, s6_118, s6_117*s6_117));
  const double s6_121 = fma(s6_115, s6_115, fma(w4.s2_191, s6_116, s6_120));
  w4.s6_122 = w4.s2_193*fma(w4.s2_187, s6_119, s6_121);

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  const double R_pitman_arm_x_z = w6.sines[7];
  const double s7_131 = K_pitman_arm_zz*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = w6.cosines[7];
  const double s7_132 = K_pitman_arm_xx*R_pitman_arm_x_x;
  const double s7_133 = fnma(R_pitman_arm_x_z, s7_132, R_pitman_arm_x_x*s7_131);
  const double s7_134 = fma(R_pitman_arm_x_x, s7_132, R_pitman_arm_x_z*s7_131);
  const double R_bell_crank_x_x = w6.cosines[8];
  const double R_bell_crank_y_x = w6.sines[8];
  const double s7_135 = -K_bell_crank_xy*R_bell_crank_x_x;
  const double s7_136 = fma(K_bell_crank_yy, R_bell_crank_y_x, s7_135);
  const double s7_137 = K_bell_crank_xx*R_bell_crank_x_x;
  const double s7_138 = fnma(K_bell_crank_xy, R_bell_crank_y_x, s7_137);
  const double s7_139 = fnma(R_bell_crank_x_x, s7_136, R_bell_crank_y_x*s7_138);
  const double s7_140 = fma(R_bell_crank_x_x, s7_138, R_bell_crank_y_x*s7_136);
  const Pair s2_196 = fnma(w1.s2_125, w2.s2_142, w2.s2_141*w1.s2_128);
  w3.Rz_carrier_left_and_right_rz_2 = w2.s2_158*(w2.s2_147*s2_196);
  w3.s3_35 = w2.s2_146*fnma(w2.s2_156, w3.Rz_carrier_left_and_right_rz_2, s2_196);
  w3.s3_36 = w2.s2_154*w3.s3_35;
  const Pair s8_497 = fms(w1.s2_131, w3.Rz_carrier_left_and_right_rz_2, w1.s2_128);
  const Pair s8_498 = fma(w1.s2_139, w3.s3_35, s8_497);
  const Pair s3_37 = fnma(w3.s3_35, w3.s2_177, w3.Rz_carrier_left_and_right_rz_2*w3.s2_176);
  const Pair s8_499 = fnma(w1.s2_131, w3.s3_36, fma(w1.s2_135, w3.s3_35, w1.s2_125));
  w3.Rz_arb_front_left_and_right_2 = w3.s2_179*fnma(w3.s2_178, w3.s3_36, s3_37);
  const Pair s8_500 = fma(w1.s2_139, w3.s3_36, w1.s2_135*w3.Rz_carrier_left_and_right_rz_2);
  const double s7_141 = fma(h_bell_crank_x, R_bell_crank_y_x, h_bell_crank_y*R_bell_crank_x_x);
  const Pair s8_501 = fnma(w3.s3_35, w2.s7_62, w2.s7_86*w3.s3_36);
  w4.s7_142 = -h_pitman_arm_z*R_pitman_arm_x_x;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_502 = w4.s3_34*w4.s7_142;
  const Pair s8_503 = w3.Rz_arb_front_left_and_right_2*w3.s7_98;
  const Pair s8_504 = s8_503 - s8_501;
  w4.s8_505 = s8_504[0] + (s8_502 - s7_141) - s8_504[1];
  const Pair s8_506 = fma(w3.Rz_carrier_left_and_right_rz_2, w2.s7_62, w2.s7_65*w3.s3_36);
  const Pair s8_507 = w3.Rz_arb_front_left_and_right_2*w3.s7_100;
  const Pair s8_508 = s8_506 - s8_507;
  w4.s7_143 = -h_pitman_arm_z*R_pitman_arm_x_z;
  const double s8_509 = w4.s3_34*w4.s7_143;
  w4.s8_510 = s8_508[0] - s8_509 - s8_508[1];
  w4.s7_144 = fma(h_bell_crank_y, R_bell_crank_y_x, -h_bell_crank_x*R_bell_crank_x_x);
  const Pair s8_511 = fma(w3.Rz_carrier_left_and_right_rz_2, w2.s7_86, w3.s3_35*w2.s7_65);
  w4.s8_512 = s8_511[0] + (w4.s7_144 + s8_511[1]);
  const Pair s8_513 = 7.5 + w3.s7_119;
  const Pair s8_514 = 10.0 + w3.s7_126;
  w3.s8_515 = s8_513 + s8_514;
  w4.s8_516 = s8_514[0] + (s8_513[0] + (5.25 + s7_141 - s8_513[1] - s8_514[1]));
  const double s8_517 = fnma(w4.s8_20, w4.s2_191, fma(w4.s8_38, w4.s2_187, w4.s8_40*w4.s2_189));
  // drag_link
  const double s8_518 = 1.5*fma(w4.s8_36, s6_115, s6_116 + fnma(w4.s8_35, s6_117, s8_517));
  const double s8_519 = fma(w4.s8_38, w4.s2_191, fnma(w4.s8_19, w4.s2_187, w4.s8_46*w4.s2_189));
  const double s8_520 = s6_119 + fnma(w4.s8_36, s6_118, fma(w4.s8_44, s6_117, s8_519));
  const double s8_521 = 1.5*fma(w4.s2_188, w4.s6_122, s8_520);
  const double s8_522 = fma(w4.s8_40, w4.s2_191, fnma(w4.s8_18, w4.s2_189, w4.s8_46*w4.s2_187));
  const double s8_523 = fnma(w4.s8_44, s6_115, s6_114 + fma(w4.s8_35, s6_118, s8_522));
  const double s8_524 = w4.s2_185*w4.s3_34;
  const double s8_525 = 1.5*fnma(w4.s2_185, w4.s6_122, s8_523);
  w4.s8_526 = -p_bell_crank_z*s7_141;
  const double s8_527 = 1.5*w4.s2_191;
  const double s8_528 = fma(p_bell_crank_z, w4.s7_144, s8_524*s8_527);
  w4.s8_529 = w4.s8_19 - w4.s8_20;
  const double s8_530 = fma(p_bell_crank_x, w4.s8_19, -p_bell_crank_z*w4.s8_46);
  const double s8_531 = fnma(w4.s8_529, s7_139, tau[Coordinate::bell_crank]);
  const double s8_532 = fma(p_bell_crank_z, w4.s8_40, p_bell_crank_x*w4.s8_38);
  const double s8_533 = fma(w4.s7_144, s8_532, fnma(s7_141, s8_530, s8_531));
  const double s8_534 = fma(s8_496, s8_521, fma(w4.s2_186, s8_518, s8_533));
  const double s8_535 = 1.5*w4.s2_189;
  const double s8_536 = 1.5*w4.s2_187;
  const double s8_537 = fnma(p_pitman_arm_y, s8_502, fnma(p_bell_crank_x, w4.s7_144, 0.9515));
  const double s8_538 = 0.3504*w4.s3_34;
  const double s8_539 = fma(p_pitman_arm_x, s8_509, fma(p_pitman_arm_z, s8_502, w4.s8_526));
  const double s8_540 = fma(s8_496, s8_496, fma(s8_524, s8_524, w4.s2_186*w4.s2_186));
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_541 = fma(593.0, z_rear_axle_ty, w4.s7_10);
  w4.s8_542 = w4.s8_516 + fma(m_rear_axle, z_rear_axle_ty, w4.s7_10);
  const double s8_543 = fma(s8_541, z_rear_axle_ty + z_rear_axle_ty, w4.s7_8);
  w4.s8_544 = fnma(w4.s2_191, s8_527, s8_543);
  const double s8_545 = fma(593.0, w3.r_rear_axle_aux1_x, w4.s7_22);
  const double s8_546 = fma(w3.r_rear_axle_aux1_x, s8_541, w4.s7_17);
  w4.s8_547 = fma(m_rear_axle, w3.r_rear_axle_aux1_x, w4.s7_22);
  const double s8_548 = fma(s8_545, w3.r_rear_axle_aux1_x + w3.r_rear_axle_aux1_x, w4.s7_24);
  w4.s8_549 = fnma(w4.s2_187, s8_536, s8_548);
  const double s8_550 = fma(593.0, w3.r_rear_axle_aux3_z, w4.s7_20);
  w4.s8_551 = fma(m_rear_axle, w3.r_rear_axle_aux3_z, w4.s7_20);
  const double s8_552 = fma(w3.r_rear_axle_aux1_x, s8_550, w4.s7_19);
  const double s8_553 = fma(s8_550, w3.r_rear_axle_aux3_z + w3.r_rear_axle_aux3_z, w4.s7_26);
  w4.s8_554 = fnma(w4.s2_189, s8_535, s8_553);
  const double s1_36 = 1.0/w6.cosines[1];
  const double s1_7 = w6.cosines[2];
  w4.s1_37 = s1_7*s1_36;
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double s1_6 = w6.sines[2];
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  const double s1_38 = w6.sines[1];
  w4.s1_39 = s1_38*s1_7;
  w4.s1_40 = w4.s1_39*s1_36;
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  const double s8_555 = fnma(s1_6, tau_chassis_ry, tau_chassis_rz*w4.s1_37);
  const double s8_556 = fma(tau_chassis_rx, w4.s1_40, s8_555);
  const double s8_557 = fma(z_rear_axle_ty, w4.f_rear_axle_x, s8_556);
  w4.s1_41 = s1_38*s1_6;
  w4.s1_42 = s1_6*s1_36;
  w4.s1_43 = w4.s1_41*s1_36;
  const double s8_558 = fma(tau_chassis_rz, w4.s1_42, s1_7*tau_chassis_ry);
  const double s8_559 = fma(tau_chassis_rx, w4.s1_43, s8_558);
  const double s8_560 = fnma(w3.r_rear_axle_aux3_z, w4.f_rear_axle_x, s8_559);
  const double s8_561 = fma(w3.r_rear_axle_aux3_z, w4.f_rear_axle_y, tau_chassis_rx);

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const double s8_562 = w3.s8_445[1];
  const double s8_563 = w3.s8_445[0];
  w4.s8_564 = 1.0/s8_562;
  result.inertia[12] = s8_562 - 1.5272999999999997e-20;
  const double s8_565 = w4.s8_237*w4.s8_564;
  w4.s8_566 = fma(w4.s8_235, s8_565, w4.s8_409);
  w4.s8_567 = w3.s8_484[0];
  w4.s8_568 = fnma(s8_565, w4.s8_567, w3.s8_484[1]);
  w4.s8_569 = w3.s8_411[1];
  w4.s8_570 = fms(s8_565, w4.s8_569, w3.s8_411[0]);
  w4.s8_571 = w3.s8_486[1];
  w4.s8_572 = fma(s8_565, w4.s8_571, w3.s8_486[0]);
  w4.s8_573 = w3.s8_488[1];
  w4.s8_574 = fma(s8_565, w4.s8_573, w3.s8_488[0]);
  w4.s8_575 = w3.s8_495[1];
  w4.s8_576 = fnma(s8_565, w4.s8_575, w3.s8_495[0]);
  w4.s8_577 = w3.s8_387[0];
  w4.s8_578 = fnma(s8_565, w4.s8_577, w3.s8_387[1]);
  const double pivot_arb_rear_left = fnma(w4.s8_237, s8_565, s8_563);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_579 = zd_bell_crank*(zd_bell_crank + w4.s8_36);
  const double s8_580 = zd_pitman_arm*w4.s8_36;
  const double s8_581 = zd_bell_crank*w4.s8_35;
  const double s8_582 = zd_pitman_arm*w4.s8_35;
  const double s8_583 = zd_bell_crank*w4.s8_44;
  const double s8_584 = zd_pitman_arm*(zd_pitman_arm + w4.s8_44);
  w4.s8_585 = fnma(w4.s7_144, s8_581, s7_141*s8_583);
  w4.s8_586 = s7_141*s8_579;
  w4.s8_587 = w4.s7_144*s8_579;
  w4.s8_588 = fma(p_bell_crank_x, s7_141, s7_139);
  w4.s8_589 = fma(w4.s7_142, s8_580, w4.s7_143*s8_582);
  w4.s8_590 = fma(w4.s7_143, s8_584, w4.s6_122*w4.s7_142);
  w4.s8_591 = fnma(w4.s6_122, w4.s7_143, w4.s7_142*s8_584);
  w4.s8_592 = 1.0/pivot_arb_rear_left;
  result.inertia[11] = fnma(1e-12, s8_563, pivot_arb_rear_left - 1.5272999999999997e-20);
  w4.s8_593 = w4.s8_592*w4.s8_572;
  const double s8_594 = fnma(w3.r_rear_axle_aux1_x, w4.f_rear_axle_y, s8_557) - w4.n_rear_axle_z;
  w4.s8_595 = w4.s8_564*w4.s8_571;
  const double s8_596 = fma(w4.s8_577, w4.s8_595, fnma(w4.s8_593, w4.s8_578, s8_594));
  const double s8_597 = fnma(s7_134, s8_582, fma(p_bell_crank_x, w4.s8_586, s8_596));
  const double s8_598 = fma(p_pitman_arm_x, w4.s8_589, fnma(s7_133, s8_580, s8_597));
  const double s8_599 = fma(w4.s2_187, s8_518, fma(p_pitman_arm_y, w4.s8_590, s8_598));
  w4.s8_600 = fnma(w4.s2_191, s8_521, s8_599);
  w4.s8_601 = w4.s8_592*w4.s8_576;
  const double s8_602 = fma(w3.r_rear_axle_aux3_z, s8_541, fma(z_rear_axle_ty, s8_550, w4.s7_6));
  const double s8_603 = fma(w3.r_rear_axle_aux1_x, w4.f_rear_axle_z, s8_560) - w4.n_rear_axle_y;
  w4.s8_604 = w4.s8_564*w4.s8_575;

  // --- step 8: elimination from the leaves to the root (63), continued ---
  const double s8_605 = fnma(w4.s8_571, w4.s8_604, fma(w4.s8_572, w4.s8_601, s8_602));
  w4.s8_606 = fnma(w4.s2_189, s8_527, s8_605);
  const double s8_607 = fnma(w4.s8_577, w4.s8_604, fnma(w4.s8_601, w4.s8_578, s8_603));
  const double s8_608 = fma(s7_139, s8_583, fma(s7_140, s8_581, s8_607));
  const double s8_609 = fnma(p_bell_crank_z, w4.s8_587, fma(p_bell_crank_x, w4.s8_585, s8_608));
  const double s8_610 = fma(p_pitman_arm_x, w4.s8_591, fma(0.3504, w4.s6_122, s8_609));
  const double s8_611 = fma(w4.s2_189, s8_521, fnma(p_pitman_arm_z, w4.s8_590, s8_610));
  w4.s8_612 = fnma(w4.s2_187, s8_525, s8_611);
  w4.s8_613 = w4.s8_592*w4.s8_574;
  const double s8_614 = fnma(z_rear_axle_ty, w4.f_rear_axle_z, s8_561) - w4.n_rear_axle_x;
  w4.s8_615 = w4.s8_564*w4.s8_573;
  const double s8_616 = fma(w4.s8_572, w4.s8_613, fma(w3.r_rear_axle_aux3_z, s8_545, s8_552));
  const double s8_617 = fma(w4.s8_613, w4.s8_576, fma(z_rear_axle_ty, s8_545, s8_546));
  w4.s8_618 = fnma(w4.s2_189, s8_536, fma(w4.s8_571, w4.s8_615, s8_616));
  w4.s8_619 = fnma(w4.s2_191, s8_536, fnma(w4.s8_575, w4.s8_615, s8_617));
  const double s8_620 = fma(w4.s8_577, w4.s8_615, fnma(w4.s8_613, w4.s8_578, s8_614));
  w5.s7_145 = 0.9515 - s7_140;
  const double s8_621 = fnma(w5.s7_145, s8_583, fnma(s7_139, s8_581, s8_620));
  const double s7_146 = 0.3504 - s7_134;
  const double s8_622 = fma(s7_133, s8_582, fnma(p_bell_crank_z, w4.s8_586, s8_621));
  const double s8_623 = fnma(p_pitman_arm_z, w4.s8_589, fma(s7_146, s8_580, s8_622));
  const double s8_624 = fnma(w4.s2_189, s8_518, fnma(p_pitman_arm_y, w4.s8_591, s8_623));
  w5.s8_625 = fma(w4.s2_191, s8_525, s8_624);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const Pair s8_626 = fma(w2.s2_165, w3.s3_35, w2.s2_168*w3.Rz_carrier_left_and_right_rz_2);
  const Pair s8_627 = fnma(w3.s3_35, w2.s2_162, w2.s2_168*w3.s3_36);
  const Pair s8_628 = fma(w3.s2_172, w3.Rz_arb_front_left_and_right_2, s8_627);
  const Pair s8_629 = fma(w2.s2_165, w3.s3_36, w3.Rz_carrier_left_and_right_rz_2*w2.s2_162);
  const Pair s8_630 = fma(w2.s2_170, w3.Rz_arb_front_left_and_right_2, s8_629);
  const Pair s8_631 = fnma(s8_626, w3.s8_316, fnma(s8_630, w3.s8_302, s8_628*w3.s8_311));
  const Pair s8_632 = fnma(s8_499, w3.s8_322, fnma(s8_500, w3.s8_305, s8_631));
  const Pair s8_633 = fma(s8_498, w3.s8_326, s8_632);
  const Pair s8_634 = fma(w3.Rz_carrier_left_and_right_rz_2, w3.s8_355, s8_633);
  const Pair s8_635 = fma(w3.Rz_carrier_left_and_right_rz_2, w1.s7_55, w3.s3_36*w3.s8_449);
  const Pair s8_636 = fnma(w3.s3_35, w1.s7_42, s8_635);
  const Pair s8_637 = fma(w3.Rz_carrier_left_and_right_rz_2, w3.s7_114, w3.s3_36*w1.s7_55);
  const Pair s8_638 = fma(w3.s3_35, w1.s7_59, s8_637);
  const Pair s8_639 = fnma(w3.Rz_carrier_left_and_right_rz_2, w1.s7_59, w3.s3_36*w1.s7_42);
  const Pair s8_640 = fnma(w3.s3_35, w3.s8_473, s8_639);
  const Pair s8_641 = 0.3477*w3.Rz_arb_front_left_and_right_2;
  const Pair s8_642 = fma(w3.s3_36, s8_636, w3.Rz_arb_front_left_and_right_2*s8_641);
  const Pair s8_643 = fma(w3.Rz_carrier_left_and_right_rz_2, s8_638, s8_642);
  const Pair s8_644 = fma(s8_628, s8_628, fma(s8_630, s8_630, s8_626*s8_626));
  const Pair s8_645 = fnma(0.3333333333333333, s8_644, fnma(w3.s3_35, s8_640, s8_643));
  const Pair s8_646 = fma(s8_499, s8_499, fma(s8_500, s8_500, s8_498*s8_498));
  const Pair s8_647 = fnma(1.1666666666666667, s8_646, s8_645);
  const double s8_648 = s8_647[0] + fnma(1.5, s8_540, fma(w4.s3_34, s8_538, 0.9515));
  w5.pivot_bell_crank = s8_647[1] + s8_648;
  const Pair s8_649 = fma(w1.r_carrier_left_aux1_z, s8_501, -p_arb_front_right_z*s8_503);
  const Pair s8_650 = fnma(p_arb_front_right_x, s8_507, s8_649);
  const Pair s8_651 = w2.r_carrier_left_and_right_aux1_y*s8_501;
  const Pair s8_652 = fnma(p_lower_arm_right_x, s8_511, s8_651);
  const Pair s8_653 = 0.3333333333333333*w3.s2_174;
  const Pair s8_654 = s8_636 + (fma(p_lower_arm_right_x, s8_506, s8_650) - s8_641);
  const Pair s8_655 = 0.3333333333333333*w3.s2_173;
  const Pair s8_656 = 1.1666666666666667*w1.s2_140;
  w3.s8_657 = fnma(w1.s2_140, s8_656, fnma(w3.s2_174, s8_653, w3.s8_479));
  const Pair s8_658 = 1.1666666666666667*w2.s2_142;
  const Pair s8_659 = fma(s8_499, s8_656, fma(s8_630, s8_655, fma(s8_628, s8_653, s8_654)));
  const Pair s8_660 = fnma(s8_500, s8_658, s8_659);
  const Pair s8_661 = fnma(s8_626, s8_655, s8_640 + fma(p_arb_front_right_y, s8_503, s8_652));
  w3.s8_662 = fnma(w2.s2_142, s8_658, fnma(w3.s2_173, s8_655, w3.s8_438));
  w3.s8_663 = fnma(w1.s2_140, s8_658, fnma(w3.s2_174, s8_655, w3.s8_475));
  w3.s8_664 = fma(w2.s2_141, s8_658, fnma(w3.s2_175, s8_655, w3.s8_467));
  const double s8_665 = fnma(s8_535, s8_496, fnma(s8_524, s8_536, s8_539 - s8_538)) - s8_660[0];
  w5.s8_666 = s8_660[1] + s8_665;
  const Pair s8_667 = fma(p_arb_front_right_y, s8_507, w1.r_carrier_left_aux1_z*s8_511);
  const Pair s8_668 = s8_638 + fma(w2.r_carrier_left_and_right_aux1_y, s8_506, s8_667);
  const Pair s8_669 = fnma(s8_640, w3.s3_30, fma(w1.s1_30, s8_506, w1.s1_28*s8_511));
  const Pair s8_670 = fma(s8_636, w3.s3_32, s8_669);
  const Pair s8_671 = fnma(s8_498, s8_656, fma(s8_626, s8_653, s8_668));
  const Pair s8_672 = fma(s8_641, w3.Rz_arb_front_left_0_and_right_1, s8_670);
  const Pair s8_673 = fma(s8_630, w3.s8_351, fma(s8_628, w3.s8_348, s8_626*w3.s8_346));
  const Pair s8_674 = fnma(0.3333333333333333, s8_673, fma(s8_638, w3.s8_345, s8_672));
  const Pair s8_675 = fma(s8_499, w3.s8_354, fma(s8_500, w3.s8_353, s8_498*w3.s8_352));
  w3.s8_676 = fnma(1.1666666666666667, s8_675, s8_674);
  const Pair s8_677 = 0.3333333333333333*w3.s2_175;
  const Pair s8_678 = fnma(w3.Rz_arb_front_left_and_right_2, w3.s7_94, s8_671);
  const Pair s8_679 = 1.1666666666666667*w2.s2_141;
  const Pair s8_680 = fma(s8_500, s8_679, fma(s8_630, s8_677, s8_678));
  w3.s8_681 = fnma(w2.s2_141, s8_679, fnma(w3.s2_175, s8_677, w3.s8_451));
  w3.s8_682 = fma(w1.s2_140, s8_679, fnma(w3.s2_174, s8_677, w3.s8_453));
  const Pair s8_683 = fnma(s8_499, s8_679, fma(s8_628, s8_677, fma(s8_498, s8_658, s8_661)));
  const Pair s8_684 = fnma(w3.Rz_arb_front_left_and_right_2, w3.s7_96, s8_683);
  const double s8_685 = s8_680[0] + fma(w4.s2_186, s8_535, fnma(p_pitman_arm_y, s8_509, s8_528));
  w5.s8_686 = s8_680[1] + s8_685;
  const double s8_687 = s8_684[0] + fma(s8_527, s8_496, fnma(w4.s2_186, s8_536, s8_537));
  w5.s8_688 = s8_684[1] + s8_687;
  const Pair s0_36 = Pair{tau[Coordinate::arb_front_left], tau[Coordinate::arb_front_right]};
  const Pair s8_689 = s0_36 - w3.s8_286;
  const Pair s8_690 = fma(w3.s3_36, w3.s8_344, fnma(w3.s3_35, w3.s8_343, s8_634));
  const Pair s8_691 = fma(w3.Rz_arb_front_left_and_right_2, s8_689, s8_690);
  w3.s8_692 = fnma(s8_689, w3.Rz_arb_front_left_0_and_right_1, w3.s8_369);
  const double s8_693 = fnma(p_pitman_arm_z, w4.s8_18, p_pitman_arm_x*w4.s8_46);
  const double s8_694 = fms(w4.s8_252, s7_133, tau[Coordinate::pitman_arm]);
  w5.s8_695 = K_chassis_xz + s7_133;
  const double s8_696 = fnma(p_rear_axle_tx_z, w4.s8_40, s8_693);
  const double s8_697 = fma(p_pitman_arm_z, w4.s8_46, p_pitman_arm_y*w4.s8_38);
  const double s8_698 = fma(w4.s7_143, s8_696, fnma(0.3504, w4.s6_122, s8_694));
  const double s8_699 = fnma(w4.s7_142, fnma(p_pitman_arm_x, w4.s8_19, s8_697), s8_698);
  w5.s8_700 = 10856.945 + s7_146;
  w5.s8_701 = s7_140 + (141129.72 + s7_134);
  const double s8_702 = s8_691[0] + fnma(s8_524, s8_525, s8_534) - s8_691[1];
  const double s8_703 = fma(w4.s8_38, w5.s7_145 - s7_140, s8_702);
  w5.s8_704 = fma(w4.s3_34, fma(w4.s8_46, s7_146 - s7_134, s8_699), s8_703);
  const Pair s8_705 = fma(w3.s8_449, w3.s3_32, fnma(w1.s7_42, w3.s3_30, w1.s1_30*w2.s7_65));
  const Pair s8_706 = fma(w1.s7_55, w3.s8_345, s8_705);
  const Pair s8_707 = fnma(w3.s8_473, w3.s3_30, fnma(w1.s1_28, w2.s7_65, w1.s7_42*w3.s3_32));
  const Pair s8_708 = fnma(w1.s7_59, w3.s8_345, s8_707);
  const Pair s8_709 = fma(w1.s7_59, w3.s3_30, fma(w1.s1_30, w2.s7_62, w1.s1_28*w2.s7_86));
  const Pair s8_710 = fma(w3.s7_114, w3.s8_345, fma(w1.s7_55, w3.s3_32, s8_709));
  const Pair s8_711 = fnma(p_lower_arm_right_y, w3.s7_126, 1.825625);
  const Pair s8_712 = fnma(w3.s7_94, w3.Rz_arb_front_left_0_and_right_1, s8_711);
  const Pair s8_713 = fma(s8_677, w3.s8_351, fma(s8_653, w3.s8_346, s8_712));
  const Pair s8_714 = fnma(w3.s7_96, w3.Rz_arb_front_left_0_and_right_1, s8_677*w3.s8_348);
  const Pair s8_715 = fnma(s8_658, w3.s8_353, fma(s8_655, w3.s8_351, s8_653*w3.s8_348));
  const Pair s8_716 = fma(s8_658, w3.s8_352, fnma(s8_655, w3.s8_346, s8_714));
  const Pair s8_717 = fma(w3.s8_348, w3.s8_348, w3.s8_346*w3.s8_346);
  w3.s8_718 = s8_708 + fnma(s8_679, w3.s8_354, s8_716);
  const Pair s8_719 = fma(w3.s8_353, w3.s8_353, w3.s8_352*w3.s8_352);
  const Pair s8_720 = fma(w2.s7_65, w3.s3_30, m_carrier_right*w1.s1_28);
  w3.s8_721 = fma(w2.s7_86, w3.s8_345, s8_720);
  const Pair s8_722 = 0.3477*w3.Rz_arb_front_left_0_and_right_1;
  w3.s8_723 = s8_706 + (fma(s8_656, w3.s8_354, s8_715) - s8_722);
  const Pair s8_724 = 0.539*w3.s3_28;
  const Pair s8_725 = fma(w3.Rz_arb_front_left_0_and_right_1, s8_722, 1.825625);
  const Pair s8_726 = fma(s8_679, w3.s8_353, fnma(s8_656, w3.s8_352, s8_713)) - s8_724;
  const Pair s8_727 = fma(w2.s7_65, w3.s3_32, m_carrier_right*w1.s1_30);
  w3.s8_728 = fma(w2.s7_62, w3.s8_345, s8_727);
  const Pair s8_729 = fma(w1.s1_28, w3.s8_721, fma(w3.s3_28, s8_724, s8_725));
  const Pair s8_730 = fma(w1.r_carrier_left_aux1_z, w3.s8_721, s8_726);
  const Pair s8_731 = fma(w3.s3_32, s8_706, fma(w1.s1_30, w3.s8_728, s8_729));
  const Pair s8_732 = s8_710 + fma(w2.r_carrier_left_and_right_aux1_y, w3.s8_728, s8_730);
  w3.s8_733 = fma(p_lower_arm_right_z, w3.s7_124, s8_732);
  const Pair s8_734 = fma(w3.s8_345, s8_710, fnma(w3.s3_30, s8_708, s8_731));
  const Pair s8_735 = fnma(0.3333333333333333, fma(w3.s8_351, w3.s8_351, s8_717), s8_734);
  w3.s8_736 = fnma(1.1666666666666667, fma(w3.s8_354, w3.s8_354, s8_719), s8_735);
  w3.s8_737 = w3.s7_94 + (1.732 + w2.s7_80);
}

/// Part 7 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63).
[[gnu::noinline]] void compute_accelerations_7(const double* tau, AccelerationsWork1& __restrict w1,
    AccelerationsWork2& __restrict w2, AccelerationsWork3& __restrict w3,
    AccelerationsWork4& __restrict w4, AccelerationsWork5& __restrict w5,
    AccelerationsWork6& __restrict w6, Accelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const Pair s8_738 = w2.s7_82 - 14.85;
  const Pair s8_739 = 17.775 + w3.s7_100;
  const Pair s8_740 = fnma(p_arb_rear_right_y, s8_738, w3.s8_737);
  const Pair s8_741 = fnma(p_arb_front_right_y, s8_739, s8_740);
  const Pair s8_742 = fma(p_lower_arm_left_x, w3.s8_515, s8_741);
  const double s8_743 = 46.2 - w4.s7_143;
  const double s8_744 = 23.1 - w4.s7_143;
  const double s8_745 = s8_742[0] + fma(p_pitman_arm_y, s8_743, w4.s8_588) - s8_742[1];
  const Pair s8_746 = 3.75 + w3.s7_119;
  const Pair s8_747 = w3.s7_106 + s8_746;
  const Pair s8_748 = 5.0 + w3.s7_126;
  const Pair s8_749 = fnma(p_upper_arm_right_z, s8_746, 2.215 + w2.s7_79);
  const Pair s8_750 = fma(0.8, s8_748, w3.s7_112);
  const Pair s8_751 = 2.025 + w2.s7_81;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const Pair s8_752 = fnma(p_lower_arm_right_z, s8_748, s8_749) - w3.s7_96;
  const Pair s8_753 = w3.s7_98 - 2.25;
  const Pair s8_754 = fnma(p_arb_rear_right_y, s8_751, s8_752);
  const Pair s8_755 = 2.1 - w3.s7_117;
  const Pair s8_756 = fma(p_arb_front_right_y, s8_753, s8_754) - w3.s7_107;
  const Pair s8_757 = 7.75 - w3.s7_124;
  const Pair s8_758 = fnma(p_upper_arm_right_y, s8_755, s8_756) - w3.s7_113;
  const Pair s8_759 = fnma(p_lower_arm_right_y, s8_757, s8_758);
  const double s8_760 = 4.2 + w4.s7_142;
  const double s8_761 = 2.1 + w4.s7_142;
  const double s8_762 = fnma(p_pitman_arm_y, s8_760, s8_759[1] - w4.s8_526) - s8_759[0];
  const Pair s8_763 = fma(109.75, w2.r_carrier_left_and_right_aux1_y, w2.s7_62);
  const Pair s8_764 = w2.r_carrier_left_and_right_aux1_y + w2.r_carrier_left_and_right_aux1_y;
  const Pair s8_765 = fma(s8_763, s8_764, w3.s8_681);
  const Pair s8_766 = w3.s3_28*w3.s7_117;
  const Pair s8_767 = s8_766 - w3.s8_721 - w3.s7_124;
  const Pair s8_768 = w3.s7_100*w3.Rz_arb_front_left_0_and_right_1;
  const Pair s8_769 = fnma(p_upper_arm_right_z, s8_766, w3.s8_733);
  const Pair s8_770 = w3.s7_119*w3.s3_28;
  const Pair s8_771 = s8_770 + (s8_768 - w3.s7_126 - w3.s8_728);
  const Pair s8_772 = fma(p_arb_front_right_y, s8_768, s8_769);
  const Pair s8_773 = fma(p_upper_arm_right_y, s8_770, s8_772);
  const Pair s8_774 = fnma(w2.s7_62, w3.s3_30, w2.s7_86*w3.s3_32);
  const Pair s8_775 = fma(m_carrier_right, w2.r_carrier_left_and_right_aux1_y, w2.s7_62);
  const Pair s8_776 = w3.s7_98*w3.Rz_arb_front_left_0_and_right_1;
  const Pair s8_777 = fma(p_lower_arm_left_x, s8_767, w3.s8_718);
  const Pair s8_778 = fma(p_arb_front_right_y, s8_776, s8_777);
  const Pair s8_779 = fma(w2.r_carrier_left_and_right_aux1_y, s8_774, s8_778);
  const Pair s8_780 = s8_774 - s8_776;
  const Pair s8_781 = fnma(p_arb_front_right_z, s8_776, w3.s8_723);
  const Pair s8_782 = fma(w1.r_carrier_left_aux1_z, s8_774, s8_781);
  const Pair s8_783 = fnma(p_arb_front_right_x, s8_768, s8_782);
  const Pair s8_784 = fma(p_lower_arm_left_x, w3.s7_126 + w3.s8_728 - s8_770, s8_783);
  w5.s8_785 = w3.s8_676[0];
  w5.s8_786 = w3.s8_676[1];
  w5.s8_787 = 1.0/w5.pivot_bell_crank;
  result.inertia[8] = w5.pivot_bell_crank - 1.5272999999999997e-20;
  const double s8_788 = w5.s8_787*w5.s8_786;
  const double pivot_lower_arm_right = fnma(w5.s8_786, s8_788, w3.s8_736[1]);
  w5.s8_789 = fnma(w4.s8_505, s8_788, s8_780[1]);
  w5.s8_790 = fma(w4.s8_512, s8_788, s8_767[1]);
  w5.s8_791 = fnma(w4.s8_510, s8_788, s8_771[1]);
  w5.s8_792 = fnma(w5.s8_688, s8_788, s8_779[1]);
  w5.s8_793 = fnma(w5.s8_686, s8_788, s8_773[1]);
  w5.s8_794 = fnma(w5.s8_666, s8_788, s8_784[1]);
  w5.s8_795 = fnma(w5.s8_704, s8_788, w3.s8_692[1]);
  w5.s8_796 = w5.s8_785*s8_788;
  const double s8_797 = w5.s8_787*w5.s8_785;
  w5.s8_798 = 1.0/pivot_lower_arm_right;
  w5.s8_799 = pivot_lower_arm_right - 1.5272999999999997e-20;
  const double s8_800 = w5.s8_796*w5.s8_798;
  w5.s8_801 = fma(s8_800, w5.s8_790, fma(w4.s8_512, s8_797, s8_767[0]));
  w5.s8_802 = fnma(w4.s8_505, s8_797, s8_800*w5.s8_789) - s8_780[0];
  w5.s8_803 = fnma(w4.s8_510, s8_797, s8_800*w5.s8_791) - s8_771[0];
  w5.s8_804 = s8_773[0] + fnma(w5.s8_686, s8_797, s8_800*w5.s8_793);
  w5.s8_805 = s8_779[0] + fnma(w5.s8_688, s8_797, s8_800*w5.s8_792);
  w5.s8_806 = fnma(w5.s8_666, s8_797, s8_800*w5.s8_794) - s8_784[0];
  w3.s8_807 = 1e-12*w3.s8_736;
  const double pivot_lower_arm_left = fnma(w5.s8_796, s8_800, fnma(w5.s8_785, s8_797,
      w3.s8_736[0]));
  w5.s8_808 = fnma(w5.s8_704, s8_797, s8_800*w5.s8_795) - w3.s8_692[0];
  const Pair s8_809 = fma(p_arb_rear_right_z, s8_738, w2.s7_78 + w3.s7_91);
  const Pair s8_810 = fma(p_arb_front_right_z, s8_739, s8_809);
  const Pair s8_811 = fnma(p_arb_rear_right_x, s8_751, s8_810);
  const Pair s8_812 = 4.2 - w3.s7_117;
  const Pair s8_813 = 15.5 - w3.s7_124;
  const Pair s8_814 = fma(p_arb_front_right_x, s8_753, s8_811);
  const Pair s8_815 = fnma(p_lower_arm_left_x, s8_812 + s8_813, s8_814);
  const double s8_816 = 66.625 - w4.s7_144;

  // --- step 8: elimination from the leaves to the root (63), continued ---
  const double s8_817 = fnma(p_pitman_arm_x, s8_761, fma(p_bell_crank_z, s8_816, w5.s8_695));
  const double s8_818 = s8_815[1] + (s8_815[0] + fma(p_pitman_arm_z, s8_744, s8_817));
  const Pair s8_819 = w3.s7_98 - 8.55 - w2.s7_81 - s8_812 - s8_813;
  const double s8_820 = s8_819[1] + (s8_819[0] + (3350.4 - s8_760));
  const Pair s8_821 = w1.s0_12*(w1.s0_12 + w2.s8_82);
  const Pair s8_822 = w1.s0_12*w2.s8_74;
  const Pair s8_823 = w1.s0_12*w2.s8_87;
  const Pair s8_824 = w2.s8_87*w2.s0_26;
  const Pair s8_825 = fma(w2.s7_77, s8_823, fma(w2.s7_78, s8_822, w3.s8_470));
  const Pair s8_826 = fnma(w2.s7_78, s8_823, fnma(w2.s7_83, s8_822, w3.s8_483));
  const Pair s8_827 = fnma(w2.s7_81, s8_822, w2.s7_82*s8_823);
  const Pair s8_828 = fma(7.9, s8_739, fnma(6.6, s8_738, w2.s7_77 + w3.s7_92));
  const Pair s8_829 = w2.s7_81*s8_821;
  const Pair s8_830 = fma(0.56, s8_755, fma(0.9, s8_751, w2.s7_83 + w3.s7_101) - s8_753);
  const Pair s8_831 = w2.s7_82*s8_821;
  const Pair s8_832 = fma(p_arb_rear_right_x, s8_827, fnma(w2.s7_80, s8_821, s8_825));
  const Pair s8_833 = w3.s7_127 + (w3.s7_120 + fma(1.24, s8_757, s8_830));
  const Pair s8_834 = w3.s7_100 + (5.85 + w2.s7_82);
  const Pair s8_835 = w2.s0_26*(w2.s8_82 + w2.s0_26);
  const Pair s8_836 = w2.s8_74*w2.s0_26;
  const Pair s8_837 = fnma(p_arb_rear_right_z, s8_827, fnma(w2.s7_79, s8_821, s8_826));
  const Pair s8_838 = fma(w3.s7_91, s8_836, fma(p_arb_rear_right_y, s8_831, s8_832));
  const Pair s8_839 = fma(w3.s7_100, s8_824, w3.s7_98*s8_836);
  const Pair s8_840 = fnma(w3.s7_91, s8_824, fnma(w3.s7_101, s8_836, s8_837));
  const Pair s8_841 = fnma(w3.s7_100, s8_835, w3.s7_98*w3.zdd_star_arb_front_left_and_right);
  const Pair s8_842 = fnma(w3.s7_94, s8_835, fma(w3.s7_92, s8_824, s8_838));
  const Pair s8_843 = fnma(p_arb_rear_right_z, s8_831, w3.s8_477);
  const Pair s8_844 = fnma(p_arb_front_right_y, s8_841, s8_842);
  const Pair s8_845 = fma(w3.s7_98, s8_835, w3.s7_100*w3.zdd_star_arb_front_left_and_right);
  const double s8_846 = s8_834[1] + (s8_834[0] + (s8_743 + (232.0 + s8_816)));
  const Pair s8_847 = fma(w3.s7_119, w2.s8_90, w2.s6_92*w3.s7_117);
  const Pair s8_848 = fnma(w3.s7_117, w2.s8_90, w3.s7_119*w2.s6_92);
  const Pair s8_849 = w2.s8_82*w2.s0_22;
  const Pair s8_850 = w2.s8_74*w2.s0_22;
  const Pair s8_851 = w2.s8_82*w1.s0_14;
  const Pair s8_852 = w2.s8_74*w1.s0_14;
  const Pair s8_853 = fnma(w3.s7_117, s8_850, w3.s7_119*s8_849);
  const Pair s8_854 = fma(w3.s7_106, s8_849, fma(p_arb_front_right_x, s8_839, s8_844));
  const Pair s8_855 = fma(w3.s7_107, s8_849, fma(p_arb_front_right_z, s8_841, s8_843));
  const Pair s8_856 = fnma(p_upper_arm_right_y, s8_853, fnma(w3.s7_107, s8_850, s8_854));
  const Pair s8_857 = fma(p_upper_arm_right_z, s8_853, fnma(w3.s7_120, s8_850, s8_855));
  const Pair s8_858 = fma(w2.r_carrier_left_and_right_aux1_y, w3.f_carrier_left_and_right_x,
      s8_856);
  const Pair s8_859 = fma(w1.r_carrier_left_aux1_z, w3.f_carrier_left_and_right_x, s8_857);
  const Pair s8_860 = fnma(w3.s7_124, s8_852, w3.s7_126*s8_851);
  const Pair s8_861 = w3.s7_126*w2.s8_91;
  const Pair s8_862 = fnma(w3.s7_113, s8_852, fma(w3.s7_112, s8_851, s8_858));
  const Pair s8_863 = w3.s7_124*w2.s8_91;
  const Pair s8_864 = fnma(w3.s7_127, s8_852, fma(w3.s7_113, s8_851, s8_859));
  // chassis: chassis_rx, revolute, chassis_aux5
  w3.s8_865 = s8_831 - s8_841 - s8_853 - w3.f_carrier_left_and_right_x - s8_860;
  const Pair s8_866 = fnma(p_upper_arm_right_z, s8_847, fma(w3.s7_96, s8_835, s8_840));
  w3.s8_867 = s8_861 + (s8_847 + (s8_839 + (w3.f_carrier_left_and_right_y + s8_827)));
  const Pair s8_868 = fma(p_lower_arm_right_z, s8_860, s8_864);
  const Pair s8_869 = s8_861 + (w3.f_carrier_left_and_right_y + s8_847);
  const Pair s8_870 = fnma(p_lower_arm_right_y, s8_860, s8_862);
  const Pair s8_871 = fma(p_lower_arm_left_x, s8_869, s8_870);
  const Pair s8_872 = fnma(p_lower_arm_right_z, s8_861, s8_866);
  const Pair s8_873 = fnma(p_arb_rear_right_x, s8_829, s8_868);
  const Pair s8_874 = fma(p_arb_rear_right_y, s8_829, s8_872);
  const Pair s8_875 = fnma(p_arb_front_right_y, s8_845, s8_874);
  const Pair s8_876 = fnma(p_lower_arm_right_y, s8_863, s8_875);
  const Pair s8_877 = fnma(p_rear_axle_tx_z, s8_839 - s8_848, s8_876);
  const Pair s8_878 = s8_863 - w3.f_carrier_left_and_right_z - s8_848;
  const Pair s8_879 = fma(p_arb_front_right_x, s8_845, s8_873);
  const Pair s8_880 = fma(p_lower_arm_left_x, s8_878, s8_879);
  w3.s8_881 = s8_863 + (s8_845 - w3.f_carrier_left_and_right_z - s8_829 - s8_848);
  const double s8_882 = s8_833[1] + (s8_833[0] + fma(0.8, s8_761, w5.s8_700));
  const double s8_883 = s8_750[0] + (s8_747[0] + (s8_750[1] + (w5.s7_145 + s8_747[1])));
  const double s8_884 = 5020.856800000031 + s8_883;
  const double s8_885 = s8_828[0] + fma(8.8, s8_744, fma(6.5, 33.3125 - w4.s7_144, w5.s8_701));
  const double s8_886 = s8_828[1] + s8_885;
  w5.s8_887 = s8_775[0] + w4.s8_542 - s8_775[1];
  const double s8_888 = s8_884 + (s8_765[1] + (s8_765[0] + w4.s8_544));
  const Pair s8_889 = 395.1 + w2.s7_65;
  const Pair s8_890 = fma(7.2, s8_889, w3.s8_662);
  const Pair s8_891 = fma(p_lower_arm_right_x, s8_763, w3.s8_664);
  const Pair s8_892 = fma(w2.r_carrier_left_and_right_aux1_y, s8_889, s8_891);
  const Pair s8_893 = 790.2 + w2.s7_65;
  const double s8_894 = s8_890[1] + (s8_890[0] + (s8_886 + w4.s8_549));
  const Pair s8_895 = fma(m_carrier_right, w1.r_carrier_left_aux1_z, w2.s7_86);
  const Pair s8_896 = fma(109.75, w1.r_carrier_left_aux1_z, w2.s7_86);
  const Pair s8_897 = fma(w1.r_carrier_left_aux1_z, s8_763, w3.s8_682);
  const Pair s8_898 = fma(w2.r_carrier_left_and_right_aux1_y, s8_896, s8_897);
  const Pair s8_899 = fma(w1.r_carrier_left_aux1_z, s8_889, w3.s8_663);
  const Pair s8_900 = fma(p_lower_arm_right_x, s8_896, s8_899);
  const Pair s8_901 = w1.r_carrier_left_aux1_z + w1.r_carrier_left_aux1_z;
  const Pair s8_902 = fma(s8_896, s8_901, w3.s8_657);
  w5.s8_903 = s8_895[1] + (s8_895[0] + (s8_820 + w4.s8_551));
  w5.s8_904 = 1.0/pivot_lower_arm_left;
  w5.s8_905 = pivot_lower_arm_left - 1.5272999999999997e-20;
  const double s8_906 = w5.s8_904*w5.s8_806;
  const double s8_907 = fnma(w4.s8_575, w4.s8_604, fnma(w4.s8_576, w4.s8_601, s8_894));
  const double s8_908 = w5.s8_798*w5.s8_794;
  const double s8_909 = fnma(w4.s8_38, s8_762, fma(w4.s8_40, s8_745, w4.s8_612));
  const double s8_910 = w5.s8_666*w5.s8_787;
  const double s8_911 = fma(w5.s8_792, s8_908, fma(w5.s8_805, s8_906, s8_762 + w4.s8_606));
  const double s8_912 = fnma(w5.s8_794, s8_908, fnma(w5.s8_806, s8_906, s8_907));
  const double s8_913 = fnma(w5.s8_704, s8_910, fnma(w5.s8_795, s8_908, s8_909));
  w5.s8_914 = s8_898[0] + fma(w5.s8_688, s8_910, s8_911) - s8_898[1];
  const double s8_915 = s8_902[1] + (s8_902[0] + (s8_882 + w4.s8_554));
  const double s8_916 = s8_915 + fnma(w5.s8_666, s8_910, s8_912);
  const double s8_917 = w5.s8_904*w5.s8_805;
  const double s8_918 = fnma(w4.s8_571, w4.s8_595, fnma(w4.s8_572, w4.s8_593, s8_888));
  const double s8_919 = w5.s8_798*w5.s8_792;
  const double s8_920 = fma(w4.s8_46, s8_762, fnma(w4.s8_529, s8_745, w4.s8_600));
  const double s8_921 = w5.s8_688*w5.s8_787;
  const double s8_922 = fnma(w5.s8_792, s8_919, fnma(w5.s8_805, s8_917, s8_918));
  const double pivot_chassis_rx = s8_894 + fnma(w5.s8_688, s8_921, s8_922);
  result.inertia[5] = pivot_chassis_rx;
  const double s8_923 = fnma(w5.s8_704, s8_921, fnma(w5.s8_795, s8_919, s8_920));
  w5.s8_924 = 1.0/pivot_chassis_rx;
  const double s8_925 = w5.s8_904*w5.s8_804;
  const double s8_926 = fnma(w4.s8_573, w4.s8_615, fnma(w4.s8_574, w4.s8_613, s8_888));
  const double s8_927 = w5.s8_798*w5.s8_793;
  const double s8_928 = fnma(w4.s8_336, s8_762, fnma(w4.s8_46, s8_745, w5.s8_625));
  const double s8_929 = w5.s8_686*w5.s8_787;
  const double s8_930 = fma(w5.s8_792, s8_927, fma(s8_925, w5.s8_805, w4.s8_618));
  const double s8_931 = fma(w5.s8_794, s8_927, fma(s8_925, w5.s8_806, s8_745 + w4.s8_619));
  const double s8_932 = fnma(w5.s8_793, s8_927, fnma(w5.s8_804, s8_925, s8_926));
  w5.s8_933 = s8_915 + fnma(w5.s8_686, s8_929, s8_932);
  const double s8_934 = fnma(w5.s8_704, s8_929, fnma(w5.s8_795, s8_927, s8_928));
  w5.s8_935 = s8_900[1] + (s8_900[0] + (s8_818 + fma(w5.s8_688, s8_929, s8_930)));
  w5.s8_936 = w5.s8_924*w5.s8_914;
  const double s8_937 = s8_892[0] + fma(w5.s8_936, w5.s8_935, fma(w5.s8_666, s8_929, s8_931));
  w5.s8_938 = s8_937 - s8_892[1];
  const double s8_939 = s8_871[0] + fnma(w4.s8_40, s8_818, fnma(s8_917, w5.s8_808, s8_923));
  w5.s8_940 = fma(w4.s8_38, s8_884 - s8_886, s8_939 - s8_871[1]);
  const double s8_941 = fnma(w4.s8_252, s8_818, fnma(s8_906, w5.s8_808, s8_913));
  const double s8_942 = fma(w5.s8_936, w5.s8_940, s8_941) - s8_880[0] - s8_880[1];
  w5.s8_943 = fma(w4.s8_46, s8_886 - s8_882, s8_942);
  w5.s8_944 = w5.s8_924*w5.s8_935;
  const double s8_945 = fma(w4.s8_38, s8_818, fnma(s8_925, w5.s8_808, s8_934));
  const double pivot_chassis_ry = fnma(w5.s8_914, w5.s8_936, s8_916);
  w5.s8_946 = fnma(1e-12, s8_916, pivot_chassis_ry);
  w5.s8_947 = 1.0/pivot_chassis_ry;
  w5.s8_948 = w5.s8_947*w5.s8_938;
  const double s8_949 = s8_877[0] + fma(w5.s8_948, w5.s8_943, fma(w5.s8_944, w5.s8_940, s8_945));
  w5.s8_950 = fma(w4.s8_40, s8_882 - s8_884, s8_949 - s8_877[1]);
  const double R_chassis_aux4_y_x = w6.sines[0];
  const double s1_6 = w6.sines[2];
  const double R_chassis_aux4_x_x = w6.cosines[0];
  w5.R_chassis_x_z = fma(R_chassis_aux4_x_x, w4.s1_39, R_chassis_aux4_y_x*s1_6);
  w5.R_chassis_y_z = fnma(R_chassis_aux4_x_x, s1_6, R_chassis_aux4_y_x*w4.s1_39);
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  const double s8_951 = fma(w5.R_chassis_y_z, tau_chassis_ty, w5.R_chassis_x_z*tau_chassis_tx);
  w5.s8_952 = w4.s8_592*w4.s8_570;
  const double s8_953 = fma(w4.R_chassis_z_z, tau_chassis_tz, s8_951) - w4.f_rear_axle_z;
  w5.s8_954 = w4.s8_564*w4.s8_569;
  const double s8_955 = fma(w4.s8_577, w5.s8_954, fnma(w5.s8_952, w4.s8_578, s8_953));
  w5.s8_956 = w5.s8_798*w5.s8_791;
  const double s8_957 = fnma(w4.s8_40, w4.s8_516, s8_955 - w4.s8_585 - w4.s8_591);
  w5.s8_958 = w4.s8_510*w5.s8_787;
  w5.s8_959 = w5.s8_904*w5.s8_803;
  const double s8_960 = fnma(w5.s8_704, w5.s8_958, fnma(w5.s8_795, w5.s8_956, s8_957));
  const double s8_961 = fma(w4.s8_18, s8_820, fnma(w5.s8_959, w5.s8_808, s8_960));
  w5.s8_962 = fnma(w4.s8_46, s8_846, s8_961);
  const double s1_7 = w6.cosines[2];
  w5.R_chassis_x_y = fnma(R_chassis_aux4_y_x, s1_7, R_chassis_aux4_x_x*w4.s1_41);
  w5.R_chassis_y_y = fma(R_chassis_aux4_x_x, s1_7, R_chassis_aux4_y_x*w4.s1_41);
  const double s8_963 = fma(w5.R_chassis_y_y, tau_chassis_ty, w5.R_chassis_x_y*tau_chassis_tx);
  w5.s8_964 = w4.s8_235*w4.s8_564;
  const double s8_965 = fma(w4.R_chassis_z_y, tau_chassis_tz, s8_963) - w4.f_rear_axle_y;
  w5.s8_966 = w4.s8_566*w4.s8_592;
  const double s8_967 = fma(w5.s8_966, w4.s8_578, fnma(w5.s8_964, w4.s8_577, s8_965));
  w5.s8_968 = w5.s8_798*w5.s8_790;
  const double s8_969 = fma(w4.s8_20, w4.s8_516, w4.s8_589 + (w4.s8_586 + s8_967));
  w5.s8_970 = w4.s8_512*w5.s8_787;
  w5.s8_971 = w5.s8_904*w5.s8_801;
  const double s8_972 = fma(w5.s8_704, w5.s8_970, fnma(w5.s8_795, w5.s8_968, s8_969));
  const double s8_973 = fnma(w4.s8_40, s8_820, fnma(w5.s8_971, w5.s8_808, s8_972));
  w5.s8_974 = fnma(w4.s8_38, s8_846, s8_973);
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux5_z_z = w6.cosines[1];
  w5.R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  w5.R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  const double s8_975 = w5.R_chassis_aux5_x_x*tau_chassis_tx;
  const double s8_976 = fma(w5.R_chassis_aux5_y_x, tau_chassis_ty, s8_975);
  w5.s8_977 = w4.s8_592*w4.s8_568;
  const double s8_978 = fnma(w6.sines[1], tau_chassis_tz, s8_976) - w4.f_rear_axle_x;
  w5.s8_979 = w4.s8_564*w4.s8_567;
  const double s8_980 = fnma(w4.s8_577, w5.s8_979, fnma(w5.s8_977, w4.s8_578, s8_978));
  w5.s8_981 = w5.s8_798*w5.s8_789;
  const double s8_982 = fnma(w4.s8_38, w4.s8_516, s8_980 - w4.s8_587 - w4.s8_590);
  w5.s8_983 = w4.s8_505*w5.s8_787;
  w5.s8_984 = w5.s8_802*w5.s8_904;
  const double s8_985 = fnma(w5.s8_704, w5.s8_983, fnma(w5.s8_795, w5.s8_981, s8_982));
  const double s8_986 = fnma(w4.s8_46, s8_820, fnma(w5.s8_984, w5.s8_808, s8_985));
  w5.s8_987 = fma(w4.s8_19, s8_846, s8_986);
  w5.s8_988 = s8_893[1] + (s8_893[0] + (s8_846 + w4.s8_547));
}

/// Part 8 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63); step 9:
/// accelerations from the root to the leaves (63), (62); step 2: closure Jacobian Phi_z and its
/// factors (60), upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_8(const State& state, const double* tau,
    AccelerationsWork1& __restrict w1, AccelerationsWork2& __restrict w2,
    AccelerationsWork3& __restrict w3, AccelerationsWork4& __restrict w4,
    AccelerationsWork5& __restrict w5, AccelerationsWork6& __restrict w6,
    Accelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_989 = fma(w4.s8_571, w5.s8_954, w5.s8_952*w4.s8_572);
  const double s8_990 = fma(w5.s8_792, w5.s8_956, fma(w5.s8_959, w5.s8_805, s8_989));
  const double s8_991 = fma(w5.s8_688, w5.s8_958, s8_990);

  // --- step 8: elimination from the leaves to the root (63), continued ---
  const double s8_992 = fnma(w4.s8_571, w5.s8_979, w5.s8_977*w4.s8_572);
  const double s8_993 = fma(w5.s8_792, w5.s8_981, fma(w5.s8_984, w5.s8_805, s8_992));
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_994 = w5.s8_887 + fma(w5.s8_688, w5.s8_983, s8_993);
  const double s8_995 = fnma(w4.s8_573, w5.s8_954, fnma(w5.s8_952, w4.s8_574, w5.s8_887));
  const double s8_996 = fnma(w5.s8_793, w5.s8_956, fnma(w5.s8_959, w5.s8_804, s8_995));
  const double s8_997 = fnma(w4.s8_575, w5.s8_954, w5.s8_952*w4.s8_576);
  const double s8_998 = fnma(w4.s8_569, w5.s8_954, fnma(w4.s8_570, w5.s8_952, 15306.0));
  const double s8_999 = fma(w5.s8_794, w5.s8_956, fma(w5.s8_959, w5.s8_806, s8_997));
  const double s8_1000 = fnma(w5.s8_791, w5.s8_956, fnma(w5.s8_803, w5.s8_959, s8_998));
  const double s8_1001 = fnma(w4.s8_510, w5.s8_958, s8_1000);
  const double s8_1002 = w5.s8_988 + fma(s8_991, w5.s8_936, fma(w5.s8_666, w5.s8_958, s8_999));
  const double s8_1003 = fnma(s8_991, w5.s8_944, fnma(w5.s8_686, w5.s8_958, s8_996));
  const double s8_1004 = fnma(w5.s8_948, s8_1002, s8_1003);
  const double s8_1005 = fma(w4.s8_571, w5.s8_964, w5.s8_966*w4.s8_572);
  const double s8_1006 = fnma(w5.s8_792, w5.s8_968, fnma(w5.s8_971, w5.s8_805, s8_1005));
  const double s8_1007 = w5.s8_988 + fma(w5.s8_688, w5.s8_970, s8_1006);
  const double s8_1008 = fnma(w4.s8_575, w5.s8_979, fnma(w5.s8_977, w4.s8_576, w5.s8_903));
  const double s8_1009 = fnma(w5.s8_794, w5.s8_981, fnma(w5.s8_984, w5.s8_806, s8_1008));
  const double s8_1010 = fnma(s8_994, w5.s8_936, fnma(w5.s8_666, w5.s8_983, s8_1009));
  const double s8_1011 = fnma(w4.s8_575, w5.s8_964, w5.s8_966*w4.s8_576);
  const double s8_1012 = fnma(w5.s8_794, w5.s8_968, fnma(w5.s8_971, w5.s8_806, s8_1011));
  const double s8_1013 = fma(w5.s8_936, s8_1007, fma(w5.s8_666, w5.s8_970, s8_1012));
  const double s8_1014 = fma(w4.s8_573, w5.s8_964, w5.s8_966*w4.s8_574);
  const double s8_1015 = fnma(w5.s8_793, w5.s8_968, fnma(w5.s8_971, w5.s8_804, s8_1014));
  const double s8_1016 = fma(w5.s8_944, s8_1007, fma(w5.s8_686, w5.s8_970, s8_1015) - w5.s8_903);
  const double s8_1017 = fma(w5.s8_948, s8_1013, s8_1016);
  const double s8_1018 = fnma(w5.s8_977, w4.s8_574, w4.s8_573*w5.s8_979);
  const double s8_1019 = fnma(w5.s8_793, w5.s8_981, fnma(w5.s8_984, w5.s8_804, s8_1018));
  const double s8_1020 = fma(s8_1010, w5.s8_948, fnma(w5.s8_686, w5.s8_983, s8_1019));
  const double s8_1021 = fnma(s8_994, w5.s8_944, s8_1020);
  const double pivot_chassis_rz = fnma(w5.s8_935, w5.s8_944, fnma(w5.s8_938, w5.s8_948, w5.s8_933));
  result.inertia[3] = fnma(1e-12, w5.s8_933, pivot_chassis_rz);
  const double s8_1022 = 1.0/pivot_chassis_rz;
  const double s8_1023 = fnma(w4.s8_567, w5.s8_979, fnma(w4.s8_568, w5.s8_977, 15306.0));
  const double s8_1024 = fnma(w5.s8_789, w5.s8_981, fnma(w5.s8_802, w5.s8_984, s8_1023));
  const double s8_1025 = fnma(w4.s8_505, w5.s8_983, s8_1024);
  const double s8_1026 = fnma(w5.s8_977, w4.s8_570, w4.s8_569*w5.s8_979);
  const double s8_1027 = fnma(w5.s8_791, w5.s8_981, fnma(w5.s8_984, w5.s8_803, s8_1026));
  const double s8_1028 = fnma(w4.s8_235, w5.s8_979, w4.s8_566*w5.s8_977);
  const double s8_1029 = fnma(w5.s8_790, w5.s8_981, fnma(w5.s8_984, w5.s8_801, s8_1028));
  const double s8_1030 = fma(w4.s8_569, w5.s8_964, w5.s8_966*w4.s8_570);
  const double s8_1031 = fnma(w4.s8_235, w5.s8_964, fnma(w4.s8_566, w5.s8_966, 15306.0));
  const double s8_1032 = fnma(w5.s8_791, w5.s8_968, fnma(w5.s8_803, w5.s8_971, s8_1030));
  const double s8_1033 = fnma(w5.s8_790, w5.s8_968, fnma(w5.s8_801, w5.s8_971, s8_1031));
  const double s8_1034 = fnma(w4.s8_512, w5.s8_970, s8_1033);
  const double s8_1035 = w5.s8_947*s8_1002;
  const double s8_1036 = s8_991*w5.s8_924;
  const double s8_1037 = fma(s8_1010, s8_1035, fnma(w4.s8_510, w5.s8_983, s8_1027));
  const double s8_1038 = fma(s8_1036, s8_1007, fma(w4.s8_510, w5.s8_970, s8_1032));
  const double s8_1039 = s8_1022*s8_1004;
  const double s8_1040 = fnma(s8_1021, s8_1039, fnma(s8_994, s8_1036, s8_1037));
  const double s8_1041 = fnma(s8_991, s8_1036, fnma(s8_1002, s8_1035, s8_1001));
  const double pivot_chassis_tz = fnma(s8_1004, s8_1039, s8_1041);
  const double s8_1042 = fnma(s8_1039, s8_1017, fma(s8_1035, s8_1013, s8_1038));
  const double s8_1043 = fma(s8_1035, w5.s8_943, fma(s8_1036, w5.s8_940, w5.s8_962));
  result.inertia[2] = fnma(1e-12, s8_1001, pivot_chassis_tz);
  const double s8_1044 = 1.0/pivot_chassis_tz;
  const double s8_1045 = w3.s8_881[1] + (w3.s8_881[0] + fnma(s8_1039, w5.s8_950, s8_1043));
  const double s8_1046 = w5.s8_924*s8_1007;
  const double s8_1047 = w5.s8_947*s8_1013;
  const double s8_1048 = fma(s8_994, s8_1046, fma(w4.s8_512, w5.s8_983, s8_1029));
  const double s8_1049 = s8_1022*s8_1017;
  const double s8_1050 = fnma(s8_1013, s8_1047, fnma(s8_1007, s8_1046, s8_1034));
  const double s8_1051 = fnma(s8_1047, w5.s8_943, fnma(s8_1046, w5.s8_940, w5.s8_974));
  const double s8_1052 = s8_1044*s8_1042;
  const double s8_1053 = fnma(s8_1021, s8_1049, fnma(s8_1010, s8_1047, s8_1048));
  const double s8_1054 = fnma(s8_1040, s8_1052, s8_1053);
  const double pivot_chassis_ty = fnma(s8_1042, s8_1052, fnma(s8_1017, s8_1049, s8_1050));
  result.inertia[1] = fnma(1e-12, s8_1034, pivot_chassis_ty);
  const double s8_1055 = 1.0/pivot_chassis_ty;
  const double s8_1056 = w3.s8_867[0] + fnma(s8_1052, s8_1045, fnma(s8_1049, w5.s8_950, s8_1051));
  const double s8_1057 = s8_1056 - w3.s8_867[1];
  const double s8_1058 = s8_994*w5.s8_924;
  const double s8_1059 = s8_1010*w5.s8_947;
  const double s8_1060 = s8_1021*s8_1022;
  const double s8_1061 = fnma(s8_1010, s8_1059, fnma(s8_994, s8_1058, s8_1025));
  const double s8_1062 = fnma(s8_1059, w5.s8_943, fma(s8_1058, w5.s8_940, w5.s8_987));
  const double s8_1063 = s8_1040*s8_1044;
  const double s8_1064 = s8_1054*s8_1055;
  const double s8_1065 = fnma(s8_1040, s8_1063, fnma(s8_1021, s8_1060, s8_1061));
  const double pivot_chassis_tx = fnma(s8_1054, s8_1064, s8_1065);
  const double s8_1066 = fnma(s8_1063, s8_1045, fnma(s8_1060, w5.s8_950, s8_1062));
  result.inertia[0] = fnma(1e-12, s8_1025, pivot_chassis_tx);

  // --- step 9: accelerations from the root to the leaves (63), (62), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1067 = w3.s8_865[1] + (w3.s8_865[0] + fnma(s8_1064, s8_1057, s8_1066));
  const double a_chassis_x = s8_1067*(1.0/pivot_chassis_tx);
  const double a_chassis_y = s8_1055*fnma(s8_1054, a_chassis_x, s8_1057);
  const double s1_38 = w6.sines[1];
  const double s9_6 = fnma(g_z, s1_38, a_chassis_x);
  const double a_chassis_z = s8_1044*fnma(s8_1042, a_chassis_y, fnma(s8_1040, a_chassis_x,
      s8_1045));
  const double s9_7 = fma(g_z, w4.R_chassis_z_y, a_chassis_y);
  const double s9_8 = fnma(s8_1017, a_chassis_y, fnma(s8_1021, a_chassis_x, w5.s8_950));
  const double s9_9 = fnma(s8_1013, a_chassis_y, fnma(s8_1010, a_chassis_x, w5.s8_943));
  const double s9_10 = fnma(s8_1007, a_chassis_y, fma(s8_994, a_chassis_x, w5.s8_940));
  const double s9_11 = fnma(w5.s8_801, a_chassis_y, fnma(w5.s8_802, a_chassis_x, w5.s8_808));
  const double s9_12 = fnma(w5.s8_790, a_chassis_y, fnma(w5.s8_789, a_chassis_x, w5.s8_795));
  const double s9_13 = fma(w4.s8_512, a_chassis_y, fnma(w4.s8_505, a_chassis_x, w5.s8_704));
  const double s9_14 = fma(w4.s8_566, a_chassis_y, fnma(w4.s8_568, a_chassis_x, w4.s8_578));
  const double s9_15 = fnma(w4.s8_235, a_chassis_y, fnma(w4.s8_567, a_chassis_x, w4.s8_577));
  const double alpha_chassis_x = s8_1022*fnma(s8_1004, a_chassis_z, s9_8);
  const double s9_16 = fma(g_z, w4.R_chassis_z_z, a_chassis_z);
  const double s9_17 = fma(w5.R_chassis_y_y, s9_7, w5.R_chassis_aux5_y_x*s9_6);
  result.zdd[Coordinate::chassis_ty] = fma(w5.R_chassis_y_z, s9_16, s9_17);
  const double s9_18 = fma(w5.R_chassis_x_y, s9_7, w5.R_chassis_aux5_x_x*s9_6);
  result.zdd[Coordinate::chassis_tx] = fma(w5.R_chassis_x_z, s9_16, s9_18);
  result.zdd[Coordinate::chassis_tz] = fma(w4.R_chassis_z_z, s9_16, fnma(s1_38, s9_6,
      w4.R_chassis_z_y*s9_7));
  const double s9_19 = fma(w5.s8_938, alpha_chassis_x, fma(s8_1002, a_chassis_z, s9_9));
  const double alpha_chassis_y = w5.s8_947*s9_19;
  const double s9_20 = fma(w5.s8_935, alpha_chassis_x, fma(s8_991, a_chassis_z, s9_10));
  const double s9_21 = alpha_chassis_y + w4.s9_5;
  const double s9_22 = fnma(w5.s8_804, alpha_chassis_x, fnma(w5.s8_803, a_chassis_z, s9_11));
  const double s9_23 = fnma(w5.s8_793, alpha_chassis_x, fnma(w5.s8_791, a_chassis_z, s9_12));
  const double s9_24 = fnma(w5.s8_686, alpha_chassis_x, fnma(w4.s8_510, a_chassis_z, s9_13));
  const double s9_25 = fnma(w4.s8_574, alpha_chassis_x, fnma(w4.s8_570, a_chassis_z, s9_14));
  const double s9_26 = fma(w4.s8_573, alpha_chassis_x, fma(w4.s8_569, a_chassis_z, s9_15));
  const double alpha_chassis_z = w5.s8_924*fma(w5.s8_914, alpha_chassis_y, s9_20);
  const double s9_27 = alpha_chassis_z + w4.s9_4;
  const double s9_28 = fnma(w5.s8_806, alpha_chassis_y, s9_22);
  const double s9_29 = fnma(w5.s8_794, alpha_chassis_y, s9_23);
  const double s9_30 = fnma(w5.s8_666, alpha_chassis_y, s9_24);
  const double s9_31 = fnma(w4.s8_576, alpha_chassis_y, s9_25);
  result.zdd[Coordinate::chassis_rz] = fma(w4.s1_37, s9_27, w4.s1_42*s9_21);
  result.zdd[Coordinate::chassis_rx] = fma(w4.s1_40, s9_27, fma(w4.s1_43, s9_21,
      alpha_chassis_x + w4.s9_3));
  const double s9_32 = w5.s8_904*fnma(w5.s8_805, alpha_chassis_z, s9_28);
  result.zdd[Coordinate::lower_arm_left] = s9_32;
  const double s9_33 = w4.s8_592*fnma(w4.s8_572, alpha_chassis_z, s9_31);
  result.zdd[Coordinate::arb_rear_left] = s9_33;
  result.zdd[Coordinate::chassis_ry] = fnma(w6.sines[2], s9_27, w6.cosines[2]*s9_21);
  const double s9_34 = fma(w4.s8_571, alpha_chassis_z, fnma(w4.s8_575, alpha_chassis_y, s9_26));
  const double s9_35 = w5.s8_798*fma(w5.s8_796, s9_32, fnma(w5.s8_792, alpha_chassis_z, s9_29));
  result.zdd[Coordinate::lower_arm_right] = s9_35;
  const double s9_36 = w4.s8_564*fnma(w4.s8_237, s9_33, s9_34);
  result.zdd[Coordinate::arb_rear_right] = s9_36;
  const double s9_37 = fnma(w5.s8_785, s9_32, fnma(w5.s8_688, alpha_chassis_z, s9_30));
  const double s9_38 = fma(w4.s3_8, s9_36, fma(w4.s3_7, s9_33, w3.zdd_star_rear_axle_ry));
  const double s9_39 = fnma(w4.s3_26, s9_36, fma(w4.s3_25, s9_33, w4.zdd_star_rear_axle_rx));
  result.zdd[Coordinate::rear_axle_tz] = fnma(w4.s3_2, s9_36, fnma(w4.s3_3, s9_33,
      w3.zdd_star_rear_axle_tz));
  const double s9_40 = fnma(w4.s3_11, s9_36, fma(w4.s3_12, s9_33, w3.zdd_star_rear_axle_rz));
  const double s9_41 = w5.s8_787*fnma(w5.s8_786, s9_35, s9_37);
  result.zdd[Coordinate::bell_crank] = s9_41;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double alpha_rear_axle_y = s9_38 + (w4.s8_22 + alpha_chassis_y);
  const double alpha_rear_axle_z = s9_39 + (w4.s8_21 + alpha_chassis_z);
  const double alpha_rear_axle_x = s9_40 + (w4.s8_23 + alpha_chassis_x);
  const double s9_42 = s9_40 + w3.s9_2;
  result.zdd[Coordinate::rear_axle_ty] = fnma(w4.s3_21, s9_33, fms(w4.s3_22, s9_36, w4.s6_62));
  const double s9_43 = fma(w3.s4_4, w3.s4_1, s9_38);
  const double s9_44 = fnma(state.zd[Coordinate::rear_axle_rz], w3.s4_6, s9_43);
  result.zdd[Coordinate::pitman_arm] = -fma(w4.s3_34, s9_41, w4.s6_122);
  const double s9_45 = w3.R_rear_axle_x_y*alpha_rear_axle_x;
  result.zdd[Coordinate::rear_axle_rx] = fma(w4.s1_34, s9_42, w4.s1_35*s9_44);
  result.zdd[Coordinate::rear_axle_rz] = fma(w4.s1_33, s9_42, fma(w4.s1_32, s9_44,
      s9_39 + w3.s9_1));
  const double s9_46 = fma(w3.R_rear_axle_y_y, alpha_rear_axle_y, s9_45);
  const double s9_47 = fma(w3.R_rear_axle_z_y, alpha_rear_axle_z, s9_46);
  result.zdd[Coordinate::rear_axle_ry] = fnma(w6.sines[9], s9_42, w6.cosines[9]*s9_44);
  const Pair s9_48 = fnma(w1.s4_22, w1.s4_30, w1.s4_28*w1.s4_23);
  const Pair s9_49 = fma(w1.s4_19, w1.s4_30, w1.s4_20*w1.s4_23);
  const Pair s9_50 = fma(w1.s4_19, w1.s4_28, w1.s4_20*w1.s4_22);
  const double s9_51 = fnma(s9_32, w3.s3_29[0], s9_41*w3.Rz_carrier_left_and_right_rz_2[0]);
  const double s9_52 = s9_51 - w2.s6_93[0];
  const double s9_53 = fnma(s9_35, w3.s3_29[1], w2.s6_93[1]);
  const double s9_54 = fma(s9_41, w3.Rz_carrier_left_and_right_rz_2[1], s9_53);
  const double s9_55 = fnma(s9_32, w3.s3_30[0], w2.zdd_star_carrier_left_and_right_ry[0]);
  const double s9_56 = fnma(s9_41, w3.s3_35[0], s9_55);
  const double s9_57 = fma(s9_35, w3.s3_30[1], w2.zdd_star_carrier_left_and_right_ry[1]);
  const double s9_58 = fma(s9_41, w3.s3_35[1], s9_57);
  const double s9_59 = fnma(s9_32, w3.s3_32[0], w2.zdd_star_carrier_left_and_right_rx[0]);
  const double s9_60 = fnma(s9_41, w3.s3_36[0], s9_59);
  const double s9_61 = fma(s9_35, w3.s3_32[1], w2.zdd_star_carrier_left_and_right_rx[1]);
  const double s9_62 = fma(s9_41, w3.s3_36[1], s9_61);
  const Pair s9_63 = fma(w1.s4_26, w1.s4_25, w1.s4_24*w1.s4_27);
  const Pair s9_64 = fma(w1.s4_18, w1.s4_26, w1.s0_14*w1.s4_24);
  const Pair s9_65 = w1.s0_14*w1.s4_26;
  const Pair s9_66 = w1.s0_14*w1.s4_27;
  const Pair s9_67 = fnma(w1.s0_14, w1.s4_25, w1.s4_18*w1.s4_27);
  const double s9_68 = s9_52 + s9_63[0] - s9_48[0];
  const double s9_69 = s9_48[1] + (s9_54 - s9_63[1]);
  const double s9_70 = s9_49[0] + (s9_60 + s9_66[0] - s9_67[0]);
  const double s9_71 = s9_49[1] + (s9_62 + s9_66[1] - s9_67[1]);
  const double s9_72 = s9_56 + s9_65[0] - s9_64[0] - s9_50[0];
  const double s9_73 = s9_50[1] + (s9_64[1] - s9_58 - s9_65[1]);
  const double s9_74 = fma(s9_70, w1.R_carrier_left_and_right_aux1_y_x[0], w6.cosines[3]*s9_68);
  result.zdd[Coordinate::carrier_left_rx] = fma(s9_72, w1.R_carrier_left_and_right_aux1_z_x[0],
      s9_74);
  result.zdd[Coordinate::carrier_left_ry] = fma(s9_72, w1.s1_25[0], fnma(s9_68, w1.s1_22[0],
      s9_70*w1.s1_23[0]));
  result.zdd[Coordinate::carrier_right_ry] = fnma(s9_73, w1.s1_25[1], fma(s9_71, w1.s1_23[1],
      s9_69*w1.s1_22[1]));
  result.zdd[Coordinate::carrier_left_rz] = fma(s9_68, w1.s1_21[0], fnma(s9_70, w1.s1_24[0],
      s9_72*w1.s1_26[0]));
  result.zdd[Coordinate::carrier_right_rz] = fma(s9_69, w1.s1_21[1], fma(s9_73, w1.s1_26[1],
      s9_71*w1.s1_24[1]));
  const double s1_44 = w1.R_carrier_left_and_right_aux1_y_x[1];
  const double s1_45 = w1.R_carrier_left_and_right_aux1_z_x[1];
  result.zdd[Coordinate::carrier_right_rx] = fma(s9_73, s1_45, fnma(s9_71, s1_44,
      w6.cosines[5]*s9_69));
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double alpha_carrier_left_x = w2.s8_107[0] + (s9_52 + (alpha_chassis_x + s9_32));
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double alpha_carrier_right_x = s9_54 + (alpha_chassis_x + s9_35) - w2.s8_107[1];
  const double s9_75 = 0.09090909090909091*tau[Coordinate::wheel_front_left];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double alpha_carrier_left_y = w2.s8_106[0] + (alpha_chassis_y + s9_60);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double alpha_carrier_right_y = w2.s8_106[1] + (alpha_chassis_y + s9_62);
  const double s9_76 = fma(alpha_carrier_left_x, w1.s1_19[0], s9_75);
  const double s1_46 = w1.R_carrier_left_and_right_aux2_y_y[0];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double alpha_carrier_left_z = alpha_chassis_z + s9_56 - w2.s8_105[0];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double alpha_carrier_right_z = w2.s8_105[1] + (alpha_chassis_z - s9_58);
  const double s9_77 = fnma(alpha_carrier_left_y, s1_46, s9_76);
  const double s1_47 = w1.R_carrier_left_and_right_aux2_z_y[0];
  result.zdd[Coordinate::wheel_front_left] = fnma(alpha_carrier_left_z, s1_47, s9_77);
  const double s9_78 = 0.09090909090909091*tau[Coordinate::wheel_front_right];
  const double s9_79 = fnma(alpha_carrier_right_x, w1.s1_19[1], s9_78);
  const double s1_48 = w1.R_carrier_left_and_right_aux2_y_y[1];
  const double s9_80 = fnma(alpha_carrier_right_y, s1_48, s9_79);
  const double s1_49 = w1.R_carrier_left_and_right_aux2_z_y[1];
  result.zdd[Coordinate::wheel_front_right] = fma(alpha_carrier_right_z, s1_49, s9_80);
  result.inertia[7] = w5.s8_799 - w3.s8_807[1];
  result.inertia[6] = w5.s8_905 - w3.s8_807[0];
  const double R_chassis_aux5_z_z = w6.cosines[1];
  const double s9_81 = fms(R_chassis_aux5_z_z, R_chassis_aux5_z_z, 1e-12);
  result.inertia[4] = mbgen::min(w5.s8_946, s9_81);
  result.zdd[Coordinate::upper_arm_left] = fnma(s9_32, w3.s3_28[0], w2.s6_92[0]);
  result.zdd[Coordinate::upper_arm_right] = -fma(s9_35, w3.s3_28[1], w2.s6_92[1]);
  const double s6_123 = w3.zdd_star_arb_front_left_and_right[0];
  const double s6_124 = w3.zdd_star_arb_front_left_and_right[1];
  const double s9_82 = fma(s9_32, w3.Rz_arb_front_left_0_and_right_1[0], s6_123);
  result.zdd[Coordinate::arb_front_left] = fma(s9_41, w3.Rz_arb_front_left_and_right_2[0], s9_82);
  const double s9_83 = fnma(s9_35, w3.Rz_arb_front_left_0_and_right_1[1], s6_124);
  result.zdd[Coordinate::arb_front_right] = fnma(s9_41, w3.Rz_arb_front_left_and_right_2[1], s9_83);

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s2_197 = 16.504892200367603*std::abs(w3.pivot_arb_front_left_and_right[1]);
  const double s2_198 = 16.679425973935604*std::abs(w3.pivot_arb_front_left_and_right[0]);
  const double s2_199 = 2.7028647671567816*std::abs(w1.pivot_carrier_left_and_right_rx[1]);
  const double s2_200 = mbgen::min(s2_199, mbgen::min(s2_198, mbgen::min(w4.s2_195, s2_197)));
  const double s2_201 = 2.7028647671567816*std::abs(w2.pivot_carrier_left_and_right_rz[1]);
  const double s2_202 = mbgen::min(s2_200, 6.8514628664707224*std::abs(w2.s2_145[1]));
  const double s2_203 = 3.405476531191585*std::abs(w2.s2_155[1]);
  const double s2_204 = 2.7028219055711094*std::abs(w1.pivot_carrier_left_and_right_rx[0]);
  const double s2_205 = mbgen::min(s2_204, mbgen::min(mbgen::min(s2_202, s2_201), s2_203));
  const double s2_206 = 2.7028219055711094*std::abs(w2.pivot_carrier_left_and_right_rz[0]);
  const double s2_207 = mbgen::min(6.915894223167946*std::abs(w2.s2_145[0]), s2_205);
  const double s2_208 = 3.3636363636363633*std::abs(w2.s2_155[0]);
  const double s2_209 = mbgen::min(s2_208, mbgen::min(s2_206, s2_207));
  const double s9_84 = mbgen::min(s2_209, std::abs(w6.cosines[4]));
  result.pivot[0] = mbgen::min(std::abs(w6.cosines[6]), s9_84);
  result.pivot[1] = mbgen::min(w4.s2_184, std::abs(w6.cosines[10]));
  const double s9_85 = fma(s9_33, w2.Rz_rear_axle_tx_1_and_0[1], w4.zdd_star_rear_axle_tx);
  result.zdd[Coordinate::rear_axle_tx] = fma(s9_36, w2.Rz_rear_axle_tx_1_and_0[0], s9_85);
  result.zdd[Coordinate::wheel_rear_left] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_left], s9_47);
  result.zdd[Coordinate::wheel_rear_right] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_right], s9_47);
  // operations of step 1: poses and axes b: 38 add, 108 multiply, 4 divide, 44 sin cos
  // operations of step 4: velocities: 27 add, 30 multiply
  // operations of step 7: inertias of the bodies and forces on joints: 12 add, 18 multiply
  // operations of step 8: elimination from the leaves to the root (63): 668 add, 564 multiply, 6
  // divide
  // operations of step 2: closure Jacobian Phi_z and its factors (60), long_rod_left ..
  // arb_link_rear_right: 154 add, 183 multiply, 12 divide, 11 other
  // operations of step 3: Rz (61), long_rod_left .. arb_link_rear_right: 20 add, 42 multiply
  // operations of step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right: 140 add, 170
  // multiply
  // operations of step 7: inertias of the bodies and forces on joints, long_rod_left ..
  // arb_link_rear_right: 25 add, 51 multiply
  // operations of step 8: elimination from the leaves to the root (63), long_rod_left ..
  // arb_link_rear_right: 613 add, 662 multiply, 2 divide
  // operations of step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left ..
  // tie_rod_right: 110 add, 139 multiply, 11 divide, 21 other
  // operations of step 3: Rz (61), upper_ball_left .. tie_rod_right: 20 add, 41 multiply
  // operations of step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right: 125 add, 171
  // multiply
  // operations of step 7: inertias of the bodies and forces on joints, upper_ball_left ..
  // tie_rod_right: 116 add, 184 multiply
  // operations of step 8: elimination from the leaves to the root (63), upper_ball_left ..
  // tie_rod_right: 855 add, 914 multiply, 3 divide
  // operations of step 9: accelerations from the root to the leaves (63), (62): 180 add, 187
  // multiply, 7 other
}

/// All accelerations with the frozen partition of the loop blocks.
void compute_accelerations(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, const double* tau, Accelerations& __restrict result) noexcept {
  AccelerationsWork1 w1;
  AccelerationsWork2 w2;
  AccelerationsWork3 w3;
  AccelerationsWork4 w4;
  AccelerationsWork5 w5;
  AccelerationsWork6 w6;
  compute_accelerations_1(state, w1, w3, w6, result);
  compute_accelerations_2(state, tau, w1, w3, w4, w6);
  compute_accelerations_3(state, tau, w1, w2, w4, w6);
  compute_accelerations_4(state, tau, w1, w2, w3, w4, w6);
  compute_accelerations_5(tau, w1, w2, w3, w4, w6);
  compute_accelerations_6(state, tau, w1, w2, w3, w4, w5, w6, result);
  compute_accelerations_7(tau, w1, w2, w3, w4, w5, w6, result);
  compute_accelerations_8(state, tau, w1, w2, w3, w4, w5, w6, result);
}

/// Result of compute_closure.
struct Closure {
  double residual[17];  ///< of every closure equation, block after block, then of every motion
  double dz[32];  ///< Newton correction; driven coordinates go to their motions
  double zd[32];  ///< consistent velocities
  double pivot[2];  ///< smallest pivot of each block over its reference
  double Rz[58];  ///< free directions of each block, row by row
};

/// Values of compute_closure that cross its parts.
struct ClosureWork1 {
  double
      R_carrier_right_aux2_y_y, R_carrier_right_aux1_y_x, s1_16, R_carrier_right_aux2_z_y,
      R_carrier_right_aux1_z_x, s2_37, s2_107, s2_109, s2_118, s2_120, s2_36, s2_123, s2_136,
      s2_138, s3_4, s4_10, s4_11, s2_191, s2_26, s2_29, s2_96, s2_100, s2_104, s2_110, s2_128,
      s2_129, s2_130, s2_131, s2_141, s3_7, s3_1, s3_10, s2_188, s4_12, s2_189, s2_190, s2_193,
      s3_11;
};

/// Values of compute_closure that cross its parts.
struct ClosureWork2 {
  double
      sines[19], cosines[19];
};

/// Part 1 of compute_closure: step 1: poses and axes b; step 2: closure Jacobian Phi_z and its
/// factors (60); step 4: velocities; step 3: Rz (61).
[[gnu::noinline]] void compute_closure_1(const State& state, ClosureWork1& __restrict w1,
    ClosureWork2& __restrict w2, Closure& __restrict result) noexcept {
  // Results that need no operation.
  for (int k = 0; k < 42; ++k) result.Rz[k] = 0.0;
  result.Rz[0] = 1.0;
  result.Rz[19] = 1.0;
  result.Rz[41] = 1.0;
  result.Rz[46] = 1.0;
  result.Rz[47] = 0.0;
  result.Rz[52] = 0.0;
  result.Rz[53] = 1.0;
  for (int k = 0; k < 32; ++k) result.dz[k] = 0.0;
  result.zd[Coordinate::chassis_tx] = state.zd[Coordinate::chassis_tx];
  result.zd[Coordinate::chassis_ty] = state.zd[Coordinate::chassis_ty];
  result.zd[Coordinate::chassis_tz] = state.zd[Coordinate::chassis_tz];
  result.zd[Coordinate::chassis_rz] = state.zd[Coordinate::chassis_rz];
  result.zd[Coordinate::chassis_ry] = state.zd[Coordinate::chassis_ry];
  result.zd[Coordinate::chassis_rx] = state.zd[Coordinate::chassis_rx];
  result.zd[Coordinate::lower_arm_left] = state.zd[Coordinate::lower_arm_left];
  result.zd[Coordinate::wheel_front_left] = state.zd[Coordinate::wheel_front_left];
  result.zd[Coordinate::lower_arm_right] = state.zd[Coordinate::lower_arm_right];
  result.zd[Coordinate::wheel_front_right] = state.zd[Coordinate::wheel_front_right];
  result.zd[Coordinate::bell_crank] = state.zd[Coordinate::bell_crank];
  result.zd[Coordinate::rear_axle_tz] = state.zd[Coordinate::rear_axle_tz];
  result.zd[Coordinate::rear_axle_rx] = state.zd[Coordinate::rear_axle_rx];
  result.zd[Coordinate::wheel_rear_left] = state.zd[Coordinate::wheel_rear_left];
  result.zd[Coordinate::wheel_rear_right] = state.zd[Coordinate::wheel_rear_right];

  // --- step 1: poses and axes b ---
  const double angles[] = {
      state.z[Coordinate::lower_arm_left], state.z[Coordinate::carrier_left_rz],
      state.z[Coordinate::carrier_left_rx], state.z[Coordinate::carrier_left_ry],
      state.z[Coordinate::upper_arm_left], state.z[Coordinate::arb_front_left],
      state.z[Coordinate::lower_arm_right], state.z[Coordinate::carrier_right_rz],
      state.z[Coordinate::carrier_right_rx], state.z[Coordinate::carrier_right_ry],
      state.z[Coordinate::upper_arm_right], state.z[Coordinate::arb_front_right],
      state.z[Coordinate::pitman_arm], state.z[Coordinate::bell_crank],
      state.z[Coordinate::rear_axle_rz], state.z[Coordinate::rear_axle_ry],
      state.z[Coordinate::rear_axle_rx], state.z[Coordinate::arb_rear_left],
      state.z[Coordinate::arb_rear_right]};
  mbgen::sincos(angles, w2.sines, w2.cosines);

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  const double s2_1 = -p_drag_link_from_z*w2.sines[12];
  const double R_bell_crank_y_x = w2.sines[13];
  const double s2_2 = p_drag_link_to_y*R_bell_crank_y_x;
  const double s2_3 = s2_2 + (1.15 - s2_1);
  const double s2_4 = -p_drag_link_from_z*w2.cosines[12];
  const double s2_5 = 0.2 - s2_4;
  const double s2_6 = 0.8565801464479954*s2_5;
  const double s2_7 = 0.8565801464479954*s2_3;
  const double pivot_pitman_arm = fnma(s2_4, s2_7, s2_1*s2_6);
  const double R_bell_crank_x_x = w2.cosines[13];
  const double s2_8 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s2_9 = p_pitman_arm_y - s2_8;
  const double s2_10 = 0.8565801464479954*s2_9;
  const double s2_11 = 0.5*fma(s2_9, s2_10, fma(s2_3, s2_7, fms(s2_5, s2_6, l_drag_link)));
  result.residual[8] = s2_11;

  // --- step 1: poses and axes b, continued ---
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = w2.cosines[0];
  const double R_carrier_left_aux1_x_x = w2.cosines[1];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = w2.sines[0];
  const double s1_1 = w2.cosines[2];
  const double s1_2 = w2.sines[2];
  const double s1_3 = fma(R_carrier_left_aux1_y_y, s1_2, R_lower_arm_left_z_y*s1_1);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_2,
      R_carrier_left_aux1_y_y*s1_1);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_4 = w2.sines[1];
  const double R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_4;
  const double s1_5 = w2.cosines[3];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_6 = w2.sines[3];
  const double R_carrier_left_y_x = fma(s1_3, s1_6, R_carrier_left_aux1_y_x*s1_5);
  const double R_carrier_left_y_z = fnma(s1_3, s1_5, R_carrier_left_aux1_y_x*s1_6);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = w2.cosines[6];
  const double R_carrier_right_aux1_x_x = w2.cosines[7];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = w2.sines[6];
  const double s1_7 = w2.cosines[8];
  const double s1_8 = w2.sines[8];
  const double s1_9 = fma(R_carrier_right_aux1_y_y, s1_8, R_lower_arm_right_z_y*s1_7);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  w1.R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_8, R_carrier_right_aux1_y_y*s1_7);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_10 = w2.sines[7];
  w1.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_10;
  const double s1_11 = w2.cosines[9];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_12 = w2.sines[9];
  const double R_carrier_right_y_x = fma(s1_9, s1_12, w1.R_carrier_right_aux1_y_x*s1_11);
  const double R_carrier_right_y_z = fnma(s1_9, s1_11, w1.R_carrier_right_aux1_y_x*s1_12);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux2_x_z = s1_4*s1_2;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_6,
      R_carrier_left_aux1_x_x*s1_5);
  const double R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_6,
      R_carrier_left_aux2_x_z*s1_5);
  const double s1_13 = s1_4*s1_1;
  const double s2_12 = p_arb_link_front_left_to_x*R_carrier_left_x_x;
  const double s2_13 = fnma(p_arb_link_front_left_to_y, s1_13 + R_carrier_left_x_z, s2_12);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_2,
      R_lower_arm_left_y_y*s1_1);
  const double R_carrier_left_aux2_z_y = fma(R_lower_arm_left_y_y, s1_2,
      R_carrier_left_aux1_z_y*s1_1);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_4;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_6,
      R_carrier_left_aux1_z_x*s1_5);
  const double R_carrier_left_z_z = fma(R_carrier_left_aux1_z_x, s1_6,
      R_carrier_left_aux2_z_z*s1_5);
  const double s2_14 = p_arb_link_front_left_to_x*R_carrier_left_z_x;
  const double s2_15 = R_carrier_left_z_z - R_carrier_left_aux2_z_y;
  const double s2_16 = fnma(p_arb_link_front_left_to_y, s2_15, s2_14);
  const double s1_14 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_15 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_14);
  const double R_arb_front_left_x_x = w2.cosines[5];
  const double R_arb_front_left_x_z = w2.sines[5];
  const double s2_17 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  const double s2_18 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s2_17);
  const double s2_19 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s2_20 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s2_19);
  const double s2_21 = 0.35 + s2_20 - s2_13;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double r_carrier_left_aux1_z = s1_15 + p_lower_arm_left_z;
  const double s2_22 = s2_18 + p_arb_front_left_z - r_carrier_left_aux1_z - s2_16;
  const double s2_23 = 3.846153846153846*s2_21;
  const double s2_24 = 3.846153846153846*s2_22;
  const double pivot_arb_front_left = fnma(s2_20, s2_24, s2_18*s2_23);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux2_x_z = s1_10*s1_8;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_12,
      R_carrier_right_aux1_x_x*s1_11);
  const double R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_12,
      R_carrier_right_aux2_x_z*s1_11);
  w1.s1_16 = s1_10*s1_7;
  const double s2_25 = p_arb_link_front_right_to_x*R_carrier_right_x_x;
  w1.s2_26 = fnma(p_arb_link_front_left_to_y, R_carrier_right_x_z - w1.s1_16, s2_25);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_8,
      R_lower_arm_right_y_y*s1_7);
  w1.R_carrier_right_aux2_z_y = fma(R_lower_arm_right_y_y, s1_8, R_carrier_right_aux1_z_y*s1_7);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  w1.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_10;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_12,
      w1.R_carrier_right_aux1_z_x*s1_11);
  const double R_carrier_right_z_z = fma(w1.R_carrier_right_aux1_z_x, s1_12,
      R_carrier_right_aux2_z_z*s1_11);
  const double s2_27 = w1.R_carrier_right_aux2_z_y + R_carrier_right_z_z;
  const double s2_28 = p_arb_link_front_right_to_x*R_carrier_right_z_x;
  w1.s2_29 = fnma(p_arb_link_front_left_to_y, s2_27, s2_28);
  const double s1_17 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  const double s1_18 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_17);
  const double R_arb_front_right_x_x = w2.cosines[11];
  const double R_arb_front_right_x_z = w2.sines[11];
  const double s2_30 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  const double s2_31 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s2_30);
  const double s2_32 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s2_33 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s2_32);
  const double s2_34 = 0.35 + s2_33 - w1.s2_26;
  const double s1_19 = s1_18 - p_lower_arm_right_z;

  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  const double s2_35 = s2_31 + (s1_19 + p_arb_front_right_z) - w1.s2_29;
  w1.s2_36 = 3.846153846153846*s2_34;
  w1.s2_37 = 3.846153846153846*s2_35;
  const double pivot_arb_front_right = fnma(s2_33, w1.s2_37, s2_31*w1.s2_36);
  const double s2_38 = p_tie_rod_left_to_z*R_carrier_left_x_z;
  const double s2_39 = -p_carrier_left_upper_ball_y*s1_13;
  const double s2_40 = fma(p_carrier_left_upper_ball_z, R_carrier_left_x_z, s2_39);
  result.residual[0] = s2_40;
  const double s2_41 = s2_39 + fma(p_tie_rod_left_to_x, R_carrier_left_x_x, s2_38);
  const double s2_42 = p_tie_rod_left_to_z*R_carrier_left_z_z;
  const double s2_43 = -p_carrier_left_upper_ball_y*R_carrier_left_aux2_z_y;
  const double s2_44 = fms(p_carrier_left_upper_ball_z, R_carrier_left_z_z, s2_43);
  const double s2_45 = fma(p_tie_rod_left_to_x, R_carrier_left_z_x, s2_42) - s2_43;
  const double s1_20 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  const double s1_21 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_20);
  const double s2_46 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_47 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_46);
  const double s2_48 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_46);
  const double s2_49 = s2_47 + (0.35 + s2_41);
  const double s2_50 = p_tie_rod_left_to_z*R_carrier_left_y_z;
  const double s2_51 = -p_carrier_left_upper_ball_y*R_carrier_left_aux2_y_y;
  const double s2_52 = fma(p_tie_rod_left_to_x, R_carrier_left_y_x, s2_50) - s2_51;
  const double s2_53 = fms(p_carrier_left_upper_ball_z, R_carrier_left_y_z, s2_51);
  const double s2_54 = p_arb_link_front_left_to_x*R_carrier_left_y_x;
  const double s2_55 = R_carrier_left_y_z - R_carrier_left_aux2_y_y;
  const double s2_56 = fnma(p_arb_link_front_left_to_y, s2_55, s2_54);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double r_carrier_left_aux1_y = p_lower_arm_left_y + s1_21;
  const double s2_57 = p_tie_rod_left_from_y*R_bell_crank_x_x;
  const double s2_58 = fma(p_tie_rod_left_from_x, R_bell_crank_y_x, s2_57);
  const double s2_59 = fnma(p_tie_rod_left_from_x, R_bell_crank_y_x, s2_57);
  const double s2_60 = s2_58 - r_carrier_left_aux1_y - s2_52;
  const double s2_61 = 1.262590031797617*s2_60;
  const double s2_62 = 1.262590031797617*s2_49;
  const double s2_63 = fnma(s2_62, s2_58, s2_47*s2_61);
  // tie_rod_left
  const double s2_64 = s2_45 + (r_carrier_left_aux1_z - p_bell_crank_z);
  const double s2_65 = 1.262590031797617*s2_64;
  const double s2_66 = fma(s2_60, s2_61, fma(s2_49, s2_62, fms(s2_64, s2_65, l_tie_rod_left)));
  const double s2_67 = 0.5*s2_66;
  result.residual[9] = s2_67;
  const double s2_68 = fnma(s2_45, s2_62, s2_41*s2_65);
  const double s2_69 = fma(s2_41, s2_61, s2_62*s2_52);
  const double s2_70 = fma(s2_45, s2_61, s2_65*s2_52);
  const double s2_71 = s2_70 + fma(s1_15, s2_61, s1_21*s2_65);
  const double s2_72 = fma(R_carrier_left_aux1_z_x, s2_69, R_carrier_left_aux1_y_x*s2_68);
  const double s2_73 = fnma(R_carrier_left_aux1_x_x, s2_70, s2_72);
  const double s2_74 = fnma(R_lower_arm_left_z_y, s2_68, R_lower_arm_left_y_y*s2_69);
  const double s2_75 = fma(R_carrier_left_aux2_z_y, s2_69, R_carrier_left_aux2_y_y*s2_68);
  const double s2_76 = fma(s1_13, s2_70, s2_75);
  const double s2_77 = p_tie_rod_right_to_z*R_carrier_right_z_z;
  const double s2_78 = p_carrier_right_upper_ball_y*w1.R_carrier_right_aux2_z_y;
  const double s2_79 = fma(p_carrier_right_upper_ball_z, R_carrier_right_z_z, s2_78);
  const double s2_80 = s2_78 + fma(p_tie_rod_right_to_x, R_carrier_right_z_x, s2_77);
  const double s2_81 = p_tie_rod_right_to_z*R_carrier_right_x_z;
  const double s2_82 = p_carrier_right_upper_ball_y*w1.s1_16;
  const double s2_83 = fms(p_carrier_right_upper_ball_z, R_carrier_right_x_z, s2_82);
  result.residual[3] = s2_83;
  const double s2_84 = fma(p_tie_rod_right_to_x, R_carrier_right_x_x, s2_81) - s2_82;
  const double s1_22 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  const double s1_23 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_22);
  const double s2_85 = s2_48 - 0.35 - s2_84;
  const double s2_86 = s2_80 + (-p_bell_crank_z - s1_19);
  const double s2_87 = 1.262590031797617*s2_85;
  const double s2_88 = 1.262590031797617*s2_86;
  const double s2_89 = fma(s2_84, s2_88, s2_80*s2_87);
  const double s2_90 = p_tie_rod_right_to_z*R_carrier_right_y_z;
  const double s2_91 = p_carrier_right_upper_ball_y*w1.R_carrier_right_aux2_y_y;
  const double s2_92 = s2_91 + fma(p_tie_rod_right_to_x, R_carrier_right_y_x, s2_90);
  const double s2_93 = fma(p_carrier_right_upper_ball_z, R_carrier_right_y_z, s2_91);
  const double s2_94 = w1.R_carrier_right_aux2_y_y + R_carrier_right_y_z;
  const double s2_95 = p_arb_link_front_right_to_x*R_carrier_right_y_x;
  w1.s2_96 = fnma(p_arb_link_front_left_to_y, s2_94, s2_95);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double r_carrier_right_aux1_y = s1_23 + p_lower_arm_right_y;
  // tie_rod_right
  const double s2_97 = s2_59 + (r_carrier_right_aux1_y + s2_92);
  const double s2_98 = 1.262590031797617*s2_97;
  const double s2_99 = fma(s2_84, s2_98, s2_87*s2_92);
  w1.s2_100 = fnma(s2_48, s2_98, s2_87*s2_59);
  const double s2_101 = fnma(s2_88, s2_92, s2_80*s2_98);
  const double s2_102 = fma(s2_97, s2_98, fma(s2_86, s2_88, fms(s2_85, s2_87, l_tie_rod_right)));
  const double s2_103 = 0.5*s2_102;
  result.residual[10] = s2_103;
  w1.s2_104 = fnma(s1_18, s2_98, fnma(s1_23, s2_88, s2_101));
  const double pivot_carrier_right_rz = fma(R_lower_arm_right_y_y, s2_99,
      R_lower_arm_right_z_y*s2_89);
  const double s2_105 = w1.R_carrier_right_aux1_y_x*s2_89;
  const double s2_106 = fnma(w1.R_carrier_right_aux1_z_x, s2_99, s2_105);
  w1.s2_107 = fma(R_carrier_right_aux1_x_x, s2_101, s2_106);
  const double s2_108 = w1.R_carrier_right_aux2_y_y*s2_89;
  w1.s2_109 = fnma(w1.s1_16, s2_101, fnma(w1.R_carrier_right_aux2_z_y, s2_99, s2_108));
  w1.s2_110 = 1.0/pivot_arb_front_right;
  const double s2_111 = 1.0/pivot_pitman_arm;

  // --- step 4: velocities ---

  // --- step 3: Rz (61) ---
  w1.s3_1 = fma(s2_2, s2_10, s2_7*s2_8)*s2_111;
  const double s2_112 = 4.291271972095581*std::abs(pivot_arb_front_right);
  result.dz[Coordinate::pitman_arm] = -(s2_11*s2_111);

  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  const double s2_113 = 1.0/pivot_arb_front_left;
  const double s2_114 = mbgen::min(s2_112, 4.625980413576839*std::abs(pivot_pitman_arm));
  const double R_upper_arm_right_z_y = w2.sines[10];
  const double R_upper_arm_right_y_y = w2.cosines[10];
  const double s2_115 = -p_upper_arm_right_ball_z*R_upper_arm_right_z_y;
  const double s2_116 = fma(p_upper_arm_right_ball_y, R_upper_arm_right_y_y, s2_115);
  const double s2_117 = mbgen::min(4.336650753223258*std::abs(pivot_arb_front_left), s2_114);
  w1.s2_118 = 1.0/pivot_carrier_right_rz;
  const double s2_119 = mbgen::min(3.3503257942070226*std::abs(s2_116), s2_117);
  w1.s2_120 = fma(R_lower_arm_right_y_y, s2_93, R_lower_arm_right_z_y*s2_79)*w1.s2_118;
  const double s2_121 = w1.R_carrier_right_aux2_y_y*s2_79;
  const double s2_122 = fnma(w1.R_carrier_right_aux2_z_y, s2_93, s2_121);
  const double pivot_carrier_right_ry = fnma(w1.s2_109, w1.s2_120, s2_122);
  w1.s2_123 = 1.0/pivot_carrier_right_ry;
  const double s2_124 = mbgen::min(5.556930741705859*std::abs(pivot_carrier_right_rz), s2_119);
  const double s2_125 = -p_upper_arm_right_ball_z*R_upper_arm_right_y_y;
  const double s2_126 = fnma(p_upper_arm_right_ball_y, R_upper_arm_right_z_y, s2_125);
  const double s2_127 = s2_126 + (s2_79 + (-p_upper_arm_right_z - s1_19));
  result.residual[5] = s2_127;
  w1.s2_128 = fnma(w1.R_carrier_right_aux1_y_x, s2_83, R_carrier_right_aux1_x_x*s2_93);
  w1.s2_129 = fma(w1.s1_16, s2_93, w1.R_carrier_right_aux2_y_y*s2_83);
  w1.s2_130 = R_lower_arm_right_z_y*s2_83;
  w1.s2_131 = 1.0/s2_116;
  const double s2_132 = s2_126*w1.s2_131;
  const double s2_133 = w1.s2_118*fnma(w1.s2_130, s2_132, R_lower_arm_right_y_y*s2_83);
  const double s2_134 = w1.R_carrier_right_aux1_y_x*s2_79;
  const double s2_135 = fnma(w1.R_carrier_right_aux1_z_x, s2_93, s2_134);
  w1.s2_136 = fnma(w1.s2_107, w1.s2_120, s2_135);
  const double s2_137 = fma(w1.s1_16, s2_79, w1.R_carrier_right_aux2_z_y*s2_83);
  w1.s2_138 = w1.s2_123*fma(w1.s2_109, s2_133, fma(w1.s2_129, s2_132, s2_137));
  const double s4_1 = fma(s2_103, w1.s2_120, s2_83);
  const double s2_139 = fnma(R_carrier_right_aux1_x_x, s2_79, w1.R_carrier_right_aux1_z_x*s2_83);
  const double s2_140 = fma(w1.s2_107, s2_133, fnma(w1.s2_128, s2_132, s2_139));
  const double pivot_carrier_right_rx = fnma(w1.s2_136, w1.s2_138, s2_140);
  w1.s2_141 = 1.0/pivot_carrier_right_rx;
  const double s2_142 = mbgen::min(2.6620449619787987*std::abs(pivot_carrier_right_ry), s2_124);
  const double R_upper_arm_left_y_y = w2.cosines[4];
  const double R_upper_arm_left_z_y = w2.sines[4];
  const double s2_143 = p_upper_arm_left_ball_y*R_upper_arm_left_y_y;
  const double s2_144 = fnma(p_upper_arm_left_ball_z, R_upper_arm_left_z_y, s2_143);
  const double s2_145 = mbgen::min(s2_142, 2.732781487945307*std::abs(pivot_carrier_right_rx));
  const double s2_146 = 1.0/s2_73;
  const double s2_147 = mbgen::min(3.3514772255331233*std::abs(s2_144), s2_145);
  const double s2_148 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_149 = fma(p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s2_148);
  const double s2_150 = s2_44 + (r_carrier_left_aux1_z - p_upper_arm_left_z - s2_149);
  result.residual[2] = s2_150;
  const double s2_151 = fnma(R_carrier_left_aux1_y_x, s2_40, R_carrier_left_aux1_x_x*s2_53);
  const double s2_152 = fma(s1_13, s2_53, R_carrier_left_aux2_y_y*s2_40);
  const double s2_153 = 1.0/s2_144;
  const double s2_154 = s2_149*s2_153;
  const double s2_155 = fnma(R_carrier_left_aux1_x_x, s2_44, R_carrier_left_aux1_z_x*s2_40);
  const double s2_156 = s2_146*fma(s2_151, s2_154, s2_155);
  const double s2_157 = fnma(s2_152, s2_154, fma(s1_13, s2_44, R_carrier_left_aux2_z_y*s2_40));
  const double pivot_carrier_left_ry = fnma(s2_76, s2_156, s2_157);
  const double s2_158 = 1.0/pivot_carrier_left_ry;
  const double s2_159 = mbgen::min(15.714736645766752*std::abs(s2_73), s2_147);
  const double s2_160 = fnma(R_carrier_left_aux1_z_x, s2_53, R_carrier_left_aux1_y_x*s2_44);
  const double s2_161 = s2_160*s2_146;
  const double s2_162 = R_lower_arm_left_z_y*s2_40;
  const double s2_163 = fnma(s2_74, s2_156, fma(s2_162, s2_154, R_lower_arm_left_y_y*s2_40));
  const double s2_164 = fnma(R_carrier_left_aux2_z_y, s2_53, R_carrier_left_aux2_y_y*s2_44);
  const double s2_165 = fnma(s2_76, s2_161, s2_164)*s2_158;
  const double s2_166 = fma(R_lower_arm_left_y_y, s2_53, R_lower_arm_left_z_y*s2_44);
  const double s2_167 = fma(s2_163, s2_165, fma(s2_74, s2_161, s2_166));
  const double s2_168 = 1.0/s2_167;
  const double s2_169 = mbgen::min(5.864463449986124*std::abs(pivot_carrier_left_ry), s2_159);
  result.pivot[0] = mbgen::min(0.43888841273380513*std::abs(s2_167), s2_169);
  const double s2_170 = s2_53 + (r_carrier_left_aux1_y - p_upper_arm_left_y - s2_144);
  result.residual[1] = s2_170;
  const double s2_171 = 0.72 - r_carrier_left_aux1_y - s2_56;
  const double s2_172 = s1_21 + s2_53;
  const double s4_2 = fma(s2_67, s2_156, fma(s2_150, s2_154, s2_170));
  const double s2_173 = fma(s2_71, s2_156, fms(s2_172, s2_154, s1_15) - s2_44);
  const double s2_174 = s2_63*s2_156;
  const double s4_3 = s2_168*fnma(s2_67, s2_161, fms(s2_165, s4_2, s2_40));
  const double s4_4 = s2_158*fms(s2_163, s4_3, s4_2);
  result.dz[Coordinate::carrier_left_ry] = s4_4;
  const double s4_5 = s2_146*fnma(s2_74, s4_3, fms(s2_76, s4_4, s2_67));
  const double s4_6 = s2_153*fma(s2_151, s4_5, fma(s2_152, s4_4, fms(s2_162, s4_3, s2_150)));
  result.dz[Coordinate::upper_arm_left] = -s4_6;
  const double s2_175 = 3.846153846153846*s2_171;
  const double s2_176 = fma(s2_22, s2_24, fms(s2_21, s2_23, l_arb_link_front_left));
  const double s2_177 = 0.5*fma(s2_171, s2_175, s2_176);
  result.residual[6] = s2_177;
  const double s2_178 = fnma(s2_23, s2_56, s2_13*s2_175);
  const double s2_179 = fnma(s2_16, s2_175, s2_24*s2_56);
  const double s2_180 = fnma(s2_13, s2_24, s2_23*s2_16);
  const double s2_181 = fnma(s1_13, s2_179, R_carrier_left_aux2_z_y*s2_178);
  const double s2_182 = fma(R_carrier_left_aux2_y_y, s2_180, s2_181);
  const double s2_183 = fma(R_carrier_left_aux1_z_x, s2_178, R_carrier_left_aux1_x_x*s2_179);
  const double s2_184 = fma(R_carrier_left_aux1_y_x, s2_180, s2_183);
  const double s2_185 = fnma(R_lower_arm_left_z_y, s2_180, R_lower_arm_left_y_y*s2_178);
  result.dz[Coordinate::carrier_left_rz] = -s4_3;
  result.dz[Coordinate::carrier_left_rx] = -s4_5;
  result.dz[Coordinate::arb_front_left] = s2_113*fnma(s2_184, s4_5, fnma(s2_185, s4_3, fms(s2_182,
      s4_4, s2_177)));
  // loop block 0
  const double Rz_carrier_left_rz_0 = fnma(s2_165, s2_173, s2_71*s2_161)*s2_168;
  result.Rz[3] = Rz_carrier_left_rz_0;

  // --- step 3: Rz (61), continued ---
  const double s3_2 = s2_179 + fnma(s1_15, s2_175, s1_21*s2_24);
  // loop block 0
  const double Rz_carrier_left_rz_2 = fnma(s2_63, s2_161, s2_165*s2_174)*s2_168;
  result.Rz[5] = Rz_carrier_left_rz_2;
  const double s3_3 = s2_158*fma(s2_163, Rz_carrier_left_rz_0, s2_173);
  const double Rz_carrier_left_ry_2 = s2_158*fnma(s2_163, Rz_carrier_left_rz_2, s2_174);
  result.Rz[11] = Rz_carrier_left_ry_2;
  w1.s3_4 = s2_146*fnma(s2_76, s3_3, fms(s2_74, Rz_carrier_left_rz_0, s2_71));
  const double s3_5 = fma(s2_74, Rz_carrier_left_rz_2, s2_63);
  const double s3_6 = fnma(s2_182, s3_3, fma(s2_185, Rz_carrier_left_rz_0, s3_2));
  w1.s3_7 = s2_146*fma(s2_76, Rz_carrier_left_ry_2, s3_5);
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double Rz_arb_front_left_0 = s2_113*fnma(s2_184, w1.s3_4, s3_6);
  result.Rz[15] = Rz_arb_front_left_0;
  const double s3_8 = fma(s2_182, Rz_carrier_left_ry_2, s2_185*Rz_carrier_left_rz_2);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  result.zd[Coordinate::carrier_left_ry] = fnma(zd_lower_arm_left, s3_3,
      zd_bell_crank*Rz_carrier_left_ry_2);
  const double s3_9 = fnma(s2_162, Rz_carrier_left_rz_0, fms(s2_151, w1.s3_4, s2_172));
  const double Rz_arb_front_left_2 = s2_113*fnma(s2_184, w1.s3_7, s3_8);
  result.Rz[17] = Rz_arb_front_left_2;
  result.Rz[9] = -s3_3;
  w1.s3_10 = s2_153*fnma(s2_152, s3_3, s3_9);
  const double s4_7 = zd_lower_arm_left*Rz_carrier_left_rz_0;
  result.zd[Coordinate::carrier_left_rz] = fma(zd_bell_crank, Rz_carrier_left_rz_2, s4_7);
  const double s4_8 = zd_lower_arm_left*Rz_arb_front_left_0;
  result.zd[Coordinate::arb_front_left] = fma(zd_bell_crank, Rz_arb_front_left_2, s4_8);
  const double s2_186 = s2_93 + (r_carrier_right_aux1_y - p_upper_arm_right_y - s2_116);
  result.residual[4] = s2_186;
  const double s2_187 = w1.s2_96 + (0.72 + r_carrier_right_aux1_y);
  w1.s2_188 = s1_23 + s2_93;
  w1.s2_189 = fma(w1.s2_104, s2_133, fnma(w1.s2_188, s2_132, s1_18 - s2_79));
  w1.s2_190 = w1.s2_100*s2_133;
  const double s4_9 = fma(w1.s2_138, s4_1, fma(s2_103, s2_133, fms(s2_127, s2_132, s2_186)));
  w1.s4_10 = w1.s2_141*s4_9;
  result.dz[Coordinate::carrier_right_rx] = w1.s4_10;
  w1.s4_11 = w1.s2_123*fma(w1.s2_136, w1.s4_10, s4_1);
  w1.s4_12 = w1.s2_118*fnma(w1.s2_109, w1.s4_11, fms(w1.s2_107, w1.s4_10, s2_103));
  result.dz[Coordinate::carrier_right_rz] = w1.s4_12;
  const double s4_13 = fma(w1.s2_129, w1.s4_11, fma(w1.s2_128, w1.s4_10, s2_127));
  result.dz[Coordinate::upper_arm_right] = w1.s2_131*fma(w1.s2_130, w1.s4_12, s4_13);
  w1.s2_191 = 3.846153846153846*s2_187;
  const double s2_192 = fma(s2_35, w1.s2_37, fms(s2_34, w1.s2_36, l_arb_link_front_right));
  w1.s2_193 = fma(s2_187, w1.s2_191, s2_192);
  w1.s3_11 = fnma(s1_18, w1.s2_191, s1_23*w1.s2_37);
}

/// Part 2 of compute_closure: step 2: closure Jacobian Phi_z and its factors (60); step 3: Rz (61).
[[gnu::noinline]] void compute_closure_2(const State& state, ClosureWork1& __restrict w1,
    ClosureWork2& __restrict w2, Closure& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  const double s2_194 = 0.5*w1.s2_193;
  result.residual[7] = s2_194;
  const double s2_195 = fma(w1.s2_26, w1.s2_191, w1.s2_36*w1.s2_96);
  const double s2_196 = fma(w1.s2_29, w1.s2_191, w1.s2_37*w1.s2_96);
  const double s2_197 = fnma(w1.s2_26, w1.s2_37, w1.s2_36*w1.s2_29);
  const double s2_198 = w1.R_carrier_right_aux2_y_y*s2_197;
  const double s2_199 = fnma(w1.R_carrier_right_aux2_z_y, s2_195, s2_198);
  const double s2_200 = fnma(w1.s1_16, s2_196, s2_199);
  const double s2_201 = fnma(w1.R_carrier_right_aux1_z_x, s2_195, w2.cosines[7]*s2_196);
  const double s2_202 = fma(w1.R_carrier_right_aux1_y_x, s2_197, s2_201);
  const double s2_203 = fma(w2.sines[6], s2_197, w2.cosines[6]*s2_195);
  result.dz[Coordinate::carrier_right_ry] = -w1.s4_11;
  const double s4_14 = fnma(s2_200, w1.s4_11, fms(s2_202, w1.s4_10, s2_194));
  result.dz[Coordinate::arb_front_right] = w1.s2_110*fnma(s2_203, w1.s4_12, s4_14);
  const double s2_204 = w1.s2_100*w1.s2_120;
  const double s2_205 = w1.s2_104*w1.s2_120;

  // --- step 3: Rz (61), continued ---
  // loop block 0
  const double Rz_carrier_right_rx_2 = w1.s2_141*fma(w1.s2_138, s2_204, w1.s2_190);
  result.Rz[26] = Rz_carrier_right_rx_2;
  const double s3_12 = fma(w1.s2_138, s2_205, w1.s2_189)*w1.s2_141;
  const double s3_13 = w1.s2_123*fma(w1.s2_136, Rz_carrier_right_rx_2, s2_204);
  const double Rz_carrier_right_ry_1 = w1.s2_123*fma(w1.s2_136, s3_12, s2_205);
  result.Rz[28] = Rz_carrier_right_ry_1;
  const double s3_14 = fnma(s2_202, s3_12, s2_196 + w1.s3_11);
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s3_15 = fnma(w1.s2_109, s3_13, fms(w1.s2_107, Rz_carrier_right_rx_2, w1.s2_100));
  const double Rz_carrier_right_rz_2 = w1.s2_118*s3_15;
  result.Rz[23] = Rz_carrier_right_rz_2;
  const double s3_16 = fma(w1.s2_109, Rz_carrier_right_ry_1, fnma(w1.s2_107, s3_12, w1.s2_104));
  const double Rz_carrier_right_rz_1 = w1.s2_118*s3_16;
  result.Rz[22] = Rz_carrier_right_rz_1;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  result.zd[Coordinate::carrier_right_rx] = fnma(zd_lower_arm_right, s3_12,
      zd_bell_crank*Rz_carrier_right_rx_2);
  const double s3_17 = fnma(s2_200, s3_13, s2_202*Rz_carrier_right_rx_2);
  const double s3_18 = fma(w1.s2_129, Rz_carrier_right_ry_1, fms(w1.s2_128, s3_12, w1.s2_188));
  const double s3_19 = fma(s2_200, Rz_carrier_right_ry_1, s3_14);
  result.zd[Coordinate::carrier_right_ry] = fnma(zd_bell_crank, s3_13,
      zd_lower_arm_right*Rz_carrier_right_ry_1);
  result.Rz[25] = -s3_12;
  const double Rz_arb_front_right_2 = w1.s2_110*fnma(s2_203, Rz_carrier_right_rz_2, s3_17);
  result.Rz[35] = Rz_arb_front_right_2;
  const double s3_20 = w1.s2_131*fnma(w1.s2_130, Rz_carrier_right_rz_1, s3_18);
  const double Rz_arb_front_right_1 = w1.s2_110*fnma(s2_203, Rz_carrier_right_rz_1, s3_19);
  result.Rz[34] = Rz_arb_front_right_1;
  result.Rz[29] = -s3_13;
  const double s4_15 = zd_lower_arm_right*Rz_carrier_right_rz_1;
  result.zd[Coordinate::carrier_right_rz] = fma(zd_bell_crank, Rz_carrier_right_rz_2, s4_15);
  const double s4_16 = zd_lower_arm_right*Rz_arb_front_right_1;
  result.zd[Coordinate::arb_front_right] = fma(zd_bell_crank, Rz_arb_front_right_2, s4_16);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = w2.cosines[14];
  const double s1_24 = w2.sines[15];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_24;
  const double R_rear_axle_aux4_y_x = w2.sines[14];
  const double s1_25 = w2.sines[16];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_26 = w2.cosines[16];
  const double R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_26, R_rear_axle_aux4_y_x*s1_25);
  const double R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_26, R_rear_axle_aux5_x_z*s1_25);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_24;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double R_rear_axle_y_y = fma(R_rear_axle_aux4_x_x, s1_26, R_rear_axle_aux5_y_z*s1_25);
  const double R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_25, R_rear_axle_aux5_y_z*s1_26);
  const double R_rear_axle_aux5_z_z = w2.cosines[15];
  const double R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_26;
  const double s2_206 = fnma(p_long_rod_left_to_z, R_rear_axle_z_z, p_long_rod_left_to_x*s1_24);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s2_207 = p_long_rod_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_208 = fma(p_long_rod_left_to_z, R_rear_axle_x_z, s2_207);
  const double R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s2_209 = p_long_rod_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_210 = fma(p_long_rod_left_to_z, R_rear_axle_y_z, s2_209);
  const double s2_211 = fma(p_long_rod_left_to_y, R_rear_axle_y_y, s2_210);
  const double s2_212 = fnma(p_long_rod_left_to_y, R_rear_axle_y_y, s2_210);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_213 = p_long_rod_left_from_y - z_rear_axle_ty - s2_211;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] + p_rear_axle_tx_z;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_25;
  const double s2_214 = fms(p_long_rod_left_to_y, R_rear_axle_z_y, s2_206);
  const double s2_215 = fma(p_long_rod_left_to_y, R_rear_axle_z_y, s2_206);
  const double s2_216 = r_rear_axle_aux3_z - p_long_rod_left_from_z;
  const double s2_217 = s2_214 + s2_216;
  const double s2_218 = s2_216 - s2_215;
  const double s2_219 = 1.1757385222540735*s2_217;
  const double s2_220 = 1.1757385222540735*s2_213;
  const double s2_221 = fma(s2_214, s2_220, s2_219*s2_211);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;

  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  const double s2_222 = fma(p_long_rod_left_to_y, R_rear_axle_x_y, s2_208);
  const double s2_223 = fnma(p_long_rod_left_to_y, R_rear_axle_x_y, s2_208);
  const double s2_224 = r_rear_axle_aux1_x - p_long_rod_left_from_x;
  const double s2_225 = s2_222 + s2_224;
  const double s2_226 = s2_224 + s2_223;
  const double s2_227 = 1.1757385222540735*s2_225;
  const double s2_228 = fma(s2_222, s2_220, s2_227*s2_211);
  const double s2_229 = fma(s2_225, s2_227, fms(s2_217, s2_219, l_long_rod_left));
  const double s2_230 = 0.5*fma(s2_213, s2_220, s2_229);
  result.residual[11] = s2_230;
  const double s2_231 = fnma(s2_214, s2_227, s2_222*s2_219);
  const double s2_232 = p_diag_rod_left_to_y*R_rear_axle_y_y;
  const double s2_233 = fma(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_232);
  const double s2_234 = fms(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_232);
  const double s2_235 = p_diag_rod_left_from_y - z_rear_axle_ty - s2_233;
  const double s2_236 = p_diag_rod_left_to_y*R_rear_axle_z_y;
  const double s2_237 = fma(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_236);
  const double s2_238 = fms(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_236);
  const double s2_239 = r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  const double s2_240 = r_rear_axle_aux3_z - p_arb_rear_left_z;
  const double s2_241 = s2_237 + s2_239;
  const double s2_242 = s2_239 + s2_238;
  const double s2_243 = 1.162476387438193*s2_241;
  const double s2_244 = 1.162476387438193*s2_235;
  const double s2_245 = fma(s2_237, s2_244, s2_243*s2_233);
  const double s2_246 = p_diag_rod_left_to_z*R_rear_axle_x_z;
  const double s2_247 = fma(p_diag_rod_left_to_y, R_rear_axle_x_y, s2_246);
  const double s2_248 = fnma(p_diag_rod_left_to_y, R_rear_axle_x_y, s2_246);
  const double s2_249 = r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  const double s2_250 = s2_247 + s2_249;
  const double s2_251 = s2_249 + s2_248;
  const double s2_252 = 1.162476387438193*s2_250;
  const double s2_253 = fma(s2_247, s2_244, s2_252*s2_233);
  const double s2_254 = fma(s2_250, s2_252, fms(s2_241, s2_243, l_diag_rod_left));
  const double s2_255 = 0.5*fma(s2_235, s2_244, s2_254);
  result.residual[12] = s2_255;
  const double s2_256 = fnma(s2_237, s2_252, s2_247*s2_243);
  const double s2_257 = -p_arb_link_rear_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_258 = fnma(p_arb_link_rear_left_to_z, R_rear_axle_x_z, s2_257);
  const double s2_259 = -p_arb_link_rear_left_to_x*s1_24;
  const double s2_260 = fma(p_arb_link_rear_left_to_z, R_rear_axle_z_z, s2_259);
  const double s2_261 = p_arb_link_rear_left_from_x*w2.sines[17];
  const double s2_262 = fma(p_arb_link_rear_left_to_y, R_rear_axle_z_y, s2_260);
  const double s2_263 = fnma(p_arb_link_rear_left_to_y, R_rear_axle_z_y, s2_260);
  const double s2_264 = s2_240 + (s2_261 + s2_262);
  const double s2_265 = p_arb_link_rear_left_from_x*w2.cosines[17];
  const double s2_266 = fms(p_arb_link_rear_left_to_y, R_rear_axle_x_y, s2_258);
  const double s2_267 = s2_265 + p_arb_rear_left_x - r_rear_axle_aux1_x - s2_266;
  const double s2_268 = fma(p_arb_link_rear_left_to_y, R_rear_axle_x_y, s2_258);
  const double s2_269 = 4.47213595499958*s2_264;
  const double s2_270 = 4.47213595499958*s2_267;
  const double pivot_arb_rear_left = fnma(s2_261, s2_270, s2_265*s2_269);
  // long_rod_right
  const double s2_271 = s2_212 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s2_272 = 1.1757385222540735*s2_271;
  const double s2_273 = 1.1757385222540735*s2_218;
  const double s2_274 = fma(s2_212, s2_273, s2_215*s2_272);
  const double s2_275 = 1.1757385222540735*s2_226;
  const double s2_276 = fma(s2_218, s2_273, fms(s2_271, s2_272, l_long_rod_right));
  const double s2_277 = fnma(s2_223, s2_272, s2_212*s2_275);
  const double s2_278 = 0.5*fma(s2_226, s2_275, s2_276);
  result.residual[14] = s2_278;
  const double s2_279 = fma(s2_215, s2_275, s2_223*s2_273);
  const double s2_280 = s2_234 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  const double pivot_rear_axle_tx = 1.162476387438193*s2_251;
  const double s2_281 = 1.162476387438193*s2_280;
  const double s2_282 = fnma(s2_248, s2_281, pivot_rear_axle_tx*s2_234);
  const double s2_283 = 1.162476387438193*s2_242;
  const double s2_284 = fnma(pivot_rear_axle_tx, s2_238, s2_248*s2_283);
  const double s2_285 = fma(s2_242, s2_283, fms(s2_251, pivot_rear_axle_tx, l_diag_rod_right));
  const double s2_286 = 0.5*fma(s2_280, s2_281, s2_285);
  result.residual[15] = s2_286;
  const double s2_287 = fnma(s2_234, s2_283, s2_238*s2_281);
  const double s2_288 = p_arb_link_rear_right_from_x*w2.cosines[18];
  const double s2_289 = s2_268 + (s2_288 + p_arb_rear_right_x - r_rear_axle_aux1_x);
  const double s2_290 = p_arb_link_rear_right_from_x*w2.sines[18];
  const double s2_291 = s2_290 + (s2_240 + s2_263);
  const double s2_292 = 4.47213595499958*s2_291;
  const double s2_293 = 4.47213595499958*s2_289;
  const double pivot_arb_rear_right = fnma(s2_290, s2_293, s2_288*s2_292);
  const double s2_294 = 1.0/pivot_arb_rear_left;
  const double s2_295 = 1.0/pivot_arb_rear_right;
  const double s2_296 = 3.204642123170383*std::abs(pivot_arb_rear_right);
  const double s2_297 = 1.0/pivot_rear_axle_tx;
  const double s2_298 = s2_227*s2_297;
  const double s2_299 = s2_275*s2_297;
  const double s2_300 = s2_252*s2_297;
  const double s2_301 = mbgen::min(3.194382824999693*std::abs(pivot_arb_rear_left), s2_296);
  const double s2_302 = fma(s2_281, s2_298, s2_220);
  const double s2_303 = fnma(s2_283, s2_298, s2_219);
  const double s4_17 = fms(s2_286, s2_298, s2_230);
  const double pivot_rear_axle_rz = fms(s2_282, s2_298, s2_228);
  const double s2_304 = 1.0/pivot_rear_axle_rz;
  const double s2_305 = mbgen::min(1.0748203921841*std::abs(pivot_rear_axle_tx), s2_301);
  const double s2_306 = fnma(R_rear_axle_aux4_y_x, s2_287, R_rear_axle_aux4_x_x*s2_284);
  const double s2_307 = fnma(s1_24, s2_282, R_rear_axle_aux5_y_x*s2_284);
  const double s2_308 = fma(R_rear_axle_aux5_x_x, s2_287, s2_307);
  const double s2_309 = fnma(R_rear_axle_aux4_y_x, s2_221, s2_306*s2_298);
  const double s2_310 = fnma(R_rear_axle_aux4_x_x, s2_231, s2_309);
  const double s2_311 = fma(s1_24, s2_228, R_rear_axle_aux5_x_x*s2_221);
  const double s2_312 = fma(s2_308, s2_298, fnma(R_rear_axle_aux5_y_x, s2_231, s2_311));
  const double s2_313 = fms(s2_282, s2_299, s2_277)*s2_304;
  const double s2_314 = fma(s2_313, s2_302, fnma(s2_281, s2_299, s2_272));
  const double s2_315 = fnma(s2_313, s2_303, fnma(s2_283, s2_299, s2_273));
  const double s4_18 = fnma(s2_313, s4_17, fms(s2_286, s2_299, s2_278));
  const double s2_316 = fnma(R_rear_axle_aux4_y_x, s2_274, s2_306*s2_299);
  const double pivot_rear_axle_ry = fnma(s2_310, s2_313, fnma(R_rear_axle_aux4_x_x, s2_279,
      s2_316));
  const double s2_317 = fma(s1_24, s2_277, R_rear_axle_aux5_x_x*s2_274);
  const double s2_318 = fma(s2_308, s2_299, fnma(R_rear_axle_aux5_y_x, s2_279, s2_317));
  const double s2_319 = fnma(s2_313, s2_312, s2_318);
  const double s2_320 = 1.0/pivot_rear_axle_ry;
  const double s2_321 = mbgen::min(s2_305, 1.5318884572025857*std::abs(pivot_rear_axle_rz));
  const double s2_322 = s2_304*fms(s2_282, s2_300, s2_253);
  const double s2_323 = fnma(R_rear_axle_aux4_y_x, s2_245, s2_306*s2_300);
  const double s2_324 = fnma(s2_310, s2_322, fnma(R_rear_axle_aux4_x_x, s2_256, s2_323))*s2_320;
  const double s2_325 = fma(s1_24, s2_253, R_rear_axle_aux5_x_x*s2_245);
  const double pivot_rear_axle_ty = fnma(s2_314, s2_324, fnma(s2_281, s2_300, fms(s2_302, s2_322,
      s2_244)));
  const double s2_326 = fma(s2_308, s2_300, fnma(R_rear_axle_aux5_y_x, s2_256, s2_325));
  const double s2_327 = 1.0/pivot_rear_axle_ty;
  const double s4_19 = fnma(s2_324, s4_18, fnma(s2_322, s4_17, fms(s2_286, s2_300, s2_255)));
  const double s4_20 = s2_327*s4_19;
  result.dz[Coordinate::rear_axle_ty] = s4_20;
  const double s2_328 = fnma(s2_324, s2_315, fnma(s2_322, s2_303, fnma(s2_283, s2_300, s2_243)));
  const double s3_21 = s2_328*s2_327;
  const double s3_22 = fnma(s2_324, s2_319, fnma(s2_322, s2_312, s2_326))*s2_327;
  const double s2_329 = mbgen::min(s2_321, 1.7893247478820993*std::abs(pivot_rear_axle_ry));
  result.pivot[1] = mbgen::min(s2_329, 1.4337752588788297*std::abs(pivot_rear_axle_ty));
  const double s4_21 = s2_320*fnma(s2_314, s4_20, s4_18);
  result.dz[Coordinate::rear_axle_ry] = s4_21;
  // loop block 1
  const double Rz_rear_axle_ry_0 = s2_320*fms(s2_314, s3_21, s2_315);
  result.Rz[50] = Rz_rear_axle_ry_0;
  const double Rz_rear_axle_ry_1 = s2_320*fms(s2_314, s3_22, s2_319);
  result.Rz[51] = Rz_rear_axle_ry_1;
  const double s4_22 = s2_304*fnma(s2_310, s4_21, fma(s2_302, s4_20, s4_17));
  result.dz[Coordinate::rear_axle_rz] = s4_22;
  const double s3_23 = s2_304*fma(s2_310, Rz_rear_axle_ry_0, fma(s2_302, s3_21, s2_303));
  const double s3_24 = s2_304*fma(s2_310, Rz_rear_axle_ry_1, fma(s2_302, s3_22, s2_312));
  const double s3_25 = fma(s2_306, Rz_rear_axle_ry_0, fms(s2_281, s3_21, s2_283));
  const double s3_26 = fma(s2_306, Rz_rear_axle_ry_1, fma(s2_281, s3_22, s2_308));
  const double s4_23 = fma(s2_282, s4_22, fnma(s2_281, s4_20, fms(s2_306, s4_21, s2_286)));
  const double s4_24 = s2_297*s4_23;
  result.dz[Coordinate::rear_axle_tx] = s4_24;
  const double Rz_rear_axle_tx_0 = s2_297*fnma(s2_282, s3_23, s3_25);
  result.Rz[42] = Rz_rear_axle_tx_0;
  const double Rz_rear_axle_tx_1 = s2_297*fnma(s2_282, s3_24, s3_26);
  result.Rz[43] = Rz_rear_axle_tx_1;
  const double s2_330 = -p_arb_link_rear_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_331 = fnma(p_arb_link_rear_left_to_z, R_rear_axle_y_z, s2_330);
  const double s2_332 = fms(p_arb_link_rear_left_to_y, R_rear_axle_y_y, s2_331);
  const double s2_333 = fma(p_arb_link_rear_left_to_y, R_rear_axle_y_y, s2_331);
  const double s2_334 = 0.6 - z_rear_axle_ty - s2_332;
  const double s2_335 = 4.47213595499958*s2_334;
  const double s2_336 = fma(s2_267, s2_270, fms(s2_264, s2_269, l_arb_link_rear_left));
  const double s2_337 = 0.5*fma(s2_334, s2_335, s2_336);
  result.residual[13] = s2_337;
  const double s2_338 = fnma(s2_270, s2_332, s2_266*s2_335);
  const double s2_339 = fma(s2_262, s2_270, s2_269*s2_266);
  const double s2_340 = fma(s2_262, s2_335, s2_269*s2_332);
  const double s2_341 = 0.6 + z_rear_axle_ty - s2_333;
  const double s2_342 = 4.47213595499958*s2_341;
  const double s2_343 = fma(s2_289, s2_293, fms(s2_291, s2_292, l_arb_link_rear_right));
  const double s2_344 = 0.5*fma(s2_341, s2_342, s2_343);
  result.residual[16] = s2_344;
  const double s2_345 = fma(s2_268, s2_342, s2_293*s2_333);
  const double s2_346 = fma(s2_263, s2_342, s2_292*s2_333);
  const double s2_347 = fnma(s2_292, s2_268, s2_263*s2_293);
  const double s2_348 = fma(R_rear_axle_aux4_x_x, s2_339, R_rear_axle_aux4_y_x*s2_340);
  const double s4_25 = fma(s2_338, s4_22, fma(s2_348, s4_21, fms(s2_335, s4_20, s2_337)));
  const double s3_27 = fnma(s2_335, s3_21, fms(s2_348, Rz_rear_axle_ry_0, s2_269));
  const double s3_28 = fnma(R_rear_axle_aux5_x_x, s2_340, R_rear_axle_aux5_y_x*s2_339);
  result.dz[Coordinate::arb_rear_left] = s2_294*fma(s2_270, s4_24, s4_25);
  const double s2_349 = fnma(R_rear_axle_aux4_y_x, s2_346, R_rear_axle_aux4_x_x*s2_347);
  const double s3_29 = fma(R_rear_axle_aux5_x_x, s2_346, R_rear_axle_aux5_y_x*s2_347);
  const double Rz_arb_rear_left_0 = s2_294*fma(s2_270, Rz_rear_axle_tx_0, fnma(s2_338, s3_23,
      s3_27));
  result.Rz[54] = Rz_arb_rear_left_0;
  const double s3_30 = fma(s2_348, Rz_rear_axle_ry_1, fnma(s2_335, s3_22, s3_28));
  const double s3_31 = s1_24 + s3_24;
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s3_32 = fma(s2_349, Rz_rear_axle_ry_0, fms(s2_342, s3_21, s2_292));
  const double s3_33 = fma(s2_349, Rz_rear_axle_ry_1, fma(s2_342, s3_22, s3_29));
  const double Rz_arb_rear_left_1 = s2_294*fnma(s2_338, s3_31, fma(s2_270, Rz_rear_axle_tx_1,
      s3_30));
  result.Rz[55] = Rz_arb_rear_left_1;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s4_26 = zd_rear_axle_tz*Rz_rear_axle_ry_0;
  result.zd[Coordinate::rear_axle_ry] = fma(zd_rear_axle_rx, Rz_rear_axle_ry_1, s4_26);
  const double s4_27 = fma(s2_345, s4_22, fnma(s2_342, s4_20, fms(s2_349, s4_21, s2_344)));
  const double s4_28 = zd_rear_axle_tz*Rz_arb_rear_left_0;
  result.zd[Coordinate::arb_rear_left] = fma(zd_rear_axle_rx, Rz_arb_rear_left_1, s4_28);
  const double Rz_arb_rear_right_0 = s2_295*fma(s2_293, Rz_rear_axle_tx_0, fnma(s2_345, s3_23,
      s3_32));
  result.Rz[56] = Rz_arb_rear_right_0;
  const double Rz_arb_rear_right_1 = s2_295*fnma(s2_345, s3_31, fma(s2_293, Rz_rear_axle_tx_1,
      s3_33));
  result.Rz[57] = Rz_arb_rear_right_1;
  result.dz[Coordinate::arb_rear_right] = s2_295*fma(s2_293, s4_24, s4_27);
  const double s4_29 = zd_rear_axle_tz*Rz_rear_axle_tx_0;
  result.zd[Coordinate::rear_axle_tx] = fma(zd_rear_axle_rx, Rz_rear_axle_tx_1, s4_29);
  const double s4_30 = zd_rear_axle_tz*Rz_arb_rear_right_0;
  result.zd[Coordinate::arb_rear_right] = fma(zd_rear_axle_rx, Rz_arb_rear_right_1, s4_30);
  // loop block 0
  result.Rz[6] = -w1.s3_4;
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  result.Rz[8] = -w1.s3_7;
  result.zd[Coordinate::carrier_left_rx] = -fma(zd_bell_crank, w1.s3_7, zd_lower_arm_left*w1.s3_4);
  result.Rz[12] = -w1.s3_10;
  result.zd[Coordinate::upper_arm_left] = -(zd_lower_arm_left*w1.s3_10);
  result.Rz[31] = -s3_20;
  result.zd[Coordinate::upper_arm_right] = -(zd_lower_arm_right*s3_20);
  result.Rz[38] = -w1.s3_1;
  result.zd[Coordinate::pitman_arm] = -(zd_bell_crank*w1.s3_1);
  // loop block 1
  result.Rz[44] = -s3_21;
  result.Rz[45] = -s3_22;
  result.zd[Coordinate::rear_axle_ty] = -fma(zd_rear_axle_rx, s3_22, zd_rear_axle_tz*s3_21);
  result.Rz[48] = -s3_23;
  result.Rz[49] = -s3_24;
  result.zd[Coordinate::rear_axle_rz] = -fma(zd_rear_axle_rx, s3_24, zd_rear_axle_tz*s3_23);
  // operations of step 1: poses and axes b: 34 add, 74 multiply, 38 sin cos
  // operations of step 4: velocities: 60 add, 94 multiply
  // operations of step 2: closure Jacobian Phi_z and its factors (60): 320 add, 431 multiply, 17
  // divide, 32 other
  // operations of step 3: Rz (61): 63 add, 97 multiply
}

/// One Newton step of the frozen partition, and consistent velocities.
void compute_closure(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    Closure& __restrict result) noexcept {
  ClosureWork1 w1;
  ClosureWork2 w2;
  compute_closure_1(state, w1, w2, result);
  compute_closure_2(state, w1, w2, result);
}

#endif  // part 0

}  // namespace

MBGEN_BETWEEN_PARTS {

/// Projection of the loop blocks, chosen at run time.
struct Projection {
  double Rz[58];  ///< of each block, row by row
  double zdd_star[22];  ///< accelerations of each block at zero independent ones
};

/// Result of compute_multipliers.
struct ConstraintForces {
  double lambda[17];  ///< multipliers, loop after loop
  double drive[1];  ///< generalised driving forces
  double missing[22];  ///< what multipliers and drives must provide, block after block
  double pivot[2];  ///< smallest pivot of each block over its reference
};

void compute_multipliers(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, const Derivative& derivative, ConstraintForces& __restrict result) noexcept;

#if MBGEN_IS_PART(1)
/// Values of compute_multipliers that cross its parts.
struct ConstraintForcesWork1 {
  double
      w_chassis_z, w_chassis_x, w_chassis_y, R_rear_axle_x_y, R_rear_axle_z_y, s7_15,
      R_rear_axle_y_y, s7_13, s1_22, R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, s1_41,
      R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, R_rear_axle_aux5_x_x,
      R_rear_axle_aux5_y_x, R_rear_axle_aux5_z_x, w_rear_axle_z, w_rear_axle_x, w_rear_axle_y,
      R_rear_axle_y_z, w_carrier_left_x, w_carrier_right_x, R_rear_axle_x_z, R_rear_axle_z_z,
      a_chassis_z, alpha_chassis_x, w_carrier_left_y, w_carrier_left_z, w_carrier_right_y,
      w_carrier_right_z, a_chassis_y, R_carrier_left_x_z, R_carrier_left_y_z, R_carrier_left_z_z,
      R_carrier_right_x_z, R_carrier_right_y_z, R_carrier_right_z_z, a_chassis_x, alpha_chassis_y,
      alpha_chassis_z, s7_9, s7_14, R_carrier_left_aux1_z_z, R_carrier_left_aux1_y_x,
      R_carrier_left_aux1_z_x, R_carrier_left_x_x, R_carrier_left_y_x, R_carrier_left_z_x,
      R_carrier_right_aux1_z_z, R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x,
      R_carrier_right_x_x, R_carrier_right_y_x, R_carrier_right_z_x, R_rear_axle_aux4_z_z, s1_52,
      s1_54, s7_11, s7_17, R_carrier_left_aux1_y_z, R_carrier_right_aux1_y_z, R_rear_axle_aux4_x_z,
      w_arb_front_left_y, w_arb_front_right_y, s7_10, s7_12, s7_16, r_rear_axle_aux1_x,
      w_arb_rear_left_y, w_arb_rear_right_y, s1_18, s1_20, s1_27, s1_29, s1_31, s1_36, s1_38, s1_46,
      s1_48, s1_50, s1_59, s1_60, s1_61, r_rear_axle_aux3_z, w_wheel_front_left_x,
      w_wheel_front_left_y, w_wheel_front_left_z, w_wheel_front_right_x, w_wheel_front_right_y,
      w_wheel_front_right_z, s4_36, w_wheel_rear_left_x, s4_37, w_wheel_rear_left_y, s4_38,
      w_wheel_rear_left_z, s4_39, w_wheel_rear_right_x, s4_40, w_wheel_rear_right_y, s4_41,
      w_wheel_rear_right_z, r_carrier_left_aux1_y, r_carrier_left_aux1_z, r_carrier_right_aux1_y,
      s1_39, s1_67, s1_84, s1_100, s1_69, s1_70, s1_73, s1_76, s1_77, s1_78, s1_86, s1_87, s1_90,
      s1_93, s1_94, s1_95, s1_102, s1_103, s1_105, s1_107, s1_108, s1_109;
};

/// Values of compute_multipliers that cross its parts.
struct ConstraintForcesWork2 {
  double
      s7_18, s7_19, alpha_rear_axle_x, alpha_rear_axle_y, alpha_rear_axle_z, alpha_carrier_left_x,
      alpha_carrier_left_y, alpha_carrier_left_z, alpha_carrier_right_x, alpha_carrier_right_y,
      alpha_carrier_right_z, s7_220, s7_222, a_rear_axle_aux3_x, a_rear_axle_aux3_z,
      alpha_lower_arm_left_x, a_carrier_left_aux1_x, s7_49, s7_53, s7_55, alpha_lower_arm_right_x,
      a_carrier_right_aux1_x, s7_110, s7_114, s7_116, a_bell_crank_x, s7_151, s7_152,
      a_carrier_left_aux1_y, a_carrier_left_aux1_z, s7_50, s7_51, s7_52, s7_54, s7_56, s7_57,
      alpha_wheel_front_left_x, alpha_wheel_front_left_y, alpha_wheel_front_left_z,
      alpha_upper_arm_left_x, alpha_arb_front_left_x, alpha_arb_front_left_y,
      alpha_arb_front_left_z, a_carrier_right_aux1_y, a_carrier_right_aux1_z, s7_111, s7_112,
      s7_113, s7_115, s7_117, s7_118, alpha_wheel_front_right_x, alpha_wheel_front_right_y,
      alpha_wheel_front_right_z, alpha_upper_arm_right_x, alpha_arb_front_right_x,
      alpha_arb_front_right_y, alpha_arb_front_right_z, alpha_pitman_arm_y, a_bell_crank_y,
      a_bell_crank_z, alpha_bell_crank_z, s7_150, s7_153, s7_154, s7_155, a_rear_axle_aux3_y, s7_21,
      a_lower_arm_left_y, s7_26, a_lower_arm_left_z, s7_27, s7_28, s7_29, s7_30, a_arb_front_left_x,
      a_arb_front_left_z, s7_79, s7_80, s7_81, s7_82, s7_85, a_lower_arm_right_y, s7_86,
      a_lower_arm_right_z, s7_87, s7_88, s7_89, s7_90, a_arb_front_right_x, a_arb_front_right_z,
      s7_131, s7_132, s7_133, s7_134, a_pitman_arm_x, s7_141, s7_144, a_wheel_front_left_x,
      a_wheel_front_left_y, a_wheel_front_left_z, a_upper_arm_left_y, a_upper_arm_left_z, s7_69,
      s7_70, s7_71, s7_72, a_arb_front_left_y, s7_83, s7_84, a_wheel_front_right_x,
      a_wheel_front_right_y, a_wheel_front_right_z, a_upper_arm_right_y, a_upper_arm_right_z,
      s7_127, s7_128, s7_129, s7_130, a_arb_front_right_y, s7_135, s7_136, a_pitman_arm_y,
      a_pitman_arm_z, s7_142, s7_143, s7_145, s7_146;
};

/// Values of compute_multipliers that cross its parts.
struct ConstraintForcesWork3 {
  double
      s7_225, s7_228, s7_231, s7_253, s7_256, s7_259, s7_294, s7_296, s7_298, s7_315, s7_318,
      s7_321, s7_370, s7_371, s7_372, s7_397, s7_398, s7_399, s7_248, s7_250, s7_275, s7_276,
      s7_290, s7_291, s7_311, s7_313, s7_337, s7_340, s7_343, s7_351, s7_353, s7_355, s7_362,
      s7_369, s7_384, s7_385, s7_386, s7_390, s7_391, s7_392, s7_400, s7_401, s7_277, s7_570,
      s7_572, s7_237, s7_240, s7_262, s7_265, s7_300, s7_304, s7_323, s7_325, s7_567,
      f_wheel_front_right_y, f_wheel_front_right_z, s7_234, s7_268, s7_286, s7_287, s7_292, s7_302,
      s7_312, s7_316, s7_319, s7_327, f_wheel_front_right_x, s7_243, s7_246, Q_rear_axle_tz,
      Q_rear_axle_ty, Q_rear_axle_tx, Q_pitman_arm, Q_arb_front_right, Q_upper_arm_right,
      n_wheel_front_right_x, n_wheel_front_right_y, n_wheel_front_right_z;
};

/// Values of compute_multipliers that cross its parts.
struct ConstraintForcesWork4 {
  double
      sines[22], cosines[22];
};

/// Part 1 of compute_multipliers: step 1: poses and axes b; step 4: velocities; step 7: inertias of
/// the bodies and forces on joints.
[[gnu::noinline]] void compute_multipliers_1(const State& state, const Derivative& derivative,
    ConstraintForcesWork1& __restrict w1, ConstraintForcesWork2& __restrict w2,
    ConstraintForcesWork4& __restrict w4) noexcept {
  // --- step 1: poses and axes b ---
  const double angles[] = {
      state.z[Coordinate::chassis_rz], state.z[Coordinate::chassis_ry],
      state.z[Coordinate::chassis_rx], state.z[Coordinate::lower_arm_left],
      state.z[Coordinate::carrier_left_rz], state.z[Coordinate::carrier_left_rx],
      state.z[Coordinate::carrier_left_ry], state.z[Coordinate::upper_arm_left],
      state.z[Coordinate::arb_front_left], state.z[Coordinate::lower_arm_right],
      state.z[Coordinate::carrier_right_rz], state.z[Coordinate::carrier_right_rx],
      state.z[Coordinate::carrier_right_ry], state.z[Coordinate::upper_arm_right],
      state.z[Coordinate::arb_front_right], state.z[Coordinate::pitman_arm],
      state.z[Coordinate::bell_crank], state.z[Coordinate::rear_axle_rz],
      state.z[Coordinate::rear_axle_ry], state.z[Coordinate::rear_axle_rx],
      state.z[Coordinate::arb_rear_left], state.z[Coordinate::arb_rear_right]};
  mbgen::sincos(angles, w4.sines, w4.cosines);
  const double s1_1 = state.charts[0] - 0.5;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_y_x = w4.sines[0];
  const double s1_2 = w4.cosines[1];
  const double R_chassis_aux5_y_x = R_chassis_aux4_y_x*s1_2;
  const double s1_3 = w4.sines[1];
  const double s1_4 = -s1_3;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux4_y_y = w4.cosines[0];
  const double s1_5 = R_chassis_aux4_y_y*s1_2;
  const double R_chassis_x_x = (s1_1 >= 0.0 ? s1_4 : s1_5);
  const double s1_6 = w4.sines[2];
  const double s1_7 = s1_2*s1_6;
  const double s1_8 = s1_3*s1_6;
  const double s1_9 = w4.cosines[2];
  const double s1_10 = fnma(R_chassis_aux4_y_x, s1_9, R_chassis_aux4_y_y*s1_8);
  const double R_chassis_x_y = (s1_1 >= 0.0 ? s1_7 : s1_10);
  const double s1_11 = s1_2*s1_9;
  const double s1_12 = s1_3*s1_9;
  const double s1_13 = fma(R_chassis_aux4_y_y, s1_12, R_chassis_aux4_y_x*s1_6);
  const double R_chassis_x_z = (s1_1 >= 0.0 ? s1_11 : s1_13);
  const double R_chassis_y_y = fma(R_chassis_aux4_y_y, s1_9, R_chassis_aux4_y_x*s1_8);
  const double R_chassis_y_z = fnma(R_chassis_aux4_y_y, s1_6, R_chassis_aux4_y_x*s1_12);
  const double R_chassis_z_x = (s1_1 >= 0.0 ? -s1_5 : s1_4);
  const double R_chassis_z_y = (s1_1 >= 0.0 ? -s1_10 : s1_7);
  const double R_chassis_z_z = (s1_1 >= 0.0 ? -s1_13 : s1_11);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = w4.sines[3];
  const double R_lower_arm_left_y_z = -R_lower_arm_left_z_y;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_14 = state.charts[1] - 0.5;
  const double R_lower_arm_left_y_y = w4.cosines[3];
  w1.R_carrier_left_aux1_z_z = (s1_14 >= 0.0 ? R_lower_arm_left_y_z : R_lower_arm_left_y_y);
  const double s1_15 = w4.sines[4];
  w1.R_carrier_left_aux1_y_x = s1_15*w1.R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_x_x = w4.cosines[4];
  const double R_carrier_left_aux1_y_y = R_carrier_left_aux1_x_x*w1.R_carrier_left_aux1_z_z;
  w1.R_carrier_left_aux1_y_z = (s1_14 >= 0.0 ? -R_lower_arm_left_y_y : R_lower_arm_left_y_z);
  const double s1_16 = (s1_14 >= 0.0 ? R_lower_arm_left_y_y : R_lower_arm_left_z_y);
  w1.R_carrier_left_aux1_z_x = s1_15*s1_16;
  const double R_carrier_left_aux1_z_y = R_carrier_left_aux1_x_x*s1_16;
  const double s1_17 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  w1.s1_18 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_17);
  w1.r_carrier_left_aux1_y = p_lower_arm_left_y + w1.s1_18;
  const double s1_19 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  w1.s1_20 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_19);
  w1.r_carrier_left_aux1_z = w1.s1_20 + p_lower_arm_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_21 = w4.cosines[5];
  w1.s1_22 = s1_15*s1_21;
  const double s1_23 = w4.sines[5];
  const double R_carrier_left_aux2_x_z = s1_15*s1_23;
  w1.R_carrier_left_aux2_y_y = fma(w1.R_carrier_left_aux1_y_z, s1_23,
      R_carrier_left_aux1_y_y*s1_21);
  const double R_carrier_left_aux2_y_z = fnma(R_carrier_left_aux1_y_y, s1_23,
      w1.R_carrier_left_aux1_y_z*s1_21);
  w1.R_carrier_left_aux2_z_y = fma(w1.R_carrier_left_aux1_z_z, s1_23,
      R_carrier_left_aux1_z_y*s1_21);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_23,
      w1.R_carrier_left_aux1_z_z*s1_21);
  const double s1_24 = w4.cosines[6];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = w4.sines[6];
  w1.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_25, R_carrier_left_aux1_x_x*s1_24);
  w1.R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_25, R_carrier_left_aux2_x_z*s1_24);
  w1.R_carrier_left_y_x = fnma(R_carrier_left_aux2_y_z, s1_25, w1.R_carrier_left_aux1_y_x*s1_24);
  w1.R_carrier_left_y_z = fma(w1.R_carrier_left_aux1_y_x, s1_25, R_carrier_left_aux2_y_z*s1_24);
  w1.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_25, w1.R_carrier_left_aux1_z_x*s1_24);
  w1.R_carrier_left_z_z = fma(w1.R_carrier_left_aux1_z_x, s1_25, R_carrier_left_aux2_z_z*s1_24);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_26 = p_wheel_front_left_z*w1.R_carrier_left_x_z;
  w1.s1_27 = fnma(p_wheel_front_left_y, w1.s1_22, s1_26);
  const double s1_28 = p_wheel_front_left_y*w1.R_carrier_left_aux2_y_y;
  w1.s1_29 = fma(p_wheel_front_left_z, w1.R_carrier_left_y_z, s1_28);
  const double s1_30 = p_wheel_front_left_y*w1.R_carrier_left_aux2_z_y;
  w1.s1_31 = fma(p_wheel_front_left_z, w1.R_carrier_left_z_z, s1_30);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = w4.sines[9];
  const double R_lower_arm_right_y_z = -R_lower_arm_right_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_32 = state.charts[2] - 0.5;
  const double R_lower_arm_right_y_y = w4.cosines[9];
  w1.R_carrier_right_aux1_z_z = (s1_32 >= 0.0 ? R_lower_arm_right_y_z : R_lower_arm_right_y_y);
  const double s1_33 = w4.sines[10];
  w1.R_carrier_right_aux1_y_x = s1_33*w1.R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_x_x = w4.cosines[10];
  const double R_carrier_right_aux1_y_y = R_carrier_right_aux1_x_x*w1.R_carrier_right_aux1_z_z;
  w1.R_carrier_right_aux1_y_z = (s1_32 >= 0.0 ? -R_lower_arm_right_y_y : R_lower_arm_right_y_z);
  const double s1_34 = (s1_32 >= 0.0 ? R_lower_arm_right_y_y : R_lower_arm_right_z_y);
  w1.R_carrier_right_aux1_z_x = s1_33*s1_34;
  const double R_carrier_right_aux1_z_y = R_carrier_right_aux1_x_x*s1_34;
  const double s1_35 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  w1.s1_36 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_35);
  w1.r_carrier_right_aux1_y = w1.s1_36 + p_lower_arm_right_y;
  const double s1_37 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  w1.s1_38 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_37);
  w1.s1_39 = w1.s1_38 - p_lower_arm_right_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_40 = w4.cosines[11];
  w1.s1_41 = s1_33*s1_40;
  const double s1_42 = w4.sines[11];
  const double R_carrier_right_aux2_x_z = s1_33*s1_42;
  w1.R_carrier_right_aux2_y_y = fma(w1.R_carrier_right_aux1_y_z, s1_42,
      R_carrier_right_aux1_y_y*s1_40);
  const double R_carrier_right_aux2_y_z = fnma(R_carrier_right_aux1_y_y, s1_42,
      w1.R_carrier_right_aux1_y_z*s1_40);
  w1.R_carrier_right_aux2_z_y = fma(w1.R_carrier_right_aux1_z_z, s1_42,
      R_carrier_right_aux1_z_y*s1_40);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_42,
      w1.R_carrier_right_aux1_z_z*s1_40);
  const double s1_43 = w4.cosines[12];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_44 = w4.sines[12];
  w1.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_44, R_carrier_right_aux1_x_x*s1_43);
  w1.R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_44, R_carrier_right_aux2_x_z*s1_43);
  w1.R_carrier_right_y_x = fnma(R_carrier_right_aux2_y_z, s1_44, w1.R_carrier_right_aux1_y_x*s1_43);
  w1.R_carrier_right_y_z = fma(w1.R_carrier_right_aux1_y_x, s1_44, R_carrier_right_aux2_y_z*s1_43);
  w1.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_44, w1.R_carrier_right_aux1_z_x*s1_43);
  w1.R_carrier_right_z_z = fma(w1.R_carrier_right_aux1_z_x, s1_44, R_carrier_right_aux2_z_z*s1_43);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_45 = -p_wheel_front_right_y*w1.s1_41;
  w1.s1_46 = fma(p_wheel_front_right_z, w1.R_carrier_right_x_z, s1_45);
  const double s1_47 = p_wheel_front_right_z*w1.R_carrier_right_y_z;
  w1.s1_48 = fma(p_wheel_front_right_y, w1.R_carrier_right_aux2_y_y, s1_47);
  const double s1_49 = p_wheel_front_right_z*w1.R_carrier_right_z_z;
  w1.s1_50 = fma(p_wheel_front_right_y, w1.R_carrier_right_aux2_z_y, s1_49);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  w1.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double z_rear_axle_tz = state.z[Coordinate::rear_axle_tz];
  w1.r_rear_axle_aux3_z = z_rear_axle_tz + p_rear_axle_tx_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s1_51 = state.charts[3] - 0.5;
  w1.R_rear_axle_aux4_z_z = (s1_51 >= 0.0 ? 0.0 : 1.0);
  const double R_rear_axle_aux4_y_y = w4.cosines[17];
  const double R_rear_axle_aux4_x_x = R_rear_axle_aux4_y_y*w1.R_rear_axle_aux4_z_z;
  const double R_rear_axle_aux4_y_x = w4.sines[17];
  w1.s1_52 = w1.R_rear_axle_aux4_z_z*R_rear_axle_aux4_y_x;
  w1.R_rear_axle_aux4_x_z = (s1_51 >= 0.0 ? 1.0 : 0.0);
  const double s1_53 = (s1_51 >= 0.0 ? -1.0 : 0.0);
  const double R_rear_axle_aux4_z_x = R_rear_axle_aux4_y_y*s1_53;
  w1.s1_54 = R_rear_axle_aux4_y_x*s1_53;
  const double s1_55 = w4.cosines[18];
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s1_56 = w4.sines[18];
  w1.R_rear_axle_aux5_x_x = fnma(w1.R_rear_axle_aux4_x_z, s1_56, R_rear_axle_aux4_x_x*s1_55);
  const double R_rear_axle_aux5_x_z = fma(R_rear_axle_aux4_x_x, s1_56,
      w1.R_rear_axle_aux4_x_z*s1_55);
  w1.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*s1_55;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_56;
  w1.R_rear_axle_aux5_z_x = fnma(w1.R_rear_axle_aux4_z_z, s1_56, R_rear_axle_aux4_z_x*s1_55);
  const double R_rear_axle_aux5_z_z = fma(R_rear_axle_aux4_z_x, s1_56,
      w1.R_rear_axle_aux4_z_z*s1_55);
  const double s1_57 = w4.sines[19];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_58 = w4.cosines[19];
  w1.R_rear_axle_x_y = fnma(w1.s1_52, s1_58, R_rear_axle_aux5_x_z*s1_57);
  w1.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_58, w1.s1_52*s1_57);
  w1.R_rear_axle_y_y = fma(R_rear_axle_aux4_y_y, s1_58, R_rear_axle_aux5_y_z*s1_57);
  w1.R_rear_axle_y_z = fnma(R_rear_axle_aux4_y_y, s1_57, R_rear_axle_aux5_y_z*s1_58);
  w1.R_rear_axle_z_y = fnma(w1.s1_54, s1_58, R_rear_axle_aux5_z_z*s1_57);
  w1.R_rear_axle_z_z = fma(R_rear_axle_aux5_z_z, s1_58, w1.s1_54*s1_57);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  w1.s1_59 = p_wheel_rear_left_y*w1.R_rear_axle_x_y;
  w1.s1_60 = p_wheel_rear_left_y*w1.R_rear_axle_y_y;
  w1.s1_61 = p_wheel_rear_left_y*w1.R_rear_axle_z_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_62 = w1.R_carrier_left_aux1_z_x*w1.s1_22;
  const double s1_63 = fma(R_carrier_left_aux1_x_x, w1.R_carrier_left_aux2_z_y, s1_62);
  const double s1_64 = w1.R_carrier_left_aux1_y_x*w1.s1_22;
  const double s1_65 = fma(R_carrier_left_aux1_x_x, w1.R_carrier_left_aux2_y_y, s1_64);
  const double s1_66 = w1.R_carrier_left_aux1_z_z*s1_65;
  w1.s1_67 = fnma(w1.R_carrier_left_aux1_y_z, s1_63, s1_66);
  const double s1_68 = 1.0/w1.s1_67;
  w1.s1_69 = R_carrier_left_aux1_y_y*s1_68;
  w1.s1_70 = s1_65*s1_68;
  const double s1_71 = w1.R_carrier_left_aux1_y_z*w1.R_carrier_left_aux1_z_x;
  const double s1_72 = fnma(w1.R_carrier_left_aux1_z_z, w1.R_carrier_left_aux1_y_x, s1_71);
  w1.s1_73 = s1_68*s1_72;
  const double s1_74 = w1.R_carrier_left_aux1_y_x*w1.R_carrier_left_aux2_z_y;
  const double s1_75 = fnma(w1.R_carrier_left_aux1_z_x, w1.R_carrier_left_aux2_y_y, s1_74);
  w1.s1_76 = s1_68*s1_75;
  w1.s1_77 = R_carrier_left_aux1_x_x*w1.R_carrier_left_aux1_y_z*s1_68;
  w1.s1_78 = s1_63*s1_68;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_79 = w1.R_carrier_right_aux1_z_x*w1.s1_41;
  const double s1_80 = fma(R_carrier_right_aux1_x_x, w1.R_carrier_right_aux2_z_y, s1_79);
  const double s1_81 = w1.R_carrier_right_aux1_y_x*w1.s1_41;
  const double s1_82 = fma(R_carrier_right_aux1_x_x, w1.R_carrier_right_aux2_y_y, s1_81);
  const double s1_83 = w1.R_carrier_right_aux1_z_z*s1_82;
  w1.s1_84 = fnma(w1.R_carrier_right_aux1_y_z, s1_80, s1_83);
  const double s1_85 = 1.0/w1.s1_84;
  w1.s1_86 = R_carrier_right_aux1_y_y*s1_85;
  w1.s1_87 = s1_82*s1_85;
  const double s1_88 = w1.R_carrier_right_aux1_y_z*w1.R_carrier_right_aux1_z_x;
  const double s1_89 = fnma(w1.R_carrier_right_aux1_z_z, w1.R_carrier_right_aux1_y_x, s1_88);
  w1.s1_90 = s1_85*s1_89;
  const double s1_91 = w1.R_carrier_right_aux1_y_x*w1.R_carrier_right_aux2_z_y;
  const double s1_92 = fnma(w1.R_carrier_right_aux1_z_x, w1.R_carrier_right_aux2_y_y, s1_91);
  w1.s1_93 = s1_85*s1_92;
  w1.s1_94 = R_carrier_right_aux1_x_x*w1.R_carrier_right_aux1_y_z*s1_85;
  w1.s1_95 = s1_80*s1_85;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_96 = R_rear_axle_aux4_y_y*w1.R_rear_axle_aux5_x_x;
  const double s1_97 = fma(w1.s1_52, w1.R_rear_axle_aux5_y_x, s1_96);
  const double s1_98 = w1.s1_54*w1.R_rear_axle_aux5_y_x;
  const double s1_99 = fma(R_rear_axle_aux4_y_y, w1.R_rear_axle_aux5_z_x, s1_98);
  w1.s1_100 = fnma(w1.R_rear_axle_aux4_z_z, s1_97, w1.R_rear_axle_aux4_x_z*s1_99);
  const double s1_101 = 1.0/w1.s1_100;
  w1.s1_102 = R_rear_axle_aux4_y_y*w1.R_rear_axle_aux4_x_z*s1_101;
  w1.s1_103 = s1_99*s1_101;
  const double s1_104 = w1.R_rear_axle_aux4_x_z*w1.s1_54;
  w1.s1_105 = s1_101*fnma(w1.R_rear_axle_aux4_z_z, w1.s1_52, s1_104);
  const double s1_106 = w1.s1_52*w1.R_rear_axle_aux5_z_x;
  w1.s1_107 = s1_101*fnma(w1.s1_54, w1.R_rear_axle_aux5_x_x, s1_106);
  w1.s1_108 = R_rear_axle_aux4_x_x*s1_101;
  w1.s1_109 = s1_97*s1_101;
  // operations: 69 add, 166 multiply, 3 divide, 44 sin cos, 15 other

  // --- step 4: velocities ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  const double s4_1 = zd_chassis_rz*s1_3;
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  w1.w_chassis_x = zd_chassis_rx - s4_1;
  const double s4_2 = zd_chassis_rz*s1_7;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  const double s4_3 = zd_chassis_ry*s1_9;
  w1.w_chassis_y = s4_2 + s4_3;
  const double s4_4 = zd_chassis_rz*s1_11;
  const double s4_5 = zd_chassis_ry*s1_6;
  w1.w_chassis_z = s4_4 - s4_5;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double w_lower_arm_left_x = zd_lower_arm_left + w1.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double s4_6 = zd_carrier_left_rz*w1.R_carrier_left_aux1_y_z;
  const double w_carrier_left_aux1_y = w1.w_chassis_y + s4_6;
  const double s4_7 = zd_carrier_left_rz*w1.R_carrier_left_aux1_z_z;
  const double w_carrier_left_aux1_z = w1.w_chassis_z + s4_7;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double s4_8 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double w_carrier_left_aux2_x = w_lower_arm_left_x + s4_8;
  const double s4_9 = zd_carrier_left_rx*w1.R_carrier_left_aux1_y_x;
  const double w_carrier_left_aux2_y = w_carrier_left_aux1_y + s4_9;
  const double s4_10 = zd_carrier_left_rx*w1.R_carrier_left_aux1_z_x;
  const double w_carrier_left_aux2_z = w_carrier_left_aux1_z + s4_10;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  const double s4_11 = zd_carrier_left_ry*w1.s1_22;
  w1.w_carrier_left_x = w_carrier_left_aux2_x - s4_11;
  const double s4_12 = zd_carrier_left_ry*w1.R_carrier_left_aux2_y_y;
  w1.w_carrier_left_y = w_carrier_left_aux2_y + s4_12;
  const double s4_13 = zd_carrier_left_ry*w1.R_carrier_left_aux2_z_y;
  w1.w_carrier_left_z = w_carrier_left_aux2_z + s4_13;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  const double s4_14 = zd_wheel_front_left*w1.s1_22;
  w1.w_wheel_front_left_x = w1.w_carrier_left_x - s4_14;
  const double s4_15 = zd_wheel_front_left*w1.R_carrier_left_aux2_y_y;
  w1.w_wheel_front_left_y = w1.w_carrier_left_y + s4_15;
  const double s4_16 = zd_wheel_front_left*w1.R_carrier_left_aux2_z_y;
  w1.w_wheel_front_left_z = w1.w_carrier_left_z + s4_16;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double w_upper_arm_left_x = state.zd[Coordinate::upper_arm_left] + w1.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  w1.w_arb_front_left_y = zd_arb_front_left + w1.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double w_lower_arm_right_x = zd_lower_arm_right + w1.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double s4_17 = zd_carrier_right_rz*w1.R_carrier_right_aux1_y_z;
  const double w_carrier_right_aux1_y = w1.w_chassis_y + s4_17;
  const double s4_18 = zd_carrier_right_rz*w1.R_carrier_right_aux1_z_z;
  const double w_carrier_right_aux1_z = w1.w_chassis_z + s4_18;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double s4_19 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double w_carrier_right_aux2_x = w_lower_arm_right_x + s4_19;
  const double s4_20 = zd_carrier_right_rx*w1.R_carrier_right_aux1_y_x;
  const double w_carrier_right_aux2_y = w_carrier_right_aux1_y + s4_20;
  const double s4_21 = zd_carrier_right_rx*w1.R_carrier_right_aux1_z_x;
  const double w_carrier_right_aux2_z = w_carrier_right_aux1_z + s4_21;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  const double s4_22 = zd_carrier_right_ry*w1.s1_41;
  w1.w_carrier_right_x = w_carrier_right_aux2_x - s4_22;
  const double s4_23 = zd_carrier_right_ry*w1.R_carrier_right_aux2_y_y;
  w1.w_carrier_right_y = w_carrier_right_aux2_y + s4_23;
  const double s4_24 = zd_carrier_right_ry*w1.R_carrier_right_aux2_z_y;
  w1.w_carrier_right_z = w_carrier_right_aux2_z + s4_24;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  const double s4_25 = zd_wheel_front_right*w1.s1_41;
  w1.w_wheel_front_right_x = w1.w_carrier_right_x - s4_25;
  const double s4_26 = zd_wheel_front_right*w1.R_carrier_right_aux2_y_y;
  w1.w_wheel_front_right_y = w1.w_carrier_right_y + s4_26;
  const double s4_27 = zd_wheel_front_right*w1.R_carrier_right_aux2_z_y;
  w1.w_wheel_front_right_z = w1.w_carrier_right_z + s4_27;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double w_upper_arm_right_x = state.zd[Coordinate::upper_arm_right] + w1.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  w1.w_arb_front_right_y = zd_arb_front_right + w1.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double w_pitman_arm_y = zd_pitman_arm + w1.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double w_bell_crank_z = zd_bell_crank + w1.w_chassis_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s4_28 = zd_rear_axle_rz*w1.R_rear_axle_aux4_x_z;
  const double w_rear_axle_aux4_x = w1.w_chassis_x + s4_28;
  const double s4_29 = zd_rear_axle_rz*w1.R_rear_axle_aux4_z_z;
  const double w_rear_axle_aux4_z = w1.w_chassis_z + s4_29;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double s4_30 = zd_rear_axle_ry*w1.s1_52;
  const double w_rear_axle_aux5_x = w_rear_axle_aux4_x - s4_30;
  const double s4_31 = zd_rear_axle_ry*R_rear_axle_aux4_y_y;
  const double w_rear_axle_aux5_y = w1.w_chassis_y + s4_31;
  const double s4_32 = zd_rear_axle_ry*w1.s1_54;
  const double w_rear_axle_aux5_z = w_rear_axle_aux4_z - s4_32;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s4_33 = zd_rear_axle_rx*w1.R_rear_axle_aux5_x_x;
  w1.w_rear_axle_x = w_rear_axle_aux5_x + s4_33;
  const double s4_34 = zd_rear_axle_rx*w1.R_rear_axle_aux5_y_x;
  w1.w_rear_axle_y = w_rear_axle_aux5_y + s4_34;
  const double s4_35 = zd_rear_axle_rx*w1.R_rear_axle_aux5_z_x;
  w1.w_rear_axle_z = w_rear_axle_aux5_z + s4_35;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  w1.s4_36 = zd_wheel_rear_left*w1.R_rear_axle_x_y;
  w1.w_wheel_rear_left_x = w1.w_rear_axle_x + w1.s4_36;
  w1.s4_37 = zd_wheel_rear_left*w1.R_rear_axle_y_y;
  w1.w_wheel_rear_left_y = w1.w_rear_axle_y + w1.s4_37;
  w1.s4_38 = zd_wheel_rear_left*w1.R_rear_axle_z_y;
  w1.w_wheel_rear_left_z = w1.w_rear_axle_z + w1.s4_38;
  // arb_rear_left: arb_rear_left, revolute, chassis
  w1.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + w1.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  w1.s4_39 = zd_wheel_rear_right*w1.R_rear_axle_x_y;
  w1.w_wheel_rear_right_x = w1.w_rear_axle_x + w1.s4_39;
  w1.s4_40 = zd_wheel_rear_right*w1.R_rear_axle_y_y;
  w1.w_wheel_rear_right_y = w1.w_rear_axle_y + w1.s4_40;
  w1.s4_41 = zd_wheel_rear_right*w1.R_rear_axle_z_y;
  w1.w_wheel_rear_right_z = w1.w_rear_axle_z + w1.s4_41;
  // arb_rear_right: arb_rear_right, revolute, chassis
  w1.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + w1.w_chassis_y;
  // operations: 49 add, 41 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_1 = derivative.zdd[Coordinate::chassis_tz] - g_z;
  const double zdd_chassis_ty = derivative.zdd[Coordinate::chassis_ty];
  const double zdd_chassis_tx = derivative.zdd[Coordinate::chassis_tx];
  const double s7_2 = fma(zdd_chassis_tx, R_chassis_x_x, zdd_chassis_ty*R_chassis_aux5_y_x);
  w1.a_chassis_x = fma(R_chassis_z_x, s7_1, s7_2);
  const double s7_3 = fma(zdd_chassis_ty, R_chassis_y_y, zdd_chassis_tx*R_chassis_x_y);
  w1.a_chassis_y = fma(R_chassis_z_y, s7_1, s7_3);
  const double s7_4 = fma(zdd_chassis_ty, R_chassis_y_z, zdd_chassis_tx*R_chassis_x_z);
  w1.a_chassis_z = fma(R_chassis_z_z, s7_1, s7_4);
  const double zdd_chassis_rz = derivative.zdd[Coordinate::chassis_rz];
  const double s7_5 = fnma(zdd_chassis_rz, s1_3, derivative.zdd[Coordinate::chassis_rx]);
  w1.alpha_chassis_x = fnma(s4_2, s4_5, fnma(s4_3, s4_4, s7_5));
  const double zdd_chassis_ry = derivative.zdd[Coordinate::chassis_ry];
  const double s7_6 = fnma(s4_1, s4_5, fma(zdd_chassis_ry, s1_9, zdd_chassis_rz*s1_7));
  w1.alpha_chassis_y = fma(zd_chassis_rx, w1.w_chassis_z, s7_6);
  const double s7_7 = fnma(s4_1, s4_3, fnma(zdd_chassis_ry, s1_6, zdd_chassis_rz*s1_11));
  w1.alpha_chassis_z = fnma(zd_chassis_rx, w1.w_chassis_y, s7_7);
  const double s7_8 = w1.w_chassis_y*w1.w_chassis_y;
  w1.s7_9 = w1.w_chassis_z*w1.w_chassis_z;
  w1.s7_10 = w1.w_chassis_x*w1.w_chassis_x;
  w1.s7_11 = s7_8 + w1.s7_10;
  w1.s7_12 = s7_8 + w1.s7_9;
  w1.s7_13 = w1.s7_9 + w1.s7_10;
  w1.s7_14 = fms(w1.w_chassis_y, w1.w_chassis_z, w1.alpha_chassis_x);
  w1.s7_15 = fma(w1.w_chassis_y, w1.w_chassis_z, w1.alpha_chassis_x);
  w1.s7_16 = fma(w1.w_chassis_x, w1.w_chassis_z, w1.alpha_chassis_y);
  w1.s7_17 = fma(w1.w_chassis_x, w1.w_chassis_y, w1.alpha_chassis_z);
  w2.s7_18 = fms(w1.w_chassis_x, w1.w_chassis_y, w1.alpha_chassis_z);
  w2.s7_19 = fms(w1.w_chassis_x, w1.w_chassis_z, w1.alpha_chassis_y);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_20 = fnma(p_lower_arm_left_z, w1.s7_16, p_lower_arm_left_x*w1.s7_12);
  w2.s7_21 = fma(p_lower_arm_left_y, w2.s7_18, w1.a_chassis_x);
  const double a_lower_arm_left_x = w2.s7_21 - s7_20;
  const double s7_22 = fma(p_lower_arm_left_z, w1.s7_14, w1.a_chassis_y);
  const double s7_23 = fma(p_lower_arm_left_x, w1.s7_17, s7_22);
  w2.a_lower_arm_left_y = fnma(p_lower_arm_left_y, w1.s7_13, s7_23);
  const double s7_24 = p_lower_arm_left_x*w2.s7_19;
  const double s7_25 = fnma(p_lower_arm_left_z, w1.s7_11, s7_24);
  w2.s7_26 = fma(p_lower_arm_left_y, w1.s7_15, w1.a_chassis_z);
  w2.a_lower_arm_left_z = s7_25 + w2.s7_26;
  w2.alpha_lower_arm_left_x = derivative.zdd[Coordinate::lower_arm_left] + w1.alpha_chassis_x;
  const double alpha_lower_arm_left_y = fma(zd_lower_arm_left, w1.w_chassis_z, w1.alpha_chassis_y);
  const double alpha_lower_arm_left_z = fnma(zd_lower_arm_left, w1.w_chassis_y, w1.alpha_chassis_z);
  w2.s7_27 = fma(w1.w_chassis_y, w1.w_chassis_z, w2.alpha_lower_arm_left_x);
  w2.s7_28 = fms(w1.w_chassis_y, w1.w_chassis_z, w2.alpha_lower_arm_left_x);
  w2.s7_29 = fma(w_lower_arm_left_x, w_lower_arm_left_x, s7_8);
  w2.s7_30 = fma(w_lower_arm_left_x, w_lower_arm_left_x, w1.s7_9);
  const double s7_31 = fma(w1.w_chassis_z, w_lower_arm_left_x, alpha_lower_arm_left_y);
  const double s7_32 = fms(w1.w_chassis_y, w_lower_arm_left_x, alpha_lower_arm_left_z);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  w2.a_carrier_left_aux1_x = fma(w1.s1_18, s7_32, fma(w1.s1_20, s7_31, a_lower_arm_left_x));
  w2.a_carrier_left_aux1_y = fnma(w1.s1_18, w2.s7_30, fma(w1.s1_20, w2.s7_28,
      w2.a_lower_arm_left_y));
  w2.a_carrier_left_aux1_z = fnma(w1.s1_20, w2.s7_29, fma(w1.s1_18, w2.s7_27,
      w2.a_lower_arm_left_z));
  const double s7_33 = fnma(w1.w_chassis_z, s4_6, w1.w_chassis_y*s4_7);
  const double alpha_carrier_left_aux1_x = w2.alpha_lower_arm_left_x + s7_33;
  const double zdd_carrier_left_rz = derivative.zdd[Coordinate::carrier_left_rz];
  const double s7_34 = zdd_carrier_left_rz*w1.R_carrier_left_aux1_y_z;
  const double alpha_carrier_left_aux1_y = alpha_lower_arm_left_y + fnma(w_lower_arm_left_x, s4_7,
      s7_34);
  const double s7_35 = zdd_carrier_left_rz*w1.R_carrier_left_aux1_z_z;
  const double alpha_carrier_left_aux1_z = alpha_lower_arm_left_z + fma(w_lower_arm_left_x, s4_6,
      s7_35);
  const double zdd_carrier_left_rx = derivative.zdd[Coordinate::carrier_left_rx];
  const double s7_36 = zdd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double s7_37 = fnma(w_carrier_left_aux1_z, s4_9, s7_36);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double alpha_carrier_left_aux2_x = alpha_carrier_left_aux1_x + fma(w_carrier_left_aux1_y,
      s4_10, s7_37);
  const double s7_38 = zdd_carrier_left_rx*w1.R_carrier_left_aux1_y_x;
  const double s7_39 = fnma(w_lower_arm_left_x, s4_10, fma(w_carrier_left_aux1_z, s4_8, s7_38));
  const double alpha_carrier_left_aux2_y = alpha_carrier_left_aux1_y + s7_39;
  const double s7_40 = zdd_carrier_left_rx*w1.R_carrier_left_aux1_z_x;
  const double s7_41 = fma(w_lower_arm_left_x, s4_9, fnma(w_carrier_left_aux1_y, s4_8, s7_40));
  const double alpha_carrier_left_aux2_z = alpha_carrier_left_aux1_z + s7_41;
  const double zdd_carrier_left_ry = derivative.zdd[Coordinate::carrier_left_ry];
  const double s7_42 = fnma(zdd_carrier_left_ry, w1.s1_22, w_carrier_left_aux2_y*s4_13);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  w2.alpha_carrier_left_x = alpha_carrier_left_aux2_x + fnma(w_carrier_left_aux2_z, s4_12, s7_42);
  const double s7_43 = zdd_carrier_left_ry*w1.R_carrier_left_aux2_y_y;
  const double s7_44 = fnma(w_carrier_left_aux2_z, s4_11, s7_43);
  w2.alpha_carrier_left_y = alpha_carrier_left_aux2_y + fnma(w_carrier_left_aux2_x, s4_13, s7_44);
  const double s7_45 = zdd_carrier_left_ry*w1.R_carrier_left_aux2_z_y;
  const double s7_46 = fma(w_carrier_left_aux2_y, s4_11, s7_45);
  w2.alpha_carrier_left_z = alpha_carrier_left_aux2_z + fma(w_carrier_left_aux2_x, s4_12, s7_46);
  const double s7_47 = w1.w_carrier_left_y*w1.w_carrier_left_y;
  const double s7_48 = w1.w_carrier_left_z*w1.w_carrier_left_z;
  w2.s7_49 = s7_47 + s7_48;
  w2.s7_50 = fma(w1.w_carrier_left_x, w1.w_carrier_left_x, s7_47);
  w2.s7_51 = fma(w1.w_carrier_left_x, w1.w_carrier_left_x, s7_48);
  w2.s7_52 = fma(w1.w_carrier_left_x, w1.w_carrier_left_y, w2.alpha_carrier_left_z);
  w2.s7_53 = fma(w1.w_carrier_left_x, w1.w_carrier_left_z, w2.alpha_carrier_left_y);
  w2.s7_54 = fma(w1.w_carrier_left_y, w1.w_carrier_left_z, w2.alpha_carrier_left_x);
  w2.s7_55 = fms(w1.w_carrier_left_x, w1.w_carrier_left_y, w2.alpha_carrier_left_z);
  w2.s7_56 = fms(w1.w_carrier_left_x, w1.w_carrier_left_z, w2.alpha_carrier_left_y);
  w2.s7_57 = fms(w1.w_carrier_left_y, w1.w_carrier_left_z, w2.alpha_carrier_left_x);
  const double s7_58 = fnma(w1.s1_27, w2.s7_49, w2.a_carrier_left_aux1_x);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  w2.a_wheel_front_left_x = fma(w1.s1_29, w2.s7_55, fma(w1.s1_31, w2.s7_53, s7_58));
  const double s7_59 = fnma(w1.s1_29, w2.s7_51, w2.a_carrier_left_aux1_y);
  w2.a_wheel_front_left_y = fma(w1.s1_31, w2.s7_57, fma(w1.s1_27, w2.s7_52, s7_59));
  const double s7_60 = fnma(w1.s1_31, w2.s7_50, w2.a_carrier_left_aux1_z);
  w2.a_wheel_front_left_z = fma(w1.s1_27, w2.s7_56, fma(w1.s1_29, w2.s7_54, s7_60));
  const double zdd_wheel_front_left = derivative.zdd[Coordinate::wheel_front_left];
  const double s7_61 = fnma(zdd_wheel_front_left, w1.s1_22, w1.w_carrier_left_y*s4_16);
  w2.alpha_wheel_front_left_x = w2.alpha_carrier_left_x + fnma(w1.w_carrier_left_z, s4_15, s7_61);
  const double s7_62 = zdd_wheel_front_left*w1.R_carrier_left_aux2_y_y;
  const double s7_63 = fnma(w1.w_carrier_left_z, s4_14, s7_62);
  w2.alpha_wheel_front_left_y = w2.alpha_carrier_left_y + fnma(w1.w_carrier_left_x, s4_16, s7_63);
  const double s7_64 = zdd_wheel_front_left*w1.R_carrier_left_aux2_z_y;
  const double s7_65 = fma(w1.w_carrier_left_x, s4_15, fma(w1.w_carrier_left_y, s4_14, s7_64));
  w2.alpha_wheel_front_left_z = w2.alpha_carrier_left_z + s7_65;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_66 = fma(p_upper_arm_left_z, w1.s7_14, w1.a_chassis_y);
  const double s7_67 = fma(p_lower_arm_left_x, w1.s7_17, s7_66);
  w2.a_upper_arm_left_y = fnma(p_upper_arm_left_y, w1.s7_13, s7_67);
  const double s7_68 = fnma(p_upper_arm_left_z, w1.s7_11, s7_24);
  w2.a_upper_arm_left_z = s7_68 + fma(p_upper_arm_left_y, w1.s7_15, w1.a_chassis_z);
  w2.alpha_upper_arm_left_x = derivative.zdd[Coordinate::upper_arm_left] + w1.alpha_chassis_x;
  w2.s7_69 = fma(w1.w_chassis_y, w1.w_chassis_z, w2.alpha_upper_arm_left_x);
  w2.s7_70 = fms(w1.w_chassis_y, w1.w_chassis_z, w2.alpha_upper_arm_left_x);
  w2.s7_71 = fma(w_upper_arm_left_x, w_upper_arm_left_x, s7_8);
  w2.s7_72 = fma(w_upper_arm_left_x, w_upper_arm_left_x, w1.s7_9);
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_73 = -p_arb_front_left_z*w1.s7_16;
  const double s7_74 = fma(p_arb_front_left_x, w1.s7_12, s7_73);
  w2.a_arb_front_left_x = fma(p_arb_front_left_y, w2.s7_18, w1.a_chassis_x) - s7_74;
  const double s7_75 = fma(p_arb_front_left_x, w1.s7_17, w1.a_chassis_y);
  const double s7_76 = fma(p_arb_front_left_z, w1.s7_14, s7_75);
  w2.a_arb_front_left_y = fnma(p_arb_front_left_y, w1.s7_13, s7_76);
  const double s7_77 = -p_arb_front_left_z*w1.s7_11;
  const double s7_78 = fma(p_arb_front_left_x, w2.s7_19, s7_77);
  w2.a_arb_front_left_z = s7_78 + fma(p_arb_front_left_y, w1.s7_15, w1.a_chassis_z);
  w2.alpha_arb_front_left_x = fnma(zd_arb_front_left, w1.w_chassis_z, w1.alpha_chassis_x);
  w2.alpha_arb_front_left_y = derivative.zdd[Coordinate::arb_front_left] + w1.alpha_chassis_y;
  w2.alpha_arb_front_left_z = fma(zd_arb_front_left, w1.w_chassis_x, w1.alpha_chassis_z);
  w2.s7_79 = fma(w1.w_chassis_x, w1.w_chassis_z, w2.alpha_arb_front_left_y);
  w2.s7_80 = fms(w1.w_chassis_x, w1.w_chassis_z, w2.alpha_arb_front_left_y);
  w2.s7_81 = fma(w1.w_arb_front_left_y, w1.w_arb_front_left_y, w1.s7_10);
  w2.s7_82 = fma(w1.w_arb_front_left_y, w1.w_arb_front_left_y, w1.s7_9);
  w2.s7_83 = fma(w1.w_chassis_x, w1.w_arb_front_left_y, w2.alpha_arb_front_left_z);
  w2.s7_84 = fms(w1.w_chassis_z, w1.w_arb_front_left_y, w2.alpha_arb_front_left_x);
  // lower_arm_right: lower_arm_right, revolute, chassis
  w2.s7_85 = fnma(p_lower_arm_left_y, w2.s7_18, w1.a_chassis_x);
  const double a_lower_arm_right_x = w2.s7_85 - s7_20;
  w2.a_lower_arm_right_y = fma(p_lower_arm_left_y, w1.s7_13, s7_23);
  w2.s7_86 = fnma(p_lower_arm_left_y, w1.s7_15, w1.a_chassis_z);
  w2.a_lower_arm_right_z = s7_25 + w2.s7_86;
  w2.alpha_lower_arm_right_x = derivative.zdd[Coordinate::lower_arm_right] + w1.alpha_chassis_x;
  const double alpha_lower_arm_right_y = fma(zd_lower_arm_right, w1.w_chassis_z,
      w1.alpha_chassis_y);
  const double alpha_lower_arm_right_z = fnma(zd_lower_arm_right, w1.w_chassis_y,
      w1.alpha_chassis_z);
  w2.s7_87 = fma(w1.w_chassis_y, w1.w_chassis_z, w2.alpha_lower_arm_right_x);
  w2.s7_88 = fms(w1.w_chassis_y, w1.w_chassis_z, w2.alpha_lower_arm_right_x);
  w2.s7_89 = fma(w_lower_arm_right_x, w_lower_arm_right_x, s7_8);
  w2.s7_90 = fma(w_lower_arm_right_x, w_lower_arm_right_x, w1.s7_9);
  const double s7_91 = fma(w1.w_chassis_z, w_lower_arm_right_x, alpha_lower_arm_right_y);
  const double s7_92 = fms(w1.w_chassis_y, w_lower_arm_right_x, alpha_lower_arm_right_z);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  w2.a_carrier_right_aux1_x = fma(w1.s1_36, s7_92, fnma(w1.s1_38, s7_91, a_lower_arm_right_x));
  const double s7_93 = fnma(w1.s1_38, w2.s7_88, w2.a_lower_arm_right_y);
  w2.a_carrier_right_aux1_y = fnma(w1.s1_36, w2.s7_90, s7_93);
  w2.a_carrier_right_aux1_z = fma(w1.s1_38, w2.s7_89, fma(w1.s1_36, w2.s7_87,
      w2.a_lower_arm_right_z));
  const double s7_94 = fnma(w1.w_chassis_z, s4_17, w1.w_chassis_y*s4_18);
  const double alpha_carrier_right_aux1_x = w2.alpha_lower_arm_right_x + s7_94;
  const double zdd_carrier_right_rz = derivative.zdd[Coordinate::carrier_right_rz];
  const double s7_95 = zdd_carrier_right_rz*w1.R_carrier_right_aux1_y_z;
  const double alpha_carrier_right_aux1_y = alpha_lower_arm_right_y + fnma(w_lower_arm_right_x,
      s4_18, s7_95);
  const double s7_96 = zdd_carrier_right_rz*w1.R_carrier_right_aux1_z_z;
  const double alpha_carrier_right_aux1_z = alpha_lower_arm_right_z + fma(w_lower_arm_right_x,
      s4_17, s7_96);
  const double zdd_carrier_right_rx = derivative.zdd[Coordinate::carrier_right_rx];
  const double s7_97 = zdd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double s7_98 = fnma(w_carrier_right_aux1_z, s4_20, s7_97);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double alpha_carrier_right_aux2_x = alpha_carrier_right_aux1_x + fma(w_carrier_right_aux1_y,
      s4_21, s7_98);
  const double s7_99 = zdd_carrier_right_rx*w1.R_carrier_right_aux1_y_x;
  const double s7_100 = fma(w_carrier_right_aux1_z, s4_19, s7_99);
  const double alpha_carrier_right_aux2_y = alpha_carrier_right_aux1_y + fnma(w_lower_arm_right_x,
      s4_21, s7_100);
  const double s7_101 = zdd_carrier_right_rx*w1.R_carrier_right_aux1_z_x;
  const double s7_102 = fnma(w_carrier_right_aux1_y, s4_19, s7_101);
  const double alpha_carrier_right_aux2_z = alpha_carrier_right_aux1_z + fma(w_lower_arm_right_x,
      s4_20, s7_102);
  const double zdd_carrier_right_ry = derivative.zdd[Coordinate::carrier_right_ry];
  const double s7_103 = fnma(zdd_carrier_right_ry, w1.s1_41, w_carrier_right_aux2_y*s4_24);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  w2.alpha_carrier_right_x = alpha_carrier_right_aux2_x + fnma(w_carrier_right_aux2_z, s4_23,
      s7_103);
  const double s7_104 = zdd_carrier_right_ry*w1.R_carrier_right_aux2_y_y;
  const double s7_105 = fnma(w_carrier_right_aux2_z, s4_22, s7_104);
  w2.alpha_carrier_right_y = alpha_carrier_right_aux2_y + fnma(w_carrier_right_aux2_x, s4_24,
      s7_105);
  const double s7_106 = zdd_carrier_right_ry*w1.R_carrier_right_aux2_z_y;
  const double s7_107 = fma(w_carrier_right_aux2_y, s4_22, s7_106);
  w2.alpha_carrier_right_z = alpha_carrier_right_aux2_z + fma(w_carrier_right_aux2_x, s4_23,
      s7_107);
  const double s7_108 = w1.w_carrier_right_y*w1.w_carrier_right_y;
  const double s7_109 = w1.w_carrier_right_z*w1.w_carrier_right_z;
  w2.s7_110 = s7_108 + s7_109;
  w2.s7_111 = fma(w1.w_carrier_right_x, w1.w_carrier_right_x, s7_108);
  w2.s7_112 = fma(w1.w_carrier_right_x, w1.w_carrier_right_x, s7_109);
  w2.s7_113 = fma(w1.w_carrier_right_x, w1.w_carrier_right_y, w2.alpha_carrier_right_z);
  w2.s7_114 = fma(w1.w_carrier_right_x, w1.w_carrier_right_z, w2.alpha_carrier_right_y);
  w2.s7_115 = fma(w1.w_carrier_right_y, w1.w_carrier_right_z, w2.alpha_carrier_right_x);
  w2.s7_116 = fms(w1.w_carrier_right_x, w1.w_carrier_right_y, w2.alpha_carrier_right_z);
  w2.s7_117 = fms(w1.w_carrier_right_x, w1.w_carrier_right_z, w2.alpha_carrier_right_y);
  w2.s7_118 = fms(w1.w_carrier_right_y, w1.w_carrier_right_z, w2.alpha_carrier_right_x);
  const double s7_119 = fnma(w1.s1_46, w2.s7_110, w2.a_carrier_right_aux1_x);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  w2.a_wheel_front_right_x = fma(w1.s1_48, w2.s7_116, fma(w1.s1_50, w2.s7_114, s7_119));
  const double s7_120 = fnma(w1.s1_48, w2.s7_112, w2.a_carrier_right_aux1_y);
  w2.a_wheel_front_right_y = fma(w1.s1_50, w2.s7_118, fma(w1.s1_46, w2.s7_113, s7_120));
  const double s7_121 = fnma(w1.s1_50, w2.s7_111, w2.a_carrier_right_aux1_z);
  w2.a_wheel_front_right_z = fma(w1.s1_46, w2.s7_117, fma(w1.s1_48, w2.s7_115, s7_121));
  const double zdd_wheel_front_right = derivative.zdd[Coordinate::wheel_front_right];
  const double s7_122 = fnma(zdd_wheel_front_right, w1.s1_41, w1.w_carrier_right_y*s4_27);
  w2.alpha_wheel_front_right_x = w2.alpha_carrier_right_x + fnma(w1.w_carrier_right_z, s4_26,
      s7_122);
  const double s7_123 = zdd_wheel_front_right*w1.R_carrier_right_aux2_y_y;
  const double s7_124 = fnma(w1.w_carrier_right_z, s4_25, s7_123);
  w2.alpha_wheel_front_right_y = w2.alpha_carrier_right_y + fnma(w1.w_carrier_right_x, s4_27,
      s7_124);
  const double s7_125 = zdd_wheel_front_right*w1.R_carrier_right_aux2_z_y;
  const double s7_126 = fma(w1.w_carrier_right_y, s4_25, s7_125);
  w2.alpha_wheel_front_right_z = w2.alpha_carrier_right_z + fma(w1.w_carrier_right_x, s4_26,
      s7_126);
  // upper_arm_right: upper_arm_right, revolute, chassis
  w2.a_upper_arm_right_y = fma(p_upper_arm_left_y, w1.s7_13, s7_67);
  w2.a_upper_arm_right_z = s7_68 + fnma(p_upper_arm_left_y, w1.s7_15, w1.a_chassis_z);
  w2.alpha_upper_arm_right_x = derivative.zdd[Coordinate::upper_arm_right] + w1.alpha_chassis_x;
  w2.s7_127 = fma(w1.w_chassis_y, w1.w_chassis_z, w2.alpha_upper_arm_right_x);
  w2.s7_128 = fms(w1.w_chassis_y, w1.w_chassis_z, w2.alpha_upper_arm_right_x);
  w2.s7_129 = fma(w_upper_arm_right_x, w_upper_arm_right_x, s7_8);
  w2.s7_130 = fma(w_upper_arm_right_x, w_upper_arm_right_x, w1.s7_9);
  // arb_front_right: arb_front_right, revolute, chassis
  w2.a_arb_front_right_x = fnma(p_arb_front_left_y, w2.s7_18, w1.a_chassis_x) - s7_74;
  w2.a_arb_front_right_y = fma(p_arb_front_left_y, w1.s7_13, s7_76);
  w2.a_arb_front_right_z = s7_78 + fnma(p_arb_front_left_y, w1.s7_15, w1.a_chassis_z);
  w2.alpha_arb_front_right_x = fnma(zd_arb_front_right, w1.w_chassis_z, w1.alpha_chassis_x);
  w2.alpha_arb_front_right_y = derivative.zdd[Coordinate::arb_front_right] + w1.alpha_chassis_y;
  w2.alpha_arb_front_right_z = fma(zd_arb_front_right, w1.w_chassis_x, w1.alpha_chassis_z);
  w2.s7_131 = fma(w1.w_chassis_x, w1.w_chassis_z, w2.alpha_arb_front_right_y);
  w2.s7_132 = fms(w1.w_chassis_x, w1.w_chassis_z, w2.alpha_arb_front_right_y);
  w2.s7_133 = fma(w1.w_arb_front_right_y, w1.w_arb_front_right_y, w1.s7_10);
  w2.s7_134 = fma(w1.w_arb_front_right_y, w1.w_arb_front_right_y, w1.s7_9);
  w2.s7_135 = fma(w1.w_chassis_x, w1.w_arb_front_right_y, w2.alpha_arb_front_right_z);
  w2.s7_136 = fms(w1.w_chassis_z, w1.w_arb_front_right_y, w2.alpha_arb_front_right_x);
  const double s7_137 = fnma(p_pitman_arm_x, w1.s7_12, w1.a_chassis_x);
  // pitman_arm: pitman_arm, revolute, chassis
  w2.a_pitman_arm_x = fma(p_upper_arm_left_y, w2.s7_18, fma(p_pitman_arm_z, w1.s7_16, s7_137));
  const double s7_138 = fma(p_pitman_arm_z, w1.s7_14, w1.a_chassis_y);
  const double s7_139 = fma(p_pitman_arm_x, w1.s7_17, s7_138);
  w2.a_pitman_arm_y = fnma(p_upper_arm_left_y, w1.s7_13, s7_139);
  const double s7_140 = fnma(p_pitman_arm_z, w1.s7_11, w1.a_chassis_z);
  w2.a_pitman_arm_z = fma(p_upper_arm_left_y, w1.s7_15, fma(p_pitman_arm_x, w2.s7_19, s7_140));
  const double alpha_pitman_arm_x = fnma(zd_pitman_arm, w1.w_chassis_z, w1.alpha_chassis_x);
  w2.alpha_pitman_arm_y = derivative.zdd[Coordinate::pitman_arm] + w1.alpha_chassis_y;
  const double alpha_pitman_arm_z = fma(zd_pitman_arm, w1.w_chassis_x, w1.alpha_chassis_z);
  w2.s7_141 = fma(w1.w_chassis_x, w1.w_chassis_z, w2.alpha_pitman_arm_y);
  w2.s7_142 = fms(w1.w_chassis_x, w1.w_chassis_z, w2.alpha_pitman_arm_y);
  w2.s7_143 = fma(w_pitman_arm_y, w_pitman_arm_y, w1.s7_10);
  w2.s7_144 = fma(w_pitman_arm_y, w_pitman_arm_y, w1.s7_9);
  w2.s7_145 = fma(w1.w_chassis_x, w_pitman_arm_y, alpha_pitman_arm_z);
  w2.s7_146 = fms(w1.w_chassis_z, w_pitman_arm_y, alpha_pitman_arm_x);
  // bell_crank: bell_crank, revolute, chassis
  const double s7_147 = fnma(p_bell_crank_x, w1.s7_12, w1.a_chassis_x);
  w2.a_bell_crank_x = fma(p_bell_crank_z, w1.s7_16, s7_147);
  const double s7_148 = fma(p_bell_crank_z, w1.s7_14, w1.a_chassis_y);
  w2.a_bell_crank_y = fma(p_bell_crank_x, w1.s7_17, s7_148);
  const double s7_149 = fnma(p_bell_crank_z, w1.s7_11, w1.a_chassis_z);
  w2.a_bell_crank_z = fma(p_bell_crank_x, w2.s7_19, s7_149);
  const double alpha_bell_crank_x = fma(zd_bell_crank, w1.w_chassis_y, w1.alpha_chassis_x);
  const double alpha_bell_crank_y = fnma(zd_bell_crank, w1.w_chassis_x, w1.alpha_chassis_y);
  w2.alpha_bell_crank_z = derivative.zdd[Coordinate::bell_crank] + w1.alpha_chassis_z;
  w2.s7_150 = fma(w1.w_chassis_x, w1.w_chassis_y, w2.alpha_bell_crank_z);
  w2.s7_151 = fms(w1.w_chassis_x, w1.w_chassis_y, w2.alpha_bell_crank_z);
  w2.s7_152 = fma(w_bell_crank_z, w_bell_crank_z, s7_8);
  w2.s7_153 = fma(w_bell_crank_z, w_bell_crank_z, w1.s7_10);
  w2.s7_154 = fma(w1.w_chassis_y, w_bell_crank_z, alpha_bell_crank_x);
  w2.s7_155 = fms(w1.w_chassis_x, w_bell_crank_z, alpha_bell_crank_y);
  const double s7_156 = derivative.zdd[Coordinate::rear_axle_tx] + w1.a_chassis_x;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double a_rear_axle_aux1_x = fnma(w1.r_rear_axle_aux1_x, w1.s7_12, s7_156) - s7_73;
  const double s7_157 = fma(w1.r_rear_axle_aux1_x, w1.s7_17, w1.a_chassis_y);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s7_158 = fma(p_arb_front_left_z, w1.s7_14, s7_157);
  const double s7_159 = fma(zd_rear_axle_tx, w1.w_chassis_z, s7_158);
  const double a_rear_axle_aux1_y = fma(zd_rear_axle_tx, w1.w_chassis_z, s7_159);
  const double s7_160 = s7_77 + fma(w1.r_rear_axle_aux1_x, w2.s7_19, w1.a_chassis_z);
  const double s7_161 = fnma(zd_rear_axle_tx, w1.w_chassis_y, s7_160);
  const double a_rear_axle_aux1_z = fnma(zd_rear_axle_tx, w1.w_chassis_y, s7_161);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s7_162 = fma(z_rear_axle_ty, w2.s7_18, a_rear_axle_aux1_x);
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double s7_163 = fnma(zd_rear_axle_ty, w1.w_chassis_z, s7_162);
  const double a_rear_axle_aux2_x = fnma(zd_rear_axle_ty, w1.w_chassis_z, s7_163);
  const double s7_164 = fnma(z_rear_axle_ty, w1.s7_13, derivative.zdd[Coordinate::rear_axle_ty]);
  const double a_rear_axle_aux2_y = a_rear_axle_aux1_y + s7_164;
  const double s7_165 = fma(z_rear_axle_ty, w1.s7_15, a_rear_axle_aux1_z);
  const double s7_166 = fma(zd_rear_axle_ty, w1.w_chassis_x, s7_165);
  const double a_rear_axle_aux2_z = fma(zd_rear_axle_ty, w1.w_chassis_x, s7_166);
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s7_167 = fma(z_rear_axle_tz, w1.s7_16, a_rear_axle_aux2_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double s7_168 = fma(zd_rear_axle_tz, w1.w_chassis_y, s7_167);
  w2.a_rear_axle_aux3_x = fma(zd_rear_axle_tz, w1.w_chassis_y, s7_168);
  const double s7_169 = fma(z_rear_axle_tz, w1.s7_14, a_rear_axle_aux2_y);
  const double s7_170 = fnma(zd_rear_axle_tz, w1.w_chassis_x, s7_169);
  w2.a_rear_axle_aux3_y = fnma(zd_rear_axle_tz, w1.w_chassis_x, s7_170);
  const double s7_171 = fnma(z_rear_axle_tz, w1.s7_11, derivative.zdd[Coordinate::rear_axle_tz]);
  w2.a_rear_axle_aux3_z = a_rear_axle_aux2_z + s7_171;
  const double zdd_rear_axle_rz = derivative.zdd[Coordinate::rear_axle_rz];
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s7_172 = fma(w1.w_chassis_y, s4_29, zdd_rear_axle_rz*w1.R_rear_axle_aux4_x_z);
  const double alpha_rear_axle_aux4_x = w1.alpha_chassis_x + s7_172;
  const double alpha_rear_axle_aux4_y = w1.alpha_chassis_y + fnma(w1.w_chassis_x, s4_29,
      w1.w_chassis_z*s4_28);
  const double s7_173 = fnma(w1.w_chassis_y, s4_28, zdd_rear_axle_rz*w1.R_rear_axle_aux4_z_z);
  const double alpha_rear_axle_aux4_z = w1.alpha_chassis_z + s7_173;
  const double zdd_rear_axle_ry = derivative.zdd[Coordinate::rear_axle_ry];
  const double s7_174 = fnma(zdd_rear_axle_ry, w1.s1_52, alpha_rear_axle_aux4_x);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double alpha_rear_axle_aux5_x = fnma(w1.w_chassis_y, s4_32, fnma(w_rear_axle_aux4_z, s4_31,
      s7_174));
  const double s7_175 = fnma(w_rear_axle_aux4_z, s4_30, zdd_rear_axle_ry*R_rear_axle_aux4_y_y);
  const double alpha_rear_axle_aux5_y = alpha_rear_axle_aux4_y + fma(w_rear_axle_aux4_x, s4_32,
      s7_175);
  const double s7_176 = fnma(zdd_rear_axle_ry, w1.s1_54, w1.w_chassis_y*s4_30);
  const double alpha_rear_axle_aux5_z = alpha_rear_axle_aux4_z + fma(w_rear_axle_aux4_x, s4_31,
      s7_176);
  const double zdd_rear_axle_rx = derivative.zdd[Coordinate::rear_axle_rx];
  const double s7_177 = zdd_rear_axle_rx*w1.R_rear_axle_aux5_x_x;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_178 = fma(w_rear_axle_aux5_y, s4_35, fnma(w_rear_axle_aux5_z, s4_34, s7_177));
  w2.alpha_rear_axle_x = alpha_rear_axle_aux5_x + s7_178;
  const double s7_179 = fma(w_rear_axle_aux5_z, s4_33, zdd_rear_axle_rx*w1.R_rear_axle_aux5_y_x);
  w2.alpha_rear_axle_y = alpha_rear_axle_aux5_y + fnma(w_rear_axle_aux5_x, s4_35, s7_179);
  const double s7_180 = zdd_rear_axle_rx*w1.R_rear_axle_aux5_z_x;
  const double s7_181 = fma(w_rear_axle_aux5_x, s4_34, fnma(w_rear_axle_aux5_y, s4_33, s7_180));
  w2.alpha_rear_axle_z = alpha_rear_axle_aux5_z + s7_181;
}

/// Part 2 of compute_multipliers: step 7: inertias of the bodies and forces on joints.
[[gnu::noinline]] void compute_multipliers_2(const State& state, const double* tau,
    const Derivative& derivative, ConstraintForcesWork1& __restrict w1,
    ConstraintForcesWork2& __restrict w2, ConstraintForcesWork3& __restrict w3,
    ConstraintForcesWork4& __restrict w4, ConstraintForces& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_182 = w1.w_rear_axle_y*w1.w_rear_axle_y;
  const double s7_183 = w1.w_rear_axle_x*w1.w_rear_axle_x;
  const double s7_184 = s7_182 + s7_183;
  const double s7_185 = fma(w1.w_rear_axle_z, w1.w_rear_axle_z, s7_182);
  const double s7_186 = fma(w1.w_rear_axle_z, w1.w_rear_axle_z, s7_183);
  const double s7_187 = fma(w1.w_rear_axle_x, w1.w_rear_axle_y, w2.alpha_rear_axle_z);
  const double s7_188 = fma(w1.w_rear_axle_y, w1.w_rear_axle_z, w2.alpha_rear_axle_x);
  const double s7_189 = fma(w1.w_rear_axle_x, w1.w_rear_axle_z, w2.alpha_rear_axle_y);
  const double s7_190 = fms(w1.w_rear_axle_x, w1.w_rear_axle_y, w2.alpha_rear_axle_z);
  const double s7_191 = fms(w1.w_rear_axle_y, w1.w_rear_axle_z, w2.alpha_rear_axle_x);
  const double s7_192 = fms(w1.w_rear_axle_x, w1.w_rear_axle_z, w2.alpha_rear_axle_y);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_193 = fma(w1.s1_60, s7_190, fnma(w1.s1_59, s7_185, w1.s1_61*s7_189));
  const double a_wheel_rear_left_x = w2.a_rear_axle_aux3_x + s7_193;
  const double s7_194 = fma(w1.s1_61, s7_191, fnma(w1.s1_60, s7_186, w1.s1_59*s7_187));
  const double a_wheel_rear_left_y = w2.a_rear_axle_aux3_y + s7_194;
  const double s7_195 = fma(w1.s1_59, s7_192, fnma(w1.s1_61, s7_184, w1.s1_60*s7_188));
  const double a_wheel_rear_left_z = w2.a_rear_axle_aux3_z + s7_195;
  const double zdd_wheel_rear_left = derivative.zdd[Coordinate::wheel_rear_left];
  const double s7_196 = fnma(w1.w_rear_axle_z, w1.s4_37, zdd_wheel_rear_left*w1.R_rear_axle_x_y);
  const double alpha_wheel_rear_left_x = w2.alpha_rear_axle_x + fma(w1.w_rear_axle_y, w1.s4_38,
      s7_196);
  const double s7_197 = fma(w1.w_rear_axle_z, w1.s4_36, zdd_wheel_rear_left*w1.R_rear_axle_y_y);
  const double alpha_wheel_rear_left_y = w2.alpha_rear_axle_y + fnma(w1.w_rear_axle_x, w1.s4_38,
      s7_197);
  const double s7_198 = fnma(w1.w_rear_axle_y, w1.s4_36, zdd_wheel_rear_left*w1.R_rear_axle_z_y);
  const double alpha_wheel_rear_left_z = w2.alpha_rear_axle_z + fma(w1.w_rear_axle_x, w1.s4_37,
      s7_198);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_199 = fma(p_arb_rear_left_z, w1.s7_16, -p_arb_rear_left_x*w1.s7_12);
  const double a_arb_rear_left_x = s7_199 + fma(p_arb_rear_left_y, w2.s7_18, w1.a_chassis_x);
  const double s7_200 = fnma(p_arb_rear_left_x, w1.s7_17, -p_arb_rear_left_z*w1.s7_14);
  const double a_arb_rear_left_y = fnma(p_arb_rear_left_y, w1.s7_13, w1.a_chassis_y) - s7_200;
  const double s7_201 = fma(p_arb_rear_left_x, w2.s7_19, -p_arb_rear_left_z*w1.s7_11);
  const double a_arb_rear_left_z = s7_201 + fma(p_arb_rear_left_y, w1.s7_15, w1.a_chassis_z);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double alpha_arb_rear_left_x = fnma(zd_arb_rear_left, w1.w_chassis_z, w1.alpha_chassis_x);
  const double alpha_arb_rear_left_y = derivative.zdd[Coordinate::arb_rear_left] +
      w1.alpha_chassis_y;
  const double alpha_arb_rear_left_z = fma(zd_arb_rear_left, w1.w_chassis_x, w1.alpha_chassis_z);
  const double s7_202 = fma(w1.w_chassis_x, w1.w_chassis_z, alpha_arb_rear_left_y);
  const double s7_203 = fms(w1.w_chassis_x, w1.w_chassis_z, alpha_arb_rear_left_y);
  const double s7_204 = fma(w1.w_arb_rear_left_y, w1.w_arb_rear_left_y, w1.s7_10);
  const double s7_205 = fma(w1.w_arb_rear_left_y, w1.w_arb_rear_left_y, w1.s7_9);
  const double s7_206 = fma(w1.w_chassis_x, w1.w_arb_rear_left_y, alpha_arb_rear_left_z);
  const double s7_207 = fms(w1.w_chassis_z, w1.w_arb_rear_left_y, alpha_arb_rear_left_x);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double a_wheel_rear_right_x = w2.a_rear_axle_aux3_x - s7_193;
  const double a_wheel_rear_right_y = w2.a_rear_axle_aux3_y - s7_194;
  const double a_wheel_rear_right_z = w2.a_rear_axle_aux3_z - s7_195;
  const double zdd_wheel_rear_right = derivative.zdd[Coordinate::wheel_rear_right];
  const double s7_208 = zdd_wheel_rear_right*w1.R_rear_axle_x_y;
  const double s7_209 = fnma(w1.w_rear_axle_z, w1.s4_40, s7_208);
  const double alpha_wheel_rear_right_x = w2.alpha_rear_axle_x + fma(w1.w_rear_axle_y, w1.s4_41,
      s7_209);
  const double s7_210 = fma(w1.w_rear_axle_z, w1.s4_39, zdd_wheel_rear_right*w1.R_rear_axle_y_y);
  const double alpha_wheel_rear_right_y = w2.alpha_rear_axle_y + fnma(w1.w_rear_axle_x, w1.s4_41,
      s7_210);
  const double s7_211 = zdd_wheel_rear_right*w1.R_rear_axle_z_y;
  const double s7_212 = fnma(w1.w_rear_axle_y, w1.s4_39, s7_211);
  const double alpha_wheel_rear_right_z = w2.alpha_rear_axle_z + fma(w1.w_rear_axle_x, w1.s4_40,
      s7_212);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double a_arb_rear_right_x = s7_199 + fnma(p_arb_rear_left_y, w2.s7_18, w1.a_chassis_x);
  const double a_arb_rear_right_y = fma(p_arb_rear_left_y, w1.s7_13, w1.a_chassis_y) - s7_200;
  const double a_arb_rear_right_z = s7_201 + fnma(p_arb_rear_left_y, w1.s7_15, w1.a_chassis_z);
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double alpha_arb_rear_right_x = fnma(zd_arb_rear_right, w1.w_chassis_z, w1.alpha_chassis_x);
  const double alpha_arb_rear_right_y = derivative.zdd[Coordinate::arb_rear_right] +
      w1.alpha_chassis_y;
  const double alpha_arb_rear_right_z = fma(zd_arb_rear_right, w1.w_chassis_x, w1.alpha_chassis_z);
  const double s7_213 = fma(w1.w_chassis_x, w1.w_chassis_z, alpha_arb_rear_right_y);
  const double s7_214 = fms(w1.w_chassis_x, w1.w_chassis_z, alpha_arb_rear_right_y);
  const double s7_215 = fma(w1.w_arb_rear_right_y, w1.w_arb_rear_right_y, w1.s7_10);
  const double s7_216 = fma(w1.w_arb_rear_right_y, w1.w_arb_rear_right_y, w1.s7_9);
  const double s7_217 = fma(w1.w_chassis_x, w1.w_arb_rear_right_y, alpha_arb_rear_right_z);
  const double s7_218 = fms(w1.w_chassis_z, w1.w_arb_rear_right_y, alpha_arb_rear_right_x);
  const double R_arb_front_left_x_x = w4.cosines[8];
  // arb_link_front_left
  const double R_arb_front_left_x_z = w4.sines[8];
  const double s7_219 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  w2.s7_220 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s7_219);
  const double s7_221 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  w2.s7_222 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s7_221);
  const double s7_223 = p_arb_link_front_left_to_x*w1.R_carrier_left_x_x;
  const double s7_224 = w1.s1_22 + w1.R_carrier_left_x_z;
  w3.s7_225 = fnma(p_arb_link_front_left_to_y, s7_224, s7_223);
  const double s7_226 = w1.R_carrier_left_z_z - w1.R_carrier_left_aux2_z_y;
  const double s7_227 = p_arb_link_front_left_to_x*w1.R_carrier_left_z_x;
  w3.s7_228 = fnma(p_arb_link_front_left_to_y, s7_226, s7_227);
  const double s7_229 = w1.R_carrier_left_y_z - w1.R_carrier_left_aux2_y_y;
  const double s7_230 = p_arb_link_front_left_to_x*w1.R_carrier_left_y_x;
  w3.s7_231 = fnma(p_arb_link_front_left_to_y, s7_229, s7_230);
  const double s7_232 = fma(w2.s7_79, w2.s7_220, w2.a_arb_front_left_x);
  const double s7_233 = fnma(w2.s7_82, w2.s7_222, s7_232);
  w3.s7_234 = 0.3333333333333333*fma(p_arb_link_front_left_from_y, w2.s7_18, s7_233);
  const double s7_235 = fnma(w2.s7_81, w2.s7_220, w2.a_arb_front_left_z);
  const double s7_236 = fma(w2.s7_80, w2.s7_222, s7_235);
  w3.s7_237 = 0.3333333333333333*fma(p_arb_link_front_left_from_y, w1.s7_15, s7_236);
  const double s7_238 = fnma(p_arb_link_front_left_from_y, w1.s7_13, w2.a_arb_front_left_y);
  const double s7_239 = fma(w2.s7_83, w2.s7_222, fma(w2.s7_84, w2.s7_220, s7_238));
  w3.s7_240 = 0.3333333333333333*s7_239;
  const double s7_241 = fnma(w2.s7_49, w3.s7_225, w2.a_carrier_left_aux1_x);
  const double s7_242 = fma(w2.s7_55, w3.s7_231, fma(w2.s7_53, w3.s7_228, s7_241));
  w3.s7_243 = 0.3333333333333333*s7_242;
  const double s7_244 = fma(w2.s7_56, w3.s7_225, w2.a_carrier_left_aux1_z);
  const double s7_245 = fma(w2.s7_54, w3.s7_231, fnma(w2.s7_50, w3.s7_228, s7_244));
  w3.s7_246 = 0.3333333333333333*s7_245;
  const double R_arb_front_right_x_x = w4.cosines[14];
  // arb_link_front_right
  const double R_arb_front_right_x_z = w4.sines[14];
  const double s7_247 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  w3.s7_248 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s7_247);
  const double s7_249 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  w3.s7_250 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s7_249);
  const double s7_251 = p_arb_link_front_right_to_x*w1.R_carrier_right_x_x;
  const double s7_252 = w1.R_carrier_right_x_z - w1.s1_41;
  w3.s7_253 = fnma(p_arb_link_front_left_to_y, s7_252, s7_251);
  const double s7_254 = w1.R_carrier_right_aux2_z_y + w1.R_carrier_right_z_z;
  const double s7_255 = p_arb_link_front_right_to_x*w1.R_carrier_right_z_x;
  w3.s7_256 = fnma(p_arb_link_front_left_to_y, s7_254, s7_255);
  const double s7_257 = w1.R_carrier_right_aux2_y_y + w1.R_carrier_right_y_z;
  const double s7_258 = p_arb_link_front_right_to_x*w1.R_carrier_right_y_x;
  w3.s7_259 = fnma(p_arb_link_front_left_to_y, s7_257, s7_258);
  const double s7_260 = fnma(p_arb_link_front_left_from_y, w1.s7_15, w2.a_arb_front_right_z);
  const double s7_261 = fma(w2.s7_132, w3.s7_250, fnma(w2.s7_133, w3.s7_248, s7_260));
  w3.s7_262 = 0.3333333333333333*s7_261;
  const double s7_263 = fma(p_arb_link_front_left_from_y, w1.s7_13, w2.a_arb_front_right_y);
  const double s7_264 = fma(w2.s7_135, w3.s7_250, fma(w2.s7_136, w3.s7_248, s7_263));
  w3.s7_265 = 0.3333333333333333*s7_264;
  const double s7_266 = fnma(p_arb_link_front_left_from_y, w2.s7_18, w2.a_arb_front_right_x);
  const double s7_267 = fnma(w2.s7_134, w3.s7_250, fma(w2.s7_131, w3.s7_248, s7_266));
  w3.s7_268 = 0.3333333333333333*s7_267;
  const double s7_269 = fma(w2.s7_117, w3.s7_253, w2.a_carrier_right_aux1_z);
  const double s7_270 = fma(w2.s7_115, w3.s7_259, fnma(w2.s7_111, w3.s7_256, s7_269));
  const double s7_271 = 0.3333333333333333*s7_270;
  const double s7_272 = fnma(w2.s7_110, w3.s7_253, w2.a_carrier_right_aux1_x);
  const double s7_273 = fma(w2.s7_116, w3.s7_259, fma(w2.s7_114, w3.s7_256, s7_272));
  const double s7_274 = 0.3333333333333333*s7_273;
  // drag_link
  const double R_pitman_arm_x_z = w4.sines[15];
  w3.s7_275 = -p_drag_link_from_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = w4.cosines[15];
  w3.s7_276 = -p_drag_link_from_z*R_pitman_arm_x_x;
  const double R_bell_crank_y_x = w4.sines[16];
  w3.s7_277 = p_drag_link_to_y*R_bell_crank_y_x;
  const double R_bell_crank_x_x = w4.cosines[16];
  const double s7_278 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s7_279 = fnma(w2.s7_141, w3.s7_276, fma(w2.s7_144, w3.s7_275, w2.a_pitman_arm_x));
  const double s7_280 = 1.5*s7_279;
  const double s7_281 = fma(w2.s7_154, s7_278, fnma(w2.s7_155, w3.s7_277, w2.a_bell_crank_z));
  const double s7_282 = 1.5*s7_281;
  const double s7_283 = 1.5*fma(w2.s7_151, s7_278, fma(w2.s7_152, w3.s7_277, w2.a_bell_crank_x));
  const double s7_284 = fnma(w2.s7_145, w3.s7_275, w2.a_pitman_arm_y);
  const double s7_285 = 1.5*fnma(w2.s7_146, w3.s7_276, s7_284);
  // tie_rod_left
  w3.s7_286 = -p_tie_rod_left_to_y*w1.R_carrier_left_aux2_z_y;
  w3.s7_287 = -p_tie_rod_left_to_y*w1.R_carrier_left_aux2_y_y;
  const double s7_288 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s7_289 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  w3.s7_290 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s7_288);
  w3.s7_291 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_289);
  w3.s7_292 = -p_tie_rod_left_to_y*w1.s1_22;
  const double s7_293 = p_tie_rod_left_to_z*w1.R_carrier_left_x_z;
  w3.s7_294 = w3.s7_292 + fma(p_tie_rod_left_to_x, w1.R_carrier_left_x_x, s7_293);
  const double s7_295 = p_tie_rod_left_to_z*w1.R_carrier_left_z_z;
  w3.s7_296 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_z_x, s7_295) - w3.s7_286;
  const double s7_297 = p_tie_rod_left_to_z*w1.R_carrier_left_y_z;
  w3.s7_298 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_y_x, s7_297) - w3.s7_287;
  const double s7_299 = fma(w2.s7_154, w3.s7_291, fnma(w2.s7_155, w3.s7_290, w2.a_bell_crank_z));
  w3.s7_300 = 1.1666666666666667*s7_299;
  const double s7_301 = fma(w2.s7_151, w3.s7_291, fma(w2.s7_152, w3.s7_290, w2.a_bell_crank_x));
  w3.s7_302 = 1.1666666666666667*s7_301;
  const double s7_303 = fnma(w2.s7_150, w3.s7_290, w2.a_bell_crank_y);
  w3.s7_304 = 1.1666666666666667*fnma(w2.s7_153, w3.s7_291, s7_303);
  const double s7_305 = fnma(w2.s7_49, w3.s7_294, w2.a_carrier_left_aux1_x);
  const double s7_306 = fma(w2.s7_55, w3.s7_298, fma(w2.s7_53, w3.s7_296, s7_305));
  const double s7_307 = 1.1666666666666667*s7_306;
  const double s7_308 = fma(w2.s7_52, w3.s7_294, w2.a_carrier_left_aux1_y);
  const double s7_309 = fnma(w2.s7_51, w3.s7_298, fma(w2.s7_57, w3.s7_296, s7_308));
  const double s7_310 = 1.1666666666666667*s7_309;
  // tie_rod_right
  w3.s7_311 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_289);
  w3.s7_312 = p_tie_rod_right_to_y*w1.s1_41;
  w3.s7_313 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s7_288);
  const double s7_314 = p_tie_rod_right_to_z*w1.R_carrier_right_x_z;
  w3.s7_315 = fma(p_tie_rod_right_to_x, w1.R_carrier_right_x_x, s7_314) - w3.s7_312;
  w3.s7_316 = p_tie_rod_right_to_y*w1.R_carrier_right_aux2_z_y;
  const double s7_317 = p_tie_rod_right_to_z*w1.R_carrier_right_z_z;
  w3.s7_318 = w3.s7_316 + fma(p_tie_rod_right_to_x, w1.R_carrier_right_z_x, s7_317);
  w3.s7_319 = p_tie_rod_right_to_y*w1.R_carrier_right_aux2_y_y;
  const double s7_320 = p_tie_rod_right_to_z*w1.R_carrier_right_y_z;
  w3.s7_321 = w3.s7_319 + fma(p_tie_rod_right_to_x, w1.R_carrier_right_y_x, s7_320);
  const double s7_322 = fma(w2.s7_155, w3.s7_313, fnma(w2.s7_154, w3.s7_311, w2.a_bell_crank_z));
  w3.s7_323 = 1.1666666666666667*s7_322;
  const double s7_324 = fma(w2.s7_150, w3.s7_313, fma(w2.s7_153, w3.s7_311, w2.a_bell_crank_y));
  w3.s7_325 = 1.1666666666666667*s7_324;
  const double s7_326 = fnma(w2.s7_151, w3.s7_311, w2.a_bell_crank_x);
  w3.s7_327 = 1.1666666666666667*fnma(w2.s7_152, w3.s7_313, s7_326);
  const double s7_328 = fnma(w2.s7_110, w3.s7_315, w2.a_carrier_right_aux1_x);
  const double s7_329 = fma(w2.s7_116, w3.s7_321, fma(w2.s7_114, w3.s7_318, s7_328));
  const double s7_330 = 1.1666666666666667*s7_329;
  const double s7_331 = fma(w2.s7_113, w3.s7_315, w2.a_carrier_right_aux1_y);
  const double s7_332 = fnma(w2.s7_112, w3.s7_321, fma(w2.s7_118, w3.s7_318, s7_331));
  const double s7_333 = 1.1666666666666667*s7_332;
  // long_rod_left
  const double s7_334 = fnma(p_long_rod_left_from_x, w1.s7_17, -p_long_rod_left_from_z*w1.s7_14);
  const double s7_335 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_z_x;
  const double s7_336 = fma(p_long_rod_left_to_z, w1.R_rear_axle_z_z, s7_335);
  w3.s7_337 = fma(p_long_rod_left_to_y, w1.R_rear_axle_z_y, s7_336);
  const double s7_338 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_x_x;
  const double s7_339 = fma(p_long_rod_left_to_z, w1.R_rear_axle_x_z, s7_338);
  w3.s7_340 = fma(p_long_rod_left_to_y, w1.R_rear_axle_x_y, s7_339);
  const double s7_341 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_y_x;
  const double s7_342 = fma(p_long_rod_left_to_z, w1.R_rear_axle_y_z, s7_341);
  w3.s7_343 = fma(p_long_rod_left_to_y, w1.R_rear_axle_y_y, s7_342);
  const double s7_344 = fma(p_long_rod_left_from_z, w1.s7_16, -p_long_rod_left_from_x*w1.s7_12);
  const double s7_345 = 3.0*(s7_344 + fma(p_long_rod_left_from_y, w2.s7_18, w1.a_chassis_x));
  const double s7_346 = fma(p_long_rod_left_from_x, w2.s7_19, -p_long_rod_left_from_z*w1.s7_11);
  const double s7_347 = 3.0*(s7_346 + fma(p_long_rod_left_from_y, w1.s7_15, w1.a_chassis_z));
  const double s7_348 = 3.0*(fnma(p_long_rod_left_from_y, w1.s7_13, w1.a_chassis_y) - s7_334);
  // diag_rod_left
  const double s7_349 = fnma(p_diag_rod_left_from_x, w1.s7_17, -p_diag_rod_left_from_z*w1.s7_14);
  const double s7_350 = p_diag_rod_left_to_z*w1.R_rear_axle_z_z;
  w3.s7_351 = fma(p_diag_rod_left_to_y, w1.R_rear_axle_z_y, s7_350);
  const double s7_352 = p_diag_rod_left_to_z*w1.R_rear_axle_x_z;
  w3.s7_353 = fma(p_diag_rod_left_to_y, w1.R_rear_axle_x_y, s7_352);
  const double s7_354 = p_diag_rod_left_to_y*w1.R_rear_axle_y_y;
  w3.s7_355 = fma(p_diag_rod_left_to_z, w1.R_rear_axle_y_z, s7_354);
  const double s7_356 = fma(p_diag_rod_left_from_z, w1.s7_16, -p_diag_rod_left_from_x*w1.s7_12);
  const double s7_357 = 2.6666666666666665*(w2.s7_21 + s7_356);
  const double s7_358 = fma(p_diag_rod_left_from_x, w2.s7_19, -p_diag_rod_left_from_z*w1.s7_11);
  const double s7_359 = 2.6666666666666665*(w2.s7_26 + s7_358);
  const double s7_360 = fnma(p_lower_arm_left_y, w1.s7_13, w1.a_chassis_y) - s7_349;
  const double s7_361 = 2.6666666666666665*s7_360;
  // arb_link_rear_left
  const double R_arb_rear_left_x_z = w4.sines[20];
  w3.s7_362 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_z;
  const double s7_363 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_y_x;
  const double s7_364 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_y_z, s7_363);
  const double s7_365 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_z_x;
  const double s7_366 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_z_z, s7_365);
  const double s7_367 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_x_x;
  const double s7_368 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_x_z, s7_367);
  const double R_arb_rear_left_x_x = w4.cosines[20];
  w3.s7_369 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_x;
  w3.s7_370 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_z_y, s7_366);
  w3.s7_371 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_x_y, s7_368);
  w3.s7_372 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_y_y, s7_364);
  const double s7_373 = fnma(s7_205, w3.s7_369, fnma(s7_202, w3.s7_362, a_arb_rear_left_x));
  const double s7_374 = 0.3333333333333333*fma(p_arb_link_rear_left_from_y, w2.s7_18, s7_373);
  const double s7_375 = fma(s7_203, w3.s7_369, fma(s7_204, w3.s7_362, a_arb_rear_left_z));
  const double s7_376 = 0.3333333333333333*fma(p_arb_link_rear_left_from_y, w1.s7_15, s7_375);
  const double s7_377 = fnma(s7_207, w3.s7_362, a_arb_rear_left_y);
  const double s7_378 = fnma(p_arb_link_rear_left_from_y, w1.s7_13, s7_377);
  const double s7_379 = 0.3333333333333333*fma(s7_206, w3.s7_369, s7_378);
  const double s7_380 = fma(s7_192, w3.s7_371, fnma(s7_184, w3.s7_370, w2.a_rear_axle_aux3_z));
  const double s7_381 = 0.3333333333333333*fma(s7_188, w3.s7_372, s7_380);
  const double s7_382 = fnma(s7_185, w3.s7_371, fma(s7_189, w3.s7_370, w2.a_rear_axle_aux3_x));
  const double s7_383 = 0.3333333333333333*fma(s7_190, w3.s7_372, s7_382);
  // long_rod_right
  w3.s7_384 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_z_y, s7_336);
  w3.s7_385 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_x_y, s7_339);
  w3.s7_386 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_y_y, s7_342);
  const double s7_387 = 3.0*(s7_344 + fnma(p_long_rod_left_from_y, w2.s7_18, w1.a_chassis_x));
  const double s7_388 = 3.0*(s7_346 + fnma(p_long_rod_left_from_y, w1.s7_15, w1.a_chassis_z));
  const double s7_389 = 3.0*(fma(p_long_rod_left_from_y, w1.s7_13, w1.a_chassis_y) - s7_334);
  // diag_rod_right
  w3.s7_390 = fnma(p_diag_rod_left_to_y, w1.R_rear_axle_z_y, s7_350);
  w3.s7_391 = fnma(p_diag_rod_left_to_y, w1.R_rear_axle_x_y, s7_352);
  w3.s7_392 = fms(p_diag_rod_left_to_z, w1.R_rear_axle_y_z, s7_354);
  const double s7_393 = 2.6666666666666665*(w2.s7_85 + s7_356);
  const double s7_394 = 2.6666666666666665*(w2.s7_86 + s7_358);
  const double s7_395 = fma(p_lower_arm_left_y, w1.s7_13, w1.a_chassis_y) - s7_349;
  const double s7_396 = 2.6666666666666665*s7_395;
  // arb_link_rear_right
  w3.s7_397 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_y_y, s7_364);
  w3.s7_398 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_x_y, s7_368);
  w3.s7_399 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_z_y, s7_366);
  const double R_arb_rear_right_x_z = w4.sines[21];
  w3.s7_400 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = w4.cosines[21];
  w3.s7_401 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_x;
  const double s7_402 = fnma(s7_192, w3.s7_398, fnma(s7_188, w3.s7_397, w2.a_rear_axle_aux3_z));
  const double s7_403 = 0.3333333333333333*fma(s7_184, w3.s7_399, s7_402);
  const double s7_404 = fma(s7_185, w3.s7_398, fnma(s7_190, w3.s7_397, w2.a_rear_axle_aux3_x));
  const double s7_405 = 0.3333333333333333*fnma(s7_189, w3.s7_399, s7_404);
  const double s7_406 = fnma(p_arb_link_rear_left_from_y, w1.s7_15, a_arb_rear_right_z);
  const double s7_407 = fma(s7_214, w3.s7_401, fma(s7_215, w3.s7_400, s7_406));
  const double s7_408 = 0.3333333333333333*s7_407;
  const double s7_409 = fma(p_arb_link_rear_left_from_y, w1.s7_13, a_arb_rear_right_y);
  const double s7_410 = fma(s7_217, w3.s7_401, fnma(s7_218, w3.s7_400, s7_409));
  const double s7_411 = 0.3333333333333333*s7_410;
  const double s7_412 = fnma(p_arb_link_rear_left_from_y, w2.s7_18, a_arb_rear_right_x);
  const double s7_413 = fnma(s7_216, w3.s7_401, fnma(s7_213, w3.s7_400, s7_412));
  const double s7_414 = 0.3333333333333333*s7_413;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_415 = c_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s7_416 = c_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s7_417 = fma(c_arb_rear_right_y, w2.s7_18, a_arb_rear_right_x);
  const double s7_418 = fma(s7_214, s7_416, fma(s7_215, s7_415, a_arb_rear_right_z));
  const double s7_419 = R_arb_rear_right_x_x*w1.w_chassis_x;
  const double s7_420 = fnma(R_arb_rear_right_x_z, w1.w_chassis_z, s7_419);
  const double s7_421 = I_arb_rear_right_xy*w1.w_arb_rear_right_y;
  const double s7_422 = R_arb_rear_right_x_x*alpha_arb_rear_right_x;
  const double s7_423 = R_arb_rear_right_x_z*w1.w_chassis_x;
  const double s7_424 = fma(R_arb_rear_right_x_x, w1.w_chassis_z, s7_423);
  const double s7_425 = fnma(w3.s7_401, s7_403, I_arb_rear_right_yy*alpha_arb_rear_right_y);
  const double s7_426 = m_arb_rear_right_2*fnma(s7_216, s7_416, fnma(s7_213, s7_415, s7_417));
  const double s7_427 = m_arb_rear_right_2*fma(c_arb_rear_right_y, w1.s7_15, s7_418);
  const double s7_428 = fnma(s7_415, s7_426, fnma(w3.s7_400, s7_405, s7_425));
  const double s7_429 = fnma(R_arb_rear_right_x_z, alpha_arb_rear_right_z, s7_422);
  const double s7_430 = fma(I_arb_rear_right_xy, s7_429, fnma(s7_416, s7_427, s7_428));
  const double s7_431 = fma(fma(I_arb_rear_right_xx, s7_420, s7_421), s7_424, s7_430);
  const double n_arb_rear_right_y = fnma(s7_420, I_arb_rear_right_zz*s7_424, s7_431);
  result.missing[21] = tau[Coordinate::arb_rear_right] - n_arb_rear_right_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double f_wheel_rear_right_x = m_wheel_rear_right*a_wheel_rear_right_x;
  const double f_wheel_rear_right_y = m_wheel_rear_right*a_wheel_rear_right_y;
  const double f_wheel_rear_right_z = m_wheel_rear_right*a_wheel_rear_right_z;
  const double s7_432 = w1.R_rear_axle_x_y*alpha_wheel_rear_right_x;
  const double s7_433 = fma(w1.R_rear_axle_y_y, alpha_wheel_rear_right_y, s7_432);
  const double s7_434 = fma(w1.R_rear_axle_z_y, alpha_wheel_rear_right_z, s7_433);
  const double s7_435 = I_wheel_rear_right_yy*s7_434;
  const double s7_436 = w1.R_rear_axle_x_z*w1.w_wheel_rear_right_x;
  const double s7_437 = fma(w1.R_rear_axle_y_z, w1.w_wheel_rear_right_y, s7_436);
  const double s7_438 = fma(w1.R_rear_axle_z_z, w1.w_wheel_rear_right_z, s7_437);
  const double s7_439 = w1.R_rear_axle_aux5_x_x*w1.w_wheel_rear_right_x;
  const double s7_440 = fma(w1.R_rear_axle_aux5_y_x, w1.w_wheel_rear_right_y, s7_439);
  const double s7_441 = fma(w1.R_rear_axle_aux5_z_x, w1.w_wheel_rear_right_z, s7_440);
  const double s7_442 = w1.R_rear_axle_aux5_x_x*alpha_wheel_rear_right_x;
  const double s7_443 = fma(w1.R_rear_axle_aux5_y_x, alpha_wheel_rear_right_y, s7_442);
  const double s7_444 = w1.R_rear_axle_x_y*w1.w_wheel_rear_right_x;
  const double s7_445 = fma(w1.R_rear_axle_y_y, w1.w_wheel_rear_right_y, s7_444);
  const double s7_446 = fma(w1.R_rear_axle_z_y, w1.w_wheel_rear_right_z, s7_445);
  const double s7_447 = I_wheel_rear_right_yy*s7_446;
  const double s7_448 = fma(w1.R_rear_axle_aux5_z_x, alpha_wheel_rear_right_z, s7_443);
  const double s7_449 = fma(I_wheel_rear_right_zz*s7_438, s7_446, I_wheel_rear_right_xx*s7_448);
  const double s7_450 = fnma(s7_438, s7_447, s7_449);
  const double s7_451 = w1.R_rear_axle_x_z*alpha_wheel_rear_right_x;
  const double s7_452 = fma(w1.R_rear_axle_y_z, alpha_wheel_rear_right_y, s7_451);
  const double s7_453 = fma(w1.R_rear_axle_z_z, alpha_wheel_rear_right_z, s7_452);
  const double s7_454 = fnma(I_wheel_rear_right_xx*s7_441, s7_446, s7_441*s7_447);
  const double s7_455 = fma(I_wheel_rear_right_zz, s7_453, s7_454);
  const double s7_456 = fma(w1.R_rear_axle_aux5_x_x, s7_450, w1.R_rear_axle_x_y*s7_435);
  const double n_wheel_rear_right_x = fma(w1.R_rear_axle_x_z, s7_455, s7_456);
  const double s7_457 = fma(w1.R_rear_axle_aux5_y_x, s7_450, w1.R_rear_axle_y_y*s7_435);
  const double n_wheel_rear_right_y = fma(w1.R_rear_axle_y_z, s7_455, s7_457);
  const double s7_458 = fma(w1.R_rear_axle_aux5_z_x, s7_450, w1.R_rear_axle_z_y*s7_435);
  const double n_wheel_rear_right_z = fma(w1.R_rear_axle_z_z, s7_455, s7_458);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_459 = c_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_460 = c_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s7_461 = fnma(c_arb_rear_right_y, w2.s7_18, a_arb_rear_left_x);
  const double s7_462 = fnma(c_arb_rear_right_y, w1.s7_15, a_arb_rear_left_z);
  const double s7_463 = R_arb_rear_left_x_x*w1.w_chassis_x;
  const double s7_464 = fnma(R_arb_rear_left_x_z, w1.w_chassis_z, s7_463);
  const double s7_465 = R_arb_rear_left_x_x*alpha_arb_rear_left_x;
  const double s7_466 = R_arb_rear_left_x_z*w1.w_chassis_x;
  const double s7_467 = fma(R_arb_rear_left_x_x, w1.w_chassis_z, s7_466);
  const double s7_468 = fnma(w3.s7_369, s7_381, I_arb_rear_left_yy*alpha_arb_rear_left_y);
  const double s7_469 = m_arb_rear_left_2*fnma(s7_205, s7_460, fnma(s7_202, s7_459, s7_461));
  const double s7_470 = m_arb_rear_left_2*fma(s7_203, s7_460, fma(s7_204, s7_459, s7_462));
  const double s7_471 = fnma(s7_459, s7_469, fnma(w3.s7_362, s7_383, s7_468));
  const double s7_472 = fnma(R_arb_rear_left_x_z, alpha_arb_rear_left_z, s7_465);
  const double s7_473 = fma(I_arb_rear_left_xy, w1.w_arb_rear_left_y, I_arb_rear_left_xx*s7_464);
  const double s7_474 = fma(I_arb_rear_left_xy, s7_472, fnma(s7_460, s7_470, s7_471));
  const double n_arb_rear_left_y = fnma(s7_464, I_arb_rear_left_zz*s7_467, fma(s7_473, s7_467,
      s7_474));
  result.missing[20] = tau[Coordinate::arb_rear_left] - n_arb_rear_left_y;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double f_wheel_rear_left_x = m_wheel_rear_left*a_wheel_rear_left_x;
  const double f_wheel_rear_left_y = m_wheel_rear_left*a_wheel_rear_left_y;
  const double f_wheel_rear_left_z = m_wheel_rear_left*a_wheel_rear_left_z;
  const double s7_475 = w1.R_rear_axle_x_y*alpha_wheel_rear_left_x;
  const double s7_476 = fma(w1.R_rear_axle_y_y, alpha_wheel_rear_left_y, s7_475);
  const double s7_477 = fma(w1.R_rear_axle_z_y, alpha_wheel_rear_left_z, s7_476);
  const double s7_478 = I_wheel_rear_left_yy*s7_477;
  const double s7_479 = w1.R_rear_axle_x_z*w1.w_wheel_rear_left_x;
  const double s7_480 = fma(w1.R_rear_axle_y_z, w1.w_wheel_rear_left_y, s7_479);
  const double s7_481 = fma(w1.R_rear_axle_z_z, w1.w_wheel_rear_left_z, s7_480);
  const double s7_482 = w1.R_rear_axle_aux5_x_x*w1.w_wheel_rear_left_x;
  const double s7_483 = fma(w1.R_rear_axle_aux5_y_x, w1.w_wheel_rear_left_y, s7_482);
  const double s7_484 = fma(w1.R_rear_axle_aux5_z_x, w1.w_wheel_rear_left_z, s7_483);
  const double s7_485 = w1.R_rear_axle_aux5_x_x*alpha_wheel_rear_left_x;
  const double s7_486 = fma(w1.R_rear_axle_aux5_y_x, alpha_wheel_rear_left_y, s7_485);
  const double s7_487 = w1.R_rear_axle_x_y*w1.w_wheel_rear_left_x;
  const double s7_488 = fma(w1.R_rear_axle_y_y, w1.w_wheel_rear_left_y, s7_487);
  const double s7_489 = fma(w1.R_rear_axle_z_y, w1.w_wheel_rear_left_z, s7_488);
  const double s7_490 = I_wheel_rear_left_yy*s7_489;
  const double s7_491 = fma(w1.R_rear_axle_aux5_z_x, alpha_wheel_rear_left_z, s7_486);
  const double s7_492 = fma(I_wheel_rear_left_zz*s7_481, s7_489, I_wheel_rear_left_xx*s7_491);
  const double s7_493 = fnma(s7_481, s7_490, s7_492);
  const double s7_494 = w1.R_rear_axle_x_z*alpha_wheel_rear_left_x;
  const double s7_495 = fma(w1.R_rear_axle_y_z, alpha_wheel_rear_left_y, s7_494);
  const double s7_496 = fma(w1.R_rear_axle_z_z, alpha_wheel_rear_left_z, s7_495);
  const double s7_497 = fnma(I_wheel_rear_left_xx*s7_484, s7_489, s7_484*s7_490);
  const double s7_498 = fma(I_wheel_rear_left_zz, s7_496, s7_497);
  const double s7_499 = fma(w1.R_rear_axle_aux5_x_x, s7_493, w1.R_rear_axle_x_y*s7_478);
  const double n_wheel_rear_left_x = fma(w1.R_rear_axle_x_z, s7_498, s7_499);
  const double s7_500 = fma(w1.R_rear_axle_aux5_y_x, s7_493, w1.R_rear_axle_y_y*s7_478);
  const double n_wheel_rear_left_y = fma(w1.R_rear_axle_y_z, s7_498, s7_500);
  const double s7_501 = fma(w1.R_rear_axle_aux5_z_x, s7_493, w1.R_rear_axle_z_y*s7_478);
  const double n_wheel_rear_left_z = fma(w1.R_rear_axle_z_z, s7_498, s7_501);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_502 = c_rear_axle_x*w1.R_rear_axle_aux5_y_x;
  const double s7_503 = fma(c_rear_axle_z, w1.R_rear_axle_y_z, s7_502);
  const double s7_504 = c_rear_axle_x*w1.R_rear_axle_aux5_z_x;
  const double s7_505 = fma(c_rear_axle_z, w1.R_rear_axle_z_z, s7_504);
  const double s7_506 = c_rear_axle_x*w1.R_rear_axle_aux5_x_x;
  const double s7_507 = fma(c_rear_axle_z, w1.R_rear_axle_x_z, s7_506);
  const double s7_508 = fma(s7_189, s7_505, fma(s7_190, s7_503, w2.a_rear_axle_aux3_x));
  const double s7_509 = m_rear_axle_2*fnma(s7_185, s7_507, s7_508);
  const double f_rear_axle_x = s7_509 + (s7_414 + (s7_393 + (s7_387 + (s7_374 + (s7_345 +
      s7_357)))));
  const double s7_510 = fma(s7_191, s7_505, fnma(s7_186, s7_503, w2.a_rear_axle_aux3_y));
  const double s7_511 = m_rear_axle_2*fma(s7_187, s7_507, s7_510);
  const double f_rear_axle_y = s7_511 + (s7_411 + (s7_396 + (s7_389 + (s7_379 + (s7_348 +
      s7_361)))));
  const double s7_512 = fnma(s7_184, s7_505, fma(s7_188, s7_503, w2.a_rear_axle_aux3_z));
  const double s7_513 = m_rear_axle_2*fma(s7_192, s7_507, s7_512);
  const double f_rear_axle_z = s7_513 + (s7_408 + (s7_394 + (s7_388 + (s7_376 + (s7_347 +
      s7_359)))));
  const double s7_514 = w1.R_rear_axle_x_y*w2.alpha_rear_axle_x;
  const double s7_515 = fma(w1.R_rear_axle_y_y, w2.alpha_rear_axle_y, s7_514);
  const double s7_516 = w1.R_rear_axle_x_z*w1.w_rear_axle_x;
  const double s7_517 = fma(w1.R_rear_axle_y_z, w1.w_rear_axle_y, s7_516);
  const double s7_518 = fma(w1.R_rear_axle_z_z, w1.w_rear_axle_z, s7_517);
  const double s7_519 = w1.R_rear_axle_aux5_x_x*w1.w_rear_axle_x;
  const double s7_520 = fma(w1.R_rear_axle_aux5_y_x, w1.w_rear_axle_y, s7_519);
  const double s7_521 = fma(w1.R_rear_axle_aux5_z_x, w1.w_rear_axle_z, s7_520);
  const double s7_522 = fma(I_rear_axle_xz, s7_518, I_rear_axle_xx*s7_521);
  const double s7_523 = fma(I_rear_axle_xz, s7_521, I_rear_axle_zz*s7_518);
  const double s7_524 = I_rear_axle_yy*fma(w1.R_rear_axle_z_y, w2.alpha_rear_axle_z, s7_515);
  const double s7_525 = fnma(s7_521, s7_523, fma(s7_518, s7_522, s7_524));
  const double s7_526 = w1.R_rear_axle_aux5_x_x*w2.alpha_rear_axle_x;
  const double s7_527 = fma(w1.R_rear_axle_aux5_y_x, w2.alpha_rear_axle_y, s7_526);
  const double s7_528 = fma(w1.R_rear_axle_aux5_z_x, w2.alpha_rear_axle_z, s7_527);
  const double s7_529 = w1.R_rear_axle_x_z*w2.alpha_rear_axle_x;
  const double s7_530 = fma(w1.R_rear_axle_y_z, w2.alpha_rear_axle_y, s7_529);
  const double s7_531 = fma(w1.R_rear_axle_z_z, w2.alpha_rear_axle_z, s7_530);
  const double s7_532 = w1.R_rear_axle_x_y*w1.w_rear_axle_x;
  const double s7_533 = fma(w1.R_rear_axle_y_y, w1.w_rear_axle_y, s7_532);
  const double s7_534 = fma(w1.R_rear_axle_z_y, w1.w_rear_axle_z, s7_533);
  const double s7_535 = I_rear_axle_yy*s7_534;
  const double s7_536 = fma(s7_523, s7_534, fma(I_rear_axle_xz, s7_531, I_rear_axle_xx*s7_528));
  const double s7_537 = fnma(s7_518, s7_535, s7_536);
  const double s7_538 = fnma(s7_522, s7_534, fma(I_rear_axle_xz, s7_528, I_rear_axle_zz*s7_531));
  const double s7_539 = fma(s7_521, s7_535, s7_538);
  const double s7_540 = fma(w3.s7_355, s7_359, fnma(w3.s7_337, s7_348, w3.s7_343*s7_347));
  const double s7_541 = fma(w3.s7_372, s7_376, fnma(w3.s7_351, s7_361, s7_540));
  const double s7_542 = fma(w3.s7_386, s7_388, fnma(w3.s7_370, s7_379, s7_541));
  const double s7_543 = fma(w3.s7_392, s7_394, fnma(w3.s7_384, s7_389, s7_542));
  const double s7_544 = fnma(w3.s7_397, s7_408, fnma(w3.s7_390, s7_396, s7_543));
  const double s7_545 = fnma(s7_505, s7_511, fma(w3.s7_399, s7_411, s7_544));
  const double s7_546 = fma(w1.R_rear_axle_x_y, s7_525, fma(s7_503, s7_513, s7_545));
  const double s7_547 = fma(w1.R_rear_axle_aux5_x_x, s7_537, s7_546);
  const double n_rear_axle_x = fma(w1.R_rear_axle_x_z, s7_539, s7_547);
  const double s7_548 = fma(w3.s7_351, s7_357, fnma(w3.s7_340, s7_347, w3.s7_337*s7_345));
  const double s7_549 = fma(w3.s7_370, s7_374, fnma(w3.s7_353, s7_359, s7_548));
  const double s7_550 = fma(w3.s7_384, s7_387, fnma(w3.s7_371, s7_376, s7_549));
  const double s7_551 = fma(w3.s7_390, s7_393, fnma(w3.s7_385, s7_388, s7_550));
  const double s7_552 = fma(w3.s7_398, s7_408, fnma(w3.s7_391, s7_394, s7_551));
  const double s7_553 = fma(s7_505, s7_509, fnma(w3.s7_399, s7_414, s7_552));
  const double s7_554 = fma(w1.R_rear_axle_y_y, s7_525, fnma(s7_507, s7_513, s7_553));
  const double s7_555 = fma(w1.R_rear_axle_aux5_y_x, s7_537, s7_554);
  const double n_rear_axle_y = fma(w1.R_rear_axle_y_z, s7_539, s7_555);
  const double s7_556 = fnma(w3.s7_355, s7_357, fnma(w3.s7_343, s7_345, w3.s7_340*s7_348));
  const double s7_557 = fnma(w3.s7_372, s7_374, fma(w3.s7_353, s7_361, s7_556));
  const double s7_558 = fnma(w3.s7_386, s7_387, fma(w3.s7_371, s7_379, s7_557));
  const double s7_559 = fnma(w3.s7_392, s7_393, fma(w3.s7_385, s7_389, s7_558));
  const double s7_560 = fnma(w3.s7_398, s7_411, fma(w3.s7_391, s7_396, s7_559));
  const double s7_561 = fnma(s7_503, s7_509, fma(w3.s7_397, s7_414, s7_560));
  const double s7_562 = fma(w1.R_rear_axle_z_y, s7_525, fma(s7_507, s7_511, s7_561));
  const double s7_563 = fma(w1.R_rear_axle_aux5_z_x, s7_537, s7_562);
  const double n_rear_axle_z = fma(w1.R_rear_axle_z_z, s7_539, s7_563);
  const double s7_564 = f_wheel_rear_right_z - f_wheel_rear_left_z;
  const double s7_565 = f_wheel_rear_left_x - f_wheel_rear_right_x;
  const double s7_566 = n_rear_axle_y + (n_wheel_rear_right_y + n_wheel_rear_left_y);
  w3.s7_567 = fma(w1.s1_61, s7_565, fma(w1.s1_59, s7_564, s7_566));
  const double s7_568 = f_wheel_rear_left_y - f_wheel_rear_right_y;
  const double s7_569 = n_rear_axle_z + (n_wheel_rear_right_z + n_wheel_rear_left_z);
  w3.s7_570 = fnma(w1.s1_60, s7_565, fma(w1.s1_59, s7_568, s7_569));
  const double s7_571 = n_rear_axle_x + (n_wheel_rear_right_x + n_wheel_rear_left_x);
  w3.s7_572 = fnma(w1.s1_61, s7_568, fnma(w1.s1_60, s7_564, s7_571));
  const double s7_573 = fnma(w1.R_rear_axle_aux5_y_x, w3.s7_567, tau[Coordinate::rear_axle_rx]);
  const double s7_574 = fnma(w1.R_rear_axle_aux5_z_x, w3.s7_570, s7_573);
  result.missing[19] = fnma(w1.R_rear_axle_aux5_x_x, w3.s7_572, s7_574);
  const double s7_575 = fnma(w4.cosines[17], w3.s7_567, tau[Coordinate::rear_axle_ry]);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  result.missing[18] = fma(w1.s1_52, w3.s7_572, fma(w1.s1_54, w3.s7_570, s7_575));
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s7_576 = fnma(w1.R_rear_axle_aux4_z_z, w3.s7_570, tau[Coordinate::rear_axle_rz]);
  result.missing[17] = fnma(w1.R_rear_axle_aux4_x_z, w3.s7_572, s7_576);
  const double s7_577 = tau[Coordinate::rear_axle_tz] - f_wheel_rear_right_z;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  w3.Q_rear_axle_tz = s7_577 - f_wheel_rear_left_z - f_rear_axle_z;
  result.missing[16] = w3.Q_rear_axle_tz;
  const double s7_578 = tau[Coordinate::rear_axle_ty] - f_wheel_rear_right_y;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  w3.Q_rear_axle_ty = s7_578 - f_wheel_rear_left_y - f_rear_axle_y;
  result.missing[15] = w3.Q_rear_axle_ty;
  const double s7_579 = tau[Coordinate::rear_axle_tx] - f_wheel_rear_right_x;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  w3.Q_rear_axle_tx = s7_579 - f_wheel_rear_left_x - f_rear_axle_x;
  result.missing[14] = w3.Q_rear_axle_tx;
  // bell_crank: bell_crank, revolute, chassis
  const double s7_580 = fma(c_bell_crank_y, R_bell_crank_y_x, -c_bell_crank_x*R_bell_crank_x_x);
  const double s7_581 = fma(c_bell_crank_x, R_bell_crank_y_x, c_bell_crank_y*R_bell_crank_x_x);
  const double s7_582 = fma(w2.s7_151, s7_581, fma(w2.s7_152, s7_580, w2.a_bell_crank_x));
  const double s7_583 = fnma(w2.s7_153, s7_581, fnma(w2.s7_150, s7_580, w2.a_bell_crank_y));
  const double s7_584 = fnma(R_bell_crank_y_x, w1.w_chassis_x, R_bell_crank_x_x*w1.w_chassis_y);
  const double s7_585 = fma(R_bell_crank_y_x, w1.w_chassis_y, R_bell_crank_x_x*w1.w_chassis_x);
  const double s7_586 = fnma(s7_278, s7_280, I_bell_crank_zz*w2.alpha_bell_crank_z);
  const double s7_587 = fnma(w3.s7_291, s7_307, fnma(w3.s7_277, s7_285, s7_586));
  const double s7_588 = fma(w3.s7_311, s7_330, fnma(w3.s7_290, s7_310, s7_587));
  const double s7_589 = fnma(s7_581, m_bell_crank_2*s7_582, fma(w3.s7_313, s7_333, s7_588));
  const double s7_590 = fma(I_bell_crank_xy, s7_585, I_bell_crank_yy*s7_584);
  const double s7_591 = fma(s7_585, s7_590, fnma(s7_580, m_bell_crank_2*s7_583, s7_589));
  const double s7_592 = fma(I_bell_crank_xy, s7_584, I_bell_crank_xx*s7_585);
  const double n_bell_crank_z = fnma(s7_584, s7_592, s7_591);
  result.missing[13] = tau[Coordinate::bell_crank] - n_bell_crank_z;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_593 = -c_pitman_arm_z*R_pitman_arm_x_z;
  const double s7_594 = -c_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_595 = fnma(w2.s7_141, s7_594, fma(w2.s7_144, s7_593, w2.a_pitman_arm_x));
  const double s7_596 = fma(w2.s7_143, s7_594, fnma(w2.s7_142, s7_593, w2.a_pitman_arm_z));
  const double s7_597 = fnma(R_pitman_arm_x_z, w1.w_chassis_z, R_pitman_arm_x_x*w1.w_chassis_x);
  const double s7_598 = fma(R_pitman_arm_x_x, w1.w_chassis_z, R_pitman_arm_x_z*w1.w_chassis_x);
  const double s7_599 = fma(w3.s7_275, s7_282, I_pitman_arm_yy*w2.alpha_pitman_arm_y);
  const double s7_600 = fnma(s7_594, m_pitman_arm_2*s7_595, fnma(w3.s7_276, s7_283, s7_599));
  const double s7_601 = fma(s7_593, m_pitman_arm_2*s7_596, s7_600);
  const double s7_602 = fma(I_pitman_arm_xx*s7_597, s7_598, s7_601);
  const double n_pitman_arm_y = fnma(s7_597, I_pitman_arm_zz*s7_598, s7_602);
  w3.Q_pitman_arm = tau[Coordinate::pitman_arm] - n_pitman_arm_y;
  result.missing[12] = w3.Q_pitman_arm;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_603 = c_arb_front_right_z*R_arb_front_right_x_x;
  const double s7_604 = fnma(c_arb_front_right_x, R_arb_front_right_x_z, s7_603);
  const double s7_605 = c_arb_front_right_z*R_arb_front_right_x_z;
  const double s7_606 = fma(c_arb_front_right_x, R_arb_front_right_x_x, s7_605);
  const double s7_607 = fma(c_arb_front_right_y, w2.s7_18, w2.a_arb_front_right_x);
  const double s7_608 = fnma(w2.s7_134, s7_606, fma(w2.s7_131, s7_604, s7_607));
  const double s7_609 = fma(w2.s7_132, s7_606, fnma(w2.s7_133, s7_604, w2.a_arb_front_right_z));
  const double s7_610 = R_arb_front_right_x_x*w2.alpha_arb_front_right_x;
  const double s7_611 = R_arb_front_right_x_z*w2.alpha_arb_front_right_x;
  const double s7_612 = R_arb_front_right_x_x*w1.w_chassis_x;
  const double s7_613 = fnma(R_arb_front_right_x_z, w1.w_chassis_z, s7_612);
  const double s7_614 = R_arb_front_right_x_z*w1.w_chassis_x;
  const double s7_615 = fma(R_arb_front_right_x_x, w1.w_chassis_z, s7_614);
  const double s7_616 = I_arb_front_right_xx*s7_613;
  const double s7_617 = fma(I_arb_front_right_xy, w1.w_arb_front_right_y, s7_616);
  const double s7_618 = I_arb_front_right_yz*w1.w_arb_front_right_y;
  const double s7_619 = fma(I_arb_front_right_xz, s7_613, s7_618);
  const double s7_620 = fnma(w3.s7_250, s7_271, I_arb_front_right_yy*w2.alpha_arb_front_right_y);
  const double s7_621 = fma(s7_604, m_arb_front_right_2*s7_608, fma(w3.s7_248, s7_274, s7_620));
  const double s7_622 = m_arb_front_right_2*fma(c_arb_front_right_y, w1.s7_15, s7_609);
  const double s7_623 = fnma(R_arb_front_right_x_z, w2.alpha_arb_front_right_z, s7_610);
  const double s7_624 = fma(I_arb_front_right_xy, s7_623, fnma(s7_606, s7_622, s7_621));
  const double s7_625 = fma(R_arb_front_right_x_x, w2.alpha_arb_front_right_z, s7_611);
  const double s7_626 = fma(I_arb_front_right_xz, s7_615, s7_617);
  const double s7_627 = fma(s7_615, s7_626, fma(I_arb_front_right_yz, s7_625, s7_624));
  const double n_arb_front_right_y = fnma(s7_613, fma(I_arb_front_right_zz, s7_615, s7_619),
      s7_627);
  w3.Q_arb_front_right = tau[Coordinate::arb_front_right] - n_arb_front_right_y;
  result.missing[11] = w3.Q_arb_front_right;
  const double R_upper_arm_right_z_y = w4.sines[13];
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_y_y = w4.cosines[13];
  const double s7_628 = -c_upper_arm_right_z*R_upper_arm_right_z_y;
  const double s7_629 = fma(c_upper_arm_right_y, R_upper_arm_right_y_y, s7_628);
  const double s7_630 = -c_upper_arm_right_z*R_upper_arm_right_y_y;
  const double s7_631 = fnma(c_upper_arm_right_y, R_upper_arm_right_z_y, s7_630);
  const double s7_632 = fnma(w2.s7_128, s7_631, fnma(w2.s7_130, s7_629, w2.a_upper_arm_right_y));
  const double f_upper_arm_right_y = m_upper_arm_right*s7_632;
  const double s7_633 = fma(w2.s7_129, s7_631, fma(w2.s7_127, s7_629, w2.a_upper_arm_right_z));
  const double f_upper_arm_right_z = m_upper_arm_right*s7_633;
  const double s7_634 = R_upper_arm_right_y_y*w1.w_chassis_y;
  const double s7_635 = fma(R_upper_arm_right_z_y, w1.w_chassis_z, s7_634);
  const double s7_636 = R_upper_arm_right_y_y*w1.w_chassis_z;
  const double s7_637 = fnma(R_upper_arm_right_z_y, w1.w_chassis_y, s7_636);
  const double s7_638 = I_upper_arm_right_xx*w2.alpha_upper_arm_right_x;
  const double s7_639 = fma(s7_631, f_upper_arm_right_y, s7_638);
  const double s7_640 = fma(s7_629, f_upper_arm_right_z, s7_639);
  const double s7_641 = fma(s7_635, I_upper_arm_right_zz*s7_637, s7_640);
  const double n_upper_arm_right_x = fnma(s7_637, I_upper_arm_right_yy*s7_635, s7_641);
  w3.Q_upper_arm_right = tau[Coordinate::upper_arm_right] - n_upper_arm_right_x;
  result.missing[10] = w3.Q_upper_arm_right;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  w3.f_wheel_front_right_x = m_wheel_front_right*w2.a_wheel_front_right_x;
  w3.f_wheel_front_right_y = m_wheel_front_right*w2.a_wheel_front_right_y;
  w3.f_wheel_front_right_z = m_wheel_front_right*w2.a_wheel_front_right_z;
  const double s7_642 = w1.R_carrier_right_x_z*w2.alpha_wheel_front_right_x;
  const double s7_643 = fma(w1.R_carrier_right_y_z, w2.alpha_wheel_front_right_y, s7_642);
  const double s7_644 = w1.R_carrier_right_x_x*w1.w_wheel_front_right_x;
  const double s7_645 = fma(w1.R_carrier_right_y_x, w1.w_wheel_front_right_y, s7_644);
  const double s7_646 = fma(w1.R_carrier_right_z_x, w1.w_wheel_front_right_z, s7_645);
  const double s7_647 = w1.R_carrier_right_aux2_y_y*w1.w_wheel_front_right_y;
  const double s7_648 = fnma(w1.s1_41, w1.w_wheel_front_right_x, s7_647);
  const double s7_649 = fma(w1.R_carrier_right_aux2_z_y, w1.w_wheel_front_right_z, s7_648);
  const double s7_650 = I_wheel_front_right_yy*s7_649;
  const double s7_651 = fma(w1.R_carrier_right_z_z, w2.alpha_wheel_front_right_z, s7_643);
  const double s7_652 = fma(s7_646, s7_650, I_wheel_front_right_zz*s7_651);
  const double s7_653 = fnma(s7_649, I_wheel_front_right_xx*s7_646, s7_652);
  const double s7_654 = w1.R_carrier_right_x_x*w2.alpha_wheel_front_right_x;
  const double s7_655 = fma(w1.R_carrier_right_y_x, w2.alpha_wheel_front_right_y, s7_654);
  const double s7_656 = w1.R_carrier_right_x_z*w1.w_wheel_front_right_x;
  const double s7_657 = fma(w1.R_carrier_right_y_z, w1.w_wheel_front_right_y, s7_656);
  const double s7_658 = fma(w1.R_carrier_right_z_z, w1.w_wheel_front_right_z, s7_657);
  const double s7_659 = fma(w1.R_carrier_right_z_x, w2.alpha_wheel_front_right_z, s7_655);
  const double s7_660 = fnma(s7_650, s7_658, I_wheel_front_right_xx*s7_659);
  const double s7_661 = fma(s7_649, I_wheel_front_right_zz*s7_658, s7_660);
  const double s7_662 = w1.R_carrier_right_aux2_y_y*w2.alpha_wheel_front_right_y;
  const double s7_663 = fnma(w1.s1_41, w2.alpha_wheel_front_right_x, s7_662);
  const double s7_664 = fma(w1.R_carrier_right_aux2_z_y, w2.alpha_wheel_front_right_z, s7_663);
  const double s7_665 = I_wheel_front_right_yy*s7_664;
  const double s7_666 = fma(w1.R_carrier_right_x_x, s7_661, w1.R_carrier_right_x_z*s7_653);
  w3.n_wheel_front_right_x = fnma(w1.s1_41, s7_665, s7_666);
  const double s7_667 = fma(w1.R_carrier_right_y_x, s7_661, w1.R_carrier_right_y_z*s7_653);
  w3.n_wheel_front_right_y = fma(w1.R_carrier_right_aux2_y_y, s7_665, s7_667);
  const double s7_668 = fma(w1.R_carrier_right_z_x, s7_661, w1.R_carrier_right_z_z*s7_653);
  w3.n_wheel_front_right_z = fma(w1.R_carrier_right_aux2_z_y, s7_665, s7_668);
}

/// Part 3 of compute_multipliers: step 7: inertias of the bodies and forces on joints; step 9:
/// multipliers of the closures and driving forces.
[[gnu::noinline]] void compute_multipliers_3(const State& state, const double* tau,
    ConstraintForcesWork1& __restrict w1, ConstraintForcesWork2& __restrict w2,
    ConstraintForcesWork3& __restrict w3, ConstraintForcesWork4& __restrict w4,
    ConstraintForces& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  const double s7_669 = c_carrier_right_z*w1.R_carrier_right_y_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_670 = fma(c_carrier_right_y, w1.R_carrier_right_aux2_y_y, s7_669);
  const double s7_671 = fma(c_carrier_right_x, w1.R_carrier_right_y_x, s7_670);
  const double s7_672 = c_carrier_right_z*w1.R_carrier_right_z_z;
  const double s7_673 = fma(c_carrier_right_y, w1.R_carrier_right_aux2_z_y, s7_672);
  const double s7_674 = fma(c_carrier_right_x, w1.R_carrier_right_z_x, s7_673);
  const double s7_675 = -c_carrier_right_y*w1.s1_41;
  const double s7_676 = fma(c_carrier_right_x, w1.R_carrier_right_x_x, s7_675);
  const double s7_677 = fma(c_carrier_right_z, w1.R_carrier_right_x_z, s7_676);
  const double s7_678 = fma(w2.s7_116, s7_671, w2.a_carrier_right_aux1_x);
  const double s7_679 = fnma(w2.s7_110, s7_677, fma(w2.s7_114, s7_674, s7_678));
  const double s7_680 = m_carrier_right_2*s7_679;
  const double s7_681 = fnma(w2.s7_112, s7_671, w2.a_carrier_right_aux1_y);
  const double s7_682 = m_carrier_right_2*fma(w2.s7_113, s7_677, fma(w2.s7_118, s7_674, s7_681));
  const double f_carrier_right_y = s7_682 + (w3.s7_265 + w3.s7_325);
  const double s7_683 = fma(w2.s7_115, s7_671, w2.a_carrier_right_aux1_z);
  const double s7_684 = fma(w2.s7_117, s7_677, fnma(w2.s7_111, s7_674, s7_683));
  const double s7_685 = m_carrier_right_2*s7_684;
  const double f_carrier_right_z = s7_685 + (w3.s7_262 + w3.s7_323);
  const double s7_686 = w1.R_carrier_right_aux2_y_y*w2.alpha_carrier_right_y;
  const double s7_687 = fnma(w1.s1_41, w2.alpha_carrier_right_x, s7_686);
  const double s7_688 = fma(w1.R_carrier_right_aux2_z_y, w2.alpha_carrier_right_z, s7_687);
  const double s7_689 = w1.R_carrier_right_x_z*w2.alpha_carrier_right_x;
  const double s7_690 = fma(w1.R_carrier_right_y_z, w2.alpha_carrier_right_y, s7_689);
  const double s7_691 = fma(w1.R_carrier_right_z_z, w2.alpha_carrier_right_z, s7_690);
  const double s7_692 = w1.R_carrier_right_x_x*w2.alpha_carrier_right_x;
  const double s7_693 = fma(w1.R_carrier_right_y_x, w2.alpha_carrier_right_y, s7_692);
  const double s7_694 = fma(w1.R_carrier_right_z_x, w2.alpha_carrier_right_z, s7_693);
  const double s7_695 = w1.R_carrier_right_x_x*w1.w_carrier_right_x;
  const double s7_696 = fma(w1.R_carrier_right_y_x, w1.w_carrier_right_y, s7_695);
  const double s7_697 = fma(w1.R_carrier_right_z_x, w1.w_carrier_right_z, s7_696);
  const double s7_698 = w1.R_carrier_right_aux2_y_y*w1.w_carrier_right_y;
  const double s7_699 = fnma(w1.s1_41, w1.w_carrier_right_x, s7_698);
  const double s7_700 = fma(w1.R_carrier_right_aux2_z_y, w1.w_carrier_right_z, s7_699);
  const double s7_701 = w1.R_carrier_right_x_z*w1.w_carrier_right_x;
  const double s7_702 = fma(w1.R_carrier_right_y_z, w1.w_carrier_right_y, s7_701);
  const double s7_703 = fma(w1.R_carrier_right_z_z, w1.w_carrier_right_z, s7_702);
  const double s7_704 = fma(I_carrier_right_yy, s7_700, I_carrier_right_xy*s7_697);
  const double s7_705 = fma(I_carrier_right_yz, s7_703, s7_704);
  const double s7_706 = fma(I_carrier_right_xy, s7_700, I_carrier_right_xx*s7_697);
  const double s7_707 = fma(I_carrier_right_xz, s7_703, s7_706);
  const double s7_708 = fma(I_carrier_right_zz, s7_691, I_carrier_right_yz*s7_688);
  const double s7_709 = fma(s7_697, s7_705, fma(I_carrier_right_xz, s7_694, s7_708));
  const double s7_710 = fnma(s7_700, s7_707, s7_709);
  const double s7_711 = fma(I_carrier_right_xz, s7_697, I_carrier_right_yz*s7_700);
  const double s7_712 = fma(I_carrier_right_zz, s7_703, s7_711);
  const double s7_713 = fma(I_carrier_right_xz, s7_691, I_carrier_right_xy*s7_688);
  const double s7_714 = fnma(s7_703, s7_705, fma(I_carrier_right_xx, s7_694, s7_713));
  const double s7_715 = fma(s7_700, s7_712, s7_714);
  const double s7_716 = fma(I_carrier_right_yz, s7_691, I_carrier_right_yy*s7_688);
  const double s7_717 = fma(s7_703, s7_707, fma(I_carrier_right_xy, s7_694, s7_716));
  const double s7_718 = fnma(s7_697, s7_712, s7_717);
  const double s7_719 = fnma(w3.s7_256, w3.s7_265, w3.s7_259*w3.s7_262);
  const double s7_720 = fnma(w3.s7_318, w3.s7_325, fma(w3.s7_321, w3.s7_323, s7_719));
  const double s7_721 = fma(s7_671, s7_685, fnma(s7_674, s7_682, s7_720));
  const double s7_722 = fma(w1.R_carrier_right_x_z, s7_710, s7_721);
  const double n_carrier_right_x = fnma(w1.s1_41, s7_718, fma(w1.R_carrier_right_x_x, s7_715,
      s7_722));
  const double s7_723 = fnma(w3.s7_253, w3.s7_262, w3.s7_256*w3.s7_268);
  const double s7_724 = fma(w3.s7_318, w3.s7_327, fnma(w3.s7_315, w3.s7_323, s7_723));
  const double s7_725 = fnma(s7_677, s7_685, fma(s7_674, s7_680, s7_724));
  const double s7_726 = fma(w1.R_carrier_right_y_z, s7_710, s7_725);
  const double s7_727 = fma(w1.R_carrier_right_y_x, s7_715, s7_726);
  const double n_carrier_right_y = fma(w1.R_carrier_right_aux2_y_y, s7_718, s7_727);
  const double s7_728 = fnma(w3.s7_259, w3.s7_268, w3.s7_253*w3.s7_265);
  const double s7_729 = fnma(w3.s7_321, w3.s7_327, fma(w3.s7_315, w3.s7_325, s7_728));
  const double s7_730 = fma(s7_677, s7_682, fnma(s7_671, s7_680, s7_729));
  const double s7_731 = fma(w1.R_carrier_right_z_z, s7_710, s7_730);
  const double s7_732 = fma(w1.R_carrier_right_z_x, s7_715, s7_731);
  const double n_carrier_right_z = fma(w1.R_carrier_right_aux2_z_y, s7_718, s7_732);
  const double s7_733 = w1.s1_50*w3.f_wheel_front_right_x;
  const double s7_734 = fnma(w1.s1_46, w3.f_wheel_front_right_z, s7_733);
  const double s7_735 = n_carrier_right_y + (w3.n_wheel_front_right_y + s7_734);
  const double s7_736 = w1.s1_46*w3.f_wheel_front_right_y;
  const double s7_737 = fnma(w1.s1_48, w3.f_wheel_front_right_x, s7_736);
  const double s7_738 = n_carrier_right_z + (w3.n_wheel_front_right_z + s7_737);
  const double s7_739 = w1.s1_48*w3.f_wheel_front_right_z;
  const double s7_740 = fnma(w1.s1_50, w3.f_wheel_front_right_y, s7_739);
  const double s7_741 = n_carrier_right_x + (w3.n_wheel_front_right_x + s7_740);
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double s7_742 = fnma(w1.R_carrier_right_aux2_y_y, s7_735, tau_carrier_right_ry);
  result.missing[9] = fma(w1.s1_41, s7_741, fnma(w1.R_carrier_right_aux2_z_y, s7_738, s7_742));
  const double s7_743 = w3.f_wheel_front_right_z + f_carrier_right_z;
  const double s7_744 = w3.f_wheel_front_right_y + f_carrier_right_y;
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double s7_745 = fnma(w1.R_carrier_right_aux1_y_x, s7_735, tau_carrier_right_rx);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux1_x_x = w4.cosines[10];
  const double s7_746 = fnma(w1.R_carrier_right_aux1_z_x, s7_738, s7_745);
  result.missing[8] = fnma(R_carrier_right_aux1_x_x, s7_741, s7_746);
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s7_747 = fnma(w1.R_carrier_right_aux1_y_z, s7_735, tau_carrier_right_rz);
  result.missing[7] = fnma(w1.R_carrier_right_aux1_z_z, s7_738, s7_747);
  const double R_lower_arm_right_z_y = w4.sines[9];
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_y_y = w4.cosines[9];
  const double s7_748 = -c_lower_arm_right_z*R_lower_arm_right_z_y;
  const double s7_749 = fma(c_lower_arm_right_y, R_lower_arm_right_y_y, s7_748);
  const double s7_750 = -c_lower_arm_right_z*R_lower_arm_right_y_y;
  const double s7_751 = fnma(c_lower_arm_right_y, R_lower_arm_right_z_y, s7_750);
  const double s7_752 = fnma(w2.s7_88, s7_751, fnma(w2.s7_90, s7_749, w2.a_lower_arm_right_y));
  const double f_lower_arm_right_y = m_lower_arm_right*s7_752;
  const double s7_753 = fma(w2.s7_89, s7_751, fma(w2.s7_87, s7_749, w2.a_lower_arm_right_z));
  const double f_lower_arm_right_z = m_lower_arm_right*s7_753;
  const double s7_754 = R_lower_arm_right_y_y*w1.w_chassis_y;
  const double s7_755 = fma(R_lower_arm_right_z_y, w1.w_chassis_z, s7_754);
  const double s7_756 = R_lower_arm_right_y_y*w1.w_chassis_z;
  const double s7_757 = fnma(R_lower_arm_right_z_y, w1.w_chassis_y, s7_756);
  const double s7_758 = I_lower_arm_right_xx*w2.alpha_lower_arm_right_x;
  const double s7_759 = fma(s7_751, f_lower_arm_right_y, s7_758);
  const double s7_760 = fma(s7_749, f_lower_arm_right_z, s7_759);
  const double s7_761 = fma(s7_755, I_lower_arm_right_zz*s7_757, s7_760);
  const double n_lower_arm_right_x = fnma(s7_757, I_lower_arm_right_yy*s7_755, s7_761);
  const double s7_762 = fnma(w1.s1_36, s7_743, tau[Coordinate::lower_arm_right] - s7_741);
  result.missing[6] = fnma(w1.s1_38, s7_744, s7_762) - n_lower_arm_right_x;
  const double R_arb_front_left_x_x = w4.cosines[8];
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = w4.sines[8];
  const double s7_763 = c_arb_front_left_z*R_arb_front_left_x_x;
  const double s7_764 = fnma(c_arb_front_left_x, R_arb_front_left_x_z, s7_763);
  const double s7_765 = c_arb_front_left_z*R_arb_front_left_x_z;
  const double s7_766 = fma(c_arb_front_left_x, R_arb_front_left_x_x, s7_765);
  const double s7_767 = fnma(c_arb_front_right_y, w2.s7_18, w2.a_arb_front_left_x);
  const double s7_768 = fnma(c_arb_front_right_y, w1.s7_15, w2.a_arb_front_left_z);
  const double s7_769 = R_arb_front_left_x_x*w2.alpha_arb_front_left_x;
  const double s7_770 = R_arb_front_left_x_z*w2.alpha_arb_front_left_x;
  const double s7_771 = R_arb_front_left_x_x*w1.w_chassis_x;
  const double s7_772 = fnma(R_arb_front_left_x_z, w1.w_chassis_z, s7_771);
  const double s7_773 = R_arb_front_left_x_z*w1.w_chassis_x;
  const double s7_774 = fma(R_arb_front_left_x_x, w1.w_chassis_z, s7_773);
  const double s7_775 = I_arb_front_left_xy*w1.w_arb_front_left_y;
  const double s7_776 = fma(I_arb_front_left_xx, s7_772, s7_775);
  const double s7_777 = I_arb_front_left_xz*s7_772;
  const double s7_778 = fma(I_arb_front_left_yz, w1.w_arb_front_left_y, s7_777);
  const double s7_779 = fma(w2.s7_220, w3.s7_243, I_arb_front_left_yy*w2.alpha_arb_front_left_y);
  const double s7_780 = m_arb_front_left_2*fnma(w2.s7_82, s7_766, fma(w2.s7_79, s7_764, s7_767));
  const double s7_781 = m_arb_front_left_2*fma(w2.s7_80, s7_766, fnma(w2.s7_81, s7_764, s7_768));
  const double s7_782 = fma(s7_764, s7_780, fnma(w2.s7_222, w3.s7_246, s7_779));
  const double s7_783 = fnma(R_arb_front_left_x_z, w2.alpha_arb_front_left_z, s7_769);
  const double s7_784 = fma(I_arb_front_left_xy, s7_783, fnma(s7_766, s7_781, s7_782));
  const double s7_785 = fma(R_arb_front_left_x_x, w2.alpha_arb_front_left_z, s7_770);
  const double s7_786 = fma(I_arb_front_left_xz, s7_774, s7_776);
  const double s7_787 = fma(s7_774, s7_786, fma(I_arb_front_left_yz, s7_785, s7_784));
  const double n_arb_front_left_y = fnma(s7_772, fma(I_arb_front_left_zz, s7_774, s7_778), s7_787);
  const double Q_arb_front_left = tau[Coordinate::arb_front_left] - n_arb_front_left_y;
  result.missing[5] = Q_arb_front_left;
  const double R_upper_arm_left_z_y = w4.sines[7];
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_y_y = w4.cosines[7];
  const double s7_788 = c_upper_arm_left_y*R_upper_arm_left_z_y;
  const double s7_789 = fma(c_upper_arm_left_z, R_upper_arm_left_y_y, s7_788);
  const double s7_790 = c_upper_arm_left_y*R_upper_arm_left_y_y;
  const double s7_791 = fnma(c_upper_arm_left_z, R_upper_arm_left_z_y, s7_790);
  const double s7_792 = fnma(w2.s7_72, s7_791, fma(w2.s7_70, s7_789, w2.a_upper_arm_left_y));
  const double f_upper_arm_left_y = m_upper_arm_left*s7_792;
  const double s7_793 = fma(w2.s7_69, s7_791, fnma(w2.s7_71, s7_789, w2.a_upper_arm_left_z));
  const double f_upper_arm_left_z = m_upper_arm_left*s7_793;
  const double s7_794 = R_upper_arm_left_y_y*w1.w_chassis_y;
  const double s7_795 = fma(R_upper_arm_left_z_y, w1.w_chassis_z, s7_794);
  const double s7_796 = R_upper_arm_left_y_y*w1.w_chassis_z;
  const double s7_797 = fnma(R_upper_arm_left_z_y, w1.w_chassis_y, s7_796);
  const double s7_798 = I_upper_arm_left_xx*w2.alpha_upper_arm_left_x;
  const double s7_799 = fnma(s7_789, f_upper_arm_left_y, s7_798);
  const double s7_800 = fma(s7_791, f_upper_arm_left_z, s7_799);
  const double s7_801 = fma(s7_795, I_upper_arm_left_zz*s7_797, s7_800);
  const double n_upper_arm_left_x = fnma(s7_797, I_upper_arm_left_yy*s7_795, s7_801);
  const double Q_upper_arm_left = tau[Coordinate::upper_arm_left] - n_upper_arm_left_x;
  result.missing[4] = Q_upper_arm_left;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double f_wheel_front_left_x = m_wheel_front_left*w2.a_wheel_front_left_x;
  const double f_wheel_front_left_y = m_wheel_front_left*w2.a_wheel_front_left_y;
  const double f_wheel_front_left_z = m_wheel_front_left*w2.a_wheel_front_left_z;
  const double s7_802 = w1.R_carrier_left_x_z*w2.alpha_wheel_front_left_x;
  const double s7_803 = fma(w1.R_carrier_left_y_z, w2.alpha_wheel_front_left_y, s7_802);
  const double s7_804 = w1.R_carrier_left_x_x*w1.w_wheel_front_left_x;
  const double s7_805 = fma(w1.R_carrier_left_y_x, w1.w_wheel_front_left_y, s7_804);
  const double s7_806 = fma(w1.R_carrier_left_z_x, w1.w_wheel_front_left_z, s7_805);
  const double s7_807 = w1.R_carrier_left_aux2_y_y*w1.w_wheel_front_left_y;
  const double s7_808 = fnma(w1.s1_22, w1.w_wheel_front_left_x, s7_807);
  const double s7_809 = fma(w1.R_carrier_left_aux2_z_y, w1.w_wheel_front_left_z, s7_808);
  const double s7_810 = I_wheel_front_left_yy*s7_809;
  const double s7_811 = fma(w1.R_carrier_left_z_z, w2.alpha_wheel_front_left_z, s7_803);
  const double s7_812 = fma(s7_806, s7_810, I_wheel_front_left_zz*s7_811);
  const double s7_813 = fnma(s7_809, I_wheel_front_left_xx*s7_806, s7_812);
  const double s7_814 = w1.R_carrier_left_x_x*w2.alpha_wheel_front_left_x;
  const double s7_815 = fma(w1.R_carrier_left_y_x, w2.alpha_wheel_front_left_y, s7_814);
  const double s7_816 = w1.R_carrier_left_x_z*w1.w_wheel_front_left_x;
  const double s7_817 = fma(w1.R_carrier_left_y_z, w1.w_wheel_front_left_y, s7_816);
  const double s7_818 = fma(w1.R_carrier_left_z_z, w1.w_wheel_front_left_z, s7_817);
  const double s7_819 = fma(w1.R_carrier_left_z_x, w2.alpha_wheel_front_left_z, s7_815);
  const double s7_820 = fnma(s7_810, s7_818, I_wheel_front_left_xx*s7_819);
  const double s7_821 = fma(s7_809, I_wheel_front_left_zz*s7_818, s7_820);
  const double s7_822 = w1.R_carrier_left_aux2_y_y*w2.alpha_wheel_front_left_y;
  const double s7_823 = fnma(w1.s1_22, w2.alpha_wheel_front_left_x, s7_822);
  const double s7_824 = fma(w1.R_carrier_left_aux2_z_y, w2.alpha_wheel_front_left_z, s7_823);
  const double s7_825 = I_wheel_front_left_yy*s7_824;
  const double s7_826 = fma(w1.R_carrier_left_x_x, s7_821, w1.R_carrier_left_x_z*s7_813);
  const double n_wheel_front_left_x = fnma(w1.s1_22, s7_825, s7_826);
  const double s7_827 = fma(w1.R_carrier_left_y_x, s7_821, w1.R_carrier_left_y_z*s7_813);
  const double n_wheel_front_left_y = fma(w1.R_carrier_left_aux2_y_y, s7_825, s7_827);
  const double s7_828 = fma(w1.R_carrier_left_z_x, s7_821, w1.R_carrier_left_z_z*s7_813);
  const double n_wheel_front_left_z = fma(w1.R_carrier_left_aux2_z_y, s7_825, s7_828);
  const double s7_829 = c_carrier_left_y*w1.R_carrier_left_aux2_y_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_830 = fma(c_carrier_left_x, w1.R_carrier_left_y_x, s7_829);
  const double s7_831 = fma(c_carrier_left_z, w1.R_carrier_left_y_z, s7_830);
  const double s7_832 = c_carrier_left_y*w1.R_carrier_left_aux2_z_y;
  const double s7_833 = fma(c_carrier_left_x, w1.R_carrier_left_z_x, s7_832);
  const double s7_834 = fma(c_carrier_left_z, w1.R_carrier_left_z_z, s7_833);
  const double s7_835 = fnma(c_carrier_left_y, w1.s1_22, c_carrier_left_z*w1.R_carrier_left_x_z);
  const double s7_836 = fma(c_carrier_left_x, w1.R_carrier_left_x_x, s7_835);
  const double s7_837 = fma(w2.s7_53, s7_834, fma(w2.s7_55, s7_831, w2.a_carrier_left_aux1_x));
  const double s7_838 = m_carrier_left_2*fnma(w2.s7_49, s7_836, s7_837);
  const double s7_839 = fma(w2.s7_57, s7_834, fnma(w2.s7_51, s7_831, w2.a_carrier_left_aux1_y));
  const double s7_840 = m_carrier_left_2*fma(w2.s7_52, s7_836, s7_839);
  const double f_carrier_left_y = s7_840 + (w3.s7_240 + w3.s7_304);
  const double s7_841 = fnma(w2.s7_50, s7_834, fma(w2.s7_54, s7_831, w2.a_carrier_left_aux1_z));
  const double s7_842 = m_carrier_left_2*fma(w2.s7_56, s7_836, s7_841);
  const double f_carrier_left_z = s7_842 + (w3.s7_237 + w3.s7_300);
  const double s7_843 = w1.R_carrier_left_x_z*w2.alpha_carrier_left_x;
  const double s7_844 = fma(w1.R_carrier_left_y_z, w2.alpha_carrier_left_y, s7_843);
  const double s7_845 = fma(w1.R_carrier_left_z_z, w2.alpha_carrier_left_z, s7_844);
  const double s7_846 = w1.R_carrier_left_x_x*w2.alpha_carrier_left_x;
  const double s7_847 = fma(w1.R_carrier_left_y_x, w2.alpha_carrier_left_y, s7_846);
  const double s7_848 = fma(w1.R_carrier_left_z_x, w2.alpha_carrier_left_z, s7_847);
  const double s7_849 = w1.R_carrier_left_aux2_y_y*w2.alpha_carrier_left_y;
  const double s7_850 = fnma(w1.s1_22, w2.alpha_carrier_left_x, s7_849);
  const double s7_851 = fma(w1.R_carrier_left_aux2_z_y, w2.alpha_carrier_left_z, s7_850);
  const double s7_852 = w1.R_carrier_left_x_x*w1.w_carrier_left_x;
  const double s7_853 = fma(w1.R_carrier_left_y_x, w1.w_carrier_left_y, s7_852);
  const double s7_854 = fma(w1.R_carrier_left_z_x, w1.w_carrier_left_z, s7_853);
  const double s7_855 = w1.R_carrier_left_aux2_y_y*w1.w_carrier_left_y;
  const double s7_856 = fnma(w1.s1_22, w1.w_carrier_left_x, s7_855);
  const double s7_857 = fma(w1.R_carrier_left_aux2_z_y, w1.w_carrier_left_z, s7_856);
  const double s7_858 = w1.R_carrier_left_x_z*w1.w_carrier_left_x;
  const double s7_859 = fma(w1.R_carrier_left_y_z, w1.w_carrier_left_y, s7_858);
  const double s7_860 = fma(w1.R_carrier_left_z_z, w1.w_carrier_left_z, s7_859);
  const double s7_861 = fma(I_carrier_left_xy, s7_854, I_carrier_left_yy*s7_857);
  const double s7_862 = fma(I_carrier_left_yz, s7_860, s7_861);
  const double s7_863 = fma(I_carrier_left_xy, s7_857, I_carrier_left_xx*s7_854);
  const double s7_864 = fma(I_carrier_left_xz, s7_860, s7_863);
  const double s7_865 = fma(I_carrier_left_xz, s7_848, I_carrier_left_zz*s7_845);
  const double s7_866 = fma(s7_854, s7_862, fma(I_carrier_left_yz, s7_851, s7_865));
  const double s7_867 = fnma(s7_857, s7_864, s7_866);
  const double s7_868 = fma(I_carrier_left_xz, s7_854, I_carrier_left_zz*s7_860);
  const double s7_869 = fma(I_carrier_left_yz, s7_857, s7_868);
  const double s7_870 = fma(I_carrier_left_xz, s7_845, I_carrier_left_xx*s7_848);
  const double s7_871 = fnma(s7_860, s7_862, fma(I_carrier_left_xy, s7_851, s7_870));
  const double s7_872 = fma(s7_857, s7_869, s7_871);
  const double s7_873 = fma(I_carrier_left_yz, s7_845, I_carrier_left_yy*s7_851);
  const double s7_874 = fma(s7_860, s7_864, fma(I_carrier_left_xy, s7_848, s7_873));
  const double s7_875 = fnma(s7_854, s7_869, s7_874);
  const double s7_876 = fnma(w3.s7_228, w3.s7_240, w3.s7_231*w3.s7_237);
  const double s7_877 = fnma(w3.s7_296, w3.s7_304, fma(w3.s7_298, w3.s7_300, s7_876));
  const double s7_878 = fma(s7_831, s7_842, fnma(s7_834, s7_840, s7_877));
  const double s7_879 = fma(w1.R_carrier_left_x_z, s7_867, s7_878);
  const double n_carrier_left_x = fnma(w1.s1_22, s7_875, fma(w1.R_carrier_left_x_x, s7_872,
      s7_879));
  const double s7_880 = fnma(w3.s7_225, w3.s7_237, w3.s7_228*w3.s7_234);
  const double s7_881 = fma(w3.s7_296, w3.s7_302, fnma(w3.s7_294, w3.s7_300, s7_880));
  const double s7_882 = fnma(s7_836, s7_842, fma(s7_834, s7_838, s7_881));
  const double s7_883 = fma(w1.R_carrier_left_y_z, s7_867, s7_882);
  const double s7_884 = fma(w1.R_carrier_left_y_x, s7_872, s7_883);
  const double n_carrier_left_y = fma(w1.R_carrier_left_aux2_y_y, s7_875, s7_884);
  const double s7_885 = fnma(w3.s7_231, w3.s7_234, w3.s7_225*w3.s7_240);
  const double s7_886 = fma(w3.s7_294, w3.s7_304, fnma(w3.s7_298, w3.s7_302, s7_885));
  const double s7_887 = fma(s7_836, s7_840, fnma(s7_831, s7_838, s7_886));
  const double s7_888 = fma(w1.R_carrier_left_z_z, s7_867, s7_887);
  const double s7_889 = fma(w1.R_carrier_left_z_x, s7_872, s7_888);
  const double n_carrier_left_z = fma(w1.R_carrier_left_aux2_z_y, s7_875, s7_889);
  const double s7_890 = fnma(w1.s1_27, f_wheel_front_left_z, w1.s1_31*f_wheel_front_left_x);
  const double s7_891 = n_carrier_left_y + (n_wheel_front_left_y + s7_890);
  const double s7_892 = fnma(w1.s1_29, f_wheel_front_left_x, w1.s1_27*f_wheel_front_left_y);
  const double s7_893 = n_carrier_left_z + (n_wheel_front_left_z + s7_892);
  const double s7_894 = fnma(w1.s1_31, f_wheel_front_left_y, w1.s1_29*f_wheel_front_left_z);
  const double s7_895 = n_carrier_left_x + (n_wheel_front_left_x + s7_894);
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double s7_896 = fnma(w1.R_carrier_left_aux2_y_y, s7_891, tau_carrier_left_ry);
  result.missing[3] = fma(w1.s1_22, s7_895, fnma(w1.R_carrier_left_aux2_z_y, s7_893, s7_896));
  const double s7_897 = f_wheel_front_left_z + f_carrier_left_z;
  const double s7_898 = f_wheel_front_left_y + f_carrier_left_y;
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double s7_899 = fnma(w1.R_carrier_left_aux1_y_x, s7_891, tau_carrier_left_rx);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux1_x_x = w4.cosines[4];
  const double s7_900 = fnma(w1.R_carrier_left_aux1_z_x, s7_893, s7_899);
  result.missing[2] = fnma(R_carrier_left_aux1_x_x, s7_895, s7_900);
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s7_901 = fnma(w1.R_carrier_left_aux1_y_z, s7_891, tau_carrier_left_rz);
  result.missing[1] = fnma(w1.R_carrier_left_aux1_z_z, s7_893, s7_901);
  const double R_lower_arm_left_z_y = w4.sines[3];
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_y_y = w4.cosines[3];
  const double s7_902 = c_lower_arm_left_y*R_lower_arm_left_z_y;
  const double s7_903 = fma(c_lower_arm_left_z, R_lower_arm_left_y_y, s7_902);
  const double s7_904 = c_lower_arm_left_y*R_lower_arm_left_y_y;
  const double s7_905 = fnma(c_lower_arm_left_z, R_lower_arm_left_z_y, s7_904);
  const double s7_906 = fnma(w2.s7_30, s7_905, fma(w2.s7_28, s7_903, w2.a_lower_arm_left_y));
  const double f_lower_arm_left_y = m_lower_arm_left*s7_906;
  const double s7_907 = fma(w2.s7_27, s7_905, fnma(w2.s7_29, s7_903, w2.a_lower_arm_left_z));
  const double f_lower_arm_left_z = m_lower_arm_left*s7_907;
  const double s7_908 = R_lower_arm_left_y_y*w1.w_chassis_y;
  const double s7_909 = fma(R_lower_arm_left_z_y, w1.w_chassis_z, s7_908);
  const double s7_910 = R_lower_arm_left_y_y*w1.w_chassis_z;
  const double s7_911 = fnma(R_lower_arm_left_z_y, w1.w_chassis_y, s7_910);
  const double s7_912 = I_lower_arm_left_xx*w2.alpha_lower_arm_left_x;
  const double s7_913 = fnma(s7_903, f_lower_arm_left_y, s7_912);
  const double s7_914 = fma(s7_905, f_lower_arm_left_z, s7_913);
  const double s7_915 = fma(s7_909, I_lower_arm_left_zz*s7_911, s7_914);
  const double n_lower_arm_left_x = fnma(s7_911, I_lower_arm_left_yy*s7_909, s7_915);
  const double s7_916 = fnma(w1.s1_18, s7_897, tau[Coordinate::lower_arm_left] - s7_895);
  result.missing[0] = fma(w1.s1_20, s7_898, s7_916) - n_lower_arm_left_x;
  // operations: 1134 add, 1348 multiply

  // --- step 9: multipliers of the closures and driving forces ---
  const double pivot_carrier_left_rx = fms(p_carrier_left_upper_ball_z, w1.R_carrier_left_z_z,
      w3.s7_286);
  // upper_ball_left
  const double s9_1 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s9_2 = fma(p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s9_1);
  const double s9_3 = fma(p_carrier_left_upper_ball_z, w1.R_carrier_left_x_z, w3.s7_292);
  const double s9_4 = fms(p_carrier_left_upper_ball_z, w1.R_carrier_left_y_z, w3.s7_287);
  const double pivot_carrier_right_rx = fma(p_carrier_right_upper_ball_z, w1.R_carrier_right_z_z,
      w3.s7_316);
  // upper_ball_right
  const double s9_5 = fma(p_carrier_right_upper_ball_z, w1.R_carrier_right_y_z, w3.s7_319);
  const double R_upper_arm_right_y_y = w4.cosines[13];
  const double R_upper_arm_right_z_y = w4.sines[13];
  const double s9_6 = -p_upper_arm_right_ball_z*R_upper_arm_right_y_y;
  const double s9_7 = fnma(p_upper_arm_right_ball_y, R_upper_arm_right_z_y, s9_6);
  const double s9_8 = fms(p_carrier_right_upper_ball_z, w1.R_carrier_right_x_z, w3.s7_312);
  // arb_link_front_left
  const double s9_9 = 0.35 + w2.s7_222 - w3.s7_225;
  const double s9_10 = w2.s7_220 + p_arb_front_left_z - w1.r_carrier_left_aux1_z - w3.s7_228;
  const double pivot_arb_front_left = fnma(w2.s7_222, s9_10, w2.s7_220*s9_9);
  // arb_link_front_left
  const double s9_11 = 0.72 - w1.r_carrier_left_aux1_y - w3.s7_231;
  const double s9_12 = fnma(w3.s7_231, s9_9, w3.s7_225*s9_11);
  const double s9_13 = fnma(w3.s7_225, s9_10, w3.s7_228*s9_9);
  const double s9_14 = fnma(w3.s7_228, s9_11, w3.s7_231*s9_10);
  // arb_link_front_right
  const double s9_15 = 0.35 + w3.s7_250 - w3.s7_253;
  const double s9_16 = w3.s7_248 + (w1.s1_39 + p_arb_front_right_z) - w3.s7_256;
  const double pivot_arb_front_right = fnma(w3.s7_250, s9_16, w3.s7_248*s9_15);
  // arb_link_front_right
  const double s9_17 = w3.s7_259 + (0.72 + w1.r_carrier_right_aux1_y);
  const double s9_18 = fma(w3.s7_256, s9_17, w3.s7_259*s9_16);
  const double s9_19 = fma(w3.s7_253, s9_17, w3.s7_259*s9_15);
  const double s9_20 = fnma(w3.s7_253, s9_16, w3.s7_256*s9_15);
  // drag_link
  const double s9_21 = 0.2 - w3.s7_276;
  const double s9_22 = w3.s7_277 + (1.15 - w3.s7_275);
  const double pivot_pitman_arm = fnma(w3.s7_276, s9_22, w3.s7_275*s9_21);
  // tie_rod_left
  const double s9_23 = w3.s7_296 + (w1.r_carrier_left_aux1_z - p_bell_crank_z);
  const double s9_24 = w3.s7_291 - w1.r_carrier_left_aux1_y - w3.s7_298;
  const double s9_25 = w3.s7_294 + (0.35 + w3.s7_290);
  const double s9_26 = fnma(w3.s7_296, s9_25, w3.s7_294*s9_23);
  const double s9_27 = fma(w3.s7_296, s9_24, w3.s7_298*s9_23);
  // tie_rod_right
  const double s9_28 = w3.s7_318 + (-p_bell_crank_z - w1.s1_39);
  const double s9_29 = w3.s7_321 + (w1.r_carrier_right_aux1_y + w3.s7_311);
  const double s9_30 = w3.s7_313 - 0.35 - w3.s7_315;
  const double s9_31 = fma(w3.s7_318, s9_30, w3.s7_315*s9_28);
  const double s9_32 = fnma(w3.s7_321, s9_28, w3.s7_318*s9_29);
  const double s9_33 = 1.0/pivot_carrier_right_rx;
  const double s9_34 = s9_31*s9_33;
  const double pivot_carrier_right_ry = fnma(s9_5, s9_34, fma(w3.s7_321, s9_30, w3.s7_315*s9_29));
  const double s9_35 = 1.0/pivot_carrier_right_ry;
  const double s9_36 = s9_8*s9_35;
  const double pivot_carrier_right_rz = fms(s9_32, s9_36, pivot_carrier_right_rx);
  const double s9_37 = s9_8*s9_33;
  const double s9_38 = s9_35*(s9_5*s9_37);
  const double s9_39 = 1.0/pivot_carrier_right_rz;
  const double s9_40 = fnma(s9_32, s9_38, s9_5)*s9_39;
  const double s9_41 = -p_upper_arm_right_ball_y*R_upper_arm_right_y_y;
  const double s9_42 = fma(p_upper_arm_right_ball_z, R_upper_arm_right_z_y, s9_41);
  const double pivot_upper_arm_right = fma(s9_7, s9_40, s9_42);
  const double s9_43 = 1.0/pivot_carrier_left_rx;
  const double s9_44 = s9_26*s9_43;
  const double s9_45 = fma(s9_4, s9_44, fma(w3.s7_298, s9_25, w3.s7_294*s9_24));
  const double s9_46 = 1.0/s9_45;
  const double s9_47 = s9_3*s9_46;
  const double pivot_carrier_left_rz = fms(s9_27, s9_47, pivot_carrier_left_rx);
  const double s9_48 = s9_3*s9_43;
  const double s9_49 = s9_46*(s9_4*s9_48);
  const double s9_50 = 1.0/pivot_carrier_left_rz;
  const double s9_51 = fnma(s9_27, s9_49, s9_4)*s9_50;
  const double s9_52 = p_upper_arm_left_ball_y*R_upper_arm_left_y_y;
  const double s9_53 = fnma(p_upper_arm_left_ball_z, R_upper_arm_left_z_y, s9_52);
  const double s9_54 = fma(s9_2, s9_51, s9_53);
  const double s9_55 = 16.504892200367603*std::abs(pivot_arb_front_right);
  const double s9_56 = mbgen::min(3.9625229801272064*std::abs(pivot_pitman_arm), s9_55);
  const double s9_57 = mbgen::min(16.679425973935604*std::abs(pivot_arb_front_left), s9_56);
  const double s9_58 = mbgen::min(2.7028647671567816*std::abs(pivot_carrier_right_rx), s9_57);
  const double s9_59 = mbgen::min(s9_58, 6.8514628664707224*std::abs(pivot_carrier_right_ry));
  const double s9_60 = mbgen::min(s9_59, 2.7028647671567816*std::abs(pivot_carrier_right_rz));
  const double s9_61 = mbgen::min(s9_60, 3.405476531191585*std::abs(pivot_upper_arm_right));
  const double s9_62 = mbgen::min(2.7028219055711094*std::abs(pivot_carrier_left_rx), s9_61);
  const double s9_63 = mbgen::min(6.915894223167946*std::abs(s9_45), s9_62);
  const double s9_64 = mbgen::min(2.7028219055711094*std::abs(pivot_carrier_left_rz), s9_63);
  const double s9_65 = mbgen::min(3.3636363636363633*std::abs(s9_54), s9_64);
  const double s9_66 = mbgen::min(s9_65, std::abs(w1.s1_67));
  result.pivot[0] = mbgen::min(s9_66, std::abs(w1.s1_84));
  const double s9_67 = Q_arb_front_left*(1.0/pivot_arb_front_left);
  result.lambda[6] = l_arb_link_front_left*s9_67;
  const double s9_68 = w3.Q_arb_front_right*(1.0/pivot_arb_front_right);
  result.lambda[7] = l_arb_link_front_right*s9_68;
  result.lambda[8] = l_drag_link*(w3.Q_pitman_arm*(1.0/pivot_pitman_arm));
  const double s9_69 = fms(tau_carrier_left_rx, w1.R_carrier_left_aux1_y_x, s7_891);
  const double s9_70 = fma(tau_carrier_left_ry, w1.s1_69, s9_69);
  const double s9_71 = s9_43*fma(s9_13, s9_67, fnma(tau_carrier_left_rz, w1.s1_78, s9_70));
  const double s9_72 = fms(tau_carrier_right_rx, w1.R_carrier_right_aux1_y_x, s7_735);
  const double s9_73 = fma(tau_carrier_right_ry, w1.s1_86, s9_72);
  const double s9_74 = s9_33*fma(s9_20, s9_68, fnma(tau_carrier_right_rz, w1.s1_95, s9_73));
  const double s9_75 = fms(tau_carrier_left_rx, w1.R_carrier_left_aux1_z_x, s7_893);
  const double s9_76 = fma(tau_carrier_left_rz, w1.s1_70, s9_75);
  const double s9_77 = fma(s9_12, s9_67, fnma(tau_carrier_left_ry, w1.s1_77, s9_76));
  const double s9_78 = s9_46*fma(s9_4, s9_71, s9_77);
  const double s9_79 = fms(tau_carrier_right_rx, w1.R_carrier_right_aux1_z_x, s7_738);
  const double s9_80 = fma(tau_carrier_right_rz, w1.s1_87, s9_79);
  const double s9_81 = fnma(s9_19, s9_68, fnma(tau_carrier_right_ry, w1.s1_94, s9_80));
  const double s9_82 = s9_35*fma(s9_5, s9_74, s9_81);
  const double s9_83 = fms(tau_carrier_right_rx, R_carrier_right_aux1_x_x, s7_741);
  const double s9_84 = fma(tau_carrier_right_ry, w1.s1_90, s9_83);
  const double s9_85 = fma(s9_18, s9_68, fma(tau_carrier_right_rz, w1.s1_93, s9_84));
  const double s9_86 = s9_39*fma(s9_32, s9_82, s9_85);
  const double s9_87 = fms(tau_carrier_left_rx, R_carrier_left_aux1_x_x, s7_895);
  const double s9_88 = fma(tau_carrier_left_ry, w1.s1_73, s9_87);
  const double s9_89 = fma(s9_14, s9_67, fma(tau_carrier_left_rz, w1.s1_76, s9_88));
  const double s9_90 = s9_50*fma(s9_27, s9_78, s9_89);
  const double s9_91 = 1.0/s9_54*fnma(s9_2, s9_90, Q_upper_arm_left);
  result.lambda[2] = -s9_91;
  const double s9_92 = 1.0/pivot_upper_arm_right*fma(s9_7, s9_86, w3.Q_upper_arm_right);
  result.lambda[5] = s9_92;
  const double s9_93 = fma(s9_51, s9_91, s9_90);
  result.lambda[1] = s9_93;
  const double s9_94 = fnma(s9_40, s9_92, s9_86);
  result.lambda[4] = s9_94;
  const double s9_95 = fma(s9_47, s9_93, fms(s9_49, s9_91, s9_78));
  result.lambda[9] = l_tie_rod_left*s9_95;
  const double s9_96 = fnma(s9_36, s9_94, fma(s9_38, s9_92, s9_82));
  result.lambda[10] = l_tie_rod_right*s9_96;
  result.lambda[0] = fma(s9_44, s9_95, fnma(s9_48, s9_91, s9_71));
  result.lambda[3] = fma(s9_34, s9_96, fma(s9_37, s9_92, s9_74));
  // long_rod_left
  const double s9_97 = w1.r_rear_axle_aux3_z - p_long_rod_left_from_z;
  const double s9_98 = w3.s7_337 + s9_97;
  const double s9_99 = w1.r_rear_axle_aux1_x - p_long_rod_left_from_x;
  const double s9_100 = w3.s7_340 + s9_99;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_101 = p_long_rod_left_from_y - z_rear_axle_ty - w3.s7_343;
  // diag_rod_left
  const double s9_102 = w1.r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  const double s9_103 = w3.s7_351 + s9_102;
  const double s9_104 = w1.r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  const double s9_105 = w3.s7_353 + s9_104;
  const double s9_106 = p_diag_rod_left_from_y - z_rear_axle_ty - w3.s7_355;
  // arb_link_rear_left
  const double s9_107 = w1.r_rear_axle_aux3_z - p_arb_rear_left_z;
  const double s9_108 = s9_107 + (w3.s7_362 + w3.s7_370);
  const double s9_109 = 0.6 - z_rear_axle_ty - w3.s7_372;
  const double s9_110 = w3.s7_369 + p_arb_rear_left_x - w1.r_rear_axle_aux1_x - w3.s7_371;
  // long_rod_right
  const double s9_111 = w3.s7_386 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s9_112 = w3.s7_384 + s9_97;
  const double s9_113 = w3.s7_385 + s9_99;
  const double pivot_rear_axle_tx = w3.s7_391 + s9_104;
  // diag_rod_right
  const double s9_114 = w3.s7_390 + s9_102;
  const double s9_115 = w3.s7_392 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  const double s9_116 = fnma(w3.s7_392, s9_114, w3.s7_390*s9_115);
  const double s9_117 = fnma(w3.s7_390, pivot_rear_axle_tx, w3.s7_391*s9_114);
  const double s9_118 = fnma(w3.s7_391, s9_115, w3.s7_392*pivot_rear_axle_tx);
  // arb_link_rear_right
  const double s9_119 = 0.6 + z_rear_axle_ty - w3.s7_397;
  const double s9_120 = s9_107 + (w3.s7_400 - w3.s7_399);
  const double s9_121 = w3.s7_401 + (w3.s7_398 + p_arb_rear_right_x - w1.r_rear_axle_aux1_x);
  const double s9_122 = 1.0/pivot_rear_axle_tx;
  const double s9_123 = s9_105*s9_122;
  const double s9_124 = fma(s9_115, s9_123, s9_106);
  const double s9_125 = s9_100*s9_122;
  const double s9_126 = fnma(w3.s7_353, s9_106, fnma(w3.s7_355, s9_105, s9_118*s9_123));
  const double s9_127 = 1.0/s9_124;
  const double s9_128 = fma(s9_115, s9_125, s9_101)*s9_127;
  const double s9_129 = fnma(w3.s7_340, s9_101, fnma(w3.s7_343, s9_100, s9_118*s9_125));
  const double pivot_rear_axle_rx = fnma(s9_126, s9_128, s9_129);
  const double s9_130 = s9_113*s9_122;
  const double s9_131 = fma(s9_117, s9_123, fnma(w3.s7_353, s9_103, w3.s7_351*s9_105));
  const double s9_132 = s9_127*fnma(s9_115, s9_130, s9_111);
  const double s9_133 = fma(s9_117, s9_125, fnma(w3.s7_340, s9_98, w3.s7_337*s9_100));
  const double s9_134 = fnma(s9_128, s9_131, s9_133);
  const double s9_135 = fma(s9_118, s9_130, fnma(w3.s7_386, s9_113, w3.s7_385*s9_111));
  const double s9_136 = 1.0/pivot_rear_axle_rx;
  const double s9_137 = fma(s9_126, s9_132, s9_135)*s9_136;
  const double s9_138 = fma(s9_117, s9_130, fnma(w3.s7_385, s9_112, w3.s7_384*s9_113));
  const double pivot_rear_axle_ry = fnma(s9_134, s9_137, fma(s9_131, s9_132, s9_138));
  const double s9_139 = fma(s9_116, s9_123, fma(w3.s7_351, s9_106, w3.s7_355*s9_103));
  const double s9_140 = s9_121*s9_122;
  const double s9_141 = s9_127*fma(s9_115, s9_140, s9_119);
  const double s9_142 = fma(s9_116, s9_125, fma(w3.s7_337, s9_101, w3.s7_343*s9_98));
  const double s9_143 = fnma(s9_128, s9_139, s9_142);
  const double s9_144 = fnma(w3.s7_397, s9_121, fnma(w3.s7_398, s9_119, s9_126*s9_141));
  const double s9_145 = s9_136*fnma(s9_118, s9_140, s9_144);
  const double s9_146 = fma(s9_116, s9_130, fnma(w3.s7_384, s9_111, w3.s7_386*s9_112));
  const double s9_147 = fnma(s9_137, s9_143, fma(s9_132, s9_139, s9_146));
  const double s9_148 = fnma(s9_117, s9_140, fma(w3.s7_399, s9_121, w3.s7_398*s9_120));
  const double s9_149 = 1.0/pivot_rear_axle_ry;
  const double s9_150 = fnma(s9_134, s9_145, fma(s9_131, s9_141, s9_148))*s9_149;
  const double s9_151 = fnma(s9_116, s9_140, fnma(w3.s7_397, s9_120, w3.s7_399*s9_119));
  const double pivot_rear_axle_rz = fnma(s9_147, s9_150, fnma(s9_143, s9_145, fma(s9_139, s9_141,
      s9_151)));
  const double s9_152 = s9_110*s9_122;
  const double s9_153 = fnma(s9_114, s9_123, s9_103);
  const double s9_154 = s9_127*fms(s9_115, s9_152, s9_109);
  const double s9_155 = fnma(s9_128, s9_153, fnma(s9_114, s9_125, s9_98));
  const double s9_156 = fnma(s9_118, s9_152, fnma(w3.s7_371, s9_109, w3.s7_372*s9_110));
  const double s9_157 = s9_136*fma(s9_126, s9_154, s9_156);
  const double s9_158 = fnma(s9_137, s9_155, fma(s9_132, s9_153, fnma(s9_114, s9_130, s9_112)));
  const double s9_159 = fnma(w3.s7_370, s9_110, fnma(w3.s7_371, s9_108, s9_131*s9_154));
  const double s9_160 = s9_149*fnma(s9_134, s9_157, fnma(s9_117, s9_152, s9_159));
  const double s9_161 = fnma(s9_145, s9_155, fma(s9_141, s9_153, fma(s9_114, s9_140, s9_120)));
  const double s9_162 = fnma(s9_150, s9_158, s9_161);
  const double s9_163 = fnma(s9_116, s9_152, fma(w3.s7_370, s9_109, w3.s7_372*s9_108));
  const double s9_164 = 1.0/pivot_rear_axle_rz;
  const double s9_165 = fnma(s9_147, s9_160, fnma(s9_143, s9_157, fma(s9_139, s9_154, s9_163)));
  const double s9_166 = s9_165*s9_164;
  const double s9_167 = fnma(s9_155, s9_157, fma(s9_153, s9_154, fma(s9_114, s9_152, s9_108)));
  const double pivot_rear_axle_tz = fnma(s9_162, s9_166, fnma(s9_158, s9_160, s9_167));
  const double s9_168 = 1.2494533266510743*std::abs(pivot_rear_axle_tx);
  const double s9_169 = mbgen::min(s9_168, 1.665350081353039*std::abs(s9_124));
  const double s9_170 = mbgen::min(s9_169, 2.1234888829989926*std::abs(pivot_rear_axle_rx));
  const double s9_171 = mbgen::min(s9_170, 1.7864443153153613*std::abs(pivot_rear_axle_ry));
  const double s9_172 = mbgen::min(s9_171, 8.176955428452642*std::abs(pivot_rear_axle_rz));
  const double s9_173 = mbgen::min(s9_172, 2.7700489841913827*std::abs(pivot_rear_axle_tz));
  result.pivot[1] = mbgen::min(s9_173, std::abs(w1.s1_100));
  const double s9_174 = w3.Q_rear_axle_tx*s9_122;
  const double s9_175 = s9_127*fnma(s9_115, s9_174, w3.Q_rear_axle_ty);
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s9_176 = fnma(tau_rear_axle_ry, w1.s1_54, tau_rear_axle_rx*w1.s1_102) - w3.s7_570;
  const double s9_177 = fma(s9_118, s9_174, fnma(tau_rear_axle_rz, w1.s1_109, s9_176));
  const double s9_178 = s9_136*fma(s9_126, s9_175, s9_177);
  const double s9_179 = fms(tau_rear_axle_ry, w4.cosines[17], w3.s7_567);
  const double s9_180 = fma(tau_rear_axle_rx, w1.s1_105, s9_179);
  const double s9_181 = fma(s9_117, s9_174, fma(tau_rear_axle_rz, w1.s1_107, s9_180));
  const double s9_182 = s9_149*fnma(s9_134, s9_178, fma(s9_131, s9_175, s9_181));
  const double s9_183 = fnma(tau_rear_axle_ry, w1.s1_52, tau_rear_axle_rz*w1.s1_103) - w3.s7_572;
  const double s9_184 = fma(s9_116, s9_174, fnma(tau_rear_axle_rx, w1.s1_108, s9_183));
  const double s9_185 = fnma(s9_147, s9_182, fnma(s9_143, s9_178, fma(s9_139, s9_175, s9_184)));
  const double s9_186 = s9_164*s9_185;
  const double s9_187 = fma(s9_153, s9_175, fnma(s9_114, s9_174, w3.Q_rear_axle_tz));
  const double s9_188 = fnma(s9_162, s9_186, fnma(s9_158, s9_182, fnma(s9_155, s9_178, s9_187)));
  const double s9_189 = 1.0/pivot_rear_axle_tz*s9_188;
  result.lambda[13] = l_arb_link_rear_left*s9_189;
  const double s9_190 = fnma(s9_166, s9_189, s9_186);
  result.lambda[16] = l_arb_link_rear_right*s9_190;
  const double s9_191 = fnma(s9_150, s9_190, fnma(s9_160, s9_189, s9_182));
  result.lambda[14] = l_long_rod_right*s9_191;
  const double s9_192 = fnma(s9_137, s9_191, fnma(s9_145, s9_190, fnma(s9_157, s9_189, s9_178)));
  result.lambda[11] = l_long_rod_left*s9_192;
  const double s9_193 = fma(s9_132, s9_191, fma(s9_141, s9_190, fms(s9_154, s9_189, s9_175)));
  const double s9_194 = fnma(s9_128, s9_192, s9_193);
  result.lambda[12] = l_diag_rod_left*s9_194;
  const double s9_195 = fnma(s9_130, s9_191, fma(s9_140, s9_190, fma(s9_152, s9_189, s9_174)));
  result.lambda[15] = l_diag_rod_right*fnma(s9_123, s9_194, fnma(s9_125, s9_192, s9_195));
  // operations: 249 add, 294 multiply, 17 divide, 38 other
}

/// Multipliers of the closures and generalised driving forces, at given accelerations.
void compute_multipliers(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    const double* tau, const Derivative& derivative, ConstraintForces& __restrict result) noexcept {
  ConstraintForcesWork1 w1;
  ConstraintForcesWork2 w2;
  ConstraintForcesWork3 w3;
  ConstraintForcesWork4 w4;
  compute_multipliers_1(state, derivative, w1, w2, w4);
  compute_multipliers_2(state, tau, derivative, w1, w2, w3, w4, result);
  compute_multipliers_3(state, tau, w1, w2, w3, w4, result);
}
#endif  // part 1

/// Result of compute_closure_terms.
struct ClosureTerms {
  double Phi[17];  ///< residuals
  double Jz[202];  ///< Jacobian of each block, row by row
  double c[17];  ///< right-hand side of the accelerations
  double driven_acceleration[32];  ///< of driven coordinates, by their motions; no others
};

void compute_closure_terms(const Tuned& parameters, const Inputs& inputs, const State& state,
    ClosureTerms& __restrict result) noexcept;

#if MBGEN_IS_PART(1)
/// Values of compute_closure_terms that cross its parts.
struct ClosureTermsWork1 {
  double
      s4_25, s4_31, s4_35, R_rear_axle_aux4_z_z, s1_27, R_rear_axle_aux4_x_z, s1_29,
      R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, R_rear_axle_aux5_z_x, R_rear_axle_x_y,
      R_rear_axle_z_y, R_rear_axle_y_y, r_rear_axle_aux1_x, R_rear_axle_y_z, r_rear_axle_aux3_z,
      R_rear_axle_x_z, R_rear_axle_z_z, s4_23, s4_24, s4_28, s4_29, s4_30, s4_32, s4_33, s4_34,
      s4_26, s4_27;
};

/// Values of compute_closure_terms that cross its parts.
struct ClosureTermsWork2 {
  double
      sines[19], cosines[19];
};

/// Part 1 of compute_closure_terms: step 1: poses and axes b; step 4: velocities; step 2: closure
/// Jacobian Phi_z and its factors (60).
[[gnu::noinline]] void compute_closure_terms_1(const State& state, ClosureTermsWork1& __restrict w1,
    ClosureTermsWork2& __restrict w2, ClosureTerms& __restrict result) noexcept {
  // Results that need no operation.
  for (int k = 0; k < 154; ++k) result.Jz[k] = 0.0;
  for (int k = 154; k < 202; ++k) result.Jz[k] = 0.0;

  // --- step 1: poses and axes b ---
  const double angles[] = {
      state.z[Coordinate::lower_arm_left], state.z[Coordinate::carrier_left_rz],
      state.z[Coordinate::carrier_left_rx], state.z[Coordinate::carrier_left_ry],
      state.z[Coordinate::upper_arm_left], state.z[Coordinate::arb_front_left],
      state.z[Coordinate::lower_arm_right], state.z[Coordinate::carrier_right_rz],
      state.z[Coordinate::carrier_right_rx], state.z[Coordinate::carrier_right_ry],
      state.z[Coordinate::upper_arm_right], state.z[Coordinate::arb_front_right],
      state.z[Coordinate::pitman_arm], state.z[Coordinate::bell_crank],
      state.z[Coordinate::rear_axle_rz], state.z[Coordinate::rear_axle_ry],
      state.z[Coordinate::rear_axle_rx], state.z[Coordinate::arb_rear_left],
      state.z[Coordinate::arb_rear_right]};
  mbgen::sincos(angles, w2.sines, w2.cosines);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = w2.sines[0];
  const double R_lower_arm_left_y_z = -R_lower_arm_left_z_y;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_1 = state.charts[1] - 0.5;
  const double R_lower_arm_left_y_y = w2.cosines[0];
  const double R_carrier_left_aux1_z_z = (s1_1 >= 0.0 ? R_lower_arm_left_y_z :
      R_lower_arm_left_y_y);
  const double s1_2 = w2.sines[1];
  const double R_carrier_left_aux1_y_x = s1_2*R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_x_x = w2.cosines[1];
  const double R_carrier_left_aux1_y_y = R_carrier_left_aux1_x_x*R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_y_z = (s1_1 >= 0.0 ? -R_lower_arm_left_y_y :
      R_lower_arm_left_y_z);
  const double s1_3 = (s1_1 >= 0.0 ? R_lower_arm_left_y_y : R_lower_arm_left_z_y);
  const double R_carrier_left_aux1_z_x = s1_2*s1_3;
  const double R_carrier_left_aux1_z_y = R_carrier_left_aux1_x_x*s1_3;
  const double s1_4 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  const double s1_5 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_4);
  const double r_carrier_left_aux1_y = p_lower_arm_left_y + s1_5;
  const double s1_6 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_7 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_6);
  const double r_carrier_left_aux1_z = s1_7 + p_lower_arm_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_8 = w2.cosines[2];
  const double s1_9 = s1_2*s1_8;
  const double s1_10 = w2.sines[2];
  const double R_carrier_left_aux2_x_z = s1_2*s1_10;
  const double R_carrier_left_aux2_y_y = fma(R_carrier_left_aux1_y_z, s1_10,
      R_carrier_left_aux1_y_y*s1_8);
  const double R_carrier_left_aux2_y_z = fnma(R_carrier_left_aux1_y_y, s1_10,
      R_carrier_left_aux1_y_z*s1_8);
  const double R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_z, s1_10,
      R_carrier_left_aux1_z_y*s1_8);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_10,
      R_carrier_left_aux1_z_z*s1_8);
  const double s1_11 = w2.cosines[3];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_12 = w2.sines[3];
  const double R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_12,
      R_carrier_left_aux1_x_x*s1_11);
  const double R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_12,
      R_carrier_left_aux2_x_z*s1_11);
  const double R_carrier_left_y_x = fnma(R_carrier_left_aux2_y_z, s1_12,
      R_carrier_left_aux1_y_x*s1_11);
  const double R_carrier_left_y_z = fma(R_carrier_left_aux1_y_x, s1_12,
      R_carrier_left_aux2_y_z*s1_11);
  const double R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_12,
      R_carrier_left_aux1_z_x*s1_11);
  const double R_carrier_left_z_z = fma(R_carrier_left_aux1_z_x, s1_12,
      R_carrier_left_aux2_z_z*s1_11);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = w2.sines[6];
  const double R_lower_arm_right_y_z = -R_lower_arm_right_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_13 = state.charts[2] - 0.5;
  const double R_lower_arm_right_y_y = w2.cosines[6];
  const double R_carrier_right_aux1_z_z = (s1_13 >= 0.0 ? R_lower_arm_right_y_z :
      R_lower_arm_right_y_y);
  const double s1_14 = w2.sines[7];
  const double R_carrier_right_aux1_y_x = s1_14*R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_x_x = w2.cosines[7];
  const double R_carrier_right_aux1_y_y = R_carrier_right_aux1_x_x*R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_y_z = (s1_13 >= 0.0 ? -R_lower_arm_right_y_y :
      R_lower_arm_right_y_z);
  const double s1_15 = (s1_13 >= 0.0 ? R_lower_arm_right_y_y : R_lower_arm_right_z_y);
  const double R_carrier_right_aux1_z_x = s1_14*s1_15;
  const double R_carrier_right_aux1_z_y = R_carrier_right_aux1_x_x*s1_15;
  const double s1_16 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  const double s1_17 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_16);
  const double r_carrier_right_aux1_y = s1_17 + p_lower_arm_right_y;
  const double s1_18 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  const double s1_19 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_18);
  const double s1_20 = s1_19 - p_lower_arm_right_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_21 = w2.cosines[8];
  const double s1_22 = s1_14*s1_21;
  const double s1_23 = w2.sines[8];
  const double R_carrier_right_aux2_x_z = s1_14*s1_23;
  const double R_carrier_right_aux2_y_y = fma(R_carrier_right_aux1_y_z, s1_23,
      R_carrier_right_aux1_y_y*s1_21);
  const double R_carrier_right_aux2_y_z = fnma(R_carrier_right_aux1_y_y, s1_23,
      R_carrier_right_aux1_y_z*s1_21);
  const double R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_z, s1_23,
      R_carrier_right_aux1_z_y*s1_21);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_23,
      R_carrier_right_aux1_z_z*s1_21);
  const double s1_24 = w2.cosines[9];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_25 = w2.sines[9];
  const double R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_25,
      R_carrier_right_aux1_x_x*s1_24);
  const double R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_25,
      R_carrier_right_aux2_x_z*s1_24);
  const double R_carrier_right_y_x = fnma(R_carrier_right_aux2_y_z, s1_25,
      R_carrier_right_aux1_y_x*s1_24);
  const double R_carrier_right_y_z = fma(R_carrier_right_aux1_y_x, s1_25,
      R_carrier_right_aux2_y_z*s1_24);
  const double R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_25,
      R_carrier_right_aux1_z_x*s1_24);
  const double R_carrier_right_z_z = fma(R_carrier_right_aux1_z_x, s1_25,
      R_carrier_right_aux2_z_z*s1_24);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  w1.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  w1.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] + p_rear_axle_tx_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s1_26 = state.charts[3] - 0.5;
  w1.R_rear_axle_aux4_z_z = (s1_26 >= 0.0 ? 0.0 : 1.0);
  const double R_rear_axle_aux4_y_y = w2.cosines[14];
  const double R_rear_axle_aux4_x_x = R_rear_axle_aux4_y_y*w1.R_rear_axle_aux4_z_z;
  const double R_rear_axle_aux4_y_x = w2.sines[14];
  w1.s1_27 = w1.R_rear_axle_aux4_z_z*R_rear_axle_aux4_y_x;
  w1.R_rear_axle_aux4_x_z = (s1_26 >= 0.0 ? 1.0 : 0.0);
  const double s1_28 = (s1_26 >= 0.0 ? -1.0 : 0.0);
  const double R_rear_axle_aux4_z_x = R_rear_axle_aux4_y_y*s1_28;
  w1.s1_29 = R_rear_axle_aux4_y_x*s1_28;
  const double s1_30 = w2.cosines[15];
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s1_31 = w2.sines[15];
  w1.R_rear_axle_aux5_x_x = fnma(w1.R_rear_axle_aux4_x_z, s1_31, R_rear_axle_aux4_x_x*s1_30);
  const double R_rear_axle_aux5_x_z = fma(R_rear_axle_aux4_x_x, s1_31,
      w1.R_rear_axle_aux4_x_z*s1_30);
  w1.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*s1_30;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_31;
  w1.R_rear_axle_aux5_z_x = fnma(w1.R_rear_axle_aux4_z_z, s1_31, R_rear_axle_aux4_z_x*s1_30);
  const double R_rear_axle_aux5_z_z = fma(R_rear_axle_aux4_z_x, s1_31,
      w1.R_rear_axle_aux4_z_z*s1_30);
  const double s1_32 = w2.sines[16];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_33 = w2.cosines[16];
  w1.R_rear_axle_x_y = fnma(w1.s1_27, s1_33, R_rear_axle_aux5_x_z*s1_32);
  w1.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_33, w1.s1_27*s1_32);
  w1.R_rear_axle_y_y = fma(R_rear_axle_aux4_y_y, s1_33, R_rear_axle_aux5_y_z*s1_32);
  w1.R_rear_axle_y_z = fnma(R_rear_axle_aux4_y_y, s1_32, R_rear_axle_aux5_y_z*s1_33);
  w1.R_rear_axle_z_y = fnma(w1.s1_29, s1_33, R_rear_axle_aux5_z_z*s1_32);
  w1.R_rear_axle_z_z = fma(R_rear_axle_aux5_z_z, s1_33, w1.s1_29*s1_32);
  // operations: 43 add, 86 multiply, 38 sin cos, 9 other

  // --- step 4: velocities ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double s4_1 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  const double s4_2 = zd_carrier_left_ry*R_carrier_left_aux2_z_y;
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double s4_3 = zd_carrier_left_rz*R_carrier_left_aux1_z_z;
  const double s4_4 = zd_carrier_left_rx*R_carrier_left_aux1_z_x;
  const double s4_5 = s4_3 + s4_4;
  const double s4_6 = s4_2 + s4_5;
  const double s4_7 = zd_carrier_left_ry*R_carrier_left_aux2_y_y;
  const double s4_8 = zd_carrier_left_rz*R_carrier_left_aux1_y_z;
  const double s4_9 = zd_carrier_left_rx*R_carrier_left_aux1_y_x;
  const double s4_10 = s4_8 + s4_9;
  const double s4_11 = s4_7 + s4_10;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double s4_12 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  const double s4_13 = zd_carrier_right_ry*R_carrier_right_aux2_z_y;
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double s4_14 = zd_carrier_right_rz*R_carrier_right_aux1_z_z;
  const double s4_15 = zd_carrier_right_rx*R_carrier_right_aux1_z_x;
  const double s4_16 = s4_14 + s4_15;
  const double s4_17 = s4_13 + s4_16;
  const double s4_18 = zd_carrier_right_ry*R_carrier_right_aux2_y_y;
  const double s4_19 = zd_carrier_right_rz*R_carrier_right_aux1_y_z;
  const double s4_20 = zd_carrier_right_rx*R_carrier_right_aux1_y_x;
  const double s4_21 = s4_19 + s4_20;
  const double s4_22 = s4_18 + s4_21;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  w1.s4_23 = zd_rear_axle_ry*R_rear_axle_aux4_y_y;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  w1.s4_24 = zd_rear_axle_rx*w1.R_rear_axle_aux5_y_x;
  w1.s4_25 = w1.s4_23 + w1.s4_24;
  w1.s4_26 = zd_rear_axle_ry*w1.s1_29;
  w1.s4_27 = zd_rear_axle_ry*w1.s1_27;
  w1.s4_28 = zd_rear_axle_rx*w1.R_rear_axle_aux5_z_x;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  w1.s4_29 = zd_rear_axle_rz*w1.R_rear_axle_aux4_z_z;
  w1.s4_30 = w1.s4_29 - w1.s4_26;
  w1.s4_31 = w1.s4_28 + w1.s4_30;
  w1.s4_32 = zd_rear_axle_rx*w1.R_rear_axle_aux5_x_x;
  w1.s4_33 = zd_rear_axle_rz*w1.R_rear_axle_aux4_x_z;
  w1.s4_34 = w1.s4_33 - w1.s4_27;
  w1.s4_35 = w1.s4_32 + w1.s4_34;
  // operations: 13 add, 22 multiply

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s2_1 = zd_lower_arm_left + s4_1;
  const double s2_2 = fnma(zd_carrier_left_ry, s1_9, s2_1);
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s2_3 = zd_lower_arm_right + s4_12;
  const double s2_4 = fnma(zd_carrier_right_ry, s1_22, s2_3);
  const double s2_5 = fma(s4_2, s4_10, fnma(s4_3, s4_9, fnma(s4_5, s4_7, s4_4*s4_8)));
  const double s2_6 = fma(s4_13, s4_21, fnma(s4_14, s4_20, fnma(s4_16, s4_18, s4_15*s4_19)));
  const double s2_7 = fma(zd_carrier_left_ry, s1_9, zd_lower_arm_left);
  const double s2_8 = fma(s4_10, s2_7, fnma(s4_1, s4_8, s4_7*s2_1));
  const double s2_9 = fma(zd_carrier_right_ry, s1_22, zd_lower_arm_right);
  const double s2_10 = fma(s4_21, s2_9, fnma(s4_12, s4_19, s4_18*s2_3));
  const double s2_11 = fnma(s4_5, s2_7, fnma(s4_2, s2_1, s4_1*s4_3));
  const double s2_12 = fnma(s4_16, s2_9, fnma(s4_13, s2_3, s4_12*s4_14));
  const double s2_13 = zd_lower_arm_left*zd_lower_arm_left;
  const double s2_14 = s1_5*s2_13;
  const double s2_15 = s1_7*s2_13;
  const double s2_16 = zd_lower_arm_right*zd_lower_arm_right;
  const double s2_17 = s1_19*s2_16;
  const double s2_18 = s1_17*s2_16;
  // upper_ball_left
  const double s2_19 = -p_carrier_left_upper_ball_y*R_carrier_left_aux2_z_y;
  const double s2_20 = -p_carrier_left_upper_ball_y*R_carrier_left_aux2_y_y;
  const double R_upper_arm_left_z_y = w2.sines[4];
  const double R_upper_arm_left_y_y = w2.cosines[4];
  const double s2_21 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_22 = fma(p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s2_21);
  result.Jz[18] = s2_22;
  const double s2_23 = -p_carrier_left_upper_ball_y*s1_9;
  const double s2_24 = fma(p_carrier_left_upper_ball_z, R_carrier_left_x_z, s2_23);
  result.Phi[0] = s2_24;
  result.Jz[15] = R_carrier_left_aux1_z_z*s2_24;
  const double s2_25 = p_upper_arm_left_ball_y*R_upper_arm_left_y_y;
  const double s2_26 = fnma(p_upper_arm_left_ball_z, R_upper_arm_left_z_y, s2_25);
  result.Jz[32] = -s2_26;
  const double s2_27 = fms(p_carrier_left_upper_ball_z, R_carrier_left_z_z, s2_19);
  const double s2_28 = fms(p_carrier_left_upper_ball_z, R_carrier_left_y_z, s2_20);
  result.Jz[17] = fma(s1_9, s2_27, R_carrier_left_aux2_z_y*s2_24);
  result.Phi[1] = s2_28 + (r_carrier_left_aux1_y - p_upper_arm_left_y - s2_26);
  result.Phi[2] = s2_27 + (r_carrier_left_aux1_z - p_upper_arm_left_z - s2_22);
  result.Jz[30] = fnma(R_carrier_left_aux1_y_x, s2_24, R_carrier_left_aux1_x_x*s2_28);
  result.Jz[1] = fnma(R_carrier_left_aux1_z_z, s2_28, R_carrier_left_aux1_y_z*s2_27);
  result.Jz[16] = fnma(R_carrier_left_aux1_x_x, s2_27, R_carrier_left_aux1_z_x*s2_24);
  result.Jz[2] = fnma(R_carrier_left_aux1_z_x, s2_28, R_carrier_left_aux1_y_x*s2_27);
  result.Jz[3] = fnma(R_carrier_left_aux2_z_y, s2_28, R_carrier_left_aux2_y_y*s2_27);
  result.Jz[28] = s1_5 + s2_28;
  result.Jz[14] = -(s1_7 + s2_27);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  result.Jz[29] = -(R_carrier_left_aux1_y_z*s2_24);
  result.Jz[31] = -fma(s1_9, s2_28, R_carrier_left_aux2_y_y*s2_24);
  const double s2_29 = fnma(s4_11, s2_24, s2_2*s2_28);
  const double s2_30 = fnma(s2_2, s2_27, s4_6*s2_24);
  result.c[0] = fma(s4_6, s2_30, fnma(s4_11, s2_29, fnma(s2_11, s2_27, s2_8*s2_28)));
  const double s2_31 = fnma(s4_6, s2_28, s4_11*s2_27);
  const double s2_32 = fma(s2_5, s2_27, fnma(s2_8, s2_24, s2_14));
  const double s2_33 = fnma(zd_upper_arm_left, zd_upper_arm_left*s2_26, s2_32);
  result.c[1] = fnma(s4_6, s2_31, fma(s2_2, s2_29, s2_33));
  const double s2_34 = fnma(s2_5, s2_28, fma(s2_11, s2_24, s2_15));
  const double s2_35 = fnma(zd_upper_arm_left, zd_upper_arm_left*s2_22, s2_34);
  result.c[2] = fma(s4_11, s2_31, fnma(s2_2, s2_30, s2_35));
  // upper_ball_right
  const double s2_36 = p_carrier_right_upper_ball_y*s1_22;
  const double R_upper_arm_right_z_y = w2.sines[10];
  const double R_upper_arm_right_y_y = w2.cosines[10];
  const double s2_37 = -p_upper_arm_right_ball_z*R_upper_arm_right_z_y;
  const double s2_38 = fma(p_upper_arm_right_ball_y, R_upper_arm_right_y_y, s2_37);
  const double s2_39 = fms(p_carrier_right_upper_ball_z, R_carrier_right_x_z, s2_36);
  result.Phi[3] = s2_39;
  result.Jz[63] = R_carrier_right_aux1_z_z*s2_39;
  const double s2_40 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_z_y;
  const double s2_41 = fma(p_carrier_right_upper_ball_z, R_carrier_right_z_z, s2_40);
  const double s2_42 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_y_y;
  const double s2_43 = fma(p_carrier_right_upper_ball_z, R_carrier_right_y_z, s2_42);
  const double s2_44 = -p_upper_arm_right_ball_z*R_upper_arm_right_y_y;
  const double s2_45 = fnma(p_upper_arm_right_ball_y, R_upper_arm_right_z_y, s2_44);
  result.Jz[66] = -s2_45;
  result.Jz[80] = -s2_38;
  result.Jz[62] = s1_19 - s2_41;
  result.Phi[5] = s2_45 + (s2_41 + (-p_upper_arm_right_z - s1_20));
  result.Jz[65] = fma(s1_22, s2_41, R_carrier_right_aux2_z_y*s2_39);
  result.Jz[76] = s1_17 + s2_43;
  result.Phi[4] = s2_43 + (r_carrier_right_aux1_y - p_upper_arm_right_y - s2_38);
  result.Jz[78] = fnma(R_carrier_right_aux1_y_x, s2_39, R_carrier_right_aux1_x_x*s2_43);
  result.Jz[49] = fnma(R_carrier_right_aux1_z_z, s2_43, R_carrier_right_aux1_y_z*s2_41);
  result.Jz[64] = fnma(R_carrier_right_aux1_x_x, s2_41, R_carrier_right_aux1_z_x*s2_39);
  result.Jz[50] = fnma(R_carrier_right_aux1_z_x, s2_43, R_carrier_right_aux1_y_x*s2_41);
  result.Jz[51] = fnma(R_carrier_right_aux2_z_y, s2_43, R_carrier_right_aux2_y_y*s2_41);
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  result.Jz[77] = -(R_carrier_right_aux1_y_z*s2_39);
  result.Jz[79] = -fma(s1_22, s2_43, R_carrier_right_aux2_y_y*s2_39);
  const double s2_46 = fnma(s4_22, s2_39, s2_4*s2_43);
  const double s2_47 = fnma(s2_4, s2_41, s4_17*s2_39);
  result.c[3] = fma(s4_17, s2_47, fnma(s4_22, s2_46, fnma(s2_12, s2_41, s2_10*s2_43)));
  const double s2_48 = fnma(s4_17, s2_43, s4_22*s2_41);
  const double s2_49 = fma(s2_6, s2_41, fnma(s2_10, s2_39, s2_18));
  const double s2_50 = fnma(zd_upper_arm_right, zd_upper_arm_right*s2_38, s2_49);
  result.c[4] = fnma(s4_17, s2_48, fma(s2_4, s2_46, s2_50));
  const double s2_51 = fnma(s2_6, s2_43, fms(s2_12, s2_39, s2_17));
  const double s2_52 = fma(zd_upper_arm_right, zd_upper_arm_right*s2_45, s2_51);
  result.c[5] = fma(s4_22, s2_48, fnma(s2_4, s2_47, s2_52));
  const double R_arb_front_left_x_z = w2.sines[5];
  // arb_link_front_left
  const double R_arb_front_left_x_x = w2.cosines[5];
  const double s2_53 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s2_54 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s2_53);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s2_55 = zd_arb_front_left*s2_54;
  const double s2_56 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  const double s2_57 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s2_56);
  const double s2_58 = zd_arb_front_left*s2_57;
  const double s2_59 = p_arb_link_front_left_to_x*R_carrier_left_x_x;
  const double s2_60 = fnma(p_arb_link_front_left_to_y, s1_9 + R_carrier_left_x_z, s2_59);
  const double s2_61 = p_arb_link_front_left_to_x*R_carrier_left_z_x;
  const double s2_62 = R_carrier_left_z_z - R_carrier_left_aux2_z_y;
  const double s2_63 = fnma(p_arb_link_front_left_to_y, s2_62, s2_61);
  const double s2_64 = fnma(s2_2, s2_63, s4_6*s2_60);
  const double s2_65 = fnma(zd_lower_arm_left, s1_7, s2_64);
  const double s2_66 = p_arb_link_front_left_to_x*R_carrier_left_y_x;
  const double s2_67 = R_carrier_left_y_z - R_carrier_left_aux2_y_y;
  const double s2_68 = fnma(p_arb_link_front_left_to_y, s2_67, s2_66);
  const double s2_69 = fnma(s4_11, s2_60, s2_2*s2_68);
  const double s2_70 = s2_69 + fma(zd_lower_arm_left, s1_5, s2_55);
  const double s2_71 = 0.72 - r_carrier_left_aux1_y - s2_68;
  const double s2_72 = 3.846153846153846*s2_71;
  const double s2_73 = 0.35 + s2_54 - s2_60;
  const double s2_74 = 3.846153846153846*s2_73;
  const double s2_75 = s2_57 + p_arb_front_left_z - r_carrier_left_aux1_z - s2_63;
  const double s2_76 = 3.846153846153846*s2_75;
  result.Jz[89] = fnma(s2_54, s2_76, s2_57*s2_74);
  const double s2_77 = fnma(s4_6, s2_68, s4_11*s2_63);
  const double s2_78 = fnma(s2_2, s2_69, fnma(s2_5, s2_63, fms(s2_8, s2_60, s2_14)));
  const double s2_79 = fnma(s2_63, s2_72, s2_68*s2_76);
  const double s2_80 = fnma(s2_68, s2_74, s2_60*s2_72);
  const double s2_81 = fnma(s2_60, s2_76, s2_63*s2_74);
  const double s2_82 = fnma(s2_11, s2_60, fms(zd_arb_front_left, s2_58, s2_15));
  const double s2_83 = fnma(s4_6, s2_64, fma(s2_11, s2_63, zd_arb_front_left*s2_55));
  result.Jz[84] = fnma(s1_5, s2_76, s1_7*s2_72) - s2_79;
  const double s2_84 = fma(s2_73, s2_74, fms(s2_71, s2_72, l_arb_link_front_left));
  result.Phi[6] = 0.5*fma(s2_75, s2_76, s2_84);
  result.Jz[85] = -fma(R_carrier_left_aux1_y_z, s2_81, R_carrier_left_aux1_z_z*s2_80);
  const double s2_85 = fma(R_carrier_left_aux1_z_x, s2_80, R_carrier_left_aux1_x_x*s2_79);
  result.Jz[86] = -fma(R_carrier_left_aux1_y_x, s2_81, s2_85);
  const double s2_86 = fnma(R_carrier_left_aux2_z_y, s2_80, s1_9*s2_79);
  result.Jz[87] = fnma(R_carrier_left_aux2_y_y, s2_81, s2_86);
  const double s2_87 = s2_58 - s2_77;
  const double s2_88 = fnma(s4_11, s2_77, fma(s2_5, s2_68, fma(s2_2, s2_64, s2_82)));
  const double s2_89 = fma(s2_76, s2_88, s2_72*fma(s4_6, s2_77, s2_78));
  const double s2_90 = fma(s2_74, fma(s4_11, s2_69, fnma(s2_8, s2_68, s2_83)), s2_89);
  const double s2_91 = fma(s2_87, s2_87, fma(s2_70, s2_70, s2_65*s2_65));
  result.c[6] = fnma(3.846153846153846, s2_91, s2_90);
  const double R_arb_front_right_x_z = w2.sines[11];
  // arb_link_front_right
  const double R_arb_front_right_x_x = w2.cosines[11];
  const double s2_92 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s2_93 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s2_92);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s2_94 = zd_arb_front_right*s2_93;
  const double s2_95 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  const double s2_96 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s2_95);
  const double s2_97 = zd_arb_front_right*s2_96;
  const double s2_98 = p_arb_link_front_right_to_x*R_carrier_right_y_x;
  const double s2_99 = R_carrier_right_aux2_y_y + R_carrier_right_y_z;
  const double s2_100 = fnma(p_arb_link_front_left_to_y, s2_99, s2_98);
  const double s2_101 = s2_100 + (0.72 + r_carrier_right_aux1_y);
  const double s2_102 = p_arb_link_front_right_to_x*R_carrier_right_x_x;
  const double s2_103 = fnma(p_arb_link_front_left_to_y, R_carrier_right_x_z - s1_22, s2_102);
  const double s2_104 = p_arb_link_front_right_to_x*R_carrier_right_z_x;
  const double s2_105 = R_carrier_right_aux2_z_y + R_carrier_right_z_z;
  const double s2_106 = fnma(p_arb_link_front_left_to_y, s2_105, s2_104);
  const double s2_107 = fnma(s2_4, s2_106, s4_17*s2_103);
  const double s2_108 = fma(zd_lower_arm_right, s1_19, s2_107);
  const double s2_109 = 3.846153846153846*s2_101;
  const double s2_110 = fnma(s4_22, s2_103, s2_4*s2_100);
  const double s2_111 = s2_110 + fma(zd_lower_arm_right, s1_17, s2_94);
  const double s2_112 = 0.35 + s2_93 - s2_103;
  const double s2_113 = 3.846153846153846*s2_112;
  const double s2_114 = s2_96 + (s1_20 + p_arb_front_right_z) - s2_106;
  const double s2_115 = 3.846153846153846*s2_114;
  result.Jz[109] = fnma(s2_93, s2_115, s2_96*s2_113);
  const double s2_116 = fnma(s4_17, s2_100, s4_22*s2_106);
  const double s2_117 = fnma(s2_4, s2_110, fnma(s2_6, s2_106, fms(s2_10, s2_103, s2_18)));
  const double s2_118 = fma(s2_100, s2_113, s2_103*s2_109);
  const double s2_119 = fma(s2_100, s2_115, s2_106*s2_109);
  const double s2_120 = fnma(s2_103, s2_115, s2_106*s2_113);
  const double s2_121 = fma(s2_6, s2_100, fma(zd_arb_front_right, s2_97, s2_17));
  const double s2_122 = fma(s2_12, s2_106, fnma(s2_10, s2_100, zd_arb_front_right*s2_94));
  result.Jz[104] = fnma(s1_17, s2_115, s1_19*s2_109) - s2_119;
  const double s2_123 = fma(s2_112, s2_113, fms(s2_101, s2_109, l_arb_link_front_right));
  result.Phi[7] = 0.5*fma(s2_114, s2_115, s2_123);
  result.Jz[105] = fnma(R_carrier_right_aux1_y_z, s2_120, R_carrier_right_aux1_z_z*s2_118);
  const double s2_124 = fnma(R_carrier_right_aux1_x_x, s2_119, R_carrier_right_aux1_z_x*s2_118);
  result.Jz[106] = fnma(R_carrier_right_aux1_y_x, s2_120, s2_124);
  const double s2_125 = fma(s1_22, s2_119, R_carrier_right_aux2_z_y*s2_118);
  result.Jz[107] = fnma(R_carrier_right_aux2_y_y, s2_120, s2_125);
  const double s2_126 = s2_97 - s2_116;
  const double s2_127 = fnma(s4_22, s2_116, fma(s2_4, s2_107, fnma(s2_12, s2_103, s2_121)));
  const double s2_128 = fnma(s2_109, fma(s4_17, s2_116, s2_117), s2_115*s2_127);
  const double s2_129 = fma(s2_113, fma(s4_22, s2_110, fnma(s4_17, s2_107, s2_122)), s2_128);
  const double s2_130 = fma(s2_126, s2_126, fma(s2_111, s2_111, s2_108*s2_108));
  result.c[7] = fnma(3.846153846153846, s2_130, s2_129);
  // drag_link
  const double s2_131 = -p_drag_link_from_z*w2.sines[12];
  const double s2_132 = -p_drag_link_from_z*w2.cosines[12];
  const double R_bell_crank_y_x = w2.sines[13];
  const double s2_133 = p_drag_link_to_y*R_bell_crank_y_x;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s2_134 = zd_pitman_arm*s2_131;
  const double s2_135 = zd_pitman_arm*s2_132;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s2_136 = zd_bell_crank*s2_133;
  const double R_bell_crank_x_x = w2.cosines[13];
  const double s2_137 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s2_138 = zd_bell_crank*s2_137;
  const double s2_139 = p_pitman_arm_y - s2_137;
  const double s2_140 = 0.8565801464479954*s2_139;
  const double s2_141 = 0.2 - s2_132;
  const double s2_142 = 0.8565801464479954*s2_141;
  const double s2_143 = s2_133 + (1.15 - s2_131);
  const double s2_144 = 0.8565801464479954*s2_143;
  result.Jz[125] = fma(s2_137, s2_144, s2_133*s2_140);
  result.Jz[124] = fnma(s2_132, s2_144, s2_131*s2_142);
  const double s2_145 = fma(s2_141, s2_142, fms(s2_139, s2_140, l_drag_link));
  result.Phi[8] = 0.5*fma(s2_143, s2_144, s2_145);
  const double s2_146 = s2_138 - s2_135;
  const double s2_147 = fma(zd_pitman_arm*s2_135, s2_142, zd_bell_crank*s2_138*s2_140);
  const double s2_148 = fma(s2_144, fnma(zd_bell_crank, s2_136, zd_pitman_arm*s2_134), s2_147);
  const double s2_149 = fma(s2_146, s2_146, fma(s2_136, s2_136, s2_134*s2_134));
  result.c[8] = -fma(0.8565801464479954, s2_149, s2_148);
  // tie_rod_left
  const double s2_150 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_151 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  const double s2_152 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_150);
  const double s2_153 = zd_bell_crank*s2_152;
  const double s2_154 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_151);
  const double s2_155 = zd_bell_crank*s2_154;
  const double s2_156 = p_tie_rod_left_to_z*R_carrier_left_z_z;
  const double s2_157 = fma(p_tie_rod_left_to_x, R_carrier_left_z_x, s2_156) - s2_19;
  const double s2_158 = s2_157 + (r_carrier_left_aux1_z - p_bell_crank_z);
  const double s2_159 = p_tie_rod_left_to_z*R_carrier_left_y_z;
  const double s2_160 = fma(p_tie_rod_left_to_x, R_carrier_left_y_x, s2_159) - s2_20;
  const double s2_161 = p_tie_rod_left_to_z*R_carrier_left_x_z;
  const double s2_162 = s2_23 + fma(p_tie_rod_left_to_x, R_carrier_left_x_x, s2_161);
  const double s2_163 = fnma(s4_11, s2_162, s2_2*s2_160);
  const double s2_164 = fma(zd_lower_arm_left, s1_5, s2_163);
  const double s2_165 = fnma(s4_6, s2_160, s4_11*s2_157);
  const double s2_166 = s2_155 + s2_165;
  const double s2_167 = 1.262590031797617*s2_158;
  const double s2_168 = s2_154 - r_carrier_left_aux1_y - s2_160;
  const double s2_169 = 1.262590031797617*s2_168;
  const double s2_170 = fnma(s2_2, s2_157, s4_6*s2_162);
  const double s2_171 = s2_170 + fnma(zd_lower_arm_left, s1_7, s2_153);
  const double s2_172 = s2_162 + (0.35 + s2_152);
  const double s2_173 = 1.262590031797617*s2_172;
  const double s2_174 = fnma(s4_11, s2_165, fnma(s2_11, s2_162, fms(s2_5, s2_160, s2_15)));
  result.Jz[139] = fnma(s2_152, s2_169, s2_154*s2_173);
  const double s2_175 = fma(s2_157, s2_169, s2_160*s2_167);
  const double s2_176 = fnma(s2_157, s2_173, s2_162*s2_167);
  const double s2_177 = fma(s2_160, s2_173, s2_162*s2_169);
  result.Jz[126] = s2_175 + fma(s1_7, s2_169, s1_5*s2_167);
  const double s2_178 = fma(s2_8, s2_162, fnma(s2_5, s2_157, fms(zd_bell_crank, s2_155, s2_14)));
  const double s2_179 = fma(s2_168, s2_169, fms(s2_158, s2_167, l_tie_rod_left));
  result.Phi[9] = 0.5*fma(s2_172, s2_173, s2_179);
  result.Jz[127] = -fma(R_carrier_left_aux1_z_z, s2_177, R_carrier_left_aux1_y_z*s2_176);
  const double s2_180 = fnma(R_carrier_left_aux1_y_x, s2_176, R_carrier_left_aux1_x_x*s2_175);
  result.Jz[128] = fnma(R_carrier_left_aux1_z_x, s2_177, s2_180);
  const double s2_181 = fma(R_carrier_left_aux2_y_y, s2_176, s1_9*s2_175);
  result.Jz[129] = -fma(R_carrier_left_aux2_z_y, s2_177, s2_181);
  const double s2_182 = fma(s2_8, s2_160, fnma(s2_11, s2_157, zd_bell_crank*s2_153));
  const double s2_183 = s2_169*fma(s4_6, s2_165, fnma(s2_2, s2_163, s2_178));
  const double s2_184 = fma(s2_171, s2_171, fma(s2_166, s2_166, s2_164*s2_164));
  const double s2_185 = fnma(s2_167, fma(s2_2, s2_170, s2_174), s2_183);
  const double s2_186 = fma(s4_6, s2_170, fnma(s4_11, s2_163, s2_182));
  result.c[9] = fma(s2_173, s2_186, fnma(1.262590031797617, s2_184, s2_185));
  // tie_rod_right
  const double s2_187 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_151);
  const double s2_188 = zd_bell_crank*s2_187;
  const double s2_189 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_150);
  const double s2_190 = zd_bell_crank*s2_189;
  const double s2_191 = p_tie_rod_right_to_z*R_carrier_right_z_z;
  const double s2_192 = s2_40 + fma(p_tie_rod_right_to_x, R_carrier_right_z_x, s2_191);
  const double s2_193 = s2_192 + (-p_bell_crank_z - s1_20);
  const double s2_194 = p_tie_rod_right_to_z*R_carrier_right_y_z;
  const double s2_195 = s2_42 + fma(p_tie_rod_right_to_x, R_carrier_right_y_x, s2_194);
  const double s2_196 = s2_195 + (r_carrier_right_aux1_y + s2_187);
  const double s2_197 = p_tie_rod_right_to_z*R_carrier_right_x_z;
  const double s2_198 = fma(p_tie_rod_right_to_x, R_carrier_right_x_x, s2_197) - s2_36;
  const double s2_199 = fnma(s4_22, s2_198, s2_4*s2_195);
  const double s2_200 = fma(zd_lower_arm_right, s1_17, s2_199);
  const double s2_201 = 1.262590031797617*s2_193;
  const double s2_202 = 1.262590031797617*s2_196;
  const double s2_203 = s2_189 - 0.35 - s2_198;
  const double s2_204 = 1.262590031797617*s2_203;
  result.Jz[153] = fnma(s2_189, s2_202, s2_187*s2_204);
  const double s2_205 = fnma(s2_4, s2_192, s4_17*s2_198);
  const double s2_206 = fnma(s4_17, s2_195, s4_22*s2_192);
  const double s2_207 = fma(s2_4, s2_205, fnma(s2_12, s2_198, fma(s2_6, s2_195, s2_17)));
  const double s2_208 = fma(s2_195, s2_204, s2_198*s2_202);
  const double s2_209 = fnma(s2_195, s2_201, s2_192*s2_202);
  const double s2_210 = fma(s2_192, s2_204, s2_198*s2_201);
  const double s2_211 = fnma(s2_10, s2_195, fma(s2_12, s2_192, zd_bell_crank*s2_190));
  result.Jz[146] = fma(s1_19, s2_202, s1_17*s2_201) - s2_209;
  const double s2_212 = fma(s2_196, s2_202, fms(s2_193, s2_201, l_tie_rod_right));
  result.Phi[10] = 0.5*fma(s2_203, s2_204, s2_212);
  result.Jz[147] = fnma(R_carrier_right_aux1_y_z, s2_210, R_carrier_right_aux1_z_z*s2_208);
  const double s2_213 = fma(s2_6, s2_192, fma(zd_bell_crank, s2_188, s2_18));
  const double s2_214 = fnma(R_carrier_right_aux1_x_x, s2_209, R_carrier_right_aux1_z_x*s2_208);
  result.Jz[148] = fnma(R_carrier_right_aux1_y_x, s2_210, s2_214);
  const double s2_215 = fma(s1_22, s2_209, R_carrier_right_aux2_z_y*s2_208);
  result.Jz[149] = fnma(R_carrier_right_aux2_y_y, s2_210, s2_215);
  const double s2_216 = s2_188 - s2_206;
  const double s2_217 = fnma(zd_lower_arm_right, s1_19, s2_190) - s2_205;
  const double s2_218 = s2_204*fnma(s4_17, s2_205, fma(s4_22, s2_199, s2_211));
  const double s2_219 = fnma(s4_17, s2_206, fma(s2_4, s2_199, fnma(s2_10, s2_198, s2_213)));
  const double s2_220 = fma(s2_202, s2_219, fnma(s2_201, fnma(s4_22, s2_206, s2_207), s2_218));
  const double s2_221 = fma(s2_217, s2_217, fma(s2_216, s2_216, s2_200*s2_200));
  result.c[10] = fnma(1.262590031797617, s2_221, s2_220);
}

/// Part 2 of compute_closure_terms: step 2: closure Jacobian Phi_z and its factors (60).
[[gnu::noinline]] void compute_closure_terms_2(const State& state, ClosureTermsWork1& __restrict w1,
    ClosureTermsWork2& __restrict w2, ClosureTerms& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  const double s2_222 = fma(w1.s4_23, w1.s4_33 - w1.s4_32, w1.s4_24*w1.s4_34);
  const double s2_223 = fma(w1.s4_26, w1.s4_33, fnma(w1.s4_27, w1.s4_29, w1.s4_30*w1.s4_32));
  const double s2_224 = fnma(w1.s4_28, w1.s4_34, s2_223);
  const double s2_225 = fnma(w1.s4_24, w1.s4_30, w1.s4_23*(w1.s4_28 - w1.s4_29));
  // long_rod_left
  const double s2_226 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_z_x;
  const double s2_227 = fma(p_long_rod_left_to_z, w1.R_rear_axle_z_z, s2_226);
  const double s2_228 = fma(p_long_rod_left_to_y, w1.R_rear_axle_z_y, s2_227);
  const double s2_229 = w1.r_rear_axle_aux3_z - p_long_rod_left_from_z;
  const double s2_230 = s2_228 + s2_229;
  const double s2_231 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_x_x;
  const double s2_232 = fma(p_long_rod_left_to_z, w1.R_rear_axle_x_z, s2_231);
  const double s2_233 = fma(p_long_rod_left_to_y, w1.R_rear_axle_x_y, s2_232);
  const double s2_234 = w1.r_rear_axle_aux1_x - p_long_rod_left_from_x;
  const double s2_235 = s2_233 + s2_234;
  const double s2_236 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_y_x;
  const double s2_237 = fma(p_long_rod_left_to_z, w1.R_rear_axle_y_z, s2_236);
  const double s2_238 = fma(p_long_rod_left_to_y, w1.R_rear_axle_y_y, s2_237);
  const double s2_239 = fnma(w1.s4_31, s2_238, w1.s4_25*s2_228);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s2_240 = zd_rear_axle_tx + s2_239;
  const double s2_241 = fnma(w1.s4_35, s2_228, w1.s4_31*s2_233);
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s2_242 = zd_rear_axle_ty + s2_241;
  const double s2_243 = fnma(w1.s4_25, s2_233, w1.s4_35*s2_238);
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s2_244 = zd_rear_axle_tz + s2_243;
  const double s2_245 = 1.1757385222540735*s2_230;
  result.Jz[156] = s2_245;
  const double s2_246 = 1.1757385222540735*s2_235;
  result.Jz[154] = s2_246;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_247 = p_long_rod_left_from_y - z_rear_axle_ty - s2_238;
  const double s2_248 = 1.1757385222540735*s2_247;
  result.Jz[155] = -s2_248;
  const double s2_249 = fma(w1.s4_31, s2_239, fnma(s2_225, s2_228, s2_222*s2_233));
  const double s2_250 = fnma(w1.s4_31, s2_241, fnma(s2_222, s2_238, s2_224*s2_228));
  const double s2_251 = fnma(w1.s4_25, s2_239, fnma(s2_224, s2_233, s2_225*s2_238));
  const double s2_252 = fma(s2_228, s2_248, s2_238*s2_245);
  const double s2_253 = fma(s2_233, s2_248, s2_238*s2_246);
  const double s2_254 = fnma(s2_228, s2_246, s2_233*s2_245);
  const double s2_255 = fma(s2_235, s2_246, fms(s2_230, s2_245, l_long_rod_left));
  result.Phi[11] = 0.5*fma(s2_247, s2_248, s2_255);
  result.Jz[157] = fnma(w1.R_rear_axle_aux4_z_z, s2_253, w1.R_rear_axle_aux4_x_z*s2_252);
  const double R_rear_axle_aux4_y_y = w2.cosines[14];
  const double s2_256 = fnma(w1.s1_27, s2_252, w1.s1_29*s2_253);
  result.Jz[158] = fnma(R_rear_axle_aux4_y_y, s2_254, s2_256);
  const double s2_257 = fnma(w1.R_rear_axle_aux5_z_x, s2_253, w1.R_rear_axle_aux5_x_x*s2_252);
  result.Jz[159] = fnma(w1.R_rear_axle_aux5_y_x, s2_254, s2_257);
  const double s2_258 = s2_248*fnma(w1.s4_35, s2_243, s2_249);
  const double s2_259 = fnma(s2_246, fma(w1.s4_25, s2_243, s2_250), s2_258);
  const double s2_260 = fma(s2_244, s2_244, fma(s2_242, s2_242, s2_240*s2_240));
  const double s2_261 = fnma(s2_245, fma(w1.s4_35, s2_241, s2_251), s2_259);
  result.c[11] = fnma(1.1757385222540735, s2_260, s2_261);
  // diag_rod_left
  const double s2_262 = p_diag_rod_left_to_z*w1.R_rear_axle_z_z;
  const double s2_263 = fma(p_diag_rod_left_to_y, w1.R_rear_axle_z_y, s2_262);
  const double s2_264 = w1.r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  const double s2_265 = s2_263 + s2_264;
  const double s2_266 = p_diag_rod_left_to_z*w1.R_rear_axle_x_z;
  const double s2_267 = fma(p_diag_rod_left_to_y, w1.R_rear_axle_x_y, s2_266);
  const double s2_268 = w1.r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  const double s2_269 = s2_267 + s2_268;
  const double s2_270 = p_diag_rod_left_to_y*w1.R_rear_axle_y_y;
  const double s2_271 = fma(p_diag_rod_left_to_z, w1.R_rear_axle_y_z, s2_270);
  const double s2_272 = fnma(w1.s4_31, s2_271, w1.s4_25*s2_263);
  const double s2_273 = zd_rear_axle_tx + s2_272;
  const double s2_274 = fnma(w1.s4_35, s2_263, w1.s4_31*s2_267);
  const double s2_275 = zd_rear_axle_ty + s2_274;
  const double s2_276 = fnma(w1.s4_25, s2_267, w1.s4_35*s2_271);
  const double s2_277 = zd_rear_axle_tz + s2_276;
  const double s2_278 = 1.162476387438193*s2_265;
  result.Jz[164] = s2_278;
  const double s2_279 = 1.162476387438193*s2_269;
  result.Jz[162] = s2_279;
  const double s2_280 = p_diag_rod_left_from_y - z_rear_axle_ty - s2_271;
  const double s2_281 = 1.162476387438193*s2_280;
  result.Jz[163] = -s2_281;
  const double s2_282 = fma(w1.s4_31, s2_272, fnma(s2_225, s2_263, s2_222*s2_267));
  const double s2_283 = fnma(w1.s4_31, s2_274, fnma(s2_222, s2_271, s2_224*s2_263));
  const double s2_284 = fnma(w1.s4_25, s2_272, fnma(s2_224, s2_267, s2_225*s2_271));
  const double s2_285 = fma(s2_263, s2_281, s2_271*s2_278);
  const double s2_286 = fma(s2_267, s2_281, s2_271*s2_279);
  const double s2_287 = fnma(s2_263, s2_279, s2_267*s2_278);
  const double s2_288 = fma(s2_269, s2_279, fms(s2_265, s2_278, l_diag_rod_left));
  result.Phi[12] = 0.5*fma(s2_280, s2_281, s2_288);
  result.Jz[165] = fnma(w1.R_rear_axle_aux4_z_z, s2_286, w1.R_rear_axle_aux4_x_z*s2_285);
  const double s2_289 = fnma(w1.s1_27, s2_285, w1.s1_29*s2_286);
  result.Jz[166] = fnma(R_rear_axle_aux4_y_y, s2_287, s2_289);
  const double s2_290 = fnma(w1.R_rear_axle_aux5_z_x, s2_286, w1.R_rear_axle_aux5_x_x*s2_285);
  result.Jz[167] = fnma(w1.R_rear_axle_aux5_y_x, s2_287, s2_290);
  const double s2_291 = s2_281*fnma(w1.s4_35, s2_276, s2_282);
  const double s2_292 = fnma(s2_279, fma(w1.s4_25, s2_276, s2_283), s2_291);
  const double s2_293 = fma(s2_277, s2_277, fma(s2_275, s2_275, s2_273*s2_273));
  const double s2_294 = fnma(s2_278, fma(w1.s4_35, s2_274, s2_284), s2_292);
  result.c[12] = fnma(1.162476387438193, s2_293, s2_294);
  // arb_link_rear_left
  const double s2_295 = p_arb_link_rear_left_from_x*w2.sines[17];
  const double s2_296 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_y_x;
  const double s2_297 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_y_z, s2_296);
  const double s2_298 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_z_x;
  const double s2_299 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_z_z, s2_298);
  const double s2_300 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_x_x;
  const double s2_301 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_x_z, s2_300);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s2_302 = zd_arb_rear_left*s2_295;
  const double s2_303 = p_arb_link_rear_left_from_x*w2.cosines[17];
  const double s2_304 = zd_arb_rear_left*s2_303;
  const double s2_305 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_z_y, s2_299);
  const double s2_306 = w1.r_rear_axle_aux3_z - p_arb_rear_left_z;
  const double s2_307 = s2_306 + (s2_295 + s2_305);
  const double s2_308 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_x_y, s2_301);
  const double s2_309 = fnma(w1.s4_35, s2_305, w1.s4_31*s2_308);
  const double s2_310 = zd_rear_axle_ty + s2_309;
  const double s2_311 = 4.47213595499958*s2_307;
  result.Jz[172] = s2_311;
  const double s2_312 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_y_y, s2_297);
  const double s2_313 = 0.6 - z_rear_axle_ty - s2_312;
  const double s2_314 = 4.47213595499958*s2_313;
  result.Jz[171] = -s2_314;
  const double s2_315 = s2_303 + p_arb_rear_left_x - w1.r_rear_axle_aux1_x - s2_308;
  const double s2_316 = 4.47213595499958*s2_315;
  result.Jz[170] = -s2_316;
  const double s2_317 = fnma(w1.s4_31, s2_312, w1.s4_25*s2_305);
  const double s2_318 = s2_317 + (zd_rear_axle_tx + s2_302);
  const double s2_319 = fnma(w1.s4_25, s2_308, w1.s4_35*s2_312);
  const double s2_320 = s2_319 + (zd_rear_axle_tz + s2_304);
  result.Jz[176] = fnma(s2_295, s2_316, s2_303*s2_311);
  const double s2_321 = fma(w1.s4_31, s2_317, fnma(s2_225, s2_305, s2_222*s2_308));
  const double s2_322 = fma(s2_305, s2_314, s2_311*s2_312);
  const double s2_323 = fnma(s2_312, s2_316, s2_308*s2_314);
  const double s2_324 = fma(s2_305, s2_316, s2_308*s2_311);
  const double s2_325 = fnma(w1.s4_31, s2_309, fma(s2_224, s2_305, zd_arb_rear_left*s2_304));
  const double s2_326 = fma(s2_313, s2_314, fms(s2_307, s2_311, l_arb_link_rear_left));
  result.Phi[13] = 0.5*fma(s2_315, s2_316, s2_326);
  result.Jz[173] = fnma(w1.R_rear_axle_aux4_z_z, s2_323, w1.R_rear_axle_aux4_x_z*s2_322);
  const double s2_327 = fnma(w1.s4_35, s2_309, fma(s2_224, s2_308, zd_arb_rear_left*s2_302));
  const double s2_328 = fnma(w1.s1_27, s2_322, w1.s1_29*s2_323);
  result.Jz[174] = fnma(R_rear_axle_aux4_y_y, s2_324, s2_328);
  const double s2_329 = fnma(w1.R_rear_axle_aux5_z_x, s2_323, w1.R_rear_axle_aux5_x_x*s2_322);
  result.Jz[175] = fnma(w1.R_rear_axle_aux5_y_x, s2_324, s2_329);
  const double s2_330 = fma(w1.s4_25, s2_319, fnma(s2_222, s2_312, s2_325));
  const double s2_331 = fma(s2_316, s2_330, s2_314*fnma(w1.s4_35, s2_319, s2_321));
  const double s2_332 = fma(s2_311, fma(w1.s4_25, s2_317, fnma(s2_225, s2_312, s2_327)), s2_331);
  const double s2_333 = fma(s2_320, s2_320, fma(s2_318, s2_318, s2_310*s2_310));
  result.c[13] = fnma(4.47213595499958, s2_333, s2_332);
  // long_rod_right
  const double s2_334 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_y_y, s2_237);
  const double s2_335 = s2_334 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s2_336 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_z_y, s2_227);
  const double s2_337 = s2_229 + s2_336;
  const double s2_338 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_x_y, s2_232);
  const double s2_339 = s2_234 + s2_338;
  const double s2_340 = fnma(w1.s4_31, s2_334, w1.s4_25*s2_336);
  const double s2_341 = zd_rear_axle_tx + s2_340;
  const double s2_342 = fnma(w1.s4_35, s2_336, w1.s4_31*s2_338);
  const double s2_343 = zd_rear_axle_ty + s2_342;
  const double s2_344 = fnma(w1.s4_25, s2_338, w1.s4_35*s2_334);
  const double s2_345 = zd_rear_axle_tz + s2_344;
  const double s2_346 = 1.1757385222540735*s2_335;
  result.Jz[179] = s2_346;
  const double s2_347 = 1.1757385222540735*s2_337;
  result.Jz[180] = s2_347;
  const double s2_348 = 1.1757385222540735*s2_339;
  result.Jz[178] = s2_348;
  const double s2_349 = fma(w1.s4_31, s2_340, fnma(s2_225, s2_336, s2_222*s2_338));
  const double s2_350 = fnma(w1.s4_31, s2_342, fnma(s2_222, s2_334, s2_224*s2_336));
  const double s2_351 = fnma(w1.s4_25, s2_340, fnma(s2_224, s2_338, s2_225*s2_334));
  const double s2_352 = fnma(s2_336, s2_348, s2_338*s2_347);
  const double s2_353 = fnma(s2_338, s2_346, s2_334*s2_348);
  const double s2_354 = fnma(s2_334, s2_347, s2_336*s2_346);
  const double s2_355 = fma(s2_337, s2_347, fms(s2_335, s2_346, l_long_rod_right));
  result.Phi[14] = 0.5*fma(s2_339, s2_348, s2_355);
  result.Jz[181] = -fma(w1.R_rear_axle_aux4_x_z, s2_354, w1.R_rear_axle_aux4_z_z*s2_353);
  const double s2_356 = fma(w1.R_rear_axle_aux5_z_x, s2_353, w1.R_rear_axle_aux5_y_x*s2_352);
  result.Jz[183] = -fma(w1.R_rear_axle_aux5_x_x, s2_354, s2_356);
  const double s2_357 = fnma(R_rear_axle_aux4_y_y, s2_352, w1.s1_29*s2_353);
  result.Jz[182] = fma(w1.s1_27, s2_354, s2_357);
  const double s2_358 = s2_346*fnma(w1.s4_35, s2_344, s2_349);
  const double s2_359 = fma(s2_348, fma(w1.s4_25, s2_344, s2_350), s2_358);
  const double s2_360 = fma(s2_345, s2_345, fma(s2_343, s2_343, s2_341*s2_341));
  const double s2_361 = fma(s2_347, fma(w1.s4_35, s2_342, s2_351), s2_359);
  result.c[14] = -fma(1.1757385222540735, s2_360, s2_361);
  // diag_rod_right
  const double s2_362 = fnma(p_diag_rod_left_to_y, w1.R_rear_axle_z_y, s2_262);
  const double s2_363 = s2_264 + s2_362;
  const double s2_364 = fms(p_diag_rod_left_to_z, w1.R_rear_axle_y_z, s2_270);
  const double s2_365 = s2_364 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  const double s2_366 = fnma(p_diag_rod_left_to_y, w1.R_rear_axle_x_y, s2_266);
  const double s2_367 = s2_268 + s2_366;
  const double s2_368 = fnma(w1.s4_31, s2_364, w1.s4_25*s2_362);
  const double s2_369 = zd_rear_axle_tx + s2_368;
  const double s2_370 = fnma(w1.s4_35, s2_362, w1.s4_31*s2_366);
  const double s2_371 = zd_rear_axle_ty + s2_370;
  const double s2_372 = fnma(w1.s4_25, s2_366, w1.s4_35*s2_364);
  const double s2_373 = zd_rear_axle_tz + s2_372;
  const double s2_374 = 1.162476387438193*s2_363;
  result.Jz[188] = s2_374;
  const double s2_375 = 1.162476387438193*s2_365;
  result.Jz[187] = s2_375;
  const double s2_376 = 1.162476387438193*s2_367;
  result.Jz[186] = s2_376;
  const double s2_377 = fma(w1.s4_31, s2_368, fnma(s2_225, s2_362, s2_222*s2_366));
  const double s2_378 = fnma(w1.s4_31, s2_370, fnma(s2_222, s2_364, s2_224*s2_362));
  const double s2_379 = fnma(w1.s4_25, s2_368, fnma(s2_224, s2_366, s2_225*s2_364));
  const double s2_380 = fnma(s2_362, s2_376, s2_366*s2_374);
  const double s2_381 = fnma(s2_366, s2_375, s2_364*s2_376);
  const double s2_382 = fnma(s2_364, s2_374, s2_362*s2_375);
  const double s2_383 = fma(s2_365, s2_375, fms(s2_363, s2_374, l_diag_rod_right));
  result.Phi[15] = 0.5*fma(s2_367, s2_376, s2_383);
  result.Jz[189] = -fma(w1.R_rear_axle_aux4_x_z, s2_382, w1.R_rear_axle_aux4_z_z*s2_381);
  const double s2_384 = fma(w1.R_rear_axle_aux5_z_x, s2_381, w1.R_rear_axle_aux5_y_x*s2_380);
  result.Jz[191] = -fma(w1.R_rear_axle_aux5_x_x, s2_382, s2_384);
  const double s2_385 = fnma(R_rear_axle_aux4_y_y, s2_380, w1.s1_29*s2_381);
  result.Jz[190] = fma(w1.s1_27, s2_382, s2_385);
  const double s2_386 = s2_375*fnma(w1.s4_35, s2_372, s2_377);
  const double s2_387 = fma(s2_376, fma(w1.s4_25, s2_372, s2_378), s2_386);
  const double s2_388 = fma(s2_373, s2_373, fma(s2_371, s2_371, s2_369*s2_369));
  const double s2_389 = fma(s2_374, fma(w1.s4_35, s2_370, s2_379), s2_387);
  result.c[15] = -fma(1.162476387438193, s2_388, s2_389);
  // arb_link_rear_right
  const double s2_390 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_y_y, s2_297);
  const double s2_391 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_x_y, s2_301);
  const double s2_392 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_z_y, s2_299);
  const double s2_393 = p_arb_link_rear_right_from_x*w2.sines[18];
  const double s2_394 = 0.6 + z_rear_axle_ty - s2_390;
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s2_395 = zd_arb_rear_right*s2_393;
  const double s2_396 = p_arb_link_rear_right_from_x*w2.cosines[18];
  const double s2_397 = zd_arb_rear_right*s2_396;
  const double s2_398 = fnma(w1.s4_31, s2_391, w1.s4_35*s2_392);
  const double s2_399 = zd_rear_axle_ty + s2_398;
  const double s2_400 = s2_393 + (s2_306 - s2_392);
  const double s2_401 = 4.47213595499958*s2_394;
  result.Jz[195] = s2_401;
  const double s2_402 = fnma(w1.s4_25, s2_392, w1.s4_31*s2_390);
  const double s2_403 = s2_402 + (zd_rear_axle_tx + s2_395);
  const double s2_404 = fnma(w1.s4_35, s2_390, w1.s4_25*s2_391);
  const double s2_405 = s2_404 + (zd_rear_axle_tz + s2_397);
  const double s2_406 = 4.47213595499958*s2_400;
  result.Jz[196] = s2_406;
  const double s2_407 = s2_396 + (s2_391 + p_arb_rear_right_x - w1.r_rear_axle_aux1_x);
  const double s2_408 = 4.47213595499958*s2_407;
  result.Jz[194] = -s2_408;
  const double s2_409 = fma(w1.s4_31, s2_402, fnma(s2_222, s2_391, s2_225*s2_392));
  result.Jz[201] = fnma(s2_393, s2_408, s2_396*s2_406);
  const double s2_410 = fma(zd_arb_rear_right, s2_397, fnma(s2_224, s2_392, s2_222*s2_390));
  const double s2_411 = fma(s2_392, s2_408, s2_391*s2_406);
  const double s2_412 = fma(s2_390, s2_408, s2_391*s2_401);
  const double s2_413 = fnma(s2_392, s2_401, s2_390*s2_406);
  const double s2_414 = fma(zd_arb_rear_right, s2_395, fnma(s2_224, s2_391, s2_225*s2_390));
  const double s2_415 = fma(s2_400, s2_406, fms(s2_394, s2_401, l_arb_link_rear_right));
  result.Phi[16] = 0.5*fma(s2_407, s2_408, s2_415);
  result.Jz[197] = -fma(w1.R_rear_axle_aux4_x_z, s2_413, w1.R_rear_axle_aux4_z_z*s2_412);
  const double s2_416 = fma(w1.s1_29, s2_412, R_rear_axle_aux4_y_y*s2_411);
  result.Jz[198] = fma(w1.s1_27, s2_413, s2_416);
  const double s2_417 = fnma(w1.R_rear_axle_aux5_z_x, s2_412, w1.R_rear_axle_aux5_y_x*s2_411);
  result.Jz[199] = fnma(w1.R_rear_axle_aux5_x_x, s2_413, s2_417);
  const double s2_418 = s2_408*fma(w1.s4_25, s2_404, fnma(w1.s4_31, s2_398, s2_410));
  const double s2_419 = fma(w1.s4_25, s2_402, fnma(w1.s4_35, s2_398, s2_414));
  const double s2_420 = fnma(s2_401, fnma(w1.s4_35, s2_404, s2_409), s2_418);
  const double s2_421 = fma(s2_405, s2_405, fma(s2_403, s2_403, s2_399*s2_399));
  result.c[16] = fnma(4.47213595499958, s2_421, fma(s2_406, s2_419, s2_420));
  // operations: 584 add, 751 multiply
}

/// Closure equations and their derivatives, for the pivoting factorisation.
void compute_closure_terms(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, ClosureTerms& __restrict result) noexcept {
  ClosureTermsWork1 w1;
  ClosureTermsWork2 w2;
  compute_closure_terms_1(state, w1, w2, result);
  compute_closure_terms_2(state, w1, w2, result);
}
#endif  // part 1

/// Result of compute_chosen_accelerations.
struct ChosenAccelerations {
  double zdd[32];  ///< accelerations
  double xd[1];  ///< rates of the auxiliary states
  double inertia[15];  ///< pivots of the final equations
};

void compute_chosen_accelerations(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, const Projection& projection,
    ChosenAccelerations& __restrict result) noexcept;

#if MBGEN_IS_PART(1)
/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork1 {
  double
      s4_38, s4_40, s4_42, R_carrier_left_aux2_y_y, R_carrier_right_aux2_y_y, s1_22, s1_35,
      r_carrier_left_aux1_y, r_carrier_left_aux1_z, r_carrier_right_aux1_y, s1_33,
      r_rear_axle_aux1_x, R_carrier_left_aux2_z_y, R_carrier_right_aux2_z_y, r_rear_axle_aux3_z,
      w_chassis_z, w_chassis_y, w_chassis_x, R_rear_axle_aux5_y_x, R_rear_axle_aux5_x_x,
      R_rear_axle_x_y, R_rear_axle_y_y, R_rear_axle_z_y, R_carrier_left_aux1_z_z,
      R_carrier_left_aux1_y_x, R_carrier_left_aux1_z_x, R_carrier_right_aux1_z_z,
      R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x, R_rear_axle_aux5_z_x,
      R_carrier_left_aux1_y_z, R_carrier_right_aux1_y_z, R_rear_axle_aux4_z_z, s1_40, s1_42, s4_31,
      s4_33, s4_35, s4_37, s4_44, s4_48, w_carrier_left_x, w_carrier_right_x, s1_30,
      R_rear_axle_aux4_x_z, R_rear_axle_y_z, w_carrier_left_y, w_carrier_left_z, w_carrier_right_y,
      w_carrier_right_z, s1_18, s1_20, R_carrier_left_y_x, R_carrier_left_y_z, R_carrier_right_y_x,
      R_carrier_right_y_z, R_carrier_left_x_x, R_carrier_left_x_z, s1_32, R_carrier_right_x_x,
      R_carrier_right_x_z, R_rear_axle_x_z, s4_25, R_rear_axle_z_z, R_carrier_left_z_x,
      R_carrier_left_z_z, R_carrier_right_z_x, R_carrier_right_z_z, s4_6, s4_7, s4_14, s4_15, s4_22,
      s4_23, s4_45, s4_46, s4_49, s4_50, R_chassis_z_x, R_chassis_z_y, R_chassis_z_z, s4_1, s4_3,
      s4_5, s4_8, s4_9, s4_10, s4_11, s4_12, s4_13, s4_16, s4_17, s4_18, s4_19, s4_20, s4_21, s4_30,
      s4_32, s4_34, s4_36, s4_43, s4_47, R_chassis_aux5_y_x, R_chassis_x_x, R_chassis_x_y,
      R_chassis_x_z, R_chassis_y_y, R_chassis_y_z, s4_2, s4_4, s1_48, s1_49, s1_50, s1_51, s1_58,
      s1_59, s1_66, s1_67, s1_74, s1_75, s1_82, s1_83, s1_89, s1_90, s1_92, s1_94, s1_95, s1_96;
};

/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork2 {
  double
      s8_15, s8_16, s8_14, s8_12, s8_11, s8_13, s8_19, s8_20, s8_21, s3_2, s3_7, s3_13, s3_4, s3_10,
      s3_16, s7_8, s7_10, s7_12, s6_5, s6_10, s6_15, s7_36, s7_38, s8_125, s8_145, s8_188, s8_239,
      s8_284, s7_19, s7_26, s7_28, s7_45, s7_46, s8_166, s8_207, s8_247, s8_282, s8_150, s8_168,
      s8_192, s8_209, s8_245, s8_249, s7_35, s7_37, s7_44, s7_47, s8_42, s8_112, s8_167, s8_208,
      s8_248, s7_33, s8_41, s8_169, s8_210, s8_262, s7_30, s7_34, s7_41, s7_42, s7_50, s7_51, s8_28,
      s8_47, f_rear_axle_x, f_rear_axle_y, f_rear_axle_z, s8_107, s8_174, s8_179, s8_184, s8_216,
      s8_221, s8_226, s8_268, s8_275, s8_280, s7_3, s7_6, s7_31, s7_43, s7_52, s8_22, s8_23, s8_24,
      s8_25, s8_27, s8_30, s8_33, s8_34, s8_38, s8_46, s8_50, s8_51, s8_54, s8_55, s8_113, s8_114,
      s8_115, s6_1, s6_6, s6_11, s6_12, s8_26, s8_29, s8_31, s8_32, s8_35, s8_44, s8_45, s8_48,
      s8_52, s8_61, s8_64, s8_76, n_rear_axle_x, n_rear_axle_y, n_rear_axle_z, s8_37, s8_40, s8_43,
      s8_49, s8_53, s8_56, s8_138, s8_139, s8_140;
};

/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork3 {
  double
      s7_71, s7_141, s7_66, s7_69, s7_144, s7_147, s7_54, s7_56, s7_103, s7_105, s7_116, s7_120,
      s3_31, s3_40, s3_49, s3_58, s3_34, s3_43, s3_52, s3_61, s3_37, s3_46, s3_55, s3_64, s7_85,
      s7_93, s7_95, s7_161, s7_169, s7_171, s8_318, s8_365, s8_402, s7_129, s7_131, s8_320, s8_357,
      s8_414, s8_497, s8_498, s8_531, s8_286, s8_300, s8_322, s8_336, s8_379, s8_380, s8_391,
      s8_502, s8_506, s8_544, s8_560, s8_561, s7_114, s7_118, s8_299, s8_335, s8_366, s8_503,
      s8_520, s8_546, s8_301, s8_337, s8_381, s8_508, s8_509, s8_562, s6_32, s6_38, s6_43, s6_48,
      s7_100, s8_306, s8_311, s8_316, s8_342, s8_347, s8_352, s8_455, s8_461, s8_467, s8_501,
      s8_521, s8_563, s6_19, s7_61, s7_62, s7_97, s7_98, s7_101, s7_110, s7_111, s7_125, s7_126,
      s7_136, s7_137, s8_438, s8_505, s8_545, s8_565, s6_16, s6_20, s7_63, s7_112, s7_127, s7_138,
      s8_532, s8_564, s3_18, s3_20, s3_22, s3_24, s3_26, s3_28, s6_17, s6_18, s6_21, s6_22, s6_23,
      s6_24, s6_25, s6_26, s6_27, s6_28, s6_33, s6_34, s6_39, s6_44;
};

/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork4 {
  double
      s7_179, s8_586, s8_589, s8_592, s8_595, s8_598, s8_601, s7_211, s7_181, s7_190, s7_192,
      s7_204, s7_205, s7_214, s8_587, s8_588, s8_590, s8_591, s8_593, s8_594, s8_596, s8_597,
      s7_194, s7_196, s8_599, s8_600, s8_602, s8_603, f_carrier_right_y, f_carrier_right_z, s7_176,
      s8_605, s8_607, s7_173, s7_177, s7_186, s7_187, s7_201, s7_202, s7_208, s7_209, s7_217,
      s7_218, s8_614, s8_642, s8_659, s8_664, s8_680, n_carrier_right_x, s7_188, s7_203, s7_210,
      s7_219, s8_613, s8_615, s8_616, s8_617, s8_621, s8_622, s8_627, s8_629, s8_630, s8_631,
      s8_632, s8_633, s8_634, s8_637, s8_638, s8_639, s8_641, s8_643, s8_644, s8_645, s8_646,
      s8_652, s8_653, s8_654, s8_655, s8_656, s8_657, s8_660, s8_661, s8_663, s8_665, s8_666,
      s8_669, s8_670, s8_674, s8_675, s8_676, s8_679, s8_682, s8_683, s8_684, s8_685, s8_687,
      f_carrier_right_x, s8_608, s8_609, s8_610, s8_611, s8_612, s8_618, s8_623, s8_625, s8_626,
      s8_635, s8_640, s8_662, s8_668, s8_677, s8_678, s8_686, s8_698, s8_701, s8_712, s8_620,
      s8_624, s8_628, s8_648, s8_650, s8_651, s8_667, s8_672, s8_673, s8_690, s8_693, s8_694;
};

/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork5 {
  double
      s8_949, s8_956, s8_954, s8_955, s8_914, s8_946, s8_947, s8_948, s8_950, s8_957, s8_961,
      s8_963, s8_747, s8_753, f_carrier_left_y, f_carrier_left_z, s8_880, s8_886, s8_917, s8_745,
      s8_751, s8_874, s8_878, s8_884, s8_743, s8_749, s8_762, s8_768, s8_774, s8_784, s8_801,
      s8_802, s8_814, n_carrier_left_x, s8_876, s8_882, s8_897, s8_910, s8_739, s8_740, s8_741,
      s8_754, s8_755, s8_756, s8_760, s8_766, s8_772, s8_776, s8_777, s8_778, s8_779, s8_780,
      s8_781, s8_783, s8_786, s8_787, s8_788, s8_789, s8_790, s8_791, s8_792, s8_798, s8_800,
      s8_804, s8_805, s8_806, s8_807, s8_809, s8_813, s8_816, s8_817, s8_819, s8_820, s8_821,
      f_carrier_left_x, s8_870, s8_871, s8_872, s8_887, s8_888, s8_889, s8_895, s8_901, s8_907,
      s8_919, s8_922, s8_923, s8_924, s8_925, s8_926, s8_927, s8_929, n_carrier_right_y,
      n_carrier_right_z, s8_758, s8_764, s8_770, s8_782, s8_793, s8_795, s8_799, s8_803, s8_812,
      s8_818, s8_823, s8_830, s8_833, s8_843, n_carrier_left_y, n_carrier_left_z, s8_893, s8_899,
      s8_905, s8_918, s8_738, s8_775, s8_794, s8_796, s8_797, s8_808, s8_810, s8_811, s8_822,
      s8_824, s8_825, s8_890, s8_891, s8_902;
};

/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork6 {
  double
      s8_1224, s8_1011, s8_1013, s8_1064, s8_1067, s8_1105, s8_1128, s8_1163, s8_1177, s8_1201,
      s8_1431, s8_1448, s8_1596, s8_999, s8_1015, s8_1062, s8_1063, s8_1126, s8_1127, s8_1167,
      s8_1178, s8_1246, s8_1471, s8_1515, s8_1612, s8_965, s8_966, s8_967, s8_968, s8_1008, s8_1009,
      s8_1010, s8_1012, s8_1014, s8_1019, s8_1021, s8_1023, s8_1024, s8_1025, s8_1026, s8_1056,
      s8_1057, s8_1058, s8_1059, s8_1060, s8_1061, s8_1065, s8_1066, s8_1068, s8_1069, s8_1070,
      s8_1114, s8_1115, s8_1116, s8_1120, s8_1122, s8_1124, s8_1125, s8_1132, s8_1134, s8_1136,
      s8_1137, s8_1173, s8_1174, s8_1175, s8_1176, s8_1179, s8_1181, s8_1183, s8_1185, s8_1205,
      s8_1207, s8_1209, s8_1480, s8_1481, s8_1532, s8_1556, s8_1614, s8_1485, s8_1499, s8_1580,
      s8_1616, s8_976, s8_982, s8_989, s8_1034, s8_1040, s8_1047, s8_1086, s8_1091, s8_1095,
      s8_1142, s8_1148, s8_1155, s8_1350, s8_1356, s8_1363, s8_1490, s8_1491, s8_1494, s8_1615,
      s8_1285, s8_1438, s8_1447, s8_1476, s8_1498, s8_1581, s8_1618, s8_1323, s8_1366, s8_1369,
      s8_1373, s8_1377, s8_1380, s8_1385, s8_1389, s8_1393, s8_1470, s8_1479, s8_1533, s8_1617,
      s8_1266, s8_1304, s8_1342, s8_1613, s8_1619, s8_1074, s8_1396;
};

/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork7 {
  double
      s8_1649, s8_1620, s8_1674, s8_1712, s8_1622, s8_1731, s8_1751, s8_1754, s8_1621, s8_1677,
      s8_1766, s8_1624, s8_1688, s8_1690, s8_1692, s8_1780, s8_1623, s8_1697, s8_1700, s8_1703,
      s8_1750, s8_1794, s8_1625, s8_1706, s8_1709, s8_1720, s8_1732, s8_1735, s8_1762, s8_1765,
      pivot_chassis_ry, s8_1767;
};

/// Values of compute_chosen_accelerations that cross its parts.
struct ChosenAccelerationsWork8 {
  double
      sines[22], cosines[22];
};

/// Part 1 of compute_chosen_accelerations: step 1: poses and axes b; step 4: velocities; step 7:
/// inertias of the bodies and forces on joints; step 8: elimination from the leaves to the root
/// (63); step 3: Rz (61), long_rod_left .. arb_link_rear_right; step 6: c and dRz/dt zd (62),
/// long_rod_left .. arb_link_rear_right; step 7: inertias of the bodies and forces on joints,
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_chosen_accelerations_1(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork1& __restrict w1,
    ChosenAccelerationsWork2& __restrict w2, ChosenAccelerationsWork8& __restrict w8,
    ChosenAccelerations& __restrict result) noexcept {
  // Results that need no operation.
  result.inertia[9] = I_wheel_front_left_polar;
  result.inertia[10] = I_wheel_front_right_polar;
  result.inertia[13] = I_wheel_rear_left_polar;
  result.inertia[14] = I_wheel_rear_right_polar;

  // --- step 1: poses and axes b ---
  const double angles[] = {
      state.z[Coordinate::chassis_rz], state.z[Coordinate::chassis_ry],
      state.z[Coordinate::chassis_rx], state.z[Coordinate::lower_arm_left],
      state.z[Coordinate::carrier_left_rz], state.z[Coordinate::carrier_left_rx],
      state.z[Coordinate::carrier_left_ry], state.z[Coordinate::upper_arm_left],
      state.z[Coordinate::arb_front_left], state.z[Coordinate::lower_arm_right],
      state.z[Coordinate::carrier_right_rz], state.z[Coordinate::carrier_right_rx],
      state.z[Coordinate::carrier_right_ry], state.z[Coordinate::upper_arm_right],
      state.z[Coordinate::arb_front_right], state.z[Coordinate::pitman_arm],
      state.z[Coordinate::bell_crank], state.z[Coordinate::rear_axle_rz],
      state.z[Coordinate::rear_axle_ry], state.z[Coordinate::rear_axle_rx],
      state.z[Coordinate::arb_rear_left], state.z[Coordinate::arb_rear_right]};
  mbgen::sincos(angles, w8.sines, w8.cosines);
  const double s1_1 = state.charts[0] - 0.5;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_y_x = w8.sines[0];
  const double s1_2 = w8.cosines[1];
  w1.R_chassis_aux5_y_x = R_chassis_aux4_y_x*s1_2;
  const double s1_3 = w8.sines[1];
  const double s1_4 = -s1_3;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux4_y_y = w8.cosines[0];
  const double s1_5 = R_chassis_aux4_y_y*s1_2;
  w1.R_chassis_x_x = (s1_1 >= 0.0 ? s1_4 : s1_5);
  const double s1_6 = w8.sines[2];
  const double s1_7 = s1_2*s1_6;
  const double s1_8 = s1_3*s1_6;
  const double s1_9 = w8.cosines[2];
  const double s1_10 = fnma(R_chassis_aux4_y_x, s1_9, R_chassis_aux4_y_y*s1_8);
  w1.R_chassis_x_y = (s1_1 >= 0.0 ? s1_7 : s1_10);
  const double s1_11 = s1_2*s1_9;
  const double s1_12 = s1_3*s1_9;
  const double s1_13 = fma(R_chassis_aux4_y_y, s1_12, R_chassis_aux4_y_x*s1_6);
  w1.R_chassis_x_z = (s1_1 >= 0.0 ? s1_11 : s1_13);
  w1.R_chassis_y_y = fma(R_chassis_aux4_y_y, s1_9, R_chassis_aux4_y_x*s1_8);
  w1.R_chassis_y_z = fnma(R_chassis_aux4_y_y, s1_6, R_chassis_aux4_y_x*s1_12);
  w1.R_chassis_z_x = (s1_1 >= 0.0 ? -s1_5 : s1_4);
  w1.R_chassis_z_y = (s1_1 >= 0.0 ? -s1_10 : s1_7);
  w1.R_chassis_z_z = (s1_1 >= 0.0 ? -s1_13 : s1_11);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = w8.sines[3];
  const double R_lower_arm_left_y_z = -R_lower_arm_left_z_y;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_14 = state.charts[1] - 0.5;
  const double R_lower_arm_left_y_y = w8.cosines[3];
  w1.R_carrier_left_aux1_z_z = (s1_14 >= 0.0 ? R_lower_arm_left_y_z : R_lower_arm_left_y_y);
  const double s1_15 = w8.sines[4];
  w1.R_carrier_left_aux1_y_x = s1_15*w1.R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_x_x = w8.cosines[4];
  const double R_carrier_left_aux1_y_y = R_carrier_left_aux1_x_x*w1.R_carrier_left_aux1_z_z;
  w1.R_carrier_left_aux1_y_z = (s1_14 >= 0.0 ? -R_lower_arm_left_y_y : R_lower_arm_left_y_z);
  const double s1_16 = (s1_14 >= 0.0 ? R_lower_arm_left_y_y : R_lower_arm_left_z_y);
  w1.R_carrier_left_aux1_z_x = s1_15*s1_16;
  const double R_carrier_left_aux1_z_y = R_carrier_left_aux1_x_x*s1_16;
  const double s1_17 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  w1.s1_18 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_17);
  w1.r_carrier_left_aux1_y = p_lower_arm_left_y + w1.s1_18;
  const double s1_19 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  w1.s1_20 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_19);
  w1.r_carrier_left_aux1_z = w1.s1_20 + p_lower_arm_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_21 = w8.cosines[5];
  w1.s1_22 = s1_15*s1_21;
  const double s1_23 = w8.sines[5];
  const double R_carrier_left_aux2_x_z = s1_15*s1_23;
  w1.R_carrier_left_aux2_y_y = fma(w1.R_carrier_left_aux1_y_z, s1_23,
      R_carrier_left_aux1_y_y*s1_21);
  const double R_carrier_left_aux2_y_z = fnma(R_carrier_left_aux1_y_y, s1_23,
      w1.R_carrier_left_aux1_y_z*s1_21);
  w1.R_carrier_left_aux2_z_y = fma(w1.R_carrier_left_aux1_z_z, s1_23,
      R_carrier_left_aux1_z_y*s1_21);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_23,
      w1.R_carrier_left_aux1_z_z*s1_21);
  const double s1_24 = w8.cosines[6];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = w8.sines[6];
  w1.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_25, R_carrier_left_aux1_x_x*s1_24);
  w1.R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_25, R_carrier_left_aux2_x_z*s1_24);
  w1.R_carrier_left_y_x = fnma(R_carrier_left_aux2_y_z, s1_25, w1.R_carrier_left_aux1_y_x*s1_24);
  w1.R_carrier_left_y_z = fma(w1.R_carrier_left_aux1_y_x, s1_25, R_carrier_left_aux2_y_z*s1_24);
  w1.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_25, w1.R_carrier_left_aux1_z_x*s1_24);
  w1.R_carrier_left_z_z = fma(w1.R_carrier_left_aux1_z_x, s1_25, R_carrier_left_aux2_z_z*s1_24);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = w8.sines[9];
  const double R_lower_arm_right_y_z = -R_lower_arm_right_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_26 = state.charts[2] - 0.5;
  const double R_lower_arm_right_y_y = w8.cosines[9];
  w1.R_carrier_right_aux1_z_z = (s1_26 >= 0.0 ? R_lower_arm_right_y_z : R_lower_arm_right_y_y);
  const double s1_27 = w8.sines[10];
  w1.R_carrier_right_aux1_y_x = s1_27*w1.R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_x_x = w8.cosines[10];
  const double R_carrier_right_aux1_y_y = R_carrier_right_aux1_x_x*w1.R_carrier_right_aux1_z_z;
  w1.R_carrier_right_aux1_y_z = (s1_26 >= 0.0 ? -R_lower_arm_right_y_y : R_lower_arm_right_y_z);
  const double s1_28 = (s1_26 >= 0.0 ? R_lower_arm_right_y_y : R_lower_arm_right_z_y);
  w1.R_carrier_right_aux1_z_x = s1_27*s1_28;
  const double R_carrier_right_aux1_z_y = R_carrier_right_aux1_x_x*s1_28;
  const double s1_29 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  w1.s1_30 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_29);
  w1.r_carrier_right_aux1_y = w1.s1_30 + p_lower_arm_right_y;
  const double s1_31 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  w1.s1_32 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_31);
  w1.s1_33 = w1.s1_32 - p_lower_arm_right_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_34 = w8.cosines[11];
  w1.s1_35 = s1_27*s1_34;
  const double s1_36 = w8.sines[11];
  const double R_carrier_right_aux2_x_z = s1_27*s1_36;
  w1.R_carrier_right_aux2_y_y = fma(w1.R_carrier_right_aux1_y_z, s1_36,
      R_carrier_right_aux1_y_y*s1_34);
  const double R_carrier_right_aux2_y_z = fnma(R_carrier_right_aux1_y_y, s1_36,
      w1.R_carrier_right_aux1_y_z*s1_34);
  w1.R_carrier_right_aux2_z_y = fma(w1.R_carrier_right_aux1_z_z, s1_36,
      R_carrier_right_aux1_z_y*s1_34);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_36,
      w1.R_carrier_right_aux1_z_z*s1_34);
  const double s1_37 = w8.cosines[12];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_38 = w8.sines[12];
  w1.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_38, R_carrier_right_aux1_x_x*s1_37);
  w1.R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_38, R_carrier_right_aux2_x_z*s1_37);
  w1.R_carrier_right_y_x = fnma(R_carrier_right_aux2_y_z, s1_38, w1.R_carrier_right_aux1_y_x*s1_37);
  w1.R_carrier_right_y_z = fma(w1.R_carrier_right_aux1_y_x, s1_38, R_carrier_right_aux2_y_z*s1_37);
  w1.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_38, w1.R_carrier_right_aux1_z_x*s1_37);
  w1.R_carrier_right_z_z = fma(w1.R_carrier_right_aux1_z_x, s1_38, R_carrier_right_aux2_z_z*s1_37);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  w1.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  w1.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] + p_rear_axle_tx_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s1_39 = state.charts[3] - 0.5;
  w1.R_rear_axle_aux4_z_z = (s1_39 >= 0.0 ? 0.0 : 1.0);
  const double R_rear_axle_aux4_y_y = w8.cosines[17];
  const double R_rear_axle_aux4_x_x = R_rear_axle_aux4_y_y*w1.R_rear_axle_aux4_z_z;
  const double R_rear_axle_aux4_y_x = w8.sines[17];
  w1.s1_40 = w1.R_rear_axle_aux4_z_z*R_rear_axle_aux4_y_x;
  w1.R_rear_axle_aux4_x_z = (s1_39 >= 0.0 ? 1.0 : 0.0);
  const double s1_41 = (s1_39 >= 0.0 ? -1.0 : 0.0);
  const double R_rear_axle_aux4_z_x = R_rear_axle_aux4_y_y*s1_41;
  w1.s1_42 = R_rear_axle_aux4_y_x*s1_41;
  const double s1_43 = w8.cosines[18];
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s1_44 = w8.sines[18];
  w1.R_rear_axle_aux5_x_x = fnma(w1.R_rear_axle_aux4_x_z, s1_44, R_rear_axle_aux4_x_x*s1_43);
  const double R_rear_axle_aux5_x_z = fma(R_rear_axle_aux4_x_x, s1_44,
      w1.R_rear_axle_aux4_x_z*s1_43);
  w1.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*s1_43;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_44;
  w1.R_rear_axle_aux5_z_x = fnma(w1.R_rear_axle_aux4_z_z, s1_44, R_rear_axle_aux4_z_x*s1_43);
  const double R_rear_axle_aux5_z_z = fma(R_rear_axle_aux4_z_x, s1_44,
      w1.R_rear_axle_aux4_z_z*s1_43);
  const double s1_45 = w8.sines[19];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_46 = w8.cosines[19];
  w1.R_rear_axle_x_y = fnma(w1.s1_40, s1_46, R_rear_axle_aux5_x_z*s1_45);
  w1.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_46, w1.s1_40*s1_45);
  w1.R_rear_axle_y_y = fma(R_rear_axle_aux4_y_y, s1_46, R_rear_axle_aux5_y_z*s1_45);
  w1.R_rear_axle_y_z = fnma(R_rear_axle_aux4_y_y, s1_45, R_rear_axle_aux5_y_z*s1_46);
  w1.R_rear_axle_z_y = fnma(w1.s1_42, s1_46, R_rear_axle_aux5_z_z*s1_45);
  w1.R_rear_axle_z_z = fma(R_rear_axle_aux5_z_z, s1_46, w1.s1_42*s1_45);

  // --- step 4: velocities ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  w1.s4_1 = zd_chassis_rz*s1_3;
  w1.w_chassis_x = state.zd[Coordinate::chassis_rx] - w1.s4_1;
  w1.s4_2 = zd_chassis_rz*s1_7;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  w1.s4_3 = zd_chassis_ry*s1_9;
  w1.w_chassis_y = w1.s4_2 + w1.s4_3;
  w1.s4_4 = zd_chassis_rz*s1_11;
  w1.s4_5 = zd_chassis_ry*s1_6;
  w1.w_chassis_z = w1.s4_4 - w1.s4_5;
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  w1.s4_6 = zd_carrier_left_rz*w1.R_carrier_left_aux1_y_z;
  w1.s4_7 = zd_carrier_left_rz*w1.R_carrier_left_aux1_z_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  w1.s4_8 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  w1.s4_9 = zd_carrier_left_rx*w1.R_carrier_left_aux1_y_x;
  w1.s4_10 = zd_carrier_left_rx*w1.R_carrier_left_aux1_z_x;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  w1.s4_11 = zd_carrier_left_ry*w1.s1_22;
  w1.s4_12 = zd_carrier_left_ry*w1.R_carrier_left_aux2_y_y;
  w1.s4_13 = zd_carrier_left_ry*w1.R_carrier_left_aux2_z_y;
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  w1.s4_14 = zd_carrier_right_rz*w1.R_carrier_right_aux1_y_z;
  w1.s4_15 = zd_carrier_right_rz*w1.R_carrier_right_aux1_z_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  w1.s4_16 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  w1.s4_17 = zd_carrier_right_rx*w1.R_carrier_right_aux1_y_x;
  w1.s4_18 = zd_carrier_right_rx*w1.R_carrier_right_aux1_z_x;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  w1.s4_19 = zd_carrier_right_ry*w1.s1_35;
  w1.s4_20 = zd_carrier_right_ry*w1.R_carrier_right_aux2_y_y;
  w1.s4_21 = zd_carrier_right_ry*w1.R_carrier_right_aux2_z_y;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  w1.s4_22 = zd_rear_axle_rz*w1.R_rear_axle_aux4_x_z;
  w1.s4_23 = zd_rear_axle_rz*w1.R_rear_axle_aux4_z_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double s4_24 = zd_rear_axle_ry*w1.s1_40;
  w1.s4_25 = zd_rear_axle_ry*R_rear_axle_aux4_y_y;
  const double s4_26 = zd_rear_axle_ry*w1.s1_42;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s4_27 = zd_rear_axle_rx*w1.R_rear_axle_aux5_x_x;
  const double s4_28 = zd_rear_axle_rx*w1.R_rear_axle_aux5_y_x;
  const double s4_29 = zd_rear_axle_rx*w1.R_rear_axle_aux5_z_x;

  // --- step 1: poses and axes b, continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s1_47 = 1.0/s1_2;
  w1.s1_48 = s1_6*s1_47;
  w1.s1_49 = s1_9*s1_47;
  w1.s1_50 = s1_8*s1_47;
  w1.s1_51 = s1_12*s1_47;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_52 = w1.R_carrier_left_aux1_z_x*w1.s1_22;
  const double s1_53 = fma(R_carrier_left_aux1_x_x, w1.R_carrier_left_aux2_z_y, s1_52);
  const double s1_54 = w1.R_carrier_left_aux1_y_x*w1.s1_22;
  const double s1_55 = fma(R_carrier_left_aux1_x_x, w1.R_carrier_left_aux2_y_y, s1_54);
  const double s1_56 = w1.R_carrier_left_aux1_z_z*s1_55;
  const double s1_57 = 1.0/fnma(w1.R_carrier_left_aux1_y_z, s1_53, s1_56);
  w1.s1_58 = R_carrier_left_aux1_y_y*s1_57;
  w1.s1_59 = s1_55*s1_57;
  const double s1_60 = w1.R_carrier_left_aux1_y_z*w1.R_carrier_left_aux1_z_x;
  const double s1_61 = fnma(w1.R_carrier_left_aux1_z_z, w1.R_carrier_left_aux1_y_x, s1_60);
  const double s1_62 = s1_57*s1_61;
  const double s1_63 = w1.R_carrier_left_aux1_y_x*w1.R_carrier_left_aux2_z_y;
  const double s1_64 = fnma(w1.R_carrier_left_aux1_z_x, w1.R_carrier_left_aux2_y_y, s1_63);
  const double s1_65 = s1_57*s1_64;
  w1.s1_66 = R_carrier_left_aux1_x_x*w1.R_carrier_left_aux1_y_z*s1_57;
  w1.s1_67 = s1_53*s1_57;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_68 = w1.R_carrier_right_aux1_z_x*w1.s1_35;
  const double s1_69 = fma(R_carrier_right_aux1_x_x, w1.R_carrier_right_aux2_z_y, s1_68);
  const double s1_70 = w1.R_carrier_right_aux1_y_x*w1.s1_35;
  const double s1_71 = fma(R_carrier_right_aux1_x_x, w1.R_carrier_right_aux2_y_y, s1_70);
  const double s1_72 = w1.R_carrier_right_aux1_z_z*s1_71;
  const double s1_73 = 1.0/fnma(w1.R_carrier_right_aux1_y_z, s1_69, s1_72);
  w1.s1_74 = R_carrier_right_aux1_y_y*s1_73;
  w1.s1_75 = s1_71*s1_73;
  const double s1_76 = w1.R_carrier_right_aux1_y_z*w1.R_carrier_right_aux1_z_x;
  const double s1_77 = fnma(w1.R_carrier_right_aux1_z_z, w1.R_carrier_right_aux1_y_x, s1_76);
  const double s1_78 = s1_73*s1_77;
  const double s1_79 = w1.R_carrier_right_aux1_y_x*w1.R_carrier_right_aux2_z_y;
  const double s1_80 = fnma(w1.R_carrier_right_aux1_z_x, w1.R_carrier_right_aux2_y_y, s1_79);
  const double s1_81 = s1_73*s1_80;
  w1.s1_82 = R_carrier_right_aux1_x_x*w1.R_carrier_right_aux1_y_z*s1_73;
  w1.s1_83 = s1_69*s1_73;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_84 = R_rear_axle_aux4_y_y*w1.R_rear_axle_aux5_x_x;
  const double s1_85 = fma(w1.s1_40, w1.R_rear_axle_aux5_y_x, s1_84);
  const double s1_86 = w1.s1_42*w1.R_rear_axle_aux5_y_x;
  const double s1_87 = fma(R_rear_axle_aux4_y_y, w1.R_rear_axle_aux5_z_x, s1_86);
  const double s1_88 = 1.0/fnma(w1.R_rear_axle_aux4_z_z, s1_85, w1.R_rear_axle_aux4_x_z*s1_87);
  w1.s1_89 = R_rear_axle_aux4_y_y*w1.R_rear_axle_aux4_x_z*s1_88;
  w1.s1_90 = s1_87*s1_88;
  const double s1_91 = w1.R_rear_axle_aux4_x_z*w1.s1_42;
  w1.s1_92 = s1_88*fnma(w1.R_rear_axle_aux4_z_z, w1.s1_40, s1_91);
  const double s1_93 = w1.s1_40*w1.R_rear_axle_aux5_z_x;
  w1.s1_94 = s1_88*fnma(w1.s1_42, w1.R_rear_axle_aux5_x_x, s1_93);
  w1.s1_95 = R_rear_axle_aux4_x_x*s1_88;
  w1.s1_96 = s1_85*s1_88;
  // operations: 63 add, 155 multiply, 4 divide, 44 sin cos, 15 other

  // --- step 4: velocities, continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  w1.s4_30 = w1.s4_7 + w1.s4_10;
  w1.s4_31 = w1.s4_13 + w1.s4_30;
  w1.s4_32 = w1.s4_6 + w1.s4_9;
  w1.s4_33 = w1.s4_12 + w1.s4_32;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  w1.s4_34 = w1.s4_15 + w1.s4_18;
  w1.s4_35 = w1.s4_21 + w1.s4_34;
  w1.s4_36 = w1.s4_14 + w1.s4_17;
  w1.s4_37 = w1.s4_20 + w1.s4_36;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  w1.s4_38 = w1.s4_25 + s4_28;
  const double s4_39 = w1.s4_23 - s4_26;
  w1.s4_40 = s4_29 + s4_39;
  const double s4_41 = w1.s4_22 - s4_24;
  w1.s4_42 = s4_27 + s4_41;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  w1.s4_43 = zd_lower_arm_left + w1.s4_8;
  w1.s4_44 = w1.s4_43 - w1.s4_11;
  w1.s4_45 = zd_lower_arm_left*w1.s1_18;
  w1.s4_46 = zd_lower_arm_left*w1.s1_20;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  w1.s4_47 = zd_lower_arm_right + w1.s4_16;
  w1.s4_48 = w1.s4_47 - w1.s4_19;
  w1.s4_49 = zd_lower_arm_right*w1.s1_30;
  w1.s4_50 = zd_lower_arm_right*w1.s1_32;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  w1.w_carrier_left_x = w1.w_chassis_x + w1.s4_44;
  w1.w_carrier_left_y = w1.w_chassis_y + w1.s4_33;
  w1.w_carrier_left_z = w1.w_chassis_z + w1.s4_31;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  w1.w_carrier_right_x = w1.w_chassis_x + w1.s4_48;
  w1.w_carrier_right_y = w1.w_chassis_y + w1.s4_37;
  w1.w_carrier_right_z = w1.w_chassis_z + w1.s4_35;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double w_rear_axle_x = w1.w_chassis_x + w1.s4_42;
  const double w_rear_axle_y = w1.w_chassis_y + w1.s4_38;
  const double w_rear_axle_z = w1.w_chassis_z + w1.s4_40;
  // operations: 29 add, 33 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  const double s7_1 = R_carrier_left_aux1_x_x*tau[Coordinate::carrier_left_rx];
  const double s7_2 = fma(tau[Coordinate::carrier_left_ry], s1_62, s7_1);
  w2.s7_3 = fma(tau[Coordinate::carrier_left_rz], s1_65, s7_2);
  const double s7_4 = R_carrier_right_aux1_x_x*tau[Coordinate::carrier_right_rx];
  const double s7_5 = fma(tau[Coordinate::carrier_right_ry], s1_78, s7_4);
  w2.s7_6 = fma(tau[Coordinate::carrier_right_rz], s1_81, s7_5);
  // operations: 4 add, 6 multiply

  // --- step 8: elimination from the leaves to the root (63) ---
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s8_1 = w1.R_rear_axle_x_y*w_rear_axle_z;
  const double s8_2 = fnma(w1.R_rear_axle_z_y, w_rear_axle_x, s8_1);
  const double s8_3 = fma(w1.R_rear_axle_y_y, w_rear_axle_y, w1.R_rear_axle_x_y*w_rear_axle_x);
  const double s8_4 = fma(w1.R_rear_axle_z_y, w_rear_axle_z, s8_3);
  const double s8_5 = state.zd[Coordinate::wheel_rear_right] + s8_4;
  const double s8_6 = w1.R_rear_axle_z_y*w_rear_axle_y;
  const double s8_7 = fnma(w1.R_rear_axle_y_y, w_rear_axle_z, s8_6);
  const double s8_8 = w1.R_rear_axle_y_y*w_rear_axle_x;
  const double s8_9 = fnma(w1.R_rear_axle_x_y, w_rear_axle_y, s8_8);
  const double s8_10 = state.zd[Coordinate::wheel_rear_left] + s8_4;

  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  const double s3_1 = R_rear_axle_aux4_y_y*projection.Rz[50];
  w2.s3_2 = fma(w1.R_rear_axle_aux5_y_x, projection.Rz[52], s3_1);
  const double s3_3 = R_rear_axle_aux4_y_y*projection.Rz[51];
  w2.s3_4 = fma(w1.R_rear_axle_aux5_y_x, projection.Rz[53], s3_3);
  const double s3_5 = w1.R_rear_axle_aux4_z_z*projection.Rz[48];
  const double s3_6 = fnma(w1.s1_42, projection.Rz[50], s3_5);
  w2.s3_7 = fma(w1.R_rear_axle_aux5_z_x, projection.Rz[52], s3_6);
  const double s3_8 = w1.R_rear_axle_aux4_z_z*projection.Rz[49];
  const double s3_9 = fnma(w1.s1_42, projection.Rz[51], s3_8);
  w2.s3_10 = fma(w1.R_rear_axle_aux5_z_x, projection.Rz[53], s3_9);
  const double s3_11 = w1.R_rear_axle_aux4_x_z*projection.Rz[48];
  const double s3_12 = fnma(w1.s1_40, projection.Rz[50], s3_11);
  w2.s3_13 = fma(w1.R_rear_axle_aux5_x_x, projection.Rz[52], s3_12);
  const double s3_14 = w1.R_rear_axle_aux4_x_z*projection.Rz[49];
  const double s3_15 = fnma(w1.s1_40, projection.Rz[51], s3_14);
  w2.s3_16 = fma(w1.R_rear_axle_aux5_x_x, projection.Rz[53], s3_15);
  // operations: 10 add, 16 multiply

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right ---
  w2.s6_1 = fnma(s4_28, s4_39, w1.s4_25*s4_29);
  const double s6_2 = w1.R_rear_axle_aux4_x_z*projection.zdd_star[17];
  const double s6_3 = fnma(w1.s1_40, projection.zdd_star[18], s6_2);
  const double s6_4 = fma(w1.R_rear_axle_aux5_x_x, projection.zdd_star[19], s6_3);
  w2.s6_5 = w2.s6_1 + fnma(w1.s4_23, w1.s4_25, s6_4);
  w2.s6_6 = fnma(w1.s4_25, s4_27, s4_28*s4_41);
  const double s6_7 = w1.R_rear_axle_aux4_z_z*projection.zdd_star[17];
  const double s6_8 = fnma(w1.s1_42, projection.zdd_star[18], s6_7);
  const double s6_9 = w2.s6_6 + fma(w1.R_rear_axle_aux5_z_x, projection.zdd_star[19], s6_8);
  w2.s6_10 = fma(w1.s4_22, w1.s4_25, s6_9);
  w2.s6_11 = fnma(s4_29, s4_41, s4_27*s4_39);
  w2.s6_12 = fnma(w1.s4_23, s4_24, w1.s4_22*s4_26);
  const double s6_13 = R_rear_axle_aux4_y_y*projection.zdd_star[18];
  const double s6_14 = w2.s6_11 + fma(w1.R_rear_axle_aux5_y_x, projection.zdd_star[19], s6_13);
  w2.s6_15 = w2.s6_12 + s6_14;
  // operations: 15 add, 18 multiply

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_7 = h_rear_axle_x*w1.R_rear_axle_aux5_y_x;
  w2.s7_8 = fma(h_rear_axle_z, w1.R_rear_axle_y_z, s7_7);
  const double s7_9 = h_rear_axle_x*w1.R_rear_axle_aux5_z_x;
  w2.s7_10 = fma(h_rear_axle_z, w1.R_rear_axle_z_z, s7_9);
  const double s7_11 = h_rear_axle_x*w1.R_rear_axle_aux5_x_x;
  w2.s7_12 = fma(h_rear_axle_z, w1.R_rear_axle_x_z, s7_11);
  const double s7_13 = K_rear_axle_yy*w1.R_rear_axle_x_y;
  const double s7_14 = K_rear_axle_xx*w1.R_rear_axle_aux5_x_x;
  const double s7_15 = fma(K_rear_axle_xz, w1.R_rear_axle_x_z, s7_14);
  const double s7_16 = K_rear_axle_xz*w1.R_rear_axle_aux5_x_x;
  const double s7_17 = fma(K_rear_axle_zz, w1.R_rear_axle_x_z, s7_16);
  const double s7_18 = fma(w1.R_rear_axle_aux5_y_x, s7_15, w1.R_rear_axle_y_y*s7_13);
  w2.s7_19 = fma(w1.R_rear_axle_y_z, s7_17, s7_18);
  const double s7_20 = K_rear_axle_yy*w1.R_rear_axle_y_y;
  const double s7_21 = K_rear_axle_xx*w1.R_rear_axle_aux5_y_x;
  const double s7_22 = fma(K_rear_axle_xz, w1.R_rear_axle_y_z, s7_21);
  const double s7_23 = K_rear_axle_xz*w1.R_rear_axle_aux5_y_x;
  const double s7_24 = fma(K_rear_axle_zz, w1.R_rear_axle_y_z, s7_23);
  const double s7_25 = fma(w1.R_rear_axle_aux5_z_x, s7_22, w1.R_rear_axle_z_y*s7_20);
  w2.s7_26 = fma(w1.R_rear_axle_z_z, s7_24, s7_25);
  const double s7_27 = fma(w1.R_rear_axle_aux5_z_x, s7_15, w1.R_rear_axle_z_y*s7_13);
  w2.s7_28 = fma(w1.R_rear_axle_z_z, s7_17, s7_27);
  const double s7_29 = fma(w1.R_rear_axle_aux5_x_x, s7_15, w1.R_rear_axle_x_y*s7_13);
  w2.s7_30 = fma(w1.R_rear_axle_x_z, s7_17, s7_29);
  w2.s7_31 = K_rear_axle_trace - w2.s7_30;
  const double s7_32 = fma(w1.R_rear_axle_aux5_y_x, s7_22, w1.R_rear_axle_y_y*s7_20);
  w2.s7_33 = fma(w1.R_rear_axle_y_z, s7_24, s7_32);
  w2.s7_34 = w2.s7_31 - w2.s7_33;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_x = w8.cosines[20];
  w2.s7_35 = K_arb_rear_left_xy*R_arb_rear_left_x_x;
  w2.s7_36 = h_arb_rear_left_x*R_arb_rear_left_x_x;
  const double R_arb_rear_left_x_z = w8.sines[20];
  w2.s7_37 = K_arb_rear_left_xy*R_arb_rear_left_x_z;
  w2.s7_38 = h_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_39 = K_arb_rear_left_zz*R_arb_rear_left_x_z;
  const double s7_40 = K_arb_rear_left_xx*R_arb_rear_left_x_x;
  w2.s7_41 = fnma(R_arb_rear_left_x_z, s7_40, R_arb_rear_left_x_x*s7_39);
  w2.s7_42 = fma(R_arb_rear_left_x_x, s7_40, R_arb_rear_left_x_z*s7_39);
  w2.s7_43 = 0.4225 - w2.s7_42;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_z = w8.sines[21];
  w2.s7_44 = -K_arb_rear_right_xy*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = w8.cosines[21];
  w2.s7_45 = h_arb_rear_right_x*R_arb_rear_right_x_x;
  w2.s7_46 = h_arb_rear_right_x*R_arb_rear_right_x_z;
  w2.s7_47 = -K_arb_rear_right_xy*R_arb_rear_right_x_x;
  const double s7_48 = K_arb_rear_right_zz*R_arb_rear_right_x_z;
  const double s7_49 = K_arb_rear_right_xx*R_arb_rear_right_x_x;
  w2.s7_50 = fnma(R_arb_rear_right_x_z, s7_49, R_arb_rear_right_x_x*s7_48);
  w2.s7_51 = fma(R_arb_rear_right_x_x, s7_49, R_arb_rear_right_x_z*s7_48);
  w2.s7_52 = 0.4225 - w2.s7_51;
  // operations: 25 add, 51 multiply

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right
  // ---
  w2.s8_11 = w1.w_chassis_y + w1.w_chassis_y;
  w2.s8_12 = w1.w_chassis_x + w1.w_chassis_x;
  w2.s8_13 = w1.w_chassis_z + w1.w_chassis_z;
  w2.s8_14 = w1.w_chassis_x*w1.w_chassis_y;
  w2.s8_15 = w1.w_chassis_y*w1.w_chassis_z;
  w2.s8_16 = w1.w_chassis_x*w1.w_chassis_z;
  const double s8_17 = w1.w_chassis_y*w1.w_chassis_y;
  const double s8_18 = w1.w_chassis_x*w1.w_chassis_x;
  w2.s8_19 = s8_17 + s8_18;
  w2.s8_20 = fma(w1.w_chassis_z, w1.w_chassis_z, s8_17);
  w2.s8_21 = fma(w1.w_chassis_z, w1.w_chassis_z, s8_18);
  // arb_rear_right: arb_rear_right, revolute, chassis
  w2.s8_22 = projection.Rz[56]*w2.s7_46;
  w2.s8_23 = projection.Rz[56]*w2.s7_45;
  w2.s8_24 = projection.Rz[57]*w2.s7_46;
  w2.s8_25 = projection.Rz[57]*w2.s7_45;
  w2.s8_26 = 0.4225*projection.Rz[56];
  w2.s8_27 = 0.4225*projection.Rz[57];
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  w2.s8_28 = zd_arb_rear_right*(zd_arb_rear_right + w2.s8_11);
  w2.s8_29 = 2.025 + w2.s7_46;
  w2.s8_30 = zd_arb_rear_right*w2.s8_13;
  w2.s8_31 = w2.s8_20 - w2.s8_21;
  w2.s8_32 = w2.s7_45 - 14.85;
  w2.s8_33 = fma(w2.s7_45, w2.s8_28, projection.zdd_star[21]*w2.s7_46);
  w2.s8_34 = zd_arb_rear_right*w2.s8_12;
  w2.s8_35 = fnma(w2.s7_46, w2.s8_30, w2.s7_45*w2.s8_34);
  const double s8_36 = fma(p_arb_rear_right_z, w2.s8_16, -p_arb_rear_right_x*w2.s8_20);
  w2.s8_37 = fma(p_arb_rear_right_y, w2.s8_14, s8_36);
  w2.s8_38 = fnma(projection.zdd_star[21], w2.s7_45, w2.s7_46*w2.s8_28);
  const double s8_39 = fma(p_arb_rear_right_x, w2.s8_16, -p_arb_rear_right_z*w2.s8_19);
  w2.s8_40 = fma(p_arb_rear_right_y, w2.s8_15, s8_39);
  w2.s8_41 = w2.s8_21 - w2.s8_19;
  w2.s8_42 = w2.s8_19 - w2.s8_20;
  w2.s8_43 = w2.s7_52 - w2.s7_51;
  // arb_rear_left: arb_rear_left, revolute, chassis
  w2.s8_44 = 2.025 + w2.s7_38;
  w2.s8_45 = 0.4225*projection.Rz[54];
  w2.s8_46 = 0.4225*projection.Rz[55];
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  w2.s8_47 = zd_arb_rear_left*(zd_arb_rear_left + w2.s8_11);
  w2.s8_48 = w2.s7_36 - 14.85;
  w2.s8_49 = fnma(p_arb_rear_right_y, w2.s8_14, s8_36);
  w2.s8_50 = zd_arb_rear_left*w2.s8_13;
  w2.s8_51 = zd_arb_rear_left*w2.s8_12;
  w2.s8_52 = fnma(w2.s7_38, w2.s8_50, w2.s7_36*w2.s8_51);
  w2.s8_53 = fnma(p_arb_rear_right_y, w2.s8_15, s8_39);
  w2.s8_54 = fnma(projection.zdd_star[20], w2.s7_36, w2.s7_38*w2.s8_47);
  w2.s8_55 = fma(w2.s7_36, w2.s8_47, projection.zdd_star[20]*w2.s7_38);
  w2.s8_56 = w2.s7_43 - w2.s7_42;
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_57 = fma(zd_rear_axle_tz, w2.s8_11, projection.zdd_star[14]);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_58 = fma(z_rear_axle_ty, w2.s8_14, fnma(zd_rear_axle_ty, w2.s8_13, s8_57));
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_59 = fma(w1.r_rear_axle_aux3_z, w2.s8_16, s8_58);
  const double s8_60 = fnma(w1.r_rear_axle_aux1_x, w2.s8_20, s8_59);
  w2.s8_61 = fnma(w1.w_chassis_y, w1.s4_42, w1.w_chassis_x*w1.s4_38);
  const double s8_62 = w2.s6_10 + w2.s8_61;
  const double s8_63 = fms(w_rear_axle_x, w_rear_axle_y, s8_62);
  w2.s8_64 = fnma(w1.w_chassis_x, w1.s4_40, w1.w_chassis_z*w1.s4_42);
  const double s8_65 = w2.s6_15 + w2.s8_64;
  const double s8_66 = fma(w_rear_axle_x, w_rear_axle_z, s8_65);
  const double s8_67 = w_rear_axle_y*w_rear_axle_y;
  const double s8_68 = w_rear_axle_z*w_rear_axle_z;
  const double s8_69 = s8_67 + s8_68;
  const double s8_70 = fma(w2.s7_10, s8_66, fma(w2.s7_8, s8_63, m_rear_axle*s8_60));
  w2.f_rear_axle_x = fnma(w2.s7_12, s8_69, s8_70);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s8_71 = fnma(zd_rear_axle_tz, w2.s8_12, projection.zdd_star[15]);
  const double s8_72 = fma(zd_rear_axle_tx, w2.s8_13, s8_71);
  const double s8_73 = fma(w1.r_rear_axle_aux1_x, w2.s8_14, s8_72);
  const double s8_74 = fma(w1.r_rear_axle_aux3_z, w2.s8_15, s8_73);
  const double s8_75 = fnma(z_rear_axle_ty, w2.s8_21, s8_74);
  w2.s8_76 = fnma(w1.w_chassis_z, w1.s4_38, w1.w_chassis_y*w1.s4_40);
  const double s8_77 = w2.s6_5 + w2.s8_76;
  const double s8_78 = fms(w_rear_axle_y, w_rear_axle_z, s8_77);
  const double s8_79 = fma(w_rear_axle_x, w_rear_axle_y, s8_62);
  const double s8_80 = fma(w_rear_axle_x, w_rear_axle_x, s8_68);
  const double s8_81 = fma(w2.s7_12, s8_79, fma(w2.s7_10, s8_78, m_rear_axle*s8_75));
  w2.f_rear_axle_y = fnma(w2.s7_8, s8_80, s8_81);
  const double s8_82 = fnma(zd_rear_axle_tx, w2.s8_11, projection.zdd_star[16]);
  const double s8_83 = fma(z_rear_axle_ty, w2.s8_15, fma(zd_rear_axle_ty, w2.s8_12, s8_82));
  const double s8_84 = fma(w1.r_rear_axle_aux1_x, w2.s8_16, s8_83);
  const double s8_85 = fnma(w1.r_rear_axle_aux3_z, w2.s8_19, s8_84);
  const double s8_86 = fma(w_rear_axle_y, w_rear_axle_z, s8_77);
  const double s8_87 = fms(w_rear_axle_x, w_rear_axle_z, s8_65);
  const double s8_88 = fma(w_rear_axle_x, w_rear_axle_x, s8_67);
  const double s8_89 = fma(w2.s7_12, s8_87, fma(w2.s7_8, s8_86, m_rear_axle*s8_85));
  w2.f_rear_axle_z = fnma(w2.s7_10, s8_88, s8_89);
  const double s8_90 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_91 = I_wheel_rear_right_polar*(s8_5 + s8_10);
  const double s8_92 = fnma(w2.s7_34, s8_78, fnma(w2.s7_10, s8_75, w2.s7_8*s8_85));
  const double s8_93 = fma(w2.s7_19, s8_87, fma(w2.s7_33, s8_86, fnma(w2.s7_28, s8_79, s8_92)));
  const double s8_94 = fma(w1.R_rear_axle_x_y, s8_90, fma(w2.s7_26, s8_80 - s8_88, s8_93));
  w2.n_rear_axle_x = fma(s8_7, s8_91, s8_94);
  const double s8_95 = fma(w2.s7_34, s8_66, fma(w2.s7_26, s8_63, w2.s7_10*s8_60));
  const double s8_96 = fnma(w2.s7_19, s8_86, fnma(w2.s7_12, s8_85, s8_95));
  const double s8_97 = fma(w1.R_rear_axle_y_y, s8_90, fnma(w2.s7_30, s8_87, s8_96));
  w2.n_rear_axle_y = fma(w2.s7_28, s8_88 - s8_69, fma(s8_2, s8_91, s8_97));
  const double s8_98 = fnma(w2.s7_33, s8_63, fnma(w2.s7_8, s8_60, w2.s7_12*s8_75));
  const double s8_99 = fma(w2.s7_30, s8_79, fma(w2.s7_28, s8_78, fnma(w2.s7_26, s8_66, s8_98)));
  const double s8_100 = fma(s8_9, s8_91, fma(w1.R_rear_axle_z_y, s8_90, s8_99));
  w2.n_rear_axle_z = fma(w2.s7_19, s8_69 - s8_80, s8_100);
}

/// Part 2 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_chosen_accelerations_2(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork1& __restrict w1,
    ChosenAccelerationsWork2& __restrict w2, ChosenAccelerationsWork3& __restrict w3,
    ChosenAccelerationsWork8& __restrict w8, ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_101 = K_rear_axle_trace - w2.s7_33;
  const double s8_102 = K_rear_axle_trace - w2.s7_34;
  const double s8_103 = fnma(w2.s3_7, w2.s7_8, m_rear_axle*projection.Rz[42]);
  const double s8_104 = fma(w2.s3_2, w2.s7_10, s8_103);
  const double s8_105 = fnma(w2.s3_10, w2.s7_8, m_rear_axle*projection.Rz[43]);
  const double s8_106 = fma(w2.s3_4, w2.s7_10, s8_105);
  w2.s8_107 = fnma(projection.Rz[55], w2.s7_38, s8_106 - w2.s8_24);
  const double s8_108 = fma(w2.s3_13, w2.s7_8, m_rear_axle*projection.Rz[46]);
  const double s8_109 = fnma(w2.s3_2, w2.s7_12, s8_108);
  const double s8_110 = fma(w2.s3_16, w2.s7_8, m_rear_axle*projection.Rz[47]);
  const double s8_111 = fnma(w2.s3_4, w2.s7_12, s8_110);
  w2.s8_112 = fnma(projection.Rz[55], w2.s7_36, s8_111 - w2.s8_25);
  w2.s8_113 = fma(593.0, w1.r_rear_axle_aux1_x, w2.s7_12);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  w2.s8_114 = fma(593.0, z_rear_axle_ty, w2.s7_8);
  w2.s8_115 = fma(593.0, w1.r_rear_axle_aux3_z, w2.s7_10);
  const double s8_116 = fnma(projection.Rz[44], w2.s7_10, projection.Rz[46]*w2.s7_8);
  const double s8_117 = fnma(w2.s3_7, w2.s7_28, fnma(w2.s3_2, w2.s7_19, s8_116));
  const double s8_118 = fma(w2.s3_13, w2.s7_31, s8_117);
  const double s8_119 = fnma(w2.s3_13, w2.s7_10, m_rear_axle*projection.Rz[44]);
  const double s8_120 = fma(w2.s3_7, w2.s7_12, s8_119);
  const double s8_121 = fnma(projection.Rz[45], w2.s7_10, projection.Rz[47]*w2.s7_8);
  const double s8_122 = fnma(w2.s3_10, w2.s7_28, fnma(w2.s3_4, w2.s7_19, s8_121));
  const double s8_123 = fma(w2.s3_16, w2.s7_31, s8_122);
  const double s8_124 = fnma(w2.s3_16, w2.s7_10, m_rear_axle*projection.Rz[45]);
  w2.s8_125 = fma(w2.s3_10, w2.s7_12, s8_124);
  const double s8_126 = fnma(projection.Rz[42], w2.s7_8, projection.Rz[44]*w2.s7_12);
  const double s8_127 = fnma(w2.s3_13, w2.s7_28, fnma(w2.s3_2, w2.s7_26, s8_126));
  const double s8_128 = fma(w2.s3_7, s8_102, s8_127);
  const double s8_129 = fnma(projection.Rz[43], w2.s7_8, projection.Rz[45]*w2.s7_12);
  const double s8_130 = fnma(w2.s3_16, w2.s7_28, fnma(w2.s3_4, w2.s7_26, s8_129));
  const double s8_131 = fma(w2.s3_10, s8_102, s8_130);
  const double s8_132 = fnma(projection.Rz[46], w2.s7_12, projection.Rz[42]*w2.s7_10);
  const double s8_133 = fnma(w2.s3_7, w2.s7_26, fnma(w2.s3_13, w2.s7_19, s8_132));
  const double s8_134 = fma(w2.s3_2, s8_101, s8_133);
  const double s8_135 = fnma(projection.Rz[47], w2.s7_12, projection.Rz[43]*w2.s7_10);
  const double s8_136 = fnma(w2.s3_10, w2.s7_26, fnma(w2.s3_16, w2.s7_19, s8_135));
  const double s8_137 = fma(w2.s3_4, s8_101, s8_136);
  w2.s8_138 = w1.r_rear_axle_aux3_z + w1.r_rear_axle_aux3_z;
  w2.s8_139 = z_rear_axle_ty + z_rear_axle_ty;
  w2.s8_140 = w1.r_rear_axle_aux1_x + w1.r_rear_axle_aux1_x;
  // long_rod_left
  const double s8_141 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_z_x;
  const double s8_142 = fma(p_long_rod_left_to_z, w1.R_rear_axle_z_z, s8_141);
  const double s8_143 = fma(p_long_rod_left_to_y, w1.R_rear_axle_z_y, s8_142);
  const double s8_144 = w1.r_rear_axle_aux3_z - p_long_rod_left_from_z;
  w2.s8_145 = s8_143 + s8_144;
  const double s8_146 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_x_x;
  const double s8_147 = fma(p_long_rod_left_to_z, w1.R_rear_axle_x_z, s8_146);
  const double s8_148 = fma(p_long_rod_left_to_y, w1.R_rear_axle_x_y, s8_147);
  const double s8_149 = w1.r_rear_axle_aux1_x - p_long_rod_left_from_x;
  w2.s8_150 = s8_148 + s8_149;
  const double s8_151 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_y_x;
  const double s8_152 = fma(p_long_rod_left_to_z, w1.R_rear_axle_y_z, s8_151);
  const double s8_153 = fma(p_long_rod_left_to_y, w1.R_rear_axle_y_y, s8_152);
  const double s8_154 = fnma(w1.s4_40, s8_153, w1.s4_38*s8_143);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s8_155 = zd_rear_axle_tx + s8_154;
  const double s8_156 = fnma(w1.s4_42, s8_143, w1.s4_40*s8_148);
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_157 = zd_rear_axle_ty + s8_156;
  const double s8_158 = fnma(w1.s4_38, s8_148, w1.s4_42*s8_153);
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s8_159 = zd_rear_axle_tz + s8_158;
  const double s8_160 = fnma(w2.s3_7, s8_153, fma(w2.s3_2, s8_143, projection.Rz[42]));
  const double s8_161 = fnma(w2.s3_10, s8_153, fma(w2.s3_4, s8_143, projection.Rz[43]));
  const double s8_162 = fma(w2.s3_7, s8_148, fnma(w2.s3_13, s8_143, projection.Rz[44]));
  const double s8_163 = fma(w2.s3_10, s8_148, fnma(w2.s3_16, s8_143, projection.Rz[45]));
  const double s8_164 = fma(w2.s3_13, s8_153, fnma(w2.s3_2, s8_148, projection.Rz[46]));
  const double s8_165 = fma(w2.s3_16, s8_153, fnma(w2.s3_4, s8_148, projection.Rz[47]));
  w2.s8_166 = p_long_rod_left_from_y - z_rear_axle_ty - s8_153;
  w2.s8_167 = 3.0*w2.s8_166;
  w2.s8_168 = 3.0*w2.s8_150;
  w2.s8_169 = 3.0*w2.s8_145;
  const double s8_170 = fms(w2.s8_20, w2.s8_150, projection.zdd_star[14]);
  const double s8_171 = fnma(w2.s8_16, w2.s8_145, fnma(w2.s6_15, s8_143, s8_170));
  const double s8_172 = fma(w1.s4_40, s8_156, fma(w2.s6_10, s8_153, s8_171));
  const double s8_173 = fnma(w1.s4_38, s8_158, fma(w2.s8_13, s8_157, s8_172));
  w2.s8_174 = 3.0*fma(w2.s8_14, w2.s8_166, fnma(w2.s8_11, s8_159, s8_173));
  const double s8_175 = fma(w2.s6_15, s8_148, fms(w2.s8_19, w2.s8_145, projection.zdd_star[16]));
  const double s8_176 = fnma(w2.s6_5, s8_153, fnma(w2.s8_16, w2.s8_150, s8_175));
  const double s8_177 = fma(w2.s8_11, s8_155, fma(w1.s4_38, s8_154, s8_176));
  const double s8_178 = fnma(w2.s8_12, s8_157, fnma(w1.s4_42, s8_156, s8_177));
  w2.s8_179 = 3.0*fma(w2.s8_15, w2.s8_166, s8_178);
  const double s8_180 = fnma(w2.s8_15, w2.s8_145, fms(w2.s6_5, s8_143, projection.zdd_star[15]));
  const double s8_181 = fnma(w2.s8_14, w2.s8_150, fnma(w2.s6_10, s8_148, s8_180));
  const double s8_182 = fnma(w2.s8_13, s8_155, fnma(w1.s4_40, s8_154, s8_181));
  const double s8_183 = fma(w2.s8_12, s8_159, fma(w1.s4_42, s8_158, s8_182));
  w2.s8_184 = 3.0*fnma(w2.s8_21, w2.s8_166, s8_183);
  // diag_rod_left
  const double s8_185 = p_diag_rod_left_to_z*w1.R_rear_axle_z_z;
  const double s8_186 = fma(p_diag_rod_left_to_y, w1.R_rear_axle_z_y, s8_185);
  const double s8_187 = w1.r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  w2.s8_188 = s8_186 + s8_187;
  const double s8_189 = p_diag_rod_left_to_z*w1.R_rear_axle_x_z;
  const double s8_190 = fma(p_diag_rod_left_to_y, w1.R_rear_axle_x_y, s8_189);
  const double s8_191 = w1.r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  w2.s8_192 = s8_190 + s8_191;
  const double s8_193 = p_diag_rod_left_to_y*w1.R_rear_axle_y_y;
  const double s8_194 = fma(p_diag_rod_left_to_z, w1.R_rear_axle_y_z, s8_193);
  const double s8_195 = fnma(w1.s4_40, s8_194, w1.s4_38*s8_186);
  const double s8_196 = zd_rear_axle_tx + s8_195;
  const double s8_197 = fnma(w1.s4_42, s8_186, w1.s4_40*s8_190);
  const double s8_198 = zd_rear_axle_ty + s8_197;
  const double s8_199 = fnma(w1.s4_38, s8_190, w1.s4_42*s8_194);
  const double s8_200 = zd_rear_axle_tz + s8_199;
  const double s8_201 = fnma(w2.s3_7, s8_194, fma(w2.s3_2, s8_186, projection.Rz[42]));
  const double s8_202 = fnma(w2.s3_10, s8_194, fma(w2.s3_4, s8_186, projection.Rz[43]));
  const double s8_203 = fma(w2.s3_7, s8_190, fnma(w2.s3_13, s8_186, projection.Rz[44]));
  const double s8_204 = fma(w2.s3_10, s8_190, fnma(w2.s3_16, s8_186, projection.Rz[45]));
  const double s8_205 = fma(w2.s3_13, s8_194, fnma(w2.s3_2, s8_190, projection.Rz[46]));
  const double s8_206 = fma(w2.s3_16, s8_194, fnma(w2.s3_4, s8_190, projection.Rz[47]));
  w2.s8_207 = p_diag_rod_left_from_y - z_rear_axle_ty - s8_194;
  w2.s8_208 = 2.6666666666666665*w2.s8_207;
  w2.s8_209 = 2.6666666666666665*w2.s8_192;
  w2.s8_210 = 2.6666666666666665*w2.s8_188;
  const double s8_211 = fms(w2.s8_20, w2.s8_192, projection.zdd_star[14]);
  const double s8_212 = fnma(w2.s8_16, w2.s8_188, fnma(w2.s6_15, s8_186, s8_211));
  const double s8_213 = fma(w1.s4_40, s8_197, fma(w2.s6_10, s8_194, s8_212));
  const double s8_214 = fnma(w1.s4_38, s8_199, fma(w2.s8_13, s8_198, s8_213));
  const double s8_215 = fma(w2.s8_14, w2.s8_207, fnma(w2.s8_11, s8_200, s8_214));
  w2.s8_216 = 2.6666666666666665*s8_215;
  const double s8_217 = fma(w2.s6_15, s8_190, fms(w2.s8_19, w2.s8_188, projection.zdd_star[16]));
  const double s8_218 = fnma(w2.s6_5, s8_194, fnma(w2.s8_16, w2.s8_192, s8_217));
  const double s8_219 = fma(w2.s8_11, s8_196, fma(w1.s4_38, s8_195, s8_218));
  const double s8_220 = fnma(w2.s8_12, s8_198, fnma(w1.s4_42, s8_197, s8_219));
  w2.s8_221 = 2.6666666666666665*fma(w2.s8_15, w2.s8_207, s8_220);
  const double s8_222 = fnma(w2.s8_15, w2.s8_188, fms(w2.s6_5, s8_186, projection.zdd_star[15]));
  const double s8_223 = fnma(w2.s8_14, w2.s8_192, fnma(w2.s6_10, s8_190, s8_222));
  const double s8_224 = fnma(w2.s8_13, s8_196, fnma(w1.s4_40, s8_195, s8_223));
  const double s8_225 = fma(w2.s8_12, s8_200, fma(w1.s4_42, s8_199, s8_224));
  w2.s8_226 = 2.6666666666666665*fnma(w2.s8_21, w2.s8_207, s8_225);
  // arb_link_rear_left
  const double s8_227 = p_arb_link_rear_left_from_x*w8.sines[20];
  const double s8_228 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_y_x;
  const double s8_229 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_y_z, s8_228);
  const double s8_230 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_z_x;
  const double s8_231 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_z_z, s8_230);
  const double s8_232 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_x_x;
  const double s8_233 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_x_z, s8_232);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s8_234 = zd_arb_rear_left*s8_227;
  const double s8_235 = p_arb_link_rear_left_from_x*w8.cosines[20];
  const double s8_236 = zd_arb_rear_left*s8_235;
  const double s8_237 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_z_y, s8_231);
  const double s8_238 = w1.r_rear_axle_aux3_z - p_arb_rear_left_z;
  w2.s8_239 = s8_238 + (s8_227 + s8_237);
  const double s8_240 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_x_y, s8_233);
  const double s8_241 = fnma(w1.s4_42, s8_237, w1.s4_40*s8_240);
  const double s8_242 = zd_rear_axle_ty + s8_241;
  const double s8_243 = fma(w2.s3_7, s8_240, fnma(w2.s3_13, s8_237, projection.Rz[44]));
  const double s8_244 = fma(w2.s3_10, s8_240, fnma(w2.s3_16, s8_237, projection.Rz[45]));
  w2.s8_245 = s8_235 + p_arb_rear_left_x - w1.r_rear_axle_aux1_x - s8_240;
  const double s8_246 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_y_y, s8_229);
  w2.s8_247 = 0.6 - z_rear_axle_ty - s8_246;
  w2.s8_248 = 0.3333333333333333*w2.s8_247;
  w2.s8_249 = 0.3333333333333333*w2.s8_245;
  const double s8_250 = fnma(w1.s4_40, s8_246, w1.s4_38*s8_237);
  const double s8_251 = s8_250 + (zd_rear_axle_tx + s8_234);
  const double s8_252 = fnma(w1.s4_38, s8_240, w1.s4_42*s8_246);
  const double s8_253 = s8_252 + (zd_rear_axle_tz + s8_236);
  const double s8_254 = fma(w2.s3_2, s8_237, fma(projection.Rz[54], s8_227, projection.Rz[42]));
  const double s8_255 = fnma(w2.s3_7, s8_246, s8_254);
  const double s8_256 = fnma(w2.s3_2, s8_240, fma(projection.Rz[54], s8_235, projection.Rz[46]));
  const double s8_257 = fma(w2.s3_13, s8_246, s8_256);
  const double s8_258 = fma(w2.s3_4, s8_237, fma(projection.Rz[55], s8_227, projection.Rz[43]));
  const double s8_259 = fnma(w2.s3_10, s8_246, s8_258);
  const double s8_260 = fnma(w2.s3_4, s8_240, fma(projection.Rz[55], s8_235, projection.Rz[47]));
  const double s8_261 = fma(w2.s3_16, s8_246, s8_260);
  w2.s8_262 = 0.3333333333333333*w2.s8_239;
  const double s8_263 = fms(zd_arb_rear_left, s8_234, projection.zdd_star[16]);
  const double s8_264 = fma(w2.s8_19, w2.s8_239, fnma(projection.zdd_star[20], s8_235, s8_263));
  const double s8_265 = fnma(w1.s4_42, s8_241, fma(w2.s6_15, s8_240, s8_264));
  const double s8_266 = fma(w2.s8_16, w2.s8_245, fnma(w2.s8_12, s8_242, s8_265));
  const double s8_267 = fma(w2.s8_15, w2.s8_247, fnma(w2.s6_5, s8_246, s8_266));
  w2.s8_268 = 0.3333333333333333*fma(w2.s8_11, s8_251, fma(w1.s4_38, s8_250, s8_267));
  const double s8_269 = fms(w1.s4_40, s8_241, projection.zdd_star[14]);
  const double s8_270 = fnma(projection.zdd_star[20], s8_227, s8_269);
  const double s8_271 = fnma(w2.s6_15, s8_237, fnma(zd_arb_rear_left, s8_236, s8_270));
  const double s8_272 = fma(w2.s8_13, s8_242, fnma(w2.s8_16, w2.s8_239, s8_271));
  const double s8_273 = fma(w2.s6_10, s8_246, fnma(w2.s8_20, w2.s8_245, s8_272));
  const double s8_274 = fnma(w1.s4_38, s8_252, fma(w2.s8_14, w2.s8_247, s8_273));
  w2.s8_275 = 0.3333333333333333*fnma(w2.s8_11, s8_253, s8_274);
  const double s8_276 = fnma(w2.s8_15, w2.s8_239, fms(w2.s6_5, s8_237, projection.zdd_star[15]));
  const double s8_277 = fma(w2.s8_14, w2.s8_245, fnma(w2.s6_10, s8_240, s8_276));
  const double s8_278 = fnma(w1.s4_40, s8_250, fnma(w2.s8_21, w2.s8_247, s8_277));
  const double s8_279 = fma(w1.s4_42, s8_252, fnma(w2.s8_13, s8_251, s8_278));
  w2.s8_280 = 0.3333333333333333*fma(w2.s8_12, s8_253, s8_279);
  // long_rod_right
  const double s8_281 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_y_y, s8_152);
  w2.s8_282 = s8_281 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s8_283 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_z_y, s8_142);
  w2.s8_284 = s8_144 + s8_283;
  const double s8_285 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_x_y, s8_147);
  w3.s8_286 = s8_149 + s8_285;
  const double s8_287 = fnma(w1.s4_40, s8_281, w1.s4_38*s8_283);
  const double s8_288 = zd_rear_axle_tx + s8_287;
  const double s8_289 = fnma(w1.s4_42, s8_283, w1.s4_40*s8_285);
  const double s8_290 = zd_rear_axle_ty + s8_289;
  const double s8_291 = fnma(w1.s4_38, s8_285, w1.s4_42*s8_281);
  const double s8_292 = zd_rear_axle_tz + s8_291;
  const double s8_293 = fma(w2.s3_2, s8_283, fnma(w2.s3_7, s8_281, projection.Rz[42]));
  const double s8_294 = fma(w2.s3_4, s8_283, fnma(w2.s3_10, s8_281, projection.Rz[43]));
  const double s8_295 = fma(w2.s3_7, s8_285, fnma(w2.s3_13, s8_283, projection.Rz[44]));
  const double s8_296 = fma(w2.s3_10, s8_285, fnma(w2.s3_16, s8_283, projection.Rz[45]));
  const double s8_297 = fnma(w2.s3_2, s8_285, fma(w2.s3_13, s8_281, projection.Rz[46]));
  const double s8_298 = fnma(w2.s3_4, s8_285, fma(w2.s3_16, s8_281, projection.Rz[47]));
  w3.s8_299 = 3.0*w2.s8_282;
  w3.s8_300 = 3.0*w3.s8_286;
  w3.s8_301 = 3.0*w2.s8_284;
  const double s8_302 = fma(w2.s6_5, s8_283, fms(w2.s8_21, w2.s8_282, projection.zdd_star[15]));
  const double s8_303 = fnma(w2.s6_10, s8_285, fnma(w2.s8_15, w2.s8_284, s8_302));
  const double s8_304 = fnma(w1.s4_40, s8_287, fnma(w2.s8_14, w3.s8_286, s8_303));
  const double s8_305 = fma(w1.s4_42, s8_291, fnma(w2.s8_13, s8_288, s8_304));
  w3.s8_306 = 3.0*fma(w2.s8_12, s8_292, s8_305);
  const double s8_307 = fnma(w2.s6_5, s8_281, fms(w2.s8_19, w2.s8_284, projection.zdd_star[16]));
  const double s8_308 = fma(w2.s6_15, s8_285, fnma(w2.s8_15, w2.s8_282, s8_307));
  const double s8_309 = fma(w1.s4_38, s8_287, fnma(w2.s8_16, w3.s8_286, s8_308));
  const double s8_310 = fnma(w1.s4_42, s8_289, fma(w2.s8_11, s8_288, s8_309));
  w3.s8_311 = 3.0*fnma(w2.s8_12, s8_290, s8_310);
  const double s8_312 = fms(w2.s6_10, s8_281, projection.zdd_star[14]);
  const double s8_313 = fnma(w2.s6_15, s8_283, fnma(w2.s8_14, w2.s8_282, s8_312));
  const double s8_314 = fma(w2.s8_20, w3.s8_286, fnma(w2.s8_16, w2.s8_284, s8_313));
  const double s8_315 = fma(w2.s8_13, s8_290, fma(w1.s4_40, s8_289, s8_314));
  w3.s8_316 = 3.0*fnma(w2.s8_11, s8_292, fnma(w1.s4_38, s8_291, s8_315));
  // diag_rod_right
  const double s8_317 = fnma(p_diag_rod_left_to_y, w1.R_rear_axle_z_y, s8_185);
  w3.s8_318 = s8_187 + s8_317;
  const double s8_319 = fms(p_diag_rod_left_to_z, w1.R_rear_axle_y_z, s8_193);
  w3.s8_320 = s8_319 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  const double s8_321 = fnma(p_diag_rod_left_to_y, w1.R_rear_axle_x_y, s8_189);
  w3.s8_322 = s8_191 + s8_321;
  const double s8_323 = fnma(w1.s4_40, s8_319, w1.s4_38*s8_317);
  const double s8_324 = zd_rear_axle_tx + s8_323;
  const double s8_325 = fnma(w1.s4_42, s8_317, w1.s4_40*s8_321);
  const double s8_326 = zd_rear_axle_ty + s8_325;
  const double s8_327 = fnma(w1.s4_38, s8_321, w1.s4_42*s8_319);
  const double s8_328 = zd_rear_axle_tz + s8_327;
  const double s8_329 = fnma(w2.s3_7, s8_319, fma(w2.s3_2, s8_317, projection.Rz[42]));
  const double s8_330 = fnma(w2.s3_10, s8_319, fma(w2.s3_4, s8_317, projection.Rz[43]));
  const double s8_331 = fma(w2.s3_7, s8_321, fnma(w2.s3_13, s8_317, projection.Rz[44]));
  const double s8_332 = fma(w2.s3_10, s8_321, fnma(w2.s3_16, s8_317, projection.Rz[45]));
  const double s8_333 = fnma(w2.s3_2, s8_321, fma(w2.s3_13, s8_319, projection.Rz[46]));
  const double s8_334 = fnma(w2.s3_4, s8_321, fma(w2.s3_16, s8_319, projection.Rz[47]));
  w3.s8_335 = 2.6666666666666665*w3.s8_320;
  w3.s8_336 = 2.6666666666666665*w3.s8_322;
  w3.s8_337 = 2.6666666666666665*w3.s8_318;
  const double s8_338 = fnma(w2.s8_15, w3.s8_318, fms(w2.s6_5, s8_317, projection.zdd_star[15]));
  const double s8_339 = fnma(w2.s6_10, s8_321, fma(w2.s8_21, w3.s8_320, s8_338));
  const double s8_340 = fnma(w1.s4_40, s8_323, fnma(w2.s8_14, w3.s8_322, s8_339));
  const double s8_341 = fma(w1.s4_42, s8_327, fnma(w2.s8_13, s8_324, s8_340));
  w3.s8_342 = 2.6666666666666665*fma(w2.s8_12, s8_328, s8_341);
  const double s8_343 = fnma(w2.s6_5, s8_319, fms(w2.s8_19, w3.s8_318, projection.zdd_star[16]));
  const double s8_344 = fma(w2.s6_15, s8_321, fnma(w2.s8_15, w3.s8_320, s8_343));
  const double s8_345 = fma(w1.s4_38, s8_323, fnma(w2.s8_16, w3.s8_322, s8_344));
  const double s8_346 = fnma(w1.s4_42, s8_325, fma(w2.s8_11, s8_324, s8_345));
  w3.s8_347 = 2.6666666666666665*fnma(w2.s8_12, s8_326, s8_346);
  const double s8_348 = fnma(w2.s6_15, s8_317, fms(w2.s6_10, s8_319, projection.zdd_star[14]));
  const double s8_349 = fnma(w2.s8_14, w3.s8_320, fnma(w2.s8_16, w3.s8_318, s8_348));
  const double s8_350 = fma(w1.s4_40, s8_325, fma(w2.s8_20, w3.s8_322, s8_349));
  const double s8_351 = fnma(w1.s4_38, s8_327, fma(w2.s8_13, s8_326, s8_350));
  w3.s8_352 = 2.6666666666666665*fnma(w2.s8_11, s8_328, s8_351);
  // arb_link_rear_right
  const double s8_353 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_y_y, s8_229);
  const double s8_354 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_x_y, s8_233);
  const double s8_355 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_z_y, s8_231);
  const double s8_356 = p_arb_link_rear_right_from_x*w8.sines[21];
  w3.s8_357 = 0.6 + z_rear_axle_ty - s8_353;
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s8_358 = zd_arb_rear_right*s8_356;
  const double s8_359 = p_arb_link_rear_right_from_x*w8.cosines[21];
  const double s8_360 = zd_arb_rear_right*s8_359;
  const double s8_361 = fnma(w1.s4_40, s8_354, w1.s4_42*s8_355);
  const double s8_362 = zd_rear_axle_ty + s8_361;
  const double s8_363 = fma(w2.s3_13, s8_355, fnma(w2.s3_7, s8_354, projection.Rz[44]));
  const double s8_364 = fma(w2.s3_16, s8_355, fnma(w2.s3_10, s8_354, projection.Rz[45]));
  w3.s8_365 = s8_356 + (s8_238 - s8_355);
  w3.s8_366 = 0.3333333333333333*w3.s8_357;
  const double s8_367 = fnma(w1.s4_38, s8_355, w1.s4_40*s8_353);
  const double s8_368 = s8_367 + (zd_rear_axle_tx + s8_358);
  const double s8_369 = fnma(w1.s4_42, s8_353, w1.s4_38*s8_354);
  const double s8_370 = s8_369 + (zd_rear_axle_tz + s8_360);
  const double s8_371 = fnma(w2.s3_2, s8_355, fma(w2.s3_7, s8_353, projection.Rz[42]));
  const double s8_372 = fma(projection.Rz[56], s8_356, s8_371);
  const double s8_373 = fma(w2.s3_2, s8_354, fnma(w2.s3_13, s8_353, projection.Rz[46]));
  const double s8_374 = fma(projection.Rz[56], s8_359, s8_373);
  const double s8_375 = fnma(w2.s3_4, s8_355, fma(w2.s3_10, s8_353, projection.Rz[43]));
  const double s8_376 = fma(projection.Rz[57], s8_356, s8_375);
  const double s8_377 = fma(w2.s3_4, s8_354, fnma(w2.s3_16, s8_353, projection.Rz[47]));
  const double s8_378 = fma(projection.Rz[57], s8_359, s8_377);
  w3.s8_379 = s8_359 + (s8_354 + p_arb_rear_right_x - w1.r_rear_axle_aux1_x);
  w3.s8_380 = 0.3333333333333333*w3.s8_379;
  w3.s8_381 = 0.3333333333333333*w3.s8_365;
  const double s8_382 = fnma(projection.Rz[55], w2.s7_35, projection.Rz[57]*w2.s7_47);
  const double s8_383 = s8_123 + fma(z_rear_axle_ty, s8_111, s8_382);
  const double s8_384 = fma(s8_165, w2.s8_167, fnma(w1.r_rear_axle_aux3_z, w2.s8_125, s8_383));
  const double s8_385 = fma(s8_206, w2.s8_208, fma(s8_163, w2.s8_169, s8_384));
  const double s8_386 = fma(w2.s8_248, s8_261, fma(s8_204, w2.s8_210, s8_385));
  const double s8_387 = fnma(s8_298, w3.s8_299, fma(s8_244, w2.s8_262, s8_386));
  const double s8_388 = fnma(s8_334, w3.s8_335, fma(s8_296, w3.s8_301, s8_387));
  const double s8_389 = fnma(w3.s8_366, s8_378, fma(s8_332, w3.s8_337, s8_388));
  const double s8_390 = fnma(projection.Rz[55], w2.s7_36, w2.s8_25);
  w3.s8_391 = fnma(p_arb_rear_right_y, s8_390, fma(s8_364, w3.s8_381, s8_389));
  const double s8_392 = fnma(projection.Rz[57], w2.s7_44, projection.Rz[55]*w2.s7_37);
  const double s8_393 = fnma(z_rear_axle_ty, s8_106, s8_392);
  const double s8_394 = s8_131 + fma(w1.r_rear_axle_aux1_x, w2.s8_125, s8_393);
  const double s8_395 = fnma(s8_163, w2.s8_168, fnma(s8_161, w2.s8_167, s8_394));
  const double s8_396 = fnma(s8_204, w2.s8_209, fnma(s8_202, w2.s8_208, s8_395));
  const double s8_397 = fnma(w2.s8_248, s8_259, fma(s8_244, w2.s8_249, s8_396));
  const double s8_398 = fnma(s8_296, w3.s8_300, fma(s8_294, w3.s8_299, s8_397));
  const double s8_399 = fnma(s8_332, w3.s8_336, fma(s8_330, w3.s8_335, s8_398));
  const double s8_400 = fma(s8_364, w3.s8_380, fma(w3.s8_366, s8_376, s8_399));
  const double s8_401 = fms(projection.Rz[55], w2.s7_38, w2.s8_24);
  w3.s8_402 = fnma(p_arb_rear_right_y, s8_401, s8_400);
  const double s8_403 = fma(w1.r_rear_axle_aux3_z, s8_106, w2.s8_27 + w2.s8_46);
  const double s8_404 = s8_137 + fnma(w1.r_rear_axle_aux1_x, s8_111, s8_403);
  const double s8_405 = fnma(s8_161, w2.s8_169, fma(s8_165, w2.s8_168, s8_404));
  const double s8_406 = fnma(s8_202, w2.s8_210, fma(s8_206, w2.s8_209, s8_405));
  const double s8_407 = fnma(s8_259, w2.s8_262, fnma(w2.s8_249, s8_261, s8_406));
  const double s8_408 = fnma(s8_294, w3.s8_301, fma(s8_298, w3.s8_300, s8_407));
  const double s8_409 = fnma(s8_330, w3.s8_337, fma(s8_334, w3.s8_336, s8_408));
  const double s8_410 = fnma(s8_376, w3.s8_381, fnma(s8_378, w3.s8_380, s8_409));
  const double s8_411 = fma(projection.Rz[55], w2.s7_38, w2.s8_24);
  const double s8_412 = fma(projection.Rz[55], w2.s7_36, w2.s8_25);
  const double s8_413 = fma(p_carrier_left_rz_y, s8_411, s8_410);
  w3.s8_414 = fma(p_arb_rear_right_x, s8_412, s8_413);
  const double s8_415 = fma(s8_164, s8_164, fma(s8_162, s8_162, s8_160*s8_160));
  const double s8_416 = fma(s8_205, s8_205, fma(s8_203, s8_203, s8_201*s8_201));
  const double s8_417 = fma(s8_257, s8_257, fma(s8_255, s8_255, s8_243*s8_243));
  const double s8_418 = fma(projection.Rz[54], w2.s8_45, projection.Rz[56]*w2.s8_26);
  const double s8_419 = fma(projection.Rz[46], s8_109, fma(projection.Rz[42], s8_104, s8_418));
  const double s8_420 = fma(projection.Rz[44], s8_120, fma(w2.s3_13, s8_118, s8_419));
  const double s8_421 = fma(s8_297, s8_297, fma(s8_295, s8_295, fma(s8_293, s8_293, s8_415)));
  const double s8_422 = fnma(3.0, s8_421, fma(w2.s3_2, s8_134, fma(w2.s3_7, s8_128, s8_420)));
  const double s8_423 = fma(s8_333, s8_333, fma(s8_331, s8_331, fma(s8_329, s8_329, s8_416)));
  const double s8_424 = fma(s8_374, s8_374, fma(s8_372, s8_372, fma(s8_363, s8_363, s8_417)));
  const double s8_425 = fnma(2.6666666666666665, s8_423, s8_422);
  const double s8_426 = fnma(0.3333333333333333, s8_424, s8_425);
  const double s8_427 = fma(s8_164, s8_165, fma(s8_162, s8_163, s8_160*s8_161));
  const double s8_428 = fma(s8_205, s8_206, fma(s8_203, s8_204, s8_201*s8_202));
  const double s8_429 = fma(s8_257, s8_261, fma(s8_255, s8_259, s8_243*s8_244));
  const double s8_430 = fma(projection.Rz[54], w2.s8_46, projection.Rz[56]*w2.s8_27);
  const double s8_431 = fma(projection.Rz[46], s8_111, fma(projection.Rz[42], s8_106, s8_430));
  const double s8_432 = fma(projection.Rz[44], w2.s8_125, fma(w2.s3_13, s8_123, s8_431));
  const double s8_433 = fma(s8_297, s8_298, fma(s8_295, s8_296, fma(s8_293, s8_294, s8_427)));
  const double s8_434 = fnma(3.0, s8_433, fma(w2.s3_2, s8_137, fma(w2.s3_7, s8_131, s8_432)));
  const double s8_435 = fma(s8_333, s8_334, fma(s8_331, s8_332, fma(s8_329, s8_330, s8_428)));
  const double s8_436 = fma(s8_374, s8_378, fma(s8_372, s8_376, fma(s8_363, s8_364, s8_429)));
  const double s8_437 = fnma(2.6666666666666665, s8_435, s8_434);
  w3.s8_438 = fnma(0.3333333333333333, s8_436, s8_437);
  const double s8_439 = fma(s8_165, s8_165, fma(s8_163, s8_163, s8_161*s8_161));
  const double s8_440 = fma(s8_206, s8_206, fma(s8_204, s8_204, s8_202*s8_202));
  const double s8_441 = fma(s8_261, s8_261, fma(s8_259, s8_259, s8_244*s8_244));
  const double s8_442 = fma(projection.Rz[55], w2.s8_46, projection.Rz[57]*w2.s8_27);
  const double s8_443 = fma(projection.Rz[47], s8_111, fma(projection.Rz[43], s8_106, s8_442));
  const double s8_444 = fma(projection.Rz[45], w2.s8_125, fma(w2.s3_16, s8_123, s8_443));
  const double s8_445 = fma(s8_298, s8_298, fma(s8_296, s8_296, fma(s8_294, s8_294, s8_439)));
  const double s8_446 = fnma(3.0, s8_445, fma(w2.s3_4, s8_137, fma(w2.s3_10, s8_131, s8_444)));
  const double s8_447 = fma(s8_334, s8_334, fma(s8_332, s8_332, fma(s8_330, s8_330, s8_440)));
  const double s8_448 = fma(s8_378, s8_378, fma(s8_376, s8_376, fma(s8_364, s8_364, s8_441)));
  const double s8_449 = fnma(2.6666666666666665, s8_447, s8_446);
  const double s8_450 = fnma(0.3333333333333333, s8_448, s8_449);
  const double s8_451 = fnma(w2.s6_5, s8_355, fms(w2.s6_10, s8_354, projection.zdd_star[15]));
  const double s8_452 = fnma(w2.s8_15, w3.s8_365, fma(w2.s8_21, w3.s8_357, s8_451));
  const double s8_453 = fnma(w2.s8_13, s8_368, fnma(w1.s4_40, s8_367, s8_452));
  const double s8_454 = fma(w2.s8_12, s8_370, fma(w1.s4_42, s8_369, s8_453));
  w3.s8_455 = 0.3333333333333333*fma(w2.s8_14, w3.s8_379, s8_454);
  const double s8_456 = fnma(w2.s6_15, s8_354, fms(w2.s6_5, s8_353, projection.zdd_star[16]));
  const double s8_457 = fma(zd_arb_rear_right, s8_358, fnma(w2.s8_15, w3.s8_357, s8_456));
  const double s8_458 = fnma(w1.s4_42, s8_361, fnma(projection.zdd_star[21], s8_359, s8_457));
  const double s8_459 = fma(w2.s8_19, w3.s8_365, fnma(w2.s8_12, s8_362, s8_458));
  const double s8_460 = fma(w2.s8_11, s8_368, fma(w1.s4_38, s8_367, s8_459));
  w3.s8_461 = 0.3333333333333333*fma(w2.s8_16, w3.s8_379, s8_460);
  const double s8_462 = fnma(w2.s6_10, s8_353, fms(w2.s6_15, s8_355, projection.zdd_star[14]));
  const double s8_463 = fnma(w2.s8_14, w3.s8_357, fnma(projection.zdd_star[21], s8_356, s8_462));
  const double s8_464 = fma(w1.s4_40, s8_361, fnma(zd_arb_rear_right, s8_360, s8_463));
  const double s8_465 = fnma(w2.s8_16, w3.s8_365, fma(w2.s8_13, s8_362, s8_464));
  const double s8_466 = fnma(w2.s8_11, s8_370, fnma(w1.s4_38, s8_369, s8_465));
  w3.s8_467 = 0.3333333333333333*fnma(w2.s8_20, w3.s8_379, s8_466);
  const double s8_468 = tau[Coordinate::rear_axle_tx] - w2.f_rear_axle_x;
  const double s8_469 = tau[Coordinate::rear_axle_ty] - w2.f_rear_axle_y;
  const double s8_470 = tau[Coordinate::rear_axle_tz] - w2.f_rear_axle_z;
  const double s8_471 = fma(w2.s7_37, w2.s8_14, tau[Coordinate::arb_rear_left]);
  const double s8_472 = fnma(w2.s7_41, w2.s8_42, fma(w2.s7_35, w2.s8_15, s8_471));
  const double s8_473 = fma(w2.s7_36, w2.s8_53, fma(w2.s7_38, w2.s8_49, s8_472));
  const double s8_474 = fnma(w2.s8_16, w2.s8_56, fnma(0.4225, projection.zdd_star[20], s8_473));
  const double s8_475 = fnma(w2.s7_44, w2.s8_14, tau[Coordinate::arb_rear_right]);
  const double s8_476 = fma(w2.s7_46, w2.s8_37, fnma(w2.s7_47, w2.s8_15, s8_475));
  const double s8_477 = fnma(0.4225, projection.zdd_star[21], fma(w2.s7_45, w2.s8_40, s8_476));
  const double s8_478 = fnma(w2.s8_16, w2.s8_43, fnma(w2.s7_50, w2.s8_42, s8_477));
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s8_479 = fma(tau_rear_axle_rx, w1.s1_92, w8.cosines[17]*tau_rear_axle_ry);
  const double s8_480 = fma(tau_rear_axle_rz, w1.s1_94, s8_479) - w2.n_rear_axle_y;
  const double s8_481 = fnma(w1.s1_42, tau_rear_axle_ry, tau_rear_axle_rx*w1.s1_89);
  const double s8_482 = fnma(tau_rear_axle_rz, w1.s1_96, s8_481) - w2.n_rear_axle_z;
  const double s8_483 = fnma(w1.s1_40, tau_rear_axle_ry, tau_rear_axle_rz*w1.s1_90);
  const double s8_484 = fnma(tau_rear_axle_rx, w1.s1_95, s8_483) - w2.n_rear_axle_x;
  const double s8_485 = fnma(s8_161, w2.s8_174, projection.Rz[43]*s8_468);
  const double s8_486 = fnma(s8_163, w2.s8_184, fnma(s8_165, w2.s8_179, s8_485));
  const double s8_487 = fnma(s8_206, w2.s8_221, fnma(s8_202, w2.s8_216, s8_486));
  const double s8_488 = fnma(s8_261, w2.s8_268, fnma(s8_204, w2.s8_226, s8_487));
  const double s8_489 = fnma(s8_244, w2.s8_280, fnma(s8_259, w2.s8_275, s8_488));
  const double s8_490 = fnma(s8_298, w3.s8_311, fnma(s8_296, w3.s8_306, s8_489));
  const double s8_491 = fnma(s8_332, w3.s8_342, fnma(s8_294, w3.s8_316, s8_490));
  const double s8_492 = fnma(s8_330, w3.s8_352, fnma(s8_334, w3.s8_347, s8_491));
  const double s8_493 = fnma(s8_378, w3.s8_461, fnma(s8_364, w3.s8_455, s8_492));
  const double s8_494 = fma(projection.Rz[45], s8_469, fnma(s8_376, w3.s8_467, s8_493));
  const double s8_495 = fma(projection.Rz[55], s8_474, fma(projection.Rz[47], s8_470, s8_494));
  const double s8_496 = fma(w2.s3_4, s8_480, fma(projection.Rz[57], s8_478, s8_495));
  w3.s8_497 = fma(w2.s3_16, s8_484, fma(w2.s3_10, s8_482, s8_496));
  result.inertia[12] = s8_450 - 1.5272999999999997e-20;
  w3.s8_498 = 1.0/s8_450;
  const double s8_499 = w3.s8_438*w3.s8_498;
  const double s8_500 = fnma(w3.s8_438, s8_499, s8_426);
  result.inertia[11] = fnma(1e-12, s8_426, s8_500 - 1.5272999999999997e-20);
  w3.s8_501 = fnma(w2.s8_125, s8_499, s8_120);
  w3.s8_502 = 1.0/s8_500;
  w3.s8_503 = w3.s8_501*w3.s8_502;
  const double s8_504 = fnma(projection.Rz[54], w2.s7_38, s8_104 - w2.s8_22);
  w3.s8_505 = fnma(w2.s8_107, s8_499, s8_504);
  w3.s8_506 = w3.s8_502*w3.s8_505;
  const double s8_507 = fnma(projection.Rz[54], w2.s7_36, s8_109 - w2.s8_23);
  w3.s8_508 = fnma(w2.s8_112, s8_499, s8_507);
  w3.s8_509 = w3.s8_502*w3.s8_508;
  const double s8_510 = fnma(projection.Rz[54], w2.s7_35, projection.Rz[56]*w2.s7_47);
  const double s8_511 = s8_118 + fma(z_rear_axle_ty, s8_109, s8_510);
  const double s8_512 = fma(s8_164, w2.s8_167, fnma(w1.r_rear_axle_aux3_z, s8_120, s8_511));
  const double s8_513 = fma(s8_205, w2.s8_208, fma(s8_162, w2.s8_169, s8_512));
  const double s8_514 = fma(w2.s8_248, s8_257, fma(s8_203, w2.s8_210, s8_513));
  const double s8_515 = fnma(s8_297, w3.s8_299, fma(s8_243, w2.s8_262, s8_514));
  const double s8_516 = fnma(s8_333, w3.s8_335, fma(s8_295, w3.s8_301, s8_515));
  const double s8_517 = fnma(w3.s8_366, s8_374, fma(s8_331, w3.s8_337, s8_516));
  const double s8_518 = fnma(w3.s8_391, s8_499, fma(s8_363, w3.s8_381, s8_517));
  const double s8_519 = fnma(projection.Rz[54], w2.s7_36, w2.s8_23);
  w3.s8_520 = fnma(p_arb_rear_right_y, s8_519, s8_518);
  w3.s8_521 = w3.s8_502*w3.s8_520;
  const double s8_522 = fnma(projection.Rz[56], w2.s7_44, projection.Rz[54]*w2.s7_37);
  const double s8_523 = fma(w1.r_rear_axle_aux1_x, s8_120, fnma(z_rear_axle_ty, s8_104, s8_522));
  const double s8_524 = fnma(s8_162, w2.s8_168, fnma(s8_160, w2.s8_167, s8_128 + s8_523));
  const double s8_525 = fnma(s8_203, w2.s8_209, fnma(s8_201, w2.s8_208, s8_524));
  const double s8_526 = fnma(w2.s8_248, s8_255, fma(s8_243, w2.s8_249, s8_525));
  const double s8_527 = fnma(s8_295, w3.s8_300, fma(s8_293, w3.s8_299, s8_526));
  const double s8_528 = fnma(s8_331, w3.s8_336, fma(s8_329, w3.s8_335, s8_527));
  const double s8_529 = fma(s8_363, w3.s8_380, fma(w3.s8_366, s8_372, s8_528));
  const double s8_530 = fms(projection.Rz[54], w2.s7_38, w2.s8_22);
  w3.s8_531 = fnma(p_arb_rear_right_y, s8_530, fnma(w3.s8_402, s8_499, s8_529));
  w3.s8_532 = w3.s8_502*w3.s8_531;
  const double s8_533 = fma(w1.r_rear_axle_aux3_z, s8_104, w2.s8_26 + w2.s8_45);
  const double s8_534 = s8_134 + fnma(w1.r_rear_axle_aux1_x, s8_109, s8_533);
  const double s8_535 = fnma(s8_160, w2.s8_169, fma(s8_164, w2.s8_168, s8_534));
  const double s8_536 = fnma(s8_201, w2.s8_210, fma(s8_205, w2.s8_209, s8_535));
  const double s8_537 = fnma(s8_255, w2.s8_262, fnma(w2.s8_249, s8_257, s8_536));
  const double s8_538 = fnma(s8_293, w3.s8_301, fma(s8_297, w3.s8_300, s8_537));
  const double s8_539 = fnma(s8_329, w3.s8_337, fma(s8_333, w3.s8_336, s8_538));
  const double s8_540 = fnma(s8_372, w3.s8_381, fnma(s8_374, w3.s8_380, s8_539));
  const double s8_541 = fma(projection.Rz[54], w2.s7_38, w2.s8_22);
  const double s8_542 = fma(p_carrier_left_rz_y, s8_541, fnma(w3.s8_414, s8_499, s8_540));
  const double s8_543 = fma(projection.Rz[54], w2.s7_36, w2.s8_23);
  w3.s8_544 = fma(p_arb_rear_right_x, s8_543, s8_542);
  w3.s8_545 = w3.s8_502*w3.s8_544;
  w3.s8_546 = w2.s8_125*w3.s8_498;
  const double s8_547 = fnma(s8_160, w2.s8_174, projection.Rz[42]*s8_468);
  const double s8_548 = fnma(s8_162, w2.s8_184, fnma(s8_164, w2.s8_179, s8_547));
  const double s8_549 = fnma(s8_205, w2.s8_221, fnma(s8_201, w2.s8_216, s8_548));
  const double s8_550 = fnma(s8_257, w2.s8_268, fnma(s8_203, w2.s8_226, s8_549));
  const double s8_551 = fnma(s8_243, w2.s8_280, fnma(s8_255, w2.s8_275, s8_550));
  const double s8_552 = fnma(s8_297, w3.s8_311, fnma(s8_295, w3.s8_306, s8_551));
  const double s8_553 = fnma(s8_331, w3.s8_342, fnma(s8_293, w3.s8_316, s8_552));
  const double s8_554 = fnma(s8_329, w3.s8_352, fnma(s8_333, w3.s8_347, s8_553));
  const double s8_555 = fnma(s8_374, w3.s8_461, fnma(s8_363, w3.s8_455, s8_554));
  const double s8_556 = fma(projection.Rz[44], s8_469, fnma(s8_372, w3.s8_467, s8_555));
  const double s8_557 = fma(projection.Rz[54], s8_474, fma(projection.Rz[46], s8_470, s8_556));
  const double s8_558 = fma(w2.s3_2, s8_480, fma(projection.Rz[56], s8_478, s8_557));
  const double s8_559 = fma(w2.s3_13, s8_484, fma(w2.s3_7, s8_482, s8_558));
  w3.s8_560 = fnma(w3.s8_497, s8_499, s8_559);
  w3.s8_561 = w2.s8_107*w3.s8_498;
  w3.s8_562 = w2.s8_112*w3.s8_498;
  w3.s8_563 = w3.s8_391*w3.s8_498;
  w3.s8_564 = w3.s8_402*w3.s8_498;
  w3.s8_565 = w3.s8_414*w3.s8_498;
  // operations: 772 add, 822 multiply, 2 divide
}

/// Part 3 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63);
/// step 3: Rz (61), upper_ball_left .. tie_rod_right; step 6: c and dRz/dt zd (62), upper_ball_left
/// .. tie_rod_right; step 7: inertias of the bodies and forces on joints, upper_ball_left ..
/// tie_rod_right; step 8: elimination from the leaves to the root (63), upper_ball_left ..
/// tie_rod_right.
[[gnu::noinline]] void compute_chosen_accelerations_3(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork1& __restrict w1,
    ChosenAccelerationsWork2& __restrict w2, ChosenAccelerationsWork3& __restrict w3,
    ChosenAccelerationsWork4& __restrict w4, ChosenAccelerationsWork5& __restrict w5,
    ChosenAccelerationsWork8& __restrict w8) noexcept {
  // --- step 8: elimination from the leaves to the root (63), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s8_566 = w1.R_carrier_right_aux2_z_y*w1.w_carrier_right_x;
  const double s8_567 = fma(w1.s1_35, w1.w_carrier_right_z, s8_566);
  const double s8_568 = w1.R_carrier_right_aux2_y_y*w1.w_carrier_right_x;
  const double s8_569 = fma(w1.s1_35, w1.w_carrier_right_y, s8_568);
  const double s8_570 = fnma(w1.s1_35, w1.w_carrier_right_x,
      state.zd[Coordinate::wheel_front_right]);
  const double s8_571 = fma(w1.R_carrier_right_aux2_y_y, w1.w_carrier_right_y, s8_570);
  const double s8_572 = fma(w1.R_carrier_right_aux2_z_y, w1.w_carrier_right_z, s8_571);
  const double s8_573 = I_wheel_front_right_polar*s8_572;
  const double s8_574 = w1.R_carrier_right_aux2_z_y*w1.w_carrier_right_y;
  const double s8_575 = fnma(w1.R_carrier_right_aux2_y_y, w1.w_carrier_right_z, s8_574);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s8_576 = w1.R_carrier_left_aux2_z_y*w1.w_carrier_left_x;
  const double s8_577 = fma(w1.s1_22, w1.w_carrier_left_z, s8_576);
  const double s8_578 = w1.R_carrier_left_aux2_y_y*w1.w_carrier_left_x;
  const double s8_579 = fma(w1.s1_22, w1.w_carrier_left_y, s8_578);
  const double s8_580 = fnma(w1.s1_22, w1.w_carrier_left_x, state.zd[Coordinate::wheel_front_left]);
  const double s8_581 = fma(w1.R_carrier_left_aux2_y_y, w1.w_carrier_left_y, s8_580);
  const double s8_582 = fma(w1.R_carrier_left_aux2_z_y, w1.w_carrier_left_z, s8_581);
  const double s8_583 = I_wheel_front_left_polar*s8_582;
  const double s8_584 = w1.R_carrier_left_aux2_z_y*w1.w_carrier_left_y;
  const double s8_585 = fnma(w1.R_carrier_left_aux2_y_y, w1.w_carrier_left_z, s8_584);

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  const double R_carrier_left_aux1_x_x = w8.cosines[4];
  const double s3_17 = R_carrier_left_aux1_x_x*projection.Rz[6];
  w3.s3_18 = fnma(w1.s1_22, projection.Rz[9], s3_17);
  const double s3_19 = R_carrier_left_aux1_x_x*projection.Rz[7];
  w3.s3_20 = fnma(w1.s1_22, projection.Rz[10], s3_19);
  const double s3_21 = R_carrier_left_aux1_x_x*projection.Rz[8];
  w3.s3_22 = fnma(w1.s1_22, projection.Rz[11], s3_21);
  const double R_carrier_right_aux1_x_x = w8.cosines[10];
  const double s3_23 = R_carrier_right_aux1_x_x*projection.Rz[24];
  w3.s3_24 = fnma(w1.s1_35, projection.Rz[27], s3_23);
  const double s3_25 = R_carrier_right_aux1_x_x*projection.Rz[25];
  w3.s3_26 = fnma(w1.s1_35, projection.Rz[28], s3_25);
  const double s3_27 = R_carrier_right_aux1_x_x*projection.Rz[26];
  w3.s3_28 = fnma(w1.s1_35, projection.Rz[29], s3_27);
  const double s3_29 = w1.R_carrier_left_aux1_z_z*projection.Rz[3];
  const double s3_30 = fma(w1.R_carrier_left_aux1_z_x, projection.Rz[6], s3_29);
  w3.s3_31 = fma(w1.R_carrier_left_aux2_z_y, projection.Rz[9], s3_30);
  const double s3_32 = w1.R_carrier_left_aux1_z_z*projection.Rz[4];
  const double s3_33 = fma(w1.R_carrier_left_aux1_z_x, projection.Rz[7], s3_32);
  w3.s3_34 = fma(w1.R_carrier_left_aux2_z_y, projection.Rz[10], s3_33);
  const double s3_35 = w1.R_carrier_left_aux1_z_z*projection.Rz[5];
  const double s3_36 = fma(w1.R_carrier_left_aux1_z_x, projection.Rz[8], s3_35);
  w3.s3_37 = fma(w1.R_carrier_left_aux2_z_y, projection.Rz[11], s3_36);
  const double s3_38 = w1.R_carrier_left_aux1_y_z*projection.Rz[3];
  const double s3_39 = fma(w1.R_carrier_left_aux1_y_x, projection.Rz[6], s3_38);
  w3.s3_40 = fma(w1.R_carrier_left_aux2_y_y, projection.Rz[9], s3_39);
  const double s3_41 = w1.R_carrier_left_aux1_y_z*projection.Rz[4];
  const double s3_42 = fma(w1.R_carrier_left_aux1_y_x, projection.Rz[7], s3_41);
  w3.s3_43 = fma(w1.R_carrier_left_aux2_y_y, projection.Rz[10], s3_42);
  const double s3_44 = w1.R_carrier_left_aux1_y_z*projection.Rz[5];
  const double s3_45 = fma(w1.R_carrier_left_aux1_y_x, projection.Rz[8], s3_44);
  w3.s3_46 = fma(w1.R_carrier_left_aux2_y_y, projection.Rz[11], s3_45);
  const double s3_47 = w1.R_carrier_right_aux1_z_z*projection.Rz[21];
  const double s3_48 = fma(w1.R_carrier_right_aux1_z_x, projection.Rz[24], s3_47);
  w3.s3_49 = fma(w1.R_carrier_right_aux2_z_y, projection.Rz[27], s3_48);
  const double s3_50 = w1.R_carrier_right_aux1_z_z*projection.Rz[22];
  const double s3_51 = fma(w1.R_carrier_right_aux1_z_x, projection.Rz[25], s3_50);
  w3.s3_52 = fma(w1.R_carrier_right_aux2_z_y, projection.Rz[28], s3_51);
  const double s3_53 = w1.R_carrier_right_aux1_z_z*projection.Rz[23];
  const double s3_54 = fma(w1.R_carrier_right_aux1_z_x, projection.Rz[26], s3_53);
  w3.s3_55 = fma(w1.R_carrier_right_aux2_z_y, projection.Rz[29], s3_54);
  const double s3_56 = w1.R_carrier_right_aux1_y_z*projection.Rz[21];
  const double s3_57 = fma(w1.R_carrier_right_aux1_y_x, projection.Rz[24], s3_56);
  w3.s3_58 = fma(w1.R_carrier_right_aux2_y_y, projection.Rz[27], s3_57);
  const double s3_59 = w1.R_carrier_right_aux1_y_z*projection.Rz[22];
  const double s3_60 = fma(w1.R_carrier_right_aux1_y_x, projection.Rz[25], s3_59);
  w3.s3_61 = fma(w1.R_carrier_right_aux2_y_y, projection.Rz[28], s3_60);
  const double s3_62 = w1.R_carrier_right_aux1_y_z*projection.Rz[23];
  const double s3_63 = fma(w1.R_carrier_right_aux1_y_x, projection.Rz[26], s3_62);
  w3.s3_64 = fma(w1.R_carrier_right_aux2_y_y, projection.Rz[29], s3_63);
  // operations: 30 add, 48 multiply

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  w3.s6_16 = zd_lower_arm_left*zd_lower_arm_left;
  w3.s6_17 = w1.s1_18*w3.s6_16;
  w3.s6_18 = w1.s1_20*w3.s6_16;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  w3.s6_19 = zd_lower_arm_right*zd_lower_arm_right;
  w3.s6_20 = w1.s1_32*w3.s6_19;
  w3.s6_21 = fma(w1.s4_13, w1.s4_43, w1.s4_11*w1.s4_30);
  w3.s6_22 = fma(w1.s4_21, w1.s4_47, w1.s4_19*w1.s4_34);
  w3.s6_23 = fnma(w1.s4_12, w1.s4_30, w1.s4_13*w1.s4_32);
  w3.s6_24 = fnma(w1.s4_7, w1.s4_9, w1.s4_6*w1.s4_10);
  w3.s6_25 = fnma(w1.s4_20, w1.s4_34, w1.s4_21*w1.s4_36);
  w3.s6_26 = fnma(w1.s4_15, w1.s4_17, w1.s4_14*w1.s4_18);
  w3.s6_27 = fma(w1.s4_12, w1.s4_43, w1.s4_11*w1.s4_32);
  w3.s6_28 = fnma(w1.s4_6, w1.s4_8, zd_lower_arm_left*w1.s4_9);
  const double s6_29 = w1.R_carrier_left_aux1_z_z*projection.zdd_star[1];
  const double s6_30 = fma(w1.R_carrier_left_aux1_z_x, projection.zdd_star[2], s6_29);
  const double s6_31 = fma(w1.R_carrier_left_aux2_z_y, projection.zdd_star[3], s6_30);
  w3.s6_32 = fma(zd_lower_arm_left, w1.s4_6, w3.s6_28 + (w3.s6_27 + s6_31));
  w3.s6_33 = fma(w1.s4_20, w1.s4_47, w1.s4_19*w1.s4_36);
  w3.s6_34 = fnma(w1.s4_14, w1.s4_16, zd_lower_arm_right*w1.s4_17);
  const double s6_35 = w1.R_carrier_right_aux1_z_z*projection.zdd_star[7];
  const double s6_36 = fma(w1.R_carrier_right_aux1_z_x, projection.zdd_star[8], s6_35);
  const double s6_37 = fma(w1.R_carrier_right_aux2_z_y, projection.zdd_star[9], s6_36);
  w3.s6_38 = fma(zd_lower_arm_right, w1.s4_14, w3.s6_34 + (w3.s6_33 + s6_37));
  w3.s6_39 = fnma(zd_lower_arm_left, w1.s4_10, w1.s4_7*w1.s4_8);
  const double s6_40 = w1.R_carrier_left_aux1_y_z*projection.zdd_star[1];
  const double s6_41 = fma(w1.R_carrier_left_aux1_y_x, projection.zdd_star[2], s6_40);
  const double s6_42 = fma(w1.R_carrier_left_aux2_y_y, projection.zdd_star[3], s6_41);
  w3.s6_43 = w3.s6_39 + (fnma(zd_lower_arm_left, w1.s4_7, s6_42) - w3.s6_21);
  w3.s6_44 = fnma(zd_lower_arm_right, w1.s4_18, w1.s4_15*w1.s4_16);
  const double s6_45 = w1.R_carrier_right_aux1_y_z*projection.zdd_star[7];
  const double s6_46 = fma(w1.R_carrier_right_aux1_y_x, projection.zdd_star[8], s6_45);
  const double s6_47 = fma(w1.R_carrier_right_aux2_y_y, projection.zdd_star[9], s6_46);
  w3.s6_48 = w3.s6_44 + (fnma(zd_lower_arm_right, w1.s4_15, s6_47) - w3.s6_22);
  // operations: 32 add, 45 multiply

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  const double R_lower_arm_left_y_y = w8.cosines[3];
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = w8.sines[3];
  const double s7_53 = h_lower_arm_left_y*R_lower_arm_left_y_y;
  w3.s7_54 = fnma(h_lower_arm_left_z, R_lower_arm_left_z_y, s7_53);
  const double s7_55 = h_lower_arm_left_y*R_lower_arm_left_z_y;
  w3.s7_56 = fma(h_lower_arm_left_z, R_lower_arm_left_y_y, s7_55);
  const double s7_57 = -K_lower_arm_left_yz*R_lower_arm_left_y_y;
  const double s7_58 = fma(K_lower_arm_left_zz, R_lower_arm_left_z_y, s7_57);
  const double s7_59 = K_lower_arm_left_yy*R_lower_arm_left_y_y;
  const double s7_60 = fnma(K_lower_arm_left_yz, R_lower_arm_left_z_y, s7_59);
  w3.s7_61 = fnma(R_lower_arm_left_y_y, s7_58, R_lower_arm_left_z_y*s7_60);
  w3.s7_62 = fma(R_lower_arm_left_y_y, s7_60, R_lower_arm_left_z_y*s7_58);
  w3.s7_63 = 1.825625 - w3.s7_62;
  const double s7_64 = h_carrier_left_y*w1.R_carrier_left_aux2_z_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_65 = fma(h_carrier_left_x, w1.R_carrier_left_z_x, s7_64);
  w3.s7_66 = fma(h_carrier_left_z, w1.R_carrier_left_z_z, s7_65);
  const double s7_67 = h_carrier_left_y*w1.R_carrier_left_aux2_y_y;
  const double s7_68 = fma(h_carrier_left_x, w1.R_carrier_left_y_x, s7_67);
  w3.s7_69 = fma(h_carrier_left_z, w1.R_carrier_left_y_z, s7_68);
  const double s7_70 = fnma(h_carrier_left_y, w1.s1_22, h_carrier_left_z*w1.R_carrier_left_x_z);
  w3.s7_71 = fma(h_carrier_left_x, w1.R_carrier_left_x_x, s7_70);
  const double s7_72 = K_carrier_left_xy*w1.R_carrier_left_x_x;
  const double s7_73 = fnma(K_carrier_left_yy, w1.s1_22, s7_72);
  const double s7_74 = fma(K_carrier_left_yz, w1.R_carrier_left_x_z, s7_73);
  const double s7_75 = K_carrier_left_yy*w1.R_carrier_left_aux2_y_y;
  const double s7_76 = fma(K_carrier_left_xy, w1.R_carrier_left_y_x, s7_75);
  const double s7_77 = fma(K_carrier_left_yz, w1.R_carrier_left_y_z, s7_76);
  const double s7_78 = K_carrier_left_yz*w1.R_carrier_left_aux2_y_y;
  const double s7_79 = fma(K_carrier_left_xz, w1.R_carrier_left_y_x, s7_78);
  const double s7_80 = fma(K_carrier_left_zz, w1.R_carrier_left_y_z, s7_79);
  const double s7_81 = K_carrier_left_xy*w1.R_carrier_left_aux2_y_y;
  const double s7_82 = fma(K_carrier_left_xx, w1.R_carrier_left_y_x, s7_81);
  const double s7_83 = fma(K_carrier_left_xz, w1.R_carrier_left_y_z, s7_82);
  const double s7_84 = fma(w1.R_carrier_left_z_z, s7_80, w1.R_carrier_left_aux2_z_y*s7_77);
  w3.s7_85 = fma(w1.R_carrier_left_z_x, s7_83, s7_84);
  const double s7_86 = K_carrier_left_zz*w1.R_carrier_left_x_z;
  const double s7_87 = fnma(K_carrier_left_yz, w1.s1_22, s7_86);
  const double s7_88 = fma(K_carrier_left_xz, w1.R_carrier_left_x_x, s7_87);
  const double s7_89 = K_carrier_left_xx*w1.R_carrier_left_x_x;
  const double s7_90 = fnma(K_carrier_left_xy, w1.s1_22, s7_89);
  const double s7_91 = fma(K_carrier_left_xz, w1.R_carrier_left_x_z, s7_90);
  const double s7_92 = fma(w1.R_carrier_left_z_z, s7_88, w1.R_carrier_left_aux2_z_y*s7_74);
  w3.s7_93 = fma(w1.R_carrier_left_z_x, s7_91, s7_92);
  const double s7_94 = fma(w1.R_carrier_left_y_z, s7_88, w1.R_carrier_left_aux2_y_y*s7_74);
  w3.s7_95 = fma(w1.R_carrier_left_y_x, s7_91, s7_94);
  const double s7_96 = fnma(w1.s1_22, s7_74, w1.R_carrier_left_x_z*s7_88);
  w3.s7_97 = fma(w1.R_carrier_left_x_x, s7_91, s7_96);
  w3.s7_98 = K_carrier_left_trace - w3.s7_97;
  const double s7_99 = fma(w1.R_carrier_left_y_z, s7_80, w1.R_carrier_left_aux2_y_y*s7_77);
  w3.s7_100 = fma(w1.R_carrier_left_y_x, s7_83, s7_99);
  w3.s7_101 = w3.s7_98 - w3.s7_100;
  const double R_upper_arm_left_y_y = w8.cosines[7];
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = w8.sines[7];
  const double s7_102 = h_upper_arm_left_y*R_upper_arm_left_y_y;
  w3.s7_103 = fnma(h_upper_arm_left_z, R_upper_arm_left_z_y, s7_102);
  const double s7_104 = h_upper_arm_left_y*R_upper_arm_left_z_y;
  w3.s7_105 = fma(h_upper_arm_left_z, R_upper_arm_left_y_y, s7_104);
  const double s7_106 = -K_upper_arm_left_yz*R_upper_arm_left_y_y;
  const double s7_107 = fma(K_upper_arm_left_zz, R_upper_arm_left_z_y, s7_106);
  const double s7_108 = K_upper_arm_left_yy*R_upper_arm_left_y_y;
  const double s7_109 = fnma(K_upper_arm_left_yz, R_upper_arm_left_z_y, s7_108);
  w3.s7_110 = fnma(R_upper_arm_left_y_y, s7_107, R_upper_arm_left_z_y*s7_109);
  w3.s7_111 = fma(R_upper_arm_left_y_y, s7_109, R_upper_arm_left_z_y*s7_107);
  w3.s7_112 = 0.539 - w3.s7_111;
  const double R_arb_front_left_x_x = w8.cosines[8];
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = w8.sines[8];
  const double s7_113 = K_arb_front_left_yz*R_arb_front_left_x_x;
  w3.s7_114 = fnma(K_arb_front_left_xy, R_arb_front_left_x_z, s7_113);
  const double s7_115 = h_arb_front_left_z*R_arb_front_left_x_x;
  w3.s7_116 = fnma(h_arb_front_left_x, R_arb_front_left_x_z, s7_115);
  const double s7_117 = K_arb_front_left_yz*R_arb_front_left_x_z;
  w3.s7_118 = fma(K_arb_front_left_xy, R_arb_front_left_x_x, s7_117);
  const double s7_119 = h_arb_front_left_z*R_arb_front_left_x_z;
  w3.s7_120 = fma(h_arb_front_left_x, R_arb_front_left_x_x, s7_119);
  const double s7_121 = K_arb_front_left_zz*R_arb_front_left_x_z;
  const double s7_122 = fma(K_arb_front_left_xz, R_arb_front_left_x_x, s7_121);
  const double s7_123 = K_arb_front_left_xx*R_arb_front_left_x_x;
  const double s7_124 = fma(K_arb_front_left_xz, R_arb_front_left_x_z, s7_123);
  w3.s7_125 = fnma(R_arb_front_left_x_z, s7_124, R_arb_front_left_x_x*s7_122);
  w3.s7_126 = fma(R_arb_front_left_x_x, s7_124, R_arb_front_left_x_z*s7_122);
  w3.s7_127 = 0.3477 - w3.s7_126;
  const double R_lower_arm_right_z_y = w8.sines[9];
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_y_y = w8.cosines[9];
  const double s7_128 = -h_lower_arm_right_z*R_lower_arm_right_z_y;
  w3.s7_129 = fma(h_lower_arm_right_y, R_lower_arm_right_y_y, s7_128);
  const double s7_130 = -h_lower_arm_right_z*R_lower_arm_right_y_y;
  w3.s7_131 = fnma(h_lower_arm_right_y, R_lower_arm_right_z_y, s7_130);
  const double s7_132 = K_lower_arm_right_yy*R_lower_arm_right_y_y;
  const double s7_133 = fnma(K_lower_arm_right_yz, R_lower_arm_right_z_y, s7_132);
  const double s7_134 = K_lower_arm_right_yz*R_lower_arm_right_y_y;
  const double s7_135 = fnma(K_lower_arm_right_zz, R_lower_arm_right_z_y, s7_134);
  w3.s7_136 = fma(R_lower_arm_right_y_y, s7_135, R_lower_arm_right_z_y*s7_133);
  w3.s7_137 = fnma(R_lower_arm_right_z_y, s7_135, R_lower_arm_right_y_y*s7_133);
  w3.s7_138 = 1.825625 - w3.s7_137;
  const double s7_139 = -h_carrier_right_y*w1.s1_35;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_140 = fma(h_carrier_right_x, w1.R_carrier_right_x_x, s7_139);
  w3.s7_141 = fma(h_carrier_right_z, w1.R_carrier_right_x_z, s7_140);
  const double s7_142 = h_carrier_right_z*w1.R_carrier_right_z_z;
  const double s7_143 = fma(h_carrier_right_y, w1.R_carrier_right_aux2_z_y, s7_142);
  w3.s7_144 = fma(h_carrier_right_x, w1.R_carrier_right_z_x, s7_143);
  const double s7_145 = h_carrier_right_z*w1.R_carrier_right_y_z;
  const double s7_146 = fma(h_carrier_right_y, w1.R_carrier_right_aux2_y_y, s7_145);
  w3.s7_147 = fma(h_carrier_right_x, w1.R_carrier_right_y_x, s7_146);
  const double s7_148 = K_carrier_right_yy*w1.s1_35;
  const double s7_149 = fnma(K_carrier_right_xy, w1.R_carrier_right_x_x, s7_148);
  const double s7_150 = fnma(K_carrier_right_yz, w1.R_carrier_right_x_z, s7_149);
  const double s7_151 = K_carrier_right_yy*w1.R_carrier_right_aux2_y_y;
  const double s7_152 = fma(K_carrier_right_xy, w1.R_carrier_right_y_x, s7_151);
  const double s7_153 = fma(K_carrier_right_yz, w1.R_carrier_right_y_z, s7_152);
  const double s7_154 = K_carrier_right_zz*w1.R_carrier_right_y_z;
  const double s7_155 = fma(K_carrier_right_yz, w1.R_carrier_right_aux2_y_y, s7_154);
  const double s7_156 = fma(K_carrier_right_xz, w1.R_carrier_right_y_x, s7_155);
  const double s7_157 = K_carrier_right_xx*w1.R_carrier_right_y_x;
  const double s7_158 = fma(K_carrier_right_xy, w1.R_carrier_right_aux2_y_y, s7_157);
  const double s7_159 = fma(K_carrier_right_xz, w1.R_carrier_right_y_z, s7_158);
  const double s7_160 = fma(w1.R_carrier_right_z_z, s7_156, w1.R_carrier_right_aux2_z_y*s7_153);
  w3.s7_161 = fma(w1.R_carrier_right_z_x, s7_159, s7_160);
  const double s7_162 = -K_carrier_right_yz*w1.s1_35;
  const double s7_163 = fma(K_carrier_right_xz, w1.R_carrier_right_x_x, s7_162);
  const double s7_164 = fma(K_carrier_right_zz, w1.R_carrier_right_x_z, s7_163);
  const double s7_165 = -K_carrier_right_xy*w1.s1_35;
  const double s7_166 = fma(K_carrier_right_xx, w1.R_carrier_right_x_x, s7_165);
  const double s7_167 = fma(K_carrier_right_xz, w1.R_carrier_right_x_z, s7_166);
  const double s7_168 = fnma(w1.R_carrier_right_aux2_z_y, s7_150, w1.R_carrier_right_z_z*s7_164);
  w3.s7_169 = fma(w1.R_carrier_right_z_x, s7_167, s7_168);
  const double s7_170 = fnma(w1.R_carrier_right_aux2_y_y, s7_150, w1.R_carrier_right_y_z*s7_164);
  w3.s7_171 = fma(w1.R_carrier_right_y_x, s7_167, s7_170);
  const double s7_172 = fma(w1.R_carrier_right_x_z, s7_164, w1.s1_35*s7_150);
  w4.s7_173 = fma(w1.R_carrier_right_x_x, s7_167, s7_172);
  const double s7_174 = K_carrier_right_trace - w4.s7_173;
  const double s7_175 = fma(w1.R_carrier_right_y_z, s7_156, w1.R_carrier_right_aux2_y_y*s7_153);
  w4.s7_176 = fma(w1.R_carrier_right_y_x, s7_159, s7_175);
  w4.s7_177 = s7_174 - w4.s7_176;
  const double R_upper_arm_right_z_y = w8.sines[13];
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_y_y = w8.cosines[13];
  const double s7_178 = -h_upper_arm_right_z*R_upper_arm_right_z_y;
  w4.s7_179 = fma(h_upper_arm_right_y, R_upper_arm_right_y_y, s7_178);
  const double s7_180 = -h_upper_arm_right_z*R_upper_arm_right_y_y;
  w4.s7_181 = fnma(h_upper_arm_right_y, R_upper_arm_right_z_y, s7_180);
  const double s7_182 = K_upper_arm_right_yy*R_upper_arm_right_y_y;
  const double s7_183 = fnma(K_upper_arm_right_yz, R_upper_arm_right_z_y, s7_182);
  const double s7_184 = K_upper_arm_right_yz*R_upper_arm_right_y_y;
  const double s7_185 = fnma(K_upper_arm_right_zz, R_upper_arm_right_z_y, s7_184);
  w4.s7_186 = fma(R_upper_arm_right_y_y, s7_185, R_upper_arm_right_z_y*s7_183);
  w4.s7_187 = fnma(R_upper_arm_right_z_y, s7_185, R_upper_arm_right_y_y*s7_183);
  w4.s7_188 = 0.539 - w4.s7_187;
  const double R_arb_front_right_x_x = w8.cosines[14];
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = w8.sines[14];
  const double s7_189 = h_arb_front_right_z*R_arb_front_right_x_x;
  w4.s7_190 = fnma(h_arb_front_right_x, R_arb_front_right_x_z, s7_189);
  const double s7_191 = h_arb_front_right_z*R_arb_front_right_x_z;
  w4.s7_192 = fma(h_arb_front_right_x, R_arb_front_right_x_x, s7_191);
  const double s7_193 = K_arb_front_right_xy*R_arb_front_right_x_x;
  w4.s7_194 = fma(K_arb_front_right_yz, R_arb_front_right_x_z, s7_193);
  const double s7_195 = -K_arb_front_right_yz*R_arb_front_right_x_x;
  w4.s7_196 = fma(K_arb_front_right_xy, R_arb_front_right_x_z, s7_195);
  const double s7_197 = K_arb_front_right_zz*R_arb_front_right_x_z;
  const double s7_198 = fma(K_arb_front_right_xz, R_arb_front_right_x_x, s7_197);
  const double s7_199 = K_arb_front_right_xx*R_arb_front_right_x_x;
  const double s7_200 = fma(K_arb_front_right_xz, R_arb_front_right_x_z, s7_199);
  w4.s7_201 = fnma(R_arb_front_right_x_z, s7_200, R_arb_front_right_x_x*s7_198);
  w4.s7_202 = fma(R_arb_front_right_x_x, s7_200, R_arb_front_right_x_z*s7_198);
  w4.s7_203 = 0.3477 - w4.s7_202;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = w8.sines[15];
  w4.s7_204 = -h_pitman_arm_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = w8.cosines[15];
  w4.s7_205 = -h_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_206 = K_pitman_arm_zz*R_pitman_arm_x_z;
  const double s7_207 = K_pitman_arm_xx*R_pitman_arm_x_x;
  w4.s7_208 = fnma(R_pitman_arm_x_z, s7_207, R_pitman_arm_x_x*s7_206);
  w4.s7_209 = fma(R_pitman_arm_x_x, s7_207, R_pitman_arm_x_z*s7_206);
  w4.s7_210 = 0.3504 - w4.s7_209;
  const double R_bell_crank_x_x = w8.cosines[16];
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_y_x = w8.sines[16];
  w4.s7_211 = fma(h_bell_crank_x, R_bell_crank_y_x, h_bell_crank_y*R_bell_crank_x_x);
  const double s7_212 = -K_bell_crank_xy*R_bell_crank_x_x;
  const double s7_213 = fma(K_bell_crank_yy, R_bell_crank_y_x, s7_212);
  w4.s7_214 = fma(h_bell_crank_y, R_bell_crank_y_x, -h_bell_crank_x*R_bell_crank_x_x);
  const double s7_215 = K_bell_crank_xx*R_bell_crank_x_x;
  const double s7_216 = fnma(K_bell_crank_xy, R_bell_crank_y_x, s7_215);
  w4.s7_217 = fnma(R_bell_crank_x_x, s7_213, R_bell_crank_y_x*s7_216);
  w4.s7_218 = fma(R_bell_crank_x_x, s7_216, R_bell_crank_y_x*s7_213);
  w4.s7_219 = 0.9515 - w4.s7_218;
  // operations: 116 add, 184 multiply

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  w4.s8_586 = projection.Rz[0] + w3.s3_18;
  w4.s8_587 = w1.s1_18*projection.Rz[0];
  w4.s8_588 = w1.s1_20*projection.Rz[0];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  w4.s8_589 = projection.Rz[18] + w3.s3_24;
  w4.s8_590 = w1.s1_30*projection.Rz[18];
  w4.s8_591 = w1.s1_32*projection.Rz[18];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  w4.s8_592 = projection.Rz[1] + w3.s3_20;
  w4.s8_593 = w1.s1_18*projection.Rz[1];
  w4.s8_594 = w1.s1_20*projection.Rz[1];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  w4.s8_595 = projection.Rz[19] + w3.s3_26;
  w4.s8_596 = w1.s1_30*projection.Rz[19];
  w4.s8_597 = w1.s1_32*projection.Rz[19];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  w4.s8_598 = projection.Rz[2] + w3.s3_22;
  w4.s8_599 = w1.s1_18*projection.Rz[2];
  w4.s8_600 = w1.s1_20*projection.Rz[2];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  w4.s8_601 = projection.Rz[20] + w3.s3_28;
  w4.s8_602 = w1.s1_30*projection.Rz[20];
  w4.s8_603 = w1.s1_32*projection.Rz[20];
  const double s8_604 = fma(R_carrier_left_aux1_x_x, projection.zdd_star[2],
      projection.zdd_star[0]);
  w4.s8_605 = w3.s6_24 + (w3.s6_23 + fnma(w1.s1_22, projection.zdd_star[3], s8_604));
  const double s8_606 = fma(R_carrier_right_aux1_x_x, projection.zdd_star[8],
      projection.zdd_star[6]);
  w4.s8_607 = w3.s6_26 + (w3.s6_25 + fnma(w1.s1_35, projection.zdd_star[9], s8_606));
  w4.s8_608 = w1.s1_32*projection.zdd_star[6];
  // bell_crank: bell_crank, revolute, chassis
  w4.s8_609 = projection.Rz[39]*w4.s7_211;
  w4.s8_610 = projection.Rz[40]*w4.s7_211;
  w4.s8_611 = projection.Rz[41]*w4.s7_211;
  w4.s8_612 = 0.9515*projection.Rz[39];
  w4.s8_613 = 0.9515*projection.Rz[40];
  w4.s8_614 = 0.9515*projection.Rz[41];
  w4.s8_615 = projection.Rz[39]*w4.s7_214;
  w4.s8_616 = projection.Rz[40]*w4.s7_214;
  w4.s8_617 = projection.Rz[41]*w4.s7_214;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  w4.s8_618 = zd_bell_crank + w2.s8_13;
  const double s8_619 = zd_bell_crank*w4.s8_618;
  w4.s8_620 = fma(p_bell_crank_x, w2.s8_20, -p_bell_crank_z*w2.s8_16);
  w4.s8_621 = zd_bell_crank*w2.s8_12;
  w4.s8_622 = zd_bell_crank*w2.s8_11;
  w4.s8_623 = 33.3125 - w4.s7_214;
  w4.s8_624 = fma(p_bell_crank_z, w2.s8_15, p_bell_crank_x*w2.s8_14);
  w4.s8_625 = fnma(w4.s7_214, w4.s8_621, w4.s7_211*w4.s8_622);
  w4.s8_626 = fnma(projection.zdd_star[13], w4.s7_211, w4.s7_214*s8_619);
  w4.s8_627 = fma(w4.s7_211, s8_619, projection.zdd_star[13]*w4.s7_214);
  w4.s8_628 = w4.s7_218 - w4.s7_219;
  // pitman_arm: pitman_arm, revolute, chassis
  w4.s8_629 = projection.Rz[36]*w4.s7_204;
  w4.s8_630 = projection.Rz[36]*w4.s7_205;
  w4.s8_631 = projection.Rz[37]*w4.s7_204;
  w4.s8_632 = projection.Rz[37]*w4.s7_205;
  w4.s8_633 = projection.Rz[38]*w4.s7_204;
  w4.s8_634 = projection.Rz[38]*w4.s7_205;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  w4.s8_635 = zd_pitman_arm + w2.s8_11;
  const double s8_636 = zd_pitman_arm*w4.s8_635;
  w4.s8_637 = 2.1 + w4.s7_205;
  w4.s8_638 = zd_pitman_arm*w2.s8_12;
  w4.s8_639 = zd_pitman_arm*w2.s8_13;
  w4.s8_640 = 0.3504*projection.Rz[36];
  w4.s8_641 = 0.3504*projection.Rz[37];
  w4.s8_642 = 0.3504*projection.Rz[38];
  w4.s8_643 = fma(w4.s7_205, w4.s8_639, w4.s7_204*w4.s8_638);
  w4.s8_644 = 23.1 - w4.s7_204;
  w4.s8_645 = fma(w4.s7_205, s8_636, projection.zdd_star[12]*w4.s7_204);
  w4.s8_646 = fnma(projection.zdd_star[12], w4.s7_205, w4.s7_204*s8_636);
  const double s8_647 = fnma(p_pitman_arm_z, w2.s8_19, p_pitman_arm_x*w2.s8_16);
  w4.s8_648 = fnma(p_rear_axle_tx_z, w2.s8_15, s8_647);
  const double s8_649 = fma(p_pitman_arm_z, w2.s8_16, p_pitman_arm_y*w2.s8_14);
  w4.s8_650 = fnma(p_pitman_arm_x, w2.s8_20, s8_649);
  w4.s8_651 = w4.s7_210 - w4.s7_209;
  // arb_front_right: arb_front_right, revolute, chassis
  w4.s8_652 = projection.Rz[33]*w4.s7_192;
  w4.s8_653 = projection.Rz[34]*w4.s7_192;
  w4.s8_654 = projection.Rz[35]*w4.s7_192;
  w4.s8_655 = projection.Rz[33]*w4.s7_190;
  w4.s8_656 = projection.Rz[34]*w4.s7_190;
  w4.s8_657 = projection.Rz[35]*w4.s7_190;
  const double s8_658 = fma(p_arb_front_right_x, w2.s8_20, -p_rear_axle_tx_z*w2.s8_16);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  w4.s8_659 = zd_arb_front_right*(zd_arb_front_right + w2.s8_11);
  w4.s8_660 = w4.s7_190 - 2.25;
  w4.s8_661 = zd_arb_front_right*w2.s8_13;
  w4.s8_662 = 0.3477*projection.Rz[33];
  w4.s8_663 = 0.3477*projection.Rz[34];
  w4.s8_664 = 0.3477*projection.Rz[35];
  w4.s8_665 = zd_arb_front_right*w2.s8_12;
  w4.s8_666 = fma(w4.s7_192, w4.s8_665, w4.s7_190*w4.s8_661);
  w4.s8_667 = fnma(p_arb_front_right_y, w2.s8_14, s8_658);
  w4.s8_668 = 17.775 + w4.s7_192;
  w4.s8_669 = fnma(w4.s7_192, w4.s8_659, projection.zdd_star[11]*w4.s7_190);
  w4.s8_670 = fma(w4.s7_190, w4.s8_659, projection.zdd_star[11]*w4.s7_192);
  const double s8_671 = fnma(p_rear_axle_tx_z, w2.s8_19, p_arb_front_right_x*w2.s8_16);
  w4.s8_672 = fma(p_arb_front_right_y, w2.s8_15, s8_671);
  w4.s8_673 = w4.s7_203 - w4.s7_202;
  // upper_arm_right: upper_arm_right, revolute, chassis
  w4.s8_674 = projection.Rz[30]*w4.s7_181;
  w4.s8_675 = projection.Rz[31]*w4.s7_181;
  w4.s8_676 = projection.Rz[32]*w4.s7_181;
  w4.s8_677 = 2.1 + w4.s7_181;
  w4.s8_678 = 0.539*projection.Rz[30];
  w4.s8_679 = 0.539*projection.Rz[31];
  w4.s8_680 = 0.539*projection.Rz[32];
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s8_681 = zd_upper_arm_right*(zd_upper_arm_right + w2.s8_12);
  w4.s8_682 = w4.s7_179 - 3.75;
  w4.s8_683 = zd_upper_arm_right*w2.s8_13;
  w4.s8_684 = zd_upper_arm_right*w2.s8_11;
  w4.s8_685 = fnma(w4.s7_181, w4.s8_683, w4.s7_179*w4.s8_684);
  w4.s8_686 = fnma(w4.s7_179, s8_681, projection.zdd_star[10]*w4.s7_181);
  w4.s8_687 = fma(w4.s7_181, s8_681, projection.zdd_star[10]*w4.s7_179);
  const double s8_688 = p_upper_arm_right_x*w2.s8_14;
  const double s8_689 = fma(p_upper_arm_right_z, w2.s8_15, s8_688);
  w4.s8_690 = fma(p_pitman_arm_y, w2.s8_21, s8_689);
  const double s8_691 = p_upper_arm_right_x*w2.s8_16;
  const double s8_692 = fnma(p_upper_arm_right_z, w2.s8_19, s8_691);
  w4.s8_693 = fma(p_rear_axle_tx_z, w2.s8_15, s8_692);
  w4.s8_694 = w4.s7_187 - w4.s7_188;
  const double s8_695 = fnma(w1.s4_50, w2.s8_13, w1.s4_49*w2.s8_11);
  const double s8_696 = fma(w1.r_carrier_right_aux1_y, w2.s8_14, s8_695);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_697 = fnma(p_upper_arm_right_x, w2.s8_20, fnma(w1.s1_33, w2.s8_16, s8_696));
  w4.s8_698 = fnma(w1.w_chassis_y, w1.s4_48, w1.w_chassis_x*w1.s4_37);
  const double s8_699 = w3.s6_38 + w4.s8_698;
  const double s8_700 = fms(w1.w_carrier_right_x, w1.w_carrier_right_y, s8_699);
  w4.s8_701 = fnma(w1.w_chassis_x, w1.s4_35, w1.w_chassis_z*w1.s4_48);
  const double s8_702 = w3.s6_48 + w4.s8_701;
  const double s8_703 = fma(w1.w_carrier_right_x, w1.w_carrier_right_z, s8_702);
  const double s8_704 = w1.w_carrier_right_y*w1.w_carrier_right_y;
  const double s8_705 = w1.w_carrier_right_z*w1.w_carrier_right_z;
  const double s8_706 = s8_704 + s8_705;
  const double s8_707 = fma(w3.s7_144, s8_703, fma(w3.s7_147, s8_700, m_carrier_right*s8_697));
  w4.f_carrier_right_x = fnma(w3.s7_141, s8_706, s8_707);
  const double s8_708 = fnma(w1.s1_33, w2.s8_15, fnma(w1.s4_49, w2.s8_12, w4.s8_608));
  const double s8_709 = fnma(w1.r_carrier_right_aux1_y, w2.s8_21, s8_708);
  const double s8_710 = s8_688 + fnma(w1.s1_30, w3.s6_19, s8_709);
  const double s8_711 = fma(w1.w_carrier_right_x, w1.w_carrier_right_y, s8_699);
  w4.s8_712 = fnma(w1.w_chassis_z, w1.s4_37, w1.w_chassis_y*w1.s4_35);
  const double s8_713 = w4.s8_607 + w4.s8_712;
  const double s8_714 = fms(w1.w_carrier_right_y, w1.w_carrier_right_z, s8_713);
  const double s8_715 = fma(w1.w_carrier_right_x, w1.w_carrier_right_x, s8_705);
  const double s8_716 = fma(w3.s7_144, s8_714, fma(w3.s7_141, s8_711, m_carrier_right*s8_710));
  w4.f_carrier_right_y = fnma(w3.s7_147, s8_715, s8_716);
  const double s8_717 = fma(w1.r_carrier_right_aux1_y, w2.s8_15, w1.s4_50*w2.s8_12);
  const double s8_718 = w3.s6_20 + fma(w1.s1_33, w2.s8_19, s8_717);
  const double s8_719 = s8_691 + fma(w1.s1_30, projection.zdd_star[6], s8_718);
  const double s8_720 = fma(w1.w_carrier_right_y, w1.w_carrier_right_z, s8_713);
  const double s8_721 = fms(w1.w_carrier_right_x, w1.w_carrier_right_z, s8_702);
  const double s8_722 = fma(w1.w_carrier_right_x, w1.w_carrier_right_x, s8_704);
  const double s8_723 = fma(w3.s7_141, s8_721, fma(w3.s7_147, s8_720, m_carrier_right*s8_719));
  w4.f_carrier_right_z = fnma(w3.s7_144, s8_722, s8_723);
  const double tau_wheel_front_right = tau[Coordinate::wheel_front_right];
  const double s8_724 = fnma(w1.s1_35, tau_wheel_front_right, s8_573*s8_575);
  const double s8_725 = fnma(w3.s7_169, s8_711, fnma(w3.s7_144, s8_710, s8_724));
  const double s8_726 = fma(w3.s7_147, s8_719, fnma(w4.s7_177, s8_714, s8_725));
  const double s8_727 = fma(w3.s7_171, s8_721, fma(w4.s7_176, s8_720, s8_726));
  w4.n_carrier_right_x = fma(w3.s7_161, s8_715 - s8_722, s8_727);
  const double s8_728 = fnma(s8_567, s8_573, w1.R_carrier_right_aux2_y_y*tau_wheel_front_right);
  const double s8_729 = fma(w3.s7_161, s8_700, fma(w3.s7_144, s8_697, s8_728));
  const double s8_730 = fnma(w3.s7_141, s8_719, fma(w4.s7_177, s8_703, s8_729));
  const double s8_731 = fnma(w4.s7_173, s8_721, fnma(w3.s7_171, s8_720, s8_730));
  w5.n_carrier_right_y = fma(w3.s7_169, s8_722 - s8_706, s8_731);
  const double s8_732 = fma(s8_569, s8_573, w1.R_carrier_right_aux2_z_y*tau_wheel_front_right);
  const double s8_733 = fnma(w4.s7_176, s8_700, fnma(w3.s7_147, s8_697, s8_732));
  const double s8_734 = fma(w3.s7_141, s8_710, fnma(w3.s7_161, s8_703, s8_733));
  const double s8_735 = fma(w3.s7_169, s8_714, fma(w4.s7_173, s8_711, s8_734));
  w5.n_carrier_right_z = fma(w3.s7_171, s8_706 - s8_715, s8_735);
  const double s8_736 = K_carrier_right_trace - w4.s7_176;
  const double s8_737 = K_carrier_right_trace - w4.s7_177;
  w5.s8_738 = w1.s1_33 + w1.s1_33;
  w5.s8_739 = fnma(w3.s3_49, w3.s7_147, w3.s3_58*w3.s7_144);
  w5.s8_740 = fnma(w3.s3_52, w3.s7_147, w3.s3_61*w3.s7_144);
  w5.s8_741 = fnma(w3.s3_55, w3.s7_147, w3.s3_64*w3.s7_144);
  const double s8_742 = fnma(w3.s3_58, w3.s7_141, w3.s7_147*w4.s8_589);
  w5.s8_743 = fma(m_carrier_right, w4.s8_590, s8_742);
  const double s8_744 = fnma(w3.s3_61, w3.s7_141, w3.s7_147*w4.s8_595);
  w5.s8_745 = fma(m_carrier_right, w4.s8_596, s8_744);
  const double s8_746 = fnma(w3.s3_64, w3.s7_141, w3.s7_147*w4.s8_601);
  w5.s8_747 = fma(m_carrier_right, w4.s8_602, s8_746);
  const double s8_748 = fnma(w3.s7_144, w4.s8_589, w3.s3_49*w3.s7_141);
  w5.s8_749 = fma(m_carrier_right, w4.s8_591, s8_748);
  const double s8_750 = fnma(w3.s7_144, w4.s8_595, w3.s3_52*w3.s7_141);
  w5.s8_751 = fma(m_carrier_right, w4.s8_597, s8_750);
  const double s8_752 = fnma(w3.s7_144, w4.s8_601, w3.s3_55*w3.s7_141);
  w5.s8_753 = fma(m_carrier_right, w4.s8_603, s8_752);
  w5.s8_754 = 395.1 + w3.s7_141;
  w5.s8_755 = fma(109.75, w1.r_carrier_right_aux1_y, w3.s7_147);
  w5.s8_756 = fnma(109.75, w1.s1_33, w3.s7_144);
  const double s8_757 = fnma(w3.s3_58, w3.s7_161, w3.s7_141*w4.s8_591);
  w5.s8_758 = fma(w3.s3_49, s8_737, fnma(w3.s7_169, w4.s8_589, s8_757));
  const double s8_759 = fnma(w3.s3_61, w3.s7_161, w3.s7_141*w4.s8_597);
  w5.s8_760 = fma(w3.s3_52, s8_737, fnma(w3.s7_169, w4.s8_595, s8_759));
  const double s8_761 = fnma(w3.s3_64, w3.s7_161, w3.s7_141*w4.s8_603);
  w5.s8_762 = fma(w3.s3_55, s8_737, fnma(w3.s7_169, w4.s8_601, s8_761));
  const double s8_763 = fnma(w3.s7_171, w4.s8_589, fnma(w3.s3_49, w3.s7_161, w3.s3_58*s8_736));
  w5.s8_764 = fnma(w3.s7_141, w4.s8_590, s8_763);
  const double s8_765 = fnma(w3.s7_171, w4.s8_595, fnma(w3.s3_52, w3.s7_161, w3.s3_61*s8_736));
  w5.s8_766 = fnma(w3.s7_141, w4.s8_596, s8_765);
  const double s8_767 = fnma(w3.s7_171, w4.s8_601, fnma(w3.s3_55, w3.s7_161, w3.s3_64*s8_736));
  w5.s8_768 = fnma(w3.s7_141, w4.s8_602, s8_767);
  const double s8_769 = fnma(w3.s3_58, w3.s7_171, fnma(w3.s3_49, w3.s7_169, s7_174*w4.s8_589));
  w5.s8_770 = fnma(w3.s7_144, w4.s8_591, fma(w3.s7_147, w4.s8_590, s8_769));
  const double s8_771 = fnma(w3.s3_61, w3.s7_171, fnma(w3.s3_52, w3.s7_169, s7_174*w4.s8_595));
  w5.s8_772 = fnma(w3.s7_144, w4.s8_597, fma(w3.s7_147, w4.s8_596, s8_771));
  const double s8_773 = fnma(w3.s3_64, w3.s7_171, fnma(w3.s3_55, w3.s7_169, s7_174*w4.s8_601));
  w5.s8_774 = fnma(w3.s7_144, w4.s8_603, fma(w3.s7_147, w4.s8_602, s8_773));
  w5.s8_775 = w1.r_carrier_right_aux1_y + w1.r_carrier_right_aux1_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  w5.s8_776 = projection.Rz[18]*w3.s7_129;
  w5.s8_777 = projection.Rz[19]*w3.s7_129;
  w5.s8_778 = projection.Rz[20]*w3.s7_129;
  w5.s8_779 = projection.Rz[18]*w3.s7_131;
  w5.s8_780 = projection.Rz[19]*w3.s7_131;
  w5.s8_781 = projection.Rz[20]*w3.s7_131;
  w5.s8_782 = 1.825625*projection.Rz[18];
  w5.s8_783 = 1.825625*projection.Rz[19];
  w5.s8_784 = 1.825625*projection.Rz[20];
  const double s8_785 = fma(zd_lower_arm_right, w2.s8_12, w3.s6_19);
  w5.s8_786 = 7.75 + w3.s7_131;
  w5.s8_787 = zd_lower_arm_right*w2.s8_13;
  w5.s8_788 = zd_lower_arm_right*w2.s8_11;
  w5.s8_789 = fnma(w3.s7_131, w5.s8_787, w3.s7_129*w5.s8_788);
  w5.s8_790 = w3.s7_129 - 5.0;
  w5.s8_791 = fnma(w3.s7_129, s8_785, projection.zdd_star[6]*w3.s7_131);
  w5.s8_792 = fma(w3.s7_131, s8_785, projection.zdd_star[6]*w3.s7_129);
  w5.s8_793 = fma(p_lower_arm_right_z, w2.s8_15, s8_688);
  w5.s8_794 = fnma(p_lower_arm_right_y, w2.s8_21, w5.s8_793);
  w5.s8_795 = fnma(p_lower_arm_right_z, w2.s8_19, s8_691);
  w5.s8_796 = fma(p_pitman_arm_z, w2.s8_15, w5.s8_795);
  w5.s8_797 = w3.s7_137 - w3.s7_138;
  // arb_front_left: arb_front_left, revolute, chassis
  w5.s8_798 = w3.s7_116 - 2.25;
  w5.s8_799 = 0.3477*projection.Rz[15];
  w5.s8_800 = 0.3477*projection.Rz[16];
  w5.s8_801 = 0.3477*projection.Rz[17];
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  w5.s8_802 = zd_arb_front_left*(zd_arb_front_left + w2.s8_11);
  w5.s8_803 = 17.775 + w3.s7_120;
  w5.s8_804 = zd_arb_front_left*w2.s8_13;
  w5.s8_805 = zd_arb_front_left*w2.s8_12;
  w5.s8_806 = fma(w3.s7_120, w5.s8_805, w3.s7_116*w5.s8_804);
  w5.s8_807 = fnma(w3.s7_120, w5.s8_802, projection.zdd_star[5]*w3.s7_116);
  w5.s8_808 = fms(-p_arb_front_right_y, w2.s8_14, s8_658);
  w5.s8_809 = fma(w3.s7_116, w5.s8_802, projection.zdd_star[5]*w3.s7_120);
  w5.s8_810 = fnma(p_arb_front_right_y, w2.s8_15, s8_671);
  w5.s8_811 = w3.s7_127 - w3.s7_126;
  // upper_arm_left: upper_arm_left, revolute, chassis
  w5.s8_812 = 0.539*projection.Rz[12];
  w5.s8_813 = 0.539*projection.Rz[13];
  w5.s8_814 = 0.539*projection.Rz[14];
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s8_815 = zd_upper_arm_left*(zd_upper_arm_left + w2.s8_12);
  w5.s8_816 = 3.75 + w3.s7_103;
  w5.s8_817 = zd_upper_arm_left*w2.s8_11;
  w5.s8_818 = w3.s7_105 - 2.1;
  w5.s8_819 = zd_upper_arm_left*w2.s8_13;
  w5.s8_820 = fma(w3.s7_105, w5.s8_819, w3.s7_103*w5.s8_817);
  w5.s8_821 = fnma(w3.s7_105, s8_815, projection.zdd_star[4]*w3.s7_103);
  w5.s8_822 = fnma(p_rear_axle_tx_z, w2.s8_15, s8_692);
  w5.s8_823 = fma(w3.s7_103, s8_815, projection.zdd_star[4]*w3.s7_105);
  w5.s8_824 = fnma(p_pitman_arm_y, w2.s8_21, s8_689);
  w5.s8_825 = w3.s7_111 - w3.s7_112;
  const double s8_826 = fma(w1.s4_46, w2.s8_13, w1.s4_45*w2.s8_11);
  const double s8_827 = fma(w1.r_carrier_left_aux1_y, w2.s8_14, s8_826);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_828 = fma(w1.r_carrier_left_aux1_z, w2.s8_16, s8_827);
  const double s8_829 = fnma(p_upper_arm_right_x, w2.s8_20, s8_828);
  w5.s8_830 = fnma(w1.w_chassis_y, w1.s4_44, w1.w_chassis_x*w1.s4_33);
  const double s8_831 = w3.s6_32 + w5.s8_830;
  const double s8_832 = fms(w1.w_carrier_left_x, w1.w_carrier_left_y, s8_831);
  w5.s8_833 = fnma(w1.w_chassis_x, w1.s4_31, w1.w_chassis_z*w1.s4_44);
  const double s8_834 = w3.s6_43 + w5.s8_833;
  const double s8_835 = fma(w1.w_carrier_left_x, w1.w_carrier_left_z, s8_834);
  const double s8_836 = w1.w_carrier_left_y*w1.w_carrier_left_y;
  const double s8_837 = w1.w_carrier_left_z*w1.w_carrier_left_z;
  const double s8_838 = s8_836 + s8_837;
  const double s8_839 = fma(w3.s7_66, s8_835, fma(w3.s7_69, s8_832, m_carrier_left*s8_829));
  w5.f_carrier_left_x = fnma(w3.s7_71, s8_838, s8_839);
  const double s8_840 = fnma(w1.s4_45, w2.s8_12, w1.r_carrier_left_aux1_z*w2.s8_15);
  const double s8_841 = fnma(w1.r_carrier_left_aux1_y, w2.s8_21, s8_840) - w3.s6_17;
  const double s8_842 = s8_688 + fnma(w1.s1_20, projection.zdd_star[0], s8_841);
  w5.s8_843 = fnma(w1.w_chassis_z, w1.s4_33, w1.w_chassis_y*w1.s4_31);
  const double s8_844 = w4.s8_605 + w5.s8_843;
  const double s8_845 = fms(w1.w_carrier_left_y, w1.w_carrier_left_z, s8_844);
  const double s8_846 = fma(w1.w_carrier_left_x, w1.w_carrier_left_y, s8_831);
  const double s8_847 = fma(w1.w_carrier_left_x, w1.w_carrier_left_x, s8_837);
  const double s8_848 = fma(w3.s7_71, s8_846, fma(w3.s7_66, s8_845, m_carrier_left*s8_842));
  w5.f_carrier_left_y = fnma(w3.s7_69, s8_847, s8_848);
  const double s8_849 = fnma(w1.s4_46, w2.s8_12, w1.r_carrier_left_aux1_y*w2.s8_15);
  const double s8_850 = fnma(w1.r_carrier_left_aux1_z, w2.s8_19, s8_849) - w3.s6_18;
  const double s8_851 = s8_691 + fma(w1.s1_18, projection.zdd_star[0], s8_850);
  const double s8_852 = fma(w1.w_carrier_left_y, w1.w_carrier_left_z, s8_844);
  const double s8_853 = fms(w1.w_carrier_left_x, w1.w_carrier_left_z, s8_834);
  const double s8_854 = fma(w1.w_carrier_left_x, w1.w_carrier_left_x, s8_836);
  const double s8_855 = fma(w3.s7_71, s8_853, fma(w3.s7_69, s8_852, m_carrier_left*s8_851));
  w5.f_carrier_left_z = fnma(w3.s7_66, s8_854, s8_855);
  const double tau_wheel_front_left = tau[Coordinate::wheel_front_left];
  const double s8_856 = fnma(w1.s1_22, tau_wheel_front_left, s8_583*s8_585);
  const double s8_857 = fnma(w3.s7_101, s8_845, fnma(w3.s7_66, s8_842, s8_856));
  const double s8_858 = fma(w3.s7_69, s8_851, fnma(w3.s7_93, s8_846, s8_857));
  const double s8_859 = fma(w3.s7_95, s8_853, fma(w3.s7_100, s8_852, s8_858));
  w5.n_carrier_left_x = fma(w3.s7_85, s8_847 - s8_854, s8_859);
  const double s8_860 = fnma(s8_577, s8_583, w1.R_carrier_left_aux2_y_y*tau_wheel_front_left);
  const double s8_861 = fma(w3.s7_85, s8_832, fma(w3.s7_66, s8_829, s8_860));
  const double s8_862 = fnma(w3.s7_71, s8_851, fma(w3.s7_101, s8_835, s8_861));
  const double s8_863 = fnma(w3.s7_97, s8_853, fnma(w3.s7_95, s8_852, s8_862));
  w5.n_carrier_left_y = fma(w3.s7_93, s8_854 - s8_838, s8_863);
  const double s8_864 = fma(s8_579, s8_583, w1.R_carrier_left_aux2_z_y*tau_wheel_front_left);
  const double s8_865 = fnma(w3.s7_100, s8_832, fnma(w3.s7_69, s8_829, s8_864));
  const double s8_866 = fma(w3.s7_71, s8_842, fnma(w3.s7_85, s8_835, s8_865));
  const double s8_867 = fma(w3.s7_97, s8_846, fma(w3.s7_93, s8_845, s8_866));
  w5.n_carrier_left_z = fma(w3.s7_95, s8_838 - s8_847, s8_867);
  const double s8_868 = K_carrier_left_trace - w3.s7_100;
  const double s8_869 = K_carrier_left_trace - w3.s7_101;
  w5.s8_870 = fnma(w3.s3_31, w3.s7_69, w3.s3_40*w3.s7_66);
  w5.s8_871 = fnma(w3.s3_34, w3.s7_69, w3.s3_43*w3.s7_66);
  w5.s8_872 = fnma(w3.s3_37, w3.s7_69, w3.s3_46*w3.s7_66);
  const double s8_873 = w5.s8_741 + (w4.s8_657 - w4.s8_611 - w4.s8_634);
  w5.s8_874 = w5.s8_872 + fma(projection.Rz[17], w3.s7_116, s8_873);
  const double s8_875 = fnma(w3.s3_40, w3.s7_71, w3.s7_69*w4.s8_586);
  w5.s8_876 = fma(m_carrier_left, w4.s8_587, s8_875);
  const double s8_877 = fnma(w3.s3_43, w3.s7_71, w3.s7_69*w4.s8_592);
  w5.s8_878 = fma(m_carrier_left, w4.s8_593, s8_877);
  const double s8_879 = fnma(w3.s3_46, w3.s7_71, w3.s7_69*w4.s8_598);
  w5.s8_880 = fma(m_carrier_left, w4.s8_599, s8_879);
  const double s8_881 = fnma(w3.s7_66, w4.s8_586, w3.s3_31*w3.s7_71);
  w5.s8_882 = fnma(m_carrier_left, w4.s8_588, s8_881);
  const double s8_883 = fnma(w3.s7_66, w4.s8_592, w3.s3_34*w3.s7_71);
  w5.s8_884 = fnma(m_carrier_left, w4.s8_594, s8_883);
  const double s8_885 = fnma(w3.s7_66, w4.s8_598, w3.s3_37*w3.s7_71);
  w5.s8_886 = fnma(m_carrier_left, w4.s8_600, s8_885);
  w5.s8_887 = fma(109.75, w1.r_carrier_left_aux1_z, w3.s7_66);
  w5.s8_888 = fma(109.75, w1.r_carrier_left_aux1_y, w3.s7_69);
  w5.s8_889 = 395.1 + w3.s7_71;
  w5.s8_890 = w1.r_carrier_left_aux1_z + w1.r_carrier_left_aux1_z;
  w5.s8_891 = w1.r_carrier_left_aux1_y + w1.r_carrier_left_aux1_y;
  const double s8_892 = fnma(w3.s7_93, w4.s8_586, fnma(w3.s3_40, w3.s7_85, w3.s3_31*s8_869));
  w5.s8_893 = fnma(w3.s7_71, w4.s8_588, s8_892);
  const double s8_894 = fnma(w3.s7_93, w4.s8_592, fnma(w3.s3_43, w3.s7_85, w3.s3_34*s8_869));
  w5.s8_895 = fnma(w3.s7_71, w4.s8_594, s8_894);
  const double s8_896 = fnma(w3.s7_93, w4.s8_598, fnma(w3.s3_46, w3.s7_85, w3.s3_37*s8_869));
  w5.s8_897 = fnma(w3.s7_71, w4.s8_600, s8_896);
  const double s8_898 = fnma(w3.s7_95, w4.s8_586, fnma(w3.s3_31, w3.s7_85, w3.s3_40*s8_868));
  w5.s8_899 = fnma(w3.s7_71, w4.s8_587, s8_898);
  const double s8_900 = fnma(w3.s7_95, w4.s8_592, fnma(w3.s3_34, w3.s7_85, w3.s3_43*s8_868));
  w5.s8_901 = fnma(w3.s7_71, w4.s8_593, s8_900);
  w5.s8_902 = fnma(w3.s7_95, w4.s8_598, fnma(w3.s3_37, w3.s7_85, w3.s3_46*s8_868));
}

/// Part 4 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_chosen_accelerations_4(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork1& __restrict w1,
    ChosenAccelerationsWork2& __restrict w2, ChosenAccelerationsWork3& __restrict w3,
    ChosenAccelerationsWork4& __restrict w4, ChosenAccelerationsWork5& __restrict w5,
    ChosenAccelerationsWork6& __restrict w6, ChosenAccelerationsWork8& __restrict w8) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_903 = fnma(w3.s7_71, w4.s8_599, w5.s8_902);
  const double s8_904 = fnma(w3.s3_40, w3.s7_95, fnma(w3.s3_31, w3.s7_93, w3.s7_98*w4.s8_586));
  w5.s8_905 = fma(w3.s7_66, w4.s8_588, fma(w3.s7_69, w4.s8_587, s8_904));
  const double s8_906 = fnma(w3.s3_43, w3.s7_95, fnma(w3.s3_34, w3.s7_93, w3.s7_98*w4.s8_592));
  w5.s8_907 = fma(w3.s7_66, w4.s8_594, fma(w3.s7_69, w4.s8_593, s8_906));
  const double s8_908 = fnma(w3.s3_46, w3.s7_95, fnma(w3.s3_37, w3.s7_93, w3.s7_98*w4.s8_598));
  const double s8_909 = fma(w3.s7_66, w4.s8_600, fma(w3.s7_69, w4.s8_599, s8_908));
  // lower_arm_left: lower_arm_left, revolute, chassis
  w5.s8_910 = w4.s7_211 + (w4.s7_179 + (w3.s7_129 + (w3.s7_103 + (5.25 + w3.s7_54))));
  const double s8_911 = w5.s8_747 + fma(projection.Rz[32], w4.s7_179, w4.s8_633 - w4.s8_654);
  const double s8_912 = fnma(projection.Rz[17], w3.s7_120, w5.s8_778 + s8_911);
  const double s8_913 = w5.s8_880 + fma(projection.Rz[14], w3.s7_103, s8_912);
  w5.s8_914 = fma(projection.Rz[2], w3.s7_54, s8_913);
  const double s8_915 = w5.s8_781 + (w5.s8_753 + (w4.s8_676 - w4.s8_617));
  const double s8_916 = w5.s8_886 + fnma(projection.Rz[14], w3.s7_105, s8_915);
  w5.s8_917 = fnma(projection.Rz[2], w3.s7_56, s8_916);
  w5.s8_918 = 1.825625*projection.Rz[0];
  w5.s8_919 = 1.825625*projection.Rz[1];
  const double s8_920 = 1.825625*projection.Rz[2];
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s8_921 = fma(zd_lower_arm_left, w2.s8_12, w3.s6_16);
  w5.s8_922 = 5.0 + w3.s7_54;
  w5.s8_923 = zd_lower_arm_left*w2.s8_11;
  w5.s8_924 = w3.s7_56 - 7.75;
  w5.s8_925 = zd_lower_arm_left*w2.s8_13;
  w5.s8_926 = fma(w3.s7_56, w5.s8_925, w3.s7_54*w5.s8_923);
  w5.s8_927 = fnma(w3.s7_56, s8_921, projection.zdd_star[0]*w3.s7_54);
  const double s8_928 = fnma(p_pitman_arm_z, w2.s8_15, w5.s8_795);
  w5.s8_929 = fma(w3.s7_54, s8_921, projection.zdd_star[0]*w3.s7_56);
  const double s8_930 = fma(p_lower_arm_right_y, w2.s8_21, w5.s8_793);
  const double s8_931 = w3.s7_62 - w3.s7_63;
  const double R_arb_front_left_x_z = w8.sines[8];
  // arb_link_front_left
  const double R_arb_front_left_x_x = w8.cosines[8];
  const double s8_932 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s8_933 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s8_932);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s8_934 = zd_arb_front_left*s8_933;
  const double s8_935 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  const double s8_936 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s8_935);
  const double s8_937 = zd_arb_front_left*s8_936;
  const double s8_938 = p_arb_link_front_left_to_x*w1.R_carrier_left_x_x;
  const double s8_939 = w1.s1_22 + w1.R_carrier_left_x_z;
  const double s8_940 = fnma(p_arb_link_front_left_to_y, s8_939, s8_938);
  const double s8_941 = w1.R_carrier_left_z_z - w1.R_carrier_left_aux2_z_y;
  const double s8_942 = p_arb_link_front_left_to_x*w1.R_carrier_left_z_x;
  const double s8_943 = fnma(p_arb_link_front_left_to_y, s8_941, s8_942);
  const double s8_944 = fnma(w1.s4_44, s8_943, w1.s4_31*s8_940);
  const double s8_945 = s8_944 - w1.s4_46;
  w5.s8_946 = fnma(w4.s8_586, s8_943, fms(w3.s3_31, s8_940, w4.s8_588));
  w5.s8_947 = fnma(w4.s8_592, s8_943, fms(w3.s3_34, s8_940, w4.s8_594));
  w5.s8_948 = fnma(w4.s8_598, s8_943, fms(w3.s3_37, s8_940, w4.s8_600));
  w5.s8_949 = s8_936 + p_arb_front_left_z - w1.r_carrier_left_aux1_z - s8_943;
  w5.s8_950 = 0.35 + s8_933 - s8_940;
  const double s8_951 = w1.R_carrier_left_y_z - w1.R_carrier_left_aux2_y_y;
  const double s8_952 = p_arb_link_front_left_to_x*w1.R_carrier_left_y_x;
  const double s8_953 = fnma(p_arb_link_front_left_to_y, s8_951, s8_952);
  w5.s8_954 = 0.72 - w1.r_carrier_left_aux1_y - s8_953;
  w5.s8_955 = 0.3333333333333333*w5.s8_954;
  w5.s8_956 = 0.3333333333333333*w5.s8_950;
  w5.s8_957 = 0.3333333333333333*w5.s8_949;
  const double s8_958 = fnma(w1.s4_33, s8_940, w1.s4_44*s8_953);
  const double s8_959 = s8_958 + (w1.s4_45 + s8_934);
  const double s8_960 = fnma(w3.s3_40, s8_940, fma(projection.Rz[15], s8_933, w4.s8_587));
  w5.s8_961 = fma(w4.s8_586, s8_953, s8_960);
  const double s8_962 = fnma(w3.s3_43, s8_940, fma(projection.Rz[16], s8_933, w4.s8_593));
  w5.s8_963 = fma(w4.s8_592, s8_953, s8_962);
  const double s8_964 = fnma(w3.s3_46, s8_940, fma(projection.Rz[17], s8_933, w4.s8_599));
  w6.s8_965 = fma(w4.s8_598, s8_953, s8_964);
  w6.s8_966 = fma(w3.s3_31, s8_953, fnma(w3.s3_40, s8_943, projection.Rz[15]*s8_936));
  w6.s8_967 = fma(w3.s3_34, s8_953, fnma(w3.s3_43, s8_943, projection.Rz[16]*s8_936));
  w6.s8_968 = fma(w3.s3_37, s8_953, fnma(w3.s3_46, s8_943, projection.Rz[17]*s8_936));
  const double s8_969 = fnma(w1.s4_31, s8_953, w1.s4_33*s8_943);
  const double s8_970 = s8_937 - s8_969;
  const double s8_971 = fnma(zd_arb_front_left, s8_934, projection.zdd_star[5]*s8_936);
  const double s8_972 = fma(w1.s4_31, s8_944, fnma(w3.s6_43, s8_943, s8_971));
  const double s8_973 = fma(w2.s8_16, w5.s8_949, fma(w2.s8_13, s8_945, s8_972));
  const double s8_974 = fma(w3.s6_32, s8_953, fnma(w2.s8_20, w5.s8_950, s8_973));
  const double s8_975 = fnma(w1.s4_33, s8_958, fma(w2.s8_14, w5.s8_954, s8_974));
  w6.s8_976 = 0.3333333333333333*fnma(w2.s8_11, s8_959, s8_975);
  const double s8_977 = fma(w1.s1_20, projection.zdd_star[0], w3.s6_17);
  const double s8_978 = fma(w2.s8_15, w5.s8_949, fnma(w3.s6_32, s8_940, w4.s8_605*s8_943));
  const double s8_979 = fnma(w2.s8_21, w5.s8_954, fma(w2.s8_14, w5.s8_950, s8_978));
  const double s8_980 = fma(w2.s8_12, s8_959, fma(w1.s4_44, s8_958, s8_979));
  const double s8_981 = s8_977 + fma(w2.s8_13, s8_970, fnma(w1.s4_31, s8_969, s8_980));
  w6.s8_982 = 0.3333333333333333*s8_981;
  const double s8_983 = fnma(w1.s1_18, projection.zdd_star[0], w3.s6_18);
  const double s8_984 = fnma(projection.zdd_star[5], s8_933, w3.s6_43*s8_940);
  const double s8_985 = fnma(w1.s4_44, s8_944, fnma(zd_arb_front_left, s8_937, s8_984));
  const double s8_986 = fnma(w2.s8_19, w5.s8_949, fnma(w2.s8_12, s8_945, s8_985));
  const double s8_987 = fnma(w4.s8_605, s8_953, fma(w2.s8_16, w5.s8_950, s8_986));
  const double s8_988 = fma(w1.s4_33, s8_969, fma(w2.s8_15, w5.s8_954, s8_987));
  w6.s8_989 = 0.3333333333333333*(s8_983 + fnma(w2.s8_11, s8_970, s8_988));
  const double R_arb_front_right_x_z = w8.sines[14];
  // arb_link_front_right
  const double R_arb_front_right_x_x = w8.cosines[14];
  const double s8_990 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s8_991 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s8_990);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s8_992 = zd_arb_front_right*s8_991;
  const double s8_993 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  const double s8_994 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s8_993);
  const double s8_995 = zd_arb_front_right*s8_994;
  const double s8_996 = w1.R_carrier_right_aux2_y_y + w1.R_carrier_right_y_z;
  const double s8_997 = p_arb_link_front_right_to_x*w1.R_carrier_right_y_x;
  const double s8_998 = fnma(p_arb_link_front_left_to_y, s8_996, s8_997);
  w6.s8_999 = s8_998 + (0.72 + w1.r_carrier_right_aux1_y);
  const double s8_1000 = p_arb_link_front_right_to_x*w1.R_carrier_right_x_x;
  const double s8_1001 = w1.R_carrier_right_x_z - w1.s1_35;
  const double s8_1002 = fnma(p_arb_link_front_left_to_y, s8_1001, s8_1000);
  const double s8_1003 = w1.R_carrier_right_aux2_z_y + w1.R_carrier_right_z_z;
  const double s8_1004 = p_arb_link_front_right_to_x*w1.R_carrier_right_z_x;
  const double s8_1005 = fnma(p_arb_link_front_left_to_y, s8_1003, s8_1004);
  const double s8_1006 = fnma(w1.s4_48, s8_1005, w1.s4_35*s8_1002);
  const double s8_1007 = w1.s4_50 + s8_1006;
  w6.s8_1008 = fnma(w4.s8_589, s8_1005, fma(w3.s3_49, s8_1002, w4.s8_591));
  w6.s8_1009 = fnma(w4.s8_595, s8_1005, fma(w3.s3_52, s8_1002, w4.s8_597));
  w6.s8_1010 = fnma(w4.s8_601, s8_1005, fma(w3.s3_55, s8_1002, w4.s8_603));
  w6.s8_1011 = s8_994 + (w1.s1_33 + p_arb_front_right_z) - s8_1005;
  w6.s8_1012 = 0.35 + s8_991 - s8_1002;
  w6.s8_1013 = 0.3333333333333333*w6.s8_1012;
  w6.s8_1014 = 0.3333333333333333*w6.s8_1011;
  w6.s8_1015 = 0.3333333333333333*w6.s8_999;
  const double s8_1016 = fnma(w1.s4_37, s8_1002, w1.s4_48*s8_998);
  const double s8_1017 = s8_1016 + (w1.s4_49 + s8_992);
  const double s8_1018 = fma(w4.s8_589, s8_998, fma(projection.Rz[33], s8_991, w4.s8_590));
  w6.s8_1019 = fnma(w3.s3_58, s8_1002, s8_1018);
  const double s8_1020 = fma(w4.s8_595, s8_998, fma(projection.Rz[34], s8_991, w4.s8_596));
  w6.s8_1021 = fnma(w3.s3_61, s8_1002, s8_1020);
  const double s8_1022 = fma(w4.s8_601, s8_998, fma(projection.Rz[35], s8_991, w4.s8_602));
  w6.s8_1023 = fnma(w3.s3_64, s8_1002, s8_1022);
  w6.s8_1024 = fnma(w3.s3_58, s8_1005, fma(w3.s3_49, s8_998, projection.Rz[33]*s8_994));
  w6.s8_1025 = fnma(w3.s3_61, s8_1005, fma(w3.s3_52, s8_998, projection.Rz[34]*s8_994));
  w6.s8_1026 = fnma(w3.s3_64, s8_1005, fma(w3.s3_55, s8_998, projection.Rz[35]*s8_994));
  const double s8_1027 = fnma(w1.s4_35, s8_998, w1.s4_37*s8_1005);
  const double s8_1028 = s8_995 - s8_1027;
  const double s8_1029 = fms(w1.s1_30, w3.s6_19, w4.s8_608);
  const double s8_1030 = fma(w4.s8_607, s8_1005, fnma(w3.s6_38, s8_1002, w2.s8_21*w6.s8_999));
  const double s8_1031 = fma(w2.s8_14, w6.s8_1012, fma(w2.s8_15, w6.s8_1011, s8_1030));
  const double s8_1032 = fma(w2.s8_12, s8_1017, fma(w1.s4_48, s8_1016, s8_1031));
  const double s8_1033 = s8_1029 + fma(w2.s8_13, s8_1028, fnma(w1.s4_35, s8_1027, s8_1032));
  w6.s8_1034 = 0.3333333333333333*s8_1033;
  const double s8_1035 = fnma(zd_arb_front_right, s8_992, projection.zdd_star[11]*s8_994);
  const double s8_1036 = fnma(w2.s8_14, w6.s8_999, fma(w3.s6_38, s8_998, s8_1035));
  const double s8_1037 = fma(w1.s4_35, s8_1006, fnma(w3.s6_48, s8_1005, s8_1036));
  const double s8_1038 = fma(w2.s8_16, w6.s8_1011, fma(w2.s8_13, s8_1007, s8_1037));
  const double s8_1039 = fnma(w1.s4_37, s8_1016, fnma(w2.s8_20, w6.s8_1012, s8_1038));
  w6.s8_1040 = 0.3333333333333333*fnma(w2.s8_11, s8_1017, s8_1039);
  const double s8_1041 = fnma(w1.s1_30, projection.zdd_star[6], fms(w3.s6_48, s8_1002, w3.s6_20));
  const double s8_1042 = fnma(projection.zdd_star[11], s8_991, s8_1041);
  const double s8_1043 = fnma(w4.s8_607, s8_998, fnma(zd_arb_front_right, s8_995, s8_1042));
  const double s8_1044 = fnma(w1.s4_48, s8_1006, fnma(w2.s8_15, w6.s8_999, s8_1043));
  const double s8_1045 = fnma(w2.s8_19, w6.s8_1011, fnma(w2.s8_12, s8_1007, s8_1044));
  const double s8_1046 = fma(w1.s4_37, s8_1027, fma(w2.s8_16, w6.s8_1012, s8_1045));
  w6.s8_1047 = 0.3333333333333333*fnma(w2.s8_11, s8_1028, s8_1046);
  // drag_link
  const double s8_1048 = -p_drag_link_from_z*w8.sines[15];
  const double s8_1049 = -p_drag_link_from_z*w8.cosines[15];
  const double R_bell_crank_y_x = w8.sines[16];
  const double s8_1050 = p_drag_link_to_y*R_bell_crank_y_x;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s8_1051 = zd_pitman_arm*s8_1048;
  const double s8_1052 = zd_pitman_arm*s8_1049;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s8_1053 = zd_bell_crank*s8_1050;
  const double R_bell_crank_x_x = w8.cosines[16];
  const double s8_1054 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s8_1055 = zd_bell_crank*s8_1054;
  w6.s8_1056 = projection.Rz[36]*s8_1048;
  w6.s8_1057 = projection.Rz[37]*s8_1048;
  w6.s8_1058 = projection.Rz[38]*s8_1048;
  w6.s8_1059 = projection.Rz[39]*s8_1050;
  w6.s8_1060 = projection.Rz[40]*s8_1050;
  w6.s8_1061 = projection.Rz[41]*s8_1050;
  w6.s8_1062 = p_pitman_arm_y - s8_1054;
  w6.s8_1063 = 1.5*w6.s8_1062;
  w6.s8_1064 = 0.2 - s8_1049;
  w6.s8_1065 = s8_1050 + (1.15 - s8_1048);
  w6.s8_1066 = 1.5*w6.s8_1064;
  w6.s8_1067 = 1.5*w6.s8_1065;
  w6.s8_1068 = fnma(projection.Rz[36], s8_1049, projection.Rz[39]*s8_1054);
  w6.s8_1069 = fnma(projection.Rz[37], s8_1049, projection.Rz[40]*s8_1054);
  w6.s8_1070 = fnma(projection.Rz[38], s8_1049, projection.Rz[41]*s8_1054);
  const double s8_1071 = fma(w6.s8_1059, w6.s8_1059, w6.s8_1056*w6.s8_1056);
  const double s8_1072 = fma(w6.s8_1068, w6.s8_1068, s8_1071);
  const double s8_1073 = fma(w6.s8_1059, w6.s8_1060, w6.s8_1056*w6.s8_1057);
  w6.s8_1074 = fma(w6.s8_1068, w6.s8_1069, s8_1073);
  const double s8_1075 = fma(w6.s8_1059, w6.s8_1061, w6.s8_1056*w6.s8_1058);
  const double s8_1076 = fma(w6.s8_1068, w6.s8_1070, s8_1075);
  const double s8_1077 = fma(w6.s8_1060, w6.s8_1060, w6.s8_1057*w6.s8_1057);
  const double s8_1078 = fma(w6.s8_1069, w6.s8_1069, s8_1077);
  const double s8_1079 = fma(w6.s8_1060, w6.s8_1061, w6.s8_1057*w6.s8_1058);
  const double s8_1080 = fma(w6.s8_1069, w6.s8_1070, s8_1079);
  const double s8_1081 = fma(w6.s8_1061, w6.s8_1061, w6.s8_1058*w6.s8_1058);
  const double s8_1082 = fma(w6.s8_1070, w6.s8_1070, s8_1081);
  const double s8_1083 = fnma(projection.zdd_star[12], s8_1049, w4.s8_635*s8_1051);
  const double s8_1084 = fma(projection.zdd_star[13], s8_1054, fnma(w4.s8_618, s8_1053, s8_1083));
  const double s8_1085 = fma(w2.s8_16, w6.s8_1064, fma(w2.s8_14, w6.s8_1062, s8_1084));
  w6.s8_1086 = 1.5*fnma(w2.s8_20, w6.s8_1065, s8_1085);
  const double s8_1087 = s8_1055 - s8_1052;
  const double s8_1088 = fma(zd_pitman_arm, s8_1052, projection.zdd_star[12]*s8_1048);
  const double s8_1089 = fma(w2.s8_15, w6.s8_1062, fma(w2.s8_12, s8_1053, s8_1088));
  const double s8_1090 = fma(w2.s8_16, w6.s8_1065, fnma(w2.s8_19, w6.s8_1064, s8_1089));
  w6.s8_1091 = 1.5*fnma(w2.s8_11, s8_1087, s8_1090);
  const double s8_1092 = fnma(w2.s8_12, s8_1051, projection.zdd_star[13]*s8_1050);
  const double s8_1093 = fnma(w2.s8_21, w6.s8_1062, fma(zd_bell_crank, s8_1055, s8_1092));
  const double s8_1094 = fma(w2.s8_14, w6.s8_1065, fma(w2.s8_15, w6.s8_1064, s8_1093));
  w6.s8_1095 = 1.5*fma(w2.s8_13, s8_1087, s8_1094);
  // tie_rod_left
  const double s8_1096 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s8_1097 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  const double s8_1098 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s8_1096);
  const double s8_1099 = zd_bell_crank*s8_1098;
  const double s8_1100 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s8_1097);
  const double s8_1101 = zd_bell_crank*s8_1100;
  const double s8_1102 = p_tie_rod_left_to_z*w1.R_carrier_left_z_z;
  const double s8_1103 = fma(p_tie_rod_left_to_y, w1.R_carrier_left_aux2_z_y, s8_1102);
  const double s8_1104 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_z_x, s8_1103);
  w6.s8_1105 = s8_1104 + (w1.r_carrier_left_aux1_z - p_bell_crank_z);
  const double s8_1106 = p_tie_rod_left_to_z*w1.R_carrier_left_y_z;
  const double s8_1107 = fma(p_tie_rod_left_to_y, w1.R_carrier_left_aux2_y_y, s8_1106);
  const double s8_1108 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_y_x, s8_1107);
  const double s8_1109 = -p_tie_rod_left_to_y*w1.s1_22;
  const double s8_1110 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_x_x, s8_1109);
  const double s8_1111 = fma(p_tie_rod_left_to_z, w1.R_carrier_left_x_z, s8_1110);
  const double s8_1112 = fnma(w1.s4_33, s8_1111, w1.s4_44*s8_1108);
  const double s8_1113 = w1.s4_45 + s8_1112;
  w6.s8_1114 = fnma(w3.s3_40, s8_1111, fma(w4.s8_586, s8_1108, w4.s8_587));
  w6.s8_1115 = fnma(w3.s3_43, s8_1111, fma(w4.s8_592, s8_1108, w4.s8_593));
  w6.s8_1116 = fnma(w3.s3_46, s8_1111, fma(w4.s8_598, s8_1108, w4.s8_599));
  const double s8_1117 = fnma(w1.s4_31, s8_1108, w1.s4_33*s8_1104);
  const double s8_1118 = s8_1101 + s8_1117;
  const double s8_1119 = fma(w3.s3_40, s8_1104, projection.Rz[39]*s8_1100);
  w6.s8_1120 = fnma(w3.s3_31, s8_1108, s8_1119);
  const double s8_1121 = fma(w3.s3_43, s8_1104, projection.Rz[40]*s8_1100);
  w6.s8_1122 = fnma(w3.s3_34, s8_1108, s8_1121);
  const double s8_1123 = fma(w3.s3_46, s8_1104, projection.Rz[41]*s8_1100);
  w6.s8_1124 = fnma(w3.s3_37, s8_1108, s8_1123);
  w6.s8_1125 = s8_1111 + (0.35 + s8_1098);
  w6.s8_1126 = s8_1100 - w1.r_carrier_left_aux1_y - s8_1108;
  w6.s8_1127 = 1.1666666666666667*w6.s8_1126;
  w6.s8_1128 = 1.1666666666666667*w6.s8_1125;
  const double s8_1129 = fnma(w1.s4_44, s8_1104, w1.s4_31*s8_1111);
  const double s8_1130 = s8_1129 + (s8_1099 - w1.s4_46);
  const double s8_1131 = fnma(w4.s8_586, s8_1104, fms(projection.Rz[39], s8_1098, w4.s8_588));
  w6.s8_1132 = fma(w3.s3_31, s8_1111, s8_1131);
  const double s8_1133 = fnma(w4.s8_592, s8_1104, fms(projection.Rz[40], s8_1098, w4.s8_594));
  w6.s8_1134 = fma(w3.s3_34, s8_1111, s8_1133);
  const double s8_1135 = fnma(w4.s8_598, s8_1104, fms(projection.Rz[41], s8_1098, w4.s8_600));
  w6.s8_1136 = fma(w3.s3_37, s8_1111, s8_1135);
  w6.s8_1137 = 1.1666666666666667*w6.s8_1105;
  const double s8_1138 = fnma(w4.s8_605, s8_1108, fma(w2.s8_19, w6.s8_1105, s8_983));
  const double s8_1139 = fma(w1.s4_33, s8_1117, fma(w3.s6_43, s8_1111, s8_1138));
  const double s8_1140 = fnma(w2.s8_16, w6.s8_1125, fma(w2.s8_11, s8_1118, s8_1139));
  const double s8_1141 = fnma(w1.s4_44, s8_1129, fma(w2.s8_15, w6.s8_1126, s8_1140));
  w6.s8_1142 = 1.1666666666666667*fnma(w2.s8_12, s8_1130, s8_1141);
  const double s8_1143 = fnma(projection.zdd_star[13], s8_1100, zd_bell_crank*s8_1099);
  const double s8_1144 = fnma(w2.s8_16, w6.s8_1105, fnma(w3.s6_43, s8_1104, s8_1143));
  const double s8_1145 = fnma(w1.s4_33, s8_1112, fma(w3.s6_32, s8_1108, s8_1144));
  const double s8_1146 = fma(w2.s8_20, w6.s8_1125, fnma(w2.s8_11, s8_1113, s8_1145));
  const double s8_1147 = fma(w1.s4_31, s8_1129, fma(w2.s8_14, w6.s8_1126, s8_1146));
  w6.s8_1148 = 1.1666666666666667*fma(w2.s8_13, s8_1130, s8_1147);
  const double s8_1149 = fnma(projection.zdd_star[13], s8_1098, s8_977);
  const double s8_1150 = fma(w4.s8_605, s8_1104, fnma(zd_bell_crank, s8_1101, s8_1149));
  const double s8_1151 = fnma(w3.s6_32, s8_1111, fnma(w2.s8_15, w6.s8_1105, s8_1150));
  const double s8_1152 = fma(w2.s8_12, s8_1113, fma(w1.s4_44, s8_1112, s8_1151));
  const double s8_1153 = fnma(w2.s8_13, s8_1118, fnma(w1.s4_31, s8_1117, s8_1152));
  const double s8_1154 = fnma(w2.s8_21, w6.s8_1126, fnma(w2.s8_14, w6.s8_1125, s8_1153));
  w6.s8_1155 = 1.1666666666666667*s8_1154;
  // tie_rod_right
  const double s8_1156 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s8_1097);
  const double s8_1157 = zd_bell_crank*s8_1156;
  const double s8_1158 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s8_1096);
  const double s8_1159 = zd_bell_crank*s8_1158;
  const double s8_1160 = p_tie_rod_right_to_y*w1.R_carrier_right_aux2_z_y;
  const double s8_1161 = fma(p_tie_rod_right_to_x, w1.R_carrier_right_z_x, s8_1160);
  const double s8_1162 = fma(p_tie_rod_right_to_z, w1.R_carrier_right_z_z, s8_1161);
  w6.s8_1163 = s8_1162 + (-p_bell_crank_z - w1.s1_33);
  const double s8_1164 = p_tie_rod_right_to_y*w1.R_carrier_right_aux2_y_y;
  const double s8_1165 = fma(p_tie_rod_right_to_x, w1.R_carrier_right_y_x, s8_1164);
  const double s8_1166 = fma(p_tie_rod_right_to_z, w1.R_carrier_right_y_z, s8_1165);
  w6.s8_1167 = s8_1166 + (w1.r_carrier_right_aux1_y + s8_1156);
  const double s8_1168 = p_tie_rod_right_to_z*w1.R_carrier_right_x_z;
  const double s8_1169 = fnma(p_tie_rod_right_to_y, w1.s1_35, s8_1168);
  const double s8_1170 = fma(p_tie_rod_right_to_x, w1.R_carrier_right_x_x, s8_1169);
  const double s8_1171 = fnma(w1.s4_37, s8_1170, w1.s4_48*s8_1166);
  const double s8_1172 = w1.s4_49 + s8_1171;
  w6.s8_1173 = fnma(w3.s3_58, s8_1170, fma(w4.s8_589, s8_1166, w4.s8_590));
  w6.s8_1174 = fnma(w3.s3_61, s8_1170, fma(w4.s8_595, s8_1166, w4.s8_596));
  w6.s8_1175 = fnma(w3.s3_64, s8_1170, fma(w4.s8_601, s8_1166, w4.s8_602));
  w6.s8_1176 = s8_1158 - 0.35 - s8_1170;
  w6.s8_1177 = 1.1666666666666667*w6.s8_1176;
  w6.s8_1178 = 1.1666666666666667*w6.s8_1167;
  w6.s8_1179 = 1.1666666666666667*w6.s8_1163;
  const double s8_1180 = fnma(w3.s3_58, s8_1162, projection.Rz[39]*s8_1156);
  w6.s8_1181 = fma(w3.s3_49, s8_1166, s8_1180);
  const double s8_1182 = fnma(w3.s3_61, s8_1162, projection.Rz[40]*s8_1156);
  w6.s8_1183 = fma(w3.s3_52, s8_1166, s8_1182);
  const double s8_1184 = fnma(w3.s3_64, s8_1162, projection.Rz[41]*s8_1156);
  w6.s8_1185 = fma(w3.s3_55, s8_1166, s8_1184);
  const double s8_1186 = w5.s8_778 + fma(projection.Rz[32], w4.s7_179, w5.s8_747);
  const double s8_1187 = w5.s8_880 + fma(projection.Rz[14], w3.s7_103, s8_1186);
  const double s8_1188 = fnma(p_pitman_arm_x, w4.s8_633, -p_bell_crank_z*w4.s8_611);
  const double s8_1189 = w4.s8_664 + (w4.s8_642 + fnma(p_pitman_arm_z, w4.s8_634, s8_1188));
  const double s8_1190 = w5.s8_801 + (w5.s8_768 + fnma(w1.s1_33, w5.s8_741, s8_1189));
  const double s8_1191 = s8_903 + fma(w1.r_carrier_left_aux1_z, w5.s8_872, s8_1190);
  const double s8_1192 = fnma(w5.s8_957, w6.s8_968, fnma(w5.s8_956, w6.s8_965, s8_1191));
  const double s8_1193 = fnma(w6.s8_1014, w6.s8_1026, fnma(w6.s8_1013, w6.s8_1023, s8_1192));
  const double s8_1194 = fnma(w6.s8_1066, w6.s8_1070, fma(w6.s8_1058, w6.s8_1067, s8_1193));
  const double s8_1195 = fnma(w6.s8_1124, w6.s8_1137, fma(w6.s8_1116, w6.s8_1128, s8_1194));
  const double s8_1196 = fma(w6.s8_1179, w6.s8_1185, fnma(w6.s8_1175, w6.s8_1177, s8_1195));
  const double s8_1197 = fma(projection.Rz[2], w3.s7_54, s8_1187);
  const double s8_1198 = fma(projection.Rz[17], w3.s7_116, w4.s8_657);
  const double s8_1199 = fnma(0.5, s8_1198, fnma(p_lower_arm_left_x, s8_1197, s8_1196));
  const double s8_1200 = fma(projection.Rz[17], w3.s7_120, w4.s8_654);
  w6.s8_1201 = fma(p_arb_front_right_x, s8_1200, s8_1199);
  const double s8_1202 = fnma(w1.s4_48, s8_1162, w1.s4_35*s8_1170);
  const double s8_1203 = fnma(w1.s4_35, s8_1166, w1.s4_37*s8_1162);
  const double s8_1204 = fma(w4.s8_589, s8_1162, fms(projection.Rz[39], s8_1158, w4.s8_591));
  w6.s8_1205 = fnma(w3.s3_49, s8_1170, s8_1204);
  const double s8_1206 = fma(w4.s8_595, s8_1162, fms(projection.Rz[40], s8_1158, w4.s8_597));
  w6.s8_1207 = fnma(w3.s3_52, s8_1170, s8_1206);
  const double s8_1208 = fma(w4.s8_601, s8_1162, fms(projection.Rz[41], s8_1158, w4.s8_603));
  w6.s8_1209 = fnma(w3.s3_55, s8_1170, s8_1208);
  const double s8_1210 = fnma(projection.Rz[14], w3.s7_105, w5.s8_781 + (w4.s8_676 + w5.s8_753));
  const double s8_1211 = fnma(projection.Rz[17], w3.s7_114, projection.Rz[35]*w4.s7_196);
  const double s8_1212 = fnma(p_bell_crank_x, w4.s8_617, w4.s8_614 + s8_1211);
  const double s8_1213 = fma(p_pitman_arm_y, w4.s8_634, s8_1212);
  const double s8_1214 = w5.s8_762 + fnma(w1.r_carrier_right_aux1_y, w5.s8_741, s8_1213);
  const double s8_1215 = w5.s8_897 + fnma(w1.r_carrier_left_aux1_y, w5.s8_872, s8_1214);
  const double s8_1216 = fma(w5.s8_955, w6.s8_968, fma(w5.s8_948, w5.s8_956, s8_1215));
  const double s8_1217 = fnma(w6.s8_1015, w6.s8_1026, fma(w6.s8_1010, w6.s8_1013, s8_1216));
  const double s8_1218 = fma(w6.s8_1063, w6.s8_1070, fnma(w6.s8_1061, w6.s8_1067, s8_1217));
  const double s8_1219 = fnma(w6.s8_1128, w6.s8_1136, fnma(w6.s8_1124, w6.s8_1127, s8_1218));
  const double s8_1220 = fnma(w6.s8_1177, w6.s8_1209, fnma(w6.s8_1178, w6.s8_1185, s8_1219));
  const double s8_1221 = fnma(projection.Rz[2], w3.s7_56, w5.s8_886 + s8_1210);
  const double s8_1222 = fnma(projection.Rz[17], w3.s7_116, w4.s8_657);
  const double s8_1223 = fma(p_lower_arm_left_x, s8_1221, s8_1220);
  w6.s8_1224 = fnma(p_arb_front_right_y, s8_1222, s8_1223);
  const double s8_1225 = fnma(projection.Rz[32], w4.s7_179, w4.s8_633);
  const double s8_1226 = fnma(projection.Rz[17], w3.s7_118, w4.s8_680);
  const double s8_1227 = fnma(projection.Rz[35], w4.s7_194, s8_1226);
  const double s8_1228 = fma(p_bell_crank_z, w4.s8_617, s8_1227);
  const double s8_1229 = fma(w1.r_carrier_right_aux1_y, w5.s8_747, s8_1228);
  const double s8_1230 = w5.s8_784 + (w5.s8_774 + fma(w1.s1_33, w5.s8_753, s8_1229));
  const double s8_1231 = fma(w1.r_carrier_left_aux1_y, w5.s8_880, w5.s8_814 + s8_1230);
  const double s8_1232 = s8_920 + (s8_909 + fnma(w1.r_carrier_left_aux1_z, w5.s8_886, s8_1231));
  const double s8_1233 = fma(w5.s8_955, w6.s8_965, fnma(w5.s8_948, w5.s8_957, s8_1232));
  const double s8_1234 = fnma(w6.s8_1015, w6.s8_1023, fnma(w6.s8_1010, w6.s8_1014, s8_1233));
  const double s8_1235 = fma(w6.s8_1061, w6.s8_1066, fnma(w6.s8_1058, w6.s8_1063, s8_1234));
  const double s8_1236 = fma(w6.s8_1136, w6.s8_1137, fma(w6.s8_1116, w6.s8_1127, s8_1235));
  const double s8_1237 = fnma(w6.s8_1179, w6.s8_1209, fnma(w6.s8_1175, w6.s8_1178, s8_1236));
  const double s8_1238 = fma(0.5, fma(projection.Rz[14], w3.s7_103, s8_1225), s8_1237);
  const double s8_1239 = fms(projection.Rz[2], w3.s7_54, w5.s8_778);
  const double s8_1240 = fnma(projection.Rz[2], w3.s7_56, w5.s8_781);
  const double s8_1241 = fma(p_lower_arm_left_y, s8_1239, s8_1238);
  const double s8_1242 = fnma(projection.Rz[14], w3.s7_105, w4.s8_676);
  const double s8_1243 = fnma(p_lower_arm_left_z, s8_1240, s8_1241);
  const double s8_1244 = fnma(projection.Rz[17], w3.s7_120, w4.s8_654);
  const double s8_1245 = fnma(p_upper_arm_right_z, s8_1242, s8_1243);
  w6.s8_1246 = fnma(p_arb_front_right_y, s8_1244, s8_1245);
  const double s8_1247 = s8_1159 - w1.s4_50 - s8_1202;
  const double s8_1248 = fma(w5.s8_961, w5.s8_961, w5.s8_946*w5.s8_946);
  const double s8_1249 = fma(w6.s8_1008, w6.s8_1008, fma(w6.s8_966, w6.s8_966, s8_1248));
  const double s8_1250 = fma(w6.s8_1120, w6.s8_1120, w6.s8_1114*w6.s8_1114);
  const double s8_1251 = fma(w6.s8_1173, w6.s8_1173, fma(w6.s8_1132, w6.s8_1132, s8_1250));
  const double s8_1252 = fma(projection.Rz[36], w4.s8_640, projection.Rz[39]*w4.s8_612);
  const double s8_1253 = fma(projection.Rz[33], w4.s8_662, s8_1252);
  const double s8_1254 = fma(w4.s8_590, w5.s8_743, fma(projection.Rz[30], w4.s8_678, s8_1253));
  const double s8_1255 = fma(w3.s3_49, w5.s8_758, fma(w4.s8_591, w5.s8_749, s8_1254));
  const double s8_1256 = fma(w4.s8_589, w5.s8_770, fma(w3.s3_58, w5.s8_764, s8_1255));
  const double s8_1257 = fma(projection.Rz[18], w5.s8_782, s8_1256);
  const double s8_1258 = fma(projection.Rz[15], w5.s8_799, s8_1257);
  const double s8_1259 = fma(w4.s8_587, w5.s8_876, fma(projection.Rz[12], w5.s8_812, s8_1258));
  const double s8_1260 = fma(w3.s3_31, w5.s8_893, fnma(w4.s8_588, w5.s8_882, s8_1259));
  const double s8_1261 = fma(w4.s8_586, w5.s8_905, fma(w3.s3_40, w5.s8_899, s8_1260));
  const double s8_1262 = fma(w6.s8_1024, w6.s8_1024, fma(w6.s8_1019, w6.s8_1019, s8_1249));
  const double s8_1263 = fnma(1.5, s8_1072, fma(projection.Rz[0], w5.s8_918, s8_1261));
  const double s8_1264 = fma(w6.s8_1205, w6.s8_1205, fma(w6.s8_1181, w6.s8_1181, s8_1251));
  const double s8_1265 = fnma(0.3333333333333333, s8_1262, s8_1263);
  w6.s8_1266 = fnma(1.1666666666666667, s8_1264, s8_1265);
  const double s8_1267 = fma(w5.s8_961, w6.s8_965, w5.s8_946*w5.s8_948);
  const double s8_1268 = fma(w6.s8_1008, w6.s8_1010, fma(w6.s8_966, w6.s8_968, s8_1267));
  const double s8_1269 = fma(w6.s8_1120, w6.s8_1124, w6.s8_1114*w6.s8_1116);
  const double s8_1270 = fma(w6.s8_1173, w6.s8_1175, fma(w6.s8_1132, w6.s8_1136, s8_1269));
  const double s8_1271 = fma(projection.Rz[36], w4.s8_642, projection.Rz[39]*w4.s8_614);
  const double s8_1272 = fma(projection.Rz[33], w4.s8_664, s8_1271);
  const double s8_1273 = fma(w4.s8_590, w5.s8_747, fma(projection.Rz[30], w4.s8_680, s8_1272));
  const double s8_1274 = fma(w3.s3_49, w5.s8_762, fma(w4.s8_591, w5.s8_753, s8_1273));
  const double s8_1275 = fma(w4.s8_589, w5.s8_774, fma(w3.s3_58, w5.s8_768, s8_1274));
  const double s8_1276 = fma(projection.Rz[18], w5.s8_784, s8_1275);
  const double s8_1277 = fma(projection.Rz[15], w5.s8_801, s8_1276);
  const double s8_1278 = fma(w4.s8_587, w5.s8_880, fma(projection.Rz[12], w5.s8_814, s8_1277));
  const double s8_1279 = fma(w3.s3_31, w5.s8_897, fnma(w4.s8_588, w5.s8_886, s8_1278));
  const double s8_1280 = fma(w4.s8_586, s8_909, fma(w3.s3_40, s8_903, s8_1279));
  const double s8_1281 = fma(w6.s8_1024, w6.s8_1026, fma(w6.s8_1019, w6.s8_1023, s8_1268));
  const double s8_1282 = fnma(1.5, s8_1076, fma(projection.Rz[0], s8_920, s8_1280));
  const double s8_1283 = fma(w6.s8_1205, w6.s8_1209, fma(w6.s8_1181, w6.s8_1185, s8_1270));
  const double s8_1284 = fnma(0.3333333333333333, s8_1281, s8_1282);
  w6.s8_1285 = fnma(1.1666666666666667, s8_1283, s8_1284);
  const double s8_1286 = fma(w5.s8_963, w5.s8_963, w5.s8_947*w5.s8_947);
  const double s8_1287 = fma(w6.s8_1009, w6.s8_1009, fma(w6.s8_967, w6.s8_967, s8_1286));
  const double s8_1288 = fma(w6.s8_1122, w6.s8_1122, w6.s8_1115*w6.s8_1115);
  const double s8_1289 = fma(w6.s8_1174, w6.s8_1174, fma(w6.s8_1134, w6.s8_1134, s8_1288));
  const double s8_1290 = fma(projection.Rz[37], w4.s8_641, projection.Rz[40]*w4.s8_613);
  const double s8_1291 = fma(projection.Rz[34], w4.s8_663, s8_1290);
  const double s8_1292 = fma(w4.s8_596, w5.s8_745, fma(projection.Rz[31], w4.s8_679, s8_1291));
  const double s8_1293 = fma(w3.s3_52, w5.s8_760, fma(w4.s8_597, w5.s8_751, s8_1292));
  const double s8_1294 = fma(w4.s8_595, w5.s8_772, fma(w3.s3_61, w5.s8_766, s8_1293));
  const double s8_1295 = fma(projection.Rz[19], w5.s8_783, s8_1294);
  const double s8_1296 = fma(projection.Rz[16], w5.s8_800, s8_1295);
  const double s8_1297 = fma(w4.s8_593, w5.s8_878, fma(projection.Rz[13], w5.s8_813, s8_1296));
  const double s8_1298 = fma(w3.s3_34, w5.s8_895, fnma(w4.s8_594, w5.s8_884, s8_1297));
  const double s8_1299 = fma(w4.s8_592, w5.s8_907, fma(w3.s3_43, w5.s8_901, s8_1298));
  const double s8_1300 = fma(w6.s8_1025, w6.s8_1025, fma(w6.s8_1021, w6.s8_1021, s8_1287));
  const double s8_1301 = fnma(1.5, s8_1078, fma(projection.Rz[1], w5.s8_919, s8_1299));
  const double s8_1302 = fma(w6.s8_1207, w6.s8_1207, fma(w6.s8_1183, w6.s8_1183, s8_1289));
  const double s8_1303 = fnma(0.3333333333333333, s8_1300, s8_1301);
  w6.s8_1304 = fnma(1.1666666666666667, s8_1302, s8_1303);
  const double s8_1305 = fma(w5.s8_963, w6.s8_965, w5.s8_947*w5.s8_948);
  const double s8_1306 = fma(w6.s8_1009, w6.s8_1010, fma(w6.s8_967, w6.s8_968, s8_1305));
  const double s8_1307 = fma(w6.s8_1122, w6.s8_1124, w6.s8_1115*w6.s8_1116);
  const double s8_1308 = fma(w6.s8_1174, w6.s8_1175, fma(w6.s8_1134, w6.s8_1136, s8_1307));
  const double s8_1309 = fma(projection.Rz[37], w4.s8_642, projection.Rz[40]*w4.s8_614);
  const double s8_1310 = fma(projection.Rz[34], w4.s8_664, s8_1309);
  const double s8_1311 = fma(w4.s8_596, w5.s8_747, fma(projection.Rz[31], w4.s8_680, s8_1310));
  const double s8_1312 = fma(w3.s3_52, w5.s8_762, fma(w4.s8_597, w5.s8_753, s8_1311));
  const double s8_1313 = fma(w4.s8_595, w5.s8_774, fma(w3.s3_61, w5.s8_768, s8_1312));
  const double s8_1314 = fma(projection.Rz[19], w5.s8_784, s8_1313);
  const double s8_1315 = fma(projection.Rz[16], w5.s8_801, s8_1314);
  const double s8_1316 = fma(w4.s8_593, w5.s8_880, fma(projection.Rz[13], w5.s8_814, s8_1315));
  const double s8_1317 = fma(w3.s3_34, w5.s8_897, fnma(w4.s8_594, w5.s8_886, s8_1316));
  const double s8_1318 = fma(w4.s8_592, s8_909, fma(w3.s3_43, s8_903, s8_1317));
  const double s8_1319 = fma(w6.s8_1025, w6.s8_1026, fma(w6.s8_1021, w6.s8_1023, s8_1306));
  const double s8_1320 = fnma(1.5, s8_1080, fma(projection.Rz[1], s8_920, s8_1318));
  const double s8_1321 = fma(w6.s8_1207, w6.s8_1209, fma(w6.s8_1183, w6.s8_1185, s8_1308));
  const double s8_1322 = fnma(0.3333333333333333, s8_1319, s8_1320);
  w6.s8_1323 = fnma(1.1666666666666667, s8_1321, s8_1322);
  const double s8_1324 = fma(w6.s8_965, w6.s8_965, w5.s8_948*w5.s8_948);
  const double s8_1325 = fma(w6.s8_1010, w6.s8_1010, fma(w6.s8_968, w6.s8_968, s8_1324));
  const double s8_1326 = fma(w6.s8_1124, w6.s8_1124, w6.s8_1116*w6.s8_1116);
  const double s8_1327 = fma(w6.s8_1175, w6.s8_1175, fma(w6.s8_1136, w6.s8_1136, s8_1326));
  const double s8_1328 = fma(projection.Rz[38], w4.s8_642, projection.Rz[41]*w4.s8_614);
  const double s8_1329 = fma(projection.Rz[35], w4.s8_664, s8_1328);
  const double s8_1330 = fma(w4.s8_602, w5.s8_747, fma(projection.Rz[32], w4.s8_680, s8_1329));
  const double s8_1331 = fma(w3.s3_55, w5.s8_762, fma(w4.s8_603, w5.s8_753, s8_1330));
  const double s8_1332 = fma(w4.s8_601, w5.s8_774, fma(w3.s3_64, w5.s8_768, s8_1331));
  const double s8_1333 = fma(projection.Rz[20], w5.s8_784, s8_1332);
  const double s8_1334 = fma(projection.Rz[17], w5.s8_801, s8_1333);
  const double s8_1335 = fma(w4.s8_599, w5.s8_880, fma(projection.Rz[14], w5.s8_814, s8_1334));
  const double s8_1336 = fma(w3.s3_37, w5.s8_897, fnma(w4.s8_600, w5.s8_886, s8_1335));
  const double s8_1337 = fma(w4.s8_598, s8_909, fma(w3.s3_46, s8_903, s8_1336));
  const double s8_1338 = fma(w6.s8_1026, w6.s8_1026, fma(w6.s8_1023, w6.s8_1023, s8_1325));
  const double s8_1339 = fnma(1.5, s8_1082, fma(projection.Rz[2], s8_920, s8_1337));
  const double s8_1340 = fma(w6.s8_1209, w6.s8_1209, fma(w6.s8_1185, w6.s8_1185, s8_1327));
  const double s8_1341 = fnma(0.3333333333333333, s8_1338, s8_1339);
  w6.s8_1342 = fnma(1.1666666666666667, s8_1340, s8_1341);
  const double s8_1343 = s8_1157 - s8_1203;
  const double s8_1344 = fms(w2.s8_19, w6.s8_1163, w3.s6_20);
  const double s8_1345 = fnma(w1.s1_30, projection.zdd_star[6], s8_1344);
  const double s8_1346 = fnma(w2.s8_15, w6.s8_1167, fnma(w4.s8_607, s8_1166, s8_1345));
  const double s8_1347 = fma(w2.s8_16, w6.s8_1176, fma(w3.s6_48, s8_1170, s8_1346));
  const double s8_1348 = fma(w1.s4_37, s8_1203, fnma(w1.s4_48, s8_1202, s8_1347));
  const double s8_1349 = fnma(w2.s8_11, s8_1343, fma(w2.s8_12, s8_1247, s8_1348));
  w6.s8_1350 = 1.1666666666666667*s8_1349;
  const double s8_1351 = fnma(zd_bell_crank, s8_1159, projection.zdd_star[13]*s8_1156);
  const double s8_1352 = fnma(w2.s8_16, w6.s8_1163, fnma(w3.s6_48, s8_1162, s8_1351));
  const double s8_1353 = fnma(w2.s8_14, w6.s8_1167, fma(w3.s6_38, s8_1166, s8_1352));
  const double s8_1354 = fnma(w2.s8_11, s8_1172, fnma(w1.s4_37, s8_1171, s8_1353));
  const double s8_1355 = fma(w1.s4_35, s8_1202, fnma(w2.s8_20, w6.s8_1176, s8_1354));
  w6.s8_1356 = 1.1666666666666667*fnma(w2.s8_13, s8_1247, s8_1355);
  const double s8_1357 = fma(zd_bell_crank, s8_1157, s8_1029);
  const double s8_1358 = fma(w4.s8_607, s8_1162, fma(projection.zdd_star[13], s8_1158, s8_1357));
  const double s8_1359 = fma(w2.s8_21, w6.s8_1167, fnma(w2.s8_15, w6.s8_1163, s8_1358));
  const double s8_1360 = fma(w1.s4_48, s8_1171, fnma(w3.s6_38, s8_1170, s8_1359));
  const double s8_1361 = fma(w2.s8_14, w6.s8_1176, fma(w2.s8_12, s8_1172, s8_1360));
  const double s8_1362 = fma(w2.s8_13, s8_1343, fnma(w1.s4_35, s8_1203, s8_1361));
  w6.s8_1363 = 1.1666666666666667*s8_1362;
  const double s8_1364 = fnma(w2.s8_41, w3.s7_61, tau[Coordinate::lower_arm_left]);
  const double s8_1365 = fma(w3.s7_56, s8_930, fnma(w3.s7_54, s8_928, s8_1364));
  w6.s8_1366 = fnma(w2.s8_15, s8_931, fnma(1.825625, projection.zdd_star[0], s8_1365));
  const double s8_1367 = fnma(w2.s8_41, w3.s7_110, tau[Coordinate::upper_arm_left]);
  const double s8_1368 = fma(w3.s7_105, w5.s8_824, fnma(w3.s7_103, w5.s8_822, s8_1367));
  w6.s8_1369 = fnma(w2.s8_15, w5.s8_825, fnma(0.539, projection.zdd_star[4], s8_1368));
  const double s8_1370 = fnma(w2.s8_14, w3.s7_114, tau[Coordinate::arb_front_left]);
  const double s8_1371 = fnma(w2.s8_42, w3.s7_125, fma(w2.s8_15, w3.s7_118, s8_1370));
  const double s8_1372 = fma(w3.s7_120, w5.s8_810, fnma(w3.s7_116, w5.s8_808, s8_1371));
  w6.s8_1373 = fnma(w2.s8_16, w5.s8_811, fnma(0.3477, projection.zdd_star[5], s8_1372));
  const double s8_1374 = fnma(w2.s8_41, w3.s7_136, tau[Coordinate::lower_arm_right]);
  const double s8_1375 = fnma(w3.s7_129, w5.s8_796, fnma(w3.s7_131, w5.s8_794, s8_1374));
  const double s8_1376 = fnma(1.825625, projection.zdd_star[6], s8_1375);
  w6.s8_1377 = fnma(w2.s8_15, w5.s8_797, s8_1376);
  const double s8_1378 = fnma(w2.s8_41, w4.s7_186, tau[Coordinate::upper_arm_right]);
  const double s8_1379 = fnma(w4.s7_179, w4.s8_693, fnma(w4.s7_181, w4.s8_690, s8_1378));
  w6.s8_1380 = fnma(w2.s8_15, w4.s8_694, fnma(0.539, projection.zdd_star[10], s8_1379));
  const double s8_1381 = fma(w2.s8_15, w4.s7_194, tau[Coordinate::arb_front_right]);
  const double s8_1382 = fnma(w2.s8_42, w4.s7_201, fma(w2.s8_14, w4.s7_196, s8_1381));
  const double s8_1383 = fma(w4.s7_192, w4.s8_672, fma(w4.s7_190, w4.s8_667, s8_1382));
  const double s8_1384 = fnma(0.3477, projection.zdd_star[11], s8_1383);
  w6.s8_1385 = fnma(w2.s8_16, w4.s8_673, s8_1384);
  const double s8_1386 = fnma(w2.s8_42, w4.s7_208, tau[Coordinate::pitman_arm]);
  const double s8_1387 = fma(w4.s7_205, w4.s8_650, fnma(w4.s7_204, w4.s8_648, s8_1386));
  const double s8_1388 = fnma(0.3504, projection.zdd_star[12], s8_1387);
  w6.s8_1389 = fnma(w2.s8_16, w4.s8_651, s8_1388);
  const double s8_1390 = fnma(w2.s8_31, w4.s7_217, tau[Coordinate::bell_crank]);
  const double s8_1391 = fma(w4.s7_214, w4.s8_624, fnma(w4.s7_211, w4.s8_620, s8_1390));
  const double s8_1392 = fnma(0.9515, projection.zdd_star[13], s8_1391);
  w6.s8_1393 = fnma(w2.s8_14, w4.s8_628, s8_1392);
  const double s8_1394 = w1.R_carrier_left_aux1_z_x*tau[Coordinate::carrier_left_rx];
  const double s8_1395 = fma(tau[Coordinate::carrier_left_rz], w1.s1_59, s8_1394);
  w6.s8_1396 = fnma(tau[Coordinate::carrier_left_ry], w1.s1_66, s8_1395);
}

/// Part 5 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63).
[[gnu::noinline]] void compute_chosen_accelerations_5(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork1& __restrict w1,
    ChosenAccelerationsWork2& __restrict w2, ChosenAccelerationsWork3& __restrict w3,
    ChosenAccelerationsWork4& __restrict w4, ChosenAccelerationsWork5& __restrict w5,
    ChosenAccelerationsWork6& __restrict w6, ChosenAccelerationsWork7& __restrict w7,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // tie_rod_right
  const double s8_1397 = w6.s8_1396 - w5.n_carrier_left_z;
  const double s8_1398 = w1.R_carrier_left_aux1_y_x*tau[Coordinate::carrier_left_rx];
  const double s8_1399 = fma(tau[Coordinate::carrier_left_ry], w1.s1_58, s8_1398);
  const double s8_1400 = fnma(tau[Coordinate::carrier_left_rz], w1.s1_67, s8_1399);
  const double s8_1401 = s8_1400 - w5.n_carrier_left_y;
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s8_1402 = w1.R_carrier_right_aux1_z_x*tau_carrier_right_rx;
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double s8_1403 = fma(tau_carrier_right_rz, w1.s1_75, s8_1402);
  const double s8_1404 = fnma(tau_carrier_right_ry, w1.s1_82, s8_1403) - w5.n_carrier_right_z;
  const double s8_1405 = w1.R_carrier_right_aux1_y_x*tau_carrier_right_rx;
  const double s8_1406 = fma(tau_carrier_right_ry, w1.s1_74, s8_1405);
  const double s8_1407 = fnma(tau_carrier_right_rz, w1.s1_83, s8_1406) - w5.n_carrier_right_y;
  const double s8_1408 = fma(w2.s7_6, w3.s3_28, w2.s7_3*w3.s3_22);
  const double s8_1409 = fnma(w4.s8_603, w4.f_carrier_right_y, s8_1408);
  const double s8_1410 = fnma(w4.s8_602, w4.f_carrier_right_z, s8_1409);
  const double s8_1411 = fnma(w4.s8_601, w4.n_carrier_right_x, s8_1410);
  const double s8_1412 = fma(w4.s8_600, w5.f_carrier_left_y, s8_1411);
  const double s8_1413 = fnma(w4.s8_599, w5.f_carrier_left_z, s8_1412);
  const double s8_1414 = fma(w6.s8_968, w6.s8_976, fnma(w4.s8_598, w5.n_carrier_left_x, s8_1413));
  const double s8_1415 = fnma(w6.s8_965, w6.s8_989, fnma(w5.s8_948, w6.s8_982, s8_1414));
  const double s8_1416 = fma(w6.s8_1026, w6.s8_1040, fnma(w6.s8_1010, w6.s8_1034, s8_1415));
  const double s8_1417 = fma(w6.s8_1070, w6.s8_1086, fnma(w6.s8_1023, w6.s8_1047, s8_1416));
  const double s8_1418 = fma(w6.s8_1061, w6.s8_1095, fma(w6.s8_1058, w6.s8_1091, s8_1417));
  const double s8_1419 = fnma(w6.s8_1124, w6.s8_1148, fnma(w6.s8_1116, w6.s8_1142, s8_1418));
  const double s8_1420 = fnma(w6.s8_1175, w6.s8_1350, fnma(w6.s8_1136, w6.s8_1155, s8_1419));
  const double s8_1421 = fma(w6.s8_1209, w6.s8_1363, fma(w6.s8_1185, w6.s8_1356, s8_1420));
  const double s8_1422 = fma(projection.Rz[2], w6.s8_1366, s8_1421);
  const double s8_1423 = fma(projection.Rz[14], w6.s8_1369, s8_1422);
  const double s8_1424 = fma(projection.Rz[17], w6.s8_1373, s8_1423);
  const double s8_1425 = fma(projection.Rz[20], w6.s8_1377, s8_1424);
  const double s8_1426 = fma(projection.Rz[32], w6.s8_1380, s8_1425);
  const double s8_1427 = fma(projection.Rz[35], w6.s8_1385, s8_1426);
  const double s8_1428 = fma(projection.Rz[38], w6.s8_1389, s8_1427);
  const double s8_1429 = fma(w3.s3_37, s8_1397, fma(projection.Rz[41], w6.s8_1393, s8_1428));
  const double s8_1430 = fma(w3.s3_55, s8_1404, fma(w3.s3_46, s8_1401, s8_1429));
  w6.s8_1431 = fma(w3.s3_64, s8_1407, s8_1430);
  const double s8_1432 = w4.s7_194 + (w3.s7_118 + (11.55 + w2.s7_35 - w2.s7_47));
  const double s8_1433 = w4.s7_217 + fma(p_bell_crank_x, w4.s7_211, s8_1432);
  const double s8_1434 = w5.s8_922 + (w5.s8_816 + (w4.s8_682 + w5.s8_790));
  const double s8_1435 = fma(p_pitman_arm_y, w4.s8_644, s8_1433);
  const double s8_1436 = fma(p_lower_arm_left_x, s8_1434, s8_1435);
  const double s8_1437 = fnma(p_arb_front_right_y, w5.s8_803 - w4.s8_668, s8_1436);
  w6.s8_1438 = fnma(p_arb_rear_right_y, w2.s8_48 - w2.s8_32, s8_1437);
  const double s8_1439 = w3.s7_114 + (w3.s7_110 + (w3.s7_61 + (w2.s7_44 - 1.05 - w2.s7_37)));
  const double s8_1440 = w4.s7_186 + (w3.s7_136 + s8_1439) - w4.s7_196;
  const double s8_1441 = fma(p_bell_crank_z, w4.s7_211, s8_1440);
  const double s8_1442 = fma(0.5, w5.s8_818 + (w4.s8_677 - w4.s8_637), s8_1441);
  const double s8_1443 = fma(p_lower_arm_left_y, w5.s8_786 + w5.s8_924, s8_1442);
  const double s8_1444 = fma(p_lower_arm_left_z, w5.s8_790 + w5.s8_922, s8_1443);
  const double s8_1445 = fma(p_upper_arm_right_z, w4.s8_682 + w5.s8_816, s8_1444);
  const double s8_1446 = fnma(p_arb_front_right_y, w5.s8_798 - w4.s8_660, s8_1445);
  w6.s8_1447 = fnma(p_arb_rear_right_y, w2.s8_29 - w2.s8_44, s8_1446);
  result.inertia[8] = w6.s8_1342 - 1.5272999999999997e-20;
  w6.s8_1448 = 1.0/w6.s8_1342;
  const double s8_1449 = w6.s8_1323*w6.s8_1448;
  const double s8_1450 = fnma(w6.s8_1323, s8_1449, w6.s8_1304);
  result.inertia[7] = fnma(1e-12, w6.s8_1304, s8_1450 - 1.5272999999999997e-20);
  const double s8_1451 = w6.s8_1285*w6.s8_1448;
  const double s8_1452 = fma(w5.s8_961, w5.s8_963, w5.s8_946*w5.s8_947);
  const double s8_1453 = fma(w6.s8_1008, w6.s8_1009, fma(w6.s8_966, w6.s8_967, s8_1452));
  const double s8_1454 = fma(w6.s8_1120, w6.s8_1122, w6.s8_1114*w6.s8_1115);
  const double s8_1455 = fma(w6.s8_1173, w6.s8_1174, fma(w6.s8_1132, w6.s8_1134, s8_1454));
  const double s8_1456 = fma(projection.Rz[36], w4.s8_641, projection.Rz[39]*w4.s8_613);
  const double s8_1457 = fma(projection.Rz[33], w4.s8_663, s8_1456);
  const double s8_1458 = fma(w4.s8_590, w5.s8_745, fma(projection.Rz[30], w4.s8_679, s8_1457));
  const double s8_1459 = fma(w3.s3_49, w5.s8_760, fma(w4.s8_591, w5.s8_751, s8_1458));
  const double s8_1460 = fma(w4.s8_589, w5.s8_772, fma(w3.s3_58, w5.s8_766, s8_1459));
  const double s8_1461 = fma(projection.Rz[18], w5.s8_783, s8_1460);
  const double s8_1462 = fma(projection.Rz[15], w5.s8_800, s8_1461);
  const double s8_1463 = fma(w4.s8_587, w5.s8_878, fma(projection.Rz[12], w5.s8_813, s8_1462));
  const double s8_1464 = fma(w3.s3_31, w5.s8_895, fnma(w4.s8_588, w5.s8_884, s8_1463));
  const double s8_1465 = fma(w4.s8_586, w5.s8_907, fma(w3.s3_40, w5.s8_901, s8_1464));
  const double s8_1466 = fnma(1.5, w6.s8_1074, fma(projection.Rz[0], w5.s8_919, s8_1465));
  const double s8_1467 = fma(w6.s8_1024, w6.s8_1025, fma(w6.s8_1019, w6.s8_1021, s8_1453));
  const double s8_1468 = fnma(0.3333333333333333, s8_1467, fnma(w6.s8_1285, s8_1449, s8_1466));
  const double s8_1469 = fma(w6.s8_1205, w6.s8_1207, fma(w6.s8_1181, w6.s8_1183, s8_1455));
  w6.s8_1470 = fnma(1.1666666666666667, s8_1469, s8_1468);
  w6.s8_1471 = 1.0/s8_1450;
  const double s8_1472 = w6.s8_1470*w6.s8_1471;
  const double s8_1473 = fnma(w6.s8_1470, s8_1472, fnma(w6.s8_1285, s8_1451, w6.s8_1266));
  result.inertia[6] = fnma(1e-12, w6.s8_1266, s8_1473 - 1.5272999999999997e-20);
  const double s8_1474 = w5.s8_740 + (w4.s8_656 - w4.s8_610 - w4.s8_632);
  const double s8_1475 = w5.s8_871 + fma(projection.Rz[16], w3.s7_116, s8_1474);
  w6.s8_1476 = fnma(w5.s8_874, s8_1449, s8_1475);
  const double s8_1477 = w5.s8_739 + (w4.s8_655 - w4.s8_609 - w4.s8_630);
  const double s8_1478 = w5.s8_870 + fma(projection.Rz[15], w3.s7_116, s8_1477);
  w6.s8_1479 = fnma(s8_1472, w6.s8_1476, fnma(w5.s8_874, s8_1451, s8_1478));
  w6.s8_1480 = 1.0/s8_1473;
  w6.s8_1481 = w6.s8_1479*w6.s8_1480;
  const double s8_1482 = w5.s8_745 + fma(projection.Rz[31], w4.s7_179, w4.s8_631 - w4.s8_653);
  const double s8_1483 = fnma(projection.Rz[16], w3.s7_120, w5.s8_777 + s8_1482);
  const double s8_1484 = w5.s8_878 + fma(projection.Rz[13], w3.s7_103, s8_1483);
  w6.s8_1485 = fnma(w5.s8_914, s8_1449, fma(projection.Rz[1], w3.s7_54, s8_1484));
  const double s8_1486 = w5.s8_743 + fma(projection.Rz[30], w4.s7_179, w4.s8_629 - w4.s8_652);
  const double s8_1487 = fnma(projection.Rz[15], w3.s7_120, w5.s8_776 + s8_1486);
  const double s8_1488 = w5.s8_876 + fma(projection.Rz[12], w3.s7_103, s8_1487);
  const double s8_1489 = fnma(w5.s8_914, s8_1451, fma(projection.Rz[0], w3.s7_54, s8_1488));
  w6.s8_1490 = fnma(s8_1472, w6.s8_1485, s8_1489);
  w6.s8_1491 = w6.s8_1480*w6.s8_1490;
  const double s8_1492 = w5.s8_780 + (w5.s8_751 + (w4.s8_675 - w4.s8_616));
  const double s8_1493 = w5.s8_884 + fnma(projection.Rz[13], w3.s7_105, s8_1492);
  w6.s8_1494 = fnma(w5.s8_917, s8_1449, fnma(projection.Rz[1], w3.s7_56, s8_1493));
  const double s8_1495 = w5.s8_779 + (w5.s8_749 + (w4.s8_674 - w4.s8_615));
  const double s8_1496 = w5.s8_882 + fnma(projection.Rz[12], w3.s7_105, s8_1495);
  const double s8_1497 = fnma(w5.s8_917, s8_1451, fnma(projection.Rz[0], w3.s7_56, s8_1496));
  w6.s8_1498 = fnma(s8_1472, w6.s8_1494, s8_1497);
  w6.s8_1499 = w6.s8_1480*w6.s8_1498;
  const double s8_1500 = w5.s8_777 + fma(projection.Rz[31], w4.s7_179, w5.s8_745);
  const double s8_1501 = w5.s8_878 + fma(projection.Rz[13], w3.s7_103, s8_1500);
  const double s8_1502 = fnma(p_pitman_arm_x, w4.s8_631, -p_bell_crank_z*w4.s8_610);
  const double s8_1503 = w4.s8_663 + (w4.s8_641 + fnma(p_pitman_arm_z, w4.s8_632, s8_1502));
  const double s8_1504 = w5.s8_800 + (w5.s8_766 + fnma(w1.s1_33, w5.s8_740, s8_1503));
  const double s8_1505 = w5.s8_901 + fma(w1.r_carrier_left_aux1_z, w5.s8_871, s8_1504);
  const double s8_1506 = fnma(w5.s8_957, w6.s8_967, fnma(w5.s8_956, w5.s8_963, s8_1505));
  const double s8_1507 = fnma(w6.s8_1014, w6.s8_1025, fnma(w6.s8_1013, w6.s8_1021, s8_1506));
  const double s8_1508 = fnma(w6.s8_1066, w6.s8_1069, fma(w6.s8_1057, w6.s8_1067, s8_1507));
  const double s8_1509 = fnma(w6.s8_1122, w6.s8_1137, fma(w6.s8_1115, w6.s8_1128, s8_1508));
  const double s8_1510 = fma(w6.s8_1179, w6.s8_1183, fnma(w6.s8_1174, w6.s8_1177, s8_1509));
  const double s8_1511 = fma(projection.Rz[1], w3.s7_54, s8_1501);
  const double s8_1512 = fnma(p_lower_arm_left_x, s8_1511, fnma(w6.s8_1201, s8_1449, s8_1510));
  const double s8_1513 = fnma(0.5, fma(projection.Rz[16], w3.s7_116, w4.s8_656), s8_1512);
  const double s8_1514 = fma(projection.Rz[16], w3.s7_120, w4.s8_653);
  w6.s8_1515 = fma(p_arb_front_right_x, s8_1514, s8_1513);
  const double s8_1516 = w5.s8_776 + fma(projection.Rz[30], w4.s7_179, w5.s8_743);
  const double s8_1517 = w5.s8_876 + fma(projection.Rz[12], w3.s7_103, s8_1516);
  const double s8_1518 = fnma(p_pitman_arm_x, w4.s8_629, -p_bell_crank_z*w4.s8_609);
  const double s8_1519 = w4.s8_662 + (w4.s8_640 + fnma(p_pitman_arm_z, w4.s8_630, s8_1518));
  const double s8_1520 = w5.s8_799 + (w5.s8_764 + fnma(w1.s1_33, w5.s8_739, s8_1519));
  const double s8_1521 = w5.s8_899 + fma(w1.r_carrier_left_aux1_z, w5.s8_870, s8_1520);
  const double s8_1522 = fnma(w5.s8_957, w6.s8_966, fnma(w5.s8_956, w5.s8_961, s8_1521));
  const double s8_1523 = fnma(w6.s8_1014, w6.s8_1024, fnma(w6.s8_1013, w6.s8_1019, s8_1522));
  const double s8_1524 = fnma(w6.s8_1066, w6.s8_1068, fma(w6.s8_1056, w6.s8_1067, s8_1523));
  const double s8_1525 = fnma(w6.s8_1120, w6.s8_1137, fma(w6.s8_1114, w6.s8_1128, s8_1524));
  const double s8_1526 = fma(w6.s8_1179, w6.s8_1181, fnma(w6.s8_1173, w6.s8_1177, s8_1525));
  const double s8_1527 = fnma(s8_1472, w6.s8_1515, fnma(w6.s8_1201, s8_1451, s8_1526));
  const double s8_1528 = fma(projection.Rz[0], w3.s7_54, s8_1517);
  const double s8_1529 = fma(projection.Rz[15], w3.s7_116, w4.s8_655);
  const double s8_1530 = fnma(0.5, s8_1529, fnma(p_lower_arm_left_x, s8_1528, s8_1527));
  const double s8_1531 = fma(projection.Rz[15], w3.s7_120, w4.s8_652);
  w6.s8_1532 = fma(p_arb_front_right_x, s8_1531, s8_1530);
  w6.s8_1533 = w6.s8_1480*w6.s8_1532;
  const double s8_1534 = fnma(projection.Rz[31], w4.s7_179, w4.s8_631);
  const double s8_1535 = fnma(projection.Rz[16], w3.s7_118, w4.s8_679);
  const double s8_1536 = fnma(projection.Rz[34], w4.s7_194, s8_1535);
  const double s8_1537 = fma(p_bell_crank_z, w4.s8_616, s8_1536);
  const double s8_1538 = fma(w1.r_carrier_right_aux1_y, w5.s8_745, s8_1537);
  const double s8_1539 = w5.s8_783 + (w5.s8_772 + fma(w1.s1_33, w5.s8_751, s8_1538));
  const double s8_1540 = fma(w1.r_carrier_left_aux1_y, w5.s8_878, w5.s8_813 + s8_1539);
  const double s8_1541 = w5.s8_907 + fnma(w1.r_carrier_left_aux1_z, w5.s8_884, s8_1540);
  const double s8_1542 = fnma(w5.s8_947, w5.s8_957, w5.s8_919 + s8_1541);
  const double s8_1543 = fnma(w6.s8_1009, w6.s8_1014, fma(w5.s8_955, w5.s8_963, s8_1542));
  const double s8_1544 = fnma(w6.s8_1057, w6.s8_1063, fnma(w6.s8_1015, w6.s8_1021, s8_1543));
  const double s8_1545 = fma(w6.s8_1115, w6.s8_1127, fma(w6.s8_1060, w6.s8_1066, s8_1544));
  const double s8_1546 = fnma(w6.s8_1174, w6.s8_1178, fma(w6.s8_1134, w6.s8_1137, s8_1545));
  const double s8_1547 = fnma(w6.s8_1246, s8_1449, fnma(w6.s8_1179, w6.s8_1207, s8_1546));
  const double s8_1548 = fma(0.5, fma(projection.Rz[13], w3.s7_103, s8_1534), s8_1547);
  const double s8_1549 = fms(projection.Rz[1], w3.s7_54, w5.s8_777);
  const double s8_1550 = fnma(projection.Rz[1], w3.s7_56, w5.s8_780);
  const double s8_1551 = fma(p_lower_arm_left_y, s8_1549, s8_1548);
  const double s8_1552 = fnma(projection.Rz[13], w3.s7_105, w4.s8_675);
  const double s8_1553 = fnma(p_lower_arm_left_z, s8_1550, s8_1551);
  const double s8_1554 = fnma(projection.Rz[16], w3.s7_120, w4.s8_653);
  const double s8_1555 = fnma(p_upper_arm_right_z, s8_1552, s8_1553);
  w6.s8_1556 = fnma(p_arb_front_right_y, s8_1554, s8_1555);
  const double s8_1557 = fnma(projection.Rz[30], w4.s7_179, w4.s8_629);
  const double s8_1558 = fnma(projection.Rz[15], w3.s7_118, w4.s8_678);
  const double s8_1559 = fnma(projection.Rz[33], w4.s7_194, s8_1558);
  const double s8_1560 = fma(p_bell_crank_z, w4.s8_615, s8_1559);
  const double s8_1561 = fma(w1.r_carrier_right_aux1_y, w5.s8_743, s8_1560);
  const double s8_1562 = w5.s8_782 + (w5.s8_770 + fma(w1.s1_33, w5.s8_749, s8_1561));
  const double s8_1563 = fma(w1.r_carrier_left_aux1_y, w5.s8_876, w5.s8_812 + s8_1562);
  const double s8_1564 = w5.s8_905 + fnma(w1.r_carrier_left_aux1_z, w5.s8_882, s8_1563);
  const double s8_1565 = fnma(w5.s8_946, w5.s8_957, w5.s8_918 + s8_1564);
  const double s8_1566 = fnma(w6.s8_1008, w6.s8_1014, fma(w5.s8_955, w5.s8_961, s8_1565));
  const double s8_1567 = fnma(w6.s8_1056, w6.s8_1063, fnma(w6.s8_1015, w6.s8_1019, s8_1566));
  const double s8_1568 = fma(w6.s8_1114, w6.s8_1127, fma(w6.s8_1059, w6.s8_1066, s8_1567));
  const double s8_1569 = fnma(w6.s8_1173, w6.s8_1178, fma(w6.s8_1132, w6.s8_1137, s8_1568));
  const double s8_1570 = fnma(w6.s8_1246, s8_1451, fnma(w6.s8_1179, w6.s8_1205, s8_1569));
  const double s8_1571 = fma(projection.Rz[12], w3.s7_103, s8_1557);
  const double s8_1572 = fma(0.5, s8_1571, fnma(s8_1472, w6.s8_1556, s8_1570));
  const double s8_1573 = fms(projection.Rz[0], w3.s7_54, w5.s8_776);
  const double s8_1574 = fnma(projection.Rz[0], w3.s7_56, w5.s8_779);
  const double s8_1575 = fma(p_lower_arm_left_y, s8_1573, s8_1572);
  const double s8_1576 = fnma(projection.Rz[12], w3.s7_105, w4.s8_674);
  const double s8_1577 = fnma(p_lower_arm_left_z, s8_1574, s8_1575);
  const double s8_1578 = fnma(projection.Rz[15], w3.s7_120, w4.s8_652);
  const double s8_1579 = fnma(p_upper_arm_right_z, s8_1576, s8_1577);
  w6.s8_1580 = fnma(p_arb_front_right_y, s8_1578, s8_1579);
  w6.s8_1581 = w6.s8_1480*w6.s8_1580;
  const double s8_1582 = fnma(projection.Rz[13], w3.s7_105, w5.s8_780 + (w4.s8_675 + w5.s8_751));
  const double s8_1583 = fnma(projection.Rz[16], w3.s7_114, projection.Rz[34]*w4.s7_196);
  const double s8_1584 = fnma(p_bell_crank_x, w4.s8_616, w4.s8_613 + s8_1583);
  const double s8_1585 = fma(p_pitman_arm_y, w4.s8_632, s8_1584);
  const double s8_1586 = w5.s8_760 + fnma(w1.r_carrier_right_aux1_y, w5.s8_740, s8_1585);
  const double s8_1587 = w5.s8_895 + fnma(w1.r_carrier_left_aux1_y, w5.s8_871, s8_1586);
  const double s8_1588 = fma(w5.s8_955, w6.s8_967, fma(w5.s8_947, w5.s8_956, s8_1587));
  const double s8_1589 = fnma(w6.s8_1015, w6.s8_1025, fma(w6.s8_1009, w6.s8_1013, s8_1588));
  const double s8_1590 = fma(w6.s8_1063, w6.s8_1069, fnma(w6.s8_1060, w6.s8_1067, s8_1589));
  const double s8_1591 = fnma(w6.s8_1128, w6.s8_1134, fnma(w6.s8_1122, w6.s8_1127, s8_1590));
  const double s8_1592 = fnma(w6.s8_1177, w6.s8_1207, fnma(w6.s8_1178, w6.s8_1183, s8_1591));
  const double s8_1593 = fnma(projection.Rz[1], w3.s7_56, w5.s8_884 + s8_1582);
  const double s8_1594 = fma(p_lower_arm_left_x, s8_1593, fnma(w6.s8_1224, s8_1449, s8_1592));
  const double s8_1595 = fnma(projection.Rz[16], w3.s7_116, w4.s8_656);
  w6.s8_1596 = fnma(p_arb_front_right_y, s8_1595, s8_1594);
  const double s8_1597 = fnma(projection.Rz[12], w3.s7_105, w5.s8_779 + (w4.s8_674 + w5.s8_749));
  const double s8_1598 = fnma(projection.Rz[15], w3.s7_114, projection.Rz[33]*w4.s7_196);
  const double s8_1599 = fnma(p_bell_crank_x, w4.s8_615, w4.s8_612 + s8_1598);
  const double s8_1600 = fma(p_pitman_arm_y, w4.s8_630, s8_1599);
  const double s8_1601 = w5.s8_758 + fnma(w1.r_carrier_right_aux1_y, w5.s8_739, s8_1600);
  const double s8_1602 = w5.s8_893 + fnma(w1.r_carrier_left_aux1_y, w5.s8_870, s8_1601);
  const double s8_1603 = fma(w5.s8_955, w6.s8_966, fma(w5.s8_946, w5.s8_956, s8_1602));
  const double s8_1604 = fnma(w6.s8_1015, w6.s8_1024, fma(w6.s8_1008, w6.s8_1013, s8_1603));
  const double s8_1605 = fma(w6.s8_1063, w6.s8_1068, fnma(w6.s8_1059, w6.s8_1067, s8_1604));
  const double s8_1606 = fnma(w6.s8_1128, w6.s8_1132, fnma(w6.s8_1120, w6.s8_1127, s8_1605));
  const double s8_1607 = fnma(w6.s8_1177, w6.s8_1205, fnma(w6.s8_1178, w6.s8_1181, s8_1606));
  const double s8_1608 = fnma(s8_1472, w6.s8_1596, fnma(w6.s8_1224, s8_1451, s8_1607));
  const double s8_1609 = fnma(projection.Rz[0], w3.s7_56, w5.s8_882 + s8_1597);
  const double s8_1610 = fnma(projection.Rz[15], w3.s7_116, w4.s8_655);
  const double s8_1611 = fma(p_lower_arm_left_x, s8_1609, s8_1608);
  w6.s8_1612 = fnma(p_arb_front_right_y, s8_1610, s8_1611);
  w6.s8_1613 = w6.s8_1480*w6.s8_1612;
  w6.s8_1614 = w6.s8_1471*w6.s8_1476;
  w6.s8_1615 = w6.s8_1471*w6.s8_1485;
  w6.s8_1616 = w6.s8_1471*w6.s8_1494;
  w6.s8_1617 = w6.s8_1471*w6.s8_1515;
  w6.s8_1618 = w6.s8_1471*w6.s8_1556;
  w6.s8_1619 = w6.s8_1471*w6.s8_1596;
  w7.s8_1620 = w5.s8_874*w6.s8_1448;
  w7.s8_1621 = w5.s8_914*w6.s8_1448;
  w7.s8_1622 = w5.s8_917*w6.s8_1448;
  w7.s8_1623 = w6.s8_1201*w6.s8_1448;
  w7.s8_1624 = w6.s8_1246*w6.s8_1448;
  w7.s8_1625 = w6.s8_1224*w6.s8_1448;
  const double s8_1626 = fma(w2.s7_6, w3.s3_26, w2.s7_3*w3.s3_20);
  const double s8_1627 = fnma(w4.s8_597, w4.f_carrier_right_y, s8_1626);
  const double s8_1628 = fnma(w4.s8_596, w4.f_carrier_right_z, s8_1627);
  const double s8_1629 = fnma(w4.s8_595, w4.n_carrier_right_x, s8_1628);
  const double s8_1630 = fma(w4.s8_594, w5.f_carrier_left_y, s8_1629);
  const double s8_1631 = fnma(w4.s8_593, w5.f_carrier_left_z, s8_1630);
  const double s8_1632 = fma(w6.s8_967, w6.s8_976, fnma(w4.s8_592, w5.n_carrier_left_x, s8_1631));
  const double s8_1633 = fnma(w5.s8_963, w6.s8_989, fnma(w5.s8_947, w6.s8_982, s8_1632));
  const double s8_1634 = fma(w6.s8_1025, w6.s8_1040, fnma(w6.s8_1009, w6.s8_1034, s8_1633));
  const double s8_1635 = fma(w6.s8_1069, w6.s8_1086, fnma(w6.s8_1021, w6.s8_1047, s8_1634));
  const double s8_1636 = fma(w6.s8_1060, w6.s8_1095, fma(w6.s8_1057, w6.s8_1091, s8_1635));
  const double s8_1637 = fnma(w6.s8_1122, w6.s8_1148, fnma(w6.s8_1115, w6.s8_1142, s8_1636));
  const double s8_1638 = fnma(w6.s8_1174, w6.s8_1350, fnma(w6.s8_1134, w6.s8_1155, s8_1637));
  const double s8_1639 = fma(w6.s8_1207, w6.s8_1363, fma(w6.s8_1183, w6.s8_1356, s8_1638));
  const double s8_1640 = fma(projection.Rz[1], w6.s8_1366, s8_1639);
  const double s8_1641 = fma(projection.Rz[13], w6.s8_1369, s8_1640);
  const double s8_1642 = fma(projection.Rz[16], w6.s8_1373, s8_1641);
  const double s8_1643 = fma(projection.Rz[19], w6.s8_1377, s8_1642);
  const double s8_1644 = fma(projection.Rz[31], w6.s8_1380, s8_1643);
  const double s8_1645 = fma(projection.Rz[34], w6.s8_1385, s8_1644);
  const double s8_1646 = fma(projection.Rz[37], w6.s8_1389, s8_1645);
  const double s8_1647 = fma(w3.s3_34, s8_1397, fma(projection.Rz[40], w6.s8_1393, s8_1646));
  const double s8_1648 = fma(w3.s3_52, s8_1404, fma(w3.s3_43, s8_1401, s8_1647));
  w7.s8_1649 = fnma(w6.s8_1431, s8_1449, fma(w3.s3_61, s8_1407, s8_1648));
  const double s8_1650 = fma(w2.s7_6, w3.s3_24, w2.s7_3*w3.s3_18);
  const double s8_1651 = fnma(w4.s8_591, w4.f_carrier_right_y, s8_1650);
  const double s8_1652 = fnma(w4.s8_590, w4.f_carrier_right_z, s8_1651);
  const double s8_1653 = fnma(w4.s8_589, w4.n_carrier_right_x, s8_1652);
  const double s8_1654 = fma(w4.s8_588, w5.f_carrier_left_y, s8_1653);
  const double s8_1655 = fnma(w4.s8_587, w5.f_carrier_left_z, s8_1654);
  const double s8_1656 = fma(w6.s8_966, w6.s8_976, fnma(w4.s8_586, w5.n_carrier_left_x, s8_1655));
  const double s8_1657 = fnma(w5.s8_961, w6.s8_989, fnma(w5.s8_946, w6.s8_982, s8_1656));
  const double s8_1658 = fma(w6.s8_1024, w6.s8_1040, fnma(w6.s8_1008, w6.s8_1034, s8_1657));
  const double s8_1659 = fma(w6.s8_1068, w6.s8_1086, fnma(w6.s8_1019, w6.s8_1047, s8_1658));
  const double s8_1660 = fma(w6.s8_1059, w6.s8_1095, fma(w6.s8_1056, w6.s8_1091, s8_1659));
  const double s8_1661 = fnma(w6.s8_1120, w6.s8_1148, fnma(w6.s8_1114, w6.s8_1142, s8_1660));
  const double s8_1662 = fnma(w6.s8_1173, w6.s8_1350, fnma(w6.s8_1132, w6.s8_1155, s8_1661));
  const double s8_1663 = fma(w6.s8_1205, w6.s8_1363, fma(w6.s8_1181, w6.s8_1356, s8_1662));
  const double s8_1664 = fma(projection.Rz[0], w6.s8_1366, s8_1663);
  const double s8_1665 = fma(projection.Rz[12], w6.s8_1369, s8_1664);
  const double s8_1666 = fma(projection.Rz[15], w6.s8_1373, s8_1665);
  const double s8_1667 = fma(projection.Rz[18], w6.s8_1377, s8_1666);
  const double s8_1668 = fma(projection.Rz[30], w6.s8_1380, s8_1667);
  const double s8_1669 = fma(projection.Rz[33], w6.s8_1385, s8_1668);
  const double s8_1670 = fma(projection.Rz[36], w6.s8_1389, s8_1669);
  const double s8_1671 = fma(w3.s3_31, s8_1397, fma(projection.Rz[39], w6.s8_1393, s8_1670));
  const double s8_1672 = fma(w3.s3_49, s8_1404, fma(w3.s3_40, s8_1401, s8_1671));
  const double s8_1673 = fnma(w6.s8_1431, s8_1451, fma(w3.s3_58, s8_1407, s8_1672));
  w7.s8_1674 = fnma(s8_1472, w7.s8_1649, s8_1673);
  const double s8_1675 = fma(w3.s8_402, w3.s8_562, w3.s8_509*w3.s8_531);
  const double s8_1676 = fma(w6.s8_1596, w6.s8_1615, fma(w6.s8_1491, w6.s8_1612, s8_1675));
  w7.s8_1677 = fma(w6.s8_1224, w7.s8_1621, s8_1676);
  // operations: 1395 add, 1489 multiply, 3 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1678 = w5.s8_818 - w4.s8_677;
  const double s8_1679 = w4.s8_668 + w5.s8_803;
  const double s8_1680 = w2.s8_32 + w2.s8_48;
  const double s8_1681 = w2.s8_29 + w2.s8_44;
  const double s8_1682 = w4.s7_201 + (w3.s7_125 + (w2.s7_50 + (w2.s7_41 - 70.9875)));
  const double s8_1683 = fma(p_bell_crank_z, w4.s8_623, w4.s7_208 + s8_1682);
  const double s8_1684 = fma(p_pitman_arm_z, w4.s8_644, fnma(p_pitman_arm_x, w4.s8_637, s8_1683));
  const double s8_1685 = fma(p_lower_arm_left_x, w5.s8_924 + (s8_1678 - w5.s8_786), s8_1684);
  const double s8_1686 = fnma(p_carrier_left_rz_y, s8_1680, fnma(0.5, s8_1679, s8_1685));
  const double s8_1687 = fma(p_arb_front_right_x, w4.s8_660 + w5.s8_798, s8_1686);
  w7.s8_1688 = fnma(p_arb_rear_right_x, s8_1681, s8_1687);
  const double s8_1689 = w3.s7_116 + (w3.s7_105 + (w3.s7_56 - w2.s7_38 - w2.s7_46)) - w3.s7_131;
  w7.s8_1690 = 3289.7 + (w4.s7_190 + (s8_1689 - w4.s7_181) - w4.s7_205);
  const double s8_1691 = w4.s7_192 + (w3.s7_120 + (w2.s7_45 + (356.525 + w2.s7_36))) - w4.s7_204;
  w7.s8_1692 = s8_1691 - w4.s7_214;
  const double s8_1693 = w3.s7_127 + (w3.s7_112 + (w3.s7_63 + (w2.s7_43 + w2.s7_52)));
  const double s8_1694 = w4.s7_210 + (w4.s7_203 + (w4.s7_188 + (w3.s7_138 + s8_1693)));
  const double s8_1695 = fma(0.9, s8_1681, fma(0.8, w4.s8_637, s8_1694) - w4.s8_660 - w5.s8_798);
  const double s8_1696 = fma(1.24, w5.s8_786 - w5.s8_924, fnma(0.56, s8_1678, s8_1695));
  w7.s8_1697 = 10856.945 + s8_1696;
  const double s8_1698 = w4.s7_219 + (w4.s7_187 + (w3.s7_137 + (w3.s7_62 + w3.s7_111)));
  const double s8_1699 = fma(0.8, w5.s8_922 - w5.s8_790, w5.s8_816 + (s8_1698 - w4.s8_682));
  w7.s8_1700 = 5020.856800000031 + s8_1699;
  const double s8_1701 = w4.s7_209 + (w4.s7_202 + (w3.s7_126 + (w2.s7_42 + w2.s7_51)));
  const double s8_1702 = fma(8.8, w4.s8_644, fma(6.5, w4.s8_623, w4.s7_218 + s8_1701));
  w7.s8_1703 = 141129.72 + fnma(6.6, s8_1680, fma(7.9, s8_1679, s8_1702));
  const double s8_1704 = fnma(w2.s8_107, w3.s8_561, fnma(w3.s8_505, w3.s8_506, 15306.0));
  const double s8_1705 = fnma(w6.s8_1476, w6.s8_1614, fnma(w6.s8_1479, w6.s8_1481, s8_1704));
  w7.s8_1706 = fnma(w5.s8_874, w7.s8_1620, s8_1705);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_1707 = w3.s7_147 + (w3.s7_69 + fma(m_rear_axle, z_rear_axle_ty, w2.s7_8));
  const double s8_1708 = w1.r_carrier_left_aux1_y + w1.r_carrier_right_aux1_y;
  w7.s8_1709 = fma(m_carrier_right, s8_1708, w5.s8_910 + s8_1707);
  const double s8_1710 = fma(w3.s8_402, w3.s8_561, w3.s8_506*w3.s8_531);
  const double s8_1711 = fma(w6.s8_1596, w6.s8_1614, fma(w6.s8_1481, w6.s8_1612, s8_1710));
  w7.s8_1712 = w7.s8_1709 + fma(w6.s8_1224, w7.s8_1620, s8_1711);
  const double s8_1713 = fnma(w2.s8_166, w2.s8_167, fma(w2.s8_114, w2.s8_139, w2.s7_33));
  const double s8_1714 = fnma(w2.s8_247, w2.s8_248, fnma(w2.s8_207, w2.s8_208, s8_1713));
  const double s8_1715 = fnma(w3.s8_320, w3.s8_335, fnma(w2.s8_282, w3.s8_299, s8_1714));
  const double s8_1716 = w4.s7_176 + (w3.s7_100 + fnma(w3.s8_357, w3.s8_366, s8_1715));
  const double s8_1717 = fma(w5.s8_888, w5.s8_891, fma(w5.s8_755, w5.s8_775, s8_1716));
  const double s8_1718 = fnma(w6.s8_999, w6.s8_1015, fnma(w5.s8_954, w5.s8_955, s8_1717));
  const double s8_1719 = fnma(w6.s8_1126, w6.s8_1127, fnma(w6.s8_1062, w6.s8_1063, s8_1718));
  w7.s8_1720 = w7.s8_1700 + fnma(w6.s8_1167, w6.s8_1178, s8_1719);
  const double s8_1721 = fnma(w2.s8_150, w2.s8_168, fma(w2.s8_113, w2.s8_140, w2.s7_30));
  const double s8_1722 = fnma(w2.s8_245, w2.s8_249, fnma(w2.s8_192, w2.s8_209, s8_1721));
  const double s8_1723 = fnma(w3.s8_322, w3.s8_336, fnma(w3.s8_286, w3.s8_300, s8_1722));
  const double s8_1724 = w4.s7_173 + (w3.s7_97 + fnma(w3.s8_379, w3.s8_380, s8_1723));
  const double s8_1725 = fnma(w6.s8_1012, w6.s8_1013, fnma(w5.s8_950, w5.s8_956, s8_1724));
  const double s8_1726 = fnma(w6.s8_1125, w6.s8_1128, fnma(w6.s8_1065, w6.s8_1067, s8_1725));
  const double s8_1727 = w7.s8_1703 + fnma(w6.s8_1176, w6.s8_1177, s8_1726);
  const double s8_1728 = fma(7.2, w5.s8_754 + w5.s8_889, s8_1727);
  const double s8_1729 = fnma(w3.s8_402, w3.s8_564, fnma(w3.s8_531, w3.s8_532, w7.s8_1720));
  const double s8_1730 = fnma(w6.s8_1596, w6.s8_1619, fnma(w6.s8_1612, w6.s8_1613, s8_1729));
  const double pivot_chassis_rx = s8_1728 + fnma(w6.s8_1224, w7.s8_1625, s8_1730);
  result.inertia[5] = pivot_chassis_rx;
  w7.s8_1731 = 1.0/pivot_chassis_rx;
  w7.s8_1732 = w7.s8_1712*w7.s8_1731;
  const double s8_1733 = w3.s7_66 + fma(m_rear_axle, w1.r_rear_axle_aux3_z, w2.s7_10);
  const double s8_1734 = w1.r_carrier_left_aux1_z - w1.s1_33;
  w7.s8_1735 = fma(m_carrier_right, s8_1734, w7.s8_1690 + (w3.s7_144 + s8_1733));
  const double s8_1736 = fma(w1.r_rear_axle_aux3_z, w2.s8_114, w2.s7_26);
  const double s8_1737 = fma(w2.s8_145, w2.s8_167, fma(z_rear_axle_ty, w2.s8_115, s8_1736));
  const double s8_1738 = fma(w2.s8_239, w2.s8_248, fma(w2.s8_188, w2.s8_208, s8_1737));
  const double s8_1739 = fnma(w3.s8_318, w3.s8_335, fnma(w2.s8_284, w3.s8_299, s8_1738));
  const double s8_1740 = fma(w3.s8_531, w3.s8_545, fnma(w3.s8_365, w3.s8_366, s8_1739));
  const double s8_1741 = w3.s7_161 + (w3.s7_85 + fma(w3.s8_402, w3.s8_565, s8_1740));
  const double s8_1742 = fnma(w1.s1_33, w5.s8_755, s8_1741);
  const double s8_1743 = fma(w1.r_carrier_right_aux1_y, w5.s8_756, s8_1742);
  const double s8_1744 = fma(w1.r_carrier_left_aux1_y, w5.s8_887, s8_1743);
  const double s8_1745 = fma(w1.r_carrier_left_aux1_z, w5.s8_888, s8_1744);
  const double s8_1746 = fma(w6.s8_1011, w6.s8_1015, fnma(w5.s8_949, w5.s8_955, s8_1745));
  const double s8_1747 = fma(w6.s8_1105, w6.s8_1127, fnma(w6.s8_1063, w6.s8_1064, s8_1746));
  const double s8_1748 = w6.s8_1447 + fnma(w6.s8_1163, w6.s8_1178, s8_1747);
  const double s8_1749 = fma(w6.s8_1596, w6.s8_1617, fma(w6.s8_1533, w6.s8_1612, s8_1748));
  w7.s8_1750 = fma(w6.s8_1224, w7.s8_1623, s8_1749);
  w7.s8_1751 = w7.s8_1731*w7.s8_1750;
  const double s8_1752 = fnma(w3.s8_414, w3.s8_561, fnma(w3.s8_506, w3.s8_544, w7.s8_1735));
  const double s8_1753 = fnma(w6.s8_1515, w6.s8_1614, fnma(w6.s8_1481, w6.s8_1532, s8_1752));
  w7.s8_1754 = fnma(w7.s8_1712, w7.s8_1751, fnma(w6.s8_1201, w7.s8_1620, s8_1753));
  const double s8_1755 = fnma(w2.s8_145, w2.s8_169, fma(w2.s8_115, w2.s8_138, w2.s7_34));
  const double s8_1756 = fnma(w2.s8_239, w2.s8_262, fnma(w2.s8_188, w2.s8_210, s8_1755));
  const double s8_1757 = fnma(w3.s8_318, w3.s8_337, fnma(w2.s8_284, w3.s8_301, s8_1756));
  const double s8_1758 = w4.s7_177 + (w3.s7_101 + fnma(w3.s8_365, w3.s8_381, s8_1757));
  const double s8_1759 = fma(w5.s8_887, w5.s8_890, fnma(w5.s8_738, w5.s8_756, s8_1758));
  const double s8_1760 = fnma(w6.s8_1011, w6.s8_1014, fnma(w5.s8_949, w5.s8_957, s8_1759));
  const double s8_1761 = fnma(w6.s8_1105, w6.s8_1137, fnma(w6.s8_1064, w6.s8_1066, s8_1760));
  w7.s8_1762 = w7.s8_1697 + fnma(w6.s8_1163, w6.s8_1179, s8_1761);
  const double s8_1763 = fnma(w3.s8_414, w3.s8_565, fnma(w3.s8_544, w3.s8_545, s8_1728));
  const double s8_1764 = fnma(w6.s8_1515, w6.s8_1617, fnma(w6.s8_1532, w6.s8_1533, s8_1763));
  w7.s8_1765 = w7.s8_1762 + fnma(w6.s8_1201, w7.s8_1623, s8_1764);
  w7.pivot_chassis_ry = fnma(w7.s8_1750, w7.s8_1751, w7.s8_1765);
  w7.s8_1766 = 1.0/w7.pivot_chassis_ry;
  w7.s8_1767 = w7.s8_1754*w7.s8_1766;
  const double s8_1768 = fma(w1.r_rear_axle_aux3_z, w2.s8_113, w2.s7_28);
  const double s8_1769 = fma(w1.r_rear_axle_aux1_x, w2.s8_115, s8_1768);
  const double s8_1770 = fnma(w2.s8_188, w2.s8_209, fnma(w2.s8_145, w2.s8_168, s8_1769));
  const double s8_1771 = fnma(w2.s8_284, w3.s8_300, fma(w2.s8_239, w2.s8_249, s8_1770));
  const double s8_1772 = fma(w3.s8_365, w3.s8_380, fnma(w3.s8_318, w3.s8_336, s8_1771));
  const double s8_1773 = w3.s7_93 + fma(w3.s8_402, w3.s8_563, fma(w3.s8_521, w3.s8_531, s8_1772));
  const double s8_1774 = fnma(w1.s1_33, w5.s8_754, w3.s7_169 + s8_1773);
  const double s8_1775 = fma(w1.r_carrier_left_aux1_z, w5.s8_889, s8_1774);
  const double s8_1776 = fnma(w6.s8_1011, w6.s8_1013, fnma(w5.s8_949, w5.s8_956, s8_1775));
  const double s8_1777 = fnma(w6.s8_1105, w6.s8_1128, fnma(w6.s8_1064, w6.s8_1067, s8_1776));
  const double s8_1778 = fma(w6.s8_1581, w6.s8_1612, fma(w6.s8_1163, w6.s8_1177, s8_1777));
  const double s8_1779 = fma(w6.s8_1224, w7.s8_1624, fma(w6.s8_1596, w6.s8_1618, s8_1778));
  w7.s8_1780 = fma(p_lower_arm_left_x, w5.s8_756 + w5.s8_887, w7.s8_1688 + s8_1779);
  const double s8_1781 = fma(z_rear_axle_ty, w2.s8_113, w2.s7_19);
  const double s8_1782 = fma(w1.r_rear_axle_aux1_x, w2.s8_114, s8_1781);
  const double s8_1783 = fma(w2.s8_207, w2.s8_209, fma(w2.s8_166, w2.s8_168, s8_1782));
  const double s8_1784 = fnma(w2.s8_282, w3.s8_300, fnma(w2.s8_247, w2.s8_249, s8_1783));
  const double s8_1785 = fma(w3.s8_357, w3.s8_380, fnma(w3.s8_320, w3.s8_336, s8_1784));
  const double s8_1786 = w3.s7_95 + fma(w3.s8_414, w3.s8_563, fma(w3.s8_521, w3.s8_544, s8_1785));
  const double s8_1787 = fma(w1.r_carrier_right_aux1_y, w5.s8_754, w3.s7_171 + s8_1786);
  const double s8_1788 = fma(w1.r_carrier_left_aux1_y, w5.s8_889, s8_1787);
  const double s8_1789 = fma(w6.s8_999, w6.s8_1013, fnma(w5.s8_954, w5.s8_956, s8_1788));
  const double s8_1790 = fma(w6.s8_1126, w6.s8_1128, fnma(w6.s8_1062, w6.s8_1067, s8_1789));
  const double s8_1791 = w6.s8_1438 + fma(w6.s8_1167, w6.s8_1177, s8_1790);
  const double s8_1792 = fma(w6.s8_1515, w6.s8_1618, fma(w6.s8_1532, w6.s8_1581, s8_1791));
  const double s8_1793 = fma(w7.s8_1751, w7.s8_1780, fma(w6.s8_1201, w7.s8_1624, s8_1792));
  w7.s8_1794 = fma(p_lower_arm_left_x, w5.s8_755 + w5.s8_888, s8_1793);
}

/// Part 6 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63);
/// step 9: accelerations from the root to the leaves (63), (62).
[[gnu::noinline]] void compute_chosen_accelerations_6(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork1& __restrict w1,
    ChosenAccelerationsWork2& __restrict w2, ChosenAccelerationsWork3& __restrict w3,
    ChosenAccelerationsWork4& __restrict w4, ChosenAccelerationsWork5& __restrict w5,
    ChosenAccelerationsWork6& __restrict w6, ChosenAccelerationsWork7& __restrict w7,
    ChosenAccelerationsWork8& __restrict w8, ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1795 = w7.s8_1766*w7.s8_1794;
  const double s8_1796 = w7.s8_1731*w7.s8_1780;
  const double s8_1797 = fnma(w3.s8_506, w3.s8_520, w7.s8_1754*s8_1795);
  const double s8_1798 = fnma(w6.s8_1481, w6.s8_1580, fnma(w3.s8_391, w3.s8_561, s8_1797));
  const double s8_1799 = fnma(w6.s8_1246, w7.s8_1620, fnma(w6.s8_1556, w6.s8_1614, s8_1798));
  const double s8_1800 = fnma(w7.s8_1712, s8_1796, s8_1799);
  const double s8_1801 = fnma(w3.s8_391, w3.s8_563, fnma(w3.s8_520, w3.s8_521, w7.s8_1720));
  const double s8_1802 = fnma(w6.s8_1556, w6.s8_1618, fnma(w6.s8_1580, w6.s8_1581, s8_1801));
  const double s8_1803 = w7.s8_1762 + fnma(w6.s8_1246, w7.s8_1624, s8_1802);
  const double pivot_chassis_rz = fnma(w7.s8_1780, s8_1796, fnma(w7.s8_1794, s8_1795, s8_1803));
  const double s8_1804 = 1.0/pivot_chassis_rz;
  const double s8_1805 = s8_1800*s8_1804;
  const double s8_1806 = w3.s7_71 + (w2.s7_12 + fma(m_rear_axle, w1.r_rear_axle_aux1_x, 1580.4));
  const double s8_1807 = w7.s8_1692 + (w3.s7_141 + s8_1806);
  const double s8_1808 = fma(w3.s8_414, w3.s8_562, w3.s8_509*w3.s8_544);
  const double s8_1809 = fma(w6.s8_1515, w6.s8_1615, fma(w6.s8_1491, w6.s8_1532, s8_1808));
  const double s8_1810 = fma(w7.s8_1677, w7.s8_1751, fma(w6.s8_1201, w7.s8_1621, s8_1809));
  const double s8_1811 = s8_1807 + s8_1810;
  const double s8_1812 = w7.s8_1766*s8_1811;
  const double s8_1813 = w7.s8_1677*w7.s8_1731;
  const double s8_1814 = fnma(w3.s8_391, w3.s8_562, fnma(w3.s8_509, w3.s8_520, w7.s8_1709));
  const double s8_1815 = fnma(w6.s8_1556, w6.s8_1615, fnma(w6.s8_1491, w6.s8_1580, s8_1814));
  const double s8_1816 = fnma(w7.s8_1677, s8_1796, fnma(w6.s8_1246, w7.s8_1621, s8_1815));
  const double s8_1817 = fnma(s8_1795, s8_1811, s8_1816);
  const double s8_1818 = s8_1804*s8_1817;
  const double s8_1819 = fnma(w3.s8_506, w3.s8_508, w7.s8_1754*s8_1812);
  const double s8_1820 = fnma(w6.s8_1481, w6.s8_1490, fnma(w2.s8_112, w3.s8_561, s8_1819));
  const double s8_1821 = fnma(w5.s8_914, w7.s8_1620, fnma(w6.s8_1485, w6.s8_1614, s8_1820));
  const double s8_1822 = fnma(s8_1800, s8_1818, fnma(w7.s8_1712, s8_1813, s8_1821));
  const double s8_1823 = fnma(w2.s8_112, w3.s8_562, fnma(w3.s8_508, w3.s8_509, 15306.0));
  const double s8_1824 = fnma(w6.s8_1485, w6.s8_1615, fnma(w6.s8_1490, w6.s8_1491, s8_1823));
  const double s8_1825 = fnma(w5.s8_914, w7.s8_1621, s8_1824);
  const double s8_1826 = fnma(w7.s8_1677, s8_1813, fnma(s8_1811, s8_1812, s8_1825));
  const double pivot_chassis_tz = fnma(s8_1817, s8_1818, s8_1826);
  const double s8_1827 = 1.0/pivot_chassis_tz;
  const double s8_1828 = s8_1822*s8_1827;
  const double s8_1829 = fnma(w3.s8_402, w3.s8_546, fnma(w3.s8_503, w3.s8_531, s8_1807));
  const double s8_1830 = fnma(w6.s8_1596, w6.s8_1616, fnma(w6.s8_1499, w6.s8_1612, s8_1829));
  const double s8_1831 = fnma(w6.s8_1224, w7.s8_1622, s8_1830);
  const double s8_1832 = w7.s8_1731*s8_1831;
  const double s8_1833 = fnma(w3.s8_503, w3.s8_544, w7.s8_1751*s8_1831);
  const double s8_1834 = fnma(w6.s8_1499, w6.s8_1532, fnma(w3.s8_414, w3.s8_546, s8_1833));
  const double s8_1835 = fnma(w6.s8_1201, w7.s8_1622, fnma(w6.s8_1515, w6.s8_1616, s8_1834));
  const double s8_1836 = w7.s8_1766*s8_1835;
  const double s8_1837 = fnma(w3.s8_391, w3.s8_546, fnma(w3.s8_503, w3.s8_520, s8_1796*s8_1831));
  const double s8_1838 = fnma(w6.s8_1556, w6.s8_1616, fnma(w6.s8_1499, w6.s8_1580, s8_1837));
  const double s8_1839 = fnma(w6.s8_1246, w7.s8_1622, s8_1838) - w7.s8_1735;
  const double s8_1840 = fma(s8_1795, s8_1835, s8_1839);
  const double s8_1841 = s8_1804*s8_1840;
  const double s8_1842 = fnma(w2.s8_112, w3.s8_546, fnma(w3.s8_503, w3.s8_508, s8_1813*s8_1831));
  const double s8_1843 = fnma(w6.s8_1485, w6.s8_1616, fnma(w6.s8_1490, w6.s8_1499, s8_1842));
  const double s8_1844 = fma(s8_1812, s8_1835, fnma(w5.s8_914, w7.s8_1622, s8_1843));
  const double s8_1845 = fnma(s8_1818, s8_1840, s8_1844);
  const double s8_1846 = s8_1827*s8_1845;
  const double s8_1847 = fnma(w3.s8_501, w3.s8_506, w7.s8_1712*s8_1832);
  const double s8_1848 = fnma(w6.s8_1481, w6.s8_1498, fnma(w2.s8_125, w3.s8_561, s8_1847));
  const double s8_1849 = fnma(w5.s8_917, w7.s8_1620, fnma(w6.s8_1494, w6.s8_1614, s8_1848));
  const double s8_1850 = fnma(s8_1800, s8_1841, fnma(w7.s8_1754, s8_1836, s8_1849));
  const double s8_1851 = fnma(s8_1822, s8_1846, s8_1850);
  const double s8_1852 = fnma(w2.s8_125, w3.s8_546, fnma(w3.s8_501, w3.s8_503, 15306.0));
  const double s8_1853 = fnma(w6.s8_1494, w6.s8_1616, fnma(w6.s8_1498, w6.s8_1499, s8_1852));
  const double s8_1854 = fnma(w5.s8_917, w7.s8_1622, s8_1853);
  const double s8_1855 = fnma(s8_1835, s8_1836, fnma(s8_1831, s8_1832, s8_1854));
  const double pivot_chassis_ty = fnma(s8_1845, s8_1846, fnma(s8_1840, s8_1841, s8_1855));
  const double s8_1856 = 1.0/pivot_chassis_ty;
  const double s8_1857 = s8_1851*s8_1856;
  const double s8_1858 = fnma(w7.s8_1754, w7.s8_1767, fnma(w7.s8_1712, w7.s8_1732, w7.s8_1706));
  const double s8_1859 = fnma(s8_1822, s8_1828, fnma(s8_1800, s8_1805, s8_1858));
  const double pivot_chassis_tx = fnma(s8_1851, s8_1857, s8_1859);
  const double s8_1860 = fnma(1e-12, w7.s8_1765, w7.pivot_chassis_ry);
  const double s8_1861 = w5.s8_823 - w4.s8_686;
  const double s8_1862 = w5.s8_929 - w4.f_carrier_right_y - w5.s8_791 - w5.f_carrier_left_y;
  const double s8_1863 = w2.s8_35 + w2.s8_52;
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double s1_6 = w8.sines[2];
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  const double s8_1864 = fnma(s1_6, tau_chassis_ry, tau_chassis_rz*w1.s1_49);
  const double s8_1865 = fma(tau_chassis_rx, w1.s1_51, s8_1864);
  const double s8_1866 = fnma(projection.zdd_star[20], w2.s7_37, s8_1865);
  const double s8_1867 = fma(w2.s7_47, w2.s8_28, fma(projection.zdd_star[21], w2.s7_44, s8_1866));
  const double s8_1868 = fnma(w2.s7_51, w2.s8_34, fnma(w2.s7_50, w2.s8_30, s8_1867));
  const double s8_1869 = fnma(w2.s7_41, w2.s8_50, fnma(w2.s7_35, w2.s8_47, s8_1868));
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_1870 = fma(z_rear_axle_ty, w2.f_rear_axle_x, fnma(w2.s7_42, w2.s8_51, s8_1869));
  const double s8_1871 = fnma(w1.r_rear_axle_aux1_x, w2.f_rear_axle_y, s8_1870);
  const double s8_1872 = fnma(w2.s8_166, w2.s8_174, s8_1871 - w2.n_rear_axle_z);
  const double s8_1873 = fnma(w2.s8_207, w2.s8_216, fnma(w2.s8_150, w2.s8_184, s8_1872));
  const double s8_1874 = fnma(w2.s8_247, w2.s8_275, fnma(w2.s8_192, w2.s8_226, s8_1873));
  const double s8_1875 = fnma(w3.s8_286, w3.s8_306, fma(w2.s8_245, w2.s8_280, s8_1874));
  const double s8_1876 = fnma(w3.s8_322, w3.s8_342, fma(w2.s8_282, w3.s8_316, s8_1875));
  const double s8_1877 = fma(w3.s8_379, w3.s8_455, fma(w3.s8_320, w3.s8_352, s8_1876));
  const double s8_1878 = fnma(w3.s8_532, w3.s8_560, fma(w3.s8_357, w3.s8_467, s8_1877));
  const double s8_1879 = fnma(w3.s8_497, w3.s8_564, s8_1878);
  const double s8_1880 = fma(projection.zdd_star[5], w3.s7_114, s8_1879);
  const double s8_1881 = fnma(projection.zdd_star[11], w4.s7_196, s8_1880);
  const double s8_1882 = fma(p_bell_crank_x, w4.s8_627, s8_1881);
  const double s8_1883 = fnma(0.9515, projection.zdd_star[13], s8_1882);
  const double s8_1884 = fnma(w4.s7_208, w4.s8_639, fnma(w4.s7_209, w4.s8_638, s8_1883));
  const double s8_1885 = fnma(w4.s7_194, w4.s8_659, fma(p_pitman_arm_x, w4.s8_643, s8_1884));
  const double s8_1886 = fnma(w4.s7_202, w4.s8_665, fnma(w4.s7_201, w4.s8_661, s8_1885));
  const double s8_1887 = fma(w4.s7_187, w4.s8_684, fma(w4.s7_186, w4.s8_683, s8_1886));
  const double s8_1888 = fma(w1.r_carrier_right_aux1_y, w4.f_carrier_right_x, s8_1887);
  const double s8_1889 = fma(w3.s7_136, w5.s8_787, s8_1888 - w5.n_carrier_right_z);
  const double s8_1890 = fnma(w3.s7_118, w5.s8_802, fma(w3.s7_137, w5.s8_788, s8_1889));
  const double s8_1891 = fnma(w3.s7_126, w5.s8_805, fnma(w3.s7_125, w5.s8_804, s8_1890));
  const double s8_1892 = fma(w3.s7_110, w5.s8_819, fma(w3.s7_111, w5.s8_817, s8_1891));
  const double s8_1893 = fma(w1.r_carrier_left_aux1_y, w5.f_carrier_left_x, s8_1892);
  const double s8_1894 = fma(w3.s7_62, w5.s8_923, s8_1893 - w5.n_carrier_left_z);
  const double s8_1895 = fnma(w5.s8_954, w6.s8_976, fma(w3.s7_61, w5.s8_925, s8_1894));
  const double s8_1896 = fma(w6.s8_1012, w6.s8_1034, fma(w5.s8_950, w6.s8_982, s8_1895));
  const double s8_1897 = fnma(w6.s8_1062, w6.s8_1086, fma(w6.s8_999, w6.s8_1040, s8_1896));
  const double s8_1898 = fnma(w6.s8_1126, w6.s8_1148, fma(w6.s8_1065, w6.s8_1095, s8_1897));
  const double s8_1899 = fma(w6.s8_1167, w6.s8_1356, fnma(w6.s8_1125, w6.s8_1155, s8_1898));
  const double s8_1900 = fnma(w2.s8_31, w6.s8_1438, fma(w6.s8_1176, w6.s8_1363, s8_1899));
  const double s8_1901 = fnma(w6.s8_1431, w7.s8_1625, fma(w2.s8_16, w6.s8_1447, s8_1900));
  const double s8_1902 = fnma(w6.s8_1613, w7.s8_1674, fnma(w6.s8_1619, w7.s8_1649, s8_1901));
  const double s8_1903 = fnma(w2.s8_15, w7.s8_1688, s8_1902);
  const double s8_1904 = fma(p_lower_arm_left_x, s8_1861 + s8_1862, s8_1903);
  const double s8_1905 = fma(0.5, w5.s8_820 + (w4.s8_646 - w4.s8_685), s8_1904);
  const double s8_1906 = fma(p_lower_arm_left_y, w5.s8_926 - w5.s8_789, s8_1905);
  const double s8_1907 = fnma(p_arb_front_right_y, w5.s8_807 - w4.s8_669, s8_1906);
  const double s8_1908 = fnma(p_arb_front_right_x, w4.s8_666 + w5.s8_806, s8_1907);
  const double s8_1909 = fnma(p_arb_rear_right_y, w2.s8_33 - w2.s8_55, s8_1908);
  const double s8_1910 = fnma(p_arb_rear_right_x, s8_1863, s8_1909);
  const double s8_1911 = fma(w2.s8_14, w7.s8_1700 - w7.s8_1703, s8_1910);
  const double s8_1912 = w5.s8_821 + (w5.s8_792 + (w4.s8_687 + w4.f_carrier_right_z));
  const double s1_9 = w8.cosines[2];
  const double s8_1913 = fma(tau_chassis_rz, w1.s1_48, s1_9*tau_chassis_ry);
  const double s8_1914 = fma(tau_chassis_rx, w1.s1_50, s8_1913);
  const double s8_1915 = fnma(0.4225, projection.zdd_star[21], s8_1914);
  const double s8_1916 = fnma(0.4225, projection.zdd_star[20], s8_1915);
  const double s8_1917 = fnma(w1.r_rear_axle_aux3_z, w2.f_rear_axle_x, s8_1916);
  const double s8_1918 = fma(w1.r_rear_axle_aux1_x, w2.f_rear_axle_z, s8_1917) - w2.n_rear_axle_y;
  const double s8_1919 = fma(w2.s8_150, w2.s8_179, fnma(w2.s8_145, w2.s8_174, s8_1918));
  const double s8_1920 = fma(w2.s8_192, w2.s8_221, fnma(w2.s8_188, w2.s8_216, s8_1919));
  const double s8_1921 = fnma(w2.s8_239, w2.s8_275, fnma(w2.s8_245, w2.s8_268, s8_1920));
  const double s8_1922 = fnma(w2.s8_284, w3.s8_316, fma(w3.s8_286, w3.s8_311, s8_1921));
  const double s8_1923 = fnma(w3.s8_318, w3.s8_352, fma(w3.s8_322, w3.s8_347, s8_1922));
  const double s8_1924 = fnma(w3.s8_365, w3.s8_467, fnma(w3.s8_379, w3.s8_461, s8_1923));
  const double s8_1925 = fnma(w3.s8_497, w3.s8_565, fnma(w3.s8_545, w3.s8_560, s8_1924));
  const double s8_1926 = fma(w4.s7_217, w4.s8_622, fma(w4.s7_218, w4.s8_621, s8_1925));
  const double s8_1927 = fnma(p_bell_crank_z, w4.s8_626, fma(p_bell_crank_x, w4.s8_625, s8_1926));
  const double s8_1928 = fnma(p_pitman_arm_z, w4.s8_646, fma(p_pitman_arm_x, w4.s8_645, s8_1927));
  const double s8_1929 = fnma(0.3504, projection.zdd_star[12], s8_1928);
  const double s8_1930 = fnma(0.3477, projection.zdd_star[11], s8_1929);
  const double s8_1931 = fnma(w4.s7_186, w4.s8_684, fnma(w4.s7_188, w4.s8_683, s8_1930));
  const double s8_1932 = fma(w1.s1_33, w4.f_carrier_right_x, s8_1931) - w5.n_carrier_right_y;
  const double s8_1933 = fnma(w3.s7_136, w5.s8_788, fnma(w3.s7_138, w5.s8_787, s8_1932));
  const double s8_1934 = fnma(0.3477, projection.zdd_star[5], s8_1933);
  const double s8_1935 = fnma(w3.s7_112, w5.s8_819, fnma(w3.s7_110, w5.s8_817, s8_1934));
  const double s8_1936 = fnma(w1.r_carrier_left_aux1_z, w5.f_carrier_left_x, s8_1935);
  const double s8_1937 = fnma(w3.s7_61, w5.s8_923, s8_1936 - w5.n_carrier_left_y);
  const double s8_1938 = fma(w5.s8_949, w6.s8_976, fnma(w3.s7_63, w5.s8_925, s8_1937));
  const double s8_1939 = fma(w6.s8_1011, w6.s8_1040, fnma(w5.s8_950, w6.s8_989, s8_1938));
  const double s8_1940 = fma(w6.s8_1064, w6.s8_1086, fnma(w6.s8_1012, w6.s8_1047, s8_1939));
  const double s8_1941 = fma(w6.s8_1125, w6.s8_1142, fnma(w6.s8_1065, w6.s8_1091, s8_1940));
  const double s8_1942 = fnma(w6.s8_1176, w6.s8_1350, fnma(w6.s8_1105, w6.s8_1148, s8_1941));
  const double s8_1943 = fma(w2.s8_15, w6.s8_1438, fnma(w6.s8_1163, w6.s8_1356, s8_1942));
  const double s8_1944 = fnma(w6.s8_1431, w7.s8_1623, fnma(w2.s8_14, w6.s8_1447, s8_1943));
  const double s8_1945 = fnma(w6.s8_1533, w7.s8_1674, fnma(w6.s8_1617, w7.s8_1649, s8_1944));
  const double s8_1946 = fma(w7.s8_1751, s8_1911, fnma(w2.s8_42, w7.s8_1688, s8_1945));
  const double s8_1947 = w5.s8_927 + (w5.f_carrier_left_z + s8_1912);
  const double s8_1948 = fma(p_lower_arm_left_x, s8_1947, s8_1946);
  const double s8_1949 = fma(0.5, w4.s8_669 + w5.s8_807, s8_1948);
  const double s8_1950 = fnma(p_carrier_left_rz_y, w2.s8_33 + w2.s8_55, s8_1949);
  const double s8_1951 = fnma(p_lower_arm_left_z, w5.s8_789 + w5.s8_926, s8_1950);
  const double s8_1952 = fnma(p_upper_arm_right_z, w4.s8_685 + w5.s8_820, s8_1951);
  const double s8_1953 = fnma(p_arb_front_right_x, w4.s8_670 + w5.s8_809, s8_1952);
  const double s8_1954 = fma(p_arb_rear_right_x, w2.s8_38 + w2.s8_54, s8_1953);
  const double s8_1955 = fma(w2.s8_16, w7.s8_1703 - w7.s8_1697, s8_1954);
  result.inertia[3] = fnma(1e-12, s8_1803, pivot_chassis_rz);
  result.inertia[2] = fnma(1e-12, s8_1825, pivot_chassis_tz);
  result.inertia[1] = fnma(1e-12, s8_1854, pivot_chassis_ty);
  const double s8_1956 = fma(projection.zdd_star[20], w2.s7_35, tau_chassis_rx);
  const double s8_1957 = fnma(projection.zdd_star[21], w2.s7_47, s8_1956);
  const double s8_1958 = fma(w2.s7_52, w2.s8_30, fma(w2.s7_44, w2.s8_28, s8_1957));
  const double s8_1959 = fnma(w2.s7_37, w2.s8_47, fma(w2.s7_50, w2.s8_34, s8_1958));
  const double s8_1960 = fma(w2.s7_41, w2.s8_51, fma(w2.s7_43, w2.s8_50, s8_1959));
  const double s8_1961 = fma(w1.r_rear_axle_aux3_z, w2.f_rear_axle_y, s8_1960);
  const double s8_1962 = fnma(z_rear_axle_ty, w2.f_rear_axle_z, s8_1961) - w2.n_rear_axle_x;
  const double s8_1963 = fma(w2.s8_145, w2.s8_184, fma(w2.s8_166, w2.s8_179, s8_1962));
  const double s8_1964 = fma(w2.s8_188, w2.s8_226, fma(w2.s8_207, w2.s8_221, s8_1963));
  const double s8_1965 = fma(w2.s8_239, w2.s8_280, fma(w2.s8_247, w2.s8_268, s8_1964));
  const double s8_1966 = fnma(w2.s8_282, w3.s8_311, fma(w2.s8_284, w3.s8_306, s8_1965));
  const double s8_1967 = fnma(w3.s8_320, w3.s8_347, fma(w3.s8_318, w3.s8_342, s8_1966));
  const double s8_1968 = fnma(w3.s8_357, w3.s8_461, fma(w3.s8_365, w3.s8_455, s8_1967));
  const double s8_1969 = fnma(w3.s8_497, w3.s8_563, fnma(w3.s8_521, w3.s8_560, s8_1968));
  const double s8_1970 = fma(projection.zdd_star[5], w3.s7_118, s8_1969);
  const double s8_1971 = fma(projection.zdd_star[11], w4.s7_194, s8_1970);
  const double s8_1972 = fnma(w4.s7_219, w4.s8_622, fnma(w4.s7_217, w4.s8_621, s8_1971));
  const double s8_1973 = fma(w4.s7_208, w4.s8_638, fnma(p_bell_crank_z, w4.s8_627, s8_1972));
  const double s8_1974 = fnma(w4.s7_196, w4.s8_659, fma(w4.s7_210, w4.s8_639, s8_1973));
  const double s8_1975 = fma(w4.s7_201, w4.s8_665, fma(w4.s7_203, w4.s8_661, s8_1974));
  const double s8_1976 = fnma(0.539, projection.zdd_star[10], s8_1975);
  const double s8_1977 = fnma(w1.s1_33, w4.f_carrier_right_y, s8_1976);
  const double s8_1978 = fnma(w1.r_carrier_right_aux1_y, w4.f_carrier_right_z, s8_1977);
  const double s8_1979 = fnma(1.825625, projection.zdd_star[6], s8_1978 - w4.n_carrier_right_x);
  const double s8_1980 = fma(w3.s7_127, w5.s8_804, fma(w3.s7_114, w5.s8_802, s8_1979));
  const double s8_1981 = fnma(0.539, projection.zdd_star[4], fma(w3.s7_125, w5.s8_805, s8_1980));
  const double s8_1982 = fma(w1.r_carrier_left_aux1_z, w5.f_carrier_left_y, s8_1981);
  const double s8_1983 = fnma(w1.r_carrier_left_aux1_y, w5.f_carrier_left_z, s8_1982);
  const double s8_1984 = fnma(1.825625, projection.zdd_star[0], s8_1983 - w5.n_carrier_left_x);
  const double s8_1985 = fma(w5.s8_954, w6.s8_989, fnma(w5.s8_949, w6.s8_982, s8_1984));
  const double s8_1986 = fnma(w6.s8_999, w6.s8_1047, fnma(w6.s8_1011, w6.s8_1034, s8_1985));
  const double s8_1987 = fnma(w6.s8_1064, w6.s8_1095, fma(w6.s8_1062, w6.s8_1091, s8_1986));
  const double s8_1988 = fma(w6.s8_1105, w6.s8_1155, fma(w6.s8_1126, w6.s8_1142, s8_1987));
  const double s8_1989 = fma(w6.s8_1163, w6.s8_1363, fnma(w6.s8_1167, w6.s8_1350, s8_1988));
  const double s8_1990 = fnma(w2.s8_41, w6.s8_1447, fnma(w2.s8_16, w6.s8_1438, s8_1989));
  const double s8_1991 = fnma(w6.s8_1618, w7.s8_1649, fnma(w6.s8_1431, w7.s8_1624, s8_1990));
  const double s8_1992 = fma(w2.s8_14, w7.s8_1688, fnma(w6.s8_1581, w7.s8_1674, s8_1991));
  const double s8_1993 = fnma(p_upper_arm_right_z, s8_1861, s8_1992);
  const double s8_1994 = fma(s8_1796, s8_1911, fnma(p_carrier_left_rz_y, s8_1863, s8_1993));
  const double s8_1995 = w4.s8_687 - w4.s8_645 - w4.s8_666 - w5.s8_806 - w5.s8_821;
  const double s8_1996 = fma(0.5, s8_1995, fma(s8_1795, s8_1955, s8_1994));
  const double s8_1997 = fma(p_lower_arm_left_y, w4.s8_643 + w5.s8_792 - w5.s8_927, s8_1996);
  const double s8_1998 = fnma(p_lower_arm_left_z, w5.s8_929 - w5.s8_791, s8_1997);
  const double s8_1999 = fnma(p_arb_front_right_y, w5.s8_809 - w4.s8_670, s8_1998);
  const double s8_2000 = fnma(p_arb_rear_right_y, w2.s8_38 - w2.s8_54, s8_1999);
  const double s8_2001 = fma(w2.s8_15, w7.s8_1697 - w7.s8_1700, s8_2000);
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  const double s8_2002 = fma(w1.R_chassis_y_z, tau_chassis_ty, w1.R_chassis_x_z*tau_chassis_tx);
  const double s8_2003 = fma(w1.R_chassis_z_z, tau_chassis_tz, s8_2002) - w2.s8_38 - w2.s8_54;
  const double s8_2004 = fnma(w3.s8_509, w3.s8_560, s8_2003 - w2.f_rear_axle_z);
  const double s8_2005 = fnma(w3.s8_497, w3.s8_562, s8_2004) - w4.s8_625 - w4.s8_645;
  const double s8_2006 = w4.s8_670 + s8_2005 - w4.s8_687 - w4.f_carrier_right_z - w5.s8_792;
  const double s8_2007 = w5.s8_809 + s8_2006 - w5.s8_821 - w5.f_carrier_left_z;
  const double s8_2008 = fnma(w2.s8_15, w5.s8_910, s8_2007) - w5.s8_927;
  const double s8_2009 = fnma(w6.s8_1615, w7.s8_1649, fnma(w6.s8_1431, w7.s8_1621, s8_2008));
  const double s8_2010 = fma(w2.s8_19, w7.s8_1690, fnma(w6.s8_1491, w7.s8_1674, s8_2009));
  const double s8_2011 = fma(s8_1813, s8_1911, fnma(w2.s8_16, w7.s8_1692, s8_2010));
  const double s8_2012 = fnma(s8_1818, s8_2001, fma(s8_1812, s8_1955, s8_2011));
  const double s8_2013 = fma(w1.R_chassis_y_y, tau_chassis_ty, w1.R_chassis_x_y*tau_chassis_tx);
  const double s8_2014 = fma(w1.R_chassis_z_y, tau_chassis_tz, s8_2013) - w2.s8_35 - w2.s8_52;
  const double s8_2015 = fnma(w3.s8_497, w3.s8_546, s8_2014 - w2.f_rear_axle_y);
  const double s8_2016 = w4.s8_643 + (w4.s8_627 + fnma(w3.s8_503, w3.s8_560, s8_2015));
  const double s8_2017 = s8_2016 - w4.s8_666 - w4.s8_686 - w4.f_carrier_right_y - w5.s8_791;
  const double s8_2018 = w5.s8_823 + (s8_2017 - w5.s8_806) - w5.f_carrier_left_y;
  const double s8_2019 = w5.s8_929 + fma(w2.s8_21, w5.s8_910, s8_2018);
  const double s8_2020 = fnma(w6.s8_1616, w7.s8_1649, fnma(w6.s8_1431, w7.s8_1622, s8_2019));
  const double s8_2021 = fnma(w2.s8_15, w7.s8_1690, fnma(w6.s8_1499, w7.s8_1674, s8_2020));
  const double s8_2022 = fnma(s8_1832, s8_1911, fnma(w2.s8_14, w7.s8_1692, s8_2021));
  const double s8_2023 = fnma(s8_1841, s8_2001, fnma(s8_1836, s8_1955, s8_2022));
  const double s8_2024 = fnma(s8_1846, s8_2012, s8_2023);
  const double s8_2025 = w1.R_chassis_x_x*tau_chassis_tx;
  const double s8_2026 = fma(w1.R_chassis_aux5_y_x, tau_chassis_ty, s8_2025);
  const double s8_2027 = w2.s8_55 + (w2.s8_33 + fma(w1.R_chassis_z_x, tau_chassis_tz, s8_2026));
  const double s8_2028 = fnma(w3.s8_506, w3.s8_560, s8_2027 - w2.f_rear_axle_x);
  const double s8_2029 = fnma(w3.s8_497, w3.s8_561, s8_2028) - w4.s8_626 - w4.s8_646 - w4.s8_669;
  const double s8_2030 = s8_2029 - w4.s8_685 - w4.f_carrier_right_x - w5.s8_789 - w5.s8_807;
  const double s8_2031 = fnma(w2.s8_14, w5.s8_910, s8_2030 - w5.s8_820 - w5.f_carrier_left_x);
  const double s8_2032 = fnma(w6.s8_1431, w7.s8_1620, s8_2031 - w5.s8_926);
  const double s8_2033 = fnma(w6.s8_1481, w7.s8_1674, fnma(w6.s8_1614, w7.s8_1649, s8_2032));
  const double s8_2034 = fma(w2.s8_20, w7.s8_1692, fnma(w2.s8_16, w7.s8_1690, s8_2033));
  const double s8_2035 = fnma(w7.s8_1767, s8_1955, fma(w7.s8_1732, s8_1911, s8_2034));
  const double s8_2036 = fnma(s8_1828, s8_2012, fnma(s8_1805, s8_2001, s8_2035));
  const double s8_2037 = fnma(s8_1857, s8_2024, s8_2036);
  result.inertia[0] = fnma(1e-12, w7.s8_1706, pivot_chassis_tx);
  const double s8_2038 = 1.0/pivot_chassis_tx;
  // operations: 688 add, 551 multiply, 6 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double a_chassis_x = s8_2037*s8_2038;
  const double a_chassis_y = s8_1856*fnma(s8_1851, a_chassis_x, s8_2024);
  const double a_chassis_z = s8_1827*fnma(s8_1845, a_chassis_y, fnma(s8_1822, a_chassis_x,
      s8_2012));
  const double s9_1 = fnma(s8_1840, a_chassis_y, fnma(s8_1800, a_chassis_x, s8_2001));
  const double alpha_chassis_x = s8_1804*fnma(s8_1817, a_chassis_z, s9_1);
  const double s9_2 = fnma(s8_1835, a_chassis_y, fnma(w7.s8_1754, a_chassis_x, s8_1955));
  const double s9_3 = fma(w7.s8_1794, alpha_chassis_x, fma(s8_1811, a_chassis_z, s9_2));
  const double alpha_chassis_y = w7.s8_1766*s9_3;
  const double s9_4 = fnma(s8_1831, a_chassis_y, fma(w7.s8_1712, a_chassis_x, s8_1911));
  const double s9_5 = fma(w7.s8_1780, alpha_chassis_x, fma(w7.s8_1677, a_chassis_z, s9_4));
  const double alpha_chassis_z = w7.s8_1731*fma(w7.s8_1750, alpha_chassis_y, s9_5);
  const double s9_6 = fma(g_z, w1.R_chassis_z_x, a_chassis_x);
  const double s9_7 = fma(g_z, w1.R_chassis_z_y, a_chassis_y);
  const double s9_8 = fma(g_z, w1.R_chassis_z_z, a_chassis_z);
  const double s9_9 = fma(w1.R_chassis_y_y, s9_7, w1.R_chassis_aux5_y_x*s9_6);
  result.zdd[Coordinate::chassis_ty] = fma(w1.R_chassis_y_z, s9_8, s9_9);
  const double s9_10 = fma(w1.R_chassis_x_y, s9_7, w1.R_chassis_x_x*s9_6);
  result.zdd[Coordinate::chassis_tx] = fma(w1.R_chassis_x_z, s9_8, s9_10);
  const double s9_11 = fma(w1.R_chassis_z_y, s9_7, w1.R_chassis_z_x*s9_6);
  result.zdd[Coordinate::chassis_tz] = fma(w1.R_chassis_z_z, s9_8, s9_11);
  const double s1_2 = w8.cosines[1];
  result.inertia[4] = mbgen::min(s8_1860, fms(s1_2, s1_2, 1e-12));
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  const double s9_12 = alpha_chassis_y + fnma(zd_chassis_rx, w1.w_chassis_z, w1.s4_1*w1.s4_5);
  const double s9_13 = alpha_chassis_z + fma(zd_chassis_rx, w1.w_chassis_y, w1.s4_1*w1.s4_3);
  result.zdd[Coordinate::chassis_rz] = fma(w1.s1_49, s9_13, w1.s1_48*s9_12);
  result.zdd[Coordinate::chassis_ry] = fnma(s1_6, s9_13, s1_9*s9_12);
  const double s9_14 = alpha_chassis_x + fma(w1.s4_2, w1.s4_5, w1.s4_3*w1.s4_4);
  result.zdd[Coordinate::chassis_rx] = fma(w1.s1_51, s9_13, fma(w1.s1_50, s9_12, s9_14));
  const double s9_15 = fnma(w6.s8_1498, a_chassis_y, fnma(w6.s8_1479, a_chassis_x, w7.s8_1674));
  const double s9_16 = fnma(w6.s8_1580, alpha_chassis_x, fnma(w6.s8_1490, a_chassis_z, s9_15));
  const double s9_17 = fnma(w6.s8_1532, alpha_chassis_y, s9_16);
  // bell_crank: bell_crank, revolute, chassis
  const double s9_18 = w6.s8_1480*fnma(w6.s8_1612, alpha_chassis_z, s9_17);
  const double s9_19 = fnma(w6.s8_1494, a_chassis_y, fnma(w6.s8_1476, a_chassis_x, w7.s8_1649));
  const double s9_20 = fnma(w6.s8_1556, alpha_chassis_x, fnma(w6.s8_1485, a_chassis_z, s9_19));
  const double s9_21 = fnma(w6.s8_1515, alpha_chassis_y, s9_20);
  const double s9_22 = fnma(w6.s8_1470, s9_18, fnma(w6.s8_1596, alpha_chassis_z, s9_21));
  const double s9_23 = w6.s8_1471*s9_22;
  const double s9_24 = fnma(w5.s8_917, a_chassis_y, fnma(w5.s8_874, a_chassis_x, w6.s8_1431));
  const double s9_25 = fnma(w6.s8_1246, alpha_chassis_x, fnma(w5.s8_914, a_chassis_z, s9_24));
  const double s9_26 = fnma(w6.s8_1201, alpha_chassis_y, s9_25);
  const double s9_27 = fnma(w6.s8_1285, s9_18, fnma(w6.s8_1224, alpha_chassis_z, s9_26));
  const double s9_28 = w6.s8_1448*fnma(w6.s8_1323, s9_23, s9_27);
  const double s9_29 = fma(projection.Rz[0], s9_18, projection.zdd_star[0]);
  const double s9_30 = fma(projection.Rz[2], s9_28, fma(projection.Rz[1], s9_23, s9_29));
  result.zdd[Coordinate::lower_arm_left] = s9_30;
  const double s9_31 = fma(projection.Rz[12], s9_18, projection.zdd_star[4]);
  result.zdd[Coordinate::upper_arm_left] = fma(projection.Rz[14], s9_28, fma(projection.Rz[13],
      s9_23, s9_31));
  const double s9_32 = fma(projection.Rz[15], s9_18, projection.zdd_star[5]);
  result.zdd[Coordinate::arb_front_left] = fma(projection.Rz[17], s9_28, fma(projection.Rz[16],
      s9_23, s9_32));
  const double s9_33 = fma(projection.Rz[18], s9_18, projection.zdd_star[6]);
  const double s9_34 = fma(projection.Rz[20], s9_28, fma(projection.Rz[19], s9_23, s9_33));
  result.zdd[Coordinate::lower_arm_right] = s9_34;
  const double s9_35 = fma(projection.Rz[30], s9_18, projection.zdd_star[10]);
  result.zdd[Coordinate::upper_arm_right] = fma(projection.Rz[32], s9_28, fma(projection.Rz[31],
      s9_23, s9_35));
  const double s9_36 = fma(projection.Rz[33], s9_18, projection.zdd_star[11]);
  result.zdd[Coordinate::arb_front_right] = fma(projection.Rz[35], s9_28, fma(projection.Rz[34],
      s9_23, s9_36));
  const double s9_37 = fma(projection.Rz[36], s9_18, projection.zdd_star[12]);
  result.zdd[Coordinate::pitman_arm] = fma(projection.Rz[38], s9_28, fma(projection.Rz[37], s9_23,
      s9_37));
  const double s9_38 = fma(projection.Rz[39], s9_18, projection.zdd_star[13]);
  result.zdd[Coordinate::bell_crank] = fma(projection.Rz[41], s9_28, fma(projection.Rz[40], s9_23,
      s9_38));
  const double s9_39 = fma(projection.Rz[9], s9_18, projection.zdd_star[3]);
  const double s9_40 = fma(projection.Rz[11], s9_28, fma(projection.Rz[10], s9_23, s9_39));
  result.zdd[Coordinate::carrier_left_ry] = s9_40;
  const double s9_41 = fma(projection.Rz[27], s9_18, projection.zdd_star[9]);
  const double s9_42 = fma(projection.Rz[29], s9_28, fma(projection.Rz[28], s9_23, s9_41));
  result.zdd[Coordinate::carrier_right_ry] = s9_42;
  const double s9_43 = fma(projection.Rz[6], s9_18, projection.zdd_star[2]);
  const double s9_44 = fma(projection.Rz[8], s9_28, fma(projection.Rz[7], s9_23, s9_43));
  result.zdd[Coordinate::carrier_left_rx] = s9_44;
  const double s9_45 = fma(projection.Rz[24], s9_18, projection.zdd_star[8]);
  const double s9_46 = fma(projection.Rz[26], s9_28, fma(projection.Rz[25], s9_23, s9_45));
  result.zdd[Coordinate::carrier_right_rx] = s9_46;
  const double s9_47 = fma(projection.Rz[3], s9_18, projection.zdd_star[1]);
  const double s9_48 = fma(projection.Rz[5], s9_28, fma(projection.Rz[4], s9_23, s9_47));
  result.zdd[Coordinate::carrier_left_rz] = s9_48;
  const double s9_49 = fma(projection.Rz[21], s9_18, projection.zdd_star[7]);
  const double s9_50 = fma(projection.Rz[23], s9_28, fma(projection.Rz[22], s9_23, s9_49));
  result.zdd[Coordinate::carrier_right_rz] = s9_50;
  const double s9_51 = s9_30 + (alpha_chassis_x + (w5.s8_843 + (w3.s6_23 + w3.s6_24)));
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double alpha_carrier_left_x = fma(w8.cosines[4], s9_44, fnma(w1.s1_22, s9_40, s9_51));
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s9_52 = w5.s8_833 + (fnma(zd_lower_arm_left, w1.s4_7, w3.s6_39) - w3.s6_21);
  const double s9_53 = fma(w1.R_carrier_left_aux2_y_y, s9_40, alpha_chassis_y + s9_52);
  const double s9_54 = fma(w1.R_carrier_left_aux1_y_x, s9_44, s9_53);
  const double alpha_carrier_left_y = fma(w1.R_carrier_left_aux1_y_z, s9_48, s9_54);
  const double s9_55 = w5.s8_830 + fma(zd_lower_arm_left, w1.s4_6, w3.s6_27 + w3.s6_28);
  const double s9_56 = fma(w1.R_carrier_left_aux2_z_y, s9_40, alpha_chassis_z + s9_55);
  const double s9_57 = fma(w1.R_carrier_left_aux1_z_x, s9_44, s9_56);
  const double alpha_carrier_left_z = fma(w1.R_carrier_left_aux1_z_z, s9_48, s9_57);
  const double s9_58 = s9_34 + (alpha_chassis_x + (w4.s8_712 + (w3.s6_25 + w3.s6_26)));
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double alpha_carrier_right_x = fma(w8.cosines[10], s9_46, fnma(w1.s1_35, s9_42, s9_58));
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s9_59 = w4.s8_701 + (fnma(zd_lower_arm_right, w1.s4_15, w3.s6_44) - w3.s6_22);
  const double s9_60 = fma(w1.R_carrier_right_aux2_y_y, s9_42, alpha_chassis_y + s9_59);
  const double s9_61 = fma(w1.R_carrier_right_aux1_y_x, s9_46, s9_60);
  const double alpha_carrier_right_y = fma(w1.R_carrier_right_aux1_y_z, s9_50, s9_61);
  const double s9_62 = w4.s8_698 + fma(zd_lower_arm_right, w1.s4_14, w3.s6_33 + w3.s6_34);
  const double s9_63 = fma(w1.R_carrier_right_aux2_z_y, s9_42, alpha_chassis_z + s9_62);
  const double s9_64 = fma(w1.R_carrier_right_aux1_z_x, s9_46, s9_63);
  const double alpha_carrier_right_z = fma(w1.R_carrier_right_aux1_z_z, s9_50, s9_64);
  const double s9_65 = 0.09090909090909091*tau[Coordinate::wheel_front_left];
  const double s9_66 = fma(w1.s1_22, alpha_carrier_left_x, s9_65);
  const double s9_67 = fnma(w1.R_carrier_left_aux2_y_y, alpha_carrier_left_y, s9_66);
  result.zdd[Coordinate::wheel_front_left] = fnma(w1.R_carrier_left_aux2_z_y, alpha_carrier_left_z,
      s9_67);
  const double s9_68 = 0.09090909090909091*tau[Coordinate::wheel_front_right];
  const double s9_69 = fma(w1.s1_35, alpha_carrier_right_x, s9_68);
  const double s9_70 = fnma(w1.R_carrier_right_aux2_y_y, alpha_carrier_right_y, s9_69);
  result.zdd[Coordinate::wheel_front_right] = fnma(w1.R_carrier_right_aux2_z_y,
      alpha_carrier_right_z, s9_70);
  const double s9_71 = fnma(w3.s8_501, a_chassis_y, fnma(w3.s8_505, a_chassis_x, w3.s8_560));
  const double s9_72 = fnma(w3.s8_520, alpha_chassis_x, fnma(w3.s8_508, a_chassis_z, s9_71));
  const double s9_73 = fnma(w3.s8_544, alpha_chassis_y, s9_72);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s9_74 = w3.s8_502*fnma(w3.s8_531, alpha_chassis_z, s9_73);
  const double s9_75 = fnma(w2.s8_125, a_chassis_y, fnma(w2.s8_107, a_chassis_x, w3.s8_497));
  const double s9_76 = fnma(w3.s8_391, alpha_chassis_x, fnma(w2.s8_112, a_chassis_z, s9_75));
  const double s9_77 = fnma(w3.s8_414, alpha_chassis_y, s9_76);
  const double s9_78 = fnma(w3.s8_438, s9_74, fnma(w3.s8_402, alpha_chassis_z, s9_77));
  const double s9_79 = w3.s8_498*s9_78;
  const double s9_80 = fma(projection.Rz[42], s9_74, projection.zdd_star[14]);
  result.zdd[Coordinate::rear_axle_tx] = fma(projection.Rz[43], s9_79, s9_80);
  const double s9_81 = fma(projection.Rz[44], s9_74, projection.zdd_star[15]);
  result.zdd[Coordinate::rear_axle_ty] = fma(projection.Rz[45], s9_79, s9_81);
  const double s9_82 = fma(projection.Rz[46], s9_74, projection.zdd_star[16]);
  result.zdd[Coordinate::rear_axle_tz] = fma(projection.Rz[47], s9_79, s9_82);
  const double s9_83 = fma(projection.Rz[54], s9_74, projection.zdd_star[20]);
  result.zdd[Coordinate::arb_rear_left] = fma(projection.Rz[55], s9_79, s9_83);
  const double s9_84 = fma(projection.Rz[56], s9_74, projection.zdd_star[21]);
  result.zdd[Coordinate::arb_rear_right] = fma(projection.Rz[57], s9_79, s9_84);
  const double s9_85 = fma(projection.Rz[50], s9_74, projection.zdd_star[18]);
  const double s9_86 = fma(projection.Rz[51], s9_79, s9_85);
  result.zdd[Coordinate::rear_axle_ry] = s9_86;
  const double s9_87 = fma(projection.Rz[52], s9_74, projection.zdd_star[19]);
  const double s9_88 = fma(projection.Rz[53], s9_79, s9_87);
  result.zdd[Coordinate::rear_axle_rx] = s9_88;
  const double s9_89 = fma(projection.Rz[48], s9_74, projection.zdd_star[17]);
  const double s9_90 = fma(projection.Rz[49], s9_79, s9_89);
  result.zdd[Coordinate::rear_axle_rz] = s9_90;
  const double s9_91 = alpha_chassis_x + (w2.s8_76 + fnma(w1.s4_23, w1.s4_25, w2.s6_1));
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s9_92 = fma(w1.R_rear_axle_aux5_x_x, s9_88, fnma(w1.s1_40, s9_86, s9_91));
  const double alpha_rear_axle_x = fma(w1.R_rear_axle_aux4_x_z, s9_90, s9_92);
  const double s9_93 = alpha_chassis_y + (w2.s8_64 + (w2.s6_11 + w2.s6_12));
  const double alpha_rear_axle_y = fma(w1.R_rear_axle_aux5_y_x, s9_88, fma(w8.cosines[17], s9_86,
      s9_93));
  const double s9_94 = alpha_chassis_z + (w2.s8_61 + fma(w1.s4_22, w1.s4_25, w2.s6_6));
  const double s9_95 = fma(w1.R_rear_axle_aux5_z_x, s9_88, fnma(w1.s1_42, s9_86, s9_94));
  const double alpha_rear_axle_z = fma(w1.R_rear_axle_aux4_z_z, s9_90, s9_95);
  const double s9_96 = w1.R_rear_axle_x_y*alpha_rear_axle_x;
  const double s9_97 = fma(w1.R_rear_axle_y_y, alpha_rear_axle_y, s9_96);
  const double s9_98 = fma(w1.R_rear_axle_z_y, alpha_rear_axle_z, s9_97);
  result.zdd[Coordinate::wheel_rear_left] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_left], s9_98);
  result.zdd[Coordinate::wheel_rear_right] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_right], s9_98);
  // operations: 194 add, 186 multiply, 1 other
}

/// All accelerations with a partition chosen at run time.
void compute_chosen_accelerations(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, const double* tau, const Projection& projection,
    ChosenAccelerations& __restrict result) noexcept {
  ChosenAccelerationsWork1 w1;
  ChosenAccelerationsWork2 w2;
  ChosenAccelerationsWork3 w3;
  ChosenAccelerationsWork4 w4;
  ChosenAccelerationsWork5 w5;
  ChosenAccelerationsWork6 w6;
  ChosenAccelerationsWork7 w7;
  ChosenAccelerationsWork8 w8;
  compute_chosen_accelerations_1(state, tau, projection, w1, w2, w8, result);
  compute_chosen_accelerations_2(state, tau, projection, w1, w2, w3, w8, result);
  compute_chosen_accelerations_3(state, tau, projection, w1, w2, w3, w4, w5, w8);
  compute_chosen_accelerations_4(state, tau, projection, w1, w2, w3, w4, w5, w6, w8);
  compute_chosen_accelerations_5(state, tau, projection, w1, w2, w3, w4, w5, w6, w7, result);
  compute_chosen_accelerations_6(state, tau, projection, w1, w2, w3, w4, w5, w6, w7, w8, result);
}
#endif  // part 1

void compute_outputs(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, const Derivative& derivative, Outputs& __restrict result) noexcept;

#if MBGEN_IS_PART(1)
/// Values of compute_outputs that cross its parts.
struct OutputsWork1 {
  double
      w_chassis_z, w_chassis_x, w_chassis_y, w_rear_axle_x, w_rear_axle_y, w_rear_axle_z,
      R_rear_axle_x_y, R_rear_axle_z_y, w_carrier_left_x, w_carrier_left_y, w_carrier_left_z,
      w_carrier_right_x, w_carrier_right_y, w_carrier_right_z, R_rear_axle_y_y, v_chassis_z,
      v_chassis_x, v_chassis_y, w_bell_crank_z, v_rear_axle_aux3_x, v_rear_axle_aux3_y,
      v_rear_axle_aux3_z, s1_22, R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, s1_41,
      R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, R_rear_axle_y_z, w_arb_front_left_y,
      w_arb_front_right_y, r_rear_axle_aux1_x, R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x,
      R_rear_axle_aux5_z_x, R_rear_axle_x_z, R_rear_axle_z_z, w_lower_arm_left_x,
      w_lower_arm_right_x, w_arb_rear_left_y, R_carrier_left_x_z, R_carrier_left_y_z,
      R_carrier_left_z_z, R_carrier_right_x_z, R_carrier_right_y_z, R_carrier_right_z_z,
      w_pitman_arm_y, R_carrier_left_x_x, R_carrier_left_y_x, R_carrier_left_z_x,
      R_carrier_right_x_x, R_carrier_right_y_x, R_carrier_right_z_x, r_rear_axle_aux3_z,
      v_lower_arm_left_y, v_carrier_left_aux1_x, v_carrier_left_aux1_y, v_carrier_left_aux1_z,
      w_upper_arm_left_x, v_arb_front_left_y, v_carrier_right_aux1_x, v_carrier_right_aux1_y,
      v_carrier_right_aux1_z, w_upper_arm_right_x, v_bell_crank_x, v_bell_crank_y, v_bell_crank_z,
      v_arb_rear_left_y, r_carrier_left_aux1_y, r_carrier_left_aux1_z, r_carrier_right_aux1_y,
      s1_39, w_wheel_front_left_x, w_wheel_front_left_y, w_wheel_front_left_z,
      w_wheel_front_right_x, w_wheel_front_right_y, w_wheel_front_right_z, w_wheel_rear_left_x,
      w_wheel_rear_left_y, w_wheel_rear_left_z, w_wheel_rear_right_x, w_wheel_rear_right_y,
      w_wheel_rear_right_z, R_chassis_z_x, R_chassis_z_y, R_chassis_z_z, s4_4, v_lower_arm_left_x,
      s4_6, v_lower_arm_left_z, v_wheel_front_left_x, v_wheel_front_left_y, v_wheel_front_left_z,
      v_upper_arm_left_y, v_arb_front_left_x, v_arb_front_left_z, s4_17, v_lower_arm_right_x, s4_18,
      v_lower_arm_right_z, v_wheel_front_right_x, v_wheel_front_right_y, v_wheel_front_right_z,
      v_arb_front_right_x, v_arb_front_right_z, v_pitman_arm_x, v_pitman_arm_y, v_pitman_arm_z,
      v_wheel_rear_left_x, v_wheel_rear_left_y, v_wheel_rear_left_z, v_arb_rear_left_x,
      v_arb_rear_left_z, v_wheel_rear_right_x, v_wheel_rear_right_y, v_wheel_rear_right_z,
      r_chassis_aux3_z, r_wheel_front_left_x, r_wheel_front_left_y, r_wheel_front_left_z,
      r_wheel_front_right_x, r_wheel_front_right_y, r_wheel_front_right_z, v_upper_arm_left_x,
      v_upper_arm_left_z, v_upper_arm_right_x, v_upper_arm_right_z;
};

/// Values of compute_outputs that cross its parts.
struct OutputsWork2 {
  double
      w_arb_rear_right_y, s7_2, s7_4, s7_6, s7_9, s7_12, s7_14, s7_16, s7_19, s7_22, s7_25, s7_26,
      s7_27, s7_28, s7_29, s7_32, s7_33, s7_36, s7_39, s7_42, s7_43, s7_44, s7_47, s7_50,
      v_arb_rear_right_x, v_arb_rear_right_z, s7_51;
};

/// Values of compute_outputs that cross its parts.
struct OutputsWork3 {
  double
      sines[22], cosines[22];
};

/// Part 1 of compute_outputs: step 1: poses and axes b; step 4: velocities; step 7: inertias of the
/// bodies and forces on joints.
[[gnu::noinline]] void compute_outputs_1(const State& state, OutputsWork1& __restrict w1,
    OutputsWork2& __restrict w2, OutputsWork3& __restrict w3) noexcept {
  // --- step 1: poses and axes b ---
  const double angles[] = {
      state.z[Coordinate::chassis_rz], state.z[Coordinate::chassis_ry],
      state.z[Coordinate::chassis_rx], state.z[Coordinate::lower_arm_left],
      state.z[Coordinate::carrier_left_rz], state.z[Coordinate::carrier_left_rx],
      state.z[Coordinate::carrier_left_ry], state.z[Coordinate::upper_arm_left],
      state.z[Coordinate::arb_front_left], state.z[Coordinate::lower_arm_right],
      state.z[Coordinate::carrier_right_rz], state.z[Coordinate::carrier_right_rx],
      state.z[Coordinate::carrier_right_ry], state.z[Coordinate::upper_arm_right],
      state.z[Coordinate::arb_front_right], state.z[Coordinate::pitman_arm],
      state.z[Coordinate::bell_crank], state.z[Coordinate::rear_axle_rz],
      state.z[Coordinate::rear_axle_ry], state.z[Coordinate::rear_axle_rx],
      state.z[Coordinate::arb_rear_left], state.z[Coordinate::arb_rear_right]};
  mbgen::sincos(angles, w3.sines, w3.cosines);
  // chassis_aux3: chassis_tz, prismatic, chassis_aux2
  w1.r_chassis_aux3_z = 1.0 + state.z[Coordinate::chassis_tz];
  const double s1_1 = state.charts[0] - 0.5;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_y_x = w3.sines[0];
  const double s1_2 = w3.cosines[1];
  const double R_chassis_aux5_y_x = R_chassis_aux4_y_x*s1_2;
  const double s1_3 = w3.sines[1];
  const double s1_4 = -s1_3;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux4_y_y = w3.cosines[0];
  const double s1_5 = R_chassis_aux4_y_y*s1_2;
  const double R_chassis_x_x = (s1_1 >= 0.0 ? s1_4 : s1_5);
  const double s1_6 = w3.sines[2];
  const double s1_7 = s1_2*s1_6;
  const double s1_8 = s1_3*s1_6;
  const double s1_9 = w3.cosines[2];
  const double s1_10 = fnma(R_chassis_aux4_y_x, s1_9, R_chassis_aux4_y_y*s1_8);
  const double R_chassis_x_y = (s1_1 >= 0.0 ? s1_7 : s1_10);
  const double s1_11 = s1_2*s1_9;
  const double s1_12 = s1_3*s1_9;
  const double s1_13 = fma(R_chassis_aux4_y_y, s1_12, R_chassis_aux4_y_x*s1_6);
  const double R_chassis_x_z = (s1_1 >= 0.0 ? s1_11 : s1_13);
  const double R_chassis_y_y = fma(R_chassis_aux4_y_y, s1_9, R_chassis_aux4_y_x*s1_8);
  const double R_chassis_y_z = fnma(R_chassis_aux4_y_y, s1_6, R_chassis_aux4_y_x*s1_12);
  w1.R_chassis_z_x = (s1_1 >= 0.0 ? -s1_5 : s1_4);
  w1.R_chassis_z_y = (s1_1 >= 0.0 ? -s1_10 : s1_7);
  w1.R_chassis_z_z = (s1_1 >= 0.0 ? -s1_13 : s1_11);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = w3.sines[3];
  const double R_lower_arm_left_y_z = -R_lower_arm_left_z_y;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_14 = state.charts[1] - 0.5;
  const double R_lower_arm_left_y_y = w3.cosines[3];
  const double R_carrier_left_aux1_z_z = (s1_14 >= 0.0 ? R_lower_arm_left_y_z :
      R_lower_arm_left_y_y);
  const double s1_15 = w3.sines[4];
  const double R_carrier_left_aux1_y_x = s1_15*R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_x_x = w3.cosines[4];
  const double R_carrier_left_aux1_y_y = R_carrier_left_aux1_x_x*R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_y_z = (s1_14 >= 0.0 ? -R_lower_arm_left_y_y :
      R_lower_arm_left_y_z);
  const double s1_16 = (s1_14 >= 0.0 ? R_lower_arm_left_y_y : R_lower_arm_left_z_y);
  const double R_carrier_left_aux1_z_x = s1_15*s1_16;
  const double R_carrier_left_aux1_z_y = R_carrier_left_aux1_x_x*s1_16;
  const double s1_17 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  const double s1_18 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_17);
  w1.r_carrier_left_aux1_y = p_lower_arm_left_y + s1_18;
  const double s1_19 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_20 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_19);
  w1.r_carrier_left_aux1_z = s1_20 + p_lower_arm_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_21 = w3.cosines[5];
  w1.s1_22 = s1_15*s1_21;
  const double s1_23 = w3.sines[5];
  const double R_carrier_left_aux2_x_z = s1_15*s1_23;
  w1.R_carrier_left_aux2_y_y = fma(R_carrier_left_aux1_y_z, s1_23, R_carrier_left_aux1_y_y*s1_21);
  const double R_carrier_left_aux2_y_z = fnma(R_carrier_left_aux1_y_y, s1_23,
      R_carrier_left_aux1_y_z*s1_21);
  w1.R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_z, s1_23, R_carrier_left_aux1_z_y*s1_21);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_23,
      R_carrier_left_aux1_z_z*s1_21);
  const double s1_24 = w3.cosines[6];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = w3.sines[6];
  w1.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_25, R_carrier_left_aux1_x_x*s1_24);
  w1.R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_25, R_carrier_left_aux2_x_z*s1_24);
  w1.R_carrier_left_y_x = fnma(R_carrier_left_aux2_y_z, s1_25, R_carrier_left_aux1_y_x*s1_24);
  w1.R_carrier_left_y_z = fma(R_carrier_left_aux1_y_x, s1_25, R_carrier_left_aux2_y_z*s1_24);
  w1.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_25, R_carrier_left_aux1_z_x*s1_24);
  w1.R_carrier_left_z_z = fma(R_carrier_left_aux1_z_x, s1_25, R_carrier_left_aux2_z_z*s1_24);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_26 = p_wheel_front_left_z*w1.R_carrier_left_x_z;
  const double s1_27 = fnma(p_wheel_front_left_y, w1.s1_22, s1_26);
  w1.r_wheel_front_left_x = p_lower_arm_left_x + s1_27;
  const double s1_28 = p_wheel_front_left_y*w1.R_carrier_left_aux2_y_y;
  const double s1_29 = fma(p_wheel_front_left_z, w1.R_carrier_left_y_z, s1_28);
  w1.r_wheel_front_left_y = w1.r_carrier_left_aux1_y + s1_29;
  const double s1_30 = p_wheel_front_left_y*w1.R_carrier_left_aux2_z_y;
  const double s1_31 = fma(p_wheel_front_left_z, w1.R_carrier_left_z_z, s1_30);
  w1.r_wheel_front_left_z = w1.r_carrier_left_aux1_z + s1_31;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = w3.sines[9];
  const double R_lower_arm_right_y_z = -R_lower_arm_right_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_32 = state.charts[2] - 0.5;
  const double R_lower_arm_right_y_y = w3.cosines[9];
  const double R_carrier_right_aux1_z_z = (s1_32 >= 0.0 ? R_lower_arm_right_y_z :
      R_lower_arm_right_y_y);
  const double s1_33 = w3.sines[10];
  const double R_carrier_right_aux1_y_x = s1_33*R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_x_x = w3.cosines[10];
  const double R_carrier_right_aux1_y_y = R_carrier_right_aux1_x_x*R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_y_z = (s1_32 >= 0.0 ? -R_lower_arm_right_y_y :
      R_lower_arm_right_y_z);
  const double s1_34 = (s1_32 >= 0.0 ? R_lower_arm_right_y_y : R_lower_arm_right_z_y);
  const double R_carrier_right_aux1_z_x = s1_33*s1_34;
  const double R_carrier_right_aux1_z_y = R_carrier_right_aux1_x_x*s1_34;
  const double s1_35 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  const double s1_36 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_35);
  w1.r_carrier_right_aux1_y = s1_36 + p_lower_arm_right_y;
  const double s1_37 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  const double s1_38 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_37);
  w1.s1_39 = s1_38 - p_lower_arm_right_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_40 = w3.cosines[11];
  w1.s1_41 = s1_33*s1_40;
  const double s1_42 = w3.sines[11];
  const double R_carrier_right_aux2_x_z = s1_33*s1_42;
  w1.R_carrier_right_aux2_y_y = fma(R_carrier_right_aux1_y_z, s1_42,
      R_carrier_right_aux1_y_y*s1_40);
  const double R_carrier_right_aux2_y_z = fnma(R_carrier_right_aux1_y_y, s1_42,
      R_carrier_right_aux1_y_z*s1_40);
  w1.R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_z, s1_42,
      R_carrier_right_aux1_z_y*s1_40);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_42,
      R_carrier_right_aux1_z_z*s1_40);
  const double s1_43 = w3.cosines[12];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_44 = w3.sines[12];
  w1.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_44, R_carrier_right_aux1_x_x*s1_43);
  w1.R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_44, R_carrier_right_aux2_x_z*s1_43);
  w1.R_carrier_right_y_x = fnma(R_carrier_right_aux2_y_z, s1_44, R_carrier_right_aux1_y_x*s1_43);
  w1.R_carrier_right_y_z = fma(R_carrier_right_aux1_y_x, s1_44, R_carrier_right_aux2_y_z*s1_43);
  w1.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_44, R_carrier_right_aux1_z_x*s1_43);
  w1.R_carrier_right_z_z = fma(R_carrier_right_aux1_z_x, s1_44, R_carrier_right_aux2_z_z*s1_43);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_45 = -p_wheel_front_right_y*w1.s1_41;
  const double s1_46 = fma(p_wheel_front_right_z, w1.R_carrier_right_x_z, s1_45);
  w1.r_wheel_front_right_x = p_lower_arm_right_x + s1_46;
  const double s1_47 = p_wheel_front_right_z*w1.R_carrier_right_y_z;
  const double s1_48 = fma(p_wheel_front_right_y, w1.R_carrier_right_aux2_y_y, s1_47);
  w1.r_wheel_front_right_y = w1.r_carrier_right_aux1_y + s1_48;
  const double s1_49 = p_wheel_front_right_z*w1.R_carrier_right_z_z;
  const double s1_50 = fma(p_wheel_front_right_y, w1.R_carrier_right_aux2_z_y, s1_49);
  w1.r_wheel_front_right_z = s1_50 - w1.s1_39;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  w1.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double z_rear_axle_tz = state.z[Coordinate::rear_axle_tz];
  w1.r_rear_axle_aux3_z = z_rear_axle_tz + p_rear_axle_tx_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s1_51 = state.charts[3] - 0.5;
  const double R_rear_axle_aux4_z_z = (s1_51 >= 0.0 ? 0.0 : 1.0);
  const double R_rear_axle_aux4_y_y = w3.cosines[17];
  const double R_rear_axle_aux4_x_x = R_rear_axle_aux4_y_y*R_rear_axle_aux4_z_z;
  const double R_rear_axle_aux4_y_x = w3.sines[17];
  const double s1_52 = R_rear_axle_aux4_z_z*R_rear_axle_aux4_y_x;
  const double R_rear_axle_aux4_x_z = (s1_51 >= 0.0 ? 1.0 : 0.0);
  const double s1_53 = (s1_51 >= 0.0 ? -1.0 : 0.0);
  const double R_rear_axle_aux4_z_x = R_rear_axle_aux4_y_y*s1_53;
  const double s1_54 = R_rear_axle_aux4_y_x*s1_53;
  const double s1_55 = w3.cosines[18];
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s1_56 = w3.sines[18];
  w1.R_rear_axle_aux5_x_x = fnma(R_rear_axle_aux4_x_z, s1_56, R_rear_axle_aux4_x_x*s1_55);
  const double R_rear_axle_aux5_x_z = fma(R_rear_axle_aux4_x_x, s1_56, R_rear_axle_aux4_x_z*s1_55);
  w1.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*s1_55;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_56;
  w1.R_rear_axle_aux5_z_x = fnma(R_rear_axle_aux4_z_z, s1_56, R_rear_axle_aux4_z_x*s1_55);
  const double R_rear_axle_aux5_z_z = fma(R_rear_axle_aux4_z_x, s1_56, R_rear_axle_aux4_z_z*s1_55);
  const double s1_57 = w3.sines[19];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_58 = w3.cosines[19];
  w1.R_rear_axle_x_y = fnma(s1_52, s1_58, R_rear_axle_aux5_x_z*s1_57);
  w1.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_58, s1_52*s1_57);
  w1.R_rear_axle_y_y = fma(R_rear_axle_aux4_y_y, s1_58, R_rear_axle_aux5_y_z*s1_57);
  w1.R_rear_axle_y_z = fnma(R_rear_axle_aux4_y_y, s1_57, R_rear_axle_aux5_y_z*s1_58);
  w1.R_rear_axle_z_y = fnma(s1_54, s1_58, R_rear_axle_aux5_z_z*s1_57);
  w1.R_rear_axle_z_z = fma(R_rear_axle_aux5_z_z, s1_58, s1_54*s1_57);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_59 = p_wheel_rear_left_y*w1.R_rear_axle_x_y;
  const double s1_60 = p_wheel_rear_left_y*w1.R_rear_axle_y_y;
  const double s1_61 = p_wheel_rear_left_y*w1.R_rear_axle_z_y;
  // operations: 61 add, 115 multiply, 44 sin cos, 15 other

  // --- step 4: velocities ---
  const double zd_chassis_ty = state.zd[Coordinate::chassis_ty];
  const double zd_chassis_tx = state.zd[Coordinate::chassis_tx];
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_tz = state.zd[Coordinate::chassis_tz];
  const double s4_1 = fma(zd_chassis_tx, R_chassis_x_x, zd_chassis_ty*R_chassis_aux5_y_x);
  w1.v_chassis_x = fma(zd_chassis_tz, w1.R_chassis_z_x, s4_1);
  const double s4_2 = fma(zd_chassis_ty, R_chassis_y_y, zd_chassis_tx*R_chassis_x_y);
  w1.v_chassis_y = fma(zd_chassis_tz, w1.R_chassis_z_y, s4_2);
  const double s4_3 = fma(zd_chassis_ty, R_chassis_y_z, zd_chassis_tx*R_chassis_x_z);
  w1.v_chassis_z = fma(zd_chassis_tz, w1.R_chassis_z_z, s4_3);
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  w1.w_chassis_x = fnma(zd_chassis_rz, s1_3, state.zd[Coordinate::chassis_rx]);
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  w1.w_chassis_y = fma(zd_chassis_ry, s1_9, zd_chassis_rz*s1_7);
  w1.w_chassis_z = fnma(zd_chassis_ry, s1_6, zd_chassis_rz*s1_11);
  // lower_arm_left: lower_arm_left, revolute, chassis
  w1.s4_4 = fnma(p_lower_arm_left_y, w1.w_chassis_z, w1.v_chassis_x);
  w1.v_lower_arm_left_x = fma(p_lower_arm_left_z, w1.w_chassis_y, w1.s4_4);
  const double s4_5 = fnma(p_lower_arm_left_z, w1.w_chassis_x, w1.v_chassis_y);
  w1.v_lower_arm_left_y = fma(p_lower_arm_left_x, w1.w_chassis_z, s4_5);
  w1.s4_6 = fma(p_lower_arm_left_y, w1.w_chassis_x, w1.v_chassis_z);
  w1.v_lower_arm_left_z = fnma(p_lower_arm_left_x, w1.w_chassis_y, w1.s4_6);
  w1.w_lower_arm_left_x = state.zd[Coordinate::lower_arm_left] + w1.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s4_7 = fnma(s1_18, w1.w_chassis_z, s1_20*w1.w_chassis_y);
  w1.v_carrier_left_aux1_x = w1.v_lower_arm_left_x + s4_7;
  w1.v_carrier_left_aux1_y = fnma(s1_20, w1.w_lower_arm_left_x, w1.v_lower_arm_left_y);
  w1.v_carrier_left_aux1_z = fma(s1_18, w1.w_lower_arm_left_x, w1.v_lower_arm_left_z);
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double w_carrier_left_aux1_y = fma(zd_carrier_left_rz, R_carrier_left_aux1_y_z,
      w1.w_chassis_y);
  const double w_carrier_left_aux1_z = fma(zd_carrier_left_rz, R_carrier_left_aux1_z_z,
      w1.w_chassis_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double w_carrier_left_aux2_x = fma(zd_carrier_left_rx, R_carrier_left_aux1_x_x,
      w1.w_lower_arm_left_x);
  const double w_carrier_left_aux2_y = fma(zd_carrier_left_rx, R_carrier_left_aux1_y_x,
      w_carrier_left_aux1_y);
  const double w_carrier_left_aux2_z = fma(zd_carrier_left_rx, R_carrier_left_aux1_z_x,
      w_carrier_left_aux1_z);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  w1.w_carrier_left_x = fnma(zd_carrier_left_ry, w1.s1_22, w_carrier_left_aux2_x);
  w1.w_carrier_left_y = fma(zd_carrier_left_ry, w1.R_carrier_left_aux2_y_y, w_carrier_left_aux2_y);
  w1.w_carrier_left_z = fma(zd_carrier_left_ry, w1.R_carrier_left_aux2_z_y, w_carrier_left_aux2_z);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s4_8 = fma(s1_31, w1.w_carrier_left_y, w1.v_carrier_left_aux1_x);
  w1.v_wheel_front_left_x = fnma(s1_29, w1.w_carrier_left_z, s4_8);
  const double s4_9 = fnma(s1_31, w1.w_carrier_left_x, w1.v_carrier_left_aux1_y);
  w1.v_wheel_front_left_y = fma(s1_27, w1.w_carrier_left_z, s4_9);
  const double s4_10 = fma(s1_29, w1.w_carrier_left_x, w1.v_carrier_left_aux1_z);
  w1.v_wheel_front_left_z = fnma(s1_27, w1.w_carrier_left_y, s4_10);
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  w1.w_wheel_front_left_x = fnma(zd_wheel_front_left, w1.s1_22, w1.w_carrier_left_x);
  w1.w_wheel_front_left_y = fma(zd_wheel_front_left, w1.R_carrier_left_aux2_y_y,
      w1.w_carrier_left_y);
  w1.w_wheel_front_left_z = fma(zd_wheel_front_left, w1.R_carrier_left_aux2_z_y,
      w1.w_carrier_left_z);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s4_11 = fma(p_upper_arm_left_z, w1.w_chassis_y, w1.v_chassis_x);
  w1.v_upper_arm_left_x = fnma(p_upper_arm_left_y, w1.w_chassis_z, s4_11);
  const double s4_12 = fnma(p_upper_arm_left_z, w1.w_chassis_x, w1.v_chassis_y);
  w1.v_upper_arm_left_y = fma(p_lower_arm_left_x, w1.w_chassis_z, s4_12);
  const double s4_13 = fnma(p_lower_arm_left_x, w1.w_chassis_y, w1.v_chassis_z);
  w1.v_upper_arm_left_z = fma(p_upper_arm_left_y, w1.w_chassis_x, s4_13);
  w1.w_upper_arm_left_x = state.zd[Coordinate::upper_arm_left] + w1.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s4_14 = fma(p_arb_front_left_z, w1.w_chassis_y, w1.v_chassis_x);
  w1.v_arb_front_left_x = fnma(p_arb_front_left_y, w1.w_chassis_z, s4_14);
  const double s4_15 = fma(p_arb_front_left_x, w1.w_chassis_z, w1.v_chassis_y);
  w1.v_arb_front_left_y = fma(p_upper_arm_left_y, w1.w_chassis_x, s4_15);
  const double s4_16 = fma(p_arb_front_left_y, w1.w_chassis_x, w1.v_chassis_z);
  w1.v_arb_front_left_z = fnma(p_arb_front_left_x, w1.w_chassis_y, s4_16);
  w1.w_arb_front_left_y = state.zd[Coordinate::arb_front_left] + w1.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  w1.s4_17 = fma(p_lower_arm_left_y, w1.w_chassis_z, w1.v_chassis_x);
  w1.v_lower_arm_right_x = fma(p_lower_arm_left_z, w1.w_chassis_y, w1.s4_17);
  w1.s4_18 = fnma(p_lower_arm_left_y, w1.w_chassis_x, w1.v_chassis_z);
  w1.v_lower_arm_right_z = fnma(p_lower_arm_left_x, w1.w_chassis_y, w1.s4_18);
  w1.w_lower_arm_right_x = state.zd[Coordinate::lower_arm_right] + w1.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s4_19 = fnma(s1_38, w1.w_chassis_y, w1.v_lower_arm_right_x);
  w1.v_carrier_right_aux1_x = fnma(s1_36, w1.w_chassis_z, s4_19);
  w1.v_carrier_right_aux1_y = fma(s1_38, w1.w_lower_arm_right_x, w1.v_lower_arm_left_y);
  w1.v_carrier_right_aux1_z = fma(s1_36, w1.w_lower_arm_right_x, w1.v_lower_arm_right_z);
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double w_carrier_right_aux1_y = fma(zd_carrier_right_rz, R_carrier_right_aux1_y_z,
      w1.w_chassis_y);
  const double w_carrier_right_aux1_z = fma(zd_carrier_right_rz, R_carrier_right_aux1_z_z,
      w1.w_chassis_z);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double w_carrier_right_aux2_x = fma(zd_carrier_right_rx, R_carrier_right_aux1_x_x,
      w1.w_lower_arm_right_x);
  const double w_carrier_right_aux2_y = fma(zd_carrier_right_rx, R_carrier_right_aux1_y_x,
      w_carrier_right_aux1_y);
  const double w_carrier_right_aux2_z = fma(zd_carrier_right_rx, R_carrier_right_aux1_z_x,
      w_carrier_right_aux1_z);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  w1.w_carrier_right_x = fnma(zd_carrier_right_ry, w1.s1_41, w_carrier_right_aux2_x);
  w1.w_carrier_right_y = fma(zd_carrier_right_ry, w1.R_carrier_right_aux2_y_y,
      w_carrier_right_aux2_y);
  w1.w_carrier_right_z = fma(zd_carrier_right_ry, w1.R_carrier_right_aux2_z_y,
      w_carrier_right_aux2_z);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s4_20 = fma(s1_50, w1.w_carrier_right_y, w1.v_carrier_right_aux1_x);
  w1.v_wheel_front_right_x = fnma(s1_48, w1.w_carrier_right_z, s4_20);
  const double s4_21 = fnma(s1_50, w1.w_carrier_right_x, w1.v_carrier_right_aux1_y);
  w1.v_wheel_front_right_y = fma(s1_46, w1.w_carrier_right_z, s4_21);
  const double s4_22 = fma(s1_48, w1.w_carrier_right_x, w1.v_carrier_right_aux1_z);
  w1.v_wheel_front_right_z = fnma(s1_46, w1.w_carrier_right_y, s4_22);
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  w1.w_wheel_front_right_x = fnma(zd_wheel_front_right, w1.s1_41, w1.w_carrier_right_x);
  w1.w_wheel_front_right_y = fma(zd_wheel_front_right, w1.R_carrier_right_aux2_y_y,
      w1.w_carrier_right_y);
  w1.w_wheel_front_right_z = fma(zd_wheel_front_right, w1.R_carrier_right_aux2_z_y,
      w1.w_carrier_right_z);
  // upper_arm_right: upper_arm_right, revolute, chassis
  w1.v_upper_arm_right_x = fma(p_upper_arm_left_y, w1.w_chassis_z, s4_11);
  w1.v_upper_arm_right_z = fnma(p_upper_arm_left_y, w1.w_chassis_x, s4_13);
  w1.w_upper_arm_right_x = state.zd[Coordinate::upper_arm_right] + w1.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  w1.v_arb_front_right_x = fma(p_arb_front_left_y, w1.w_chassis_z, s4_14);
  const double s4_23 = fnma(p_arb_front_left_y, w1.w_chassis_x, w1.v_chassis_z);
  w1.v_arb_front_right_z = fnma(p_arb_front_left_x, w1.w_chassis_y, s4_23);
  w1.w_arb_front_right_y = state.zd[Coordinate::arb_front_right] + w1.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s4_24 = fma(p_pitman_arm_z, w1.w_chassis_y, w1.v_chassis_x);
  w1.v_pitman_arm_x = fnma(p_upper_arm_left_y, w1.w_chassis_z, s4_24);
  const double s4_25 = fma(p_pitman_arm_x, w1.w_chassis_z, w1.v_chassis_y);
  w1.v_pitman_arm_y = fma(p_lower_arm_left_y, w1.w_chassis_x, s4_25);
  const double s4_26 = fnma(p_pitman_arm_x, w1.w_chassis_y, w1.v_chassis_z);
  w1.v_pitman_arm_z = fma(p_upper_arm_left_y, w1.w_chassis_x, s4_26);
  w1.w_pitman_arm_y = state.zd[Coordinate::pitman_arm] + w1.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  w1.v_bell_crank_x = fma(p_bell_crank_z, w1.w_chassis_y, w1.v_chassis_x);
  const double s4_27 = fnma(p_bell_crank_z, w1.w_chassis_x, w1.v_chassis_y);
  w1.v_bell_crank_y = fma(p_bell_crank_x, w1.w_chassis_z, s4_27);
  w1.v_bell_crank_z = fnma(p_bell_crank_x, w1.w_chassis_y, w1.v_chassis_z);
  w1.w_bell_crank_z = state.zd[Coordinate::bell_crank] + w1.w_chassis_z;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double s4_28 = state.zd[Coordinate::rear_axle_tx] + w1.v_chassis_x;
  const double v_rear_axle_aux1_x = fma(p_arb_front_left_z, w1.w_chassis_y, s4_28);
  const double s4_29 = fma(w1.r_rear_axle_aux1_x, w1.w_chassis_z, w1.v_chassis_y);
  const double v_rear_axle_aux1_y = fma(p_upper_arm_left_y, w1.w_chassis_x, s4_29);
  const double v_rear_axle_aux1_z = fnma(w1.r_rear_axle_aux1_x, w1.w_chassis_y, w1.v_chassis_z);
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double v_rear_axle_aux2_x = fnma(z_rear_axle_ty, w1.w_chassis_z, v_rear_axle_aux1_x);
  const double v_rear_axle_aux2_y = state.zd[Coordinate::rear_axle_ty] + v_rear_axle_aux1_y;
  const double v_rear_axle_aux2_z = fma(z_rear_axle_ty, w1.w_chassis_x, v_rear_axle_aux1_z);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  w1.v_rear_axle_aux3_x = fma(z_rear_axle_tz, w1.w_chassis_y, v_rear_axle_aux2_x);
  w1.v_rear_axle_aux3_y = fnma(z_rear_axle_tz, w1.w_chassis_x, v_rear_axle_aux2_y);
  w1.v_rear_axle_aux3_z = state.zd[Coordinate::rear_axle_tz] + v_rear_axle_aux2_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double w_rear_axle_aux4_x = fma(zd_rear_axle_rz, R_rear_axle_aux4_x_z, w1.w_chassis_x);
  const double w_rear_axle_aux4_z = fma(zd_rear_axle_rz, R_rear_axle_aux4_z_z, w1.w_chassis_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double w_rear_axle_aux5_x = fnma(zd_rear_axle_ry, s1_52, w_rear_axle_aux4_x);
  const double w_rear_axle_aux5_y = fma(zd_rear_axle_ry, R_rear_axle_aux4_y_y, w1.w_chassis_y);
  const double w_rear_axle_aux5_z = fnma(zd_rear_axle_ry, s1_54, w_rear_axle_aux4_z);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  w1.w_rear_axle_x = fma(zd_rear_axle_rx, w1.R_rear_axle_aux5_x_x, w_rear_axle_aux5_x);
  w1.w_rear_axle_y = fma(zd_rear_axle_rx, w1.R_rear_axle_aux5_y_x, w_rear_axle_aux5_y);
  w1.w_rear_axle_z = fma(zd_rear_axle_rx, w1.R_rear_axle_aux5_z_x, w_rear_axle_aux5_z);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s4_30 = fnma(s1_60, w1.w_rear_axle_z, s1_61*w1.w_rear_axle_y);
  w1.v_wheel_rear_left_x = w1.v_rear_axle_aux3_x + s4_30;
  const double s4_31 = fnma(s1_61, w1.w_rear_axle_x, s1_59*w1.w_rear_axle_z);
  w1.v_wheel_rear_left_y = w1.v_rear_axle_aux3_y + s4_31;
  const double s4_32 = fnma(s1_59, w1.w_rear_axle_y, s1_60*w1.w_rear_axle_x);
  w1.v_wheel_rear_left_z = w1.v_rear_axle_aux3_z + s4_32;
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  w1.w_wheel_rear_left_x = fma(zd_wheel_rear_left, w1.R_rear_axle_x_y, w1.w_rear_axle_x);
  w1.w_wheel_rear_left_y = fma(zd_wheel_rear_left, w1.R_rear_axle_y_y, w1.w_rear_axle_y);
  w1.w_wheel_rear_left_z = fma(zd_wheel_rear_left, w1.R_rear_axle_z_y, w1.w_rear_axle_z);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s4_33 = fma(p_arb_rear_left_z, w1.w_chassis_y, w1.v_chassis_x);
  w1.v_arb_rear_left_x = fnma(p_arb_rear_left_y, w1.w_chassis_z, s4_33);
  const double s4_34 = fnma(p_arb_rear_left_z, w1.w_chassis_x, w1.v_chassis_y);
  w1.v_arb_rear_left_y = fma(p_arb_rear_left_x, w1.w_chassis_z, s4_34);
  const double s4_35 = fnma(p_arb_rear_left_x, w1.w_chassis_y, w1.v_chassis_z);
  w1.v_arb_rear_left_z = fma(p_arb_rear_left_y, w1.w_chassis_x, s4_35);
  w1.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + w1.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  w1.v_wheel_rear_right_x = w1.v_rear_axle_aux3_x - s4_30;
  w1.v_wheel_rear_right_y = w1.v_rear_axle_aux3_y - s4_31;
  w1.v_wheel_rear_right_z = w1.v_rear_axle_aux3_z - s4_32;
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  w1.w_wheel_rear_right_x = fma(zd_wheel_rear_right, w1.R_rear_axle_x_y, w1.w_rear_axle_x);
  w1.w_wheel_rear_right_y = fma(zd_wheel_rear_right, w1.R_rear_axle_y_y, w1.w_rear_axle_y);
  w1.w_wheel_rear_right_z = fma(zd_wheel_rear_right, w1.R_rear_axle_z_y, w1.w_rear_axle_z);
  // arb_rear_right: arb_rear_right, revolute, chassis
  w2.v_arb_rear_right_x = fma(p_arb_rear_left_y, w1.w_chassis_z, s4_33);
  w2.v_arb_rear_right_z = fnma(p_arb_rear_left_y, w1.w_chassis_x, s4_35);
  w2.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + w1.w_chassis_y;
  // operations: 140 add, 129 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  const double R_arb_front_left_x_x = w3.cosines[8];
  // arb_link_front_left
  const double R_arb_front_left_x_z = w3.sines[8];
  const double s7_1 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  w2.s7_2 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s7_1);
  const double s7_3 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  w2.s7_4 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s7_3);
  const double s7_5 = p_arb_link_front_left_to_x*w1.R_carrier_left_x_x;
  w2.s7_6 = fnma(p_arb_link_front_left_to_y, w1.s1_22 + w1.R_carrier_left_x_z, s7_5);
  const double s7_7 = w1.R_carrier_left_z_z - w1.R_carrier_left_aux2_z_y;
  const double s7_8 = p_arb_link_front_left_to_x*w1.R_carrier_left_z_x;
  w2.s7_9 = fnma(p_arb_link_front_left_to_y, s7_7, s7_8);
  const double s7_10 = w1.R_carrier_left_y_z - w1.R_carrier_left_aux2_y_y;
  const double s7_11 = p_arb_link_front_left_to_x*w1.R_carrier_left_y_x;
  w2.s7_12 = fnma(p_arb_link_front_left_to_y, s7_10, s7_11);
  const double R_arb_front_right_x_x = w3.cosines[14];
  // arb_link_front_right
  const double R_arb_front_right_x_z = w3.sines[14];
  const double s7_13 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  w2.s7_14 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s7_13);
  const double s7_15 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  w2.s7_16 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s7_15);
  const double s7_17 = p_arb_link_front_right_to_x*w1.R_carrier_right_x_x;
  const double s7_18 = w1.R_carrier_right_x_z - w1.s1_41;
  w2.s7_19 = fnma(p_arb_link_front_left_to_y, s7_18, s7_17);
  const double s7_20 = w1.R_carrier_right_aux2_z_y + w1.R_carrier_right_z_z;
  const double s7_21 = p_arb_link_front_right_to_x*w1.R_carrier_right_z_x;
  w2.s7_22 = fnma(p_arb_link_front_left_to_y, s7_20, s7_21);
  const double s7_23 = w1.R_carrier_right_aux2_y_y + w1.R_carrier_right_y_z;
  const double s7_24 = p_arb_link_front_right_to_x*w1.R_carrier_right_y_x;
  w2.s7_25 = fnma(p_arb_link_front_left_to_y, s7_23, s7_24);
  // drag_link
  w2.s7_26 = -p_drag_link_from_z*w3.sines[15];
  w2.s7_27 = -p_drag_link_from_z*w3.cosines[15];
  const double R_bell_crank_y_x = w3.sines[16];
  w2.s7_28 = p_drag_link_to_y*R_bell_crank_y_x;
  const double R_bell_crank_x_x = w3.cosines[16];
  w2.s7_29 = p_drag_link_to_y*R_bell_crank_x_x;
  // tie_rod_left
  const double s7_30 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s7_31 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  w2.s7_32 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s7_30);
  w2.s7_33 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_31);
  const double s7_34 = -p_tie_rod_left_to_y*w1.s1_22;
  const double s7_35 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_x_x, s7_34);
  w2.s7_36 = fma(p_tie_rod_left_to_z, w1.R_carrier_left_x_z, s7_35);
  const double s7_37 = p_tie_rod_left_to_z*w1.R_carrier_left_z_z;
  const double s7_38 = fma(p_tie_rod_left_to_y, w1.R_carrier_left_aux2_z_y, s7_37);
  w2.s7_39 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_z_x, s7_38);
  const double s7_40 = p_tie_rod_left_to_z*w1.R_carrier_left_y_z;
  const double s7_41 = fma(p_tie_rod_left_to_y, w1.R_carrier_left_aux2_y_y, s7_40);
  w2.s7_42 = fma(p_tie_rod_left_to_x, w1.R_carrier_left_y_x, s7_41);
  // tie_rod_right
  w2.s7_43 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_31);
  w2.s7_44 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s7_30);
  const double s7_45 = p_tie_rod_right_to_z*w1.R_carrier_right_x_z;
  const double s7_46 = fnma(p_tie_rod_right_to_y, w1.s1_41, s7_45);
  w2.s7_47 = fma(p_tie_rod_right_to_x, w1.R_carrier_right_x_x, s7_46);
  const double s7_48 = p_tie_rod_right_to_y*w1.R_carrier_right_aux2_z_y;
  const double s7_49 = fma(p_tie_rod_right_to_x, w1.R_carrier_right_z_x, s7_48);
  w2.s7_50 = fma(p_tie_rod_right_to_z, w1.R_carrier_right_z_z, s7_49);
  w2.s7_51 = p_tie_rod_right_to_y*w1.R_carrier_right_aux2_y_y;
}

/// Part 2 of compute_outputs: step 7: inertias of the bodies and forces on joints; step 9: outputs,
/// energies, power.
[[gnu::noinline]] void compute_outputs_2(const State& state, const double* tau,
    OutputsWork1& __restrict w1, OutputsWork2& __restrict w2, OutputsWork3& __restrict w3,
    Outputs& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  const double s7_52 = fma(p_tie_rod_right_to_x, w1.R_carrier_right_y_x, w2.s7_51);
  const double s7_53 = fma(p_tie_rod_right_to_z, w1.R_carrier_right_y_z, s7_52);
  // long_rod_left
  const double s7_54 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_z_x;
  const double s7_55 = fma(p_long_rod_left_to_z, w1.R_rear_axle_z_z, s7_54);
  const double s7_56 = fma(p_long_rod_left_to_y, w1.R_rear_axle_z_y, s7_55);
  const double s7_57 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_x_x;
  const double s7_58 = fma(p_long_rod_left_to_z, w1.R_rear_axle_x_z, s7_57);
  const double s7_59 = fma(p_long_rod_left_to_y, w1.R_rear_axle_x_y, s7_58);
  const double s7_60 = p_long_rod_left_to_x*w1.R_rear_axle_aux5_y_x;
  const double s7_61 = fma(p_long_rod_left_to_z, w1.R_rear_axle_y_z, s7_60);
  const double s7_62 = fma(p_long_rod_left_to_y, w1.R_rear_axle_y_y, s7_61);
  // diag_rod_left
  const double s7_63 = p_diag_rod_left_to_z*w1.R_rear_axle_z_z;
  const double s7_64 = fma(p_diag_rod_left_to_y, w1.R_rear_axle_z_y, s7_63);
  const double s7_65 = p_diag_rod_left_to_z*w1.R_rear_axle_x_z;
  const double s7_66 = fma(p_diag_rod_left_to_y, w1.R_rear_axle_x_y, s7_65);
  const double s7_67 = p_diag_rod_left_to_y*w1.R_rear_axle_y_y;
  const double s7_68 = fma(p_diag_rod_left_to_z, w1.R_rear_axle_y_z, s7_67);
  // arb_link_rear_left
  const double R_arb_rear_left_x_z = w3.sines[20];
  const double s7_69 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_z;
  const double s7_70 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_y_x;
  const double s7_71 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_y_z, s7_70);
  const double s7_72 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_z_x;
  const double s7_73 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_z_z, s7_72);
  const double s7_74 = -p_arb_link_rear_left_to_x*w1.R_rear_axle_aux5_x_x;
  const double s7_75 = fnma(p_arb_link_rear_left_to_z, w1.R_rear_axle_x_z, s7_74);
  const double R_arb_rear_left_x_x = w3.cosines[20];
  const double s7_76 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_x;
  const double s7_77 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_z_y, s7_73);
  const double s7_78 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_x_y, s7_75);
  const double s7_79 = fms(p_arb_link_rear_left_to_y, w1.R_rear_axle_y_y, s7_71);
  // long_rod_right
  const double s7_80 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_z_y, s7_55);
  const double s7_81 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_x_y, s7_58);
  const double s7_82 = fnma(p_long_rod_left_to_y, w1.R_rear_axle_y_y, s7_61);
  // diag_rod_right
  const double s7_83 = fnma(p_diag_rod_left_to_y, w1.R_rear_axle_z_y, s7_63);
  const double s7_84 = fnma(p_diag_rod_left_to_y, w1.R_rear_axle_x_y, s7_65);
  const double s7_85 = fms(p_diag_rod_left_to_z, w1.R_rear_axle_y_z, s7_67);
  // arb_link_rear_right
  const double s7_86 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_y_y, s7_71);
  const double s7_87 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_x_y, s7_75);
  const double s7_88 = fma(p_arb_link_rear_left_to_y, w1.R_rear_axle_z_y, s7_73);
  const double R_arb_rear_right_x_z = w3.sines[21];
  const double s7_89 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = w3.cosines[21];
  const double s7_90 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_x;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_91 = c_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s7_92 = c_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s7_93 = R_arb_rear_right_x_x*w1.w_chassis_x;
  const double s7_94 = fnma(R_arb_rear_right_x_z, w1.w_chassis_z, s7_93);
  const double s7_95 = I_arb_rear_right_yy*w2.w_arb_rear_right_y;
  const double s7_96 = fma(I_arb_rear_right_xy, s7_94, s7_95);
  const double s7_97 = I_arb_rear_right_xy*w2.w_arb_rear_right_y;
  const double s7_98 = fma(I_arb_rear_right_xx, s7_94, s7_97);
  const double s7_99 = R_arb_rear_right_x_z*w1.w_chassis_x;
  const double s7_100 = fma(R_arb_rear_right_x_x, w1.w_chassis_z, s7_99);
  const double s7_101 = I_arb_rear_right_zz*s7_100;
  const double s7_102 = w1.R_rear_axle_x_z*w1.w_wheel_rear_right_x;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_103 = fma(w1.R_rear_axle_y_z, w1.w_wheel_rear_right_y, s7_102);
  const double s7_104 = fma(w1.R_rear_axle_z_z, w1.w_wheel_rear_right_z, s7_103);
  const double s7_105 = w1.R_rear_axle_aux5_x_x*w1.w_wheel_rear_right_x;
  const double s7_106 = fma(w1.R_rear_axle_aux5_y_x, w1.w_wheel_rear_right_y, s7_105);
  const double s7_107 = fma(w1.R_rear_axle_aux5_z_x, w1.w_wheel_rear_right_z, s7_106);
  const double s7_108 = I_wheel_rear_right_xx*s7_107;
  const double s7_109 = I_wheel_rear_right_zz*s7_104;
  const double s7_110 = w1.R_rear_axle_x_y*w1.w_wheel_rear_right_x;
  const double s7_111 = fma(w1.R_rear_axle_y_y, w1.w_wheel_rear_right_y, s7_110);
  const double s7_112 = fma(w1.R_rear_axle_z_y, w1.w_wheel_rear_right_z, s7_111);
  const double s7_113 = I_wheel_rear_right_yy*s7_112;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_114 = c_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_115 = c_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s7_116 = R_arb_rear_left_x_x*w1.w_chassis_x;
  const double s7_117 = fnma(R_arb_rear_left_x_z, w1.w_chassis_z, s7_116);
  const double s7_118 = fma(I_arb_rear_left_xy, s7_117, I_arb_rear_left_yy*w1.w_arb_rear_left_y);
  const double s7_119 = fma(I_arb_rear_left_xy, w1.w_arb_rear_left_y, I_arb_rear_left_xx*s7_117);
  const double s7_120 = R_arb_rear_left_x_z*w1.w_chassis_x;
  const double s7_121 = fma(R_arb_rear_left_x_x, w1.w_chassis_z, s7_120);
  const double s7_122 = I_arb_rear_left_zz*s7_121;
  const double s7_123 = w1.R_rear_axle_x_z*w1.w_wheel_rear_left_x;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_124 = fma(w1.R_rear_axle_y_z, w1.w_wheel_rear_left_y, s7_123);
  const double s7_125 = fma(w1.R_rear_axle_z_z, w1.w_wheel_rear_left_z, s7_124);
  const double s7_126 = w1.R_rear_axle_aux5_x_x*w1.w_wheel_rear_left_x;
  const double s7_127 = fma(w1.R_rear_axle_aux5_y_x, w1.w_wheel_rear_left_y, s7_126);
  const double s7_128 = fma(w1.R_rear_axle_aux5_z_x, w1.w_wheel_rear_left_z, s7_127);
  const double s7_129 = I_wheel_rear_left_xx*s7_128;
  const double s7_130 = I_wheel_rear_left_zz*s7_125;
  const double s7_131 = w1.R_rear_axle_x_y*w1.w_wheel_rear_left_x;
  const double s7_132 = fma(w1.R_rear_axle_y_y, w1.w_wheel_rear_left_y, s7_131);
  const double s7_133 = fma(w1.R_rear_axle_z_y, w1.w_wheel_rear_left_z, s7_132);
  const double s7_134 = I_wheel_rear_left_yy*s7_133;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_135 = c_rear_axle_x*w1.R_rear_axle_aux5_y_x;
  const double s7_136 = fma(c_rear_axle_z, w1.R_rear_axle_y_z, s7_135);
  const double s7_137 = c_rear_axle_x*w1.R_rear_axle_aux5_z_x;
  const double s7_138 = fma(c_rear_axle_z, w1.R_rear_axle_z_z, s7_137);
  const double s7_139 = c_rear_axle_x*w1.R_rear_axle_aux5_x_x;
  const double s7_140 = fma(c_rear_axle_z, w1.R_rear_axle_x_z, s7_139);
  const double s7_141 = w1.R_rear_axle_x_z*w1.w_rear_axle_x;
  const double s7_142 = fma(w1.R_rear_axle_y_z, w1.w_rear_axle_y, s7_141);
  const double s7_143 = fma(w1.R_rear_axle_z_z, w1.w_rear_axle_z, s7_142);
  const double s7_144 = w1.R_rear_axle_aux5_x_x*w1.w_rear_axle_x;
  const double s7_145 = fma(w1.R_rear_axle_aux5_y_x, w1.w_rear_axle_y, s7_144);
  const double s7_146 = fma(w1.R_rear_axle_aux5_z_x, w1.w_rear_axle_z, s7_145);
  const double s7_147 = fma(I_rear_axle_xz, s7_143, I_rear_axle_xx*s7_146);
  const double s7_148 = fma(I_rear_axle_xz, s7_146, I_rear_axle_zz*s7_143);
  const double s7_149 = w1.R_rear_axle_x_y*w1.w_rear_axle_x;
  const double s7_150 = fma(w1.R_rear_axle_y_y, w1.w_rear_axle_y, s7_149);
  const double s7_151 = fma(w1.R_rear_axle_z_y, w1.w_rear_axle_z, s7_150);
  const double s7_152 = I_rear_axle_yy*s7_151;
  const double R_bell_crank_x_x = w3.cosines[16];
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_y_x = w3.sines[16];
  const double s7_153 = fma(c_bell_crank_y, R_bell_crank_y_x, -c_bell_crank_x*R_bell_crank_x_x);
  const double s7_154 = fma(c_bell_crank_x, R_bell_crank_y_x, c_bell_crank_y*R_bell_crank_x_x);
  const double s7_155 = fnma(R_bell_crank_y_x, w1.w_chassis_x, R_bell_crank_x_x*w1.w_chassis_y);
  const double s7_156 = I_bell_crank_zz*w1.w_bell_crank_z;
  const double s7_157 = fma(R_bell_crank_y_x, w1.w_chassis_y, R_bell_crank_x_x*w1.w_chassis_x);
  const double s7_158 = fma(I_bell_crank_xy, s7_157, I_bell_crank_yy*s7_155);
  const double s7_159 = fma(I_bell_crank_xy, s7_155, I_bell_crank_xx*s7_157);
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = w3.sines[15];
  const double s7_160 = -c_pitman_arm_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = w3.cosines[15];
  const double s7_161 = -c_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_162 = fnma(R_pitman_arm_x_z, w1.w_chassis_z, R_pitman_arm_x_x*w1.w_chassis_x);
  const double s7_163 = I_pitman_arm_yy*w1.w_pitman_arm_y;
  const double s7_164 = I_pitman_arm_xx*s7_162;
  const double s7_165 = fma(R_pitman_arm_x_x, w1.w_chassis_z, R_pitman_arm_x_z*w1.w_chassis_x);
  const double s7_166 = I_pitman_arm_zz*s7_165;
  const double R_arb_front_right_x_x = w3.cosines[14];
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = w3.sines[14];
  const double s7_167 = c_arb_front_right_z*R_arb_front_right_x_x;
  const double s7_168 = fnma(c_arb_front_right_x, R_arb_front_right_x_z, s7_167);
  const double s7_169 = c_arb_front_right_z*R_arb_front_right_x_z;
  const double s7_170 = fma(c_arb_front_right_x, R_arb_front_right_x_x, s7_169);
  const double s7_171 = R_arb_front_right_x_x*w1.w_chassis_x;
  const double s7_172 = fnma(R_arb_front_right_x_z, w1.w_chassis_z, s7_171);
  const double s7_173 = R_arb_front_right_x_z*w1.w_chassis_x;
  const double s7_174 = fma(R_arb_front_right_x_x, w1.w_chassis_z, s7_173);
  const double s7_175 = I_arb_front_right_yy*w1.w_arb_front_right_y;
  const double s7_176 = fma(I_arb_front_right_xy, s7_172, s7_175);
  const double s7_177 = fma(I_arb_front_right_yz, s7_174, s7_176);
  const double s7_178 = I_arb_front_right_xx*s7_172;
  const double s7_179 = fma(I_arb_front_right_xy, w1.w_arb_front_right_y, s7_178);
  const double s7_180 = fma(I_arb_front_right_xz, s7_174, s7_179);
  const double s7_181 = I_arb_front_right_yz*w1.w_arb_front_right_y;
  const double s7_182 = fma(I_arb_front_right_xz, s7_172, s7_181);
  const double s7_183 = fma(I_arb_front_right_zz, s7_174, s7_182);
  const double R_upper_arm_right_z_y = w3.sines[13];
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_y_y = w3.cosines[13];
  const double s7_184 = -c_upper_arm_right_z*R_upper_arm_right_z_y;
  const double s7_185 = fma(c_upper_arm_right_y, R_upper_arm_right_y_y, s7_184);
  const double s7_186 = -c_upper_arm_right_z*R_upper_arm_right_y_y;
  const double s7_187 = fnma(c_upper_arm_right_y, R_upper_arm_right_z_y, s7_186);
  const double s7_188 = R_upper_arm_right_y_y*w1.w_chassis_y;
  const double s7_189 = fma(R_upper_arm_right_z_y, w1.w_chassis_z, s7_188);
  const double s7_190 = R_upper_arm_right_y_y*w1.w_chassis_z;
  const double s7_191 = fnma(R_upper_arm_right_z_y, w1.w_chassis_y, s7_190);
  const double s7_192 = I_upper_arm_right_zz*s7_191;
  const double s7_193 = I_upper_arm_right_yy*s7_189;
  const double s7_194 = I_upper_arm_right_xx*w1.w_upper_arm_right_x;
  const double s7_195 = w1.R_carrier_right_x_x*w1.w_wheel_front_right_x;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_196 = fma(w1.R_carrier_right_y_x, w1.w_wheel_front_right_y, s7_195);
  const double s7_197 = fma(w1.R_carrier_right_z_x, w1.w_wheel_front_right_z, s7_196);
  const double s7_198 = w1.R_carrier_right_aux2_y_y*w1.w_wheel_front_right_y;
  const double s7_199 = fnma(w1.s1_41, w1.w_wheel_front_right_x, s7_198);
  const double s7_200 = fma(w1.R_carrier_right_aux2_z_y, w1.w_wheel_front_right_z, s7_199);
  const double s7_201 = I_wheel_front_right_yy*s7_200;
  const double s7_202 = I_wheel_front_right_xx*s7_197;
  const double s7_203 = w1.R_carrier_right_x_z*w1.w_wheel_front_right_x;
  const double s7_204 = fma(w1.R_carrier_right_y_z, w1.w_wheel_front_right_y, s7_203);
  const double s7_205 = fma(w1.R_carrier_right_z_z, w1.w_wheel_front_right_z, s7_204);
  const double s7_206 = I_wheel_front_right_zz*s7_205;
  const double s7_207 = c_carrier_right_z*w1.R_carrier_right_y_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_208 = fma(c_carrier_right_y, w1.R_carrier_right_aux2_y_y, s7_207);
  const double s7_209 = fma(c_carrier_right_x, w1.R_carrier_right_y_x, s7_208);
  const double s7_210 = c_carrier_right_z*w1.R_carrier_right_z_z;
  const double s7_211 = fma(c_carrier_right_y, w1.R_carrier_right_aux2_z_y, s7_210);
  const double s7_212 = fma(c_carrier_right_x, w1.R_carrier_right_z_x, s7_211);
  const double s7_213 = -c_carrier_right_y*w1.s1_41;
  const double s7_214 = fma(c_carrier_right_x, w1.R_carrier_right_x_x, s7_213);
  const double s7_215 = fma(c_carrier_right_z, w1.R_carrier_right_x_z, s7_214);
  const double s7_216 = w1.R_carrier_right_x_x*w1.w_carrier_right_x;
  const double s7_217 = fma(w1.R_carrier_right_y_x, w1.w_carrier_right_y, s7_216);
  const double s7_218 = fma(w1.R_carrier_right_z_x, w1.w_carrier_right_z, s7_217);
  const double s7_219 = w1.R_carrier_right_aux2_y_y*w1.w_carrier_right_y;
  const double s7_220 = fnma(w1.s1_41, w1.w_carrier_right_x, s7_219);
  const double s7_221 = fma(w1.R_carrier_right_aux2_z_y, w1.w_carrier_right_z, s7_220);
  const double s7_222 = w1.R_carrier_right_x_z*w1.w_carrier_right_x;
  const double s7_223 = fma(w1.R_carrier_right_y_z, w1.w_carrier_right_y, s7_222);
  const double s7_224 = fma(w1.R_carrier_right_z_z, w1.w_carrier_right_z, s7_223);
  const double s7_225 = fma(I_carrier_right_yy, s7_221, I_carrier_right_xy*s7_218);
  const double s7_226 = fma(I_carrier_right_yz, s7_224, s7_225);
  const double s7_227 = fma(I_carrier_right_xy, s7_221, I_carrier_right_xx*s7_218);
  const double s7_228 = fma(I_carrier_right_xz, s7_224, s7_227);
  const double s7_229 = fma(I_carrier_right_xz, s7_218, I_carrier_right_yz*s7_221);
  const double s7_230 = fma(I_carrier_right_zz, s7_224, s7_229);
  const double R_lower_arm_right_z_y = w3.sines[9];
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_y_y = w3.cosines[9];
  const double s7_231 = -c_lower_arm_right_z*R_lower_arm_right_z_y;
  const double s7_232 = fma(c_lower_arm_right_y, R_lower_arm_right_y_y, s7_231);
  const double s7_233 = -c_lower_arm_right_z*R_lower_arm_right_y_y;
  const double s7_234 = fnma(c_lower_arm_right_y, R_lower_arm_right_z_y, s7_233);
  const double s7_235 = R_lower_arm_right_y_y*w1.w_chassis_y;
  const double s7_236 = fma(R_lower_arm_right_z_y, w1.w_chassis_z, s7_235);
  const double s7_237 = R_lower_arm_right_y_y*w1.w_chassis_z;
  const double s7_238 = fnma(R_lower_arm_right_z_y, w1.w_chassis_y, s7_237);
  const double s7_239 = I_lower_arm_right_zz*s7_238;
  const double s7_240 = I_lower_arm_right_yy*s7_236;
  const double s7_241 = I_lower_arm_right_xx*w1.w_lower_arm_right_x;
  const double R_arb_front_left_x_x = w3.cosines[8];
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = w3.sines[8];
  const double s7_242 = c_arb_front_left_z*R_arb_front_left_x_x;
  const double s7_243 = fnma(c_arb_front_left_x, R_arb_front_left_x_z, s7_242);
  const double s7_244 = c_arb_front_left_z*R_arb_front_left_x_z;
  const double s7_245 = fma(c_arb_front_left_x, R_arb_front_left_x_x, s7_244);
  const double s7_246 = R_arb_front_left_x_x*w1.w_chassis_x;
  const double s7_247 = fnma(R_arb_front_left_x_z, w1.w_chassis_z, s7_246);
  const double s7_248 = R_arb_front_left_x_z*w1.w_chassis_x;
  const double s7_249 = fma(R_arb_front_left_x_x, w1.w_chassis_z, s7_248);
  const double s7_250 = I_arb_front_left_yy*w1.w_arb_front_left_y;
  const double s7_251 = fma(I_arb_front_left_xy, s7_247, s7_250);
  const double s7_252 = fma(I_arb_front_left_yz, s7_249, s7_251);
  const double s7_253 = I_arb_front_left_xy*w1.w_arb_front_left_y;
  const double s7_254 = fma(I_arb_front_left_xx, s7_247, s7_253);
  const double s7_255 = fma(I_arb_front_left_xz, s7_249, s7_254);
  const double s7_256 = I_arb_front_left_xz*s7_247;
  const double s7_257 = fma(I_arb_front_left_yz, w1.w_arb_front_left_y, s7_256);
  const double s7_258 = fma(I_arb_front_left_zz, s7_249, s7_257);
  const double R_upper_arm_left_z_y = w3.sines[7];
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_y_y = w3.cosines[7];
  const double s7_259 = c_upper_arm_left_y*R_upper_arm_left_z_y;
  const double s7_260 = fma(c_upper_arm_left_z, R_upper_arm_left_y_y, s7_259);
  const double s7_261 = c_upper_arm_left_y*R_upper_arm_left_y_y;
  const double s7_262 = fnma(c_upper_arm_left_z, R_upper_arm_left_z_y, s7_261);
  const double s7_263 = R_upper_arm_left_y_y*w1.w_chassis_y;
  const double s7_264 = fma(R_upper_arm_left_z_y, w1.w_chassis_z, s7_263);
  const double s7_265 = R_upper_arm_left_y_y*w1.w_chassis_z;
  const double s7_266 = fnma(R_upper_arm_left_z_y, w1.w_chassis_y, s7_265);
  const double s7_267 = I_upper_arm_left_zz*s7_266;
  const double s7_268 = I_upper_arm_left_yy*s7_264;
  const double s7_269 = I_upper_arm_left_xx*w1.w_upper_arm_left_x;
  const double s7_270 = w1.R_carrier_left_x_x*w1.w_wheel_front_left_x;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_271 = fma(w1.R_carrier_left_y_x, w1.w_wheel_front_left_y, s7_270);
  const double s7_272 = fma(w1.R_carrier_left_z_x, w1.w_wheel_front_left_z, s7_271);
  const double s7_273 = w1.R_carrier_left_aux2_y_y*w1.w_wheel_front_left_y;
  const double s7_274 = fnma(w1.s1_22, w1.w_wheel_front_left_x, s7_273);
  const double s7_275 = fma(w1.R_carrier_left_aux2_z_y, w1.w_wheel_front_left_z, s7_274);
  const double s7_276 = I_wheel_front_left_yy*s7_275;
  const double s7_277 = I_wheel_front_left_xx*s7_272;
  const double s7_278 = w1.R_carrier_left_x_z*w1.w_wheel_front_left_x;
  const double s7_279 = fma(w1.R_carrier_left_y_z, w1.w_wheel_front_left_y, s7_278);
  const double s7_280 = fma(w1.R_carrier_left_z_z, w1.w_wheel_front_left_z, s7_279);
  const double s7_281 = I_wheel_front_left_zz*s7_280;
  const double s7_282 = c_carrier_left_y*w1.R_carrier_left_aux2_y_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_283 = fma(c_carrier_left_x, w1.R_carrier_left_y_x, s7_282);
  const double s7_284 = fma(c_carrier_left_z, w1.R_carrier_left_y_z, s7_283);
  const double s7_285 = c_carrier_left_y*w1.R_carrier_left_aux2_z_y;
  const double s7_286 = fma(c_carrier_left_x, w1.R_carrier_left_z_x, s7_285);
  const double s7_287 = fma(c_carrier_left_z, w1.R_carrier_left_z_z, s7_286);
  const double s7_288 = fnma(c_carrier_left_y, w1.s1_22, c_carrier_left_z*w1.R_carrier_left_x_z);
  const double s7_289 = fma(c_carrier_left_x, w1.R_carrier_left_x_x, s7_288);
  const double s7_290 = w1.R_carrier_left_x_x*w1.w_carrier_left_x;
  const double s7_291 = fma(w1.R_carrier_left_y_x, w1.w_carrier_left_y, s7_290);
  const double s7_292 = fma(w1.R_carrier_left_z_x, w1.w_carrier_left_z, s7_291);
  const double s7_293 = w1.R_carrier_left_aux2_y_y*w1.w_carrier_left_y;
  const double s7_294 = fnma(w1.s1_22, w1.w_carrier_left_x, s7_293);
  const double s7_295 = fma(w1.R_carrier_left_aux2_z_y, w1.w_carrier_left_z, s7_294);
  const double s7_296 = w1.R_carrier_left_x_z*w1.w_carrier_left_x;
  const double s7_297 = fma(w1.R_carrier_left_y_z, w1.w_carrier_left_y, s7_296);
  const double s7_298 = fma(w1.R_carrier_left_z_z, w1.w_carrier_left_z, s7_297);
  const double s7_299 = fma(I_carrier_left_xy, s7_292, I_carrier_left_yy*s7_295);
  const double s7_300 = fma(I_carrier_left_yz, s7_298, s7_299);
  const double s7_301 = fma(I_carrier_left_xy, s7_295, I_carrier_left_xx*s7_292);
  const double s7_302 = fma(I_carrier_left_xz, s7_298, s7_301);
  const double s7_303 = fma(I_carrier_left_xz, s7_292, I_carrier_left_zz*s7_298);
  const double s7_304 = fma(I_carrier_left_yz, s7_295, s7_303);
  const double R_lower_arm_left_z_y = w3.sines[3];
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_y_y = w3.cosines[3];
  const double s7_305 = c_lower_arm_left_y*R_lower_arm_left_z_y;
  const double s7_306 = fma(c_lower_arm_left_z, R_lower_arm_left_y_y, s7_305);
  const double s7_307 = c_lower_arm_left_y*R_lower_arm_left_y_y;
  const double s7_308 = fnma(c_lower_arm_left_z, R_lower_arm_left_z_y, s7_307);
  const double s7_309 = R_lower_arm_left_y_y*w1.w_chassis_y;
  const double s7_310 = fma(R_lower_arm_left_z_y, w1.w_chassis_z, s7_309);
  const double s7_311 = R_lower_arm_left_y_y*w1.w_chassis_z;
  const double s7_312 = fnma(R_lower_arm_left_z_y, w1.w_chassis_y, s7_311);
  const double s7_313 = I_lower_arm_left_zz*s7_312;
  const double s7_314 = I_lower_arm_left_yy*s7_310;
  const double s7_315 = I_lower_arm_left_xx*w1.w_lower_arm_left_x;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_316 = fma(I_chassis_xz, w1.w_chassis_x, I_chassis_zz*w1.w_chassis_z);
  const double s7_317 = I_chassis_yy*w1.w_chassis_y;
  const double s7_318 = fma(I_chassis_xz, w1.w_chassis_z, I_chassis_xx*w1.w_chassis_x);
  // operations: 181 add, 334 multiply

  // --- step 9: outputs, energies, power ---
  const double s9_1 = state.zd[Coordinate::chassis_tx]*tau[Coordinate::chassis_tx];
  const double s9_2 = fma(state.zd[Coordinate::chassis_ty], tau[Coordinate::chassis_ty], s9_1);
  const double s9_3 = fma(state.zd[Coordinate::chassis_tz], tau[Coordinate::chassis_tz], s9_2);
  const double s9_4 = fma(state.zd[Coordinate::chassis_rz], tau[Coordinate::chassis_rz], s9_3);
  const double s9_5 = fma(state.zd[Coordinate::chassis_ry], tau[Coordinate::chassis_ry], s9_4);
  const double s9_6 = fma(state.zd[Coordinate::chassis_rx], tau[Coordinate::chassis_rx], s9_5);
  const double s9_7 = fma(state.zd[Coordinate::lower_arm_left], tau[Coordinate::lower_arm_left],
      s9_6);
  const double s9_8 = fma(state.zd[Coordinate::carrier_left_rz], tau[Coordinate::carrier_left_rz],
      s9_7);
  const double s9_9 = fma(state.zd[Coordinate::carrier_left_rx], tau[Coordinate::carrier_left_rx],
      s9_8);
  const double s9_10 = fma(state.zd[Coordinate::carrier_left_ry], tau[Coordinate::carrier_left_ry],
      s9_9);
  const double s9_11 = fma(state.zd[Coordinate::wheel_front_left],
      tau[Coordinate::wheel_front_left], s9_10);
  const double s9_12 = fma(state.zd[Coordinate::upper_arm_left], tau[Coordinate::upper_arm_left],
      s9_11);
  const double s9_13 = fma(state.zd[Coordinate::arb_front_left], tau[Coordinate::arb_front_left],
      s9_12);
  const double s9_14 = fma(state.zd[Coordinate::lower_arm_right], tau[Coordinate::lower_arm_right],
      s9_13);
  const double s9_15 = fma(state.zd[Coordinate::carrier_right_rz],
      tau[Coordinate::carrier_right_rz], s9_14);
  const double s9_16 = fma(state.zd[Coordinate::carrier_right_rx],
      tau[Coordinate::carrier_right_rx], s9_15);
  const double s9_17 = fma(state.zd[Coordinate::carrier_right_ry],
      tau[Coordinate::carrier_right_ry], s9_16);
  const double s9_18 = fma(state.zd[Coordinate::wheel_front_right],
      tau[Coordinate::wheel_front_right], s9_17);
  const double s9_19 = fma(state.zd[Coordinate::upper_arm_right], tau[Coordinate::upper_arm_right],
      s9_18);
  const double s9_20 = fma(state.zd[Coordinate::arb_front_right], tau[Coordinate::arb_front_right],
      s9_19);
  const double s9_21 = fma(state.zd[Coordinate::pitman_arm], tau[Coordinate::pitman_arm], s9_20);
  const double s9_22 = fma(state.zd[Coordinate::bell_crank], tau[Coordinate::bell_crank], s9_21);
  const double s9_23 = fma(state.zd[Coordinate::rear_axle_tx], tau[Coordinate::rear_axle_tx],
      s9_22);
  const double s9_24 = fma(state.zd[Coordinate::rear_axle_ty], tau[Coordinate::rear_axle_ty],
      s9_23);
  const double s9_25 = fma(state.zd[Coordinate::rear_axle_tz], tau[Coordinate::rear_axle_tz],
      s9_24);
  const double s9_26 = fma(state.zd[Coordinate::rear_axle_rz], tau[Coordinate::rear_axle_rz],
      s9_25);
  const double s9_27 = fma(state.zd[Coordinate::rear_axle_ry], tau[Coordinate::rear_axle_ry],
      s9_26);
  const double s9_28 = fma(state.zd[Coordinate::rear_axle_rx], tau[Coordinate::rear_axle_rx],
      s9_27);
  const double s9_29 = fma(state.zd[Coordinate::wheel_rear_left], tau[Coordinate::wheel_rear_left],
      s9_28);
  const double s9_30 = fma(state.zd[Coordinate::arb_rear_left], tau[Coordinate::arb_rear_left],
      s9_29);
  const double s9_31 = fma(state.zd[Coordinate::wheel_rear_right],
      tau[Coordinate::wheel_rear_right], s9_30);
  result.applied_power = fma(state.zd[Coordinate::arb_rear_right], tau[Coordinate::arb_rear_right],
      s9_31);
  const double s9_32 = fnma(w1.w_rear_axle_z, s7_87, w1.v_rear_axle_aux3_y);
  const double s9_33 = fma(w1.w_chassis_x, s7_89, w1.v_arb_rear_left_y);
  const double s9_34 = fnma(w1.w_rear_axle_x, s7_86, w1.v_rear_axle_aux3_z);
  const double s9_35 = fnma(w2.w_arb_rear_right_y, s7_90, w2.v_arb_rear_right_z);
  const double s9_36 = fma(w1.w_rear_axle_z, s7_86, w1.v_rear_axle_aux3_x);
  const double s9_37 = fnma(w2.w_arb_rear_right_y, s7_89, w2.v_arb_rear_right_x);
  const double s9_38 = fnma(p_diag_rod_left_from_z, w1.w_chassis_x, w1.v_chassis_y);
  const double s9_39 = fnma(w1.w_rear_axle_x, s7_83, w1.v_rear_axle_aux3_y);
  const double s9_40 = fma(w1.w_rear_axle_y, s7_83, w1.v_rear_axle_aux3_x);
  const double s9_41 = fnma(w1.w_rear_axle_y, s7_84, w1.v_rear_axle_aux3_z);
  const double s9_42 = fma(p_long_rod_left_from_x, w1.w_chassis_z, w1.v_chassis_y);
  const double s9_43 = fnma(w1.w_rear_axle_x, s7_80, w1.v_rear_axle_aux3_y);
  const double s9_44 = fma(p_long_rod_left_from_z, w1.w_chassis_y, w1.v_chassis_x);
  const double s9_45 = fma(w1.w_rear_axle_y, s7_80, w1.v_rear_axle_aux3_x);
  const double s9_46 = fnma(p_long_rod_left_from_x, w1.w_chassis_y, w1.v_chassis_z);
  const double s9_47 = fnma(w1.w_rear_axle_y, s7_81, w1.v_rear_axle_aux3_z);
  const double s9_48 = fnma(w1.w_rear_axle_x, s7_77, w1.v_rear_axle_aux3_y);
  const double s9_49 = fma(w1.w_chassis_x, s7_69, w1.v_arb_rear_left_y);
  const double s9_50 = fnma(w1.w_rear_axle_y, s7_78, w1.v_rear_axle_aux3_z);
  const double s9_51 = fnma(w1.w_arb_rear_left_y, s7_76, w1.v_arb_rear_left_z);
  const double s9_52 = fma(w1.w_rear_axle_y, s7_77, w1.v_rear_axle_aux3_x);
  const double s9_53 = fnma(w1.w_arb_rear_left_y, s7_69, w1.v_arb_rear_left_x);
  const double s9_54 = fnma(w1.w_rear_axle_x, s7_64, w1.v_rear_axle_aux3_y);
  const double s9_55 = fnma(w1.w_rear_axle_y, s7_66, w1.v_rear_axle_aux3_z);
  const double s9_56 = fma(w1.w_rear_axle_y, s7_64, w1.v_rear_axle_aux3_x);
  const double s9_57 = fnma(w1.w_rear_axle_x, s7_56, w1.v_rear_axle_aux3_y);
  const double s9_58 = fnma(w1.w_rear_axle_y, s7_59, w1.v_rear_axle_aux3_z);
  const double s9_59 = fma(w1.w_rear_axle_y, s7_56, w1.v_rear_axle_aux3_x);
  const double s9_60 = fma(w1.w_carrier_right_z, w2.s7_47, w1.v_carrier_right_aux1_y);
  const double s9_61 = fma(w1.w_carrier_right_y, w2.s7_50, w1.v_carrier_right_aux1_x);
  const double s9_62 = fnma(w1.w_carrier_right_y, w2.s7_47, w1.v_carrier_right_aux1_z);
  const double s9_63 = fnma(w1.w_chassis_x, w2.s7_43, w1.v_bell_crank_z);
  const double s9_64 = fma(w1.w_carrier_left_z, w2.s7_36, w1.v_carrier_left_aux1_y);
  const double s9_65 = fma(w1.w_carrier_left_y, w2.s7_39, w1.v_carrier_left_aux1_x);
  const double s9_66 = fnma(w1.w_carrier_left_y, w2.s7_36, w1.v_carrier_left_aux1_z);
  const double s9_67 = fma(w1.w_chassis_y, w2.s7_32, w1.v_bell_crank_z);
  const double s9_68 = fnma(w1.w_chassis_z, w2.s7_26, w1.v_pitman_arm_y);
  const double s9_69 = fma(w1.w_chassis_y, w2.s7_28, w1.v_bell_crank_z);
  const double s9_70 = fnma(w1.w_bell_crank_z, w2.s7_28, w1.v_bell_crank_y);
  const double s9_71 = fnma(w1.w_pitman_arm_y, w2.s7_27, w1.v_pitman_arm_x);
  const double s9_72 = fnma(w1.w_bell_crank_z, w2.s7_29, w1.v_bell_crank_x);
  const double s9_73 = fma(s9_71, s9_72, s9_70*fma(w1.w_chassis_x, w2.s7_27, s9_68));
  const double s9_74 = fma(w1.w_pitman_arm_y, w2.s7_26, w1.v_pitman_arm_z);
  const double s9_75 = fma(w1.w_carrier_left_z, w2.s7_6, w1.v_carrier_left_aux1_y);
  const double s9_76 = fnma(w1.w_chassis_x, w2.s7_2, w1.v_arb_front_left_y);
  const double s9_77 = fnma(w1.w_carrier_left_y, w2.s7_6, w1.v_carrier_left_aux1_z);
  const double s9_78 = fnma(w1.w_arb_front_left_y, w2.s7_4, w1.v_arb_front_left_z);
  const double s9_79 = fma(w1.w_carrier_left_y, w2.s7_9, w1.v_carrier_left_aux1_x);
  const double s9_80 = fma(w1.w_arb_front_left_y, w2.s7_2, w1.v_arb_front_left_x);
  const double s9_81 = fnma(w1.w_chassis_x, w2.s7_14, w1.v_arb_front_left_y);
  const double s9_82 = fma(w1.w_carrier_right_z, w2.s7_19, w1.v_carrier_right_aux1_y);
  const double s9_83 = fnma(w1.w_carrier_right_y, w2.s7_19, w1.v_carrier_right_aux1_z);
  const double s9_84 = fnma(w1.w_arb_front_right_y, w2.s7_16, w1.v_arb_front_right_z);
  const double s9_85 = fma(w1.w_carrier_right_y, w2.s7_22, w1.v_carrier_right_aux1_x);
  const double s9_86 = fma(w1.w_arb_front_right_y, w2.s7_14, w1.v_arb_front_right_x);
  const double s9_87 = fma(w1.w_chassis_x, s7_91, w1.v_arb_rear_left_y);
  const double s9_88 = fma(w1.w_chassis_z, s7_92, s9_87);
  const double s9_89 = fnma(w2.w_arb_rear_right_y, s7_92, w2.v_arb_rear_right_z);
  const double s9_90 = fnma(c_arb_rear_left_y, w1.w_chassis_x, s9_89);
  const double s9_91 = fnma(w2.w_arb_rear_right_y, s7_91, w2.v_arb_rear_right_x);
  const double s9_92 = fma(c_arb_rear_left_y, w1.w_chassis_z, s9_91);
  const double s9_93 = fma(w1.w_chassis_x, s7_114, w1.v_arb_rear_left_y);
  const double s9_94 = fma(w1.w_chassis_z, s7_115, s9_93);
  const double s9_95 = fnma(w1.w_arb_rear_left_y, s7_114, w1.v_arb_rear_left_x);
  const double s9_96 = fnma(c_arb_rear_left_y, w1.w_chassis_z, s9_95);
  const double s9_97 = fnma(w1.w_arb_rear_left_y, s7_115, w1.v_arb_rear_left_z);
  const double s9_98 = fma(c_arb_rear_left_y, w1.w_chassis_x, s9_97);
  const double s9_99 = fnma(w1.w_rear_axle_x, s7_138, w1.v_rear_axle_aux3_y);
  const double s9_100 = fma(w1.w_rear_axle_z, s7_140, s9_99);
  const double s9_101 = fma(w1.w_rear_axle_x, s7_136, w1.v_rear_axle_aux3_z);
  const double s9_102 = fnma(w1.w_rear_axle_y, s7_140, s9_101);
  const double s9_103 = fnma(w1.w_rear_axle_z, s7_136, w1.v_rear_axle_aux3_x);
  const double s9_104 = fma(w1.w_rear_axle_y, s7_138, s9_103);
  const double s9_105 = fnma(w1.w_bell_crank_z, s7_153, w1.v_bell_crank_y);
  const double s9_106 = fnma(w1.w_bell_crank_z, s7_154, w1.v_bell_crank_x);
  const double s9_107 = fma(w1.w_chassis_y, s7_153, w1.v_bell_crank_z);
  const double s9_108 = fma(w1.w_chassis_x, s7_154, s9_107);
  const double s9_109 = fma(w1.w_pitman_arm_y, s7_160, w1.v_pitman_arm_z);
  const double s9_110 = fnma(w1.w_pitman_arm_y, s7_161, w1.v_pitman_arm_x);
  const double s9_111 = fnma(w1.w_chassis_z, s7_160, w1.v_pitman_arm_y);
  const double s9_112 = fma(w1.w_chassis_x, s7_161, s9_111);
  const double s9_113 = fnma(w1.w_chassis_x, s7_168, w1.v_arb_front_left_y);
  const double s9_114 = fma(w1.w_chassis_z, s7_170, s9_113);
  const double s9_115 = fma(w1.w_arb_front_right_y, s7_168, w1.v_arb_front_right_x);
  const double s9_116 = fma(c_arb_front_left_y, w1.w_chassis_z, s9_115);
  const double s9_117 = fnma(w1.w_arb_front_right_y, s7_170, w1.v_arb_front_right_z);
  const double s9_118 = fnma(c_arb_front_left_y, w1.w_chassis_x, s9_117);
  const double s9_119 = fma(w1.w_upper_arm_right_x, s7_187, w1.v_upper_arm_left_y);
  const double s9_120 = fma(w1.w_upper_arm_right_x, s7_185, w1.v_upper_arm_right_z);
  const double s9_121 = fnma(w1.w_chassis_z, s7_185, w1.v_upper_arm_right_x);
  const double s9_122 = fnma(w1.w_chassis_y, s7_187, s9_121);
  const double s9_123 = fnma(w1.w_carrier_right_x, s7_212, w1.v_carrier_right_aux1_y);
  const double s9_124 = fma(w1.w_carrier_right_z, s7_215, s9_123);
  const double s9_125 = fma(w1.w_carrier_right_x, s7_209, w1.v_carrier_right_aux1_z);
  const double s9_126 = fnma(w1.w_carrier_right_y, s7_215, s9_125);
  const double s9_127 = fnma(w1.w_carrier_right_z, s7_209, w1.v_carrier_right_aux1_x);
  const double s9_128 = fma(w1.w_carrier_right_y, s7_212, s9_127);
  const double s9_129 = fma(w1.w_lower_arm_right_x, s7_234, w1.v_lower_arm_left_y);
  const double s9_130 = fma(w1.w_lower_arm_right_x, s7_232, w1.v_lower_arm_right_z);
  const double s9_131 = fnma(w1.w_chassis_z, s7_232, w1.v_lower_arm_right_x);
  const double s9_132 = fnma(w1.w_chassis_y, s7_234, s9_131);
  const double s9_133 = fnma(w1.w_chassis_x, s7_243, w1.v_arb_front_left_y);
  const double s9_134 = fma(w1.w_chassis_z, s7_245, s9_133);
  const double s9_135 = fma(w1.w_arb_front_left_y, s7_243, w1.v_arb_front_left_x);
  const double s9_136 = fnma(c_arb_front_left_y, w1.w_chassis_z, s9_135);
  const double s9_137 = fnma(w1.w_arb_front_left_y, s7_245, w1.v_arb_front_left_z);
  const double s9_138 = fma(c_arb_front_left_y, w1.w_chassis_x, s9_137);
  const double s9_139 = fnma(w1.w_upper_arm_left_x, s7_260, w1.v_upper_arm_left_y);
  const double s9_140 = fma(w1.w_upper_arm_left_x, s7_262, w1.v_upper_arm_left_z);
  const double s9_141 = fma(w1.w_chassis_y, s7_260, w1.v_upper_arm_left_x);
  const double s9_142 = fnma(w1.w_chassis_z, s7_262, s9_141);
  const double s9_143 = fnma(w1.w_carrier_left_x, s7_287, w1.v_carrier_left_aux1_y);
  const double s9_144 = fma(w1.w_carrier_left_z, s7_289, s9_143);
  const double s9_145 = fma(w1.w_carrier_left_x, s7_284, w1.v_carrier_left_aux1_z);
  const double s9_146 = fnma(w1.w_carrier_left_y, s7_289, s9_145);
  const double s9_147 = fnma(w1.w_carrier_left_z, s7_284, w1.v_carrier_left_aux1_x);
  const double s9_148 = fma(w1.w_carrier_left_y, s7_287, s9_147);
  const double s9_149 = fma(c_chassis_z, w1.w_chassis_y, w1.v_chassis_x);
  const double s9_150 = fnma(c_chassis_x, w1.w_chassis_y, w1.v_chassis_z);
  const double s9_151 = fnma(c_chassis_z, w1.w_chassis_x, w1.v_chassis_y);
  const double s9_152 = fma(c_chassis_x, w1.w_chassis_z, s9_151);
  const double s9_153 = fnma(w1.w_lower_arm_left_x, s7_306, w1.v_lower_arm_left_y);
  const double s9_154 = fma(w1.w_lower_arm_left_x, s7_308, w1.v_lower_arm_left_z);
  const double s9_155 = fma(w1.w_chassis_y, s7_306, w1.v_lower_arm_left_x);
  const double s9_156 = fnma(w1.w_chassis_z, s7_308, s9_155);
  const double s9_157 = fma(s9_94, s9_94, fma(s9_92, s9_92, fma(s9_90, s9_90, s9_88*s9_88)));
  const double s9_158 = fma(s9_114, s9_114, fma(s9_98, s9_98, fma(s9_96, s9_96, s9_157)));
  const double s9_159 = fma(s9_134, s9_134, fma(s9_118, s9_118, fma(s9_116, s9_116, s9_158)));
  const double s9_160 = fma(w1.w_rear_axle_x, s7_88, s9_32)*fma(w1.w_chassis_z, s7_90, s9_33);
  const double s9_161 = fnma(p_arb_link_rear_left_from_y, w1.w_chassis_x, s9_35);
  const double s9_162 = fma(fma(w1.w_rear_axle_y, s7_87, s9_34), s9_161, s9_160);
  const double s9_163 = fma(p_arb_link_rear_left_from_y, w1.w_chassis_z, s9_37);
  const double s9_164 = fma(fnma(w1.w_rear_axle_y, s7_88, s9_36), s9_163, s9_162);
  const double s9_165 = fma(w1.w_rear_axle_z, s7_78, s9_48);
  const double s9_166 = fma(p_arb_link_rear_left_from_y, w1.w_chassis_x, s9_51);
  const double s9_167 = fma(s9_165, fma(w1.w_chassis_z, s7_76, s9_49), s9_164);
  const double s9_168 = fnma(p_arb_link_rear_left_from_y, w1.w_chassis_z, s9_53);
  const double s9_169 = fma(fma(w1.w_rear_axle_x, s7_79, s9_50), s9_166, s9_167);
  const double s9_170 = fma(fnma(w1.w_rear_axle_z, s7_79, s9_52), s9_168, s9_169);
  const double s9_171 = fnma(w1.w_carrier_left_x, w2.s7_9, s9_75);
  const double s9_172 = fma(p_arb_link_front_left_from_y, w1.w_chassis_x, s9_78);
  const double s9_173 = fma(s9_171, fma(w1.w_chassis_z, w2.s7_4, s9_76), s9_170);
  const double s9_174 = fma(fma(w1.w_carrier_left_x, w2.s7_12, s9_77), s9_172, s9_173);
  const double s9_175 = fnma(p_arb_link_front_left_from_y, w1.w_chassis_z, s9_80);
  const double s9_176 = fma(fnma(w1.w_carrier_left_z, w2.s7_12, s9_79), s9_175, s9_174);
  const double s9_177 = fnma(w1.w_carrier_right_x, w2.s7_22, s9_82);
  const double s9_178 = fnma(p_arb_link_front_left_from_y, w1.w_chassis_x, s9_84);
  const double s9_179 = fma(fma(w1.w_chassis_z, w2.s7_16, s9_81), s9_177, s9_176);
  const double s9_180 = fma(fma(w1.w_carrier_right_x, w2.s7_25, s9_83), s9_178, s9_179);
  const double s9_181 = fma(p_arb_link_front_left_from_y, w1.w_chassis_z, s9_86);
  const double s9_182 = w1.v_wheel_rear_left_x*w1.v_wheel_rear_left_x;
  const double s9_183 = fma(w1.v_wheel_rear_left_y, w1.v_wheel_rear_left_y, s9_182);
  const double s9_184 = fma(w1.v_wheel_rear_left_z, w1.v_wheel_rear_left_z, s9_183);
  const double s9_185 = fma(w1.v_wheel_rear_right_x, w1.v_wheel_rear_right_x, s9_184);
  const double s9_186 = fma(w1.v_wheel_rear_right_y, w1.v_wheel_rear_right_y, s9_185);
  const double s9_187 = fma(s9_122, s9_122, fma(s9_120, s9_120, s9_119*s9_119));
  const double s9_188 = w1.v_wheel_front_left_x*w1.v_wheel_front_left_x;
  const double s9_189 = fma(w1.v_wheel_front_left_y, w1.v_wheel_front_left_y, s9_188);
  const double s9_190 = fma(w1.v_wheel_front_left_z, w1.v_wheel_front_left_z, s9_189);
  const double s9_191 = fma(w1.v_wheel_front_right_x, w1.v_wheel_front_right_x, s9_190);
  const double s9_192 = fma(w1.v_wheel_front_right_y, w1.v_wheel_front_right_y, s9_191);
  const double s9_193 = fma(s9_128, s9_128, fma(s9_126, s9_126, s9_124*s9_124));
  const double s9_194 = fma(s9_132, s9_132, fma(s9_130, s9_130, s9_129*s9_129));
  const double s9_195 = fma(w1.w_rear_axle_z, s7_84, s9_39);
  const double s9_196 = fma(p_diag_rod_left_from_z, w1.w_chassis_y, w1.s4_17);
  const double s9_197 = fnma(p_diag_rod_left_from_x, w1.w_chassis_y, w1.s4_18);
  const double s9_198 = s9_196*fnma(w1.w_rear_axle_z, s7_85, s9_40);
  const double s9_199 = fma(s9_197, fma(w1.w_rear_axle_x, s7_85, s9_41), s9_198);
  const double s9_200 = fnma(p_diag_rod_left_from_x, w1.w_chassis_y, w1.s4_6);
  const double s9_201 = fma(s9_200, fma(w1.w_rear_axle_x, s7_68, s9_55), s9_199);
  const double s9_202 = fma(p_diag_rod_left_from_z, w1.w_chassis_y, w1.s4_4);
  const double s9_203 = fma(fnma(w1.w_rear_axle_z, s7_68, s9_56), s9_202, s9_201);
  const double s9_204 = fma(p_diag_rod_left_from_x, w1.w_chassis_z, s9_38);
  const double s9_205 = fma(w1.w_rear_axle_z, s7_81, s9_43);
  const double s9_206 = fma(p_long_rod_left_from_y, w1.w_chassis_z, s9_44);
  const double s9_207 = fnma(p_long_rod_left_from_y, w1.w_chassis_x, s9_46);
  const double s9_208 = s9_206*fnma(w1.w_rear_axle_z, s7_82, s9_45);
  const double s9_209 = fma(s9_207, fma(w1.w_rear_axle_x, s7_82, s9_47), s9_208);
  const double s9_210 = fma(p_long_rod_left_from_y, w1.w_chassis_x, s9_46);
  const double s9_211 = fma(s9_210, fma(w1.w_rear_axle_x, s7_62, s9_58), s9_209);
  const double s9_212 = fnma(p_long_rod_left_from_y, w1.w_chassis_z, s9_44);
  const double s9_213 = fma(fnma(w1.w_rear_axle_z, s7_62, s9_59), s9_212, s9_211);
  const double s9_214 = fma(p_long_rod_left_from_y, w1.w_chassis_x, s9_42);
  const double s9_215 = fma(w1.w_bell_crank_z, w2.s7_44, w1.v_bell_crank_y);
  const double s9_216 = fma(w1.w_bell_crank_z, w2.s7_43, w1.v_bell_crank_x);
  const double s9_217 = s9_215*fnma(w1.w_carrier_right_x, w2.s7_50, s9_60);
  const double s9_218 = fma(s9_216, fnma(w1.w_carrier_right_z, s7_53, s9_61), s9_217);
  const double s9_219 = fma(w1.w_carrier_right_x, s7_53, s9_62);
  const double s9_220 = fma(s9_219, fnma(w1.w_chassis_y, w2.s7_44, s9_63), s9_218);
  const double s9_221 = fnma(w1.w_bell_crank_z, w2.s7_32, w1.v_bell_crank_y);
  const double s9_222 = fma(s9_221, fnma(w1.w_carrier_left_x, w2.s7_39, s9_64), s9_220);
  const double s9_223 = fnma(w1.w_bell_crank_z, w2.s7_33, w1.v_bell_crank_x);
  const double s9_224 = fma(s9_223, fnma(w1.w_carrier_left_z, w2.s7_42, s9_65), s9_222);
  const double s9_225 = fma(w1.w_carrier_left_x, w2.s7_42, s9_66);
  const double s9_226 = fma(s7_100, s7_101, fma(s7_94, s7_98, w2.w_arb_rear_right_y*s7_96));
  const double s9_227 = fma(s7_112, s7_113, fma(s7_104, s7_109, fma(s7_107, s7_108, s9_226)));
  const double s9_228 = fma(s7_117, s7_119, fma(w1.w_arb_rear_left_y, s7_118, s9_227));
  const double s9_229 = fma(s7_125, s7_130, fma(s7_128, s7_129, fma(s7_121, s7_122, s9_228)));
  const double s9_230 = fma(s7_143, s7_148, fma(s7_146, s7_147, fma(s7_133, s7_134, s9_229)));
  const double s9_231 = fma(w1.w_bell_crank_z, s7_156, fma(s7_151, s7_152, s9_230));
  const double s9_232 = fma(s7_157, s7_159, fma(s7_155, s7_158, s9_231));
  const double s9_233 = fma(s7_162, s7_164, fma(w1.w_pitman_arm_y, s7_163, s9_232));
  const double s9_234 = fma(w1.w_arb_front_right_y, s7_177, fma(s7_165, s7_166, s9_233));
  const double s9_235 = fma(s7_191, s7_192, fma(s7_174, s7_183, fma(s7_172, s7_180, s9_234)));
  const double s9_236 = fma(w1.w_upper_arm_right_x, s7_194, fma(s7_189, s7_193, s9_235));
  const double s9_237 = fma(s7_205, s7_206, fma(s7_197, s7_202, fma(s7_200, s7_201, s9_236)));
  const double s9_238 = fma(s7_224, s7_230, fma(s7_218, s7_228, fma(s7_221, s7_226, s9_237)));
  const double s9_239 = fma(s7_236, s7_240, fma(s7_238, s7_239, s9_238));
  const double s9_240 = fma(w1.w_lower_arm_right_x, s7_241, s9_239);
  const double s9_241 = fma(s7_247, s7_255, fma(w1.w_arb_front_left_y, s7_252, s9_240));
  const double s9_242 = fma(s7_264, s7_268, fma(s7_266, s7_267, fma(s7_249, s7_258, s9_241)));
  const double s9_243 = fma(s7_275, s7_276, fma(w1.w_upper_arm_left_x, s7_269, s9_242));
  const double s9_244 = fma(s7_295, s7_300, fma(s7_280, s7_281, fma(s7_272, s7_277, s9_243)));
  const double s9_245 = fma(s7_312, s7_313, fma(s7_298, s7_304, fma(s7_292, s7_302, s9_244)));
  const double s9_246 = fma(w1.w_lower_arm_left_x, s7_315, fma(s7_310, s7_314, s9_245));
  const double s9_247 = fma(w1.w_chassis_y, s7_317, fma(w1.w_chassis_z, s7_316, s9_246));
  const double s9_248 = fma(s9_74, fma(w1.w_chassis_x, w2.s7_29, s9_69), s9_73);
  const double s9_249 = fma(s9_104, s9_104, fma(s9_102, s9_102, s9_100*s9_100));
  const double s9_250 = fma(3.0, s9_248, fma(w1.w_chassis_x, s7_318, s9_247));
  const double s9_251 = fma(s9_108, s9_108, fma(s9_106, s9_106, s9_105*s9_105));
  const double s9_252 = fma(m_bell_crank_2, s9_251, fma(m_rear_axle_2, s9_249, s9_250));
  const double s9_253 = fma(s9_112, s9_112, fma(s9_110, s9_110, s9_109*s9_109));
  const double s9_254 = fma(s9_152, s9_152, fma(s9_150, s9_150, s9_149*s9_149));
  const double s9_255 = fma(m_chassis, s9_254, fma(m_pitman_arm_2, s9_253, s9_252));
  const double s9_256 = fma(s9_138, s9_138, fma(s9_136, s9_136, s9_159));
  const double s9_257 = fma(fnma(w1.w_carrier_right_z, w2.s7_25, s9_85), s9_181, s9_180);
  const double s9_258 = fma(0.6666666666666666, s9_257, fma(m_arb_rear_right_2, s9_256, s9_255));
  const double s9_259 = fma(w1.v_wheel_rear_right_z, w1.v_wheel_rear_right_z, s9_186);
  const double s9_260 = fma(s9_142, s9_142, fma(s9_140, s9_140, fma(s9_139, s9_139, s9_187)));
  const double s9_261 = fma(m_upper_arm_right, s9_260, fma(m_wheel_rear_right, s9_259, s9_258));
  const double s9_262 = fma(w1.v_wheel_front_right_z, w1.v_wheel_front_right_z, s9_192);
  const double s9_263 = fma(s9_148, s9_148, fma(s9_146, s9_146, fma(s9_144, s9_144, s9_193)));
  const double s9_264 = fma(m_carrier_right_2, s9_263, fma(m_wheel_front_right, s9_262, s9_261));
  const double s9_265 = fma(s9_156, s9_156, fma(s9_154, s9_154, fma(s9_153, s9_153, s9_194)));
  const double s9_266 = fma(s9_204, s9_195 + fma(w1.w_rear_axle_z, s7_66, s9_54), s9_203);
  const double s9_267 = fma(5.333333333333333, s9_266, fma(m_lower_arm_right, s9_265, s9_264));
  const double s9_268 = fma(s9_214, s9_205 + fma(w1.w_rear_axle_z, s7_59, s9_57), s9_213);
  const double s9_269 = fma(s9_225, fma(w1.w_chassis_x, w2.s7_33, s9_67), s9_224);
  result.kinetic_energy = 0.5*fma(2.3333333333333335, s9_269, fma(6.0, s9_268, s9_267));
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_270 = z_rear_axle_ty + z_rear_axle_ty;
  const double s9_271 = w1.r_carrier_right_aux1_y + (w1.r_carrier_left_aux1_y + s9_270);
  const double s9_272 = w1.r_carrier_left_aux1_y + w1.r_carrier_right_aux1_y;
  const double s9_273 = fma(m_bell_crank_2, s7_154, fma(1.5, w2.s7_29, 5.25));
  const double s9_274 = fma(m_rear_axle_2, z_rear_axle_ty + s7_136, s9_273);
  const double s9_275 = s7_79 + (w2.s7_25 + (w2.s7_12 + s9_271)) - s7_86;
  const double s9_276 = s7_53 + (w2.s7_42 + (w2.s7_33 + s9_272) - w2.s7_43);
  const double s9_277 = fma(1.1666666666666667, s9_276, fma(0.3333333333333333, s9_275, s9_274));
  const double s9_278 = fma(3.0, s7_82 + (s7_62 + s9_270), s9_277);
  const double s9_279 = fma(2.6666666666666665, s7_85 + (s7_68 + s9_270), s9_278);
  const double s9_280 = fma(m_wheel_rear_right, s9_270, s9_279);
  const double s9_281 = w1.r_wheel_front_left_y + w1.r_wheel_front_right_y;
  const double s9_282 = fma(m_upper_arm_right, s7_185 + s7_262, s9_280);
  const double s9_283 = fma(m_wheel_front_right, s9_281, s9_282);
  const double s9_284 = fma(m_carrier_right_2, s7_284 + (s7_209 + s9_272), s9_283);
  const double s9_285 = w2.s7_4 + (w1.r_rear_axle_aux1_x + (8.5 + w1.r_rear_axle_aux1_x));
  const double s9_286 = s7_78 + (s7_76 + (w2.s7_19 + (w2.s7_16 + (w2.s7_6 + s9_285)))) - s7_87;
  const double s9_287 = w1.r_rear_axle_aux1_x + w1.r_rear_axle_aux1_x;
  const double s9_288 = fma(m_rear_axle_2, w1.r_rear_axle_aux1_x + s7_140, 232.0);
  const double s9_289 = fma(m_bell_crank_2, p_bell_crank_x - s7_153, s9_288);
  const double s9_290 = fma(m_pitman_arm_2, p_pitman_arm_x - s7_160, s9_289);
  const double s9_291 = w2.s7_47 + (w2.s7_44 + (w2.s7_36 + (13.7 - w2.s7_32)));
  const double s9_292 = fma(0.3333333333333333, s7_90 + s9_286, s9_290);
  const double s9_293 = s7_245 + (s7_170 + (s7_115 + (1.3 + s7_92)));
  const double s9_294 = fma(m_arb_rear_right_2, s9_293, fma(1.1666666666666667, s9_291, s9_292));
  const double s9_295 = fma(1.5, 7.65 - w2.s7_26 - w2.s7_28, s9_294);
  const double s9_296 = fma(3.0, s7_81 + (s7_59 + s9_287), s9_295);
  const double s9_297 = fma(2.6666666666666665, s7_84 + (s7_66 + s9_287), s9_296);
  const double s9_298 = w1.r_wheel_front_left_x + w1.r_wheel_front_right_x;
  const double s9_299 = fma(m_wheel_rear_right, s9_287, s9_297);
  const double s9_300 = fma(m_wheel_front_right, s9_298, s9_299);
  const double s9_301 = w1.r_rear_axle_aux3_z + (w1.r_carrier_left_aux1_z - 1.9 - w1.s1_39);
  const double s9_302 = w2.s7_14 + (w2.s7_9 + (w2.s7_2 + (w1.r_rear_axle_aux3_z + s9_301)));
  const double s9_303 = w1.r_carrier_left_aux1_z - w1.s1_39;
  const double s9_304 = w1.r_rear_axle_aux3_z + w1.r_rear_axle_aux3_z;
  const double s9_305 = fnma(1.5, w2.s7_27 - p_pitman_arm_z, 3350.4);
  const double s9_306 = fnma(m_pitman_arm_2, s7_161 - p_pitman_arm_z, s9_305);
  const double s9_307 = fma(m_rear_axle_2, w1.r_rear_axle_aux3_z + s7_138, s9_306);
  const double s9_308 = s7_77 + (w2.s7_22 + s9_302 - s7_69) - s7_88 - s7_89;
  const double s9_309 = s7_243 + (s7_168 - (s7_114 + (1.9 + s7_91)));
  const double s9_310 = fma(m_arb_rear_right_2, s9_309, fma(0.3333333333333333, s9_308, s9_307));
  const double s9_311 = fma(1.1666666666666667, w2.s7_50 + (w2.s7_39 + s9_303), s9_310);
  const double s9_312 = fma(3.0, s7_80 + (s7_56 + s9_304), s9_311);
  const double s9_313 = fma(2.6666666666666665, s7_83 + (s7_64 + s9_304), s9_312);
  const double s9_314 = fma(m_wheel_rear_right, s9_304, s9_313);
  const double s9_315 = fma(m_upper_arm_right, s7_260 - (0.56 + s7_187), s9_314);
  const double s9_316 = w1.r_wheel_front_left_z + w1.r_wheel_front_right_z;
  const double s9_317 = fma(m_wheel_front_right, s9_316, s9_315);
  const double s9_318 = fma(m_carrier_right_2, s7_287 + (s7_212 + s9_303), s9_317);
  const double s9_319 = fma(m_lower_arm_right, s7_232 + s7_308, s9_284);
  const double s9_320 = fma(w1.R_chassis_z_y, s9_319, 15306.0*w1.r_chassis_aux3_z);
  const double s9_321 = fma(m_carrier_right_2, s7_289 + (7.2 + s7_215), s9_300);
  const double s9_322 = fma(m_lower_arm_right, s7_306 - (1.24 + s7_234), s9_318);
  const double s9_323 = fma(w1.R_chassis_z_z, s9_322, fma(w1.R_chassis_z_x, s9_321, s9_320));
  result.potential_energy = -g_z*s9_323;
  // operations: 482 add, 413 multiply
}

/// Outputs, energies and power, at given accelerations.
void compute_outputs(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    const double* tau, const Derivative& /*derivative*/, Outputs& __restrict result) noexcept {
  OutputsWork1 w1;
  OutputsWork2 w2;
  OutputsWork3 w3;
  compute_outputs_1(state, w1, w2, w3);
  compute_outputs_2(state, tau, w1, w2, w3, result);
}
#endif  // part 1

}  // namespace

#if MBGEN_IS_PART(0)
namespace {

/// Sizes, tables and programs of this model for the runtime's algorithms; see mbgen/solver.hpp.
struct System {
  using Parameters = coach_mechanism::Tuned;
  using Inputs = coach_mechanism::Inputs;
  using State = coach_mechanism::State;
  using Derivative = coach_mechanism::Derivative;
  using Multipliers = coach_mechanism::Multipliers;
  static constexpr int kCoordinates = 32;
  static constexpr int kAuxiliaryStates = 0;
  static constexpr int kBlocks = 2;
  static constexpr int kEquations = 17;
  static constexpr int kFreeDirections = 15;
  static constexpr bool kHasClosure = true;
  static constexpr int kDrives = 0;
  static constexpr double kClosureTolerance = 1e-12;
  static constexpr int kBalls = 4;
  static constexpr mbgen::Ball kBall[] = {
      {{3, 4, 5}, -1}, {{7, 8, 9}, 1}, {{14, 15, 16}, 1}, {{25, 26, 27}, -1}};
  static constexpr int kBlockCoordinates = 22;
  static constexpr mbgen::FreeDirection kFreeDirection[] = {
      {0, -1, 0}, {1, -1, 0}, {2, -1, 0}, {3, -1, 0}, {4, -1, 0}, {5, -1, 0}, {6, 0, 0}, {13, 0, 1},
      {21, 0, 2}, {10, -1, 0}, {17, -1, 0}, {24, 1, 0}, {27, 1, 1}, {28, -1, 0}, {30, -1, 0}};
  static constexpr double Parameters::*kParameterMember[] = {nullptr};
  static constexpr double Inputs::*kInputMember[] = {nullptr};
  static constexpr unsigned char kDriven[] = {
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  static constexpr unsigned char kRedundant[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  static constexpr int kDriveCoordinate[] = {0};
  static constexpr mbgen::BlockLayout kBlockLayout[] = {
      {11, 14, 11, 3, 0, 0, 0, 0, 0.17}, {6, 8, 6, 2, 11, 14, 154, 42, 0.38}};
  static constexpr int kBlockCoordinate[] = {
      6, 7, 8, 9, 11, 12, 13, 14, 15, 16, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 29, 31};
  static constexpr unsigned char kBlockDriven[] = {
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  static constexpr int kMultiplierPlace[] = {
      0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  using Accelerations = coach_mechanism::Accelerations;
  static constexpr auto accelerations = &compute_accelerations;
  using Closure = coach_mechanism::Closure;
  static constexpr auto closure = &compute_closure;
  using ConstraintForces = coach_mechanism::ConstraintForces;
  static constexpr auto multipliers = &compute_multipliers;
  using ClosureTerms = coach_mechanism::ClosureTerms;
  static constexpr auto closure_terms = &compute_closure_terms;
  using ChosenAccelerations = coach_mechanism::ChosenAccelerations;
  static constexpr auto chosen_accelerations = &compute_chosen_accelerations;
  using Projection = coach_mechanism::Projection;
  static double argument_sum(const Parameters& /*parameters*/, const Inputs& /*inputs*/) noexcept {
    return 0.0;
  }
};

}  // namespace

State initial_state() noexcept {
  static constexpr State start = {
      {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
       0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
      {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
       0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
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

bool Dynamics::leaves_charts(const State& state) const noexcept {
  return mbgen::any_leaves_chart(System::kBall, System::kBalls, state.charts, state.z);
}

bool Dynamics::settle_charts(State& state) const noexcept {
  return mbgen::settle_balls(System::kBall, System::kBalls, state.charts, state.z, state.zd);
}

void Dynamics::change_charts(const State& from, const State& to, double (&z)[kCoordinates],
                             double (&zd)[kCoordinates], double (&zdd)[kCoordinates]) const noexcept {
  mbgen::change_charts(System::kBall, System::kBalls, from.charts, to.charts, z, zd, zdd);
}

State in_users_angles(const State& state) noexcept {
  Derivative none{};
  return in_users_angles(state, none);
}

State in_users_angles(const State& state, Derivative& derivative) noexcept {
  State users;
  mbgen::integrator_detail::copy_state(state, users);
  mbgen::to_users_angles(System::kBall, System::kBalls, users.charts, users.z, users.zd, derivative.zdd);
  for (auto& chart : users.charts) chart = 0;
  return users;
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
constexpr double kTurning[] = {
    0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0,
    1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 1.0, 0.0, 1.0};

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

#endif  // part 0
}  // namespace coach_mechanism
