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
constexpr double c_arb_front_left_y = 0.06692307692307692;
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
constexpr double c_arb_front_right_y = -0.06692307692307692;
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
constexpr double c_bell_crank_y = 0.09720000000000001;
constexpr double I_bell_crank_xx = 0.2800026666666667;
constexpr double I_bell_crank_yy = 0.14412600000000003;
constexpr double I_bell_crank_zz = 0.4041286666666667;
constexpr double I_bell_crank_xy = -0.10155600000000001;
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
constexpr double c_arb_rear_left_y = 0.057692307692307696;
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
constexpr double c_arb_rear_right_y = -0.057692307692307696;
constexpr double I_arb_rear_right_xx = 0.15615384615384614;
constexpr double I_arb_rear_right_yy = 0.14461538461538462;
constexpr double I_arb_rear_right_zz = 0.23076923076923078;
constexpr double I_arb_rear_right_xy = 0.01230769230769231;
constexpr double p_arb_link_front_left_from_x = -0.25;
constexpr double p_arb_link_front_left_from_y = 0.27;
constexpr double p_arb_link_front_left_from_z = 0.1;
constexpr double p_arb_link_front_left_to_x = 0.1;
constexpr double p_arb_link_front_left_to_y = -0.03;
constexpr double l_arb_link_front_left = 0.26;
constexpr double p_arb_link_front_right_from_x = -0.25;
constexpr double p_arb_link_front_right_from_y = -0.27;
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
constexpr double p_arb_link_rear_left_from_y = 0.15;
constexpr double p_arb_link_rear_left_to_x = -0.35;
constexpr double p_arb_link_rear_left_to_y = 0.6;
constexpr double p_arb_link_rear_left_to_z = -0.15;
constexpr double l_arb_link_rear_left = 0.22360679774997896;
constexpr double p_long_rod_right_from_x = -1.6;
constexpr double p_long_rod_right_from_y = -0.55;
constexpr double p_long_rod_right_from_z = -0.55;
constexpr double l_long_rod_right = 0.8505292469985968;
constexpr double p_diag_rod_right_from_x = -1.7;
constexpr double p_diag_rod_right_from_y = -0.4;
constexpr double p_diag_rod_right_from_z = -0.15;
constexpr double l_diag_rod_right = 0.8602325267042626;
constexpr double p_arb_link_rear_right_from_x = 0.35;
constexpr double p_arb_link_rear_right_from_y = -0.15;
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
constexpr double p_arb_front_left_y = 0.45;
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
constexpr double p_arb_front_right_y = -0.45;
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
constexpr double p_arb_rear_left_y = 0.45;
constexpr double p_arb_rear_left_z = -0.45;
constexpr double p_arb_rear_right_x = -3.3;
constexpr double p_arb_rear_right_y = -0.45;
constexpr double p_arb_rear_right_z = -0.45;
constexpr double h_chassis_x = -55.99999999999999;
constexpr double h_chassis_y = 2.220446049250313e-16;
constexpr double h_chassis_z = 3362.7;
constexpr double K_chassis_xx = 140092.31999999998;
constexpr double K_chassis_yy = 5008.005000000032;
constexpr double K_chassis_zz = 10849.555000000006;
constexpr double K_chassis_xy = 4.440892098500626e-16;
constexpr double K_chassis_xz = 19.919999999999998;
constexpr double h_lower_arm_left_y = 5.5;
constexpr double h_lower_arm_left_z = -0.625;
constexpr double K_lower_arm_left_xx = 0.225;
constexpr double K_lower_arm_left_yy = 1.785;
constexpr double K_lower_arm_left_zz = 0.040625;
constexpr double K_lower_arm_left_yz = -0.1375;
constexpr double m_carrier_left_2 = 219.5;
constexpr double h_carrier_left_x = -0.6700000000000002;
constexpr double h_carrier_left_y = 26.97;
constexpr double h_carrier_left_z = 36.825;
constexpr double K_carrier_left_xx = 1.4293999999999993;
constexpr double K_carrier_left_yy = 11.679275;
constexpr double K_carrier_left_zz = 7.48155;
constexpr double K_carrier_left_xy = 0.0355;
constexpr double K_carrier_left_xz = -0.0509;
constexpr double K_carrier_left_yz = 4.6066;
constexpr double K_carrier_left_trace = 20.590225;
constexpr double I_wheel_front_left_polar = 11.0;
constexpr double h_upper_arm_left_y = 2.25;
constexpr double h_upper_arm_left_z = -0.15;
constexpr double K_upper_arm_left_xx = 0.075;
constexpr double K_upper_arm_left_yy = 0.5125;
constexpr double K_upper_arm_left_zz = 0.0265;
constexpr double K_upper_arm_left_yz = -0.0225;
constexpr double h_arb_front_left_x = -1.29;
constexpr double h_arb_front_left_z = 0.5;
constexpr double K_arb_front_left_xx = 0.2827;
constexpr double K_arb_front_left_yy = 0.20789999999999997;
constexpr double K_arb_front_left_zz = 0.06499999999999997;
constexpr double K_arb_front_left_xy = -0.1195;
constexpr double K_arb_front_left_xz = -0.077;
constexpr double K_arb_front_left_yz = 0.047;
constexpr double h_lower_arm_right_y = -5.5;
constexpr double h_lower_arm_right_z = -0.625;
constexpr double K_lower_arm_right_xx = 0.225;
constexpr double K_lower_arm_right_yy = 1.785;
constexpr double K_lower_arm_right_zz = 0.040625;
constexpr double K_lower_arm_right_yz = 0.1375;
constexpr double m_carrier_right_2 = 219.5;
constexpr double h_carrier_right_x = -0.6700000000000002;
constexpr double h_carrier_right_y = -26.97;
constexpr double h_carrier_right_z = 36.825;
constexpr double K_carrier_right_xx = 1.4293999999999993;
constexpr double K_carrier_right_yy = 11.679275;
constexpr double K_carrier_right_zz = 7.48155;
constexpr double K_carrier_right_xy = -0.0355;
constexpr double K_carrier_right_xz = -0.0509;
constexpr double K_carrier_right_yz = -4.6066;
constexpr double K_carrier_right_trace = 20.590225;
constexpr double I_wheel_front_right_polar = 11.0;
constexpr double h_upper_arm_right_y = -2.25;
constexpr double h_upper_arm_right_z = -0.15;
constexpr double K_upper_arm_right_xx = 0.075;
constexpr double K_upper_arm_right_yy = 0.5125;
constexpr double K_upper_arm_right_zz = 0.0265;
constexpr double K_upper_arm_right_yz = 0.0225;
constexpr double h_arb_front_right_x = -1.29;
constexpr double h_arb_front_right_z = 0.5;
constexpr double K_arb_front_right_xx = 0.2827;
constexpr double K_arb_front_right_yy = 0.20789999999999997;
constexpr double K_arb_front_right_zz = 0.06499999999999997;
constexpr double K_arb_front_right_xy = 0.1195;
constexpr double K_arb_front_right_xz = -0.077;
constexpr double K_arb_front_right_yz = -0.047;
constexpr double h_pitman_arm_z = -1.65;
constexpr double K_pitman_arm_xx = 0.02;
constexpr double K_pitman_arm_yy = 0.01;
constexpr double K_pitman_arm_zz = 0.3304;
constexpr double h_bell_crank_x = -2.0300000000000002;
constexpr double h_bell_crank_y = 2.0700000000000003;
constexpr double K_bell_crank_xx = 0.3741000000000001;
constexpr double K_bell_crank_yy = 0.5773999999999999;
constexpr double K_bell_crank_xy = -0.05040000000000003;
constexpr double K_bell_crank_trace = 0.9615;
constexpr double m_rear_axle_2 = 1186.0;
constexpr double h_rear_axle_x = 0.20000000000000012;
constexpr double h_rear_axle_z = 2.26;
constexpr double K_rear_axle_xx = 22.789999999999992;
constexpr double K_rear_axle_yy = 617.7850000000001;
constexpr double K_rear_axle_zz = 23.660200000000025;
constexpr double K_rear_axle_xz = 0.032999999999999995;
constexpr double K_rear_axle_yz = -3.469446951953614e-18;
constexpr double K_rear_axle_trace = 664.2352000000001;
constexpr double h_arb_rear_left_x = 1.5499999999999998;
constexpr double K_arb_rear_left_xx = 0.38749999999999996;
constexpr double K_arb_rear_left_yy = 0.1575;
constexpr double K_arb_rear_left_zz = 0.034999999999999976;
constexpr double K_arb_rear_left_xy = 0.1125;
constexpr double I_wheel_rear_right_polar = 22.0;
constexpr double h_arb_rear_right_x = 1.5499999999999998;
constexpr double K_arb_rear_right_xx = 0.38749999999999996;
constexpr double K_arb_rear_right_yy = 0.1575;
constexpr double K_arb_rear_right_zz = 0.034999999999999976;
constexpr double K_arb_rear_right_xy = -0.1125;
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
      sines[22], cosines[22], R_chassis_x_y, R_chassis_y_y, R_chassis_x_z, R_chassis_y_z,
      R_chassis_z_z, R_chassis_z_y, s1_6, R_carrier_left_aux1_y_x, R_carrier_left_aux1_z_x, s1_11,
      s1_13, R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, s1_17, s1_22, R_carrier_left_x_x,
      R_carrier_left_x_z, R_carrier_left_y_x, R_carrier_left_y_z, R_carrier_left_z_x,
      R_carrier_left_z_z, R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x, s1_31, s1_33,
      R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, s1_37, s1_42, R_carrier_right_x_x,
      R_carrier_right_x_z, R_carrier_right_y_x, R_carrier_right_y_z, R_carrier_right_z_x,
      R_carrier_right_z_z, R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, s1_50, R_rear_axle_x_y,
      R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z,
      R_chassis_aux5_x_x, R_chassis_aux5_y_x, s7_4, s7_7, s7_9, s1_55, s1_56, s1_58, s1_59, s1_60,
      s1_62, s1_63, s1_65, s1_67, s1_69, s1_71, s1_72, s1_74, s1_76, s1_77, s1_79, s1_81, s1_83,
      s1_85, s1_87, s1_88, s1_90, s1_92, s1_93, s1_95, s1_97, s1_98, s1_100, s1_101, s1_102, s1_104,
      s1_105, s4_1, s4_2, w_chassis_y, s4_3, s4_4, w_chassis_z, s4_5, s4_6, s4_7, s4_8, s4_9, s4_10,
      s4_11, s4_12, s4_13, s4_14, s4_15, s4_16, s4_17, s4_18, s4_19, s4_20, s4_21, s4_22, s4_23,
      s4_24, s4_25, s4_26, s4_27, s4_28, s4_29, s4_30, s4_32, s4_33, w_chassis_x, s4_34, s4_35,
      s4_37, s4_38, s4_39, s4_40, s4_41, s4_42, s4_43, s4_44, s4_45, s4_46, s4_47, s4_48, s4_49,
      s4_50, w_carrier_left_x, w_carrier_left_y, s4_52, w_carrier_left_z, s4_54, s4_57, s4_59,
      w_carrier_right_x, w_carrier_right_y, s4_61, w_carrier_right_z, s4_63, s4_66, s4_68,
      w_rear_axle_x, w_rear_axle_y, w_rear_axle_z, s8_3, s8_4, s8_5, r_rear_axle_aux3_z, s2_7, s2_8,
      s2_9, r_rear_axle_aux1_x, s2_11, s2_12, s2_13, s2_17, s2_18, s2_19, s2_21, s2_22, s2_24,
      s2_26, s2_28, s2_29, s2_33, s2_34, s2_35, s2_42, s2_43, s2_45, s2_46, s2_48, s2_50, s2_53,
      s2_54, s2_55, s2_57, s2_58, s2_60, s2_61, s2_63, s2_66, s2_67, s2_68, s2_69, s2_70,
      pivot_rear_axle_tx, s2_71, s2_73, s2_75, s2_78, s2_79, s2_80, s2_81, s2_84, s2_85, s2_87,
      s2_88, s2_91, s2_92, s2_94, s2_95, s2_97, s2_150, s3_2, Rz_rear_axle_rz_0, Rz_rear_axle_ry_0,
      Rz_rear_axle_rx_0, s3_8, Rz_rear_axle_tx_0, Rz_rear_axle_tz_1, s3_10, Rz_rear_axle_ry_1,
      Rz_rear_axle_rx_1, s3_14, Rz_rear_axle_tx_1, s6_1, s6_2, s6_3, s6_4, s6_5, s6_6, s6_8, s6_10,
      s6_11, s6_12, s6_13, s6_14, s6_15, s6_16, s6_17, s6_18, s6_19, s6_41, s6_43, s6_44, s6_45,
      s6_46, zdd_star_rear_axle_tz, zdd_star_rear_axle_rz, zdd_star_rear_axle_ry,
      zdd_star_rear_axle_rx, s6_58, zdd_star_rear_axle_tx, s7_11, s7_13, s7_14, s8_12, s8_15, s8_17,
      s8_18, s8_19, s8_21, s8_22, s8_23, s8_24, s8_27, s8_28, s8_35, s8_36, s8_39, s8_41, s8_42,
      s8_44, s8_46, s8_47, s8_48, s8_57, s8_59, s8_71, s8_73, s8_74, s8_75, s8_76, s8_88, s8_349,
      s8_354, s8_364, s8_372, s8_382, s8_386, s8_390, s8_397, s8_404, s8_412, s8_445, s8_447,
      s8_448, s8_450, s8_451, s8_452, s8_453, s8_454, s8_461, s8_469, s8_478, s8_479, s8_482,
      s8_483, s8_484, s8_485, s8_486, s8_493, s8_496, s8_499, s8_500, s8_501, s8_502, s8_503,
      s8_504, s8_508, s8_511, s8_512, s8_513, s8_514, s8_518, s8_521, s8_522, s8_523, s8_536,
      s8_539, s8_552, s8_555, s8_556, s8_567, s8_570, s8_572, s8_573, s8_576, s8_578, s8_579,
      s2_178, s2_180, s2_183, s2_184, s2_187, r_carrier_left_aux1_z, s2_190, s2_194,
      r_carrier_left_aux1_y, s2_197, s2_202, s2_204, s2_207, s2_208, s2_211, s2_213, s2_214, s2_218,
      r_carrier_right_aux1_y, s2_221, s2_225, s2_226, s2_227, s2_228, s2_229, s2_230, s2_231,
      s2_234, s2_235, s2_237, s2_240, s2_241, s2_244, s2_248, s2_249, s2_254, s2_256, s2_257,
      s2_259, s2_261, s2_263, s2_265, s2_268, s2_308, s3_18, s3_19, Rz_upper_arm_left_2,
      Rz_lower_arm_left_2, s3_20, s3_21, s3_22, s3_23, s3_24, Rz_arb_front_left_0, s3_29,
      Rz_arb_front_left_2, s3_31, s3_33, s3_34, s3_35, Rz_carrier_right_rz_2, Rz_carrier_right_ry_1,
      Rz_carrier_right_rx_1, s3_39, Rz_carrier_right_ry_2, s3_41, Rz_carrier_right_rx_2, s3_45,
      Rz_arb_front_right_1, s3_49, Rz_arb_front_right_2, s3_52, s3_55, s3_57, s6_65, s6_66, s6_67,
      s6_68, s6_69, s6_70, s6_71, s6_74, s6_75, s6_78, s6_79, s6_80, s6_81, s6_82, s6_83, s6_84,
      s6_87, s6_88, s6_89, s6_90, s6_91, s6_94, s6_96, s6_97, s6_101, s6_103, s6_104, s6_105,
      s6_106, s6_108, s6_111, s6_115, s6_116, s6_119, s6_120, s6_121, s6_122, s6_123, s6_134,
      zdd_star_lower_arm_left, zdd_star_carrier_left_ry, zdd_star_carrier_left_rx, s6_137,
      zdd_star_arb_front_left, s6_147, zdd_star_carrier_right_rz, zdd_star_carrier_right_ry,
      zdd_star_carrier_right_rx, s6_149, zdd_star_arb_front_right, s6_154, s7_54, s7_56, s7_61,
      s7_62, s7_63, s7_64, s7_65, s7_74, s7_77, s7_80, s8_580, s8_581, s8_583, s8_584, s8_585,
      s7_91, s7_96, s7_98, s7_100, s7_102, s8_586, s8_587, s8_588, s8_589, s8_590, s8_591, s8_592,
      s8_593, s7_106, s7_108, s8_594, s8_595, s7_113, s7_114, s7_115, s7_119, s7_121, s7_123,
      s7_125, s8_596, s8_597, s7_130, s7_131, s7_132, s7_133, s7_136, s7_138, s7_143, s7_144,
      s7_145, s7_147, s8_599, s8_606, s8_607, s8_608, s7_190, s7_192, s8_615, s8_616, s7_197,
      s7_198, s7_199, s7_203, s7_205, s8_617, s8_618, s7_207, s7_209, s7_214, s7_215, s7_216,
      s7_217, s7_221, s7_222, s7_223, s7_224, s7_227, s7_228, s7_229, s7_232, s7_233, s7_238,
      s7_239, s7_242, s7_243, s8_621, s8_622, s8_624, s8_629, s8_630, s8_631, s8_632, s8_634,
      s8_635, s8_636, s8_639, s8_640, s8_641, s8_642, s8_643, s8_644, s8_648, s8_650, s8_655,
      s8_656, s8_657, s8_658, s8_659, s8_660, s8_662, s8_664, f_carrier_right_x, f_carrier_right_y,
      f_carrier_right_z, n_carrier_right_x, n_carrier_right_y, s8_704, s8_705, s8_706, s8_709,
      s8_710, s8_720, s8_727, s8_735, s8_740, s8_741, s8_742, s8_743, s8_748, s8_749, s8_750,
      s8_751, s8_758, s8_759, s8_764, s8_765, s8_766, s8_769, s8_774, s8_776, s8_782,
      f_carrier_left_x, f_carrier_left_y, f_carrier_left_z, n_carrier_left_x, n_carrier_left_y,
      s8_822, s8_824, s8_825, s8_829, s8_832, s8_835, s8_836, s8_837, s8_840, s8_851, s8_858,
      s8_865, s8_869, s8_871, s8_872, s8_873, s8_875, s8_876, s8_877, s8_880, s8_884, s8_885,
      s8_888, s8_892, s8_897, s8_905, s8_916, s8_923, s8_931, s8_934, s8_938, s8_940, s8_944,
      s8_947, s8_957, s8_964, s8_971, s8_990, s8_993, s8_996, s8_999, s8_1002, s8_1010, s8_1011,
      s8_1014, s8_1015, s8_1020, s8_1027, s8_1034, s8_1041, pivot_bell_crank, s8_1061, s8_1062,
      s8_1063, s8_1064, s8_1065, s8_1066, s8_1067, s8_1068, s8_1069, s8_1071, s8_1073, s8_1075,
      s8_1091, s8_1110, s8_1125, s8_1135, s8_1141, s8_1150, s8_1152, s8_1154, s8_1166, s8_1170;
};

/// Part 1 of compute_accelerations: step 1: poses and axes b; step 7: inertias of the bodies and
/// forces on joints; step 1: poses and axes b; step 4: velocities; step 8: elimination from the
/// leaves to the root (63); step 2: closure Jacobian Phi_z and its factors (60), long_rod_left ..
/// arb_link_rear_right; step 3: Rz (61), long_rod_left .. arb_link_rear_right; step 6: c and dRz/dt
/// zd (62), long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_accelerations_1(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // Results that need no operation.
  result.inertia[9] = 10.999999999989;
  result.inertia[10] = 10.999999999989;
  result.inertia[13] = 21.999999999978;
  result.inertia[14] = 21.999999999978;

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
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s1_1 = work.sines[1];
  const double s1_2 = work.sines[2];
  const double s1_3 = s1_1*s1_2;
  const double R_chassis_aux4_x_x = work.cosines[0];
  const double R_chassis_aux4_y_x = work.sines[0];
  const double s1_4 = work.cosines[2];
  work.R_chassis_x_y = fnma(R_chassis_aux4_y_x, s1_4, R_chassis_aux4_x_x*s1_3);
  work.R_chassis_y_y = fma(R_chassis_aux4_y_x, s1_3, R_chassis_aux4_x_x*s1_4);
  const double s1_5 = s1_1*s1_4;
  work.R_chassis_x_z = fma(R_chassis_aux4_x_x, s1_5, R_chassis_aux4_y_x*s1_2);
  work.R_chassis_y_z = fnma(R_chassis_aux4_x_x, s1_2, R_chassis_aux4_y_x*s1_5);
  const double R_chassis_aux5_z_z = work.cosines[1];
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_4;
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_2;
  work.s1_6 = fma(s1_4, work.R_chassis_z_z, s1_2*work.R_chassis_z_y);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s1_7 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_7;
  const double R_lower_arm_left_z_y = work.sines[3];
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_7;
  const double s1_8 = R_lower_arm_left_z_y*work.R_carrier_left_aux1_z_x;
  const double s1_9 = fma(R_lower_arm_left_y_y, work.R_carrier_left_aux1_y_x, s1_8);
  const double s1_10 = -p_carrier_left_rz_z*R_lower_arm_left_z_y;
  work.s1_11 = fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_10);
  const double s1_12 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_13 = fnma(-p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_12);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double s1_14 = work.cosines[5];
  const double s1_15 = work.sines[5];
  work.R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_15, R_carrier_left_aux1_y_y*s1_14);
  const double s1_16 = fma(R_carrier_left_aux1_y_y, s1_15, R_lower_arm_left_z_y*s1_14);
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  work.R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_y, s1_14, R_lower_arm_left_y_y*s1_15);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_15,
      R_lower_arm_left_y_y*s1_14);
  work.s1_17 = s1_7*s1_14;
  const double s1_18 = work.R_carrier_left_aux1_z_x*work.s1_17;
  const double s1_19 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s1_18);
  const double s1_20 = work.R_carrier_left_aux1_y_x*work.s1_17;
  const double s1_21 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s1_20);
  work.s1_22 = fma(R_lower_arm_left_y_y, s1_21, R_lower_arm_left_z_y*s1_19);
  const double s1_23 = work.R_carrier_left_aux1_y_x*work.R_carrier_left_aux2_z_y;
  const double s1_24 = fnma(work.R_carrier_left_aux1_z_x, work.R_carrier_left_aux2_y_y, s1_23);
  const double R_carrier_left_aux2_x_z = s1_7*s1_15;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = work.cosines[6];
  const double s1_26 = work.sines[6];
  work.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_26, R_carrier_left_aux1_x_x*s1_25);
  work.R_carrier_left_x_z = fma(R_carrier_left_aux2_x_z, s1_25, R_carrier_left_aux1_x_x*s1_26);
  work.R_carrier_left_y_x = fma(s1_16, s1_26, work.R_carrier_left_aux1_y_x*s1_25);
  work.R_carrier_left_y_z = fnma(s1_16, s1_25, work.R_carrier_left_aux1_y_x*s1_26);
  work.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_26,
      work.R_carrier_left_aux1_z_x*s1_25);
  work.R_carrier_left_z_z = fma(R_carrier_left_aux2_z_z, s1_25, work.R_carrier_left_aux1_z_x*s1_26);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_27 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_27;
  const double R_lower_arm_right_z_y = work.sines[9];
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_27;
  const double s1_28 = R_lower_arm_right_z_y*work.R_carrier_right_aux1_z_x;
  const double s1_29 = fma(R_lower_arm_right_y_y, work.R_carrier_right_aux1_y_x, s1_28);
  const double s1_30 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  work.s1_31 = fnma(-p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_30);
  const double s1_32 = -p_carrier_right_rz_y*R_lower_arm_right_z_y;
  work.s1_33 = fma(-p_carrier_right_rz_z, R_lower_arm_right_y_y, s1_32);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double s1_34 = work.cosines[11];
  const double s1_35 = work.sines[11];
  work.R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_35,
      R_carrier_right_aux1_y_y*s1_34);
  const double s1_36 = fma(R_carrier_right_aux1_y_y, s1_35, R_lower_arm_right_z_y*s1_34);
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  work.R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_y, s1_34, R_lower_arm_right_y_y*s1_35);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_35,
      R_lower_arm_right_y_y*s1_34);
  work.s1_37 = s1_27*s1_34;
  const double s1_38 = work.R_carrier_right_aux1_z_x*work.s1_37;
  const double s1_39 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s1_38);
  const double s1_40 = work.R_carrier_right_aux1_y_x*work.s1_37;
  const double s1_41 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s1_40);
  work.s1_42 = fma(R_lower_arm_right_y_y, s1_41, R_lower_arm_right_z_y*s1_39);
  const double s1_43 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s1_44 = fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y, s1_43);
  const double R_carrier_right_aux2_x_z = s1_27*s1_35;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_45 = work.cosines[12];
  const double s1_46 = work.sines[12];
  work.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_46, R_carrier_right_aux1_x_x*s1_45);
  work.R_carrier_right_x_z = fma(R_carrier_right_aux2_x_z, s1_45, R_carrier_right_aux1_x_x*s1_46);
  work.R_carrier_right_y_x = fma(s1_36, s1_46, work.R_carrier_right_aux1_y_x*s1_45);
  work.R_carrier_right_y_z = fnma(s1_36, s1_45, work.R_carrier_right_aux1_y_x*s1_46);
  const double s1_47 = work.R_carrier_right_aux1_z_x*s1_45;
  work.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_46, s1_47);
  const double s1_48 = work.R_carrier_right_aux1_z_x*s1_46;
  work.R_carrier_right_z_z = fma(R_carrier_right_aux2_z_z, s1_45, s1_48);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s1_49 = R_rear_axle_aux4_y_x*work.R_rear_axle_aux5_y_x;
  work.s1_50 = fma(R_rear_axle_aux4_x_x, work.R_rear_axle_aux5_x_x, s1_49);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_51 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_51;
  const double s1_52 = work.sines[19];
  const double s1_53 = work.cosines[19];
  work.R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_53, R_rear_axle_aux5_x_z*s1_52);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_53, R_rear_axle_aux4_y_x*s1_52);
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_51;
  work.R_rear_axle_y_y = fma(R_rear_axle_aux5_y_z, s1_52, R_rear_axle_aux4_x_x*s1_53);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_52, R_rear_axle_aux5_y_z*s1_53);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_52;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_53;

  // --- step 7: inertias of the bodies and forces on joints ---
  // chassis_aux3: chassis_tz, prismatic, chassis_aux2
  work.R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  work.R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double s7_1 = work.R_chassis_aux5_y_x*tau_chassis_ty;
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  const double s7_2 = work.R_chassis_z_y*tau_chassis_tz;
  const double s7_3 = fma(work.R_chassis_y_y, tau_chassis_ty, s7_2);
  work.s7_4 = fma(work.R_chassis_x_y, tau_chassis_tx, s7_3);
  const double s7_5 = work.R_chassis_z_z*tau_chassis_tz;
  const double s7_6 = fma(work.R_chassis_x_z, tau_chassis_tx, s7_5);
  work.s7_7 = fma(work.R_chassis_y_z, tau_chassis_ty, s7_6);
  const double s7_8 = fma(work.R_chassis_aux5_x_x, tau_chassis_tx, s7_1);
  work.s7_9 = fnma(s1_1, tau_chassis_tz, s7_8);
  // operations: 6 add, 11 multiply

  // --- step 1: poses and axes b, continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s1_54 = 1.0/work.s1_6;
  work.s1_55 = s1_3*s1_54;
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  work.s1_56 = s1_2*s1_54;
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double s1_57 = fma(s1_4, tau_chassis_ry, tau_chassis_rx*work.s1_55);
  work.s1_58 = fma(tau_chassis_rz, work.s1_56, s1_57);
  work.s1_59 = s1_5*s1_54;
  work.s1_60 = s1_4*s1_54;
  const double s1_61 = fma(tau_chassis_rz, work.s1_60, tau_chassis_rx*work.s1_59);
  work.s1_62 = fnma(s1_2, tau_chassis_ry, s1_61);
  work.s1_63 = work.s1_6*s1_54;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_64 = 1.0/work.s1_22;
  work.s1_65 = R_carrier_left_aux1_z_y*s1_64;
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double s1_66 = tau_carrier_left_ry*work.s1_65;
  work.s1_67 = R_carrier_left_aux1_y_y*s1_64;
  const double s1_68 = tau_carrier_left_ry*work.s1_67;
  work.s1_69 = s1_21*s1_64;
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double s1_70 = fma(work.R_carrier_left_aux1_z_x, tau_carrier_left_rx, s1_66);
  work.s1_71 = fma(tau_carrier_left_rz, work.s1_69, s1_70);
  work.s1_72 = s1_64*s1_24;
  const double s1_73 = R_carrier_left_aux1_x_x*tau_carrier_left_rx;
  work.s1_74 = s1_9*s1_64;
  const double s1_75 = fma(tau_carrier_left_rz, work.s1_72, s1_73);
  work.s1_76 = fnma(tau_carrier_left_ry, work.s1_74, s1_75);
  work.s1_77 = s1_19*s1_64;
  const double s1_78 = fma(work.R_carrier_left_aux1_y_x, tau_carrier_left_rx, s1_68);
  work.s1_79 = fnma(tau_carrier_left_rz, work.s1_77, s1_78);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_80 = 1.0/work.s1_42;
  work.s1_81 = R_carrier_right_aux1_z_y*s1_80;
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double s1_82 = tau_carrier_right_ry*work.s1_81;
  work.s1_83 = R_carrier_right_aux1_y_y*s1_80;
  const double s1_84 = tau_carrier_right_ry*work.s1_83;
  work.s1_85 = s1_41*s1_80;
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s1_86 = fma(work.R_carrier_right_aux1_z_x, tau_carrier_right_rx, s1_82);
  work.s1_87 = fma(tau_carrier_right_rz, work.s1_85, s1_86);
  work.s1_88 = s1_80*s1_44;
  const double s1_89 = R_carrier_right_aux1_x_x*tau_carrier_right_rx;
  work.s1_90 = s1_29*s1_80;
  const double s1_91 = fma(tau_carrier_right_rz, work.s1_88, s1_89);
  work.s1_92 = fnma(tau_carrier_right_ry, work.s1_90, s1_91);
  work.s1_93 = s1_39*s1_80;
  const double s1_94 = fma(work.R_carrier_right_aux1_y_x, tau_carrier_right_rx, s1_84);
  work.s1_95 = fnma(tau_carrier_right_rz, work.s1_93, s1_94);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_96 = 1.0/work.s1_50;
  work.s1_97 = R_rear_axle_aux4_y_x*s1_96;
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  work.s1_98 = R_rear_axle_aux5_y_z*s1_96;
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s1_99 = fma(R_rear_axle_aux4_x_x, tau_rear_axle_ry, tau_rear_axle_rx*work.s1_97);
  work.s1_100 = fma(tau_rear_axle_rz, work.s1_98, s1_99);
  work.s1_101 = R_rear_axle_aux5_x_z*s1_96;
  work.s1_102 = R_rear_axle_aux4_x_x*s1_96;
  const double s1_103 = fma(tau_rear_axle_rz, work.s1_101, tau_rear_axle_rx*work.s1_102);
  work.s1_104 = fnma(R_rear_axle_aux4_y_x, tau_rear_axle_ry, s1_103);
  work.s1_105 = work.s1_50*s1_96;
  // operations: 64 add, 162 multiply, 4 divide, 44 sin cos

  // --- step 4: velocities ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  work.s4_1 = zd_chassis_rz*work.R_chassis_z_y;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.s4_2 = zd_chassis_ry*s1_4;
  work.w_chassis_y = work.s4_1 + work.s4_2;
  work.s4_3 = zd_chassis_rz*work.R_chassis_z_z;
  work.s4_4 = zd_chassis_ry*s1_2;
  work.w_chassis_z = work.s4_3 - work.s4_4;
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  work.s4_5 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  work.s4_6 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  work.s4_7 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  work.s4_8 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.s4_9 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.s4_10 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  work.s4_11 = work.s4_6 + work.s4_8;
  work.s4_12 = work.s4_10 + work.s4_11;
  work.s4_13 = work.s4_7 - work.s4_5;
  work.s4_14 = work.s4_9 + work.s4_13;
  work.s4_15 = fnma(work.w_chassis_z, work.s4_14, work.w_chassis_y*work.s4_12);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  work.s4_16 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  work.s4_17 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  work.s4_18 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  work.s4_19 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.s4_20 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.s4_21 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.s4_22 = work.s4_17 + work.s4_19;
  work.s4_23 = work.s4_21 + work.s4_22;
  work.s4_24 = work.s4_18 - work.s4_16;
  work.s4_25 = work.s4_20 + work.s4_24;
  work.s4_26 = fnma(work.w_chassis_z, work.s4_25, work.w_chassis_y*work.s4_23);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  work.s4_27 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s4_28 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.s4_29 = zd_rear_axle_rx*s1_51;
  work.s4_30 = work.s4_27 + work.s4_28;
  const double s4_31 = state.zd[Coordinate::rear_axle_rz] - work.s4_29;
  work.s4_32 = fnma(work.w_chassis_z, work.s4_30, work.w_chassis_y*s4_31);
  work.s4_33 = zd_chassis_rz*s1_1;
  work.w_chassis_x = state.zd[Coordinate::chassis_rx] - work.s4_33;
  work.s4_34 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  work.s4_35 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  const double s4_36 = work.s4_35 - work.s4_34;
  work.s4_37 = fnma(work.w_chassis_y, s4_36, work.w_chassis_x*work.s4_30);
  work.s4_38 = fnma(work.w_chassis_x, s4_31, work.w_chassis_z*s4_36);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s4_39 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  work.s4_40 = zd_carrier_left_ry*work.s1_17;
  work.s4_41 = state.zd[Coordinate::lower_arm_left] + work.s4_39;
  work.s4_42 = work.s4_41 - work.s4_40;
  work.s4_43 = fnma(work.w_chassis_y, work.s4_42, work.w_chassis_x*work.s4_14);
  work.s4_44 = fnma(work.w_chassis_x, work.s4_12, work.w_chassis_z*work.s4_42);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s4_45 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  work.s4_46 = zd_carrier_right_ry*work.s1_37;
  work.s4_47 = state.zd[Coordinate::lower_arm_right] + work.s4_45;
  work.s4_48 = work.s4_47 - work.s4_46;
  work.s4_49 = fnma(work.w_chassis_y, work.s4_48, work.w_chassis_x*work.s4_25);
  work.s4_50 = fnma(work.w_chassis_x, work.s4_23, work.w_chassis_z*work.s4_48);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.w_carrier_left_x = work.w_chassis_x + work.s4_42;
  work.w_carrier_left_y = work.w_chassis_y + work.s4_14;
  const double s4_51 = work.s1_17*work.w_carrier_left_y;
  work.s4_52 = fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_x, s4_51);
  work.w_carrier_left_z = work.w_chassis_z + work.s4_12;
  const double s4_53 = work.s1_17*work.w_carrier_left_z;
  work.s4_54 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_x, s4_53);
  const double s4_55 = fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_y,
      state.zd[Coordinate::wheel_front_left]);
  const double s4_56 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s4_55);
  work.s4_57 = fnma(work.s1_17, work.w_carrier_left_x, s4_56);
  const double s4_58 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_y;
  work.s4_59 = fnma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_z, s4_58);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.w_carrier_right_x = work.w_chassis_x + work.s4_48;
  work.w_carrier_right_y = work.w_chassis_y + work.s4_25;
  const double s4_60 = work.s1_37*work.w_carrier_right_y;
  work.s4_61 = fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_x, s4_60);
  work.w_carrier_right_z = work.w_chassis_z + work.s4_23;
  const double s4_62 = work.s1_37*work.w_carrier_right_z;
  work.s4_63 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_x, s4_62);
  const double s4_64 = fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_y,
      state.zd[Coordinate::wheel_front_right]);
  const double s4_65 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s4_64);
  work.s4_66 = fnma(work.s1_37, work.w_carrier_right_x, s4_65);
  const double s4_67 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_y;
  work.s4_68 = fnma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_z, s4_67);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.w_rear_axle_x = work.w_chassis_x + s4_36;
  work.w_rear_axle_y = work.w_chassis_y + work.s4_30;
  const double s4_69 = work.R_rear_axle_y_y*work.w_rear_axle_x;
  const double s4_70 = fnma(work.R_rear_axle_x_y, work.w_rear_axle_y, s4_69);
  work.w_rear_axle_z = work.w_chassis_z + s4_31;
  const double s4_71 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s4_72 = fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s4_71);
  const double s4_73 = fma(work.R_rear_axle_x_y, work.w_rear_axle_x, s4_72);
  const double s4_74 = work.R_rear_axle_x_y*work.w_rear_axle_z;
  const double s4_75 = fnma(work.R_rear_axle_z_y, work.w_rear_axle_x, s4_74);
  const double s4_76 = work.R_rear_axle_z_y*work.w_rear_axle_y;
  const double s4_77 = fnma(work.R_rear_axle_y_y, work.w_rear_axle_z, s4_76);
  const double s4_78 = state.zd[Coordinate::wheel_rear_right] + s4_73;
  const double s4_79 = s4_78 + (state.zd[Coordinate::wheel_rear_left] + s4_73);
  // operations: 56 add, 71 multiply

  // --- step 8: elimination from the leaves to the root (63) ---
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s8_1 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_2 = I_wheel_rear_right_polar*s4_79;
  work.s8_3 = fma(s4_70, s8_2, work.R_rear_axle_z_y*s8_1);
  work.s8_4 = fma(s4_75, s8_2, work.R_rear_axle_y_y*s8_1);
  work.s8_5 = fma(s4_77, s8_2, work.R_rear_axle_x_y*s8_1);

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right
  // ---
  // long_rod_left
  const double s2_1 = p_long_rod_left_to_x*s1_51;
  const double s2_2 = fma(-p_long_rod_left_to_z, work.R_rear_axle_z_z, s2_1);
  const double s2_3 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s2_4 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_x_z, s2_3);
  const double s2_5 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s2_6 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_y_z, s2_5);
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - (-p_rear_axle_tx_z);
  work.s2_7 = fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_2);
  work.s2_8 = -p_long_rod_left_from_z + (work.r_rear_axle_aux3_z + work.s2_7);
  work.s2_9 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_4);
  const double s2_10 = fnma(s4_36, work.s2_7, s4_31*work.s2_9);
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  work.s2_11 = -p_long_rod_left_from_x + (work.r_rear_axle_aux1_x + work.s2_9);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.s2_12 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_6);
  work.s2_13 = p_long_rod_left_from_y - z_rear_axle_ty - work.s2_12;
  const double s2_14 = fma(work.s2_7, work.s2_13, work.s2_8*work.s2_12);
  const double s2_15 = fnma(s4_31, work.s2_12, work.s4_30*work.s2_7);
  const double s2_16 = fnma(work.s4_30, work.s2_9, s4_36*work.s2_12);
  work.s2_17 = fnma(s4_31, s2_10, work.s4_30*s2_16);
  work.s2_18 = fnma(s4_36, s2_16, s4_31*s2_15);
  work.s2_19 = fnma(work.s4_30, s2_15, s4_36*s2_10);
  // diag_rod_left
  const double s2_20 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  work.s2_21 = fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s2_20);
  work.s2_22 = -p_diag_rod_left_from_z + (work.r_rear_axle_aux3_z + work.s2_21);
  const double s2_23 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  work.s2_24 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_23);
  const double s2_25 = fnma(s4_36, work.s2_21, s4_31*work.s2_24);
  work.s2_26 = -p_diag_rod_left_from_x + (work.r_rear_axle_aux1_x + work.s2_24);
  const double s2_27 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  work.s2_28 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_27);
  work.s2_29 = p_diag_rod_left_from_y - z_rear_axle_ty - work.s2_28;
  const double s2_30 = fma(work.s2_21, work.s2_29, work.s2_22*work.s2_28);
  const double s2_31 = fnma(s4_31, work.s2_28, work.s4_30*work.s2_21);
  const double s2_32 = fnma(work.s4_30, work.s2_24, s4_36*work.s2_28);
  work.s2_33 = fnma(s4_31, s2_25, work.s4_30*s2_32);
  work.s2_34 = fnma(s4_36, s2_32, s4_31*s2_31);
  work.s2_35 = fnma(work.s4_30, s2_31, s4_36*s2_25);
  // arb_link_rear_left
  const double s2_36 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s2_37 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s2_36);
  const double s2_38 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s2_39 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s2_38);
  const double s2_40 = -p_arb_link_rear_left_to_x*s1_51;
  const double s2_41 = fnma(-p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s2_40);
  work.s2_42 = p_arb_link_rear_left_from_x*work.sines[20];
  work.s2_43 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_41);
  const double s2_44 = work.s2_42 + (work.r_rear_axle_aux3_z + work.s2_43);
  work.s2_45 = -p_arb_rear_left_z + s2_44;
  work.s2_46 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_37);
  const double s2_47 = fnma(s4_31, work.s2_46, work.s4_30*work.s2_43);
  work.s2_48 = 0.6 - z_rear_axle_ty - work.s2_46;
  const double s2_49 = fma(work.s2_43, work.s2_48, work.s2_45*work.s2_46);
  work.s2_50 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_39);
  const double s2_51 = fnma(s4_36, work.s2_43, s4_31*work.s2_50);
  const double s2_52 = fnma(work.s4_30, work.s2_50, s4_36*work.s2_46);
  work.s2_53 = fnma(s4_36, s2_52, s4_31*s2_47);
  work.s2_54 = p_arb_link_rear_left_from_x*work.cosines[20];
  work.s2_55 = work.s2_54 - work.r_rear_axle_aux1_x - work.s2_50 - (-p_arb_rear_left_x);
  const double s2_56 = fnma(work.s2_42, work.s2_55, work.s2_45*work.s2_54);
  // long_rod_right
  work.s2_57 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_2);
  work.s2_58 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_6);
  const double s2_59 = fma(s4_31, work.s2_58, work.s4_30*work.s2_57);
  work.s2_60 = -p_long_rod_right_from_y + (z_rear_axle_ty + work.s2_58);
  work.s2_61 = -p_long_rod_right_from_z + (work.r_rear_axle_aux3_z - work.s2_57);
  const double s2_62 = fma(work.s2_57, work.s2_60, work.s2_58*work.s2_61);
  work.s2_63 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_4);
  const double s2_64 = fma(s4_31, work.s2_63, s4_36*work.s2_57);
  const double s2_65 = fnma(work.s4_30, work.s2_63, s4_36*work.s2_58);
  work.s2_66 = fma(s4_36, s2_64, work.s4_30*s2_59);
  work.s2_67 = fma(s4_36, s2_65, s4_31*s2_59);
  work.s2_68 = fnma(s4_31, s2_64, work.s4_30*s2_65);
  work.s2_69 = -p_long_rod_right_from_x + (work.r_rear_axle_aux1_x + work.s2_63);
  // diag_rod_right
  work.s2_70 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_23);
  work.pivot_rear_axle_tx = -p_diag_rod_right_from_x + (work.r_rear_axle_aux1_x + work.s2_70);
  work.s2_71 = fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s2_20);
  const double s2_72 = fnma(s4_36, work.s2_71, s4_31*work.s2_70);
  work.s2_73 = -p_diag_rod_right_from_z + (work.r_rear_axle_aux3_z + work.s2_71);
  const double s2_74 = fnma(work.pivot_rear_axle_tx, work.s2_71, work.s2_70*work.s2_73);
  work.s2_75 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_27);
  const double s2_76 = fnma(s4_31, work.s2_75, work.s4_30*work.s2_71);
  const double s2_77 = fnma(work.s4_30, work.s2_70, s4_36*work.s2_75);
  work.s2_78 = fnma(s4_31, s2_72, work.s4_30*s2_77);
  work.s2_79 = fnma(s4_36, s2_77, s4_31*s2_76);
  work.s2_80 = fnma(work.s4_30, s2_76, s4_36*s2_72);
  work.s2_81 = -p_diag_rod_right_from_y + (z_rear_axle_ty + work.s2_75);
  const double s2_82 = fnma(work.s2_73, work.s2_75, work.s2_71*work.s2_81);
  const double s2_83 = fnma(work.s2_70, work.s2_81, work.pivot_rear_axle_tx*work.s2_75);
  // arb_link_rear_right
  work.s2_84 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_37);
  work.s2_85 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_39);
  const double s2_86 = fnma(s4_36, work.s2_84, work.s4_30*work.s2_85);
  work.s2_87 = 0.6 + (z_rear_axle_ty - work.s2_84);
  work.s2_88 = fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_41);
  const double s2_89 = fma(s4_36, work.s2_88, s4_31*work.s2_85);
  const double s2_90 = fma(work.s4_30, work.s2_88, s4_31*work.s2_84);
  work.s2_91 = fnma(s4_36, s2_86, s4_31*s2_90);
  work.s2_92 = p_arb_link_rear_right_from_x*work.sines[21];
  const double s2_93 = work.s2_92 + (work.r_rear_axle_aux3_z + work.s2_88);
  work.s2_94 = -p_arb_rear_right_z + s2_93;
  work.s2_95 = p_arb_link_rear_right_from_x*work.cosines[21];
  const double s2_96 = work.s2_85 + work.s2_95 - work.r_rear_axle_aux1_x;
  work.s2_97 = s2_96 - (-p_arb_rear_right_x);
  const double s2_98 = fnma(work.s2_92, work.s2_97, work.s2_94*work.s2_95);
  const double s2_99 = 1.0/work.pivot_rear_axle_tx;
  const double s2_100 = work.s2_26*s2_99;
  const double s2_101 = fnma(work.s2_24, work.s2_29, fnma(work.s2_26, work.s2_28, s2_83*s2_100));
  const double s2_102 = fma(work.s2_21, work.s2_26, fnma(work.s2_22, work.s2_24, s2_74*s2_100));
  const double s2_103 = fma(s2_82, s2_100, s2_30);
  const double s2_104 = work.s2_11*s2_99;
  const double s2_105 = fma(work.s2_81, s2_100, work.s2_29);
  const double s2_106 = 1.0/s2_105;
  const double s2_107 = fma(work.s2_81, s2_104, work.s2_13)*s2_106;
  const double s2_108 = fnma(work.s2_9, work.s2_13, fnma(work.s2_11, work.s2_12, s2_83*s2_104));
  const double pivot_rear_axle_rx = fnma(s2_101, s2_107, s2_108);
  const double s2_109 = fma(work.s2_7, work.s2_11, fnma(work.s2_8, work.s2_9, s2_74*s2_104));
  const double s2_110 = fnma(s2_107, s2_102, s2_109);
  const double s2_111 = fnma(s2_107, s2_103, fma(s2_82, s2_104, s2_14));
  const double s2_112 = work.s2_69*s2_99;
  const double s2_113 = s2_106*fnma(work.s2_81, s2_112, work.s2_60);
  const double s2_114 = fma(work.s2_60, work.s2_63, fnma(work.s2_58, work.s2_69, s2_83*s2_112));
  const double s2_115 = fnma(work.s2_57, work.s2_69, fnma(work.s2_61, work.s2_63, s2_74*s2_112));
  const double s2_116 = 1.0/pivot_rear_axle_rx;
  const double s2_117 = fma(s2_101, s2_113, s2_114)*s2_116;
  const double pivot_rear_axle_ry = fnma(s2_110, s2_117, fma(s2_102, s2_113, s2_115));
  const double s2_118 = fnma(s2_117, s2_111, fma(s2_113, s2_103, fma(s2_82, s2_112, s2_62)));
  const double s2_119 = work.s2_97*s2_99;
  const double s2_120 = s2_106*fma(work.s2_81, s2_119, work.s2_87);
  const double s2_121 = fnma(work.s2_84, work.s2_97, s2_101*s2_120);
  const double s2_122 = fma(work.s2_85, work.s2_94, fnma(work.s2_88, work.s2_97, s2_102*s2_120));
  const double s2_123 = fnma(work.s2_87, work.s2_88, s2_103*s2_120);
  const double s2_124 = s2_116*fnma(s2_83, s2_119, fnma(work.s2_85, work.s2_87, s2_121));
  const double s2_125 = fnma(s2_82, s2_119, fnma(work.s2_84, work.s2_94, s2_123));
  const double s2_126 = 1.0/pivot_rear_axle_ry;
  const double s2_127 = fnma(s2_110, s2_124, fnma(s2_74, s2_119, s2_122))*s2_126;
  const double pivot_rear_axle_rz = fnma(s2_118, s2_127, fnma(s2_111, s2_124, s2_125));
  const double s2_128 = work.s2_55*s2_99;
  const double s2_129 = s2_106*fms(work.s2_81, s2_128, work.s2_48);
  const double s2_130 = fma(work.s2_46, work.s2_55, fnma(work.s2_48, work.s2_50, s2_101*s2_129));
  const double s2_131 = fnma(work.s2_45, work.s2_50, s2_102*s2_129);
  const double s2_132 = fnma(work.s2_73, s2_100, work.s2_22);
  const double s2_133 = fnma(s2_107, s2_132, fnma(work.s2_73, s2_104, work.s2_8));
  const double s2_134 = s2_116*fnma(s2_83, s2_128, s2_130);
  const double s2_135 = fnma(s2_74, s2_128, fnma(work.s2_43, work.s2_55, s2_131));
  const double s2_136 = fma(s2_113, s2_132, fnma(work.s2_73, s2_112, work.s2_61));
  const double s2_137 = fnma(s2_117, s2_133, s2_136);
  const double s2_138 = s2_126*fnma(s2_110, s2_134, s2_135);
  const double s2_139 = fnma(s2_111, s2_134, fma(s2_103, s2_129, fnma(s2_82, s2_128, s2_49)));
  const double s2_140 = fma(s2_120, s2_132, fma(work.s2_73, s2_119, work.s2_94));
  const double s2_141 = fnma(s2_127, s2_137, fnma(s2_124, s2_133, s2_140));
  const double s2_142 = 1.0/pivot_rear_axle_rz;
  const double s2_143 = fnma(s2_118, s2_138, s2_139)*s2_142;
  const double s2_144 = fma(s2_132, s2_129, fma(work.s2_73, s2_128, work.s2_45));
  const double pivot_rear_axle_tz = fnma(s2_141, s2_143, fnma(s2_137, s2_138, fnma(s2_133, s2_134,
      s2_144)));
  const double s2_145 = 1.2494533266510743*std::abs(work.pivot_rear_axle_tx);
  const double s2_146 = mbgen::min(s2_145, 1.665350081353039*std::abs(s2_105));
  const double s2_147 = mbgen::min(s2_146, 2.1234888829989926*std::abs(pivot_rear_axle_rx));
  const double s2_148 = mbgen::min(s2_147, 1.7864443153153613*std::abs(pivot_rear_axle_ry));
  const double s2_149 = mbgen::min(s2_148, 8.176955428452642*std::abs(pivot_rear_axle_rz));
  work.s2_150 = mbgen::min(s2_149, 2.7700489841913827*std::abs(pivot_rear_axle_tz));
  // operations: 173 add, 217 multiply, 5 divide, 11 other

  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  const double s3_1 = 1.0/pivot_rear_axle_tz;
  work.s3_2 = s2_56*s3_1;
  work.Rz_rear_axle_rz_0 = s2_142*(s2_141*work.s3_2);
  work.Rz_rear_axle_ry_0 = s2_126*fnma(s2_118, work.Rz_rear_axle_rz_0, s2_137*work.s3_2);
  const double s3_3 = fnma(s2_111, work.Rz_rear_axle_rz_0, s2_133*work.s3_2);
  const double s3_4 = fnma(s2_103, work.Rz_rear_axle_rz_0, s2_132*work.s3_2);
  const double s3_5 = fma(s2_82, work.Rz_rear_axle_rz_0, work.s2_73*work.s3_2);
  work.Rz_rear_axle_rx_0 = s2_116*fnma(s2_110, work.Rz_rear_axle_ry_0, s3_3);
  const double s3_6 = fnma(s2_102, work.Rz_rear_axle_ry_0, s3_4);
  const double s3_7 = fma(s2_74, work.Rz_rear_axle_ry_0, s3_5);
  work.s3_8 = s2_106*fnma(s2_101, work.Rz_rear_axle_rx_0, s3_6);
  const double s3_9 = fma(work.s2_81, work.s3_8, fma(s2_83, work.Rz_rear_axle_rx_0, s3_7));
  work.Rz_rear_axle_tx_0 = s2_99*s3_9;
  work.Rz_rear_axle_tz_1 = s2_98*s2_143*s3_1;
  work.s3_10 = s2_142*fma(s2_141, work.Rz_rear_axle_tz_1, s2_98);
  work.Rz_rear_axle_ry_1 = s2_126*fnma(s2_137, work.Rz_rear_axle_tz_1, s2_118*work.s3_10);
  const double s3_11 = fnma(s2_110, work.Rz_rear_axle_ry_1, s2_111*work.s3_10);
  work.Rz_rear_axle_rx_1 = s2_116*fnma(s2_133, work.Rz_rear_axle_tz_1, s3_11);
  const double s3_12 = fnma(s2_102, work.Rz_rear_axle_ry_1, s2_103*work.s3_10);
  const double s3_13 = fnma(s2_101, work.Rz_rear_axle_rx_1, s3_12);
  work.s3_14 = s2_106*fnma(s2_132, work.Rz_rear_axle_tz_1, s3_13);
  const double s3_15 = fma(s2_83, work.Rz_rear_axle_rx_1, s2_74*work.Rz_rear_axle_ry_1);
  const double s3_16 = fnma(s2_82, work.s3_10, fma(work.s2_81, work.s3_14, s3_15));
  work.Rz_rear_axle_tx_1 = s2_99*fnma(work.s2_73, work.Rz_rear_axle_tz_1, s3_16);
  // operations: 21 add, 43 multiply, 1 divide

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right ---
  // long_rod_left
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  work.s6_1 = zd_rear_axle_tx + s2_15;
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  work.s6_2 = zd_rear_axle_ty + s2_10;
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  work.s6_3 = zd_rear_axle_tz + s2_16;
  // diag_rod_left
  work.s6_4 = zd_rear_axle_tx + s2_31;
  work.s6_5 = zd_rear_axle_ty + s2_25;
  work.s6_6 = zd_rear_axle_tz + s2_32;
  // arb_link_rear_left
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s6_7 = zd_arb_rear_left*work.s2_42;
  work.s6_8 = fma(work.s4_30, s2_47, fnma(s4_36, s2_51, zd_arb_rear_left*s6_7));
  const double s6_9 = zd_arb_rear_left*work.s2_54;
  work.s6_10 = fnma(s4_31, s2_51, fma(work.s4_30, s2_52, zd_arb_rear_left*s6_9));
  work.s6_11 = zd_rear_axle_ty + s2_51;
  work.s6_12 = s6_7 + (zd_rear_axle_tx + s2_47);
  work.s6_13 = s6_9 + (zd_rear_axle_tz + s2_52);
  // long_rod_right
  work.s6_14 = zd_rear_axle_ty + s2_64;
  work.s6_15 = zd_rear_axle_tz + s2_65;
  work.s6_16 = zd_rear_axle_tx - s2_59;
  // diag_rod_right
  work.s6_17 = zd_rear_axle_tx + s2_76;
  work.s6_18 = zd_rear_axle_ty + s2_72;
  work.s6_19 = zd_rear_axle_tz + s2_77;
  const double s6_20 = fma(work.s6_17, work.s6_17, work.s6_18*work.s6_18);
  const double s6_21 = fma(work.s2_81, work.s2_79, fma(work.s6_19, work.s6_19, s6_20));
  const double s6_22 = fma(work.s2_73, work.s2_80, s6_21);
  const double s6_23 = fma(work.pivot_rear_axle_tx, work.s2_78, s6_22);
  const double s6_24 = fnma(work.s6_4, work.s6_4, fnma(work.s6_5, work.s6_5, s2_100*s6_23));
  const double s6_25 = fnma(work.s2_22, work.s2_35, fnma(work.s6_6, work.s6_6, s6_24));
  const double s6_26 = fma(work.s2_29, work.s2_34, fnma(work.s2_26, work.s2_33, s6_25));
  const double s6_27 = fnma(work.s6_1, work.s6_1, fnma(work.s6_2, work.s6_2, s2_104*s6_23));
  const double s6_28 = fnma(work.s2_8, work.s2_19, fnma(work.s6_3, work.s6_3, s6_27));
  const double s6_29 = fma(work.s2_13, work.s2_18, fnma(work.s2_11, work.s2_17, s6_28));
  const double s6_30 = fnma(s2_107, s6_26, s6_29);
  const double s6_31 = fnma(work.s6_15, work.s6_15, fnma(work.s6_14, work.s6_14, s2_112*s6_23));
  const double s6_32 = fnma(work.s2_61, work.s2_66, fnma(work.s6_16, work.s6_16, s6_31));
  const double s6_33 = fma(work.s2_60, work.s2_67, fnma(work.s2_69, work.s2_68, s6_32));
  const double s6_34 = fnma(s2_117, s6_30, fma(s2_113, s6_26, s6_33));
  const double s6_35 = s2_120*s6_26;
  const double s6_36 = fnma(work.s6_12, work.s6_12, fnma(work.s6_11, work.s6_11, s2_129*s6_26));
  const double s6_37 = fma(work.s2_48, work.s2_53, fnma(work.s6_13, work.s6_13, s6_36));
  const double s6_38 = fma(work.s2_55, work.s6_10, fma(work.s2_45, work.s6_8, s6_37));
  const double s6_39 = fnma(s2_138, s6_34, fnma(s2_134, s6_30, fnma(s2_128, s6_23, s6_38)));
  // arb_link_rear_right
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s6_40 = zd_arb_rear_right*work.s2_92;
  work.s6_41 = fma(work.s4_30, s2_90, fma(s4_36, s2_89, zd_arb_rear_right*s6_40));
  const double s6_42 = zd_arb_rear_right*work.s2_95;
  work.s6_43 = fma(work.s4_30, s2_86, fma(s4_31, s2_89, zd_arb_rear_right*s6_42));
  work.s6_44 = zd_rear_axle_ty - s2_89;
  work.s6_45 = s6_40 + (zd_rear_axle_tx + s2_90);
  work.s6_46 = s6_42 + (zd_rear_axle_tz + s2_86);
  const double s6_47 = fnma(work.s6_45, work.s6_45, fnma(work.s6_44, work.s6_44, s6_35));
  const double s6_48 = fnma(work.s2_87, work.s2_91, fnma(work.s6_46, work.s6_46, s6_47));
  const double s6_49 = fma(work.s2_97, work.s6_43, fma(work.s2_94, work.s6_41, s6_48));
  const double s6_50 = fnma(s2_127, s6_34, fnma(s2_124, s6_30, fnma(s2_119, s6_23, s6_49)));
  const double s6_51 = fnma(s2_143, s6_50, s6_39);
  work.zdd_star_rear_axle_tz = s3_1*s6_51;
  work.zdd_star_rear_axle_rz = s2_142*fnma(s2_141, work.zdd_star_rear_axle_tz, s6_50);
  const double s6_52 = fnma(s2_118, work.zdd_star_rear_axle_rz, s6_34);
  work.zdd_star_rear_axle_ry = s2_126*fnma(s2_137, work.zdd_star_rear_axle_tz, s6_52);
  const double s6_53 = fnma(s2_110, work.zdd_star_rear_axle_ry, s6_30);
  const double s6_54 = fnma(s2_111, work.zdd_star_rear_axle_rz, s6_53);
  work.zdd_star_rear_axle_rx = s2_116*fnma(s2_133, work.zdd_star_rear_axle_tz, s6_54);
  const double s6_55 = fnma(s2_101, work.zdd_star_rear_axle_rx, s6_26);
  const double s6_56 = fnma(s2_102, work.zdd_star_rear_axle_ry, s6_55);
  const double s6_57 = fnma(s2_103, work.zdd_star_rear_axle_rz, s6_56);
  work.s6_58 = s2_106*fnma(s2_132, work.zdd_star_rear_axle_tz, s6_57);
  const double s6_59 = fms(s2_82, work.zdd_star_rear_axle_rz, s6_23);
  const double s6_60 = fma(s2_74, work.zdd_star_rear_axle_ry, s6_59);
  const double s6_61 = fma(s2_83, work.zdd_star_rear_axle_rx, s6_60);
  const double s6_62 = fma(work.s2_81, work.s6_58, s6_61);
  work.zdd_star_rear_axle_tx = s2_99*fnma(work.s2_73, work.zdd_star_rear_axle_tz, s6_62);
  // operations: 90 add, 88 multiply
}

/// Part 2 of compute_accelerations: step 7: inertias of the bodies and forces on joints,
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 7: inertias of the bodies and forces on joints,
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63).
[[gnu::noinline]] void compute_accelerations_2(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_10 = h_rear_axle_x*work.R_rear_axle_aux5_y_x;
  work.s7_11 = fma(h_rear_axle_z, work.R_rear_axle_y_z, s7_10);
  const double s7_12 = h_rear_axle_x*work.R_rear_axle_aux5_x_x;
  work.s7_13 = fma(h_rear_axle_z, work.R_rear_axle_x_z, s7_12);
  const double s1_51 = work.sines[18];
  work.s7_14 = fnma(h_rear_axle_x, s1_51, h_rear_axle_z*work.R_rear_axle_z_z);

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_6 = work.Rz_rear_axle_rz_0*work.s7_11;
  const double s8_7 = work.Rz_rear_axle_rx_0*work.s7_13;
  const double s8_8 = work.Rz_rear_axle_tx_1*work.s7_14;

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right,
  // continued ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_15 = K_rear_axle_xx*work.R_rear_axle_aux5_y_x;
  const double s7_16 = fma(K_rear_axle_xz, work.R_rear_axle_y_z, s7_15);
  const double s7_17 = K_rear_axle_xx*work.R_rear_axle_aux5_x_x;
  const double s7_18 = fma(K_rear_axle_xz, work.R_rear_axle_x_z, s7_17);
  const double s7_19 = K_rear_axle_yy*work.R_rear_axle_y_y;
  const double s7_20 = fnma(-K_rear_axle_yz, work.R_rear_axle_y_z, s7_19);
  const double s7_21 = K_rear_axle_yy*work.R_rear_axle_x_y;
  const double s7_22 = fnma(-K_rear_axle_yz, work.R_rear_axle_x_z, s7_21);
  const double s7_23 = K_rear_axle_xz*work.R_rear_axle_aux5_y_x;
  const double s7_24 = fma(K_rear_axle_zz, work.R_rear_axle_y_z, s7_23);
  const double s7_25 = fnma(-K_rear_axle_yz, work.R_rear_axle_y_y, s7_24);
  const double s7_26 = fma(work.R_rear_axle_z_z, s7_25, work.R_rear_axle_z_y*s7_20);
  const double s7_27 = fnma(s1_51, s7_16, s7_26);
  const double s7_28 = K_rear_axle_xz*work.R_rear_axle_aux5_x_x;
  const double s7_29 = fma(K_rear_axle_zz, work.R_rear_axle_x_z, s7_28);
  const double s7_30 = fnma(-K_rear_axle_yz, work.R_rear_axle_x_y, s7_29);
  const double s7_31 = fma(work.R_rear_axle_z_z, s7_30, work.R_rear_axle_z_y*s7_22);
  const double s7_32 = fnma(s1_51, s7_18, s7_31);
  const double s7_33 = fma(work.R_rear_axle_aux5_y_x, s7_18, work.R_rear_axle_y_y*s7_22);
  const double s7_34 = fma(work.R_rear_axle_y_z, s7_30, s7_33);
  const double s7_35 = fma(work.R_rear_axle_aux5_y_x, s7_16, work.R_rear_axle_y_y*s7_20);
  const double s7_36 = fma(work.R_rear_axle_y_z, s7_25, s7_35);
  const double s7_37 = fma(work.R_rear_axle_aux5_x_x, s7_18, work.R_rear_axle_x_y*s7_22);
  const double s7_38 = fma(work.R_rear_axle_x_z, s7_30, s7_37);
  const double s8_9 = fma(work.Rz_rear_axle_tz_1, work.s7_11, work.s3_14*work.s7_14);
  const double s8_10 = fnma(work.Rz_rear_axle_ry_1, s7_34, s8_9);
  const double s8_11 = fma(work.s3_10, s7_34, fnma(work.Rz_rear_axle_tz_1, work.s7_13, s8_8));
  const double s7_39 = K_rear_axle_trace - s7_38 - s7_36;
  const double s7_40 = s7_38 + (s7_36 + s7_39);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_z = work.sines[20];
  const double s7_41 = K_arb_rear_left_zz*R_arb_rear_left_x_z;
  const double R_arb_rear_left_x_x = work.cosines[20];
  const double s7_42 = K_arb_rear_left_xx*R_arb_rear_left_x_x;
  const double s7_43 = fnma(R_arb_rear_left_x_z, s7_42, R_arb_rear_left_x_x*s7_41);
  const double s7_44 = fma(R_arb_rear_left_x_x, s7_42, R_arb_rear_left_x_z*s7_41);
  const double s7_45 = 0.4224999999999999 - s7_44;
  const double s7_46 = K_arb_rear_left_yy + (s7_44 + s7_45) - K_arb_rear_left_yy;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_z = work.sines[21];
  const double s7_47 = K_arb_rear_right_zz*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = work.cosines[21];
  const double s7_48 = K_arb_rear_right_xx*R_arb_rear_right_x_x;
  const double s7_49 = fnma(R_arb_rear_right_x_z, s7_48, R_arb_rear_right_x_x*s7_47);
  const double s7_50 = fma(R_arb_rear_right_x_x, s7_48, R_arb_rear_right_x_z*s7_47);
  const double s7_51 = 0.4224999999999999 - s7_50;
  const double s7_52 = K_arb_rear_right_yy + (s7_50 + s7_51) - K_arb_rear_right_yy;
  // operations: 37 add, 47 multiply

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  work.s8_12 = work.w_chassis_y + work.w_chassis_y;
  const double s8_13 = fma(zd_arb_rear_right, work.s8_12, zd_arb_rear_right*zd_arb_rear_right);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s8_14 = fma(zd_arb_rear_left, work.s8_12, zd_arb_rear_left*zd_arb_rear_left);
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s8_15 = fma(zd_pitman_arm, work.s8_12, zd_pitman_arm*zd_pitman_arm);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s8_16 = zd_arb_front_right*zd_arb_front_right;
  work.s8_17 = fma(zd_arb_front_right, work.s8_12, s8_16);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.s8_18 = fma(zd_arb_front_left, work.s8_12, zd_arb_front_left*zd_arb_front_left);
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  work.s8_19 = work.w_chassis_x + work.w_chassis_x;
  const double s8_20 = zd_upper_arm_right*zd_upper_arm_right;
  work.s8_21 = fma(zd_upper_arm_right, work.s8_19, s8_20);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  work.s8_22 = fma(zd_upper_arm_left, work.s8_19, zd_upper_arm_left*zd_upper_arm_left);
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s8_23 = work.w_chassis_z + work.w_chassis_z;
  work.s8_24 = fma(zd_bell_crank, work.s8_23, zd_bell_crank*zd_bell_crank);
  const double s8_25 = -K_arb_rear_right_xy*R_arb_rear_right_x_z;
  const double s8_26 = -K_arb_rear_right_xy*R_arb_rear_right_x_x;
  work.s8_27 = work.w_chassis_x*work.w_chassis_y;
  work.s8_28 = work.w_chassis_y*work.w_chassis_z;
  const double s8_29 = fnma(s8_25, work.s8_27, tau[Coordinate::arb_rear_right]);
  const double s8_30 = fnma(s8_26, work.s8_28, s8_29);
  const double s8_31 = K_arb_rear_left_xy*R_arb_rear_left_x_x;
  const double s8_32 = K_arb_rear_left_xy*R_arb_rear_left_x_z;
  const double s8_33 = fma(s8_32, work.s8_27, tau[Coordinate::arb_rear_left]);
  const double s8_34 = fma(s8_31, work.s8_28, s8_33);
  work.s8_35 = fnma(-p_bell_crank_z, work.s8_28, p_bell_crank_x*work.s8_27);
  work.s8_36 = work.w_chassis_x*work.w_chassis_z;
  const double s8_37 = work.w_chassis_x*work.w_chassis_x;
  const double s8_38 = work.w_chassis_y*work.w_chassis_y;
  work.s8_39 = s8_38 + s8_37;
  const double s8_40 = fnma(-p_arb_rear_right_x, work.s8_36, -p_arb_rear_right_z*work.s8_39);
  work.s8_41 = fma(p_arb_front_right_x, work.s8_36, -p_rear_axle_tx_z*work.s8_39);
  work.s8_42 = fma(work.w_chassis_z, work.w_chassis_z, s8_38);
  const double s8_43 = fnma(-p_arb_rear_right_z, work.s8_36, -p_arb_rear_right_x*work.s8_42);
  work.s8_44 = fma(p_bell_crank_x, work.s8_42, -p_bell_crank_z*work.s8_36);
  const double s8_45 = fnma(-p_pitman_arm_z, work.s8_36, p_pitman_arm_y*work.s8_27);
  work.s8_46 = fnma(p_pitman_arm_x, work.s8_42, s8_45);
  work.s8_47 = fma(p_arb_front_right_x, work.s8_42, -p_rear_axle_tx_z*work.s8_36);
  work.s8_48 = fma(work.w_chassis_z, work.w_chassis_z, s8_37);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s8_49 = h_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s8_50 = h_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s8_51 = zd_arb_rear_right*work.s8_23;
  const double s8_52 = zd_arb_rear_right*work.s8_19;
  const double s8_53 = fnma(s8_50, s8_51, s8_49*s8_52);
  const double s8_54 = fma(s8_50, fnma(-p_arb_rear_right_y, work.s8_27, s8_43), s8_30);
  const double s8_55 = fma(s8_49, fnma(-p_arb_rear_right_z, work.s8_28, s8_40), s8_54);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s8_56 = h_arb_rear_left_x*R_arb_rear_left_x_x;
  work.s8_57 = s8_56 + s8_49 - 59.4;
  const double s8_58 = h_arb_rear_left_x*R_arb_rear_left_x_z;
  work.s8_59 = 8.1 + (s8_58 + s8_50);
  const double s8_60 = zd_arb_rear_left*work.s8_23;
  const double s8_61 = zd_arb_rear_left*work.s8_19;
  const double s8_62 = fnma(s8_58, s8_60, s8_56*s8_61);
  const double s8_63 = fma(s8_58, fma(-p_arb_rear_right_y, work.s8_27, s8_43), s8_34);
  const double s8_64 = fma(s8_56, fma(-p_arb_rear_right_z, work.s8_28, s8_40), s8_63);
  const double s8_65 = s8_49 - 14.85;
  const double s8_66 = s8_56 - 14.85;
  const double s8_67 = fnma(-p_arb_rear_right_y, s8_65, s7_43 + s7_49);
  const double s8_68 = 2.025 + s8_50;
  const double s8_69 = 2.025 + s8_58;
  const double s8_70 = s8_68 + s8_69;
  work.s8_71 = fma(-p_arb_rear_left_x, s8_70, fnma(p_arb_rear_left_y, s8_66, s8_67));
  const double s8_72 = fnma(-p_arb_rear_right_y, s8_65, fma(p_arb_rear_left_y, s8_66, s8_31));
  work.s8_73 = s8_72 - s8_26;
  work.s8_74 = fma(p_carrier_left_rz_y, s8_68 - s8_69, s8_25 - s8_32);
  work.s8_75 = fma(0.9, s8_70, s7_45 + s7_51);
  work.s8_76 = fnma(6.6, s8_65 + s8_66, s7_44 + s7_50);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_77 = m_rear_axle_2*work.Rz_rear_axle_tx_0;
  const double s8_78 = fma(work.Rz_rear_axle_ry_0, work.s7_14, s8_77);
  const double s8_79 = fnma(work.Rz_rear_axle_rx_0, work.s7_11, s8_78);
  const double s8_80 = m_rear_axle_2*work.Rz_rear_axle_tx_1;
  const double s8_81 = fma(work.Rz_rear_axle_ry_1, work.s7_14, s8_80);
  const double s8_82 = fnma(work.Rz_rear_axle_rx_1, work.s7_11, s8_81);
  const double s8_83 = fnma(work.s3_10, work.s7_11, m_rear_axle_2*work.Rz_rear_axle_tz_1);
  const double s8_84 = fnma(work.Rz_rear_axle_ry_1, work.s7_13, s8_83);
  const double s8_85 = fnma(work.Rz_rear_axle_ry_0, work.s7_13, s8_6);
  const double s8_86 = fnma(m_rear_axle_2, work.s3_2, s8_85);
  const double s8_87 = fma(work.Rz_rear_axle_rx_1, work.s7_13, work.s3_10*work.s7_14);
  work.s8_88 = fnma(m_rear_axle_2, work.s3_14, s8_87);
  const double s8_89 = fnma(work.Rz_rear_axle_rz_0, work.s7_14, s8_7);
  const double s8_90 = fnma(m_rear_axle_2, work.s3_8, s8_89);
  // arb_link_rear_right
  const double s8_91 = fnma(work.s3_2, s8_84, work.Rz_rear_axle_tx_0*s8_82);
  const double s8_92 = fnma(work.s3_8, work.s8_88, s8_91);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_93 = fma(zd_rear_axle_tz, work.s8_12, work.zdd_star_rear_axle_tx);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_94 = fnma(zd_rear_axle_ty, work.s8_23, s8_93);
  const double s8_95 = fma(z_rear_axle_ty, work.s8_27, s8_94);
  const double s8_96 = fma(work.r_rear_axle_aux3_z, work.s8_36, s8_95);
  const double s8_97 = fnma(work.r_rear_axle_aux1_x, work.s8_42, s8_96);
  const double s8_98 = work.zdd_star_rear_axle_rx + work.s4_37;
  const double s8_99 = fms(work.w_rear_axle_x, work.w_rear_axle_y, s8_98);
  const double s8_100 = work.zdd_star_rear_axle_ry + work.s4_38;
  const double s8_101 = fma(work.w_rear_axle_x, work.w_rear_axle_z, s8_100);
  const double s8_102 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s8_103 = work.w_rear_axle_z*work.w_rear_axle_z;
  const double s8_104 = s8_102 + s8_103;
  const double s8_105 = fma(work.s7_14, s8_101, fma(work.s7_11, s8_99, m_rear_axle_2*s8_97));
  const double f_rear_axle_x = fnma(work.s7_13, s8_104, s8_105);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s8_106 = fms(zd_rear_axle_tx, work.s8_23, work.s6_58);
  const double s8_107 = fnma(zd_rear_axle_tz, work.s8_19, s8_106);
  const double s8_108 = fma(work.r_rear_axle_aux1_x, work.s8_27, s8_107);
  const double s8_109 = fma(work.r_rear_axle_aux3_z, work.s8_28, s8_108);
  const double s8_110 = fnma(z_rear_axle_ty, work.s8_48, s8_109);
  const double s8_111 = fma(work.w_rear_axle_x, work.w_rear_axle_y, s8_98);
  const double s8_112 = work.zdd_star_rear_axle_rz + work.s4_32;
  const double s8_113 = fms(work.w_rear_axle_y, work.w_rear_axle_z, s8_112);
  const double s8_114 = fnma(work.s7_11, s8_97, fma(work.s7_13, s8_110, work.s8_3));
  const double s8_115 = fnma(s7_36, s8_99, fma(s7_38, s8_111, fma(s7_32, s8_113, s8_114)));
  const double s8_116 = fma(work.w_rear_axle_x, work.w_rear_axle_x, s8_103);
  const double s8_117 = fma(work.s7_14, s8_113, fma(work.s7_13, s8_111, m_rear_axle_2*s8_110));
  const double f_rear_axle_y = fnma(work.s7_11, s8_116, s8_117);
  const double s8_118 = fma(zd_rear_axle_ty, work.s8_19, work.zdd_star_rear_axle_tz);
  const double s8_119 = fnma(zd_rear_axle_tx, work.s8_12, s8_118);
  const double s8_120 = fma(z_rear_axle_ty, work.s8_28, s8_119);
  const double s8_121 = fma(work.r_rear_axle_aux1_x, work.s8_36, s8_120);
  const double s8_122 = fnma(work.r_rear_axle_aux3_z, work.s8_39, s8_121);
  const double s8_123 = fnma(work.s7_13, s8_122, fma(work.s7_14, s8_97, work.s8_4));
  const double s8_124 = fma(work.w_rear_axle_y, work.w_rear_axle_z, s8_112);
  const double s8_125 = fnma(work.s7_14, s8_110, fma(work.s7_11, s8_122, work.s8_5));
  const double s8_126 = fms(work.w_rear_axle_x, work.w_rear_axle_z, s8_100);
  const double s8_127 = fnma(s7_32, s8_111, fma(s7_34, s8_126, fma(s7_36, s8_124, s8_125)));
  const double s8_128 = fnma(s7_34, s8_124, fma(s7_39, s8_101, fma(s7_27, s8_99, s8_123)));
  const double s8_129 = fma(work.w_rear_axle_x, work.w_rear_axle_x, s8_102);
  const double s8_130 = fma(work.s7_13, s8_126, fma(work.s7_11, s8_124, m_rear_axle_2*s8_122));
  const double f_rear_axle_z = fnma(work.s7_14, s8_129, s8_130);
  const double n_rear_axle_x = fma(s7_27, s8_116 - s8_129, fnma(s7_39, s8_113, s8_127));
  const double n_rear_axle_y = fma(s7_32, s8_129 - s8_104, fnma(s7_38, s8_126, s8_128));
  const double s8_131 = work.s1_100 - n_rear_axle_y;
  const double n_rear_axle_z = fma(s7_34, s8_104 - s8_116, fnma(s7_27, s8_101, s8_115));
  const double s8_132 = s7_40 - s7_38;
  const double s8_133 = fnma(work.s3_10, s8_132, fnma(work.Rz_rear_axle_rx_1, s7_32, s8_10));
  const double s8_134 = fnma(work.s3_2, work.s7_11, work.s3_8*work.s7_14);
  const double s8_135 = fma(work.Rz_rear_axle_rz_0, s8_132, s8_134);
  const double s8_136 = fnma(work.Rz_rear_axle_rx_0, s7_32, s8_135);
  const double s8_137 = fnma(work.Rz_rear_axle_ry_0, s7_34, s8_136);
  const double s8_138 = fma(593.0, work.r_rear_axle_aux3_z, work.s7_14);
  const double s8_139 = s7_40 - s7_36;
  const double s8_140 = fnma(work.Rz_rear_axle_rx_1, s7_27, s8_11);
  const double s8_141 = fma(work.Rz_rear_axle_ry_1, s8_139, s8_140);
  const double s8_142 = fma(work.Rz_rear_axle_tx_0, work.s7_14, work.s3_2*work.s7_13);
  const double s8_143 = fma(work.Rz_rear_axle_ry_0, s8_139, s8_142);
  const double s8_144 = fnma(work.Rz_rear_axle_rz_0, s7_34, s8_143);
  const double s8_145 = fnma(work.Rz_rear_axle_rx_0, s7_27, s8_144);
  const double s8_146 = fma(work.Rz_rear_axle_ry_0, s8_141, s8_92);
  const double s8_147 = s7_40 - s7_39;
  const double s8_148 = fnma(work.Rz_rear_axle_rz_0, s7_32, work.Rz_rear_axle_rx_0*s8_147);
  const double s8_149 = fnma(work.s3_8, work.s7_13, fnma(work.Rz_rear_axle_ry_0, s7_27, s8_148));
  const double s8_150 = fnma(work.Rz_rear_axle_tx_0, work.s7_11, s8_149);
  const double s8_151 = fma(work.Rz_rear_axle_rx_1, s8_147, work.s3_10*s7_32);
  const double s8_152 = fnma(work.Rz_rear_axle_ry_1, s7_27, s8_151);
  const double s8_153 = fnma(work.s3_14, work.s7_13, s8_152);
  const double s8_154 = fnma(work.Rz_rear_axle_tx_1, work.s7_11, s8_153);
  const double s8_155 = fma(work.Rz_rear_axle_rz_0, s8_133, s8_146);
  const double s8_156 = fma(work.Rz_rear_axle_rx_0, s8_154, s8_155);
  // long_rod_left
  const double s8_157 = fma(work.s2_7, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_158 = fnma(work.s2_12, work.Rz_rear_axle_rx_0, s8_157);
  const double s8_159 = fma(work.s2_7, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_160 = fnma(work.s2_12, work.Rz_rear_axle_rx_1, s8_159);
  const double s8_161 = fnma(work.s2_12, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_162 = fnma(work.s2_9, work.Rz_rear_axle_ry_1, s8_161);
  const double s8_163 = fms(work.s2_7, work.s3_10, work.s3_14);
  const double s8_164 = fma(work.s2_9, work.Rz_rear_axle_rx_1, s8_163);
  const double s8_165 = fma(s8_162, s8_162, fma(s8_160, s8_160, s8_164*s8_164));
  const double s8_166 = fms(work.s2_12, work.Rz_rear_axle_rz_0, work.s3_2);
  const double s8_167 = fnma(work.s2_9, work.Rz_rear_axle_ry_0, s8_166);
  const double s8_168 = fms(work.s2_9, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_169 = fnma(work.s2_7, work.Rz_rear_axle_rz_0, s8_168);
  const double s8_170 = fma(s8_167, s8_167, fma(s8_158, s8_158, s8_169*s8_169));
  const double s8_171 = fma(s8_162, s8_167, fma(s8_158, s8_160, s8_164*s8_169));
  const double s8_172 = fms(work.s2_13, work.s8_27, work.s2_17) - work.zdd_star_rear_axle_tx;
  const double s8_173 = fnma(work.s2_8, work.s8_36, fma(work.s2_11, work.s8_42, s8_172));
  const double s8_174 = fnma(work.s6_3, work.s8_12, fma(work.s6_2, work.s8_23, s8_173));
  const double s8_175 = fnma(work.s2_7, work.zdd_star_rear_axle_ry, s8_174);
  const double s8_176 = 3.0*fma(work.s2_12, work.zdd_star_rear_axle_rx, s8_175);
  const double s8_177 = fms(work.s2_13, work.s8_28, work.s2_19) - work.zdd_star_rear_axle_tz;
  const double s8_178 = fnma(work.s2_11, work.s8_36, fma(work.s2_8, work.s8_39, s8_177));
  const double s8_179 = fnma(work.s6_2, work.s8_19, fma(work.s6_1, work.s8_12, s8_178));
  const double s8_180 = fnma(work.s2_12, work.zdd_star_rear_axle_rz, s8_179);
  const double s8_181 = 3.0*fma(work.s2_9, work.zdd_star_rear_axle_ry, s8_180);
  const double s8_182 = fma(work.s6_3, work.s8_19, work.s6_58 - work.s2_18);
  const double s8_183 = fnma(work.s6_1, work.s8_23, s8_182);
  const double s8_184 = fnma(work.s2_9, work.zdd_star_rear_axle_rx, s8_183);
  const double s8_185 = fma(work.s2_7, work.zdd_star_rear_axle_rz, s8_184);
  const double s8_186 = fnma(work.s2_8, work.s8_28, fnma(work.s2_13, work.s8_48, s8_185));
  const double s8_187 = 3.0*fnma(work.s2_11, work.s8_27, s8_186);
  const double s8_188 = fnma(s8_162, s8_181, fnma(s8_160, s8_176, fnma(s8_164, s8_187, s8_55)));
  const double s8_189 = fnma(s8_167, s8_181, fnma(s8_158, s8_176, fnma(s8_169, s8_187, s8_64)));
  // diag_rod_left
  const double s8_190 = fma(work.s2_21, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_191 = fnma(work.s2_28, work.Rz_rear_axle_rx_0, s8_190);
  const double s8_192 = fma(work.s2_21, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_193 = fnma(work.s2_28, work.Rz_rear_axle_rx_1, s8_192);
  const double s8_194 = fnma(work.s2_28, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_195 = fnma(work.s2_24, work.Rz_rear_axle_ry_1, s8_194);
  const double s8_196 = fms(work.s2_21, work.s3_10, work.s3_14);
  const double s8_197 = fma(work.s2_24, work.Rz_rear_axle_rx_1, s8_196);
  const double s8_198 = fma(s8_195, s8_195, fma(s8_193, s8_193, s8_197*s8_197));
  const double s8_199 = fms(work.s2_24, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_200 = fnma(work.s2_21, work.Rz_rear_axle_rz_0, s8_199);
  const double s8_201 = fms(work.s2_28, work.Rz_rear_axle_rz_0, work.s3_2);
  const double s8_202 = fnma(work.s2_24, work.Rz_rear_axle_ry_0, s8_201);
  const double s8_203 = fma(s8_202, s8_202, fma(s8_191, s8_191, s8_200*s8_200));
  const double s8_204 = fma(s8_195, s8_202, fma(s8_191, s8_193, s8_197*s8_200));
  const double s8_205 = fms(work.s2_29, work.s8_27, work.s2_33) - work.zdd_star_rear_axle_tx;
  const double s8_206 = fnma(work.s2_22, work.s8_36, fma(work.s2_26, work.s8_42, s8_205));
  const double s8_207 = fnma(work.s6_6, work.s8_12, fma(work.s6_5, work.s8_23, s8_206));
  const double s8_208 = fnma(work.s2_21, work.zdd_star_rear_axle_ry, s8_207);
  const double s8_209 = 2.6666666666666665*fma(work.s2_28, work.zdd_star_rear_axle_rx, s8_208);
  const double s8_210 = fms(work.s2_29, work.s8_28, work.s2_35) - work.zdd_star_rear_axle_tz;
  const double s8_211 = fnma(work.s2_26, work.s8_36, fma(work.s2_22, work.s8_39, s8_210));
  const double s8_212 = fnma(work.s6_5, work.s8_19, fma(work.s6_4, work.s8_12, s8_211));
  const double s8_213 = fnma(work.s2_28, work.zdd_star_rear_axle_rz, s8_212);
  const double s8_214 = 2.6666666666666665*fma(work.s2_24, work.zdd_star_rear_axle_ry, s8_213);
  const double s8_215 = fma(work.s6_6, work.s8_19, work.s6_58 - work.s2_34);
  const double s8_216 = fnma(work.s6_4, work.s8_23, s8_215);
  const double s8_217 = fnma(work.s2_24, work.zdd_star_rear_axle_rx, s8_216);
  const double s8_218 = fma(work.s2_21, work.zdd_star_rear_axle_rz, s8_217);
  const double s8_219 = fnma(work.s2_22, work.s8_28, fnma(work.s2_29, work.s8_48, s8_218));
  const double s8_220 = 2.6666666666666665*fnma(work.s2_26, work.s8_27, s8_219);
  const double s8_221 = fnma(s8_195, s8_214, fnma(s8_193, s8_209, fnma(s8_197, s8_220, s8_188)));
  const double s8_222 = fnma(s8_202, s8_214, fnma(s8_191, s8_209, fnma(s8_200, s8_220, s8_189)));
  // arb_link_rear_left
  const double s8_223 = fma(work.s2_43, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_224 = fnma(work.s2_46, work.Rz_rear_axle_rx_1, s8_223);
  const double s8_225 = fnma(work.s2_46, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_226 = fnma(work.s2_50, work.Rz_rear_axle_ry_1, s8_225);
  const double s8_227 = fms(work.s2_43, work.s3_10, work.s3_14);
  const double s8_228 = fma(work.s2_50, work.Rz_rear_axle_rx_1, s8_227);
  const double s8_229 = fma(s8_226, s8_226, fma(s8_224, s8_224, s8_228*s8_228));
  const double s8_230 = fms(work.s2_50, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_231 = fnma(work.s2_43, work.Rz_rear_axle_rz_0, s8_230);
  const double s8_232 = work.s2_42 + work.Rz_rear_axle_tx_0;
  const double s8_233 = fma(work.s2_43, work.Rz_rear_axle_ry_0, s8_232);
  const double s8_234 = fnma(work.s2_46, work.Rz_rear_axle_rx_0, s8_233);
  const double s8_235 = fma(work.s2_46, work.Rz_rear_axle_rz_0, work.s2_54 - work.s3_2);
  const double s8_236 = fnma(work.s2_50, work.Rz_rear_axle_ry_0, s8_235);
  const double s8_237 = fma(s8_236, s8_236, fma(s8_234, s8_234, s8_231*s8_231));
  const double s8_238 = fma(s8_226, s8_236, fma(s8_224, s8_234, s8_228*s8_231));
  const double s8_239 = fma(work.s2_48, work.s8_28, work.s6_8 - work.zdd_star_rear_axle_tz);
  const double s8_240 = fma(work.s2_55, work.s8_36, fma(work.s2_45, work.s8_39, s8_239));
  const double s8_241 = fnma(work.s6_11, work.s8_19, fma(work.s6_12, work.s8_12, s8_240));
  const double s8_242 = fnma(work.s2_46, work.zdd_star_rear_axle_rz, s8_241);
  const double s8_243 = 0.3333333333333333*fma(work.s2_50, work.zdd_star_rear_axle_ry, s8_242);
  const double s8_244 = fms(work.s2_48, work.s8_27, work.s6_10) - work.zdd_star_rear_axle_tx;
  const double s8_245 = fnma(work.s2_55, work.s8_42, fnma(work.s2_45, work.s8_36, s8_244));
  const double s8_246 = fnma(work.s6_13, work.s8_12, fma(work.s6_11, work.s8_23, s8_245));
  const double s8_247 = fnma(work.s2_43, work.zdd_star_rear_axle_ry, s8_246);
  const double s8_248 = 0.3333333333333333*fma(work.s2_46, work.zdd_star_rear_axle_rx, s8_247);
  const double s8_249 = fma(work.s2_55, work.s8_27, work.s6_58 - work.s2_53);
  const double s8_250 = fnma(work.s2_48, work.s8_48, fnma(work.s2_45, work.s8_28, s8_249));
  const double s8_251 = fnma(work.s6_12, work.s8_23, fma(work.s6_13, work.s8_19, s8_250));
  const double s8_252 = fnma(work.s2_50, work.zdd_star_rear_axle_rx, s8_251);
  const double s8_253 = 0.3333333333333333*fma(work.s2_43, work.zdd_star_rear_axle_rz, s8_252);
  const double s8_254 = fnma(s8_226, s8_243, fnma(s8_224, s8_248, fnma(s8_228, s8_253, s8_221)));
  const double s8_255 = fnma(s8_236, s8_243, fnma(s8_234, s8_248, fnma(s8_231, s8_253, s8_222)));
  // long_rod_right
  const double s8_256 = fnma(work.s2_58, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_257 = fnma(work.s2_63, work.Rz_rear_axle_ry_1, s8_256);
  const double s8_258 = fnma(work.s2_57, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_259 = fnma(work.s2_58, work.Rz_rear_axle_rx_0, s8_258);
  const double s8_260 = fnma(work.s2_57, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_261 = fnma(work.s2_58, work.Rz_rear_axle_rx_1, s8_260);
  const double s8_262 = fms(work.s2_57, work.Rz_rear_axle_rz_0, work.s3_8);
  const double s8_263 = fma(work.s2_63, work.Rz_rear_axle_rx_0, s8_262);
  const double s8_264 = fms(work.s2_58, work.Rz_rear_axle_rz_0, work.s3_2);
  const double s8_265 = fnma(work.s2_63, work.Rz_rear_axle_ry_0, s8_264);
  const double s8_266 = fma(s8_265, s8_265, fma(s8_259, s8_259, fma(s8_263, s8_263, s8_170)));
  const double s8_267 = fms(work.s2_63, work.Rz_rear_axle_rx_1, work.s3_14);
  const double s8_268 = fnma(work.s2_57, work.s3_10, s8_267);
  const double s8_269 = fma(s8_261, s8_261, fma(s8_257, s8_257, fma(s8_268, s8_268, s8_165)));
  const double s8_270 = fma(s8_259, s8_261, fma(s8_257, s8_265, fma(s8_263, s8_268, s8_171)));
  const double s8_271 = fnma(3.0, s8_270, s8_156);
  const double s8_272 = fma(work.s2_60, work.s8_48, work.s2_67 + work.s6_58);
  const double s8_273 = fnma(work.s2_69, work.s8_27, fnma(work.s2_61, work.s8_28, s8_272));
  const double s8_274 = fnma(work.s6_16, work.s8_23, fma(work.s6_15, work.s8_19, s8_273));
  const double s8_275 = fnma(work.s2_57, work.zdd_star_rear_axle_rz, s8_274);
  const double s8_276 = 3.0*fnma(work.s2_63, work.zdd_star_rear_axle_rx, s8_275);
  const double s8_277 = fms(work.s2_61, work.s8_39, work.s2_66) - work.zdd_star_rear_axle_tz;
  const double s8_278 = fnma(work.s2_60, work.s8_28, fnma(work.s2_69, work.s8_36, s8_277));
  const double s8_279 = fnma(work.s6_14, work.s8_19, fma(work.s6_16, work.s8_12, s8_278));
  const double s8_280 = fnma(work.s2_58, work.zdd_star_rear_axle_rz, s8_279);
  const double s8_281 = 3.0*fma(work.s2_63, work.zdd_star_rear_axle_ry, s8_280);
  const double s8_282 = fms(work.s2_69, work.s8_42, work.s2_68) - work.zdd_star_rear_axle_tx;
  const double s8_283 = fnma(work.s2_60, work.s8_27, fnma(work.s2_61, work.s8_36, s8_282));
  const double s8_284 = fnma(work.s6_15, work.s8_12, fma(work.s6_14, work.s8_23, s8_283));
  const double s8_285 = fma(work.s2_57, work.zdd_star_rear_axle_ry, s8_284);
  const double s8_286 = 3.0*fma(work.s2_58, work.zdd_star_rear_axle_rx, s8_285);
  const double s8_287 = fnma(s8_261, s8_286, fnma(s8_257, s8_281, fnma(s8_268, s8_276, s8_254)));
  const double s8_288 = fnma(s8_265, s8_281, fnma(s8_259, s8_286, fnma(s8_263, s8_276, s8_255)));
  // diag_rod_right
  const double s8_289 = fma(work.s2_71, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_290 = fnma(work.s2_75, work.Rz_rear_axle_rx_0, s8_289);
  const double s8_291 = fma(work.s2_71, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_292 = fnma(work.s2_75, work.Rz_rear_axle_rx_1, s8_291);
  const double s8_293 = fnma(work.s2_75, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_294 = fnma(work.s2_70, work.Rz_rear_axle_ry_1, s8_293);
  const double s8_295 = fms(work.s2_71, work.s3_10, work.s3_14);
  const double s8_296 = fma(work.s2_70, work.Rz_rear_axle_rx_1, s8_295);
  const double s8_297 = fma(s8_294, s8_294, fma(s8_292, s8_292, fma(s8_296, s8_296, s8_198)));
  const double s8_298 = fms(work.s2_70, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_299 = fnma(work.s2_71, work.Rz_rear_axle_rz_0, s8_298);
  const double s8_300 = fms(work.s2_75, work.Rz_rear_axle_rz_0, work.s3_2);
  const double s8_301 = fnma(work.s2_70, work.Rz_rear_axle_ry_0, s8_300);
  const double s8_302 = fma(s8_301, s8_301, fma(s8_290, s8_290, fma(s8_299, s8_299, s8_203)));
  const double s8_303 = fma(s8_294, s8_301, fma(s8_290, s8_292, fma(s8_296, s8_299, s8_204)));
  const double s8_304 = fnma(2.6666666666666665, s8_303, s8_271);
  const double s8_305 = fma(work.s2_81, work.s8_48, work.s6_58 - work.s2_79);
  const double s8_306 = fnma(work.s2_73, work.s8_28, s8_305);
  const double s8_307 = fnma(work.pivot_rear_axle_tx, work.s8_27, s8_306);
  const double s8_308 = fnma(work.s6_17, work.s8_23, fma(work.s6_19, work.s8_19, s8_307));
  const double s8_309 = fnma(work.s2_70, work.zdd_star_rear_axle_rx, s8_308);
  const double s8_310 = 2.6666666666666665*fma(work.s2_71, work.zdd_star_rear_axle_rz, s8_309);
  const double s8_311 = fms(work.s2_73, work.s8_39, work.s2_80) - work.zdd_star_rear_axle_tz;
  const double s8_312 = fnma(work.pivot_rear_axle_tx, work.s8_36, s8_311);
  const double s8_313 = fma(work.s6_17, work.s8_12, fnma(work.s2_81, work.s8_28, s8_312));
  const double s8_314 = fnma(work.s6_18, work.s8_19, s8_313);
  const double s8_315 = fnma(work.s2_75, work.zdd_star_rear_axle_rz, s8_314);
  const double s8_316 = 2.6666666666666665*fma(work.s2_70, work.zdd_star_rear_axle_ry, s8_315);
  const double s8_317 = fms(work.pivot_rear_axle_tx, work.s8_42, work.s2_78);
  const double s8_318 = fnma(work.s2_73, work.s8_36, s8_317 - work.zdd_star_rear_axle_tx);
  const double s8_319 = fma(work.s6_18, work.s8_23, fnma(work.s2_81, work.s8_27, s8_318));
  const double s8_320 = fnma(work.s6_19, work.s8_12, s8_319);
  const double s8_321 = fnma(work.s2_71, work.zdd_star_rear_axle_ry, s8_320);
  const double s8_322 = 2.6666666666666665*fma(work.s2_75, work.zdd_star_rear_axle_rx, s8_321);
  const double s8_323 = fnma(s8_294, s8_316, fnma(s8_292, s8_322, fnma(s8_296, s8_310, s8_287)));
  const double s8_324 = fnma(s8_301, s8_316, fnma(s8_290, s8_322, fnma(s8_299, s8_310, s8_288)));
  // arb_link_rear_right
  const double s8_325 = fms(work.s2_88, work.s3_10, work.s3_14);
  const double s8_326 = fnma(work.s2_85, work.Rz_rear_axle_rx_1, s8_325);
  const double s8_327 = work.s2_92 + work.Rz_rear_axle_tx_1;
  const double s8_328 = fma(work.s2_84, work.Rz_rear_axle_rx_1, s8_327);
  const double s8_329 = fma(work.s2_88, work.Rz_rear_axle_ry_1, s8_328);
  const double s8_330 = fma(work.s2_84, work.s3_10, work.s2_95 + work.Rz_rear_axle_tz_1);
  const double s8_331 = fma(work.s2_85, work.Rz_rear_axle_ry_1, s8_330);
  const double s8_332 = fma(work.Rz_rear_axle_tz_1, s8_84, s7_52);
  const double s8_333 = fnma(work.s3_14, work.s8_88, fma(work.Rz_rear_axle_tx_1, s8_82, s8_332));
  const double s8_334 = fma(work.Rz_rear_axle_ry_1, s8_141, s8_333);
  const double s8_335 = fnma(work.s3_10, s8_133, fma(work.Rz_rear_axle_rx_1, s8_154, s8_334));
  const double s8_336 = fma(s8_331, s8_331, fma(s8_329, s8_329, fma(s8_326, s8_326, s8_229)));
  const double s8_337 = fnma(2.6666666666666665, s8_297, fnma(3.0, s8_269, s8_335));
  const double pivot_arb_rear_right = fnma(0.3333333333333333, s8_336, s8_337);
  const double s8_338 = fma(593.0, work.r_rear_axle_aux1_x, work.s7_13);
  const double s8_339 = fma(work.r_rear_axle_aux1_x, s8_138, s7_32);
  const double s8_340 = 3.0*work.s2_11;
  const double s8_341 = 2.6666666666666665*work.s2_26;
  const double s8_342 = fnma(work.s2_8, s8_340, fma(work.r_rear_axle_aux3_z, s8_338, s8_339));
  const double s8_343 = 0.3333333333333333*work.s2_55;
  const double s8_344 = 3.0*work.s2_69;
  const double s8_345 = fma(work.s2_45, s8_343, fnma(work.s2_22, s8_341, s8_342));
  const double s8_346 = 2.6666666666666665*work.pivot_rear_axle_tx;
  const double s8_347 = 0.3333333333333333*work.s2_97;
  const double s8_348 = fnma(work.s2_73, s8_346, fnma(work.s2_61, s8_344, s8_345));
  work.s8_349 = fma(work.s2_94, s8_347, s8_348);
  const double s8_350 = fma(593.0, z_rear_axle_ty, work.s7_11);
  const double s8_351 = fma(work.r_rear_axle_aux1_x, s8_350, fma(z_rear_axle_ty, s8_338, s7_34));
  const double s8_352 = fma(work.s2_29, s8_341, fma(work.s2_13, s8_340, s8_351));
  const double s8_353 = fnma(work.s2_60, s8_344, fnma(work.s2_48, s8_343, s8_352));
  work.s8_354 = fma(work.s2_87, s8_347, fnma(work.s2_81, s8_346, s8_353));
  const double s8_355 = 3.0*work.s2_13;
  const double s8_356 = fma(work.r_rear_axle_aux3_z, s8_350, fma(z_rear_axle_ty, s8_138, s7_27));
  const double s8_357 = 2.6666666666666665*work.s2_29;
  const double s8_358 = 0.3333333333333333*work.s2_48;
  const double s8_359 = fma(work.s2_22, s8_357, fma(work.s2_8, s8_355, s8_356));
  const double s8_360 = 3.0*work.s2_60;
  const double s8_361 = 2.6666666666666665*work.s2_81;
  const double s8_362 = fnma(work.s2_61, s8_360, fma(work.s2_45, s8_358, s8_359));
  const double s8_363 = 0.3333333333333333*work.s2_87;
  work.s8_364 = fnma(work.s2_94, s8_363, fnma(work.s2_73, s8_361, s8_362));
  const double s8_365 = fma(work.s2_85, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_366 = fma(work.s2_88, work.Rz_rear_axle_rz_0, s8_365);
  const double s8_367 = fma(work.s2_84, work.Rz_rear_axle_rx_0, work.Rz_rear_axle_tx_0);
  const double s8_368 = fma(work.s2_88, work.Rz_rear_axle_ry_0, s8_367);
  const double s8_369 = fms(work.s2_85, work.Rz_rear_axle_ry_0, work.s3_2);
  const double s8_370 = fnma(work.s2_84, work.Rz_rear_axle_rz_0, s8_369);
  const double s8_371 = fnma(s8_326, s8_366, fma(s8_331, s8_370, fma(s8_329, s8_368, s8_238)));
  work.s8_372 = fnma(0.3333333333333333, s8_371, s8_304);
  const double s8_373 = 3.0*work.s2_8;
  const double s8_374 = fma(s8_138, work.r_rear_axle_aux3_z + work.r_rear_axle_aux3_z, s7_39);
  const double s8_375 = 2.6666666666666665*work.s2_22;
  const double s8_376 = 0.3333333333333333*work.s2_45;
  const double s8_377 = fnma(work.s2_22, s8_375, fnma(work.s2_8, s8_373, s8_374));
  const double s8_378 = 3.0*work.s2_61;
  const double s8_379 = 2.6666666666666665*work.s2_73;
  const double s8_380 = fnma(work.s2_61, s8_378, fnma(work.s2_45, s8_376, s8_377));
  const double s8_381 = 0.3333333333333333*work.s2_94;
  work.s8_382 = fnma(work.s2_94, s8_381, fnma(work.s2_73, s8_379, s8_380));
  const double s8_383 = fma(s8_350, z_rear_axle_ty + z_rear_axle_ty, s7_36);
  const double s8_384 = fnma(work.s2_29, s8_357, fnma(work.s2_13, s8_355, s8_383));
  const double s8_385 = fnma(work.s2_60, s8_360, fnma(work.s2_48, s8_358, s8_384));
  work.s8_386 = fnma(work.s2_87, s8_363, fnma(work.s2_81, s8_361, s8_385));
  const double s8_387 = fma(s8_338, work.r_rear_axle_aux1_x + work.r_rear_axle_aux1_x, s7_38);
  const double s8_388 = fnma(work.s2_26, s8_341, fnma(work.s2_11, s8_340, s8_387));
  const double s8_389 = fnma(work.s2_69, s8_344, fnma(work.s2_55, s8_343, s8_388));
  work.s8_390 = fnma(work.s2_97, s8_347, fnma(work.pivot_rear_axle_tx, s8_346, s8_389));
  const double s8_391 = fma(-p_arb_rear_right_y, s8_49, s8_26 + s8_133);
  const double s8_392 = fma(z_rear_axle_ty, s8_84, s8_391);
  const double s8_393 = fma(s8_164, s8_373, fnma(work.r_rear_axle_aux3_z, work.s8_88, s8_392));
  const double s8_394 = fma(s8_357, s8_195, fma(s8_197, s8_375, fma(s8_355, s8_162, s8_393)));
  const double s8_395 = fma(s8_378, s8_268, fma(s8_358, s8_226, fma(s8_228, s8_376, s8_394)));
  const double s8_396 = fnma(s8_361, s8_294, fma(s8_379, s8_296, fnma(s8_360, s8_257, s8_395)));
  work.s8_397 = fnma(s8_331, s8_363, fma(s8_326, s8_381, s8_396));
  const double s8_398 = fnma(-p_arb_rear_right_z, s8_50, s8_154 - s8_25);
  const double s8_399 = fma(work.r_rear_axle_aux1_x, work.s8_88, s8_398);
  const double s8_400 = fnma(s8_340, s8_164, fnma(z_rear_axle_ty, s8_82, s8_399));
  const double s8_401 = fnma(s8_357, s8_193, fnma(s8_341, s8_197, fnma(s8_355, s8_160, s8_400)));
  const double s8_402 = fma(s8_360, s8_261, fnma(s8_358, s8_224, fma(s8_343, s8_228, s8_401)));
  const double s8_403 = fnma(s8_346, s8_296, fma(s8_361, s8_292, fnma(s8_344, s8_268, s8_402)));
  work.s8_404 = fma(s8_326, s8_347, fma(s8_329, s8_363, s8_403));
  const double s8_405 = s7_52 + fma(-p_arb_rear_right_z, s8_50, s8_141);
  const double s8_406 = fnma(-p_arb_rear_right_x, s8_49, s8_405);
  const double s8_407 = fma(work.r_rear_axle_aux3_z, s8_82, s8_406);
  const double s8_408 = fma(s8_340, s8_162, fnma(work.r_rear_axle_aux1_x, s8_84, s8_407));
  const double s8_409 = fnma(s8_193, s8_375, fma(s8_341, s8_195, fnma(s8_160, s8_373, s8_408)));
  const double s8_410 = fma(s8_344, s8_257, fnma(s8_343, s8_226, fnma(s8_224, s8_376, s8_409)));
  const double s8_411 = fnma(s8_379, s8_292, fma(s8_346, s8_294, fnma(s8_378, s8_261, s8_410)));
  work.s8_412 = fnma(s8_331, s8_347, fnma(s8_329, s8_381, s8_411));
  const double s8_413 = fnma(work.s3_2, s8_86, fma(work.Rz_rear_axle_tx_0, s8_79, s7_46));
  const double s8_414 = fma(work.Rz_rear_axle_ry_0, s8_145, fnma(work.s3_8, s8_90, s8_413));
  const double s8_415 = fma(work.Rz_rear_axle_rz_0, s8_137, s8_414);
  const double s8_416 = fnma(3.0, s8_266, fma(work.Rz_rear_axle_rx_0, s8_150, s8_415));
  const double s8_417 = fma(s8_370, s8_370, fma(s8_368, s8_368, fma(s8_366, s8_366, s8_237)));
  const double s8_418 = fnma(2.6666666666666665, s8_302, s8_416);
  const double s8_419 = fnma(0.3333333333333333, s8_417, s8_418);
  const double s8_420 = fma(work.s2_87, work.s8_48, work.s6_58 - work.s2_91);
  const double s8_421 = fnma(work.s2_94, work.s8_28, fma(work.s2_97, work.s8_27, s8_420));
  const double s8_422 = fnma(work.s6_45, work.s8_23, fma(work.s6_46, work.s8_19, s8_421));
  const double s8_423 = fma(work.s2_85, work.zdd_star_rear_axle_rx, s8_422);
  const double s8_424 = 0.3333333333333333*fma(work.s2_88, work.zdd_star_rear_axle_rz, s8_423);
  const double s8_425 = fma(work.s2_94, work.s8_39, work.s6_41 - work.zdd_star_rear_axle_tz);
  const double s8_426 = fnma(work.s2_87, work.s8_28, fma(work.s2_97, work.s8_36, s8_425));
  const double s8_427 = fnma(work.s6_44, work.s8_19, fma(work.s6_45, work.s8_12, s8_426));
  const double s8_428 = fnma(work.s2_85, work.zdd_star_rear_axle_ry, s8_427);
  const double s8_429 = 0.3333333333333333*fma(work.s2_84, work.zdd_star_rear_axle_rz, s8_428);
  const double s8_430 = fms(work.s6_44, work.s8_23, work.s6_43) - work.zdd_star_rear_axle_tx;
  const double s8_431 = fnma(work.s6_46, work.s8_12, s8_430);
  const double s8_432 = fnma(work.s2_84, work.zdd_star_rear_axle_rx, s8_431);
  const double s8_433 = fnma(work.s2_88, work.zdd_star_rear_axle_ry, s8_432);
  const double s8_434 = fnma(work.s2_94, work.s8_36, fnma(work.s2_87, work.s8_27, s8_433));
  const double s8_435 = 0.3333333333333333*fnma(work.s2_97, work.s8_42, s8_434);
  const double s8_436 = fma(s8_366, s8_424, fnma(s8_370, s8_429, fnma(s8_368, s8_435, s8_324)));
  const double tau_rear_axle_tz = tau[Coordinate::rear_axle_tz];
  const double s8_437 = fnma(s8_331, s8_429, fnma(s8_329, s8_435, fnma(s8_326, s8_424, s8_323)));
  const double s8_438 = fma(work.Rz_rear_axle_tz_1, tau_rear_axle_tz - f_rear_axle_z, s8_437);
  const double s8_439 = fma(work.s3_10, n_rear_axle_x - work.s1_104, s8_438);
  const double s8_440 = fms(tau[Coordinate::rear_axle_rz], work.s1_105, n_rear_axle_z);
  const double s8_441 = fma(work.Rz_rear_axle_ry_1, s8_131, s8_439);
  const double s8_442 = f_rear_axle_y - tau[Coordinate::rear_axle_ty];
  const double s8_443 = tau[Coordinate::rear_axle_tx] - f_rear_axle_x;
  const double s8_444 = fma(work.s3_14, s8_442, fma(work.Rz_rear_axle_rx_1, s8_440, s8_441));
  work.s8_445 = work.s8_42 - work.s8_39;
  const double s8_446 = fma(s7_49, work.s8_445, fma(work.Rz_rear_axle_tx_1, s8_443, s8_444));
  work.s8_447 = fma(work.s8_36, s7_50 - s7_51, s8_446);
  work.s8_448 = 1.0/pivot_arb_rear_right;
  const double s8_449 = work.s8_372*work.s8_448;
  result.inertia[12] = fnma(1e-12, pivot_arb_rear_right, pivot_arb_rear_right);
  const double pivot_arb_rear_left = fnma(work.s8_372, s8_449, s8_419);
  result.inertia[11] = fnma(1e-12, s8_419, pivot_arb_rear_left);
  work.s8_450 = 1.0/pivot_arb_rear_left;
  work.s8_451 = s8_82 - s8_50;
  work.s8_452 = fnma(work.s8_451, s8_449, s8_79 - s8_58);
  work.s8_453 = s8_84 - s8_49;
  work.s8_454 = fnma(work.s8_453, s8_449, s8_86 - s8_56);
  const double s8_455 = fma(-p_arb_rear_left_z, s8_58, s8_32 + s8_150);
  const double s8_456 = fnma(z_rear_axle_ty, s8_79, fma(work.r_rear_axle_aux1_x, s8_90, s8_455));
  const double s8_457 = fnma(s8_341, s8_200, fnma(s8_355, s8_158, fnma(s8_340, s8_169, s8_456)));
  const double s8_458 = fnma(s8_358, s8_234, fma(s8_343, s8_231, fnma(s8_357, s8_191, s8_457)));
  const double s8_459 = fma(s8_361, s8_290, fnma(s8_344, s8_263, fma(s8_360, s8_259, s8_458)));
  const double s8_460 = fnma(s8_347, s8_366, fma(s8_363, s8_368, fnma(s8_346, s8_299, s8_459)));
  work.s8_461 = fnma(work.s8_404, s8_449, s8_460);
  const double s8_462 = fma(z_rear_axle_ty, s8_86, s8_137 - s8_31);
  const double s8_463 = fnma(work.r_rear_axle_aux3_z, s8_90, s8_462);
  const double s8_464 = fma(s8_169, s8_373, fnma(p_arb_rear_left_y, s8_56, s8_463));
  const double s8_465 = fma(s8_357, s8_202, fma(s8_200, s8_375, fma(s8_355, s8_167, s8_464)));
  const double s8_466 = fma(s8_378, s8_263, fma(s8_358, s8_236, fma(s8_231, s8_376, s8_465)));
  const double s8_467 = fnma(s8_361, s8_301, fma(s8_379, s8_299, fnma(s8_360, s8_265, s8_466)));
  const double s8_468 = fnma(s8_381, s8_366, fnma(s8_363, s8_370, s8_467));
  work.s8_469 = fnma(work.s8_397, s8_449, s8_468);
  const double s8_470 = s7_46 + fma(-p_arb_rear_left_z, s8_58, s8_145);
  const double s8_471 = fnma(-p_arb_rear_left_x, s8_56, s8_470);
  const double s8_472 = fma(work.r_rear_axle_aux3_z, s8_79, s8_471);
  const double s8_473 = fma(s8_340, s8_167, fnma(work.r_rear_axle_aux1_x, s8_86, s8_472));
  const double s8_474 = fnma(s8_191, s8_375, fma(s8_341, s8_202, fnma(s8_158, s8_373, s8_473)));
  const double s8_475 = fma(s8_344, s8_265, fnma(s8_343, s8_236, fnma(s8_376, s8_234, s8_474)));
  const double s8_476 = fnma(s8_379, s8_290, fma(s8_346, s8_301, fnma(s8_378, s8_259, s8_475)));
  const double s8_477 = fnma(s8_347, s8_370, fnma(s8_381, s8_368, s8_476));
  work.s8_478 = fnma(work.s8_412, s8_449, s8_477);
  work.s8_479 = fnma(work.s8_88, s8_449, s8_90);
  const double s8_480 = work.s8_479*work.s8_450;
  const double s8_481 = work.s8_88*work.s8_448;
  work.s8_482 = fma(work.s8_88, s8_481, work.s8_479*s8_480);
  work.s8_483 = fma(work.s8_453, s8_481, s8_480*work.s8_454);
  work.s8_484 = fma(work.s8_397, s8_481, s8_480*work.s8_469);
  work.s8_485 = fma(work.s8_404, s8_481, s8_480*work.s8_461);
  work.s8_486 = fma(work.s8_412, s8_481, s8_480*work.s8_478);
  const double s8_487 = fnma(work.s8_447, s8_449, s8_436);
  const double s8_488 = fma(work.s3_2, f_rear_axle_z - tau_rear_axle_tz, s8_487);
  const double s8_489 = fma(work.Rz_rear_axle_rz_0, work.s1_104 - n_rear_axle_x, s8_488);
  const double s8_490 = fma(work.Rz_rear_axle_ry_0, s8_131, s8_489);
  const double s8_491 = fma(work.s3_8, s8_442, fma(work.Rz_rear_axle_rx_0, s8_440, s8_490));
  const double s8_492 = fma(s7_43, work.s8_445, fma(work.Rz_rear_axle_tx_0, s8_443, s8_491));
  work.s8_493 = fma(work.s8_36, s7_44 - s7_45, s8_492);
  const double s8_494 = s8_53 + s8_62;
  const double s8_495 = fma(work.s8_447, s8_481, f_rear_axle_y + s8_494);
  work.s8_496 = fma(s8_480, work.s8_493, s8_495);
  const double s8_497 = work.s8_450*work.s8_452;
  const double s8_498 = work.s8_451*work.s8_448;
  work.s8_499 = fma(work.s8_88, s8_498, work.s8_479*s8_497);
  work.s8_500 = fma(work.s8_451, s8_498, work.s8_452*s8_497);
  work.s8_501 = fma(work.s8_453, s8_498, s8_497*work.s8_454);
  work.s8_502 = fma(work.s8_397, s8_498, s8_497*work.s8_469);
  work.s8_503 = fma(work.s8_404, s8_498, s8_497*work.s8_461);
  work.s8_504 = fma(work.s8_412, s8_498, s8_497*work.s8_478);
  const double s8_505 = s8_49*s8_13;
  const double s8_506 = s8_56*s8_14;
  const double s8_507 = fma(work.s8_447, s8_498, f_rear_axle_x - s8_505 - s8_506);
  work.s8_508 = fma(s8_497, work.s8_493, s8_507);
  const double s8_509 = work.s8_450*work.s8_454;
  const double s8_510 = work.s8_453*work.s8_448;
  work.s8_511 = fma(work.s8_453, s8_510, work.s8_454*s8_509);
  work.s8_512 = fma(work.s8_397, s8_510, s8_509*work.s8_469);
  work.s8_513 = fma(work.s8_404, s8_510, s8_509*work.s8_461);
  work.s8_514 = fma(work.s8_412, s8_510, s8_509*work.s8_478);
  const double s8_515 = s8_50*s8_13;
  const double s8_516 = fma(s8_58, s8_14, s8_515);
  const double s8_517 = fma(work.s8_447, s8_510, f_rear_axle_z + s8_516);
  work.s8_518 = fma(s8_509, work.s8_493, s8_517);
  const double s8_519 = work.s8_450*work.s8_469;
  const double s8_520 = work.s8_397*work.s8_448;
  work.s8_521 = fma(work.s8_397, s8_520, work.s8_469*s8_519);
  work.s8_522 = fma(work.s8_404, s8_520, work.s8_461*s8_519);
  work.s8_523 = fma(work.s8_412, s8_520, s8_519*work.s8_478);
  const double s8_524 = fnma(s8_25, s8_13, fma(work.s8_447, s8_520, n_rear_axle_x));
  const double s8_525 = fma(s8_32, s8_14, fnma(s7_51, s8_51, fnma(s7_49, s8_52, s8_524)));
  const double s8_526 = fnma(s7_45, s8_60, fnma(s7_43, s8_61, s8_525));
  const double s8_527 = fma(z_rear_axle_ty, f_rear_axle_z, s8_526);
  const double s8_528 = fnma(work.r_rear_axle_aux3_z, f_rear_axle_y, s8_527);
  const double s8_529 = fnma(work.s2_8, s8_187, fnma(work.s2_13, s8_181, s8_528));
  const double s8_530 = fnma(work.s2_22, s8_220, fnma(work.s2_29, s8_214, s8_529));
  const double s8_531 = fnma(work.s2_45, s8_253, fnma(work.s2_48, s8_243, s8_530));
  const double s8_532 = fnma(work.s2_61, s8_276, fma(work.s2_60, s8_281, s8_531));
  const double s8_533 = fnma(work.s2_73, s8_310, fma(work.s2_81, s8_316, s8_532));
  const double s8_534 = fnma(work.s2_94, s8_424, fma(work.s2_87, s8_429, s8_533));
  const double s8_535 = s8_53 + fma(s8_58, s8_14, s8_62) - s8_515;
  work.s8_536 = fma(p_carrier_left_rz_y, s8_535, fma(s8_519, work.s8_493, s8_534));
  const double s8_537 = work.s8_450*work.s8_461;
  const double s8_538 = work.s8_404*work.s8_448;
  work.s8_539 = fma(work.s8_404, s8_538, work.s8_461*s8_537);
  const double s8_540 = fma(-p_arb_rear_left_z, s8_506, n_rear_axle_z);
  const double s8_541 = fma(work.s8_447, s8_538, fnma(-p_arb_rear_right_z, s8_505, s8_540));
  const double s8_542 = fnma(s8_26, s8_13, fma(s7_49, s8_51, fma(s7_50, s8_52, s8_541)));
  const double s8_543 = fma(s7_43, s8_60, fma(s7_44, s8_61, fma(s8_31, s8_14, s8_542)));
  const double s8_544 = fma(work.r_rear_axle_aux1_x, f_rear_axle_y, s8_543);
  const double s8_545 = fma(work.s2_13, s8_176, fnma(z_rear_axle_ty, f_rear_axle_x, s8_544));
  const double s8_546 = fma(work.s2_29, s8_209, fma(work.s2_11, s8_187, s8_545));
  const double s8_547 = fma(work.s2_48, s8_248, fma(work.s2_26, s8_220, s8_546));
  const double s8_548 = fma(work.s2_69, s8_276, fnma(work.s2_55, s8_253, s8_547));
  const double s8_549 = fma(work.pivot_rear_axle_tx, s8_310, fnma(work.s2_60, s8_286, s8_548));
  const double s8_550 = fnma(work.s2_97, s8_424, fnma(work.s2_81, s8_322, s8_549));
  const double s8_551 = fma(s8_537, work.s8_493, fnma(work.s2_87, s8_435, s8_550));
  work.s8_552 = fnma(-p_arb_rear_left_x, s8_494, s8_551);
  const double s8_553 = work.s8_450*work.s8_478;
  const double s8_554 = work.s8_412*work.s8_448;
  work.s8_555 = fma(work.s8_404, s8_554, work.s8_461*s8_553);
  work.s8_556 = fma(work.s8_412, s8_554, work.s8_478*s8_553);
  const double s8_557 = fma(-p_arb_rear_right_z, s8_505, n_rear_axle_y);
  const double s8_558 = fma(work.s8_447, s8_554, fma(-p_arb_rear_left_z, s8_506, s8_557));
  const double s8_559 = fma(work.r_rear_axle_aux3_z, f_rear_axle_x, s8_558);
  const double s8_560 = fnma(work.r_rear_axle_aux1_x, f_rear_axle_z, s8_559);
  const double s8_561 = fnma(work.s2_11, s8_181, fma(work.s2_8, s8_176, s8_560));
  const double s8_562 = fnma(work.s2_26, s8_214, fma(work.s2_22, s8_209, s8_561));
  const double s8_563 = fma(work.s2_45, s8_248, fma(work.s2_55, s8_243, s8_562));
  const double s8_564 = fnma(work.s2_69, s8_281, fma(work.s2_61, s8_286, s8_563));
  const double s8_565 = fnma(work.pivot_rear_axle_tx, s8_316, fma(work.s2_73, s8_322, s8_564));
  const double s8_566 = fma(work.s2_94, s8_435, fma(work.s2_97, s8_429, s8_565));
  work.s8_567 = fma(-p_arb_rear_left_x, s8_516, fma(s8_553, work.s8_493, s8_566));
  // operations: 779 add, 831 multiply, 2 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s8_568 = I_wheel_front_right_polar*work.s4_66;
  const double tau_wheel_front_right = tau[Coordinate::wheel_front_right];
  const double s8_569 = work.R_carrier_right_aux2_z_y*tau_wheel_front_right;
  work.s8_570 = fma(work.s4_61, s8_568, s8_569);
  const double s8_571 = work.R_carrier_right_aux2_y_y*tau_wheel_front_right;
  work.s8_572 = fnma(work.s4_63, s8_568, s8_571);
  work.s8_573 = fnma(work.s1_37, tau_wheel_front_right, s8_568*work.s4_68);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s8_574 = I_wheel_front_left_polar*work.s4_57;
  const double tau_wheel_front_left = tau[Coordinate::wheel_front_left];
  const double s8_575 = work.R_carrier_left_aux2_z_y*tau_wheel_front_left;
  work.s8_576 = fma(work.s4_52, s8_574, s8_575);
  const double s8_577 = work.R_carrier_left_aux2_y_y*tau_wheel_front_left;
  work.s8_578 = fnma(work.s4_54, s8_574, s8_577);
  work.s8_579 = fnma(work.s1_17, tau_wheel_front_left, s8_574*work.s4_59);
}

/// Part 3 of compute_accelerations: step 2: closure Jacobian Phi_z and its factors (60),
/// upper_ball_left .. tie_rod_right; step 3: Rz (61), upper_ball_left .. tie_rod_right; step 6: c
/// and dRz/dt zd (62), upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces
/// on joints, upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root
/// (63), upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_3(const State& state,
    AccelerationsWork& __restrict work) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), upper_ball_left .. tie_rod_right ---
  // upper_ball_left
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s2_151 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_152 = fnma(-p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s2_151);
  const double s2_153 = -p_upper_arm_left_ball_z*R_upper_arm_left_z_y;
  const double s2_154 = fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s2_153);
  const double s2_155 = -p_carrier_left_upper_ball_y*work.R_carrier_left_aux2_z_y;
  const double pivot_carrier_left_rx = fms(p_carrier_left_upper_ball_z, work.R_carrier_left_z_z,
      s2_155);
  const double s2_156 = -p_carrier_left_upper_ball_y*work.s1_17;
  const double s2_157 = fma(p_carrier_left_upper_ball_z, work.R_carrier_left_x_z, s2_156);
  const double s2_158 = fnma(work.s4_42, pivot_carrier_left_rx, work.s4_12*s2_157);
  const double s2_159 = -p_carrier_left_upper_ball_y*work.R_carrier_left_aux2_y_y;
  const double s2_160 = fms(p_carrier_left_upper_ball_z, work.R_carrier_left_y_z, s2_159);
  const double s2_161 = fnma(work.s4_14, s2_157, work.s4_42*s2_160);
  const double s2_162 = fnma(work.s4_12, s2_158, work.s4_14*s2_161);
  const double s2_163 = fnma(work.s4_12, s2_160, work.s4_14*pivot_carrier_left_rx);
  // upper_ball_right
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s2_164 = -p_upper_arm_right_ball_z*R_upper_arm_right_z_y;
  const double s2_165 = fnma(-p_upper_arm_right_ball_y, R_upper_arm_right_y_y, s2_164);
  const double s2_166 = -p_upper_arm_right_ball_y*R_upper_arm_right_z_y;
  const double s2_167 = fma(-p_upper_arm_right_ball_z, R_upper_arm_right_y_y, s2_166);
  const double s2_168 = p_carrier_right_upper_ball_y*work.R_carrier_right_aux2_z_y;
  const double pivot_carrier_right_rx = fma(p_carrier_right_upper_ball_z, work.R_carrier_right_z_z,
      s2_168);
  const double s2_169 = p_carrier_right_upper_ball_y*work.R_carrier_right_aux2_y_y;
  const double s2_170 = fma(p_carrier_right_upper_ball_z, work.R_carrier_right_y_z, s2_169);
  const double s2_171 = fnma(work.s4_23, s2_170, work.s4_25*pivot_carrier_right_rx);
  const double s2_172 = p_carrier_right_upper_ball_y*work.s1_37;
  const double s2_173 = fms(p_carrier_right_upper_ball_z, work.R_carrier_right_x_z, s2_172);
  const double s2_174 = fnma(work.s4_25, s2_173, work.s4_48*s2_170);
  const double s2_175 = fnma(work.s4_48, pivot_carrier_right_rx, work.s4_23*s2_173);
  const double s2_176 = fnma(work.s4_23, s2_175, work.s4_25*s2_174);
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s2_177 = -p_arb_link_front_left_from_x*R_arb_front_left_x_z;
  work.s2_178 = fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s2_177);
  const double s2_179 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s2_180 = fnma(-p_arb_link_front_left_from_x, R_arb_front_left_x_x, s2_179);
  const double s2_181 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s2_182 = work.s1_17 + work.R_carrier_left_x_z;
  work.s2_183 = fma(-p_arb_link_front_left_to_y, s2_182, s2_181);
  work.s2_184 = 0.35 + (work.s2_180 - work.s2_183);
  const double s2_185 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s2_186 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s2_187 = fma(-p_arb_link_front_left_to_y, s2_185, s2_186);
  const double s2_188 = fnma(work.s4_42, work.s2_187, work.s4_12*work.s2_183);
  work.r_carrier_left_aux1_z = work.s1_13 - (-p_lower_arm_left_z);
  const double s2_189 = work.s2_178 - work.r_carrier_left_aux1_z - work.s2_187;
  work.s2_190 = s2_189 - (-p_arb_front_left_z);
  const double pivot_arb_front_left = fnma(work.s2_180, work.s2_190, work.s2_178*work.s2_184);
  const double s2_191 = fnma(work.s2_183, work.s2_190, work.s2_184*work.s2_187);
  const double s2_192 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s2_193 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s2_194 = fma(-p_arb_link_front_left_to_y, s2_192, s2_193);
  const double s2_195 = fnma(work.s4_14, work.s2_183, work.s4_42*work.s2_194);
  const double s2_196 = fnma(work.s4_12, work.s2_194, work.s4_14*work.s2_187);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_11;
  work.s2_197 = 0.72 - work.r_carrier_left_aux1_y - work.s2_194;
  const double s2_198 = fnma(work.s2_184, work.s2_194, work.s2_183*work.s2_197);
  const double s2_199 = fnma(work.s2_187, work.s2_197, work.s2_190*work.s2_194);
  const double s2_200 = fnma(work.s1_13, work.s2_197, fma(work.s1_11, work.s2_190, s2_199));
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s2_201 = -p_arb_link_front_right_from_x*R_arb_front_right_x_z;
  work.s2_202 = fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s2_201);
  const double s2_203 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s2_204 = fnma(-p_arb_link_front_right_from_x, R_arb_front_right_x_x, s2_203);
  const double s2_205 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s2_206 = work.R_carrier_right_x_z - work.s1_37;
  work.s2_207 = fma(-p_arb_link_front_left_to_y, s2_206, s2_205);
  work.s2_208 = 0.35 + (work.s2_204 - work.s2_207);
  const double s2_209 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s2_210 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s2_211 = fma(-p_arb_link_front_left_to_y, s2_209, s2_210);
  const double s2_212 = fnma(work.s4_48, work.s2_211, work.s4_23*work.s2_207);
  work.s2_213 = -p_lower_arm_right_z + work.s1_33;
  work.s2_214 = work.s2_213 + work.s2_202 - work.s2_211 - (-p_arb_front_right_z);
  const double pivot_arb_front_right = fnma(work.s2_204, work.s2_214, work.s2_202*work.s2_208);
  const double s2_215 = fnma(work.s2_207, work.s2_214, work.s2_208*work.s2_211);
  const double s2_216 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s2_217 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s2_218 = fma(-p_arb_link_front_left_to_y, s2_216, s2_217);
  const double s2_219 = fnma(work.s4_25, work.s2_207, work.s4_48*work.s2_218);
  const double s2_220 = fnma(work.s4_23, work.s2_218, work.s4_25*work.s2_211);
  work.r_carrier_right_aux1_y = work.s1_31 - (-p_lower_arm_right_y);
  work.s2_221 = 0.72 + (work.r_carrier_right_aux1_y + work.s2_218);
  const double s2_222 = fma(work.s2_214, work.s2_218, work.s2_211*work.s2_221);
  const double s2_223 = fma(work.s2_208, work.s2_218, work.s2_207*work.s2_221);
  const double s2_224 = fnma(work.s1_33, work.s2_221, fma(work.s1_31, work.s2_214, s2_222));
  // drag_link
  work.s2_225 = -p_drag_link_from_z*work.sines[15];
  const double R_bell_crank_y_x = work.sines[16];
  work.s2_226 = p_drag_link_to_y*R_bell_crank_y_x;
  work.s2_227 = 1.15 + (work.s2_226 - work.s2_225);
  work.s2_228 = -p_drag_link_from_z*work.cosines[15];
  work.s2_229 = 0.2 - work.s2_228;
  const double pivot_pitman_arm = fnma(work.s2_228, work.s2_227, work.s2_225*work.s2_229);
  const double R_bell_crank_x_x = work.cosines[16];
  work.s2_230 = p_drag_link_to_y*R_bell_crank_x_x;
  work.s2_231 = p_pitman_arm_y - work.s2_230;
  const double s2_232 = fma(work.s2_227, work.s2_230, work.s2_226*work.s2_231);
  // tie_rod_left
  const double s2_233 = fms(p_tie_rod_left_to_z, work.R_carrier_left_z_z, s2_155);
  work.s2_234 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_z_x, s2_233);
  work.s2_235 = -p_bell_crank_z + (work.r_carrier_left_aux1_z + work.s2_234);
  const double s2_236 = fms(p_tie_rod_left_to_z, work.R_carrier_left_y_z, s2_159);
  work.s2_237 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_y_x, s2_236);
  const double s2_238 = fnma(work.s4_12, work.s2_237, work.s4_14*work.s2_234);
  const double s2_239 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  work.s2_240 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_239);
  work.s2_241 = work.s2_240 - work.r_carrier_left_aux1_y - work.s2_237;
  const double s2_242 = fma(work.s2_234, work.s2_241, work.s2_235*work.s2_237);
  const double s2_243 = fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, s2_156);
  work.s2_244 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_x_x, s2_243);
  const double s2_245 = fnma(work.s4_14, work.s2_244, work.s4_42*work.s2_237);
  const double s2_246 = fnma(work.s4_42, work.s2_234, work.s4_12*work.s2_244);
  const double s2_247 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  work.s2_248 = fma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s2_247);
  work.s2_249 = 0.35 + (work.s2_248 + work.s2_244);
  const double s2_250 = fnma(work.s2_240, work.s2_249, work.s2_248*work.s2_241);
  const double s2_251 = fnma(work.s2_234, work.s2_249, work.s2_235*work.s2_244);
  const double s2_252 = fma(work.s2_237, work.s2_249, work.s2_241*work.s2_244);
  const double s2_253 = fma(work.s1_13, work.s2_241, fma(work.s1_11, work.s2_235, s2_242));
  // tie_rod_right
  work.s2_254 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_239);
  const double s2_255 = fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, s2_168);
  work.s2_256 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_z_x, s2_255);
  work.s2_257 = -p_bell_crank_z + (work.s2_256 - work.s2_213);
  const double s2_258 = fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, s2_169);
  work.s2_259 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_y_x, s2_258);
  const double s2_260 = fnma(work.s4_23, work.s2_259, work.s4_25*work.s2_256);
  work.s2_261 = work.s2_254 + (work.r_carrier_right_aux1_y + work.s2_259);
  const double s2_262 = fnma(work.s2_257, work.s2_259, work.s2_256*work.s2_261);
  work.s2_263 = fnma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s2_247);
  const double s2_264 = fms(p_tie_rod_right_to_z, work.R_carrier_right_x_z, s2_172);
  work.s2_265 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_x_x, s2_264);
  const double s2_266 = fnma(work.s4_25, work.s2_265, work.s4_48*work.s2_259);
  const double s2_267 = fnma(work.s4_48, work.s2_256, work.s4_23*work.s2_265);
  work.s2_268 = work.s2_263 - work.s2_265 - 0.35;
  const double s2_269 = fnma(work.s2_261, work.s2_263, work.s2_254*work.s2_268);
  const double s2_270 = fma(work.s2_256, work.s2_268, work.s2_257*work.s2_265);
  const double s2_271 = fma(work.s2_259, work.s2_268, work.s2_261*work.s2_265);
  const double s2_272 = fnma(work.s1_33, work.s2_261, fnma(work.s1_31, work.s2_257, s2_262));
  const double s2_273 = 1.0/pivot_carrier_right_rx;
  const double s2_274 = s2_270*s2_273;
  const double pivot_carrier_right_ry = fnma(s2_170, s2_274, s2_271);
  const double s2_275 = s2_173*s2_273;
  const double s2_276 = 1.0/pivot_carrier_right_ry;
  const double s2_277 = s2_276*(s2_170*s2_275);
  const double s2_278 = s2_173*s2_276;
  const double pivot_carrier_right_rz = fms(s2_262, s2_278, pivot_carrier_right_rx);
  const double s2_279 = 1.0/pivot_carrier_right_rz;
  const double s2_280 = fnma(s2_262, s2_277, s2_170)*s2_279;
  const double pivot_upper_arm_right = fms(s2_167, s2_280, s2_165);
  const double s2_281 = 1.0/pivot_carrier_left_rx;
  const double s2_282 = s2_251*s2_281;
  const double s2_283 = fma(s2_160, s2_282, s2_252);
  const double s2_284 = s2_157*s2_281;
  const double s2_285 = 1.0/s2_283;
  const double s2_286 = s2_160*s2_284*s2_285;
  const double pivot_lower_arm_left = fnma(s2_253, s2_286, work.s1_11 + s2_160);
  const double s2_287 = s2_157*s2_285;
  const double s2_288 = 1.0/pivot_lower_arm_left;
  const double s2_289 = (fms(s2_253, s2_287, work.s1_13) - pivot_carrier_left_rx)*s2_288;
  const double pivot_upper_arm_left = fma(s2_154, s2_289, s2_152);
  const double s2_290 = s2_250*s2_286;
  const double s2_291 = fma(s2_289, s2_290, s2_250*s2_287);
  const double s2_292 = s2_269*s2_278;
  const double s2_293 = fma(s2_280, s2_292, s2_269*s2_277);
  const double s2_294 = fma(s2_272, s2_278, work.s1_33 - pivot_carrier_right_rx);
  const double s2_295 = fnma(s2_280, s2_294, fnma(s2_272, s2_277, work.s1_31 + s2_170));
  const double s2_296 = fnma(s2_242, s2_286, s2_160);
  const double s2_297 = fnma(s2_289, s2_296, fms(s2_242, s2_287, pivot_carrier_left_rx));
  const double s2_298 = 16.504892200367603*std::abs(pivot_arb_front_right);
  const double s2_299 = mbgen::min(3.9625229801272064*std::abs(pivot_pitman_arm), s2_298);
  const double s2_300 = mbgen::min(16.679425973935604*std::abs(pivot_arb_front_left), s2_299);
  const double s2_301 = mbgen::min(2.7028647671567816*std::abs(pivot_carrier_right_rx), s2_300);
  const double s2_302 = mbgen::min(s2_301, 6.8514628664707224*std::abs(pivot_carrier_right_ry));
  const double s2_303 = mbgen::min(s2_302, 2.7028647671567816*std::abs(pivot_carrier_right_rz));
  const double s2_304 = mbgen::min(s2_303, 3.405476531191585*std::abs(pivot_upper_arm_right));
  const double s2_305 = mbgen::min(2.7028219055711094*std::abs(pivot_carrier_left_rx), s2_304);
  const double s2_306 = mbgen::min(6.915894223167945*std::abs(s2_283), s2_305);
  const double s2_307 = mbgen::min(2.5101920700758265*std::abs(pivot_lower_arm_left), s2_306);
  work.s2_308 = mbgen::min(3.84681640934729*std::abs(pivot_upper_arm_left), s2_307);
  // operations: 142 add, 189 multiply, 6 divide, 21 other

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  const double s3_17 = 1.0/pivot_upper_arm_left;
  work.s3_18 = s2_297*s3_17;
  work.s3_19 = s2_288*fma(s2_154, work.s3_18, s2_296);
  work.Rz_upper_arm_left_2 = s3_17*s2_291;
  work.Rz_lower_arm_left_2 = s2_288*fms(s2_154, work.Rz_upper_arm_left_2, s2_290);
  work.s3_20 = s2_285*fms(s2_253, work.s3_19, s2_242);
  work.s3_21 = s2_281*(s2_160*work.s3_20);
  work.s3_22 = fnma(work.s2_234, work.s3_21, work.s2_237*work.s3_20);
  work.s3_23 = s2_285*fnma(s2_253, work.Rz_lower_arm_left_2, s2_250);
  work.s3_24 = s2_281*(s2_160*work.s3_23);
  const double s3_25 = fnma(s2_198, work.s3_23, s2_200*work.Rz_lower_arm_left_2);
  const double s3_26 = fnma(s2_198, work.s3_20, fnma(s2_191, work.s3_21, s2_199));
  const double s3_27 = 1.0/pivot_arb_front_left;
  work.Rz_arb_front_left_0 = s3_27*fnma(s2_200, work.s3_19, s3_26);
  const double s3_28 = fnma(work.s2_194, work.s3_20, work.s2_178*work.Rz_arb_front_left_0);
  work.s3_29 = fma(work.s2_187, work.s3_21, s3_28);
  work.Rz_arb_front_left_2 = s3_27*fnma(s2_191, work.s3_24, s3_25);
  const double s3_30 = fnma(work.s2_194, work.s3_23, work.s2_178*work.Rz_arb_front_left_2);
  work.s3_31 = fma(work.s2_187, work.s3_24, s3_30);
  const double s3_32 = 1.0/pivot_upper_arm_right;
  work.s3_33 = s2_295*s3_32;
  work.s3_34 = s2_279*fma(s2_167, work.s3_33, s2_294);
  work.s3_35 = s2_293*s3_32;
  work.Rz_carrier_right_rz_2 = s2_279*fnma(s2_167, work.s3_35, s2_292);
  work.Rz_carrier_right_ry_1 = s2_276*fnma(s2_262, work.s3_34, s2_272);
  work.Rz_carrier_right_rx_1 = s2_273*(s2_170*work.Rz_carrier_right_ry_1);
  const double s3_36 = fma(s2_215, work.Rz_carrier_right_rx_1, s2_224);
  const double s3_37 = fnma(s2_223, work.Rz_carrier_right_ry_1, s3_36);
  const double s3_38 = work.s2_256*work.Rz_carrier_right_rx_1;
  work.s3_39 = fnma(work.s2_259, work.Rz_carrier_right_ry_1, s3_38);
  work.Rz_carrier_right_ry_2 = s2_276*fms(s2_262, work.Rz_carrier_right_rz_2, s2_269);
  const double s3_40 = work.s2_207*work.Rz_carrier_right_ry_2;
  work.s3_41 = fnma(work.s2_211, work.Rz_carrier_right_rz_2, s3_40);
  work.Rz_carrier_right_rx_2 = s2_273*(s2_170*work.Rz_carrier_right_ry_2);
  const double s3_42 = s2_222*work.Rz_carrier_right_rz_2;
  const double s3_43 = fma(s2_215, work.Rz_carrier_right_rx_2, s3_42);
  const double s3_44 = work.s2_259*work.Rz_carrier_right_rz_2;
  work.s3_45 = fnma(work.s2_265, work.Rz_carrier_right_rx_2, s3_44);
  const double s3_46 = 1.0/pivot_arb_front_right;
  work.Rz_arb_front_right_1 = s3_46*fnma(s2_222, work.s3_34, s3_37);
  const double s3_47 = work.s2_202*work.Rz_arb_front_right_1;
  const double s3_48 = fnma(work.s2_211, work.Rz_carrier_right_rx_1, s3_47);
  work.s3_49 = fma(work.s2_218, work.Rz_carrier_right_ry_1, s3_48);
  work.Rz_arb_front_right_2 = s3_46*fnma(s2_223, work.Rz_carrier_right_ry_2, s3_43);
  const double s3_50 = work.s2_204*work.Rz_arb_front_right_2;
  const double s3_51 = fma(work.s2_218, work.Rz_carrier_right_rz_2, s3_50);
  work.s3_52 = fnma(work.s2_207, work.Rz_carrier_right_rx_2, s3_51);
  const double s3_53 = work.s2_202*work.Rz_arb_front_right_2;
  const double s3_54 = fnma(work.s2_211, work.Rz_carrier_right_rx_2, s3_53);
  work.s3_55 = fma(work.s2_218, work.Rz_carrier_right_ry_2, s3_54);
  const double s3_56 = 1.0/pivot_pitman_arm;
  work.s3_57 = s2_232*s3_56;
  // operations: 32 add, 68 multiply, 5 divide

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  // arb_link_front_left
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s6_63 = zd_arb_front_left*work.s2_180;
  const double s6_64 = fma(work.s4_14, s2_195, zd_arb_front_left*s6_63);
  work.s6_65 = fnma(work.s4_12, s2_188, s6_64);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s6_66 = zd_lower_arm_left*work.s1_11;
  work.s6_67 = s6_63 + (work.s6_66 + s2_195);
  work.s6_68 = zd_lower_arm_left*zd_lower_arm_left;
  work.s6_69 = work.s1_11*work.s6_68;
  work.s6_70 = fnma(work.s4_42, s2_195, fms(work.s4_12, s2_196, work.s6_69));
  work.s6_71 = work.s1_13*work.s6_68;
  const double s6_72 = zd_arb_front_left*work.s2_178;
  const double s6_73 = fma(work.s4_42, s2_188, fms(zd_arb_front_left, s6_72, work.s6_71));
  work.s6_74 = fnma(work.s4_14, s2_196, s6_73);
  work.s6_75 = s6_72 - s2_196;
  // arb_link_front_right
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s6_76 = zd_arb_front_right*work.s2_204;
  const double s6_77 = fma(work.s4_25, s2_219, zd_arb_front_right*s6_76);
  work.s6_78 = fnma(work.s4_23, s2_212, s6_77);
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s6_79 = zd_lower_arm_right*work.s1_31;
  work.s6_80 = s6_76 + (work.s6_79 + s2_219);
  work.s6_81 = zd_lower_arm_right*zd_lower_arm_right;
  work.s6_82 = work.s1_31*work.s6_81;
  work.s6_83 = fnma(work.s4_48, s2_219, fms(work.s4_23, s2_220, work.s6_82));
  work.s6_84 = work.s1_33*work.s6_81;
  const double s6_85 = zd_arb_front_right*work.s2_202;
  const double s6_86 = fma(work.s4_48, s2_212, fma(zd_arb_front_right, s6_85, work.s6_84));
  work.s6_87 = fnma(work.s4_25, s2_220, s6_86);
  work.s6_88 = s6_85 - s2_220;
  // drag_link
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s6_89 = zd_pitman_arm*work.s2_225;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s6_90 = zd_bell_crank*work.s2_226;
  work.s6_91 = fnma(zd_bell_crank, work.s6_90, zd_pitman_arm*work.s6_89);
  const double s6_92 = zd_pitman_arm*work.s2_228;
  const double s6_93 = zd_bell_crank*work.s2_230;
  work.s6_94 = s6_93 - s6_92;
  const double s6_95 = fma(work.s6_89, work.s6_89, work.s6_90*work.s6_90);
  work.s6_96 = zd_bell_crank*s6_93;
  work.s6_97 = zd_pitman_arm*s6_92;
  const double s6_98 = fma(work.s2_231, work.s6_96, fma(work.s6_94, work.s6_94, s6_95));
  const double s6_99 = fma(work.s2_227, work.s6_91, fma(work.s2_229, work.s6_97, s6_98));
  // tie_rod_left
  const double s6_100 = zd_bell_crank*work.s2_248;
  work.s6_101 = fma(work.s4_12, s2_246, fnma(work.s4_14, s2_245, zd_bell_crank*s6_100));
  const double s6_102 = zd_bell_crank*work.s2_240;
  work.s6_103 = work.s6_66 + s2_245;
  work.s6_104 = s6_102 + s2_238;
  work.s6_105 = zd_lower_arm_left*work.s1_13;
  work.s6_106 = s6_100 + s2_246 - work.s6_105;
  const double s6_107 = fma(work.s6_104, work.s6_104, work.s6_103*work.s6_103);
  work.s6_108 = fnma(work.s4_14, s2_238, fms(work.s4_42, s2_246, work.s6_71));
  const double s6_109 = fma(work.s2_235, work.s6_108, fma(work.s6_106, work.s6_106, s6_107));
  const double s6_110 = fma(work.s4_12, s2_238, fms(zd_bell_crank, s6_102, work.s6_69));
  work.s6_111 = fnma(work.s4_42, s2_245, s6_110);
  const double s6_112 = fnma(work.s2_241, work.s6_111, fnma(work.s2_249, work.s6_101, s6_109));
  const double s6_113 = fma(s2_282, s2_162, s6_112);
  // tie_rod_right
  const double s6_114 = zd_bell_crank*work.s2_263;
  work.s6_115 = fnma(work.s4_23, s2_267, fma(work.s4_25, s2_266, zd_bell_crank*s6_114));
  work.s6_116 = fnma(work.s4_25, s2_260, fma(work.s4_48, s2_267, work.s6_84));
  const double s6_117 = zd_bell_crank*work.s2_254;
  const double s6_118 = fnma(work.s4_23, s2_260, fma(zd_bell_crank, s6_117, work.s6_82));
  work.s6_119 = fma(work.s4_48, s2_266, s6_118);
  work.s6_120 = s6_117 - s2_260;
  work.s6_121 = work.s6_79 + s2_266;
  work.s6_122 = zd_lower_arm_right*work.s1_33;
  work.s6_123 = s6_114 - work.s6_122 - s2_267;
  const double s6_124 = fma(work.s6_120, work.s6_120, work.s6_121*work.s6_121);
  const double s6_125 = fma(work.s2_257, work.s6_116, fma(work.s6_123, work.s6_123, s6_124));
  const double s6_126 = fnma(work.s2_261, work.s6_119, fnma(work.s2_268, work.s6_115, s6_125));
  const double s6_127 = fma(s2_274, s2_176, s6_126);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s6_128 = fma(s2_286, s6_113, work.s6_71);
  const double s6_129 = fnma(zd_upper_arm_left, zd_upper_arm_left*s2_152, s6_128);
  const double s6_130 = fma(work.s4_14, s2_163, fnma(work.s4_42, s2_158, s6_129));
  const double s6_131 = fnma(s2_284, s2_162, s6_130);
  const double s6_132 = fms(zd_upper_arm_left, zd_upper_arm_left*s2_154, work.s6_69);
  const double s6_133 = fnma(work.s4_42, s2_161, fma(work.s4_12, s2_163, s6_132));
  work.s6_134 = s3_17*fma(s2_289, s6_131, fma(s2_287, s6_113, s6_133));
  work.zdd_star_lower_arm_left = s2_288*fnma(s2_154, work.s6_134, s6_131);
  work.zdd_star_carrier_left_ry = s2_285*fma(s2_253, work.zdd_star_lower_arm_left, s6_113);
  const double s6_135 = s2_200*work.zdd_star_lower_arm_left;
  work.zdd_star_carrier_left_rx = s2_281*fms(s2_160, work.zdd_star_carrier_left_ry, s2_162);
  const double s6_136 = fma(s2_198, work.zdd_star_carrier_left_ry, s6_135);
  work.s6_137 = s2_188 - work.s6_105;
  const double s6_138 = fma(s2_191, work.zdd_star_carrier_left_rx, s6_136);
  const double s6_139 = fnma(work.s6_75, work.s6_75, fnma(work.s6_137, work.s6_137, s6_138));
  const double s6_140 = fma(work.s2_197, work.s6_70, fnma(work.s6_67, work.s6_67, s6_139));
  work.zdd_star_arb_front_left = s3_27*fma(work.s2_190, work.s6_74, fma(work.s2_184, work.s6_65,
      s6_140));
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s6_141 = fma(s2_278, s6_127, work.s6_82);
  const double s6_142 = fnma(zd_upper_arm_right, zd_upper_arm_right*s2_165, s6_141);
  const double s6_143 = fma(work.s4_48, s2_174, fnma(work.s4_23, s2_171, s6_142));
  const double s6_144 = fnma(work.s4_25, s2_171, fma(work.s4_48, s2_175, work.s6_84));
  const double s6_145 = fnma(zd_upper_arm_right, zd_upper_arm_right*s2_167, s6_144);
  const double s6_146 = fma(s2_280, s6_143, fma(s2_277, s6_127, fma(s2_275, s2_176, s6_145)));
  work.s6_147 = s3_32*s6_146;
  work.zdd_star_carrier_right_rz = s2_279*fnma(s2_167, work.s6_147, s6_143);
  work.zdd_star_carrier_right_ry = s2_276*fms(s2_262, work.zdd_star_carrier_right_rz, s6_127);
  work.zdd_star_carrier_right_rx = s2_273*fms(s2_170, work.zdd_star_carrier_right_ry, s2_176);
  const double s6_148 = s2_222*work.zdd_star_carrier_right_rz;
  work.s6_149 = work.s6_122 + s2_212;
  const double s6_150 = fma(s2_215, work.zdd_star_carrier_right_rx, s6_148);
  const double s6_151 = fnma(work.s6_88, work.s6_88, fnma(work.s6_149, work.s6_149, s6_150));
  const double s6_152 = fnma(work.s2_221, work.s6_83, fnma(work.s6_80, work.s6_80, s6_151));
  const double s6_153 = fma(work.s2_214, work.s6_87, fma(work.s2_208, work.s6_78, s6_152));
  work.zdd_star_arb_front_right = s3_46*fnma(s2_223, work.zdd_star_carrier_right_ry, s6_153);
  work.s6_154 = s3_56*s6_99;
  // operations: 105 add, 137 multiply

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s7_53 = -h_lower_arm_left_z*R_lower_arm_left_z_y;
  work.s7_54 = fma(h_lower_arm_left_y, R_lower_arm_left_y_y, s7_53);
  const double s7_55 = h_lower_arm_left_y*R_lower_arm_left_z_y;
  work.s7_56 = fnma(-h_lower_arm_left_z, R_lower_arm_left_y_y, s7_55);
  const double s7_57 = K_lower_arm_left_zz*R_lower_arm_left_z_y;
  const double s7_58 = fma(-K_lower_arm_left_yz, R_lower_arm_left_y_y, s7_57);
  const double s7_59 = -K_lower_arm_left_yz*R_lower_arm_left_z_y;
  const double s7_60 = fma(K_lower_arm_left_yy, R_lower_arm_left_y_y, s7_59);
  work.s7_61 = fnma(R_lower_arm_left_y_y, s7_58, R_lower_arm_left_z_y*s7_60);
  work.s7_62 = fma(R_lower_arm_left_y_y, s7_60, R_lower_arm_left_z_y*s7_58);
  work.s7_63 = 1.825625 - work.s7_62;
  work.s7_64 = work.s7_62 + work.s7_63;
  work.s7_65 = K_lower_arm_left_xx + work.s7_64 - K_lower_arm_left_xx;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_66 = K_carrier_left_yz*work.R_carrier_left_x_z;
  const double s7_67 = fma(K_carrier_left_xy, work.R_carrier_left_x_x, s7_66);
  const double s7_68 = fnma(K_carrier_left_yy, work.s1_17, s7_67);
  const double s7_69 = K_carrier_left_yy*work.R_carrier_left_aux2_y_y;
  const double s7_70 = fma(K_carrier_left_xy, work.R_carrier_left_y_x, s7_69);
  const double s7_71 = fma(K_carrier_left_yz, work.R_carrier_left_y_z, s7_70);
  const double s7_72 = h_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_73 = fma(h_carrier_left_z, work.R_carrier_left_z_z, s7_72);
  work.s7_74 = fnma(-h_carrier_left_x, work.R_carrier_left_z_x, s7_73);
  const double s7_75 = h_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_76 = fma(h_carrier_left_z, work.R_carrier_left_y_z, s7_75);
  work.s7_77 = fnma(-h_carrier_left_x, work.R_carrier_left_y_x, s7_76);
  const double s7_78 = h_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_79 = fnma(-h_carrier_left_x, work.R_carrier_left_x_x, s7_78);
  work.s7_80 = fnma(h_carrier_left_y, work.s1_17, s7_79);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_580 = fnma(work.s3_21, work.s7_74, work.s3_20*work.s7_77);
  work.s8_581 = fnma(work.s3_24, work.s7_74, work.s3_23*work.s7_77);
  const double s8_582 = fma(m_rear_axle_2, state.z[Coordinate::rear_axle_ty], work.s7_11);
  work.s8_583 = s8_582 + work.s7_77;
  work.s8_584 = fma(m_rear_axle_2, work.r_rear_axle_aux1_x, work.s7_13) + work.s7_80;
  work.s8_585 = fma(m_rear_axle_2, work.r_rear_axle_aux3_z, work.s7_14) + work.s7_74;

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_81 = K_carrier_left_yz*work.R_carrier_left_aux2_y_y;
  const double s7_82 = fma(K_carrier_left_zz, work.R_carrier_left_y_z, s7_81);
  const double s7_83 = fnma(-K_carrier_left_xz, work.R_carrier_left_y_x, s7_82);
  const double s7_84 = K_carrier_left_zz*work.R_carrier_left_x_z;
  const double s7_85 = fnma(-K_carrier_left_xz, work.R_carrier_left_x_x, s7_84);
  const double s7_86 = fnma(K_carrier_left_yz, work.s1_17, s7_85);
  const double s7_87 = K_carrier_left_xy*work.R_carrier_left_aux2_y_y;
  const double s7_88 = fma(K_carrier_left_xx, work.R_carrier_left_y_x, s7_87);
  const double s7_89 = fnma(-K_carrier_left_xz, work.R_carrier_left_y_z, s7_88);
  const double s7_90 = fma(work.R_carrier_left_z_z, s7_83, work.R_carrier_left_aux2_z_y*s7_71);
  work.s7_91 = fma(work.R_carrier_left_z_x, s7_89, s7_90);
  const double s7_92 = K_carrier_left_xx*work.R_carrier_left_x_x;
  const double s7_93 = fnma(-K_carrier_left_xz, work.R_carrier_left_x_z, s7_92);
  const double s7_94 = fnma(K_carrier_left_xy, work.s1_17, s7_93);
  const double s7_95 = fma(work.R_carrier_left_z_z, s7_86, work.R_carrier_left_aux2_z_y*s7_68);
  work.s7_96 = fma(work.R_carrier_left_z_x, s7_94, s7_95);
  const double s7_97 = fma(work.R_carrier_left_y_x, s7_94, work.R_carrier_left_aux2_y_y*s7_68);
  work.s7_98 = fma(work.R_carrier_left_y_z, s7_86, s7_97);
  const double s7_99 = fma(work.R_carrier_left_y_x, s7_89, work.R_carrier_left_aux2_y_y*s7_71);
  work.s7_100 = fma(work.R_carrier_left_y_z, s7_83, s7_99);
  const double s7_101 = fma(work.R_carrier_left_x_x, s7_94, work.R_carrier_left_x_z*s7_86);
  work.s7_102 = fnma(work.s1_17, s7_68, s7_101);
  work.s8_586 = fnma(work.Rz_lower_arm_left_2, work.s7_98, work.s3_23*work.s7_91);
  work.s8_587 = fnma(work.Rz_lower_arm_left_2, work.s7_96, work.s3_24*work.s7_91);
  work.s8_588 = fma(work.s3_20, work.s7_96, work.s3_21*work.s7_98);
  work.s8_589 = work.s8_349 + work.s7_96;
  work.s8_590 = work.s8_354 + work.s7_98;
  work.s8_591 = work.s8_364 + work.s7_91;
  work.s8_592 = work.s8_386 + work.s7_100;
  work.s8_593 = work.s8_390 + work.s7_102;
}

/// Part 4 of compute_accelerations: step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 7: inertias of the bodies and forces on joints,
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_accelerations_4(const State& state, const double* tau,
    AccelerationsWork& __restrict work) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_103 = K_carrier_left_trace - work.s7_102 - work.s7_100;
  const double s7_104 = work.s7_102 + (work.s7_100 + s7_103);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_105 = -h_upper_arm_left_z*R_upper_arm_left_z_y;
  work.s7_106 = fma(h_upper_arm_left_y, R_upper_arm_left_y_y, s7_105);
  const double s7_107 = h_upper_arm_left_y*R_upper_arm_left_z_y;
  work.s7_108 = fnma(-h_upper_arm_left_z, R_upper_arm_left_y_y, s7_107);
  work.s8_594 = fnma(work.s7_106, work.s8_22, work.s6_134*work.s7_108);
  work.s8_595 = fma(work.s7_108, work.s8_22, work.s6_134*work.s7_106);
  const double s7_109 = K_upper_arm_left_zz*R_upper_arm_left_z_y;
  const double s7_110 = fma(-K_upper_arm_left_yz, R_upper_arm_left_y_y, s7_109);
  const double s7_111 = -K_upper_arm_left_yz*R_upper_arm_left_z_y;
  const double s7_112 = fma(K_upper_arm_left_yy, R_upper_arm_left_y_y, s7_111);
  work.s7_113 = fnma(R_upper_arm_left_y_y, s7_110, R_upper_arm_left_z_y*s7_112);
  work.s7_114 = fma(R_upper_arm_left_y_y, s7_112, R_upper_arm_left_z_y*s7_110);
  work.s7_115 = 0.539 - work.s7_114;
  const double s7_116 = work.s7_114 + work.s7_115;
  const double s7_117 = K_upper_arm_left_xx + s7_116 - K_upper_arm_left_xx;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_118 = -K_arb_front_left_xy*R_arb_front_left_x_z;
  work.s7_119 = fma(K_arb_front_left_yz, R_arb_front_left_x_x, s7_118);
  const double s7_120 = K_arb_front_left_yz*R_arb_front_left_x_z;
  work.s7_121 = fnma(-K_arb_front_left_xy, R_arb_front_left_x_x, s7_120);
  const double s7_122 = -h_arb_front_left_x*R_arb_front_left_x_z;
  work.s7_123 = fma(h_arb_front_left_z, R_arb_front_left_x_x, s7_122);
  const double s7_124 = h_arb_front_left_z*R_arb_front_left_x_z;
  work.s7_125 = fnma(-h_arb_front_left_x, R_arb_front_left_x_x, s7_124);
  work.s8_596 = fnma(work.s7_125, work.s8_18, work.zdd_star_arb_front_left*work.s7_123);
  work.s8_597 = fma(work.s7_123, work.s8_18, work.zdd_star_arb_front_left*work.s7_125);
  const double s7_126 = K_arb_front_left_zz*R_arb_front_left_x_z;
  const double s7_127 = fnma(-K_arb_front_left_xz, R_arb_front_left_x_x, s7_126);
  const double s7_128 = K_arb_front_left_xx*R_arb_front_left_x_x;
  const double s7_129 = fnma(-K_arb_front_left_xz, R_arb_front_left_x_z, s7_128);
  work.s7_130 = fnma(R_arb_front_left_x_z, s7_129, R_arb_front_left_x_x*s7_127);
  work.s7_131 = fma(R_arb_front_left_x_x, s7_129, R_arb_front_left_x_z*s7_127);
  work.s7_132 = 0.3477 - work.s7_131;
  work.s7_133 = work.s7_131 + work.s7_132;
  const double s7_134 = K_arb_front_left_yy + work.s7_133 - K_arb_front_left_yy;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s7_135 = -h_lower_arm_right_z*R_lower_arm_right_z_y;
  work.s7_136 = fnma(-h_lower_arm_right_y, R_lower_arm_right_y_y, s7_135);
  const double s7_137 = -h_lower_arm_right_y*R_lower_arm_right_z_y;
  work.s7_138 = fma(-h_lower_arm_right_z, R_lower_arm_right_y_y, s7_137);
  const double s7_139 = K_lower_arm_right_yz*R_lower_arm_right_y_y;
  const double s7_140 = fnma(K_lower_arm_right_zz, R_lower_arm_right_z_y, s7_139);
  const double s7_141 = K_lower_arm_right_yy*R_lower_arm_right_y_y;
  const double s7_142 = fnma(K_lower_arm_right_yz, R_lower_arm_right_z_y, s7_141);
  work.s7_143 = fma(R_lower_arm_right_y_y, s7_140, R_lower_arm_right_z_y*s7_142);
  work.s7_144 = fnma(R_lower_arm_right_z_y, s7_140, R_lower_arm_right_y_y*s7_142);
  work.s7_145 = 1.825625 - work.s7_144;
  const double s7_146 = K_lower_arm_right_xx + (work.s7_144 + work.s7_145);
  work.s7_147 = s7_146 - K_lower_arm_right_xx;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_148 = K_carrier_right_yy*work.R_carrier_right_aux2_y_y;
  const double s7_149 = K_carrier_right_yy*work.s1_37;
  const double s7_150 = fma(-K_carrier_right_yz, work.R_carrier_right_x_z, s7_149);
  const double s7_151 = fma(-K_carrier_right_xy, work.R_carrier_right_x_x, s7_150);
  const double s7_152 = fnma(-K_carrier_right_xy, work.R_carrier_right_y_x, s7_148);
  const double s7_153 = fnma(-K_carrier_right_yz, work.R_carrier_right_y_z, s7_152);
  const double s7_154 = -h_carrier_right_y*work.s1_37;
  const double s7_155 = fma(h_carrier_right_z, work.R_carrier_right_x_z, s7_154);
  const double s7_156 = fnma(-h_carrier_right_x, work.R_carrier_right_x_x, s7_155);
  const double s7_157 = h_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_158 = fnma(-h_carrier_right_x, work.R_carrier_right_z_x, s7_157);
  const double s7_159 = fnma(-h_carrier_right_y, work.R_carrier_right_aux2_z_y, s7_158);
  const double s7_160 = h_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_161 = fnma(-h_carrier_right_x, work.R_carrier_right_y_x, s7_160);
  const double s7_162 = fnma(-h_carrier_right_y, work.R_carrier_right_aux2_y_y, s7_161);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_598 = work.Rz_carrier_right_rx_1*s7_159;
  work.s8_599 = fnma(work.Rz_carrier_right_ry_1, s7_162, s8_598);
  const double s8_600 = work.Rz_carrier_right_rx_2*s7_159;
  const double s8_601 = fnma(work.Rz_carrier_right_ry_2, s7_162, s8_600);
  const double s8_602 = work.Rz_carrier_right_rz_2*s7_162;
  const double s8_603 = fnma(work.Rz_carrier_right_rx_2, s7_156, s8_602);
  const double s8_604 = work.Rz_carrier_right_ry_2*s7_156;
  const double s8_605 = fnma(work.Rz_carrier_right_rz_2, s7_159, s8_604);
  work.s8_606 = s7_162 + work.s8_583;
  work.s8_607 = s7_156 + work.s8_584;
  work.s8_608 = s7_159 + work.s8_585;

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_163 = K_carrier_right_zz*work.R_carrier_right_y_z;
  const double s7_164 = fnma(-K_carrier_right_xz, work.R_carrier_right_y_x, s7_163);
  const double s7_165 = fnma(-K_carrier_right_yz, work.R_carrier_right_aux2_y_y, s7_164);
  const double s7_166 = work.R_carrier_right_aux2_z_y*s7_153;
  const double s7_167 = -K_carrier_right_yz*work.s1_37;
  const double s7_168 = fma(K_carrier_right_zz, work.R_carrier_right_x_z, s7_167);
  const double s7_169 = fnma(-K_carrier_right_xz, work.R_carrier_right_x_x, s7_168);
  const double s7_170 = K_carrier_right_xx*work.R_carrier_right_y_x;
  const double s7_171 = fnma(-K_carrier_right_xz, work.R_carrier_right_y_z, s7_170);
  const double s7_172 = fnma(-K_carrier_right_xy, work.R_carrier_right_aux2_y_y, s7_171);
  const double s7_173 = fma(work.R_carrier_right_z_z, s7_165, s7_166);
  const double s7_174 = fma(work.R_carrier_right_z_x, s7_172, s7_173);
  const double s7_175 = -K_carrier_right_xy*work.s1_37;
  const double s7_176 = fma(K_carrier_right_xx, work.R_carrier_right_x_x, s7_175);
  const double s7_177 = fnma(-K_carrier_right_xz, work.R_carrier_right_x_z, s7_176);
  const double s7_178 = fma(work.R_carrier_right_z_x, s7_177, work.R_carrier_right_z_z*s7_169);
  const double s7_179 = fnma(work.R_carrier_right_aux2_z_y, s7_151, s7_178);
  const double s7_180 = fma(work.R_carrier_right_y_z, s7_169, work.R_carrier_right_y_x*s7_177);
  const double s7_181 = fnma(work.R_carrier_right_aux2_y_y, s7_151, s7_180);
  const double s7_182 = fma(work.R_carrier_right_x_z, s7_169, work.s1_37*s7_151);
  const double s7_183 = fma(work.R_carrier_right_x_x, s7_177, s7_182);
  const double s7_184 = work.R_carrier_right_aux2_y_y*s7_153;
  const double s7_185 = fma(work.R_carrier_right_y_x, s7_172, s7_184);
  const double s7_186 = fma(work.R_carrier_right_y_z, s7_165, s7_185);
  const double s8_609 = s7_179 + work.s8_589;
  const double s8_610 = s7_181 + work.s8_590;
  const double s8_611 = s7_174 + work.s8_591;
  const double s8_612 = s7_186 + work.s8_592;
  const double s8_613 = s7_183 + work.s8_593;
  const double s7_187 = K_carrier_right_trace - s7_183 - s7_186;
  const double s8_614 = s7_187 + (work.s8_382 + s7_103);
  const double s7_188 = s7_186 + (s7_183 + s7_187);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_189 = -h_upper_arm_right_z*R_upper_arm_right_z_y;
  work.s7_190 = fnma(-h_upper_arm_right_y, R_upper_arm_right_y_y, s7_189);
  const double s7_191 = -h_upper_arm_right_y*R_upper_arm_right_z_y;
  work.s7_192 = fma(-h_upper_arm_right_z, R_upper_arm_right_y_y, s7_191);
  work.s8_615 = fnma(work.s6_147, work.s7_190, work.s7_192*work.s8_21);
  work.s8_616 = fma(work.s7_190, work.s8_21, work.s6_147*work.s7_192);
  const double s7_193 = K_upper_arm_right_yz*R_upper_arm_right_y_y;
  const double s7_194 = fnma(K_upper_arm_right_zz, R_upper_arm_right_z_y, s7_193);
  const double s7_195 = K_upper_arm_right_yy*R_upper_arm_right_y_y;
  const double s7_196 = fnma(K_upper_arm_right_yz, R_upper_arm_right_z_y, s7_195);
  work.s7_197 = fma(R_upper_arm_right_y_y, s7_194, R_upper_arm_right_z_y*s7_196);
  work.s7_198 = fnma(R_upper_arm_right_z_y, s7_194, R_upper_arm_right_y_y*s7_196);
  work.s7_199 = 0.539 - work.s7_198;
  const double s7_200 = work.s7_198 + work.s7_199;
  const double s7_201 = K_upper_arm_right_xx + s7_200 - K_upper_arm_right_xx;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_202 = -h_arb_front_right_x*R_arb_front_right_x_z;
  work.s7_203 = fma(h_arb_front_right_z, R_arb_front_right_x_x, s7_202);
  const double s7_204 = h_arb_front_right_z*R_arb_front_right_x_z;
  work.s7_205 = fnma(-h_arb_front_right_x, R_arb_front_right_x_x, s7_204);
  work.s8_617 = fnma(work.s7_205, work.s8_17, work.zdd_star_arb_front_right*work.s7_203);
  work.s8_618 = fma(work.s7_203, work.s8_17, work.zdd_star_arb_front_right*work.s7_205);
  const double s7_206 = K_arb_front_right_xy*R_arb_front_right_x_x;
  work.s7_207 = fnma(-K_arb_front_right_yz, R_arb_front_right_x_z, s7_206);
  const double s7_208 = K_arb_front_right_xy*R_arb_front_right_x_z;
  work.s7_209 = fma(-K_arb_front_right_yz, R_arb_front_right_x_x, s7_208);
  const double s7_210 = K_arb_front_right_zz*R_arb_front_right_x_z;
  const double s7_211 = fnma(-K_arb_front_right_xz, R_arb_front_right_x_x, s7_210);
  const double s7_212 = K_arb_front_right_xx*R_arb_front_right_x_x;
  const double s7_213 = fnma(-K_arb_front_right_xz, R_arb_front_right_x_z, s7_212);
  work.s7_214 = fnma(R_arb_front_right_x_z, s7_213, R_arb_front_right_x_x*s7_211);
  work.s7_215 = fma(R_arb_front_right_x_x, s7_213, R_arb_front_right_x_z*s7_211);
  work.s7_216 = 0.3477 - work.s7_215;
  work.s7_217 = work.s7_215 + work.s7_216;
  const double s7_218 = fnma(work.zdd_star_arb_front_right, work.s7_217,
      tau[Coordinate::arb_front_right]);
  const double s7_219 = fma(work.s8_28, work.s7_207, fma(work.s8_27, work.s7_209, s7_218));
  const double s7_220 = K_arb_front_right_yy + work.s7_217 - K_arb_front_right_yy;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  work.s7_221 = -h_pitman_arm_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s7_222 = -h_pitman_arm_z*R_pitman_arm_x_x;
  work.s7_223 = fnma(work.s6_154, work.s7_221, work.s7_222*work.s8_15);
  work.s7_224 = fma(work.s7_221, work.s8_15, work.s6_154*work.s7_222);
  const double s7_225 = K_pitman_arm_zz*R_pitman_arm_x_z;
  const double s7_226 = K_pitman_arm_xx*R_pitman_arm_x_x;
  work.s7_227 = fnma(R_pitman_arm_x_z, s7_226, R_pitman_arm_x_x*s7_225);
  work.s7_228 = fma(R_pitman_arm_x_x, s7_226, R_pitman_arm_x_z*s7_225);
  work.s7_229 = 0.3504 - work.s7_228;
  const double s7_230 = work.s7_228 + work.s7_229;
  const double s7_231 = K_pitman_arm_yy + s7_230 - K_pitman_arm_yy;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_x_x = work.cosines[16];
  const double R_bell_crank_y_x = work.sines[16];
  work.s7_232 = fnma(-h_bell_crank_x, R_bell_crank_y_x, h_bell_crank_y*R_bell_crank_x_x);
  work.s7_233 = fma(-h_bell_crank_x, R_bell_crank_x_x, h_bell_crank_y*R_bell_crank_y_x);
  const double s8_619 = fnma(work.s7_232, work.s8_44, tau[Coordinate::bell_crank]);
  const double s8_620 = fma(work.s7_233, work.s8_35, s8_619);
  const double s7_234 = -K_bell_crank_xy*R_bell_crank_y_x;
  const double s7_235 = -K_bell_crank_xy*R_bell_crank_x_x;
  const double s7_236 = fma(K_bell_crank_yy, R_bell_crank_y_x, s7_235);
  const double s7_237 = fma(K_bell_crank_xx, R_bell_crank_x_x, s7_234);
  work.s7_238 = fnma(R_bell_crank_x_x, s7_236, R_bell_crank_y_x*s7_237);
  work.s7_239 = fma(R_bell_crank_x_x, s7_237, R_bell_crank_y_x*s7_236);
  const double s7_240 = R_bell_crank_y_x*fms(K_bell_crank_xx, R_bell_crank_y_x, s7_235);
  const double s7_241 = fms(K_bell_crank_yy, R_bell_crank_x_x, s7_234);
  work.s7_242 = fma(R_bell_crank_x_x, s7_241, s7_240);
  work.s7_243 = K_bell_crank_trace - work.s7_239 - work.s7_242;
  const double s7_244 = work.s7_242 + (work.s7_239 + work.s7_243) - work.s7_243;
  // operations: 153 add, 195 multiply

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_621 = 1.0 - work.s3_19;
  work.s8_622 = work.s1_11*work.s3_19;
  const double s8_623 = fma(work.s3_20, work.s7_91, work.s7_80*work.s8_622);
  work.s8_624 = work.s1_13*work.s3_19;
  const double s8_625 = fma(work.s3_21, work.s7_91, work.s7_80*work.s8_624);
  const double s8_626 = work.s1_11*work.Rz_lower_arm_left_2;
  const double s8_627 = work.s1_13*work.Rz_lower_arm_left_2;
  const double s8_628 = fma(work.s3_24, work.s7_98, fma(work.s7_77, s8_626, work.s7_74*s8_627));
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s8_629 = zd_bell_crank*work.s8_19;
  work.s8_630 = zd_bell_crank*work.s8_12;
  work.s8_631 = fnma(work.s7_233, work.s8_629, work.s7_232*work.s8_630);
  work.s8_632 = work.s7_233*work.s8_24;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s8_633 = work.s3_57*s7_231;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s8_634 = zd_pitman_arm*work.s8_19;
  work.s8_635 = zd_pitman_arm*work.s8_23;
  work.s8_636 = fma(work.s7_222, work.s8_635, work.s7_221*work.s8_634);
  const double s8_637 = -p_rear_axle_tx_z*work.s8_28;
  const double s8_638 = fma(-p_pitman_arm_z, work.s8_39, s8_637);
  work.s8_639 = fma(p_pitman_arm_x, work.s8_36, s8_638);
  work.s8_640 = work.s6_154*s7_230;
  // arb_front_right: arb_front_right, revolute, chassis
  work.s8_641 = work.Rz_arb_front_right_1*s7_220;
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.s8_642 = zd_arb_front_right*work.s8_23;
  work.s8_643 = zd_arb_front_right*work.s8_19;
  work.s8_644 = fma(work.s7_205, work.s8_643, work.s7_203*work.s8_642);
  const double s8_645 = fma(-p_arb_rear_right_y, work.s8_27, work.s8_47);
  const double s8_646 = fnma(-p_arb_rear_right_z, work.s8_28, work.s8_41);
  const double s8_647 = fma(work.s7_205, s8_646, fma(work.s7_203, s8_645, s7_219));
  work.s8_648 = work.s8_39 - work.s8_42;
  const double s8_649 = fnma(work.s8_36, work.s7_216 - work.s7_215, s8_647);
  work.s8_650 = fnma(work.s7_214, work.s8_648, s8_649);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s8_651 = work.Rz_arb_front_right_2*s7_220;
  const double s8_652 = work.s3_35*s7_201;
  const double s8_653 = fma(work.s3_33, s8_652, work.Rz_arb_front_right_1*s8_651);
  const double s8_654 = fma(work.s1_31, s8_603, fma(work.s1_33, s8_605, s8_653));
  work.s8_655 = work.s3_33*s7_201;
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  work.s8_656 = zd_upper_arm_right*work.s8_23;
  work.s8_657 = zd_upper_arm_right*work.s8_12;
  work.s8_658 = fnma(work.s7_192, work.s8_656, work.s7_190*work.s8_657);
  work.s8_659 = work.s6_147*s7_200;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_660 = 1.0 - work.s3_34;
  const double s8_661 = fma(work.Rz_carrier_right_ry_1, s7_156, m_carrier_right_2*work.s1_33);
  work.s8_662 = fnma(s7_159, work.s8_660, s8_661);
  const double s8_663 = fma(s7_162, work.s8_660, m_carrier_right_2*work.s1_31);
  work.s8_664 = fnma(work.Rz_carrier_right_rx_1, s7_156, s8_663);
  const double s8_665 = p_upper_arm_right_x*work.s8_42;
  const double s8_666 = fnma(work.s6_122, work.s8_23, fms(work.s6_79, work.s8_12, s8_665));
  const double s8_667 = fma(work.r_carrier_right_aux1_y, work.s8_27, s8_666);
  const double s8_668 = fnma(work.s2_213, work.s8_36, s8_667);
  const double s8_669 = work.zdd_star_carrier_right_ry + work.s4_49;
  const double s8_670 = fms(work.w_carrier_right_x, work.w_carrier_right_y, s8_669);
  const double s8_671 = work.zdd_star_carrier_right_rx + work.s4_50;
  const double s8_672 = fma(work.w_carrier_right_x, work.w_carrier_right_z, s8_671);
  const double s8_673 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s8_674 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s8_675 = s8_673 + s8_674;
  const double s8_676 = fma(s7_159, s8_672, fma(s7_162, s8_670, m_carrier_right_2*s8_668));
  work.f_carrier_right_x = fnma(s7_156, s8_675, s8_676);
  const double s8_677 = p_upper_arm_right_x*work.s8_27;
  const double s8_678 = fnma(work.s2_213, work.s8_28, s8_677 - work.s6_82);
  const double s8_679 = fnma(work.r_carrier_right_aux1_y, work.s8_48, s8_678);
  const double s8_680 = fnma(work.s6_79, work.s8_19, s8_679);
  const double s8_681 = fma(work.w_carrier_right_x, work.w_carrier_right_y, s8_669);
  const double s8_682 = fnma(s7_162, s8_668, fma(s7_156, s8_680, work.s8_570));
  const double s8_683 = work.zdd_star_carrier_right_rz + work.s4_26;
  const double s8_684 = fms(work.w_carrier_right_y, work.w_carrier_right_z, s8_683);
  const double s8_685 = fnma(s7_186, s8_670, fma(s7_179, s8_684, fma(s7_183, s8_681, s8_682)));
  const double s8_686 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_674);
  const double s8_687 = fma(s7_159, s8_684, fma(s7_156, s8_681, m_carrier_right_2*s8_680));
  work.f_carrier_right_y = fnma(s7_162, s8_686, s8_687);
  const double s8_688 = fnma(work.s1_92, work.s3_34, tau[Coordinate::lower_arm_right]);
  const double s8_689 = p_upper_arm_right_x*work.s8_36;
  const double s8_690 = fma(work.s6_122, work.s8_19, work.s6_84 + s8_689);
  const double s8_691 = fma(work.r_carrier_right_aux1_y, work.s8_28, s8_690);
  const double s8_692 = fma(work.s2_213, work.s8_39, s8_691);
  const double s8_693 = fnma(s7_156, s8_692, fma(s7_159, s8_668, work.s8_572));
  const double s8_694 = fma(work.w_carrier_right_y, work.w_carrier_right_z, s8_683);
  const double s8_695 = fnma(s7_159, s8_680, fma(s7_162, s8_692, work.s8_573));
  const double s8_696 = fms(work.w_carrier_right_x, work.w_carrier_right_z, s8_671);
  const double s8_697 = fnma(s7_179, s8_681, fma(s7_181, s8_696, fma(s7_186, s8_694, s8_695)));
  const double s8_698 = fnma(s7_181, s8_694, fma(s7_187, s8_672, fma(s7_174, s8_670, s8_693)));
  const double s8_699 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_673);
  const double s8_700 = fma(s7_156, s8_696, fma(s7_162, s8_694, m_carrier_right_2*s8_692));
  work.f_carrier_right_z = fnma(s7_159, s8_699, s8_700);
  const double s8_701 = fnma(work.s1_33, work.f_carrier_right_y, s8_688);
  work.n_carrier_right_x = fma(s7_174, s8_686 - s8_699, fnma(s7_187, s8_684, s8_697));
  const double s8_702 = fnma(work.s1_31, work.f_carrier_right_z, s8_701);
  const double s8_703 = fnma(work.s8_660, work.n_carrier_right_x, s8_702);
  work.n_carrier_right_y = fma(s7_179, s8_699 - s8_675, fnma(s7_183, s8_696, s8_698));
  work.s8_704 = work.s1_95 - work.n_carrier_right_y;
  const double n_carrier_right_z = fma(s7_181, s8_675 - s8_686, fnma(s7_174, s8_672, s8_685));
  work.s8_705 = work.s1_87 - n_carrier_right_z;
  work.s8_706 = 395.1 + s7_156;
  const double s8_707 = fnma(work.s2_213, work.s8_706, s8_609);
  const double s8_708 = fma(work.r_carrier_right_aux1_y, work.s8_706, s8_610);
  work.s8_709 = fma(109.75, work.r_carrier_right_aux1_y, s7_162);
  work.s8_710 = fnma(109.75, work.s2_213, s7_159);
  const double s8_711 = fma(work.r_carrier_right_aux1_y, work.s8_710, s8_611);
  const double s8_712 = fnma(work.s2_213, work.s8_709, s8_711);
  const double s8_713 = fnma(work.s2_213 + work.s2_213, work.s8_710, s8_614);
  const double s8_714 = s7_188 - s7_186;
  const double s8_715 = work.Rz_carrier_right_rx_2*s8_714;
  const double s8_716 = fnma(work.Rz_carrier_right_rz_2, s7_181, s8_715);
  const double s8_717 = fnma(work.Rz_carrier_right_ry_2, s7_174, s8_716);
  const double s8_718 = work.Rz_carrier_right_rx_1*s8_714;
  const double s8_719 = fnma(work.Rz_carrier_right_ry_1, s7_174, s8_718);
  work.s8_720 = fnma(work.s1_31, s7_156, fnma(s7_181, work.s8_660, s8_719));
  const double s8_721 = s7_188 - s7_187;
  const double s8_722 = work.Rz_carrier_right_ry_2*s8_721;
  const double s8_723 = fnma(work.Rz_carrier_right_rz_2, s7_179, s8_722);
  const double s8_724 = fnma(work.Rz_carrier_right_rx_2, s7_174, s8_723);
  const double s8_725 = fma(work.Rz_carrier_right_ry_1, s8_721, work.s1_33*s7_156);
  const double s8_726 = fnma(s7_179, work.s8_660, s8_725);
  work.s8_727 = fnma(work.Rz_carrier_right_rx_1, s7_174, s8_726);
  const double s8_728 = fma(work.Rz_carrier_right_rx_1, s8_717, s8_654);
  const double s8_729 = s7_188 - s7_183;
  const double s8_730 = work.Rz_carrier_right_rz_2*s8_729;
  const double s8_731 = fnma(work.Rz_carrier_right_ry_2, s7_179, s8_730);
  const double s8_732 = fnma(work.Rz_carrier_right_rx_2, s7_181, s8_731);
  const double s8_733 = fma(work.s8_660, s8_729, fnma(work.s1_33, s7_159, work.s1_31*s7_162));
  const double s8_734 = fnma(work.Rz_carrier_right_ry_1, s7_179, s8_733);
  work.s8_735 = fnma(work.Rz_carrier_right_rx_1, s7_181, s8_734);
  const double s8_736 = fma(work.Rz_carrier_right_ry_1, s8_724, s8_728);
  const double s8_737 = fma(work.s8_660, s8_732, s8_736);
  const double s8_738 = work.r_carrier_right_aux1_y + work.r_carrier_right_aux1_y;
  const double s8_739 = fma(work.s8_709, s8_738, s8_612);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s8_740 = fma(zd_lower_arm_right, work.s8_19, work.s6_81);
  work.s8_741 = zd_lower_arm_right*work.s8_23;
  work.s8_742 = zd_lower_arm_right*work.s8_12;
  work.s8_743 = fnma(work.s7_138, work.s8_741, work.s7_136*work.s8_742);
  const double s8_744 = fnma(-p_lower_arm_right_z, work.s8_28, s8_677);
  const double s8_745 = fma(-p_lower_arm_right_z, work.s8_39, s8_689);
  const double s8_746 = fnma(work.s7_138, fma(-p_lower_arm_right_y, work.s8_48, s8_744), s8_703);
  const double s8_747 = fnma(work.s7_136, fnma(-p_pitman_arm_z, work.s8_28, s8_745), s8_746);
  // arb_front_left: arb_front_left, revolute, chassis
  work.s8_748 = work.Rz_arb_front_left_0*s7_134;
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.s8_749 = zd_arb_front_left*work.s8_23;
  work.s8_750 = zd_arb_front_left*work.s8_19;
  work.s8_751 = fma(work.s7_125, work.s8_750, work.s7_123*work.s8_749);
  const double s8_752 = fnma(work.zdd_star_arb_front_left, work.s7_133,
      tau[Coordinate::arb_front_left]);
  const double s8_753 = fms(-p_arb_rear_right_y, work.s8_27, work.s8_47);
  const double s8_754 = fma(-p_arb_rear_right_z, work.s8_28, work.s8_41);
  const double s8_755 = fma(work.s7_125, s8_754, fnma(work.s7_123, s8_753, s8_752));
  const double s8_756 = fma(work.s8_28, work.s7_121, fnma(work.s8_27, work.s7_119, s8_755));
  const double s8_757 = fnma(work.s8_36, work.s7_132 - work.s7_131, s8_756);
  work.s8_758 = fnma(work.s7_130, work.s8_648, s8_757);
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.s8_759 = work.s3_18*s7_117;
  const double s8_760 = fma(work.s3_18, work.s8_759, work.Rz_arb_front_left_0*work.s8_748);
  const double s8_761 = work.Rz_upper_arm_left_2*s7_117;
  const double s8_762 = work.Rz_arb_front_left_2*s7_134;
  const double s8_763 = fnma(work.s3_18, s8_761, work.Rz_arb_front_left_0*s8_762);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  work.s8_764 = zd_upper_arm_left*work.s8_12;
  work.s8_765 = zd_upper_arm_left*work.s8_23;
  work.s8_766 = fma(work.s7_108, work.s8_765, work.s7_106*work.s8_764);
  const double s8_767 = fnma(-p_upper_arm_right_z, work.s8_28, s8_677);
  const double s8_768 = fma(-p_upper_arm_right_z, work.s8_39, s8_689);
  work.s8_769 = work.s6_134*s7_116;
  const double s8_770 = fms(work.s7_106, s8_637 + s8_768, work.s8_769);
  const double s8_771 = fnma(work.s7_108, fnma(p_pitman_arm_y, work.s8_48, s8_767), s8_770);
  const double s8_772 = work.s8_48 - work.s8_39;
  const double s8_773 = fma(work.s8_28, work.s7_114 - work.s7_115, s8_771);
  work.s8_774 = fma(work.s7_113, s8_772, s8_773);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_775 = fnma(work.s3_20, work.s7_80, m_carrier_left_2*work.s8_624);
  work.s8_776 = fnma(work.s7_74, work.s8_621, s8_775);
  const double s8_777 = fma(work.s3_24, work.s7_80, m_carrier_left_2*s8_626);
  const double s8_778 = fma(work.Rz_lower_arm_left_2, work.s7_77, s8_777);
  const double s8_779 = fma(work.s3_23, work.s7_80, m_carrier_left_2*s8_627);
  const double s8_780 = fma(work.Rz_lower_arm_left_2, work.s7_74, s8_779);
  const double s8_781 = fma(work.s7_77, work.s8_621, work.s3_21*work.s7_80);
  work.s8_782 = fnma(m_carrier_left_2, work.s8_622, s8_781);
  // tie_rod_left
  const double s8_783 = fnma(work.s8_622, work.s8_782, fma(work.s8_624, work.s8_776, s8_760));
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_784 = fma(work.s6_105, work.s8_23, fms(work.s6_66, work.s8_12, s8_665));
  const double s8_785 = fma(work.r_carrier_left_aux1_y, work.s8_27, s8_784);
  const double s8_786 = fma(work.r_carrier_left_aux1_z, work.s8_36, s8_785);
  const double s8_787 = work.zdd_star_carrier_left_ry + work.s4_43;
  const double s8_788 = fms(work.w_carrier_left_x, work.w_carrier_left_y, s8_787);
  const double s8_789 = work.zdd_star_carrier_left_rx + work.s4_44;
  const double s8_790 = fma(work.w_carrier_left_x, work.w_carrier_left_z, s8_789);
  const double s8_791 = fma(work.s7_77, s8_788, m_carrier_left_2*s8_786);
  const double s8_792 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s8_793 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s8_794 = s8_792 + s8_793;
  work.f_carrier_left_x = fnma(work.s7_80, s8_794, fma(work.s7_74, s8_790, s8_791));
  const double s8_795 = fnma(work.s1_13, work.zdd_star_lower_arm_left, s8_677 - work.s6_69);
  const double s8_796 = fma(work.r_carrier_left_aux1_z, work.s8_28, s8_795);
  const double s8_797 = fnma(work.r_carrier_left_aux1_y, work.s8_48, s8_796);
  const double s8_798 = fnma(work.s6_66, work.s8_19, s8_797);
  const double s8_799 = work.zdd_star_lower_arm_left + work.s4_15;
  const double s8_800 = fms(work.w_carrier_left_y, work.w_carrier_left_z, s8_799);
  const double s8_801 = fnma(work.s7_77, s8_786, fma(work.s7_80, s8_798, work.s8_576));
  const double s8_802 = fma(work.w_carrier_left_x, work.w_carrier_left_y, s8_787);
  const double s8_803 = fma(work.s7_74, s8_800, m_carrier_left_2*s8_798);
  const double s8_804 = fma(work.s7_102, s8_802, fma(work.s7_96, s8_800, s8_801));
  const double s8_805 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_793);
  work.f_carrier_left_y = fnma(work.s7_77, s8_805, fma(work.s7_80, s8_802, s8_803));
  const double s8_806 = fma(work.s1_11, work.zdd_star_lower_arm_left, s8_689) - work.s6_71;
  const double s8_807 = fma(work.r_carrier_left_aux1_y, work.s8_28, s8_806);
  const double s8_808 = fnma(work.r_carrier_left_aux1_z, work.s8_39, s8_807);
  const double s8_809 = fnma(work.s6_105, work.s8_19, s8_808);
  const double s8_810 = fnma(work.s7_80, s8_809, fma(work.s7_74, s8_786, work.s8_578));
  const double s8_811 = fma(work.w_carrier_left_y, work.w_carrier_left_z, s8_799);
  const double s8_812 = fnma(work.s7_74, s8_798, fma(work.s7_77, s8_809, work.s8_579));
  const double s8_813 = fma(s7_103, s8_790, fma(work.s7_91, s8_788, s8_810));
  const double s8_814 = fms(work.w_carrier_left_x, work.w_carrier_left_z, s8_789);
  const double s8_815 = fma(work.s7_77, s8_811, m_carrier_left_2*s8_809);
  const double s8_816 = fma(work.s7_98, s8_814, fma(work.s7_100, s8_811, s8_812));
  const double s8_817 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_792);
  work.f_carrier_left_z = fnma(work.s7_74, s8_817, fma(work.s7_80, s8_814, s8_815));
  const double s8_818 = fnma(s8_626, work.f_carrier_left_z, s8_620);
  const double s8_819 = fma(s8_627, work.f_carrier_left_y, s8_818);
  const double s8_820 = fnma(s7_103, s8_800, fnma(work.s7_96, s8_802, s8_816));
  work.n_carrier_left_x = fma(work.s7_91, s8_805 - s8_817, s8_820);
  const double s8_821 = fnma(work.s7_102, s8_814, fnma(work.s7_98, s8_811, s8_813));
  work.n_carrier_left_y = fma(work.s7_96, s8_817 - s8_794, s8_821);
  work.s8_822 = work.n_carrier_left_y - work.s1_79;
  const double s8_823 = fnma(work.s7_91, s8_790, fnma(work.s7_100, s8_788, s8_804));
  const double n_carrier_left_z = fma(work.s7_98, s8_794 - s8_805, s8_823);
  work.s8_824 = n_carrier_left_z - work.s1_71;
  work.s8_825 = n_carrier_right_z + (work.s8_552 + n_carrier_left_z);
  const double s8_826 = work.Rz_arb_front_right_2*work.s7_203;
  const double s8_827 = s8_601 + fma(work.Rz_arb_front_left_2, work.s7_123, work.s8_581);
  const double s8_828 = work.s3_57*work.s7_222;
  work.s8_829 = s8_828 + (s8_826 + s8_827) - work.s7_232;
  const double s8_830 = s7_104 - s7_103;
  const double s8_831 = fnma(work.s7_80, s8_627, fnma(work.s3_23, s8_830, work.s8_587));
  work.s8_832 = fnma(work.s3_20, s8_830, fnma(work.s7_96, work.s8_621, s8_625));
  const double s8_833 = s7_104 - work.s7_100;
  const double s8_834 = fnma(work.s7_80, s8_626, fnma(work.s3_24, s8_833, work.s8_586));
  work.s8_835 = fnma(work.s3_21, s8_833, fnma(work.s7_98, work.s8_621, s8_623));
  work.s8_836 = fma(109.75, work.r_carrier_left_aux1_z, work.s7_74);
  work.s8_837 = fma(109.75, work.r_carrier_left_aux1_y, work.s7_77);
  const double s8_838 = fma(work.r_carrier_left_aux1_y, work.s8_836, s8_712);
  const double s8_839 = fma(work.r_carrier_left_aux1_z, work.s8_837, s8_838);
  work.s8_840 = 395.1 + work.s7_80;
  const double s8_841 = fma(work.r_carrier_left_aux1_z, work.s8_840, s8_707);
  const double s8_842 = fma(work.r_carrier_left_aux1_y, work.s8_840, s8_708);
  const double s8_843 = work.r_carrier_left_aux1_z + work.r_carrier_left_aux1_z;
  const double s8_844 = fma(work.s8_836, s8_843, s8_713);
  const double s8_845 = work.r_carrier_left_aux1_y + work.r_carrier_left_aux1_y;
  const double s8_846 = fma(work.s8_837, s8_845, s8_739);
  const double s8_847 = s7_104 - work.s7_102;
  const double s8_848 = fma(work.s3_23, work.s7_96, s8_628);
  const double s8_849 = fma(work.Rz_lower_arm_left_2, s8_847, s8_848);
  const double s8_850 = fnma(work.s7_77, work.s8_622, fma(work.s8_621, s8_847, work.s8_588));
  work.s8_851 = fnma(work.s7_74, work.s8_624, s8_850);
  const double s8_852 = fnma(work.s3_20, work.s8_832, fma(work.s8_621, work.s8_851, s8_783));
  const double s8_853 = fnma(work.s3_21, work.s8_835, s8_852);
  const double s8_854 = fnma(work.s3_20, s8_831, fma(work.s8_621, s8_849, s8_763));
  const double s8_855 = fnma(work.s8_622, s8_778, fnma(work.s3_21, s8_834, s8_854));
  const double s8_856 = fnma(work.s8_624, s8_780, s8_855);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s8_857 = work.s7_232 + (work.s7_190 + (work.s7_136 + (work.s7_54 + work.s7_106)));
  work.s8_858 = 5.25 + s8_857;
  const double s8_859 = work.Rz_lower_arm_left_2*work.s7_54;
  const double s8_860 = work.s3_57*work.s7_221;
  const double s8_861 = s8_603 + fma(work.Rz_upper_arm_left_2, work.s7_106, s8_778 + s8_859);
  const double s8_862 = work.Rz_arb_front_right_2*work.s7_205;
  const double s8_863 = work.s3_35*work.s7_190;
  const double s8_864 = s8_861 - s8_860 - s8_862 - s8_863;
  work.s8_865 = fnma(work.Rz_arb_front_left_2, work.s7_125, s8_864);
  const double s8_866 = work.s3_35*work.s7_192;
  const double s8_867 = s8_605 - work.s7_233 - s8_866;
  const double s8_868 = work.Rz_lower_arm_left_2*work.s7_56;
  work.s8_869 = fnma(work.Rz_upper_arm_left_2, work.s7_108, s8_867) - s8_780 - s8_868;
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s8_870 = fma(zd_lower_arm_left, work.s8_19, work.s6_68);
  work.s8_871 = fnma(work.s7_56, s8_870, work.zdd_star_lower_arm_left*work.s7_54);
  work.s8_872 = fma(work.s7_54, s8_870, work.zdd_star_lower_arm_left*work.s7_56);
  work.s8_873 = work.s3_19*work.s7_65;
  const double s8_874 = fma(work.s3_19, work.s8_873, s8_853);
  work.s8_875 = zd_lower_arm_left*work.s8_12;
  work.s8_876 = zd_lower_arm_left*work.s8_23;
  work.s8_877 = fma(work.s7_56, work.s8_876, work.s7_54*work.s8_875);
  const double s8_878 = work.Rz_lower_arm_left_2*work.s7_65;
  const double s8_879 = fnma(work.s3_19, s8_878, s8_856);
  work.s8_880 = work.zdd_star_lower_arm_left*work.s7_64;
  const double s8_881 = fma(work.s7_54, fma(-p_pitman_arm_z, work.s8_28, s8_745), work.s8_880);
  const double s8_882 = fnma(work.s7_56, fnma(-p_lower_arm_right_y, work.s8_48, s8_744), s8_881);
  const double s8_883 = fma(work.s8_28, work.s7_62 - work.s7_63, s8_882);
  work.s8_884 = fma(work.s7_61, s8_772, s8_883);
  // arb_link_front_left
  work.s8_885 = 0.3333333333333333*work.s2_197;
  const double s8_886 = fnma(work.s2_190, work.s8_885, s8_839);
  const double s8_887 = fnma(work.s2_197, work.s8_885, s8_846);
  work.s8_888 = 0.3333333333333333*work.s2_184;
  const double s8_889 = fnma(work.s2_190, work.s8_888, s8_841);
  const double s8_890 = fnma(work.s2_197, work.s8_888, s8_842);
  const double s8_891 = fnma(work.s2_184, work.s8_888, s8_613);
  work.s8_892 = 0.3333333333333333*work.s2_190;
  const double s8_893 = fnma(work.s2_190, work.s8_892, s8_844);
  const double s8_894 = fma(work.s2_183, work.s3_23, s8_627);
  const double s8_895 = fma(work.s2_187, work.Rz_lower_arm_left_2, s8_894);
  const double s8_896 = fnma(work.s2_183, work.s3_20, work.s8_624);
  work.s8_897 = fnma(work.s2_187, work.s8_621, s8_896);
  const double s8_898 = fma(work.s2_180, work.Rz_arb_front_left_2, s8_626);
  const double s8_899 = fma(work.s2_183, work.s3_24, s8_898);
  const double s8_900 = fma(work.s2_194, work.Rz_lower_arm_left_2, s8_899);
  const double s8_901 = fma(s8_900, s8_900, fma(work.s3_31, work.s3_31, s8_895*s8_895));
  const double s8_902 = fma(work.s3_52, work.s3_52, fma(work.s3_41, work.s3_41, s8_901));
  const double s8_903 = fma(work.s3_55, work.s3_55, s8_902);
  const double s8_904 = fms(work.s2_180, work.Rz_arb_front_left_0, work.s8_622);
  work.s8_905 = fma(work.s2_194, work.s8_621, fma(work.s2_183, work.s3_21, s8_904));
  const double s8_906 = fma(work.s3_29, work.s3_29, work.s8_897*work.s8_897);
  const double s8_907 = fma(s8_900, work.s8_905, work.s3_31*work.s3_29);
  const double s8_908 = fnma(0.3333333333333333, fma(work.s8_905, work.s8_905, s8_906), s8_874);
  const double s8_909 = fnma(0.3333333333333333, fnma(s8_895, work.s8_897, s8_907), s8_879);
  const double s8_910 = fma(work.s8_36, work.s2_190, fms(work.s8_27, work.s2_197, work.s6_65));
  const double s8_911 = fma(work.s8_23, work.s6_137, fnma(work.s8_42, work.s2_184, s8_910));
  const double s8_912 = fnma(work.s8_12, work.s6_67, s8_911);
  const double s8_913 = fma(work.s2_178, work.zdd_star_arb_front_left, s8_912);
  const double s8_914 = fnma(work.s2_187, work.zdd_star_carrier_left_rx, s8_913);
  const double s8_915 = fma(work.s2_194, work.zdd_star_carrier_left_ry, s8_914);
  work.s8_916 = 0.3333333333333333*s8_915;
  const double s8_917 = fms(work.s1_13, work.zdd_star_lower_arm_left, work.s6_70);
  const double s8_918 = fma(work.s8_28, work.s2_190, fma(work.s8_27, work.s2_184, s8_917));
  const double s8_919 = fma(work.s8_19, work.s6_67, fnma(work.s8_48, work.s2_197, s8_918));
  const double s8_920 = fma(work.s8_23, work.s6_75, s8_919);
  const double s8_921 = fnma(work.s2_183, work.zdd_star_carrier_left_ry, s8_920);
  const double s8_922 = fma(work.s2_187, work.zdd_star_lower_arm_left, s8_921);
  work.s8_923 = 0.3333333333333333*s8_922;
  const double s8_924 = fms(work.s8_28, work.s2_197, work.s6_74);
  const double s8_925 = fnma(work.s1_11, work.zdd_star_lower_arm_left, s8_924);
  const double s8_926 = fnma(work.s8_39, work.s2_190, fma(work.s8_36, work.s2_184, s8_925));
  const double s8_927 = fnma(work.s8_12, work.s6_75, fnma(work.s8_19, work.s6_137, s8_926));
  const double s8_928 = fnma(work.s2_180, work.zdd_star_arb_front_left, s8_927);
  const double s8_929 = fnma(work.s2_194, work.zdd_star_lower_arm_left, s8_928);
  const double s8_930 = fma(work.s2_183, work.zdd_star_carrier_left_rx, s8_929);
  work.s8_931 = 0.3333333333333333*s8_930;
  const double s8_932 = fma(work.s3_31, work.s8_916, fnma(s8_900, work.s8_931, s8_819));
  const double s8_933 = fma(s8_895, work.s8_923, s8_932);
  // arb_link_front_right
  work.s8_934 = 0.3333333333333333*work.s2_208;
  const double s8_935 = fnma(work.s2_214, work.s8_934, s8_889);
  const double s8_936 = fma(work.s2_221, work.s8_934, s8_890);
  const double s8_937 = fnma(work.s2_208, work.s8_934, s8_891);
  work.s8_938 = 0.3333333333333333*work.s2_214;
  const double s8_939 = fnma(work.s2_214, work.s8_938, s8_893);
  work.s8_940 = 0.3333333333333333*work.s2_221;
  const double s8_941 = fma(work.s2_214, work.s8_940, s8_886);
  const double s8_942 = fnma(work.s2_221, work.s8_940, s8_887);
  const double s8_943 = fma(work.s2_207, work.Rz_carrier_right_ry_1, work.s1_33);
  work.s8_944 = fnma(work.s2_211, work.s8_660, s8_943);
  const double s8_945 = fma(work.s2_204, work.Rz_arb_front_right_1, work.s1_31);
  const double s8_946 = fma(work.s2_218, work.s8_660, s8_945);
  work.s8_947 = fnma(work.s2_207, work.Rz_carrier_right_rx_1, s8_946);
  const double s8_948 = fma(work.s3_55, work.s3_49, work.s3_41*work.s8_944);
  const double s8_949 = fma(work.s3_49, work.s3_49, work.s8_944*work.s8_944);
  const double s8_950 = fma(work.s8_947, work.s8_947, s8_949);
  const double s8_951 = fnma(0.3333333333333333, fma(work.s3_52, work.s8_947, s8_948), s8_737);
  const double s8_952 = fma(work.s8_27, work.s2_208, fms(work.s8_48, work.s2_221, work.s6_83));
  const double s8_953 = fma(work.s8_19, work.s6_80, fma(work.s8_28, work.s2_214, s8_952));
  const double s8_954 = fma(work.s8_23, work.s6_88, s8_953);
  const double s8_955 = fnma(work.s2_207, work.zdd_star_carrier_right_ry, s8_954);
  const double s8_956 = fma(work.s2_211, work.zdd_star_carrier_right_rz, s8_955);
  work.s8_957 = 0.3333333333333333*s8_956;
  const double s8_958 = fnma(work.s8_42, work.s2_208, fms(work.s8_36, work.s2_214, work.s6_78));
  const double s8_959 = fma(work.s8_23, work.s6_149, fnma(work.s8_27, work.s2_221, s8_958));
  const double s8_960 = fnma(work.s8_12, work.s6_80, s8_959);
  const double s8_961 = fma(work.s2_202, work.zdd_star_arb_front_right, s8_960);
  const double s8_962 = fnma(work.s2_211, work.zdd_star_carrier_right_rx, s8_961);
  const double s8_963 = fma(work.s2_218, work.zdd_star_carrier_right_ry, s8_962);
  work.s8_964 = 0.3333333333333333*s8_963;
  const double s8_965 = fnma(work.s8_39, work.s2_214, fms(work.s8_36, work.s2_208, work.s6_87));
  const double s8_966 = fnma(work.s8_19, work.s6_149, fnma(work.s8_28, work.s2_221, s8_965));
  const double s8_967 = fnma(work.s8_12, work.s6_88, s8_966);
  const double s8_968 = fnma(work.s2_204, work.zdd_star_arb_front_right, s8_967);
  const double s8_969 = fnma(work.s2_218, work.zdd_star_carrier_right_rz, s8_968);
  const double s8_970 = fma(work.s2_207, work.zdd_star_carrier_right_rx, s8_969);
  work.s8_971 = 0.3333333333333333*s8_970;
  const double s8_972 = fnma(work.s3_52, work.s8_971, fnma(work.s3_41, work.s8_957, s8_933));
  const double s8_973 = fma(work.s3_55, work.s8_964, s8_972);
  const double s8_974 = fnma(work.s8_947, work.s8_971, fnma(work.s8_944, work.s8_957, s8_747));
  const double s8_975 = fma(work.s3_49, work.s8_964, s8_974);
  // drag_link
  const double s8_976 = work.s2_225*work.s3_57;
  const double s8_977 = 1.5*work.s2_231;
  const double s8_978 = fnma(work.s2_229, s8_977, s8_941);
  const double s8_979 = fnma(work.s2_231, s8_977, s8_942);
  const double s8_980 = 1.5*work.s2_229;
  const double s8_981 = fnma(work.s2_229, s8_980, s8_939);
  const double s8_982 = 1.5*work.s2_227;
  const double s8_983 = fnma(work.s2_229, s8_982, s8_935);
  const double s8_984 = fnma(work.s2_231, s8_982, s8_936);
  const double s8_985 = fnma(work.s2_227, s8_982, s8_937);
  const double s8_986 = fma(work.s2_228, work.s3_57, work.s2_230);
  const double s8_987 = fma(s8_986, s8_986, fma(s8_976, s8_976, work.s2_226*work.s2_226));
  const double s8_988 = fnma(work.s8_19, work.s6_89, fma(work.s8_23, work.s6_94, work.s6_96));
  const double s8_989 = fma(work.s8_28, work.s2_229, fma(work.s8_27, work.s2_227, s8_988));
  work.s8_990 = 1.5*fnma(work.s8_48, work.s2_231, s8_989);
  const double s8_991 = fma(work.s8_36, work.s2_229, fma(work.s8_27, work.s2_231, work.s6_91));
  const double s8_992 = fma(work.s2_228, work.s6_154, fnma(work.s8_42, work.s2_227, s8_991));
  work.s8_993 = 1.5*fnma(work.s8_23, work.s6_90, fma(work.s8_12, work.s6_89, s8_992));
  const double s8_994 = fma(work.s8_36, work.s2_227, fma(work.s8_28, work.s2_231, work.s6_97));
  const double s8_995 = fnma(work.s2_225, work.s6_154, fnma(work.s8_39, work.s2_229, s8_994));
  work.s8_996 = 1.5*fnma(work.s8_12, work.s6_94, fma(work.s8_19, work.s6_90, s8_995));
  const double s8_997 = fma(s8_986, work.s8_993, fnma(s8_976, work.s8_996, s8_973));
  const double s8_998 = fma(work.s2_226, work.s8_990, s8_997);
  // tie_rod_left
  work.s8_999 = 1.1666666666666667*work.s2_241;
  const double s8_1000 = fma(work.s2_235, work.s8_999, s8_978);
  const double s8_1001 = fnma(work.s2_241, work.s8_999, s8_979);
  work.s8_1002 = 1.1666666666666667*work.s2_249;
  const double s8_1003 = fnma(work.s2_235, work.s8_1002, s8_983);
  const double s8_1004 = fma(work.s2_241, work.s8_1002, s8_984);
  const double s8_1005 = fnma(work.s2_249, work.s8_1002, s8_985);
  const double s8_1006 = fnma(work.s2_234, work.s3_24, fma(work.s2_237, work.s3_23, work.s2_240));
  const double s8_1007 = fma(work.s2_244, work.s3_24, s8_626);
  const double s8_1008 = fma(work.s2_237, work.Rz_lower_arm_left_2, s8_1007);
  const double s8_1009 = fnma(work.s2_244, work.s3_20, work.s8_624);
  work.s8_1010 = fnma(work.s2_234, work.s8_621, s8_1009);
  work.s8_1011 = fma(work.s2_237, work.s8_621, fms(work.s2_244, work.s3_21, work.s8_622));
  const double s8_1012 = fma(work.s3_22, work.s3_22, work.s8_1010*work.s8_1010);
  const double s8_1013 = fma(work.s8_1011, work.s8_1011, s8_1012);
  work.s8_1014 = fnma(1.1666666666666667, s8_1013, s8_908);
  work.s8_1015 = 1.1666666666666667*work.s2_235;
  const double s8_1016 = fnma(work.s2_235, work.s8_1015, s8_981);
  const double s8_1017 = fma(work.s2_244, work.s3_23, s8_627 - work.s2_248);
  const double s8_1018 = fma(work.s2_234, work.Rz_lower_arm_left_2, s8_1017);
  const double s8_1019 = fma(s8_1008, work.s8_1011, work.s3_22*s8_1006);
  work.s8_1020 = fnma(1.1666666666666667, fnma(work.s8_1010, s8_1018, s8_1019), s8_909);
  const double s8_1021 = fma(s8_1018, s8_1018, fma(s8_1008, s8_1008, s8_1006*s8_1006));
  const double s8_1022 = fnma(work.s8_36, work.s2_235, fma(work.s8_27, work.s2_241, work.s6_101));
  const double s8_1023 = fma(work.s8_23, work.s6_106, fma(work.s8_42, work.s2_249, s8_1022));
  const double s8_1024 = fnma(work.s8_12, work.s6_103, s8_1023);
  const double s8_1025 = fnma(work.s2_234, work.zdd_star_carrier_left_rx, s8_1024);
  const double s8_1026 = fma(work.s2_237, work.zdd_star_carrier_left_ry, s8_1025);
  work.s8_1027 = 1.1666666666666667*s8_1026;
  const double s8_1028 = fms(work.s8_28, work.s2_241, work.s6_108);
  const double s8_1029 = fnma(work.s1_11, work.zdd_star_lower_arm_left, s8_1028);
  const double s8_1030 = fma(work.s8_39, work.s2_235, fnma(work.s8_36, work.s2_249, s8_1029));
  const double s8_1031 = fnma(work.s8_19, work.s6_106, fma(work.s8_12, work.s6_104, s8_1030));
  const double s8_1032 = fnma(work.s2_237, work.zdd_star_lower_arm_left, s8_1031);
  const double s8_1033 = fma(work.s2_244, work.zdd_star_carrier_left_rx, s8_1032);
  work.s8_1034 = 1.1666666666666667*s8_1033;
  const double s8_1035 = fms(work.s1_13, work.zdd_star_lower_arm_left, work.s6_111);
  const double s8_1036 = fnma(work.s8_28, work.s2_235, fnma(work.s8_27, work.s2_249, s8_1035));
  const double s8_1037 = fma(work.s8_19, work.s6_103, fnma(work.s8_48, work.s2_241, s8_1036));
  const double s8_1038 = fnma(work.s8_23, work.s6_104, s8_1037);
  const double s8_1039 = fnma(work.s2_244, work.zdd_star_carrier_left_ry, s8_1038);
  const double s8_1040 = fma(work.s2_234, work.zdd_star_lower_arm_left, s8_1039);
  work.s8_1041 = 1.1666666666666667*s8_1040;
  const double s8_1042 = fnma(s8_1008, work.s8_1034, fnma(s8_1006, work.s8_1027, s8_998));
  const double s8_1043 = fma(s8_1018, work.s8_1041, s8_1042);
  // tie_rod_right
  const double s8_1044 = fnma(work.s2_265, work.Rz_carrier_right_ry_2, work.s2_263);
  const double s8_1045 = fma(work.s2_256, work.Rz_carrier_right_rz_2, s8_1044);
  const double s8_1046 = fnma(work.s2_256, work.Rz_carrier_right_rx_2, work.s2_254);
  const double s8_1047 = fma(work.s2_259, work.Rz_carrier_right_ry_2, s8_1046);
  const double s8_1048 = fma(work.s3_45, work.s3_45, fma(s8_1045, s8_1045, s8_1021));
  const double s8_1049 = s8_849 + s8_878;
  const double s8_1050 = fma(work.Rz_arb_front_right_2, s8_651, fma(work.s3_57, s8_633, s7_244));
  const double s8_1051 = fma(work.s3_35, s8_652, s8_1050);
  const double s8_1052 = fma(work.Rz_carrier_right_rx_2, s8_717, s8_1051);
  const double s8_1053 = fma(work.Rz_carrier_right_rz_2, s8_732, s8_1052);
  const double s8_1054 = fma(work.Rz_carrier_right_ry_2, s8_724, s8_1053);
  const double s8_1055 = fma(work.Rz_arb_front_left_2, s8_762, s8_1054);
  const double s8_1056 = fma(s8_626, s8_778, fma(work.Rz_upper_arm_left_2, s8_761, s8_1055));
  const double s8_1057 = fnma(work.s3_23, s8_831, fma(s8_627, s8_780, s8_1056));
  const double s8_1058 = fnma(1.5, s8_987, fnma(work.s3_24, s8_834, s8_1057));
  const double s8_1059 = fnma(0.3333333333333333, s8_903, s8_1058);
  const double s8_1060 = fma(work.Rz_lower_arm_left_2, s8_1049, s8_1059);
  work.pivot_bell_crank = fnma(1.1666666666666667, fma(s8_1047, s8_1047, s8_1048), s8_1060);
  work.s8_1061 = 1.1666666666666667*work.s2_268;
  work.s8_1062 = fma(work.s2_257, work.s8_1061, s8_1003);
  work.s8_1063 = fma(work.s2_261, work.s8_1061, s8_1004);
  work.s8_1064 = fnma(work.s2_268, work.s8_1061, s8_1005);
  work.s8_1065 = 1.1666666666666667*work.s2_261;
  work.s8_1066 = fnma(work.s2_257, work.s8_1065, s8_1000);
  work.s8_1067 = fnma(work.s2_261, work.s8_1065, s8_1001);
  work.s8_1068 = 1.1666666666666667*work.s2_257;
  work.s8_1069 = fnma(work.s2_257, work.s8_1068, s8_1016);
  const double s8_1070 = fma(work.s2_265, work.Rz_carrier_right_ry_1, work.s1_33);
  work.s8_1071 = fnma(work.s2_256, work.s8_660, s8_1070);
  const double s8_1072 = fma(work.s2_259, work.s8_660, work.s1_31);
  work.s8_1073 = fnma(work.s2_265, work.Rz_carrier_right_rx_1, s8_1072);
  const double s8_1074 = fnma(s8_1047, work.s3_39, work.s3_45*work.s8_1073);
  work.s8_1075 = fnma(1.1666666666666667, fnma(s8_1045, work.s8_1071, s8_1074), s8_951);
  const double s8_1076 = fma(work.s3_39, work.s3_39, work.s8_1071*work.s8_1071);
  const double s8_1077 = fnma(work.Rz_upper_arm_left_2, work.s7_106, s8_863 - s8_603) - s8_778;
  const double s8_1078 = fma(-p_bell_crank_z, work.s7_232, s8_651 + (s8_717 + (s8_762 + s8_834)));
  const double s8_1079 = fma(p_pitman_arm_x, s8_860, s8_1078 - s8_633);
  const double s8_1080 = fnma(work.s2_213, s8_601, fnma(-p_pitman_arm_z, s8_828, s8_1079));
  const double s8_1081 = fma(work.r_carrier_left_aux1_z, work.s8_581, s8_1080);
  const double s8_1082 = fnma(work.s8_888, s8_900, fnma(work.s8_892, work.s3_31, s8_1081));
  const double s8_1083 = fnma(work.s8_934, work.s3_52, fnma(work.s8_938, work.s3_55, s8_1082));
  const double s8_1084 = fnma(s8_976, s8_982, fnma(s8_980, s8_986, s8_1083));
  const double s8_1085 = fma(work.s8_1002, s8_1008, fnma(s8_1006, work.s8_1015, s8_1084));
  const double s8_1086 = fnma(work.s3_45, work.s8_1061, fma(s8_1047, work.s8_1068, s8_1085));
  const double s8_1087 = fma(p_lower_arm_left_x, s8_1077 - s8_859, s8_1086);
  const double s8_1088 = fma(work.Rz_arb_front_left_2, work.s7_123, s8_826);
  const double s8_1089 = fma(work.Rz_arb_front_left_2, work.s7_125, s8_862);
  const double s8_1090 = fnma(-p_rear_axle_tx_z, s8_1088, s8_1087);
  work.s8_1091 = fma(p_arb_front_left_x, s8_1089, s8_1090);
  const double s8_1092 = s8_732 + (s8_761 + s8_1049) - s8_652;
  const double s8_1093 = fnma(work.Rz_arb_front_right_2, work.s7_207, s8_1092);
  const double s8_1094 = fma(work.s2_213, s8_605, fnma(-p_bell_crank_z, work.s7_233, s8_1093));
  const double s8_1095 = fma(work.r_carrier_right_aux1_y, s8_603, s8_1094);
  const double s8_1096 = fnma(work.Rz_arb_front_left_2, work.s7_121, s8_1095);
  const double s8_1097 = fma(work.r_carrier_left_aux1_z, s8_780, s8_1096);
  const double s8_1098 = fma(work.r_carrier_left_aux1_y, s8_778, s8_1097);
  const double s8_1099 = fma(p_lower_arm_left_y, s8_859, s8_1098);
  const double s8_1100 = fma(work.s8_892, s8_895, fnma(-p_lower_arm_left_z, s8_868, s8_1099));
  const double s8_1101 = fnma(work.s8_940, work.s3_52, fma(work.s8_885, s8_900, s8_1100));
  const double s8_1102 = fma(work.s2_226, s8_980, fnma(work.s8_938, work.s3_41, s8_1101));
  const double s8_1103 = fma(work.s8_999, s8_1008, fma(s8_976, s8_977, s8_1102));
  const double s8_1104 = fnma(work.s3_45, work.s8_1065, fnma(work.s8_1015, s8_1018, s8_1103));
  const double s8_1105 = fma(work.Rz_upper_arm_left_2, work.s7_106, s8_863) - s8_860;
  const double s8_1106 = fma(-p_rear_axle_tx_z, s8_1105, fnma(s8_1045, work.s8_1068, s8_1104));
  const double s8_1107 = fnma(work.Rz_arb_front_left_2, work.s7_125, s8_862);
  const double s8_1108 = fma(work.Rz_upper_arm_left_2, work.s7_108, s8_866);
  const double s8_1109 = fma(p_carrier_left_rz_y, s8_1107, s8_1106);
  work.s8_1110 = fnma(-p_upper_arm_right_z, s8_1108, s8_1109);
  const double s8_1111 = fnma(work.Rz_upper_arm_left_2, work.s7_108, s8_605 - s8_866) - s8_780;
  const double s8_1112 = fnma(p_bell_crank_x, work.s7_233, s8_724 + (s7_244 + s8_831));
  const double s8_1113 = fnma(p_pitman_arm_y, s8_828, s8_1112);
  const double s8_1114 = fma(work.Rz_arb_front_right_2, work.s7_209, s8_1113);
  const double s8_1115 = fnma(work.r_carrier_right_aux1_y, s8_601, s8_1114);
  const double s8_1116 = fnma(work.Rz_arb_front_left_2, work.s7_119, s8_1115);
  const double s8_1117 = fnma(work.r_carrier_left_aux1_y, work.s8_581, s8_1116);
  const double s8_1118 = fnma(work.s8_888, s8_895, fma(work.s8_885, work.s3_31, s8_1117));
  const double s8_1119 = fnma(work.s8_940, work.s3_55, fma(work.s8_934, work.s3_41, s8_1118));
  const double s8_1120 = fnma(work.s2_226, s8_982, fma(s8_977, s8_986, s8_1119));
  const double s8_1121 = fnma(work.s8_999, s8_1006, fma(work.s8_1002, s8_1018, s8_1120));
  const double s8_1122 = fnma(s8_1047, work.s8_1065, fnma(s8_1045, work.s8_1061, s8_1121));
  const double s8_1123 = fnma(work.Rz_arb_front_left_2, work.s7_123, s8_826);
  const double s8_1124 = fma(p_lower_arm_left_x, s8_1111 - s8_868, s8_1122);
  work.s8_1125 = fma(p_carrier_left_rz_y, s8_1123, s8_1124);
  const double s8_1126 = fma(work.s8_36, work.s2_257, fma(work.s8_27, work.s2_261, work.s6_115));
  const double s8_1127 = fma(work.s8_12, work.s6_121, fma(work.s8_42, work.s2_268, s8_1126));
  const double s8_1128 = fma(work.s8_23, work.s6_123, s8_1127);
  const double s8_1129 = fma(work.s2_256, work.zdd_star_carrier_right_rx, s8_1128);
  const double s8_1130 = fma(work.s8_27, work.s2_268, fma(work.s8_48, work.s2_261, work.s6_119));
  const double s8_1131 = fma(work.s8_19, work.s6_121, fnma(work.s8_28, work.s2_257, s8_1130));
  const double s8_1132 = fma(work.s8_23, work.s6_120, s8_1131);
  const double s8_1133 = fnma(work.s2_265, work.zdd_star_carrier_right_ry, s8_1132);
  const double s8_1134 = fma(work.s2_256, work.zdd_star_carrier_right_rz, s8_1133);
  work.s8_1135 = 1.1666666666666667*s8_1134;
  const double s8_1136 = fma(work.s8_39, work.s2_257, fms(work.s8_36, work.s2_268, work.s6_116));
  const double s8_1137 = fma(work.s8_19, work.s6_123, fnma(work.s8_28, work.s2_261, s8_1136));
  const double s8_1138 = fnma(work.s8_12, work.s6_120, s8_1137);
  const double s8_1139 = fnma(work.s2_259, work.zdd_star_carrier_right_rz, s8_1138);
  const double s8_1140 = fma(work.s2_265, work.zdd_star_carrier_right_rx, s8_1139);
  work.s8_1141 = 1.1666666666666667*s8_1140;
  const double s8_1142 = fnma(work.s8_1071, work.s8_1135, s8_975);
  const double s8_1143 = fma(work.Rz_arb_front_right_1, work.s8_641, work.s7_147);
  const double s8_1144 = fma(work.s1_33, work.s8_662, fma(work.s3_33, work.s8_655, s8_1143));
  const double s8_1145 = fma(work.s1_31, work.s8_664, s8_1144);
  const double s8_1146 = fma(work.Rz_carrier_right_rx_1, work.s8_720, s8_1145);
  const double s8_1147 = fma(work.Rz_carrier_right_ry_1, work.s8_727, s8_1146);
  const double s8_1148 = fnma(0.3333333333333333, s8_950, fma(work.s8_660, work.s8_735, s8_1147));
  const double s8_1149 = fma(work.s8_1073, work.s8_1073, s8_1076);
  work.s8_1150 = fnma(1.1666666666666667, s8_1149, s8_1148);
  const double s8_1151 = fnma(work.s2_259, work.zdd_star_carrier_right_ry, s8_1129);
  work.s8_1152 = 1.1666666666666667*s8_1151;
  const double s8_1153 = fnma(s8_1047, work.s8_1152, fnma(work.s3_45, work.s8_1141, s8_1043));
  work.s8_1154 = fma(work.s3_39, work.s8_1152, fnma(work.s8_1073, work.s8_1141, s8_1142));
  const double s8_1155 = tau[Coordinate::lower_arm_left] - work.n_carrier_left_x - work.s8_884;
  const double s8_1156 = fma(s8_1045, work.s8_1135, s8_1153);
  const double s8_1157 = fma(work.Rz_lower_arm_left_2, s8_1155, s8_1156);
  const double s8_1158 = fma(work.s8_27, work.s7_242 - work.s7_239, s8_1157);
  const double s8_1159 = tau[Coordinate::upper_arm_left] - work.s8_774;
  const double s8_1160 = fma(work.Rz_upper_arm_left_2, s8_1159, s8_1158);
  const double s8_1161 = fma(work.s3_24, work.s8_822, fma(work.s3_23, work.s8_824, s8_1160));
  const double s8_1162 = fms(work.s7_192, fma(p_pitman_arm_y, work.s8_48, s8_767), work.s8_659);
  const double s8_1163 = s8_1162 - tau[Coordinate::upper_arm_right];
  const double s8_1164 = fma(work.s7_190, s8_768 - s8_637, s8_1163);
  const double s8_1165 = fma(work.s8_28, work.s7_198 - work.s7_199, s8_1164);
  work.s8_1166 = fma(work.s7_197, s8_772, s8_1165);
  const double s8_1167 = fma(work.Rz_arb_front_left_2, work.s8_758, s8_1161);
  const double s8_1168 = fma(work.s3_35, work.s8_1166, s8_1167);
  const double s8_1169 = work.s1_92 - work.n_carrier_right_x;
  work.s8_1170 = fma(work.Rz_carrier_right_rz_2, s8_1169, s8_1168);
}

/// Part 5 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63); step 9:
/// accelerations from the root to the leaves (63), (62).
[[gnu::noinline]] void compute_accelerations_5(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // tie_rod_right
  const double s8_1171 = fma(work.Rz_carrier_right_ry_2, work.s8_705, work.s8_1170);
  const double s8_1172 = fma(work.Rz_carrier_right_rx_2, work.s8_704, s8_1171);
  const double s8_1173 = fms(work.s7_221, work.s8_639, work.s8_640) - tau[Coordinate::pitman_arm];
  const double s8_1174 = fnma(work.s7_222, work.s8_46, s8_1173);
  const double s8_1175 = fma(work.s8_36, work.s7_229 - work.s7_228, s8_1174);
  const double s8_1176 = fma(work.Rz_arb_front_right_2, work.s8_650, s8_1172);
  const double s8_1177 = work.s8_48 - work.s8_42;
  const double s8_1178 = fma(work.s3_57, fma(work.s7_227, work.s8_648, s8_1175), s8_1176);
  const double s8_1179 = fma(work.s7_238, s8_1177, s8_1178);
  const double s8_1180 = 1.0/work.pivot_bell_crank;
  const double s8_1181 = work.s8_1075*s8_1180;
  const double s8_1182 = work.s8_1020*s8_1180;
  const double s8_1183 = work.s8_1020*s8_1181;
  const double pivot_lower_arm_right = fnma(work.s8_1075, s8_1181, work.s8_1150);
  const double s8_1184 = 1.0/pivot_lower_arm_right;
  const double s8_1185 = s8_1183*s8_1184;
  const double pivot_carrier_left_rz = fnma(s8_1183, s8_1185, fnma(work.s8_1020, s8_1182,
      work.s8_1014));
  const double s8_1186 = work.s8_57 + (work.s7_125 + work.s7_205) - work.s7_233 - work.s7_221;
  const double s8_1187 = 471.925 + s8_1186;
  const double s8_1188 = 2.1 + work.s7_192;
  const double s8_1189 = work.s7_108 - 2.1;
  const double s8_1190 = work.s7_56 - 7.75;
  const double s8_1191 = 7.75 + work.s7_138;
  const double s8_1192 = 23.1 - work.s7_221;
  const double s8_1193 = work.s7_227 + (work.s8_71 + (work.s7_130 + work.s7_214)) - 90.9075;
  const double s8_1194 = 2.1 + work.s7_222;
  const double s8_1195 = 33.31250000000001 - work.s7_233;
  const double s8_1196 = fnma(p_pitman_arm_x, s8_1194, fnma(-p_pitman_arm_z, s8_1192, s8_1193));
  const double s8_1197 = fnma(-p_bell_crank_z, s8_1195, s8_1196);
  const double s8_1198 = 17.775 + work.s7_205;
  const double s8_1199 = 17.775 + work.s7_125;
  const double s8_1200 = s8_1198 + s8_1199;
  const double s8_1201 = fma(p_lower_arm_left_x, s8_1189 + s8_1190 - s8_1188 - s8_1191, s8_1197);
  const double s8_1202 = work.s7_203 - 2.25;
  const double s8_1203 = work.s7_123 - 2.25;
  const double s8_1204 = fnma(-p_rear_axle_tx_z, s8_1200, s8_1201);
  const double s8_1205 = fma(p_arb_front_left_x, s8_1202 + s8_1203, s8_1204);
  const double s8_1206 = work.s7_190 - 3.75;
  const double s8_1207 = 3.75 + work.s7_106;
  const double s8_1208 = 5.0 + work.s7_54;
  const double s8_1209 = work.s7_136 - 5.0;
  const double s8_1210 = 11.55 + (work.s7_238 + (work.s8_73 + (work.s7_121 + work.s7_207)));
  const double s8_1211 = fma(p_pitman_arm_y, s8_1192, fma(p_bell_crank_x, work.s7_232, s8_1210));
  const double s8_1212 = s8_1209 + (s8_1206 + (s8_1207 + s8_1208));
  const double s8_1213 = fma(p_lower_arm_left_x, s8_1212, s8_1211);
  const double s8_1214 = fma(p_carrier_left_rz_y, s8_1199 - s8_1198, s8_1213);
  const double s8_1215 = work.s7_197 + (work.s7_143 + (work.s7_119 + (work.s7_61 + work.s7_113)));
  const double s8_1216 = fnma(-p_bell_crank_z, work.s7_232, work.s8_74 + s8_1215 - work.s7_209);
  const double s8_1217 = fma(-p_rear_axle_tx_z, s8_1188 + s8_1189 - s8_1194, s8_1216 - 1.05);
  const double s8_1218 = fma(p_lower_arm_left_y, s8_1191 + s8_1190, s8_1217);
  const double s8_1219 = fma(p_carrier_left_rz_y, s8_1203 - s8_1202, s8_1218);
  const double s8_1220 = fnma(-p_lower_arm_left_z, s8_1209 + s8_1208, s8_1219);
  const double s8_1221 = fnma(-p_upper_arm_right_z, s8_1206 + s8_1207, s8_1220);
  const double s8_1222 = work.r_carrier_left_aux1_y + work.r_carrier_right_aux1_y;
  const double s8_1223 = fma(m_carrier_right_2, s8_1222, work.s8_606);
  const double s8_1224 = 1580.4 + work.s8_607;
  const double s8_1225 = work.r_carrier_left_aux1_z - work.s2_213;
  const double s8_1226 = fma(m_carrier_right_2, s8_1225, work.s8_608);
  const double s8_1227 = fma(p_lower_arm_left_x, work.s8_710 + work.s8_836, work.s8_1062);
  const double s8_1228 = fma(p_lower_arm_left_x, work.s8_709 + work.s8_837, work.s8_1063);
  const double s8_1229 = work.s7_203 + (work.s7_123 + (work.s7_56 + work.s7_108)) - work.s7_222;
  const double s8_1230 = s8_1229 - work.s7_192 - work.s7_138 - work.s8_59 - 64.9;
  result.inertia[8] = fnma(1e-12, work.pivot_bell_crank, work.pivot_bell_crank);
  const double s8_1231 = work.s7_199 + (work.s7_145 + (work.s7_132 + (work.s7_63 + work.s7_115)));
  const double s8_1232 = work.s7_243 + (work.s8_75 + (work.s7_229 + (work.s7_216 + s8_1231)));
  const double s8_1233 = fma(0.8, s8_1194, 7.380000000000001 + (s8_1232 - s8_1202 - s8_1203));
  const double s8_1234 = fma(1.24, s8_1191 - s8_1190, fma(0.56, s8_1188 - s8_1189, s8_1233));
  const double s8_1235 = work.s7_198 + (work.s7_144 + (work.s7_114 + (work.s7_62 + s8_1207)));
  const double s8_1236 = fma(0.8, s8_1208 - s8_1209, 12.8518 + (work.s7_242 + s8_1235 - s8_1206));
  const double s8_1237 = work.s7_239 + (work.s8_76 + (work.s7_228 + (work.s7_131 + work.s7_215)));
  const double s8_1238 = fma(8.8, s8_1192, fma(6.5, s8_1195, 1037.4 + s8_1237));
  const double s8_1239 = fma(7.9, s8_1200, s8_1238);
  const double s8_1240 = fma(7.2, work.s8_706 + work.s8_840, work.s8_1064);
  result.inertia[7] = fnma(1e-12, work.s8_1150, pivot_lower_arm_right);
  const double s8_1241 = work.Rz_arb_front_right_1*work.s7_203;
  const double s8_1242 = fnma(work.s8_829, s8_1181, s8_1241 + work.s8_599);
  const double s8_1243 = work.s3_33*work.s7_192;
  const double s8_1244 = work.s7_138 + work.s8_662 - s8_1243;
  const double s8_1245 = work.Rz_arb_front_right_1*work.s7_205;
  const double s8_1246 = work.s3_33*work.s7_190;
  const double s8_1247 = work.s7_136 + work.s8_664 - s8_1245 - s8_1246;
  const double s8_1248 = fnma(work.s8_865, s8_1181, s8_1247);
  const double s8_1249 = fma(work.Rz_arb_front_right_1, work.s7_209, work.s8_727);
  const double s8_1250 = fma(-p_arb_front_right_y, s8_1241, s8_1249);
  const double s8_1251 = fnma(work.r_carrier_right_aux1_y, work.s8_599, s8_1250);
  const double s8_1252 = fnma(work.s8_940, work.s3_49, fma(work.s8_934, work.s8_944, s8_1251));
  const double s8_1253 = fma(work.s8_1061, work.s8_1071, fma(work.s8_1065, work.s3_39, s8_1252));
  const double s8_1254 = fma(p_lower_arm_left_x, s8_1244, fnma(work.s8_1125, s8_1181, s8_1253));
  const double s8_1255 = work.s8_735 + work.s7_147 - work.s8_655;
  const double s8_1256 = fma(-p_arb_front_right_y, s8_1245, s8_1255);
  const double s8_1257 = fnma(work.Rz_arb_front_right_1, work.s7_207, s8_1256);
  const double s8_1258 = fma(-p_upper_arm_right_y, s8_1246, s8_1257);
  const double s8_1259 = fnma(-p_upper_arm_right_z, s8_1243, s8_1258);
  const double s8_1260 = fma(work.s2_213, work.s8_662, s8_1259);
  const double s8_1261 = fma(work.r_carrier_right_aux1_y, work.s8_664, s8_1260);
  const double s8_1262 = fma(-p_lower_arm_right_z, work.s7_138, s8_1261);
  const double s8_1263 = fnma(-p_lower_arm_right_y, work.s7_136, s8_1262);
  const double s8_1264 = fnma(work.s8_938, work.s8_944, fnma(work.s8_940, work.s8_947, s8_1263));
  const double s8_1265 = fma(work.s8_1068, work.s8_1071, s8_1264);
  const double s8_1266 = fnma(work.s8_1110, s8_1181, fnma(work.s8_1065, work.s8_1073, s8_1265));
  const double s8_1267 = fma(p_arb_front_right_x, s8_1245, work.s8_641 + work.s8_720);
  const double s8_1268 = fnma(-p_arb_front_right_z, s8_1241, s8_1267);
  const double s8_1269 = fnma(work.s8_938, work.s3_49, fnma(work.s2_213, work.s8_599, s8_1268));
  const double s8_1270 = fnma(work.s3_39, work.s8_1068, fnma(work.s8_934, work.s8_947, s8_1269));
  const double s8_1271 = fnma(work.s8_1091, s8_1181, fnma(work.s8_1061, work.s8_1073, s8_1270));
  const double s8_1272 = fma(p_lower_arm_left_x, s8_1246 - work.s8_664 - work.s7_136, s8_1271);
  const double s8_1273 = fnma(s8_1179, s8_1181, work.s8_1154);
  const double s8_1274 = fma(work.s8_28, work.s7_145 - work.s7_144, s8_1273);
  const double s8_1275 = fma(work.s3_33, work.s8_1166, s8_1274);
  const double s8_1276 = fma(work.Rz_carrier_right_ry_1, work.s8_705, s8_1275);
  const double s8_1277 = fma(work.Rz_carrier_right_rx_1, work.s8_704, s8_1276);
  const double s8_1278 = work.s8_39 - work.s8_48;
  const double s8_1279 = fma(work.Rz_arb_front_right_1, work.s8_650, s8_1277);
  const double s8_1280 = fma(work.s7_143, s8_1278, s8_1279);
  const double s8_1281 = fma(s8_1185, s8_1280, work.s1_76);
  const double s8_1282 = fnma(work.s8_624, work.f_carrier_left_y, s8_1281);
  const double s8_1283 = fma(work.s8_622, work.f_carrier_left_z, s8_1282);
  const double s8_1284 = fnma(work.s8_621, work.n_carrier_left_x, s8_1283);
  const double s8_1285 = fnma(work.s8_905, work.s8_931, fnma(work.s8_897, work.s8_923, s8_1284));
  const double s8_1286 = fnma(work.s8_1010, work.s8_1041, fma(work.s3_29, work.s8_916, s8_1285));
  const double s8_1287 = fnma(work.s3_22, work.s8_1027, s8_1286);
  result.inertia[6] = fnma(1e-12, work.s8_1014, pivot_carrier_left_rz);
  const double s8_1288 = work.Rz_arb_front_left_0*work.s7_123;
  const double s8_1289 = fnma(work.s8_829, s8_1182, fma(s8_1185, s8_1242, s8_1288 + work.s8_580));
  const double s8_1290 = 1.0/pivot_carrier_left_rz;
  const double s8_1291 = s8_1289*s8_1290;
  const double s8_1292 = work.s3_18*work.s7_108;
  const double s8_1293 = work.s3_19*work.s7_56;
  const double s8_1294 = work.s8_776 + (s8_1292 + s8_1293);
  const double s8_1295 = fnma(work.s8_869, s8_1181, s8_1244);
  const double s8_1296 = fnma(work.s8_869, s8_1182, fma(s8_1185, s8_1295, s8_1294));
  const double s8_1297 = s8_1290*s8_1296;
  const double s8_1298 = work.Rz_arb_front_left_0*work.s7_125;
  const double s8_1299 = work.s3_18*work.s7_106;
  const double s8_1300 = work.s3_19*work.s7_54;
  const double s8_1301 = fma(s8_1185, s8_1248, work.s8_782 - s8_1298 - s8_1299 - s8_1300);
  const double s8_1302 = fnma(work.s8_865, s8_1182, s8_1301);
  const double s8_1303 = s8_1290*s8_1302;
  const double s8_1304 = fma(s8_1185, s8_1254, work.s8_832);
  const double s8_1305 = fnma(work.Rz_arb_front_left_0, work.s7_119, s8_1304);
  const double s8_1306 = fnma(p_arb_front_left_y, s8_1288, s8_1305);
  const double s8_1307 = fnma(work.r_carrier_left_aux1_y, work.s8_580, s8_1306);
  const double s8_1308 = fma(work.s8_888, work.s8_897, fma(work.s8_885, work.s3_29, s8_1307));
  const double s8_1309 = fnma(work.s3_22, work.s8_999, fnma(work.s8_1002, work.s8_1010, s8_1308));
  const double s8_1310 = fma(p_lower_arm_left_x, s8_1294, fnma(work.s8_1125, s8_1182, s8_1309));
  const double s8_1311 = s8_1290*s8_1310;
  const double s8_1312 = fma(s8_1185, s8_1266, work.s8_851 - work.s8_759 - work.s8_873);
  const double s8_1313 = fma(-p_upper_arm_left_z, s8_1292, s8_1312);
  const double s8_1314 = fnma(p_upper_arm_left_y, s8_1299, s8_1313);
  const double s8_1315 = fnma(work.Rz_arb_front_left_0, work.s7_121, s8_1314);
  const double s8_1316 = fnma(p_arb_front_left_y, s8_1298, s8_1315);
  const double s8_1317 = fma(work.r_carrier_left_aux1_y, work.s8_782, s8_1316);
  const double s8_1318 = fnma(work.r_carrier_left_aux1_z, work.s8_776, s8_1317);
  const double s8_1319 = fma(-p_lower_arm_left_z, s8_1293, s8_1318);
  const double s8_1320 = fnma(p_lower_arm_left_y, s8_1300, s8_1319);
  const double s8_1321 = fnma(work.s8_892, work.s8_897, fma(work.s8_885, work.s8_905, s8_1320));
  const double s8_1322 = fma(work.s8_999, work.s8_1011, fma(work.s8_1010, work.s8_1015, s8_1321));
  const double s8_1323 = fnma(work.s8_1110, s8_1182, s8_1322);
  const double s8_1324 = s8_1290*s8_1323;
  const double s8_1325 = fma(s8_1185, s8_1272, work.s8_748 + work.s8_835);
  const double s8_1326 = fma(p_arb_front_left_x, s8_1298, s8_1325);
  const double s8_1327 = fnma(-p_arb_front_left_z, s8_1288, s8_1326);
  const double s8_1328 = fma(work.r_carrier_left_aux1_z, work.s8_580, s8_1327);
  const double s8_1329 = fnma(work.s8_888, work.s8_905, fnma(work.s8_892, work.s3_29, s8_1328));
  const double s8_1330 = fma(work.s8_1002, work.s8_1011, fnma(work.s3_22, work.s8_1015, s8_1329));
  const double s8_1331 = fnma(work.s8_1091, s8_1182, s8_1330);
  const double s8_1332 = fma(p_lower_arm_left_x, s8_1299 + s8_1300 - work.s8_782, s8_1331);
  const double s8_1333 = s8_1290*s8_1332;
  const double s8_1334 = s8_1184*s8_1242;
  const double s8_1335 = s8_1184*s8_1295;
  const double s8_1336 = s8_1184*s8_1248;
  const double s8_1337 = s8_1184*s8_1254;
  const double s8_1338 = s8_1184*s8_1266;
  const double s8_1339 = s8_1184*s8_1272;
  const double s8_1340 = work.s8_829*s8_1180;
  const double s8_1341 = fma(s8_1295, s8_1334, fma(s8_1291, s8_1296, work.s8_499));
  const double s8_1342 = fma(work.s8_869, s8_1340, s8_1341);
  const double s8_1343 = fma(s8_1242, s8_1334, fma(s8_1289, s8_1291, work.s8_500));
  const double s8_1344 = fma(work.s8_829, s8_1340, s8_1343);
  const double s8_1345 = fma(s8_1248, s8_1334, fma(s8_1291, s8_1302, work.s8_501));
  const double s8_1346 = fma(work.s8_865, s8_1340, s8_1345);
  const double s8_1347 = fma(s8_1266, s8_1334, fma(s8_1291, s8_1323, work.s8_502));
  const double s8_1348 = fma(work.s8_1110, s8_1340, s8_1347);
  const double s8_1349 = fma(s8_1254, s8_1334, fma(s8_1291, s8_1310, work.s8_503));
  const double s8_1350 = fma(work.s8_1125, s8_1340, s8_1349);
  const double s8_1351 = fma(s8_1272, s8_1334, fma(s8_1291, s8_1332, work.s8_504));
  const double s8_1352 = fma(work.s8_1091, s8_1340, s8_1351);
  const double s8_1353 = work.s8_865*s8_1180;
  const double s8_1354 = fma(s8_1248, s8_1336, fma(s8_1302, s8_1303, work.s8_511));
  const double s8_1355 = fma(work.s8_865, s8_1353, s8_1354);
  const double s8_1356 = fma(s8_1266, s8_1336, fma(s8_1303, s8_1323, work.s8_512));
  const double s8_1357 = fma(work.s8_1110, s8_1353, s8_1356);
  const double s8_1358 = fma(s8_1254, s8_1336, fma(s8_1303, s8_1310, work.s8_513));
  const double s8_1359 = fma(work.s8_1125, s8_1353, s8_1358);
  const double s8_1360 = fma(s8_1272, s8_1336, fma(s8_1303, s8_1332, work.s8_514));
  const double s8_1361 = fma(work.s8_1091, s8_1353, s8_1360);
  const double s8_1362 = work.s8_869*s8_1180;
  const double s8_1363 = fma(s8_1295, s8_1335, fma(s8_1296, s8_1297, work.s8_482));
  const double s8_1364 = fma(work.s8_869, s8_1362, s8_1363);
  const double s8_1365 = fma(s8_1248, s8_1335, fma(s8_1297, s8_1302, work.s8_483));
  const double s8_1366 = fma(work.s8_865, s8_1362, s8_1365);
  const double s8_1367 = fma(s8_1266, s8_1335, fma(s8_1297, s8_1323, work.s8_484));
  const double s8_1368 = fma(work.s8_1110, s8_1362, s8_1367);
  const double s8_1369 = fma(s8_1254, s8_1335, fma(s8_1297, s8_1310, work.s8_485));
  const double s8_1370 = fma(work.s8_1125, s8_1362, s8_1369);
  const double s8_1371 = fma(s8_1272, s8_1335, fma(s8_1297, s8_1332, work.s8_486));
  const double s8_1372 = fma(work.s8_1091, s8_1362, s8_1371);
  const double s8_1373 = work.s8_1091*s8_1180;
  const double s8_1374 = fma(s8_1254, s8_1339, fma(s8_1310, s8_1333, work.s8_555));
  const double s8_1375 = fma(s8_1272, s8_1339, fma(s8_1332, s8_1333, work.s8_556));
  const double s8_1376 = fma(work.s8_1091, s8_1373, s8_1375);
  const double s8_1377 = fma(work.s8_1125, s8_1373, s8_1374) + (s8_1221 + work.s8_1066);
  const double s8_1378 = work.s8_1110*s8_1180;
  const double s8_1379 = fma(s8_1266, s8_1338, fma(s8_1323, s8_1324, work.s8_521));
  const double s8_1380 = fma(work.s8_1110, s8_1378, s8_1379);
  const double s8_1381 = fma(s8_1254, s8_1338, fma(s8_1310, s8_1324, work.s8_522));
  const double s8_1382 = fma(work.s8_1125, s8_1378, s8_1381);
  const double s8_1383 = fma(s8_1272, s8_1338, fma(s8_1324, s8_1332, work.s8_523));
  const double s8_1384 = fma(work.s8_1091, s8_1378, s8_1383);
  const double s8_1385 = work.s8_1125*s8_1180;
  const double s8_1386 = fma(s8_1280, s8_1337, fma(s8_1179, s8_1385, work.s8_825));
  const double s8_1387 = fma(work.s7_227, work.s8_635, fma(work.s7_228, work.s8_634, s8_1386));
  const double s8_1388 = work.s7_232*work.s8_24;
  const double s8_1389 = fnma(p_pitman_arm_x, work.s8_636, s8_1387);
  const double s8_1390 = fnma(p_bell_crank_x, s8_1388, s8_1389);
  const double s8_1391 = fma(work.zdd_star_arb_front_right, work.s7_209, s8_1390);
  const double s8_1392 = fma(work.s7_215, work.s8_643, fma(work.s7_207, work.s8_17, s8_1391));
  const double s8_1393 = fnma(work.s7_197, work.s8_656, fma(work.s7_214, work.s8_642, s8_1392));
  const double s8_1394 = fnma(work.s7_198, work.s8_657, s8_1393);
  const double s8_1395 = fnma(work.r_carrier_right_aux1_y, work.f_carrier_right_x, s8_1394);
  const double s8_1396 = fnma(work.s7_144, work.s8_742, fnma(work.s7_143, work.s8_741, s8_1395));
  const double s8_1397 = fma(work.s7_130, work.s8_749, fma(work.s7_131, work.s8_750, s8_1396));
  const double s8_1398 = fnma(work.zdd_star_arb_front_left, work.s7_119, s8_1397);
  const double s8_1399 = fnma(work.s7_114, work.s8_764, fma(work.s7_121, work.s8_18, s8_1398));
  const double s8_1400 = fnma(work.s7_113, work.s8_765, s8_1399);
  const double s8_1401 = fnma(work.r_carrier_left_aux1_y, work.f_carrier_left_x, s8_1400);
  const double s8_1402 = fnma(work.s7_61, work.s8_876, fnma(work.s7_62, work.s8_875, s8_1401));
  const double s8_1403 = fnma(work.s2_184, work.s8_923, fma(work.s2_197, work.s8_916, s8_1402));
  const double s8_1404 = fnma(work.s2_221, work.s8_964, fnma(work.s2_208, work.s8_957, s8_1403));
  const double s8_1405 = fnma(work.s2_227, work.s8_990, fma(work.s2_231, work.s8_993, s8_1404));
  const double s8_1406 = fma(work.s2_249, work.s8_1041, fma(work.s2_241, work.s8_1027, s8_1405));
  const double s8_1407 = fma(s8_1254, s8_1337, fma(s8_1310, s8_1311, work.s8_539));
  const double s8_1408 = fma(work.s8_1125, s8_1385, s8_1407);
  const double s8_1409 = fnma(s8_1179, s8_1182, fnma(work.s8_1011, work.s8_1034, s8_1287));
  const double s8_1410 = fma(work.s3_18, work.s8_774 - tau[Coordinate::upper_arm_left], s8_1409);
  const double s8_1411 = fma(work.s3_19, work.s8_884 - tau[Coordinate::lower_arm_left], s8_1410);
  const double s8_1412 = fma(work.s3_21, work.s8_822, fma(work.s3_20, work.s8_824, s8_1411));
  const double s8_1413 = fma(work.Rz_arb_front_left_0, work.s8_758, s8_1412);
  const double s8_1414 = fnma(work.s2_268, work.s8_1135, fma(work.s2_261, work.s8_1152, s8_1406));
  const double s8_1415 = work.s8_594 + work.f_carrier_left_y;
  const double s8_1416 = work.s8_496 + (work.f_carrier_right_y + (work.s8_751 + s8_1415));
  const double s8_1417 = work.s8_644 + s8_1416 - s8_1388 - work.s8_636 - work.s8_616;
  const double s8_1418 = fnma(work.s7_136, work.s8_740, s8_1417) - work.s8_872;
  const double s8_1419 = fma(s8_1280, s8_1335, fma(s8_1179, s8_1362, s8_1418));
  const double s8_1420 = work.s7_4 - fma(s8_1297, s8_1413, s8_1419);
  const double s8_1421 = work.s8_596 + (work.s8_766 + (work.f_carrier_left_x + work.s8_877));
  const double s8_1422 = work.s8_658 + (work.f_carrier_right_x + (work.s8_743 + s8_1421));
  const double s8_1423 = work.s8_632 + (work.s8_508 + (work.s7_224 + (work.s8_617 + s8_1422)));
  const double s8_1424 = fma(s8_1280, s8_1334, fma(s8_1179, s8_1340, s8_1423));
  const double s8_1425 = work.s7_9 - fma(s8_1291, s8_1413, s8_1424);
  const double s8_1426 = fma(work.s7_138, work.s8_740, work.f_carrier_left_z + work.s8_871);
  const double s8_1427 = work.s7_223 + (work.s8_615 + (work.f_carrier_right_z + s8_1426));
  const double s8_1428 = work.s8_631 + (work.s8_518 + s8_1427) - work.s8_618 - work.s8_597;
  const double s8_1429 = fma(s8_1280, s8_1336, fma(s8_1179, s8_1353, s8_1428 - work.s8_595));
  const double s8_1430 = work.s7_7 - fma(s8_1303, s8_1413, s8_1429);
  const double s8_1431 = work.n_carrier_right_x + (work.n_carrier_left_x + work.s8_880);
  const double s8_1432 = fma(s8_1179, s8_1378, work.s8_536 + s8_1431 - work.s8_659 - work.s8_769);
  const double s8_1433 = fma(work.s7_242, work.s8_630, fma(s8_1280, s8_1338, s8_1432));
  const double s8_1434 = fnma(-p_bell_crank_z, s8_1388, fma(work.s7_238, work.s8_629, s8_1433));
  const double s8_1435 = fnma(work.s7_229, work.s8_635, fnma(work.s7_227, work.s8_634, s8_1434));
  const double s8_1436 = fma(work.s7_209, work.s8_17, s8_1435);
  const double s8_1437 = fnma(work.zdd_star_arb_front_right, work.s7_207, s8_1436);
  const double s8_1438 = fnma(work.s7_216, work.s8_642, fnma(work.s7_214, work.s8_643, s8_1437));
  const double s8_1439 = fma(work.s2_213, work.f_carrier_right_y, s8_1438);
  const double s8_1440 = fma(work.r_carrier_right_aux1_y, work.f_carrier_right_z, s8_1439);
  const double s8_1441 = fnma(work.zdd_star_arb_front_left, work.s7_121, s8_1440);
  const double s8_1442 = fnma(work.s7_130, work.s8_750, fnma(work.s7_119, work.s8_18, s8_1441));
  const double s8_1443 = fnma(work.s7_132, work.s8_749, s8_1442);
  const double s8_1444 = fma(work.r_carrier_left_aux1_y, work.f_carrier_left_z, s8_1443);
  const double s8_1445 = fnma(work.r_carrier_left_aux1_z, work.f_carrier_left_y, s8_1444);
  const double s8_1446 = fnma(work.s2_197, work.s8_931, fma(work.s2_190, work.s8_923, s8_1445));
  const double s8_1447 = fma(work.s2_221, work.s8_971, fma(work.s2_214, work.s8_957, s8_1446));
  const double s8_1448 = fnma(work.s2_231, work.s8_996, fma(work.s2_229, work.s8_990, s8_1447));
  const double s8_1449 = fnma(work.s2_241, work.s8_1034, s8_1448);
  const double s8_1450 = fma(work.s2_261, work.s8_1141, fnma(work.s2_235, work.s8_1041, s8_1449));
  const double s8_1451 = work.s8_644 + (work.s7_223 + work.s8_751) - work.s8_615 - work.s8_595;
  const double s8_1452 = fma(s8_1324, s8_1413, fnma(work.s2_257, work.s8_1135, s8_1450));
  const double s8_1453 = fnma(work.s7_138, work.s8_740, work.s8_871 - work.s8_636);
  const double s8_1454 = fma(-p_rear_axle_tx_z, s8_1451, s8_1452);
  const double s8_1455 = fma(p_lower_arm_left_y, s8_1453, s8_1454);
  const double s8_1456 = fma(p_carrier_left_rz_y, work.s8_618 - work.s8_597, s8_1455);
  const double s8_1457 = fma(work.s7_136, work.s8_740, work.s8_872);
  const double s8_1458 = fnma(-p_lower_arm_left_z, s8_1457, s8_1456);
  const double s8_1459 = fma(-p_upper_arm_right_z, work.s8_594 - work.s8_616, s8_1458);
  const double s8_1460 = fms(tau[Coordinate::chassis_rx], work.s1_63, s8_1459);
  const double s8_1461 = work.f_carrier_right_y + s8_1415 - work.s8_616;
  const double s8_1462 = fnma(work.s7_136, work.s8_740, s8_1461) - work.s8_872;
  const double s8_1463 = fma(p_lower_arm_left_x, s8_1462, fma(s8_1311, s8_1413, s8_1414));
  const double s8_1464 = fma(-p_rear_axle_tx_z, work.s8_658 - work.s7_224 - work.s8_766, s8_1463);
  const double s8_1465 = fma(p_lower_arm_left_y, work.s8_743 - work.s8_877, s8_1464);
  const double s8_1466 = fma(p_carrier_left_rz_y, work.s8_617 - work.s8_596, s8_1465);
  const double s8_1467 = work.s1_62 - fma(p_arb_front_left_x, work.s8_644 + work.s8_751, s8_1466);
  const double s8_1468 = work.s8_595 - work.s8_615 - work.f_carrier_right_z;
  const double s8_1469 = fnma(work.s7_138, work.s8_740, s8_1468) - work.f_carrier_left_z;
  const double s8_1470 = fma(work.zdd_star_arb_front_left, work.s7_133, work.n_carrier_left_y);
  const double s8_1471 = work.s8_567 + (work.n_carrier_right_y + s8_1470);
  const double s8_1472 = fma(work.zdd_star_arb_front_right, work.s7_217, s8_1471) - work.s8_640;
  const double s8_1473 = fma(s8_1280, s8_1339, fma(s8_1179, s8_1373, s8_1472));
  const double s8_1474 = fnma(work.s7_238, work.s8_630, fnma(work.s7_239, work.s8_629, s8_1473));
  const double s8_1475 = fnma(-p_bell_crank_z, work.s8_632, s8_1474);
  const double s8_1476 = fnma(p_bell_crank_x, work.s8_631, s8_1475);
  const double s8_1477 = fnma(-p_pitman_arm_z, work.s7_224, s8_1476);
  const double s8_1478 = fnma(p_pitman_arm_x, work.s7_223, s8_1477);
  const double s8_1479 = fma(work.s7_199, work.s8_656, fma(work.s7_197, work.s8_657, s8_1478));
  const double s8_1480 = fnma(work.s2_213, work.f_carrier_right_x, s8_1479);
  const double s8_1481 = fma(work.s7_145, work.s8_741, fma(work.s7_143, work.s8_742, s8_1480));
  const double s8_1482 = fma(work.s7_115, work.s8_765, fma(work.s7_113, work.s8_764, s8_1481));
  const double s8_1483 = fma(work.r_carrier_left_aux1_z, work.f_carrier_left_x, s8_1482);
  const double s8_1484 = fma(work.s7_63, work.s8_876, fma(work.s7_61, work.s8_875, s8_1483));
  const double s8_1485 = fnma(work.s2_190, work.s8_916, fma(work.s2_184, work.s8_931, s8_1484));
  const double s8_1486 = fnma(work.s2_214, work.s8_964, fma(work.s2_208, work.s8_971, s8_1485));
  const double s8_1487 = fnma(work.s2_229, work.s8_993, fma(work.s2_227, work.s8_996, s8_1486));
  const double s8_1488 = fma(work.s2_235, work.s8_1027, fnma(work.s2_249, work.s8_1034, s8_1487));
  const double s8_1489 = fnma(work.s2_257, work.s8_1152, fma(work.s2_268, work.s8_1141, s8_1488));
  const double s8_1490 = fma(s8_1333, s8_1413, s8_1489);
  const double s8_1491 = fma(p_lower_arm_left_x, s8_1469 - work.s8_871, s8_1490);
  const double s8_1492 = fnma(-p_lower_arm_left_z, work.s8_743 + work.s8_877, s8_1491);
  const double s8_1493 = fnma(-p_rear_axle_tx_z, work.s8_617 + work.s8_596, s8_1492);
  const double s8_1494 = fma(p_arb_front_left_x, work.s8_618 + work.s8_597, s8_1493);
  const double s8_1495 = fnma(-p_upper_arm_right_z, work.s8_658 + work.s8_766, s8_1494);
  const double s8_1496 = work.s1_58 - s8_1495;
  // operations: 1213 add, 1099 multiply, 3 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1497 = h_chassis_y + work.s8_858;
  const double s8_1498 = s8_1223 + s8_1497;
  const double s8_1499 = s8_1350 + s8_1498;
  const double s8_1500 = K_chassis_xz + s8_1205;
  const double s8_1501 = s8_1382 + (s8_1227 + s8_1500);
  const double s8_1502 = K_chassis_xy + s8_1214;
  const double s8_1503 = h_chassis_z + s8_1230;
  const double s8_1504 = s8_1226 + s8_1503;
  const double s8_1505 = s8_1187 - (-h_chassis_x);
  const double s8_1506 = s8_1224 + s8_1505;
  const double s8_1507 = s8_1506 - s8_1370;
  const double s8_1508 = fnma(work.s8_28, s8_1503, fnma(work.s8_27, s8_1505, s8_1420));
  const double s8_1509 = K_chassis_zz + s8_1234;
  const double s8_1510 = work.s8_1069 + s8_1509;
  const double s8_1511 = K_chassis_yy + s8_1236;
  const double s8_1512 = work.s8_1067 + s8_1511;
  const double s8_1513 = K_chassis_xx + s8_1239;
  const double s8_1514 = s8_1240 + s8_1513;
  const double s8_1515 = 15306.0 - s8_1344;
  const double s8_1516 = 15306.0 - s8_1355;
  const double s8_1517 = 15306.0 - s8_1364;
  const double s8_1518 = s8_1512 + (s8_1510 + s8_1514);
  const double pivot_chassis_rx = s8_1518 - s8_1510 - s8_1408;
  const double s8_1519 = 1.0/pivot_chassis_rx;
  const double s8_1520 = s8_1519*s8_1377;
  const double s8_1521 = fnma(s8_1499, s8_1520, s8_1504 - s8_1352);
  const double s8_1522 = fma(s8_1520, s8_1501, s8_1384 + (s8_1228 + s8_1502));
  const double s8_1523 = fma(s8_1359, s8_1520, s8_1361 + s8_1506);
  const double s8_1524 = fms(s8_1520, s8_1507, s8_1372);
  const double s8_1525 = s8_1518 - s8_1512 - s8_1376;
  const double pivot_chassis_ry = fnma(s8_1377, s8_1520, s8_1525);
  const double s8_1526 = 1.0/pivot_chassis_ry;
  const double s8_1527 = s8_1526*s8_1522;
  const double s8_1528 = s8_1519*s8_1501;
  const double s8_1529 = fnma(s8_1499, s8_1528, fms(s8_1521, s8_1527, s8_1348));
  const double s8_1530 = fnma(s8_1527, s8_1523, fnma(s8_1359, s8_1528, s8_1498 - s8_1357));
  const double s8_1531 = fma(s8_1527, s8_1524, fms(s8_1528, s8_1507, s8_1368) - s8_1504);
  const double s8_1532 = s8_1518 - s8_1514 - s8_1380;
  const double pivot_chassis_rz = fnma(s8_1522, s8_1527, fnma(s8_1501, s8_1528, s8_1532));
  const double s8_1533 = s8_1526*s8_1523;
  const double s8_1534 = s8_1359*s8_1519;
  const double s8_1535 = 1.0/pivot_chassis_rz;
  const double s8_1536 = s8_1535*s8_1530;
  const double s8_1537 = fnma(s8_1499, s8_1534, fms(s8_1521, s8_1533, s8_1346));
  const double s8_1538 = fnma(s8_1529, s8_1536, s8_1537);
  const double s8_1539 = fma(s8_1533, s8_1524, fms(s8_1534, s8_1507, s8_1366));
  const double s8_1540 = fnma(s8_1536, s8_1531, s8_1539);
  const double s8_1541 = fnma(s8_1523, s8_1533, fnma(s8_1359, s8_1534, s8_1516));
  const double pivot_chassis_tz = fnma(s8_1530, s8_1536, s8_1541);
  const double s8_1542 = s8_1519*s8_1507;
  const double s8_1543 = s8_1526*s8_1524;
  const double s8_1544 = s8_1535*s8_1531;
  const double s8_1545 = fnma(s8_1521, s8_1543, fms(s8_1499, s8_1542, s8_1342));
  const double s8_1546 = 1.0/pivot_chassis_tz;
  const double s8_1547 = s8_1546*s8_1540;
  const double s8_1548 = fnma(s8_1538, s8_1547, fnma(s8_1529, s8_1544, s8_1545));
  const double s8_1549 = fnma(s8_1524, s8_1543, fnma(s8_1507, s8_1542, s8_1517));
  const double pivot_chassis_ty = fnma(s8_1540, s8_1547, fnma(s8_1531, s8_1544, s8_1549));
  const double s8_1550 = s8_1499*s8_1519;
  const double s8_1551 = s8_1521*s8_1526;
  const double s8_1552 = s8_1529*s8_1535;
  const double s8_1553 = fnma(s8_1521, s8_1551, fnma(s8_1499, s8_1550, s8_1515));
  const double s8_1554 = s8_1538*s8_1546;
  const double s8_1555 = 1.0/pivot_chassis_ty;
  const double s8_1556 = s8_1548*s8_1555;
  const double s8_1557 = fnma(s8_1538, s8_1554, fnma(s8_1529, s8_1552, s8_1553));
  const double pivot_chassis_tx = fnma(s8_1548, s8_1556, s8_1557);
  result.inertia[5] = fnma(1e-12, pivot_chassis_rx, pivot_chassis_rx);
  const double s8_1558 = fma(work.s8_36, s8_1221, fnma(work.s8_28, s8_1500, s8_1467));
  const double s8_1559 = fma(s8_1177, s8_1502, fma(work.s8_27, s8_1511 - s8_1513, s8_1558));
  const double s8_1560 = fnma(work.s8_27, s8_1221, fma(s8_1520, s8_1559, s8_1496));
  const double s8_1561 = fnma(work.s8_27, s8_1497, fma(s8_1550, s8_1559, s8_1425));
  const double s8_1562 = fnma(1e-12, s8_1525, pivot_chassis_ry);
  const double s8_1563 = fma(work.s8_36, s8_1513 - s8_1509, fma(work.s8_28, s8_1502, s8_1560));
  const double s8_1564 = fma(work.s8_445, s8_1500, s8_1563);
  const double s8_1565 = fma(s8_1528, s8_1559, fma(s8_1527, s8_1564, s8_1460));
  const double s8_1566 = fma(s8_1534, s8_1559, fma(s8_1533, s8_1564, s8_1430));
  const double s8_1567 = fnma(work.s8_36, s8_1505, fnma(work.s8_28, s8_1497, s8_1566));
  const double s8_1568 = fnma(s8_1542, s8_1559, fma(work.s8_48, s8_1497, s8_1508));
  const double s8_1569 = fma(work.s8_42, s8_1505, fnma(work.s8_36, s8_1503, s8_1561));
  result.inertia[3] = fnma(1e-12, s8_1532, pivot_chassis_rz);
  result.inertia[2] = fnma(1e-12, s8_1516, pivot_chassis_tz);
  result.inertia[1] = fnma(1e-12, s8_1517, pivot_chassis_ty);
  const double s8_1570 = fma(work.s8_27, s8_1500, fnma(work.s8_36, s8_1502, s8_1565));
  const double s8_1571 = fma(s8_1221, s8_1278, fma(work.s8_28, s8_1509 - s8_1511, s8_1570));
  const double s8_1572 = fnma(s8_1536, s8_1571, fma(work.s8_39, s8_1503, s8_1567));
  const double s8_1573 = fnma(s8_1544, s8_1571, fnma(s8_1543, s8_1564, s8_1568));
  const double s8_1574 = fnma(s8_1547, s8_1572, s8_1573);
  const double s8_1575 = fnma(s8_1552, s8_1571, fnma(s8_1551, s8_1564, s8_1569));
  const double s8_1576 = fnma(s8_1556, s8_1574, fnma(s8_1554, s8_1572, s8_1575));
  result.inertia[0] = fnma(1e-12, s8_1515, pivot_chassis_tx);
  const double s8_1577 = 1.0/pivot_chassis_tx;
  // operations: 125 add, 113 multiply, 6 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double a_chassis_x = s8_1576*s8_1577;
  const double a_chassis_y = s8_1555*fnma(s8_1548, a_chassis_x, s8_1574);
  const double a_chassis_z = s8_1546*fnma(s8_1540, a_chassis_y, fnma(s8_1538, a_chassis_x,
      s8_1572));
  const double s9_1 = fnma(s8_1531, a_chassis_y, fnma(s8_1529, a_chassis_x, s8_1571));
  const double alpha_chassis_x = s8_1535*fnma(s8_1530, a_chassis_z, s9_1);
  const double s9_2 = fnma(s8_1524, a_chassis_y, fnma(s8_1521, a_chassis_x, s8_1564));
  const double alpha_chassis_y = s8_1526*fma(s8_1522, alpha_chassis_x, fma(s8_1523, a_chassis_z,
      s9_2));
  const double s9_3 = fnma(s8_1507, a_chassis_y, fma(s8_1499, a_chassis_x, s8_1559));
  const double s9_4 = fma(s8_1501, alpha_chassis_x, fma(s8_1359, a_chassis_z, s9_3));
  const double alpha_chassis_z = s8_1519*fma(s8_1377, alpha_chassis_y, s9_4);
  const double s9_5 = fnma(-g_z, work.R_chassis_z_y, a_chassis_y);
  const double s1_1 = work.sines[1];
  const double s9_6 = fma(-g_z, s1_1, a_chassis_x);
  const double s9_7 = fnma(-g_z, work.R_chassis_z_z, a_chassis_z);
  result.zdd[Coordinate::chassis_tz] = fnma(s1_1, s9_6, fma(work.R_chassis_z_z, s9_7,
      work.R_chassis_z_y*s9_5));
  const double s9_8 = fma(work.R_chassis_aux5_y_x, s9_6, work.R_chassis_y_y*s9_5);
  result.zdd[Coordinate::chassis_ty] = fma(work.R_chassis_y_z, s9_7, s9_8);
  const double s9_9 = fma(work.R_chassis_aux5_x_x, s9_6, work.R_chassis_x_y*s9_5);
  result.zdd[Coordinate::chassis_tx] = fma(work.R_chassis_x_z, s9_7, s9_9);
  result.inertia[4] = mbgen::min(s8_1562, fms(work.s1_6, work.s1_6, 1e-12));
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  const double s9_10 = fma(work.s4_33, work.s4_4, alpha_chassis_y);
  const double s9_11 = fnma(zd_chassis_rx, work.w_chassis_z, s9_10);
  const double s9_12 = fma(zd_chassis_rx, work.w_chassis_y, alpha_chassis_z);
  const double s9_13 = fma(work.s4_33, work.s4_2, s9_12);
  result.zdd[Coordinate::chassis_rz] = fma(work.s1_60, s9_13, work.s1_56*s9_11);
  result.zdd[Coordinate::chassis_ry] = fnma(work.sines[2], s9_13, work.cosines[2]*s9_11);
  const double s9_14 = fma(work.s4_2, work.s4_3, fma(work.s4_1, work.s4_4, alpha_chassis_x));
  result.zdd[Coordinate::chassis_rx] = fma(work.s1_63, s9_14, fma(work.s1_59, s9_13,
      work.s1_55*s9_11));
  // bell_crank: bell_crank, revolute, chassis
  const double s9_15 = fnma(s8_1289, a_chassis_x, fnma(s8_1296, a_chassis_y, s8_1413));
  const double s9_16 = fnma(s8_1332, alpha_chassis_y, fnma(s8_1302, a_chassis_z, s9_15));
  const double s9_17 = fnma(s8_1323, alpha_chassis_x, fnma(s8_1310, alpha_chassis_z, s9_16));
  const double s9_18 = s8_1290*s9_17;
  const double s9_19 = fnma(s8_1295, a_chassis_y, fma(s8_1183, s9_18, s8_1280));
  const double s9_20 = fnma(s8_1248, a_chassis_z, fnma(s8_1242, a_chassis_x, s9_19));
  const double s9_21 = fnma(s8_1254, alpha_chassis_z, fnma(s8_1272, alpha_chassis_y, s9_20));
  const double s9_22 = s8_1184*fnma(s8_1266, alpha_chassis_x, s9_21);
  result.zdd[Coordinate::lower_arm_right] = s9_22;
  const double s9_23 = fnma(work.s8_829, a_chassis_x, fnma(work.s8_869, a_chassis_y, s8_1179));
  const double s9_24 = fnma(work.s8_865, a_chassis_z, s9_23);
  const double s9_25 = fnma(work.s8_1091, alpha_chassis_y, s9_24);
  const double s9_26 = fnma(work.s8_1110, alpha_chassis_x, s9_25);
  const double s9_27 = fnma(work.s8_1020, s9_18, fnma(work.s8_1125, alpha_chassis_z, s9_26));
  const double s9_28 = s8_1180*fnma(work.s8_1075, s9_22, s9_27);
  result.zdd[Coordinate::bell_crank] = s9_28;
  const double s9_29 = fma(work.Rz_arb_front_left_0, s9_18, work.zdd_star_arb_front_left);
  result.zdd[Coordinate::arb_front_left] = fma(work.Rz_arb_front_left_2, s9_28, s9_29);
  const double s9_30 = fma(work.Rz_lower_arm_left_2, s9_28, work.zdd_star_lower_arm_left);
  result.zdd[Coordinate::lower_arm_left] = fnma(work.s3_19, s9_18, s9_30);
  const double s9_31 = fma(work.Rz_carrier_right_ry_1, s9_22, work.zdd_star_carrier_right_ry);
  const double s9_32 = fma(work.Rz_carrier_right_ry_2, s9_28, s9_31);
  const double s9_33 = fma(work.Rz_carrier_right_rx_1, s9_22, work.zdd_star_carrier_right_rx);
  const double s9_34 = fma(work.Rz_carrier_right_rx_2, s9_28, s9_33);
  const double s9_35 = fma(work.Rz_arb_front_right_1, s9_22, work.zdd_star_arb_front_right);
  result.zdd[Coordinate::arb_front_right] = fma(work.Rz_arb_front_right_2, s9_28, s9_35);
  const double s9_36 = fnma(work.s3_20, s9_18, work.zdd_star_carrier_left_ry);
  const double s9_37 = fnma(work.s3_23, s9_28, s9_36);
  const double s9_38 = fnma(work.s3_21, s9_18, work.zdd_star_carrier_left_rx);
  const double s9_39 = fnma(work.s3_24, s9_28, s9_38);
  const double s9_40 = fms(work.Rz_upper_arm_left_2, s9_28, work.s6_134);
  result.zdd[Coordinate::upper_arm_left] = fnma(work.s3_18, s9_18, s9_40);
  result.zdd[Coordinate::pitman_arm] = -fma(work.s3_57, s9_28, work.s6_154);
  result.zdd[Coordinate::upper_arm_right] = -fma(work.s3_35, s9_28, fma(work.s3_33, s9_22,
      work.s6_147));
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double alpha_carrier_left_x = fma(work.s8_621, s9_18,
      alpha_chassis_x + (work.s4_15 + s9_30));
  const double alpha_carrier_left_y = alpha_chassis_y + (work.s4_44 + s9_39);
  const double alpha_carrier_left_z = alpha_chassis_z + (work.s4_43 + s9_37);
  const double s9_41 = fma(work.s4_6, work.s4_7, fma(work.s4_5, work.s4_8, s9_18));
  const double s9_42 = fma(work.s4_9, work.s4_11, fnma(work.s4_10, work.s4_13, s9_41));
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s9_43 = fnma(work.s4_6, work.s4_39, fma(work.s4_10, work.s4_41, s9_39));
  const double s9_44 = fma(work.s4_11, zd_lower_arm_left + work.s4_40, s9_43);
  const double s9_45 = fnma(work.s4_40, work.s4_13, fnma(work.s4_5, work.s4_39, s9_37));
  const double s9_46 = fnma(work.s4_9, work.s4_41, s9_45);
  const double s9_47 = fma(zd_lower_arm_left, work.s4_5 - work.s4_7, s9_46);
  const double s9_48 = fma(work.cosines[4], s9_42, work.R_carrier_left_aux1_y_x*s9_44);
  result.zdd[Coordinate::carrier_left_rx] = fma(work.R_carrier_left_aux1_z_x, s9_47, s9_48);
  result.zdd[Coordinate::carrier_left_ry] = fnma(work.s1_74, s9_42, fma(work.s1_65, s9_47,
      work.s1_67*s9_44));
  result.zdd[Coordinate::carrier_left_rz] = fnma(work.s1_77, s9_44, fma(work.s1_72, s9_42,
      work.s1_69*s9_47));
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s9_49 = fma(work.Rz_carrier_right_rz_2, s9_28, work.zdd_star_carrier_right_rz);
  const double alpha_carrier_right_x = fma(work.s8_660, s9_22,
      alpha_chassis_x + (work.s4_26 + s9_49));
  const double alpha_carrier_right_y = alpha_chassis_y + (work.s4_50 + s9_34);
  const double alpha_carrier_right_z = alpha_chassis_z + (work.s4_49 + s9_32);
  const double s9_50 = fma(work.s4_16, work.s4_19, fnma(work.s3_34, s9_22, s9_49));
  const double s9_51 = fnma(work.s4_21, work.s4_24, fma(work.s4_17, work.s4_18, s9_50));
  const double s9_52 = fma(work.s4_20, work.s4_22, s9_51);
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s9_53 = fnma(work.s4_17, work.s4_45, fma(work.s4_21, work.s4_47, s9_34));
  const double s9_54 = fma(work.s4_22, zd_lower_arm_right + work.s4_46, s9_53);
  const double s9_55 = fnma(work.s4_46, work.s4_24, fnma(work.s4_16, work.s4_45, s9_32));
  const double s9_56 = fnma(work.s4_20, work.s4_47, s9_55);
  const double s9_57 = fma(zd_lower_arm_right, work.s4_16 - work.s4_18, s9_56);
  const double s9_58 = fma(work.cosines[10], s9_52, work.R_carrier_right_aux1_y_x*s9_54);
  result.zdd[Coordinate::carrier_right_rx] = fma(work.R_carrier_right_aux1_z_x, s9_57, s9_58);
  result.zdd[Coordinate::carrier_right_ry] = fnma(work.s1_90, s9_52, fma(work.s1_81, s9_57,
      work.s1_83*s9_54));
  result.zdd[Coordinate::carrier_right_rz] = fnma(work.s1_93, s9_54, fma(work.s1_88, s9_52,
      work.s1_85*s9_57));
  // bell_crank: bell_crank, revolute, chassis
  const double s9_59 = mbgen::min(work.s2_308, std::abs(work.s1_22));
  result.pivot[0] = mbgen::min(std::abs(work.s1_42), s9_59);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s9_60 = 0.09090909090909091*tau[Coordinate::wheel_front_left];
  const double s9_61 = fnma(work.R_carrier_left_aux2_y_y, alpha_carrier_left_y, s9_60);
  const double s9_62 = fnma(work.R_carrier_left_aux2_z_y, alpha_carrier_left_z, s9_61);
  result.zdd[Coordinate::wheel_front_left] = fma(work.s1_17, alpha_carrier_left_x, s9_62);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s9_63 = 0.09090909090909091*tau[Coordinate::wheel_front_right];
  const double s9_64 = fnma(work.R_carrier_right_aux2_y_y, alpha_carrier_right_y, s9_63);
  const double s9_65 = fnma(work.R_carrier_right_aux2_z_y, alpha_carrier_right_z, s9_64);
  result.zdd[Coordinate::wheel_front_right] = fma(work.s1_37, alpha_carrier_right_x, s9_65);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s9_66 = fnma(work.s8_479, a_chassis_y, work.s8_493);
  const double s9_67 = fnma(work.s8_454, a_chassis_z, fnma(work.s8_452, a_chassis_x, s9_66));
  const double s9_68 = fnma(work.s8_478, alpha_chassis_y, s9_67);
  const double s9_69 = fnma(work.s8_461, alpha_chassis_z, s9_68);
  const double s9_70 = work.s8_450*fnma(work.s8_469, alpha_chassis_x, s9_69);
  result.zdd[Coordinate::arb_rear_left] = s9_70;
  const double s9_71 = fnma(work.s8_88, a_chassis_y, work.s8_447);
  const double s9_72 = fnma(work.s8_453, a_chassis_z, fnma(work.s8_451, a_chassis_x, s9_71));
  const double s9_73 = fnma(work.s8_412, alpha_chassis_y, s9_72);
  const double s9_74 = fnma(work.s8_397, alpha_chassis_x, s9_73);
  const double s9_75 = fnma(work.s8_372, s9_70, fnma(work.s8_404, alpha_chassis_z, s9_74));
  const double s9_76 = work.s8_448*s9_75;
  result.zdd[Coordinate::arb_rear_right] = s9_76;
  const double s9_77 = fma(work.Rz_rear_axle_ry_0, s9_70, work.zdd_star_rear_axle_ry);
  const double s9_78 = fma(work.Rz_rear_axle_ry_1, s9_76, s9_77);
  const double s9_79 = fma(work.Rz_rear_axle_rx_0, s9_70, work.zdd_star_rear_axle_rx);
  const double s9_80 = fma(work.Rz_rear_axle_rx_1, s9_76, s9_79);
  const double s9_81 = fma(work.Rz_rear_axle_tx_0, s9_70, work.zdd_star_rear_axle_tx);
  result.zdd[Coordinate::rear_axle_tx] = fma(work.Rz_rear_axle_tx_1, s9_76, s9_81);
  const double s9_82 = fnma(work.s3_2, s9_70, work.zdd_star_rear_axle_tz);
  result.zdd[Coordinate::rear_axle_tz] = fma(work.Rz_rear_axle_tz_1, s9_76, s9_82);
  const double s9_83 = fma(work.Rz_rear_axle_rz_0, s9_70, work.zdd_star_rear_axle_rz);
  const double s9_84 = fnma(work.s3_10, s9_76, s9_83);
  result.zdd[Coordinate::rear_axle_ty] = -fma(work.s3_14, s9_76, fma(work.s3_8, s9_70, work.s6_58));
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double alpha_rear_axle_x = alpha_chassis_x + (work.s4_32 + s9_84);
  const double alpha_rear_axle_y = alpha_chassis_y + (work.s4_38 + s9_78);
  const double alpha_rear_axle_z = alpha_chassis_z + (work.s4_37 + s9_80);
  const double s9_85 = work.R_rear_axle_y_y*alpha_rear_axle_y;
  const double s9_86 = fma(work.R_rear_axle_z_y, alpha_rear_axle_z, s9_85);
  const double s9_87 = fma(work.R_rear_axle_x_y, alpha_rear_axle_x, s9_86);
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s9_88 = fma(work.s4_34, work.s4_29, s9_78);
  const double s9_89 = fma(zd_rear_axle_rz, work.s4_34 - work.s4_35, s9_88);
  const double s9_90 = fma(zd_rear_axle_rz, work.s4_30, fma(work.s4_27, work.s4_29, s9_84));
  result.zdd[Coordinate::rear_axle_rx] = fma(work.s1_102, s9_90, work.s1_97*s9_89);
  result.zdd[Coordinate::rear_axle_ry] = fnma(work.sines[17], s9_90, work.cosines[17]*s9_89);
  const double s9_91 = fma(work.s4_27, work.s4_35, fma(work.s4_34, work.s4_28, s9_80));
  result.zdd[Coordinate::rear_axle_rz] = fma(work.s1_105, s9_91, fma(work.s1_101, s9_90,
      work.s1_98*s9_89));
  // arb_rear_right: arb_rear_right, revolute, chassis
  result.pivot[1] = mbgen::min(work.s2_150, std::abs(work.s1_50));
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  result.zdd[Coordinate::wheel_rear_left] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_left], s9_87);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  result.zdd[Coordinate::wheel_rear_right] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_right], s9_87);
  // operations: 181 add, 187 multiply, 7 other
}

/// All accelerations with the frozen partition of the loop blocks.
void compute_accelerations(const Tuned& /*parameters*/, const Inputs& /*inputs*/,
    const State& state, const double* tau, Accelerations& __restrict result) noexcept {
  AccelerationsWork work;
  compute_accelerations_1(state, tau, work, result);
  compute_accelerations_2(state, tau, work, result);
  compute_accelerations_3(state, work);
  compute_accelerations_4(state, tau, work);
  compute_accelerations_5(state, tau, work, result);
}

/// Result of compute_closure.
struct Closure {
  double residual[17];  ///< of every closure equation, block after block, then of every motion
  double dz[32];  ///< Newton correction; driven coordinates go to their motions
  double zd[32];  ///< consistent velocities
  double pivot[2];  ///< smallest pivot of each block over its reference
};

/// One Newton step of the frozen partition, and consistent velocities.
void compute_closure(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
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
  double sines[19], cosines[19];
  mbgen::sincos(angles, sines, cosines);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = cosines[0];
  const double s1_1 = sines[1];
  const double R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_1;
  const double R_carrier_left_aux1_x_x = cosines[1];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = sines[0];
  const double R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_1;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_2 = -p_carrier_left_rz_z*R_lower_arm_left_z_y;
  const double s1_3 = fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_2);
  const double r_carrier_left_aux1_y = p_lower_arm_left_y + s1_3;
  const double s1_4 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_5 = fnma(-p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_4);
  const double r_carrier_left_aux1_z = s1_5 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_6 = cosines[2];
  const double s1_7 = s1_1*s1_6;
  const double s1_8 = sines[2];
  const double R_carrier_left_aux2_x_z = s1_1*s1_8;
  const double R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_8,
      R_carrier_left_aux1_y_y*s1_6);
  const double s1_9 = fma(R_carrier_left_aux1_y_y, s1_8, R_lower_arm_left_z_y*s1_6);
  const double R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_y, s1_6,
      R_lower_arm_left_y_y*s1_8);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_8,
      R_lower_arm_left_y_y*s1_6);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_10 = cosines[3];
  const double s1_11 = sines[3];
  const double R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_11,
      R_carrier_left_aux1_x_x*s1_10);
  const double R_carrier_left_x_z = fma(R_carrier_left_aux2_x_z, s1_10,
      R_carrier_left_aux1_x_x*s1_11);
  const double R_carrier_left_y_x = fma(s1_9, s1_11, R_carrier_left_aux1_y_x*s1_10);
  const double R_carrier_left_y_z = fnma(s1_9, s1_10, R_carrier_left_aux1_y_x*s1_11);
  const double R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_11,
      R_carrier_left_aux1_z_x*s1_10);
  const double R_carrier_left_z_z = fma(R_carrier_left_aux2_z_z, s1_10,
      R_carrier_left_aux1_z_x*s1_11);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = cosines[6];
  const double s1_12 = sines[7];
  const double R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_12;
  const double R_carrier_right_aux1_x_x = cosines[7];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = sines[6];
  const double R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_12;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_13 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  const double s1_14 = fnma(-p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_13);
  const double r_carrier_right_aux1_y = s1_14 - (-p_lower_arm_right_y);
  const double s1_15 = -p_carrier_right_rz_y*R_lower_arm_right_z_y;
  const double s1_16 = fma(-p_carrier_right_rz_z, R_lower_arm_right_y_y, s1_15);
  const double s1_17 = -p_lower_arm_right_z + s1_16;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_18 = cosines[8];
  const double s1_19 = s1_12*s1_18;
  const double s1_20 = sines[8];
  const double R_carrier_right_aux2_x_z = s1_12*s1_20;
  const double R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_20,
      R_carrier_right_aux1_y_y*s1_18);
  const double s1_21 = fma(R_carrier_right_aux1_y_y, s1_20, R_lower_arm_right_z_y*s1_18);
  const double R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_y, s1_18,
      R_lower_arm_right_y_y*s1_20);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_20,
      R_lower_arm_right_y_y*s1_18);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_22 = cosines[9];
  const double s1_23 = sines[9];
  const double R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_23,
      R_carrier_right_aux1_x_x*s1_22);
  const double R_carrier_right_x_z = fma(R_carrier_right_aux2_x_z, s1_22,
      R_carrier_right_aux1_x_x*s1_23);
  const double R_carrier_right_y_x = fma(s1_21, s1_23, R_carrier_right_aux1_y_x*s1_22);
  const double R_carrier_right_y_z = fnma(s1_21, s1_22, R_carrier_right_aux1_y_x*s1_23);
  const double R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_23,
      R_carrier_right_aux1_z_x*s1_22);
  const double R_carrier_right_z_z = fma(R_carrier_right_aux2_z_z, s1_22,
      R_carrier_right_aux1_z_x*s1_23);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = cosines[14];
  const double R_rear_axle_aux5_z_z = cosines[15];
  const double R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_24 = sines[15];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_24;
  const double R_rear_axle_aux4_y_x = sines[14];
  const double R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_24;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_25 = sines[16];
  const double s1_26 = cosines[16];
  const double R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_26, R_rear_axle_aux5_x_z*s1_25);
  const double R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_26, R_rear_axle_aux4_y_x*s1_25);
  const double R_rear_axle_y_y = fma(R_rear_axle_aux5_y_z, s1_25, R_rear_axle_aux4_x_x*s1_26);
  const double R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_25, R_rear_axle_aux5_y_z*s1_26);
  const double R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_25;
  const double R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_26;
  // operations: 34 add, 74 multiply, 38 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  // upper_ball_left
  const double R_upper_arm_left_z_y = sines[4];
  const double R_upper_arm_left_y_y = cosines[4];
  const double s2_1 = -p_upper_arm_left_ball_z*R_upper_arm_left_z_y;
  const double s2_2 = fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s2_1);
  const double s2_3 = -p_carrier_left_upper_ball_y*R_carrier_left_aux2_z_y;
  const double s2_4 = -p_carrier_left_upper_ball_y*R_carrier_left_aux2_y_y;
  const double s2_5 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_6 = fnma(-p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s2_5);
  const double s2_7 = -p_carrier_left_upper_ball_y*s1_7;
  const double s2_8 = fma(p_carrier_left_upper_ball_z, R_carrier_left_x_z, s2_7);
  result.residual[0] = s2_8;
  const double s2_9 = R_lower_arm_left_z_y*s2_8;
  const double s2_10 = fms(p_carrier_left_upper_ball_z, R_carrier_left_z_z, s2_3);
  const double s2_11 = fms(p_carrier_left_upper_ball_z, R_carrier_left_y_z, s2_4);
  const double s2_12 = s1_5 + s2_10;
  const double s2_13 = r_carrier_left_aux1_y + s2_11 - s2_2 - p_upper_arm_left_y;
  result.residual[1] = s2_13;
  const double s2_14 = -p_upper_arm_left_z + (r_carrier_left_aux1_z + s2_10 - s2_6);
  result.residual[2] = s2_14;
  const double s2_15 = fnma(R_carrier_left_aux1_y_x, s2_8, R_carrier_left_aux1_x_x*s2_11);
  const double s2_16 = fnma(R_carrier_left_aux1_z_x, s2_11, R_carrier_left_aux1_y_x*s2_10);
  const double s2_17 = s1_3 + s2_11;
  const double s2_18 = fma(R_carrier_left_aux2_y_y, s2_8, s1_7*s2_11);
  // upper_ball_right
  const double R_upper_arm_right_z_y = sines[10];
  const double R_upper_arm_right_y_y = cosines[10];
  const double s2_19 = -p_upper_arm_right_ball_z*R_upper_arm_right_z_y;
  const double s2_20 = fnma(-p_upper_arm_right_ball_y, R_upper_arm_right_y_y, s2_19);
  const double s2_21 = p_carrier_right_upper_ball_y*s1_19;
  const double s2_22 = fms(p_carrier_right_upper_ball_z, R_carrier_right_x_z, s2_21);
  result.residual[3] = s2_22;
  const double s2_23 = R_lower_arm_right_z_y*s2_22;
  const double s2_24 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_z_y;
  const double s2_25 = fma(p_carrier_right_upper_ball_z, R_carrier_right_z_z, s2_24);
  const double s2_26 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_y_y;
  const double s2_27 = fma(p_carrier_right_upper_ball_z, R_carrier_right_y_z, s2_26);
  const double s2_28 = -p_upper_arm_right_ball_y*R_upper_arm_right_z_y;
  const double s2_29 = fma(-p_upper_arm_right_ball_z, R_upper_arm_right_y_y, s2_28);
  const double s2_30 = s1_16 - s2_25;
  const double s2_31 = -p_upper_arm_right_z + (s2_25 + s2_29 - s1_17);
  result.residual[5] = s2_31;
  const double s2_32 = s1_14 + s2_27;
  const double s2_33 = -p_upper_arm_right_y + (r_carrier_right_aux1_y + s2_27 - s2_20);
  result.residual[4] = s2_33;
  const double s2_34 = fnma(R_carrier_right_aux1_y_x, s2_22, R_carrier_right_aux1_x_x*s2_27);
  const double s2_35 = fma(R_lower_arm_right_y_y, s2_27, R_lower_arm_right_z_y*s2_25);
  const double s2_36 = fma(R_carrier_right_aux2_y_y, s2_22, s1_19*s2_27);
  // arb_link_front_left
  const double R_arb_front_left_x_z = sines[5];
  const double R_arb_front_left_x_x = cosines[5];
  const double s2_37 = -p_arb_link_front_left_from_x*R_arb_front_left_x_z;
  const double s2_38 = fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s2_37);
  const double s2_39 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s2_40 = fnma(-p_arb_link_front_left_from_x, R_arb_front_left_x_x, s2_39);
  const double s2_41 = p_arb_link_front_left_to_x*R_carrier_left_x_x;
  const double s2_42 = fma(-p_arb_link_front_left_to_y, s1_7 + R_carrier_left_x_z, s2_41);
  const double s2_43 = 0.35 + (s2_40 - s2_42);
  const double s2_44 = 3.846153846153846*s2_43;
  const double s2_45 = p_arb_link_front_left_to_x*R_carrier_left_z_x;
  const double s2_46 = R_carrier_left_z_z - R_carrier_left_aux2_z_y;
  const double s2_47 = fma(-p_arb_link_front_left_to_y, s2_46, s2_45);
  const double s2_48 = s2_38 - r_carrier_left_aux1_z - s2_47 - (-p_arb_front_left_z);
  const double s2_49 = 3.846153846153846*s2_48;
  const double pivot_arb_front_left = fnma(s2_40, s2_49, s2_38*s2_44);
  const double s2_50 = p_arb_link_front_left_to_x*R_carrier_left_y_x;
  const double s2_51 = R_carrier_left_y_z - R_carrier_left_aux2_y_y;
  const double s2_52 = fma(-p_arb_link_front_left_to_y, s2_51, s2_50);
  const double s2_53 = 0.72 - r_carrier_left_aux1_y - s2_52;
  const double s2_54 = 3.846153846153846*s2_53;
  const double s2_55 = fnma(s2_47, s2_54, s2_49*s2_52);
  const double s2_56 = fnma(s1_5, s2_54, fma(s1_3, s2_49, s2_55));
  const double s2_57 = fnma(s2_44, s2_52, s2_42*s2_54);
  const double s2_58 = fnma(s2_42, s2_49, s2_44*s2_47);
  const double s2_59 = fma(s2_43, s2_44, fms(s2_53, s2_54, l_arb_link_front_left));
  const double s2_60 = 0.5*fma(s2_48, s2_49, s2_59);
  result.residual[6] = s2_60;
  const double s2_61 = fnma(R_lower_arm_left_z_y, s2_58, R_lower_arm_left_y_y*s2_57);
  const double s2_62 = fma(R_carrier_left_aux1_x_x, s2_55, R_carrier_left_aux1_y_x*s2_58);
  const double s2_63 = fma(R_carrier_left_aux1_z_x, s2_57, s2_62);
  const double s2_64 = fma(R_carrier_left_aux2_z_y, s2_57, R_carrier_left_aux2_y_y*s2_58);
  const double s2_65 = fnma(s1_7, s2_55, s2_64);
  // arb_link_front_right
  const double R_arb_front_right_x_z = sines[11];
  const double R_arb_front_right_x_x = cosines[11];
  const double s2_66 = -p_arb_link_front_right_from_x*R_arb_front_right_x_z;
  const double s2_67 = fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s2_66);
  const double s2_68 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s2_69 = fnma(-p_arb_link_front_right_from_x, R_arb_front_right_x_x, s2_68);
  const double s2_70 = p_arb_link_front_right_to_x*R_carrier_right_x_x;
  const double s2_71 = fma(-p_arb_link_front_left_to_y, R_carrier_right_x_z - s1_19, s2_70);
  const double s2_72 = 0.35 + (s2_69 - s2_71);
  const double s2_73 = 3.846153846153846*s2_72;
  const double s2_74 = p_arb_link_front_right_to_x*R_carrier_right_z_x;
  const double s2_75 = R_carrier_right_aux2_z_y + R_carrier_right_z_z;
  const double s2_76 = fma(-p_arb_link_front_left_to_y, s2_75, s2_74);
  const double s2_77 = s1_17 + s2_67 - s2_76 - (-p_arb_front_right_z);
  const double s2_78 = 3.846153846153846*s2_77;
  const double pivot_arb_front_right = fnma(s2_69, s2_78, s2_67*s2_73);
  const double s2_79 = p_arb_link_front_right_to_x*R_carrier_right_y_x;
  const double s2_80 = R_carrier_right_aux2_y_y + R_carrier_right_y_z;
  const double s2_81 = fma(-p_arb_link_front_left_to_y, s2_80, s2_79);
  const double s2_82 = 0.72 + (r_carrier_right_aux1_y + s2_81);
  const double s2_83 = 3.846153846153846*s2_82;
  const double s2_84 = fma(s2_73, s2_81, s2_71*s2_83);
  const double s2_85 = fma(s2_78, s2_81, s2_76*s2_83);
  const double s2_86 = fnma(s1_16, s2_83, fma(s1_14, s2_78, s2_85));
  const double s2_87 = fnma(s2_71, s2_78, s2_73*s2_76);
  const double s2_88 = fma(s2_72, s2_73, fms(s2_82, s2_83, l_arb_link_front_right));
  const double s2_89 = 0.5*fma(s2_77, s2_78, s2_88);
  result.residual[7] = s2_89;
  const double s2_90 = fma(R_lower_arm_right_y_y, s2_84, R_lower_arm_right_z_y*s2_87);
  const double s2_91 = fma(R_carrier_right_aux1_x_x, s2_85, R_carrier_right_aux1_y_x*s2_87);
  const double s2_92 = fnma(R_carrier_right_aux1_z_x, s2_84, s2_91);
  const double s2_93 = fnma(s1_19, s2_85, R_carrier_right_aux2_y_y*s2_87);
  const double s2_94 = fnma(R_carrier_right_aux2_z_y, s2_84, s2_93);
  // drag_link
  const double s2_95 = -p_drag_link_from_z*sines[12];
  const double s2_96 = -p_drag_link_from_z*cosines[12];
  const double s2_97 = 0.2 - s2_96;
  const double s2_98 = 0.8565801464479954*s2_97;
  const double R_bell_crank_y_x = sines[13];
  const double s2_99 = p_drag_link_to_y*R_bell_crank_y_x;
  const double s2_100 = 1.15 + (s2_99 - s2_95);
  const double s2_101 = 0.8565801464479954*s2_100;
  const double pivot_pitman_arm = fnma(s2_96, s2_101, s2_95*s2_98);
  const double R_bell_crank_x_x = cosines[13];
  const double s2_102 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s2_103 = p_pitman_arm_y - s2_102;
  const double s2_104 = 0.8565801464479954*s2_103;
  const double s2_105 = fma(s2_101, s2_102, s2_99*s2_104);
  const double s2_106 = fma(s2_100, s2_101, fma(s2_97, s2_98, fms(s2_103, s2_104, l_drag_link)));
  const double s2_107 = 0.5*s2_106;
  result.residual[8] = s2_107;
  // tie_rod_left
  const double s2_108 = fma(p_tie_rod_left_to_z, R_carrier_left_x_z, s2_7);
  const double s2_109 = fnma(-p_tie_rod_left_to_x, R_carrier_left_x_x, s2_108);
  const double s2_110 = fms(p_tie_rod_left_to_z, R_carrier_left_z_z, s2_3);
  const double s2_111 = fnma(-p_tie_rod_left_to_x, R_carrier_left_z_x, s2_110);
  const double s2_112 = -p_bell_crank_z + (r_carrier_left_aux1_z + s2_111);
  const double s2_113 = 1.262590031797617*s2_112;
  const double s2_114 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_115 = fma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s2_114);
  const double s2_116 = 0.35 + (s2_109 + s2_115);
  const double s2_117 = 1.262590031797617*s2_116;
  const double s2_118 = fnma(s2_111, s2_117, s2_109*s2_113);
  const double s2_119 = p_tie_rod_left_from_y*R_bell_crank_x_x;
  const double s2_120 = fnma(-p_tie_rod_left_from_x, R_bell_crank_y_x, s2_119);
  const double s2_121 = fms(p_tie_rod_left_to_z, R_carrier_left_y_z, s2_4);
  const double s2_122 = fnma(-p_tie_rod_left_to_x, R_carrier_left_y_x, s2_121);
  const double s2_123 = s2_120 - r_carrier_left_aux1_y - s2_122;
  const double s2_124 = 1.262590031797617*s2_123;
  const double s2_125 = fma(s2_117, s2_122, s2_109*s2_124);
  const double s2_126 = fma(s2_113, s2_122, s2_111*s2_124);
  const double s2_127 = fma(R_carrier_left_aux1_z_x, s2_125, R_carrier_left_aux1_y_x*s2_118);
  const double s2_128 = fnma(R_carrier_left_aux1_x_x, s2_126, s2_127);
  const double s2_129 = fnma(s2_117, s2_120, s2_115*s2_124);
  const double s2_130 = fma(s1_5, s2_124, fma(s1_3, s2_113, s2_126));
  const double s2_131 = fma(s2_112, s2_113, fms(s2_123, s2_124, l_tie_rod_left));
  const double s2_132 = 0.5*fma(s2_116, s2_117, s2_131);
  result.residual[9] = s2_132;
  const double s2_133 = fnma(R_lower_arm_left_z_y, s2_118, R_lower_arm_left_y_y*s2_125);
  const double s2_134 = fma(s1_7, s2_126, R_carrier_left_aux2_y_y*s2_118);
  const double s2_135 = fma(R_carrier_left_aux2_z_y, s2_125, s2_134);
  // tie_rod_right
  const double s2_136 = fma(p_tie_rod_right_to_z, R_carrier_right_z_z, s2_24);
  const double s2_137 = fnma(-p_tie_rod_right_to_x, R_carrier_right_z_x, s2_136);
  const double s2_138 = fnma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s2_114);
  const double s2_139 = fms(p_tie_rod_right_to_z, R_carrier_right_x_z, s2_21);
  const double s2_140 = fnma(-p_tie_rod_right_to_x, R_carrier_right_x_x, s2_139);
  const double s2_141 = s2_138 - s2_140 - 0.35;
  const double s2_142 = 1.262590031797617*s2_141;
  const double s2_143 = -p_bell_crank_z + (s2_137 - s1_17);
  const double s2_144 = 1.262590031797617*s2_143;
  const double s2_145 = fma(s2_140, s2_144, s2_137*s2_142);
  const double s2_146 = fma(p_tie_rod_right_to_z, R_carrier_right_y_z, s2_26);
  const double s2_147 = fnma(-p_tie_rod_right_to_x, R_carrier_right_y_x, s2_146);
  const double s2_148 = fma(-p_tie_rod_left_from_x, R_bell_crank_y_x, s2_119);
  const double s2_149 = s2_148 + (r_carrier_right_aux1_y + s2_147);
  const double s2_150 = 1.262590031797617*s2_149;
  const double s2_151 = fma(s2_140, s2_150, s2_142*s2_147);
  const double pivot_carrier_right_rz = fma(R_lower_arm_right_y_y, s2_151,
      R_lower_arm_right_z_y*s2_145);
  const double s2_152 = fnma(s2_138, s2_150, s2_142*s2_148);
  const double s2_153 = fnma(s2_144, s2_147, s2_137*s2_150);
  const double s2_154 = fnma(s1_16, s2_150, fnma(s1_14, s2_144, s2_153));
  const double s2_155 = fma(s2_143, s2_144, fms(s2_149, s2_150, l_tie_rod_right));
  const double s2_156 = 0.5*fma(s2_141, s2_142, s2_155);
  result.residual[10] = s2_156;
  const double s2_157 = fma(R_carrier_right_aux1_x_x, s2_153, R_carrier_right_aux1_y_x*s2_145);
  const double s2_158 = fnma(R_carrier_right_aux1_z_x, s2_151, s2_157);
  const double s2_159 = fnma(s1_19, s2_153, R_carrier_right_aux2_y_y*s2_145);
  const double s2_160 = fnma(R_carrier_right_aux2_z_y, s2_151, s2_159);
  const double s2_161 = 1.0/pivot_carrier_right_rz;
  const double s2_162 = s2_35*s2_161;
  const double s2_163 = fnma(R_carrier_right_aux2_z_y, s2_27, R_carrier_right_aux2_y_y*s2_25);
  const double pivot_carrier_right_ry = fnma(s2_160, s2_162, s2_163);
  const double s2_164 = 1.0/s2_20;
  const double s2_165 = s2_29*s2_164;
  const double s2_166 = s2_161*fnma(s2_23, s2_165, R_lower_arm_right_y_y*s2_22);
  const double s2_167 = fnma(R_carrier_right_aux1_z_x, s2_27, R_carrier_right_aux1_y_x*s2_25);
  const double s2_168 = fnma(s2_158, s2_162, s2_167);
  const double s2_169 = 1.0/pivot_carrier_right_ry;
  const double s2_170 = fma(s2_36, s2_165, fma(R_carrier_right_aux2_z_y, s2_22, s1_19*s2_25));
  const double s2_171 = s2_169*fma(s2_160, s2_166, s2_170);
  const double s2_172 = fnma(R_carrier_right_aux1_x_x, s2_25, R_carrier_right_aux1_z_x*s2_22);
  const double pivot_carrier_right_rx = fnma(s2_168, s2_171, fma(s2_158, s2_166, fnma(s2_34, s2_165,
      s2_172)));
  const double s2_173 = 1.0/s2_2;
  const double s2_174 = s2_6*s2_173;
  const double s2_175 = 1.0/s2_128;
  const double s2_176 = fnma(R_carrier_left_aux1_x_x, s2_10, R_carrier_left_aux1_z_x*s2_8);
  const double s2_177 = s2_175*fma(s2_15, s2_174, s2_176);
  const double s2_178 = fnma(s2_18, s2_174, fma(R_carrier_left_aux2_z_y, s2_8, s1_7*s2_10));
  const double pivot_carrier_left_ry = fnma(s2_135, s2_177, s2_178);
  const double s2_179 = s2_16*s2_175;
  const double s2_180 = fnma(s2_133, s2_177, fma(s2_9, s2_174, R_lower_arm_left_y_y*s2_8));
  const double s2_181 = fnma(R_carrier_left_aux2_z_y, s2_11, R_carrier_left_aux2_y_y*s2_10);
  const double s2_182 = 1.0/pivot_carrier_left_ry;
  const double s2_183 = fnma(s2_135, s2_179, s2_181)*s2_182;
  const double s2_184 = fma(R_lower_arm_left_y_y, s2_11, R_lower_arm_left_z_y*s2_10);
  const double s2_185 = fma(s2_180, s2_183, fma(s2_133, s2_179, s2_184));
  const double s2_186 = 1.0/pivot_arb_front_left;
  const double s2_187 = 1.0/pivot_arb_front_right;
  const double s2_188 = 1.0/pivot_pitman_arm;
  const double s2_189 = 1.0/pivot_carrier_right_rx;
  const double s2_190 = 1.0/s2_185;
  const double s2_191 = 4.291271972095581*std::abs(pivot_arb_front_right);
  const double s2_192 = mbgen::min(s2_191, 4.625980413576839*std::abs(pivot_pitman_arm));
  const double s2_193 = mbgen::min(4.336650753223258*std::abs(pivot_arb_front_left), s2_192);
  const double s2_194 = mbgen::min(3.3503257942070226*std::abs(s2_20), s2_193);
  const double s2_195 = mbgen::min(5.556930741705859*std::abs(pivot_carrier_right_rz), s2_194);
  const double s2_196 = mbgen::min(2.6620449619787987*std::abs(pivot_carrier_right_ry), s2_195);
  const double s2_197 = mbgen::min(s2_196, 2.732781487945307*std::abs(pivot_carrier_right_rx));
  const double s2_198 = mbgen::min(3.3514772255331233*std::abs(s2_2), s2_197);
  const double s2_199 = mbgen::min(15.714736645766752*std::abs(s2_128), s2_198);
  const double s2_200 = mbgen::min(5.864463449986124*std::abs(pivot_carrier_left_ry), s2_199);
  result.pivot[0] = mbgen::min(0.43888841273380513*std::abs(s2_185), s2_200);

  // --- step 4: velocities ---
  // loop block 0
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s4_1 = zd_lower_arm_left*s2_17;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s4_2 = zd_lower_arm_right*s2_32;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  result.dz[Coordinate::pitman_arm] = -(s2_107*s2_188);
  const double s4_3 = fma(s2_156, s2_162, s2_22);
  result.zd[Coordinate::pitman_arm] = -(s2_188*(zd_bell_crank*s2_105));
  const double s4_4 = fma(s2_132, s2_177, fma(s2_14, s2_174, s2_13));
  const double s4_5 = fnma(zd_lower_arm_left, s2_130, zd_bell_crank*s2_129);
  const double s4_6 = fnma(zd_bell_crank, s2_152, zd_lower_arm_right*s2_154);
  const double s4_7 = s2_162*s4_6;
  const double s4_8 = s2_189*fma(s2_31, s2_165, fma(s2_156, s2_166, fms(s2_171, s4_3, s2_33)));
  result.dz[Coordinate::carrier_right_rx] = s4_8;
  const double s4_9 = s2_190*fnma(s2_132, s2_179, fms(s2_183, s4_4, s2_8));
  result.dz[Coordinate::carrier_left_rz] = -s4_9;
  const double s4_10 = fnma(s2_166, s4_6, fnma(zd_lower_arm_right, s2_30, s2_165*s4_2));
  const double s4_11 = s2_189*fnma(s2_171, s4_7, s4_10);
  result.zd[Coordinate::carrier_right_rx] = s4_11;
  const double s4_12 = fnma(s2_174, s4_1, fma(zd_lower_arm_left, s2_12, s2_177*s4_5));
  const double s4_13 = s2_190*fnma(s2_183, s4_12, s2_179*s4_5);
  result.zd[Coordinate::carrier_left_rz] = -s4_13;
  const double s4_14 = s2_169*fma(s2_168, s4_8, s4_3);
  result.dz[Coordinate::carrier_right_ry] = -s4_14;
  const double s4_15 = s2_182*fms(s2_180, s4_9, s4_4);
  result.dz[Coordinate::carrier_left_ry] = s4_15;
  const double s4_16 = s2_169*fnma(s2_168, s4_11, s4_7);
  result.zd[Coordinate::carrier_right_ry] = s4_16;
  const double s4_17 = s2_182*fma(s2_180, s4_13, s4_12);
  result.zd[Coordinate::carrier_left_ry] = s4_17;
  const double s4_18 = s2_175*fnma(s2_133, s4_9, fms(s2_135, s4_15, s2_132));
  result.dz[Coordinate::carrier_left_rx] = -s4_18;
  const double s4_19 = s2_161*fnma(s2_160, s4_14, fms(s2_158, s4_8, s2_156));
  result.dz[Coordinate::carrier_right_rz] = s4_19;
  const double s4_20 = s2_175*fnma(s2_133, s4_13, fma(s2_135, s4_17, s4_5));
  result.zd[Coordinate::carrier_left_rx] = -s4_20;
  const double s4_21 = s2_161*fma(s2_160, s4_16, fma(s2_158, s4_11, s4_6));
  result.zd[Coordinate::carrier_right_rz] = s4_21;
  result.dz[Coordinate::upper_arm_right] = s2_164*fma(s2_34, s4_8, fma(s2_36, s4_14, fma(s2_23,
      s4_19, s2_31)));
  result.dz[Coordinate::arb_front_right] = s2_187*fnma(s2_94, s4_14, fnma(s2_90, s4_19, fms(s2_92,
      s4_8, s2_89)));
  result.dz[Coordinate::arb_front_left] = s2_186*fnma(s2_61, s4_9, fnma(s2_63, s4_18, fms(s2_65,
      s4_15, s2_60)));
  const double s4_22 = fma(zd_lower_arm_right, s2_86, fma(s2_94, s4_16, s2_92*s4_11));
  result.zd[Coordinate::arb_front_right] = s2_187*fnma(s2_90, s4_21, s4_22);
  const double s4_23 = fnma(s2_63, s4_20, fma(zd_lower_arm_left, s2_56, s2_65*s4_17));
  result.zd[Coordinate::arb_front_left] = s2_186*fnma(s2_61, s4_13, s4_23);
  result.dz[Coordinate::upper_arm_left] = -(s2_173*fma(s2_15, s4_18, fma(s2_18, s4_15, fms(s2_9,
      s4_9, s2_14))));
  const double s4_24 = s2_164*fnma(s2_34, s4_11, fnma(s2_23, s4_21, fms(s2_36, s4_16, s4_2)));
  result.zd[Coordinate::upper_arm_right] = -s4_24;
  result.zd[Coordinate::upper_arm_left] = -(s2_173*fma(s2_15, s4_20, fma(s2_18, s4_17, fms(s2_9,
      s4_13, s4_1))));

  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  // long_rod_left
  const double s2_201 = fma(-p_long_rod_left_to_z, R_rear_axle_z_z, p_long_rod_left_to_x*s1_24);
  const double s2_202 = fms(p_long_rod_left_to_y, R_rear_axle_z_y, s2_201);
  const double s2_203 = -p_long_rod_left_from_z + (r_rear_axle_aux3_z + s2_202);
  const double s2_204 = p_long_rod_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_205 = fnma(-p_long_rod_left_to_z, R_rear_axle_x_z, s2_204);
  const double s2_206 = fma(p_long_rod_left_to_y, R_rear_axle_x_y, s2_205);
  const double s2_207 = -p_long_rod_left_from_x + (r_rear_axle_aux1_x + s2_206);
  const double s2_208 = 1.1757385222540735*s2_203;
  const double s2_209 = 1.1757385222540735*s2_207;
  const double s2_210 = p_long_rod_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_211 = fnma(-p_long_rod_left_to_z, R_rear_axle_y_z, s2_210);
  const double s2_212 = fma(p_long_rod_left_to_y, R_rear_axle_y_y, s2_211);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_213 = p_long_rod_left_from_y - z_rear_axle_ty - s2_212;
  const double s2_214 = 1.1757385222540735*s2_213;
  const double s2_215 = fma(s2_202, s2_214, s2_208*s2_212);
  const double s2_216 = fma(s2_206, s2_214, s2_209*s2_212);
  const double s2_217 = fnma(s2_202, s2_209, s2_206*s2_208);
  const double s2_218 = fma(s2_203, s2_208, fms(s2_213, s2_214, l_long_rod_left));
  const double s2_219 = 0.5*fma(s2_207, s2_209, s2_218);
  result.residual[11] = s2_219;
  const double s2_220 = fnma(s1_24, s2_216, R_rear_axle_aux5_y_x*s2_217);
  const double s2_221 = fnma(R_rear_axle_aux5_x_x, s2_215, s2_220);
  // diag_rod_left
  const double s2_222 = p_diag_rod_left_to_y*R_rear_axle_z_y;
  const double s2_223 = fma(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_222);
  const double s2_224 = -p_diag_rod_left_from_z + (r_rear_axle_aux3_z + s2_223);
  const double s2_225 = p_diag_rod_left_to_z*R_rear_axle_x_z;
  const double s2_226 = fma(p_diag_rod_left_to_y, R_rear_axle_x_y, s2_225);
  const double s2_227 = -p_diag_rod_left_from_x + (r_rear_axle_aux1_x + s2_226);
  const double s2_228 = 1.162476387438193*s2_224;
  const double s2_229 = 1.162476387438193*s2_227;
  const double s2_230 = p_diag_rod_left_to_y*R_rear_axle_y_y;
  const double s2_231 = fma(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_230);
  const double s2_232 = p_diag_rod_left_from_y - z_rear_axle_ty - s2_231;
  const double s2_233 = 1.162476387438193*s2_232;
  const double s2_234 = fma(s2_223, s2_233, s2_228*s2_231);
  const double s2_235 = fma(s2_226, s2_233, s2_229*s2_231);
  const double s2_236 = fnma(s2_223, s2_229, s2_226*s2_228);
  const double s2_237 = fma(s2_224, s2_228, fms(s2_232, s2_233, l_diag_rod_left));
  const double s2_238 = 0.5*fma(s2_227, s2_229, s2_237);
  result.residual[12] = s2_238;
  const double s2_239 = fnma(s1_24, s2_235, R_rear_axle_aux5_y_x*s2_236);
  const double s2_240 = fnma(R_rear_axle_aux5_x_x, s2_234, s2_239);
  // arb_link_rear_left
  const double s2_241 = p_arb_link_rear_left_from_x*cosines[17];
  const double s2_242 = p_arb_link_rear_left_from_x*sines[17];
  const double s2_243 = -p_arb_link_rear_left_to_x*s1_24;
  const double s2_244 = fnma(-p_arb_link_rear_left_to_z, R_rear_axle_z_z, s2_243);
  const double s2_245 = fma(p_arb_link_rear_left_to_y, R_rear_axle_z_y, s2_244);
  const double s2_246 = -p_arb_rear_left_z + (s2_242 + (r_rear_axle_aux3_z + s2_245));
  const double s2_247 = 4.47213595499958*s2_246;
  const double s2_248 = -p_arb_link_rear_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_249 = fma(-p_arb_link_rear_left_to_z, R_rear_axle_x_z, s2_248);
  const double s2_250 = fms(p_arb_link_rear_left_to_y, R_rear_axle_x_y, s2_249);
  const double s2_251 = s2_241 - r_rear_axle_aux1_x - s2_250 - (-p_arb_rear_left_x);
  const double s2_252 = 4.47213595499958*s2_251;
  const double pivot_arb_rear_left = fnma(s2_242, s2_252, s2_241*s2_247);
  const double s2_253 = -p_arb_link_rear_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_254 = fma(-p_arb_link_rear_left_to_z, R_rear_axle_y_z, s2_253);
  const double s2_255 = fms(p_arb_link_rear_left_to_y, R_rear_axle_y_y, s2_254);
  const double s2_256 = 0.6 - z_rear_axle_ty - s2_255;
  const double s2_257 = 4.47213595499958*s2_256;
  const double s2_258 = fma(s2_245, s2_257, s2_247*s2_255);
  const double s2_259 = fnma(s2_252, s2_255, s2_250*s2_257);
  const double s2_260 = fma(s2_245, s2_252, s2_247*s2_250);
  const double s2_261 = fma(s2_246, s2_247, fms(s2_256, s2_257, l_arb_link_rear_left));
  const double s2_262 = 0.5*fma(s2_251, s2_252, s2_261);
  result.residual[13] = s2_262;
  const double s2_263 = fma(R_rear_axle_aux4_x_x, s2_260, R_rear_axle_aux4_y_x*s2_258);
  const double s2_264 = fnma(s1_24, s2_259, R_rear_axle_aux5_y_x*s2_260);
  const double s2_265 = fnma(R_rear_axle_aux5_x_x, s2_258, s2_264);
  // long_rod_right
  const double s2_266 = fma(p_long_rod_left_to_y, R_rear_axle_z_y, s2_201);
  const double s2_267 = fnma(p_long_rod_left_to_y, R_rear_axle_y_y, s2_211);
  const double s2_268 = -p_long_rod_right_from_y + (z_rear_axle_ty + s2_267);
  const double s2_269 = -p_long_rod_right_from_z + (r_rear_axle_aux3_z - s2_266);
  const double s2_270 = fnma(p_long_rod_left_to_y, R_rear_axle_x_y, s2_205);
  const double s2_271 = -p_long_rod_right_from_x + (r_rear_axle_aux1_x + s2_270);
  const double s2_272 = 1.1757385222540735*s2_268;
  const double s2_273 = 1.1757385222540735*s2_269;
  const double s2_274 = 1.1757385222540735*s2_271;
  const double s2_275 = fma(s2_266, s2_272, s2_267*s2_273);
  const double s2_276 = fnma(s2_270, s2_272, s2_267*s2_274);
  const double s2_277 = fma(s2_266, s2_274, s2_270*s2_273);
  const double s2_278 = fma(s2_269, s2_273, fms(s2_268, s2_272, l_long_rod_right));
  const double s2_279 = 0.5*fma(s2_271, s2_274, s2_278);
  result.residual[14] = s2_279;
  const double s2_280 = fnma(s1_24, s2_276, R_rear_axle_aux5_y_x*s2_277);
  const double s2_281 = fnma(R_rear_axle_aux5_x_x, s2_275, s2_280);
  // diag_rod_right
  const double s2_282 = fnma(p_diag_rod_left_to_y, R_rear_axle_x_y, s2_225);
  const double s2_283 = -p_diag_rod_right_from_x + (r_rear_axle_aux1_x + s2_282);
  const double pivot_rear_axle_tx = 1.162476387438193*s2_283;
  const double s2_284 = fms(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_222);
  const double s2_285 = -p_diag_rod_right_from_z + (r_rear_axle_aux3_z + s2_284);
  const double s2_286 = fms(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_230);
  const double s2_287 = -p_diag_rod_right_from_y + (z_rear_axle_ty + s2_286);
  const double s2_288 = 1.162476387438193*s2_285;
  const double s2_289 = 1.162476387438193*s2_287;
  const double s2_290 = fnma(s2_282, s2_289, pivot_rear_axle_tx*s2_286);
  const double s2_291 = fnma(pivot_rear_axle_tx, s2_284, s2_282*s2_288);
  const double s2_292 = fnma(s2_286, s2_288, s2_284*s2_289);
  const double s2_293 = fma(s2_285, s2_288, fms(s2_287, s2_289, l_diag_rod_right));
  const double s2_294 = 0.5*fma(s2_283, pivot_rear_axle_tx, s2_293);
  result.residual[15] = s2_294;
  const double s2_295 = fnma(R_rear_axle_aux4_y_x, s2_292, R_rear_axle_aux4_x_x*s2_291);
  const double s2_296 = fma(R_rear_axle_aux5_x_x, s2_292, R_rear_axle_aux5_y_x*s2_291);
  const double s2_297 = fnma(s1_24, s2_290, s2_296);
  // arb_link_rear_right
  const double s2_298 = p_arb_link_rear_right_from_x*cosines[18];
  const double s2_299 = fnma(p_arb_link_rear_left_to_y, R_rear_axle_z_y, s2_244);
  const double s2_300 = p_arb_link_rear_right_from_x*sines[18];
  const double s2_301 = -p_arb_rear_right_z + (s2_299 + (r_rear_axle_aux3_z + s2_300));
  const double s2_302 = 4.47213595499958*s2_301;
  const double s2_303 = fma(p_arb_link_rear_left_to_y, R_rear_axle_x_y, s2_249);
  const double s2_304 = s2_298 + s2_303 - r_rear_axle_aux1_x - (-p_arb_rear_right_x);
  const double s2_305 = 4.47213595499958*s2_304;
  const double pivot_arb_rear_right = fnma(s2_300, s2_305, s2_298*s2_302);
  const double s2_306 = fma(p_arb_link_rear_left_to_y, R_rear_axle_y_y, s2_254);
  const double s2_307 = 0.6 + (z_rear_axle_ty - s2_306);
  const double s2_308 = 4.47213595499958*s2_307;
  const double s2_309 = fma(s2_303, s2_308, s2_305*s2_306);
  const double s2_310 = fnma(s2_302, s2_303, s2_299*s2_305);
  const double s2_311 = fma(s2_302, s2_306, s2_299*s2_308);
  const double s2_312 = fma(s2_301, s2_302, fms(s2_307, s2_308, l_arb_link_rear_right));
  const double s2_313 = 0.5*fma(s2_304, s2_305, s2_312);
  result.residual[16] = s2_313;
  const double s2_314 = fnma(R_rear_axle_aux4_y_x, s2_311, R_rear_axle_aux4_x_x*s2_310);
  const double s2_315 = fma(R_rear_axle_aux5_x_x, s2_311, R_rear_axle_aux5_y_x*s2_310);
  const double s2_316 = fnma(s1_24, s2_309, s2_315);
  const double s2_317 = 1.0/pivot_rear_axle_tx;
  const double s2_318 = s2_209*s2_317;
  const double pivot_rear_axle_rz = fms(s2_290, s2_318, s2_216);
  const double s2_319 = s2_274*s2_317;
  const double s2_320 = fnma(R_rear_axle_aux4_y_x, s2_215, s2_295*s2_318);
  const double s2_321 = fnma(R_rear_axle_aux4_x_x, s2_217, s2_320);
  const double s2_322 = 1.0/pivot_rear_axle_rz;
  const double s2_323 = fms(s2_290, s2_319, s2_276)*s2_322;
  const double s2_324 = fnma(R_rear_axle_aux4_y_x, s2_275, s2_295*s2_319);
  const double pivot_rear_axle_ry = fnma(s2_321, s2_323, fnma(R_rear_axle_aux4_x_x, s2_277,
      s2_324));
  const double s2_325 = fma(s2_289, s2_318, s2_214);
  const double s2_326 = s2_229*s2_317;
  const double s2_327 = s2_322*fms(s2_290, s2_326, s2_235);
  const double s2_328 = fma(s2_323, s2_325, fnma(s2_289, s2_319, s2_272));
  const double s2_329 = fnma(R_rear_axle_aux4_y_x, s2_234, s2_295*s2_326);
  const double s2_330 = 1.0/pivot_rear_axle_ry;
  const double s2_331 = fnma(s2_321, s2_327, fnma(R_rear_axle_aux4_x_x, s2_236, s2_329))*s2_330;
  const double pivot_rear_axle_ty = fnma(s2_328, s2_331, fnma(s2_289, s2_326, fms(s2_325, s2_327,
      s2_233)));
  const double s2_332 = 1.0/pivot_arb_rear_left;
  const double s2_333 = 1.0/pivot_arb_rear_right;
  const double s2_334 = 1.0/pivot_rear_axle_ty;
  const double s2_335 = 3.204642123170383*std::abs(pivot_arb_rear_right);
  const double s2_336 = mbgen::min(3.194382824999693*std::abs(pivot_arb_rear_left), s2_335);
  const double s2_337 = mbgen::min(1.0748203921841*std::abs(pivot_rear_axle_tx), s2_336);
  const double s2_338 = mbgen::min(s2_337, 1.5318884572025857*std::abs(pivot_rear_axle_rz));
  const double s2_339 = mbgen::min(s2_338, 1.7893247478820993*std::abs(pivot_rear_axle_ry));
  result.pivot[1] = mbgen::min(s2_339, 1.4337752588788297*std::abs(pivot_rear_axle_ty));
  // operations: 313 add, 415 multiply, 17 divide, 32 other

  // --- step 4: velocities, continued ---
  // loop block 1
  const double s4_25 = fms(s2_294, s2_318, s2_219);
  const double s4_26 = fnma(s2_323, s4_25, fms(s2_294, s2_319, s2_279));
  const double s4_27 = fnma(s2_331, s4_26, fnma(s2_327, s4_25, fms(s2_294, s2_326, s2_238)));
  const double s4_28 = s2_334*s4_27;
  result.dz[Coordinate::rear_axle_ty] = s4_28;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s4_29 = fnma(zd_rear_axle_tz, s2_288, zd_rear_axle_rx*s2_297);
  const double s4_30 = fnma(zd_rear_axle_tz, s2_208, zd_rear_axle_rx*s2_221);
  const double s4_31 = fnma(s2_318, s4_29, s4_30);
  const double s4_32 = fnma(zd_rear_axle_tz, s2_273, zd_rear_axle_rx*s2_281);
  const double s4_33 = fnma(s2_323, s4_31, fnma(s2_319, s4_29, s4_32));
  const double s4_34 = fnma(zd_rear_axle_tz, s2_228, zd_rear_axle_rx*s2_240);
  const double s4_35 = fnma(s2_331, s4_33, fnma(s2_327, s4_31, fnma(s2_326, s4_29, s4_34)));
  const double s4_36 = s2_334*s4_35;
  result.zd[Coordinate::rear_axle_ty] = s4_36;
  const double s4_37 = s2_330*fnma(s2_328, s4_28, s4_26);
  result.dz[Coordinate::rear_axle_ry] = s4_37;
  const double s4_38 = s2_330*fnma(s2_328, s4_36, s4_33);
  result.zd[Coordinate::rear_axle_ry] = s4_38;
  const double s4_39 = s2_322*fnma(s2_321, s4_37, fma(s2_325, s4_28, s4_25));
  result.dz[Coordinate::rear_axle_rz] = s4_39;
  const double s4_40 = s2_322*fnma(s2_321, s4_38, fma(s2_325, s4_36, s4_31));
  result.zd[Coordinate::rear_axle_rz] = s4_40;
  const double s4_41 = fnma(s2_289, s4_28, fma(s2_290, s4_39, fms(s2_295, s4_37, s2_294)));
  const double s4_42 = s2_317*s4_41;
  result.dz[Coordinate::rear_axle_tx] = s4_42;
  const double s4_43 = fnma(s2_289, s4_36, fma(s2_290, s4_40, fma(s2_295, s4_38, s4_29)));
  const double s4_44 = s2_317*s4_43;
  result.zd[Coordinate::rear_axle_tx] = s4_44;
  const double s4_45 = fma(s2_259, s4_39, fma(s2_263, s4_37, fms(s2_257, s4_28, s2_262)));
  result.dz[Coordinate::arb_rear_left] = s2_332*fma(s2_252, s4_42, s4_45);
  const double s4_46 = fma(s2_305, s4_42, fma(s2_309, s4_39, fms(s2_314, s4_37, s2_313)));
  result.dz[Coordinate::arb_rear_right] = s2_333*fnma(s2_308, s4_28, s4_46);
  const double s4_47 = fma(s2_252, s4_44, fma(s2_259, s4_40, fma(s2_263, s4_38, s2_257*s4_36)));
  const double s4_48 = fnma(zd_rear_axle_tz, s2_247, fma(zd_rear_axle_rx, s2_265, s4_47));
  result.zd[Coordinate::arb_rear_left] = s2_332*s4_48;
  const double s4_49 = fma(s2_305, s4_44, fma(s2_309, s4_40, s2_314*s4_38));
  const double s4_50 = fnma(zd_rear_axle_tz, s2_302, fma(zd_rear_axle_rx, s2_316, s4_49));
  result.zd[Coordinate::arb_rear_right] = s2_333*fnma(s2_308, s4_36, s4_50);
  // operations: 98 add, 149 multiply
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
      sines[22], cosines[22], R_carrier_left_aux1_y_x, R_carrier_left_aux1_z_x, s1_8,
      r_carrier_left_aux1_y, s1_10, r_carrier_left_aux1_z, s1_12, R_carrier_left_aux2_y_y,
      R_carrier_left_aux2_z_y, R_carrier_left_x_x, R_carrier_left_x_z, R_carrier_left_y_x,
      R_carrier_left_y_z, R_carrier_left_z_x, R_carrier_left_z_z, s1_18, s1_20, s1_22,
      R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x, s1_25, r_carrier_right_aux1_y, s1_27,
      s1_28, s1_30, R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, R_carrier_right_x_x,
      R_carrier_right_x_z, R_carrier_right_y_x, R_carrier_right_y_z, R_carrier_right_z_x,
      R_carrier_right_z_z, s1_38, s1_40, s1_42, r_rear_axle_aux1_x, r_rear_axle_aux3_z,
      R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y,
      R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z, s1_46, s1_47, s1_48, s1_53, s1_55, s1_56,
      s1_57, s1_58, s1_64, s1_66, s1_67, s1_68, s1_71, s1_72, s1_73, s1_75, s1_77, s1_78, s1_79,
      s1_80, s1_81, w_chassis_x, w_chassis_y, w_chassis_z, w_carrier_left_x, w_carrier_left_y,
      w_carrier_left_z, w_wheel_front_left_x, w_wheel_front_left_y, w_wheel_front_left_z,
      w_arb_front_left_y, w_carrier_right_x, w_carrier_right_y, w_carrier_right_z,
      w_wheel_front_right_x, w_wheel_front_right_y, w_wheel_front_right_z, w_arb_front_right_y,
      w_rear_axle_x, w_rear_axle_y, w_rear_axle_z, w_wheel_rear_left_x, w_wheel_rear_left_y,
      w_wheel_rear_left_z, w_arb_rear_left_y, w_wheel_rear_right_x, w_wheel_rear_right_y,
      w_wheel_rear_right_z, w_arb_rear_right_y, a_chassis_x, a_chassis_y, a_chassis_z, s7_11, s7_12,
      s7_13, s7_14, s7_15, s7_16, s7_17, s7_18, s7_19, s7_21, a_lower_arm_left_y, s7_26,
      a_lower_arm_left_z, alpha_lower_arm_left_x, s7_27, s7_28, s7_29, s7_30, a_carrier_left_aux1_x,
      a_carrier_left_aux1_y, a_carrier_left_aux1_z, alpha_carrier_left_x, alpha_carrier_left_y,
      alpha_carrier_left_z, s7_50, s7_51, s7_52, s7_53, s7_54, s7_55, s7_56, s7_57, s7_58,
      a_wheel_front_left_x, a_wheel_front_left_y, a_wheel_front_left_z, alpha_wheel_front_left_x,
      alpha_wheel_front_left_y, alpha_wheel_front_left_z, a_upper_arm_left_y, a_upper_arm_left_z,
      alpha_upper_arm_left_x, s7_71, s7_72, s7_73, s7_74, a_arb_front_left_x, a_arb_front_left_z,
      alpha_arb_front_left_x, alpha_arb_front_left_y, alpha_arb_front_left_z, s7_83, s7_84, s7_85,
      s7_86, s7_88, s7_89, a_lower_arm_right_y, a_lower_arm_right_z, alpha_lower_arm_right_x, s7_91,
      s7_92, s7_93, s7_94, a_carrier_right_aux1_x, a_carrier_right_aux1_y, a_carrier_right_aux1_z,
      alpha_carrier_right_x, alpha_carrier_right_y, alpha_carrier_right_z, s7_116, s7_117, s7_118,
      s7_119, s7_120, s7_121, s7_122, s7_123, s7_124, a_wheel_front_right_x, a_wheel_front_right_y,
      a_wheel_front_right_z, alpha_wheel_front_right_x, alpha_wheel_front_right_y,
      alpha_wheel_front_right_z, a_upper_arm_right_y, a_upper_arm_right_z, alpha_upper_arm_right_x,
      s7_134, s7_135, s7_136, s7_137, a_arb_front_right_x, a_arb_front_right_z,
      alpha_arb_front_right_x, alpha_arb_front_right_y, alpha_arb_front_right_z, s7_138, s7_139,
      s7_140, s7_141, s7_143, s7_144, a_pitman_arm_x, a_pitman_arm_z, alpha_pitman_arm_y, s7_150,
      s7_151, s7_152, s7_153, a_bell_crank_x, a_bell_crank_y, a_bell_crank_z, alpha_bell_crank_z,
      s7_159, s7_160, s7_161, s7_162, s7_163, s7_164, a_rear_axle_aux3_x, a_rear_axle_aux3_y,
      a_rear_axle_aux3_z, alpha_rear_axle_x, alpha_rear_axle_y, alpha_rear_axle_z, s7_189, s7_190,
      s7_191, s7_192, s7_193, s7_194, s7_195, s7_196, s7_197, a_wheel_rear_left_x,
      a_wheel_rear_left_y, a_wheel_rear_left_z, alpha_wheel_rear_left_x, alpha_wheel_rear_left_y,
      alpha_wheel_rear_left_z, a_arb_rear_left_x, a_arb_rear_left_y, a_arb_rear_left_z,
      alpha_arb_rear_left_x, alpha_arb_rear_left_y, alpha_arb_rear_left_z, s7_207, s7_208, s7_209,
      s7_210, s7_211, s7_212, s7_213, s7_214, a_wheel_rear_right_x, a_wheel_rear_right_y,
      a_wheel_rear_right_z, alpha_wheel_rear_right_x, alpha_wheel_rear_right_y,
      alpha_wheel_rear_right_z, a_arb_rear_right_x, a_arb_rear_right_y, a_arb_rear_right_z,
      alpha_arb_rear_right_x, alpha_arb_rear_right_y, alpha_arb_rear_right_z, s7_220, s7_221,
      s7_222, s7_223, s7_224, s7_225, s7_226, s7_227, s7_229, s7_231, s7_234, s7_237, s7_240,
      s7_243, s7_246, s7_249, s7_252, s7_255, s7_257, s7_259, s7_262, s7_265, s7_268, s7_271,
      s7_275, s7_279, s7_282, s7_285, s7_286, s7_287, s7_288, s7_289, s7_291, s7_293, s7_295,
      s7_296, s7_297, s7_298, s7_301, s7_302, s7_303, s7_305, s7_307, s7_309, s7_322, s7_323,
      s7_324, s7_326, s7_327, s7_329, s7_330, s7_332, s7_349, s7_352, s7_355, s7_367, s7_369,
      s7_371, s7_380, s7_385, s7_388, s7_389, s7_390, s7_406, s7_407, s7_408, s7_412, s7_413,
      s7_414, s7_421, s7_422, s7_423, s7_424, s7_425, s7_596, s7_599, s7_602, Q_rear_axle_tz,
      Q_rear_axle_ty, Q_rear_axle_tx, Q_pitman_arm, Q_arb_front_right, Q_upper_arm_right, s7_775,
      s7_778, s7_781, Q_arb_front_left, Q_upper_arm_left, s7_937, s7_940, Q_lower_arm_left;
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
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_x_x = work.cosines[0];
  const double R_chassis_aux5_z_z = work.cosines[1];
  const double R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  const double R_chassis_aux4_y_x = work.sines[0];
  const double R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s1_1 = work.sines[1];
  const double s1_2 = work.sines[2];
  const double s1_3 = s1_1*s1_2;
  const double s1_4 = work.cosines[2];
  const double R_chassis_x_y = fnma(R_chassis_aux4_y_x, s1_4, R_chassis_aux4_x_x*s1_3);
  const double s1_5 = s1_1*s1_4;
  const double R_chassis_x_z = fma(R_chassis_aux4_x_x, s1_5, R_chassis_aux4_y_x*s1_2);
  const double R_chassis_y_y = fma(R_chassis_aux4_y_x, s1_3, R_chassis_aux4_x_x*s1_4);
  const double R_chassis_y_z = fnma(R_chassis_aux4_x_x, s1_2, R_chassis_aux4_y_x*s1_5);
  const double R_chassis_z_y = R_chassis_aux5_z_z*s1_2;
  const double R_chassis_z_z = R_chassis_aux5_z_z*s1_4;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s1_6 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_6;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = work.sines[3];
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_6;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_7 = -p_carrier_left_rz_z*R_lower_arm_left_z_y;
  work.s1_8 = fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_7);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_8;
  const double s1_9 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_10 = fnma(-p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_9);
  work.r_carrier_left_aux1_z = work.s1_10 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_11 = work.cosines[5];
  work.s1_12 = s1_6*s1_11;
  const double s1_13 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_6*s1_13;
  work.R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_13, R_carrier_left_aux1_y_y*s1_11);
  const double s1_14 = fma(R_carrier_left_aux1_y_y, s1_13, R_lower_arm_left_z_y*s1_11);
  work.R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_y, s1_11, R_lower_arm_left_y_y*s1_13);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_13,
      R_lower_arm_left_y_y*s1_11);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_15 = work.cosines[6];
  const double s1_16 = work.sines[6];
  work.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_16, R_carrier_left_aux1_x_x*s1_15);
  work.R_carrier_left_x_z = fma(R_carrier_left_aux2_x_z, s1_15, R_carrier_left_aux1_x_x*s1_16);
  work.R_carrier_left_y_x = fma(s1_14, s1_16, work.R_carrier_left_aux1_y_x*s1_15);
  work.R_carrier_left_y_z = fnma(s1_14, s1_15, work.R_carrier_left_aux1_y_x*s1_16);
  work.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_16,
      work.R_carrier_left_aux1_z_x*s1_15);
  work.R_carrier_left_z_z = fma(R_carrier_left_aux2_z_z, s1_15, work.R_carrier_left_aux1_z_x*s1_16);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_17 = p_wheel_front_left_z*work.R_carrier_left_x_z;
  work.s1_18 = fnma(p_wheel_front_left_y, work.s1_12, s1_17);
  const double s1_19 = p_wheel_front_left_y*work.R_carrier_left_aux2_y_y;
  work.s1_20 = fma(p_wheel_front_left_z, work.R_carrier_left_y_z, s1_19);
  const double s1_21 = p_wheel_front_left_y*work.R_carrier_left_aux2_z_y;
  work.s1_22 = fma(p_wheel_front_left_z, work.R_carrier_left_z_z, s1_21);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_23 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_23;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[9];
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_23;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_24 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  work.s1_25 = fnma(-p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_24);
  work.r_carrier_right_aux1_y = work.s1_25 - (-p_lower_arm_right_y);
  const double s1_26 = -p_carrier_right_rz_y*R_lower_arm_right_z_y;
  work.s1_27 = fma(-p_carrier_right_rz_z, R_lower_arm_right_y_y, s1_26);
  work.s1_28 = -p_lower_arm_right_z + work.s1_27;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_29 = work.cosines[11];
  work.s1_30 = s1_23*s1_29;
  const double s1_31 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_23*s1_31;
  work.R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_31,
      R_carrier_right_aux1_y_y*s1_29);
  const double s1_32 = fma(R_carrier_right_aux1_y_y, s1_31, R_lower_arm_right_z_y*s1_29);
  work.R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_y, s1_29, R_lower_arm_right_y_y*s1_31);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_31,
      R_lower_arm_right_y_y*s1_29);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_33 = work.cosines[12];
  const double s1_34 = work.sines[12];
  work.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_34, R_carrier_right_aux1_x_x*s1_33);
  work.R_carrier_right_x_z = fma(R_carrier_right_aux2_x_z, s1_33, R_carrier_right_aux1_x_x*s1_34);
  work.R_carrier_right_y_x = fma(s1_32, s1_34, work.R_carrier_right_aux1_y_x*s1_33);
  work.R_carrier_right_y_z = fnma(s1_32, s1_33, work.R_carrier_right_aux1_y_x*s1_34);
  const double s1_35 = work.R_carrier_right_aux1_z_x*s1_33;
  work.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_34, s1_35);
  const double s1_36 = work.R_carrier_right_aux1_z_x*s1_34;
  work.R_carrier_right_z_z = fma(R_carrier_right_aux2_z_z, s1_33, s1_36);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_37 = -p_wheel_front_right_y*work.s1_30;
  work.s1_38 = fma(p_wheel_front_right_z, work.R_carrier_right_x_z, s1_37);
  const double s1_39 = p_wheel_front_right_z*work.R_carrier_right_y_z;
  work.s1_40 = fnma(-p_wheel_front_right_y, work.R_carrier_right_aux2_y_y, s1_39);
  const double s1_41 = p_wheel_front_right_z*work.R_carrier_right_z_z;
  work.s1_42 = fnma(-p_wheel_front_right_y, work.R_carrier_right_aux2_z_y, s1_41);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double z_rear_axle_tz = state.z[Coordinate::rear_axle_tz];
  work.r_rear_axle_aux3_z = z_rear_axle_tz - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_43 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_43;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_43;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_44 = work.sines[19];
  const double s1_45 = work.cosines[19];
  work.R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_45, R_rear_axle_aux5_x_z*s1_44);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_45, R_rear_axle_aux4_y_x*s1_44);
  work.R_rear_axle_y_y = fma(R_rear_axle_aux5_y_z, s1_44, R_rear_axle_aux4_x_x*s1_45);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_44, R_rear_axle_aux5_y_z*s1_45);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_44;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_45;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  work.s1_46 = p_wheel_rear_left_y*work.R_rear_axle_x_y;
  work.s1_47 = p_wheel_rear_left_y*work.R_rear_axle_y_y;
  work.s1_48 = p_wheel_rear_left_y*work.R_rear_axle_z_y;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_49 = work.R_carrier_left_aux1_z_x*work.s1_12;
  const double s1_50 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s1_49);
  const double s1_51 = work.R_carrier_left_aux1_y_x*work.s1_12;
  const double s1_52 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s1_51);
  work.s1_53 = fma(R_lower_arm_left_y_y, s1_52, R_lower_arm_left_z_y*s1_50);
  const double s1_54 = 1.0/work.s1_53;
  work.s1_55 = R_carrier_left_aux1_z_y*s1_54;
  work.s1_56 = R_carrier_left_aux1_y_y*s1_54;
  work.s1_57 = s1_52*s1_54;
  work.s1_58 = s1_50*s1_54;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_59 = R_lower_arm_right_z_y*work.R_carrier_right_aux1_z_x;
  const double s1_60 = work.R_carrier_right_aux1_z_x*work.s1_30;
  const double s1_61 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s1_60);
  const double s1_62 = work.R_carrier_right_aux1_y_x*work.s1_30;
  const double s1_63 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s1_62);
  work.s1_64 = fma(R_lower_arm_right_y_y, s1_63, R_lower_arm_right_z_y*s1_61);
  const double s1_65 = 1.0/work.s1_64;
  work.s1_66 = R_carrier_right_aux1_z_y*s1_65;
  work.s1_67 = R_carrier_right_aux1_y_y*s1_65;
  work.s1_68 = s1_63*s1_65;
  const double s1_69 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s1_70 = fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y, s1_69);
  work.s1_71 = s1_65*s1_70;
  work.s1_72 = fma(R_lower_arm_right_y_y, work.R_carrier_right_aux1_y_x, s1_59)*s1_65;
  work.s1_73 = s1_61*s1_65;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_74 = R_rear_axle_aux4_y_x*work.R_rear_axle_aux5_y_x;
  work.s1_75 = fma(R_rear_axle_aux4_x_x, work.R_rear_axle_aux5_x_x, s1_74);
  const double s1_76 = 1.0/work.s1_75;
  work.s1_77 = R_rear_axle_aux4_y_x*s1_76;
  work.s1_78 = R_rear_axle_aux4_x_x*s1_76;
  work.s1_79 = R_rear_axle_aux5_y_z*s1_76;
  work.s1_80 = R_rear_axle_aux5_x_z*s1_76;
  work.s1_81 = work.s1_75*s1_76;
  // operations: 53 add, 136 multiply, 3 divide, 44 sin cos

  // --- step 4: velocities ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  const double s4_1 = zd_chassis_rz*s1_1;
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  work.w_chassis_x = zd_chassis_rx - s4_1;
  const double s4_2 = zd_chassis_rz*R_chassis_z_y;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  const double s4_3 = zd_chassis_ry*s1_4;
  work.w_chassis_y = s4_2 + s4_3;
  const double s4_4 = zd_chassis_rz*R_chassis_z_z;
  const double s4_5 = zd_chassis_ry*s1_2;
  work.w_chassis_z = s4_4 - s4_5;
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double w_lower_arm_left_x = zd_lower_arm_left + work.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double s4_6 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  const double w_carrier_left_aux1_y = work.w_chassis_y - s4_6;
  const double s4_7 = zd_carrier_left_rz*R_lower_arm_left_y_y;
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
  const double s4_11 = zd_carrier_left_ry*work.s1_12;
  work.w_carrier_left_x = w_carrier_left_aux2_x - s4_11;
  const double s4_12 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.w_carrier_left_y = w_carrier_left_aux2_y + s4_12;
  const double s4_13 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  work.w_carrier_left_z = w_carrier_left_aux2_z + s4_13;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  const double s4_14 = zd_wheel_front_left*work.s1_12;
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
  const double s4_17 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  const double w_carrier_right_aux1_y = work.w_chassis_y - s4_17;
  const double s4_18 = zd_carrier_right_rz*R_lower_arm_right_y_y;
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
  const double s4_22 = zd_carrier_right_ry*work.s1_30;
  work.w_carrier_right_x = w_carrier_right_aux2_x - s4_22;
  const double s4_23 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.w_carrier_right_y = w_carrier_right_aux2_y + s4_23;
  const double s4_24 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.w_carrier_right_z = w_carrier_right_aux2_z + s4_24;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  const double s4_25 = zd_wheel_front_right*work.s1_30;
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
  const double w_rear_axle_aux4_z = zd_rear_axle_rz + work.w_chassis_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double s4_28 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  const double w_rear_axle_aux5_x = work.w_chassis_x - s4_28;
  const double s4_29 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  const double w_rear_axle_aux5_y = work.w_chassis_y + s4_29;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s4_30 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.w_rear_axle_x = w_rear_axle_aux5_x + s4_30;
  const double s4_31 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.w_rear_axle_y = w_rear_axle_aux5_y + s4_31;
  const double s4_32 = zd_rear_axle_rx*s1_43;
  work.w_rear_axle_z = w_rear_axle_aux4_z - s4_32;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  const double s4_33 = zd_wheel_rear_left*work.R_rear_axle_x_y;
  work.w_wheel_rear_left_x = work.w_rear_axle_x + s4_33;
  const double s4_34 = zd_wheel_rear_left*work.R_rear_axle_y_y;
  work.w_wheel_rear_left_y = work.w_rear_axle_y + s4_34;
  const double s4_35 = zd_wheel_rear_left*work.R_rear_axle_z_y;
  work.w_wheel_rear_left_z = work.w_rear_axle_z + s4_35;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  work.w_arb_rear_left_y = zd_arb_rear_left + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  const double s4_36 = zd_wheel_rear_right*work.R_rear_axle_x_y;
  work.w_wheel_rear_right_x = work.w_rear_axle_x + s4_36;
  const double s4_37 = zd_wheel_rear_right*work.R_rear_axle_y_y;
  work.w_wheel_rear_right_y = work.w_rear_axle_y + s4_37;
  const double s4_38 = zd_wheel_rear_right*work.R_rear_axle_z_y;
  work.w_wheel_rear_right_z = work.w_rear_axle_z + s4_38;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  work.w_arb_rear_right_y = zd_arb_rear_right + work.w_chassis_y;
  // operations: 47 add, 38 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_1 = -g_z + derivative.zdd[Coordinate::chassis_tz];
  const double zdd_chassis_ty = derivative.zdd[Coordinate::chassis_ty];
  const double zdd_chassis_tx = derivative.zdd[Coordinate::chassis_tx];
  const double s7_2 = zdd_chassis_ty*R_chassis_aux5_y_x;
  work.a_chassis_x = fnma(s1_1, s7_1, fma(zdd_chassis_tx, R_chassis_aux5_x_x, s7_2));
  const double s7_3 = fma(zdd_chassis_tx, R_chassis_x_y, zdd_chassis_ty*R_chassis_y_y);
  work.a_chassis_y = fma(R_chassis_z_y, s7_1, s7_3);
  const double s7_4 = fma(zdd_chassis_tx, R_chassis_x_z, zdd_chassis_ty*R_chassis_y_z);
  work.a_chassis_z = fma(R_chassis_z_z, s7_1, s7_4);
  const double zdd_chassis_rz = derivative.zdd[Coordinate::chassis_rz];
  const double s7_5 = fnma(zdd_chassis_rz, s1_1, derivative.zdd[Coordinate::chassis_rx]);
  const double alpha_chassis_x = fnma(s4_3, s4_4, fnma(s4_2, s4_5, s7_5));
  const double zdd_chassis_ry = derivative.zdd[Coordinate::chassis_ry];
  const double s7_6 = fma(zdd_chassis_rz, R_chassis_z_y, zd_chassis_rx*work.w_chassis_z);
  const double alpha_chassis_y = fnma(s4_1, s4_5, fma(zdd_chassis_ry, s1_4, s7_6));
  const double s7_7 = fnma(zdd_chassis_ry, s1_2, zdd_chassis_rz*R_chassis_z_z);
  const double alpha_chassis_z = fnma(zd_chassis_rx, work.w_chassis_y, fnma(s4_1, s4_3, s7_7));
  const double s7_8 = work.w_chassis_y*work.w_chassis_y;
  const double s7_9 = work.w_chassis_z*work.w_chassis_z;
  const double s7_10 = work.w_chassis_x*work.w_chassis_x;
  work.s7_11 = s7_8 + s7_10;
  work.s7_12 = s7_8 + s7_9;
  work.s7_13 = s7_9 + s7_10;
  work.s7_14 = fms(work.w_chassis_y, work.w_chassis_z, alpha_chassis_x);
  work.s7_15 = fma(work.w_chassis_y, work.w_chassis_z, alpha_chassis_x);
  work.s7_16 = fma(work.w_chassis_x, work.w_chassis_z, alpha_chassis_y);
  work.s7_17 = fma(work.w_chassis_x, work.w_chassis_y, alpha_chassis_z);
  work.s7_18 = fms(work.w_chassis_x, work.w_chassis_y, alpha_chassis_z);
  work.s7_19 = fms(work.w_chassis_x, work.w_chassis_z, alpha_chassis_y);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_20 = fma(p_lower_arm_left_x, work.s7_12, -p_lower_arm_left_z*work.s7_16);
  work.s7_21 = fma(p_lower_arm_left_y, work.s7_18, work.a_chassis_x);
  const double a_lower_arm_left_x = work.s7_21 - s7_20;
  const double s7_22 = fma(p_lower_arm_left_x, work.s7_17, work.a_chassis_y);
  const double s7_23 = fnma(-p_lower_arm_left_z, work.s7_14, s7_22);
  work.a_lower_arm_left_y = fnma(p_lower_arm_left_y, work.s7_13, s7_23);
  const double s7_24 = p_lower_arm_left_x*work.s7_19;
  const double s7_25 = fma(-p_lower_arm_left_z, work.s7_11, s7_24);
  work.s7_26 = fma(p_lower_arm_left_y, work.s7_15, work.a_chassis_z);
  work.a_lower_arm_left_z = s7_25 + work.s7_26;
  work.alpha_lower_arm_left_x = derivative.zdd[Coordinate::lower_arm_left] + alpha_chassis_x;
  const double alpha_lower_arm_left_y = fma(zd_lower_arm_left, work.w_chassis_z, alpha_chassis_y);
  const double alpha_lower_arm_left_z = fnma(zd_lower_arm_left, work.w_chassis_y, alpha_chassis_z);
  work.s7_27 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_left_x);
  work.s7_28 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_left_x);
  work.s7_29 = fma(w_lower_arm_left_x, w_lower_arm_left_x, s7_8);
  work.s7_30 = fma(w_lower_arm_left_x, w_lower_arm_left_x, s7_9);
  const double s7_31 = fma(work.w_chassis_z, w_lower_arm_left_x, alpha_lower_arm_left_y);
  const double s7_32 = fms(work.w_chassis_y, w_lower_arm_left_x, alpha_lower_arm_left_z);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  work.a_carrier_left_aux1_x = fma(work.s1_10, s7_31, fma(work.s1_8, s7_32, a_lower_arm_left_x));
  const double s7_33 = fma(work.s1_10, work.s7_28, work.a_lower_arm_left_y);
  work.a_carrier_left_aux1_y = fnma(work.s1_8, work.s7_30, s7_33);
  const double s7_34 = fma(work.s1_8, work.s7_27, work.a_lower_arm_left_z);
  work.a_carrier_left_aux1_z = fnma(work.s1_10, work.s7_29, s7_34);
  const double s7_35 = fma(work.w_chassis_y, s4_7, work.alpha_lower_arm_left_x);
  const double alpha_carrier_left_aux1_x = fma(work.w_chassis_z, s4_6, s7_35);
  const double zdd_carrier_left_rz = derivative.zdd[Coordinate::carrier_left_rz];
  const double s7_36 = fnma(zdd_carrier_left_rz, R_lower_arm_left_z_y, alpha_lower_arm_left_y);
  const double alpha_carrier_left_aux1_y = fnma(w_lower_arm_left_x, s4_7, s7_36);
  const double s7_37 = fma(zdd_carrier_left_rz, R_lower_arm_left_y_y, alpha_lower_arm_left_z);
  const double alpha_carrier_left_aux1_z = fnma(w_lower_arm_left_x, s4_6, s7_37);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zdd_carrier_left_rx = derivative.zdd[Coordinate::carrier_left_rx];
  const double s7_38 = fma(zdd_carrier_left_rx, R_carrier_left_aux1_x_x, alpha_carrier_left_aux1_x);
  const double s7_39 = fma(w_carrier_left_aux1_y, s4_10, s7_38);
  const double alpha_carrier_left_aux2_x = fnma(w_carrier_left_aux1_z, s4_9, s7_39);
  const double s7_40 = fma(zdd_carrier_left_rx, work.R_carrier_left_aux1_y_x,
      alpha_carrier_left_aux1_y);
  const double alpha_carrier_left_aux2_y = fnma(w_lower_arm_left_x, s4_10,
      fma(w_carrier_left_aux1_z, s4_8, s7_40));
  const double s7_41 = fma(zdd_carrier_left_rx, work.R_carrier_left_aux1_z_x,
      alpha_carrier_left_aux1_z);
  const double alpha_carrier_left_aux2_z = fnma(w_carrier_left_aux1_y, s4_8, fma(w_lower_arm_left_x,
      s4_9, s7_41));
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zdd_carrier_left_ry = derivative.zdd[Coordinate::carrier_left_ry];
  const double s7_42 = fnma(zdd_carrier_left_ry, work.s1_12, alpha_carrier_left_aux2_x);
  const double s7_43 = fma(w_carrier_left_aux2_y, s4_13, s7_42);
  work.alpha_carrier_left_x = fnma(w_carrier_left_aux2_z, s4_12, s7_43);
  const double s7_44 = fma(zdd_carrier_left_ry, work.R_carrier_left_aux2_y_y,
      alpha_carrier_left_aux2_y);
  const double s7_45 = fnma(w_carrier_left_aux2_x, s4_13, s7_44);
  work.alpha_carrier_left_y = fnma(w_carrier_left_aux2_z, s4_11, s7_45);
  const double s7_46 = fma(zdd_carrier_left_ry, work.R_carrier_left_aux2_z_y,
      alpha_carrier_left_aux2_z);
  const double s7_47 = fma(w_carrier_left_aux2_x, s4_12, s7_46);
  work.alpha_carrier_left_z = fma(w_carrier_left_aux2_y, s4_11, s7_47);
  const double s7_48 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s7_49 = work.w_carrier_left_y*work.w_carrier_left_y;
  work.s7_50 = s7_48 + s7_49;
  work.s7_51 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s7_48);
  work.s7_52 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s7_49);
  work.s7_53 = fma(work.w_carrier_left_x, work.w_carrier_left_z, work.alpha_carrier_left_y);
  work.s7_54 = fma(work.w_carrier_left_x, work.w_carrier_left_y, work.alpha_carrier_left_z);
  work.s7_55 = fma(work.w_carrier_left_y, work.w_carrier_left_z, work.alpha_carrier_left_x);
  work.s7_56 = fms(work.w_carrier_left_x, work.w_carrier_left_z, work.alpha_carrier_left_y);
  work.s7_57 = fms(work.w_carrier_left_x, work.w_carrier_left_y, work.alpha_carrier_left_z);
  work.s7_58 = fms(work.w_carrier_left_y, work.w_carrier_left_z, work.alpha_carrier_left_x);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_59 = fma(work.s1_20, work.s7_57, work.a_carrier_left_aux1_x);
  work.a_wheel_front_left_x = fnma(work.s1_18, work.s7_50, fma(work.s1_22, work.s7_53, s7_59));
  const double s7_60 = fma(work.s1_22, work.s7_58, work.a_carrier_left_aux1_y);
  work.a_wheel_front_left_y = fnma(work.s1_20, work.s7_51, fma(work.s1_18, work.s7_54, s7_60));
  const double s7_61 = fma(work.s1_20, work.s7_55, work.a_carrier_left_aux1_z);
  work.a_wheel_front_left_z = fnma(work.s1_22, work.s7_52, fma(work.s1_18, work.s7_56, s7_61));
  const double zdd_wheel_front_left = derivative.zdd[Coordinate::wheel_front_left];
  const double s7_62 = fnma(zdd_wheel_front_left, work.s1_12, work.alpha_carrier_left_x);
  const double s7_63 = fma(work.w_carrier_left_y, s4_16, s7_62);
  work.alpha_wheel_front_left_x = fnma(work.w_carrier_left_z, s4_15, s7_63);
  const double s7_64 = fma(zdd_wheel_front_left, work.R_carrier_left_aux2_y_y,
      work.alpha_carrier_left_y);
  const double s7_65 = fnma(work.w_carrier_left_z, s4_14, s7_64);
  work.alpha_wheel_front_left_y = fnma(work.w_carrier_left_x, s4_16, s7_65);
  const double s7_66 = fma(zdd_wheel_front_left, work.R_carrier_left_aux2_z_y,
      work.alpha_carrier_left_z);
  const double s7_67 = fma(work.w_carrier_left_y, s4_14, s7_66);
  work.alpha_wheel_front_left_z = fma(work.w_carrier_left_x, s4_15, s7_67);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_68 = fnma(-p_upper_arm_left_z, work.s7_14, s7_22);
  work.a_upper_arm_left_y = fnma(p_upper_arm_left_y, work.s7_13, s7_68);
  const double s7_69 = fma(-p_upper_arm_left_z, work.s7_11, s7_24);
  const double s7_70 = fma(p_upper_arm_left_y, work.s7_15, work.a_chassis_z);
  work.a_upper_arm_left_z = s7_69 + s7_70;
  work.alpha_upper_arm_left_x = derivative.zdd[Coordinate::upper_arm_left] + alpha_chassis_x;
  work.s7_71 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_left_x);
  work.s7_72 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_left_x);
  work.s7_73 = fma(w_upper_arm_left_x, w_upper_arm_left_x, s7_8);
  work.s7_74 = fma(w_upper_arm_left_x, w_upper_arm_left_x, s7_9);
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_75 = -p_arb_front_left_z*work.s7_16;
  const double s7_76 = fma(p_arb_front_left_x, work.s7_12, s7_75);
  const double s7_77 = fma(p_arb_front_left_y, work.s7_18, work.a_chassis_x);
  work.a_arb_front_left_x = s7_77 - s7_76;
  const double s7_78 = fnma(-p_arb_front_left_z, work.s7_14, work.a_chassis_y);
  const double s7_79 = fma(p_arb_front_left_x, work.s7_17, s7_78);
  const double a_arb_front_left_y = fnma(p_arb_front_left_y, work.s7_13, s7_79);
  const double s7_80 = -p_arb_front_left_z*work.s7_11;
  const double s7_81 = fma(p_arb_front_left_x, work.s7_19, s7_80);
  const double s7_82 = fma(p_arb_front_left_y, work.s7_15, work.a_chassis_z);
  work.a_arb_front_left_z = s7_81 + s7_82;
  work.alpha_arb_front_left_x = fnma(zd_arb_front_left, work.w_chassis_z, alpha_chassis_x);
  work.alpha_arb_front_left_y = derivative.zdd[Coordinate::arb_front_left] + alpha_chassis_y;
  work.alpha_arb_front_left_z = fma(zd_arb_front_left, work.w_chassis_x, alpha_chassis_z);
  work.s7_83 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_left_y);
  work.s7_84 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_left_y);
  work.s7_85 = fma(work.w_arb_front_left_y, work.w_arb_front_left_y, s7_10);
  work.s7_86 = fma(work.w_arb_front_left_y, work.w_arb_front_left_y, s7_9);
  const double s7_87 = fma(work.w_chassis_x, work.w_arb_front_left_y, work.alpha_arb_front_left_z);
  work.s7_88 = fma(work.w_chassis_z, work.w_arb_front_left_y, work.alpha_arb_front_left_x);
  work.s7_89 = fms(work.w_chassis_x, work.w_arb_front_left_y, work.alpha_arb_front_left_z);
  const double s7_90 = fms(work.w_chassis_z, work.w_arb_front_left_y, work.alpha_arb_front_left_x);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double a_lower_arm_right_x = fnma(p_lower_arm_left_y, work.s7_18, work.a_chassis_x) - s7_20;
  work.a_lower_arm_right_y = fma(p_lower_arm_left_y, work.s7_13, s7_23);
  work.a_lower_arm_right_z = fnma(p_lower_arm_left_y, work.s7_15, work.a_chassis_z + s7_25);
  work.alpha_lower_arm_right_x = derivative.zdd[Coordinate::lower_arm_right] + alpha_chassis_x;
  const double alpha_lower_arm_right_y = fma(zd_lower_arm_right, work.w_chassis_z, alpha_chassis_y);
  const double alpha_lower_arm_right_z = fnma(zd_lower_arm_right, work.w_chassis_y,
      alpha_chassis_z);
  work.s7_91 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_right_x);
  work.s7_92 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_right_x);
  work.s7_93 = fma(w_lower_arm_right_x, w_lower_arm_right_x, s7_8);
  work.s7_94 = fma(w_lower_arm_right_x, w_lower_arm_right_x, s7_9);
  const double s7_95 = fma(work.w_chassis_z, w_lower_arm_right_x, alpha_lower_arm_right_y);
  const double s7_96 = fms(work.w_chassis_y, w_lower_arm_right_x, alpha_lower_arm_right_z);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  work.a_carrier_right_aux1_x = fnma(work.s1_27, s7_95, fma(work.s1_25, s7_96,
      a_lower_arm_right_x));
  const double s7_97 = fnma(work.s1_27, work.s7_92, work.a_lower_arm_right_y);
  work.a_carrier_right_aux1_y = fnma(work.s1_25, work.s7_94, s7_97);
  const double s7_98 = fma(work.s1_27, work.s7_93, work.a_lower_arm_right_z);
  work.a_carrier_right_aux1_z = fma(work.s1_25, work.s7_91, s7_98);
  const double s7_99 = fma(work.w_chassis_y, s4_18, work.alpha_lower_arm_right_x);
  const double alpha_carrier_right_aux1_x = fma(work.w_chassis_z, s4_17, s7_99);
  const double zdd_carrier_right_rz = derivative.zdd[Coordinate::carrier_right_rz];
  const double s7_100 = fnma(zdd_carrier_right_rz, R_lower_arm_right_z_y, alpha_lower_arm_right_y);
  const double alpha_carrier_right_aux1_y = fnma(w_lower_arm_right_x, s4_18, s7_100);
  const double s7_101 = fma(zdd_carrier_right_rz, R_lower_arm_right_y_y, alpha_lower_arm_right_z);
  const double alpha_carrier_right_aux1_z = fnma(w_lower_arm_right_x, s4_17, s7_101);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zdd_carrier_right_rx = derivative.zdd[Coordinate::carrier_right_rx];
  const double s7_102 = fma(zdd_carrier_right_rx, R_carrier_right_aux1_x_x,
      alpha_carrier_right_aux1_x);
  const double s7_103 = fma(w_carrier_right_aux1_y, s4_21, s7_102);
  const double alpha_carrier_right_aux2_x = fnma(w_carrier_right_aux1_z, s4_20, s7_103);
  const double s7_104 = fma(zdd_carrier_right_rx, work.R_carrier_right_aux1_y_x,
      alpha_carrier_right_aux1_y);
  const double s7_105 = fma(w_carrier_right_aux1_z, s4_19, s7_104);
  const double alpha_carrier_right_aux2_y = fnma(w_lower_arm_right_x, s4_21, s7_105);
  const double s7_106 = fma(zdd_carrier_right_rx, work.R_carrier_right_aux1_z_x,
      alpha_carrier_right_aux1_z);
  const double s7_107 = fma(w_lower_arm_right_x, s4_20, s7_106);
  const double alpha_carrier_right_aux2_z = fnma(w_carrier_right_aux1_y, s4_19, s7_107);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zdd_carrier_right_ry = derivative.zdd[Coordinate::carrier_right_ry];
  const double s7_108 = fnma(zdd_carrier_right_ry, work.s1_30, alpha_carrier_right_aux2_x);
  const double s7_109 = fma(w_carrier_right_aux2_y, s4_24, s7_108);
  work.alpha_carrier_right_x = fnma(w_carrier_right_aux2_z, s4_23, s7_109);
  const double s7_110 = fma(zdd_carrier_right_ry, work.R_carrier_right_aux2_y_y,
      alpha_carrier_right_aux2_y);
  const double s7_111 = fnma(w_carrier_right_aux2_x, s4_24, s7_110);
  work.alpha_carrier_right_y = fnma(w_carrier_right_aux2_z, s4_22, s7_111);
  const double s7_112 = fma(zdd_carrier_right_ry, work.R_carrier_right_aux2_z_y,
      alpha_carrier_right_aux2_z);
  const double s7_113 = fma(w_carrier_right_aux2_x, s4_23, s7_112);
  work.alpha_carrier_right_z = fma(w_carrier_right_aux2_y, s4_22, s7_113);
  const double s7_114 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s7_115 = work.w_carrier_right_y*work.w_carrier_right_y;
  work.s7_116 = s7_114 + s7_115;
  work.s7_117 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s7_114);
  work.s7_118 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s7_115);
  work.s7_119 = fma(work.w_carrier_right_x, work.w_carrier_right_z, work.alpha_carrier_right_y);
  work.s7_120 = fma(work.w_carrier_right_x, work.w_carrier_right_y, work.alpha_carrier_right_z);
  work.s7_121 = fma(work.w_carrier_right_y, work.w_carrier_right_z, work.alpha_carrier_right_x);
  work.s7_122 = fms(work.w_carrier_right_x, work.w_carrier_right_z, work.alpha_carrier_right_y);
  work.s7_123 = fms(work.w_carrier_right_x, work.w_carrier_right_y, work.alpha_carrier_right_z);
  work.s7_124 = fms(work.w_carrier_right_y, work.w_carrier_right_z, work.alpha_carrier_right_x);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_125 = fma(work.s1_40, work.s7_123, work.a_carrier_right_aux1_x);
  work.a_wheel_front_right_x = fnma(work.s1_38, work.s7_116, fma(work.s1_42, work.s7_119, s7_125));
  const double s7_126 = fma(work.s1_38, work.s7_120, work.a_carrier_right_aux1_y);
  work.a_wheel_front_right_y = fnma(work.s1_40, work.s7_117, fma(work.s1_42, work.s7_124, s7_126));
  const double s7_127 = fma(work.s1_40, work.s7_121, work.a_carrier_right_aux1_z);
  work.a_wheel_front_right_z = fnma(work.s1_42, work.s7_118, fma(work.s1_38, work.s7_122, s7_127));
  const double zdd_wheel_front_right = derivative.zdd[Coordinate::wheel_front_right];
  const double s7_128 = fnma(zdd_wheel_front_right, work.s1_30, work.alpha_carrier_right_x);
  const double s7_129 = fma(work.w_carrier_right_y, s4_27, s7_128);
  work.alpha_wheel_front_right_x = fnma(work.w_carrier_right_z, s4_26, s7_129);
  const double s7_130 = fma(zdd_wheel_front_right, work.R_carrier_right_aux2_y_y,
      work.alpha_carrier_right_y);
  const double s7_131 = fnma(work.w_carrier_right_z, s4_25, s7_130);
  work.alpha_wheel_front_right_y = fnma(work.w_carrier_right_x, s4_27, s7_131);
  const double s7_132 = fma(zdd_wheel_front_right, work.R_carrier_right_aux2_z_y,
      work.alpha_carrier_right_z);
  const double s7_133 = fma(work.w_carrier_right_y, s4_25, s7_132);
  work.alpha_wheel_front_right_z = fma(work.w_carrier_right_x, s4_26, s7_133);
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.a_upper_arm_right_y = fma(p_upper_arm_left_y, work.s7_13, s7_68);
  work.a_upper_arm_right_z = fnma(p_upper_arm_left_y, work.s7_15, work.a_chassis_z + s7_69);
  work.alpha_upper_arm_right_x = derivative.zdd[Coordinate::upper_arm_right] + alpha_chassis_x;
  work.s7_134 = fma(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_right_x);
  work.s7_135 = fms(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_right_x);
  work.s7_136 = fma(w_upper_arm_right_x, w_upper_arm_right_x, s7_8);
  work.s7_137 = fma(w_upper_arm_right_x, w_upper_arm_right_x, s7_9);
  // arb_front_right: arb_front_right, revolute, chassis
  work.a_arb_front_right_x = fnma(p_arb_front_left_y, work.s7_18, work.a_chassis_x) - s7_76;
  const double a_arb_front_right_y = fma(p_arb_front_left_y, work.s7_13, s7_79);
  work.a_arb_front_right_z = fnma(p_arb_front_left_y, work.s7_15, work.a_chassis_z + s7_81);
  work.alpha_arb_front_right_x = fnma(zd_arb_front_right, work.w_chassis_z, alpha_chassis_x);
  work.alpha_arb_front_right_y = derivative.zdd[Coordinate::arb_front_right] + alpha_chassis_y;
  work.alpha_arb_front_right_z = fma(zd_arb_front_right, work.w_chassis_x, alpha_chassis_z);
  work.s7_138 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_right_y);
  work.s7_139 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_right_y);
  work.s7_140 = fma(work.w_arb_front_right_y, work.w_arb_front_right_y, s7_10);
  work.s7_141 = fma(work.w_arb_front_right_y, work.w_arb_front_right_y, s7_9);
  const double s7_142 = fma(work.w_chassis_x, work.w_arb_front_right_y,
      work.alpha_arb_front_right_z);
  work.s7_143 = fma(work.w_chassis_z, work.w_arb_front_right_y, work.alpha_arb_front_right_x);
  work.s7_144 = fms(work.w_chassis_x, work.w_arb_front_right_y, work.alpha_arb_front_right_z);
  const double s7_145 = fms(work.w_chassis_z, work.w_arb_front_right_y,
      work.alpha_arb_front_right_x);
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_146 = fma(p_upper_arm_left_y, work.s7_18, work.a_chassis_x);
  const double s7_147 = fnma(-p_pitman_arm_z, work.s7_16, s7_146);
  work.a_pitman_arm_x = fnma(p_pitman_arm_x, work.s7_12, s7_147);
  const double s7_148 = fnma(p_upper_arm_left_y, work.s7_13, work.a_chassis_y);
  const double s7_149 = fma(p_pitman_arm_x, work.s7_17, s7_148);
  const double a_pitman_arm_y = fnma(-p_pitman_arm_z, work.s7_14, s7_149);
  work.a_pitman_arm_z = fma(p_pitman_arm_x, work.s7_19, fma(-p_pitman_arm_z, work.s7_11, s7_70));
  const double alpha_pitman_arm_x = fnma(zd_pitman_arm, work.w_chassis_z, alpha_chassis_x);
  work.alpha_pitman_arm_y = derivative.zdd[Coordinate::pitman_arm] + alpha_chassis_y;
  const double alpha_pitman_arm_z = fma(zd_pitman_arm, work.w_chassis_x, alpha_chassis_z);
  work.s7_150 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_pitman_arm_y);
  work.s7_151 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_pitman_arm_y);
  work.s7_152 = fma(w_pitman_arm_y, w_pitman_arm_y, s7_10);
  work.s7_153 = fma(w_pitman_arm_y, w_pitman_arm_y, s7_9);
  const double s7_154 = fma(work.w_chassis_x, w_pitman_arm_y, alpha_pitman_arm_z);
  const double s7_155 = fms(work.w_chassis_z, w_pitman_arm_y, alpha_pitman_arm_x);
  // bell_crank: bell_crank, revolute, chassis
  const double s7_156 = fnma(-p_bell_crank_z, work.s7_16, work.a_chassis_x);
  work.a_bell_crank_x = fnma(p_bell_crank_x, work.s7_12, s7_156);
  const double s7_157 = fma(p_bell_crank_x, work.s7_17, work.a_chassis_y);
  work.a_bell_crank_y = fnma(-p_bell_crank_z, work.s7_14, s7_157);
  const double s7_158 = fma(-p_bell_crank_z, work.s7_11, work.a_chassis_z);
  work.a_bell_crank_z = fma(p_bell_crank_x, work.s7_19, s7_158);
  const double alpha_bell_crank_x = fma(zd_bell_crank, work.w_chassis_y, alpha_chassis_x);
  const double alpha_bell_crank_y = fnma(zd_bell_crank, work.w_chassis_x, alpha_chassis_y);
  work.alpha_bell_crank_z = derivative.zdd[Coordinate::bell_crank] + alpha_chassis_z;
  work.s7_159 = fma(work.w_chassis_x, work.w_chassis_y, work.alpha_bell_crank_z);
  work.s7_160 = fms(work.w_chassis_x, work.w_chassis_y, work.alpha_bell_crank_z);
  work.s7_161 = fma(w_bell_crank_z, w_bell_crank_z, s7_8);
  work.s7_162 = fma(w_bell_crank_z, w_bell_crank_z, s7_10);
  work.s7_163 = fma(work.w_chassis_y, w_bell_crank_z, alpha_bell_crank_x);
  work.s7_164 = fms(work.w_chassis_x, w_bell_crank_z, alpha_bell_crank_y);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double s7_165 = derivative.zdd[Coordinate::rear_axle_tx] + work.a_chassis_x - s7_75;
  const double a_rear_axle_aux1_x = fnma(work.r_rear_axle_aux1_x, work.s7_12, s7_165);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s7_166 = fma(zd_rear_axle_tx, work.w_chassis_z, work.a_chassis_y);
  const double s7_167 = fma(zd_rear_axle_tx, work.w_chassis_z, s7_166);
  const double s7_168 = fnma(-p_arb_front_left_z, work.s7_14, s7_167);
  const double a_rear_axle_aux1_y = fma(work.r_rear_axle_aux1_x, work.s7_17, s7_168);
  const double s7_169 = fnma(zd_rear_axle_tx, work.w_chassis_y, work.a_chassis_z + s7_80);
  const double s7_170 = fnma(zd_rear_axle_tx, work.w_chassis_y, s7_169);
  const double a_rear_axle_aux1_z = fma(work.r_rear_axle_aux1_x, work.s7_19, s7_170);
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s7_171 = fnma(zd_rear_axle_ty, work.w_chassis_z, a_rear_axle_aux1_x);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s7_172 = fnma(zd_rear_axle_ty, work.w_chassis_z, s7_171);
  const double a_rear_axle_aux2_x = fma(z_rear_axle_ty, work.s7_18, s7_172);
  const double s7_173 = derivative.zdd[Coordinate::rear_axle_ty] + a_rear_axle_aux1_y;
  const double a_rear_axle_aux2_y = fnma(z_rear_axle_ty, work.s7_13, s7_173);
  const double s7_174 = fma(zd_rear_axle_ty, work.w_chassis_x, a_rear_axle_aux1_z);
  const double s7_175 = fma(zd_rear_axle_ty, work.w_chassis_x, s7_174);
  const double a_rear_axle_aux2_z = fma(z_rear_axle_ty, work.s7_15, s7_175);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s7_176 = fma(zd_rear_axle_tz, work.w_chassis_y, a_rear_axle_aux2_x);
  const double s7_177 = fma(zd_rear_axle_tz, work.w_chassis_y, s7_176);
  work.a_rear_axle_aux3_x = fma(z_rear_axle_tz, work.s7_16, s7_177);
  const double s7_178 = fnma(zd_rear_axle_tz, work.w_chassis_x, a_rear_axle_aux2_y);
  const double s7_179 = fnma(zd_rear_axle_tz, work.w_chassis_x, s7_178);
  work.a_rear_axle_aux3_y = fma(z_rear_axle_tz, work.s7_14, s7_179);
  const double s7_180 = derivative.zdd[Coordinate::rear_axle_tz] + a_rear_axle_aux2_z;
  work.a_rear_axle_aux3_z = fnma(z_rear_axle_tz, work.s7_11, s7_180);
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double alpha_rear_axle_aux4_x = fma(zd_rear_axle_rz, work.w_chassis_y, alpha_chassis_x);
  const double alpha_rear_axle_aux4_y = fnma(zd_rear_axle_rz, work.w_chassis_x, alpha_chassis_y);
  const double alpha_rear_axle_aux4_z = derivative.zdd[Coordinate::rear_axle_rz] + alpha_chassis_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zdd_rear_axle_ry = derivative.zdd[Coordinate::rear_axle_ry];
  const double s7_181 = fnma(zdd_rear_axle_ry, R_rear_axle_aux4_y_x, alpha_rear_axle_aux4_x);
  const double alpha_rear_axle_aux5_x = fnma(w_rear_axle_aux4_z, s4_29, s7_181);
  const double s7_182 = fma(zdd_rear_axle_ry, R_rear_axle_aux4_x_x, alpha_rear_axle_aux4_y);
  const double alpha_rear_axle_aux5_y = fnma(w_rear_axle_aux4_z, s4_28, s7_182);
  const double s7_183 = fma(work.w_chassis_y, s4_28, alpha_rear_axle_aux4_z);
  const double alpha_rear_axle_aux5_z = fma(work.w_chassis_x, s4_29, s7_183);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zdd_rear_axle_rx = derivative.zdd[Coordinate::rear_axle_rx];
  const double s7_184 = fma(zdd_rear_axle_rx, work.R_rear_axle_aux5_x_x, alpha_rear_axle_aux5_x);
  work.alpha_rear_axle_x = fnma(w_rear_axle_aux5_y, s4_32, fnma(w_rear_axle_aux4_z, s4_31, s7_184));
  const double s7_185 = fma(zdd_rear_axle_rx, work.R_rear_axle_aux5_y_x, alpha_rear_axle_aux5_y);
  work.alpha_rear_axle_y = fma(w_rear_axle_aux5_x, s4_32, fma(w_rear_axle_aux4_z, s4_30, s7_185));
  const double s7_186 = fnma(zdd_rear_axle_rx, s1_43, alpha_rear_axle_aux5_z);
  work.alpha_rear_axle_z = fnma(w_rear_axle_aux5_y, s4_30, fma(w_rear_axle_aux5_x, s4_31, s7_186));
  const double s7_187 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s7_188 = work.w_rear_axle_x*work.w_rear_axle_x;
  work.s7_189 = s7_187 + s7_188;
  work.s7_190 = fma(work.w_rear_axle_z, work.w_rear_axle_z, s7_187);
  work.s7_191 = fma(work.w_rear_axle_z, work.w_rear_axle_z, s7_188);
  work.s7_192 = fma(work.w_rear_axle_y, work.w_rear_axle_z, work.alpha_rear_axle_x);
  work.s7_193 = fma(work.w_rear_axle_x, work.w_rear_axle_z, work.alpha_rear_axle_y);
  work.s7_194 = fma(work.w_rear_axle_x, work.w_rear_axle_y, work.alpha_rear_axle_z);
  work.s7_195 = fms(work.w_rear_axle_y, work.w_rear_axle_z, work.alpha_rear_axle_x);
  work.s7_196 = fms(work.w_rear_axle_x, work.w_rear_axle_z, work.alpha_rear_axle_y);
  work.s7_197 = fms(work.w_rear_axle_x, work.w_rear_axle_y, work.alpha_rear_axle_z);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_198 = fma(work.s1_48, work.s7_193, work.a_rear_axle_aux3_x);
  work.a_wheel_rear_left_x = fnma(work.s1_46, work.s7_190, fma(work.s1_47, work.s7_197, s7_198));
  const double s7_199 = fma(work.s1_46, work.s7_194, work.s1_48*work.s7_195);
  work.a_wheel_rear_left_y = fnma(work.s1_47, work.s7_191, work.a_rear_axle_aux3_y + s7_199);
  const double s7_200 = fma(work.s1_46, work.s7_196, work.a_rear_axle_aux3_z);
  work.a_wheel_rear_left_z = fnma(work.s1_48, work.s7_189, fma(work.s1_47, work.s7_192, s7_200));
  const double zdd_wheel_rear_left = derivative.zdd[Coordinate::wheel_rear_left];
  const double s7_201 = fma(zdd_wheel_rear_left, work.R_rear_axle_x_y, work.alpha_rear_axle_x);
  work.alpha_wheel_rear_left_x = fnma(work.w_rear_axle_z, s4_34, fma(work.w_rear_axle_y, s4_35,
      s7_201));
  const double s7_202 = fma(zdd_wheel_rear_left, work.R_rear_axle_y_y, work.alpha_rear_axle_y);
  work.alpha_wheel_rear_left_y = fnma(work.w_rear_axle_x, s4_35, fma(work.w_rear_axle_z, s4_33,
      s7_202));
  const double s7_203 = fma(zdd_wheel_rear_left, work.R_rear_axle_z_y, work.alpha_rear_axle_z);
  work.alpha_wheel_rear_left_z = fnma(work.w_rear_axle_y, s4_33, fma(work.w_rear_axle_x, s4_34,
      s7_203));
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_204 = fnma(-p_arb_rear_left_z, work.s7_16, -p_arb_rear_left_x*work.s7_12);
  work.a_arb_rear_left_x = s7_77 + s7_204;
  const double s7_205 = fma(-p_arb_rear_left_x, work.s7_17, -p_arb_rear_left_z*work.s7_14);
  work.a_arb_rear_left_y = fnma(p_arb_front_left_y, work.s7_13, work.a_chassis_y) - s7_205;
  const double s7_206 = fnma(-p_arb_rear_left_x, work.s7_19, -p_arb_rear_left_z*work.s7_11);
  work.a_arb_rear_left_z = s7_82 + s7_206;
  work.alpha_arb_rear_left_x = fnma(zd_arb_rear_left, work.w_chassis_z, alpha_chassis_x);
  work.alpha_arb_rear_left_y = derivative.zdd[Coordinate::arb_rear_left] + alpha_chassis_y;
  work.alpha_arb_rear_left_z = fma(zd_arb_rear_left, work.w_chassis_x, alpha_chassis_z);
  work.s7_207 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_rear_left_y);
  work.s7_208 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_rear_left_y);
  work.s7_209 = fma(work.w_arb_rear_left_y, work.w_arb_rear_left_y, s7_10);
  work.s7_210 = fma(work.w_arb_rear_left_y, work.w_arb_rear_left_y, s7_9);
  work.s7_211 = fma(work.w_chassis_x, work.w_arb_rear_left_y, work.alpha_arb_rear_left_z);
  work.s7_212 = fma(work.w_chassis_z, work.w_arb_rear_left_y, work.alpha_arb_rear_left_x);
  work.s7_213 = fms(work.w_chassis_x, work.w_arb_rear_left_y, work.alpha_arb_rear_left_z);
  work.s7_214 = fms(work.w_chassis_z, work.w_arb_rear_left_y, work.alpha_arb_rear_left_x);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_215 = fma(work.s1_46, work.s7_190, work.a_rear_axle_aux3_x);
  work.a_wheel_rear_right_x = fnma(work.s1_47, work.s7_197, fnma(work.s1_48, work.s7_193, s7_215));
  work.a_wheel_rear_right_y = fma(work.s1_47, work.s7_191, work.a_rear_axle_aux3_y) - s7_199;
  const double s7_216 = fma(work.s1_48, work.s7_189, work.a_rear_axle_aux3_z);
  work.a_wheel_rear_right_z = fnma(work.s1_47, work.s7_192, fnma(work.s1_46, work.s7_196, s7_216));
  const double zdd_wheel_rear_right = derivative.zdd[Coordinate::wheel_rear_right];
  const double s7_217 = fma(zdd_wheel_rear_right, work.R_rear_axle_x_y, work.alpha_rear_axle_x);
  work.alpha_wheel_rear_right_x = fnma(work.w_rear_axle_z, s4_37, fma(work.w_rear_axle_y, s4_38,
      s7_217));
  const double s7_218 = fma(zdd_wheel_rear_right, work.R_rear_axle_y_y, work.alpha_rear_axle_y);
  work.alpha_wheel_rear_right_y = fnma(work.w_rear_axle_x, s4_38, fma(work.w_rear_axle_z, s4_36,
      s7_218));
  const double s7_219 = fma(zdd_wheel_rear_right, work.R_rear_axle_z_y, work.alpha_rear_axle_z);
  work.alpha_wheel_rear_right_z = fnma(work.w_rear_axle_y, s4_36, fma(work.w_rear_axle_x, s4_37,
      s7_219));
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.a_arb_rear_right_x = fnma(p_arb_front_left_y, work.s7_18, work.a_chassis_x + s7_204);
  work.a_arb_rear_right_y = fma(p_arb_front_left_y, work.s7_13, work.a_chassis_y) - s7_205;
  work.a_arb_rear_right_z = fnma(p_arb_front_left_y, work.s7_15, work.a_chassis_z + s7_206);
  work.alpha_arb_rear_right_x = fnma(zd_arb_rear_right, work.w_chassis_z, alpha_chassis_x);
  work.alpha_arb_rear_right_y = derivative.zdd[Coordinate::arb_rear_right] + alpha_chassis_y;
  work.alpha_arb_rear_right_z = fma(zd_arb_rear_right, work.w_chassis_x, alpha_chassis_z);
  work.s7_220 = fma(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_rear_right_y);
  work.s7_221 = fms(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_rear_right_y);
  work.s7_222 = fma(work.w_arb_rear_right_y, work.w_arb_rear_right_y, s7_10);
  work.s7_223 = fma(work.w_arb_rear_right_y, work.w_arb_rear_right_y, s7_9);
  work.s7_224 = fma(work.w_chassis_x, work.w_arb_rear_right_y, work.alpha_arb_rear_right_z);
  work.s7_225 = fma(work.w_chassis_z, work.w_arb_rear_right_y, work.alpha_arb_rear_right_x);
  work.s7_226 = fms(work.w_chassis_x, work.w_arb_rear_right_y, work.alpha_arb_rear_right_z);
  work.s7_227 = fms(work.w_chassis_z, work.w_arb_rear_right_y, work.alpha_arb_rear_right_x);
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_228 = -p_arb_link_front_left_from_x*R_arb_front_left_x_z;
  work.s7_229 = fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s7_228);
  const double s7_230 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s7_231 = fnma(-p_arb_link_front_left_from_x, R_arb_front_left_x_x, s7_230);
  const double s7_232 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s7_233 = work.s1_12 + work.R_carrier_left_x_z;
  work.s7_234 = fma(-p_arb_link_front_left_to_y, s7_233, s7_232);
  const double s7_235 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s7_236 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s7_237 = fma(-p_arb_link_front_left_to_y, s7_235, s7_236);
  const double s7_238 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s7_239 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s7_240 = fma(-p_arb_link_front_left_to_y, s7_238, s7_239);
  const double s7_241 = fnma(p_arb_link_front_left_from_y, work.s7_13, a_arb_front_left_y);
  const double s7_242 = fma(s7_90, work.s7_229, fma(s7_87, work.s7_231, s7_241));
  work.s7_243 = 0.3333333333333333*s7_242;
  const double s7_244 = fma(p_arb_link_front_left_from_y, work.s7_88, work.a_arb_front_left_z);
  const double s7_245 = fnma(work.s7_85, work.s7_229, fma(work.s7_84, work.s7_231, s7_244));
  work.s7_246 = 0.3333333333333333*s7_245;
  const double s7_247 = fma(p_arb_link_front_left_from_y, work.s7_89, work.a_arb_front_left_x);
  const double s7_248 = fnma(work.s7_86, work.s7_231, fma(work.s7_83, work.s7_229, s7_247));
  work.s7_249 = 0.3333333333333333*s7_248;
  const double s7_250 = fma(work.s7_55, work.s7_237, work.a_carrier_left_aux1_z);
  const double s7_251 = fnma(work.s7_52, work.s7_240, fma(work.s7_56, work.s7_234, s7_250));
  work.s7_252 = 0.3333333333333333*s7_251;
  const double s7_253 = fma(work.s7_57, work.s7_237, work.a_carrier_left_aux1_x);
  const double s7_254 = fnma(work.s7_50, work.s7_234, fma(work.s7_53, work.s7_240, s7_253));
  work.s7_255 = 0.3333333333333333*s7_254;
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_256 = -p_arb_link_front_right_from_x*R_arb_front_right_x_z;
  work.s7_257 = fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s7_256);
  const double s7_258 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s7_259 = fnma(-p_arb_link_front_right_from_x, R_arb_front_right_x_x, s7_258);
  const double s7_260 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s7_261 = work.R_carrier_right_x_z - work.s1_30;
  work.s7_262 = fma(-p_arb_link_front_left_to_y, s7_261, s7_260);
  const double s7_263 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s7_264 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s7_265 = fma(-p_arb_link_front_left_to_y, s7_263, s7_264);
  const double s7_266 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s7_267 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s7_268 = fma(-p_arb_link_front_left_to_y, s7_266, s7_267);
  const double s7_269 = fma(p_arb_link_front_left_from_y, work.s7_13, a_arb_front_right_y);
  const double s7_270 = fma(s7_145, work.s7_257, fma(s7_142, work.s7_259, s7_269));
  work.s7_271 = 0.3333333333333333*s7_270;
  const double s7_272 = fma(work.s7_139, work.s7_259, work.a_arb_front_right_z);
  const double s7_273 = fnma(work.s7_140, work.s7_257, s7_272);
  const double s7_274 = fnma(-p_arb_link_front_right_from_y, work.s7_143, s7_273);
  work.s7_275 = 0.3333333333333333*s7_274;
  const double s7_276 = fma(work.s7_138, work.s7_257, work.a_arb_front_right_x);
  const double s7_277 = fnma(work.s7_141, work.s7_259, s7_276);
  const double s7_278 = fnma(-p_arb_link_front_right_from_y, work.s7_144, s7_277);
  work.s7_279 = 0.3333333333333333*s7_278;
  const double s7_280 = fma(work.s7_121, work.s7_265, work.a_carrier_right_aux1_z);
  const double s7_281 = fnma(work.s7_118, work.s7_268, fma(work.s7_122, work.s7_262, s7_280));
  work.s7_282 = 0.3333333333333333*s7_281;
  const double s7_283 = fma(work.s7_123, work.s7_265, work.a_carrier_right_aux1_x);
  const double s7_284 = fnma(work.s7_116, work.s7_262, fma(work.s7_119, work.s7_268, s7_283));
  work.s7_285 = 0.3333333333333333*s7_284;
  // drag_link
  work.s7_286 = -p_drag_link_from_z*work.sines[15];
  work.s7_287 = -p_drag_link_from_z*work.cosines[15];
  work.s7_288 = p_drag_link_to_y*work.sines[16];
  work.s7_289 = p_drag_link_to_y*work.cosines[16];
  const double s7_290 = fma(work.s7_153, work.s7_286, work.a_pitman_arm_x);
  work.s7_291 = 1.5*fnma(work.s7_150, work.s7_287, s7_290);
  const double s7_292 = fma(work.s7_163, work.s7_289, work.a_bell_crank_z);
  work.s7_293 = 1.5*fnma(work.s7_164, work.s7_288, s7_292);
  const double s7_294 = fma(work.s7_161, work.s7_288, work.a_bell_crank_x);
  work.s7_295 = 1.5*fma(work.s7_160, work.s7_289, s7_294);
  work.s7_296 = 1.5*fnma(s7_155, work.s7_287, fnma(s7_154, work.s7_286, a_pitman_arm_y));
  // tie_rod_left
  work.s7_297 = -p_tie_rod_left_to_y*work.R_carrier_left_aux2_z_y;
}

/// Part 2 of compute_multipliers: step 7: inertias of the bodies and forces on joints.
[[gnu::noinline]] void compute_multipliers_2(const double* tau,
    ConstraintForcesWork& __restrict work, ConstraintForces& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // tie_rod_left
  work.s7_298 = -p_tie_rod_left_to_y*work.R_carrier_left_aux2_y_y;
  const double R_bell_crank_y_x = work.sines[16];
  const double s7_299 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s7_300 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  const double R_bell_crank_x_x = work.cosines[16];
  work.s7_301 = fma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s7_299);
  work.s7_302 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_300);
  work.s7_303 = -p_tie_rod_left_to_y*work.s1_12;
  const double s7_304 = fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, work.s7_303);
  work.s7_305 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_x_x, s7_304);
  const double s7_306 = fms(p_tie_rod_left_to_z, work.R_carrier_left_y_z, work.s7_298);
  work.s7_307 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_y_x, s7_306);
  const double s7_308 = fms(p_tie_rod_left_to_z, work.R_carrier_left_z_z, work.s7_297);
  work.s7_309 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_z_x, s7_308);
  const double s7_310 = fma(work.s7_163, work.s7_302, work.a_bell_crank_z);
  const double s7_311 = 1.1666666666666667*fnma(work.s7_164, work.s7_301, s7_310);
  const double s7_312 = fma(work.s7_161, work.s7_301, work.a_bell_crank_x);
  const double s7_313 = 1.1666666666666667*fma(work.s7_160, work.s7_302, s7_312);
  const double s7_314 = fnma(work.s7_159, work.s7_301, work.a_bell_crank_y);
  const double s7_315 = 1.1666666666666667*fnma(work.s7_162, work.s7_302, s7_314);
  const double s7_316 = fma(work.s7_54, work.s7_305, work.a_carrier_left_aux1_y);
  const double s7_317 = fnma(work.s7_51, work.s7_307, fma(work.s7_58, work.s7_309, s7_316));
  const double s7_318 = 1.1666666666666667*s7_317;
  const double s7_319 = fma(work.s7_57, work.s7_307, work.a_carrier_left_aux1_x);
  const double s7_320 = fnma(work.s7_50, work.s7_305, fma(work.s7_53, work.s7_309, s7_319));
  const double s7_321 = 1.1666666666666667*s7_320;
  // tie_rod_right
  work.s7_322 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_300);
  work.s7_323 = p_tie_rod_right_to_y*work.s1_30;
  work.s7_324 = fnma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s7_299);
  const double s7_325 = fms(p_tie_rod_right_to_z, work.R_carrier_right_x_z, work.s7_323);
  work.s7_326 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_x_x, s7_325);
  work.s7_327 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s7_328 = fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, work.s7_327);
  work.s7_329 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_y_x, s7_328);
  work.s7_330 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s7_331 = fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, work.s7_330);
  work.s7_332 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_z_x, s7_331);
  const double s7_333 = fma(work.s7_159, work.s7_324, work.a_bell_crank_y);
  const double s7_334 = 1.1666666666666667*fma(work.s7_162, work.s7_322, s7_333);
  const double s7_335 = fma(work.s7_164, work.s7_324, work.a_bell_crank_z);
  const double s7_336 = 1.1666666666666667*fnma(work.s7_163, work.s7_322, s7_335);
  const double s7_337 = fnma(work.s7_161, work.s7_324, work.a_bell_crank_x);
  const double s7_338 = 1.1666666666666667*fnma(work.s7_160, work.s7_322, s7_337);
  const double s7_339 = fma(work.s7_123, work.s7_329, work.a_carrier_right_aux1_x);
  const double s7_340 = fnma(work.s7_116, work.s7_326, fma(work.s7_119, work.s7_332, s7_339));
  const double s7_341 = 1.1666666666666667*s7_340;
  const double s7_342 = fma(work.s7_120, work.s7_326, work.a_carrier_right_aux1_y);
  const double s7_343 = fnma(work.s7_117, work.s7_329, fma(work.s7_124, work.s7_332, s7_342));
  const double s7_344 = 1.1666666666666667*s7_343;
  // long_rod_left
  const double s1_43 = work.sines[18];
  const double s7_345 = p_long_rod_left_to_x*s1_43;
  const double s7_346 = fma(-p_long_rod_left_to_z, work.R_rear_axle_z_z, s7_345);
  const double s7_347 = -p_long_rod_left_from_x*work.s7_17;
  const double s7_348 = fma(-p_long_rod_left_from_z, work.s7_14, s7_347);
  work.s7_349 = fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_346);
  const double s7_350 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_351 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_x_z, s7_350);
  work.s7_352 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_351);
  const double s7_353 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_354 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_y_z, s7_353);
  work.s7_355 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_354);
  const double s7_356 = -p_long_rod_left_from_z*work.s7_11;
  const double s7_357 = work.a_chassis_z + fnma(-p_long_rod_left_from_x, work.s7_19, s7_356);
  const double s7_358 = 3.0*fma(p_long_rod_left_from_y, work.s7_15, s7_357);
  const double s7_359 = -p_long_rod_left_from_x*work.s7_12;
  const double s7_360 = work.a_chassis_x + fnma(-p_long_rod_left_from_z, work.s7_16, s7_359);
  const double s7_361 = 3.0*fma(p_long_rod_left_from_y, work.s7_18, s7_360);
  const double s7_362 = fnma(p_long_rod_left_from_y, work.s7_13, work.a_chassis_y) - s7_348;
  const double s7_363 = 3.0*s7_362;
  // diag_rod_left
  const double s7_364 = -p_diag_rod_left_from_x*work.s7_17;
  const double s7_365 = fma(-p_diag_rod_left_from_z, work.s7_14, s7_364);
  const double s7_366 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  work.s7_367 = fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s7_366);
  const double s7_368 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  work.s7_369 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_368);
  const double s7_370 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  work.s7_371 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_370);
  const double s7_372 = -p_diag_rod_left_from_z*work.s7_11;
  const double s7_373 = fnma(-p_diag_rod_left_from_x, work.s7_19, s7_372);
  const double s7_374 = 2.6666666666666665*(work.s7_26 + s7_373);
  const double s7_375 = -p_diag_rod_left_from_x*work.s7_12;
  const double s7_376 = fnma(-p_diag_rod_left_from_z, work.s7_16, s7_375);
  const double s7_377 = 2.6666666666666665*(work.s7_21 + s7_376);
  const double s7_378 = fnma(p_lower_arm_left_y, work.s7_13, work.a_chassis_y) - s7_365;
  const double s7_379 = 2.6666666666666665*s7_378;
  // arb_link_rear_left
  const double R_arb_rear_left_x_z = work.sines[20];
  work.s7_380 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_z;
  const double s7_381 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_382 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s7_381);
  const double s7_383 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_384 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s7_383);
  const double R_arb_rear_left_x_x = work.cosines[20];
  work.s7_385 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_x;
  const double s7_386 = -p_arb_link_rear_left_to_x*s1_43;
  const double s7_387 = fnma(-p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s7_386);
  work.s7_388 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s7_387);
  work.s7_389 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_384);
  work.s7_390 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_382);
  const double s7_391 = fma(p_arb_link_rear_left_from_y, work.s7_212, work.a_arb_rear_left_z);
  const double s7_392 = fma(work.s7_208, work.s7_385, fma(work.s7_209, work.s7_380, s7_391));
  const double s7_393 = 0.3333333333333333*s7_392;
  const double s7_394 = fma(p_arb_link_rear_left_from_y, work.s7_213, work.a_arb_rear_left_x);
  const double s7_395 = fnma(work.s7_210, work.s7_385, fnma(work.s7_207, work.s7_380, s7_394));
  const double s7_396 = 0.3333333333333333*s7_395;
  const double s7_397 = fnma(p_arb_link_rear_left_from_y, work.s7_13, work.a_arb_rear_left_y);
  const double s7_398 = fnma(work.s7_214, work.s7_380, fma(work.s7_211, work.s7_385, s7_397));
  const double s7_399 = 0.3333333333333333*s7_398;
  const double s7_400 = fma(work.s7_192, work.s7_390, work.a_rear_axle_aux3_z);
  const double s7_401 = fnma(work.s7_189, work.s7_388, fma(work.s7_196, work.s7_389, s7_400));
  const double s7_402 = 0.3333333333333333*s7_401;
  const double s7_403 = fma(work.s7_197, work.s7_390, work.a_rear_axle_aux3_x);
  const double s7_404 = fnma(work.s7_190, work.s7_389, fma(work.s7_193, work.s7_388, s7_403));
  const double s7_405 = 0.3333333333333333*s7_404;
  // long_rod_right
  work.s7_406 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_346);
  work.s7_407 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_351);
  work.s7_408 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_354);
  const double s7_409 = 3.0*(fma(p_long_rod_left_from_y, work.s7_13, work.a_chassis_y) - s7_348);
  const double s7_410 = 3.0*fnma(p_long_rod_left_from_y, work.s7_15, s7_357);
  const double s7_411 = 3.0*fnma(p_long_rod_left_from_y, work.s7_18, s7_360);
  // diag_rod_right
  work.s7_412 = fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s7_366);
  work.s7_413 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_368);
  work.s7_414 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_370);
  const double s7_415 = fma(p_lower_arm_left_y, work.s7_13, work.a_chassis_y) - s7_365;
  const double s7_416 = 2.6666666666666665*s7_415;
  const double s7_417 = fnma(p_lower_arm_left_y, work.s7_15, work.a_chassis_z + s7_373);
  const double s7_418 = 2.6666666666666665*s7_417;
  const double s7_419 = fnma(p_lower_arm_left_y, work.s7_18, work.a_chassis_x + s7_376);
  const double s7_420 = 2.6666666666666665*s7_419;
  // arb_link_rear_right
  work.s7_421 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_382);
  work.s7_422 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_384);
  const double R_arb_rear_right_x_z = work.sines[21];
  work.s7_423 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_z;
  work.s7_424 = fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s7_387);
  const double R_arb_rear_right_x_x = work.cosines[21];
  work.s7_425 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_x;
  const double s7_426 = fma(work.s7_190, work.s7_422, work.a_rear_axle_aux3_x);
  const double s7_427 = fnma(work.s7_197, work.s7_421, fma(work.s7_193, work.s7_424, s7_426));
  const double s7_428 = 0.3333333333333333*s7_427;
  const double s7_429 = fnma(work.s7_192, work.s7_421, work.a_rear_axle_aux3_z);
  const double s7_430 = fnma(work.s7_196, work.s7_422, fnma(work.s7_189, work.s7_424, s7_429));
  const double s7_431 = 0.3333333333333333*s7_430;
  const double s7_432 = fma(p_arb_link_rear_left_from_y, work.s7_13, work.a_arb_rear_right_y);
  const double s7_433 = fnma(work.s7_227, work.s7_423, fma(work.s7_224, work.s7_425, s7_432));
  const double s7_434 = 0.3333333333333333*s7_433;
  const double s7_435 = fma(work.s7_222, work.s7_423, work.a_arb_rear_right_z);
  const double s7_436 = fma(work.s7_221, work.s7_425, s7_435);
  const double s7_437 = fnma(-p_arb_link_rear_right_from_y, work.s7_225, s7_436);
  const double s7_438 = 0.3333333333333333*s7_437;
  const double s7_439 = fnma(-p_arb_link_rear_right_from_y, work.s7_226, work.a_arb_rear_right_x);
  const double s7_440 = fnma(work.s7_223, work.s7_425, fnma(work.s7_220, work.s7_423, s7_439));
  const double s7_441 = 0.3333333333333333*s7_440;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_442 = c_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s7_443 = c_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s7_444 = fnma(-c_arb_rear_right_y, work.s7_226, work.a_arb_rear_right_x);
  const double s7_445 = fnma(work.s7_223, s7_443, fnma(work.s7_220, s7_442, s7_444));
  const double s7_446 = fma(work.s7_222, s7_442, work.a_arb_rear_right_z);
  const double s7_447 = fnma(-c_arb_rear_right_y, work.s7_225, fma(work.s7_221, s7_443, s7_446));
  const double s7_448 = R_arb_rear_right_x_x*work.w_chassis_x;
  const double s7_449 = fnma(R_arb_rear_right_x_z, work.w_chassis_z, s7_448);
  const double s7_450 = I_arb_rear_right_xy*work.w_arb_rear_right_y;
  const double s7_451 = R_arb_rear_right_x_x*work.alpha_arb_rear_right_x;
  const double s7_452 = R_arb_rear_right_x_z*work.w_chassis_x;
  const double s7_453 = fma(R_arb_rear_right_x_x, work.w_chassis_z, s7_452);
  const double s7_454 = fnma(R_arb_rear_right_x_z, work.alpha_arb_rear_right_z, s7_451);
  const double s7_455 = I_arb_rear_right_yy*work.alpha_arb_rear_right_y;
  const double s7_456 = fma(I_arb_rear_right_xx, s7_449, s7_450);
  const double s7_457 = fma(s7_456, s7_453, fma(I_arb_rear_right_xy, s7_454, s7_455));
  const double s7_458 = fnma(s7_449, I_arb_rear_right_zz*s7_453, s7_457);
  const double s7_459 = fnma(s7_442, m_arb_rear_right*s7_445, s7_458);
  const double s7_460 = fnma(work.s7_423, s7_428, fnma(s7_443, m_arb_rear_right*s7_447, s7_459));
  const double n_arb_rear_right_y = fnma(work.s7_425, s7_431, s7_460);
  result.missing[21] = tau[Coordinate::arb_rear_right] - n_arb_rear_right_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double f_wheel_rear_right_x = m_wheel_rear_right*work.a_wheel_rear_right_x;
  const double f_wheel_rear_right_y = m_wheel_rear_right*work.a_wheel_rear_right_y;
  const double f_wheel_rear_right_z = m_wheel_rear_right*work.a_wheel_rear_right_z;
  const double s7_461 = work.R_rear_axle_y_y*work.alpha_wheel_rear_right_y;
  const double s7_462 = fma(work.R_rear_axle_z_y, work.alpha_wheel_rear_right_z, s7_461);
  const double s7_463 = work.R_rear_axle_y_z*work.w_wheel_rear_right_y;
  const double s7_464 = fma(work.R_rear_axle_z_z, work.w_wheel_rear_right_z, s7_463);
  const double s7_465 = fma(work.R_rear_axle_x_z, work.w_wheel_rear_right_x, s7_464);
  const double s7_466 = work.R_rear_axle_aux5_y_x*work.w_wheel_rear_right_y;
  const double s7_467 = fma(work.R_rear_axle_aux5_x_x, work.w_wheel_rear_right_x, s7_466);
  const double s7_468 = fnma(s1_43, work.w_wheel_rear_right_z, s7_467);
  const double s7_469 = I_wheel_rear_right_xx*s7_468;
  const double s7_470 = I_wheel_rear_right_zz*s7_465;
  const double s7_471 = fma(work.R_rear_axle_x_y, work.alpha_wheel_rear_right_x, s7_462);
  const double s7_472 = fnma(s7_468, s7_470, fma(s7_465, s7_469, I_wheel_rear_right_yy*s7_471));
  const double s7_473 = work.R_rear_axle_aux5_y_x*work.alpha_wheel_rear_right_y;
  const double s7_474 = fma(work.R_rear_axle_aux5_x_x, work.alpha_wheel_rear_right_x, s7_473);
  const double s7_475 = work.R_rear_axle_y_y*work.w_wheel_rear_right_y;
  const double s7_476 = fma(work.R_rear_axle_z_y, work.w_wheel_rear_right_z, s7_475);
  const double s7_477 = fma(work.R_rear_axle_x_y, work.w_wheel_rear_right_x, s7_476);
  const double s7_478 = I_wheel_rear_right_yy*s7_477;
  const double s7_479 = I_wheel_rear_right_xx*fnma(s1_43, work.alpha_wheel_rear_right_z, s7_474);
  const double s7_480 = fnma(s7_465, s7_478, fma(s7_470, s7_477, s7_479));
  const double s7_481 = work.R_rear_axle_y_z*work.alpha_wheel_rear_right_y;
  const double s7_482 = fma(work.R_rear_axle_z_z, work.alpha_wheel_rear_right_z, s7_481);
  const double s7_483 = fma(work.R_rear_axle_x_z, work.alpha_wheel_rear_right_x, s7_482);
  const double s7_484 = fnma(s7_469, s7_477, fma(s7_468, s7_478, I_wheel_rear_right_zz*s7_483));
  const double s7_485 = fma(work.R_rear_axle_aux5_x_x, s7_480, work.R_rear_axle_x_y*s7_472);
  const double n_wheel_rear_right_x = fma(work.R_rear_axle_x_z, s7_484, s7_485);
  const double s7_486 = fma(work.R_rear_axle_aux5_y_x, s7_480, work.R_rear_axle_y_y*s7_472);
  const double n_wheel_rear_right_y = fma(work.R_rear_axle_y_z, s7_484, s7_486);
  const double s7_487 = fma(work.R_rear_axle_z_z, s7_484, work.R_rear_axle_z_y*s7_472);
  const double n_wheel_rear_right_z = fnma(s1_43, s7_480, s7_487);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_488 = c_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_489 = c_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s7_490 = fma(c_arb_rear_left_y, work.s7_213, work.a_arb_rear_left_x);
  const double s7_491 = fnma(work.s7_210, s7_489, fnma(work.s7_207, s7_488, s7_490));
  const double s7_492 = fma(c_arb_rear_left_y, work.s7_212, work.a_arb_rear_left_z);
  const double s7_493 = fma(work.s7_208, s7_489, fma(work.s7_209, s7_488, s7_492));
  const double s7_494 = R_arb_rear_left_x_x*work.w_chassis_x;
  const double s7_495 = fnma(R_arb_rear_left_x_z, work.w_chassis_z, s7_494);
  const double s7_496 = I_arb_rear_left_xx*s7_495;
  const double s7_497 = R_arb_rear_left_x_x*work.alpha_arb_rear_left_x;
  const double s7_498 = R_arb_rear_left_x_z*work.w_chassis_x;
  const double s7_499 = fma(R_arb_rear_left_x_x, work.w_chassis_z, s7_498);
  const double s7_500 = fnma(R_arb_rear_left_x_z, work.alpha_arb_rear_left_z, s7_497);
  const double s7_501 = I_arb_rear_left_yy*work.alpha_arb_rear_left_y;
  const double s7_502 = fnma(-I_arb_rear_left_xy, work.w_arb_rear_left_y, s7_496);
  const double s7_503 = fma(s7_502, s7_499, fnma(-I_arb_rear_left_xy, s7_500, s7_501));
  const double s7_504 = fnma(s7_495, I_arb_rear_left_zz*s7_499, s7_503);
  const double s7_505 = fnma(s7_488, m_arb_rear_left*s7_491, s7_504);
  const double s7_506 = fnma(work.s7_380, s7_405, fnma(s7_489, m_arb_rear_left*s7_493, s7_505));
  const double n_arb_rear_left_y = fnma(work.s7_385, s7_402, s7_506);
  result.missing[20] = tau[Coordinate::arb_rear_left] - n_arb_rear_left_y;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double f_wheel_rear_left_x = m_wheel_rear_left*work.a_wheel_rear_left_x;
  const double f_wheel_rear_left_y = m_wheel_rear_left*work.a_wheel_rear_left_y;
  const double f_wheel_rear_left_z = m_wheel_rear_left*work.a_wheel_rear_left_z;
  const double s7_507 = work.R_rear_axle_y_y*work.alpha_wheel_rear_left_y;
  const double s7_508 = fma(work.R_rear_axle_z_y, work.alpha_wheel_rear_left_z, s7_507);
  const double s7_509 = work.R_rear_axle_y_z*work.w_wheel_rear_left_y;
  const double s7_510 = fma(work.R_rear_axle_z_z, work.w_wheel_rear_left_z, s7_509);
  const double s7_511 = fma(work.R_rear_axle_x_z, work.w_wheel_rear_left_x, s7_510);
  const double s7_512 = work.R_rear_axle_aux5_y_x*work.w_wheel_rear_left_y;
  const double s7_513 = fma(work.R_rear_axle_aux5_x_x, work.w_wheel_rear_left_x, s7_512);
  const double s7_514 = fnma(s1_43, work.w_wheel_rear_left_z, s7_513);
  const double s7_515 = I_wheel_rear_left_xx*s7_514;
  const double s7_516 = I_wheel_rear_left_zz*s7_511;
  const double s7_517 = fma(work.R_rear_axle_x_y, work.alpha_wheel_rear_left_x, s7_508);
  const double s7_518 = fnma(s7_514, s7_516, fma(s7_511, s7_515, I_wheel_rear_left_yy*s7_517));
  const double s7_519 = work.R_rear_axle_aux5_y_x*work.alpha_wheel_rear_left_y;
  const double s7_520 = fma(work.R_rear_axle_aux5_x_x, work.alpha_wheel_rear_left_x, s7_519);
  const double s7_521 = work.R_rear_axle_y_y*work.w_wheel_rear_left_y;
  const double s7_522 = fma(work.R_rear_axle_z_y, work.w_wheel_rear_left_z, s7_521);
  const double s7_523 = fma(work.R_rear_axle_x_y, work.w_wheel_rear_left_x, s7_522);
  const double s7_524 = I_wheel_rear_left_yy*s7_523;
  const double s7_525 = I_wheel_rear_left_xx*fnma(s1_43, work.alpha_wheel_rear_left_z, s7_520);
  const double s7_526 = fnma(s7_511, s7_524, fma(s7_516, s7_523, s7_525));
  const double s7_527 = work.R_rear_axle_y_z*work.alpha_wheel_rear_left_y;
  const double s7_528 = fma(work.R_rear_axle_z_z, work.alpha_wheel_rear_left_z, s7_527);
  const double s7_529 = fma(work.R_rear_axle_x_z, work.alpha_wheel_rear_left_x, s7_528);
  const double s7_530 = fnma(s7_515, s7_523, fma(s7_514, s7_524, I_wheel_rear_left_zz*s7_529));
  const double s7_531 = fma(work.R_rear_axle_aux5_x_x, s7_526, work.R_rear_axle_x_y*s7_518);
  const double n_wheel_rear_left_x = fma(work.R_rear_axle_x_z, s7_530, s7_531);
  const double s7_532 = fma(work.R_rear_axle_aux5_y_x, s7_526, work.R_rear_axle_y_y*s7_518);
  const double n_wheel_rear_left_y = fma(work.R_rear_axle_y_z, s7_530, s7_532);
  const double s7_533 = fma(work.R_rear_axle_z_z, s7_530, work.R_rear_axle_z_y*s7_518);
  const double n_wheel_rear_left_z = fnma(s1_43, s7_526, s7_533);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_534 = c_rear_axle_x*work.R_rear_axle_aux5_y_x;
  const double s7_535 = fma(c_rear_axle_z, work.R_rear_axle_y_z, s7_534);
  const double s7_536 = fnma(c_rear_axle_x, s1_43, c_rear_axle_z*work.R_rear_axle_z_z);
  const double s7_537 = c_rear_axle_x*work.R_rear_axle_aux5_x_x;
  const double s7_538 = fma(c_rear_axle_z, work.R_rear_axle_x_z, s7_537);
  const double s7_539 = fma(work.s7_197, s7_535, work.a_rear_axle_aux3_x);
  const double s7_540 = m_rear_axle*fnma(work.s7_190, s7_538, fma(work.s7_193, s7_536, s7_539));
  const double f_rear_axle_x = s7_377 + (s7_361 + (s7_396 + (s7_411 + (s7_420 + (s7_441 +
      s7_540)))));
  const double s7_541 = fma(work.s7_194, s7_538, work.a_rear_axle_aux3_y);
  const double s7_542 = m_rear_axle*fnma(work.s7_191, s7_535, fma(work.s7_195, s7_536, s7_541));
  const double f_rear_axle_y = s7_379 + (s7_363 + (s7_399 + (s7_409 + (s7_416 + (s7_434 +
      s7_542)))));
  const double s7_543 = fma(work.s7_192, s7_535, work.a_rear_axle_aux3_z);
  const double s7_544 = m_rear_axle*fnma(work.s7_189, s7_536, fma(work.s7_196, s7_538, s7_543));
  const double f_rear_axle_z = s7_374 + (s7_358 + (s7_393 + (s7_410 + (s7_418 + (s7_438 +
      s7_544)))));
  const double s7_545 = work.R_rear_axle_y_y*work.alpha_rear_axle_y;
  const double s7_546 = fma(work.R_rear_axle_z_y, work.alpha_rear_axle_z, s7_545);
  const double s7_547 = work.R_rear_axle_y_z*work.w_rear_axle_y;
  const double s7_548 = fma(work.R_rear_axle_z_z, work.w_rear_axle_z, s7_547);
  const double s7_549 = fma(work.R_rear_axle_x_z, work.w_rear_axle_x, s7_548);
  const double s7_550 = work.R_rear_axle_aux5_y_x*work.w_rear_axle_y;
  const double s7_551 = fma(work.R_rear_axle_aux5_x_x, work.w_rear_axle_x, s7_550);
  const double s7_552 = fnma(s1_43, work.w_rear_axle_z, s7_551);
  const double s7_553 = fnma(-I_rear_axle_xz, s7_549, I_rear_axle_xx*s7_552);
  const double s7_554 = fnma(-I_rear_axle_xz, s7_552, I_rear_axle_zz*s7_549);
  const double s7_555 = I_rear_axle_yy*fma(work.R_rear_axle_x_y, work.alpha_rear_axle_x, s7_546);
  const double s7_556 = fnma(s7_552, s7_554, fma(s7_549, s7_553, s7_555));
  const double s7_557 = work.R_rear_axle_aux5_y_x*work.alpha_rear_axle_y;
  const double s7_558 = fma(work.R_rear_axle_aux5_x_x, work.alpha_rear_axle_x, s7_557);
  const double s7_559 = fnma(s1_43, work.alpha_rear_axle_z, s7_558);
  const double s7_560 = work.R_rear_axle_y_z*work.alpha_rear_axle_y;
  const double s7_561 = fma(work.R_rear_axle_z_z, work.alpha_rear_axle_z, s7_560);
  const double s7_562 = fma(work.R_rear_axle_x_z, work.alpha_rear_axle_x, s7_561);
  const double s7_563 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s7_564 = fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s7_563);
  const double s7_565 = fma(work.R_rear_axle_x_y, work.w_rear_axle_x, s7_564);
  const double s7_566 = I_rear_axle_yy*s7_565;
  const double s7_567 = fnma(-I_rear_axle_xz, s7_562, I_rear_axle_xx*s7_559);
  const double s7_568 = fnma(s7_549, s7_566, fma(s7_554, s7_565, s7_567));
  const double s7_569 = fnma(-I_rear_axle_xz, s7_559, I_rear_axle_zz*s7_562);
  const double s7_570 = fnma(s7_553, s7_565, fma(s7_552, s7_566, s7_569));
  const double s7_571 = fma(work.R_rear_axle_x_y, s7_556, fnma(s7_536, s7_542, s7_535*s7_544));
  const double s7_572 = fma(work.R_rear_axle_aux5_x_x, s7_568, s7_571);
  const double s7_573 = fnma(work.s7_349, s7_363, fma(work.R_rear_axle_x_z, s7_570, s7_572));
  const double s7_574 = fnma(work.s7_367, s7_379, fma(work.s7_355, s7_358, s7_573));
  const double s7_575 = fnma(work.s7_388, s7_399, fma(work.s7_371, s7_374, s7_574));
  const double s7_576 = fma(work.s7_408, s7_410, fma(work.s7_390, s7_393, s7_575));
  const double s7_577 = fnma(work.s7_412, s7_416, fma(work.s7_406, s7_409, s7_576));
  const double s7_578 = fnma(work.s7_424, s7_434, fma(work.s7_414, s7_418, s7_577));
  const double n_rear_axle_x = fnma(work.s7_421, s7_438, s7_578);
  const double s7_579 = fma(work.R_rear_axle_y_y, s7_556, fnma(s7_538, s7_544, s7_536*s7_540));
  const double s7_580 = fma(work.R_rear_axle_aux5_y_x, s7_568, s7_579);
  const double s7_581 = fnma(work.s7_352, s7_358, fma(work.R_rear_axle_y_z, s7_570, s7_580));
  const double s7_582 = fnma(work.s7_369, s7_374, fma(work.s7_349, s7_361, s7_581));
  const double s7_583 = fnma(work.s7_389, s7_393, fma(work.s7_367, s7_377, s7_582));
  const double s7_584 = fnma(work.s7_407, s7_410, fma(work.s7_388, s7_396, s7_583));
  const double s7_585 = fnma(work.s7_413, s7_418, fnma(work.s7_406, s7_411, s7_584));
  const double s7_586 = fma(work.s7_424, s7_441, fma(work.s7_412, s7_420, s7_585));
  const double n_rear_axle_y = fma(work.s7_422, s7_438, s7_586);
  const double s7_587 = fma(work.R_rear_axle_z_y, s7_556, fnma(s7_535, s7_540, s7_538*s7_542));
  const double s7_588 = fnma(s1_43, s7_568, fma(work.R_rear_axle_z_z, s7_570, s7_587));
  const double s7_589 = fma(work.s7_352, s7_363, fnma(work.s7_355, s7_361, s7_588));
  const double s7_590 = fma(work.s7_369, s7_379, fnma(work.s7_371, s7_377, s7_589));
  const double s7_591 = fma(work.s7_389, s7_399, fnma(work.s7_390, s7_396, s7_590));
  const double s7_592 = fma(work.s7_407, s7_409, fnma(work.s7_408, s7_411, s7_591));
  const double s7_593 = fma(work.s7_413, s7_416, fnma(work.s7_414, s7_420, s7_592));
  const double n_rear_axle_z = fma(work.s7_421, s7_441, fnma(work.s7_422, s7_434, s7_593));
  const double s7_594 = n_wheel_rear_left_y + (n_wheel_rear_right_y + n_rear_axle_y);
  const double s7_595 = fma(work.s1_46, f_wheel_rear_right_z - f_wheel_rear_left_z, s7_594);
  work.s7_596 = fma(work.s1_48, f_wheel_rear_left_x - f_wheel_rear_right_x, s7_595);
  const double s7_597 = n_wheel_rear_left_x + (n_wheel_rear_right_x + n_rear_axle_x);
  const double s7_598 = fma(work.s1_47, f_wheel_rear_left_z - f_wheel_rear_right_z, s7_597);
  work.s7_599 = fma(work.s1_48, f_wheel_rear_right_y - f_wheel_rear_left_y, s7_598);
  const double s7_600 = n_wheel_rear_left_z + (n_wheel_rear_right_z + n_rear_axle_z);
  const double s7_601 = fma(work.s1_46, f_wheel_rear_left_y - f_wheel_rear_right_y, s7_600);
  work.s7_602 = fma(work.s1_47, f_wheel_rear_right_x - f_wheel_rear_left_x, s7_601);
  const double s7_603 = fnma(work.R_rear_axle_aux5_y_x, work.s7_596, tau[Coordinate::rear_axle_rx]);
  const double s7_604 = fnma(work.R_rear_axle_aux5_x_x, work.s7_599, s7_603);
  result.missing[19] = fma(s1_43, work.s7_602, s7_604);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s7_605 = fnma(work.cosines[17], work.s7_596, tau[Coordinate::rear_axle_ry]);
  result.missing[18] = fma(work.sines[17], work.s7_599, s7_605);
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  result.missing[17] = tau[Coordinate::rear_axle_rz] - work.s7_602;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double s7_606 = tau[Coordinate::rear_axle_tz] - f_wheel_rear_right_z;
  work.Q_rear_axle_tz = s7_606 - f_wheel_rear_left_z - f_rear_axle_z;
  result.missing[16] = work.Q_rear_axle_tz;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double s7_607 = tau[Coordinate::rear_axle_ty] - f_wheel_rear_right_y;
  work.Q_rear_axle_ty = s7_607 - f_wheel_rear_left_y - f_rear_axle_y;
  result.missing[15] = work.Q_rear_axle_ty;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double s7_608 = tau[Coordinate::rear_axle_tx] - f_wheel_rear_right_x;
  work.Q_rear_axle_tx = s7_608 - f_wheel_rear_left_x - f_rear_axle_x;
  result.missing[14] = work.Q_rear_axle_tx;
  // bell_crank: bell_crank, revolute, chassis
  const double s7_609 = fma(-c_bell_crank_x, R_bell_crank_x_x, c_bell_crank_y*R_bell_crank_y_x);
  const double s7_610 = fnma(-c_bell_crank_x, R_bell_crank_y_x, c_bell_crank_y*R_bell_crank_x_x);
  const double s7_611 = fma(work.s7_160, s7_610, fma(work.s7_161, s7_609, work.a_bell_crank_x));
  const double s7_612 = fnma(work.s7_159, s7_609, work.a_bell_crank_y);
  const double s7_613 = R_bell_crank_x_x*work.w_chassis_y;
  const double s7_614 = fnma(R_bell_crank_y_x, work.w_chassis_x, s7_613);
  const double s7_615 = R_bell_crank_y_x*work.w_chassis_y;
  const double s7_616 = fma(R_bell_crank_x_x, work.w_chassis_x, s7_615);
  const double s7_617 = fnma(-I_bell_crank_xy, s7_616, I_bell_crank_yy*s7_614);
  const double s7_618 = fma(s7_616, s7_617, I_bell_crank_zz*work.alpha_bell_crank_z);
  const double s7_619 = fnma(-I_bell_crank_xy, s7_614, I_bell_crank_xx*s7_616);
  const double s7_620 = m_bell_crank*fnma(work.s7_162, s7_610, s7_612);
  const double s7_621 = fnma(s7_609, s7_620, fnma(s7_614, s7_619, s7_618));
  const double s7_622 = fnma(s7_610, m_bell_crank*s7_611, s7_621);
  const double s7_623 = fnma(work.s7_289, work.s7_291, fnma(work.s7_288, work.s7_296, s7_622));
  const double s7_624 = fnma(work.s7_301, s7_318, fnma(work.s7_302, s7_321, s7_623));
  const double n_bell_crank_z = fma(work.s7_322, s7_341, fma(work.s7_324, s7_344, s7_624));
  result.missing[13] = tau[Coordinate::bell_crank] - n_bell_crank_z;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  const double s7_625 = -c_pitman_arm_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  const double s7_626 = -c_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_627 = fnma(work.s7_150, s7_626, fma(work.s7_153, s7_625, work.a_pitman_arm_x));
  const double s7_628 = fnma(work.s7_151, s7_625, fma(work.s7_152, s7_626, work.a_pitman_arm_z));
  const double s7_629 = R_pitman_arm_x_x*work.w_chassis_x;
  const double s7_630 = fnma(R_pitman_arm_x_z, work.w_chassis_z, s7_629);
  const double s7_631 = R_pitman_arm_x_z*work.w_chassis_x;
  const double s7_632 = fma(R_pitman_arm_x_x, work.w_chassis_z, s7_631);
  const double s7_633 = I_pitman_arm_yy*work.alpha_pitman_arm_y;
  const double s7_634 = fma(I_pitman_arm_xx*s7_630, s7_632, s7_633);
  const double s7_635 = fnma(s7_630, I_pitman_arm_zz*s7_632, s7_634);
  const double s7_636 = fma(s7_625, m_pitman_arm*s7_628, s7_635);
  const double s7_637 = fnma(s7_626, m_pitman_arm*s7_627, s7_636);
  const double n_pitman_arm_y = fma(work.s7_286, work.s7_293, fnma(work.s7_287, work.s7_295,
      s7_637));
  work.Q_pitman_arm = tau[Coordinate::pitman_arm] - n_pitman_arm_y;
  result.missing[12] = work.Q_pitman_arm;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_638 = -c_arb_front_right_x*R_arb_front_right_x_z;
  const double s7_639 = fma(c_arb_front_right_z, R_arb_front_right_x_x, s7_638);
  const double s7_640 = c_arb_front_right_z*R_arb_front_right_x_z;
  const double s7_641 = fnma(-c_arb_front_right_x, R_arb_front_right_x_x, s7_640);
  const double s7_642 = fma(work.s7_138, s7_639, work.a_arb_front_right_x);
  const double s7_643 = fnma(work.s7_141, s7_641, s7_642);
  const double s7_644 = fma(work.s7_139, s7_641, work.a_arb_front_right_z);
  const double s7_645 = fnma(work.s7_140, s7_639, s7_644);
  const double s7_646 = R_arb_front_right_x_x*work.alpha_arb_front_right_x;
  const double s7_647 = R_arb_front_right_x_z*work.alpha_arb_front_right_x;
  const double s7_648 = R_arb_front_right_x_x*work.w_chassis_x;
  const double s7_649 = fnma(R_arb_front_right_x_z, work.w_chassis_z, s7_648);
  const double s7_650 = R_arb_front_right_x_z*work.w_chassis_x;
  const double s7_651 = fma(R_arb_front_right_x_x, work.w_chassis_z, s7_650);
  const double s7_652 = fma(I_arb_front_right_xx, s7_649, I_arb_front_right_xz*s7_651);
  const double s7_653 = I_arb_front_right_yz*work.w_arb_front_right_y;
  const double s7_654 = fma(I_arb_front_right_xz, s7_649, s7_653);
  const double s7_655 = fma(R_arb_front_right_x_x, work.alpha_arb_front_right_z, s7_647);
  const double s7_656 = I_arb_front_right_yy*work.alpha_arb_front_right_y;
  const double s7_657 = fnma(R_arb_front_right_x_z, work.alpha_arb_front_right_z, s7_646);
  const double s7_658 = fma(I_arb_front_right_yz, s7_655, s7_656);
  const double s7_659 = fnma(-I_arb_front_right_xy, work.w_arb_front_right_y, s7_652);
  const double s7_660 = fma(s7_651, s7_659, fnma(-I_arb_front_right_xy, s7_657, s7_658));
  const double s7_661 = m_arb_front_right*fnma(-c_arb_front_right_y, work.s7_144, s7_643);
  const double s7_662 = fnma(s7_649, fma(I_arb_front_right_zz, s7_651, s7_654), s7_660);
  const double s7_663 = m_arb_front_right*fnma(-c_arb_front_right_y, work.s7_143, s7_645);
  const double s7_664 = fnma(s7_641, s7_663, fma(s7_639, s7_661, s7_662));
  const double n_arb_front_right_y = fma(work.s7_257, work.s7_285, fnma(work.s7_259, work.s7_282,
      s7_664));
  work.Q_arb_front_right = tau[Coordinate::arb_front_right] - n_arb_front_right_y;
  result.missing[11] = work.Q_arb_front_right;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_665 = -c_upper_arm_right_z*R_upper_arm_right_z_y;
  const double s7_666 = fnma(-c_upper_arm_right_y, R_upper_arm_right_y_y, s7_665);
  const double s7_667 = -c_upper_arm_right_y*R_upper_arm_right_z_y;
  const double s7_668 = fma(-c_upper_arm_right_z, R_upper_arm_right_y_y, s7_667);
  const double s7_669 = fnma(work.s7_137, s7_666, work.a_upper_arm_right_y);
  const double f_upper_arm_right_y = m_upper_arm_right*fnma(work.s7_135, s7_668, s7_669);
  const double s7_670 = fma(work.s7_136, s7_668, work.a_upper_arm_right_z);
  const double f_upper_arm_right_z = m_upper_arm_right*fma(work.s7_134, s7_666, s7_670);
  const double s7_671 = R_upper_arm_right_z_y*work.w_chassis_z;
  const double s7_672 = fma(R_upper_arm_right_y_y, work.w_chassis_y, s7_671);
  const double s7_673 = R_upper_arm_right_y_y*work.w_chassis_z;
  const double s7_674 = fnma(R_upper_arm_right_z_y, work.w_chassis_y, s7_673);
  const double s7_675 = I_upper_arm_right_xx*work.alpha_upper_arm_right_x;
  const double s7_676 = fma(s7_672, I_upper_arm_right_zz*s7_674, s7_675);
  const double s7_677 = fnma(s7_674, I_upper_arm_right_yy*s7_672, s7_676);
  const double s7_678 = fma(s7_668, f_upper_arm_right_y, s7_677);
  const double n_upper_arm_right_x = fma(s7_666, f_upper_arm_right_z, s7_678);
  work.Q_upper_arm_right = tau[Coordinate::upper_arm_right] - n_upper_arm_right_x;
  result.missing[10] = work.Q_upper_arm_right;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double f_wheel_front_right_x = m_wheel_front_right*work.a_wheel_front_right_x;
  const double f_wheel_front_right_y = m_wheel_front_right*work.a_wheel_front_right_y;
  const double f_wheel_front_right_z = m_wheel_front_right*work.a_wheel_front_right_z;
  const double s7_679 = work.R_carrier_right_y_z*work.alpha_wheel_front_right_y;
  const double s7_680 = fma(work.R_carrier_right_x_z, work.alpha_wheel_front_right_x, s7_679);
  const double s7_681 = work.R_carrier_right_y_x*work.w_wheel_front_right_y;
  const double s7_682 = fma(work.R_carrier_right_x_x, work.w_wheel_front_right_x, s7_681);
  const double s7_683 = fma(work.R_carrier_right_z_x, work.w_wheel_front_right_z, s7_682);
  const double s7_684 = work.R_carrier_right_aux2_y_y*work.w_wheel_front_right_y;
  const double s7_685 = fma(work.R_carrier_right_aux2_z_y, work.w_wheel_front_right_z, s7_684);
  const double s7_686 = fnma(work.s1_30, work.w_wheel_front_right_x, s7_685);
  const double s7_687 = I_wheel_front_right_yy*s7_686;
  const double s7_688 = I_wheel_front_right_xx*s7_683;
  const double s7_689 = fma(work.R_carrier_right_z_z, work.alpha_wheel_front_right_z, s7_680);
  const double s7_690 = fnma(s7_686, s7_688, fma(s7_683, s7_687, I_wheel_front_right_zz*s7_689));
  const double s7_691 = work.R_carrier_right_y_x*work.alpha_wheel_front_right_y;
  const double s7_692 = fma(work.R_carrier_right_x_x, work.alpha_wheel_front_right_x, s7_691);
  const double s7_693 = work.R_carrier_right_y_z*work.w_wheel_front_right_y;
  const double s7_694 = fma(work.R_carrier_right_x_z, work.w_wheel_front_right_x, s7_693);
  const double s7_695 = fma(work.R_carrier_right_z_z, work.w_wheel_front_right_z, s7_694);
  const double s7_696 = I_wheel_front_right_zz*s7_695;
  const double s7_697 = fma(work.R_carrier_right_z_x, work.alpha_wheel_front_right_z, s7_692);
  const double s7_698 = fnma(s7_687, s7_695, fma(s7_686, s7_696, I_wheel_front_right_xx*s7_697));
  const double s7_699 = work.R_carrier_right_aux2_y_y*work.alpha_wheel_front_right_y;
  const double s7_700 = fma(work.R_carrier_right_aux2_z_y, work.alpha_wheel_front_right_z, s7_699);
  const double s7_701 = fnma(work.s1_30, work.alpha_wheel_front_right_x, s7_700);
  const double s7_702 = fnma(s7_683, s7_696, fma(s7_688, s7_695, I_wheel_front_right_yy*s7_701));
  const double s7_703 = fma(work.R_carrier_right_x_x, s7_698, work.R_carrier_right_x_z*s7_690);
  const double n_wheel_front_right_x = fnma(work.s1_30, s7_702, s7_703);
  const double s7_704 = work.R_carrier_right_aux2_y_y*s7_702;
  const double s7_705 = fma(work.R_carrier_right_y_x, s7_698, s7_704);
  const double n_wheel_front_right_y = fma(work.R_carrier_right_y_z, s7_690, s7_705);
  const double s7_706 = work.R_carrier_right_aux2_z_y*s7_702;
  const double s7_707 = fma(work.R_carrier_right_z_z, s7_690, s7_706);
  const double n_wheel_front_right_z = fma(work.R_carrier_right_z_x, s7_698, s7_707);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_708 = c_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_709 = fnma(-c_carrier_right_x, work.R_carrier_right_y_x, s7_708);
  const double s7_710 = fnma(-c_carrier_right_y, work.R_carrier_right_aux2_y_y, s7_709);
  const double s7_711 = c_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_712 = fnma(-c_carrier_right_x, work.R_carrier_right_z_x, s7_711);
  const double s7_713 = fnma(-c_carrier_right_y, work.R_carrier_right_aux2_z_y, s7_712);
  const double s7_714 = -c_carrier_right_y*work.s1_30;
  const double s7_715 = fma(c_carrier_right_z, work.R_carrier_right_x_z, s7_714);
  const double s7_716 = fnma(-c_carrier_right_x, work.R_carrier_right_x_x, s7_715);
  const double s7_717 = fma(work.s7_123, s7_710, work.a_carrier_right_aux1_x);
  const double s7_718 = fnma(work.s7_116, s7_716, fma(work.s7_119, s7_713, s7_717));
  const double s7_719 = m_carrier_right*s7_718;
  const double s7_720 = fma(work.s7_120, s7_716, work.a_carrier_right_aux1_y);
  const double s7_721 = fnma(work.s7_117, s7_710, fma(work.s7_124, s7_713, s7_720));
  const double s7_722 = m_carrier_right*s7_721;
  const double f_carrier_right_y = s7_334 + (work.s7_271 + s7_722);
  const double s7_723 = fma(work.s7_121, s7_710, work.a_carrier_right_aux1_z);
  const double s7_724 = fnma(work.s7_118, s7_713, fma(work.s7_122, s7_716, s7_723));
  const double s7_725 = m_carrier_right*s7_724;
  const double f_carrier_right_z = s7_336 + (work.s7_275 + s7_725);
  const double s7_726 = work.R_carrier_right_aux2_y_y*work.alpha_carrier_right_y;
  const double s7_727 = fma(work.R_carrier_right_aux2_z_y, work.alpha_carrier_right_z, s7_726);
  const double s7_728 = fnma(work.s1_30, work.alpha_carrier_right_x, s7_727);
  const double s7_729 = work.R_carrier_right_y_z*work.alpha_carrier_right_y;
  const double s7_730 = fma(work.R_carrier_right_x_z, work.alpha_carrier_right_x, s7_729);
  const double s7_731 = fma(work.R_carrier_right_z_z, work.alpha_carrier_right_z, s7_730);
  const double s7_732 = work.R_carrier_right_y_x*work.alpha_carrier_right_y;
  const double s7_733 = fma(work.R_carrier_right_x_x, work.alpha_carrier_right_x, s7_732);
  const double s7_734 = fma(work.R_carrier_right_z_x, work.alpha_carrier_right_z, s7_733);
  const double s7_735 = work.R_carrier_right_y_x*work.w_carrier_right_y;
  const double s7_736 = fma(work.R_carrier_right_x_x, work.w_carrier_right_x, s7_735);
  const double s7_737 = fma(work.R_carrier_right_z_x, work.w_carrier_right_z, s7_736);
  const double s7_738 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_y;
  const double s7_739 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s7_738);
  const double s7_740 = fnma(work.s1_30, work.w_carrier_right_x, s7_739);
  const double s7_741 = work.R_carrier_right_y_z*work.w_carrier_right_y;
  const double s7_742 = fma(work.R_carrier_right_x_z, work.w_carrier_right_x, s7_741);
  const double s7_743 = fma(work.R_carrier_right_z_z, work.w_carrier_right_z, s7_742);
  const double s7_744 = fma(I_carrier_right_yz, s7_743, I_carrier_right_yy*s7_740);
  const double s7_745 = fma(I_carrier_right_xy, s7_737, s7_744);
  const double s7_746 = fma(I_carrier_right_xx, s7_737, I_carrier_right_xy*s7_740);
  const double s7_747 = fnma(-I_carrier_right_xz, s7_743, s7_746);
  const double s7_748 = fma(I_carrier_right_zz, s7_731, I_carrier_right_yz*s7_728);
  const double s7_749 = fma(s7_737, s7_745, fnma(-I_carrier_right_xz, s7_734, s7_748));
  const double s7_750 = fnma(s7_740, s7_747, s7_749);
  const double s7_751 = fma(I_carrier_right_zz, s7_743, I_carrier_right_yz*s7_740);
  const double s7_752 = fnma(-I_carrier_right_xz, s7_737, s7_751);
  const double s7_753 = fma(I_carrier_right_xx, s7_734, I_carrier_right_xy*s7_728);
  const double s7_754 = fma(s7_740, s7_752, fnma(-I_carrier_right_xz, s7_731, s7_753));
  const double s7_755 = fnma(s7_743, s7_745, s7_754);
  const double s7_756 = fma(I_carrier_right_yz, s7_731, I_carrier_right_yy*s7_728);
  const double s7_757 = fma(s7_743, s7_747, fma(I_carrier_right_xy, s7_734, s7_756));
  const double s7_758 = fnma(s7_737, s7_752, s7_757);
  const double s7_759 = fnma(s7_713, s7_722, s7_710*s7_725);
  const double s7_760 = fma(work.R_carrier_right_x_z, s7_750, s7_759);
  const double s7_761 = fnma(work.s1_30, s7_758, fma(work.R_carrier_right_x_x, s7_755, s7_760));
  const double s7_762 = fma(work.s7_265, work.s7_275, fnma(work.s7_268, work.s7_271, s7_761));
  const double n_carrier_right_x = fma(work.s7_329, s7_336, fnma(work.s7_332, s7_334, s7_762));
  const double s7_763 = fnma(s7_716, s7_725, s7_713*s7_719);
  const double s7_764 = fma(work.R_carrier_right_aux2_y_y, s7_758, s7_763);
  const double s7_765 = fma(work.R_carrier_right_y_x, s7_755, s7_764);
  const double s7_766 = fma(work.R_carrier_right_y_z, s7_750, s7_765);
  const double s7_767 = fma(work.s7_268, work.s7_279, fnma(work.s7_262, work.s7_275, s7_766));
  const double n_carrier_right_y = fma(work.s7_332, s7_338, fnma(work.s7_326, s7_336, s7_767));
  const double s7_768 = fnma(s7_710, s7_719, s7_716*s7_722);
  const double s7_769 = fma(work.R_carrier_right_aux2_z_y, s7_758, s7_768);
  const double s7_770 = fma(work.R_carrier_right_z_z, s7_750, s7_769);
  const double s7_771 = fma(work.R_carrier_right_z_x, s7_755, s7_770);
  const double s7_772 = fma(work.s7_262, work.s7_271, fnma(work.s7_265, work.s7_279, s7_771));
  const double n_carrier_right_z = fma(work.s7_326, s7_334, fnma(work.s7_329, s7_338, s7_772));
  const double s7_773 = n_wheel_front_right_y + n_carrier_right_y;
  const double s7_774 = fma(work.s1_42, f_wheel_front_right_x, s7_773);
  work.s7_775 = fnma(work.s1_38, f_wheel_front_right_z, s7_774);
  const double s7_776 = n_wheel_front_right_z + n_carrier_right_z;
  const double s7_777 = fma(work.s1_38, f_wheel_front_right_y, s7_776);
  work.s7_778 = fnma(work.s1_40, f_wheel_front_right_x, s7_777);
  const double s7_779 = n_wheel_front_right_x + n_carrier_right_x;
  const double s7_780 = fma(work.s1_40, f_wheel_front_right_z, s7_779);
  work.s7_781 = fnma(work.s1_42, f_wheel_front_right_y, s7_780);
  const double s7_782 = fnma(work.R_carrier_right_aux2_y_y, work.s7_775,
      tau[Coordinate::carrier_right_ry]);
  const double s7_783 = fnma(work.R_carrier_right_aux2_z_y, work.s7_778, s7_782);
  result.missing[9] = fma(work.s1_30, work.s7_781, s7_783);
  const double s7_784 = f_wheel_front_right_z + f_carrier_right_z;
  const double s7_785 = f_wheel_front_right_y + f_carrier_right_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s7_786 = fnma(work.R_carrier_right_aux1_y_x, work.s7_775,
      tau[Coordinate::carrier_right_rx]);
  const double s7_787 = fnma(work.cosines[10], work.s7_781, s7_786);
  result.missing[8] = fnma(work.R_carrier_right_aux1_z_x, work.s7_778, s7_787);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s7_788 = fnma(R_lower_arm_right_y_y, work.s7_778, tau[Coordinate::carrier_right_rz]);
  result.missing[7] = fma(R_lower_arm_right_z_y, work.s7_775, s7_788);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_789 = -c_lower_arm_right_z*R_lower_arm_right_z_y;
  const double s7_790 = fnma(-c_lower_arm_right_y, R_lower_arm_right_y_y, s7_789);
  const double s7_791 = -c_lower_arm_right_y*R_lower_arm_right_z_y;
  const double s7_792 = fma(-c_lower_arm_right_z, R_lower_arm_right_y_y, s7_791);
  const double s7_793 = fnma(work.s7_94, s7_790, work.a_lower_arm_right_y);
  const double f_lower_arm_right_y = m_lower_arm_right*fnma(work.s7_92, s7_792, s7_793);
  const double s7_794 = fma(work.s7_93, s7_792, work.a_lower_arm_right_z);
  const double f_lower_arm_right_z = m_lower_arm_right*fma(work.s7_91, s7_790, s7_794);
  const double s7_795 = R_lower_arm_right_z_y*work.w_chassis_z;
  const double s7_796 = fma(R_lower_arm_right_y_y, work.w_chassis_y, s7_795);
  const double s7_797 = R_lower_arm_right_y_y*work.w_chassis_z;
  const double s7_798 = fnma(R_lower_arm_right_z_y, work.w_chassis_y, s7_797);
  const double s7_799 = I_lower_arm_right_xx*work.alpha_lower_arm_right_x;
  const double s7_800 = fma(s7_796, I_lower_arm_right_zz*s7_798, s7_799);
  const double s7_801 = fnma(s7_798, I_lower_arm_right_yy*s7_796, s7_800);
  const double s7_802 = fma(s7_792, f_lower_arm_right_y, s7_801);
  const double n_lower_arm_right_x = fma(s7_790, f_lower_arm_right_z, s7_802);
  const double s7_803 = tau[Coordinate::lower_arm_right] - work.s7_781 - n_lower_arm_right_x;
  result.missing[6] = fnma(work.s1_25, s7_784, fnma(work.s1_27, s7_785, s7_803));
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_804 = -c_arb_front_left_x*R_arb_front_left_x_z;
  const double s7_805 = fma(c_arb_front_left_z, R_arb_front_left_x_x, s7_804);
  const double s7_806 = c_arb_front_left_z*R_arb_front_left_x_z;
  const double s7_807 = fnma(-c_arb_front_left_x, R_arb_front_left_x_x, s7_806);
  const double s7_808 = fma(c_arb_front_left_y, work.s7_89, work.a_arb_front_left_x);
  const double s7_809 = fnma(work.s7_86, s7_807, fma(work.s7_83, s7_805, s7_808));
  const double s7_810 = fma(c_arb_front_left_y, work.s7_88, work.a_arb_front_left_z);
  const double s7_811 = fnma(work.s7_85, s7_805, fma(work.s7_84, s7_807, s7_810));
  const double s7_812 = R_arb_front_left_x_x*work.alpha_arb_front_left_x;
  const double s7_813 = R_arb_front_left_x_z*work.alpha_arb_front_left_x;
  const double s7_814 = R_arb_front_left_x_x*work.w_chassis_x;
  const double s7_815 = fnma(R_arb_front_left_x_z, work.w_chassis_z, s7_814);
  const double s7_816 = R_arb_front_left_x_z*work.w_chassis_x;
  const double s7_817 = fma(R_arb_front_left_x_x, work.w_chassis_z, s7_816);
  const double s7_818 = I_arb_front_left_xy*work.w_arb_front_left_y;
  const double s7_819 = fma(I_arb_front_left_xz, s7_817, s7_818);
  const double s7_820 = fma(I_arb_front_left_zz, s7_817, I_arb_front_left_xz*s7_815);
  const double s7_821 = fnma(R_arb_front_left_x_z, work.alpha_arb_front_left_z, s7_812);
  const double s7_822 = I_arb_front_left_yy*work.alpha_arb_front_left_y;
  const double s7_823 = fma(R_arb_front_left_x_x, work.alpha_arb_front_left_z, s7_813);
  const double s7_824 = fma(I_arb_front_left_xy, s7_821, s7_822);
  const double s7_825 = fnma(-I_arb_front_left_yz, s7_823, s7_824);
  const double s7_826 = fma(s7_817, fma(I_arb_front_left_xx, s7_815, s7_819), s7_825);
  const double s7_827 = fnma(-I_arb_front_left_yz, work.w_arb_front_left_y, s7_820);
  const double s7_828 = fma(s7_805, m_arb_front_left*s7_809, fnma(s7_815, s7_827, s7_826));
  const double s7_829 = fnma(s7_807, m_arb_front_left*s7_811, s7_828);
  const double n_arb_front_left_y = fma(work.s7_229, work.s7_255, fnma(work.s7_231, work.s7_252,
      s7_829));
  work.Q_arb_front_left = tau[Coordinate::arb_front_left] - n_arb_front_left_y;
  result.missing[5] = work.Q_arb_front_left;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_830 = c_upper_arm_left_y*R_upper_arm_left_z_y;
  const double s7_831 = fnma(-c_upper_arm_left_z, R_upper_arm_left_y_y, s7_830);
  const double s7_832 = -c_upper_arm_left_z*R_upper_arm_left_z_y;
  const double s7_833 = fma(c_upper_arm_left_y, R_upper_arm_left_y_y, s7_832);
  const double s7_834 = fma(work.s7_72, s7_831, work.a_upper_arm_left_y);
  const double f_upper_arm_left_y = m_upper_arm_left*fnma(work.s7_74, s7_833, s7_834);
  const double s7_835 = fma(work.s7_71, s7_833, work.a_upper_arm_left_z);
  const double f_upper_arm_left_z = m_upper_arm_left*fnma(work.s7_73, s7_831, s7_835);
  const double s7_836 = R_upper_arm_left_z_y*work.w_chassis_z;
  const double s7_837 = fma(R_upper_arm_left_y_y, work.w_chassis_y, s7_836);
  const double s7_838 = R_upper_arm_left_y_y*work.w_chassis_z;
  const double s7_839 = fnma(R_upper_arm_left_z_y, work.w_chassis_y, s7_838);
  const double s7_840 = I_upper_arm_left_xx*work.alpha_upper_arm_left_x;
  const double s7_841 = fma(s7_837, I_upper_arm_left_zz*s7_839, s7_840);
  const double s7_842 = fnma(s7_839, I_upper_arm_left_yy*s7_837, s7_841);
  const double s7_843 = fma(s7_833, f_upper_arm_left_z, s7_842);
  const double n_upper_arm_left_x = fnma(s7_831, f_upper_arm_left_y, s7_843);
  work.Q_upper_arm_left = tau[Coordinate::upper_arm_left] - n_upper_arm_left_x;
  result.missing[4] = work.Q_upper_arm_left;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double f_wheel_front_left_x = m_wheel_front_left*work.a_wheel_front_left_x;
  const double f_wheel_front_left_y = m_wheel_front_left*work.a_wheel_front_left_y;
  const double f_wheel_front_left_z = m_wheel_front_left*work.a_wheel_front_left_z;
  const double s7_844 = work.R_carrier_left_y_z*work.alpha_wheel_front_left_y;
  const double s7_845 = fma(work.R_carrier_left_x_z, work.alpha_wheel_front_left_x, s7_844);
  const double s7_846 = work.R_carrier_left_y_x*work.w_wheel_front_left_y;
  const double s7_847 = fma(work.R_carrier_left_x_x, work.w_wheel_front_left_x, s7_846);
  const double s7_848 = fma(work.R_carrier_left_z_x, work.w_wheel_front_left_z, s7_847);
  const double s7_849 = work.R_carrier_left_aux2_y_y*work.w_wheel_front_left_y;
  const double s7_850 = fma(work.R_carrier_left_aux2_z_y, work.w_wheel_front_left_z, s7_849);
  const double s7_851 = fnma(work.s1_12, work.w_wheel_front_left_x, s7_850);
  const double s7_852 = I_wheel_front_left_yy*s7_851;
  const double s7_853 = I_wheel_front_left_xx*s7_848;
  const double s7_854 = fma(work.R_carrier_left_z_z, work.alpha_wheel_front_left_z, s7_845);
  const double s7_855 = fnma(s7_851, s7_853, fma(s7_848, s7_852, I_wheel_front_left_zz*s7_854));
  const double s7_856 = work.R_carrier_left_y_x*work.alpha_wheel_front_left_y;
  const double s7_857 = fma(work.R_carrier_left_x_x, work.alpha_wheel_front_left_x, s7_856);
  const double s7_858 = work.R_carrier_left_y_z*work.w_wheel_front_left_y;
  const double s7_859 = fma(work.R_carrier_left_x_z, work.w_wheel_front_left_x, s7_858);
  const double s7_860 = fma(work.R_carrier_left_z_z, work.w_wheel_front_left_z, s7_859);
  const double s7_861 = I_wheel_front_left_zz*s7_860;
  const double s7_862 = fma(work.R_carrier_left_z_x, work.alpha_wheel_front_left_z, s7_857);
  const double s7_863 = fnma(s7_852, s7_860, fma(s7_851, s7_861, I_wheel_front_left_xx*s7_862));
  const double s7_864 = work.R_carrier_left_aux2_y_y*work.alpha_wheel_front_left_y;
  const double s7_865 = fma(work.R_carrier_left_aux2_z_y, work.alpha_wheel_front_left_z, s7_864);
  const double s7_866 = fnma(work.s1_12, work.alpha_wheel_front_left_x, s7_865);
  const double s7_867 = fnma(s7_848, s7_861, fma(s7_853, s7_860, I_wheel_front_left_yy*s7_866));
  const double s7_868 = fma(work.R_carrier_left_x_x, s7_863, work.R_carrier_left_x_z*s7_855);
  const double n_wheel_front_left_x = fnma(work.s1_12, s7_867, s7_868);
  const double s7_869 = work.R_carrier_left_aux2_y_y*s7_867;
  const double s7_870 = fma(work.R_carrier_left_y_x, s7_863, s7_869);
  const double n_wheel_front_left_y = fma(work.R_carrier_left_y_z, s7_855, s7_870);
  const double s7_871 = work.R_carrier_left_aux2_z_y*s7_867;
  const double s7_872 = fma(work.R_carrier_left_z_z, s7_855, s7_871);
  const double n_wheel_front_left_z = fma(work.R_carrier_left_z_x, s7_863, s7_872);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_873 = c_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_874 = fma(c_carrier_left_z, work.R_carrier_left_y_z, s7_873);
  const double s7_875 = fnma(-c_carrier_left_x, work.R_carrier_left_y_x, s7_874);
  const double s7_876 = c_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_877 = fma(c_carrier_left_z, work.R_carrier_left_z_z, s7_876);
  const double s7_878 = fnma(-c_carrier_left_x, work.R_carrier_left_z_x, s7_877);
  const double s7_879 = c_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_880 = fnma(-c_carrier_left_x, work.R_carrier_left_x_x, s7_879);
  const double s7_881 = fnma(c_carrier_left_y, work.s1_12, s7_880);
  const double s7_882 = fma(work.s7_57, s7_875, work.a_carrier_left_aux1_x);
  const double s7_883 = m_carrier_left*fnma(work.s7_50, s7_881, fma(work.s7_53, s7_878, s7_882));
  const double s7_884 = fma(work.s7_54, s7_881, work.a_carrier_left_aux1_y);
  const double s7_885 = m_carrier_left*fnma(work.s7_51, s7_875, fma(work.s7_58, s7_878, s7_884));
  const double f_carrier_left_y = s7_315 + (work.s7_243 + s7_885);
  const double s7_886 = fma(work.s7_55, s7_875, work.a_carrier_left_aux1_z);
  const double s7_887 = m_carrier_left*fnma(work.s7_52, s7_878, fma(work.s7_56, s7_881, s7_886));
  const double f_carrier_left_z = s7_311 + (work.s7_246 + s7_887);
  const double s7_888 = work.R_carrier_left_y_z*work.alpha_carrier_left_y;
  const double s7_889 = fma(work.R_carrier_left_x_z, work.alpha_carrier_left_x, s7_888);
  const double s7_890 = fma(work.R_carrier_left_z_z, work.alpha_carrier_left_z, s7_889);
  const double s7_891 = work.R_carrier_left_y_x*work.alpha_carrier_left_y;
  const double s7_892 = fma(work.R_carrier_left_x_x, work.alpha_carrier_left_x, s7_891);
  const double s7_893 = fma(work.R_carrier_left_z_x, work.alpha_carrier_left_z, s7_892);
  const double s7_894 = work.R_carrier_left_aux2_y_y*work.alpha_carrier_left_y;
  const double s7_895 = fma(work.R_carrier_left_aux2_z_y, work.alpha_carrier_left_z, s7_894);
  const double s7_896 = fnma(work.s1_12, work.alpha_carrier_left_x, s7_895);
  const double s7_897 = work.R_carrier_left_y_x*work.w_carrier_left_y;
  const double s7_898 = fma(work.R_carrier_left_x_x, work.w_carrier_left_x, s7_897);
  const double s7_899 = fma(work.R_carrier_left_z_x, work.w_carrier_left_z, s7_898);
  const double s7_900 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_y;
  const double s7_901 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s7_900);
  const double s7_902 = fnma(work.s1_12, work.w_carrier_left_x, s7_901);
  const double s7_903 = work.R_carrier_left_y_z*work.w_carrier_left_y;
  const double s7_904 = fma(work.R_carrier_left_x_z, work.w_carrier_left_x, s7_903);
  const double s7_905 = fma(work.R_carrier_left_z_z, work.w_carrier_left_z, s7_904);
  const double s7_906 = fnma(-I_carrier_left_yz, s7_905, I_carrier_left_yy*s7_902);
  const double s7_907 = fnma(-I_carrier_left_xy, s7_899, s7_906);
  const double s7_908 = fnma(-I_carrier_left_xz, s7_905, I_carrier_left_xx*s7_899);
  const double s7_909 = fnma(-I_carrier_left_xy, s7_902, s7_908);
  const double s7_910 = fnma(-I_carrier_left_xz, s7_893, I_carrier_left_zz*s7_890);
  const double s7_911 = fma(s7_899, s7_907, fnma(-I_carrier_left_yz, s7_896, s7_910));
  const double s7_912 = fnma(s7_902, s7_909, s7_911);
  const double s7_913 = fnma(-I_carrier_left_xz, s7_899, I_carrier_left_zz*s7_905);
  const double s7_914 = fnma(-I_carrier_left_yz, s7_902, s7_913);
  const double s7_915 = fnma(-I_carrier_left_xz, s7_890, I_carrier_left_xx*s7_893);
  const double s7_916 = fma(s7_902, s7_914, fnma(-I_carrier_left_xy, s7_896, s7_915));
  const double s7_917 = fnma(s7_905, s7_907, s7_916);
  const double s7_918 = fnma(-I_carrier_left_yz, s7_890, I_carrier_left_yy*s7_896);
  const double s7_919 = fma(s7_905, s7_909, fnma(-I_carrier_left_xy, s7_893, s7_918));
  const double s7_920 = fnma(s7_899, s7_914, s7_919);
  const double s7_921 = fnma(s7_878, s7_885, s7_875*s7_887);
  const double s7_922 = fma(work.R_carrier_left_x_z, s7_912, s7_921);
  const double s7_923 = fnma(work.s1_12, s7_920, fma(work.R_carrier_left_x_x, s7_917, s7_922));
  const double s7_924 = fma(work.s7_237, work.s7_246, fnma(work.s7_240, work.s7_243, s7_923));
  const double n_carrier_left_x = fma(work.s7_307, s7_311, fnma(work.s7_309, s7_315, s7_924));
  const double s7_925 = fnma(s7_881, s7_887, s7_878*s7_883);
  const double s7_926 = fma(work.R_carrier_left_aux2_y_y, s7_920, s7_925);
  const double s7_927 = fma(work.R_carrier_left_y_x, s7_917, s7_926);
  const double s7_928 = fma(work.R_carrier_left_y_z, s7_912, s7_927);
  const double s7_929 = fma(work.s7_240, work.s7_249, fnma(work.s7_234, work.s7_246, s7_928));
  const double n_carrier_left_y = fma(work.s7_309, s7_313, fnma(work.s7_305, s7_311, s7_929));
  const double s7_930 = fnma(s7_875, s7_883, s7_881*s7_885);
  const double s7_931 = fma(work.R_carrier_left_aux2_z_y, s7_920, s7_930);
  const double s7_932 = fma(work.R_carrier_left_z_z, s7_912, s7_931);
  const double s7_933 = fma(work.R_carrier_left_z_x, s7_917, s7_932);
  const double s7_934 = fma(work.s7_234, work.s7_243, fnma(work.s7_237, work.s7_249, s7_933));
  const double n_carrier_left_z = fma(work.s7_305, s7_315, fnma(work.s7_307, s7_313, s7_934));
  const double s7_935 = n_wheel_front_left_y + n_carrier_left_y;
  const double s7_936 = fma(work.s1_22, f_wheel_front_left_x, s7_935);
  work.s7_937 = fnma(work.s1_18, f_wheel_front_left_z, s7_936);
  const double s7_938 = n_wheel_front_left_z + n_carrier_left_z;
  const double s7_939 = fma(work.s1_18, f_wheel_front_left_y, s7_938);
  work.s7_940 = fnma(work.s1_20, f_wheel_front_left_x, s7_939);
  const double s7_941 = n_wheel_front_left_x + n_carrier_left_x;
  const double s7_942 = fma(work.s1_20, f_wheel_front_left_z, s7_941);
  const double s7_943 = fnma(work.s1_22, f_wheel_front_left_y, s7_942);
  const double s7_944 = fnma(work.R_carrier_left_aux2_y_y, work.s7_937,
      tau[Coordinate::carrier_left_ry]);
  const double s7_945 = fnma(work.R_carrier_left_aux2_z_y, work.s7_940, s7_944);
  result.missing[3] = fma(work.s1_12, s7_943, s7_945);
  const double s7_946 = f_wheel_front_left_y + f_carrier_left_y;
  const double s7_947 = f_wheel_front_left_z + f_carrier_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s7_948 = fnma(work.R_carrier_left_aux1_y_x, work.s7_937,
      tau[Coordinate::carrier_left_rx]);
  const double s7_949 = fnma(work.cosines[4], s7_943, s7_948);
  result.missing[2] = fnma(work.R_carrier_left_aux1_z_x, work.s7_940, s7_949);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s7_950 = fnma(R_lower_arm_left_y_y, work.s7_940, tau[Coordinate::carrier_left_rz]);
  result.missing[1] = fma(R_lower_arm_left_z_y, work.s7_937, s7_950);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_951 = c_lower_arm_left_y*R_lower_arm_left_z_y;
  const double s7_952 = fnma(-c_lower_arm_left_z, R_lower_arm_left_y_y, s7_951);
  const double s7_953 = -c_lower_arm_left_z*R_lower_arm_left_z_y;
  const double s7_954 = fma(c_lower_arm_left_y, R_lower_arm_left_y_y, s7_953);
  const double s7_955 = fma(work.s7_28, s7_952, work.a_lower_arm_left_y);
  const double f_lower_arm_left_y = m_lower_arm_left*fnma(work.s7_30, s7_954, s7_955);
  const double s7_956 = fma(work.s7_27, s7_954, work.a_lower_arm_left_z);
  const double f_lower_arm_left_z = m_lower_arm_left*fnma(work.s7_29, s7_952, s7_956);
  const double s7_957 = R_lower_arm_left_z_y*work.w_chassis_z;
  const double s7_958 = fma(R_lower_arm_left_y_y, work.w_chassis_y, s7_957);
  const double s7_959 = R_lower_arm_left_y_y*work.w_chassis_z;
  const double s7_960 = fnma(R_lower_arm_left_z_y, work.w_chassis_y, s7_959);
  const double s7_961 = I_lower_arm_left_xx*work.alpha_lower_arm_left_x;
  const double s7_962 = fma(s7_958, I_lower_arm_left_zz*s7_960, s7_961);
  const double s7_963 = fnma(s7_960, I_lower_arm_left_yy*s7_958, s7_962);
  const double s7_964 = fma(s7_954, f_lower_arm_left_z, s7_963);
  const double n_lower_arm_left_x = fnma(s7_952, f_lower_arm_left_y, s7_964);
  const double s7_965 = tau[Coordinate::lower_arm_left] - s7_943 - n_lower_arm_left_x;
  work.Q_lower_arm_left = fma(work.s1_10, s7_946, fnma(work.s1_8, s7_947, s7_965));
  result.missing[0] = work.Q_lower_arm_left;
  // operations: 1146 add, 1359 multiply
}

/// Part 3 of compute_multipliers: step 9: multipliers of the closures and driving forces.
[[gnu::noinline]] void compute_multipliers_3(const State& state, const double* tau,
    ConstraintForcesWork& __restrict work, ConstraintForces& __restrict result) noexcept {
  // --- step 9: multipliers of the closures and driving forces ---
  // upper_ball_left
  const double pivot_carrier_left_rx = fms(p_carrier_left_upper_ball_z, work.R_carrier_left_z_z,
      work.s7_297);
  const double s9_1 = fma(p_carrier_left_upper_ball_z, work.R_carrier_left_x_z, work.s7_303);
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s9_2 = -p_upper_arm_left_ball_z*R_upper_arm_left_z_y;
  const double s9_3 = fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s9_2);
  const double s9_4 = fms(p_carrier_left_upper_ball_z, work.R_carrier_left_y_z, work.s7_298);
  // upper_ball_right
  const double pivot_carrier_right_rx = fma(p_carrier_right_upper_ball_z, work.R_carrier_right_z_z,
      work.s7_330);
  const double s9_5 = fma(p_carrier_right_upper_ball_z, work.R_carrier_right_y_z, work.s7_327);
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s9_6 = -p_upper_arm_right_ball_y*R_upper_arm_right_z_y;
  const double s9_7 = fma(-p_upper_arm_right_ball_z, R_upper_arm_right_y_y, s9_6);
  const double s9_8 = fms(p_carrier_right_upper_ball_z, work.R_carrier_right_x_z, work.s7_323);
  // arb_link_front_left
  const double s9_9 = 0.35 + (work.s7_231 - work.s7_234);
  const double s9_10 = work.s7_229 - work.r_carrier_left_aux1_z - work.s7_240;
  const double s9_11 = s9_10 - (-p_arb_front_left_z);
  const double pivot_arb_front_left = fnma(work.s7_231, s9_11, work.s7_229*s9_9);
  const double s9_12 = 0.72 - work.r_carrier_left_aux1_y - work.s7_237;
  const double s9_13 = fnma(work.s7_237, s9_9, work.s7_234*s9_12);
  const double s9_14 = fnma(work.s7_234, s9_11, work.s7_240*s9_9);
  const double s9_15 = fnma(s9_12, work.s1_10 + work.s7_240, s9_11*(work.s1_8 + work.s7_237));
  // arb_link_front_right
  const double s9_16 = 0.35 + (work.s7_259 - work.s7_262);
  const double s9_17 = work.s1_28 + work.s7_257 - work.s7_268 - (-p_arb_front_right_z);
  const double pivot_arb_front_right = fnma(work.s7_259, s9_17, work.s7_257*s9_16);
  const double s9_18 = 0.72 + (work.r_carrier_right_aux1_y + work.s7_265);
  const double s9_19 = fma(work.s7_265, s9_17, work.s7_268*s9_18);
  const double s9_20 = fma(work.s7_265, s9_16, work.s7_262*s9_18);
  const double s9_21 = fnma(work.s7_262, s9_17, work.s7_268*s9_16);
  // drag_link
  const double s9_22 = 1.15 + (work.s7_288 - work.s7_286);
  const double pivot_pitman_arm = fnma(work.s7_287, s9_22, work.s7_286*(0.2 - work.s7_287));
  // tie_rod_left
  const double s9_23 = -p_bell_crank_z + (work.r_carrier_left_aux1_z + work.s7_309);
  const double s9_24 = work.s7_302 - work.r_carrier_left_aux1_y - work.s7_307;
  const double s9_25 = 0.35 + (work.s7_301 + work.s7_305);
  const double s9_26 = fnma(work.s7_309, s9_25, work.s7_305*s9_23);
  const double s9_27 = fma(s9_24, work.s1_10 + work.s7_309, s9_23*(work.s1_8 + work.s7_307));
  // tie_rod_right
  const double s9_28 = -p_bell_crank_z + (work.s7_332 - work.s1_28);
  const double s9_29 = work.s7_322 + (work.r_carrier_right_aux1_y + work.s7_329);
  const double s9_30 = work.s7_324 - work.s7_326 - 0.35;
  const double s9_31 = fma(work.s7_332, s9_30, work.s7_326*s9_28);
  const double s9_32 = fnma(work.s7_329, s9_28, work.s7_332*s9_29);
  const double s9_33 = 1.0/pivot_carrier_right_rx;
  const double s9_34 = s9_31*s9_33;
  const double pivot_carrier_right_ry = fnma(s9_5, s9_34, fma(work.s7_329, s9_30,
      work.s7_326*s9_29));
  const double s9_35 = 1.0/pivot_carrier_right_ry;
  const double s9_36 = s9_8*s9_35;
  const double pivot_carrier_right_rz = fms(s9_32, s9_36, pivot_carrier_right_rx);
  const double s9_37 = s9_8*s9_33;
  const double s9_38 = s9_35*(s9_5*s9_37);
  const double s9_39 = 1.0/pivot_carrier_right_rz;
  const double s9_40 = fnma(s9_32, s9_38, s9_5)*s9_39;
  const double s9_41 = fnma(-p_upper_arm_right_ball_z, R_upper_arm_right_z_y, s9_7*s9_40);
  const double pivot_upper_arm_right = fma(-p_upper_arm_right_ball_y, R_upper_arm_right_y_y, s9_41);
  const double s9_42 = 1.0/pivot_carrier_left_rx;
  const double s9_43 = s9_26*s9_42;
  const double s9_44 = fma(s9_4, s9_43, fma(work.s7_307, s9_25, work.s7_305*s9_24));
  const double s9_45 = s9_1*s9_42;
  const double s9_46 = 1.0/s9_44;
  const double s9_47 = s9_4*s9_45*s9_46;
  const double pivot_lower_arm_left = fnma(s9_27, s9_47, work.s1_8 + s9_4);
  const double s9_48 = s9_1*s9_46;
  const double s9_49 = 1.0/pivot_lower_arm_left;
  const double s9_50 = (fms(s9_27, s9_48, work.s1_10) - pivot_carrier_left_rx)*s9_49;
  const double s9_51 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s9_52 = fnma(-p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s9_51);
  const double pivot_upper_arm_left = fma(s9_3, s9_50, s9_52);
  const double s9_53 = 16.504892200367603*std::abs(pivot_arb_front_right);
  const double s9_54 = mbgen::min(3.9625229801272064*std::abs(pivot_pitman_arm), s9_53);
  const double s9_55 = mbgen::min(16.679425973935604*std::abs(pivot_arb_front_left), s9_54);
  const double s9_56 = mbgen::min(2.7028647671567816*std::abs(pivot_carrier_right_rx), s9_55);
  const double s9_57 = mbgen::min(s9_56, 6.8514628664707224*std::abs(pivot_carrier_right_ry));
  const double s9_58 = mbgen::min(s9_57, 2.7028647671567816*std::abs(pivot_carrier_right_rz));
  const double s9_59 = mbgen::min(s9_58, 3.405476531191585*std::abs(pivot_upper_arm_right));
  const double s9_60 = mbgen::min(2.7028219055711094*std::abs(pivot_carrier_left_rx), s9_59);
  const double s9_61 = mbgen::min(6.915894223167945*std::abs(s9_44), s9_60);
  const double s9_62 = mbgen::min(2.5101920700758265*std::abs(pivot_lower_arm_left), s9_61);
  const double s9_63 = mbgen::min(3.84681640934729*std::abs(pivot_upper_arm_left), s9_62);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s9_64 = mbgen::min(s9_63, std::abs(work.s1_53));
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  result.pivot[0] = mbgen::min(s9_64, std::abs(work.s1_64));
  const double s9_65 = work.Q_arb_front_left*(1.0/pivot_arb_front_left);
  result.lambda[6] = l_arb_link_front_left*s9_65;
  const double s9_66 = work.Q_arb_front_right*(1.0/pivot_arb_front_right);
  result.lambda[7] = l_arb_link_front_right*s9_66;
  result.lambda[8] = l_drag_link*(work.Q_pitman_arm*(1.0/pivot_pitman_arm));
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double s9_67 = fms(tau_carrier_left_ry, work.s1_56, work.s7_937);
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double s9_68 = fma(tau_carrier_left_rx, work.R_carrier_left_aux1_y_x, s9_67);
  const double s9_69 = s9_42*fma(s9_14, s9_65, fnma(tau_carrier_left_rz, work.s1_58, s9_68));
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double s9_70 = fms(tau_carrier_right_ry, work.s1_67, work.s7_775);
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s9_71 = fma(tau_carrier_right_rx, work.R_carrier_right_aux1_y_x, s9_70);
  const double s9_72 = s9_33*fma(s9_21, s9_66, fnma(tau_carrier_right_rz, work.s1_73, s9_71));
  const double s9_73 = fma(tau_carrier_left_ry, work.s1_55, fms(s9_4, s9_69, work.s7_940));
  const double s9_74 = fma(tau_carrier_left_rx, work.R_carrier_left_aux1_z_x, s9_73);
  const double s9_75 = s9_46*fma(s9_13, s9_65, fma(tau_carrier_left_rz, work.s1_57, s9_74));
  const double s9_76 = fma(tau_carrier_right_ry, work.s1_66, fms(s9_5, s9_72, work.s7_778));
  const double s9_77 = fma(tau_carrier_right_rx, work.R_carrier_right_aux1_z_x, s9_76);
  const double s9_78 = s9_35*fnma(s9_20, s9_66, fma(tau_carrier_right_rz, work.s1_68, s9_77));
  const double s9_79 = s9_49*fma(s9_15, s9_65, fma(s9_27, s9_75, work.Q_lower_arm_left));
  const double s9_80 = fms(s9_32, s9_78, work.s7_781);
  const double s9_81 = fma(tau_carrier_right_rx, work.cosines[10], s9_80);
  const double s9_82 = fma(tau_carrier_right_rz, work.s1_71, s9_81);
  const double s9_83 = s9_39*fma(s9_19, s9_66, fnma(tau_carrier_right_ry, work.s1_72, s9_82));
  const double s9_84 = 1.0/pivot_upper_arm_left*fma(s9_3, s9_79, work.Q_upper_arm_left);
  result.lambda[1] = s9_84;
  const double s9_85 = 1.0/pivot_upper_arm_right*fma(s9_7, s9_83, work.Q_upper_arm_right);
  result.lambda[5] = s9_85;
  const double s9_86 = fnma(s9_50, s9_84, s9_79);
  result.lambda[2] = s9_86;
  const double s9_87 = fnma(s9_40, s9_85, s9_83);
  result.lambda[4] = s9_87;
  const double s9_88 = fnma(s9_47, s9_86, fms(s9_48, s9_84, s9_75));
  result.lambda[9] = l_tie_rod_left*s9_88;
  const double s9_89 = fnma(s9_36, s9_87, fma(s9_38, s9_85, s9_78));
  result.lambda[10] = l_tie_rod_right*s9_89;
  result.lambda[0] = fma(s9_43, s9_88, fma(s9_45, s9_86, s9_69));
  result.lambda[3] = fma(s9_34, s9_89, fma(s9_37, s9_85, s9_72));
  // long_rod_left
  const double s9_90 = -p_long_rod_left_from_z + (work.r_rear_axle_aux3_z + work.s7_349);
  const double s9_91 = -p_long_rod_left_from_x + (work.r_rear_axle_aux1_x + work.s7_352);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_92 = p_long_rod_left_from_y - z_rear_axle_ty - work.s7_355;
  // diag_rod_left
  const double s9_93 = -p_diag_rod_left_from_z + (work.r_rear_axle_aux3_z + work.s7_367);
  const double s9_94 = -p_diag_rod_left_from_x + (work.r_rear_axle_aux1_x + work.s7_369);
  const double s9_95 = p_diag_rod_left_from_y - z_rear_axle_ty - work.s7_371;
  // arb_link_rear_left
  const double s9_96 = work.s7_380 + (work.r_rear_axle_aux3_z + work.s7_388);
  const double s9_97 = -p_arb_rear_left_z + s9_96;
  const double s9_98 = 0.6 - z_rear_axle_ty - work.s7_390;
  const double s9_99 = work.s7_385 - work.r_rear_axle_aux1_x - work.s7_389;
  const double s9_100 = s9_99 - (-p_arb_rear_left_x);
  // long_rod_right
  const double s9_101 = -p_long_rod_right_from_y + (z_rear_axle_ty + work.s7_408);
  const double s9_102 = -p_long_rod_right_from_z + (work.r_rear_axle_aux3_z - work.s7_406);
  const double s9_103 = -p_long_rod_right_from_x + (work.r_rear_axle_aux1_x + work.s7_407);
  // diag_rod_right
  const double pivot_rear_axle_tx = -p_diag_rod_right_from_x + (work.r_rear_axle_aux1_x +
      work.s7_413);
  const double s9_104 = -p_diag_rod_right_from_z + (work.r_rear_axle_aux3_z + work.s7_412);
  const double s9_105 = -p_diag_rod_right_from_y + (z_rear_axle_ty + work.s7_414);
  const double s9_106 = fnma(work.s7_414, s9_104, work.s7_412*s9_105);
  const double s9_107 = fnma(work.s7_412, pivot_rear_axle_tx, work.s7_413*s9_104);
  const double s9_108 = fnma(work.s7_413, s9_105, work.s7_414*pivot_rear_axle_tx);
  // arb_link_rear_right
  const double s9_109 = 0.6 + (z_rear_axle_ty - work.s7_421);
  const double s9_110 = work.s7_423 + (work.r_rear_axle_aux3_z + work.s7_424);
  const double s9_111 = -p_arb_rear_right_z + s9_110;
  const double s9_112 = work.s7_422 + work.s7_425 - work.r_rear_axle_aux1_x;
  const double s9_113 = s9_112 - (-p_arb_rear_right_x);
  const double s9_114 = 1.0/pivot_rear_axle_tx;
  const double s9_115 = s9_94*s9_114;
  const double s9_116 = fma(s9_105, s9_115, s9_95);
  const double s9_117 = s9_91*s9_114;
  const double s9_118 = fnma(work.s7_369, s9_95, fnma(work.s7_371, s9_94, s9_108*s9_115));
  const double s9_119 = 1.0/s9_116;
  const double s9_120 = fma(s9_105, s9_117, s9_92)*s9_119;
  const double s9_121 = fnma(work.s7_352, s9_92, fnma(work.s7_355, s9_91, s9_108*s9_117));
  const double pivot_rear_axle_rx = fnma(s9_118, s9_120, s9_121);
  const double s9_122 = s9_103*s9_114;
  const double s9_123 = fma(work.s7_367, s9_94, fnma(work.s7_369, s9_93, s9_107*s9_115));
  const double s9_124 = s9_119*fnma(s9_105, s9_122, s9_101);
  const double s9_125 = fma(work.s7_349, s9_91, fnma(work.s7_352, s9_90, s9_107*s9_117));
  const double s9_126 = fnma(s9_120, s9_123, s9_125);
  const double s9_127 = fma(work.s7_407, s9_101, fnma(work.s7_408, s9_103, s9_108*s9_122));
  const double s9_128 = 1.0/pivot_rear_axle_rx;
  const double s9_129 = fma(s9_118, s9_124, s9_127)*s9_128;
  const double s9_130 = fnma(work.s7_406, s9_103, fnma(work.s7_407, s9_102, s9_107*s9_122));
  const double pivot_rear_axle_ry = fnma(s9_126, s9_129, fma(s9_123, s9_124, s9_130));
  const double s9_131 = fma(s9_106, s9_115, fma(work.s7_367, s9_95, work.s7_371*s9_93));
  const double s9_132 = s9_113*s9_114;
  const double s9_133 = s9_119*fma(s9_105, s9_132, s9_109);
  const double s9_134 = fma(s9_106, s9_117, fma(work.s7_349, s9_92, work.s7_355*s9_90));
  const double s9_135 = fnma(s9_120, s9_131, s9_134);
  const double s9_136 = fnma(work.s7_422, s9_109, fnma(work.s7_421, s9_113, s9_118*s9_133));
  const double s9_137 = s9_128*fnma(s9_108, s9_132, s9_136);
  const double s9_138 = fma(s9_106, s9_122, fma(work.s7_406, s9_101, work.s7_408*s9_102));
  const double s9_139 = fnma(s9_129, s9_135, fma(s9_124, s9_131, s9_138));
  const double s9_140 = fma(work.s7_422, s9_111, fnma(work.s7_424, s9_113, s9_123*s9_133));
  const double s9_141 = 1.0/pivot_rear_axle_ry;
  const double s9_142 = fnma(s9_126, s9_137, fnma(s9_107, s9_132, s9_140))*s9_141;
  const double s9_143 = fnma(work.s7_421, s9_111, fnma(work.s7_424, s9_109, s9_131*s9_133));
  const double pivot_rear_axle_rz = fnma(s9_139, s9_142, fnma(s9_135, s9_137, fnma(s9_106, s9_132,
      s9_143)));
  const double s9_144 = s9_100*s9_114;
  const double s9_145 = fnma(s9_104, s9_115, s9_93);
  const double s9_146 = s9_119*fms(s9_105, s9_144, s9_98);
  const double s9_147 = fnma(s9_120, s9_145, fnma(s9_104, s9_117, s9_90));
  const double s9_148 = fma(work.s7_390, s9_100, fnma(work.s7_389, s9_98, s9_118*s9_146));
  const double s9_149 = s9_128*fnma(s9_108, s9_144, s9_148);
  const double s9_150 = fnma(s9_129, s9_147, fma(s9_124, s9_145, fnma(s9_104, s9_122, s9_102)));
  const double s9_151 = fnma(work.s7_388, s9_100, fnma(work.s7_389, s9_97, s9_123*s9_146));
  const double s9_152 = s9_141*fnma(s9_126, s9_149, fnma(s9_107, s9_144, s9_151));
  const double s9_153 = fnma(s9_137, s9_147, fma(s9_133, s9_145, fma(s9_104, s9_132, s9_111)));
  const double s9_154 = fnma(s9_142, s9_150, s9_153);
  const double s9_155 = fnma(s9_106, s9_144, fma(work.s7_388, s9_98, work.s7_390*s9_97));
  const double s9_156 = 1.0/pivot_rear_axle_rz;
  const double s9_157 = fnma(s9_139, s9_152, fnma(s9_135, s9_149, fma(s9_131, s9_146, s9_155)));
  const double s9_158 = s9_157*s9_156;
  const double s9_159 = fnma(s9_147, s9_149, fma(s9_145, s9_146, fma(s9_104, s9_144, s9_97)));
  const double pivot_rear_axle_tz = fnma(s9_154, s9_158, fnma(s9_150, s9_152, s9_159));
  const double s9_160 = 1.2494533266510743*std::abs(pivot_rear_axle_tx);
  const double s9_161 = mbgen::min(s9_160, 1.665350081353039*std::abs(s9_116));
  const double s9_162 = mbgen::min(s9_161, 2.1234888829989926*std::abs(pivot_rear_axle_rx));
  const double s9_163 = mbgen::min(s9_162, 1.7864443153153613*std::abs(pivot_rear_axle_ry));
  const double s9_164 = mbgen::min(s9_163, 8.176955428452642*std::abs(pivot_rear_axle_rz));
  const double s9_165 = mbgen::min(s9_164, 2.7700489841913827*std::abs(pivot_rear_axle_tz));
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  result.pivot[1] = mbgen::min(s9_165, std::abs(work.s1_75));
  const double s9_166 = work.Q_rear_axle_tx*s9_114;
  const double s9_167 = s9_119*fnma(s9_105, s9_166, work.Q_rear_axle_ty);
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s9_168 = fma(tau_rear_axle_rz, work.s1_81, fms(s9_118, s9_167, work.s7_602));
  const double s9_169 = s9_128*fma(s9_108, s9_166, s9_168);
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double s9_170 = fma(tau_rear_axle_rx, work.s1_77, fms(s9_123, s9_167, work.s7_596));
  const double s9_171 = fma(tau_rear_axle_ry, work.cosines[17], s9_170);
  const double s9_172 = fma(s9_107, s9_166, fma(tau_rear_axle_rz, work.s1_79, s9_171));
  const double s9_173 = s9_141*fnma(s9_126, s9_169, s9_172);
  const double s9_174 = fma(tau_rear_axle_rx, work.s1_78, fms(s9_131, s9_167, work.s7_599));
  const double s9_175 = fma(tau_rear_axle_rz, work.s1_80, s9_174);
  const double s9_176 = fma(s9_106, s9_166, fnma(tau_rear_axle_ry, work.sines[17], s9_175));
  const double s9_177 = s9_156*fnma(s9_139, s9_173, fnma(s9_135, s9_169, s9_176));
  const double s9_178 = fnma(s9_104, s9_166, fma(s9_145, s9_167, work.Q_rear_axle_tz));
  const double s9_179 = fnma(s9_154, s9_177, fnma(s9_150, s9_173, fnma(s9_147, s9_169, s9_178)));
  const double s9_180 = 1.0/pivot_rear_axle_tz*s9_179;
  result.lambda[13] = l_arb_link_rear_left*s9_180;
  const double s9_181 = fnma(s9_158, s9_180, s9_177);
  result.lambda[16] = l_arb_link_rear_right*s9_181;
  const double s9_182 = fnma(s9_152, s9_180, fnma(s9_142, s9_181, s9_173));
  result.lambda[14] = l_long_rod_right*s9_182;
  const double s9_183 = fnma(s9_149, s9_180, fnma(s9_137, s9_181, fnma(s9_129, s9_182, s9_169)));
  result.lambda[11] = l_long_rod_left*s9_183;
  const double s9_184 = fma(s9_124, s9_182, fma(s9_133, s9_181, fms(s9_146, s9_180, s9_167)));
  const double s9_185 = fnma(s9_120, s9_183, s9_184);
  result.lambda[12] = l_diag_rod_left*s9_185;
  const double s9_186 = fnma(s9_115, s9_185, fma(s9_132, s9_181, fma(s9_144, s9_180, s9_166)));
  result.lambda[15] = l_diag_rod_right*fnma(s9_122, s9_182, fnma(s9_117, s9_183, s9_186));
  // operations: 255 add, 289 multiply, 17 divide, 38 other
}

/// Multipliers of the closures and generalised driving forces, at given accelerations.
void compute_multipliers(const Tuned& /*parameters*/, const Inputs& /*inputs*/, const State& state,
    const double* tau, const Derivative& derivative, ConstraintForces& __restrict result) noexcept {
  ConstraintForcesWork work;
  compute_multipliers_1(state, derivative, work);
  compute_multipliers_2(tau, work, result);
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
      sines[19], cosines[19], s1_16, r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux5_x_x,
      R_rear_axle_aux5_y_x, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z,
      R_rear_axle_z_y, R_rear_axle_z_z, s4_25, s4_26, s4_27, s4_28, s4_29, s4_30, s4_31, s4_32,
      s2_190, s2_200, s2_201, s2_202, s2_204, s2_205, s2_208, s2_213, s2_216, s2_219;
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
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[0];
  const double s1_1 = work.sines[1];
  const double R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_1;
  const double R_carrier_left_aux1_x_x = work.cosines[1];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = work.sines[0];
  const double R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_1;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_2 = -p_carrier_left_rz_z*R_lower_arm_left_z_y;
  const double s1_3 = fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_2);
  const double r_carrier_left_aux1_y = p_lower_arm_left_y + s1_3;
  const double s1_4 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_5 = fnma(-p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_4);
  const double r_carrier_left_aux1_z = s1_5 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_6 = work.cosines[2];
  const double s1_7 = s1_1*s1_6;
  const double s1_8 = work.sines[2];
  const double R_carrier_left_aux2_x_z = s1_1*s1_8;
  const double R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_8,
      R_carrier_left_aux1_y_y*s1_6);
  const double s1_9 = fma(R_carrier_left_aux1_y_y, s1_8, R_lower_arm_left_z_y*s1_6);
  const double R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_y, s1_6,
      R_lower_arm_left_y_y*s1_8);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_8,
      R_lower_arm_left_y_y*s1_6);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_10 = work.cosines[3];
  const double s1_11 = work.sines[3];
  const double R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_11,
      R_carrier_left_aux1_x_x*s1_10);
  const double R_carrier_left_x_z = fma(R_carrier_left_aux2_x_z, s1_10,
      R_carrier_left_aux1_x_x*s1_11);
  const double R_carrier_left_y_x = fma(s1_9, s1_11, R_carrier_left_aux1_y_x*s1_10);
  const double R_carrier_left_y_z = fnma(s1_9, s1_10, R_carrier_left_aux1_y_x*s1_11);
  const double R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_11,
      R_carrier_left_aux1_z_x*s1_10);
  const double R_carrier_left_z_z = fma(R_carrier_left_aux2_z_z, s1_10,
      R_carrier_left_aux1_z_x*s1_11);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[6];
  const double s1_12 = work.sines[7];
  const double R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_12;
  const double R_carrier_right_aux1_x_x = work.cosines[7];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[6];
  const double R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_12;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_13 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  const double s1_14 = fnma(-p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_13);
  const double r_carrier_right_aux1_y = s1_14 - (-p_lower_arm_right_y);
  const double s1_15 = -p_carrier_right_rz_y*R_lower_arm_right_z_y;
  work.s1_16 = fma(-p_carrier_right_rz_z, R_lower_arm_right_y_y, s1_15);
  const double s1_17 = -p_lower_arm_right_z + work.s1_16;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_18 = work.cosines[8];
  const double s1_19 = s1_12*s1_18;
  const double s1_20 = work.sines[8];
  const double R_carrier_right_aux2_x_z = s1_12*s1_20;
  const double R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_20,
      R_carrier_right_aux1_y_y*s1_18);
  const double s1_21 = fma(R_carrier_right_aux1_y_y, s1_20, R_lower_arm_right_z_y*s1_18);
  const double R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_y, s1_18,
      R_lower_arm_right_y_y*s1_20);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_20,
      R_lower_arm_right_y_y*s1_18);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_22 = work.cosines[9];
  const double s1_23 = work.sines[9];
  const double R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_23,
      R_carrier_right_aux1_x_x*s1_22);
  const double R_carrier_right_x_z = fma(R_carrier_right_aux2_x_z, s1_22,
      R_carrier_right_aux1_x_x*s1_23);
  const double R_carrier_right_y_x = fma(s1_21, s1_23, R_carrier_right_aux1_y_x*s1_22);
  const double R_carrier_right_y_z = fnma(s1_21, s1_22, R_carrier_right_aux1_y_x*s1_23);
  const double R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_23,
      R_carrier_right_aux1_z_x*s1_22);
  const double R_carrier_right_z_z = fma(R_carrier_right_aux2_z_z, s1_22,
      R_carrier_right_aux1_z_x*s1_23);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  const double R_rear_axle_aux5_z_z = work.cosines[15];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_24 = work.sines[15];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_24;
  const double R_rear_axle_aux4_y_x = work.sines[14];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_24;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_25 = work.sines[16];
  const double s1_26 = work.cosines[16];
  work.R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_26, R_rear_axle_aux5_x_z*s1_25);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_26, R_rear_axle_aux4_y_x*s1_25);
  work.R_rear_axle_y_y = fma(R_rear_axle_aux5_y_z, s1_25, R_rear_axle_aux4_x_x*s1_26);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_25, R_rear_axle_aux5_y_z*s1_26);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_25;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_26;
  // operations: 34 add, 74 multiply, 38 sin cos

  // --- step 4: velocities ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double s4_1 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  const double s4_2 = fnma(zd_carrier_left_ry, s1_7, s4_1);
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double s4_3 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  const double s4_4 = zd_carrier_left_ry*R_carrier_left_aux2_z_y;
  const double s4_5 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  const double s4_6 = zd_carrier_left_rx*R_carrier_left_aux1_z_x;
  const double s4_7 = s4_5 + s4_6;
  const double s4_8 = s4_4 + s4_7;
  const double s4_9 = zd_carrier_left_ry*R_carrier_left_aux2_y_y;
  const double s4_10 = zd_carrier_left_rx*R_carrier_left_aux1_y_x;
  const double s4_11 = s4_10 - s4_3;
  const double s4_12 = s4_9 + s4_11;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double s4_13 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  const double s4_14 = fnma(zd_carrier_right_ry, s1_19, s4_13);
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double s4_15 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  const double s4_16 = zd_carrier_right_ry*R_carrier_right_aux2_z_y;
  const double s4_17 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  const double s4_18 = zd_carrier_right_rx*R_carrier_right_aux1_z_x;
  const double s4_19 = s4_17 + s4_18;
  const double s4_20 = s4_16 + s4_19;
  const double s4_21 = zd_carrier_right_ry*R_carrier_right_aux2_y_y;
  const double s4_22 = zd_carrier_right_rx*R_carrier_right_aux1_y_x;
  const double s4_23 = s4_22 - s4_15;
  const double s4_24 = s4_21 + s4_23;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  work.s4_25 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s4_26 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.s4_27 = work.s4_25 + work.s4_26;
  work.s4_28 = zd_rear_axle_rx*s1_24;
  work.s4_29 = state.zd[Coordinate::rear_axle_rz] - work.s4_28;
  work.s4_30 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.s4_31 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  work.s4_32 = work.s4_30 - work.s4_31;
  // operations: 13 add, 21 multiply

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s2_1 = zd_lower_arm_left + s4_2;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s2_2 = zd_lower_arm_right + s4_14;
  const double s2_3 = zd_lower_arm_left + s4_1;
  const double s2_4 = zd_lower_arm_right + s4_13;
  const double s2_5 = fnma(s4_5, s4_10, fnma(s4_3, s4_6, fnma(s4_7, s4_9, s4_4*s4_11)));
  const double s2_6 = fnma(s4_17, s4_22, fnma(s4_15, s4_18, fnma(s4_19, s4_21, s4_16*s4_23)));
  const double s2_7 = fma(zd_carrier_left_ry, s1_7, zd_lower_arm_left);
  const double s2_8 = fma(s4_11, s2_7, fma(s4_1, s4_3, s4_9*s2_3));
  const double s2_9 = fma(zd_carrier_right_ry, s1_19, zd_lower_arm_right);
  const double s2_10 = fma(s4_23, s2_9, fma(s4_13, s4_15, s4_21*s2_4));
  const double s2_11 = fnma(s4_7, s2_7, fnma(s4_4, s2_3, s4_1*s4_5));
  const double s2_12 = fnma(s4_19, s2_9, fnma(s4_16, s2_4, s4_13*s4_17));
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s2_13 = zd_lower_arm_left*zd_lower_arm_left;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s2_14 = s1_3*s2_13;
  const double s2_15 = s1_5*s2_13;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s2_16 = zd_lower_arm_right*zd_lower_arm_right;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s2_17 = work.s1_16*s2_16;
  const double s2_18 = s1_14*s2_16;
  // upper_ball_left
  const double s2_19 = -p_carrier_left_upper_ball_y*R_carrier_left_aux2_z_y;
  const double s2_20 = -p_carrier_left_upper_ball_y*R_carrier_left_aux2_y_y;
  const double R_upper_arm_left_z_y = work.sines[4];
  const double R_upper_arm_left_y_y = work.cosines[4];
  const double s2_21 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_22 = fnma(-p_upper_arm_left_ball_z, R_upper_arm_left_y_y, s2_21);
  result.Jz[18] = s2_22;
  const double s2_23 = -p_carrier_left_upper_ball_y*s1_7;
  const double s2_24 = fma(p_carrier_left_upper_ball_z, R_carrier_left_x_z, s2_23);
  result.Phi[0] = s2_24;
  result.Jz[29] = R_lower_arm_left_z_y*s2_24;
  result.Jz[15] = R_lower_arm_left_y_y*s2_24;
  const double s2_25 = -p_upper_arm_left_ball_z*R_upper_arm_left_z_y;
  const double s2_26 = fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s2_25);
  result.Jz[32] = -s2_26;
  const double s2_27 = fms(p_carrier_left_upper_ball_z, R_carrier_left_z_z, s2_19);
  const double s2_28 = fms(p_carrier_left_upper_ball_z, R_carrier_left_y_z, s2_20);
  result.Jz[17] = fma(R_carrier_left_aux2_z_y, s2_24, s1_7*s2_27);
  result.Phi[1] = r_carrier_left_aux1_y + s2_28 - s2_26 - p_upper_arm_left_y;
  result.Phi[2] = -p_upper_arm_left_z + (r_carrier_left_aux1_z + s2_27 - s2_22);
  result.Jz[30] = fnma(R_carrier_left_aux1_y_x, s2_24, R_carrier_left_aux1_x_x*s2_28);
  result.Jz[16] = fnma(R_carrier_left_aux1_x_x, s2_27, R_carrier_left_aux1_z_x*s2_24);
  result.Jz[2] = fnma(R_carrier_left_aux1_z_x, s2_28, R_carrier_left_aux1_y_x*s2_27);
  result.Jz[3] = fnma(R_carrier_left_aux2_z_y, s2_28, R_carrier_left_aux2_y_y*s2_27);
  result.Jz[28] = s1_3 + s2_28;
  result.Jz[14] = -(s1_5 + s2_27);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  result.Jz[1] = -fma(R_lower_arm_left_y_y, s2_28, R_lower_arm_left_z_y*s2_27);
  result.Jz[31] = -fma(R_carrier_left_aux2_y_y, s2_24, s1_7*s2_28);
  const double s2_29 = fnma(s4_12, s2_24, s2_1*s2_28);
  const double s2_30 = fnma(s2_1, s2_27, s4_8*s2_24);
  result.c[0] = fma(s4_8, s2_30, fnma(s4_12, s2_29, fnma(s2_11, s2_27, s2_8*s2_28)));
  const double s2_31 = fnma(s4_8, s2_28, s4_12*s2_27);
  const double s2_32 = fnma(zd_upper_arm_left, zd_upper_arm_left*s2_26, s2_14);
  const double s2_33 = fnma(s4_8, s2_31, fma(s2_5, s2_27, fnma(s2_8, s2_24, s2_32)));
  result.c[1] = fma(s2_1, s2_29, s2_33);
  const double s2_34 = fnma(zd_upper_arm_left, zd_upper_arm_left*s2_22, s2_15);
  const double s2_35 = fnma(s2_1, s2_30, fma(s2_11, s2_24, fnma(s2_5, s2_28, s2_34)));
  result.c[2] = fma(s4_12, s2_31, s2_35);
  // upper_ball_right
  const double s2_36 = p_carrier_right_upper_ball_y*s1_19;
  const double R_upper_arm_right_z_y = work.sines[10];
  const double R_upper_arm_right_y_y = work.cosines[10];
  const double s2_37 = -p_upper_arm_right_ball_z*R_upper_arm_right_z_y;
  const double s2_38 = fnma(-p_upper_arm_right_ball_y, R_upper_arm_right_y_y, s2_37);
  const double s2_39 = fms(p_carrier_right_upper_ball_z, R_carrier_right_x_z, s2_36);
  result.Phi[3] = s2_39;
  result.Jz[77] = R_lower_arm_right_z_y*s2_39;
  result.Jz[63] = R_lower_arm_right_y_y*s2_39;
  const double s2_40 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_z_y;
  const double s2_41 = fma(p_carrier_right_upper_ball_z, R_carrier_right_z_z, s2_40);
  const double s2_42 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_y_y;
  const double s2_43 = fma(p_carrier_right_upper_ball_z, R_carrier_right_y_z, s2_42);
  const double s2_44 = -p_upper_arm_right_ball_y*R_upper_arm_right_z_y;
  const double s2_45 = fma(-p_upper_arm_right_ball_z, R_upper_arm_right_y_y, s2_44);
  result.Jz[66] = -s2_45;
  result.Jz[80] = -s2_38;
  result.Jz[62] = work.s1_16 - s2_41;
  result.Phi[5] = -p_upper_arm_right_z + (s2_41 + s2_45 - s1_17);
  result.Jz[65] = fma(R_carrier_right_aux2_z_y, s2_39, s1_19*s2_41);
  result.Jz[76] = s1_14 + s2_43;
  result.Phi[4] = -p_upper_arm_right_y + (r_carrier_right_aux1_y + s2_43 - s2_38);
  result.Jz[78] = fnma(R_carrier_right_aux1_y_x, s2_39, R_carrier_right_aux1_x_x*s2_43);
  result.Jz[64] = fnma(R_carrier_right_aux1_x_x, s2_41, R_carrier_right_aux1_z_x*s2_39);
  result.Jz[50] = fnma(R_carrier_right_aux1_z_x, s2_43, R_carrier_right_aux1_y_x*s2_41);
  result.Jz[51] = fnma(R_carrier_right_aux2_z_y, s2_43, R_carrier_right_aux2_y_y*s2_41);
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  result.Jz[49] = -fma(R_lower_arm_right_y_y, s2_43, R_lower_arm_right_z_y*s2_41);
  result.Jz[79] = -fma(R_carrier_right_aux2_y_y, s2_39, s1_19*s2_43);
  const double s2_46 = fnma(s4_24, s2_39, s2_2*s2_43);
  const double s2_47 = fnma(s2_2, s2_41, s4_20*s2_39);
  result.c[3] = fma(s4_20, s2_47, fnma(s4_24, s2_46, fnma(s2_12, s2_41, s2_10*s2_43)));
  const double s2_48 = fnma(s4_20, s2_43, s4_24*s2_41);
  const double s2_49 = fnma(zd_upper_arm_right, zd_upper_arm_right*s2_38, s2_18);
  const double s2_50 = fnma(s4_20, s2_48, fma(s2_6, s2_41, fnma(s2_10, s2_39, s2_49)));
  result.c[4] = fma(s2_2, s2_46, s2_50);
  const double s2_51 = fnma(s2_2, s2_47, fnma(s2_6, s2_43, fms(s2_12, s2_39, s2_17)));
  const double s2_52 = zd_upper_arm_right*s2_45;
  result.c[5] = fma(zd_upper_arm_right, s2_52, fma(s4_24, s2_48, s2_51));
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[5];
  const double R_arb_front_left_x_x = work.cosines[5];
  const double s2_53 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s2_54 = fnma(-p_arb_link_front_left_from_x, R_arb_front_left_x_x, s2_53);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s2_55 = zd_arb_front_left*s2_54;
  const double s2_56 = -p_arb_link_front_left_from_x*R_arb_front_left_x_z;
  const double s2_57 = fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s2_56);
  const double s2_58 = zd_arb_front_left*s2_57;
  const double s2_59 = p_arb_link_front_left_to_x*R_carrier_left_x_x;
  const double s2_60 = fma(-p_arb_link_front_left_to_y, s1_7 + R_carrier_left_x_z, s2_59);
  const double s2_61 = p_arb_link_front_left_to_x*R_carrier_left_z_x;
  const double s2_62 = R_carrier_left_z_z - R_carrier_left_aux2_z_y;
  const double s2_63 = fma(-p_arb_link_front_left_to_y, s2_62, s2_61);
  const double s2_64 = fnma(s2_1, s2_63, s4_8*s2_60);
  const double s2_65 = fnma(zd_lower_arm_left, s1_5, s2_64);
  const double s2_66 = p_arb_link_front_left_to_x*R_carrier_left_y_x;
  const double s2_67 = R_carrier_left_y_z - R_carrier_left_aux2_y_y;
  const double s2_68 = fma(-p_arb_link_front_left_to_y, s2_67, s2_66);
  const double s2_69 = fnma(s4_12, s2_60, s2_1*s2_68);
  const double s2_70 = s2_55 + fma(zd_lower_arm_left, s1_3, s2_69);
  const double s2_71 = 0.72 - r_carrier_left_aux1_y - s2_68;
  const double s2_72 = 3.846153846153846*s2_71;
  const double s2_73 = 0.35 + (s2_54 - s2_60);
  const double s2_74 = 3.846153846153846*s2_73;
  const double s2_75 = s2_57 - r_carrier_left_aux1_z - s2_63 - (-p_arb_front_left_z);
  const double s2_76 = 3.846153846153846*s2_75;
  result.Jz[89] = fnma(s2_54, s2_76, s2_57*s2_74);
  const double s2_77 = fnma(s4_8, s2_68, s4_12*s2_63);
  const double s2_78 = fma(s4_8, s2_77, fnma(s2_5, s2_63, fms(s2_8, s2_60, s2_14)));
  const double s2_79 = fnma(s2_63, s2_72, s2_68*s2_76);
  const double s2_80 = fnma(s2_68, s2_74, s2_60*s2_72);
  const double s2_81 = fnma(s2_60, s2_76, s2_63*s2_74);
  const double s2_82 = fma(s2_5, s2_68, fms(zd_arb_front_left, s2_58, s2_15));
  const double s2_83 = fnma(s2_8, s2_68, fma(s2_11, s2_63, zd_arb_front_left*s2_55));
  result.Jz[84] = fnma(s1_3, s2_76, fms(s1_5, s2_72, s2_79));
  const double s2_84 = fma(s2_73, s2_74, fms(s2_71, s2_72, l_arb_link_front_left));
  result.Phi[6] = 0.5*fma(s2_75, s2_76, s2_84);
  result.Jz[85] = fnma(R_lower_arm_left_y_y, s2_80, R_lower_arm_left_z_y*s2_81);
  const double s2_85 = fma(R_carrier_left_aux1_x_x, s2_79, R_carrier_left_aux1_y_x*s2_81);
  result.Jz[86] = -fma(R_carrier_left_aux1_z_x, s2_80, s2_85);
  const double s2_86 = fnma(R_carrier_left_aux2_y_y, s2_81, s1_7*s2_79);
  result.Jz[87] = fnma(R_carrier_left_aux2_z_y, s2_80, s2_86);
  const double s2_87 = s2_58 - s2_77;
  const double s2_88 = fma(s2_70, s2_70, fma(s2_87, s2_87, s2_65*s2_65));
  const double s2_89 = fnma(3.846153846153846, s2_88, s2_72*fnma(s2_1, s2_69, s2_78));
  const double s2_90 = fnma(s4_12, s2_77, fma(s2_1, s2_64, fnma(s2_11, s2_60, s2_82)));
  const double s2_91 = fma(s2_74, fnma(s4_8, s2_64, fma(s4_12, s2_69, s2_83)), s2_89);
  result.c[6] = fma(s2_76, s2_90, s2_91);
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[11];
  const double R_arb_front_right_x_x = work.cosines[11];
  const double s2_92 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s2_93 = fnma(-p_arb_link_front_right_from_x, R_arb_front_right_x_x, s2_92);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s2_94 = zd_arb_front_right*s2_93;
  const double s2_95 = -p_arb_link_front_right_from_x*R_arb_front_right_x_z;
  const double s2_96 = fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s2_95);
  const double s2_97 = zd_arb_front_right*s2_96;
  const double s2_98 = p_arb_link_front_right_to_x*R_carrier_right_y_x;
  const double s2_99 = R_carrier_right_aux2_y_y + R_carrier_right_y_z;
  const double s2_100 = fma(-p_arb_link_front_left_to_y, s2_99, s2_98);
  const double s2_101 = 0.72 + (r_carrier_right_aux1_y + s2_100);
  const double s2_102 = p_arb_link_front_right_to_x*R_carrier_right_x_x;
  const double s2_103 = fma(-p_arb_link_front_left_to_y, R_carrier_right_x_z - s1_19, s2_102);
  const double s2_104 = p_arb_link_front_right_to_x*R_carrier_right_z_x;
  const double s2_105 = R_carrier_right_aux2_z_y + R_carrier_right_z_z;
  const double s2_106 = fma(-p_arb_link_front_left_to_y, s2_105, s2_104);
  const double s2_107 = fnma(s2_2, s2_106, s4_20*s2_103);
  const double s2_108 = fma(zd_lower_arm_right, work.s1_16, s2_107);
  const double s2_109 = 3.846153846153846*s2_101;
  const double s2_110 = fnma(s4_24, s2_103, s2_2*s2_100);
  const double s2_111 = s2_94 + fma(zd_lower_arm_right, s1_14, s2_110);
  const double s2_112 = 0.35 + (s2_93 - s2_103);
  const double s2_113 = 3.846153846153846*s2_112;
  const double s2_114 = s1_17 + s2_96 - s2_106 - (-p_arb_front_right_z);
  const double s2_115 = 3.846153846153846*s2_114;
  result.Jz[109] = fnma(s2_93, s2_115, s2_96*s2_113);
  const double s2_116 = fnma(s4_20, s2_100, s4_24*s2_106);
  const double s2_117 = fma(s4_20, s2_116, fnma(s2_6, s2_106, fms(s2_10, s2_103, s2_18)));
  const double s2_118 = fma(s2_100, s2_113, s2_103*s2_109);
  const double s2_119 = fma(s2_100, s2_115, s2_106*s2_109);
  const double s2_120 = fnma(s2_103, s2_115, s2_106*s2_113);
  const double s2_121 = fma(s2_6, s2_100, fma(zd_arb_front_right, s2_97, s2_17));
  const double s2_122 = fnma(s2_10, s2_100, fma(s2_12, s2_106, zd_arb_front_right*s2_94));
  result.Jz[104] = fnma(s1_14, s2_115, fms(work.s1_16, s2_109, s2_119));
  const double s2_123 = fma(s2_112, s2_113, fms(s2_101, s2_109, l_arb_link_front_right));
  result.Phi[7] = 0.5*fma(s2_114, s2_115, s2_123);
  result.Jz[105] = fma(R_lower_arm_right_y_y, s2_118, R_lower_arm_right_z_y*s2_120);
  const double s2_124 = fnma(R_carrier_right_aux1_y_x, s2_120, R_carrier_right_aux1_z_x*s2_118);
  result.Jz[106] = fnma(R_carrier_right_aux1_x_x, s2_119, s2_124);
  const double s2_125 = fnma(R_carrier_right_aux2_y_y, s2_120, s1_19*s2_119);
  result.Jz[107] = fma(R_carrier_right_aux2_z_y, s2_118, s2_125);
  const double s2_126 = s2_97 - s2_116;
  const double s2_127 = fma(s2_111, s2_111, fma(s2_126, s2_126, s2_108*s2_108));
  const double s2_128 = s2_113*fnma(s4_20, s2_107, fma(s4_24, s2_110, s2_122));
  const double s2_129 = fnma(3.846153846153846, s2_127, s2_128);
  const double s2_130 = fnma(s4_24, s2_116, fma(s2_2, s2_107, fnma(s2_12, s2_103, s2_121)));
  result.c[7] = fma(s2_115, s2_130, fnma(s2_109, fnma(s2_2, s2_110, s2_117), s2_129));
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
  const double s2_143 = 1.15 + (s2_133 - s2_131);
  const double s2_144 = 0.8565801464479954*s2_143;
  result.Jz[125] = fma(s2_137, s2_144, s2_133*s2_140);
  result.Jz[124] = fnma(s2_132, s2_144, s2_131*s2_142);
  const double s2_145 = fma(s2_141, s2_142, fms(s2_139, s2_140, l_drag_link));
  result.Phi[8] = 0.5*fma(s2_143, s2_144, s2_145);
  const double s2_146 = s2_138 - s2_135;
  const double s2_147 = fma(zd_pitman_arm*s2_135, s2_142, zd_bell_crank*s2_138*s2_140);
  const double s2_148 = fma(s2_144, fnma(zd_bell_crank, s2_136, zd_pitman_arm*s2_134), s2_147);
  const double s2_149 = fma(s2_146, s2_146, fma(s2_134, s2_134, s2_136*s2_136));
  result.c[8] = -fma(0.8565801464479954, s2_149, s2_148);
  // tie_rod_left
  const double s2_150 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_151 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  const double s2_152 = fma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s2_150);
  const double s2_153 = zd_bell_crank*s2_152;
  const double s2_154 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_151);
  const double s2_155 = zd_bell_crank*s2_154;
  const double s2_156 = fms(p_tie_rod_left_to_z, R_carrier_left_z_z, s2_19);
  const double s2_157 = fnma(-p_tie_rod_left_to_x, R_carrier_left_z_x, s2_156);
  const double s2_158 = -p_bell_crank_z + (r_carrier_left_aux1_z + s2_157);
  const double s2_159 = fms(p_tie_rod_left_to_z, R_carrier_left_y_z, s2_20);
  const double s2_160 = fnma(-p_tie_rod_left_to_x, R_carrier_left_y_x, s2_159);
  const double s2_161 = fma(p_tie_rod_left_to_z, R_carrier_left_x_z, s2_23);
  const double s2_162 = fnma(-p_tie_rod_left_to_x, R_carrier_left_x_x, s2_161);
  const double s2_163 = fnma(s4_12, s2_162, s2_1*s2_160);
  const double s2_164 = fma(zd_lower_arm_left, s1_3, s2_163);
  const double s2_165 = fnma(s4_8, s2_160, s4_12*s2_157);
  const double s2_166 = s2_155 + s2_165;
  const double s2_167 = 1.262590031797617*s2_158;
  const double s2_168 = s2_154 - r_carrier_left_aux1_y - s2_160;
  const double s2_169 = 1.262590031797617*s2_168;
  const double s2_170 = fnma(s2_1, s2_157, s4_8*s2_162);
  const double s2_171 = fnma(zd_lower_arm_left, s1_5, s2_153 + s2_170);
  const double s2_172 = 0.35 + (s2_152 + s2_162);
  const double s2_173 = 1.262590031797617*s2_172;
  const double s2_174 = fma(s2_1, s2_170, fnma(s2_11, s2_162, fms(s2_5, s2_160, s2_15)));
  result.Jz[139] = fnma(s2_152, s2_169, s2_154*s2_173);
  const double s2_175 = fma(s2_157, s2_169, s2_160*s2_167);
  const double s2_176 = fnma(s2_157, s2_173, s2_162*s2_167);
  const double s2_177 = fma(s2_160, s2_173, s2_162*s2_169);
  result.Jz[126] = fma(s1_5, s2_169, fma(s1_3, s2_167, s2_175));
  const double s2_178 = fnma(s2_5, s2_157, fma(s2_8, s2_162, fms(zd_bell_crank, s2_155, s2_14)));
  const double s2_179 = fma(s2_158, s2_167, fms(s2_168, s2_169, l_tie_rod_left));
  result.Phi[9] = 0.5*fma(s2_172, s2_173, s2_179);
  result.Jz[127] = fnma(R_lower_arm_left_y_y, s2_177, R_lower_arm_left_z_y*s2_176);
  const double s2_180 = fnma(R_carrier_left_aux1_y_x, s2_176, R_carrier_left_aux1_x_x*s2_175);
  result.Jz[128] = fnma(R_carrier_left_aux1_z_x, s2_177, s2_180);
  const double s2_181 = fma(s1_7, s2_175, R_carrier_left_aux2_y_y*s2_176);
  result.Jz[129] = -fma(R_carrier_left_aux2_z_y, s2_177, s2_181);
  const double s2_182 = fma(s2_8, s2_160, fnma(s2_11, s2_157, zd_bell_crank*s2_153));
  const double s2_183 = fma(s2_171, s2_171, fma(s2_166, s2_166, s2_164*s2_164));
  const double s2_184 = s2_169*fnma(s2_1, s2_163, fma(s4_8, s2_165, s2_178));
  const double s2_185 = fnma(1.262590031797617, s2_183, s2_184);
  const double s2_186 = fnma(s2_167, fnma(s4_12, s2_165, s2_174), s2_185);
  result.c[9] = fma(s2_173, fma(s4_8, s2_170, fnma(s4_12, s2_163, s2_182)), s2_186);
  // tie_rod_right
  const double s2_187 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_151);
  const double s2_188 = zd_bell_crank*s2_187;
  const double s2_189 = fnma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s2_150);
  work.s2_190 = zd_bell_crank*s2_189;
  const double s2_191 = fma(p_tie_rod_right_to_z, R_carrier_right_z_z, s2_40);
  const double s2_192 = fnma(-p_tie_rod_right_to_x, R_carrier_right_z_x, s2_191);
  const double s2_193 = -p_bell_crank_z + (s2_192 - s1_17);
  const double s2_194 = fma(p_tie_rod_right_to_z, R_carrier_right_y_z, s2_42);
  const double s2_195 = fnma(-p_tie_rod_right_to_x, R_carrier_right_y_x, s2_194);
  const double s2_196 = s2_187 + (r_carrier_right_aux1_y + s2_195);
  const double s2_197 = fms(p_tie_rod_right_to_z, R_carrier_right_x_z, s2_36);
  const double s2_198 = fnma(-p_tie_rod_right_to_x, R_carrier_right_x_x, s2_197);
  const double s2_199 = fnma(s4_24, s2_198, s2_2*s2_195);
  work.s2_200 = fma(zd_lower_arm_right, s1_14, s2_199);
  work.s2_201 = 1.262590031797617*s2_193;
  work.s2_202 = 1.262590031797617*s2_196;
  const double s2_203 = s2_189 - s2_198 - 0.35;
  work.s2_204 = 1.262590031797617*s2_203;
  result.Jz[153] = fnma(s2_189, work.s2_202, s2_187*work.s2_204);
  work.s2_205 = fnma(s2_2, s2_192, s4_20*s2_198);
  const double s2_206 = fnma(s4_20, s2_195, s4_24*s2_192);
  const double s2_207 = fma(s2_2, work.s2_205, fnma(s2_12, s2_198, fma(s2_6, s2_195, s2_17)));
  work.s2_208 = fnma(s4_24, s2_206, s2_207);
  const double s2_209 = fma(s2_195, work.s2_204, s2_198*work.s2_202);
  const double s2_210 = fnma(s2_195, work.s2_201, s2_192*work.s2_202);
  const double s2_211 = fma(s2_192, work.s2_204, s2_198*work.s2_201);
  const double s2_212 = fnma(s2_10, s2_195, fma(s2_12, s2_192, zd_bell_crank*work.s2_190));
  work.s2_213 = fnma(s4_20, work.s2_205, fma(s4_24, s2_199, s2_212));
  result.Jz[146] = fma(work.s1_16, work.s2_202, fms(s1_14, work.s2_201, s2_210));
  const double s2_214 = fma(s2_193, work.s2_201, fms(s2_196, work.s2_202, l_tie_rod_right));
  result.Phi[10] = 0.5*fma(s2_203, work.s2_204, s2_214);
  result.Jz[147] = fma(R_lower_arm_right_y_y, s2_209, R_lower_arm_right_z_y*s2_211);
  const double s2_215 = fnma(s2_10, s2_198, fma(zd_bell_crank, s2_188, s2_18));
  work.s2_216 = fma(s2_2, s2_199, fnma(s4_20, s2_206, fma(s2_6, s2_192, s2_215)));
  const double s2_217 = fnma(R_carrier_right_aux1_y_x, s2_211, R_carrier_right_aux1_z_x*s2_209);
  result.Jz[148] = fnma(R_carrier_right_aux1_x_x, s2_210, s2_217);
  const double s2_218 = fnma(R_carrier_right_aux2_y_y, s2_211, s1_19*s2_210);
  result.Jz[149] = fma(R_carrier_right_aux2_z_y, s2_209, s2_218);
  work.s2_219 = s2_188 - s2_206;
}

/// Part 2 of compute_closure_terms: step 2: closure Jacobian Phi_z and its factors (60).
[[gnu::noinline]] void compute_closure_terms_2(const State& state,
    ClosureTermsWork& __restrict work, ClosureTerms& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  // tie_rod_right
  const double s2_220 = fnma(state.zd[Coordinate::lower_arm_right], work.s1_16, work.s2_190);
  const double s2_221 = s2_220 - work.s2_205;
  const double s2_222 = fma(work.s2_219, work.s2_219, work.s2_200*work.s2_200);
  const double s2_223 = fma(s2_221, s2_221, s2_222);
  const double s2_224 = fnma(1.262590031797617, s2_223, work.s2_204*work.s2_213);
  result.c[10] = fma(work.s2_202, work.s2_216, fnma(work.s2_201, work.s2_208, s2_224));
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s2_225 = fnma(work.s4_28, work.s4_31, zd_rear_axle_rz*work.s4_32);
  const double s2_226 = fma(work.s4_25, work.s4_30, work.s4_26*work.s4_31);
  const double s2_227 = fma(zd_rear_axle_rz, work.s4_27, work.s4_25*work.s4_28);
  // long_rod_left
  const double s1_24 = work.sines[15];
  const double s2_228 = p_long_rod_left_to_x*s1_24;
  const double s2_229 = fma(-p_long_rod_left_to_z, work.R_rear_axle_z_z, s2_228);
  const double s2_230 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s2_231 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_y_z, s2_230);
  const double s2_232 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_231);
  const double s2_233 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s2_234 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_x_z, s2_233);
  const double s2_235 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_234);
  const double s2_236 = fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_229);
  const double s2_237 = -p_long_rod_left_from_z + (work.r_rear_axle_aux3_z + s2_236);
  const double s2_238 = -p_long_rod_left_from_x + (work.r_rear_axle_aux1_x + s2_235);
  const double s2_239 = fnma(work.s4_29, s2_232, work.s4_27*s2_236);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s2_240 = zd_rear_axle_tx + s2_239;
  const double s2_241 = fnma(work.s4_32, s2_236, work.s4_29*s2_235);
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s2_242 = zd_rear_axle_ty + s2_241;
  const double s2_243 = fnma(work.s4_27, s2_235, work.s4_32*s2_232);
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s2_244 = zd_rear_axle_tz + s2_243;
  const double s2_245 = 1.1757385222540735*s2_237;
  result.Jz[156] = s2_245;
  const double s2_246 = 1.1757385222540735*s2_238;
  result.Jz[154] = s2_246;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_247 = p_long_rod_left_from_y - z_rear_axle_ty - s2_232;
  const double s2_248 = 1.1757385222540735*s2_247;
  result.Jz[155] = -s2_248;
  const double s2_249 = fma(work.s4_27, s2_243, fma(s2_225, s2_236, s2_226*s2_232));
  const double s2_250 = fma(work.s4_29, s2_239, fnma(s2_226, s2_235, s2_227*s2_236));
  const double s2_251 = fma(s2_236, s2_248, s2_232*s2_245);
  const double s2_252 = fma(s2_235, s2_248, s2_232*s2_246);
  result.Jz[157] = -s2_252;
  const double s2_253 = fnma(s2_227, s2_232, fnma(work.s4_27, s2_239, work.s4_32*s2_241));
  const double s2_254 = fnma(s2_236, s2_246, s2_235*s2_245);
  const double s2_255 = fma(s2_237, s2_245, fms(s2_247, s2_248, l_long_rod_left));
  result.Phi[11] = 0.5*fma(s2_238, s2_246, s2_255);
  const double R_rear_axle_aux4_y_x = work.sines[14];
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  result.Jz[158] = -fma(R_rear_axle_aux4_x_x, s2_254, R_rear_axle_aux4_y_x*s2_251);
  const double s2_256 = fnma(work.R_rear_axle_aux5_y_x, s2_254, s1_24*s2_252);
  result.Jz[159] = fma(work.R_rear_axle_aux5_x_x, s2_251, s2_256);
  const double s2_257 = fma(s2_244, s2_244, fma(s2_240, s2_240, s2_242*s2_242));
  const double s2_258 = s2_248*fnma(work.s4_32, s2_243, s2_250);
  const double s2_259 = fnma(1.1757385222540735, s2_257, s2_258);
  const double s2_260 = fnma(s2_245, fnma(s2_225, s2_235, s2_253), s2_259);
  result.c[11] = fnma(s2_246, fnma(work.s4_29, s2_241, s2_249), s2_260);
  // diag_rod_left
  const double s2_261 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  const double s2_262 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_261);
  const double s2_263 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  const double s2_264 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_263);
  const double s2_265 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  const double s2_266 = fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s2_265);
  const double s2_267 = -p_diag_rod_left_from_z + (work.r_rear_axle_aux3_z + s2_266);
  const double s2_268 = -p_diag_rod_left_from_x + (work.r_rear_axle_aux1_x + s2_262);
  const double s2_269 = fnma(work.s4_29, s2_264, work.s4_27*s2_266);
  const double s2_270 = zd_rear_axle_tx + s2_269;
  const double s2_271 = fnma(work.s4_32, s2_266, work.s4_29*s2_262);
  const double s2_272 = zd_rear_axle_ty + s2_271;
  const double s2_273 = fnma(work.s4_27, s2_262, work.s4_32*s2_264);
  const double s2_274 = zd_rear_axle_tz + s2_273;
  const double s2_275 = 1.162476387438193*s2_267;
  result.Jz[164] = s2_275;
  const double s2_276 = 1.162476387438193*s2_268;
  result.Jz[162] = s2_276;
  const double s2_277 = p_diag_rod_left_from_y - z_rear_axle_ty - s2_264;
  const double s2_278 = 1.162476387438193*s2_277;
  result.Jz[163] = -s2_278;
  const double s2_279 = fma(work.s4_27, s2_273, fma(s2_225, s2_266, s2_226*s2_264));
  const double s2_280 = fma(work.s4_29, s2_269, fnma(s2_226, s2_262, s2_227*s2_266));
  const double s2_281 = fma(s2_266, s2_278, s2_264*s2_275);
  const double s2_282 = fma(s2_262, s2_278, s2_264*s2_276);
  result.Jz[165] = -s2_282;
  const double s2_283 = fnma(s2_227, s2_264, fnma(work.s4_27, s2_269, work.s4_32*s2_271));
  const double s2_284 = fnma(s2_266, s2_276, s2_262*s2_275);
  const double s2_285 = fma(s2_267, s2_275, fms(s2_277, s2_278, l_diag_rod_left));
  result.Phi[12] = 0.5*fma(s2_268, s2_276, s2_285);
  result.Jz[166] = -fma(R_rear_axle_aux4_x_x, s2_284, R_rear_axle_aux4_y_x*s2_281);
  const double s2_286 = fnma(work.R_rear_axle_aux5_y_x, s2_284, s1_24*s2_282);
  result.Jz[167] = fma(work.R_rear_axle_aux5_x_x, s2_281, s2_286);
  const double s2_287 = fma(s2_274, s2_274, fma(s2_270, s2_270, s2_272*s2_272));
  const double s2_288 = fnma(1.162476387438193, s2_287, s2_278*fnma(work.s4_32, s2_273, s2_280));
  const double s2_289 = fnma(s2_275, fnma(s2_225, s2_262, s2_283), s2_288);
  result.c[12] = fnma(s2_276, fnma(work.s4_29, s2_271, s2_279), s2_289);
  // arb_link_rear_left
  const double s2_290 = p_arb_link_rear_left_from_x*work.sines[17];
  const double s2_291 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s2_292 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s2_291);
  const double s2_293 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s2_294 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s2_293);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s2_295 = zd_arb_rear_left*s2_290;
  const double s2_296 = p_arb_link_rear_left_from_x*work.cosines[17];
  const double s2_297 = zd_arb_rear_left*s2_296;
  const double s2_298 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_292);
  const double s2_299 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_294);
  const double s2_300 = -p_arb_link_rear_left_to_x*s1_24;
  const double s2_301 = fnma(-p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s2_300);
  const double s2_302 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_301);
  const double s2_303 = -p_arb_rear_left_z + (s2_290 + (work.r_rear_axle_aux3_z + s2_302));
  const double s2_304 = fnma(work.s4_32, s2_302, work.s4_29*s2_299);
  const double s2_305 = zd_rear_axle_ty + s2_304;
  const double s2_306 = 4.47213595499958*s2_303;
  result.Jz[172] = s2_306;
  const double s2_307 = 0.6 - z_rear_axle_ty - s2_298;
  const double s2_308 = 4.47213595499958*s2_307;
  result.Jz[171] = -s2_308;
  const double s2_309 = s2_296 - work.r_rear_axle_aux1_x - s2_299 - (-p_arb_rear_left_x);
  const double s2_310 = 4.47213595499958*s2_309;
  result.Jz[170] = -s2_310;
  const double s2_311 = fnma(work.s4_29, s2_298, work.s4_27*s2_302);
  const double s2_312 = s2_295 + (zd_rear_axle_tx + s2_311);
  const double s2_313 = fnma(work.s4_27, s2_299, work.s4_32*s2_298);
  const double s2_314 = s2_297 + (zd_rear_axle_tz + s2_313);
  result.Jz[176] = fnma(s2_290, s2_310, s2_296*s2_306);
  const double s2_315 = fma(work.s4_29, s2_311, fnma(s2_226, s2_299, s2_227*s2_302));
  const double s2_316 = fma(s2_302, s2_308, s2_298*s2_306);
  const double s2_317 = fnma(s2_298, s2_310, s2_299*s2_308);
  result.Jz[173] = -s2_317;
  const double s2_318 = fma(s2_302, s2_310, s2_299*s2_306);
  const double s2_319 = fma(s2_225, s2_302, fma(s2_226, s2_298, zd_arb_rear_left*s2_297));
  const double s2_320 = fma(s2_303, s2_306, fms(s2_307, s2_308, l_arb_link_rear_left));
  result.Phi[13] = 0.5*fma(s2_309, s2_310, s2_320);
  result.Jz[174] = -fma(R_rear_axle_aux4_x_x, s2_318, R_rear_axle_aux4_y_x*s2_316);
  const double s2_321 = fnma(work.s4_32, s2_304, zd_arb_rear_left*s2_295);
  const double s2_322 = fma(s2_227, s2_298, fma(work.s4_27, s2_311, s2_321));
  const double s2_323 = fnma(work.R_rear_axle_aux5_y_x, s2_318, s1_24*s2_317);
  result.Jz[175] = fma(work.R_rear_axle_aux5_x_x, s2_316, s2_323);
  const double s2_324 = fma(s2_314, s2_314, fma(s2_312, s2_312, s2_305*s2_305));
  const double s2_325 = fnma(4.47213595499958, s2_324, s2_308*fnma(work.s4_32, s2_313, s2_315));
  const double s2_326 = fnma(work.s4_29, s2_304, fma(work.s4_27, s2_313, s2_319));
  result.c[13] = fma(s2_310, s2_326, fma(s2_306, fma(s2_225, s2_299, s2_322), s2_325));
  // long_rod_right
  const double s2_327 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_229);
  const double s2_328 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_231);
  const double s2_329 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_234);
  const double s2_330 = -p_long_rod_right_from_y + (z_rear_axle_ty + s2_328);
  const double s2_331 = -p_long_rod_right_from_z + (work.r_rear_axle_aux3_z - s2_327);
  const double s2_332 = -p_long_rod_right_from_x + (work.r_rear_axle_aux1_x + s2_329);
  const double s2_333 = fma(work.s4_29, s2_328, work.s4_27*s2_327);
  const double s2_334 = fma(work.s4_29, s2_329, work.s4_32*s2_327);
  const double s2_335 = zd_rear_axle_ty + s2_334;
  const double s2_336 = fnma(work.s4_27, s2_329, work.s4_32*s2_328);
  const double s2_337 = zd_rear_axle_tz + s2_336;
  const double s2_338 = zd_rear_axle_tx - s2_333;
  const double s2_339 = 1.1757385222540735*s2_330;
  result.Jz[179] = s2_339;
  const double s2_340 = 1.1757385222540735*s2_331;
  result.Jz[180] = s2_340;
  const double s2_341 = 1.1757385222540735*s2_332;
  result.Jz[178] = s2_341;
  const double s2_342 = fma(work.s4_29, s2_333, fma(s2_227, s2_327, s2_226*s2_329));
  const double s2_343 = fma(work.s4_27, s2_336, fnma(s2_225, s2_327, s2_226*s2_328));
  const double s2_344 = fma(s2_327, s2_339, s2_328*s2_340);
  const double s2_345 = fnma(s2_227, s2_328, fma(work.s4_32, s2_334, work.s4_27*s2_333));
  const double s2_346 = fnma(s2_329, s2_339, s2_328*s2_341);
  result.Jz[181] = -s2_346;
  const double s2_347 = fma(s2_327, s2_341, s2_329*s2_340);
  const double s2_348 = fma(s2_331, s2_340, fms(s2_330, s2_339, l_long_rod_right));
  result.Phi[14] = 0.5*fma(s2_332, s2_341, s2_348);
  result.Jz[182] = -fma(R_rear_axle_aux4_x_x, s2_347, R_rear_axle_aux4_y_x*s2_344);
  const double s2_349 = fnma(work.R_rear_axle_aux5_y_x, s2_347, s1_24*s2_346);
  result.Jz[183] = fma(work.R_rear_axle_aux5_x_x, s2_344, s2_349);
  const double s2_350 = fma(s2_338, s2_338, fma(s2_337, s2_337, s2_335*s2_335));
  const double s2_351 = fnma(1.1757385222540735, s2_350, s2_339*fma(work.s4_32, s2_336, s2_342));
  const double s2_352 = fnma(s2_340, fnma(s2_225, s2_329, s2_345), s2_351);
  result.c[14] = fnma(s2_341, fnma(work.s4_29, s2_334, s2_343), s2_352);
  // diag_rod_right
  const double s2_353 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_261);
  const double s2_354 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_263);
  const double s2_355 = fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s2_265);
  const double s2_356 = -p_diag_rod_right_from_z + (work.r_rear_axle_aux3_z + s2_355);
  const double s2_357 = -p_diag_rod_right_from_y + (z_rear_axle_ty + s2_354);
  const double s2_358 = -p_diag_rod_right_from_x + (work.r_rear_axle_aux1_x + s2_353);
  const double s2_359 = fnma(work.s4_29, s2_354, work.s4_27*s2_355);
  const double s2_360 = zd_rear_axle_tx + s2_359;
  const double s2_361 = fnma(work.s4_32, s2_355, work.s4_29*s2_353);
  const double s2_362 = zd_rear_axle_ty + s2_361;
  const double s2_363 = fnma(work.s4_27, s2_353, work.s4_32*s2_354);
  const double s2_364 = zd_rear_axle_tz + s2_363;
  const double s2_365 = 1.162476387438193*s2_356;
  result.Jz[188] = s2_365;
  const double s2_366 = 1.162476387438193*s2_357;
  result.Jz[187] = s2_366;
  const double s2_367 = 1.162476387438193*s2_358;
  result.Jz[186] = s2_367;
  const double s2_368 = fma(work.s4_27, s2_363, fma(s2_225, s2_355, s2_226*s2_354));
  const double s2_369 = fma(work.s4_29, s2_359, fnma(s2_226, s2_353, s2_227*s2_355));
  const double s2_370 = fnma(s2_227, s2_354, fnma(work.s4_27, s2_359, work.s4_32*s2_361));
  const double s2_371 = fnma(s2_353, s2_366, s2_354*s2_367);
  result.Jz[189] = -s2_371;
  const double s2_372 = fnma(s2_355, s2_367, s2_353*s2_365);
  const double s2_373 = fnma(s2_354, s2_365, s2_355*s2_366);
  const double s2_374 = fma(s2_356, s2_365, fms(s2_357, s2_366, l_diag_rod_right));
  result.Phi[15] = 0.5*fma(s2_358, s2_367, s2_374);
  result.Jz[190] = fnma(R_rear_axle_aux4_x_x, s2_372, R_rear_axle_aux4_y_x*s2_373);
  const double s2_375 = fnma(work.R_rear_axle_aux5_y_x, s2_372, s1_24*s2_371);
  result.Jz[191] = fnma(work.R_rear_axle_aux5_x_x, s2_373, s2_375);
  const double s2_376 = fma(s2_364, s2_364, fma(s2_360, s2_360, s2_362*s2_362));
  const double s2_377 = fma(s2_366, fnma(work.s4_32, s2_363, s2_369), 1.162476387438193*s2_376);
  const double s2_378 = fma(s2_365, fnma(s2_225, s2_353, s2_370), s2_377);
  result.c[15] = -fma(s2_367, fnma(work.s4_29, s2_361, s2_368), s2_378);
  // arb_link_rear_right
  const double s2_379 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_292);
  const double s2_380 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_294);
  const double s2_381 = p_arb_link_rear_right_from_x*work.sines[18];
  const double s2_382 = fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_301);
  const double s2_383 = 0.6 + (z_rear_axle_ty - s2_379);
  const double s2_384 = fma(work.s4_32, s2_382, work.s4_29*s2_380);
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s2_385 = zd_arb_rear_right*s2_381;
  const double s2_386 = p_arb_link_rear_right_from_x*work.cosines[18];
  const double s2_387 = zd_arb_rear_right*s2_386;
  const double s2_388 = -p_arb_rear_right_z + (s2_381 + (work.r_rear_axle_aux3_z + s2_382));
  const double s2_389 = zd_rear_axle_ty - s2_384;
  const double s2_390 = 4.47213595499958*s2_383;
  result.Jz[195] = s2_390;
  const double s2_391 = fma(work.s4_27, s2_382, work.s4_29*s2_379);
  const double s2_392 = s2_385 + (zd_rear_axle_tx + s2_391);
  const double s2_393 = fnma(work.s4_32, s2_379, work.s4_27*s2_380);
  const double s2_394 = s2_387 + (zd_rear_axle_tz + s2_393);
  const double s2_395 = 4.47213595499958*s2_388;
  result.Jz[196] = s2_395;
  const double s2_396 = s2_380 + s2_386 - work.r_rear_axle_aux1_x - (-p_arb_rear_right_x);
  const double s2_397 = 4.47213595499958*s2_396;
  result.Jz[194] = -s2_397;
  const double s2_398 = fma(work.s4_29, s2_391, fma(s2_226, s2_380, s2_227*s2_382));
  result.Jz[201] = fnma(s2_381, s2_397, s2_386*s2_395);
  const double s2_399 = fnma(s2_226, s2_379, fma(s2_225, s2_382, zd_arb_rear_right*s2_387));
  const double s2_400 = fma(s2_380, s2_390, s2_379*s2_397);
  result.Jz[197] = -s2_400;
  const double s2_401 = fnma(s2_380, s2_395, s2_382*s2_397);
  const double s2_402 = fma(s2_379, s2_395, s2_382*s2_390);
  const double s2_403 = fnma(s2_227, s2_379, fnma(s2_225, s2_380, zd_arb_rear_right*s2_385));
  const double s2_404 = fma(s2_388, s2_395, fms(s2_383, s2_390, l_arb_link_rear_right));
  result.Phi[16] = 0.5*fma(s2_396, s2_397, s2_404);
  result.Jz[198] = fnma(R_rear_axle_aux4_x_x, s2_401, R_rear_axle_aux4_y_x*s2_402);
  const double s2_405 = fnma(work.R_rear_axle_aux5_y_x, s2_401, s1_24*s2_400);
  result.Jz[199] = fnma(work.R_rear_axle_aux5_x_x, s2_402, s2_405);
  const double s2_406 = s2_395*fma(work.s4_27, s2_391, fma(work.s4_32, s2_384, s2_403));
  const double s2_407 = fma(s2_394, s2_394, fma(s2_392, s2_392, s2_389*s2_389));
  const double s2_408 = fnma(4.47213595499958, s2_407, s2_406);
  const double s2_409 = fma(work.s4_27, s2_393, fma(work.s4_29, s2_384, s2_399));
  const double s2_410 = fnma(s2_390, fnma(work.s4_32, s2_393, s2_398), s2_408);
  result.c[16] = fma(s2_397, s2_409, s2_410);
  // operations: 573 add, 729 multiply
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
      sines[22], cosines[22], R_chassis_aux5_x_x, R_chassis_aux5_y_x, R_chassis_x_y, R_chassis_x_z,
      R_chassis_y_y, R_chassis_y_z, R_chassis_z_y, R_chassis_z_z, R_carrier_left_aux1_y_x,
      R_carrier_left_aux1_z_x, s1_8, r_carrier_left_aux1_y, s1_10, r_carrier_left_aux1_z, s1_12,
      R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y, R_carrier_left_x_x, R_carrier_left_x_z,
      R_carrier_left_y_x, R_carrier_left_y_z, R_carrier_left_z_x, R_carrier_left_z_z,
      R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x, s1_19, r_carrier_right_aux1_y, s1_21,
      s1_22, s1_24, R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, R_carrier_right_x_x,
      R_carrier_right_x_z, R_carrier_right_y_x, R_carrier_right_y_z, R_carrier_right_z_x,
      R_carrier_right_z_z, r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux5_x_x,
      R_rear_axle_aux5_y_x, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z,
      R_rear_axle_z_y, R_rear_axle_z_z, s4_1, w_chassis_x, s4_2, s4_3, w_chassis_y, s4_4, s4_5,
      w_chassis_z, s4_6, s4_7, s4_8, s4_9, s4_10, s4_11, s4_12, s4_13, s4_14, s4_15, s4_16, s4_17,
      s4_18, s4_19, s1_34, s1_36, s1_37, s1_38, s1_39, s1_40, s1_76, s4_25, s4_26, s4_27, s4_28,
      s4_29, s4_30, s4_31, s4_32, s4_33, s4_34, s4_35, s4_36, s4_37, s4_38, s4_39, s4_40, s4_41,
      s4_42, s4_43, w_carrier_left_x, w_carrier_left_y, w_carrier_left_z, w_carrier_right_x,
      w_carrier_right_y, w_carrier_right_z, w_rear_axle_x, w_rear_axle_y, w_rear_axle_z, s7_3, s7_6,
      s7_9, s7_11, s7_13, s7_16, s7_19, s7_21, s7_24, s7_27, s7_30, s7_32, s7_34, s8_14, s8_15,
      s8_16, s3_2, s3_4, s3_5, s3_6, s3_8, s3_10, s6_4, s6_7, s6_10, s7_36, s7_38, s7_39, s7_50,
      s7_57, s7_59, s7_61, s7_63, s7_64, s7_65, s7_66, s7_67, s7_68, s7_69, s7_72, s7_73, s7_74,
      s7_75, s7_77, s7_78, s7_79, s7_80, s7_83, s7_84, s7_85, s7_86, s8_17, s8_18, s8_19, s8_20,
      s8_21, s8_22, s8_25, s8_26, s8_27, s8_28, s8_29, s8_30, s8_31, s8_33, s8_34, s8_35, s8_37,
      s8_39, s8_40, s8_41, s8_43, s8_45, s8_46, s8_47, s8_48, s8_49, s8_51, s8_52, s8_53, s8_54,
      s8_56, s8_57, s8_58, s8_59, s8_61, s8_62, s8_63, s8_64, s8_67, s8_69, s8_70, s8_71, s8_72,
      s8_73, s8_74, s8_82, s8_85, s8_98, s8_120, s8_121, s8_122, s8_127, s8_132, s8_146, s8_164,
      s8_165, s8_166, s8_398, s8_416, s8_420, s8_430, s8_440, s8_450, s8_453, s8_456, s8_459,
      s8_484, s8_541, s8_542, s8_545, s8_546, s8_547, s8_548, s8_549, s8_551, s8_552, s8_561,
      s8_562, s8_573, s8_574, s8_584, s8_585, s8_586, s8_597, s8_600, s8_601, s8_603, s8_604,
      s8_607, s8_608, s8_622, s8_623, s8_639, s8_640, s8_652, s8_653, s8_654, s8_655, s8_656,
      s8_657, s8_658, s8_659, s8_660, s8_661, s8_662, s8_663, s8_664, s8_665, s8_666, s8_667,
      s8_668, s8_669, s8_670, s8_671, s8_672, s8_673, s3_12, s3_14, s3_16, s3_18, s3_20, s3_22,
      s3_25, s3_28, s3_31, s3_34, s3_37, s3_40, s3_43, s3_46, s3_49, s3_52, s3_55, s3_58, s6_11,
      s6_12, s6_13, s6_16, s6_17, s6_36, s6_43, s6_48, s6_53, s7_89, s7_91, s7_96, s7_97, s7_98,
      s7_99, s7_100, s7_103, s7_106, s7_109, s7_124, s7_133, s7_136, s7_139, s7_141, s7_142, s7_143,
      s7_145, s7_147, s7_152, s7_153, s7_154, s7_155, s7_158, s7_160, s7_162, s7_164, s7_169,
      s7_170, s7_171, s7_172, s7_175, s7_177, s7_182, s7_183, s7_184, s7_185, s7_189, s7_192,
      s7_195, s7_210, s7_218, s7_220, s7_222, s7_225, s7_226, s7_229, s7_231, s7_236, s7_237,
      s7_238, s7_239, s7_242, s7_244, s7_246, s7_248, s7_253, s7_254, s7_255, s7_256, s7_258,
      s7_259, s7_262, s7_263, s7_264, s7_265, s7_267, s7_271, s7_273, s7_274, s7_277, s7_278,
      s7_279, s8_700, s8_701, s8_702, s8_703, s8_704, s8_705, s8_706, s8_707, s8_708, s8_709,
      s8_710, s8_711, s8_712, s8_713, s8_714, s8_715, s8_716, s8_717, s8_718, s8_719, s8_720,
      s8_721, s8_722, s8_723, s8_724, s8_725, s8_726, s8_728, s8_729, s8_730, s8_732, s8_733,
      s8_734, s8_735, s8_736, s8_737, s8_738, s8_739, s8_740, s8_741, s8_742, s8_743, s8_744,
      s8_745, s8_746, s8_747, s8_749, s8_750, s8_751, s8_753, s8_754, s8_755, s8_756, s8_757,
      s8_758, s8_759, s8_761, s8_763, s8_764, s8_765, s8_766, s8_767, s8_768, s8_769, s8_770,
      s8_772, s8_773, s8_775, s8_776, s8_777, s8_778, s8_779, s8_780, s8_781, s8_782, s8_783,
      s8_784, s8_786, s8_787, s8_788, s8_789, s8_790, s8_791, s8_794, s8_795, s8_797, s8_798,
      s8_799, s8_800, s8_801, s8_802, s8_803, s8_806, s8_809, s8_810, s8_811, s8_816, s8_819,
      f_carrier_right_x, s8_831, f_carrier_right_y, f_carrier_right_z, n_carrier_right_x,
      n_carrier_right_y, n_carrier_right_z, s8_852, s8_853, s8_854, s8_855, s8_857, s8_859, s8_861,
      s8_863, s8_865, s8_867, s8_868, s8_869, s8_870, s8_873, s8_875, s8_877, s8_880, s8_882,
      s8_884, s8_888, s8_891, s8_894, s8_895, s8_896, s8_897, s8_898, s8_899, s8_900, s8_901,
      s8_903, s8_904, s8_905, s8_906, s8_908, s8_909, s8_910, s8_911, s8_912, s8_913, s8_914,
      s8_915, s8_916, s8_917, s8_918, s8_919, s8_920, s8_921, s8_923, s8_924, s8_925, s8_926,
      s8_927, s8_928, s8_929, s8_930, s8_931, s8_932, s8_933, s8_935, s8_936, s8_938, s8_939,
      s8_940, s8_941, s8_942, s8_943, s8_944, s8_945, s8_946, s8_947, s8_948, s8_953, s8_956,
      f_carrier_left_x, s8_967, f_carrier_left_y, f_carrier_left_z, n_carrier_left_x,
      n_carrier_left_y, n_carrier_left_z, s8_989, s8_990, s8_991, s8_993, s8_995, s8_997, s8_999,
      s8_1001, s8_1003, s8_1005, s8_1006, s8_1007, s8_1008, s8_1009, s8_1010, s8_1013, s8_1015,
      s8_1017, s8_1020, s8_1022, s8_1028, s8_1031, s8_1036, s8_1040, s8_1044, s8_1048, s8_1049,
      s8_1050, s8_1052, s8_1053, s8_1055, s8_1057, s8_1074, s8_1075, s8_1077, s8_1078, s8_1082,
      s8_1083, s8_1084, s8_1085, s8_1089, s8_1091, s8_1095, s8_1097, s8_1108, s8_1114, s8_1122,
      s8_1132, s8_1141, s8_1142, s8_1144, s8_1145, s8_1146, s8_1147, s8_1148, s8_1152, s8_1154,
      s8_1158, s8_1160, s8_1170, s8_1177, s8_1184, s8_1193, s8_1194, s8_1196, s8_1197, s8_1199,
      s8_1200, s8_1201, s8_1202, s8_1203, s8_1204, s8_1205, s8_1206, s8_1211, s8_1224, s8_1230,
      s8_1234, s8_1244, s8_1253, s8_1254, s8_1259, s8_1261, s8_1264, s8_1265, s8_1266, s8_1267,
      s8_1271, s8_1273, s8_1276, s8_1281, s8_1288, s8_1295, s8_1303, s8_1307, s8_1313, s8_1314,
      s8_1316, s8_1317, s8_1318, s8_1319, s8_1321, s8_1323, s8_1342, s8_1346, s8_1348, s8_1368,
      s8_1392, s8_1418, s8_1438, s8_1463, s8_1483, s8_1502, s8_1509, s8_1515, s8_1521, s8_1524,
      s8_1527, s8_1531, s8_1534, s8_1537, s8_1541, s8_1544, s8_1547, s8_1548, s8_1549, s8_1550,
      s8_1551, s8_1575, s8_1577, s8_1586, s8_1592, s8_1600, s8_1603, s8_1604, s8_1606, s8_1616,
      s8_1624, s8_1633, s8_1635, s8_1640, s8_1643, s8_1646, s8_1653, s8_1660, s8_1661, s8_1662;
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
  result.inertia[9] = 10.999999999989;
  result.inertia[10] = 10.999999999989;
  result.inertia[13] = 21.999999999978;
  result.inertia[14] = 21.999999999978;

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
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_x_x = work.cosines[0];
  const double R_chassis_aux5_z_z = work.cosines[1];
  work.R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  const double R_chassis_aux4_y_x = work.sines[0];
  work.R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s1_1 = work.sines[1];
  const double s1_2 = work.sines[2];
  const double s1_3 = s1_1*s1_2;
  const double s1_4 = work.cosines[2];
  work.R_chassis_x_y = fnma(R_chassis_aux4_y_x, s1_4, R_chassis_aux4_x_x*s1_3);
  const double s1_5 = s1_1*s1_4;
  work.R_chassis_x_z = fma(R_chassis_aux4_x_x, s1_5, R_chassis_aux4_y_x*s1_2);
  work.R_chassis_y_y = fma(R_chassis_aux4_y_x, s1_3, R_chassis_aux4_x_x*s1_4);
  work.R_chassis_y_z = fnma(R_chassis_aux4_x_x, s1_2, R_chassis_aux4_y_x*s1_5);
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_2;
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_4;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s1_6 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_6;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = work.sines[3];
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_6;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_7 = -p_carrier_left_rz_z*R_lower_arm_left_z_y;
  work.s1_8 = fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_7);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_8;
  const double s1_9 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_10 = fnma(-p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_9);
  work.r_carrier_left_aux1_z = work.s1_10 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_11 = work.cosines[5];
  work.s1_12 = s1_6*s1_11;
  const double s1_13 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_6*s1_13;
  work.R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_13, R_carrier_left_aux1_y_y*s1_11);
  const double s1_14 = fma(R_carrier_left_aux1_y_y, s1_13, R_lower_arm_left_z_y*s1_11);
  work.R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_y, s1_11, R_lower_arm_left_y_y*s1_13);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_13,
      R_lower_arm_left_y_y*s1_11);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_15 = work.cosines[6];
  const double s1_16 = work.sines[6];
  work.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_16, R_carrier_left_aux1_x_x*s1_15);
  work.R_carrier_left_x_z = fma(R_carrier_left_aux2_x_z, s1_15, R_carrier_left_aux1_x_x*s1_16);
  work.R_carrier_left_y_x = fma(s1_14, s1_16, work.R_carrier_left_aux1_y_x*s1_15);
  work.R_carrier_left_y_z = fnma(s1_14, s1_15, work.R_carrier_left_aux1_y_x*s1_16);
  work.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_16,
      work.R_carrier_left_aux1_z_x*s1_15);
  work.R_carrier_left_z_z = fma(R_carrier_left_aux2_z_z, s1_15, work.R_carrier_left_aux1_z_x*s1_16);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_17 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_17;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[9];
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_17;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_18 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  work.s1_19 = fnma(-p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_18);
  work.r_carrier_right_aux1_y = work.s1_19 - (-p_lower_arm_right_y);
  const double s1_20 = -p_carrier_right_rz_y*R_lower_arm_right_z_y;
  work.s1_21 = fma(-p_carrier_right_rz_z, R_lower_arm_right_y_y, s1_20);
  work.s1_22 = -p_lower_arm_right_z + work.s1_21;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_23 = work.cosines[11];
  work.s1_24 = s1_17*s1_23;
  const double s1_25 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_17*s1_25;
  work.R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_25,
      R_carrier_right_aux1_y_y*s1_23);
  const double s1_26 = fma(R_carrier_right_aux1_y_y, s1_25, R_lower_arm_right_z_y*s1_23);
  work.R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_y, s1_23, R_lower_arm_right_y_y*s1_25);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_25,
      R_lower_arm_right_y_y*s1_23);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_27 = work.cosines[12];
  const double s1_28 = work.sines[12];
  work.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_28, R_carrier_right_aux1_x_x*s1_27);
  work.R_carrier_right_x_z = fma(R_carrier_right_aux2_x_z, s1_27, R_carrier_right_aux1_x_x*s1_28);
  work.R_carrier_right_y_x = fma(s1_26, s1_28, work.R_carrier_right_aux1_y_x*s1_27);
  work.R_carrier_right_y_z = fnma(s1_26, s1_27, work.R_carrier_right_aux1_y_x*s1_28);
  const double s1_29 = work.R_carrier_right_aux1_z_x*s1_27;
  work.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_28, s1_29);
  const double s1_30 = work.R_carrier_right_aux1_z_x*s1_28;
  work.R_carrier_right_z_z = fma(R_carrier_right_aux2_z_z, s1_27, s1_30);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_31 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_31;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_31;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_32 = work.sines[19];
  const double s1_33 = work.cosines[19];
  work.R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_33, R_rear_axle_aux5_x_z*s1_32);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_33, R_rear_axle_aux4_y_x*s1_32);
  work.R_rear_axle_y_y = fma(R_rear_axle_aux5_y_z, s1_32, R_rear_axle_aux4_x_x*s1_33);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_32, R_rear_axle_aux5_y_z*s1_33);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_32;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_33;

  // --- step 4: velocities ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  work.s4_1 = zd_chassis_rz*s1_1;
  work.w_chassis_x = state.zd[Coordinate::chassis_rx] - work.s4_1;
  work.s4_2 = zd_chassis_rz*work.R_chassis_z_y;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.s4_3 = zd_chassis_ry*s1_4;
  work.w_chassis_y = work.s4_2 + work.s4_3;
  work.s4_4 = zd_chassis_rz*work.R_chassis_z_z;
  work.s4_5 = zd_chassis_ry*s1_2;
  work.w_chassis_z = work.s4_4 - work.s4_5;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  work.s4_6 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  work.s4_7 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  work.s4_8 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  work.s4_9 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  work.s4_10 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.s4_11 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.s4_12 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  work.s4_13 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  work.s4_14 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  work.s4_15 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  work.s4_16 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  work.s4_17 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.s4_18 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.s4_19 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double s4_20 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  const double s4_21 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s4_22 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  const double s4_23 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  const double s4_24 = zd_rear_axle_rx*s1_31;

  // --- step 1: poses and axes b, continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  work.s1_34 = fma(s1_4, work.R_chassis_z_z, s1_2*work.R_chassis_z_y);
  const double s1_35 = 1.0/work.s1_34;
  work.s1_36 = s1_2*s1_35;
  work.s1_37 = s1_4*s1_35;
  work.s1_38 = s1_3*s1_35;
  work.s1_39 = s1_5*s1_35;
  work.s1_40 = work.s1_34*s1_35;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_41 = R_lower_arm_left_z_y*work.R_carrier_left_aux1_z_x;
  const double s1_42 = work.R_carrier_left_aux1_z_x*work.s1_12;
  const double s1_43 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s1_42);
  const double s1_44 = work.R_carrier_left_aux1_y_x*work.s1_12;
  const double s1_45 = fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s1_44);
  const double s1_46 = 1.0/fma(R_lower_arm_left_y_y, s1_45, R_lower_arm_left_z_y*s1_43);
  const double s1_47 = R_carrier_left_aux1_z_y*s1_46;
  const double s1_48 = R_carrier_left_aux1_y_y*s1_46;
  const double s1_49 = s1_45*s1_46;
  const double s1_50 = work.R_carrier_left_aux1_y_x*work.R_carrier_left_aux2_z_y;
  const double s1_51 = fnma(work.R_carrier_left_aux1_z_x, work.R_carrier_left_aux2_y_y, s1_50);
  const double s1_52 = s1_46*s1_51;
  const double s1_53 = fma(R_lower_arm_left_y_y, work.R_carrier_left_aux1_y_x, s1_41)*s1_46;
  const double s1_54 = s1_43*s1_46;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_55 = R_lower_arm_right_z_y*work.R_carrier_right_aux1_z_x;
  const double s1_56 = work.R_carrier_right_aux1_z_x*work.s1_24;
  const double s1_57 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s1_56);
  const double s1_58 = work.R_carrier_right_aux1_y_x*work.s1_24;
  const double s1_59 = fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s1_58);
  const double s1_60 = 1.0/fma(R_lower_arm_right_y_y, s1_59, R_lower_arm_right_z_y*s1_57);
  const double s1_61 = R_carrier_right_aux1_z_y*s1_60;
  const double s1_62 = R_carrier_right_aux1_y_y*s1_60;
  const double s1_63 = s1_59*s1_60;
  const double s1_64 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s1_65 = fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y, s1_64);
  const double s1_66 = s1_60*s1_65;
  const double s1_67 = fma(R_lower_arm_right_y_y, work.R_carrier_right_aux1_y_x, s1_55)*s1_60;
  const double s1_68 = s1_57*s1_60;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_69 = R_rear_axle_aux4_y_x*work.R_rear_axle_aux5_y_x;
  const double s1_70 = fma(R_rear_axle_aux4_x_x, work.R_rear_axle_aux5_x_x, s1_69);
  const double s1_71 = 1.0/s1_70;
  const double s1_72 = R_rear_axle_aux4_y_x*s1_71;
  const double s1_73 = R_rear_axle_aux4_x_x*s1_71;
  const double s1_74 = R_rear_axle_aux5_y_z*s1_71;
  const double s1_75 = R_rear_axle_aux5_x_z*s1_71;
  work.s1_76 = s1_70*s1_71;
  // operations: 50 add, 134 multiply, 4 divide, 44 sin cos

  // --- step 4: velocities, continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s4_25 = work.s4_7 + work.s4_10;
  work.s4_26 = work.s4_12 + work.s4_25;
  work.s4_27 = work.s4_9 - work.s4_6;
  work.s4_28 = work.s4_11 + work.s4_27;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s4_29 = work.s4_14 + work.s4_17;
  work.s4_30 = work.s4_19 + work.s4_29;
  work.s4_31 = work.s4_16 - work.s4_13;
  work.s4_32 = work.s4_18 + work.s4_31;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.s4_33 = s4_21 + s4_23;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  work.s4_34 = zd_rear_axle_rz - s4_24;
  work.s4_35 = s4_22 - s4_20;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s4_36 = zd_lower_arm_left + work.s4_8;
  work.s4_37 = fnma(zd_carrier_left_ry, work.s1_12, work.s4_36);
  work.s4_38 = zd_lower_arm_left*work.s1_8;
  work.s4_39 = zd_lower_arm_left*work.s1_10;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s4_40 = zd_lower_arm_right + work.s4_15;
  work.s4_41 = fnma(zd_carrier_right_ry, work.s1_24, work.s4_40);
  work.s4_42 = zd_lower_arm_right*work.s1_19;
  work.s4_43 = zd_lower_arm_right*work.s1_21;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.w_carrier_left_x = work.w_chassis_x + work.s4_37;
  work.w_carrier_left_y = work.w_chassis_y + work.s4_28;
  work.w_carrier_left_z = work.w_chassis_z + work.s4_26;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.w_carrier_right_x = work.w_chassis_x + work.s4_41;
  work.w_carrier_right_y = work.w_chassis_y + work.s4_32;
  work.w_carrier_right_z = work.w_chassis_z + work.s4_30;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.w_rear_axle_x = work.w_chassis_x + work.s4_35;
  work.w_rear_axle_y = work.w_chassis_y + work.s4_33;
  work.w_rear_axle_z = work.w_chassis_z + work.s4_34;
  // operations: 27 add, 30 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  // chassis_aux3: chassis_tz, prismatic, chassis_aux2
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double s7_1 = work.R_chassis_z_y*tau_chassis_tz;
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double s7_2 = fma(work.R_chassis_y_y, tau_chassis_ty, s7_1);
  work.s7_3 = fma(work.R_chassis_x_y, tau_chassis_tx, s7_2);
  const double s7_4 = work.R_chassis_z_z*tau_chassis_tz;
  const double s7_5 = fma(work.R_chassis_x_z, tau_chassis_tx, s7_4);
  work.s7_6 = fma(work.R_chassis_y_z, tau_chassis_ty, s7_5);
  const double s7_7 = work.R_chassis_aux5_y_x*tau_chassis_ty;
  const double s7_8 = fma(work.R_chassis_aux5_x_x, tau_chassis_tx, s7_7);
  work.s7_9 = fnma(s1_1, tau_chassis_tz, s7_8);
  // chassis: chassis_rx, revolute, chassis_aux5
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double s7_10 = fma(s1_4, tau_chassis_ry, tau_chassis_rx*work.s1_38);
  work.s7_11 = fma(tau_chassis_rz, work.s1_36, s7_10);
  const double s7_12 = fma(tau_chassis_rz, work.s1_37, tau_chassis_rx*work.s1_39);
  work.s7_13 = fnma(s1_2, tau_chassis_ry, s7_12);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double s7_14 = tau_carrier_left_ry*s1_47;
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double s7_15 = fma(work.R_carrier_left_aux1_z_x, tau_carrier_left_rx, s7_14);
  work.s7_16 = fma(tau_carrier_left_rz, s1_49, s7_15);
  const double s7_17 = tau_carrier_left_ry*s1_48;
  const double s7_18 = fma(work.R_carrier_left_aux1_y_x, tau_carrier_left_rx, s7_17);
  work.s7_19 = fnma(tau_carrier_left_rz, s1_54, s7_18);
  const double s7_20 = R_carrier_left_aux1_x_x*tau_carrier_left_rx;
  work.s7_21 = fnma(tau_carrier_left_ry, s1_53, fma(tau_carrier_left_rz, s1_52, s7_20));
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double s7_22 = tau_carrier_right_ry*s1_61;
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s7_23 = fma(work.R_carrier_right_aux1_z_x, tau_carrier_right_rx, s7_22);
  work.s7_24 = fma(tau_carrier_right_rz, s1_63, s7_23);
  const double s7_25 = tau_carrier_right_ry*s1_62;
  const double s7_26 = fma(work.R_carrier_right_aux1_y_x, tau_carrier_right_rx, s7_25);
  work.s7_27 = fnma(tau_carrier_right_rz, s1_68, s7_26);
  const double s7_28 = R_carrier_right_aux1_x_x*tau_carrier_right_rx;
  const double s7_29 = fma(tau_carrier_right_rz, s1_66, s7_28);
  work.s7_30 = fnma(tau_carrier_right_ry, s1_67, s7_29);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s7_31 = fma(R_rear_axle_aux4_x_x, tau_rear_axle_ry, tau_rear_axle_rx*s1_72);
  work.s7_32 = fma(tau_rear_axle_rz, s1_74, s7_31);
  const double s7_33 = fma(tau_rear_axle_rz, s1_75, tau_rear_axle_rx*s1_73);
  work.s7_34 = fnma(R_rear_axle_aux4_y_x, tau_rear_axle_ry, s7_33);
  // operations: 26 add, 39 multiply

  // --- step 8: elimination from the leaves to the root (63) ---
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s8_1 = work.R_rear_axle_y_y*work.w_rear_axle_x;
  const double s8_2 = fnma(work.R_rear_axle_x_y, work.w_rear_axle_y, s8_1);
  const double s8_3 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s8_4 = fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s8_3);
  const double s8_5 = fma(work.R_rear_axle_x_y, work.w_rear_axle_x, s8_4);
  const double s8_6 = state.zd[Coordinate::wheel_rear_right] + s8_5;
  const double s8_7 = work.R_rear_axle_x_y*work.w_rear_axle_z;
  const double s8_8 = fnma(work.R_rear_axle_z_y, work.w_rear_axle_x, s8_7);
  const double s8_9 = work.R_rear_axle_z_y*work.w_rear_axle_y;
  const double s8_10 = fnma(work.R_rear_axle_y_y, work.w_rear_axle_z, s8_9);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s8_11 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_12 = s8_6 + (state.zd[Coordinate::wheel_rear_left] + s8_5);
  const double s8_13 = I_wheel_rear_right_polar*s8_12;
  work.s8_14 = fma(s8_2, s8_13, work.R_rear_axle_z_y*s8_11);
  work.s8_15 = fma(s8_8, s8_13, work.R_rear_axle_y_y*s8_11);
  work.s8_16 = fma(s8_10, s8_13, work.R_rear_axle_x_y*s8_11);

  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  const double s3_1 = R_rear_axle_aux4_x_x*projection.Rz[50];
  work.s3_2 = fma(work.R_rear_axle_aux5_y_x, projection.Rz[52], s3_1);
  const double s3_3 = R_rear_axle_aux4_x_x*projection.Rz[51];
  work.s3_4 = fma(work.R_rear_axle_aux5_y_x, projection.Rz[53], s3_3);
  work.s3_5 = fnma(s1_31, projection.Rz[52], projection.Rz[48]);
  work.s3_6 = fnma(s1_31, projection.Rz[53], projection.Rz[49]);
  const double s3_7 = work.R_rear_axle_aux5_x_x*projection.Rz[52];
  work.s3_8 = fnma(R_rear_axle_aux4_y_x, projection.Rz[50], s3_7);
  const double s3_9 = work.R_rear_axle_aux5_x_x*projection.Rz[53];
  work.s3_10 = fnma(R_rear_axle_aux4_y_x, projection.Rz[51], s3_9);
  // operations: 6 add, 10 multiply

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right ---
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s6_1 = zd_arb_rear_left*zd_arb_rear_left;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s6_2 = zd_arb_rear_right*zd_arb_rear_right;
  const double s6_3 = fnma(s1_31, projection.zdd_star[19], projection.zdd_star[17]);
  work.s6_4 = fnma(s4_21, s4_22, fnma(s4_20, s4_23, s6_3));
  const double s6_5 = fnma(s4_20, s4_24, work.R_rear_axle_aux5_y_x*projection.zdd_star[19]);
  const double s6_6 = fma(R_rear_axle_aux4_x_x, projection.zdd_star[18], s6_5);
  work.s6_7 = fma(zd_rear_axle_rz, work.s4_35, s6_6);
  const double s6_8 = work.R_rear_axle_aux5_x_x*projection.zdd_star[19];
  const double s6_9 = fnma(R_rear_axle_aux4_y_x, projection.zdd_star[18], s6_8);
  work.s6_10 = fnma(zd_rear_axle_rz, work.s4_33, fnma(s4_21, s4_24, s6_9));
  // operations: 9 add, 13 multiply

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_35 = h_rear_axle_x*work.R_rear_axle_aux5_y_x;
  work.s7_36 = fma(h_rear_axle_z, work.R_rear_axle_y_z, s7_35);
  const double s7_37 = h_rear_axle_x*work.R_rear_axle_aux5_x_x;
  work.s7_38 = fma(h_rear_axle_z, work.R_rear_axle_x_z, s7_37);
  work.s7_39 = fnma(h_rear_axle_x, s1_31, h_rear_axle_z*work.R_rear_axle_z_z);
  const double s7_40 = K_rear_axle_xx*work.R_rear_axle_aux5_y_x;
  const double s7_41 = fma(K_rear_axle_xz, work.R_rear_axle_y_z, s7_40);
  const double s7_42 = K_rear_axle_xx*work.R_rear_axle_aux5_x_x;
  const double s7_43 = fma(K_rear_axle_xz, work.R_rear_axle_x_z, s7_42);
  const double s7_44 = K_rear_axle_yy*work.R_rear_axle_y_y;
  const double s7_45 = fnma(-K_rear_axle_yz, work.R_rear_axle_y_z, s7_44);
  const double s7_46 = K_rear_axle_xz*work.R_rear_axle_aux5_y_x;
  const double s7_47 = fma(K_rear_axle_zz, work.R_rear_axle_y_z, s7_46);
  const double s7_48 = fnma(-K_rear_axle_yz, work.R_rear_axle_y_y, s7_47);
  const double s7_49 = fma(work.R_rear_axle_z_z, s7_48, work.R_rear_axle_z_y*s7_45);
  work.s7_50 = fnma(s1_31, s7_41, s7_49);
  const double s7_51 = K_rear_axle_yy*work.R_rear_axle_x_y;
  const double s7_52 = fnma(-K_rear_axle_yz, work.R_rear_axle_x_z, s7_51);
  const double s7_53 = K_rear_axle_xz*work.R_rear_axle_aux5_x_x;
  const double s7_54 = fma(K_rear_axle_zz, work.R_rear_axle_x_z, s7_53);
  const double s7_55 = fnma(-K_rear_axle_yz, work.R_rear_axle_x_y, s7_54);
  const double s7_56 = fma(work.R_rear_axle_z_z, s7_55, work.R_rear_axle_z_y*s7_52);
  work.s7_57 = fnma(s1_31, s7_43, s7_56);
  const double s7_58 = fma(work.R_rear_axle_aux5_y_x, s7_43, work.R_rear_axle_y_y*s7_52);
  work.s7_59 = fma(work.R_rear_axle_y_z, s7_55, s7_58);
  const double s7_60 = fma(work.R_rear_axle_aux5_y_x, s7_41, work.R_rear_axle_y_y*s7_45);
  work.s7_61 = fma(work.R_rear_axle_y_z, s7_48, s7_60);
  const double s7_62 = fma(work.R_rear_axle_aux5_x_x, s7_43, work.R_rear_axle_x_y*s7_52);
  work.s7_63 = fma(work.R_rear_axle_x_z, s7_55, s7_62);
  work.s7_64 = K_rear_axle_trace - work.s7_63 - work.s7_61;
  work.s7_65 = work.s7_63 + (work.s7_61 + work.s7_64);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_x = work.cosines[20];
  work.s7_66 = K_arb_rear_left_xy*R_arb_rear_left_x_x;
  work.s7_67 = h_arb_rear_left_x*R_arb_rear_left_x_x;
  const double R_arb_rear_left_x_z = work.sines[20];
  work.s7_68 = K_arb_rear_left_xy*R_arb_rear_left_x_z;
  work.s7_69 = h_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_70 = K_arb_rear_left_zz*R_arb_rear_left_x_z;
  const double s7_71 = K_arb_rear_left_xx*R_arb_rear_left_x_x;
  work.s7_72 = fnma(R_arb_rear_left_x_z, s7_71, R_arb_rear_left_x_x*s7_70);
  work.s7_73 = fma(R_arb_rear_left_x_x, s7_71, R_arb_rear_left_x_z*s7_70);
  work.s7_74 = 0.4224999999999999 - work.s7_73;
  work.s7_75 = work.s7_73 + work.s7_74;
  const double s7_76 = K_arb_rear_left_yy + work.s7_75;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_z = work.sines[21];
  work.s7_77 = -K_arb_rear_right_xy*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = work.cosines[21];
  work.s7_78 = h_arb_rear_right_x*R_arb_rear_right_x_x;
  work.s7_79 = h_arb_rear_right_x*R_arb_rear_right_x_z;
  work.s7_80 = -K_arb_rear_right_xy*R_arb_rear_right_x_x;
  const double s7_81 = K_arb_rear_right_zz*R_arb_rear_right_x_z;
  const double s7_82 = K_arb_rear_right_xx*R_arb_rear_right_x_x;
  work.s7_83 = fnma(R_arb_rear_right_x_z, s7_82, R_arb_rear_right_x_x*s7_81);
  work.s7_84 = fma(R_arb_rear_right_x_x, s7_82, R_arb_rear_right_x_z*s7_81);
  work.s7_85 = 0.4224999999999999 - work.s7_84;
  work.s7_86 = work.s7_84 + work.s7_85;
  const double s7_87 = K_arb_rear_right_yy + work.s7_86;
  // operations: 35 add, 55 multiply

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right
  // ---
  work.s8_17 = work.w_chassis_y + work.w_chassis_y;
  work.s8_18 = work.w_chassis_x + work.w_chassis_x;
  work.s8_19 = work.w_chassis_z + work.w_chassis_z;
  work.s8_20 = work.w_chassis_x*work.w_chassis_y;
  work.s8_21 = work.w_chassis_y*work.w_chassis_z;
  work.s8_22 = work.w_chassis_x*work.w_chassis_z;
  const double s8_23 = work.w_chassis_y*work.w_chassis_y;
  const double s8_24 = work.w_chassis_x*work.w_chassis_x;
  work.s8_25 = s8_23 + s8_24;
  work.s8_26 = fma(work.w_chassis_z, work.w_chassis_z, s8_23);
  work.s8_27 = fma(work.w_chassis_z, work.w_chassis_z, s8_24);
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.s8_28 = projection.Rz[56]*work.s7_79;
  work.s8_29 = projection.Rz[56]*work.s7_78;
  work.s8_30 = projection.Rz[57]*work.s7_79;
  work.s8_31 = projection.Rz[57]*work.s7_78;
  const double s8_32 = s7_87 - K_arb_rear_right_yy;
  work.s8_33 = projection.Rz[56]*s8_32;
  work.s8_34 = projection.Rz[57]*s8_32;
  work.s8_35 = fma(zd_arb_rear_right, work.s8_17, s6_2);
  const double s8_36 = 2.025 + work.s7_79;
  work.s8_37 = zd_arb_rear_right*work.s8_19;
  const double s8_38 = work.s7_78 - 14.85;
  work.s8_39 = fma(work.s7_78, work.s8_35, projection.zdd_star[21]*work.s7_79);
  work.s8_40 = zd_arb_rear_right*work.s8_18;
  work.s8_41 = fnma(work.s7_79, work.s8_37, work.s7_78*work.s8_40);
  const double s8_42 = fnma(-p_arb_rear_right_z, work.s8_22, -p_arb_rear_right_x*work.s8_26);
  work.s8_43 = fnma(-p_arb_rear_right_y, work.s8_20, s8_42);
  const double s8_44 = fnma(-p_arb_rear_right_x, work.s8_22, -p_arb_rear_right_z*work.s8_25);
  work.s8_45 = fnma(-p_arb_rear_right_z, work.s8_21, s8_44);
  work.s8_46 = fnma(projection.zdd_star[21], work.s7_78, work.s7_79*work.s8_35);
  work.s8_47 = work.s8_25 - work.s8_26;
  work.s8_48 = work.s7_85 - work.s7_84;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.s8_49 = work.s7_67 + work.s7_78 - 59.4;
  const double s8_50 = 2.025 + work.s7_69;
  work.s8_51 = projection.Rz[54]*work.s7_69;
  work.s8_52 = projection.Rz[55]*work.s7_69;
  work.s8_53 = fma(zd_arb_rear_left, work.s8_17, s6_1);
  work.s8_54 = 8.1 + (work.s7_69 + work.s7_79);
  const double s8_55 = work.s7_67 - 14.85;
  work.s8_56 = fma(-p_arb_rear_right_y, work.s8_20, s8_42);
  work.s8_57 = zd_arb_rear_left*work.s8_19;
  work.s8_58 = zd_arb_rear_left*work.s8_18;
  work.s8_59 = fnma(work.s7_69, work.s8_57, work.s7_67*work.s8_58);
  const double s8_60 = s7_76 - K_arb_rear_left_yy;
  work.s8_61 = projection.Rz[54]*s8_60;
  work.s8_62 = projection.Rz[55]*s8_60;
  work.s8_63 = fma(-p_arb_rear_right_z, work.s8_21, s8_44);
  work.s8_64 = fnma(projection.zdd_star[20], work.s7_67, work.s7_69*work.s8_53);
  const double s8_65 = s8_36 + s8_50;
  const double s8_66 = fnma(-p_arb_rear_right_y, s8_38, work.s7_72 + work.s7_83);
  work.s8_67 = fma(-p_arb_rear_right_x, s8_65, fnma(p_arb_rear_left_y, s8_55, s8_66));
  const double s8_68 = fma(p_arb_rear_left_y, s8_55, work.s7_66);
  work.s8_69 = fnma(-p_arb_rear_right_y, s8_38, s8_68) - work.s7_80;
  work.s8_70 = fma(p_carrier_left_rz_y, s8_36 - s8_50, work.s7_77 - work.s7_68);
  work.s8_71 = fma(work.s7_67, work.s8_53, projection.zdd_star[20]*work.s7_69);
  work.s8_72 = fma(0.9, s8_65, work.s7_74 + work.s7_85);
  work.s8_73 = s8_38 + s8_55;
}

/// Part 2 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_chosen_accelerations_2(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.s8_74 = fnma(6.6, work.s8_73, work.s7_73 + work.s7_84);
  const double s8_75 = work.s7_74 - work.s7_73;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_76 = fma(zd_rear_axle_tz, work.s8_17, projection.zdd_star[14]);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_77 = fnma(zd_rear_axle_ty, work.s8_19, s8_76);
  const double s8_78 = fma(z_rear_axle_ty, work.s8_20, s8_77);
  const double s8_79 = fma(work.r_rear_axle_aux3_z, work.s8_22, s8_78);
  const double s8_80 = fnma(work.r_rear_axle_aux1_x, work.s8_26, s8_79);
  const double s8_81 = fnma(work.w_chassis_y, work.s4_35, work.w_chassis_x*work.s4_33);
  work.s8_82 = work.s6_4 + s8_81;
  const double s8_83 = fms(work.w_rear_axle_x, work.w_rear_axle_y, work.s8_82);
  const double s8_84 = fnma(work.w_chassis_x, work.s4_34, work.w_chassis_z*work.s4_35);
  work.s8_85 = work.s6_7 + s8_84;
  const double s8_86 = fma(work.w_rear_axle_x, work.w_rear_axle_z, work.s8_85);
  const double s8_87 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s8_88 = work.w_rear_axle_z*work.w_rear_axle_z;
  const double s8_89 = s8_87 + s8_88;
  const double s8_90 = fma(work.s7_39, s8_86, fma(work.s7_36, s8_83, m_rear_axle_2*s8_80));
  const double f_rear_axle_x = fnma(work.s7_38, s8_89, s8_90);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s8_91 = fma(zd_rear_axle_tx, work.s8_19, projection.zdd_star[15]);
  const double s8_92 = fnma(zd_rear_axle_tz, work.s8_18, s8_91);
  const double s8_93 = fma(work.r_rear_axle_aux1_x, work.s8_20, s8_92);
  const double s8_94 = fma(work.r_rear_axle_aux3_z, work.s8_21, s8_93);
  const double s8_95 = fnma(z_rear_axle_ty, work.s8_27, s8_94);
  const double s8_96 = fma(work.w_rear_axle_x, work.w_rear_axle_y, work.s8_82);
  const double s8_97 = fnma(work.w_chassis_z, work.s4_33, work.w_chassis_y*work.s4_34);
  work.s8_98 = work.s6_10 + s8_97;
  const double s8_99 = fms(work.w_rear_axle_y, work.w_rear_axle_z, work.s8_98);
  const double s8_100 = fma(work.w_rear_axle_x, work.w_rear_axle_x, s8_88);
  const double s8_101 = fma(work.s7_39, s8_99, fma(work.s7_38, s8_96, m_rear_axle_2*s8_95));
  const double f_rear_axle_y = fnma(work.s7_36, s8_100, s8_101);
  const double s8_102 = fma(zd_rear_axle_ty, work.s8_18, projection.zdd_star[16]);
  const double s8_103 = fnma(zd_rear_axle_tx, work.s8_17, s8_102);
  const double s8_104 = fma(z_rear_axle_ty, work.s8_21, s8_103);
  const double s8_105 = fma(work.r_rear_axle_aux1_x, work.s8_22, s8_104);
  const double s8_106 = fnma(work.r_rear_axle_aux3_z, work.s8_25, s8_105);
  const double s8_107 = fma(work.w_rear_axle_y, work.w_rear_axle_z, work.s8_98);
  const double s8_108 = fms(work.w_rear_axle_x, work.w_rear_axle_z, work.s8_85);
  const double s8_109 = fma(work.w_rear_axle_x, work.w_rear_axle_x, s8_87);
  const double s8_110 = fma(work.s7_38, s8_108, fma(work.s7_36, s8_107, m_rear_axle_2*s8_106));
  const double f_rear_axle_z = fnma(work.s7_39, s8_109, s8_110);
  const double s8_111 = fnma(work.s7_39, s8_95, fma(work.s7_36, s8_106, work.s8_16));
  const double s8_112 = fma(work.s7_59, s8_108, fma(work.s7_61, s8_107, s8_111));
  const double s8_113 = fnma(work.s7_64, s8_99, fnma(work.s7_57, s8_96, s8_112));
  const double n_rear_axle_x = fma(work.s7_50, s8_100 - s8_109, s8_113);
  const double s8_114 = fnma(work.s7_38, s8_106, fma(work.s7_39, s8_80, work.s8_15));
  const double s8_115 = fma(work.s7_64, s8_86, fma(work.s7_50, s8_83, s8_114));
  const double s8_116 = fnma(work.s7_63, s8_108, fnma(work.s7_59, s8_107, s8_115));
  const double n_rear_axle_y = fma(work.s7_57, s8_109 - s8_89, s8_116);
  const double s8_117 = fnma(work.s7_36, s8_80, fma(work.s7_38, s8_95, work.s8_14));
  const double s8_118 = fma(work.s7_63, s8_96, fma(work.s7_57, s8_99, s8_117));
  const double s8_119 = fnma(work.s7_50, s8_86, fnma(work.s7_61, s8_83, s8_118));
  const double n_rear_axle_z = fma(work.s7_59, s8_89 - s8_100, s8_119);
  work.s8_120 = fma(m_rear_axle_2, z_rear_axle_ty, work.s7_36);
  work.s8_121 = fma(m_rear_axle_2, work.r_rear_axle_aux1_x, work.s7_38);
  work.s8_122 = fma(m_rear_axle_2, work.r_rear_axle_aux3_z, work.s7_39);
  const double s8_123 = fma(work.s3_2, work.s7_39, m_rear_axle_2*projection.Rz[42]);
  const double s8_124 = fnma(work.s3_5, work.s7_36, s8_123);
  const double s8_125 = fma(work.s3_4, work.s7_39, m_rear_axle_2*projection.Rz[43]);
  const double s8_126 = fnma(work.s3_6, work.s7_36, s8_125);
  work.s8_127 = s8_126 - work.s8_30 - work.s8_52;
  const double s8_128 = fma(work.s3_8, work.s7_36, m_rear_axle_2*projection.Rz[46]);
  const double s8_129 = fnma(work.s3_2, work.s7_38, s8_128);
  const double s8_130 = fma(work.s3_10, work.s7_36, m_rear_axle_2*projection.Rz[47]);
  const double s8_131 = fnma(work.s3_4, work.s7_38, s8_130);
  work.s8_132 = fnma(projection.Rz[55], work.s7_67, s8_131 - work.s8_31);
  const double s8_133 = fma(593.0, work.r_rear_axle_aux3_z, work.s7_39);
  const double s8_134 = fma(593.0, z_rear_axle_ty, work.s7_36);
  const double s8_135 = fma(593.0, work.r_rear_axle_aux1_x, work.s7_38);
  const double s8_136 = work.s7_65 - work.s7_63;
  const double s8_137 = fnma(projection.Rz[44], work.s7_39, projection.Rz[46]*work.s7_36);
  const double s8_138 = fnma(work.s3_5, work.s7_57, fma(work.s3_8, s8_136, s8_137));
  const double s8_139 = fnma(work.s3_2, work.s7_59, s8_138);
  const double s8_140 = fma(work.s3_5, work.s7_38, m_rear_axle_2*projection.Rz[44]);
  const double s8_141 = fnma(work.s3_8, work.s7_39, s8_140);
  const double s8_142 = fnma(projection.Rz[45], work.s7_39, projection.Rz[47]*work.s7_36);
  const double s8_143 = fnma(work.s3_6, work.s7_57, fma(work.s3_10, s8_136, s8_142));
  const double s8_144 = fnma(work.s3_4, work.s7_59, s8_143);
  const double s8_145 = fma(work.s3_6, work.s7_38, m_rear_axle_2*projection.Rz[45]);
  work.s8_146 = fnma(work.s3_10, work.s7_39, s8_145);
  const double s8_147 = work.s7_65 - work.s7_64;
  const double s8_148 = fnma(projection.Rz[42], work.s7_36, projection.Rz[44]*work.s7_38);
  const double s8_149 = fnma(work.s3_8, work.s7_57, fma(work.s3_5, s8_147, s8_148));
  const double s8_150 = fnma(work.s3_2, work.s7_50, s8_149);
  const double s8_151 = fnma(projection.Rz[43], work.s7_36, projection.Rz[45]*work.s7_38);
  const double s8_152 = fnma(work.s3_10, work.s7_57, fma(work.s3_6, s8_147, s8_151));
  const double s8_153 = fnma(work.s3_4, work.s7_50, s8_152);
  const double s8_154 = work.s7_65 - work.s7_61;
  const double s8_155 = fnma(projection.Rz[46], work.s7_38, projection.Rz[42]*work.s7_39);
  const double s8_156 = fnma(work.s3_5, work.s7_50, fma(work.s3_2, s8_154, s8_155));
  const double s8_157 = fnma(work.s3_8, work.s7_59, s8_156);
  const double s8_158 = fnma(projection.Rz[47], work.s7_38, projection.Rz[43]*work.s7_39);
  const double s8_159 = fnma(work.s3_6, work.s7_50, fma(work.s3_4, s8_154, s8_158));
  const double s8_160 = fnma(work.s3_10, work.s7_59, s8_159);
  const double s8_161 = work.r_rear_axle_aux3_z + work.r_rear_axle_aux3_z;
  const double s8_162 = z_rear_axle_ty + z_rear_axle_ty;
  const double s8_163 = work.r_rear_axle_aux1_x + work.r_rear_axle_aux1_x;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  work.s8_164 = -p_rear_axle_tx_z*work.s8_21;
  work.s8_165 = -p_rear_axle_tx_z*work.s8_22;
  work.s8_166 = -p_rear_axle_tx_z*work.s8_25;
  // long_rod_left
  const double s1_31 = work.sines[18];
  const double s8_167 = p_long_rod_left_to_x*s1_31;
  const double s8_168 = fma(-p_long_rod_left_to_z, work.R_rear_axle_z_z, s8_167);
  const double s8_169 = fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s8_168);
  const double s8_170 = -p_long_rod_left_from_z + (work.r_rear_axle_aux3_z + s8_169);
  const double s8_171 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s8_172 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_x_z, s8_171);
  const double s8_173 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s8_172);
  const double s8_174 = -p_long_rod_left_from_x + (work.r_rear_axle_aux1_x + s8_173);
  const double s8_175 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s8_176 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_y_z, s8_175);
  const double s8_177 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s8_176);
  const double s8_178 = fnma(work.s4_34, s8_177, work.s4_33*s8_169);
  const double s8_179 = zd_rear_axle_tx + s8_178;
  const double s8_180 = fnma(work.s4_35, s8_169, work.s4_34*s8_173);
  const double s8_181 = zd_rear_axle_ty + s8_180;
  const double s8_182 = fnma(work.s4_33, s8_173, work.s4_35*s8_177);
  const double s8_183 = zd_rear_axle_tz + s8_182;
  const double s8_184 = fnma(work.s3_5, s8_177, fma(work.s3_2, s8_169, projection.Rz[42]));
  const double s8_185 = fnma(work.s3_6, s8_177, fma(work.s3_4, s8_169, projection.Rz[43]));
  const double s8_186 = fnma(work.s3_8, s8_169, fma(work.s3_5, s8_173, projection.Rz[44]));
  const double s8_187 = fnma(work.s3_10, s8_169, fma(work.s3_6, s8_173, projection.Rz[45]));
  const double s8_188 = fnma(work.s3_2, s8_173, fma(work.s3_8, s8_177, projection.Rz[46]));
  const double s8_189 = fnma(work.s3_4, s8_173, fma(work.s3_10, s8_177, projection.Rz[47]));
  const double s8_190 = p_long_rod_left_from_y - z_rear_axle_ty - s8_177;
  const double s8_191 = 3.0*s8_190;
  const double s8_192 = 3.0*s8_174;
  const double s8_193 = 3.0*s8_170;
  const double s8_194 = fms(work.s8_20, s8_190, projection.zdd_star[14]);
  const double s8_195 = fnma(work.s8_22, s8_170, fma(work.s8_26, s8_174, s8_194));
  const double s8_196 = fnma(work.s8_17, s8_183, fma(work.s8_19, s8_181, s8_195));
  const double s8_197 = fma(work.s6_4, s8_177, fnma(work.s6_7, s8_169, s8_196));
  const double s8_198 = 3.0*fma(work.s4_34, s8_180, fnma(work.s4_33, s8_182, s8_197));
  const double s8_199 = fms(work.s8_21, s8_190, projection.zdd_star[16]);
  const double s8_200 = fnma(work.s8_22, s8_174, fma(work.s8_25, s8_170, s8_199));
  const double s8_201 = fnma(work.s8_18, s8_181, fma(work.s8_17, s8_179, s8_200));
  const double s8_202 = fma(work.s6_7, s8_173, fnma(work.s6_10, s8_177, s8_201));
  const double s8_203 = 3.0*fma(work.s4_33, s8_178, fnma(work.s4_35, s8_180, s8_202));
  const double s8_204 = fms(work.s8_18, s8_183, projection.zdd_star[15]);
  const double s8_205 = fnma(work.s6_4, s8_173, fnma(work.s8_19, s8_179, s8_204));
  const double s8_206 = fnma(work.s4_34, s8_178, fma(work.s6_10, s8_169, s8_205));
  const double s8_207 = fnma(work.s8_27, s8_190, fma(work.s4_35, s8_182, s8_206));
  const double s8_208 = 3.0*fnma(work.s8_21, s8_170, fnma(work.s8_20, s8_174, s8_207));
  // diag_rod_left
  const double s8_209 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  const double s8_210 = fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s8_209);
  const double s8_211 = -p_diag_rod_left_from_z + (work.r_rear_axle_aux3_z + s8_210);
  const double s8_212 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  const double s8_213 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s8_212);
  const double s8_214 = -p_diag_rod_left_from_x + (work.r_rear_axle_aux1_x + s8_213);
  const double s8_215 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  const double s8_216 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s8_215);
  const double s8_217 = fnma(work.s4_34, s8_216, work.s4_33*s8_210);
  const double s8_218 = zd_rear_axle_tx + s8_217;
  const double s8_219 = fnma(work.s4_35, s8_210, work.s4_34*s8_213);
  const double s8_220 = zd_rear_axle_ty + s8_219;
  const double s8_221 = fnma(work.s4_33, s8_213, work.s4_35*s8_216);
  const double s8_222 = zd_rear_axle_tz + s8_221;
  const double s8_223 = fnma(work.s3_5, s8_216, fma(work.s3_2, s8_210, projection.Rz[42]));
  const double s8_224 = fnma(work.s3_6, s8_216, fma(work.s3_4, s8_210, projection.Rz[43]));
  const double s8_225 = fnma(work.s3_8, s8_210, fma(work.s3_5, s8_213, projection.Rz[44]));
  const double s8_226 = fnma(work.s3_10, s8_210, fma(work.s3_6, s8_213, projection.Rz[45]));
  const double s8_227 = fnma(work.s3_2, s8_213, fma(work.s3_8, s8_216, projection.Rz[46]));
  const double s8_228 = fnma(work.s3_4, s8_213, fma(work.s3_10, s8_216, projection.Rz[47]));
  const double s8_229 = p_diag_rod_left_from_y - z_rear_axle_ty - s8_216;
  const double s8_230 = 2.6666666666666665*s8_229;
  const double s8_231 = 2.6666666666666665*s8_214;
  const double s8_232 = 2.6666666666666665*s8_211;
  const double s8_233 = fms(work.s8_20, s8_229, projection.zdd_star[14]);
  const double s8_234 = fnma(work.s8_22, s8_211, fma(work.s8_26, s8_214, s8_233));
  const double s8_235 = fnma(work.s8_17, s8_222, fma(work.s8_19, s8_220, s8_234));
  const double s8_236 = fma(work.s6_4, s8_216, fnma(work.s6_7, s8_210, s8_235));
  const double s8_237 = fma(work.s4_34, s8_219, fnma(work.s4_33, s8_221, s8_236));
  const double s8_238 = 2.6666666666666665*s8_237;
  const double s8_239 = fms(work.s8_21, s8_229, projection.zdd_star[16]);
  const double s8_240 = fnma(work.s8_22, s8_214, fma(work.s8_25, s8_211, s8_239));
  const double s8_241 = fnma(work.s8_18, s8_220, fma(work.s8_17, s8_218, s8_240));
  const double s8_242 = fma(work.s6_7, s8_213, fnma(work.s6_10, s8_216, s8_241));
  const double s8_243 = fma(work.s4_33, s8_217, fnma(work.s4_35, s8_219, s8_242));
  const double s8_244 = 2.6666666666666665*s8_243;
  const double s8_245 = fms(work.s8_18, s8_222, projection.zdd_star[15]);
  const double s8_246 = fnma(work.s6_4, s8_213, fnma(work.s8_19, s8_218, s8_245));
  const double s8_247 = fnma(work.s4_34, s8_217, fma(work.s6_10, s8_210, s8_246));
  const double s8_248 = fnma(work.s8_27, s8_229, fma(work.s4_35, s8_221, s8_247));
  const double s8_249 = fnma(work.s8_21, s8_211, fnma(work.s8_20, s8_214, s8_248));
  const double s8_250 = 2.6666666666666665*s8_249;
  // arb_link_rear_left
  const double s8_251 = p_arb_link_rear_left_from_x*work.sines[20];
  const double s8_252 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s8_253 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s8_252);
  const double s8_254 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s8_255 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s8_254);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s8_256 = zd_arb_rear_left*s8_251;
  const double s8_257 = p_arb_link_rear_left_from_x*work.cosines[20];
  const double s8_258 = zd_arb_rear_left*s8_257;
  const double s8_259 = -p_arb_link_rear_left_to_x*s1_31;
  const double s8_260 = fnma(-p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s8_259);
  const double s8_261 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s8_260);
  const double s8_262 = -p_arb_rear_left_z + (s8_251 + (work.r_rear_axle_aux3_z + s8_261));
  const double s8_263 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s8_255);
  const double s8_264 = fnma(work.s4_35, s8_261, work.s4_34*s8_263);
  const double s8_265 = zd_rear_axle_ty + s8_264;
  const double s8_266 = fnma(work.s3_8, s8_261, fma(work.s3_5, s8_263, projection.Rz[44]));
  const double s8_267 = fnma(work.s3_10, s8_261, fma(work.s3_6, s8_263, projection.Rz[45]));
  const double s8_268 = s8_257 - work.r_rear_axle_aux1_x - s8_263 - (-p_arb_rear_left_x);
  const double s8_269 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s8_253);
  const double s8_270 = 0.6 - z_rear_axle_ty - s8_269;
  const double s8_271 = 0.3333333333333333*s8_270;
  const double s8_272 = 0.3333333333333333*s8_268;
  const double s8_273 = fnma(work.s4_34, s8_269, work.s4_33*s8_261);
  const double s8_274 = s8_256 + (zd_rear_axle_tx + s8_273);
  const double s8_275 = fnma(work.s4_33, s8_263, work.s4_35*s8_269);
  const double s8_276 = s8_258 + (zd_rear_axle_tz + s8_275);
  const double s8_277 = fma(projection.Rz[54], s8_251, projection.Rz[42]);
  const double s8_278 = fnma(work.s3_5, s8_269, fma(work.s3_2, s8_261, s8_277));
  const double s8_279 = fma(projection.Rz[54], s8_257, projection.Rz[46]);
  const double s8_280 = fnma(work.s3_2, s8_263, fma(work.s3_8, s8_269, s8_279));
  const double s8_281 = fma(projection.Rz[55], s8_251, projection.Rz[43]);
  const double s8_282 = fnma(work.s3_6, s8_269, fma(work.s3_4, s8_261, s8_281));
  const double s8_283 = fma(projection.Rz[55], s8_257, projection.Rz[47]);
  const double s8_284 = fnma(work.s3_4, s8_263, fma(work.s3_10, s8_269, s8_283));
  const double s8_285 = 0.3333333333333333*s8_262;
  const double s8_286 = fms(work.s8_21, s8_270, projection.zdd_star[16]);
  const double s8_287 = fma(work.s8_25, s8_262, fma(work.s8_22, s8_268, s8_286));
  const double s8_288 = fnma(work.s4_35, s8_264, fma(zd_arb_rear_left, s8_256, s8_287));
  const double s8_289 = fnma(projection.zdd_star[20], s8_257, fma(work.s4_33, s8_273, s8_288));
  const double s8_290 = fma(work.s6_7, s8_263, fnma(work.s6_10, s8_269, s8_289));
  const double s8_291 = fnma(work.s8_18, s8_265, fma(work.s8_17, s8_274, s8_290));
  const double s8_292 = 0.3333333333333333*s8_291;
  const double s8_293 = fms(work.s8_20, s8_270, projection.zdd_star[14]);
  const double s8_294 = fnma(work.s8_26, s8_268, fnma(work.s8_22, s8_262, s8_293));
  const double s8_295 = fnma(work.s8_17, s8_276, fma(work.s8_19, s8_265, s8_294));
  const double s8_296 = fnma(work.s6_7, s8_261, fnma(projection.zdd_star[20], s8_251, s8_295));
  const double s8_297 = fnma(zd_arb_rear_left, s8_258, fma(work.s6_4, s8_269, s8_296));
  const double s8_298 = fma(work.s4_34, s8_264, fnma(work.s4_33, s8_275, s8_297));
  const double s8_299 = 0.3333333333333333*s8_298;
  const double s8_300 = fms(work.s8_20, s8_268, projection.zdd_star[15]);
  const double s8_301 = fnma(work.s8_27, s8_270, fnma(work.s8_21, s8_262, s8_300));
  const double s8_302 = fnma(work.s8_19, s8_274, fma(work.s8_18, s8_276, s8_301));
  const double s8_303 = fma(work.s6_10, s8_261, fnma(work.s6_4, s8_263, s8_302));
  const double s8_304 = fma(work.s4_35, s8_275, fnma(work.s4_34, s8_273, s8_303));
  const double s8_305 = 0.3333333333333333*s8_304;
  // long_rod_right
  const double s8_306 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s8_168);
  const double s8_307 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s8_176);
  const double s8_308 = -p_long_rod_right_from_y + (z_rear_axle_ty + s8_307);
  const double s8_309 = -p_long_rod_right_from_z + (work.r_rear_axle_aux3_z - s8_306);
  const double s8_310 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s8_172);
  const double s8_311 = -p_long_rod_right_from_x + (work.r_rear_axle_aux1_x + s8_310);
  const double s8_312 = fma(work.s4_34, s8_307, work.s4_33*s8_306);
  const double s8_313 = fma(work.s4_34, s8_310, work.s4_35*s8_306);
  const double s8_314 = zd_rear_axle_ty + s8_313;
  const double s8_315 = fnma(work.s4_33, s8_310, work.s4_35*s8_307);
  const double s8_316 = zd_rear_axle_tz + s8_315;
  const double s8_317 = fma(work.s3_5, s8_310, fma(work.s3_8, s8_306, projection.Rz[44]));
  const double s8_318 = fma(work.s3_6, s8_310, fma(work.s3_10, s8_306, projection.Rz[45]));
  const double s8_319 = fnma(work.s3_2, s8_310, fma(work.s3_8, s8_307, projection.Rz[46]));
  const double s8_320 = fnma(work.s3_4, s8_310, fma(work.s3_10, s8_307, projection.Rz[47]));
  const double s8_321 = zd_rear_axle_tx - s8_312;
  const double s8_322 = fnma(work.s3_5, s8_307, fnma(work.s3_2, s8_306, projection.Rz[42]));
  const double s8_323 = fnma(work.s3_6, s8_307, fnma(work.s3_4, s8_306, projection.Rz[43]));
  const double s8_324 = 3.0*s8_308;
  const double s8_325 = 3.0*s8_311;
  const double s8_326 = 3.0*s8_309;
  const double s8_327 = fms(work.s8_27, s8_308, projection.zdd_star[15]);
  const double s8_328 = fnma(work.s8_21, s8_309, fnma(work.s8_20, s8_311, s8_327));
  const double s8_329 = fma(work.s4_35, s8_315, fma(work.s4_34, s8_312, s8_328));
  const double s8_330 = fnma(work.s6_4, s8_310, fnma(work.s6_10, s8_306, s8_329));
  const double s8_331 = 3.0*fnma(work.s8_19, s8_321, fma(work.s8_18, s8_316, s8_330));
  const double s8_332 = fms(work.s8_25, s8_309, projection.zdd_star[16]);
  const double s8_333 = fnma(work.s8_21, s8_308, fnma(work.s8_22, s8_311, s8_332));
  const double s8_334 = fnma(work.s8_18, s8_314, fma(work.s8_17, s8_321, s8_333));
  const double s8_335 = fma(work.s6_7, s8_310, fnma(work.s6_10, s8_307, s8_334));
  const double s8_336 = 3.0*fnma(work.s4_35, s8_313, fnma(work.s4_33, s8_312, s8_335));
  const double s8_337 = fms(work.s8_26, s8_311, projection.zdd_star[14]);
  const double s8_338 = fnma(work.s8_20, s8_308, fnma(work.s8_22, s8_309, s8_337));
  const double s8_339 = fnma(work.s8_17, s8_316, fma(work.s8_19, s8_314, s8_338));
  const double s8_340 = fma(work.s6_4, s8_307, fma(work.s6_7, s8_306, s8_339));
  const double s8_341 = 3.0*fma(work.s4_34, s8_313, fnma(work.s4_33, s8_315, s8_340));
  // diag_rod_right
  const double s8_342 = fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s8_209);
  const double s8_343 = -p_diag_rod_right_from_z + (work.r_rear_axle_aux3_z + s8_342);
  const double s8_344 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s8_215);
  const double s8_345 = -p_diag_rod_right_from_y + (z_rear_axle_ty + s8_344);
  const double s8_346 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s8_212);
  const double s8_347 = -p_diag_rod_right_from_x + (work.r_rear_axle_aux1_x + s8_346);
  const double s8_348 = fnma(work.s4_34, s8_344, work.s4_33*s8_342);
  const double s8_349 = zd_rear_axle_tx + s8_348;
  const double s8_350 = fnma(work.s4_35, s8_342, work.s4_34*s8_346);
  const double s8_351 = zd_rear_axle_ty + s8_350;
  const double s8_352 = fnma(work.s4_33, s8_346, work.s4_35*s8_344);
  const double s8_353 = zd_rear_axle_tz + s8_352;
  const double s8_354 = fnma(work.s3_5, s8_344, fma(work.s3_2, s8_342, projection.Rz[42]));
  const double s8_355 = fnma(work.s3_6, s8_344, fma(work.s3_4, s8_342, projection.Rz[43]));
  const double s8_356 = fnma(work.s3_8, s8_342, fma(work.s3_5, s8_346, projection.Rz[44]));
  const double s8_357 = fnma(work.s3_10, s8_342, fma(work.s3_6, s8_346, projection.Rz[45]));
  const double s8_358 = fnma(work.s3_2, s8_346, fma(work.s3_8, s8_344, projection.Rz[46]));
  const double s8_359 = fnma(work.s3_4, s8_346, fma(work.s3_10, s8_344, projection.Rz[47]));
  const double s8_360 = 2.6666666666666665*s8_345;
  const double s8_361 = 2.6666666666666665*s8_347;
  const double s8_362 = 2.6666666666666665*s8_343;
  const double s8_363 = fms(work.s8_27, s8_345, projection.zdd_star[15]);
  const double s8_364 = fnma(work.s8_21, s8_343, fnma(work.s8_20, s8_347, s8_363));
  const double s8_365 = fnma(work.s8_19, s8_349, fma(work.s8_18, s8_353, s8_364));
  const double s8_366 = fma(work.s6_10, s8_342, fnma(work.s6_4, s8_346, s8_365));
  const double s8_367 = fma(work.s4_35, s8_352, fnma(work.s4_34, s8_348, s8_366));
  const double s8_368 = 2.6666666666666665*s8_367;
  const double s8_369 = fms(work.s8_25, s8_343, projection.zdd_star[16]);
  const double s8_370 = fnma(work.s8_21, s8_345, fnma(work.s8_22, s8_347, s8_369));
  const double s8_371 = fnma(work.s8_18, s8_351, fma(work.s8_17, s8_349, s8_370));
  const double s8_372 = fma(work.s6_7, s8_346, fnma(work.s6_10, s8_344, s8_371));
  const double s8_373 = fma(work.s4_33, s8_348, fnma(work.s4_35, s8_350, s8_372));
  const double s8_374 = 2.6666666666666665*s8_373;
  const double s8_375 = fms(work.s8_26, s8_347, projection.zdd_star[14]);
  const double s8_376 = fnma(work.s8_20, s8_345, fnma(work.s8_22, s8_343, s8_375));
  const double s8_377 = fnma(work.s8_17, s8_353, fma(work.s8_19, s8_351, s8_376));
  const double s8_378 = fma(work.s6_4, s8_344, fnma(work.s6_7, s8_342, s8_377));
  const double s8_379 = fma(work.s4_34, s8_350, fnma(work.s4_33, s8_352, s8_378));
  const double s8_380 = 2.6666666666666665*s8_379;
  // arb_link_rear_right
  const double s8_381 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s8_253);
  const double s8_382 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s8_255);
  const double s8_383 = p_arb_link_rear_right_from_x*work.sines[21];
  const double s8_384 = 0.6 + (z_rear_axle_ty - s8_381);
  const double s8_385 = fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s8_260);
  const double s8_386 = fma(work.s4_35, s8_385, work.s4_34*s8_382);
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s8_387 = zd_arb_rear_right*s8_383;
  const double s8_388 = p_arb_link_rear_right_from_x*work.cosines[21];
  const double s8_389 = zd_arb_rear_right*s8_388;
  const double s8_390 = -p_arb_rear_right_z + (s8_383 + (work.r_rear_axle_aux3_z + s8_385));
  const double s8_391 = zd_rear_axle_ty - s8_386;
  const double s8_392 = fnma(work.s3_8, s8_385, fnma(work.s3_5, s8_382, projection.Rz[44]));
  const double s8_393 = fnma(work.s3_10, s8_385, fnma(work.s3_6, s8_382, projection.Rz[45]));
  const double s8_394 = 0.3333333333333333*s8_384;
  const double s8_395 = fma(z_rear_axle_ty, s8_133, work.s7_50);
  const double s8_396 = fma(s8_170, s8_191, fma(work.r_rear_axle_aux3_z, s8_134, s8_395));
  const double s8_397 = fnma(s8_309, s8_324, fma(s8_262, s8_271, fma(s8_211, s8_230, s8_396)));
  work.s8_398 = fnma(s8_390, s8_394, fnma(s8_343, s8_360, s8_397));
  const double s8_399 = fma(work.s4_33, s8_385, work.s4_34*s8_381);
  const double s8_400 = s8_387 + (zd_rear_axle_tx + s8_399);
  const double s8_401 = fnma(work.s4_35, s8_381, work.s4_33*s8_382);
  const double s8_402 = s8_389 + (zd_rear_axle_tz + s8_401);
  const double s8_403 = fma(projection.Rz[56], s8_383, projection.Rz[42]);
  const double s8_404 = fma(work.s3_2, s8_385, fma(work.s3_5, s8_381, s8_403));
  const double s8_405 = fma(projection.Rz[56], s8_388, projection.Rz[46]);
  const double s8_406 = fnma(work.s3_8, s8_381, fma(work.s3_2, s8_382, s8_405));
  const double s8_407 = fma(projection.Rz[57], s8_383, projection.Rz[43]);
  const double s8_408 = fma(work.s3_4, s8_385, fma(work.s3_6, s8_381, s8_407));
  const double s8_409 = fma(projection.Rz[57], s8_388, projection.Rz[47]);
  const double s8_410 = fnma(work.s3_10, s8_381, fma(work.s3_4, s8_382, s8_409));
  const double s8_411 = s8_382 + s8_388 - work.r_rear_axle_aux1_x - (-p_arb_rear_right_x);
  const double s8_412 = 0.3333333333333333*s8_411;
  const double s8_413 = fma(work.r_rear_axle_aux1_x, s8_133, work.s7_57);
  const double s8_414 = fnma(s8_170, s8_192, fma(work.r_rear_axle_aux3_z, s8_135, s8_413));
  const double s8_415 = fnma(s8_309, s8_325, fma(s8_262, s8_272, fnma(s8_211, s8_231, s8_414)));
  work.s8_416 = fma(s8_390, s8_412, fnma(s8_343, s8_361, s8_415));
  const double s8_417 = fma(z_rear_axle_ty, s8_135, work.s7_59);
  const double s8_418 = fma(s8_190, s8_192, fma(work.r_rear_axle_aux1_x, s8_134, s8_417));
  const double s8_419 = fnma(s8_308, s8_325, fnma(s8_270, s8_272, fma(s8_229, s8_231, s8_418)));
  work.s8_420 = fma(s8_384, s8_412, fnma(s8_345, s8_361, s8_419));
  const double s8_421 = 0.3333333333333333*s8_390;
  const double s8_422 = fma(projection.Rz[57], work.s7_80, s8_144);
  const double s8_423 = fma(z_rear_axle_ty, s8_131, fnma(projection.Rz[55], work.s7_66, s8_422));
  const double s8_424 = fma(s8_187, s8_193, fnma(work.r_rear_axle_aux3_z, work.s8_146, s8_423));
  const double s8_425 = fma(s8_228, s8_230, fma(s8_226, s8_232, fma(s8_189, s8_191, s8_424)));
  const double s8_426 = fma(s8_318, s8_326, fma(s8_271, s8_284, fma(s8_267, s8_285, s8_425)));
  const double s8_427 = fnma(s8_359, s8_360, fma(s8_357, s8_362, fnma(s8_320, s8_324, s8_426)));
  const double s8_428 = fnma(s8_394, s8_410, fma(s8_393, s8_421, s8_427));
  const double s8_429 = fnma(projection.Rz[55], work.s7_67, work.s8_31);
  work.s8_430 = fma(p_carrier_left_rz_y, s8_429, s8_428);
  const double s8_431 = fma(-p_arb_rear_left_z, work.s8_52, s8_153);
  const double s8_432 = fnma(-p_arb_rear_right_z, work.s8_30, s8_431);
  const double s8_433 = fma(projection.Rz[55], work.s7_68, s8_432);
  const double s8_434 = fnma(projection.Rz[57], work.s7_77, s8_433);
  const double s8_435 = fma(work.r_rear_axle_aux1_x, work.s8_146, s8_434);
  const double s8_436 = fnma(s8_187, s8_192, fnma(z_rear_axle_ty, s8_126, s8_435));
  const double s8_437 = fnma(s8_224, s8_230, fnma(s8_226, s8_231, fnma(s8_185, s8_191, s8_436)));
  const double s8_438 = fma(s8_323, s8_324, fnma(s8_271, s8_282, fma(s8_267, s8_272, s8_437)));
  const double s8_439 = fnma(s8_357, s8_361, fma(s8_355, s8_360, fnma(s8_318, s8_325, s8_438)));
  work.s8_440 = fma(s8_393, s8_412, fma(s8_394, s8_408, s8_439));
  const double s8_441 = work.s8_34 + (work.s8_62 + fma(-p_arb_rear_left_z, work.s8_52, s8_160));
  const double s8_442 = fma(-p_arb_rear_right_z, work.s8_30, s8_441);
  const double s8_443 = fma(work.r_rear_axle_aux3_z, s8_126, s8_442);
  const double s8_444 = fma(s8_189, s8_192, fnma(work.r_rear_axle_aux1_x, s8_131, s8_443));
  const double s8_445 = fnma(s8_224, s8_232, fma(s8_228, s8_231, fnma(s8_185, s8_193, s8_444)));
  const double s8_446 = fma(s8_320, s8_325, fnma(s8_272, s8_284, fnma(s8_282, s8_285, s8_445)));
  const double s8_447 = fnma(s8_355, s8_362, fma(s8_359, s8_361, fnma(s8_323, s8_326, s8_446)));
  const double s8_448 = fnma(s8_410, s8_412, fnma(s8_408, s8_421, s8_447));
  const double s8_449 = fma(projection.Rz[55], work.s7_67, work.s8_31);
  work.s8_450 = fnma(-p_arb_rear_right_x, s8_449, s8_448);
  const double s8_451 = fnma(s8_170, s8_193, fma(s8_133, s8_161, work.s7_64));
  const double s8_452 = fnma(s8_309, s8_326, fnma(s8_262, s8_285, fnma(s8_211, s8_232, s8_451)));
  work.s8_453 = fnma(s8_390, s8_421, fnma(s8_343, s8_362, s8_452));
  const double s8_454 = fnma(s8_190, s8_191, fma(s8_134, s8_162, work.s7_61));
  const double s8_455 = fnma(s8_308, s8_324, fnma(s8_270, s8_271, fnma(s8_229, s8_230, s8_454)));
  work.s8_456 = fnma(s8_384, s8_394, fnma(s8_345, s8_360, s8_455));
  const double s8_457 = fnma(s8_174, s8_192, fma(s8_135, s8_163, work.s7_63));
  const double s8_458 = fnma(s8_311, s8_325, fnma(s8_268, s8_272, fnma(s8_214, s8_231, s8_457)));
  work.s8_459 = fnma(s8_411, s8_412, fnma(s8_347, s8_361, s8_458));
  const double s8_460 = fma(s8_188, s8_188, fma(s8_184, s8_184, s8_186*s8_186));
  const double s8_461 = fma(s8_227, s8_227, fma(s8_223, s8_223, s8_225*s8_225));
  const double s8_462 = fma(s8_280, s8_280, fma(s8_278, s8_278, s8_266*s8_266));
  const double s8_463 = fma(projection.Rz[54], work.s8_61, projection.Rz[56]*work.s8_33);
  const double s8_464 = fma(projection.Rz[42], s8_124, fma(projection.Rz[44], s8_141, s8_463));
  const double s8_465 = fma(work.s3_2, s8_157, fma(projection.Rz[46], s8_129, s8_464));
  const double s8_466 = fma(s8_322, s8_322, fma(s8_319, s8_319, fma(s8_317, s8_317, s8_460)));
  const double s8_467 = fma(work.s3_8, s8_139, fma(work.s3_5, s8_150, s8_465));
  const double s8_468 = fma(s8_358, s8_358, fma(s8_354, s8_354, fma(s8_356, s8_356, s8_461)));
  const double s8_469 = fma(s8_406, s8_406, fma(s8_404, s8_404, fma(s8_392, s8_392, s8_462)));
  const double s8_470 = fnma(2.6666666666666665, s8_468, fnma(3.0, s8_466, s8_467));
  const double s8_471 = fnma(0.3333333333333333, s8_469, s8_470);
  const double s8_472 = fma(s8_188, s8_189, fma(s8_184, s8_185, s8_186*s8_187));
  const double s8_473 = fma(s8_227, s8_228, fma(s8_223, s8_224, s8_225*s8_226));
  const double s8_474 = fma(s8_280, s8_284, fma(s8_278, s8_282, s8_266*s8_267));
  const double s8_475 = fma(projection.Rz[54], work.s8_62, projection.Rz[56]*work.s8_34);
  const double s8_476 = fma(projection.Rz[44], work.s8_146, s8_475);
  const double s8_477 = fma(projection.Rz[46], s8_131, fma(projection.Rz[42], s8_126, s8_476));
  const double s8_478 = fma(work.s3_5, s8_153, fma(work.s3_2, s8_160, s8_477));
  const double s8_479 = fma(s8_322, s8_323, fma(s8_319, s8_320, fma(s8_317, s8_318, s8_472)));
  const double s8_480 = fma(s8_358, s8_359, fma(s8_354, s8_355, fma(s8_356, s8_357, s8_473)));
  const double s8_481 = fnma(3.0, s8_479, fma(work.s3_8, s8_144, s8_478));
  const double s8_482 = fma(s8_406, s8_410, fma(s8_404, s8_408, fma(s8_392, s8_393, s8_474)));
  const double s8_483 = fnma(2.6666666666666665, s8_480, s8_481);
  work.s8_484 = fnma(0.3333333333333333, s8_482, s8_483);
  const double s8_485 = fma(s8_189, s8_189, fma(s8_185, s8_185, s8_187*s8_187));
  const double s8_486 = fma(s8_228, s8_228, fma(s8_224, s8_224, s8_226*s8_226));
  const double s8_487 = fma(s8_284, s8_284, fma(s8_282, s8_282, s8_267*s8_267));
  const double s8_488 = fma(projection.Rz[55], work.s8_62, projection.Rz[57]*work.s8_34);
  const double s8_489 = fma(projection.Rz[45], work.s8_146, s8_488);
  const double s8_490 = fma(projection.Rz[47], s8_131, fma(projection.Rz[43], s8_126, s8_489));
  const double s8_491 = fma(work.s3_6, s8_153, fma(work.s3_4, s8_160, s8_490));
  const double s8_492 = fma(s8_323, s8_323, fma(s8_320, s8_320, fma(s8_318, s8_318, s8_485)));
  const double s8_493 = fma(s8_359, s8_359, fma(s8_355, s8_355, fma(s8_357, s8_357, s8_486)));
  const double s8_494 = fnma(3.0, s8_492, fma(work.s3_10, s8_144, s8_491));
  const double s8_495 = fma(s8_410, s8_410, fma(s8_408, s8_408, fma(s8_393, s8_393, s8_487)));
  const double s8_496 = fnma(2.6666666666666665, s8_493, s8_494);
  const double s8_497 = fnma(0.3333333333333333, s8_495, s8_496);
  const double s8_498 = fms(work.s8_27, s8_384, projection.zdd_star[15]);
  const double s8_499 = fnma(work.s8_21, s8_390, fma(work.s8_20, s8_411, s8_498));
  const double s8_500 = fnma(work.s8_19, s8_400, fma(work.s8_18, s8_402, s8_499));
  const double s8_501 = fma(work.s6_10, s8_385, fma(work.s6_4, s8_382, s8_500));
  const double s8_502 = fma(work.s4_35, s8_401, fnma(work.s4_34, s8_399, s8_501));
  const double s8_503 = 0.3333333333333333*s8_502;
  const double s8_504 = fms(work.s8_22, s8_411, projection.zdd_star[16]);
  const double s8_505 = fnma(work.s8_21, s8_384, fma(work.s8_25, s8_390, s8_504));
  const double s8_506 = fma(work.s4_35, s8_386, fma(zd_arb_rear_right, s8_387, s8_505));
  const double s8_507 = fnma(projection.zdd_star[21], s8_388, fma(work.s4_33, s8_399, s8_506));
  const double s8_508 = fma(work.s6_10, s8_381, fnma(work.s6_7, s8_382, s8_507));
  const double s8_509 = fnma(work.s8_18, s8_391, fma(work.s8_17, s8_400, s8_508));
  const double s8_510 = 0.3333333333333333*s8_509;
  const double s8_511 = fms(work.s8_19, s8_391, projection.zdd_star[14]);
  const double s8_512 = fnma(projection.zdd_star[21], s8_383, fnma(work.s8_17, s8_402, s8_511));
  const double s8_513 = fnma(work.s6_7, s8_385, fnma(work.s6_4, s8_381, s8_512));
  const double s8_514 = fnma(work.s4_34, s8_386, fnma(zd_arb_rear_right, s8_389, s8_513));
  const double s8_515 = fnma(work.s8_20, s8_384, fnma(work.s4_33, s8_401, s8_514));
  const double s8_516 = fnma(work.s8_26, s8_411, fnma(work.s8_22, s8_390, s8_515));
  const double s8_517 = 0.3333333333333333*s8_516;
  const double s8_518 = tau[Coordinate::rear_axle_tx] - f_rear_axle_x;
  const double s8_519 = tau[Coordinate::rear_axle_ty] - f_rear_axle_y;
  const double s8_520 = tau[Coordinate::rear_axle_tz] - f_rear_axle_z;
  const double s8_521 = fnma(projection.zdd_star[20], work.s7_75, tau[Coordinate::arb_rear_left]);
  const double s8_522 = fma(work.s7_66, work.s8_21, fma(work.s7_68, work.s8_20, s8_521));
  const double s8_523 = fma(work.s7_67, work.s8_63, fma(work.s7_69, work.s8_56, s8_522));
  const double s8_524 = fnma(work.s8_22, s8_75, fnma(work.s7_72, work.s8_47, s8_523));
  const double s8_525 = fnma(projection.zdd_star[21], work.s7_86, tau[Coordinate::arb_rear_right]);
  const double s8_526 = fnma(work.s7_80, work.s8_21, fnma(work.s7_77, work.s8_20, s8_525));
  const double s8_527 = fma(work.s7_78, work.s8_45, fma(work.s7_79, work.s8_43, s8_526));
  const double s8_528 = fnma(work.s8_22, work.s8_48, fnma(work.s7_83, work.s8_47, s8_527));
  const double s8_529 = work.s7_32 - n_rear_axle_y;
  const double s8_530 = fms(tau[Coordinate::rear_axle_rz], work.s1_76, n_rear_axle_z);
  const double s8_531 = work.s7_34 - n_rear_axle_x;
  const double s8_532 = fnma(s8_185, s8_198, fnma(s8_187, s8_208, projection.Rz[43]*s8_518));
  const double s8_533 = fnma(s8_224, s8_238, fnma(s8_226, s8_250, fnma(s8_189, s8_203, s8_532)));
  const double s8_534 = fnma(s8_282, s8_299, fnma(s8_267, s8_305, fnma(s8_228, s8_244, s8_533)));
  const double s8_535 = fnma(s8_320, s8_336, fnma(s8_318, s8_331, fnma(s8_284, s8_292, s8_534)));
  const double s8_536 = fnma(s8_355, s8_380, fnma(s8_357, s8_368, fnma(s8_323, s8_341, s8_535)));
  const double s8_537 = fnma(s8_408, s8_517, fnma(s8_393, s8_503, fnma(s8_359, s8_374, s8_536)));
  const double s8_538 = fma(projection.Rz[45], s8_519, fnma(s8_410, s8_510, s8_537));
  const double s8_539 = fma(projection.Rz[55], s8_524, fma(projection.Rz[47], s8_520, s8_538));
  const double s8_540 = fma(work.s3_4, s8_529, fma(projection.Rz[57], s8_528, s8_539));
  work.s8_541 = fma(work.s3_10, s8_531, fma(work.s3_6, s8_530, s8_540));
  result.inertia[12] = fnma(1e-12, s8_497, s8_497);
  work.s8_542 = 1.0/s8_497;
  const double s8_543 = work.s8_484*work.s8_542;
  const double s8_544 = fnma(work.s8_484, s8_543, s8_471);
  result.inertia[11] = fnma(1e-12, s8_471, s8_544);
  work.s8_545 = fnma(work.s8_146, s8_543, s8_141);
  work.s8_546 = 1.0/s8_544;
  work.s8_547 = work.s8_545*work.s8_546;
  work.s8_548 = fnma(work.s8_127, s8_543, s8_124 - work.s8_28 - work.s8_51);
  work.s8_549 = work.s8_546*work.s8_548;
  const double s8_550 = fnma(projection.Rz[54], work.s7_67, s8_129 - work.s8_29);
  work.s8_551 = fnma(work.s8_132, s8_543, s8_550);
  work.s8_552 = work.s8_546*work.s8_551;
  const double s8_553 = fma(projection.Rz[56], work.s7_80, s8_139);
  const double s8_554 = fma(z_rear_axle_ty, s8_129, fnma(projection.Rz[54], work.s7_66, s8_553));
  const double s8_555 = fma(s8_186, s8_193, fnma(work.r_rear_axle_aux3_z, s8_141, s8_554));
  const double s8_556 = fma(s8_227, s8_230, fma(s8_225, s8_232, fma(s8_188, s8_191, s8_555)));
  const double s8_557 = fma(s8_317, s8_326, fma(s8_271, s8_280, fma(s8_266, s8_285, s8_556)));
  const double s8_558 = fnma(s8_358, s8_360, fma(s8_356, s8_362, fnma(s8_319, s8_324, s8_557)));
  const double s8_559 = fnma(s8_394, s8_406, fma(s8_392, s8_421, s8_558));
  const double s8_560 = fnma(projection.Rz[54], work.s7_67, work.s8_29);
  work.s8_561 = fma(p_carrier_left_rz_y, s8_560, fnma(work.s8_430, s8_543, s8_559));
  work.s8_562 = work.s8_546*work.s8_561;
  const double s8_563 = fma(-p_arb_rear_left_z, work.s8_51, s8_150);
  const double s8_564 = fnma(-p_arb_rear_right_z, work.s8_28, s8_563);
  const double s8_565 = fma(projection.Rz[54], work.s7_68, s8_564);
  const double s8_566 = fnma(projection.Rz[56], work.s7_77, s8_565);
  const double s8_567 = fma(work.r_rear_axle_aux1_x, s8_141, s8_566);
  const double s8_568 = fnma(s8_186, s8_192, fnma(z_rear_axle_ty, s8_124, s8_567));
  const double s8_569 = fnma(s8_223, s8_230, fnma(s8_225, s8_231, fnma(s8_184, s8_191, s8_568)));
  const double s8_570 = fma(s8_322, s8_324, fnma(s8_271, s8_278, fma(s8_266, s8_272, s8_569)));
  const double s8_571 = fnma(s8_356, s8_361, fma(s8_354, s8_360, fnma(s8_317, s8_325, s8_570)));
  const double s8_572 = fma(s8_392, s8_412, fma(s8_394, s8_404, s8_571));
  work.s8_573 = fnma(work.s8_440, s8_543, s8_572);
  work.s8_574 = work.s8_546*work.s8_573;
  const double s8_575 = work.s8_33 + (work.s8_61 + fma(-p_arb_rear_left_z, work.s8_51, s8_157));
  const double s8_576 = fma(-p_arb_rear_right_z, work.s8_28, s8_575);
  const double s8_577 = fma(work.r_rear_axle_aux3_z, s8_124, s8_576);
  const double s8_578 = fma(s8_188, s8_192, fnma(work.r_rear_axle_aux1_x, s8_129, s8_577));
  const double s8_579 = fnma(s8_223, s8_232, fma(s8_227, s8_231, fnma(s8_184, s8_193, s8_578)));
  const double s8_580 = fma(s8_319, s8_325, fnma(s8_272, s8_280, fnma(s8_278, s8_285, s8_579)));
  const double s8_581 = fnma(s8_354, s8_362, fma(s8_358, s8_361, fnma(s8_322, s8_326, s8_580)));
  const double s8_582 = fnma(s8_406, s8_412, fnma(s8_404, s8_421, s8_581));
  const double s8_583 = fma(projection.Rz[54], work.s7_67, work.s8_29);
  work.s8_584 = fnma(-p_arb_rear_right_x, s8_583, fnma(work.s8_450, s8_543, s8_582));
  work.s8_585 = work.s8_546*work.s8_584;
  work.s8_586 = work.s8_146*work.s8_542;
  const double s8_587 = fnma(s8_184, s8_198, fnma(s8_186, s8_208, projection.Rz[42]*s8_518));
  const double s8_588 = fnma(s8_223, s8_238, fnma(s8_225, s8_250, fnma(s8_188, s8_203, s8_587)));
  const double s8_589 = fnma(s8_278, s8_299, fnma(s8_266, s8_305, fnma(s8_227, s8_244, s8_588)));
  const double s8_590 = fnma(s8_319, s8_336, fnma(s8_317, s8_331, fnma(s8_280, s8_292, s8_589)));
  const double s8_591 = fnma(s8_354, s8_380, fnma(s8_356, s8_368, fnma(s8_322, s8_341, s8_590)));
  const double s8_592 = fnma(s8_404, s8_517, fnma(s8_392, s8_503, fnma(s8_358, s8_374, s8_591)));
  const double s8_593 = fnma(work.s8_541, s8_543, fnma(s8_406, s8_510, s8_592));
  const double s8_594 = fma(projection.Rz[46], s8_520, fma(projection.Rz[44], s8_519, s8_593));
  const double s8_595 = fma(projection.Rz[56], s8_528, fma(projection.Rz[54], s8_524, s8_594));
  const double s8_596 = fma(work.s3_5, s8_530, fma(work.s3_2, s8_529, s8_595));
  work.s8_597 = fma(work.s3_8, s8_531, s8_596);
  const double s8_598 = work.s8_41 + work.s8_59;
  const double s8_599 = fma(work.s8_541, work.s8_586, f_rear_axle_y + s8_598);
  work.s8_600 = fma(work.s8_547, work.s8_597, s8_599);
  work.s8_601 = work.s8_127*work.s8_542;
  const double s8_602 = fma(work.s8_541, work.s8_601, f_rear_axle_x - work.s8_39 - work.s8_71);
  work.s8_603 = fma(work.s8_549, work.s8_597, s8_602);
  work.s8_604 = work.s8_132*work.s8_542;
  const double s8_605 = work.s8_46 + work.s8_64;
  const double s8_606 = fma(work.s8_541, work.s8_604, f_rear_axle_z + s8_605);
  work.s8_607 = fma(work.s8_552, work.s8_597, s8_606);
  work.s8_608 = work.s8_430*work.s8_542;
  const double s8_609 = fma(work.s8_541, work.s8_608, n_rear_axle_x);
  const double s8_610 = fma(projection.zdd_star[21], work.s7_80, s8_609);
  const double s8_611 = fnma(work.s7_83, work.s8_40, fnma(work.s7_77, work.s8_35, s8_610));
  const double s8_612 = fma(work.s7_68, work.s8_53, fnma(work.s7_85, work.s8_37, s8_611));
  const double s8_613 = fnma(projection.zdd_star[20], work.s7_66, s8_612);
  const double s8_614 = fnma(work.s7_74, work.s8_57, fnma(work.s7_72, work.s8_58, s8_613));
  const double s8_615 = fma(z_rear_axle_ty, f_rear_axle_z, s8_614);
  const double s8_616 = fnma(work.r_rear_axle_aux3_z, f_rear_axle_y, s8_615);
  const double s8_617 = fnma(s8_229, s8_244, fnma(s8_170, s8_208, fnma(s8_190, s8_203, s8_616)));
  const double s8_618 = fnma(s8_262, s8_305, fnma(s8_270, s8_292, fnma(s8_211, s8_250, s8_617)));
  const double s8_619 = fma(s8_345, s8_374, fnma(s8_309, s8_331, fma(s8_308, s8_336, s8_618)));
  const double s8_620 = fnma(s8_390, s8_503, fma(s8_384, s8_510, fnma(s8_343, s8_368, s8_619)));
  const double s8_621 = work.s8_41 + (work.s8_59 + work.s8_64) - work.s8_46;
  work.s8_622 = fma(p_carrier_left_rz_y, s8_621, fma(work.s8_562, work.s8_597, s8_620));
  work.s8_623 = work.s8_440*work.s8_542;
  const double s8_624 = fma(-p_arb_rear_left_z, work.s8_71, n_rear_axle_z);
  const double s8_625 = fnma(-p_arb_rear_right_z, work.s8_39, s8_624);
  const double s8_626 = fma(work.s7_84, work.s8_40, fma(work.s8_541, work.s8_623, s8_625));
  const double s8_627 = fma(work.s7_83, work.s8_37, s8_626);
  const double s8_628 = fnma(projection.zdd_star[21], work.s7_77, s8_627);
  const double s8_629 = fnma(work.s7_80, work.s8_35, s8_628);
  const double s8_630 = fma(projection.zdd_star[20], work.s7_68, s8_629);
  const double s8_631 = fma(work.s7_73, work.s8_58, fma(work.s7_66, work.s8_53, s8_630));
  const double s8_632 = fma(work.s7_72, work.s8_57, s8_631);
  const double s8_633 = fma(work.r_rear_axle_aux1_x, f_rear_axle_y, s8_632);
  const double s8_634 = fma(s8_190, s8_198, fnma(z_rear_axle_ty, f_rear_axle_x, s8_633));
  const double s8_635 = fma(s8_214, s8_250, fma(s8_229, s8_238, fma(s8_174, s8_208, s8_634)));
  const double s8_636 = fma(s8_311, s8_331, fnma(s8_268, s8_305, fma(s8_270, s8_299, s8_635)));
  const double s8_637 = fnma(s8_345, s8_380, fma(s8_347, s8_368, fnma(s8_308, s8_341, s8_636)));
  const double s8_638 = fnma(s8_384, s8_517, fnma(s8_411, s8_503, s8_637));
  work.s8_639 = fnma(-p_arb_rear_right_x, s8_598, fma(work.s8_574, work.s8_597, s8_638));
  work.s8_640 = work.s8_450*work.s8_542;
  const double s8_641 = fma(-p_arb_rear_left_z, work.s8_71, n_rear_axle_y);
  const double s8_642 = fma(projection.zdd_star[20], work.s7_75, s8_641);
  const double s8_643 = fma(projection.zdd_star[21], work.s7_86, s8_642);
  const double s8_644 = fma(-p_arb_rear_right_z, work.s8_39, s8_643);
  const double s8_645 = fma(work.s8_541, work.s8_640, s8_644);
  const double s8_646 = fma(work.r_rear_axle_aux3_z, f_rear_axle_x, s8_645);
  const double s8_647 = fnma(work.r_rear_axle_aux1_x, f_rear_axle_z, s8_646);
  const double s8_648 = fma(s8_211, s8_238, fnma(s8_174, s8_203, fma(s8_170, s8_198, s8_647)));
  const double s8_649 = fma(s8_262, s8_299, fma(s8_268, s8_292, fnma(s8_214, s8_244, s8_648)));
  const double s8_650 = fma(s8_343, s8_380, fnma(s8_311, s8_336, fma(s8_309, s8_341, s8_649)));
  const double s8_651 = fma(s8_390, s8_517, fma(s8_411, s8_510, fnma(s8_347, s8_374, s8_650)));
  work.s8_652 = fma(-p_arb_rear_right_x, s8_605, fma(work.s8_585, work.s8_597, s8_651));
}

/// Part 3 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to the root (63); step
/// 3: Rz (61), upper_ball_left .. tie_rod_right; step 6: c and dRz/dt zd (62), upper_ball_left ..
/// tie_rod_right; step 7: inertias of the bodies and forces on joints, upper_ball_left ..
/// tie_rod_right; step 8: elimination from the leaves to the root (63), upper_ball_left ..
/// tie_rod_right.
[[gnu::noinline]] void compute_chosen_accelerations_3(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work) noexcept {
  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  work.s8_653 = fma(work.s8_146, work.s8_586, work.s8_545*work.s8_547);
  work.s8_654 = fma(work.s8_146, work.s8_601, work.s8_545*work.s8_549);
  work.s8_655 = fma(work.s8_127, work.s8_601, work.s8_548*work.s8_549);
  work.s8_656 = fma(work.s8_132, work.s8_586, work.s8_547*work.s8_551);
  work.s8_657 = fma(work.s8_132, work.s8_601, work.s8_549*work.s8_551);
  work.s8_658 = fma(work.s8_132, work.s8_604, work.s8_551*work.s8_552);
  work.s8_659 = fma(work.s8_430, work.s8_586, work.s8_547*work.s8_561);
  work.s8_660 = fma(work.s8_430, work.s8_601, work.s8_549*work.s8_561);
  work.s8_661 = fma(work.s8_430, work.s8_604, work.s8_552*work.s8_561);
  work.s8_662 = fma(work.s8_430, work.s8_608, work.s8_561*work.s8_562);
  work.s8_663 = fma(work.s8_440, work.s8_586, work.s8_547*work.s8_573);
  work.s8_664 = fma(work.s8_440, work.s8_601, work.s8_549*work.s8_573);
  work.s8_665 = fma(work.s8_440, work.s8_604, work.s8_552*work.s8_573);
  work.s8_666 = fma(work.s8_440, work.s8_608, work.s8_562*work.s8_573);
  work.s8_667 = fma(work.s8_440, work.s8_623, work.s8_573*work.s8_574);
  work.s8_668 = fma(work.s8_440, work.s8_640, work.s8_573*work.s8_585);
  work.s8_669 = fma(work.s8_450, work.s8_586, work.s8_547*work.s8_584);
  work.s8_670 = fma(work.s8_450, work.s8_601, work.s8_549*work.s8_584);
  work.s8_671 = fma(work.s8_450, work.s8_604, work.s8_552*work.s8_584);
  work.s8_672 = fma(work.s8_450, work.s8_608, work.s8_562*work.s8_584);
  work.s8_673 = fma(work.s8_450, work.s8_640, work.s8_584*work.s8_585);
  // operations: 943 add, 988 multiply, 2 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s8_674 = work.s1_24*work.w_carrier_right_z;
  const double s8_675 = work.s1_24*work.w_carrier_right_y;
  const double s8_676 = fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_y,
      state.zd[Coordinate::wheel_front_right]);
  const double s8_677 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s8_676);
  const double s8_678 = fnma(work.s1_24, work.w_carrier_right_x, s8_677);
  const double s8_679 = I_wheel_front_right_polar*s8_678;
  const double tau_wheel_front_right = tau[Coordinate::wheel_front_right];
  const double s8_680 = fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_x, s8_675);
  const double s8_681 = fma(s8_680, s8_679, work.R_carrier_right_aux2_z_y*tau_wheel_front_right);
  const double s8_682 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_x, s8_674);
  const double s8_683 = work.R_carrier_right_aux2_y_y*tau_wheel_front_right;
  const double s8_684 = fnma(s8_682, s8_679, s8_683);
  const double s8_685 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_y;
  const double s8_686 = fnma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_z, s8_685);
  const double s8_687 = fnma(work.s1_24, tau_wheel_front_right, s8_679*s8_686);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s8_688 = work.s1_12*work.w_carrier_left_z;
  const double s8_689 = work.s1_12*work.w_carrier_left_y;
  const double s8_690 = fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_y,
      state.zd[Coordinate::wheel_front_left]);
  const double s8_691 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s8_690);
  const double s8_692 = I_wheel_front_left_polar*fnma(work.s1_12, work.w_carrier_left_x, s8_691);
  const double tau_wheel_front_left = tau[Coordinate::wheel_front_left];
  const double s8_693 = fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_x, s8_689);
  const double s8_694 = fma(s8_693, s8_692, work.R_carrier_left_aux2_z_y*tau_wheel_front_left);
  const double s8_695 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_x, s8_688);
  const double s8_696 = fnma(s8_695, s8_692, work.R_carrier_left_aux2_y_y*tau_wheel_front_left);
  const double s8_697 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_y;
  const double s8_698 = s8_692*fnma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_z, s8_697);
  const double s8_699 = fnma(work.s1_12, tau_wheel_front_left, s8_698);

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s3_11 = R_carrier_left_aux1_x_x*projection.Rz[6];
  work.s3_12 = fnma(work.s1_12, projection.Rz[9], s3_11);
  const double s3_13 = R_carrier_left_aux1_x_x*projection.Rz[7];
  work.s3_14 = fnma(work.s1_12, projection.Rz[10], s3_13);
  const double s3_15 = R_carrier_left_aux1_x_x*projection.Rz[8];
  work.s3_16 = fnma(work.s1_12, projection.Rz[11], s3_15);
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s3_17 = R_carrier_right_aux1_x_x*projection.Rz[24];
  work.s3_18 = fnma(work.s1_24, projection.Rz[27], s3_17);
  const double s3_19 = R_carrier_right_aux1_x_x*projection.Rz[25];
  work.s3_20 = fnma(work.s1_24, projection.Rz[28], s3_19);
  const double s3_21 = R_carrier_right_aux1_x_x*projection.Rz[26];
  work.s3_22 = fnma(work.s1_24, projection.Rz[29], s3_21);
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s3_23 = work.R_carrier_left_aux2_z_y*projection.Rz[9];
  const double s3_24 = fma(R_lower_arm_left_y_y, projection.Rz[3], s3_23);
  work.s3_25 = fma(work.R_carrier_left_aux1_z_x, projection.Rz[6], s3_24);
  const double s3_26 = work.R_carrier_left_aux2_z_y*projection.Rz[10];
  const double s3_27 = fma(R_lower_arm_left_y_y, projection.Rz[4], s3_26);
  work.s3_28 = fma(work.R_carrier_left_aux1_z_x, projection.Rz[7], s3_27);
  const double s3_29 = work.R_carrier_left_aux2_z_y*projection.Rz[11];
  const double s3_30 = fma(R_lower_arm_left_y_y, projection.Rz[5], s3_29);
  work.s3_31 = fma(work.R_carrier_left_aux1_z_x, projection.Rz[8], s3_30);
  const double s3_32 = work.R_carrier_left_aux2_y_y*projection.Rz[9];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s3_33 = fma(work.R_carrier_left_aux1_y_x, projection.Rz[6], s3_32);
  work.s3_34 = fnma(R_lower_arm_left_z_y, projection.Rz[3], s3_33);
  const double s3_35 = work.R_carrier_left_aux2_y_y*projection.Rz[10];
  const double s3_36 = fma(work.R_carrier_left_aux1_y_x, projection.Rz[7], s3_35);
  work.s3_37 = fnma(R_lower_arm_left_z_y, projection.Rz[4], s3_36);
  const double s3_38 = work.R_carrier_left_aux2_y_y*projection.Rz[11];
  const double s3_39 = fma(work.R_carrier_left_aux1_y_x, projection.Rz[8], s3_38);
  work.s3_40 = fnma(R_lower_arm_left_z_y, projection.Rz[5], s3_39);
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s3_41 = work.R_carrier_right_aux2_z_y*projection.Rz[27];
  const double s3_42 = fma(R_lower_arm_right_y_y, projection.Rz[21], s3_41);
  work.s3_43 = fma(work.R_carrier_right_aux1_z_x, projection.Rz[24], s3_42);
  const double s3_44 = work.R_carrier_right_aux2_z_y*projection.Rz[28];
  const double s3_45 = fma(R_lower_arm_right_y_y, projection.Rz[22], s3_44);
  work.s3_46 = fma(work.R_carrier_right_aux1_z_x, projection.Rz[25], s3_45);
  const double s3_47 = work.R_carrier_right_aux2_z_y*projection.Rz[29];
  const double s3_48 = fma(R_lower_arm_right_y_y, projection.Rz[23], s3_47);
  work.s3_49 = fma(work.R_carrier_right_aux1_z_x, projection.Rz[26], s3_48);
  const double s3_50 = work.R_carrier_right_aux2_y_y*projection.Rz[27];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s3_51 = fma(work.R_carrier_right_aux1_y_x, projection.Rz[24], s3_50);
  work.s3_52 = fnma(R_lower_arm_right_z_y, projection.Rz[21], s3_51);
  const double s3_53 = work.R_carrier_right_aux2_y_y*projection.Rz[28];
  const double s3_54 = fma(work.R_carrier_right_aux1_y_x, projection.Rz[25], s3_53);
  work.s3_55 = fnma(R_lower_arm_right_z_y, projection.Rz[22], s3_54);
  const double s3_56 = work.R_carrier_right_aux2_y_y*projection.Rz[29];
  const double s3_57 = fma(work.R_carrier_right_aux1_y_x, projection.Rz[26], s3_56);
  work.s3_58 = fnma(R_lower_arm_right_z_y, projection.Rz[23], s3_57);
  // operations: 30 add, 48 multiply

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s6_11 = zd_lower_arm_left*zd_lower_arm_left;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s6_12 = work.s1_8*work.s6_11;
  work.s6_13 = work.s1_10*work.s6_11;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s6_14 = zd_upper_arm_left*zd_upper_arm_left;
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s6_15 = zd_arb_front_left*zd_arb_front_left;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s6_16 = zd_lower_arm_right*zd_lower_arm_right;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s6_17 = work.s1_19*work.s6_16;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s6_18 = zd_upper_arm_right*zd_upper_arm_right;
  // arb_front_right: arb_front_right, revolute, chassis
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s6_19 = zd_arb_front_right*zd_arb_front_right;
  // pitman_arm: pitman_arm, revolute, chassis
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s6_20 = zd_pitman_arm*zd_pitman_arm;
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s6_21 = zd_bell_crank*zd_bell_crank;
  const double s6_22 = fnma(work.s4_11, work.s4_25, work.s4_12*work.s4_27);
  const double s6_23 = fma(R_carrier_left_aux1_x_x, projection.zdd_star[2], s6_22);
  const double s6_24 = fnma(work.s4_7, work.s4_9, fnma(work.s4_6, work.s4_10, s6_23));
  const double s6_25 = fnma(work.s1_12, projection.zdd_star[3], s6_24);
  const double s6_26 = fnma(work.s4_18, work.s4_29, work.s4_19*work.s4_31);
  const double s6_27 = fma(R_carrier_right_aux1_x_x, projection.zdd_star[8], s6_26);
  const double s6_28 = fnma(work.s4_14, work.s4_16, fnma(work.s4_13, work.s4_17, s6_27));
  const double s6_29 = fnma(work.s1_24, projection.zdd_star[9], s6_28);
  const double s6_30 = fma(state.zd[Coordinate::carrier_left_ry], work.s1_12, zd_lower_arm_left);
  const double s6_31 = work.s4_11*work.s4_36;
  const double s6_32 = fma(work.R_carrier_left_aux2_z_y, projection.zdd_star[3], s6_31);
  const double s6_33 = fma(work.s4_6, work.s4_8, s6_32);
  const double s6_34 = fma(work.R_carrier_left_aux1_z_x, projection.zdd_star[2], s6_33);
  const double s6_35 = fma(R_lower_arm_left_y_y, projection.zdd_star[1], s6_34);
  work.s6_36 = fma(work.s4_27, s6_30, s6_35);
  const double s6_37 = fma(state.zd[Coordinate::carrier_right_ry], work.s1_24, zd_lower_arm_right);
  const double s6_38 = work.s4_18*work.s4_40;
  const double s6_39 = fma(work.R_carrier_right_aux2_z_y, projection.zdd_star[9], s6_38);
  const double s6_40 = fma(work.s4_13, work.s4_15, s6_39);
  const double s6_41 = fma(work.R_carrier_right_aux1_z_x, projection.zdd_star[8], s6_40);
  const double s6_42 = fma(R_lower_arm_right_y_y, projection.zdd_star[7], s6_41);
  work.s6_43 = fma(work.s4_31, s6_37, s6_42);
  const double s6_44 = work.R_carrier_left_aux2_y_y*projection.zdd_star[3];
  const double s6_45 = fma(work.s4_7, work.s4_8, s6_44);
  const double s6_46 = fma(work.R_carrier_left_aux1_y_x, projection.zdd_star[2], s6_45);
  const double s6_47 = fnma(R_lower_arm_left_z_y, projection.zdd_star[1], s6_46);
  work.s6_48 = fnma(work.s4_25, s6_30, fnma(work.s4_12, work.s4_36, s6_47));
  const double s6_49 = work.R_carrier_right_aux2_y_y*projection.zdd_star[9];
  const double s6_50 = fma(work.s4_14, work.s4_15, s6_49);
  const double s6_51 = fma(work.R_carrier_right_aux1_y_x, projection.zdd_star[8], s6_50);
  const double s6_52 = fnma(R_lower_arm_right_z_y, projection.zdd_star[7], s6_51);
  work.s6_53 = fnma(work.s4_29, s6_37, fnma(work.s4_19, work.s4_40, s6_52));
  // operations: 32 add, 49 multiply

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_88 = -h_lower_arm_left_z*R_lower_arm_left_z_y;
  work.s7_89 = fma(h_lower_arm_left_y, R_lower_arm_left_y_y, s7_88);
  const double s7_90 = h_lower_arm_left_y*R_lower_arm_left_z_y;
  work.s7_91 = fnma(-h_lower_arm_left_z, R_lower_arm_left_y_y, s7_90);
  const double s7_92 = K_lower_arm_left_zz*R_lower_arm_left_z_y;
  const double s7_93 = fma(-K_lower_arm_left_yz, R_lower_arm_left_y_y, s7_92);
  const double s7_94 = -K_lower_arm_left_yz*R_lower_arm_left_z_y;
  const double s7_95 = fma(K_lower_arm_left_yy, R_lower_arm_left_y_y, s7_94);
  work.s7_96 = fnma(R_lower_arm_left_y_y, s7_93, R_lower_arm_left_z_y*s7_95);
  work.s7_97 = fma(R_lower_arm_left_y_y, s7_95, R_lower_arm_left_z_y*s7_93);
  work.s7_98 = 1.825625 - work.s7_97;
  work.s7_99 = work.s7_97 + work.s7_98;
  work.s7_100 = K_lower_arm_left_xx + work.s7_99;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_101 = h_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_102 = fma(h_carrier_left_z, work.R_carrier_left_z_z, s7_101);
  work.s7_103 = fnma(-h_carrier_left_x, work.R_carrier_left_z_x, s7_102);
  const double s7_104 = h_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_105 = fma(h_carrier_left_z, work.R_carrier_left_y_z, s7_104);
  work.s7_106 = fnma(-h_carrier_left_x, work.R_carrier_left_y_x, s7_105);
  const double s7_107 = h_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_108 = fnma(-h_carrier_left_x, work.R_carrier_left_x_x, s7_107);
  work.s7_109 = fnma(h_carrier_left_y, work.s1_12, s7_108);
  const double s7_110 = K_carrier_left_yz*work.R_carrier_left_x_z;
  const double s7_111 = fma(K_carrier_left_xy, work.R_carrier_left_x_x, s7_110);
  const double s7_112 = fnma(K_carrier_left_yy, work.s1_12, s7_111);
  const double s7_113 = K_carrier_left_yy*work.R_carrier_left_aux2_y_y;
  const double s7_114 = fma(K_carrier_left_xy, work.R_carrier_left_y_x, s7_113);
  const double s7_115 = fma(K_carrier_left_yz, work.R_carrier_left_y_z, s7_114);
  const double s7_116 = K_carrier_left_yz*work.R_carrier_left_aux2_y_y;
  const double s7_117 = fma(K_carrier_left_zz, work.R_carrier_left_y_z, s7_116);
  const double s7_118 = fnma(-K_carrier_left_xz, work.R_carrier_left_y_x, s7_117);
  const double s7_119 = K_carrier_left_xy*work.R_carrier_left_aux2_y_y;
  const double s7_120 = fma(K_carrier_left_xx, work.R_carrier_left_y_x, s7_119);
  const double s7_121 = fnma(-K_carrier_left_xz, work.R_carrier_left_y_z, s7_120);
  const double s7_122 = work.R_carrier_left_aux2_z_y*s7_115;
  const double s7_123 = fma(work.R_carrier_left_z_z, s7_118, s7_122);
  work.s7_124 = fma(work.R_carrier_left_z_x, s7_121, s7_123);
  const double s7_125 = K_carrier_left_zz*work.R_carrier_left_x_z;
  const double s7_126 = fnma(-K_carrier_left_xz, work.R_carrier_left_x_x, s7_125);
  const double s7_127 = fnma(K_carrier_left_yz, work.s1_12, s7_126);
  const double s7_128 = K_carrier_left_xx*work.R_carrier_left_x_x;
  const double s7_129 = fnma(-K_carrier_left_xz, work.R_carrier_left_x_z, s7_128);
  const double s7_130 = fnma(K_carrier_left_xy, work.s1_12, s7_129);
  const double s7_131 = work.R_carrier_left_aux2_z_y*s7_112;
  const double s7_132 = fma(work.R_carrier_left_z_z, s7_127, s7_131);
  work.s7_133 = fma(work.R_carrier_left_z_x, s7_130, s7_132);
  const double s7_134 = work.R_carrier_left_aux2_y_y*s7_112;
  const double s7_135 = fma(work.R_carrier_left_y_x, s7_130, s7_134);
  work.s7_136 = fma(work.R_carrier_left_y_z, s7_127, s7_135);
  const double s7_137 = work.R_carrier_left_aux2_y_y*s7_115;
  const double s7_138 = fma(work.R_carrier_left_y_x, s7_121, s7_137);
  work.s7_139 = fma(work.R_carrier_left_y_z, s7_118, s7_138);
  const double s7_140 = fma(work.R_carrier_left_x_x, s7_130, work.R_carrier_left_x_z*s7_127);
  work.s7_141 = fnma(work.s1_12, s7_112, s7_140);
  work.s7_142 = K_carrier_left_trace - work.s7_141 - work.s7_139;
  work.s7_143 = work.s7_141 + (work.s7_139 + work.s7_142);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_144 = -h_upper_arm_left_z*R_upper_arm_left_z_y;
  work.s7_145 = fma(h_upper_arm_left_y, R_upper_arm_left_y_y, s7_144);
  const double s7_146 = h_upper_arm_left_y*R_upper_arm_left_z_y;
  work.s7_147 = fnma(-h_upper_arm_left_z, R_upper_arm_left_y_y, s7_146);
  const double s7_148 = K_upper_arm_left_zz*R_upper_arm_left_z_y;
  const double s7_149 = fma(-K_upper_arm_left_yz, R_upper_arm_left_y_y, s7_148);
  const double s7_150 = -K_upper_arm_left_yz*R_upper_arm_left_z_y;
  const double s7_151 = fma(K_upper_arm_left_yy, R_upper_arm_left_y_y, s7_150);
  work.s7_152 = fnma(R_upper_arm_left_y_y, s7_149, R_upper_arm_left_z_y*s7_151);
  work.s7_153 = fma(R_upper_arm_left_y_y, s7_151, R_upper_arm_left_z_y*s7_149);
  work.s7_154 = 0.539 - work.s7_153;
  work.s7_155 = work.s7_153 + work.s7_154;
  const double s7_156 = K_upper_arm_left_xx + work.s7_155;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_157 = -K_arb_front_left_xy*R_arb_front_left_x_z;
  work.s7_158 = fma(K_arb_front_left_yz, R_arb_front_left_x_x, s7_157);
  const double s7_159 = -h_arb_front_left_x*R_arb_front_left_x_z;
  work.s7_160 = fma(h_arb_front_left_z, R_arb_front_left_x_x, s7_159);
  const double s7_161 = K_arb_front_left_yz*R_arb_front_left_x_z;
  work.s7_162 = fnma(-K_arb_front_left_xy, R_arb_front_left_x_x, s7_161);
  const double s7_163 = h_arb_front_left_z*R_arb_front_left_x_z;
  work.s7_164 = fnma(-h_arb_front_left_x, R_arb_front_left_x_x, s7_163);
  const double s7_165 = K_arb_front_left_zz*R_arb_front_left_x_z;
  const double s7_166 = fnma(-K_arb_front_left_xz, R_arb_front_left_x_x, s7_165);
  const double s7_167 = K_arb_front_left_xx*R_arb_front_left_x_x;
  const double s7_168 = fnma(-K_arb_front_left_xz, R_arb_front_left_x_z, s7_167);
  work.s7_169 = fnma(R_arb_front_left_x_z, s7_168, R_arb_front_left_x_x*s7_166);
  work.s7_170 = fma(R_arb_front_left_x_x, s7_168, R_arb_front_left_x_z*s7_166);
  work.s7_171 = 0.3477 - work.s7_170;
  work.s7_172 = work.s7_170 + work.s7_171;
  const double s7_173 = K_arb_front_left_yy + work.s7_172;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_174 = -h_lower_arm_right_z*R_lower_arm_right_z_y;
  work.s7_175 = fnma(-h_lower_arm_right_y, R_lower_arm_right_y_y, s7_174);
  const double s7_176 = -h_lower_arm_right_y*R_lower_arm_right_z_y;
  work.s7_177 = fma(-h_lower_arm_right_z, R_lower_arm_right_y_y, s7_176);
  const double s7_178 = K_lower_arm_right_yy*R_lower_arm_right_y_y;
  const double s7_179 = fnma(K_lower_arm_right_yz, R_lower_arm_right_z_y, s7_178);
  const double s7_180 = K_lower_arm_right_yz*R_lower_arm_right_y_y;
  const double s7_181 = fnma(K_lower_arm_right_zz, R_lower_arm_right_z_y, s7_180);
  work.s7_182 = fma(R_lower_arm_right_y_y, s7_181, R_lower_arm_right_z_y*s7_179);
  work.s7_183 = fnma(R_lower_arm_right_z_y, s7_181, R_lower_arm_right_y_y*s7_179);
  work.s7_184 = 1.825625 - work.s7_183;
  work.s7_185 = work.s7_183 + work.s7_184;
  const double s7_186 = K_lower_arm_right_xx + work.s7_185;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_187 = -h_carrier_right_y*work.s1_24;
  const double s7_188 = fma(h_carrier_right_z, work.R_carrier_right_x_z, s7_187);
  work.s7_189 = fnma(-h_carrier_right_x, work.R_carrier_right_x_x, s7_188);
  const double s7_190 = h_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_191 = fnma(-h_carrier_right_x, work.R_carrier_right_z_x, s7_190);
  work.s7_192 = fnma(-h_carrier_right_y, work.R_carrier_right_aux2_z_y, s7_191);
  const double s7_193 = h_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_194 = fnma(-h_carrier_right_x, work.R_carrier_right_y_x, s7_193);
  work.s7_195 = fnma(-h_carrier_right_y, work.R_carrier_right_aux2_y_y, s7_194);
  const double s7_196 = K_carrier_right_yy*work.s1_24;
  const double s7_197 = fma(-K_carrier_right_yz, work.R_carrier_right_x_z, s7_196);
  const double s7_198 = fma(-K_carrier_right_xy, work.R_carrier_right_x_x, s7_197);
  const double s7_199 = K_carrier_right_yy*work.R_carrier_right_aux2_y_y;
  const double s7_200 = fnma(-K_carrier_right_xy, work.R_carrier_right_y_x, s7_199);
  const double s7_201 = fnma(-K_carrier_right_yz, work.R_carrier_right_y_z, s7_200);
  const double s7_202 = K_carrier_right_zz*work.R_carrier_right_y_z;
  const double s7_203 = fnma(-K_carrier_right_xz, work.R_carrier_right_y_x, s7_202);
  const double s7_204 = fnma(-K_carrier_right_yz, work.R_carrier_right_aux2_y_y, s7_203);
  const double s7_205 = K_carrier_right_xx*work.R_carrier_right_y_x;
  const double s7_206 = fnma(-K_carrier_right_xz, work.R_carrier_right_y_z, s7_205);
  const double s7_207 = fnma(-K_carrier_right_xy, work.R_carrier_right_aux2_y_y, s7_206);
  const double s7_208 = work.R_carrier_right_aux2_z_y*s7_201;
  const double s7_209 = fma(work.R_carrier_right_z_z, s7_204, s7_208);
  work.s7_210 = fma(work.R_carrier_right_z_x, s7_207, s7_209);
  const double s7_211 = -K_carrier_right_yz*work.s1_24;
  const double s7_212 = fma(K_carrier_right_zz, work.R_carrier_right_x_z, s7_211);
  const double s7_213 = fnma(-K_carrier_right_xz, work.R_carrier_right_x_x, s7_212);
  const double s7_214 = -K_carrier_right_xy*work.s1_24;
  const double s7_215 = fma(K_carrier_right_xx, work.R_carrier_right_x_x, s7_214);
  const double s7_216 = fnma(-K_carrier_right_xz, work.R_carrier_right_x_z, s7_215);
  const double s7_217 = fma(work.R_carrier_right_z_x, s7_216, work.R_carrier_right_z_z*s7_213);
  work.s7_218 = fnma(work.R_carrier_right_aux2_z_y, s7_198, s7_217);
  const double s7_219 = fma(work.R_carrier_right_y_z, s7_213, work.R_carrier_right_y_x*s7_216);
  work.s7_220 = fnma(work.R_carrier_right_aux2_y_y, s7_198, s7_219);
  const double s7_221 = fma(work.R_carrier_right_x_z, s7_213, work.s1_24*s7_198);
  work.s7_222 = fma(work.R_carrier_right_x_x, s7_216, s7_221);
  const double s7_223 = work.R_carrier_right_aux2_y_y*s7_201;
  const double s7_224 = fma(work.R_carrier_right_y_x, s7_207, s7_223);
  work.s7_225 = fma(work.R_carrier_right_y_z, s7_204, s7_224);
  work.s7_226 = K_carrier_right_trace - work.s7_222 - work.s7_225;
  const double s7_227 = work.s7_225 + (work.s7_222 + work.s7_226);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_228 = -h_upper_arm_right_z*R_upper_arm_right_z_y;
  work.s7_229 = fnma(-h_upper_arm_right_y, R_upper_arm_right_y_y, s7_228);
  const double s7_230 = -h_upper_arm_right_y*R_upper_arm_right_z_y;
  work.s7_231 = fma(-h_upper_arm_right_z, R_upper_arm_right_y_y, s7_230);
  const double s7_232 = K_upper_arm_right_yy*R_upper_arm_right_y_y;
  const double s7_233 = fnma(K_upper_arm_right_yz, R_upper_arm_right_z_y, s7_232);
  const double s7_234 = K_upper_arm_right_yz*R_upper_arm_right_y_y;
  const double s7_235 = fnma(K_upper_arm_right_zz, R_upper_arm_right_z_y, s7_234);
  work.s7_236 = fma(R_upper_arm_right_y_y, s7_235, R_upper_arm_right_z_y*s7_233);
  work.s7_237 = fnma(R_upper_arm_right_z_y, s7_235, R_upper_arm_right_y_y*s7_233);
  work.s7_238 = 0.539 - work.s7_237;
  work.s7_239 = work.s7_237 + work.s7_238;
  const double s7_240 = K_upper_arm_right_xx + work.s7_239;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_241 = -h_arb_front_right_x*R_arb_front_right_x_z;
  work.s7_242 = fma(h_arb_front_right_z, R_arb_front_right_x_x, s7_241);
  const double s7_243 = h_arb_front_right_z*R_arb_front_right_x_z;
  work.s7_244 = fnma(-h_arb_front_right_x, R_arb_front_right_x_x, s7_243);
  const double s7_245 = K_arb_front_right_xy*R_arb_front_right_x_x;
  work.s7_246 = fnma(-K_arb_front_right_yz, R_arb_front_right_x_z, s7_245);
  const double s7_247 = K_arb_front_right_xy*R_arb_front_right_x_z;
  work.s7_248 = fma(-K_arb_front_right_yz, R_arb_front_right_x_x, s7_247);
  const double s7_249 = K_arb_front_right_zz*R_arb_front_right_x_z;
  const double s7_250 = fnma(-K_arb_front_right_xz, R_arb_front_right_x_x, s7_249);
  const double s7_251 = K_arb_front_right_xx*R_arb_front_right_x_x;
  const double s7_252 = fnma(-K_arb_front_right_xz, R_arb_front_right_x_z, s7_251);
  work.s7_253 = fnma(R_arb_front_right_x_z, s7_252, R_arb_front_right_x_x*s7_250);
  work.s7_254 = fma(R_arb_front_right_x_x, s7_252, R_arb_front_right_x_z*s7_250);
  work.s7_255 = 0.3477 - work.s7_254;
  work.s7_256 = work.s7_254 + work.s7_255;
  const double s7_257 = K_arb_front_right_yy + work.s7_256;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  work.s7_258 = -h_pitman_arm_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s7_259 = -h_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_260 = K_pitman_arm_zz*R_pitman_arm_x_z;
  const double s7_261 = K_pitman_arm_xx*R_pitman_arm_x_x;
  work.s7_262 = fnma(R_pitman_arm_x_z, s7_261, R_pitman_arm_x_x*s7_260);
  work.s7_263 = fma(R_pitman_arm_x_x, s7_261, R_pitman_arm_x_z*s7_260);
  work.s7_264 = 0.3504 - work.s7_263;
  work.s7_265 = work.s7_263 + work.s7_264;
  const double s7_266 = K_pitman_arm_yy + work.s7_265;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_x_x = work.cosines[16];
  const double R_bell_crank_y_x = work.sines[16];
  work.s7_267 = fnma(-h_bell_crank_x, R_bell_crank_y_x, h_bell_crank_y*R_bell_crank_x_x);
  const double s7_268 = -K_bell_crank_xy*R_bell_crank_y_x;
  const double s7_269 = -K_bell_crank_xy*R_bell_crank_x_x;
  const double s7_270 = fma(K_bell_crank_yy, R_bell_crank_y_x, s7_269);
  work.s7_271 = fma(-h_bell_crank_x, R_bell_crank_x_x, h_bell_crank_y*R_bell_crank_y_x);
  const double s7_272 = fma(K_bell_crank_xx, R_bell_crank_x_x, s7_268);
  work.s7_273 = fnma(R_bell_crank_x_x, s7_270, R_bell_crank_y_x*s7_272);
  work.s7_274 = fma(R_bell_crank_x_x, s7_272, R_bell_crank_y_x*s7_270);
  const double s7_275 = R_bell_crank_y_x*fms(K_bell_crank_xx, R_bell_crank_y_x, s7_269);
  const double s7_276 = fms(K_bell_crank_yy, R_bell_crank_x_x, s7_268);
  work.s7_277 = fma(R_bell_crank_x_x, s7_276, s7_275);
  work.s7_278 = K_bell_crank_trace - work.s7_274 - work.s7_277;
  work.s7_279 = work.s7_274 + work.s7_277;
  const double s7_280 = work.s7_278 + work.s7_279;
  // operations: 140 add, 188 multiply

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_700 = projection.Rz[0] + work.s3_12;
  work.s8_701 = work.s1_8*projection.Rz[0];
  work.s8_702 = work.s1_10*projection.Rz[0];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_703 = projection.Rz[18] + work.s3_18;
  work.s8_704 = work.s1_19*projection.Rz[18];
  work.s8_705 = work.s1_21*projection.Rz[18];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_706 = projection.Rz[1] + work.s3_14;
  work.s8_707 = work.s1_8*projection.Rz[1];
  work.s8_708 = work.s1_10*projection.Rz[1];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_709 = projection.Rz[19] + work.s3_20;
  work.s8_710 = work.s1_19*projection.Rz[19];
  work.s8_711 = work.s1_21*projection.Rz[19];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_712 = projection.Rz[2] + work.s3_16;
  work.s8_713 = work.s1_8*projection.Rz[2];
  work.s8_714 = work.s1_10*projection.Rz[2];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_715 = projection.Rz[20] + work.s3_22;
  work.s8_716 = work.s1_19*projection.Rz[20];
  work.s8_717 = work.s1_21*projection.Rz[20];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_718 = projection.zdd_star[0] + s6_25;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_719 = projection.zdd_star[6] + s6_29;
  work.s8_720 = work.s1_19*projection.zdd_star[6];
  // bell_crank: bell_crank, revolute, chassis
  work.s8_721 = projection.Rz[39]*work.s7_267;
  work.s8_722 = projection.Rz[40]*work.s7_267;
  work.s8_723 = projection.Rz[41]*work.s7_267;
  work.s8_724 = projection.Rz[39]*work.s7_271;
  work.s8_725 = projection.Rz[40]*work.s7_271;
  work.s8_726 = projection.Rz[41]*work.s7_271;
  const double s8_727 = s7_280 - work.s7_278;
  work.s8_728 = projection.Rz[39]*s8_727;
  work.s8_729 = projection.Rz[40]*s8_727;
  work.s8_730 = projection.Rz[41]*s8_727;
  const double s8_731 = fma(zd_bell_crank, work.s8_19, s6_21);
  work.s8_732 = fma(p_bell_crank_x, work.s8_26, -p_bell_crank_z*work.s8_22);
  work.s8_733 = zd_bell_crank*work.s8_18;
  work.s8_734 = zd_bell_crank*work.s8_17;
  work.s8_735 = 33.31250000000001 - work.s7_271;
  work.s8_736 = fnma(-p_bell_crank_z, work.s8_21, p_bell_crank_x*work.s8_20);
  work.s8_737 = fnma(work.s7_271, work.s8_733, work.s7_267*work.s8_734);
  work.s8_738 = fnma(projection.zdd_star[13], work.s7_267, work.s7_271*s8_731);
  work.s8_739 = fma(work.s7_267, s8_731, projection.zdd_star[13]*work.s7_271);
  work.s8_740 = work.s7_274 - work.s7_277;
  work.s8_741 = work.s8_26 - work.s8_27;
  // pitman_arm: pitman_arm, revolute, chassis
  work.s8_742 = projection.Rz[36]*work.s7_258;
  work.s8_743 = projection.Rz[36]*work.s7_259;
  work.s8_744 = projection.Rz[37]*work.s7_258;
  work.s8_745 = projection.Rz[37]*work.s7_259;
  work.s8_746 = projection.Rz[38]*work.s7_258;
  work.s8_747 = projection.Rz[38]*work.s7_259;
  const double s8_748 = fma(zd_pitman_arm, work.s8_17, s6_20);
  work.s8_749 = 2.1 + work.s7_259;
  work.s8_750 = zd_pitman_arm*work.s8_18;
  work.s8_751 = zd_pitman_arm*work.s8_19;
  const double s8_752 = s7_266 - K_pitman_arm_yy;
  work.s8_753 = projection.Rz[36]*s8_752;
  work.s8_754 = projection.Rz[37]*s8_752;
  work.s8_755 = projection.Rz[38]*s8_752;
  work.s8_756 = fma(work.s7_259, work.s8_751, work.s7_258*work.s8_750);
  work.s8_757 = 23.1 - work.s7_258;
  work.s8_758 = fma(work.s7_259, s8_748, projection.zdd_star[12]*work.s7_258);
  work.s8_759 = fnma(projection.zdd_star[12], work.s7_259, work.s7_258*s8_748);
  const double s8_760 = fma(-p_pitman_arm_z, work.s8_25, work.s8_164);
  work.s8_761 = fma(p_pitman_arm_x, work.s8_22, s8_760);
  const double s8_762 = fnma(-p_pitman_arm_z, work.s8_22, p_pitman_arm_y*work.s8_20);
  work.s8_763 = fnma(p_pitman_arm_x, work.s8_26, s8_762);
  work.s8_764 = work.s7_264 - work.s7_263;
  // arb_front_right: arb_front_right, revolute, chassis
  work.s8_765 = projection.Rz[33]*work.s7_244;
  work.s8_766 = projection.Rz[34]*work.s7_244;
  work.s8_767 = projection.Rz[35]*work.s7_244;
  work.s8_768 = projection.Rz[33]*work.s7_242;
  work.s8_769 = projection.Rz[34]*work.s7_242;
  work.s8_770 = projection.Rz[35]*work.s7_242;
  const double s8_771 = fma(p_arb_front_right_x, work.s8_26, work.s8_165);
  work.s8_772 = fma(zd_arb_front_right, work.s8_17, s6_19);
  work.s8_773 = work.s7_242 - 2.25;
  const double s8_774 = s7_257 - K_arb_front_right_yy;
  work.s8_775 = projection.Rz[33]*s8_774;
  work.s8_776 = projection.Rz[34]*s8_774;
  work.s8_777 = projection.Rz[35]*s8_774;
  work.s8_778 = zd_arb_front_right*work.s8_19;
  work.s8_779 = zd_arb_front_right*work.s8_18;
  work.s8_780 = fma(work.s7_244, work.s8_779, work.s7_242*work.s8_778);
  work.s8_781 = fma(-p_arb_rear_right_y, work.s8_20, s8_771);
  work.s8_782 = 17.775 + work.s7_244;
  work.s8_783 = fnma(work.s7_244, work.s8_772, projection.zdd_star[11]*work.s7_242);
  work.s8_784 = fma(work.s7_242, work.s8_772, projection.zdd_star[11]*work.s7_244);
  const double s8_785 = fma(p_arb_front_right_x, work.s8_22, work.s8_166);
  work.s8_786 = fnma(-p_arb_rear_right_z, work.s8_21, s8_785);
  work.s8_787 = work.s7_255 - work.s7_254;
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.s8_788 = projection.Rz[30]*work.s7_231;
  work.s8_789 = projection.Rz[31]*work.s7_231;
  work.s8_790 = projection.Rz[32]*work.s7_231;
  work.s8_791 = 2.1 + work.s7_231;
  const double s8_792 = p_upper_arm_right_x*work.s8_26;
  const double s8_793 = fma(zd_upper_arm_right, work.s8_18, s6_18);
  work.s8_794 = work.s7_229 - 3.75;
  work.s8_795 = zd_upper_arm_right*work.s8_19;
  const double s8_796 = s7_240 - K_upper_arm_right_xx;
  work.s8_797 = projection.Rz[30]*s8_796;
  work.s8_798 = projection.Rz[31]*s8_796;
  work.s8_799 = projection.Rz[32]*s8_796;
  work.s8_800 = zd_upper_arm_right*work.s8_17;
  work.s8_801 = fnma(work.s7_231, work.s8_795, work.s7_229*work.s8_800);
  work.s8_802 = fnma(work.s7_229, s8_793, projection.zdd_star[10]*work.s7_231);
  work.s8_803 = fma(work.s7_231, s8_793, projection.zdd_star[10]*work.s7_229);
  const double s8_804 = p_upper_arm_right_x*work.s8_20;
  const double s8_805 = fnma(-p_upper_arm_right_z, work.s8_21, s8_804);
  work.s8_806 = fma(p_pitman_arm_y, work.s8_27, s8_805);
  const double s8_807 = p_upper_arm_right_x*work.s8_22;
  const double s8_808 = fma(-p_upper_arm_right_z, work.s8_25, s8_807);
  work.s8_809 = s8_808 - work.s8_164;
  work.s8_810 = work.s7_237 - work.s7_238;
  work.s8_811 = work.s8_27 - work.s8_25;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_812 = fnma(work.s4_43, work.s8_19, fms(work.s4_42, work.s8_17, s8_792));
  const double s8_813 = fma(work.r_carrier_right_aux1_y, work.s8_20, s8_812);
  const double s8_814 = fnma(work.s1_22, work.s8_22, s8_813);
  const double s8_815 = fnma(work.w_chassis_y, work.s4_41, work.w_chassis_x*work.s4_32);
  work.s8_816 = work.s6_43 + s8_815;
  const double s8_817 = fms(work.w_carrier_right_x, work.w_carrier_right_y, work.s8_816);
  const double s8_818 = fnma(work.w_chassis_x, work.s4_30, work.w_chassis_z*work.s4_41);
  work.s8_819 = work.s6_53 + s8_818;
  const double s8_820 = fma(work.w_carrier_right_x, work.w_carrier_right_z, work.s8_819);
  const double s8_821 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s8_822 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s8_823 = s8_821 + s8_822;
  const double s8_824 = fma(work.s7_195, s8_817, m_carrier_right_2*s8_814);
  work.f_carrier_right_x = fnma(work.s7_189, s8_823, fma(work.s7_192, s8_820, s8_824));
  const double s8_825 = fma(work.s1_21, projection.zdd_star[6], s8_804) - work.s6_17;
  const double s8_826 = fnma(work.s1_22, work.s8_21, s8_825);
  const double s8_827 = fnma(work.r_carrier_right_aux1_y, work.s8_27, s8_826);
  const double s8_828 = fnma(work.s4_42, work.s8_18, s8_827);
  const double s8_829 = fma(work.w_carrier_right_x, work.w_carrier_right_y, work.s8_816);
  const double s8_830 = fnma(work.w_chassis_z, work.s4_32, work.w_chassis_y*work.s4_30);
  work.s8_831 = work.s8_719 + s8_830;
  const double s8_832 = fms(work.w_carrier_right_y, work.w_carrier_right_z, work.s8_831);
  const double s8_833 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_822);
  const double s8_834 = fma(work.s7_189, s8_829, m_carrier_right_2*s8_828);
  work.f_carrier_right_y = fnma(work.s7_195, s8_833, fma(work.s7_192, s8_832, s8_834));
  const double s8_835 = work.s8_720 + fma(work.s1_21, work.s6_16, s8_807);
  const double s8_836 = fma(work.s4_43, work.s8_18, s8_835);
  const double s8_837 = fma(work.r_carrier_right_aux1_y, work.s8_21, s8_836);
  const double s8_838 = fma(work.s1_22, work.s8_25, s8_837);
  const double s8_839 = fma(work.w_carrier_right_y, work.w_carrier_right_z, work.s8_831);
  const double s8_840 = fms(work.w_carrier_right_x, work.w_carrier_right_z, work.s8_819);
  const double s8_841 = fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_821);
  const double s8_842 = fma(work.s7_195, s8_839, m_carrier_right_2*s8_838);
  work.f_carrier_right_z = fnma(work.s7_192, s8_841, fma(work.s7_189, s8_840, s8_842));
  const double s8_843 = fnma(work.s7_192, s8_828, fma(work.s7_195, s8_838, s8_687));
  const double s8_844 = fma(work.s7_220, s8_840, fma(work.s7_225, s8_839, s8_843));
  const double s8_845 = fnma(work.s7_226, s8_832, fnma(work.s7_218, s8_829, s8_844));
  work.n_carrier_right_x = fma(work.s7_210, s8_833 - s8_841, s8_845);
  const double s8_846 = fnma(work.s7_189, s8_838, fma(work.s7_192, s8_814, s8_684));
  const double s8_847 = fma(work.s7_226, s8_820, fma(work.s7_210, s8_817, s8_846));
  const double s8_848 = fnma(work.s7_222, s8_840, fnma(work.s7_220, s8_839, s8_847));
  work.n_carrier_right_y = fma(work.s7_218, s8_841 - s8_823, s8_848);
  const double s8_849 = fnma(work.s7_195, s8_814, fma(work.s7_189, s8_828, s8_681));
  const double s8_850 = fma(work.s7_218, s8_832, fma(work.s7_222, s8_829, s8_849));
  const double s8_851 = fnma(work.s7_210, s8_820, fnma(work.s7_225, s8_817, s8_850));
  work.n_carrier_right_z = fma(work.s7_220, s8_823 - s8_833, s8_851);
  work.s8_852 = work.s1_22 + work.s1_22;
  work.s8_853 = fnma(work.s3_43, work.s7_195, work.s3_52*work.s7_192);
  work.s8_854 = fnma(work.s3_46, work.s7_195, work.s3_55*work.s7_192);
  work.s8_855 = fnma(work.s3_49, work.s7_195, work.s3_58*work.s7_192);
  const double s8_856 = fma(work.s7_195, work.s8_703, m_carrier_right_2*work.s8_704);
  work.s8_857 = fnma(work.s3_52, work.s7_189, s8_856);
  const double s8_858 = fma(work.s7_195, work.s8_709, m_carrier_right_2*work.s8_710);
  work.s8_859 = fnma(work.s3_55, work.s7_189, s8_858);
  const double s8_860 = fma(work.s7_195, work.s8_715, m_carrier_right_2*work.s8_716);
  work.s8_861 = fnma(work.s3_58, work.s7_189, s8_860);
  const double s8_862 = fma(work.s3_43, work.s7_189, m_carrier_right_2*work.s8_705);
  work.s8_863 = fnma(work.s7_192, work.s8_703, s8_862);
  const double s8_864 = fma(work.s3_46, work.s7_189, m_carrier_right_2*work.s8_711);
  work.s8_865 = fnma(work.s7_192, work.s8_709, s8_864);
  const double s8_866 = fma(work.s3_49, work.s7_189, m_carrier_right_2*work.s8_717);
  work.s8_867 = fnma(work.s7_192, work.s8_715, s8_866);
  work.s8_868 = 395.1 + work.s7_189;
  work.s8_869 = fma(109.75, work.r_carrier_right_aux1_y, work.s7_195);
  work.s8_870 = fnma(109.75, work.s1_22, work.s7_192);
  const double s8_871 = s7_227 - work.s7_226;
  const double s8_872 = fma(work.s3_43, s8_871, work.s7_189*work.s8_705);
  work.s8_873 = fnma(work.s3_52, work.s7_210, fnma(work.s7_218, work.s8_703, s8_872));
  const double s8_874 = fma(work.s3_46, s8_871, work.s7_189*work.s8_711);
  work.s8_875 = fnma(work.s3_55, work.s7_210, fnma(work.s7_218, work.s8_709, s8_874));
  const double s8_876 = fma(work.s3_49, s8_871, work.s7_189*work.s8_717);
  work.s8_877 = fnma(work.s3_58, work.s7_210, fnma(work.s7_218, work.s8_715, s8_876));
  const double s8_878 = s7_227 - work.s7_225;
  const double s8_879 = fnma(work.s3_43, work.s7_210, work.s3_52*s8_878);
  work.s8_880 = fnma(work.s7_189, work.s8_704, fnma(work.s7_220, work.s8_703, s8_879));
  const double s8_881 = fnma(work.s3_46, work.s7_210, work.s3_55*s8_878);
  work.s8_882 = fnma(work.s7_189, work.s8_710, fnma(work.s7_220, work.s8_709, s8_881));
  const double s8_883 = fnma(work.s3_49, work.s7_210, work.s3_58*s8_878);
  work.s8_884 = fnma(work.s7_189, work.s8_716, fnma(work.s7_220, work.s8_715, s8_883));
  const double s8_885 = s7_227 - work.s7_222;
  const double s8_886 = fnma(work.s7_192, work.s8_705, work.s7_195*work.s8_704);
  const double s8_887 = fnma(work.s3_43, work.s7_218, fma(work.s8_703, s8_885, s8_886));
  work.s8_888 = fnma(work.s3_52, work.s7_220, s8_887);
  const double s8_889 = fnma(work.s7_192, work.s8_711, work.s7_195*work.s8_710);
  const double s8_890 = fnma(work.s3_46, work.s7_218, fma(work.s8_709, s8_885, s8_889));
  work.s8_891 = fnma(work.s3_55, work.s7_220, s8_890);
  const double s8_892 = fnma(work.s7_192, work.s8_717, work.s7_195*work.s8_716);
  const double s8_893 = fnma(work.s3_49, work.s7_218, fma(work.s8_715, s8_885, s8_892));
  work.s8_894 = fnma(work.s3_58, work.s7_220, s8_893);
  work.s8_895 = work.r_carrier_right_aux1_y + work.r_carrier_right_aux1_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s8_896 = projection.Rz[18]*work.s7_175;
  work.s8_897 = projection.Rz[19]*work.s7_175;
  work.s8_898 = projection.Rz[20]*work.s7_175;
  work.s8_899 = projection.Rz[18]*work.s7_177;
  work.s8_900 = projection.Rz[19]*work.s7_177;
  work.s8_901 = projection.Rz[20]*work.s7_177;
  const double s8_902 = fma(zd_lower_arm_right, work.s8_18, work.s6_16);
  work.s8_903 = 7.75 + work.s7_177;
  work.s8_904 = zd_lower_arm_right*work.s8_19;
  work.s8_905 = zd_lower_arm_right*work.s8_17;
  work.s8_906 = fnma(work.s7_177, work.s8_904, work.s7_175*work.s8_905);
  const double s8_907 = s7_186 - K_lower_arm_right_xx;
  work.s8_908 = projection.Rz[18]*s8_907;
  work.s8_909 = projection.Rz[19]*s8_907;
  work.s8_910 = projection.Rz[20]*s8_907;
  work.s8_911 = work.s7_175 - 5.0;
  work.s8_912 = fnma(work.s7_175, s8_902, projection.zdd_star[6]*work.s7_177);
  work.s8_913 = fma(work.s7_177, s8_902, projection.zdd_star[6]*work.s7_175);
  work.s8_914 = fnma(-p_lower_arm_right_z, work.s8_21, s8_804);
  work.s8_915 = fma(-p_lower_arm_right_y, work.s8_27, work.s8_914);
  work.s8_916 = fma(-p_lower_arm_right_z, work.s8_25, s8_807);
  work.s8_917 = fnma(-p_pitman_arm_z, work.s8_21, work.s8_916);
  work.s8_918 = work.s7_183 - work.s7_184;
  // arb_front_left: arb_front_left, revolute, chassis
  work.s8_919 = work.s7_160 - 2.25;
  work.s8_920 = fma(zd_arb_front_left, work.s8_17, s6_15);
  work.s8_921 = 17.775 + work.s7_164;
  const double s8_922 = s7_173 - K_arb_front_left_yy;
  work.s8_923 = projection.Rz[15]*s8_922;
  work.s8_924 = projection.Rz[16]*s8_922;
  work.s8_925 = projection.Rz[17]*s8_922;
  work.s8_926 = zd_arb_front_left*work.s8_19;
  work.s8_927 = zd_arb_front_left*work.s8_18;
  work.s8_928 = fma(work.s7_164, work.s8_927, work.s7_160*work.s8_926);
  work.s8_929 = fnma(work.s7_164, work.s8_920, projection.zdd_star[5]*work.s7_160);
  work.s8_930 = fms(-p_arb_rear_right_y, work.s8_20, s8_771);
  work.s8_931 = fma(work.s7_160, work.s8_920, projection.zdd_star[5]*work.s7_164);
  work.s8_932 = fma(-p_arb_rear_right_z, work.s8_21, s8_785);
  work.s8_933 = work.s7_171 - work.s7_170;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s8_934 = fma(zd_upper_arm_left, work.s8_18, s6_14);
  work.s8_935 = 3.75 + work.s7_145;
  work.s8_936 = work.s7_147 - 2.1;
  const double s8_937 = s7_156 - K_upper_arm_left_xx;
  work.s8_938 = projection.Rz[12]*s8_937;
  work.s8_939 = projection.Rz[13]*s8_937;
  work.s8_940 = projection.Rz[14]*s8_937;
  work.s8_941 = zd_upper_arm_left*work.s8_17;
  work.s8_942 = zd_upper_arm_left*work.s8_19;
  work.s8_943 = fma(work.s7_147, work.s8_942, work.s7_145*work.s8_941);
  work.s8_944 = fnma(work.s7_147, s8_934, projection.zdd_star[4]*work.s7_145);
  work.s8_945 = work.s8_164 + s8_808;
  work.s8_946 = fma(work.s7_145, s8_934, projection.zdd_star[4]*work.s7_147);
  work.s8_947 = fnma(p_pitman_arm_y, work.s8_27, s8_805);
  work.s8_948 = work.s7_153 - work.s7_154;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_949 = fma(work.s4_39, work.s8_19, fms(work.s4_38, work.s8_17, s8_792));
  const double s8_950 = fma(work.r_carrier_left_aux1_y, work.s8_20, s8_949);
  const double s8_951 = fma(work.r_carrier_left_aux1_z, work.s8_22, s8_950);
  const double s8_952 = fnma(work.w_chassis_y, work.s4_37, work.w_chassis_x*work.s4_28);
  work.s8_953 = work.s6_36 + s8_952;
  const double s8_954 = fms(work.w_carrier_left_x, work.w_carrier_left_y, work.s8_953);
  const double s8_955 = fnma(work.w_chassis_x, work.s4_26, work.w_chassis_z*work.s4_37);
  work.s8_956 = work.s6_48 + s8_955;
  const double s8_957 = fma(work.w_carrier_left_x, work.w_carrier_left_z, work.s8_956);
  const double s8_958 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s8_959 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s8_960 = s8_958 + s8_959;
  const double s8_961 = fma(work.s7_106, s8_954, m_carrier_left_2*s8_951);
  work.f_carrier_left_x = fnma(work.s7_109, s8_960, fma(work.s7_103, s8_957, s8_961));
  const double s8_962 = fnma(work.s1_10, projection.zdd_star[0], s8_804 - work.s6_12);
  const double s8_963 = fma(work.r_carrier_left_aux1_z, work.s8_21, s8_962);
  const double s8_964 = fnma(work.r_carrier_left_aux1_y, work.s8_27, s8_963);
  const double s8_965 = fnma(work.s4_38, work.s8_18, s8_964);
  const double s8_966 = fnma(work.w_chassis_z, work.s4_28, work.w_chassis_y*work.s4_26);
  work.s8_967 = work.s8_718 + s8_966;
  const double s8_968 = fms(work.w_carrier_left_y, work.w_carrier_left_z, work.s8_967);
  const double s8_969 = fma(work.w_carrier_left_x, work.w_carrier_left_y, work.s8_953);
  const double s8_970 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_959);
  const double s8_971 = fma(work.s7_103, s8_968, m_carrier_left_2*s8_965);
  work.f_carrier_left_y = fnma(work.s7_106, s8_970, fma(work.s7_109, s8_969, s8_971));
  const double s8_972 = fma(work.s1_8, projection.zdd_star[0], s8_807) - work.s6_13;
  const double s8_973 = fma(work.r_carrier_left_aux1_y, work.s8_21, s8_972);
  const double s8_974 = fnma(work.r_carrier_left_aux1_z, work.s8_25, s8_973);
  const double s8_975 = fnma(work.s4_39, work.s8_18, s8_974);
  const double s8_976 = fma(work.w_carrier_left_y, work.w_carrier_left_z, work.s8_967);
  const double s8_977 = fms(work.w_carrier_left_x, work.w_carrier_left_z, work.s8_956);
  const double s8_978 = fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_958);
  const double s8_979 = fma(work.s7_106, s8_976, m_carrier_left_2*s8_975);
  work.f_carrier_left_z = fnma(work.s7_103, s8_978, fma(work.s7_109, s8_977, s8_979));
  const double s8_980 = fnma(work.s7_103, s8_965, fma(work.s7_106, s8_975, s8_699));
  const double s8_981 = fma(work.s7_136, s8_977, fma(work.s7_139, s8_976, s8_980));
  const double s8_982 = fnma(work.s7_142, s8_968, fnma(work.s7_133, s8_969, s8_981));
  work.n_carrier_left_x = fma(work.s7_124, s8_970 - s8_978, s8_982);
  const double s8_983 = fnma(work.s7_109, s8_975, fma(work.s7_103, s8_951, s8_696));
  const double s8_984 = fma(work.s7_142, s8_957, fma(work.s7_124, s8_954, s8_983));
  const double s8_985 = fnma(work.s7_141, s8_977, fnma(work.s7_136, s8_976, s8_984));
  work.n_carrier_left_y = fma(work.s7_133, s8_978 - s8_960, s8_985);
  const double s8_986 = fnma(work.s7_106, s8_951, fma(work.s7_109, s8_965, s8_694));
  const double s8_987 = fma(work.s7_141, s8_969, fma(work.s7_133, s8_968, s8_986));
  const double s8_988 = fnma(work.s7_124, s8_957, fnma(work.s7_139, s8_954, s8_987));
  work.n_carrier_left_z = fma(work.s7_136, s8_960 - s8_970, s8_988);
  work.s8_989 = fnma(work.s3_25, work.s7_106, work.s3_34*work.s7_103);
  work.s8_990 = fnma(work.s3_28, work.s7_106, work.s3_37*work.s7_103);
  work.s8_991 = fnma(work.s3_31, work.s7_106, work.s3_40*work.s7_103);
  const double s8_992 = work.s8_855 + fma(projection.Rz[17], work.s7_160, work.s8_991);
  work.s8_993 = work.s8_770 + s8_992 - work.s8_723 - work.s8_747;
  const double s8_994 = fma(work.s7_106, work.s8_700, m_carrier_left_2*work.s8_701);
  work.s8_995 = fnma(work.s3_34, work.s7_109, s8_994);
  const double s8_996 = fma(work.s7_106, work.s8_706, m_carrier_left_2*work.s8_707);
  work.s8_997 = fnma(work.s3_37, work.s7_109, s8_996);
  const double s8_998 = fma(work.s7_106, work.s8_712, m_carrier_left_2*work.s8_713);
  work.s8_999 = fnma(work.s3_40, work.s7_109, s8_998);
  const double s8_1000 = fnma(work.s7_103, work.s8_700, work.s3_25*work.s7_109);
  work.s8_1001 = fnma(m_carrier_left_2, work.s8_702, s8_1000);
  const double s8_1002 = fnma(work.s7_103, work.s8_706, work.s3_28*work.s7_109);
  work.s8_1003 = fnma(m_carrier_left_2, work.s8_708, s8_1002);
  const double s8_1004 = fnma(work.s7_103, work.s8_712, work.s3_31*work.s7_109);
  work.s8_1005 = fnma(m_carrier_left_2, work.s8_714, s8_1004);
  work.s8_1006 = fma(109.75, work.r_carrier_left_aux1_z, work.s7_103);
  work.s8_1007 = fma(109.75, work.r_carrier_left_aux1_y, work.s7_106);
  work.s8_1008 = 395.1 + work.s7_109;
  work.s8_1009 = work.r_carrier_left_aux1_z + work.r_carrier_left_aux1_z;
  work.s8_1010 = work.r_carrier_left_aux1_y + work.r_carrier_left_aux1_y;
  const double s8_1011 = work.s7_143 - work.s7_142;
  const double s8_1012 = fnma(work.s7_133, work.s8_700, work.s3_25*s8_1011);
  work.s8_1013 = fnma(work.s7_109, work.s8_702, fnma(work.s3_34, work.s7_124, s8_1012));
  const double s8_1014 = fnma(work.s7_133, work.s8_706, work.s3_28*s8_1011);
  work.s8_1015 = fnma(work.s7_109, work.s8_708, fnma(work.s3_37, work.s7_124, s8_1014));
  const double s8_1016 = fnma(work.s7_133, work.s8_712, work.s3_31*s8_1011);
  work.s8_1017 = fnma(work.s7_109, work.s8_714, fnma(work.s3_40, work.s7_124, s8_1016));
}

/// Part 4 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_chosen_accelerations_4(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_1018 = work.s7_143 - work.s7_139;
  const double s8_1019 = fnma(work.s3_25, work.s7_124, work.s3_34*s8_1018);
  work.s8_1020 = fnma(work.s7_109, work.s8_701, fnma(work.s7_136, work.s8_700, s8_1019));
  const double s8_1021 = fnma(work.s3_28, work.s7_124, work.s3_37*s8_1018);
  work.s8_1022 = fnma(work.s7_109, work.s8_707, fnma(work.s7_136, work.s8_706, s8_1021));
  const double s8_1023 = fnma(work.s3_31, work.s7_124, work.s3_40*s8_1018);
  const double s8_1024 = fnma(work.s7_109, work.s8_713, fnma(work.s7_136, work.s8_712, s8_1023));
  const double s8_1025 = work.s7_143 - work.s7_141;
  const double s8_1026 = fma(work.s7_106, work.s8_701, work.s7_103*work.s8_702);
  const double s8_1027 = fnma(work.s3_25, work.s7_133, fma(work.s8_700, s8_1025, s8_1026));
  work.s8_1028 = fnma(work.s3_34, work.s7_136, s8_1027);
  const double s8_1029 = fma(work.s7_106, work.s8_707, work.s7_103*work.s8_708);
  const double s8_1030 = fnma(work.s3_28, work.s7_133, fma(work.s8_706, s8_1025, s8_1029));
  work.s8_1031 = fnma(work.s3_37, work.s7_136, s8_1030);
  const double s8_1032 = fma(work.s7_106, work.s8_713, work.s7_103*work.s8_714);
  const double s8_1033 = fnma(work.s3_31, work.s7_133, fma(work.s8_712, s8_1025, s8_1032));
  const double s8_1034 = fnma(work.s3_40, work.s7_136, s8_1033);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s8_1035 = work.s7_267 + (work.s7_229 + (work.s7_175 + (work.s7_89 + work.s7_145)));
  work.s8_1036 = 5.25 + s8_1035;
  const double s8_1037 = fma(projection.Rz[2], work.s7_89, work.s8_999);
  const double s8_1038 = work.s8_898 + fma(projection.Rz[14], work.s7_145, s8_1037);
  const double s8_1039 = work.s8_746 + fma(projection.Rz[32], work.s7_229, work.s8_861 + s8_1038);
  work.s8_1040 = fnma(projection.Rz[17], work.s7_164, s8_1039 - work.s8_767);
  const double s8_1041 = work.s8_901 + work.s8_1005;
  const double s8_1042 = work.s8_790 + (work.s8_867 + s8_1041) - work.s8_726;
  const double s8_1043 = fnma(projection.Rz[14], work.s7_147, s8_1042);
  work.s8_1044 = fnma(projection.Rz[2], work.s7_91, s8_1043);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s8_1045 = fma(zd_lower_arm_left, work.s8_18, work.s6_11);
  const double s8_1046 = 5.0 + work.s7_89;
  const double s8_1047 = work.s7_91 - 7.75;
  work.s8_1048 = zd_lower_arm_left*work.s8_17;
  work.s8_1049 = zd_lower_arm_left*work.s8_19;
  work.s8_1050 = fma(work.s7_91, work.s8_1049, work.s7_89*work.s8_1048);
  const double s8_1051 = work.s7_100 - K_lower_arm_left_xx;
  work.s8_1052 = projection.Rz[0]*s8_1051;
  work.s8_1053 = projection.Rz[1]*s8_1051;
  const double s8_1054 = projection.Rz[2]*s8_1051;
  work.s8_1055 = fnma(work.s7_91, s8_1045, projection.zdd_star[0]*work.s7_89);
  const double s8_1056 = fma(-p_pitman_arm_z, work.s8_21, work.s8_916);
  work.s8_1057 = fma(work.s7_89, s8_1045, projection.zdd_star[0]*work.s7_91);
  const double s8_1058 = fnma(-p_lower_arm_right_y, work.s8_27, work.s8_914);
  const double s8_1059 = work.s7_97 - work.s7_98;
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s8_1060 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s8_1061 = fnma(-p_arb_link_front_left_from_x, R_arb_front_left_x_x, s8_1060);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s8_1062 = zd_arb_front_left*s8_1061;
  const double s8_1063 = -p_arb_link_front_left_from_x*R_arb_front_left_x_z;
  const double s8_1064 = fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s8_1063);
  const double s8_1065 = zd_arb_front_left*s8_1064;
  const double s8_1066 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s8_1067 = work.s1_12 + work.R_carrier_left_x_z;
  const double s8_1068 = fma(-p_arb_link_front_left_to_y, s8_1067, s8_1066);
  const double s8_1069 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s8_1070 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  const double s8_1071 = fma(-p_arb_link_front_left_to_y, s8_1069, s8_1070);
  const double s8_1072 = fnma(work.s4_37, s8_1071, work.s4_26*s8_1068);
  const double s8_1073 = s8_1072 - work.s4_39;
  work.s8_1074 = fnma(work.s8_700, s8_1071, fms(work.s3_25, s8_1068, work.s8_702));
  work.s8_1075 = fnma(work.s8_706, s8_1071, fms(work.s3_28, s8_1068, work.s8_708));
  const double s8_1076 = fnma(work.s8_712, s8_1071, fms(work.s3_31, s8_1068, work.s8_714));
  work.s8_1077 = s8_1064 - work.r_carrier_left_aux1_z - s8_1071 - (-p_arb_front_left_z);
  work.s8_1078 = 0.35 + (s8_1061 - s8_1068);
  const double s8_1079 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s8_1080 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  const double s8_1081 = fma(-p_arb_link_front_left_to_y, s8_1079, s8_1080);
  work.s8_1082 = 0.72 - work.r_carrier_left_aux1_y - s8_1081;
  work.s8_1083 = 0.3333333333333333*work.s8_1082;
  work.s8_1084 = 0.3333333333333333*work.s8_1078;
  work.s8_1085 = 0.3333333333333333*work.s8_1077;
  const double s8_1086 = fnma(work.s4_28, s8_1068, work.s4_37*s8_1081);
  const double s8_1087 = s8_1062 + (work.s4_38 + s8_1086);
  const double s8_1088 = fma(work.s8_700, s8_1081, fma(projection.Rz[15], s8_1061, work.s8_701));
  work.s8_1089 = fnma(work.s3_34, s8_1068, s8_1088);
  const double s8_1090 = fma(work.s8_706, s8_1081, fma(projection.Rz[16], s8_1061, work.s8_707));
  work.s8_1091 = fnma(work.s3_37, s8_1068, s8_1090);
  const double s8_1092 = fma(work.s8_712, s8_1081, fma(projection.Rz[17], s8_1061, work.s8_713));
  const double s8_1093 = fnma(work.s3_40, s8_1068, s8_1092);
  const double s8_1094 = fnma(work.s3_34, s8_1071, projection.Rz[15]*s8_1064);
  work.s8_1095 = fma(work.s3_25, s8_1081, s8_1094);
  const double s8_1096 = fnma(work.s3_37, s8_1071, projection.Rz[16]*s8_1064);
  work.s8_1097 = fma(work.s3_28, s8_1081, s8_1096);
  const double s8_1098 = fnma(work.s3_40, s8_1071, projection.Rz[17]*s8_1064);
  const double s8_1099 = fma(work.s3_31, s8_1081, s8_1098);
  const double s8_1100 = fnma(work.s4_26, s8_1081, work.s4_28*s8_1071);
  const double s8_1101 = s8_1065 - s8_1100;
  const double s8_1102 = fma(work.s8_22, work.s8_1077, work.s8_20*work.s8_1082);
  const double s8_1103 = fnma(work.s8_26, work.s8_1078, s8_1102);
  const double s8_1104 = fnma(work.s6_48, s8_1071, fma(projection.zdd_star[5], s8_1064, s8_1103));
  const double s8_1105 = fnma(zd_arb_front_left, s8_1062, fma(work.s6_36, s8_1081, s8_1104));
  const double s8_1106 = fma(work.s4_26, s8_1072, fnma(work.s4_28, s8_1086, s8_1105));
  const double s8_1107 = fnma(work.s8_17, s8_1087, fma(work.s8_19, s8_1073, s8_1106));
  work.s8_1108 = 0.3333333333333333*s8_1107;
  const double s8_1109 = fma(work.s1_10, projection.zdd_star[0], work.s6_12);
  const double s8_1110 = fma(work.s8_21, work.s8_1077, fma(work.s8_20, work.s8_1078, s8_1109));
  const double s8_1111 = fma(work.s8_18, s8_1087, fnma(work.s8_27, work.s8_1082, s8_1110));
  const double s8_1112 = fnma(work.s6_36, s8_1068, fma(work.s8_19, s8_1101, s8_1111));
  const double s8_1113 = fnma(work.s4_26, s8_1100, fma(work.s8_718, s8_1071, s8_1112));
  work.s8_1114 = 0.3333333333333333*fma(work.s4_37, s8_1086, s8_1113);
  const double s8_1115 = fnma(work.s1_8, projection.zdd_star[0], work.s6_13);
  const double s8_1116 = fma(work.s8_22, work.s8_1078, fma(work.s8_21, work.s8_1082, s8_1115));
  const double s8_1117 = fnma(work.s8_18, s8_1073, fnma(work.s8_25, work.s8_1077, s8_1116));
  const double s8_1118 = fnma(work.s8_17, s8_1101, s8_1117);
  const double s8_1119 = fnma(projection.zdd_star[5], s8_1061, s8_1118);
  const double s8_1120 = fma(work.s6_48, s8_1068, fnma(work.s8_718, s8_1081, s8_1119));
  const double s8_1121 = fnma(work.s4_37, s8_1072, fnma(zd_arb_front_left, s8_1065, s8_1120));
  work.s8_1122 = 0.3333333333333333*fma(work.s4_28, s8_1100, s8_1121);
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s8_1123 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s8_1124 = fnma(-p_arb_link_front_right_from_x, R_arb_front_right_x_x, s8_1123);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s8_1125 = zd_arb_front_right*s8_1124;
  const double s8_1126 = -p_arb_link_front_right_from_x*R_arb_front_right_x_z;
  const double s8_1127 = fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s8_1126);
  const double s8_1128 = zd_arb_front_right*s8_1127;
  const double s8_1129 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s8_1130 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  const double s8_1131 = fma(-p_arb_link_front_left_to_y, s8_1129, s8_1130);
  work.s8_1132 = 0.72 + (work.r_carrier_right_aux1_y + s8_1131);
  const double s8_1133 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s8_1134 = work.R_carrier_right_x_z - work.s1_24;
  const double s8_1135 = fma(-p_arb_link_front_left_to_y, s8_1134, s8_1133);
  const double s8_1136 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s8_1137 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  const double s8_1138 = fma(-p_arb_link_front_left_to_y, s8_1136, s8_1137);
  const double s8_1139 = fnma(work.s4_41, s8_1138, work.s4_30*s8_1135);
  const double s8_1140 = work.s4_43 + s8_1139;
  work.s8_1141 = fnma(work.s8_703, s8_1138, fma(work.s3_43, s8_1135, work.s8_705));
  work.s8_1142 = fnma(work.s8_709, s8_1138, fma(work.s3_46, s8_1135, work.s8_711));
  const double s8_1143 = fnma(work.s8_715, s8_1138, fma(work.s3_49, s8_1135, work.s8_717));
  work.s8_1144 = work.s1_22 + s8_1127 - s8_1138 - (-p_arb_front_right_z);
  work.s8_1145 = 0.35 + (s8_1124 - s8_1135);
  work.s8_1146 = 0.3333333333333333*work.s8_1145;
  work.s8_1147 = 0.3333333333333333*work.s8_1144;
  work.s8_1148 = 0.3333333333333333*work.s8_1132;
  const double s8_1149 = fnma(work.s4_32, s8_1135, work.s4_41*s8_1131);
  const double s8_1150 = s8_1125 + (work.s4_42 + s8_1149);
  const double s8_1151 = fma(work.s8_703, s8_1131, fma(projection.Rz[33], s8_1124, work.s8_704));
  work.s8_1152 = fnma(work.s3_52, s8_1135, s8_1151);
  const double s8_1153 = fma(work.s8_709, s8_1131, fma(projection.Rz[34], s8_1124, work.s8_710));
  work.s8_1154 = fnma(work.s3_55, s8_1135, s8_1153);
  const double s8_1155 = fma(work.s8_715, s8_1131, fma(projection.Rz[35], s8_1124, work.s8_716));
  const double s8_1156 = fnma(work.s3_58, s8_1135, s8_1155);
  const double s8_1157 = fnma(work.s3_52, s8_1138, projection.Rz[33]*s8_1127);
  work.s8_1158 = fma(work.s3_43, s8_1131, s8_1157);
  const double s8_1159 = fnma(work.s3_55, s8_1138, projection.Rz[34]*s8_1127);
  work.s8_1160 = fma(work.s3_46, s8_1131, s8_1159);
  const double s8_1161 = fnma(work.s3_58, s8_1138, projection.Rz[35]*s8_1127);
  const double s8_1162 = fma(work.s3_49, s8_1131, s8_1161);
  const double s8_1163 = fnma(work.s4_30, s8_1131, work.s4_32*s8_1138);
  const double s8_1164 = s8_1128 - s8_1163;
  const double s8_1165 = fnma(work.s1_21, projection.zdd_star[6], work.s6_17);
  const double s8_1166 = fma(work.s8_20, work.s8_1145, fma(work.s8_27, work.s8_1132, s8_1165));
  const double s8_1167 = fma(work.s8_18, s8_1150, fma(work.s8_21, work.s8_1144, s8_1166));
  const double s8_1168 = fnma(work.s6_43, s8_1135, fma(work.s8_19, s8_1164, s8_1167));
  const double s8_1169 = fnma(work.s4_30, s8_1163, fma(work.s8_719, s8_1138, s8_1168));
  work.s8_1170 = 0.3333333333333333*fma(work.s4_41, s8_1149, s8_1169);
  const double s8_1171 = fnma(work.s8_26, work.s8_1145, work.s8_22*work.s8_1144);
  const double s8_1172 = fnma(work.s8_20, work.s8_1132, s8_1171);
  const double s8_1173 = fma(projection.zdd_star[11], s8_1127, s8_1172);
  const double s8_1174 = fma(work.s6_43, s8_1131, fnma(work.s6_53, s8_1138, s8_1173));
  const double s8_1175 = fnma(work.s4_32, s8_1149, fnma(zd_arb_front_right, s8_1125, s8_1174));
  const double s8_1176 = fma(work.s8_19, s8_1140, fma(work.s4_30, s8_1139, s8_1175));
  work.s8_1177 = 0.3333333333333333*fnma(work.s8_17, s8_1150, s8_1176);
  const double s8_1178 = fnma(work.s1_21, work.s6_16, fms(work.s8_22, work.s8_1145, work.s8_720));
  const double s8_1179 = fnma(work.s8_21, work.s8_1132, fnma(work.s8_25, work.s8_1144, s8_1178));
  const double s8_1180 = fnma(work.s8_17, s8_1164, fnma(work.s8_18, s8_1140, s8_1179));
  const double s8_1181 = fnma(projection.zdd_star[11], s8_1124, s8_1180);
  const double s8_1182 = fma(work.s6_53, s8_1135, fnma(work.s8_719, s8_1131, s8_1181));
  const double s8_1183 = fnma(work.s4_41, s8_1139, fnma(zd_arb_front_right, s8_1128, s8_1182));
  work.s8_1184 = 0.3333333333333333*fma(work.s4_32, s8_1163, s8_1183);
  // drag_link
  const double s8_1185 = -p_drag_link_from_z*work.sines[15];
  const double s8_1186 = -p_drag_link_from_z*work.cosines[15];
  const double R_bell_crank_y_x = work.sines[16];
  const double s8_1187 = p_drag_link_to_y*R_bell_crank_y_x;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s8_1188 = zd_pitman_arm*s8_1185;
  const double s8_1189 = zd_pitman_arm*s8_1186;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s8_1190 = zd_bell_crank*s8_1187;
  const double R_bell_crank_x_x = work.cosines[16];
  const double s8_1191 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s8_1192 = zd_bell_crank*s8_1191;
  work.s8_1193 = projection.Rz[36]*s8_1185;
  work.s8_1194 = projection.Rz[37]*s8_1185;
  const double s8_1195 = projection.Rz[38]*s8_1185;
  work.s8_1196 = projection.Rz[39]*s8_1187;
  work.s8_1197 = projection.Rz[40]*s8_1187;
  const double s8_1198 = projection.Rz[41]*s8_1187;
  work.s8_1199 = p_pitman_arm_y - s8_1191;
  work.s8_1200 = 1.5*work.s8_1199;
  work.s8_1201 = 0.2 - s8_1186;
  work.s8_1202 = 1.15 + (s8_1187 - s8_1185);
  work.s8_1203 = 1.5*work.s8_1201;
  work.s8_1204 = 1.5*work.s8_1202;
  work.s8_1205 = fnma(projection.Rz[36], s8_1186, projection.Rz[39]*s8_1191);
  work.s8_1206 = fnma(projection.Rz[37], s8_1186, projection.Rz[40]*s8_1191);
  const double s8_1207 = fnma(projection.Rz[38], s8_1186, projection.Rz[41]*s8_1191);
  const double s8_1208 = fma(work.s8_1193, work.s8_1193, work.s8_1196*work.s8_1196);
  const double s8_1209 = fma(work.s8_1205, work.s8_1205, s8_1208);
  const double s8_1210 = fma(work.s8_1193, work.s8_1194, work.s8_1196*work.s8_1197);
  work.s8_1211 = fma(work.s8_1205, work.s8_1206, s8_1210);
  const double s8_1212 = fma(work.s8_1193, s8_1195, work.s8_1196*s8_1198);
  const double s8_1213 = fma(work.s8_1205, s8_1207, s8_1212);
  const double s8_1214 = fma(work.s8_1194, work.s8_1194, work.s8_1197*work.s8_1197);
  const double s8_1215 = fma(work.s8_1206, work.s8_1206, s8_1214);
  const double s8_1216 = fma(work.s8_1194, s8_1195, work.s8_1197*s8_1198);
  const double s8_1217 = fma(work.s8_1206, s8_1207, s8_1216);
  const double s8_1218 = fma(s8_1207, s8_1207, fma(s8_1195, s8_1195, s8_1198*s8_1198));
  const double s8_1219 = fma(work.s8_22, work.s8_1201, work.s8_20*work.s8_1199);
  const double s8_1220 = fnma(work.s8_26, work.s8_1202, s8_1219);
  const double s8_1221 = fma(projection.zdd_star[13], s8_1191, s8_1220);
  const double s8_1222 = fnma(projection.zdd_star[12], s8_1186, s8_1221);
  const double s8_1223 = fma(s8_1188, zd_pitman_arm + work.s8_17, s8_1222);
  work.s8_1224 = 1.5*fnma(s8_1190, zd_bell_crank + work.s8_19, s8_1223);
  const double s8_1225 = s8_1192 - s8_1189;
  const double s8_1226 = fma(work.s8_22, work.s8_1202, work.s8_21*work.s8_1199);
  const double s8_1227 = fnma(work.s8_25, work.s8_1201, s8_1226);
  const double s8_1228 = fma(projection.zdd_star[12], s8_1185, s8_1227);
  const double s8_1229 = fma(work.s8_18, s8_1190, fma(zd_pitman_arm, s8_1189, s8_1228));
  work.s8_1230 = 1.5*fnma(work.s8_17, s8_1225, s8_1229);
  const double s8_1231 = fma(zd_bell_crank, s8_1192, projection.zdd_star[13]*s8_1187);
  const double s8_1232 = fnma(work.s8_18, s8_1188, fma(work.s8_19, s8_1225, s8_1231));
  const double s8_1233 = fma(work.s8_21, work.s8_1201, fma(work.s8_20, work.s8_1202, s8_1232));
  work.s8_1234 = 1.5*fnma(work.s8_27, work.s8_1199, s8_1233);
  // tie_rod_left
  const double s8_1235 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s8_1236 = -p_tie_rod_left_from_x*R_bell_crank_y_x;
  const double s8_1237 = fma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s8_1235);
  const double s8_1238 = zd_bell_crank*s8_1237;
  const double s8_1239 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s8_1236);
  const double s8_1240 = zd_bell_crank*s8_1239;
  const double s8_1241 = p_tie_rod_left_to_z*work.R_carrier_left_z_z;
  const double s8_1242 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_z_x, s8_1241);
  const double s8_1243 = fnma(-p_tie_rod_left_to_y, work.R_carrier_left_aux2_z_y, s8_1242);
  work.s8_1244 = -p_bell_crank_z + (work.r_carrier_left_aux1_z + s8_1243);
  const double s8_1245 = p_tie_rod_left_to_z*work.R_carrier_left_y_z;
  const double s8_1246 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_y_x, s8_1245);
  const double s8_1247 = fnma(-p_tie_rod_left_to_y, work.R_carrier_left_aux2_y_y, s8_1246);
  const double s8_1248 = -p_tie_rod_left_to_y*work.s1_12;
  const double s8_1249 = fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, s8_1248);
  const double s8_1250 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_x_x, s8_1249);
  const double s8_1251 = fnma(work.s4_28, s8_1250, work.s4_37*s8_1247);
  const double s8_1252 = work.s4_38 + s8_1251;
  work.s8_1253 = fnma(work.s3_34, s8_1250, fma(work.s8_700, s8_1247, work.s8_701));
  work.s8_1254 = fnma(work.s3_37, s8_1250, fma(work.s8_706, s8_1247, work.s8_707));
  const double s8_1255 = fnma(work.s3_40, s8_1250, fma(work.s8_712, s8_1247, work.s8_713));
  const double s8_1256 = fnma(work.s4_26, s8_1247, work.s4_28*s8_1243);
  const double s8_1257 = s8_1240 + s8_1256;
  const double s8_1258 = fma(work.s3_34, s8_1243, projection.Rz[39]*s8_1239);
  work.s8_1259 = fnma(work.s3_25, s8_1247, s8_1258);
  const double s8_1260 = fma(work.s3_37, s8_1243, projection.Rz[40]*s8_1239);
  work.s8_1261 = fnma(work.s3_28, s8_1247, s8_1260);
  const double s8_1262 = fma(work.s3_40, s8_1243, projection.Rz[41]*s8_1239);
  const double s8_1263 = fnma(work.s3_31, s8_1247, s8_1262);
  work.s8_1264 = 0.35 + (s8_1237 + s8_1250);
  work.s8_1265 = s8_1239 - work.r_carrier_left_aux1_y - s8_1247;
  work.s8_1266 = 1.1666666666666667*work.s8_1265;
  work.s8_1267 = 1.1666666666666667*work.s8_1264;
  const double s8_1268 = fnma(work.s4_37, s8_1243, work.s4_26*s8_1250);
  const double s8_1269 = s8_1238 + s8_1268 - work.s4_39;
  const double s8_1270 = fma(work.s3_25, s8_1250, fms(projection.Rz[39], s8_1237, work.s8_702));
  work.s8_1271 = fnma(work.s8_700, s8_1243, s8_1270);
  const double s8_1272 = fma(work.s3_28, s8_1250, fms(projection.Rz[40], s8_1237, work.s8_708));
  work.s8_1273 = fnma(work.s8_706, s8_1243, s8_1272);
  const double s8_1274 = fma(work.s3_31, s8_1250, fms(projection.Rz[41], s8_1237, work.s8_714));
  const double s8_1275 = fnma(work.s8_712, s8_1243, s8_1274);
  work.s8_1276 = 1.1666666666666667*work.s8_1244;
  const double s8_1277 = fnma(work.s8_22, work.s8_1264, fma(work.s8_21, work.s8_1265, s8_1115));
  const double s8_1278 = fma(work.s8_17, s8_1257, fma(work.s8_25, work.s8_1244, s8_1277));
  const double s8_1279 = fnma(work.s8_718, s8_1247, fnma(work.s8_18, s8_1269, s8_1278));
  const double s8_1280 = fnma(work.s4_37, s8_1268, fma(work.s6_48, s8_1250, s8_1279));
  work.s8_1281 = 1.1666666666666667*fma(work.s4_28, s8_1256, s8_1280);
  const double s8_1282 = fnma(work.s8_22, work.s8_1244, work.s8_20*work.s8_1265);
  const double s8_1283 = fma(zd_bell_crank, s8_1238, fma(work.s8_26, work.s8_1264, s8_1282));
  const double s8_1284 = fma(work.s4_26, s8_1268, fnma(work.s4_28, s8_1251, s8_1283));
  const double s8_1285 = fnma(projection.zdd_star[13], s8_1239, s8_1284);
  const double s8_1286 = fma(work.s6_36, s8_1247, fnma(work.s6_48, s8_1243, s8_1285));
  const double s8_1287 = fnma(work.s8_17, s8_1252, fma(work.s8_19, s8_1269, s8_1286));
  work.s8_1288 = 1.1666666666666667*s8_1287;
  const double s8_1289 = fnma(work.s8_21, work.s8_1244, fnma(work.s8_20, work.s8_1264, s8_1109));
  const double s8_1290 = fma(work.s8_18, s8_1252, fnma(work.s8_27, work.s8_1265, s8_1289));
  const double s8_1291 = fnma(work.s8_19, s8_1257, s8_1290);
  const double s8_1292 = fnma(projection.zdd_star[13], s8_1237, s8_1291);
  const double s8_1293 = fma(work.s8_718, s8_1243, fnma(work.s6_36, s8_1250, s8_1292));
  const double s8_1294 = fnma(work.s4_26, s8_1256, fnma(zd_bell_crank, s8_1240, s8_1293));
  work.s8_1295 = 1.1666666666666667*fma(work.s4_37, s8_1251, s8_1294);
  // tie_rod_right
  const double s8_1296 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s8_1236);
  const double s8_1297 = zd_bell_crank*s8_1296;
  const double s8_1298 = fnma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s8_1235);
  const double s8_1299 = zd_bell_crank*s8_1298;
  const double s8_1300 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s8_1301 = fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, s8_1300);
  const double s8_1302 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_z_x, s8_1301);
  work.s8_1303 = -p_bell_crank_z + (s8_1302 - work.s1_22);
  const double s8_1304 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s8_1305 = fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, s8_1304);
  const double s8_1306 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_y_x, s8_1305);
  work.s8_1307 = s8_1296 + (work.r_carrier_right_aux1_y + s8_1306);
  const double s8_1308 = p_tie_rod_right_to_z*work.R_carrier_right_x_z;
  const double s8_1309 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_x_x, s8_1308);
  const double s8_1310 = fnma(p_tie_rod_right_to_y, work.s1_24, s8_1309);
  const double s8_1311 = fnma(work.s4_32, s8_1310, work.s4_41*s8_1306);
  const double s8_1312 = work.s4_42 + s8_1311;
  work.s8_1313 = fnma(work.s3_52, s8_1310, fma(work.s8_703, s8_1306, work.s8_704));
  work.s8_1314 = fnma(work.s3_55, s8_1310, fma(work.s8_709, s8_1306, work.s8_710));
  const double s8_1315 = fnma(work.s3_58, s8_1310, fma(work.s8_715, s8_1306, work.s8_716));
  work.s8_1316 = s8_1298 - s8_1310 - 0.35;
  work.s8_1317 = 1.1666666666666667*work.s8_1316;
  work.s8_1318 = 1.1666666666666667*work.s8_1307;
  work.s8_1319 = 1.1666666666666667*work.s8_1303;
  const double s8_1320 = fnma(work.s3_52, s8_1302, projection.Rz[39]*s8_1296);
  work.s8_1321 = fma(work.s3_43, s8_1306, s8_1320);
  const double s8_1322 = fnma(work.s3_55, s8_1302, projection.Rz[40]*s8_1296);
  work.s8_1323 = fma(work.s3_46, s8_1306, s8_1322);
  const double s8_1324 = fnma(work.s3_58, s8_1302, projection.Rz[41]*s8_1296);
  const double s8_1325 = fma(work.s3_49, s8_1306, s8_1324);
  const double s8_1326 = work.s8_777 + (work.s8_755 + (work.s8_884 + (work.s8_925 + s8_1024)));
  const double s8_1327 = fma(-p_bell_crank_z, work.s8_723, s8_1326);
  const double s8_1328 = fma(-p_pitman_arm_z, work.s8_747, s8_1327);
  const double s8_1329 = fnma(p_pitman_arm_x, work.s8_746, s8_1328);
  const double s8_1330 = fnma(work.s1_22, work.s8_855, s8_1329);
  const double s8_1331 = fma(work.r_carrier_left_aux1_z, work.s8_991, s8_1330);
  const double s8_1332 = fnma(work.s8_1084, s8_1093, fnma(work.s8_1085, s8_1099, s8_1331));
  const double s8_1333 = fnma(work.s8_1146, s8_1156, fnma(work.s8_1147, s8_1162, s8_1332));
  const double s8_1334 = fnma(work.s8_1203, s8_1207, fma(s8_1195, work.s8_1204, s8_1333));
  const double s8_1335 = fma(s8_1255, work.s8_1267, fnma(s8_1263, work.s8_1276, s8_1334));
  const double s8_1336 = fnma(s8_1315, work.s8_1317, fma(work.s8_1319, s8_1325, s8_1335));
  const double s8_1337 = work.s8_861 + fma(projection.Rz[32], work.s7_229, s8_1038);
  const double s8_1338 = fma(projection.Rz[17], work.s7_160, work.s8_770);
  const double s8_1339 = fnma(p_lower_arm_left_x, s8_1337, s8_1336);
  const double s8_1340 = fma(projection.Rz[17], work.s7_164, work.s8_767);
  const double s8_1341 = fnma(-p_rear_axle_tx_z, s8_1338, s8_1339);
  work.s8_1342 = fma(p_arb_front_right_x, s8_1340, s8_1341);
  const double s8_1343 = fnma(work.s4_41, s8_1302, work.s4_30*s8_1310);
  const double s8_1344 = fnma(work.s4_30, s8_1306, work.s4_32*s8_1302);
  const double s8_1345 = fnma(work.s3_43, s8_1310, fms(projection.Rz[39], s8_1298, work.s8_705));
  work.s8_1346 = fma(work.s8_703, s8_1302, s8_1345);
  const double s8_1347 = fnma(work.s3_46, s8_1310, fms(projection.Rz[40], s8_1298, work.s8_711));
  work.s8_1348 = fma(work.s8_709, s8_1302, s8_1347);
  const double s8_1349 = fnma(work.s3_49, s8_1310, fms(projection.Rz[41], s8_1298, work.s8_717));
  const double s8_1350 = fma(work.s8_715, s8_1302, s8_1349);
  const double s8_1351 = work.s8_867 + (work.s8_790 + s8_1041);
  const double s8_1352 = fnma(projection.Rz[14], work.s7_147, s8_1351);
  const double s8_1353 = work.s8_877 + (work.s8_730 + work.s8_1017);
  const double s8_1354 = fnma(p_bell_crank_x, work.s8_726, s8_1353);
  const double s8_1355 = fma(p_pitman_arm_y, work.s8_747, s8_1354);
  const double s8_1356 = fma(projection.Rz[35], work.s7_248, s8_1355);
  const double s8_1357 = fnma(work.r_carrier_right_aux1_y, work.s8_855, s8_1356);
  const double s8_1358 = fnma(projection.Rz[17], work.s7_158, s8_1357);
  const double s8_1359 = fnma(work.r_carrier_left_aux1_y, work.s8_991, s8_1358);
  const double s8_1360 = fma(s8_1076, work.s8_1084, fma(work.s8_1083, s8_1099, s8_1359));
  const double s8_1361 = fnma(work.s8_1148, s8_1162, fma(s8_1143, work.s8_1146, s8_1360));
  const double s8_1362 = fnma(s8_1198, work.s8_1204, fma(work.s8_1200, s8_1207, s8_1361));
  const double s8_1363 = fnma(s8_1263, work.s8_1266, fnma(work.s8_1267, s8_1275, s8_1362));
  const double s8_1364 = fnma(work.s8_1318, s8_1325, fnma(work.s8_1317, s8_1350, s8_1363));
  const double s8_1365 = fnma(projection.Rz[2], work.s7_91, s8_1352);
  const double s8_1366 = fnma(projection.Rz[17], work.s7_160, work.s8_770);
  const double s8_1367 = fma(p_lower_arm_left_x, s8_1365, s8_1364);
  work.s8_1368 = fma(p_carrier_left_rz_y, s8_1366, s8_1367);
  const double s8_1369 = fma(projection.Rz[14], work.s7_145, work.s8_746);
  const double s8_1370 = work.s8_799 + (work.s8_910 + (work.s8_940 + (s8_1034 + s8_1054)));
  const double s8_1371 = fnma(-p_bell_crank_z, work.s8_726, work.s8_894 + s8_1370);
  const double s8_1372 = fnma(projection.Rz[35], work.s7_246, s8_1371);
  const double s8_1373 = fma(work.s1_22, work.s8_867, s8_1372);
  const double s8_1374 = fma(work.r_carrier_right_aux1_y, work.s8_861, s8_1373);
  const double s8_1375 = fnma(projection.Rz[17], work.s7_162, s8_1374);
  const double s8_1376 = fma(work.r_carrier_left_aux1_y, work.s8_999, s8_1375);
  const double s8_1377 = fnma(work.r_carrier_left_aux1_z, work.s8_1005, s8_1376);
  const double s8_1378 = fnma(s8_1076, work.s8_1085, fma(work.s8_1083, s8_1093, s8_1377));
  const double s8_1379 = fnma(s8_1143, work.s8_1147, fnma(work.s8_1148, s8_1156, s8_1378));
  const double s8_1380 = fnma(s8_1195, work.s8_1200, fma(s8_1198, work.s8_1203, s8_1379));
  const double s8_1381 = fma(s8_1255, work.s8_1266, fma(s8_1275, work.s8_1276, s8_1380));
  const double s8_1382 = fnma(work.s8_1319, s8_1350, fnma(s8_1315, work.s8_1318, s8_1381));
  const double s8_1383 = fnma(projection.Rz[32], work.s7_229, s8_1369);
  const double s8_1384 = fms(projection.Rz[2], work.s7_89, work.s8_898);
  const double s8_1385 = fma(-p_rear_axle_tx_z, s8_1383, s8_1382);
  const double s8_1386 = fnma(projection.Rz[17], work.s7_164, work.s8_767);
  const double s8_1387 = fma(p_lower_arm_left_y, s8_1384, s8_1385);
  const double s8_1388 = fnma(projection.Rz[2], work.s7_91, work.s8_901);
  const double s8_1389 = fma(p_carrier_left_rz_y, s8_1386, s8_1387);
  const double s8_1390 = fnma(projection.Rz[14], work.s7_147, work.s8_790);
  const double s8_1391 = fma(-p_lower_arm_left_z, s8_1388, s8_1389);
  work.s8_1392 = fma(-p_upper_arm_right_z, s8_1390, s8_1391);
  const double s8_1393 = s8_1299 - work.s4_43 - s8_1343;
  const double s8_1394 = fma(work.s8_1095, work.s8_1095, work.s8_1074*work.s8_1074);
  const double s8_1395 = fma(work.s8_1089, work.s8_1089, s8_1394);
  const double s8_1396 = fma(work.s8_1141, work.s8_1141, s8_1395);
  const double s8_1397 = fma(work.s8_1158, work.s8_1158, s8_1396);
  const double s8_1398 = fma(work.s8_1259, work.s8_1259, work.s8_1253*work.s8_1253);
  const double s8_1399 = fma(work.s8_1271, work.s8_1271, s8_1398);
  const double s8_1400 = fma(work.s8_1313, work.s8_1313, s8_1399);
  const double s8_1401 = fma(work.s8_1321, work.s8_1321, s8_1400);
  const double s8_1402 = fma(projection.Rz[36], work.s8_753, projection.Rz[39]*work.s8_728);
  const double s8_1403 = fma(projection.Rz[33], work.s8_775, s8_1402);
  const double s8_1404 = fma(projection.Rz[30], work.s8_797, s8_1403);
  const double s8_1405 = fma(work.s8_704, work.s8_857, fma(work.s8_705, work.s8_863, s8_1404));
  const double s8_1406 = fma(work.s3_43, work.s8_873, fma(work.s3_52, work.s8_880, s8_1405));
  const double s8_1407 = fma(work.s8_703, work.s8_888, s8_1406);
  const double s8_1408 = fma(projection.Rz[18], work.s8_908, s8_1407);
  const double s8_1409 = fma(projection.Rz[15], work.s8_923, s8_1408);
  const double s8_1410 = fma(projection.Rz[12], work.s8_938, s8_1409);
  const double s8_1411 = fnma(work.s8_702, work.s8_1001, fma(work.s8_701, work.s8_995, s8_1410));
  const double s8_1412 = fma(work.s3_25, work.s8_1013, fma(work.s3_34, work.s8_1020, s8_1411));
  const double s8_1413 = fma(work.s8_700, work.s8_1028, s8_1412);
  const double s8_1414 = fnma(1.5, s8_1209, fma(projection.Rz[0], work.s8_1052, s8_1413));
  const double s8_1415 = fma(work.s8_1152, work.s8_1152, s8_1397);
  const double s8_1416 = fnma(0.3333333333333333, s8_1415, s8_1414);
  const double s8_1417 = fma(work.s8_1346, work.s8_1346, s8_1401);
  work.s8_1418 = fnma(1.1666666666666667, s8_1417, s8_1416);
  const double s8_1419 = fma(work.s8_1095, s8_1099, work.s8_1074*s8_1076);
  const double s8_1420 = fma(work.s8_1141, s8_1143, fma(work.s8_1089, s8_1093, s8_1419));
  const double s8_1421 = fma(work.s8_1259, s8_1263, work.s8_1253*s8_1255);
  const double s8_1422 = fma(work.s8_1313, s8_1315, fma(work.s8_1271, s8_1275, s8_1421));
  const double s8_1423 = fma(projection.Rz[36], work.s8_755, projection.Rz[39]*work.s8_730);
  const double s8_1424 = fma(projection.Rz[33], work.s8_777, s8_1423);
  const double s8_1425 = fma(projection.Rz[30], work.s8_799, s8_1424);
  const double s8_1426 = fma(work.s8_704, work.s8_861, fma(work.s8_705, work.s8_867, s8_1425));
  const double s8_1427 = fma(work.s3_43, work.s8_877, fma(work.s3_52, work.s8_884, s8_1426));
  const double s8_1428 = fma(work.s8_703, work.s8_894, s8_1427);
  const double s8_1429 = fma(projection.Rz[18], work.s8_910, s8_1428);
  const double s8_1430 = fma(projection.Rz[15], work.s8_925, s8_1429);
  const double s8_1431 = fma(projection.Rz[12], work.s8_940, s8_1430);
  const double s8_1432 = fnma(work.s8_702, work.s8_1005, fma(work.s8_701, work.s8_999, s8_1431));
  const double s8_1433 = fma(work.s3_25, work.s8_1017, fma(work.s3_34, s8_1024, s8_1432));
  const double s8_1434 = fma(projection.Rz[0], s8_1054, fma(work.s8_700, s8_1034, s8_1433));
  const double s8_1435 = fma(work.s8_1152, s8_1156, fma(work.s8_1158, s8_1162, s8_1420));
  const double s8_1436 = fma(work.s8_1346, s8_1350, fma(work.s8_1321, s8_1325, s8_1422));
  const double s8_1437 = fnma(0.3333333333333333, s8_1435, fnma(1.5, s8_1213, s8_1434));
  work.s8_1438 = fnma(1.1666666666666667, s8_1436, s8_1437);
  const double s8_1439 = fma(work.s8_1097, work.s8_1097, work.s8_1075*work.s8_1075);
  const double s8_1440 = fma(work.s8_1091, work.s8_1091, s8_1439);
  const double s8_1441 = fma(work.s8_1142, work.s8_1142, s8_1440);
  const double s8_1442 = fma(work.s8_1160, work.s8_1160, s8_1441);
  const double s8_1443 = fma(work.s8_1261, work.s8_1261, work.s8_1254*work.s8_1254);
  const double s8_1444 = fma(work.s8_1273, work.s8_1273, s8_1443);
  const double s8_1445 = fma(work.s8_1314, work.s8_1314, s8_1444);
  const double s8_1446 = fma(work.s8_1323, work.s8_1323, s8_1445);
  const double s8_1447 = fma(projection.Rz[37], work.s8_754, projection.Rz[40]*work.s8_729);
  const double s8_1448 = fma(projection.Rz[34], work.s8_776, s8_1447);
  const double s8_1449 = fma(projection.Rz[31], work.s8_798, s8_1448);
  const double s8_1450 = fma(work.s8_710, work.s8_859, fma(work.s8_711, work.s8_865, s8_1449));
  const double s8_1451 = fma(work.s3_46, work.s8_875, fma(work.s3_55, work.s8_882, s8_1450));
  const double s8_1452 = fma(work.s8_709, work.s8_891, s8_1451);
  const double s8_1453 = fma(projection.Rz[19], work.s8_909, s8_1452);
  const double s8_1454 = fma(projection.Rz[16], work.s8_924, s8_1453);
  const double s8_1455 = fma(projection.Rz[13], work.s8_939, s8_1454);
  const double s8_1456 = fnma(work.s8_708, work.s8_1003, fma(work.s8_707, work.s8_997, s8_1455));
  const double s8_1457 = fma(work.s3_28, work.s8_1015, fma(work.s3_37, work.s8_1022, s8_1456));
  const double s8_1458 = fma(work.s8_706, work.s8_1031, s8_1457);
  const double s8_1459 = fnma(1.5, s8_1215, fma(projection.Rz[1], work.s8_1053, s8_1458));
  const double s8_1460 = fma(work.s8_1154, work.s8_1154, s8_1442);
  const double s8_1461 = fnma(0.3333333333333333, s8_1460, s8_1459);
  const double s8_1462 = fma(work.s8_1348, work.s8_1348, s8_1446);
  work.s8_1463 = fnma(1.1666666666666667, s8_1462, s8_1461);
  const double s8_1464 = fma(work.s8_1097, s8_1099, work.s8_1075*s8_1076);
  const double s8_1465 = fma(work.s8_1142, s8_1143, fma(work.s8_1091, s8_1093, s8_1464));
  const double s8_1466 = fma(work.s8_1261, s8_1263, work.s8_1254*s8_1255);
  const double s8_1467 = fma(work.s8_1314, s8_1315, fma(work.s8_1273, s8_1275, s8_1466));
  const double s8_1468 = fma(projection.Rz[37], work.s8_755, projection.Rz[40]*work.s8_730);
  const double s8_1469 = fma(projection.Rz[34], work.s8_777, s8_1468);
  const double s8_1470 = fma(projection.Rz[31], work.s8_799, s8_1469);
  const double s8_1471 = fma(work.s8_710, work.s8_861, fma(work.s8_711, work.s8_867, s8_1470));
  const double s8_1472 = fma(work.s3_46, work.s8_877, fma(work.s3_55, work.s8_884, s8_1471));
  const double s8_1473 = fma(work.s8_709, work.s8_894, s8_1472);
  const double s8_1474 = fma(projection.Rz[19], work.s8_910, s8_1473);
  const double s8_1475 = fma(projection.Rz[16], work.s8_925, s8_1474);
  const double s8_1476 = fma(projection.Rz[13], work.s8_940, s8_1475);
  const double s8_1477 = fnma(work.s8_708, work.s8_1005, fma(work.s8_707, work.s8_999, s8_1476));
  const double s8_1478 = fma(work.s3_28, work.s8_1017, fma(work.s3_37, s8_1024, s8_1477));
  const double s8_1479 = fma(projection.Rz[1], s8_1054, fma(work.s8_706, s8_1034, s8_1478));
  const double s8_1480 = fma(work.s8_1154, s8_1156, fma(work.s8_1160, s8_1162, s8_1465));
  const double s8_1481 = fma(work.s8_1348, s8_1350, fma(work.s8_1323, s8_1325, s8_1467));
  const double s8_1482 = fnma(0.3333333333333333, s8_1480, fnma(1.5, s8_1217, s8_1479));
  work.s8_1483 = fnma(1.1666666666666667, s8_1481, s8_1482);
  const double s8_1484 = fma(s8_1093, s8_1093, fma(s8_1099, s8_1099, s8_1076*s8_1076));
  const double s8_1485 = fma(s8_1162, s8_1162, fma(s8_1143, s8_1143, s8_1484));
  const double s8_1486 = fma(s8_1275, s8_1275, fma(s8_1263, s8_1263, s8_1255*s8_1255));
  const double s8_1487 = fma(s8_1325, s8_1325, fma(s8_1315, s8_1315, s8_1486));
  const double s8_1488 = fma(projection.Rz[38], work.s8_755, projection.Rz[41]*work.s8_730);
  const double s8_1489 = fma(projection.Rz[35], work.s8_777, s8_1488);
  const double s8_1490 = fma(projection.Rz[32], work.s8_799, s8_1489);
  const double s8_1491 = fma(work.s8_716, work.s8_861, fma(work.s8_717, work.s8_867, s8_1490));
  const double s8_1492 = fma(work.s3_49, work.s8_877, fma(work.s3_58, work.s8_884, s8_1491));
  const double s8_1493 = fma(work.s8_715, work.s8_894, s8_1492);
  const double s8_1494 = fma(projection.Rz[20], work.s8_910, s8_1493);
  const double s8_1495 = fma(projection.Rz[17], work.s8_925, s8_1494);
  const double s8_1496 = fma(projection.Rz[14], work.s8_940, s8_1495);
  const double s8_1497 = fnma(work.s8_714, work.s8_1005, fma(work.s8_713, work.s8_999, s8_1496));
  const double s8_1498 = fma(work.s3_31, work.s8_1017, fma(work.s3_40, s8_1024, s8_1497));
  const double s8_1499 = fma(projection.Rz[2], s8_1054, fma(work.s8_712, s8_1034, s8_1498));
  const double s8_1500 = fma(s8_1156, s8_1156, s8_1485);
  const double s8_1501 = fnma(0.3333333333333333, s8_1500, fnma(1.5, s8_1218, s8_1499));
  work.s8_1502 = fnma(1.1666666666666667, fma(s8_1350, s8_1350, s8_1487), s8_1501);
  const double s8_1503 = s8_1297 - s8_1344;
  const double s8_1504 = fnma(work.s1_21, work.s6_16, fms(work.s8_22, work.s8_1316, work.s8_720));
  const double s8_1505 = fnma(work.s8_21, work.s8_1307, fma(work.s8_25, work.s8_1303, s8_1504));
  const double s8_1506 = fnma(work.s8_17, s8_1503, fma(work.s8_18, s8_1393, s8_1505));
  const double s8_1507 = fma(work.s6_53, s8_1310, fnma(work.s8_719, s8_1306, s8_1506));
  const double s8_1508 = fma(work.s4_32, s8_1344, fnma(work.s4_41, s8_1343, s8_1507));
  work.s8_1509 = 1.1666666666666667*s8_1508;
  const double s8_1510 = fnma(work.s6_53, s8_1302, projection.zdd_star[13]*s8_1296);
  const double s8_1511 = fnma(zd_bell_crank, s8_1299, fma(work.s6_43, s8_1306, s8_1510));
  const double s8_1512 = fma(work.s4_30, s8_1343, fnma(work.s4_32, s8_1311, s8_1511));
  const double s8_1513 = fnma(work.s8_19, s8_1393, fnma(work.s8_17, s8_1312, s8_1512));
  const double s8_1514 = fnma(work.s8_22, work.s8_1303, fnma(work.s8_20, work.s8_1307, s8_1513));
  work.s8_1515 = 1.1666666666666667*fnma(work.s8_26, work.s8_1316, s8_1514);
  const double s8_1516 = fma(work.s8_20, work.s8_1316, fma(work.s8_27, work.s8_1307, s8_1165));
  const double s8_1517 = fma(work.s8_18, s8_1312, fnma(work.s8_21, work.s8_1303, s8_1516));
  const double s8_1518 = fma(projection.zdd_star[13], s8_1298, fma(work.s8_19, s8_1503, s8_1517));
  const double s8_1519 = fma(work.s8_719, s8_1302, fnma(work.s6_43, s8_1310, s8_1518));
  const double s8_1520 = fnma(work.s4_30, s8_1344, fma(zd_bell_crank, s8_1297, s8_1519));
  work.s8_1521 = 1.1666666666666667*fma(work.s4_41, s8_1311, s8_1520);
  const double s8_1522 = fnma(projection.zdd_star[0], work.s7_99, tau[Coordinate::lower_arm_left]);
  const double s8_1523 = fma(work.s7_91, s8_1058, fnma(work.s7_89, s8_1056, s8_1522));
  work.s8_1524 = fnma(work.s7_96, work.s8_811, fnma(work.s8_21, s8_1059, s8_1523));
  const double s8_1525 = fnma(projection.zdd_star[4], work.s7_155, tau[Coordinate::upper_arm_left]);
  const double s8_1526 = fma(work.s7_147, work.s8_947, fnma(work.s7_145, work.s8_945, s8_1525));
  work.s8_1527 = fnma(work.s7_152, work.s8_811, fnma(work.s8_21, work.s8_948, s8_1526));
  const double s8_1528 = fnma(projection.zdd_star[5], work.s7_172, tau[Coordinate::arb_front_left]);
  const double s8_1529 = fma(work.s7_164, work.s8_932, fnma(work.s7_160, work.s8_930, s8_1528));
  const double s8_1530 = fma(work.s8_21, work.s7_162, fnma(work.s8_20, work.s7_158, s8_1529));
  work.s8_1531 = fnma(work.s8_47, work.s7_169, fnma(work.s8_22, work.s8_933, s8_1530));
  const double s8_1532 = fnma(projection.zdd_star[6], work.s7_185,
      tau[Coordinate::lower_arm_right]);
  const double s8_1533 = fnma(work.s7_175, work.s8_917, fnma(work.s7_177, work.s8_915, s8_1532));
  work.s8_1534 = fnma(work.s7_182, work.s8_811, fnma(work.s8_21, work.s8_918, s8_1533));
  const double s8_1535 = fnma(projection.zdd_star[10], work.s7_239,
      tau[Coordinate::upper_arm_right]);
  const double s8_1536 = fnma(work.s7_229, work.s8_809, fnma(work.s7_231, work.s8_806, s8_1535));
  work.s8_1537 = fnma(work.s7_236, work.s8_811, fnma(work.s8_21, work.s8_810, s8_1536));
  const double s8_1538 = fnma(projection.zdd_star[11], work.s7_256,
      tau[Coordinate::arb_front_right]);
  const double s8_1539 = fma(work.s8_21, work.s7_246, fma(work.s8_20, work.s7_248, s8_1538));
  const double s8_1540 = fma(work.s7_244, work.s8_786, fma(work.s7_242, work.s8_781, s8_1539));
  work.s8_1541 = fnma(work.s8_47, work.s7_253, fnma(work.s8_22, work.s8_787, s8_1540));
  const double s8_1542 = fnma(projection.zdd_star[12], work.s7_265, tau[Coordinate::pitman_arm]);
  const double s8_1543 = fma(work.s7_259, work.s8_763, fnma(work.s7_258, work.s8_761, s8_1542));
  work.s8_1544 = fnma(work.s8_47, work.s7_262, fnma(work.s8_22, work.s8_764, s8_1543));
  const double s8_1545 = fnma(projection.zdd_star[13], work.s7_279, tau[Coordinate::bell_crank]);
  const double s8_1546 = fma(work.s7_271, work.s8_736, fnma(work.s7_267, work.s8_732, s8_1545));
  work.s8_1547 = fnma(work.s7_273, work.s8_741, fnma(work.s8_20, work.s8_740, s8_1546));
  work.s8_1548 = work.s7_16 - work.n_carrier_left_z;
  work.s8_1549 = work.s7_19 - work.n_carrier_left_y;
  work.s8_1550 = work.s7_24 - work.n_carrier_right_z;
  work.s8_1551 = work.s7_27 - work.n_carrier_right_y;
  const double s8_1552 = fma(work.s7_21, work.s3_16, work.s7_30*work.s3_22);
  const double s8_1553 = fnma(work.s8_717, work.f_carrier_right_y, s8_1552);
  const double s8_1554 = fnma(work.s8_716, work.f_carrier_right_z, s8_1553);
  const double s8_1555 = fnma(work.s8_715, work.n_carrier_right_x, s8_1554);
  const double s8_1556 = fnma(work.s8_713, work.f_carrier_left_z, s8_1555);
  const double s8_1557 = fma(work.s8_714, work.f_carrier_left_y, s8_1556);
  const double s8_1558 = fnma(work.s8_712, work.n_carrier_left_x, s8_1557);
  const double s8_1559 = fnma(s8_1093, work.s8_1122, fnma(s8_1076, work.s8_1114, s8_1558));
  const double s8_1560 = fnma(s8_1143, work.s8_1170, fma(s8_1099, work.s8_1108, s8_1559));
  const double s8_1561 = fma(s8_1162, work.s8_1177, fnma(s8_1156, work.s8_1184, s8_1560));
  const double s8_1562 = fma(s8_1195, work.s8_1230, fma(s8_1198, work.s8_1234, s8_1561));
  const double s8_1563 = fnma(s8_1255, work.s8_1281, fma(s8_1207, work.s8_1224, s8_1562));
  const double s8_1564 = fnma(s8_1275, work.s8_1295, fnma(s8_1263, work.s8_1288, s8_1563));
  const double s8_1565 = fma(s8_1325, work.s8_1515, fnma(s8_1315, work.s8_1509, s8_1564));
  const double s8_1566 = fma(projection.Rz[2], work.s8_1524, fma(s8_1350, work.s8_1521, s8_1565));
  const double s8_1567 = fma(projection.Rz[14], work.s8_1527, s8_1566);
  const double s8_1568 = fma(projection.Rz[17], work.s8_1531, s8_1567);
  const double s8_1569 = fma(projection.Rz[20], work.s8_1534, s8_1568);
  const double s8_1570 = fma(projection.Rz[32], work.s8_1537, s8_1569);
  const double s8_1571 = fma(projection.Rz[35], work.s8_1541, s8_1570);
  const double s8_1572 = fma(projection.Rz[38], work.s8_1544, s8_1571);
  const double s8_1573 = fma(projection.Rz[41], work.s8_1547, s8_1572);
  const double s8_1574 = fma(work.s3_40, work.s8_1549, fma(work.s3_31, work.s8_1548, s8_1573));
  work.s8_1575 = fma(work.s3_58, work.s8_1551, fma(work.s3_49, work.s8_1550, s8_1574));
  const double s8_1576 = work.s8_49 + (work.s7_164 + work.s7_244) - work.s7_271 - work.s7_258;
  work.s8_1577 = 471.925 + s8_1576;
  const double s8_1578 = work.s8_782 + work.s8_921;
  const double s8_1579 = work.s7_262 + (work.s8_67 + (work.s7_169 + work.s7_253)) - 90.9075;
  const double s8_1580 = fnma(-p_pitman_arm_z, work.s8_757, s8_1579);
  const double s8_1581 = fnma(p_pitman_arm_x, work.s8_749, s8_1580);
  const double s8_1582 = work.s8_936 + s8_1047 - work.s8_791 - work.s8_903;
  const double s8_1583 = fnma(-p_bell_crank_z, work.s8_735, s8_1581);
  const double s8_1584 = fma(p_lower_arm_left_x, s8_1582, s8_1583);
  const double s8_1585 = fnma(-p_rear_axle_tx_z, s8_1578, s8_1584);
  work.s8_1586 = fma(p_arb_front_right_x, work.s8_773 + work.s8_919, s8_1585);
  const double s8_1587 = 11.55 + (work.s7_273 + (work.s8_69 + (work.s7_162 + work.s7_246)));
  const double s8_1588 = fma(p_bell_crank_x, work.s7_267, s8_1587);
  const double s8_1589 = work.s8_911 + (work.s8_794 + (work.s8_935 + s8_1046));
  const double s8_1590 = fma(p_pitman_arm_y, work.s8_757, s8_1588);
  const double s8_1591 = fma(p_lower_arm_left_x, s8_1589, s8_1590);
  work.s8_1592 = fma(p_carrier_left_rz_y, work.s8_921 - work.s8_782, s8_1591);
  const double s8_1593 = work.s7_236 + (work.s7_182 + (work.s7_158 + (work.s7_96 + work.s7_152)));
  const double s8_1594 = work.s8_70 + s8_1593 - work.s7_248 - 1.05;
  const double s8_1595 = fnma(-p_bell_crank_z, work.s7_267, s8_1594);
  const double s8_1596 = fma(-p_rear_axle_tx_z, work.s8_791 + work.s8_936 - work.s8_749, s8_1595);
  const double s8_1597 = fma(p_lower_arm_left_y, work.s8_903 + s8_1047, s8_1596);
  const double s8_1598 = fma(p_carrier_left_rz_y, work.s8_919 - work.s8_773, s8_1597);
  const double s8_1599 = fnma(-p_lower_arm_left_z, work.s8_911 + s8_1046, s8_1598);
  work.s8_1600 = fnma(-p_upper_arm_right_z, work.s8_794 + work.s8_935, s8_1599);
  const double s8_1601 = work.r_carrier_left_aux1_y + work.r_carrier_right_aux1_y;
  const double s8_1602 = work.s7_195 + (work.s8_120 + work.s7_106);
  work.s8_1603 = fma(m_carrier_right_2, s8_1601, s8_1602);
  work.s8_1604 = 1580.4 + (work.s7_189 + (work.s8_121 + work.s7_109));
  const double s8_1605 = work.s7_192 + (work.s8_122 + work.s7_103);
  work.s8_1606 = fma(m_carrier_right_2, work.r_carrier_left_aux1_z - work.s1_22, s8_1605);
  const double s8_1607 = work.s7_210 + (work.s8_398 + work.s7_124);
  const double s8_1608 = fma(work.r_carrier_right_aux1_y, work.s8_870, s8_1607);
  const double s8_1609 = fnma(work.s1_22, work.s8_869, s8_1608);
  const double s8_1610 = fma(work.r_carrier_left_aux1_y, work.s8_1006, s8_1609);
  const double s8_1611 = fma(work.r_carrier_left_aux1_z, work.s8_1007, s8_1610);
  const double s8_1612 = fnma(work.s8_1077, work.s8_1083, s8_1611);
  const double s8_1613 = fma(work.s8_1144, work.s8_1148, s8_1612);
  const double s8_1614 = fnma(work.s8_1200, work.s8_1201, s8_1613);
  const double s8_1615 = fma(work.s8_1244, work.s8_1266, s8_1614);
  work.s8_1616 = fnma(work.s8_1303, work.s8_1318, s8_1615);
  const double s8_1617 = fnma(work.s1_22, work.s8_868, work.s7_218 + (work.s8_416 + work.s7_133));
  const double s8_1618 = fma(work.r_carrier_left_aux1_z, work.s8_1008, s8_1617);
  const double s8_1619 = fnma(work.s8_1077, work.s8_1084, s8_1618);
  const double s8_1620 = fnma(work.s8_1144, work.s8_1146, s8_1619);
  const double s8_1621 = fnma(work.s8_1201, work.s8_1204, s8_1620);
  const double s8_1622 = fnma(work.s8_1244, work.s8_1267, s8_1621);
  const double s8_1623 = fma(work.s8_1303, work.s8_1317, s8_1622);
  work.s8_1624 = fma(p_lower_arm_left_x, work.s8_870 + work.s8_1006, s8_1623);
  const double s8_1625 = work.s7_220 + (work.s8_420 + work.s7_136);
  const double s8_1626 = fma(work.r_carrier_right_aux1_y, work.s8_868, s8_1625);
  const double s8_1627 = fma(work.r_carrier_left_aux1_y, work.s8_1008, s8_1626);
  const double s8_1628 = fnma(work.s8_1082, work.s8_1084, s8_1627);
  const double s8_1629 = fma(work.s8_1132, work.s8_1146, s8_1628);
  const double s8_1630 = fnma(work.s8_1199, work.s8_1204, s8_1629);
  const double s8_1631 = fma(work.s8_1265, work.s8_1267, s8_1630);
  const double s8_1632 = fma(work.s8_1307, work.s8_1317, s8_1631);
  work.s8_1633 = fma(p_lower_arm_left_x, work.s8_869 + work.s8_1007, s8_1632);
  const double s8_1634 = work.s7_242 + (work.s7_160 + (work.s7_91 + work.s7_147)) - work.s7_259;
  work.s8_1635 = s8_1634 - work.s7_231 - work.s7_177 - work.s8_54 - 64.9;
  result.inertia[8] = fnma(1e-12, work.s8_1502, work.s8_1502);
  const double s8_1636 = work.s7_238 + (work.s7_184 + (work.s7_171 + (work.s7_98 + work.s7_154)));
  const double s8_1637 = work.s7_278 + (work.s8_72 + (work.s7_264 + (work.s7_255 + s8_1636)));
  const double s8_1638 = 7.380000000000001 + (s8_1637 - work.s8_773 - work.s8_919);
  const double s8_1639 = fma(0.56, work.s8_791 - work.s8_936, fma(0.8, work.s8_749, s8_1638));
  work.s8_1640 = fma(1.24, work.s8_903 - s8_1047, s8_1639);
  const double s8_1641 = work.s7_237 + (work.s7_183 + (work.s7_153 + (work.s7_97 + work.s8_935)));
  const double s8_1642 = 12.8518 + (work.s7_277 + s8_1641 - work.s8_794);
  work.s8_1643 = fma(0.8, s8_1046 - work.s8_911, s8_1642);
  const double s8_1644 = work.s7_274 + (work.s8_74 + (work.s7_263 + (work.s7_170 + work.s7_254)));
  const double s8_1645 = fma(8.8, work.s8_757, fma(6.5, work.s8_735, 1037.4 + s8_1644));
  work.s8_1646 = fma(7.9, s8_1578, s8_1645);
  const double s8_1647 = work.s7_226 + (work.s8_453 + work.s7_142);
  const double s8_1648 = fma(work.s8_1006, work.s8_1009, fnma(work.s8_852, work.s8_870, s8_1647));
  const double s8_1649 = fnma(work.s8_1077, work.s8_1085, s8_1648);
  const double s8_1650 = fnma(work.s8_1144, work.s8_1147, s8_1649);
  const double s8_1651 = fnma(work.s8_1201, work.s8_1203, s8_1650);
  const double s8_1652 = fnma(work.s8_1244, work.s8_1276, s8_1651);
  work.s8_1653 = fnma(work.s8_1303, work.s8_1319, s8_1652);
  const double s8_1654 = fma(work.s8_869, work.s8_895, work.s7_225 + (work.s8_456 + work.s7_139));
  const double s8_1655 = fma(work.s8_1007, work.s8_1010, s8_1654);
  const double s8_1656 = fnma(work.s8_1082, work.s8_1083, s8_1655);
  const double s8_1657 = fnma(work.s8_1132, work.s8_1148, s8_1656);
  const double s8_1658 = fnma(work.s8_1199, work.s8_1200, s8_1657);
  const double s8_1659 = fnma(work.s8_1265, work.s8_1266, s8_1658);
  work.s8_1660 = fnma(work.s8_1307, work.s8_1318, s8_1659);
  work.s8_1661 = work.s8_868 + work.s8_1008;
  work.s8_1662 = work.s8_459 + work.s7_141;
}

/// Part 5 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63); step 9:
/// accelerations from the root to the leaves (63), (62).
[[gnu::noinline]] void compute_chosen_accelerations_5(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_1663 = fnma(work.s8_1078, work.s8_1084, work.s7_222 + work.s8_1662);
  const double s8_1664 = fnma(work.s8_1145, work.s8_1146, s8_1663);
  const double s8_1665 = fnma(work.s8_1202, work.s8_1204, s8_1664);
  const double s8_1666 = fnma(work.s8_1264, work.s8_1267, s8_1665);
  const double s8_1667 = fma(7.2, work.s8_1661, fnma(work.s8_1316, work.s8_1317, s8_1666));
  const double s8_1668 = 1.0/work.s8_1502;
  const double s8_1669 = work.s8_1483*s8_1668;
  const double s8_1670 = fnma(work.s8_1483, s8_1669, work.s8_1463);
  result.inertia[7] = fnma(1e-12, work.s8_1463, s8_1670);
  const double s8_1671 = work.s8_1438*s8_1668;
  const double s8_1672 = fma(work.s8_1095, work.s8_1097, work.s8_1074*work.s8_1075);
  const double s8_1673 = fma(work.s8_1089, work.s8_1091, s8_1672);
  const double s8_1674 = fma(work.s8_1141, work.s8_1142, s8_1673);
  const double s8_1675 = fma(work.s8_1158, work.s8_1160, s8_1674);
  const double s8_1676 = fma(work.s8_1259, work.s8_1261, work.s8_1253*work.s8_1254);
  const double s8_1677 = fma(work.s8_1271, work.s8_1273, s8_1676);
  const double s8_1678 = fma(work.s8_1313, work.s8_1314, s8_1677);
  const double s8_1679 = fma(work.s8_1321, work.s8_1323, s8_1678);
  const double s8_1680 = fma(projection.Rz[36], work.s8_754, projection.Rz[39]*work.s8_729);
  const double s8_1681 = fma(projection.Rz[33], work.s8_776, s8_1680);
  const double s8_1682 = fma(projection.Rz[30], work.s8_798, s8_1681);
  const double s8_1683 = fma(work.s8_704, work.s8_859, fma(work.s8_705, work.s8_865, s8_1682));
  const double s8_1684 = fma(work.s3_43, work.s8_875, fma(work.s3_52, work.s8_882, s8_1683));
  const double s8_1685 = fma(work.s8_703, work.s8_891, s8_1684);
  const double s8_1686 = fma(projection.Rz[18], work.s8_909, s8_1685);
  const double s8_1687 = fma(projection.Rz[15], work.s8_924, s8_1686);
  const double s8_1688 = fma(projection.Rz[12], work.s8_939, s8_1687);
  const double s8_1689 = fnma(work.s8_702, work.s8_1003, fma(work.s8_701, work.s8_997, s8_1688));
  const double s8_1690 = fma(work.s3_25, work.s8_1015, fma(work.s3_34, work.s8_1022, s8_1689));
  const double s8_1691 = fma(work.s8_700, work.s8_1031, s8_1690);
  const double s8_1692 = fnma(1.5, work.s8_1211, fma(projection.Rz[0], work.s8_1053, s8_1691));
  const double s8_1693 = fma(work.s8_1152, work.s8_1154, s8_1675);
  const double s8_1694 = fnma(0.3333333333333333, s8_1693, fnma(work.s8_1438, s8_1669, s8_1692));
  const double s8_1695 = fma(work.s8_1346, work.s8_1348, s8_1679);
  const double s8_1696 = fnma(1.1666666666666667, s8_1695, s8_1694);
  const double s8_1697 = 1.0/s8_1670;
  const double s8_1698 = s8_1696*s8_1697;
  const double s8_1699 = fnma(s8_1696, s8_1698, fnma(work.s8_1438, s8_1671, work.s8_1418));
  result.inertia[6] = fnma(1e-12, work.s8_1418, s8_1699);
  const double s8_1700 = work.s8_854 + fma(projection.Rz[16], work.s7_160, work.s8_990);
  const double s8_1701 = work.s8_769 + s8_1700 - work.s8_722 - work.s8_745;
  const double s8_1702 = fnma(work.s8_993, s8_1669, s8_1701);
  const double s8_1703 = work.s8_853 + fma(projection.Rz[15], work.s7_160, work.s8_989);
  const double s8_1704 = work.s8_768 + s8_1703 - work.s8_721 - work.s8_743;
  const double s8_1705 = fnma(s8_1698, s8_1702, fnma(work.s8_993, s8_1671, s8_1704));
  const double s8_1706 = 1.0/s8_1699;
  const double s8_1707 = s8_1705*s8_1706;
  const double s8_1708 = fma(projection.Rz[1], work.s7_89, work.s8_997);
  const double s8_1709 = work.s8_897 + fma(projection.Rz[13], work.s7_145, s8_1708);
  const double s8_1710 = work.s8_744 + fma(projection.Rz[31], work.s7_229, work.s8_859 + s8_1709);
  const double s8_1711 = fnma(projection.Rz[16], work.s7_164, s8_1710 - work.s8_766);
  const double s8_1712 = fnma(work.s8_1040, s8_1669, s8_1711);
  const double s8_1713 = fma(projection.Rz[0], work.s7_89, work.s8_995);
  const double s8_1714 = work.s8_896 + fma(projection.Rz[12], work.s7_145, s8_1713);
  const double s8_1715 = work.s8_742 + fma(projection.Rz[30], work.s7_229, work.s8_857 + s8_1714);
  const double s8_1716 = fnma(projection.Rz[15], work.s7_164, s8_1715 - work.s8_765);
  const double s8_1717 = fnma(s8_1698, s8_1712, fnma(work.s8_1040, s8_1671, s8_1716));
  const double s8_1718 = s8_1706*s8_1717;
  const double s8_1719 = work.s8_900 + work.s8_1003;
  const double s8_1720 = work.s8_789 + (work.s8_865 + s8_1719) - work.s8_725;
  const double s8_1721 = fnma(projection.Rz[13], work.s7_147, s8_1720);
  const double s8_1722 = fnma(work.s8_1044, s8_1669, fnma(projection.Rz[1], work.s7_91, s8_1721));
  const double s8_1723 = work.s8_899 + work.s8_1001;
  const double s8_1724 = work.s8_788 + (work.s8_863 + s8_1723) - work.s8_724;
  const double s8_1725 = fnma(projection.Rz[12], work.s7_147, s8_1724);
  const double s8_1726 = fnma(work.s8_1044, s8_1671, fnma(projection.Rz[0], work.s7_91, s8_1725));
  const double s8_1727 = fnma(s8_1698, s8_1722, s8_1726);
  const double s8_1728 = s8_1706*s8_1727;
  const double s8_1729 = work.s8_754 + (work.s8_882 + (work.s8_924 + work.s8_1022));
  const double s8_1730 = fma(-p_bell_crank_z, work.s8_722, work.s8_776 + s8_1729);
  const double s8_1731 = fma(-p_pitman_arm_z, work.s8_745, s8_1730);
  const double s8_1732 = fnma(p_pitman_arm_x, work.s8_744, s8_1731);
  const double s8_1733 = fnma(work.s1_22, work.s8_854, s8_1732);
  const double s8_1734 = fma(work.r_carrier_left_aux1_z, work.s8_990, s8_1733);
  const double s8_1735 = fnma(work.s8_1085, work.s8_1097, s8_1734);
  const double s8_1736 = fnma(work.s8_1084, work.s8_1091, s8_1735);
  const double s8_1737 = fnma(work.s8_1147, work.s8_1160, s8_1736);
  const double s8_1738 = fnma(work.s8_1146, work.s8_1154, s8_1737);
  const double s8_1739 = fma(work.s8_1194, work.s8_1204, s8_1738);
  const double s8_1740 = fnma(work.s8_1203, work.s8_1206, s8_1739);
  const double s8_1741 = fnma(work.s8_1261, work.s8_1276, s8_1740);
  const double s8_1742 = fma(work.s8_1254, work.s8_1267, s8_1741);
  const double s8_1743 = fma(work.s8_1319, work.s8_1323, s8_1742);
  const double s8_1744 = fnma(work.s8_1342, s8_1669, fnma(work.s8_1314, work.s8_1317, s8_1743));
  const double s8_1745 = work.s8_859 + fma(projection.Rz[31], work.s7_229, s8_1709);
  const double s8_1746 = fma(projection.Rz[16], work.s7_160, work.s8_769);
  const double s8_1747 = fnma(p_lower_arm_left_x, s8_1745, s8_1744);
  const double s8_1748 = fma(projection.Rz[16], work.s7_164, work.s8_766);
  const double s8_1749 = fnma(-p_rear_axle_tx_z, s8_1746, s8_1747);
  const double s8_1750 = fma(p_arb_front_right_x, s8_1748, s8_1749);
  const double s8_1751 = work.s8_753 + (work.s8_880 + (work.s8_923 + work.s8_1020));
  const double s8_1752 = fma(-p_bell_crank_z, work.s8_721, work.s8_775 + s8_1751);
  const double s8_1753 = fma(-p_pitman_arm_z, work.s8_743, s8_1752);
  const double s8_1754 = fnma(p_pitman_arm_x, work.s8_742, s8_1753);
  const double s8_1755 = fnma(work.s1_22, work.s8_853, s8_1754);
  const double s8_1756 = fma(work.r_carrier_left_aux1_z, work.s8_989, s8_1755);
  const double s8_1757 = fnma(work.s8_1085, work.s8_1095, s8_1756);
  const double s8_1758 = fnma(work.s8_1084, work.s8_1089, s8_1757);
  const double s8_1759 = fnma(work.s8_1147, work.s8_1158, s8_1758);
  const double s8_1760 = fnma(work.s8_1146, work.s8_1152, s8_1759);
  const double s8_1761 = fma(work.s8_1193, work.s8_1204, s8_1760);
  const double s8_1762 = fnma(work.s8_1203, work.s8_1205, s8_1761);
  const double s8_1763 = fnma(work.s8_1259, work.s8_1276, s8_1762);
  const double s8_1764 = fma(work.s8_1253, work.s8_1267, s8_1763);
  const double s8_1765 = fma(work.s8_1319, work.s8_1321, s8_1764);
  const double s8_1766 = fnma(work.s8_1342, s8_1671, fnma(work.s8_1313, work.s8_1317, s8_1765));
  const double s8_1767 = work.s8_857 + fma(projection.Rz[30], work.s7_229, s8_1714);
  const double s8_1768 = fnma(p_lower_arm_left_x, s8_1767, fnma(s8_1698, s8_1750, s8_1766));
  const double s8_1769 = fma(projection.Rz[15], work.s7_160, work.s8_768);
  const double s8_1770 = fma(projection.Rz[15], work.s7_164, work.s8_765);
  const double s8_1771 = fnma(-p_rear_axle_tx_z, s8_1769, s8_1768);
  const double s8_1772 = fma(p_arb_front_right_x, s8_1770, s8_1771);
  const double s8_1773 = s8_1706*s8_1772;
  const double s8_1774 = fma(projection.Rz[13], work.s7_145, work.s8_744);
  const double s8_1775 = work.s8_909 + (work.s8_939 + (work.s8_1031 + work.s8_1053));
  const double s8_1776 = work.s8_891 + (work.s8_798 + s8_1775);
  const double s8_1777 = fnma(-p_bell_crank_z, work.s8_725, s8_1776);
  const double s8_1778 = fnma(projection.Rz[34], work.s7_246, s8_1777);
  const double s8_1779 = fma(work.s1_22, work.s8_865, s8_1778);
  const double s8_1780 = fma(work.r_carrier_right_aux1_y, work.s8_859, s8_1779);
  const double s8_1781 = fnma(projection.Rz[16], work.s7_162, s8_1780);
  const double s8_1782 = fma(work.r_carrier_left_aux1_y, work.s8_997, s8_1781);
  const double s8_1783 = fnma(work.r_carrier_left_aux1_z, work.s8_1003, s8_1782);
  const double s8_1784 = fma(work.s8_1083, work.s8_1091, s8_1783);
  const double s8_1785 = fnma(work.s8_1075, work.s8_1085, s8_1784);
  const double s8_1786 = fnma(work.s8_1148, work.s8_1154, s8_1785);
  const double s8_1787 = fnma(work.s8_1142, work.s8_1147, s8_1786);
  const double s8_1788 = fma(work.s8_1197, work.s8_1203, s8_1787);
  const double s8_1789 = fnma(work.s8_1194, work.s8_1200, s8_1788);
  const double s8_1790 = fma(work.s8_1273, work.s8_1276, s8_1789);
  const double s8_1791 = fma(work.s8_1254, work.s8_1266, s8_1790);
  const double s8_1792 = fnma(work.s8_1314, work.s8_1318, s8_1791);
  const double s8_1793 = fnma(work.s8_1392, s8_1669, fnma(work.s8_1319, work.s8_1348, s8_1792));
  const double s8_1794 = fnma(projection.Rz[31], work.s7_229, s8_1774);
  const double s8_1795 = fms(projection.Rz[1], work.s7_89, work.s8_897);
  const double s8_1796 = fma(-p_rear_axle_tx_z, s8_1794, s8_1793);
  const double s8_1797 = fnma(projection.Rz[16], work.s7_164, work.s8_766);
  const double s8_1798 = fma(p_lower_arm_left_y, s8_1795, s8_1796);
  const double s8_1799 = fnma(projection.Rz[1], work.s7_91, work.s8_900);
  const double s8_1800 = fma(p_carrier_left_rz_y, s8_1797, s8_1798);
  const double s8_1801 = fnma(projection.Rz[13], work.s7_147, work.s8_789);
  const double s8_1802 = fma(-p_lower_arm_left_z, s8_1799, s8_1800);
  const double s8_1803 = fma(-p_upper_arm_right_z, s8_1801, s8_1802);
  const double s8_1804 = fma(projection.Rz[12], work.s7_145, work.s8_742);
  const double s8_1805 = work.s8_908 + (work.s8_938 + (work.s8_1028 + work.s8_1052));
  const double s8_1806 = work.s8_888 + (work.s8_797 + s8_1805);
  const double s8_1807 = fnma(-p_bell_crank_z, work.s8_724, s8_1806);
  const double s8_1808 = fnma(projection.Rz[33], work.s7_246, s8_1807);
  const double s8_1809 = fma(work.s1_22, work.s8_863, s8_1808);
  const double s8_1810 = fma(work.r_carrier_right_aux1_y, work.s8_857, s8_1809);
  const double s8_1811 = fnma(projection.Rz[15], work.s7_162, s8_1810);
  const double s8_1812 = fma(work.r_carrier_left_aux1_y, work.s8_995, s8_1811);
  const double s8_1813 = fnma(work.r_carrier_left_aux1_z, work.s8_1001, s8_1812);
  const double s8_1814 = fma(work.s8_1083, work.s8_1089, s8_1813);
  const double s8_1815 = fnma(work.s8_1074, work.s8_1085, s8_1814);
  const double s8_1816 = fnma(work.s8_1148, work.s8_1152, s8_1815);
  const double s8_1817 = fnma(work.s8_1141, work.s8_1147, s8_1816);
  const double s8_1818 = fma(work.s8_1196, work.s8_1203, s8_1817);
  const double s8_1819 = fnma(work.s8_1193, work.s8_1200, s8_1818);
  const double s8_1820 = fma(work.s8_1271, work.s8_1276, s8_1819);
  const double s8_1821 = fma(work.s8_1253, work.s8_1266, s8_1820);
  const double s8_1822 = fnma(work.s8_1313, work.s8_1318, s8_1821);
  const double s8_1823 = fnma(work.s8_1392, s8_1671, fnma(work.s8_1319, work.s8_1346, s8_1822));
  const double s8_1824 = fnma(projection.Rz[30], work.s7_229, s8_1804);
  const double s8_1825 = fma(-p_rear_axle_tx_z, s8_1824, fnma(s8_1698, s8_1803, s8_1823));
  const double s8_1826 = fms(projection.Rz[0], work.s7_89, work.s8_896);
  const double s8_1827 = fnma(projection.Rz[15], work.s7_164, work.s8_765);
  const double s8_1828 = fma(p_lower_arm_left_y, s8_1826, s8_1825);
  const double s8_1829 = fnma(projection.Rz[0], work.s7_91, work.s8_899);
  const double s8_1830 = fma(p_carrier_left_rz_y, s8_1827, s8_1828);
  const double s8_1831 = fnma(projection.Rz[12], work.s7_147, work.s8_788);
  const double s8_1832 = fma(-p_lower_arm_left_z, s8_1829, s8_1830);
  const double s8_1833 = fma(-p_upper_arm_right_z, s8_1831, s8_1832);
  const double s8_1834 = s8_1706*s8_1833;
  const double s8_1835 = work.s8_865 + (work.s8_789 + s8_1719);
  const double s8_1836 = fnma(projection.Rz[13], work.s7_147, s8_1835);
  const double s8_1837 = work.s8_875 + (work.s8_729 + work.s8_1015);
  const double s8_1838 = fnma(p_bell_crank_x, work.s8_725, s8_1837);
  const double s8_1839 = fma(p_pitman_arm_y, work.s8_745, s8_1838);
  const double s8_1840 = fma(projection.Rz[34], work.s7_248, s8_1839);
  const double s8_1841 = fnma(work.r_carrier_right_aux1_y, work.s8_854, s8_1840);
  const double s8_1842 = fnma(projection.Rz[16], work.s7_158, s8_1841);
  const double s8_1843 = fnma(work.r_carrier_left_aux1_y, work.s8_990, s8_1842);
  const double s8_1844 = fma(work.s8_1083, work.s8_1097, s8_1843);
  const double s8_1845 = fma(work.s8_1075, work.s8_1084, s8_1844);
  const double s8_1846 = fma(work.s8_1142, work.s8_1146, s8_1845);
  const double s8_1847 = fnma(work.s8_1148, work.s8_1160, s8_1846);
  const double s8_1848 = fma(work.s8_1200, work.s8_1206, s8_1847);
  const double s8_1849 = fnma(work.s8_1197, work.s8_1204, s8_1848);
  const double s8_1850 = fnma(work.s8_1267, work.s8_1273, s8_1849);
  const double s8_1851 = fnma(work.s8_1261, work.s8_1266, s8_1850);
  const double s8_1852 = fnma(work.s8_1317, work.s8_1348, s8_1851);
  const double s8_1853 = fnma(work.s8_1368, s8_1669, fnma(work.s8_1318, work.s8_1323, s8_1852));
  const double s8_1854 = fnma(projection.Rz[1], work.s7_91, s8_1836);
  const double s8_1855 = fnma(projection.Rz[16], work.s7_160, work.s8_769);
  const double s8_1856 = fma(p_lower_arm_left_x, s8_1854, s8_1853);
  const double s8_1857 = fma(p_carrier_left_rz_y, s8_1855, s8_1856);
  const double s8_1858 = work.s8_863 + (work.s8_788 + s8_1723);
  const double s8_1859 = fnma(projection.Rz[12], work.s7_147, s8_1858);
  const double s8_1860 = work.s8_873 + (work.s8_728 + work.s8_1013);
  const double s8_1861 = fnma(p_bell_crank_x, work.s8_724, s8_1860);
  const double s8_1862 = fma(p_pitman_arm_y, work.s8_743, s8_1861);
  const double s8_1863 = fma(projection.Rz[33], work.s7_248, s8_1862);
  const double s8_1864 = fnma(work.r_carrier_right_aux1_y, work.s8_853, s8_1863);
  const double s8_1865 = fnma(projection.Rz[15], work.s7_158, s8_1864);
  const double s8_1866 = fnma(work.r_carrier_left_aux1_y, work.s8_989, s8_1865);
  const double s8_1867 = fma(work.s8_1083, work.s8_1095, s8_1866);
  const double s8_1868 = fma(work.s8_1074, work.s8_1084, s8_1867);
  const double s8_1869 = fma(work.s8_1141, work.s8_1146, s8_1868);
  const double s8_1870 = fnma(work.s8_1148, work.s8_1158, s8_1869);
  const double s8_1871 = fma(work.s8_1200, work.s8_1205, s8_1870);
  const double s8_1872 = fnma(work.s8_1196, work.s8_1204, s8_1871);
  const double s8_1873 = fnma(work.s8_1267, work.s8_1271, s8_1872);
  const double s8_1874 = fnma(work.s8_1259, work.s8_1266, s8_1873);
  const double s8_1875 = fnma(work.s8_1317, work.s8_1346, s8_1874);
  const double s8_1876 = fnma(work.s8_1368, s8_1671, fnma(work.s8_1318, work.s8_1321, s8_1875));
  const double s8_1877 = fnma(projection.Rz[0], work.s7_91, s8_1859);
  const double s8_1878 = fma(p_lower_arm_left_x, s8_1877, fnma(s8_1698, s8_1857, s8_1876));
  const double s8_1879 = fnma(projection.Rz[15], work.s7_160, work.s8_768);
  const double s8_1880 = fma(p_carrier_left_rz_y, s8_1879, s8_1878);
  const double s8_1881 = s8_1706*s8_1880;
  const double s8_1882 = s8_1697*s8_1702;
  const double s8_1883 = s8_1697*s8_1712;
  const double s8_1884 = s8_1697*s8_1722;
  const double s8_1885 = s8_1697*s8_1750;
  const double s8_1886 = s8_1697*s8_1803;
  const double s8_1887 = s8_1697*s8_1857;
  const double s8_1888 = work.s8_993*s8_1668;
  const double s8_1889 = work.s8_1040*s8_1668;
  const double s8_1890 = work.s8_1044*s8_1668;
  const double s8_1891 = work.s8_1342*s8_1668;
  const double s8_1892 = work.s8_1392*s8_1668;
  const double s8_1893 = work.s8_1368*s8_1668;
  const double s8_1894 = fma(work.s7_21, work.s3_14, work.s7_30*work.s3_20);
  const double s8_1895 = fnma(work.s8_711, work.f_carrier_right_y, s8_1894);
  const double s8_1896 = fnma(work.s8_710, work.f_carrier_right_z, s8_1895);
  const double s8_1897 = fnma(work.s8_709, work.n_carrier_right_x, s8_1896);
  const double s8_1898 = fnma(work.s8_707, work.f_carrier_left_z, s8_1897);
  const double s8_1899 = fma(work.s8_708, work.f_carrier_left_y, s8_1898);
  const double s8_1900 = fnma(work.s8_706, work.n_carrier_left_x, s8_1899);
  const double s8_1901 = fnma(work.s8_1075, work.s8_1114, s8_1900);
  const double s8_1902 = fnma(work.s8_1091, work.s8_1122, s8_1901);
  const double s8_1903 = fma(work.s8_1097, work.s8_1108, s8_1902);
  const double s8_1904 = fnma(work.s8_1142, work.s8_1170, s8_1903);
  const double s8_1905 = fnma(work.s8_1154, work.s8_1184, s8_1904);
  const double s8_1906 = fma(work.s8_1160, work.s8_1177, s8_1905);
  const double s8_1907 = fma(work.s8_1197, work.s8_1234, s8_1906);
  const double s8_1908 = fma(work.s8_1194, work.s8_1230, s8_1907);
  const double s8_1909 = fma(work.s8_1206, work.s8_1224, s8_1908);
  const double s8_1910 = fnma(work.s8_1254, work.s8_1281, s8_1909);
  const double s8_1911 = fnma(work.s8_1261, work.s8_1288, s8_1910);
  const double s8_1912 = fnma(work.s8_1273, work.s8_1295, s8_1911);
  const double s8_1913 = fnma(work.s8_1314, work.s8_1509, s8_1912);
  const double s8_1914 = fma(work.s8_1323, work.s8_1515, s8_1913);
  const double s8_1915 = fnma(work.s8_1575, s8_1669, fma(work.s8_1348, work.s8_1521, s8_1914));
  const double s8_1916 = fma(projection.Rz[1], work.s8_1524, s8_1915);
  const double s8_1917 = fma(projection.Rz[13], work.s8_1527, s8_1916);
  const double s8_1918 = fma(projection.Rz[16], work.s8_1531, s8_1917);
  const double s8_1919 = fma(projection.Rz[19], work.s8_1534, s8_1918);
  const double s8_1920 = fma(projection.Rz[31], work.s8_1537, s8_1919);
  const double s8_1921 = fma(projection.Rz[34], work.s8_1541, s8_1920);
  const double s8_1922 = fma(projection.Rz[37], work.s8_1544, s8_1921);
  const double s8_1923 = fma(projection.Rz[40], work.s8_1547, s8_1922);
  const double s8_1924 = fma(work.s3_37, work.s8_1549, fma(work.s3_28, work.s8_1548, s8_1923));
  const double s8_1925 = fma(work.s3_55, work.s8_1551, fma(work.s3_46, work.s8_1550, s8_1924));
  const double s8_1926 = fma(work.s7_21, work.s3_12, work.s7_30*work.s3_18);
  const double s8_1927 = fnma(work.s8_705, work.f_carrier_right_y, s8_1926);
  const double s8_1928 = fnma(work.s8_704, work.f_carrier_right_z, s8_1927);
  const double s8_1929 = fnma(work.s8_703, work.n_carrier_right_x, s8_1928);
  const double s8_1930 = fnma(work.s8_701, work.f_carrier_left_z, s8_1929);
  const double s8_1931 = fma(work.s8_702, work.f_carrier_left_y, s8_1930);
  const double s8_1932 = fnma(work.s8_700, work.n_carrier_left_x, s8_1931);
  const double s8_1933 = fnma(work.s8_1074, work.s8_1114, s8_1932);
  const double s8_1934 = fnma(work.s8_1089, work.s8_1122, s8_1933);
  const double s8_1935 = fma(work.s8_1095, work.s8_1108, s8_1934);
  const double s8_1936 = fnma(work.s8_1141, work.s8_1170, s8_1935);
  const double s8_1937 = fnma(work.s8_1152, work.s8_1184, s8_1936);
  const double s8_1938 = fma(work.s8_1158, work.s8_1177, s8_1937);
  const double s8_1939 = fma(work.s8_1196, work.s8_1234, s8_1938);
  const double s8_1940 = fma(work.s8_1193, work.s8_1230, s8_1939);
  const double s8_1941 = fma(work.s8_1205, work.s8_1224, s8_1940);
  const double s8_1942 = fnma(work.s8_1253, work.s8_1281, s8_1941);
  const double s8_1943 = fnma(work.s8_1259, work.s8_1288, s8_1942);
  const double s8_1944 = fnma(work.s8_1271, work.s8_1295, s8_1943);
  const double s8_1945 = fnma(work.s8_1313, work.s8_1509, s8_1944);
  const double s8_1946 = fma(work.s8_1321, work.s8_1515, s8_1945);
  const double s8_1947 = fnma(work.s8_1575, s8_1671, fma(work.s8_1346, work.s8_1521, s8_1946));
  const double s8_1948 = fma(projection.Rz[0], work.s8_1524, fnma(s8_1698, s8_1925, s8_1947));
  const double s8_1949 = fma(projection.Rz[12], work.s8_1527, s8_1948);
  const double s8_1950 = fma(projection.Rz[15], work.s8_1531, s8_1949);
  const double s8_1951 = fma(projection.Rz[18], work.s8_1534, s8_1950);
  const double s8_1952 = fma(projection.Rz[30], work.s8_1537, s8_1951);
  const double s8_1953 = fma(projection.Rz[33], work.s8_1541, s8_1952);
  const double s8_1954 = fma(projection.Rz[36], work.s8_1544, s8_1953);
  const double s8_1955 = fma(projection.Rz[39], work.s8_1547, s8_1954);
  const double s8_1956 = fma(work.s3_34, work.s8_1549, fma(work.s3_25, work.s8_1548, s8_1955));
  const double s8_1957 = fma(work.s3_52, work.s8_1551, fma(work.s3_43, work.s8_1550, s8_1956));
  const double s8_1958 = work.s8_912 + (work.s8_928 + work.f_carrier_left_y);
  const double s8_1959 = work.s8_600 + (work.s8_802 + (work.f_carrier_right_y + s8_1958));
  const double s8_1960 = work.s8_780 + s8_1959 - work.s8_739 - work.s8_756 - work.s8_946;
  const double s8_1961 = fma(work.s8_1575, s8_1890, s8_1960 - work.s8_1057);
  const double s8_1962 = fma(s8_1728, s8_1957, fma(s8_1884, s8_1925, s8_1961));
  const double s8_1963 = work.s8_929 + (work.s8_943 + (work.f_carrier_left_x + work.s8_1050));
  const double s8_1964 = work.s8_801 + (work.f_carrier_right_x + (work.s8_906 + s8_1963));
  const double s8_1965 = work.s8_738 + (work.s8_603 + (work.s8_759 + (work.s8_783 + s8_1964)));
  const double s8_1966 = fma(s8_1882, s8_1925, fma(work.s8_1575, s8_1888, s8_1965));
  const double s8_1967 = fma(s8_1707, s8_1957, s8_1966);
  const double s8_1968 = work.s8_913 + (work.s8_944 + (work.f_carrier_left_z + work.s8_1055));
  const double s8_1969 = work.s8_758 + (work.s8_803 + (work.f_carrier_right_z + s8_1968));
  const double s8_1970 = work.s8_737 + (work.s8_607 + s8_1969) - work.s8_784 - work.s8_931;
  const double s8_1971 = fma(s8_1883, s8_1925, fma(work.s8_1575, s8_1889, s8_1970));
  const double s8_1972 = fma(s8_1718, s8_1957, s8_1971);
  const double s8_1973 = fma(projection.zdd_star[0], work.s7_99, work.n_carrier_left_x);
  const double s8_1974 = fma(projection.zdd_star[4], work.s7_155, s8_1973);
  const double s8_1975 = fma(projection.zdd_star[6], work.s7_185, s8_1974);
  const double s8_1976 = work.s8_622 + (work.n_carrier_right_x + s8_1975);
  const double s8_1977 = fma(projection.zdd_star[10], work.s7_239, s8_1976);
  const double s8_1978 = fma(s8_1886, s8_1925, fma(work.s8_1575, s8_1892, s8_1977));
  const double s8_1979 = fma(work.s7_273, work.s8_733, fma(work.s7_277, work.s8_734, s8_1978));
  const double s8_1980 = fnma(-p_bell_crank_z, work.s8_739, s8_1979);
  const double s8_1981 = fnma(work.s7_264, work.s8_751, fnma(work.s7_262, work.s8_750, s8_1980));
  const double s8_1982 = fma(work.s7_248, work.s8_772, s8_1981);
  const double s8_1983 = fnma(projection.zdd_star[11], work.s7_246, s8_1982);
  const double s8_1984 = fnma(work.s7_255, work.s8_778, fnma(work.s7_253, work.s8_779, s8_1983));
  const double s8_1985 = fma(work.s1_22, work.f_carrier_right_y, s8_1984);
  const double s8_1986 = fma(work.r_carrier_right_aux1_y, work.f_carrier_right_z, s8_1985);
  const double s8_1987 = fnma(projection.zdd_star[5], work.s7_162, s8_1986);
  const double s8_1988 = fnma(work.s7_169, work.s8_927, fnma(work.s7_158, work.s8_920, s8_1987));
  const double s8_1989 = fnma(work.s7_171, work.s8_926, s8_1988);
  const double s8_1990 = fma(work.r_carrier_left_aux1_y, work.f_carrier_left_z, s8_1989);
  const double s8_1991 = fnma(work.r_carrier_left_aux1_z, work.f_carrier_left_y, s8_1990);
  const double s8_1992 = fma(work.s8_1077, work.s8_1114, s8_1991);
  const double s8_1993 = fnma(work.s8_1082, work.s8_1122, s8_1992);
  const double s8_1994 = fma(work.s8_1144, work.s8_1170, s8_1993);
  const double s8_1995 = fma(work.s8_1132, work.s8_1184, s8_1994);
  const double s8_1996 = fma(work.s8_1201, work.s8_1234, s8_1995);
  const double s8_1997 = fnma(work.s8_1199, work.s8_1230, s8_1996);
  const double s8_1998 = fnma(work.s8_1265, work.s8_1281, s8_1997);
  const double s8_1999 = fnma(work.s8_1244, work.s8_1295, s8_1998);
  const double s8_2000 = fma(work.s8_1307, work.s8_1509, s8_1999);
  const double s8_2001 = work.s8_780 + (work.s8_758 + (work.s8_928 + work.s8_944)) - work.s8_803;
  const double s8_2002 = fma(s8_1834, s8_1957, fnma(work.s8_1303, work.s8_1521, s8_2000));
  const double s8_2003 = work.s8_1055 - work.s8_756 - work.s8_913;
  const double s8_2004 = fma(-p_rear_axle_tx_z, s8_2001, s8_2002);
  const double s8_2005 = fma(p_lower_arm_left_y, s8_2003, s8_2004);
  const double s8_2006 = fma(p_carrier_left_rz_y, work.s8_784 - work.s8_931, s8_2005);
  const double s8_2007 = fma(-p_lower_arm_left_z, work.s8_912 - work.s8_1057, s8_2006);
  const double s8_2008 = fma(-p_upper_arm_right_z, work.s8_802 - work.s8_946, s8_2007);
  const double s8_2009 = work.s8_802 + (work.s8_912 + work.f_carrier_left_y);
  const double s8_2010 = work.s8_639 + (work.n_carrier_right_z + work.n_carrier_left_z);
  const double s8_2011 = fma(projection.zdd_star[13], work.s7_279, s8_2010);
  const double s8_2012 = fma(s8_1887, s8_1925, fma(work.s8_1575, s8_1893, s8_2011));
  const double s8_2013 = fnma(p_bell_crank_x, work.s8_739, s8_2012);
  const double s8_2014 = fma(work.s7_262, work.s8_751, fma(work.s7_263, work.s8_750, s8_2013));
  const double s8_2015 = fnma(p_pitman_arm_x, work.s8_756, s8_2014);
  const double s8_2016 = fma(projection.zdd_star[11], work.s7_248, s8_2015);
  const double s8_2017 = fma(work.s7_254, work.s8_779, fma(work.s7_246, work.s8_772, s8_2016));
  const double s8_2018 = fnma(work.s7_236, work.s8_795, fma(work.s7_253, work.s8_778, s8_2017));
  const double s8_2019 = fnma(work.s7_237, work.s8_800, s8_2018);
  const double s8_2020 = fnma(work.r_carrier_right_aux1_y, work.f_carrier_right_x, s8_2019);
  const double s8_2021 = fnma(work.s7_183, work.s8_905, fnma(work.s7_182, work.s8_904, s8_2020));
  const double s8_2022 = fma(work.s7_169, work.s8_926, fma(work.s7_170, work.s8_927, s8_2021));
  const double s8_2023 = fnma(projection.zdd_star[5], work.s7_158, s8_2022);
  const double s8_2024 = fnma(work.s7_153, work.s8_941, fma(work.s7_162, work.s8_920, s8_2023));
  const double s8_2025 = fnma(work.s7_152, work.s8_942, s8_2024);
  const double s8_2026 = fnma(work.r_carrier_left_aux1_y, work.f_carrier_left_x, s8_2025);
  const double s8_2027 = fnma(work.s7_96, work.s8_1049, fnma(work.s7_97, work.s8_1048, s8_2026));
  const double s8_2028 = fma(work.s8_1082, work.s8_1108, s8_2027);
  const double s8_2029 = fnma(work.s8_1078, work.s8_1114, s8_2028);
  const double s8_2030 = fnma(work.s8_1145, work.s8_1170, s8_2029);
  const double s8_2031 = fnma(work.s8_1132, work.s8_1177, s8_2030);
  const double s8_2032 = fma(work.s8_1199, work.s8_1224, s8_2031);
  const double s8_2033 = fnma(work.s8_1202, work.s8_1234, s8_2032);
  const double s8_2034 = fma(work.s8_1265, work.s8_1288, s8_2033);
  const double s8_2035 = fma(work.s8_1264, work.s8_1295, s8_2034);
  const double s8_2036 = fnma(work.s8_1316, work.s8_1521, s8_2035);
  const double s8_2037 = fma(s8_1881, s8_1957, fnma(work.s8_1307, work.s8_1515, s8_2036));
  const double s8_2038 = work.f_carrier_right_y + s8_2009 - work.s8_946 - work.s8_1057;
  const double s8_2039 = fma(p_lower_arm_left_x, s8_2038, s8_2037);
  const double s8_2040 = fma(-p_rear_axle_tx_z, work.s8_801 - work.s8_759 - work.s8_943, s8_2039);
  const double s8_2041 = fma(p_lower_arm_left_y, work.s8_906 - work.s8_1050, s8_2040);
  const double s8_2042 = fma(p_carrier_left_rz_y, work.s8_783 - work.s8_929, s8_2041);
  const double s8_2043 = fma(p_arb_front_right_x, work.s8_780 + work.s8_928, s8_2042);
  const double s8_2044 = fma(projection.zdd_star[5], work.s7_172, work.n_carrier_left_y);
  const double s8_2045 = work.n_carrier_right_y + s8_2044;
  const double s8_2046 = work.s8_652 + fma(projection.zdd_star[11], work.s7_256, s8_2045);
  const double s8_2047 = fma(projection.zdd_star[12], work.s7_265, s8_2046);
  const double s8_2048 = fma(s8_1885, s8_1925, fma(work.s8_1575, s8_1891, s8_2047));
  const double s8_2049 = fnma(-p_pitman_arm_z, work.s8_759, s8_2048);
  const double s8_2050 = fnma(p_pitman_arm_x, work.s8_758, s8_2049);
  const double s8_2051 = fnma(work.s7_273, work.s8_734, fnma(work.s7_274, work.s8_733, s8_2050));
  const double s8_2052 = fnma(-p_bell_crank_z, work.s8_738, s8_2051);
  const double s8_2053 = fnma(p_bell_crank_x, work.s8_737, s8_2052);
  const double s8_2054 = fma(work.s7_238, work.s8_795, fma(work.s7_236, work.s8_800, s8_2053));
  const double s8_2055 = fnma(work.s1_22, work.f_carrier_right_x, s8_2054);
  const double s8_2056 = fma(work.s7_184, work.s8_904, fma(work.s7_182, work.s8_905, s8_2055));
  const double s8_2057 = fma(work.s7_154, work.s8_942, fma(work.s7_152, work.s8_941, s8_2056));
  const double s8_2058 = fma(work.r_carrier_left_aux1_z, work.f_carrier_left_x, s8_2057);
  const double s8_2059 = fma(work.s7_98, work.s8_1049, fma(work.s7_96, work.s8_1048, s8_2058));
  const double s8_2060 = fma(work.s8_1078, work.s8_1122, s8_2059);
  const double s8_2061 = fnma(work.s8_1077, work.s8_1108, s8_2060);
  const double s8_2062 = fma(work.s8_1145, work.s8_1184, s8_2061);
  const double s8_2063 = fnma(work.s8_1144, work.s8_1177, s8_2062);
  const double s8_2064 = fma(work.s8_1202, work.s8_1230, s8_2063);
  const double s8_2065 = fnma(work.s8_1201, work.s8_1224, s8_2064);
  const double s8_2066 = fnma(work.s8_1264, work.s8_1281, s8_2065);
  const double s8_2067 = fma(work.s8_1244, work.s8_1288, s8_2066);
  const double s8_2068 = fma(work.s8_1316, work.s8_1509, s8_2067);
  const double s8_2069 = fma(s8_1773, s8_1957, fma(work.s8_1303, work.s8_1515, s8_2068));
  const double s8_2070 = work.f_carrier_right_z + (work.s8_803 + s8_1968);
  const double s8_2071 = fnma(p_lower_arm_left_x, s8_2070, s8_2069);
  const double s8_2072 = fnma(-p_lower_arm_left_z, work.s8_906 + work.s8_1050, s8_2071);
  const double s8_2073 = fnma(-p_rear_axle_tx_z, work.s8_783 + work.s8_929, s8_2072);
  const double s8_2074 = fnma(-p_upper_arm_right_z, work.s8_801 + work.s8_943, s8_2073);
  const double s8_2075 = fma(p_arb_front_right_x, work.s8_784 + work.s8_931, s8_2074);
  const double s8_2076 = fma(s8_1722, s8_1884, fma(s8_1727, s8_1728, work.s8_653));
  const double s8_2077 = fma(work.s8_1044, s8_1890, s8_2076);
  const double s8_2078 = fma(s8_1722, s8_1882, fma(s8_1707, s8_1727, work.s8_654));
  const double s8_2079 = fma(work.s8_1044, s8_1888, s8_2078);
  const double s8_2080 = fma(s8_1702, s8_1882, fma(s8_1705, s8_1707, work.s8_655));
  const double s8_2081 = fma(work.s8_993, s8_1888, s8_2080);
  const double s8_2082 = fma(s8_1712, s8_1884, fma(s8_1717, s8_1728, work.s8_656));
  const double s8_2083 = fma(work.s8_1040, s8_1890, s8_2082);
  const double s8_2084 = fma(s8_1712, s8_1882, fma(s8_1707, s8_1717, work.s8_657));
  const double s8_2085 = fma(work.s8_1040, s8_1888, s8_2084);
  const double s8_2086 = fma(s8_1712, s8_1883, fma(s8_1717, s8_1718, work.s8_658));
  const double s8_2087 = fma(work.s8_1040, s8_1889, s8_2086);
  const double s8_2088 = fma(s8_1803, s8_1884, fma(s8_1728, s8_1833, work.s8_659));
  const double s8_2089 = fma(work.s8_1392, s8_1890, s8_2088);
  const double s8_2090 = fma(s8_1803, s8_1882, fma(s8_1707, s8_1833, work.s8_660));
  const double s8_2091 = fma(work.s8_1392, s8_1888, s8_2090);
  const double s8_2092 = fma(s8_1803, s8_1883, fma(s8_1718, s8_1833, work.s8_661));
  const double s8_2093 = fma(work.s8_1392, s8_1889, s8_2092);
  const double s8_2094 = fma(s8_1803, s8_1886, fma(s8_1833, s8_1834, work.s8_662));
  const double s8_2095 = fma(work.s8_1392, s8_1892, s8_2094);
  const double s8_2096 = fma(s8_1857, s8_1884, fma(s8_1728, s8_1880, work.s8_663));
  const double s8_2097 = fma(work.s8_1368, s8_1890, s8_2096);
  const double s8_2098 = fma(s8_1857, s8_1882, fma(s8_1707, s8_1880, work.s8_664));
  const double s8_2099 = fma(work.s8_1368, s8_1888, s8_2098);
  const double s8_2100 = fma(s8_1857, s8_1883, fma(s8_1718, s8_1880, work.s8_665));
  const double s8_2101 = fma(work.s8_1368, s8_1889, s8_2100);
  const double s8_2102 = fma(s8_1857, s8_1886, fma(s8_1834, s8_1880, work.s8_666));
  const double s8_2103 = fma(work.s8_1368, s8_1892, s8_2102);
  const double s8_2104 = fma(s8_1857, s8_1887, fma(s8_1880, s8_1881, work.s8_667));
  const double s8_2105 = fma(work.s8_1368, s8_1893, s8_2104);
  const double s8_2106 = fma(s8_1857, s8_1885, fma(s8_1773, s8_1880, work.s8_668));
  const double s8_2107 = fma(work.s8_1368, s8_1891, s8_2106);
  const double s8_2108 = fma(s8_1750, s8_1884, fma(s8_1728, s8_1772, work.s8_669));
  const double s8_2109 = fma(work.s8_1342, s8_1890, s8_2108);
  const double s8_2110 = fma(s8_1750, s8_1882, fma(s8_1707, s8_1772, work.s8_670));
  const double s8_2111 = fma(work.s8_1342, s8_1888, s8_2110);
  const double s8_2112 = fma(s8_1750, s8_1883, fma(s8_1718, s8_1772, work.s8_671));
  const double s8_2113 = fma(work.s8_1342, s8_1889, s8_2112);
  const double s8_2114 = fma(s8_1750, s8_1886, fma(s8_1772, s8_1834, work.s8_672));
  const double s8_2115 = fma(work.s8_1342, s8_1892, s8_2114);
  const double s8_2116 = fma(s8_1750, s8_1885, fma(s8_1772, s8_1773, work.s8_673));
  const double s8_2117 = fma(work.s8_1342, s8_1891, s8_2116);
  // operations: 1747 add, 1692 multiply, 3 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_2118 = h_chassis_y + work.s8_1036;
  const double s8_2119 = K_chassis_xz + work.s8_1586;
  const double s8_2120 = K_chassis_xy + work.s8_1592;
  const double s8_2121 = h_chassis_z + work.s8_1635;
  const double s8_2122 = work.s8_1577 - (-h_chassis_x);
  const double s8_2123 = K_chassis_zz + work.s8_1640;
  const double s8_2124 = K_chassis_yy + work.s8_1643;
  const double s8_2125 = K_chassis_xx + work.s8_1646;
  const double s8_2126 = 15306.0 - s8_2081;
  const double s8_2127 = work.s8_1603 + s8_2118;
  const double s8_2128 = s8_2099 + s8_2127;
  const double s8_2129 = work.s8_1653 + s8_2123;
  const double s8_2130 = work.s8_1660 + s8_2124;
  const double s8_2131 = s8_1667 + s8_2125;
  const double s8_2132 = s8_2130 + (s8_2129 + s8_2131);
  const double pivot_chassis_rx = s8_2132 - s8_2129 - s8_2105;
  const double s8_2133 = 1.0/pivot_chassis_rx;
  const double s8_2134 = s8_2128*s8_2133;
  const double s8_2135 = work.s8_1606 + s8_2121;
  const double s8_2136 = s8_2107 + (work.s8_1600 + work.s8_1616);
  const double s8_2137 = s8_2133*s8_2136;
  const double s8_2138 = fnma(s8_2128, s8_2137, s8_2135 - s8_2111);
  const double s8_2139 = s8_2132 - s8_2130 - s8_2117;
  const double pivot_chassis_ry = fnma(s8_2136, s8_2137, s8_2139);
  const double s8_2140 = 1.0/pivot_chassis_ry;
  const double s8_2141 = s8_2138*s8_2140;
  const double s8_2142 = s8_2103 + (work.s8_1624 + s8_2119);
  const double s8_2143 = fma(s8_2137, s8_2142, s8_2115 + (work.s8_1633 + s8_2120));
  const double s8_2144 = s8_2140*s8_2143;
  const double s8_2145 = s8_2133*s8_2142;
  const double s8_2146 = fnma(s8_2128, s8_2145, fms(s8_2138, s8_2144, s8_2091));
  const double s8_2147 = s8_2132 - s8_2131 - s8_2095;
  const double pivot_chassis_rz = fnma(s8_2143, s8_2144, fnma(s8_2142, s8_2145, s8_2147));
  const double s8_2148 = 1.0/pivot_chassis_rz;
  const double s8_2149 = s8_2146*s8_2148;
  const double s8_2150 = work.s8_1604 + s8_2122;
  const double s8_2151 = fma(s8_2101, s8_2137, s8_2113 + s8_2150);
  const double s8_2152 = s8_2140*s8_2151;
  const double s8_2153 = s8_2101*s8_2133;
  const double s8_2154 = fnma(s8_2144, s8_2151, fnma(s8_2101, s8_2145, s8_2127 - s8_2093));
  const double s8_2155 = s8_2148*s8_2154;
  const double s8_2156 = fnma(s8_2128, s8_2153, fms(s8_2138, s8_2152, s8_2085));
  const double s8_2157 = fnma(s8_2146, s8_2155, s8_2156);
  const double s8_2158 = 15306.0 - s8_2087;
  const double s8_2159 = fnma(s8_2151, s8_2152, fnma(s8_2101, s8_2153, s8_2158));
  const double pivot_chassis_tz = fnma(s8_2154, s8_2155, s8_2159);
  const double s8_2160 = 1.0/pivot_chassis_tz;
  const double s8_2161 = s8_2157*s8_2160;
  const double s8_2162 = s8_2150 - s8_2097;
  const double s8_2163 = s8_2133*s8_2162;
  const double s8_2164 = fms(s8_2137, s8_2162, s8_2109);
  const double s8_2165 = s8_2140*s8_2164;
  const double s8_2166 = fma(s8_2144, s8_2164, fms(s8_2145, s8_2162, s8_2089) - s8_2135);
  const double s8_2167 = s8_2148*s8_2166;
  const double s8_2168 = fma(s8_2152, s8_2164, fms(s8_2153, s8_2162, s8_2083));
  const double s8_2169 = fnma(s8_2155, s8_2166, s8_2168);
  const double s8_2170 = s8_2160*s8_2169;
  const double s8_2171 = fnma(s8_2138, s8_2165, fms(s8_2128, s8_2163, s8_2079));
  const double s8_2172 = fnma(s8_2157, s8_2170, fnma(s8_2146, s8_2167, s8_2171));
  const double s8_2173 = 15306.0 - s8_2077;
  const double s8_2174 = fnma(s8_2164, s8_2165, fnma(s8_2162, s8_2163, s8_2173));
  const double pivot_chassis_ty = fnma(s8_2169, s8_2170, fnma(s8_2166, s8_2167, s8_2174));
  const double s8_2175 = 1.0/pivot_chassis_ty;
  const double s8_2176 = s8_2172*s8_2175;
  const double s8_2177 = fnma(s8_2138, s8_2141, fnma(s8_2128, s8_2134, s8_2126));
  const double s8_2178 = fnma(s8_2157, s8_2161, fnma(s8_2146, s8_2149, s8_2177));
  const double pivot_chassis_tx = fnma(s8_2172, s8_2176, s8_2178);
  result.inertia[5] = fnma(1e-12, pivot_chassis_rx, pivot_chassis_rx);
  const double s8_2179 = fnma(work.s8_21, s8_2119, work.s7_13 - s8_2043);
  const double s8_2180 = fma(work.s8_22, work.s8_1600, s8_2179);
  const double s8_2181 = fma(work.s8_20, s8_2124 - s8_2125, s8_2180);
  const double s8_2182 = fma(s8_2120, work.s8_27 - work.s8_26, s8_2181);
  const double s8_2183 = fnma(1e-12, s8_2139, pivot_chassis_ry);
  const double s8_2184 = fma(s8_2137, s8_2182, work.s7_11 - s8_2075);
  const double s8_2185 = fma(work.s8_21, s8_2120, fnma(work.s8_20, work.s8_1600, s8_2184));
  const double s8_2186 = fma(work.s8_22, s8_2125 - s8_2123, s8_2185);
  const double s8_2187 = fma(s8_2119, work.s8_26 - work.s8_25, s8_2186);
  result.inertia[3] = fnma(1e-12, s8_2147, pivot_chassis_rz);
  result.inertia[2] = fnma(1e-12, s8_2158, pivot_chassis_tz);
  result.inertia[1] = fnma(1e-12, s8_2173, pivot_chassis_ty);
  const double s8_2188 = fms(tau[Coordinate::chassis_rx], work.s1_40, s8_2008);
  const double s8_2189 = fma(s8_2145, s8_2182, fma(s8_2144, s8_2187, s8_2188));
  const double s8_2190 = fma(work.s8_20, s8_2119, fnma(work.s8_22, s8_2120, s8_2189));
  const double s8_2191 = fma(work.s8_21, s8_2123 - s8_2124, s8_2190);
  const double s8_2192 = fma(work.s8_1600, work.s8_25 - work.s8_27, s8_2191);
  const double s8_2193 = fma(s8_2153, s8_2182, fma(s8_2152, s8_2187, work.s7_6 - s8_1972));
  const double s8_2194 = fnma(work.s8_22, s8_2122, fnma(work.s8_21, s8_2118, s8_2193));
  const double s8_2195 = fnma(s8_2155, s8_2192, fma(work.s8_25, s8_2121, s8_2194));
  const double s8_2196 = fnma(work.s8_20, s8_2122, work.s7_3 - s8_1962);
  const double s8_2197 = fma(work.s8_27, s8_2118, fnma(work.s8_21, s8_2121, s8_2196));
  const double s8_2198 = fnma(s8_2165, s8_2187, fnma(s8_2163, s8_2182, s8_2197));
  const double s8_2199 = fnma(s8_2170, s8_2195, fnma(s8_2167, s8_2192, s8_2198));
  const double s8_2200 = fnma(work.s8_20, s8_2118, fma(s8_2134, s8_2182, work.s7_9 - s8_1967));
  const double s8_2201 = fma(work.s8_26, s8_2122, fnma(work.s8_22, s8_2121, s8_2200));
  const double s8_2202 = fnma(s8_2149, s8_2192, fnma(s8_2141, s8_2187, s8_2201));
  const double s8_2203 = fnma(s8_2176, s8_2199, fnma(s8_2161, s8_2195, s8_2202));
  result.inertia[0] = fnma(1e-12, s8_2126, pivot_chassis_tx);
  const double s8_2204 = 1.0/pivot_chassis_tx;
  // operations: 156 add, 141 multiply, 6 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double a_chassis_x = s8_2203*s8_2204;
  const double a_chassis_y = s8_2175*fnma(s8_2172, a_chassis_x, s8_2199);
  const double a_chassis_z = s8_2160*fnma(s8_2169, a_chassis_y, fnma(s8_2157, a_chassis_x,
      s8_2195));
  const double s9_1 = fnma(s8_2166, a_chassis_y, fnma(s8_2146, a_chassis_x, s8_2192));
  const double alpha_chassis_x = s8_2148*fnma(s8_2154, a_chassis_z, s9_1);
  const double s9_2 = fnma(s8_2164, a_chassis_y, fnma(s8_2138, a_chassis_x, s8_2187));
  const double alpha_chassis_y = s8_2140*fma(s8_2143, alpha_chassis_x, fma(s8_2151, a_chassis_z,
      s9_2));
  const double s9_3 = fnma(s8_2162, a_chassis_y, fma(s8_2128, a_chassis_x, s8_2182));
  const double s9_4 = fma(s8_2142, alpha_chassis_x, fma(s8_2101, a_chassis_z, s9_3));
  const double alpha_chassis_z = s8_2133*fma(s8_2136, alpha_chassis_y, s9_4);
  const double s1_1 = work.sines[1];
  const double s9_5 = fma(-g_z, s1_1, a_chassis_x);
  const double s9_6 = fnma(-g_z, work.R_chassis_z_y, a_chassis_y);
  const double s9_7 = fnma(-g_z, work.R_chassis_z_z, a_chassis_z);
  result.zdd[Coordinate::chassis_tz] = fnma(s1_1, s9_5, fma(work.R_chassis_z_z, s9_7,
      work.R_chassis_z_y*s9_6));
  const double s9_8 = fma(work.R_chassis_aux5_y_x, s9_5, work.R_chassis_y_y*s9_6);
  result.zdd[Coordinate::chassis_ty] = fma(work.R_chassis_y_z, s9_7, s9_8);
  const double s9_9 = fma(work.R_chassis_aux5_x_x, s9_5, work.R_chassis_x_y*s9_6);
  result.zdd[Coordinate::chassis_tx] = fma(work.R_chassis_x_z, s9_7, s9_9);
  result.inertia[4] = mbgen::min(s8_2183, fms(work.s1_34, work.s1_34, 1e-12));
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  const double s9_10 = fma(work.s4_1, work.s4_5, alpha_chassis_y);
  const double s9_11 = fnma(zd_chassis_rx, work.w_chassis_z, s9_10);
  const double s9_12 = fma(zd_chassis_rx, work.w_chassis_y, alpha_chassis_z);
  const double s9_13 = fma(work.s4_1, work.s4_3, s9_12);
  result.zdd[Coordinate::chassis_rz] = fma(work.s1_37, s9_13, work.s1_36*s9_11);
  result.zdd[Coordinate::chassis_ry] = fnma(work.sines[2], s9_13, work.cosines[2]*s9_11);
  const double s9_14 = fma(work.s4_3, work.s4_4, fma(work.s4_2, work.s4_5, alpha_chassis_x));
  result.zdd[Coordinate::chassis_rx] = fma(work.s1_40, s9_14, fma(work.s1_39, s9_13,
      work.s1_38*s9_11));
  // bell_crank: bell_crank, revolute, chassis
  const double s9_15 = fnma(s8_1705, a_chassis_x, fnma(s8_1727, a_chassis_y, s8_1957));
  const double s9_16 = fnma(s8_1772, alpha_chassis_y, fnma(s8_1717, a_chassis_z, s9_15));
  const double s9_17 = fnma(s8_1833, alpha_chassis_x, fnma(s8_1880, alpha_chassis_z, s9_16));
  const double s9_18 = s8_1706*s9_17;
  const double s9_19 = fnma(s8_1702, a_chassis_x, fnma(s8_1722, a_chassis_y, s8_1925));
  const double s9_20 = fnma(s8_1750, alpha_chassis_y, fnma(s8_1712, a_chassis_z, s9_19));
  const double s9_21 = fnma(s8_1803, alpha_chassis_x, fnma(s8_1857, alpha_chassis_z, s9_20));
  const double s9_22 = s8_1697*fnma(s8_1696, s9_18, s9_21);
  const double s9_23 = fnma(work.s8_1044, a_chassis_y, work.s8_1575);
  const double s9_24 = fnma(work.s8_1040, a_chassis_z, fnma(work.s8_993, a_chassis_x, s9_23));
  const double s9_25 = fnma(work.s8_1342, alpha_chassis_y, s9_24);
  const double s9_26 = fnma(work.s8_1368, alpha_chassis_z, s9_25);
  const double s9_27 = fnma(work.s8_1438, s9_18, fnma(work.s8_1392, alpha_chassis_x, s9_26));
  const double s9_28 = s8_1668*fnma(work.s8_1483, s9_22, s9_27);
  const double s9_29 = fma(projection.Rz[0], s9_18, projection.zdd_star[0]);
  result.zdd[Coordinate::lower_arm_left] = fma(projection.Rz[2], s9_28, fma(projection.Rz[1], s9_22,
      s9_29));
  const double s9_30 = fma(projection.Rz[3], s9_18, projection.zdd_star[1]);
  result.zdd[Coordinate::carrier_left_rz] = fma(projection.Rz[5], s9_28, fma(projection.Rz[4],
      s9_22, s9_30));
  const double s9_31 = fma(projection.Rz[6], s9_18, projection.zdd_star[2]);
  result.zdd[Coordinate::carrier_left_rx] = fma(projection.Rz[8], s9_28, fma(projection.Rz[7],
      s9_22, s9_31));
  const double s9_32 = fma(projection.Rz[9], s9_18, projection.zdd_star[3]);
  result.zdd[Coordinate::carrier_left_ry] = fma(projection.Rz[11], s9_28, fma(projection.Rz[10],
      s9_22, s9_32));
  const double s9_33 = fma(projection.Rz[12], s9_18, projection.zdd_star[4]);
  result.zdd[Coordinate::upper_arm_left] = fma(projection.Rz[14], s9_28, fma(projection.Rz[13],
      s9_22, s9_33));
  const double s9_34 = fma(projection.Rz[15], s9_18, projection.zdd_star[5]);
  result.zdd[Coordinate::arb_front_left] = fma(projection.Rz[17], s9_28, fma(projection.Rz[16],
      s9_22, s9_34));
  const double s9_35 = fma(projection.Rz[18], s9_18, projection.zdd_star[6]);
  result.zdd[Coordinate::lower_arm_right] = fma(projection.Rz[20], s9_28, fma(projection.Rz[19],
      s9_22, s9_35));
  const double s9_36 = fma(projection.Rz[21], s9_18, projection.zdd_star[7]);
  result.zdd[Coordinate::carrier_right_rz] = fma(projection.Rz[23], s9_28, fma(projection.Rz[22],
      s9_22, s9_36));
  const double s9_37 = fma(projection.Rz[24], s9_18, projection.zdd_star[8]);
  result.zdd[Coordinate::carrier_right_rx] = fma(projection.Rz[26], s9_28, fma(projection.Rz[25],
      s9_22, s9_37));
  const double s9_38 = fma(projection.Rz[27], s9_18, projection.zdd_star[9]);
  result.zdd[Coordinate::carrier_right_ry] = fma(projection.Rz[29], s9_28, fma(projection.Rz[28],
      s9_22, s9_38));
  const double s9_39 = fma(projection.Rz[30], s9_18, projection.zdd_star[10]);
  result.zdd[Coordinate::upper_arm_right] = fma(projection.Rz[32], s9_28, fma(projection.Rz[31],
      s9_22, s9_39));
  const double s9_40 = fma(projection.Rz[33], s9_18, projection.zdd_star[11]);
  result.zdd[Coordinate::arb_front_right] = fma(projection.Rz[35], s9_28, fma(projection.Rz[34],
      s9_22, s9_40));
  const double s9_41 = fma(projection.Rz[36], s9_18, projection.zdd_star[12]);
  result.zdd[Coordinate::pitman_arm] = fma(projection.Rz[38], s9_28, fma(projection.Rz[37], s9_22,
      s9_41));
  const double s9_42 = fma(projection.Rz[39], s9_18, projection.zdd_star[13]);
  result.zdd[Coordinate::bell_crank] = fma(projection.Rz[41], s9_28, fma(projection.Rz[40], s9_22,
      s9_42));
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s9_43 = fma(work.s8_712, s9_28, work.s8_967 + alpha_chassis_x);
  const double alpha_carrier_left_x = fma(work.s8_700, s9_18, fma(work.s8_706, s9_22, s9_43));
  const double s9_44 = fma(work.s3_40, s9_28, work.s8_956 + alpha_chassis_y);
  const double alpha_carrier_left_y = fma(work.s3_34, s9_18, fma(work.s3_37, s9_22, s9_44));
  const double s9_45 = fma(work.s3_31, s9_28, work.s8_953 + alpha_chassis_z);
  const double alpha_carrier_left_z = fma(work.s3_25, s9_18, fma(work.s3_28, s9_22, s9_45));
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s9_46 = fma(work.s8_715, s9_28, work.s8_831 + alpha_chassis_x);
  const double alpha_carrier_right_x = fma(work.s8_703, s9_18, fma(work.s8_709, s9_22, s9_46));
  const double s9_47 = fma(work.s3_58, s9_28, work.s8_819 + alpha_chassis_y);
  const double alpha_carrier_right_y = fma(work.s3_52, s9_18, fma(work.s3_55, s9_22, s9_47));
  const double s9_48 = fma(work.s3_49, s9_28, work.s8_816 + alpha_chassis_z);
  const double alpha_carrier_right_z = fma(work.s3_43, s9_18, fma(work.s3_46, s9_22, s9_48));
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s9_49 = 0.09090909090909091*tau[Coordinate::wheel_front_left];
  const double s9_50 = fnma(work.R_carrier_left_aux2_y_y, alpha_carrier_left_y, s9_49);
  const double s9_51 = fnma(work.R_carrier_left_aux2_z_y, alpha_carrier_left_z, s9_50);
  result.zdd[Coordinate::wheel_front_left] = fma(work.s1_12, alpha_carrier_left_x, s9_51);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s9_52 = 0.09090909090909091*tau[Coordinate::wheel_front_right];
  const double s9_53 = fnma(work.R_carrier_right_aux2_y_y, alpha_carrier_right_y, s9_52);
  const double s9_54 = fnma(work.R_carrier_right_aux2_z_y, alpha_carrier_right_z, s9_53);
  result.zdd[Coordinate::wheel_front_right] = fma(work.s1_24, alpha_carrier_right_x, s9_54);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s9_55 = fnma(work.s8_545, a_chassis_y, work.s8_597);
  const double s9_56 = fnma(work.s8_551, a_chassis_z, fnma(work.s8_548, a_chassis_x, s9_55));
  const double s9_57 = fnma(work.s8_584, alpha_chassis_y, s9_56);
  const double s9_58 = fnma(work.s8_561, alpha_chassis_x, s9_57);
  const double s9_59 = work.s8_546*fnma(work.s8_573, alpha_chassis_z, s9_58);
  const double s9_60 = fnma(work.s8_146, a_chassis_y, work.s8_541);
  const double s9_61 = fnma(work.s8_132, a_chassis_z, fnma(work.s8_127, a_chassis_x, s9_60));
  const double s9_62 = fnma(work.s8_450, alpha_chassis_y, s9_61);
  const double s9_63 = fnma(work.s8_430, alpha_chassis_x, s9_62);
  const double s9_64 = fnma(work.s8_484, s9_59, fnma(work.s8_440, alpha_chassis_z, s9_63));
  const double s9_65 = work.s8_542*s9_64;
  const double s9_66 = fma(projection.Rz[42], s9_59, projection.zdd_star[14]);
  result.zdd[Coordinate::rear_axle_tx] = fma(projection.Rz[43], s9_65, s9_66);
  const double s9_67 = fma(projection.Rz[44], s9_59, projection.zdd_star[15]);
  result.zdd[Coordinate::rear_axle_ty] = fma(projection.Rz[45], s9_65, s9_67);
  const double s9_68 = fma(projection.Rz[46], s9_59, projection.zdd_star[16]);
  result.zdd[Coordinate::rear_axle_tz] = fma(projection.Rz[47], s9_65, s9_68);
  const double s9_69 = fma(projection.Rz[48], s9_59, projection.zdd_star[17]);
  result.zdd[Coordinate::rear_axle_rz] = fma(projection.Rz[49], s9_65, s9_69);
  const double s9_70 = fma(projection.Rz[50], s9_59, projection.zdd_star[18]);
  result.zdd[Coordinate::rear_axle_ry] = fma(projection.Rz[51], s9_65, s9_70);
  const double s9_71 = fma(projection.Rz[52], s9_59, projection.zdd_star[19]);
  result.zdd[Coordinate::rear_axle_rx] = fma(projection.Rz[53], s9_65, s9_71);
  const double s9_72 = fma(projection.Rz[54], s9_59, projection.zdd_star[20]);
  result.zdd[Coordinate::arb_rear_left] = fma(projection.Rz[55], s9_65, s9_72);
  const double s9_73 = fma(projection.Rz[56], s9_59, projection.zdd_star[21]);
  result.zdd[Coordinate::arb_rear_right] = fma(projection.Rz[57], s9_65, s9_73);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s9_74 = fma(work.s3_10, s9_65, work.s8_98 + alpha_chassis_x);
  const double alpha_rear_axle_x = fma(work.s3_8, s9_59, s9_74);
  const double s9_75 = fma(work.s3_4, s9_65, work.s8_85 + alpha_chassis_y);
  const double alpha_rear_axle_y = fma(work.s3_2, s9_59, s9_75);
  const double s9_76 = fma(work.s3_6, s9_65, work.s8_82 + alpha_chassis_z);
  const double alpha_rear_axle_z = fma(work.s3_5, s9_59, s9_76);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s9_77 = work.R_rear_axle_y_y*alpha_rear_axle_y;
  const double s9_78 = fma(work.R_rear_axle_z_y, alpha_rear_axle_z, s9_77);
  const double s9_79 = fma(work.R_rear_axle_x_y, alpha_rear_axle_x, s9_78);
  result.zdd[Coordinate::wheel_rear_left] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_left], s9_79);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  result.zdd[Coordinate::wheel_rear_right] = fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_right], s9_79);
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
  compute_chosen_accelerations_4(state, tau, projection, work, result);
  compute_chosen_accelerations_5(state, tau, projection, work, result);
}
#endif  // part 1

void compute_outputs(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, const Derivative& derivative, Outputs& __restrict result) noexcept;

#if MBGEN_IS_PART(1)
/// Values of compute_outputs that cross its parts.
struct OutputsWork {
  double
      sines[22], cosines[22], r_chassis_aux3_z, R_chassis_z_y, R_chassis_z_z, r_carrier_left_aux1_y,
      r_carrier_left_aux1_z, s1_12, R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y,
      R_carrier_left_x_x, R_carrier_left_x_z, R_carrier_left_y_x, R_carrier_left_y_z,
      R_carrier_left_z_x, R_carrier_left_z_z, r_wheel_front_left_x, r_wheel_front_left_y,
      r_wheel_front_left_z, r_carrier_right_aux1_y, s1_28, s1_30, R_carrier_right_aux2_y_y,
      R_carrier_right_aux2_z_y, R_carrier_right_x_x, R_carrier_right_x_z, R_carrier_right_y_x,
      R_carrier_right_y_z, R_carrier_right_z_x, R_carrier_right_z_z, r_wheel_front_right_x,
      r_wheel_front_right_y, r_wheel_front_right_z, r_rear_axle_aux1_x, r_rear_axle_aux3_z,
      R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y,
      R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z, r_wheel_rear_left_x, r_wheel_rear_left_y,
      r_wheel_rear_left_z, r_wheel_rear_right_x, r_wheel_rear_right_y, r_wheel_rear_right_z,
      v_chassis_x, v_chassis_y, v_chassis_z, w_chassis_x, w_chassis_y, w_chassis_z, s4_4,
      v_lower_arm_left_x, v_lower_arm_left_y, s4_6, v_lower_arm_left_z, w_lower_arm_left_x,
      v_carrier_left_aux1_x, v_carrier_left_aux1_y, v_carrier_left_aux1_z, w_carrier_left_x,
      w_carrier_left_y, w_carrier_left_z, v_wheel_front_left_x, v_wheel_front_left_y,
      v_wheel_front_left_z, w_wheel_front_left_x, w_wheel_front_left_y, w_wheel_front_left_z,
      v_upper_arm_left_x, v_upper_arm_left_y, v_upper_arm_left_z, w_upper_arm_left_x,
      v_arb_front_left_x, v_arb_front_left_y, v_arb_front_left_z, w_arb_front_left_y, s4_16,
      v_lower_arm_right_x, v_lower_arm_right_z, w_lower_arm_right_x, v_carrier_right_aux1_x,
      v_carrier_right_aux1_y, v_carrier_right_aux1_z, w_carrier_right_x, w_carrier_right_y,
      w_carrier_right_z, v_wheel_front_right_x, v_wheel_front_right_y, v_wheel_front_right_z,
      w_wheel_front_right_x, w_wheel_front_right_y, w_wheel_front_right_z, v_upper_arm_right_x,
      v_upper_arm_right_z, w_upper_arm_right_x, v_arb_front_right_x, v_arb_front_right_z,
      w_arb_front_right_y, v_pitman_arm_x, v_pitman_arm_y, v_pitman_arm_z, w_pitman_arm_y,
      v_bell_crank_x, v_bell_crank_y, v_bell_crank_z, w_bell_crank_z, v_rear_axle_aux3_x,
      v_rear_axle_aux3_y, v_rear_axle_aux3_z, w_rear_axle_x, w_rear_axle_y, w_rear_axle_z,
      v_wheel_rear_left_x, v_wheel_rear_left_y, v_wheel_rear_left_z, w_wheel_rear_left_x,
      w_wheel_rear_left_y, w_wheel_rear_left_z, v_arb_rear_left_x, v_arb_rear_left_y,
      v_arb_rear_left_z, w_arb_rear_left_y, v_wheel_rear_right_x, v_wheel_rear_right_y,
      v_wheel_rear_right_z, w_wheel_rear_right_x, w_wheel_rear_right_y, w_wheel_rear_right_z,
      v_arb_rear_right_x, v_arb_rear_right_z, w_arb_rear_right_y, s7_2, s7_4, s7_7, s7_10, s7_13,
      s7_15, s7_17, s7_20, s7_23, s7_26, s7_27, s7_28, s7_29, s7_30, s7_33, s7_34, s7_37, s7_40,
      s7_43, s7_44, s7_45, s7_48, s7_51, s7_54, s7_57, s7_60, s7_63, s7_65, s7_67, s7_69, s7_70,
      s7_75, s7_77, s7_78, s7_79, s7_80, s7_81, s7_82, s7_83, s7_84, s7_85, s7_86, s7_87, s7_88;
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
  // chassis_aux5: chassis_ry, revolute, chassis_aux4
  const double R_chassis_aux4_x_x = work.cosines[0];
  const double R_chassis_aux5_z_z = work.cosines[1];
  const double R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  const double R_chassis_aux4_y_x = work.sines[0];
  const double R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s1_1 = work.sines[1];
  const double s1_2 = work.sines[2];
  const double s1_3 = s1_1*s1_2;
  const double s1_4 = work.cosines[2];
  const double R_chassis_x_y = fnma(R_chassis_aux4_y_x, s1_4, R_chassis_aux4_x_x*s1_3);
  const double s1_5 = s1_1*s1_4;
  const double R_chassis_x_z = fma(R_chassis_aux4_x_x, s1_5, R_chassis_aux4_y_x*s1_2);
  const double R_chassis_y_y = fma(R_chassis_aux4_y_x, s1_3, R_chassis_aux4_x_x*s1_4);
  const double R_chassis_y_z = fnma(R_chassis_aux4_x_x, s1_2, R_chassis_aux4_y_x*s1_5);
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_2;
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_4;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s1_6 = work.sines[4];
  const double R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_6;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_6;
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_7 = -p_carrier_left_rz_z*R_lower_arm_left_z_y;
  const double s1_8 = fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_7);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + s1_8;
  const double s1_9 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_10 = fnma(-p_carrier_left_rz_z, R_lower_arm_left_y_y, s1_9);
  work.r_carrier_left_aux1_z = s1_10 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_11 = work.cosines[5];
  work.s1_12 = s1_6*s1_11;
  const double s1_13 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_6*s1_13;
  work.R_carrier_left_aux2_y_y = fnma(R_lower_arm_left_z_y, s1_13, R_carrier_left_aux1_y_y*s1_11);
  const double s1_14 = fma(R_carrier_left_aux1_y_y, s1_13, R_lower_arm_left_z_y*s1_11);
  work.R_carrier_left_aux2_z_y = fma(R_carrier_left_aux1_z_y, s1_11, R_lower_arm_left_y_y*s1_13);
  const double R_carrier_left_aux2_z_z = fnma(R_carrier_left_aux1_z_y, s1_13,
      R_lower_arm_left_y_y*s1_11);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_15 = work.cosines[6];
  const double s1_16 = work.sines[6];
  work.R_carrier_left_x_x = fnma(R_carrier_left_aux2_x_z, s1_16, R_carrier_left_aux1_x_x*s1_15);
  work.R_carrier_left_x_z = fma(R_carrier_left_aux2_x_z, s1_15, R_carrier_left_aux1_x_x*s1_16);
  work.R_carrier_left_y_x = fma(s1_14, s1_16, R_carrier_left_aux1_y_x*s1_15);
  work.R_carrier_left_y_z = fnma(s1_14, s1_15, R_carrier_left_aux1_y_x*s1_16);
  work.R_carrier_left_z_x = fnma(R_carrier_left_aux2_z_z, s1_16, R_carrier_left_aux1_z_x*s1_15);
  work.R_carrier_left_z_z = fma(R_carrier_left_aux2_z_z, s1_15, R_carrier_left_aux1_z_x*s1_16);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_17 = p_wheel_front_left_z*work.R_carrier_left_x_z;
  const double s1_18 = fnma(p_wheel_front_left_y, work.s1_12, s1_17);
  work.r_wheel_front_left_x = p_lower_arm_left_x + s1_18;
  const double s1_19 = p_wheel_front_left_y*work.R_carrier_left_aux2_y_y;
  const double s1_20 = fma(p_wheel_front_left_z, work.R_carrier_left_y_z, s1_19);
  work.r_wheel_front_left_y = work.r_carrier_left_aux1_y + s1_20;
  const double s1_21 = p_wheel_front_left_y*work.R_carrier_left_aux2_z_y;
  const double s1_22 = fma(p_wheel_front_left_z, work.R_carrier_left_z_z, s1_21);
  work.r_wheel_front_left_z = work.r_carrier_left_aux1_z + s1_22;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_23 = work.sines[10];
  const double R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_23;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_23;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_24 = -p_carrier_right_rz_z*R_lower_arm_right_z_y;
  const double s1_25 = fnma(-p_carrier_right_rz_y, R_lower_arm_right_y_y, s1_24);
  work.r_carrier_right_aux1_y = s1_25 - (-p_lower_arm_right_y);
  const double s1_26 = -p_carrier_right_rz_y*R_lower_arm_right_z_y;
  const double s1_27 = fma(-p_carrier_right_rz_z, R_lower_arm_right_y_y, s1_26);
  work.s1_28 = -p_lower_arm_right_z + s1_27;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_29 = work.cosines[11];
  work.s1_30 = s1_23*s1_29;
  const double s1_31 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_23*s1_31;
  work.R_carrier_right_aux2_y_y = fnma(R_lower_arm_right_z_y, s1_31,
      R_carrier_right_aux1_y_y*s1_29);
  const double s1_32 = fma(R_carrier_right_aux1_y_y, s1_31, R_lower_arm_right_z_y*s1_29);
  work.R_carrier_right_aux2_z_y = fma(R_carrier_right_aux1_z_y, s1_29, R_lower_arm_right_y_y*s1_31);
  const double R_carrier_right_aux2_z_z = fnma(R_carrier_right_aux1_z_y, s1_31,
      R_lower_arm_right_y_y*s1_29);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_33 = work.cosines[12];
  const double s1_34 = work.sines[12];
  work.R_carrier_right_x_x = fnma(R_carrier_right_aux2_x_z, s1_34, R_carrier_right_aux1_x_x*s1_33);
  work.R_carrier_right_x_z = fma(R_carrier_right_aux2_x_z, s1_33, R_carrier_right_aux1_x_x*s1_34);
  work.R_carrier_right_y_x = fma(s1_32, s1_34, R_carrier_right_aux1_y_x*s1_33);
  work.R_carrier_right_y_z = fnma(s1_32, s1_33, R_carrier_right_aux1_y_x*s1_34);
  work.R_carrier_right_z_x = fnma(R_carrier_right_aux2_z_z, s1_34, R_carrier_right_aux1_z_x*s1_33);
  work.R_carrier_right_z_z = fma(R_carrier_right_aux2_z_z, s1_33, R_carrier_right_aux1_z_x*s1_34);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_35 = -p_wheel_front_right_y*work.s1_30;
  const double s1_36 = fma(p_wheel_front_right_z, work.R_carrier_right_x_z, s1_35);
  work.r_wheel_front_right_x = p_lower_arm_right_x + s1_36;
  const double s1_37 = p_wheel_front_right_z*work.R_carrier_right_y_z;
  const double s1_38 = fnma(-p_wheel_front_right_y, work.R_carrier_right_aux2_y_y, s1_37);
  work.r_wheel_front_right_y = work.r_carrier_right_aux1_y + s1_38;
  const double s1_39 = p_wheel_front_right_z*work.R_carrier_right_z_z;
  const double s1_40 = fnma(-p_wheel_front_right_y, work.R_carrier_right_aux2_z_y, s1_39);
  work.r_wheel_front_right_z = s1_40 - work.s1_28;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double z_rear_axle_tz = state.z[Coordinate::rear_axle_tz];
  work.r_rear_axle_aux3_z = z_rear_axle_tz - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_41 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_41;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_41;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_42 = work.sines[19];
  const double s1_43 = work.cosines[19];
  work.R_rear_axle_x_y = fnma(R_rear_axle_aux4_y_x, s1_43, R_rear_axle_aux5_x_z*s1_42);
  work.R_rear_axle_x_z = fma(R_rear_axle_aux5_x_z, s1_43, R_rear_axle_aux4_y_x*s1_42);
  work.R_rear_axle_y_y = fma(R_rear_axle_aux5_y_z, s1_42, R_rear_axle_aux4_x_x*s1_43);
  work.R_rear_axle_y_z = fnma(R_rear_axle_aux4_x_x, s1_42, R_rear_axle_aux5_y_z*s1_43);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_42;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_43;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_44 = p_wheel_rear_left_y*work.R_rear_axle_x_y;
  work.r_wheel_rear_left_x = work.r_rear_axle_aux1_x + s1_44;
  const double s1_45 = p_wheel_rear_left_y*work.R_rear_axle_y_y;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.r_wheel_rear_left_y = z_rear_axle_ty + s1_45;
  const double s1_46 = p_wheel_rear_left_y*work.R_rear_axle_z_y;
  work.r_wheel_rear_left_z = work.r_rear_axle_aux3_z + s1_46;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  work.r_wheel_rear_right_x = work.r_rear_axle_aux1_x - s1_44;
  work.r_wheel_rear_right_y = z_rear_axle_ty - s1_45;
  work.r_wheel_rear_right_z = work.r_rear_axle_aux3_z - s1_46;
  // operations: 57 add, 103 multiply, 44 sin cos

  // --- step 4: velocities ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_tx = state.zd[Coordinate::chassis_tx];
  const double zd_chassis_ty = state.zd[Coordinate::chassis_ty];
  const double zd_chassis_tz = state.zd[Coordinate::chassis_tz];
  const double s4_1 = fma(zd_chassis_ty, R_chassis_aux5_y_x, zd_chassis_tx*R_chassis_aux5_x_x);
  work.v_chassis_x = fnma(zd_chassis_tz, s1_1, s4_1);
  const double s4_2 = fma(zd_chassis_tx, R_chassis_x_y, zd_chassis_tz*work.R_chassis_z_y);
  work.v_chassis_y = fma(zd_chassis_ty, R_chassis_y_y, s4_2);
  const double s4_3 = fma(zd_chassis_tx, R_chassis_x_z, zd_chassis_tz*work.R_chassis_z_z);
  work.v_chassis_z = fma(zd_chassis_ty, R_chassis_y_z, s4_3);
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  work.w_chassis_x = fnma(zd_chassis_rz, s1_1, state.zd[Coordinate::chassis_rx]);
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.w_chassis_y = fma(zd_chassis_ry, s1_4, zd_chassis_rz*work.R_chassis_z_y);
  work.w_chassis_z = fnma(zd_chassis_ry, s1_2, zd_chassis_rz*work.R_chassis_z_z);
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s4_4 = fnma(p_lower_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_lower_arm_left_x = fnma(-p_lower_arm_left_z, work.w_chassis_y, work.s4_4);
  const double s4_5 = fma(p_lower_arm_left_x, work.w_chassis_z, work.v_chassis_y);
  work.v_lower_arm_left_y = fma(-p_lower_arm_left_z, work.w_chassis_x, s4_5);
  work.s4_6 = fma(p_lower_arm_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_lower_arm_left_z = fnma(p_lower_arm_left_x, work.w_chassis_y, work.s4_6);
  work.w_lower_arm_left_x = state.zd[Coordinate::lower_arm_left] + work.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s4_7 = fma(s1_10, work.w_chassis_y, work.v_lower_arm_left_x);
  work.v_carrier_left_aux1_x = fnma(s1_8, work.w_chassis_z, s4_7);
  work.v_carrier_left_aux1_y = fnma(s1_10, work.w_lower_arm_left_x, work.v_lower_arm_left_y);
  work.v_carrier_left_aux1_z = fma(s1_8, work.w_lower_arm_left_x, work.v_lower_arm_left_z);
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double w_carrier_left_aux1_y = fnma(zd_carrier_left_rz, R_lower_arm_left_z_y,
      work.w_chassis_y);
  const double w_carrier_left_aux1_z = fma(zd_carrier_left_rz, R_lower_arm_left_y_y,
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
  work.w_carrier_left_x = fnma(zd_carrier_left_ry, work.s1_12, w_carrier_left_aux2_x);
  work.w_carrier_left_y = fma(zd_carrier_left_ry, work.R_carrier_left_aux2_y_y,
      w_carrier_left_aux2_y);
  work.w_carrier_left_z = fma(zd_carrier_left_ry, work.R_carrier_left_aux2_z_y,
      w_carrier_left_aux2_z);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s4_8 = fma(s1_22, work.w_carrier_left_y, work.v_carrier_left_aux1_x);
  work.v_wheel_front_left_x = fnma(s1_20, work.w_carrier_left_z, s4_8);
  const double s4_9 = fma(s1_18, work.w_carrier_left_z, work.v_carrier_left_aux1_y);
  work.v_wheel_front_left_y = fnma(s1_22, work.w_carrier_left_x, s4_9);
  const double s4_10 = fma(s1_20, work.w_carrier_left_x, work.v_carrier_left_aux1_z);
  work.v_wheel_front_left_z = fnma(s1_18, work.w_carrier_left_y, s4_10);
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  work.w_wheel_front_left_x = fnma(zd_wheel_front_left, work.s1_12, work.w_carrier_left_x);
  work.w_wheel_front_left_y = fma(zd_wheel_front_left, work.R_carrier_left_aux2_y_y,
      work.w_carrier_left_y);
  work.w_wheel_front_left_z = fma(zd_wheel_front_left, work.R_carrier_left_aux2_z_y,
      work.w_carrier_left_z);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s4_11 = fnma(-p_upper_arm_left_z, work.w_chassis_y, work.v_chassis_x);
  work.v_upper_arm_left_x = fnma(p_upper_arm_left_y, work.w_chassis_z, s4_11);
  work.v_upper_arm_left_y = fma(-p_upper_arm_left_z, work.w_chassis_x, s4_5);
  const double s4_12 = fma(p_upper_arm_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_upper_arm_left_z = fnma(p_lower_arm_left_x, work.w_chassis_y, s4_12);
  work.w_upper_arm_left_x = state.zd[Coordinate::upper_arm_left] + work.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s4_13 = fnma(-p_arb_front_left_z, work.w_chassis_y, work.v_chassis_x);
  work.v_arb_front_left_x = fnma(p_arb_front_left_y, work.w_chassis_z, s4_13);
  const double s4_14 = fma(p_upper_arm_left_y, work.w_chassis_x, work.v_chassis_y);
  work.v_arb_front_left_y = fma(p_arb_front_left_x, work.w_chassis_z, s4_14);
  const double s4_15 = fma(p_arb_front_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_arb_front_left_z = fnma(p_arb_front_left_x, work.w_chassis_y, s4_15);
  work.w_arb_front_left_y = state.zd[Coordinate::arb_front_left] + work.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s4_16 = fma(p_lower_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_lower_arm_right_x = fnma(-p_lower_arm_left_z, work.w_chassis_y, work.s4_16);
  const double s4_17 = fnma(p_lower_arm_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_lower_arm_right_z = fnma(p_lower_arm_left_x, work.w_chassis_y, s4_17);
  work.w_lower_arm_right_x = state.zd[Coordinate::lower_arm_right] + work.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s4_18 = fnma(s1_27, work.w_chassis_y, work.v_lower_arm_right_x);
  work.v_carrier_right_aux1_x = fnma(s1_25, work.w_chassis_z, s4_18);
  work.v_carrier_right_aux1_y = fma(s1_27, work.w_lower_arm_right_x, work.v_lower_arm_left_y);
  work.v_carrier_right_aux1_z = fma(s1_25, work.w_lower_arm_right_x, work.v_lower_arm_right_z);
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double w_carrier_right_aux1_y = fnma(zd_carrier_right_rz, R_lower_arm_right_z_y,
      work.w_chassis_y);
  const double w_carrier_right_aux1_z = fma(zd_carrier_right_rz, R_lower_arm_right_y_y,
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
  work.w_carrier_right_x = fnma(zd_carrier_right_ry, work.s1_30, w_carrier_right_aux2_x);
  work.w_carrier_right_y = fma(zd_carrier_right_ry, work.R_carrier_right_aux2_y_y,
      w_carrier_right_aux2_y);
  work.w_carrier_right_z = fma(zd_carrier_right_ry, work.R_carrier_right_aux2_z_y,
      w_carrier_right_aux2_z);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s4_19 = fma(s1_40, work.w_carrier_right_y, work.v_carrier_right_aux1_x);
  work.v_wheel_front_right_x = fnma(s1_38, work.w_carrier_right_z, s4_19);
  const double s4_20 = fma(s1_36, work.w_carrier_right_z, work.v_carrier_right_aux1_y);
  work.v_wheel_front_right_y = fnma(s1_40, work.w_carrier_right_x, s4_20);
  const double s4_21 = fma(s1_38, work.w_carrier_right_x, work.v_carrier_right_aux1_z);
  work.v_wheel_front_right_z = fnma(s1_36, work.w_carrier_right_y, s4_21);
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  work.w_wheel_front_right_x = fnma(zd_wheel_front_right, work.s1_30, work.w_carrier_right_x);
  work.w_wheel_front_right_y = fma(zd_wheel_front_right, work.R_carrier_right_aux2_y_y,
      work.w_carrier_right_y);
  work.w_wheel_front_right_z = fma(zd_wheel_front_right, work.R_carrier_right_aux2_z_y,
      work.w_carrier_right_z);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s4_22 = fma(p_upper_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_upper_arm_right_x = fnma(-p_upper_arm_left_z, work.w_chassis_y, s4_22);
  const double s4_23 = fnma(p_lower_arm_left_x, work.w_chassis_y, work.v_chassis_z);
  work.v_upper_arm_right_z = fnma(p_upper_arm_left_y, work.w_chassis_x, s4_23);
  work.w_upper_arm_right_x = state.zd[Coordinate::upper_arm_right] + work.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s4_24 = fma(p_arb_front_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_arb_front_right_x = fnma(-p_arb_front_left_z, work.w_chassis_y, s4_24);
  const double s4_25 = fnma(p_arb_front_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_arb_front_right_z = fnma(p_arb_front_left_x, work.w_chassis_y, s4_25);
  work.w_arb_front_right_y = state.zd[Coordinate::arb_front_right] + work.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s4_26 = fnma(p_upper_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_pitman_arm_x = fnma(-p_pitman_arm_z, work.w_chassis_y, s4_26);
  const double s4_27 = fma(p_lower_arm_left_y, work.w_chassis_x, work.v_chassis_y);
  work.v_pitman_arm_y = fma(p_pitman_arm_x, work.w_chassis_z, s4_27);
  work.v_pitman_arm_z = fnma(p_pitman_arm_x, work.w_chassis_y, s4_12);
  work.w_pitman_arm_y = state.zd[Coordinate::pitman_arm] + work.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  work.v_bell_crank_x = fnma(-p_bell_crank_z, work.w_chassis_y, work.v_chassis_x);
  const double s4_28 = fma(-p_bell_crank_z, work.w_chassis_x, work.v_chassis_y);
  work.v_bell_crank_y = fma(p_bell_crank_x, work.w_chassis_z, s4_28);
  work.v_bell_crank_z = fnma(p_bell_crank_x, work.w_chassis_y, work.v_chassis_z);
  work.w_bell_crank_z = state.zd[Coordinate::bell_crank] + work.w_chassis_z;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double s4_29 = state.zd[Coordinate::rear_axle_tx] + work.v_chassis_x;
  const double v_rear_axle_aux1_x = fnma(-p_arb_front_left_z, work.w_chassis_y, s4_29);
  const double v_rear_axle_aux1_y = fma(work.r_rear_axle_aux1_x, work.w_chassis_z, s4_14);
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
  const double w_rear_axle_aux4_z = state.zd[Coordinate::rear_axle_rz] + work.w_chassis_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double w_rear_axle_aux5_x = fnma(zd_rear_axle_ry, R_rear_axle_aux4_y_x, work.w_chassis_x);
  const double w_rear_axle_aux5_y = fma(zd_rear_axle_ry, R_rear_axle_aux4_x_x, work.w_chassis_y);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.w_rear_axle_x = fma(zd_rear_axle_rx, work.R_rear_axle_aux5_x_x, w_rear_axle_aux5_x);
  work.w_rear_axle_y = fma(zd_rear_axle_rx, work.R_rear_axle_aux5_y_x, w_rear_axle_aux5_y);
  work.w_rear_axle_z = fnma(zd_rear_axle_rx, s1_41, w_rear_axle_aux4_z);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s4_30 = fma(s1_46, work.w_rear_axle_y, work.v_rear_axle_aux3_x);
  work.v_wheel_rear_left_x = fnma(s1_45, work.w_rear_axle_z, s4_30);
  const double s4_31 = fma(s1_44, work.w_rear_axle_z, work.v_rear_axle_aux3_y);
  work.v_wheel_rear_left_y = fnma(s1_46, work.w_rear_axle_x, s4_31);
  const double s4_32 = fma(s1_45, work.w_rear_axle_x, work.v_rear_axle_aux3_z);
  work.v_wheel_rear_left_z = fnma(s1_44, work.w_rear_axle_y, s4_32);
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  work.w_wheel_rear_left_x = fma(zd_wheel_rear_left, work.R_rear_axle_x_y, work.w_rear_axle_x);
  work.w_wheel_rear_left_y = fma(zd_wheel_rear_left, work.R_rear_axle_y_y, work.w_rear_axle_y);
  work.w_wheel_rear_left_z = fma(zd_wheel_rear_left, work.R_rear_axle_z_y, work.w_rear_axle_z);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s4_33 = fnma(p_arb_front_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_arb_rear_left_x = fnma(-p_arb_rear_left_z, work.w_chassis_y, s4_33);
  const double s4_34 = fma(p_arb_front_left_y, work.w_chassis_x, work.v_chassis_y);
  work.v_arb_rear_left_y = fnma(-p_arb_rear_left_x, work.w_chassis_z, s4_34);
  work.v_arb_rear_left_z = fma(-p_arb_rear_left_x, work.w_chassis_y, s4_15);
  work.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s4_35 = fma(s1_45, work.w_rear_axle_z, work.v_rear_axle_aux3_x);
  work.v_wheel_rear_right_x = fnma(s1_46, work.w_rear_axle_y, s4_35);
  const double s4_36 = fma(s1_46, work.w_rear_axle_x, work.v_rear_axle_aux3_y);
  work.v_wheel_rear_right_y = fnma(s1_44, work.w_rear_axle_z, s4_36);
  const double s4_37 = fma(s1_44, work.w_rear_axle_y, work.v_rear_axle_aux3_z);
  work.v_wheel_rear_right_z = fnma(s1_45, work.w_rear_axle_x, s4_37);
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  work.w_wheel_rear_right_x = fma(zd_wheel_rear_right, work.R_rear_axle_x_y, work.w_rear_axle_x);
  work.w_wheel_rear_right_y = fma(zd_wheel_rear_right, work.R_rear_axle_y_y, work.w_rear_axle_y);
  work.w_wheel_rear_right_z = fma(zd_wheel_rear_right, work.R_rear_axle_z_y, work.w_rear_axle_z);
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.v_arb_rear_right_x = fnma(-p_arb_rear_left_z, work.w_chassis_y, s4_24);
  const double s4_38 = fma(-p_arb_rear_left_x, work.w_chassis_y, work.v_chassis_z);
  work.v_arb_rear_right_z = fnma(p_arb_front_left_y, work.w_chassis_x, s4_38);
  work.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + work.w_chassis_y;
  // operations: 141 add, 132 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_1 = -p_arb_link_front_left_from_x*R_arb_front_left_x_z;
  work.s7_2 = fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s7_1);
  const double s7_3 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s7_4 = fnma(-p_arb_link_front_left_from_x, R_arb_front_left_x_x, s7_3);
  const double s7_5 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s7_6 = work.s1_12 + work.R_carrier_left_x_z;
  work.s7_7 = fma(-p_arb_link_front_left_to_y, s7_6, s7_5);
  const double s7_8 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s7_9 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s7_10 = fma(-p_arb_link_front_left_to_y, s7_8, s7_9);
  const double s7_11 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s7_12 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s7_13 = fma(-p_arb_link_front_left_to_y, s7_11, s7_12);
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_14 = -p_arb_link_front_right_from_x*R_arb_front_right_x_z;
  work.s7_15 = fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s7_14);
  const double s7_16 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s7_17 = fnma(-p_arb_link_front_right_from_x, R_arb_front_right_x_x, s7_16);
  const double s7_18 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s7_19 = work.R_carrier_right_x_z - work.s1_30;
  work.s7_20 = fma(-p_arb_link_front_left_to_y, s7_19, s7_18);
  const double s7_21 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s7_22 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s7_23 = fma(-p_arb_link_front_left_to_y, s7_21, s7_22);
  const double s7_24 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s7_25 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s7_26 = fma(-p_arb_link_front_left_to_y, s7_24, s7_25);
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
  work.s7_33 = fma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s7_31);
  work.s7_34 = fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_32);
  const double s7_35 = -p_tie_rod_left_to_y*work.s1_12;
  const double s7_36 = fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, s7_35);
  work.s7_37 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_x_x, s7_36);
  const double s7_38 = p_tie_rod_left_to_z*work.R_carrier_left_y_z;
  const double s7_39 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_y_x, s7_38);
  work.s7_40 = fnma(-p_tie_rod_left_to_y, work.R_carrier_left_aux2_y_y, s7_39);
  const double s7_41 = p_tie_rod_left_to_z*work.R_carrier_left_z_z;
  const double s7_42 = fnma(-p_tie_rod_left_to_x, work.R_carrier_left_z_x, s7_41);
  work.s7_43 = fnma(-p_tie_rod_left_to_y, work.R_carrier_left_aux2_z_y, s7_42);
  // tie_rod_right
  work.s7_44 = fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_32);
  work.s7_45 = fnma(-p_tie_rod_left_from_x, R_bell_crank_x_x, s7_31);
  const double s7_46 = p_tie_rod_right_to_z*work.R_carrier_right_x_z;
  const double s7_47 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_x_x, s7_46);
  work.s7_48 = fnma(p_tie_rod_right_to_y, work.s1_30, s7_47);
  const double s7_49 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s7_50 = fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, s7_49);
  work.s7_51 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_y_x, s7_50);
  const double s7_52 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s7_53 = fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, s7_52);
  work.s7_54 = fnma(-p_tie_rod_right_to_x, work.R_carrier_right_z_x, s7_53);
  // long_rod_left
  const double s7_55 = p_long_rod_left_to_x*s1_41;
  const double s7_56 = fma(-p_long_rod_left_to_z, work.R_rear_axle_z_z, s7_55);
  work.s7_57 = fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_56);
  const double s7_58 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_59 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_x_z, s7_58);
  work.s7_60 = fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_59);
  const double s7_61 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_62 = fnma(-p_long_rod_left_to_z, work.R_rear_axle_y_z, s7_61);
  work.s7_63 = fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_62);
  // diag_rod_left
  const double s7_64 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  work.s7_65 = fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s7_64);
  const double s7_66 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  work.s7_67 = fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_66);
  const double s7_68 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  work.s7_69 = fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_68);
  // arb_link_rear_left
  work.s7_70 = p_arb_link_rear_left_from_x*work.sines[20];
  const double s7_71 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_72 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_y_z, s7_71);
  const double s7_73 = -p_arb_link_rear_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_74 = fma(-p_arb_link_rear_left_to_z, work.R_rear_axle_x_z, s7_73);
  work.s7_75 = p_arb_link_rear_left_from_x*work.cosines[20];
  const double s7_76 = -p_arb_link_rear_left_to_x*s1_41;
  work.s7_77 = fnma(-p_arb_link_rear_left_to_z, work.R_rear_axle_z_z, s7_76);
  work.s7_78 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, work.s7_77);
  work.s7_79 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_74);
  work.s7_80 = fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_72);
  // long_rod_right
  work.s7_81 = fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_56);
  work.s7_82 = fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_59);
  work.s7_83 = fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_62);
  // diag_rod_right
  work.s7_84 = fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s7_64);
  work.s7_85 = fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_66);
  work.s7_86 = fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_68);
  // arb_link_rear_right
  work.s7_87 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_72);
  work.s7_88 = fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_74);
}

/// Part 2 of compute_outputs: step 7: inertias of the bodies and forces on joints; step 9: outputs,
/// energies, power.
[[gnu::noinline]] void compute_outputs_2(const State& state, const double* tau,
    OutputsWork& __restrict work, Outputs& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // arb_link_rear_right
  const double R_arb_rear_right_x_z = work.sines[21];
  const double s7_89 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_z;
  const double s7_90 = fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, work.s7_77);
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
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_103 = work.R_rear_axle_y_z*work.w_wheel_rear_right_y;
  const double s7_104 = fma(work.R_rear_axle_z_z, work.w_wheel_rear_right_z, s7_103);
  const double s7_105 = fma(work.R_rear_axle_x_z, work.w_wheel_rear_right_x, s7_104);
  const double s7_106 = work.R_rear_axle_aux5_y_x*work.w_wheel_rear_right_y;
  const double s1_41 = work.sines[18];
  const double s7_107 = fma(work.R_rear_axle_aux5_x_x, work.w_wheel_rear_right_x, s7_106);
  const double s7_108 = fnma(s1_41, work.w_wheel_rear_right_z, s7_107);
  const double s7_109 = I_wheel_rear_right_xx*s7_108;
  const double s7_110 = I_wheel_rear_right_zz*s7_105;
  const double s7_111 = work.R_rear_axle_y_y*work.w_wheel_rear_right_y;
  const double s7_112 = fma(work.R_rear_axle_z_y, work.w_wheel_rear_right_z, s7_111);
  const double s7_113 = fma(work.R_rear_axle_x_y, work.w_wheel_rear_right_x, s7_112);
  const double s7_114 = I_wheel_rear_right_yy*s7_113;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_z = work.sines[20];
  const double s7_115 = c_arb_rear_left_x*R_arb_rear_left_x_z;
  const double R_arb_rear_left_x_x = work.cosines[20];
  const double s7_116 = c_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s7_117 = R_arb_rear_left_x_x*work.w_chassis_x;
  const double s7_118 = fnma(R_arb_rear_left_x_z, work.w_chassis_z, s7_117);
  const double s7_119 = I_arb_rear_left_yy*work.w_arb_rear_left_y;
  const double s7_120 = fnma(-I_arb_rear_left_xy, s7_118, s7_119);
  const double s7_121 = I_arb_rear_left_xx*s7_118;
  const double s7_122 = fnma(-I_arb_rear_left_xy, work.w_arb_rear_left_y, s7_121);
  const double s7_123 = R_arb_rear_left_x_z*work.w_chassis_x;
  const double s7_124 = fma(R_arb_rear_left_x_x, work.w_chassis_z, s7_123);
  const double s7_125 = I_arb_rear_left_zz*s7_124;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_126 = work.R_rear_axle_y_z*work.w_wheel_rear_left_y;
  const double s7_127 = fma(work.R_rear_axle_z_z, work.w_wheel_rear_left_z, s7_126);
  const double s7_128 = fma(work.R_rear_axle_x_z, work.w_wheel_rear_left_x, s7_127);
  const double s7_129 = work.R_rear_axle_aux5_y_x*work.w_wheel_rear_left_y;
  const double s7_130 = fma(work.R_rear_axle_aux5_x_x, work.w_wheel_rear_left_x, s7_129);
  const double s7_131 = fnma(s1_41, work.w_wheel_rear_left_z, s7_130);
  const double s7_132 = I_wheel_rear_left_xx*s7_131;
  const double s7_133 = I_wheel_rear_left_zz*s7_128;
  const double s7_134 = work.R_rear_axle_y_y*work.w_wheel_rear_left_y;
  const double s7_135 = fma(work.R_rear_axle_z_y, work.w_wheel_rear_left_z, s7_134);
  const double s7_136 = fma(work.R_rear_axle_x_y, work.w_wheel_rear_left_x, s7_135);
  const double s7_137 = I_wheel_rear_left_yy*s7_136;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_138 = c_rear_axle_x*work.R_rear_axle_aux5_y_x;
  const double s7_139 = fma(c_rear_axle_z, work.R_rear_axle_y_z, s7_138);
  const double s7_140 = fnma(c_rear_axle_x, s1_41, c_rear_axle_z*work.R_rear_axle_z_z);
  const double s7_141 = c_rear_axle_x*work.R_rear_axle_aux5_x_x;
  const double s7_142 = fma(c_rear_axle_z, work.R_rear_axle_x_z, s7_141);
  const double s7_143 = work.R_rear_axle_y_z*work.w_rear_axle_y;
  const double s7_144 = fma(work.R_rear_axle_z_z, work.w_rear_axle_z, s7_143);
  const double s7_145 = fma(work.R_rear_axle_x_z, work.w_rear_axle_x, s7_144);
  const double s7_146 = work.R_rear_axle_aux5_y_x*work.w_rear_axle_y;
  const double s7_147 = fma(work.R_rear_axle_aux5_x_x, work.w_rear_axle_x, s7_146);
  const double s7_148 = fnma(s1_41, work.w_rear_axle_z, s7_147);
  const double s7_149 = fnma(-I_rear_axle_xz, s7_145, I_rear_axle_xx*s7_148);
  const double s7_150 = fnma(-I_rear_axle_xz, s7_148, I_rear_axle_zz*s7_145);
  const double s7_151 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s7_152 = fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s7_151);
  const double s7_153 = fma(work.R_rear_axle_x_y, work.w_rear_axle_x, s7_152);
  const double s7_154 = I_rear_axle_yy*s7_153;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_y_x = work.sines[16];
  const double R_bell_crank_x_x = work.cosines[16];
  const double s7_155 = fma(-c_bell_crank_x, R_bell_crank_x_x, c_bell_crank_y*R_bell_crank_y_x);
  const double s7_156 = fnma(-c_bell_crank_x, R_bell_crank_y_x, c_bell_crank_y*R_bell_crank_x_x);
  const double s7_157 = R_bell_crank_x_x*work.w_chassis_y;
  const double s7_158 = fnma(R_bell_crank_y_x, work.w_chassis_x, s7_157);
  const double s7_159 = I_bell_crank_zz*work.w_bell_crank_z;
  const double s7_160 = R_bell_crank_y_x*work.w_chassis_y;
  const double s7_161 = fma(R_bell_crank_x_x, work.w_chassis_x, s7_160);
  const double s7_162 = fnma(-I_bell_crank_xy, s7_161, I_bell_crank_yy*s7_158);
  const double s7_163 = fnma(-I_bell_crank_xy, s7_158, I_bell_crank_xx*s7_161);
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  const double s7_164 = -c_pitman_arm_z*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  const double s7_165 = -c_pitman_arm_z*R_pitman_arm_x_x;
  const double s7_166 = R_pitman_arm_x_x*work.w_chassis_x;
  const double s7_167 = fnma(R_pitman_arm_x_z, work.w_chassis_z, s7_166);
  const double s7_168 = I_pitman_arm_yy*work.w_pitman_arm_y;
  const double s7_169 = I_pitman_arm_xx*s7_167;
  const double s7_170 = R_pitman_arm_x_z*work.w_chassis_x;
  const double s7_171 = fma(R_pitman_arm_x_x, work.w_chassis_z, s7_170);
  const double s7_172 = I_pitman_arm_zz*s7_171;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_173 = -c_arb_front_right_x*R_arb_front_right_x_z;
  const double s7_174 = fma(c_arb_front_right_z, R_arb_front_right_x_x, s7_173);
  const double s7_175 = c_arb_front_right_z*R_arb_front_right_x_z;
  const double s7_176 = fnma(-c_arb_front_right_x, R_arb_front_right_x_x, s7_175);
  const double s7_177 = R_arb_front_right_x_x*work.w_chassis_x;
  const double s7_178 = fnma(R_arb_front_right_x_z, work.w_chassis_z, s7_177);
  const double s7_179 = R_arb_front_right_x_z*work.w_chassis_x;
  const double s7_180 = fma(R_arb_front_right_x_x, work.w_chassis_z, s7_179);
  const double s7_181 = I_arb_front_right_yy*work.w_arb_front_right_y;
  const double s7_182 = fma(I_arb_front_right_yz, s7_180, s7_181);
  const double s7_183 = fnma(-I_arb_front_right_xy, s7_178, s7_182);
  const double s7_184 = fma(I_arb_front_right_xx, s7_178, I_arb_front_right_xz*s7_180);
  const double s7_185 = fnma(-I_arb_front_right_xy, work.w_arb_front_right_y, s7_184);
  const double s7_186 = I_arb_front_right_yz*work.w_arb_front_right_y;
  const double s7_187 = fma(I_arb_front_right_xz, s7_178, s7_186);
  const double s7_188 = fma(I_arb_front_right_zz, s7_180, s7_187);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_189 = -c_upper_arm_right_z*R_upper_arm_right_z_y;
  const double s7_190 = fnma(-c_upper_arm_right_y, R_upper_arm_right_y_y, s7_189);
  const double s7_191 = -c_upper_arm_right_y*R_upper_arm_right_z_y;
  const double s7_192 = fma(-c_upper_arm_right_z, R_upper_arm_right_y_y, s7_191);
  const double s7_193 = R_upper_arm_right_z_y*work.w_chassis_z;
  const double s7_194 = fma(R_upper_arm_right_y_y, work.w_chassis_y, s7_193);
  const double s7_195 = R_upper_arm_right_y_y*work.w_chassis_z;
  const double s7_196 = fnma(R_upper_arm_right_z_y, work.w_chassis_y, s7_195);
  const double s7_197 = I_upper_arm_right_zz*s7_196;
  const double s7_198 = I_upper_arm_right_yy*s7_194;
  const double s7_199 = I_upper_arm_right_xx*work.w_upper_arm_right_x;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_200 = work.R_carrier_right_y_x*work.w_wheel_front_right_y;
  const double s7_201 = fma(work.R_carrier_right_x_x, work.w_wheel_front_right_x, s7_200);
  const double s7_202 = fma(work.R_carrier_right_z_x, work.w_wheel_front_right_z, s7_201);
  const double s7_203 = work.R_carrier_right_aux2_y_y*work.w_wheel_front_right_y;
  const double s7_204 = fma(work.R_carrier_right_aux2_z_y, work.w_wheel_front_right_z, s7_203);
  const double s7_205 = fnma(work.s1_30, work.w_wheel_front_right_x, s7_204);
  const double s7_206 = I_wheel_front_right_yy*s7_205;
  const double s7_207 = I_wheel_front_right_xx*s7_202;
  const double s7_208 = work.R_carrier_right_y_z*work.w_wheel_front_right_y;
  const double s7_209 = fma(work.R_carrier_right_x_z, work.w_wheel_front_right_x, s7_208);
  const double s7_210 = fma(work.R_carrier_right_z_z, work.w_wheel_front_right_z, s7_209);
  const double s7_211 = I_wheel_front_right_zz*s7_210;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_212 = c_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_213 = fnma(-c_carrier_right_x, work.R_carrier_right_y_x, s7_212);
  const double s7_214 = fnma(-c_carrier_right_y, work.R_carrier_right_aux2_y_y, s7_213);
  const double s7_215 = c_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_216 = fnma(-c_carrier_right_x, work.R_carrier_right_z_x, s7_215);
  const double s7_217 = fnma(-c_carrier_right_y, work.R_carrier_right_aux2_z_y, s7_216);
  const double s7_218 = -c_carrier_right_y*work.s1_30;
  const double s7_219 = fma(c_carrier_right_z, work.R_carrier_right_x_z, s7_218);
  const double s7_220 = fnma(-c_carrier_right_x, work.R_carrier_right_x_x, s7_219);
  const double s7_221 = work.R_carrier_right_y_x*work.w_carrier_right_y;
  const double s7_222 = fma(work.R_carrier_right_x_x, work.w_carrier_right_x, s7_221);
  const double s7_223 = fma(work.R_carrier_right_z_x, work.w_carrier_right_z, s7_222);
  const double s7_224 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_y;
  const double s7_225 = fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s7_224);
  const double s7_226 = fnma(work.s1_30, work.w_carrier_right_x, s7_225);
  const double s7_227 = work.R_carrier_right_y_z*work.w_carrier_right_y;
  const double s7_228 = fma(work.R_carrier_right_x_z, work.w_carrier_right_x, s7_227);
  const double s7_229 = fma(work.R_carrier_right_z_z, work.w_carrier_right_z, s7_228);
  const double s7_230 = fma(I_carrier_right_yz, s7_229, I_carrier_right_yy*s7_226);
  const double s7_231 = fma(I_carrier_right_xy, s7_223, s7_230);
  const double s7_232 = fma(I_carrier_right_xx, s7_223, I_carrier_right_xy*s7_226);
  const double s7_233 = fnma(-I_carrier_right_xz, s7_229, s7_232);
  const double s7_234 = fma(I_carrier_right_zz, s7_229, I_carrier_right_yz*s7_226);
  const double s7_235 = fnma(-I_carrier_right_xz, s7_223, s7_234);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s7_236 = -c_lower_arm_right_z*R_lower_arm_right_z_y;
  const double s7_237 = fnma(-c_lower_arm_right_y, R_lower_arm_right_y_y, s7_236);
  const double s7_238 = -c_lower_arm_right_y*R_lower_arm_right_z_y;
  const double s7_239 = fma(-c_lower_arm_right_z, R_lower_arm_right_y_y, s7_238);
  const double s7_240 = R_lower_arm_right_z_y*work.w_chassis_z;
  const double s7_241 = fma(R_lower_arm_right_y_y, work.w_chassis_y, s7_240);
  const double s7_242 = R_lower_arm_right_y_y*work.w_chassis_z;
  const double s7_243 = fnma(R_lower_arm_right_z_y, work.w_chassis_y, s7_242);
  const double s7_244 = I_lower_arm_right_zz*s7_243;
  const double s7_245 = I_lower_arm_right_yy*s7_241;
  const double s7_246 = I_lower_arm_right_xx*work.w_lower_arm_right_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_247 = -c_arb_front_left_x*R_arb_front_left_x_z;
  const double s7_248 = fma(c_arb_front_left_z, R_arb_front_left_x_x, s7_247);
  const double s7_249 = c_arb_front_left_z*R_arb_front_left_x_z;
  const double s7_250 = fnma(-c_arb_front_left_x, R_arb_front_left_x_x, s7_249);
  const double s7_251 = R_arb_front_left_x_x*work.w_chassis_x;
  const double s7_252 = fnma(R_arb_front_left_x_z, work.w_chassis_z, s7_251);
  const double s7_253 = R_arb_front_left_x_z*work.w_chassis_x;
  const double s7_254 = fma(R_arb_front_left_x_x, work.w_chassis_z, s7_253);
  const double s7_255 = I_arb_front_left_yy*work.w_arb_front_left_y;
  const double s7_256 = fma(I_arb_front_left_xy, s7_252, s7_255);
  const double s7_257 = fnma(-I_arb_front_left_yz, s7_254, s7_256);
  const double s7_258 = I_arb_front_left_xy*work.w_arb_front_left_y;
  const double s7_259 = fma(I_arb_front_left_xz, s7_254, s7_258);
  const double s7_260 = fma(I_arb_front_left_xx, s7_252, s7_259);
  const double s7_261 = fma(I_arb_front_left_zz, s7_254, I_arb_front_left_xz*s7_252);
  const double s7_262 = fnma(-I_arb_front_left_yz, work.w_arb_front_left_y, s7_261);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_263 = c_upper_arm_left_y*R_upper_arm_left_z_y;
  const double s7_264 = fnma(-c_upper_arm_left_z, R_upper_arm_left_y_y, s7_263);
  const double s7_265 = -c_upper_arm_left_z*R_upper_arm_left_z_y;
  const double s7_266 = fma(c_upper_arm_left_y, R_upper_arm_left_y_y, s7_265);
  const double s7_267 = R_upper_arm_left_z_y*work.w_chassis_z;
  const double s7_268 = fma(R_upper_arm_left_y_y, work.w_chassis_y, s7_267);
  const double s7_269 = R_upper_arm_left_y_y*work.w_chassis_z;
  const double s7_270 = fnma(R_upper_arm_left_z_y, work.w_chassis_y, s7_269);
  const double s7_271 = I_upper_arm_left_zz*s7_270;
  const double s7_272 = I_upper_arm_left_yy*s7_268;
  const double s7_273 = I_upper_arm_left_xx*work.w_upper_arm_left_x;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_274 = work.R_carrier_left_y_x*work.w_wheel_front_left_y;
  const double s7_275 = fma(work.R_carrier_left_x_x, work.w_wheel_front_left_x, s7_274);
  const double s7_276 = fma(work.R_carrier_left_z_x, work.w_wheel_front_left_z, s7_275);
  const double s7_277 = work.R_carrier_left_aux2_y_y*work.w_wheel_front_left_y;
  const double s7_278 = fma(work.R_carrier_left_aux2_z_y, work.w_wheel_front_left_z, s7_277);
  const double s7_279 = fnma(work.s1_12, work.w_wheel_front_left_x, s7_278);
  const double s7_280 = I_wheel_front_left_yy*s7_279;
  const double s7_281 = I_wheel_front_left_xx*s7_276;
  const double s7_282 = work.R_carrier_left_y_z*work.w_wheel_front_left_y;
  const double s7_283 = fma(work.R_carrier_left_x_z, work.w_wheel_front_left_x, s7_282);
  const double s7_284 = fma(work.R_carrier_left_z_z, work.w_wheel_front_left_z, s7_283);
  const double s7_285 = I_wheel_front_left_zz*s7_284;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_286 = c_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_287 = fma(c_carrier_left_z, work.R_carrier_left_y_z, s7_286);
  const double s7_288 = fnma(-c_carrier_left_x, work.R_carrier_left_y_x, s7_287);
  const double s7_289 = c_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_290 = fma(c_carrier_left_z, work.R_carrier_left_z_z, s7_289);
  const double s7_291 = fnma(-c_carrier_left_x, work.R_carrier_left_z_x, s7_290);
  const double s7_292 = c_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_293 = fnma(-c_carrier_left_x, work.R_carrier_left_x_x, s7_292);
  const double s7_294 = fnma(c_carrier_left_y, work.s1_12, s7_293);
  const double s7_295 = work.R_carrier_left_y_x*work.w_carrier_left_y;
  const double s7_296 = fma(work.R_carrier_left_x_x, work.w_carrier_left_x, s7_295);
  const double s7_297 = fma(work.R_carrier_left_z_x, work.w_carrier_left_z, s7_296);
  const double s7_298 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_y;
  const double s7_299 = fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s7_298);
  const double s7_300 = fnma(work.s1_12, work.w_carrier_left_x, s7_299);
  const double s7_301 = work.R_carrier_left_y_z*work.w_carrier_left_y;
  const double s7_302 = fma(work.R_carrier_left_x_z, work.w_carrier_left_x, s7_301);
  const double s7_303 = fma(work.R_carrier_left_z_z, work.w_carrier_left_z, s7_302);
  const double s7_304 = fnma(-I_carrier_left_yz, s7_303, I_carrier_left_yy*s7_300);
  const double s7_305 = fnma(-I_carrier_left_xy, s7_297, s7_304);
  const double s7_306 = fnma(-I_carrier_left_xz, s7_303, I_carrier_left_xx*s7_297);
  const double s7_307 = fnma(-I_carrier_left_xy, s7_300, s7_306);
  const double s7_308 = fnma(-I_carrier_left_xz, s7_297, I_carrier_left_zz*s7_303);
  const double s7_309 = fnma(-I_carrier_left_yz, s7_300, s7_308);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s7_310 = c_lower_arm_left_y*R_lower_arm_left_z_y;
  const double s7_311 = fnma(-c_lower_arm_left_z, R_lower_arm_left_y_y, s7_310);
  const double s7_312 = -c_lower_arm_left_z*R_lower_arm_left_z_y;
  const double s7_313 = fma(c_lower_arm_left_y, R_lower_arm_left_y_y, s7_312);
  const double s7_314 = R_lower_arm_left_z_y*work.w_chassis_z;
  const double s7_315 = fma(R_lower_arm_left_y_y, work.w_chassis_y, s7_314);
  const double s7_316 = R_lower_arm_left_y_y*work.w_chassis_z;
  const double s7_317 = fnma(R_lower_arm_left_z_y, work.w_chassis_y, s7_316);
  const double s7_318 = I_lower_arm_left_zz*s7_317;
  const double s7_319 = I_lower_arm_left_yy*s7_315;
  const double s7_320 = I_lower_arm_left_xx*work.w_lower_arm_left_x;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_321 = fnma(-I_chassis_xz, work.w_chassis_x, I_chassis_zz*work.w_chassis_z);
  const double s7_322 = I_chassis_yy*work.w_chassis_y;
  const double s7_323 = fnma(-I_chassis_xz, work.w_chassis_z, I_chassis_xx*work.w_chassis_x);
  // operations: 181 add, 334 multiply

  // --- step 9: outputs, energies, power ---
  const double s9_1 = state.zd[Coordinate::arb_rear_right]*tau[Coordinate::arb_rear_right];
  const double s9_2 = fma(state.zd[Coordinate::wheel_rear_right], tau[Coordinate::wheel_rear_right],
      s9_1);
  const double s9_3 = fma(state.zd[Coordinate::arb_rear_left], tau[Coordinate::arb_rear_left],
      s9_2);
  const double s9_4 = fma(state.zd[Coordinate::wheel_rear_left], tau[Coordinate::wheel_rear_left],
      s9_3);
  const double s9_5 = fma(state.zd[Coordinate::rear_axle_rx], tau[Coordinate::rear_axle_rx], s9_4);
  const double s9_6 = fma(state.zd[Coordinate::rear_axle_ry], tau[Coordinate::rear_axle_ry], s9_5);
  const double s9_7 = fma(state.zd[Coordinate::rear_axle_rz], tau[Coordinate::rear_axle_rz], s9_6);
  const double s9_8 = fma(state.zd[Coordinate::rear_axle_tz], tau[Coordinate::rear_axle_tz], s9_7);
  const double s9_9 = fma(state.zd[Coordinate::rear_axle_ty], tau[Coordinate::rear_axle_ty], s9_8);
  const double s9_10 = fma(state.zd[Coordinate::rear_axle_tx], tau[Coordinate::rear_axle_tx], s9_9);
  const double s9_11 = fma(state.zd[Coordinate::bell_crank], tau[Coordinate::bell_crank], s9_10);
  const double s9_12 = fma(state.zd[Coordinate::pitman_arm], tau[Coordinate::pitman_arm], s9_11);
  const double s9_13 = fma(state.zd[Coordinate::arb_front_right], tau[Coordinate::arb_front_right],
      s9_12);
  const double s9_14 = fma(state.zd[Coordinate::upper_arm_right], tau[Coordinate::upper_arm_right],
      s9_13);
  const double s9_15 = fma(state.zd[Coordinate::wheel_front_right],
      tau[Coordinate::wheel_front_right], s9_14);
  const double s9_16 = fma(state.zd[Coordinate::carrier_right_ry],
      tau[Coordinate::carrier_right_ry], s9_15);
  const double s9_17 = fma(state.zd[Coordinate::carrier_right_rx],
      tau[Coordinate::carrier_right_rx], s9_16);
  const double s9_18 = fma(state.zd[Coordinate::carrier_right_rz],
      tau[Coordinate::carrier_right_rz], s9_17);
  const double s9_19 = fma(state.zd[Coordinate::lower_arm_right], tau[Coordinate::lower_arm_right],
      s9_18);
  const double s9_20 = fma(state.zd[Coordinate::arb_front_left], tau[Coordinate::arb_front_left],
      s9_19);
  const double s9_21 = fma(state.zd[Coordinate::upper_arm_left], tau[Coordinate::upper_arm_left],
      s9_20);
  const double s9_22 = fma(state.zd[Coordinate::wheel_front_left],
      tau[Coordinate::wheel_front_left], s9_21);
  const double s9_23 = fma(state.zd[Coordinate::carrier_left_ry], tau[Coordinate::carrier_left_ry],
      s9_22);
  const double s9_24 = fma(state.zd[Coordinate::carrier_left_rx], tau[Coordinate::carrier_left_rx],
      s9_23);
  const double s9_25 = fma(state.zd[Coordinate::carrier_left_rz], tau[Coordinate::carrier_left_rz],
      s9_24);
  const double s9_26 = fma(state.zd[Coordinate::lower_arm_left], tau[Coordinate::lower_arm_left],
      s9_25);
  const double s9_27 = fma(state.zd[Coordinate::chassis_rx], tau[Coordinate::chassis_rx], s9_26);
  const double s9_28 = fma(state.zd[Coordinate::chassis_ry], tau[Coordinate::chassis_ry], s9_27);
  const double s9_29 = fma(state.zd[Coordinate::chassis_rz], tau[Coordinate::chassis_rz], s9_28);
  const double s9_30 = fma(state.zd[Coordinate::chassis_tz], tau[Coordinate::chassis_tz], s9_29);
  const double s9_31 = fma(state.zd[Coordinate::chassis_tx], tau[Coordinate::chassis_tx], s9_30);
  result.applied_power = fma(state.zd[Coordinate::chassis_ty], tau[Coordinate::chassis_ty], s9_31);
  const double s9_32 = work.s7_75 + (work.s7_20 + (work.s7_17 + (work.s7_4 + work.s7_7)));
  const double s9_33 = work.s7_79 + (work.r_rear_axle_aux1_x + s9_32);
  const double s9_34 = work.r_rear_axle_aux1_x + (work.r_rear_axle_aux1_x + work.s7_82);
  const double s9_35 = work.r_rear_axle_aux1_x + (work.r_rear_axle_aux1_x + work.s7_85);
  const double s9_36 = fma(m_rear_axle, work.r_rear_axle_aux1_x + s7_142, 231.99999999999997);
  const double s9_37 = fma(m_bell_crank, p_bell_crank_x - s7_155, s9_36);
  const double s9_38 = 8.5 + (s7_91 + (work.r_rear_axle_aux1_x + s9_33 - work.s7_88));
  const double s9_39 = fma(m_pitman_arm, p_pitman_arm_x - s7_164, s9_37);
  const double s9_40 = 13.7 + (work.s7_45 + (work.s7_48 + (work.s7_37 - work.s7_33)));
  const double s9_41 = fma(1.1666666666666667, s9_40, fma(0.3333333333333333, s9_38, s9_39));
  const double s9_42 = 1.3 + (s7_116 + (s7_93 + (s7_176 + s7_250)));
  const double s9_43 = fma(m_arb_rear_right, s9_42, s9_41);
  const double s9_44 = fma(1.5, 7.65 - work.s7_29 - work.s7_27, s9_43);
  const double s9_45 = fma(3.0, work.s7_60 + s9_34, s9_44);
  const double s9_46 = work.r_wheel_rear_left_x + work.r_wheel_rear_right_x;
  const double s9_47 = fma(2.6666666666666665, work.s7_67 + s9_35, s9_45);
  const double s9_48 = work.r_wheel_front_left_x + work.r_wheel_front_right_x;
  const double s9_49 = fma(m_wheel_front_right, s9_48, fma(m_wheel_rear_right, s9_46, s9_47));
  const double s9_50 = fma(work.w_chassis_x, s7_89, work.v_arb_rear_left_y);
  const double s9_51 = fnma(work.w_rear_axle_z, work.s7_88, work.v_rear_axle_aux3_y);
  const double s9_52 = fma(work.w_rear_axle_y, work.s7_88, work.v_rear_axle_aux3_z);
  const double s9_53 = fnma(-p_diag_rod_left_from_z, work.w_chassis_x, work.v_arb_rear_right_z);
  const double s9_54 = fma(work.w_rear_axle_z, work.s7_87, work.v_rear_axle_aux3_x);
  const double s9_55 = fma(p_arb_link_rear_left_from_y, work.w_chassis_z, work.v_arb_rear_right_x);
  const double s9_56 = fma(-p_diag_rod_left_from_z, work.w_chassis_x, work.v_chassis_y);
  const double s9_57 = fma(work.w_rear_axle_z, work.s7_85, work.v_rear_axle_aux3_y);
  const double s9_58 = fma(-p_diag_rod_left_from_x, work.w_chassis_y, work.v_chassis_z);
  const double s9_59 = fma(work.w_rear_axle_x, work.s7_86, work.v_rear_axle_aux3_z);
  const double s9_60 = fma(work.w_rear_axle_y, work.s7_84, work.v_rear_axle_aux3_x);
  const double s9_61 = fma(-p_long_rod_left_from_z, work.w_chassis_x, work.v_chassis_y);
  const double s9_62 = fma(work.w_rear_axle_x, work.s7_81, work.v_rear_axle_aux3_y);
  const double s9_63 = fma(-p_long_rod_left_from_x, work.w_chassis_y, work.v_chassis_z);
  const double s9_64 = fma(work.w_rear_axle_x, work.s7_83, work.v_rear_axle_aux3_z);
  const double s9_65 = fma(p_long_rod_left_from_y, work.w_chassis_z, work.v_chassis_x);
  const double s9_66 = fnma(work.w_rear_axle_y, work.s7_81, work.v_rear_axle_aux3_x);
  const double s9_67 = fma(work.w_rear_axle_z, work.s7_79, work.v_rear_axle_aux3_y);
  const double s9_68 = fma(work.w_chassis_x, work.s7_70, work.v_arb_rear_left_y);
  const double s9_69 = fma(work.w_rear_axle_x, work.s7_80, work.v_rear_axle_aux3_z);
  const double s9_70 = fma(-p_diag_rod_left_from_z, work.w_chassis_x, work.v_arb_rear_left_z);
  const double s9_71 = fma(work.w_rear_axle_y, work.s7_78, work.v_rear_axle_aux3_x);
  const double s9_72 = fnma(p_arb_link_rear_left_from_y, work.w_chassis_z, work.v_arb_rear_left_x);
  const double s9_73 = fma(work.w_rear_axle_z, work.s7_67, work.v_rear_axle_aux3_y);
  const double s9_74 = fma(work.w_rear_axle_x, work.s7_69, work.v_rear_axle_aux3_z);
  const double s9_75 = fma(work.w_rear_axle_y, work.s7_65, work.v_rear_axle_aux3_x);
  const double s9_76 = fma(work.w_rear_axle_z, work.s7_60, work.v_rear_axle_aux3_y);
  const double s9_77 = fma(work.w_rear_axle_x, work.s7_63, work.v_rear_axle_aux3_z);
  const double s9_78 = fma(work.w_rear_axle_y, work.s7_57, work.v_rear_axle_aux3_x);
  const double s9_79 = fnma(-p_long_rod_left_from_z, work.w_chassis_y, work.v_chassis_x);
  const double s9_80 = fma(work.w_carrier_right_z, work.s7_48, work.v_carrier_right_aux1_y);
  const double s9_81 = fma(work.w_carrier_right_y, work.s7_54, work.v_carrier_right_aux1_x);
  const double s9_82 = fma(work.w_carrier_right_x, work.s7_51, work.v_carrier_right_aux1_z);
  const double s9_83 = fnma(work.w_chassis_x, work.s7_44, work.v_bell_crank_z);
  const double s9_84 = fma(work.w_carrier_left_z, work.s7_37, work.v_carrier_left_aux1_y);
  const double s9_85 = fma(work.w_carrier_left_y, work.s7_43, work.v_carrier_left_aux1_x);
  const double s9_86 = fma(work.w_carrier_left_x, work.s7_40, work.v_carrier_left_aux1_z);
  const double s9_87 = fma(work.w_chassis_y, work.s7_33, work.v_bell_crank_z);
  const double s9_88 = fma(work.w_chassis_x, work.s7_28, work.v_pitman_arm_y);
  const double s9_89 = fma(work.w_chassis_y, work.s7_29, work.v_bell_crank_z);
  const double s9_90 = fnma(work.w_bell_crank_z, work.s7_29, work.v_bell_crank_y);
  const double s9_91 = fnma(work.w_pitman_arm_y, work.s7_28, work.v_pitman_arm_x);
  const double s9_92 = fnma(work.w_bell_crank_z, work.s7_30, work.v_bell_crank_x);
  const double s9_93 = fma(s9_91, s9_92, s9_90*fnma(work.w_chassis_z, work.s7_27, s9_88));
  const double s9_94 = fma(work.w_pitman_arm_y, work.s7_27, work.v_pitman_arm_z);
  const double s9_95 = fma(work.w_carrier_left_z, work.s7_7, work.v_carrier_left_aux1_y);
  const double s9_96 = fma(work.w_chassis_z, work.s7_4, work.v_arb_front_left_y);
  const double s9_97 = fma(work.w_carrier_left_x, work.s7_10, work.v_carrier_left_aux1_z);
  const double s9_98 = fma(p_arb_link_front_left_from_y, work.w_chassis_x, work.v_arb_front_left_z);
  const double s9_99 = fma(work.w_carrier_left_y, work.s7_13, work.v_carrier_left_aux1_x);
  const double s9_100 = fnma(p_arb_link_front_left_from_y, work.w_chassis_z,
      work.v_arb_front_left_x);
  const double s9_101 = fma(work.w_chassis_z, work.s7_17, work.v_arb_front_left_y);
  const double s9_102 = fma(work.w_carrier_right_z, work.s7_20, work.v_carrier_right_aux1_y);
  const double s9_103 = fma(work.w_carrier_right_x, work.s7_23, work.v_carrier_right_aux1_z);
  const double s9_104 = fnma(p_arb_link_front_left_from_y, work.w_chassis_x,
      work.v_arb_front_right_z);
  const double s9_105 = fma(work.w_carrier_right_y, work.s7_26, work.v_carrier_right_aux1_x);
  const double s9_106 = fma(p_arb_link_front_left_from_y, work.w_chassis_z,
      work.v_arb_front_right_x);
  const double s9_107 = fma(work.w_chassis_x, s7_92, work.v_arb_rear_left_y);
  const double s9_108 = fma(work.w_chassis_z, s7_93, s9_107);
  const double s9_109 = fma(c_arb_rear_left_y, work.w_chassis_z, work.v_arb_rear_right_x);
  const double s9_110 = fnma(work.w_arb_rear_right_y, s7_92, s9_109);
  const double s9_111 = fnma(c_arb_rear_left_y, work.w_chassis_x, work.v_arb_rear_right_z);
  const double s9_112 = fnma(work.w_arb_rear_right_y, s7_93, s9_111);
  const double s9_113 = fma(work.w_chassis_x, s7_115, work.v_arb_rear_left_y);
  const double s9_114 = fma(work.w_chassis_z, s7_116, s9_113);
  const double s9_115 = fma(c_arb_rear_left_y, work.w_chassis_x, work.v_arb_rear_left_z);
  const double s9_116 = fnma(work.w_arb_rear_left_y, s7_116, s9_115);
  const double s9_117 = fnma(c_arb_rear_left_y, work.w_chassis_z, work.v_arb_rear_left_x);
  const double s9_118 = fnma(work.w_arb_rear_left_y, s7_115, s9_117);
  const double s9_119 = fma(work.w_rear_axle_z, s7_142, work.v_rear_axle_aux3_y);
  const double s9_120 = fnma(work.w_rear_axle_x, s7_140, s9_119);
  const double s9_121 = fma(work.w_rear_axle_x, s7_139, work.v_rear_axle_aux3_z);
  const double s9_122 = fnma(work.w_rear_axle_y, s7_142, s9_121);
  const double s9_123 = fma(work.w_rear_axle_y, s7_140, work.v_rear_axle_aux3_x);
  const double s9_124 = fnma(work.w_rear_axle_z, s7_139, s9_123);
  const double s9_125 = fnma(work.w_bell_crank_z, s7_155, work.v_bell_crank_y);
  const double s9_126 = fnma(work.w_bell_crank_z, s7_156, work.v_bell_crank_x);
  const double s9_127 = fma(work.w_chassis_y, s7_155, work.v_bell_crank_z);
  const double s9_128 = fma(work.w_chassis_x, s7_156, s9_127);
  const double s9_129 = fma(work.w_pitman_arm_y, s7_164, work.v_pitman_arm_z);
  const double s9_130 = fnma(work.w_pitman_arm_y, s7_165, work.v_pitman_arm_x);
  const double s9_131 = fma(work.w_chassis_x, s7_165, work.v_pitman_arm_y);
  const double s9_132 = fnma(work.w_chassis_z, s7_164, s9_131);
  const double s9_133 = fma(work.w_chassis_z, s7_176, work.v_arb_front_left_y);
  const double s9_134 = fnma(work.w_chassis_x, s7_174, s9_133);
  const double s9_135 = fma(c_arb_front_left_y, work.w_chassis_z, work.v_arb_front_right_x);
  const double s9_136 = fma(work.w_arb_front_right_y, s7_174, s9_135);
  const double s9_137 = fnma(c_arb_front_left_y, work.w_chassis_x, work.v_arb_front_right_z);
  const double s9_138 = fnma(work.w_arb_front_right_y, s7_176, s9_137);
  const double s9_139 = fma(work.w_upper_arm_right_x, s7_192, work.v_upper_arm_left_y);
  const double s9_140 = fma(work.w_upper_arm_right_x, s7_190, work.v_upper_arm_right_z);
  const double s9_141 = fnma(work.w_chassis_y, s7_192, work.v_upper_arm_right_x);
  const double s9_142 = fnma(work.w_chassis_z, s7_190, s9_141);
  const double s9_143 = fma(work.w_carrier_right_z, s7_220, work.v_carrier_right_aux1_y);
  const double s9_144 = fnma(work.w_carrier_right_x, s7_217, s9_143);
  const double s9_145 = fma(work.w_carrier_right_x, s7_214, work.v_carrier_right_aux1_z);
  const double s9_146 = fnma(work.w_carrier_right_y, s7_220, s9_145);
  const double s9_147 = fma(work.w_carrier_right_y, s7_217, work.v_carrier_right_aux1_x);
  const double s9_148 = fnma(work.w_carrier_right_z, s7_214, s9_147);
  const double s9_149 = fma(work.w_lower_arm_right_x, s7_239, work.v_lower_arm_left_y);
  const double s9_150 = fma(work.w_lower_arm_right_x, s7_237, work.v_lower_arm_right_z);
  const double s9_151 = fnma(work.w_chassis_y, s7_239, work.v_lower_arm_right_x);
  const double s9_152 = fnma(work.w_chassis_z, s7_237, s9_151);
  const double s9_153 = fma(work.w_chassis_z, s7_250, work.v_arb_front_left_y);
  const double s9_154 = fnma(work.w_chassis_x, s7_248, s9_153);
  const double s9_155 = fma(c_arb_front_left_y, work.w_chassis_x, work.v_arb_front_left_z);
  const double s9_156 = fnma(work.w_arb_front_left_y, s7_250, s9_155);
  const double s9_157 = fnma(c_arb_front_left_y, work.w_chassis_z, work.v_arb_front_left_x);
  const double s9_158 = fma(work.w_arb_front_left_y, s7_248, s9_157);
  const double s9_159 = fnma(work.w_upper_arm_left_x, s7_264, work.v_upper_arm_left_y);
  const double s9_160 = fma(work.w_upper_arm_left_x, s7_266, work.v_upper_arm_left_z);
  const double s9_161 = fma(work.w_chassis_y, s7_264, work.v_upper_arm_left_x);
  const double s9_162 = fnma(work.w_chassis_z, s7_266, s9_161);
  const double s9_163 = fma(work.w_carrier_left_z, s7_294, work.v_carrier_left_aux1_y);
  const double s9_164 = fnma(work.w_carrier_left_x, s7_291, s9_163);
  const double s9_165 = fma(work.w_carrier_left_x, s7_288, work.v_carrier_left_aux1_z);
  const double s9_166 = fnma(work.w_carrier_left_y, s7_294, s9_165);
  const double s9_167 = fma(work.w_carrier_left_y, s7_291, work.v_carrier_left_aux1_x);
  const double s9_168 = fnma(work.w_carrier_left_z, s7_288, s9_167);
  const double s9_169 = fma(-c_chassis_x, work.w_chassis_y, work.v_chassis_z);
  const double s9_170 = fma(c_chassis_z, work.w_chassis_y, work.v_chassis_x);
  const double s9_171 = fnma(-c_chassis_x, work.w_chassis_z, work.v_chassis_y);
  const double s9_172 = fnma(c_chassis_z, work.w_chassis_x, s9_171);
  const double s9_173 = fnma(work.w_lower_arm_left_x, s7_311, work.v_lower_arm_left_y);
  const double s9_174 = fma(work.w_lower_arm_left_x, s7_313, work.v_lower_arm_left_z);
  const double s9_175 = fma(work.w_chassis_y, s7_311, work.v_lower_arm_left_x);
  const double s9_176 = fnma(work.w_chassis_z, s7_313, s9_175);
  const double s9_177 = fma(s9_158, s9_158, fma(s9_156, s9_156, s9_154*s9_154));
  const double s9_178 = fma(s9_138, s9_138, fma(s9_136, s9_136, fma(s9_134, s9_134, s9_177)));
  const double s9_179 = fma(s9_112, s9_112, fma(s9_110, s9_110, fma(s9_108, s9_108, s9_178)));
  const double s9_180 = fnma(work.w_carrier_right_x, work.s7_26, s9_102);
  const double s9_181 = fnma(work.w_arb_front_right_y, work.s7_17, s9_104);
  const double s9_182 = fnma(work.w_chassis_x, work.s7_15, s9_101)*s9_180;
  const double s9_183 = fma(fnma(work.w_carrier_right_y, work.s7_20, s9_103), s9_181, s9_182);
  const double s9_184 = fma(work.w_arb_front_right_y, work.s7_15, s9_106);
  const double s9_185 = fma(fnma(work.w_carrier_right_z, work.s7_23, s9_105), s9_184, s9_183);
  const double s9_186 = fnma(work.w_carrier_left_x, work.s7_13, s9_95);
  const double s9_187 = fma(s9_186, fnma(work.w_chassis_x, work.s7_2, s9_96), s9_185);
  const double s9_188 = fnma(work.w_arb_front_left_y, work.s7_4, s9_98);
  const double s9_189 = fma(fnma(work.w_carrier_left_y, work.s7_7, s9_97), s9_188, s9_187);
  const double s9_190 = fma(work.w_arb_front_left_y, work.s7_2, s9_100);
  const double s9_191 = fma(fnma(work.w_carrier_left_z, work.s7_10, s9_99), s9_190, s9_189);
  const double s9_192 = fnma(work.w_rear_axle_x, s7_90, s9_51);
  const double s9_193 = fma(fma(work.w_chassis_z, s7_91, s9_50), s9_192, s9_191);
  const double s9_194 = fnma(work.w_rear_axle_x, work.s7_87, s9_52);
  const double s9_195 = fma(s9_194, fnma(work.w_arb_rear_right_y, s7_91, s9_53), s9_193);
  const double s9_196 = fnma(work.w_arb_rear_right_y, s7_89, s9_55);
  const double s9_197 = fma(fma(work.w_rear_axle_y, s7_90, s9_54), s9_196, s9_195);
  const double s9_198 = fnma(work.w_rear_axle_x, work.s7_78, s9_67);
  const double s9_199 = fma(s9_198, fma(work.w_chassis_z, work.s7_75, s9_68), s9_197);
  const double s9_200 = fnma(work.w_arb_rear_left_y, work.s7_75, s9_70);
  const double s9_201 = fma(fnma(work.w_rear_axle_y, work.s7_79, s9_69), s9_200, s9_199);
  const double s9_202 = fnma(work.w_arb_rear_left_y, work.s7_70, s9_72);
  const double s9_203 = work.v_wheel_rear_right_y*work.v_wheel_rear_right_y;
  const double s9_204 = fma(work.v_wheel_rear_right_z, work.v_wheel_rear_right_z, s9_203);
  const double s9_205 = fma(work.v_wheel_rear_right_x, work.v_wheel_rear_right_x, s9_204);
  const double s9_206 = fma(work.v_wheel_rear_left_y, work.v_wheel_rear_left_y, s9_205);
  const double s9_207 = fma(work.v_wheel_rear_left_z, work.v_wheel_rear_left_z, s9_206);
  const double s9_208 = fma(s9_142, s9_142, fma(s9_140, s9_140, s9_139*s9_139));
  const double s9_209 = work.v_wheel_front_right_y*work.v_wheel_front_right_y;
  const double s9_210 = fma(work.v_wheel_front_right_z, work.v_wheel_front_right_z, s9_209);
  const double s9_211 = fma(work.v_wheel_front_right_x, work.v_wheel_front_right_x, s9_210);
  const double s9_212 = fma(work.v_wheel_front_left_y, work.v_wheel_front_left_y, s9_211);
  const double s9_213 = fma(work.v_wheel_front_left_z, work.v_wheel_front_left_z, s9_212);
  const double s9_214 = fma(s9_148, s9_148, fma(s9_146, s9_146, s9_144*s9_144));
  const double s9_215 = fma(s9_152, s9_152, fma(s9_150, s9_150, s9_149*s9_149));
  const double s9_216 = fnma(work.w_rear_axle_x, work.s7_84, s9_57);
  const double s9_217 = fnma(p_lower_arm_left_y, work.w_chassis_x, s9_58);
  const double s9_218 = fnma(-p_diag_rod_left_from_z, work.w_chassis_y, work.s4_16);
  const double s9_219 = s9_217*fnma(work.w_rear_axle_y, work.s7_85, s9_59);
  const double s9_220 = fma(s9_218, fnma(work.w_rear_axle_z, work.s7_86, s9_60), s9_219);
  const double s9_221 = fma(-p_diag_rod_left_from_x, work.w_chassis_y, work.s4_6);
  const double s9_222 = fma(s9_221, fnma(work.w_rear_axle_y, work.s7_67, s9_74), s9_220);
  const double s9_223 = fnma(-p_diag_rod_left_from_z, work.w_chassis_y, work.s4_4);
  const double s9_224 = fma(fnma(work.w_rear_axle_z, work.s7_69, s9_75), s9_223, s9_222);
  const double s9_225 = fnma(-p_diag_rod_left_from_x, work.w_chassis_z, s9_56);
  const double s9_226 = s9_216 + fnma(work.w_rear_axle_x, work.s7_65, s9_73);
  const double s9_227 = fnma(work.w_rear_axle_x, work.s7_57, s9_76);
  const double s9_228 = fnma(-p_long_rod_left_from_z, work.w_chassis_x, s9_63);
  const double s9_229 = fnma(-p_long_rod_left_from_z, work.w_chassis_y, s9_65);
  const double s9_230 = s9_228*fnma(work.w_rear_axle_y, work.s7_82, s9_64);
  const double s9_231 = fma(s9_229, fnma(work.w_rear_axle_z, work.s7_83, s9_66), s9_230);
  const double s9_232 = fma(-p_long_rod_left_from_z, work.w_chassis_x, s9_63);
  const double s9_233 = fma(s9_232, fnma(work.w_rear_axle_y, work.s7_60, s9_77), s9_231);
  const double s9_234 = fnma(p_long_rod_left_from_y, work.w_chassis_z, s9_79);
  const double s9_235 = fma(fnma(work.w_rear_axle_z, work.s7_63, s9_78), s9_234, s9_233);
  const double s9_236 = fnma(-p_long_rod_left_from_x, work.w_chassis_z, s9_61);
  const double s9_237 = fma(work.w_bell_crank_z, work.s7_45, work.v_bell_crank_y);
  const double s9_238 = fma(work.w_bell_crank_z, work.s7_44, work.v_bell_crank_x);
  const double s9_239 = s9_237*fnma(work.w_carrier_right_x, work.s7_54, s9_80);
  const double s9_240 = fma(s9_238, fnma(work.w_carrier_right_z, work.s7_51, s9_81), s9_239);
  const double s9_241 = fnma(work.w_carrier_right_y, work.s7_48, s9_82);
  const double s9_242 = fma(s9_241, fnma(work.w_chassis_y, work.s7_45, s9_83), s9_240);
  const double s9_243 = fnma(work.w_bell_crank_z, work.s7_33, work.v_bell_crank_y);
  const double s9_244 = fma(s9_243, fnma(work.w_carrier_left_x, work.s7_43, s9_84), s9_242);
  const double s9_245 = fnma(work.w_bell_crank_z, work.s7_34, work.v_bell_crank_x);
  const double s9_246 = fma(s9_245, fnma(work.w_carrier_left_z, work.s7_40, s9_85), s9_244);
  const double s9_247 = fnma(work.w_carrier_left_y, work.s7_37, s9_86);
  const double s9_248 = 3.0*fma(s9_94, fma(work.w_chassis_x, work.s7_30, s9_89), s9_93);
  const double s9_249 = fma(s7_101, s7_102, fma(work.w_arb_rear_right_y, s7_97, s9_248));
  const double s9_250 = fma(s7_108, s7_109, fma(s7_113, s7_114, fma(s7_95, s7_99, s9_249)));
  const double s9_251 = fma(work.w_arb_rear_left_y, s7_120, fma(s7_105, s7_110, s9_250));
  const double s9_252 = fma(s7_136, s7_137, fma(s7_118, s7_122, fma(s7_124, s7_125, s9_251)));
  const double s9_253 = fma(s7_153, s7_154, fma(s7_128, s7_133, fma(s7_131, s7_132, s9_252)));
  const double s9_254 = fma(s9_124, s9_124, fma(s9_122, s9_122, s9_120*s9_120));
  const double s9_255 = fma(s7_145, s7_150, fma(s7_148, s7_149, s9_253));
  const double s9_256 = fma(s7_158, s7_162, fma(m_rear_axle, s9_254, s9_255));
  const double s9_257 = fma(s7_161, s7_163, fma(work.w_bell_crank_z, s7_159, s9_256));
  const double s9_258 = fma(s9_128, s9_128, fma(s9_126, s9_126, s9_125*s9_125));
  const double s9_259 = fma(work.w_pitman_arm_y, s7_168, fma(m_bell_crank, s9_258, s9_257));
  const double s9_260 = fma(s9_132, s9_132, fma(s9_130, s9_130, s9_129*s9_129));
  const double s9_261 = fma(s7_167, s7_169, fma(s7_171, s7_172, s9_259));
  const double s9_262 = fma(work.w_arb_front_right_y, s7_183, fma(m_pitman_arm, s9_260, s9_261));
  const double s9_263 = fma(s7_194, s7_198, fma(s7_178, s7_185, fma(s7_180, s7_188, s9_262)));
  const double s9_264 = fma(s7_196, s7_197, fma(work.w_upper_arm_right_x, s7_199, s9_263));
  const double s9_265 = fma(s7_210, s7_211, fma(s7_202, s7_207, fma(s7_205, s7_206, s9_264)));
  const double s9_266 = fma(s7_229, s7_235, fma(s7_223, s7_233, fma(s7_226, s7_231, s9_265)));
  const double s9_267 = fma(work.w_lower_arm_right_x, s7_246, fma(s7_241, s7_245, s9_266));
  const double s9_268 = fma(work.w_arb_front_left_y, s7_257, fma(s7_243, s7_244, s9_267));
  const double s9_269 = fma(s7_268, s7_272, fma(s7_252, s7_260, fma(s7_254, s7_262, s9_268)));
  const double s9_270 = fma(s7_270, s7_271, fma(work.w_upper_arm_left_x, s7_273, s9_269));
  const double s9_271 = fma(s7_284, s7_285, fma(s7_276, s7_281, fma(s7_279, s7_280, s9_270)));
  const double s9_272 = fma(s7_303, s7_309, fma(s7_297, s7_307, fma(s7_300, s7_305, s9_271)));
  const double s9_273 = fma(work.w_lower_arm_left_x, s7_320, fma(s7_315, s7_319, s9_272));
  const double s9_274 = fma(work.w_chassis_y, s7_322, fma(s7_317, s7_318, s9_273));
  const double s9_275 = fma(work.w_chassis_z, s7_321, fma(work.w_chassis_x, s7_323, s9_274));
  const double s9_276 = fma(s9_172, s9_172, fma(s9_170, s9_170, s9_169*s9_169));
  const double s9_277 = fma(s9_118, s9_118, fma(s9_116, s9_116, fma(s9_114, s9_114, s9_179)));
  const double s9_278 = fma(fnma(work.w_rear_axle_z, work.s7_80, s9_71), s9_202, s9_201);
  const double s9_279 = fma(m_arb_rear_right, s9_277, fma(m_chassis, s9_276, s9_275));
  const double s9_280 = fma(work.v_wheel_rear_left_x, work.v_wheel_rear_left_x, s9_207);
  const double s9_281 = fma(m_wheel_rear_right, s9_280, fma(0.6666666666666666, s9_278, s9_279));
  const double s9_282 = fma(s9_162, s9_162, fma(s9_160, s9_160, fma(s9_159, s9_159, s9_208)));
  const double s9_283 = fma(work.v_wheel_front_left_x, work.v_wheel_front_left_x, s9_213);
  const double s9_284 = fma(m_wheel_front_right, s9_283, fma(m_upper_arm_right, s9_282, s9_281));
  const double s9_285 = fma(s9_168, s9_168, fma(s9_166, s9_166, fma(s9_164, s9_164, s9_214)));
  const double s9_286 = fma(s9_176, s9_176, fma(s9_174, s9_174, fma(s9_173, s9_173, s9_215)));
  const double s9_287 = fma(m_lower_arm_right, s9_286, fma(m_carrier_right, s9_285, s9_284));
  const double s9_288 = fma(s9_236, fma(work.w_rear_axle_z, work.s7_82, s9_62) + s9_227, s9_235);
  const double s9_289 = fma(5.333333333333333, fma(s9_225, s9_226, s9_224), s9_287);
  const double s9_290 = fma(s9_247, fma(work.w_chassis_x, work.s7_34, s9_87), s9_246);
  result.kinetic_energy = 0.5*fma(2.3333333333333335, s9_290, fma(6.0, s9_288, s9_289));
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_291 = work.r_carrier_right_aux1_y + (work.r_carrier_left_aux1_y + work.s7_10);
  const double s9_292 = z_rear_axle_ty + (z_rear_axle_ty + (work.s7_23 + s9_291) - work.s7_87);
  const double s9_293 = work.s7_51 + (work.r_carrier_right_aux1_y + work.s7_34);
  const double s9_294 = work.r_carrier_left_aux1_y + (work.r_carrier_right_aux1_y + s7_214);
  const double s9_295 = fma(m_rear_axle, z_rear_axle_ty + s7_139, fma(1.5, work.s7_30, 5.25));
  const double s9_296 = fma(m_bell_crank, s7_156, s9_295);
  const double s9_297 = work.s7_40 + (work.r_carrier_left_aux1_y + s9_293) - work.s7_44;
  const double s9_298 = fma(0.3333333333333333, work.s7_80 + s9_292, s9_296);
  const double s9_299 = work.s7_63 + (z_rear_axle_ty + (z_rear_axle_ty + work.s7_83));
  const double s9_300 = work.s7_69 + (z_rear_axle_ty + (z_rear_axle_ty + work.s7_86));
  const double s9_301 = fma(3.0, s9_299, fma(1.1666666666666667, s9_297, s9_298));
  const double s9_302 = work.r_wheel_rear_left_y + work.r_wheel_rear_right_y;
  const double s9_303 = fma(m_wheel_rear_right, s9_302, fma(2.6666666666666665, s9_300, s9_301));
  const double s9_304 = work.r_wheel_front_left_y + work.r_wheel_front_right_y;
  const double s9_305 = fma(m_upper_arm_right, s7_190 + s7_266, s9_303);
  const double s9_306 = fma(m_wheel_front_right, s9_304, s9_305);
  const double s9_307 = fma(m_carrier_right, s7_288 + s9_294, s9_306);
  const double s9_308 = work.s7_15 + (work.s7_13 + (work.r_carrier_left_aux1_z + work.s7_2));
  const double s9_309 = s7_90 + (work.r_rear_axle_aux3_z + (work.s7_26 + s9_308 - work.s1_28));
  const double s9_310 = work.s7_78 + (work.r_rear_axle_aux3_z + s9_309) - work.s7_70 - s7_89;
  const double s9_311 = work.r_rear_axle_aux3_z + (work.r_rear_axle_aux3_z - work.s7_81);
  const double s9_312 = work.r_rear_axle_aux3_z + (work.r_rear_axle_aux3_z + work.s7_84);
  const double s9_313 = fma(m_rear_axle, work.r_rear_axle_aux3_z + s7_140, 3350.4);
  const double s9_314 = fnma(m_pitman_arm, -p_pitman_arm_z + s7_165, s9_313);
  const double s9_315 = fnma(1.5, -p_pitman_arm_z + work.s7_28, s9_314);
  const double s9_316 = fma(0.3333333333333333, s9_310 - 1.9, s9_315);
  const double s9_317 = work.s7_43 + (work.r_carrier_left_aux1_z + (work.s7_54 - work.s1_28));
  const double s9_318 = fma(m_arb_rear_right, s7_174 + s7_248 - s7_115 - s7_92 - 1.9, s9_316);
  const double s9_319 = fma(3.0, work.s7_57 + s9_311, fma(1.1666666666666667, s9_317, s9_318));
  const double s9_320 = work.r_wheel_rear_left_z + work.r_wheel_rear_right_z;
  const double s9_321 = fma(2.6666666666666665, work.s7_65 + s9_312, s9_319);
  const double s9_322 = fma(m_wheel_rear_right, s9_320, s9_321);
  const double s9_323 = work.r_wheel_front_left_z + work.r_wheel_front_right_z;
  const double s9_324 = fma(m_upper_arm_right, s7_264 - s7_192 - 0.56, s9_322);
  const double s9_325 = s7_291 + (work.r_carrier_left_aux1_z + (s7_217 - work.s1_28));
  const double s9_326 = fma(m_carrier_right, s9_325, fma(m_wheel_front_right, s9_323, s9_324));
  const double s9_327 = fma(m_lower_arm_right, s7_237 + s7_313, s9_307);
  const double s9_328 = 15305.999999999998*work.r_chassis_aux3_z;
  const double s9_329 = fma(m_lower_arm_right, s7_311 - s7_239 - 1.24, s9_326);
  const double s9_330 = fma(work.R_chassis_z_z, s9_329, fma(work.R_chassis_z_y, s9_327, s9_328));
  const double s9_331 = fma(m_carrier_right, 7.2 + (s7_220 + s7_294), s9_49);
  result.potential_energy = -g_z*fnma(work.sines[1], s9_331, s9_330);
  // operations: 493 add, 415 multiply
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

/// What the runtime's algorithms need to know of this model; see mbgen/solver.hpp.
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
