// coach_mechanism, content hash 736a3d9dded7669b
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

#include "coach_mechanism.hpp"

#include "mbgen/elementary.hpp"
#include "mbgen/fma.hpp"
#include "mbgen/motion.hpp"
#include "mbgen/scalar.hpp"
#include "mbgen/solver.hpp"

#include <cmath>

// Compiled with -DMBGEN_PART=0 this file is what runs at every step, with 1 to 1 programs that run rarely; the
// 2 objects together are the solver. Compiled without MBGEN_PART it is the whole solver.
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

namespace {

// Numbers of the model.
constexpr double g_z = -9.81;
constexpr double m_chassis = 13522.666666666668;
constexpr double c_chassis_x = -0.0027607966870439754;
constexpr double c_chassis_z = 0.24897456123052653;
constexpr double I_chassis_xx = 15014.70911391573;
constexpr double I_chassis_yy = 150070.8160441727;
constexpr double I_chassis_zz = 145066.78026359034;
constexpr double I_chassis_xz = -22.575050285939653;
constexpr double m_lower_arm_left = 25.0;
constexpr double c_lower_arm_left_y = 0.22;
constexpr double c_lower_arm_left_z = -0.025;
constexpr double I_lower_arm_left_xx = 0.6;
constexpr double I_lower_arm_left_yy = 0.25;
constexpr double I_lower_arm_left_zz = 0.8;
constexpr double m_carrier_left = 113.0;
constexpr double c_carrier_left_x = -0.003952802359882006;
constexpr double c_carrier_left_y = 0.07666666666666667;
constexpr double c_carrier_left_z = 0.16710914454277287;
constexpr double I_carrier_left_xx = 3.081700098328417;
constexpr double I_carrier_left_yy = 2.6532900688298917;
constexpr double I_carrier_left_zz = 3.1640788593903637;
constexpr double I_carrier_left_xy = -0.057911111111111115;
constexpr double I_carrier_left_xz = -0.04070875122910522;
constexpr double I_carrier_left_yz = -0.039511111111111115;
constexpr double m_wheel_front_left = 105.0;
constexpr double I_wheel_front_left_xx = 6.0;
constexpr double I_wheel_front_left_yy = 11.0;
constexpr double I_wheel_front_left_zz = 6.0;
constexpr double m_upper_arm_left = 15.0;
constexpr double c_upper_arm_left_y = 0.15;
constexpr double c_upper_arm_left_z = -0.01;
constexpr double I_upper_arm_left_xx = 0.2;
constexpr double I_upper_arm_left_yy = 0.1;
constexpr double I_upper_arm_left_zz = 0.25;
constexpr double m_arb_front_left = 8.666666666666666;
constexpr double c_arb_front_left_x = -0.13923076923076924;
constexpr double c_arb_front_left_y = -0.007521367521367457;
constexpr double c_arb_front_left_z = 0.05384615384615385;
constexpr double I_arb_front_left_xx = 0.18132307692307692;
constexpr double I_arb_front_left_yy = 0.1304;
constexpr double I_arb_front_left_zz = 0.23864615384615384;
constexpr double I_arb_front_left_xy = 0.016246153846153848;
constexpr double I_arb_front_left_xz = 0.0036923076923076927;
constexpr double I_arb_front_left_yz = -0.00676923076923077;
constexpr double m_lower_arm_right = 25.0;
constexpr double c_lower_arm_right_y = -0.22;
constexpr double c_lower_arm_right_z = -0.025;
constexpr double I_lower_arm_right_xx = 0.6;
constexpr double I_lower_arm_right_yy = 0.25;
constexpr double I_lower_arm_right_zz = 0.8;
constexpr double m_carrier_right = 113.0;
constexpr double c_carrier_right_x = -0.003952802359882006;
constexpr double c_carrier_right_y = -0.07666666666666667;
constexpr double c_carrier_right_z = 0.16710914454277287;
constexpr double I_carrier_right_xx = 3.081700098328417;
constexpr double I_carrier_right_yy = 2.6532900688298917;
constexpr double I_carrier_right_zz = 3.1640788593903637;
constexpr double I_carrier_right_xy = 0.057911111111111115;
constexpr double I_carrier_right_xz = -0.04070875122910522;
constexpr double I_carrier_right_yz = 0.039511111111111115;
constexpr double m_wheel_front_right = 105.0;
constexpr double I_wheel_front_right_xx = 6.0;
constexpr double I_wheel_front_right_yy = 11.0;
constexpr double I_wheel_front_right_zz = 6.0;
constexpr double m_upper_arm_right = 15.0;
constexpr double c_upper_arm_right_y = -0.15;
constexpr double c_upper_arm_right_z = -0.01;
constexpr double I_upper_arm_right_xx = 0.2;
constexpr double I_upper_arm_right_yy = 0.1;
constexpr double I_upper_arm_right_zz = 0.25;
constexpr double m_arb_front_right = 8.666666666666666;
constexpr double c_arb_front_right_x = -0.13923076923076924;
constexpr double c_arb_front_right_y = 0.007521367521367457;
constexpr double c_arb_front_right_z = 0.05384615384615385;
constexpr double I_arb_front_right_xx = 0.18132307692307692;
constexpr double I_arb_front_right_yy = 0.1304;
constexpr double I_arb_front_right_zz = 0.23864615384615384;
constexpr double I_arb_front_right_xy = -0.016246153846153848;
constexpr double I_arb_front_right_xz = 0.0036923076923076927;
constexpr double I_arb_front_right_yz = 0.00676923076923077;
constexpr double m_pitman_arm = 9.0;
constexpr double c_pitman_arm_z = -0.14666666666666667;
constexpr double I_pitman_arm_xx = 0.0742;
constexpr double I_pitman_arm_yy = 0.0842;
constexpr double I_pitman_arm_zz = 0.03;
constexpr double m_bell_crank = 16.666666666666668;
constexpr double c_bell_crank_x = -0.0938;
constexpr double c_bell_crank_y = 0.0972;
constexpr double I_bell_crank_xx = 0.28000266666666673;
constexpr double I_bell_crank_yy = 0.144126;
constexpr double I_bell_crank_zz = 0.4041286666666667;
constexpr double I_bell_crank_xy = -0.101556;
constexpr double m_rear_axle = 774.0;
constexpr double c_rear_axle_x = 0.0001722652885443584;
constexpr double c_rear_axle_z = 0.0019465977605512485;
constexpr double I_rear_axle_xx = 264.98720045937415;
constexpr double I_rear_axle_yy = 45.96384415733562;
constexpr double I_rear_axle_zz = 264.4099770312949;
constexpr double I_rear_axle_xz = -0.021740453631926497;
constexpr double m_wheel_rear_left = 200.0;
constexpr double I_wheel_rear_left_xx = 14.0;
constexpr double I_wheel_rear_left_yy = 22.0;
constexpr double I_wheel_rear_left_zz = 14.0;
constexpr double m_arb_rear_left = 8.666666666666666;
constexpr double c_arb_rear_left_x = 0.16538461538461538;
constexpr double c_arb_rear_left_y = -0.003418803418803379;
constexpr double I_arb_rear_left_xx = 0.15615384615384614;
constexpr double I_arb_rear_left_yy = 0.14461538461538462;
constexpr double I_arb_rear_left_zz = 0.23076923076923078;
constexpr double I_arb_rear_left_xy = -0.01230769230769231;
constexpr double m_wheel_rear_right = 200.0;
constexpr double I_wheel_rear_right_xx = 14.0;
constexpr double I_wheel_rear_right_yy = 22.0;
constexpr double I_wheel_rear_right_zz = 14.0;
constexpr double m_arb_rear_right = 8.666666666666666;
constexpr double c_arb_rear_right_x = 0.16538461538461538;
constexpr double c_arb_rear_right_y = 0.003418803418803379;
constexpr double I_arb_rear_right_xx = 0.15615384615384614;
constexpr double I_arb_rear_right_yy = 0.14461538461538462;
constexpr double I_arb_rear_right_zz = 0.23076923076923078;
constexpr double I_arb_rear_right_xy = 0.01230769230769231;
constexpr double p_arb_link_front_left_from_x = -0.25;
constexpr double p_arb_link_front_left_from_y = 0.1955555555555556;
constexpr double p_arb_link_front_left_from_z = 0.1;
constexpr double p_arb_link_front_left_to_x = 0.1;
constexpr double p_arb_link_front_left_to_y = -0.03;
constexpr double l_arb_link_front_left = 0.26;
constexpr double p_arb_link_front_right_from_x = -0.25;
constexpr double p_arb_link_front_right_from_y = -0.1955555555555556;
constexpr double p_arb_link_front_right_from_z = 0.1;
constexpr double p_arb_link_front_right_to_x = 0.1;
constexpr double l_arb_link_front_right = 0.26;
constexpr double p_drag_link_from_z = -0.22;
constexpr double p_drag_link_to_y = 0.3;
constexpr double l_drag_link = 1.167433081593973;
constexpr double p_tie_rod_left_from_x = -0.2;
constexpr double p_tie_rod_left_from_y = 0.08;
constexpr double p_tie_rod_left_to_x = -0.22;
constexpr double p_tie_rod_left_to_y = -0.05;
constexpr double p_tie_rod_left_to_z = 0.07;
constexpr double l_tie_rod_left = 0.7920227269466451;
constexpr double p_tie_rod_right_to_x = -0.22;
constexpr double p_tie_rod_right_to_y = 0.05;
constexpr double p_tie_rod_right_to_z = 0.07;
constexpr double l_tie_rod_right = 0.7920227269466451;
constexpr double p_long_rod_left_from_x = -1.6;
constexpr double p_long_rod_left_from_y = 0.55;
constexpr double p_long_rod_left_from_z = -0.55;
constexpr double p_long_rod_left_to_x = 0.05;
constexpr double p_long_rod_left_to_y = 0.55;
constexpr double p_long_rod_left_to_z = -0.08;
constexpr double l_long_rod_left = 0.8505292469985968;
constexpr double p_diag_rod_left_from_x = -1.7;
constexpr double p_diag_rod_left_from_y = 0.4;
constexpr double p_diag_rod_left_from_z = -0.15;
constexpr double p_diag_rod_left_to_y = 0.1;
constexpr double p_diag_rod_left_to_z = 0.25;
constexpr double l_diag_rod_left = 0.8602325267042626;
constexpr double p_arb_link_rear_left_from_x = 0.35;
constexpr double p_arb_link_rear_left_from_y = 0.0888888888888889;
constexpr double p_arb_link_rear_left_to_x = -0.35;
constexpr double p_arb_link_rear_left_to_y = 0.6;
constexpr double p_arb_link_rear_left_to_z = -0.15;
constexpr double l_arb_link_rear_left = 0.22360679774997896;
constexpr double p_long_rod_right_from_y = -0.55;
constexpr double l_long_rod_right = 0.8505292469985968;
constexpr double p_diag_rod_right_from_y = -0.4;
constexpr double l_diag_rod_right = 0.8602325267042626;
constexpr double p_arb_link_rear_right_from_x = 0.35;
constexpr double p_arb_link_rear_right_from_y = -0.0888888888888889;
constexpr double l_arb_link_rear_right = 0.22360679774997896;
constexpr double p_lower_arm_left_x = 3.6;
constexpr double p_lower_arm_left_y = 0.4;
constexpr double p_lower_arm_left_z = -0.62;
constexpr double p_carrier_left_rz_y = 0.45;
constexpr double p_carrier_left_rz_z = -0.05;
constexpr double p_wheel_front_left_y = 0.175;
constexpr double p_wheel_front_left_z = 0.17;
constexpr double p_upper_arm_left_y = 0.5;
constexpr double p_upper_arm_left_z = -0.28;
constexpr double p_arb_front_left_x = 3.95;
constexpr double p_arb_front_left_y = 0.5244444444444444;
constexpr double p_arb_front_left_z = -0.5;
constexpr double p_lower_arm_right_x = 3.6;
constexpr double p_lower_arm_right_y = -0.4;
constexpr double p_lower_arm_right_z = -0.62;
constexpr double p_carrier_right_rz_y = -0.45;
constexpr double p_carrier_right_rz_z = -0.05;
constexpr double p_wheel_front_right_y = -0.175;
constexpr double p_wheel_front_right_z = 0.17;
constexpr double p_upper_arm_right_x = 3.6;
constexpr double p_upper_arm_right_y = -0.5;
constexpr double p_upper_arm_right_z = -0.28;
constexpr double p_arb_front_right_x = 3.95;
constexpr double p_arb_front_right_y = -0.5244444444444444;
constexpr double p_arb_front_right_z = -0.5;
constexpr double p_pitman_arm_x = 4.4;
constexpr double p_pitman_arm_y = 0.5;
constexpr double p_pitman_arm_z = -0.4;
constexpr double p_bell_crank_x = 3.25;
constexpr double p_bell_crank_z = -0.6;
constexpr double p_rear_axle_tx_x = -2.5;
constexpr double p_rear_axle_tx_z = -0.5;
constexpr double p_wheel_rear_left_y = 0.93;
constexpr double p_arb_rear_left_x = -3.3;
constexpr double p_arb_rear_left_y = 0.5111111111111111;
constexpr double p_arb_rear_left_z = -0.45;
constexpr double p_arb_rear_right_x = -3.3;
constexpr double p_arb_rear_right_y = -0.5111111111111111;
constexpr double p_arb_rear_right_z = -0.45;
constexpr double h_lower_arm_left_y = 5.5;
constexpr double h_lower_arm_left_z = -0.625;
constexpr double K_lower_arm_left_yy = 1.785;
constexpr double K_lower_arm_left_zz = 0.040625;
constexpr double K_lower_arm_left_yz = -0.1375;
constexpr double m_carrier_left_2 = 219.5;
constexpr double h_carrier_left_x = -0.67;
constexpr double h_carrier_left_y = 26.97;
constexpr double h_carrier_left_z = 36.825;
constexpr double K_carrier_left_xx = 1.4294;
constexpr double K_carrier_left_yy = 11.679275;
constexpr double K_carrier_left_zz = 7.48155;
constexpr double K_carrier_left_xy = 0.0355;
constexpr double K_carrier_left_xz = -0.0509;
constexpr double K_carrier_left_yz = 4.6066;
constexpr double K_carrier_left_trace = 20.590225;
constexpr double I_wheel_front_left_polar = 11.0;
constexpr double h_upper_arm_left_y = 2.25;
constexpr double h_upper_arm_left_z = -0.15;
constexpr double K_upper_arm_left_yy = 0.5125;
constexpr double K_upper_arm_left_zz = 0.0265;
constexpr double K_upper_arm_left_yz = -0.0225;
constexpr double h_arb_front_left_x = -1.29;
constexpr double h_arb_front_left_z = 0.5;
constexpr double K_arb_front_left_xx = 0.2827;
constexpr double K_arb_front_left_zz = 0.065;
constexpr double K_arb_front_left_xy = -0.023466666666666747;
constexpr double K_arb_front_left_xz = -0.077;
constexpr double K_arb_front_left_yz = 0.00977777777777781;
constexpr double h_lower_arm_right_y = -5.5;
constexpr double h_lower_arm_right_z = -0.625;
constexpr double K_lower_arm_right_yy = 1.785;
constexpr double K_lower_arm_right_zz = 0.040625;
constexpr double K_lower_arm_right_yz = 0.1375;
constexpr double m_carrier_right_2 = 219.5;
constexpr double h_carrier_right_x = -0.67;
constexpr double h_carrier_right_y = -26.97;
constexpr double h_carrier_right_z = 36.825;
constexpr double K_carrier_right_xx = 1.4294;
constexpr double K_carrier_right_yy = 11.679275;
constexpr double K_carrier_right_zz = 7.48155;
constexpr double K_carrier_right_xy = -0.0355;
constexpr double K_carrier_right_xz = -0.0509;
constexpr double K_carrier_right_yz = -4.6066;
constexpr double K_carrier_right_trace = 20.590225;
constexpr double I_wheel_front_right_polar = 11.0;
constexpr double h_upper_arm_right_y = -2.25;
constexpr double h_upper_arm_right_z = -0.15;
constexpr double K_upper_arm_right_yy = 0.5125;
constexpr double K_upper_arm_right_zz = 0.0265;
constexpr double K_upper_arm_right_yz = 0.0225;
constexpr double h_arb_front_right_x = -1.29;
constexpr double h_arb_front_right_z = 0.5;
constexpr double K_arb_front_right_xx = 0.2827;
constexpr double K_arb_front_right_zz = 0.065;
constexpr double K_arb_front_right_xy = 0.023466666666666747;
constexpr double K_arb_front_right_xz = -0.077;
constexpr double K_arb_front_right_yz = -0.00977777777777781;
constexpr double h_pitman_arm_z = -1.65;
constexpr double K_pitman_arm_xx = 0.02;
constexpr double K_pitman_arm_zz = 0.3304;
constexpr double h_bell_crank_x = -2.03;
constexpr double h_bell_crank_y = 2.07;
constexpr double K_bell_crank_xx = 0.3741;
constexpr double K_bell_crank_yy = 0.5774;
constexpr double K_bell_crank_xy = -0.0504;
constexpr double m_rear_axle_2 = 1186.0;
constexpr double h_rear_axle_x = 0.2;
constexpr double h_rear_axle_z = 2.26;
constexpr double K_rear_axle_xx = 22.79;
constexpr double K_rear_axle_yy = 617.785;
constexpr double K_rear_axle_zz = 23.6602;
constexpr double K_rear_axle_xz = 0.033;
constexpr double K_rear_axle_trace = 664.2352;
constexpr double I_wheel_rear_left_polar = 22.0;
constexpr double h_arb_rear_left_x = 1.55;
constexpr double K_arb_rear_left_xx = 0.3875;
constexpr double K_arb_rear_left_zz = 0.035;
constexpr double K_arb_rear_left_xy = 0.017777777777777837;
constexpr double I_wheel_rear_right_polar = 22.0;
constexpr double h_arb_rear_right_x = 1.55;
constexpr double K_arb_rear_right_xx = 0.3875;
constexpr double K_arb_rear_right_zz = 0.035;
constexpr double K_arb_rear_right_xy = -0.017777777777777837;
constexpr double p_carrier_left_upper_ball_y = -0.05;
constexpr double p_carrier_left_upper_ball_z = 0.37;
constexpr double p_upper_arm_left_ball_y = 0.3;
constexpr double p_upper_arm_left_ball_z = -0.02;
constexpr double p_carrier_right_upper_ball_y = 0.05;
constexpr double p_carrier_right_upper_ball_z = 0.37;
constexpr double p_upper_arm_right_ball_y = -0.3;
constexpr double p_upper_arm_right_ball_z = -0.02;

#if MBGEN_IS_PART(0)

/// Result of compute_accelerations.
struct Accelerations {
  double zdd[32];  ///< accelerations
  double xd[1];  ///< rates of the auxiliary states
  double pivot[2];  ///< smallest pivot of each block over its reference
  double inertia[15];  ///< pivots of the final equations
};

/// Values of compute_accelerations that cross its parts.
struct AccelerationsWork {
  double
      sines[22], cosines[22], R_rear_axle_aux5_x_z, R_rear_axle_x_y, R_rear_axle_aux5_y_z,
      R_rear_axle_y_y, R_rear_axle_z_y, s4_1, s4_2, s4_3, s2_7, s2_8, s2_9, s2_10, s4_6, s4_7, s4_8,
      s2_11, s2_12, s2_13, s2_14, s2_15, s2_16, s2_22, s2_23, s2_24, s2_26, s2_27, s2_28, s2_30,
      s2_31, r_rear_axle_aux1_x, s2_33, pivot_rear_axle_tx, s2_35, s2_36, r_rear_axle_aux3_z, s2_38,
      s2_39, s2_40, s2_41, s2_42, s2_43, s2_44, s2_47, s2_48, s2_49, s2_51, s2_52, s2_55, s2_57,
      s2_60, s2_61, s2_62, s2_64, s2_65, s2_67, s2_69, s2_71, s2_72, s2_73, s2_74, s2_80, s2_84,
      s2_86, s2_87, s2_89, s2_90, s2_91, s2_92, s2_102, s2_104, s2_105, s2_106, s2_107, s7_6, s7_8,
      s7_9, s7_16, s7_18, s7_19, s7_21, s7_22, s1_5, R_chassis_z_y, w_chassis_x, w_chassis_y,
      R_chassis_z_z, w_chassis_z, s9_1, s9_2, s9_3, s2_118, s2_119, s2_121, s2_122,
      zdd_star_rear_axle_tz, s2_123, zdd_star_rear_axle_rz, zdd_star_rear_axle_ry,
      zdd_star_rear_axle_rx, s6_88, zdd_star_rear_axle_tx, s8_40, s8_41, s8_42, s8_43, s8_44, s8_45,
      s8_57, s8_64, s8_69, s8_77, s8_87, s8_88, s8_89, s8_90, s8_92, s8_93, s8_94, s8_114, s8_132,
      s8_133, s8_135, s8_136, s8_138, s8_140, s8_141, s8_142, s8_143, s8_144, s8_145, s8_146, s7_23,
      s7_24, n_rear_axle_x, f_rear_axle_z, n_rear_axle_y, f_rear_axle_y, f_rear_axle_x,
      n_rear_axle_z, R_carrier_left_aux1_y_x, R_carrier_left_y_x, R_carrier_left_y_z,
      R_carrier_right_aux1_y_x, R_carrier_right_y_x, R_carrier_right_y_z, R_carrier_left_aux2_y_y,
      R_carrier_left_aux2_z_y, R_carrier_left_aux2_z_z, R_carrier_left_aux1_z_x, s1_21, s1_28,
      s1_29, s1_30, s1_31, s1_32, s9_4, s1_35, R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y,
      R_carrier_right_aux2_z_z, R_carrier_right_aux1_z_x, s1_37, s1_44, s1_45, s1_46, s1_47, s1_48,
      s9_5, s1_51, s3_1, Rz_rear_axle_tz_1, s3_2, Rz_rear_axle_rz_0, Rz_rear_axle_ry_0,
      Rz_rear_axle_ry_1, Rz_rear_axle_rx_0, Rz_rear_axle_rx_1, s3_9, s3_12, Rz_rear_axle_tx_0,
      Rz_rear_axle_tx_1, s7_28, s7_32, s8_265, pivot_arb_rear_right, s7_35, s7_36, s8_306, s8_318,
      s7_39, s7_40, s8_336, s8_347, s8_353, s8_357, s8_358, s1_54, s1_56, s1_57, s8_364, s8_378,
      s1_58, s1_59, s1_60, s1_61, s9_6, s8_383, s8_391, s8_392, s8_393, s7_41, s8_396, s7_42,
      s8_399, s8_407, s8_451, s2_128, s8_462, s8_464, s8_466, s8_468, s8_469, s8_472, s8_474,
      s8_476, s8_478, s8_479, s8_480, s8_481, s8_482, s8_484, s8_493, s8_494, s8_495, s8_505, s1_63,
      s1_64, s1_65, s1_66, s1_67, s8_519, s8_520, s8_522, s8_523, s8_524, s8_525, s8_526, s8_527,
      pivot_arb_rear_left, s8_531, s8_532, s8_533, R_carrier_left_x_x, R_carrier_left_x_z, s2_131,
      R_carrier_left_z_x, R_carrier_left_z_z, s2_134, s2_137, R_carrier_right_x_x,
      R_carrier_right_x_z, s2_140, R_carrier_right_z_x, R_carrier_right_z_z, s2_143, s2_146, s1_73,
      s2_148, s4_14, s4_15, s4_16, s4_17, s4_18, s4_19, s4_20, s4_21, s4_22, s4_23, s4_24, s4_25,
      s4_26, s4_27, s4_28, s6_93, s6_94, s6_97, s6_98, s1_75, s2_150, s6_99, s8_534, s6_101, s6_103,
      s1_77, s2_152, s4_29, s4_30, s4_31, s4_32, s4_33, s4_34, s4_35, s4_36, s4_37, s4_38, s4_39,
      s4_40, s4_41, s4_42, s4_43, s6_107, s6_109, s6_112, s6_113, s1_79, s2_154, s6_114, s8_535,
      s6_116, s6_118, s2_157, s2_160, s2_164, s6_122, s2_168, s6_124, s6_126, s4_44, s6_127, s2_171,
      s6_129, s6_130, s6_131, s2_174, pivot_carrier_right_rx, s2_177, s2_178, s2_181, s2_182,
      s6_135, s6_137, s6_139, s6_141, s6_142, s4_45, s6_143, s6_144, r_carrier_left_aux1_z, s2_189,
      r_carrier_left_aux1_y, s2_190, s2_191, s2_201, s2_205, s2_208, Rz_upper_arm_left_0,
      Rz_upper_arm_left_2, s6_159, s2_210, s3_20, Rz_carrier_left_rz_2, zdd_star_carrier_left_rz,
      s3_21, s3_22, zdd_star_carrier_left_ry, s8_537, zdd_star_carrier_left_rx, s3_23, s3_24,
      s8_538, s2_211, s2_213, s2_214, s2_219, Rz_arb_front_left_0, Rz_arb_front_left_2,
      zdd_star_arb_front_left, s1_80, s2_226, r_carrier_right_aux1_y, s2_227, s2_228, s3_28, s3_29,
      s6_179, s3_30, Rz_carrier_right_rz_2, zdd_star_carrier_right_rz, Rz_carrier_right_ry_1,
      Rz_carrier_right_ry_2, zdd_star_carrier_right_ry, s8_540, zdd_star_carrier_right_rx,
      Rz_carrier_right_rx_1, Rz_carrier_right_rx_2, s8_542, s2_243, s2_244, s2_245,
      Rz_arb_front_right_1, Rz_arb_front_right_2, zdd_star_arb_front_right, s2_251, s2_252, s2_254,
      s2_256, s3_36, s8_543, s6_195, s7_50, s7_51, s7_54, s7_71, s7_78, s7_81, s7_83, s7_88, s7_93,
      s7_94, s7_99, s7_100, s7_105, s7_106, s7_109, s8_544, s7_124, s8_545, s7_136, s7_139, s8_546,
      s8_547, s7_145, s7_147, s8_548, s7_152, s7_153, s7_158, s7_159, s7_162, s8_549, s7_163,
      s7_168, s7_169, s8_551, s8_552, s8_561, s8_562, s8_563, f_carrier_right_x, f_carrier_right_y,
      s8_594, s7_170, f_carrier_right_z, n_carrier_right_x, n_carrier_right_y, n_carrier_right_z,
      s7_173, s7_175, s8_606, s8_607, s8_608, s8_609, s8_621, f_carrier_left_x, f_carrier_left_y,
      s8_654, f_carrier_left_z, n_carrier_left_x, n_carrier_left_y, n_carrier_left_z, s8_664,
      s8_665, s8_667, s8_669, s8_671, s8_673, s8_676, s8_682, s8_689, s8_691, s8_693, s8_700,
      s8_701, s8_702, s8_705, s8_707, s8_713, s8_720, s8_722, s8_723, s8_725, s8_728, s8_731,
      s8_738, s8_741, s8_744, s8_747, s8_750, s8_753, s8_754, s7_179, s7_181, s7_183, s7_184,
      s7_185, s7_186, s8_759, s8_764, s7_187, s8_765, s8_769, s8_770, s7_189, s8_774, s8_777,
      s8_780, s8_783, s8_785, s8_787, s8_788, s8_791, s8_792, s8_801, s7_194, s8_802, s7_196,
      s7_200, s8_819, s8_827, s8_843, s8_845, s8_847, s8_857, s8_859, s8_860, s8_864, s8_866,
      s8_914, s8_917, s8_918, s8_928, s7_204, s7_206, s8_937, s8_938, s8_939, s8_944, s8_945,
      s8_946, s8_953, s8_954, s8_955, s7_209, s7_211, s8_974, s8_985, s8_996, s8_1002, s8_1005,
      s8_1008, s7_218, s8_1012, s8_1013, s8_1015, s8_1021, s8_1022, s8_1024, s8_1028, s8_1029,
      s8_1069, s8_1078, s8_1079, s8_1080, s8_1137, s8_1140, s8_1149, s8_1152, s8_1153,
      pivot_bell_crank, s8_1164, s8_1169, s8_1171, s8_1173, s8_1177, s8_1184, s8_1187, s8_1189,
      s8_1191, s8_1199, s8_1201, s8_1206, s8_1223, s8_1224, s8_1226, s8_1230, s8_1237, s8_1239,
      s8_1243, s8_1246, s8_1280, s8_1296, s8_1304, s8_1305, s8_1307, s8_1309;
};

/// Part 1 of compute_accelerations: step 1: poses and axes b; step 2: closure Jacobian Phi_z and
/// its factors (60), long_rod_left .. arb_link_rear_right; step 4: velocities; step 6: c and dRz/dt
/// zd (62), long_rod_left .. arb_link_rear_right; step 2: closure Jacobian Phi_z and its factors
/// (60), long_rod_left .. arb_link_rear_right; step 6: c and dRz/dt zd (62), long_rod_left ..
/// arb_link_rear_right; step 2: closure Jacobian Phi_z and its factors (60), long_rod_left ..
/// arb_link_rear_right; step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right; step 2:
/// closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right; step 7:
/// inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right; step 8:
/// elimination from the leaves to the root (63); step 9: accelerations from the root to the leaves
/// (63), (62); step 8: elimination from the leaves to the root (63), long_rod_left ..
/// arb_link_rear_right.
[[gnu::noinline]] void compute_accelerations_1(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
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
  mbgen::sincos(angles, work.sines, work.cosines);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double s1_1 = work.sines[18];
  work.R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_1;
  const double s1_2 = work.sines[19];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double R_rear_axle_aux4_y_x = work.sines[17];
  const double s1_3 = work.cosines[19];
  work.R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_3, work.R_rear_axle_aux5_x_z*s1_2);
  const double R_rear_axle_x_z = fma(work.R_rear_axle_aux5_x_z, s1_3, R_rear_axle_aux4_y_x*s1_2);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  work.R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_1;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.R_rear_axle_y_y = fma(R_rear_axle_aux4_x_x, s1_3, work.R_rear_axle_aux5_y_z*s1_2);
  const double R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_2, work.R_rear_axle_aux5_y_z*s1_3);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  const double R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right
  // ---
  const double s2_1 = -p_arb_link_rear_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_2 = fnma(p_arb_link_rear_left_to_z, R_rear_axle_y_z, s2_1);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s2_3 = -p_arb_link_rear_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_4 = fnma(p_arb_link_rear_left_to_z, R_rear_axle_x_z, s2_3);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_3;
  const double s2_5 = -p_arb_link_rear_left_to_x*s1_1;
  const double s2_6 = fma(p_arb_link_rear_left_to_z, R_rear_axle_z_z, s2_5);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_2;

  // --- step 4: velocities ---
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  work.s4_1 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s4_2 = zd_rear_axle_rx*R_rear_axle_aux5_x_x;
  work.s4_3 = zd_rear_axle_rx*s1_1;
  const double s4_4 = state.zd[Coordinate::rear_axle_rz] - work.s4_3;
  const double s4_5 = work.s4_2 - work.s4_1;
  work.s2_7 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_6);
  work.s2_8 = fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_6);
  work.s2_9 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_4);
  work.s2_10 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_4);

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right ---
  const double s6_1 = fnma(s4_5, work.s2_7, s4_4*work.s2_9);
  work.s4_6 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  work.s4_7 = zd_rear_axle_rx*R_rear_axle_aux5_y_x;
  work.s4_8 = work.s4_6 + work.s4_7;
  work.s2_11 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_2);
  work.s2_12 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_2);
  const double s6_2 = fnma(s4_4, work.s2_11, work.s4_8*work.s2_7);
  const double s6_3 = fnma(work.s4_8, work.s2_9, s4_5*work.s2_11);
  work.s2_13 = p_arb_link_rear_left_from_x*work.cosines[20];
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s6_4 = zd_arb_rear_left*work.s2_13;
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s6_5 = s6_3 + (zd_rear_axle_tz + s6_4);
  const double s6_6 = fma(work.s4_8, s6_3, fnma(s4_4, s6_1, zd_arb_rear_left*s6_4));
  const double s6_7 = fnma(s4_5, s6_3, s4_4*s6_2);
  work.s2_14 = p_arb_link_rear_left_from_x*work.sines[20];
  const double s6_8 = zd_arb_rear_left*work.s2_14;
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s6_9 = s6_2 + (zd_rear_axle_tx + s6_8);
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s6_10 = zd_rear_axle_ty + s6_1;
  const double s6_11 = fma(work.s4_8, s6_2, fnma(s4_5, s6_1, zd_arb_rear_left*s6_8));
  const double s6_12 = fma(s4_5, work.s2_8, s4_4*work.s2_10);
  const double s6_13 = fma(work.s4_8, work.s2_8, s4_4*work.s2_12);
  const double s6_14 = fnma(s4_5, work.s2_12, work.s4_8*work.s2_10);
  work.s2_15 = p_arb_link_rear_right_from_x*work.cosines[21];
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s6_15 = zd_arb_rear_right*work.s2_15;
  const double s6_16 = s6_14 + (zd_rear_axle_tz + s6_15);
  const double s6_17 = fma(work.s4_8, s6_14, fma(s4_4, s6_12, zd_arb_rear_right*s6_15));
  const double s6_18 = fnma(s4_5, s6_14, s4_4*s6_13);
  work.s2_16 = p_arb_link_rear_right_from_x*work.sines[21];
  const double s6_19 = zd_arb_rear_right*work.s2_16;
  const double s6_20 = s6_13 + (zd_rear_axle_tx + s6_19);
  const double s6_21 = zd_rear_axle_ty - s6_12;
  const double s6_22 = fma(work.s4_8, s6_13, fma(s4_5, s6_12, zd_arb_rear_right*s6_19));

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right,
  // continued ---
  const double s2_17 = fnma(p_long_rod_left_to_z, R_rear_axle_z_z, p_long_rod_left_to_x*s1_1);
  const double s2_18 = p_long_rod_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_19 = fma(p_long_rod_left_to_z, R_rear_axle_x_z, s2_18);
  const double s2_20 = p_long_rod_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_21 = fma(p_long_rod_left_to_z, R_rear_axle_y_z, s2_20);
  work.s2_22 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_21);
  work.s2_23 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_21);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.s2_24 = p_long_rod_left_from_y - z_rear_axle_ty - work.s2_22;
  const double s2_25 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  work.s2_26 = fma(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_25);
  work.s2_27 = fms(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_25);
  work.s2_28 = p_diag_rod_left_from_y - z_rear_axle_ty - work.s2_26;
  const double s2_29 = p_diag_rod_left_to_z*R_rear_axle_x_z;
  work.s2_30 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_29);
  work.s2_31 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_29);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  const double s2_32 = work.r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  work.s2_33 = work.s2_30 + s2_32;
  work.pivot_rear_axle_tx = s2_32 + work.s2_31;
  const double s2_34 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  work.s2_35 = fma(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_34);
  work.s2_36 = fms(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_34);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] + p_rear_axle_tx_z;
  const double s2_37 = work.r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  work.s2_38 = work.s2_35 + s2_37;
  work.s2_39 = s2_37 + work.s2_36;
  work.s2_40 = work.s2_27 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  work.s2_41 = fnma(work.s2_39, work.s2_27, work.s2_36*work.s2_40);
  work.s2_42 = fnma(work.pivot_rear_axle_tx, work.s2_36, work.s2_31*work.s2_39);
  work.s2_43 = fnma(work.s2_31, work.s2_40, work.pivot_rear_axle_tx*work.s2_27);
  work.s2_44 = 1.0/work.pivot_rear_axle_tx;
  const double s2_45 = work.s2_33*work.s2_44;
  const double s2_46 = fnma(work.s2_33, work.s2_26, work.s2_43*s2_45);
  work.s2_47 = fnma(work.s2_30, work.s2_28, s2_46);
  work.s2_48 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_19);
  work.s2_49 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_19);
  const double s2_50 = work.r_rear_axle_aux1_x - p_long_rod_left_from_x;
  work.s2_51 = work.s2_48 + s2_50;
  work.s2_52 = s2_50 + work.s2_49;
  const double s2_53 = fma(work.s2_40, s2_45, work.s2_28);
  const double s2_54 = work.s2_51*work.s2_44;
  work.s2_55 = 1.0/s2_53;
  const double s2_56 = fma(work.s2_40, s2_54, work.s2_24)*work.s2_55;
  work.s2_57 = 1.665350081353039*std::abs(s2_53);
  const double s2_58 = fnma(work.s2_51, work.s2_22, work.s2_43*s2_54);
  const double pivot_rear_axle_rx = fnma(work.s2_47, s2_56, fnma(work.s2_48, work.s2_24, s2_58));
  const double s2_59 = fnma(work.s2_38, work.s2_30, work.s2_35*work.s2_33);
  work.s2_60 = fma(work.s2_42, s2_45, s2_59);
  work.s2_61 = fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_17);
  work.s2_62 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_17);
  const double s2_63 = work.r_rear_axle_aux3_z - p_long_rod_left_from_z;
  work.s2_64 = work.s2_61 + s2_63;
  work.s2_65 = s2_63 - work.s2_62;
  const double s2_66 = fnma(work.s2_64, work.s2_48, work.s2_61*work.s2_51);
  work.s2_67 = fnma(s2_56, work.s2_60, fma(work.s2_42, s2_54, s2_66));
  const double s2_68 = fma(work.s2_35, work.s2_28, work.s2_38*work.s2_26);
  work.s2_69 = fma(work.s2_41, s2_45, s2_68);
  const double s2_70 = fma(work.s2_61, work.s2_24, work.s2_64*work.s2_22);
  work.s2_71 = fnma(s2_56, work.s2_69, fma(work.s2_41, s2_54, s2_70));

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right, continued ---
  // diag_rod_left
  const double s6_23 = fnma(s4_4, work.s2_26, work.s4_8*work.s2_35);
  const double s6_24 = fnma(s4_5, work.s2_35, s4_4*work.s2_30);
  const double s6_25 = fnma(work.s4_8, work.s2_30, s4_5*work.s2_26);
  const double s6_26 = fnma(s4_4, s6_24, work.s4_8*s6_25);
  const double s6_27 = zd_rear_axle_ty + s6_24;
  const double s6_28 = fnma(work.s4_8, s6_23, s4_5*s6_24);
  const double s6_29 = zd_rear_axle_tx + s6_23;
  const double s6_30 = fnma(s4_5, s6_25, s4_4*s6_23);
  const double s6_31 = zd_rear_axle_tz + s6_25;
  // diag_rod_right
  const double s6_32 = fnma(s4_4, work.s2_27, work.s4_8*work.s2_36);
  const double s6_33 = fnma(s4_5, work.s2_36, s4_4*work.s2_31);
  const double s6_34 = fnma(work.s4_8, work.s2_31, s4_5*work.s2_27);
  const double s6_35 = fnma(s4_4, s6_33, work.s4_8*s6_34);
  const double s6_36 = zd_rear_axle_ty + s6_33;
  const double s6_37 = fnma(work.s4_8, s6_32, s4_5*s6_33);
  const double s6_38 = zd_rear_axle_tx + s6_32;
  const double s6_39 = fnma(s4_5, s6_34, s4_4*s6_32);
  const double s6_40 = zd_rear_axle_tz + s6_34;
  const double s6_41 = fma(s6_40, s6_40, fma(s6_36, s6_36, s6_38*s6_38));
  const double s6_42 = fma(work.s2_40, s6_39, fma(work.pivot_rear_axle_tx, s6_35, s6_41));
  const double s6_43 = fma(work.s2_39, s6_37, s6_42);
  const double s6_44 = fnma(s6_27, s6_27, fnma(s6_29, s6_29, work.s2_28*s6_30));
  const double s6_45 = fnma(work.s2_33, s6_26, fnma(s6_31, s6_31, s6_44));
  const double s6_46 = fma(s2_45, s6_43, fnma(work.s2_38, s6_28, s6_45));
  work.s2_72 = fnma(work.s2_39, s2_45, work.s2_38);
  // long_rod_left
  const double s6_47 = fnma(s4_4, work.s2_22, work.s4_8*work.s2_61);
  const double s6_48 = fnma(s4_5, work.s2_61, s4_4*work.s2_48);
  const double s6_49 = fnma(work.s4_8, work.s2_48, s4_5*work.s2_22);
  const double s6_50 = fnma(s4_4, s6_48, work.s4_8*s6_49);
  const double s6_51 = zd_rear_axle_ty + s6_48;
  const double s6_52 = fnma(work.s4_8, s6_47, s4_5*s6_48);
  const double s6_53 = zd_rear_axle_tx + s6_47;
  const double s6_54 = fnma(s4_5, s6_49, s4_4*s6_47);
  const double s6_55 = zd_rear_axle_tz + s6_49;
  const double s6_56 = fnma(s6_51, s6_51, fnma(s6_53, s6_53, work.s2_24*s6_54));
  const double s6_57 = fnma(work.s2_51, s6_50, fnma(s6_55, s6_55, s6_56));
  const double s6_58 = fnma(s2_56, s6_46, fma(s2_54, s6_43, fnma(work.s2_64, s6_52, s6_57)));

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right,
  // continued ---
  work.s2_73 = fnma(s2_56, work.s2_72, fnma(work.s2_39, s2_54, work.s2_64));
  work.s2_74 = work.s2_23 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s2_75 = work.s2_52*work.s2_44;
  const double s2_76 = work.s2_55*fnma(work.s2_40, s2_75, work.s2_74);
  const double s2_77 = fnma(work.s2_23, work.s2_52, work.s2_74*work.s2_49);
  const double s2_78 = fnma(work.s2_65, work.s2_49, work.s2_42*s2_75);
  const double s2_79 = fma(work.s2_23, work.s2_65, work.s2_62*work.s2_74);

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right, continued ---
  // long_rod_right
  const double s6_59 = fma(s4_4, work.s2_23, work.s4_8*work.s2_62);
  const double s6_60 = fma(s4_4, work.s2_49, s4_5*work.s2_62);
  const double s6_61 = fnma(work.s4_8, work.s2_49, s4_5*work.s2_23);
  const double s6_62 = fma(s4_5, s6_60, work.s4_8*s6_59);
  const double s6_63 = fnma(s4_4, s6_60, work.s4_8*s6_61);
  const double s6_64 = zd_rear_axle_ty + s6_60;
  const double s6_65 = zd_rear_axle_tx - s6_59;
  const double s6_66 = fma(s4_5, s6_61, s4_4*s6_59);
  const double s6_67 = zd_rear_axle_tz + s6_61;
  const double s6_68 = fnma(s6_67, s6_67, fnma(s6_64, s6_64, work.s2_74*s6_66));
  const double s6_69 = fnma(work.s2_65, s6_62, fnma(s6_65, s6_65, s6_68));
  work.s2_80 = 1.0/pivot_rear_axle_rx;
  const double s2_81 = fma(work.s2_47, s2_76, fma(work.s2_43, s2_75, s2_77))*work.s2_80;
  const double s2_82 = fma(work.s2_60, s2_76, fnma(work.s2_62, work.s2_52, s2_78));
  const double pivot_rear_axle_ry = fnma(work.s2_67, s2_81, s2_82);
  const double s2_83 = fma(s2_76, work.s2_69, fma(work.s2_41, s2_75, s2_79));
  work.s2_84 = fnma(s2_81, work.s2_71, s2_83);
  const double s2_85 = fma(s2_76, work.s2_72, fnma(work.s2_39, s2_75, work.s2_65));
  work.s2_86 = fnma(s2_81, work.s2_73, s2_85);
  const double s6_70 = fma(s2_76, s6_46, fma(s2_75, s6_43, fnma(work.s2_52, s6_63, s6_69)));
  const double s6_71 = fnma(s2_81, s6_58, s6_70);

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right,
  // continued ---
  work.s2_87 = 2.1234888829989926*std::abs(pivot_rear_axle_rx);
  const double s2_88 = work.r_rear_axle_aux3_z - p_arb_rear_left_z;
  work.s2_89 = s2_88 + (work.s2_14 + work.s2_7);
  work.s2_90 = work.s2_8 + (s2_88 + work.s2_16);
  work.s2_91 = 0.6 + z_rear_axle_ty - work.s2_12;
  work.s2_92 = work.s2_15 + (work.s2_10 + p_arb_rear_right_x - work.r_rear_axle_aux1_x);
  const double s2_93 = work.s2_92*work.s2_44;
  const double s2_94 = work.s2_55*fma(work.s2_40, s2_93, work.s2_91);
  const double s2_95 = fnma(work.s2_10, work.s2_91, work.s2_47*s2_94);
  const double s2_96 = work.s2_80*fnma(work.s2_43, s2_93, fnma(work.s2_12, work.s2_92, s2_95));
  const double s2_97 = fnma(work.s2_8, work.s2_92, work.s2_10*work.s2_90);
  const double s2_98 = fma(work.s2_60, s2_94, fnma(work.s2_42, s2_93, s2_97));
  const double s2_99 = fnma(work.s2_91, work.s2_8, work.s2_69*s2_94);
  const double s2_100 = fnma(work.s2_41, s2_93, fnma(work.s2_12, work.s2_90, s2_99));
  const double s6_72 = fnma(s6_21, s6_21, fnma(s2_93, s6_43, work.s2_92*s6_17));
  const double s2_101 = fma(s2_94, work.s2_72, fma(work.s2_39, s2_93, work.s2_90));
  const double s6_73 = fnma(work.s2_91, s6_18, fnma(s6_16, s6_16, fnma(s6_20, s6_20, s6_72)));
  work.s2_102 = 1.0/pivot_rear_axle_ry;
  const double s2_103 = fnma(work.s2_67, s2_96, s2_98)*work.s2_102;
  const double pivot_rear_axle_rz = fnma(work.s2_84, s2_103, fnma(work.s2_71, s2_96, s2_100));
  work.s2_104 = fnma(s2_103, work.s2_86, fnma(s2_96, work.s2_73, s2_101));
  const double s6_74 = fnma(s2_96, s6_58, fma(s2_94, s6_46, fma(work.s2_90, s6_22, s6_73)));
  const double s6_75 = fnma(s2_103, s6_71, s6_74);
  work.s2_105 = 1.7864443153153613*std::abs(pivot_rear_axle_ry);
  work.s2_106 = 0.6 - z_rear_axle_ty - work.s2_11;
  work.s2_107 = work.s2_13 + p_arb_rear_left_x - work.r_rear_axle_aux1_x - work.s2_9;
  const double s2_108 = work.s2_107*work.s2_44;
  const double s2_109 = work.s2_55*fms(work.s2_40, s2_108, work.s2_106);
  const double s2_110 = fnma(work.s2_106, work.s2_9, work.s2_11*work.s2_107);
  const double s2_111 = work.s2_80*fma(work.s2_47, s2_109, fnma(work.s2_43, s2_108, s2_110));
  const double s2_112 = fnma(work.s2_89, work.s2_9, work.s2_60*s2_109);
  const double s2_113 = fnma(work.s2_42, s2_108, fnma(work.s2_7, work.s2_107, s2_112));
  const double s2_114 = work.s2_102*fnma(work.s2_67, s2_111, s2_113);
  const double s2_115 = fma(work.s2_7, work.s2_106, work.s2_89*work.s2_11);
  const double s2_116 = fma(work.s2_69, s2_109, fnma(work.s2_41, s2_108, s2_115));
  const double s6_76 = fnma(s6_5, s6_5, fnma(s6_9, s6_9, fnma(s6_10, s6_10, work.s2_106*s6_7)));
  const double s6_77 = fma(work.s2_89, s6_11, fma(work.s2_107, s6_6, s6_76));
  const double s2_117 = fma(work.s2_72, s2_109, fma(work.s2_39, s2_108, work.s2_89));
  const double s6_78 = fnma(s2_111, s6_58, fma(s2_109, s6_46, fnma(s2_108, s6_43, s6_77)));

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_1 = K_rear_axle_xx*R_rear_axle_aux5_y_x;
  const double s7_2 = fma(K_rear_axle_xz, R_rear_axle_y_z, s7_1);
  const double s7_3 = K_rear_axle_yy*work.R_rear_axle_y_y;
  const double s7_4 = K_rear_axle_xz*R_rear_axle_aux5_y_x;
  const double s7_5 = fma(K_rear_axle_zz, R_rear_axle_y_z, s7_4);
  work.s7_6 = fma(R_rear_axle_z_z, s7_5, fnma(s1_1, s7_2, work.R_rear_axle_z_y*s7_3));
  const double s7_7 = fma(work.R_rear_axle_y_y, s7_3, R_rear_axle_aux5_y_x*s7_2);
  work.s7_8 = fma(R_rear_axle_y_z, s7_5, s7_7);
  work.s7_9 = fma(h_rear_axle_z, R_rear_axle_y_z, h_rear_axle_x*R_rear_axle_aux5_y_x);
  const double s7_10 = K_rear_axle_xx*R_rear_axle_aux5_x_x;
  const double s7_11 = fma(K_rear_axle_xz, R_rear_axle_x_z, s7_10);
  const double s7_12 = K_rear_axle_xz*R_rear_axle_aux5_x_x;
  const double s7_13 = fma(K_rear_axle_zz, R_rear_axle_x_z, s7_12);
  const double s7_14 = K_rear_axle_yy*work.R_rear_axle_x_y;
  const double s7_15 = fma(work.R_rear_axle_y_y, s7_14, R_rear_axle_aux5_y_x*s7_11);
  work.s7_16 = fma(R_rear_axle_y_z, s7_13, s7_15);
  const double s7_17 = fnma(s1_1, s7_11, work.R_rear_axle_z_y*s7_14);
  work.s7_18 = fma(R_rear_axle_z_z, s7_13, s7_17);
  work.s7_19 = fnma(h_rear_axle_x, s1_1, h_rear_axle_z*R_rear_axle_z_z);
  const double s7_20 = fma(work.R_rear_axle_x_y, s7_14, R_rear_axle_aux5_x_x*s7_11);
  work.s7_21 = fma(R_rear_axle_x_z, s7_13, s7_20);
  work.s7_22 = fma(h_rear_axle_z, R_rear_axle_x_z, h_rear_axle_x*R_rear_axle_aux5_x_x);
  const double s1_4 = R_rear_axle_aux4_x_x*R_rear_axle_aux5_x_x;
  work.s1_5 = fma(R_rear_axle_aux4_y_x, R_rear_axle_aux5_y_x, s1_4);
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux5_z_z = work.cosines[1];
  const double s1_6 = work.sines[2];
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_6;
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  const double s4_9 = zd_chassis_rz*work.sines[1];
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  work.w_chassis_x = zd_chassis_rx - s4_9;
  const double s4_10 = zd_chassis_rz*work.R_chassis_z_y;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  const double s1_7 = work.cosines[2];
  const double s4_11 = zd_chassis_ry*s1_7;
  work.w_chassis_y = s4_10 + s4_11;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double w_rear_axle_x = work.w_chassis_x + s4_5;
  const double w_rear_axle_y = work.w_chassis_y + work.s4_8;

  // --- step 8: elimination from the leaves to the root (63) ---
  const double s8_1 = work.R_rear_axle_x_y*w_rear_axle_x;
  // chassis: chassis_rx, revolute, chassis_aux5
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_7;
  const double s4_12 = zd_chassis_rz*work.R_chassis_z_z;
  const double s4_13 = zd_chassis_ry*s1_6;
  work.w_chassis_z = s4_12 - s4_13;

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  work.s9_1 = fma(s4_10, s4_13, s4_11*s4_12);
  work.s9_2 = fma(zd_chassis_rx, work.w_chassis_y, s4_9*s4_11);
  work.s9_3 = fnma(zd_chassis_rx, work.w_chassis_z, s4_9*s4_13);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double w_rear_axle_z = work.w_chassis_z + s4_4;
  const double s8_2 = fma(work.R_rear_axle_y_y, w_rear_axle_y, s8_1);
  const double s8_3 = fma(work.R_rear_axle_z_y, w_rear_axle_z, s8_2);

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right
  // ---
  const double s8_4 = state.zd[Coordinate::wheel_rear_right] + s8_3;
  const double s8_5 = s8_4 + (state.zd[Coordinate::wheel_rear_left] + s8_3);
  const double s8_6 = I_wheel_rear_right_polar*s8_5;
  const double s8_7 = work.R_rear_axle_y_y*w_rear_axle_x;
  const double s8_8 = work.R_rear_axle_x_y*w_rear_axle_z;
  const double s8_9 = work.R_rear_axle_z_y*w_rear_axle_y;
  work.s2_118 = 1.0/pivot_rear_axle_rz;
  work.s2_119 = fnma(work.s2_84, s2_114, fnma(work.s2_71, s2_111, s2_116))*work.s2_118;
  const double s2_120 = fnma(work.s2_86, s2_114, fnma(work.s2_73, s2_111, s2_117));
  const double pivot_rear_axle_tz = fnma(work.s2_104, work.s2_119, s2_120);
  work.s2_121 = 8.176955428452642*std::abs(pivot_rear_axle_rz);
  work.s2_122 = 1.0/pivot_rear_axle_tz;
  work.zdd_star_rear_axle_tz = work.s2_122*fnma(work.s2_119, s6_75, fnma(s2_114, s6_71, s6_78));
  work.s2_123 = 2.7700489841913827*std::abs(pivot_rear_axle_tz);
  work.zdd_star_rear_axle_rz = work.s2_118*fnma(work.s2_104, work.zdd_star_rear_axle_tz, s6_75);
  const double s6_79 = fnma(work.s2_86, work.zdd_star_rear_axle_tz, s6_71);
  const double s6_80 = fnma(work.s2_73, work.zdd_star_rear_axle_tz, s6_58);
  const double s6_81 = fnma(work.s2_72, work.zdd_star_rear_axle_tz, s6_46);
  const double s8_10 = s6_11 - work.zdd_star_rear_axle_tz;
  const double s8_11 = s6_22 - work.zdd_star_rear_axle_tz;
  work.zdd_star_rear_axle_ry = work.s2_102*fnma(work.s2_84, work.zdd_star_rear_axle_rz, s6_79);
  const double s6_82 = fms(work.s2_41, work.zdd_star_rear_axle_rz, s6_43);
  const double s6_83 = fnma(work.s2_71, work.zdd_star_rear_axle_rz, s6_80);
  const double s6_84 = fnma(work.s2_69, work.zdd_star_rear_axle_rz, s6_81);
  const double s8_12 = fnma(work.s2_11, work.zdd_star_rear_axle_rz, s8_10);
  const double s8_13 = fma(work.s2_12, work.zdd_star_rear_axle_rz, s8_11);
  const double s6_85 = fnma(work.s2_39, work.zdd_star_rear_axle_tz, s6_82);
  work.zdd_star_rear_axle_rx = work.s2_80*fnma(work.s2_67, work.zdd_star_rear_axle_ry, s6_83);
  const double s8_14 = fms(work.s2_48, work.zdd_star_rear_axle_ry, s6_52);
  const double s8_15 = fms(work.s2_30, work.zdd_star_rear_axle_ry, s6_28);
  const double s8_16 = fms(work.s2_49, work.zdd_star_rear_axle_ry, s6_62);
  const double s8_17 = fms(work.s2_31, work.zdd_star_rear_axle_ry, s6_37);
  const double s6_86 = fnma(work.s2_60, work.zdd_star_rear_axle_ry, s6_84);
  const double s6_87 = fma(work.s2_42, work.zdd_star_rear_axle_ry, s6_85);
  const double s8_18 = fms(work.s2_61, work.zdd_star_rear_axle_rz, s6_54);
  const double s8_19 = fms(work.s2_35, work.zdd_star_rear_axle_rz, s6_30);
  const double s8_20 = fms(work.s2_7, work.zdd_star_rear_axle_rz, s6_7);
  const double s8_21 = fnma(work.s2_62, work.zdd_star_rear_axle_rz, s6_66);
  const double s8_22 = fms(work.s2_62, work.zdd_star_rear_axle_ry, s6_63);
  const double s8_23 = fms(work.s2_36, work.zdd_star_rear_axle_rz, s6_39);
  const double s8_24 = fms(work.s2_8, work.zdd_star_rear_axle_rz, s6_18);
  const double s8_25 = s8_14 - work.zdd_star_rear_axle_tz;
  const double s8_26 = s8_15 - work.zdd_star_rear_axle_tz;
  const double s8_27 = s8_16 - work.zdd_star_rear_axle_tz;
  const double s8_28 = s8_17 - work.zdd_star_rear_axle_tz;
  work.s6_88 = work.s2_55*fnma(work.s2_47, work.zdd_star_rear_axle_rx, s6_86);
  const double s8_29 = fms(work.s2_22, work.zdd_star_rear_axle_rx, s6_50);
  const double s8_30 = fms(work.s2_26, work.zdd_star_rear_axle_rx, s6_26);
  const double s8_31 = fms(work.s2_11, work.zdd_star_rear_axle_rx, s6_6);
  const double s8_32 = fms(work.s2_27, work.zdd_star_rear_axle_rx, s6_35);
  const double s6_89 = fma(work.s2_43, work.zdd_star_rear_axle_rx, s6_87);
  work.zdd_star_rear_axle_tx = work.s2_44*fma(work.s2_40, work.s6_88, s6_89);
  const double s8_33 = fnma(work.s2_61, work.zdd_star_rear_axle_ry, s8_29);
  const double s8_34 = fnma(work.s2_35, work.zdd_star_rear_axle_ry, s8_30);
  const double s8_35 = fnma(work.s2_7, work.zdd_star_rear_axle_ry, s8_31);
  const double s8_36 = fma(work.s2_23, work.zdd_star_rear_axle_rx, s8_22);
  const double s8_37 = fnma(work.s2_36, work.zdd_star_rear_axle_ry, s8_32);
  const double s8_38 = work.w_chassis_y*work.w_chassis_y;
  const double s8_39 = work.w_chassis_x*work.w_chassis_x;
  work.s8_40 = s8_38 + s8_39;
  work.s8_41 = fma(work.w_chassis_z, work.w_chassis_z, s8_38);
  work.s8_42 = fma(work.w_chassis_z, work.w_chassis_z, s8_39);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.s8_43 = fnma(work.w_chassis_y, s4_5, work.w_chassis_x*work.s4_8);
  work.s8_44 = fnma(work.w_chassis_x, s4_4, work.w_chassis_z*s4_5);
  work.s8_45 = fnma(work.w_chassis_z, work.s4_8, work.w_chassis_y*s4_4);
  const double s8_46 = work.zdd_star_rear_axle_rx + work.s8_43;
  const double s8_47 = fms(w_rear_axle_x, w_rear_axle_y, s8_46);
  const double s8_48 = fma(w_rear_axle_x, w_rear_axle_y, s8_46);
  const double s8_49 = work.zdd_star_rear_axle_rz + work.s8_45;
  const double s8_50 = fms(w_rear_axle_y, w_rear_axle_z, s8_49);
  const double s8_51 = fma(w_rear_axle_y, w_rear_axle_z, s8_49);
  const double s8_52 = w_rear_axle_y*w_rear_axle_y;
  const double s8_53 = work.zdd_star_rear_axle_ry + work.s8_44;
  const double s8_54 = fma(w_rear_axle_x, w_rear_axle_z, s8_53);
  const double s8_55 = fms(w_rear_axle_x, w_rear_axle_z, s8_53);
  const double s8_56 = w_rear_axle_z*w_rear_axle_z;
  work.s8_57 = work.w_chassis_x + work.w_chassis_x;
  const double s8_58 = work.s6_88 + fnma(work.s2_48, work.zdd_star_rear_axle_rx, s8_18);
  const double s8_59 = work.s6_88 + fnma(work.s2_30, work.zdd_star_rear_axle_rx, s8_19);
  const double s8_60 = work.s6_88 + fnma(work.s2_9, work.zdd_star_rear_axle_rx, s8_20);
  const double s8_61 = work.s6_88 + fnma(work.s2_49, work.zdd_star_rear_axle_rx, s8_21);
  const double s8_62 = work.s6_88 + fnma(work.s2_31, work.zdd_star_rear_axle_rx, s8_23);
  const double s8_63 = work.s6_88 + fma(work.s2_10, work.zdd_star_rear_axle_rx, s8_24);
  work.s8_64 = work.w_chassis_z + work.w_chassis_z;
  const double s8_65 = fms(s6_21, work.s8_64, s6_17);
  const double s8_66 = fnma(work.s2_8, work.zdd_star_rear_axle_ry, s8_65);
  const double s8_67 = fnma(work.s2_12, work.zdd_star_rear_axle_rx, s8_66);
  const double s8_68 = fms(zd_rear_axle_tx, work.s8_64, work.s6_88);
  work.s8_69 = work.w_chassis_x*work.w_chassis_y;
  const double s8_70 = fnma(zd_rear_axle_tz, work.s8_57, s8_68);
  const double s8_71 = fnma(s6_53, work.s8_64, fma(s6_55, work.s8_57, s8_58));
  const double s8_72 = fnma(s6_29, work.s8_64, fma(s6_31, work.s8_57, s8_59));
  const double s8_73 = fnma(s6_9, work.s8_64, fma(s6_5, work.s8_57, s8_60));
  const double s8_74 = fnma(s6_65, work.s8_64, fma(s6_67, work.s8_57, s8_61));
  const double s8_75 = fnma(s6_38, work.s8_64, fma(s6_40, work.s8_57, s8_62));
  const double s8_76 = fnma(s6_20, work.s8_64, fma(s6_16, work.s8_57, s8_63));
  work.s8_77 = work.w_chassis_y*work.w_chassis_z;
  const double s8_78 = fma(work.r_rear_axle_aux1_x, work.s8_69, s8_70);
  const double s8_79 = fnma(work.pivot_rear_axle_tx, work.s8_69, s8_75);
  const double s8_80 = fma(work.r_rear_axle_aux3_z, work.s8_77, s8_78);
  const double s8_81 = fnma(z_rear_axle_ty, work.s8_42, s8_80);
  const double s8_82 = fnma(work.s2_64, work.s8_77, fnma(work.s2_51, work.s8_69, s8_71));
  const double s8_83 = fnma(work.s2_38, work.s8_77, fnma(work.s2_33, work.s8_69, s8_72));
  const double s8_84 = fnma(work.s2_89, work.s8_77, fma(work.s2_107, work.s8_69, s8_73));
  const double s8_85 = fnma(work.s2_65, work.s8_77, fnma(work.s2_52, work.s8_69, s8_74));
  const double s8_86 = fnma(work.s2_90, work.s8_77, fma(work.s2_92, work.s8_69, s8_76));
  work.s8_87 = 3.0*fnma(work.s2_24, work.s8_42, s8_82);
  work.s8_88 = 2.6666666666666665*fnma(work.s2_28, work.s8_42, s8_83);
  work.s8_89 = 0.3333333333333333*fnma(work.s2_106, work.s8_42, s8_84);
  work.s8_90 = 3.0*fma(work.s2_74, work.s8_42, s8_85);
  const double s8_91 = fma(work.s2_40, work.s8_42, fnma(work.s2_39, work.s8_77, s8_79));
  work.s8_92 = 2.6666666666666665*s8_91;
  work.s8_93 = 0.3333333333333333*fma(work.s2_91, work.s8_42, s8_86);
  work.s8_94 = work.w_chassis_y + work.w_chassis_y;
  const double s8_95 = fnma(work.s2_22, work.zdd_star_rear_axle_rz, s8_25);
  const double s8_96 = fnma(work.s2_26, work.zdd_star_rear_axle_rz, s8_26);
  const double s8_97 = fnma(work.s2_23, work.zdd_star_rear_axle_rz, s8_27);
  const double s8_98 = fnma(work.s2_27, work.zdd_star_rear_axle_rz, s8_28);
  const double s8_99 = fnma(work.s2_10, work.zdd_star_rear_axle_ry, s8_13);
  const double s8_100 = fnma(s6_55, work.s8_94, s8_33 - work.zdd_star_rear_axle_tx);
  const double s8_101 = fnma(s6_31, work.s8_94, s8_34 - work.zdd_star_rear_axle_tx);
  const double s8_102 = fma(s6_9, work.s8_94, fma(work.s2_9, work.zdd_star_rear_axle_ry, s8_12));
  const double s8_103 = fnma(s6_5, work.s8_94, s8_35 - work.zdd_star_rear_axle_tx);
  const double s8_104 = fnma(s6_67, work.s8_94, s8_36 - work.zdd_star_rear_axle_tx);
  const double s8_105 = fnma(s6_40, work.s8_94, s8_37 - work.zdd_star_rear_axle_tx);
  const double s8_106 = fnma(s6_16, work.s8_94, s8_67 - work.zdd_star_rear_axle_tx);
  const double s8_107 = fnma(s6_51, work.s8_57, fma(s6_53, work.s8_94, s8_95));
  const double s8_108 = fnma(s6_27, work.s8_57, fma(s6_29, work.s8_94, s8_96));
  const double s8_109 = fnma(s6_64, work.s8_57, fma(s6_65, work.s8_94, s8_97));
  const double s8_110 = fnma(s6_36, work.s8_57, fma(s6_38, work.s8_94, s8_98));
  const double s8_111 = fnma(s6_21, work.s8_57, fma(s6_20, work.s8_94, s8_99));
  const double s8_112 = fnma(zd_rear_axle_tx, work.s8_94, work.zdd_star_rear_axle_tz);
  const double s8_113 = fma(zd_rear_axle_ty, work.s8_57, s8_112);
  work.s8_114 = work.w_chassis_x*work.w_chassis_z;
  const double s8_115 = fma(z_rear_axle_ty, work.s8_77, s8_113);
  const double s8_116 = fma(work.s2_24, work.s8_69, fma(s6_51, work.s8_64, s8_100));
  const double s8_117 = fma(work.s2_28, work.s8_69, fma(s6_27, work.s8_64, s8_101));
  const double s8_118 = fma(work.s2_106, work.s8_77, fnma(s6_10, work.s8_57, s8_102));
  const double s8_119 = fma(work.s2_106, work.s8_69, fma(s6_10, work.s8_64, s8_103));
  const double s8_120 = fnma(work.s2_74, work.s8_69, fma(s6_64, work.s8_64, s8_104));
  const double s8_121 = fnma(work.s2_40, work.s8_77, s8_110);
  const double s8_122 = fnma(work.s2_40, work.s8_69, fma(s6_36, work.s8_64, s8_105));
  const double s8_123 = fma(work.r_rear_axle_aux1_x, work.s8_114, s8_115);
  const double s8_124 = fnma(work.r_rear_axle_aux3_z, work.s8_40, s8_123);
  const double s8_125 = fnma(work.s2_51, work.s8_114, fma(work.s2_24, work.s8_77, s8_107));
  const double s8_126 = fnma(work.s2_33, work.s8_114, fma(work.s2_28, work.s8_77, s8_108));
  const double s8_127 = fnma(work.s2_52, work.s8_114, fnma(work.s2_74, work.s8_77, s8_109));
  const double s8_128 = fnma(work.pivot_rear_axle_tx, work.s8_114, s8_121);
  const double s8_129 = fnma(work.s2_39, work.s8_114, s8_122);
  const double s8_130 = fma(work.s2_92, work.s8_114, fnma(work.s2_91, work.s8_77, s8_111));
  const double s8_131 = fnma(work.s2_90, work.s8_114, fnma(work.s2_91, work.s8_69, s8_106));
  work.s8_132 = 3.0*fma(work.s2_51, work.s8_41, fnma(work.s2_64, work.s8_114, s8_116));
  work.s8_133 = 3.0*fma(work.s2_64, work.s8_40, s8_125);
  const double s8_134 = fma(work.s2_33, work.s8_41, fnma(work.s2_38, work.s8_114, s8_117));
  work.s8_135 = 2.6666666666666665*s8_134;
  work.s8_136 = 2.6666666666666665*fma(work.s2_38, work.s8_40, s8_126);
  const double s8_137 = fma(work.s2_89, work.s8_40, fma(work.s2_107, work.s8_114, s8_118));
  work.s8_138 = 0.3333333333333333*s8_137;
  const double s8_139 = fnma(work.s2_107, work.s8_41, fnma(work.s2_89, work.s8_114, s8_119));
  work.s8_140 = 0.3333333333333333*s8_139;
  work.s8_141 = 3.0*fma(work.s2_65, work.s8_40, s8_127);
  work.s8_142 = 3.0*fma(work.s2_52, work.s8_41, fnma(work.s2_65, work.s8_114, s8_120));
  work.s8_143 = 2.6666666666666665*fma(work.s2_39, work.s8_40, s8_128);
  work.s8_144 = 2.6666666666666665*fma(work.pivot_rear_axle_tx, work.s8_41, s8_129);
  work.s8_145 = 0.3333333333333333*fma(work.s2_90, work.s8_40, s8_130);
  work.s8_146 = 0.3333333333333333*fnma(work.s2_92, work.s8_41, s8_131);
  const double s8_147 = fma(w_rear_axle_x, w_rear_axle_x, s8_56);
  const double s8_148 = s8_52 + s8_56;
  const double s8_149 = fma(w_rear_axle_x, w_rear_axle_x, s8_52);
  work.s7_23 = K_rear_axle_trace - work.s7_21;
  work.s7_24 = work.s7_23 - work.s7_8;
  const double s8_150 = fnma(work.s7_18, s8_48, fnma(work.s7_19, s8_81, work.s7_9*s8_124));
  const double s8_151 = fma(work.s7_8, s8_51, fnma(work.s7_24, s8_50, s8_150));
  const double s8_152 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_153 = fma(work.s7_6, s8_147 - s8_149, fma(work.s7_16, s8_55, s8_151));
  const double s8_154 = fnma(work.R_rear_axle_y_y, w_rear_axle_z, s8_9);
  work.n_rear_axle_x = fma(s8_154, s8_6, fma(work.R_rear_axle_x_y, s8_152, s8_153));
  const double s8_155 = fma(zd_rear_axle_tz, work.s8_94, work.zdd_star_rear_axle_tx);
  const double s8_156 = fnma(zd_rear_axle_ty, work.s8_64, s8_155);
  const double s8_157 = fma(z_rear_axle_ty, work.s8_69, s8_156);
  const double s8_158 = fma(work.r_rear_axle_aux3_z, work.s8_114, s8_157);
  const double s8_159 = fnma(work.r_rear_axle_aux1_x, work.s8_41, s8_158);
  const double s8_160 = fma(work.s7_24, s8_54, fma(work.s7_6, s8_47, work.s7_19*s8_159));
  const double s8_161 = fnma(work.s7_16, s8_51, fnma(work.s7_22, s8_124, s8_160));
  const double s8_162 = fma(work.s7_22, s8_55, fma(work.s7_9, s8_51, m_rear_axle_2*s8_124));
  work.f_rear_axle_z = fnma(work.s7_19, s8_149, s8_162);
  const double s8_163 = fma(work.R_rear_axle_y_y, s8_152, fnma(work.s7_21, s8_55, s8_161));
  const double s8_164 = fma(fnma(work.R_rear_axle_z_y, w_rear_axle_x, s8_8), s8_6, s8_163);
  work.n_rear_axle_y = fma(work.s7_18, s8_149 - s8_148, s8_164);
  const double s8_165 = fnma(work.s7_8, s8_47, fnma(work.s7_9, s8_159, work.s7_22*s8_81));
  const double s8_166 = fma(work.s7_19, s8_50, fma(work.s7_22, s8_48, m_rear_axle_2*s8_81));
  work.f_rear_axle_y = fnma(work.s7_9, s8_147, s8_166);
  const double s8_167 = fma(work.s7_19, s8_54, fma(work.s7_9, s8_47, m_rear_axle_2*s8_159));
  work.f_rear_axle_x = fnma(work.s7_22, s8_148, s8_167);
  const double s8_168 = fma(work.s7_21, s8_48, fnma(work.s7_6, s8_54, s8_165));
  const double s8_169 = fma(work.R_rear_axle_z_y, s8_152, fma(work.s7_18, s8_50, s8_168));
  const double s8_170 = fma(fnma(work.R_rear_axle_x_y, w_rear_axle_y, s8_7), s8_6, s8_169);
  work.n_rear_axle_z = fma(work.s7_16, s8_148 - s8_147, s8_170);
}

/// Part 2 of compute_accelerations: step 1: poses and axes b; step 3: Rz (61), long_rod_left ..
/// arb_link_rear_right; step 7: inertias of the bodies and forces on joints, long_rod_left ..
/// arb_link_rear_right; step 8: elimination from the leaves to the root (63), long_rod_left ..
/// arb_link_rear_right; step 8: elimination from the leaves to the root (63), upper_ball_left ..
/// tie_rod_right; step 8: elimination from the leaves to the root (63); step 8: elimination from
/// the leaves to the root (63), long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_accelerations_2(const State& state, const double* tau,
    AccelerationsWork& __restrict work) noexcept {
  // --- step 1: poses and axes b, continued ---
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s1_8 = work.cosines[5];
  const double s1_9 = work.sines[5];
  const double s1_10 = fma(R_carrier_left_aux1_y_y, s1_9, R_lower_arm_left_z_y*s1_8);
  const double s1_11 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_11;
  const double s1_12 = work.cosines[6];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_13 = work.sines[6];
  work.R_carrier_left_y_x = fma(s1_10, s1_13, work.R_carrier_left_aux1_y_x*s1_12);
  work.R_carrier_left_y_z = fnma(s1_10, s1_12, work.R_carrier_left_aux1_y_x*s1_13);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s1_14 = work.cosines[11];
  const double s1_15 = work.sines[11];
  const double s1_16 = fma(R_carrier_right_aux1_y_y, s1_15, R_lower_arm_right_z_y*s1_14);
  const double s1_17 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_17;
  const double s1_18 = work.cosines[12];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_19 = work.sines[12];
  work.R_carrier_right_y_x = fma(s1_16, s1_19, work.R_carrier_right_aux1_y_x*s1_18);
  work.R_carrier_right_y_z = fnma(s1_16, s1_18, work.R_carrier_right_aux1_y_x*s1_19);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  work.R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_9, R_carrier_left_aux1_y_y*s1_8);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  work.R_carrier_left_aux2_z_y = fma(R_lower_arm_left_y_y, s1_9, R_carrier_left_aux1_z_y*s1_8);
  work.R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_9, R_lower_arm_left_y_y*s1_8);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_11;
  const double s1_20 = R_lower_arm_left_y_y*work.R_carrier_left_aux1_y_x;
  work.s1_21 = s1_11*s1_8;
  const double s1_22 = work.R_carrier_left_aux1_z_x*work.s1_21;
  const double s1_23 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s1_22);
  const double s1_24 = work.R_carrier_left_aux1_y_x*work.s1_21;
  const double s1_25 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s1_24);
  const double s1_26 = fma(R_lower_arm_left_y_y, s1_25, R_lower_arm_left_z_y*s1_23);
  const double s1_27 = 1.0/s1_26;
  work.s1_28 = R_carrier_left_aux1_z_y*s1_27;
  work.s1_29 = R_carrier_left_aux1_y_y*s1_27;
  work.s1_30 = s1_25*s1_27;
  work.s1_31 = fma(R_lower_arm_left_z_y, work.R_carrier_left_aux1_z_x, s1_20)*s1_27;
  work.s1_32 = s1_23*s1_27;
  work.s9_4 = std::abs(s1_26);
  const double s1_33 = work.R_carrier_left_aux1_y_x*work.R_carrier_left_aux2_z_y;
  const double s1_34 = fnma(work.R_carrier_left_aux1_z_x, work.R_carrier_left_aux2_y_y, s1_33);
  work.s1_35 = s1_27*s1_34;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  work.R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_15,
      R_carrier_right_aux1_y_y*s1_14);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  work.R_carrier_right_aux2_z_y = fma(R_lower_arm_right_y_y, s1_15, R_carrier_right_aux1_z_y*s1_14);
  work.R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_15,
      R_lower_arm_right_y_y*s1_14);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_17;
  const double s1_36 = R_lower_arm_right_y_y*work.R_carrier_right_aux1_y_x;
  work.s1_37 = s1_17*s1_14;
  const double s1_38 = work.R_carrier_right_aux1_z_x*work.s1_37;
  const double s1_39 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s1_38);
  const double s1_40 = work.R_carrier_right_aux1_y_x*work.s1_37;
  const double s1_41 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s1_40);
  const double s1_42 = fma(R_lower_arm_right_y_y, s1_41, R_lower_arm_right_z_y*s1_39);
  const double s1_43 = 1.0/s1_42;
  work.s1_44 = R_carrier_right_aux1_z_y*s1_43;
  work.s1_45 = R_carrier_right_aux1_y_y*s1_43;
  work.s1_46 = s1_41*s1_43;
  work.s1_47 = fma(R_lower_arm_right_z_y, work.R_carrier_right_aux1_z_x, s1_36)*s1_43;
  work.s1_48 = s1_39*s1_43;
  work.s9_5 = std::abs(s1_42);
  const double s1_49 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s1_50 = fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y, s1_49);
  work.s1_51 = s1_43*s1_50;

  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  work.s3_1 = fnma(work.s2_14, work.s2_107, work.s2_89*work.s2_13)*work.s2_122;
  const double s2_124 = fnma(work.s2_16, work.s2_92, work.s2_90*work.s2_15);
  work.Rz_rear_axle_tz_1 = s2_124*work.s2_119*work.s2_122;
  work.s3_2 = work.s2_118*fma(work.s2_104, work.Rz_rear_axle_tz_1, s2_124);
  work.Rz_rear_axle_rz_0 = work.s2_118*(work.s2_104*work.s3_1);
  const double s3_3 = fnma(work.s2_84, work.Rz_rear_axle_rz_0, work.s2_86*work.s3_1);
  work.Rz_rear_axle_ry_0 = work.s2_102*s3_3;
  const double s8_171 = fma(work.s2_11, work.Rz_rear_axle_rz_0, work.s2_13 - work.s3_1);
  const double s8_172 = fnma(work.s2_9, work.Rz_rear_axle_ry_0, s8_171);
  const double s3_4 = fnma(work.s2_86, work.Rz_rear_axle_tz_1, work.s2_84*work.s3_2);
  work.Rz_rear_axle_ry_1 = work.s2_102*s3_4;
  const double s8_173 = fma(work.s2_12, work.s3_2, work.s2_15 + work.Rz_rear_axle_tz_1);
  const double s8_174 = fma(work.s2_10, work.Rz_rear_axle_ry_1, s8_173);
  const double s3_5 = fnma(work.s2_71, work.Rz_rear_axle_rz_0, work.s2_73*work.s3_1);
  work.Rz_rear_axle_rx_0 = work.s2_80*fnma(work.s2_67, work.Rz_rear_axle_ry_0, s3_5);
  const double s8_175 = fma(work.s2_7, work.Rz_rear_axle_ry_0, work.s2_14);
  const double s3_6 = fnma(work.s2_73, work.Rz_rear_axle_tz_1, work.s2_71*work.s3_2);
  work.Rz_rear_axle_rx_1 = work.s2_80*fnma(work.s2_67, work.Rz_rear_axle_ry_1, s3_6);
  const double s8_176 = fma(work.s2_8, work.Rz_rear_axle_ry_1, work.s2_16);
  const double s3_7 = fnma(work.s2_69, work.Rz_rear_axle_rz_0, work.s2_72*work.s3_1);
  const double s3_8 = fnma(work.s2_60, work.Rz_rear_axle_ry_0, s3_7);
  work.s3_9 = work.s2_55*fnma(work.s2_47, work.Rz_rear_axle_rx_0, s3_8);
  const double s3_10 = fnma(work.s2_72, work.Rz_rear_axle_tz_1, work.s2_69*work.s3_2);
  const double s3_11 = fnma(work.s2_60, work.Rz_rear_axle_ry_1, s3_10);
  work.s3_12 = work.s2_55*fnma(work.s2_47, work.Rz_rear_axle_rx_1, s3_11);
  const double s3_13 = fma(work.s2_41, work.Rz_rear_axle_rz_0, work.s2_39*work.s3_1);
  const double s3_14 = fma(work.s2_42, work.Rz_rear_axle_ry_0, s3_13);
  const double s3_15 = fma(work.s2_43, work.Rz_rear_axle_rx_0, s3_14);
  const double s3_16 = work.s2_42*work.Rz_rear_axle_ry_1;
  work.Rz_rear_axle_tx_0 = work.s2_44*fma(work.s2_40, work.s3_9, s3_15);
  const double s3_17 = fnma(work.s2_39, work.Rz_rear_axle_tz_1, s3_16);
  const double s8_177 = fnma(work.s2_11, work.Rz_rear_axle_rx_0, s8_175);
  const double s8_178 = work.Rz_rear_axle_tx_0 + s8_177;
  const double s3_18 = fnma(work.s2_41, work.s3_2, s3_17);
  const double s3_19 = fma(work.s2_43, work.Rz_rear_axle_rx_1, s3_18);
  work.Rz_rear_axle_tx_1 = work.s2_44*fma(work.s2_40, work.s3_12, s3_19);
  const double s8_179 = work.Rz_rear_axle_tx_1 + fma(work.s2_12, work.Rz_rear_axle_rx_1, s8_176);

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right,
  // continued ---
  const double R_arb_rear_left_x_z = work.sines[20];
  const double s7_25 = K_arb_rear_left_zz*R_arb_rear_left_x_z;
  const double R_arb_rear_left_x_x = work.cosines[20];
  const double s7_26 = K_arb_rear_left_xx*R_arb_rear_left_x_x;
  const double s7_27 = fnma(R_arb_rear_left_x_z, s7_26, R_arb_rear_left_x_x*s7_25);
  work.s7_28 = fma(R_arb_rear_left_x_x, s7_26, R_arb_rear_left_x_z*s7_25);
  const double R_arb_rear_right_x_z = work.sines[21];
  const double s7_29 = K_arb_rear_right_zz*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = work.cosines[21];
  const double s7_30 = K_arb_rear_right_xx*R_arb_rear_right_x_x;
  const double s7_31 = fnma(R_arb_rear_right_x_z, s7_30, R_arb_rear_right_x_x*s7_29);
  work.s7_32 = fma(R_arb_rear_right_x_x, s7_30, R_arb_rear_right_x_z*s7_29);

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const double s8_180 = work.Rz_rear_axle_tx_1*work.s7_19;
  const double s8_181 = fnma(work.Rz_rear_axle_tz_1, work.s7_22, s8_180);
  const double s8_182 = fnma(work.Rz_rear_axle_rx_1, work.s7_6, s8_181);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_183 = K_rear_axle_trace - work.s7_8;
  const double s8_184 = fma(work.Rz_rear_axle_ry_1, s8_183, fma(work.s3_2, work.s7_16, s8_182));
  const double s8_185 = fma(work.Rz_rear_axle_tx_0, work.s7_19, work.s3_1*work.s7_22);
  const double s8_186 = fnma(work.Rz_rear_axle_rx_0, work.s7_6, s8_185);
  const double s8_187 = fnma(work.Rz_rear_axle_rz_0, work.s7_16, s8_186);
  const double s8_188 = fma(work.Rz_rear_axle_ry_0, s8_183, s8_187);
  const double s8_189 = fma(work.s3_12, work.s7_19, work.Rz_rear_axle_tz_1*work.s7_9);
  const double s8_190 = fnma(work.Rz_rear_axle_rx_1, work.s7_18, s8_189);
  const double s8_191 = fnma(work.Rz_rear_axle_ry_1, work.s7_16, s8_190);
  const double s8_192 = fnma(work.s3_2, work.s7_23, s8_191);
  const double s8_193 = fnma(work.s3_1, work.s7_9, work.s3_9*work.s7_19);
  const double s8_194 = fnma(work.Rz_rear_axle_rx_0, work.s7_18, s8_193);
  const double s8_195 = fnma(work.Rz_rear_axle_ry_0, work.s7_16, s8_194);
  const double s8_196 = fma(work.Rz_rear_axle_rz_0, work.s7_23, s8_195);
  const double s8_197 = work.s2_61*work.Rz_rear_axle_ry_0;
  // long_rod_left
  const double s8_198 = fnma(work.s2_22, work.Rz_rear_axle_rx_0, s8_197);
  const double s8_199 = work.Rz_rear_axle_tx_0 + s8_198;
  const double s8_200 = work.s2_61*work.Rz_rear_axle_ry_1;
  const double s8_201 = fnma(work.s2_22, work.Rz_rear_axle_rx_1, s8_200);
  const double s8_202 = work.Rz_rear_axle_tx_1 + s8_201;
  const double s8_203 = fnma(work.s2_22, work.s3_2, work.Rz_rear_axle_tz_1);
  const double s8_204 = fnma(work.s2_48, work.Rz_rear_axle_ry_1, s8_203);
  const double s8_205 = fms(work.s2_22, work.Rz_rear_axle_rz_0, work.s3_1);
  const double s8_206 = fnma(work.s2_48, work.Rz_rear_axle_ry_0, s8_205);
  const double s8_207 = work.s2_48*work.Rz_rear_axle_rx_0;
  const double s8_208 = fnma(work.s2_61, work.Rz_rear_axle_rz_0, s8_207) - work.s3_9;
  const double s8_209 = fma(work.s2_48, work.Rz_rear_axle_rx_1, work.s2_61*work.s3_2);
  const double s8_210 = s8_209 - work.s3_12;
  const double s8_211 = work.s2_35*work.Rz_rear_axle_ry_0;
  // diag_rod_left
  const double s8_212 = fnma(work.s2_26, work.Rz_rear_axle_rx_0, s8_211);
  const double s8_213 = work.Rz_rear_axle_tx_0 + s8_212;
  const double s8_214 = work.s2_35*work.Rz_rear_axle_ry_1;
  const double s8_215 = fnma(work.s2_26, work.Rz_rear_axle_rx_1, s8_214);
  const double s8_216 = work.Rz_rear_axle_tx_1 + s8_215;
  const double s8_217 = fnma(work.s2_26, work.s3_2, work.Rz_rear_axle_tz_1);
  const double s8_218 = fnma(work.s2_30, work.Rz_rear_axle_ry_1, s8_217);
  const double s8_219 = fms(work.s2_26, work.Rz_rear_axle_rz_0, work.s3_1);
  const double s8_220 = fnma(work.s2_30, work.Rz_rear_axle_ry_0, s8_219);
  const double s8_221 = work.s2_30*work.Rz_rear_axle_rx_0;
  const double s8_222 = fnma(work.s2_35, work.Rz_rear_axle_rz_0, s8_221) - work.s3_9;
  const double s8_223 = fma(work.s2_30, work.Rz_rear_axle_rx_1, work.s2_35*work.s3_2);
  const double s8_224 = s8_223 - work.s3_12;
  const double s8_225 = work.s2_7*work.Rz_rear_axle_ry_1;
  const double s8_226 = fnma(work.s2_11, work.Rz_rear_axle_rx_1, s8_225);
  const double s8_227 = work.Rz_rear_axle_tx_1 + s8_226;
  const double s8_228 = fnma(work.s2_11, work.s3_2, work.Rz_rear_axle_tz_1);
  const double s8_229 = fnma(work.s2_9, work.Rz_rear_axle_ry_1, s8_228);
  const double s8_230 = work.s2_9*work.Rz_rear_axle_rx_0;
  const double s8_231 = fnma(work.s2_7, work.Rz_rear_axle_rz_0, s8_230) - work.s3_9;
  const double s8_232 = fma(work.s2_9, work.Rz_rear_axle_rx_1, work.s2_7*work.s3_2) - work.s3_12;
  // long_rod_right
  const double s8_233 = fnma(work.s2_23, work.s3_2, work.Rz_rear_axle_tz_1);
  const double s8_234 = fnma(work.s2_49, work.Rz_rear_axle_ry_1, s8_233);
  const double s8_235 = fnma(work.s2_62, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_236 = fnma(work.s2_23, work.Rz_rear_axle_rx_0, s8_235);
  const double s8_237 = work.s2_62*work.Rz_rear_axle_rz_0;
  const double s8_238 = fma(work.s2_49, work.Rz_rear_axle_rx_0, s8_237) - work.s3_9;
  const double s8_239 = fms(work.s2_23, work.Rz_rear_axle_rz_0, work.s3_1);
  const double s8_240 = fnma(work.s2_49, work.Rz_rear_axle_ry_0, s8_239);
  const double s8_241 = fnma(work.s2_62, work.s3_2, work.s2_49*work.Rz_rear_axle_rx_1);
  const double s8_242 = s8_241 - work.s3_12;
  const double s8_243 = fnma(work.s2_62, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_244 = fnma(work.s2_23, work.Rz_rear_axle_rx_1, s8_243);
  const double s8_245 = work.s2_36*work.Rz_rear_axle_ry_0;
  // diag_rod_right
  const double s8_246 = fnma(work.s2_27, work.Rz_rear_axle_rx_0, s8_245);
  const double s8_247 = work.Rz_rear_axle_tx_0 + s8_246;
  const double s8_248 = work.s2_36*work.Rz_rear_axle_ry_1;
  const double s8_249 = fnma(work.s2_27, work.Rz_rear_axle_rx_1, s8_248);
  const double s8_250 = work.Rz_rear_axle_tx_1 + s8_249;
  const double s8_251 = fnma(work.s2_27, work.s3_2, work.Rz_rear_axle_tz_1);
  const double s8_252 = fnma(work.s2_31, work.Rz_rear_axle_ry_1, s8_251);
  const double s8_253 = fms(work.s2_27, work.Rz_rear_axle_rz_0, work.s3_1);
  const double s8_254 = fnma(work.s2_31, work.Rz_rear_axle_ry_0, s8_253);
  const double s8_255 = fma(work.s2_31, work.Rz_rear_axle_rx_1, work.s2_36*work.s3_2);
  const double s8_256 = s8_255 - work.s3_12;
  const double s8_257 = work.s2_31*work.Rz_rear_axle_rx_0;
  const double s8_258 = fnma(work.s2_36, work.Rz_rear_axle_rz_0, s8_257) - work.s3_9;
  const double s8_259 = m_rear_axle_2*work.Rz_rear_axle_tx_1;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_260 = fnma(work.Rz_rear_axle_rx_1, work.s7_9, s8_259);
  const double s8_261 = fma(work.Rz_rear_axle_ry_1, work.s7_19, s8_260);
  const double s8_262 = fnma(work.s3_2, work.s7_9, m_rear_axle_2*work.Rz_rear_axle_tz_1);
  const double s8_263 = fnma(work.Rz_rear_axle_ry_1, work.s7_22, s8_262);
  const double s8_264 = fnma(m_rear_axle_2, work.s3_12, work.Rz_rear_axle_rx_1*work.s7_22);
  work.s8_265 = fma(work.s3_2, work.s7_19, s8_264);
  const double s8_266 = fnma(work.Rz_rear_axle_tx_1, work.s7_9, work.s3_2*work.s7_18);
  const double s8_267 = fnma(work.s3_12, work.s7_22, s8_266);
  const double s8_268 = K_rear_axle_trace - work.s7_24;
  const double s8_269 = fnma(work.Rz_rear_axle_ry_1, work.s7_6, s8_267);
  const double s8_270 = fma(work.Rz_rear_axle_rx_1, s8_268, s8_269);
  const double s8_271 = fnma(work.Rz_rear_axle_tx_0, work.s7_9, work.Rz_rear_axle_rx_0*s8_268);
  const double s8_272 = fnma(work.s3_9, work.s7_22, s8_271);
  const double s8_273 = fnma(work.Rz_rear_axle_ry_0, work.s7_6, s8_272);
  const double s8_274 = fnma(work.Rz_rear_axle_rz_0, work.s7_18, s8_273);
  const double s8_275 = fma(s8_210, s8_210, fma(s8_204, s8_204, s8_202*s8_202));
  const double s8_276 = fma(work.Rz_rear_axle_tx_1, s8_261, 0.4225);
  const double s8_277 = fma(work.Rz_rear_axle_tz_1, s8_263, s8_276);
  const double s8_278 = fnma(work.s3_2, s8_192, fnma(work.s3_12, work.s8_265, s8_277));
  const double s8_279 = fma(work.Rz_rear_axle_ry_1, s8_184, s8_278);
  const double s8_280 = fma(s8_242, s8_242, fma(s8_244, s8_244, fma(s8_234, s8_234, s8_275)));
  const double s8_281 = fma(s8_224, s8_224, fma(s8_218, s8_218, s8_216*s8_216));
  const double s8_282 = fma(s8_256, s8_256, fma(s8_252, s8_252, fma(s8_250, s8_250, s8_281)));
  const double s8_283 = fnma(3.0, s8_280, fma(work.Rz_rear_axle_rx_1, s8_270, s8_279));
  const double s8_284 = fnma(work.s2_10, work.Rz_rear_axle_rx_1, work.s2_8*work.s3_2);
  const double s8_285 = s8_284 - work.s3_12;
  const double s8_286 = fma(s8_232, s8_232, fma(s8_229, s8_229, s8_227*s8_227));
  const double s8_287 = fma(s8_174, s8_174, fma(s8_179, s8_179, fma(s8_285, s8_285, s8_286)));
  const double s8_288 = fnma(2.6666666666666665, s8_282, s8_283);
  work.pivot_arb_rear_right = fnma(0.3333333333333333, s8_287, s8_288);
  const double s8_289 = fma(p_arb_rear_right_z, work.s8_114, -p_arb_rear_right_x*work.s8_41);
  const double s7_33 = -K_arb_rear_right_xy*R_arb_rear_right_x_z;
  const double s7_34 = -K_arb_rear_right_xy*R_arb_rear_right_x_x;
  const double s8_290 = fnma(s7_33, work.s8_69, tau[Coordinate::arb_rear_right]);
  work.s7_35 = h_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s8_291 = fma(p_arb_rear_right_y, work.s8_69, s8_289);
  const double s8_292 = fma(p_arb_rear_right_x, work.s8_114, -p_arb_rear_right_z*work.s8_40);
  work.s7_36 = h_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s8_293 = fma(work.s7_35, s8_291, fnma(s7_34, work.s8_77, s8_290));
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_294 = fma(z_rear_axle_ty, s8_263, fnma(p_arb_rear_right_y, work.s7_36, s7_34));
  const double s8_295 = 3.0*work.s2_24;
  const double s8_296 = s8_192 + fnma(work.r_rear_axle_aux3_z, work.s8_265, s8_294);
  const double s8_297 = fms(work.r_rear_axle_aux1_x, work.s8_265, s7_33);
  const double s8_298 = fma(p_arb_rear_right_y, work.s7_35, s8_297);
  const double s8_299 = fma(p_arb_rear_right_x, work.s7_36, 0.4225);
  const double s8_300 = fnma(p_arb_rear_right_z, work.s7_35, s8_299);
  const double s8_301 = fma(work.r_rear_axle_aux3_z, s8_261, s8_300);
  const double s8_302 = 3.0*work.s2_51;
  const double s8_303 = fnma(s8_295, s8_202, s8_270 + fnma(z_rear_axle_ty, s8_261, s8_298));
  const double s8_304 = s8_184 + fnma(work.r_rear_axle_aux1_x, s8_263, s8_301);
  const double s8_305 = 3.0*work.s2_64;
  work.s8_306 = work.s8_40 - work.s8_41;
  const double s8_307 = fma(work.s7_36, fma(p_arb_rear_right_y, work.s8_77, s8_292), s8_293);
  const double s8_308 = fnma(s8_202, work.s8_132, fnma(s7_31, work.s8_306, s8_307));
  const double s8_309 = fnma(s8_210, work.s8_87, fnma(s8_204, work.s8_133, s8_308));
  const double s8_310 = fma(s8_210, s8_208, fma(s8_204, s8_206, s8_199*s8_202));
  const double s8_311 = fnma(s8_218, work.s8_136, fnma(s8_216, work.s8_135, s8_309));
  const double s8_312 = fnma(s8_229, work.s8_138, fnma(s8_224, work.s8_88, s8_311));
  const double s8_313 = fnma(s8_232, work.s8_89, fnma(s8_227, work.s8_140, s8_312));
  const double s8_314 = fnma(s8_234, work.s8_141, fnma(s8_242, work.s8_90, s8_313));
  const double s8_315 = fnma(s8_256, work.s8_92, fnma(s8_244, work.s8_142, s8_314));
  const double s8_316 = fnma(s8_250, work.s8_144, fnma(s8_252, work.s8_143, s8_315));
  const double s8_317 = fnma(s8_174, work.s8_145, fnma(s8_285, work.s8_93, s8_316));
  work.s8_318 = fnma(s8_179, work.s8_146, s8_317);
  const double s7_37 = K_arb_rear_left_xy*R_arb_rear_left_x_x;
  const double s7_38 = K_arb_rear_left_xy*R_arb_rear_left_x_z;
  const double s8_319 = fma(s7_38, work.s8_69, tau[Coordinate::arb_rear_left]);
  work.s7_39 = h_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s8_320 = fnma(s7_27, work.s8_306, fma(s7_37, work.s8_77, s8_319));
  work.s7_40 = h_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s8_321 = fma(work.s7_39, fnma(p_arb_rear_right_y, work.s8_69, s8_289), s8_320);
  const double s8_322 = fma(work.s7_40, fnma(p_arb_rear_right_y, work.s8_77, s8_292), s8_321);
  const double s8_323 = fnma(s8_206, work.s8_133, fnma(s8_199, work.s8_132, s8_322));
  const double s8_324 = fnma(s8_213, work.s8_135, fnma(s8_208, work.s8_87, s8_323));
  const double s8_325 = fnma(s8_222, work.s8_88, fnma(s8_220, work.s8_136, s8_324));
  const double s8_326 = fnma(s8_178, work.s8_140, fnma(s8_172, work.s8_138, s8_325));
  const double s8_327 = fnma(s8_238, work.s8_90, fnma(s8_231, work.s8_89, s8_326));
  const double s8_328 = fnma(s8_236, work.s8_142, fnma(s8_240, work.s8_141, s8_327));
  const double s8_329 = fnma(s8_254, work.s8_143, fnma(s8_258, work.s8_92, s8_328));
  const double s8_330 = m_rear_axle_2*work.Rz_rear_axle_tx_0;
  const double s8_331 = fnma(work.Rz_rear_axle_rx_0, work.s7_9, s8_330);
  const double s8_332 = fma(work.Rz_rear_axle_ry_0, work.s7_19, s8_331);
  const double s8_333 = fnma(m_rear_axle_2, work.s3_1, work.Rz_rear_axle_rz_0*work.s7_9);
  const double s8_334 = fnma(work.Rz_rear_axle_ry_0, work.s7_22, s8_333);
  const double s8_335 = fnma(m_rear_axle_2, work.s3_9, work.Rz_rear_axle_rx_0*work.s7_22);
  work.s8_336 = fnma(work.Rz_rear_axle_rz_0, work.s7_19, s8_335);
  const double s8_337 = fnma(z_rear_axle_ty, s8_332, fma(p_arb_rear_left_y, work.s7_39, s7_38));
  const double s8_338 = s8_274 + fma(work.r_rear_axle_aux1_x, work.s8_336, s8_337);
  const double s8_339 = fma(p_arb_rear_left_x, work.s7_40, 0.4225);
  const double s8_340 = fnma(p_arb_rear_left_z, work.s7_39, s8_339);
  const double s8_341 = fma(work.r_rear_axle_aux3_z, s8_332, s8_340);
  const double s8_342 = s8_188 + fnma(work.r_rear_axle_aux1_x, s8_334, s8_341);
  const double s8_343 = fma(s8_208, s8_208, fma(s8_206, s8_206, s8_199*s8_199));
  const double s8_344 = fnma(p_arb_rear_left_y, work.s7_40, fms(z_rear_axle_ty, s8_334, s7_37));
  const double s8_345 = s8_196 + fnma(work.r_rear_axle_aux3_z, work.s8_336, s8_344);
  const double s8_346 = fma(593.0, z_rear_axle_ty, work.s7_9);
  work.s8_347 = fma(m_rear_axle_2, z_rear_axle_ty, work.s7_9);
  const double s8_348 = fma(s8_346, z_rear_axle_ty + z_rear_axle_ty, work.s7_8);
  const double s8_349 = fma(593.0, work.r_rear_axle_aux1_x, work.s7_22);
  const double s8_350 = fma(work.r_rear_axle_aux1_x, s8_346, work.s7_16);
  const double s8_351 = work.r_rear_axle_aux1_x + work.r_rear_axle_aux1_x;
  const double s8_352 = fma(593.0, work.r_rear_axle_aux3_z, work.s7_19);
  work.s8_353 = fma(m_rear_axle_2, work.r_rear_axle_aux3_z, work.s7_19);
  const double s8_354 = fma(z_rear_axle_ty, s8_352, work.s7_6);
  const double s8_355 = fma(work.r_rear_axle_aux1_x, s8_352, work.s7_18);
  const double s8_356 = work.r_rear_axle_aux3_z + work.r_rear_axle_aux3_z;
  const double s1_6 = work.sines[2];
  const double s1_7 = work.cosines[2];
  const double s1_52 = fma(s1_7, work.R_chassis_z_z, s1_6*work.R_chassis_z_y);
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  work.s8_357 = zd_arb_rear_right*(zd_arb_rear_right + work.s8_94);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  work.s8_358 = zd_arb_rear_left*(zd_arb_rear_left + work.s8_94);
  const double s1_53 = 1.0/s1_52;
  work.s1_54 = s1_7*s1_53;
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  const double s1_55 = work.sines[1];
  work.s1_56 = s1_55*s1_7;
  work.s1_57 = work.s1_56*s1_53;
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  const double s8_359 = fnma(s1_6, tau_chassis_ry, tau_chassis_rz*work.s1_54);
  const double s8_360 = zd_arb_rear_right*work.s8_64;
  const double s8_361 = fma(s7_34, work.s8_357, fma(tau_chassis_rx, work.s1_57, s8_359));
  const double s8_362 = zd_arb_rear_right*work.s8_57;
  const double s8_363 = fnma(work.s7_32, s8_362, fnma(s7_31, s8_360, s8_361));

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  work.s8_364 = 11.55 + s7_37 - s7_34;
  const double s8_365 = zd_arb_rear_left*work.s8_64;
  const double s8_366 = zd_arb_rear_left*work.s8_57;

  // --- step 8: elimination from the leaves to the root (63), continued ---
  const double s8_367 = fnma(s7_27, s8_365, fnma(s7_37, work.s8_358, s8_363));
  const double s8_368 = fnma(work.s7_28, s8_366, s8_367);
  const double s8_369 = fma(z_rear_axle_ty, work.f_rear_axle_x, s8_368);
  const double s8_370 = fnma(work.r_rear_axle_aux1_x, work.f_rear_axle_y, s8_369);
  const double s8_371 = fnma(work.s2_24, work.s8_132, s8_370 - work.n_rear_axle_z);
  const double s8_372 = fnma(work.s2_28, work.s8_135, fnma(work.s2_51, work.s8_87, s8_371));
  const double s8_373 = fnma(work.s2_106, work.s8_140, fnma(work.s2_33, work.s8_88, s8_372));
  const double s8_374 = fnma(work.s2_52, work.s8_90, fma(work.s2_107, work.s8_89, s8_373));
  const double s8_375 = fma(work.s2_74, work.s8_142, s8_374);
  const double s8_376 = fnma(work.pivot_rear_axle_tx, work.s8_92, s8_375);
  const double s8_377 = fma(work.s2_92, work.s8_93, fma(work.s2_40, work.s8_144, s8_376));
  work.s8_378 = fma(work.s2_91, work.s8_146, s8_377);
  work.s1_58 = s1_6*s1_53;
  work.s1_59 = s1_55*s1_6;
  work.s1_60 = work.s1_59*s1_53;
  work.s1_61 = s1_52*s1_53;
  const double s8_379 = fma(tau_chassis_rz, work.s1_58, s1_7*tau_chassis_ry);
  work.s9_6 = fms(s1_52, s1_52, 1e-12);
  const double s8_380 = fma(tau_chassis_rx, work.s1_60, s8_379);
  const double s8_381 = fnma(work.r_rear_axle_aux3_z, work.f_rear_axle_x, s8_380);
  const double s8_382 = fma(work.r_rear_axle_aux1_x, work.f_rear_axle_z, s8_381);
  // chassis: chassis_rx, revolute, chassis_aux5
  work.s8_383 = work.s7_22 + fma(m_rear_axle_2, work.r_rear_axle_aux1_x, 1580.4);
  const double s8_384 = fnma(work.s2_64, work.s8_132, s8_382 - work.n_rear_axle_y);
  const double s8_385 = fnma(work.s2_38, work.s8_135, fma(work.s2_51, work.s8_133, s8_384));
  const double s8_386 = fnma(work.s2_107, work.s8_138, fma(work.s2_33, work.s8_136, s8_385));
  const double s8_387 = fma(work.s2_52, work.s8_141, fnma(work.s2_89, work.s8_140, s8_386));
  const double s8_388 = fnma(work.s2_65, work.s8_142, s8_387);
  const double s8_389 = fma(work.pivot_rear_axle_tx, work.s8_143, s8_388);
  const double s8_390 = fnma(work.s2_92, work.s8_145, fnma(work.s2_39, work.s8_144, s8_389));
  work.s8_391 = fnma(work.s2_90, work.s8_146, s8_390);
  work.s8_392 = fnma(work.s7_35, s8_360, work.s7_36*s8_362);
  work.s8_393 = s7_33 - 1.05 - s7_38;
  work.s7_41 = 0.4225 - work.s7_32;
  const double s8_394 = fma(s7_33, work.s8_357, tau_chassis_rx*work.s1_61);
  const double s8_395 = fma(s7_31, s8_362, fma(work.s7_41, s8_360, s8_394));
  work.s8_396 = fnma(work.s7_39, s8_365, work.s7_40*s8_366);
  work.s7_42 = 0.4225 - work.s7_28;
  const double s8_397 = fma(work.s7_42, s8_365, fnma(s7_38, work.s8_358, s8_395));
  const double s8_398 = fma(s7_27, s8_366, s8_397);
  work.s8_399 = s7_31 + (s7_27 - 70.9875);
  const double s8_400 = fma(work.r_rear_axle_aux3_z, work.f_rear_axle_y, s8_398);
  const double s8_401 = fnma(z_rear_axle_ty, work.f_rear_axle_z, s8_400) - work.n_rear_axle_x;
  const double s8_402 = fma(work.s2_64, work.s8_87, fma(work.s2_24, work.s8_133, s8_401));
  const double s8_403 = fma(work.s2_38, work.s8_88, fma(work.s2_28, work.s8_136, s8_402));
  const double s8_404 = fma(work.s2_89, work.s8_89, fma(work.s2_106, work.s8_138, s8_403));
  const double s8_405 = fnma(work.s2_74, work.s8_141, fma(work.s2_65, work.s8_90, s8_404));
  const double s8_406 = fnma(work.s2_40, work.s8_143, fma(work.s2_39, work.s8_92, s8_405));
  work.s8_407 = fnma(work.s2_91, work.s8_145, fma(work.s2_90, work.s8_93, s8_406));
  const double s8_408 = 2.6666666666666665*work.s2_28;
  const double s8_409 = fma(work.s2_64, s8_295, fma(work.r_rear_axle_aux3_z, s8_346, s8_354));
  const double s8_410 = 2.6666666666666665*work.s2_38;
  const double s8_411 = fma(s8_408, s8_218, fma(s8_210, s8_305, fma(s8_295, s8_204, s8_296)));
  const double s8_412 = fma(s8_408, s8_220, fma(s8_208, s8_305, fma(s8_295, s8_206, s8_345)));
  const double s8_413 = fnma(work.s2_64, s8_305, fma(s8_352, s8_356, work.s7_24));
  const double s8_414 = 0.3333333333333333*work.s2_106;
  const double s8_415 = fnma(work.s2_28, s8_408, fnma(work.s2_24, s8_295, s8_348));
  const double s8_416 = 0.3333333333333333*work.s2_89;
  const double s8_417 = 3.0*work.s2_74;
  const double s8_418 = fma(s8_232, s8_416, fma(s8_414, s8_229, fma(s8_224, s8_410, s8_411)));
  const double s8_419 = fma(work.s2_89, s8_414, fma(work.s2_38, s8_408, s8_409));
  const double s8_420 = 3.0*work.s2_65;
  const double s8_421 = fma(s8_414, s8_172, fma(s8_231, s8_416, fma(s8_222, s8_410, s8_412)));
  const double s8_422 = fnma(work.s2_89, s8_416, fnma(work.s2_38, s8_410, s8_413));
  const double s8_423 = 2.6666666666666665*work.s2_33;
  const double s8_424 = fnma(s8_408, s8_213, fnma(s8_302, s8_208, fnma(s8_295, s8_199, s8_338)));
  const double s8_425 = fnma(work.s2_51, s8_302, fma(s8_349, s8_351, work.s7_21));
  const double s8_426 = fnma(work.s2_64, s8_302, fma(work.r_rear_axle_aux3_z, s8_349, s8_355));
  const double s8_427 = fma(work.s2_24, s8_302, fma(z_rear_axle_ty, s8_349, s8_350));

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const double s8_428 = fnma(s8_423, s8_224, fnma(s8_408, s8_216, fnma(s8_302, s8_210, s8_303)));
  const double s8_429 = fma(s8_423, s8_218, fnma(s8_202, s8_305, fma(s8_302, s8_204, s8_304)));
  const double s8_430 = fma(s8_423, s8_220, fnma(s8_199, s8_305, fma(s8_302, s8_206, s8_342)));
  const double s8_431 = fma(s8_218, s8_220, fma(s8_224, s8_222, s8_213*s8_216));
  const double s8_432 = fma(s8_220, s8_220, fma(s8_222, s8_222, s8_213*s8_213));
  const double s8_433 = 0.3333333333333333*work.s2_107;
  const double s8_434 = fnma(s8_433, s8_172, fnma(s8_416, s8_178, fnma(s8_213, s8_410, s8_430)));
  const double s8_435 = fnma(s8_414, s8_178, fma(s8_433, s8_231, fnma(s8_423, s8_222, s8_424)));
  const double s8_436 = 3.0*work.s2_52;
  const double s8_437 = fma(s8_417, s8_244, fma(s8_433, s8_232, fnma(s8_414, s8_227, s8_428)));
  const double s8_438 = fnma(s8_227, s8_416, fnma(s8_433, s8_229, fnma(s8_216, s8_410, s8_429)));
  const double s8_439 = fnma(work.s2_107, s8_433, fnma(work.s2_33, s8_423, s8_425));
  const double s8_440 = fma(work.s2_89, s8_433, fnma(work.s2_38, s8_423, s8_426));
  const double s8_441 = fnma(work.s2_106, s8_433, fma(work.s2_28, s8_423, s8_427));
  const double s8_442 = work.s2_8*work.Rz_rear_axle_rz_0;
  const double s8_443 = work.s3_9 + fma(work.s2_10, work.Rz_rear_axle_rx_0, s8_442);
  const double s8_444 = work.s2_8*work.Rz_rear_axle_ry_0;
  const double s8_445 = fma(s8_172, s8_172, fma(s8_178, s8_178, s8_231*s8_231));
  const double s8_446 = fma(s8_229, s8_172, fma(s8_227, s8_178, s8_232*s8_231));
  const double s8_447 = fms(work.s2_10, work.Rz_rear_axle_ry_0, work.s3_1);
  const double s8_448 = fnma(work.s2_12, work.Rz_rear_axle_rz_0, s8_447);
  const double s8_449 = work.Rz_rear_axle_tx_0 + fma(work.s2_12, work.Rz_rear_axle_rx_0, s8_444);
  const double s8_450 = fma(s8_443, work.s8_93, fnma(s8_247, work.s8_144, s8_329));
  work.s8_451 = fnma(s8_449, work.s8_146, fnma(s8_448, work.s8_145, s8_450));
  const double s8_452 = 2.6666666666666665*work.s2_40;
  const double s8_453 = fnma(work.s2_74, s8_417, fnma(work.s2_106, s8_414, s8_415));
  const double s8_454 = 2.6666666666666665*work.s2_39;
  const double s8_455 = fnma(s8_452, s8_252, fma(s8_420, s8_242, fnma(s8_417, s8_234, s8_418)));
  const double s8_456 = fma(s8_454, s8_258, fnma(s8_417, s8_240, fma(s8_420, s8_238, s8_421)));
  const double s8_457 = 2.6666666666666665*work.pivot_rear_axle_tx;
  const double s8_458 = fnma(s8_454, s8_250, fnma(s8_420, s8_244, fma(s8_436, s8_234, s8_438)));
  const double s8_459 = fma(s8_452, s8_247, fnma(s8_436, s8_238, fma(s8_417, s8_236, s8_435)));
  const double s8_460 = fnma(s8_454, s8_247, fma(s8_436, s8_240, fnma(s8_420, s8_236, s8_434)));
  const double s2_125 = 1.2494533266510743*std::abs(work.pivot_rear_axle_tx);
  const double s2_126 = mbgen::min(mbgen::min(s2_125, work.s2_57), work.s2_87);
  const double s2_127 = mbgen::min(mbgen::min(s2_126, work.s2_105), work.s2_121);
  work.s2_128 = mbgen::min(s2_127, work.s2_123);
  const double s8_461 = 0.3333333333333333*work.s2_91;
  work.s8_462 = fnma(work.s2_91, s8_461, fnma(work.s2_40, s8_452, s8_453));
  const double s8_463 = fnma(work.s2_39, s8_452, fnma(work.s2_65, s8_417, s8_419));
  work.s8_464 = fnma(work.s2_90, s8_461, s8_463);
  const double s8_465 = 0.3333333333333333*work.s2_90;
  work.s8_466 = fma(s8_285, s8_465, fnma(s8_174, s8_461, fma(s8_454, s8_256, s8_455)));
  const double s8_467 = fnma(work.s2_39, s8_454, fnma(work.s2_65, s8_420, s8_422));
  work.s8_468 = fnma(work.s2_90, s8_465, s8_467);
  work.s8_469 = fnma(s8_461, s8_448, fnma(s8_465, s8_443, fnma(s8_452, s8_254, s8_456)));
  const double s8_470 = 0.3333333333333333*work.s2_92;
  const double s8_471 = fnma(s8_457, s8_256, fma(s8_452, s8_250, fnma(s8_436, s8_242, s8_437)));
  work.s8_472 = fnma(s8_470, s8_448, fnma(s8_465, s8_449, fma(s8_457, s8_254, s8_460)));
  const double s8_473 = fnma(work.pivot_rear_axle_tx, s8_457, fnma(work.s2_52, s8_436, s8_439));
  work.s8_474 = fnma(work.s2_92, s8_470, s8_473);
  const double s8_475 = fnma(work.s2_39, s8_457, fnma(work.s2_65, s8_436, s8_440));
  work.s8_476 = fma(work.s2_90, s8_470, s8_475);
  const double s8_477 = fnma(work.s2_40, s8_457, fnma(work.s2_74, s8_436, s8_441));
  work.s8_478 = fma(work.s2_91, s8_470, s8_477);
  work.s8_479 = fma(s8_179, s8_461, fma(s8_285, s8_470, s8_471));
  work.s8_480 = fnma(s8_179, s8_465, fnma(s8_174, s8_470, fma(s8_457, s8_252, s8_458)));
  work.s8_481 = fma(s8_461, s8_449, fnma(s8_470, s8_443, fnma(s8_457, s8_258, s8_459)));
  work.s8_482 = s8_332 - work.s7_39;
  const double s8_483 = fnma(work.s3_1, s8_334, fma(work.Rz_rear_axle_tx_0, s8_332, 0.4225));
  work.s8_484 = s8_334 - work.s7_40;
  const double s8_485 = fnma(work.s3_9, work.s8_336, s8_483);
  const double s8_486 = fma(work.Rz_rear_axle_rx_0, s8_274, s8_485);
  const double s8_487 = fma(work.Rz_rear_axle_ry_0, s8_188, s8_486);
  const double s8_488 = fma(s8_240, s8_240, fma(s8_238, s8_238, fma(s8_236, s8_236, s8_343)));
  const double s8_489 = fma(s8_254, s8_254, fma(s8_258, s8_258, fma(s8_247, s8_247, s8_432)));
  const double s8_490 = fnma(3.0, s8_488, fma(work.Rz_rear_axle_rz_0, s8_196, s8_487));
  const double s8_491 = fma(s8_448, s8_448, fma(s8_449, s8_449, fma(s8_443, s8_443, s8_445)));
  const double s8_492 = fnma(2.6666666666666665, s8_489, s8_490);
  work.s8_493 = fnma(0.3333333333333333, s8_491, s8_492);
  work.s8_494 = s8_261 - work.s7_35;
  work.s8_495 = s8_263 - work.s7_36;
  const double s8_496 = fnma(work.s3_1, s8_263, work.Rz_rear_axle_tx_0*s8_261);
  const double s8_497 = fnma(work.s3_9, work.s8_265, s8_496);
  const double s8_498 = fma(work.Rz_rear_axle_rz_0, s8_192, s8_497);
  const double s8_499 = fma(work.Rz_rear_axle_ry_0, s8_184, s8_498);
  const double s8_500 = fma(s8_238, s8_242, fma(s8_234, s8_240, fma(s8_236, s8_244, s8_310)));
  const double s8_501 = fma(s8_252, s8_254, fma(s8_256, s8_258, fma(s8_247, s8_250, s8_431)));
  const double s8_502 = fnma(3.0, s8_500, fma(work.Rz_rear_axle_rx_0, s8_270, s8_499));
  const double s8_503 = fma(s8_174, s8_448, fma(s8_179, s8_449, fnma(s8_285, s8_443, s8_446)));
  const double s8_504 = fnma(2.6666666666666665, s8_501, s8_502);
  work.s8_505 = fnma(0.3333333333333333, s8_503, s8_504);
}

/// Part 3 of compute_accelerations: step 1: poses and axes b; step 7: inertias of the bodies and
/// forces on joints; step 8: elimination from the leaves to the root (63), long_rod_left ..
/// arb_link_rear_right; step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left ..
/// tie_rod_right; step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right; step 2: closure
/// Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right; step 6: c and dRz/dt zd
/// (62), upper_ball_left .. tie_rod_right; step 2: closure Jacobian Phi_z and its factors (60),
/// upper_ball_left .. tie_rod_right; step 3: Rz (61), upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_3(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 1: poses and axes b, continued ---
  const double s1_62 = 1.0/work.s1_5;
  work.s1_63 = work.R_rear_axle_aux5_y_z*s1_62;
  work.s1_64 = work.R_rear_axle_aux5_x_z*s1_62;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.s1_65 = R_rear_axle_aux4_y_x*s1_62;
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s8_506 = fma(tau_rear_axle_rx, work.s1_65, R_rear_axle_aux4_x_x*tau_rear_axle_ry);
  const double s8_507 = fma(tau_rear_axle_rz, work.s1_63, s8_506) - work.n_rear_axle_y;
  const double tau_rear_axle_tz = tau[Coordinate::rear_axle_tz];
  const double s8_508 = tau_rear_axle_tz - work.f_rear_axle_z;
  work.s1_66 = R_rear_axle_aux4_x_x*s1_62;
  work.s1_67 = work.s1_5*s1_62;
  const double s8_509 = fms(tau_rear_axle_rz, work.s1_67, work.n_rear_axle_z);
  const double s8_510 = fma(work.Rz_rear_axle_ry_0, s8_507, work.s8_451);
  result.pivot[1] = mbgen::min(work.s2_128, std::abs(work.s1_5));

  // --- step 7: inertias of the bodies and forces on joints ---
  const double s7_43 = tau_rear_axle_rx*work.s1_66;
  const double s7_44 = fnma(R_rear_axle_aux4_y_x, tau_rear_axle_ry, s7_43);
  const double s7_45 = fma(tau_rear_axle_rz, work.s1_64, s7_44);

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const double s8_511 = fma(work.Rz_rear_axle_tz_1, s8_508, work.s8_318);
  const double s8_512 = fma(work.s3_2, work.n_rear_axle_x - s7_45, s8_511);
  const double s8_513 = fma(work.Rz_rear_axle_ry_1, s8_507, s8_512);
  const double s8_514 = work.f_rear_axle_y - tau[Coordinate::rear_axle_ty];
  const double s8_515 = tau[Coordinate::rear_axle_tx] - work.f_rear_axle_x;
  const double s8_516 = fma(work.s3_12, s8_514, fma(work.Rz_rear_axle_rx_1, s8_509, s8_513));
  const double s8_517 = fma(work.s3_9, s8_514, fma(work.Rz_rear_axle_rx_0, s8_509, s8_510));
  const double s8_518 = fma(work.Rz_rear_axle_tx_1, s8_515, s8_516);
  work.s8_519 = fma(work.s8_114, work.s7_32 - work.s7_41, s8_518);
  work.s8_520 = 1.0/work.pivot_arb_rear_right;
  result.inertia[12] = work.pivot_arb_rear_right - 1.5272999999999997e-20;
  const double s8_521 = work.s8_505*work.s8_520;
  work.s8_522 = fnma(work.s8_265, s8_521, work.s8_336);
  work.s8_523 = fnma(work.s8_494, s8_521, work.s8_482);
  work.s8_524 = fnma(work.s8_495, s8_521, work.s8_484);
  work.s8_525 = fnma(work.s8_479, s8_521, work.s8_481);
  work.s8_526 = fnma(work.s8_466, s8_521, work.s8_469);
  work.s8_527 = fnma(work.s8_480, s8_521, work.s8_472);
  work.pivot_arb_rear_left = fnma(work.s8_505, s8_521, work.s8_493);
  const double s8_528 = fnma(work.s8_519, s8_521, fma(work.Rz_rear_axle_tx_0, s8_515, s8_517));
  const double s8_529 = fma(work.s3_1, work.f_rear_axle_z - tau_rear_axle_tz, s8_528);
  const double s8_530 = fma(work.Rz_rear_axle_rz_0, s7_45 - work.n_rear_axle_x, s8_529);
  work.s8_531 = fma(work.s8_114, work.s7_28 - work.s7_42, s8_530);
  work.s8_532 = work.s7_41 + (10856.945 + work.s7_42);
  work.s8_533 = work.s7_32 + (141129.72 + work.s7_28);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux2_x_z = work.sines[4]*work.sines[5];
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s1_12 = work.cosines[6];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_13 = work.sines[6];
  work.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_13, R_carrier_left_aux1_x_x*s1_12);
  work.R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_13, R_carrier_left_aux2_x_z*s1_12);

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right ---
  const double s2_129 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s2_130 = work.s1_21 + work.R_carrier_left_x_z;
  work.s2_131 = fnma(p_arb_link_front_left_to_y, s2_130, s2_129);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_68 = work.R_carrier_left_aux1_z_x*s1_12;
  work.R_carrier_left_z_x = fnma(work.R_carrier_left_aux2_z_z, s1_13, s1_68);
  const double s1_69 = work.R_carrier_left_aux2_z_z*s1_12;
  work.R_carrier_left_z_z = fma(work.R_carrier_left_aux1_z_x, s1_13, s1_69);
  const double s2_132 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s2_133 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s2_134 = fnma(p_arb_link_front_left_to_y, s2_132, s2_133);
  const double s2_135 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s2_136 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s2_137 = fnma(p_arb_link_front_left_to_y, s2_135, s2_136);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux2_x_z = work.sines[10]*work.sines[11];
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s1_18 = work.cosines[12];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_19 = work.sines[12];
  work.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_19, R_carrier_right_aux1_x_x*s1_18);
  work.R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_19, R_carrier_right_aux2_x_z*s1_18);
  const double s2_138 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s2_139 = work.R_carrier_right_x_z - work.s1_37;
  work.s2_140 = fnma(p_arb_link_front_left_to_y, s2_139, s2_138);
  const double s1_70 = work.R_carrier_right_aux1_z_x*s1_18;
  work.R_carrier_right_z_x = fnma(work.R_carrier_right_aux2_z_z, s1_19, s1_70);
  const double s1_71 = work.R_carrier_right_aux2_z_z*s1_18;
  work.R_carrier_right_z_z = fma(work.R_carrier_right_aux1_z_x, s1_19, s1_71);
  const double s2_141 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s2_142 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s2_143 = fnma(p_arb_link_front_left_to_y, s2_141, s2_142);
  const double s2_144 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s2_145 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s2_146 = fnma(p_arb_link_front_left_to_y, s2_144, s2_145);
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s1_72 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  work.s1_73 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_72);
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s2_147 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s2_148 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s2_147);
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  work.s4_14 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  work.s4_15 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  work.s4_16 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.s4_17 = zd_carrier_left_ry*work.s1_21;
  work.s4_18 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  work.s4_19 = work.s4_14 + work.s4_16;
  work.s4_20 = work.s4_18 + work.s4_19;
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s4_21 = zd_lower_arm_left + work.s4_15;
  work.s4_22 = work.s4_21 - work.s4_17;

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  const double s6_90 = fnma(work.s4_22, work.s2_134, work.s4_20*work.s2_131);
  work.s4_23 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  work.s4_24 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  work.s4_25 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.s4_26 = work.s4_24 - work.s4_23;
  work.s4_27 = work.s4_25 + work.s4_26;
  const double s6_91 = fnma(work.s4_27, work.s2_131, work.s4_22*work.s2_137);
  work.s4_28 = zd_lower_arm_left*work.s1_73;
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s6_92 = zd_arb_front_left*work.s2_148;
  work.s6_93 = s6_91 + (work.s4_28 + s6_92);
  work.s6_94 = fma(work.s4_27, s6_91, fnma(work.s4_20, s6_90, zd_arb_front_left*s6_92));
  const double s6_95 = fnma(work.s4_20, work.s2_137, work.s4_27*work.s2_134);
  const double s6_96 = zd_lower_arm_left*zd_lower_arm_left;
  work.s6_97 = work.s1_73*s6_96;
  work.s6_98 = fnma(work.s4_22, s6_91, fms(work.s4_20, s6_95, work.s6_97));
  const double s1_74 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_75 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_74);
  const double s2_149 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  work.s2_150 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s2_149);
  work.s6_99 = work.s1_75*s6_96;
  work.s8_534 = fma(zd_lower_arm_left, work.s8_57, s6_96);
  const double s6_100 = zd_arb_front_left*work.s2_150;
  work.s6_101 = s6_100 - s6_95;
  const double s6_102 = fma(work.s4_22, s6_90, fms(zd_arb_front_left, s6_100, work.s6_99));
  work.s6_103 = fnma(work.s4_27, s6_95, s6_102);
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_76 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  work.s1_77 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_76);
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s2_151 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s2_152 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s2_151);
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  work.s4_29 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  work.s4_30 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  work.s4_31 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.s4_32 = zd_carrier_right_ry*work.s1_37;
  work.s4_33 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.s4_34 = work.s4_29 + work.s4_31;
  work.s4_35 = work.s4_33 + work.s4_34;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s4_36 = zd_lower_arm_right + work.s4_30;
  work.s4_37 = work.s4_36 - work.s4_32;
  const double s6_104 = fnma(work.s4_37, work.s2_143, work.s4_35*work.s2_140);
  work.s4_38 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  work.s4_39 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  work.s4_40 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.s4_41 = work.s4_39 - work.s4_38;
  work.s4_42 = work.s4_40 + work.s4_41;
  const double s6_105 = fnma(work.s4_42, work.s2_140, work.s4_37*work.s2_146);
  work.s4_43 = zd_lower_arm_right*work.s1_77;
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s6_106 = zd_arb_front_right*work.s2_152;
  work.s6_107 = s6_105 + (work.s4_43 + s6_106);
  const double s6_108 = fnma(work.s4_35, s6_104, zd_arb_front_right*s6_106);
  work.s6_109 = fma(work.s4_42, s6_105, s6_108);
  const double s6_110 = fnma(work.s4_35, work.s2_146, work.s4_42*work.s2_143);
  const double s6_111 = zd_lower_arm_right*zd_lower_arm_right;
  work.s6_112 = work.s1_77*s6_111;
  work.s6_113 = fnma(work.s4_37, s6_105, fms(work.s4_35, s6_110, work.s6_112));
  const double s1_78 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  work.s1_79 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_78);
  const double s2_153 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  work.s2_154 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s2_153);
  work.s6_114 = work.s1_79*s6_111;
  work.s8_535 = fma(zd_lower_arm_right, work.s8_57, s6_111);
  const double s6_115 = zd_arb_front_right*work.s2_154;
  work.s6_116 = s6_115 - s6_110;
  const double s6_117 = fma(work.s4_37, s6_104, fma(zd_arb_front_right, s6_115, work.s6_114));
  work.s6_118 = fnma(work.s4_42, s6_110, s6_117);

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s2_155 = p_tie_rod_left_to_z*work.R_carrier_left_z_z;
  const double s2_156 = -p_carrier_left_upper_ball_y*work.R_carrier_left_aux2_z_y;
  work.s2_157 = fma(p_tie_rod_left_to_x, work.R_carrier_left_z_x, s2_155) - s2_156;
  const double pivot_carrier_left_rx = fms(p_carrier_left_upper_ball_z, work.R_carrier_left_z_z,
      s2_156);
  const double s2_158 = p_tie_rod_left_to_z*work.R_carrier_left_y_z;
  const double s2_159 = -p_carrier_left_upper_ball_y*work.R_carrier_left_aux2_y_y;
  work.s2_160 = fma(p_tie_rod_left_to_x, work.R_carrier_left_y_x, s2_158) - s2_159;
  const double s2_161 = fms(p_carrier_left_upper_ball_z, work.R_carrier_left_y_z, s2_159);
  const double s2_162 = p_tie_rod_left_to_z*work.R_carrier_left_x_z;
  const double s2_163 = -p_carrier_left_upper_ball_y*work.s1_21;
  work.s2_164 = s2_163 + fma(p_tie_rod_left_to_x, work.R_carrier_left_x_x, s2_162);
  const double s2_165 = fma(p_carrier_left_upper_ball_z, work.R_carrier_left_x_z, s2_163);
  const double s6_119 = fnma(work.s4_27, work.s2_164, work.s4_22*work.s2_160);
  const double s6_120 = fnma(work.s4_20, work.s2_160, work.s4_27*work.s2_157);
  const double s6_121 = fnma(work.s4_22, work.s2_157, work.s4_20*work.s2_164);
  work.s6_122 = fnma(work.s4_27, s6_120, fms(work.s4_22, s6_121, work.s6_99));
  const double R_bell_crank_y_x = work.sines[16];
  const double s2_166 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  const double R_bell_crank_x_x = work.cosines[16];
  const double s2_167 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_166);
  work.s2_168 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_166);
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s6_123 = zd_bell_crank*s2_167;
  work.s6_124 = s6_123 + s6_120;
  const double s6_125 = fnma(work.s4_22, s6_119, fms(zd_bell_crank, s6_123, work.s6_97));
  work.s6_126 = fma(work.s4_20, s6_120, s6_125);
  work.s4_44 = zd_lower_arm_left*work.s1_75;
  work.s6_127 = s6_90 - work.s4_44;
  const double s2_169 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_170 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_169);
  work.s2_171 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_169);
  const double s6_128 = zd_bell_crank*s2_170;
  work.s6_129 = s6_121 + (s6_128 - work.s4_44);
  work.s6_130 = work.s4_28 + s6_119;
  work.s6_131 = fma(work.s4_20, s6_121, fnma(work.s4_27, s6_119, zd_bell_crank*s6_128));
  const double s2_172 = p_tie_rod_right_to_z*work.R_carrier_right_z_z;
  const double s2_173 = p_carrier_right_upper_ball_y*work.R_carrier_right_aux2_z_y;
  work.s2_174 = s2_173 + fma(p_tie_rod_right_to_x, work.R_carrier_right_z_x, s2_172);
  work.pivot_carrier_right_rx = fma(p_carrier_right_upper_ball_z, work.R_carrier_right_z_z, s2_173);
  const double s2_175 = p_tie_rod_right_to_z*work.R_carrier_right_y_z;
  const double s2_176 = p_carrier_right_upper_ball_y*work.R_carrier_right_aux2_y_y;
  work.s2_177 = s2_176 + fma(p_tie_rod_right_to_x, work.R_carrier_right_y_x, s2_175);
  work.s2_178 = fma(p_carrier_right_upper_ball_z, work.R_carrier_right_y_z, s2_176);
  const double s2_179 = p_tie_rod_right_to_z*work.R_carrier_right_x_z;
  const double s2_180 = p_carrier_right_upper_ball_y*work.s1_37;
  work.s2_181 = fma(p_tie_rod_right_to_x, work.R_carrier_right_x_x, s2_179) - s2_180;
  work.s2_182 = fms(p_carrier_right_upper_ball_z, work.R_carrier_right_x_z, s2_180);

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right, continued ---
  // tie_rod_right
  const double s6_132 = fnma(work.s4_42, work.s2_181, work.s4_37*work.s2_177);
  const double s6_133 = fnma(work.s4_37, work.s2_174, work.s4_35*work.s2_181);
  const double s6_134 = fnma(work.s4_35, work.s2_177, work.s4_42*work.s2_174);
  work.s6_135 = fnma(work.s4_42, s6_134, fma(work.s4_37, s6_133, work.s6_114));
  const double s6_136 = zd_bell_crank*work.s2_168;
  work.s6_137 = s6_136 - s6_134;
  const double s6_138 = fma(work.s4_37, s6_132, fma(zd_bell_crank, s6_136, work.s6_112));
  work.s6_139 = fnma(work.s4_35, s6_134, s6_138);
  const double s6_140 = zd_bell_crank*work.s2_171;
  work.s6_141 = work.s4_43 + s6_132;
  work.s6_142 = fnma(work.s4_35, s6_133, fma(work.s4_42, s6_132, zd_bell_crank*s6_140));
  work.s4_45 = zd_lower_arm_right*work.s1_79;
  work.s6_143 = work.s4_45 + s6_104;
  work.s6_144 = s6_140 - work.s4_45 - s6_133;
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s2_183 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_184 = fma(p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s2_183);
  const double s2_185 = p_upper_arm_left_ball_y*R_upper_arm_left_y_y;
  const double s2_186 = fnma(p_upper_arm_left_ball_z, R_upper_arm_left_z_y, s2_185);
  const double s6_145 = fnma(work.s4_27, s2_165, work.s4_22*s2_161);
  const double s6_146 = fnma(work.s4_22, pivot_carrier_left_rx, work.s4_20*s2_165);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s6_147 = fms(zd_upper_arm_left, zd_upper_arm_left*s2_186, work.s6_97);
  const double s6_148 = fnma(work.s4_20, s6_146, work.s4_27*s6_145);
  const double s6_149 = fnma(zd_upper_arm_left, zd_upper_arm_left*s2_184, work.s6_99);
  const double s6_150 = fnma(work.s4_20, s2_161, work.s4_27*pivot_carrier_left_rx);
  const double s2_187 = 1.0/pivot_carrier_left_rx;
  const double s2_188 = s2_165*s2_187;
  const double s6_151 = fnma(s2_188, s6_148, fnma(work.s4_22, s6_146, s6_149));
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  work.r_carrier_left_aux1_z = work.s1_75 + p_lower_arm_left_z;
  work.s2_189 = work.s2_157 + (work.r_carrier_left_aux1_z - p_bell_crank_z);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_73;

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  work.s2_190 = s2_167 - work.r_carrier_left_aux1_y - work.s2_160;
  work.s2_191 = work.s2_164 + (0.35 + s2_170);
  const double s2_192 = fnma(s2_167, work.s2_191, s2_170*work.s2_190);
  const double s2_193 = fnma(work.s2_157, work.s2_191, work.s2_189*work.s2_164)*s2_187;
  const double s2_194 = fma(work.s2_157, work.s2_190, work.s2_189*work.s2_160);
  const double s2_195 = s2_194 + fma(work.s1_75, work.s2_190, work.s1_73*work.s2_189);
  const double s2_196 = fma(work.s2_160, work.s2_191, work.s2_190*work.s2_164);
  const double s2_197 = fma(s2_161, s2_193, s2_196);
  const double s6_152 = fma(work.s6_130, work.s6_130, s2_193*s6_148);
  const double s6_153 = fma(work.s6_129, work.s6_129, fma(work.s6_124, work.s6_124, s6_152));
  const double s6_154 = fnma(work.s2_190, work.s6_126, fma(work.s2_189, work.s6_122, s6_153));
  const double s6_155 = fnma(work.s2_191, work.s6_131, s6_154);
  const double s2_198 = 1.0/s2_197;
  const double s2_199 = s2_165*s2_198;
  const double s2_200 = s2_198*(s2_161*s2_188);
  const double s6_156 = fma(work.s4_20, s6_150, fnma(work.s4_22, s6_145, s6_147));
  const double s6_157 = fma(s2_199, s6_155, s6_156);
  work.s2_201 = 6.915894223167946*std::abs(s2_197);
  const double pivot_carrier_left_rz = fms(s2_194, s2_199, pivot_carrier_left_rx);
  const double s2_202 = 1.0/pivot_carrier_left_rz;
  const double s2_203 = fnma(s2_194, s2_200, s2_161)*s2_202;
  const double s2_204 = fma(s2_184, s2_203, s2_186);
  const double s6_158 = fma(s2_200, s6_155, fma(work.s4_27, s6_150, s6_151));
  work.s2_205 = 2.7028219055711094*std::abs(pivot_carrier_left_rz);
  const double s2_206 = s2_192*s2_199;
  const double s2_207 = fms(s2_195, s2_199, work.s1_75) - pivot_carrier_left_rx;
  work.s2_208 = 2.7028219055711094*std::abs(pivot_carrier_left_rx);
  const double s2_209 = 1.0/s2_204;

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  work.Rz_upper_arm_left_0 = fnma(s2_203, s2_207, fnma(s2_195, s2_200, work.s1_73 + s2_161))*s2_209;
  work.Rz_upper_arm_left_2 = fma(s2_203, s2_206, s2_192*s2_200)*s2_209;
  work.s6_159 = s2_209*fma(s2_203, s6_157, s6_158);
  work.s2_210 = 3.3636363636363633*std::abs(s2_204);
  work.s3_20 = s2_202*fma(s2_184, work.Rz_upper_arm_left_0, s2_207);
  work.Rz_carrier_left_rz_2 = s2_202*fnma(s2_184, work.Rz_upper_arm_left_2, s2_206);
  work.zdd_star_carrier_left_rz = s2_202*fms(s2_184, work.s6_159, s6_157);
  work.s3_21 = s2_198*fms(s2_194, work.s3_20, s2_195);
  work.s3_22 = s2_198*fnma(s2_194, work.Rz_carrier_left_rz_2, s2_192);
  work.zdd_star_carrier_left_ry = s2_198*fma(s2_194, work.zdd_star_carrier_left_rz, s6_155);
  const double s8_536 = fms(work.s2_157, work.Rz_carrier_left_rz_2, s2_170);
  work.s8_537 = fma(work.s2_164, work.s3_22, s8_536);
  work.zdd_star_carrier_left_rx = s2_187*fms(s2_161, work.zdd_star_carrier_left_ry, s6_148);
  work.s3_23 = s2_187*(s2_161*work.s3_21);
  work.s3_24 = s2_187*(s2_161*work.s3_22);
  work.s8_538 = fnma(work.s2_157, work.s3_24, fma(work.s2_160, work.s3_22, s2_167));
  work.s2_211 = 0.35 + work.s2_148 - work.s2_131;
  const double s2_212 = work.s2_150 + p_arb_front_left_z - work.r_carrier_left_aux1_z;
  work.s2_213 = s2_212 - work.s2_134;
  work.s2_214 = 0.72 - work.r_carrier_left_aux1_y - work.s2_137;
  const double s2_215 = fnma(work.s2_211, work.s2_137, work.s2_131*work.s2_214);
  const double s2_216 = fnma(work.s2_134, work.s2_214, work.s2_213*work.s2_137);
  const double s3_25 = s2_216 + fnma(work.s1_75, work.s2_214, work.s1_73*work.s2_213);
  const double s6_160 = fnma(work.s6_127, work.s6_127, work.s2_211*work.s6_94);
  const double s6_161 = fma(work.s2_214, work.s6_98, fnma(work.s6_93, work.s6_93, s6_160));
  const double s6_162 = fnma(work.s6_101, work.s6_101, fma(work.s2_213, work.s6_103, s6_161));
  const double s6_163 = fma(s2_216, work.zdd_star_carrier_left_rz, s6_162);
  const double s2_217 = fnma(work.s2_131, work.s2_213, work.s2_211*work.s2_134);
  const double s3_26 = fnma(s2_215, work.s3_21, fnma(s2_216, work.s3_20, s3_25));
  const double s3_27 = fnma(s2_215, work.s3_22, s2_216*work.Rz_carrier_left_rz_2);
  const double s6_164 = fma(s2_215, work.zdd_star_carrier_left_ry, s6_163);
  const double pivot_arb_front_left = fnma(work.s2_148, work.s2_213, work.s2_150*work.s2_211);
  const double s2_218 = 1.0/pivot_arb_front_left;
  work.s2_219 = std::abs(pivot_arb_front_left);
  work.Rz_arb_front_left_0 = s2_218*fnma(s2_217, work.s3_23, s3_26);
  work.Rz_arb_front_left_2 = s2_218*fnma(s2_217, work.s3_24, s3_27);
  work.zdd_star_arb_front_left = s2_218*fma(s2_217, work.zdd_star_carrier_left_rx, s6_164);
}

/// Part 4 of compute_accelerations: step 2: closure Jacobian Phi_z and its factors (60),
/// upper_ball_left .. tie_rod_right; step 6: c and dRz/dt zd (62), upper_ball_left ..
/// tie_rod_right; step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left ..
/// tie_rod_right; step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right; step 7: inertias
/// of the bodies and forces on joints, upper_ball_left .. tie_rod_right; step 8: elimination from
/// the leaves to the root (63), upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_4(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s2_220 = -p_upper_arm_right_ball_z*R_upper_arm_right_z_y;
  const double s2_221 = fma(p_upper_arm_right_ball_y, R_upper_arm_right_y_y, s2_220);
  const double s2_222 = -p_upper_arm_right_ball_z*R_upper_arm_right_y_y;
  const double s2_223 = fnma(p_upper_arm_right_ball_y, R_upper_arm_right_z_y, s2_222);

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right, continued ---
  const double s6_165 = fnma(work.s4_42, work.s2_182, work.s4_37*work.s2_178);
  const double s6_166 = fnma(work.s4_37, work.pivot_carrier_right_rx, work.s4_35*work.s2_182);
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s6_167 = fnma(zd_upper_arm_right, zd_upper_arm_right*s2_221, work.s6_112);
  const double s6_168 = fnma(work.s4_35, s6_166, work.s4_42*s6_165);
  const double s6_169 = fnma(zd_upper_arm_right, zd_upper_arm_right*s2_223, work.s6_114);
  const double s6_170 = fnma(work.s4_35, work.s2_178, work.s4_42*work.pivot_carrier_right_rx);
  const double s2_224 = 1.0/work.pivot_carrier_right_rx;
  const double s2_225 = work.s2_182*s2_224;
  const double s6_171 = fma(s2_225, s6_168, fma(work.s4_37, s6_166, s6_169));
  work.s1_80 = work.s1_79 - p_lower_arm_right_z;
  work.s2_226 = work.s2_174 + (-p_bell_crank_z - work.s1_80);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  work.r_carrier_right_aux1_y = work.s1_77 + p_lower_arm_right_y;

  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right,
  // continued ---
  work.s2_227 = work.s2_177 + (work.r_carrier_right_aux1_y + work.s2_168);
  work.s2_228 = work.s2_171 - 0.35 - work.s2_181;
  const double s2_229 = fnma(work.s2_227, work.s2_171, work.s2_168*work.s2_228);
  const double s2_230 = fma(work.s2_174, work.s2_228, work.s2_226*work.s2_181)*s2_224;
  const double s2_231 = fnma(work.s2_226, work.s2_177, work.s2_174*work.s2_227);
  const double s2_232 = fnma(work.s1_79, work.s2_227, fnma(work.s1_77, work.s2_226, s2_231));
  const double s2_233 = fma(work.s2_177, work.s2_228, work.s2_227*work.s2_181);
  const double pivot_carrier_right_ry = fnma(work.s2_178, s2_230, s2_233);
  const double s6_172 = fma(work.s6_141, work.s6_141, s2_230*s6_168);
  const double s6_173 = fnma(work.s2_228, work.s6_142, fma(work.s2_226, work.s6_135, s6_172));
  const double s6_174 = fma(work.s6_137, work.s6_137, fnma(work.s2_227, work.s6_139, s6_173));
  const double s6_175 = fma(work.s6_144, work.s6_144, s6_174);
  const double s2_234 = 1.0/pivot_carrier_right_ry;
  const double s2_235 = work.s2_182*s2_234;
  const double s2_236 = s2_234*(work.s2_178*s2_225);
  const double s6_176 = fnma(work.s4_35, s6_170, fma(work.s4_37, s6_165, s6_167));
  const double s6_177 = fma(s2_235, s6_175, s6_176);
  const double pivot_carrier_right_rz = fms(s2_231, s2_235, work.pivot_carrier_right_rx);
  const double s2_237 = 1.0/pivot_carrier_right_rz;
  const double s2_238 = fnma(s2_231, s2_236, work.s2_178)*s2_237;
  const double pivot_upper_arm_right = fms(s2_223, s2_238, s2_221);
  const double s6_178 = fma(s2_236, s6_175, fnma(work.s4_42, s6_170, s6_171));
  const double s2_239 = fma(s2_232, s2_235, work.s1_79 - work.pivot_carrier_right_rx);
  const double s2_240 = s2_229*s2_235;
  const double s2_241 = 1.0/pivot_upper_arm_right;
  const double s2_242 = fnma(s2_238, s2_239, fnma(s2_232, s2_236, work.s1_77 + work.s2_178));
  work.s3_28 = s2_242*s2_241;
  work.s3_29 = fma(s2_238, s2_240, s2_229*s2_236)*s2_241;
  work.s6_179 = s2_241*fma(s2_238, s6_177, s6_178);
  work.s3_30 = s2_237*fma(s2_223, work.s3_28, s2_239);
  work.Rz_carrier_right_rz_2 = s2_237*fnma(s2_223, work.s3_29, s2_240);
  work.zdd_star_carrier_right_rz = s2_237*fnma(s2_223, work.s6_179, s6_177);
  work.Rz_carrier_right_ry_1 = s2_234*fnma(s2_231, work.s3_30, s2_232);
  work.Rz_carrier_right_ry_2 = s2_234*fms(s2_231, work.Rz_carrier_right_rz_2, s2_229);
  work.zdd_star_carrier_right_ry = s2_234*fms(s2_231, work.zdd_star_carrier_right_rz, s6_175);
  const double s8_539 = fma(work.s2_174, work.Rz_carrier_right_rz_2, work.s2_171);
  work.s8_540 = fnma(work.s2_181, work.Rz_carrier_right_ry_2, s8_539);
  work.zdd_star_carrier_right_rx = s2_224*fms(work.s2_178, work.zdd_star_carrier_right_ry, s6_168);
  work.Rz_carrier_right_rx_1 = s2_224*(work.s2_178*work.Rz_carrier_right_ry_1);
  work.Rz_carrier_right_rx_2 = s2_224*(work.s2_178*work.Rz_carrier_right_ry_2);
  const double s8_541 = fma(work.s2_177, work.Rz_carrier_right_ry_2, work.s2_168);
  work.s8_542 = fnma(work.s2_174, work.Rz_carrier_right_rx_2, s8_541);
  work.s2_243 = 0.35 + work.s2_152 - work.s2_140;
  work.s2_244 = work.s2_154 + (work.s1_80 + p_arb_front_right_z) - work.s2_143;
  work.s2_245 = work.s2_146 + (0.72 + work.r_carrier_right_aux1_y);
  const double s2_246 = fma(work.s2_143, work.s2_245, work.s2_244*work.s2_146);
  const double s2_247 = fma(work.s2_140, work.s2_245, work.s2_243*work.s2_146);
  const double s3_31 = s2_246 + fnma(work.s1_79, work.s2_245, work.s1_77*work.s2_244);
  const double s3_32 = fnma(s2_246, work.s3_30, s3_31);
  const double s6_180 = fnma(work.s6_143, work.s6_143, work.s2_243*work.s6_109);
  const double s6_181 = fnma(work.s2_245, work.s6_113, fnma(work.s6_107, work.s6_107, s6_180));
  const double s6_182 = fnma(work.s6_116, work.s6_116, fma(work.s2_244, work.s6_118, s6_181));
  const double s6_183 = fma(s2_246, work.zdd_star_carrier_right_rz, s6_182);
  const double s3_33 = s2_246*work.Rz_carrier_right_rz_2;
  const double s2_248 = fnma(work.s2_140, work.s2_244, work.s2_243*work.s2_143);
  const double s3_34 = fnma(s2_247, work.Rz_carrier_right_ry_1, s3_32);
  const double s3_35 = fnma(s2_247, work.Rz_carrier_right_ry_2, s3_33);
  const double s6_184 = fnma(s2_247, work.zdd_star_carrier_right_ry, s6_183);
  const double pivot_arb_front_right = fnma(work.s2_152, work.s2_244, work.s2_154*work.s2_243);
  const double s2_249 = 1.0/pivot_arb_front_right;
  work.Rz_arb_front_right_1 = s2_249*fma(s2_248, work.Rz_carrier_right_rx_1, s3_34);
  work.Rz_arb_front_right_2 = s2_249*fma(s2_248, work.Rz_carrier_right_rx_2, s3_35);
  work.zdd_star_arb_front_right = s2_249*fma(s2_248, work.zdd_star_carrier_right_rx, s6_184);
  const double R_pitman_arm_x_z = work.sines[15];
  const double s2_250 = -p_drag_link_from_z*R_pitman_arm_x_z;
  const double R_bell_crank_y_x = work.sines[16];
  work.s2_251 = p_drag_link_to_y*R_bell_crank_y_x;
  work.s2_252 = work.s2_251 + (1.15 - s2_250);
  const double R_pitman_arm_x_x = work.cosines[15];
  const double s2_253 = -p_drag_link_from_z*R_pitman_arm_x_x;
  work.s2_254 = 0.2 - s2_253;
  const double pivot_pitman_arm = fnma(s2_253, work.s2_252, s2_250*work.s2_254);
  const double R_bell_crank_x_x = work.cosines[16];
  const double s2_255 = p_drag_link_to_y*R_bell_crank_x_x;
  work.s2_256 = p_pitman_arm_y - s2_255;
  const double s2_257 = 1.0/pivot_pitman_arm;
  work.s3_36 = fma(work.s2_251, work.s2_256, work.s2_252*s2_255)*s2_257;
  const double s2_258 = 16.504892200367603*std::abs(pivot_arb_front_right);
  const double s2_259 = mbgen::min(3.9625229801272064*std::abs(pivot_pitman_arm), s2_258);
  const double s2_260 = 2.7028647671567816*std::abs(work.pivot_carrier_right_rx);
  const double s2_261 = mbgen::min(s2_260, mbgen::min(16.679425973935604*work.s2_219, s2_259));
  const double s2_262 = mbgen::min(s2_261, 6.8514628664707224*std::abs(pivot_carrier_right_ry));
  const double s2_263 = mbgen::min(s2_262, 2.7028647671567816*std::abs(pivot_carrier_right_rz));
  const double s2_264 = mbgen::min(s2_263, 3.405476531191585*std::abs(pivot_upper_arm_right));
  const double s2_265 = mbgen::min(work.s2_201, mbgen::min(work.s2_208, s2_264));
  const double s2_266 = mbgen::min(work.s2_210, mbgen::min(work.s2_205, s2_265));
  result.pivot[0] = mbgen::min(work.s9_5, mbgen::min(s2_266, work.s9_4));
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s6_185 = zd_pitman_arm*s2_253;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s6_186 = zd_bell_crank*s2_255;
  work.s8_543 = fma(s2_253, work.s3_36, s2_255);

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right, continued ---
  // drag_link
  const double s6_187 = zd_pitman_arm*s6_185;
  const double s6_188 = s6_186 - s6_185;
  const double s6_189 = zd_bell_crank*s6_186;
  const double s6_190 = zd_pitman_arm*s2_250;
  const double s6_191 = zd_bell_crank*work.s2_251;
  const double s6_192 = fnma(zd_bell_crank, s6_191, zd_pitman_arm*s6_190);
  const double s6_193 = fma(work.s2_254, s6_187, fma(s6_191, s6_191, s6_190*s6_190));
  const double s6_194 = fma(s6_188, s6_188, fma(work.s2_256, s6_189, s6_193));
  work.s6_195 = s2_257*fma(work.s2_252, s6_192, s6_194);

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s7_46 = -K_lower_arm_left_yz*R_lower_arm_left_y_y;
  const double s7_47 = fma(K_lower_arm_left_zz, R_lower_arm_left_z_y, s7_46);
  const double s7_48 = K_lower_arm_left_yy*R_lower_arm_left_y_y;
  const double s7_49 = fnma(K_lower_arm_left_yz, R_lower_arm_left_z_y, s7_48);
  work.s7_50 = fnma(R_lower_arm_left_y_y, s7_47, R_lower_arm_left_z_y*s7_49);
  work.s7_51 = fma(R_lower_arm_left_y_y, s7_49, R_lower_arm_left_z_y*s7_47);
  const double s7_52 = h_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_53 = fma(h_carrier_left_x, work.R_carrier_left_z_x, s7_52);
  work.s7_54 = fma(h_carrier_left_z, work.R_carrier_left_z_z, s7_53);
  const double s7_55 = K_carrier_left_xy*work.R_carrier_left_x_x;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_56 = fnma(K_carrier_left_yy, work.s1_21, s7_55);
  const double s7_57 = fma(K_carrier_left_yz, work.R_carrier_left_x_z, s7_56);
  const double s7_58 = K_carrier_left_yy*work.R_carrier_left_aux2_y_y;
  const double s7_59 = fma(K_carrier_left_xy, work.R_carrier_left_y_x, s7_58);
  const double s7_60 = fma(K_carrier_left_yz, work.R_carrier_left_y_z, s7_59);
  const double s7_61 = K_carrier_left_yz*work.R_carrier_left_aux2_y_y;
  const double s7_62 = fma(K_carrier_left_xz, work.R_carrier_left_y_x, s7_61);
  const double s7_63 = fma(K_carrier_left_zz, work.R_carrier_left_y_z, s7_62);
  const double s7_64 = K_carrier_left_zz*work.R_carrier_left_x_z;
  const double s7_65 = fnma(K_carrier_left_yz, work.s1_21, s7_64);
  const double s7_66 = fma(K_carrier_left_xz, work.R_carrier_left_x_x, s7_65);
  const double s7_67 = K_carrier_left_xy*work.R_carrier_left_aux2_y_y;
  const double s7_68 = fma(K_carrier_left_xx, work.R_carrier_left_y_x, s7_67);
  const double s7_69 = fma(K_carrier_left_xz, work.R_carrier_left_y_z, s7_68);
  const double s7_70 = fma(work.R_carrier_left_z_z, s7_63, work.R_carrier_left_aux2_z_y*s7_60);
  work.s7_71 = fma(work.R_carrier_left_z_x, s7_69, s7_70);
  const double s7_72 = fma(work.R_carrier_left_y_z, s7_63, work.R_carrier_left_aux2_y_y*s7_60);
  const double s7_73 = fma(work.R_carrier_left_y_x, s7_69, s7_72);
  const double s7_74 = K_carrier_left_xx*work.R_carrier_left_x_x;
  const double s7_75 = fnma(K_carrier_left_xy, work.s1_21, s7_74);
  const double s7_76 = fma(K_carrier_left_xz, work.R_carrier_left_x_z, s7_75);
  const double s7_77 = fma(work.R_carrier_left_z_z, s7_66, work.R_carrier_left_aux2_z_y*s7_57);
  work.s7_78 = fma(work.R_carrier_left_z_x, s7_76, s7_77);
  const double s7_79 = h_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_80 = fma(h_carrier_left_x, work.R_carrier_left_y_x, s7_79);
  work.s7_81 = fma(h_carrier_left_z, work.R_carrier_left_y_z, s7_80);
  const double s7_82 = fma(work.R_carrier_left_y_z, s7_66, work.R_carrier_left_aux2_y_y*s7_57);
  work.s7_83 = fma(work.R_carrier_left_y_x, s7_76, s7_82);
  const double s7_84 = h_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_85 = fnma(work.s1_21, s7_57, work.R_carrier_left_x_z*s7_66);
  const double s7_86 = fma(work.R_carrier_left_x_x, s7_76, s7_85);
  const double s7_87 = fnma(h_carrier_left_y, work.s1_21, s7_84);
  work.s7_88 = fma(h_carrier_left_x, work.R_carrier_left_x_x, s7_87);
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double R_upper_arm_left_z_y = work.sines[7];
  const double s7_89 = -K_upper_arm_left_yz*R_upper_arm_left_y_y;
  const double s7_90 = fma(K_upper_arm_left_zz, R_upper_arm_left_z_y, s7_89);
  const double s7_91 = K_upper_arm_left_yy*R_upper_arm_left_y_y;
  const double s7_92 = fnma(K_upper_arm_left_yz, R_upper_arm_left_z_y, s7_91);
  work.s7_93 = fnma(R_upper_arm_left_y_y, s7_90, R_upper_arm_left_z_y*s7_92);
  work.s7_94 = fma(R_upper_arm_left_y_y, s7_92, R_upper_arm_left_z_y*s7_90);
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_95 = K_arb_front_left_zz*R_arb_front_left_x_z;
  const double s7_96 = fma(K_arb_front_left_xz, R_arb_front_left_x_x, s7_95);
  const double s7_97 = K_arb_front_left_xx*R_arb_front_left_x_x;
  const double s7_98 = fma(K_arb_front_left_xz, R_arb_front_left_x_z, s7_97);
  work.s7_99 = fnma(R_arb_front_left_x_z, s7_98, R_arb_front_left_x_x*s7_96);
  work.s7_100 = fma(R_arb_front_left_x_x, s7_98, R_arb_front_left_x_z*s7_96);
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s7_101 = K_lower_arm_right_yy*R_lower_arm_right_y_y;
  const double s7_102 = fnma(K_lower_arm_right_yz, R_lower_arm_right_z_y, s7_101);
  const double s7_103 = K_lower_arm_right_yz*R_lower_arm_right_y_y;
  const double s7_104 = fnma(K_lower_arm_right_zz, R_lower_arm_right_z_y, s7_103);
  work.s7_105 = fma(R_lower_arm_right_y_y, s7_104, R_lower_arm_right_z_y*s7_102);
  work.s7_106 = fnma(R_lower_arm_right_z_y, s7_104, R_lower_arm_right_y_y*s7_102);
  const double s7_107 = h_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_108 = fma(h_carrier_right_y, work.R_carrier_right_aux2_z_y, s7_107);
  work.s7_109 = fma(h_carrier_right_x, work.R_carrier_right_z_x, s7_108);
  work.s8_544 = work.s7_109 + (work.s7_54 + work.s8_353);
  const double s7_110 = K_carrier_right_yy*work.s1_37;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_111 = fnma(K_carrier_right_xy, work.R_carrier_right_x_x, s7_110);
  const double s7_112 = fnma(K_carrier_right_yz, work.R_carrier_right_x_z, s7_111);
  const double s7_113 = K_carrier_right_yy*work.R_carrier_right_aux2_y_y;
  const double s7_114 = fma(K_carrier_right_xy, work.R_carrier_right_y_x, s7_113);
  const double s7_115 = fma(K_carrier_right_yz, work.R_carrier_right_y_z, s7_114);
  const double s7_116 = K_carrier_right_zz*work.R_carrier_right_y_z;
  const double s7_117 = fma(K_carrier_right_yz, work.R_carrier_right_aux2_y_y, s7_116);
  const double s7_118 = fma(K_carrier_right_xz, work.R_carrier_right_y_x, s7_117);
  const double s7_119 = K_carrier_right_xx*work.R_carrier_right_y_x;
  const double s7_120 = fma(K_carrier_right_xy, work.R_carrier_right_aux2_y_y, s7_119);
  const double s7_121 = fma(K_carrier_right_xz, work.R_carrier_right_y_z, s7_120);
  const double s7_122 = work.R_carrier_right_aux2_z_y*s7_115;
  const double s7_123 = fma(work.R_carrier_right_z_z, s7_118, s7_122);
  work.s7_124 = fma(work.R_carrier_right_z_x, s7_121, s7_123);
  const double s7_125 = work.R_carrier_right_aux2_y_y*s7_115;
  const double s7_126 = fma(work.R_carrier_right_y_z, s7_118, s7_125);
  const double s7_127 = fma(work.R_carrier_right_y_x, s7_121, s7_126);
  work.s8_545 = s7_127 + (s7_73 + work.s8_462);
  const double s7_128 = -K_carrier_right_yz*work.s1_37;
  const double s7_129 = fma(K_carrier_right_xz, work.R_carrier_right_x_x, s7_128);
  const double s7_130 = fma(K_carrier_right_zz, work.R_carrier_right_x_z, s7_129);
  const double s7_131 = work.R_carrier_right_z_z*s7_130;
  const double s7_132 = -K_carrier_right_xy*work.s1_37;
  const double s7_133 = fma(K_carrier_right_xx, work.R_carrier_right_x_x, s7_132);
  const double s7_134 = fma(K_carrier_right_xz, work.R_carrier_right_x_z, s7_133);
  const double s7_135 = fnma(work.R_carrier_right_aux2_z_y, s7_112, s7_131);
  work.s7_136 = fma(work.R_carrier_right_z_x, s7_134, s7_135);
  const double s7_137 = -h_carrier_right_y*work.s1_37;
  const double s7_138 = fma(h_carrier_right_x, work.R_carrier_right_x_x, s7_137);
  work.s7_139 = fma(h_carrier_right_z, work.R_carrier_right_x_z, s7_138);
  work.s8_546 = work.s7_139 + (work.s7_88 + work.s8_383);
  const double s7_140 = fma(work.R_carrier_right_x_z, s7_130, work.s1_37*s7_112);
  const double s7_141 = fma(work.R_carrier_right_x_x, s7_134, s7_140);
  const double s7_142 = work.R_carrier_right_y_z*s7_130;
  work.s8_547 = s7_141 + (s7_86 + work.s8_474);
  const double s7_143 = h_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_144 = fnma(work.R_carrier_right_aux2_y_y, s7_112, s7_142);
  work.s7_145 = fma(work.R_carrier_right_y_x, s7_134, s7_144);
  const double s7_146 = fma(h_carrier_right_y, work.R_carrier_right_aux2_y_y, s7_143);
  work.s7_147 = fma(h_carrier_right_x, work.R_carrier_right_y_x, s7_146);
  work.s8_548 = work.s7_147 + (work.s7_81 + work.s8_347);
  const double s7_148 = K_upper_arm_right_yy*R_upper_arm_right_y_y;
  const double s7_149 = fnma(K_upper_arm_right_yz, R_upper_arm_right_z_y, s7_148);
  const double s7_150 = K_upper_arm_right_yz*R_upper_arm_right_y_y;
  const double s7_151 = fnma(K_upper_arm_right_zz, R_upper_arm_right_z_y, s7_150);
  work.s7_152 = fma(R_upper_arm_right_y_y, s7_151, R_upper_arm_right_z_y*s7_149);
  work.s7_153 = fnma(R_upper_arm_right_z_y, s7_151, R_upper_arm_right_y_y*s7_149);
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_154 = K_arb_front_right_zz*R_arb_front_right_x_z;
  const double s7_155 = fma(K_arb_front_right_xz, R_arb_front_right_x_x, s7_154);
  const double s7_156 = K_arb_front_right_xx*R_arb_front_right_x_x;
  const double s7_157 = fma(K_arb_front_right_xz, R_arb_front_right_x_z, s7_156);
  work.s7_158 = fnma(R_arb_front_right_x_z, s7_157, R_arb_front_right_x_x*s7_155);
  work.s7_159 = fma(R_arb_front_right_x_x, s7_157, R_arb_front_right_x_z*s7_155);
  const double s7_160 = K_pitman_arm_zz*R_pitman_arm_x_z;
  const double s7_161 = K_pitman_arm_xx*R_pitman_arm_x_x;
  work.s7_162 = fnma(R_pitman_arm_x_z, s7_161, R_pitman_arm_x_x*s7_160);
  work.s8_549 = work.s7_162 + (work.s7_158 + (work.s7_99 + work.s8_399));
  work.s7_163 = fma(R_pitman_arm_x_x, s7_161, R_pitman_arm_x_z*s7_160);
  const double s7_164 = -K_bell_crank_xy*R_bell_crank_x_x;
  const double s7_165 = fma(K_bell_crank_yy, R_bell_crank_y_x, s7_164);
  const double s7_166 = K_bell_crank_xx*R_bell_crank_x_x;
  const double s7_167 = fnma(K_bell_crank_xy, R_bell_crank_y_x, s7_166);
  work.s7_168 = fnma(R_bell_crank_x_x, s7_165, R_bell_crank_y_x*s7_167);
  work.s7_169 = fma(R_bell_crank_x_x, s7_167, R_bell_crank_y_x*s7_165);
  const double s8_550 = work.s7_163 + (work.s7_159 + (work.s7_100 + work.s8_533));
  work.s8_551 = work.s7_169 + s8_550;

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  work.s8_552 = p_upper_arm_right_x*work.s8_69;
  const double s8_553 = fnma(work.s1_80, work.s8_77, fnma(work.s4_43, work.s8_57, work.s8_552));
  const double s8_554 = fnma(work.s4_45, work.s8_64, work.s4_43*work.s8_94);
  const double s8_555 = fnma(work.r_carrier_right_aux1_y, work.s8_42, s8_553) - work.s6_112;
  const double s8_556 = fma(work.r_carrier_right_aux1_y, work.s8_69, s8_554);
  const double s8_557 = fnma(work.s1_80, work.s8_114, s8_556);
  const double s8_558 = fnma(p_upper_arm_right_x, work.s8_41, s8_557);
  const double s8_559 = fma(work.r_carrier_right_aux1_y, work.s8_77, work.s4_45*work.s8_57);
  const double s8_560 = fnma(work.w_chassis_z, work.s4_42, work.w_chassis_y*work.s4_35);
  work.s8_561 = work.zdd_star_carrier_right_rz + s8_560;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double w_carrier_right_y = work.w_chassis_y + work.s4_42;
  work.s8_562 = fnma(work.w_chassis_y, work.s4_37, work.w_chassis_x*work.s4_42);
  const double w_carrier_right_x = work.w_chassis_x + work.s4_37;
  work.s8_563 = fnma(work.w_chassis_x, work.s4_35, work.w_chassis_z*work.s4_37);
  const double w_carrier_right_z = work.w_chassis_z + work.s4_35;
  const double s8_564 = work.R_carrier_right_aux2_z_y*w_carrier_right_x;
  const double s8_565 = work.R_carrier_right_aux2_y_y*w_carrier_right_x;
  const double s8_566 = fnma(work.s1_37, w_carrier_right_x,
      state.zd[Coordinate::wheel_front_right]);
  const double s8_567 = fma(work.R_carrier_right_aux2_y_y, w_carrier_right_y, s8_566);
  const double s8_568 = fma(work.R_carrier_right_aux2_z_y, w_carrier_right_z, s8_567);
  const double s8_569 = I_wheel_front_right_polar*s8_568;
  const double s8_570 = work.R_carrier_right_aux2_z_y*w_carrier_right_y;
  const double tau_wheel_front_right = tau[Coordinate::wheel_front_right];
  const double s8_571 = s8_569*fnma(work.R_carrier_right_aux2_y_y, w_carrier_right_z, s8_570);
  const double s8_572 = fnma(work.s1_37, tau_wheel_front_right, s8_571);
  const double s8_573 = work.zdd_star_carrier_right_ry + work.s8_562;
  const double s8_574 = fms(w_carrier_right_x, w_carrier_right_y, s8_573);
  const double s8_575 = fma(w_carrier_right_x, w_carrier_right_y, s8_573);
  const double s8_576 = w_carrier_right_y*w_carrier_right_y;
  const double s8_577 = fms(w_carrier_right_y, w_carrier_right_z, work.s8_561);
  const double s8_578 = fma(w_carrier_right_y, w_carrier_right_z, work.s8_561);
  const double s8_579 = work.zdd_star_carrier_right_rx + work.s8_563;
  const double s8_580 = fma(w_carrier_right_x, w_carrier_right_z, s8_579);
  const double s8_581 = fms(w_carrier_right_x, w_carrier_right_z, s8_579);
  const double s8_582 = w_carrier_right_z*w_carrier_right_z;
  const double s8_583 = s8_576 + s8_582;
  const double s8_584 = fma(w_carrier_right_x, w_carrier_right_x, s8_582);
  const double s8_585 = fma(w_carrier_right_x, w_carrier_right_x, s8_576);
  const double s8_586 = work.R_carrier_right_aux2_y_y*tau_wheel_front_right;
  const double s8_587 = fnma(fma(work.s1_37, w_carrier_right_z, s8_564), s8_569, s8_586);
  const double s8_588 = work.R_carrier_right_aux2_z_y*tau_wheel_front_right;
  const double s8_589 = fma(fma(work.s1_37, w_carrier_right_y, s8_565), s8_569, s8_588);
  const double s8_590 = fnma(s7_127, s8_574, fnma(work.s7_147, s8_558, s8_589));
  const double s8_591 = fma(work.s7_147, s8_574, m_carrier_right_2*s8_558);
  work.f_carrier_right_x = fnma(work.s7_139, s8_583, fma(work.s7_109, s8_580, s8_591));
  const double s8_592 = fma(work.s7_139, s8_555, fnma(work.s7_124, s8_580, s8_590));
  const double s8_593 = fma(work.s7_139, s8_575, m_carrier_right_2*s8_555);
  work.f_carrier_right_y = fnma(work.s7_147, s8_584, fma(work.s7_109, s8_577, s8_593));
  work.s8_594 = p_upper_arm_right_x*work.s8_114;
  const double s8_595 = work.s8_594 + (work.s6_114 + fma(work.s1_80, work.s8_40, s8_559));
  work.s7_170 = K_carrier_right_trace - s7_141;
  const double s7_171 = work.s7_170 - s7_127;
  const double s8_596 = fnma(work.s7_136, s8_575, fnma(work.s7_109, s8_555, s8_572));
  const double s8_597 = fma(work.s7_124, s8_574, fma(work.s7_109, s8_558, s8_587));
  const double s8_598 = fma(work.s7_147, s8_595, fnma(s7_171, s8_577, s8_596));
  const double s8_599 = fnma(work.s7_139, s8_595, fma(s7_171, s8_580, s8_597));
  const double s8_600 = K_carrier_right_trace - s7_127;
  const double s8_601 = fma(work.s7_147, s8_578, m_carrier_right_2*s8_595);
  work.f_carrier_right_z = fnma(work.s7_109, s8_585, fma(work.s7_139, s8_581, s8_601));
  const double s8_602 = fma(work.s7_145, s8_581, fma(s7_127, s8_578, s8_598));
  work.n_carrier_right_x = fma(work.s7_124, s8_584 - s8_585, s8_602);
  const double s8_603 = fnma(s7_141, s8_581, fnma(work.s7_145, s8_578, s8_599));
  work.n_carrier_right_y = fma(work.s7_136, s8_585 - s8_583, s8_603);
  const double s8_604 = fma(work.s7_136, s8_577, fma(s7_141, s8_575, s8_592));
  work.n_carrier_right_z = fma(work.s7_145, s8_583 - s8_584, s8_604);
  const double s7_172 = h_upper_arm_left_y*R_upper_arm_left_y_y;
  work.s7_173 = fnma(h_upper_arm_left_z, R_upper_arm_left_z_y, s7_172);
  const double s7_174 = h_upper_arm_left_y*R_upper_arm_left_z_y;
  work.s7_175 = fma(h_upper_arm_left_z, R_upper_arm_left_y_y, s7_174);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s8_605 = zd_upper_arm_left*(zd_upper_arm_left + work.s8_57);
  work.s8_606 = fnma(work.s7_173, s8_605, work.s6_159*work.s7_175);
  work.s8_607 = fma(work.s7_175, s8_605, work.s6_159*work.s7_173);
  work.s8_608 = fnma(work.w_chassis_y, work.s4_22, work.w_chassis_x*work.s4_27);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double w_carrier_left_x = work.w_chassis_x + work.s4_22;
  work.s8_609 = fnma(work.w_chassis_x, work.s4_20, work.w_chassis_z*work.s4_22);
  const double s8_610 = fnma(work.s4_28, work.s8_57, work.r_carrier_left_aux1_z*work.s8_77);
  const double s8_611 = fma(work.s4_44, work.s8_64, work.s4_28*work.s8_94);
  const double s8_612 = fnma(work.r_carrier_left_aux1_y, work.s8_42, s8_610) - work.s6_97;
  const double s8_613 = work.s8_552 + s8_612;
  const double s8_614 = fma(work.r_carrier_left_aux1_y, work.s8_69, s8_611);
  const double s8_615 = fma(work.r_carrier_left_aux1_z, work.s8_114, s8_614);
  const double s8_616 = fnma(p_upper_arm_right_x, work.s8_41, s8_615);
  const double s8_617 = fnma(work.s4_44, work.s8_57, work.r_carrier_left_aux1_y*work.s8_77);
  const double s8_618 = fnma(work.r_carrier_left_aux1_z, work.s8_40, s8_617) - work.s6_99;
  const double s8_619 = work.s8_594 + s8_618;
  const double w_carrier_left_y = work.w_chassis_y + work.s4_27;
  const double w_carrier_left_z = work.w_chassis_z + work.s4_20;
  const double s8_620 = fnma(work.w_chassis_z, work.s4_27, work.w_chassis_y*work.s4_20);
  work.s8_621 = work.zdd_star_carrier_left_rz + s8_620;
  const double s8_622 = work.R_carrier_left_aux2_z_y*w_carrier_left_x;
  const double s8_623 = work.R_carrier_left_aux2_y_y*w_carrier_left_x;
  const double s8_624 = fnma(work.s1_21, w_carrier_left_x, state.zd[Coordinate::wheel_front_left]);
  const double s8_625 = fma(work.R_carrier_left_aux2_y_y, w_carrier_left_y, s8_624);
  const double s8_626 = fma(work.R_carrier_left_aux2_z_y, w_carrier_left_z, s8_625);
  const double s8_627 = I_wheel_front_left_polar*s8_626;
  const double s8_628 = work.R_carrier_left_aux2_z_y*w_carrier_left_y;
  const double tau_wheel_front_left = tau[Coordinate::wheel_front_left];
  const double s8_629 = s8_627*fnma(work.R_carrier_left_aux2_y_y, w_carrier_left_z, s8_628);
  const double s8_630 = work.zdd_star_carrier_left_ry + work.s8_608;
  const double s8_631 = fms(w_carrier_left_x, w_carrier_left_y, s8_630);
  const double s8_632 = fma(w_carrier_left_x, w_carrier_left_y, s8_630);
  const double s8_633 = w_carrier_left_y*w_carrier_left_y;
  const double s8_634 = fms(w_carrier_left_y, w_carrier_left_z, work.s8_621);
  const double s8_635 = fma(w_carrier_left_y, w_carrier_left_z, work.s8_621);
  const double s8_636 = work.zdd_star_carrier_left_rx + work.s8_609;
  const double s8_637 = fma(w_carrier_left_x, w_carrier_left_z, s8_636);
  const double s8_638 = fms(w_carrier_left_x, w_carrier_left_z, s8_636);
  const double s8_639 = w_carrier_left_z*w_carrier_left_z;
  const double s8_640 = s8_633 + s8_639;
  const double s8_641 = fma(w_carrier_left_x, w_carrier_left_x, s8_639);
  const double s8_642 = fma(w_carrier_left_x, w_carrier_left_x, s8_633);
  const double s8_643 = work.R_carrier_left_aux2_y_y*tau_wheel_front_left;
  const double s8_644 = fnma(fma(work.s1_21, w_carrier_left_z, s8_622), s8_627, s8_643);
  const double s8_645 = work.R_carrier_left_aux2_z_y*tau_wheel_front_left;
  const double s8_646 = fma(fma(work.s1_21, w_carrier_left_y, s8_623), s8_627, s8_645);
  const double s8_647 = fnma(s7_73, s8_631, fnma(work.s7_81, s8_616, s8_646));
  const double s8_648 = fma(work.s7_81, s8_631, m_carrier_left_2*s8_616);
  work.f_carrier_left_x = fnma(work.s7_88, s8_640, fma(work.s7_54, s8_637, s8_648));
  const double s8_649 = fma(work.s7_88, s8_613, fnma(work.s7_71, s8_637, s8_647));
  const double s8_650 = fma(work.s7_54, s8_634, m_carrier_left_2*s8_613);
  work.f_carrier_left_y = fnma(work.s7_81, s8_641, fma(work.s7_88, s8_632, s8_650));
  const double s7_176 = K_carrier_left_trace - s7_86;
  const double s7_177 = s7_176 - s7_73;
  const double s8_651 = fnma(work.s7_54, s8_613, fnma(work.s1_21, tau_wheel_front_left, s8_629));
  const double s8_652 = fma(work.s7_71, s8_631, fma(work.s7_54, s8_616, s8_644));
  const double s8_653 = K_carrier_left_trace - s7_177;
  work.s8_654 = s7_171 + (s7_177 + work.s8_468);
  const double s8_655 = fnma(work.s7_78, s8_632, fnma(s7_177, s8_634, s8_651));
  const double s8_656 = fnma(work.s7_88, s8_619, fma(s7_177, s8_637, s8_652));
  const double s8_657 = K_carrier_right_trace - s7_171;
  const double s8_658 = fma(s7_73, s8_635, fma(work.s7_81, s8_619, s8_655));
  const double s8_659 = K_carrier_left_trace - s7_73;
  const double s8_660 = fma(work.s7_81, s8_635, m_carrier_left_2*s8_619);
  work.f_carrier_left_z = fnma(work.s7_54, s8_642, fma(work.s7_88, s8_638, s8_660));
  work.n_carrier_left_x = fma(work.s7_71, s8_641 - s8_642, fma(work.s7_83, s8_638, s8_658));
  const double s8_661 = fnma(s7_86, s8_638, fnma(work.s7_83, s8_635, s8_656));
  work.n_carrier_left_y = fma(work.s7_78, s8_642 - s8_640, s8_661);
  const double s8_662 = fma(s7_86, s8_632, fma(work.s7_78, s8_634, s8_649));
  work.n_carrier_left_z = fma(work.s7_83, s8_640 - s8_641, s8_662);
  const double s8_663 = fnma(work.Rz_carrier_left_rz_2, work.s7_78, work.s3_24*work.s7_71);
  work.s8_664 = fnma(work.s3_22, s8_653, s8_663);
  work.s8_665 = 1.0 - work.s3_20;
  const double s8_666 = fnma(work.s1_75, work.s7_88, work.s3_23*work.s7_71);
  work.s8_667 = fnma(work.s3_21, s8_653, fnma(work.s7_78, work.s8_665, s8_666));
  const double s8_668 = fnma(work.Rz_carrier_left_rz_2, work.s7_83, work.s3_22*work.s7_71);
  work.s8_669 = fnma(work.s3_24, s8_659, s8_668);
  const double s8_670 = fnma(work.s1_73, work.s7_88, work.s3_21*work.s7_71);
  work.s8_671 = fnma(work.s3_23, s8_659, fnma(work.s7_83, work.s8_665, s8_670));
  const double s8_672 = fma(work.s3_24, work.s7_83, work.s3_22*work.s7_78);
  work.s8_673 = fma(work.Rz_carrier_left_rz_2, s7_176, s8_672);
  const double s8_674 = fma(work.s1_73, work.s7_81, work.s1_75*work.s7_54);
  const double s8_675 = fma(work.s3_23, work.s7_83, fma(work.s3_21, work.s7_78, s8_674));
  work.s8_676 = fma(s7_176, work.s8_665, s8_675);
  const double s8_677 = fma(work.s8_77, work.s2_213, work.s8_69*work.s2_211);
  const double s8_678 = fma(work.s8_57, work.s6_93, fnma(work.s8_42, work.s2_214, s8_677));
  const double s8_679 = fma(work.s8_64, work.s6_101, s8_678 - work.s6_98);
  const double s8_680 = fma(work.s2_134, work.zdd_star_carrier_left_rz, s8_679);
  // arb_link_front_left
  const double s8_681 = fnma(work.s2_131, work.zdd_star_carrier_left_ry, s8_680);
  work.s8_682 = 0.3333333333333333*s8_681;
  const double s8_683 = fnma(work.s8_41, work.s2_211, work.s8_114*work.s2_213);
  const double s8_684 = fma(work.s8_64, work.s6_127, fma(work.s8_69, work.s2_214, s8_683));
  const double s8_685 = fnma(work.s8_94, work.s6_93, s8_684) - work.s6_94;
  const double s8_686 = fma(work.s2_137, work.zdd_star_carrier_left_ry, s8_685);
  const double s8_687 = fnma(work.s2_134, work.zdd_star_carrier_left_rx, s8_686);
  const double s8_688 = fma(work.s2_150, work.zdd_star_arb_front_left, s8_687);
  work.s8_689 = 0.3333333333333333*s8_688;
  const double s8_690 = fnma(work.s2_137, work.s3_22, work.s2_134*work.s3_24);
  work.s8_691 = fma(work.s2_150, work.Rz_arb_front_left_2, s8_690);
  const double s8_692 = fnma(work.s2_137, work.s3_21, work.s2_134*work.s3_23);
  work.s8_693 = fma(work.s2_150, work.Rz_arb_front_left_0, s8_692);
  const double s8_694 = fnma(work.s8_40, work.s2_213, work.s8_114*work.s2_211);
  const double s8_695 = fnma(work.s8_57, work.s6_127, fma(work.s8_77, work.s2_214, s8_694));
  const double s8_696 = fnma(work.s8_94, work.s6_101, s8_695 - work.s6_103);
  const double s8_697 = fnma(work.s2_137, work.zdd_star_carrier_left_rz, s8_696);
  const double s8_698 = fma(work.s2_131, work.zdd_star_carrier_left_rx, s8_697);
  const double s8_699 = fnma(work.s2_148, work.zdd_star_arb_front_left, s8_698);
  work.s8_700 = 0.3333333333333333*s8_699;
  work.s8_701 = fma(work.s2_134, work.s8_665, fma(work.s2_131, work.s3_21, work.s1_75));
  work.s8_702 = fma(work.s2_131, work.s3_22, work.s2_134*work.Rz_carrier_left_rz_2);
  const double s8_703 = fma(work.s2_131, work.s3_23, work.s1_73);
  const double s8_704 = fma(work.s2_148, work.Rz_arb_front_left_0, s8_703);
  work.s8_705 = fma(work.s2_137, work.s8_665, s8_704);
  const double s8_706 = fma(work.s2_131, work.s3_24, work.s2_137*work.Rz_carrier_left_rz_2);
  work.s8_707 = fma(work.s2_148, work.Rz_arb_front_left_2, s8_706);
  const double s8_708 = fma(work.s8_77, work.s2_244, work.s8_69*work.s2_243);
  const double s8_709 = fma(work.s8_57, work.s6_107, fma(work.s8_42, work.s2_245, s8_708));
  const double s8_710 = fma(work.s8_64, work.s6_116, s8_709 - work.s6_113);
  const double s8_711 = fma(work.s2_143, work.zdd_star_carrier_right_rz, s8_710);
  // arb_link_front_right
  const double s8_712 = fnma(work.s2_140, work.zdd_star_carrier_right_ry, s8_711);
  work.s8_713 = 0.3333333333333333*s8_712;
  const double s8_714 = fnma(work.s8_41, work.s2_243, work.s8_114*work.s2_244);
  const double s8_715 = fma(work.s8_64, work.s6_143, fnma(work.s8_69, work.s2_245, s8_714));
  const double s8_716 = fnma(work.s8_94, work.s6_107, s8_715) - work.s6_109;
  const double s8_717 = fma(work.s2_146, work.zdd_star_carrier_right_ry, s8_716);
  const double s8_718 = fnma(work.s2_143, work.zdd_star_carrier_right_rx, s8_717);
  const double s8_719 = fma(work.s2_154, work.zdd_star_arb_front_right, s8_718);
  work.s8_720 = 0.3333333333333333*s8_719;
  const double s8_721 = work.s2_140*work.Rz_carrier_right_ry_2;
  work.s8_722 = fnma(work.s2_143, work.Rz_carrier_right_rz_2, s8_721);
  work.s8_723 = 1.0 - work.s3_30;
  const double s8_724 = fma(work.s2_140, work.Rz_carrier_right_ry_1, work.s1_79);
  work.s8_725 = fnma(work.s2_143, work.s8_723, s8_724);
  const double s8_726 = work.s2_146*work.Rz_carrier_right_ry_2;
  const double s8_727 = fnma(work.s2_143, work.Rz_carrier_right_rx_2, s8_726);
  work.s8_728 = fma(work.s2_154, work.Rz_arb_front_right_2, s8_727);
  const double s8_729 = work.s2_146*work.Rz_carrier_right_ry_1;
  const double s8_730 = fnma(work.s2_143, work.Rz_carrier_right_rx_1, s8_729);
  work.s8_731 = fma(work.s2_154, work.Rz_arb_front_right_1, s8_730);
  const double s8_732 = fnma(work.s8_40, work.s2_244, work.s8_114*work.s2_243);
  const double s8_733 = fnma(work.s8_57, work.s6_143, fnma(work.s8_77, work.s2_245, s8_732));
  const double s8_734 = fnma(work.s8_94, work.s6_116, s8_733 - work.s6_118);
  const double s8_735 = fnma(work.s2_146, work.zdd_star_carrier_right_rz, s8_734);
  const double s8_736 = fma(work.s2_140, work.zdd_star_carrier_right_rx, s8_735);
  const double s8_737 = fnma(work.s2_152, work.zdd_star_arb_front_right, s8_736);
  work.s8_738 = 0.3333333333333333*s8_737;
  const double s8_739 = fnma(work.s2_140, work.Rz_carrier_right_rx_1, work.s1_77);
  const double s8_740 = fma(work.s2_152, work.Rz_arb_front_right_1, s8_739);
  work.s8_741 = fma(work.s2_146, work.s8_723, s8_740);
  const double s8_742 = work.s2_146*work.Rz_carrier_right_rz_2;
  const double s8_743 = fnma(work.s2_140, work.Rz_carrier_right_rx_2, s8_742);
  work.s8_744 = fma(work.s2_152, work.Rz_arb_front_right_2, s8_743);
  const double s8_745 = fma(work.s8_69, work.s2_252, work.s8_77*work.s2_254);
  const double s8_746 = s6_189 + fnma(work.s8_57, s6_190, fnma(work.s8_42, work.s2_256, s8_745));
  // drag_link
  work.s8_747 = 1.5*fma(work.s8_64, s6_188, s8_746);
  const double s8_748 = fnma(work.s8_41, work.s2_252, work.s8_114*work.s2_254);
  const double s8_749 = fma(work.s8_94, s6_190, fma(work.s8_69, work.s2_256, s8_748));
  work.s8_750 = 1.5*fma(s2_253, work.s6_195, s6_192 + fnma(work.s8_64, s6_191, s8_749));
  const double s8_751 = fnma(work.s8_40, work.s2_254, work.s8_114*work.s2_252);
  const double s8_752 = s6_187 + fma(work.s8_57, s6_191, fma(work.s8_77, work.s2_256, s8_751));
  work.s8_753 = s2_250*work.s3_36;
  work.s8_754 = 1.5*fnma(s2_250, work.s6_195, fnma(work.s8_94, s6_188, s8_752));
  const double s7_178 = K_arb_front_left_yz*R_arb_front_left_x_x;
  work.s7_179 = fnma(K_arb_front_left_xy, R_arb_front_left_x_z, s7_178);
  const double s8_755 = work.s7_105 + (work.s7_179 + (work.s7_93 + (work.s7_50 + work.s8_393)));
  const double s7_180 = h_arb_front_right_z*R_arb_front_right_x_x;
  work.s7_181 = fnma(h_arb_front_right_x, R_arb_front_right_x_z, s7_180);
  const double s7_182 = -K_arb_front_right_yz*R_arb_front_right_x_x;
  work.s7_183 = fma(K_arb_front_right_xy, R_arb_front_right_x_z, s7_182);
  work.s7_184 = fma(h_bell_crank_x, R_bell_crank_y_x, h_bell_crank_y*R_bell_crank_x_x);
  work.s7_185 = fma(h_bell_crank_y, R_bell_crank_y_x, -h_bell_crank_x*R_bell_crank_x_x);
  const double s8_756 = work.Rz_carrier_right_rx_2*work.s7_109;
  const double s8_757 = fnma(work.Rz_carrier_right_ry_2, work.s7_147, s8_756);
  work.s7_186 = -h_pitman_arm_z*R_pitman_arm_x_x;
  const double s8_758 = work.s3_36*work.s7_186;
  work.s8_759 = work.Rz_arb_front_right_2*work.s7_181;
  const double s8_760 = fnma(work.Rz_arb_front_left_2, work.s7_179, 0.9515);
  const double s8_761 = fma(work.Rz_arb_front_right_2, work.s7_183, s8_760);
  const double s8_762 = fnma(p_pitman_arm_y, s8_758, fnma(p_bell_crank_x, work.s7_185, s8_761));
  const double s8_763 = -p_bell_crank_z*work.s7_184;
  work.s8_764 = work.s7_152 + s8_755 - work.s7_183 - s8_763;
  work.s7_187 = -h_pitman_arm_z*R_pitman_arm_x_z;
  work.s8_765 = work.s3_36*work.s7_187;
  const double s8_766 = 0.3504*work.s3_36;
  const double s8_767 = fma(p_pitman_arm_x, work.s8_765, fma(p_pitman_arm_z, s8_758, s8_763));
  const double s8_768 = 0.3477*work.Rz_arb_front_right_2;
  work.s8_769 = fma(work.Rz_arb_front_right_2, s8_768, fma(work.s3_36, s8_766, 0.9515));
  work.s8_770 = work.Rz_arb_front_right_1*s8_768;
  const double s7_188 = h_arb_front_left_z*R_arb_front_left_x_x;
  work.s7_189 = fnma(h_arb_front_left_x, R_arb_front_left_x_z, s7_188);
  const double s8_771 = s8_757 + (work.s8_759 + (s8_758 - work.s7_184));
  const double s8_772 = work.Rz_carrier_right_rx_2*s8_600;
  const double s8_773 = fnma(work.Rz_carrier_right_ry_2, work.s7_124, s8_772);
  work.s8_774 = fnma(work.Rz_carrier_right_rz_2, work.s7_145, s8_773);
  const double s8_775 = fnma(work.s1_77, work.s7_139, work.Rz_carrier_right_rx_1*s8_600);
  const double s8_776 = fnma(work.Rz_carrier_right_ry_1, work.s7_124, s8_775);
  work.s8_777 = fnma(work.s7_145, work.s8_723, s8_776);
  const double s8_778 = fnma(work.Rz_carrier_right_rx_1, work.s7_124, work.s1_79*work.s7_139);
  const double s8_779 = fnma(work.s7_136, work.s8_723, s8_778);
  work.s8_780 = fma(work.Rz_carrier_right_ry_1, s8_657, s8_779);
  const double s8_781 = work.Rz_carrier_right_ry_2*s8_657;
  const double s8_782 = fnma(work.Rz_carrier_right_rx_2, work.s7_124, s8_781);
  work.s8_783 = fnma(work.Rz_carrier_right_rz_2, work.s7_136, s8_782);
  const double s8_784 = fnma(work.s3_24, work.s7_54, work.s3_22*work.s7_81);
  work.s8_785 = s8_784 + fma(work.Rz_arb_front_left_2, work.s7_189, s8_771);
  const double s8_786 = work.s8_783 + fnma(work.r_carrier_right_aux1_y, s8_757, s8_762);
  work.s8_787 = work.s8_664 + fnma(work.r_carrier_left_aux1_y, s8_784, s8_786);
  work.s8_788 = 0.3477*work.Rz_arb_front_left_2;
  const double s8_789 = work.s8_774 + fnma(work.s1_80, s8_757, s8_768 + (s8_767 - s8_766));
  const double s8_790 = fma(work.r_carrier_left_aux1_z, s8_784, work.s8_788 + s8_789);
  work.s8_791 = work.s8_669 + s8_790;
  work.s8_792 = work.s8_41 - work.s8_42;
  const double s8_793 = fma(p_bell_crank_x, work.s8_41, -p_bell_crank_z*work.s8_114);
  const double s8_794 = fnma(work.s8_792, work.s7_168, tau[Coordinate::bell_crank]);
  const double s8_795 = fma(p_bell_crank_z, work.s8_77, p_bell_crank_x*work.s8_69);
  const double s8_796 = fma(work.s7_185, s8_795, fnma(work.s7_184, s8_793, s8_794));
  const double s8_797 = fma(work.s8_691, work.s8_689, fma(work.s8_702, work.s8_682, s8_796));
  const double s8_798 = fnma(work.s8_722, work.s8_713, fnma(work.s8_707, work.s8_700, s8_797));
  const double s8_799 = fnma(work.s8_744, work.s8_738, fma(work.s8_728, work.s8_720, s8_798));
  const double s8_800 = fma(work.s8_543, work.s8_750, fma(work.s2_251, work.s8_747, s8_799));
  work.s8_801 = fnma(work.s8_753, work.s8_754, s8_800);
}

/// Part 5 of compute_accelerations: step 7: inertias of the bodies and forces on joints; step 8:
/// elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right; step 8:
/// elimination from the leaves to the root (63); step 8: elimination from the leaves to the root
/// (63), upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_5(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double s7_190 = work.cosines[4]*tau_carrier_left_rx;
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double s7_191 = fma(tau_carrier_left_rz, work.s1_35, s7_190);
  const double s7_192 = fnma(tau_carrier_left_ry, work.s1_31, s7_191);
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s7_193 = h_lower_arm_left_y*R_lower_arm_left_y_y;
  work.s7_194 = fnma(h_lower_arm_left_z, R_lower_arm_left_z_y, s7_193);
  work.s8_802 = work.s8_42 - work.s8_40;
  const double s8_803 = fnma(s7_192, work.s3_20, tau[Coordinate::lower_arm_left]);
  const double s8_804 = fnma(work.s8_802, work.s7_50, s8_803);
  const double s8_805 = fma(work.s1_75, work.f_carrier_left_y, s8_804);
  const double s8_806 = fnma(work.s1_73, work.f_carrier_left_z, s8_805);
  const double s8_807 = fnma(p_lower_arm_right_z, work.s8_40, work.s8_594);
  const double s8_808 = fnma(p_upper_arm_right_z, work.s8_40, work.s8_594);
  const double s8_809 = fnma(work.s8_665, work.n_carrier_left_x, s8_806);
  const double s7_195 = h_lower_arm_left_y*R_lower_arm_left_z_y;
  work.s7_196 = fma(h_lower_arm_left_z, R_lower_arm_left_y_y, s7_195);
  const double s8_810 = fma(p_lower_arm_right_z, work.s8_77, work.s8_552);
  const double s8_811 = fma(p_upper_arm_right_z, work.s8_77, work.s8_552);
  const double s8_812 = fnma(work.s7_194, fnma(p_pitman_arm_z, work.s8_77, s8_807), s8_809);
  const double s8_813 = fma(work.s7_196, fma(p_lower_arm_right_y, work.s8_42, s8_810), s8_812);
  const double s8_814 = fma(work.s8_693, work.s8_689, fma(work.s8_701, work.s8_682, s8_813));
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_197 = K_arb_front_left_yz*R_arb_front_left_x_z;
  const double s7_198 = fma(K_arb_front_left_xy, R_arb_front_left_x_x, s7_197);
  const double s7_199 = h_arb_front_left_z*R_arb_front_left_x_z;
  work.s7_200 = fma(h_arb_front_left_x, R_arb_front_left_x_x, s7_199);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_815 = fnma(work.s3_23, work.s7_54, work.s3_21*work.s7_81);
  const double s8_816 = fma(work.s3_23, work.s7_88, m_carrier_left_2*work.s1_73);
  const double s8_817 = fma(work.s7_81, work.s8_665, s8_816);
  const double s8_818 = fma(work.s3_21, work.s7_88, m_carrier_left_2*work.s1_75);
  work.s8_819 = fma(work.s7_54, work.s8_665, s8_818);
  const double s8_820 = fma(work.s8_707, work.s8_705, work.s8_702*work.s8_701);
  const double s8_821 = fma(p_lower_arm_left_y, work.s7_194, 1.825625);
  const double s8_822 = fma(p_lower_arm_left_z, work.s7_196, s8_821);
  const double s8_823 = work.Rz_arb_front_left_0*work.s7_200;
  const double s8_824 = fnma(work.Rz_arb_front_left_0, s7_198, s8_822);
  const double s8_825 = work.Rz_upper_arm_left_0*work.s7_173;
  const double s8_826 = fnma(p_arb_front_left_y, s8_823, s8_824);
  work.s8_827 = work.Rz_upper_arm_left_0*work.s7_175;
  const double s8_828 = fma(p_upper_arm_left_y, s8_825, s8_826);
  const double s8_829 = 0.539*work.Rz_upper_arm_left_0;
  const double s8_830 = s8_829 + fma(p_upper_arm_left_z, work.s8_827, s8_828);
  const double s8_831 = fma(work.r_carrier_left_aux1_y, s8_817, s8_830);
  const double s8_832 = 0.3333333333333333*work.s2_213;
  const double s8_833 = work.s8_676 + fma(work.r_carrier_left_aux1_z, work.s8_819, s8_831);
  const double s8_834 = work.Rz_arb_front_left_0*work.s7_189;
  const double s8_835 = fnma(work.Rz_arb_front_left_0, work.s7_179, work.s8_667);
  const double s8_836 = fnma(p_arb_front_left_y, s8_834, s8_835);
  const double s8_837 = 0.3333333333333333*work.s2_211;
  const double s8_838 = fnma(work.r_carrier_left_aux1_y, s8_815, s8_836);
  const double s8_839 = fma(work.s8_705, work.s8_705, work.s8_701*work.s8_701);
  const double s8_840 = 0.3333333333333333*work.s2_214;
  const double s8_841 = 0.3477*work.Rz_arb_front_left_0;
  const double s8_842 = fma(work.Rz_arb_front_left_0, s8_841, 1.825625);
  work.s8_843 = s8_834 + s8_815;
  const double s8_844 = fma(p_arb_front_left_z, s8_834, fma(p_arb_front_left_x, s8_823, s8_841));
  work.s8_845 = s8_817 + (s8_825 + (work.s7_194 - s8_823));
  const double s8_846 = fma(work.s1_73, s8_817, fma(work.Rz_upper_arm_left_0, s8_829, s8_842));
  work.s8_847 = s8_817 + (work.s7_194 + s8_825);
  const double s8_848 = work.s8_671 + fma(work.r_carrier_left_aux1_z, s8_815, s8_844);
  const double s8_849 = fnma(work.s3_21, work.s8_667, fma(work.s1_75, work.s8_819, s8_846));
  const double s8_850 = fma(work.s8_665, work.s8_676, fnma(work.s3_23, work.s8_671, s8_849));
  const double s8_851 = fma(109.75, work.r_carrier_right_aux1_y, work.s7_147);
  const double s8_852 = work.r_carrier_right_aux1_y + work.r_carrier_right_aux1_y;
  const double s8_853 = fma(109.75, work.r_carrier_left_aux1_y, work.s7_81);
  const double s8_854 = fma(work.s3_24, work.s7_88, work.Rz_carrier_left_rz_2*work.s7_81);
  const double s8_855 = work.r_carrier_left_aux1_y + work.r_carrier_left_aux1_y;
  const double s8_856 = fma(s8_853, s8_855, fma(s8_851, s8_852, work.s8_545));
  work.s8_857 = 1.0/work.pivot_arb_rear_left;
  const double s8_858 = work.pivot_arb_rear_left - 1.5272999999999997e-20;
  result.inertia[11] = fnma(1e-12, work.s8_493, s8_858);
  work.s8_859 = work.s8_857*work.s8_527;
  work.s8_860 = work.s8_480*work.s8_520;
  const double s8_861 = fma(work.s8_525, work.s8_859, work.s8_464);
  const double s8_862 = fnma(work.s8_859, work.s8_531, work.s8_391);
  const double s8_863 = work.s7_124 + (work.s7_71 + fma(work.s8_479, work.s8_860, s8_861));
  work.s8_864 = s8_851 + s8_853;
  const double R_arb_front_right_x_x = work.cosines[14];
  const double R_arb_front_right_x_z = work.sines[14];
  const double s7_201 = K_arb_front_right_xy*R_arb_front_right_x_x;
  const double s7_202 = fma(K_arb_front_right_yz, R_arb_front_right_x_z, s7_201);
  const double s8_865 = fma(p_bell_crank_x, work.s7_184, s7_202 + (s7_198 + work.s8_364));
  work.s8_866 = work.s7_168 + s8_865;
  const double s8_867 = work.Rz_carrier_right_rz_2*work.s7_147;
  const double s8_868 = fnma(work.Rz_carrier_right_rx_2, work.s7_139, s8_867);
  const double s8_869 = work.Rz_carrier_right_ry_2*work.s7_139;
  const double s8_870 = fnma(work.Rz_carrier_right_rz_2, work.s7_109, s8_869);
  const double s8_871 = fnma(work.s1_79, work.s7_109, work.s1_77*work.s7_147);
  const double s8_872 = fnma(work.Rz_carrier_right_ry_1, work.s7_136, s8_871);
  const double s8_873 = fnma(work.Rz_carrier_right_rx_1, work.s7_145, s8_872);
  const double s8_874 = fma(work.s7_170, work.s8_723, s8_873);
  const double s8_875 = work.Rz_carrier_right_rz_2*work.s7_170;
  const double s8_876 = fnma(work.Rz_carrier_right_ry_2, work.s7_136, s8_875);
  const double s8_877 = fnma(work.Rz_carrier_right_rx_2, work.s7_145, s8_876);
  const double s8_878 = fma(work.s3_22, work.s7_88, work.Rz_carrier_left_rz_2*work.s7_54);
  const double s8_879 = fma(109.75, work.r_carrier_left_aux1_z, work.s7_54);
  const double s8_880 = 395.1 + work.s7_88;
  const double s8_881 = work.r_carrier_right_aux1_y*s8_868;
  const double s8_882 = fnma(work.Rz_arb_front_left_2, s7_198, s8_881);
  const double s8_883 = fnma(work.Rz_arb_front_right_2, s7_202, s8_882);
  const double s8_884 = 0.539*work.s3_29;
  const double s8_885 = fma(work.s3_29, s8_884, work.s8_769);
  const double s8_886 = fma(p_bell_crank_z, work.s7_185, s8_883) - s8_884;
  const double s8_887 = fma(work.Rz_carrier_right_rx_2, work.s8_774, s8_885);
  const double s8_888 = fma(work.s1_77, s8_868, fma(work.s3_28, s8_884, work.s8_770));
  const double s8_889 = fma(work.Rz_carrier_right_ry_2, work.s8_783, s8_887);
  const double s8_890 = fma(work.s1_79, s8_870, s8_888);
  const double s8_891 = fma(work.Rz_carrier_right_rz_2, s8_877, s8_889);
  const double s8_892 = fma(work.Rz_carrier_right_rx_1, work.s8_774, s8_890);
  const double s8_893 = fma(work.Rz_carrier_right_ry_1, work.s8_783, s8_892);
  const double s8_894 = 0.539*work.Rz_upper_arm_left_2;
  const double s8_895 = work.Rz_arb_front_left_0*work.s8_788;
  const double s8_896 = fma(work.Rz_arb_front_left_2, work.s8_788, s8_891);
  const double s8_897 = fma(work.Rz_upper_arm_left_2, s8_894, s8_896);
  const double s8_898 = s8_894 + (s8_877 + fma(work.s1_80, s8_870, s8_886));
  const double s8_899 = fma(work.s1_73, s8_854, fma(work.Rz_upper_arm_left_0, s8_894, s8_895));
  const double s8_900 = fma(work.r_carrier_left_aux1_y, s8_854, s8_898);
  const double s8_901 = fma(work.s2_160, work.s8_665, fma(work.s2_164, work.s3_23, work.s1_73));
  const double s8_902 = fnma(work.s3_24, work.s8_669, fnma(work.s3_22, work.s8_664, s8_897));
  const double s8_903 = fma(work.s2_157, work.s8_665, fma(work.s2_164, work.s3_21, work.s1_75));
  const double s8_904 = fnma(work.s3_21, work.s8_664, fma(work.s1_75, s8_878, s8_899));
  const double s8_905 = work.s8_673 + fma(work.r_carrier_left_aux1_z, s8_878, s8_900);
  const double s8_906 = fma(work.s8_665, work.s8_673, fnma(work.s3_23, work.s8_669, s8_904));
  const double s8_907 = fma(work.s8_707, work.s8_707, work.s8_702*work.s8_702);
  const double s8_908 = fma(work.s8_722, work.s8_722, fma(work.s8_691, work.s8_691, s8_907));
  const double s8_909 = fnma(109.75, work.s1_80, work.s7_109);
  const double s8_910 = fnma(work.s1_80, s8_851, s8_863);
  const double s8_911 = fma(work.r_carrier_right_aux1_y, s8_909, s8_910);
  const double s8_912 = fma(work.r_carrier_left_aux1_y, s8_879, s8_911);
  const double s8_913 = fma(work.r_carrier_left_aux1_z, s8_853, s8_912);
  work.s8_914 = s8_909 + s8_879;
  const double s8_915 = work.r_carrier_left_aux1_z + work.r_carrier_left_aux1_z;
  const double s8_916 = fma(s8_879, s8_915, fnma(work.s1_80 + work.s1_80, s8_909, work.s8_654));
  work.s8_917 = work.s8_857*work.s8_526;
  work.s8_918 = work.s8_466*work.s8_520;
  const double s8_919 = fma(work.s8_525, work.s8_917, work.s8_476);
  const double s8_920 = fma(work.s8_917, work.s8_527, work.s8_478);
  const double s8_921 = fnma(work.s8_917, work.s8_531, work.s8_407);
  const double s8_922 = fnma(work.s8_519, work.s8_918, s8_921);
  const double s8_923 = fma(work.zdd_star_arb_front_left, s7_198, s8_922);
  const double s8_924 = 395.1 + work.s7_139;
  const double s8_925 = work.s7_136 + (work.s7_78 + fma(work.s8_479, work.s8_918, s8_919));
  const double s8_926 = work.s7_145 + (work.s7_83 + fma(work.s8_480, work.s8_918, s8_920));
  const double s8_927 = fnma(work.s1_80, s8_924, s8_925);
  work.s8_928 = s8_924 + s8_880;
  const double s8_929 = fma(work.r_carrier_right_aux1_y, s8_924, s8_926);
  const double s8_930 = fma(work.r_carrier_left_aux1_z, s8_880, s8_927);
  const double s8_931 = fma(work.r_carrier_left_aux1_y, s8_880, s8_929);
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_203 = -h_upper_arm_right_z*R_upper_arm_right_z_y;
  work.s7_204 = fma(h_upper_arm_right_y, R_upper_arm_right_y_y, s7_203);
  const double s7_205 = -h_upper_arm_right_z*R_upper_arm_right_y_y;
  work.s7_206 = fnma(h_upper_arm_right_y, R_upper_arm_right_z_y, s7_205);
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s8_932 = zd_bell_crank*(zd_bell_crank + work.s8_64);
  const double s8_933 = zd_bell_crank*work.s8_57;
  const double s8_934 = fma(work.zdd_star_arb_front_right, s7_202, s8_923);
  const double s8_935 = zd_bell_crank*work.s8_94;
  const double s8_936 = fma(work.s7_169, s8_933, fnma(work.s8_519, work.s8_860, s8_862));
  work.s8_937 = fnma(work.s7_185, s8_933, work.s7_184*s8_935);
  work.s8_938 = work.s7_184*s8_932;
  work.s8_939 = work.s7_185*s8_932;
  const double s8_940 = fma(p_bell_crank_x, work.s8_937, fma(work.s7_168, s8_935, s8_936));
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s8_941 = zd_pitman_arm*(zd_pitman_arm + work.s8_94);
  const double s8_942 = zd_pitman_arm*work.s8_57;
  const double s8_943 = zd_pitman_arm*work.s8_64;
  work.s8_944 = fma(work.s7_186, s8_943, work.s7_187*s8_942);
  work.s8_945 = fma(work.s7_187, s8_941, work.s6_195*work.s7_186);
  work.s8_946 = fnma(work.s6_195, work.s7_187, work.s7_186*s8_941);
  const double s8_947 = fma(0.3504, work.s6_195, fnma(p_bell_crank_z, work.s8_939, s8_940));
  const double s8_948 = fma(p_pitman_arm_x, work.s8_946, s8_947);
  const double s8_949 = fnma(p_pitman_arm_z, work.s8_945, s8_948);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s8_950 = zd_arb_front_right*(zd_arb_front_right + work.s8_94);
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s8_951 = zd_upper_arm_right*work.s8_64;
  const double s8_952 = zd_upper_arm_right*work.s8_94;
  work.s8_953 = fnma(work.s7_206, s8_951, work.s7_204*s8_952);
  work.s8_954 = work.s8_857*work.s8_525;
  work.s8_955 = work.s8_479*work.s8_520;
  const double s8_956 = fnma(work.s8_954, work.s8_531, work.s8_378);
  const double s8_957 = fnma(work.s8_519, work.s8_955, s8_956);
  const double s8_958 = fma(work.zdd_star_arb_front_left, work.s7_179, s8_957);
  const double s8_959 = fnma(work.zdd_star_arb_front_right, work.s7_183, s8_958);
  const double s8_960 = fnma(work.s7_163, s8_942, fma(p_bell_crank_x, work.s8_938, s8_959));
  const double s8_961 = fma(p_pitman_arm_x, work.s8_944, fnma(work.s7_162, s8_943, s8_960));
  const double s8_962 = zd_arb_front_right*work.s8_64;
  const double s8_963 = zd_arb_front_right*work.s8_57;
  const double s8_964 = fnma(work.s7_158, s8_962, fnma(s7_202, s8_950, s8_961));
  const double s8_965 = fma(work.s7_152, s8_951, fnma(work.s7_159, s8_963, s8_964));
  const double s8_966 = fma(work.s7_153, s8_952, s8_965);
  const double s8_967 = fma(work.r_carrier_right_aux1_y, work.f_carrier_right_x, s8_966);
  const double s7_207 = 0.539 - work.s7_153;
  const double s8_968 = fnma(0.3477, work.zdd_star_arb_front_right, s8_949);
  const double s8_969 = fnma(work.s7_152, s8_952, fnma(s7_207, s8_951, s8_968));
  const double s8_970 = fms(work.s8_802, work.s7_152, tau[Coordinate::upper_arm_right]);
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s7_208 = -h_lower_arm_right_z*R_lower_arm_right_z_y;
  work.s7_209 = fma(h_lower_arm_right_y, R_lower_arm_right_y_y, s7_208);
  const double s7_210 = -h_lower_arm_right_z*R_lower_arm_right_y_y;
  work.s7_211 = fnma(h_lower_arm_right_y, R_lower_arm_right_z_y, s7_210);
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s8_971 = zd_lower_arm_right*work.s8_64;
  const double s8_972 = zd_lower_arm_right*work.s8_94;
  const double s8_973 = fma(work.s7_105, s8_971, s8_967 - work.n_carrier_right_z);
  work.s8_974 = fnma(work.s7_211, s8_971, work.s7_209*s8_972);
  const double s7_212 = 1.825625 - work.s7_106;
  const double s8_975 = fma(work.s1_80, work.f_carrier_right_x, s8_969) - work.n_carrier_right_y;
  const double s8_976 = fnma(work.s7_105, s8_972, fnma(s7_212, s8_971, s8_975));
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s8_977 = zd_arb_front_left*(zd_arb_front_left + work.s8_94);
  const double s8_978 = zd_arb_front_left*work.s8_64;
  const double s8_979 = fnma(s7_198, s8_977, fma(work.s7_106, s8_972, s8_973));
  const double s8_980 = zd_arb_front_left*work.s8_57;
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s8_981 = zd_upper_arm_left*work.s8_94;
  const double s8_982 = fnma(work.s7_100, s8_980, fnma(work.s7_99, s8_978, s8_979));
  const double s8_983 = fnma(0.3477, work.zdd_star_arb_front_left, s8_976);
  const double s8_984 = zd_upper_arm_left*work.s8_64;
  work.s8_985 = fma(work.s7_175, s8_984, work.s7_173*s8_981);
  const double s8_986 = fma(work.s7_93, s8_984, fma(work.s7_94, s8_981, s8_982));
  const double s8_987 = fnma(work.s8_802, work.s7_93, tau[Coordinate::upper_arm_left]);
  const double s8_988 = fma(work.r_carrier_left_aux1_y, work.f_carrier_left_x, s8_986);
  const double s8_989 = fnma(work.R_carrier_left_aux1_z_x, tau_carrier_left_rx,
      work.n_carrier_left_z);
  const double s8_990 = fnma(tau_carrier_left_ry, work.s1_28, s8_989);
  const double s8_991 = fnma(tau_carrier_left_rz, work.s1_30, s8_990);
  const double s7_213 = 0.539 - work.s7_94;
  const double s8_992 = fnma(s7_213, s8_984, fnma(work.s7_93, s8_981, s8_983));
  const double s8_993 = fnma(work.r_carrier_left_aux1_z, work.f_carrier_left_x, s8_992);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s8_994 = zd_lower_arm_left*work.s8_94;
  const double s8_995 = zd_lower_arm_left*work.s8_64;
  work.s8_996 = fma(work.s7_196, s8_995, work.s7_194*s8_994);
  const double s8_997 = fma(work.s7_51, s8_994, s8_988 - work.n_carrier_left_z);
  const double s8_998 = fma(work.s2_211, work.s8_682, fma(work.s7_50, s8_995, s8_997));
  const double s8_999 = fma(work.s2_243, work.s8_713, fnma(work.s2_214, work.s8_689, s8_998));
  const double s8_1000 = fma(work.s2_252, work.s8_747, fma(work.s2_245, work.s8_720, s8_999));
  const double s7_214 = 1.825625 - work.s7_51;
  const double s8_1001 = fnma(work.s7_50, s8_994, s8_993 - work.n_carrier_left_y);
  work.s8_1002 = s7_214 - work.s7_51;
  const double s8_1003 = fma(work.s2_213, work.s8_689, fnma(s7_214, s8_995, s8_1001));
  const double s8_1004 = fma(work.s2_244, work.s8_720, fnma(work.s2_211, work.s8_700, s8_1003));
  work.s8_1005 = s7_212 - work.s7_106;
  const double s8_1006 = work.s7_106 + (work.s7_94 + (5020.856800000031 + work.s7_51));
  const double s8_1007 = fma(work.s2_254, work.s8_750, fnma(work.s2_243, work.s8_738, s8_1004));
  const double s7_215 = 0.9515 - work.s7_169;
  work.s8_1008 = s7_215 + (work.s7_153 + s8_1006);
  const double s8_1009 = fnma(s7_215, s8_935, fnma(work.s7_168, s8_933, s8_934));
  const double s8_1010 = fms(work.s8_306, work.s7_162, tau[Coordinate::pitman_arm]);
  const double s7_216 = 0.3504 - work.s7_163;
  const double s8_1011 = fma(work.s7_162, s8_942, fnma(p_bell_crank_z, work.s8_938, s8_1009));
  const double s7_217 = h_arb_front_right_z*R_arb_front_right_x_z;
  work.s7_218 = fma(h_arb_front_right_x, R_arb_front_right_x_x, s7_217);
  work.s8_1012 = fnma(work.s7_218, s8_950, work.zdd_star_arb_front_right*work.s7_181);
  work.s8_1013 = fma(work.s7_181, s8_950, work.zdd_star_arb_front_right*work.s7_218);
  const double s7_219 = 0.3477 - work.s7_159;
  const double s8_1014 = fnma(work.s7_183, s8_950, fma(s7_216, s8_943, s8_1011));
  work.s8_1015 = fma(work.s7_218, s8_963, work.s7_181*s8_962);
  const double s8_1016 = fma(work.s7_158, s8_963, fma(s7_219, s8_962, s8_1014));
  const double s8_1017 = fma(0.539, work.s6_179, s8_1016);
  const double s8_1018 = fnma(work.s1_80, work.f_carrier_right_y, s8_1017);
  const double s8_1019 = fnma(work.r_carrier_right_aux1_y, work.f_carrier_right_z, s8_1018);
  const double s8_1020 = fnma(work.s8_69, work.s7_179, tau[Coordinate::arb_front_left]);
  work.s8_1021 = fnma(work.s7_200, s8_977, work.zdd_star_arb_front_left*work.s7_189);
  work.s8_1022 = fma(work.s7_189, s8_977, work.zdd_star_arb_front_left*work.s7_200);
  const double s7_220 = 0.3477 - work.s7_100;
  const double s8_1023 = fma(work.s7_179, s8_977, s8_1019 - work.n_carrier_right_x);
  work.s8_1024 = fma(work.s7_200, s8_980, work.s7_189*s8_978);

  // --- step 8: elimination from the leaves to the root (63), continued ---
  const double s8_1025 = fma(work.s7_99, s8_980, fma(s7_220, s8_978, s8_1023));
  const double s8_1026 = s7_207 + (s7_212 + (s7_220 + (s7_213 + (s7_214 + work.s8_532))));
  const double s8_1027 = fma(0.539, work.s6_159, s8_1025);
  work.s8_1028 = s7_216 + (s7_219 + s8_1026);
  work.s8_1029 = work.r_carrier_left_aux1_z - work.s1_80;
  const double s8_1030 = fma(work.r_carrier_left_aux1_z, work.f_carrier_left_y, s8_1027);
  const double s8_1031 = fnma(work.r_carrier_left_aux1_y, work.f_carrier_left_z, s8_1030);
  const double s8_1032 = fnma(work.s2_213, work.s8_682, s8_1031 - work.n_carrier_left_x);
  const double s8_1033 = fnma(work.s2_244, work.s8_713, fma(work.s2_214, work.s8_700, s8_1032));
  const double s8_1034 = fnma(work.s2_254, work.s8_747, fnma(work.s2_245, work.s8_738, s8_1033));
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s7_221 = work.cosines[10]*tau_carrier_right_rx;
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double s7_222 = fma(tau_carrier_right_rz, work.s1_51, s7_221);
  const double s7_223 = fnma(tau_carrier_right_ry, work.s1_47, s7_222);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_1035 = fnma(s7_223, work.s3_30, tau[Coordinate::lower_arm_right]);
  const double s8_1036 = fnma(work.s8_802, work.s7_105, s8_1035);
  const double s8_1037 = fnma(work.s1_79, work.f_carrier_right_y, s8_1036);
  const double s8_1038 = fnma(work.s1_77, work.f_carrier_right_z, s8_1037);
  const double s8_1039 = fnma(work.s8_723, work.n_carrier_right_x, s8_1038);
  const double s8_1040 = fnma(p_lower_arm_right_y, work.s8_42, s8_810);
  const double s8_1041 = fma(p_pitman_arm_z, work.s8_77, s8_807);
  const double s8_1042 = fnma(work.s7_209, s8_1041, fnma(work.s7_211, s8_1040, s8_1039));
  const double s8_1043 = fma(work.s8_731, work.s8_720, fnma(work.s8_725, work.s8_713, s8_1042));
  const double s8_1044 = work.Rz_carrier_right_rx_1*work.s7_109;
  const double s8_1045 = fnma(work.Rz_carrier_right_ry_1, work.s7_147, s8_1044);
  const double s8_1046 = m_carrier_right_2*work.s1_79;
  const double s8_1047 = fma(work.Rz_carrier_right_ry_1, work.s7_139, s8_1046);
  const double s8_1048 = fnma(work.s7_109, work.s8_723, s8_1047);
  const double s8_1049 = m_carrier_right_2*work.s1_77;
  const double s8_1050 = fnma(work.Rz_carrier_right_rx_1, work.s7_139, s8_1049);
  const double s8_1051 = fma(work.s7_147, work.s8_723, s8_1050);
  const double s8_1052 = fma(work.s8_744, work.s8_741, work.s8_722*work.s8_725);
  const double s8_1053 = fma(work.s8_728, work.s8_731, s8_1052);
  const double s8_1054 = work.Rz_arb_front_right_1*work.s7_181;
  const double s8_1055 = work.Rz_arb_front_right_1*work.s7_183;
  const double s8_1056 = fnma(p_arb_front_right_y, s8_1054, s8_1055);
  const double s8_1057 = 0.3333333333333333*work.s2_243;
  const double s8_1058 = fnma(s8_832, work.s8_691, fnma(s8_837, work.s8_707, work.s8_791));
  const double s8_1059 = fma(s8_840, work.s8_691, fnma(s8_837, work.s8_702, work.s8_787));
  const double s8_1060 = work.s8_780 + fnma(work.r_carrier_right_aux1_y, s8_1045, s8_1056);
  const double s8_1061 = fma(p_lower_arm_right_y, work.s7_209, 1.825625);
  const double s8_1062 = fnma(p_lower_arm_right_z, work.s7_211, s8_1061);
  const double s8_1063 = fma(work.s8_77, s7_202, tau[Coordinate::arb_front_right]);
  const double s8_1064 = work.Rz_arb_front_right_1*work.s7_218;
  const double s8_1065 = fnma(work.Rz_arb_front_right_1, s7_202, s8_1062);
  const double s8_1066 = 0.539*work.s3_28;
  const double s8_1067 = work.s3_28*work.s7_206;
  const double s8_1068 = fnma(p_arb_front_right_y, s8_1064, s8_1065) - s8_1066;
  work.s8_1069 = s8_1048 + (work.s7_211 - s8_1067);
  const double s8_1070 = work.s3_28*work.s7_204;
  const double s8_1071 = fma(p_upper_arm_right_z, s8_1067, s8_1068);
  const double s8_1072 = fma(work.s1_80, s8_1048, fnma(p_upper_arm_right_y, s8_1070, s8_1071));
  const double s8_1073 = 0.3333333333333333*work.s2_244;
  const double s8_1074 = fma(s8_840, work.s8_707, fma(s8_832, work.s8_702, s8_905));
  const double s8_1075 = s8_874 + fma(work.r_carrier_right_aux1_y, s8_1051, s8_1072);
  const double s8_1076 = fma(work.s8_741, work.s8_741, work.s8_725*work.s8_725);
  const double s8_1077 = 0.3333333333333333*work.s2_245;
  work.s8_1078 = s8_1054 + s8_1045;
  work.s8_1079 = s8_1051 + (work.s7_209 - s8_1064 - s8_1070);
  work.s8_1080 = s8_1070 - work.s7_209 - s8_1051;
  const double s8_1081 = 0.3477*work.Rz_arb_front_right_1;
  const double s8_1082 = s8_1081 + fma(p_arb_front_right_z, s8_1054, p_arb_front_right_x*s8_1064);
  const double s8_1083 = fma(work.Rz_arb_front_right_1, s8_1081, 1.825625);
  const double s8_1084 = work.s8_777 + fnma(work.s1_80, s8_1045, s8_1082);
  const double s8_1085 = fma(work.s1_79, s8_1048, fma(work.s3_28, s8_1066, s8_1083));
  const double s8_1086 = fma(work.s2_181, work.Rz_carrier_right_ry_1, work.s1_79);
  const double s8_1087 = fnma(work.s2_174, work.s8_723, s8_1086);
  const double s8_1088 = fma(work.s1_77, s8_1051, s8_1085);
  const double s8_1089 = fnma(work.s2_181, work.Rz_carrier_right_rx_1, work.s1_77);
  const double s8_1090 = fma(work.s2_177, work.s8_723, s8_1089);
  const double s8_1091 = fma(work.Rz_carrier_right_rx_1, work.s8_777, s8_1088);
  const double s8_1092 = fma(work.Rz_carrier_right_ry_1, work.s8_780, s8_1091);
  const double s8_1093 = fma(work.s8_731, work.s8_731, s8_1076);
  const double s8_1094 = 1.5*work.s2_256;
  const double s8_1095 = fnma(s8_1077, work.s8_744, fnma(s8_1073, work.s8_722, s8_1074));
  const double s8_1096 = fnma(work.s2_245, s8_1077, fnma(work.s2_214, s8_840, s8_856));
  const double s8_1097 = fma(work.s2_244, s8_1077, fnma(work.s2_213, s8_840, s8_913));
  const double s8_1098 = 1.5*work.s2_254;
  const double s8_1099 = fnma(work.s2_244, s8_1073, fnma(work.s2_213, s8_832, s8_916));
  const double s8_1100 = 1.5*work.s2_252;
  const double s8_1101 = fnma(s8_1073, work.s8_728, fnma(s8_1057, work.s8_744, s8_1058));
  const double s8_1102 = fnma(s8_1077, work.s8_728, fma(s8_1057, work.s8_722, s8_1059));
  const double s8_1103 = fnma(work.s2_243, s8_1057, fnma(work.s2_211, s8_837, work.s8_547));
  const double s8_1104 = fnma(work.s2_244, s8_1057, fnma(work.s2_213, s8_837, s8_930));
  const double s8_1105 = fma(work.s2_245, s8_1057, fnma(work.s2_214, s8_837, s8_931));
  const double s8_1106 = fma(work.s8_753, work.s8_753, work.s2_251*work.s2_251);
  const double s8_1107 = fma(work.Rz_carrier_left_rz_2, work.s8_673, s8_902);
  const double s8_1108 = fma(work.s8_728, work.s8_728, fma(work.s8_744, work.s8_744, s8_908));
  const double s8_1109 = fnma(1.5, fma(work.s8_543, work.s8_543, s8_1106), s8_1107);
  const double s8_1110 = fma(work.s8_77, work.s2_190, work.s8_40*work.s2_189);
  const double s8_1111 = fma(work.s8_94, work.s6_124, fnma(work.s8_114, work.s2_191, s8_1110));
  const double s8_1112 = fnma(work.s8_57, work.s6_129, s8_1111) - work.s6_122;
  const double s8_1113 = fnma(work.s2_160, work.zdd_star_carrier_left_rz, s8_1112);
  const double s8_1114 = fma(work.s2_164, work.zdd_star_carrier_left_rx, s8_1113);
  const double s8_1115 = 1.1666666666666667*s8_1114;
  const double s8_1116 = fnma(work.s8_114, work.s2_189, work.s8_69*work.s2_190);
  const double s8_1117 = fnma(work.s8_94, work.s6_130, fma(work.s8_41, work.s2_191, s8_1116));
  const double s8_1118 = work.s6_131 + fma(work.s8_64, work.s6_129, s8_1117);
  const double s8_1119 = fnma(work.s8_77, work.s2_189, work.s8_57*work.s6_130);
  const double s8_1120 = fma(work.s2_160, work.zdd_star_carrier_left_ry, s8_1118);
  const double s8_1121 = fnma(work.s2_157, work.zdd_star_carrier_left_rx, s8_1120);
  const double s8_1122 = 1.1666666666666667*s8_1121;
  const double s8_1123 = fnma(work.s8_69, work.s2_191, fnma(work.s8_42, work.s2_190, s8_1119));
  const double s8_1124 = fma(work.s2_191, s8_1115, fnma(work.s2_252, work.s8_754, s8_1007));
  const double s8_1125 = fnma(work.s8_64, work.s6_124, s8_1123) - work.s6_126;
  const double s8_1126 = fma(work.s2_157, work.zdd_star_carrier_left_rz, s8_1125);
  const double s8_1127 = fnma(work.s2_164, work.zdd_star_carrier_left_ry, s8_1126);
  const double s8_1128 = 1.1666666666666667*s8_1127;
  const double s8_1129 = fnma(work.s2_190, s8_1122, fnma(work.s2_256, work.s8_750, s8_1000));
  const double s8_1130 = fma(work.s2_190, s8_1115, fma(work.s2_256, work.s8_754, s8_1034));
  const double s8_1131 = fnma(work.s2_157, work.s3_23, work.s2_160*work.s3_21);
  const double s8_1132 = fma(work.s2_164, work.s3_24, work.s2_160*work.Rz_carrier_left_rz_2);
  const double s8_1133 = fnma(s8_901, s8_1115, fnma(work.s8_705, work.s8_700, s8_814));
  const double s8_1134 = fnma(work.s8_538, s8_1122, fnma(s8_1132, s8_1115, work.s8_801));
  const double s8_1135 = fnma(0.3333333333333333, fma(work.s8_691, work.s8_693, s8_820), s8_906);
  const double s8_1136 = fma(s8_903, work.s8_537, fma(s8_1131, work.s8_538, s8_1132*s8_901));
  work.s8_1137 = fnma(1.1666666666666667, s8_1136, s8_1135);
  const double s8_1138 = fnma(0.3333333333333333, fma(work.s8_693, work.s8_693, s8_839), s8_850);
  const double s8_1139 = fma(s8_903, s8_903, fma(s8_901, s8_901, s8_1131*s8_1131));
  work.s8_1140 = fnma(1.1666666666666667, s8_1139, s8_1138);
  const double s8_1141 = 1.1666666666666667*work.s2_191;
  const double s8_1142 = fnma(s8_1098, work.s8_543, fnma(work.s8_753, s8_1100, s8_1101));
  const double s8_1143 = fnma(s8_832, work.s8_693, fnma(s8_837, work.s8_705, s8_848));
  const double s8_1144 = 1.1666666666666667*work.s2_190;
  const double s8_1145 = fma(work.s2_251, s8_1098, fma(work.s8_753, s8_1094, s8_1095));
  const double s8_1146 = fma(s8_1094, work.s8_543, fnma(work.s2_251, s8_1100, s8_1102));
  const double s8_1147 = fma(s8_840, work.s8_705, fma(s8_832, work.s8_701, s8_833));
  const double s8_1148 = fma(s8_840, work.s8_693, fnma(s8_837, work.s8_701, s8_838));
  work.s8_1149 = fma(s8_1141, s8_903, fnma(s8_1131, s8_1144, s8_1148));
  const double s8_1150 = fma(work.s8_538, work.s8_538, s8_1132*s8_1132);
  const double s8_1151 = 1.1666666666666667*work.s2_189;
  work.s8_1152 = fnma(s8_903, s8_1151, fma(s8_1144, s8_901, s8_1147));
  work.s8_1153 = fnma(s8_1131, s8_1151, fma(s8_1141, s8_901, s8_1143));
  const double s8_1154 = work.s2_177*work.Rz_carrier_right_rz_2;
  const double s8_1155 = fnma(work.s2_181, work.Rz_carrier_right_rx_2, s8_1154);
  const double s8_1156 = fma(work.s8_540, work.s8_540, fma(work.s8_537, work.s8_537, s8_1150));
  const double s8_1157 = fma(work.s8_542, work.s8_542, fma(s8_1155, s8_1155, s8_1156));
  const double s8_1158 = fnma(0.3333333333333333, s8_1108, s8_1109);
  work.pivot_bell_crank = fnma(1.1666666666666667, s8_1157, s8_1158);
  const double s8_1159 = work.Rz_arb_front_right_2*work.s7_218;
  const double s8_1160 = fms(work.s3_29, work.s7_204, s8_868);
  const double s8_1161 = fms(work.s3_29, work.s7_204, work.s8_765);
  const double s8_1162 = fnma(work.s3_29, work.s7_204, s8_868 - work.s8_765 - s8_1159);
  const double s8_1163 = fnma(work.Rz_arb_front_left_2, work.s7_200, s8_1162);
  work.s8_1164 = s8_854 + fma(work.Rz_upper_arm_left_2, work.s7_173, s8_1163);
  const double s8_1165 = 1.1666666666666667*work.s2_228;
  const double s8_1166 = fnma(work.s8_538, s8_1151, fma(s8_1132, s8_1141, s8_1142));
  const double s8_1167 = fma(s8_1141, work.s8_537, fnma(s8_1144, work.s8_538, s8_1146));
  const double s8_1168 = fnma(work.s2_191, s8_1141, fnma(work.s2_252, s8_1100, s8_1103));
  work.s8_1169 = fnma(work.s2_228, s8_1165, s8_1168);
  const double s8_1170 = fnma(work.s2_189, s8_1141, fnma(work.s2_254, s8_1100, s8_1104));
  work.s8_1171 = fma(work.s2_226, s8_1165, s8_1170);
  const double s8_1172 = fma(work.s2_190, s8_1141, fnma(work.s2_256, s8_1100, s8_1105));
  work.s8_1173 = fma(work.s2_227, s8_1165, s8_1172);
  const double s8_1174 = 1.1666666666666667*work.s2_226;
  const double s8_1175 = fnma(s8_1077, work.s8_741, fnma(s8_1073, work.s8_725, s8_1075));
  const double s8_1176 = fnma(work.s2_189, s8_1151, fnma(work.s2_254, s8_1098, s8_1099));
  work.s8_1177 = fnma(work.s2_226, s8_1174, s8_1176);
  const double s8_1178 = fnma(work.Rz_upper_arm_left_2, work.s7_173, s8_1160) - s8_854;
  const double s8_1179 = fma(work.s8_542, s8_1174, fnma(s8_1155, s8_1165, s8_1166));
  const double s8_1180 = fma(work.Rz_arb_front_left_2, work.s7_189, work.s8_759);
  const double s8_1181 = fma(p_lower_arm_left_x, s8_1178, s8_1179);
  const double s8_1182 = fma(work.Rz_arb_front_left_2, work.s7_200, s8_1159);
  const double s8_1183 = fma(p_rear_axle_tx_z, s8_1180, s8_1181);
  work.s8_1184 = fma(p_arb_front_left_x, s8_1182, s8_1183);
  const double s8_1185 = 1.1666666666666667*work.s2_227;
  const double s8_1186 = fnma(s8_1151, work.s8_537, fma(s8_1132, s8_1144, s8_1145));
  work.s8_1187 = fnma(s8_1185, s8_1090, fma(s8_1174, s8_1087, s8_1175));
  const double s8_1188 = fnma(work.s2_190, s8_1144, fnma(work.s2_256, s8_1094, s8_1096));
  work.s8_1189 = fnma(work.s2_227, s8_1185, s8_1188);
  const double s8_1190 = fma(work.s2_189, s8_1144, fnma(work.s2_254, s8_1094, s8_1097));
  work.s8_1191 = fnma(work.s2_226, s8_1185, s8_1190);
  const double s8_1192 = fnma(work.s8_540, s8_1174, fnma(s8_1155, s8_1185, s8_1186));
  const double s8_1193 = fma(work.Rz_upper_arm_left_2, work.s7_173, s8_1161);
  const double s8_1194 = work.s3_29*work.s7_206;
  const double s8_1195 = fma(work.Rz_upper_arm_left_2, work.s7_175, s8_1194);
  const double s8_1196 = fnma(p_rear_axle_tx_z, s8_1193, s8_1192);
  const double s8_1197 = fnma(work.Rz_arb_front_left_2, work.s7_200, s8_1159);
  const double s8_1198 = fma(p_upper_arm_right_z, s8_1195, s8_1196);
  work.s8_1199 = fnma(p_arb_front_right_y, s8_1197, s8_1198);
  const double s8_1200 = s8_870 - work.s7_185 - s8_1194;
  work.s8_1201 = fnma(work.Rz_upper_arm_left_2, work.s7_175, s8_1200) - s8_878;
  const double s8_1202 = fnma(work.Rz_upper_arm_left_2, work.s7_175, s8_870 - s8_1194) - s8_878;
  const double s8_1203 = fnma(work.s8_542, s8_1185, fnma(work.s8_540, s8_1165, s8_1167));
  // tie_rod_right
  const double s8_1204 = fnma(work.Rz_arb_front_left_2, work.s7_189, work.s8_759);
  const double s8_1205 = fma(p_lower_arm_left_x, s8_1202, s8_1203);
  work.s8_1206 = fnma(p_arb_front_right_y, s8_1204, s8_1205);
  const double s8_1207 = fma(work.s8_69, work.s2_227, work.s8_114*work.s2_226);
  const double s8_1208 = fma(work.s8_94, work.s6_141, fma(work.s8_41, work.s2_228, s8_1207));
  const double s8_1209 = fma(work.s8_64, work.s6_144, work.s6_142 + s8_1208);
  const double s8_1210 = fnma(work.s2_177, work.zdd_star_carrier_right_ry, s8_1209);
  const double s8_1211 = fma(work.s2_174, work.zdd_star_carrier_right_rx, s8_1210);
  const double s8_1212 = 1.1666666666666667*s8_1211;
  const double s8_1213 = fnma(work.s8_77, work.s2_226, work.s8_42*work.s2_227);
  const double s8_1214 = fma(work.s8_57, work.s6_141, fma(work.s8_69, work.s2_228, s8_1213));
  const double s8_1215 = fma(work.s8_64, work.s6_137, work.s6_139 + s8_1214);
  const double s8_1216 = fma(work.s2_174, work.zdd_star_carrier_right_rz, s8_1215);
  const double s8_1217 = work.s2_174*work.Rz_carrier_right_rx_1;
  const double s8_1218 = fnma(work.s2_177, work.Rz_carrier_right_ry_1, s8_1217);
  const double s8_1219 = fnma(work.s2_181, work.zdd_star_carrier_right_ry, s8_1216);
  const double s8_1220 = 1.1666666666666667*s8_1219;
  const double s8_1221 = fnma(s8_1077, work.s8_731, fma(s8_1057, work.s8_725, s8_1060));
  const double s8_1222 = fnma(s8_1073, work.s8_731, fnma(s8_1057, work.s8_741, s8_1084));
  work.s8_1223 = fma(s8_1165, s8_1087, fma(s8_1185, s8_1218, s8_1221));
  work.s8_1224 = fnma(s8_1165, s8_1090, fnma(s8_1218, s8_1174, s8_1222));
  const double s8_1225 = fma(work.s2_228, s8_1220, fnma(work.s2_191, s8_1128, s8_1129));
  work.s8_1226 = fnma(work.s2_227, s8_1212, s8_1225);
  const double s8_1227 = fnma(work.s8_77, work.s2_227, work.s8_40*work.s2_226);
  const double s8_1228 = fma(work.s8_114, work.s2_228, s8_1227) - work.s6_135;
  const double s8_1229 = fma(work.s8_57, work.s6_144, fnma(work.s8_94, work.s6_137, s8_1228));
  work.s8_1230 = zd_upper_arm_right*(zd_upper_arm_right + work.s8_57);
  const double s8_1231 = fnma(work.s2_177, work.zdd_star_carrier_right_rz, s8_1229);
  const double s8_1232 = fma(work.s2_181, work.zdd_star_carrier_right_rx, s8_1231);
  const double s8_1233 = 1.1666666666666667*s8_1232;
  const double s8_1234 = fma(work.s8_540, s8_1220, fma(work.s8_537, s8_1128, s8_1134));
  const double s8_1235 = fnma(s8_1087, s8_1220, fnma(work.s8_741, work.s8_738, s8_1043));
  const double s8_1236 = fma(work.s2_226, s8_1220, fma(work.s2_189, s8_1128, s8_1130));
  work.s8_1237 = fnma(work.s2_227, s8_1233, s8_1236);
  const double s8_1238 = fnma(work.s2_228, s8_1233, fnma(work.s2_189, s8_1122, s8_1124));
  work.s8_1239 = fma(work.s2_226, s8_1212, s8_1238);
  const double s8_1240 = fnma(work.s8_542, s8_1212, fnma(s8_1155, s8_1233, s8_1234));
  const double s8_1241 = fnma(work.s8_540, s8_1087, fnma(work.s8_542, s8_1218, s8_1155*s8_1090));
  const double s8_1242 = fnma(0.3333333333333333, s8_1053, fma(work.s8_723, s8_877, s8_893));
  work.s8_1243 = fnma(1.1666666666666667, s8_1241, s8_1242);
  const double s8_1244 = fnma(0.3333333333333333, s8_1093, fma(work.s8_723, s8_874, s8_1092));
  const double s8_1245 = fma(s8_1090, s8_1090, fma(s8_1087, s8_1087, s8_1218*s8_1218));
  work.s8_1246 = fnma(1.1666666666666667, s8_1245, s8_1244);
  const double s8_1247 = fnma(p_pitman_arm_y, work.s8_42, s8_811);
  const double s8_1248 = fma(p_pitman_arm_y, work.s8_42, s8_811);
  const double s8_1249 = fma(work.s7_175, s8_1247, fma(0.539, work.s6_159, s8_987));
  const double s8_1250 = fma(work.s7_206, s8_1248, fnma(0.539, work.s6_179, s8_970));
  const double s8_1251 = fnma(work.s7_173, fnma(p_rear_axle_tx_z, work.s8_77, s8_808), s8_1249);
  const double s8_1252 = fnma(work.s8_77, work.s7_94 - s7_213, s8_1251);
  const double s8_1253 = fma(work.s7_204, fma(p_rear_axle_tx_z, work.s8_77, s8_808), s8_1250);
  const double s8_1254 = fma(work.s8_77, work.s7_153 - s7_207, s8_1253);
  const double s8_1255 = fma(work.s8_69, s7_215 - work.s7_169, s8_1240);
  const double s8_1256 = fma(s8_903, s8_1128, fnma(s8_1131, s8_1122, s8_1133));
  const double s8_1257 = fma(s8_1218, s8_1212, fnma(s8_1090, s8_1233, s8_1235));
  const double s8_1258 = fma(work.Rz_upper_arm_left_2, s8_1252, s8_1255);
  const double s8_1259 = fma(work.Rz_carrier_left_rz_2, s7_192 - work.n_carrier_left_x, s8_1258);
  const double s8_1260 = tau_carrier_left_rz*work.s1_32;
  const double s8_1261 = fnma(work.R_carrier_left_aux1_y_x, tau_carrier_left_rx, s8_1260);
  const double s8_1262 = work.n_carrier_left_y + fnma(tau_carrier_left_ry, work.s1_29, s8_1261);
  const double s8_1263 = fma(work.s3_21, s8_991, fma(work.Rz_upper_arm_left_0, s8_1252, s8_1256));
  const double s8_1264 = fma(p_arb_front_right_x, work.s8_41, -p_rear_axle_tx_z*work.s8_114);
  const double s8_1265 = fnma(work.s8_306, work.s7_99, fma(work.s8_77, s7_198, s8_1020));
  const double s8_1266 = fms(-p_arb_front_right_y, work.s8_69, s8_1264);
  const double s8_1267 = fnma(work.s8_306, work.s7_158, fma(work.s8_69, work.s7_183, s8_1063));
  const double s8_1268 = fnma(p_arb_front_right_y, work.s8_69, s8_1264);
  const double s8_1269 = fnma(p_rear_axle_tx_z, work.s8_40, p_arb_front_right_x*work.s8_114);
  const double s8_1270 = fnma(p_arb_front_right_y, work.s8_77, s8_1269);
  const double s8_1271 = fma(p_arb_front_right_y, work.s8_77, s8_1269);
  const double s8_1272 = fma(work.s7_200, s8_1270, fnma(work.s7_189, s8_1266, s8_1265));
  const double s8_1273 = fma(work.s7_218, s8_1271, fma(work.s7_181, s8_1268, s8_1267));
  const double s8_1274 = fnma(0.3477, work.zdd_star_arb_front_left, s8_1272);
  const double s8_1275 = fnma(work.s8_114, s7_220 - work.s7_100, s8_1274);
  const double s8_1276 = fnma(0.3477, work.zdd_star_arb_front_right, s8_1273);
  const double s8_1277 = fnma(work.s8_114, s7_219 - work.s7_159, s8_1276);
  const double s8_1278 = fma(work.s3_24, s8_1262, fma(work.s3_22, s8_991, s8_1259));
  const double s8_1279 = fma(work.s3_23, s8_1262, s8_1263);
  work.s8_1280 = fma(work.Rz_arb_front_left_0, s8_1275, s8_1279);
  const double s8_1281 = fma(work.Rz_arb_front_left_2, s8_1275, s8_1278);
  const double s8_1282 = fma(work.s3_29, s8_1254, s8_1281);
  const double s8_1283 = s7_223 - work.n_carrier_right_x;
  const double s8_1284 = work.R_carrier_right_aux1_z_x*tau_carrier_right_rx;
  const double s8_1285 = fma(tau_carrier_right_ry, work.s1_44, s8_1284);
  const double s8_1286 = fma(tau_carrier_right_rz, work.s1_46, s8_1285) - work.n_carrier_right_z;
  const double s8_1287 = fma(work.Rz_carrier_right_rz_2, s8_1283, s8_1282);
  const double s8_1288 = fma(work.s3_28, s8_1254, s8_1257);
  const double s8_1289 = work.R_carrier_right_aux1_y_x*tau_carrier_right_rx;
  const double s8_1290 = fma(tau_carrier_right_ry, work.s1_45, s8_1289);
  const double s8_1291 = fnma(tau_carrier_right_rz, work.s1_48, s8_1290) - work.n_carrier_right_y;
  const double s8_1292 = fma(work.Rz_carrier_right_ry_2, s8_1286, s8_1287);
  const double s8_1293 = fma(work.Rz_carrier_right_ry_1, s8_1286, s8_1288);
  const double s8_1294 = fma(work.Rz_carrier_right_rx_2, s8_1291, s8_1292);
  const double s8_1295 = fma(work.Rz_carrier_right_rx_1, s8_1291, s8_1293);
  work.s8_1296 = fma(work.Rz_arb_front_right_1, s8_1277, s8_1295);
  const double s8_1297 = fnma(p_pitman_arm_z, work.s8_40, p_pitman_arm_x*work.s8_114);
  const double s8_1298 = fnma(p_rear_axle_tx_z, work.s8_77, s8_1297);
  const double s8_1299 = fma(p_pitman_arm_z, work.s8_114, p_pitman_arm_y*work.s8_69);
  const double s8_1300 = fma(work.s7_187, s8_1298, fnma(0.3504, work.s6_195, s8_1010));
  const double s8_1301 = fnma(work.s7_186, fnma(p_pitman_arm_x, work.s8_41, s8_1299), s8_1300);
  const double s8_1302 = fma(work.Rz_arb_front_right_2, s8_1277, s8_1294);
  const double s8_1303 = fma(work.s8_114, s7_216 - work.s7_163, s8_1301);
  work.s8_1304 = fma(work.s3_36, s8_1303, s8_1302);
  work.s8_1305 = 3.75 + work.s7_173;
  const double s8_1306 = work.s7_204 + (work.s7_209 + (work.s7_173 + (5.25 + work.s7_194)));
  work.s8_1307 = work.s7_184 + s8_1306;
  const double s8_1308 = work.r_carrier_left_aux1_y + work.r_carrier_right_aux1_y;
  work.s8_1309 = fma(m_carrier_right_2, s8_1308, work.s8_1307 + work.s8_548);
}

/// Part 6 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63); step 9:
/// accelerations from the root to the leaves (63), (62).
[[gnu::noinline]] void compute_accelerations_6(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_1310 = fma(work.s7_204, work.s8_1230, work.s6_179*work.s7_206);
  const double s8_1311 = fnma(work.s6_179, work.s7_204, work.s7_206*work.s8_1230);
  const double s8_1312 = work.s7_204 - 3.75;
  const double s8_1313 = work.s7_209 - 5.0;
  const double s8_1314 = work.s7_209*work.s8_535;
  const double s8_1315 = 5.0 + work.s7_194;
  const double s8_1316 = 23.1 - work.s7_187;
  const double s8_1317 = s8_1315 + (work.s8_1305 + (s8_1312 + s8_1313));
  const double s8_1318 = fma(p_pitman_arm_y, s8_1316, work.s8_866);
  const double s8_1319 = 17.775 + work.s7_218;
  const double s8_1320 = 17.775 + work.s7_200;
  const double s8_1321 = fma(p_lower_arm_left_x, s8_1317, s8_1318);
  const double s8_1322 = s8_1319 + s8_1320;
  const double s8_1323 = work.s7_36 - 14.85;
  const double s8_1324 = work.s7_40 - 14.85;
  const double s8_1325 = fnma(p_arb_front_right_y, s8_1320 - s8_1319, s8_1321);
  const double s8_1326 = fnma(p_arb_rear_right_y, s8_1324 - s8_1323, s8_1325);
  const double s8_1327 = s8_1323 + s8_1324;
  const double s8_1328 = 2.1 + work.s7_186;
  const double s8_1329 = 2.1 + work.s7_206;
  const double s8_1330 = work.s7_175 - 2.1;
  const double s8_1331 = 7.75 + work.s7_211;
  const double s8_1332 = work.s7_196 - 7.75;
  const double s8_1333 = fnma(p_rear_axle_tx_z, s8_1330 + (s8_1329 - s8_1328), work.s8_764);
  const double s8_1334 = fma(p_lower_arm_left_y, s8_1331 + s8_1332, s8_1333);
  const double s8_1335 = fma(p_lower_arm_left_z, s8_1313 + s8_1315, s8_1334);
  const double s8_1336 = fma(0.8, s8_1315 - s8_1313, work.s8_1305 + (work.s8_1008 - s8_1312));
  const double s8_1337 = s8_1336 + work.s8_1189;
  const double s8_1338 = work.s7_181 - 2.25;
  const double s8_1339 = work.s7_189 - 2.25;
  const double s8_1340 = fma(p_upper_arm_right_z, s8_1312 + work.s8_1305, s8_1335);
  const double s8_1341 = 2.025 + work.s7_35;
  const double s8_1342 = 2.025 + work.s7_39;
  const double s8_1343 = fnma(p_arb_front_right_y, s8_1339 - s8_1338, s8_1340);
  const double s8_1344 = fnma(p_arb_rear_right_y, s8_1341 - s8_1342, s8_1343);
  const double s8_1345 = s8_1341 + s8_1342;
  const double s8_1346 = 1.0/work.pivot_bell_crank;
  result.inertia[8] = work.pivot_bell_crank - 1.5272999999999997e-20;
  const double s8_1347 = work.s8_1243*s8_1346;
  const double s8_1348 = fnma(work.s8_785, s8_1347, work.s8_1078);
  const double s8_1349 = fnma(work.s8_1164, s8_1347, work.s8_1079);
  const double s8_1350 = fnma(work.s8_1199, s8_1347, work.s8_1187);
  const double s8_1351 = fnma(work.s8_1206, s8_1347, work.s8_1223);
  const double s8_1352 = fma(p_lower_arm_left_x, work.s8_1069, s8_1351);
  const double s8_1353 = fnma(work.s8_1184, s8_1347, work.s8_1224);
  const double s8_1354 = fma(p_lower_arm_left_x, work.s8_1080, s8_1353);
  const double s8_1355 = fma(work.s8_77, work.s8_1005, fnma(work.s8_1304, s8_1347, work.s8_1296));
  const double s8_1356 = fnma(work.s8_1201, s8_1347, work.s8_1069);
  const double s8_1357 = work.s8_1137*s8_1347;
  const double pivot_lower_arm_right = fnma(work.s8_1243, s8_1347, work.s8_1246);
  const double s8_1358 = 1.0/pivot_lower_arm_right;
  const double s8_1359 = pivot_lower_arm_right - 1.5272999999999997e-20;
  result.inertia[7] = fnma(1e-12, work.s8_1246, s8_1359);
  const double s8_1360 = s8_1357*s8_1358;
  const double s8_1361 = work.s8_1137*s8_1346;
  const double s8_1362 = fms(s8_1360, s8_1356, work.s7_196) - work.s8_827 - work.s8_819;
  const double s8_1363 = fnma(work.s8_1201, s8_1361, s8_1362);
  const double s8_1364 = fma(s8_1360, s8_1348, fnma(work.s8_785, s8_1361, work.s8_843));
  const double s8_1365 = fma(s8_1360, s8_1349, fnma(work.s8_1164, s8_1361, work.s8_845));
  const double s8_1366 = fma(s8_1360, s8_1350, fnma(work.s8_1199, s8_1361, work.s8_1152));
  const double s8_1367 = fma(s8_1360, s8_1352, fnma(work.s8_1206, s8_1361, work.s8_1149));
  const double s8_1368 = work.s8_819 + (work.s7_196 + work.s8_827);
  const double s8_1369 = fnma(p_lower_arm_left_x, s8_1368, s8_1367);
  const double s8_1370 = fma(s8_1360, s8_1354, fnma(work.s8_1184, s8_1361, work.s8_1153));
  const double s8_1371 = fnma(p_lower_arm_left_x, work.s8_847, s8_1370);
  const double pivot_lower_arm_left = fnma(s8_1357, s8_1360, fnma(work.s8_1137, s8_1361,
      work.s8_1140));
  const double s8_1372 = fma(s8_1360, s8_1355, fnma(work.s8_1304, s8_1361, work.s8_1280));
  const double s8_1373 = fma(work.s8_77, work.s8_1002, s8_1372);
  const double s8_1374 = fma(0.9, s8_1345, fma(0.8, s8_1328, work.s8_1028) - s8_1338 - s8_1339);
  const double s8_1375 = fma(1.24, s8_1331 - s8_1332, fma(0.56, s8_1329 - s8_1330, s8_1374));
  const double s8_1376 = s8_1375 + work.s8_1177;
  const double s8_1377 = 33.3125 - work.s7_185;

  // --- step 8: elimination from the leaves to the root (63), continued ---
  const double s8_1378 = fnma(p_pitman_arm_x, s8_1328, fma(p_bell_crank_z, s8_1377, work.s8_549));
  const double s8_1379 = s8_1332 + (s8_1330 - s8_1329 - s8_1331);
  const double s8_1380 = fnma(6.6, s8_1327, fma(8.8, s8_1316, fma(6.5, s8_1377, work.s8_551)));
  const double s8_1381 = fma(7.9, s8_1322, s8_1380);
  const double s8_1382 = fma(p_lower_arm_left_x, s8_1379, fma(p_pitman_arm_z, s8_1316, s8_1378));
  const double s8_1383 = fnma(p_carrier_left_rz_y, s8_1327, s8_1382);
  const double s8_1384 = fma(7.2, work.s8_928, s8_1381 + work.s8_1169);
  const double s8_1385 = fma(p_rear_axle_tx_z, s8_1322, s8_1383);
  const double s8_1386 = fma(p_arb_front_left_x, s8_1338 + s8_1339, s8_1385);
  const double s8_1387 = fnma(p_arb_rear_left_x, s8_1345, s8_1386);
  const double R_chassis_aux4_y_x = work.sines[0];
  const double s1_6 = work.sines[2];
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux4_x_x = work.cosines[0];
  const double R_chassis_x_z = fma(R_chassis_aux4_x_x, work.s1_56, R_chassis_aux4_y_x*s1_6);
  const double R_chassis_y_z = fnma(R_chassis_aux4_x_x, s1_6, R_chassis_aux4_y_x*work.s1_56);
  const double s8_1388 = work.s7_35*work.s8_357;
  const double s8_1389 = work.s7_36*work.s8_357;
  const double s8_1390 = work.s7_175 + (work.s7_196 + (3289.7 - work.s7_39 - work.s7_35));
  const double s8_1391 = work.s7_181 + (work.s7_189 + s8_1390 - work.s7_211 - work.s7_206);
  const double s8_1392 = s8_1391 - work.s7_186;
  const double s8_1393 = fma(m_carrier_right_2, work.s8_1029, s8_1392 + work.s8_544);
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  const double s8_1394 = fma(R_chassis_y_z, tau_chassis_ty, R_chassis_x_z*tau_chassis_tx);
  const double s8_1395 = fma(work.R_chassis_z_z, tau_chassis_tz, s8_1394) - s8_1388;
  const double s8_1396 = work.s8_857*work.s8_524;
  const double s8_1397 = fnma(work.s7_39, work.s8_358, s8_1395) - work.f_rear_axle_z;
  const double s8_1398 = work.s8_495*work.s8_520;
  const double s8_1399 = fnma(work.s8_519, s8_1398, fnma(s8_1396, work.s8_531, s8_1397));
  const double s8_1400 = work.s8_1013 + (s8_1399 - work.s8_937 - work.s8_946) - s8_1311;
  const double s8_1401 = fma(work.s7_211, work.s8_535, s8_1311 + work.f_carrier_right_z);
  const double s8_1402 = fnma(work.s7_211, work.s8_535, s8_1400 - work.f_carrier_right_z);
  const double s8_1403 = fma(work.s7_211, work.s8_535, work.s8_944);
  const double s8_1404 = work.f_carrier_left_z + (s8_1401 - work.s8_607);
  const double s8_1405 = work.s8_607 + (work.s8_1022 + s8_1402) - work.f_carrier_left_z;
  const double s1_7 = work.cosines[2];
  const double R_chassis_x_y = fnma(R_chassis_aux4_y_x, s1_7, R_chassis_aux4_x_x*work.s1_59);
  const double R_chassis_y_y = fma(R_chassis_aux4_x_x, s1_7, R_chassis_aux4_y_x*work.s1_59);
  const double s8_1406 = fma(R_chassis_y_y, tau_chassis_ty, R_chassis_x_y*tau_chassis_tx);
  const double s8_1407 = work.s8_392 + work.s8_396;
  const double s8_1408 = fma(work.R_chassis_z_y, tau_chassis_tz, s8_1406) - work.s8_392;
  const double s8_1409 = work.s8_265*work.s8_520;
  const double s8_1410 = work.s8_522*work.s8_857;
  const double s8_1411 = fnma(work.s8_519, s8_1409, s8_1408 - work.s8_396 - work.f_rear_axle_y);
  const double s8_1412 = work.s8_944 + (work.s8_938 + fnma(s8_1410, work.s8_531, s8_1411));
  const double s8_1413 = s8_1314 + (s8_1310 + (s8_1412 - work.s8_1015) - work.f_carrier_right_y);
  const double s8_1414 = s8_1314 + (s8_1310 - work.f_carrier_right_y) - work.s8_606;
  const double s8_1415 = s8_1413 - work.s8_1024 - work.s8_606 - work.f_carrier_left_y;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux5_z_z = work.cosines[1];
  const double R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  const double R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  const double s8_1416 = R_chassis_aux5_x_x*tau_chassis_tx;
  const double s1_55 = work.sines[1];
  const double s8_1417 = fma(R_chassis_aux5_y_x, tau_chassis_ty, s8_1416);
  const double s8_1418 = s8_1389 + fnma(s1_55, tau_chassis_tz, s8_1417);
  const double s8_1419 = work.s7_218 + (work.s7_200 + (work.s7_36 + (356.525 + work.s7_40)));
  const double s8_1420 = s8_1419 - work.s7_187 - work.s7_185;
  const double s8_1421 = s8_1420 + work.s8_546;
  const double s8_1422 = 1.0/pivot_lower_arm_left;
  result.inertia[6] = fnma(1e-12, work.s8_1140, pivot_lower_arm_left - 1.5272999999999997e-20);
  const double s8_1423 = s8_1422*s8_1369;
  const double s8_1424 = fnma(work.s8_479, work.s8_955, fnma(work.s8_525, work.s8_954, s8_1337));
  const double s8_1425 = s8_1358*s8_1352;
  const double s8_1426 = fma(work.s8_114, s8_1344, fnma(work.s8_792, s8_1326, work.s8_1226));
  const double s8_1427 = work.s8_1206*s8_1346;
  const double s8_1428 = fnma(s8_1352, s8_1425, fnma(s8_1369, s8_1423, s8_1424));
  // chassis: chassis_rx, revolute, chassis_aux5
  const double pivot_chassis_rx = s8_1384 + fnma(work.s8_1206, s8_1427, s8_1428);
  result.inertia[5] = pivot_chassis_rx;
  const double s8_1429 = fnma(work.s8_1304, s8_1427, fnma(s8_1355, s8_1425, s8_1426));
  const double s8_1430 = 1.0/pivot_chassis_rx;
  const double s8_1431 = fma(work.s7_194, work.s8_534, s8_1414 - work.f_carrier_left_y);
  const double s8_1432 = fnma(work.s8_77, s8_1387, fnma(s8_1423, s8_1373, s8_1429));
  const double s8_1433 = s8_1422*s8_1366;
  const double s8_1434 = fnma(work.s8_466, work.s8_918, fnma(work.s8_526, work.s8_917, s8_1337));
  const double s8_1435 = s8_1358*s8_1350;
  const double s8_1436 = fnma(work.s8_802, s8_1344, fnma(work.s8_114, s8_1326, work.s8_1237));
  const double s8_1437 = work.s8_1199*s8_1346;
  const double s8_1438 = fma(s8_1352, s8_1435, fma(s8_1433, s8_1369, work.s8_1171));
  const double s8_1439 = fma(s8_1354, s8_1435, fma(s8_1433, s8_1371, s8_1326 + work.s8_1173));
  const double s8_1440 = fnma(s8_1350, s8_1435, fnma(s8_1366, s8_1433, s8_1434));
  const double s8_1441 = s8_1376 + fnma(work.s8_1199, s8_1437, s8_1440);
  const double s8_1442 = fnma(work.s8_1304, s8_1437, fnma(s8_1355, s8_1435, s8_1436));
  const double s8_1443 = s8_1387 + fma(work.s8_1206, s8_1437, s8_1438);
  const double s8_1444 = fma(p_lower_arm_left_x, work.s8_914, s8_1443);
  const double s8_1445 = fma(work.s8_69, s8_1387, fnma(s8_1433, s8_1373, s8_1442));
  const double s8_1446 = s8_1422*s8_1371;
  const double s8_1447 = fnma(work.s8_480, work.s8_860, fnma(work.s8_527, work.s8_859, s8_1384));
  const double s8_1448 = s8_1358*s8_1354;
  const double s8_1449 = fnma(work.s8_69, s8_1344, fma(work.s8_77, s8_1326, work.s8_1239));
  const double s8_1450 = work.s8_1184*s8_1346;
  const double s8_1451 = fma(s8_1352, s8_1448, fma(s8_1369, s8_1446, s8_1344 + work.s8_1191));
  const double s8_1452 = fma(work.s8_1206, s8_1450, s8_1451);
  const double s8_1453 = fnma(s8_1354, s8_1448, fnma(s8_1371, s8_1446, s8_1447));
  const double s8_1454 = s8_1376 + fnma(work.s8_1184, s8_1450, s8_1453);
  const double s8_1455 = fnma(work.s8_1304, s8_1450, fnma(s8_1355, s8_1448, s8_1449));
  const double s8_1456 = s8_1430*s8_1452;
  const double s8_1457 = fma(s8_1456, s8_1444, fma(work.s8_1184, s8_1437, s8_1439));
  const double s8_1458 = fma(p_lower_arm_left_x, work.s8_864, s8_1457);
  const double s8_1459 = work.s8_985 + (work.s8_945 - work.s8_953);
  const double s8_1460 = fma(p_lower_arm_left_x, s8_1431, s8_1432);
  const double s8_1461 = fnma(p_rear_axle_tx_z, s8_1459, s8_1460);
  const double s8_1462 = fma(p_lower_arm_left_y, work.s8_996 - work.s8_974, s8_1461);
  const double s8_1463 = fnma(p_arb_front_left_x, work.s8_1015 + work.s8_1024, s8_1462);
  const double s8_1464 = fnma(p_arb_front_right_y, work.s8_1021 - work.s8_1012, s8_1463);
  const double s8_1465 = fnma(p_arb_rear_left_x, s8_1407, s8_1464);
  const double s8_1466 = fnma(work.s7_40, work.s8_358, s8_1389);
  const double s8_1467 = fnma(p_arb_rear_right_y, s8_1466, s8_1465);
  const double s8_1468 = fma(work.s8_69, s8_1336 - s8_1381, s8_1467);
  const double s8_1469 = fnma(work.s8_306, s8_1387, fnma(s8_1446, s8_1373, s8_1455));
  const double s8_1470 = fnma(work.s7_196, work.s8_534, s8_1404);
  const double s8_1471 = fma(p_lower_arm_left_x, s8_1470, fma(s8_1456, s8_1468, s8_1469));
  const double s8_1472 = fma(work.s7_40, work.s8_358, s8_1389);
  const double s8_1473 = fnma(p_carrier_left_rz_y, s8_1472, s8_1471);
  const double s8_1474 = fnma(p_lower_arm_left_z, work.s8_974 + work.s8_996, s8_1473);
  const double s8_1475 = fnma(p_rear_axle_tx_z, work.s8_1012 + work.s8_1021, s8_1474);
  const double s8_1476 = fnma(p_arb_front_left_x, work.s8_1013 + work.s8_1022, s8_1475);
  const double s8_1477 = fnma(p_upper_arm_right_z, work.s8_953 + work.s8_985, s8_1476);
  const double s8_1478 = fma(p_arb_rear_left_x, fma(work.s7_39, work.s8_358, s8_1388), s8_1477);
  const double s8_1479 = fma(work.s8_114, s8_1381 - s8_1375, s8_1478);
  const double s8_1480 = s8_1430*s8_1444;
  const double pivot_chassis_ry = fnma(s8_1452, s8_1456, s8_1454);
  const double s8_1481 = 1.0/pivot_chassis_ry;
  result.inertia[4] = mbgen::min(fnma(1e-12, s8_1454, pivot_chassis_ry), work.s9_6);
  const double s8_1482 = s8_1481*s8_1458;
  const double s8_1483 = fma(s8_1480, s8_1468, fnma(p_carrier_left_rz_y, s8_1407, s8_1445));
  const double s8_1484 = work.s8_607 + (s8_1311 - work.s8_946 - work.s8_1015 - work.s8_1024);
  const double s8_1485 = fnma(p_rear_axle_tx_z, s8_1484, fma(s8_1482, s8_1479, s8_1483));
  const double s8_1486 = fma(p_lower_arm_left_y, fma(work.s7_196, work.s8_534, s8_1403), s8_1485);
  const double s8_1487 = fma(work.s7_194, work.s8_534, s8_1314);
  const double s8_1488 = fnma(p_lower_arm_left_z, s8_1487, s8_1486);
  const double s8_1489 = fnma(p_upper_arm_right_z, s8_1310 - work.s8_606, s8_1488);
  const double s8_1490 = fnma(p_arb_front_right_y, work.s8_1022 - work.s8_1013, s8_1489);
  const double s8_1491 = fnma(work.s7_39, work.s8_358, s8_1388);
  const double s8_1492 = fnma(p_arb_rear_right_y, s8_1491, s8_1490);
  const double s8_1493 = fma(work.s8_77, s8_1375 - s8_1336, s8_1492);
  const double s8_1494 = s8_1358*s8_1349;
  const double s8_1495 = fma(work.s7_196, work.s8_534, fnma(work.s8_77, work.s8_1307, s8_1405));
  const double s8_1496 = work.s8_1164*s8_1346;
  const double s8_1497 = s8_1422*s8_1365;
  const double s8_1498 = fnma(work.s8_1304, s8_1496, fnma(s8_1355, s8_1494, s8_1495));
  const double s8_1499 = fma(work.s8_40, s8_1392, fnma(s8_1497, s8_1373, s8_1498));
  const double s8_1500 = s8_1358*s8_1356;
  const double s8_1501 = fma(work.s7_194, work.s8_534, fma(work.s8_42, work.s8_1307, s8_1415));
  const double s8_1502 = work.s8_1201*s8_1346;
  const double s8_1503 = s8_1422*s8_1363;
  const double s8_1504 = fnma(work.s8_1304, s8_1502, fnma(s8_1355, s8_1500, s8_1501));
  const double s8_1505 = fnma(work.s8_77, s8_1392, fnma(s8_1503, s8_1373, s8_1504));
  const double s8_1506 = work.s8_857*work.s8_523;
  const double s8_1507 = fma(work.s7_40, work.s8_358, s8_1418) - work.f_rear_axle_x;
  const double s8_1508 = work.s8_494*work.s8_520;
  const double s8_1509 = fnma(work.s8_519, s8_1508, fnma(s8_1506, work.s8_531, s8_1507));
  const double s8_1510 = s8_1509 - work.s8_939 - work.s8_945 - work.s8_1012 - work.s8_953;
  const double s8_1511 = s8_1510 - work.f_carrier_right_x - work.s8_974 - work.s8_1021;
  const double s8_1512 = s8_1511 - work.s8_985 - work.f_carrier_left_x;
  const double s8_1513 = s8_1358*s8_1348;
  const double s8_1514 = fnma(work.s8_69, work.s8_1307, s8_1512) - work.s8_996;
  const double s8_1515 = work.s8_785*s8_1346;
  const double s8_1516 = s8_1364*s8_1422;
  const double s8_1517 = fnma(work.s8_1304, s8_1515, fnma(s8_1355, s8_1513, s8_1514));
  const double s8_1518 = fnma(work.s8_114, s8_1392, fnma(s8_1516, s8_1373, s8_1517));
  const double s8_1519 = fma(s8_1497, s8_1369, fma(work.s8_479, s8_1398, s8_1396*work.s8_525));
  const double s8_1520 = fma(work.s8_1206, s8_1496, fma(s8_1352, s8_1494, s8_1519));
  const double s8_1521 = fma(s8_1516, s8_1369, fma(work.s8_479, s8_1508, s8_1506*work.s8_525));
  const double s8_1522 = fma(work.s8_1206, s8_1515, fma(s8_1352, s8_1513, s8_1521));
  const double s8_1523 = work.s8_1309 + s8_1522;
  const double s8_1524 = fnma(work.s8_466, s8_1398, fnma(s8_1396, work.s8_526, work.s8_1309));
  const double s8_1525 = fnma(s8_1350, s8_1494, fnma(s8_1497, s8_1366, s8_1524));
  const double s8_1526 = fma(s8_1497, s8_1371, fma(work.s8_480, s8_1398, s8_1396*work.s8_527));
  const double s8_1527 = fnma(work.s8_495, s8_1398, fnma(work.s8_524, s8_1396, 15306.0));
  const double s8_1528 = fma(work.s8_1184, s8_1496, fma(s8_1354, s8_1494, s8_1526));
  const double s8_1529 = fnma(s8_1349, s8_1494, fnma(s8_1365, s8_1497, s8_1527));
  const double s8_1530 = fnma(work.s8_1164, s8_1496, s8_1529);
  const double s8_1531 = s8_1421 + fma(s8_1520, s8_1456, s8_1528);
  const double s8_1532 = fnma(s8_1520, s8_1480, fnma(work.s8_1199, s8_1496, s8_1525));
  const double s8_1533 = fnma(s8_1482, s8_1531, s8_1532);
  const double s8_1534 = fnma(work.s8_479, s8_1409, fnma(s8_1410, work.s8_525, s8_1421));
  const double s8_1535 = fnma(s8_1352, s8_1500, fnma(s8_1503, s8_1369, s8_1534));
  const double s8_1536 = fnma(work.s8_1206, s8_1502, s8_1535);
  const double s8_1537 = fnma(work.s8_480, s8_1508, fnma(s8_1506, work.s8_527, s8_1393));
  const double s8_1538 = fnma(s8_1354, s8_1513, fnma(s8_1516, s8_1371, s8_1537));
  const double s8_1539 = fnma(s8_1523, s8_1456, fnma(work.s8_1184, s8_1515, s8_1538));
  const double s8_1540 = fnma(work.s8_480, s8_1409, fnma(s8_1410, work.s8_527, s8_1456*s8_1536));
  const double s8_1541 = fnma(s8_1354, s8_1500, fnma(s8_1503, s8_1371, s8_1540));
  const double s8_1542 = fnma(work.s8_1184, s8_1502, s8_1541);
  const double s8_1543 = fnma(work.s8_466, s8_1508, fnma(s8_1506, work.s8_526, s8_1539*s8_1482));
  const double s8_1544 = fnma(s8_1350, s8_1513, fnma(s8_1516, s8_1366, s8_1543));
  const double s8_1545 = fnma(s8_1523, s8_1480, fnma(work.s8_1199, s8_1515, s8_1544));
  const double pivot_chassis_rz = fnma(s8_1444, s8_1480, fnma(s8_1458, s8_1482, s8_1441));
  result.inertia[3] = fnma(1e-12, s8_1441, pivot_chassis_rz);
  const double s8_1546 = 1.0/pivot_chassis_rz;
  const double s8_1547 = fnma(work.s8_466, s8_1409, fnma(s8_1410, work.s8_526, s8_1480*s8_1536));
  const double s8_1548 = fnma(s8_1350, s8_1500, fnma(s8_1503, s8_1366, s8_1547));
  const double s8_1549 = fma(s8_1482, s8_1542, fnma(work.s8_1199, s8_1502, s8_1548) - s8_1393);
  const double s8_1550 = s8_1481*s8_1531;
  const double s8_1551 = fnma(work.s8_495, s8_1508, fnma(s8_1506, work.s8_524, s8_1539*s8_1550));
  const double s8_1552 = fnma(s8_1349, s8_1513, fnma(s8_1516, s8_1365, s8_1551));
  const double s8_1553 = s8_1430*s8_1536;
  const double s8_1554 = fnma(work.s8_265, s8_1508, fnma(work.s8_522, s8_1506, s8_1523*s8_1553));
  const double s8_1555 = fnma(work.s8_494, s8_1508, fnma(work.s8_523, s8_1506, 15306.0));
  const double s8_1556 = fnma(s8_1356, s8_1513, fnma(s8_1516, s8_1363, s8_1554));
  const double s8_1557 = fnma(s8_1348, s8_1513, fnma(s8_1364, s8_1516, s8_1555));
  const double s8_1558 = fnma(work.s8_785, s8_1515, s8_1557);
  const double s8_1559 = s8_1520*s8_1430;
  const double s8_1560 = fma(s8_1559, s8_1468, fnma(work.s8_114, s8_1420, s8_1499));
  const double s8_1561 = fnma(work.s8_495, s8_1409, fnma(s8_1410, work.s8_524, s8_1559*s8_1536));
  const double s8_1562 = fnma(work.s8_265, s8_1409, fnma(work.s8_522, s8_1410, 15306.0));
  const double s8_1563 = fnma(s8_1349, s8_1500, fnma(s8_1365, s8_1503, s8_1561));
  const double s8_1564 = fnma(s8_1356, s8_1500, fnma(s8_1363, s8_1503, s8_1562));
  const double s8_1565 = fnma(work.s8_1201, s8_1502, s8_1564);
  const double s8_1566 = s8_1546*s8_1533;
  const double s8_1567 = fnma(s8_1523, s8_1559, fnma(work.s8_1164, s8_1515, s8_1552));
  const double s8_1568 = fnma(s8_1545, s8_1566, s8_1567);
  const double s8_1569 = fnma(s8_1520, s8_1559, fnma(s8_1531, s8_1550, s8_1530));
  const double pivot_chassis_tz = fnma(s8_1533, s8_1566, s8_1569);
  const double s8_1570 = fma(s8_1550, s8_1542, fnma(work.s8_1164, s8_1502, s8_1563));
  const double s8_1571 = fnma(s8_1566, s8_1549, s8_1570);
  const double s8_1572 = fnma(s8_1566, s8_1493, fma(s8_1550, s8_1479, s8_1560));
  result.inertia[2] = fnma(1e-12, s8_1530, pivot_chassis_tz);
  const double s8_1573 = 1.0/pivot_chassis_tz;
  const double s8_1574 = s8_1481*s8_1542;
  const double s8_1575 = fnma(s8_1553, s8_1468, fnma(work.s8_69, s8_1420, s8_1505));
  const double s8_1576 = s8_1546*s8_1549;
  const double s8_1577 = fnma(s8_1539, s8_1574, fnma(work.s8_1201, s8_1515, s8_1556));
  const double s8_1578 = fnma(s8_1542, s8_1574, fnma(s8_1536, s8_1553, s8_1565));
  const double s8_1579 = s8_1573*s8_1571;
  const double s8_1580 = fnma(s8_1568, s8_1579, fnma(s8_1545, s8_1576, s8_1577));
  const double pivot_chassis_ty = fnma(s8_1571, s8_1579, fnma(s8_1549, s8_1576, s8_1578));
  const double s8_1581 = fnma(s8_1576, s8_1493, fnma(s8_1574, s8_1479, s8_1575));
  const double s8_1582 = fnma(s8_1579, s8_1572, s8_1581);
  result.inertia[1] = fnma(1e-12, s8_1565, pivot_chassis_ty);
  const double s8_1583 = 1.0/pivot_chassis_ty;
  const double s8_1584 = s8_1523*s8_1430;
  const double s8_1585 = s8_1539*s8_1481;
  const double s8_1586 = fma(s8_1584, s8_1468, fma(work.s8_41, s8_1420, s8_1518));
  const double s8_1587 = s8_1545*s8_1546;
  const double s8_1588 = fnma(s8_1539, s8_1585, fnma(s8_1523, s8_1584, s8_1558));
  const double s8_1589 = s8_1568*s8_1573;
  const double s8_1590 = fnma(s8_1587, s8_1493, fnma(s8_1585, s8_1479, s8_1586));
  const double s8_1591 = s8_1580*s8_1583;
  const double s8_1592 = fnma(s8_1568, s8_1589, fnma(s8_1545, s8_1587, s8_1588));
  const double pivot_chassis_tx = fnma(s8_1580, s8_1591, s8_1592);
  result.inertia[0] = fnma(1e-12, s8_1558, pivot_chassis_tx);

  // --- step 9: accelerations from the root to the leaves (63), (62), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1593 = fnma(s8_1591, s8_1582, fnma(s8_1589, s8_1572, s8_1590));
  const double a_chassis_x = s8_1593*(1.0/pivot_chassis_tx);
  const double a_chassis_y = s8_1583*fnma(s8_1580, a_chassis_x, s8_1582);
  const double s9_7 = fnma(g_z, s1_55, a_chassis_x);
  const double s9_8 = fnma(work.s8_785, a_chassis_x, work.s8_1304);
  const double s9_9 = fnma(work.s8_523, a_chassis_x, work.s8_531);
  const double s9_10 = fnma(work.s8_494, a_chassis_x, work.s8_519);
  const double a_chassis_z = s8_1573*fnma(s8_1571, a_chassis_y, fnma(s8_1568, a_chassis_x,
      s8_1572));
  const double s9_11 = fma(g_z, work.R_chassis_z_y, a_chassis_y);
  const double s9_12 = fnma(s8_1549, a_chassis_y, fnma(s8_1545, a_chassis_x, s8_1493));
  const double s9_13 = fnma(s8_1542, a_chassis_y, fnma(s8_1539, a_chassis_x, s8_1479));
  const double s9_14 = fnma(s8_1536, a_chassis_y, fma(s8_1523, a_chassis_x, s8_1468));
  const double s9_15 = fnma(s8_1363, a_chassis_y, fnma(s8_1364, a_chassis_x, s8_1373));
  const double s9_16 = fnma(s8_1356, a_chassis_y, fnma(s8_1348, a_chassis_x, s8_1355));
  const double alpha_chassis_x = s8_1546*fnma(s8_1533, a_chassis_z, s9_12);
  const double s9_17 = fma(g_z, work.R_chassis_z_z, a_chassis_z);
  const double s9_18 = fnma(work.s8_1164, a_chassis_z, fnma(work.s8_1201, a_chassis_y, s9_8));
  const double s9_19 = fnma(work.s8_524, a_chassis_z, fnma(work.s8_522, a_chassis_y, s9_9));
  const double s9_20 = fnma(work.s8_495, a_chassis_z, fnma(work.s8_265, a_chassis_y, s9_10));
  const double s9_21 = fma(R_chassis_y_y, s9_11, R_chassis_aux5_y_x*s9_7);
  result.zdd[Coordinate::chassis_ty] = fma(R_chassis_y_z, s9_17, s9_21);
  const double s9_22 = fma(R_chassis_x_y, s9_11, R_chassis_aux5_x_x*s9_7);
  result.zdd[Coordinate::chassis_tx] = fma(R_chassis_x_z, s9_17, s9_22);
  const double s9_23 = fnma(s1_55, s9_7, work.R_chassis_z_y*s9_11);
  result.zdd[Coordinate::chassis_tz] = fma(work.R_chassis_z_z, s9_17, s9_23);
  const double alpha_chassis_y = s8_1481*fma(s8_1458, alpha_chassis_x, fma(s8_1531, a_chassis_z,
      s9_13));
  const double s9_24 = fma(s8_1444, alpha_chassis_x, fma(s8_1520, a_chassis_z, s9_14));
  const double s9_25 = alpha_chassis_y + work.s9_3;
  const double s9_26 = fnma(s8_1366, alpha_chassis_x, fnma(s8_1365, a_chassis_z, s9_15));
  const double s9_27 = fnma(s8_1350, alpha_chassis_x, fnma(s8_1349, a_chassis_z, s9_16));
  const double s9_28 = fnma(work.s8_1199, alpha_chassis_x, s9_18);
  const double s9_29 = fnma(work.s8_526, alpha_chassis_x, s9_19);
  const double s9_30 = fnma(work.s8_466, alpha_chassis_x, s9_20);
  const double alpha_chassis_z = s8_1430*fma(s8_1452, alpha_chassis_y, s9_24);
  const double s9_31 = alpha_chassis_z + work.s9_2;
  const double s9_32 = fnma(work.s8_1184, alpha_chassis_y, s9_28);
  const double s9_33 = fnma(work.s8_527, alpha_chassis_y, s9_29);
  const double s9_34 = fnma(work.s8_480, alpha_chassis_y, s9_30);
  result.zdd[Coordinate::chassis_rz] = fma(work.s1_54, s9_31, work.s1_58*s9_25);
  const double s9_35 = fnma(s8_1369, alpha_chassis_z, fnma(s8_1371, alpha_chassis_y, s9_26));
  const double s9_36 = s8_1422*s9_35;
  result.zdd[Coordinate::lower_arm_left] = s9_36;
  const double s9_37 = work.s8_857*fnma(work.s8_525, alpha_chassis_z, s9_33);
  result.zdd[Coordinate::arb_rear_left] = s9_37;
  result.zdd[Coordinate::chassis_ry] = fnma(s1_6, s9_31, s1_7*s9_25);
  const double s9_38 = fma(work.s1_57, s9_31, work.s1_60*s9_25);
  result.zdd[Coordinate::chassis_rx] = fma(work.s1_61, alpha_chassis_x + work.s9_1, s9_38);
  const double s9_39 = fnma(s8_1352, alpha_chassis_z, fnma(s8_1354, alpha_chassis_y, s9_27));
  const double s9_40 = s8_1358*fma(s8_1357, s9_36, s9_39);
  result.zdd[Coordinate::lower_arm_right] = s9_40;
  const double s9_41 = fnma(work.s8_505, s9_37, fnma(work.s8_479, alpha_chassis_z, s9_34));
  const double s9_42 = work.s8_520*s9_41;
  result.zdd[Coordinate::arb_rear_right] = s9_42;
  const double s9_43 = fnma(work.s8_1137, s9_36, fnma(work.s8_1206, alpha_chassis_z, s9_32));
  const double s9_44 = fma(work.Rz_rear_axle_ry_0, s9_37, work.zdd_star_rear_axle_ry);
  const double s9_45 = fma(work.Rz_rear_axle_ry_1, s9_42, s9_44);
  const double s9_46 = fma(work.Rz_rear_axle_rx_0, s9_37, work.zdd_star_rear_axle_rx);
  const double s9_47 = fma(work.Rz_rear_axle_rx_1, s9_42, s9_46);
  const double s9_48 = fma(work.Rz_rear_axle_tx_0, s9_37, work.zdd_star_rear_axle_tx);
  result.zdd[Coordinate::rear_axle_tx] = fma(work.Rz_rear_axle_tx_1, s9_42, s9_48);
  const double s9_49 = fnma(work.s3_1, s9_37, work.zdd_star_rear_axle_tz);
  result.zdd[Coordinate::rear_axle_tz] = fma(work.Rz_rear_axle_tz_1, s9_42, s9_49);
  const double s9_50 = fma(work.Rz_rear_axle_rz_0, s9_37, work.zdd_star_rear_axle_rz);
  const double s9_51 = fnma(work.s3_2, s9_42, s9_50);
  const double s9_52 = s8_1346*fnma(work.s8_1243, s9_40, s9_43);
  result.zdd[Coordinate::bell_crank] = s9_52;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double alpha_rear_axle_y = s9_45 + (work.s8_44 + alpha_chassis_y);
  const double alpha_rear_axle_z = s9_47 + (work.s8_43 + alpha_chassis_z);
  const double alpha_rear_axle_x = s9_51 + (work.s8_45 + alpha_chassis_x);
  result.zdd[Coordinate::rear_axle_ty] = -fma(work.s3_12, s9_42, fma(work.s3_9, s9_37, work.s6_88));
  const double s9_53 = fma(work.Rz_arb_front_left_0, s9_36, work.zdd_star_arb_front_left);
  result.zdd[Coordinate::arb_front_left] = fma(work.Rz_arb_front_left_2, s9_52, s9_53);
  const double s9_54 = fms(work.Rz_upper_arm_left_0, s9_36, work.s6_159);
  result.zdd[Coordinate::upper_arm_left] = fma(work.Rz_upper_arm_left_2, s9_52, s9_54);
  const double s9_55 = fma(work.Rz_carrier_right_ry_1, s9_40, work.zdd_star_carrier_right_ry);
  const double s9_56 = fma(work.Rz_carrier_right_ry_2, s9_52, s9_55);
  const double s9_57 = fma(work.Rz_carrier_right_rx_1, s9_40, work.zdd_star_carrier_right_rx);
  const double s9_58 = fma(work.Rz_carrier_right_rx_2, s9_52, s9_57);
  const double s9_59 = fma(work.Rz_arb_front_right_1, s9_40, work.zdd_star_arb_front_right);
  result.zdd[Coordinate::arb_front_right] = fma(work.Rz_arb_front_right_2, s9_52, s9_59);
  const double s9_60 = fnma(work.s3_21, s9_36, work.zdd_star_carrier_left_ry);
  const double s9_61 = fnma(work.s3_22, s9_52, s9_60);
  const double s9_62 = fnma(work.s3_23, s9_36, work.zdd_star_carrier_left_rx);
  const double s9_63 = fnma(work.s3_24, s9_52, s9_62);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s9_64 = fma(work.s8_665, s9_36, work.s8_621 + alpha_chassis_x);
  const double alpha_carrier_left_x = fma(work.Rz_carrier_left_rz_2, s9_52, s9_64);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s9_65 = fma(work.s8_723, s9_40, work.s8_561 + alpha_chassis_x);
  const double alpha_carrier_right_x = fma(work.Rz_carrier_right_rz_2, s9_52, s9_65);
  const double alpha_carrier_right_z = s9_56 + (work.s8_562 + alpha_chassis_z);
  const double alpha_carrier_right_y = s9_58 + (work.s8_563 + alpha_chassis_y);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double alpha_carrier_left_z = s9_61 + (work.s8_608 + alpha_chassis_z);
  const double alpha_carrier_left_y = s9_63 + (work.s8_609 + alpha_chassis_y);
  result.zdd[Coordinate::pitman_arm] = -fma(work.s3_36, s9_52, work.s6_195);
  result.zdd[Coordinate::upper_arm_right] = -fma(work.s3_29, s9_52, fma(work.s3_28, s9_40,
      work.s6_179));
  const double s9_66 = work.R_rear_axle_x_y*alpha_rear_axle_x;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s9_67 = fma(work.R_rear_axle_y_y, alpha_rear_axle_y, s9_66);
  const double s9_68 = fma(work.R_rear_axle_z_y, alpha_rear_axle_z, s9_67);
  const double s9_69 = s9_51 + fma(zd_rear_axle_rz, work.s4_8, work.s4_6*work.s4_3);
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s9_70 = fnma(work.s4_32, work.s4_41, fnma(work.s4_38, work.s4_30, s9_56));
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s9_71 = fnma(work.s4_17, work.s4_26, fnma(work.s4_23, work.s4_15, s9_61));
  const double s9_72 = fma(work.s4_1, work.s4_3, s9_45);
  const double s9_73 = fma(zd_rear_axle_rz, work.s4_1 - work.s4_2, s9_72);
  result.zdd[Coordinate::rear_axle_rx] = fma(work.s1_66, s9_69, work.s1_65*s9_73);
  result.zdd[Coordinate::rear_axle_ry] = fnma(work.sines[17], s9_69, work.cosines[17]*s9_73);
  const double s9_74 = s9_47 + fma(work.s4_1, work.s4_7, work.s4_6*work.s4_2);
  result.zdd[Coordinate::rear_axle_rz] = fma(work.s1_67, s9_74, fma(work.s1_64, s9_69,
      work.s1_63*s9_73));
  const double s9_75 = s9_58 + fnma(work.s4_29, work.s4_30, work.s4_33*work.s4_36);
  const double s9_76 = fma(work.s4_34, zd_lower_arm_right + work.s4_32, s9_75);
  const double s9_77 = s9_63 + fnma(work.s4_14, work.s4_15, work.s4_18*work.s4_21);
  const double s9_78 = fma(work.s4_19, zd_lower_arm_left + work.s4_17, s9_77);
  const double s9_79 = fma(work.s4_38, work.s4_31, work.s4_29*work.s4_39);
  const double s9_80 = fnma(work.s4_40, work.s4_36, s9_70);
  const double s9_81 = fma(zd_lower_arm_right, work.s4_38 - work.s4_39, s9_80);
  const double s9_82 = fma(work.s4_23, work.s4_16, work.s4_14*work.s4_24);
  const double s9_83 = fnma(work.s4_25, work.s4_21, s9_71);
  const double s9_84 = fma(zd_lower_arm_left, work.s4_23 - work.s4_24, s9_83);
  const double s9_85 = fnma(work.s4_33, work.s4_41, fma(work.s4_40, work.s4_34, s9_79));
  const double s9_86 = fnma(work.s4_18, work.s4_26, fma(work.s4_25, work.s4_19, s9_82));
  const double s9_87 = fnma(work.s3_30, s9_40, work.zdd_star_carrier_right_rz + s9_85);
  const double s9_88 = fma(work.Rz_carrier_right_rz_2, s9_52, s9_87);
  const double s9_89 = fnma(work.s3_20, s9_36, work.zdd_star_carrier_left_rz + s9_86);
  const double s9_90 = fma(work.Rz_carrier_left_rz_2, s9_52, s9_89);
  result.zdd[Coordinate::carrier_right_ry] = fma(work.s1_44, s9_81, fnma(work.s1_47, s9_88,
      work.s1_45*s9_76));
  result.zdd[Coordinate::carrier_left_ry] = fma(work.s1_28, s9_84, fnma(work.s1_31, s9_90,
      work.s1_29*s9_78));
  result.zdd[Coordinate::carrier_right_rz] = fma(work.s1_46, s9_81, fnma(work.s1_48, s9_76,
      work.s1_51*s9_88));
  result.zdd[Coordinate::carrier_left_rz] = fma(work.s1_30, s9_84, fnma(work.s1_32, s9_78,
      work.s1_35*s9_90));
  const double s9_91 = fma(work.R_carrier_right_aux1_y_x, s9_76, work.cosines[10]*s9_88);
  result.zdd[Coordinate::carrier_right_rx] = fma(work.R_carrier_right_aux1_z_x, s9_81, s9_91);
  const double s9_92 = fma(work.R_carrier_left_aux1_y_x, s9_78, work.cosines[4]*s9_90);
  result.zdd[Coordinate::carrier_left_rx] = fma(work.R_carrier_left_aux1_z_x, s9_84, s9_92);
  const double s9_93 = 0.09090909090909091*tau[Coordinate::wheel_front_left];
  const double s9_94 = fma(work.s1_21, alpha_carrier_left_x, s9_93);
  const double s9_95 = fnma(work.R_carrier_left_aux2_y_y, alpha_carrier_left_y, s9_94);
  result.zdd[Coordinate::wheel_front_left] = fnma(work.R_carrier_left_aux2_z_y,
      alpha_carrier_left_z, s9_95);
  const double s9_96 = 0.09090909090909091*tau[Coordinate::wheel_front_right];
  const double s9_97 = fma(work.s1_37, alpha_carrier_right_x, s9_96);
  const double s9_98 = fnma(work.R_carrier_right_aux2_y_y, alpha_carrier_right_y, s9_97);
  result.zdd[Coordinate::wheel_front_right] = fnma(work.R_carrier_right_aux2_z_y,
      alpha_carrier_right_z, s9_98);
  result.zdd[Coordinate::wheel_rear_left] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_left], s9_68);
  result.zdd[Coordinate::wheel_rear_right] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_right], s9_68);
  // operations of step 1: poses and axes b: 50 add, 134 multiply, 4 divide, 44 sin cos
  // operations of step 4: velocities: 27 add, 30 multiply
  // operations of step 7: inertias of the bodies and forces on joints: 6 add, 9 multiply
  // operations of step 8: elimination from the leaves to the root (63): 681 add, 558 multiply, 6
  // divide
  // operations of step 2: closure Jacobian Phi_z and its factors (60), long_rod_left ..
  // arb_link_rear_right: 134 add, 154 multiply, 6 divide, 11 other
  // operations of step 3: Rz (61), long_rod_left .. arb_link_rear_right: 21 add, 42 multiply
  // operations of step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right: 122 add, 152
  // multiply
  // operations of step 7: inertias of the bodies and forces on joints, long_rod_left ..
  // arb_link_rear_right: 25 add, 51 multiply
  // operations of step 8: elimination from the leaves to the root (63), long_rod_left ..
  // arb_link_rear_right: 611 add, 642 multiply, 2 divide
  // operations of step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left ..
  // tie_rod_right: 114 add, 145 multiply, 11 divide, 21 other
  // operations of step 3: Rz (61), upper_ball_left .. tie_rod_right: 22 add, 49 multiply
  // operations of step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right: 125 add, 173
  // multiply
  // operations of step 7: inertias of the bodies and forces on joints, upper_ball_left ..
  // tie_rod_right: 116 add, 184 multiply
  // operations of step 8: elimination from the leaves to the root (63), upper_ball_left ..
  // tie_rod_right: 846 add, 905 multiply, 3 divide
  // operations of step 9: accelerations from the root to the leaves (63), (62): 181 add, 189
  // multiply, 7 other
}

/// All accelerations with the frozen partition of the loop blocks.
void compute_accelerations(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, const double* tau, Accelerations& __restrict result) noexcept {
  AccelerationsWork work;
  compute_accelerations_1(state, tau, work, result);
  compute_accelerations_2(state, tau, work);
  compute_accelerations_3(state, tau, work, result);
  compute_accelerations_4(state, tau, work, result);
  compute_accelerations_5(state, tau, work, result);
  compute_accelerations_6(state, tau, work, result);
}

/// Result of compute_closure.
struct Closure {
  double residual[17];  ///< of every closure equation, block after block, then of every motion
  double dz[32];  ///< Newton correction; driven coordinates go to their motions
  double zd[32];  ///< consistent velocities
  double pivot[2];  ///< smallest pivot of each block over its reference
};

/// Values of compute_closure that cross its parts.
struct ClosureWork {
  double
      sines[19], cosines[19], R_carrier_left_aux2_y_y, R_carrier_left_aux1_y_x,
      R_carrier_right_aux2_y_y, R_carrier_right_aux1_y_x, s1_13, s2_13, R_carrier_left_aux2_z_y,
      R_carrier_left_aux1_z_x, s2_16, s1_15, s2_23, s2_24, s2_25, s1_16, s2_28,
      R_carrier_right_aux2_z_y, R_carrier_right_aux1_z_x, s2_31, s1_20, s2_38, s2_39, s2_40, s2_43,
      s1_23, s2_56, s2_59, r_carrier_left_aux1_y, s2_69, s4_2, s2_77, s2_79, s2_99, s2_112, s2_115,
      s2_145, s2_147, s2_151, s2_153, s2_154, s2_156, s2_157, s2_159, s2_161, s2_164, s2_165,
      s2_167, s2_170, s4_7, s2_173, s2_175, s2_177, s4_10, s4_12, s4_13, s4_14, s4_15, s4_17;
};

/// Part 1 of compute_closure: step 1: poses and axes b; step 2: closure Jacobian Phi_z and its
/// factors (60); step 4: velocities; step 1: poses and axes b; step 2: closure Jacobian Phi_z and
/// its factors (60); step 4: velocities.
[[gnu::noinline]] void compute_closure_1(const State& state, ClosureWork& __restrict work,
    Closure& __restrict result) noexcept {
  // Results that need no operation.
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
  mbgen::sincos(angles, work.sines, work.cosines);

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  const double s2_1 = -p_drag_link_from_z*work.sines[12];
  const double R_bell_crank_y_x = work.sines[13];
  const double s2_2 = p_drag_link_to_y*R_bell_crank_y_x;
  const double s2_3 = s2_2 + (1.15 - s2_1);
  const double s2_4 = -p_drag_link_from_z*work.cosines[12];
  const double s2_5 = 0.2 - s2_4;
  const double s2_6 = 0.8565801464479954*s2_5;
  const double s2_7 = 0.8565801464479954*s2_3;
  const double pivot_pitman_arm = fnma(s2_4, s2_7, s2_1*s2_6);
  const double R_bell_crank_x_x = work.cosines[13];
  const double s2_8 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s2_9 = p_pitman_arm_y - s2_8;
  const double s2_10 = 0.8565801464479954*s2_9;

  // --- step 4: velocities ---
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s2_11 = 0.5*fma(s2_9, s2_10, fma(s2_3, s2_7, fms(s2_5, s2_6, l_drag_link)));
  result.residual[8] = s2_11;

  // --- step 1: poses and axes b, continued ---
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[0];
  const double R_carrier_left_aux1_x_x = work.cosines[1];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = work.sines[0];
  const double s1_1 = work.cosines[2];
  const double s1_2 = work.sines[2];
  const double s1_3 = fma(R_carrier_left_aux1_y_y, s1_2, R_lower_arm_left_z_y*s1_1);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  work.R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_2, R_carrier_left_aux1_y_y*s1_1);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_4 = work.sines[1];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_4;
  const double s1_5 = work.cosines[3];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_6 = work.sines[3];
  const double R_carrier_left_y_x = fma(s1_3, s1_6, work.R_carrier_left_aux1_y_x*s1_5);
  const double R_carrier_left_y_z = fnma(s1_3, s1_5, work.R_carrier_left_aux1_y_x*s1_6);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[6];
  const double R_carrier_right_aux1_x_x = work.cosines[7];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[6];
  const double s1_7 = work.cosines[8];
  const double s1_8 = work.sines[8];
  const double s1_9 = fma(R_carrier_right_aux1_y_y, s1_8, R_lower_arm_right_z_y*s1_7);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  work.R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_8, R_carrier_right_aux1_y_y*s1_7);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_10 = work.sines[7];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_10;
  const double s1_11 = work.cosines[9];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_12 = work.sines[9];
  const double R_carrier_right_y_x = fma(s1_9, s1_12, work.R_carrier_right_aux1_y_x*s1_11);
  const double R_carrier_right_y_z = fnma(s1_9, s1_11, work.R_carrier_right_aux1_y_x*s1_12);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux2_x_z = s1_4*s1_2;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_6,
      R_carrier_left_aux1_x_x*s1_5);
  const double R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_6,
      R_carrier_left_aux2_x_z*s1_5);
  work.s1_13 = s1_4*s1_1;
  const double s2_12 = p_arb_link_front_left_to_x*R_carrier_left_x_x;
  work.s2_13 = fnma(p_arb_link_front_left_to_y, work.s1_13 + R_carrier_left_x_z, s2_12);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_2,
      R_lower_arm_left_y_y*s1_1);
  work.R_carrier_left_aux2_z_y = fma(R_lower_arm_left_y_y, s1_2, R_carrier_left_aux1_z_y*s1_1);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_4;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_6,
      work.R_carrier_left_aux1_z_x*s1_5);
  const double R_carrier_left_z_z = fma(work.R_carrier_left_aux1_z_x, s1_6,
      R_carrier_left_aux2_z_z*s1_5);
  const double s2_14 = R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s2_15 = p_arb_link_front_left_to_x*R_carrier_left_z_x;
  work.s2_16 = fnma(p_arb_link_front_left_to_y, s2_14, s2_15);
  const double s1_14 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_15 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_14);
  const double R_arb_front_left_x_x = work.cosines[5];
  const double R_arb_front_left_x_z = work.sines[5];
  const double s2_17 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  const double s2_18 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s2_17);
  const double s2_19 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s2_20 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s2_19);
  const double s2_21 = 0.35 + s2_20 - work.s2_13;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double r_carrier_left_aux1_z = work.s1_15 + p_lower_arm_left_z;
  const double s2_22 = s2_18 + p_arb_front_left_z - r_carrier_left_aux1_z - work.s2_16;
  work.s2_23 = 3.846153846153846*s2_21;
  work.s2_24 = 3.846153846153846*s2_22;
  const double pivot_arb_front_left = fnma(s2_20, work.s2_24, s2_18*work.s2_23);
  work.s2_25 = fma(s2_22, work.s2_24, fms(s2_21, work.s2_23, l_arb_link_front_left));
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux2_x_z = s1_10*s1_8;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_12,
      R_carrier_right_aux1_x_x*s1_11);
  const double R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_12,
      R_carrier_right_aux2_x_z*s1_11);
  work.s1_16 = s1_10*s1_7;
  const double s2_26 = p_arb_link_front_right_to_x*R_carrier_right_x_x;
  const double s2_27 = R_carrier_right_x_z - work.s1_16;
  work.s2_28 = fnma(p_arb_link_front_left_to_y, s2_27, s2_26);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_8,
      R_lower_arm_right_y_y*s1_7);
  work.R_carrier_right_aux2_z_y = fma(R_lower_arm_right_y_y, s1_8, R_carrier_right_aux1_z_y*s1_7);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_10;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_17 = work.R_carrier_right_aux1_z_x*s1_11;
  const double R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_12, s1_17);
  const double s1_18 = R_carrier_right_aux2_z_z*s1_11;
  const double R_carrier_right_z_z = fma(work.R_carrier_right_aux1_z_x, s1_12, s1_18);
  const double s2_29 = work.R_carrier_right_aux2_z_y + R_carrier_right_z_z;
  const double s2_30 = p_arb_link_front_right_to_x*R_carrier_right_z_x;
  work.s2_31 = fnma(p_arb_link_front_left_to_y, s2_29, s2_30);
  const double s1_19 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  work.s1_20 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_19);
  const double R_arb_front_right_x_x = work.cosines[11];
  const double R_arb_front_right_x_z = work.sines[11];
  const double s2_32 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  const double s2_33 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s2_32);
  const double s2_34 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s2_35 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s2_34);
  const double s2_36 = 0.35 + s2_35 - work.s2_28;
  const double s1_21 = work.s1_20 - p_lower_arm_right_z;

  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  const double s2_37 = s2_33 + (s1_21 + p_arb_front_right_z) - work.s2_31;
  work.s2_38 = 3.846153846153846*s2_36;
  work.s2_39 = 3.846153846153846*s2_37;
  const double pivot_arb_front_right = fnma(s2_35, work.s2_39, s2_33*work.s2_38);
  work.s2_40 = fma(s2_37, work.s2_39, fms(s2_36, work.s2_38, l_arb_link_front_right));
  const double s2_41 = p_tie_rod_left_to_z*R_carrier_left_x_z;
  const double s2_42 = -p_carrier_left_upper_ball_y*work.s1_13;
  work.s2_43 = fma(p_carrier_left_upper_ball_z, R_carrier_left_x_z, s2_42);
  result.residual[0] = work.s2_43;
  const double s2_44 = s2_42 + fma(p_tie_rod_left_to_x, R_carrier_left_x_x, s2_41);
  const double s2_45 = p_tie_rod_left_to_z*R_carrier_left_z_z;
  const double s2_46 = -p_carrier_left_upper_ball_y*work.R_carrier_left_aux2_z_y;
  const double s2_47 = fms(p_carrier_left_upper_ball_z, R_carrier_left_z_z, s2_46);
  const double s2_48 = fma(p_tie_rod_left_to_x, R_carrier_left_z_x, s2_45) - s2_46;
  const double s1_22 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  work.s1_23 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_22);
  const double s2_49 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_50 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_49);
  const double s2_51 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s2_49);
  const double s2_52 = s2_50 + (0.35 + s2_44);
  const double s2_53 = p_tie_rod_left_to_z*R_carrier_left_y_z;
  const double s2_54 = -p_carrier_left_upper_ball_y*work.R_carrier_left_aux2_y_y;
  const double s2_55 = fma(p_tie_rod_left_to_x, R_carrier_left_y_x, s2_53) - s2_54;
  work.s2_56 = fms(p_carrier_left_upper_ball_z, R_carrier_left_y_z, s2_54);
  const double s2_57 = R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s2_58 = p_arb_link_front_left_to_x*R_carrier_left_y_x;
  work.s2_59 = fnma(p_arb_link_front_left_to_y, s2_57, s2_58);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_23;
  const double s2_60 = p_tie_rod_left_from_y*R_bell_crank_x_x;
  const double s2_61 = fma(p_tie_rod_left_from_x, R_bell_crank_y_x, s2_60);
  const double s2_62 = fnma(p_tie_rod_left_from_x, R_bell_crank_y_x, s2_60);
  const double s2_63 = s2_61 - work.r_carrier_left_aux1_y - s2_55;
  const double s2_64 = 1.262590031797617*s2_63;
  const double s2_65 = 1.262590031797617*s2_52;
  // tie_rod_left
  const double s2_66 = s2_48 + (r_carrier_left_aux1_z - p_bell_crank_z);
  const double s2_67 = 1.262590031797617*s2_66;
  const double s2_68 = fma(s2_63, s2_64, fma(s2_52, s2_65, fms(s2_66, s2_67, l_tie_rod_left)));
  work.s2_69 = 0.5*s2_68;
  result.residual[9] = work.s2_69;
  const double s2_70 = fnma(s2_48, s2_65, s2_44*s2_67);
  const double s2_71 = fma(s2_44, s2_64, s2_65*s2_55);
  const double s2_72 = fma(s2_48, s2_64, s2_67*s2_55);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s2_73 = s2_72 + fma(work.s1_15, s2_64, work.s1_23*s2_67);
  const double s4_1 = zd_bell_crank*fnma(s2_65, s2_61, s2_50*s2_64);
  work.s4_2 = fnma(zd_lower_arm_left, s2_73, s4_1);
  const double s2_74 = work.R_carrier_left_aux1_y_x*s2_70;
  const double s2_75 = fma(work.R_carrier_left_aux1_z_x, s2_71, s2_74);
  const double s2_76 = fnma(R_carrier_left_aux1_x_x, s2_72, s2_75);
  work.s2_77 = fnma(R_lower_arm_left_z_y, s2_70, R_lower_arm_left_y_y*s2_71);
  const double s2_78 = work.R_carrier_left_aux2_y_y*s2_70;
  work.s2_79 = fma(work.s1_13, s2_72, fma(work.R_carrier_left_aux2_z_y, s2_71, s2_78));
  const double s2_80 = p_tie_rod_right_to_z*R_carrier_right_z_z;
  const double s2_81 = p_carrier_right_upper_ball_y*work.R_carrier_right_aux2_z_y;
  const double s2_82 = fma(p_carrier_right_upper_ball_z, R_carrier_right_z_z, s2_81);
  const double s2_83 = s2_81 + fma(p_tie_rod_right_to_x, R_carrier_right_z_x, s2_80);
  const double s2_84 = p_tie_rod_right_to_z*R_carrier_right_x_z;
  const double s2_85 = p_carrier_right_upper_ball_y*work.s1_16;
  const double s2_86 = fms(p_carrier_right_upper_ball_z, R_carrier_right_x_z, s2_85);
  result.residual[3] = s2_86;
  const double s2_87 = fma(p_tie_rod_right_to_x, R_carrier_right_x_x, s2_84) - s2_85;
  const double s1_24 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  const double s1_25 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_24);
  const double s2_88 = s2_51 - 0.35 - s2_87;
  const double s2_89 = s2_83 + (-p_bell_crank_z - s1_21);
  const double s2_90 = 1.262590031797617*s2_88;
  const double s2_91 = 1.262590031797617*s2_89;
  const double s2_92 = fma(s2_87, s2_91, s2_83*s2_90);
  const double s2_93 = p_tie_rod_right_to_z*R_carrier_right_y_z;
  const double s2_94 = p_carrier_right_upper_ball_y*work.R_carrier_right_aux2_y_y;
  const double s2_95 = s2_94 + fma(p_tie_rod_right_to_x, R_carrier_right_y_x, s2_93);
  const double s2_96 = fma(p_carrier_right_upper_ball_z, R_carrier_right_y_z, s2_94);
  const double s2_97 = work.R_carrier_right_aux2_y_y + R_carrier_right_y_z;
  const double s2_98 = p_arb_link_front_right_to_x*R_carrier_right_y_x;
  work.s2_99 = fnma(p_arb_link_front_left_to_y, s2_97, s2_98);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double r_carrier_right_aux1_y = s1_25 + p_lower_arm_right_y;
  // tie_rod_right
  const double s2_100 = s2_62 + (r_carrier_right_aux1_y + s2_95);
  const double s2_101 = 1.262590031797617*s2_100;
  const double s2_102 = fma(s2_87, s2_101, s2_90*s2_95);
  const double s2_103 = fma(s2_89, s2_91, fms(s2_88, s2_90, l_tie_rod_right));
  const double s2_104 = fnma(s2_91, s2_95, s2_83*s2_101);
  const double s2_105 = 0.5*fma(s2_100, s2_101, s2_103);
  result.residual[10] = s2_105;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s4_3 = zd_lower_arm_right*fnma(work.s1_20, s2_101, fnma(s1_25, s2_91, s2_104));
  const double s4_4 = fnma(zd_bell_crank, fnma(s2_51, s2_101, s2_90*s2_62), s4_3);
  const double pivot_carrier_right_rz = fma(R_lower_arm_right_y_y, s2_102,
      R_lower_arm_right_z_y*s2_92);
  const double s2_106 = work.R_carrier_right_aux1_y_x*s2_92;
  const double s2_107 = fnma(work.R_carrier_right_aux1_z_x, s2_102, s2_106);
  const double s2_108 = fma(R_carrier_right_aux1_x_x, s2_104, s2_107);
  const double s2_109 = work.R_carrier_right_aux2_y_y*s2_92;
  const double s2_110 = fnma(work.R_carrier_right_aux2_z_y, s2_102, s2_109);
  const double s2_111 = fnma(work.s1_16, s2_104, s2_110);
  work.s2_112 = 1.0/pivot_arb_front_right;
  const double s2_113 = 1.0/pivot_pitman_arm;
  const double s2_114 = 4.291271972095581*std::abs(pivot_arb_front_right);
  result.dz[Coordinate::pitman_arm] = -(s2_11*s2_113);
  result.zd[Coordinate::pitman_arm] = -(s2_113*(zd_bell_crank*fma(s2_2, s2_10, s2_7*s2_8)));
  work.s2_115 = 1.0/pivot_arb_front_left;
  const double s2_116 = mbgen::min(s2_114, 4.625980413576839*std::abs(pivot_pitman_arm));
  const double R_upper_arm_right_z_y = work.sines[10];
  const double R_upper_arm_right_y_y = work.cosines[10];
  const double s2_117 = -p_upper_arm_right_ball_z*R_upper_arm_right_z_y;
  const double s2_118 = fma(p_upper_arm_right_ball_y, R_upper_arm_right_y_y, s2_117);
  const double s2_119 = mbgen::min(4.336650753223258*std::abs(pivot_arb_front_left), s2_116);
  const double s2_120 = 1.0/pivot_carrier_right_rz;
  const double s2_121 = mbgen::min(3.3503257942070226*std::abs(s2_118), s2_119);
  const double s2_122 = fma(R_lower_arm_right_y_y, s2_96, R_lower_arm_right_z_y*s2_82)*s2_120;
  const double s2_123 = work.R_carrier_right_aux2_y_y*s2_82;
  const double pivot_carrier_right_ry = fnma(s2_111, s2_122, fnma(work.R_carrier_right_aux2_z_y,
      s2_96, s2_123));
  const double s2_124 = 1.0/pivot_carrier_right_ry;
  const double s2_125 = mbgen::min(5.556930741705859*std::abs(pivot_carrier_right_rz), s2_121);
  const double s2_126 = -p_upper_arm_right_ball_z*R_upper_arm_right_y_y;
  const double s2_127 = fnma(p_upper_arm_right_ball_y, R_upper_arm_right_z_y, s2_126);
  const double s2_128 = s2_127 + (s2_82 + (-p_upper_arm_right_z - s1_21));
  result.residual[5] = s2_128;
  const double s2_129 = R_carrier_right_aux1_x_x*s2_96;
  const double s2_130 = fnma(work.R_carrier_right_aux1_y_x, s2_86, s2_129);
  const double s2_131 = fma(work.s1_16, s2_96, work.R_carrier_right_aux2_y_y*s2_86);
  const double s2_132 = R_lower_arm_right_z_y*s2_86;
  const double s2_133 = 1.0/s2_118;
  const double s2_134 = s2_127*s2_133;
  const double s2_135 = s2_120*fnma(s2_132, s2_134, R_lower_arm_right_y_y*s2_86);
  const double s2_136 = work.R_carrier_right_aux1_y_x*s2_82;
  const double s2_137 = fnma(s2_108, s2_122, fnma(work.R_carrier_right_aux1_z_x, s2_96, s2_136));
  const double s2_138 = fma(work.s1_16, s2_82, work.R_carrier_right_aux2_z_y*s2_86);
  const double s2_139 = s2_124*fma(s2_111, s2_135, fma(s2_131, s2_134, s2_138));
  const double s2_140 = work.R_carrier_right_aux1_z_x*s2_86;
  const double s4_5 = fma(s2_105, s2_122, s2_86);
  const double s4_6 = s2_122*s4_4;
  const double s2_141 = fnma(s2_130, s2_134, fnma(R_carrier_right_aux1_x_x, s2_82, s2_140));
  const double pivot_carrier_right_rx = fnma(s2_137, s2_139, fma(s2_108, s2_135, s2_141));
  const double s2_142 = 1.0/pivot_carrier_right_rx;
  const double s2_143 = mbgen::min(2.6620449619787987*std::abs(pivot_carrier_right_ry), s2_125);
  const double R_upper_arm_left_y_y = work.cosines[4];
  const double R_upper_arm_left_z_y = work.sines[4];
  const double s2_144 = p_upper_arm_left_ball_y*R_upper_arm_left_y_y;
  work.s2_145 = fnma(p_upper_arm_left_ball_z, R_upper_arm_left_z_y, s2_144);
  const double s2_146 = mbgen::min(s2_143, 2.732781487945307*std::abs(pivot_carrier_right_rx));
  work.s2_147 = 1.0/s2_76;
  const double s2_148 = mbgen::min(3.3514772255331233*std::abs(work.s2_145), s2_146);
  const double s2_149 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_150 = fma(p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s2_149);
  work.s2_151 = s2_47 + (r_carrier_left_aux1_z - p_upper_arm_left_z - s2_150);
  result.residual[2] = work.s2_151;
  const double s2_152 = R_carrier_left_aux1_x_x*work.s2_56;
  work.s2_153 = fnma(work.R_carrier_left_aux1_y_x, work.s2_43, s2_152);
  work.s2_154 = fma(work.s1_13, work.s2_56, work.R_carrier_left_aux2_y_y*work.s2_43);
  const double s2_155 = work.R_carrier_left_aux1_z_x*work.s2_43;
  work.s2_156 = 1.0/work.s2_145;
  work.s2_157 = s2_150*work.s2_156;
  const double s2_158 = fnma(R_carrier_left_aux1_x_x, s2_47, s2_155);
  work.s2_159 = work.s2_147*fma(work.s2_153, work.s2_157, s2_158);
  const double s2_160 = fma(work.s1_13, s2_47, work.R_carrier_left_aux2_z_y*work.s2_43);
  const double pivot_carrier_left_ry = fnma(work.s2_79, work.s2_159, fnma(work.s2_154, work.s2_157,
      s2_160));
  work.s2_161 = 1.0/pivot_carrier_left_ry;
  const double s2_162 = mbgen::min(15.714736645766752*std::abs(s2_76), s2_148);
  const double s2_163 = work.R_carrier_left_aux1_y_x*s2_47;
  work.s2_164 = fnma(work.R_carrier_left_aux1_z_x, work.s2_56, s2_163)*work.s2_147;
  work.s2_165 = R_lower_arm_left_z_y*work.s2_43;
  const double s2_166 = fma(work.s2_165, work.s2_157, R_lower_arm_left_y_y*work.s2_43);
  work.s2_167 = fnma(work.s2_77, work.s2_159, s2_166);
  const double s2_168 = work.R_carrier_left_aux2_y_y*s2_47;
  const double s2_169 = fnma(work.R_carrier_left_aux2_z_y, work.s2_56, s2_168);
  work.s2_170 = fnma(work.s2_79, work.s2_164, s2_169)*work.s2_161;
  work.s4_7 = zd_lower_arm_left*(work.s1_15 + s2_47);
  const double s2_171 = fma(R_lower_arm_left_y_y, work.s2_56, R_lower_arm_left_z_y*s2_47);
  const double s2_172 = fma(work.s2_167, work.s2_170, fma(work.s2_77, work.s2_164, s2_171));
  work.s2_173 = 1.0/s2_172;
  const double s2_174 = mbgen::min(5.864463449986124*std::abs(pivot_carrier_left_ry), s2_162);
  result.pivot[0] = mbgen::min(0.43888841273380513*std::abs(s2_172), s2_174);
  work.s2_175 = work.s2_99 + (0.72 + r_carrier_right_aux1_y);
  const double s2_176 = s2_96 + (r_carrier_right_aux1_y - p_upper_arm_right_y - s2_118);
  result.residual[4] = s2_176;
  work.s2_177 = s1_25*work.s2_39;

  // --- step 4: velocities, continued ---
  // loop block 0
  const double s4_8 = zd_lower_arm_right*(s1_25 + s2_96);
  const double s4_9 = fma(s2_139, s4_5, fma(s2_105, s2_135, fms(s2_128, s2_134, s2_176)));
  work.s4_10 = s2_142*s4_9;
  result.dz[Coordinate::carrier_right_rx] = work.s4_10;
  const double s4_11 = fnma(zd_lower_arm_right, work.s1_20 - s2_82, s2_134*s4_8);
  work.s4_12 = s2_124*fma(s2_137, work.s4_10, s4_5);
  work.s4_13 = s2_142*fnma(s2_139, s4_6, fnma(s2_135, s4_4, s4_11));
  result.zd[Coordinate::carrier_right_rx] = work.s4_13;
  work.s4_14 = s2_120*fnma(s2_111, work.s4_12, fms(s2_108, work.s4_10, s2_105));
  result.dz[Coordinate::carrier_right_rz] = work.s4_14;
  work.s4_15 = s2_124*fnma(s2_137, work.s4_13, s4_6);
  result.zd[Coordinate::carrier_right_ry] = work.s4_15;
  const double s4_16 = fma(s2_131, work.s4_12, fma(s2_130, work.s4_10, s2_128));
  result.dz[Coordinate::upper_arm_right] = s2_133*fma(s2_132, work.s4_14, s4_16);
  work.s4_17 = s2_120*fma(s2_111, work.s4_15, fma(s2_108, work.s4_13, s4_4));
  result.zd[Coordinate::carrier_right_rz] = work.s4_17;
  const double s4_18 = fnma(s2_130, work.s4_13, fms(s2_131, work.s4_15, s4_8));
  result.zd[Coordinate::upper_arm_right] = -(s2_133*fnma(s2_132, work.s4_17, s4_18));
}

/// Part 2 of compute_closure: step 2: closure Jacobian Phi_z and its factors (60); step 4:
/// velocities; step 2: closure Jacobian Phi_z and its factors (60); step 4: velocities; step 2:
/// closure Jacobian Phi_z and its factors (60); step 4: velocities.
[[gnu::noinline]] void compute_closure_2(const State& state, ClosureWork& __restrict work,
    Closure& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  // arb_link_front_right
  const double s2_178 = 3.846153846153846*work.s2_175;
  const double s2_179 = 0.5*fma(work.s2_175, s2_178, work.s2_40);
  result.residual[7] = s2_179;
  const double s2_180 = fma(work.s2_28, s2_178, work.s2_38*work.s2_99);
  const double s2_181 = fma(work.s2_31, s2_178, work.s2_39*work.s2_99);
  const double s2_182 = fnma(work.s2_28, work.s2_39, work.s2_38*work.s2_31);
  const double s2_183 = s2_181 + fnma(work.s1_20, s2_178, work.s2_177);
  const double s2_184 = work.R_carrier_right_aux2_y_y*s2_182;
  const double s2_185 = fnma(work.R_carrier_right_aux2_z_y, s2_180, s2_184);
  const double s2_186 = fnma(work.s1_16, s2_181, s2_185);
  const double s2_187 = fnma(work.R_carrier_right_aux1_z_x, s2_180, work.cosines[7]*s2_181);
  const double s2_188 = fma(work.R_carrier_right_aux1_y_x, s2_182, s2_187);
  const double s2_189 = fma(work.sines[6], s2_182, work.cosines[6]*s2_180);
  const double s4_19 = fma(s2_188, work.s4_13, state.zd[Coordinate::lower_arm_right]*s2_183);
  result.dz[Coordinate::carrier_right_ry] = -work.s4_12;
  const double s4_20 = fnma(s2_186, work.s4_12, fms(s2_188, work.s4_10, s2_179));
  result.dz[Coordinate::arb_front_right] = work.s2_112*fnma(s2_189, work.s4_14, s4_20);
  result.zd[Coordinate::arb_front_right] = work.s2_112*fnma(s2_189, work.s4_17, fma(s2_186,
      work.s4_15, s4_19));
  const double s2_190 = work.r_carrier_left_aux1_y - p_upper_arm_left_y - work.s2_145;
  const double s2_191 = work.s2_56 + s2_190;
  result.residual[1] = s2_191;
  const double s2_192 = 0.72 - work.r_carrier_left_aux1_y - work.s2_59;

  // --- step 4: velocities, continued ---
  // loop block 0
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s4_21 = zd_lower_arm_left*(work.s1_23 + work.s2_56);
  const double s4_22 = fma(work.s2_69, work.s2_159, fma(work.s2_151, work.s2_157, s2_191));
  const double s4_23 = fma(work.s2_159, work.s4_2, fnma(work.s2_157, s4_21, work.s4_7));
  const double s4_24 = fnma(work.s2_69, work.s2_164, fms(work.s2_170, s4_22, work.s2_43));
  const double s4_25 = work.s2_173*s4_24;
  const double s4_26 = work.s2_161*fms(work.s2_167, s4_25, s4_22);
  result.dz[Coordinate::carrier_left_ry] = s4_26;
  const double s4_27 = work.s2_173*fnma(work.s2_170, s4_23, work.s2_164*work.s4_2);
  const double s4_28 = work.s2_161*fma(work.s2_167, s4_27, s4_23);
  result.zd[Coordinate::carrier_left_ry] = s4_28;
  const double s4_29 = work.s2_147*fnma(work.s2_77, s4_25, fms(work.s2_79, s4_26, work.s2_69));
  const double s4_30 = fma(work.s2_154, s4_26, fms(work.s2_165, s4_25, work.s2_151));
  const double s4_31 = work.s2_147*fma(work.s2_79, s4_28, fnma(work.s2_77, s4_27, work.s4_2));
  const double s4_32 = fma(work.s2_154, s4_28, fms(work.s2_165, s4_27, s4_21));
  result.dz[Coordinate::upper_arm_left] = -(work.s2_156*fma(work.s2_153, s4_29, s4_30));
  result.zd[Coordinate::upper_arm_left] = -(work.s2_156*fma(work.s2_153, s4_31, s4_32));

  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  // arb_link_front_left
  const double s2_193 = 3.846153846153846*s2_192;
  const double s2_194 = 0.5*fma(s2_192, s2_193, work.s2_25);
  result.residual[6] = s2_194;
  const double s2_195 = fnma(work.s2_23, work.s2_59, work.s2_13*s2_193);
  const double s2_196 = fnma(work.s2_16, s2_193, work.s2_24*work.s2_59);
  const double s2_197 = fnma(work.s2_13, work.s2_24, work.s2_23*work.s2_16);
  const double s2_198 = s2_196 + fnma(work.s1_15, s2_193, work.s1_23*work.s2_24);
  const double s2_199 = fnma(work.s1_13, s2_196, work.R_carrier_left_aux2_z_y*s2_195);
  const double s2_200 = fma(work.R_carrier_left_aux2_y_y, s2_197, s2_199);
  const double s2_201 = fma(work.R_carrier_left_aux1_z_x, s2_195, work.cosines[1]*s2_196);
  const double s2_202 = fma(work.R_carrier_left_aux1_y_x, s2_197, s2_201);
  const double s2_203 = fnma(work.sines[0], s2_197, work.cosines[0]*s2_195);
  result.dz[Coordinate::carrier_left_rz] = -s4_25;
  result.zd[Coordinate::carrier_left_rz] = -s4_27;
  result.dz[Coordinate::carrier_left_rx] = -s4_29;
  const double s4_33 = fnma(s2_202, s4_29, fnma(s2_203, s4_25, fms(s2_200, s4_26, s2_194)));
  result.dz[Coordinate::arb_front_left] = work.s2_115*s4_33;
  const double s4_34 = fma(s2_200, s4_28, fnma(s2_203, s4_27, zd_lower_arm_left*s2_198));
  result.zd[Coordinate::carrier_left_rx] = -s4_31;
  result.zd[Coordinate::arb_front_left] = work.s2_115*fnma(s2_202, s4_31, s4_34);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  const double s1_26 = work.sines[15];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_26;
  const double R_rear_axle_aux4_y_x = work.sines[14];
  const double s1_27 = work.sines[16];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_28 = work.cosines[16];
  const double R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_28, R_rear_axle_aux4_y_x*s1_27);
  const double R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_28, R_rear_axle_aux5_x_z*s1_27);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_26;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double R_rear_axle_y_y = fma(R_rear_axle_aux4_x_x, s1_28, R_rear_axle_aux5_y_z*s1_27);
  const double R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_27, R_rear_axle_aux5_y_z*s1_28);
  const double R_rear_axle_aux5_z_z = work.cosines[15];
  const double R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_28;
  const double s2_204 = fnma(p_long_rod_left_to_z, R_rear_axle_z_z, p_long_rod_left_to_x*s1_26);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s2_205 = p_long_rod_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_206 = fma(p_long_rod_left_to_z, R_rear_axle_x_z, s2_205);
  const double R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s2_207 = p_long_rod_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_208 = fma(p_long_rod_left_to_z, R_rear_axle_y_z, s2_207);
  const double s2_209 = fma(p_long_rod_left_to_y, R_rear_axle_y_y, s2_208);
  const double s2_210 = fnma(p_long_rod_left_to_y, R_rear_axle_y_y, s2_208);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_211 = p_long_rod_left_from_y - z_rear_axle_ty - s2_209;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] + p_rear_axle_tx_z;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_27;
  const double s2_212 = fms(p_long_rod_left_to_y, R_rear_axle_z_y, s2_204);
  const double s2_213 = fma(p_long_rod_left_to_y, R_rear_axle_z_y, s2_204);
  const double s2_214 = r_rear_axle_aux3_z - p_long_rod_left_from_z;
  const double s2_215 = s2_212 + s2_214;
  const double s2_216 = s2_214 - s2_213;
  const double s2_217 = 1.1757385222540735*s2_215;
  const double s2_218 = 1.1757385222540735*s2_211;
  const double s2_219 = fma(s2_212, s2_218, s2_217*s2_209);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  const double s2_220 = fma(p_long_rod_left_to_y, R_rear_axle_x_y, s2_206);
  const double s2_221 = fnma(p_long_rod_left_to_y, R_rear_axle_x_y, s2_206);
  const double s2_222 = r_rear_axle_aux1_x - p_long_rod_left_from_x;
  const double s2_223 = s2_220 + s2_222;
  const double s2_224 = s2_222 + s2_221;
  const double s2_225 = 1.1757385222540735*s2_223;
  const double s2_226 = fma(s2_220, s2_218, s2_225*s2_209);
  const double s2_227 = fma(s2_223, s2_225, fms(s2_215, s2_217, l_long_rod_left));
  const double s2_228 = 0.5*fma(s2_211, s2_218, s2_227);
  result.residual[11] = s2_228;
  const double s2_229 = fnma(s2_212, s2_225, s2_220*s2_217);
  const double s2_230 = p_diag_rod_left_to_y*R_rear_axle_y_y;
  const double s2_231 = fma(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_230);
  const double s2_232 = fms(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_230);
  const double s2_233 = p_diag_rod_left_from_y - z_rear_axle_ty - s2_231;
  const double s2_234 = p_diag_rod_left_to_y*R_rear_axle_z_y;
  const double s2_235 = fma(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_234);
  const double s2_236 = fms(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_234);
  const double s2_237 = r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  const double s2_238 = r_rear_axle_aux3_z - p_arb_rear_left_z;
  const double s2_239 = s2_235 + s2_237;
  const double s2_240 = s2_237 + s2_236;
  const double s2_241 = 1.162476387438193*s2_239;
  const double s2_242 = 1.162476387438193*s2_233;
  const double s2_243 = fma(s2_235, s2_242, s2_241*s2_231);
  const double s2_244 = p_diag_rod_left_to_z*R_rear_axle_x_z;
  const double s2_245 = fma(p_diag_rod_left_to_y, R_rear_axle_x_y, s2_244);
  const double s2_246 = fnma(p_diag_rod_left_to_y, R_rear_axle_x_y, s2_244);
  const double s2_247 = r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  const double s2_248 = s2_245 + s2_247;
  const double s2_249 = s2_247 + s2_246;
  const double s2_250 = 1.162476387438193*s2_248;
  const double s2_251 = fma(s2_245, s2_242, s2_250*s2_231);
  const double s2_252 = fma(s2_248, s2_250, fms(s2_239, s2_241, l_diag_rod_left));
  const double s2_253 = 0.5*fma(s2_233, s2_242, s2_252);
  result.residual[12] = s2_253;
  const double s2_254 = fnma(s2_235, s2_250, s2_245*s2_241);
  const double s2_255 = -p_arb_link_rear_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_256 = fnma(p_arb_link_rear_left_to_z, R_rear_axle_x_z, s2_255);
  const double s2_257 = -p_arb_link_rear_left_to_x*s1_26;
  const double s2_258 = fma(p_arb_link_rear_left_to_z, R_rear_axle_z_z, s2_257);
  const double s2_259 = p_arb_link_rear_left_from_x*work.sines[17];
  const double s2_260 = fma(p_arb_link_rear_left_to_y, R_rear_axle_z_y, s2_258);
  const double s2_261 = fnma(p_arb_link_rear_left_to_y, R_rear_axle_z_y, s2_258);
  const double s2_262 = s2_238 + (s2_259 + s2_260);
  const double s2_263 = p_arb_link_rear_left_from_x*work.cosines[17];
  const double s2_264 = fms(p_arb_link_rear_left_to_y, R_rear_axle_x_y, s2_256);
  const double s2_265 = s2_263 + p_arb_rear_left_x - r_rear_axle_aux1_x - s2_264;
  const double s2_266 = fma(p_arb_link_rear_left_to_y, R_rear_axle_x_y, s2_256);
  const double s2_267 = 4.47213595499958*s2_262;
  const double s2_268 = 4.47213595499958*s2_265;
  const double pivot_arb_rear_left = fnma(s2_259, s2_268, s2_263*s2_267);
  // long_rod_right
  const double s2_269 = s2_210 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s2_270 = 1.1757385222540735*s2_269;
  const double s2_271 = 1.1757385222540735*s2_216;
  const double s2_272 = fma(s2_210, s2_271, s2_213*s2_270);
  const double s2_273 = 1.1757385222540735*s2_224;
  const double s2_274 = fma(s2_216, s2_271, fms(s2_269, s2_270, l_long_rod_right));
  const double s2_275 = fnma(s2_221, s2_270, s2_210*s2_273);
  const double s2_276 = 0.5*fma(s2_224, s2_273, s2_274);
  result.residual[14] = s2_276;
  const double s2_277 = fma(s2_213, s2_273, s2_221*s2_271);
  const double s2_278 = s2_232 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  const double pivot_rear_axle_tx = 1.162476387438193*s2_249;
  const double s2_279 = 1.162476387438193*s2_278;
  const double s2_280 = fnma(s2_246, s2_279, pivot_rear_axle_tx*s2_232);
  const double s2_281 = 1.162476387438193*s2_240;
  const double s2_282 = fnma(pivot_rear_axle_tx, s2_236, s2_246*s2_281);
  const double s2_283 = fma(s2_240, s2_281, fms(s2_249, pivot_rear_axle_tx, l_diag_rod_right));
  const double s2_284 = 0.5*fma(s2_278, s2_279, s2_283);
  result.residual[15] = s2_284;
  const double s2_285 = fnma(s2_232, s2_281, s2_236*s2_279);
  const double s2_286 = p_arb_link_rear_right_from_x*work.cosines[18];
  const double s2_287 = s2_266 + (s2_286 + p_arb_rear_right_x - r_rear_axle_aux1_x);
  const double s2_288 = p_arb_link_rear_right_from_x*work.sines[18];
  const double s2_289 = s2_288 + (s2_238 + s2_261);
  const double s2_290 = 4.47213595499958*s2_289;
  const double s2_291 = 4.47213595499958*s2_287;
  const double pivot_arb_rear_right = fnma(s2_288, s2_291, s2_286*s2_290);
  const double s2_292 = 1.0/pivot_arb_rear_left;
  const double s2_293 = 1.0/pivot_arb_rear_right;
  const double s2_294 = 3.204642123170383*std::abs(pivot_arb_rear_right);
  const double s2_295 = 1.0/pivot_rear_axle_tx;
  const double s2_296 = s2_225*s2_295;
  const double s2_297 = s2_273*s2_295;
  const double s2_298 = s2_250*s2_295;
  const double s2_299 = mbgen::min(3.194382824999693*std::abs(pivot_arb_rear_left), s2_294);
  const double s2_300 = fma(s2_279, s2_296, s2_218);
  const double s4_35 = fms(s2_284, s2_296, s2_228);
  const double pivot_rear_axle_rz = fms(s2_280, s2_296, s2_226);
  const double s2_301 = 1.0/pivot_rear_axle_rz;
  const double s2_302 = mbgen::min(1.0748203921841*std::abs(pivot_rear_axle_tx), s2_299);
  const double s2_303 = fnma(R_rear_axle_aux4_y_x, s2_285, R_rear_axle_aux4_x_x*s2_282);
  const double s2_304 = fnma(s1_26, s2_280, R_rear_axle_aux5_y_x*s2_282);
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s4_36 = zd_rear_axle_rx*fma(R_rear_axle_aux5_x_x, s2_285, s2_304);
  const double s4_37 = fnma(zd_rear_axle_tz, s2_281, s4_36);
  const double s2_305 = fnma(R_rear_axle_aux4_y_x, s2_219, s2_303*s2_296);
  const double s2_306 = fnma(R_rear_axle_aux4_x_x, s2_229, s2_305);
  const double s2_307 = fnma(R_rear_axle_aux5_x_x, s2_219, R_rear_axle_aux5_y_x*s2_229);
  const double s4_38 = zd_rear_axle_rx*fnma(s1_26, s2_226, s2_307);
  const double s4_39 = fnma(s2_296, s4_37, fnma(zd_rear_axle_tz, s2_217, s4_38));
  const double s2_308 = fms(s2_280, s2_297, s2_275)*s2_301;
  const double s2_309 = fma(s2_308, s2_300, fnma(s2_279, s2_297, s2_270));
  const double s4_40 = fnma(s2_308, s4_35, fms(s2_284, s2_297, s2_276));
  const double s2_310 = fnma(R_rear_axle_aux4_y_x, s2_272, s2_303*s2_297);
  const double pivot_rear_axle_ry = fnma(s2_306, s2_308, fnma(R_rear_axle_aux4_x_x, s2_277,
      s2_310));
  const double s2_311 = fnma(R_rear_axle_aux5_x_x, s2_272, R_rear_axle_aux5_y_x*s2_277);
  const double s4_41 = zd_rear_axle_rx*fnma(s1_26, s2_275, s2_311);
  const double s4_42 = fnma(s2_297, s4_37, fnma(zd_rear_axle_tz, s2_271, s4_41));
  const double s4_43 = fnma(s2_308, s4_39, s4_42);
  const double s2_312 = 1.0/pivot_rear_axle_ry;
  const double s2_313 = mbgen::min(s2_302, 1.5318884572025857*std::abs(pivot_rear_axle_rz));
  const double s2_314 = s2_301*fms(s2_280, s2_298, s2_251);
  const double s2_315 = fnma(R_rear_axle_aux4_y_x, s2_243, s2_303*s2_298);
  const double s2_316 = fnma(s2_306, s2_314, fnma(R_rear_axle_aux4_x_x, s2_254, s2_315))*s2_312;
  const double s2_317 = fnma(R_rear_axle_aux5_x_x, s2_243, R_rear_axle_aux5_y_x*s2_254);
  const double pivot_rear_axle_ty = fnma(s2_309, s2_316, fnma(s2_279, s2_298, fms(s2_300, s2_314,
      s2_242)));
  const double s4_44 = zd_rear_axle_rx*fnma(s1_26, s2_251, s2_317);
  const double s4_45 = fnma(s2_298, s4_37, fnma(zd_rear_axle_tz, s2_241, s4_44));
  const double s2_318 = 1.0/pivot_rear_axle_ty;
  const double s4_46 = fnma(s2_316, s4_40, fnma(s2_314, s4_35, fms(s2_284, s2_298, s2_253)));
  const double s4_47 = s2_318*s4_46;
  result.dz[Coordinate::rear_axle_ty] = s4_47;
  const double s4_48 = s2_318*fnma(s2_316, s4_43, fnma(s2_314, s4_39, s4_45));
  result.zd[Coordinate::rear_axle_ty] = s4_48;
  const double s2_319 = mbgen::min(s2_313, 1.7893247478820993*std::abs(pivot_rear_axle_ry));
  result.pivot[1] = mbgen::min(s2_319, 1.4337752588788297*std::abs(pivot_rear_axle_ty));

  // --- step 4: velocities, continued ---
  // loop block 1
  const double s4_49 = s2_312*fnma(s2_309, s4_47, s4_40);
  result.dz[Coordinate::rear_axle_ry] = s4_49;
  const double s4_50 = s2_312*fnma(s2_309, s4_48, s4_43);
  result.zd[Coordinate::rear_axle_ry] = s4_50;
  const double s4_51 = s2_301*fnma(s2_306, s4_49, fma(s2_300, s4_47, s4_35));
  result.dz[Coordinate::rear_axle_rz] = s4_51;
  const double s4_52 = s2_301*fnma(s2_306, s4_50, fma(s2_300, s4_48, s4_39));
  result.zd[Coordinate::rear_axle_rz] = s4_52;
  const double s4_53 = fma(s2_280, s4_51, fnma(s2_279, s4_47, fms(s2_303, s4_49, s2_284)));
  const double s4_54 = s2_295*s4_53;
  result.dz[Coordinate::rear_axle_tx] = s4_54;
  const double s4_55 = fma(s2_280, s4_52, fma(s2_303, s4_50, fnma(s2_279, s4_48, s4_37)));
  const double s4_56 = s2_295*s4_55;
  result.zd[Coordinate::rear_axle_tx] = s4_56;
  const double s2_320 = -p_arb_link_rear_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_321 = fnma(p_arb_link_rear_left_to_z, R_rear_axle_y_z, s2_320);
  const double s2_322 = fms(p_arb_link_rear_left_to_y, R_rear_axle_y_y, s2_321);
  const double s2_323 = fma(p_arb_link_rear_left_to_y, R_rear_axle_y_y, s2_321);
  const double s2_324 = 0.6 - z_rear_axle_ty - s2_322;
  const double s2_325 = 4.47213595499958*s2_324;
  const double s2_326 = fma(s2_265, s2_268, fms(s2_262, s2_267, l_arb_link_rear_left));
  const double s2_327 = 0.5*fma(s2_324, s2_325, s2_326);
  result.residual[13] = s2_327;
  const double s2_328 = fnma(s2_268, s2_322, s2_264*s2_325);
  const double s2_329 = fma(s2_260, s2_268, s2_267*s2_264);
  const double s2_330 = fma(s2_260, s2_325, s2_267*s2_322);
  const double s2_331 = fma(R_rear_axle_aux4_x_x, s2_329, R_rear_axle_aux4_y_x*s2_330);
  const double s2_332 = fnma(R_rear_axle_aux5_x_x, s2_330, R_rear_axle_aux5_y_x*s2_329);
  const double s4_57 = fma(s2_328, s4_51, fma(s2_331, s4_49, fms(s2_325, s4_47, s2_327)));
  result.dz[Coordinate::arb_rear_left] = s2_292*fma(s2_268, s4_54, s4_57);
  const double s4_58 = zd_rear_axle_rx*fnma(s1_26, s2_328, s2_332);
  const double s4_59 = fma(s2_325, s4_48, fnma(zd_rear_axle_tz, s2_267, s4_58));
  result.zd[Coordinate::arb_rear_left] = s2_292*fma(s2_268, s4_56, fma(s2_328, s4_52, fma(s2_331,
      s4_50, s4_59)));

  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  // arb_link_rear_right
  const double s2_333 = 0.6 + z_rear_axle_ty - s2_323;
  const double s2_334 = 4.47213595499958*s2_333;
  const double s2_335 = fma(s2_287, s2_291, fms(s2_289, s2_290, l_arb_link_rear_right));
  const double s2_336 = 0.5*fma(s2_333, s2_334, s2_335);
  result.residual[16] = s2_336;
  const double s2_337 = fma(s2_266, s2_334, s2_291*s2_323);
  const double s2_338 = fma(s2_261, s2_334, s2_290*s2_323);
  const double s2_339 = fnma(s2_290, s2_266, s2_261*s2_291);
  const double s2_340 = fnma(R_rear_axle_aux4_y_x, s2_338, R_rear_axle_aux4_x_x*s2_339);
  const double s2_341 = fnma(s1_26, s2_337, R_rear_axle_aux5_y_x*s2_339);

  // --- step 4: velocities, continued ---
  const double s4_60 = zd_rear_axle_rx*fma(R_rear_axle_aux5_x_x, s2_338, s2_341);
  const double s4_61 = fma(s2_337, s4_51, fnma(s2_334, s4_47, fms(s2_340, s4_49, s2_336)));
  const double s4_62 = fnma(s2_334, s4_48, fnma(zd_rear_axle_tz, s2_290, s4_60));
  result.dz[Coordinate::arb_rear_right] = s2_293*fma(s2_291, s4_54, s4_61);
  result.zd[Coordinate::arb_rear_right] = s2_293*fma(s2_291, s4_56, fma(s2_337, s4_52, fma(s2_340,
      s4_50, s4_62)));
  // operations of step 1: poses and axes b: 34 add, 74 multiply, 38 sin cos
  // operations of step 4: velocities: 98 add, 149 multiply
  // operations of step 2: closure Jacobian Phi_z and its factors (60): 308 add, 415 multiply, 17
  // divide, 32 other
}

/// One Newton step of the frozen partition, and consistent velocities.
void compute_closure(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    Closure& __restrict result) noexcept {
  ClosureWork work;
  compute_closure_1(state, work, result);
  compute_closure_2(state, work, result);
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
struct ConstraintForcesWork {
  double
      sines[22], cosines[22], R_carrier_left_aux1_z_z, R_carrier_left_aux1_y_x,
      R_carrier_left_aux1_y_z, R_carrier_left_aux1_z_x, s1_18, r_carrier_left_aux1_y, s1_20,
      r_carrier_left_aux1_z, s1_22, R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y,
      R_carrier_left_x_x, R_carrier_left_x_z, R_carrier_left_y_x, R_carrier_left_y_z,
      R_carrier_left_z_x, R_carrier_left_z_z, s1_27, s1_29, s1_31, R_carrier_right_aux1_z_z,
      R_carrier_right_aux1_y_x, R_carrier_right_aux1_y_z, R_carrier_right_aux1_z_x, s1_36,
      r_carrier_right_aux1_y, s1_38, s1_39, s1_41, R_carrier_right_aux2_y_y,
      R_carrier_right_aux2_z_y, R_carrier_right_x_x, R_carrier_right_x_z, R_carrier_right_y_x,
      R_carrier_right_y_z, R_carrier_right_z_x, R_carrier_right_z_z, s1_54, s1_56, s1_58,
      r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux4_z_z, s1_60, R_rear_axle_aux4_x_z,
      s1_62, R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, R_rear_axle_aux5_z_x, R_rear_axle_x_y,
      R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z, s1_67,
      s1_68, s1_69, s1_75, s1_77, s1_78, s1_81, s1_84, s1_85, s1_86, s1_92, s1_94, s1_95, s1_98,
      s1_101, s1_102, s1_103, s1_109, s1_111, s1_112, s1_114, s1_116, s1_117, s1_118, w_chassis_x,
      w_chassis_y, w_chassis_z, w_carrier_left_x, w_carrier_left_y, w_carrier_left_z,
      w_wheel_front_left_x, w_wheel_front_left_y, w_wheel_front_left_z, w_arb_front_left_y,
      w_carrier_right_x, w_carrier_right_y, w_carrier_right_z, w_wheel_front_right_x,
      w_wheel_front_right_y, w_wheel_front_right_z, w_arb_front_right_y, w_rear_axle_x,
      w_rear_axle_y, w_rear_axle_z, s4_36, w_wheel_rear_left_x, s4_37, w_wheel_rear_left_y, s4_38,
      w_wheel_rear_left_z, w_arb_rear_left_y, s4_39, w_wheel_rear_right_x, s4_40,
      w_wheel_rear_right_y, s4_41, w_wheel_rear_right_z, w_arb_rear_right_y, a_chassis_x,
      a_chassis_y, a_chassis_z, alpha_chassis_x, alpha_chassis_y, alpha_chassis_z, s7_9, s7_10,
      s7_11, s7_12, s7_13, s7_14, s7_15, s7_16, s7_17, s7_18, s7_19, s7_21, a_lower_arm_left_y,
      s7_26, a_lower_arm_left_z, alpha_lower_arm_left_x, s7_27, s7_28, s7_29, s7_30,
      a_carrier_left_aux1_x, a_carrier_left_aux1_y, a_carrier_left_aux1_z, alpha_carrier_left_x,
      alpha_carrier_left_y, alpha_carrier_left_z, s7_51, s7_52, s7_53, s7_54, s7_55, s7_56, s7_57,
      s7_58, s7_59, a_wheel_front_left_x, a_wheel_front_left_y, a_wheel_front_left_z,
      alpha_wheel_front_left_x, alpha_wheel_front_left_y, alpha_wheel_front_left_z,
      a_upper_arm_left_y, a_upper_arm_left_z, alpha_upper_arm_left_x, s7_71, s7_72, s7_73, s7_74,
      a_arb_front_left_x, a_arb_front_left_y, a_arb_front_left_z, alpha_arb_front_left_x,
      alpha_arb_front_left_y, alpha_arb_front_left_z, s7_81, s7_82, s7_83, s7_84, s7_85, s7_86,
      s7_87, s7_88, s7_89, a_lower_arm_right_y, s7_90, a_lower_arm_right_z, alpha_lower_arm_right_x,
      s7_91, s7_92, s7_93, s7_94, a_carrier_right_aux1_x, a_carrier_right_aux1_y,
      a_carrier_right_aux1_z, alpha_carrier_right_x, alpha_carrier_right_y, alpha_carrier_right_z,
      s7_115, s7_116, s7_117, s7_118, s7_119, s7_120, s7_121, s7_122, s7_123, a_wheel_front_right_x,
      a_wheel_front_right_y, a_wheel_front_right_z, alpha_wheel_front_right_x,
      alpha_wheel_front_right_y, alpha_wheel_front_right_z, a_upper_arm_right_y,
      a_upper_arm_right_z, alpha_upper_arm_right_x, s7_132, s7_133, s7_134, s7_135,
      a_arb_front_right_x, a_arb_front_right_y, a_arb_front_right_z, alpha_arb_front_right_x,
      alpha_arb_front_right_y, alpha_arb_front_right_z, s7_136, s7_137, s7_138, s7_139, s7_140,
      s7_141, s7_142, s7_143, a_pitman_arm_x, a_pitman_arm_y, a_pitman_arm_z, alpha_pitman_arm_y,
      s7_150, s7_151, s7_152, s7_153, s7_154, s7_155, a_bell_crank_x, a_bell_crank_y,
      a_bell_crank_z, alpha_bell_crank_z, s7_159, s7_160, s7_161, s7_162, s7_163, s7_164,
      a_rear_axle_aux3_x, a_rear_axle_aux3_y, a_rear_axle_aux3_z, alpha_rear_axle_x,
      alpha_rear_axle_y, alpha_rear_axle_z, s7_195, s7_196, s7_197, s7_198, s7_241, s7_243, s7_246,
      s7_249, s7_252, s7_255, s7_258, s7_261, s7_264, s7_267, s7_269, s7_271, s7_274, s7_277,
      s7_280, s7_283, s7_286, s7_289, s7_296, s7_297, s7_298, s7_308, s7_309, s7_312, s7_313,
      s7_314, s7_316, s7_318, s7_320, s7_322, s7_324, s7_326, s7_333, s7_334, s7_335, s7_338,
      s7_339, s7_342, s7_343, s7_346, s7_348, s7_350, s7_352, s7_363, s7_366, s7_369, s7_381,
      s7_383, s7_385, s7_394, s7_401, s7_402, s7_403, s7_404, s7_420, s7_421, s7_422, s7_428,
      s7_429, s7_430, s7_435, s7_436, s7_437, s7_438, s7_439, s7_607, s7_610, s7_613,
      Q_rear_axle_tz, Q_rear_axle_ty, Q_rear_axle_tx, Q_pitman_arm, Q_arb_front_right,
      Q_upper_arm_right, f_wheel_front_right_x, f_wheel_front_right_y, f_wheel_front_right_z,
      s7_708, s7_712, n_wheel_front_right_x, n_wheel_front_right_y, s7_717;
};

/// Part 1 of compute_multipliers: step 1: poses and axes b; step 4: velocities; step 7: inertias of
/// the bodies and forces on joints.
[[gnu::noinline]] void compute_multipliers_1(const State& state, const Derivative& derivative,
    ConstraintForcesWork& __restrict work) noexcept {
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
  mbgen::sincos(angles, work.sines, work.cosines);
  const double s1_1 = state.charts[0] - 0.5;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_y_x = work.sines[0];
  const double s1_2 = work.cosines[1];
  const double R_chassis_aux5_y_x = R_chassis_aux4_y_x*s1_2;
  const double s1_3 = work.sines[1];
  const double s1_4 = -s1_3;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux4_y_y = work.cosines[0];
  const double s1_5 = R_chassis_aux4_y_y*s1_2;
  const double R_chassis_x_x = (s1_1 >= 0.0 ? s1_4 : s1_5);
  const double s1_6 = work.sines[2];
  const double s1_7 = s1_2*s1_6;
  const double s1_8 = s1_3*s1_6;
  const double s1_9 = work.cosines[2];
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
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_lower_arm_left_y_z = -R_lower_arm_left_z_y;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_14 = state.charts[1] - 0.5;
  const double R_lower_arm_left_y_y = work.cosines[3];
  work.R_carrier_left_aux1_z_z = (s1_14 >= 0.0 ? R_lower_arm_left_y_z : R_lower_arm_left_y_y);
  const double s1_15 = work.sines[4];
  work.R_carrier_left_aux1_y_x = s1_15*work.R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_carrier_left_aux1_x_x*work.R_carrier_left_aux1_z_z;
  work.R_carrier_left_aux1_y_z = (s1_14 >= 0.0 ? -R_lower_arm_left_y_y : R_lower_arm_left_y_z);
  const double s1_16 = (s1_14 >= 0.0 ? R_lower_arm_left_y_y : R_lower_arm_left_z_y);
  work.R_carrier_left_aux1_z_x = s1_15*s1_16;
  const double R_carrier_left_aux1_z_y = R_carrier_left_aux1_x_x*s1_16;
  const double s1_17 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  work.s1_18 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_17);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_18;
  const double s1_19 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_20 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_19);
  work.r_carrier_left_aux1_z = work.s1_20 + p_lower_arm_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_21 = work.cosines[5];
  work.s1_22 = s1_15*s1_21;
  const double s1_23 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_15*s1_23;
  work.R_carrier_left_aux2_y_y = fma(work.R_carrier_left_aux1_y_z, s1_23,
      R_carrier_left_aux1_y_y*s1_21);
  const double R_carrier_left_aux2_y_z = fnma(R_carrier_left_aux1_y_y, s1_23,
      work.R_carrier_left_aux1_y_z*s1_21);
  work.R_carrier_left_aux2_z_y = fma(work.R_carrier_left_aux1_z_z, s1_23,
      R_carrier_left_aux1_z_y*s1_21);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_23,
      work.R_carrier_left_aux1_z_z*s1_21);
  const double s1_24 = work.cosines[6];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = work.sines[6];
  work.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_25, R_carrier_left_aux1_x_x*s1_24);
  work.R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_25, R_carrier_left_aux2_x_z*s1_24);
  work.R_carrier_left_y_x = fnma(R_carrier_left_aux2_y_z, s1_25,
      work.R_carrier_left_aux1_y_x*s1_24);
  work.R_carrier_left_y_z = fma(work.R_carrier_left_aux1_y_x, s1_25, R_carrier_left_aux2_y_z*s1_24);
  work.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_25,
      work.R_carrier_left_aux1_z_x*s1_24);
  work.R_carrier_left_z_z = fma(work.R_carrier_left_aux1_z_x, s1_25, R_carrier_left_aux2_z_z*s1_24);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_26 = p_wheel_front_left_z*work.R_carrier_left_x_z;
  work.s1_27 = fnma(p_wheel_front_left_y, work.s1_22, s1_26);
  const double s1_28 = p_wheel_front_left_y*work.R_carrier_left_aux2_y_y;
  work.s1_29 = fma(p_wheel_front_left_z, work.R_carrier_left_y_z, s1_28);
  const double s1_30 = p_wheel_front_left_y*work.R_carrier_left_aux2_z_y;
  work.s1_31 = fma(p_wheel_front_left_z, work.R_carrier_left_z_z, s1_30);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_z = -R_lower_arm_right_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_32 = state.charts[2] - 0.5;
  const double R_lower_arm_right_y_y = work.cosines[9];
  work.R_carrier_right_aux1_z_z = (s1_32 >= 0.0 ? R_lower_arm_right_y_z : R_lower_arm_right_y_y);
  const double s1_33 = work.sines[10];
  work.R_carrier_right_aux1_y_x = s1_33*work.R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_carrier_right_aux1_x_x*work.R_carrier_right_aux1_z_z;
  work.R_carrier_right_aux1_y_z = (s1_32 >= 0.0 ? -R_lower_arm_right_y_y : R_lower_arm_right_y_z);
  const double s1_34 = (s1_32 >= 0.0 ? R_lower_arm_right_y_y : R_lower_arm_right_z_y);
  work.R_carrier_right_aux1_z_x = s1_33*s1_34;
  const double R_carrier_right_aux1_z_y = R_carrier_right_aux1_x_x*s1_34;
  const double s1_35 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  work.s1_36 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_35);
  work.r_carrier_right_aux1_y = work.s1_36 + p_lower_arm_right_y;
  const double s1_37 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  work.s1_38 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_37);
  work.s1_39 = work.s1_38 - p_lower_arm_right_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_40 = work.cosines[11];
  work.s1_41 = s1_33*s1_40;
  const double s1_42 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_33*s1_42;
  const double s1_43 = R_carrier_right_aux1_y_y*s1_40;
  work.R_carrier_right_aux2_y_y = fma(work.R_carrier_right_aux1_y_z, s1_42, s1_43);
  const double s1_44 = work.R_carrier_right_aux1_y_z*s1_40;
  const double R_carrier_right_aux2_y_z = fnma(R_carrier_right_aux1_y_y, s1_42, s1_44);
  const double s1_45 = R_carrier_right_aux1_z_y*s1_40;
  work.R_carrier_right_aux2_z_y = fma(work.R_carrier_right_aux1_z_z, s1_42, s1_45);
  const double s1_46 = work.R_carrier_right_aux1_z_z*s1_40;
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_42, s1_46);
  const double s1_47 = work.cosines[12];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_48 = work.sines[12];
  work.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_48, R_carrier_right_aux1_x_x*s1_47);
  work.R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_48, R_carrier_right_aux2_x_z*s1_47);
  const double s1_49 = work.R_carrier_right_aux1_y_x*s1_47;
  work.R_carrier_right_y_x = fnma(R_carrier_right_aux2_y_z, s1_48, s1_49);
  const double s1_50 = R_carrier_right_aux2_y_z*s1_47;
  work.R_carrier_right_y_z = fma(work.R_carrier_right_aux1_y_x, s1_48, s1_50);
  const double s1_51 = work.R_carrier_right_aux1_z_x*s1_47;
  work.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_48, s1_51);
  const double s1_52 = R_carrier_right_aux2_z_z*s1_47;
  work.R_carrier_right_z_z = fma(work.R_carrier_right_aux1_z_x, s1_48, s1_52);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_53 = -p_wheel_front_right_y*work.s1_41;
  work.s1_54 = fma(p_wheel_front_right_z, work.R_carrier_right_x_z, s1_53);
  const double s1_55 = p_wheel_front_right_z*work.R_carrier_right_y_z;
  work.s1_56 = fma(p_wheel_front_right_y, work.R_carrier_right_aux2_y_y, s1_55);
  const double s1_57 = p_wheel_front_right_z*work.R_carrier_right_z_z;
  work.s1_58 = fma(p_wheel_front_right_y, work.R_carrier_right_aux2_z_y, s1_57);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double z_rear_axle_tz = state.z[Coordinate::rear_axle_tz];
  work.r_rear_axle_aux3_z = z_rear_axle_tz + p_rear_axle_tx_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s1_59 = state.charts[3] - 0.5;
  work.R_rear_axle_aux4_z_z = (s1_59 >= 0.0 ? 0.0 : 1.0);
  const double R_rear_axle_aux4_y_y = work.cosines[17];
  const double R_rear_axle_aux4_x_x = R_rear_axle_aux4_y_y*work.R_rear_axle_aux4_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.s1_60 = work.R_rear_axle_aux4_z_z*R_rear_axle_aux4_y_x;
  work.R_rear_axle_aux4_x_z = (s1_59 >= 0.0 ? 1.0 : 0.0);
  const double s1_61 = (s1_59 >= 0.0 ? -1.0 : 0.0);
  const double R_rear_axle_aux4_z_x = R_rear_axle_aux4_y_y*s1_61;
  work.s1_62 = R_rear_axle_aux4_y_x*s1_61;
  const double s1_63 = work.cosines[18];
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s1_64 = work.sines[18];
  work.R_rear_axle_aux5_x_x = fnma(work.R_rear_axle_aux4_x_z, s1_64, R_rear_axle_aux4_x_x*s1_63);
  const double R_rear_axle_aux5_x_z = fma(R_rear_axle_aux4_x_x, s1_64,
      work.R_rear_axle_aux4_x_z*s1_63);
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*s1_63;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_64;
  work.R_rear_axle_aux5_z_x = fnma(work.R_rear_axle_aux4_z_z, s1_64, R_rear_axle_aux4_z_x*s1_63);
  const double R_rear_axle_aux5_z_z = fma(R_rear_axle_aux4_z_x, s1_64,
      work.R_rear_axle_aux4_z_z*s1_63);
  const double s1_65 = work.sines[19];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_66 = work.cosines[19];
  work.R_rear_axle_x_y = fnma(work.s1_60, s1_66, R_rear_axle_aux5_x_z*s1_65);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_66, work.s1_60*s1_65);
  work.R_rear_axle_y_y = fma(R_rear_axle_aux4_y_y, s1_66, R_rear_axle_aux5_y_z*s1_65);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_y_y, s1_65, R_rear_axle_aux5_y_z*s1_66);
  work.R_rear_axle_z_y = fnma(work.s1_62, s1_66, R_rear_axle_aux5_z_z*s1_65);
  work.R_rear_axle_z_z = fma(R_rear_axle_aux5_z_z, s1_66, work.s1_62*s1_65);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  work.s1_67 = p_wheel_rear_left_y*work.R_rear_axle_x_y;
  work.s1_68 = p_wheel_rear_left_y*work.R_rear_axle_y_y;
  work.s1_69 = p_wheel_rear_left_y*work.R_rear_axle_z_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_70 = work.R_carrier_left_aux1_z_x*work.s1_22;
  const double s1_71 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s1_70);
  const double s1_72 = work.R_carrier_left_aux1_y_x*work.s1_22;
  const double s1_73 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s1_72);
  const double s1_74 = work.R_carrier_left_aux1_z_z*s1_73;
  work.s1_75 = fnma(work.R_carrier_left_aux1_y_z, s1_71, s1_74);
  const double s1_76 = 1.0/work.s1_75;
  work.s1_77 = R_carrier_left_aux1_y_y*s1_76;
  work.s1_78 = s1_73*s1_76;
  const double s1_79 = work.R_carrier_left_aux1_y_z*work.R_carrier_left_aux1_z_x;
  const double s1_80 = fnma(work.R_carrier_left_aux1_z_z, work.R_carrier_left_aux1_y_x, s1_79);
  work.s1_81 = s1_76*s1_80;
  const double s1_82 = work.R_carrier_left_aux1_y_x*work.R_carrier_left_aux2_z_y;
  const double s1_83 = fnma(work.R_carrier_left_aux1_z_x, work.R_carrier_left_aux2_y_y, s1_82);
  work.s1_84 = s1_76*s1_83;
  work.s1_85 = R_carrier_left_aux1_x_x*work.R_carrier_left_aux1_y_z*s1_76;
  work.s1_86 = s1_71*s1_76;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_87 = work.R_carrier_right_aux1_z_x*work.s1_41;
  const double s1_88 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s1_87);
  const double s1_89 = work.R_carrier_right_aux1_y_x*work.s1_41;
  const double s1_90 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s1_89);
  const double s1_91 = work.R_carrier_right_aux1_z_z*s1_90;
  work.s1_92 = fnma(work.R_carrier_right_aux1_y_z, s1_88, s1_91);
  const double s1_93 = 1.0/work.s1_92;
  work.s1_94 = R_carrier_right_aux1_y_y*s1_93;
  work.s1_95 = s1_90*s1_93;
  const double s1_96 = work.R_carrier_right_aux1_y_z*work.R_carrier_right_aux1_z_x;
  const double s1_97 = fnma(work.R_carrier_right_aux1_z_z, work.R_carrier_right_aux1_y_x, s1_96);
  work.s1_98 = s1_93*s1_97;
  const double s1_99 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s1_100 = fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y, s1_99);
  work.s1_101 = s1_93*s1_100;
  work.s1_102 = R_carrier_right_aux1_x_x*work.R_carrier_right_aux1_y_z*s1_93;
  work.s1_103 = s1_88*s1_93;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_104 = R_rear_axle_aux4_y_y*work.R_rear_axle_aux5_x_x;
  const double s1_105 = fma(work.s1_60, work.R_rear_axle_aux5_y_x, s1_104);
  const double s1_106 = work.s1_62*work.R_rear_axle_aux5_y_x;
  const double s1_107 = fma(R_rear_axle_aux4_y_y, work.R_rear_axle_aux5_z_x, s1_106);
  const double s1_108 = work.R_rear_axle_aux4_x_z*s1_107;
  work.s1_109 = fnma(work.R_rear_axle_aux4_z_z, s1_105, s1_108);
  const double s1_110 = 1.0/work.s1_109;
  work.s1_111 = R_rear_axle_aux4_y_y*work.R_rear_axle_aux4_x_z*s1_110;
  work.s1_112 = s1_107*s1_110;
  const double s1_113 = work.R_rear_axle_aux4_x_z*work.s1_62;
  work.s1_114 = s1_110*fnma(work.R_rear_axle_aux4_z_z, work.s1_60, s1_113);
  const double s1_115 = work.s1_60*work.R_rear_axle_aux5_z_x;
  work.s1_116 = s1_110*fnma(work.s1_62, work.R_rear_axle_aux5_x_x, s1_115);
  work.s1_117 = R_rear_axle_aux4_x_x*s1_110;
  work.s1_118 = s1_105*s1_110;
  // operations: 69 add, 166 multiply, 3 divide, 44 sin cos, 15 other

  // --- step 4: velocities ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  const double s4_1 = zd_chassis_rz*s1_3;
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  work.w_chassis_x = zd_chassis_rx - s4_1;
  const double s4_2 = zd_chassis_rz*s1_7;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  const double s4_3 = zd_chassis_ry*s1_9;
  work.w_chassis_y = s4_2 + s4_3;
  const double s4_4 = zd_chassis_rz*s1_11;
  const double s4_5 = zd_chassis_ry*s1_6;
  work.w_chassis_z = s4_4 - s4_5;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double w_lower_arm_left_x = zd_lower_arm_left + work.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double s4_6 = zd_carrier_left_rz*work.R_carrier_left_aux1_y_z;
  const double w_carrier_left_aux1_y = work.w_chassis_y + s4_6;
  const double s4_7 = zd_carrier_left_rz*work.R_carrier_left_aux1_z_z;
  const double w_carrier_left_aux1_z = work.w_chassis_z + s4_7;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double s4_8 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double w_carrier_left_aux2_x = w_lower_arm_left_x + s4_8;
  const double s4_9 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  const double w_carrier_left_aux2_y = w_carrier_left_aux1_y + s4_9;
  const double s4_10 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double w_carrier_left_aux2_z = w_carrier_left_aux1_z + s4_10;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  const double s4_11 = zd_carrier_left_ry*work.s1_22;
  work.w_carrier_left_x = w_carrier_left_aux2_x - s4_11;
  const double s4_12 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.w_carrier_left_y = w_carrier_left_aux2_y + s4_12;
  const double s4_13 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  work.w_carrier_left_z = w_carrier_left_aux2_z + s4_13;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  const double s4_14 = zd_wheel_front_left*work.s1_22;
  work.w_wheel_front_left_x = work.w_carrier_left_x - s4_14;
  const double s4_15 = zd_wheel_front_left*work.R_carrier_left_aux2_y_y;
  work.w_wheel_front_left_y = work.w_carrier_left_y + s4_15;
  const double s4_16 = zd_wheel_front_left*work.R_carrier_left_aux2_z_y;
  work.w_wheel_front_left_z = work.w_carrier_left_z + s4_16;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double w_upper_arm_left_x = state.zd[Coordinate::upper_arm_left] + work.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.w_arb_front_left_y = zd_arb_front_left + work.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double w_lower_arm_right_x = zd_lower_arm_right + work.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double s4_17 = zd_carrier_right_rz*work.R_carrier_right_aux1_y_z;
  const double w_carrier_right_aux1_y = work.w_chassis_y + s4_17;
  const double s4_18 = zd_carrier_right_rz*work.R_carrier_right_aux1_z_z;
  const double w_carrier_right_aux1_z = work.w_chassis_z + s4_18;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double s4_19 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double w_carrier_right_aux2_x = w_lower_arm_right_x + s4_19;
  const double s4_20 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  const double w_carrier_right_aux2_y = w_carrier_right_aux1_y + s4_20;
  const double s4_21 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double w_carrier_right_aux2_z = w_carrier_right_aux1_z + s4_21;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  const double s4_22 = zd_carrier_right_ry*work.s1_41;
  work.w_carrier_right_x = w_carrier_right_aux2_x - s4_22;
  const double s4_23 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.w_carrier_right_y = w_carrier_right_aux2_y + s4_23;
  const double s4_24 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.w_carrier_right_z = w_carrier_right_aux2_z + s4_24;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  const double s4_25 = zd_wheel_front_right*work.s1_41;
  work.w_wheel_front_right_x = work.w_carrier_right_x - s4_25;
  const double s4_26 = zd_wheel_front_right*work.R_carrier_right_aux2_y_y;
  work.w_wheel_front_right_y = work.w_carrier_right_y + s4_26;
  const double s4_27 = zd_wheel_front_right*work.R_carrier_right_aux2_z_y;
  work.w_wheel_front_right_z = work.w_carrier_right_z + s4_27;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double w_upper_arm_right_x = state.zd[Coordinate::upper_arm_right] + work.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.w_arb_front_right_y = zd_arb_front_right + work.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double w_pitman_arm_y = zd_pitman_arm + work.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double w_bell_crank_z = zd_bell_crank + work.w_chassis_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s4_28 = zd_rear_axle_rz*work.R_rear_axle_aux4_x_z;
  const double w_rear_axle_aux4_x = work.w_chassis_x + s4_28;
  const double s4_29 = zd_rear_axle_rz*work.R_rear_axle_aux4_z_z;
  const double w_rear_axle_aux4_z = work.w_chassis_z + s4_29;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double s4_30 = zd_rear_axle_ry*work.s1_60;
  const double w_rear_axle_aux5_x = w_rear_axle_aux4_x - s4_30;
  const double s4_31 = zd_rear_axle_ry*R_rear_axle_aux4_y_y;
  const double w_rear_axle_aux5_y = work.w_chassis_y + s4_31;
  const double s4_32 = zd_rear_axle_ry*work.s1_62;
  const double w_rear_axle_aux5_z = w_rear_axle_aux4_z - s4_32;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s4_33 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.w_rear_axle_x = w_rear_axle_aux5_x + s4_33;
  const double s4_34 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.w_rear_axle_y = w_rear_axle_aux5_y + s4_34;
  const double s4_35 = zd_rear_axle_rx*work.R_rear_axle_aux5_z_x;
  work.w_rear_axle_z = w_rear_axle_aux5_z + s4_35;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  work.s4_36 = zd_wheel_rear_left*work.R_rear_axle_x_y;
  work.w_wheel_rear_left_x = work.w_rear_axle_x + work.s4_36;
  work.s4_37 = zd_wheel_rear_left*work.R_rear_axle_y_y;
  work.w_wheel_rear_left_y = work.w_rear_axle_y + work.s4_37;
  work.s4_38 = zd_wheel_rear_left*work.R_rear_axle_z_y;
  work.w_wheel_rear_left_z = work.w_rear_axle_z + work.s4_38;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  work.s4_39 = zd_wheel_rear_right*work.R_rear_axle_x_y;
  work.w_wheel_rear_right_x = work.w_rear_axle_x + work.s4_39;
  work.s4_40 = zd_wheel_rear_right*work.R_rear_axle_y_y;
  work.w_wheel_rear_right_y = work.w_rear_axle_y + work.s4_40;
  work.s4_41 = zd_wheel_rear_right*work.R_rear_axle_z_y;
  work.w_wheel_rear_right_z = work.w_rear_axle_z + work.s4_41;
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + work.w_chassis_y;
  // operations: 49 add, 41 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_1 = derivative.zdd[Coordinate::chassis_tz] - g_z;
  const double zdd_chassis_ty = derivative.zdd[Coordinate::chassis_ty];
  const double zdd_chassis_tx = derivative.zdd[Coordinate::chassis_tx];
  const double s7_2 = fma(zdd_chassis_tx, R_chassis_x_x, zdd_chassis_ty*R_chassis_aux5_y_x);
  work.a_chassis_x = fma(R_chassis_z_x, s7_1, s7_2);
  const double s7_3 = fma(zdd_chassis_ty, R_chassis_y_y, zdd_chassis_tx*R_chassis_x_y);
  work.a_chassis_y = fma(R_chassis_z_y, s7_1, s7_3);
  const double s7_4 = fma(zdd_chassis_ty, R_chassis_y_z, zdd_chassis_tx*R_chassis_x_z);
  work.a_chassis_z = fma(R_chassis_z_z, s7_1, s7_4);
  const double zdd_chassis_rz = derivative.zdd[Coordinate::chassis_rz];
  const double s7_5 = fnma(zdd_chassis_rz, s1_3, derivative.zdd[Coordinate::chassis_rx]);
  work.alpha_chassis_x = fnma(s4_2, s4_5, fnma(s4_3, s4_4, s7_5));
  const double zdd_chassis_ry = derivative.zdd[Coordinate::chassis_ry];
  const double s7_6 = fnma(s4_1, s4_5, fma(zdd_chassis_ry, s1_9, zdd_chassis_rz*s1_7));
  work.alpha_chassis_y = fma(zd_chassis_rx, work.w_chassis_z, s7_6);
  const double s7_7 = fnma(s4_1, s4_3, fnma(zdd_chassis_ry, s1_6, zdd_chassis_rz*s1_11));
  work.alpha_chassis_z = fnma(zd_chassis_rx, work.w_chassis_y, s7_7);
  const double s7_8 = work.w_chassis_y*work.w_chassis_y;
  work.s7_9 = work.w_chassis_z*work.w_chassis_z;
  work.s7_10 = work.w_chassis_x*work.w_chassis_x;
  work.s7_11 = s7_8 + work.s7_10;
  work.s7_12 = s7_8 + work.s7_9;
  work.s7_13 = work.s7_9 + work.s7_10;
  work.s7_14 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_chassis_x);
  work.s7_15 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_chassis_x);
  work.s7_16 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_chassis_y);
  work.s7_17 = fma(work.w_chassis_x, work.w_chassis_y, work.alpha_chassis_z);
  work.s7_18 = fms(work.w_chassis_x, work.w_chassis_y, work.alpha_chassis_z);
  work.s7_19 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_chassis_y);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_20 = fnma(p_lower_arm_left_z, work.s7_16, p_lower_arm_left_x*work.s7_12);
  work.s7_21 = fma(p_lower_arm_left_y, work.s7_18, work.a_chassis_x);
  const double a_lower_arm_left_x = work.s7_21 - s7_20;
  const double s7_22 = fma(p_lower_arm_left_z, work.s7_14, work.a_chassis_y);
  const double s7_23 = fma(p_lower_arm_left_x, work.s7_17, s7_22);
  work.a_lower_arm_left_y = fnma(p_lower_arm_left_y, work.s7_13, s7_23);
  const double s7_24 = p_lower_arm_left_x*work.s7_19;
  const double s7_25 = fnma(p_lower_arm_left_z, work.s7_11, s7_24);
  work.s7_26 = fma(p_lower_arm_left_y, work.s7_15, work.a_chassis_z);
  work.a_lower_arm_left_z = s7_25 + work.s7_26;
  work.alpha_lower_arm_left_x = derivative.zdd[Coordinate::lower_arm_left] + work.alpha_chassis_x;
  const double alpha_lower_arm_left_y = fma(zd_lower_arm_left, work.w_chassis_z,
      work.alpha_chassis_y);
  const double alpha_lower_arm_left_z = fnma(zd_lower_arm_left, work.w_chassis_y,
      work.alpha_chassis_z);
  work.s7_27 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_left_x);
  work.s7_28 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_left_x);
  work.s7_29 = fma(w_lower_arm_left_x, w_lower_arm_left_x, s7_8);
  work.s7_30 = fma(w_lower_arm_left_x, w_lower_arm_left_x, work.s7_9);
  const double s7_31 = fma(work.w_chassis_z, w_lower_arm_left_x, alpha_lower_arm_left_y);
  const double s7_32 = fms(work.w_chassis_y, w_lower_arm_left_x, alpha_lower_arm_left_z);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  work.a_carrier_left_aux1_x = fma(work.s1_18, s7_32, fma(work.s1_20, s7_31, a_lower_arm_left_x));
  const double s7_33 = fma(work.s1_20, work.s7_28, work.a_lower_arm_left_y);
  work.a_carrier_left_aux1_y = fnma(work.s1_18, work.s7_30, s7_33);
  const double s7_34 = fma(work.s1_18, work.s7_27, work.a_lower_arm_left_z);
  work.a_carrier_left_aux1_z = fnma(work.s1_20, work.s7_29, s7_34);
  const double s7_35 = fnma(work.w_chassis_z, s4_6, work.w_chassis_y*s4_7);
  const double alpha_carrier_left_aux1_x = work.alpha_lower_arm_left_x + s7_35;
  const double zdd_carrier_left_rz = derivative.zdd[Coordinate::carrier_left_rz];
  const double s7_36 = zdd_carrier_left_rz*work.R_carrier_left_aux1_y_z;
  const double alpha_carrier_left_aux1_y = alpha_lower_arm_left_y + fnma(w_lower_arm_left_x, s4_7,
      s7_36);
  const double s7_37 = zdd_carrier_left_rz*work.R_carrier_left_aux1_z_z;
  const double alpha_carrier_left_aux1_z = alpha_lower_arm_left_z + fma(w_lower_arm_left_x, s4_6,
      s7_37);
  const double zdd_carrier_left_rx = derivative.zdd[Coordinate::carrier_left_rx];
  const double s7_38 = zdd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double s7_39 = fnma(w_carrier_left_aux1_z, s4_9, s7_38);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double alpha_carrier_left_aux2_x = alpha_carrier_left_aux1_x + fma(w_carrier_left_aux1_y,
      s4_10, s7_39);
  const double s7_40 = zdd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  const double s7_41 = fnma(w_lower_arm_left_x, s4_10, fma(w_carrier_left_aux1_z, s4_8, s7_40));
  const double alpha_carrier_left_aux2_y = alpha_carrier_left_aux1_y + s7_41;
  const double s7_42 = zdd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double s7_43 = fma(w_lower_arm_left_x, s4_9, fnma(w_carrier_left_aux1_y, s4_8, s7_42));
  const double alpha_carrier_left_aux2_z = alpha_carrier_left_aux1_z + s7_43;
  const double zdd_carrier_left_ry = derivative.zdd[Coordinate::carrier_left_ry];
  const double s7_44 = fnma(zdd_carrier_left_ry, work.s1_22, w_carrier_left_aux2_y*s4_13);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.alpha_carrier_left_x = alpha_carrier_left_aux2_x + fnma(w_carrier_left_aux2_z, s4_12, s7_44);
  const double s7_45 = zdd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  const double s7_46 = fnma(w_carrier_left_aux2_z, s4_11, s7_45);
  work.alpha_carrier_left_y = alpha_carrier_left_aux2_y + fnma(w_carrier_left_aux2_x, s4_13, s7_46);
  const double s7_47 = zdd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  const double s7_48 = fma(w_carrier_left_aux2_y, s4_11, s7_47);
  work.alpha_carrier_left_z = alpha_carrier_left_aux2_z + fma(w_carrier_left_aux2_x, s4_12, s7_48);
  const double s7_49 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s7_50 = work.w_carrier_left_z*work.w_carrier_left_z;
  work.s7_51 = s7_49 + s7_50;
  work.s7_52 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s7_49);
  work.s7_53 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s7_50);
  work.s7_54 = fma(work.w_carrier_left_x, work.w_carrier_left_y, work.alpha_carrier_left_z);
  work.s7_55 = fma(work.w_carrier_left_x, work.w_carrier_left_z, work.alpha_carrier_left_y);
  work.s7_56 = fma(work.w_carrier_left_y, work.w_carrier_left_z, work.alpha_carrier_left_x);
  work.s7_57 = fms(work.w_carrier_left_x, work.w_carrier_left_y, work.alpha_carrier_left_z);
  work.s7_58 = fms(work.w_carrier_left_x, work.w_carrier_left_z, work.alpha_carrier_left_y);
  work.s7_59 = fms(work.w_carrier_left_y, work.w_carrier_left_z, work.alpha_carrier_left_x);
  const double s7_60 = fnma(work.s1_27, work.s7_51, work.a_carrier_left_aux1_x);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  work.a_wheel_front_left_x = fma(work.s1_29, work.s7_57, fma(work.s1_31, work.s7_55, s7_60));
  const double s7_61 = fnma(work.s1_29, work.s7_53, work.a_carrier_left_aux1_y);
  work.a_wheel_front_left_y = fma(work.s1_31, work.s7_59, fma(work.s1_27, work.s7_54, s7_61));
  const double s7_62 = fnma(work.s1_31, work.s7_52, work.a_carrier_left_aux1_z);
  work.a_wheel_front_left_z = fma(work.s1_27, work.s7_58, fma(work.s1_29, work.s7_56, s7_62));
  const double zdd_wheel_front_left = derivative.zdd[Coordinate::wheel_front_left];
  const double s7_63 = fnma(zdd_wheel_front_left, work.s1_22, work.w_carrier_left_y*s4_16);
  work.alpha_wheel_front_left_x = work.alpha_carrier_left_x + fnma(work.w_carrier_left_z, s4_15,
      s7_63);
  const double s7_64 = zdd_wheel_front_left*work.R_carrier_left_aux2_y_y;
  const double s7_65 = fnma(work.w_carrier_left_z, s4_14, s7_64);
  work.alpha_wheel_front_left_y = work.alpha_carrier_left_y + fnma(work.w_carrier_left_x, s4_16,
      s7_65);
  const double s7_66 = zdd_wheel_front_left*work.R_carrier_left_aux2_z_y;
  const double s7_67 = fma(work.w_carrier_left_y, s4_14, s7_66);
  work.alpha_wheel_front_left_z = work.alpha_carrier_left_z + fma(work.w_carrier_left_x, s4_15,
      s7_67);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_68 = fma(p_upper_arm_left_z, work.s7_14, work.a_chassis_y);
  const double s7_69 = fma(p_lower_arm_left_x, work.s7_17, s7_68);
  work.a_upper_arm_left_y = fnma(p_upper_arm_left_y, work.s7_13, s7_69);
  const double s7_70 = fnma(p_upper_arm_left_z, work.s7_11, s7_24);
  work.a_upper_arm_left_z = s7_70 + fma(p_upper_arm_left_y, work.s7_15, work.a_chassis_z);
  work.alpha_upper_arm_left_x = derivative.zdd[Coordinate::upper_arm_left] + work.alpha_chassis_x;
  work.s7_71 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_left_x);
  work.s7_72 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_left_x);
  work.s7_73 = fma(w_upper_arm_left_x, w_upper_arm_left_x, s7_8);
  work.s7_74 = fma(w_upper_arm_left_x, w_upper_arm_left_x, work.s7_9);
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_75 = -p_arb_front_left_z*work.s7_16;
  const double s7_76 = fma(p_arb_front_left_x, work.s7_12, s7_75);
  work.a_arb_front_left_x = fma(p_arb_front_left_y, work.s7_18, work.a_chassis_x) - s7_76;
  const double s7_77 = fma(p_arb_front_left_x, work.s7_17, work.a_chassis_y);
  const double s7_78 = fma(p_arb_front_left_z, work.s7_14, s7_77);
  work.a_arb_front_left_y = fnma(p_arb_front_left_y, work.s7_13, s7_78);
  const double s7_79 = -p_arb_front_left_z*work.s7_11;
  const double s7_80 = fma(p_arb_front_left_x, work.s7_19, s7_79);
  work.a_arb_front_left_z = s7_80 + fma(p_arb_front_left_y, work.s7_15, work.a_chassis_z);
  work.alpha_arb_front_left_x = fnma(zd_arb_front_left, work.w_chassis_z, work.alpha_chassis_x);
  work.alpha_arb_front_left_y = derivative.zdd[Coordinate::arb_front_left] + work.alpha_chassis_y;
  work.alpha_arb_front_left_z = fma(zd_arb_front_left, work.w_chassis_x, work.alpha_chassis_z);
  work.s7_81 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_left_y);
  work.s7_82 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_left_y);
  work.s7_83 = fma(work.w_arb_front_left_y, work.w_arb_front_left_y, work.s7_10);
  work.s7_84 = fma(work.w_arb_front_left_y, work.w_arb_front_left_y, work.s7_9);
  work.s7_85 = fma(work.w_chassis_x, work.w_arb_front_left_y, work.alpha_arb_front_left_z);
  work.s7_86 = fma(work.w_chassis_z, work.w_arb_front_left_y, work.alpha_arb_front_left_x);
  work.s7_87 = fms(work.w_chassis_x, work.w_arb_front_left_y, work.alpha_arb_front_left_z);
  work.s7_88 = fms(work.w_chassis_z, work.w_arb_front_left_y, work.alpha_arb_front_left_x);
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s7_89 = fnma(p_lower_arm_left_y, work.s7_18, work.a_chassis_x);
  const double a_lower_arm_right_x = work.s7_89 - s7_20;
  work.a_lower_arm_right_y = fma(p_lower_arm_left_y, work.s7_13, s7_23);
  work.s7_90 = fnma(p_lower_arm_left_y, work.s7_15, work.a_chassis_z);
  work.a_lower_arm_right_z = s7_25 + work.s7_90;
  work.alpha_lower_arm_right_x = derivative.zdd[Coordinate::lower_arm_right] + work.alpha_chassis_x;
  const double alpha_lower_arm_right_y = fma(zd_lower_arm_right, work.w_chassis_z,
      work.alpha_chassis_y);
  const double alpha_lower_arm_right_z = fnma(zd_lower_arm_right, work.w_chassis_y,
      work.alpha_chassis_z);
  work.s7_91 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_right_x);
  work.s7_92 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_right_x);
  work.s7_93 = fma(w_lower_arm_right_x, w_lower_arm_right_x, s7_8);
  work.s7_94 = fma(w_lower_arm_right_x, w_lower_arm_right_x, work.s7_9);
  const double s7_95 = fma(work.w_chassis_z, w_lower_arm_right_x, alpha_lower_arm_right_y);
  const double s7_96 = fms(work.w_chassis_y, w_lower_arm_right_x, alpha_lower_arm_right_z);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  work.a_carrier_right_aux1_x = fma(work.s1_36, s7_96, fnma(work.s1_38, s7_95,
      a_lower_arm_right_x));
  const double s7_97 = fnma(work.s1_38, work.s7_92, work.a_lower_arm_right_y);
  work.a_carrier_right_aux1_y = fnma(work.s1_36, work.s7_94, s7_97);
  const double s7_98 = fma(work.s1_36, work.s7_91, work.a_lower_arm_right_z);
  work.a_carrier_right_aux1_z = fma(work.s1_38, work.s7_93, s7_98);
  const double s7_99 = fnma(work.w_chassis_z, s4_17, work.w_chassis_y*s4_18);
  const double alpha_carrier_right_aux1_x = work.alpha_lower_arm_right_x + s7_99;
  const double zdd_carrier_right_rz = derivative.zdd[Coordinate::carrier_right_rz];
  const double s7_100 = zdd_carrier_right_rz*work.R_carrier_right_aux1_y_z;
  const double alpha_carrier_right_aux1_y = alpha_lower_arm_right_y + fnma(w_lower_arm_right_x,
      s4_18, s7_100);
  const double s7_101 = zdd_carrier_right_rz*work.R_carrier_right_aux1_z_z;
  const double alpha_carrier_right_aux1_z = alpha_lower_arm_right_z + fma(w_lower_arm_right_x,
      s4_17, s7_101);
  const double zdd_carrier_right_rx = derivative.zdd[Coordinate::carrier_right_rx];
  const double s7_102 = zdd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double s7_103 = fnma(w_carrier_right_aux1_z, s4_20, s7_102);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double alpha_carrier_right_aux2_x = alpha_carrier_right_aux1_x + fma(w_carrier_right_aux1_y,
      s4_21, s7_103);
  const double s7_104 = zdd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  const double s7_105 = fma(w_carrier_right_aux1_z, s4_19, s7_104);
  const double alpha_carrier_right_aux2_y = alpha_carrier_right_aux1_y + fnma(w_lower_arm_right_x,
      s4_21, s7_105);
  const double s7_106 = zdd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double s7_107 = fnma(w_carrier_right_aux1_y, s4_19, s7_106);
  const double alpha_carrier_right_aux2_z = alpha_carrier_right_aux1_z + fma(w_lower_arm_right_x,
      s4_20, s7_107);
  const double zdd_carrier_right_ry = derivative.zdd[Coordinate::carrier_right_ry];
  const double s7_108 = fnma(zdd_carrier_right_ry, work.s1_41, w_carrier_right_aux2_y*s4_24);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.alpha_carrier_right_x = alpha_carrier_right_aux2_x + fnma(w_carrier_right_aux2_z, s4_23,
      s7_108);
  const double s7_109 = zdd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  const double s7_110 = fnma(w_carrier_right_aux2_z, s4_22, s7_109);
  work.alpha_carrier_right_y = alpha_carrier_right_aux2_y + fnma(w_carrier_right_aux2_x, s4_24,
      s7_110);
  const double s7_111 = zdd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  const double s7_112 = fma(w_carrier_right_aux2_y, s4_22, s7_111);
  work.alpha_carrier_right_z = alpha_carrier_right_aux2_z + fma(w_carrier_right_aux2_x, s4_23,
      s7_112);
  const double s7_113 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s7_114 = work.w_carrier_right_z*work.w_carrier_right_z;
  work.s7_115 = s7_113 + s7_114;
  work.s7_116 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s7_113);
  work.s7_117 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s7_114);
  work.s7_118 = fma(work.w_carrier_right_x, work.w_carrier_right_y, work.alpha_carrier_right_z);
  work.s7_119 = fma(work.w_carrier_right_x, work.w_carrier_right_z, work.alpha_carrier_right_y);
  work.s7_120 = fma(work.w_carrier_right_y, work.w_carrier_right_z, work.alpha_carrier_right_x);
  work.s7_121 = fms(work.w_carrier_right_x, work.w_carrier_right_y, work.alpha_carrier_right_z);
  work.s7_122 = fms(work.w_carrier_right_x, work.w_carrier_right_z, work.alpha_carrier_right_y);
  work.s7_123 = fms(work.w_carrier_right_y, work.w_carrier_right_z, work.alpha_carrier_right_x);
  const double s7_124 = fnma(work.s1_54, work.s7_115, work.a_carrier_right_aux1_x);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  work.a_wheel_front_right_x = fma(work.s1_56, work.s7_121, fma(work.s1_58, work.s7_119, s7_124));
  const double s7_125 = fnma(work.s1_56, work.s7_117, work.a_carrier_right_aux1_y);
  work.a_wheel_front_right_y = fma(work.s1_58, work.s7_123, fma(work.s1_54, work.s7_118, s7_125));
  const double s7_126 = fnma(work.s1_58, work.s7_116, work.a_carrier_right_aux1_z);
  work.a_wheel_front_right_z = fma(work.s1_54, work.s7_122, fma(work.s1_56, work.s7_120, s7_126));
  const double zdd_wheel_front_right = derivative.zdd[Coordinate::wheel_front_right];
  const double s7_127 = fnma(zdd_wheel_front_right, work.s1_41, work.w_carrier_right_y*s4_27);
  work.alpha_wheel_front_right_x = work.alpha_carrier_right_x + fnma(work.w_carrier_right_z, s4_26,
      s7_127);
  const double s7_128 = zdd_wheel_front_right*work.R_carrier_right_aux2_y_y;
  const double s7_129 = fnma(work.w_carrier_right_z, s4_25, s7_128);
  work.alpha_wheel_front_right_y = work.alpha_carrier_right_y + fnma(work.w_carrier_right_x, s4_27,
      s7_129);
  const double s7_130 = zdd_wheel_front_right*work.R_carrier_right_aux2_z_y;
  const double s7_131 = fma(work.w_carrier_right_y, s4_25, s7_130);
  work.alpha_wheel_front_right_z = work.alpha_carrier_right_z + fma(work.w_carrier_right_x, s4_26,
      s7_131);
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.a_upper_arm_right_y = fma(p_upper_arm_left_y, work.s7_13, s7_69);
  work.a_upper_arm_right_z = s7_70 + fnma(p_upper_arm_left_y, work.s7_15, work.a_chassis_z);
  work.alpha_upper_arm_right_x = derivative.zdd[Coordinate::upper_arm_right] + work.alpha_chassis_x;
  work.s7_132 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_right_x);
  work.s7_133 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_right_x);
  work.s7_134 = fma(w_upper_arm_right_x, w_upper_arm_right_x, s7_8);
  work.s7_135 = fma(w_upper_arm_right_x, w_upper_arm_right_x, work.s7_9);
  // arb_front_right: arb_front_right, revolute, chassis
  work.a_arb_front_right_x = fnma(p_arb_front_left_y, work.s7_18, work.a_chassis_x) - s7_76;
  work.a_arb_front_right_y = fma(p_arb_front_left_y, work.s7_13, s7_78);
  work.a_arb_front_right_z = s7_80 + fnma(p_arb_front_left_y, work.s7_15, work.a_chassis_z);
  work.alpha_arb_front_right_x = fnma(zd_arb_front_right, work.w_chassis_z, work.alpha_chassis_x);
  work.alpha_arb_front_right_y = derivative.zdd[Coordinate::arb_front_right] + work.alpha_chassis_y;
  work.alpha_arb_front_right_z = fma(zd_arb_front_right, work.w_chassis_x, work.alpha_chassis_z);
  work.s7_136 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_right_y);
  work.s7_137 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_right_y);
  work.s7_138 = fma(work.w_arb_front_right_y, work.w_arb_front_right_y, work.s7_10);
  work.s7_139 = fma(work.w_arb_front_right_y, work.w_arb_front_right_y, work.s7_9);
  work.s7_140 = fma(work.w_chassis_x, work.w_arb_front_right_y, work.alpha_arb_front_right_z);
  work.s7_141 = fma(work.w_chassis_z, work.w_arb_front_right_y, work.alpha_arb_front_right_x);
  work.s7_142 = fms(work.w_chassis_x, work.w_arb_front_right_y, work.alpha_arb_front_right_z);
  work.s7_143 = fms(work.w_chassis_z, work.w_arb_front_right_y, work.alpha_arb_front_right_x);
  const double s7_144 = fnma(p_pitman_arm_x, work.s7_12, work.a_chassis_x);
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_145 = fma(p_pitman_arm_z, work.s7_16, s7_144);
  work.a_pitman_arm_x = fma(p_upper_arm_left_y, work.s7_18, s7_145);
  const double s7_146 = fma(p_pitman_arm_z, work.s7_14, work.a_chassis_y);
  const double s7_147 = fma(p_pitman_arm_x, work.s7_17, s7_146);
  work.a_pitman_arm_y = fnma(p_upper_arm_left_y, work.s7_13, s7_147);
  const double s7_148 = fnma(p_pitman_arm_z, work.s7_11, work.a_chassis_z);
  const double s7_149 = fma(p_pitman_arm_x, work.s7_19, s7_148);
  work.a_pitman_arm_z = fma(p_upper_arm_left_y, work.s7_15, s7_149);
  const double alpha_pitman_arm_x = fnma(zd_pitman_arm, work.w_chassis_z, work.alpha_chassis_x);
  work.alpha_pitman_arm_y = derivative.zdd[Coordinate::pitman_arm] + work.alpha_chassis_y;
  const double alpha_pitman_arm_z = fma(zd_pitman_arm, work.w_chassis_x, work.alpha_chassis_z);
  work.s7_150 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_pitman_arm_y);
  work.s7_151 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_pitman_arm_y);
  work.s7_152 = fma(w_pitman_arm_y, w_pitman_arm_y, work.s7_10);
  work.s7_153 = fma(w_pitman_arm_y, w_pitman_arm_y, work.s7_9);
  work.s7_154 = fma(work.w_chassis_x, w_pitman_arm_y, alpha_pitman_arm_z);
  work.s7_155 = fms(work.w_chassis_z, w_pitman_arm_y, alpha_pitman_arm_x);
  // bell_crank: bell_crank, revolute, chassis
  const double s7_156 = fnma(p_bell_crank_x, work.s7_12, work.a_chassis_x);
  work.a_bell_crank_x = fma(p_bell_crank_z, work.s7_16, s7_156);
  const double s7_157 = fma(p_bell_crank_z, work.s7_14, work.a_chassis_y);
  work.a_bell_crank_y = fma(p_bell_crank_x, work.s7_17, s7_157);
  const double s7_158 = fnma(p_bell_crank_z, work.s7_11, work.a_chassis_z);
  work.a_bell_crank_z = fma(p_bell_crank_x, work.s7_19, s7_158);
  const double alpha_bell_crank_x = fma(zd_bell_crank, work.w_chassis_y, work.alpha_chassis_x);
  const double alpha_bell_crank_y = fnma(zd_bell_crank, work.w_chassis_x, work.alpha_chassis_y);
  work.alpha_bell_crank_z = derivative.zdd[Coordinate::bell_crank] + work.alpha_chassis_z;
  work.s7_159 = fma(work.w_chassis_x, work.w_chassis_y, work.alpha_bell_crank_z);
  work.s7_160 = fms(work.w_chassis_x, work.w_chassis_y, work.alpha_bell_crank_z);
  work.s7_161 = fma(w_bell_crank_z, w_bell_crank_z, s7_8);
  work.s7_162 = fma(w_bell_crank_z, w_bell_crank_z, work.s7_10);
  work.s7_163 = fma(work.w_chassis_y, w_bell_crank_z, alpha_bell_crank_x);
  work.s7_164 = fms(work.w_chassis_x, w_bell_crank_z, alpha_bell_crank_y);
  const double s7_165 = derivative.zdd[Coordinate::rear_axle_tx] + work.a_chassis_x;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double a_rear_axle_aux1_x = fnma(work.r_rear_axle_aux1_x, work.s7_12, s7_165) - s7_75;
  const double s7_166 = fma(work.r_rear_axle_aux1_x, work.s7_17, work.a_chassis_y);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s7_167 = fma(p_arb_front_left_z, work.s7_14, s7_166);
  const double s7_168 = fma(zd_rear_axle_tx, work.w_chassis_z, s7_167);
  const double a_rear_axle_aux1_y = fma(zd_rear_axle_tx, work.w_chassis_z, s7_168);
  const double s7_169 = s7_79 + fma(work.r_rear_axle_aux1_x, work.s7_19, work.a_chassis_z);
  const double s7_170 = fnma(zd_rear_axle_tx, work.w_chassis_y, s7_169);
  const double a_rear_axle_aux1_z = fnma(zd_rear_axle_tx, work.w_chassis_y, s7_170);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s7_171 = fma(z_rear_axle_ty, work.s7_18, a_rear_axle_aux1_x);
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double s7_172 = fnma(zd_rear_axle_ty, work.w_chassis_z, s7_171);
  const double a_rear_axle_aux2_x = fnma(zd_rear_axle_ty, work.w_chassis_z, s7_172);
  const double s7_173 = fnma(z_rear_axle_ty, work.s7_13, derivative.zdd[Coordinate::rear_axle_ty]);
  const double a_rear_axle_aux2_y = a_rear_axle_aux1_y + s7_173;
  const double s7_174 = fma(z_rear_axle_ty, work.s7_15, a_rear_axle_aux1_z);
  const double s7_175 = fma(zd_rear_axle_ty, work.w_chassis_x, s7_174);
  const double a_rear_axle_aux2_z = fma(zd_rear_axle_ty, work.w_chassis_x, s7_175);
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s7_176 = fma(z_rear_axle_tz, work.s7_16, a_rear_axle_aux2_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double s7_177 = fma(zd_rear_axle_tz, work.w_chassis_y, s7_176);
  work.a_rear_axle_aux3_x = fma(zd_rear_axle_tz, work.w_chassis_y, s7_177);
  const double s7_178 = fma(z_rear_axle_tz, work.s7_14, a_rear_axle_aux2_y);
  const double s7_179 = fnma(zd_rear_axle_tz, work.w_chassis_x, s7_178);
  work.a_rear_axle_aux3_y = fnma(zd_rear_axle_tz, work.w_chassis_x, s7_179);
  const double s7_180 = fnma(z_rear_axle_tz, work.s7_11, derivative.zdd[Coordinate::rear_axle_tz]);
  work.a_rear_axle_aux3_z = a_rear_axle_aux2_z + s7_180;
  const double zdd_rear_axle_rz = derivative.zdd[Coordinate::rear_axle_rz];
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s7_181 = fma(work.w_chassis_y, s4_29, zdd_rear_axle_rz*work.R_rear_axle_aux4_x_z);
  const double alpha_rear_axle_aux4_x = work.alpha_chassis_x + s7_181;
  const double s7_182 = fnma(work.w_chassis_x, s4_29, work.w_chassis_z*s4_28);
  const double alpha_rear_axle_aux4_y = work.alpha_chassis_y + s7_182;
  const double s7_183 = zdd_rear_axle_rz*work.R_rear_axle_aux4_z_z;
  const double alpha_rear_axle_aux4_z = work.alpha_chassis_z + fnma(work.w_chassis_y, s4_28,
      s7_183);
  const double zdd_rear_axle_ry = derivative.zdd[Coordinate::rear_axle_ry];
  const double s7_184 = fnma(zdd_rear_axle_ry, work.s1_60, alpha_rear_axle_aux4_x);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double alpha_rear_axle_aux5_x = fnma(work.w_chassis_y, s4_32, fnma(w_rear_axle_aux4_z,
      s4_31, s7_184));
  const double s7_185 = fnma(w_rear_axle_aux4_z, s4_30, zdd_rear_axle_ry*R_rear_axle_aux4_y_y);
  const double alpha_rear_axle_aux5_y = alpha_rear_axle_aux4_y + fma(w_rear_axle_aux4_x, s4_32,
      s7_185);
  const double s7_186 = fnma(zdd_rear_axle_ry, work.s1_62, work.w_chassis_y*s4_30);
  const double alpha_rear_axle_aux5_z = alpha_rear_axle_aux4_z + fma(w_rear_axle_aux4_x, s4_31,
      s7_186);
  const double zdd_rear_axle_rx = derivative.zdd[Coordinate::rear_axle_rx];
  const double s7_187 = zdd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_188 = fma(w_rear_axle_aux5_y, s4_35, fnma(w_rear_axle_aux5_z, s4_34, s7_187));
  work.alpha_rear_axle_x = alpha_rear_axle_aux5_x + s7_188;
  const double s7_189 = zdd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  const double s7_190 = fnma(w_rear_axle_aux5_x, s4_35, fma(w_rear_axle_aux5_z, s4_33, s7_189));
  work.alpha_rear_axle_y = alpha_rear_axle_aux5_y + s7_190;
  const double s7_191 = zdd_rear_axle_rx*work.R_rear_axle_aux5_z_x;
  const double s7_192 = fma(w_rear_axle_aux5_x, s4_34, fnma(w_rear_axle_aux5_y, s4_33, s7_191));
  work.alpha_rear_axle_z = alpha_rear_axle_aux5_z + s7_192;
  const double s7_193 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s7_194 = work.w_rear_axle_x*work.w_rear_axle_x;
  work.s7_195 = s7_193 + s7_194;
  work.s7_196 = fma(work.w_rear_axle_z, work.w_rear_axle_z, s7_193);
  work.s7_197 = fma(work.w_rear_axle_z, work.w_rear_axle_z, s7_194);
  work.s7_198 = fma(work.w_rear_axle_x, work.w_rear_axle_y, work.alpha_rear_axle_z);
}

/// Part 2 of compute_multipliers: step 7: inertias of the bodies and forces on joints.
[[gnu::noinline]] void compute_multipliers_2(const State& state, const double* tau,
    const Derivative& derivative, ConstraintForcesWork& __restrict work,
    ConstraintForces& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_199 = fma(work.w_rear_axle_y, work.w_rear_axle_z, work.alpha_rear_axle_x);
  const double s7_200 = fma(work.w_rear_axle_x, work.w_rear_axle_z, work.alpha_rear_axle_y);
  const double s7_201 = fms(work.w_rear_axle_x, work.w_rear_axle_y, work.alpha_rear_axle_z);
  const double s7_202 = fms(work.w_rear_axle_y, work.w_rear_axle_z, work.alpha_rear_axle_x);
  const double s7_203 = fms(work.w_rear_axle_x, work.w_rear_axle_z, work.alpha_rear_axle_y);
  const double s7_204 = fma(work.s1_68, s7_201, work.a_rear_axle_aux3_x);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double a_wheel_rear_left_x = fnma(work.s1_67, work.s7_196, fma(work.s1_69, s7_200, s7_204));
  const double s7_205 = fma(work.s1_69, s7_202, work.s1_67*work.s7_198);
  const double a_wheel_rear_left_y = fnma(work.s1_68, work.s7_197,
      work.a_rear_axle_aux3_y + s7_205);
  const double s7_206 = fma(work.s1_68, s7_199, work.a_rear_axle_aux3_z);
  const double a_wheel_rear_left_z = fnma(work.s1_69, work.s7_195, fma(work.s1_67, s7_203, s7_206));
  const double zdd_wheel_rear_left = derivative.zdd[Coordinate::wheel_rear_left];
  const double s7_207 = zdd_wheel_rear_left*work.R_rear_axle_x_y;
  const double s7_208 = fnma(work.w_rear_axle_z, work.s4_37, s7_207);
  const double alpha_wheel_rear_left_x = work.alpha_rear_axle_x + fma(work.w_rear_axle_y,
      work.s4_38, s7_208);
  const double s7_209 = zdd_wheel_rear_left*work.R_rear_axle_y_y;
  const double s7_210 = fma(work.w_rear_axle_z, work.s4_36, s7_209);
  const double alpha_wheel_rear_left_y = work.alpha_rear_axle_y + fnma(work.w_rear_axle_x,
      work.s4_38, s7_210);
  const double s7_211 = zdd_wheel_rear_left*work.R_rear_axle_z_y;
  const double s7_212 = fnma(work.w_rear_axle_y, work.s4_36, s7_211);
  const double alpha_wheel_rear_left_z = work.alpha_rear_axle_z + fma(work.w_rear_axle_x,
      work.s4_37, s7_212);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_213 = fma(p_arb_rear_left_z, work.s7_16, -p_arb_rear_left_x*work.s7_12);
  const double a_arb_rear_left_x = s7_213 + fma(p_arb_rear_left_y, work.s7_18, work.a_chassis_x);
  const double s7_214 = fnma(p_arb_rear_left_x, work.s7_17, -p_arb_rear_left_z*work.s7_14);
  const double a_arb_rear_left_y = fnma(p_arb_rear_left_y, work.s7_13, work.a_chassis_y) - s7_214;
  const double s7_215 = fma(p_arb_rear_left_x, work.s7_19, -p_arb_rear_left_z*work.s7_11);
  const double a_arb_rear_left_z = s7_215 + fma(p_arb_rear_left_y, work.s7_15, work.a_chassis_z);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double alpha_arb_rear_left_x = fnma(zd_arb_rear_left, work.w_chassis_z,
      work.alpha_chassis_x);
  const double alpha_arb_rear_left_y = derivative.zdd[Coordinate::arb_rear_left] +
      work.alpha_chassis_y;
  const double alpha_arb_rear_left_z = fma(zd_arb_rear_left, work.w_chassis_x,
      work.alpha_chassis_z);
  const double s7_216 = fma(work.w_chassis_x, work.w_chassis_z, alpha_arb_rear_left_y);
  const double s7_217 = fms(work.w_chassis_x, work.w_chassis_z, alpha_arb_rear_left_y);
  const double s7_218 = fma(work.w_arb_rear_left_y, work.w_arb_rear_left_y, work.s7_10);
  const double s7_219 = fma(work.w_arb_rear_left_y, work.w_arb_rear_left_y, work.s7_9);
  const double s7_220 = fma(work.w_chassis_x, work.w_arb_rear_left_y, alpha_arb_rear_left_z);
  const double s7_221 = fma(work.w_chassis_z, work.w_arb_rear_left_y, alpha_arb_rear_left_x);
  const double s7_222 = fms(work.w_chassis_x, work.w_arb_rear_left_y, alpha_arb_rear_left_z);
  const double s7_223 = fms(work.w_chassis_z, work.w_arb_rear_left_y, alpha_arb_rear_left_x);
  const double s7_224 = fnma(work.s1_68, s7_201, work.a_rear_axle_aux3_x);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double a_wheel_rear_right_x = fma(work.s1_67, work.s7_196, fnma(work.s1_69, s7_200,
      s7_224));
  const double a_wheel_rear_right_y = fma(work.s1_68, work.s7_197,
      work.a_rear_axle_aux3_y - s7_205);
  const double s7_225 = fnma(work.s1_68, s7_199, work.a_rear_axle_aux3_z);
  const double a_wheel_rear_right_z = fma(work.s1_69, work.s7_195, fnma(work.s1_67, s7_203,
      s7_225));
  const double zdd_wheel_rear_right = derivative.zdd[Coordinate::wheel_rear_right];
  const double s7_226 = zdd_wheel_rear_right*work.R_rear_axle_x_y;
  const double s7_227 = fnma(work.w_rear_axle_z, work.s4_40, s7_226);
  const double alpha_wheel_rear_right_x = work.alpha_rear_axle_x + fma(work.w_rear_axle_y,
      work.s4_41, s7_227);
  const double s7_228 = zdd_wheel_rear_right*work.R_rear_axle_y_y;
  const double s7_229 = fma(work.w_rear_axle_z, work.s4_39, s7_228);
  const double alpha_wheel_rear_right_y = work.alpha_rear_axle_y + fnma(work.w_rear_axle_x,
      work.s4_41, s7_229);
  const double s7_230 = zdd_wheel_rear_right*work.R_rear_axle_z_y;
  const double s7_231 = fnma(work.w_rear_axle_y, work.s4_39, s7_230);
  const double alpha_wheel_rear_right_z = work.alpha_rear_axle_z + fma(work.w_rear_axle_x,
      work.s4_40, s7_231);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double a_arb_rear_right_x = s7_213 + fnma(p_arb_rear_left_y, work.s7_18, work.a_chassis_x);
  const double a_arb_rear_right_y = fma(p_arb_rear_left_y, work.s7_13, work.a_chassis_y) - s7_214;
  const double a_arb_rear_right_z = s7_215 + fnma(p_arb_rear_left_y, work.s7_15, work.a_chassis_z);
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double alpha_arb_rear_right_x = fnma(zd_arb_rear_right, work.w_chassis_z,
      work.alpha_chassis_x);
  const double alpha_arb_rear_right_y = derivative.zdd[Coordinate::arb_rear_right] +
      work.alpha_chassis_y;
  const double alpha_arb_rear_right_z = fma(zd_arb_rear_right, work.w_chassis_x,
      work.alpha_chassis_z);
  const double s7_232 = fma(work.w_chassis_x, work.w_chassis_z, alpha_arb_rear_right_y);
  const double s7_233 = fms(work.w_chassis_x, work.w_chassis_z, alpha_arb_rear_right_y);
  const double s7_234 = fma(work.w_arb_rear_right_y, work.w_arb_rear_right_y, work.s7_10);
  const double s7_235 = fma(work.w_arb_rear_right_y, work.w_arb_rear_right_y, work.s7_9);
  const double s7_236 = fma(work.w_chassis_x, work.w_arb_rear_right_y, alpha_arb_rear_right_z);
  const double s7_237 = fma(work.w_chassis_z, work.w_arb_rear_right_y, alpha_arb_rear_right_x);
  const double s7_238 = fms(work.w_chassis_x, work.w_arb_rear_right_y, alpha_arb_rear_right_z);
  const double s7_239 = fms(work.w_chassis_z, work.w_arb_rear_right_y, alpha_arb_rear_right_x);
  const double R_arb_front_left_x_x = work.cosines[8];
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double s7_240 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  work.s7_241 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s7_240);
  const double s7_242 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s7_243 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s7_242);
  const double s7_244 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s7_245 = work.s1_22 + work.R_carrier_left_x_z;
  work.s7_246 = fnma(p_arb_link_front_left_to_y, s7_245, s7_244);
  const double s7_247 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s7_248 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s7_249 = fnma(p_arb_link_front_left_to_y, s7_247, s7_248);
  const double s7_250 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s7_251 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s7_252 = fnma(p_arb_link_front_left_to_y, s7_250, s7_251);
  const double s7_253 = fma(p_arb_link_front_left_from_y, work.s7_87, work.a_arb_front_left_x);
  const double s7_254 = fnma(work.s7_84, work.s7_243, fma(work.s7_81, work.s7_241, s7_253));
  work.s7_255 = 0.3333333333333333*s7_254;
  const double s7_256 = fma(p_arb_link_front_left_from_y, work.s7_86, work.a_arb_front_left_z);
  const double s7_257 = fma(work.s7_82, work.s7_243, fnma(work.s7_83, work.s7_241, s7_256));
  work.s7_258 = 0.3333333333333333*s7_257;
  const double s7_259 = fnma(p_arb_link_front_left_from_y, work.s7_13, work.a_arb_front_left_y);
  const double s7_260 = fma(work.s7_85, work.s7_243, fma(work.s7_88, work.s7_241, s7_259));
  work.s7_261 = 0.3333333333333333*s7_260;
  const double s7_262 = fnma(work.s7_51, work.s7_246, work.a_carrier_left_aux1_x);
  const double s7_263 = fma(work.s7_57, work.s7_252, fma(work.s7_55, work.s7_249, s7_262));
  work.s7_264 = 0.3333333333333333*s7_263;
  const double s7_265 = fma(work.s7_58, work.s7_246, work.a_carrier_left_aux1_z);
  const double s7_266 = fma(work.s7_56, work.s7_252, fnma(work.s7_52, work.s7_249, s7_265));
  work.s7_267 = 0.3333333333333333*s7_266;
  const double R_arb_front_right_x_x = work.cosines[14];
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double s7_268 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  work.s7_269 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s7_268);
  const double s7_270 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s7_271 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s7_270);
  const double s7_272 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s7_273 = work.R_carrier_right_x_z - work.s1_41;
  work.s7_274 = fnma(p_arb_link_front_left_to_y, s7_273, s7_272);
  const double s7_275 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s7_276 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s7_277 = fnma(p_arb_link_front_left_to_y, s7_275, s7_276);
  const double s7_278 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s7_279 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s7_280 = fnma(p_arb_link_front_left_to_y, s7_278, s7_279);
  const double s7_281 = fma(p_arb_link_front_right_from_y, work.s7_141, work.a_arb_front_right_z);
  const double s7_282 = fma(work.s7_137, work.s7_271, fnma(work.s7_138, work.s7_269, s7_281));
  work.s7_283 = 0.3333333333333333*s7_282;
  const double s7_284 = fma(p_arb_link_front_left_from_y, work.s7_13, work.a_arb_front_right_y);
  const double s7_285 = fma(work.s7_140, work.s7_271, fma(work.s7_143, work.s7_269, s7_284));
  work.s7_286 = 0.3333333333333333*s7_285;
  const double s7_287 = fma(p_arb_link_front_right_from_y, work.s7_142, work.a_arb_front_right_x);
  const double s7_288 = fnma(work.s7_139, work.s7_271, fma(work.s7_136, work.s7_269, s7_287));
  work.s7_289 = 0.3333333333333333*s7_288;
  const double s7_290 = fma(work.s7_122, work.s7_274, work.a_carrier_right_aux1_z);
  const double s7_291 = fma(work.s7_120, work.s7_280, fnma(work.s7_116, work.s7_277, s7_290));
  const double s7_292 = 0.3333333333333333*s7_291;
  const double s7_293 = fnma(work.s7_115, work.s7_274, work.a_carrier_right_aux1_x);
  const double s7_294 = fma(work.s7_121, work.s7_280, fma(work.s7_119, work.s7_277, s7_293));
  const double s7_295 = 0.3333333333333333*s7_294;
  // drag_link
  const double R_pitman_arm_x_z = work.sines[15];
  work.s7_296 = -p_drag_link_from_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s7_297 = -p_drag_link_from_z*R_pitman_arm_x_x;
  const double R_bell_crank_y_x = work.sines[16];
  work.s7_298 = p_drag_link_to_y*R_bell_crank_y_x;
  const double R_bell_crank_x_x = work.cosines[16];
  const double s7_299 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s7_300 = fma(work.s7_153, work.s7_296, work.a_pitman_arm_x);
  const double s7_301 = 1.5*fnma(work.s7_150, work.s7_297, s7_300);
  const double s7_302 = fnma(work.s7_164, work.s7_298, work.a_bell_crank_z);
  const double s7_303 = 1.5*fma(work.s7_163, s7_299, s7_302);
  const double s7_304 = fma(work.s7_161, work.s7_298, work.a_bell_crank_x);
  const double s7_305 = 1.5*fma(work.s7_160, s7_299, s7_304);
  const double s7_306 = fnma(work.s7_154, work.s7_296, work.a_pitman_arm_y);
  const double s7_307 = 1.5*fnma(work.s7_155, work.s7_297, s7_306);
  // tie_rod_left
  work.s7_308 = -p_tie_rod_left_to_y*work.R_carrier_left_aux2_z_y;
  work.s7_309 = -p_tie_rod_left_to_y*work.R_carrier_left_aux2_y_y;
  const double s7_310 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s7_311 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  work.s7_312 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s7_310);
  work.s7_313 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_311);
  work.s7_314 = -p_tie_rod_left_to_y*work.s1_22;
  const double s7_315 = p_tie_rod_left_to_z*work.R_carrier_left_x_z;
  work.s7_316 = work.s7_314 + fma(p_tie_rod_left_to_x, work.R_carrier_left_x_x, s7_315);
  const double s7_317 = p_tie_rod_left_to_z*work.R_carrier_left_z_z;
  work.s7_318 = fma(p_tie_rod_left_to_x, work.R_carrier_left_z_x, s7_317) - work.s7_308;
  const double s7_319 = p_tie_rod_left_to_z*work.R_carrier_left_y_z;
  work.s7_320 = fma(p_tie_rod_left_to_x, work.R_carrier_left_y_x, s7_319) - work.s7_309;
  const double s7_321 = fnma(work.s7_164, work.s7_312, work.a_bell_crank_z);
  work.s7_322 = 1.1666666666666667*fma(work.s7_163, work.s7_313, s7_321);
  const double s7_323 = fma(work.s7_161, work.s7_312, work.a_bell_crank_x);
  work.s7_324 = 1.1666666666666667*fma(work.s7_160, work.s7_313, s7_323);
  const double s7_325 = fnma(work.s7_159, work.s7_312, work.a_bell_crank_y);
  work.s7_326 = 1.1666666666666667*fnma(work.s7_162, work.s7_313, s7_325);
  const double s7_327 = fnma(work.s7_51, work.s7_316, work.a_carrier_left_aux1_x);
  const double s7_328 = fma(work.s7_57, work.s7_320, fma(work.s7_55, work.s7_318, s7_327));
  const double s7_329 = 1.1666666666666667*s7_328;
  const double s7_330 = fma(work.s7_54, work.s7_316, work.a_carrier_left_aux1_y);
  const double s7_331 = fnma(work.s7_53, work.s7_320, fma(work.s7_59, work.s7_318, s7_330));
  const double s7_332 = 1.1666666666666667*s7_331;
  // tie_rod_right
  work.s7_333 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_311);
  work.s7_334 = p_tie_rod_right_to_y*work.s1_41;
  work.s7_335 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s7_310);
  const double s7_336 = p_tie_rod_right_to_z*work.R_carrier_right_x_z;
  const double s7_337 = fma(p_tie_rod_right_to_x, work.R_carrier_right_x_x, s7_336);
  work.s7_338 = s7_337 - work.s7_334;
  work.s7_339 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s7_340 = p_tie_rod_right_to_z*work.R_carrier_right_z_z;
  const double s7_341 = fma(p_tie_rod_right_to_x, work.R_carrier_right_z_x, s7_340);
  work.s7_342 = work.s7_339 + s7_341;
  work.s7_343 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s7_344 = p_tie_rod_right_to_z*work.R_carrier_right_y_z;
  const double s7_345 = fma(p_tie_rod_right_to_x, work.R_carrier_right_y_x, s7_344);
  work.s7_346 = work.s7_343 + s7_345;
  const double s7_347 = fnma(work.s7_163, work.s7_333, work.a_bell_crank_z);
  work.s7_348 = 1.1666666666666667*fma(work.s7_164, work.s7_335, s7_347);
  const double s7_349 = fma(work.s7_162, work.s7_333, work.a_bell_crank_y);
  work.s7_350 = 1.1666666666666667*fma(work.s7_159, work.s7_335, s7_349);
  const double s7_351 = fnma(work.s7_160, work.s7_333, work.a_bell_crank_x);
  work.s7_352 = 1.1666666666666667*fnma(work.s7_161, work.s7_335, s7_351);
  const double s7_353 = fnma(work.s7_115, work.s7_338, work.a_carrier_right_aux1_x);
  const double s7_354 = fma(work.s7_121, work.s7_346, fma(work.s7_119, work.s7_342, s7_353));
  const double s7_355 = 1.1666666666666667*s7_354;
  const double s7_356 = fma(work.s7_118, work.s7_338, work.a_carrier_right_aux1_y);
  const double s7_357 = fnma(work.s7_117, work.s7_346, fma(work.s7_123, work.s7_342, s7_356));
  const double s7_358 = 1.1666666666666667*s7_357;
  // long_rod_left
  const double s7_359 = -p_long_rod_left_from_z*work.s7_14;
  const double s7_360 = fnma(p_long_rod_left_from_x, work.s7_17, s7_359);
  const double s7_361 = p_long_rod_left_to_x*work.R_rear_axle_aux5_z_x;
  const double s7_362 = fma(p_long_rod_left_to_z, work.R_rear_axle_z_z, s7_361);
  work.s7_363 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_362);
  const double s7_364 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_365 = fma(p_long_rod_left_to_z, work.R_rear_axle_x_z, s7_364);
  work.s7_366 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_365);
  const double s7_367 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_368 = fma(p_long_rod_left_to_z, work.R_rear_axle_y_z, s7_367);
  work.s7_369 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_368);
  const double s7_370 = -p_long_rod_left_from_x*work.s7_12;
  const double s7_371 = fma(p_long_rod_left_from_z, work.s7_16, s7_370);
  const double s7_372 = 3.0*(s7_371 + fma(p_long_rod_left_from_y, work.s7_18, work.a_chassis_x));
  const double s7_373 = -p_long_rod_left_from_z*work.s7_11;
  const double s7_374 = fma(p_long_rod_left_from_x, work.s7_19, s7_373);
  const double s7_375 = 3.0*(s7_374 + fma(p_long_rod_left_from_y, work.s7_15, work.a_chassis_z));
  const double s7_376 = fnma(p_long_rod_left_from_y, work.s7_13, work.a_chassis_y) - s7_360;
  const double s7_377 = 3.0*s7_376;
  // diag_rod_left
  const double s7_378 = -p_diag_rod_left_from_z*work.s7_14;
  const double s7_379 = fnma(p_diag_rod_left_from_x, work.s7_17, s7_378);
  const double s7_380 = p_diag_rod_left_to_z*work.R_rear_axle_z_z;
  work.s7_381 = fma(p_diag_rod_left_to_y, work.R_rear_axle_z_y, s7_380);
  const double s7_382 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  work.s7_383 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_382);
  const double s7_384 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  work.s7_385 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_384);
  const double s7_386 = -p_diag_rod_left_from_x*work.s7_12;
  const double s7_387 = fma(p_diag_rod_left_from_z, work.s7_16, s7_386);
  const double s7_388 = 2.6666666666666665*(work.s7_21 + s7_387);
  const double s7_389 = -p_diag_rod_left_from_z*work.s7_11;
  const double s7_390 = fma(p_diag_rod_left_from_x, work.s7_19, s7_389);
  const double s7_391 = 2.6666666666666665*(work.s7_26 + s7_390);
  const double s7_392 = fnma(p_lower_arm_left_y, work.s7_13, work.a_chassis_y) - s7_379;
  const double s7_393 = 2.6666666666666665*s7_392;
  // arb_link_rear_left
  const double R_arb_rear_left_x_z = work.sines[20];
  work.s7_394 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_z;
  const double s7_395 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_396 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s7_395);
  const double s7_397 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_z_x;
  const double s7_398 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s7_397);
  const double s7_399 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_400 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s7_399);
  const double R_arb_rear_left_x_x = work.cosines[20];
  work.s7_401 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_x;
  work.s7_402 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s7_398);
  work.s7_403 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_400);
  work.s7_404 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_396);
  const double s7_405 = fma(p_arb_link_rear_left_from_y, s7_222, a_arb_rear_left_x);
  const double s7_406 = fnma(s7_219, work.s7_401, fnma(s7_216, work.s7_394, s7_405));
  const double s7_407 = 0.3333333333333333*s7_406;
  const double s7_408 = fma(p_arb_link_rear_left_from_y, s7_221, a_arb_rear_left_z);
  const double s7_409 = fma(s7_217, work.s7_401, fma(s7_218, work.s7_394, s7_408));
  const double s7_410 = 0.3333333333333333*s7_409;
  const double s7_411 = fnma(s7_223, work.s7_394, a_arb_rear_left_y);
  const double s7_412 = fnma(p_arb_link_rear_left_from_y, work.s7_13, s7_411);
  const double s7_413 = 0.3333333333333333*fma(s7_220, work.s7_401, s7_412);
  const double s7_414 = fnma(work.s7_195, work.s7_402, work.a_rear_axle_aux3_z);
  const double s7_415 = fma(s7_199, work.s7_404, fma(s7_203, work.s7_403, s7_414));
  const double s7_416 = 0.3333333333333333*s7_415;
  const double s7_417 = fma(s7_200, work.s7_402, work.a_rear_axle_aux3_x);
  const double s7_418 = fma(s7_201, work.s7_404, fnma(work.s7_196, work.s7_403, s7_417));
  const double s7_419 = 0.3333333333333333*s7_418;
  // long_rod_right
  work.s7_420 = fnma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_362);
  work.s7_421 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_365);
  work.s7_422 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_368);
  const double s7_423 = s7_371 + fnma(p_long_rod_left_from_y, work.s7_18, work.a_chassis_x);
  const double s7_424 = 3.0*s7_423;
  const double s7_425 = s7_374 + fnma(p_long_rod_left_from_y, work.s7_15, work.a_chassis_z);
  const double s7_426 = 3.0*s7_425;
  const double s7_427 = 3.0*(fma(p_long_rod_left_from_y, work.s7_13, work.a_chassis_y) - s7_360);
  // diag_rod_right
  work.s7_428 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_z_y, s7_380);
  work.s7_429 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_382);
  work.s7_430 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_384);
  const double s7_431 = 2.6666666666666665*(work.s7_89 + s7_387);
  const double s7_432 = 2.6666666666666665*(work.s7_90 + s7_390);
  const double s7_433 = fma(p_lower_arm_left_y, work.s7_13, work.a_chassis_y) - s7_379;
  const double s7_434 = 2.6666666666666665*s7_433;
  // arb_link_rear_right
  work.s7_435 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_396);
  work.s7_436 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_400);
  work.s7_437 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s7_398);
  const double R_arb_rear_right_x_z = work.sines[21];
  work.s7_438 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = work.cosines[21];
  work.s7_439 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_x;
  const double s7_440 = fnma(s7_199, work.s7_435, work.a_rear_axle_aux3_z);
  const double s7_441 = fma(work.s7_195, work.s7_437, fnma(s7_203, work.s7_436, s7_440));
  const double s7_442 = 0.3333333333333333*s7_441;
  const double s7_443 = fnma(s7_201, work.s7_435, work.a_rear_axle_aux3_x);
  const double s7_444 = fnma(s7_200, work.s7_437, fma(work.s7_196, work.s7_436, s7_443));
  const double s7_445 = 0.3333333333333333*s7_444;
  const double s7_446 = fma(p_arb_link_rear_right_from_y, s7_237, a_arb_rear_right_z);
  const double s7_447 = fma(s7_233, work.s7_439, fma(s7_234, work.s7_438, s7_446));
  const double s7_448 = 0.3333333333333333*s7_447;
  const double s7_449 = fma(p_arb_link_rear_left_from_y, work.s7_13, a_arb_rear_right_y);
  const double s7_450 = fma(s7_236, work.s7_439, fnma(s7_239, work.s7_438, s7_449));
  const double s7_451 = 0.3333333333333333*s7_450;
  const double s7_452 = fma(p_arb_link_rear_right_from_y, s7_238, a_arb_rear_right_x);
  const double s7_453 = fnma(s7_235, work.s7_439, fnma(s7_232, work.s7_438, s7_452));
  const double s7_454 = 0.3333333333333333*s7_453;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_455 = c_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s7_456 = c_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s7_457 = fma(c_arb_rear_right_y, s7_238, a_arb_rear_right_x);
  const double s7_458 = fma(s7_234, s7_455, fma(c_arb_rear_right_y, s7_237, a_arb_rear_right_z));
  const double s7_459 = R_arb_rear_right_x_x*work.w_chassis_x;
  const double s7_460 = fnma(R_arb_rear_right_x_z, work.w_chassis_z, s7_459);
  const double s7_461 = I_arb_rear_right_xy*work.w_arb_rear_right_y;
  const double s7_462 = R_arb_rear_right_x_x*alpha_arb_rear_right_x;
  const double s7_463 = R_arb_rear_right_x_z*work.w_chassis_x;
  const double s7_464 = fma(R_arb_rear_right_x_x, work.w_chassis_z, s7_463);
  const double s7_465 = fnma(work.s7_439, s7_442, I_arb_rear_right_yy*alpha_arb_rear_right_y);
  const double s7_466 = m_arb_rear_right*fnma(s7_235, s7_456, fnma(s7_232, s7_455, s7_457));
  const double s7_467 = fnma(s7_455, s7_466, fnma(work.s7_438, s7_445, s7_465));
  const double s7_468 = fnma(s7_456, m_arb_rear_right*fma(s7_233, s7_456, s7_458), s7_467);
  const double s7_469 = fnma(R_arb_rear_right_x_z, alpha_arb_rear_right_z, s7_462);
  const double s7_470 = fma(I_arb_rear_right_xx, s7_460, s7_461);
  const double s7_471 = fma(s7_470, s7_464, fma(I_arb_rear_right_xy, s7_469, s7_468));
  const double n_arb_rear_right_y = fnma(s7_460, I_arb_rear_right_zz*s7_464, s7_471);
  result.missing[21] = tau[Coordinate::arb_rear_right] - n_arb_rear_right_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double f_wheel_rear_right_x = m_wheel_rear_right*a_wheel_rear_right_x;
  const double f_wheel_rear_right_y = m_wheel_rear_right*a_wheel_rear_right_y;
  const double f_wheel_rear_right_z = m_wheel_rear_right*a_wheel_rear_right_z;
  const double s7_472 = work.R_rear_axle_x_y*alpha_wheel_rear_right_x;
  const double s7_473 = fma(work.R_rear_axle_y_y, alpha_wheel_rear_right_y, s7_472);
  const double s7_474 = work.R_rear_axle_x_z*work.w_wheel_rear_right_x;
  const double s7_475 = fma(work.R_rear_axle_y_z, work.w_wheel_rear_right_y, s7_474);
  const double s7_476 = fma(work.R_rear_axle_z_z, work.w_wheel_rear_right_z, s7_475);
  const double s7_477 = work.R_rear_axle_aux5_x_x*work.w_wheel_rear_right_x;
  const double s7_478 = fma(work.R_rear_axle_aux5_y_x, work.w_wheel_rear_right_y, s7_477);
  const double s7_479 = fma(work.R_rear_axle_aux5_z_x, work.w_wheel_rear_right_z, s7_478);
  const double s7_480 = I_wheel_rear_right_xx*s7_479;
  const double s7_481 = I_wheel_rear_right_zz*s7_476;
  const double s7_482 = fma(work.R_rear_axle_z_y, alpha_wheel_rear_right_z, s7_473);
  const double s7_483 = fnma(s7_479, s7_481, fma(s7_476, s7_480, I_wheel_rear_right_yy*s7_482));
  const double s7_484 = work.R_rear_axle_aux5_x_x*alpha_wheel_rear_right_x;
  const double s7_485 = fma(work.R_rear_axle_aux5_y_x, alpha_wheel_rear_right_y, s7_484);
  const double s7_486 = work.R_rear_axle_x_y*work.w_wheel_rear_right_x;
  const double s7_487 = fma(work.R_rear_axle_y_y, work.w_wheel_rear_right_y, s7_486);
  const double s7_488 = fma(work.R_rear_axle_z_y, work.w_wheel_rear_right_z, s7_487);
  const double s7_489 = I_wheel_rear_right_yy*s7_488;
  const double s7_490 = fma(work.R_rear_axle_aux5_z_x, alpha_wheel_rear_right_z, s7_485);
  const double s7_491 = fnma(s7_476, s7_489, fma(s7_481, s7_488, I_wheel_rear_right_xx*s7_490));
  const double s7_492 = work.R_rear_axle_x_z*alpha_wheel_rear_right_x;
  const double s7_493 = fma(work.R_rear_axle_y_z, alpha_wheel_rear_right_y, s7_492);
  const double s7_494 = fma(work.R_rear_axle_z_z, alpha_wheel_rear_right_z, s7_493);
  const double s7_495 = fma(I_wheel_rear_right_zz, s7_494, fnma(s7_480, s7_488, s7_479*s7_489));
  const double s7_496 = fma(work.R_rear_axle_aux5_x_x, s7_491, work.R_rear_axle_x_y*s7_483);
  const double n_wheel_rear_right_x = fma(work.R_rear_axle_x_z, s7_495, s7_496);
  const double s7_497 = fma(work.R_rear_axle_aux5_y_x, s7_491, work.R_rear_axle_y_y*s7_483);
  const double n_wheel_rear_right_y = fma(work.R_rear_axle_y_z, s7_495, s7_497);
  const double s7_498 = fma(work.R_rear_axle_aux5_z_x, s7_491, work.R_rear_axle_z_y*s7_483);
  const double n_wheel_rear_right_z = fma(work.R_rear_axle_z_z, s7_495, s7_498);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_499 = c_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_500 = c_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s7_501 = fnma(s7_216, s7_499, fma(c_arb_rear_left_y, s7_222, a_arb_rear_left_x));
  const double s7_502 = fma(s7_218, s7_499, fma(c_arb_rear_left_y, s7_221, a_arb_rear_left_z));
  const double s7_503 = R_arb_rear_left_x_x*work.w_chassis_x;
  const double s7_504 = fnma(R_arb_rear_left_x_z, work.w_chassis_z, s7_503);
  const double s7_505 = I_arb_rear_left_xx*s7_504;
  const double s7_506 = R_arb_rear_left_x_x*alpha_arb_rear_left_x;
  const double s7_507 = R_arb_rear_left_x_z*work.w_chassis_x;
  const double s7_508 = fma(R_arb_rear_left_x_x, work.w_chassis_z, s7_507);
  const double s7_509 = fnma(work.s7_401, s7_416, I_arb_rear_left_yy*alpha_arb_rear_left_y);
  const double s7_510 = m_arb_rear_left*fnma(s7_219, s7_500, s7_501);
  const double s7_511 = fnma(s7_499, s7_510, fnma(work.s7_394, s7_419, s7_509));
  const double s7_512 = fnma(s7_500, m_arb_rear_left*fma(s7_217, s7_500, s7_502), s7_511);
  const double s7_513 = fnma(R_arb_rear_left_x_z, alpha_arb_rear_left_z, s7_506);
  const double s7_514 = fma(I_arb_rear_left_xy, work.w_arb_rear_left_y, s7_505);
  const double s7_515 = fma(s7_514, s7_508, fma(I_arb_rear_left_xy, s7_513, s7_512));
  const double n_arb_rear_left_y = fnma(s7_504, I_arb_rear_left_zz*s7_508, s7_515);
  result.missing[20] = tau[Coordinate::arb_rear_left] - n_arb_rear_left_y;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double f_wheel_rear_left_x = m_wheel_rear_left*a_wheel_rear_left_x;
  const double f_wheel_rear_left_y = m_wheel_rear_left*a_wheel_rear_left_y;
  const double f_wheel_rear_left_z = m_wheel_rear_left*a_wheel_rear_left_z;
  const double s7_516 = work.R_rear_axle_x_y*alpha_wheel_rear_left_x;
  const double s7_517 = fma(work.R_rear_axle_y_y, alpha_wheel_rear_left_y, s7_516);
  const double s7_518 = work.R_rear_axle_x_z*work.w_wheel_rear_left_x;
  const double s7_519 = fma(work.R_rear_axle_y_z, work.w_wheel_rear_left_y, s7_518);
  const double s7_520 = fma(work.R_rear_axle_z_z, work.w_wheel_rear_left_z, s7_519);
  const double s7_521 = work.R_rear_axle_aux5_x_x*work.w_wheel_rear_left_x;
  const double s7_522 = fma(work.R_rear_axle_aux5_y_x, work.w_wheel_rear_left_y, s7_521);
  const double s7_523 = fma(work.R_rear_axle_aux5_z_x, work.w_wheel_rear_left_z, s7_522);
  const double s7_524 = I_wheel_rear_left_xx*s7_523;
  const double s7_525 = I_wheel_rear_left_zz*s7_520;
  const double s7_526 = fma(work.R_rear_axle_z_y, alpha_wheel_rear_left_z, s7_517);
  const double s7_527 = fnma(s7_523, s7_525, fma(s7_520, s7_524, I_wheel_rear_left_yy*s7_526));
  const double s7_528 = work.R_rear_axle_aux5_x_x*alpha_wheel_rear_left_x;
  const double s7_529 = fma(work.R_rear_axle_aux5_y_x, alpha_wheel_rear_left_y, s7_528);
  const double s7_530 = work.R_rear_axle_x_y*work.w_wheel_rear_left_x;
  const double s7_531 = fma(work.R_rear_axle_y_y, work.w_wheel_rear_left_y, s7_530);
  const double s7_532 = fma(work.R_rear_axle_z_y, work.w_wheel_rear_left_z, s7_531);
  const double s7_533 = I_wheel_rear_left_yy*s7_532;
  const double s7_534 = fma(work.R_rear_axle_aux5_z_x, alpha_wheel_rear_left_z, s7_529);
  const double s7_535 = fnma(s7_520, s7_533, fma(s7_525, s7_532, I_wheel_rear_left_xx*s7_534));
  const double s7_536 = work.R_rear_axle_x_z*alpha_wheel_rear_left_x;
  const double s7_537 = fma(work.R_rear_axle_y_z, alpha_wheel_rear_left_y, s7_536);
  const double s7_538 = fma(work.R_rear_axle_z_z, alpha_wheel_rear_left_z, s7_537);
  const double s7_539 = fma(I_wheel_rear_left_zz, s7_538, fnma(s7_524, s7_532, s7_523*s7_533));
  const double s7_540 = fma(work.R_rear_axle_aux5_x_x, s7_535, work.R_rear_axle_x_y*s7_527);
  const double n_wheel_rear_left_x = fma(work.R_rear_axle_x_z, s7_539, s7_540);
  const double s7_541 = fma(work.R_rear_axle_aux5_y_x, s7_535, work.R_rear_axle_y_y*s7_527);
  const double n_wheel_rear_left_y = fma(work.R_rear_axle_y_z, s7_539, s7_541);
  const double s7_542 = fma(work.R_rear_axle_aux5_z_x, s7_535, work.R_rear_axle_z_y*s7_527);
  const double n_wheel_rear_left_z = fma(work.R_rear_axle_z_z, s7_539, s7_542);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_543 = c_rear_axle_x*work.R_rear_axle_aux5_y_x;
  const double s7_544 = fma(c_rear_axle_z, work.R_rear_axle_y_z, s7_543);
  const double s7_545 = c_rear_axle_x*work.R_rear_axle_aux5_z_x;
  const double s7_546 = fma(c_rear_axle_z, work.R_rear_axle_z_z, s7_545);
  const double s7_547 = c_rear_axle_x*work.R_rear_axle_aux5_x_x;
  const double s7_548 = fma(c_rear_axle_z, work.R_rear_axle_x_z, s7_547);
  const double s7_549 = fma(s7_200, s7_546, fma(s7_201, s7_544, work.a_rear_axle_aux3_x));
  const double s7_550 = m_rear_axle*fnma(work.s7_196, s7_548, s7_549);
  const double f_rear_axle_x = s7_550 + (s7_454 + (s7_431 + (s7_424 + (s7_407 + (s7_372 +
      s7_388)))));
  const double s7_551 = fma(s7_202, s7_546, fnma(work.s7_197, s7_544, work.a_rear_axle_aux3_y));
  const double s7_552 = m_rear_axle*fma(work.s7_198, s7_548, s7_551);
  const double f_rear_axle_y = s7_552 + (s7_451 + (s7_434 + (s7_427 + (s7_413 + (s7_377 +
      s7_393)))));
  const double s7_553 = fnma(work.s7_195, s7_546, fma(s7_199, s7_544, work.a_rear_axle_aux3_z));
  const double s7_554 = m_rear_axle*fma(s7_203, s7_548, s7_553);
  const double f_rear_axle_z = s7_554 + (s7_448 + (s7_432 + (s7_426 + (s7_410 + (s7_375 +
      s7_391)))));
  const double s7_555 = work.R_rear_axle_x_y*work.alpha_rear_axle_x;
  const double s7_556 = fma(work.R_rear_axle_y_y, work.alpha_rear_axle_y, s7_555);
  const double s7_557 = work.R_rear_axle_x_z*work.w_rear_axle_x;
  const double s7_558 = fma(work.R_rear_axle_y_z, work.w_rear_axle_y, s7_557);
  const double s7_559 = fma(work.R_rear_axle_z_z, work.w_rear_axle_z, s7_558);
  const double s7_560 = work.R_rear_axle_aux5_x_x*work.w_rear_axle_x;
  const double s7_561 = fma(work.R_rear_axle_aux5_y_x, work.w_rear_axle_y, s7_560);
  const double s7_562 = fma(work.R_rear_axle_aux5_z_x, work.w_rear_axle_z, s7_561);
  const double s7_563 = fma(I_rear_axle_xz, s7_559, I_rear_axle_xx*s7_562);
  const double s7_564 = fma(I_rear_axle_xz, s7_562, I_rear_axle_zz*s7_559);
  const double s7_565 = I_rear_axle_yy*fma(work.R_rear_axle_z_y, work.alpha_rear_axle_z, s7_556);
  const double s7_566 = fnma(s7_562, s7_564, fma(s7_559, s7_563, s7_565));
  const double s7_567 = work.R_rear_axle_aux5_x_x*work.alpha_rear_axle_x;
  const double s7_568 = fma(work.R_rear_axle_aux5_y_x, work.alpha_rear_axle_y, s7_567);
  const double s7_569 = fma(work.R_rear_axle_aux5_z_x, work.alpha_rear_axle_z, s7_568);
  const double s7_570 = work.R_rear_axle_x_z*work.alpha_rear_axle_x;
  const double s7_571 = fma(work.R_rear_axle_y_z, work.alpha_rear_axle_y, s7_570);
  const double s7_572 = fma(work.R_rear_axle_z_z, work.alpha_rear_axle_z, s7_571);
  const double s7_573 = work.R_rear_axle_x_y*work.w_rear_axle_x;
  const double s7_574 = fma(work.R_rear_axle_y_y, work.w_rear_axle_y, s7_573);
  const double s7_575 = fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s7_574);
  const double s7_576 = I_rear_axle_yy*s7_575;
  const double s7_577 = fma(s7_564, s7_575, fma(I_rear_axle_xz, s7_572, I_rear_axle_xx*s7_569));
  const double s7_578 = fnma(s7_559, s7_576, s7_577);
  const double s7_579 = fnma(s7_563, s7_575, fma(I_rear_axle_xz, s7_569, I_rear_axle_zz*s7_572));
  const double s7_580 = fma(s7_562, s7_576, s7_579);
  const double s7_581 = fma(work.s7_385, s7_391, fnma(work.s7_363, s7_377, work.s7_369*s7_375));
  const double s7_582 = fma(work.s7_404, s7_410, fnma(work.s7_381, s7_393, s7_581));
  const double s7_583 = fma(work.s7_422, s7_426, fnma(work.s7_402, s7_413, s7_582));
  const double s7_584 = fma(work.s7_430, s7_432, fnma(work.s7_420, s7_427, s7_583));
  const double s7_585 = fnma(work.s7_435, s7_448, fnma(work.s7_428, s7_434, s7_584));
  const double s7_586 = fnma(s7_546, s7_552, fma(work.s7_437, s7_451, s7_585));
  const double s7_587 = fma(work.R_rear_axle_x_y, s7_566, fma(s7_544, s7_554, s7_586));
  const double s7_588 = fma(work.R_rear_axle_aux5_x_x, s7_578, s7_587);
  const double n_rear_axle_x = fma(work.R_rear_axle_x_z, s7_580, s7_588);
  const double s7_589 = fma(work.s7_381, s7_388, fnma(work.s7_366, s7_375, work.s7_363*s7_372));
  const double s7_590 = fma(work.s7_402, s7_407, fnma(work.s7_383, s7_391, s7_589));
  const double s7_591 = fma(work.s7_420, s7_424, fnma(work.s7_403, s7_410, s7_590));
  const double s7_592 = fma(work.s7_428, s7_431, fnma(work.s7_421, s7_426, s7_591));
  const double s7_593 = fma(work.s7_436, s7_448, fnma(work.s7_429, s7_432, s7_592));
  const double s7_594 = fma(s7_546, s7_550, fnma(work.s7_437, s7_454, s7_593));
  const double s7_595 = fma(work.R_rear_axle_y_y, s7_566, fnma(s7_548, s7_554, s7_594));
  const double s7_596 = fma(work.R_rear_axle_aux5_y_x, s7_578, s7_595);
  const double n_rear_axle_y = fma(work.R_rear_axle_y_z, s7_580, s7_596);
  const double s7_597 = fnma(work.s7_385, s7_388, fnma(work.s7_369, s7_372, work.s7_366*s7_377));
  const double s7_598 = fnma(work.s7_404, s7_407, fma(work.s7_383, s7_393, s7_597));
  const double s7_599 = fnma(work.s7_422, s7_424, fma(work.s7_403, s7_413, s7_598));
  const double s7_600 = fnma(work.s7_430, s7_431, fma(work.s7_421, s7_427, s7_599));
  const double s7_601 = fnma(work.s7_436, s7_451, fma(work.s7_429, s7_434, s7_600));
  const double s7_602 = fnma(s7_544, s7_550, fma(work.s7_435, s7_454, s7_601));
  const double s7_603 = fma(work.R_rear_axle_z_y, s7_566, fma(s7_548, s7_552, s7_602));
  const double s7_604 = fma(work.R_rear_axle_aux5_z_x, s7_578, s7_603);
  const double n_rear_axle_z = fma(work.R_rear_axle_z_z, s7_580, s7_604);
  const double s7_605 = n_rear_axle_y + (n_wheel_rear_right_y + n_wheel_rear_left_y);
  const double s7_606 = fma(work.s1_67, f_wheel_rear_right_z - f_wheel_rear_left_z, s7_605);
  work.s7_607 = fma(work.s1_69, f_wheel_rear_left_x - f_wheel_rear_right_x, s7_606);
  const double s7_608 = n_rear_axle_z + (n_wheel_rear_right_z + n_wheel_rear_left_z);
  const double s7_609 = fma(work.s1_67, f_wheel_rear_left_y - f_wheel_rear_right_y, s7_608);
  work.s7_610 = fma(work.s1_68, f_wheel_rear_right_x - f_wheel_rear_left_x, s7_609);
  const double s7_611 = n_rear_axle_x + (n_wheel_rear_right_x + n_wheel_rear_left_x);
  const double s7_612 = fma(work.s1_68, f_wheel_rear_left_z - f_wheel_rear_right_z, s7_611);
  work.s7_613 = fma(work.s1_69, f_wheel_rear_right_y - f_wheel_rear_left_y, s7_612);
  const double s7_614 = fnma(work.R_rear_axle_aux5_y_x, work.s7_607, tau[Coordinate::rear_axle_rx]);
  const double s7_615 = fnma(work.R_rear_axle_aux5_z_x, work.s7_610, s7_614);
  result.missing[19] = fnma(work.R_rear_axle_aux5_x_x, work.s7_613, s7_615);
  const double s7_616 = fnma(work.cosines[17], work.s7_607, tau[Coordinate::rear_axle_ry]);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  result.missing[18] = fma(work.s1_60, work.s7_613, fma(work.s1_62, work.s7_610, s7_616));
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s7_617 = fnma(work.R_rear_axle_aux4_z_z, work.s7_610, tau[Coordinate::rear_axle_rz]);
  result.missing[17] = fnma(work.R_rear_axle_aux4_x_z, work.s7_613, s7_617);
  const double s7_618 = tau[Coordinate::rear_axle_tz] - f_wheel_rear_right_z;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.Q_rear_axle_tz = s7_618 - f_wheel_rear_left_z - f_rear_axle_z;
  result.missing[16] = work.Q_rear_axle_tz;
  const double s7_619 = tau[Coordinate::rear_axle_ty] - f_wheel_rear_right_y;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  work.Q_rear_axle_ty = s7_619 - f_wheel_rear_left_y - f_rear_axle_y;
  result.missing[15] = work.Q_rear_axle_ty;
  const double s7_620 = tau[Coordinate::rear_axle_tx] - f_wheel_rear_right_x;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.Q_rear_axle_tx = s7_620 - f_wheel_rear_left_x - f_rear_axle_x;
  result.missing[14] = work.Q_rear_axle_tx;
  // bell_crank: bell_crank, revolute, chassis
  const double s7_621 = fma(c_bell_crank_y, R_bell_crank_y_x, -c_bell_crank_x*R_bell_crank_x_x);
  const double s7_622 = fma(c_bell_crank_x, R_bell_crank_y_x, c_bell_crank_y*R_bell_crank_x_x);
  const double s7_623 = fma(work.s7_160, s7_622, fma(work.s7_161, s7_621, work.a_bell_crank_x));
  const double s7_624 = fnma(work.s7_159, s7_621, work.a_bell_crank_y);
  const double s7_625 = R_bell_crank_x_x*work.w_chassis_y;
  const double s7_626 = fnma(R_bell_crank_y_x, work.w_chassis_x, s7_625);
  const double s7_627 = R_bell_crank_x_x*work.w_chassis_x;
  const double s7_628 = fma(R_bell_crank_y_x, work.w_chassis_y, s7_627);
  const double s7_629 = fnma(s7_299, s7_301, I_bell_crank_zz*work.alpha_bell_crank_z);
  const double s7_630 = fnma(work.s7_313, s7_329, fnma(work.s7_298, s7_307, s7_629));
  const double s7_631 = fma(work.s7_333, s7_355, fnma(work.s7_312, s7_332, s7_630));
  const double s7_632 = fnma(s7_622, m_bell_crank*s7_623, fma(work.s7_335, s7_358, s7_631));
  const double s7_633 = fnma(s7_621, m_bell_crank*fnma(work.s7_162, s7_622, s7_624), s7_632);
  const double s7_634 = fma(I_bell_crank_xy, s7_628, I_bell_crank_yy*s7_626);
  const double s7_635 = fma(I_bell_crank_xy, s7_626, I_bell_crank_xx*s7_628);
  const double n_bell_crank_z = fnma(s7_626, s7_635, fma(s7_628, s7_634, s7_633));
  result.missing[13] = tau[Coordinate::bell_crank] - n_bell_crank_z;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_636 = -c_pitman_arm_z*R_pitman_arm_x_z;
  const double s7_637 = -c_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_638 = fnma(work.s7_150, s7_637, fma(work.s7_153, s7_636, work.a_pitman_arm_x));
  const double s7_639 = fma(work.s7_152, s7_637, fnma(work.s7_151, s7_636, work.a_pitman_arm_z));
  const double s7_640 = R_pitman_arm_x_x*work.w_chassis_x;
  const double s7_641 = fnma(R_pitman_arm_x_z, work.w_chassis_z, s7_640);
  const double s7_642 = R_pitman_arm_x_z*work.w_chassis_x;
  const double s7_643 = fma(R_pitman_arm_x_x, work.w_chassis_z, s7_642);
  const double s7_644 = fma(work.s7_296, s7_303, I_pitman_arm_yy*work.alpha_pitman_arm_y);
  const double s7_645 = fnma(s7_637, m_pitman_arm*s7_638, fnma(work.s7_297, s7_305, s7_644));
  const double s7_646 = fma(s7_636, m_pitman_arm*s7_639, s7_645);
  const double s7_647 = fma(I_pitman_arm_xx*s7_641, s7_643, s7_646);
  const double n_pitman_arm_y = fnma(s7_641, I_pitman_arm_zz*s7_643, s7_647);
  work.Q_pitman_arm = tau[Coordinate::pitman_arm] - n_pitman_arm_y;
  result.missing[12] = work.Q_pitman_arm;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_648 = c_arb_front_right_z*R_arb_front_right_x_x;
  const double s7_649 = fnma(c_arb_front_right_x, R_arb_front_right_x_z, s7_648);
  const double s7_650 = c_arb_front_right_z*R_arb_front_right_x_z;
  const double s7_651 = fma(c_arb_front_right_x, R_arb_front_right_x_x, s7_650);
  const double s7_652 = fma(c_arb_front_right_y, work.s7_142, work.a_arb_front_right_x);
  const double s7_653 = fnma(work.s7_139, s7_651, fma(work.s7_136, s7_649, s7_652));
  const double s7_654 = fma(c_arb_front_right_y, work.s7_141, work.a_arb_front_right_z);
  const double s7_655 = fma(work.s7_137, s7_651, fnma(work.s7_138, s7_649, s7_654));
  const double s7_656 = R_arb_front_right_x_x*work.alpha_arb_front_right_x;
  const double s7_657 = R_arb_front_right_x_z*work.alpha_arb_front_right_x;
  const double s7_658 = R_arb_front_right_x_x*work.w_chassis_x;
  const double s7_659 = fnma(R_arb_front_right_x_z, work.w_chassis_z, s7_658);
  const double s7_660 = R_arb_front_right_x_z*work.w_chassis_x;
  const double s7_661 = fma(R_arb_front_right_x_x, work.w_chassis_z, s7_660);
  const double s7_662 = I_arb_front_right_xx*s7_659;
  const double s7_663 = fma(I_arb_front_right_xy, work.w_arb_front_right_y, s7_662);
  const double s7_664 = I_arb_front_right_yz*work.w_arb_front_right_y;
  const double s7_665 = fma(I_arb_front_right_xz, s7_659, s7_664);
  const double s7_666 = I_arb_front_right_yy*work.alpha_arb_front_right_y;
  const double s7_667 = fma(work.s7_269, s7_295, fnma(work.s7_271, s7_292, s7_666));
  const double s7_668 = fma(s7_649, m_arb_front_right*s7_653, s7_667);
  const double s7_669 = fnma(R_arb_front_right_x_z, work.alpha_arb_front_right_z, s7_656);
  const double s7_670 = fnma(s7_651, m_arb_front_right*s7_655, s7_668);
  const double s7_671 = fma(R_arb_front_right_x_x, work.alpha_arb_front_right_z, s7_657);
  const double s7_672 = fma(I_arb_front_right_xy, s7_669, s7_670);
  const double s7_673 = fma(I_arb_front_right_xz, s7_661, s7_663);
  const double s7_674 = fma(s7_661, s7_673, fma(I_arb_front_right_yz, s7_671, s7_672));
  const double n_arb_front_right_y = fnma(s7_659, fma(I_arb_front_right_zz, s7_661, s7_665),
      s7_674);
  work.Q_arb_front_right = tau[Coordinate::arb_front_right] - n_arb_front_right_y;
  result.missing[11] = work.Q_arb_front_right;
  const double R_upper_arm_right_z_y = work.sines[13];
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_675 = -c_upper_arm_right_z*R_upper_arm_right_z_y;
  const double s7_676 = fma(c_upper_arm_right_y, R_upper_arm_right_y_y, s7_675);
  const double s7_677 = -c_upper_arm_right_z*R_upper_arm_right_y_y;
  const double s7_678 = fnma(c_upper_arm_right_y, R_upper_arm_right_z_y, s7_677);
  const double s7_679 = fnma(work.s7_135, s7_676, work.a_upper_arm_right_y);
  const double f_upper_arm_right_y = m_upper_arm_right*fnma(work.s7_133, s7_678, s7_679);
  const double s7_680 = fma(work.s7_132, s7_676, work.a_upper_arm_right_z);
  const double f_upper_arm_right_z = m_upper_arm_right*fma(work.s7_134, s7_678, s7_680);
  const double s7_681 = R_upper_arm_right_y_y*work.w_chassis_y;
  const double s7_682 = fma(R_upper_arm_right_z_y, work.w_chassis_z, s7_681);
  const double s7_683 = R_upper_arm_right_y_y*work.w_chassis_z;
  const double s7_684 = fnma(R_upper_arm_right_z_y, work.w_chassis_y, s7_683);
  const double s7_685 = I_upper_arm_right_xx*work.alpha_upper_arm_right_x;
  const double s7_686 = fma(s7_678, f_upper_arm_right_y, s7_685);
  const double s7_687 = fma(s7_676, f_upper_arm_right_z, s7_686);
  const double s7_688 = fma(s7_682, I_upper_arm_right_zz*s7_684, s7_687);
  const double n_upper_arm_right_x = fnma(s7_684, I_upper_arm_right_yy*s7_682, s7_688);
  work.Q_upper_arm_right = tau[Coordinate::upper_arm_right] - n_upper_arm_right_x;
  result.missing[10] = work.Q_upper_arm_right;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  work.f_wheel_front_right_x = m_wheel_front_right*work.a_wheel_front_right_x;
  work.f_wheel_front_right_y = m_wheel_front_right*work.a_wheel_front_right_y;
  work.f_wheel_front_right_z = m_wheel_front_right*work.a_wheel_front_right_z;
  const double s7_689 = work.R_carrier_right_x_z*work.alpha_wheel_front_right_x;
  const double s7_690 = fma(work.R_carrier_right_y_z, work.alpha_wheel_front_right_y, s7_689);
  const double s7_691 = work.R_carrier_right_x_x*work.w_wheel_front_right_x;
  const double s7_692 = fma(work.R_carrier_right_y_x, work.w_wheel_front_right_y, s7_691);
  const double s7_693 = fma(work.R_carrier_right_z_x, work.w_wheel_front_right_z, s7_692);
  const double s7_694 = work.R_carrier_right_aux2_y_y*work.w_wheel_front_right_y;
  const double s7_695 = fnma(work.s1_41, work.w_wheel_front_right_x, s7_694);
  const double s7_696 = fma(work.R_carrier_right_aux2_z_y, work.w_wheel_front_right_z, s7_695);
  const double s7_697 = I_wheel_front_right_yy*s7_696;
  const double s7_698 = I_wheel_front_right_xx*s7_693;
  const double s7_699 = fma(work.R_carrier_right_z_z, work.alpha_wheel_front_right_z, s7_690);
  const double s7_700 = fnma(s7_696, s7_698, fma(s7_693, s7_697, I_wheel_front_right_zz*s7_699));
  const double s7_701 = work.R_carrier_right_x_x*work.alpha_wheel_front_right_x;
  const double s7_702 = fma(work.R_carrier_right_y_x, work.alpha_wheel_front_right_y, s7_701);
  const double s7_703 = work.R_carrier_right_x_z*work.w_wheel_front_right_x;
  const double s7_704 = fma(work.R_carrier_right_y_z, work.w_wheel_front_right_y, s7_703);
  const double s7_705 = fma(work.R_carrier_right_z_z, work.w_wheel_front_right_z, s7_704);
  const double s7_706 = I_wheel_front_right_zz*s7_705;
  const double s7_707 = fma(work.R_carrier_right_z_x, work.alpha_wheel_front_right_z, s7_702);
  work.s7_708 = fma(s7_696, s7_706, fnma(s7_697, s7_705, I_wheel_front_right_xx*s7_707));
  const double s7_709 = work.R_carrier_right_aux2_y_y*work.alpha_wheel_front_right_y;
  const double s7_710 = fnma(work.s1_41, work.alpha_wheel_front_right_x, s7_709);
  const double s7_711 = fma(work.R_carrier_right_aux2_z_y, work.alpha_wheel_front_right_z, s7_710);
  work.s7_712 = fma(I_wheel_front_right_yy, s7_711, fnma(s7_693, s7_706, s7_698*s7_705));
  const double s7_713 = work.R_carrier_right_x_z*s7_700;
  const double s7_714 = fma(work.R_carrier_right_x_x, work.s7_708, s7_713);
  work.n_wheel_front_right_x = fnma(work.s1_41, work.s7_712, s7_714);
  const double s7_715 = work.R_carrier_right_y_z*s7_700;
  const double s7_716 = fma(work.R_carrier_right_y_x, work.s7_708, s7_715);
  work.n_wheel_front_right_y = fma(work.R_carrier_right_aux2_y_y, work.s7_712, s7_716);
  work.s7_717 = work.R_carrier_right_z_z*s7_700;
}

/// Part 3 of compute_multipliers: step 7: inertias of the bodies and forces on joints; step 9:
/// multipliers of the closures and driving forces.
[[gnu::noinline]] void compute_multipliers_3(const State& state, const double* tau,
    ConstraintForcesWork& __restrict work, ConstraintForces& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_718 = fma(work.R_carrier_right_z_x, work.s7_708, work.s7_717);
  const double n_wheel_front_right_z = fma(work.R_carrier_right_aux2_z_y, work.s7_712, s7_718);
  const double s7_719 = c_carrier_right_z*work.R_carrier_right_y_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_720 = fma(c_carrier_right_y, work.R_carrier_right_aux2_y_y, s7_719);
  const double s7_721 = fma(c_carrier_right_x, work.R_carrier_right_y_x, s7_720);
  const double s7_722 = c_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_723 = fma(c_carrier_right_y, work.R_carrier_right_aux2_z_y, s7_722);
  const double s7_724 = fma(c_carrier_right_x, work.R_carrier_right_z_x, s7_723);
  const double s7_725 = -c_carrier_right_y*work.s1_41;
  const double s7_726 = fma(c_carrier_right_x, work.R_carrier_right_x_x, s7_725);
  const double s7_727 = fma(c_carrier_right_z, work.R_carrier_right_x_z, s7_726);
  const double s7_728 = fma(work.s7_121, s7_721, work.a_carrier_right_aux1_x);
  const double s7_729 = fnma(work.s7_115, s7_727, fma(work.s7_119, s7_724, s7_728));
  const double s7_730 = m_carrier_right*s7_729;
  const double s7_731 = fnma(work.s7_117, s7_721, work.a_carrier_right_aux1_y);
  const double s7_732 = fma(work.s7_118, s7_727, fma(work.s7_123, s7_724, s7_731));
  const double s7_733 = m_carrier_right*s7_732;
  const double f_carrier_right_y = s7_733 + (work.s7_286 + work.s7_350);
  const double s7_734 = fma(work.s7_120, s7_721, work.a_carrier_right_aux1_z);
  const double s7_735 = fma(work.s7_122, s7_727, fnma(work.s7_116, s7_724, s7_734));
  const double s7_736 = m_carrier_right*s7_735;
  const double f_carrier_right_z = s7_736 + (work.s7_283 + work.s7_348);
  const double s7_737 = work.R_carrier_right_aux2_y_y*work.alpha_carrier_right_y;
  const double s7_738 = fnma(work.s1_41, work.alpha_carrier_right_x, s7_737);
  const double s7_739 = fma(work.R_carrier_right_aux2_z_y, work.alpha_carrier_right_z, s7_738);
  const double s7_740 = work.R_carrier_right_x_z*work.alpha_carrier_right_x;
  const double s7_741 = fma(work.R_carrier_right_y_z, work.alpha_carrier_right_y, s7_740);
  const double s7_742 = fma(work.R_carrier_right_z_z, work.alpha_carrier_right_z, s7_741);
  const double s7_743 = work.R_carrier_right_x_x*work.alpha_carrier_right_x;
  const double s7_744 = fma(work.R_carrier_right_y_x, work.alpha_carrier_right_y, s7_743);
  const double s7_745 = fma(work.R_carrier_right_z_x, work.alpha_carrier_right_z, s7_744);
  const double s7_746 = work.R_carrier_right_x_x*work.w_carrier_right_x;
  const double s7_747 = fma(work.R_carrier_right_y_x, work.w_carrier_right_y, s7_746);
  const double s7_748 = fma(work.R_carrier_right_z_x, work.w_carrier_right_z, s7_747);
  const double s7_749 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_y;
  const double s7_750 = fnma(work.s1_41, work.w_carrier_right_x, s7_749);
  const double s7_751 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s7_750);
  const double s7_752 = work.R_carrier_right_x_z*work.w_carrier_right_x;
  const double s7_753 = fma(work.R_carrier_right_y_z, work.w_carrier_right_y, s7_752);
  const double s7_754 = fma(work.R_carrier_right_z_z, work.w_carrier_right_z, s7_753);
  const double s7_755 = fma(I_carrier_right_yy, s7_751, I_carrier_right_xy*s7_748);
  const double s7_756 = fma(I_carrier_right_yz, s7_754, s7_755);
  const double s7_757 = fma(I_carrier_right_xy, s7_751, I_carrier_right_xx*s7_748);
  const double s7_758 = fma(I_carrier_right_xz, s7_754, s7_757);
  const double s7_759 = fma(I_carrier_right_zz, s7_742, I_carrier_right_yz*s7_739);
  const double s7_760 = fma(s7_748, s7_756, fma(I_carrier_right_xz, s7_745, s7_759));
  const double s7_761 = fnma(s7_751, s7_758, s7_760);
  const double s7_762 = fma(I_carrier_right_xz, s7_748, I_carrier_right_yz*s7_751);
  const double s7_763 = fma(I_carrier_right_zz, s7_754, s7_762);
  const double s7_764 = fma(I_carrier_right_xz, s7_742, I_carrier_right_xy*s7_739);
  const double s7_765 = fnma(s7_754, s7_756, fma(I_carrier_right_xx, s7_745, s7_764));
  const double s7_766 = fma(s7_751, s7_763, s7_765);
  const double s7_767 = fma(I_carrier_right_yz, s7_742, I_carrier_right_yy*s7_739);
  const double s7_768 = fma(s7_754, s7_758, fma(I_carrier_right_xy, s7_745, s7_767));
  const double s7_769 = fnma(s7_748, s7_763, s7_768);
  const double s7_770 = fnma(work.s7_277, work.s7_286, work.s7_280*work.s7_283);
  const double s7_771 = fnma(work.s7_342, work.s7_350, fma(work.s7_346, work.s7_348, s7_770));
  const double s7_772 = fma(s7_721, s7_736, fnma(s7_724, s7_733, s7_771));
  const double s7_773 = fma(work.R_carrier_right_x_z, s7_761, s7_772);
  const double n_carrier_right_x = fnma(work.s1_41, s7_769, fma(work.R_carrier_right_x_x, s7_766,
      s7_773));
  const double s7_774 = fnma(work.s7_274, work.s7_283, work.s7_277*work.s7_289);
  const double s7_775 = fma(work.s7_342, work.s7_352, fnma(work.s7_338, work.s7_348, s7_774));
  const double s7_776 = fnma(s7_727, s7_736, fma(s7_724, s7_730, s7_775));
  const double s7_777 = fma(work.R_carrier_right_y_z, s7_761, s7_776);
  const double s7_778 = fma(work.R_carrier_right_y_x, s7_766, s7_777);
  const double n_carrier_right_y = fma(work.R_carrier_right_aux2_y_y, s7_769, s7_778);
  const double s7_779 = fnma(work.s7_280, work.s7_289, work.s7_274*work.s7_286);
  const double s7_780 = fnma(work.s7_346, work.s7_352, fma(work.s7_338, work.s7_350, s7_779));
  const double s7_781 = fma(s7_727, s7_733, fnma(s7_721, s7_730, s7_780));
  const double s7_782 = fma(work.R_carrier_right_z_z, s7_761, s7_781);
  const double s7_783 = fma(work.R_carrier_right_z_x, s7_766, s7_782);
  const double n_carrier_right_z = fma(work.R_carrier_right_aux2_z_y, s7_769, s7_783);
  const double s7_784 = work.s1_58*work.f_wheel_front_right_x;
  const double s7_785 = fnma(work.s1_54, work.f_wheel_front_right_z, s7_784);
  const double s7_786 = n_carrier_right_y + (work.n_wheel_front_right_y + s7_785);
  const double s7_787 = work.s1_54*work.f_wheel_front_right_y;
  const double s7_788 = fnma(work.s1_56, work.f_wheel_front_right_x, s7_787);
  const double s7_789 = n_carrier_right_z + (n_wheel_front_right_z + s7_788);
  const double s7_790 = work.s1_56*work.f_wheel_front_right_z;
  const double s7_791 = fnma(work.s1_58, work.f_wheel_front_right_y, s7_790);
  const double s7_792 = n_carrier_right_x + (work.n_wheel_front_right_x + s7_791);
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double s7_793 = fnma(work.R_carrier_right_aux2_y_y, s7_786, tau_carrier_right_ry);
  const double s7_794 = fnma(work.R_carrier_right_aux2_z_y, s7_789, s7_793);
  result.missing[9] = fma(work.s1_41, s7_792, s7_794);
  const double s7_795 = work.f_wheel_front_right_z + f_carrier_right_z;
  const double s7_796 = work.f_wheel_front_right_y + f_carrier_right_y;
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double s7_797 = fnma(work.R_carrier_right_aux1_y_x, s7_786, tau_carrier_right_rx);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s7_798 = fnma(work.R_carrier_right_aux1_z_x, s7_789, s7_797);
  result.missing[8] = fnma(R_carrier_right_aux1_x_x, s7_792, s7_798);
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s7_799 = fnma(work.R_carrier_right_aux1_y_z, s7_786, tau_carrier_right_rz);
  result.missing[7] = fnma(work.R_carrier_right_aux1_z_z, s7_789, s7_799);
  const double R_lower_arm_right_z_y = work.sines[9];
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s7_800 = -c_lower_arm_right_z*R_lower_arm_right_z_y;
  const double s7_801 = fma(c_lower_arm_right_y, R_lower_arm_right_y_y, s7_800);
  const double s7_802 = -c_lower_arm_right_z*R_lower_arm_right_y_y;
  const double s7_803 = fnma(c_lower_arm_right_y, R_lower_arm_right_z_y, s7_802);
  const double s7_804 = fnma(work.s7_94, s7_801, work.a_lower_arm_right_y);
  const double f_lower_arm_right_y = m_lower_arm_right*fnma(work.s7_92, s7_803, s7_804);
  const double s7_805 = fma(work.s7_91, s7_801, work.a_lower_arm_right_z);
  const double f_lower_arm_right_z = m_lower_arm_right*fma(work.s7_93, s7_803, s7_805);
  const double s7_806 = R_lower_arm_right_y_y*work.w_chassis_y;
  const double s7_807 = fma(R_lower_arm_right_z_y, work.w_chassis_z, s7_806);
  const double s7_808 = R_lower_arm_right_y_y*work.w_chassis_z;
  const double s7_809 = fnma(R_lower_arm_right_z_y, work.w_chassis_y, s7_808);
  const double s7_810 = I_lower_arm_right_xx*work.alpha_lower_arm_right_x;
  const double s7_811 = fma(s7_803, f_lower_arm_right_y, s7_810);
  const double s7_812 = fma(s7_801, f_lower_arm_right_z, s7_811);
  const double s7_813 = fma(s7_807, I_lower_arm_right_zz*s7_809, s7_812);
  const double n_lower_arm_right_x = fnma(s7_809, I_lower_arm_right_yy*s7_807, s7_813);
  const double s7_814 = fnma(work.s1_36, s7_795, tau[Coordinate::lower_arm_right] - s7_792);
  result.missing[6] = fnma(work.s1_38, s7_796, s7_814) - n_lower_arm_right_x;
  const double R_arb_front_left_x_x = work.cosines[8];
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double s7_815 = c_arb_front_left_z*R_arb_front_left_x_x;
  const double s7_816 = fnma(c_arb_front_left_x, R_arb_front_left_x_z, s7_815);
  const double s7_817 = c_arb_front_left_z*R_arb_front_left_x_z;
  const double s7_818 = fma(c_arb_front_left_x, R_arb_front_left_x_x, s7_817);
  const double s7_819 = fma(c_arb_front_left_y, work.s7_87, work.a_arb_front_left_x);
  const double s7_820 = fnma(work.s7_84, s7_818, fma(work.s7_81, s7_816, s7_819));
  const double s7_821 = fma(c_arb_front_left_y, work.s7_86, work.a_arb_front_left_z);
  const double s7_822 = fma(work.s7_82, s7_818, fnma(work.s7_83, s7_816, s7_821));
  const double s7_823 = R_arb_front_left_x_x*work.alpha_arb_front_left_x;
  const double s7_824 = R_arb_front_left_x_z*work.alpha_arb_front_left_x;
  const double s7_825 = R_arb_front_left_x_x*work.w_chassis_x;
  const double s7_826 = fnma(R_arb_front_left_x_z, work.w_chassis_z, s7_825);
  const double s7_827 = R_arb_front_left_x_z*work.w_chassis_x;
  const double s7_828 = fma(R_arb_front_left_x_x, work.w_chassis_z, s7_827);
  const double s7_829 = I_arb_front_left_xy*work.w_arb_front_left_y;
  const double s7_830 = fma(I_arb_front_left_xx, s7_826, s7_829);
  const double s7_831 = I_arb_front_left_xz*s7_826;
  const double s7_832 = fma(I_arb_front_left_yz, work.w_arb_front_left_y, s7_831);
  const double s7_833 = I_arb_front_left_yy*work.alpha_arb_front_left_y;
  const double s7_834 = fnma(work.s7_243, work.s7_267, fma(work.s7_241, work.s7_264, s7_833));
  const double s7_835 = fma(s7_816, m_arb_front_left*s7_820, s7_834);
  const double s7_836 = fnma(R_arb_front_left_x_z, work.alpha_arb_front_left_z, s7_823);
  const double s7_837 = fnma(s7_818, m_arb_front_left*s7_822, s7_835);
  const double s7_838 = fma(R_arb_front_left_x_x, work.alpha_arb_front_left_z, s7_824);
  const double s7_839 = fma(I_arb_front_left_xy, s7_836, s7_837);
  const double s7_840 = fma(I_arb_front_left_xz, s7_828, s7_830);
  const double s7_841 = fma(s7_828, s7_840, fma(I_arb_front_left_yz, s7_838, s7_839));
  const double n_arb_front_left_y = fnma(s7_826, fma(I_arb_front_left_zz, s7_828, s7_832), s7_841);
  const double Q_arb_front_left = tau[Coordinate::arb_front_left] - n_arb_front_left_y;
  result.missing[5] = Q_arb_front_left;
  const double R_upper_arm_left_z_y = work.sines[7];
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_842 = c_upper_arm_left_y*R_upper_arm_left_z_y;
  const double s7_843 = fma(c_upper_arm_left_z, R_upper_arm_left_y_y, s7_842);
  const double s7_844 = c_upper_arm_left_y*R_upper_arm_left_y_y;
  const double s7_845 = fnma(c_upper_arm_left_z, R_upper_arm_left_z_y, s7_844);
  const double s7_846 = fma(work.s7_72, s7_843, work.a_upper_arm_left_y);
  const double f_upper_arm_left_y = m_upper_arm_left*fnma(work.s7_74, s7_845, s7_846);
  const double s7_847 = fnma(work.s7_73, s7_843, work.a_upper_arm_left_z);
  const double f_upper_arm_left_z = m_upper_arm_left*fma(work.s7_71, s7_845, s7_847);
  const double s7_848 = R_upper_arm_left_y_y*work.w_chassis_y;
  const double s7_849 = fma(R_upper_arm_left_z_y, work.w_chassis_z, s7_848);
  const double s7_850 = R_upper_arm_left_y_y*work.w_chassis_z;
  const double s7_851 = fnma(R_upper_arm_left_z_y, work.w_chassis_y, s7_850);
  const double s7_852 = I_upper_arm_left_xx*work.alpha_upper_arm_left_x;
  const double s7_853 = fnma(s7_843, f_upper_arm_left_y, s7_852);
  const double s7_854 = fma(s7_845, f_upper_arm_left_z, s7_853);
  const double s7_855 = fma(s7_849, I_upper_arm_left_zz*s7_851, s7_854);
  const double n_upper_arm_left_x = fnma(s7_851, I_upper_arm_left_yy*s7_849, s7_855);
  const double Q_upper_arm_left = tau[Coordinate::upper_arm_left] - n_upper_arm_left_x;
  result.missing[4] = Q_upper_arm_left;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double f_wheel_front_left_x = m_wheel_front_left*work.a_wheel_front_left_x;
  const double f_wheel_front_left_y = m_wheel_front_left*work.a_wheel_front_left_y;
  const double f_wheel_front_left_z = m_wheel_front_left*work.a_wheel_front_left_z;
  const double s7_856 = work.R_carrier_left_x_z*work.alpha_wheel_front_left_x;
  const double s7_857 = fma(work.R_carrier_left_y_z, work.alpha_wheel_front_left_y, s7_856);
  const double s7_858 = work.R_carrier_left_x_x*work.w_wheel_front_left_x;
  const double s7_859 = fma(work.R_carrier_left_y_x, work.w_wheel_front_left_y, s7_858);
  const double s7_860 = fma(work.R_carrier_left_z_x, work.w_wheel_front_left_z, s7_859);
  const double s7_861 = work.R_carrier_left_aux2_y_y*work.w_wheel_front_left_y;
  const double s7_862 = fnma(work.s1_22, work.w_wheel_front_left_x, s7_861);
  const double s7_863 = fma(work.R_carrier_left_aux2_z_y, work.w_wheel_front_left_z, s7_862);
  const double s7_864 = I_wheel_front_left_yy*s7_863;
  const double s7_865 = I_wheel_front_left_xx*s7_860;
  const double s7_866 = fma(work.R_carrier_left_z_z, work.alpha_wheel_front_left_z, s7_857);
  const double s7_867 = fnma(s7_863, s7_865, fma(s7_860, s7_864, I_wheel_front_left_zz*s7_866));
  const double s7_868 = work.R_carrier_left_x_x*work.alpha_wheel_front_left_x;
  const double s7_869 = fma(work.R_carrier_left_y_x, work.alpha_wheel_front_left_y, s7_868);
  const double s7_870 = work.R_carrier_left_x_z*work.w_wheel_front_left_x;
  const double s7_871 = fma(work.R_carrier_left_y_z, work.w_wheel_front_left_y, s7_870);
  const double s7_872 = fma(work.R_carrier_left_z_z, work.w_wheel_front_left_z, s7_871);
  const double s7_873 = I_wheel_front_left_zz*s7_872;
  const double s7_874 = fma(work.R_carrier_left_z_x, work.alpha_wheel_front_left_z, s7_869);
  const double s7_875 = fma(s7_863, s7_873, fnma(s7_864, s7_872, I_wheel_front_left_xx*s7_874));
  const double s7_876 = work.R_carrier_left_aux2_y_y*work.alpha_wheel_front_left_y;
  const double s7_877 = fnma(work.s1_22, work.alpha_wheel_front_left_x, s7_876);
  const double s7_878 = fma(work.R_carrier_left_aux2_z_y, work.alpha_wheel_front_left_z, s7_877);
  const double s7_879 = fma(I_wheel_front_left_yy, s7_878, fnma(s7_860, s7_873, s7_865*s7_872));
  const double s7_880 = fma(work.R_carrier_left_x_x, s7_875, work.R_carrier_left_x_z*s7_867);
  const double n_wheel_front_left_x = fnma(work.s1_22, s7_879, s7_880);
  const double s7_881 = fma(work.R_carrier_left_y_x, s7_875, work.R_carrier_left_y_z*s7_867);
  const double n_wheel_front_left_y = fma(work.R_carrier_left_aux2_y_y, s7_879, s7_881);
  const double s7_882 = fma(work.R_carrier_left_z_x, s7_875, work.R_carrier_left_z_z*s7_867);
  const double n_wheel_front_left_z = fma(work.R_carrier_left_aux2_z_y, s7_879, s7_882);
  const double s7_883 = c_carrier_left_y*work.R_carrier_left_aux2_y_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_884 = fma(c_carrier_left_x, work.R_carrier_left_y_x, s7_883);
  const double s7_885 = fma(c_carrier_left_z, work.R_carrier_left_y_z, s7_884);
  const double s7_886 = c_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_887 = fma(c_carrier_left_x, work.R_carrier_left_z_x, s7_886);
  const double s7_888 = fma(c_carrier_left_z, work.R_carrier_left_z_z, s7_887);
  const double s7_889 = c_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_890 = fnma(c_carrier_left_y, work.s1_22, s7_889);
  const double s7_891 = fma(c_carrier_left_x, work.R_carrier_left_x_x, s7_890);
  const double s7_892 = fma(work.s7_57, s7_885, work.a_carrier_left_aux1_x);
  const double s7_893 = m_carrier_left*fnma(work.s7_51, s7_891, fma(work.s7_55, s7_888, s7_892));
  const double s7_894 = fnma(work.s7_53, s7_885, work.a_carrier_left_aux1_y);
  const double s7_895 = m_carrier_left*fma(work.s7_54, s7_891, fma(work.s7_59, s7_888, s7_894));
  const double f_carrier_left_y = s7_895 + (work.s7_261 + work.s7_326);
  const double s7_896 = fma(work.s7_56, s7_885, work.a_carrier_left_aux1_z);
  const double s7_897 = m_carrier_left*fma(work.s7_58, s7_891, fnma(work.s7_52, s7_888, s7_896));
  const double f_carrier_left_z = s7_897 + (work.s7_258 + work.s7_322);
  const double s7_898 = work.R_carrier_left_x_z*work.alpha_carrier_left_x;
  const double s7_899 = fma(work.R_carrier_left_y_z, work.alpha_carrier_left_y, s7_898);
  const double s7_900 = fma(work.R_carrier_left_z_z, work.alpha_carrier_left_z, s7_899);
  const double s7_901 = work.R_carrier_left_x_x*work.alpha_carrier_left_x;
  const double s7_902 = fma(work.R_carrier_left_y_x, work.alpha_carrier_left_y, s7_901);
  const double s7_903 = fma(work.R_carrier_left_z_x, work.alpha_carrier_left_z, s7_902);
  const double s7_904 = work.R_carrier_left_aux2_y_y*work.alpha_carrier_left_y;
  const double s7_905 = fnma(work.s1_22, work.alpha_carrier_left_x, s7_904);
  const double s7_906 = fma(work.R_carrier_left_aux2_z_y, work.alpha_carrier_left_z, s7_905);
  const double s7_907 = work.R_carrier_left_x_x*work.w_carrier_left_x;
  const double s7_908 = fma(work.R_carrier_left_y_x, work.w_carrier_left_y, s7_907);
  const double s7_909 = fma(work.R_carrier_left_z_x, work.w_carrier_left_z, s7_908);
  const double s7_910 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_y;
  const double s7_911 = fnma(work.s1_22, work.w_carrier_left_x, s7_910);
  const double s7_912 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s7_911);
  const double s7_913 = work.R_carrier_left_x_z*work.w_carrier_left_x;
  const double s7_914 = fma(work.R_carrier_left_y_z, work.w_carrier_left_y, s7_913);
  const double s7_915 = fma(work.R_carrier_left_z_z, work.w_carrier_left_z, s7_914);
  const double s7_916 = fma(I_carrier_left_xy, s7_909, I_carrier_left_yy*s7_912);
  const double s7_917 = fma(I_carrier_left_yz, s7_915, s7_916);
  const double s7_918 = fma(I_carrier_left_xy, s7_912, I_carrier_left_xx*s7_909);
  const double s7_919 = fma(I_carrier_left_xz, s7_915, s7_918);
  const double s7_920 = fma(I_carrier_left_xz, s7_903, I_carrier_left_zz*s7_900);
  const double s7_921 = fma(s7_909, s7_917, fma(I_carrier_left_yz, s7_906, s7_920));
  const double s7_922 = fnma(s7_912, s7_919, s7_921);
  const double s7_923 = fma(I_carrier_left_xz, s7_909, I_carrier_left_zz*s7_915);
  const double s7_924 = fma(I_carrier_left_yz, s7_912, s7_923);
  const double s7_925 = fma(I_carrier_left_xz, s7_900, I_carrier_left_xx*s7_903);
  const double s7_926 = fnma(s7_915, s7_917, fma(I_carrier_left_xy, s7_906, s7_925));
  const double s7_927 = fma(s7_912, s7_924, s7_926);
  const double s7_928 = fma(I_carrier_left_yz, s7_900, I_carrier_left_yy*s7_906);
  const double s7_929 = fma(s7_915, s7_919, fma(I_carrier_left_xy, s7_903, s7_928));
  const double s7_930 = fnma(s7_909, s7_924, s7_929);
  const double s7_931 = fnma(work.s7_249, work.s7_261, work.s7_252*work.s7_258);
  const double s7_932 = fnma(work.s7_318, work.s7_326, fma(work.s7_320, work.s7_322, s7_931));
  const double s7_933 = fma(s7_885, s7_897, fnma(s7_888, s7_895, s7_932));
  const double s7_934 = fma(work.R_carrier_left_x_z, s7_922, s7_933);
  const double n_carrier_left_x = fnma(work.s1_22, s7_930, fma(work.R_carrier_left_x_x, s7_927,
      s7_934));
  const double s7_935 = fnma(work.s7_246, work.s7_258, work.s7_249*work.s7_255);
  const double s7_936 = fma(work.s7_318, work.s7_324, fnma(work.s7_316, work.s7_322, s7_935));
  const double s7_937 = fnma(s7_891, s7_897, fma(s7_888, s7_893, s7_936));
  const double s7_938 = fma(work.R_carrier_left_y_z, s7_922, s7_937);
  const double s7_939 = fma(work.R_carrier_left_y_x, s7_927, s7_938);
  const double n_carrier_left_y = fma(work.R_carrier_left_aux2_y_y, s7_930, s7_939);
  const double s7_940 = fnma(work.s7_252, work.s7_255, work.s7_246*work.s7_261);
  const double s7_941 = fma(work.s7_316, work.s7_326, fnma(work.s7_320, work.s7_324, s7_940));
  const double s7_942 = fma(s7_891, s7_895, fnma(s7_885, s7_893, s7_941));
  const double s7_943 = fma(work.R_carrier_left_z_z, s7_922, s7_942);
  const double s7_944 = fma(work.R_carrier_left_z_x, s7_927, s7_943);
  const double n_carrier_left_z = fma(work.R_carrier_left_aux2_z_y, s7_930, s7_944);
  const double s7_945 = fnma(work.s1_27, f_wheel_front_left_z, work.s1_31*f_wheel_front_left_x);
  const double s7_946 = n_carrier_left_y + (n_wheel_front_left_y + s7_945);
  const double s7_947 = fnma(work.s1_29, f_wheel_front_left_x, work.s1_27*f_wheel_front_left_y);
  const double s7_948 = n_carrier_left_z + (n_wheel_front_left_z + s7_947);
  const double s7_949 = fnma(work.s1_31, f_wheel_front_left_y, work.s1_29*f_wheel_front_left_z);
  const double s7_950 = n_carrier_left_x + (n_wheel_front_left_x + s7_949);
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double s7_951 = fnma(work.R_carrier_left_aux2_y_y, s7_946, tau_carrier_left_ry);
  const double s7_952 = fnma(work.R_carrier_left_aux2_z_y, s7_948, s7_951);
  result.missing[3] = fma(work.s1_22, s7_950, s7_952);
  const double s7_953 = f_wheel_front_left_z + f_carrier_left_z;
  const double s7_954 = f_wheel_front_left_y + f_carrier_left_y;
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double s7_955 = fnma(work.R_carrier_left_aux1_y_x, s7_946, tau_carrier_left_rx);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s7_956 = fnma(work.R_carrier_left_aux1_z_x, s7_948, s7_955);
  result.missing[2] = fnma(R_carrier_left_aux1_x_x, s7_950, s7_956);
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s7_957 = fnma(work.R_carrier_left_aux1_y_z, s7_946, tau_carrier_left_rz);
  result.missing[1] = fnma(work.R_carrier_left_aux1_z_z, s7_948, s7_957);
  const double R_lower_arm_left_z_y = work.sines[3];
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s7_958 = c_lower_arm_left_y*R_lower_arm_left_z_y;
  const double s7_959 = fma(c_lower_arm_left_z, R_lower_arm_left_y_y, s7_958);
  const double s7_960 = c_lower_arm_left_y*R_lower_arm_left_y_y;
  const double s7_961 = fnma(c_lower_arm_left_z, R_lower_arm_left_z_y, s7_960);
  const double s7_962 = fma(work.s7_28, s7_959, work.a_lower_arm_left_y);
  const double f_lower_arm_left_y = m_lower_arm_left*fnma(work.s7_30, s7_961, s7_962);
  const double s7_963 = fnma(work.s7_29, s7_959, work.a_lower_arm_left_z);
  const double f_lower_arm_left_z = m_lower_arm_left*fma(work.s7_27, s7_961, s7_963);
  const double s7_964 = R_lower_arm_left_y_y*work.w_chassis_y;
  const double s7_965 = fma(R_lower_arm_left_z_y, work.w_chassis_z, s7_964);
  const double s7_966 = R_lower_arm_left_y_y*work.w_chassis_z;
  const double s7_967 = fnma(R_lower_arm_left_z_y, work.w_chassis_y, s7_966);
  const double s7_968 = I_lower_arm_left_xx*work.alpha_lower_arm_left_x;
  const double s7_969 = fnma(s7_959, f_lower_arm_left_y, s7_968);
  const double s7_970 = fma(s7_961, f_lower_arm_left_z, s7_969);
  const double s7_971 = fma(s7_965, I_lower_arm_left_zz*s7_967, s7_970);
  const double n_lower_arm_left_x = fnma(s7_967, I_lower_arm_left_yy*s7_965, s7_971);
  const double s7_972 = fnma(work.s1_18, s7_953, tau[Coordinate::lower_arm_left] - s7_950);
  result.missing[0] = fma(work.s1_20, s7_954, s7_972) - n_lower_arm_left_x;
  // operations: 1158 add, 1371 multiply

  // --- step 9: multipliers of the closures and driving forces ---
  const double pivot_carrier_left_rx = fms(p_carrier_left_upper_ball_z, work.R_carrier_left_z_z,
      work.s7_308);
  // upper_ball_left
  const double s9_1 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s9_2 = fma(p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s9_1);
  const double s9_3 = fma(p_carrier_left_upper_ball_z, work.R_carrier_left_x_z, work.s7_314);
  const double s9_4 = fms(p_carrier_left_upper_ball_z, work.R_carrier_left_y_z, work.s7_309);
  const double pivot_carrier_right_rx = fma(p_carrier_right_upper_ball_z, work.R_carrier_right_z_z,
      work.s7_339);
  // upper_ball_right
  const double s9_5 = fma(p_carrier_right_upper_ball_z, work.R_carrier_right_y_z, work.s7_343);
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double R_upper_arm_right_z_y = work.sines[13];
  const double s9_6 = -p_upper_arm_right_ball_z*R_upper_arm_right_y_y;
  const double s9_7 = fnma(p_upper_arm_right_ball_y, R_upper_arm_right_z_y, s9_6);
  const double s9_8 = fms(p_carrier_right_upper_ball_z, work.R_carrier_right_x_z, work.s7_334);
  // arb_link_front_left
  const double s9_9 = 0.35 + work.s7_243 - work.s7_246;
  const double s9_10 = work.s7_241 + p_arb_front_left_z - work.r_carrier_left_aux1_z;
  const double s9_11 = s9_10 - work.s7_249;
  const double pivot_arb_front_left = fnma(work.s7_243, s9_11, work.s7_241*s9_9);
  // arb_link_front_left
  const double s9_12 = 0.72 - work.r_carrier_left_aux1_y - work.s7_252;
  const double s9_13 = fnma(work.s7_252, s9_9, work.s7_246*s9_12);
  const double s9_14 = fnma(work.s7_246, s9_11, work.s7_249*s9_9);
  const double s9_15 = fnma(work.s7_249, s9_12, work.s7_252*s9_11);
  // arb_link_front_right
  const double s9_16 = 0.35 + work.s7_271 - work.s7_274;
  const double s9_17 = work.s7_269 + (work.s1_39 + p_arb_front_right_z) - work.s7_277;
  const double pivot_arb_front_right = fnma(work.s7_271, s9_17, work.s7_269*s9_16);
  // arb_link_front_right
  const double s9_18 = work.s7_280 + (0.72 + work.r_carrier_right_aux1_y);
  const double s9_19 = fma(work.s7_277, s9_18, work.s7_280*s9_17);
  const double s9_20 = fma(work.s7_274, s9_18, work.s7_280*s9_16);
  const double s9_21 = fnma(work.s7_274, s9_17, work.s7_277*s9_16);
  // drag_link
  const double s9_22 = 0.2 - work.s7_297;
  const double s9_23 = work.s7_298 + (1.15 - work.s7_296);
  const double pivot_pitman_arm = fnma(work.s7_297, s9_23, work.s7_296*s9_22);
  // tie_rod_left
  const double s9_24 = work.s7_318 + (work.r_carrier_left_aux1_z - p_bell_crank_z);
  const double s9_25 = work.s7_313 - work.r_carrier_left_aux1_y - work.s7_320;
  const double s9_26 = work.s7_316 + (0.35 + work.s7_312);
  const double s9_27 = fnma(work.s7_318, s9_26, work.s7_316*s9_24);
  const double s9_28 = fma(work.s7_318, s9_25, work.s7_320*s9_24);
  // tie_rod_right
  const double s9_29 = work.s7_342 + (-p_bell_crank_z - work.s1_39);
  const double s9_30 = work.s7_346 + (work.r_carrier_right_aux1_y + work.s7_333);
  const double s9_31 = work.s7_335 - 0.35 - work.s7_338;
  const double s9_32 = fma(work.s7_342, s9_31, work.s7_338*s9_29);
  const double s9_33 = fnma(work.s7_346, s9_29, work.s7_342*s9_30);
  const double s9_34 = 1.0/pivot_carrier_right_rx;
  const double s9_35 = s9_32*s9_34;
  const double pivot_carrier_right_ry = fnma(s9_5, s9_35, fma(work.s7_346, s9_31,
      work.s7_338*s9_30));
  const double s9_36 = 1.0/pivot_carrier_right_ry;
  const double s9_37 = s9_8*s9_36;
  const double pivot_carrier_right_rz = fms(s9_33, s9_37, pivot_carrier_right_rx);
  const double s9_38 = s9_8*s9_34;
  const double s9_39 = s9_36*(s9_5*s9_38);
  const double s9_40 = 1.0/pivot_carrier_right_rz;
  const double s9_41 = fnma(s9_33, s9_39, s9_5)*s9_40;
  const double s9_42 = -p_upper_arm_right_ball_y*R_upper_arm_right_y_y;
  const double s9_43 = fma(p_upper_arm_right_ball_z, R_upper_arm_right_z_y, s9_42);
  const double pivot_upper_arm_right = fma(s9_7, s9_41, s9_43);
  const double s9_44 = 1.0/pivot_carrier_left_rx;
  const double s9_45 = s9_27*s9_44;
  const double s9_46 = fma(s9_4, s9_45, fma(work.s7_320, s9_26, work.s7_316*s9_25));
  const double s9_47 = 1.0/s9_46;
  const double s9_48 = s9_3*s9_47;
  const double pivot_carrier_left_rz = fms(s9_28, s9_48, pivot_carrier_left_rx);
  const double s9_49 = s9_3*s9_44;
  const double s9_50 = s9_47*(s9_4*s9_49);
  const double s9_51 = 1.0/pivot_carrier_left_rz;
  const double s9_52 = fnma(s9_28, s9_50, s9_4)*s9_51;
  const double s9_53 = p_upper_arm_left_ball_y*R_upper_arm_left_y_y;
  const double s9_54 = fnma(p_upper_arm_left_ball_z, R_upper_arm_left_z_y, s9_53);
  const double s9_55 = fma(s9_2, s9_52, s9_54);
  const double s9_56 = 16.504892200367603*std::abs(pivot_arb_front_right);
  const double s9_57 = mbgen::min(3.9625229801272064*std::abs(pivot_pitman_arm), s9_56);
  const double s9_58 = mbgen::min(16.679425973935604*std::abs(pivot_arb_front_left), s9_57);
  const double s9_59 = mbgen::min(2.7028647671567816*std::abs(pivot_carrier_right_rx), s9_58);
  const double s9_60 = mbgen::min(s9_59, 6.8514628664707224*std::abs(pivot_carrier_right_ry));
  const double s9_61 = mbgen::min(s9_60, 2.7028647671567816*std::abs(pivot_carrier_right_rz));
  const double s9_62 = mbgen::min(s9_61, 3.405476531191585*std::abs(pivot_upper_arm_right));
  const double s9_63 = mbgen::min(2.7028219055711094*std::abs(pivot_carrier_left_rx), s9_62);
  const double s9_64 = mbgen::min(6.915894223167946*std::abs(s9_46), s9_63);
  const double s9_65 = mbgen::min(2.7028219055711094*std::abs(pivot_carrier_left_rz), s9_64);
  const double s9_66 = mbgen::min(3.3636363636363633*std::abs(s9_55), s9_65);
  const double s9_67 = mbgen::min(s9_66, std::abs(work.s1_75));
  result.pivot[0] = mbgen::min(s9_67, std::abs(work.s1_92));
  const double s9_68 = Q_arb_front_left*(1.0/pivot_arb_front_left);
  result.lambda[6] = l_arb_link_front_left*s9_68;
  const double s9_69 = work.Q_arb_front_right*(1.0/pivot_arb_front_right);
  result.lambda[7] = l_arb_link_front_right*s9_69;
  result.lambda[8] = l_drag_link*(work.Q_pitman_arm*(1.0/pivot_pitman_arm));
  const double s9_70 = fms(tau_carrier_left_rx, work.R_carrier_left_aux1_y_x, s7_946);
  const double s9_71 = fma(tau_carrier_left_ry, work.s1_77, s9_70);
  const double s9_72 = s9_44*fma(s9_14, s9_68, fnma(tau_carrier_left_rz, work.s1_86, s9_71));
  const double s9_73 = fms(tau_carrier_right_rx, work.R_carrier_right_aux1_y_x, s7_786);
  const double s9_74 = fma(tau_carrier_right_ry, work.s1_94, s9_73);
  const double s9_75 = s9_34*fma(s9_21, s9_69, fnma(tau_carrier_right_rz, work.s1_103, s9_74));
  const double s9_76 = fms(tau_carrier_left_rx, work.R_carrier_left_aux1_z_x, s7_948);
  const double s9_77 = fma(tau_carrier_left_rz, work.s1_78, s9_76);
  const double s9_78 = fma(s9_13, s9_68, fnma(tau_carrier_left_ry, work.s1_85, s9_77));
  const double s9_79 = s9_47*fma(s9_4, s9_72, s9_78);
  const double s9_80 = fms(tau_carrier_right_rx, work.R_carrier_right_aux1_z_x, s7_789);
  const double s9_81 = fma(tau_carrier_right_rz, work.s1_95, s9_80);
  const double s9_82 = fnma(s9_20, s9_69, fnma(tau_carrier_right_ry, work.s1_102, s9_81));
  const double s9_83 = s9_36*fma(s9_5, s9_75, s9_82);
  const double s9_84 = fms(tau_carrier_right_rx, R_carrier_right_aux1_x_x, s7_792);
  const double s9_85 = fma(tau_carrier_right_ry, work.s1_98, s9_84);
  const double s9_86 = fma(s9_19, s9_69, fma(tau_carrier_right_rz, work.s1_101, s9_85));
  const double s9_87 = s9_40*fma(s9_33, s9_83, s9_86);
  const double s9_88 = fms(tau_carrier_left_rx, R_carrier_left_aux1_x_x, s7_950);
  const double s9_89 = fma(tau_carrier_left_ry, work.s1_81, s9_88);
  const double s9_90 = fma(s9_15, s9_68, fma(tau_carrier_left_rz, work.s1_84, s9_89));
  const double s9_91 = s9_51*fma(s9_28, s9_79, s9_90);
  const double s9_92 = 1.0/s9_55*fnma(s9_2, s9_91, Q_upper_arm_left);
  result.lambda[2] = -s9_92;
  const double s9_93 = 1.0/pivot_upper_arm_right*fma(s9_7, s9_87, work.Q_upper_arm_right);
  result.lambda[5] = s9_93;
  const double s9_94 = fma(s9_52, s9_92, s9_91);
  result.lambda[1] = s9_94;
  const double s9_95 = fnma(s9_41, s9_93, s9_87);
  result.lambda[4] = s9_95;
  const double s9_96 = fma(s9_48, s9_94, fms(s9_50, s9_92, s9_79));
  result.lambda[9] = l_tie_rod_left*s9_96;
  const double s9_97 = fnma(s9_37, s9_95, fma(s9_39, s9_93, s9_83));
  result.lambda[10] = l_tie_rod_right*s9_97;
  result.lambda[0] = fma(s9_45, s9_96, fnma(s9_49, s9_92, s9_72));
  result.lambda[3] = fma(s9_35, s9_97, fma(s9_38, s9_93, s9_75));
  // long_rod_left
  const double s9_98 = work.r_rear_axle_aux3_z - p_long_rod_left_from_z;
  const double s9_99 = work.s7_363 + s9_98;
  const double s9_100 = work.r_rear_axle_aux1_x - p_long_rod_left_from_x;
  const double s9_101 = work.s7_366 + s9_100;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_102 = p_long_rod_left_from_y - z_rear_axle_ty - work.s7_369;
  // diag_rod_left
  const double s9_103 = work.r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  const double s9_104 = work.s7_381 + s9_103;
  const double s9_105 = work.r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  const double s9_106 = work.s7_383 + s9_105;
  const double s9_107 = p_diag_rod_left_from_y - z_rear_axle_ty - work.s7_385;
  // arb_link_rear_left
  const double s9_108 = work.r_rear_axle_aux3_z - p_arb_rear_left_z;
  const double s9_109 = s9_108 + (work.s7_394 + work.s7_402);
  const double s9_110 = 0.6 - z_rear_axle_ty - work.s7_404;
  const double s9_111 = work.s7_401 + p_arb_rear_left_x - work.r_rear_axle_aux1_x - work.s7_403;
  // long_rod_right
  const double s9_112 = work.s7_422 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s9_113 = work.s7_420 + s9_98;
  const double s9_114 = work.s7_421 + s9_100;
  const double pivot_rear_axle_tx = work.s7_429 + s9_105;
  // diag_rod_right
  const double s9_115 = work.s7_428 + s9_103;
  const double s9_116 = work.s7_430 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  const double s9_117 = fnma(work.s7_430, s9_115, work.s7_428*s9_116);
  const double s9_118 = fnma(work.s7_428, pivot_rear_axle_tx, work.s7_429*s9_115);
  const double s9_119 = fnma(work.s7_429, s9_116, work.s7_430*pivot_rear_axle_tx);
  // arb_link_rear_right
  const double s9_120 = 0.6 + z_rear_axle_ty - work.s7_435;
  const double s9_121 = s9_108 + (work.s7_438 - work.s7_437);
  const double s9_122 = work.s7_436 + p_arb_rear_right_x - work.r_rear_axle_aux1_x;
  const double s9_123 = work.s7_439 + s9_122;
  const double s9_124 = 1.0/pivot_rear_axle_tx;
  const double s9_125 = s9_106*s9_124;
  const double s9_126 = fma(s9_116, s9_125, s9_107);
  const double s9_127 = s9_101*s9_124;
  const double s9_128 = fnma(work.s7_383, s9_107, fnma(work.s7_385, s9_106, s9_119*s9_125));
  const double s9_129 = 1.0/s9_126;
  const double s9_130 = fma(s9_116, s9_127, s9_102)*s9_129;
  const double s9_131 = fnma(work.s7_366, s9_102, fnma(work.s7_369, s9_101, s9_119*s9_127));
  const double pivot_rear_axle_rx = fnma(s9_128, s9_130, s9_131);
  const double s9_132 = s9_114*s9_124;
  const double s9_133 = fma(s9_118, s9_125, fnma(work.s7_383, s9_104, work.s7_381*s9_106));
  const double s9_134 = s9_129*fnma(s9_116, s9_132, s9_112);
  const double s9_135 = fma(s9_118, s9_127, fnma(work.s7_366, s9_99, work.s7_363*s9_101));
  const double s9_136 = fnma(s9_130, s9_133, s9_135);
  const double s9_137 = fma(s9_119, s9_132, fnma(work.s7_422, s9_114, work.s7_421*s9_112));
  const double s9_138 = 1.0/pivot_rear_axle_rx;
  const double s9_139 = fma(s9_128, s9_134, s9_137)*s9_138;
  const double s9_140 = fma(s9_118, s9_132, fnma(work.s7_421, s9_113, work.s7_420*s9_114));
  const double pivot_rear_axle_ry = fnma(s9_136, s9_139, fma(s9_133, s9_134, s9_140));
  const double s9_141 = fma(s9_117, s9_125, fma(work.s7_381, s9_107, work.s7_385*s9_104));
  const double s9_142 = s9_123*s9_124;
  const double s9_143 = s9_129*fma(s9_116, s9_142, s9_120);
  const double s9_144 = fma(s9_117, s9_127, fma(work.s7_363, s9_102, work.s7_369*s9_99));
  const double s9_145 = fnma(s9_130, s9_141, s9_144);
  const double s9_146 = fnma(work.s7_435, s9_123, fnma(work.s7_436, s9_120, s9_128*s9_143));
  const double s9_147 = s9_138*fnma(s9_119, s9_142, s9_146);
  const double s9_148 = fma(s9_117, s9_132, fnma(work.s7_420, s9_112, work.s7_422*s9_113));
  const double s9_149 = fnma(s9_139, s9_145, fma(s9_134, s9_141, s9_148));
  const double s9_150 = fnma(s9_118, s9_142, fma(work.s7_437, s9_123, work.s7_436*s9_121));
  const double s9_151 = 1.0/pivot_rear_axle_ry;
  const double s9_152 = fnma(s9_136, s9_147, fma(s9_133, s9_143, s9_150))*s9_151;
  const double s9_153 = fnma(s9_117, s9_142, fnma(work.s7_435, s9_121, work.s7_437*s9_120));
  const double pivot_rear_axle_rz = fnma(s9_149, s9_152, fnma(s9_145, s9_147, fma(s9_141, s9_143,
      s9_153)));
  const double s9_154 = s9_111*s9_124;
  const double s9_155 = fnma(s9_115, s9_125, s9_104);
  const double s9_156 = s9_129*fms(s9_116, s9_154, s9_110);
  const double s9_157 = fnma(s9_130, s9_155, fnma(s9_115, s9_127, s9_99));
  const double s9_158 = fnma(s9_119, s9_154, fnma(work.s7_403, s9_110, work.s7_404*s9_111));
  const double s9_159 = s9_138*fma(s9_128, s9_156, s9_158);
  const double s9_160 = fnma(s9_139, s9_157, fma(s9_134, s9_155, fnma(s9_115, s9_132, s9_113)));
  const double s9_161 = fnma(work.s7_402, s9_111, fnma(work.s7_403, s9_109, s9_133*s9_156));
  const double s9_162 = s9_151*fnma(s9_136, s9_159, fnma(s9_118, s9_154, s9_161));
  const double s9_163 = fnma(s9_147, s9_157, fma(s9_143, s9_155, fma(s9_115, s9_142, s9_121)));
  const double s9_164 = fnma(s9_152, s9_160, s9_163);
  const double s9_165 = fnma(s9_117, s9_154, fma(work.s7_402, s9_110, work.s7_404*s9_109));
  const double s9_166 = 1.0/pivot_rear_axle_rz;
  const double s9_167 = fnma(s9_149, s9_162, fnma(s9_145, s9_159, fma(s9_141, s9_156, s9_165)));
  const double s9_168 = s9_167*s9_166;
  const double s9_169 = fnma(s9_157, s9_159, fma(s9_155, s9_156, fma(s9_115, s9_154, s9_109)));
  const double pivot_rear_axle_tz = fnma(s9_164, s9_168, fnma(s9_160, s9_162, s9_169));
  const double s9_170 = 1.2494533266510743*std::abs(pivot_rear_axle_tx);
  const double s9_171 = mbgen::min(s9_170, 1.665350081353039*std::abs(s9_126));
  const double s9_172 = mbgen::min(s9_171, 2.1234888829989926*std::abs(pivot_rear_axle_rx));
  const double s9_173 = mbgen::min(s9_172, 1.7864443153153613*std::abs(pivot_rear_axle_ry));
  const double s9_174 = mbgen::min(s9_173, 8.176955428452642*std::abs(pivot_rear_axle_rz));
  const double s9_175 = mbgen::min(s9_174, 2.7700489841913827*std::abs(pivot_rear_axle_tz));
  result.pivot[1] = mbgen::min(s9_175, std::abs(work.s1_109));
  const double s9_176 = work.Q_rear_axle_tx*s9_124;
  const double s9_177 = s9_129*fnma(s9_116, s9_176, work.Q_rear_axle_ty);
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double s9_178 = fnma(tau_rear_axle_ry, work.s1_62, tau_rear_axle_rx*work.s1_111);
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s9_179 = fnma(tau_rear_axle_rz, work.s1_118, s9_178 - work.s7_610);
  const double s9_180 = s9_138*fma(s9_128, s9_177, fma(s9_119, s9_176, s9_179));
  const double s9_181 = fms(tau_rear_axle_ry, work.cosines[17], work.s7_607);
  const double s9_182 = fma(tau_rear_axle_rx, work.s1_114, s9_181);
  const double s9_183 = fma(s9_118, s9_176, fma(tau_rear_axle_rz, work.s1_116, s9_182));
  const double s9_184 = s9_151*fnma(s9_136, s9_180, fma(s9_133, s9_177, s9_183));
  const double s9_185 = fnma(tau_rear_axle_ry, work.s1_60, tau_rear_axle_rz*work.s1_112);
  const double s9_186 = fnma(tau_rear_axle_rx, work.s1_117, s9_185 - work.s7_613);
  const double s9_187 = fnma(s9_145, s9_180, fma(s9_141, s9_177, fma(s9_117, s9_176, s9_186)));
  const double s9_188 = s9_166*fnma(s9_149, s9_184, s9_187);
  const double s9_189 = fma(s9_155, s9_177, fnma(s9_115, s9_176, work.Q_rear_axle_tz));
  const double s9_190 = fnma(s9_164, s9_188, fnma(s9_160, s9_184, fnma(s9_157, s9_180, s9_189)));
  const double s9_191 = 1.0/pivot_rear_axle_tz*s9_190;
  result.lambda[13] = l_arb_link_rear_left*s9_191;
  const double s9_192 = fnma(s9_168, s9_191, s9_188);
  result.lambda[16] = l_arb_link_rear_right*s9_192;
  const double s9_193 = fnma(s9_152, s9_192, fnma(s9_162, s9_191, s9_184));
  result.lambda[14] = l_long_rod_right*s9_193;
  const double s9_194 = fnma(s9_139, s9_193, fnma(s9_147, s9_192, fnma(s9_159, s9_191, s9_180)));
  result.lambda[11] = l_long_rod_left*s9_194;
  const double s9_195 = fma(s9_134, s9_193, fma(s9_143, s9_192, fms(s9_156, s9_191, s9_177)));
  const double s9_196 = fnma(s9_130, s9_194, s9_195);
  result.lambda[12] = l_diag_rod_left*s9_196;
  const double s9_197 = fnma(s9_132, s9_193, fma(s9_142, s9_192, fma(s9_154, s9_191, s9_176)));
  result.lambda[15] = l_diag_rod_right*fnma(s9_125, s9_196, fnma(s9_127, s9_194, s9_197));
  // operations: 249 add, 294 multiply, 17 divide, 38 other
}

/// Multipliers of the closures and generalised driving forces, at given accelerations.
void compute_multipliers(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    const double* tau, const Derivative& derivative, ConstraintForces& __restrict result) noexcept {
  ConstraintForcesWork work;
  compute_multipliers_1(state, derivative, work);
  compute_multipliers_2(state, tau, derivative, work, result);
  compute_multipliers_3(state, tau, work, result);
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
struct ClosureTermsWork {
  double
      sines[19], cosines[19], r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux4_z_z, s1_27,
      R_rear_axle_aux4_x_z, s1_29, R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, R_rear_axle_aux5_z_x,
      R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z, R_rear_axle_z_y,
      R_rear_axle_z_z, s4_23, s4_24, s4_25, s4_26, s4_27, s4_28, s4_29, s4_30, s4_31, s4_32, s4_33,
      s4_34, s4_35;
};

/// Part 1 of compute_closure_terms: step 1: poses and axes b; step 4: velocities; step 2: closure
/// Jacobian Phi_z and its factors (60).
[[gnu::noinline]] void compute_closure_terms_1(const State& state,
    ClosureTermsWork& __restrict work, ClosureTerms& __restrict result) noexcept {
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
  mbgen::sincos(angles, work.sines, work.cosines);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = work.sines[0];
  const double R_lower_arm_left_y_z = -R_lower_arm_left_z_y;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_1 = state.charts[1] - 0.5;
  const double R_lower_arm_left_y_y = work.cosines[0];
  const double R_carrier_left_aux1_z_z = (s1_1 >= 0.0 ? R_lower_arm_left_y_z :
      R_lower_arm_left_y_y);
  const double s1_2 = work.sines[1];
  const double R_carrier_left_aux1_y_x = s1_2*R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_x_x = work.cosines[1];
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
  const double s1_8 = work.cosines[2];
  const double s1_9 = s1_2*s1_8;
  const double s1_10 = work.sines[2];
  const double R_carrier_left_aux2_x_z = s1_2*s1_10;
  const double R_carrier_left_aux2_y_y = fma(R_carrier_left_aux1_y_z, s1_10,
      R_carrier_left_aux1_y_y*s1_8);
  const double R_carrier_left_aux2_y_z = fnma(R_carrier_left_aux1_y_y, s1_10,
      R_carrier_left_aux1_y_z*s1_8);
  const double R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_z, s1_10,
      R_carrier_left_aux1_z_y*s1_8);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_10,
      R_carrier_left_aux1_z_z*s1_8);
  const double s1_11 = work.cosines[3];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_12 = work.sines[3];
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
  const double R_lower_arm_right_z_y = work.sines[6];
  const double R_lower_arm_right_y_z = -R_lower_arm_right_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_13 = state.charts[2] - 0.5;
  const double R_lower_arm_right_y_y = work.cosines[6];
  const double R_carrier_right_aux1_z_z = (s1_13 >= 0.0 ? R_lower_arm_right_y_z :
      R_lower_arm_right_y_y);
  const double s1_14 = work.sines[7];
  const double R_carrier_right_aux1_y_x = s1_14*R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_x_x = work.cosines[7];
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
  const double s1_21 = work.cosines[8];
  const double s1_22 = s1_14*s1_21;
  const double s1_23 = work.sines[8];
  const double R_carrier_right_aux2_x_z = s1_14*s1_23;
  const double R_carrier_right_aux2_y_y = fma(R_carrier_right_aux1_y_z, s1_23,
      R_carrier_right_aux1_y_y*s1_21);
  const double R_carrier_right_aux2_y_z = fnma(R_carrier_right_aux1_y_y, s1_23,
      R_carrier_right_aux1_y_z*s1_21);
  const double R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_z, s1_23,
      R_carrier_right_aux1_z_y*s1_21);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_23,
      R_carrier_right_aux1_z_z*s1_21);
  const double s1_24 = work.cosines[9];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_25 = work.sines[9];
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
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] + p_rear_axle_tx_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s1_26 = state.charts[3] - 0.5;
  work.R_rear_axle_aux4_z_z = (s1_26 >= 0.0 ? 0.0 : 1.0);
  const double R_rear_axle_aux4_y_y = work.cosines[14];
  const double R_rear_axle_aux4_x_x = R_rear_axle_aux4_y_y*work.R_rear_axle_aux4_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[14];
  work.s1_27 = work.R_rear_axle_aux4_z_z*R_rear_axle_aux4_y_x;
  work.R_rear_axle_aux4_x_z = (s1_26 >= 0.0 ? 1.0 : 0.0);
  const double s1_28 = (s1_26 >= 0.0 ? -1.0 : 0.0);
  const double R_rear_axle_aux4_z_x = R_rear_axle_aux4_y_y*s1_28;
  work.s1_29 = R_rear_axle_aux4_y_x*s1_28;
  const double s1_30 = work.cosines[15];
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s1_31 = work.sines[15];
  work.R_rear_axle_aux5_x_x = fnma(work.R_rear_axle_aux4_x_z, s1_31, R_rear_axle_aux4_x_x*s1_30);
  const double R_rear_axle_aux5_x_z = fma(R_rear_axle_aux4_x_x, s1_31,
      work.R_rear_axle_aux4_x_z*s1_30);
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*s1_30;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_31;
  work.R_rear_axle_aux5_z_x = fnma(work.R_rear_axle_aux4_z_z, s1_31, R_rear_axle_aux4_z_x*s1_30);
  const double R_rear_axle_aux5_z_z = fma(R_rear_axle_aux4_z_x, s1_31,
      work.R_rear_axle_aux4_z_z*s1_30);
  const double s1_32 = work.sines[16];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_33 = work.cosines[16];
  work.R_rear_axle_x_y = fnma(work.s1_27, s1_33, R_rear_axle_aux5_x_z*s1_32);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_33, work.s1_27*s1_32);
  work.R_rear_axle_y_y = fma(R_rear_axle_aux4_y_y, s1_33, R_rear_axle_aux5_y_z*s1_32);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_y_y, s1_32, R_rear_axle_aux5_y_z*s1_33);
  work.R_rear_axle_z_y = fnma(work.s1_29, s1_33, R_rear_axle_aux5_z_z*s1_32);
  work.R_rear_axle_z_z = fma(R_rear_axle_aux5_z_z, s1_33, work.s1_29*s1_32);
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
  work.s4_23 = zd_rear_axle_ry*R_rear_axle_aux4_y_y;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s4_24 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.s4_25 = work.s4_23 + work.s4_24;
  work.s4_26 = zd_rear_axle_ry*work.s1_29;
  work.s4_27 = zd_rear_axle_ry*work.s1_27;
  work.s4_28 = zd_rear_axle_rx*work.R_rear_axle_aux5_z_x;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  work.s4_29 = zd_rear_axle_rz*work.R_rear_axle_aux4_z_z;
  work.s4_30 = work.s4_29 - work.s4_26;
  work.s4_31 = work.s4_28 + work.s4_30;
  work.s4_32 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.s4_33 = zd_rear_axle_rz*work.R_rear_axle_aux4_x_z;
  work.s4_34 = work.s4_33 - work.s4_27;
  work.s4_35 = work.s4_32 + work.s4_34;
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
  const double R_upper_arm_left_z_y = work.sines[4];
  const double R_upper_arm_left_y_y = work.cosines[4];
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
  const double R_upper_arm_right_z_y = work.sines[10];
  const double R_upper_arm_right_y_y = work.cosines[10];
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
  const double R_arb_front_left_x_z = work.sines[5];
  // arb_link_front_left
  const double R_arb_front_left_x_x = work.cosines[5];
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
  const double R_arb_front_right_x_z = work.sines[11];
  // arb_link_front_right
  const double R_arb_front_right_x_x = work.cosines[11];
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
  const double s2_131 = -p_drag_link_from_z*work.sines[12];
  const double s2_132 = -p_drag_link_from_z*work.cosines[12];
  const double R_bell_crank_y_x = work.sines[13];
  const double s2_133 = p_drag_link_to_y*R_bell_crank_y_x;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s2_134 = zd_pitman_arm*s2_131;
  const double s2_135 = zd_pitman_arm*s2_132;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s2_136 = zd_bell_crank*s2_133;
  const double R_bell_crank_x_x = work.cosines[13];
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
[[gnu::noinline]] void compute_closure_terms_2(const State& state,
    ClosureTermsWork& __restrict work, ClosureTerms& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  const double s2_222 = fma(work.s4_23, work.s4_33 - work.s4_32, work.s4_24*work.s4_34);
  const double s2_223 = fnma(work.s4_27, work.s4_29, work.s4_30*work.s4_32);
  const double s2_224 = fnma(work.s4_28, work.s4_34, fma(work.s4_26, work.s4_33, s2_223));
  const double s2_225 = fnma(work.s4_24, work.s4_30, work.s4_23*(work.s4_28 - work.s4_29));
  // long_rod_left
  const double s2_226 = p_long_rod_left_to_x*work.R_rear_axle_aux5_z_x;
  const double s2_227 = fma(p_long_rod_left_to_z, work.R_rear_axle_z_z, s2_226);
  const double s2_228 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_227);
  const double s2_229 = work.r_rear_axle_aux3_z - p_long_rod_left_from_z;
  const double s2_230 = s2_228 + s2_229;
  const double s2_231 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s2_232 = fma(p_long_rod_left_to_z, work.R_rear_axle_x_z, s2_231);
  const double s2_233 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_232);
  const double s2_234 = work.r_rear_axle_aux1_x - p_long_rod_left_from_x;
  const double s2_235 = s2_233 + s2_234;
  const double s2_236 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s2_237 = fma(p_long_rod_left_to_z, work.R_rear_axle_y_z, s2_236);
  const double s2_238 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_237);
  const double s2_239 = fnma(work.s4_31, s2_238, work.s4_25*s2_228);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s2_240 = zd_rear_axle_tx + s2_239;
  const double s2_241 = fnma(work.s4_35, s2_228, work.s4_31*s2_233);
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s2_242 = zd_rear_axle_ty + s2_241;
  const double s2_243 = fnma(work.s4_25, s2_233, work.s4_35*s2_238);
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
  const double s2_249 = fma(work.s4_31, s2_239, fnma(s2_225, s2_228, s2_222*s2_233));
  const double s2_250 = fnma(work.s4_31, s2_241, fnma(s2_222, s2_238, s2_224*s2_228));
  const double s2_251 = fnma(work.s4_25, s2_239, fnma(s2_224, s2_233, s2_225*s2_238));
  const double s2_252 = fma(s2_228, s2_248, s2_238*s2_245);
  const double s2_253 = fma(s2_233, s2_248, s2_238*s2_246);
  const double s2_254 = fnma(s2_228, s2_246, s2_233*s2_245);
  const double s2_255 = fma(s2_235, s2_246, fms(s2_230, s2_245, l_long_rod_left));
  result.Phi[11] = 0.5*fma(s2_247, s2_248, s2_255);
  const double s2_256 = work.R_rear_axle_aux4_x_z*s2_252;
  result.Jz[157] = fnma(work.R_rear_axle_aux4_z_z, s2_253, s2_256);
  const double R_rear_axle_aux4_y_y = work.cosines[14];
  const double s2_257 = fnma(work.s1_27, s2_252, work.s1_29*s2_253);
  result.Jz[158] = fnma(R_rear_axle_aux4_y_y, s2_254, s2_257);
  const double s2_258 = work.R_rear_axle_aux5_x_x*s2_252;
  const double s2_259 = fnma(work.R_rear_axle_aux5_z_x, s2_253, s2_258);
  result.Jz[159] = fnma(work.R_rear_axle_aux5_y_x, s2_254, s2_259);
  const double s2_260 = s2_248*fnma(work.s4_35, s2_243, s2_249);
  const double s2_261 = fnma(s2_246, fma(work.s4_25, s2_243, s2_250), s2_260);
  const double s2_262 = fma(s2_244, s2_244, fma(s2_242, s2_242, s2_240*s2_240));
  const double s2_263 = fnma(s2_245, fma(work.s4_35, s2_241, s2_251), s2_261);
  result.c[11] = fnma(1.1757385222540735, s2_262, s2_263);
  // diag_rod_left
  const double s2_264 = p_diag_rod_left_to_z*work.R_rear_axle_z_z;
  const double s2_265 = fma(p_diag_rod_left_to_y, work.R_rear_axle_z_y, s2_264);
  const double s2_266 = work.r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  const double s2_267 = s2_265 + s2_266;
  const double s2_268 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  const double s2_269 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_268);
  const double s2_270 = work.r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  const double s2_271 = s2_269 + s2_270;
  const double s2_272 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  const double s2_273 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_272);
  const double s2_274 = fnma(work.s4_31, s2_273, work.s4_25*s2_265);
  const double s2_275 = zd_rear_axle_tx + s2_274;
  const double s2_276 = fnma(work.s4_35, s2_265, work.s4_31*s2_269);
  const double s2_277 = zd_rear_axle_ty + s2_276;
  const double s2_278 = fnma(work.s4_25, s2_269, work.s4_35*s2_273);
  const double s2_279 = zd_rear_axle_tz + s2_278;
  const double s2_280 = 1.162476387438193*s2_267;
  result.Jz[164] = s2_280;
  const double s2_281 = 1.162476387438193*s2_271;
  result.Jz[162] = s2_281;
  const double s2_282 = p_diag_rod_left_from_y - z_rear_axle_ty - s2_273;
  const double s2_283 = 1.162476387438193*s2_282;
  result.Jz[163] = -s2_283;
  const double s2_284 = fma(work.s4_31, s2_274, fnma(s2_225, s2_265, s2_222*s2_269));
  const double s2_285 = fnma(work.s4_31, s2_276, fnma(s2_222, s2_273, s2_224*s2_265));
  const double s2_286 = fnma(work.s4_25, s2_274, fnma(s2_224, s2_269, s2_225*s2_273));
  const double s2_287 = fma(s2_265, s2_283, s2_273*s2_280);
  const double s2_288 = fma(s2_269, s2_283, s2_273*s2_281);
  const double s2_289 = fnma(s2_265, s2_281, s2_269*s2_280);
  const double s2_290 = fma(s2_271, s2_281, fms(s2_267, s2_280, l_diag_rod_left));
  result.Phi[12] = 0.5*fma(s2_282, s2_283, s2_290);
  const double s2_291 = work.R_rear_axle_aux4_x_z*s2_287;
  result.Jz[165] = fnma(work.R_rear_axle_aux4_z_z, s2_288, s2_291);
  const double s2_292 = fnma(work.s1_27, s2_287, work.s1_29*s2_288);
  result.Jz[166] = fnma(R_rear_axle_aux4_y_y, s2_289, s2_292);
  const double s2_293 = work.R_rear_axle_aux5_x_x*s2_287;
  const double s2_294 = fnma(work.R_rear_axle_aux5_z_x, s2_288, s2_293);
  result.Jz[167] = fnma(work.R_rear_axle_aux5_y_x, s2_289, s2_294);
  const double s2_295 = s2_283*fnma(work.s4_35, s2_278, s2_284);
  const double s2_296 = fnma(s2_281, fma(work.s4_25, s2_278, s2_285), s2_295);
  const double s2_297 = fma(s2_279, s2_279, fma(s2_277, s2_277, s2_275*s2_275));
  const double s2_298 = fnma(s2_280, fma(work.s4_35, s2_276, s2_286), s2_296);
  result.c[12] = fnma(1.162476387438193, s2_297, s2_298);
  // arb_link_rear_left
  const double s2_299 = p_arb_link_rear_left_from_x*work.sines[17];
  const double s2_300 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s2_301 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s2_300);
  const double s2_302 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_z_x;
  const double s2_303 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s2_302);
  const double s2_304 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s2_305 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s2_304);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s2_306 = zd_arb_rear_left*s2_299;
  const double s2_307 = p_arb_link_rear_left_from_x*work.cosines[17];
  const double s2_308 = zd_arb_rear_left*s2_307;
  const double s2_309 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_303);
  const double s2_310 = work.r_rear_axle_aux3_z - p_arb_rear_left_z;
  const double s2_311 = s2_310 + (s2_299 + s2_309);
  const double s2_312 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_305);
  const double s2_313 = fnma(work.s4_35, s2_309, work.s4_31*s2_312);
  const double s2_314 = zd_rear_axle_ty + s2_313;
  const double s2_315 = 4.47213595499958*s2_311;
  result.Jz[172] = s2_315;
  const double s2_316 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_301);
  const double s2_317 = 0.6 - z_rear_axle_ty - s2_316;
  const double s2_318 = 4.47213595499958*s2_317;
  result.Jz[171] = -s2_318;
  const double s2_319 = s2_307 + p_arb_rear_left_x - work.r_rear_axle_aux1_x - s2_312;
  const double s2_320 = 4.47213595499958*s2_319;
  result.Jz[170] = -s2_320;
  const double s2_321 = fnma(work.s4_31, s2_316, work.s4_25*s2_309);
  const double s2_322 = s2_321 + (zd_rear_axle_tx + s2_306);
  const double s2_323 = fnma(work.s4_25, s2_312, work.s4_35*s2_316);
  const double s2_324 = s2_323 + (zd_rear_axle_tz + s2_308);
  result.Jz[176] = fnma(s2_299, s2_320, s2_307*s2_315);
  const double s2_325 = fma(work.s4_31, s2_321, fnma(s2_225, s2_309, s2_222*s2_312));
  const double s2_326 = fma(s2_309, s2_318, s2_315*s2_316);
  const double s2_327 = fnma(s2_316, s2_320, s2_312*s2_318);
  const double s2_328 = fma(s2_309, s2_320, s2_312*s2_315);
  const double s2_329 = fnma(work.s4_31, s2_313, fma(s2_224, s2_309, zd_arb_rear_left*s2_308));
  const double s2_330 = fma(s2_317, s2_318, fms(s2_311, s2_315, l_arb_link_rear_left));
  result.Phi[13] = 0.5*fma(s2_319, s2_320, s2_330);
  const double s2_331 = work.R_rear_axle_aux4_x_z*s2_326;
  result.Jz[173] = fnma(work.R_rear_axle_aux4_z_z, s2_327, s2_331);
  const double s2_332 = fnma(work.s4_35, s2_313, fma(s2_224, s2_312, zd_arb_rear_left*s2_306));
  const double s2_333 = fnma(work.s1_27, s2_326, work.s1_29*s2_327);
  result.Jz[174] = fnma(R_rear_axle_aux4_y_y, s2_328, s2_333);
  const double s2_334 = work.R_rear_axle_aux5_x_x*s2_326;
  const double s2_335 = fnma(work.R_rear_axle_aux5_z_x, s2_327, s2_334);
  result.Jz[175] = fnma(work.R_rear_axle_aux5_y_x, s2_328, s2_335);
  const double s2_336 = fma(work.s4_25, s2_323, fnma(s2_222, s2_316, s2_329));
  const double s2_337 = fma(s2_320, s2_336, s2_318*fnma(work.s4_35, s2_323, s2_325));
  const double s2_338 = fma(work.s4_25, s2_321, fnma(s2_225, s2_316, s2_332));
  const double s2_339 = fma(s2_324, s2_324, fma(s2_322, s2_322, s2_314*s2_314));
  result.c[13] = fnma(4.47213595499958, s2_339, fma(s2_315, s2_338, s2_337));
  // long_rod_right
  const double s2_340 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_237);
  const double s2_341 = s2_340 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s2_342 = fnma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_227);
  const double s2_343 = s2_229 + s2_342;
  const double s2_344 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_232);
  const double s2_345 = s2_234 + s2_344;
  const double s2_346 = fnma(work.s4_31, s2_340, work.s4_25*s2_342);
  const double s2_347 = zd_rear_axle_tx + s2_346;
  const double s2_348 = fnma(work.s4_35, s2_342, work.s4_31*s2_344);
  const double s2_349 = zd_rear_axle_ty + s2_348;
  const double s2_350 = fnma(work.s4_25, s2_344, work.s4_35*s2_340);
  const double s2_351 = zd_rear_axle_tz + s2_350;
  const double s2_352 = 1.1757385222540735*s2_341;
  result.Jz[179] = s2_352;
  const double s2_353 = 1.1757385222540735*s2_343;
  result.Jz[180] = s2_353;
  const double s2_354 = 1.1757385222540735*s2_345;
  result.Jz[178] = s2_354;
  const double s2_355 = fma(work.s4_31, s2_346, fnma(s2_225, s2_342, s2_222*s2_344));
  const double s2_356 = fnma(work.s4_31, s2_348, fnma(s2_222, s2_340, s2_224*s2_342));
  const double s2_357 = fnma(work.s4_25, s2_346, fnma(s2_224, s2_344, s2_225*s2_340));
  const double s2_358 = fnma(s2_342, s2_354, s2_344*s2_353);
  const double s2_359 = fnma(s2_344, s2_352, s2_340*s2_354);
  const double s2_360 = fnma(s2_340, s2_353, s2_342*s2_352);
  const double s2_361 = fma(s2_343, s2_353, fms(s2_341, s2_352, l_long_rod_right));
  result.Phi[14] = 0.5*fma(s2_345, s2_354, s2_361);
  const double s2_362 = fma(work.R_rear_axle_aux4_x_z, s2_360, work.R_rear_axle_aux4_z_z*s2_359);
  result.Jz[181] = -s2_362;
  const double s2_363 = fma(work.R_rear_axle_aux5_z_x, s2_359, work.R_rear_axle_aux5_y_x*s2_358);
  result.Jz[183] = -fma(work.R_rear_axle_aux5_x_x, s2_360, s2_363);
  const double s2_364 = fnma(R_rear_axle_aux4_y_y, s2_358, work.s1_29*s2_359);
  result.Jz[182] = fma(work.s1_27, s2_360, s2_364);
  const double s2_365 = s2_352*fnma(work.s4_35, s2_350, s2_355);
  const double s2_366 = fma(s2_354, fma(work.s4_25, s2_350, s2_356), s2_365);
  const double s2_367 = fma(s2_351, s2_351, fma(s2_349, s2_349, s2_347*s2_347));
  const double s2_368 = fma(s2_353, fma(work.s4_35, s2_348, s2_357), s2_366);
  result.c[14] = -fma(1.1757385222540735, s2_367, s2_368);
  // diag_rod_right
  const double s2_369 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_z_y, s2_264);
  const double s2_370 = s2_266 + s2_369;
  const double s2_371 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_272);
  const double s2_372 = s2_371 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  const double s2_373 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_268);
  const double s2_374 = s2_270 + s2_373;
  const double s2_375 = fnma(work.s4_31, s2_371, work.s4_25*s2_369);
  const double s2_376 = zd_rear_axle_tx + s2_375;
  const double s2_377 = fnma(work.s4_35, s2_369, work.s4_31*s2_373);
  const double s2_378 = zd_rear_axle_ty + s2_377;
  const double s2_379 = fnma(work.s4_25, s2_373, work.s4_35*s2_371);
  const double s2_380 = zd_rear_axle_tz + s2_379;
  const double s2_381 = 1.162476387438193*s2_370;
  result.Jz[188] = s2_381;
  const double s2_382 = 1.162476387438193*s2_372;
  result.Jz[187] = s2_382;
  const double s2_383 = 1.162476387438193*s2_374;
  result.Jz[186] = s2_383;
  const double s2_384 = fma(work.s4_31, s2_375, fnma(s2_225, s2_369, s2_222*s2_373));
  const double s2_385 = fnma(work.s4_31, s2_377, fnma(s2_222, s2_371, s2_224*s2_369));
  const double s2_386 = fnma(work.s4_25, s2_375, fnma(s2_224, s2_373, s2_225*s2_371));
  const double s2_387 = fnma(s2_369, s2_383, s2_373*s2_381);
  const double s2_388 = fnma(s2_373, s2_382, s2_371*s2_383);
  const double s2_389 = fnma(s2_371, s2_381, s2_369*s2_382);
  const double s2_390 = fma(s2_372, s2_382, fms(s2_370, s2_381, l_diag_rod_right));
  result.Phi[15] = 0.5*fma(s2_374, s2_383, s2_390);
  const double s2_391 = fma(work.R_rear_axle_aux4_x_z, s2_389, work.R_rear_axle_aux4_z_z*s2_388);
  result.Jz[189] = -s2_391;
  const double s2_392 = fma(work.R_rear_axle_aux5_z_x, s2_388, work.R_rear_axle_aux5_y_x*s2_387);
  result.Jz[191] = -fma(work.R_rear_axle_aux5_x_x, s2_389, s2_392);
  const double s2_393 = fnma(R_rear_axle_aux4_y_y, s2_387, work.s1_29*s2_388);
  result.Jz[190] = fma(work.s1_27, s2_389, s2_393);
  const double s2_394 = s2_382*fnma(work.s4_35, s2_379, s2_384);
  const double s2_395 = fma(s2_383, fma(work.s4_25, s2_379, s2_385), s2_394);
  const double s2_396 = fma(s2_380, s2_380, fma(s2_378, s2_378, s2_376*s2_376));
  const double s2_397 = fma(s2_381, fma(work.s4_35, s2_377, s2_386), s2_395);
  result.c[15] = -fma(1.162476387438193, s2_396, s2_397);
  // arb_link_rear_right
  const double s2_398 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_301);
  const double s2_399 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_305);
  const double s2_400 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_303);
  const double s2_401 = p_arb_link_rear_right_from_x*work.sines[18];
  const double s2_402 = 0.6 + z_rear_axle_ty - s2_398;
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s2_403 = zd_arb_rear_right*s2_401;
  const double s2_404 = p_arb_link_rear_right_from_x*work.cosines[18];
  const double s2_405 = zd_arb_rear_right*s2_404;
  const double s2_406 = fnma(work.s4_31, s2_399, work.s4_35*s2_400);
  const double s2_407 = zd_rear_axle_ty + s2_406;
  const double s2_408 = s2_401 + (s2_310 - s2_400);
  const double s2_409 = 4.47213595499958*s2_402;
  result.Jz[195] = s2_409;
  const double s2_410 = fnma(work.s4_25, s2_400, work.s4_31*s2_398);
  const double s2_411 = s2_410 + (zd_rear_axle_tx + s2_403);
  const double s2_412 = fnma(work.s4_35, s2_398, work.s4_25*s2_399);
  const double s2_413 = s2_412 + (zd_rear_axle_tz + s2_405);
  const double s2_414 = 4.47213595499958*s2_408;
  result.Jz[196] = s2_414;
  const double s2_415 = s2_404 + (s2_399 + p_arb_rear_right_x - work.r_rear_axle_aux1_x);
  const double s2_416 = 4.47213595499958*s2_415;
  result.Jz[194] = -s2_416;
  const double s2_417 = fma(work.s4_31, s2_410, fnma(s2_222, s2_399, s2_225*s2_400));
  result.Jz[201] = fnma(s2_401, s2_416, s2_404*s2_414);
  const double s2_418 = fma(zd_arb_rear_right, s2_405, fnma(s2_224, s2_400, s2_222*s2_398));
  const double s2_419 = fma(s2_400, s2_416, s2_399*s2_414);
  const double s2_420 = fma(s2_398, s2_416, s2_399*s2_409);
  const double s2_421 = fnma(s2_400, s2_409, s2_398*s2_414);
  const double s2_422 = fma(zd_arb_rear_right, s2_403, fnma(s2_224, s2_399, s2_225*s2_398));
  const double s2_423 = fma(s2_408, s2_414, fms(s2_402, s2_409, l_arb_link_rear_right));
  result.Phi[16] = 0.5*fma(s2_415, s2_416, s2_423);
  const double s2_424 = fma(work.R_rear_axle_aux4_x_z, s2_421, work.R_rear_axle_aux4_z_z*s2_420);
  result.Jz[197] = -s2_424;
  const double s2_425 = fma(work.s1_29, s2_420, R_rear_axle_aux4_y_y*s2_419);
  result.Jz[198] = fma(work.s1_27, s2_421, s2_425);
  const double s2_426 = work.R_rear_axle_aux5_y_x*s2_419;
  const double s2_427 = fnma(work.R_rear_axle_aux5_z_x, s2_420, s2_426);
  result.Jz[199] = fnma(work.R_rear_axle_aux5_x_x, s2_421, s2_427);
  const double s2_428 = s2_416*fma(work.s4_25, s2_412, fnma(work.s4_31, s2_406, s2_418));
  const double s2_429 = fma(work.s4_25, s2_410, fnma(work.s4_35, s2_406, s2_422));
  const double s2_430 = fnma(s2_409, fnma(work.s4_35, s2_412, s2_417), s2_428);
  const double s2_431 = fma(s2_413, s2_413, fma(s2_411, s2_411, s2_407*s2_407));
  result.c[16] = fnma(4.47213595499958, s2_431, fma(s2_414, s2_429, s2_430));
  // operations: 584 add, 751 multiply
}

/// Closure equations and their derivatives, for the pivoting factorisation.
void compute_closure_terms(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, ClosureTerms& __restrict result) noexcept {
  ClosureTermsWork work;
  compute_closure_terms_1(state, work, result);
  compute_closure_terms_2(state, work, result);
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
struct ChosenAccelerationsWork {
  double
      sines[22], cosines[22], R_chassis_aux5_y_x, R_chassis_x_x, R_chassis_x_y, R_chassis_x_z,
      R_chassis_y_y, R_chassis_y_z, R_chassis_z_x, R_chassis_z_y, R_chassis_z_z,
      R_carrier_left_aux1_z_z, R_carrier_left_aux1_y_x, R_carrier_left_aux1_y_z,
      R_carrier_left_aux1_z_x, s1_18, r_carrier_left_aux1_y, s1_20, r_carrier_left_aux1_z, s1_22,
      R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, R_carrier_left_x_x, R_carrier_left_x_z,
      R_carrier_left_y_x, R_carrier_left_y_z, R_carrier_left_z_x, R_carrier_left_z_z,
      R_carrier_right_aux1_z_z, R_carrier_right_aux1_y_x, R_carrier_right_aux1_y_z,
      R_carrier_right_aux1_z_x, s1_30, r_carrier_right_aux1_y, s1_32, s1_33, s1_35,
      R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, R_carrier_right_x_x, R_carrier_right_x_z,
      R_carrier_right_y_x, R_carrier_right_y_z, R_carrier_right_z_x, R_carrier_right_z_z,
      r_rear_axle_aux1_x, r_rear_axle_aux3_z, s1_48, s1_50, R_rear_axle_aux5_x_x,
      R_rear_axle_aux5_y_x, R_rear_axle_aux5_z_x, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y,
      R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z, s4_1, w_chassis_x, s4_2, s4_3, w_chassis_y,
      s4_4, s4_5, w_chassis_z, s4_6, s4_7, s4_8, s4_9, s4_10, s4_11, s4_12, s4_13, s4_14, s4_15,
      s4_16, s4_17, s4_18, s4_19, s1_55, s1_57, s1_58, s1_59, s1_60, s1_61, s1_68, s1_69, s1_76,
      s1_77, s1_84, s1_85, s1_92, s1_93, s1_99, s1_100, s1_102, s1_104, s1_105, s1_106, s4_28,
      s4_29, s4_30, s4_31, s4_32, s4_33, s4_34, s4_35, s4_36, s4_38, s4_40, s4_41, s4_42, s4_43,
      s4_44, s4_45, s4_46, s4_47, s4_48, w_carrier_left_x, w_carrier_left_y, w_carrier_left_z,
      w_carrier_right_x, w_carrier_right_y, w_carrier_right_z, s7_3, s7_6, s3_2, s3_4, s3_7, s3_10,
      s3_13, s3_16, s6_4, s6_8, s6_12, s7_8, s7_10, s7_12, s7_19, s7_26, s7_28, s7_30, s7_31, s7_33,
      s7_34, s7_35, s7_36, s7_37, s7_38, s7_41, s7_42, s7_43, s7_44, s7_45, s7_46, s7_47, s7_50,
      s7_51, s7_52, s8_12, s8_13, s8_14, s8_15, s8_16, s8_17, s8_20, s8_21, s8_22, s8_23, s8_24,
      s8_25, s8_26, s8_27, s8_28, s8_29, s8_30, s8_31, s8_32, s8_33, s8_34, s8_35, s8_36, s8_38,
      s8_39, s8_41, s8_42, s8_43, s8_44, s8_45, s8_46, s8_47, s8_48, s8_49, s8_50, s8_51, s8_52,
      s8_53, s8_54, s8_55, s8_56, s8_57, s8_64, s8_67, f_rear_axle_x, s8_79, f_rear_axle_y,
      f_rear_axle_z, n_rear_axle_x, n_rear_axle_y, n_rear_axle_z, s8_109, s8_114, s8_115, s8_116,
      s8_117, s8_127, s8_140, s8_141, s8_142, s8_147, s8_152, s8_168, s8_169, s8_170, s8_171,
      s8_176, s8_181, s8_186, s8_190, s8_194, s8_209, s8_210, s8_211, s8_212, s8_218, s8_224,
      s8_230, s8_243, s8_249, s8_251, s8_252, s8_253, s8_266, s8_273, s8_280, s8_286, s8_288,
      s8_290, s8_292, s8_305, s8_306, s8_307, s8_312, s8_317, s8_322, s8_324, s8_326, s8_328,
      s8_341, s8_342, s8_343, s8_349, s8_355, s8_361, s8_366, s8_374, s8_375, s8_388, s8_389,
      s8_390, s8_401, s8_412, s8_424, s8_448, s8_465, s8_472, s8_479, s8_511, s8_512, s8_515,
      s8_516, s8_517, s8_519, s8_520, s8_522, s8_523, s8_534, s8_535, s8_546, s8_547, s8_559,
      s8_560, s8_561, s8_575, s8_576, s8_577, s8_578, s8_579, s8_580, s3_18, s3_20, s3_22, s3_24,
      s3_26, s3_28, s3_31, s3_34, s3_37, s3_40, s3_43, s3_46, s3_49, s3_52, s3_55, s3_58, s3_61,
      s3_64, s6_13, s6_14, s6_15, s6_16, s6_17, s6_23, s6_29, s6_34, s6_39, s7_54, s7_56, s7_61,
      s7_62, s7_63, s7_66, s7_69, s7_72, s7_86, s7_94, s7_96, s7_98, s7_101, s7_102, s7_104, s7_106,
      s7_111, s7_112, s7_113, s7_115, s7_117, s7_119, s7_121, s7_126, s7_127, s7_128, s7_130,
      s7_132, s7_137, s7_138, s7_139, s7_142, s7_145, s7_148, s7_163, s7_172, s7_175, s7_177,
      s7_181, s7_182, s7_184, s7_186, s7_191, s7_192, s7_193, s7_195, s7_197, s7_199, s7_201,
      s7_206, s7_207, s7_208, s7_209, s7_210, s7_213, s7_214, s7_215, s7_216, s7_219, s7_222,
      s7_223, s7_224, s8_601, s8_602, s8_603, s8_604, s8_605, s8_606, s8_607, s8_608, s8_609,
      s8_610, s8_611, s8_612, s8_613, s8_614, s8_615, s8_616, s8_617, s8_618, s8_623, s8_628,
      s8_629, s8_630, s8_631, s8_632, s8_633, s8_634, s8_635, s8_636, s8_637, s8_638, s8_639,
      s8_641, s8_642, s8_643, s8_644, s8_645, s8_646, s8_647, s8_648, s8_649, s8_650, s8_651,
      s8_652, s8_653, s8_654, s8_655, s8_656, s8_658, s8_659, s8_660, s8_661, s8_662, s8_663,
      s8_664, s8_665, s8_666, s8_667, s8_669, s8_671, s8_672, s8_673, s8_674, s8_675, s8_676,
      s8_677, s8_678, s8_680, s8_681, s8_682, s8_683, s8_684, s8_685, s8_686, s8_687, s8_688,
      s8_689, s8_690, s8_691, s8_693, s8_694, s8_695, s8_696, s8_697, s8_698, s8_699, s8_700,
      s8_701, s8_703, s8_704, s8_705, s8_706, s8_707, s8_708, s8_711, s8_714, s8_715, s8_721,
      s8_724, f_carrier_right_x, s8_735, f_carrier_right_y, f_carrier_right_z, n_carrier_right_x,
      n_carrier_right_y, n_carrier_right_z, s8_760, s8_761, s8_762, s8_763, s8_765, s8_767, s8_769,
      s8_771, s8_773, s8_775, s8_776, s8_777, s8_778, s8_780, s8_782, s8_784, s8_786, s8_788,
      s8_790, s8_793, s8_796, s8_799, s8_800, s8_801, s8_802, s8_803, s8_804, s8_805, s8_806,
      s8_807, s8_808, s8_809, s8_811, s8_812, s8_813, s8_814, s8_815, s8_816, s8_817, s8_818,
      s8_819, s8_820, s8_821, s8_822, s8_823, s8_824, s8_825, s8_826, s8_827, s8_828, s8_829,
      s8_830, s8_831, s8_832, s8_833, s8_834, s8_835, s8_836, s8_837, s8_838, s8_839, s8_841,
      s8_842, s8_843, s8_844, s8_845, s8_846, s8_847, s8_848, s8_849, s8_850, s8_856, s8_859,
      f_carrier_left_x, s8_869, f_carrier_left_y, f_carrier_left_z, n_carrier_left_x,
      n_carrier_left_y, n_carrier_left_z, s8_895, s8_896, s8_897, s8_899, s8_901, s8_903, s8_905,
      s8_907, s8_909, s8_911, s8_912, s8_913, s8_914, s8_915, s8_916, s8_918, s8_920, s8_922,
      s8_924, s8_926, s8_928, s8_931, s8_934, s8_937, s8_938, s8_939, s8_944, s8_947, s8_948,
      s8_949, s8_952, s8_953, s8_954, s8_955, s8_956, s8_957, s8_959, s8_976, s8_977, s8_978,
      s8_979, s8_980, s8_984, s8_985, s8_986, s8_987, s8_991, s8_993, s8_995, s8_997, s8_999,
      s8_1001, s8_1009, s8_1015, s8_1022, s8_1032, s8_1041, s8_1042, s8_1043, s8_1044, s8_1045,
      s8_1046, s8_1047, s8_1048, s8_1052, s8_1054, s8_1056, s8_1058, s8_1060, s8_1062, s8_1070,
      s8_1076, s8_1084, s8_1093, s8_1094, s8_1095, s8_1096, s8_1097, s8_1098, s8_1099, s8_1100,
      s8_1101, s8_1102, s8_1103, s8_1104, s8_1105, s8_1106, s8_1107, s8_1111, s8_1124, s8_1129,
      s8_1133, s8_1143, s8_1152, s8_1153, s8_1154, s8_1158, s8_1160, s8_1162, s8_1163, s8_1164,
      s8_1165, s8_1166, s8_1170, s8_1172, s8_1174, s8_1175, s8_1180, s8_1186, s8_1193, s8_1201,
      s8_1205, s8_1211, s8_1212, s8_1213, s8_1214, s8_1215, s8_1216, s8_1217, s8_1219, s8_1221,
      s8_1223, s8_1243, s8_1247, s8_1249, s8_1251, s8_1271, s8_1297, s8_1322, s8_1345, s8_1369,
      s8_1392, s8_1416, s8_1424, s8_1430, s8_1437, s8_1441, s8_1445, s8_1450, s8_1454, s8_1458,
      s8_1463, s8_1467, s8_1471, s8_1474, s8_1477, s8_1480, s8_1483, s8_1488, s8_1515, s8_1522,
      s8_1531, s8_1532, s8_1559, s8_1560, s8_1565, s8_1568, s8_1569, s8_1570, s8_1575, s8_1581,
      s8_1582, s8_1585, s8_1589, s8_1590, s8_1610, s8_1630, s8_1631, s8_1657, s8_1684, s8_1685,
      s8_1705, s8_1725, s8_1726, s8_1727, s8_1728, s8_1729, s8_1730, s8_1731, s8_1732, s8_1733,
      s8_1734, s8_1735, s8_1736, s8_1737, s8_1738, s8_1770, s8_1802, s8_1806, s8_1818, s8_1821,
      s8_1823, s8_1828, s8_1831, s8_1834, s8_1838, s8_1841, s8_1845, s8_1855, s8_1870, s8_1871,
      s8_1874, s8_1891, s8_1892, s8_1898, s8_1908, s8_1912, pivot_chassis_ry, s8_1913, s8_1914,
      s8_1931, s8_1949;
};

/// Part 1 of compute_chosen_accelerations: step 1: poses and axes b; step 4: velocities; step 1:
/// poses and axes b; step 4: velocities; step 7: inertias of the bodies and forces on joints; step
/// 8: elimination from the leaves to the root (63); step 3: Rz (61), long_rod_left ..
/// arb_link_rear_right; step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right; step 7:
/// inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right; step 8:
/// elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_chosen_accelerations_1(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
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
  mbgen::sincos(angles, work.sines, work.cosines);
  const double s1_1 = state.charts[0] - 0.5;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_y_x = work.sines[0];
  const double s1_2 = work.cosines[1];
  work.R_chassis_aux5_y_x = R_chassis_aux4_y_x*s1_2;
  const double s1_3 = work.sines[1];
  const double s1_4 = -s1_3;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux4_y_y = work.cosines[0];
  const double s1_5 = R_chassis_aux4_y_y*s1_2;
  work.R_chassis_x_x = (s1_1 >= 0.0 ? s1_4 : s1_5);
  const double s1_6 = work.sines[2];
  const double s1_7 = s1_2*s1_6;
  const double s1_8 = s1_3*s1_6;
  const double s1_9 = work.cosines[2];
  const double s1_10 = fnma(R_chassis_aux4_y_x, s1_9, R_chassis_aux4_y_y*s1_8);
  work.R_chassis_x_y = (s1_1 >= 0.0 ? s1_7 : s1_10);
  const double s1_11 = s1_2*s1_9;
  const double s1_12 = s1_3*s1_9;
  const double s1_13 = fma(R_chassis_aux4_y_y, s1_12, R_chassis_aux4_y_x*s1_6);
  work.R_chassis_x_z = (s1_1 >= 0.0 ? s1_11 : s1_13);
  work.R_chassis_y_y = fma(R_chassis_aux4_y_y, s1_9, R_chassis_aux4_y_x*s1_8);
  work.R_chassis_y_z = fnma(R_chassis_aux4_y_y, s1_6, R_chassis_aux4_y_x*s1_12);
  work.R_chassis_z_x = (s1_1 >= 0.0 ? -s1_5 : s1_4);
  work.R_chassis_z_y = (s1_1 >= 0.0 ? -s1_10 : s1_7);
  work.R_chassis_z_z = (s1_1 >= 0.0 ? -s1_13 : s1_11);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_lower_arm_left_y_z = -R_lower_arm_left_z_y;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_14 = state.charts[1] - 0.5;
  const double R_lower_arm_left_y_y = work.cosines[3];
  work.R_carrier_left_aux1_z_z = (s1_14 >= 0.0 ? R_lower_arm_left_y_z : R_lower_arm_left_y_y);
  const double s1_15 = work.sines[4];
  work.R_carrier_left_aux1_y_x = s1_15*work.R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_carrier_left_aux1_x_x*work.R_carrier_left_aux1_z_z;
  work.R_carrier_left_aux1_y_z = (s1_14 >= 0.0 ? -R_lower_arm_left_y_y : R_lower_arm_left_y_z);
  const double s1_16 = (s1_14 >= 0.0 ? R_lower_arm_left_y_y : R_lower_arm_left_z_y);
  work.R_carrier_left_aux1_z_x = s1_15*s1_16;
  const double R_carrier_left_aux1_z_y = R_carrier_left_aux1_x_x*s1_16;
  const double s1_17 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  work.s1_18 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_17);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_18;
  const double s1_19 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_20 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_19);
  work.r_carrier_left_aux1_z = work.s1_20 + p_lower_arm_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_21 = work.cosines[5];
  work.s1_22 = s1_15*s1_21;
  const double s1_23 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_15*s1_23;
  work.R_carrier_left_aux2_y_y = fma(work.R_carrier_left_aux1_y_z, s1_23,
      R_carrier_left_aux1_y_y*s1_21);
  const double R_carrier_left_aux2_y_z = fnma(R_carrier_left_aux1_y_y, s1_23,
      work.R_carrier_left_aux1_y_z*s1_21);
  work.R_carrier_left_aux2_z_y = fma(work.R_carrier_left_aux1_z_z, s1_23,
      R_carrier_left_aux1_z_y*s1_21);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_23,
      work.R_carrier_left_aux1_z_z*s1_21);
  const double s1_24 = work.cosines[6];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = work.sines[6];
  work.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_25, R_carrier_left_aux1_x_x*s1_24);
  work.R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_25, R_carrier_left_aux2_x_z*s1_24);
  work.R_carrier_left_y_x = fnma(R_carrier_left_aux2_y_z, s1_25,
      work.R_carrier_left_aux1_y_x*s1_24);
  work.R_carrier_left_y_z = fma(work.R_carrier_left_aux1_y_x, s1_25, R_carrier_left_aux2_y_z*s1_24);
  work.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_25,
      work.R_carrier_left_aux1_z_x*s1_24);
  work.R_carrier_left_z_z = fma(work.R_carrier_left_aux1_z_x, s1_25, R_carrier_left_aux2_z_z*s1_24);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_z = -R_lower_arm_right_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_26 = state.charts[2] - 0.5;
  const double R_lower_arm_right_y_y = work.cosines[9];
  work.R_carrier_right_aux1_z_z = (s1_26 >= 0.0 ? R_lower_arm_right_y_z : R_lower_arm_right_y_y);
  const double s1_27 = work.sines[10];
  work.R_carrier_right_aux1_y_x = s1_27*work.R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_carrier_right_aux1_x_x*work.R_carrier_right_aux1_z_z;
  work.R_carrier_right_aux1_y_z = (s1_26 >= 0.0 ? -R_lower_arm_right_y_y : R_lower_arm_right_y_z);
  const double s1_28 = (s1_26 >= 0.0 ? R_lower_arm_right_y_y : R_lower_arm_right_z_y);
  work.R_carrier_right_aux1_z_x = s1_27*s1_28;
  const double R_carrier_right_aux1_z_y = R_carrier_right_aux1_x_x*s1_28;
  const double s1_29 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  work.s1_30 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_29);
  work.r_carrier_right_aux1_y = work.s1_30 + p_lower_arm_right_y;
  const double s1_31 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  work.s1_32 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_31);
  work.s1_33 = work.s1_32 - p_lower_arm_right_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_34 = work.cosines[11];
  work.s1_35 = s1_27*s1_34;
  const double s1_36 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_27*s1_36;
  const double s1_37 = R_carrier_right_aux1_y_y*s1_34;
  work.R_carrier_right_aux2_y_y = fma(work.R_carrier_right_aux1_y_z, s1_36, s1_37);
  const double s1_38 = work.R_carrier_right_aux1_y_z*s1_34;
  const double R_carrier_right_aux2_y_z = fnma(R_carrier_right_aux1_y_y, s1_36, s1_38);
  const double s1_39 = R_carrier_right_aux1_z_y*s1_34;
  work.R_carrier_right_aux2_z_y = fma(work.R_carrier_right_aux1_z_z, s1_36, s1_39);
  const double s1_40 = work.R_carrier_right_aux1_z_z*s1_34;
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_36, s1_40);
  const double s1_41 = work.cosines[12];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_42 = work.sines[12];
  work.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_42, R_carrier_right_aux1_x_x*s1_41);
  work.R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_42, R_carrier_right_aux2_x_z*s1_41);
  const double s1_43 = work.R_carrier_right_aux1_y_x*s1_41;
  work.R_carrier_right_y_x = fnma(R_carrier_right_aux2_y_z, s1_42, s1_43);
  const double s1_44 = R_carrier_right_aux2_y_z*s1_41;
  work.R_carrier_right_y_z = fma(work.R_carrier_right_aux1_y_x, s1_42, s1_44);
  const double s1_45 = work.R_carrier_right_aux1_z_x*s1_41;
  work.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_42, s1_45);
  const double s1_46 = R_carrier_right_aux2_z_z*s1_41;
  work.R_carrier_right_z_z = fma(work.R_carrier_right_aux1_z_x, s1_42, s1_46);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] + p_rear_axle_tx_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s1_47 = state.charts[3] - 0.5;
  const double R_rear_axle_aux4_z_z = (s1_47 >= 0.0 ? 0.0 : 1.0);
  const double R_rear_axle_aux4_y_y = work.cosines[17];
  const double R_rear_axle_aux4_x_x = R_rear_axle_aux4_y_y*R_rear_axle_aux4_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.s1_48 = R_rear_axle_aux4_z_z*R_rear_axle_aux4_y_x;
  const double R_rear_axle_aux4_x_z = (s1_47 >= 0.0 ? 1.0 : 0.0);
  const double s1_49 = (s1_47 >= 0.0 ? -1.0 : 0.0);
  const double R_rear_axle_aux4_z_x = R_rear_axle_aux4_y_y*s1_49;
  work.s1_50 = R_rear_axle_aux4_y_x*s1_49;
  const double s1_51 = work.cosines[18];
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s1_52 = work.sines[18];
  work.R_rear_axle_aux5_x_x = fnma(R_rear_axle_aux4_x_z, s1_52, R_rear_axle_aux4_x_x*s1_51);
  const double R_rear_axle_aux5_x_z = fma(R_rear_axle_aux4_x_x, s1_52, R_rear_axle_aux4_x_z*s1_51);
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*s1_51;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_52;
  work.R_rear_axle_aux5_z_x = fnma(R_rear_axle_aux4_z_z, s1_52, R_rear_axle_aux4_z_x*s1_51);
  const double R_rear_axle_aux5_z_z = fma(R_rear_axle_aux4_z_x, s1_52, R_rear_axle_aux4_z_z*s1_51);
  const double s1_53 = work.sines[19];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_54 = work.cosines[19];
  work.R_rear_axle_x_y = fnma(work.s1_48, s1_54, R_rear_axle_aux5_x_z*s1_53);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_54, work.s1_48*s1_53);
  work.R_rear_axle_y_y = fma(R_rear_axle_aux4_y_y, s1_54, R_rear_axle_aux5_y_z*s1_53);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_y_y, s1_53, R_rear_axle_aux5_y_z*s1_54);
  work.R_rear_axle_z_y = fnma(work.s1_50, s1_54, R_rear_axle_aux5_z_z*s1_53);
  work.R_rear_axle_z_z = fma(R_rear_axle_aux5_z_z, s1_54, work.s1_50*s1_53);

  // --- step 4: velocities ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  work.s4_1 = zd_chassis_rz*s1_3;
  work.w_chassis_x = state.zd[Coordinate::chassis_rx] - work.s4_1;
  work.s4_2 = zd_chassis_rz*s1_7;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.s4_3 = zd_chassis_ry*s1_9;
  work.w_chassis_y = work.s4_2 + work.s4_3;
  work.s4_4 = zd_chassis_rz*s1_11;
  work.s4_5 = zd_chassis_ry*s1_6;
  work.w_chassis_z = work.s4_4 - work.s4_5;
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  work.s4_6 = zd_carrier_left_rz*work.R_carrier_left_aux1_y_z;
  work.s4_7 = zd_carrier_left_rz*work.R_carrier_left_aux1_z_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  work.s4_8 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  work.s4_9 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  work.s4_10 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.s4_11 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.s4_12 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  work.s4_13 = zd_carrier_right_rz*work.R_carrier_right_aux1_y_z;
  work.s4_14 = zd_carrier_right_rz*work.R_carrier_right_aux1_z_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  work.s4_15 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  work.s4_16 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  work.s4_17 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.s4_18 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.s4_19 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s4_20 = zd_rear_axle_rz*R_rear_axle_aux4_x_z;
  const double s4_21 = zd_rear_axle_rz*R_rear_axle_aux4_z_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double s4_22 = zd_rear_axle_ry*work.s1_48;
  const double s4_23 = zd_rear_axle_ry*R_rear_axle_aux4_y_y;
  const double s4_24 = zd_rear_axle_ry*work.s1_50;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s4_25 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  const double s4_26 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  const double s4_27 = zd_rear_axle_rx*work.R_rear_axle_aux5_z_x;

  // --- step 1: poses and axes b, continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  work.s1_55 = fma(s1_9, s1_11, s1_6*s1_7);
  const double s1_56 = 1.0/work.s1_55;
  work.s1_57 = s1_6*s1_56;
  work.s1_58 = s1_9*s1_56;
  work.s1_59 = s1_8*s1_56;
  work.s1_60 = s1_12*s1_56;
  work.s1_61 = work.s1_55*s1_56;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_62 = work.R_carrier_left_aux1_z_x*work.s1_22;
  const double s1_63 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s1_62);
  const double s1_64 = work.R_carrier_left_aux1_y_x*work.s1_22;
  const double s1_65 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s1_64);
  const double s1_66 = work.R_carrier_left_aux1_z_z*s1_65;
  const double s1_67 = 1.0/fnma(work.R_carrier_left_aux1_y_z, s1_63, s1_66);
  work.s1_68 = R_carrier_left_aux1_y_y*s1_67;
  work.s1_69 = s1_65*s1_67;
  const double s1_70 = work.R_carrier_left_aux1_y_z*work.R_carrier_left_aux1_z_x;
  const double s1_71 = fnma(work.R_carrier_left_aux1_z_z, work.R_carrier_left_aux1_y_x, s1_70);
  const double s1_72 = s1_67*s1_71;
  const double s1_73 = work.R_carrier_left_aux1_y_x*work.R_carrier_left_aux2_z_y;
  const double s1_74 = fnma(work.R_carrier_left_aux1_z_x, work.R_carrier_left_aux2_y_y, s1_73);
  const double s1_75 = s1_67*s1_74;
  work.s1_76 = R_carrier_left_aux1_x_x*work.R_carrier_left_aux1_y_z*s1_67;
  work.s1_77 = s1_63*s1_67;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_78 = work.R_carrier_right_aux1_z_x*work.s1_35;
  const double s1_79 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s1_78);
  const double s1_80 = work.R_carrier_right_aux1_y_x*work.s1_35;
  const double s1_81 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s1_80);
  const double s1_82 = work.R_carrier_right_aux1_z_z*s1_81;
  const double s1_83 = 1.0/fnma(work.R_carrier_right_aux1_y_z, s1_79, s1_82);
  work.s1_84 = R_carrier_right_aux1_y_y*s1_83;
  work.s1_85 = s1_81*s1_83;
  const double s1_86 = work.R_carrier_right_aux1_y_z*work.R_carrier_right_aux1_z_x;
  const double s1_87 = fnma(work.R_carrier_right_aux1_z_z, work.R_carrier_right_aux1_y_x, s1_86);
  const double s1_88 = s1_83*s1_87;
  const double s1_89 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s1_90 = fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y, s1_89);
  const double s1_91 = s1_83*s1_90;
  work.s1_92 = R_carrier_right_aux1_x_x*work.R_carrier_right_aux1_y_z*s1_83;
  work.s1_93 = s1_79*s1_83;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_94 = R_rear_axle_aux4_y_y*work.R_rear_axle_aux5_x_x;
  const double s1_95 = fma(work.s1_48, work.R_rear_axle_aux5_y_x, s1_94);
  const double s1_96 = work.s1_50*work.R_rear_axle_aux5_y_x;
  const double s1_97 = fma(R_rear_axle_aux4_y_y, work.R_rear_axle_aux5_z_x, s1_96);
  const double s1_98 = 1.0/fnma(R_rear_axle_aux4_z_z, s1_95, R_rear_axle_aux4_x_z*s1_97);
  work.s1_99 = R_rear_axle_aux4_y_y*R_rear_axle_aux4_x_z*s1_98;
  work.s1_100 = s1_97*s1_98;
  const double s1_101 = fnma(R_rear_axle_aux4_z_z, work.s1_48, R_rear_axle_aux4_x_z*work.s1_50);
  work.s1_102 = s1_98*s1_101;
  const double s1_103 = work.s1_48*work.R_rear_axle_aux5_z_x;
  work.s1_104 = s1_98*fnma(work.s1_50, work.R_rear_axle_aux5_x_x, s1_103);
  work.s1_105 = R_rear_axle_aux4_x_x*s1_98;
  work.s1_106 = s1_95*s1_98;
  // operations: 64 add, 158 multiply, 4 divide, 44 sin cos, 15 other

  // --- step 4: velocities, continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s4_28 = work.s4_7 + work.s4_10;
  work.s4_29 = work.s4_12 + work.s4_28;
  work.s4_30 = work.s4_6 + work.s4_9;
  work.s4_31 = work.s4_11 + work.s4_30;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s4_32 = work.s4_14 + work.s4_17;
  work.s4_33 = work.s4_19 + work.s4_32;
  work.s4_34 = work.s4_13 + work.s4_16;
  work.s4_35 = work.s4_18 + work.s4_34;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.s4_36 = s4_23 + s4_26;
  const double s4_37 = s4_21 - s4_24;
  work.s4_38 = s4_27 + s4_37;
  const double s4_39 = s4_20 - s4_22;
  work.s4_40 = s4_25 + s4_39;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s4_41 = zd_lower_arm_left + work.s4_8;
  work.s4_42 = fnma(zd_carrier_left_ry, work.s1_22, work.s4_41);
  work.s4_43 = zd_lower_arm_left*work.s1_18;
  work.s4_44 = zd_lower_arm_left*work.s1_20;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s4_45 = zd_lower_arm_right + work.s4_15;
  work.s4_46 = fnma(zd_carrier_right_ry, work.s1_35, work.s4_45);
  work.s4_47 = zd_lower_arm_right*work.s1_30;
  work.s4_48 = zd_lower_arm_right*work.s1_32;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.w_carrier_left_x = work.w_chassis_x + work.s4_42;
  work.w_carrier_left_y = work.w_chassis_y + work.s4_31;
  work.w_carrier_left_z = work.w_chassis_z + work.s4_29;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.w_carrier_right_x = work.w_chassis_x + work.s4_46;
  work.w_carrier_right_y = work.w_chassis_y + work.s4_35;
  work.w_carrier_right_z = work.w_chassis_z + work.s4_33;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double w_rear_axle_x = work.w_chassis_x + work.s4_40;
  const double w_rear_axle_y = work.w_chassis_y + work.s4_36;
  const double w_rear_axle_z = work.w_chassis_z + work.s4_38;
  // operations: 29 add, 33 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  const double s7_1 = R_carrier_left_aux1_x_x*tau[Coordinate::carrier_left_rx];
  const double s7_2 = fma(tau[Coordinate::carrier_left_ry], s1_72, s7_1);
  work.s7_3 = fma(tau[Coordinate::carrier_left_rz], s1_75, s7_2);
  const double s7_4 = R_carrier_right_aux1_x_x*tau[Coordinate::carrier_right_rx];
  const double s7_5 = fma(tau[Coordinate::carrier_right_ry], s1_88, s7_4);
  work.s7_6 = fma(tau[Coordinate::carrier_right_rz], s1_91, s7_5);
  // operations: 4 add, 6 multiply

  // --- step 8: elimination from the leaves to the root (63) ---
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s8_1 = work.R_rear_axle_x_y*w_rear_axle_z;
  const double s8_2 = fnma(work.R_rear_axle_z_y, w_rear_axle_x, s8_1);
  const double s8_3 = work.R_rear_axle_x_y*w_rear_axle_x;
  const double s8_4 = fma(work.R_rear_axle_y_y, w_rear_axle_y, s8_3);
  const double s8_5 = fma(work.R_rear_axle_z_y, w_rear_axle_z, s8_4);
  const double s8_6 = state.zd[Coordinate::wheel_rear_right] + s8_5;
  const double s8_7 = work.R_rear_axle_z_y*w_rear_axle_y;
  const double s8_8 = fnma(work.R_rear_axle_y_y, w_rear_axle_z, s8_7);
  const double s8_9 = work.R_rear_axle_y_y*w_rear_axle_x;
  const double s8_10 = fnma(work.R_rear_axle_x_y, w_rear_axle_y, s8_9);
  const double s8_11 = state.zd[Coordinate::wheel_rear_left] + s8_5;

  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  const double s3_1 = R_rear_axle_aux4_y_y*projection.Rz[50];
  work.s3_2 = fma(work.R_rear_axle_aux5_y_x, projection.Rz[52], s3_1);
  const double s3_3 = R_rear_axle_aux4_y_y*projection.Rz[51];
  work.s3_4 = fma(work.R_rear_axle_aux5_y_x, projection.Rz[53], s3_3);
  const double s3_5 = R_rear_axle_aux4_z_z*projection.Rz[48];
  const double s3_6 = fnma(work.s1_50, projection.Rz[50], s3_5);
  work.s3_7 = fma(work.R_rear_axle_aux5_z_x, projection.Rz[52], s3_6);
  const double s3_8 = R_rear_axle_aux4_z_z*projection.Rz[49];
  const double s3_9 = fnma(work.s1_50, projection.Rz[51], s3_8);
  work.s3_10 = fma(work.R_rear_axle_aux5_z_x, projection.Rz[53], s3_9);
  const double s3_11 = R_rear_axle_aux4_x_z*projection.Rz[48];
  const double s3_12 = fnma(work.s1_48, projection.Rz[50], s3_11);
  work.s3_13 = fma(work.R_rear_axle_aux5_x_x, projection.Rz[52], s3_12);
  const double s3_14 = R_rear_axle_aux4_x_z*projection.Rz[49];
  const double s3_15 = fnma(work.s1_48, projection.Rz[51], s3_14);
  work.s3_16 = fma(work.R_rear_axle_aux5_x_x, projection.Rz[53], s3_15);
  // operations: 10 add, 16 multiply

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right ---
  const double s6_1 = R_rear_axle_aux4_x_z*projection.zdd_star[17];
  const double s6_2 = fnma(work.s1_48, projection.zdd_star[18], s6_1);
  const double s6_3 = fma(work.R_rear_axle_aux5_x_x, projection.zdd_star[19], s6_2);
  work.s6_4 = fma(s4_23, s4_27 - s4_21, fnma(s4_26, s4_37, s6_3));
  const double s6_5 = R_rear_axle_aux4_z_z*projection.zdd_star[17];
  const double s6_6 = fnma(work.s1_50, projection.zdd_star[18], s6_5);
  const double s6_7 = fma(work.R_rear_axle_aux5_z_x, projection.zdd_star[19], s6_6);
  work.s6_8 = fma(s4_23, s4_20 - s4_25, fma(s4_26, s4_39, s6_7));
  const double s6_9 = fnma(s4_21, s4_22, s4_20*s4_24);
  const double s6_10 = fma(R_rear_axle_aux4_y_y, projection.zdd_star[18], s6_9);
  const double s6_11 = fma(work.R_rear_axle_aux5_y_x, projection.zdd_star[19], s6_10);
  work.s6_12 = fnma(s4_27, s4_39, fma(s4_25, s4_37, s6_11));
  // operations: 15 add, 16 multiply

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_7 = h_rear_axle_x*work.R_rear_axle_aux5_y_x;
  work.s7_8 = fma(h_rear_axle_z, work.R_rear_axle_y_z, s7_7);
  const double s7_9 = h_rear_axle_x*work.R_rear_axle_aux5_z_x;
  work.s7_10 = fma(h_rear_axle_z, work.R_rear_axle_z_z, s7_9);
  const double s7_11 = h_rear_axle_x*work.R_rear_axle_aux5_x_x;
  work.s7_12 = fma(h_rear_axle_z, work.R_rear_axle_x_z, s7_11);
  const double s7_13 = K_rear_axle_yy*work.R_rear_axle_x_y;
  const double s7_14 = K_rear_axle_xx*work.R_rear_axle_aux5_x_x;
  const double s7_15 = fma(K_rear_axle_xz, work.R_rear_axle_x_z, s7_14);
  const double s7_16 = K_rear_axle_xz*work.R_rear_axle_aux5_x_x;
  const double s7_17 = fma(K_rear_axle_zz, work.R_rear_axle_x_z, s7_16);
  const double s7_18 = fma(work.R_rear_axle_aux5_y_x, s7_15, work.R_rear_axle_y_y*s7_13);
  work.s7_19 = fma(work.R_rear_axle_y_z, s7_17, s7_18);
  const double s7_20 = K_rear_axle_yy*work.R_rear_axle_y_y;
  const double s7_21 = K_rear_axle_xx*work.R_rear_axle_aux5_y_x;
  const double s7_22 = fma(K_rear_axle_xz, work.R_rear_axle_y_z, s7_21);
  const double s7_23 = K_rear_axle_xz*work.R_rear_axle_aux5_y_x;
  const double s7_24 = fma(K_rear_axle_zz, work.R_rear_axle_y_z, s7_23);
  const double s7_25 = fma(work.R_rear_axle_aux5_z_x, s7_22, work.R_rear_axle_z_y*s7_20);
  work.s7_26 = fma(work.R_rear_axle_z_z, s7_24, s7_25);
  const double s7_27 = fma(work.R_rear_axle_aux5_z_x, s7_15, work.R_rear_axle_z_y*s7_13);
  work.s7_28 = fma(work.R_rear_axle_z_z, s7_17, s7_27);
  const double s7_29 = fma(work.R_rear_axle_aux5_x_x, s7_15, work.R_rear_axle_x_y*s7_13);
  work.s7_30 = fma(work.R_rear_axle_x_z, s7_17, s7_29);
  work.s7_31 = K_rear_axle_trace - work.s7_30;
  const double s7_32 = fma(work.R_rear_axle_aux5_y_x, s7_22, work.R_rear_axle_y_y*s7_20);
  work.s7_33 = fma(work.R_rear_axle_y_z, s7_24, s7_32);
  work.s7_34 = work.s7_31 - work.s7_33;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_x = work.cosines[20];
  work.s7_35 = K_arb_rear_left_xy*R_arb_rear_left_x_x;
  work.s7_36 = h_arb_rear_left_x*R_arb_rear_left_x_x;
  const double R_arb_rear_left_x_z = work.sines[20];
  work.s7_37 = K_arb_rear_left_xy*R_arb_rear_left_x_z;
  work.s7_38 = h_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_39 = K_arb_rear_left_zz*R_arb_rear_left_x_z;
  const double s7_40 = K_arb_rear_left_xx*R_arb_rear_left_x_x;
  work.s7_41 = fnma(R_arb_rear_left_x_z, s7_40, R_arb_rear_left_x_x*s7_39);
  work.s7_42 = fma(R_arb_rear_left_x_x, s7_40, R_arb_rear_left_x_z*s7_39);
  work.s7_43 = 0.4225 - work.s7_42;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_z = work.sines[21];
  work.s7_44 = -K_arb_rear_right_xy*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = work.cosines[21];
  work.s7_45 = h_arb_rear_right_x*R_arb_rear_right_x_x;
  work.s7_46 = h_arb_rear_right_x*R_arb_rear_right_x_z;
  work.s7_47 = -K_arb_rear_right_xy*R_arb_rear_right_x_x;
  const double s7_48 = K_arb_rear_right_zz*R_arb_rear_right_x_z;
  const double s7_49 = K_arb_rear_right_xx*R_arb_rear_right_x_x;
  work.s7_50 = fnma(R_arb_rear_right_x_z, s7_49, R_arb_rear_right_x_x*s7_48);
  work.s7_51 = fma(R_arb_rear_right_x_x, s7_49, R_arb_rear_right_x_z*s7_48);
  work.s7_52 = 0.4225 - work.s7_51;
  // operations: 25 add, 51 multiply

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right
  // ---
  work.s8_12 = work.w_chassis_y + work.w_chassis_y;
  work.s8_13 = work.w_chassis_x + work.w_chassis_x;
  work.s8_14 = work.w_chassis_z + work.w_chassis_z;
  work.s8_15 = work.w_chassis_x*work.w_chassis_y;
  work.s8_16 = work.w_chassis_y*work.w_chassis_z;
  work.s8_17 = work.w_chassis_x*work.w_chassis_z;
  const double s8_18 = work.w_chassis_y*work.w_chassis_y;
  const double s8_19 = work.w_chassis_x*work.w_chassis_x;
  work.s8_20 = s8_18 + s8_19;
  work.s8_21 = fma(work.w_chassis_z, work.w_chassis_z, s8_18);
  work.s8_22 = fma(work.w_chassis_z, work.w_chassis_z, s8_19);
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.s8_23 = projection.Rz[56]*work.s7_46;
  work.s8_24 = projection.Rz[56]*work.s7_45;
  work.s8_25 = projection.Rz[57]*work.s7_46;
  work.s8_26 = projection.Rz[57]*work.s7_45;
  work.s8_27 = 0.4225*projection.Rz[56];
  work.s8_28 = 0.4225*projection.Rz[57];
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  work.s8_29 = zd_arb_rear_right*(zd_arb_rear_right + work.s8_12);
  work.s8_30 = 2.025 + work.s7_46;
  work.s8_31 = zd_arb_rear_right*work.s8_14;
  work.s8_32 = work.s8_21 - work.s8_22;
  work.s8_33 = work.s7_45 - 14.85;
  work.s8_34 = fma(work.s7_45, work.s8_29, projection.zdd_star[21]*work.s7_46);
  work.s8_35 = zd_arb_rear_right*work.s8_13;
  work.s8_36 = fnma(work.s7_46, work.s8_31, work.s7_45*work.s8_35);
  const double s8_37 = fma(p_arb_rear_right_z, work.s8_17, -p_arb_rear_right_x*work.s8_21);
  work.s8_38 = fma(p_arb_rear_right_y, work.s8_15, s8_37);
  work.s8_39 = fnma(projection.zdd_star[21], work.s7_45, work.s7_46*work.s8_29);
  const double s8_40 = fma(p_arb_rear_right_x, work.s8_17, -p_arb_rear_right_z*work.s8_20);
  work.s8_41 = fma(p_arb_rear_right_y, work.s8_16, s8_40);
  work.s8_42 = work.s8_22 - work.s8_20;
  work.s8_43 = work.s8_20 - work.s8_21;
  work.s8_44 = work.s7_52 - work.s7_51;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.s8_45 = 2.025 + work.s7_38;
  work.s8_46 = 0.4225*projection.Rz[54];
  work.s8_47 = 0.4225*projection.Rz[55];
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  work.s8_48 = zd_arb_rear_left*(zd_arb_rear_left + work.s8_12);
  work.s8_49 = work.s7_36 - 14.85;
  work.s8_50 = fnma(p_arb_rear_right_y, work.s8_15, s8_37);
  work.s8_51 = zd_arb_rear_left*work.s8_14;
  work.s8_52 = zd_arb_rear_left*work.s8_13;
  work.s8_53 = fnma(work.s7_38, work.s8_51, work.s7_36*work.s8_52);
  work.s8_54 = fnma(p_arb_rear_right_y, work.s8_16, s8_40);
  work.s8_55 = fnma(projection.zdd_star[20], work.s7_36, work.s7_38*work.s8_48);
  work.s8_56 = fma(work.s7_36, work.s8_48, projection.zdd_star[20]*work.s7_38);
  work.s8_57 = work.s7_43 - work.s7_42;
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_58 = fma(zd_rear_axle_tz, work.s8_12, projection.zdd_star[14]);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_59 = fnma(zd_rear_axle_ty, work.s8_14, s8_58);
  const double s8_60 = fma(z_rear_axle_ty, work.s8_15, s8_59);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_61 = fma(work.r_rear_axle_aux3_z, work.s8_17, s8_60);
  const double s8_62 = fnma(work.r_rear_axle_aux1_x, work.s8_21, s8_61);
  const double s8_63 = fnma(work.w_chassis_y, work.s4_40, work.w_chassis_x*work.s4_36);
  work.s8_64 = work.s6_8 + s8_63;
  const double s8_65 = fms(w_rear_axle_x, w_rear_axle_y, work.s8_64);
  const double s8_66 = fnma(work.w_chassis_x, work.s4_38, work.w_chassis_z*work.s4_40);
  work.s8_67 = work.s6_12 + s8_66;
  const double s8_68 = fma(w_rear_axle_x, w_rear_axle_z, work.s8_67);
  const double s8_69 = w_rear_axle_y*w_rear_axle_y;
  const double s8_70 = w_rear_axle_z*w_rear_axle_z;
  const double s8_71 = s8_69 + s8_70;
  const double s8_72 = fma(work.s7_10, s8_68, fma(work.s7_8, s8_65, m_rear_axle_2*s8_62));
  work.f_rear_axle_x = fnma(work.s7_12, s8_71, s8_72);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s8_73 = fnma(zd_rear_axle_tz, work.s8_13, projection.zdd_star[15]);
  const double s8_74 = fma(zd_rear_axle_tx, work.s8_14, s8_73);
  const double s8_75 = fma(work.r_rear_axle_aux1_x, work.s8_15, s8_74);
  const double s8_76 = fma(work.r_rear_axle_aux3_z, work.s8_16, s8_75);
  const double s8_77 = fnma(z_rear_axle_ty, work.s8_22, s8_76);
  const double s8_78 = fnma(work.w_chassis_z, work.s4_36, work.w_chassis_y*work.s4_38);
  work.s8_79 = work.s6_4 + s8_78;
  const double s8_80 = fms(w_rear_axle_y, w_rear_axle_z, work.s8_79);
  const double s8_81 = fma(w_rear_axle_x, w_rear_axle_y, work.s8_64);
  const double s8_82 = fma(w_rear_axle_x, w_rear_axle_x, s8_70);
  const double s8_83 = fma(work.s7_12, s8_81, fma(work.s7_10, s8_80, m_rear_axle_2*s8_77));
  work.f_rear_axle_y = fnma(work.s7_8, s8_82, s8_83);
  const double s8_84 = fnma(zd_rear_axle_tx, work.s8_12, projection.zdd_star[16]);
  const double s8_85 = fma(z_rear_axle_ty, work.s8_16, fma(zd_rear_axle_ty, work.s8_13, s8_84));
  const double s8_86 = fma(work.r_rear_axle_aux1_x, work.s8_17, s8_85);
  const double s8_87 = fnma(work.r_rear_axle_aux3_z, work.s8_20, s8_86);
  const double s8_88 = fma(w_rear_axle_y, w_rear_axle_z, work.s8_79);
  const double s8_89 = fms(w_rear_axle_x, w_rear_axle_z, work.s8_67);
  const double s8_90 = fma(w_rear_axle_x, w_rear_axle_x, s8_69);
  const double s8_91 = fma(work.s7_12, s8_89, fma(work.s7_8, s8_88, m_rear_axle_2*s8_87));
  work.f_rear_axle_z = fnma(work.s7_10, s8_90, s8_91);
  const double s8_92 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_93 = I_wheel_rear_right_polar*(s8_6 + s8_11);
  const double s8_94 = fnma(work.s7_34, s8_80, fnma(work.s7_10, s8_77, work.s7_8*s8_87));
  const double s8_95 = fma(work.s7_33, s8_88, fnma(work.s7_28, s8_81, s8_94));
  const double s8_96 = fma(work.s7_26, s8_82 - s8_90, fma(work.s7_19, s8_89, s8_95));
  work.n_rear_axle_x = fma(s8_8, s8_93, fma(work.R_rear_axle_x_y, s8_92, s8_96));
  const double s8_97 = fma(work.s7_34, s8_68, fma(work.s7_26, s8_65, work.s7_10*s8_62));
  const double s8_98 = fnma(work.s7_19, s8_88, fnma(work.s7_12, s8_87, s8_97));
  const double s8_99 = fma(work.R_rear_axle_y_y, s8_92, fnma(work.s7_30, s8_89, s8_98));
  work.n_rear_axle_y = fma(work.s7_28, s8_90 - s8_71, fma(s8_2, s8_93, s8_99));
  const double s8_100 = fnma(work.s7_33, s8_65, fnma(work.s7_8, s8_62, work.s7_12*s8_77));
  const double s8_101 = fma(work.s7_28, s8_80, fnma(work.s7_26, s8_68, s8_100));
  const double s8_102 = fma(work.R_rear_axle_z_y, s8_92, fma(work.s7_30, s8_81, s8_101));
  work.n_rear_axle_z = fma(work.s7_19, s8_71 - s8_82, fma(s8_10, s8_93, s8_102));
}

/// Part 2 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_chosen_accelerations_2(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_103 = K_rear_axle_trace - work.s7_33;
  const double s8_104 = K_rear_axle_trace - work.s7_34;
  const double s8_105 = fnma(work.s3_7, work.s7_8, m_rear_axle_2*projection.Rz[42]);
  const double s8_106 = fma(work.s3_2, work.s7_10, s8_105);
  const double s8_107 = fnma(work.s3_10, work.s7_8, m_rear_axle_2*projection.Rz[43]);
  const double s8_108 = fma(work.s3_4, work.s7_10, s8_107);
  work.s8_109 = fnma(projection.Rz[55], work.s7_38, s8_108 - work.s8_25);
  const double s8_110 = fma(work.s3_13, work.s7_8, m_rear_axle_2*projection.Rz[46]);
  const double s8_111 = fnma(work.s3_2, work.s7_12, s8_110);
  const double s8_112 = fma(work.s3_16, work.s7_8, m_rear_axle_2*projection.Rz[47]);
  const double s8_113 = fnma(work.s3_4, work.s7_12, s8_112);
  work.s8_114 = fnma(projection.Rz[55], work.s7_36, s8_113 - work.s8_26);
  work.s8_115 = fma(593.0, work.r_rear_axle_aux1_x, work.s7_12);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.s8_116 = fma(593.0, z_rear_axle_ty, work.s7_8);
  work.s8_117 = fma(593.0, work.r_rear_axle_aux3_z, work.s7_10);
  const double s8_118 = fnma(projection.Rz[44], work.s7_10, projection.Rz[46]*work.s7_8);
  const double s8_119 = fnma(work.s3_7, work.s7_28, fnma(work.s3_2, work.s7_19, s8_118));
  const double s8_120 = fma(work.s3_13, work.s7_31, s8_119);
  const double s8_121 = fnma(work.s3_13, work.s7_10, m_rear_axle_2*projection.Rz[44]);
  const double s8_122 = fma(work.s3_7, work.s7_12, s8_121);
  const double s8_123 = fnma(projection.Rz[45], work.s7_10, projection.Rz[47]*work.s7_8);
  const double s8_124 = fnma(work.s3_10, work.s7_28, fnma(work.s3_4, work.s7_19, s8_123));
  const double s8_125 = fma(work.s3_16, work.s7_31, s8_124);
  const double s8_126 = fnma(work.s3_16, work.s7_10, m_rear_axle_2*projection.Rz[45]);
  work.s8_127 = fma(work.s3_10, work.s7_12, s8_126);
  const double s8_128 = fnma(projection.Rz[42], work.s7_8, projection.Rz[44]*work.s7_12);
  const double s8_129 = fnma(work.s3_13, work.s7_28, fnma(work.s3_2, work.s7_26, s8_128));
  const double s8_130 = fma(work.s3_7, s8_104, s8_129);
  const double s8_131 = fnma(projection.Rz[43], work.s7_8, projection.Rz[45]*work.s7_12);
  const double s8_132 = fnma(work.s3_16, work.s7_28, fnma(work.s3_4, work.s7_26, s8_131));
  const double s8_133 = fma(work.s3_10, s8_104, s8_132);
  const double s8_134 = fnma(projection.Rz[46], work.s7_12, projection.Rz[42]*work.s7_10);
  const double s8_135 = fnma(work.s3_7, work.s7_26, fnma(work.s3_13, work.s7_19, s8_134));
  const double s8_136 = fma(work.s3_2, s8_103, s8_135);
  const double s8_137 = fnma(projection.Rz[47], work.s7_12, projection.Rz[43]*work.s7_10);
  const double s8_138 = fnma(work.s3_10, work.s7_26, fnma(work.s3_16, work.s7_19, s8_137));
  const double s8_139 = fma(work.s3_4, s8_103, s8_138);
  work.s8_140 = work.r_rear_axle_aux3_z + work.r_rear_axle_aux3_z;
  work.s8_141 = z_rear_axle_ty + z_rear_axle_ty;
  work.s8_142 = work.r_rear_axle_aux1_x + work.r_rear_axle_aux1_x;
  // long_rod_left
  const double s8_143 = p_long_rod_left_to_x*work.R_rear_axle_aux5_z_x;
  const double s8_144 = fma(p_long_rod_left_to_z, work.R_rear_axle_z_z, s8_143);
  const double s8_145 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s8_144);
  const double s8_146 = work.r_rear_axle_aux3_z - p_long_rod_left_from_z;
  work.s8_147 = s8_145 + s8_146;
  const double s8_148 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s8_149 = fma(p_long_rod_left_to_z, work.R_rear_axle_x_z, s8_148);
  const double s8_150 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s8_149);
  const double s8_151 = work.r_rear_axle_aux1_x - p_long_rod_left_from_x;
  work.s8_152 = s8_150 + s8_151;
  const double s8_153 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s8_154 = fma(p_long_rod_left_to_z, work.R_rear_axle_y_z, s8_153);
  const double s8_155 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s8_154);
  const double s8_156 = fnma(work.s4_38, s8_155, work.s4_36*s8_145);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s8_157 = zd_rear_axle_tx + s8_156;
  const double s8_158 = fnma(work.s4_40, s8_145, work.s4_38*s8_150);
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_159 = zd_rear_axle_ty + s8_158;
  const double s8_160 = fnma(work.s4_36, s8_150, work.s4_40*s8_155);
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s8_161 = zd_rear_axle_tz + s8_160;
  const double s8_162 = fnma(work.s3_7, s8_155, fma(work.s3_2, s8_145, projection.Rz[42]));
  const double s8_163 = fnma(work.s3_10, s8_155, fma(work.s3_4, s8_145, projection.Rz[43]));
  const double s8_164 = fma(work.s3_7, s8_150, fnma(work.s3_13, s8_145, projection.Rz[44]));
  const double s8_165 = fma(work.s3_10, s8_150, fnma(work.s3_16, s8_145, projection.Rz[45]));
  const double s8_166 = fma(work.s3_13, s8_155, fnma(work.s3_2, s8_150, projection.Rz[46]));
  const double s8_167 = fma(work.s3_16, s8_155, fnma(work.s3_4, s8_150, projection.Rz[47]));
  work.s8_168 = p_long_rod_left_from_y - z_rear_axle_ty - s8_155;
  work.s8_169 = 3.0*work.s8_168;
  work.s8_170 = 3.0*work.s8_152;
  work.s8_171 = 3.0*work.s8_147;
  const double s8_172 = fms(work.s8_21, work.s8_152, projection.zdd_star[14]);
  const double s8_173 = fnma(work.s8_17, work.s8_147, fnma(work.s6_12, s8_145, s8_172));
  const double s8_174 = fma(work.s4_38, s8_158, fma(work.s6_8, s8_155, s8_173));
  const double s8_175 = fnma(work.s4_36, s8_160, fma(work.s8_14, s8_159, s8_174));
  work.s8_176 = 3.0*fma(work.s8_15, work.s8_168, fnma(work.s8_12, s8_161, s8_175));
  const double s8_177 = fms(work.s8_20, work.s8_147, projection.zdd_star[16]);
  const double s8_178 = fnma(work.s8_17, work.s8_152, fma(work.s6_12, s8_150, s8_177));
  const double s8_179 = fma(work.s4_36, s8_156, fnma(work.s6_4, s8_155, s8_178));
  const double s8_180 = fnma(work.s4_40, s8_158, fma(work.s8_12, s8_157, s8_179));
  work.s8_181 = 3.0*fma(work.s8_16, work.s8_168, fnma(work.s8_13, s8_159, s8_180));
  const double s8_182 = fms(work.s6_4, s8_145, projection.zdd_star[15]);
  const double s8_183 = fnma(work.s6_8, s8_150, fnma(work.s8_16, work.s8_147, s8_182));
  const double s8_184 = fnma(work.s4_38, s8_156, fnma(work.s8_15, work.s8_152, s8_183));
  const double s8_185 = fma(work.s4_40, s8_160, fnma(work.s8_14, s8_157, s8_184));
  work.s8_186 = 3.0*fnma(work.s8_22, work.s8_168, fma(work.s8_13, s8_161, s8_185));
  // diag_rod_left
  const double s8_187 = p_diag_rod_left_to_z*work.R_rear_axle_z_z;
  const double s8_188 = fma(p_diag_rod_left_to_y, work.R_rear_axle_z_y, s8_187);
  const double s8_189 = work.r_rear_axle_aux3_z - p_diag_rod_left_from_z;
  work.s8_190 = s8_188 + s8_189;
  const double s8_191 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  const double s8_192 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s8_191);
  const double s8_193 = work.r_rear_axle_aux1_x - p_diag_rod_left_from_x;
  work.s8_194 = s8_192 + s8_193;
  const double s8_195 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  const double s8_196 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s8_195);
  const double s8_197 = fnma(work.s4_38, s8_196, work.s4_36*s8_188);
  const double s8_198 = zd_rear_axle_tx + s8_197;
  const double s8_199 = fnma(work.s4_40, s8_188, work.s4_38*s8_192);
  const double s8_200 = zd_rear_axle_ty + s8_199;
  const double s8_201 = fnma(work.s4_36, s8_192, work.s4_40*s8_196);
  const double s8_202 = zd_rear_axle_tz + s8_201;
  const double s8_203 = fnma(work.s3_7, s8_196, fma(work.s3_2, s8_188, projection.Rz[42]));
  const double s8_204 = fnma(work.s3_10, s8_196, fma(work.s3_4, s8_188, projection.Rz[43]));
  const double s8_205 = fma(work.s3_7, s8_192, fnma(work.s3_13, s8_188, projection.Rz[44]));
  const double s8_206 = fma(work.s3_10, s8_192, fnma(work.s3_16, s8_188, projection.Rz[45]));
  const double s8_207 = fma(work.s3_13, s8_196, fnma(work.s3_2, s8_192, projection.Rz[46]));
  const double s8_208 = fma(work.s3_16, s8_196, fnma(work.s3_4, s8_192, projection.Rz[47]));
  work.s8_209 = p_diag_rod_left_from_y - z_rear_axle_ty - s8_196;
  work.s8_210 = 2.6666666666666665*work.s8_209;
  work.s8_211 = 2.6666666666666665*work.s8_194;
  work.s8_212 = 2.6666666666666665*work.s8_190;
  const double s8_213 = fms(work.s8_21, work.s8_194, projection.zdd_star[14]);
  const double s8_214 = fnma(work.s8_17, work.s8_190, fnma(work.s6_12, s8_188, s8_213));
  const double s8_215 = fma(work.s4_38, s8_199, fma(work.s6_8, s8_196, s8_214));
  const double s8_216 = fnma(work.s4_36, s8_201, fma(work.s8_14, s8_200, s8_215));
  const double s8_217 = fma(work.s8_15, work.s8_209, fnma(work.s8_12, s8_202, s8_216));
  work.s8_218 = 2.6666666666666665*s8_217;
  const double s8_219 = fms(work.s8_20, work.s8_190, projection.zdd_star[16]);
  const double s8_220 = fnma(work.s8_17, work.s8_194, fma(work.s6_12, s8_192, s8_219));
  const double s8_221 = fma(work.s4_36, s8_197, fnma(work.s6_4, s8_196, s8_220));
  const double s8_222 = fnma(work.s4_40, s8_199, fma(work.s8_12, s8_198, s8_221));
  const double s8_223 = fma(work.s8_16, work.s8_209, fnma(work.s8_13, s8_200, s8_222));
  work.s8_224 = 2.6666666666666665*s8_223;
  const double s8_225 = fms(work.s6_4, s8_188, projection.zdd_star[15]);
  const double s8_226 = fnma(work.s6_8, s8_192, fnma(work.s8_16, work.s8_190, s8_225));
  const double s8_227 = fnma(work.s4_38, s8_197, fnma(work.s8_15, work.s8_194, s8_226));
  const double s8_228 = fma(work.s4_40, s8_201, fnma(work.s8_14, s8_198, s8_227));
  const double s8_229 = fnma(work.s8_22, work.s8_209, fma(work.s8_13, s8_202, s8_228));
  work.s8_230 = 2.6666666666666665*s8_229;
  // arb_link_rear_left
  const double s8_231 = p_arb_link_rear_left_from_x*work.sines[20];
  const double s8_232 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s8_233 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s8_232);
  const double s8_234 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_z_x;
  const double s8_235 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s8_234);
  const double s8_236 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s8_237 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s8_236);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s8_238 = zd_arb_rear_left*s8_231;
  const double s8_239 = p_arb_link_rear_left_from_x*work.cosines[20];
  const double s8_240 = zd_arb_rear_left*s8_239;
  const double s8_241 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s8_235);
  const double s8_242 = work.r_rear_axle_aux3_z - p_arb_rear_left_z;
  work.s8_243 = s8_242 + (s8_231 + s8_241);
  const double s8_244 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s8_237);
  const double s8_245 = fnma(work.s4_40, s8_241, work.s4_38*s8_244);
  const double s8_246 = zd_rear_axle_ty + s8_245;
  const double s8_247 = fma(work.s3_7, s8_244, fnma(work.s3_13, s8_241, projection.Rz[44]));
  const double s8_248 = fma(work.s3_10, s8_244, fnma(work.s3_16, s8_241, projection.Rz[45]));
  work.s8_249 = s8_239 + p_arb_rear_left_x - work.r_rear_axle_aux1_x - s8_244;
  const double s8_250 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s8_233);
  work.s8_251 = 0.6 - z_rear_axle_ty - s8_250;
  work.s8_252 = 0.3333333333333333*work.s8_251;
  work.s8_253 = 0.3333333333333333*work.s8_249;
  const double s8_254 = fnma(work.s4_38, s8_250, work.s4_36*s8_241);
  const double s8_255 = s8_254 + (zd_rear_axle_tx + s8_238);
  const double s8_256 = fnma(work.s4_36, s8_244, work.s4_40*s8_250);
  const double s8_257 = s8_256 + (zd_rear_axle_tz + s8_240);
  const double s8_258 = fma(projection.Rz[54], s8_231, projection.Rz[42]);
  const double s8_259 = fnma(work.s3_7, s8_250, fma(work.s3_2, s8_241, s8_258));
  const double s8_260 = fma(projection.Rz[54], s8_239, projection.Rz[46]);
  const double s8_261 = fma(work.s3_13, s8_250, fnma(work.s3_2, s8_244, s8_260));
  const double s8_262 = fma(projection.Rz[55], s8_231, projection.Rz[43]);
  const double s8_263 = fnma(work.s3_10, s8_250, fma(work.s3_4, s8_241, s8_262));
  const double s8_264 = fma(projection.Rz[55], s8_239, projection.Rz[47]);
  const double s8_265 = fma(work.s3_16, s8_250, fnma(work.s3_4, s8_244, s8_264));
  work.s8_266 = 0.3333333333333333*work.s8_243;
  const double s8_267 = fms(zd_arb_rear_left, s8_238, projection.zdd_star[16]);
  const double s8_268 = fnma(projection.zdd_star[20], s8_239, s8_267);
  const double s8_269 = fma(work.s6_12, s8_244, fma(work.s8_20, work.s8_243, s8_268));
  const double s8_270 = fnma(work.s8_13, s8_246, fnma(work.s4_40, s8_245, s8_269));
  const double s8_271 = fnma(work.s6_4, s8_250, fma(work.s8_17, work.s8_249, s8_270));
  const double s8_272 = fma(work.s4_36, s8_254, fma(work.s8_16, work.s8_251, s8_271));
  work.s8_273 = 0.3333333333333333*fma(work.s8_12, s8_255, s8_272);
  const double s8_274 = fms(work.s4_38, s8_245, projection.zdd_star[14]);
  const double s8_275 = fnma(projection.zdd_star[20], s8_231, s8_274);
  const double s8_276 = fnma(work.s6_12, s8_241, fnma(zd_arb_rear_left, s8_240, s8_275));
  const double s8_277 = fma(work.s8_14, s8_246, fnma(work.s8_17, work.s8_243, s8_276));
  const double s8_278 = fma(work.s6_8, s8_250, fnma(work.s8_21, work.s8_249, s8_277));
  const double s8_279 = fnma(work.s4_36, s8_256, fma(work.s8_15, work.s8_251, s8_278));
  work.s8_280 = 0.3333333333333333*fnma(work.s8_12, s8_257, s8_279);
  const double s8_281 = fms(work.s6_4, s8_241, projection.zdd_star[15]);
  const double s8_282 = fnma(work.s6_8, s8_244, fnma(work.s8_16, work.s8_243, s8_281));
  const double s8_283 = fnma(work.s8_22, work.s8_251, fma(work.s8_15, work.s8_249, s8_282));
  const double s8_284 = fnma(work.s8_14, s8_255, fnma(work.s4_38, s8_254, s8_283));
  const double s8_285 = fma(work.s8_13, s8_257, fma(work.s4_40, s8_256, s8_284));
  work.s8_286 = 0.3333333333333333*s8_285;
  // long_rod_right
  const double s8_287 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s8_154);
  work.s8_288 = s8_287 + (z_rear_axle_ty - p_long_rod_right_from_y);
  const double s8_289 = fnma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s8_144);
  work.s8_290 = s8_146 + s8_289;
  const double s8_291 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s8_149);
  work.s8_292 = s8_151 + s8_291;
  const double s8_293 = fnma(work.s4_38, s8_287, work.s4_36*s8_289);
  const double s8_294 = zd_rear_axle_tx + s8_293;
  const double s8_295 = fnma(work.s4_40, s8_289, work.s4_38*s8_291);
  const double s8_296 = zd_rear_axle_ty + s8_295;
  const double s8_297 = fnma(work.s4_36, s8_291, work.s4_40*s8_287);
  const double s8_298 = zd_rear_axle_tz + s8_297;
  const double s8_299 = fma(work.s3_2, s8_289, fnma(work.s3_7, s8_287, projection.Rz[42]));
  const double s8_300 = fma(work.s3_4, s8_289, fnma(work.s3_10, s8_287, projection.Rz[43]));
  const double s8_301 = fma(work.s3_7, s8_291, fnma(work.s3_13, s8_289, projection.Rz[44]));
  const double s8_302 = fma(work.s3_10, s8_291, fnma(work.s3_16, s8_289, projection.Rz[45]));
  const double s8_303 = fnma(work.s3_2, s8_291, fma(work.s3_13, s8_287, projection.Rz[46]));
  const double s8_304 = fnma(work.s3_4, s8_291, fma(work.s3_16, s8_287, projection.Rz[47]));
  work.s8_305 = 3.0*work.s8_288;
  work.s8_306 = 3.0*work.s8_292;
  work.s8_307 = 3.0*work.s8_290;
  const double s8_308 = fms(work.s8_22, work.s8_288, projection.zdd_star[15]);
  const double s8_309 = fnma(work.s8_16, work.s8_290, fma(work.s6_4, s8_289, s8_308));
  const double s8_310 = fnma(work.s8_15, work.s8_292, fnma(work.s6_8, s8_291, s8_309));
  const double s8_311 = fnma(work.s8_14, s8_294, fnma(work.s4_38, s8_293, s8_310));
  work.s8_312 = 3.0*fma(work.s8_13, s8_298, fma(work.s4_40, s8_297, s8_311));
  const double s8_313 = fms(work.s8_20, work.s8_290, projection.zdd_star[16]);
  const double s8_314 = fnma(work.s8_16, work.s8_288, fnma(work.s6_4, s8_287, s8_313));
  const double s8_315 = fnma(work.s8_17, work.s8_292, fma(work.s6_12, s8_291, s8_314));
  const double s8_316 = fma(work.s8_12, s8_294, fma(work.s4_36, s8_293, s8_315));
  work.s8_317 = 3.0*fnma(work.s8_13, s8_296, fnma(work.s4_40, s8_295, s8_316));
  const double s8_318 = fms(work.s6_8, s8_287, projection.zdd_star[14]);
  const double s8_319 = fnma(work.s6_12, s8_289, fnma(work.s8_15, work.s8_288, s8_318));
  const double s8_320 = fma(work.s8_21, work.s8_292, fnma(work.s8_17, work.s8_290, s8_319));
  const double s8_321 = fma(work.s8_14, s8_296, fma(work.s4_38, s8_295, s8_320));
  work.s8_322 = 3.0*fnma(work.s8_12, s8_298, fnma(work.s4_36, s8_297, s8_321));
  // diag_rod_right
  const double s8_323 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_z_y, s8_187);
  work.s8_324 = s8_189 + s8_323;
  const double s8_325 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s8_195);
  work.s8_326 = s8_325 + (z_rear_axle_ty - p_diag_rod_right_from_y);
  const double s8_327 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s8_191);
  work.s8_328 = s8_193 + s8_327;
  const double s8_329 = fnma(work.s4_38, s8_325, work.s4_36*s8_323);
  const double s8_330 = zd_rear_axle_tx + s8_329;
  const double s8_331 = fnma(work.s4_40, s8_323, work.s4_38*s8_327);
  const double s8_332 = zd_rear_axle_ty + s8_331;
  const double s8_333 = fnma(work.s4_36, s8_327, work.s4_40*s8_325);
  const double s8_334 = zd_rear_axle_tz + s8_333;
  const double s8_335 = fnma(work.s3_7, s8_325, fma(work.s3_2, s8_323, projection.Rz[42]));
  const double s8_336 = fnma(work.s3_10, s8_325, fma(work.s3_4, s8_323, projection.Rz[43]));
  const double s8_337 = fma(work.s3_7, s8_327, fnma(work.s3_13, s8_323, projection.Rz[44]));
  const double s8_338 = fma(work.s3_10, s8_327, fnma(work.s3_16, s8_323, projection.Rz[45]));
  const double s8_339 = fnma(work.s3_2, s8_327, fma(work.s3_13, s8_325, projection.Rz[46]));
  const double s8_340 = fnma(work.s3_4, s8_327, fma(work.s3_16, s8_325, projection.Rz[47]));
  work.s8_341 = 2.6666666666666665*work.s8_326;
  work.s8_342 = 2.6666666666666665*work.s8_328;
  work.s8_343 = 2.6666666666666665*work.s8_324;
  const double s8_344 = fms(work.s6_4, s8_323, projection.zdd_star[15]);
  const double s8_345 = fma(work.s8_22, work.s8_326, fnma(work.s8_16, work.s8_324, s8_344));
  const double s8_346 = fnma(work.s8_15, work.s8_328, fnma(work.s6_8, s8_327, s8_345));
  const double s8_347 = fnma(work.s8_14, s8_330, fnma(work.s4_38, s8_329, s8_346));
  const double s8_348 = fma(work.s8_13, s8_334, fma(work.s4_40, s8_333, s8_347));
  work.s8_349 = 2.6666666666666665*s8_348;
  const double s8_350 = fms(work.s8_20, work.s8_324, projection.zdd_star[16]);
  const double s8_351 = fnma(work.s8_16, work.s8_326, fnma(work.s6_4, s8_325, s8_350));
  const double s8_352 = fnma(work.s8_17, work.s8_328, fma(work.s6_12, s8_327, s8_351));
  const double s8_353 = fma(work.s8_12, s8_330, fma(work.s4_36, s8_329, s8_352));
  const double s8_354 = fnma(work.s8_13, s8_332, fnma(work.s4_40, s8_331, s8_353));
  work.s8_355 = 2.6666666666666665*s8_354;
  const double s8_356 = fms(work.s6_8, s8_325, projection.zdd_star[14]);
  const double s8_357 = fnma(work.s8_17, work.s8_324, fnma(work.s6_12, s8_323, s8_356));
  const double s8_358 = fma(work.s8_21, work.s8_328, fnma(work.s8_15, work.s8_326, s8_357));
  const double s8_359 = fma(work.s8_14, s8_332, fma(work.s4_38, s8_331, s8_358));
  const double s8_360 = fnma(work.s8_12, s8_334, fnma(work.s4_36, s8_333, s8_359));
  work.s8_361 = 2.6666666666666665*s8_360;
  // arb_link_rear_right
  const double s8_362 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s8_233);
  const double s8_363 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s8_237);
  const double s8_364 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s8_235);
  const double s8_365 = p_arb_link_rear_right_from_x*work.sines[21];
  work.s8_366 = 0.6 + z_rear_axle_ty - s8_362;
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s8_367 = zd_arb_rear_right*s8_365;
  const double s8_368 = p_arb_link_rear_right_from_x*work.cosines[21];
  const double s8_369 = zd_arb_rear_right*s8_368;
  const double s8_370 = fnma(work.s4_38, s8_363, work.s4_40*s8_364);
  const double s8_371 = zd_rear_axle_ty + s8_370;
  const double s8_372 = fma(work.s3_13, s8_364, fnma(work.s3_7, s8_363, projection.Rz[44]));
  const double s8_373 = fma(work.s3_16, s8_364, fnma(work.s3_10, s8_363, projection.Rz[45]));
  work.s8_374 = s8_365 + (s8_242 - s8_364);
  work.s8_375 = 0.3333333333333333*work.s8_366;
  const double s8_376 = fnma(work.s4_36, s8_364, work.s4_38*s8_362);
  const double s8_377 = s8_376 + (zd_rear_axle_tx + s8_367);
  const double s8_378 = fnma(work.s4_40, s8_362, work.s4_36*s8_363);
  const double s8_379 = s8_378 + (zd_rear_axle_tz + s8_369);
  const double s8_380 = fnma(work.s3_2, s8_364, fma(work.s3_7, s8_362, projection.Rz[42]));
  const double s8_381 = fma(projection.Rz[56], s8_365, s8_380);
  const double s8_382 = fma(work.s3_2, s8_363, fnma(work.s3_13, s8_362, projection.Rz[46]));
  const double s8_383 = fma(projection.Rz[56], s8_368, s8_382);
  const double s8_384 = fnma(work.s3_4, s8_364, fma(work.s3_10, s8_362, projection.Rz[43]));
  const double s8_385 = fma(projection.Rz[57], s8_365, s8_384);
  const double s8_386 = fma(work.s3_4, s8_363, fnma(work.s3_16, s8_362, projection.Rz[47]));
  const double s8_387 = fma(projection.Rz[57], s8_368, s8_386);
  work.s8_388 = s8_368 + (s8_363 + p_arb_rear_right_x - work.r_rear_axle_aux1_x);
  work.s8_389 = 0.3333333333333333*work.s8_388;
  work.s8_390 = 0.3333333333333333*work.s8_374;
  const double s8_391 = fnma(projection.Rz[55], work.s7_35, projection.Rz[57]*work.s7_47);
  const double s8_392 = s8_125 + fma(z_rear_axle_ty, s8_113, s8_391);
  const double s8_393 = fnma(work.r_rear_axle_aux3_z, work.s8_127, s8_392);
  const double s8_394 = fma(s8_165, work.s8_171, fma(s8_167, work.s8_169, s8_393));
  const double s8_395 = fma(s8_206, work.s8_212, fma(s8_208, work.s8_210, s8_394));
  const double s8_396 = fma(s8_248, work.s8_266, fma(work.s8_252, s8_265, s8_395));
  const double s8_397 = fma(s8_302, work.s8_307, fnma(s8_304, work.s8_305, s8_396));
  const double s8_398 = fma(s8_338, work.s8_343, fnma(s8_340, work.s8_341, s8_397));
  const double s8_399 = fma(s8_373, work.s8_390, fnma(work.s8_375, s8_387, s8_398));
  const double s8_400 = fnma(projection.Rz[55], work.s7_36, work.s8_26);
  work.s8_401 = fnma(p_arb_rear_right_y, s8_400, s8_399);
  const double s8_402 = fnma(projection.Rz[57], work.s7_44, projection.Rz[55]*work.s7_37);
  const double s8_403 = fnma(z_rear_axle_ty, s8_108, s8_402);
  const double s8_404 = s8_133 + fma(work.r_rear_axle_aux1_x, work.s8_127, s8_403);
  const double s8_405 = fnma(s8_165, work.s8_170, fnma(s8_163, work.s8_169, s8_404));
  const double s8_406 = fnma(s8_206, work.s8_211, fnma(s8_204, work.s8_210, s8_405));
  const double s8_407 = fnma(work.s8_252, s8_263, fma(s8_248, work.s8_253, s8_406));
  const double s8_408 = fnma(s8_302, work.s8_306, fma(s8_300, work.s8_305, s8_407));
  const double s8_409 = fnma(s8_338, work.s8_342, fma(s8_336, work.s8_341, s8_408));
  const double s8_410 = fma(s8_373, work.s8_389, fma(work.s8_375, s8_385, s8_409));
  const double s8_411 = fms(projection.Rz[55], work.s7_38, work.s8_25);
  work.s8_412 = fnma(p_arb_rear_right_y, s8_411, s8_410);
  const double s8_413 = fma(work.r_rear_axle_aux3_z, s8_108, work.s8_28 + work.s8_47);
  const double s8_414 = s8_139 + fnma(work.r_rear_axle_aux1_x, s8_113, s8_413);
  const double s8_415 = fnma(s8_163, work.s8_171, fma(s8_167, work.s8_170, s8_414));
  const double s8_416 = fnma(s8_204, work.s8_212, fma(s8_208, work.s8_211, s8_415));
  const double s8_417 = fnma(s8_263, work.s8_266, fnma(work.s8_253, s8_265, s8_416));
  const double s8_418 = fnma(s8_300, work.s8_307, fma(s8_304, work.s8_306, s8_417));
  const double s8_419 = fnma(s8_336, work.s8_343, fma(s8_340, work.s8_342, s8_418));
  const double s8_420 = fnma(s8_385, work.s8_390, fnma(s8_387, work.s8_389, s8_419));
  const double s8_421 = fma(projection.Rz[55], work.s7_38, work.s8_25);
  const double s8_422 = fma(projection.Rz[55], work.s7_36, work.s8_26);
  const double s8_423 = fma(p_carrier_left_rz_y, s8_421, s8_420);
  work.s8_424 = fma(p_arb_rear_right_x, s8_422, s8_423);
  const double s8_425 = fma(s8_166, s8_166, fma(s8_164, s8_164, s8_162*s8_162));
  const double s8_426 = fma(s8_207, s8_207, fma(s8_205, s8_205, s8_203*s8_203));
  const double s8_427 = fma(s8_261, s8_261, fma(s8_259, s8_259, s8_247*s8_247));
  const double s8_428 = fma(projection.Rz[54], work.s8_46, projection.Rz[56]*work.s8_27);
  const double s8_429 = fma(projection.Rz[46], s8_111, fma(projection.Rz[42], s8_106, s8_428));
  const double s8_430 = fma(projection.Rz[44], s8_122, fma(work.s3_13, s8_120, s8_429));
  const double s8_431 = fma(s8_303, s8_303, fma(s8_301, s8_301, fma(s8_299, s8_299, s8_425)));
  const double s8_432 = fma(work.s3_2, s8_136, fma(work.s3_7, s8_130, s8_430));
  const double s8_433 = fma(s8_339, s8_339, fma(s8_337, s8_337, fma(s8_335, s8_335, s8_426)));
  const double s8_434 = fma(s8_383, s8_383, fma(s8_381, s8_381, fma(s8_372, s8_372, s8_427)));
  const double s8_435 = fnma(2.6666666666666665, s8_433, fnma(3.0, s8_431, s8_432));
  const double s8_436 = fnma(0.3333333333333333, s8_434, s8_435);
  const double s8_437 = fma(s8_166, s8_167, fma(s8_164, s8_165, s8_162*s8_163));
  const double s8_438 = fma(s8_207, s8_208, fma(s8_205, s8_206, s8_203*s8_204));
  const double s8_439 = fma(s8_261, s8_265, fma(s8_259, s8_263, s8_247*s8_248));
  const double s8_440 = fma(projection.Rz[54], work.s8_47, projection.Rz[56]*work.s8_28);
  const double s8_441 = fma(projection.Rz[46], s8_113, fma(projection.Rz[42], s8_108, s8_440));
  const double s8_442 = fma(projection.Rz[44], work.s8_127, fma(work.s3_13, s8_125, s8_441));
  const double s8_443 = fma(s8_303, s8_304, fma(s8_301, s8_302, fma(s8_299, s8_300, s8_437)));
  const double s8_444 = fma(work.s3_2, s8_139, fma(work.s3_7, s8_133, s8_442));
  const double s8_445 = fma(s8_339, s8_340, fma(s8_337, s8_338, fma(s8_335, s8_336, s8_438)));
  const double s8_446 = fma(s8_383, s8_387, fma(s8_381, s8_385, fma(s8_372, s8_373, s8_439)));
  const double s8_447 = fnma(2.6666666666666665, s8_445, fnma(3.0, s8_443, s8_444));
  work.s8_448 = fnma(0.3333333333333333, s8_446, s8_447);
  const double s8_449 = fma(s8_167, s8_167, fma(s8_165, s8_165, s8_163*s8_163));
  const double s8_450 = fma(s8_208, s8_208, fma(s8_206, s8_206, s8_204*s8_204));
  const double s8_451 = fma(s8_265, s8_265, fma(s8_263, s8_263, s8_248*s8_248));
  const double s8_452 = fma(projection.Rz[55], work.s8_47, projection.Rz[57]*work.s8_28);
  const double s8_453 = fma(projection.Rz[47], s8_113, fma(projection.Rz[43], s8_108, s8_452));
  const double s8_454 = fma(projection.Rz[45], work.s8_127, fma(work.s3_16, s8_125, s8_453));
  const double s8_455 = fma(s8_304, s8_304, fma(s8_302, s8_302, fma(s8_300, s8_300, s8_449)));
  const double s8_456 = fma(work.s3_4, s8_139, fma(work.s3_10, s8_133, s8_454));
  const double s8_457 = fma(s8_340, s8_340, fma(s8_338, s8_338, fma(s8_336, s8_336, s8_450)));
  const double s8_458 = fma(s8_387, s8_387, fma(s8_385, s8_385, fma(s8_373, s8_373, s8_451)));
  const double s8_459 = fnma(2.6666666666666665, s8_457, fnma(3.0, s8_455, s8_456));
  const double s8_460 = fnma(0.3333333333333333, s8_458, s8_459);
  const double s8_461 = fnma(work.s6_4, s8_364, fms(work.s6_8, s8_363, projection.zdd_star[15]));
  const double s8_462 = fnma(work.s8_16, work.s8_374, fma(work.s8_22, work.s8_366, s8_461));
  const double s8_463 = fnma(work.s8_14, s8_377, fnma(work.s4_38, s8_376, s8_462));
  const double s8_464 = fma(work.s8_13, s8_379, fma(work.s4_40, s8_378, s8_463));
  work.s8_465 = 0.3333333333333333*fma(work.s8_15, work.s8_388, s8_464);
  const double s8_466 = fms(work.s6_4, s8_362, projection.zdd_star[16]);
  const double s8_467 = fnma(work.s8_16, work.s8_366, fnma(work.s6_12, s8_363, s8_466));
  const double s8_468 = fma(zd_arb_rear_right, s8_367, s8_467);
  const double s8_469 = fnma(work.s4_40, s8_370, fnma(projection.zdd_star[21], s8_368, s8_468));
  const double s8_470 = fma(work.s8_20, work.s8_374, fnma(work.s8_13, s8_371, s8_469));
  const double s8_471 = fma(work.s8_12, s8_377, fma(work.s4_36, s8_376, s8_470));
  work.s8_472 = 0.3333333333333333*fma(work.s8_17, work.s8_388, s8_471);
  const double s8_473 = fms(work.s6_12, s8_364, projection.zdd_star[14]);
  const double s8_474 = fnma(projection.zdd_star[21], s8_365, fnma(work.s6_8, s8_362, s8_473));
  const double s8_475 = fnma(zd_arb_rear_right, s8_369, fnma(work.s8_15, work.s8_366, s8_474));
  const double s8_476 = fma(work.s8_14, s8_371, fma(work.s4_38, s8_370, s8_475));
  const double s8_477 = fnma(work.s4_36, s8_378, fnma(work.s8_17, work.s8_374, s8_476));
  const double s8_478 = fnma(work.s8_21, work.s8_388, fnma(work.s8_12, s8_379, s8_477));
  work.s8_479 = 0.3333333333333333*s8_478;
  const double s8_480 = tau[Coordinate::rear_axle_tx] - work.f_rear_axle_x;
  const double s8_481 = tau[Coordinate::rear_axle_ty] - work.f_rear_axle_y;
  const double s8_482 = tau[Coordinate::rear_axle_tz] - work.f_rear_axle_z;
  const double s8_483 = fma(work.s7_37, work.s8_15, tau[Coordinate::arb_rear_left]);
  const double s8_484 = fnma(work.s7_41, work.s8_43, fma(work.s7_35, work.s8_16, s8_483));
  const double s8_485 = fma(work.s7_36, work.s8_54, fma(work.s7_38, work.s8_50, s8_484));
  const double s8_486 = fnma(0.4225, projection.zdd_star[20], s8_485);
  const double s8_487 = fnma(work.s8_17, work.s8_57, s8_486);
  const double s8_488 = fnma(work.s7_44, work.s8_15, tau[Coordinate::arb_rear_right]);
  const double s8_489 = fma(work.s7_46, work.s8_38, fnma(work.s7_47, work.s8_16, s8_488));
  const double s8_490 = fma(work.s7_45, work.s8_41, s8_489);
  const double s8_491 = fnma(0.4225, projection.zdd_star[21], s8_490);
  const double s8_492 = fnma(work.s8_17, work.s8_44, fnma(work.s7_50, work.s8_43, s8_491));
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s8_493 = fma(tau_rear_axle_rx, work.s1_102, work.cosines[17]*tau_rear_axle_ry);
  const double s8_494 = fma(tau_rear_axle_rz, work.s1_104, s8_493) - work.n_rear_axle_y;
  const double s8_495 = fnma(work.s1_50, tau_rear_axle_ry, tau_rear_axle_rx*work.s1_99);
  const double s8_496 = fnma(tau_rear_axle_rz, work.s1_106, s8_495) - work.n_rear_axle_z;
  const double s8_497 = fnma(work.s1_48, tau_rear_axle_ry, tau_rear_axle_rz*work.s1_100);
  const double s8_498 = fnma(tau_rear_axle_rx, work.s1_105, s8_497) - work.n_rear_axle_x;
  const double s8_499 = fnma(s8_163, work.s8_176, projection.Rz[43]*s8_480);
  const double s8_500 = fnma(s8_165, work.s8_186, fnma(s8_167, work.s8_181, s8_499));
  const double s8_501 = fnma(s8_208, work.s8_224, fnma(s8_204, work.s8_218, s8_500));
  const double s8_502 = fnma(s8_265, work.s8_273, fnma(s8_206, work.s8_230, s8_501));
  const double s8_503 = fnma(s8_248, work.s8_286, fnma(s8_263, work.s8_280, s8_502));
  const double s8_504 = fnma(s8_304, work.s8_317, fnma(s8_302, work.s8_312, s8_503));
  const double s8_505 = fnma(s8_338, work.s8_349, fnma(s8_300, work.s8_322, s8_504));
  const double s8_506 = fnma(s8_336, work.s8_361, fnma(s8_340, work.s8_355, s8_505));
  const double s8_507 = fnma(s8_387, work.s8_472, fnma(s8_373, work.s8_465, s8_506));
  const double s8_508 = fma(projection.Rz[45], s8_481, fnma(s8_385, work.s8_479, s8_507));
  const double s8_509 = fma(projection.Rz[55], s8_487, fma(projection.Rz[47], s8_482, s8_508));
  const double s8_510 = fma(work.s3_4, s8_494, fma(projection.Rz[57], s8_492, s8_509));
  work.s8_511 = fma(work.s3_16, s8_498, fma(work.s3_10, s8_496, s8_510));
  result.inertia[12] = s8_460 - 1.5272999999999997e-20;
  work.s8_512 = 1.0/s8_460;
  const double s8_513 = work.s8_448*work.s8_512;
  const double s8_514 = fnma(work.s8_448, s8_513, s8_436);
  result.inertia[11] = fnma(1e-12, s8_436, s8_514 - 1.5272999999999997e-20);
  work.s8_515 = fnma(work.s8_127, s8_513, s8_122);
  work.s8_516 = 1.0/s8_514;
  work.s8_517 = work.s8_515*work.s8_516;
  const double s8_518 = fnma(projection.Rz[54], work.s7_38, s8_106 - work.s8_23);
  work.s8_519 = fnma(work.s8_109, s8_513, s8_518);
  work.s8_520 = work.s8_516*work.s8_519;
  const double s8_521 = fnma(projection.Rz[54], work.s7_36, s8_111 - work.s8_24);
  work.s8_522 = fnma(work.s8_114, s8_513, s8_521);
  work.s8_523 = work.s8_516*work.s8_522;
  const double s8_524 = fnma(projection.Rz[54], work.s7_35, projection.Rz[56]*work.s7_47);
  const double s8_525 = s8_120 + fma(z_rear_axle_ty, s8_111, s8_524);
  const double s8_526 = fma(s8_166, work.s8_169, fnma(work.r_rear_axle_aux3_z, s8_122, s8_525));
  const double s8_527 = fma(s8_207, work.s8_210, fma(s8_164, work.s8_171, s8_526));
  const double s8_528 = fma(work.s8_252, s8_261, fma(s8_205, work.s8_212, s8_527));
  const double s8_529 = fnma(s8_303, work.s8_305, fma(s8_247, work.s8_266, s8_528));
  const double s8_530 = fnma(s8_339, work.s8_341, fma(s8_301, work.s8_307, s8_529));
  const double s8_531 = fnma(work.s8_375, s8_383, fma(s8_337, work.s8_343, s8_530));
  const double s8_532 = fnma(work.s8_401, s8_513, fma(s8_372, work.s8_390, s8_531));
  const double s8_533 = fnma(projection.Rz[54], work.s7_36, work.s8_24);
  work.s8_534 = fnma(p_arb_rear_right_y, s8_533, s8_532);
  work.s8_535 = work.s8_516*work.s8_534;
  const double s8_536 = fnma(projection.Rz[56], work.s7_44, projection.Rz[54]*work.s7_37);
  const double s8_537 = fnma(z_rear_axle_ty, s8_106, s8_536);
  const double s8_538 = s8_130 + fma(work.r_rear_axle_aux1_x, s8_122, s8_537);
  const double s8_539 = fnma(s8_164, work.s8_170, fnma(s8_162, work.s8_169, s8_538));
  const double s8_540 = fnma(s8_205, work.s8_211, fnma(s8_203, work.s8_210, s8_539));
  const double s8_541 = fnma(work.s8_252, s8_259, fma(s8_247, work.s8_253, s8_540));
  const double s8_542 = fnma(s8_301, work.s8_306, fma(s8_299, work.s8_305, s8_541));
  const double s8_543 = fnma(s8_337, work.s8_342, fma(s8_335, work.s8_341, s8_542));
  const double s8_544 = fma(s8_372, work.s8_389, fma(work.s8_375, s8_381, s8_543));
  const double s8_545 = fms(projection.Rz[54], work.s7_38, work.s8_23);
  work.s8_546 = fnma(p_arb_rear_right_y, s8_545, fnma(work.s8_412, s8_513, s8_544));
  work.s8_547 = work.s8_516*work.s8_546;
  const double s8_548 = fma(work.r_rear_axle_aux3_z, s8_106, work.s8_27 + work.s8_46);
  const double s8_549 = s8_136 + fnma(work.r_rear_axle_aux1_x, s8_111, s8_548);
  const double s8_550 = fnma(s8_162, work.s8_171, fma(s8_166, work.s8_170, s8_549));
  const double s8_551 = fnma(s8_203, work.s8_212, fma(s8_207, work.s8_211, s8_550));
  const double s8_552 = fnma(s8_259, work.s8_266, fnma(work.s8_253, s8_261, s8_551));
  const double s8_553 = fnma(s8_299, work.s8_307, fma(s8_303, work.s8_306, s8_552));
  const double s8_554 = fnma(s8_335, work.s8_343, fma(s8_339, work.s8_342, s8_553));
  const double s8_555 = fnma(s8_381, work.s8_390, fnma(s8_383, work.s8_389, s8_554));
  const double s8_556 = fma(projection.Rz[54], work.s7_38, work.s8_23);
  const double s8_557 = fma(p_carrier_left_rz_y, s8_556, fnma(work.s8_424, s8_513, s8_555));
  const double s8_558 = fma(projection.Rz[54], work.s7_36, work.s8_24);
  work.s8_559 = fma(p_arb_rear_right_x, s8_558, s8_557);
  work.s8_560 = work.s8_516*work.s8_559;
  work.s8_561 = work.s8_127*work.s8_512;
  const double s8_562 = fnma(s8_162, work.s8_176, projection.Rz[42]*s8_480);
  const double s8_563 = fnma(s8_164, work.s8_186, fnma(s8_166, work.s8_181, s8_562));
  const double s8_564 = fnma(s8_207, work.s8_224, fnma(s8_203, work.s8_218, s8_563));
  const double s8_565 = fnma(s8_261, work.s8_273, fnma(s8_205, work.s8_230, s8_564));
  const double s8_566 = fnma(s8_247, work.s8_286, fnma(s8_259, work.s8_280, s8_565));
  const double s8_567 = fnma(s8_303, work.s8_317, fnma(s8_301, work.s8_312, s8_566));
  const double s8_568 = fnma(s8_337, work.s8_349, fnma(s8_299, work.s8_322, s8_567));
  const double s8_569 = fnma(s8_335, work.s8_361, fnma(s8_339, work.s8_355, s8_568));
  const double s8_570 = fnma(s8_383, work.s8_472, fnma(s8_372, work.s8_465, s8_569));
  const double s8_571 = fma(projection.Rz[44], s8_481, fnma(s8_381, work.s8_479, s8_570));
  const double s8_572 = fma(projection.Rz[54], s8_487, fma(projection.Rz[46], s8_482, s8_571));
  const double s8_573 = fma(work.s3_2, s8_494, fma(projection.Rz[56], s8_492, s8_572));
  const double s8_574 = fma(work.s3_13, s8_498, fma(work.s3_7, s8_496, s8_573));
  work.s8_575 = fnma(work.s8_511, s8_513, s8_574);
  work.s8_576 = work.s8_109*work.s8_512;
  work.s8_577 = work.s8_114*work.s8_512;
  work.s8_578 = work.s8_401*work.s8_512;
  work.s8_579 = work.s8_412*work.s8_512;
  work.s8_580 = work.s8_424*work.s8_512;
  // operations: 772 add, 822 multiply, 2 divide
}

/// Part 3 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63);
/// step 3: Rz (61), upper_ball_left .. tie_rod_right; step 6: c and dRz/dt zd (62), upper_ball_left
/// .. tie_rod_right; step 7: inertias of the bodies and forces on joints, upper_ball_left ..
/// tie_rod_right; step 8: elimination from the leaves to the root (63), upper_ball_left ..
/// tie_rod_right.
[[gnu::noinline]] void compute_chosen_accelerations_3(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 8: elimination from the leaves to the root (63), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s8_581 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_x;
  const double s8_582 = fma(work.s1_35, work.w_carrier_right_z, s8_581);
  const double s8_583 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_x;
  const double s8_584 = fma(work.s1_35, work.w_carrier_right_y, s8_583);
  const double s8_585 = fnma(work.s1_35, work.w_carrier_right_x,
      state.zd[Coordinate::wheel_front_right]);
  const double s8_586 = fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_y, s8_585);
  const double s8_587 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s8_586);
  const double s8_588 = I_wheel_front_right_polar*s8_587;
  const double s8_589 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_y;
  const double s8_590 = fnma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_z, s8_589);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s8_591 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_x;
  const double s8_592 = fma(work.s1_22, work.w_carrier_left_z, s8_591);
  const double s8_593 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_x;
  const double s8_594 = fma(work.s1_22, work.w_carrier_left_y, s8_593);
  const double s8_595 = fnma(work.s1_22, work.w_carrier_left_x,
      state.zd[Coordinate::wheel_front_left]);
  const double s8_596 = fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_y, s8_595);
  const double s8_597 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s8_596);
  const double s8_598 = I_wheel_front_left_polar*s8_597;
  const double s8_599 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_y;
  const double s8_600 = fnma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_z, s8_599);

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s3_17 = R_carrier_left_aux1_x_x*projection.Rz[6];
  work.s3_18 = fnma(work.s1_22, projection.Rz[9], s3_17);
  const double s3_19 = R_carrier_left_aux1_x_x*projection.Rz[7];
  work.s3_20 = fnma(work.s1_22, projection.Rz[10], s3_19);
  const double s3_21 = R_carrier_left_aux1_x_x*projection.Rz[8];
  work.s3_22 = fnma(work.s1_22, projection.Rz[11], s3_21);
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s3_23 = R_carrier_right_aux1_x_x*projection.Rz[24];
  work.s3_24 = fnma(work.s1_35, projection.Rz[27], s3_23);
  const double s3_25 = R_carrier_right_aux1_x_x*projection.Rz[25];
  work.s3_26 = fnma(work.s1_35, projection.Rz[28], s3_25);
  const double s3_27 = R_carrier_right_aux1_x_x*projection.Rz[26];
  work.s3_28 = fnma(work.s1_35, projection.Rz[29], s3_27);
  const double s3_29 = work.R_carrier_left_aux1_z_z*projection.Rz[3];
  const double s3_30 = fma(work.R_carrier_left_aux1_z_x, projection.Rz[6], s3_29);
  work.s3_31 = fma(work.R_carrier_left_aux2_z_y, projection.Rz[9], s3_30);
  const double s3_32 = work.R_carrier_left_aux1_z_z*projection.Rz[4];
  const double s3_33 = fma(work.R_carrier_left_aux1_z_x, projection.Rz[7], s3_32);
  work.s3_34 = fma(work.R_carrier_left_aux2_z_y, projection.Rz[10], s3_33);
  const double s3_35 = work.R_carrier_left_aux1_z_z*projection.Rz[5];
  const double s3_36 = fma(work.R_carrier_left_aux1_z_x, projection.Rz[8], s3_35);
  work.s3_37 = fma(work.R_carrier_left_aux2_z_y, projection.Rz[11], s3_36);
  const double s3_38 = work.R_carrier_left_aux1_y_z*projection.Rz[3];
  const double s3_39 = fma(work.R_carrier_left_aux1_y_x, projection.Rz[6], s3_38);
  work.s3_40 = fma(work.R_carrier_left_aux2_y_y, projection.Rz[9], s3_39);
  const double s3_41 = work.R_carrier_left_aux1_y_z*projection.Rz[4];
  const double s3_42 = fma(work.R_carrier_left_aux1_y_x, projection.Rz[7], s3_41);
  work.s3_43 = fma(work.R_carrier_left_aux2_y_y, projection.Rz[10], s3_42);
  const double s3_44 = work.R_carrier_left_aux1_y_z*projection.Rz[5];
  const double s3_45 = fma(work.R_carrier_left_aux1_y_x, projection.Rz[8], s3_44);
  work.s3_46 = fma(work.R_carrier_left_aux2_y_y, projection.Rz[11], s3_45);
  const double s3_47 = work.R_carrier_right_aux1_z_z*projection.Rz[21];
  const double s3_48 = fma(work.R_carrier_right_aux1_z_x, projection.Rz[24], s3_47);
  work.s3_49 = fma(work.R_carrier_right_aux2_z_y, projection.Rz[27], s3_48);
  const double s3_50 = work.R_carrier_right_aux1_z_z*projection.Rz[22];
  const double s3_51 = fma(work.R_carrier_right_aux1_z_x, projection.Rz[25], s3_50);
  work.s3_52 = fma(work.R_carrier_right_aux2_z_y, projection.Rz[28], s3_51);
  const double s3_53 = work.R_carrier_right_aux1_z_z*projection.Rz[23];
  const double s3_54 = fma(work.R_carrier_right_aux1_z_x, projection.Rz[26], s3_53);
  work.s3_55 = fma(work.R_carrier_right_aux2_z_y, projection.Rz[29], s3_54);
  const double s3_56 = work.R_carrier_right_aux1_y_z*projection.Rz[21];
  const double s3_57 = fma(work.R_carrier_right_aux1_y_x, projection.Rz[24], s3_56);
  work.s3_58 = fma(work.R_carrier_right_aux2_y_y, projection.Rz[27], s3_57);
  const double s3_59 = work.R_carrier_right_aux1_y_z*projection.Rz[22];
  const double s3_60 = fma(work.R_carrier_right_aux1_y_x, projection.Rz[25], s3_59);
  work.s3_61 = fma(work.R_carrier_right_aux2_y_y, projection.Rz[28], s3_60);
  const double s3_62 = work.R_carrier_right_aux1_y_z*projection.Rz[23];
  const double s3_63 = fma(work.R_carrier_right_aux1_y_x, projection.Rz[26], s3_62);
  work.s3_64 = fma(work.R_carrier_right_aux2_y_y, projection.Rz[29], s3_63);
  // operations: 30 add, 48 multiply

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s6_13 = zd_lower_arm_left*zd_lower_arm_left;
  work.s6_14 = work.s1_18*work.s6_13;
  work.s6_15 = work.s1_20*work.s6_13;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s6_16 = zd_lower_arm_right*zd_lower_arm_right;
  work.s6_17 = work.s1_32*work.s6_16;
  const double s6_18 = fma(state.zd[Coordinate::carrier_left_ry], work.s1_22, zd_lower_arm_left);
  const double s6_19 = work.R_carrier_left_aux1_z_z*projection.zdd_star[1];
  const double s6_20 = fnma(work.s4_6, work.s4_8, s6_19);
  const double s6_21 = fma(work.R_carrier_left_aux1_z_x, projection.zdd_star[2], s6_20);
  const double s6_22 = fma(work.R_carrier_left_aux2_z_y, projection.zdd_star[3], s6_21);
  work.s6_23 = fma(work.s4_30, s6_18, fma(work.s4_11, work.s4_41, s6_22));
  const double s6_24 = fma(state.zd[Coordinate::carrier_right_ry], work.s1_35, zd_lower_arm_right);
  const double s6_25 = work.R_carrier_right_aux1_z_z*projection.zdd_star[7];
  const double s6_26 = fnma(work.s4_13, work.s4_15, s6_25);
  const double s6_27 = fma(work.R_carrier_right_aux1_z_x, projection.zdd_star[8], s6_26);
  const double s6_28 = fma(work.R_carrier_right_aux2_z_y, projection.zdd_star[9], s6_27);
  work.s6_29 = fma(work.s4_34, s6_24, fma(work.s4_18, work.s4_45, s6_28));
  const double s6_30 = work.s4_7*work.s4_8;
  const double s6_31 = fma(work.R_carrier_left_aux1_y_z, projection.zdd_star[1], s6_30);
  const double s6_32 = fma(work.R_carrier_left_aux1_y_x, projection.zdd_star[2], s6_31);
  const double s6_33 = fma(work.R_carrier_left_aux2_y_y, projection.zdd_star[3], s6_32);
  work.s6_34 = fnma(work.s4_28, s6_18, fnma(work.s4_12, work.s4_41, s6_33));
  const double s6_35 = work.s4_14*work.s4_15;
  const double s6_36 = fma(work.R_carrier_right_aux1_y_z, projection.zdd_star[7], s6_35);
  const double s6_37 = fma(work.R_carrier_right_aux1_y_x, projection.zdd_star[8], s6_36);
  const double s6_38 = fma(work.R_carrier_right_aux2_y_y, projection.zdd_star[9], s6_37);
  work.s6_39 = fnma(work.s4_32, s6_24, fnma(work.s4_19, work.s4_45, s6_38));
  // operations: 22 add, 31 multiply

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  const double R_lower_arm_left_y_y = work.cosines[3];
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s7_53 = h_lower_arm_left_y*R_lower_arm_left_y_y;
  work.s7_54 = fnma(h_lower_arm_left_z, R_lower_arm_left_z_y, s7_53);
  const double s7_55 = h_lower_arm_left_y*R_lower_arm_left_z_y;
  work.s7_56 = fma(h_lower_arm_left_z, R_lower_arm_left_y_y, s7_55);
  const double s7_57 = -K_lower_arm_left_yz*R_lower_arm_left_y_y;
  const double s7_58 = fma(K_lower_arm_left_zz, R_lower_arm_left_z_y, s7_57);
  const double s7_59 = K_lower_arm_left_yy*R_lower_arm_left_y_y;
  const double s7_60 = fnma(K_lower_arm_left_yz, R_lower_arm_left_z_y, s7_59);
  work.s7_61 = fnma(R_lower_arm_left_y_y, s7_58, R_lower_arm_left_z_y*s7_60);
  work.s7_62 = fma(R_lower_arm_left_y_y, s7_60, R_lower_arm_left_z_y*s7_58);
  work.s7_63 = 1.825625 - work.s7_62;
  const double s7_64 = h_carrier_left_y*work.R_carrier_left_aux2_z_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_65 = fma(h_carrier_left_x, work.R_carrier_left_z_x, s7_64);
  work.s7_66 = fma(h_carrier_left_z, work.R_carrier_left_z_z, s7_65);
  const double s7_67 = h_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_68 = fma(h_carrier_left_x, work.R_carrier_left_y_x, s7_67);
  work.s7_69 = fma(h_carrier_left_z, work.R_carrier_left_y_z, s7_68);
  const double s7_70 = h_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_71 = fnma(h_carrier_left_y, work.s1_22, s7_70);
  work.s7_72 = fma(h_carrier_left_x, work.R_carrier_left_x_x, s7_71);
  const double s7_73 = K_carrier_left_xy*work.R_carrier_left_x_x;
  const double s7_74 = fnma(K_carrier_left_yy, work.s1_22, s7_73);
  const double s7_75 = fma(K_carrier_left_yz, work.R_carrier_left_x_z, s7_74);
  const double s7_76 = K_carrier_left_yy*work.R_carrier_left_aux2_y_y;
  const double s7_77 = fma(K_carrier_left_xy, work.R_carrier_left_y_x, s7_76);
  const double s7_78 = fma(K_carrier_left_yz, work.R_carrier_left_y_z, s7_77);
  const double s7_79 = K_carrier_left_yz*work.R_carrier_left_aux2_y_y;
  const double s7_80 = fma(K_carrier_left_xz, work.R_carrier_left_y_x, s7_79);
  const double s7_81 = fma(K_carrier_left_zz, work.R_carrier_left_y_z, s7_80);
  const double s7_82 = K_carrier_left_xy*work.R_carrier_left_aux2_y_y;
  const double s7_83 = fma(K_carrier_left_xx, work.R_carrier_left_y_x, s7_82);
  const double s7_84 = fma(K_carrier_left_xz, work.R_carrier_left_y_z, s7_83);
  const double s7_85 = fma(work.R_carrier_left_z_z, s7_81, work.R_carrier_left_aux2_z_y*s7_78);
  work.s7_86 = fma(work.R_carrier_left_z_x, s7_84, s7_85);
  const double s7_87 = K_carrier_left_zz*work.R_carrier_left_x_z;
  const double s7_88 = fnma(K_carrier_left_yz, work.s1_22, s7_87);
  const double s7_89 = fma(K_carrier_left_xz, work.R_carrier_left_x_x, s7_88);
  const double s7_90 = K_carrier_left_xx*work.R_carrier_left_x_x;
  const double s7_91 = fnma(K_carrier_left_xy, work.s1_22, s7_90);
  const double s7_92 = fma(K_carrier_left_xz, work.R_carrier_left_x_z, s7_91);
  const double s7_93 = fma(work.R_carrier_left_z_z, s7_89, work.R_carrier_left_aux2_z_y*s7_75);
  work.s7_94 = fma(work.R_carrier_left_z_x, s7_92, s7_93);
  const double s7_95 = fma(work.R_carrier_left_y_z, s7_89, work.R_carrier_left_aux2_y_y*s7_75);
  work.s7_96 = fma(work.R_carrier_left_y_x, s7_92, s7_95);
  const double s7_97 = fnma(work.s1_22, s7_75, work.R_carrier_left_x_z*s7_89);
  work.s7_98 = fma(work.R_carrier_left_x_x, s7_92, s7_97);
  const double s7_99 = K_carrier_left_trace - work.s7_98;
  const double s7_100 = fma(work.R_carrier_left_y_z, s7_81, work.R_carrier_left_aux2_y_y*s7_78);
  work.s7_101 = fma(work.R_carrier_left_y_x, s7_84, s7_100);
  work.s7_102 = s7_99 - work.s7_101;
  const double R_upper_arm_left_y_y = work.cosines[7];
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double s7_103 = h_upper_arm_left_y*R_upper_arm_left_y_y;
  work.s7_104 = fnma(h_upper_arm_left_z, R_upper_arm_left_z_y, s7_103);
  const double s7_105 = h_upper_arm_left_y*R_upper_arm_left_z_y;
  work.s7_106 = fma(h_upper_arm_left_z, R_upper_arm_left_y_y, s7_105);
  const double s7_107 = -K_upper_arm_left_yz*R_upper_arm_left_y_y;
  const double s7_108 = fma(K_upper_arm_left_zz, R_upper_arm_left_z_y, s7_107);
  const double s7_109 = K_upper_arm_left_yy*R_upper_arm_left_y_y;
  const double s7_110 = fnma(K_upper_arm_left_yz, R_upper_arm_left_z_y, s7_109);
  work.s7_111 = fnma(R_upper_arm_left_y_y, s7_108, R_upper_arm_left_z_y*s7_110);
  work.s7_112 = fma(R_upper_arm_left_y_y, s7_110, R_upper_arm_left_z_y*s7_108);
  work.s7_113 = 0.539 - work.s7_112;
  const double R_arb_front_left_x_x = work.cosines[8];
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double s7_114 = K_arb_front_left_yz*R_arb_front_left_x_x;
  work.s7_115 = fnma(K_arb_front_left_xy, R_arb_front_left_x_z, s7_114);
  const double s7_116 = h_arb_front_left_z*R_arb_front_left_x_x;
  work.s7_117 = fnma(h_arb_front_left_x, R_arb_front_left_x_z, s7_116);
  const double s7_118 = K_arb_front_left_yz*R_arb_front_left_x_z;
  work.s7_119 = fma(K_arb_front_left_xy, R_arb_front_left_x_x, s7_118);
  const double s7_120 = h_arb_front_left_z*R_arb_front_left_x_z;
  work.s7_121 = fma(h_arb_front_left_x, R_arb_front_left_x_x, s7_120);
  const double s7_122 = K_arb_front_left_zz*R_arb_front_left_x_z;
  const double s7_123 = fma(K_arb_front_left_xz, R_arb_front_left_x_x, s7_122);
  const double s7_124 = K_arb_front_left_xx*R_arb_front_left_x_x;
  const double s7_125 = fma(K_arb_front_left_xz, R_arb_front_left_x_z, s7_124);
  work.s7_126 = fnma(R_arb_front_left_x_z, s7_125, R_arb_front_left_x_x*s7_123);
  work.s7_127 = fma(R_arb_front_left_x_x, s7_125, R_arb_front_left_x_z*s7_123);
  work.s7_128 = 0.3477 - work.s7_127;
  const double R_lower_arm_right_z_y = work.sines[9];
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s7_129 = -h_lower_arm_right_z*R_lower_arm_right_z_y;
  work.s7_130 = fma(h_lower_arm_right_y, R_lower_arm_right_y_y, s7_129);
  const double s7_131 = -h_lower_arm_right_z*R_lower_arm_right_y_y;
  work.s7_132 = fnma(h_lower_arm_right_y, R_lower_arm_right_z_y, s7_131);
  const double s7_133 = K_lower_arm_right_yy*R_lower_arm_right_y_y;
  const double s7_134 = fnma(K_lower_arm_right_yz, R_lower_arm_right_z_y, s7_133);
  const double s7_135 = K_lower_arm_right_yz*R_lower_arm_right_y_y;
  const double s7_136 = fnma(K_lower_arm_right_zz, R_lower_arm_right_z_y, s7_135);
  work.s7_137 = fma(R_lower_arm_right_y_y, s7_136, R_lower_arm_right_z_y*s7_134);
  work.s7_138 = fnma(R_lower_arm_right_z_y, s7_136, R_lower_arm_right_y_y*s7_134);
  work.s7_139 = 1.825625 - work.s7_138;
  const double s7_140 = -h_carrier_right_y*work.s1_35;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_141 = fma(h_carrier_right_x, work.R_carrier_right_x_x, s7_140);
  work.s7_142 = fma(h_carrier_right_z, work.R_carrier_right_x_z, s7_141);
  const double s7_143 = h_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_144 = fma(h_carrier_right_y, work.R_carrier_right_aux2_z_y, s7_143);
  work.s7_145 = fma(h_carrier_right_x, work.R_carrier_right_z_x, s7_144);
  const double s7_146 = h_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_147 = fma(h_carrier_right_y, work.R_carrier_right_aux2_y_y, s7_146);
  work.s7_148 = fma(h_carrier_right_x, work.R_carrier_right_y_x, s7_147);
  const double s7_149 = K_carrier_right_yy*work.s1_35;
  const double s7_150 = fnma(K_carrier_right_xy, work.R_carrier_right_x_x, s7_149);
  const double s7_151 = fnma(K_carrier_right_yz, work.R_carrier_right_x_z, s7_150);
  const double s7_152 = K_carrier_right_yy*work.R_carrier_right_aux2_y_y;
  const double s7_153 = fma(K_carrier_right_xy, work.R_carrier_right_y_x, s7_152);
  const double s7_154 = fma(K_carrier_right_yz, work.R_carrier_right_y_z, s7_153);
  const double s7_155 = K_carrier_right_zz*work.R_carrier_right_y_z;
  const double s7_156 = fma(K_carrier_right_yz, work.R_carrier_right_aux2_y_y, s7_155);
  const double s7_157 = fma(K_carrier_right_xz, work.R_carrier_right_y_x, s7_156);
  const double s7_158 = K_carrier_right_xx*work.R_carrier_right_y_x;
  const double s7_159 = fma(K_carrier_right_xy, work.R_carrier_right_aux2_y_y, s7_158);
  const double s7_160 = fma(K_carrier_right_xz, work.R_carrier_right_y_z, s7_159);
  const double s7_161 = work.R_carrier_right_aux2_z_y*s7_154;
  const double s7_162 = fma(work.R_carrier_right_z_z, s7_157, s7_161);
  work.s7_163 = fma(work.R_carrier_right_z_x, s7_160, s7_162);
  const double s7_164 = -K_carrier_right_yz*work.s1_35;
  const double s7_165 = fma(K_carrier_right_xz, work.R_carrier_right_x_x, s7_164);
  const double s7_166 = fma(K_carrier_right_zz, work.R_carrier_right_x_z, s7_165);
  const double s7_167 = -K_carrier_right_xy*work.s1_35;
  const double s7_168 = fma(K_carrier_right_xx, work.R_carrier_right_x_x, s7_167);
  const double s7_169 = fma(K_carrier_right_xz, work.R_carrier_right_x_z, s7_168);
  const double s7_170 = work.R_carrier_right_z_z*s7_166;
  const double s7_171 = fnma(work.R_carrier_right_aux2_z_y, s7_151, s7_170);
  work.s7_172 = fma(work.R_carrier_right_z_x, s7_169, s7_171);
  const double s7_173 = work.R_carrier_right_y_z*s7_166;
  const double s7_174 = fnma(work.R_carrier_right_aux2_y_y, s7_151, s7_173);
  work.s7_175 = fma(work.R_carrier_right_y_x, s7_169, s7_174);
  const double s7_176 = fma(work.R_carrier_right_x_z, s7_166, work.s1_35*s7_151);
  work.s7_177 = fma(work.R_carrier_right_x_x, s7_169, s7_176);
  const double s7_178 = K_carrier_right_trace - work.s7_177;
  const double s7_179 = work.R_carrier_right_aux2_y_y*s7_154;
  const double s7_180 = fma(work.R_carrier_right_y_z, s7_157, s7_179);
  work.s7_181 = fma(work.R_carrier_right_y_x, s7_160, s7_180);
  work.s7_182 = s7_178 - work.s7_181;
  const double R_upper_arm_right_z_y = work.sines[13];
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_183 = -h_upper_arm_right_z*R_upper_arm_right_z_y;
  work.s7_184 = fma(h_upper_arm_right_y, R_upper_arm_right_y_y, s7_183);
  const double s7_185 = -h_upper_arm_right_z*R_upper_arm_right_y_y;
  work.s7_186 = fnma(h_upper_arm_right_y, R_upper_arm_right_z_y, s7_185);
  const double s7_187 = K_upper_arm_right_yy*R_upper_arm_right_y_y;
  const double s7_188 = fnma(K_upper_arm_right_yz, R_upper_arm_right_z_y, s7_187);
  const double s7_189 = K_upper_arm_right_yz*R_upper_arm_right_y_y;
  const double s7_190 = fnma(K_upper_arm_right_zz, R_upper_arm_right_z_y, s7_189);
  work.s7_191 = fma(R_upper_arm_right_y_y, s7_190, R_upper_arm_right_z_y*s7_188);
  work.s7_192 = fnma(R_upper_arm_right_z_y, s7_190, R_upper_arm_right_y_y*s7_188);
  work.s7_193 = 0.539 - work.s7_192;
  const double R_arb_front_right_x_x = work.cosines[14];
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double s7_194 = h_arb_front_right_z*R_arb_front_right_x_x;
  work.s7_195 = fnma(h_arb_front_right_x, R_arb_front_right_x_z, s7_194);
  const double s7_196 = h_arb_front_right_z*R_arb_front_right_x_z;
  work.s7_197 = fma(h_arb_front_right_x, R_arb_front_right_x_x, s7_196);
  const double s7_198 = K_arb_front_right_xy*R_arb_front_right_x_x;
  work.s7_199 = fma(K_arb_front_right_yz, R_arb_front_right_x_z, s7_198);
  const double s7_200 = -K_arb_front_right_yz*R_arb_front_right_x_x;
  work.s7_201 = fma(K_arb_front_right_xy, R_arb_front_right_x_z, s7_200);
  const double s7_202 = K_arb_front_right_zz*R_arb_front_right_x_z;
  const double s7_203 = fma(K_arb_front_right_xz, R_arb_front_right_x_x, s7_202);
  const double s7_204 = K_arb_front_right_xx*R_arb_front_right_x_x;
  const double s7_205 = fma(K_arb_front_right_xz, R_arb_front_right_x_z, s7_204);
  work.s7_206 = fnma(R_arb_front_right_x_z, s7_205, R_arb_front_right_x_x*s7_203);
  work.s7_207 = fma(R_arb_front_right_x_x, s7_205, R_arb_front_right_x_z*s7_203);
  work.s7_208 = 0.3477 - work.s7_207;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  work.s7_209 = -h_pitman_arm_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s7_210 = -h_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_211 = K_pitman_arm_zz*R_pitman_arm_x_z;
  const double s7_212 = K_pitman_arm_xx*R_pitman_arm_x_x;
  work.s7_213 = fnma(R_pitman_arm_x_z, s7_212, R_pitman_arm_x_x*s7_211);
  work.s7_214 = fma(R_pitman_arm_x_x, s7_212, R_pitman_arm_x_z*s7_211);
  work.s7_215 = 0.3504 - work.s7_214;
  const double R_bell_crank_x_x = work.cosines[16];
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_y_x = work.sines[16];
  work.s7_216 = fma(h_bell_crank_x, R_bell_crank_y_x, h_bell_crank_y*R_bell_crank_x_x);
  const double s7_217 = -K_bell_crank_xy*R_bell_crank_x_x;
  const double s7_218 = fma(K_bell_crank_yy, R_bell_crank_y_x, s7_217);
  work.s7_219 = fma(h_bell_crank_y, R_bell_crank_y_x, -h_bell_crank_x*R_bell_crank_x_x);
  const double s7_220 = K_bell_crank_xx*R_bell_crank_x_x;
  const double s7_221 = fnma(K_bell_crank_xy, R_bell_crank_y_x, s7_220);
  work.s7_222 = fnma(R_bell_crank_x_x, s7_218, R_bell_crank_y_x*s7_221);
  work.s7_223 = fma(R_bell_crank_x_x, s7_221, R_bell_crank_y_x*s7_218);
  work.s7_224 = 0.9515 - work.s7_223;
  // operations: 116 add, 184 multiply

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_601 = projection.Rz[0] + work.s3_18;
  work.s8_602 = work.s1_18*projection.Rz[0];
  work.s8_603 = work.s1_20*projection.Rz[0];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_604 = projection.Rz[18] + work.s3_24;
  work.s8_605 = work.s1_30*projection.Rz[18];
  work.s8_606 = work.s1_32*projection.Rz[18];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_607 = projection.Rz[1] + work.s3_20;
  work.s8_608 = work.s1_18*projection.Rz[1];
  work.s8_609 = work.s1_20*projection.Rz[1];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_610 = projection.Rz[19] + work.s3_26;
  work.s8_611 = work.s1_30*projection.Rz[19];
  work.s8_612 = work.s1_32*projection.Rz[19];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_613 = projection.Rz[2] + work.s3_22;
  work.s8_614 = work.s1_18*projection.Rz[2];
  work.s8_615 = work.s1_20*projection.Rz[2];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_616 = projection.Rz[20] + work.s3_28;
  work.s8_617 = work.s1_30*projection.Rz[20];
  work.s8_618 = work.s1_32*projection.Rz[20];
  const double s8_619 = fnma(work.s4_7, work.s4_9, work.s4_6*work.s4_10);
  const double s8_620 = projection.zdd_star[0] + s8_619;
  const double s8_621 = fma(R_carrier_left_aux1_x_x, projection.zdd_star[2], s8_620);
  const double s8_622 = fnma(work.s1_22, projection.zdd_star[3], s8_621);
  work.s8_623 = fma(work.s4_12, work.s4_30, fnma(work.s4_11, work.s4_28, s8_622));
  const double s8_624 = fnma(work.s4_14, work.s4_16, work.s4_13*work.s4_17);
  const double s8_625 = projection.zdd_star[6] + s8_624;
  const double s8_626 = fma(R_carrier_right_aux1_x_x, projection.zdd_star[8], s8_625);
  const double s8_627 = fnma(work.s1_35, projection.zdd_star[9], s8_626);
  work.s8_628 = fma(work.s4_19, work.s4_34, fnma(work.s4_18, work.s4_32, s8_627));
  work.s8_629 = work.s1_32*projection.zdd_star[6];
  // bell_crank: bell_crank, revolute, chassis
  work.s8_630 = projection.Rz[39]*work.s7_216;
  work.s8_631 = projection.Rz[40]*work.s7_216;
  work.s8_632 = projection.Rz[41]*work.s7_216;
  work.s8_633 = 0.9515*projection.Rz[39];
  work.s8_634 = 0.9515*projection.Rz[40];
  work.s8_635 = 0.9515*projection.Rz[41];
  work.s8_636 = projection.Rz[39]*work.s7_219;
  work.s8_637 = projection.Rz[40]*work.s7_219;
  work.s8_638 = projection.Rz[41]*work.s7_219;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s8_639 = zd_bell_crank + work.s8_14;
  const double s8_640 = zd_bell_crank*work.s8_639;
  work.s8_641 = fma(p_bell_crank_x, work.s8_21, -p_bell_crank_z*work.s8_17);
  work.s8_642 = zd_bell_crank*work.s8_13;
  work.s8_643 = zd_bell_crank*work.s8_12;
  work.s8_644 = 33.3125 - work.s7_219;
  work.s8_645 = fma(p_bell_crank_z, work.s8_16, p_bell_crank_x*work.s8_15);
  work.s8_646 = fnma(work.s7_219, work.s8_642, work.s7_216*work.s8_643);
  work.s8_647 = fnma(projection.zdd_star[13], work.s7_216, work.s7_219*s8_640);
  work.s8_648 = fma(work.s7_216, s8_640, projection.zdd_star[13]*work.s7_219);
  work.s8_649 = work.s7_223 - work.s7_224;
  // pitman_arm: pitman_arm, revolute, chassis
  work.s8_650 = projection.Rz[36]*work.s7_209;
  work.s8_651 = projection.Rz[36]*work.s7_210;
  work.s8_652 = projection.Rz[37]*work.s7_209;
  work.s8_653 = projection.Rz[37]*work.s7_210;
  work.s8_654 = projection.Rz[38]*work.s7_209;
  work.s8_655 = projection.Rz[38]*work.s7_210;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s8_656 = zd_pitman_arm + work.s8_12;
  const double s8_657 = zd_pitman_arm*work.s8_656;
  work.s8_658 = 2.1 + work.s7_210;
  work.s8_659 = zd_pitman_arm*work.s8_13;
  work.s8_660 = zd_pitman_arm*work.s8_14;
  work.s8_661 = 0.3504*projection.Rz[36];
  work.s8_662 = 0.3504*projection.Rz[37];
  work.s8_663 = 0.3504*projection.Rz[38];
  work.s8_664 = fma(work.s7_210, work.s8_660, work.s7_209*work.s8_659);
  work.s8_665 = 23.1 - work.s7_209;
  work.s8_666 = fma(work.s7_210, s8_657, projection.zdd_star[12]*work.s7_209);
  work.s8_667 = fnma(projection.zdd_star[12], work.s7_210, work.s7_209*s8_657);
  const double s8_668 = fnma(p_pitman_arm_z, work.s8_20, p_pitman_arm_x*work.s8_17);
  work.s8_669 = fnma(p_rear_axle_tx_z, work.s8_16, s8_668);
  const double s8_670 = fma(p_pitman_arm_z, work.s8_17, p_pitman_arm_y*work.s8_15);
  work.s8_671 = fnma(p_pitman_arm_x, work.s8_21, s8_670);
  work.s8_672 = work.s7_215 - work.s7_214;
  // arb_front_right: arb_front_right, revolute, chassis
  work.s8_673 = projection.Rz[33]*work.s7_197;
  work.s8_674 = projection.Rz[34]*work.s7_197;
  work.s8_675 = projection.Rz[35]*work.s7_197;
  work.s8_676 = projection.Rz[33]*work.s7_195;
  work.s8_677 = projection.Rz[34]*work.s7_195;
  work.s8_678 = projection.Rz[35]*work.s7_195;
  const double s8_679 = fma(p_arb_front_right_x, work.s8_21, -p_rear_axle_tx_z*work.s8_17);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.s8_680 = zd_arb_front_right*(zd_arb_front_right + work.s8_12);
  work.s8_681 = work.s7_195 - 2.25;
  work.s8_682 = zd_arb_front_right*work.s8_14;
  work.s8_683 = 0.3477*projection.Rz[33];
  work.s8_684 = 0.3477*projection.Rz[34];
  work.s8_685 = 0.3477*projection.Rz[35];
  work.s8_686 = zd_arb_front_right*work.s8_13;
  work.s8_687 = fma(work.s7_197, work.s8_686, work.s7_195*work.s8_682);
  work.s8_688 = fnma(p_arb_front_right_y, work.s8_15, s8_679);
  work.s8_689 = 17.775 + work.s7_197;
  work.s8_690 = fnma(work.s7_197, work.s8_680, projection.zdd_star[11]*work.s7_195);
  work.s8_691 = fma(work.s7_195, work.s8_680, projection.zdd_star[11]*work.s7_197);
  const double s8_692 = fnma(p_rear_axle_tx_z, work.s8_20, p_arb_front_right_x*work.s8_17);
  work.s8_693 = fma(p_arb_front_right_y, work.s8_16, s8_692);
  work.s8_694 = work.s7_208 - work.s7_207;
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.s8_695 = projection.Rz[30]*work.s7_186;
  work.s8_696 = projection.Rz[31]*work.s7_186;
  work.s8_697 = projection.Rz[32]*work.s7_186;
  work.s8_698 = 2.1 + work.s7_186;
  work.s8_699 = 0.539*projection.Rz[30];
  work.s8_700 = 0.539*projection.Rz[31];
  work.s8_701 = 0.539*projection.Rz[32];
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s8_702 = zd_upper_arm_right*(zd_upper_arm_right + work.s8_13);
  work.s8_703 = work.s7_184 - 3.75;
  work.s8_704 = zd_upper_arm_right*work.s8_14;
  work.s8_705 = zd_upper_arm_right*work.s8_12;
  work.s8_706 = fnma(work.s7_186, work.s8_704, work.s7_184*work.s8_705);
  work.s8_707 = fnma(work.s7_184, s8_702, projection.zdd_star[10]*work.s7_186);
  work.s8_708 = fma(work.s7_186, s8_702, projection.zdd_star[10]*work.s7_184);
  const double s8_709 = p_upper_arm_right_x*work.s8_15;
  const double s8_710 = fma(p_upper_arm_right_z, work.s8_16, s8_709);
  work.s8_711 = fma(p_pitman_arm_y, work.s8_22, s8_710);
  const double s8_712 = p_upper_arm_right_x*work.s8_17;
  const double s8_713 = fnma(p_upper_arm_right_z, work.s8_20, s8_712);
  work.s8_714 = fma(p_rear_axle_tx_z, work.s8_16, s8_713);
  work.s8_715 = work.s7_192 - work.s7_193;
  const double s8_716 = fnma(work.s4_48, work.s8_14, work.s4_47*work.s8_12);
  const double s8_717 = fma(work.r_carrier_right_aux1_y, work.s8_15, s8_716);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_718 = fnma(work.s1_33, work.s8_17, s8_717);
  const double s8_719 = fnma(p_upper_arm_right_x, work.s8_21, s8_718);
  const double s8_720 = fnma(work.w_chassis_y, work.s4_46, work.w_chassis_x*work.s4_35);
  work.s8_721 = work.s6_29 + s8_720;
  const double s8_722 = fms(work.w_carrier_right_x, work.w_carrier_right_y, work.s8_721);
  const double s8_723 = fnma(work.w_chassis_x, work.s4_33, work.w_chassis_z*work.s4_46);
  work.s8_724 = work.s6_39 + s8_723;
  const double s8_725 = fma(work.w_carrier_right_x, work.w_carrier_right_z, work.s8_724);
  const double s8_726 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s8_727 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s8_728 = s8_726 + s8_727;
  const double s8_729 = fma(work.s7_148, s8_722, m_carrier_right_2*s8_719);
  work.f_carrier_right_x = fnma(work.s7_142, s8_728, fma(work.s7_145, s8_725, s8_729));
  const double s8_730 = fnma(work.s1_33, work.s8_16, fnma(work.s4_47, work.s8_13, work.s8_629));
  const double s8_731 = fnma(work.r_carrier_right_aux1_y, work.s8_22, s8_730);
  const double s8_732 = s8_709 + fnma(work.s1_30, work.s6_16, s8_731);
  const double s8_733 = fma(work.w_carrier_right_x, work.w_carrier_right_y, work.s8_721);
  const double s8_734 = fnma(work.w_chassis_z, work.s4_35, work.w_chassis_y*work.s4_33);
  work.s8_735 = work.s8_628 + s8_734;
  const double s8_736 = fms(work.w_carrier_right_y, work.w_carrier_right_z, work.s8_735);
  const double s8_737 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_727);
  const double s8_738 = fma(work.s7_142, s8_733, m_carrier_right_2*s8_732);
  work.f_carrier_right_y = fnma(work.s7_148, s8_737, fma(work.s7_145, s8_736, s8_738));
  const double s8_739 = fma(work.r_carrier_right_aux1_y, work.s8_16, work.s4_48*work.s8_13);
  const double s8_740 = work.s6_17 + fma(work.s1_33, work.s8_20, s8_739);
  const double s8_741 = s8_712 + fma(work.s1_30, projection.zdd_star[6], s8_740);
  const double s8_742 = fma(work.w_carrier_right_y, work.w_carrier_right_z, work.s8_735);
  const double s8_743 = fms(work.w_carrier_right_x, work.w_carrier_right_z, work.s8_724);
  const double s8_744 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_726);
  const double s8_745 = fma(work.s7_148, s8_742, m_carrier_right_2*s8_741);
  work.f_carrier_right_z = fnma(work.s7_145, s8_744, fma(work.s7_142, s8_743, s8_745));
  const double tau_wheel_front_right = tau[Coordinate::wheel_front_right];
  const double s8_746 = fnma(work.s1_35, tau_wheel_front_right, s8_588*s8_590);
  const double s8_747 = fnma(work.s7_172, s8_733, fnma(work.s7_145, s8_732, s8_746));
  const double s8_748 = fma(work.s7_148, s8_741, fnma(work.s7_182, s8_736, s8_747));
  const double s8_749 = fma(work.s7_175, s8_743, fma(work.s7_181, s8_742, s8_748));
  work.n_carrier_right_x = fma(work.s7_163, s8_737 - s8_744, s8_749);
  const double s8_750 = work.R_carrier_right_aux2_y_y*tau_wheel_front_right;
  const double s8_751 = fma(work.s7_145, s8_719, fnma(s8_582, s8_588, s8_750));
  const double s8_752 = fma(work.s7_182, s8_725, fma(work.s7_163, s8_722, s8_751));
  const double s8_753 = fnma(work.s7_175, s8_742, fnma(work.s7_142, s8_741, s8_752));
  work.n_carrier_right_y = fma(work.s7_172, s8_744 - s8_728, fnma(work.s7_177, s8_743, s8_753));
  const double s8_754 = fma(s8_584, s8_588, work.R_carrier_right_aux2_z_y*tau_wheel_front_right);
  const double s8_755 = fnma(work.s7_181, s8_722, fnma(work.s7_148, s8_719, s8_754));
  const double s8_756 = fma(work.s7_142, s8_732, fnma(work.s7_163, s8_725, s8_755));
  const double s8_757 = fma(work.s7_172, s8_736, fma(work.s7_177, s8_733, s8_756));
  work.n_carrier_right_z = fma(work.s7_175, s8_728 - s8_737, s8_757);
  const double s8_758 = K_carrier_right_trace - work.s7_181;
  const double s8_759 = K_carrier_right_trace - work.s7_182;
  work.s8_760 = work.s1_33 + work.s1_33;
  work.s8_761 = fnma(work.s3_49, work.s7_148, work.s3_58*work.s7_145);
  work.s8_762 = fnma(work.s3_52, work.s7_148, work.s3_61*work.s7_145);
  work.s8_763 = fnma(work.s3_55, work.s7_148, work.s3_64*work.s7_145);
  const double s8_764 = fnma(work.s3_58, work.s7_142, work.s7_148*work.s8_604);
  work.s8_765 = fma(m_carrier_right_2, work.s8_605, s8_764);
  const double s8_766 = fnma(work.s3_61, work.s7_142, work.s7_148*work.s8_610);
  work.s8_767 = fma(m_carrier_right_2, work.s8_611, s8_766);
  const double s8_768 = fnma(work.s3_64, work.s7_142, work.s7_148*work.s8_616);
  work.s8_769 = fma(m_carrier_right_2, work.s8_617, s8_768);
  const double s8_770 = fnma(work.s7_145, work.s8_604, work.s3_49*work.s7_142);
  work.s8_771 = fma(m_carrier_right_2, work.s8_606, s8_770);
  const double s8_772 = fnma(work.s7_145, work.s8_610, work.s3_52*work.s7_142);
  work.s8_773 = fma(m_carrier_right_2, work.s8_612, s8_772);
  const double s8_774 = fnma(work.s7_145, work.s8_616, work.s3_55*work.s7_142);
  work.s8_775 = fma(m_carrier_right_2, work.s8_618, s8_774);
  work.s8_776 = 395.1 + work.s7_142;
  work.s8_777 = fma(109.75, work.r_carrier_right_aux1_y, work.s7_148);
  work.s8_778 = fnma(109.75, work.s1_33, work.s7_145);
  const double s8_779 = fnma(work.s3_58, work.s7_163, work.s7_142*work.s8_606);
  work.s8_780 = fma(work.s3_49, s8_759, fnma(work.s7_172, work.s8_604, s8_779));
  const double s8_781 = fnma(work.s3_61, work.s7_163, work.s7_142*work.s8_612);
  work.s8_782 = fma(work.s3_52, s8_759, fnma(work.s7_172, work.s8_610, s8_781));
  const double s8_783 = fnma(work.s3_64, work.s7_163, work.s7_142*work.s8_618);
  work.s8_784 = fma(work.s3_55, s8_759, fnma(work.s7_172, work.s8_616, s8_783));
  const double s8_785 = fnma(work.s3_49, work.s7_163, work.s3_58*s8_758);
  work.s8_786 = fnma(work.s7_142, work.s8_605, fnma(work.s7_175, work.s8_604, s8_785));
  const double s8_787 = fnma(work.s3_52, work.s7_163, work.s3_61*s8_758);
  work.s8_788 = fnma(work.s7_142, work.s8_611, fnma(work.s7_175, work.s8_610, s8_787));
  const double s8_789 = fnma(work.s3_55, work.s7_163, work.s3_64*s8_758);
  work.s8_790 = fnma(work.s7_142, work.s8_617, fnma(work.s7_175, work.s8_616, s8_789));
  const double s8_791 = fnma(work.s3_49, work.s7_172, s7_178*work.s8_604);
  const double s8_792 = fma(work.s7_148, work.s8_605, fnma(work.s3_58, work.s7_175, s8_791));
  work.s8_793 = fnma(work.s7_145, work.s8_606, s8_792);
  const double s8_794 = fnma(work.s3_52, work.s7_172, s7_178*work.s8_610);
  const double s8_795 = fma(work.s7_148, work.s8_611, fnma(work.s3_61, work.s7_175, s8_794));
  work.s8_796 = fnma(work.s7_145, work.s8_612, s8_795);
  const double s8_797 = fnma(work.s3_55, work.s7_172, s7_178*work.s8_616);
  const double s8_798 = fma(work.s7_148, work.s8_617, fnma(work.s3_64, work.s7_175, s8_797));
  work.s8_799 = fnma(work.s7_145, work.s8_618, s8_798);
  work.s8_800 = work.r_carrier_right_aux1_y + work.r_carrier_right_aux1_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s8_801 = projection.Rz[18]*work.s7_130;
  work.s8_802 = projection.Rz[19]*work.s7_130;
  work.s8_803 = projection.Rz[20]*work.s7_130;
  work.s8_804 = projection.Rz[18]*work.s7_132;
  work.s8_805 = projection.Rz[19]*work.s7_132;
  work.s8_806 = projection.Rz[20]*work.s7_132;
  work.s8_807 = 1.825625*projection.Rz[18];
  work.s8_808 = 1.825625*projection.Rz[19];
  work.s8_809 = 1.825625*projection.Rz[20];
  const double s8_810 = fma(zd_lower_arm_right, work.s8_13, work.s6_16);
  work.s8_811 = 7.75 + work.s7_132;
  work.s8_812 = zd_lower_arm_right*work.s8_14;
  work.s8_813 = zd_lower_arm_right*work.s8_12;
  work.s8_814 = fnma(work.s7_132, work.s8_812, work.s7_130*work.s8_813);
  work.s8_815 = work.s7_130 - 5.0;
  work.s8_816 = fnma(work.s7_130, s8_810, projection.zdd_star[6]*work.s7_132);
  work.s8_817 = fma(work.s7_132, s8_810, projection.zdd_star[6]*work.s7_130);
  work.s8_818 = fma(p_lower_arm_right_z, work.s8_16, s8_709);
  work.s8_819 = fnma(p_lower_arm_right_y, work.s8_22, work.s8_818);
  work.s8_820 = fnma(p_lower_arm_right_z, work.s8_20, s8_712);
  work.s8_821 = fma(p_pitman_arm_z, work.s8_16, work.s8_820);
  work.s8_822 = work.s7_138 - work.s7_139;
  // arb_front_left: arb_front_left, revolute, chassis
  work.s8_823 = work.s7_117 - 2.25;
  work.s8_824 = 0.3477*projection.Rz[15];
  work.s8_825 = 0.3477*projection.Rz[16];
  work.s8_826 = 0.3477*projection.Rz[17];
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.s8_827 = zd_arb_front_left*(zd_arb_front_left + work.s8_12);
  work.s8_828 = 17.775 + work.s7_121;
  work.s8_829 = zd_arb_front_left*work.s8_14;
  work.s8_830 = zd_arb_front_left*work.s8_13;
  work.s8_831 = fma(work.s7_121, work.s8_830, work.s7_117*work.s8_829);
  work.s8_832 = fnma(work.s7_121, work.s8_827, projection.zdd_star[5]*work.s7_117);
  work.s8_833 = fms(-p_arb_front_right_y, work.s8_15, s8_679);
  work.s8_834 = fma(work.s7_117, work.s8_827, projection.zdd_star[5]*work.s7_121);
  work.s8_835 = fnma(p_arb_front_right_y, work.s8_16, s8_692);
  work.s8_836 = work.s7_128 - work.s7_127;
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.s8_837 = 0.539*projection.Rz[12];
  work.s8_838 = 0.539*projection.Rz[13];
  work.s8_839 = 0.539*projection.Rz[14];
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s8_840 = zd_upper_arm_left*(zd_upper_arm_left + work.s8_13);
  work.s8_841 = 3.75 + work.s7_104;
  work.s8_842 = zd_upper_arm_left*work.s8_12;
  work.s8_843 = work.s7_106 - 2.1;
  work.s8_844 = zd_upper_arm_left*work.s8_14;
  work.s8_845 = fma(work.s7_106, work.s8_844, work.s7_104*work.s8_842);
  work.s8_846 = fnma(work.s7_106, s8_840, projection.zdd_star[4]*work.s7_104);
  work.s8_847 = fnma(p_rear_axle_tx_z, work.s8_16, s8_713);
  work.s8_848 = fma(work.s7_104, s8_840, projection.zdd_star[4]*work.s7_106);
  work.s8_849 = fnma(p_pitman_arm_y, work.s8_22, s8_710);
  work.s8_850 = work.s7_112 - work.s7_113;
  const double s8_851 = fma(work.s4_44, work.s8_14, work.s4_43*work.s8_12);
  const double s8_852 = fma(work.r_carrier_left_aux1_y, work.s8_15, s8_851);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_853 = fma(work.r_carrier_left_aux1_z, work.s8_17, s8_852);
  const double s8_854 = fnma(p_upper_arm_right_x, work.s8_21, s8_853);
  const double s8_855 = fnma(work.w_chassis_y, work.s4_42, work.w_chassis_x*work.s4_31);
  work.s8_856 = work.s6_23 + s8_855;
  const double s8_857 = fms(work.w_carrier_left_x, work.w_carrier_left_y, work.s8_856);
  const double s8_858 = fnma(work.w_chassis_x, work.s4_29, work.w_chassis_z*work.s4_42);
  work.s8_859 = work.s6_34 + s8_858;
  const double s8_860 = fma(work.w_carrier_left_x, work.w_carrier_left_z, work.s8_859);
  const double s8_861 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s8_862 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s8_863 = s8_861 + s8_862;
  const double s8_864 = fma(work.s7_69, s8_857, m_carrier_left_2*s8_854);
  work.f_carrier_left_x = fnma(work.s7_72, s8_863, fma(work.s7_66, s8_860, s8_864));
  const double s8_865 = fnma(work.s4_43, work.s8_13, work.r_carrier_left_aux1_z*work.s8_16);
  const double s8_866 = fnma(work.r_carrier_left_aux1_y, work.s8_22, s8_865) - work.s6_14;
  const double s8_867 = s8_709 + fnma(work.s1_20, projection.zdd_star[0], s8_866);
  const double s8_868 = fnma(work.w_chassis_z, work.s4_31, work.w_chassis_y*work.s4_29);
  work.s8_869 = work.s8_623 + s8_868;
  const double s8_870 = fms(work.w_carrier_left_y, work.w_carrier_left_z, work.s8_869);
  const double s8_871 = fma(work.w_carrier_left_x, work.w_carrier_left_y, work.s8_856);
  const double s8_872 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_862);
  const double s8_873 = fma(work.s7_66, s8_870, m_carrier_left_2*s8_867);
  work.f_carrier_left_y = fnma(work.s7_69, s8_872, fma(work.s7_72, s8_871, s8_873));
  const double s8_874 = fnma(work.s4_44, work.s8_13, work.r_carrier_left_aux1_y*work.s8_16);
  const double s8_875 = fnma(work.r_carrier_left_aux1_z, work.s8_20, s8_874) - work.s6_15;
  const double s8_876 = s8_712 + fma(work.s1_18, projection.zdd_star[0], s8_875);
  const double s8_877 = fma(work.w_carrier_left_y, work.w_carrier_left_z, work.s8_869);
  const double s8_878 = fms(work.w_carrier_left_x, work.w_carrier_left_z, work.s8_859);
  const double s8_879 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_861);
  const double s8_880 = fma(work.s7_69, s8_877, m_carrier_left_2*s8_876);
  work.f_carrier_left_z = fnma(work.s7_66, s8_879, fma(work.s7_72, s8_878, s8_880));
  const double tau_wheel_front_left = tau[Coordinate::wheel_front_left];
  const double s8_881 = fnma(work.s1_22, tau_wheel_front_left, s8_598*s8_600);
  const double s8_882 = fnma(work.s7_102, s8_870, fnma(work.s7_66, s8_867, s8_881));
  const double s8_883 = fma(work.s7_69, s8_876, fnma(work.s7_94, s8_871, s8_882));
  const double s8_884 = fma(work.s7_96, s8_878, fma(work.s7_101, s8_877, s8_883));
  work.n_carrier_left_x = fma(work.s7_86, s8_872 - s8_879, s8_884);
  const double s8_885 = fnma(s8_592, s8_598, work.R_carrier_left_aux2_y_y*tau_wheel_front_left);
  const double s8_886 = fma(work.s7_86, s8_857, fma(work.s7_66, s8_854, s8_885));
  const double s8_887 = fnma(work.s7_72, s8_876, fma(work.s7_102, s8_860, s8_886));
  const double s8_888 = fnma(work.s7_98, s8_878, fnma(work.s7_96, s8_877, s8_887));
  work.n_carrier_left_y = fma(work.s7_94, s8_879 - s8_863, s8_888);
  const double s8_889 = fma(s8_594, s8_598, work.R_carrier_left_aux2_z_y*tau_wheel_front_left);
  const double s8_890 = fnma(work.s7_101, s8_857, fnma(work.s7_69, s8_854, s8_889));
  const double s8_891 = fma(work.s7_72, s8_867, fnma(work.s7_86, s8_860, s8_890));
  const double s8_892 = fma(work.s7_98, s8_871, fma(work.s7_94, s8_870, s8_891));
  work.n_carrier_left_z = fma(work.s7_96, s8_863 - s8_872, s8_892);
  const double s8_893 = K_carrier_left_trace - work.s7_101;
  const double s8_894 = K_carrier_left_trace - work.s7_102;
  work.s8_895 = fnma(work.s3_31, work.s7_69, work.s3_40*work.s7_66);
  work.s8_896 = fnma(work.s3_34, work.s7_69, work.s3_43*work.s7_66);
  work.s8_897 = fnma(work.s3_37, work.s7_69, work.s3_46*work.s7_66);
  const double s8_898 = work.s8_763 + (work.s8_678 - work.s8_632 - work.s8_655);
  work.s8_899 = work.s8_897 + fma(projection.Rz[17], work.s7_117, s8_898);
  const double s8_900 = fnma(work.s3_40, work.s7_72, work.s7_69*work.s8_601);
  work.s8_901 = fma(m_carrier_left_2, work.s8_602, s8_900);
  const double s8_902 = fnma(work.s3_43, work.s7_72, work.s7_69*work.s8_607);
  work.s8_903 = fma(m_carrier_left_2, work.s8_608, s8_902);
  const double s8_904 = fnma(work.s3_46, work.s7_72, work.s7_69*work.s8_613);
  work.s8_905 = fma(m_carrier_left_2, work.s8_614, s8_904);
  const double s8_906 = fnma(work.s7_66, work.s8_601, work.s3_31*work.s7_72);
  work.s8_907 = fnma(m_carrier_left_2, work.s8_603, s8_906);
  const double s8_908 = fnma(work.s7_66, work.s8_607, work.s3_34*work.s7_72);
  work.s8_909 = fnma(m_carrier_left_2, work.s8_609, s8_908);
  const double s8_910 = fnma(work.s7_66, work.s8_613, work.s3_37*work.s7_72);
  work.s8_911 = fnma(m_carrier_left_2, work.s8_615, s8_910);
  work.s8_912 = fma(109.75, work.r_carrier_left_aux1_z, work.s7_66);
  work.s8_913 = fma(109.75, work.r_carrier_left_aux1_y, work.s7_69);
  work.s8_914 = 395.1 + work.s7_72;
  work.s8_915 = work.r_carrier_left_aux1_z + work.r_carrier_left_aux1_z;
  work.s8_916 = work.r_carrier_left_aux1_y + work.r_carrier_left_aux1_y;
  const double s8_917 = fnma(work.s3_40, work.s7_86, work.s3_31*s8_894);
  work.s8_918 = fnma(work.s7_72, work.s8_603, fnma(work.s7_94, work.s8_601, s8_917));
  const double s8_919 = fnma(work.s3_43, work.s7_86, work.s3_34*s8_894);
  work.s8_920 = fnma(work.s7_72, work.s8_609, fnma(work.s7_94, work.s8_607, s8_919));
  const double s8_921 = fnma(work.s3_46, work.s7_86, work.s3_37*s8_894);
  work.s8_922 = fnma(work.s7_72, work.s8_615, fnma(work.s7_94, work.s8_613, s8_921));
  const double s8_923 = fnma(work.s3_31, work.s7_86, work.s3_40*s8_893);
  work.s8_924 = fnma(work.s7_72, work.s8_602, fnma(work.s7_96, work.s8_601, s8_923));
  const double s8_925 = fnma(work.s3_34, work.s7_86, work.s3_43*s8_893);
  work.s8_926 = fnma(work.s7_72, work.s8_608, fnma(work.s7_96, work.s8_607, s8_925));
  const double s8_927 = fnma(work.s3_37, work.s7_86, work.s3_46*s8_893);
  work.s8_928 = fnma(work.s7_72, work.s8_614, fnma(work.s7_96, work.s8_613, s8_927));
  const double s8_929 = fnma(work.s3_31, work.s7_94, s7_99*work.s8_601);
  const double s8_930 = fma(work.s7_69, work.s8_602, fnma(work.s3_40, work.s7_96, s8_929));
  work.s8_931 = fma(work.s7_66, work.s8_603, s8_930);
  const double s8_932 = fnma(work.s3_34, work.s7_94, s7_99*work.s8_607);
  const double s8_933 = fma(work.s7_69, work.s8_608, fnma(work.s3_43, work.s7_96, s8_932));
  work.s8_934 = fma(work.s7_66, work.s8_609, s8_933);
  const double s8_935 = fnma(work.s3_37, work.s7_94, s7_99*work.s8_613);
  const double s8_936 = fma(work.s7_69, work.s8_614, fnma(work.s3_46, work.s7_96, s8_935));
  work.s8_937 = fma(work.s7_66, work.s8_615, s8_936);
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s8_938 = work.s7_130 + (work.s7_104 + (5.25 + work.s7_54));
}

/// Part 4 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_chosen_accelerations_4(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s8_939 = work.s7_216 + (work.s7_184 + work.s8_938);
  const double s8_940 = fma(projection.Rz[32], work.s7_184, work.s8_654 - work.s8_675);
  const double s8_941 = work.s8_803 + (work.s8_769 + s8_940);
  const double s8_942 = fnma(projection.Rz[17], work.s7_121, s8_941);
  const double s8_943 = work.s8_905 + fma(projection.Rz[14], work.s7_104, s8_942);
  work.s8_944 = fma(projection.Rz[2], work.s7_54, s8_943);
  const double s8_945 = work.s8_806 + (work.s8_775 + (work.s8_697 - work.s8_638));
  const double s8_946 = work.s8_911 + fnma(projection.Rz[14], work.s7_106, s8_945);
  work.s8_947 = fnma(projection.Rz[2], work.s7_56, s8_946);
  work.s8_948 = 1.825625*projection.Rz[0];
  work.s8_949 = 1.825625*projection.Rz[1];
  const double s8_950 = 1.825625*projection.Rz[2];
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s8_951 = fma(zd_lower_arm_left, work.s8_13, work.s6_13);
  work.s8_952 = 5.0 + work.s7_54;
  work.s8_953 = zd_lower_arm_left*work.s8_12;
  work.s8_954 = work.s7_56 - 7.75;
  work.s8_955 = zd_lower_arm_left*work.s8_14;
  work.s8_956 = fma(work.s7_56, work.s8_955, work.s7_54*work.s8_953);
  work.s8_957 = fnma(work.s7_56, s8_951, projection.zdd_star[0]*work.s7_54);
  const double s8_958 = fnma(p_pitman_arm_z, work.s8_16, work.s8_820);
  work.s8_959 = fma(work.s7_54, s8_951, projection.zdd_star[0]*work.s7_56);
  const double s8_960 = fma(p_lower_arm_right_y, work.s8_22, work.s8_818);
  const double s8_961 = work.s7_62 - work.s7_63;
  const double R_arb_front_left_x_z = work.sines[8];
  // arb_link_front_left
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s8_962 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s8_963 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s8_962);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s8_964 = zd_arb_front_left*s8_963;
  const double s8_965 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  const double s8_966 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s8_965);
  const double s8_967 = zd_arb_front_left*s8_966;
  const double s8_968 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s8_969 = work.s1_22 + work.R_carrier_left_x_z;
  const double s8_970 = fnma(p_arb_link_front_left_to_y, s8_969, s8_968);
  const double s8_971 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s8_972 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  const double s8_973 = fnma(p_arb_link_front_left_to_y, s8_971, s8_972);
  const double s8_974 = fnma(work.s4_42, s8_973, work.s4_29*s8_970);
  const double s8_975 = s8_974 - work.s4_44;
  work.s8_976 = fnma(work.s8_601, s8_973, fms(work.s3_31, s8_970, work.s8_603));
  work.s8_977 = fnma(work.s8_607, s8_973, fms(work.s3_34, s8_970, work.s8_609));
  work.s8_978 = fnma(work.s8_613, s8_973, fms(work.s3_37, s8_970, work.s8_615));
  work.s8_979 = s8_966 + p_arb_front_left_z - work.r_carrier_left_aux1_z - s8_973;
  work.s8_980 = 0.35 + s8_963 - s8_970;
  const double s8_981 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s8_982 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  const double s8_983 = fnma(p_arb_link_front_left_to_y, s8_981, s8_982);
  work.s8_984 = 0.72 - work.r_carrier_left_aux1_y - s8_983;
  work.s8_985 = 0.3333333333333333*work.s8_984;
  work.s8_986 = 0.3333333333333333*work.s8_980;
  work.s8_987 = 0.3333333333333333*work.s8_979;
  const double s8_988 = fnma(work.s4_31, s8_970, work.s4_42*s8_983);
  const double s8_989 = s8_988 + (work.s4_43 + s8_964);
  const double s8_990 = fnma(work.s3_40, s8_970, fma(projection.Rz[15], s8_963, work.s8_602));
  work.s8_991 = fma(work.s8_601, s8_983, s8_990);
  const double s8_992 = fnma(work.s3_43, s8_970, fma(projection.Rz[16], s8_963, work.s8_608));
  work.s8_993 = fma(work.s8_607, s8_983, s8_992);
  const double s8_994 = fnma(work.s3_46, s8_970, fma(projection.Rz[17], s8_963, work.s8_614));
  work.s8_995 = fma(work.s8_613, s8_983, s8_994);
  const double s8_996 = fnma(work.s3_40, s8_973, projection.Rz[15]*s8_966);
  work.s8_997 = fma(work.s3_31, s8_983, s8_996);
  const double s8_998 = fnma(work.s3_43, s8_973, projection.Rz[16]*s8_966);
  work.s8_999 = fma(work.s3_34, s8_983, s8_998);
  const double s8_1000 = fnma(work.s3_46, s8_973, projection.Rz[17]*s8_966);
  work.s8_1001 = fma(work.s3_37, s8_983, s8_1000);
  const double s8_1002 = fnma(work.s4_29, s8_983, work.s4_31*s8_973);
  const double s8_1003 = s8_967 - s8_1002;
  const double s8_1004 = fnma(zd_arb_front_left, s8_964, projection.zdd_star[5]*s8_966);
  const double s8_1005 = fma(work.s4_29, s8_974, fnma(work.s6_34, s8_973, s8_1004));
  const double s8_1006 = fma(work.s8_17, work.s8_979, fma(work.s8_14, s8_975, s8_1005));
  const double s8_1007 = fma(work.s6_23, s8_983, fnma(work.s8_21, work.s8_980, s8_1006));
  const double s8_1008 = fnma(work.s4_31, s8_988, fma(work.s8_15, work.s8_984, s8_1007));
  work.s8_1009 = 0.3333333333333333*fnma(work.s8_12, s8_989, s8_1008);
  const double s8_1010 = fma(work.s1_20, projection.zdd_star[0], work.s6_14);
  const double s8_1011 = fnma(work.s6_23, s8_970, work.s8_623*s8_973);
  const double s8_1012 = fma(work.s8_15, work.s8_980, fma(work.s8_16, work.s8_979, s8_1011));
  const double s8_1013 = fma(work.s4_42, s8_988, fnma(work.s8_22, work.s8_984, s8_1012));
  const double s8_1014 = fnma(work.s4_29, s8_1002, fma(work.s8_13, s8_989, s8_1013));
  work.s8_1015 = 0.3333333333333333*(s8_1010 + fma(work.s8_14, s8_1003, s8_1014));
  const double s8_1016 = fnma(work.s1_18, projection.zdd_star[0], work.s6_15);
  const double s8_1017 = fnma(projection.zdd_star[5], s8_963, work.s6_34*s8_970);
  const double s8_1018 = fnma(work.s4_42, s8_974, fnma(zd_arb_front_left, s8_967, s8_1017));
  const double s8_1019 = fnma(work.s8_20, work.s8_979, fnma(work.s8_13, s8_975, s8_1018));
  const double s8_1020 = fnma(work.s8_623, s8_983, fma(work.s8_17, work.s8_980, s8_1019));
  const double s8_1021 = fma(work.s4_31, s8_1002, fma(work.s8_16, work.s8_984, s8_1020));
  work.s8_1022 = 0.3333333333333333*(s8_1016 + fnma(work.s8_12, s8_1003, s8_1021));
  const double R_arb_front_right_x_z = work.sines[14];
  // arb_link_front_right
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s8_1023 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s8_1024 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s8_1023);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s8_1025 = zd_arb_front_right*s8_1024;
  const double s8_1026 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  const double s8_1027 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s8_1026);
  const double s8_1028 = zd_arb_front_right*s8_1027;
  const double s8_1029 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s8_1030 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  const double s8_1031 = fnma(p_arb_link_front_left_to_y, s8_1029, s8_1030);
  work.s8_1032 = s8_1031 + (0.72 + work.r_carrier_right_aux1_y);
  const double s8_1033 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s8_1034 = work.R_carrier_right_x_z - work.s1_35;
  const double s8_1035 = fnma(p_arb_link_front_left_to_y, s8_1034, s8_1033);
  const double s8_1036 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s8_1037 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  const double s8_1038 = fnma(p_arb_link_front_left_to_y, s8_1036, s8_1037);
  const double s8_1039 = fnma(work.s4_46, s8_1038, work.s4_33*s8_1035);
  const double s8_1040 = work.s4_48 + s8_1039;
  work.s8_1041 = fnma(work.s8_604, s8_1038, fma(work.s3_49, s8_1035, work.s8_606));
  work.s8_1042 = fnma(work.s8_610, s8_1038, fma(work.s3_52, s8_1035, work.s8_612));
  work.s8_1043 = fnma(work.s8_616, s8_1038, fma(work.s3_55, s8_1035, work.s8_618));
  work.s8_1044 = s8_1027 + (work.s1_33 + p_arb_front_right_z) - s8_1038;
  work.s8_1045 = 0.35 + s8_1024 - s8_1035;
  work.s8_1046 = 0.3333333333333333*work.s8_1045;
  work.s8_1047 = 0.3333333333333333*work.s8_1044;
  work.s8_1048 = 0.3333333333333333*work.s8_1032;
  const double s8_1049 = fnma(work.s4_35, s8_1035, work.s4_46*s8_1031);
  const double s8_1050 = s8_1049 + (work.s4_47 + s8_1025);
  const double s8_1051 = fma(work.s8_604, s8_1031, fma(projection.Rz[33], s8_1024, work.s8_605));
  work.s8_1052 = fnma(work.s3_58, s8_1035, s8_1051);
  const double s8_1053 = fma(work.s8_610, s8_1031, fma(projection.Rz[34], s8_1024, work.s8_611));
  work.s8_1054 = fnma(work.s3_61, s8_1035, s8_1053);
  const double s8_1055 = fma(work.s8_616, s8_1031, fma(projection.Rz[35], s8_1024, work.s8_617));
  work.s8_1056 = fnma(work.s3_64, s8_1035, s8_1055);
  const double s8_1057 = fma(work.s3_49, s8_1031, projection.Rz[33]*s8_1027);
  work.s8_1058 = fnma(work.s3_58, s8_1038, s8_1057);
  const double s8_1059 = fma(work.s3_52, s8_1031, projection.Rz[34]*s8_1027);
  work.s8_1060 = fnma(work.s3_61, s8_1038, s8_1059);
  const double s8_1061 = fma(work.s3_55, s8_1031, projection.Rz[35]*s8_1027);
  work.s8_1062 = fnma(work.s3_64, s8_1038, s8_1061);
  const double s8_1063 = fnma(work.s4_33, s8_1031, work.s4_35*s8_1038);
  const double s8_1064 = s8_1028 - s8_1063;
  const double s8_1065 = fms(work.s1_30, work.s6_16, work.s8_629);
  const double s8_1066 = fnma(work.s6_29, s8_1035, work.s8_22*work.s8_1032);
  const double s8_1067 = fma(work.s8_16, work.s8_1044, fma(work.s8_628, s8_1038, s8_1066));
  const double s8_1068 = fma(work.s4_46, s8_1049, fma(work.s8_15, work.s8_1045, s8_1067));
  const double s8_1069 = fnma(work.s4_33, s8_1063, fma(work.s8_13, s8_1050, s8_1068));
  work.s8_1070 = 0.3333333333333333*(s8_1065 + fma(work.s8_14, s8_1064, s8_1069));
  const double s8_1071 = fnma(zd_arb_front_right, s8_1025, projection.zdd_star[11]*s8_1027);
  const double s8_1072 = fnma(work.s8_15, work.s8_1032, fma(work.s6_29, s8_1031, s8_1071));
  const double s8_1073 = fma(work.s4_33, s8_1039, fnma(work.s6_39, s8_1038, s8_1072));
  const double s8_1074 = fma(work.s8_17, work.s8_1044, fma(work.s8_14, s8_1040, s8_1073));
  const double s8_1075 = fnma(work.s4_35, s8_1049, fnma(work.s8_21, work.s8_1045, s8_1074));
  work.s8_1076 = 0.3333333333333333*fnma(work.s8_12, s8_1050, s8_1075);
  const double s8_1077 = fms(work.s6_39, s8_1035, work.s6_17);
  const double s8_1078 = fnma(work.s1_30, projection.zdd_star[6], s8_1077);
  const double s8_1079 = fnma(projection.zdd_star[11], s8_1024, s8_1078);
  const double s8_1080 = fnma(work.s8_628, s8_1031, fnma(zd_arb_front_right, s8_1028, s8_1079));
  const double s8_1081 = fnma(work.s4_46, s8_1039, fnma(work.s8_16, work.s8_1032, s8_1080));
  const double s8_1082 = fnma(work.s8_20, work.s8_1044, fnma(work.s8_13, s8_1040, s8_1081));
  const double s8_1083 = fma(work.s4_35, s8_1063, fma(work.s8_17, work.s8_1045, s8_1082));
  work.s8_1084 = 0.3333333333333333*fnma(work.s8_12, s8_1064, s8_1083);
  // drag_link
  const double s8_1085 = -p_drag_link_from_z*work.sines[15];
  const double s8_1086 = -p_drag_link_from_z*work.cosines[15];
  const double R_bell_crank_y_x = work.sines[16];
  const double s8_1087 = p_drag_link_to_y*R_bell_crank_y_x;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s8_1088 = zd_pitman_arm*s8_1085;
  const double s8_1089 = zd_pitman_arm*s8_1086;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s8_1090 = zd_bell_crank*s8_1087;
  const double R_bell_crank_x_x = work.cosines[16];
  const double s8_1091 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s8_1092 = zd_bell_crank*s8_1091;
  work.s8_1093 = projection.Rz[36]*s8_1085;
  work.s8_1094 = projection.Rz[37]*s8_1085;
  work.s8_1095 = projection.Rz[38]*s8_1085;
  work.s8_1096 = projection.Rz[39]*s8_1087;
  work.s8_1097 = projection.Rz[40]*s8_1087;
  work.s8_1098 = projection.Rz[41]*s8_1087;
  work.s8_1099 = p_pitman_arm_y - s8_1091;
  work.s8_1100 = 1.5*work.s8_1099;
  work.s8_1101 = 0.2 - s8_1086;
  work.s8_1102 = s8_1087 + (1.15 - s8_1085);
  work.s8_1103 = 1.5*work.s8_1101;
  work.s8_1104 = 1.5*work.s8_1102;
  work.s8_1105 = fnma(projection.Rz[36], s8_1086, projection.Rz[39]*s8_1091);
  work.s8_1106 = fnma(projection.Rz[37], s8_1086, projection.Rz[40]*s8_1091);
  work.s8_1107 = fnma(projection.Rz[38], s8_1086, projection.Rz[41]*s8_1091);
  const double s8_1108 = fma(work.s8_1096, work.s8_1096, work.s8_1093*work.s8_1093);
  const double s8_1109 = fma(work.s8_1105, work.s8_1105, s8_1108);
  const double s8_1110 = fma(work.s8_1096, work.s8_1097, work.s8_1093*work.s8_1094);
  work.s8_1111 = fma(work.s8_1105, work.s8_1106, s8_1110);
  const double s8_1112 = fma(work.s8_1096, work.s8_1098, work.s8_1093*work.s8_1095);
  const double s8_1113 = fma(work.s8_1105, work.s8_1107, s8_1112);
  const double s8_1114 = fma(work.s8_1097, work.s8_1097, work.s8_1094*work.s8_1094);
  const double s8_1115 = fma(work.s8_1106, work.s8_1106, s8_1114);
  const double s8_1116 = fma(work.s8_1097, work.s8_1098, work.s8_1094*work.s8_1095);
  const double s8_1117 = fma(work.s8_1106, work.s8_1107, s8_1116);
  const double s8_1118 = fma(work.s8_1098, work.s8_1098, work.s8_1095*work.s8_1095);
  const double s8_1119 = fma(work.s8_1107, work.s8_1107, s8_1118);
  const double s8_1120 = fnma(projection.zdd_star[12], s8_1086, work.s8_656*s8_1088);
  const double s8_1121 = fnma(work.s8_639, s8_1090, s8_1120);
  const double s8_1122 = fma(projection.zdd_star[13], s8_1091, s8_1121);
  const double s8_1123 = fma(work.s8_17, work.s8_1101, fma(work.s8_15, work.s8_1099, s8_1122));
  work.s8_1124 = 1.5*fnma(work.s8_21, work.s8_1102, s8_1123);
  const double s8_1125 = s8_1092 - s8_1089;
  const double s8_1126 = fma(zd_pitman_arm, s8_1089, projection.zdd_star[12]*s8_1085);
  const double s8_1127 = fma(work.s8_16, work.s8_1099, fma(work.s8_13, s8_1090, s8_1126));
  const double s8_1128 = fma(work.s8_17, work.s8_1102, fnma(work.s8_20, work.s8_1101, s8_1127));
  work.s8_1129 = 1.5*fnma(work.s8_12, s8_1125, s8_1128);
  const double s8_1130 = fnma(work.s8_13, s8_1088, projection.zdd_star[13]*s8_1087);
  const double s8_1131 = fnma(work.s8_22, work.s8_1099, fma(zd_bell_crank, s8_1092, s8_1130));
  const double s8_1132 = fma(work.s8_15, work.s8_1102, fma(work.s8_16, work.s8_1101, s8_1131));
  work.s8_1133 = 1.5*fma(work.s8_14, s8_1125, s8_1132);
  // tie_rod_left
  const double s8_1134 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s8_1135 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  const double s8_1136 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s8_1134);
  const double s8_1137 = zd_bell_crank*s8_1136;
  const double s8_1138 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s8_1135);
  const double s8_1139 = zd_bell_crank*s8_1138;
  const double s8_1140 = p_tie_rod_left_to_z*work.R_carrier_left_z_z;
  const double s8_1141 = fma(p_tie_rod_left_to_y, work.R_carrier_left_aux2_z_y, s8_1140);
  const double s8_1142 = fma(p_tie_rod_left_to_x, work.R_carrier_left_z_x, s8_1141);
  work.s8_1143 = s8_1142 + (work.r_carrier_left_aux1_z - p_bell_crank_z);
  const double s8_1144 = p_tie_rod_left_to_z*work.R_carrier_left_y_z;
  const double s8_1145 = fma(p_tie_rod_left_to_y, work.R_carrier_left_aux2_y_y, s8_1144);
  const double s8_1146 = fma(p_tie_rod_left_to_x, work.R_carrier_left_y_x, s8_1145);
  const double s8_1147 = -p_tie_rod_left_to_y*work.s1_22;
  const double s8_1148 = fma(p_tie_rod_left_to_x, work.R_carrier_left_x_x, s8_1147);
  const double s8_1149 = fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, s8_1148);
  const double s8_1150 = fnma(work.s4_31, s8_1149, work.s4_42*s8_1146);
  const double s8_1151 = work.s4_43 + s8_1150;
  work.s8_1152 = fnma(work.s3_40, s8_1149, fma(work.s8_601, s8_1146, work.s8_602));
  work.s8_1153 = fnma(work.s3_43, s8_1149, fma(work.s8_607, s8_1146, work.s8_608));
  work.s8_1154 = fnma(work.s3_46, s8_1149, fma(work.s8_613, s8_1146, work.s8_614));
  const double s8_1155 = fnma(work.s4_29, s8_1146, work.s4_31*s8_1142);
  const double s8_1156 = s8_1139 + s8_1155;
  const double s8_1157 = fma(work.s3_40, s8_1142, projection.Rz[39]*s8_1138);
  work.s8_1158 = fnma(work.s3_31, s8_1146, s8_1157);
  const double s8_1159 = fma(work.s3_43, s8_1142, projection.Rz[40]*s8_1138);
  work.s8_1160 = fnma(work.s3_34, s8_1146, s8_1159);
  const double s8_1161 = fma(work.s3_46, s8_1142, projection.Rz[41]*s8_1138);
  work.s8_1162 = fnma(work.s3_37, s8_1146, s8_1161);
  work.s8_1163 = s8_1149 + (0.35 + s8_1136);
  work.s8_1164 = s8_1138 - work.r_carrier_left_aux1_y - s8_1146;
  work.s8_1165 = 1.1666666666666667*work.s8_1164;
  work.s8_1166 = 1.1666666666666667*work.s8_1163;
  const double s8_1167 = fnma(work.s4_42, s8_1142, work.s4_29*s8_1149);
  const double s8_1168 = s8_1167 + (s8_1137 - work.s4_44);
  const double s8_1169 = fnma(work.s8_601, s8_1142, fms(projection.Rz[39], s8_1136, work.s8_603));
  work.s8_1170 = fma(work.s3_31, s8_1149, s8_1169);
  const double s8_1171 = fnma(work.s8_607, s8_1142, fms(projection.Rz[40], s8_1136, work.s8_609));
  work.s8_1172 = fma(work.s3_34, s8_1149, s8_1171);
  const double s8_1173 = fnma(work.s8_613, s8_1142, fms(projection.Rz[41], s8_1136, work.s8_615));
  work.s8_1174 = fma(work.s3_37, s8_1149, s8_1173);
  work.s8_1175 = 1.1666666666666667*work.s8_1143;
  const double s8_1176 = fnma(work.s8_623, s8_1146, fma(work.s8_20, work.s8_1143, s8_1016));
  const double s8_1177 = fma(work.s4_31, s8_1155, fma(work.s6_34, s8_1149, s8_1176));
  const double s8_1178 = fnma(work.s8_17, work.s8_1163, fma(work.s8_12, s8_1156, s8_1177));
  const double s8_1179 = fnma(work.s4_42, s8_1167, fma(work.s8_16, work.s8_1164, s8_1178));
  work.s8_1180 = 1.1666666666666667*fnma(work.s8_13, s8_1168, s8_1179);
  const double s8_1181 = fnma(projection.zdd_star[13], s8_1138, zd_bell_crank*s8_1137);
  const double s8_1182 = fnma(work.s8_17, work.s8_1143, fnma(work.s6_34, s8_1142, s8_1181));
  const double s8_1183 = fnma(work.s4_31, s8_1150, fma(work.s6_23, s8_1146, s8_1182));
  const double s8_1184 = fma(work.s8_21, work.s8_1163, fnma(work.s8_12, s8_1151, s8_1183));
  const double s8_1185 = fma(work.s4_29, s8_1167, fma(work.s8_15, work.s8_1164, s8_1184));
  work.s8_1186 = 1.1666666666666667*fma(work.s8_14, s8_1168, s8_1185);
  const double s8_1187 = fnma(projection.zdd_star[13], s8_1136, s8_1010);
  const double s8_1188 = fma(work.s8_623, s8_1142, fnma(zd_bell_crank, s8_1139, s8_1187));
  const double s8_1189 = fnma(work.s6_23, s8_1149, fnma(work.s8_16, work.s8_1143, s8_1188));
  const double s8_1190 = fma(work.s8_13, s8_1151, fma(work.s4_42, s8_1150, s8_1189));
  const double s8_1191 = fnma(work.s8_14, s8_1156, fnma(work.s4_29, s8_1155, s8_1190));
  const double s8_1192 = fnma(work.s8_22, work.s8_1164, fnma(work.s8_15, work.s8_1163, s8_1191));
  work.s8_1193 = 1.1666666666666667*s8_1192;
  // tie_rod_right
  const double s8_1194 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s8_1135);
  const double s8_1195 = zd_bell_crank*s8_1194;
  const double s8_1196 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s8_1134);
  const double s8_1197 = zd_bell_crank*s8_1196;
  const double s8_1198 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s8_1199 = fma(p_tie_rod_right_to_x, work.R_carrier_right_z_x, s8_1198);
  const double s8_1200 = fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, s8_1199);
  work.s8_1201 = s8_1200 + (-p_bell_crank_z - work.s1_33);
  const double s8_1202 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s8_1203 = fma(p_tie_rod_right_to_x, work.R_carrier_right_y_x, s8_1202);
  const double s8_1204 = fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, s8_1203);
  work.s8_1205 = s8_1204 + (work.r_carrier_right_aux1_y + s8_1194);
  const double s8_1206 = p_tie_rod_right_to_z*work.R_carrier_right_x_z;
  const double s8_1207 = fnma(p_tie_rod_right_to_y, work.s1_35, s8_1206);
  const double s8_1208 = fma(p_tie_rod_right_to_x, work.R_carrier_right_x_x, s8_1207);
  const double s8_1209 = fnma(work.s4_35, s8_1208, work.s4_46*s8_1204);
  const double s8_1210 = work.s4_47 + s8_1209;
  work.s8_1211 = fnma(work.s3_58, s8_1208, fma(work.s8_604, s8_1204, work.s8_605));
  work.s8_1212 = fnma(work.s3_61, s8_1208, fma(work.s8_610, s8_1204, work.s8_611));
  work.s8_1213 = fnma(work.s3_64, s8_1208, fma(work.s8_616, s8_1204, work.s8_617));
  work.s8_1214 = s8_1196 - 0.35 - s8_1208;
  work.s8_1215 = 1.1666666666666667*work.s8_1214;
  work.s8_1216 = 1.1666666666666667*work.s8_1205;
  work.s8_1217 = 1.1666666666666667*work.s8_1201;
  const double s8_1218 = fnma(work.s3_58, s8_1200, projection.Rz[39]*s8_1194);
  work.s8_1219 = fma(work.s3_49, s8_1204, s8_1218);
  const double s8_1220 = fnma(work.s3_61, s8_1200, projection.Rz[40]*s8_1194);
  work.s8_1221 = fma(work.s3_52, s8_1204, s8_1220);
  const double s8_1222 = fnma(work.s3_64, s8_1200, projection.Rz[41]*s8_1194);
  work.s8_1223 = fma(work.s3_55, s8_1204, s8_1222);
  const double s8_1224 = work.s8_803 + fma(projection.Rz[32], work.s7_184, work.s8_769);
  const double s8_1225 = work.s8_905 + fma(projection.Rz[14], work.s7_104, s8_1224);
  const double s8_1226 = fnma(p_pitman_arm_x, work.s8_654, -p_bell_crank_z*work.s8_632);
  const double s8_1227 = work.s8_685 + (work.s8_663 + fnma(p_pitman_arm_z, work.s8_655, s8_1226));
  const double s8_1228 = work.s8_826 + (work.s8_790 + fnma(work.s1_33, work.s8_763, s8_1227));
  const double s8_1229 = work.s8_928 + fma(work.r_carrier_left_aux1_z, work.s8_897, s8_1228);
  const double s8_1230 = fnma(work.s8_987, work.s8_1001, fnma(work.s8_986, work.s8_995, s8_1229));
  const double s8_1231 = fnma(work.s8_1046, work.s8_1056, s8_1230);
  const double s8_1232 = fnma(work.s8_1047, work.s8_1062, s8_1231);
  const double s8_1233 = fma(work.s8_1095, work.s8_1104, s8_1232);
  const double s8_1234 = fnma(work.s8_1103, work.s8_1107, s8_1233);
  const double s8_1235 = fma(work.s8_1154, work.s8_1166, s8_1234);
  const double s8_1236 = fnma(work.s8_1162, work.s8_1175, s8_1235);
  const double s8_1237 = fnma(work.s8_1213, work.s8_1215, s8_1236);
  const double s8_1238 = fma(projection.Rz[2], work.s7_54, s8_1225);
  const double s8_1239 = fma(work.s8_1217, work.s8_1223, s8_1237);
  const double s8_1240 = fma(projection.Rz[17], work.s7_117, work.s8_678);
  const double s8_1241 = fnma(0.5, s8_1240, fnma(p_lower_arm_left_x, s8_1238, s8_1239));
  const double s8_1242 = fma(projection.Rz[17], work.s7_121, work.s8_675);
  work.s8_1243 = fma(p_arb_front_right_x, s8_1242, s8_1241);
  const double s8_1244 = fnma(work.s4_46, s8_1200, work.s4_33*s8_1208);
  const double s8_1245 = fnma(work.s4_33, s8_1204, work.s4_35*s8_1200);
  const double s8_1246 = fma(work.s8_604, s8_1200, fms(projection.Rz[39], s8_1196, work.s8_606));
  work.s8_1247 = fnma(work.s3_49, s8_1208, s8_1246);
  const double s8_1248 = fma(work.s8_610, s8_1200, fms(projection.Rz[40], s8_1196, work.s8_612));
  work.s8_1249 = fnma(work.s3_52, s8_1208, s8_1248);
  const double s8_1250 = fma(work.s8_616, s8_1200, fms(projection.Rz[41], s8_1196, work.s8_618));
  work.s8_1251 = fnma(work.s3_55, s8_1208, s8_1250);
  const double s8_1252 = work.s8_806 + (work.s8_697 + work.s8_775);
  const double s8_1253 = work.s8_911 + fnma(projection.Rz[14], work.s7_106, s8_1252);
  const double s8_1254 = fnma(projection.Rz[17], work.s7_115, projection.Rz[35]*work.s7_201);
  const double s8_1255 = fnma(p_bell_crank_x, work.s8_638, work.s8_635 + s8_1254);
  const double s8_1256 = fma(p_pitman_arm_y, work.s8_655, s8_1255);
  const double s8_1257 = work.s8_784 + fnma(work.r_carrier_right_aux1_y, work.s8_763, s8_1256);
  const double s8_1258 = work.s8_922 + fnma(work.r_carrier_left_aux1_y, work.s8_897, s8_1257);
  const double s8_1259 = fma(work.s8_985, work.s8_1001, fma(work.s8_978, work.s8_986, s8_1258));
  const double s8_1260 = fma(work.s8_1043, work.s8_1046, s8_1259);
  const double s8_1261 = fnma(work.s8_1048, work.s8_1062, s8_1260);
  const double s8_1262 = fnma(work.s8_1098, work.s8_1104, s8_1261);
  const double s8_1263 = fma(work.s8_1100, work.s8_1107, s8_1262);
  const double s8_1264 = fnma(work.s8_1162, work.s8_1165, s8_1263);
  const double s8_1265 = fnma(work.s8_1166, work.s8_1174, s8_1264);
  const double s8_1266 = fnma(work.s8_1216, work.s8_1223, s8_1265);
  const double s8_1267 = fnma(projection.Rz[2], work.s7_56, s8_1253);
  const double s8_1268 = fnma(work.s8_1215, work.s8_1251, s8_1266);
  const double s8_1269 = fnma(projection.Rz[17], work.s7_117, work.s8_678);
  const double s8_1270 = fma(p_lower_arm_left_x, s8_1267, s8_1268);
  work.s8_1271 = fnma(p_arb_front_right_y, s8_1269, s8_1270);
  const double s8_1272 = fnma(projection.Rz[32], work.s7_184, work.s8_654);
  const double s8_1273 = fnma(projection.Rz[17], work.s7_119, work.s8_701);
  const double s8_1274 = fnma(projection.Rz[35], work.s7_199, s8_1273);
  const double s8_1275 = fma(p_bell_crank_z, work.s8_638, s8_1274);
  const double s8_1276 = fma(work.r_carrier_right_aux1_y, work.s8_769, s8_1275);
  const double s8_1277 = work.s8_809 + (work.s8_799 + fma(work.s1_33, work.s8_775, s8_1276));
  const double s8_1278 = fma(work.r_carrier_left_aux1_y, work.s8_905, work.s8_839 + s8_1277);
  const double s8_1279 = work.s8_937 + fnma(work.r_carrier_left_aux1_z, work.s8_911, s8_1278);
  const double s8_1280 = fnma(work.s8_978, work.s8_987, s8_950 + s8_1279);
  const double s8_1281 = fnma(work.s8_1043, work.s8_1047, fma(work.s8_985, work.s8_995, s8_1280));
  const double s8_1282 = fnma(work.s8_1048, work.s8_1056, s8_1281);
  const double s8_1283 = fnma(work.s8_1095, work.s8_1100, s8_1282);
  const double s8_1284 = fma(work.s8_1098, work.s8_1103, s8_1283);
  const double s8_1285 = fma(work.s8_1154, work.s8_1165, s8_1284);
  const double s8_1286 = fma(work.s8_1174, work.s8_1175, s8_1285);
  const double s8_1287 = fnma(work.s8_1213, work.s8_1216, s8_1286);
  const double s8_1288 = fma(projection.Rz[14], work.s7_104, s8_1272);
  const double s8_1289 = fma(0.5, s8_1288, fnma(work.s8_1217, work.s8_1251, s8_1287));
  const double s8_1290 = fms(projection.Rz[2], work.s7_54, work.s8_803);
  const double s8_1291 = fnma(projection.Rz[2], work.s7_56, work.s8_806);
  const double s8_1292 = fma(p_lower_arm_left_y, s8_1290, s8_1289);
  const double s8_1293 = fnma(projection.Rz[14], work.s7_106, work.s8_697);
  const double s8_1294 = fnma(p_lower_arm_left_z, s8_1291, s8_1292);
  const double s8_1295 = fnma(projection.Rz[17], work.s7_121, work.s8_675);
  const double s8_1296 = fnma(p_upper_arm_right_z, s8_1293, s8_1294);
  work.s8_1297 = fnma(p_arb_front_right_y, s8_1295, s8_1296);
  const double s8_1298 = s8_1197 - work.s4_48 - s8_1244;
  const double s8_1299 = fma(work.s8_991, work.s8_991, work.s8_976*work.s8_976);
  const double s8_1300 = fma(work.s8_1041, work.s8_1041, fma(work.s8_997, work.s8_997, s8_1299));
  const double s8_1301 = fma(work.s8_1052, work.s8_1052, s8_1300);
  const double s8_1302 = fma(work.s8_1158, work.s8_1158, work.s8_1152*work.s8_1152);
  const double s8_1303 = fma(work.s8_1170, work.s8_1170, s8_1302);
  const double s8_1304 = fma(work.s8_1211, work.s8_1211, s8_1303);
  const double s8_1305 = fma(work.s8_1219, work.s8_1219, s8_1304);
  const double s8_1306 = fma(projection.Rz[36], work.s8_661, projection.Rz[39]*work.s8_633);
  const double s8_1307 = fma(projection.Rz[33], work.s8_683, s8_1306);
  const double s8_1308 = fma(projection.Rz[30], work.s8_699, s8_1307);
  const double s8_1309 = fma(work.s8_606, work.s8_771, fma(work.s8_605, work.s8_765, s8_1308));
  const double s8_1310 = fma(work.s3_58, work.s8_786, fma(work.s3_49, work.s8_780, s8_1309));
  const double s8_1311 = fma(work.s8_604, work.s8_793, s8_1310);
  const double s8_1312 = fma(projection.Rz[18], work.s8_807, s8_1311);
  const double s8_1313 = fma(projection.Rz[15], work.s8_824, s8_1312);
  const double s8_1314 = fma(projection.Rz[12], work.s8_837, s8_1313);
  const double s8_1315 = fnma(work.s8_603, work.s8_907, fma(work.s8_602, work.s8_901, s8_1314));
  const double s8_1316 = fma(work.s3_40, work.s8_924, fma(work.s3_31, work.s8_918, s8_1315));
  const double s8_1317 = fma(work.s8_601, work.s8_931, s8_1316);
  const double s8_1318 = fnma(1.5, s8_1109, fma(projection.Rz[0], work.s8_948, s8_1317));
  const double s8_1319 = fma(work.s8_1058, work.s8_1058, s8_1301);
  const double s8_1320 = fnma(0.3333333333333333, s8_1319, s8_1318);
  const double s8_1321 = fma(work.s8_1247, work.s8_1247, s8_1305);
  work.s8_1322 = fnma(1.1666666666666667, s8_1321, s8_1320);
  const double s8_1323 = fma(work.s8_991, work.s8_995, work.s8_976*work.s8_978);
  const double s8_1324 = fma(work.s8_1041, work.s8_1043, fma(work.s8_997, work.s8_1001, s8_1323));
  const double s8_1325 = fma(work.s8_1052, work.s8_1056, s8_1324);
  const double s8_1326 = fma(work.s8_1158, work.s8_1162, work.s8_1152*work.s8_1154);
  const double s8_1327 = fma(work.s8_1170, work.s8_1174, s8_1326);
  const double s8_1328 = fma(work.s8_1211, work.s8_1213, s8_1327);
  const double s8_1329 = fma(work.s8_1219, work.s8_1223, s8_1328);
  const double s8_1330 = fma(projection.Rz[36], work.s8_663, projection.Rz[39]*work.s8_635);
  const double s8_1331 = fma(projection.Rz[33], work.s8_685, s8_1330);
  const double s8_1332 = fma(projection.Rz[30], work.s8_701, s8_1331);
  const double s8_1333 = fma(work.s8_606, work.s8_775, fma(work.s8_605, work.s8_769, s8_1332));
  const double s8_1334 = fma(work.s3_58, work.s8_790, fma(work.s3_49, work.s8_784, s8_1333));
  const double s8_1335 = fma(work.s8_604, work.s8_799, s8_1334);
  const double s8_1336 = fma(projection.Rz[18], work.s8_809, s8_1335);
  const double s8_1337 = fma(projection.Rz[15], work.s8_826, s8_1336);
  const double s8_1338 = fma(projection.Rz[12], work.s8_839, s8_1337);
  const double s8_1339 = fnma(work.s8_603, work.s8_911, fma(work.s8_602, work.s8_905, s8_1338));
  const double s8_1340 = fma(work.s3_40, work.s8_928, fma(work.s3_31, work.s8_922, s8_1339));
  const double s8_1341 = fma(projection.Rz[0], s8_950, fma(work.s8_601, work.s8_937, s8_1340));
  const double s8_1342 = fma(work.s8_1058, work.s8_1062, s8_1325);
  const double s8_1343 = fnma(0.3333333333333333, s8_1342, fnma(1.5, s8_1113, s8_1341));
  const double s8_1344 = fma(work.s8_1247, work.s8_1251, s8_1329);
  work.s8_1345 = fnma(1.1666666666666667, s8_1344, s8_1343);
  const double s8_1346 = fma(work.s8_993, work.s8_993, work.s8_977*work.s8_977);
  const double s8_1347 = fma(work.s8_1042, work.s8_1042, fma(work.s8_999, work.s8_999, s8_1346));
  const double s8_1348 = fma(work.s8_1054, work.s8_1054, s8_1347);
  const double s8_1349 = fma(work.s8_1160, work.s8_1160, work.s8_1153*work.s8_1153);
  const double s8_1350 = fma(work.s8_1172, work.s8_1172, s8_1349);
  const double s8_1351 = fma(work.s8_1212, work.s8_1212, s8_1350);
  const double s8_1352 = fma(work.s8_1221, work.s8_1221, s8_1351);
  const double s8_1353 = fma(projection.Rz[37], work.s8_662, projection.Rz[40]*work.s8_634);
  const double s8_1354 = fma(projection.Rz[34], work.s8_684, s8_1353);
  const double s8_1355 = fma(projection.Rz[31], work.s8_700, s8_1354);
  const double s8_1356 = fma(work.s8_612, work.s8_773, fma(work.s8_611, work.s8_767, s8_1355));
  const double s8_1357 = fma(work.s3_61, work.s8_788, fma(work.s3_52, work.s8_782, s8_1356));
  const double s8_1358 = fma(work.s8_610, work.s8_796, s8_1357);
  const double s8_1359 = fma(projection.Rz[19], work.s8_808, s8_1358);
  const double s8_1360 = fma(projection.Rz[16], work.s8_825, s8_1359);
  const double s8_1361 = fma(projection.Rz[13], work.s8_838, s8_1360);
  const double s8_1362 = fnma(work.s8_609, work.s8_909, fma(work.s8_608, work.s8_903, s8_1361));
  const double s8_1363 = fma(work.s3_43, work.s8_926, fma(work.s3_34, work.s8_920, s8_1362));
  const double s8_1364 = fma(work.s8_607, work.s8_934, s8_1363);
  const double s8_1365 = fnma(1.5, s8_1115, fma(projection.Rz[1], work.s8_949, s8_1364));
  const double s8_1366 = fma(work.s8_1060, work.s8_1060, s8_1348);
  const double s8_1367 = fnma(0.3333333333333333, s8_1366, s8_1365);
  const double s8_1368 = fma(work.s8_1249, work.s8_1249, s8_1352);
  work.s8_1369 = fnma(1.1666666666666667, s8_1368, s8_1367);
  const double s8_1370 = fma(work.s8_993, work.s8_995, work.s8_977*work.s8_978);
  const double s8_1371 = fma(work.s8_1042, work.s8_1043, fma(work.s8_999, work.s8_1001, s8_1370));
  const double s8_1372 = fma(work.s8_1054, work.s8_1056, s8_1371);
  const double s8_1373 = fma(work.s8_1160, work.s8_1162, work.s8_1153*work.s8_1154);
  const double s8_1374 = fma(work.s8_1172, work.s8_1174, s8_1373);
  const double s8_1375 = fma(work.s8_1212, work.s8_1213, s8_1374);
  const double s8_1376 = fma(work.s8_1221, work.s8_1223, s8_1375);
  const double s8_1377 = fma(projection.Rz[37], work.s8_663, projection.Rz[40]*work.s8_635);
  const double s8_1378 = fma(projection.Rz[34], work.s8_685, s8_1377);
  const double s8_1379 = fma(projection.Rz[31], work.s8_701, s8_1378);
  const double s8_1380 = fma(work.s8_612, work.s8_775, fma(work.s8_611, work.s8_769, s8_1379));
  const double s8_1381 = fma(work.s3_61, work.s8_790, fma(work.s3_52, work.s8_784, s8_1380));
  const double s8_1382 = fma(work.s8_610, work.s8_799, s8_1381);
  const double s8_1383 = fma(projection.Rz[19], work.s8_809, s8_1382);
  const double s8_1384 = fma(projection.Rz[16], work.s8_826, s8_1383);
  const double s8_1385 = fma(projection.Rz[13], work.s8_839, s8_1384);
  const double s8_1386 = fnma(work.s8_609, work.s8_911, fma(work.s8_608, work.s8_905, s8_1385));
  const double s8_1387 = fma(work.s3_43, work.s8_928, fma(work.s3_34, work.s8_922, s8_1386));
  const double s8_1388 = fma(projection.Rz[1], s8_950, fma(work.s8_607, work.s8_937, s8_1387));
  const double s8_1389 = fma(work.s8_1060, work.s8_1062, s8_1372);
  const double s8_1390 = fnma(0.3333333333333333, s8_1389, fnma(1.5, s8_1117, s8_1388));
  const double s8_1391 = fma(work.s8_1249, work.s8_1251, s8_1376);
  work.s8_1392 = fnma(1.1666666666666667, s8_1391, s8_1390);
  const double s8_1393 = fma(work.s8_995, work.s8_995, work.s8_978*work.s8_978);
  const double s8_1394 = fma(work.s8_1001, work.s8_1001, s8_1393);
  const double s8_1395 = fma(work.s8_1043, work.s8_1043, s8_1394);
  const double s8_1396 = fma(work.s8_1056, work.s8_1056, s8_1395);
  const double s8_1397 = fma(work.s8_1162, work.s8_1162, work.s8_1154*work.s8_1154);
  const double s8_1398 = fma(work.s8_1174, work.s8_1174, s8_1397);
  const double s8_1399 = fma(work.s8_1213, work.s8_1213, s8_1398);
  const double s8_1400 = fma(work.s8_1223, work.s8_1223, s8_1399);
  const double s8_1401 = fma(projection.Rz[38], work.s8_663, projection.Rz[41]*work.s8_635);
  const double s8_1402 = fma(projection.Rz[35], work.s8_685, s8_1401);
  const double s8_1403 = fma(projection.Rz[32], work.s8_701, s8_1402);
  const double s8_1404 = fma(work.s8_618, work.s8_775, fma(work.s8_617, work.s8_769, s8_1403));
  const double s8_1405 = fma(work.s3_64, work.s8_790, fma(work.s3_55, work.s8_784, s8_1404));
  const double s8_1406 = fma(work.s8_616, work.s8_799, s8_1405);
  const double s8_1407 = fma(projection.Rz[20], work.s8_809, s8_1406);
  const double s8_1408 = fma(projection.Rz[17], work.s8_826, s8_1407);
  const double s8_1409 = fma(projection.Rz[14], work.s8_839, s8_1408);
  const double s8_1410 = fnma(work.s8_615, work.s8_911, fma(work.s8_614, work.s8_905, s8_1409));
  const double s8_1411 = fma(work.s3_46, work.s8_928, fma(work.s3_37, work.s8_922, s8_1410));
  const double s8_1412 = fma(projection.Rz[2], s8_950, fma(work.s8_613, work.s8_937, s8_1411));
  const double s8_1413 = fma(work.s8_1062, work.s8_1062, s8_1396);
  const double s8_1414 = fnma(0.3333333333333333, s8_1413, fnma(1.5, s8_1119, s8_1412));
  const double s8_1415 = fma(work.s8_1251, work.s8_1251, s8_1400);
  work.s8_1416 = fnma(1.1666666666666667, s8_1415, s8_1414);
  const double s8_1417 = s8_1195 - s8_1245;
  const double s8_1418 = fms(work.s8_20, work.s8_1201, work.s6_17);
  const double s8_1419 = fnma(work.s1_30, projection.zdd_star[6], s8_1418);
  const double s8_1420 = fnma(work.s8_16, work.s8_1205, fnma(work.s8_628, s8_1204, s8_1419));
  const double s8_1421 = fma(work.s8_17, work.s8_1214, fma(work.s6_39, s8_1208, s8_1420));
  const double s8_1422 = fma(work.s4_35, s8_1245, fnma(work.s4_46, s8_1244, s8_1421));
  const double s8_1423 = fnma(work.s8_12, s8_1417, fma(work.s8_13, s8_1298, s8_1422));
  work.s8_1424 = 1.1666666666666667*s8_1423;
  const double s8_1425 = fnma(zd_bell_crank, s8_1197, projection.zdd_star[13]*s8_1194);
  const double s8_1426 = fnma(work.s8_17, work.s8_1201, fnma(work.s6_39, s8_1200, s8_1425));
  const double s8_1427 = fnma(work.s8_15, work.s8_1205, fma(work.s6_29, s8_1204, s8_1426));
  const double s8_1428 = fnma(work.s8_12, s8_1210, fnma(work.s4_35, s8_1209, s8_1427));
  const double s8_1429 = fma(work.s4_33, s8_1244, fnma(work.s8_21, work.s8_1214, s8_1428));
  work.s8_1430 = 1.1666666666666667*fnma(work.s8_14, s8_1298, s8_1429);
  const double s8_1431 = fma(zd_bell_crank, s8_1195, s8_1065);
  const double s8_1432 = fma(projection.zdd_star[13], s8_1196, s8_1431);
  const double s8_1433 = fnma(work.s8_16, work.s8_1201, fma(work.s8_628, s8_1200, s8_1432));
  const double s8_1434 = fnma(work.s6_29, s8_1208, fma(work.s8_22, work.s8_1205, s8_1433));
  const double s8_1435 = fma(work.s8_13, s8_1210, fma(work.s4_46, s8_1209, s8_1434));
  const double s8_1436 = fnma(work.s4_33, s8_1245, fma(work.s8_15, work.s8_1214, s8_1435));
  work.s8_1437 = 1.1666666666666667*fma(work.s8_14, s8_1417, s8_1436);
  const double s8_1438 = fnma(work.s8_42, work.s7_61, tau[Coordinate::lower_arm_left]);
  const double s8_1439 = fma(work.s7_56, s8_960, fnma(work.s7_54, s8_958, s8_1438));
  const double s8_1440 = fnma(1.825625, projection.zdd_star[0], s8_1439);
  work.s8_1441 = fnma(work.s8_16, s8_961, s8_1440);
  const double s8_1442 = fnma(work.s8_42, work.s7_111, tau[Coordinate::upper_arm_left]);
  const double s8_1443 = fma(work.s7_106, work.s8_849, fnma(work.s7_104, work.s8_847, s8_1442));
  const double s8_1444 = fnma(0.539, projection.zdd_star[4], s8_1443);
  work.s8_1445 = fnma(work.s8_16, work.s8_850, s8_1444);
  const double s8_1446 = fnma(work.s8_15, work.s7_115, tau[Coordinate::arb_front_left]);
  const double s8_1447 = fnma(work.s8_43, work.s7_126, fma(work.s8_16, work.s7_119, s8_1446));
  const double s8_1448 = fma(work.s7_121, work.s8_835, fnma(work.s7_117, work.s8_833, s8_1447));
  const double s8_1449 = fnma(0.3477, projection.zdd_star[5], s8_1448);
  work.s8_1450 = fnma(work.s8_17, work.s8_836, s8_1449);
  const double s8_1451 = fnma(work.s8_42, work.s7_137, tau[Coordinate::lower_arm_right]);
  const double s8_1452 = fnma(work.s7_130, work.s8_821, fnma(work.s7_132, work.s8_819, s8_1451));
  const double s8_1453 = fnma(1.825625, projection.zdd_star[6], s8_1452);
  work.s8_1454 = fnma(work.s8_16, work.s8_822, s8_1453);
  const double s8_1455 = fnma(work.s8_42, work.s7_191, tau[Coordinate::upper_arm_right]);
  const double s8_1456 = fnma(work.s7_184, work.s8_714, fnma(work.s7_186, work.s8_711, s8_1455));
  const double s8_1457 = fnma(0.539, projection.zdd_star[10], s8_1456);
  work.s8_1458 = fnma(work.s8_16, work.s8_715, s8_1457);
  const double s8_1459 = fma(work.s8_16, work.s7_199, tau[Coordinate::arb_front_right]);
  const double s8_1460 = fnma(work.s8_43, work.s7_206, fma(work.s8_15, work.s7_201, s8_1459));
  const double s8_1461 = fma(work.s7_197, work.s8_693, fma(work.s7_195, work.s8_688, s8_1460));
  const double s8_1462 = fnma(0.3477, projection.zdd_star[11], s8_1461);
  work.s8_1463 = fnma(work.s8_17, work.s8_694, s8_1462);
  const double s8_1464 = fnma(work.s8_43, work.s7_213, tau[Coordinate::pitman_arm]);
  const double s8_1465 = fma(work.s7_210, work.s8_671, fnma(work.s7_209, work.s8_669, s8_1464));
  const double s8_1466 = fnma(0.3504, projection.zdd_star[12], s8_1465);
  work.s8_1467 = fnma(work.s8_17, work.s8_672, s8_1466);
  const double s8_1468 = fnma(work.s8_32, work.s7_222, tau[Coordinate::bell_crank]);
  const double s8_1469 = fma(work.s7_219, work.s8_645, fnma(work.s7_216, work.s8_641, s8_1468));
  const double s8_1470 = fnma(0.9515, projection.zdd_star[13], s8_1469);
  work.s8_1471 = fnma(work.s8_15, work.s8_649, s8_1470);
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double s8_1472 = work.R_carrier_left_aux1_z_x*tau_carrier_left_rx;
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double s8_1473 = fma(tau_carrier_left_rz, work.s1_69, s8_1472);
  work.s8_1474 = fnma(tau_carrier_left_ry, work.s1_76, s8_1473) - work.n_carrier_left_z;
  const double s8_1475 = work.R_carrier_left_aux1_y_x*tau_carrier_left_rx;
  const double s8_1476 = fma(tau_carrier_left_ry, work.s1_68, s8_1475);
  work.s8_1477 = fnma(tau_carrier_left_rz, work.s1_77, s8_1476) - work.n_carrier_left_y;
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s8_1478 = work.R_carrier_right_aux1_z_x*tau_carrier_right_rx;
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double s8_1479 = fma(tau_carrier_right_rz, work.s1_85, s8_1478);
  work.s8_1480 = fnma(tau_carrier_right_ry, work.s1_92, s8_1479) - work.n_carrier_right_z;
  const double s8_1481 = work.R_carrier_right_aux1_y_x*tau_carrier_right_rx;
  const double s8_1482 = fma(tau_carrier_right_ry, work.s1_84, s8_1481);
  work.s8_1483 = fnma(tau_carrier_right_rz, work.s1_93, s8_1482) - work.n_carrier_right_y;
  const double s8_1484 = fma(work.s7_6, work.s3_28, work.s7_3*work.s3_22);
  const double s8_1485 = fnma(work.s8_618, work.f_carrier_right_y, s8_1484);
  const double s8_1486 = fnma(work.s8_617, work.f_carrier_right_z, s8_1485);
  const double s8_1487 = fnma(work.s8_616, work.n_carrier_right_x, s8_1486);
  work.s8_1488 = fma(work.s8_615, work.f_carrier_left_y, s8_1487);
}

/// Part 5 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63).
[[gnu::noinline]] void compute_chosen_accelerations_5(const State& state,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_1489 = fnma(work.s8_614, work.f_carrier_left_z, work.s8_1488);
  const double s8_1490 = fnma(work.s8_613, work.n_carrier_left_x, s8_1489);
  const double s8_1491 = fma(work.s8_1001, work.s8_1009, s8_1490);
  const double s8_1492 = fnma(work.s8_978, work.s8_1015, s8_1491);
  const double s8_1493 = fnma(work.s8_995, work.s8_1022, s8_1492);
  const double s8_1494 = fnma(work.s8_1043, work.s8_1070, s8_1493);
  const double s8_1495 = fma(work.s8_1062, work.s8_1076, s8_1494);
  const double s8_1496 = fnma(work.s8_1056, work.s8_1084, s8_1495);
  const double s8_1497 = fma(work.s8_1107, work.s8_1124, s8_1496);
  const double s8_1498 = fma(work.s8_1095, work.s8_1129, s8_1497);
  const double s8_1499 = fma(work.s8_1098, work.s8_1133, s8_1498);
  const double s8_1500 = fnma(work.s8_1154, work.s8_1180, s8_1499);
  const double s8_1501 = fnma(work.s8_1162, work.s8_1186, s8_1500);
  const double s8_1502 = fnma(work.s8_1174, work.s8_1193, s8_1501);
  const double s8_1503 = fnma(work.s8_1213, work.s8_1424, s8_1502);
  const double s8_1504 = fma(work.s8_1223, work.s8_1430, s8_1503);
  const double s8_1505 = fma(work.s8_1251, work.s8_1437, s8_1504);
  const double s8_1506 = fma(projection.Rz[2], work.s8_1441, s8_1505);
  const double s8_1507 = fma(projection.Rz[14], work.s8_1445, s8_1506);
  const double s8_1508 = fma(projection.Rz[17], work.s8_1450, s8_1507);
  const double s8_1509 = fma(projection.Rz[20], work.s8_1454, s8_1508);
  const double s8_1510 = fma(projection.Rz[32], work.s8_1458, s8_1509);
  const double s8_1511 = fma(projection.Rz[35], work.s8_1463, s8_1510);
  const double s8_1512 = fma(projection.Rz[38], work.s8_1467, s8_1511);
  const double s8_1513 = fma(projection.Rz[41], work.s8_1471, s8_1512);
  const double s8_1514 = fma(work.s3_46, work.s8_1477, fma(work.s3_37, work.s8_1474, s8_1513));
  work.s8_1515 = fma(work.s3_64, work.s8_1483, fma(work.s3_55, work.s8_1480, s8_1514));
  const double s8_1516 = work.s7_199 + (work.s7_119 + (11.55 + work.s7_35 - work.s7_47));
  const double s8_1517 = work.s7_222 + fma(p_bell_crank_x, work.s7_216, s8_1516);
  const double s8_1518 = work.s8_952 + (work.s8_841 + (work.s8_703 + work.s8_815));
  const double s8_1519 = fma(p_pitman_arm_y, work.s8_665, s8_1517);
  const double s8_1520 = fma(p_lower_arm_left_x, s8_1518, s8_1519);
  const double s8_1521 = fnma(p_arb_front_right_y, work.s8_828 - work.s8_689, s8_1520);
  work.s8_1522 = fnma(p_arb_rear_right_y, work.s8_49 - work.s8_33, s8_1521);
  const double s8_1523 = work.s7_111 + (work.s7_61 + (work.s7_44 - 1.05 - work.s7_37));
  const double s8_1524 = work.s7_191 + (work.s7_137 + (work.s7_115 + s8_1523)) - work.s7_201;
  const double s8_1525 = work.s8_843 + (work.s8_698 - work.s8_658);
  const double s8_1526 = fma(0.5, s8_1525, fma(p_bell_crank_z, work.s7_216, s8_1524));
  const double s8_1527 = fma(p_lower_arm_left_y, work.s8_811 + work.s8_954, s8_1526);
  const double s8_1528 = fma(p_lower_arm_left_z, work.s8_815 + work.s8_952, s8_1527);
  const double s8_1529 = fma(p_upper_arm_right_z, work.s8_703 + work.s8_841, s8_1528);
  const double s8_1530 = fnma(p_arb_front_right_y, work.s8_823 - work.s8_681, s8_1529);
  work.s8_1531 = fnma(p_arb_rear_right_y, work.s8_30 - work.s8_45, s8_1530);
  result.inertia[8] = work.s8_1416 - 1.5272999999999997e-20;
  work.s8_1532 = 1.0/work.s8_1416;
  const double s8_1533 = work.s8_1392*work.s8_1532;
  const double s8_1534 = fnma(work.s8_1392, s8_1533, work.s8_1369);
  result.inertia[7] = fnma(1e-12, work.s8_1369, s8_1534 - 1.5272999999999997e-20);
  const double s8_1535 = work.s8_1345*work.s8_1532;
  const double s8_1536 = fma(work.s8_991, work.s8_993, work.s8_976*work.s8_977);
  const double s8_1537 = fma(work.s8_1041, work.s8_1042, fma(work.s8_997, work.s8_999, s8_1536));
  const double s8_1538 = fma(work.s8_1052, work.s8_1054, s8_1537);
  const double s8_1539 = fma(work.s8_1158, work.s8_1160, work.s8_1152*work.s8_1153);
  const double s8_1540 = fma(work.s8_1170, work.s8_1172, s8_1539);
  const double s8_1541 = fma(work.s8_1211, work.s8_1212, s8_1540);
  const double s8_1542 = fma(work.s8_1219, work.s8_1221, s8_1541);
  const double s8_1543 = fma(projection.Rz[36], work.s8_662, projection.Rz[39]*work.s8_634);
  const double s8_1544 = fma(projection.Rz[33], work.s8_684, s8_1543);
  const double s8_1545 = fma(projection.Rz[30], work.s8_700, s8_1544);
  const double s8_1546 = fma(work.s8_606, work.s8_773, fma(work.s8_605, work.s8_767, s8_1545));
  const double s8_1547 = fma(work.s3_58, work.s8_788, fma(work.s3_49, work.s8_782, s8_1546));
  const double s8_1548 = fma(work.s8_604, work.s8_796, s8_1547);
  const double s8_1549 = fma(projection.Rz[18], work.s8_808, s8_1548);
  const double s8_1550 = fma(projection.Rz[15], work.s8_825, s8_1549);
  const double s8_1551 = fma(projection.Rz[12], work.s8_838, s8_1550);
  const double s8_1552 = fnma(work.s8_603, work.s8_909, fma(work.s8_602, work.s8_903, s8_1551));
  const double s8_1553 = fma(work.s3_40, work.s8_926, fma(work.s3_31, work.s8_920, s8_1552));
  const double s8_1554 = fma(work.s8_601, work.s8_934, s8_1553);
  const double s8_1555 = fnma(1.5, work.s8_1111, fma(projection.Rz[0], work.s8_949, s8_1554));
  const double s8_1556 = fma(work.s8_1058, work.s8_1060, s8_1538);
  const double s8_1557 = fnma(0.3333333333333333, s8_1556, fnma(work.s8_1345, s8_1533, s8_1555));
  const double s8_1558 = fma(work.s8_1247, work.s8_1249, s8_1542);
  work.s8_1559 = fnma(1.1666666666666667, s8_1558, s8_1557);
  work.s8_1560 = 1.0/s8_1534;
  const double s8_1561 = work.s8_1559*work.s8_1560;
  const double s8_1562 = fnma(work.s8_1559, s8_1561, fnma(work.s8_1345, s8_1535, work.s8_1322));
  result.inertia[6] = fnma(1e-12, work.s8_1322, s8_1562 - 1.5272999999999997e-20);
  const double s8_1563 = work.s8_762 + (work.s8_677 - work.s8_631 - work.s8_653);
  const double s8_1564 = work.s8_896 + fma(projection.Rz[16], work.s7_117, s8_1563);
  work.s8_1565 = fnma(work.s8_899, s8_1533, s8_1564);
  const double s8_1566 = work.s8_761 + (work.s8_676 - work.s8_630 - work.s8_651);
  const double s8_1567 = work.s8_895 + fma(projection.Rz[15], work.s7_117, s8_1566);
  work.s8_1568 = fnma(s8_1561, work.s8_1565, fnma(work.s8_899, s8_1535, s8_1567));
  work.s8_1569 = 1.0/s8_1562;
  work.s8_1570 = work.s8_1568*work.s8_1569;
  const double s8_1571 = fma(projection.Rz[31], work.s7_184, work.s8_652 - work.s8_674);
  const double s8_1572 = work.s8_802 + (work.s8_767 + s8_1571);
  const double s8_1573 = fnma(projection.Rz[16], work.s7_121, s8_1572);
  const double s8_1574 = work.s8_903 + fma(projection.Rz[13], work.s7_104, s8_1573);
  work.s8_1575 = fnma(work.s8_944, s8_1533, fma(projection.Rz[1], work.s7_54, s8_1574));
  const double s8_1576 = fma(projection.Rz[30], work.s7_184, work.s8_650 - work.s8_673);
  const double s8_1577 = work.s8_801 + (work.s8_765 + s8_1576);
  const double s8_1578 = fnma(projection.Rz[15], work.s7_121, s8_1577);
  const double s8_1579 = work.s8_901 + fma(projection.Rz[12], work.s7_104, s8_1578);
  const double s8_1580 = fnma(work.s8_944, s8_1535, fma(projection.Rz[0], work.s7_54, s8_1579));
  work.s8_1581 = fnma(s8_1561, work.s8_1575, s8_1580);
  work.s8_1582 = work.s8_1569*work.s8_1581;
  const double s8_1583 = work.s8_805 + (work.s8_773 + (work.s8_696 - work.s8_637));
  const double s8_1584 = work.s8_909 + fnma(projection.Rz[13], work.s7_106, s8_1583);
  work.s8_1585 = fnma(work.s8_947, s8_1533, fnma(projection.Rz[1], work.s7_56, s8_1584));
  const double s8_1586 = work.s8_804 + (work.s8_771 + (work.s8_695 - work.s8_636));
  const double s8_1587 = work.s8_907 + fnma(projection.Rz[12], work.s7_106, s8_1586);
  const double s8_1588 = fnma(work.s8_947, s8_1535, fnma(projection.Rz[0], work.s7_56, s8_1587));
  work.s8_1589 = fnma(s8_1561, work.s8_1585, s8_1588);
  work.s8_1590 = work.s8_1569*work.s8_1589;
  const double s8_1591 = work.s8_802 + fma(projection.Rz[31], work.s7_184, work.s8_767);
  const double s8_1592 = work.s8_903 + fma(projection.Rz[13], work.s7_104, s8_1591);
  const double s8_1593 = fnma(p_pitman_arm_x, work.s8_652, -p_bell_crank_z*work.s8_631);
  const double s8_1594 = work.s8_684 + (work.s8_662 + fnma(p_pitman_arm_z, work.s8_653, s8_1593));
  const double s8_1595 = work.s8_825 + (work.s8_788 + fnma(work.s1_33, work.s8_762, s8_1594));
  const double s8_1596 = work.s8_926 + fma(work.r_carrier_left_aux1_z, work.s8_896, s8_1595);
  const double s8_1597 = fnma(work.s8_987, work.s8_999, fnma(work.s8_986, work.s8_993, s8_1596));
  const double s8_1598 = fnma(work.s8_1046, work.s8_1054, s8_1597);
  const double s8_1599 = fnma(work.s8_1047, work.s8_1060, s8_1598);
  const double s8_1600 = fma(work.s8_1094, work.s8_1104, s8_1599);
  const double s8_1601 = fnma(work.s8_1103, work.s8_1106, s8_1600);
  const double s8_1602 = fma(work.s8_1153, work.s8_1166, s8_1601);
  const double s8_1603 = fnma(work.s8_1160, work.s8_1175, s8_1602);
  const double s8_1604 = fnma(work.s8_1212, work.s8_1215, s8_1603);
  const double s8_1605 = fnma(work.s8_1243, s8_1533, fma(work.s8_1217, work.s8_1221, s8_1604));
  const double s8_1606 = fma(projection.Rz[1], work.s7_54, s8_1592);
  const double s8_1607 = fma(projection.Rz[16], work.s7_117, work.s8_677);
  const double s8_1608 = fnma(0.5, s8_1607, fnma(p_lower_arm_left_x, s8_1606, s8_1605));
  const double s8_1609 = fma(projection.Rz[16], work.s7_121, work.s8_674);
  work.s8_1610 = fma(p_arb_front_right_x, s8_1609, s8_1608);
  const double s8_1611 = work.s8_801 + fma(projection.Rz[30], work.s7_184, work.s8_765);
  const double s8_1612 = work.s8_901 + fma(projection.Rz[12], work.s7_104, s8_1611);
  const double s8_1613 = fnma(p_pitman_arm_x, work.s8_650, -p_bell_crank_z*work.s8_630);
  const double s8_1614 = work.s8_683 + (work.s8_661 + fnma(p_pitman_arm_z, work.s8_651, s8_1613));
  const double s8_1615 = work.s8_824 + (work.s8_786 + fnma(work.s1_33, work.s8_761, s8_1614));
  const double s8_1616 = work.s8_924 + fma(work.r_carrier_left_aux1_z, work.s8_895, s8_1615);
  const double s8_1617 = fnma(work.s8_987, work.s8_997, fnma(work.s8_986, work.s8_991, s8_1616));
  const double s8_1618 = fnma(work.s8_1046, work.s8_1052, s8_1617);
  const double s8_1619 = fnma(work.s8_1047, work.s8_1058, s8_1618);
  const double s8_1620 = fma(work.s8_1093, work.s8_1104, s8_1619);
  const double s8_1621 = fnma(work.s8_1103, work.s8_1105, s8_1620);
  const double s8_1622 = fma(work.s8_1152, work.s8_1166, s8_1621);
  const double s8_1623 = fnma(work.s8_1158, work.s8_1175, s8_1622);
  const double s8_1624 = fnma(work.s8_1211, work.s8_1215, s8_1623);
  const double s8_1625 = fnma(work.s8_1243, s8_1535, fma(work.s8_1217, work.s8_1219, s8_1624));
  const double s8_1626 = fma(projection.Rz[0], work.s7_54, s8_1612);
  const double s8_1627 = fnma(p_lower_arm_left_x, s8_1626, fnma(s8_1561, work.s8_1610, s8_1625));
  const double s8_1628 = fnma(0.5, fma(projection.Rz[15], work.s7_117, work.s8_676), s8_1627);
  const double s8_1629 = fma(projection.Rz[15], work.s7_121, work.s8_673);
  work.s8_1630 = fma(p_arb_front_right_x, s8_1629, s8_1628);
  work.s8_1631 = work.s8_1569*work.s8_1630;
  const double s8_1632 = fnma(projection.Rz[31], work.s7_184, work.s8_652);
  const double s8_1633 = fnma(projection.Rz[16], work.s7_119, work.s8_700);
  const double s8_1634 = fnma(projection.Rz[34], work.s7_199, s8_1633);
  const double s8_1635 = fma(p_bell_crank_z, work.s8_637, s8_1634);
  const double s8_1636 = fma(work.r_carrier_right_aux1_y, work.s8_767, s8_1635);
  const double s8_1637 = work.s8_808 + (work.s8_796 + fma(work.s1_33, work.s8_773, s8_1636));
  const double s8_1638 = fma(work.r_carrier_left_aux1_y, work.s8_903, work.s8_838 + s8_1637);
  const double s8_1639 = work.s8_934 + fnma(work.r_carrier_left_aux1_z, work.s8_909, s8_1638);
  const double s8_1640 = fnma(work.s8_977, work.s8_987, work.s8_949 + s8_1639);
  const double s8_1641 = fnma(work.s8_1042, work.s8_1047, fma(work.s8_985, work.s8_993, s8_1640));
  const double s8_1642 = fnma(work.s8_1048, work.s8_1054, s8_1641);
  const double s8_1643 = fnma(work.s8_1094, work.s8_1100, s8_1642);
  const double s8_1644 = fma(work.s8_1097, work.s8_1103, s8_1643);
  const double s8_1645 = fma(work.s8_1153, work.s8_1165, s8_1644);
  const double s8_1646 = fma(work.s8_1172, work.s8_1175, s8_1645);
  const double s8_1647 = fnma(work.s8_1212, work.s8_1216, s8_1646);
  const double s8_1648 = fnma(work.s8_1297, s8_1533, fnma(work.s8_1217, work.s8_1249, s8_1647));
  const double s8_1649 = fma(0.5, fma(projection.Rz[13], work.s7_104, s8_1632), s8_1648);
  const double s8_1650 = fms(projection.Rz[1], work.s7_54, work.s8_802);
  const double s8_1651 = fnma(projection.Rz[1], work.s7_56, work.s8_805);
  const double s8_1652 = fma(p_lower_arm_left_y, s8_1650, s8_1649);
  const double s8_1653 = fnma(projection.Rz[13], work.s7_106, work.s8_696);
  const double s8_1654 = fnma(p_lower_arm_left_z, s8_1651, s8_1652);
  const double s8_1655 = fnma(projection.Rz[16], work.s7_121, work.s8_674);
  const double s8_1656 = fnma(p_upper_arm_right_z, s8_1653, s8_1654);
  work.s8_1657 = fnma(p_arb_front_right_y, s8_1655, s8_1656);
  const double s8_1658 = fnma(projection.Rz[30], work.s7_184, work.s8_650);
  const double s8_1659 = fnma(projection.Rz[15], work.s7_119, work.s8_699);
  const double s8_1660 = fnma(projection.Rz[33], work.s7_199, s8_1659);
  const double s8_1661 = fma(p_bell_crank_z, work.s8_636, s8_1660);
  const double s8_1662 = fma(work.r_carrier_right_aux1_y, work.s8_765, s8_1661);
  const double s8_1663 = work.s8_807 + (work.s8_793 + fma(work.s1_33, work.s8_771, s8_1662));
  const double s8_1664 = fma(work.r_carrier_left_aux1_y, work.s8_901, work.s8_837 + s8_1663);
  const double s8_1665 = work.s8_931 + fnma(work.r_carrier_left_aux1_z, work.s8_907, s8_1664);
  const double s8_1666 = fnma(work.s8_976, work.s8_987, work.s8_948 + s8_1665);
  const double s8_1667 = fnma(work.s8_1041, work.s8_1047, fma(work.s8_985, work.s8_991, s8_1666));
  const double s8_1668 = fnma(work.s8_1048, work.s8_1052, s8_1667);
  const double s8_1669 = fnma(work.s8_1093, work.s8_1100, s8_1668);
  const double s8_1670 = fma(work.s8_1096, work.s8_1103, s8_1669);
  const double s8_1671 = fma(work.s8_1152, work.s8_1165, s8_1670);
  const double s8_1672 = fma(work.s8_1170, work.s8_1175, s8_1671);
  const double s8_1673 = fnma(work.s8_1211, work.s8_1216, s8_1672);
  const double s8_1674 = fnma(work.s8_1297, s8_1535, fnma(work.s8_1217, work.s8_1247, s8_1673));
  const double s8_1675 = fma(projection.Rz[12], work.s7_104, s8_1658);
  const double s8_1676 = fma(0.5, s8_1675, fnma(s8_1561, work.s8_1657, s8_1674));
  const double s8_1677 = fms(projection.Rz[0], work.s7_54, work.s8_801);
  const double s8_1678 = fnma(projection.Rz[0], work.s7_56, work.s8_804);
  const double s8_1679 = fma(p_lower_arm_left_y, s8_1677, s8_1676);
  const double s8_1680 = fnma(projection.Rz[12], work.s7_106, work.s8_695);
  const double s8_1681 = fnma(p_lower_arm_left_z, s8_1678, s8_1679);
  const double s8_1682 = fnma(projection.Rz[15], work.s7_121, work.s8_673);
  const double s8_1683 = fnma(p_upper_arm_right_z, s8_1680, s8_1681);
  work.s8_1684 = fnma(p_arb_front_right_y, s8_1682, s8_1683);
  work.s8_1685 = work.s8_1569*work.s8_1684;
  const double s8_1686 = work.s8_805 + (work.s8_696 + work.s8_773);
  const double s8_1687 = work.s8_909 + fnma(projection.Rz[13], work.s7_106, s8_1686);
  const double s8_1688 = fnma(projection.Rz[16], work.s7_115, projection.Rz[34]*work.s7_201);
  const double s8_1689 = fnma(p_bell_crank_x, work.s8_637, work.s8_634 + s8_1688);
  const double s8_1690 = fma(p_pitman_arm_y, work.s8_653, s8_1689);
  const double s8_1691 = work.s8_782 + fnma(work.r_carrier_right_aux1_y, work.s8_762, s8_1690);
  const double s8_1692 = work.s8_920 + fnma(work.r_carrier_left_aux1_y, work.s8_896, s8_1691);
  const double s8_1693 = fma(work.s8_985, work.s8_999, fma(work.s8_977, work.s8_986, s8_1692));
  const double s8_1694 = fma(work.s8_1042, work.s8_1046, s8_1693);
  const double s8_1695 = fnma(work.s8_1048, work.s8_1060, s8_1694);
  const double s8_1696 = fnma(work.s8_1097, work.s8_1104, s8_1695);
  const double s8_1697 = fma(work.s8_1100, work.s8_1106, s8_1696);
  const double s8_1698 = fnma(work.s8_1160, work.s8_1165, s8_1697);
  const double s8_1699 = fnma(work.s8_1166, work.s8_1172, s8_1698);
  const double s8_1700 = fnma(work.s8_1216, work.s8_1221, s8_1699);
  const double s8_1701 = fnma(work.s8_1271, s8_1533, fnma(work.s8_1215, work.s8_1249, s8_1700));
  const double s8_1702 = fnma(projection.Rz[1], work.s7_56, s8_1687);
  const double s8_1703 = fnma(projection.Rz[16], work.s7_117, work.s8_677);
  const double s8_1704 = fma(p_lower_arm_left_x, s8_1702, s8_1701);
  work.s8_1705 = fnma(p_arb_front_right_y, s8_1703, s8_1704);
  const double s8_1706 = work.s8_804 + (work.s8_695 + work.s8_771);
  const double s8_1707 = work.s8_907 + fnma(projection.Rz[12], work.s7_106, s8_1706);
  const double s8_1708 = fnma(projection.Rz[15], work.s7_115, projection.Rz[33]*work.s7_201);
  const double s8_1709 = fnma(p_bell_crank_x, work.s8_636, work.s8_633 + s8_1708);
  const double s8_1710 = fma(p_pitman_arm_y, work.s8_651, s8_1709);
  const double s8_1711 = work.s8_780 + fnma(work.r_carrier_right_aux1_y, work.s8_761, s8_1710);
  const double s8_1712 = work.s8_918 + fnma(work.r_carrier_left_aux1_y, work.s8_895, s8_1711);
  const double s8_1713 = fma(work.s8_985, work.s8_997, fma(work.s8_976, work.s8_986, s8_1712));
  const double s8_1714 = fma(work.s8_1041, work.s8_1046, s8_1713);
  const double s8_1715 = fnma(work.s8_1048, work.s8_1058, s8_1714);
  const double s8_1716 = fnma(work.s8_1096, work.s8_1104, s8_1715);
  const double s8_1717 = fma(work.s8_1100, work.s8_1105, s8_1716);
  const double s8_1718 = fnma(work.s8_1158, work.s8_1165, s8_1717);
  const double s8_1719 = fnma(work.s8_1166, work.s8_1170, s8_1718);
  const double s8_1720 = fnma(work.s8_1216, work.s8_1219, s8_1719);
  const double s8_1721 = fnma(work.s8_1271, s8_1535, fnma(work.s8_1215, work.s8_1247, s8_1720));
  const double s8_1722 = fnma(projection.Rz[0], work.s7_56, s8_1707);
  const double s8_1723 = fma(p_lower_arm_left_x, s8_1722, fnma(s8_1561, work.s8_1705, s8_1721));
  const double s8_1724 = fnma(projection.Rz[15], work.s7_117, work.s8_676);
  work.s8_1725 = fnma(p_arb_front_right_y, s8_1724, s8_1723);
  work.s8_1726 = work.s8_1569*work.s8_1725;
  work.s8_1727 = work.s8_1560*work.s8_1565;
  work.s8_1728 = work.s8_1560*work.s8_1575;
  work.s8_1729 = work.s8_1560*work.s8_1585;
  work.s8_1730 = work.s8_1560*work.s8_1610;
  work.s8_1731 = work.s8_1560*work.s8_1657;
  work.s8_1732 = work.s8_1560*work.s8_1705;
  work.s8_1733 = work.s8_899*work.s8_1532;
  work.s8_1734 = work.s8_944*work.s8_1532;
  work.s8_1735 = work.s8_947*work.s8_1532;
  work.s8_1736 = work.s8_1243*work.s8_1532;
  work.s8_1737 = work.s8_1297*work.s8_1532;
  work.s8_1738 = work.s8_1271*work.s8_1532;
  const double s8_1739 = fma(work.s7_6, work.s3_26, work.s7_3*work.s3_20);
  const double s8_1740 = fnma(work.s8_612, work.f_carrier_right_y, s8_1739);
  const double s8_1741 = fnma(work.s8_611, work.f_carrier_right_z, s8_1740);
  const double s8_1742 = fnma(work.s8_610, work.n_carrier_right_x, s8_1741);
  const double s8_1743 = fma(work.s8_609, work.f_carrier_left_y, s8_1742);
  const double s8_1744 = fnma(work.s8_608, work.f_carrier_left_z, s8_1743);
  const double s8_1745 = fnma(work.s8_607, work.n_carrier_left_x, s8_1744);
  const double s8_1746 = fnma(work.s8_977, work.s8_1015, fma(work.s8_999, work.s8_1009, s8_1745));
  const double s8_1747 = fnma(work.s8_993, work.s8_1022, s8_1746);
  const double s8_1748 = fnma(work.s8_1042, work.s8_1070, s8_1747);
  const double s8_1749 = fma(work.s8_1060, work.s8_1076, s8_1748);
  const double s8_1750 = fnma(work.s8_1054, work.s8_1084, s8_1749);
  const double s8_1751 = fma(work.s8_1106, work.s8_1124, s8_1750);
  const double s8_1752 = fma(work.s8_1094, work.s8_1129, s8_1751);
  const double s8_1753 = fma(work.s8_1097, work.s8_1133, s8_1752);
  const double s8_1754 = fnma(work.s8_1153, work.s8_1180, s8_1753);
  const double s8_1755 = fnma(work.s8_1160, work.s8_1186, s8_1754);
  const double s8_1756 = fnma(work.s8_1172, work.s8_1193, s8_1755);
  const double s8_1757 = fnma(work.s8_1212, work.s8_1424, s8_1756);
  const double s8_1758 = fma(work.s8_1221, work.s8_1430, s8_1757);
  const double s8_1759 = fma(work.s8_1249, work.s8_1437, s8_1758);
  const double s8_1760 = fma(projection.Rz[1], work.s8_1441, s8_1759);
  const double s8_1761 = fma(projection.Rz[13], work.s8_1445, s8_1760);
  const double s8_1762 = fma(projection.Rz[16], work.s8_1450, s8_1761);
  const double s8_1763 = fma(projection.Rz[19], work.s8_1454, s8_1762);
  const double s8_1764 = fma(projection.Rz[31], work.s8_1458, s8_1763);
  const double s8_1765 = fma(projection.Rz[34], work.s8_1463, s8_1764);
  const double s8_1766 = fma(projection.Rz[37], work.s8_1467, s8_1765);
  const double s8_1767 = fma(projection.Rz[40], work.s8_1471, s8_1766);
  const double s8_1768 = fma(work.s3_43, work.s8_1477, fma(work.s3_34, work.s8_1474, s8_1767));
  const double s8_1769 = fma(work.s3_61, work.s8_1483, fma(work.s3_52, work.s8_1480, s8_1768));
  work.s8_1770 = fnma(work.s8_1515, s8_1533, s8_1769);
  const double s8_1771 = fma(work.s7_6, work.s3_24, work.s7_3*work.s3_18);
  const double s8_1772 = fnma(work.s8_606, work.f_carrier_right_y, s8_1771);
  const double s8_1773 = fnma(work.s8_605, work.f_carrier_right_z, s8_1772);
  const double s8_1774 = fnma(work.s8_604, work.n_carrier_right_x, s8_1773);
  const double s8_1775 = fma(work.s8_603, work.f_carrier_left_y, s8_1774);
  const double s8_1776 = fnma(work.s8_602, work.f_carrier_left_z, s8_1775);
  const double s8_1777 = fnma(work.s8_601, work.n_carrier_left_x, s8_1776);
  const double s8_1778 = fnma(work.s8_976, work.s8_1015, fma(work.s8_997, work.s8_1009, s8_1777));
  const double s8_1779 = fnma(work.s8_991, work.s8_1022, s8_1778);
  const double s8_1780 = fnma(work.s8_1041, work.s8_1070, s8_1779);
  const double s8_1781 = fma(work.s8_1058, work.s8_1076, s8_1780);
  const double s8_1782 = fnma(work.s8_1052, work.s8_1084, s8_1781);
  const double s8_1783 = fma(work.s8_1105, work.s8_1124, s8_1782);
  const double s8_1784 = fma(work.s8_1093, work.s8_1129, s8_1783);
  const double s8_1785 = fma(work.s8_1096, work.s8_1133, s8_1784);
  const double s8_1786 = fnma(work.s8_1152, work.s8_1180, s8_1785);
  const double s8_1787 = fnma(work.s8_1158, work.s8_1186, s8_1786);
  const double s8_1788 = fnma(work.s8_1170, work.s8_1193, s8_1787);
  const double s8_1789 = fnma(work.s8_1211, work.s8_1424, s8_1788);
  const double s8_1790 = fma(work.s8_1219, work.s8_1430, s8_1789);
  const double s8_1791 = fma(work.s8_1247, work.s8_1437, s8_1790);
  const double s8_1792 = fma(projection.Rz[0], work.s8_1441, s8_1791);
  const double s8_1793 = fma(projection.Rz[12], work.s8_1445, s8_1792);
  const double s8_1794 = fma(projection.Rz[15], work.s8_1450, s8_1793);
  const double s8_1795 = fma(projection.Rz[18], work.s8_1454, s8_1794);
  const double s8_1796 = fma(projection.Rz[30], work.s8_1458, s8_1795);
  const double s8_1797 = fma(projection.Rz[33], work.s8_1463, s8_1796);
  const double s8_1798 = fma(projection.Rz[36], work.s8_1467, s8_1797);
  const double s8_1799 = fma(projection.Rz[39], work.s8_1471, s8_1798);
  const double s8_1800 = fma(work.s3_40, work.s8_1477, fma(work.s3_31, work.s8_1474, s8_1799));
  const double s8_1801 = fma(work.s3_58, work.s8_1483, fma(work.s3_49, work.s8_1480, s8_1800));
  work.s8_1802 = fnma(s8_1561, work.s8_1770, fnma(work.s8_1515, s8_1535, s8_1801));
  const double s8_1803 = fma(work.s8_412, work.s8_577, work.s8_523*work.s8_546);
  const double s8_1804 = fma(work.s8_1582, work.s8_1725, s8_1803);
  const double s8_1805 = fma(work.s8_1705, work.s8_1728, s8_1804);
  work.s8_1806 = fma(work.s8_1271, work.s8_1734, s8_1805);
  // operations: 1399 add, 1497 multiply, 3 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1807 = work.s8_689 + work.s8_828;
  const double s8_1808 = work.s8_33 + work.s8_49;
  const double s8_1809 = work.s8_30 + work.s8_45;
  const double s8_1810 = work.s7_206 + (work.s7_126 + (work.s7_50 + (work.s7_41 - 70.9875)));
  const double s8_1811 = fma(p_bell_crank_z, work.s8_644, work.s7_213 + s8_1810);
  const double s8_1812 = fnma(p_pitman_arm_x, work.s8_658, s8_1811);
  const double s8_1813 = work.s8_954 + (work.s8_843 - work.s8_698 - work.s8_811);
  const double s8_1814 = fma(p_pitman_arm_z, work.s8_665, s8_1812);
  const double s8_1815 = fnma(0.5, s8_1807, fma(p_lower_arm_left_x, s8_1813, s8_1814));
  const double s8_1816 = fnma(p_carrier_left_rz_y, s8_1808, s8_1815);
  const double s8_1817 = fma(p_arb_front_right_x, work.s8_681 + work.s8_823, s8_1816);
  work.s8_1818 = fnma(p_arb_rear_right_x, s8_1809, s8_1817);
  const double s8_1819 = work.s7_106 + (work.s7_56 + (3289.7 - work.s7_38 - work.s7_46));
  const double s8_1820 = work.s7_195 + (work.s7_117 + s8_1819 - work.s7_132 - work.s7_186);
  work.s8_1821 = s8_1820 - work.s7_210;
  const double s8_1822 = work.s7_197 + (work.s7_121 + (work.s7_45 + (356.525 + work.s7_36)));
  work.s8_1823 = s8_1822 - work.s7_209 - work.s7_219;
  const double s8_1824 = work.s7_113 + (work.s7_63 + (work.s7_52 + (10856.945 + work.s7_43)));
  const double s8_1825 = work.s7_208 + (work.s7_193 + (work.s7_139 + (work.s7_128 + s8_1824)));
  const double s8_1826 = fma(0.8, work.s8_658, work.s7_215 + s8_1825) - work.s8_681 - work.s8_823;
  const double s8_1827 = fma(0.56, work.s8_698 - work.s8_843, fma(0.9, s8_1809, s8_1826));
  work.s8_1828 = fma(1.24, work.s8_811 - work.s8_954, s8_1827);
  const double s8_1829 = work.s7_138 + (work.s7_112 + (5020.856800000031 + work.s7_62));
  const double s8_1830 = work.s8_841 + (work.s7_224 + (work.s7_192 + s8_1829) - work.s8_703);
  work.s8_1831 = fma(0.8, work.s8_952 - work.s8_815, s8_1830);
  const double s8_1832 = work.s7_207 + (work.s7_127 + (work.s7_51 + (141129.72 + work.s7_42)));
  const double s8_1833 = fma(6.5, work.s8_644, work.s7_223 + (work.s7_214 + s8_1832));
  work.s8_1834 = fnma(6.6, s8_1808, fma(7.9, s8_1807, fma(8.8, work.s8_665, s8_1833)));
  const double s8_1835 = fnma(work.s8_109, work.s8_576, fnma(work.s8_519, work.s8_520, 15306.0));
  const double s8_1836 = fnma(work.s8_1568, work.s8_1570, s8_1835);
  const double s8_1837 = fnma(work.s8_1565, work.s8_1727, s8_1836);
  work.s8_1838 = fnma(work.s8_899, work.s8_1733, s8_1837);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_1839 = work.s7_69 + fma(m_rear_axle_2, z_rear_axle_ty, work.s7_8);
  const double s8_1840 = work.r_carrier_left_aux1_y + work.r_carrier_right_aux1_y;
  work.s8_1841 = fma(m_carrier_right_2, s8_1840, work.s8_939 + (work.s7_148 + s8_1839));
  const double s8_1842 = fma(work.s8_412, work.s8_576, work.s8_520*work.s8_546);
  const double s8_1843 = fma(work.s8_1570, work.s8_1725, s8_1842);
  const double s8_1844 = fma(work.s8_1705, work.s8_1727, s8_1843);
  work.s8_1845 = work.s8_1841 + fma(work.s8_1271, work.s8_1733, s8_1844);
  const double s8_1846 = fma(work.s8_116, work.s8_141, work.s7_33);
  const double s8_1847 = fnma(work.s8_209, work.s8_210, fnma(work.s8_168, work.s8_169, s8_1846));
  const double s8_1848 = fnma(work.s8_288, work.s8_305, fnma(work.s8_251, work.s8_252, s8_1847));
  const double s8_1849 = fnma(work.s8_366, work.s8_375, fnma(work.s8_326, work.s8_341, s8_1848));
  const double s8_1850 = fma(work.s8_777, work.s8_800, work.s7_181 + (work.s7_101 + s8_1849));
  const double s8_1851 = fnma(work.s8_984, work.s8_985, fma(work.s8_913, work.s8_916, s8_1850));
  const double s8_1852 = fnma(work.s8_1032, work.s8_1048, s8_1851);
  const double s8_1853 = fnma(work.s8_1099, work.s8_1100, s8_1852);
  const double s8_1854 = fnma(work.s8_1164, work.s8_1165, s8_1853);
  work.s8_1855 = work.s8_1831 + fnma(work.s8_1205, work.s8_1216, s8_1854);
  const double s8_1856 = fma(work.s8_115, work.s8_142, work.s7_30);
  const double s8_1857 = fnma(work.s8_194, work.s8_211, fnma(work.s8_152, work.s8_170, s8_1856));
  const double s8_1858 = fnma(work.s8_292, work.s8_306, fnma(work.s8_249, work.s8_253, s8_1857));
  const double s8_1859 = fnma(work.s8_388, work.s8_389, fnma(work.s8_328, work.s8_342, s8_1858));
  const double s8_1860 = fnma(work.s8_980, work.s8_986, work.s7_177 + (work.s7_98 + s8_1859));
  const double s8_1861 = fnma(work.s8_1045, work.s8_1046, s8_1860);
  const double s8_1862 = fnma(work.s8_1102, work.s8_1104, s8_1861);
  const double s8_1863 = fnma(work.s8_1163, work.s8_1166, s8_1862);
  const double s8_1864 = work.s8_1834 + fnma(work.s8_1214, work.s8_1215, s8_1863);
  const double s8_1865 = fma(7.2, work.s8_776 + work.s8_914, s8_1864);
  const double s8_1866 = fnma(work.s8_546, work.s8_547, work.s8_1855);
  const double s8_1867 = fnma(work.s8_412, work.s8_579, s8_1866);
  const double s8_1868 = fnma(work.s8_1725, work.s8_1726, s8_1867);
  const double s8_1869 = fnma(work.s8_1705, work.s8_1732, s8_1868);
  const double pivot_chassis_rx = s8_1865 + fnma(work.s8_1271, work.s8_1738, s8_1869);
  result.inertia[5] = pivot_chassis_rx;
  work.s8_1870 = 1.0/pivot_chassis_rx;
  work.s8_1871 = work.s8_1845*work.s8_1870;
  const double s8_1872 = work.s7_66 + fma(m_rear_axle_2, work.r_rear_axle_aux3_z, work.s7_10);
  const double s8_1873 = work.r_carrier_left_aux1_z - work.s1_33;
  work.s8_1874 = fma(m_carrier_right_2, s8_1873, work.s8_1821 + (work.s7_145 + s8_1872));
  const double s8_1875 = fma(work.r_rear_axle_aux3_z, work.s8_116, work.s7_26);
  const double s8_1876 = fma(work.s8_147, work.s8_169, fma(z_rear_axle_ty, work.s8_117, s8_1875));
  const double s8_1877 = fma(work.s8_243, work.s8_252, fma(work.s8_190, work.s8_210, s8_1876));
  const double s8_1878 = fnma(work.s8_324, work.s8_341, fnma(work.s8_290, work.s8_305, s8_1877));
  const double s8_1879 = fma(work.s8_546, work.s8_560, fnma(work.s8_374, work.s8_375, s8_1878));
  const double s8_1880 = work.s7_163 + (work.s7_86 + fma(work.s8_412, work.s8_580, s8_1879));
  const double s8_1881 = fnma(work.s1_33, work.s8_777, s8_1880);
  const double s8_1882 = fma(work.r_carrier_right_aux1_y, work.s8_778, s8_1881);
  const double s8_1883 = fma(work.r_carrier_left_aux1_y, work.s8_912, s8_1882);
  const double s8_1884 = fma(work.r_carrier_left_aux1_z, work.s8_913, s8_1883);
  const double s8_1885 = fma(work.s8_1044, work.s8_1048, fnma(work.s8_979, work.s8_985, s8_1884));
  const double s8_1886 = fnma(work.s8_1100, work.s8_1101, s8_1885);
  const double s8_1887 = fma(work.s8_1143, work.s8_1165, s8_1886);
  const double s8_1888 = work.s8_1531 + fnma(work.s8_1201, work.s8_1216, s8_1887);
  const double s8_1889 = fma(work.s8_1631, work.s8_1725, s8_1888);
  const double s8_1890 = fma(work.s8_1705, work.s8_1730, s8_1889);
  work.s8_1891 = fma(work.s8_1271, work.s8_1736, s8_1890);
  work.s8_1892 = work.s8_1870*work.s8_1891;
  const double s8_1893 = fnma(work.s8_520, work.s8_559, work.s8_1874);
  const double s8_1894 = fnma(work.s8_424, work.s8_576, s8_1893);
  const double s8_1895 = fnma(work.s8_1570, work.s8_1630, s8_1894);
  const double s8_1896 = fnma(work.s8_1610, work.s8_1727, s8_1895);
  const double s8_1897 = fnma(work.s8_1243, work.s8_1733, s8_1896);
  work.s8_1898 = fnma(work.s8_1845, work.s8_1892, s8_1897);
  const double s8_1899 = fma(work.s8_117, work.s8_140, work.s7_34);
  const double s8_1900 = fnma(work.s8_190, work.s8_212, fnma(work.s8_147, work.s8_171, s8_1899));
  const double s8_1901 = fnma(work.s8_290, work.s8_307, fnma(work.s8_243, work.s8_266, s8_1900));
  const double s8_1902 = fnma(work.s8_374, work.s8_390, fnma(work.s8_324, work.s8_343, s8_1901));
  const double s8_1903 = fnma(work.s8_760, work.s8_778, work.s7_182 + (work.s7_102 + s8_1902));
  const double s8_1904 = fnma(work.s8_979, work.s8_987, fma(work.s8_912, work.s8_915, s8_1903));
  const double s8_1905 = fnma(work.s8_1044, work.s8_1047, s8_1904);
  const double s8_1906 = fnma(work.s8_1101, work.s8_1103, s8_1905);
  const double s8_1907 = fnma(work.s8_1143, work.s8_1175, s8_1906);
  work.s8_1908 = work.s8_1828 + fnma(work.s8_1201, work.s8_1217, s8_1907);
  const double s8_1909 = fnma(work.s8_424, work.s8_580, fnma(work.s8_559, work.s8_560, s8_1865));
  const double s8_1910 = fnma(work.s8_1630, work.s8_1631, s8_1909);
  const double s8_1911 = fnma(work.s8_1610, work.s8_1730, s8_1910);
  work.s8_1912 = work.s8_1908 + fnma(work.s8_1243, work.s8_1736, s8_1911);
  work.pivot_chassis_ry = fnma(work.s8_1891, work.s8_1892, work.s8_1912);
  work.s8_1913 = 1.0/work.pivot_chassis_ry;
  work.s8_1914 = work.s8_1898*work.s8_1913;
  const double s8_1915 = fma(work.r_rear_axle_aux3_z, work.s8_115, work.s7_28);
  const double s8_1916 = fma(work.r_rear_axle_aux1_x, work.s8_117, s8_1915);
  const double s8_1917 = fnma(work.s8_190, work.s8_211, fnma(work.s8_147, work.s8_170, s8_1916));
  const double s8_1918 = fnma(work.s8_290, work.s8_306, fma(work.s8_243, work.s8_253, s8_1917));
  const double s8_1919 = fma(work.s8_374, work.s8_389, fnma(work.s8_324, work.s8_342, s8_1918));
  const double s8_1920 = fma(work.s8_412, work.s8_578, fma(work.s8_535, work.s8_546, s8_1919));
  const double s8_1921 = fnma(work.s1_33, work.s8_776, work.s7_172 + (work.s7_94 + s8_1920));
  const double s8_1922 = fma(work.r_carrier_left_aux1_z, work.s8_914, s8_1921);
  const double s8_1923 = fnma(work.s8_979, work.s8_986, s8_1922);
  const double s8_1924 = fnma(work.s8_1044, work.s8_1046, s8_1923);
  const double s8_1925 = fnma(work.s8_1101, work.s8_1104, s8_1924);
  const double s8_1926 = fnma(work.s8_1143, work.s8_1166, s8_1925);
  const double s8_1927 = fma(work.s8_1201, work.s8_1215, s8_1926);
  const double s8_1928 = fma(work.s8_1685, work.s8_1725, s8_1927);
  const double s8_1929 = fma(work.s8_1705, work.s8_1731, s8_1928);
  const double s8_1930 = work.s8_1818 + fma(work.s8_1271, work.s8_1737, s8_1929);
  work.s8_1931 = fma(p_lower_arm_left_x, work.s8_778 + work.s8_912, s8_1930);
  const double s8_1932 = fma(z_rear_axle_ty, work.s8_115, work.s7_19);
  const double s8_1933 = fma(work.r_rear_axle_aux1_x, work.s8_116, s8_1932);
  const double s8_1934 = fma(work.s8_209, work.s8_211, fma(work.s8_168, work.s8_170, s8_1933));
  const double s8_1935 = fnma(work.s8_288, work.s8_306, fnma(work.s8_251, work.s8_253, s8_1934));
  const double s8_1936 = fma(work.s8_366, work.s8_389, fnma(work.s8_326, work.s8_342, s8_1935));
  const double s8_1937 = fma(work.s8_424, work.s8_578, fma(work.s8_535, work.s8_559, s8_1936));
  const double s8_1938 = work.s7_175 + (work.s7_96 + s8_1937);
  const double s8_1939 = fma(work.r_carrier_right_aux1_y, work.s8_776, s8_1938);
  const double s8_1940 = fma(work.r_carrier_left_aux1_y, work.s8_914, s8_1939);
  const double s8_1941 = fma(work.s8_1032, work.s8_1046, fnma(work.s8_984, work.s8_986, s8_1940));
  const double s8_1942 = fnma(work.s8_1099, work.s8_1104, s8_1941);
  const double s8_1943 = fma(work.s8_1164, work.s8_1166, s8_1942);
  const double s8_1944 = work.s8_1522 + fma(work.s8_1205, work.s8_1215, s8_1943);
  const double s8_1945 = fma(work.s8_1630, work.s8_1685, s8_1944);
  const double s8_1946 = fma(work.s8_1610, work.s8_1731, s8_1945);
  const double s8_1947 = fma(work.s8_1243, work.s8_1737, s8_1946);
  const double s8_1948 = fma(work.s8_1892, work.s8_1931, s8_1947);
  work.s8_1949 = fma(p_lower_arm_left_x, work.s8_777 + work.s8_913, s8_1948);
}

/// Part 6 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63);
/// step 9: accelerations from the root to the leaves (63), (62).
[[gnu::noinline]] void compute_chosen_accelerations_6(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1950 = work.s8_1913*work.s8_1949;
  const double s8_1951 = work.s8_1870*work.s8_1931;
  const double s8_1952 = fnma(work.s8_520, work.s8_534, work.s8_1898*s8_1950);
  const double s8_1953 = fnma(work.s8_401, work.s8_576, s8_1952);
  const double s8_1954 = fnma(work.s8_1570, work.s8_1684, s8_1953);
  const double s8_1955 = fnma(work.s8_1657, work.s8_1727, s8_1954);
  const double s8_1956 = fnma(work.s8_1845, s8_1951, fnma(work.s8_1297, work.s8_1733, s8_1955));
  const double s8_1957 = fnma(work.s8_534, work.s8_535, work.s8_1855);
  const double s8_1958 = fnma(work.s8_401, work.s8_578, s8_1957);
  const double s8_1959 = fnma(work.s8_1684, work.s8_1685, s8_1958);
  const double s8_1960 = fnma(work.s8_1657, work.s8_1731, s8_1959);
  const double s8_1961 = work.s8_1908 + fnma(work.s8_1297, work.s8_1737, s8_1960);
  const double pivot_chassis_rz = fnma(work.s8_1931, s8_1951, fnma(work.s8_1949, s8_1950, s8_1961));
  const double s8_1962 = 1.0/pivot_chassis_rz;
  const double s8_1963 = s8_1956*s8_1962;
  const double s8_1964 = work.s7_12 + fma(m_rear_axle_2, work.r_rear_axle_aux1_x, 1580.4);
  const double s8_1965 = work.s8_1823 + (work.s7_142 + (work.s7_72 + s8_1964));
  const double s8_1966 = fma(work.s8_424, work.s8_577, work.s8_523*work.s8_559);
  const double s8_1967 = fma(work.s8_1582, work.s8_1630, s8_1966);
  const double s8_1968 = fma(work.s8_1610, work.s8_1728, s8_1967);
  const double s8_1969 = fma(work.s8_1243, work.s8_1734, s8_1968);
  const double s8_1970 = s8_1965 + fma(work.s8_1806, work.s8_1892, s8_1969);
  const double s8_1971 = work.s8_1913*s8_1970;
  const double s8_1972 = work.s8_1806*work.s8_1870;
  const double s8_1973 = fnma(work.s8_523, work.s8_534, work.s8_1841);
  const double s8_1974 = fnma(work.s8_401, work.s8_577, s8_1973);
  const double s8_1975 = fnma(work.s8_1582, work.s8_1684, s8_1974);
  const double s8_1976 = fnma(work.s8_1657, work.s8_1728, s8_1975);
  const double s8_1977 = fnma(work.s8_1806, s8_1951, fnma(work.s8_1297, work.s8_1734, s8_1976));
  const double s8_1978 = fnma(s8_1950, s8_1970, s8_1977);
  const double s8_1979 = s8_1962*s8_1978;
  const double s8_1980 = fnma(work.s8_520, work.s8_522, work.s8_1898*s8_1971);
  const double s8_1981 = fnma(work.s8_114, work.s8_576, s8_1980);
  const double s8_1982 = fnma(work.s8_1570, work.s8_1581, s8_1981);
  const double s8_1983 = fnma(work.s8_1575, work.s8_1727, s8_1982);
  const double s8_1984 = fnma(work.s8_1845, s8_1972, fnma(work.s8_944, work.s8_1733, s8_1983));
  const double s8_1985 = fnma(s8_1956, s8_1979, s8_1984);
  const double s8_1986 = fnma(work.s8_114, work.s8_577, fnma(work.s8_522, work.s8_523, 15306.0));
  const double s8_1987 = fnma(work.s8_1581, work.s8_1582, s8_1986);
  const double s8_1988 = fnma(work.s8_1575, work.s8_1728, s8_1987);
  const double s8_1989 = fnma(work.s8_944, work.s8_1734, s8_1988);
  const double s8_1990 = fnma(work.s8_1806, s8_1972, fnma(s8_1970, s8_1971, s8_1989));
  const double pivot_chassis_tz = fnma(s8_1978, s8_1979, s8_1990);
  const double s8_1991 = 1.0/pivot_chassis_tz;
  const double s8_1992 = s8_1985*s8_1991;
  const double s8_1993 = fnma(work.s8_412, work.s8_561, fnma(work.s8_517, work.s8_546, s8_1965));
  const double s8_1994 = fnma(work.s8_1590, work.s8_1725, s8_1993);
  const double s8_1995 = fnma(work.s8_1705, work.s8_1729, s8_1994);
  const double s8_1996 = fnma(work.s8_1271, work.s8_1735, s8_1995);
  const double s8_1997 = work.s8_1870*s8_1996;
  const double s8_1998 = fnma(work.s8_517, work.s8_559, work.s8_1892*s8_1996);
  const double s8_1999 = fnma(work.s8_424, work.s8_561, s8_1998);
  const double s8_2000 = fnma(work.s8_1590, work.s8_1630, s8_1999);
  const double s8_2001 = fnma(work.s8_1610, work.s8_1729, s8_2000);
  const double s8_2002 = fnma(work.s8_1243, work.s8_1735, s8_2001);
  const double s8_2003 = work.s8_1913*s8_2002;
  const double s8_2004 = fnma(work.s8_517, work.s8_534, s8_1951*s8_1996);
  const double s8_2005 = fnma(work.s8_401, work.s8_561, s8_2004);
  const double s8_2006 = fnma(work.s8_1590, work.s8_1684, s8_2005);
  const double s8_2007 = fnma(work.s8_1657, work.s8_1729, s8_2006);
  const double s8_2008 = fnma(work.s8_1297, work.s8_1735, s8_2007) - work.s8_1874;
  const double s8_2009 = fma(s8_1950, s8_2002, s8_2008);
  const double s8_2010 = s8_1962*s8_2009;
  const double s8_2011 = fnma(work.s8_517, work.s8_522, s8_1972*s8_1996);
  const double s8_2012 = fnma(work.s8_114, work.s8_561, s8_2011);
  const double s8_2013 = fnma(work.s8_1581, work.s8_1590, s8_2012);
  const double s8_2014 = fnma(work.s8_1575, work.s8_1729, s8_2013);
  const double s8_2015 = fma(s8_1971, s8_2002, fnma(work.s8_944, work.s8_1735, s8_2014));
  const double s8_2016 = fnma(s8_1979, s8_2009, s8_2015);
  const double s8_2017 = s8_1991*s8_2016;
  const double s8_2018 = fnma(work.s8_515, work.s8_520, work.s8_1845*s8_1997);
  const double s8_2019 = fnma(work.s8_127, work.s8_576, s8_2018);
  const double s8_2020 = fnma(work.s8_1570, work.s8_1589, s8_2019);
  const double s8_2021 = fnma(work.s8_1585, work.s8_1727, s8_2020);
  const double s8_2022 = fnma(work.s8_1898, s8_2003, fnma(work.s8_947, work.s8_1733, s8_2021));
  const double s8_2023 = fnma(s8_1985, s8_2017, fnma(s8_1956, s8_2010, s8_2022));
  const double s8_2024 = fnma(work.s8_127, work.s8_561, fnma(work.s8_515, work.s8_517, 15306.0));
  const double s8_2025 = fnma(work.s8_1589, work.s8_1590, s8_2024);
  const double s8_2026 = fnma(work.s8_1585, work.s8_1729, s8_2025);
  const double s8_2027 = fnma(work.s8_947, work.s8_1735, s8_2026);
  const double s8_2028 = fnma(s8_2002, s8_2003, fnma(s8_1996, s8_1997, s8_2027));
  const double pivot_chassis_ty = fnma(s8_2016, s8_2017, fnma(s8_2009, s8_2010, s8_2028));
  const double s8_2029 = 1.0/pivot_chassis_ty;
  const double s8_2030 = s8_2023*s8_2029;
  const double s8_2031 = fnma(work.s8_1845, work.s8_1871, work.s8_1838);
  const double s8_2032 = fnma(s8_1956, s8_1963, fnma(work.s8_1898, work.s8_1914, s8_2031));
  const double pivot_chassis_tx = fnma(s8_2023, s8_2030, fnma(s8_1985, s8_1992, s8_2032));
  const double s8_2033 = fnma(1e-12, work.s8_1912, work.pivot_chassis_ry);
  const double s8_2034 = work.s8_848 - work.s8_707;
  const double s8_2035 = work.s8_959 - work.f_carrier_right_y - work.s8_816;
  const double s8_2036 = work.s8_36 + work.s8_53;
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double s1_6 = work.sines[2];
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  const double s8_2037 = fnma(s1_6, tau_chassis_ry, tau_chassis_rz*work.s1_58);
  const double s8_2038 = fma(tau_chassis_rx, work.s1_60, s8_2037);
  const double s8_2039 = fnma(projection.zdd_star[20], work.s7_37, s8_2038);
  const double s8_2040 = fma(projection.zdd_star[21], work.s7_44, s8_2039);
  const double s8_2041 = fnma(work.s7_50, work.s8_31, fma(work.s7_47, work.s8_29, s8_2040));
  const double s8_2042 = fnma(work.s7_35, work.s8_48, fnma(work.s7_51, work.s8_35, s8_2041));
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_2043 = fnma(work.s7_42, work.s8_52, fnma(work.s7_41, work.s8_51, s8_2042));
  const double s8_2044 = fma(z_rear_axle_ty, work.f_rear_axle_x, s8_2043);
  const double s8_2045 = fnma(work.r_rear_axle_aux1_x, work.f_rear_axle_y, s8_2044);
  const double s8_2046 = fnma(work.s8_168, work.s8_176, s8_2045 - work.n_rear_axle_z);
  const double s8_2047 = fnma(work.s8_209, work.s8_218, fnma(work.s8_152, work.s8_186, s8_2046));
  const double s8_2048 = fnma(work.s8_251, work.s8_280, fnma(work.s8_194, work.s8_230, s8_2047));
  const double s8_2049 = fnma(work.s8_292, work.s8_312, fma(work.s8_249, work.s8_286, s8_2048));
  const double s8_2050 = fnma(work.s8_328, work.s8_349, fma(work.s8_288, work.s8_322, s8_2049));
  const double s8_2051 = fma(work.s8_388, work.s8_465, fma(work.s8_326, work.s8_361, s8_2050));
  const double s8_2052 = fnma(work.s8_547, work.s8_575, fma(work.s8_366, work.s8_479, s8_2051));
  const double s8_2053 = fnma(work.s8_511, work.s8_579, s8_2052);
  const double s8_2054 = fma(projection.zdd_star[5], work.s7_115, s8_2053);
  const double s8_2055 = fnma(projection.zdd_star[11], work.s7_201, s8_2054);
  const double s8_2056 = fma(p_bell_crank_x, work.s8_648, s8_2055);
  const double s8_2057 = fnma(0.9515, projection.zdd_star[13], s8_2056);
  const double s8_2058 = fnma(work.s7_213, work.s8_660, fnma(work.s7_214, work.s8_659, s8_2057));
  const double s8_2059 = fma(p_pitman_arm_x, work.s8_664, s8_2058);
  const double s8_2060 = fnma(work.s7_206, work.s8_682, fnma(work.s7_199, work.s8_680, s8_2059));
  const double s8_2061 = fma(work.s7_191, work.s8_704, fnma(work.s7_207, work.s8_686, s8_2060));
  const double s8_2062 = fma(work.s7_192, work.s8_705, s8_2061);
  const double s8_2063 = fma(work.r_carrier_right_aux1_y, work.f_carrier_right_x, s8_2062);
  const double s8_2064 = fma(work.s7_137, work.s8_812, s8_2063 - work.n_carrier_right_z);
  const double s8_2065 = fnma(work.s7_119, work.s8_827, fma(work.s7_138, work.s8_813, s8_2064));
  const double s8_2066 = fnma(work.s7_127, work.s8_830, fnma(work.s7_126, work.s8_829, s8_2065));
  const double s8_2067 = fma(work.s7_111, work.s8_844, fma(work.s7_112, work.s8_842, s8_2066));
  const double s8_2068 = fma(work.r_carrier_left_aux1_y, work.f_carrier_left_x, s8_2067);
  const double s8_2069 = fma(work.s7_62, work.s8_953, s8_2068 - work.n_carrier_left_z);
  const double s8_2070 = fnma(work.s8_984, work.s8_1009, fma(work.s7_61, work.s8_955, s8_2069));
  const double s8_2071 = fma(work.s8_1045, work.s8_1070, fma(work.s8_980, work.s8_1015, s8_2070));
  const double s8_2072 = fma(work.s8_1032, work.s8_1076, s8_2071);
  const double s8_2073 = fnma(work.s8_1099, work.s8_1124, s8_2072);
  const double s8_2074 = fma(work.s8_1102, work.s8_1133, s8_2073);
  const double s8_2075 = fnma(work.s8_1164, work.s8_1186, s8_2074);
  const double s8_2076 = fnma(work.s8_1163, work.s8_1193, s8_2075);
  const double s8_2077 = fma(work.s8_1205, work.s8_1430, s8_2076);
  const double s8_2078 = fnma(work.s8_32, work.s8_1522, fma(work.s8_1214, work.s8_1437, s8_2077));
  const double s8_2079 = fnma(work.s8_1515, work.s8_1738, fma(work.s8_17, work.s8_1531, s8_2078));
  const double s8_2080 = fnma(work.s8_1732, work.s8_1770, s8_2079);
  const double s8_2081 = fnma(work.s8_1726, work.s8_1802, s8_2080);
  const double s8_2082 = s8_2034 + (s8_2035 - work.f_carrier_left_y);
  const double s8_2083 = fnma(work.s8_16, work.s8_1818, s8_2081);
  const double s8_2084 = work.s8_845 + (work.s8_667 - work.s8_706);
  const double s8_2085 = fma(0.5, s8_2084, fma(p_lower_arm_left_x, s8_2082, s8_2083));
  const double s8_2086 = fma(p_lower_arm_left_y, work.s8_956 - work.s8_814, s8_2085);
  const double s8_2087 = fnma(p_arb_front_right_y, work.s8_832 - work.s8_690, s8_2086);
  const double s8_2088 = fnma(p_arb_front_right_x, work.s8_687 + work.s8_831, s8_2087);
  const double s8_2089 = fnma(p_arb_rear_right_y, work.s8_34 - work.s8_56, s8_2088);
  const double s8_2090 = fnma(p_arb_rear_right_x, s8_2036, s8_2089);
  const double s8_2091 = fma(work.s8_15, work.s8_1831 - work.s8_1834, s8_2090);
  const double s8_2092 = work.s8_846 + (work.s8_817 + (work.s8_708 + work.f_carrier_right_z));
  const double s1_9 = work.cosines[2];
  const double s8_2093 = fma(tau_chassis_rz, work.s1_57, s1_9*tau_chassis_ry);
  const double s8_2094 = fma(tau_chassis_rx, work.s1_59, s8_2093);
  const double s8_2095 = fnma(0.4225, projection.zdd_star[21], s8_2094);
  const double s8_2096 = fnma(0.4225, projection.zdd_star[20], s8_2095);
  const double s8_2097 = fnma(work.r_rear_axle_aux3_z, work.f_rear_axle_x, s8_2096);
  const double s8_2098 = fma(work.r_rear_axle_aux1_x, work.f_rear_axle_z, s8_2097);
  const double s8_2099 = fnma(work.s8_147, work.s8_176, s8_2098 - work.n_rear_axle_y);
  const double s8_2100 = fnma(work.s8_190, work.s8_218, fma(work.s8_152, work.s8_181, s8_2099));
  const double s8_2101 = fnma(work.s8_249, work.s8_273, fma(work.s8_194, work.s8_224, s8_2100));
  const double s8_2102 = fma(work.s8_292, work.s8_317, fnma(work.s8_243, work.s8_280, s8_2101));
  const double s8_2103 = fma(work.s8_328, work.s8_355, fnma(work.s8_290, work.s8_322, s8_2102));
  const double s8_2104 = fnma(work.s8_388, work.s8_472, fnma(work.s8_324, work.s8_361, s8_2103));
  const double s8_2105 = fnma(work.s8_560, work.s8_575, fnma(work.s8_374, work.s8_479, s8_2104));
  const double s8_2106 = fma(work.s7_223, work.s8_642, fnma(work.s8_511, work.s8_580, s8_2105));
  const double s8_2107 = fma(p_bell_crank_x, work.s8_646, fma(work.s7_222, work.s8_643, s8_2106));
  const double s8_2108 = fnma(p_bell_crank_z, work.s8_647, s8_2107);
  const double s8_2109 = fma(p_pitman_arm_x, work.s8_666, s8_2108);
  const double s8_2110 = fnma(p_pitman_arm_z, work.s8_667, s8_2109);
  const double s8_2111 = fnma(0.3504, projection.zdd_star[12], s8_2110);
  const double s8_2112 = fnma(0.3477, projection.zdd_star[11], s8_2111);
  const double s8_2113 = fnma(work.s7_191, work.s8_705, fnma(work.s7_193, work.s8_704, s8_2112));
  const double s8_2114 = fma(work.s1_33, work.f_carrier_right_x, s8_2113);
  const double s8_2115 = fnma(work.s7_139, work.s8_812, s8_2114 - work.n_carrier_right_y);
  const double s8_2116 = fnma(work.s7_137, work.s8_813, s8_2115);
  const double s8_2117 = fnma(0.3477, projection.zdd_star[5], s8_2116);
  const double s8_2118 = fnma(work.s7_113, work.s8_844, fnma(work.s7_111, work.s8_842, s8_2117));
  const double s8_2119 = fnma(work.r_carrier_left_aux1_z, work.f_carrier_left_x, s8_2118);
  const double s8_2120 = fnma(work.s7_61, work.s8_953, s8_2119 - work.n_carrier_left_y);
  const double s8_2121 = fma(work.s8_979, work.s8_1009, fnma(work.s7_63, work.s8_955, s8_2120));
  const double s8_2122 = fnma(work.s8_980, work.s8_1022, s8_2121);
  const double s8_2123 = fma(work.s8_1044, work.s8_1076, s8_2122);
  const double s8_2124 = fnma(work.s8_1045, work.s8_1084, s8_2123);
  const double s8_2125 = fma(work.s8_1101, work.s8_1124, s8_2124);
  const double s8_2126 = fnma(work.s8_1102, work.s8_1129, s8_2125);
  const double s8_2127 = fma(work.s8_1163, work.s8_1180, s8_2126);
  const double s8_2128 = fnma(work.s8_1143, work.s8_1186, s8_2127);
  const double s8_2129 = fnma(work.s8_1214, work.s8_1424, s8_2128);
  const double s8_2130 = fma(work.s8_16, work.s8_1522, fnma(work.s8_1201, work.s8_1430, s8_2129));
  const double s8_2131 = fnma(work.s8_15, work.s8_1531, s8_2130);
  const double s8_2132 = fnma(work.s8_1515, work.s8_1736, s8_2131);
  const double s8_2133 = fnma(work.s8_1730, work.s8_1770, s8_2132);
  const double s8_2134 = fnma(work.s8_1631, work.s8_1802, s8_2133);
  const double s8_2135 = fma(work.s8_1892, s8_2091, fnma(work.s8_43, work.s8_1818, s8_2134));
  const double s8_2136 = work.s8_957 + (work.f_carrier_left_z + s8_2092);
  const double s8_2137 = fma(p_lower_arm_left_x, s8_2136, s8_2135);
  const double s8_2138 = fma(0.5, work.s8_690 + work.s8_832, s8_2137);
  const double s8_2139 = fnma(p_carrier_left_rz_y, work.s8_34 + work.s8_56, s8_2138);
  const double s8_2140 = fnma(p_lower_arm_left_z, work.s8_814 + work.s8_956, s8_2139);
  const double s8_2141 = fnma(p_upper_arm_right_z, work.s8_706 + work.s8_845, s8_2140);
  const double s8_2142 = fnma(p_arb_front_right_x, work.s8_691 + work.s8_834, s8_2141);
  const double s8_2143 = fma(p_arb_rear_right_x, work.s8_39 + work.s8_55, s8_2142);
  const double s8_2144 = fma(work.s8_17, work.s8_1834 - work.s8_1828, s8_2143);
  result.inertia[3] = fnma(1e-12, s8_1961, pivot_chassis_rz);
  result.inertia[2] = fnma(1e-12, s8_1989, pivot_chassis_tz);
  result.inertia[1] = fnma(1e-12, s8_2027, pivot_chassis_ty);
  const double s8_2145 = fma(projection.zdd_star[20], work.s7_35, tau_chassis_rx*work.s1_61);
  const double s8_2146 = fnma(projection.zdd_star[21], work.s7_47, s8_2145);
  const double s8_2147 = fma(work.s7_52, work.s8_31, fma(work.s7_44, work.s8_29, s8_2146));
  const double s8_2148 = fnma(work.s7_37, work.s8_48, fma(work.s7_50, work.s8_35, s8_2147));
  const double s8_2149 = fma(work.s7_41, work.s8_52, fma(work.s7_43, work.s8_51, s8_2148));
  const double s8_2150 = fma(work.r_rear_axle_aux3_z, work.f_rear_axle_y, s8_2149);
  const double s8_2151 = fnma(z_rear_axle_ty, work.f_rear_axle_z, s8_2150) - work.n_rear_axle_x;
  const double s8_2152 = fma(work.s8_147, work.s8_186, fma(work.s8_168, work.s8_181, s8_2151));
  const double s8_2153 = fma(work.s8_190, work.s8_230, fma(work.s8_209, work.s8_224, s8_2152));
  const double s8_2154 = fma(work.s8_243, work.s8_286, fma(work.s8_251, work.s8_273, s8_2153));
  const double s8_2155 = fnma(work.s8_288, work.s8_317, fma(work.s8_290, work.s8_312, s8_2154));
  const double s8_2156 = fnma(work.s8_326, work.s8_355, fma(work.s8_324, work.s8_349, s8_2155));
  const double s8_2157 = fnma(work.s8_366, work.s8_472, fma(work.s8_374, work.s8_465, s8_2156));
  const double s8_2158 = fnma(work.s8_511, work.s8_578, fnma(work.s8_535, work.s8_575, s8_2157));
  const double s8_2159 = fma(projection.zdd_star[5], work.s7_119, s8_2158);
  const double s8_2160 = fma(projection.zdd_star[11], work.s7_199, s8_2159);
  const double s8_2161 = fnma(work.s7_224, work.s8_643, fnma(work.s7_222, work.s8_642, s8_2160));
  const double s8_2162 = fnma(p_bell_crank_z, work.s8_648, s8_2161);
  const double s8_2163 = fma(work.s7_215, work.s8_660, fma(work.s7_213, work.s8_659, s8_2162));
  const double s8_2164 = fma(work.s7_208, work.s8_682, fnma(work.s7_201, work.s8_680, s8_2163));
  const double s8_2165 = fma(work.s7_206, work.s8_686, s8_2164);
  const double s8_2166 = fnma(0.539, projection.zdd_star[10], s8_2165);
  const double s8_2167 = fnma(work.s1_33, work.f_carrier_right_y, s8_2166);
  const double s8_2168 = fnma(work.r_carrier_right_aux1_y, work.f_carrier_right_z, s8_2167);
  const double s8_2169 = fnma(1.825625, projection.zdd_star[6], s8_2168 - work.n_carrier_right_x);
  const double s8_2170 = fma(work.s7_128, work.s8_829, fma(work.s7_115, work.s8_827, s8_2169));
  const double s8_2171 = fma(work.s7_126, work.s8_830, s8_2170);
  const double s8_2172 = fnma(0.539, projection.zdd_star[4], s8_2171);
  const double s8_2173 = fma(work.r_carrier_left_aux1_z, work.f_carrier_left_y, s8_2172);
  const double s8_2174 = fnma(work.r_carrier_left_aux1_y, work.f_carrier_left_z, s8_2173);
  const double s8_2175 = fnma(1.825625, projection.zdd_star[0], s8_2174 - work.n_carrier_left_x);
  const double s8_2176 = fma(work.s8_984, work.s8_1022, fnma(work.s8_979, work.s8_1015, s8_2175));
  const double s8_2177 = fnma(work.s8_1044, work.s8_1070, s8_2176);
  const double s8_2178 = fnma(work.s8_1032, work.s8_1084, s8_2177);
  const double s8_2179 = fma(work.s8_1099, work.s8_1129, s8_2178);
  const double s8_2180 = fnma(work.s8_1101, work.s8_1133, s8_2179);
  const double s8_2181 = fma(work.s8_1164, work.s8_1180, s8_2180);
  const double s8_2182 = fma(work.s8_1143, work.s8_1193, s8_2181);
  const double s8_2183 = fnma(work.s8_1205, work.s8_1424, s8_2182);
  const double s8_2184 = fnma(work.s8_17, work.s8_1522, fma(work.s8_1201, work.s8_1437, s8_2183));
  const double s8_2185 = fnma(work.s8_42, work.s8_1531, s8_2184);
  const double s8_2186 = fnma(work.s8_1515, work.s8_1737, s8_2185);
  const double s8_2187 = fnma(work.s8_1731, work.s8_1770, s8_2186);
  const double s8_2188 = fma(work.s8_15, work.s8_1818, fnma(work.s8_1685, work.s8_1802, s8_2187));
  const double s8_2189 = fnma(p_upper_arm_right_z, s8_2034, s8_2188);
  const double s8_2190 = fma(s8_1951, s8_2091, fnma(p_carrier_left_rz_y, s8_2036, s8_2189));
  const double s8_2191 = work.s8_708 - work.s8_666 - work.s8_687 - work.s8_831 - work.s8_846;
  const double s8_2192 = fma(0.5, s8_2191, fma(s8_1950, s8_2144, s8_2190));
  const double s8_2193 = work.s8_664 + work.s8_817 - work.s8_957;
  const double s8_2194 = fma(p_lower_arm_left_y, s8_2193, s8_2192);
  const double s8_2195 = fnma(p_lower_arm_left_z, work.s8_959 - work.s8_816, s8_2194);
  const double s8_2196 = fnma(p_arb_front_right_y, work.s8_834 - work.s8_691, s8_2195);
  const double s8_2197 = fnma(p_arb_rear_right_y, work.s8_39 - work.s8_55, s8_2196);
  const double s8_2198 = fma(work.s8_16, work.s8_1828 - work.s8_1831, s8_2197);
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double s8_2199 = work.R_chassis_x_z*tau_chassis_tx;
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  const double s8_2200 = fma(work.R_chassis_y_z, tau_chassis_ty, s8_2199);
  const double s8_2201 = fma(work.R_chassis_z_z, tau_chassis_tz, s8_2200) - work.s8_39;
  const double s8_2202 = s8_2201 - work.s8_55 - work.f_rear_axle_z;
  const double s8_2203 = fnma(work.s8_511, work.s8_577, fnma(work.s8_523, work.s8_575, s8_2202));
  const double s8_2204 = work.s8_691 + (s8_2203 - work.s8_646 - work.s8_666) - work.s8_708;
  const double s8_2205 = work.s8_834 + (s8_2204 - work.f_carrier_right_z - work.s8_817);
  const double s8_2206 = s8_2205 - work.s8_846 - work.f_carrier_left_z;
  const double s8_2207 = fnma(work.s8_16, work.s8_939, s8_2206) - work.s8_957;
  const double s8_2208 = fnma(work.s8_1515, work.s8_1734, s8_2207);
  const double s8_2209 = fnma(work.s8_1728, work.s8_1770, s8_2208);
  const double s8_2210 = fma(work.s8_20, work.s8_1821, fnma(work.s8_1582, work.s8_1802, s8_2209));
  const double s8_2211 = fma(s8_1972, s8_2091, fnma(work.s8_17, work.s8_1823, s8_2210));
  const double s8_2212 = fnma(s8_1979, s8_2198, fma(s8_1971, s8_2144, s8_2211));
  const double s8_2213 = work.R_chassis_x_y*tau_chassis_tx;
  const double s8_2214 = fma(work.R_chassis_y_y, tau_chassis_ty, s8_2213);
  const double s8_2215 = fma(work.R_chassis_z_y, tau_chassis_tz, s8_2214) - work.s8_36;
  const double s8_2216 = s8_2215 - work.s8_53 - work.f_rear_axle_y;
  const double s8_2217 = fnma(work.s8_517, work.s8_575, fnma(work.s8_511, work.s8_561, s8_2216));
  const double s8_2218 = work.s8_664 + (work.s8_648 + s8_2217) - work.s8_687 - work.s8_707;
  const double s8_2219 = s8_2218 - work.f_carrier_right_y - work.s8_816 - work.s8_831;
  const double s8_2220 = work.s8_848 + s8_2219 - work.f_carrier_left_y;
  const double s8_2221 = work.s8_959 + fma(work.s8_22, work.s8_939, s8_2220);
  const double s8_2222 = fnma(work.s8_1515, work.s8_1735, s8_2221);
  const double s8_2223 = fnma(work.s8_1729, work.s8_1770, s8_2222);
  const double s8_2224 = fnma(work.s8_1590, work.s8_1802, s8_2223);
  const double s8_2225 = fnma(work.s8_15, work.s8_1823, fnma(work.s8_16, work.s8_1821, s8_2224));
  const double s8_2226 = fnma(s8_2003, s8_2144, fnma(s8_1997, s8_2091, s8_2225));
  const double s8_2227 = fnma(s8_2017, s8_2212, fnma(s8_2010, s8_2198, s8_2226));
  const double s8_2228 = work.R_chassis_x_x*tau_chassis_tx;
  const double s8_2229 = fma(work.R_chassis_aux5_y_x, tau_chassis_ty, s8_2228);
  const double s8_2230 = work.s8_34 + fma(work.R_chassis_z_x, tau_chassis_tz, s8_2229);
  const double s8_2231 = work.s8_56 + s8_2230 - work.f_rear_axle_x;
  const double s8_2232 = fnma(work.s8_511, work.s8_576, fnma(work.s8_520, work.s8_575, s8_2231));
  const double s8_2233 = s8_2232 - work.s8_647 - work.s8_667 - work.s8_690 - work.s8_706;
  const double s8_2234 = s8_2233 - work.f_carrier_right_x - work.s8_814 - work.s8_832;
  const double s8_2235 = s8_2234 - work.s8_845 - work.f_carrier_left_x;
  const double s8_2236 = fnma(work.s8_15, work.s8_939, s8_2235) - work.s8_956;
  const double s8_2237 = fnma(work.s8_1515, work.s8_1733, s8_2236);
  const double s8_2238 = fnma(work.s8_1727, work.s8_1770, s8_2237);
  const double s8_2239 = fnma(work.s8_1570, work.s8_1802, s8_2238);
  const double s8_2240 = fma(work.s8_21, work.s8_1823, fnma(work.s8_17, work.s8_1821, s8_2239));
  const double s8_2241 = fnma(work.s8_1914, s8_2144, fma(work.s8_1871, s8_2091, s8_2240));
  const double s8_2242 = fnma(s8_1992, s8_2212, fnma(s8_1963, s8_2198, s8_2241));
  const double s8_2243 = fnma(s8_2030, s8_2227, s8_2242);
  result.inertia[0] = fnma(1e-12, work.s8_1838, pivot_chassis_tx);
  const double s8_2244 = 1.0/pivot_chassis_tx;
  // operations: 689 add, 552 multiply, 6 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double a_chassis_x = s8_2243*s8_2244;
  const double a_chassis_y = s8_2029*fnma(s8_2023, a_chassis_x, s8_2227);
  const double a_chassis_z = s8_1991*fnma(s8_2016, a_chassis_y, fnma(s8_1985, a_chassis_x,
      s8_2212));
  const double s9_1 = fnma(s8_2009, a_chassis_y, fnma(s8_1956, a_chassis_x, s8_2198));
  const double alpha_chassis_x = s8_1962*fnma(s8_1978, a_chassis_z, s9_1);
  const double s9_2 = fnma(s8_2002, a_chassis_y, fnma(work.s8_1898, a_chassis_x, s8_2144));
  const double s9_3 = fma(work.s8_1949, alpha_chassis_x, fma(s8_1970, a_chassis_z, s9_2));
  const double alpha_chassis_y = work.s8_1913*s9_3;
  const double s9_4 = fnma(s8_1996, a_chassis_y, fma(work.s8_1845, a_chassis_x, s8_2091));
  const double s9_5 = fma(work.s8_1931, alpha_chassis_x, fma(work.s8_1806, a_chassis_z, s9_4));
  const double alpha_chassis_z = work.s8_1870*fma(work.s8_1891, alpha_chassis_y, s9_5);
  const double s9_6 = fma(g_z, work.R_chassis_z_x, a_chassis_x);
  const double s9_7 = fma(g_z, work.R_chassis_z_y, a_chassis_y);
  const double s9_8 = fma(g_z, work.R_chassis_z_z, a_chassis_z);
  const double s9_9 = fma(work.R_chassis_y_y, s9_7, work.R_chassis_aux5_y_x*s9_6);
  result.zdd[Coordinate::chassis_ty] = fma(work.R_chassis_y_z, s9_8, s9_9);
  const double s9_10 = fma(work.R_chassis_x_y, s9_7, work.R_chassis_x_x*s9_6);
  result.zdd[Coordinate::chassis_tx] = fma(work.R_chassis_x_z, s9_8, s9_10);
  const double s9_11 = fma(work.R_chassis_z_y, s9_7, work.R_chassis_z_x*s9_6);
  result.zdd[Coordinate::chassis_tz] = fma(work.R_chassis_z_z, s9_8, s9_11);
  result.inertia[4] = mbgen::min(s8_2033, fms(work.s1_55, work.s1_55, 1e-12));
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  const double s9_12 = fnma(zd_chassis_rx, work.w_chassis_z, work.s4_1*work.s4_5);
  const double s9_13 = alpha_chassis_y + s9_12;
  const double s9_14 = fma(zd_chassis_rx, work.w_chassis_y, work.s4_1*work.s4_3);
  const double s9_15 = alpha_chassis_z + s9_14;
  result.zdd[Coordinate::chassis_rz] = fma(work.s1_58, s9_15, work.s1_57*s9_13);
  result.zdd[Coordinate::chassis_ry] = fnma(s1_6, s9_15, s1_9*s9_13);
  const double s9_16 = alpha_chassis_x + fma(work.s4_2, work.s4_5, work.s4_3*work.s4_4);
  result.zdd[Coordinate::chassis_rx] = fma(work.s1_61, s9_16, fma(work.s1_60, s9_15,
      work.s1_59*s9_13));
  const double s9_17 = fnma(work.s8_1568, a_chassis_x, work.s8_1802);
  const double s9_18 = fnma(work.s8_1581, a_chassis_z, fnma(work.s8_1589, a_chassis_y, s9_17));
  const double s9_19 = fnma(work.s8_1684, alpha_chassis_x, s9_18);
  const double s9_20 = fnma(work.s8_1630, alpha_chassis_y, s9_19);
  // bell_crank: bell_crank, revolute, chassis
  const double s9_21 = work.s8_1569*fnma(work.s8_1725, alpha_chassis_z, s9_20);
  const double s9_22 = fnma(work.s8_1565, a_chassis_x, work.s8_1770);
  const double s9_23 = fnma(work.s8_1575, a_chassis_z, fnma(work.s8_1585, a_chassis_y, s9_22));
  const double s9_24 = fnma(work.s8_1657, alpha_chassis_x, s9_23);
  const double s9_25 = fnma(work.s8_1610, alpha_chassis_y, s9_24);
  const double s9_26 = fnma(work.s8_1559, s9_21, fnma(work.s8_1705, alpha_chassis_z, s9_25));
  const double s9_27 = work.s8_1560*s9_26;
  const double s9_28 = fnma(work.s8_899, a_chassis_x, work.s8_1515);
  const double s9_29 = fnma(work.s8_944, a_chassis_z, fnma(work.s8_947, a_chassis_y, s9_28));
  const double s9_30 = fnma(work.s8_1297, alpha_chassis_x, s9_29);
  const double s9_31 = fnma(work.s8_1243, alpha_chassis_y, s9_30);
  const double s9_32 = fnma(work.s8_1345, s9_21, fnma(work.s8_1271, alpha_chassis_z, s9_31));
  const double s9_33 = work.s8_1532*fnma(work.s8_1392, s9_27, s9_32);
  const double s9_34 = fma(projection.Rz[0], s9_21, projection.zdd_star[0]);
  result.zdd[Coordinate::lower_arm_left] = fma(projection.Rz[2], s9_33, fma(projection.Rz[1], s9_27,
      s9_34));
  const double s9_35 = fma(projection.Rz[3], s9_21, projection.zdd_star[1]);
  result.zdd[Coordinate::carrier_left_rz] = fma(projection.Rz[5], s9_33, fma(projection.Rz[4],
      s9_27, s9_35));
  const double s9_36 = fma(projection.Rz[6], s9_21, projection.zdd_star[2]);
  result.zdd[Coordinate::carrier_left_rx] = fma(projection.Rz[8], s9_33, fma(projection.Rz[7],
      s9_27, s9_36));
  const double s9_37 = fma(projection.Rz[9], s9_21, projection.zdd_star[3]);
  result.zdd[Coordinate::carrier_left_ry] = fma(projection.Rz[11], s9_33, fma(projection.Rz[10],
      s9_27, s9_37));
  const double s9_38 = fma(projection.Rz[12], s9_21, projection.zdd_star[4]);
  result.zdd[Coordinate::upper_arm_left] = fma(projection.Rz[14], s9_33, fma(projection.Rz[13],
      s9_27, s9_38));
  const double s9_39 = fma(projection.Rz[15], s9_21, projection.zdd_star[5]);
  result.zdd[Coordinate::arb_front_left] = fma(projection.Rz[17], s9_33, fma(projection.Rz[16],
      s9_27, s9_39));
  const double s9_40 = fma(projection.Rz[18], s9_21, projection.zdd_star[6]);
  result.zdd[Coordinate::lower_arm_right] = fma(projection.Rz[20], s9_33, fma(projection.Rz[19],
      s9_27, s9_40));
  const double s9_41 = fma(projection.Rz[21], s9_21, projection.zdd_star[7]);
  result.zdd[Coordinate::carrier_right_rz] = fma(projection.Rz[23], s9_33, fma(projection.Rz[22],
      s9_27, s9_41));
  const double s9_42 = fma(projection.Rz[24], s9_21, projection.zdd_star[8]);
  result.zdd[Coordinate::carrier_right_rx] = fma(projection.Rz[26], s9_33, fma(projection.Rz[25],
      s9_27, s9_42));
  const double s9_43 = fma(projection.Rz[27], s9_21, projection.zdd_star[9]);
  result.zdd[Coordinate::carrier_right_ry] = fma(projection.Rz[29], s9_33, fma(projection.Rz[28],
      s9_27, s9_43));
  const double s9_44 = fma(projection.Rz[30], s9_21, projection.zdd_star[10]);
  result.zdd[Coordinate::upper_arm_right] = fma(projection.Rz[32], s9_33, fma(projection.Rz[31],
      s9_27, s9_44));
  const double s9_45 = fma(projection.Rz[33], s9_21, projection.zdd_star[11]);
  result.zdd[Coordinate::arb_front_right] = fma(projection.Rz[35], s9_33, fma(projection.Rz[34],
      s9_27, s9_45));
  const double s9_46 = fma(projection.Rz[36], s9_21, projection.zdd_star[12]);
  result.zdd[Coordinate::pitman_arm] = fma(projection.Rz[38], s9_33, fma(projection.Rz[37], s9_27,
      s9_46));
  const double s9_47 = fma(projection.Rz[39], s9_21, projection.zdd_star[13]);
  result.zdd[Coordinate::bell_crank] = fma(projection.Rz[41], s9_33, fma(projection.Rz[40], s9_27,
      s9_47));
  const double s9_48 = fma(work.s8_601, s9_21, work.s8_869 + alpha_chassis_x);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double alpha_carrier_left_x = fma(work.s8_613, s9_33, fma(work.s8_607, s9_27, s9_48));
  const double s9_49 = fma(work.s3_40, s9_21, work.s8_859 + alpha_chassis_y);
  const double alpha_carrier_left_y = fma(work.s3_46, s9_33, fma(work.s3_43, s9_27, s9_49));
  const double s9_50 = fma(work.s3_31, s9_21, work.s8_856 + alpha_chassis_z);
  const double alpha_carrier_left_z = fma(work.s3_37, s9_33, fma(work.s3_34, s9_27, s9_50));
  const double s9_51 = fma(work.s8_604, s9_21, work.s8_735 + alpha_chassis_x);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double alpha_carrier_right_x = fma(work.s8_616, s9_33, fma(work.s8_610, s9_27, s9_51));
  const double s9_52 = fma(work.s3_58, s9_21, work.s8_724 + alpha_chassis_y);
  const double alpha_carrier_right_y = fma(work.s3_64, s9_33, fma(work.s3_61, s9_27, s9_52));
  const double s9_53 = fma(work.s3_49, s9_21, work.s8_721 + alpha_chassis_z);
  const double alpha_carrier_right_z = fma(work.s3_55, s9_33, fma(work.s3_52, s9_27, s9_53));
  const double s9_54 = 0.09090909090909091*tau[Coordinate::wheel_front_left];
  const double s9_55 = fma(work.s1_22, alpha_carrier_left_x, s9_54);
  const double s9_56 = fnma(work.R_carrier_left_aux2_y_y, alpha_carrier_left_y, s9_55);
  result.zdd[Coordinate::wheel_front_left] = fnma(work.R_carrier_left_aux2_z_y,
      alpha_carrier_left_z, s9_56);
  const double s9_57 = 0.09090909090909091*tau[Coordinate::wheel_front_right];
  const double s9_58 = fma(work.s1_35, alpha_carrier_right_x, s9_57);
  const double s9_59 = fnma(work.R_carrier_right_aux2_y_y, alpha_carrier_right_y, s9_58);
  result.zdd[Coordinate::wheel_front_right] = fnma(work.R_carrier_right_aux2_z_y,
      alpha_carrier_right_z, s9_59);
  const double s9_60 = fnma(work.s8_519, a_chassis_x, work.s8_575);
  const double s9_61 = fnma(work.s8_522, a_chassis_z, fnma(work.s8_515, a_chassis_y, s9_60));
  const double s9_62 = fnma(work.s8_534, alpha_chassis_x, s9_61);
  const double s9_63 = fnma(work.s8_559, alpha_chassis_y, s9_62);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s9_64 = work.s8_516*fnma(work.s8_546, alpha_chassis_z, s9_63);
  const double s9_65 = fnma(work.s8_109, a_chassis_x, work.s8_511);
  const double s9_66 = fnma(work.s8_114, a_chassis_z, fnma(work.s8_127, a_chassis_y, s9_65));
  const double s9_67 = fnma(work.s8_401, alpha_chassis_x, s9_66);
  const double s9_68 = fnma(work.s8_424, alpha_chassis_y, s9_67);
  const double s9_69 = fnma(work.s8_448, s9_64, fnma(work.s8_412, alpha_chassis_z, s9_68));
  const double s9_70 = work.s8_512*s9_69;
  const double s9_71 = fma(projection.Rz[42], s9_64, projection.zdd_star[14]);
  result.zdd[Coordinate::rear_axle_tx] = fma(projection.Rz[43], s9_70, s9_71);
  const double s9_72 = fma(projection.Rz[44], s9_64, projection.zdd_star[15]);
  result.zdd[Coordinate::rear_axle_ty] = fma(projection.Rz[45], s9_70, s9_72);
  const double s9_73 = fma(projection.Rz[46], s9_64, projection.zdd_star[16]);
  result.zdd[Coordinate::rear_axle_tz] = fma(projection.Rz[47], s9_70, s9_73);
  const double s9_74 = fma(projection.Rz[48], s9_64, projection.zdd_star[17]);
  result.zdd[Coordinate::rear_axle_rz] = fma(projection.Rz[49], s9_70, s9_74);
  const double s9_75 = fma(projection.Rz[50], s9_64, projection.zdd_star[18]);
  result.zdd[Coordinate::rear_axle_ry] = fma(projection.Rz[51], s9_70, s9_75);
  const double s9_76 = fma(projection.Rz[52], s9_64, projection.zdd_star[19]);
  result.zdd[Coordinate::rear_axle_rx] = fma(projection.Rz[53], s9_70, s9_76);
  const double s9_77 = fma(projection.Rz[54], s9_64, projection.zdd_star[20]);
  result.zdd[Coordinate::arb_rear_left] = fma(projection.Rz[55], s9_70, s9_77);
  const double s9_78 = fma(projection.Rz[56], s9_64, projection.zdd_star[21]);
  result.zdd[Coordinate::arb_rear_right] = fma(projection.Rz[57], s9_70, s9_78);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s9_79 = fma(work.s3_13, s9_64, work.s8_79 + alpha_chassis_x);
  const double alpha_rear_axle_x = fma(work.s3_16, s9_70, s9_79);
  const double s9_80 = fma(work.s3_2, s9_64, work.s8_67 + alpha_chassis_y);
  const double alpha_rear_axle_y = fma(work.s3_4, s9_70, s9_80);
  const double s9_81 = fma(work.s3_7, s9_64, work.s8_64 + alpha_chassis_z);
  const double alpha_rear_axle_z = fma(work.s3_10, s9_70, s9_81);
  const double s9_82 = work.R_rear_axle_x_y*alpha_rear_axle_x;
  const double s9_83 = fma(work.R_rear_axle_y_y, alpha_rear_axle_y, s9_82);
  const double s9_84 = fma(work.R_rear_axle_z_y, alpha_rear_axle_z, s9_83);
  result.zdd[Coordinate::wheel_rear_left] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_left], s9_84);
  result.zdd[Coordinate::wheel_rear_right] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_right], s9_84);
  // operations: 170 add, 181 multiply, 1 other
}

/// All accelerations with a partition chosen at run time.
void compute_chosen_accelerations(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, const double* tau, const Projection& projection,
    ChosenAccelerations& __restrict result) noexcept {
  ChosenAccelerationsWork work;
  compute_chosen_accelerations_1(state, tau, projection, work, result);
  compute_chosen_accelerations_2(state, tau, projection, work, result);
  compute_chosen_accelerations_3(state, tau, projection, work);
  compute_chosen_accelerations_4(state, tau, projection, work);
  compute_chosen_accelerations_5(state, projection, work, result);
  compute_chosen_accelerations_6(state, tau, projection, work, result);
}
#endif  // part 1

void compute_outputs(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, const Derivative& derivative, Outputs& __restrict result) noexcept;

#if MBGEN_IS_PART(1)
/// Values of compute_outputs that cross its parts.
struct OutputsWork {
  double
      sines[22], cosines[22], r_chassis_aux3_z, R_chassis_z_x, R_chassis_z_y, R_chassis_z_z,
      r_carrier_left_aux1_y, r_carrier_left_aux1_z, s1_22, R_carrier_left_aux2_y_y,
      R_carrier_left_aux2_z_y, R_carrier_left_x_x, R_carrier_left_x_z, R_carrier_left_y_x,
      R_carrier_left_y_z, R_carrier_left_z_x, R_carrier_left_z_z, r_wheel_front_left_x,
      r_wheel_front_left_y, r_wheel_front_left_z, r_carrier_right_aux1_y, s1_39, s1_41,
      R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, R_carrier_right_x_x, R_carrier_right_x_z,
      R_carrier_right_y_x, R_carrier_right_y_z, R_carrier_right_z_x, R_carrier_right_z_z,
      r_wheel_front_right_x, r_wheel_front_right_y, r_wheel_front_right_z, r_rear_axle_aux1_x,
      r_rear_axle_aux3_z, R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, R_rear_axle_aux5_z_x,
      R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z, R_rear_axle_z_y,
      R_rear_axle_z_z, r_wheel_rear_left_x, r_wheel_rear_left_y, r_wheel_rear_left_z,
      r_wheel_rear_right_x, r_wheel_rear_right_y, r_wheel_rear_right_z, v_chassis_x, v_chassis_y,
      v_chassis_z, w_chassis_x, w_chassis_y, w_chassis_z, s4_4, v_lower_arm_left_x,
      v_lower_arm_left_y, s4_6, v_lower_arm_left_z, w_lower_arm_left_x, v_carrier_left_aux1_x,
      v_carrier_left_aux1_y, v_carrier_left_aux1_z, w_carrier_left_x, w_carrier_left_y,
      w_carrier_left_z, v_wheel_front_left_x, v_wheel_front_left_y, v_wheel_front_left_z,
      w_wheel_front_left_x, w_wheel_front_left_y, w_wheel_front_left_z, v_upper_arm_left_x,
      v_upper_arm_left_y, v_upper_arm_left_z, w_upper_arm_left_x, v_arb_front_left_x,
      v_arb_front_left_y, v_arb_front_left_z, w_arb_front_left_y, s4_17, v_lower_arm_right_x, s4_18,
      v_lower_arm_right_z, w_lower_arm_right_x, v_carrier_right_aux1_x, v_carrier_right_aux1_y,
      v_carrier_right_aux1_z, w_carrier_right_x, w_carrier_right_y, w_carrier_right_z,
      v_wheel_front_right_x, v_wheel_front_right_y, v_wheel_front_right_z, w_wheel_front_right_x,
      w_wheel_front_right_y, w_wheel_front_right_z, v_upper_arm_right_x, v_upper_arm_right_z,
      w_upper_arm_right_x, v_arb_front_right_x, v_arb_front_right_z, w_arb_front_right_y,
      v_pitman_arm_x, v_pitman_arm_y, v_pitman_arm_z, w_pitman_arm_y, v_bell_crank_x,
      v_bell_crank_y, v_bell_crank_z, w_bell_crank_z, v_rear_axle_aux3_x, v_rear_axle_aux3_y,
      v_rear_axle_aux3_z, w_rear_axle_x, w_rear_axle_y, w_rear_axle_z, v_wheel_rear_left_x,
      v_wheel_rear_left_y, v_wheel_rear_left_z, w_wheel_rear_left_x, w_wheel_rear_left_y,
      w_wheel_rear_left_z, v_arb_rear_left_x, v_arb_rear_left_y, v_arb_rear_left_z,
      w_arb_rear_left_y, v_wheel_rear_right_x, v_wheel_rear_right_y, v_wheel_rear_right_z,
      w_wheel_rear_right_x, w_wheel_rear_right_y, w_wheel_rear_right_z, v_arb_rear_right_x,
      v_arb_rear_right_z, w_arb_rear_right_y, s7_2, s7_4, s7_7, s7_10, s7_13, s7_15, s7_17, s7_20,
      s7_23, s7_26, s7_27, s7_28, s7_29, s7_30, s7_33, s7_34, s7_37, s7_40, s7_43, s7_44, s7_45,
      s7_46;
};

/// Part 1 of compute_outputs: step 1: poses and axes b; step 4: velocities; step 7: inertias of the
/// bodies and forces on joints.
[[gnu::noinline]] void compute_outputs_1(const State& state,
    OutputsWork& __restrict work) noexcept {
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
  mbgen::sincos(angles, work.sines, work.cosines);
  // chassis_aux3: chassis_tz, prismatic, chassis_aux2
  work.r_chassis_aux3_z = 1.0 + state.z[Coordinate::chassis_tz];
  const double s1_1 = state.charts[0] - 0.5;
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_y_x = work.sines[0];
  const double s1_2 = work.cosines[1];
  const double R_chassis_aux5_y_x = R_chassis_aux4_y_x*s1_2;
  const double s1_3 = work.sines[1];
  const double s1_4 = -s1_3;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double R_chassis_aux4_y_y = work.cosines[0];
  const double s1_5 = R_chassis_aux4_y_y*s1_2;
  const double R_chassis_x_x = (s1_1 >= 0.0 ? s1_4 : s1_5);
  const double s1_6 = work.sines[2];
  const double s1_7 = s1_2*s1_6;
  const double s1_8 = s1_3*s1_6;
  const double s1_9 = work.cosines[2];
  const double s1_10 = fnma(R_chassis_aux4_y_x, s1_9, R_chassis_aux4_y_y*s1_8);
  const double R_chassis_x_y = (s1_1 >= 0.0 ? s1_7 : s1_10);
  const double s1_11 = s1_2*s1_9;
  const double s1_12 = s1_3*s1_9;
  const double s1_13 = fma(R_chassis_aux4_y_y, s1_12, R_chassis_aux4_y_x*s1_6);
  const double R_chassis_x_z = (s1_1 >= 0.0 ? s1_11 : s1_13);
  const double R_chassis_y_y = fma(R_chassis_aux4_y_y, s1_9, R_chassis_aux4_y_x*s1_8);
  const double R_chassis_y_z = fnma(R_chassis_aux4_y_y, s1_6, R_chassis_aux4_y_x*s1_12);
  work.R_chassis_z_x = (s1_1 >= 0.0 ? -s1_5 : s1_4);
  work.R_chassis_z_y = (s1_1 >= 0.0 ? -s1_10 : s1_7);
  work.R_chassis_z_z = (s1_1 >= 0.0 ? -s1_13 : s1_11);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_lower_arm_left_y_z = -R_lower_arm_left_z_y;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s1_14 = state.charts[1] - 0.5;
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_carrier_left_aux1_z_z = (s1_14 >= 0.0 ? R_lower_arm_left_y_z :
      R_lower_arm_left_y_y);
  const double s1_15 = work.sines[4];
  const double R_carrier_left_aux1_y_x = s1_15*R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_carrier_left_aux1_x_x*R_carrier_left_aux1_z_z;
  const double R_carrier_left_aux1_y_z = (s1_14 >= 0.0 ? -R_lower_arm_left_y_y :
      R_lower_arm_left_y_z);
  const double s1_16 = (s1_14 >= 0.0 ? R_lower_arm_left_y_y : R_lower_arm_left_z_y);
  const double R_carrier_left_aux1_z_x = s1_15*s1_16;
  const double R_carrier_left_aux1_z_y = R_carrier_left_aux1_x_x*s1_16;
  const double s1_17 = p_carrier_left_rz_y*R_lower_arm_left_y_y;
  const double s1_18 = fnma(p_carrier_left_rz_z, R_lower_arm_left_z_y, s1_17);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + s1_18;
  const double s1_19 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_20 = fma(p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_19);
  work.r_carrier_left_aux1_z = s1_20 + p_lower_arm_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_21 = work.cosines[5];
  work.s1_22 = s1_15*s1_21;
  const double s1_23 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_15*s1_23;
  work.R_carrier_left_aux2_y_y = fma(R_carrier_left_aux1_y_z, s1_23, R_carrier_left_aux1_y_y*s1_21);
  const double R_carrier_left_aux2_y_z = fnma(R_carrier_left_aux1_y_y, s1_23,
      R_carrier_left_aux1_y_z*s1_21);
  work.R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_z, s1_23, R_carrier_left_aux1_z_y*s1_21);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_23,
      R_carrier_left_aux1_z_z*s1_21);
  const double s1_24 = work.cosines[6];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = work.sines[6];
  work.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_25, R_carrier_left_aux1_x_x*s1_24);
  work.R_carrier_left_x_z = fma(R_carrier_left_aux1_x_x, s1_25, R_carrier_left_aux2_x_z*s1_24);
  work.R_carrier_left_y_x = fnma(R_carrier_left_aux2_y_z, s1_25, R_carrier_left_aux1_y_x*s1_24);
  work.R_carrier_left_y_z = fma(R_carrier_left_aux1_y_x, s1_25, R_carrier_left_aux2_y_z*s1_24);
  work.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_25, R_carrier_left_aux1_z_x*s1_24);
  work.R_carrier_left_z_z = fma(R_carrier_left_aux1_z_x, s1_25, R_carrier_left_aux2_z_z*s1_24);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_26 = p_wheel_front_left_z*work.R_carrier_left_x_z;
  const double s1_27 = fnma(p_wheel_front_left_y, work.s1_22, s1_26);
  work.r_wheel_front_left_x = p_lower_arm_left_x + s1_27;
  const double s1_28 = p_wheel_front_left_y*work.R_carrier_left_aux2_y_y;
  const double s1_29 = fma(p_wheel_front_left_z, work.R_carrier_left_y_z, s1_28);
  work.r_wheel_front_left_y = work.r_carrier_left_aux1_y + s1_29;
  const double s1_30 = p_wheel_front_left_y*work.R_carrier_left_aux2_z_y;
  const double s1_31 = fma(p_wheel_front_left_z, work.R_carrier_left_z_z, s1_30);
  work.r_wheel_front_left_z = work.r_carrier_left_aux1_z + s1_31;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_z = -R_lower_arm_right_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s1_32 = state.charts[2] - 0.5;
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_carrier_right_aux1_z_z = (s1_32 >= 0.0 ? R_lower_arm_right_y_z :
      R_lower_arm_right_y_y);
  const double s1_33 = work.sines[10];
  const double R_carrier_right_aux1_y_x = s1_33*R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_carrier_right_aux1_x_x*R_carrier_right_aux1_z_z;
  const double R_carrier_right_aux1_y_z = (s1_32 >= 0.0 ? -R_lower_arm_right_y_y :
      R_lower_arm_right_y_z);
  const double s1_34 = (s1_32 >= 0.0 ? R_lower_arm_right_y_y : R_lower_arm_right_z_y);
  const double R_carrier_right_aux1_z_x = s1_33*s1_34;
  const double R_carrier_right_aux1_z_y = R_carrier_right_aux1_x_x*s1_34;
  const double s1_35 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  const double s1_36 = fma(p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_35);
  work.r_carrier_right_aux1_y = s1_36 + p_lower_arm_right_y;
  const double s1_37 = -p_carrier_right_rz_z*R_lower_arm_right_y_y;
  const double s1_38 = fnma(p_carrier_right_rz_y, R_lower_arm_right_z_y, s1_37);
  work.s1_39 = s1_38 - p_lower_arm_right_z;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_40 = work.cosines[11];
  work.s1_41 = s1_33*s1_40;
  const double s1_42 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_33*s1_42;
  work.R_carrier_right_aux2_y_y = fma(R_carrier_right_aux1_y_z, s1_42,
      R_carrier_right_aux1_y_y*s1_40);
  const double R_carrier_right_aux2_y_z = fnma(R_carrier_right_aux1_y_y, s1_42,
      R_carrier_right_aux1_y_z*s1_40);
  work.R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_z, s1_42,
      R_carrier_right_aux1_z_y*s1_40);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_42,
      R_carrier_right_aux1_z_z*s1_40);
  const double s1_43 = work.cosines[12];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_44 = work.sines[12];
  work.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_44, R_carrier_right_aux1_x_x*s1_43);
  work.R_carrier_right_x_z = fma(R_carrier_right_aux1_x_x, s1_44, R_carrier_right_aux2_x_z*s1_43);
  work.R_carrier_right_y_x = fnma(R_carrier_right_aux2_y_z, s1_44, R_carrier_right_aux1_y_x*s1_43);
  work.R_carrier_right_y_z = fma(R_carrier_right_aux1_y_x, s1_44, R_carrier_right_aux2_y_z*s1_43);
  work.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_44, R_carrier_right_aux1_z_x*s1_43);
  work.R_carrier_right_z_z = fma(R_carrier_right_aux1_z_x, s1_44, R_carrier_right_aux2_z_z*s1_43);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_45 = -p_wheel_front_right_y*work.s1_41;
  const double s1_46 = fma(p_wheel_front_right_z, work.R_carrier_right_x_z, s1_45);
  work.r_wheel_front_right_x = p_lower_arm_right_x + s1_46;
  const double s1_47 = p_wheel_front_right_z*work.R_carrier_right_y_z;
  const double s1_48 = fma(p_wheel_front_right_y, work.R_carrier_right_aux2_y_y, s1_47);
  work.r_wheel_front_right_y = work.r_carrier_right_aux1_y + s1_48;
  const double s1_49 = p_wheel_front_right_z*work.R_carrier_right_z_z;
  const double s1_50 = fma(p_wheel_front_right_y, work.R_carrier_right_aux2_z_y, s1_49);
  work.r_wheel_front_right_z = s1_50 - work.s1_39;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] + p_rear_axle_tx_x;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double z_rear_axle_tz = state.z[Coordinate::rear_axle_tz];
  work.r_rear_axle_aux3_z = z_rear_axle_tz + p_rear_axle_tx_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double s1_51 = state.charts[3] - 0.5;
  const double R_rear_axle_aux4_z_z = (s1_51 >= 0.0 ? 0.0 : 1.0);
  const double R_rear_axle_aux4_y_y = work.cosines[17];
  const double R_rear_axle_aux4_x_x = R_rear_axle_aux4_y_y*R_rear_axle_aux4_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  const double s1_52 = R_rear_axle_aux4_z_z*R_rear_axle_aux4_y_x;
  const double R_rear_axle_aux4_x_z = (s1_51 >= 0.0 ? 1.0 : 0.0);
  const double s1_53 = (s1_51 >= 0.0 ? -1.0 : 0.0);
  const double R_rear_axle_aux4_z_x = R_rear_axle_aux4_y_y*s1_53;
  const double s1_54 = R_rear_axle_aux4_y_x*s1_53;
  const double s1_55 = work.cosines[18];
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s1_56 = work.sines[18];
  work.R_rear_axle_aux5_x_x = fnma(R_rear_axle_aux4_x_z, s1_56, R_rear_axle_aux4_x_x*s1_55);
  const double R_rear_axle_aux5_x_z = fma(R_rear_axle_aux4_x_x, s1_56, R_rear_axle_aux4_x_z*s1_55);
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*s1_55;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_56;
  work.R_rear_axle_aux5_z_x = fnma(R_rear_axle_aux4_z_z, s1_56, R_rear_axle_aux4_z_x*s1_55);
  const double R_rear_axle_aux5_z_z = fma(R_rear_axle_aux4_z_x, s1_56, R_rear_axle_aux4_z_z*s1_55);
  const double s1_57 = work.sines[19];
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_58 = work.cosines[19];
  work.R_rear_axle_x_y = fnma(s1_52, s1_58, R_rear_axle_aux5_x_z*s1_57);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_58, s1_52*s1_57);
  work.R_rear_axle_y_y = fma(R_rear_axle_aux4_y_y, s1_58, R_rear_axle_aux5_y_z*s1_57);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_y_y, s1_57, R_rear_axle_aux5_y_z*s1_58);
  work.R_rear_axle_z_y = fnma(s1_54, s1_58, R_rear_axle_aux5_z_z*s1_57);
  work.R_rear_axle_z_z = fma(R_rear_axle_aux5_z_z, s1_58, s1_54*s1_57);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_59 = p_wheel_rear_left_y*work.R_rear_axle_x_y;
  work.r_wheel_rear_left_x = work.r_rear_axle_aux1_x + s1_59;
  const double s1_60 = p_wheel_rear_left_y*work.R_rear_axle_y_y;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.r_wheel_rear_left_y = z_rear_axle_ty + s1_60;
  const double s1_61 = p_wheel_rear_left_y*work.R_rear_axle_z_y;
  work.r_wheel_rear_left_z = work.r_rear_axle_aux3_z + s1_61;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  work.r_wheel_rear_right_x = work.r_rear_axle_aux1_x - s1_59;
  work.r_wheel_rear_right_y = z_rear_axle_ty - s1_60;
  work.r_wheel_rear_right_z = work.r_rear_axle_aux3_z - s1_61;
  // operations: 67 add, 115 multiply, 44 sin cos, 15 other

  // --- step 4: velocities ---
  const double zd_chassis_ty = state.zd[Coordinate::chassis_ty];
  const double zd_chassis_tx = state.zd[Coordinate::chassis_tx];
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_tz = state.zd[Coordinate::chassis_tz];
  const double s4_1 = fma(zd_chassis_tx, R_chassis_x_x, zd_chassis_ty*R_chassis_aux5_y_x);
  work.v_chassis_x = fma(zd_chassis_tz, work.R_chassis_z_x, s4_1);
  const double s4_2 = fma(zd_chassis_ty, R_chassis_y_y, zd_chassis_tx*R_chassis_x_y);
  work.v_chassis_y = fma(zd_chassis_tz, work.R_chassis_z_y, s4_2);
  const double s4_3 = fma(zd_chassis_ty, R_chassis_y_z, zd_chassis_tx*R_chassis_x_z);
  work.v_chassis_z = fma(zd_chassis_tz, work.R_chassis_z_z, s4_3);
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  work.w_chassis_x = fnma(zd_chassis_rz, s1_3, state.zd[Coordinate::chassis_rx]);
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.w_chassis_y = fma(zd_chassis_ry, s1_9, zd_chassis_rz*s1_7);
  work.w_chassis_z = fnma(zd_chassis_ry, s1_6, zd_chassis_rz*s1_11);
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s4_4 = fnma(p_lower_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_lower_arm_left_x = fma(p_lower_arm_left_z, work.w_chassis_y, work.s4_4);
  const double s4_5 = fnma(p_lower_arm_left_z, work.w_chassis_x, work.v_chassis_y);
  work.v_lower_arm_left_y = fma(p_lower_arm_left_x, work.w_chassis_z, s4_5);
  work.s4_6 = fma(p_lower_arm_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_lower_arm_left_z = fnma(p_lower_arm_left_x, work.w_chassis_y, work.s4_6);
  work.w_lower_arm_left_x = state.zd[Coordinate::lower_arm_left] + work.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s4_7 = fnma(s1_18, work.w_chassis_z, s1_20*work.w_chassis_y);
  work.v_carrier_left_aux1_x = work.v_lower_arm_left_x + s4_7;
  work.v_carrier_left_aux1_y = fnma(s1_20, work.w_lower_arm_left_x, work.v_lower_arm_left_y);
  work.v_carrier_left_aux1_z = fma(s1_18, work.w_lower_arm_left_x, work.v_lower_arm_left_z);
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double w_carrier_left_aux1_y = fma(zd_carrier_left_rz, R_carrier_left_aux1_y_z,
      work.w_chassis_y);
  const double w_carrier_left_aux1_z = fma(zd_carrier_left_rz, R_carrier_left_aux1_z_z,
      work.w_chassis_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double w_carrier_left_aux2_x = fma(zd_carrier_left_rx, R_carrier_left_aux1_x_x,
      work.w_lower_arm_left_x);
  const double w_carrier_left_aux2_y = fma(zd_carrier_left_rx, R_carrier_left_aux1_y_x,
      w_carrier_left_aux1_y);
  const double w_carrier_left_aux2_z = fma(zd_carrier_left_rx, R_carrier_left_aux1_z_x,
      w_carrier_left_aux1_z);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.w_carrier_left_x = fnma(zd_carrier_left_ry, work.s1_22, w_carrier_left_aux2_x);
  work.w_carrier_left_y = fma(zd_carrier_left_ry, work.R_carrier_left_aux2_y_y,
      w_carrier_left_aux2_y);
  work.w_carrier_left_z = fma(zd_carrier_left_ry, work.R_carrier_left_aux2_z_y,
      w_carrier_left_aux2_z);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s4_8 = fma(s1_31, work.w_carrier_left_y, work.v_carrier_left_aux1_x);
  work.v_wheel_front_left_x = fnma(s1_29, work.w_carrier_left_z, s4_8);
  const double s4_9 = fnma(s1_31, work.w_carrier_left_x, work.v_carrier_left_aux1_y);
  work.v_wheel_front_left_y = fma(s1_27, work.w_carrier_left_z, s4_9);
  const double s4_10 = fma(s1_29, work.w_carrier_left_x, work.v_carrier_left_aux1_z);
  work.v_wheel_front_left_z = fnma(s1_27, work.w_carrier_left_y, s4_10);
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  work.w_wheel_front_left_x = fnma(zd_wheel_front_left, work.s1_22, work.w_carrier_left_x);
  work.w_wheel_front_left_y = fma(zd_wheel_front_left, work.R_carrier_left_aux2_y_y,
      work.w_carrier_left_y);
  work.w_wheel_front_left_z = fma(zd_wheel_front_left, work.R_carrier_left_aux2_z_y,
      work.w_carrier_left_z);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s4_11 = fma(p_upper_arm_left_z, work.w_chassis_y, work.v_chassis_x);
  work.v_upper_arm_left_x = fnma(p_upper_arm_left_y, work.w_chassis_z, s4_11);
  const double s4_12 = fnma(p_upper_arm_left_z, work.w_chassis_x, work.v_chassis_y);
  work.v_upper_arm_left_y = fma(p_lower_arm_left_x, work.w_chassis_z, s4_12);
  const double s4_13 = fnma(p_lower_arm_left_x, work.w_chassis_y, work.v_chassis_z);
  work.v_upper_arm_left_z = fma(p_upper_arm_left_y, work.w_chassis_x, s4_13);
  work.w_upper_arm_left_x = state.zd[Coordinate::upper_arm_left] + work.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s4_14 = fma(p_arb_front_left_z, work.w_chassis_y, work.v_chassis_x);
  work.v_arb_front_left_x = fnma(p_arb_front_left_y, work.w_chassis_z, s4_14);
  const double s4_15 = fma(p_arb_front_left_x, work.w_chassis_z, work.v_chassis_y);
  work.v_arb_front_left_y = fma(p_upper_arm_left_y, work.w_chassis_x, s4_15);
  const double s4_16 = fma(p_arb_front_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_arb_front_left_z = fnma(p_arb_front_left_x, work.w_chassis_y, s4_16);
  work.w_arb_front_left_y = state.zd[Coordinate::arb_front_left] + work.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s4_17 = fma(p_lower_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_lower_arm_right_x = fma(p_lower_arm_left_z, work.w_chassis_y, work.s4_17);
  work.s4_18 = fnma(p_lower_arm_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_lower_arm_right_z = fnma(p_lower_arm_left_x, work.w_chassis_y, work.s4_18);
  work.w_lower_arm_right_x = state.zd[Coordinate::lower_arm_right] + work.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s4_19 = fnma(s1_38, work.w_chassis_y, work.v_lower_arm_right_x);
  work.v_carrier_right_aux1_x = fnma(s1_36, work.w_chassis_z, s4_19);
  work.v_carrier_right_aux1_y = fma(s1_38, work.w_lower_arm_right_x, work.v_lower_arm_left_y);
  work.v_carrier_right_aux1_z = fma(s1_36, work.w_lower_arm_right_x, work.v_lower_arm_right_z);
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double w_carrier_right_aux1_y = fma(zd_carrier_right_rz, R_carrier_right_aux1_y_z,
      work.w_chassis_y);
  const double w_carrier_right_aux1_z = fma(zd_carrier_right_rz, R_carrier_right_aux1_z_z,
      work.w_chassis_z);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double w_carrier_right_aux2_x = fma(zd_carrier_right_rx, R_carrier_right_aux1_x_x,
      work.w_lower_arm_right_x);
  const double w_carrier_right_aux2_y = fma(zd_carrier_right_rx, R_carrier_right_aux1_y_x,
      w_carrier_right_aux1_y);
  const double w_carrier_right_aux2_z = fma(zd_carrier_right_rx, R_carrier_right_aux1_z_x,
      w_carrier_right_aux1_z);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.w_carrier_right_x = fnma(zd_carrier_right_ry, work.s1_41, w_carrier_right_aux2_x);
  work.w_carrier_right_y = fma(zd_carrier_right_ry, work.R_carrier_right_aux2_y_y,
      w_carrier_right_aux2_y);
  work.w_carrier_right_z = fma(zd_carrier_right_ry, work.R_carrier_right_aux2_z_y,
      w_carrier_right_aux2_z);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s4_20 = fma(s1_50, work.w_carrier_right_y, work.v_carrier_right_aux1_x);
  work.v_wheel_front_right_x = fnma(s1_48, work.w_carrier_right_z, s4_20);
  const double s4_21 = fnma(s1_50, work.w_carrier_right_x, work.v_carrier_right_aux1_y);
  work.v_wheel_front_right_y = fma(s1_46, work.w_carrier_right_z, s4_21);
  const double s4_22 = fma(s1_48, work.w_carrier_right_x, work.v_carrier_right_aux1_z);
  work.v_wheel_front_right_z = fnma(s1_46, work.w_carrier_right_y, s4_22);
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  work.w_wheel_front_right_x = fnma(zd_wheel_front_right, work.s1_41, work.w_carrier_right_x);
  work.w_wheel_front_right_y = fma(zd_wheel_front_right, work.R_carrier_right_aux2_y_y,
      work.w_carrier_right_y);
  work.w_wheel_front_right_z = fma(zd_wheel_front_right, work.R_carrier_right_aux2_z_y,
      work.w_carrier_right_z);
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.v_upper_arm_right_x = fma(p_upper_arm_left_y, work.w_chassis_z, s4_11);
  work.v_upper_arm_right_z = fnma(p_upper_arm_left_y, work.w_chassis_x, s4_13);
  work.w_upper_arm_right_x = state.zd[Coordinate::upper_arm_right] + work.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  work.v_arb_front_right_x = fma(p_arb_front_left_y, work.w_chassis_z, s4_14);
  const double s4_23 = fnma(p_arb_front_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_arb_front_right_z = fnma(p_arb_front_left_x, work.w_chassis_y, s4_23);
  work.w_arb_front_right_y = state.zd[Coordinate::arb_front_right] + work.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s4_24 = fma(p_pitman_arm_z, work.w_chassis_y, work.v_chassis_x);
  work.v_pitman_arm_x = fnma(p_upper_arm_left_y, work.w_chassis_z, s4_24);
  const double s4_25 = fma(p_pitman_arm_x, work.w_chassis_z, work.v_chassis_y);
  work.v_pitman_arm_y = fma(p_lower_arm_left_y, work.w_chassis_x, s4_25);
  const double s4_26 = fnma(p_pitman_arm_x, work.w_chassis_y, work.v_chassis_z);
  work.v_pitman_arm_z = fma(p_upper_arm_left_y, work.w_chassis_x, s4_26);
  work.w_pitman_arm_y = state.zd[Coordinate::pitman_arm] + work.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  work.v_bell_crank_x = fma(p_bell_crank_z, work.w_chassis_y, work.v_chassis_x);
  const double s4_27 = fnma(p_bell_crank_z, work.w_chassis_x, work.v_chassis_y);
  work.v_bell_crank_y = fma(p_bell_crank_x, work.w_chassis_z, s4_27);
  work.v_bell_crank_z = fnma(p_bell_crank_x, work.w_chassis_y, work.v_chassis_z);
  work.w_bell_crank_z = state.zd[Coordinate::bell_crank] + work.w_chassis_z;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double s4_28 = state.zd[Coordinate::rear_axle_tx] + work.v_chassis_x;
  const double v_rear_axle_aux1_x = fma(p_arb_front_left_z, work.w_chassis_y, s4_28);
  const double s4_29 = fma(work.r_rear_axle_aux1_x, work.w_chassis_z, work.v_chassis_y);
  const double v_rear_axle_aux1_y = fma(p_upper_arm_left_y, work.w_chassis_x, s4_29);
  const double v_rear_axle_aux1_z = fnma(work.r_rear_axle_aux1_x, work.w_chassis_y,
      work.v_chassis_z);
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double v_rear_axle_aux2_x = fnma(z_rear_axle_ty, work.w_chassis_z, v_rear_axle_aux1_x);
  const double v_rear_axle_aux2_y = state.zd[Coordinate::rear_axle_ty] + v_rear_axle_aux1_y;
  const double v_rear_axle_aux2_z = fma(z_rear_axle_ty, work.w_chassis_x, v_rear_axle_aux1_z);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.v_rear_axle_aux3_x = fma(z_rear_axle_tz, work.w_chassis_y, v_rear_axle_aux2_x);
  work.v_rear_axle_aux3_y = fnma(z_rear_axle_tz, work.w_chassis_x, v_rear_axle_aux2_y);
  work.v_rear_axle_aux3_z = state.zd[Coordinate::rear_axle_tz] + v_rear_axle_aux2_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double w_rear_axle_aux4_x = fma(zd_rear_axle_rz, R_rear_axle_aux4_x_z, work.w_chassis_x);
  const double w_rear_axle_aux4_z = fma(zd_rear_axle_rz, R_rear_axle_aux4_z_z, work.w_chassis_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double w_rear_axle_aux5_x = fnma(zd_rear_axle_ry, s1_52, w_rear_axle_aux4_x);
  const double w_rear_axle_aux5_y = fma(zd_rear_axle_ry, R_rear_axle_aux4_y_y, work.w_chassis_y);
  const double w_rear_axle_aux5_z = fnma(zd_rear_axle_ry, s1_54, w_rear_axle_aux4_z);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.w_rear_axle_x = fma(zd_rear_axle_rx, work.R_rear_axle_aux5_x_x, w_rear_axle_aux5_x);
  work.w_rear_axle_y = fma(zd_rear_axle_rx, work.R_rear_axle_aux5_y_x, w_rear_axle_aux5_y);
  work.w_rear_axle_z = fma(zd_rear_axle_rx, work.R_rear_axle_aux5_z_x, w_rear_axle_aux5_z);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s4_30 = fma(s1_61, work.w_rear_axle_y, work.v_rear_axle_aux3_x);
  work.v_wheel_rear_left_x = fnma(s1_60, work.w_rear_axle_z, s4_30);
  const double s4_31 = fma(s1_59, work.w_rear_axle_z, work.v_rear_axle_aux3_y);
  work.v_wheel_rear_left_y = fnma(s1_61, work.w_rear_axle_x, s4_31);
  const double s4_32 = fma(s1_60, work.w_rear_axle_x, work.v_rear_axle_aux3_z);
  work.v_wheel_rear_left_z = fnma(s1_59, work.w_rear_axle_y, s4_32);
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  work.w_wheel_rear_left_x = fma(zd_wheel_rear_left, work.R_rear_axle_x_y, work.w_rear_axle_x);
  work.w_wheel_rear_left_y = fma(zd_wheel_rear_left, work.R_rear_axle_y_y, work.w_rear_axle_y);
  work.w_wheel_rear_left_z = fma(zd_wheel_rear_left, work.R_rear_axle_z_y, work.w_rear_axle_z);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s4_33 = fma(p_arb_rear_left_z, work.w_chassis_y, work.v_chassis_x);
  work.v_arb_rear_left_x = fnma(p_arb_rear_left_y, work.w_chassis_z, s4_33);
  const double s4_34 = fnma(p_arb_rear_left_z, work.w_chassis_x, work.v_chassis_y);
  work.v_arb_rear_left_y = fma(p_arb_rear_left_x, work.w_chassis_z, s4_34);
  const double s4_35 = fnma(p_arb_rear_left_x, work.w_chassis_y, work.v_chassis_z);
  work.v_arb_rear_left_z = fma(p_arb_rear_left_y, work.w_chassis_x, s4_35);
  work.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s4_36 = fnma(s1_61, work.w_rear_axle_y, work.v_rear_axle_aux3_x);
  work.v_wheel_rear_right_x = fma(s1_60, work.w_rear_axle_z, s4_36);
  const double s4_37 = fnma(s1_59, work.w_rear_axle_z, work.v_rear_axle_aux3_y);
  work.v_wheel_rear_right_y = fma(s1_61, work.w_rear_axle_x, s4_37);
  const double s4_38 = fnma(s1_60, work.w_rear_axle_x, work.v_rear_axle_aux3_z);
  work.v_wheel_rear_right_z = fma(s1_59, work.w_rear_axle_y, s4_38);
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  work.w_wheel_rear_right_x = fma(zd_wheel_rear_right, work.R_rear_axle_x_y, work.w_rear_axle_x);
  work.w_wheel_rear_right_y = fma(zd_wheel_rear_right, work.R_rear_axle_y_y, work.w_rear_axle_y);
  work.w_wheel_rear_right_z = fma(zd_wheel_rear_right, work.R_rear_axle_z_y, work.w_rear_axle_z);
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.v_arb_rear_right_x = fma(p_arb_rear_left_y, work.w_chassis_z, s4_33);
  work.v_arb_rear_right_z = fnma(p_arb_rear_left_y, work.w_chassis_x, s4_35);
  work.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + work.w_chassis_y;
  // operations: 143 add, 135 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  const double R_arb_front_left_x_x = work.cosines[8];
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double s7_1 = p_arb_link_front_left_from_z*R_arb_front_left_x_x;
  work.s7_2 = fnma(p_arb_link_front_left_from_x, R_arb_front_left_x_z, s7_1);
  const double s7_3 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s7_4 = fma(p_arb_link_front_left_from_x, R_arb_front_left_x_x, s7_3);
  const double s7_5 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s7_6 = work.s1_22 + work.R_carrier_left_x_z;
  work.s7_7 = fnma(p_arb_link_front_left_to_y, s7_6, s7_5);
  const double s7_8 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s7_9 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s7_10 = fnma(p_arb_link_front_left_to_y, s7_8, s7_9);
  const double s7_11 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s7_12 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s7_13 = fnma(p_arb_link_front_left_to_y, s7_11, s7_12);
  const double R_arb_front_right_x_x = work.cosines[14];
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double s7_14 = p_arb_link_front_right_from_z*R_arb_front_right_x_x;
  work.s7_15 = fnma(p_arb_link_front_right_from_x, R_arb_front_right_x_z, s7_14);
  const double s7_16 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s7_17 = fma(p_arb_link_front_right_from_x, R_arb_front_right_x_x, s7_16);
  const double s7_18 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s7_19 = work.R_carrier_right_x_z - work.s1_41;
  work.s7_20 = fnma(p_arb_link_front_left_to_y, s7_19, s7_18);
  const double s7_21 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s7_22 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s7_23 = fnma(p_arb_link_front_left_to_y, s7_21, s7_22);
  const double s7_24 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s7_25 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s7_26 = fnma(p_arb_link_front_left_to_y, s7_24, s7_25);
  // drag_link
  work.s7_27 = -p_drag_link_from_z*work.sines[15];
  work.s7_28 = -p_drag_link_from_z*work.cosines[15];
  const double R_bell_crank_y_x = work.sines[16];
  work.s7_29 = p_drag_link_to_y*R_bell_crank_y_x;
  const double R_bell_crank_x_x = work.cosines[16];
  work.s7_30 = p_drag_link_to_y*R_bell_crank_x_x;
  // tie_rod_left
  const double s7_31 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s7_32 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  work.s7_33 = fnma(p_tie_rod_left_from_x, R_bell_crank_x_x, s7_31);
  work.s7_34 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_32);
  const double s7_35 = -p_tie_rod_left_to_y*work.s1_22;
  const double s7_36 = fma(p_tie_rod_left_to_x, work.R_carrier_left_x_x, s7_35);
  work.s7_37 = fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, s7_36);
  const double s7_38 = p_tie_rod_left_to_z*work.R_carrier_left_z_z;
  const double s7_39 = fma(p_tie_rod_left_to_y, work.R_carrier_left_aux2_z_y, s7_38);
  work.s7_40 = fma(p_tie_rod_left_to_x, work.R_carrier_left_z_x, s7_39);
  const double s7_41 = p_tie_rod_left_to_z*work.R_carrier_left_y_z;
  const double s7_42 = fma(p_tie_rod_left_to_y, work.R_carrier_left_aux2_y_y, s7_41);
  work.s7_43 = fma(p_tie_rod_left_to_x, work.R_carrier_left_y_x, s7_42);
  // tie_rod_right
  work.s7_44 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_32);
  work.s7_45 = fma(p_tie_rod_left_from_x, R_bell_crank_x_x, s7_31);
  work.s7_46 = p_tie_rod_right_to_z*work.R_carrier_right_x_z;
}

/// Part 2 of compute_outputs: step 7: inertias of the bodies and forces on joints; step 9: outputs,
/// energies, power.
[[gnu::noinline]] void compute_outputs_2(const State& state, const double* tau,
    OutputsWork& __restrict work, Outputs& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // tie_rod_right
  const double s7_47 = fnma(p_tie_rod_right_to_y, work.s1_41, work.s7_46);
  const double s7_48 = fma(p_tie_rod_right_to_x, work.R_carrier_right_x_x, s7_47);
  const double s7_49 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s7_50 = fma(p_tie_rod_right_to_x, work.R_carrier_right_z_x, s7_49);
  const double s7_51 = fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, s7_50);
  const double s7_52 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s7_53 = fma(p_tie_rod_right_to_x, work.R_carrier_right_y_x, s7_52);
  const double s7_54 = fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, s7_53);
  // long_rod_left
  const double s7_55 = p_long_rod_left_to_x*work.R_rear_axle_aux5_z_x;
  const double s7_56 = fma(p_long_rod_left_to_z, work.R_rear_axle_z_z, s7_55);
  const double s7_57 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_56);
  const double s7_58 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_59 = fma(p_long_rod_left_to_z, work.R_rear_axle_x_z, s7_58);
  const double s7_60 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_59);
  const double s7_61 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_62 = fma(p_long_rod_left_to_z, work.R_rear_axle_y_z, s7_61);
  const double s7_63 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_62);
  // diag_rod_left
  const double s7_64 = p_diag_rod_left_to_z*work.R_rear_axle_z_z;
  const double s7_65 = fma(p_diag_rod_left_to_y, work.R_rear_axle_z_y, s7_64);
  const double s7_66 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  const double s7_67 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_66);
  const double s7_68 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  const double s7_69 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_68);
  // arb_link_rear_left
  const double R_arb_rear_left_x_z = work.sines[20];
  const double s7_70 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_z;
  const double s7_71 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_72 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s7_71);
  const double s7_73 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_z_x;
  const double s7_74 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s7_73);
  const double s7_75 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_76 = fnma(p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s7_75);
  const double R_arb_rear_left_x_x = work.cosines[20];
  const double s7_77 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_x;
  const double s7_78 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s7_74);
  const double s7_79 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_76);
  const double s7_80 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_72);
  // long_rod_right
  const double s7_81 = fnma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_56);
  const double s7_82 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_59);
  const double s7_83 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_62);
  // diag_rod_right
  const double s7_84 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_z_y, s7_64);
  const double s7_85 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_66);
  const double s7_86 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_68);
  // arb_link_rear_right
  const double s7_87 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_72);
  const double s7_88 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_76);
  const double s7_89 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s7_74);
  const double R_arb_rear_right_x_z = work.sines[21];
  const double s7_90 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = work.cosines[21];
  const double s7_91 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_x;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_92 = c_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s7_93 = c_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s7_94 = R_arb_rear_right_x_x*work.w_chassis_x;
  const double s7_95 = fnma(R_arb_rear_right_x_z, work.w_chassis_z, s7_94);
  const double s7_96 = I_arb_rear_right_yy*work.w_arb_rear_right_y;
  const double s7_97 = fma(I_arb_rear_right_xy, s7_95, s7_96);
  const double s7_98 = I_arb_rear_right_xy*work.w_arb_rear_right_y;
  const double s7_99 = fma(I_arb_rear_right_xx, s7_95, s7_98);
  const double s7_100 = R_arb_rear_right_x_z*work.w_chassis_x;
  const double s7_101 = fma(R_arb_rear_right_x_x, work.w_chassis_z, s7_100);
  const double s7_102 = I_arb_rear_right_zz*s7_101;
  const double s7_103 = work.R_rear_axle_x_z*work.w_wheel_rear_right_x;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_104 = fma(work.R_rear_axle_y_z, work.w_wheel_rear_right_y, s7_103);
  const double s7_105 = fma(work.R_rear_axle_z_z, work.w_wheel_rear_right_z, s7_104);
  const double s7_106 = work.R_rear_axle_aux5_x_x*work.w_wheel_rear_right_x;
  const double s7_107 = fma(work.R_rear_axle_aux5_y_x, work.w_wheel_rear_right_y, s7_106);
  const double s7_108 = fma(work.R_rear_axle_aux5_z_x, work.w_wheel_rear_right_z, s7_107);
  const double s7_109 = I_wheel_rear_right_xx*s7_108;
  const double s7_110 = I_wheel_rear_right_zz*s7_105;
  const double s7_111 = work.R_rear_axle_x_y*work.w_wheel_rear_right_x;
  const double s7_112 = fma(work.R_rear_axle_y_y, work.w_wheel_rear_right_y, s7_111);
  const double s7_113 = fma(work.R_rear_axle_z_y, work.w_wheel_rear_right_z, s7_112);
  const double s7_114 = I_wheel_rear_right_yy*s7_113;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_115 = c_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_116 = c_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s7_117 = R_arb_rear_left_x_x*work.w_chassis_x;
  const double s7_118 = fnma(R_arb_rear_left_x_z, work.w_chassis_z, s7_117);
  const double s7_119 = I_arb_rear_left_yy*work.w_arb_rear_left_y;
  const double s7_120 = fma(I_arb_rear_left_xy, s7_118, s7_119);
  const double s7_121 = I_arb_rear_left_xx*s7_118;
  const double s7_122 = fma(I_arb_rear_left_xy, work.w_arb_rear_left_y, s7_121);
  const double s7_123 = R_arb_rear_left_x_z*work.w_chassis_x;
  const double s7_124 = fma(R_arb_rear_left_x_x, work.w_chassis_z, s7_123);
  const double s7_125 = I_arb_rear_left_zz*s7_124;
  const double s7_126 = work.R_rear_axle_x_z*work.w_wheel_rear_left_x;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_127 = fma(work.R_rear_axle_y_z, work.w_wheel_rear_left_y, s7_126);
  const double s7_128 = fma(work.R_rear_axle_z_z, work.w_wheel_rear_left_z, s7_127);
  const double s7_129 = work.R_rear_axle_aux5_x_x*work.w_wheel_rear_left_x;
  const double s7_130 = fma(work.R_rear_axle_aux5_y_x, work.w_wheel_rear_left_y, s7_129);
  const double s7_131 = fma(work.R_rear_axle_aux5_z_x, work.w_wheel_rear_left_z, s7_130);
  const double s7_132 = I_wheel_rear_left_xx*s7_131;
  const double s7_133 = I_wheel_rear_left_zz*s7_128;
  const double s7_134 = work.R_rear_axle_x_y*work.w_wheel_rear_left_x;
  const double s7_135 = fma(work.R_rear_axle_y_y, work.w_wheel_rear_left_y, s7_134);
  const double s7_136 = fma(work.R_rear_axle_z_y, work.w_wheel_rear_left_z, s7_135);
  const double s7_137 = I_wheel_rear_left_yy*s7_136;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_138 = c_rear_axle_x*work.R_rear_axle_aux5_y_x;
  const double s7_139 = fma(c_rear_axle_z, work.R_rear_axle_y_z, s7_138);
  const double s7_140 = c_rear_axle_x*work.R_rear_axle_aux5_z_x;
  const double s7_141 = fma(c_rear_axle_z, work.R_rear_axle_z_z, s7_140);
  const double s7_142 = c_rear_axle_x*work.R_rear_axle_aux5_x_x;
  const double s7_143 = fma(c_rear_axle_z, work.R_rear_axle_x_z, s7_142);
  const double s7_144 = work.R_rear_axle_x_z*work.w_rear_axle_x;
  const double s7_145 = fma(work.R_rear_axle_y_z, work.w_rear_axle_y, s7_144);
  const double s7_146 = fma(work.R_rear_axle_z_z, work.w_rear_axle_z, s7_145);
  const double s7_147 = work.R_rear_axle_aux5_x_x*work.w_rear_axle_x;
  const double s7_148 = fma(work.R_rear_axle_aux5_y_x, work.w_rear_axle_y, s7_147);
  const double s7_149 = fma(work.R_rear_axle_aux5_z_x, work.w_rear_axle_z, s7_148);
  const double s7_150 = fma(I_rear_axle_xz, s7_146, I_rear_axle_xx*s7_149);
  const double s7_151 = fma(I_rear_axle_xz, s7_149, I_rear_axle_zz*s7_146);
  const double s7_152 = work.R_rear_axle_x_y*work.w_rear_axle_x;
  const double s7_153 = fma(work.R_rear_axle_y_y, work.w_rear_axle_y, s7_152);
  const double s7_154 = fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s7_153);
  const double s7_155 = I_rear_axle_yy*s7_154;
  const double R_bell_crank_x_x = work.cosines[16];
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_y_x = work.sines[16];
  const double s7_156 = fma(c_bell_crank_y, R_bell_crank_y_x, -c_bell_crank_x*R_bell_crank_x_x);
  const double s7_157 = fma(c_bell_crank_x, R_bell_crank_y_x, c_bell_crank_y*R_bell_crank_x_x);
  const double s7_158 = R_bell_crank_x_x*work.w_chassis_y;
  const double s7_159 = fnma(R_bell_crank_y_x, work.w_chassis_x, s7_158);
  const double s7_160 = I_bell_crank_zz*work.w_bell_crank_z;
  const double s7_161 = R_bell_crank_x_x*work.w_chassis_x;
  const double s7_162 = fma(R_bell_crank_y_x, work.w_chassis_y, s7_161);
  const double s7_163 = fma(I_bell_crank_xy, s7_162, I_bell_crank_yy*s7_159);
  const double s7_164 = fma(I_bell_crank_xy, s7_159, I_bell_crank_xx*s7_162);
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  const double s7_165 = -c_pitman_arm_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  const double s7_166 = -c_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_167 = R_pitman_arm_x_x*work.w_chassis_x;
  const double s7_168 = fnma(R_pitman_arm_x_z, work.w_chassis_z, s7_167);
  const double s7_169 = I_pitman_arm_yy*work.w_pitman_arm_y;
  const double s7_170 = I_pitman_arm_xx*s7_168;
  const double s7_171 = R_pitman_arm_x_z*work.w_chassis_x;
  const double s7_172 = fma(R_pitman_arm_x_x, work.w_chassis_z, s7_171);
  const double s7_173 = I_pitman_arm_zz*s7_172;
  const double R_arb_front_right_x_x = work.cosines[14];
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double s7_174 = c_arb_front_right_z*R_arb_front_right_x_x;
  const double s7_175 = fnma(c_arb_front_right_x, R_arb_front_right_x_z, s7_174);
  const double s7_176 = c_arb_front_right_z*R_arb_front_right_x_z;
  const double s7_177 = fma(c_arb_front_right_x, R_arb_front_right_x_x, s7_176);
  const double s7_178 = R_arb_front_right_x_x*work.w_chassis_x;
  const double s7_179 = fnma(R_arb_front_right_x_z, work.w_chassis_z, s7_178);
  const double s7_180 = R_arb_front_right_x_z*work.w_chassis_x;
  const double s7_181 = fma(R_arb_front_right_x_x, work.w_chassis_z, s7_180);
  const double s7_182 = I_arb_front_right_yy*work.w_arb_front_right_y;
  const double s7_183 = fma(I_arb_front_right_xy, s7_179, s7_182);
  const double s7_184 = fma(I_arb_front_right_yz, s7_181, s7_183);
  const double s7_185 = I_arb_front_right_xx*s7_179;
  const double s7_186 = fma(I_arb_front_right_xy, work.w_arb_front_right_y, s7_185);
  const double s7_187 = fma(I_arb_front_right_xz, s7_181, s7_186);
  const double s7_188 = I_arb_front_right_yz*work.w_arb_front_right_y;
  const double s7_189 = fma(I_arb_front_right_xz, s7_179, s7_188);
  const double s7_190 = fma(I_arb_front_right_zz, s7_181, s7_189);
  const double R_upper_arm_right_z_y = work.sines[13];
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_191 = -c_upper_arm_right_z*R_upper_arm_right_z_y;
  const double s7_192 = fma(c_upper_arm_right_y, R_upper_arm_right_y_y, s7_191);
  const double s7_193 = -c_upper_arm_right_z*R_upper_arm_right_y_y;
  const double s7_194 = fnma(c_upper_arm_right_y, R_upper_arm_right_z_y, s7_193);
  const double s7_195 = R_upper_arm_right_y_y*work.w_chassis_y;
  const double s7_196 = fma(R_upper_arm_right_z_y, work.w_chassis_z, s7_195);
  const double s7_197 = R_upper_arm_right_y_y*work.w_chassis_z;
  const double s7_198 = fnma(R_upper_arm_right_z_y, work.w_chassis_y, s7_197);
  const double s7_199 = I_upper_arm_right_zz*s7_198;
  const double s7_200 = I_upper_arm_right_yy*s7_196;
  const double s7_201 = I_upper_arm_right_xx*work.w_upper_arm_right_x;
  const double s7_202 = work.R_carrier_right_x_x*work.w_wheel_front_right_x;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_203 = fma(work.R_carrier_right_y_x, work.w_wheel_front_right_y, s7_202);
  const double s7_204 = fma(work.R_carrier_right_z_x, work.w_wheel_front_right_z, s7_203);
  const double s7_205 = work.R_carrier_right_aux2_y_y*work.w_wheel_front_right_y;
  const double s7_206 = fnma(work.s1_41, work.w_wheel_front_right_x, s7_205);
  const double s7_207 = fma(work.R_carrier_right_aux2_z_y, work.w_wheel_front_right_z, s7_206);
  const double s7_208 = I_wheel_front_right_yy*s7_207;
  const double s7_209 = I_wheel_front_right_xx*s7_204;
  const double s7_210 = work.R_carrier_right_x_z*work.w_wheel_front_right_x;
  const double s7_211 = fma(work.R_carrier_right_y_z, work.w_wheel_front_right_y, s7_210);
  const double s7_212 = fma(work.R_carrier_right_z_z, work.w_wheel_front_right_z, s7_211);
  const double s7_213 = I_wheel_front_right_zz*s7_212;
  const double s7_214 = c_carrier_right_z*work.R_carrier_right_y_z;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_215 = fma(c_carrier_right_y, work.R_carrier_right_aux2_y_y, s7_214);
  const double s7_216 = fma(c_carrier_right_x, work.R_carrier_right_y_x, s7_215);
  const double s7_217 = c_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_218 = fma(c_carrier_right_y, work.R_carrier_right_aux2_z_y, s7_217);
  const double s7_219 = fma(c_carrier_right_x, work.R_carrier_right_z_x, s7_218);
  const double s7_220 = -c_carrier_right_y*work.s1_41;
  const double s7_221 = fma(c_carrier_right_x, work.R_carrier_right_x_x, s7_220);
  const double s7_222 = fma(c_carrier_right_z, work.R_carrier_right_x_z, s7_221);
  const double s7_223 = work.R_carrier_right_x_x*work.w_carrier_right_x;
  const double s7_224 = fma(work.R_carrier_right_y_x, work.w_carrier_right_y, s7_223);
  const double s7_225 = fma(work.R_carrier_right_z_x, work.w_carrier_right_z, s7_224);
  const double s7_226 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_y;
  const double s7_227 = fnma(work.s1_41, work.w_carrier_right_x, s7_226);
  const double s7_228 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s7_227);
  const double s7_229 = work.R_carrier_right_x_z*work.w_carrier_right_x;
  const double s7_230 = fma(work.R_carrier_right_y_z, work.w_carrier_right_y, s7_229);
  const double s7_231 = fma(work.R_carrier_right_z_z, work.w_carrier_right_z, s7_230);
  const double s7_232 = fma(I_carrier_right_yy, s7_228, I_carrier_right_xy*s7_225);
  const double s7_233 = fma(I_carrier_right_yz, s7_231, s7_232);
  const double s7_234 = fma(I_carrier_right_xy, s7_228, I_carrier_right_xx*s7_225);
  const double s7_235 = fma(I_carrier_right_xz, s7_231, s7_234);
  const double s7_236 = fma(I_carrier_right_xz, s7_225, I_carrier_right_yz*s7_228);
  const double s7_237 = fma(I_carrier_right_zz, s7_231, s7_236);
  const double R_lower_arm_right_z_y = work.sines[9];
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s7_238 = -c_lower_arm_right_z*R_lower_arm_right_z_y;
  const double s7_239 = fma(c_lower_arm_right_y, R_lower_arm_right_y_y, s7_238);
  const double s7_240 = -c_lower_arm_right_z*R_lower_arm_right_y_y;
  const double s7_241 = fnma(c_lower_arm_right_y, R_lower_arm_right_z_y, s7_240);
  const double s7_242 = R_lower_arm_right_y_y*work.w_chassis_y;
  const double s7_243 = fma(R_lower_arm_right_z_y, work.w_chassis_z, s7_242);
  const double s7_244 = R_lower_arm_right_y_y*work.w_chassis_z;
  const double s7_245 = fnma(R_lower_arm_right_z_y, work.w_chassis_y, s7_244);
  const double s7_246 = I_lower_arm_right_zz*s7_245;
  const double s7_247 = I_lower_arm_right_yy*s7_243;
  const double s7_248 = I_lower_arm_right_xx*work.w_lower_arm_right_x;
  const double R_arb_front_left_x_x = work.cosines[8];
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double s7_249 = c_arb_front_left_z*R_arb_front_left_x_x;
  const double s7_250 = fnma(c_arb_front_left_x, R_arb_front_left_x_z, s7_249);
  const double s7_251 = c_arb_front_left_z*R_arb_front_left_x_z;
  const double s7_252 = fma(c_arb_front_left_x, R_arb_front_left_x_x, s7_251);
  const double s7_253 = R_arb_front_left_x_x*work.w_chassis_x;
  const double s7_254 = fnma(R_arb_front_left_x_z, work.w_chassis_z, s7_253);
  const double s7_255 = R_arb_front_left_x_z*work.w_chassis_x;
  const double s7_256 = fma(R_arb_front_left_x_x, work.w_chassis_z, s7_255);
  const double s7_257 = I_arb_front_left_yy*work.w_arb_front_left_y;
  const double s7_258 = fma(I_arb_front_left_xy, s7_254, s7_257);
  const double s7_259 = fma(I_arb_front_left_yz, s7_256, s7_258);
  const double s7_260 = I_arb_front_left_xy*work.w_arb_front_left_y;
  const double s7_261 = fma(I_arb_front_left_xx, s7_254, s7_260);
  const double s7_262 = fma(I_arb_front_left_xz, s7_256, s7_261);
  const double s7_263 = I_arb_front_left_xz*s7_254;
  const double s7_264 = fma(I_arb_front_left_yz, work.w_arb_front_left_y, s7_263);
  const double s7_265 = fma(I_arb_front_left_zz, s7_256, s7_264);
  const double R_upper_arm_left_z_y = work.sines[7];
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_266 = c_upper_arm_left_y*R_upper_arm_left_z_y;
  const double s7_267 = fma(c_upper_arm_left_z, R_upper_arm_left_y_y, s7_266);
  const double s7_268 = c_upper_arm_left_y*R_upper_arm_left_y_y;
  const double s7_269 = fnma(c_upper_arm_left_z, R_upper_arm_left_z_y, s7_268);
  const double s7_270 = R_upper_arm_left_y_y*work.w_chassis_y;
  const double s7_271 = fma(R_upper_arm_left_z_y, work.w_chassis_z, s7_270);
  const double s7_272 = R_upper_arm_left_y_y*work.w_chassis_z;
  const double s7_273 = fnma(R_upper_arm_left_z_y, work.w_chassis_y, s7_272);
  const double s7_274 = I_upper_arm_left_zz*s7_273;
  const double s7_275 = I_upper_arm_left_yy*s7_271;
  const double s7_276 = I_upper_arm_left_xx*work.w_upper_arm_left_x;
  const double s7_277 = work.R_carrier_left_x_x*work.w_wheel_front_left_x;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_278 = fma(work.R_carrier_left_y_x, work.w_wheel_front_left_y, s7_277);
  const double s7_279 = fma(work.R_carrier_left_z_x, work.w_wheel_front_left_z, s7_278);
  const double s7_280 = work.R_carrier_left_aux2_y_y*work.w_wheel_front_left_y;
  const double s7_281 = fnma(work.s1_22, work.w_wheel_front_left_x, s7_280);
  const double s7_282 = fma(work.R_carrier_left_aux2_z_y, work.w_wheel_front_left_z, s7_281);
  const double s7_283 = I_wheel_front_left_yy*s7_282;
  const double s7_284 = I_wheel_front_left_xx*s7_279;
  const double s7_285 = work.R_carrier_left_x_z*work.w_wheel_front_left_x;
  const double s7_286 = fma(work.R_carrier_left_y_z, work.w_wheel_front_left_y, s7_285);
  const double s7_287 = fma(work.R_carrier_left_z_z, work.w_wheel_front_left_z, s7_286);
  const double s7_288 = I_wheel_front_left_zz*s7_287;
  const double s7_289 = c_carrier_left_y*work.R_carrier_left_aux2_y_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_290 = fma(c_carrier_left_x, work.R_carrier_left_y_x, s7_289);
  const double s7_291 = fma(c_carrier_left_z, work.R_carrier_left_y_z, s7_290);
  const double s7_292 = c_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_293 = fma(c_carrier_left_x, work.R_carrier_left_z_x, s7_292);
  const double s7_294 = fma(c_carrier_left_z, work.R_carrier_left_z_z, s7_293);
  const double s7_295 = c_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_296 = fnma(c_carrier_left_y, work.s1_22, s7_295);
  const double s7_297 = fma(c_carrier_left_x, work.R_carrier_left_x_x, s7_296);
  const double s7_298 = work.R_carrier_left_x_x*work.w_carrier_left_x;
  const double s7_299 = fma(work.R_carrier_left_y_x, work.w_carrier_left_y, s7_298);
  const double s7_300 = fma(work.R_carrier_left_z_x, work.w_carrier_left_z, s7_299);
  const double s7_301 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_y;
  const double s7_302 = fnma(work.s1_22, work.w_carrier_left_x, s7_301);
  const double s7_303 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s7_302);
  const double s7_304 = work.R_carrier_left_x_z*work.w_carrier_left_x;
  const double s7_305 = fma(work.R_carrier_left_y_z, work.w_carrier_left_y, s7_304);
  const double s7_306 = fma(work.R_carrier_left_z_z, work.w_carrier_left_z, s7_305);
  const double s7_307 = fma(I_carrier_left_xy, s7_300, I_carrier_left_yy*s7_303);
  const double s7_308 = fma(I_carrier_left_yz, s7_306, s7_307);
  const double s7_309 = fma(I_carrier_left_xy, s7_303, I_carrier_left_xx*s7_300);
  const double s7_310 = fma(I_carrier_left_xz, s7_306, s7_309);
  const double s7_311 = fma(I_carrier_left_xz, s7_300, I_carrier_left_zz*s7_306);
  const double s7_312 = fma(I_carrier_left_yz, s7_303, s7_311);
  const double R_lower_arm_left_z_y = work.sines[3];
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s7_313 = c_lower_arm_left_y*R_lower_arm_left_z_y;
  const double s7_314 = fma(c_lower_arm_left_z, R_lower_arm_left_y_y, s7_313);
  const double s7_315 = c_lower_arm_left_y*R_lower_arm_left_y_y;
  const double s7_316 = fnma(c_lower_arm_left_z, R_lower_arm_left_z_y, s7_315);
  const double s7_317 = R_lower_arm_left_y_y*work.w_chassis_y;
  const double s7_318 = fma(R_lower_arm_left_z_y, work.w_chassis_z, s7_317);
  const double s7_319 = R_lower_arm_left_y_y*work.w_chassis_z;
  const double s7_320 = fnma(R_lower_arm_left_z_y, work.w_chassis_y, s7_319);
  const double s7_321 = I_lower_arm_left_zz*s7_320;
  const double s7_322 = I_lower_arm_left_yy*s7_318;
  const double s7_323 = I_lower_arm_left_xx*work.w_lower_arm_left_x;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_324 = fma(I_chassis_xz, work.w_chassis_x, I_chassis_zz*work.w_chassis_z);
  const double s7_325 = I_chassis_yy*work.w_chassis_y;
  const double s7_326 = fma(I_chassis_xz, work.w_chassis_z, I_chassis_xx*work.w_chassis_x);
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
  const double s9_32 = fnma(work.w_rear_axle_z, s7_88, work.v_rear_axle_aux3_y);
  const double s9_33 = fma(work.w_chassis_x, s7_90, work.v_arb_rear_left_y);
  const double s9_34 = fnma(work.w_rear_axle_x, s7_87, work.v_rear_axle_aux3_z);
  const double s9_35 = fnma(work.w_arb_rear_right_y, s7_91, work.v_arb_rear_right_z);
  const double s9_36 = fma(work.w_rear_axle_z, s7_87, work.v_rear_axle_aux3_x);
  const double s9_37 = fnma(work.w_arb_rear_right_y, s7_90, work.v_arb_rear_right_x);
  const double s9_38 = fnma(p_diag_rod_left_from_z, work.w_chassis_x, work.v_chassis_y);
  const double s9_39 = fnma(work.w_rear_axle_x, s7_84, work.v_rear_axle_aux3_y);
  const double s9_40 = fma(work.w_rear_axle_y, s7_84, work.v_rear_axle_aux3_x);
  const double s9_41 = fnma(work.w_rear_axle_y, s7_85, work.v_rear_axle_aux3_z);
  const double s9_42 = fma(p_long_rod_left_from_x, work.w_chassis_z, work.v_chassis_y);
  const double s9_43 = fnma(work.w_rear_axle_x, s7_81, work.v_rear_axle_aux3_y);
  const double s9_44 = fma(p_long_rod_left_from_z, work.w_chassis_y, work.v_chassis_x);
  const double s9_45 = fma(work.w_rear_axle_y, s7_81, work.v_rear_axle_aux3_x);
  const double s9_46 = fnma(p_long_rod_left_from_x, work.w_chassis_y, work.v_chassis_z);
  const double s9_47 = fnma(work.w_rear_axle_y, s7_82, work.v_rear_axle_aux3_z);
  const double s9_48 = fnma(work.w_rear_axle_x, s7_78, work.v_rear_axle_aux3_y);
  const double s9_49 = fma(work.w_chassis_x, s7_70, work.v_arb_rear_left_y);
  const double s9_50 = fnma(work.w_rear_axle_y, s7_79, work.v_rear_axle_aux3_z);
  const double s9_51 = fnma(work.w_arb_rear_left_y, s7_77, work.v_arb_rear_left_z);
  const double s9_52 = fma(work.w_rear_axle_y, s7_78, work.v_rear_axle_aux3_x);
  const double s9_53 = fnma(work.w_arb_rear_left_y, s7_70, work.v_arb_rear_left_x);
  const double s9_54 = fnma(work.w_rear_axle_x, s7_65, work.v_rear_axle_aux3_y);
  const double s9_55 = fnma(work.w_rear_axle_y, s7_67, work.v_rear_axle_aux3_z);
  const double s9_56 = fma(work.w_rear_axle_y, s7_65, work.v_rear_axle_aux3_x);
  const double s9_57 = fnma(work.w_rear_axle_x, s7_57, work.v_rear_axle_aux3_y);
  const double s9_58 = fnma(work.w_rear_axle_y, s7_60, work.v_rear_axle_aux3_z);
  const double s9_59 = fma(work.w_rear_axle_y, s7_57, work.v_rear_axle_aux3_x);
  const double s9_60 = fma(work.w_carrier_right_z, s7_48, work.v_carrier_right_aux1_y);
  const double s9_61 = fma(work.w_carrier_right_y, s7_51, work.v_carrier_right_aux1_x);
  const double s9_62 = fnma(work.w_carrier_right_y, s7_48, work.v_carrier_right_aux1_z);
  const double s9_63 = fnma(work.w_chassis_x, work.s7_44, work.v_bell_crank_z);
  const double s9_64 = fma(work.w_carrier_left_z, work.s7_37, work.v_carrier_left_aux1_y);
  const double s9_65 = fma(work.w_carrier_left_y, work.s7_40, work.v_carrier_left_aux1_x);
  const double s9_66 = fnma(work.w_carrier_left_y, work.s7_37, work.v_carrier_left_aux1_z);
  const double s9_67 = fma(work.w_chassis_y, work.s7_33, work.v_bell_crank_z);
  const double s9_68 = fnma(work.w_chassis_z, work.s7_27, work.v_pitman_arm_y);
  const double s9_69 = fma(work.w_chassis_y, work.s7_29, work.v_bell_crank_z);
  const double s9_70 = fnma(work.w_bell_crank_z, work.s7_29, work.v_bell_crank_y);
  const double s9_71 = fnma(work.w_pitman_arm_y, work.s7_28, work.v_pitman_arm_x);
  const double s9_72 = fnma(work.w_bell_crank_z, work.s7_30, work.v_bell_crank_x);
  const double s9_73 = fma(s9_71, s9_72, s9_70*fma(work.w_chassis_x, work.s7_28, s9_68));
  const double s9_74 = fma(work.w_pitman_arm_y, work.s7_27, work.v_pitman_arm_z);
  const double s9_75 = fma(work.w_carrier_left_z, work.s7_7, work.v_carrier_left_aux1_y);
  const double s9_76 = fnma(work.w_chassis_x, work.s7_2, work.v_arb_front_left_y);
  const double s9_77 = fnma(work.w_carrier_left_y, work.s7_7, work.v_carrier_left_aux1_z);
  const double s9_78 = fnma(work.w_arb_front_left_y, work.s7_4, work.v_arb_front_left_z);
  const double s9_79 = fma(work.w_carrier_left_y, work.s7_10, work.v_carrier_left_aux1_x);
  const double s9_80 = fma(work.w_arb_front_left_y, work.s7_2, work.v_arb_front_left_x);
  const double s9_81 = fnma(work.w_chassis_x, work.s7_15, work.v_arb_front_left_y);
  const double s9_82 = fma(work.w_carrier_right_z, work.s7_20, work.v_carrier_right_aux1_y);
  const double s9_83 = fnma(work.w_carrier_right_y, work.s7_20, work.v_carrier_right_aux1_z);
  const double s9_84 = fnma(work.w_arb_front_right_y, work.s7_17, work.v_arb_front_right_z);
  const double s9_85 = fma(work.w_carrier_right_y, work.s7_23, work.v_carrier_right_aux1_x);
  const double s9_86 = fma(work.w_arb_front_right_y, work.s7_15, work.v_arb_front_right_x);
  const double s9_87 = fma(work.w_chassis_x, s7_92, work.v_arb_rear_left_y);
  const double s9_88 = fma(work.w_chassis_z, s7_93, s9_87);
  const double s9_89 = fnma(work.w_arb_rear_right_y, s7_93, work.v_arb_rear_right_z);
  const double s9_90 = fnma(c_arb_rear_left_y, work.w_chassis_x, s9_89);
  const double s9_91 = fnma(work.w_arb_rear_right_y, s7_92, work.v_arb_rear_right_x);
  const double s9_92 = fma(c_arb_rear_left_y, work.w_chassis_z, s9_91);
  const double s9_93 = fma(work.w_chassis_x, s7_115, work.v_arb_rear_left_y);
  const double s9_94 = fma(work.w_chassis_z, s7_116, s9_93);
  const double s9_95 = fnma(work.w_arb_rear_left_y, s7_115, work.v_arb_rear_left_x);
  const double s9_96 = fnma(c_arb_rear_left_y, work.w_chassis_z, s9_95);
  const double s9_97 = fnma(work.w_arb_rear_left_y, s7_116, work.v_arb_rear_left_z);
  const double s9_98 = fma(c_arb_rear_left_y, work.w_chassis_x, s9_97);
  const double s9_99 = fnma(work.w_rear_axle_x, s7_141, work.v_rear_axle_aux3_y);
  const double s9_100 = fma(work.w_rear_axle_z, s7_143, s9_99);
  const double s9_101 = fma(work.w_rear_axle_x, s7_139, work.v_rear_axle_aux3_z);
  const double s9_102 = fnma(work.w_rear_axle_y, s7_143, s9_101);
  const double s9_103 = fnma(work.w_rear_axle_z, s7_139, work.v_rear_axle_aux3_x);
  const double s9_104 = fma(work.w_rear_axle_y, s7_141, s9_103);
  const double s9_105 = fnma(work.w_bell_crank_z, s7_156, work.v_bell_crank_y);
  const double s9_106 = fnma(work.w_bell_crank_z, s7_157, work.v_bell_crank_x);
  const double s9_107 = fma(work.w_chassis_y, s7_156, work.v_bell_crank_z);
  const double s9_108 = fma(work.w_chassis_x, s7_157, s9_107);
  const double s9_109 = fma(work.w_pitman_arm_y, s7_165, work.v_pitman_arm_z);
  const double s9_110 = fnma(work.w_pitman_arm_y, s7_166, work.v_pitman_arm_x);
  const double s9_111 = fnma(work.w_chassis_z, s7_165, work.v_pitman_arm_y);
  const double s9_112 = fma(work.w_chassis_x, s7_166, s9_111);
  const double s9_113 = fnma(work.w_chassis_x, s7_175, work.v_arb_front_left_y);
  const double s9_114 = fma(work.w_chassis_z, s7_177, s9_113);
  const double s9_115 = fma(work.w_arb_front_right_y, s7_175, work.v_arb_front_right_x);
  const double s9_116 = fma(c_arb_front_left_y, work.w_chassis_z, s9_115);
  const double s9_117 = fnma(work.w_arb_front_right_y, s7_177, work.v_arb_front_right_z);
  const double s9_118 = fnma(c_arb_front_left_y, work.w_chassis_x, s9_117);
  const double s9_119 = fma(work.w_upper_arm_right_x, s7_194, work.v_upper_arm_left_y);
  const double s9_120 = fma(work.w_upper_arm_right_x, s7_192, work.v_upper_arm_right_z);
  const double s9_121 = fnma(work.w_chassis_z, s7_192, work.v_upper_arm_right_x);
  const double s9_122 = fnma(work.w_chassis_y, s7_194, s9_121);
  const double s9_123 = fnma(work.w_carrier_right_x, s7_219, work.v_carrier_right_aux1_y);
  const double s9_124 = fma(work.w_carrier_right_z, s7_222, s9_123);
  const double s9_125 = fma(work.w_carrier_right_x, s7_216, work.v_carrier_right_aux1_z);
  const double s9_126 = fnma(work.w_carrier_right_y, s7_222, s9_125);
  const double s9_127 = fnma(work.w_carrier_right_z, s7_216, work.v_carrier_right_aux1_x);
  const double s9_128 = fma(work.w_carrier_right_y, s7_219, s9_127);
  const double s9_129 = fma(work.w_lower_arm_right_x, s7_241, work.v_lower_arm_left_y);
  const double s9_130 = fma(work.w_lower_arm_right_x, s7_239, work.v_lower_arm_right_z);
  const double s9_131 = fnma(work.w_chassis_z, s7_239, work.v_lower_arm_right_x);
  const double s9_132 = fnma(work.w_chassis_y, s7_241, s9_131);
  const double s9_133 = fnma(work.w_chassis_x, s7_250, work.v_arb_front_left_y);
  const double s9_134 = fma(work.w_chassis_z, s7_252, s9_133);
  const double s9_135 = fma(work.w_arb_front_left_y, s7_250, work.v_arb_front_left_x);
  const double s9_136 = fnma(c_arb_front_left_y, work.w_chassis_z, s9_135);
  const double s9_137 = fnma(work.w_arb_front_left_y, s7_252, work.v_arb_front_left_z);
  const double s9_138 = fma(c_arb_front_left_y, work.w_chassis_x, s9_137);
  const double s9_139 = fnma(work.w_upper_arm_left_x, s7_267, work.v_upper_arm_left_y);
  const double s9_140 = fma(work.w_upper_arm_left_x, s7_269, work.v_upper_arm_left_z);
  const double s9_141 = fma(work.w_chassis_y, s7_267, work.v_upper_arm_left_x);
  const double s9_142 = fnma(work.w_chassis_z, s7_269, s9_141);
  const double s9_143 = fnma(work.w_carrier_left_x, s7_294, work.v_carrier_left_aux1_y);
  const double s9_144 = fma(work.w_carrier_left_z, s7_297, s9_143);
  const double s9_145 = fma(work.w_carrier_left_x, s7_291, work.v_carrier_left_aux1_z);
  const double s9_146 = fnma(work.w_carrier_left_y, s7_297, s9_145);
  const double s9_147 = fnma(work.w_carrier_left_z, s7_291, work.v_carrier_left_aux1_x);
  const double s9_148 = fma(work.w_carrier_left_y, s7_294, s9_147);
  const double s9_149 = fma(c_chassis_z, work.w_chassis_y, work.v_chassis_x);
  const double s9_150 = fnma(c_chassis_x, work.w_chassis_y, work.v_chassis_z);
  const double s9_151 = fnma(c_chassis_z, work.w_chassis_x, work.v_chassis_y);
  const double s9_152 = fma(c_chassis_x, work.w_chassis_z, s9_151);
  const double s9_153 = fnma(work.w_lower_arm_left_x, s7_314, work.v_lower_arm_left_y);
  const double s9_154 = fma(work.w_lower_arm_left_x, s7_316, work.v_lower_arm_left_z);
  const double s9_155 = fma(work.w_chassis_y, s7_314, work.v_lower_arm_left_x);
  const double s9_156 = fnma(work.w_chassis_z, s7_316, s9_155);
  const double s9_157 = fma(s9_94, s9_94, fma(s9_92, s9_92, fma(s9_90, s9_90, s9_88*s9_88)));
  const double s9_158 = fma(s9_114, s9_114, fma(s9_98, s9_98, fma(s9_96, s9_96, s9_157)));
  const double s9_159 = fma(s9_134, s9_134, fma(s9_118, s9_118, fma(s9_116, s9_116, s9_158)));
  const double s9_160 = fma(work.w_rear_axle_x, s7_89, s9_32);
  const double s9_161 = fnma(p_arb_link_rear_left_from_y, work.w_chassis_x, s9_35);
  const double s9_162 = s9_160*fma(work.w_chassis_z, s7_91, s9_33);
  const double s9_163 = fma(fma(work.w_rear_axle_y, s7_88, s9_34), s9_161, s9_162);
  const double s9_164 = fma(p_arb_link_rear_left_from_y, work.w_chassis_z, s9_37);
  const double s9_165 = fma(fnma(work.w_rear_axle_y, s7_89, s9_36), s9_164, s9_163);
  const double s9_166 = fma(work.w_rear_axle_z, s7_79, s9_48);
  const double s9_167 = fma(p_arb_link_rear_left_from_y, work.w_chassis_x, s9_51);
  const double s9_168 = fma(s9_166, fma(work.w_chassis_z, s7_77, s9_49), s9_165);
  const double s9_169 = fnma(p_arb_link_rear_left_from_y, work.w_chassis_z, s9_53);
  const double s9_170 = fma(fma(work.w_rear_axle_x, s7_80, s9_50), s9_167, s9_168);
  const double s9_171 = fma(fnma(work.w_rear_axle_z, s7_80, s9_52), s9_169, s9_170);
  const double s9_172 = fnma(work.w_carrier_left_x, work.s7_10, s9_75);
  const double s9_173 = fma(s9_172, fma(work.w_chassis_z, work.s7_4, s9_76), s9_171);
  const double s9_174 = fma(p_arb_link_front_left_from_y, work.w_chassis_x, s9_78);
  const double s9_175 = fma(fma(work.w_carrier_left_x, work.s7_13, s9_77), s9_174, s9_173);
  const double s9_176 = fnma(p_arb_link_front_left_from_y, work.w_chassis_z, s9_80);
  const double s9_177 = fma(fnma(work.w_carrier_left_z, work.s7_13, s9_79), s9_176, s9_175);
  const double s9_178 = fnma(work.w_carrier_right_x, work.s7_23, s9_82);
  const double s9_179 = fma(fma(work.w_chassis_z, work.s7_17, s9_81), s9_178, s9_177);
  const double s9_180 = fnma(p_arb_link_front_left_from_y, work.w_chassis_x, s9_84);
  const double s9_181 = fma(fma(work.w_carrier_right_x, work.s7_26, s9_83), s9_180, s9_179);
  const double s9_182 = fma(p_arb_link_front_left_from_y, work.w_chassis_z, s9_86);
  const double s9_183 = work.v_wheel_rear_left_x*work.v_wheel_rear_left_x;
  const double s9_184 = fma(work.v_wheel_rear_left_y, work.v_wheel_rear_left_y, s9_183);
  const double s9_185 = fma(work.v_wheel_rear_left_z, work.v_wheel_rear_left_z, s9_184);
  const double s9_186 = fma(work.v_wheel_rear_right_x, work.v_wheel_rear_right_x, s9_185);
  const double s9_187 = fma(work.v_wheel_rear_right_y, work.v_wheel_rear_right_y, s9_186);
  const double s9_188 = fma(s9_122, s9_122, fma(s9_120, s9_120, s9_119*s9_119));
  const double s9_189 = work.v_wheel_front_left_x*work.v_wheel_front_left_x;
  const double s9_190 = fma(work.v_wheel_front_left_y, work.v_wheel_front_left_y, s9_189);
  const double s9_191 = fma(work.v_wheel_front_left_z, work.v_wheel_front_left_z, s9_190);
  const double s9_192 = fma(work.v_wheel_front_right_x, work.v_wheel_front_right_x, s9_191);
  const double s9_193 = fma(work.v_wheel_front_right_y, work.v_wheel_front_right_y, s9_192);
  const double s9_194 = fma(s9_128, s9_128, fma(s9_126, s9_126, s9_124*s9_124));
  const double s9_195 = fma(s9_132, s9_132, fma(s9_130, s9_130, s9_129*s9_129));
  const double s9_196 = fma(work.w_rear_axle_z, s7_85, s9_39);
  const double s9_197 = fma(p_diag_rod_left_from_z, work.w_chassis_y, work.s4_17);
  const double s9_198 = fnma(p_diag_rod_left_from_x, work.w_chassis_y, work.s4_18);
  const double s9_199 = s9_197*fnma(work.w_rear_axle_z, s7_86, s9_40);
  const double s9_200 = fma(s9_198, fma(work.w_rear_axle_x, s7_86, s9_41), s9_199);
  const double s9_201 = fnma(p_diag_rod_left_from_x, work.w_chassis_y, work.s4_6);
  const double s9_202 = fma(s9_201, fma(work.w_rear_axle_x, s7_69, s9_55), s9_200);
  const double s9_203 = fma(p_diag_rod_left_from_z, work.w_chassis_y, work.s4_4);
  const double s9_204 = fma(fnma(work.w_rear_axle_z, s7_69, s9_56), s9_203, s9_202);
  const double s9_205 = fma(p_diag_rod_left_from_x, work.w_chassis_z, s9_38);
  const double s9_206 = fma(work.w_rear_axle_z, s7_82, s9_43);
  const double s9_207 = fma(p_long_rod_left_from_y, work.w_chassis_z, s9_44);
  const double s9_208 = fma(p_long_rod_left_from_z, work.w_chassis_x, s9_46);
  const double s9_209 = s9_207*fnma(work.w_rear_axle_z, s7_83, s9_45);
  const double s9_210 = fma(s9_208, fma(work.w_rear_axle_x, s7_83, s9_47), s9_209);
  const double s9_211 = fnma(p_long_rod_left_from_z, work.w_chassis_x, s9_46);
  const double s9_212 = fma(s9_211, fma(work.w_rear_axle_x, s7_63, s9_58), s9_210);
  const double s9_213 = fnma(p_long_rod_left_from_y, work.w_chassis_z, s9_44);
  const double s9_214 = fma(fnma(work.w_rear_axle_z, s7_63, s9_59), s9_213, s9_212);
  const double s9_215 = fnma(p_long_rod_left_from_z, work.w_chassis_x, s9_42);
  const double s9_216 = fma(work.w_bell_crank_z, work.s7_45, work.v_bell_crank_y);
  const double s9_217 = fma(work.w_bell_crank_z, work.s7_44, work.v_bell_crank_x);
  const double s9_218 = s9_216*fnma(work.w_carrier_right_x, s7_51, s9_60);
  const double s9_219 = fma(s9_217, fnma(work.w_carrier_right_z, s7_54, s9_61), s9_218);
  const double s9_220 = fma(work.w_carrier_right_x, s7_54, s9_62);
  const double s9_221 = fma(s9_220, fnma(work.w_chassis_y, work.s7_45, s9_63), s9_219);
  const double s9_222 = fnma(work.w_bell_crank_z, work.s7_33, work.v_bell_crank_y);
  const double s9_223 = fma(s9_222, fnma(work.w_carrier_left_x, work.s7_40, s9_64), s9_221);
  const double s9_224 = fnma(work.w_bell_crank_z, work.s7_34, work.v_bell_crank_x);
  const double s9_225 = fma(s9_224, fnma(work.w_carrier_left_z, work.s7_43, s9_65), s9_223);
  const double s9_226 = fma(work.w_carrier_left_x, work.s7_43, s9_66);
  const double s9_227 = fma(s7_101, s7_102, fma(s7_95, s7_99, work.w_arb_rear_right_y*s7_97));
  const double s9_228 = fma(s7_113, s7_114, fma(s7_105, s7_110, fma(s7_108, s7_109, s9_227)));
  const double s9_229 = fma(s7_118, s7_122, fma(work.w_arb_rear_left_y, s7_120, s9_228));
  const double s9_230 = fma(s7_128, s7_133, fma(s7_131, s7_132, fma(s7_124, s7_125, s9_229)));
  const double s9_231 = fma(s7_146, s7_151, fma(s7_149, s7_150, fma(s7_136, s7_137, s9_230)));
  const double s9_232 = fma(work.w_bell_crank_z, s7_160, fma(s7_154, s7_155, s9_231));
  const double s9_233 = fma(s7_162, s7_164, fma(s7_159, s7_163, s9_232));
  const double s9_234 = fma(s7_168, s7_170, fma(work.w_pitman_arm_y, s7_169, s9_233));
  const double s9_235 = fma(work.w_arb_front_right_y, s7_184, fma(s7_172, s7_173, s9_234));
  const double s9_236 = fma(s7_198, s7_199, fma(s7_181, s7_190, fma(s7_179, s7_187, s9_235)));
  const double s9_237 = fma(work.w_upper_arm_right_x, s7_201, fma(s7_196, s7_200, s9_236));
  const double s9_238 = fma(s7_212, s7_213, fma(s7_204, s7_209, fma(s7_207, s7_208, s9_237)));
  const double s9_239 = fma(s7_231, s7_237, fma(s7_225, s7_235, fma(s7_228, s7_233, s9_238)));
  const double s9_240 = fma(s7_243, s7_247, fma(s7_245, s7_246, s9_239));
  const double s9_241 = fma(work.w_lower_arm_right_x, s7_248, s9_240);
  const double s9_242 = fma(s7_254, s7_262, fma(work.w_arb_front_left_y, s7_259, s9_241));
  const double s9_243 = fma(s7_271, s7_275, fma(s7_273, s7_274, fma(s7_256, s7_265, s9_242)));
  const double s9_244 = fma(s7_282, s7_283, fma(work.w_upper_arm_left_x, s7_276, s9_243));
  const double s9_245 = fma(s7_303, s7_308, fma(s7_287, s7_288, fma(s7_279, s7_284, s9_244)));
  const double s9_246 = fma(s7_320, s7_321, fma(s7_306, s7_312, fma(s7_300, s7_310, s9_245)));
  const double s9_247 = fma(work.w_lower_arm_left_x, s7_323, fma(s7_318, s7_322, s9_246));
  const double s9_248 = fma(work.w_chassis_y, s7_325, fma(work.w_chassis_z, s7_324, s9_247));
  const double s9_249 = fma(s9_74, fma(work.w_chassis_x, work.s7_30, s9_69), s9_73);
  const double s9_250 = fma(s9_104, s9_104, fma(s9_102, s9_102, s9_100*s9_100));
  const double s9_251 = fma(3.0, s9_249, fma(work.w_chassis_x, s7_326, s9_248));
  const double s9_252 = fma(s9_108, s9_108, fma(s9_106, s9_106, s9_105*s9_105));
  const double s9_253 = fma(m_bell_crank, s9_252, fma(m_rear_axle, s9_250, s9_251));
  const double s9_254 = fma(s9_112, s9_112, fma(s9_110, s9_110, s9_109*s9_109));
  const double s9_255 = fma(s9_152, s9_152, fma(s9_150, s9_150, s9_149*s9_149));
  const double s9_256 = fma(m_chassis, s9_255, fma(m_pitman_arm, s9_254, s9_253));
  const double s9_257 = fma(s9_138, s9_138, fma(s9_136, s9_136, s9_159));
  const double s9_258 = fma(fnma(work.w_carrier_right_z, work.s7_26, s9_85), s9_182, s9_181);
  const double s9_259 = fma(0.6666666666666666, s9_258, fma(m_arb_rear_right, s9_257, s9_256));
  const double s9_260 = fma(work.v_wheel_rear_right_z, work.v_wheel_rear_right_z, s9_187);
  const double s9_261 = fma(s9_142, s9_142, fma(s9_140, s9_140, fma(s9_139, s9_139, s9_188)));
  const double s9_262 = fma(m_upper_arm_right, s9_261, fma(m_wheel_rear_right, s9_260, s9_259));
  const double s9_263 = fma(work.v_wheel_front_right_z, work.v_wheel_front_right_z, s9_193);
  const double s9_264 = fma(s9_148, s9_148, fma(s9_146, s9_146, fma(s9_144, s9_144, s9_194)));
  const double s9_265 = fma(m_carrier_right, s9_264, fma(m_wheel_front_right, s9_263, s9_262));
  const double s9_266 = fma(s9_156, s9_156, fma(s9_154, s9_154, fma(s9_153, s9_153, s9_195)));
  const double s9_267 = fma(s9_205, s9_196 + fma(work.w_rear_axle_z, s7_67, s9_54), s9_204);
  const double s9_268 = fma(5.333333333333333, s9_267, fma(m_lower_arm_right, s9_266, s9_265));
  const double s9_269 = fma(s9_215, s9_206 + fma(work.w_rear_axle_z, s7_60, s9_57), s9_214);
  const double s9_270 = fma(s9_226, fma(work.w_chassis_x, work.s7_34, s9_67), s9_225);
  result.kinetic_energy = 0.5*fma(2.3333333333333335, s9_270, fma(6.0, s9_269, s9_268));
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_271 = z_rear_axle_ty + z_rear_axle_ty;
  const double s9_272 = work.r_carrier_right_aux1_y + (work.r_carrier_left_aux1_y + s9_271);
  const double s9_273 = work.r_carrier_left_aux1_y + work.r_carrier_right_aux1_y;
  const double s9_274 = fma(m_bell_crank, s7_157, fma(1.5, work.s7_30, 5.25));
  const double s9_275 = s7_80 + (work.s7_26 + (work.s7_13 + s9_272)) - s7_87;
  const double s9_276 = fma(m_rear_axle, z_rear_axle_ty + s7_139, s9_274);
  const double s9_277 = s7_54 + (work.s7_43 + (work.s7_34 + s9_273) - work.s7_44);
  const double s9_278 = fma(1.1666666666666667, s9_277, fma(0.3333333333333333, s9_275, s9_276));
  const double s9_279 = fma(3.0, s7_83 + (s7_63 + s9_271), s9_278);
  const double s9_280 = fma(2.6666666666666665, s7_86 + (s7_69 + s9_271), s9_279);
  const double s9_281 = work.r_wheel_rear_left_y + work.r_wheel_rear_right_y;
  const double s9_282 = fma(m_wheel_rear_right, s9_281, s9_280);
  const double s9_283 = work.r_wheel_front_left_y + work.r_wheel_front_right_y;
  const double s9_284 = fma(m_upper_arm_right, s7_192 + s7_269, s9_282);
  const double s9_285 = fma(m_wheel_front_right, s9_283, s9_284);
  const double s9_286 = fma(m_carrier_right, s7_291 + (s7_216 + s9_273), s9_285);
  const double s9_287 = work.s7_4 + (work.r_rear_axle_aux1_x + (8.5 + work.r_rear_axle_aux1_x));
  const double s9_288 = s7_79 + (s7_77 + (work.s7_20 + (work.s7_17 + (work.s7_7 + s9_287))));
  const double s9_289 = work.r_rear_axle_aux1_x + work.r_rear_axle_aux1_x;
  const double s9_290 = fma(m_rear_axle, work.r_rear_axle_aux1_x + s7_143, 232.0);
  const double s9_291 = fma(m_bell_crank, p_bell_crank_x - s7_156, s9_290);
  const double s9_292 = fma(m_pitman_arm, p_pitman_arm_x - s7_165, s9_291);
  const double s9_293 = s7_48 + (work.s7_45 + (work.s7_37 + (13.7 - work.s7_33)));
  const double s9_294 = fma(0.3333333333333333, s7_91 + (s9_288 - s7_88), s9_292);
  const double s9_295 = s7_252 + (s7_177 + (s7_116 + (1.3 + s7_93)));
  const double s9_296 = fma(m_arb_rear_right, s9_295, fma(1.1666666666666667, s9_293, s9_294));
  const double s9_297 = fma(1.5, 7.65 - work.s7_27 - work.s7_29, s9_296);
  const double s9_298 = fma(3.0, s7_82 + (s7_60 + s9_289), s9_297);
  const double s9_299 = fma(2.6666666666666665, s7_85 + (s7_67 + s9_289), s9_298);
  const double s9_300 = work.r_wheel_rear_left_x + work.r_wheel_rear_right_x;
  const double s9_301 = work.r_wheel_front_left_x + work.r_wheel_front_right_x;
  const double s9_302 = fma(m_wheel_rear_right, s9_300, s9_299);
  const double s9_303 = fma(m_wheel_front_right, s9_301, s9_302);
  const double s9_304 = work.r_carrier_left_aux1_z - 1.9 - work.s1_39;
  const double s9_305 = work.r_rear_axle_aux3_z + (work.r_rear_axle_aux3_z + s9_304);
  const double s9_306 = work.s7_23 + (work.s7_15 + (work.s7_10 + (work.s7_2 + s9_305))) - s7_70;
  const double s9_307 = work.r_carrier_left_aux1_z - work.s1_39;
  const double s9_308 = work.r_rear_axle_aux3_z + work.r_rear_axle_aux3_z;
  const double s9_309 = fnma(1.5, work.s7_28 - p_pitman_arm_z, 3350.4);
  const double s9_310 = fnma(m_pitman_arm, s7_166 - p_pitman_arm_z, s9_309);
  const double s9_311 = fma(m_rear_axle, work.r_rear_axle_aux3_z + s7_141, s9_310);
  const double s9_312 = fma(0.3333333333333333, s7_78 + s9_306 - s7_89 - s7_90, s9_311);
  const double s9_313 = s7_250 + (s7_175 - (s7_115 + (1.9 + s7_92)));
  const double s9_314 = fma(m_arb_rear_right, s9_313, s9_312);
  const double s9_315 = fma(1.1666666666666667, s7_51 + (work.s7_40 + s9_307), s9_314);
  const double s9_316 = fma(3.0, s7_81 + (s7_57 + s9_308), s9_315);
  const double s9_317 = fma(2.6666666666666665, s7_84 + (s7_65 + s9_308), s9_316);
  const double s9_318 = work.r_wheel_rear_left_z + work.r_wheel_rear_right_z;
  const double s9_319 = fma(m_wheel_rear_right, s9_318, s9_317);
  const double s9_320 = fma(m_upper_arm_right, s7_267 - (0.56 + s7_194), s9_319);
  const double s9_321 = work.r_wheel_front_left_z + work.r_wheel_front_right_z;
  const double s9_322 = fma(m_wheel_front_right, s9_321, s9_320);
  const double s9_323 = fma(m_carrier_right, s7_294 + (s7_219 + s9_307), s9_322);
  const double s9_324 = fma(m_lower_arm_right, s7_239 + s7_316, s9_286);
  const double s9_325 = fma(work.R_chassis_z_y, s9_324, 15306.0*work.r_chassis_aux3_z);
  const double s9_326 = fma(m_carrier_right, s7_297 + (7.2 + s7_222), s9_303);
  const double s9_327 = fma(m_lower_arm_right, s7_314 - (1.24 + s7_241), s9_323);
  const double s9_328 = fma(work.R_chassis_z_z, s9_327, fma(work.R_chassis_z_x, s9_326, s9_325));
  result.potential_energy = -g_z*s9_328;
  // operations: 485 add, 413 multiply
}

/// Outputs, energies and power, at given accelerations.
void compute_outputs(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    const double* tau, const Derivative& /*derivative*/, Outputs& __restrict result) noexcept {
  OutputsWork work;
  compute_outputs_1(state, work);
  compute_outputs_2(state, tau, work, result);
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

mbgen::Status step_rk4(const Tuned& parameters, const Inputs& inputs, State& state, double h) noexcept {
  return mbgen::step_rk4(Dynamics{parameters, inputs}, state, h);
}

mbgen::Status step_abm4(const Tuned& parameters, const Inputs& inputs, State& state, History& history,
                        double h) noexcept {
  return mbgen::step_abm4(Dynamics{parameters, inputs}, state, history, h);
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
