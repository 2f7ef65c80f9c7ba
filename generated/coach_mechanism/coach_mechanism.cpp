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
      R_carrier_left_z_z, R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x, s1_35, s1_37,
      R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, s1_43, s1_48, R_carrier_right_x_x,
      R_carrier_right_x_z, R_carrier_right_y_x, R_carrier_right_y_z, R_carrier_right_z_x,
      R_carrier_right_z_z, R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, s1_58, R_rear_axle_x_y,
      R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z,
      R_chassis_aux5_x_x, R_chassis_aux5_y_x, s7_4, s7_7, s7_9, s5_2, s5_3, s5_5, s5_6, s5_7, s5_9,
      s5_10, s5_12, s5_14, s5_16, s5_18, s5_19, s5_21, s5_23, s5_24, s5_26, s5_28, s5_30, s5_32,
      s5_34, s5_35, s5_37, s5_39, s5_40, s5_42, s5_44, s5_46, s5_48, s5_49, s5_50, s5_52, s5_53,
      s4_1, s4_2, w_chassis_y, s4_3, s4_4, w_chassis_z, s4_5, s4_6, s4_7, s4_8, s4_9, s4_10, s4_11,
      s4_12, s4_13, s4_14, s4_15, s4_16, s4_17, s4_18, s4_19, s4_20, s4_21, s4_22, s4_23, s4_24,
      s4_25, s4_26, s4_27, s4_28, s4_29, s4_30, s4_32, s4_33, w_chassis_x, s4_34, s4_35, s4_37,
      s4_38, s4_39, s4_40, s4_41, s4_42, s4_43, s4_44, s4_45, s4_46, s4_47, s4_48, s4_49, s4_50,
      w_carrier_left_x, w_carrier_left_y, s4_52, w_carrier_left_z, s4_54, s4_57, s4_59,
      w_carrier_right_x, w_carrier_right_y, s4_61, w_carrier_right_z, s4_63, s4_66, s4_68,
      w_rear_axle_x, w_rear_axle_y, w_rear_axle_z, s8_3, s8_4, s8_5, r_rear_axle_aux3_z, s2_7, s2_8,
      s2_9, r_rear_axle_aux1_x, s2_11, s2_12, s2_13, s2_17, s2_18, s2_19, s2_21, s2_22, s2_24,
      s2_26, s2_28, s2_29, s2_33, s2_34, s2_35, s2_42, s2_43, s2_45, s2_46, s2_48, s2_50, s2_53,
      s2_54, s2_55, s2_57, s2_58, s2_60, s2_61, s2_63, s2_66, s2_67, s2_68, s2_69, s2_70,
      pivot_rear_axle_tx, s2_71, s2_73, s2_75, s2_78, s2_79, s2_80, s2_81, s2_84, s2_85, s2_87,
      s2_88, s2_91, s2_92, s2_94, s2_95, s2_97, s2_159, s3_2, Rz_rear_axle_rz_0, Rz_rear_axle_ry_0,
      Rz_rear_axle_rx_0, s3_8, Rz_rear_axle_tx_0, Rz_rear_axle_tz_1, s3_10, Rz_rear_axle_ry_1,
      Rz_rear_axle_rx_1, s3_14, Rz_rear_axle_tx_1, s6_1, s6_2, s6_3, s6_4, s6_5, s6_6, s6_9, s6_12,
      s6_13, s6_14, s6_15, s6_16, s6_17, s6_18, s6_19, s6_20, s6_21, s6_56, s6_59, s6_60, s6_61,
      s6_63, zdd_star_rear_axle_tz, zdd_star_rear_axle_rz, zdd_star_rear_axle_ry,
      zdd_star_rear_axle_rx, s6_77, zdd_star_rear_axle_tx, s7_11, s7_13, s7_14, s8_13, s8_18, s8_20,
      s8_22, s8_23, s8_25, s8_27, s8_28, s8_29, s8_32, s8_33, s8_40, s8_41, s8_44, s8_48, s8_49,
      s8_52, s8_54, s8_56, s8_57, s8_67, s8_69, s8_83, s8_85, s8_86, s8_87, s8_88, s8_101, s8_421,
      s8_427, s8_438, s8_448, s8_459, s8_463, s8_469, s8_478, s8_487, s8_497, s8_544, s8_547,
      s8_548, s8_550, s8_551, s8_552, s8_553, s8_554, s8_563, s8_573, s8_584, s8_585, s8_588,
      s8_589, s8_590, s8_591, s8_592, s8_601, s8_604, s8_607, s8_608, s8_609, s8_610, s8_611,
      s8_612, s8_616, s8_619, s8_620, s8_621, s8_622, s8_626, s8_629, s8_630, s8_631, s8_646,
      s8_649, s8_665, s8_668, s8_669, s8_683, s8_686, s8_688, s8_689, s8_692, s8_694, s8_695,
      s2_187, s2_189, s2_192, s2_193, s2_196, r_carrier_left_aux1_z, s2_199, s2_203,
      r_carrier_left_aux1_y, s2_206, s2_212, s2_214, s2_217, s2_218, s2_221, s2_223, s2_224, s2_228,
      r_carrier_right_aux1_y, s2_231, s2_236, s2_237, s2_238, s2_239, s2_240, s2_241, s2_242,
      s2_245, s2_246, s2_248, s2_251, s2_252, s2_255, s2_259, s2_260, s2_266, s2_268, s2_269,
      s2_271, s2_273, s2_275, s2_277, s2_280, s2_323, s3_19, s3_20, Rz_upper_arm_left_2,
      Rz_lower_arm_left_2, s3_21, s3_22, s3_23, s3_24, s3_25, Rz_arb_front_left_0, s3_31,
      Rz_arb_front_left_2, s3_34, s3_36, s3_37, s3_38, Rz_carrier_right_rz_2, Rz_carrier_right_ry_1,
      Rz_carrier_right_rx_1, s3_42, Rz_carrier_right_ry_2, s3_44, Rz_carrier_right_rx_2, s3_48,
      Rz_arb_front_right_1, s3_52, Rz_arb_front_right_2, s3_55, s3_58, s3_60, s6_84, s6_85, s6_86,
      s6_87, s6_88, s6_90, s6_91, s6_94, s6_95, s6_98, s6_99, s6_100, s6_101, s6_102, s6_104,
      s6_105, s6_108, s6_109, s6_110, s6_111, s6_112, s6_115, s6_117, s6_119, s6_125, s6_127,
      s6_128, s6_129, s6_130, s6_133, s6_137, s6_143, s6_145, s6_148, s6_149, s6_150, s6_151,
      s6_152, s6_165, zdd_star_lower_arm_left, zdd_star_carrier_left_ry, zdd_star_carrier_left_rx,
      s6_168, zdd_star_arb_front_left, s6_182, zdd_star_carrier_right_rz, zdd_star_carrier_right_ry,
      zdd_star_carrier_right_rx, s6_184, zdd_star_arb_front_right, s6_192, s7_54, s7_56, s7_61,
      s7_62, s7_63, s7_64, s7_65, s7_74, s7_77, s7_80, s8_696, s8_697, s8_699, s8_701, s8_703,
      s7_93, s7_98, s7_101, s7_104, s7_107, s8_705, s8_706, s8_707, s8_708, s8_709, s8_710, s8_711,
      s8_712, s7_111, s7_113, s8_713, s8_714, s7_118, s7_119, s7_120, s7_124, s7_126, s7_128,
      s7_130, s8_716, s8_718, s7_135, s7_136, s7_137, s7_138, s7_141, s7_143, s7_148, s7_149,
      s7_150, s7_152, s8_720, s8_727, s8_728, s8_729, s7_197, s7_199, s8_736, s8_737, s7_204,
      s7_205, s7_206, s7_210, s7_212, s8_739, s8_741, s7_214, s7_216, s7_221, s7_222, s7_223,
      s7_224, s7_229, s7_230, s7_231, s7_232, s7_235, s7_236, s7_237, s7_241, s7_243, s7_248,
      s7_249, s7_252, s7_253, s8_744, s8_745, s8_747, s8_753, s8_754, s8_755, s8_756, s8_758,
      s8_759, s8_760, s8_763, s8_764, s8_765, s8_766, s8_767, s8_768, s8_772, s8_774, s8_779,
      s8_780, s8_781, s8_782, s8_783, s8_785, s8_787, s8_789, f_carrier_right_x, f_carrier_right_y,
      f_carrier_right_z, n_carrier_right_x, n_carrier_right_y, s8_832, s8_834, s8_835, s8_838,
      s8_839, s8_850, s8_857, s8_866, s8_871, s8_872, s8_873, s8_874, s8_881, s8_882, s8_883,
      s8_884, s8_893, s8_894, s8_900, s8_901, s8_902, s8_905, s8_911, s8_913, s8_919,
      f_carrier_left_x, f_carrier_left_y, f_carrier_left_z, n_carrier_left_x, n_carrier_left_y,
      s8_966, s8_968, s8_969, s8_973, s8_978, s8_983, s8_984, s8_985, s8_988, s8_1000, s8_1009,
      s8_1016, s8_1021, s8_1024, s8_1025, s8_1026, s8_1028, s8_1029, s8_1030, s8_1033, s8_1039,
      s8_1040, s8_1043, s8_1047, s8_1052, s8_1063, s8_1078, s8_1087, s8_1097, s8_1101, s8_1105,
      s8_1107, s8_1111, s8_1114, s8_1127, s8_1136, s8_1145, s8_1169, s8_1175, s8_1181, s8_1185,
      s8_1188, s8_1197, s8_1199, s8_1202, s8_1203, s8_1209, s8_1219, s8_1228, s8_1238,
      pivot_bell_crank, s8_1262, s8_1263, s8_1264, s8_1265, s8_1266, s8_1267, s8_1268, s8_1269,
      s8_1270, s8_1272, s8_1274, s8_1277, s8_1299, s8_1324, s8_1343, s8_1357, s8_1365, s8_1376,
      s8_1378, s8_1382, s8_1396, s8_1400;
};

/// Part 1 of compute_accelerations: step 1: poses and axes b; step 7: inertias of the bodies and
/// forces on joints; step 5: applied forces Q (48); step 4: velocities; step 8: elimination from
/// the leaves to the root (63); step 2: closure Jacobian Phi_z and its factors (60), long_rod_left
/// .. arb_link_rear_right; step 3: Rz (61), long_rod_left .. arb_link_rear_right; step 6: c and
/// dRz/dt zd (62), long_rod_left .. arb_link_rear_right.
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
  work.R_chassis_x_y = mbgen::fnma(R_chassis_aux4_y_x, s1_4, R_chassis_aux4_x_x*s1_3);
  work.R_chassis_y_y = mbgen::fma(R_chassis_aux4_y_x, s1_3, R_chassis_aux4_x_x*s1_4);
  const double s1_5 = s1_1*s1_4;
  work.R_chassis_x_z = mbgen::fma(R_chassis_aux4_x_x, s1_5, R_chassis_aux4_y_x*s1_2);
  work.R_chassis_y_z = mbgen::fnma(R_chassis_aux4_x_x, s1_2, R_chassis_aux4_y_x*s1_5);
  const double R_chassis_aux5_z_z = work.cosines[1];
  work.R_chassis_z_z = R_chassis_aux5_z_z*s1_4;
  work.R_chassis_z_y = R_chassis_aux5_z_z*s1_2;
  work.s1_6 = mbgen::fma(s1_4, work.R_chassis_z_z, s1_2*work.R_chassis_z_y);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s1_7 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_7;
  const double R_lower_arm_left_z_y = work.sines[3];
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_7;
  const double s1_8 = R_lower_arm_left_z_y*work.R_carrier_left_aux1_z_x;
  const double s1_9 = mbgen::fma(R_lower_arm_left_y_y, work.R_carrier_left_aux1_y_x, s1_8);
  const double s1_10 = (-p_carrier_left_rz_z)*R_lower_arm_left_z_y;
  work.s1_11 = mbgen::fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_10);
  const double s1_12 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_13 = mbgen::fnma((-p_carrier_left_rz_z), R_lower_arm_left_y_y, s1_12);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double s1_14 = work.cosines[5];
  const double s1_15 = work.sines[5];
  work.R_carrier_left_aux2_y_y = mbgen::fnma(R_lower_arm_left_z_y, s1_15,
      R_carrier_left_aux1_y_y*s1_14);
  const double s1_16 = mbgen::fma(R_carrier_left_aux1_y_y, s1_15, R_lower_arm_left_z_y*s1_14);
  const double R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  work.R_carrier_left_aux2_z_y = mbgen::fma(R_carrier_left_aux1_z_y, s1_14,
      R_lower_arm_left_y_y*s1_15);
  const double R_carrier_left_aux2_z_z = mbgen::fnma(R_carrier_left_aux1_z_y, s1_15,
      R_lower_arm_left_y_y*s1_14);
  work.s1_17 = s1_7*s1_14;
  const double s1_18 = work.R_carrier_left_aux1_z_x*work.s1_17;
  const double s1_19 = mbgen::fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s1_18);
  const double s1_20 = work.R_carrier_left_aux1_y_x*work.s1_17;
  const double s1_21 = mbgen::fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s1_20);
  work.s1_22 = mbgen::fma(R_lower_arm_left_y_y, s1_21, R_lower_arm_left_z_y*s1_19);
  const double s1_23 = work.R_carrier_left_aux1_y_x*work.R_carrier_left_aux2_z_y;
  const double s1_24 = mbgen::fnma(work.R_carrier_left_aux1_z_x, work.R_carrier_left_aux2_y_y,
      s1_23);
  const double R_carrier_left_aux2_x_z = s1_7*s1_15;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_25 = work.cosines[6];
  const double s1_26 = work.sines[6];
  const double s1_27 = R_carrier_left_aux1_x_x*s1_25;
  work.R_carrier_left_x_x = mbgen::fnma(R_carrier_left_aux2_x_z, s1_26, s1_27);
  const double s1_28 = R_carrier_left_aux1_x_x*s1_26;
  work.R_carrier_left_x_z = mbgen::fma(R_carrier_left_aux2_x_z, s1_25, s1_28);
  work.R_carrier_left_y_x = mbgen::fma(s1_16, s1_26, work.R_carrier_left_aux1_y_x*s1_25);
  work.R_carrier_left_y_z = mbgen::fnma(s1_16, s1_25, work.R_carrier_left_aux1_y_x*s1_26);
  const double s1_29 = work.R_carrier_left_aux1_z_x*s1_25;
  work.R_carrier_left_z_x = mbgen::fnma(R_carrier_left_aux2_z_z, s1_26, s1_29);
  const double s1_30 = work.R_carrier_left_aux1_z_x*s1_26;
  work.R_carrier_left_z_z = mbgen::fma(R_carrier_left_aux2_z_z, s1_25, s1_30);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_31 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_31;
  const double R_lower_arm_right_z_y = work.sines[9];
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_31;
  const double s1_32 = R_lower_arm_right_z_y*work.R_carrier_right_aux1_z_x;
  const double s1_33 = mbgen::fma(R_lower_arm_right_y_y, work.R_carrier_right_aux1_y_x, s1_32);
  const double s1_34 = (-p_carrier_right_rz_z)*R_lower_arm_right_z_y;
  work.s1_35 = mbgen::fnma((-p_carrier_right_rz_y), R_lower_arm_right_y_y, s1_34);
  const double s1_36 = (-p_carrier_right_rz_y)*R_lower_arm_right_z_y;
  work.s1_37 = mbgen::fma((-p_carrier_right_rz_z), R_lower_arm_right_y_y, s1_36);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double s1_38 = work.cosines[11];
  const double s1_39 = work.sines[11];
  const double s1_40 = R_carrier_right_aux1_y_y*s1_38;
  work.R_carrier_right_aux2_y_y = mbgen::fnma(R_lower_arm_right_z_y, s1_39, s1_40);
  const double s1_41 = mbgen::fma(R_carrier_right_aux1_y_y, s1_39, R_lower_arm_right_z_y*s1_38);
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  work.R_carrier_right_aux2_z_y = mbgen::fma(R_carrier_right_aux1_z_y, s1_38,
      R_lower_arm_right_y_y*s1_39);
  const double s1_42 = R_lower_arm_right_y_y*s1_38;
  const double R_carrier_right_aux2_z_z = mbgen::fnma(R_carrier_right_aux1_z_y, s1_39, s1_42);
  work.s1_43 = s1_31*s1_38;
  const double s1_44 = work.R_carrier_right_aux1_z_x*work.s1_43;
  const double s1_45 = mbgen::fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s1_44);
  const double s1_46 = work.R_carrier_right_aux1_y_x*work.s1_43;
  const double s1_47 = mbgen::fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s1_46);
  work.s1_48 = mbgen::fma(R_lower_arm_right_y_y, s1_47, R_lower_arm_right_z_y*s1_45);
  const double s1_49 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s1_50 = mbgen::fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y,
      s1_49);
  const double R_carrier_right_aux2_x_z = s1_31*s1_39;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_51 = work.cosines[12];
  const double s1_52 = work.sines[12];
  const double s1_53 = R_carrier_right_aux1_x_x*s1_51;
  work.R_carrier_right_x_x = mbgen::fnma(R_carrier_right_aux2_x_z, s1_52, s1_53);
  const double s1_54 = R_carrier_right_aux1_x_x*s1_52;
  work.R_carrier_right_x_z = mbgen::fma(R_carrier_right_aux2_x_z, s1_51, s1_54);
  work.R_carrier_right_y_x = mbgen::fma(s1_41, s1_52, work.R_carrier_right_aux1_y_x*s1_51);
  work.R_carrier_right_y_z = mbgen::fnma(s1_41, s1_51, work.R_carrier_right_aux1_y_x*s1_52);
  const double s1_55 = work.R_carrier_right_aux1_z_x*s1_51;
  work.R_carrier_right_z_x = mbgen::fnma(R_carrier_right_aux2_z_z, s1_52, s1_55);
  const double s1_56 = work.R_carrier_right_aux1_z_x*s1_52;
  work.R_carrier_right_z_z = mbgen::fma(R_carrier_right_aux2_z_z, s1_51, s1_56);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double s1_57 = R_rear_axle_aux4_y_x*work.R_rear_axle_aux5_y_x;
  work.s1_58 = mbgen::fma(R_rear_axle_aux4_x_x, work.R_rear_axle_aux5_x_x, s1_57);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_59 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_59;
  const double s1_60 = work.sines[19];
  const double s1_61 = work.cosines[19];
  work.R_rear_axle_x_y = mbgen::fnma(R_rear_axle_aux4_y_x, s1_61, R_rear_axle_aux5_x_z*s1_60);
  work.R_rear_axle_x_z = mbgen::fma(R_rear_axle_aux5_x_z, s1_61, R_rear_axle_aux4_y_x*s1_60);
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_59;
  work.R_rear_axle_y_y = mbgen::fma(R_rear_axle_aux5_y_z, s1_60, R_rear_axle_aux4_x_x*s1_61);
  work.R_rear_axle_y_z = mbgen::fnma(R_rear_axle_aux4_x_x, s1_60, R_rear_axle_aux5_y_z*s1_61);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_60;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_61;
  // operations: 44 add, 110 multiply, 44 sin cos

  // --- step 7: inertias of the bodies and forces on joints ---
  // chassis_aux3: chassis_tz, prismatic, chassis_aux2
  work.R_chassis_aux5_x_x = R_chassis_aux4_x_x*R_chassis_aux5_z_z;
  work.R_chassis_aux5_y_x = R_chassis_aux4_y_x*R_chassis_aux5_z_z;
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double s7_1 = work.R_chassis_aux5_y_x*tau_chassis_ty;
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  const double s7_2 = work.R_chassis_z_y*tau_chassis_tz;
  const double s7_3 = mbgen::fma(work.R_chassis_y_y, tau_chassis_ty, s7_2);
  work.s7_4 = mbgen::fma(work.R_chassis_x_y, tau_chassis_tx, s7_3);
  const double s7_5 = work.R_chassis_z_z*tau_chassis_tz;
  const double s7_6 = mbgen::fma(work.R_chassis_x_z, tau_chassis_tx, s7_5);
  work.s7_7 = mbgen::fma(work.R_chassis_y_z, tau_chassis_ty, s7_6);
  const double s7_8 = mbgen::fma(work.R_chassis_aux5_x_x, tau_chassis_tx, s7_1);
  work.s7_9 = mbgen::fnma(s1_1, tau_chassis_tz, s7_8);
  // operations: 6 add, 11 multiply

  // --- step 5: applied forces Q (48) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s5_1 = 1.0/work.s1_6;
  work.s5_2 = s1_3*s5_1;
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  work.s5_3 = s1_2*s5_1;
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double s5_4 = mbgen::fma(s1_4, tau_chassis_ry, tau_chassis_rx*work.s5_2);
  work.s5_5 = mbgen::fma(tau_chassis_rz, work.s5_3, s5_4);
  work.s5_6 = s1_5*s5_1;
  work.s5_7 = s1_4*s5_1;
  const double s5_8 = mbgen::fma(tau_chassis_rz, work.s5_7, tau_chassis_rx*work.s5_6);
  work.s5_9 = mbgen::fnma(s1_2, tau_chassis_ry, s5_8);
  work.s5_10 = work.s1_6*s5_1;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s5_11 = 1.0/work.s1_22;
  work.s5_12 = R_carrier_left_aux1_z_y*s5_11;
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double s5_13 = tau_carrier_left_ry*work.s5_12;
  work.s5_14 = R_carrier_left_aux1_y_y*s5_11;
  const double s5_15 = tau_carrier_left_ry*work.s5_14;
  work.s5_16 = s1_21*s5_11;
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double s5_17 = mbgen::fma(work.R_carrier_left_aux1_z_x, tau_carrier_left_rx, s5_13);
  work.s5_18 = mbgen::fma(tau_carrier_left_rz, work.s5_16, s5_17);
  work.s5_19 = s5_11*s1_24;
  const double s5_20 = R_carrier_left_aux1_x_x*tau_carrier_left_rx;
  work.s5_21 = s1_9*s5_11;
  const double s5_22 = mbgen::fma(tau_carrier_left_rz, work.s5_19, s5_20);
  work.s5_23 = mbgen::fnma(tau_carrier_left_ry, work.s5_21, s5_22);
  work.s5_24 = s1_19*s5_11;
  const double s5_25 = mbgen::fma(work.R_carrier_left_aux1_y_x, tau_carrier_left_rx, s5_15);
  work.s5_26 = mbgen::fnma(tau_carrier_left_rz, work.s5_24, s5_25);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s5_27 = 1.0/work.s1_48;
  work.s5_28 = R_carrier_right_aux1_z_y*s5_27;
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double s5_29 = tau_carrier_right_ry*work.s5_28;
  work.s5_30 = R_carrier_right_aux1_y_y*s5_27;
  const double s5_31 = tau_carrier_right_ry*work.s5_30;
  work.s5_32 = s1_47*s5_27;
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s5_33 = mbgen::fma(work.R_carrier_right_aux1_z_x, tau_carrier_right_rx, s5_29);
  work.s5_34 = mbgen::fma(tau_carrier_right_rz, work.s5_32, s5_33);
  work.s5_35 = s5_27*s1_50;
  const double s5_36 = R_carrier_right_aux1_x_x*tau_carrier_right_rx;
  work.s5_37 = s1_33*s5_27;
  const double s5_38 = mbgen::fma(tau_carrier_right_rz, work.s5_35, s5_36);
  work.s5_39 = mbgen::fnma(tau_carrier_right_ry, work.s5_37, s5_38);
  work.s5_40 = s1_45*s5_27;
  const double s5_41 = mbgen::fma(work.R_carrier_right_aux1_y_x, tau_carrier_right_rx, s5_31);
  work.s5_42 = mbgen::fnma(tau_carrier_right_rz, work.s5_40, s5_41);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s5_43 = 1.0/work.s1_58;
  work.s5_44 = R_rear_axle_aux4_y_x*s5_43;
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double s5_45 = tau_rear_axle_rx*work.s5_44;
  work.s5_46 = R_rear_axle_aux5_y_z*s5_43;
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s5_47 = mbgen::fma(R_rear_axle_aux4_x_x, tau_rear_axle_ry, s5_45);
  work.s5_48 = mbgen::fma(tau_rear_axle_rz, work.s5_46, s5_47);
  work.s5_49 = R_rear_axle_aux5_x_z*s5_43;
  work.s5_50 = R_rear_axle_aux4_x_x*s5_43;
  const double s5_51 = mbgen::fma(tau_rear_axle_rz, work.s5_49, tau_rear_axle_rx*work.s5_50);
  work.s5_52 = mbgen::fnma(R_rear_axle_aux4_y_x, tau_rear_axle_ry, s5_51);
  work.s5_53 = work.s1_58*s5_43;
  // operations: 20 add, 52 multiply, 4 divide

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
  work.s4_15 = mbgen::fnma(work.w_chassis_z, work.s4_14, work.w_chassis_y*work.s4_12);
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
  work.s4_26 = mbgen::fnma(work.w_chassis_z, work.s4_25, work.w_chassis_y*work.s4_23);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  work.s4_27 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s4_28 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.s4_29 = zd_rear_axle_rx*s1_59;
  work.s4_30 = work.s4_27 + work.s4_28;
  const double s4_31 = state.zd[Coordinate::rear_axle_rz] - work.s4_29;
  work.s4_32 = mbgen::fnma(work.w_chassis_z, work.s4_30, work.w_chassis_y*s4_31);
  work.s4_33 = zd_chassis_rz*s1_1;
  work.w_chassis_x = state.zd[Coordinate::chassis_rx] - work.s4_33;
  work.s4_34 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  work.s4_35 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  const double s4_36 = work.s4_35 - work.s4_34;
  work.s4_37 = mbgen::fnma(work.w_chassis_y, s4_36, work.w_chassis_x*work.s4_30);
  work.s4_38 = mbgen::fnma(work.w_chassis_x, s4_31, work.w_chassis_z*s4_36);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s4_39 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  work.s4_40 = zd_carrier_left_ry*work.s1_17;
  work.s4_41 = state.zd[Coordinate::lower_arm_left] + work.s4_39;
  work.s4_42 = work.s4_41 - work.s4_40;
  work.s4_43 = mbgen::fnma(work.w_chassis_y, work.s4_42, work.w_chassis_x*work.s4_14);
  work.s4_44 = mbgen::fnma(work.w_chassis_x, work.s4_12, work.w_chassis_z*work.s4_42);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s4_45 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  work.s4_46 = zd_carrier_right_ry*work.s1_43;
  work.s4_47 = state.zd[Coordinate::lower_arm_right] + work.s4_45;
  work.s4_48 = work.s4_47 - work.s4_46;
  work.s4_49 = mbgen::fnma(work.w_chassis_y, work.s4_48, work.w_chassis_x*work.s4_25);
  work.s4_50 = mbgen::fnma(work.w_chassis_x, work.s4_23, work.w_chassis_z*work.s4_48);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.w_carrier_left_x = work.w_chassis_x + work.s4_42;
  work.w_carrier_left_y = work.w_chassis_y + work.s4_14;
  const double s4_51 = work.s1_17*work.w_carrier_left_y;
  work.s4_52 = mbgen::fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_x, s4_51);
  work.w_carrier_left_z = work.w_chassis_z + work.s4_12;
  const double s4_53 = work.s1_17*work.w_carrier_left_z;
  work.s4_54 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_x, s4_53);
  const double s4_55 = mbgen::fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_y,
      state.zd[Coordinate::wheel_front_left]);
  const double s4_56 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s4_55);
  work.s4_57 = mbgen::fnma(work.s1_17, work.w_carrier_left_x, s4_56);
  const double s4_58 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_y;
  work.s4_59 = mbgen::fnma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_z, s4_58);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.w_carrier_right_x = work.w_chassis_x + work.s4_48;
  work.w_carrier_right_y = work.w_chassis_y + work.s4_25;
  const double s4_60 = work.s1_43*work.w_carrier_right_y;
  work.s4_61 = mbgen::fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_x, s4_60);
  work.w_carrier_right_z = work.w_chassis_z + work.s4_23;
  const double s4_62 = work.s1_43*work.w_carrier_right_z;
  work.s4_63 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_x, s4_62);
  const double s4_64 = mbgen::fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_y,
      state.zd[Coordinate::wheel_front_right]);
  const double s4_65 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s4_64);
  work.s4_66 = mbgen::fnma(work.s1_43, work.w_carrier_right_x, s4_65);
  const double s4_67 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_y;
  work.s4_68 = mbgen::fnma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_z, s4_67);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.w_rear_axle_x = work.w_chassis_x + s4_36;
  work.w_rear_axle_y = work.w_chassis_y + work.s4_30;
  const double s4_69 = work.R_rear_axle_y_y*work.w_rear_axle_x;
  const double s4_70 = mbgen::fnma(work.R_rear_axle_x_y, work.w_rear_axle_y, s4_69);
  work.w_rear_axle_z = work.w_chassis_z + s4_31;
  const double s4_71 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s4_72 = mbgen::fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s4_71);
  const double s4_73 = mbgen::fma(work.R_rear_axle_x_y, work.w_rear_axle_x, s4_72);
  const double s4_74 = work.R_rear_axle_x_y*work.w_rear_axle_z;
  const double s4_75 = mbgen::fnma(work.R_rear_axle_z_y, work.w_rear_axle_x, s4_74);
  const double s4_76 = work.R_rear_axle_z_y*work.w_rear_axle_y;
  const double s4_77 = mbgen::fnma(work.R_rear_axle_y_y, work.w_rear_axle_z, s4_76);
  const double s4_78 = state.zd[Coordinate::wheel_rear_right] + s4_73;
  const double s4_79 = s4_78 + (state.zd[Coordinate::wheel_rear_left] + s4_73);
  // operations: 56 add, 71 multiply

  // --- step 8: elimination from the leaves to the root (63) ---
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s8_1 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_2 = I_wheel_rear_right_polar*s4_79;
  work.s8_3 = mbgen::fma(s4_70, s8_2, work.R_rear_axle_z_y*s8_1);
  work.s8_4 = mbgen::fma(s4_75, s8_2, work.R_rear_axle_y_y*s8_1);
  work.s8_5 = mbgen::fma(s4_77, s8_2, work.R_rear_axle_x_y*s8_1);

  // --- step 2: closure Jacobian Phi_z and its factors (60), long_rod_left .. arb_link_rear_right
  // ---
  // long_rod_left
  const double s2_1 = p_long_rod_left_to_x*s1_59;
  const double s2_2 = mbgen::fma((-p_long_rod_left_to_z), work.R_rear_axle_z_z, s2_1);
  const double s2_3 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s2_4 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_x_z, s2_3);
  const double s2_5 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s2_6 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_y_z, s2_5);
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - (-p_rear_axle_tx_z);
  work.s2_7 = mbgen::fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_2);
  work.s2_8 = (-p_long_rod_left_from_z) + (work.r_rear_axle_aux3_z + work.s2_7);
  work.s2_9 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_4);
  const double s2_10 = mbgen::fnma(s4_36, work.s2_7, s4_31*work.s2_9);
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  work.s2_11 = (-p_long_rod_left_from_x) + (work.r_rear_axle_aux1_x + work.s2_9);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.s2_12 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_6);
  work.s2_13 = p_long_rod_left_from_y - z_rear_axle_ty - work.s2_12;
  const double s2_14 = mbgen::fma(work.s2_7, work.s2_13, work.s2_8*work.s2_12);
  const double s2_15 = mbgen::fnma(s4_31, work.s2_12, work.s4_30*work.s2_7);
  const double s2_16 = mbgen::fnma(work.s4_30, work.s2_9, s4_36*work.s2_12);
  work.s2_17 = mbgen::fnma(s4_31, s2_10, work.s4_30*s2_16);
  work.s2_18 = mbgen::fnma(s4_36, s2_16, s4_31*s2_15);
  work.s2_19 = mbgen::fnma(work.s4_30, s2_15, s4_36*s2_10);
  // diag_rod_left
  const double s2_20 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  work.s2_21 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s2_20);
  work.s2_22 = (-p_diag_rod_left_from_z) + (work.r_rear_axle_aux3_z + work.s2_21);
  const double s2_23 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  work.s2_24 = mbgen::fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_23);
  const double s2_25 = mbgen::fnma(s4_36, work.s2_21, s4_31*work.s2_24);
  work.s2_26 = (-p_diag_rod_left_from_x) + (work.r_rear_axle_aux1_x + work.s2_24);
  const double s2_27 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  work.s2_28 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_27);
  work.s2_29 = p_diag_rod_left_from_y - z_rear_axle_ty - work.s2_28;
  const double s2_30 = mbgen::fma(work.s2_21, work.s2_29, work.s2_22*work.s2_28);
  const double s2_31 = mbgen::fnma(s4_31, work.s2_28, work.s4_30*work.s2_21);
  const double s2_32 = mbgen::fnma(work.s4_30, work.s2_24, s4_36*work.s2_28);
  work.s2_33 = mbgen::fnma(s4_31, s2_25, work.s4_30*s2_32);
  work.s2_34 = mbgen::fnma(s4_36, s2_32, s4_31*s2_31);
  work.s2_35 = mbgen::fnma(work.s4_30, s2_31, s4_36*s2_25);
  // arb_link_rear_left
  const double s2_36 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_y_x;
  const double s2_37 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_y_z, s2_36);
  const double s2_38 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_x_x;
  const double s2_39 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_x_z, s2_38);
  const double s2_40 = (-p_arb_link_rear_left_to_x)*s1_59;
  const double s2_41 = mbgen::fnma((-p_arb_link_rear_left_to_z), work.R_rear_axle_z_z, s2_40);
  work.s2_42 = p_arb_link_rear_left_from_x*work.sines[20];
  work.s2_43 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_41);
  const double s2_44 = work.s2_42 + (work.r_rear_axle_aux3_z + work.s2_43);
  work.s2_45 = (-p_arb_rear_left_z) + s2_44;
  work.s2_46 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_37);
  const double s2_47 = mbgen::fnma(s4_31, work.s2_46, work.s4_30*work.s2_43);
  work.s2_48 = 0.6 - z_rear_axle_ty - work.s2_46;
  const double s2_49 = mbgen::fma(work.s2_43, work.s2_48, work.s2_45*work.s2_46);
  work.s2_50 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_39);
  const double s2_51 = mbgen::fnma(s4_36, work.s2_43, s4_31*work.s2_50);
  const double s2_52 = mbgen::fnma(work.s4_30, work.s2_50, s4_36*work.s2_46);
  work.s2_53 = mbgen::fnma(s4_36, s2_52, s4_31*s2_47);
  work.s2_54 = p_arb_link_rear_left_from_x*work.cosines[20];
  work.s2_55 = work.s2_54 - work.r_rear_axle_aux1_x - work.s2_50 - (-p_arb_rear_left_x);
  const double s2_56 = mbgen::fnma(work.s2_42, work.s2_55, work.s2_45*work.s2_54);
  // long_rod_right
  work.s2_57 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_2);
  work.s2_58 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_6);
  const double s2_59 = mbgen::fma(s4_31, work.s2_58, work.s4_30*work.s2_57);
  work.s2_60 = (-p_long_rod_right_from_y) + (z_rear_axle_ty + work.s2_58);
  work.s2_61 = (-p_long_rod_right_from_z) + (work.r_rear_axle_aux3_z - work.s2_57);
  const double s2_62 = mbgen::fma(work.s2_57, work.s2_60, work.s2_58*work.s2_61);
  work.s2_63 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_4);
  const double s2_64 = mbgen::fma(s4_31, work.s2_63, s4_36*work.s2_57);
  const double s2_65 = mbgen::fnma(work.s4_30, work.s2_63, s4_36*work.s2_58);
  work.s2_66 = mbgen::fma(s4_36, s2_64, work.s4_30*s2_59);
  work.s2_67 = mbgen::fma(s4_36, s2_65, s4_31*s2_59);
  work.s2_68 = mbgen::fnma(s4_31, s2_64, work.s4_30*s2_65);
  work.s2_69 = (-p_long_rod_right_from_x) + (work.r_rear_axle_aux1_x + work.s2_63);
  // diag_rod_right
  work.s2_70 = mbgen::fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_23);
  work.pivot_rear_axle_tx = (-p_diag_rod_right_from_x) + (work.r_rear_axle_aux1_x + work.s2_70);
  work.s2_71 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s2_20);
  const double s2_72 = mbgen::fnma(s4_36, work.s2_71, s4_31*work.s2_70);
  work.s2_73 = (-p_diag_rod_right_from_z) + (work.r_rear_axle_aux3_z + work.s2_71);
  const double s2_74 = mbgen::fnma(work.pivot_rear_axle_tx, work.s2_71, work.s2_70*work.s2_73);
  work.s2_75 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_27);
  const double s2_76 = mbgen::fnma(s4_31, work.s2_75, work.s4_30*work.s2_71);
  const double s2_77 = mbgen::fnma(work.s4_30, work.s2_70, s4_36*work.s2_75);
  work.s2_78 = mbgen::fnma(s4_31, s2_72, work.s4_30*s2_77);
  work.s2_79 = mbgen::fnma(s4_36, s2_77, s4_31*s2_76);
  work.s2_80 = mbgen::fnma(work.s4_30, s2_76, s4_36*s2_72);
  work.s2_81 = (-p_diag_rod_right_from_y) + (z_rear_axle_ty + work.s2_75);
  const double s2_82 = mbgen::fnma(work.s2_73, work.s2_75, work.s2_71*work.s2_81);
  const double s2_83 = mbgen::fnma(work.s2_70, work.s2_81, work.pivot_rear_axle_tx*work.s2_75);
  // arb_link_rear_right
  work.s2_84 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_37);
  work.s2_85 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_39);
  const double s2_86 = mbgen::fnma(s4_36, work.s2_84, work.s4_30*work.s2_85);
  work.s2_87 = 0.6 + (z_rear_axle_ty - work.s2_84);
  work.s2_88 = mbgen::fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_41);
  const double s2_89 = mbgen::fma(s4_36, work.s2_88, s4_31*work.s2_85);
  const double s2_90 = mbgen::fma(work.s4_30, work.s2_88, s4_31*work.s2_84);
  work.s2_91 = mbgen::fnma(s4_36, s2_86, s4_31*s2_90);
  work.s2_92 = p_arb_link_rear_right_from_x*work.sines[21];
  const double s2_93 = work.s2_92 + (work.r_rear_axle_aux3_z + work.s2_88);
  work.s2_94 = (-p_arb_rear_right_z) + s2_93;
  work.s2_95 = p_arb_link_rear_right_from_x*work.cosines[21];
  const double s2_96 = work.s2_85 + work.s2_95 - work.r_rear_axle_aux1_x;
  work.s2_97 = s2_96 - (-p_arb_rear_right_x);
  const double s2_98 = mbgen::fnma(work.s2_92, work.s2_97, work.s2_94*work.s2_95);
  const double s2_99 = 1.0/work.pivot_rear_axle_tx;
  const double s2_100 = work.s2_26*s2_99;
  const double s2_101 = mbgen::fnma(work.s2_26, work.s2_28, s2_83*s2_100);
  const double s2_102 = mbgen::fnma(work.s2_24, work.s2_29, s2_101);
  const double s2_103 = mbgen::fnma(work.s2_22, work.s2_24, s2_74*s2_100);
  const double s2_104 = mbgen::fma(work.s2_21, work.s2_26, s2_103);
  const double s2_105 = mbgen::fma(s2_82, s2_100, s2_30);
  const double s2_106 = work.s2_11*s2_99;
  const double s2_107 = mbgen::fnma(work.s2_11, work.s2_12, s2_83*s2_106);
  const double s2_108 = mbgen::fnma(work.s2_8, work.s2_9, s2_74*s2_106);
  const double s2_109 = mbgen::fma(work.s2_81, s2_100, work.s2_29);
  const double s2_110 = 1.0/s2_109;
  const double s2_111 = mbgen::fma(work.s2_81, s2_106, work.s2_13)*s2_110;
  const double pivot_rear_axle_rx = mbgen::fnma(s2_102, s2_111, mbgen::fnma(work.s2_9, work.s2_13,
      s2_107));
  const double s2_112 = mbgen::fnma(s2_111, s2_104, mbgen::fma(work.s2_7, work.s2_11, s2_108));
  const double s2_113 = mbgen::fnma(s2_111, s2_105, mbgen::fma(s2_82, s2_106, s2_14));
  const double s2_114 = work.s2_69*s2_99;
  const double s2_115 = mbgen::fnma(work.s2_58, work.s2_69, s2_83*s2_114);
  const double s2_116 = mbgen::fnma(work.s2_61, work.s2_63, s2_74*s2_114);
  const double s2_117 = s2_110*mbgen::fnma(work.s2_81, s2_114, work.s2_60);
  const double s2_118 = 1.0/pivot_rear_axle_rx;
  const double s2_119 = mbgen::fma(s2_102, s2_117, mbgen::fma(work.s2_60, work.s2_63, s2_115));
  const double s2_120 = s2_119*s2_118;
  const double s2_121 = mbgen::fma(s2_104, s2_117, mbgen::fnma(work.s2_57, work.s2_69, s2_116));
  const double pivot_rear_axle_ry = mbgen::fnma(s2_112, s2_120, s2_121);
  const double s2_122 = mbgen::fma(s2_117, s2_105, mbgen::fma(s2_82, s2_114, s2_62));
  const double s2_123 = mbgen::fnma(s2_120, s2_113, s2_122);
  const double s2_124 = work.s2_97*s2_99;
  const double s2_125 = s2_110*mbgen::fma(work.s2_81, s2_124, work.s2_87);
  const double s2_126 = mbgen::fnma(work.s2_84, work.s2_97, s2_102*s2_125);
  const double s2_127 = mbgen::fnma(work.s2_88, work.s2_97, s2_104*s2_125);
  const double s2_128 = mbgen::fnma(work.s2_87, work.s2_88, s2_105*s2_125);
  const double s2_129 = mbgen::fnma(s2_83, s2_124, mbgen::fnma(work.s2_85, work.s2_87, s2_126));
  const double s2_130 = s2_118*s2_129;
  const double s2_131 = mbgen::fnma(s2_74, s2_124, mbgen::fma(work.s2_85, work.s2_94, s2_127));
  const double s2_132 = mbgen::fnma(s2_82, s2_124, mbgen::fnma(work.s2_84, work.s2_94, s2_128));
  const double s2_133 = 1.0/pivot_rear_axle_ry;
  const double s2_134 = mbgen::fnma(s2_112, s2_130, s2_131)*s2_133;
  const double pivot_rear_axle_rz = mbgen::fnma(s2_123, s2_134, mbgen::fnma(s2_113, s2_130,
      s2_132));
  const double s2_135 = work.s2_55*s2_99;
  const double s2_136 = s2_110*mbgen::fms(work.s2_81, s2_135, work.s2_48);
  const double s2_137 = mbgen::fnma(work.s2_48, work.s2_50, s2_102*s2_136);
  const double s2_138 = mbgen::fnma(work.s2_45, work.s2_50, s2_104*s2_136);
  const double s2_139 = mbgen::fnma(work.s2_73, s2_100, work.s2_22);
  const double s2_140 = mbgen::fnma(s2_111, s2_139, mbgen::fnma(work.s2_73, s2_106, work.s2_8));
  const double s2_141 = mbgen::fnma(s2_83, s2_135, mbgen::fma(work.s2_46, work.s2_55, s2_137));
  const double s2_142 = s2_118*s2_141;
  const double s2_143 = mbgen::fnma(s2_74, s2_135, mbgen::fnma(work.s2_43, work.s2_55, s2_138));
  const double s2_144 = mbgen::fma(s2_105, s2_136, mbgen::fnma(s2_82, s2_135, s2_49));
  const double s2_145 = mbgen::fma(s2_117, s2_139, mbgen::fnma(work.s2_73, s2_114, work.s2_61));
  const double s2_146 = mbgen::fnma(s2_120, s2_140, s2_145);
  const double s2_147 = s2_133*mbgen::fnma(s2_112, s2_142, s2_143);
  const double s2_148 = mbgen::fma(s2_125, s2_139, mbgen::fma(work.s2_73, s2_124, work.s2_94));
  const double s2_149 = mbgen::fnma(s2_134, s2_146, mbgen::fnma(s2_130, s2_140, s2_148));
  const double s2_150 = 1.0/pivot_rear_axle_rz;
  const double s2_151 = mbgen::fnma(s2_123, s2_147, mbgen::fnma(s2_113, s2_142, s2_144))*s2_150;
  const double s2_152 = mbgen::fma(s2_139, s2_136, mbgen::fma(work.s2_73, s2_135, work.s2_45));
  const double s2_153 = mbgen::fnma(s2_146, s2_147, mbgen::fnma(s2_140, s2_142, s2_152));
  const double pivot_rear_axle_tz = mbgen::fnma(s2_149, s2_151, s2_153);
  const double s2_154 = 1.2494533266510743*std::abs(work.pivot_rear_axle_tx);
  const double s2_155 = mbgen::min(s2_154, 1.665350081353039*std::abs(s2_109));
  const double s2_156 = mbgen::min(s2_155, 2.1234888829989926*std::abs(pivot_rear_axle_rx));
  const double s2_157 = mbgen::min(s2_156, 1.7864443153153613*std::abs(pivot_rear_axle_ry));
  const double s2_158 = mbgen::min(s2_157, 8.176955428452642*std::abs(pivot_rear_axle_rz));
  work.s2_159 = mbgen::min(s2_158, 2.7700489841913827*std::abs(pivot_rear_axle_tz));
  // operations: 173 add, 217 multiply, 5 divide, 11 other

  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  const double s3_1 = 1.0/pivot_rear_axle_tz;
  work.s3_2 = s2_56*s3_1;
  work.Rz_rear_axle_rz_0 = s2_150*(s2_149*work.s3_2);
  work.Rz_rear_axle_ry_0 = s2_133*mbgen::fnma(s2_123, work.Rz_rear_axle_rz_0, s2_146*work.s3_2);
  const double s3_3 = mbgen::fnma(s2_113, work.Rz_rear_axle_rz_0, s2_140*work.s3_2);
  const double s3_4 = mbgen::fnma(s2_105, work.Rz_rear_axle_rz_0, s2_139*work.s3_2);
  const double s3_5 = mbgen::fma(s2_82, work.Rz_rear_axle_rz_0, work.s2_73*work.s3_2);
  work.Rz_rear_axle_rx_0 = s2_118*mbgen::fnma(s2_112, work.Rz_rear_axle_ry_0, s3_3);
  const double s3_6 = mbgen::fnma(s2_104, work.Rz_rear_axle_ry_0, s3_4);
  const double s3_7 = mbgen::fma(s2_74, work.Rz_rear_axle_ry_0, s3_5);
  work.s3_8 = s2_110*mbgen::fnma(s2_102, work.Rz_rear_axle_rx_0, s3_6);
  const double s3_9 = mbgen::fma(s2_83, work.Rz_rear_axle_rx_0, s3_7);
  work.Rz_rear_axle_tx_0 = s2_99*mbgen::fma(work.s2_81, work.s3_8, s3_9);
  work.Rz_rear_axle_tz_1 = s2_98*s2_151*s3_1;
  work.s3_10 = s2_150*mbgen::fma(s2_149, work.Rz_rear_axle_tz_1, s2_98);
  work.Rz_rear_axle_ry_1 = s2_133*mbgen::fnma(s2_146, work.Rz_rear_axle_tz_1, s2_123*work.s3_10);
  const double s3_11 = mbgen::fnma(s2_112, work.Rz_rear_axle_ry_1, s2_113*work.s3_10);
  work.Rz_rear_axle_rx_1 = s2_118*mbgen::fnma(s2_140, work.Rz_rear_axle_tz_1, s3_11);
  const double s3_12 = mbgen::fnma(s2_104, work.Rz_rear_axle_ry_1, s2_105*work.s3_10);
  const double s3_13 = mbgen::fnma(s2_102, work.Rz_rear_axle_rx_1, s3_12);
  work.s3_14 = s2_110*mbgen::fnma(s2_139, work.Rz_rear_axle_tz_1, s3_13);
  const double s3_15 = mbgen::fma(s2_83, work.Rz_rear_axle_rx_1, s2_74*work.Rz_rear_axle_ry_1);
  const double s3_16 = mbgen::fma(work.s2_81, work.s3_14, s3_15);
  const double s3_17 = mbgen::fnma(s2_82, work.s3_10, s3_16);
  work.Rz_rear_axle_tx_1 = s2_99*mbgen::fnma(work.s2_73, work.Rz_rear_axle_tz_1, s3_17);
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
  const double s6_8 = mbgen::fnma(s4_36, s2_51, zd_arb_rear_left*s6_7);
  work.s6_9 = mbgen::fma(work.s4_30, s2_47, s6_8);
  const double s6_10 = zd_arb_rear_left*work.s2_54;
  const double s6_11 = mbgen::fma(work.s4_30, s2_52, zd_arb_rear_left*s6_10);
  work.s6_12 = mbgen::fnma(s4_31, s2_51, s6_11);
  work.s6_13 = zd_rear_axle_ty + s2_51;
  work.s6_14 = s6_7 + (zd_rear_axle_tx + s2_47);
  work.s6_15 = s6_10 + (zd_rear_axle_tz + s2_52);
  // long_rod_right
  work.s6_16 = zd_rear_axle_ty + s2_64;
  work.s6_17 = zd_rear_axle_tz + s2_65;
  work.s6_18 = zd_rear_axle_tx - s2_59;
  // diag_rod_right
  work.s6_19 = zd_rear_axle_tx + s2_76;
  work.s6_20 = zd_rear_axle_ty + s2_72;
  work.s6_21 = zd_rear_axle_tz + s2_77;
  const double s6_22 = mbgen::fma(work.s6_19, work.s6_19, work.s6_20*work.s6_20);
  const double s6_23 = mbgen::fma(work.s6_21, work.s6_21, s6_22);
  const double s6_24 = mbgen::fma(work.s2_81, work.s2_79, s6_23);
  const double s6_25 = mbgen::fma(work.s2_73, work.s2_80, s6_24);
  const double s6_26 = mbgen::fma(work.pivot_rear_axle_tx, work.s2_78, s6_25);
  const double s6_27 = mbgen::fnma(work.s6_5, work.s6_5, s2_100*s6_26);
  const double s6_28 = mbgen::fnma(work.s6_4, work.s6_4, s6_27);
  const double s6_29 = mbgen::fnma(work.s6_6, work.s6_6, s6_28);
  const double s6_30 = mbgen::fnma(work.s2_22, work.s2_35, s6_29);
  const double s6_31 = mbgen::fnma(work.s2_26, work.s2_33, s6_30);
  const double s6_32 = mbgen::fma(work.s2_29, work.s2_34, s6_31);
  const double s6_33 = mbgen::fnma(work.s6_2, work.s6_2, s2_106*s6_26);
  const double s6_34 = mbgen::fnma(work.s6_1, work.s6_1, s6_33);
  const double s6_35 = mbgen::fnma(work.s6_3, work.s6_3, s6_34);
  const double s6_36 = mbgen::fnma(work.s2_8, work.s2_19, s6_35);
  const double s6_37 = mbgen::fnma(work.s2_11, work.s2_17, s6_36);
  const double s6_38 = mbgen::fnma(s2_111, s6_32, mbgen::fma(work.s2_13, work.s2_18, s6_37));
  const double s6_39 = mbgen::fnma(work.s6_16, work.s6_16, s2_114*s6_26);
  const double s6_40 = mbgen::fnma(work.s6_17, work.s6_17, s6_39);
  const double s6_41 = mbgen::fnma(work.s6_18, work.s6_18, s6_40);
  const double s6_42 = mbgen::fnma(work.s2_61, work.s2_66, s6_41);
  const double s6_43 = mbgen::fnma(work.s2_69, work.s2_68, s6_42);
  const double s6_44 = mbgen::fma(s2_117, s6_32, mbgen::fma(work.s2_60, work.s2_67, s6_43));
  const double s6_45 = mbgen::fnma(s2_120, s6_38, s6_44);
  const double s6_46 = s2_125*s6_32;
  const double s6_47 = mbgen::fnma(work.s6_13, work.s6_13, s2_136*s6_32);
  const double s6_48 = mbgen::fnma(work.s6_14, work.s6_14, s6_47);
  const double s6_49 = mbgen::fnma(work.s6_15, work.s6_15, s6_48);
  const double s6_50 = mbgen::fma(work.s2_48, work.s2_53, s6_49);
  const double s6_51 = mbgen::fma(work.s2_45, work.s6_9, s6_50);
  const double s6_52 = mbgen::fnma(s2_135, s6_26, mbgen::fma(work.s2_55, work.s6_12, s6_51));
  const double s6_53 = mbgen::fnma(s2_147, s6_45, mbgen::fnma(s2_142, s6_38, s6_52));
  // arb_link_rear_right
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s6_54 = zd_arb_rear_right*work.s2_92;
  const double s6_55 = mbgen::fma(s4_36, s2_89, zd_arb_rear_right*s6_54);
  work.s6_56 = mbgen::fma(work.s4_30, s2_90, s6_55);
  const double s6_57 = zd_arb_rear_right*work.s2_95;
  const double s6_58 = mbgen::fma(s4_31, s2_89, zd_arb_rear_right*s6_57);
  work.s6_59 = mbgen::fma(work.s4_30, s2_86, s6_58);
  work.s6_60 = zd_rear_axle_ty - s2_89;
  work.s6_61 = s6_54 + (zd_rear_axle_tx + s2_90);
  const double s6_62 = mbgen::fnma(work.s6_60, work.s6_60, s6_46);
  work.s6_63 = s6_57 + (zd_rear_axle_tz + s2_86);
  const double s6_64 = mbgen::fnma(work.s6_61, work.s6_61, s6_62);
  const double s6_65 = mbgen::fnma(work.s6_63, work.s6_63, s6_64);
  const double s6_66 = mbgen::fnma(work.s2_87, work.s2_91, s6_65);
  const double s6_67 = mbgen::fma(work.s2_94, work.s6_56, s6_66);
  const double s6_68 = mbgen::fnma(s2_124, s6_26, mbgen::fma(work.s2_97, work.s6_59, s6_67));
  const double s6_69 = mbgen::fnma(s2_134, s6_45, mbgen::fnma(s2_130, s6_38, s6_68));
  const double s6_70 = mbgen::fnma(s2_151, s6_69, s6_53);
  work.zdd_star_rear_axle_tz = s3_1*s6_70;
  work.zdd_star_rear_axle_rz = s2_150*mbgen::fnma(s2_149, work.zdd_star_rear_axle_tz, s6_69);
  const double s6_71 = mbgen::fnma(s2_123, work.zdd_star_rear_axle_rz, s6_45);
  work.zdd_star_rear_axle_ry = s2_133*mbgen::fnma(s2_146, work.zdd_star_rear_axle_tz, s6_71);
  const double s6_72 = mbgen::fnma(s2_112, work.zdd_star_rear_axle_ry, s6_38);
  const double s6_73 = mbgen::fnma(s2_113, work.zdd_star_rear_axle_rz, s6_72);
  work.zdd_star_rear_axle_rx = s2_118*mbgen::fnma(s2_140, work.zdd_star_rear_axle_tz, s6_73);
  const double s6_74 = mbgen::fnma(s2_102, work.zdd_star_rear_axle_rx, s6_32);
  const double s6_75 = mbgen::fnma(s2_104, work.zdd_star_rear_axle_ry, s6_74);
  const double s6_76 = mbgen::fnma(s2_105, work.zdd_star_rear_axle_rz, s6_75);
  work.s6_77 = s2_110*mbgen::fnma(s2_139, work.zdd_star_rear_axle_tz, s6_76);
  const double s6_78 = mbgen::fms(s2_82, work.zdd_star_rear_axle_rz, s6_26);
  const double s6_79 = mbgen::fma(s2_74, work.zdd_star_rear_axle_ry, s6_78);
  const double s6_80 = mbgen::fma(s2_83, work.zdd_star_rear_axle_rx, s6_79);
  const double s6_81 = mbgen::fma(work.s2_81, work.s6_77, s6_80);
  work.zdd_star_rear_axle_tx = s2_99*mbgen::fnma(work.s2_73, work.zdd_star_rear_axle_tz, s6_81);
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
  work.s7_11 = mbgen::fma(h_rear_axle_z, work.R_rear_axle_y_z, s7_10);
  const double s7_12 = h_rear_axle_x*work.R_rear_axle_aux5_x_x;
  work.s7_13 = mbgen::fma(h_rear_axle_z, work.R_rear_axle_x_z, s7_12);
  const double s1_59 = work.sines[18];
  work.s7_14 = mbgen::fnma(h_rear_axle_x, s1_59, h_rear_axle_z*work.R_rear_axle_z_z);

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
  const double s7_16 = mbgen::fma(K_rear_axle_xz, work.R_rear_axle_y_z, s7_15);
  const double s7_17 = K_rear_axle_xx*work.R_rear_axle_aux5_x_x;
  const double s7_18 = mbgen::fma(K_rear_axle_xz, work.R_rear_axle_x_z, s7_17);
  const double s7_19 = K_rear_axle_yy*work.R_rear_axle_y_y;
  const double s7_20 = mbgen::fnma((-K_rear_axle_yz), work.R_rear_axle_y_z, s7_19);
  const double s7_21 = K_rear_axle_yy*work.R_rear_axle_x_y;
  const double s7_22 = mbgen::fnma((-K_rear_axle_yz), work.R_rear_axle_x_z, s7_21);
  const double s7_23 = K_rear_axle_xz*work.R_rear_axle_aux5_y_x;
  const double s7_24 = mbgen::fma(K_rear_axle_zz, work.R_rear_axle_y_z, s7_23);
  const double s7_25 = mbgen::fnma((-K_rear_axle_yz), work.R_rear_axle_y_y, s7_24);
  const double s7_26 = mbgen::fma(work.R_rear_axle_z_z, s7_25, work.R_rear_axle_z_y*s7_20);
  const double s7_27 = mbgen::fnma(s1_59, s7_16, s7_26);
  const double s7_28 = K_rear_axle_xz*work.R_rear_axle_aux5_x_x;
  const double s7_29 = mbgen::fma(K_rear_axle_zz, work.R_rear_axle_x_z, s7_28);
  const double s7_30 = mbgen::fnma((-K_rear_axle_yz), work.R_rear_axle_x_y, s7_29);
  const double s7_31 = mbgen::fma(work.R_rear_axle_z_z, s7_30, work.R_rear_axle_z_y*s7_22);
  const double s7_32 = mbgen::fnma(s1_59, s7_18, s7_31);
  const double s7_33 = mbgen::fma(work.R_rear_axle_aux5_y_x, s7_18, work.R_rear_axle_y_y*s7_22);
  const double s7_34 = mbgen::fma(work.R_rear_axle_y_z, s7_30, s7_33);
  const double s7_35 = mbgen::fma(work.R_rear_axle_aux5_y_x, s7_16, work.R_rear_axle_y_y*s7_20);
  const double s7_36 = mbgen::fma(work.R_rear_axle_y_z, s7_25, s7_35);
  const double s7_37 = mbgen::fma(work.R_rear_axle_aux5_x_x, s7_18, work.R_rear_axle_x_y*s7_22);
  const double s7_38 = mbgen::fma(work.R_rear_axle_x_z, s7_30, s7_37);
  const double s8_9 = mbgen::fma(work.Rz_rear_axle_tz_1, work.s7_11, work.s3_14*work.s7_14);
  const double s8_10 = mbgen::fnma(work.Rz_rear_axle_ry_1, s7_34, s8_9);
  const double s8_11 = mbgen::fnma(work.Rz_rear_axle_tz_1, work.s7_13, s8_8);
  const double s8_12 = mbgen::fma(work.s3_10, s7_34, s8_11);
  const double s7_39 = K_rear_axle_trace - s7_38 - s7_36;
  const double s7_40 = s7_38 + (s7_36 + s7_39);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_z = work.sines[20];
  const double s7_41 = K_arb_rear_left_zz*R_arb_rear_left_x_z;
  const double R_arb_rear_left_x_x = work.cosines[20];
  const double s7_42 = K_arb_rear_left_xx*R_arb_rear_left_x_x;
  const double s7_43 = mbgen::fnma(R_arb_rear_left_x_z, s7_42, R_arb_rear_left_x_x*s7_41);
  const double s7_44 = mbgen::fma(R_arb_rear_left_x_x, s7_42, R_arb_rear_left_x_z*s7_41);
  const double s7_45 = 0.4224999999999999 - s7_44;
  const double s7_46 = K_arb_rear_left_yy + (s7_44 + s7_45) - K_arb_rear_left_yy;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_z = work.sines[21];
  const double s7_47 = K_arb_rear_right_zz*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = work.cosines[21];
  const double s7_48 = K_arb_rear_right_xx*R_arb_rear_right_x_x;
  const double s7_49 = mbgen::fnma(R_arb_rear_right_x_z, s7_48, R_arb_rear_right_x_x*s7_47);
  const double s7_50 = mbgen::fma(R_arb_rear_right_x_x, s7_48, R_arb_rear_right_x_z*s7_47);
  const double s7_51 = 0.4224999999999999 - s7_50;
  const double s7_52 = K_arb_rear_right_yy + (s7_50 + s7_51) - K_arb_rear_right_yy;
  // operations: 37 add, 47 multiply

  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  work.s8_13 = work.w_chassis_y + work.w_chassis_y;
  const double s8_14 = zd_arb_rear_right*zd_arb_rear_right;
  const double s8_15 = mbgen::fma(zd_arb_rear_right, work.s8_13, s8_14);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s8_16 = zd_arb_rear_left*zd_arb_rear_left;
  const double s8_17 = mbgen::fma(zd_arb_rear_left, work.s8_13, s8_16);
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s8_18 = mbgen::fma(zd_pitman_arm, work.s8_13, zd_pitman_arm*zd_pitman_arm);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s8_19 = zd_arb_front_right*zd_arb_front_right;
  work.s8_20 = mbgen::fma(zd_arb_front_right, work.s8_13, s8_19);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s8_21 = zd_arb_front_left*zd_arb_front_left;
  work.s8_22 = mbgen::fma(zd_arb_front_left, work.s8_13, s8_21);
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  work.s8_23 = work.w_chassis_x + work.w_chassis_x;
  const double s8_24 = zd_upper_arm_right*zd_upper_arm_right;
  work.s8_25 = mbgen::fma(zd_upper_arm_right, work.s8_23, s8_24);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s8_26 = zd_upper_arm_left*zd_upper_arm_left;
  work.s8_27 = mbgen::fma(zd_upper_arm_left, work.s8_23, s8_26);
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s8_28 = work.w_chassis_z + work.w_chassis_z;
  work.s8_29 = mbgen::fma(zd_bell_crank, work.s8_28, zd_bell_crank*zd_bell_crank);
  const double s8_30 = (-K_arb_rear_right_xy)*R_arb_rear_right_x_z;
  const double s8_31 = (-K_arb_rear_right_xy)*R_arb_rear_right_x_x;
  work.s8_32 = work.w_chassis_x*work.w_chassis_y;
  work.s8_33 = work.w_chassis_y*work.w_chassis_z;
  const double s8_34 = mbgen::fnma(s8_30, work.s8_32, tau[Coordinate::arb_rear_right]);
  const double s8_35 = mbgen::fnma(s8_31, work.s8_33, s8_34);
  const double s8_36 = K_arb_rear_left_xy*R_arb_rear_left_x_x;
  const double s8_37 = K_arb_rear_left_xy*R_arb_rear_left_x_z;
  const double s8_38 = mbgen::fma(s8_37, work.s8_32, tau[Coordinate::arb_rear_left]);
  const double s8_39 = mbgen::fma(s8_36, work.s8_33, s8_38);
  work.s8_40 = mbgen::fnma((-p_bell_crank_z), work.s8_33, p_bell_crank_x*work.s8_32);
  work.s8_41 = work.w_chassis_x*work.w_chassis_z;
  const double s8_42 = work.w_chassis_x*work.w_chassis_x;
  const double s8_43 = work.w_chassis_y*work.w_chassis_y;
  work.s8_44 = s8_43 + s8_42;
  const double s8_45 = (-p_arb_rear_right_z)*work.s8_44;
  const double s8_46 = mbgen::fnma((-p_arb_rear_right_x), work.s8_41, s8_45);
  const double s8_47 = (-p_rear_axle_tx_z)*work.s8_44;
  work.s8_48 = mbgen::fma(p_arb_front_right_x, work.s8_41, s8_47);
  work.s8_49 = mbgen::fma(work.w_chassis_z, work.w_chassis_z, s8_43);
  const double s8_50 = (-p_arb_rear_right_x)*work.s8_49;
  const double s8_51 = mbgen::fnma((-p_arb_rear_right_z), work.s8_41, s8_50);
  work.s8_52 = mbgen::fma(p_bell_crank_x, work.s8_49, (-p_bell_crank_z)*work.s8_41);
  const double s8_53 = mbgen::fnma((-p_pitman_arm_z), work.s8_41, p_pitman_arm_y*work.s8_32);
  work.s8_54 = mbgen::fnma(p_pitman_arm_x, work.s8_49, s8_53);
  const double s8_55 = (-p_rear_axle_tx_z)*work.s8_41;
  work.s8_56 = mbgen::fma(p_arb_front_right_x, work.s8_49, s8_55);
  work.s8_57 = mbgen::fma(work.w_chassis_z, work.w_chassis_z, s8_42);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s8_58 = h_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s8_59 = h_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s8_60 = zd_arb_rear_right*work.s8_28;
  const double s8_61 = zd_arb_rear_right*work.s8_23;
  const double s8_62 = mbgen::fnma(s8_59, s8_60, s8_58*s8_61);
  const double s8_63 = mbgen::fnma((-p_arb_rear_right_y), work.s8_32, s8_51);
  const double s8_64 = mbgen::fnma((-p_arb_rear_right_z), work.s8_33, s8_46);
  const double s8_65 = mbgen::fma(s8_58, s8_64, mbgen::fma(s8_59, s8_63, s8_35));
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s8_66 = h_arb_rear_left_x*R_arb_rear_left_x_x;
  work.s8_67 = s8_66 + s8_58 - 59.4;
  const double s8_68 = h_arb_rear_left_x*R_arb_rear_left_x_z;
  work.s8_69 = 8.1 + (s8_68 + s8_59);
  const double s8_70 = mbgen::fma((-p_arb_rear_right_y), work.s8_32, s8_51);
  const double s8_71 = zd_arb_rear_left*work.s8_28;
  const double s8_72 = zd_arb_rear_left*work.s8_23;
  const double s8_73 = mbgen::fnma(s8_68, s8_71, s8_66*s8_72);
  const double s8_74 = mbgen::fma((-p_arb_rear_right_z), work.s8_33, s8_46);
  const double s8_75 = mbgen::fma(s8_66, s8_74, mbgen::fma(s8_68, s8_70, s8_39));
  const double s8_76 = s8_58 - 14.85;
  const double s8_77 = s8_66 - 14.85;
  const double s8_78 = mbgen::fnma((-p_arb_rear_right_y), s8_76, s7_43 + s7_49);
  const double s8_79 = 2.025 + s8_59;
  const double s8_80 = 2.025 + s8_68;
  const double s8_81 = s8_79 + s8_80;
  const double s8_82 = mbgen::fnma(p_arb_rear_left_y, s8_77, s8_78);
  work.s8_83 = mbgen::fma((-p_arb_rear_left_x), s8_81, s8_82);
  const double s8_84 = mbgen::fma(p_arb_rear_left_y, s8_77, s8_36);
  work.s8_85 = mbgen::fnma((-p_arb_rear_right_y), s8_76, s8_84) - s8_31;
  work.s8_86 = mbgen::fma(p_carrier_left_rz_y, s8_79 - s8_80, s8_30 - s8_37);
  work.s8_87 = mbgen::fma(0.9, s8_81, s7_45 + s7_51);
  work.s8_88 = mbgen::fnma(6.6, s8_76 + s8_77, s7_44 + s7_50);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s8_89 = m_rear_axle_2*work.Rz_rear_axle_tx_0;
  const double s8_90 = mbgen::fma(work.Rz_rear_axle_ry_0, work.s7_14, s8_89);
  const double s8_91 = mbgen::fnma(work.Rz_rear_axle_rx_0, work.s7_11, s8_90);
  const double s8_92 = m_rear_axle_2*work.Rz_rear_axle_tx_1;
  const double s8_93 = mbgen::fma(work.Rz_rear_axle_ry_1, work.s7_14, s8_92);
  const double s8_94 = mbgen::fnma(work.Rz_rear_axle_rx_1, work.s7_11, s8_93);
  const double s8_95 = m_rear_axle_2*work.Rz_rear_axle_tz_1;
  const double s8_96 = mbgen::fnma(work.s3_10, work.s7_11, s8_95);
  const double s8_97 = mbgen::fnma(work.Rz_rear_axle_ry_1, work.s7_13, s8_96);
  const double s8_98 = mbgen::fnma(work.Rz_rear_axle_ry_0, work.s7_13, s8_6);
  const double s8_99 = mbgen::fnma(m_rear_axle_2, work.s3_2, s8_98);
  const double s8_100 = mbgen::fma(work.Rz_rear_axle_rx_1, work.s7_13, work.s3_10*work.s7_14);
  work.s8_101 = mbgen::fnma(m_rear_axle_2, work.s3_14, s8_100);
  const double s8_102 = mbgen::fnma(work.Rz_rear_axle_rz_0, work.s7_14, s8_7);
  const double s8_103 = mbgen::fnma(m_rear_axle_2, work.s3_8, s8_102);
  // arb_link_rear_right
  const double s8_104 = mbgen::fnma(work.s3_2, s8_97, work.Rz_rear_axle_tx_0*s8_94);
  const double s8_105 = mbgen::fnma(work.s3_8, work.s8_101, s8_104);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_106 = mbgen::fma(zd_rear_axle_tz, work.s8_13, work.zdd_star_rear_axle_tx);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_107 = mbgen::fnma(zd_rear_axle_ty, work.s8_28, s8_106);
  const double s8_108 = mbgen::fma(z_rear_axle_ty, work.s8_32, s8_107);
  const double s8_109 = mbgen::fma(work.r_rear_axle_aux3_z, work.s8_41, s8_108);
  const double s8_110 = mbgen::fnma(work.r_rear_axle_aux1_x, work.s8_49, s8_109);
  const double s8_111 = work.zdd_star_rear_axle_rx + work.s4_37;
  const double s8_112 = mbgen::fms(work.w_rear_axle_x, work.w_rear_axle_y, s8_111);
  const double s8_113 = work.zdd_star_rear_axle_ry + work.s4_38;
  const double s8_114 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_z, s8_113);
  const double s8_115 = mbgen::fma(work.s7_11, s8_112, m_rear_axle_2*s8_110);
  const double s8_116 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s8_117 = work.w_rear_axle_z*work.w_rear_axle_z;
  const double s8_118 = s8_116 + s8_117;
  const double f_rear_axle_x = mbgen::fnma(work.s7_13, s8_118, mbgen::fma(work.s7_14, s8_114,
      s8_115));
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s8_119 = mbgen::fms(zd_rear_axle_tx, work.s8_28, work.s6_77);
  const double s8_120 = mbgen::fnma(zd_rear_axle_tz, work.s8_23, s8_119);
  const double s8_121 = mbgen::fma(work.r_rear_axle_aux1_x, work.s8_32, s8_120);
  const double s8_122 = mbgen::fma(work.r_rear_axle_aux3_z, work.s8_33, s8_121);
  const double s8_123 = mbgen::fnma(z_rear_axle_ty, work.s8_57, s8_122);
  const double s8_124 = mbgen::fma(work.s7_13, s8_123, work.s8_3);
  const double s8_125 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_y, s8_111);
  const double s8_126 = work.zdd_star_rear_axle_rz + work.s4_32;
  const double s8_127 = mbgen::fms(work.w_rear_axle_y, work.w_rear_axle_z, s8_126);
  const double s8_128 = mbgen::fma(work.s7_13, s8_125, m_rear_axle_2*s8_123);
  const double s8_129 = mbgen::fma(s7_32, s8_127, mbgen::fnma(work.s7_11, s8_110, s8_124));
  const double s8_130 = mbgen::fnma(s7_36, s8_112, mbgen::fma(s7_38, s8_125, s8_129));
  const double s8_131 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_x, s8_117);
  const double f_rear_axle_y = mbgen::fnma(work.s7_11, s8_131, mbgen::fma(work.s7_14, s8_127,
      s8_128));
  const double s8_132 = mbgen::fma(zd_rear_axle_ty, work.s8_23, work.zdd_star_rear_axle_tz);
  const double s8_133 = mbgen::fnma(zd_rear_axle_tx, work.s8_13, s8_132);
  const double s8_134 = mbgen::fma(z_rear_axle_ty, work.s8_33, s8_133);
  const double s8_135 = mbgen::fma(work.r_rear_axle_aux1_x, work.s8_41, s8_134);
  const double s8_136 = mbgen::fnma(work.r_rear_axle_aux3_z, work.s8_44, s8_135);
  const double s8_137 = mbgen::fma(work.s7_11, s8_136, work.s8_5);
  const double s8_138 = mbgen::fma(work.s7_14, s8_110, work.s8_4);
  const double s8_139 = mbgen::fma(s7_27, s8_112, mbgen::fnma(work.s7_13, s8_136, s8_138));
  const double s8_140 = mbgen::fma(work.w_rear_axle_y, work.w_rear_axle_z, s8_126);
  const double s8_141 = mbgen::fms(work.w_rear_axle_x, work.w_rear_axle_z, s8_113);
  const double s8_142 = mbgen::fma(work.s7_11, s8_140, m_rear_axle_2*s8_136);
  const double s8_143 = mbgen::fma(s7_36, s8_140, mbgen::fnma(work.s7_14, s8_123, s8_137));
  const double s8_144 = mbgen::fnma(s7_32, s8_125, mbgen::fma(s7_34, s8_141, s8_143));
  const double s8_145 = mbgen::fnma(s7_34, s8_140, mbgen::fma(s7_39, s8_114, s8_139));
  const double s8_146 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_x, s8_116);
  const double f_rear_axle_z = mbgen::fnma(work.s7_14, s8_146, mbgen::fma(work.s7_13, s8_141,
      s8_142));
  const double n_rear_axle_x = mbgen::fma(s7_27, s8_131 - s8_146, mbgen::fnma(s7_39, s8_127,
      s8_144));
  const double n_rear_axle_y = mbgen::fma(s7_32, s8_146 - s8_118, mbgen::fnma(s7_38, s8_141,
      s8_145));
  const double s8_147 = work.s5_48 - n_rear_axle_y;
  const double n_rear_axle_z = mbgen::fma(s7_34, s8_118 - s8_131, mbgen::fnma(s7_27, s8_114,
      s8_130));
  const double s8_148 = s7_40 - s7_38;
  const double s8_149 = mbgen::fnma(work.Rz_rear_axle_rx_1, s7_32, s8_10);
  const double s8_150 = mbgen::fnma(work.s3_10, s8_148, s8_149);
  const double s8_151 = mbgen::fnma(work.s3_2, work.s7_11, work.s3_8*work.s7_14);
  const double s8_152 = mbgen::fma(work.Rz_rear_axle_rz_0, s8_148, s8_151);
  const double s8_153 = mbgen::fnma(work.Rz_rear_axle_rx_0, s7_32, s8_152);
  const double s8_154 = mbgen::fnma(work.Rz_rear_axle_ry_0, s7_34, s8_153);
  const double s8_155 = mbgen::fma(593.0, work.r_rear_axle_aux3_z, work.s7_14);
  const double s8_156 = s7_40 - s7_36;
  const double s8_157 = mbgen::fnma(work.Rz_rear_axle_rx_1, s7_27, s8_12);
  const double s8_158 = mbgen::fma(work.Rz_rear_axle_ry_1, s8_156, s8_157);
  const double s8_159 = mbgen::fma(work.Rz_rear_axle_tx_0, work.s7_14, work.s3_2*work.s7_13);
  const double s8_160 = mbgen::fma(work.Rz_rear_axle_ry_0, s8_156, s8_159);
  const double s8_161 = mbgen::fnma(work.Rz_rear_axle_rz_0, s7_34, s8_160);
  const double s8_162 = mbgen::fnma(work.Rz_rear_axle_rx_0, s7_27, s8_161);
  const double s8_163 = mbgen::fma(work.Rz_rear_axle_ry_0, s8_158, s8_105);
  const double s8_164 = s7_40 - s7_39;
  const double s8_165 = work.Rz_rear_axle_rx_0*s8_164;
  const double s8_166 = mbgen::fnma(work.Rz_rear_axle_rz_0, s7_32, s8_165);
  const double s8_167 = mbgen::fnma(work.Rz_rear_axle_ry_0, s7_27, s8_166);
  const double s8_168 = mbgen::fnma(work.s3_8, work.s7_13, s8_167);
  const double s8_169 = mbgen::fnma(work.Rz_rear_axle_tx_0, work.s7_11, s8_168);
  const double s8_170 = mbgen::fma(work.Rz_rear_axle_rx_1, s8_164, work.s3_10*s7_32);
  const double s8_171 = mbgen::fnma(work.Rz_rear_axle_ry_1, s7_27, s8_170);
  const double s8_172 = mbgen::fnma(work.s3_14, work.s7_13, s8_171);
  const double s8_173 = mbgen::fnma(work.Rz_rear_axle_tx_1, work.s7_11, s8_172);
  const double s8_174 = mbgen::fma(work.Rz_rear_axle_rz_0, s8_150, s8_163);
  const double s8_175 = mbgen::fma(work.Rz_rear_axle_rx_0, s8_173, s8_174);
  // long_rod_left
  const double s8_176 = mbgen::fma(work.s2_7, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_177 = mbgen::fnma(work.s2_12, work.Rz_rear_axle_rx_0, s8_176);
  const double s8_178 = mbgen::fma(work.s2_7, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_179 = mbgen::fnma(work.s2_12, work.Rz_rear_axle_rx_1, s8_178);
  const double s8_180 = mbgen::fnma(work.s2_12, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_181 = mbgen::fnma(work.s2_9, work.Rz_rear_axle_ry_1, s8_180);
  const double s8_182 = mbgen::fms(work.s2_7, work.s3_10, work.s3_14);
  const double s8_183 = mbgen::fma(work.s2_9, work.Rz_rear_axle_rx_1, s8_182);
  const double s8_184 = mbgen::fma(s8_181, s8_181, mbgen::fma(s8_179, s8_179, s8_183*s8_183));
  const double s8_185 = mbgen::fms(work.s2_12, work.Rz_rear_axle_rz_0, work.s3_2);
  const double s8_186 = mbgen::fnma(work.s2_9, work.Rz_rear_axle_ry_0, s8_185);
  const double s8_187 = mbgen::fms(work.s2_9, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_188 = mbgen::fnma(work.s2_7, work.Rz_rear_axle_rz_0, s8_187);
  const double s8_189 = mbgen::fma(s8_186, s8_186, mbgen::fma(s8_177, s8_177, s8_188*s8_188));
  const double s8_190 = mbgen::fma(s8_181, s8_186, mbgen::fma(s8_177, s8_179, s8_183*s8_188));
  const double s8_191 = mbgen::fms(work.s2_13, work.s8_32, work.s2_17);
  const double s8_192 = mbgen::fma(work.s2_11, work.s8_49, s8_191 - work.zdd_star_rear_axle_tx);
  const double s8_193 = mbgen::fnma(work.s2_8, work.s8_41, s8_192);
  const double s8_194 = mbgen::fma(work.s6_2, work.s8_28, s8_193);
  const double s8_195 = mbgen::fnma(work.s6_3, work.s8_13, s8_194);
  const double s8_196 = mbgen::fnma(work.s2_7, work.zdd_star_rear_axle_ry, s8_195);
  const double s8_197 = 3.0*mbgen::fma(work.s2_12, work.zdd_star_rear_axle_rx, s8_196);
  const double s8_198 = mbgen::fms(work.s2_13, work.s8_33, work.s2_19);
  const double s8_199 = mbgen::fma(work.s2_8, work.s8_44, s8_198 - work.zdd_star_rear_axle_tz);
  const double s8_200 = mbgen::fnma(work.s2_11, work.s8_41, s8_199);
  const double s8_201 = mbgen::fma(work.s6_1, work.s8_13, s8_200);
  const double s8_202 = mbgen::fnma(work.s6_2, work.s8_23, s8_201);
  const double s8_203 = mbgen::fnma(work.s2_12, work.zdd_star_rear_axle_rz, s8_202);
  const double s8_204 = 3.0*mbgen::fma(work.s2_9, work.zdd_star_rear_axle_ry, s8_203);
  const double s8_205 = mbgen::fma(work.s6_3, work.s8_23, work.s6_77 - work.s2_18);
  const double s8_206 = mbgen::fnma(work.s6_1, work.s8_28, s8_205);
  const double s8_207 = mbgen::fnma(work.s2_9, work.zdd_star_rear_axle_rx, s8_206);
  const double s8_208 = mbgen::fma(work.s2_7, work.zdd_star_rear_axle_rz, s8_207);
  const double s8_209 = mbgen::fnma(work.s2_13, work.s8_57, s8_208);
  const double s8_210 = mbgen::fnma(work.s2_8, work.s8_33, s8_209);
  const double s8_211 = 3.0*mbgen::fnma(work.s2_11, work.s8_32, s8_210);
  const double s8_212 = mbgen::fnma(s8_179, s8_197, mbgen::fnma(s8_183, s8_211, s8_65));
  const double s8_213 = mbgen::fnma(s8_181, s8_204, s8_212);
  const double s8_214 = mbgen::fnma(s8_177, s8_197, mbgen::fnma(s8_188, s8_211, s8_75));
  const double s8_215 = mbgen::fnma(s8_186, s8_204, s8_214);
  // diag_rod_left
  const double s8_216 = mbgen::fma(work.s2_21, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_217 = mbgen::fnma(work.s2_28, work.Rz_rear_axle_rx_0, s8_216);
  const double s8_218 = mbgen::fma(work.s2_21, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_219 = mbgen::fnma(work.s2_28, work.Rz_rear_axle_rx_1, s8_218);
  const double s8_220 = mbgen::fnma(work.s2_28, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_221 = mbgen::fnma(work.s2_24, work.Rz_rear_axle_ry_1, s8_220);
  const double s8_222 = mbgen::fms(work.s2_21, work.s3_10, work.s3_14);
  const double s8_223 = mbgen::fma(work.s2_24, work.Rz_rear_axle_rx_1, s8_222);
  const double s8_224 = mbgen::fma(s8_221, s8_221, mbgen::fma(s8_219, s8_219, s8_223*s8_223));
  const double s8_225 = mbgen::fms(work.s2_24, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_226 = mbgen::fnma(work.s2_21, work.Rz_rear_axle_rz_0, s8_225);
  const double s8_227 = mbgen::fms(work.s2_28, work.Rz_rear_axle_rz_0, work.s3_2);
  const double s8_228 = mbgen::fnma(work.s2_24, work.Rz_rear_axle_ry_0, s8_227);
  const double s8_229 = mbgen::fma(s8_228, s8_228, mbgen::fma(s8_217, s8_217, s8_226*s8_226));
  const double s8_230 = mbgen::fma(s8_221, s8_228, mbgen::fma(s8_217, s8_219, s8_223*s8_226));
  const double s8_231 = mbgen::fms(work.s2_29, work.s8_32, work.s2_33);
  const double s8_232 = mbgen::fma(work.s2_26, work.s8_49, s8_231 - work.zdd_star_rear_axle_tx);
  const double s8_233 = mbgen::fnma(work.s2_22, work.s8_41, s8_232);
  const double s8_234 = mbgen::fma(work.s6_5, work.s8_28, s8_233);
  const double s8_235 = mbgen::fnma(work.s6_6, work.s8_13, s8_234);
  const double s8_236 = mbgen::fnma(work.s2_21, work.zdd_star_rear_axle_ry, s8_235);
  const double s8_237 = mbgen::fma(work.s2_28, work.zdd_star_rear_axle_rx, s8_236);
  const double s8_238 = 2.6666666666666665*s8_237;
  const double s8_239 = mbgen::fms(work.s2_29, work.s8_33, work.s2_35);
  const double s8_240 = mbgen::fma(work.s2_22, work.s8_44, s8_239 - work.zdd_star_rear_axle_tz);
  const double s8_241 = mbgen::fnma(work.s2_26, work.s8_41, s8_240);
  const double s8_242 = mbgen::fma(work.s6_4, work.s8_13, s8_241);
  const double s8_243 = mbgen::fnma(work.s6_5, work.s8_23, s8_242);
  const double s8_244 = mbgen::fnma(work.s2_28, work.zdd_star_rear_axle_rz, s8_243);
  const double s8_245 = mbgen::fma(work.s2_24, work.zdd_star_rear_axle_ry, s8_244);
  const double s8_246 = 2.6666666666666665*s8_245;
  const double s8_247 = mbgen::fma(work.s6_6, work.s8_23, work.s6_77 - work.s2_34);
  const double s8_248 = mbgen::fnma(work.s6_4, work.s8_28, s8_247);
  const double s8_249 = mbgen::fnma(work.s2_24, work.zdd_star_rear_axle_rx, s8_248);
  const double s8_250 = mbgen::fma(work.s2_21, work.zdd_star_rear_axle_rz, s8_249);
  const double s8_251 = mbgen::fnma(work.s2_29, work.s8_57, s8_250);
  const double s8_252 = mbgen::fnma(work.s2_22, work.s8_33, s8_251);
  const double s8_253 = 2.6666666666666665*mbgen::fnma(work.s2_26, work.s8_32, s8_252);
  const double s8_254 = mbgen::fnma(s8_219, s8_238, mbgen::fnma(s8_223, s8_253, s8_213));
  const double s8_255 = mbgen::fnma(s8_221, s8_246, s8_254);
  const double s8_256 = mbgen::fnma(s8_217, s8_238, mbgen::fnma(s8_226, s8_253, s8_215));
  const double s8_257 = mbgen::fnma(s8_228, s8_246, s8_256);
  // arb_link_rear_left
  const double s8_258 = mbgen::fma(work.s2_43, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_259 = mbgen::fnma(work.s2_46, work.Rz_rear_axle_rx_1, s8_258);
  const double s8_260 = mbgen::fnma(work.s2_46, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_261 = mbgen::fnma(work.s2_50, work.Rz_rear_axle_ry_1, s8_260);
  const double s8_262 = mbgen::fms(work.s2_43, work.s3_10, work.s3_14);
  const double s8_263 = mbgen::fma(work.s2_50, work.Rz_rear_axle_rx_1, s8_262);
  const double s8_264 = mbgen::fma(s8_261, s8_261, mbgen::fma(s8_259, s8_259, s8_263*s8_263));
  const double s8_265 = mbgen::fms(work.s2_50, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_266 = mbgen::fnma(work.s2_43, work.Rz_rear_axle_rz_0, s8_265);
  const double s8_267 = work.s2_42 + work.Rz_rear_axle_tx_0;
  const double s8_268 = mbgen::fma(work.s2_43, work.Rz_rear_axle_ry_0, s8_267);
  const double s8_269 = mbgen::fnma(work.s2_46, work.Rz_rear_axle_rx_0, s8_268);
  const double s8_270 = mbgen::fma(work.s2_46, work.Rz_rear_axle_rz_0, work.s2_54 - work.s3_2);
  const double s8_271 = mbgen::fnma(work.s2_50, work.Rz_rear_axle_ry_0, s8_270);
  const double s8_272 = mbgen::fma(s8_271, s8_271, mbgen::fma(s8_269, s8_269, s8_266*s8_266));
  const double s8_273 = mbgen::fma(s8_261, s8_271, mbgen::fma(s8_259, s8_269, s8_263*s8_266));
  const double s8_274 = work.s6_9 - work.zdd_star_rear_axle_tz;
  const double s8_275 = mbgen::fma(work.s2_48, work.s8_33, s8_274);
  const double s8_276 = mbgen::fma(work.s2_45, work.s8_44, s8_275);
  const double s8_277 = mbgen::fma(work.s2_55, work.s8_41, s8_276);
  const double s8_278 = mbgen::fma(work.s6_14, work.s8_13, s8_277);
  const double s8_279 = mbgen::fnma(work.s6_13, work.s8_23, s8_278);
  const double s8_280 = mbgen::fnma(work.s2_46, work.zdd_star_rear_axle_rz, s8_279);
  const double s8_281 = mbgen::fma(work.s2_50, work.zdd_star_rear_axle_ry, s8_280);
  const double s8_282 = 0.3333333333333333*s8_281;
  const double s8_283 = mbgen::fms(work.s2_48, work.s8_32, work.s6_12);
  const double s8_284 = mbgen::fnma(work.s2_45, work.s8_41, s8_283 - work.zdd_star_rear_axle_tx);
  const double s8_285 = mbgen::fnma(work.s2_55, work.s8_49, s8_284);
  const double s8_286 = mbgen::fma(work.s6_13, work.s8_28, s8_285);
  const double s8_287 = mbgen::fnma(work.s6_15, work.s8_13, s8_286);
  const double s8_288 = mbgen::fnma(work.s2_43, work.zdd_star_rear_axle_ry, s8_287);
  const double s8_289 = mbgen::fma(work.s2_46, work.zdd_star_rear_axle_rx, s8_288);
  const double s8_290 = 0.3333333333333333*s8_289;
  const double s8_291 = mbgen::fma(work.s2_55, work.s8_32, work.s6_77 - work.s2_53);
  const double s8_292 = mbgen::fnma(work.s2_45, work.s8_33, s8_291);
  const double s8_293 = mbgen::fnma(work.s2_48, work.s8_57, s8_292);
  const double s8_294 = mbgen::fma(work.s6_15, work.s8_23, s8_293);
  const double s8_295 = mbgen::fnma(work.s6_14, work.s8_28, s8_294);
  const double s8_296 = mbgen::fnma(work.s2_50, work.zdd_star_rear_axle_rx, s8_295);
  const double s8_297 = mbgen::fma(work.s2_43, work.zdd_star_rear_axle_rz, s8_296);
  const double s8_298 = 0.3333333333333333*s8_297;
  const double s8_299 = mbgen::fnma(s8_259, s8_290, mbgen::fnma(s8_263, s8_298, s8_255));
  const double s8_300 = mbgen::fnma(s8_261, s8_282, s8_299);
  const double s8_301 = mbgen::fnma(s8_269, s8_290, mbgen::fnma(s8_266, s8_298, s8_257));
  const double s8_302 = mbgen::fnma(s8_271, s8_282, s8_301);
  // long_rod_right
  const double s8_303 = mbgen::fnma(work.s2_58, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_304 = mbgen::fnma(work.s2_63, work.Rz_rear_axle_ry_1, s8_303);
  const double s8_305 = mbgen::fnma(work.s2_57, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_306 = mbgen::fnma(work.s2_58, work.Rz_rear_axle_rx_0, s8_305);
  const double s8_307 = mbgen::fnma(work.s2_57, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_308 = mbgen::fnma(work.s2_58, work.Rz_rear_axle_rx_1, s8_307);
  const double s8_309 = mbgen::fms(work.s2_57, work.Rz_rear_axle_rz_0, work.s3_8);
  const double s8_310 = mbgen::fma(work.s2_63, work.Rz_rear_axle_rx_0, s8_309);
  const double s8_311 = mbgen::fms(work.s2_58, work.Rz_rear_axle_rz_0, work.s3_2);
  const double s8_312 = mbgen::fnma(work.s2_63, work.Rz_rear_axle_ry_0, s8_311);
  const double s8_313 = mbgen::fma(s8_306, s8_306, mbgen::fma(s8_310, s8_310, s8_189));
  const double s8_314 = mbgen::fma(s8_312, s8_312, s8_313);
  const double s8_315 = mbgen::fms(work.s2_63, work.Rz_rear_axle_rx_1, work.s3_14);
  const double s8_316 = mbgen::fnma(work.s2_57, work.s3_10, s8_315);
  const double s8_317 = mbgen::fma(s8_304, s8_304, mbgen::fma(s8_316, s8_316, s8_184));
  const double s8_318 = mbgen::fma(s8_308, s8_308, s8_317);
  const double s8_319 = mbgen::fma(s8_304, s8_312, mbgen::fma(s8_310, s8_316, s8_190));
  const double s8_320 = mbgen::fnma(3.0, mbgen::fma(s8_306, s8_308, s8_319), s8_175);
  const double s8_321 = mbgen::fma(work.s2_60, work.s8_57, work.s2_67 + work.s6_77);
  const double s8_322 = mbgen::fnma(work.s2_61, work.s8_33, s8_321);
  const double s8_323 = mbgen::fnma(work.s2_69, work.s8_32, s8_322);
  const double s8_324 = mbgen::fma(work.s6_17, work.s8_23, s8_323);
  const double s8_325 = mbgen::fnma(work.s6_18, work.s8_28, s8_324);
  const double s8_326 = mbgen::fnma(work.s2_57, work.zdd_star_rear_axle_rz, s8_325);
  const double s8_327 = 3.0*mbgen::fnma(work.s2_63, work.zdd_star_rear_axle_rx, s8_326);
  const double s8_328 = mbgen::fms(work.s2_61, work.s8_44, work.s2_66);
  const double s8_329 = mbgen::fnma(work.s2_69, work.s8_41, s8_328 - work.zdd_star_rear_axle_tz);
  const double s8_330 = mbgen::fnma(work.s2_60, work.s8_33, s8_329);
  const double s8_331 = mbgen::fma(work.s6_18, work.s8_13, s8_330);
  const double s8_332 = mbgen::fnma(work.s6_16, work.s8_23, s8_331);
  const double s8_333 = mbgen::fnma(work.s2_58, work.zdd_star_rear_axle_rz, s8_332);
  const double s8_334 = 3.0*mbgen::fma(work.s2_63, work.zdd_star_rear_axle_ry, s8_333);
  const double s8_335 = mbgen::fms(work.s2_69, work.s8_49, work.s2_68);
  const double s8_336 = mbgen::fnma(work.s2_61, work.s8_41, s8_335 - work.zdd_star_rear_axle_tx);
  const double s8_337 = mbgen::fnma(work.s2_60, work.s8_32, s8_336);
  const double s8_338 = mbgen::fma(work.s6_16, work.s8_28, s8_337);
  const double s8_339 = mbgen::fnma(work.s6_17, work.s8_13, s8_338);
  const double s8_340 = mbgen::fma(work.s2_57, work.zdd_star_rear_axle_ry, s8_339);
  const double s8_341 = 3.0*mbgen::fma(work.s2_58, work.zdd_star_rear_axle_rx, s8_340);
  const double s8_342 = mbgen::fnma(s8_304, s8_334, mbgen::fnma(s8_316, s8_327, s8_300));
  const double s8_343 = mbgen::fnma(s8_308, s8_341, s8_342);
  const double s8_344 = mbgen::fnma(s8_306, s8_341, mbgen::fnma(s8_310, s8_327, s8_302));
  const double s8_345 = mbgen::fnma(s8_312, s8_334, s8_344);
  // diag_rod_right
  const double s8_346 = mbgen::fma(work.s2_71, work.Rz_rear_axle_ry_0, work.Rz_rear_axle_tx_0);
  const double s8_347 = mbgen::fnma(work.s2_75, work.Rz_rear_axle_rx_0, s8_346);
  const double s8_348 = mbgen::fma(work.s2_71, work.Rz_rear_axle_ry_1, work.Rz_rear_axle_tx_1);
  const double s8_349 = mbgen::fnma(work.s2_75, work.Rz_rear_axle_rx_1, s8_348);
  const double s8_350 = mbgen::fnma(work.s2_75, work.s3_10, work.Rz_rear_axle_tz_1);
  const double s8_351 = mbgen::fnma(work.s2_70, work.Rz_rear_axle_ry_1, s8_350);
  const double s8_352 = mbgen::fms(work.s2_71, work.s3_10, work.s3_14);
  const double s8_353 = mbgen::fma(work.s2_70, work.Rz_rear_axle_rx_1, s8_352);
  const double s8_354 = mbgen::fma(s8_349, s8_349, mbgen::fma(s8_353, s8_353, s8_224));
  const double s8_355 = mbgen::fma(s8_351, s8_351, s8_354);
  const double s8_356 = mbgen::fms(work.s2_70, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_357 = mbgen::fnma(work.s2_71, work.Rz_rear_axle_rz_0, s8_356);
  const double s8_358 = mbgen::fms(work.s2_75, work.Rz_rear_axle_rz_0, work.s3_2);
  const double s8_359 = mbgen::fnma(work.s2_70, work.Rz_rear_axle_ry_0, s8_358);
  const double s8_360 = mbgen::fma(s8_347, s8_347, mbgen::fma(s8_357, s8_357, s8_229));
  const double s8_361 = mbgen::fma(s8_359, s8_359, s8_360);
  const double s8_362 = mbgen::fma(s8_347, s8_349, mbgen::fma(s8_353, s8_357, s8_230));
  const double s8_363 = mbgen::fma(s8_351, s8_359, s8_362);
  const double s8_364 = mbgen::fnma(2.6666666666666665, s8_363, s8_320);
  const double s8_365 = mbgen::fma(work.s2_81, work.s8_57, work.s6_77 - work.s2_79);
  const double s8_366 = mbgen::fnma(work.s2_73, work.s8_33, s8_365);
  const double s8_367 = mbgen::fnma(work.pivot_rear_axle_tx, work.s8_32, s8_366);
  const double s8_368 = mbgen::fma(work.s6_21, work.s8_23, s8_367);
  const double s8_369 = mbgen::fnma(work.s6_19, work.s8_28, s8_368);
  const double s8_370 = mbgen::fnma(work.s2_70, work.zdd_star_rear_axle_rx, s8_369);
  const double s8_371 = mbgen::fma(work.s2_71, work.zdd_star_rear_axle_rz, s8_370);
  const double s8_372 = 2.6666666666666665*s8_371;
  const double s8_373 = mbgen::fms(work.s2_73, work.s8_44, work.s2_80);
  const double s8_374 = s8_373 - work.zdd_star_rear_axle_tz;
  const double s8_375 = mbgen::fnma(work.pivot_rear_axle_tx, work.s8_41, s8_374);
  const double s8_376 = mbgen::fnma(work.s2_81, work.s8_33, s8_375);
  const double s8_377 = mbgen::fma(work.s6_19, work.s8_13, s8_376);
  const double s8_378 = mbgen::fnma(work.s6_20, work.s8_23, s8_377);
  const double s8_379 = mbgen::fnma(work.s2_75, work.zdd_star_rear_axle_rz, s8_378);
  const double s8_380 = mbgen::fma(work.s2_70, work.zdd_star_rear_axle_ry, s8_379);
  const double s8_381 = 2.6666666666666665*s8_380;
  const double s8_382 = mbgen::fms(work.pivot_rear_axle_tx, work.s8_49, work.s2_78);
  const double s8_383 = mbgen::fnma(work.s2_73, work.s8_41, s8_382 - work.zdd_star_rear_axle_tx);
  const double s8_384 = mbgen::fnma(work.s2_81, work.s8_32, s8_383);
  const double s8_385 = mbgen::fma(work.s6_20, work.s8_28, s8_384);
  const double s8_386 = mbgen::fnma(work.s6_21, work.s8_13, s8_385);
  const double s8_387 = mbgen::fnma(work.s2_71, work.zdd_star_rear_axle_ry, s8_386);
  const double s8_388 = mbgen::fma(work.s2_75, work.zdd_star_rear_axle_rx, s8_387);
  const double s8_389 = 2.6666666666666665*s8_388;
  const double s8_390 = mbgen::fnma(s8_349, s8_389, mbgen::fnma(s8_353, s8_372, s8_343));
  const double s8_391 = mbgen::fnma(s8_351, s8_381, s8_390);
  const double s8_392 = mbgen::fnma(s8_347, s8_389, mbgen::fnma(s8_357, s8_372, s8_345));
  const double s8_393 = mbgen::fnma(s8_359, s8_381, s8_392);
  // arb_link_rear_right
  const double s8_394 = mbgen::fms(work.s2_88, work.s3_10, work.s3_14);
  const double s8_395 = mbgen::fnma(work.s2_85, work.Rz_rear_axle_rx_1, s8_394);
  const double s8_396 = work.s2_92 + work.Rz_rear_axle_tx_1;
  const double s8_397 = mbgen::fma(work.s2_84, work.Rz_rear_axle_rx_1, s8_396);
  const double s8_398 = mbgen::fma(work.s2_88, work.Rz_rear_axle_ry_1, s8_397);
  const double s8_399 = mbgen::fma(work.s2_84, work.s3_10, work.s2_95 + work.Rz_rear_axle_tz_1);
  const double s8_400 = mbgen::fma(work.s2_85, work.Rz_rear_axle_ry_1, s8_399);
  const double s8_401 = mbgen::fma(s8_398, s8_398, mbgen::fma(s8_395, s8_395, s8_264));
  const double s8_402 = mbgen::fma(work.Rz_rear_axle_tz_1, s8_97, s7_52);
  const double s8_403 = mbgen::fma(work.Rz_rear_axle_tx_1, s8_94, s8_402);
  const double s8_404 = mbgen::fnma(work.s3_14, work.s8_101, s8_403);
  const double s8_405 = mbgen::fma(work.Rz_rear_axle_ry_1, s8_158, s8_404);
  const double s8_406 = mbgen::fma(work.Rz_rear_axle_rx_1, s8_173, s8_405);
  const double s8_407 = mbgen::fnma(3.0, s8_318, mbgen::fnma(work.s3_10, s8_150, s8_406));
  const double s8_408 = mbgen::fnma(2.6666666666666665, s8_355, s8_407);
  const double s8_409 = mbgen::fma(s8_400, s8_400, s8_401);
  const double pivot_arb_rear_right = mbgen::fnma(0.3333333333333333, s8_409, s8_408);
  const double s8_410 = mbgen::fma(593.0, work.r_rear_axle_aux1_x, work.s7_13);
  const double s8_411 = mbgen::fma(work.r_rear_axle_aux1_x, s8_155, s7_32);
  const double s8_412 = 3.0*work.s2_11;
  const double s8_413 = mbgen::fma(work.r_rear_axle_aux3_z, s8_410, s8_411);
  const double s8_414 = 2.6666666666666665*work.s2_26;
  const double s8_415 = 0.3333333333333333*work.s2_55;
  const double s8_416 = mbgen::fnma(work.s2_22, s8_414, mbgen::fnma(work.s2_8, s8_412, s8_413));
  const double s8_417 = 3.0*work.s2_69;
  const double s8_418 = 2.6666666666666665*work.pivot_rear_axle_tx;
  const double s8_419 = mbgen::fnma(work.s2_61, s8_417, mbgen::fma(work.s2_45, s8_415, s8_416));
  const double s8_420 = 0.3333333333333333*work.s2_97;
  work.s8_421 = mbgen::fma(work.s2_94, s8_420, mbgen::fnma(work.s2_73, s8_418, s8_419));
  const double s8_422 = mbgen::fma(593.0, z_rear_axle_ty, work.s7_11);
  const double s8_423 = mbgen::fma(z_rear_axle_ty, s8_410, s7_34);
  const double s8_424 = mbgen::fma(work.r_rear_axle_aux1_x, s8_422, s8_423);
  const double s8_425 = mbgen::fma(work.s2_29, s8_414, mbgen::fma(work.s2_13, s8_412, s8_424));
  const double s8_426 = mbgen::fnma(work.s2_60, s8_417, mbgen::fnma(work.s2_48, s8_415, s8_425));
  work.s8_427 = mbgen::fma(work.s2_87, s8_420, mbgen::fnma(work.s2_81, s8_418, s8_426));
  const double s8_428 = mbgen::fma(z_rear_axle_ty, s8_155, s7_27);
  const double s8_429 = 3.0*work.s2_13;
  const double s8_430 = mbgen::fma(work.r_rear_axle_aux3_z, s8_422, s8_428);
  const double s8_431 = 2.6666666666666665*work.s2_29;
  const double s8_432 = 0.3333333333333333*work.s2_48;
  const double s8_433 = mbgen::fma(work.s2_22, s8_431, mbgen::fma(work.s2_8, s8_429, s8_430));
  const double s8_434 = 3.0*work.s2_60;
  const double s8_435 = 2.6666666666666665*work.s2_81;
  const double s8_436 = mbgen::fnma(work.s2_61, s8_434, mbgen::fma(work.s2_45, s8_432, s8_433));
  const double s8_437 = 0.3333333333333333*work.s2_87;
  work.s8_438 = mbgen::fnma(work.s2_94, s8_437, mbgen::fnma(work.s2_73, s8_435, s8_436));
  const double s8_439 = mbgen::fma(work.s2_85, work.Rz_rear_axle_rx_0, work.s3_8);
  const double s8_440 = mbgen::fma(work.s2_88, work.Rz_rear_axle_rz_0, s8_439);
  const double s8_441 = mbgen::fma(work.s2_84, work.Rz_rear_axle_rx_0, work.Rz_rear_axle_tx_0);
  const double s8_442 = mbgen::fma(work.s2_88, work.Rz_rear_axle_ry_0, s8_441);
  const double s8_443 = mbgen::fms(work.s2_85, work.Rz_rear_axle_ry_0, work.s3_2);
  const double s8_444 = mbgen::fnma(work.s2_84, work.Rz_rear_axle_rz_0, s8_443);
  const double s8_445 = mbgen::fma(s8_442, s8_442, mbgen::fma(s8_440, s8_440, s8_272));
  const double s8_446 = mbgen::fma(s8_400, s8_444, mbgen::fma(s8_398, s8_442, s8_273));
  const double s8_447 = mbgen::fnma(s8_395, s8_440, s8_446);
  work.s8_448 = mbgen::fnma(0.3333333333333333, s8_447, s8_364);
  const double s8_449 = work.r_rear_axle_aux3_z + work.r_rear_axle_aux3_z;
  const double s8_450 = 3.0*work.s2_8;
  const double s8_451 = 2.6666666666666665*work.s2_22;
  const double s8_452 = mbgen::fnma(work.s2_8, s8_450, mbgen::fma(s8_155, s8_449, s7_39));
  const double s8_453 = 0.3333333333333333*work.s2_45;
  const double s8_454 = 3.0*work.s2_61;
  const double s8_455 = mbgen::fnma(work.s2_45, s8_453, mbgen::fnma(work.s2_22, s8_451, s8_452));
  const double s8_456 = 2.6666666666666665*work.s2_73;
  const double s8_457 = 0.3333333333333333*work.s2_94;
  const double s8_458 = mbgen::fnma(work.s2_73, s8_456, mbgen::fnma(work.s2_61, s8_454, s8_455));
  work.s8_459 = mbgen::fnma(work.s2_94, s8_457, s8_458);
  const double s8_460 = mbgen::fma(s8_422, z_rear_axle_ty + z_rear_axle_ty, s7_36);
  const double s8_461 = mbgen::fnma(work.s2_29, s8_431, mbgen::fnma(work.s2_13, s8_429, s8_460));
  const double s8_462 = mbgen::fnma(work.s2_60, s8_434, mbgen::fnma(work.s2_48, s8_432, s8_461));
  work.s8_463 = mbgen::fnma(work.s2_87, s8_437, mbgen::fnma(work.s2_81, s8_435, s8_462));
  const double s8_464 = work.r_rear_axle_aux1_x + work.r_rear_axle_aux1_x;
  const double s8_465 = mbgen::fnma(work.s2_11, s8_412, mbgen::fma(s8_410, s8_464, s7_38));
  const double s8_466 = mbgen::fnma(work.s2_55, s8_415, mbgen::fnma(work.s2_26, s8_414, s8_465));
  const double s8_467 = mbgen::fnma(work.s2_69, s8_417, s8_466);
  const double s8_468 = mbgen::fnma(work.pivot_rear_axle_tx, s8_418, s8_467);
  work.s8_469 = mbgen::fnma(work.s2_97, s8_420, s8_468);
  const double s8_470 = mbgen::fma((-p_arb_rear_right_y), s8_58, s8_31 + s8_150);
  const double s8_471 = mbgen::fma(z_rear_axle_ty, s8_97, s8_470);
  const double s8_472 = mbgen::fnma(work.r_rear_axle_aux3_z, work.s8_101, s8_471);
  const double s8_473 = mbgen::fma(s8_429, s8_181, mbgen::fma(s8_183, s8_450, s8_472));
  const double s8_474 = mbgen::fma(s8_431, s8_221, mbgen::fma(s8_223, s8_451, s8_473));
  const double s8_475 = mbgen::fma(s8_432, s8_261, mbgen::fma(s8_263, s8_453, s8_474));
  const double s8_476 = mbgen::fnma(s8_434, s8_304, mbgen::fma(s8_454, s8_316, s8_475));
  const double s8_477 = mbgen::fnma(s8_435, s8_351, mbgen::fma(s8_456, s8_353, s8_476));
  work.s8_478 = mbgen::fnma(s8_400, s8_437, mbgen::fma(s8_395, s8_457, s8_477));
  const double s8_479 = mbgen::fnma((-p_arb_rear_right_z), s8_59, s8_173 - s8_30);
  const double s8_480 = mbgen::fma(work.r_rear_axle_aux1_x, work.s8_101, s8_479);
  const double s8_481 = mbgen::fnma(s8_412, s8_183, mbgen::fnma(z_rear_axle_ty, s8_94, s8_480));
  const double s8_482 = mbgen::fnma(s8_414, s8_223, mbgen::fnma(s8_429, s8_179, s8_481));
  const double s8_483 = mbgen::fma(s8_415, s8_263, mbgen::fnma(s8_431, s8_219, s8_482));
  const double s8_484 = mbgen::fma(s8_434, s8_308, mbgen::fnma(s8_432, s8_259, s8_483));
  const double s8_485 = mbgen::fma(s8_435, s8_349, mbgen::fnma(s8_417, s8_316, s8_484));
  const double s8_486 = mbgen::fma(s8_398, s8_437, mbgen::fnma(s8_418, s8_353, s8_485));
  work.s8_487 = mbgen::fma(s8_395, s8_420, s8_486);
  const double s8_488 = s7_52 + mbgen::fma((-p_arb_rear_right_z), s8_59, s8_158);
  const double s8_489 = mbgen::fnma((-p_arb_rear_right_x), s8_58, s8_488);
  const double s8_490 = mbgen::fma(work.r_rear_axle_aux3_z, s8_94, s8_489);
  const double s8_491 = mbgen::fnma(work.r_rear_axle_aux1_x, s8_97, s8_490);
  const double s8_492 = mbgen::fnma(s8_179, s8_450, mbgen::fma(s8_412, s8_181, s8_491));
  const double s8_493 = mbgen::fnma(s8_219, s8_451, mbgen::fma(s8_414, s8_221, s8_492));
  const double s8_494 = mbgen::fnma(s8_415, s8_261, mbgen::fnma(s8_259, s8_453, s8_493));
  const double s8_495 = mbgen::fnma(s8_454, s8_308, mbgen::fma(s8_417, s8_304, s8_494));
  const double s8_496 = mbgen::fnma(s8_456, s8_349, mbgen::fma(s8_418, s8_351, s8_495));
  work.s8_497 = mbgen::fnma(s8_400, s8_420, mbgen::fnma(s8_398, s8_457, s8_496));
  const double s8_498 = mbgen::fma(work.Rz_rear_axle_tx_0, s8_91, s7_46);
  const double s8_499 = mbgen::fnma(work.s3_8, s8_103, mbgen::fnma(work.s3_2, s8_99, s8_498));
  const double s8_500 = mbgen::fma(work.Rz_rear_axle_ry_0, s8_162, s8_499);
  const double s8_501 = mbgen::fma(work.Rz_rear_axle_rz_0, s8_154, s8_500);
  const double s8_502 = mbgen::fma(work.Rz_rear_axle_rx_0, s8_169, s8_501);
  const double s8_503 = mbgen::fnma(3.0, s8_314, s8_502);
  const double s8_504 = mbgen::fnma(2.6666666666666665, s8_361, s8_503);
  const double s8_505 = mbgen::fma(s8_444, s8_444, s8_445);
  const double s8_506 = mbgen::fnma(0.3333333333333333, s8_505, s8_504);
  const double s8_507 = mbgen::fma(work.s2_87, work.s8_57, work.s6_77 - work.s2_91);
  const double s8_508 = mbgen::fma(work.s2_97, work.s8_32, s8_507);
  const double s8_509 = mbgen::fnma(work.s2_94, work.s8_33, s8_508);
  const double s8_510 = mbgen::fma(work.s6_63, work.s8_23, s8_509);
  const double s8_511 = mbgen::fnma(work.s6_61, work.s8_28, s8_510);
  const double s8_512 = mbgen::fma(work.s2_85, work.zdd_star_rear_axle_rx, s8_511);
  const double s8_513 = mbgen::fma(work.s2_88, work.zdd_star_rear_axle_rz, s8_512);
  const double s8_514 = 0.3333333333333333*s8_513;
  const double s8_515 = work.s6_56 - work.zdd_star_rear_axle_tz;
  const double s8_516 = mbgen::fma(work.s2_94, work.s8_44, s8_515);
  const double s8_517 = mbgen::fma(work.s2_97, work.s8_41, s8_516);
  const double s8_518 = mbgen::fnma(work.s2_87, work.s8_33, s8_517);
  const double s8_519 = mbgen::fma(work.s6_61, work.s8_13, s8_518);
  const double s8_520 = mbgen::fnma(work.s6_60, work.s8_23, s8_519);
  const double s8_521 = mbgen::fnma(work.s2_85, work.zdd_star_rear_axle_ry, s8_520);
  const double s8_522 = mbgen::fma(work.s2_84, work.zdd_star_rear_axle_rz, s8_521);
  const double s8_523 = 0.3333333333333333*s8_522;
  const double s8_524 = mbgen::fms(work.s6_60, work.s8_28, work.s6_59);
  const double s8_525 = mbgen::fnma(work.s6_63, work.s8_13, s8_524 - work.zdd_star_rear_axle_tx);
  const double s8_526 = mbgen::fnma(work.s2_84, work.zdd_star_rear_axle_rx, s8_525);
  const double s8_527 = mbgen::fnma(work.s2_88, work.zdd_star_rear_axle_ry, s8_526);
  const double s8_528 = mbgen::fnma(work.s2_87, work.s8_32, s8_527);
  const double s8_529 = mbgen::fnma(work.s2_94, work.s8_41, s8_528);
  const double s8_530 = 0.3333333333333333*mbgen::fnma(work.s2_97, work.s8_49, s8_529);
  const double s8_531 = mbgen::fnma(s8_398, s8_530, mbgen::fnma(s8_395, s8_514, s8_391));
  const double s8_532 = mbgen::fnma(s8_444, s8_523, mbgen::fnma(s8_442, s8_530, s8_393));
  const double s8_533 = mbgen::fma(s8_440, s8_514, s8_532);
  const double tau_rear_axle_tz = tau[Coordinate::rear_axle_tz];
  const double s8_534 = mbgen::fnma(s8_400, s8_523, s8_531);
  const double s8_535 = tau_rear_axle_tz - f_rear_axle_z;
  const double s8_536 = mbgen::fma(work.Rz_rear_axle_tz_1, s8_535, s8_534);
  const double s8_537 = mbgen::fma(work.s3_10, n_rear_axle_x - work.s5_52, s8_536);
  const double s8_538 = mbgen::fms(tau[Coordinate::rear_axle_rz], work.s5_53, n_rear_axle_z);
  const double s8_539 = mbgen::fma(work.Rz_rear_axle_ry_1, s8_147, s8_537);
  const double s8_540 = f_rear_axle_y - tau[Coordinate::rear_axle_ty];
  const double s8_541 = mbgen::fma(work.Rz_rear_axle_rx_1, s8_538, s8_539);
  const double s8_542 = tau[Coordinate::rear_axle_tx] - f_rear_axle_x;
  const double s8_543 = mbgen::fma(work.s3_14, s8_540, s8_541);
  work.s8_544 = work.s8_49 - work.s8_44;
  const double s8_545 = mbgen::fma(work.Rz_rear_axle_tx_1, s8_542, s8_543);
  const double s8_546 = mbgen::fma(s7_49, work.s8_544, s8_545);
  work.s8_547 = mbgen::fma(work.s8_41, s7_50 - s7_51, s8_546);
  work.s8_548 = 1.0/pivot_arb_rear_right;
  const double s8_549 = work.s8_448*work.s8_548;
  result.inertia[12] = mbgen::fnma(1e-12, pivot_arb_rear_right, pivot_arb_rear_right);
  const double pivot_arb_rear_left = mbgen::fnma(work.s8_448, s8_549, s8_506);
  result.inertia[11] = mbgen::fnma(1e-12, s8_506, pivot_arb_rear_left);
  work.s8_550 = 1.0/pivot_arb_rear_left;
  work.s8_551 = s8_94 - s8_59;
  work.s8_552 = mbgen::fnma(work.s8_551, s8_549, s8_91 - s8_68);
  work.s8_553 = s8_97 - s8_58;
  work.s8_554 = mbgen::fnma(work.s8_553, s8_549, s8_99 - s8_66);
  const double s8_555 = mbgen::fma((-p_arb_rear_left_z), s8_68, s8_37 + s8_169);
  const double s8_556 = mbgen::fma(work.r_rear_axle_aux1_x, s8_103, s8_555);
  const double s8_557 = mbgen::fnma(s8_412, s8_188, mbgen::fnma(z_rear_axle_ty, s8_91, s8_556));
  const double s8_558 = mbgen::fnma(s8_414, s8_226, mbgen::fnma(s8_429, s8_177, s8_557));
  const double s8_559 = mbgen::fma(s8_415, s8_266, mbgen::fnma(s8_431, s8_217, s8_558));
  const double s8_560 = mbgen::fma(s8_434, s8_306, mbgen::fnma(s8_432, s8_269, s8_559));
  const double s8_561 = mbgen::fma(s8_435, s8_347, mbgen::fnma(s8_417, s8_310, s8_560));
  const double s8_562 = mbgen::fma(s8_437, s8_442, mbgen::fnma(s8_418, s8_357, s8_561));
  work.s8_563 = mbgen::fnma(work.s8_487, s8_549, mbgen::fnma(s8_420, s8_440, s8_562));
  const double s8_564 = mbgen::fma(z_rear_axle_ty, s8_99, s8_154 - s8_36);
  const double s8_565 = mbgen::fnma(work.r_rear_axle_aux3_z, s8_103, s8_564);
  const double s8_566 = mbgen::fnma(p_arb_rear_left_y, s8_66, s8_565);
  const double s8_567 = mbgen::fma(s8_429, s8_186, mbgen::fma(s8_188, s8_450, s8_566));
  const double s8_568 = mbgen::fma(s8_431, s8_228, mbgen::fma(s8_226, s8_451, s8_567));
  const double s8_569 = mbgen::fma(s8_432, s8_271, mbgen::fma(s8_266, s8_453, s8_568));
  const double s8_570 = mbgen::fnma(s8_434, s8_312, mbgen::fma(s8_454, s8_310, s8_569));
  const double s8_571 = mbgen::fnma(s8_435, s8_359, mbgen::fma(s8_456, s8_357, s8_570));
  const double s8_572 = mbgen::fnma(s8_457, s8_440, mbgen::fnma(s8_437, s8_444, s8_571));
  work.s8_573 = mbgen::fnma(work.s8_478, s8_549, s8_572);
  const double s8_574 = s7_46 + mbgen::fma((-p_arb_rear_left_z), s8_68, s8_162);
  const double s8_575 = mbgen::fnma((-p_arb_rear_left_x), s8_66, s8_574);
  const double s8_576 = mbgen::fma(work.r_rear_axle_aux3_z, s8_91, s8_575);
  const double s8_577 = mbgen::fnma(work.r_rear_axle_aux1_x, s8_99, s8_576);
  const double s8_578 = mbgen::fnma(s8_177, s8_450, mbgen::fma(s8_412, s8_186, s8_577));
  const double s8_579 = mbgen::fnma(s8_217, s8_451, mbgen::fma(s8_414, s8_228, s8_578));
  const double s8_580 = mbgen::fnma(s8_415, s8_271, mbgen::fnma(s8_453, s8_269, s8_579));
  const double s8_581 = mbgen::fnma(s8_454, s8_306, mbgen::fma(s8_417, s8_312, s8_580));
  const double s8_582 = mbgen::fnma(s8_456, s8_347, mbgen::fma(s8_418, s8_359, s8_581));
  const double s8_583 = mbgen::fnma(s8_420, s8_444, mbgen::fnma(s8_457, s8_442, s8_582));
  work.s8_584 = mbgen::fnma(work.s8_497, s8_549, s8_583);
  work.s8_585 = mbgen::fnma(work.s8_101, s8_549, s8_103);
  const double s8_586 = work.s8_585*work.s8_550;
  const double s8_587 = work.s8_101*work.s8_548;
  work.s8_588 = mbgen::fma(work.s8_101, s8_587, work.s8_585*s8_586);
  work.s8_589 = mbgen::fma(work.s8_553, s8_587, s8_586*work.s8_554);
  work.s8_590 = mbgen::fma(work.s8_478, s8_587, s8_586*work.s8_573);
  work.s8_591 = mbgen::fma(work.s8_487, s8_587, s8_586*work.s8_563);
  work.s8_592 = mbgen::fma(work.s8_497, s8_587, s8_586*work.s8_584);
  const double s8_593 = mbgen::fnma(work.s8_547, s8_549, s8_533);
  const double s8_594 = mbgen::fma(work.s3_2, f_rear_axle_z - tau_rear_axle_tz, s8_593);
  const double s8_595 = mbgen::fma(work.Rz_rear_axle_rz_0, work.s5_52 - n_rear_axle_x, s8_594);
  const double s8_596 = mbgen::fma(work.Rz_rear_axle_ry_0, s8_147, s8_595);
  const double s8_597 = mbgen::fma(work.Rz_rear_axle_rx_0, s8_538, s8_596);
  const double s8_598 = mbgen::fma(work.s3_8, s8_540, s8_597);
  const double s8_599 = mbgen::fma(work.Rz_rear_axle_tx_0, s8_542, s8_598);
  const double s8_600 = mbgen::fma(s7_43, work.s8_544, s8_599);
  work.s8_601 = mbgen::fma(work.s8_41, s7_44 - s7_45, s8_600);
  const double s8_602 = s8_62 + s8_73;
  const double s8_603 = mbgen::fma(work.s8_547, s8_587, f_rear_axle_y + s8_602);
  work.s8_604 = mbgen::fma(s8_586, work.s8_601, s8_603);
  const double s8_605 = work.s8_550*work.s8_552;
  const double s8_606 = work.s8_551*work.s8_548;
  work.s8_607 = mbgen::fma(work.s8_101, s8_606, work.s8_585*s8_605);
  work.s8_608 = mbgen::fma(work.s8_551, s8_606, work.s8_552*s8_605);
  work.s8_609 = mbgen::fma(work.s8_553, s8_606, s8_605*work.s8_554);
  work.s8_610 = mbgen::fma(work.s8_478, s8_606, s8_605*work.s8_573);
  work.s8_611 = mbgen::fma(work.s8_487, s8_606, s8_605*work.s8_563);
  work.s8_612 = mbgen::fma(work.s8_497, s8_606, s8_605*work.s8_584);
  const double s8_613 = s8_58*s8_15;
  const double s8_614 = s8_66*s8_17;
  const double s8_615 = mbgen::fma(work.s8_547, s8_606, f_rear_axle_x - s8_613 - s8_614);
  work.s8_616 = mbgen::fma(s8_605, work.s8_601, s8_615);
  const double s8_617 = work.s8_550*work.s8_554;
  const double s8_618 = work.s8_553*work.s8_548;
  work.s8_619 = mbgen::fma(work.s8_553, s8_618, work.s8_554*s8_617);
  work.s8_620 = mbgen::fma(work.s8_478, s8_618, s8_617*work.s8_573);
  work.s8_621 = mbgen::fma(work.s8_487, s8_618, s8_617*work.s8_563);
  work.s8_622 = mbgen::fma(work.s8_497, s8_618, s8_617*work.s8_584);
  const double s8_623 = s8_59*s8_15;
  const double s8_624 = mbgen::fma(s8_68, s8_17, s8_623);
  const double s8_625 = mbgen::fma(work.s8_547, s8_618, f_rear_axle_z + s8_624);
  work.s8_626 = mbgen::fma(s8_617, work.s8_601, s8_625);
  const double s8_627 = work.s8_550*work.s8_573;
  const double s8_628 = work.s8_478*work.s8_548;
  work.s8_629 = mbgen::fma(work.s8_478, s8_628, work.s8_573*s8_627);
  work.s8_630 = mbgen::fma(work.s8_487, s8_628, work.s8_563*s8_627);
  work.s8_631 = mbgen::fma(work.s8_497, s8_628, s8_627*work.s8_584);
  const double s8_632 = mbgen::fma(work.s8_547, s8_628, n_rear_axle_x);
  const double s8_633 = mbgen::fnma(s7_49, s8_61, mbgen::fnma(s8_30, s8_15, s8_632));
  const double s8_634 = mbgen::fma(s8_37, s8_17, mbgen::fnma(s7_51, s8_60, s8_633));
  const double s8_635 = mbgen::fnma(s7_45, s8_71, mbgen::fnma(s7_43, s8_72, s8_634));
  const double s8_636 = mbgen::fma(z_rear_axle_ty, f_rear_axle_z, s8_635);
  const double s8_637 = mbgen::fnma(work.r_rear_axle_aux3_z, f_rear_axle_y, s8_636);
  const double s8_638 = mbgen::fnma(work.s2_8, s8_211, mbgen::fnma(work.s2_13, s8_204, s8_637));
  const double s8_639 = mbgen::fnma(work.s2_22, s8_253, mbgen::fnma(work.s2_29, s8_246, s8_638));
  const double s8_640 = mbgen::fnma(work.s2_45, s8_298, mbgen::fnma(work.s2_48, s8_282, s8_639));
  const double s8_641 = mbgen::fnma(work.s2_61, s8_327, mbgen::fma(work.s2_60, s8_334, s8_640));
  const double s8_642 = mbgen::fnma(work.s2_73, s8_372, mbgen::fma(work.s2_81, s8_381, s8_641));
  const double s8_643 = mbgen::fnma(work.s2_94, s8_514, mbgen::fma(work.s2_87, s8_523, s8_642));
  const double s8_644 = s8_62 + mbgen::fma(s8_68, s8_17, s8_73) - s8_623;
  const double s8_645 = mbgen::fma(s8_627, work.s8_601, s8_643);
  work.s8_646 = mbgen::fma(p_carrier_left_rz_y, s8_644, s8_645);
  const double s8_647 = work.s8_550*work.s8_563;
  const double s8_648 = work.s8_487*work.s8_548;
  work.s8_649 = mbgen::fma(work.s8_487, s8_648, work.s8_563*s8_647);
  const double s8_650 = mbgen::fma((-p_arb_rear_left_z), s8_614, n_rear_axle_z);
  const double s8_651 = mbgen::fnma((-p_arb_rear_right_z), s8_613, s8_650);
  const double s8_652 = mbgen::fma(s7_50, s8_61, mbgen::fma(work.s8_547, s8_648, s8_651));
  const double s8_653 = mbgen::fnma(s8_31, s8_15, mbgen::fma(s7_49, s8_60, s8_652));
  const double s8_654 = mbgen::fma(s7_44, s8_72, mbgen::fma(s8_36, s8_17, s8_653));
  const double s8_655 = mbgen::fma(s7_43, s8_71, s8_654);
  const double s8_656 = mbgen::fma(work.r_rear_axle_aux1_x, f_rear_axle_y, s8_655);
  const double s8_657 = mbgen::fnma(z_rear_axle_ty, f_rear_axle_x, s8_656);
  const double s8_658 = mbgen::fma(work.s2_11, s8_211, mbgen::fma(work.s2_13, s8_197, s8_657));
  const double s8_659 = mbgen::fma(work.s2_26, s8_253, mbgen::fma(work.s2_29, s8_238, s8_658));
  const double s8_660 = mbgen::fnma(work.s2_55, s8_298, mbgen::fma(work.s2_48, s8_290, s8_659));
  const double s8_661 = mbgen::fnma(work.s2_60, s8_341, mbgen::fma(work.s2_69, s8_327, s8_660));
  const double s8_662 = mbgen::fma(work.pivot_rear_axle_tx, s8_372, s8_661);
  const double s8_663 = mbgen::fnma(work.s2_97, s8_514, mbgen::fnma(work.s2_81, s8_389, s8_662));
  const double s8_664 = mbgen::fma(s8_647, work.s8_601, mbgen::fnma(work.s2_87, s8_530, s8_663));
  work.s8_665 = mbgen::fnma((-p_arb_rear_left_x), s8_602, s8_664);
  const double s8_666 = work.s8_550*work.s8_584;
  const double s8_667 = work.s8_497*work.s8_548;
  work.s8_668 = mbgen::fma(work.s8_487, s8_667, work.s8_563*s8_666);
  work.s8_669 = mbgen::fma(work.s8_497, s8_667, work.s8_584*s8_666);
  const double s8_670 = mbgen::fma((-p_arb_rear_right_z), s8_613, n_rear_axle_y);
  const double s8_671 = mbgen::fma((-p_arb_rear_left_z), s8_614, s8_670);
  const double s8_672 = mbgen::fma(work.s8_547, s8_667, s8_671);
  const double s8_673 = mbgen::fma(work.r_rear_axle_aux3_z, f_rear_axle_x, s8_672);
  const double s8_674 = mbgen::fnma(work.r_rear_axle_aux1_x, f_rear_axle_z, s8_673);
  const double s8_675 = mbgen::fnma(work.s2_11, s8_204, mbgen::fma(work.s2_8, s8_197, s8_674));
  const double s8_676 = mbgen::fnma(work.s2_26, s8_246, mbgen::fma(work.s2_22, s8_238, s8_675));
  const double s8_677 = mbgen::fma(work.s2_45, s8_290, mbgen::fma(work.s2_55, s8_282, s8_676));
  const double s8_678 = mbgen::fnma(work.s2_69, s8_334, mbgen::fma(work.s2_61, s8_341, s8_677));
  const double s8_679 = mbgen::fma(work.s2_73, s8_389, s8_678);
  const double s8_680 = mbgen::fnma(work.pivot_rear_axle_tx, s8_381, s8_679);
  const double s8_681 = mbgen::fma(work.s2_94, s8_530, mbgen::fma(work.s2_97, s8_523, s8_680));
  const double s8_682 = mbgen::fma(s8_666, work.s8_601, s8_681);
  work.s8_683 = mbgen::fma((-p_arb_rear_left_x), s8_624, s8_682);
  // operations: 779 add, 831 multiply, 2 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s8_684 = I_wheel_front_right_polar*work.s4_66;
  const double tau_wheel_front_right = tau[Coordinate::wheel_front_right];
  const double s8_685 = work.R_carrier_right_aux2_z_y*tau_wheel_front_right;
  work.s8_686 = mbgen::fma(work.s4_61, s8_684, s8_685);
  const double s8_687 = work.R_carrier_right_aux2_y_y*tau_wheel_front_right;
  work.s8_688 = mbgen::fnma(work.s4_63, s8_684, s8_687);
  work.s8_689 = mbgen::fnma(work.s1_43, tau_wheel_front_right, s8_684*work.s4_68);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s8_690 = I_wheel_front_left_polar*work.s4_57;
  const double tau_wheel_front_left = tau[Coordinate::wheel_front_left];
  const double s8_691 = work.R_carrier_left_aux2_z_y*tau_wheel_front_left;
  work.s8_692 = mbgen::fma(work.s4_52, s8_690, s8_691);
  const double s8_693 = work.R_carrier_left_aux2_y_y*tau_wheel_front_left;
  work.s8_694 = mbgen::fnma(work.s4_54, s8_690, s8_693);
  work.s8_695 = mbgen::fnma(work.s1_17, tau_wheel_front_left, s8_690*work.s4_59);
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
  const double s2_160 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_161 = mbgen::fnma((-p_upper_arm_left_ball_z), R_upper_arm_left_y_y, s2_160);
  const double s2_162 = (-p_upper_arm_left_ball_z)*R_upper_arm_left_z_y;
  const double s2_163 = mbgen::fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s2_162);
  const double s2_164 = (-p_carrier_left_upper_ball_y)*work.R_carrier_left_aux2_z_y;
  const double pivot_carrier_left_rx = mbgen::fms(p_carrier_left_upper_ball_z,
      work.R_carrier_left_z_z, s2_164);
  const double s2_165 = (-p_carrier_left_upper_ball_y)*work.s1_17;
  const double s2_166 = mbgen::fma(p_carrier_left_upper_ball_z, work.R_carrier_left_x_z, s2_165);
  const double s2_167 = mbgen::fnma(work.s4_42, pivot_carrier_left_rx, work.s4_12*s2_166);
  const double s2_168 = (-p_carrier_left_upper_ball_y)*work.R_carrier_left_aux2_y_y;
  const double s2_169 = mbgen::fms(p_carrier_left_upper_ball_z, work.R_carrier_left_y_z, s2_168);
  const double s2_170 = mbgen::fnma(work.s4_14, s2_166, work.s4_42*s2_169);
  const double s2_171 = mbgen::fnma(work.s4_12, s2_167, work.s4_14*s2_170);
  const double s2_172 = mbgen::fnma(work.s4_12, s2_169, work.s4_14*pivot_carrier_left_rx);
  // upper_ball_right
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s2_173 = (-p_upper_arm_right_ball_z)*R_upper_arm_right_z_y;
  const double s2_174 = mbgen::fnma((-p_upper_arm_right_ball_y), R_upper_arm_right_y_y, s2_173);
  const double s2_175 = (-p_upper_arm_right_ball_y)*R_upper_arm_right_z_y;
  const double s2_176 = mbgen::fma((-p_upper_arm_right_ball_z), R_upper_arm_right_y_y, s2_175);
  const double s2_177 = p_carrier_right_upper_ball_y*work.R_carrier_right_aux2_z_y;
  const double pivot_carrier_right_rx = mbgen::fma(p_carrier_right_upper_ball_z,
      work.R_carrier_right_z_z, s2_177);
  const double s2_178 = p_carrier_right_upper_ball_y*work.R_carrier_right_aux2_y_y;
  const double s2_179 = mbgen::fma(p_carrier_right_upper_ball_z, work.R_carrier_right_y_z, s2_178);
  const double s2_180 = mbgen::fnma(work.s4_23, s2_179, work.s4_25*pivot_carrier_right_rx);
  const double s2_181 = p_carrier_right_upper_ball_y*work.s1_43;
  const double s2_182 = mbgen::fms(p_carrier_right_upper_ball_z, work.R_carrier_right_x_z, s2_181);
  const double s2_183 = mbgen::fnma(work.s4_25, s2_182, work.s4_48*s2_179);
  const double s2_184 = mbgen::fnma(work.s4_48, pivot_carrier_right_rx, work.s4_23*s2_182);
  const double s2_185 = mbgen::fnma(work.s4_23, s2_184, work.s4_25*s2_183);
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s2_186 = (-p_arb_link_front_left_from_x)*R_arb_front_left_x_z;
  work.s2_187 = mbgen::fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s2_186);
  const double s2_188 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s2_189 = mbgen::fnma((-p_arb_link_front_left_from_x), R_arb_front_left_x_x, s2_188);
  const double s2_190 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s2_191 = work.s1_17 + work.R_carrier_left_x_z;
  work.s2_192 = mbgen::fma((-p_arb_link_front_left_to_y), s2_191, s2_190);
  work.s2_193 = 0.35 + (work.s2_189 - work.s2_192);
  const double s2_194 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s2_195 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s2_196 = mbgen::fma((-p_arb_link_front_left_to_y), s2_194, s2_195);
  const double s2_197 = mbgen::fnma(work.s4_42, work.s2_196, work.s4_12*work.s2_192);
  work.r_carrier_left_aux1_z = work.s1_13 - (-p_lower_arm_left_z);
  const double s2_198 = work.s2_187 - work.r_carrier_left_aux1_z - work.s2_196;
  work.s2_199 = s2_198 - (-p_arb_front_left_z);
  const double pivot_arb_front_left = mbgen::fnma(work.s2_189, work.s2_199,
      work.s2_187*work.s2_193);
  const double s2_200 = mbgen::fnma(work.s2_192, work.s2_199, work.s2_193*work.s2_196);
  const double s2_201 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s2_202 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s2_203 = mbgen::fma((-p_arb_link_front_left_to_y), s2_201, s2_202);
  const double s2_204 = mbgen::fnma(work.s4_14, work.s2_192, work.s4_42*work.s2_203);
  const double s2_205 = mbgen::fnma(work.s4_12, work.s2_203, work.s4_14*work.s2_196);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_11;
  work.s2_206 = 0.72 - work.r_carrier_left_aux1_y - work.s2_203;
  const double s2_207 = mbgen::fnma(work.s2_193, work.s2_203, work.s2_192*work.s2_206);
  const double s2_208 = mbgen::fnma(work.s2_196, work.s2_206, work.s2_199*work.s2_203);
  const double s2_209 = mbgen::fma(work.s1_11, work.s2_199, s2_208);
  const double s2_210 = mbgen::fnma(work.s1_13, work.s2_206, s2_209);
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s2_211 = (-p_arb_link_front_right_from_x)*R_arb_front_right_x_z;
  work.s2_212 = mbgen::fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s2_211);
  const double s2_213 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s2_214 = mbgen::fnma((-p_arb_link_front_right_from_x), R_arb_front_right_x_x, s2_213);
  const double s2_215 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s2_216 = work.R_carrier_right_x_z - work.s1_43;
  work.s2_217 = mbgen::fma((-p_arb_link_front_left_to_y), s2_216, s2_215);
  work.s2_218 = 0.35 + (work.s2_214 - work.s2_217);
  const double s2_219 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s2_220 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s2_221 = mbgen::fma((-p_arb_link_front_left_to_y), s2_219, s2_220);
  const double s2_222 = mbgen::fnma(work.s4_48, work.s2_221, work.s4_23*work.s2_217);
  work.s2_223 = (-p_lower_arm_right_z) + work.s1_37;
  work.s2_224 = work.s2_223 + work.s2_212 - work.s2_221 - (-p_arb_front_right_z);
  const double pivot_arb_front_right = mbgen::fnma(work.s2_214, work.s2_224,
      work.s2_212*work.s2_218);
  const double s2_225 = mbgen::fnma(work.s2_217, work.s2_224, work.s2_218*work.s2_221);
  const double s2_226 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s2_227 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s2_228 = mbgen::fma((-p_arb_link_front_left_to_y), s2_226, s2_227);
  const double s2_229 = mbgen::fnma(work.s4_25, work.s2_217, work.s4_48*work.s2_228);
  const double s2_230 = mbgen::fnma(work.s4_23, work.s2_228, work.s4_25*work.s2_221);
  work.r_carrier_right_aux1_y = work.s1_35 - (-p_lower_arm_right_y);
  work.s2_231 = 0.72 + (work.r_carrier_right_aux1_y + work.s2_228);
  const double s2_232 = mbgen::fma(work.s2_224, work.s2_228, work.s2_221*work.s2_231);
  const double s2_233 = mbgen::fma(work.s2_218, work.s2_228, work.s2_217*work.s2_231);
  const double s2_234 = mbgen::fma(work.s1_35, work.s2_224, s2_232);
  const double s2_235 = mbgen::fnma(work.s1_37, work.s2_231, s2_234);
  // drag_link
  work.s2_236 = (-p_drag_link_from_z)*work.sines[15];
  const double R_bell_crank_y_x = work.sines[16];
  work.s2_237 = p_drag_link_to_y*R_bell_crank_y_x;
  work.s2_238 = 1.15 + (work.s2_237 - work.s2_236);
  work.s2_239 = (-p_drag_link_from_z)*work.cosines[15];
  work.s2_240 = 0.2 - work.s2_239;
  const double pivot_pitman_arm = mbgen::fnma(work.s2_239, work.s2_238, work.s2_236*work.s2_240);
  const double R_bell_crank_x_x = work.cosines[16];
  work.s2_241 = p_drag_link_to_y*R_bell_crank_x_x;
  work.s2_242 = p_pitman_arm_y - work.s2_241;
  const double s2_243 = mbgen::fma(work.s2_238, work.s2_241, work.s2_237*work.s2_242);
  // tie_rod_left
  const double s2_244 = mbgen::fms(p_tie_rod_left_to_z, work.R_carrier_left_z_z, s2_164);
  work.s2_245 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_z_x, s2_244);
  work.s2_246 = (-p_bell_crank_z) + (work.r_carrier_left_aux1_z + work.s2_245);
  const double s2_247 = mbgen::fms(p_tie_rod_left_to_z, work.R_carrier_left_y_z, s2_168);
  work.s2_248 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_y_x, s2_247);
  const double s2_249 = mbgen::fnma(work.s4_12, work.s2_248, work.s4_14*work.s2_245);
  const double s2_250 = (-p_tie_rod_left_from_x)*R_bell_crank_y_x;
  work.s2_251 = mbgen::fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_250);
  work.s2_252 = work.s2_251 - work.r_carrier_left_aux1_y - work.s2_248;
  const double s2_253 = mbgen::fma(work.s2_245, work.s2_252, work.s2_246*work.s2_248);
  const double s2_254 = mbgen::fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, s2_165);
  work.s2_255 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_x_x, s2_254);
  const double s2_256 = mbgen::fnma(work.s4_14, work.s2_255, work.s4_42*work.s2_248);
  const double s2_257 = mbgen::fnma(work.s4_42, work.s2_245, work.s4_12*work.s2_255);
  const double s2_258 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  work.s2_259 = mbgen::fma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s2_258);
  work.s2_260 = 0.35 + (work.s2_259 + work.s2_255);
  const double s2_261 = mbgen::fnma(work.s2_251, work.s2_260, work.s2_259*work.s2_252);
  const double s2_262 = mbgen::fnma(work.s2_245, work.s2_260, work.s2_246*work.s2_255);
  const double s2_263 = mbgen::fma(work.s2_248, work.s2_260, work.s2_252*work.s2_255);
  const double s2_264 = mbgen::fma(work.s1_11, work.s2_246, s2_253);
  const double s2_265 = mbgen::fma(work.s1_13, work.s2_252, s2_264);
  // tie_rod_right
  work.s2_266 = mbgen::fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_250);
  const double s2_267 = mbgen::fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, s2_177);
  work.s2_268 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_z_x, s2_267);
  work.s2_269 = (-p_bell_crank_z) + (work.s2_268 - work.s2_223);
  const double s2_270 = mbgen::fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, s2_178);
  work.s2_271 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_y_x, s2_270);
  const double s2_272 = mbgen::fnma(work.s4_23, work.s2_271, work.s4_25*work.s2_268);
  work.s2_273 = work.s2_266 + (work.r_carrier_right_aux1_y + work.s2_271);
  const double s2_274 = mbgen::fnma(work.s2_269, work.s2_271, work.s2_268*work.s2_273);
  work.s2_275 = mbgen::fnma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s2_258);
  const double s2_276 = mbgen::fms(p_tie_rod_right_to_z, work.R_carrier_right_x_z, s2_181);
  work.s2_277 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_x_x, s2_276);
  const double s2_278 = mbgen::fnma(work.s4_25, work.s2_277, work.s4_48*work.s2_271);
  const double s2_279 = mbgen::fnma(work.s4_48, work.s2_268, work.s4_23*work.s2_277);
  work.s2_280 = work.s2_275 - work.s2_277 - 0.35;
  const double s2_281 = mbgen::fnma(work.s2_273, work.s2_275, work.s2_266*work.s2_280);
  const double s2_282 = mbgen::fma(work.s2_268, work.s2_280, work.s2_269*work.s2_277);
  const double s2_283 = mbgen::fma(work.s2_271, work.s2_280, work.s2_273*work.s2_277);
  const double s2_284 = mbgen::fnma(work.s1_35, work.s2_269, s2_274);
  const double s2_285 = mbgen::fnma(work.s1_37, work.s2_273, s2_284);
  const double s2_286 = 1.0/pivot_carrier_right_rx;
  const double s2_287 = s2_282*s2_286;
  const double pivot_carrier_right_ry = mbgen::fnma(s2_179, s2_287, s2_283);
  const double s2_288 = s2_182*s2_286;
  const double s2_289 = 1.0/pivot_carrier_right_ry;
  const double s2_290 = s2_289*(s2_179*s2_288);
  const double s2_291 = s2_182*s2_289;
  const double pivot_carrier_right_rz = mbgen::fms(s2_274, s2_291, pivot_carrier_right_rx);
  const double s2_292 = 1.0/pivot_carrier_right_rz;
  const double s2_293 = mbgen::fnma(s2_274, s2_290, s2_179)*s2_292;
  const double pivot_upper_arm_right = mbgen::fms(s2_176, s2_293, s2_174);
  const double s2_294 = 1.0/pivot_carrier_left_rx;
  const double s2_295 = s2_262*s2_294;
  const double s2_296 = mbgen::fma(s2_169, s2_295, s2_263);
  const double s2_297 = s2_166*s2_294;
  const double s2_298 = 1.0/s2_296;
  const double s2_299 = s2_169*s2_297*s2_298;
  const double pivot_lower_arm_left = mbgen::fnma(s2_265, s2_299, work.s1_11 + s2_169);
  const double s2_300 = s2_166*s2_298;
  const double s2_301 = 1.0/pivot_lower_arm_left;
  const double s2_302 = (mbgen::fms(s2_265, s2_300, work.s1_13) - pivot_carrier_left_rx)*s2_301;
  const double pivot_upper_arm_left = mbgen::fma(s2_163, s2_302, s2_161);
  const double s2_303 = s2_261*s2_299;
  const double s2_304 = mbgen::fma(s2_302, s2_303, s2_261*s2_300);
  const double s2_305 = s2_281*s2_291;
  const double s2_306 = mbgen::fma(s2_293, s2_305, s2_281*s2_290);
  const double s2_307 = mbgen::fma(s2_285, s2_291, work.s1_37 - pivot_carrier_right_rx);
  const double s2_308 = mbgen::fnma(s2_285, s2_290, work.s1_35 + s2_179);
  const double s2_309 = mbgen::fnma(s2_293, s2_307, s2_308);
  const double s2_310 = mbgen::fnma(s2_253, s2_299, s2_169);
  const double s2_311 = mbgen::fms(s2_253, s2_300, pivot_carrier_left_rx);
  const double s2_312 = mbgen::fnma(s2_302, s2_310, s2_311);
  const double s2_313 = 16.504892200367603*std::abs(pivot_arb_front_right);
  const double s2_314 = mbgen::min(3.9625229801272064*std::abs(pivot_pitman_arm), s2_313);
  const double s2_315 = mbgen::min(16.679425973935604*std::abs(pivot_arb_front_left), s2_314);
  const double s2_316 = mbgen::min(2.7028647671567816*std::abs(pivot_carrier_right_rx), s2_315);
  const double s2_317 = mbgen::min(s2_316, 6.8514628664707224*std::abs(pivot_carrier_right_ry));
  const double s2_318 = mbgen::min(s2_317, 2.7028647671567816*std::abs(pivot_carrier_right_rz));
  const double s2_319 = mbgen::min(s2_318, 3.405476531191585*std::abs(pivot_upper_arm_right));
  const double s2_320 = mbgen::min(2.7028219055711094*std::abs(pivot_carrier_left_rx), s2_319);
  const double s2_321 = mbgen::min(6.915894223167945*std::abs(s2_296), s2_320);
  const double s2_322 = mbgen::min(2.5101920700758265*std::abs(pivot_lower_arm_left), s2_321);
  work.s2_323 = mbgen::min(3.84681640934729*std::abs(pivot_upper_arm_left), s2_322);
  // operations: 142 add, 189 multiply, 6 divide, 21 other

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  const double s3_18 = 1.0/pivot_upper_arm_left;
  work.s3_19 = s2_312*s3_18;
  work.s3_20 = s2_301*mbgen::fma(s2_163, work.s3_19, s2_310);
  work.Rz_upper_arm_left_2 = s3_18*s2_304;
  work.Rz_lower_arm_left_2 = s2_301*mbgen::fms(s2_163, work.Rz_upper_arm_left_2, s2_303);
  work.s3_21 = s2_298*mbgen::fms(s2_265, work.s3_20, s2_253);
  work.s3_22 = s2_294*(s2_169*work.s3_21);
  work.s3_23 = mbgen::fnma(work.s2_245, work.s3_22, work.s2_248*work.s3_21);
  work.s3_24 = s2_298*mbgen::fnma(s2_265, work.Rz_lower_arm_left_2, s2_261);
  work.s3_25 = s2_294*(s2_169*work.s3_24);
  const double s3_26 = mbgen::fnma(s2_207, work.s3_24, s2_210*work.Rz_lower_arm_left_2);
  const double s3_27 = mbgen::fnma(s2_207, work.s3_21, mbgen::fnma(s2_200, work.s3_22, s2_208));
  const double s3_28 = 1.0/pivot_arb_front_left;
  work.Rz_arb_front_left_0 = s3_28*mbgen::fnma(s2_210, work.s3_20, s3_27);
  const double s3_29 = work.s2_187*work.Rz_arb_front_left_0;
  const double s3_30 = mbgen::fnma(work.s2_203, work.s3_21, s3_29);
  work.s3_31 = mbgen::fma(work.s2_196, work.s3_22, s3_30);
  work.Rz_arb_front_left_2 = s3_28*mbgen::fnma(s2_200, work.s3_25, s3_26);
  const double s3_32 = work.s2_187*work.Rz_arb_front_left_2;
  const double s3_33 = mbgen::fnma(work.s2_203, work.s3_24, s3_32);
  work.s3_34 = mbgen::fma(work.s2_196, work.s3_25, s3_33);
  const double s3_35 = 1.0/pivot_upper_arm_right;
  work.s3_36 = s2_309*s3_35;
  work.s3_37 = s2_292*mbgen::fma(s2_176, work.s3_36, s2_307);
  work.s3_38 = s2_306*s3_35;
  work.Rz_carrier_right_rz_2 = s2_292*mbgen::fnma(s2_176, work.s3_38, s2_305);
  work.Rz_carrier_right_ry_1 = s2_289*mbgen::fnma(s2_274, work.s3_37, s2_285);
  work.Rz_carrier_right_rx_1 = s2_286*(s2_179*work.Rz_carrier_right_ry_1);
  const double s3_39 = mbgen::fma(s2_225, work.Rz_carrier_right_rx_1, s2_235);
  const double s3_40 = mbgen::fnma(s2_233, work.Rz_carrier_right_ry_1, s3_39);
  const double s3_41 = work.s2_268*work.Rz_carrier_right_rx_1;
  work.s3_42 = mbgen::fnma(work.s2_271, work.Rz_carrier_right_ry_1, s3_41);
  work.Rz_carrier_right_ry_2 = s2_289*mbgen::fms(s2_274, work.Rz_carrier_right_rz_2, s2_281);
  const double s3_43 = work.s2_217*work.Rz_carrier_right_ry_2;
  work.s3_44 = mbgen::fnma(work.s2_221, work.Rz_carrier_right_rz_2, s3_43);
  work.Rz_carrier_right_rx_2 = s2_286*(s2_179*work.Rz_carrier_right_ry_2);
  const double s3_45 = s2_232*work.Rz_carrier_right_rz_2;
  const double s3_46 = mbgen::fma(s2_225, work.Rz_carrier_right_rx_2, s3_45);
  const double s3_47 = work.s2_271*work.Rz_carrier_right_rz_2;
  work.s3_48 = mbgen::fnma(work.s2_277, work.Rz_carrier_right_rx_2, s3_47);
  const double s3_49 = 1.0/pivot_arb_front_right;
  work.Rz_arb_front_right_1 = s3_49*mbgen::fnma(s2_232, work.s3_37, s3_40);
  const double s3_50 = work.s2_212*work.Rz_arb_front_right_1;
  const double s3_51 = mbgen::fnma(work.s2_221, work.Rz_carrier_right_rx_1, s3_50);
  work.s3_52 = mbgen::fma(work.s2_228, work.Rz_carrier_right_ry_1, s3_51);
  work.Rz_arb_front_right_2 = s3_49*mbgen::fnma(s2_233, work.Rz_carrier_right_ry_2, s3_46);
  const double s3_53 = work.s2_214*work.Rz_arb_front_right_2;
  const double s3_54 = mbgen::fma(work.s2_228, work.Rz_carrier_right_rz_2, s3_53);
  work.s3_55 = mbgen::fnma(work.s2_217, work.Rz_carrier_right_rx_2, s3_54);
  const double s3_56 = work.s2_212*work.Rz_arb_front_right_2;
  const double s3_57 = mbgen::fnma(work.s2_221, work.Rz_carrier_right_rx_2, s3_56);
  work.s3_58 = mbgen::fma(work.s2_228, work.Rz_carrier_right_ry_2, s3_57);
  const double s3_59 = 1.0/pivot_pitman_arm;
  work.s3_60 = s2_243*s3_59;
  // operations: 32 add, 68 multiply, 5 divide

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  // arb_link_front_left
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s6_82 = zd_arb_front_left*work.s2_189;
  const double s6_83 = mbgen::fma(work.s4_14, s2_204, zd_arb_front_left*s6_82);
  work.s6_84 = mbgen::fnma(work.s4_12, s2_197, s6_83);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s6_85 = zd_lower_arm_left*work.s1_11;
  work.s6_86 = s6_82 + (work.s6_85 + s2_204);
  work.s6_87 = zd_lower_arm_left*zd_lower_arm_left;
  work.s6_88 = work.s1_11*work.s6_87;
  const double s6_89 = mbgen::fms(work.s4_12, s2_205, work.s6_88);
  work.s6_90 = mbgen::fnma(work.s4_42, s2_204, s6_89);
  work.s6_91 = work.s1_13*work.s6_87;
  const double s6_92 = zd_arb_front_left*work.s2_187;
  const double s6_93 = mbgen::fms(zd_arb_front_left, s6_92, work.s6_91);
  work.s6_94 = mbgen::fnma(work.s4_14, s2_205, mbgen::fma(work.s4_42, s2_197, s6_93));
  work.s6_95 = s6_92 - s2_205;
  // arb_link_front_right
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s6_96 = zd_arb_front_right*work.s2_214;
  const double s6_97 = mbgen::fma(work.s4_25, s2_229, zd_arb_front_right*s6_96);
  work.s6_98 = mbgen::fnma(work.s4_23, s2_222, s6_97);
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s6_99 = zd_lower_arm_right*work.s1_35;
  work.s6_100 = s6_96 + (work.s6_99 + s2_229);
  work.s6_101 = zd_lower_arm_right*zd_lower_arm_right;
  work.s6_102 = work.s1_35*work.s6_101;
  const double s6_103 = mbgen::fms(work.s4_23, s2_230, work.s6_102);
  work.s6_104 = mbgen::fnma(work.s4_48, s2_229, s6_103);
  work.s6_105 = work.s1_37*work.s6_101;
  const double s6_106 = zd_arb_front_right*work.s2_212;
  const double s6_107 = mbgen::fma(zd_arb_front_right, s6_106, work.s6_105);
  work.s6_108 = mbgen::fnma(work.s4_25, s2_230, mbgen::fma(work.s4_48, s2_222, s6_107));
  work.s6_109 = s6_106 - s2_230;
  // drag_link
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s6_110 = zd_pitman_arm*work.s2_236;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s6_111 = zd_bell_crank*work.s2_237;
  work.s6_112 = mbgen::fnma(zd_bell_crank, work.s6_111, zd_pitman_arm*work.s6_110);
  const double s6_113 = zd_pitman_arm*work.s2_239;
  const double s6_114 = zd_bell_crank*work.s2_241;
  work.s6_115 = s6_114 - s6_113;
  const double s6_116 = mbgen::fma(work.s6_110, work.s6_110, work.s6_111*work.s6_111);
  work.s6_117 = zd_bell_crank*s6_114;
  const double s6_118 = mbgen::fma(work.s6_115, work.s6_115, s6_116);
  work.s6_119 = zd_pitman_arm*s6_113;
  const double s6_120 = mbgen::fma(work.s2_242, work.s6_117, s6_118);
  const double s6_121 = mbgen::fma(work.s2_240, work.s6_119, s6_120);
  const double s6_122 = mbgen::fma(work.s2_238, work.s6_112, s6_121);
  // tie_rod_left
  const double s6_123 = zd_bell_crank*work.s2_259;
  const double s6_124 = mbgen::fnma(work.s4_14, s2_256, zd_bell_crank*s6_123);
  work.s6_125 = mbgen::fma(work.s4_12, s2_257, s6_124);
  const double s6_126 = zd_bell_crank*work.s2_251;
  work.s6_127 = work.s6_85 + s2_256;
  work.s6_128 = s6_126 + s2_249;
  work.s6_129 = zd_lower_arm_left*work.s1_13;
  work.s6_130 = s6_123 + s2_257 - work.s6_129;
  const double s6_131 = mbgen::fma(work.s6_128, work.s6_128, work.s6_127*work.s6_127);
  const double s6_132 = mbgen::fms(work.s4_42, s2_257, work.s6_91);
  work.s6_133 = mbgen::fnma(work.s4_14, s2_249, s6_132);
  const double s6_134 = mbgen::fma(work.s6_130, work.s6_130, s6_131);
  const double s6_135 = mbgen::fma(work.s2_246, work.s6_133, s6_134);
  const double s6_136 = mbgen::fms(zd_bell_crank, s6_126, work.s6_88);
  work.s6_137 = mbgen::fnma(work.s4_42, s2_256, mbgen::fma(work.s4_12, s2_249, s6_136));
  const double s6_138 = mbgen::fnma(work.s2_260, work.s6_125, s6_135);
  const double s6_139 = mbgen::fnma(work.s2_252, work.s6_137, s6_138);
  const double s6_140 = mbgen::fma(s2_295, s2_171, s6_139);
  // tie_rod_right
  const double s6_141 = zd_bell_crank*work.s2_275;
  const double s6_142 = mbgen::fma(work.s4_25, s2_278, zd_bell_crank*s6_141);
  work.s6_143 = mbgen::fnma(work.s4_23, s2_279, s6_142);
  const double s6_144 = mbgen::fma(work.s4_48, s2_279, work.s6_105);
  work.s6_145 = mbgen::fnma(work.s4_25, s2_272, s6_144);
  const double s6_146 = zd_bell_crank*work.s2_266;
  const double s6_147 = mbgen::fma(zd_bell_crank, s6_146, work.s6_102);
  work.s6_148 = mbgen::fma(work.s4_48, s2_278, mbgen::fnma(work.s4_23, s2_272, s6_147));
  work.s6_149 = s6_146 - s2_272;
  work.s6_150 = work.s6_99 + s2_278;
  work.s6_151 = zd_lower_arm_right*work.s1_37;
  work.s6_152 = s6_141 - work.s6_151 - s2_279;
  const double s6_153 = mbgen::fma(work.s6_149, work.s6_149, work.s6_150*work.s6_150);
  const double s6_154 = mbgen::fma(work.s6_152, work.s6_152, s6_153);
  const double s6_155 = mbgen::fma(work.s2_269, work.s6_145, s6_154);
  const double s6_156 = mbgen::fnma(work.s2_280, work.s6_143, s6_155);
  const double s6_157 = mbgen::fnma(work.s2_273, work.s6_148, s6_156);
  const double s6_158 = mbgen::fma(s2_287, s2_185, s6_157);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s6_159 = mbgen::fma(s2_299, s6_140, work.s6_91);
  const double s6_160 = mbgen::fnma(zd_upper_arm_left, zd_upper_arm_left*s2_161, s6_159);
  const double s6_161 = mbgen::fma(work.s4_14, s2_172, mbgen::fnma(work.s4_42, s2_167, s6_160));
  const double s6_162 = mbgen::fnma(s2_297, s2_171, s6_161);
  const double s6_163 = mbgen::fms(zd_upper_arm_left, zd_upper_arm_left*s2_163, work.s6_88);
  const double s6_164 = mbgen::fnma(work.s4_42, s2_170, mbgen::fma(work.s4_12, s2_172, s6_163));
  work.s6_165 = s3_18*mbgen::fma(s2_302, s6_162, mbgen::fma(s2_300, s6_140, s6_164));
  work.zdd_star_lower_arm_left = s2_301*mbgen::fnma(s2_163, work.s6_165, s6_162);
  work.zdd_star_carrier_left_ry = s2_298*mbgen::fma(s2_265, work.zdd_star_lower_arm_left, s6_140);
  const double s6_166 = s2_210*work.zdd_star_lower_arm_left;
  work.zdd_star_carrier_left_rx = s2_294*mbgen::fms(s2_169, work.zdd_star_carrier_left_ry, s2_171);
  const double s6_167 = mbgen::fma(s2_207, work.zdd_star_carrier_left_ry, s6_166);
  work.s6_168 = s2_197 - work.s6_129;
  const double s6_169 = mbgen::fma(s2_200, work.zdd_star_carrier_left_rx, s6_167);
  const double s6_170 = mbgen::fnma(work.s6_168, work.s6_168, s6_169);
  const double s6_171 = mbgen::fnma(work.s6_95, work.s6_95, s6_170);
  const double s6_172 = mbgen::fnma(work.s6_86, work.s6_86, s6_171);
  const double s6_173 = mbgen::fma(work.s2_206, work.s6_90, s6_172);
  const double s6_174 = mbgen::fma(work.s2_193, work.s6_84, s6_173);
  work.zdd_star_arb_front_left = s3_28*mbgen::fma(work.s2_199, work.s6_94, s6_174);
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s6_175 = mbgen::fma(s2_291, s6_158, work.s6_102);
  const double s6_176 = mbgen::fnma(zd_upper_arm_right, zd_upper_arm_right*s2_174, s6_175);
  const double s6_177 = mbgen::fma(work.s4_48, s2_183, mbgen::fnma(work.s4_23, s2_180, s6_176));
  const double s6_178 = mbgen::fma(work.s4_48, s2_184, work.s6_105);
  const double s6_179 = mbgen::fnma(work.s4_25, s2_180, s6_178);
  const double s6_180 = mbgen::fnma(zd_upper_arm_right, zd_upper_arm_right*s2_176, s6_179);
  const double s6_181 = mbgen::fma(s2_290, s6_158, mbgen::fma(s2_288, s2_185, s6_180));
  work.s6_182 = s3_35*mbgen::fma(s2_293, s6_177, s6_181);
  work.zdd_star_carrier_right_rz = s2_292*mbgen::fnma(s2_176, work.s6_182, s6_177);
  work.zdd_star_carrier_right_ry = s2_289*mbgen::fms(s2_274, work.zdd_star_carrier_right_rz,
      s6_158);
  work.zdd_star_carrier_right_rx = s2_286*mbgen::fms(s2_179, work.zdd_star_carrier_right_ry,
      s2_185);
  const double s6_183 = s2_232*work.zdd_star_carrier_right_rz;
  work.s6_184 = work.s6_151 + s2_222;
  const double s6_185 = mbgen::fma(s2_225, work.zdd_star_carrier_right_rx, s6_183);
  const double s6_186 = mbgen::fnma(work.s6_184, work.s6_184, s6_185);
  const double s6_187 = mbgen::fnma(work.s6_109, work.s6_109, s6_186);
  const double s6_188 = mbgen::fnma(work.s6_100, work.s6_100, s6_187);
  const double s6_189 = mbgen::fnma(work.s2_231, work.s6_104, s6_188);
  const double s6_190 = mbgen::fma(work.s2_218, work.s6_98, s6_189);
  const double s6_191 = mbgen::fma(work.s2_224, work.s6_108, s6_190);
  work.zdd_star_arb_front_right = s3_49*mbgen::fnma(s2_233, work.zdd_star_carrier_right_ry, s6_191);
  work.s6_192 = s3_59*s6_122;
  // operations: 105 add, 137 multiply

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s7_53 = (-h_lower_arm_left_z)*R_lower_arm_left_z_y;
  work.s7_54 = mbgen::fma(h_lower_arm_left_y, R_lower_arm_left_y_y, s7_53);
  const double s7_55 = h_lower_arm_left_y*R_lower_arm_left_z_y;
  work.s7_56 = mbgen::fnma((-h_lower_arm_left_z), R_lower_arm_left_y_y, s7_55);
  const double s7_57 = K_lower_arm_left_zz*R_lower_arm_left_z_y;
  const double s7_58 = mbgen::fma((-K_lower_arm_left_yz), R_lower_arm_left_y_y, s7_57);
  const double s7_59 = (-K_lower_arm_left_yz)*R_lower_arm_left_z_y;
  const double s7_60 = mbgen::fma(K_lower_arm_left_yy, R_lower_arm_left_y_y, s7_59);
  work.s7_61 = mbgen::fnma(R_lower_arm_left_y_y, s7_58, R_lower_arm_left_z_y*s7_60);
  work.s7_62 = mbgen::fma(R_lower_arm_left_y_y, s7_60, R_lower_arm_left_z_y*s7_58);
  work.s7_63 = 1.825625 - work.s7_62;
  work.s7_64 = work.s7_62 + work.s7_63;
  work.s7_65 = K_lower_arm_left_xx + work.s7_64 - K_lower_arm_left_xx;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_66 = K_carrier_left_yz*work.R_carrier_left_x_z;
  const double s7_67 = mbgen::fma(K_carrier_left_xy, work.R_carrier_left_x_x, s7_66);
  const double s7_68 = mbgen::fnma(K_carrier_left_yy, work.s1_17, s7_67);
  const double s7_69 = K_carrier_left_yy*work.R_carrier_left_aux2_y_y;
  const double s7_70 = mbgen::fma(K_carrier_left_xy, work.R_carrier_left_y_x, s7_69);
  const double s7_71 = mbgen::fma(K_carrier_left_yz, work.R_carrier_left_y_z, s7_70);
  const double s7_72 = h_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_73 = mbgen::fma(h_carrier_left_z, work.R_carrier_left_z_z, s7_72);
  work.s7_74 = mbgen::fnma((-h_carrier_left_x), work.R_carrier_left_z_x, s7_73);
  const double s7_75 = h_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_76 = mbgen::fma(h_carrier_left_z, work.R_carrier_left_y_z, s7_75);
  work.s7_77 = mbgen::fnma((-h_carrier_left_x), work.R_carrier_left_y_x, s7_76);
  const double s7_78 = h_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_79 = mbgen::fnma((-h_carrier_left_x), work.R_carrier_left_x_x, s7_78);
  work.s7_80 = mbgen::fnma(h_carrier_left_y, work.s1_17, s7_79);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_696 = mbgen::fnma(work.s3_22, work.s7_74, work.s3_21*work.s7_77);
  work.s8_697 = mbgen::fnma(work.s3_25, work.s7_74, work.s3_24*work.s7_77);
  const double s8_698 = mbgen::fma(m_rear_axle_2, state.z[Coordinate::rear_axle_ty], work.s7_11);
  work.s8_699 = s8_698 + work.s7_77;
  const double s8_700 = mbgen::fma(m_rear_axle_2, work.r_rear_axle_aux1_x, work.s7_13);
  work.s8_701 = s8_700 + work.s7_80;
  const double s8_702 = mbgen::fma(m_rear_axle_2, work.r_rear_axle_aux3_z, work.s7_14);
  work.s8_703 = s8_702 + work.s7_74;

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_81 = K_carrier_left_yz*work.R_carrier_left_aux2_y_y;
  const double s7_82 = mbgen::fma(K_carrier_left_zz, work.R_carrier_left_y_z, s7_81);
  const double s7_83 = mbgen::fnma((-K_carrier_left_xz), work.R_carrier_left_y_x, s7_82);
  const double s7_84 = work.R_carrier_left_aux2_z_y*s7_71;
  const double s7_85 = K_carrier_left_zz*work.R_carrier_left_x_z;
  const double s7_86 = mbgen::fnma((-K_carrier_left_xz), work.R_carrier_left_x_x, s7_85);
  const double s7_87 = mbgen::fnma(K_carrier_left_yz, work.s1_17, s7_86);
  const double s7_88 = work.R_carrier_left_aux2_z_y*s7_68;
  const double s7_89 = K_carrier_left_xy*work.R_carrier_left_aux2_y_y;
  const double s7_90 = mbgen::fma(K_carrier_left_xx, work.R_carrier_left_y_x, s7_89);
  const double s7_91 = mbgen::fnma((-K_carrier_left_xz), work.R_carrier_left_y_z, s7_90);
  const double s7_92 = mbgen::fma(work.R_carrier_left_z_z, s7_83, s7_84);
  work.s7_93 = mbgen::fma(work.R_carrier_left_z_x, s7_91, s7_92);
  const double s7_94 = K_carrier_left_xx*work.R_carrier_left_x_x;
  const double s7_95 = mbgen::fnma((-K_carrier_left_xz), work.R_carrier_left_x_z, s7_94);
  const double s7_96 = mbgen::fnma(K_carrier_left_xy, work.s1_17, s7_95);
  const double s7_97 = mbgen::fma(work.R_carrier_left_z_z, s7_87, s7_88);
  work.s7_98 = mbgen::fma(work.R_carrier_left_z_x, s7_96, s7_97);
  const double s7_99 = work.R_carrier_left_aux2_y_y*s7_68;
  const double s7_100 = mbgen::fma(work.R_carrier_left_y_x, s7_96, s7_99);
  work.s7_101 = mbgen::fma(work.R_carrier_left_y_z, s7_87, s7_100);
  const double s7_102 = work.R_carrier_left_aux2_y_y*s7_71;
  const double s7_103 = mbgen::fma(work.R_carrier_left_y_x, s7_91, s7_102);
  work.s7_104 = mbgen::fma(work.R_carrier_left_y_z, s7_83, s7_103);
  const double s7_105 = work.R_carrier_left_x_z*s7_87;
  const double s7_106 = mbgen::fma(work.R_carrier_left_x_x, s7_96, s7_105);
  work.s7_107 = mbgen::fnma(work.s1_17, s7_68, s7_106);
  const double s8_704 = work.s3_24*work.s7_93;
  work.s8_705 = mbgen::fnma(work.Rz_lower_arm_left_2, work.s7_101, s8_704);
  work.s8_706 = mbgen::fnma(work.Rz_lower_arm_left_2, work.s7_98, work.s3_25*work.s7_93);
  work.s8_707 = mbgen::fma(work.s3_21, work.s7_98, work.s3_22*work.s7_101);
  work.s8_708 = work.s8_421 + work.s7_98;
  work.s8_709 = work.s8_427 + work.s7_101;
  work.s8_710 = work.s8_438 + work.s7_93;
  work.s8_711 = work.s8_463 + work.s7_104;
  work.s8_712 = work.s8_469 + work.s7_107;
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
  const double s7_108 = K_carrier_left_trace - work.s7_107 - work.s7_104;
  const double s7_109 = work.s7_107 + (work.s7_104 + s7_108);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_110 = (-h_upper_arm_left_z)*R_upper_arm_left_z_y;
  work.s7_111 = mbgen::fma(h_upper_arm_left_y, R_upper_arm_left_y_y, s7_110);
  const double s7_112 = h_upper_arm_left_y*R_upper_arm_left_z_y;
  work.s7_113 = mbgen::fnma((-h_upper_arm_left_z), R_upper_arm_left_y_y, s7_112);
  work.s8_713 = mbgen::fnma(work.s7_111, work.s8_27, work.s6_165*work.s7_113);
  work.s8_714 = mbgen::fma(work.s7_113, work.s8_27, work.s6_165*work.s7_111);
  const double s7_114 = K_upper_arm_left_zz*R_upper_arm_left_z_y;
  const double s7_115 = mbgen::fma((-K_upper_arm_left_yz), R_upper_arm_left_y_y, s7_114);
  const double s7_116 = (-K_upper_arm_left_yz)*R_upper_arm_left_z_y;
  const double s7_117 = mbgen::fma(K_upper_arm_left_yy, R_upper_arm_left_y_y, s7_116);
  work.s7_118 = mbgen::fnma(R_upper_arm_left_y_y, s7_115, R_upper_arm_left_z_y*s7_117);
  work.s7_119 = mbgen::fma(R_upper_arm_left_y_y, s7_117, R_upper_arm_left_z_y*s7_115);
  work.s7_120 = 0.539 - work.s7_119;
  const double s7_121 = work.s7_119 + work.s7_120;
  const double s7_122 = K_upper_arm_left_xx + s7_121 - K_upper_arm_left_xx;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_123 = (-K_arb_front_left_xy)*R_arb_front_left_x_z;
  work.s7_124 = mbgen::fma(K_arb_front_left_yz, R_arb_front_left_x_x, s7_123);
  const double s7_125 = K_arb_front_left_yz*R_arb_front_left_x_z;
  work.s7_126 = mbgen::fnma((-K_arb_front_left_xy), R_arb_front_left_x_x, s7_125);
  const double s7_127 = (-h_arb_front_left_x)*R_arb_front_left_x_z;
  work.s7_128 = mbgen::fma(h_arb_front_left_z, R_arb_front_left_x_x, s7_127);
  const double s7_129 = h_arb_front_left_z*R_arb_front_left_x_z;
  work.s7_130 = mbgen::fnma((-h_arb_front_left_x), R_arb_front_left_x_x, s7_129);
  const double s8_715 = work.zdd_star_arb_front_left*work.s7_128;
  work.s8_716 = mbgen::fnma(work.s7_130, work.s8_22, s8_715);
  const double s8_717 = work.zdd_star_arb_front_left*work.s7_130;
  work.s8_718 = mbgen::fma(work.s7_128, work.s8_22, s8_717);
  const double s7_131 = K_arb_front_left_zz*R_arb_front_left_x_z;
  const double s7_132 = mbgen::fnma((-K_arb_front_left_xz), R_arb_front_left_x_x, s7_131);
  const double s7_133 = K_arb_front_left_xx*R_arb_front_left_x_x;
  const double s7_134 = mbgen::fnma((-K_arb_front_left_xz), R_arb_front_left_x_z, s7_133);
  work.s7_135 = mbgen::fnma(R_arb_front_left_x_z, s7_134, R_arb_front_left_x_x*s7_132);
  work.s7_136 = mbgen::fma(R_arb_front_left_x_x, s7_134, R_arb_front_left_x_z*s7_132);
  work.s7_137 = 0.3477 - work.s7_136;
  work.s7_138 = work.s7_136 + work.s7_137;
  const double s7_139 = K_arb_front_left_yy + work.s7_138 - K_arb_front_left_yy;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s7_140 = (-h_lower_arm_right_z)*R_lower_arm_right_z_y;
  work.s7_141 = mbgen::fnma((-h_lower_arm_right_y), R_lower_arm_right_y_y, s7_140);
  const double s7_142 = (-h_lower_arm_right_y)*R_lower_arm_right_z_y;
  work.s7_143 = mbgen::fma((-h_lower_arm_right_z), R_lower_arm_right_y_y, s7_142);
  const double s7_144 = K_lower_arm_right_yz*R_lower_arm_right_y_y;
  const double s7_145 = mbgen::fnma(K_lower_arm_right_zz, R_lower_arm_right_z_y, s7_144);
  const double s7_146 = K_lower_arm_right_yy*R_lower_arm_right_y_y;
  const double s7_147 = mbgen::fnma(K_lower_arm_right_yz, R_lower_arm_right_z_y, s7_146);
  work.s7_148 = mbgen::fma(R_lower_arm_right_y_y, s7_145, R_lower_arm_right_z_y*s7_147);
  work.s7_149 = mbgen::fnma(R_lower_arm_right_z_y, s7_145, R_lower_arm_right_y_y*s7_147);
  work.s7_150 = 1.825625 - work.s7_149;
  const double s7_151 = K_lower_arm_right_xx + (work.s7_149 + work.s7_150);
  work.s7_152 = s7_151 - K_lower_arm_right_xx;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_153 = K_carrier_right_yy*work.R_carrier_right_aux2_y_y;
  const double s7_154 = K_carrier_right_yy*work.s1_43;
  const double s7_155 = mbgen::fma((-K_carrier_right_yz), work.R_carrier_right_x_z, s7_154);
  const double s7_156 = mbgen::fma((-K_carrier_right_xy), work.R_carrier_right_x_x, s7_155);
  const double s7_157 = mbgen::fnma((-K_carrier_right_xy), work.R_carrier_right_y_x, s7_153);
  const double s7_158 = mbgen::fnma((-K_carrier_right_yz), work.R_carrier_right_y_z, s7_157);
  const double s7_159 = (-h_carrier_right_y)*work.s1_43;
  const double s7_160 = mbgen::fma(h_carrier_right_z, work.R_carrier_right_x_z, s7_159);
  const double s7_161 = mbgen::fnma((-h_carrier_right_x), work.R_carrier_right_x_x, s7_160);
  const double s7_162 = h_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_163 = mbgen::fnma((-h_carrier_right_x), work.R_carrier_right_z_x, s7_162);
  const double s7_164 = mbgen::fnma((-h_carrier_right_y), work.R_carrier_right_aux2_z_y, s7_163);
  const double s7_165 = h_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_166 = mbgen::fnma((-h_carrier_right_x), work.R_carrier_right_y_x, s7_165);
  const double s7_167 = mbgen::fnma((-h_carrier_right_y), work.R_carrier_right_aux2_y_y, s7_166);

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_719 = work.Rz_carrier_right_rx_1*s7_164;
  work.s8_720 = mbgen::fnma(work.Rz_carrier_right_ry_1, s7_167, s8_719);
  const double s8_721 = work.Rz_carrier_right_rx_2*s7_164;
  const double s8_722 = mbgen::fnma(work.Rz_carrier_right_ry_2, s7_167, s8_721);
  const double s8_723 = work.Rz_carrier_right_rz_2*s7_167;
  const double s8_724 = mbgen::fnma(work.Rz_carrier_right_rx_2, s7_161, s8_723);
  const double s8_725 = work.Rz_carrier_right_ry_2*s7_161;
  const double s8_726 = mbgen::fnma(work.Rz_carrier_right_rz_2, s7_164, s8_725);
  work.s8_727 = s7_167 + work.s8_699;
  work.s8_728 = s7_161 + work.s8_701;
  work.s8_729 = s7_164 + work.s8_703;

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_168 = K_carrier_right_zz*work.R_carrier_right_y_z;
  const double s7_169 = mbgen::fnma((-K_carrier_right_xz), work.R_carrier_right_y_x, s7_168);
  const double s7_170 = mbgen::fnma((-K_carrier_right_yz), work.R_carrier_right_aux2_y_y, s7_169);
  const double s7_171 = work.R_carrier_right_aux2_z_y*s7_158;
  const double s7_172 = (-K_carrier_right_yz)*work.s1_43;
  const double s7_173 = mbgen::fma(K_carrier_right_zz, work.R_carrier_right_x_z, s7_172);
  const double s7_174 = mbgen::fnma((-K_carrier_right_xz), work.R_carrier_right_x_x, s7_173);
  const double s7_175 = K_carrier_right_xx*work.R_carrier_right_y_x;
  const double s7_176 = mbgen::fnma((-K_carrier_right_xz), work.R_carrier_right_y_z, s7_175);
  const double s7_177 = mbgen::fnma((-K_carrier_right_xy), work.R_carrier_right_aux2_y_y, s7_176);
  const double s7_178 = mbgen::fma(work.R_carrier_right_z_z, s7_170, s7_171);
  const double s7_179 = mbgen::fma(work.R_carrier_right_z_x, s7_177, s7_178);
  const double s7_180 = (-K_carrier_right_xy)*work.s1_43;
  const double s7_181 = mbgen::fma(K_carrier_right_xx, work.R_carrier_right_x_x, s7_180);
  const double s7_182 = mbgen::fnma((-K_carrier_right_xz), work.R_carrier_right_x_z, s7_181);
  const double s7_183 = work.R_carrier_right_z_z*s7_174;
  const double s7_184 = mbgen::fma(work.R_carrier_right_z_x, s7_182, s7_183);
  const double s7_185 = mbgen::fnma(work.R_carrier_right_aux2_z_y, s7_156, s7_184);
  const double s7_186 = work.R_carrier_right_y_x*s7_182;
  const double s7_187 = mbgen::fma(work.R_carrier_right_y_z, s7_174, s7_186);
  const double s7_188 = mbgen::fnma(work.R_carrier_right_aux2_y_y, s7_156, s7_187);
  const double s7_189 = mbgen::fma(work.R_carrier_right_x_z, s7_174, work.s1_43*s7_156);
  const double s7_190 = mbgen::fma(work.R_carrier_right_x_x, s7_182, s7_189);
  const double s7_191 = work.R_carrier_right_aux2_y_y*s7_158;
  const double s7_192 = mbgen::fma(work.R_carrier_right_y_x, s7_177, s7_191);
  const double s7_193 = mbgen::fma(work.R_carrier_right_y_z, s7_170, s7_192);
  const double s8_730 = s7_185 + work.s8_708;
  const double s8_731 = s7_188 + work.s8_709;
  const double s8_732 = s7_179 + work.s8_710;
  const double s8_733 = s7_193 + work.s8_711;
  const double s8_734 = s7_190 + work.s8_712;
  const double s7_194 = K_carrier_right_trace - s7_190 - s7_193;
  const double s8_735 = s7_194 + (work.s8_459 + s7_108);
  const double s7_195 = s7_193 + (s7_190 + s7_194);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_196 = (-h_upper_arm_right_z)*R_upper_arm_right_z_y;
  work.s7_197 = mbgen::fnma((-h_upper_arm_right_y), R_upper_arm_right_y_y, s7_196);
  const double s7_198 = (-h_upper_arm_right_y)*R_upper_arm_right_z_y;
  work.s7_199 = mbgen::fma((-h_upper_arm_right_z), R_upper_arm_right_y_y, s7_198);
  work.s8_736 = mbgen::fnma(work.s6_182, work.s7_197, work.s7_199*work.s8_25);
  work.s8_737 = mbgen::fma(work.s7_197, work.s8_25, work.s6_182*work.s7_199);
  const double s7_200 = K_upper_arm_right_yz*R_upper_arm_right_y_y;
  const double s7_201 = mbgen::fnma(K_upper_arm_right_zz, R_upper_arm_right_z_y, s7_200);
  const double s7_202 = K_upper_arm_right_yy*R_upper_arm_right_y_y;
  const double s7_203 = mbgen::fnma(K_upper_arm_right_yz, R_upper_arm_right_z_y, s7_202);
  work.s7_204 = mbgen::fma(R_upper_arm_right_y_y, s7_201, R_upper_arm_right_z_y*s7_203);
  work.s7_205 = mbgen::fnma(R_upper_arm_right_z_y, s7_201, R_upper_arm_right_y_y*s7_203);
  work.s7_206 = 0.539 - work.s7_205;
  const double s7_207 = work.s7_205 + work.s7_206;
  const double s7_208 = K_upper_arm_right_xx + s7_207 - K_upper_arm_right_xx;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_209 = (-h_arb_front_right_x)*R_arb_front_right_x_z;
  work.s7_210 = mbgen::fma(h_arb_front_right_z, R_arb_front_right_x_x, s7_209);
  const double s7_211 = h_arb_front_right_z*R_arb_front_right_x_z;
  work.s7_212 = mbgen::fnma((-h_arb_front_right_x), R_arb_front_right_x_x, s7_211);
  const double s8_738 = work.zdd_star_arb_front_right*work.s7_210;
  work.s8_739 = mbgen::fnma(work.s7_212, work.s8_20, s8_738);
  const double s8_740 = work.zdd_star_arb_front_right*work.s7_212;
  work.s8_741 = mbgen::fma(work.s7_210, work.s8_20, s8_740);
  const double s7_213 = K_arb_front_right_xy*R_arb_front_right_x_x;
  work.s7_214 = mbgen::fnma((-K_arb_front_right_yz), R_arb_front_right_x_z, s7_213);
  const double s7_215 = K_arb_front_right_xy*R_arb_front_right_x_z;
  work.s7_216 = mbgen::fma((-K_arb_front_right_yz), R_arb_front_right_x_x, s7_215);
  const double s7_217 = K_arb_front_right_zz*R_arb_front_right_x_z;
  const double s7_218 = mbgen::fnma((-K_arb_front_right_xz), R_arb_front_right_x_x, s7_217);
  const double s7_219 = K_arb_front_right_xx*R_arb_front_right_x_x;
  const double s7_220 = mbgen::fnma((-K_arb_front_right_xz), R_arb_front_right_x_z, s7_219);
  work.s7_221 = mbgen::fnma(R_arb_front_right_x_z, s7_220, R_arb_front_right_x_x*s7_218);
  work.s7_222 = mbgen::fma(R_arb_front_right_x_x, s7_220, R_arb_front_right_x_z*s7_218);
  work.s7_223 = 0.3477 - work.s7_222;
  work.s7_224 = work.s7_222 + work.s7_223;
  const double s7_225 = mbgen::fnma(work.zdd_star_arb_front_right, work.s7_224,
      tau[Coordinate::arb_front_right]);
  const double s7_226 = mbgen::fma(work.s8_32, work.s7_216, s7_225);
  const double s7_227 = mbgen::fma(work.s8_33, work.s7_214, s7_226);
  const double s7_228 = K_arb_front_right_yy + work.s7_224 - K_arb_front_right_yy;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  work.s7_229 = (-h_pitman_arm_z)*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s7_230 = (-h_pitman_arm_z)*R_pitman_arm_x_x;
  work.s7_231 = mbgen::fnma(work.s6_192, work.s7_229, work.s7_230*work.s8_18);
  work.s7_232 = mbgen::fma(work.s7_229, work.s8_18, work.s6_192*work.s7_230);
  const double s7_233 = K_pitman_arm_zz*R_pitman_arm_x_z;
  const double s7_234 = K_pitman_arm_xx*R_pitman_arm_x_x;
  work.s7_235 = mbgen::fnma(R_pitman_arm_x_z, s7_234, R_pitman_arm_x_x*s7_233);
  work.s7_236 = mbgen::fma(R_pitman_arm_x_x, s7_234, R_pitman_arm_x_z*s7_233);
  work.s7_237 = 0.3504 - work.s7_236;
  const double s7_238 = work.s7_236 + work.s7_237;
  const double s7_239 = K_pitman_arm_yy + s7_238 - K_pitman_arm_yy;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_x_x = work.cosines[16];
  const double R_bell_crank_y_x = work.sines[16];
  const double s7_240 = h_bell_crank_y*R_bell_crank_x_x;
  work.s7_241 = mbgen::fnma((-h_bell_crank_x), R_bell_crank_y_x, s7_240);
  const double s7_242 = h_bell_crank_y*R_bell_crank_y_x;
  work.s7_243 = mbgen::fma((-h_bell_crank_x), R_bell_crank_x_x, s7_242);
  const double s8_742 = mbgen::fnma(work.s7_241, work.s8_52, tau[Coordinate::bell_crank]);
  const double s8_743 = mbgen::fma(work.s7_243, work.s8_40, s8_742);
  const double s7_244 = (-K_bell_crank_xy)*R_bell_crank_y_x;
  const double s7_245 = (-K_bell_crank_xy)*R_bell_crank_x_x;
  const double s7_246 = mbgen::fma(K_bell_crank_yy, R_bell_crank_y_x, s7_245);
  const double s7_247 = mbgen::fma(K_bell_crank_xx, R_bell_crank_x_x, s7_244);
  work.s7_248 = mbgen::fnma(R_bell_crank_x_x, s7_246, R_bell_crank_y_x*s7_247);
  work.s7_249 = mbgen::fma(R_bell_crank_x_x, s7_247, R_bell_crank_y_x*s7_246);
  const double s7_250 = R_bell_crank_y_x*mbgen::fms(K_bell_crank_xx, R_bell_crank_y_x, s7_245);
  const double s7_251 = mbgen::fms(K_bell_crank_yy, R_bell_crank_x_x, s7_244);
  work.s7_252 = mbgen::fma(R_bell_crank_x_x, s7_251, s7_250);
  work.s7_253 = K_bell_crank_trace - work.s7_249 - work.s7_252;
  const double s7_254 = work.s7_252 + (work.s7_249 + work.s7_253) - work.s7_253;
  // operations: 153 add, 195 multiply

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_744 = 1.0 - work.s3_20;
  work.s8_745 = work.s1_11*work.s3_20;
  const double s8_746 = mbgen::fma(work.s3_21, work.s7_93, work.s7_80*work.s8_745);
  work.s8_747 = work.s1_13*work.s3_20;
  const double s8_748 = mbgen::fma(work.s3_22, work.s7_93, work.s7_80*work.s8_747);
  const double s8_749 = work.s1_11*work.Rz_lower_arm_left_2;
  const double s8_750 = work.s1_13*work.Rz_lower_arm_left_2;
  const double s8_751 = mbgen::fma(work.s7_77, s8_749, work.s7_74*s8_750);
  const double s8_752 = mbgen::fma(work.s3_25, work.s7_101, s8_751);
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  work.s8_753 = zd_bell_crank*work.s8_23;
  work.s8_754 = zd_bell_crank*work.s8_13;
  work.s8_755 = mbgen::fnma(work.s7_243, work.s8_753, work.s7_241*work.s8_754);
  work.s8_756 = work.s7_243*work.s8_29;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s8_757 = work.s3_60*s7_239;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  work.s8_758 = zd_pitman_arm*work.s8_23;
  work.s8_759 = zd_pitman_arm*work.s8_28;
  work.s8_760 = mbgen::fma(work.s7_230, work.s8_759, work.s7_229*work.s8_758);
  const double s8_761 = (-p_rear_axle_tx_z)*work.s8_33;
  const double s8_762 = mbgen::fma((-p_pitman_arm_z), work.s8_44, s8_761);
  work.s8_763 = mbgen::fma(p_pitman_arm_x, work.s8_41, s8_762);
  work.s8_764 = work.s6_192*s7_238;
  // arb_front_right: arb_front_right, revolute, chassis
  work.s8_765 = work.Rz_arb_front_right_1*s7_228;
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  work.s8_766 = zd_arb_front_right*work.s8_28;
  work.s8_767 = zd_arb_front_right*work.s8_23;
  work.s8_768 = mbgen::fma(work.s7_212, work.s8_767, work.s7_210*work.s8_766);
  const double s8_769 = mbgen::fma((-p_arb_rear_right_y), work.s8_32, work.s8_56);
  const double s8_770 = mbgen::fnma((-p_arb_rear_right_z), work.s8_33, work.s8_48);
  const double s8_771 = mbgen::fma(work.s7_212, s8_770, mbgen::fma(work.s7_210, s8_769, s7_227));
  work.s8_772 = work.s8_44 - work.s8_49;
  const double s8_773 = mbgen::fnma(work.s8_41, work.s7_223 - work.s7_222, s8_771);
  work.s8_774 = mbgen::fnma(work.s7_221, work.s8_772, s8_773);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s8_775 = work.Rz_arb_front_right_2*s7_228;
  const double s8_776 = work.s3_38*s7_208;
  const double s8_777 = mbgen::fma(work.s3_36, s8_776, work.Rz_arb_front_right_1*s8_775);
  const double s8_778 = mbgen::fma(work.s1_35, s8_724, mbgen::fma(work.s1_37, s8_726, s8_777));
  work.s8_779 = work.s3_36*s7_208;
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  work.s8_780 = zd_upper_arm_right*work.s8_28;
  work.s8_781 = zd_upper_arm_right*work.s8_13;
  work.s8_782 = mbgen::fnma(work.s7_199, work.s8_780, work.s7_197*work.s8_781);
  work.s8_783 = work.s6_182*s7_207;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_784 = m_carrier_right_2*work.s1_37;
  work.s8_785 = 1.0 - work.s3_37;
  const double s8_786 = mbgen::fma(work.Rz_carrier_right_ry_1, s7_161, s8_784);
  work.s8_787 = mbgen::fnma(s7_164, work.s8_785, s8_786);
  const double s8_788 = mbgen::fma(s7_167, work.s8_785, m_carrier_right_2*work.s1_35);
  work.s8_789 = mbgen::fnma(work.Rz_carrier_right_rx_1, s7_161, s8_788);
  const double s8_790 = p_upper_arm_right_x*work.s8_49;
  const double s8_791 = mbgen::fms(work.s6_99, work.s8_13, s8_790);
  const double s8_792 = mbgen::fnma(work.s6_151, work.s8_28, s8_791);
  const double s8_793 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_32, s8_792);
  const double s8_794 = mbgen::fnma(work.s2_223, work.s8_41, s8_793);
  const double s8_795 = work.zdd_star_carrier_right_ry + work.s4_49;
  const double s8_796 = mbgen::fms(work.w_carrier_right_x, work.w_carrier_right_y, s8_795);
  const double s8_797 = work.zdd_star_carrier_right_rx + work.s4_50;
  const double s8_798 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_z, s8_797);
  const double s8_799 = mbgen::fma(s7_167, s8_796, m_carrier_right_2*s8_794);
  const double s8_800 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s8_801 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s8_802 = s8_800 + s8_801;
  work.f_carrier_right_x = mbgen::fnma(s7_161, s8_802, mbgen::fma(s7_164, s8_798, s8_799));
  const double s8_803 = p_upper_arm_right_x*work.s8_32;
  const double s8_804 = mbgen::fnma(work.s2_223, work.s8_33, s8_803 - work.s6_102);
  const double s8_805 = mbgen::fnma(work.r_carrier_right_aux1_y, work.s8_57, s8_804);
  const double s8_806 = mbgen::fnma(work.s6_99, work.s8_23, s8_805);
  const double s8_807 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_y, s8_795);
  const double s8_808 = mbgen::fnma(s7_167, s8_794, mbgen::fma(s7_161, s8_806, work.s8_686));
  const double s8_809 = work.zdd_star_carrier_right_rz + work.s4_26;
  const double s8_810 = mbgen::fms(work.w_carrier_right_y, work.w_carrier_right_z, s8_809);
  const double s8_811 = mbgen::fma(s7_161, s8_807, m_carrier_right_2*s8_806);
  const double s8_812 = mbgen::fma(s7_185, s8_810, mbgen::fma(s7_190, s8_807, s8_808));
  const double s8_813 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_801);
  work.f_carrier_right_y = mbgen::fnma(s7_167, s8_813, mbgen::fma(s7_164, s8_810, s8_811));
  const double s8_814 = mbgen::fnma(work.s5_39, work.s3_37, tau[Coordinate::lower_arm_right]);
  const double s8_815 = p_upper_arm_right_x*work.s8_41;
  const double s8_816 = mbgen::fma(work.s6_151, work.s8_23, work.s6_105 + s8_815);
  const double s8_817 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_33, s8_816);
  const double s8_818 = mbgen::fma(work.s2_223, work.s8_44, s8_817);
  const double s8_819 = mbgen::fnma(s7_161, s8_818, mbgen::fma(s7_164, s8_794, work.s8_688));
  const double s8_820 = mbgen::fma(work.w_carrier_right_y, work.w_carrier_right_z, s8_809);
  const double s8_821 = mbgen::fnma(s7_164, s8_806, mbgen::fma(s7_167, s8_818, work.s8_689));
  const double s8_822 = mbgen::fma(s7_194, s8_798, mbgen::fma(s7_179, s8_796, s8_819));
  const double s8_823 = mbgen::fms(work.w_carrier_right_x, work.w_carrier_right_z, s8_797);
  const double s8_824 = mbgen::fma(s7_167, s8_820, m_carrier_right_2*s8_818);
  const double s8_825 = mbgen::fma(s7_188, s8_823, mbgen::fma(s7_193, s8_820, s8_821));
  const double s8_826 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_800);
  work.f_carrier_right_z = mbgen::fnma(s7_164, s8_826, mbgen::fma(s7_161, s8_823, s8_824));
  const double s8_827 = mbgen::fnma(work.s1_37, work.f_carrier_right_y, s8_814);
  const double s8_828 = mbgen::fnma(s7_194, s8_810, mbgen::fnma(s7_185, s8_807, s8_825));
  work.n_carrier_right_x = mbgen::fma(s7_179, s8_813 - s8_826, s8_828);
  const double s8_829 = mbgen::fnma(work.s1_35, work.f_carrier_right_z, s8_827);
  const double s8_830 = mbgen::fnma(work.s8_785, work.n_carrier_right_x, s8_829);
  const double s8_831 = mbgen::fnma(s7_190, s8_823, mbgen::fnma(s7_188, s8_820, s8_822));
  work.n_carrier_right_y = mbgen::fma(s7_185, s8_826 - s8_802, s8_831);
  work.s8_832 = work.s5_42 - work.n_carrier_right_y;
  const double s8_833 = mbgen::fnma(s7_179, s8_798, mbgen::fnma(s7_193, s8_796, s8_812));
  const double n_carrier_right_z = mbgen::fma(s7_188, s8_802 - s8_813, s8_833);
  work.s8_834 = work.s5_34 - n_carrier_right_z;
  work.s8_835 = 395.1 + s7_161;
  const double s8_836 = mbgen::fnma(work.s2_223, work.s8_835, s8_730);
  const double s8_837 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_835, s8_731);
  work.s8_838 = mbgen::fma(109.75, work.r_carrier_right_aux1_y, s7_167);
  work.s8_839 = mbgen::fnma(109.75, work.s2_223, s7_164);
  const double s8_840 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_839, s8_732);
  const double s8_841 = mbgen::fnma(work.s2_223, work.s8_838, s8_840);
  const double s8_842 = mbgen::fnma(work.s2_223 + work.s2_223, work.s8_839, s8_735);
  const double s8_843 = s7_195 - s7_193;
  const double s8_844 = work.Rz_carrier_right_rx_2*s8_843;
  const double s8_845 = mbgen::fnma(work.Rz_carrier_right_rz_2, s7_188, s8_844);
  const double s8_846 = mbgen::fnma(work.Rz_carrier_right_ry_2, s7_179, s8_845);
  const double s8_847 = work.Rz_carrier_right_rx_1*s8_843;
  const double s8_848 = mbgen::fnma(work.Rz_carrier_right_ry_1, s7_179, s8_847);
  const double s8_849 = mbgen::fnma(s7_188, work.s8_785, s8_848);
  work.s8_850 = mbgen::fnma(work.s1_35, s7_161, s8_849);
  const double s8_851 = s7_195 - s7_194;
  const double s8_852 = work.Rz_carrier_right_ry_2*s8_851;
  const double s8_853 = mbgen::fnma(work.Rz_carrier_right_rz_2, s7_185, s8_852);
  const double s8_854 = mbgen::fnma(work.Rz_carrier_right_rx_2, s7_179, s8_853);
  const double s8_855 = mbgen::fma(work.Rz_carrier_right_ry_1, s8_851, work.s1_37*s7_161);
  const double s8_856 = mbgen::fnma(s7_185, work.s8_785, s8_855);
  work.s8_857 = mbgen::fnma(work.Rz_carrier_right_rx_1, s7_179, s8_856);
  const double s8_858 = mbgen::fma(work.Rz_carrier_right_rx_1, s8_846, s8_778);
  const double s8_859 = s7_195 - s7_190;
  const double s8_860 = work.Rz_carrier_right_rz_2*s8_859;
  const double s8_861 = mbgen::fnma(work.Rz_carrier_right_ry_2, s7_185, s8_860);
  const double s8_862 = mbgen::fnma(work.Rz_carrier_right_rx_2, s7_188, s8_861);
  const double s8_863 = mbgen::fnma(work.s1_37, s7_164, work.s1_35*s7_167);
  const double s8_864 = mbgen::fma(work.s8_785, s8_859, s8_863);
  const double s8_865 = mbgen::fnma(work.Rz_carrier_right_ry_1, s7_185, s8_864);
  work.s8_866 = mbgen::fnma(work.Rz_carrier_right_rx_1, s7_188, s8_865);
  const double s8_867 = mbgen::fma(work.Rz_carrier_right_ry_1, s8_854, s8_858);
  const double s8_868 = mbgen::fma(work.s8_785, s8_862, s8_867);
  const double s8_869 = work.r_carrier_right_aux1_y + work.r_carrier_right_aux1_y;
  const double s8_870 = mbgen::fma(work.s8_838, s8_869, s8_733);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s8_871 = mbgen::fma(zd_lower_arm_right, work.s8_23, work.s6_101);
  work.s8_872 = zd_lower_arm_right*work.s8_28;
  work.s8_873 = zd_lower_arm_right*work.s8_13;
  work.s8_874 = mbgen::fnma(work.s7_143, work.s8_872, work.s7_141*work.s8_873);
  const double s8_875 = mbgen::fnma((-p_lower_arm_right_z), work.s8_33, s8_803);
  const double s8_876 = mbgen::fma((-p_lower_arm_right_y), work.s8_57, s8_875);
  const double s8_877 = mbgen::fma((-p_lower_arm_right_z), work.s8_44, s8_815);
  const double s8_878 = mbgen::fnma((-p_pitman_arm_z), work.s8_33, s8_877);
  const double s8_879 = mbgen::fnma(work.s7_143, s8_876, s8_830);
  const double s8_880 = mbgen::fnma(work.s7_141, s8_878, s8_879);
  // arb_front_left: arb_front_left, revolute, chassis
  work.s8_881 = work.Rz_arb_front_left_0*s7_139;
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  work.s8_882 = zd_arb_front_left*work.s8_28;
  work.s8_883 = zd_arb_front_left*work.s8_23;
  work.s8_884 = mbgen::fma(work.s7_130, work.s8_883, work.s7_128*work.s8_882);
  const double s8_885 = mbgen::fnma(work.zdd_star_arb_front_left, work.s7_138,
      tau[Coordinate::arb_front_left]);
  const double s8_886 = mbgen::fms((-p_arb_rear_right_y), work.s8_32, work.s8_56);
  const double s8_887 = mbgen::fma((-p_arb_rear_right_z), work.s8_33, work.s8_48);
  const double s8_888 = mbgen::fnma(work.s7_128, s8_886, s8_885);
  const double s8_889 = mbgen::fma(work.s7_130, s8_887, s8_888);
  const double s8_890 = mbgen::fnma(work.s8_32, work.s7_124, s8_889);
  const double s8_891 = mbgen::fma(work.s8_33, work.s7_126, s8_890);
  const double s8_892 = mbgen::fnma(work.s8_41, work.s7_137 - work.s7_136, s8_891);
  work.s8_893 = mbgen::fnma(work.s7_135, work.s8_772, s8_892);
  // upper_arm_left: upper_arm_left, revolute, chassis
  work.s8_894 = work.s3_19*s7_122;
  const double s8_895 = work.Rz_arb_front_left_0*work.s8_881;
  const double s8_896 = mbgen::fma(work.s3_19, work.s8_894, s8_895);
  const double s8_897 = work.Rz_upper_arm_left_2*s7_122;
  const double s8_898 = work.Rz_arb_front_left_2*s7_139;
  const double s8_899 = mbgen::fnma(work.s3_19, s8_897, work.Rz_arb_front_left_0*s8_898);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  work.s8_900 = zd_upper_arm_left*work.s8_13;
  work.s8_901 = zd_upper_arm_left*work.s8_28;
  work.s8_902 = mbgen::fma(work.s7_113, work.s8_901, work.s7_111*work.s8_900);
  const double s8_903 = mbgen::fnma((-p_upper_arm_right_z), work.s8_33, s8_803);
  const double s8_904 = mbgen::fma((-p_upper_arm_right_z), work.s8_44, s8_815);
  work.s8_905 = work.s6_165*s7_121;
  const double s8_906 = mbgen::fms(work.s7_111, s8_761 + s8_904, work.s8_905);
  const double s8_907 = mbgen::fnma(p_pitman_arm_y, work.s8_57, s8_903);
  const double s8_908 = mbgen::fnma(work.s7_113, s8_907, s8_906);
  const double s8_909 = work.s8_57 - work.s8_44;
  const double s8_910 = mbgen::fma(work.s8_33, work.s7_119 - work.s7_120, s8_908);
  work.s8_911 = mbgen::fma(work.s7_118, s8_909, s8_910);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_912 = mbgen::fnma(work.s3_21, work.s7_80, m_carrier_left_2*work.s8_747);
  work.s8_913 = mbgen::fnma(work.s7_74, work.s8_744, s8_912);
  const double s8_914 = mbgen::fma(work.s3_25, work.s7_80, m_carrier_left_2*s8_749);
  const double s8_915 = mbgen::fma(work.Rz_lower_arm_left_2, work.s7_77, s8_914);
  const double s8_916 = mbgen::fma(work.s3_24, work.s7_80, m_carrier_left_2*s8_750);
  const double s8_917 = mbgen::fma(work.Rz_lower_arm_left_2, work.s7_74, s8_916);
  const double s8_918 = mbgen::fma(work.s7_77, work.s8_744, work.s3_22*work.s7_80);
  work.s8_919 = mbgen::fnma(m_carrier_left_2, work.s8_745, s8_918);
  // tie_rod_left
  const double s8_920 = mbgen::fma(work.s8_747, work.s8_913, s8_896);
  const double s8_921 = mbgen::fnma(work.s8_745, work.s8_919, s8_920);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_922 = mbgen::fms(work.s6_85, work.s8_13, s8_790);
  const double s8_923 = mbgen::fma(work.s6_129, work.s8_28, s8_922);
  const double s8_924 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_32, s8_923);
  const double s8_925 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_41, s8_924);
  const double s8_926 = work.zdd_star_carrier_left_ry + work.s4_43;
  const double s8_927 = mbgen::fms(work.w_carrier_left_x, work.w_carrier_left_y, s8_926);
  const double s8_928 = work.zdd_star_carrier_left_rx + work.s4_44;
  const double s8_929 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_z, s8_928);
  const double s8_930 = mbgen::fma(work.s7_77, s8_927, m_carrier_left_2*s8_925);
  const double s8_931 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s8_932 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s8_933 = s8_931 + s8_932;
  work.f_carrier_left_x = mbgen::fnma(work.s7_80, s8_933, mbgen::fma(work.s7_74, s8_929, s8_930));
  const double s8_934 = s8_803 - work.s6_88;
  const double s8_935 = mbgen::fnma(work.s1_13, work.zdd_star_lower_arm_left, s8_934);
  const double s8_936 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_33, s8_935);
  const double s8_937 = mbgen::fnma(work.r_carrier_left_aux1_y, work.s8_57, s8_936);
  const double s8_938 = mbgen::fnma(work.s6_85, work.s8_23, s8_937);
  const double s8_939 = mbgen::fma(work.s7_80, s8_938, work.s8_692);
  const double s8_940 = work.zdd_star_lower_arm_left + work.s4_15;
  const double s8_941 = mbgen::fms(work.w_carrier_left_y, work.w_carrier_left_z, s8_940);
  const double s8_942 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_y, s8_926);
  const double s8_943 = mbgen::fma(work.s7_74, s8_941, m_carrier_left_2*s8_938);
  const double s8_944 = mbgen::fma(work.s7_98, s8_941, mbgen::fnma(work.s7_77, s8_925, s8_939));
  const double s8_945 = mbgen::fma(work.s7_107, s8_942, s8_944);
  const double s8_946 = mbgen::fnma(work.s7_104, s8_927, s8_945);
  const double s8_947 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_932);
  work.f_carrier_left_y = mbgen::fnma(work.s7_77, s8_947, mbgen::fma(work.s7_80, s8_942, s8_943));
  const double s8_948 = mbgen::fma(work.s1_11, work.zdd_star_lower_arm_left, s8_815);
  const double s8_949 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_33, s8_948 - work.s6_91);
  const double s8_950 = mbgen::fnma(work.r_carrier_left_aux1_z, work.s8_44, s8_949);
  const double s8_951 = mbgen::fnma(work.s6_129, work.s8_23, s8_950);
  const double s8_952 = mbgen::fma(work.s7_77, s8_951, work.s8_695);
  const double s8_953 = mbgen::fma(work.s7_74, s8_925, work.s8_694);
  const double s8_954 = mbgen::fma(work.s7_93, s8_927, mbgen::fnma(work.s7_80, s8_951, s8_953));
  const double s8_955 = mbgen::fma(work.w_carrier_left_y, work.w_carrier_left_z, s8_940);
  const double s8_956 = mbgen::fms(work.w_carrier_left_x, work.w_carrier_left_z, s8_928);
  const double s8_957 = mbgen::fma(work.s7_77, s8_955, m_carrier_left_2*s8_951);
  const double s8_958 = mbgen::fma(work.s7_104, s8_955, mbgen::fnma(work.s7_74, s8_938, s8_952));
  const double s8_959 = mbgen::fnma(work.s7_98, s8_942, mbgen::fma(work.s7_101, s8_956, s8_958));
  const double s8_960 = mbgen::fnma(work.s7_101, s8_955, mbgen::fma(s7_108, s8_929, s8_954));
  const double s8_961 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_931);
  work.f_carrier_left_z = mbgen::fnma(work.s7_74, s8_961, mbgen::fma(work.s7_80, s8_956, s8_957));
  const double s8_962 = mbgen::fnma(s8_749, work.f_carrier_left_z, s8_743);
  const double s8_963 = mbgen::fma(s8_750, work.f_carrier_left_y, s8_962);
  const double s8_964 = mbgen::fnma(s7_108, s8_941, s8_959);
  work.n_carrier_left_x = mbgen::fma(work.s7_93, s8_947 - s8_961, s8_964);
  const double s8_965 = mbgen::fnma(work.s7_107, s8_956, s8_960);
  work.n_carrier_left_y = mbgen::fma(work.s7_98, s8_961 - s8_933, s8_965);
  work.s8_966 = work.n_carrier_left_y - work.s5_26;
  const double s8_967 = mbgen::fnma(work.s7_93, s8_929, s8_946);
  const double n_carrier_left_z = mbgen::fma(work.s7_101, s8_933 - s8_947, s8_967);
  work.s8_968 = n_carrier_left_z - work.s5_18;
  work.s8_969 = n_carrier_right_z + (work.s8_665 + n_carrier_left_z);
  const double s8_970 = work.Rz_arb_front_right_2*work.s7_210;
  const double s8_971 = s8_722 + mbgen::fma(work.Rz_arb_front_left_2, work.s7_128, work.s8_697);
  const double s8_972 = work.s3_60*work.s7_230;
  work.s8_973 = s8_972 + (s8_970 + s8_971) - work.s7_241;
  const double s8_974 = s7_109 - s7_108;
  const double s8_975 = mbgen::fnma(work.s3_24, s8_974, work.s8_706);
  const double s8_976 = mbgen::fnma(work.s7_80, s8_750, s8_975);
  const double s8_977 = mbgen::fnma(work.s7_98, work.s8_744, s8_748);
  work.s8_978 = mbgen::fnma(work.s3_21, s8_974, s8_977);
  const double s8_979 = s7_109 - work.s7_104;
  const double s8_980 = mbgen::fnma(work.s3_25, s8_979, work.s8_705);
  const double s8_981 = mbgen::fnma(work.s7_80, s8_749, s8_980);
  const double s8_982 = mbgen::fnma(work.s7_101, work.s8_744, s8_746);
  work.s8_983 = mbgen::fnma(work.s3_22, s8_979, s8_982);
  work.s8_984 = mbgen::fma(109.75, work.r_carrier_left_aux1_z, work.s7_74);
  work.s8_985 = mbgen::fma(109.75, work.r_carrier_left_aux1_y, work.s7_77);
  const double s8_986 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_984, s8_841);
  const double s8_987 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_985, s8_986);
  work.s8_988 = 395.1 + work.s7_80;
  const double s8_989 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_988, s8_836);
  const double s8_990 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_988, s8_837);
  const double s8_991 = work.r_carrier_left_aux1_z + work.r_carrier_left_aux1_z;
  const double s8_992 = mbgen::fma(work.s8_984, s8_991, s8_842);
  const double s8_993 = work.r_carrier_left_aux1_y + work.r_carrier_left_aux1_y;
  const double s8_994 = mbgen::fma(work.s8_985, s8_993, s8_870);
  const double s8_995 = s7_109 - work.s7_107;
  const double s8_996 = mbgen::fma(work.s3_24, work.s7_98, s8_752);
  const double s8_997 = mbgen::fma(work.Rz_lower_arm_left_2, s8_995, s8_996);
  const double s8_998 = mbgen::fma(work.s8_744, s8_995, work.s8_707);
  const double s8_999 = mbgen::fnma(work.s7_77, work.s8_745, s8_998);
  work.s8_1000 = mbgen::fnma(work.s7_74, work.s8_747, s8_999);
  const double s8_1001 = mbgen::fma(work.s8_744, work.s8_1000, s8_921);
  const double s8_1002 = mbgen::fnma(work.s3_21, work.s8_978, s8_1001);
  const double s8_1003 = mbgen::fnma(work.s3_22, work.s8_983, s8_1002);
  const double s8_1004 = mbgen::fnma(work.s3_21, s8_976, mbgen::fma(work.s8_744, s8_997, s8_899));
  const double s8_1005 = mbgen::fnma(work.s3_22, s8_981, s8_1004);
  const double s8_1006 = mbgen::fnma(work.s8_745, s8_915, s8_1005);
  const double s8_1007 = mbgen::fnma(work.s8_747, s8_917, s8_1006);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s8_1008 = work.s7_241 + (work.s7_197 + (work.s7_141 + (work.s7_54 + work.s7_111)));
  work.s8_1009 = 5.25 + s8_1008;
  const double s8_1010 = work.Rz_lower_arm_left_2*work.s7_54;
  const double s8_1011 = mbgen::fma(work.Rz_upper_arm_left_2, work.s7_111, s8_915 + s8_1010);
  const double s8_1012 = work.s3_60*work.s7_229;
  const double s8_1013 = work.Rz_arb_front_right_2*work.s7_212;
  const double s8_1014 = work.s3_38*work.s7_197;
  const double s8_1015 = s8_724 + s8_1011 - s8_1012 - s8_1013 - s8_1014;
  work.s8_1016 = mbgen::fnma(work.Rz_arb_front_left_2, work.s7_130, s8_1015);
  const double s8_1017 = work.s3_38*work.s7_199;
  const double s8_1018 = s8_726 - work.s7_243 - s8_1017;
  const double s8_1019 = work.Rz_lower_arm_left_2*work.s7_56;
  const double s8_1020 = mbgen::fnma(work.Rz_upper_arm_left_2, work.s7_113, s8_1018) - s8_917;
  work.s8_1021 = s8_1020 - s8_1019;
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s8_1022 = mbgen::fma(zd_lower_arm_left, work.s8_23, work.s6_87);
  const double s8_1023 = work.zdd_star_lower_arm_left*work.s7_54;
  work.s8_1024 = mbgen::fnma(work.s7_56, s8_1022, s8_1023);
  work.s8_1025 = mbgen::fma(work.s7_54, s8_1022, work.zdd_star_lower_arm_left*work.s7_56);
  work.s8_1026 = work.s3_20*work.s7_65;
  const double s8_1027 = mbgen::fma(work.s3_20, work.s8_1026, s8_1003);
  work.s8_1028 = zd_lower_arm_left*work.s8_13;
  work.s8_1029 = zd_lower_arm_left*work.s8_28;
  work.s8_1030 = mbgen::fma(work.s7_56, work.s8_1029, work.s7_54*work.s8_1028);
  const double s8_1031 = work.Rz_lower_arm_left_2*work.s7_65;
  const double s8_1032 = mbgen::fnma(work.s3_20, s8_1031, s8_1007);
  work.s8_1033 = work.zdd_star_lower_arm_left*work.s7_64;
  const double s8_1034 = mbgen::fma((-p_pitman_arm_z), work.s8_33, s8_877);
  const double s8_1035 = mbgen::fnma((-p_lower_arm_right_y), work.s8_57, s8_875);
  const double s8_1036 = mbgen::fma(work.s7_54, s8_1034, work.s8_1033);
  const double s8_1037 = mbgen::fnma(work.s7_56, s8_1035, s8_1036);
  const double s8_1038 = mbgen::fma(work.s8_33, work.s7_62 - work.s7_63, s8_1037);
  work.s8_1039 = mbgen::fma(work.s7_61, s8_909, s8_1038);
  // arb_link_front_left
  work.s8_1040 = 0.3333333333333333*work.s2_206;
  const double s8_1041 = mbgen::fnma(work.s2_199, work.s8_1040, s8_987);
  const double s8_1042 = mbgen::fnma(work.s2_206, work.s8_1040, s8_994);
  work.s8_1043 = 0.3333333333333333*work.s2_193;
  const double s8_1044 = mbgen::fnma(work.s2_199, work.s8_1043, s8_989);
  const double s8_1045 = mbgen::fnma(work.s2_206, work.s8_1043, s8_990);
  const double s8_1046 = mbgen::fnma(work.s2_193, work.s8_1043, s8_734);
  work.s8_1047 = 0.3333333333333333*work.s2_199;
  const double s8_1048 = mbgen::fnma(work.s2_199, work.s8_1047, s8_992);
  const double s8_1049 = mbgen::fma(work.s2_192, work.s3_24, s8_750);
  const double s8_1050 = mbgen::fma(work.s2_196, work.Rz_lower_arm_left_2, s8_1049);
  const double s8_1051 = mbgen::fnma(work.s2_192, work.s3_21, work.s8_747);
  work.s8_1052 = mbgen::fnma(work.s2_196, work.s8_744, s8_1051);
  const double s8_1053 = mbgen::fma(work.s2_189, work.Rz_arb_front_left_2, s8_749);
  const double s8_1054 = mbgen::fma(work.s2_192, work.s3_25, s8_1053);
  const double s8_1055 = mbgen::fma(work.s2_203, work.Rz_lower_arm_left_2, s8_1054);
  const double s8_1056 = mbgen::fma(work.s3_34, work.s3_34, s8_1050*s8_1050);
  const double s8_1057 = mbgen::fma(s8_1055, s8_1055, s8_1056);
  const double s8_1058 = mbgen::fma(work.s3_44, work.s3_44, s8_1057);
  const double s8_1059 = mbgen::fma(work.s3_55, work.s3_55, s8_1058);
  const double s8_1060 = mbgen::fma(work.s3_58, work.s3_58, s8_1059);
  const double s8_1061 = mbgen::fms(work.s2_189, work.Rz_arb_front_left_0, work.s8_745);
  const double s8_1062 = mbgen::fma(work.s2_192, work.s3_22, s8_1061);
  work.s8_1063 = mbgen::fma(work.s2_203, work.s8_744, s8_1062);
  const double s8_1064 = mbgen::fma(work.s3_31, work.s3_31, work.s8_1052*work.s8_1052);
  const double s8_1065 = mbgen::fma(s8_1055, work.s8_1063, work.s3_34*work.s3_31);
  const double s8_1066 = mbgen::fma(work.s8_1063, work.s8_1063, s8_1064);
  const double s8_1067 = mbgen::fnma(0.3333333333333333, s8_1066, s8_1027);
  const double s8_1068 = mbgen::fnma(s8_1050, work.s8_1052, s8_1065);
  const double s8_1069 = mbgen::fnma(0.3333333333333333, s8_1068, s8_1032);
  const double s8_1070 = mbgen::fms(work.s8_32, work.s2_206, work.s6_84);
  const double s8_1071 = mbgen::fma(work.s8_41, work.s2_199, s8_1070);
  const double s8_1072 = mbgen::fnma(work.s8_49, work.s2_193, s8_1071);
  const double s8_1073 = mbgen::fma(work.s8_28, work.s6_168, s8_1072);
  const double s8_1074 = mbgen::fnma(work.s8_13, work.s6_86, s8_1073);
  const double s8_1075 = mbgen::fma(work.s2_187, work.zdd_star_arb_front_left, s8_1074);
  const double s8_1076 = mbgen::fnma(work.s2_196, work.zdd_star_carrier_left_rx, s8_1075);
  const double s8_1077 = mbgen::fma(work.s2_203, work.zdd_star_carrier_left_ry, s8_1076);
  work.s8_1078 = 0.3333333333333333*s8_1077;
  const double s8_1079 = mbgen::fms(work.s1_13, work.zdd_star_lower_arm_left, work.s6_90);
  const double s8_1080 = mbgen::fma(work.s8_32, work.s2_193, s8_1079);
  const double s8_1081 = mbgen::fma(work.s8_33, work.s2_199, s8_1080);
  const double s8_1082 = mbgen::fnma(work.s8_57, work.s2_206, s8_1081);
  const double s8_1083 = mbgen::fma(work.s8_23, work.s6_86, s8_1082);
  const double s8_1084 = mbgen::fma(work.s8_28, work.s6_95, s8_1083);
  const double s8_1085 = mbgen::fnma(work.s2_192, work.zdd_star_carrier_left_ry, s8_1084);
  const double s8_1086 = mbgen::fma(work.s2_196, work.zdd_star_lower_arm_left, s8_1085);
  work.s8_1087 = 0.3333333333333333*s8_1086;
  const double s8_1088 = mbgen::fms(work.s8_33, work.s2_206, work.s6_94);
  const double s8_1089 = mbgen::fnma(work.s1_11, work.zdd_star_lower_arm_left, s8_1088);
  const double s8_1090 = mbgen::fma(work.s8_41, work.s2_193, s8_1089);
  const double s8_1091 = mbgen::fnma(work.s8_44, work.s2_199, s8_1090);
  const double s8_1092 = mbgen::fnma(work.s8_23, work.s6_168, s8_1091);
  const double s8_1093 = mbgen::fnma(work.s8_13, work.s6_95, s8_1092);
  const double s8_1094 = mbgen::fnma(work.s2_189, work.zdd_star_arb_front_left, s8_1093);
  const double s8_1095 = mbgen::fnma(work.s2_203, work.zdd_star_lower_arm_left, s8_1094);
  const double s8_1096 = mbgen::fma(work.s2_192, work.zdd_star_carrier_left_rx, s8_1095);
  work.s8_1097 = 0.3333333333333333*s8_1096;
  const double s8_1098 = mbgen::fnma(s8_1055, work.s8_1097, s8_963);
  const double s8_1099 = mbgen::fma(work.s3_34, work.s8_1078, s8_1098);
  const double s8_1100 = mbgen::fma(s8_1050, work.s8_1087, s8_1099);
  // arb_link_front_right
  work.s8_1101 = 0.3333333333333333*work.s2_218;
  const double s8_1102 = mbgen::fnma(work.s2_224, work.s8_1101, s8_1044);
  const double s8_1103 = mbgen::fma(work.s2_231, work.s8_1101, s8_1045);
  const double s8_1104 = mbgen::fnma(work.s2_218, work.s8_1101, s8_1046);
  work.s8_1105 = 0.3333333333333333*work.s2_224;
  const double s8_1106 = mbgen::fnma(work.s2_224, work.s8_1105, s8_1048);
  work.s8_1107 = 0.3333333333333333*work.s2_231;
  const double s8_1108 = mbgen::fma(work.s2_224, work.s8_1107, s8_1041);
  const double s8_1109 = mbgen::fnma(work.s2_231, work.s8_1107, s8_1042);
  const double s8_1110 = mbgen::fma(work.s2_217, work.Rz_carrier_right_ry_1, work.s1_37);
  work.s8_1111 = mbgen::fnma(work.s2_221, work.s8_785, s8_1110);
  const double s8_1112 = mbgen::fma(work.s2_214, work.Rz_arb_front_right_1, work.s1_35);
  const double s8_1113 = mbgen::fma(work.s2_228, work.s8_785, s8_1112);
  work.s8_1114 = mbgen::fnma(work.s2_217, work.Rz_carrier_right_rx_1, s8_1113);
  const double s8_1115 = mbgen::fma(work.s3_58, work.s3_52, work.s3_44*work.s8_1111);
  const double s8_1116 = mbgen::fma(work.s3_52, work.s3_52, work.s8_1111*work.s8_1111);
  const double s8_1117 = mbgen::fma(work.s8_1114, work.s8_1114, s8_1116);
  const double s8_1118 = mbgen::fma(work.s3_55, work.s8_1114, s8_1115);
  const double s8_1119 = mbgen::fnma(0.3333333333333333, s8_1118, s8_868);
  const double s8_1120 = mbgen::fms(work.s8_57, work.s2_231, work.s6_104);
  const double s8_1121 = mbgen::fma(work.s8_32, work.s2_218, s8_1120);
  const double s8_1122 = mbgen::fma(work.s8_33, work.s2_224, s8_1121);
  const double s8_1123 = mbgen::fma(work.s8_23, work.s6_100, s8_1122);
  const double s8_1124 = mbgen::fma(work.s8_28, work.s6_109, s8_1123);
  const double s8_1125 = mbgen::fnma(work.s2_217, work.zdd_star_carrier_right_ry, s8_1124);
  const double s8_1126 = mbgen::fma(work.s2_221, work.zdd_star_carrier_right_rz, s8_1125);
  work.s8_1127 = 0.3333333333333333*s8_1126;
  const double s8_1128 = mbgen::fms(work.s8_41, work.s2_224, work.s6_98);
  const double s8_1129 = mbgen::fnma(work.s8_49, work.s2_218, s8_1128);
  const double s8_1130 = mbgen::fnma(work.s8_32, work.s2_231, s8_1129);
  const double s8_1131 = mbgen::fma(work.s8_28, work.s6_184, s8_1130);
  const double s8_1132 = mbgen::fnma(work.s8_13, work.s6_100, s8_1131);
  const double s8_1133 = mbgen::fma(work.s2_212, work.zdd_star_arb_front_right, s8_1132);
  const double s8_1134 = mbgen::fnma(work.s2_221, work.zdd_star_carrier_right_rx, s8_1133);
  const double s8_1135 = mbgen::fma(work.s2_228, work.zdd_star_carrier_right_ry, s8_1134);
  work.s8_1136 = 0.3333333333333333*s8_1135;
  const double s8_1137 = mbgen::fms(work.s8_41, work.s2_218, work.s6_108);
  const double s8_1138 = mbgen::fnma(work.s8_44, work.s2_224, s8_1137);
  const double s8_1139 = mbgen::fnma(work.s8_33, work.s2_231, s8_1138);
  const double s8_1140 = mbgen::fnma(work.s8_23, work.s6_184, s8_1139);
  const double s8_1141 = mbgen::fnma(work.s8_13, work.s6_109, s8_1140);
  const double s8_1142 = mbgen::fnma(work.s2_214, work.zdd_star_arb_front_right, s8_1141);
  const double s8_1143 = mbgen::fnma(work.s2_228, work.zdd_star_carrier_right_rz, s8_1142);
  const double s8_1144 = mbgen::fma(work.s2_217, work.zdd_star_carrier_right_rx, s8_1143);
  work.s8_1145 = 0.3333333333333333*s8_1144;
  const double s8_1146 = mbgen::fnma(work.s3_44, work.s8_1127, s8_1100);
  const double s8_1147 = mbgen::fnma(work.s3_55, work.s8_1145, s8_1146);
  const double s8_1148 = mbgen::fma(work.s3_58, work.s8_1136, s8_1147);
  const double s8_1149 = mbgen::fnma(work.s8_1111, work.s8_1127, s8_880);
  const double s8_1150 = mbgen::fnma(work.s8_1114, work.s8_1145, s8_1149);
  const double s8_1151 = mbgen::fma(work.s3_52, work.s8_1136, s8_1150);
  // drag_link
  const double s8_1152 = work.s2_236*work.s3_60;
  const double s8_1153 = 1.5*work.s2_242;
  const double s8_1154 = mbgen::fnma(work.s2_240, s8_1153, s8_1108);
  const double s8_1155 = mbgen::fnma(work.s2_242, s8_1153, s8_1109);
  const double s8_1156 = 1.5*work.s2_240;
  const double s8_1157 = mbgen::fnma(work.s2_240, s8_1156, s8_1106);
  const double s8_1158 = 1.5*work.s2_238;
  const double s8_1159 = mbgen::fnma(work.s2_240, s8_1158, s8_1102);
  const double s8_1160 = mbgen::fnma(work.s2_242, s8_1158, s8_1103);
  const double s8_1161 = mbgen::fnma(work.s2_238, s8_1158, s8_1104);
  const double s8_1162 = mbgen::fma(work.s2_239, work.s3_60, work.s2_241);
  const double s8_1163 = mbgen::fma(s8_1152, s8_1152, work.s2_237*work.s2_237);
  const double s8_1164 = mbgen::fma(s8_1162, s8_1162, s8_1163);
  const double s8_1165 = mbgen::fma(work.s8_28, work.s6_115, work.s6_117);
  const double s8_1166 = mbgen::fnma(work.s8_23, work.s6_110, s8_1165);
  const double s8_1167 = mbgen::fma(work.s8_32, work.s2_238, s8_1166);
  const double s8_1168 = mbgen::fma(work.s8_33, work.s2_240, s8_1167);
  work.s8_1169 = 1.5*mbgen::fnma(work.s8_57, work.s2_242, s8_1168);
  const double s8_1170 = mbgen::fma(work.s8_32, work.s2_242, work.s6_112);
  const double s8_1171 = mbgen::fma(work.s8_41, work.s2_240, s8_1170);
  const double s8_1172 = mbgen::fnma(work.s8_49, work.s2_238, s8_1171);
  const double s8_1173 = mbgen::fma(work.s2_239, work.s6_192, s8_1172);
  const double s8_1174 = mbgen::fma(work.s8_13, work.s6_110, s8_1173);
  work.s8_1175 = 1.5*mbgen::fnma(work.s8_28, work.s6_111, s8_1174);
  const double s8_1176 = mbgen::fma(work.s8_33, work.s2_242, work.s6_119);
  const double s8_1177 = mbgen::fma(work.s8_41, work.s2_238, s8_1176);
  const double s8_1178 = mbgen::fnma(work.s8_44, work.s2_240, s8_1177);
  const double s8_1179 = mbgen::fnma(work.s2_236, work.s6_192, s8_1178);
  const double s8_1180 = mbgen::fma(work.s8_23, work.s6_111, s8_1179);
  work.s8_1181 = 1.5*mbgen::fnma(work.s8_13, work.s6_115, s8_1180);
  const double s8_1182 = mbgen::fnma(s8_1152, work.s8_1181, s8_1148);
  const double s8_1183 = mbgen::fma(s8_1162, work.s8_1175, s8_1182);
  const double s8_1184 = mbgen::fma(work.s2_237, work.s8_1169, s8_1183);
  // tie_rod_left
  work.s8_1185 = 1.1666666666666667*work.s2_252;
  const double s8_1186 = mbgen::fma(work.s2_246, work.s8_1185, s8_1154);
  const double s8_1187 = mbgen::fnma(work.s2_252, work.s8_1185, s8_1155);
  work.s8_1188 = 1.1666666666666667*work.s2_260;
  const double s8_1189 = mbgen::fnma(work.s2_246, work.s8_1188, s8_1159);
  const double s8_1190 = mbgen::fma(work.s2_252, work.s8_1188, s8_1160);
  const double s8_1191 = mbgen::fnma(work.s2_260, work.s8_1188, s8_1161);
  const double s8_1192 = mbgen::fma(work.s2_248, work.s3_24, work.s2_251);
  const double s8_1193 = mbgen::fnma(work.s2_245, work.s3_25, s8_1192);
  const double s8_1194 = mbgen::fma(work.s2_255, work.s3_25, s8_749);
  const double s8_1195 = mbgen::fma(work.s2_248, work.Rz_lower_arm_left_2, s8_1194);
  const double s8_1196 = mbgen::fnma(work.s2_255, work.s3_21, work.s8_747);
  work.s8_1197 = mbgen::fnma(work.s2_245, work.s8_744, s8_1196);
  const double s8_1198 = mbgen::fms(work.s2_255, work.s3_22, work.s8_745);
  work.s8_1199 = mbgen::fma(work.s2_248, work.s8_744, s8_1198);
  const double s8_1200 = mbgen::fma(work.s3_23, work.s3_23, work.s8_1197*work.s8_1197);
  const double s8_1201 = mbgen::fma(work.s8_1199, work.s8_1199, s8_1200);
  work.s8_1202 = mbgen::fnma(1.1666666666666667, s8_1201, s8_1067);
  work.s8_1203 = 1.1666666666666667*work.s2_246;
  const double s8_1204 = mbgen::fnma(work.s2_246, work.s8_1203, s8_1157);
  const double s8_1205 = mbgen::fma(work.s2_255, work.s3_24, s8_750 - work.s2_259);
  const double s8_1206 = mbgen::fma(work.s2_245, work.Rz_lower_arm_left_2, s8_1205);
  const double s8_1207 = mbgen::fma(s8_1195, work.s8_1199, work.s3_23*s8_1193);
  const double s8_1208 = mbgen::fnma(work.s8_1197, s8_1206, s8_1207);
  work.s8_1209 = mbgen::fnma(1.1666666666666667, s8_1208, s8_1069);
  const double s8_1210 = mbgen::fma(s8_1195, s8_1195, s8_1193*s8_1193);
  const double s8_1211 = mbgen::fma(s8_1206, s8_1206, s8_1210);
  const double s8_1212 = mbgen::fma(work.s8_32, work.s2_252, work.s6_125);
  const double s8_1213 = mbgen::fnma(work.s8_41, work.s2_246, s8_1212);
  const double s8_1214 = mbgen::fma(work.s8_49, work.s2_260, s8_1213);
  const double s8_1215 = mbgen::fma(work.s8_28, work.s6_130, s8_1214);
  const double s8_1216 = mbgen::fnma(work.s8_13, work.s6_127, s8_1215);
  const double s8_1217 = mbgen::fnma(work.s2_245, work.zdd_star_carrier_left_rx, s8_1216);
  const double s8_1218 = mbgen::fma(work.s2_248, work.zdd_star_carrier_left_ry, s8_1217);
  work.s8_1219 = 1.1666666666666667*s8_1218;
  const double s8_1220 = mbgen::fms(work.s8_33, work.s2_252, work.s6_133);
  const double s8_1221 = mbgen::fnma(work.s1_11, work.zdd_star_lower_arm_left, s8_1220);
  const double s8_1222 = mbgen::fnma(work.s8_41, work.s2_260, s8_1221);
  const double s8_1223 = mbgen::fma(work.s8_44, work.s2_246, s8_1222);
  const double s8_1224 = mbgen::fma(work.s8_13, work.s6_128, s8_1223);
  const double s8_1225 = mbgen::fnma(work.s8_23, work.s6_130, s8_1224);
  const double s8_1226 = mbgen::fnma(work.s2_248, work.zdd_star_lower_arm_left, s8_1225);
  const double s8_1227 = mbgen::fma(work.s2_255, work.zdd_star_carrier_left_rx, s8_1226);
  work.s8_1228 = 1.1666666666666667*s8_1227;
  const double s8_1229 = mbgen::fnma(s8_1193, work.s8_1219, s8_1184);
  const double s8_1230 = mbgen::fms(work.s1_13, work.zdd_star_lower_arm_left, work.s6_137);
  const double s8_1231 = mbgen::fnma(work.s8_32, work.s2_260, s8_1230);
  const double s8_1232 = mbgen::fnma(work.s8_33, work.s2_246, s8_1231);
  const double s8_1233 = mbgen::fnma(work.s8_57, work.s2_252, s8_1232);
  const double s8_1234 = mbgen::fma(work.s8_23, work.s6_127, s8_1233);
  const double s8_1235 = mbgen::fnma(work.s8_28, work.s6_128, s8_1234);
  const double s8_1236 = mbgen::fnma(work.s2_255, work.zdd_star_carrier_left_ry, s8_1235);
  const double s8_1237 = mbgen::fma(work.s2_245, work.zdd_star_lower_arm_left, s8_1236);
  work.s8_1238 = 1.1666666666666667*s8_1237;
  const double s8_1239 = mbgen::fnma(s8_1195, work.s8_1228, s8_1229);
  const double s8_1240 = mbgen::fma(s8_1206, work.s8_1238, s8_1239);
  // tie_rod_right
  const double s8_1241 = mbgen::fnma(work.s2_277, work.Rz_carrier_right_ry_2, work.s2_275);
  const double s8_1242 = mbgen::fma(work.s2_268, work.Rz_carrier_right_rz_2, s8_1241);
  const double s8_1243 = mbgen::fma(s8_1242, s8_1242, s8_1211);
  const double s8_1244 = mbgen::fnma(work.s2_268, work.Rz_carrier_right_rx_2, work.s2_266);
  const double s8_1245 = mbgen::fma(work.s2_271, work.Rz_carrier_right_ry_2, s8_1244);
  const double s8_1246 = mbgen::fma(work.s3_48, work.s3_48, s8_1243);
  const double s8_1247 = s8_997 + s8_1031;
  const double s8_1248 = mbgen::fma(work.s3_60, s8_757, s7_254);
  const double s8_1249 = mbgen::fma(work.Rz_arb_front_right_2, s8_775, s8_1248);
  const double s8_1250 = mbgen::fma(work.s3_38, s8_776, s8_1249);
  const double s8_1251 = mbgen::fma(work.Rz_carrier_right_rx_2, s8_846, s8_1250);
  const double s8_1252 = mbgen::fma(work.Rz_carrier_right_rz_2, s8_862, s8_1251);
  const double s8_1253 = mbgen::fma(work.Rz_carrier_right_ry_2, s8_854, s8_1252);
  const double s8_1254 = mbgen::fma(work.Rz_arb_front_left_2, s8_898, s8_1253);
  const double s8_1255 = mbgen::fma(work.Rz_upper_arm_left_2, s8_897, s8_1254);
  const double s8_1256 = mbgen::fma(s8_750, s8_917, mbgen::fma(s8_749, s8_915, s8_1255));
  const double s8_1257 = mbgen::fnma(work.s3_24, s8_976, s8_1256);
  const double s8_1258 = mbgen::fnma(1.5, s8_1164, mbgen::fnma(work.s3_25, s8_981, s8_1257));
  const double s8_1259 = mbgen::fnma(0.3333333333333333, s8_1060, s8_1258);
  const double s8_1260 = mbgen::fma(work.Rz_lower_arm_left_2, s8_1247, s8_1259);
  const double s8_1261 = mbgen::fma(s8_1245, s8_1245, s8_1246);
  work.pivot_bell_crank = mbgen::fnma(1.1666666666666667, s8_1261, s8_1260);
  work.s8_1262 = 1.1666666666666667*work.s2_280;
  work.s8_1263 = mbgen::fma(work.s2_269, work.s8_1262, s8_1189);
  work.s8_1264 = mbgen::fma(work.s2_273, work.s8_1262, s8_1190);
  work.s8_1265 = mbgen::fnma(work.s2_280, work.s8_1262, s8_1191);
  work.s8_1266 = 1.1666666666666667*work.s2_273;
  work.s8_1267 = mbgen::fnma(work.s2_269, work.s8_1266, s8_1186);
  work.s8_1268 = mbgen::fnma(work.s2_273, work.s8_1266, s8_1187);
  work.s8_1269 = 1.1666666666666667*work.s2_269;
  work.s8_1270 = mbgen::fnma(work.s2_269, work.s8_1269, s8_1204);
  const double s8_1271 = mbgen::fma(work.s2_277, work.Rz_carrier_right_ry_1, work.s1_37);
  work.s8_1272 = mbgen::fnma(work.s2_268, work.s8_785, s8_1271);
  const double s8_1273 = mbgen::fma(work.s2_271, work.s8_785, work.s1_35);
  work.s8_1274 = mbgen::fnma(work.s2_277, work.Rz_carrier_right_rx_1, s8_1273);
  const double s8_1275 = mbgen::fnma(s8_1245, work.s3_42, work.s3_48*work.s8_1274);
  const double s8_1276 = mbgen::fnma(s8_1242, work.s8_1272, s8_1275);
  work.s8_1277 = mbgen::fnma(1.1666666666666667, s8_1276, s8_1119);
  const double s8_1278 = mbgen::fma(work.s3_42, work.s3_42, work.s8_1272*work.s8_1272);
  const double s8_1279 = mbgen::fnma(work.Rz_upper_arm_left_2, work.s7_111, s8_1014 - s8_724);
  const double s8_1280 = s8_775 + (s8_846 + (s8_898 + s8_981));
  const double s8_1281 = mbgen::fma((-p_bell_crank_z), work.s7_241, s8_1280) - s8_757;
  const double s8_1282 = mbgen::fma(p_pitman_arm_x, s8_1012, s8_1281);
  const double s8_1283 = mbgen::fnma((-p_pitman_arm_z), s8_972, s8_1282);
  const double s8_1284 = mbgen::fnma(work.s2_223, s8_722, s8_1283);
  const double s8_1285 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_697, s8_1284);
  const double s8_1286 = mbgen::fnma(work.s8_1047, work.s3_34, s8_1285);
  const double s8_1287 = mbgen::fnma(work.s8_1043, s8_1055, s8_1286);
  const double s8_1288 = mbgen::fnma(work.s8_1105, work.s3_58, s8_1287);
  const double s8_1289 = mbgen::fnma(work.s8_1101, work.s3_55, s8_1288);
  const double s8_1290 = mbgen::fnma(s8_1152, s8_1158, mbgen::fnma(s8_1156, s8_1162, s8_1289));
  const double s8_1291 = mbgen::fnma(s8_1193, work.s8_1203, s8_1290);
  const double s8_1292 = mbgen::fma(work.s8_1188, s8_1195, s8_1291);
  const double s8_1293 = mbgen::fma(s8_1245, work.s8_1269, s8_1292);
  const double s8_1294 = mbgen::fnma(work.s3_48, work.s8_1262, s8_1293);
  const double s8_1295 = mbgen::fma(p_lower_arm_left_x, s8_1279 - s8_915 - s8_1010, s8_1294);
  const double s8_1296 = mbgen::fma(work.Rz_arb_front_left_2, work.s7_128, s8_970);
  const double s8_1297 = mbgen::fma(work.Rz_arb_front_left_2, work.s7_130, s8_1013);
  const double s8_1298 = mbgen::fnma((-p_rear_axle_tx_z), s8_1296, s8_1295);
  work.s8_1299 = mbgen::fma(p_arb_front_left_x, s8_1297, s8_1298);
  const double s8_1300 = s8_862 + (s8_897 + s8_1247) - s8_776;
  const double s8_1301 = mbgen::fnma(work.Rz_arb_front_right_2, work.s7_214, s8_1300);
  const double s8_1302 = mbgen::fnma((-p_bell_crank_z), work.s7_243, s8_1301);
  const double s8_1303 = mbgen::fma(work.s2_223, s8_726, s8_1302);
  const double s8_1304 = mbgen::fma(work.r_carrier_right_aux1_y, s8_724, s8_1303);
  const double s8_1305 = mbgen::fnma(work.Rz_arb_front_left_2, work.s7_126, s8_1304);
  const double s8_1306 = mbgen::fma(work.r_carrier_left_aux1_z, s8_917, s8_1305);
  const double s8_1307 = mbgen::fma(work.r_carrier_left_aux1_y, s8_915, s8_1306);
  const double s8_1308 = mbgen::fma(p_lower_arm_left_y, s8_1010, s8_1307);
  const double s8_1309 = mbgen::fnma((-p_lower_arm_left_z), s8_1019, s8_1308);
  const double s8_1310 = mbgen::fma(work.s8_1047, s8_1050, s8_1309);
  const double s8_1311 = mbgen::fma(work.s8_1040, s8_1055, s8_1310);
  const double s8_1312 = mbgen::fnma(work.s8_1107, work.s3_55, s8_1311);
  const double s8_1313 = mbgen::fnma(work.s8_1105, work.s3_44, s8_1312);
  const double s8_1314 = mbgen::fma(s8_1152, s8_1153, mbgen::fma(work.s2_237, s8_1156, s8_1313));
  const double s8_1315 = mbgen::fma(work.s8_1185, s8_1195, s8_1314);
  const double s8_1316 = mbgen::fnma(work.s8_1203, s8_1206, s8_1315);
  const double s8_1317 = mbgen::fnma(work.s3_48, work.s8_1266, s8_1316);
  const double s8_1318 = mbgen::fma(work.Rz_upper_arm_left_2, work.s7_111, s8_1014) - s8_1012;
  const double s8_1319 = mbgen::fnma(s8_1242, work.s8_1269, s8_1317);
  const double s8_1320 = mbgen::fnma(work.Rz_arb_front_left_2, work.s7_130, s8_1013);
  const double s8_1321 = mbgen::fma((-p_rear_axle_tx_z), s8_1318, s8_1319);
  const double s8_1322 = mbgen::fma(work.Rz_upper_arm_left_2, work.s7_113, s8_1017);
  const double s8_1323 = mbgen::fma(p_carrier_left_rz_y, s8_1320, s8_1321);
  work.s8_1324 = mbgen::fnma((-p_upper_arm_right_z), s8_1322, s8_1323);
  const double s8_1325 = mbgen::fnma(work.Rz_upper_arm_left_2, work.s7_113, s8_726 - s8_1017);
  const double s8_1326 = mbgen::fnma(p_bell_crank_x, work.s7_243, s8_854 + (s7_254 + s8_976));
  const double s8_1327 = mbgen::fnma(p_pitman_arm_y, s8_972, s8_1326);
  const double s8_1328 = mbgen::fma(work.Rz_arb_front_right_2, work.s7_216, s8_1327);
  const double s8_1329 = mbgen::fnma(work.r_carrier_right_aux1_y, s8_722, s8_1328);
  const double s8_1330 = mbgen::fnma(work.Rz_arb_front_left_2, work.s7_124, s8_1329);
  const double s8_1331 = mbgen::fnma(work.r_carrier_left_aux1_y, work.s8_697, s8_1330);
  const double s8_1332 = mbgen::fma(work.s8_1040, work.s3_34, s8_1331);
  const double s8_1333 = mbgen::fnma(work.s8_1043, s8_1050, s8_1332);
  const double s8_1334 = mbgen::fma(work.s8_1101, work.s3_44, s8_1333);
  const double s8_1335 = mbgen::fnma(work.s8_1107, work.s3_58, s8_1334);
  const double s8_1336 = mbgen::fnma(work.s2_237, s8_1158, mbgen::fma(s8_1153, s8_1162, s8_1335));
  const double s8_1337 = mbgen::fma(work.s8_1188, s8_1206, s8_1336);
  const double s8_1338 = mbgen::fnma(work.s8_1185, s8_1193, s8_1337);
  const double s8_1339 = mbgen::fnma(s8_1242, work.s8_1262, s8_1338);
  const double s8_1340 = mbgen::fnma(s8_1245, work.s8_1266, s8_1339);
  const double s8_1341 = mbgen::fma(p_lower_arm_left_x, s8_1325 - s8_917 - s8_1019, s8_1340);
  const double s8_1342 = mbgen::fnma(work.Rz_arb_front_left_2, work.s7_128, s8_970);
  work.s8_1343 = mbgen::fma(p_carrier_left_rz_y, s8_1342, s8_1341);
  const double s8_1344 = mbgen::fma(work.s8_32, work.s2_273, work.s6_143);
  const double s8_1345 = mbgen::fma(work.s8_41, work.s2_269, s8_1344);
  const double s8_1346 = mbgen::fma(work.s8_49, work.s2_280, s8_1345);
  const double s8_1347 = mbgen::fma(work.s8_13, work.s6_150, s8_1346);
  const double s8_1348 = mbgen::fma(work.s8_28, work.s6_152, s8_1347);
  const double s8_1349 = mbgen::fma(work.s2_268, work.zdd_star_carrier_right_rx, s8_1348);
  const double s8_1350 = mbgen::fma(work.s8_57, work.s2_273, work.s6_148);
  const double s8_1351 = mbgen::fma(work.s8_32, work.s2_280, s8_1350);
  const double s8_1352 = mbgen::fnma(work.s8_33, work.s2_269, s8_1351);
  const double s8_1353 = mbgen::fma(work.s8_23, work.s6_150, s8_1352);
  const double s8_1354 = mbgen::fma(work.s8_28, work.s6_149, s8_1353);
  const double s8_1355 = mbgen::fnma(work.s2_277, work.zdd_star_carrier_right_ry, s8_1354);
  const double s8_1356 = mbgen::fma(work.s2_268, work.zdd_star_carrier_right_rz, s8_1355);
  work.s8_1357 = 1.1666666666666667*s8_1356;
  const double s8_1358 = mbgen::fms(work.s8_41, work.s2_280, work.s6_145);
  const double s8_1359 = mbgen::fma(work.s8_44, work.s2_269, s8_1358);
  const double s8_1360 = mbgen::fnma(work.s8_33, work.s2_273, s8_1359);
  const double s8_1361 = mbgen::fma(work.s8_23, work.s6_152, s8_1360);
  const double s8_1362 = mbgen::fnma(work.s8_13, work.s6_149, s8_1361);
  const double s8_1363 = mbgen::fnma(work.s2_271, work.zdd_star_carrier_right_rz, s8_1362);
  const double s8_1364 = mbgen::fma(work.s2_277, work.zdd_star_carrier_right_rx, s8_1363);
  work.s8_1365 = 1.1666666666666667*s8_1364;
  const double s8_1366 = mbgen::fnma(work.s8_1272, work.s8_1357, s8_1151);
  const double s8_1367 = mbgen::fma(work.Rz_arb_front_right_1, work.s8_765, work.s7_152);
  const double s8_1368 = mbgen::fma(work.s3_36, work.s8_779, s8_1367);
  const double s8_1369 = mbgen::fma(work.s1_37, work.s8_787, s8_1368);
  const double s8_1370 = mbgen::fma(work.s1_35, work.s8_789, s8_1369);
  const double s8_1371 = mbgen::fma(work.Rz_carrier_right_rx_1, work.s8_850, s8_1370);
  const double s8_1372 = mbgen::fma(work.Rz_carrier_right_ry_1, work.s8_857, s8_1371);
  const double s8_1373 = mbgen::fma(work.s8_785, work.s8_866, s8_1372);
  const double s8_1374 = mbgen::fnma(0.3333333333333333, s8_1117, s8_1373);
  const double s8_1375 = mbgen::fma(work.s8_1274, work.s8_1274, s8_1278);
  work.s8_1376 = mbgen::fnma(1.1666666666666667, s8_1375, s8_1374);
  const double s8_1377 = mbgen::fnma(work.s2_271, work.zdd_star_carrier_right_ry, s8_1349);
  work.s8_1378 = 1.1666666666666667*s8_1377;
  const double s8_1379 = mbgen::fnma(work.s3_48, work.s8_1365, s8_1240);
  const double s8_1380 = mbgen::fnma(s8_1245, work.s8_1378, s8_1379);
  const double s8_1381 = mbgen::fnma(work.s8_1274, work.s8_1365, s8_1366);
  work.s8_1382 = mbgen::fma(work.s3_42, work.s8_1378, s8_1381);
  const double s8_1383 = tau[Coordinate::lower_arm_left] - work.n_carrier_left_x - work.s8_1039;
  const double s8_1384 = mbgen::fma(s8_1242, work.s8_1357, s8_1380);
  const double s8_1385 = mbgen::fma(work.Rz_lower_arm_left_2, s8_1383, s8_1384);
  const double s8_1386 = mbgen::fma(work.s8_32, work.s7_252 - work.s7_249, s8_1385);
  const double s8_1387 = tau[Coordinate::upper_arm_left] - work.s8_911;
  const double s8_1388 = mbgen::fma(work.Rz_upper_arm_left_2, s8_1387, s8_1386);
  const double s8_1389 = mbgen::fma(work.s3_24, work.s8_968, s8_1388);
  const double s8_1390 = mbgen::fma(work.s3_25, work.s8_966, s8_1389);
  const double s8_1391 = mbgen::fma(p_pitman_arm_y, work.s8_57, s8_903);
  const double s8_1392 = mbgen::fms(work.s7_199, s8_1391, work.s8_783);
  const double s8_1393 = s8_1392 - tau[Coordinate::upper_arm_right];
  const double s8_1394 = mbgen::fma(work.s7_197, s8_904 - s8_761, s8_1393);
  const double s8_1395 = mbgen::fma(work.s8_33, work.s7_205 - work.s7_206, s8_1394);
  work.s8_1396 = mbgen::fma(work.s7_204, s8_909, s8_1395);
  const double s8_1397 = mbgen::fma(work.Rz_arb_front_left_2, work.s8_893, s8_1390);
  const double s8_1398 = mbgen::fma(work.s3_38, work.s8_1396, s8_1397);
  const double s8_1399 = work.s5_39 - work.n_carrier_right_x;
  work.s8_1400 = mbgen::fma(work.Rz_carrier_right_rz_2, s8_1399, s8_1398);
}

/// Part 5 of compute_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63); step 9:
/// accelerations from the root to the leaves (63), (62).
[[gnu::noinline]] void compute_accelerations_5(const State& state, const double* tau,
    AccelerationsWork& __restrict work, Accelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // tie_rod_right
  const double s8_1401 = mbgen::fma(work.Rz_carrier_right_ry_2, work.s8_834, work.s8_1400);
  const double s8_1402 = mbgen::fma(work.Rz_carrier_right_rx_2, work.s8_832, s8_1401);
  const double s8_1403 = mbgen::fms(work.s7_229, work.s8_763, work.s8_764);
  const double s8_1404 = s8_1403 - tau[Coordinate::pitman_arm];
  const double s8_1405 = mbgen::fnma(work.s7_230, work.s8_54, s8_1404);
  const double s8_1406 = mbgen::fma(work.s8_41, work.s7_237 - work.s7_236, s8_1405);
  const double s8_1407 = mbgen::fma(work.Rz_arb_front_right_2, work.s8_774, s8_1402);
  const double s8_1408 = mbgen::fma(work.s7_235, work.s8_772, s8_1406);
  const double s8_1409 = work.s8_57 - work.s8_49;
  const double s8_1410 = mbgen::fma(work.s3_60, s8_1408, s8_1407);
  const double s8_1411 = mbgen::fma(work.s7_248, s8_1409, s8_1410);
  const double s8_1412 = 1.0/work.pivot_bell_crank;
  const double s8_1413 = work.s8_1277*s8_1412;
  const double s8_1414 = work.s8_1209*s8_1412;
  const double s8_1415 = work.s8_1209*s8_1413;
  const double pivot_lower_arm_right = mbgen::fnma(work.s8_1277, s8_1413, work.s8_1376);
  const double s8_1416 = 1.0/pivot_lower_arm_right;
  const double s8_1417 = s8_1415*s8_1416;
  const double s8_1418 = mbgen::fnma(work.s8_1209, s8_1414, work.s8_1202);
  const double pivot_carrier_left_rz = mbgen::fnma(s8_1415, s8_1417, s8_1418);
  const double s8_1419 = work.s8_67 + (work.s7_130 + work.s7_212) - work.s7_243 - work.s7_229;
  const double s8_1420 = 471.925 + s8_1419;
  const double s8_1421 = 2.1 + work.s7_199;
  const double s8_1422 = work.s7_113 - 2.1;
  const double s8_1423 = work.s7_56 - 7.75;
  const double s8_1424 = 7.75 + work.s7_143;
  const double s8_1425 = 23.1 - work.s7_229;
  const double s8_1426 = work.s7_235 + (work.s8_83 + (work.s7_135 + work.s7_221)) - 90.9075;
  const double s8_1427 = 2.1 + work.s7_230;
  const double s8_1428 = mbgen::fnma((-p_pitman_arm_z), s8_1425, s8_1426);
  const double s8_1429 = 33.31250000000001 - work.s7_243;
  const double s8_1430 = mbgen::fnma(p_pitman_arm_x, s8_1427, s8_1428);
  const double s8_1431 = mbgen::fnma((-p_bell_crank_z), s8_1429, s8_1430);
  const double s8_1432 = s8_1422 + s8_1423 - s8_1421 - s8_1424;
  const double s8_1433 = 17.775 + work.s7_212;
  const double s8_1434 = 17.775 + work.s7_130;
  const double s8_1435 = s8_1433 + s8_1434;
  const double s8_1436 = mbgen::fma(p_lower_arm_left_x, s8_1432, s8_1431);
  const double s8_1437 = work.s7_210 - 2.25;
  const double s8_1438 = work.s7_128 - 2.25;
  const double s8_1439 = mbgen::fnma((-p_rear_axle_tx_z), s8_1435, s8_1436);
  const double s8_1440 = mbgen::fma(p_arb_front_left_x, s8_1437 + s8_1438, s8_1439);
  const double s8_1441 = work.s7_197 - 3.75;
  const double s8_1442 = 3.75 + work.s7_111;
  const double s8_1443 = 5.0 + work.s7_54;
  const double s8_1444 = work.s7_141 - 5.0;
  const double s8_1445 = 11.55 + (work.s7_248 + (work.s8_85 + (work.s7_126 + work.s7_214)));
  const double s8_1446 = mbgen::fma(p_bell_crank_x, work.s7_241, s8_1445);
  const double s8_1447 = mbgen::fma(p_pitman_arm_y, s8_1425, s8_1446);
  const double s8_1448 = s8_1444 + (s8_1441 + (s8_1442 + s8_1443));
  const double s8_1449 = mbgen::fma(p_lower_arm_left_x, s8_1448, s8_1447);
  const double s8_1450 = mbgen::fma(p_carrier_left_rz_y, s8_1434 - s8_1433, s8_1449);
  const double s8_1451 = work.s7_204 + (work.s7_148 + (work.s7_124 + (work.s7_61 + work.s7_118)));
  const double s8_1452 = work.s8_86 + s8_1451 - work.s7_216;
  const double s8_1453 = mbgen::fnma((-p_bell_crank_z), work.s7_241, s8_1452) - 1.05;
  const double s8_1454 = mbgen::fma((-p_rear_axle_tx_z), s8_1421 + s8_1422 - s8_1427, s8_1453);
  const double s8_1455 = mbgen::fma(p_lower_arm_left_y, s8_1424 + s8_1423, s8_1454);
  const double s8_1456 = mbgen::fma(p_carrier_left_rz_y, s8_1438 - s8_1437, s8_1455);
  const double s8_1457 = mbgen::fnma((-p_lower_arm_left_z), s8_1444 + s8_1443, s8_1456);
  const double s8_1458 = mbgen::fnma((-p_upper_arm_right_z), s8_1441 + s8_1442, s8_1457);
  const double s8_1459 = work.r_carrier_left_aux1_y + work.r_carrier_right_aux1_y;
  const double s8_1460 = mbgen::fma(m_carrier_right_2, s8_1459, work.s8_727);
  const double s8_1461 = 1580.4 + work.s8_728;
  const double s8_1462 = work.r_carrier_left_aux1_z - work.s2_223;
  const double s8_1463 = mbgen::fma(m_carrier_right_2, s8_1462, work.s8_729);
  const double s8_1464 = mbgen::fma(p_lower_arm_left_x, work.s8_839 + work.s8_984, work.s8_1263);
  const double s8_1465 = mbgen::fma(p_lower_arm_left_x, work.s8_838 + work.s8_985, work.s8_1264);
  const double s8_1466 = work.s7_210 + (work.s7_128 + (work.s7_56 + work.s7_113)) - work.s7_230;
  const double s8_1467 = s8_1466 - work.s7_199 - work.s7_143 - work.s8_69 - 64.9;
  result.inertia[8] = mbgen::fnma(1e-12, work.pivot_bell_crank, work.pivot_bell_crank);
  const double s8_1468 = work.s7_206 + (work.s7_150 + (work.s7_137 + (work.s7_63 + work.s7_120)));
  const double s8_1469 = work.s7_253 + (work.s8_87 + (work.s7_237 + (work.s7_223 + s8_1468)));
  const double s8_1470 = 7.380000000000001 + (s8_1469 - s8_1437 - s8_1438);
  const double s8_1471 = mbgen::fma(0.56, s8_1421 - s8_1422, mbgen::fma(0.8, s8_1427, s8_1470));
  const double s8_1472 = mbgen::fma(1.24, s8_1424 - s8_1423, s8_1471);
  const double s8_1473 = work.s7_205 + (work.s7_149 + (work.s7_119 + (work.s7_62 + s8_1442)));
  const double s8_1474 = 12.8518 + (work.s7_252 + s8_1473 - s8_1441);
  const double s8_1475 = mbgen::fma(0.8, s8_1443 - s8_1444, s8_1474);
  const double s8_1476 = work.s7_249 + (work.s8_88 + (work.s7_236 + (work.s7_136 + work.s7_222)));
  const double s8_1477 = mbgen::fma(8.8, s8_1425, mbgen::fma(6.5, s8_1429, 1037.4 + s8_1476));
  const double s8_1478 = mbgen::fma(7.9, s8_1435, s8_1477);
  const double s8_1479 = mbgen::fma(7.2, work.s8_835 + work.s8_988, work.s8_1265);
  result.inertia[7] = mbgen::fnma(1e-12, work.s8_1376, pivot_lower_arm_right);
  const double s8_1480 = work.Rz_arb_front_right_1*work.s7_210;
  const double s8_1481 = mbgen::fnma(work.s8_973, s8_1413, s8_1480 + work.s8_720);
  const double s8_1482 = work.s3_36*work.s7_199;
  const double s8_1483 = work.s7_143 + work.s8_787 - s8_1482;
  const double s8_1484 = work.Rz_arb_front_right_1*work.s7_212;
  const double s8_1485 = work.s3_36*work.s7_197;
  const double s8_1486 = work.s7_141 + work.s8_789 - s8_1484 - s8_1485;
  const double s8_1487 = mbgen::fnma(work.s8_1016, s8_1413, s8_1486);
  const double s8_1488 = mbgen::fma(work.Rz_arb_front_right_1, work.s7_216, work.s8_857);
  const double s8_1489 = mbgen::fma((-p_arb_front_right_y), s8_1480, s8_1488);
  const double s8_1490 = mbgen::fnma(work.r_carrier_right_aux1_y, work.s8_720, s8_1489);
  const double s8_1491 = mbgen::fma(work.s8_1101, work.s8_1111, s8_1490);
  const double s8_1492 = mbgen::fnma(work.s8_1107, work.s3_52, s8_1491);
  const double s8_1493 = mbgen::fma(work.s8_1266, work.s3_42, s8_1492);
  const double s8_1494 = mbgen::fma(work.s8_1262, work.s8_1272, s8_1493);
  const double s8_1495 = mbgen::fnma(work.s8_1343, s8_1413, s8_1494);
  const double s8_1496 = mbgen::fma(p_lower_arm_left_x, s8_1483, s8_1495);
  const double s8_1497 = work.s8_866 + work.s7_152 - work.s8_779;
  const double s8_1498 = mbgen::fma((-p_arb_front_right_y), s8_1484, s8_1497);
  const double s8_1499 = mbgen::fnma(work.Rz_arb_front_right_1, work.s7_214, s8_1498);
  const double s8_1500 = mbgen::fma((-p_upper_arm_right_y), s8_1485, s8_1499);
  const double s8_1501 = mbgen::fnma((-p_upper_arm_right_z), s8_1482, s8_1500);
  const double s8_1502 = mbgen::fma(work.s2_223, work.s8_787, s8_1501);
  const double s8_1503 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_789, s8_1502);
  const double s8_1504 = mbgen::fma((-p_lower_arm_right_z), work.s7_143, s8_1503);
  const double s8_1505 = mbgen::fnma((-p_lower_arm_right_y), work.s7_141, s8_1504);
  const double s8_1506 = mbgen::fnma(work.s8_1107, work.s8_1114, s8_1505);
  const double s8_1507 = mbgen::fnma(work.s8_1105, work.s8_1111, s8_1506);
  const double s8_1508 = mbgen::fma(work.s8_1269, work.s8_1272, s8_1507);
  const double s8_1509 = mbgen::fnma(work.s8_1266, work.s8_1274, s8_1508);
  const double s8_1510 = mbgen::fnma(work.s8_1324, s8_1413, s8_1509);
  const double s8_1511 = mbgen::fma(p_arb_front_right_x, s8_1484, work.s8_765 + work.s8_850);
  const double s8_1512 = mbgen::fnma((-p_arb_front_right_z), s8_1480, s8_1511);
  const double s8_1513 = mbgen::fnma(work.s2_223, work.s8_720, s8_1512);
  const double s8_1514 = mbgen::fnma(work.s8_1105, work.s3_52, s8_1513);
  const double s8_1515 = mbgen::fnma(work.s8_1101, work.s8_1114, s8_1514);
  const double s8_1516 = mbgen::fnma(work.s3_42, work.s8_1269, s8_1515);
  const double s8_1517 = mbgen::fnma(work.s8_1262, work.s8_1274, s8_1516);
  const double s8_1518 = mbgen::fnma(work.s8_1299, s8_1413, s8_1517);
  const double s8_1519 = s8_1485 - work.s8_789 - work.s7_141;
  const double s8_1520 = mbgen::fma(p_lower_arm_left_x, s8_1519, s8_1518);
  const double s8_1521 = mbgen::fnma(s8_1411, s8_1413, work.s8_1382);
  const double s8_1522 = mbgen::fma(work.s8_33, work.s7_150 - work.s7_149, s8_1521);
  const double s8_1523 = mbgen::fma(work.s3_36, work.s8_1396, s8_1522);
  const double s8_1524 = mbgen::fma(work.Rz_carrier_right_ry_1, work.s8_834, s8_1523);
  const double s8_1525 = mbgen::fma(work.Rz_carrier_right_rx_1, work.s8_832, s8_1524);
  const double s8_1526 = work.s8_44 - work.s8_57;
  const double s8_1527 = mbgen::fma(work.Rz_arb_front_right_1, work.s8_774, s8_1525);
  const double s8_1528 = mbgen::fma(work.s7_148, s8_1526, s8_1527);
  const double s8_1529 = mbgen::fma(s8_1417, s8_1528, work.s5_23);
  const double s8_1530 = mbgen::fnma(work.s8_747, work.f_carrier_left_y, s8_1529);
  const double s8_1531 = mbgen::fma(work.s8_745, work.f_carrier_left_z, s8_1530);
  const double s8_1532 = mbgen::fnma(work.s8_744, work.n_carrier_left_x, s8_1531);
  const double s8_1533 = mbgen::fnma(work.s8_1052, work.s8_1087, s8_1532);
  const double s8_1534 = mbgen::fnma(work.s8_1063, work.s8_1097, s8_1533);
  const double s8_1535 = mbgen::fma(work.s3_31, work.s8_1078, s8_1534);
  const double s8_1536 = mbgen::fnma(work.s8_1197, work.s8_1238, s8_1535);
  const double s8_1537 = mbgen::fnma(work.s3_23, work.s8_1219, s8_1536);
  const double s8_1538 = mbgen::fnma(work.s8_1199, work.s8_1228, s8_1537);
  result.inertia[6] = mbgen::fnma(1e-12, work.s8_1202, pivot_carrier_left_rz);
  const double s8_1539 = work.Rz_arb_front_left_0*work.s7_128;
  const double s8_1540 = mbgen::fma(s8_1417, s8_1481, s8_1539 + work.s8_696);
  const double s8_1541 = mbgen::fnma(work.s8_973, s8_1414, s8_1540);
  const double s8_1542 = 1.0/pivot_carrier_left_rz;
  const double s8_1543 = s8_1541*s8_1542;
  const double s8_1544 = work.s3_19*work.s7_113;
  const double s8_1545 = work.s3_20*work.s7_56;
  const double s8_1546 = work.s8_913 + (s8_1544 + s8_1545);
  const double s8_1547 = mbgen::fnma(work.s8_1021, s8_1413, s8_1483);
  const double s8_1548 = mbgen::fma(s8_1417, s8_1547, s8_1546);
  const double s8_1549 = mbgen::fnma(work.s8_1021, s8_1414, s8_1548);
  const double s8_1550 = s8_1542*s8_1549;
  const double s8_1551 = work.Rz_arb_front_left_0*work.s7_130;
  const double s8_1552 = work.s3_19*work.s7_111;
  const double s8_1553 = work.s3_20*work.s7_54;
  const double s8_1554 = mbgen::fma(s8_1417, s8_1487, work.s8_919 - s8_1551 - s8_1552 - s8_1553);
  const double s8_1555 = mbgen::fnma(work.s8_1016, s8_1414, s8_1554);
  const double s8_1556 = s8_1542*s8_1555;
  const double s8_1557 = mbgen::fma(s8_1417, s8_1496, work.s8_978);
  const double s8_1558 = mbgen::fnma(work.Rz_arb_front_left_0, work.s7_124, s8_1557);
  const double s8_1559 = mbgen::fnma(p_arb_front_left_y, s8_1539, s8_1558);
  const double s8_1560 = mbgen::fnma(work.r_carrier_left_aux1_y, work.s8_696, s8_1559);
  const double s8_1561 = mbgen::fma(work.s8_1040, work.s3_31, s8_1560);
  const double s8_1562 = mbgen::fma(work.s8_1043, work.s8_1052, s8_1561);
  const double s8_1563 = mbgen::fnma(work.s8_1188, work.s8_1197, s8_1562);
  const double s8_1564 = mbgen::fnma(work.s3_23, work.s8_1185, s8_1563);
  const double s8_1565 = mbgen::fnma(work.s8_1343, s8_1414, s8_1564);
  const double s8_1566 = mbgen::fma(p_lower_arm_left_x, s8_1546, s8_1565);
  const double s8_1567 = s8_1542*s8_1566;
  const double s8_1568 = mbgen::fma(s8_1417, s8_1510, work.s8_1000 - work.s8_894 - work.s8_1026);
  const double s8_1569 = mbgen::fma((-p_upper_arm_left_z), s8_1544, s8_1568);
  const double s8_1570 = mbgen::fnma(p_upper_arm_left_y, s8_1552, s8_1569);
  const double s8_1571 = mbgen::fnma(work.Rz_arb_front_left_0, work.s7_126, s8_1570);
  const double s8_1572 = mbgen::fnma(p_arb_front_left_y, s8_1551, s8_1571);
  const double s8_1573 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_919, s8_1572);
  const double s8_1574 = mbgen::fnma(work.r_carrier_left_aux1_z, work.s8_913, s8_1573);
  const double s8_1575 = mbgen::fma((-p_lower_arm_left_z), s8_1545, s8_1574);
  const double s8_1576 = mbgen::fnma(p_lower_arm_left_y, s8_1553, s8_1575);
  const double s8_1577 = mbgen::fma(work.s8_1040, work.s8_1063, s8_1576);
  const double s8_1578 = mbgen::fnma(work.s8_1047, work.s8_1052, s8_1577);
  const double s8_1579 = mbgen::fma(work.s8_1197, work.s8_1203, s8_1578);
  const double s8_1580 = mbgen::fma(work.s8_1185, work.s8_1199, s8_1579);
  const double s8_1581 = mbgen::fnma(work.s8_1324, s8_1414, s8_1580);
  const double s8_1582 = s8_1542*s8_1581;
  const double s8_1583 = mbgen::fma(s8_1417, s8_1520, work.s8_881 + work.s8_983);
  const double s8_1584 = mbgen::fma(p_arb_front_left_x, s8_1551, s8_1583);
  const double s8_1585 = mbgen::fnma((-p_arb_front_left_z), s8_1539, s8_1584);
  const double s8_1586 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_696, s8_1585);
  const double s8_1587 = mbgen::fnma(work.s8_1047, work.s3_31, s8_1586);
  const double s8_1588 = mbgen::fnma(work.s8_1043, work.s8_1063, s8_1587);
  const double s8_1589 = mbgen::fnma(work.s3_23, work.s8_1203, s8_1588);
  const double s8_1590 = mbgen::fma(work.s8_1188, work.s8_1199, s8_1589);
  const double s8_1591 = mbgen::fnma(work.s8_1299, s8_1414, s8_1590);
  const double s8_1592 = mbgen::fma(p_lower_arm_left_x, s8_1552 + s8_1553 - work.s8_919, s8_1591);
  const double s8_1593 = s8_1542*s8_1592;
  const double s8_1594 = s8_1416*s8_1481;
  const double s8_1595 = s8_1416*s8_1547;
  const double s8_1596 = s8_1416*s8_1487;
  const double s8_1597 = s8_1416*s8_1496;
  const double s8_1598 = s8_1416*s8_1510;
  const double s8_1599 = s8_1416*s8_1520;
  const double s8_1600 = work.s8_973*s8_1412;
  const double s8_1601 = mbgen::fma(s8_1547, s8_1594, mbgen::fma(s8_1543, s8_1549, work.s8_607));
  const double s8_1602 = mbgen::fma(work.s8_1021, s8_1600, s8_1601);
  const double s8_1603 = mbgen::fma(s8_1481, s8_1594, mbgen::fma(s8_1541, s8_1543, work.s8_608));
  const double s8_1604 = mbgen::fma(work.s8_973, s8_1600, s8_1603);
  const double s8_1605 = mbgen::fma(s8_1487, s8_1594, mbgen::fma(s8_1543, s8_1555, work.s8_609));
  const double s8_1606 = mbgen::fma(work.s8_1016, s8_1600, s8_1605);
  const double s8_1607 = mbgen::fma(s8_1510, s8_1594, mbgen::fma(s8_1543, s8_1581, work.s8_610));
  const double s8_1608 = mbgen::fma(work.s8_1324, s8_1600, s8_1607);
  const double s8_1609 = mbgen::fma(s8_1496, s8_1594, mbgen::fma(s8_1543, s8_1566, work.s8_611));
  const double s8_1610 = mbgen::fma(work.s8_1343, s8_1600, s8_1609);
  const double s8_1611 = mbgen::fma(s8_1520, s8_1594, mbgen::fma(s8_1543, s8_1592, work.s8_612));
  const double s8_1612 = mbgen::fma(work.s8_1299, s8_1600, s8_1611);
  const double s8_1613 = work.s8_1016*s8_1412;
  const double s8_1614 = mbgen::fma(s8_1487, s8_1596, mbgen::fma(s8_1555, s8_1556, work.s8_619));
  const double s8_1615 = mbgen::fma(work.s8_1016, s8_1613, s8_1614);
  const double s8_1616 = mbgen::fma(s8_1510, s8_1596, mbgen::fma(s8_1556, s8_1581, work.s8_620));
  const double s8_1617 = mbgen::fma(work.s8_1324, s8_1613, s8_1616);
  const double s8_1618 = mbgen::fma(s8_1496, s8_1596, mbgen::fma(s8_1556, s8_1566, work.s8_621));
  const double s8_1619 = mbgen::fma(work.s8_1343, s8_1613, s8_1618);
  const double s8_1620 = mbgen::fma(s8_1520, s8_1596, mbgen::fma(s8_1556, s8_1592, work.s8_622));
  const double s8_1621 = mbgen::fma(work.s8_1299, s8_1613, s8_1620);
  const double s8_1622 = work.s8_1021*s8_1412;
  const double s8_1623 = mbgen::fma(s8_1547, s8_1595, mbgen::fma(s8_1549, s8_1550, work.s8_588));
  const double s8_1624 = mbgen::fma(work.s8_1021, s8_1622, s8_1623);
  const double s8_1625 = mbgen::fma(s8_1487, s8_1595, mbgen::fma(s8_1550, s8_1555, work.s8_589));
  const double s8_1626 = mbgen::fma(work.s8_1016, s8_1622, s8_1625);
  const double s8_1627 = mbgen::fma(s8_1510, s8_1595, mbgen::fma(s8_1550, s8_1581, work.s8_590));
  const double s8_1628 = mbgen::fma(work.s8_1324, s8_1622, s8_1627);
  const double s8_1629 = mbgen::fma(s8_1496, s8_1595, mbgen::fma(s8_1550, s8_1566, work.s8_591));
  const double s8_1630 = mbgen::fma(work.s8_1343, s8_1622, s8_1629);
  const double s8_1631 = mbgen::fma(s8_1520, s8_1595, mbgen::fma(s8_1550, s8_1592, work.s8_592));
  const double s8_1632 = mbgen::fma(work.s8_1299, s8_1622, s8_1631);
  const double s8_1633 = work.s8_1299*s8_1412;
  const double s8_1634 = mbgen::fma(s8_1496, s8_1599, mbgen::fma(s8_1566, s8_1593, work.s8_668));
  const double s8_1635 = mbgen::fma(s8_1520, s8_1599, mbgen::fma(s8_1592, s8_1593, work.s8_669));
  const double s8_1636 = mbgen::fma(work.s8_1299, s8_1633, s8_1635);
  const double s8_1637 = mbgen::fma(work.s8_1343, s8_1633, s8_1634) + (s8_1458 + work.s8_1267);
  const double s8_1638 = work.s8_1324*s8_1412;
  const double s8_1639 = mbgen::fma(s8_1510, s8_1598, mbgen::fma(s8_1581, s8_1582, work.s8_629));
  const double s8_1640 = mbgen::fma(work.s8_1324, s8_1638, s8_1639);
  const double s8_1641 = mbgen::fma(s8_1496, s8_1598, mbgen::fma(s8_1566, s8_1582, work.s8_630));
  const double s8_1642 = mbgen::fma(work.s8_1343, s8_1638, s8_1641);
  const double s8_1643 = mbgen::fma(s8_1520, s8_1598, mbgen::fma(s8_1582, s8_1592, work.s8_631));
  const double s8_1644 = mbgen::fma(work.s8_1299, s8_1638, s8_1643);
  const double s8_1645 = work.s8_1343*s8_1412;
  const double s8_1646 = mbgen::fma(s8_1528, s8_1597, mbgen::fma(s8_1411, s8_1645, work.s8_969));
  const double s8_1647 = mbgen::fma(work.s7_236, work.s8_758, s8_1646);
  const double s8_1648 = mbgen::fma(work.s7_235, work.s8_759, s8_1647);
  const double s8_1649 = work.s7_241*work.s8_29;
  const double s8_1650 = mbgen::fnma(p_pitman_arm_x, work.s8_760, s8_1648);
  const double s8_1651 = mbgen::fnma(p_bell_crank_x, s8_1649, s8_1650);
  const double s8_1652 = mbgen::fma(work.zdd_star_arb_front_right, work.s7_216, s8_1651);
  const double s8_1653 = mbgen::fma(work.s7_214, work.s8_20, s8_1652);
  const double s8_1654 = mbgen::fma(work.s7_222, work.s8_767, s8_1653);
  const double s8_1655 = mbgen::fma(work.s7_221, work.s8_766, s8_1654);
  const double s8_1656 = mbgen::fnma(work.s7_204, work.s8_780, s8_1655);
  const double s8_1657 = mbgen::fnma(work.s7_205, work.s8_781, s8_1656);
  const double s8_1658 = mbgen::fnma(work.r_carrier_right_aux1_y, work.f_carrier_right_x, s8_1657);
  const double s8_1659 = mbgen::fnma(work.s7_148, work.s8_872, s8_1658);
  const double s8_1660 = mbgen::fnma(work.s7_149, work.s8_873, s8_1659);
  const double s8_1661 = mbgen::fma(work.s7_136, work.s8_883, s8_1660);
  const double s8_1662 = mbgen::fma(work.s7_135, work.s8_882, s8_1661);
  const double s8_1663 = mbgen::fnma(work.zdd_star_arb_front_left, work.s7_124, s8_1662);
  const double s8_1664 = mbgen::fma(work.s7_126, work.s8_22, s8_1663);
  const double s8_1665 = mbgen::fnma(work.s7_119, work.s8_900, s8_1664);
  const double s8_1666 = mbgen::fnma(work.s7_118, work.s8_901, s8_1665);
  const double s8_1667 = mbgen::fnma(work.r_carrier_left_aux1_y, work.f_carrier_left_x, s8_1666);
  const double s8_1668 = mbgen::fnma(work.s7_62, work.s8_1028, s8_1667);
  const double s8_1669 = mbgen::fnma(work.s7_61, work.s8_1029, s8_1668);
  const double s8_1670 = mbgen::fma(work.s2_206, work.s8_1078, s8_1669);
  const double s8_1671 = mbgen::fnma(work.s2_193, work.s8_1087, s8_1670);
  const double s8_1672 = mbgen::fnma(work.s2_218, work.s8_1127, s8_1671);
  const double s8_1673 = mbgen::fnma(work.s2_231, work.s8_1136, s8_1672);
  const double s8_1674 = mbgen::fma(work.s2_242, work.s8_1175, s8_1673);
  const double s8_1675 = mbgen::fnma(work.s2_238, work.s8_1169, s8_1674);
  const double s8_1676 = mbgen::fma(work.s2_252, work.s8_1219, s8_1675);
  const double s8_1677 = mbgen::fma(work.s2_260, work.s8_1238, s8_1676);
  const double s8_1678 = mbgen::fma(work.s2_273, work.s8_1378, s8_1677);
  const double s8_1679 = mbgen::fma(s8_1496, s8_1597, mbgen::fma(s8_1566, s8_1567, work.s8_649));
  const double s8_1680 = mbgen::fma(work.s8_1343, s8_1645, s8_1679);
  const double s8_1681 = work.s8_911 - tau[Coordinate::upper_arm_left];
  const double s8_1682 = mbgen::fma(work.s3_19, s8_1681, mbgen::fnma(s8_1411, s8_1414, s8_1538));
  const double s8_1683 = work.s8_1039 - tau[Coordinate::lower_arm_left];
  const double s8_1684 = mbgen::fma(work.s3_20, s8_1683, s8_1682);
  const double s8_1685 = mbgen::fma(work.s3_21, work.s8_968, s8_1684);
  const double s8_1686 = mbgen::fma(work.s3_22, work.s8_966, s8_1685);
  const double s8_1687 = mbgen::fma(work.Rz_arb_front_left_0, work.s8_893, s8_1686);
  const double s8_1688 = mbgen::fnma(work.s2_280, work.s8_1357, s8_1678);
  const double s8_1689 = work.s8_713 + work.f_carrier_left_y;
  const double s8_1690 = work.s8_604 + (work.f_carrier_right_y + (work.s8_884 + s8_1689));
  const double s8_1691 = work.s8_768 + s8_1690 - s8_1649 - work.s8_760 - work.s8_737;
  const double s8_1692 = mbgen::fnma(work.s7_141, work.s8_871, s8_1691) - work.s8_1025;
  const double s8_1693 = mbgen::fma(s8_1528, s8_1595, mbgen::fma(s8_1411, s8_1622, s8_1692));
  const double s8_1694 = work.s7_4 - mbgen::fma(s8_1550, s8_1687, s8_1693);
  const double s8_1695 = work.s8_716 + (work.s8_902 + (work.f_carrier_left_x + work.s8_1030));
  const double s8_1696 = work.s8_782 + (work.f_carrier_right_x + (work.s8_874 + s8_1695));
  const double s8_1697 = work.s8_756 + (work.s8_616 + (work.s7_232 + (work.s8_739 + s8_1696)));
  const double s8_1698 = mbgen::fma(s8_1528, s8_1594, mbgen::fma(s8_1411, s8_1600, s8_1697));
  const double s8_1699 = work.s7_9 - mbgen::fma(s8_1543, s8_1687, s8_1698);
  const double s8_1700 = work.f_carrier_left_z + work.s8_1024;
  const double s8_1701 = work.f_carrier_right_z + mbgen::fma(work.s7_143, work.s8_871, s8_1700);
  const double s8_1702 = work.s8_755 + (work.s8_626 + (work.s7_231 + (work.s8_736 + s8_1701)));
  const double s8_1703 = s8_1702 - work.s8_741 - work.s8_718 - work.s8_714;
  const double s8_1704 = mbgen::fma(s8_1528, s8_1596, mbgen::fma(s8_1411, s8_1613, s8_1703));
  const double s8_1705 = work.s7_7 - mbgen::fma(s8_1556, s8_1687, s8_1704);
  const double s8_1706 = work.n_carrier_right_x + (work.n_carrier_left_x + work.s8_1033);
  const double s8_1707 = work.s8_646 + s8_1706 - work.s8_783 - work.s8_905;
  const double s8_1708 = mbgen::fma(s8_1528, s8_1598, mbgen::fma(s8_1411, s8_1638, s8_1707));
  const double s8_1709 = mbgen::fma(work.s7_252, work.s8_754, s8_1708);
  const double s8_1710 = mbgen::fma(work.s7_248, work.s8_753, s8_1709);
  const double s8_1711 = mbgen::fnma((-p_bell_crank_z), s8_1649, s8_1710);
  const double s8_1712 = mbgen::fnma(work.s7_235, work.s8_758, s8_1711);
  const double s8_1713 = mbgen::fnma(work.s7_237, work.s8_759, s8_1712);
  const double s8_1714 = mbgen::fma(work.s7_216, work.s8_20, s8_1713);
  const double s8_1715 = mbgen::fnma(work.zdd_star_arb_front_right, work.s7_214, s8_1714);
  const double s8_1716 = mbgen::fnma(work.s7_221, work.s8_767, s8_1715);
  const double s8_1717 = mbgen::fnma(work.s7_223, work.s8_766, s8_1716);
  const double s8_1718 = mbgen::fma(work.s2_223, work.f_carrier_right_y, s8_1717);
  const double s8_1719 = mbgen::fma(work.r_carrier_right_aux1_y, work.f_carrier_right_z, s8_1718);
  const double s8_1720 = mbgen::fnma(work.zdd_star_arb_front_left, work.s7_126, s8_1719);
  const double s8_1721 = mbgen::fnma(work.s7_124, work.s8_22, s8_1720);
  const double s8_1722 = mbgen::fnma(work.s7_135, work.s8_883, s8_1721);
  const double s8_1723 = mbgen::fnma(work.s7_137, work.s8_882, s8_1722);
  const double s8_1724 = mbgen::fma(work.r_carrier_left_aux1_y, work.f_carrier_left_z, s8_1723);
  const double s8_1725 = mbgen::fnma(work.r_carrier_left_aux1_z, work.f_carrier_left_y, s8_1724);
  const double s8_1726 = mbgen::fma(work.s2_199, work.s8_1087, s8_1725);
  const double s8_1727 = mbgen::fnma(work.s2_206, work.s8_1097, s8_1726);
  const double s8_1728 = mbgen::fma(work.s2_224, work.s8_1127, s8_1727);
  const double s8_1729 = mbgen::fma(work.s2_231, work.s8_1145, s8_1728);
  const double s8_1730 = mbgen::fma(work.s2_240, work.s8_1169, s8_1729);
  const double s8_1731 = mbgen::fnma(work.s2_242, work.s8_1181, s8_1730);
  const double s8_1732 = mbgen::fnma(work.s2_252, work.s8_1228, s8_1731);
  const double s8_1733 = mbgen::fnma(work.s2_246, work.s8_1238, s8_1732);
  const double s8_1734 = mbgen::fma(work.s2_273, work.s8_1365, s8_1733);
  const double s8_1735 = mbgen::fnma(work.s2_269, work.s8_1357, s8_1734);
  const double s8_1736 = work.s8_768 + (work.s7_231 + work.s8_884) - work.s8_736 - work.s8_714;
  const double s8_1737 = mbgen::fma(s8_1582, s8_1687, s8_1735);
  const double s8_1738 = mbgen::fnma(work.s7_143, work.s8_871, work.s8_1024 - work.s8_760);
  const double s8_1739 = mbgen::fma((-p_rear_axle_tx_z), s8_1736, s8_1737);
  const double s8_1740 = mbgen::fma(p_lower_arm_left_y, s8_1738, s8_1739);
  const double s8_1741 = mbgen::fma(p_carrier_left_rz_y, work.s8_741 - work.s8_718, s8_1740);
  const double s8_1742 = mbgen::fma(work.s7_141, work.s8_871, work.s8_1025);
  const double s8_1743 = mbgen::fnma((-p_lower_arm_left_z), s8_1742, s8_1741);
  const double s8_1744 = mbgen::fma((-p_upper_arm_right_z), work.s8_713 - work.s8_737, s8_1743);
  const double s8_1745 = mbgen::fms(tau[Coordinate::chassis_rx], work.s5_10, s8_1744);
  const double s8_1746 = work.f_carrier_right_y + s8_1689 - work.s8_737;
  const double s8_1747 = mbgen::fnma(work.s7_141, work.s8_871, s8_1746) - work.s8_1025;
  const double s8_1748 = mbgen::fma(s8_1567, s8_1687, s8_1688);
  const double s8_1749 = mbgen::fma(p_lower_arm_left_x, s8_1747, s8_1748);
  const double s8_1750 = work.s8_782 - work.s7_232 - work.s8_902;
  const double s8_1751 = mbgen::fma((-p_rear_axle_tx_z), s8_1750, s8_1749);
  const double s8_1752 = mbgen::fma(p_lower_arm_left_y, work.s8_874 - work.s8_1030, s8_1751);
  const double s8_1753 = mbgen::fma(p_carrier_left_rz_y, work.s8_739 - work.s8_716, s8_1752);
  const double s8_1754 = mbgen::fma(p_arb_front_left_x, work.s8_768 + work.s8_884, s8_1753);
  const double s8_1755 = work.s5_9 - s8_1754;
  const double s8_1756 = work.s8_714 - work.s8_736 - work.f_carrier_right_z;
  const double s8_1757 = mbgen::fnma(work.s7_143, work.s8_871, s8_1756) - work.f_carrier_left_z;
  const double s8_1758 = mbgen::fma(work.zdd_star_arb_front_left, work.s7_138,
      work.n_carrier_left_y);
  const double s8_1759 = work.s8_683 + (work.n_carrier_right_y + s8_1758);
  const double s8_1760 = mbgen::fma(work.zdd_star_arb_front_right, work.s7_224, s8_1759);
  const double s8_1761 = mbgen::fma(s8_1411, s8_1633, s8_1760 - work.s8_764);
  const double s8_1762 = mbgen::fma(s8_1528, s8_1599, s8_1761);
  const double s8_1763 = mbgen::fnma(work.s7_249, work.s8_753, s8_1762);
  const double s8_1764 = mbgen::fnma(work.s7_248, work.s8_754, s8_1763);
  const double s8_1765 = mbgen::fnma((-p_bell_crank_z), work.s8_756, s8_1764);
  const double s8_1766 = mbgen::fnma(p_bell_crank_x, work.s8_755, s8_1765);
  const double s8_1767 = mbgen::fnma((-p_pitman_arm_z), work.s7_232, s8_1766);
  const double s8_1768 = mbgen::fnma(p_pitman_arm_x, work.s7_231, s8_1767);
  const double s8_1769 = mbgen::fma(work.s7_204, work.s8_781, s8_1768);
  const double s8_1770 = mbgen::fma(work.s7_206, work.s8_780, s8_1769);
  const double s8_1771 = mbgen::fnma(work.s2_223, work.f_carrier_right_x, s8_1770);
  const double s8_1772 = mbgen::fma(work.s7_148, work.s8_873, s8_1771);
  const double s8_1773 = mbgen::fma(work.s7_150, work.s8_872, s8_1772);
  const double s8_1774 = mbgen::fma(work.s7_118, work.s8_900, s8_1773);
  const double s8_1775 = mbgen::fma(work.s7_120, work.s8_901, s8_1774);
  const double s8_1776 = mbgen::fma(work.r_carrier_left_aux1_z, work.f_carrier_left_x, s8_1775);
  const double s8_1777 = mbgen::fma(work.s7_61, work.s8_1028, s8_1776);
  const double s8_1778 = mbgen::fma(work.s7_63, work.s8_1029, s8_1777);
  const double s8_1779 = mbgen::fma(work.s2_193, work.s8_1097, s8_1778);
  const double s8_1780 = mbgen::fnma(work.s2_199, work.s8_1078, s8_1779);
  const double s8_1781 = mbgen::fma(work.s2_218, work.s8_1145, s8_1780);
  const double s8_1782 = mbgen::fnma(work.s2_224, work.s8_1136, s8_1781);
  const double s8_1783 = mbgen::fma(work.s2_238, work.s8_1181, s8_1782);
  const double s8_1784 = mbgen::fnma(work.s2_240, work.s8_1175, s8_1783);
  const double s8_1785 = mbgen::fnma(work.s2_260, work.s8_1228, s8_1784);
  const double s8_1786 = mbgen::fma(work.s2_246, work.s8_1219, s8_1785);
  const double s8_1787 = mbgen::fma(work.s2_280, work.s8_1365, s8_1786);
  const double s8_1788 = mbgen::fnma(work.s2_269, work.s8_1378, s8_1787);
  const double s8_1789 = mbgen::fma(s8_1593, s8_1687, s8_1788);
  const double s8_1790 = mbgen::fma(p_lower_arm_left_x, s8_1757 - work.s8_1024, s8_1789);
  const double s8_1791 = mbgen::fnma((-p_lower_arm_left_z), work.s8_874 + work.s8_1030, s8_1790);
  const double s8_1792 = mbgen::fnma((-p_rear_axle_tx_z), work.s8_739 + work.s8_716, s8_1791);
  const double s8_1793 = mbgen::fma(p_arb_front_left_x, work.s8_741 + work.s8_718, s8_1792);
  const double s8_1794 = mbgen::fnma((-p_upper_arm_right_z), work.s8_782 + work.s8_902, s8_1793);
  const double s8_1795 = work.s5_5 - s8_1794;
  // operations: 1213 add, 1099 multiply, 3 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_1796 = h_chassis_y + work.s8_1009;
  const double s8_1797 = s8_1460 + s8_1796;
  const double s8_1798 = s8_1610 + s8_1797;
  const double s8_1799 = K_chassis_xz + s8_1440;
  const double s8_1800 = s8_1642 + (s8_1464 + s8_1799);
  const double s8_1801 = mbgen::fnma(work.s8_33, s8_1799, s8_1755);
  const double s8_1802 = K_chassis_xy + s8_1450;
  const double s8_1803 = h_chassis_z + s8_1467;
  const double s8_1804 = s8_1463 + s8_1803;
  const double s8_1805 = s8_1420 - (-h_chassis_x);
  const double s8_1806 = s8_1461 + s8_1805;
  const double s8_1807 = s8_1806 - s8_1630;
  const double s8_1808 = mbgen::fnma(work.s8_32, s8_1805, s8_1694);
  const double s8_1809 = mbgen::fnma(work.s8_33, s8_1803, s8_1808);
  const double s8_1810 = K_chassis_zz + s8_1472;
  const double s8_1811 = work.s8_1270 + s8_1810;
  const double s8_1812 = K_chassis_yy + s8_1475;
  const double s8_1813 = work.s8_1268 + s8_1812;
  const double s8_1814 = K_chassis_xx + s8_1478;
  const double s8_1815 = s8_1479 + s8_1814;
  const double s8_1816 = 15306.0 - s8_1604;
  const double s8_1817 = 15306.0 - s8_1615;
  const double s8_1818 = 15306.0 - s8_1624;
  const double s8_1819 = s8_1813 + (s8_1811 + s8_1815);
  const double pivot_chassis_rx = s8_1819 - s8_1811 - s8_1680;
  const double s8_1820 = 1.0/pivot_chassis_rx;
  const double s8_1821 = s8_1820*s8_1637;
  const double s8_1822 = mbgen::fnma(s8_1798, s8_1821, s8_1804 - s8_1612);
  const double s8_1823 = mbgen::fma(s8_1821, s8_1800, s8_1644 + (s8_1465 + s8_1802));
  const double s8_1824 = mbgen::fma(s8_1619, s8_1821, s8_1621 + s8_1806);
  const double s8_1825 = mbgen::fms(s8_1821, s8_1807, s8_1632);
  const double s8_1826 = s8_1819 - s8_1813 - s8_1636;
  const double pivot_chassis_ry = mbgen::fnma(s8_1637, s8_1821, s8_1826);
  const double s8_1827 = 1.0/pivot_chassis_ry;
  const double s8_1828 = s8_1827*s8_1823;
  const double s8_1829 = s8_1820*s8_1800;
  const double s8_1830 = mbgen::fnma(s8_1798, s8_1829, mbgen::fms(s8_1822, s8_1828, s8_1608));
  const double s8_1831 = mbgen::fnma(s8_1619, s8_1829, s8_1797 - s8_1617);
  const double s8_1832 = mbgen::fnma(s8_1828, s8_1824, s8_1831);
  const double s8_1833 = mbgen::fms(s8_1829, s8_1807, s8_1628) - s8_1804;
  const double s8_1834 = mbgen::fma(s8_1828, s8_1825, s8_1833);
  const double s8_1835 = s8_1819 - s8_1815 - s8_1640;
  const double pivot_chassis_rz = mbgen::fnma(s8_1823, s8_1828, mbgen::fnma(s8_1800, s8_1829,
      s8_1835));
  const double s8_1836 = s8_1827*s8_1824;
  const double s8_1837 = s8_1619*s8_1820;
  const double s8_1838 = 1.0/pivot_chassis_rz;
  const double s8_1839 = s8_1838*s8_1832;
  const double s8_1840 = mbgen::fnma(s8_1798, s8_1837, mbgen::fms(s8_1822, s8_1836, s8_1606));
  const double s8_1841 = mbgen::fnma(s8_1830, s8_1839, s8_1840);
  const double s8_1842 = mbgen::fma(s8_1836, s8_1825, mbgen::fms(s8_1837, s8_1807, s8_1626));
  const double s8_1843 = mbgen::fnma(s8_1839, s8_1834, s8_1842);
  const double s8_1844 = mbgen::fnma(s8_1824, s8_1836, mbgen::fnma(s8_1619, s8_1837, s8_1817));
  const double pivot_chassis_tz = mbgen::fnma(s8_1832, s8_1839, s8_1844);
  const double s8_1845 = s8_1820*s8_1807;
  const double s8_1846 = s8_1827*s8_1825;
  const double s8_1847 = s8_1838*s8_1834;
  const double s8_1848 = mbgen::fnma(s8_1822, s8_1846, mbgen::fms(s8_1798, s8_1845, s8_1602));
  const double s8_1849 = 1.0/pivot_chassis_tz;
  const double s8_1850 = s8_1849*s8_1843;
  const double s8_1851 = mbgen::fnma(s8_1841, s8_1850, mbgen::fnma(s8_1830, s8_1847, s8_1848));
  const double s8_1852 = mbgen::fnma(s8_1825, s8_1846, mbgen::fnma(s8_1807, s8_1845, s8_1818));
  const double pivot_chassis_ty = mbgen::fnma(s8_1843, s8_1850, mbgen::fnma(s8_1834, s8_1847,
      s8_1852));
  const double s8_1853 = s8_1798*s8_1820;
  const double s8_1854 = s8_1822*s8_1827;
  const double s8_1855 = s8_1830*s8_1838;
  const double s8_1856 = mbgen::fnma(s8_1822, s8_1854, mbgen::fnma(s8_1798, s8_1853, s8_1816));
  const double s8_1857 = s8_1841*s8_1849;
  const double s8_1858 = 1.0/pivot_chassis_ty;
  const double s8_1859 = s8_1851*s8_1858;
  const double s8_1860 = mbgen::fnma(s8_1841, s8_1857, mbgen::fnma(s8_1830, s8_1855, s8_1856));
  const double pivot_chassis_tx = mbgen::fnma(s8_1851, s8_1859, s8_1860);
  result.inertia[5] = mbgen::fnma(1e-12, pivot_chassis_rx, pivot_chassis_rx);
  const double s8_1861 = mbgen::fma(work.s8_41, s8_1458, s8_1801);
  const double s8_1862 = mbgen::fma(work.s8_32, s8_1812 - s8_1814, s8_1861);
  const double s8_1863 = mbgen::fma(s8_1409, s8_1802, s8_1862);
  const double s8_1864 = mbgen::fnma(work.s8_32, s8_1458, mbgen::fma(s8_1821, s8_1863, s8_1795));
  const double s8_1865 = mbgen::fnma(work.s8_32, s8_1796, mbgen::fma(s8_1853, s8_1863, s8_1699));
  const double s8_1866 = mbgen::fnma(work.s8_41, s8_1803, s8_1865);
  const double s8_1867 = mbgen::fnma(1e-12, s8_1826, pivot_chassis_ry);
  const double s8_1868 = mbgen::fma(work.s8_33, s8_1802, s8_1864);
  const double s8_1869 = mbgen::fma(work.s8_41, s8_1814 - s8_1810, s8_1868);
  const double s8_1870 = mbgen::fma(work.s8_544, s8_1799, s8_1869);
  const double s8_1871 = mbgen::fma(s8_1829, s8_1863, mbgen::fma(s8_1828, s8_1870, s8_1745));
  const double s8_1872 = mbgen::fnma(work.s8_41, s8_1802, s8_1871);
  const double s8_1873 = mbgen::fma(s8_1837, s8_1863, mbgen::fma(s8_1836, s8_1870, s8_1705));
  const double s8_1874 = mbgen::fnma(work.s8_33, s8_1796, s8_1873);
  const double s8_1875 = mbgen::fnma(work.s8_41, s8_1805, s8_1874);
  const double s8_1876 = mbgen::fnma(s8_1845, s8_1863, mbgen::fma(work.s8_57, s8_1796, s8_1809));
  result.inertia[3] = mbgen::fnma(1e-12, s8_1835, pivot_chassis_rz);
  result.inertia[2] = mbgen::fnma(1e-12, s8_1817, pivot_chassis_tz);
  result.inertia[1] = mbgen::fnma(1e-12, s8_1818, pivot_chassis_ty);
  const double s8_1877 = mbgen::fma(work.s8_32, s8_1799, s8_1872);
  const double s8_1878 = mbgen::fma(work.s8_33, s8_1810 - s8_1812, s8_1877);
  const double s8_1879 = mbgen::fma(s8_1458, s8_1526, s8_1878);
  const double s8_1880 = mbgen::fnma(s8_1839, s8_1879, mbgen::fma(work.s8_44, s8_1803, s8_1875));
  const double s8_1881 = mbgen::fnma(s8_1847, s8_1879, mbgen::fnma(s8_1846, s8_1870, s8_1876));
  const double s8_1882 = mbgen::fnma(s8_1850, s8_1880, s8_1881);
  const double s8_1883 = mbgen::fnma(s8_1854, s8_1870, mbgen::fma(work.s8_49, s8_1805, s8_1866));
  const double s8_1884 = mbgen::fnma(s8_1857, s8_1880, mbgen::fnma(s8_1855, s8_1879, s8_1883));
  const double s8_1885 = mbgen::fnma(s8_1859, s8_1882, s8_1884);
  result.inertia[0] = mbgen::fnma(1e-12, s8_1816, pivot_chassis_tx);
  const double s8_1886 = 1.0/pivot_chassis_tx;
  // operations: 125 add, 113 multiply, 6 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double a_chassis_x = s8_1885*s8_1886;
  const double a_chassis_y = s8_1858*mbgen::fnma(s8_1851, a_chassis_x, s8_1882);
  const double s9_1 = mbgen::fnma(s8_1841, a_chassis_x, s8_1880);
  const double a_chassis_z = s8_1849*mbgen::fnma(s8_1843, a_chassis_y, s9_1);
  const double s9_2 = mbgen::fnma(s8_1830, a_chassis_x, s8_1879);
  const double s9_3 = mbgen::fnma(s8_1834, a_chassis_y, s9_2);
  const double alpha_chassis_x = s8_1838*mbgen::fnma(s8_1832, a_chassis_z, s9_3);
  const double s9_4 = mbgen::fnma(s8_1822, a_chassis_x, s8_1870);
  const double s9_5 = mbgen::fnma(s8_1825, a_chassis_y, s9_4);
  const double s9_6 = mbgen::fma(s8_1824, a_chassis_z, s9_5);
  const double alpha_chassis_y = s8_1827*mbgen::fma(s8_1823, alpha_chassis_x, s9_6);
  const double s9_7 = mbgen::fma(s8_1798, a_chassis_x, s8_1863);
  const double s9_8 = mbgen::fnma(s8_1807, a_chassis_y, s9_7);
  const double s9_9 = mbgen::fma(s8_1619, a_chassis_z, s9_8);
  const double s9_10 = mbgen::fma(s8_1800, alpha_chassis_x, s9_9);
  const double alpha_chassis_z = s8_1820*mbgen::fma(s8_1637, alpha_chassis_y, s9_10);
  const double s9_11 = mbgen::fnma((-g_z), work.R_chassis_z_y, a_chassis_y);
  const double s1_1 = work.sines[1];
  const double s9_12 = mbgen::fma((-g_z), s1_1, a_chassis_x);
  const double s9_13 = mbgen::fnma((-g_z), work.R_chassis_z_z, a_chassis_z);
  const double s9_14 = mbgen::fma(work.R_chassis_z_z, s9_13, work.R_chassis_z_y*s9_11);
  result.zdd[Coordinate::chassis_tz] = mbgen::fnma(s1_1, s9_12, s9_14);
  const double s9_15 = mbgen::fma(work.R_chassis_aux5_y_x, s9_12, work.R_chassis_y_y*s9_11);
  result.zdd[Coordinate::chassis_ty] = mbgen::fma(work.R_chassis_y_z, s9_13, s9_15);
  const double s9_16 = mbgen::fma(work.R_chassis_aux5_x_x, s9_12, work.R_chassis_x_y*s9_11);
  result.zdd[Coordinate::chassis_tx] = mbgen::fma(work.R_chassis_x_z, s9_13, s9_16);
  result.inertia[4] = mbgen::min(s8_1867, mbgen::fms(work.s1_6, work.s1_6, 1e-12));
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  const double s9_17 = mbgen::fma(work.s4_33, work.s4_4, alpha_chassis_y);
  const double s9_18 = mbgen::fnma(zd_chassis_rx, work.w_chassis_z, s9_17);
  const double s9_19 = mbgen::fma(zd_chassis_rx, work.w_chassis_y, alpha_chassis_z);
  const double s9_20 = mbgen::fma(work.s4_33, work.s4_2, s9_19);
  result.zdd[Coordinate::chassis_rz] = mbgen::fma(work.s5_7, s9_20, work.s5_3*s9_18);
  result.zdd[Coordinate::chassis_ry] = mbgen::fnma(work.sines[2], s9_20, work.cosines[2]*s9_18);
  const double s9_21 = mbgen::fma(work.s4_1, work.s4_4, alpha_chassis_x);
  const double s9_22 = mbgen::fma(work.s5_6, s9_20, work.s5_2*s9_18);
  result.zdd[Coordinate::chassis_rx] = mbgen::fma(work.s5_10, mbgen::fma(work.s4_2, work.s4_3,
      s9_21), s9_22);
  // bell_crank: bell_crank, revolute, chassis
  const double s9_23 = mbgen::fnma(s8_1549, a_chassis_y, s8_1687);
  const double s9_24 = mbgen::fnma(s8_1541, a_chassis_x, s9_23);
  const double s9_25 = mbgen::fnma(s8_1555, a_chassis_z, s9_24);
  const double s9_26 = mbgen::fnma(s8_1592, alpha_chassis_y, s9_25);
  const double s9_27 = mbgen::fnma(s8_1566, alpha_chassis_z, s9_26);
  const double s9_28 = s8_1542*mbgen::fnma(s8_1581, alpha_chassis_x, s9_27);
  const double s9_29 = mbgen::fnma(s8_1547, a_chassis_y, mbgen::fma(s8_1415, s9_28, s8_1528));
  const double s9_30 = mbgen::fnma(s8_1481, a_chassis_x, s9_29);
  const double s9_31 = mbgen::fnma(s8_1487, a_chassis_z, s9_30);
  const double s9_32 = mbgen::fnma(s8_1520, alpha_chassis_y, s9_31);
  const double s9_33 = mbgen::fnma(s8_1496, alpha_chassis_z, s9_32);
  const double s9_34 = s8_1416*mbgen::fnma(s8_1510, alpha_chassis_x, s9_33);
  result.zdd[Coordinate::lower_arm_right] = s9_34;
  const double s9_35 = mbgen::fnma(work.s8_1021, a_chassis_y, s8_1411);
  const double s9_36 = mbgen::fnma(work.s8_973, a_chassis_x, s9_35);
  const double s9_37 = mbgen::fnma(work.s8_1016, a_chassis_z, s9_36);
  const double s9_38 = mbgen::fnma(work.s8_1299, alpha_chassis_y, s9_37);
  const double s9_39 = mbgen::fnma(work.s8_1324, alpha_chassis_x, s9_38);
  const double s9_40 = mbgen::fnma(work.s8_1343, alpha_chassis_z, s9_39);
  const double s9_41 = mbgen::fnma(work.s8_1209, s9_28, s9_40);
  const double s9_42 = s8_1412*mbgen::fnma(work.s8_1277, s9_34, s9_41);
  result.zdd[Coordinate::bell_crank] = s9_42;
  const double s9_43 = mbgen::fma(work.Rz_arb_front_left_0, s9_28, work.zdd_star_arb_front_left);
  result.zdd[Coordinate::arb_front_left] = mbgen::fma(work.Rz_arb_front_left_2, s9_42, s9_43);
  const double s9_44 = mbgen::fma(work.Rz_lower_arm_left_2, s9_42, work.zdd_star_lower_arm_left);
  result.zdd[Coordinate::lower_arm_left] = mbgen::fnma(work.s3_20, s9_28, s9_44);
  const double s9_45 = mbgen::fma(work.Rz_carrier_right_ry_1, s9_34,
      work.zdd_star_carrier_right_ry);
  const double s9_46 = mbgen::fma(work.Rz_carrier_right_ry_2, s9_42, s9_45);
  const double s9_47 = mbgen::fma(work.Rz_carrier_right_rx_1, s9_34,
      work.zdd_star_carrier_right_rx);
  const double s9_48 = mbgen::fma(work.Rz_carrier_right_rx_2, s9_42, s9_47);
  const double s9_49 = mbgen::fma(work.Rz_arb_front_right_1, s9_34, work.zdd_star_arb_front_right);
  result.zdd[Coordinate::arb_front_right] = mbgen::fma(work.Rz_arb_front_right_2, s9_42, s9_49);
  const double s9_50 = mbgen::fnma(work.s3_21, s9_28, work.zdd_star_carrier_left_ry);
  const double s9_51 = mbgen::fnma(work.s3_24, s9_42, s9_50);
  const double s9_52 = mbgen::fnma(work.s3_22, s9_28, work.zdd_star_carrier_left_rx);
  const double s9_53 = mbgen::fnma(work.s3_25, s9_42, s9_52);
  const double s9_54 = mbgen::fms(work.Rz_upper_arm_left_2, s9_42, work.s6_165);
  result.zdd[Coordinate::upper_arm_left] = mbgen::fnma(work.s3_19, s9_28, s9_54);
  result.zdd[Coordinate::pitman_arm] = -mbgen::fma(work.s3_60, s9_42, work.s6_192);
  const double s9_55 = mbgen::fma(work.s3_36, s9_34, work.s6_182);
  result.zdd[Coordinate::upper_arm_right] = -mbgen::fma(work.s3_38, s9_42, s9_55);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double alpha_carrier_left_x = mbgen::fma(work.s8_744, s9_28,
      alpha_chassis_x + (work.s4_15 + s9_44));
  const double alpha_carrier_left_y = alpha_chassis_y + (work.s4_44 + s9_53);
  const double alpha_carrier_left_z = alpha_chassis_z + (work.s4_43 + s9_51);
  const double s9_56 = mbgen::fma(work.s4_5, work.s4_8, s9_28);
  const double s9_57 = mbgen::fma(work.s4_6, work.s4_7, s9_56);
  const double s9_58 = mbgen::fnma(work.s4_10, work.s4_13, s9_57);
  const double s9_59 = mbgen::fma(work.s4_9, work.s4_11, s9_58);
  const double s9_60 = mbgen::fma(work.s4_10, work.s4_41, s9_53);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s9_61 = mbgen::fnma(work.s4_6, work.s4_39, s9_60);
  const double s9_62 = mbgen::fma(work.s4_11, zd_lower_arm_left + work.s4_40, s9_61);
  const double s9_63 = mbgen::fnma(work.s4_5, work.s4_39, s9_51);
  const double s9_64 = mbgen::fnma(work.s4_40, work.s4_13, s9_63);
  const double s9_65 = mbgen::fnma(work.s4_9, work.s4_41, s9_64);
  const double s9_66 = mbgen::fma(zd_lower_arm_left, work.s4_5 - work.s4_7, s9_65);
  const double s9_67 = mbgen::fma(work.cosines[4], s9_59, work.R_carrier_left_aux1_y_x*s9_62);
  result.zdd[Coordinate::carrier_left_rx] = mbgen::fma(work.R_carrier_left_aux1_z_x, s9_66, s9_67);
  const double s9_68 = mbgen::fma(work.s5_12, s9_66, work.s5_14*s9_62);
  result.zdd[Coordinate::carrier_left_ry] = mbgen::fnma(work.s5_21, s9_59, s9_68);
  const double s9_69 = mbgen::fma(work.s5_19, s9_59, work.s5_16*s9_66);
  result.zdd[Coordinate::carrier_left_rz] = mbgen::fnma(work.s5_24, s9_62, s9_69);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s9_70 = mbgen::fma(work.Rz_carrier_right_rz_2, s9_42,
      work.zdd_star_carrier_right_rz);
  const double alpha_carrier_right_x = mbgen::fma(work.s8_785, s9_34,
      alpha_chassis_x + (work.s4_26 + s9_70));
  const double alpha_carrier_right_y = alpha_chassis_y + (work.s4_50 + s9_48);
  const double alpha_carrier_right_z = alpha_chassis_z + (work.s4_49 + s9_46);
  const double s9_71 = mbgen::fnma(work.s3_37, s9_34, s9_70);
  const double s9_72 = mbgen::fma(work.s4_16, work.s4_19, s9_71);
  const double s9_73 = mbgen::fma(work.s4_17, work.s4_18, s9_72);
  const double s9_74 = mbgen::fnma(work.s4_21, work.s4_24, s9_73);
  const double s9_75 = mbgen::fma(work.s4_20, work.s4_22, s9_74);
  const double s9_76 = mbgen::fma(work.s4_21, work.s4_47, s9_48);
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s9_77 = mbgen::fnma(work.s4_17, work.s4_45, s9_76);
  const double s9_78 = mbgen::fma(work.s4_22, zd_lower_arm_right + work.s4_46, s9_77);
  const double s9_79 = mbgen::fnma(work.s4_16, work.s4_45, s9_46);
  const double s9_80 = mbgen::fnma(work.s4_46, work.s4_24, s9_79);
  const double s9_81 = mbgen::fnma(work.s4_20, work.s4_47, s9_80);
  const double s9_82 = mbgen::fma(zd_lower_arm_right, work.s4_16 - work.s4_18, s9_81);
  const double s9_83 = mbgen::fma(work.cosines[10], s9_75, work.R_carrier_right_aux1_y_x*s9_78);
  result.zdd[Coordinate::carrier_right_rx] = mbgen::fma(work.R_carrier_right_aux1_z_x, s9_82,
      s9_83);
  const double s9_84 = mbgen::fma(work.s5_28, s9_82, work.s5_30*s9_78);
  result.zdd[Coordinate::carrier_right_ry] = mbgen::fnma(work.s5_37, s9_75, s9_84);
  const double s9_85 = mbgen::fma(work.s5_35, s9_75, work.s5_32*s9_82);
  result.zdd[Coordinate::carrier_right_rz] = mbgen::fnma(work.s5_40, s9_78, s9_85);
  // bell_crank: bell_crank, revolute, chassis
  const double s9_86 = mbgen::min(work.s2_323, std::abs(work.s1_22));
  result.pivot[0] = mbgen::min(std::abs(work.s1_48), s9_86);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s9_87 = 0.09090909090909091*tau[Coordinate::wheel_front_left];
  const double s9_88 = mbgen::fnma(work.R_carrier_left_aux2_y_y, alpha_carrier_left_y, s9_87);
  const double s9_89 = mbgen::fnma(work.R_carrier_left_aux2_z_y, alpha_carrier_left_z, s9_88);
  result.zdd[Coordinate::wheel_front_left] = mbgen::fma(work.s1_17, alpha_carrier_left_x, s9_89);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s9_90 = 0.09090909090909091*tau[Coordinate::wheel_front_right];
  const double s9_91 = mbgen::fnma(work.R_carrier_right_aux2_y_y, alpha_carrier_right_y, s9_90);
  const double s9_92 = mbgen::fnma(work.R_carrier_right_aux2_z_y, alpha_carrier_right_z, s9_91);
  result.zdd[Coordinate::wheel_front_right] = mbgen::fma(work.s1_43, alpha_carrier_right_x, s9_92);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s9_93 = mbgen::fnma(work.s8_585, a_chassis_y, work.s8_601);
  const double s9_94 = mbgen::fnma(work.s8_552, a_chassis_x, s9_93);
  const double s9_95 = mbgen::fnma(work.s8_554, a_chassis_z, s9_94);
  const double s9_96 = mbgen::fnma(work.s8_584, alpha_chassis_y, s9_95);
  const double s9_97 = mbgen::fnma(work.s8_563, alpha_chassis_z, s9_96);
  const double s9_98 = work.s8_550*mbgen::fnma(work.s8_573, alpha_chassis_x, s9_97);
  result.zdd[Coordinate::arb_rear_left] = s9_98;
  const double s9_99 = mbgen::fnma(work.s8_101, a_chassis_y, work.s8_547);
  const double s9_100 = mbgen::fnma(work.s8_551, a_chassis_x, s9_99);
  const double s9_101 = mbgen::fnma(work.s8_553, a_chassis_z, s9_100);
  const double s9_102 = mbgen::fnma(work.s8_497, alpha_chassis_y, s9_101);
  const double s9_103 = mbgen::fnma(work.s8_478, alpha_chassis_x, s9_102);
  const double s9_104 = mbgen::fnma(work.s8_487, alpha_chassis_z, s9_103);
  const double s9_105 = work.s8_548*mbgen::fnma(work.s8_448, s9_98, s9_104);
  result.zdd[Coordinate::arb_rear_right] = s9_105;
  const double s9_106 = mbgen::fma(work.Rz_rear_axle_ry_0, s9_98, work.zdd_star_rear_axle_ry);
  const double s9_107 = mbgen::fma(work.Rz_rear_axle_ry_1, s9_105, s9_106);
  const double s9_108 = mbgen::fma(work.Rz_rear_axle_rx_0, s9_98, work.zdd_star_rear_axle_rx);
  const double s9_109 = mbgen::fma(work.Rz_rear_axle_rx_1, s9_105, s9_108);
  const double s9_110 = mbgen::fma(work.Rz_rear_axle_tx_0, s9_98, work.zdd_star_rear_axle_tx);
  result.zdd[Coordinate::rear_axle_tx] = mbgen::fma(work.Rz_rear_axle_tx_1, s9_105, s9_110);
  const double s9_111 = mbgen::fnma(work.s3_2, s9_98, work.zdd_star_rear_axle_tz);
  result.zdd[Coordinate::rear_axle_tz] = mbgen::fma(work.Rz_rear_axle_tz_1, s9_105, s9_111);
  const double s9_112 = mbgen::fma(work.Rz_rear_axle_rz_0, s9_98, work.zdd_star_rear_axle_rz);
  const double s9_113 = mbgen::fnma(work.s3_10, s9_105, s9_112);
  const double s9_114 = mbgen::fma(work.s3_14, s9_105, mbgen::fma(work.s3_8, s9_98, work.s6_77));
  result.zdd[Coordinate::rear_axle_ty] = -s9_114;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double alpha_rear_axle_x = alpha_chassis_x + (work.s4_32 + s9_113);
  const double alpha_rear_axle_y = alpha_chassis_y + (work.s4_38 + s9_107);
  const double alpha_rear_axle_z = alpha_chassis_z + (work.s4_37 + s9_109);
  const double s9_115 = work.R_rear_axle_y_y*alpha_rear_axle_y;
  const double s9_116 = mbgen::fma(work.R_rear_axle_z_y, alpha_rear_axle_z, s9_115);
  const double s9_117 = mbgen::fma(work.R_rear_axle_x_y, alpha_rear_axle_x, s9_116);
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s9_118 = mbgen::fma(work.s4_34, work.s4_29, s9_107);
  const double s9_119 = mbgen::fma(zd_rear_axle_rz, work.s4_34 - work.s4_35, s9_118);
  const double s9_120 = mbgen::fma(work.s4_27, work.s4_29, s9_113);
  const double s9_121 = mbgen::fma(zd_rear_axle_rz, work.s4_30, s9_120);
  result.zdd[Coordinate::rear_axle_rx] = mbgen::fma(work.s5_50, s9_121, work.s5_44*s9_119);
  result.zdd[Coordinate::rear_axle_ry] = mbgen::fnma(work.sines[17], s9_121,
      work.cosines[17]*s9_119);
  const double s9_122 = mbgen::fma(work.s4_34, work.s4_28, s9_109);
  const double s9_123 = mbgen::fma(work.s5_49, s9_121, work.s5_46*s9_119);
  const double s9_124 = mbgen::fma(work.s4_27, work.s4_35, s9_122);
  result.zdd[Coordinate::rear_axle_rz] = mbgen::fma(work.s5_53, s9_124, s9_123);
  // arb_rear_right: arb_rear_right, revolute, chassis
  result.pivot[1] = mbgen::min(work.s2_159, std::abs(work.s1_58));
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  result.zdd[Coordinate::wheel_rear_left] = mbgen::fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_left], s9_117);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  result.zdd[Coordinate::wheel_rear_right] = mbgen::fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_right], s9_117);
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
  const double s1_2 = (-p_carrier_left_rz_z)*R_lower_arm_left_z_y;
  const double s1_3 = mbgen::fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_2);
  const double r_carrier_left_aux1_y = p_lower_arm_left_y + s1_3;
  const double s1_4 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_5 = mbgen::fnma((-p_carrier_left_rz_z), R_lower_arm_left_y_y, s1_4);
  const double r_carrier_left_aux1_z = s1_5 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_6 = cosines[2];
  const double s1_7 = s1_1*s1_6;
  const double s1_8 = sines[2];
  const double R_carrier_left_aux2_x_z = s1_1*s1_8;
  const double R_carrier_left_aux2_y_y = mbgen::fnma(R_lower_arm_left_z_y, s1_8,
      R_carrier_left_aux1_y_y*s1_6);
  const double s1_9 = mbgen::fma(R_carrier_left_aux1_y_y, s1_8, R_lower_arm_left_z_y*s1_6);
  const double R_carrier_left_aux2_z_y = mbgen::fma(R_carrier_left_aux1_z_y, s1_6,
      R_lower_arm_left_y_y*s1_8);
  const double R_carrier_left_aux2_z_z = mbgen::fnma(R_carrier_left_aux1_z_y, s1_8,
      R_lower_arm_left_y_y*s1_6);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_10 = cosines[3];
  const double s1_11 = sines[3];
  const double s1_12 = R_carrier_left_aux1_x_x*s1_10;
  const double R_carrier_left_x_x = mbgen::fnma(R_carrier_left_aux2_x_z, s1_11, s1_12);
  const double s1_13 = R_carrier_left_aux1_x_x*s1_11;
  const double R_carrier_left_x_z = mbgen::fma(R_carrier_left_aux2_x_z, s1_10, s1_13);
  const double R_carrier_left_y_x = mbgen::fma(s1_9, s1_11, R_carrier_left_aux1_y_x*s1_10);
  const double R_carrier_left_y_z = mbgen::fnma(s1_9, s1_10, R_carrier_left_aux1_y_x*s1_11);
  const double s1_14 = R_carrier_left_aux1_z_x*s1_10;
  const double R_carrier_left_z_x = mbgen::fnma(R_carrier_left_aux2_z_z, s1_11, s1_14);
  const double s1_15 = R_carrier_left_aux1_z_x*s1_11;
  const double R_carrier_left_z_z = mbgen::fma(R_carrier_left_aux2_z_z, s1_10, s1_15);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = cosines[6];
  const double s1_16 = sines[7];
  const double R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_16;
  const double R_carrier_right_aux1_x_x = cosines[7];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = sines[6];
  const double R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_16;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_17 = (-p_carrier_right_rz_z)*R_lower_arm_right_z_y;
  const double s1_18 = mbgen::fnma((-p_carrier_right_rz_y), R_lower_arm_right_y_y, s1_17);
  const double r_carrier_right_aux1_y = s1_18 - (-p_lower_arm_right_y);
  const double s1_19 = (-p_carrier_right_rz_y)*R_lower_arm_right_z_y;
  const double s1_20 = mbgen::fma((-p_carrier_right_rz_z), R_lower_arm_right_y_y, s1_19);
  const double s1_21 = (-p_lower_arm_right_z) + s1_20;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_22 = cosines[8];
  const double s1_23 = s1_16*s1_22;
  const double s1_24 = sines[8];
  const double R_carrier_right_aux2_x_z = s1_16*s1_24;
  const double s1_25 = R_carrier_right_aux1_y_y*s1_22;
  const double R_carrier_right_aux2_y_y = mbgen::fnma(R_lower_arm_right_z_y, s1_24, s1_25);
  const double s1_26 = mbgen::fma(R_carrier_right_aux1_y_y, s1_24, R_lower_arm_right_z_y*s1_22);
  const double R_carrier_right_aux2_z_y = mbgen::fma(R_carrier_right_aux1_z_y, s1_22,
      R_lower_arm_right_y_y*s1_24);
  const double s1_27 = R_lower_arm_right_y_y*s1_22;
  const double R_carrier_right_aux2_z_z = mbgen::fnma(R_carrier_right_aux1_z_y, s1_24, s1_27);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_28 = cosines[9];
  const double s1_29 = sines[9];
  const double s1_30 = R_carrier_right_aux1_x_x*s1_28;
  const double R_carrier_right_x_x = mbgen::fnma(R_carrier_right_aux2_x_z, s1_29, s1_30);
  const double s1_31 = R_carrier_right_aux1_x_x*s1_29;
  const double R_carrier_right_x_z = mbgen::fma(R_carrier_right_aux2_x_z, s1_28, s1_31);
  const double R_carrier_right_y_x = mbgen::fma(s1_26, s1_29, R_carrier_right_aux1_y_x*s1_28);
  const double R_carrier_right_y_z = mbgen::fnma(s1_26, s1_28, R_carrier_right_aux1_y_x*s1_29);
  const double s1_32 = R_carrier_right_aux1_z_x*s1_28;
  const double R_carrier_right_z_x = mbgen::fnma(R_carrier_right_aux2_z_z, s1_29, s1_32);
  const double s1_33 = R_carrier_right_aux1_z_x*s1_29;
  const double R_carrier_right_z_z = mbgen::fma(R_carrier_right_aux2_z_z, s1_28, s1_33);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = cosines[14];
  const double R_rear_axle_aux5_z_z = cosines[15];
  const double R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_34 = sines[15];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_34;
  const double R_rear_axle_aux4_y_x = sines[14];
  const double R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_34;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_35 = sines[16];
  const double s1_36 = cosines[16];
  const double R_rear_axle_x_y = mbgen::fnma(R_rear_axle_aux4_y_x, s1_36,
      R_rear_axle_aux5_x_z*s1_35);
  const double R_rear_axle_x_z = mbgen::fma(R_rear_axle_aux5_x_z, s1_36,
      R_rear_axle_aux4_y_x*s1_35);
  const double R_rear_axle_y_y = mbgen::fma(R_rear_axle_aux5_y_z, s1_35,
      R_rear_axle_aux4_x_x*s1_36);
  const double R_rear_axle_y_z = mbgen::fnma(R_rear_axle_aux4_x_x, s1_35,
      R_rear_axle_aux5_y_z*s1_36);
  const double R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_35;
  const double R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_36;
  // operations: 34 add, 74 multiply, 38 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  // upper_ball_left
  const double R_upper_arm_left_z_y = sines[4];
  const double R_upper_arm_left_y_y = cosines[4];
  const double s2_1 = (-p_upper_arm_left_ball_z)*R_upper_arm_left_z_y;
  const double s2_2 = mbgen::fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s2_1);
  const double s2_3 = (-p_carrier_left_upper_ball_y)*R_carrier_left_aux2_z_y;
  const double s2_4 = (-p_carrier_left_upper_ball_y)*R_carrier_left_aux2_y_y;
  const double s2_5 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_6 = mbgen::fnma((-p_upper_arm_left_ball_z), R_upper_arm_left_y_y, s2_5);
  const double s2_7 = (-p_carrier_left_upper_ball_y)*s1_7;
  const double s2_8 = mbgen::fma(p_carrier_left_upper_ball_z, R_carrier_left_x_z, s2_7);
  result.residual[0] = s2_8;
  const double s2_9 = R_lower_arm_left_z_y*s2_8;
  const double s2_10 = mbgen::fms(p_carrier_left_upper_ball_z, R_carrier_left_z_z, s2_3);
  const double s2_11 = mbgen::fms(p_carrier_left_upper_ball_z, R_carrier_left_y_z, s2_4);
  const double s2_12 = s1_5 + s2_10;
  const double s2_13 = r_carrier_left_aux1_y + s2_11 - s2_2 - p_upper_arm_left_y;
  result.residual[1] = s2_13;
  const double s2_14 = (-p_upper_arm_left_z) + (r_carrier_left_aux1_z + s2_10 - s2_6);
  result.residual[2] = s2_14;
  const double s2_15 = R_carrier_left_aux1_x_x*s2_11;
  const double s2_16 = mbgen::fnma(R_carrier_left_aux1_y_x, s2_8, s2_15);
  const double s2_17 = R_carrier_left_aux1_y_x*s2_10;
  const double s2_18 = mbgen::fnma(R_carrier_left_aux1_z_x, s2_11, s2_17);
  const double s2_19 = s1_3 + s2_11;
  const double s2_20 = mbgen::fma(R_carrier_left_aux2_y_y, s2_8, s1_7*s2_11);
  // upper_ball_right
  const double R_upper_arm_right_z_y = sines[10];
  const double R_upper_arm_right_y_y = cosines[10];
  const double s2_21 = (-p_upper_arm_right_ball_z)*R_upper_arm_right_z_y;
  const double s2_22 = mbgen::fnma((-p_upper_arm_right_ball_y), R_upper_arm_right_y_y, s2_21);
  const double s2_23 = p_carrier_right_upper_ball_y*s1_23;
  const double s2_24 = mbgen::fms(p_carrier_right_upper_ball_z, R_carrier_right_x_z, s2_23);
  result.residual[3] = s2_24;
  const double s2_25 = R_lower_arm_right_z_y*s2_24;
  const double s2_26 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_z_y;
  const double s2_27 = mbgen::fma(p_carrier_right_upper_ball_z, R_carrier_right_z_z, s2_26);
  const double s2_28 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_y_y;
  const double s2_29 = mbgen::fma(p_carrier_right_upper_ball_z, R_carrier_right_y_z, s2_28);
  const double s2_30 = (-p_upper_arm_right_ball_y)*R_upper_arm_right_z_y;
  const double s2_31 = mbgen::fma((-p_upper_arm_right_ball_z), R_upper_arm_right_y_y, s2_30);
  const double s2_32 = s1_20 - s2_27;
  const double s2_33 = (-p_upper_arm_right_z) + (s2_27 + s2_31 - s1_21);
  result.residual[5] = s2_33;
  const double s2_34 = s1_18 + s2_29;
  const double s2_35 = (-p_upper_arm_right_y) + (r_carrier_right_aux1_y + s2_29 - s2_22);
  result.residual[4] = s2_35;
  const double s2_36 = R_carrier_right_aux1_x_x*s2_29;
  const double s2_37 = mbgen::fnma(R_carrier_right_aux1_y_x, s2_24, s2_36);
  const double s2_38 = mbgen::fma(R_lower_arm_right_y_y, s2_29, R_lower_arm_right_z_y*s2_27);
  const double s2_39 = mbgen::fma(R_carrier_right_aux2_y_y, s2_24, s1_23*s2_29);
  // arb_link_front_left
  const double R_arb_front_left_x_z = sines[5];
  const double R_arb_front_left_x_x = cosines[5];
  const double s2_40 = (-p_arb_link_front_left_from_x)*R_arb_front_left_x_z;
  const double s2_41 = mbgen::fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s2_40);
  const double s2_42 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s2_43 = mbgen::fnma((-p_arb_link_front_left_from_x), R_arb_front_left_x_x, s2_42);
  const double s2_44 = p_arb_link_front_left_to_x*R_carrier_left_x_x;
  const double s2_45 = s1_7 + R_carrier_left_x_z;
  const double s2_46 = mbgen::fma((-p_arb_link_front_left_to_y), s2_45, s2_44);
  const double s2_47 = 0.35 + (s2_43 - s2_46);
  const double s2_48 = 3.846153846153846*s2_47;
  const double s2_49 = p_arb_link_front_left_to_x*R_carrier_left_z_x;
  const double s2_50 = R_carrier_left_z_z - R_carrier_left_aux2_z_y;
  const double s2_51 = mbgen::fma((-p_arb_link_front_left_to_y), s2_50, s2_49);
  const double s2_52 = s2_41 - r_carrier_left_aux1_z - s2_51 - (-p_arb_front_left_z);
  const double s2_53 = 3.846153846153846*s2_52;
  const double pivot_arb_front_left = mbgen::fnma(s2_43, s2_53, s2_41*s2_48);
  const double s2_54 = p_arb_link_front_left_to_x*R_carrier_left_y_x;
  const double s2_55 = R_carrier_left_y_z - R_carrier_left_aux2_y_y;
  const double s2_56 = mbgen::fma((-p_arb_link_front_left_to_y), s2_55, s2_54);
  const double s2_57 = 0.72 - r_carrier_left_aux1_y - s2_56;
  const double s2_58 = 3.846153846153846*s2_57;
  const double s2_59 = mbgen::fnma(s2_51, s2_58, s2_53*s2_56);
  const double s2_60 = mbgen::fnma(s1_5, s2_58, mbgen::fma(s1_3, s2_53, s2_59));
  const double s2_61 = mbgen::fnma(s2_48, s2_56, s2_46*s2_58);
  const double s2_62 = mbgen::fnma(s2_46, s2_53, s2_48*s2_51);
  const double s2_63 = mbgen::fms(s2_57, s2_58, l_arb_link_front_left);
  const double s2_64 = 0.5*mbgen::fma(s2_52, s2_53, mbgen::fma(s2_47, s2_48, s2_63));
  result.residual[6] = s2_64;
  const double s2_65 = mbgen::fnma(R_lower_arm_left_z_y, s2_62, R_lower_arm_left_y_y*s2_61);
  const double s2_66 = R_carrier_left_aux1_y_x*s2_62;
  const double s2_67 = mbgen::fma(R_carrier_left_aux1_x_x, s2_59, s2_66);
  const double s2_68 = mbgen::fma(R_carrier_left_aux1_z_x, s2_61, s2_67);
  const double s2_69 = R_carrier_left_aux2_y_y*s2_62;
  const double s2_70 = mbgen::fma(R_carrier_left_aux2_z_y, s2_61, s2_69);
  const double s2_71 = mbgen::fnma(s1_7, s2_59, s2_70);
  // arb_link_front_right
  const double R_arb_front_right_x_z = sines[11];
  const double R_arb_front_right_x_x = cosines[11];
  const double s2_72 = (-p_arb_link_front_right_from_x)*R_arb_front_right_x_z;
  const double s2_73 = mbgen::fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s2_72);
  const double s2_74 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s2_75 = mbgen::fnma((-p_arb_link_front_right_from_x), R_arb_front_right_x_x, s2_74);
  const double s2_76 = p_arb_link_front_right_to_x*R_carrier_right_x_x;
  const double s2_77 = R_carrier_right_x_z - s1_23;
  const double s2_78 = mbgen::fma((-p_arb_link_front_left_to_y), s2_77, s2_76);
  const double s2_79 = 0.35 + (s2_75 - s2_78);
  const double s2_80 = 3.846153846153846*s2_79;
  const double s2_81 = p_arb_link_front_right_to_x*R_carrier_right_z_x;
  const double s2_82 = R_carrier_right_aux2_z_y + R_carrier_right_z_z;
  const double s2_83 = mbgen::fma((-p_arb_link_front_left_to_y), s2_82, s2_81);
  const double s2_84 = s1_21 + s2_73 - s2_83 - (-p_arb_front_right_z);
  const double s2_85 = 3.846153846153846*s2_84;
  const double pivot_arb_front_right = mbgen::fnma(s2_75, s2_85, s2_73*s2_80);
  const double s2_86 = p_arb_link_front_right_to_x*R_carrier_right_y_x;
  const double s2_87 = R_carrier_right_aux2_y_y + R_carrier_right_y_z;
  const double s2_88 = mbgen::fma((-p_arb_link_front_left_to_y), s2_87, s2_86);
  const double s2_89 = 0.72 + (r_carrier_right_aux1_y + s2_88);
  const double s2_90 = 3.846153846153846*s2_89;
  const double s2_91 = mbgen::fma(s2_80, s2_88, s2_78*s2_90);
  const double s2_92 = mbgen::fma(s2_85, s2_88, s2_83*s2_90);
  const double s2_93 = mbgen::fnma(s1_20, s2_90, mbgen::fma(s1_18, s2_85, s2_92));
  const double s2_94 = mbgen::fnma(s2_78, s2_85, s2_80*s2_83);
  const double s2_95 = mbgen::fms(s2_89, s2_90, l_arb_link_front_right);
  const double s2_96 = 0.5*mbgen::fma(s2_84, s2_85, mbgen::fma(s2_79, s2_80, s2_95));
  result.residual[7] = s2_96;
  const double s2_97 = mbgen::fma(R_lower_arm_right_y_y, s2_91, R_lower_arm_right_z_y*s2_94);
  const double s2_98 = R_carrier_right_aux1_y_x*s2_94;
  const double s2_99 = mbgen::fma(R_carrier_right_aux1_x_x, s2_92, s2_98);
  const double s2_100 = mbgen::fnma(R_carrier_right_aux1_z_x, s2_91, s2_99);
  const double s2_101 = mbgen::fnma(s1_23, s2_92, R_carrier_right_aux2_y_y*s2_94);
  const double s2_102 = mbgen::fnma(R_carrier_right_aux2_z_y, s2_91, s2_101);
  // drag_link
  const double s2_103 = (-p_drag_link_from_z)*sines[12];
  const double s2_104 = (-p_drag_link_from_z)*cosines[12];
  const double s2_105 = 0.2 - s2_104;
  const double s2_106 = 0.8565801464479954*s2_105;
  const double R_bell_crank_y_x = sines[13];
  const double s2_107 = p_drag_link_to_y*R_bell_crank_y_x;
  const double s2_108 = 1.15 + (s2_107 - s2_103);
  const double s2_109 = 0.8565801464479954*s2_108;
  const double pivot_pitman_arm = mbgen::fnma(s2_104, s2_109, s2_103*s2_106);
  const double R_bell_crank_x_x = cosines[13];
  const double s2_110 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s2_111 = p_pitman_arm_y - s2_110;
  const double s2_112 = 0.8565801464479954*s2_111;
  const double s2_113 = mbgen::fma(s2_109, s2_110, s2_107*s2_112);
  const double s2_114 = mbgen::fma(s2_105, s2_106, mbgen::fms(s2_111, s2_112, l_drag_link));
  const double s2_115 = 0.5*mbgen::fma(s2_108, s2_109, s2_114);
  result.residual[8] = s2_115;
  // tie_rod_left
  const double s2_116 = mbgen::fma(p_tie_rod_left_to_z, R_carrier_left_x_z, s2_7);
  const double s2_117 = mbgen::fnma((-p_tie_rod_left_to_x), R_carrier_left_x_x, s2_116);
  const double s2_118 = mbgen::fms(p_tie_rod_left_to_z, R_carrier_left_z_z, s2_3);
  const double s2_119 = mbgen::fnma((-p_tie_rod_left_to_x), R_carrier_left_z_x, s2_118);
  const double s2_120 = (-p_bell_crank_z) + (r_carrier_left_aux1_z + s2_119);
  const double s2_121 = 1.262590031797617*s2_120;
  const double s2_122 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_123 = mbgen::fma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s2_122);
  const double s2_124 = 0.35 + (s2_117 + s2_123);
  const double s2_125 = 1.262590031797617*s2_124;
  const double s2_126 = mbgen::fnma(s2_119, s2_125, s2_117*s2_121);
  const double s2_127 = p_tie_rod_left_from_y*R_bell_crank_x_x;
  const double s2_128 = mbgen::fnma((-p_tie_rod_left_from_x), R_bell_crank_y_x, s2_127);
  const double s2_129 = mbgen::fms(p_tie_rod_left_to_z, R_carrier_left_y_z, s2_4);
  const double s2_130 = mbgen::fnma((-p_tie_rod_left_to_x), R_carrier_left_y_x, s2_129);
  const double s2_131 = s2_128 - r_carrier_left_aux1_y - s2_130;
  const double s2_132 = 1.262590031797617*s2_131;
  const double s2_133 = mbgen::fma(s2_125, s2_130, s2_117*s2_132);
  const double s2_134 = mbgen::fma(s2_121, s2_130, s2_119*s2_132);
  const double s2_135 = R_carrier_left_aux1_y_x*s2_126;
  const double s2_136 = mbgen::fma(R_carrier_left_aux1_z_x, s2_133, s2_135);
  const double s2_137 = mbgen::fnma(R_carrier_left_aux1_x_x, s2_134, s2_136);
  const double s2_138 = mbgen::fnma(s2_125, s2_128, s2_123*s2_132);
  const double s2_139 = mbgen::fma(s1_5, s2_132, mbgen::fma(s1_3, s2_121, s2_134));
  const double s2_140 = mbgen::fma(s2_120, s2_121, mbgen::fms(s2_131, s2_132, l_tie_rod_left));
  const double s2_141 = 0.5*mbgen::fma(s2_124, s2_125, s2_140);
  result.residual[9] = s2_141;
  const double s2_142 = mbgen::fnma(R_lower_arm_left_z_y, s2_126, R_lower_arm_left_y_y*s2_133);
  const double s2_143 = mbgen::fma(s1_7, s2_134, R_carrier_left_aux2_y_y*s2_126);
  const double s2_144 = mbgen::fma(R_carrier_left_aux2_z_y, s2_133, s2_143);
  // tie_rod_right
  const double s2_145 = mbgen::fma(p_tie_rod_right_to_z, R_carrier_right_z_z, s2_26);
  const double s2_146 = mbgen::fnma((-p_tie_rod_right_to_x), R_carrier_right_z_x, s2_145);
  const double s2_147 = mbgen::fnma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s2_122);
  const double s2_148 = mbgen::fms(p_tie_rod_right_to_z, R_carrier_right_x_z, s2_23);
  const double s2_149 = mbgen::fnma((-p_tie_rod_right_to_x), R_carrier_right_x_x, s2_148);
  const double s2_150 = s2_147 - s2_149 - 0.35;
  const double s2_151 = 1.262590031797617*s2_150;
  const double s2_152 = (-p_bell_crank_z) + (s2_146 - s1_21);
  const double s2_153 = 1.262590031797617*s2_152;
  const double s2_154 = mbgen::fma(s2_149, s2_153, s2_146*s2_151);
  const double s2_155 = mbgen::fma(p_tie_rod_right_to_z, R_carrier_right_y_z, s2_28);
  const double s2_156 = mbgen::fnma((-p_tie_rod_right_to_x), R_carrier_right_y_x, s2_155);
  const double s2_157 = mbgen::fma((-p_tie_rod_left_from_x), R_bell_crank_y_x, s2_127);
  const double s2_158 = s2_157 + (r_carrier_right_aux1_y + s2_156);
  const double s2_159 = 1.262590031797617*s2_158;
  const double s2_160 = mbgen::fma(s2_149, s2_159, s2_151*s2_156);
  const double pivot_carrier_right_rz = mbgen::fma(R_lower_arm_right_y_y, s2_160,
      R_lower_arm_right_z_y*s2_154);
  const double s2_161 = mbgen::fnma(s2_147, s2_159, s2_151*s2_157);
  const double s2_162 = mbgen::fnma(s2_153, s2_156, s2_146*s2_159);
  const double s2_163 = mbgen::fnma(s1_20, s2_159, mbgen::fnma(s1_18, s2_153, s2_162));
  const double s2_164 = mbgen::fma(s2_152, s2_153, mbgen::fms(s2_158, s2_159, l_tie_rod_right));
  const double s2_165 = 0.5*mbgen::fma(s2_150, s2_151, s2_164);
  result.residual[10] = s2_165;
  const double s2_166 = R_carrier_right_aux1_y_x*s2_154;
  const double s2_167 = mbgen::fma(R_carrier_right_aux1_x_x, s2_162, s2_166);
  const double s2_168 = mbgen::fnma(R_carrier_right_aux1_z_x, s2_160, s2_167);
  const double s2_169 = mbgen::fnma(s1_23, s2_162, R_carrier_right_aux2_y_y*s2_154);
  const double s2_170 = mbgen::fnma(R_carrier_right_aux2_z_y, s2_160, s2_169);
  const double s2_171 = 1.0/pivot_carrier_right_rz;
  const double s2_172 = s2_38*s2_171;
  const double s2_173 = R_carrier_right_aux2_y_y*s2_27;
  const double s2_174 = mbgen::fnma(R_carrier_right_aux2_z_y, s2_29, s2_173);
  const double pivot_carrier_right_ry = mbgen::fnma(s2_170, s2_172, s2_174);
  const double s2_175 = 1.0/s2_22;
  const double s2_176 = s2_31*s2_175;
  const double s2_177 = s2_171*mbgen::fnma(s2_25, s2_176, R_lower_arm_right_y_y*s2_24);
  const double s2_178 = R_carrier_right_aux1_y_x*s2_27;
  const double s2_179 = mbgen::fnma(R_carrier_right_aux1_z_x, s2_29, s2_178);
  const double s2_180 = mbgen::fnma(s2_168, s2_172, s2_179);
  const double s2_181 = 1.0/pivot_carrier_right_ry;
  const double s2_182 = mbgen::fma(R_carrier_right_aux2_z_y, s2_24, s1_23*s2_27);
  const double s2_183 = s2_181*mbgen::fma(s2_170, s2_177, mbgen::fma(s2_39, s2_176, s2_182));
  const double s2_184 = R_carrier_right_aux1_z_x*s2_24;
  const double s2_185 = mbgen::fnma(R_carrier_right_aux1_x_x, s2_27, s2_184);
  const double s2_186 = mbgen::fma(s2_168, s2_177, mbgen::fnma(s2_37, s2_176, s2_185));
  const double pivot_carrier_right_rx = mbgen::fnma(s2_180, s2_183, s2_186);
  const double s2_187 = 1.0/s2_2;
  const double s2_188 = s2_6*s2_187;
  const double s2_189 = 1.0/s2_137;
  const double s2_190 = R_carrier_left_aux1_z_x*s2_8;
  const double s2_191 = mbgen::fnma(R_carrier_left_aux1_x_x, s2_10, s2_190);
  const double s2_192 = s2_189*mbgen::fma(s2_16, s2_188, s2_191);
  const double s2_193 = mbgen::fma(R_carrier_left_aux2_z_y, s2_8, s1_7*s2_10);
  const double pivot_carrier_left_ry = mbgen::fnma(s2_144, s2_192, mbgen::fnma(s2_20, s2_188,
      s2_193));
  const double s2_194 = s2_18*s2_189;
  const double s2_195 = mbgen::fma(s2_9, s2_188, R_lower_arm_left_y_y*s2_8);
  const double s2_196 = mbgen::fnma(s2_142, s2_192, s2_195);
  const double s2_197 = R_carrier_left_aux2_y_y*s2_10;
  const double s2_198 = mbgen::fnma(R_carrier_left_aux2_z_y, s2_11, s2_197);
  const double s2_199 = 1.0/pivot_carrier_left_ry;
  const double s2_200 = mbgen::fnma(s2_144, s2_194, s2_198)*s2_199;
  const double s2_201 = mbgen::fma(R_lower_arm_left_y_y, s2_11, R_lower_arm_left_z_y*s2_10);
  const double s2_202 = mbgen::fma(s2_196, s2_200, mbgen::fma(s2_142, s2_194, s2_201));
  const double s2_203 = 1.0/pivot_arb_front_left;
  const double s2_204 = 1.0/pivot_arb_front_right;
  const double s2_205 = 1.0/pivot_pitman_arm;
  const double s2_206 = 1.0/pivot_carrier_right_rx;
  const double s2_207 = 1.0/s2_202;
  const double s2_208 = 4.291271972095581*std::abs(pivot_arb_front_right);
  const double s2_209 = mbgen::min(s2_208, 4.625980413576839*std::abs(pivot_pitman_arm));
  const double s2_210 = mbgen::min(4.336650753223258*std::abs(pivot_arb_front_left), s2_209);
  const double s2_211 = mbgen::min(3.3503257942070226*std::abs(s2_22), s2_210);
  const double s2_212 = mbgen::min(5.556930741705859*std::abs(pivot_carrier_right_rz), s2_211);
  const double s2_213 = mbgen::min(2.6620449619787987*std::abs(pivot_carrier_right_ry), s2_212);
  const double s2_214 = mbgen::min(s2_213, 2.732781487945307*std::abs(pivot_carrier_right_rx));
  const double s2_215 = mbgen::min(3.3514772255331233*std::abs(s2_2), s2_214);
  const double s2_216 = mbgen::min(15.714736645766752*std::abs(s2_137), s2_215);
  const double s2_217 = mbgen::min(5.864463449986124*std::abs(pivot_carrier_left_ry), s2_216);
  result.pivot[0] = mbgen::min(0.43888841273380513*std::abs(s2_202), s2_217);
  // long_rod_left
  const double s2_218 = p_long_rod_left_to_x*s1_34;
  const double s2_219 = mbgen::fma((-p_long_rod_left_to_z), R_rear_axle_z_z, s2_218);
  const double s2_220 = mbgen::fms(p_long_rod_left_to_y, R_rear_axle_z_y, s2_219);
  const double s2_221 = (-p_long_rod_left_from_z) + (r_rear_axle_aux3_z + s2_220);
  const double s2_222 = p_long_rod_left_to_x*R_rear_axle_aux5_x_x;
  const double s2_223 = mbgen::fnma((-p_long_rod_left_to_z), R_rear_axle_x_z, s2_222);
  const double s2_224 = mbgen::fma(p_long_rod_left_to_y, R_rear_axle_x_y, s2_223);
  const double s2_225 = (-p_long_rod_left_from_x) + (r_rear_axle_aux1_x + s2_224);
  const double s2_226 = 1.1757385222540735*s2_221;
  const double s2_227 = 1.1757385222540735*s2_225;
  const double s2_228 = p_long_rod_left_to_x*R_rear_axle_aux5_y_x;
  const double s2_229 = mbgen::fnma((-p_long_rod_left_to_z), R_rear_axle_y_z, s2_228);
  const double s2_230 = mbgen::fma(p_long_rod_left_to_y, R_rear_axle_y_y, s2_229);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_231 = p_long_rod_left_from_y - z_rear_axle_ty - s2_230;
  const double s2_232 = 1.1757385222540735*s2_231;
  const double s2_233 = mbgen::fma(s2_220, s2_232, s2_226*s2_230);
  const double s2_234 = mbgen::fma(s2_224, s2_232, s2_227*s2_230);
  const double s2_235 = mbgen::fnma(s2_220, s2_227, s2_224*s2_226);
  const double s2_236 = mbgen::fma(s2_221, s2_226, mbgen::fms(s2_231, s2_232, l_long_rod_left));
  const double s2_237 = 0.5*mbgen::fma(s2_225, s2_227, s2_236);
  result.residual[11] = s2_237;
  const double s2_238 = mbgen::fnma(s1_34, s2_234, R_rear_axle_aux5_y_x*s2_235);
  const double s2_239 = mbgen::fnma(R_rear_axle_aux5_x_x, s2_233, s2_238);
  // diag_rod_left
  const double s2_240 = p_diag_rod_left_to_y*R_rear_axle_z_y;
  const double s2_241 = mbgen::fma(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_240);
  const double s2_242 = (-p_diag_rod_left_from_z) + (r_rear_axle_aux3_z + s2_241);
  const double s2_243 = p_diag_rod_left_to_z*R_rear_axle_x_z;
  const double s2_244 = mbgen::fma(p_diag_rod_left_to_y, R_rear_axle_x_y, s2_243);
  const double s2_245 = (-p_diag_rod_left_from_x) + (r_rear_axle_aux1_x + s2_244);
  const double s2_246 = 1.162476387438193*s2_242;
  const double s2_247 = 1.162476387438193*s2_245;
  const double s2_248 = p_diag_rod_left_to_y*R_rear_axle_y_y;
  const double s2_249 = mbgen::fma(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_248);
  const double s2_250 = p_diag_rod_left_from_y - z_rear_axle_ty - s2_249;
  const double s2_251 = 1.162476387438193*s2_250;
  const double s2_252 = mbgen::fma(s2_241, s2_251, s2_246*s2_249);
  const double s2_253 = mbgen::fma(s2_244, s2_251, s2_247*s2_249);
  const double s2_254 = mbgen::fnma(s2_241, s2_247, s2_244*s2_246);
  const double s2_255 = mbgen::fma(s2_242, s2_246, mbgen::fms(s2_250, s2_251, l_diag_rod_left));
  const double s2_256 = 0.5*mbgen::fma(s2_245, s2_247, s2_255);
  result.residual[12] = s2_256;
  const double s2_257 = mbgen::fnma(s1_34, s2_253, R_rear_axle_aux5_y_x*s2_254);
  const double s2_258 = mbgen::fnma(R_rear_axle_aux5_x_x, s2_252, s2_257);
  // arb_link_rear_left
  const double s2_259 = p_arb_link_rear_left_from_x*cosines[17];
  const double s2_260 = p_arb_link_rear_left_from_x*sines[17];
  const double s2_261 = (-p_arb_link_rear_left_to_x)*s1_34;
  const double s2_262 = mbgen::fnma((-p_arb_link_rear_left_to_z), R_rear_axle_z_z, s2_261);
  const double s2_263 = mbgen::fma(p_arb_link_rear_left_to_y, R_rear_axle_z_y, s2_262);
  const double s2_264 = (-p_arb_rear_left_z) + (s2_260 + (r_rear_axle_aux3_z + s2_263));
  const double s2_265 = 4.47213595499958*s2_264;
  const double s2_266 = (-p_arb_link_rear_left_to_x)*R_rear_axle_aux5_x_x;
  const double s2_267 = mbgen::fma((-p_arb_link_rear_left_to_z), R_rear_axle_x_z, s2_266);
  const double s2_268 = mbgen::fms(p_arb_link_rear_left_to_y, R_rear_axle_x_y, s2_267);
  const double s2_269 = s2_259 - r_rear_axle_aux1_x - s2_268 - (-p_arb_rear_left_x);
  const double s2_270 = 4.47213595499958*s2_269;
  const double pivot_arb_rear_left = mbgen::fnma(s2_260, s2_270, s2_259*s2_265);
  const double s2_271 = (-p_arb_link_rear_left_to_x)*R_rear_axle_aux5_y_x;
  const double s2_272 = mbgen::fma((-p_arb_link_rear_left_to_z), R_rear_axle_y_z, s2_271);
  const double s2_273 = mbgen::fms(p_arb_link_rear_left_to_y, R_rear_axle_y_y, s2_272);
  const double s2_274 = 0.6 - z_rear_axle_ty - s2_273;
  const double s2_275 = 4.47213595499958*s2_274;
  const double s2_276 = mbgen::fma(s2_263, s2_275, s2_265*s2_273);
  const double s2_277 = mbgen::fnma(s2_270, s2_273, s2_268*s2_275);
  const double s2_278 = mbgen::fma(s2_263, s2_270, s2_265*s2_268);
  const double s2_279 = mbgen::fms(s2_274, s2_275, l_arb_link_rear_left);
  const double s2_280 = 0.5*mbgen::fma(s2_269, s2_270, mbgen::fma(s2_264, s2_265, s2_279));
  result.residual[13] = s2_280;
  const double s2_281 = mbgen::fma(R_rear_axle_aux4_x_x, s2_278, R_rear_axle_aux4_y_x*s2_276);
  const double s2_282 = mbgen::fnma(s1_34, s2_277, R_rear_axle_aux5_y_x*s2_278);
  const double s2_283 = mbgen::fnma(R_rear_axle_aux5_x_x, s2_276, s2_282);
  // long_rod_right
  const double s2_284 = mbgen::fma(p_long_rod_left_to_y, R_rear_axle_z_y, s2_219);
  const double s2_285 = mbgen::fnma(p_long_rod_left_to_y, R_rear_axle_y_y, s2_229);
  const double s2_286 = (-p_long_rod_right_from_y) + (z_rear_axle_ty + s2_285);
  const double s2_287 = (-p_long_rod_right_from_z) + (r_rear_axle_aux3_z - s2_284);
  const double s2_288 = mbgen::fnma(p_long_rod_left_to_y, R_rear_axle_x_y, s2_223);
  const double s2_289 = (-p_long_rod_right_from_x) + (r_rear_axle_aux1_x + s2_288);
  const double s2_290 = 1.1757385222540735*s2_286;
  const double s2_291 = 1.1757385222540735*s2_287;
  const double s2_292 = 1.1757385222540735*s2_289;
  const double s2_293 = mbgen::fma(s2_284, s2_290, s2_285*s2_291);
  const double s2_294 = mbgen::fnma(s2_288, s2_290, s2_285*s2_292);
  const double s2_295 = mbgen::fma(s2_284, s2_292, s2_288*s2_291);
  const double s2_296 = mbgen::fma(s2_287, s2_291, mbgen::fms(s2_286, s2_290, l_long_rod_right));
  const double s2_297 = 0.5*mbgen::fma(s2_289, s2_292, s2_296);
  result.residual[14] = s2_297;
  const double s2_298 = mbgen::fnma(s1_34, s2_294, R_rear_axle_aux5_y_x*s2_295);
  const double s2_299 = mbgen::fnma(R_rear_axle_aux5_x_x, s2_293, s2_298);
  // diag_rod_right
  const double s2_300 = mbgen::fnma(p_diag_rod_left_to_y, R_rear_axle_x_y, s2_243);
  const double s2_301 = (-p_diag_rod_right_from_x) + (r_rear_axle_aux1_x + s2_300);
  const double pivot_rear_axle_tx = 1.162476387438193*s2_301;
  const double s2_302 = mbgen::fms(p_diag_rod_left_to_z, R_rear_axle_z_z, s2_240);
  const double s2_303 = (-p_diag_rod_right_from_z) + (r_rear_axle_aux3_z + s2_302);
  const double s2_304 = mbgen::fms(p_diag_rod_left_to_z, R_rear_axle_y_z, s2_248);
  const double s2_305 = (-p_diag_rod_right_from_y) + (z_rear_axle_ty + s2_304);
  const double s2_306 = 1.162476387438193*s2_303;
  const double s2_307 = 1.162476387438193*s2_305;
  const double s2_308 = mbgen::fnma(s2_300, s2_307, pivot_rear_axle_tx*s2_304);
  const double s2_309 = mbgen::fnma(pivot_rear_axle_tx, s2_302, s2_300*s2_306);
  const double s2_310 = mbgen::fnma(s2_304, s2_306, s2_302*s2_307);
  const double s2_311 = mbgen::fma(s2_303, s2_306, mbgen::fms(s2_305, s2_307, l_diag_rod_right));
  const double s2_312 = 0.5*mbgen::fma(s2_301, pivot_rear_axle_tx, s2_311);
  result.residual[15] = s2_312;
  const double s2_313 = mbgen::fnma(R_rear_axle_aux4_y_x, s2_310, R_rear_axle_aux4_x_x*s2_309);
  const double s2_314 = mbgen::fma(R_rear_axle_aux5_x_x, s2_310, R_rear_axle_aux5_y_x*s2_309);
  const double s2_315 = mbgen::fnma(s1_34, s2_308, s2_314);
  // arb_link_rear_right
  const double s2_316 = p_arb_link_rear_right_from_x*cosines[18];
  const double s2_317 = mbgen::fnma(p_arb_link_rear_left_to_y, R_rear_axle_z_y, s2_262);
  const double s2_318 = p_arb_link_rear_right_from_x*sines[18];
  const double s2_319 = (-p_arb_rear_right_z) + (s2_317 + (r_rear_axle_aux3_z + s2_318));
  const double s2_320 = 4.47213595499958*s2_319;
  const double s2_321 = mbgen::fma(p_arb_link_rear_left_to_y, R_rear_axle_x_y, s2_267);
  const double s2_322 = s2_316 + s2_321 - r_rear_axle_aux1_x - (-p_arb_rear_right_x);
  const double s2_323 = 4.47213595499958*s2_322;
  const double pivot_arb_rear_right = mbgen::fnma(s2_318, s2_323, s2_316*s2_320);
  const double s2_324 = mbgen::fma(p_arb_link_rear_left_to_y, R_rear_axle_y_y, s2_272);
  const double s2_325 = 0.6 + (z_rear_axle_ty - s2_324);
  const double s2_326 = 4.47213595499958*s2_325;
  const double s2_327 = mbgen::fma(s2_321, s2_326, s2_323*s2_324);
  const double s2_328 = mbgen::fnma(s2_320, s2_321, s2_317*s2_323);
  const double s2_329 = mbgen::fma(s2_320, s2_324, s2_317*s2_326);
  const double s2_330 = mbgen::fms(s2_325, s2_326, l_arb_link_rear_right);
  const double s2_331 = 0.5*mbgen::fma(s2_322, s2_323, mbgen::fma(s2_319, s2_320, s2_330));
  result.residual[16] = s2_331;
  const double s2_332 = mbgen::fnma(R_rear_axle_aux4_y_x, s2_329, R_rear_axle_aux4_x_x*s2_328);
  const double s2_333 = mbgen::fma(R_rear_axle_aux5_x_x, s2_329, R_rear_axle_aux5_y_x*s2_328);
  const double s2_334 = mbgen::fnma(s1_34, s2_327, s2_333);
  const double s2_335 = 1.0/pivot_rear_axle_tx;
  const double s2_336 = s2_227*s2_335;
  const double pivot_rear_axle_rz = mbgen::fms(s2_308, s2_336, s2_234);
  const double s2_337 = s2_292*s2_335;
  const double s2_338 = mbgen::fnma(R_rear_axle_aux4_y_x, s2_233, s2_313*s2_336);
  const double s2_339 = mbgen::fnma(R_rear_axle_aux4_x_x, s2_235, s2_338);
  const double s2_340 = 1.0/pivot_rear_axle_rz;
  const double s2_341 = mbgen::fms(s2_308, s2_337, s2_294)*s2_340;
  const double s2_342 = mbgen::fnma(R_rear_axle_aux4_y_x, s2_293, s2_313*s2_337);
  const double s2_343 = mbgen::fnma(R_rear_axle_aux4_x_x, s2_295, s2_342);
  const double pivot_rear_axle_ry = mbgen::fnma(s2_339, s2_341, s2_343);
  const double s2_344 = mbgen::fma(s2_307, s2_336, s2_232);
  const double s2_345 = s2_247*s2_335;
  const double s2_346 = s2_340*mbgen::fms(s2_308, s2_345, s2_253);
  const double s2_347 = mbgen::fma(s2_341, s2_344, mbgen::fnma(s2_307, s2_337, s2_290));
  const double s2_348 = mbgen::fnma(R_rear_axle_aux4_y_x, s2_252, s2_313*s2_345);
  const double s2_349 = mbgen::fnma(R_rear_axle_aux4_x_x, s2_254, s2_348);
  const double s2_350 = 1.0/pivot_rear_axle_ry;
  const double s2_351 = mbgen::fnma(s2_339, s2_346, s2_349)*s2_350;
  const double s2_352 = mbgen::fnma(s2_307, s2_345, mbgen::fms(s2_344, s2_346, s2_251));
  const double pivot_rear_axle_ty = mbgen::fnma(s2_347, s2_351, s2_352);
  const double s2_353 = 1.0/pivot_arb_rear_left;
  const double s2_354 = 1.0/pivot_arb_rear_right;
  const double s2_355 = 1.0/pivot_rear_axle_ty;
  const double s2_356 = 3.204642123170383*std::abs(pivot_arb_rear_right);
  const double s2_357 = mbgen::min(3.194382824999693*std::abs(pivot_arb_rear_left), s2_356);
  const double s2_358 = mbgen::min(1.0748203921841*std::abs(pivot_rear_axle_tx), s2_357);
  const double s2_359 = mbgen::min(s2_358, 1.5318884572025857*std::abs(pivot_rear_axle_rz));
  const double s2_360 = mbgen::min(s2_359, 1.7893247478820993*std::abs(pivot_rear_axle_ry));
  result.pivot[1] = mbgen::min(s2_360, 1.4337752588788297*std::abs(pivot_rear_axle_ty));
  // operations: 313 add, 415 multiply, 17 divide, 32 other

  // --- step 4: velocities ---
  // loop block 0
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s4_1 = zd_lower_arm_left*s2_19;
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s4_2 = zd_lower_arm_right*s2_34;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  result.dz[Coordinate::pitman_arm] = -(s2_115*s2_205);
  const double s4_3 = mbgen::fma(s2_165, s2_172, s2_24);
  result.zd[Coordinate::pitman_arm] = -(s2_205*(zd_bell_crank*s2_113));
  const double s4_4 = mbgen::fma(s2_141, s2_192, mbgen::fma(s2_14, s2_188, s2_13));
  const double s4_5 = mbgen::fnma(zd_lower_arm_left, s2_139, zd_bell_crank*s2_138);
  const double s4_6 = mbgen::fnma(zd_bell_crank, s2_161, zd_lower_arm_right*s2_163);
  const double s4_7 = s2_172*s4_6;
  const double s4_8 = mbgen::fma(s2_165, s2_177, mbgen::fms(s2_183, s4_3, s2_35));
  const double s4_9 = s2_206*mbgen::fma(s2_33, s2_176, s4_8);
  result.dz[Coordinate::carrier_right_rx] = s4_9;
  const double s4_10 = s2_207*mbgen::fnma(s2_141, s2_194, mbgen::fms(s2_200, s4_4, s2_8));
  result.dz[Coordinate::carrier_left_rz] = -s4_10;
  const double s4_11 = mbgen::fnma(zd_lower_arm_right, s2_32, s2_176*s4_2);
  const double s4_12 = s2_206*mbgen::fnma(s2_183, s4_7, mbgen::fnma(s2_177, s4_6, s4_11));
  result.zd[Coordinate::carrier_right_rx] = s4_12;
  const double s4_13 = mbgen::fma(zd_lower_arm_left, s2_12, s2_192*s4_5);
  const double s4_14 = mbgen::fnma(s2_188, s4_1, s4_13);
  const double s4_15 = s2_207*mbgen::fnma(s2_200, s4_14, s2_194*s4_5);
  result.zd[Coordinate::carrier_left_rz] = -s4_15;
  const double s4_16 = s2_181*mbgen::fma(s2_180, s4_9, s4_3);
  result.dz[Coordinate::carrier_right_ry] = -s4_16;
  const double s4_17 = s2_199*mbgen::fms(s2_196, s4_10, s4_4);
  result.dz[Coordinate::carrier_left_ry] = s4_17;
  const double s4_18 = s2_181*mbgen::fnma(s2_180, s4_12, s4_7);
  result.zd[Coordinate::carrier_right_ry] = s4_18;
  const double s4_19 = s2_199*mbgen::fma(s2_196, s4_15, s4_14);
  result.zd[Coordinate::carrier_left_ry] = s4_19;
  const double s4_20 = s2_189*mbgen::fnma(s2_142, s4_10, mbgen::fms(s2_144, s4_17, s2_141));
  result.dz[Coordinate::carrier_left_rx] = -s4_20;
  const double s4_21 = s2_171*mbgen::fnma(s2_170, s4_16, mbgen::fms(s2_168, s4_9, s2_165));
  result.dz[Coordinate::carrier_right_rz] = s4_21;
  const double s4_22 = s2_189*mbgen::fnma(s2_142, s4_15, mbgen::fma(s2_144, s4_19, s4_5));
  result.zd[Coordinate::carrier_left_rx] = -s4_22;
  const double s4_23 = s2_171*mbgen::fma(s2_170, s4_18, mbgen::fma(s2_168, s4_12, s4_6));
  result.zd[Coordinate::carrier_right_rz] = s4_23;
  const double s4_24 = mbgen::fma(s2_39, s4_16, mbgen::fma(s2_25, s4_21, s2_33));
  result.dz[Coordinate::upper_arm_right] = s2_175*mbgen::fma(s2_37, s4_9, s4_24);
  const double s4_25 = mbgen::fnma(s2_97, s4_21, mbgen::fms(s2_100, s4_9, s2_96));
  result.dz[Coordinate::arb_front_right] = s2_204*mbgen::fnma(s2_102, s4_16, s4_25);
  const double s4_26 = mbgen::fnma(s2_68, s4_20, mbgen::fms(s2_71, s4_17, s2_64));
  result.dz[Coordinate::arb_front_left] = s2_203*mbgen::fnma(s2_65, s4_10, s4_26);
  const double s4_27 = mbgen::fma(s2_102, s4_18, s2_100*s4_12);
  const double s4_28 = mbgen::fnma(s2_97, s4_23, mbgen::fma(zd_lower_arm_right, s2_93, s4_27));
  result.zd[Coordinate::arb_front_right] = s2_204*s4_28;
  const double s4_29 = mbgen::fma(zd_lower_arm_left, s2_60, s2_71*s4_19);
  result.zd[Coordinate::arb_front_left] = s2_203*mbgen::fnma(s2_65, s4_15, mbgen::fnma(s2_68, s4_22,
      s4_29));
  const double s4_30 = mbgen::fma(s2_20, s4_17, mbgen::fms(s2_9, s4_10, s2_14));
  result.dz[Coordinate::upper_arm_left] = -(s2_187*mbgen::fma(s2_16, s4_20, s4_30));
  const double s4_31 = mbgen::fnma(s2_25, s4_23, mbgen::fms(s2_39, s4_18, s4_2));
  result.zd[Coordinate::upper_arm_right] = -(s2_175*mbgen::fnma(s2_37, s4_12, s4_31));
  const double s4_32 = mbgen::fma(s2_20, s4_19, mbgen::fms(s2_9, s4_15, s4_1));
  result.zd[Coordinate::upper_arm_left] = -(s2_187*mbgen::fma(s2_16, s4_22, s4_32));
  // loop block 1
  const double s4_33 = mbgen::fms(s2_312, s2_336, s2_237);
  const double s4_34 = mbgen::fnma(s2_341, s4_33, mbgen::fms(s2_312, s2_337, s2_297));
  const double s4_35 = mbgen::fnma(s2_346, s4_33, mbgen::fms(s2_312, s2_345, s2_256));
  const double s4_36 = s2_355*mbgen::fnma(s2_351, s4_34, s4_35);
  result.dz[Coordinate::rear_axle_ty] = s4_36;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s4_37 = mbgen::fnma(zd_rear_axle_tz, s2_306, zd_rear_axle_rx*s2_315);
  const double s4_38 = mbgen::fnma(zd_rear_axle_tz, s2_226, zd_rear_axle_rx*s2_239);
  const double s4_39 = mbgen::fnma(s2_336, s4_37, s4_38);
  const double s4_40 = mbgen::fnma(zd_rear_axle_tz, s2_291, zd_rear_axle_rx*s2_299);
  const double s4_41 = mbgen::fnma(s2_341, s4_39, mbgen::fnma(s2_337, s4_37, s4_40));
  const double s4_42 = mbgen::fnma(zd_rear_axle_tz, s2_246, zd_rear_axle_rx*s2_258);
  const double s4_43 = mbgen::fnma(s2_346, s4_39, mbgen::fnma(s2_345, s4_37, s4_42));
  const double s4_44 = s2_355*mbgen::fnma(s2_351, s4_41, s4_43);
  result.zd[Coordinate::rear_axle_ty] = s4_44;
  const double s4_45 = s2_350*mbgen::fnma(s2_347, s4_36, s4_34);
  result.dz[Coordinate::rear_axle_ry] = s4_45;
  const double s4_46 = s2_350*mbgen::fnma(s2_347, s4_44, s4_41);
  result.zd[Coordinate::rear_axle_ry] = s4_46;
  const double s4_47 = s2_340*mbgen::fnma(s2_339, s4_45, mbgen::fma(s2_344, s4_36, s4_33));
  result.dz[Coordinate::rear_axle_rz] = s4_47;
  const double s4_48 = s2_340*mbgen::fnma(s2_339, s4_46, mbgen::fma(s2_344, s4_44, s4_39));
  result.zd[Coordinate::rear_axle_rz] = s4_48;
  const double s4_49 = mbgen::fma(s2_308, s4_47, mbgen::fms(s2_313, s4_45, s2_312));
  const double s4_50 = s2_335*mbgen::fnma(s2_307, s4_36, s4_49);
  result.dz[Coordinate::rear_axle_tx] = s4_50;
  const double s4_51 = mbgen::fma(s2_308, s4_48, mbgen::fma(s2_313, s4_46, s4_37));
  const double s4_52 = s2_335*mbgen::fnma(s2_307, s4_44, s4_51);
  result.zd[Coordinate::rear_axle_tx] = s4_52;
  const double s4_53 = mbgen::fma(s2_281, s4_45, mbgen::fms(s2_275, s4_36, s2_280));
  result.dz[Coordinate::arb_rear_left] = s2_353*mbgen::fma(s2_270, s4_50, mbgen::fma(s2_277, s4_47,
      s4_53));
  const double s4_54 = mbgen::fma(s2_327, s4_47, mbgen::fms(s2_332, s4_45, s2_331));
  result.dz[Coordinate::arb_rear_right] = s2_354*mbgen::fnma(s2_326, s4_36, mbgen::fma(s2_323,
      s4_50, s4_54));
  const double s4_55 = mbgen::fma(s2_277, s4_48, mbgen::fma(s2_281, s4_46, s2_275*s4_44));
  const double s4_56 = mbgen::fma(zd_rear_axle_rx, s2_283, mbgen::fma(s2_270, s4_52, s4_55));
  result.zd[Coordinate::arb_rear_left] = s2_353*mbgen::fnma(zd_rear_axle_tz, s2_265, s4_56);
  const double s4_57 = mbgen::fma(s2_323, s4_52, mbgen::fma(s2_327, s4_48, s2_332*s4_46));
  const double s4_58 = mbgen::fma(zd_rear_axle_rx, s2_334, s4_57);
  const double s4_59 = mbgen::fnma(s2_326, s4_44, mbgen::fnma(zd_rear_axle_tz, s2_320, s4_58));
  result.zd[Coordinate::arb_rear_right] = s2_354*s4_59;
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
      sines[22], cosines[22], R_carrier_left_aux1_y_x, R_carrier_left_aux1_y_y,
      R_carrier_left_aux1_z_x, R_carrier_left_aux1_z_y, s1_8, r_carrier_left_aux1_y, s1_10,
      r_carrier_left_aux1_z, s1_12, R_carrier_left_aux2_y_y, R_carrier_left_aux2_z_y,
      R_carrier_left_x_x, R_carrier_left_x_z, R_carrier_left_y_x, R_carrier_left_y_z,
      R_carrier_left_z_x, R_carrier_left_z_z, s1_26, s1_28, s1_30, R_carrier_right_aux1_y_x,
      R_carrier_right_aux1_y_y, R_carrier_right_aux1_z_x, R_carrier_right_aux1_z_y, s1_33,
      r_carrier_right_aux1_y, s1_35, s1_36, s1_38, R_carrier_right_aux2_y_y,
      R_carrier_right_aux2_z_y, R_carrier_right_x_x, R_carrier_right_x_z, R_carrier_right_y_x,
      R_carrier_right_y_z, R_carrier_right_z_x, R_carrier_right_z_z, s1_52, s1_54, s1_56,
      r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux5_x_x, R_rear_axle_aux5_x_z,
      R_rear_axle_aux5_y_x, R_rear_axle_aux5_y_z, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y,
      R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z, s1_62, s1_63, s1_64, w_chassis_x,
      w_chassis_y, w_chassis_z, w_carrier_left_x, w_carrier_left_y, w_carrier_left_z,
      w_wheel_front_left_x, w_wheel_front_left_y, w_wheel_front_left_z, w_arb_front_left_y,
      w_carrier_right_x, w_carrier_right_y, w_carrier_right_z, w_wheel_front_right_x,
      w_wheel_front_right_y, w_wheel_front_right_z, w_arb_front_right_y, w_rear_axle_x,
      w_rear_axle_y, w_rear_axle_z, s4_33, w_wheel_rear_left_x, s4_34, w_wheel_rear_left_y, s4_35,
      w_wheel_rear_left_z, w_arb_rear_left_y, s4_36, w_wheel_rear_right_x, s4_37,
      w_wheel_rear_right_y, s4_38, w_wheel_rear_right_z, w_arb_rear_right_y, a_chassis_x,
      a_chassis_y, a_chassis_z, alpha_chassis_x, alpha_chassis_y, alpha_chassis_z, s7_12, s7_13,
      s7_14, s7_15, s7_16, s7_17, s7_18, s7_19, s7_20, s7_21, s7_22, s7_25, a_lower_arm_left_y,
      s7_30, a_lower_arm_left_z, alpha_lower_arm_left_x, s7_31, s7_32, s7_33, s7_34,
      a_carrier_left_aux1_x, a_carrier_left_aux1_y, a_carrier_left_aux1_z, alpha_carrier_left_x,
      alpha_carrier_left_y, alpha_carrier_left_z, s7_57, s7_58, s7_59, s7_60, s7_61, s7_62, s7_63,
      s7_64, s7_65, a_wheel_front_left_x, a_wheel_front_left_y, a_wheel_front_left_z,
      alpha_wheel_front_left_x, alpha_wheel_front_left_y, alpha_wheel_front_left_z,
      a_upper_arm_left_y, a_upper_arm_left_z, alpha_upper_arm_left_x, s7_81, s7_82, s7_83, s7_84,
      s7_87, a_arb_front_left_x, a_arb_front_left_y, s7_92, a_arb_front_left_z,
      alpha_arb_front_left_x, alpha_arb_front_left_y, alpha_arb_front_left_z, s7_93, s7_94, s7_95,
      s7_96, s7_97, s7_98, s7_99, s7_100, a_lower_arm_right_y, a_lower_arm_right_z,
      alpha_lower_arm_right_x, s7_101, s7_102, s7_103, s7_104, a_carrier_right_aux1_x,
      a_carrier_right_aux1_y, a_carrier_right_aux1_z, alpha_carrier_right_x, alpha_carrier_right_y,
      alpha_carrier_right_z, s7_127, s7_128, s7_129, s7_130, s7_131, s7_132, s7_133, s7_134, s7_135,
      a_wheel_front_right_x, a_wheel_front_right_y, a_wheel_front_right_z,
      alpha_wheel_front_right_x, alpha_wheel_front_right_y, alpha_wheel_front_right_z,
      a_upper_arm_right_y, a_upper_arm_right_z, alpha_upper_arm_right_x, s7_148, s7_149, s7_150,
      s7_151, a_arb_front_right_x, a_arb_front_right_y, a_arb_front_right_z,
      alpha_arb_front_right_x, alpha_arb_front_right_y, alpha_arb_front_right_z, s7_152, s7_153,
      s7_154, s7_155, s7_156, s7_157, s7_158, s7_159, a_pitman_arm_x, a_pitman_arm_y,
      a_pitman_arm_z, alpha_pitman_arm_y, s7_165, s7_166, s7_167, s7_168, s7_169, s7_170,
      a_bell_crank_x, a_bell_crank_y, a_bell_crank_z, alpha_bell_crank_z, s7_174, s7_175, s7_176,
      s7_177, s7_178, s7_179, a_rear_axle_aux3_x, a_rear_axle_aux3_y, a_rear_axle_aux3_z,
      alpha_rear_axle_x, alpha_rear_axle_y, alpha_rear_axle_z, s7_256, s7_258, s7_261, s7_264,
      s7_267, s7_270, s7_273, s7_276, s7_284, s7_286, s7_289, s7_292, s7_295, s7_313, s7_314,
      s7_315, s7_325, s7_326, s7_329, s7_330, s7_331, s7_333, s7_335, s7_337, s7_339, s7_341,
      s7_343, s7_350, s7_351, s7_352, s7_354, s7_355, s7_357, s7_358, s7_360, s7_377, s7_380,
      s7_383, s7_397, s7_399, s7_401, s7_410, s7_415, s7_418, s7_419, s7_420, s7_436, s7_437,
      s7_438, s7_443, s7_444, s7_445, s7_452, s7_453, s7_454, s7_455, s7_456, s7_664, s7_668,
      s7_672, Q_rear_axle_tz, Q_rear_axle_ty, Q_rear_axle_tx, Q_pitman_arm, Q_arb_front_right,
      Q_upper_arm_right, s7_864, s7_867, s7_870, Q_arb_front_left, n_upper_arm_left_x;
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
  const double R_chassis_x_y = mbgen::fnma(R_chassis_aux4_y_x, s1_4, R_chassis_aux4_x_x*s1_3);
  const double s1_5 = s1_1*s1_4;
  const double R_chassis_x_z = mbgen::fma(R_chassis_aux4_x_x, s1_5, R_chassis_aux4_y_x*s1_2);
  const double R_chassis_y_y = mbgen::fma(R_chassis_aux4_y_x, s1_3, R_chassis_aux4_x_x*s1_4);
  const double R_chassis_y_z = mbgen::fnma(R_chassis_aux4_x_x, s1_2, R_chassis_aux4_y_x*s1_5);
  const double R_chassis_z_y = R_chassis_aux5_z_z*s1_2;
  const double R_chassis_z_z = R_chassis_aux5_z_z*s1_4;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s1_6 = work.sines[4];
  work.R_carrier_left_aux1_y_x = R_lower_arm_left_y_y*s1_6;
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  work.R_carrier_left_aux1_y_y = R_lower_arm_left_y_y*R_carrier_left_aux1_x_x;
  const double R_lower_arm_left_z_y = work.sines[3];
  work.R_carrier_left_aux1_z_x = R_lower_arm_left_z_y*s1_6;
  work.R_carrier_left_aux1_z_y = R_lower_arm_left_z_y*R_carrier_left_aux1_x_x;
  const double s1_7 = (-p_carrier_left_rz_z)*R_lower_arm_left_z_y;
  work.s1_8 = mbgen::fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_7);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_8;
  const double s1_9 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_10 = mbgen::fnma((-p_carrier_left_rz_z), R_lower_arm_left_y_y, s1_9);
  work.r_carrier_left_aux1_z = work.s1_10 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_11 = work.cosines[5];
  work.s1_12 = s1_6*s1_11;
  const double s1_13 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_6*s1_13;
  const double s1_14 = work.R_carrier_left_aux1_y_y*s1_11;
  work.R_carrier_left_aux2_y_y = mbgen::fnma(R_lower_arm_left_z_y, s1_13, s1_14);
  const double s1_15 = R_lower_arm_left_z_y*s1_11;
  const double s1_16 = mbgen::fma(work.R_carrier_left_aux1_y_y, s1_13, s1_15);
  const double s1_17 = R_lower_arm_left_y_y*s1_13;
  work.R_carrier_left_aux2_z_y = mbgen::fma(work.R_carrier_left_aux1_z_y, s1_11, s1_17);
  const double s1_18 = R_lower_arm_left_y_y*s1_11;
  const double R_carrier_left_aux2_z_z = mbgen::fnma(work.R_carrier_left_aux1_z_y, s1_13, s1_18);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_19 = work.cosines[6];
  const double s1_20 = work.sines[6];
  const double s1_21 = R_carrier_left_aux1_x_x*s1_19;
  work.R_carrier_left_x_x = mbgen::fnma(R_carrier_left_aux2_x_z, s1_20, s1_21);
  const double s1_22 = R_carrier_left_aux1_x_x*s1_20;
  work.R_carrier_left_x_z = mbgen::fma(R_carrier_left_aux2_x_z, s1_19, s1_22);
  work.R_carrier_left_y_x = mbgen::fma(s1_16, s1_20, work.R_carrier_left_aux1_y_x*s1_19);
  work.R_carrier_left_y_z = mbgen::fnma(s1_16, s1_19, work.R_carrier_left_aux1_y_x*s1_20);
  const double s1_23 = work.R_carrier_left_aux1_z_x*s1_19;
  work.R_carrier_left_z_x = mbgen::fnma(R_carrier_left_aux2_z_z, s1_20, s1_23);
  const double s1_24 = work.R_carrier_left_aux1_z_x*s1_20;
  work.R_carrier_left_z_z = mbgen::fma(R_carrier_left_aux2_z_z, s1_19, s1_24);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_25 = p_wheel_front_left_z*work.R_carrier_left_x_z;
  work.s1_26 = mbgen::fnma(p_wheel_front_left_y, work.s1_12, s1_25);
  const double s1_27 = p_wheel_front_left_y*work.R_carrier_left_aux2_y_y;
  work.s1_28 = mbgen::fma(p_wheel_front_left_z, work.R_carrier_left_y_z, s1_27);
  const double s1_29 = p_wheel_front_left_y*work.R_carrier_left_aux2_z_y;
  work.s1_30 = mbgen::fma(p_wheel_front_left_z, work.R_carrier_left_z_z, s1_29);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_31 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_31;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  work.R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[9];
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_31;
  work.R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_32 = (-p_carrier_right_rz_z)*R_lower_arm_right_z_y;
  work.s1_33 = mbgen::fnma((-p_carrier_right_rz_y), R_lower_arm_right_y_y, s1_32);
  work.r_carrier_right_aux1_y = work.s1_33 - (-p_lower_arm_right_y);
  const double s1_34 = (-p_carrier_right_rz_y)*R_lower_arm_right_z_y;
  work.s1_35 = mbgen::fma((-p_carrier_right_rz_z), R_lower_arm_right_y_y, s1_34);
  work.s1_36 = (-p_lower_arm_right_z) + work.s1_35;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_37 = work.cosines[11];
  work.s1_38 = s1_31*s1_37;
  const double s1_39 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_31*s1_39;
  const double s1_40 = work.R_carrier_right_aux1_y_y*s1_37;
  work.R_carrier_right_aux2_y_y = mbgen::fnma(R_lower_arm_right_z_y, s1_39, s1_40);
  const double s1_41 = R_lower_arm_right_z_y*s1_37;
  const double s1_42 = mbgen::fma(work.R_carrier_right_aux1_y_y, s1_39, s1_41);
  const double s1_43 = R_lower_arm_right_y_y*s1_39;
  work.R_carrier_right_aux2_z_y = mbgen::fma(work.R_carrier_right_aux1_z_y, s1_37, s1_43);
  const double s1_44 = R_lower_arm_right_y_y*s1_37;
  const double R_carrier_right_aux2_z_z = mbgen::fnma(work.R_carrier_right_aux1_z_y, s1_39, s1_44);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_45 = work.cosines[12];
  const double s1_46 = work.sines[12];
  const double s1_47 = R_carrier_right_aux1_x_x*s1_45;
  work.R_carrier_right_x_x = mbgen::fnma(R_carrier_right_aux2_x_z, s1_46, s1_47);
  const double s1_48 = R_carrier_right_aux1_x_x*s1_46;
  work.R_carrier_right_x_z = mbgen::fma(R_carrier_right_aux2_x_z, s1_45, s1_48);
  work.R_carrier_right_y_x = mbgen::fma(s1_42, s1_46, work.R_carrier_right_aux1_y_x*s1_45);
  work.R_carrier_right_y_z = mbgen::fnma(s1_42, s1_45, work.R_carrier_right_aux1_y_x*s1_46);
  const double s1_49 = work.R_carrier_right_aux1_z_x*s1_45;
  work.R_carrier_right_z_x = mbgen::fnma(R_carrier_right_aux2_z_z, s1_46, s1_49);
  const double s1_50 = work.R_carrier_right_aux1_z_x*s1_46;
  work.R_carrier_right_z_z = mbgen::fma(R_carrier_right_aux2_z_z, s1_45, s1_50);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_51 = (-p_wheel_front_right_y)*work.s1_38;
  work.s1_52 = mbgen::fma(p_wheel_front_right_z, work.R_carrier_right_x_z, s1_51);
  const double s1_53 = p_wheel_front_right_z*work.R_carrier_right_y_z;
  work.s1_54 = mbgen::fnma((-p_wheel_front_right_y), work.R_carrier_right_aux2_y_y, s1_53);
  const double s1_55 = p_wheel_front_right_z*work.R_carrier_right_z_z;
  work.s1_56 = mbgen::fnma((-p_wheel_front_right_y), work.R_carrier_right_aux2_z_y, s1_55);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double z_rear_axle_tz = state.z[Coordinate::rear_axle_tz];
  work.r_rear_axle_aux3_z = z_rear_axle_tz - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_57 = work.sines[18];
  work.R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_57;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  work.R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_57;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_58 = work.sines[19];
  const double s1_59 = work.cosines[19];
  const double s1_60 = work.R_rear_axle_aux5_x_z*s1_58;
  work.R_rear_axle_x_y = mbgen::fnma(R_rear_axle_aux4_y_x, s1_59, s1_60);
  work.R_rear_axle_x_z = mbgen::fma(work.R_rear_axle_aux5_x_z, s1_59, R_rear_axle_aux4_y_x*s1_58);
  work.R_rear_axle_y_y = mbgen::fma(work.R_rear_axle_aux5_y_z, s1_58, R_rear_axle_aux4_x_x*s1_59);
  const double s1_61 = work.R_rear_axle_aux5_y_z*s1_59;
  work.R_rear_axle_y_z = mbgen::fnma(R_rear_axle_aux4_x_x, s1_58, s1_61);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_58;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_59;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  work.s1_62 = p_wheel_rear_left_y*work.R_rear_axle_x_y;
  work.s1_63 = p_wheel_rear_left_y*work.R_rear_axle_y_y;
  work.s1_64 = p_wheel_rear_left_y*work.R_rear_axle_z_y;
  // operations: 44 add, 103 multiply, 44 sin cos

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
  const double s4_22 = zd_carrier_right_ry*work.s1_38;
  work.w_carrier_right_x = w_carrier_right_aux2_x - s4_22;
  const double s4_23 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.w_carrier_right_y = w_carrier_right_aux2_y + s4_23;
  const double s4_24 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  work.w_carrier_right_z = w_carrier_right_aux2_z + s4_24;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  const double s4_25 = zd_wheel_front_right*work.s1_38;
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
  const double s4_32 = zd_rear_axle_rx*s1_57;
  work.w_rear_axle_z = w_rear_axle_aux4_z - s4_32;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  work.s4_33 = zd_wheel_rear_left*work.R_rear_axle_x_y;
  work.w_wheel_rear_left_x = work.w_rear_axle_x + work.s4_33;
  work.s4_34 = zd_wheel_rear_left*work.R_rear_axle_y_y;
  work.w_wheel_rear_left_y = work.w_rear_axle_y + work.s4_34;
  work.s4_35 = zd_wheel_rear_left*work.R_rear_axle_z_y;
  work.w_wheel_rear_left_z = work.w_rear_axle_z + work.s4_35;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  work.s4_36 = zd_wheel_rear_right*work.R_rear_axle_x_y;
  work.w_wheel_rear_right_x = work.w_rear_axle_x + work.s4_36;
  work.s4_37 = zd_wheel_rear_right*work.R_rear_axle_y_y;
  work.w_wheel_rear_right_y = work.w_rear_axle_y + work.s4_37;
  work.s4_38 = zd_wheel_rear_right*work.R_rear_axle_z_y;
  work.w_wheel_rear_right_z = work.w_rear_axle_z + work.s4_38;
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + work.w_chassis_y;
  // operations: 47 add, 38 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_1 = (-g_z) + derivative.zdd[Coordinate::chassis_tz];
  const double zdd_chassis_ty = derivative.zdd[Coordinate::chassis_ty];
  const double zdd_chassis_tx = derivative.zdd[Coordinate::chassis_tx];
  const double s7_2 = zdd_chassis_ty*R_chassis_aux5_y_x;
  const double s7_3 = mbgen::fma(zdd_chassis_tx, R_chassis_aux5_x_x, s7_2);
  work.a_chassis_x = mbgen::fnma(s1_1, s7_1, s7_3);
  const double s7_4 = mbgen::fma(zdd_chassis_tx, R_chassis_x_y, zdd_chassis_ty*R_chassis_y_y);
  work.a_chassis_y = mbgen::fma(R_chassis_z_y, s7_1, s7_4);
  const double s7_5 = mbgen::fma(zdd_chassis_tx, R_chassis_x_z, zdd_chassis_ty*R_chassis_y_z);
  work.a_chassis_z = mbgen::fma(R_chassis_z_z, s7_1, s7_5);
  const double zdd_chassis_rz = derivative.zdd[Coordinate::chassis_rz];
  const double s7_6 = mbgen::fnma(zdd_chassis_rz, s1_1, derivative.zdd[Coordinate::chassis_rx]);
  work.alpha_chassis_x = mbgen::fnma(s4_3, s4_4, mbgen::fnma(s4_2, s4_5, s7_6));
  const double s7_7 = zd_chassis_rx*work.w_chassis_z;
  const double zdd_chassis_ry = derivative.zdd[Coordinate::chassis_ry];
  const double s7_8 = mbgen::fma(zdd_chassis_rz, R_chassis_z_y, s7_7);
  work.alpha_chassis_y = mbgen::fnma(s4_1, s4_5, mbgen::fma(zdd_chassis_ry, s1_4, s7_8));
  const double s7_9 = mbgen::fnma(zdd_chassis_ry, s1_2, zdd_chassis_rz*R_chassis_z_z);
  const double s7_10 = mbgen::fnma(s4_1, s4_3, s7_9);
  work.alpha_chassis_z = mbgen::fnma(zd_chassis_rx, work.w_chassis_y, s7_10);
  const double s7_11 = work.w_chassis_y*work.w_chassis_y;
  work.s7_12 = work.w_chassis_z*work.w_chassis_z;
  work.s7_13 = work.w_chassis_x*work.w_chassis_x;
  work.s7_14 = s7_11 + work.s7_13;
  work.s7_15 = s7_11 + work.s7_12;
  work.s7_16 = work.s7_12 + work.s7_13;
  work.s7_17 = mbgen::fms(work.w_chassis_y, work.w_chassis_z, work.alpha_chassis_x);
  work.s7_18 = mbgen::fma(work.w_chassis_y, work.w_chassis_z, work.alpha_chassis_x);
  work.s7_19 = mbgen::fma(work.w_chassis_x, work.w_chassis_z, work.alpha_chassis_y);
  work.s7_20 = mbgen::fma(work.w_chassis_x, work.w_chassis_y, work.alpha_chassis_z);
  work.s7_21 = mbgen::fms(work.w_chassis_x, work.w_chassis_y, work.alpha_chassis_z);
  work.s7_22 = mbgen::fms(work.w_chassis_x, work.w_chassis_z, work.alpha_chassis_y);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_23 = (-p_lower_arm_left_z)*work.s7_19;
  const double s7_24 = mbgen::fma(p_lower_arm_left_x, work.s7_15, s7_23);
  work.s7_25 = mbgen::fma(p_lower_arm_left_y, work.s7_21, work.a_chassis_x);
  const double a_lower_arm_left_x = work.s7_25 - s7_24;
  const double s7_26 = mbgen::fma(p_lower_arm_left_x, work.s7_20, work.a_chassis_y);
  const double s7_27 = mbgen::fnma((-p_lower_arm_left_z), work.s7_17, s7_26);
  work.a_lower_arm_left_y = mbgen::fnma(p_lower_arm_left_y, work.s7_16, s7_27);
  const double s7_28 = p_lower_arm_left_x*work.s7_22;
  const double s7_29 = mbgen::fma((-p_lower_arm_left_z), work.s7_14, s7_28);
  work.s7_30 = mbgen::fma(p_lower_arm_left_y, work.s7_18, work.a_chassis_z);
  work.a_lower_arm_left_z = s7_29 + work.s7_30;
  work.alpha_lower_arm_left_x = derivative.zdd[Coordinate::lower_arm_left] + work.alpha_chassis_x;
  const double alpha_lower_arm_left_y = mbgen::fma(zd_lower_arm_left, work.w_chassis_z,
      work.alpha_chassis_y);
  const double alpha_lower_arm_left_z = mbgen::fnma(zd_lower_arm_left, work.w_chassis_y,
      work.alpha_chassis_z);
  work.s7_31 = mbgen::fma(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_left_x);
  work.s7_32 = mbgen::fms(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_left_x);
  work.s7_33 = mbgen::fma(w_lower_arm_left_x, w_lower_arm_left_x, s7_11);
  work.s7_34 = mbgen::fma(w_lower_arm_left_x, w_lower_arm_left_x, work.s7_12);
  const double s7_35 = mbgen::fma(work.w_chassis_z, w_lower_arm_left_x, alpha_lower_arm_left_y);
  const double s7_36 = mbgen::fms(work.w_chassis_y, w_lower_arm_left_x, alpha_lower_arm_left_z);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s7_37 = mbgen::fma(work.s1_8, s7_36, a_lower_arm_left_x);
  work.a_carrier_left_aux1_x = mbgen::fma(work.s1_10, s7_35, s7_37);
  const double s7_38 = mbgen::fma(work.s1_10, work.s7_32, work.a_lower_arm_left_y);
  work.a_carrier_left_aux1_y = mbgen::fnma(work.s1_8, work.s7_34, s7_38);
  const double s7_39 = mbgen::fma(work.s1_8, work.s7_31, work.a_lower_arm_left_z);
  work.a_carrier_left_aux1_z = mbgen::fnma(work.s1_10, work.s7_33, s7_39);
  const double s7_40 = mbgen::fma(work.w_chassis_y, s4_7, work.alpha_lower_arm_left_x);
  const double alpha_carrier_left_aux1_x = mbgen::fma(work.w_chassis_z, s4_6, s7_40);
  const double zdd_carrier_left_rz = derivative.zdd[Coordinate::carrier_left_rz];
  const double s7_41 = mbgen::fnma(zdd_carrier_left_rz, R_lower_arm_left_z_y,
      alpha_lower_arm_left_y);
  const double alpha_carrier_left_aux1_y = mbgen::fnma(w_lower_arm_left_x, s4_7, s7_41);
  const double s7_42 = mbgen::fma(zdd_carrier_left_rz, R_lower_arm_left_y_y,
      alpha_lower_arm_left_z);
  const double alpha_carrier_left_aux1_z = mbgen::fnma(w_lower_arm_left_x, s4_6, s7_42);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zdd_carrier_left_rx = derivative.zdd[Coordinate::carrier_left_rx];
  const double s7_43 = mbgen::fma(zdd_carrier_left_rx, R_carrier_left_aux1_x_x,
      alpha_carrier_left_aux1_x);
  const double s7_44 = mbgen::fma(w_carrier_left_aux1_y, s4_10, s7_43);
  const double alpha_carrier_left_aux2_x = mbgen::fnma(w_carrier_left_aux1_z, s4_9, s7_44);
  const double s7_45 = mbgen::fma(zdd_carrier_left_rx, work.R_carrier_left_aux1_y_x,
      alpha_carrier_left_aux1_y);
  const double s7_46 = mbgen::fma(w_carrier_left_aux1_z, s4_8, s7_45);
  const double alpha_carrier_left_aux2_y = mbgen::fnma(w_lower_arm_left_x, s4_10, s7_46);
  const double s7_47 = mbgen::fma(zdd_carrier_left_rx, work.R_carrier_left_aux1_z_x,
      alpha_carrier_left_aux1_z);
  const double s7_48 = mbgen::fma(w_lower_arm_left_x, s4_9, s7_47);
  const double alpha_carrier_left_aux2_z = mbgen::fnma(w_carrier_left_aux1_y, s4_8, s7_48);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zdd_carrier_left_ry = derivative.zdd[Coordinate::carrier_left_ry];
  const double s7_49 = mbgen::fnma(zdd_carrier_left_ry, work.s1_12, alpha_carrier_left_aux2_x);
  const double s7_50 = mbgen::fma(w_carrier_left_aux2_y, s4_13, s7_49);
  work.alpha_carrier_left_x = mbgen::fnma(w_carrier_left_aux2_z, s4_12, s7_50);
  const double s7_51 = mbgen::fma(zdd_carrier_left_ry, work.R_carrier_left_aux2_y_y,
      alpha_carrier_left_aux2_y);
  const double s7_52 = mbgen::fnma(w_carrier_left_aux2_x, s4_13, s7_51);
  work.alpha_carrier_left_y = mbgen::fnma(w_carrier_left_aux2_z, s4_11, s7_52);
  const double s7_53 = mbgen::fma(zdd_carrier_left_ry, work.R_carrier_left_aux2_z_y,
      alpha_carrier_left_aux2_z);
  const double s7_54 = mbgen::fma(w_carrier_left_aux2_x, s4_12, s7_53);
  work.alpha_carrier_left_z = mbgen::fma(w_carrier_left_aux2_y, s4_11, s7_54);
  const double s7_55 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s7_56 = work.w_carrier_left_y*work.w_carrier_left_y;
  work.s7_57 = s7_55 + s7_56;
  work.s7_58 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_x, s7_55);
  work.s7_59 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_x, s7_56);
  work.s7_60 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_z, work.alpha_carrier_left_y);
  work.s7_61 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_y, work.alpha_carrier_left_z);
  work.s7_62 = mbgen::fma(work.w_carrier_left_y, work.w_carrier_left_z, work.alpha_carrier_left_x);
  work.s7_63 = mbgen::fms(work.w_carrier_left_x, work.w_carrier_left_z, work.alpha_carrier_left_y);
  work.s7_64 = mbgen::fms(work.w_carrier_left_x, work.w_carrier_left_y, work.alpha_carrier_left_z);
  work.s7_65 = mbgen::fms(work.w_carrier_left_y, work.w_carrier_left_z, work.alpha_carrier_left_x);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_66 = mbgen::fma(work.s1_28, work.s7_64, work.a_carrier_left_aux1_x);
  const double s7_67 = mbgen::fma(work.s1_30, work.s7_60, s7_66);
  work.a_wheel_front_left_x = mbgen::fnma(work.s1_26, work.s7_57, s7_67);
  const double s7_68 = mbgen::fma(work.s1_30, work.s7_65, work.a_carrier_left_aux1_y);
  const double s7_69 = mbgen::fma(work.s1_26, work.s7_61, s7_68);
  work.a_wheel_front_left_y = mbgen::fnma(work.s1_28, work.s7_58, s7_69);
  const double s7_70 = mbgen::fma(work.s1_28, work.s7_62, work.a_carrier_left_aux1_z);
  const double s7_71 = mbgen::fma(work.s1_26, work.s7_63, s7_70);
  work.a_wheel_front_left_z = mbgen::fnma(work.s1_30, work.s7_59, s7_71);
  const double zdd_wheel_front_left = derivative.zdd[Coordinate::wheel_front_left];
  const double s7_72 = mbgen::fnma(zdd_wheel_front_left, work.s1_12, work.alpha_carrier_left_x);
  const double s7_73 = mbgen::fma(work.w_carrier_left_y, s4_16, s7_72);
  work.alpha_wheel_front_left_x = mbgen::fnma(work.w_carrier_left_z, s4_15, s7_73);
  const double s7_74 = mbgen::fma(zdd_wheel_front_left, work.R_carrier_left_aux2_y_y,
      work.alpha_carrier_left_y);
  const double s7_75 = mbgen::fnma(work.w_carrier_left_z, s4_14, s7_74);
  work.alpha_wheel_front_left_y = mbgen::fnma(work.w_carrier_left_x, s4_16, s7_75);
  const double s7_76 = mbgen::fma(zdd_wheel_front_left, work.R_carrier_left_aux2_z_y,
      work.alpha_carrier_left_z);
  const double s7_77 = mbgen::fma(work.w_carrier_left_y, s4_14, s7_76);
  work.alpha_wheel_front_left_z = mbgen::fma(work.w_carrier_left_x, s4_15, s7_77);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s7_78 = mbgen::fnma((-p_upper_arm_left_z), work.s7_17, s7_26);
  work.a_upper_arm_left_y = mbgen::fnma(p_upper_arm_left_y, work.s7_16, s7_78);
  const double s7_79 = mbgen::fma((-p_upper_arm_left_z), work.s7_14, s7_28);
  const double s7_80 = mbgen::fma(p_upper_arm_left_y, work.s7_18, work.a_chassis_z);
  work.a_upper_arm_left_z = s7_79 + s7_80;
  work.alpha_upper_arm_left_x = derivative.zdd[Coordinate::upper_arm_left] + work.alpha_chassis_x;
  work.s7_81 = mbgen::fma(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_left_x);
  work.s7_82 = mbgen::fms(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_left_x);
  work.s7_83 = mbgen::fma(w_upper_arm_left_x, w_upper_arm_left_x, s7_11);
  work.s7_84 = mbgen::fma(w_upper_arm_left_x, w_upper_arm_left_x, work.s7_12);
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_85 = (-p_arb_front_left_z)*work.s7_19;
  const double s7_86 = mbgen::fma(p_arb_front_left_x, work.s7_15, s7_85);
  work.s7_87 = mbgen::fma(p_arb_front_left_y, work.s7_21, work.a_chassis_x);
  work.a_arb_front_left_x = work.s7_87 - s7_86;
  const double s7_88 = mbgen::fnma((-p_arb_front_left_z), work.s7_17, work.a_chassis_y);
  const double s7_89 = mbgen::fma(p_arb_front_left_x, work.s7_20, s7_88);
  work.a_arb_front_left_y = mbgen::fnma(p_arb_front_left_y, work.s7_16, s7_89);
  const double s7_90 = (-p_arb_front_left_z)*work.s7_14;
  const double s7_91 = mbgen::fma(p_arb_front_left_x, work.s7_22, s7_90);
  work.s7_92 = mbgen::fma(p_arb_front_left_y, work.s7_18, work.a_chassis_z);
  work.a_arb_front_left_z = s7_91 + work.s7_92;
  work.alpha_arb_front_left_x = mbgen::fnma(zd_arb_front_left, work.w_chassis_z,
      work.alpha_chassis_x);
  work.alpha_arb_front_left_y = derivative.zdd[Coordinate::arb_front_left] + work.alpha_chassis_y;
  work.alpha_arb_front_left_z = mbgen::fma(zd_arb_front_left, work.w_chassis_x,
      work.alpha_chassis_z);
  work.s7_93 = mbgen::fma(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_left_y);
  work.s7_94 = mbgen::fms(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_left_y);
  work.s7_95 = mbgen::fma(work.w_arb_front_left_y, work.w_arb_front_left_y, work.s7_13);
  work.s7_96 = mbgen::fma(work.w_arb_front_left_y, work.w_arb_front_left_y, work.s7_12);
  work.s7_97 = mbgen::fma(work.w_chassis_x, work.w_arb_front_left_y, work.alpha_arb_front_left_z);
  work.s7_98 = mbgen::fma(work.w_chassis_z, work.w_arb_front_left_y, work.alpha_arb_front_left_x);
  work.s7_99 = mbgen::fms(work.w_chassis_x, work.w_arb_front_left_y, work.alpha_arb_front_left_z);
  work.s7_100 = mbgen::fms(work.w_chassis_z, work.w_arb_front_left_y, work.alpha_arb_front_left_x);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double a_lower_arm_right_x = mbgen::fnma(p_lower_arm_left_y, work.s7_21,
      work.a_chassis_x) - s7_24;
  work.a_lower_arm_right_y = mbgen::fma(p_lower_arm_left_y, work.s7_16, s7_27);
  work.a_lower_arm_right_z = mbgen::fnma(p_lower_arm_left_y, work.s7_18, work.a_chassis_z + s7_29);
  work.alpha_lower_arm_right_x = derivative.zdd[Coordinate::lower_arm_right] + work.alpha_chassis_x;
  const double alpha_lower_arm_right_y = mbgen::fma(zd_lower_arm_right, work.w_chassis_z,
      work.alpha_chassis_y);
  const double alpha_lower_arm_right_z = mbgen::fnma(zd_lower_arm_right, work.w_chassis_y,
      work.alpha_chassis_z);
  work.s7_101 = mbgen::fma(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_right_x);
  work.s7_102 = mbgen::fms(work.w_chassis_y, work.w_chassis_z, work.alpha_lower_arm_right_x);
  work.s7_103 = mbgen::fma(w_lower_arm_right_x, w_lower_arm_right_x, s7_11);
  work.s7_104 = mbgen::fma(w_lower_arm_right_x, w_lower_arm_right_x, work.s7_12);
  const double s7_105 = mbgen::fma(work.w_chassis_z, w_lower_arm_right_x, alpha_lower_arm_right_y);
  const double s7_106 = mbgen::fms(work.w_chassis_y, w_lower_arm_right_x, alpha_lower_arm_right_z);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s7_107 = mbgen::fma(work.s1_33, s7_106, a_lower_arm_right_x);
  work.a_carrier_right_aux1_x = mbgen::fnma(work.s1_35, s7_105, s7_107);
  const double s7_108 = mbgen::fnma(work.s1_35, work.s7_102, work.a_lower_arm_right_y);
  work.a_carrier_right_aux1_y = mbgen::fnma(work.s1_33, work.s7_104, s7_108);
  const double s7_109 = mbgen::fma(work.s1_35, work.s7_103, work.a_lower_arm_right_z);
  work.a_carrier_right_aux1_z = mbgen::fma(work.s1_33, work.s7_101, s7_109);
  const double s7_110 = mbgen::fma(work.w_chassis_y, s4_18, work.alpha_lower_arm_right_x);
  const double alpha_carrier_right_aux1_x = mbgen::fma(work.w_chassis_z, s4_17, s7_110);
  const double zdd_carrier_right_rz = derivative.zdd[Coordinate::carrier_right_rz];
  const double s7_111 = mbgen::fnma(zdd_carrier_right_rz, R_lower_arm_right_z_y,
      alpha_lower_arm_right_y);
  const double alpha_carrier_right_aux1_y = mbgen::fnma(w_lower_arm_right_x, s4_18, s7_111);
  const double s7_112 = mbgen::fma(zdd_carrier_right_rz, R_lower_arm_right_y_y,
      alpha_lower_arm_right_z);
  const double alpha_carrier_right_aux1_z = mbgen::fnma(w_lower_arm_right_x, s4_17, s7_112);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zdd_carrier_right_rx = derivative.zdd[Coordinate::carrier_right_rx];
  const double s7_113 = mbgen::fma(zdd_carrier_right_rx, R_carrier_right_aux1_x_x,
      alpha_carrier_right_aux1_x);
  const double s7_114 = mbgen::fma(w_carrier_right_aux1_y, s4_21, s7_113);
  const double alpha_carrier_right_aux2_x = mbgen::fnma(w_carrier_right_aux1_z, s4_20, s7_114);
  const double s7_115 = mbgen::fma(zdd_carrier_right_rx, work.R_carrier_right_aux1_y_x,
      alpha_carrier_right_aux1_y);
  const double s7_116 = mbgen::fma(w_carrier_right_aux1_z, s4_19, s7_115);
  const double alpha_carrier_right_aux2_y = mbgen::fnma(w_lower_arm_right_x, s4_21, s7_116);
  const double s7_117 = mbgen::fma(zdd_carrier_right_rx, work.R_carrier_right_aux1_z_x,
      alpha_carrier_right_aux1_z);
  const double s7_118 = mbgen::fma(w_lower_arm_right_x, s4_20, s7_117);
  const double alpha_carrier_right_aux2_z = mbgen::fnma(w_carrier_right_aux1_y, s4_19, s7_118);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zdd_carrier_right_ry = derivative.zdd[Coordinate::carrier_right_ry];
  const double s7_119 = mbgen::fnma(zdd_carrier_right_ry, work.s1_38, alpha_carrier_right_aux2_x);
  const double s7_120 = mbgen::fma(w_carrier_right_aux2_y, s4_24, s7_119);
  work.alpha_carrier_right_x = mbgen::fnma(w_carrier_right_aux2_z, s4_23, s7_120);
  const double s7_121 = mbgen::fma(zdd_carrier_right_ry, work.R_carrier_right_aux2_y_y,
      alpha_carrier_right_aux2_y);
  const double s7_122 = mbgen::fnma(w_carrier_right_aux2_x, s4_24, s7_121);
  work.alpha_carrier_right_y = mbgen::fnma(w_carrier_right_aux2_z, s4_22, s7_122);
  const double s7_123 = mbgen::fma(zdd_carrier_right_ry, work.R_carrier_right_aux2_z_y,
      alpha_carrier_right_aux2_z);
  const double s7_124 = mbgen::fma(w_carrier_right_aux2_x, s4_23, s7_123);
  work.alpha_carrier_right_z = mbgen::fma(w_carrier_right_aux2_y, s4_22, s7_124);
  const double s7_125 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s7_126 = work.w_carrier_right_y*work.w_carrier_right_y;
  work.s7_127 = s7_125 + s7_126;
  work.s7_128 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_x, s7_125);
  work.s7_129 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_x, s7_126);
  work.s7_130 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_z,
      work.alpha_carrier_right_y);
  work.s7_131 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_y,
      work.alpha_carrier_right_z);
  work.s7_132 = mbgen::fma(work.w_carrier_right_y, work.w_carrier_right_z,
      work.alpha_carrier_right_x);
  work.s7_133 = mbgen::fms(work.w_carrier_right_x, work.w_carrier_right_z,
      work.alpha_carrier_right_y);
  work.s7_134 = mbgen::fms(work.w_carrier_right_x, work.w_carrier_right_y,
      work.alpha_carrier_right_z);
  work.s7_135 = mbgen::fms(work.w_carrier_right_y, work.w_carrier_right_z,
      work.alpha_carrier_right_x);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_136 = mbgen::fma(work.s1_54, work.s7_134, work.a_carrier_right_aux1_x);
  const double s7_137 = mbgen::fma(work.s1_56, work.s7_130, s7_136);
  work.a_wheel_front_right_x = mbgen::fnma(work.s1_52, work.s7_127, s7_137);
  const double s7_138 = mbgen::fma(work.s1_52, work.s7_131, work.a_carrier_right_aux1_y);
  const double s7_139 = mbgen::fma(work.s1_56, work.s7_135, s7_138);
  work.a_wheel_front_right_y = mbgen::fnma(work.s1_54, work.s7_128, s7_139);
  const double s7_140 = mbgen::fma(work.s1_54, work.s7_132, work.a_carrier_right_aux1_z);
  const double s7_141 = mbgen::fma(work.s1_52, work.s7_133, s7_140);
  work.a_wheel_front_right_z = mbgen::fnma(work.s1_56, work.s7_129, s7_141);
  const double zdd_wheel_front_right = derivative.zdd[Coordinate::wheel_front_right];
  const double s7_142 = mbgen::fnma(zdd_wheel_front_right, work.s1_38, work.alpha_carrier_right_x);
  const double s7_143 = mbgen::fma(work.w_carrier_right_y, s4_27, s7_142);
  work.alpha_wheel_front_right_x = mbgen::fnma(work.w_carrier_right_z, s4_26, s7_143);
  const double s7_144 = mbgen::fma(zdd_wheel_front_right, work.R_carrier_right_aux2_y_y,
      work.alpha_carrier_right_y);
  const double s7_145 = mbgen::fnma(work.w_carrier_right_z, s4_25, s7_144);
  work.alpha_wheel_front_right_y = mbgen::fnma(work.w_carrier_right_x, s4_27, s7_145);
  const double s7_146 = mbgen::fma(zdd_wheel_front_right, work.R_carrier_right_aux2_z_y,
      work.alpha_carrier_right_z);
  const double s7_147 = mbgen::fma(work.w_carrier_right_y, s4_25, s7_146);
  work.alpha_wheel_front_right_z = mbgen::fma(work.w_carrier_right_x, s4_26, s7_147);
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.a_upper_arm_right_y = mbgen::fma(p_upper_arm_left_y, work.s7_16, s7_78);
  work.a_upper_arm_right_z = mbgen::fnma(p_upper_arm_left_y, work.s7_18, work.a_chassis_z + s7_79);
  work.alpha_upper_arm_right_x = derivative.zdd[Coordinate::upper_arm_right] + work.alpha_chassis_x;
  work.s7_148 = mbgen::fma(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_right_x);
  work.s7_149 = mbgen::fms(work.w_chassis_y, work.w_chassis_z, work.alpha_upper_arm_right_x);
  work.s7_150 = mbgen::fma(w_upper_arm_right_x, w_upper_arm_right_x, s7_11);
  work.s7_151 = mbgen::fma(w_upper_arm_right_x, w_upper_arm_right_x, work.s7_12);
  // arb_front_right: arb_front_right, revolute, chassis
  work.a_arb_front_right_x = mbgen::fnma(p_arb_front_left_y, work.s7_21, work.a_chassis_x) - s7_86;
  work.a_arb_front_right_y = mbgen::fma(p_arb_front_left_y, work.s7_16, s7_89);
  work.a_arb_front_right_z = mbgen::fnma(p_arb_front_left_y, work.s7_18, work.a_chassis_z + s7_91);
  work.alpha_arb_front_right_x = mbgen::fnma(zd_arb_front_right, work.w_chassis_z,
      work.alpha_chassis_x);
  work.alpha_arb_front_right_y = derivative.zdd[Coordinate::arb_front_right] + work.alpha_chassis_y;
  work.alpha_arb_front_right_z = mbgen::fma(zd_arb_front_right, work.w_chassis_x,
      work.alpha_chassis_z);
  work.s7_152 = mbgen::fma(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_right_y);
  work.s7_153 = mbgen::fms(work.w_chassis_x, work.w_chassis_z, work.alpha_arb_front_right_y);
  work.s7_154 = mbgen::fma(work.w_arb_front_right_y, work.w_arb_front_right_y, work.s7_13);
  work.s7_155 = mbgen::fma(work.w_arb_front_right_y, work.w_arb_front_right_y, work.s7_12);
  work.s7_156 = mbgen::fma(work.w_chassis_x, work.w_arb_front_right_y,
      work.alpha_arb_front_right_z);
  work.s7_157 = mbgen::fma(work.w_chassis_z, work.w_arb_front_right_y,
      work.alpha_arb_front_right_x);
  work.s7_158 = mbgen::fms(work.w_chassis_x, work.w_arb_front_right_y,
      work.alpha_arb_front_right_z);
  work.s7_159 = mbgen::fms(work.w_chassis_z, work.w_arb_front_right_y,
      work.alpha_arb_front_right_x);
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_160 = mbgen::fma(p_upper_arm_left_y, work.s7_21, work.a_chassis_x);
  const double s7_161 = mbgen::fnma((-p_pitman_arm_z), work.s7_19, s7_160);
  work.a_pitman_arm_x = mbgen::fnma(p_pitman_arm_x, work.s7_15, s7_161);
  const double s7_162 = mbgen::fnma(p_upper_arm_left_y, work.s7_16, work.a_chassis_y);
  const double s7_163 = mbgen::fma(p_pitman_arm_x, work.s7_20, s7_162);
  work.a_pitman_arm_y = mbgen::fnma((-p_pitman_arm_z), work.s7_17, s7_163);
  const double s7_164 = mbgen::fma((-p_pitman_arm_z), work.s7_14, s7_80);
  work.a_pitman_arm_z = mbgen::fma(p_pitman_arm_x, work.s7_22, s7_164);
  const double alpha_pitman_arm_x = mbgen::fnma(zd_pitman_arm, work.w_chassis_z,
      work.alpha_chassis_x);
  work.alpha_pitman_arm_y = derivative.zdd[Coordinate::pitman_arm] + work.alpha_chassis_y;
  const double alpha_pitman_arm_z = mbgen::fma(zd_pitman_arm, work.w_chassis_x,
      work.alpha_chassis_z);
  work.s7_165 = mbgen::fma(work.w_chassis_x, work.w_chassis_z, work.alpha_pitman_arm_y);
  work.s7_166 = mbgen::fms(work.w_chassis_x, work.w_chassis_z, work.alpha_pitman_arm_y);
  work.s7_167 = mbgen::fma(w_pitman_arm_y, w_pitman_arm_y, work.s7_13);
  work.s7_168 = mbgen::fma(w_pitman_arm_y, w_pitman_arm_y, work.s7_12);
  work.s7_169 = mbgen::fma(work.w_chassis_x, w_pitman_arm_y, alpha_pitman_arm_z);
  work.s7_170 = mbgen::fms(work.w_chassis_z, w_pitman_arm_y, alpha_pitman_arm_x);
  // bell_crank: bell_crank, revolute, chassis
  const double s7_171 = mbgen::fnma((-p_bell_crank_z), work.s7_19, work.a_chassis_x);
  work.a_bell_crank_x = mbgen::fnma(p_bell_crank_x, work.s7_15, s7_171);
  const double s7_172 = mbgen::fma(p_bell_crank_x, work.s7_20, work.a_chassis_y);
  work.a_bell_crank_y = mbgen::fnma((-p_bell_crank_z), work.s7_17, s7_172);
  const double s7_173 = mbgen::fma((-p_bell_crank_z), work.s7_14, work.a_chassis_z);
  work.a_bell_crank_z = mbgen::fma(p_bell_crank_x, work.s7_22, s7_173);
  const double alpha_bell_crank_x = mbgen::fma(zd_bell_crank, work.w_chassis_y,
      work.alpha_chassis_x);
  const double alpha_bell_crank_y = mbgen::fnma(zd_bell_crank, work.w_chassis_x,
      work.alpha_chassis_y);
  work.alpha_bell_crank_z = derivative.zdd[Coordinate::bell_crank] + work.alpha_chassis_z;
  work.s7_174 = mbgen::fma(work.w_chassis_x, work.w_chassis_y, work.alpha_bell_crank_z);
  work.s7_175 = mbgen::fms(work.w_chassis_x, work.w_chassis_y, work.alpha_bell_crank_z);
  work.s7_176 = mbgen::fma(w_bell_crank_z, w_bell_crank_z, s7_11);
  work.s7_177 = mbgen::fma(w_bell_crank_z, w_bell_crank_z, work.s7_13);
  work.s7_178 = mbgen::fma(work.w_chassis_y, w_bell_crank_z, alpha_bell_crank_x);
  work.s7_179 = mbgen::fms(work.w_chassis_x, w_bell_crank_z, alpha_bell_crank_y);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double s7_180 = derivative.zdd[Coordinate::rear_axle_tx] + work.a_chassis_x - s7_85;
  const double a_rear_axle_aux1_x = mbgen::fnma(work.r_rear_axle_aux1_x, work.s7_15, s7_180);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s7_181 = mbgen::fma(zd_rear_axle_tx, work.w_chassis_z, work.a_chassis_y);
  const double s7_182 = mbgen::fma(zd_rear_axle_tx, work.w_chassis_z, s7_181);
  const double s7_183 = mbgen::fnma((-p_arb_front_left_z), work.s7_17, s7_182);
  const double a_rear_axle_aux1_y = mbgen::fma(work.r_rear_axle_aux1_x, work.s7_20, s7_183);
  const double s7_184 = mbgen::fnma(zd_rear_axle_tx, work.w_chassis_y, work.a_chassis_z + s7_90);
  const double s7_185 = mbgen::fnma(zd_rear_axle_tx, work.w_chassis_y, s7_184);
  const double a_rear_axle_aux1_z = mbgen::fma(work.r_rear_axle_aux1_x, work.s7_22, s7_185);
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s7_186 = mbgen::fnma(zd_rear_axle_ty, work.w_chassis_z, a_rear_axle_aux1_x);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s7_187 = mbgen::fnma(zd_rear_axle_ty, work.w_chassis_z, s7_186);
  const double a_rear_axle_aux2_x = mbgen::fma(z_rear_axle_ty, work.s7_21, s7_187);
  const double s7_188 = derivative.zdd[Coordinate::rear_axle_ty] + a_rear_axle_aux1_y;
  const double a_rear_axle_aux2_y = mbgen::fnma(z_rear_axle_ty, work.s7_16, s7_188);
  const double s7_189 = mbgen::fma(zd_rear_axle_ty, work.w_chassis_x, a_rear_axle_aux1_z);
  const double s7_190 = mbgen::fma(zd_rear_axle_ty, work.w_chassis_x, s7_189);
  const double a_rear_axle_aux2_z = mbgen::fma(z_rear_axle_ty, work.s7_18, s7_190);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s7_191 = mbgen::fma(zd_rear_axle_tz, work.w_chassis_y, a_rear_axle_aux2_x);
  const double s7_192 = mbgen::fma(zd_rear_axle_tz, work.w_chassis_y, s7_191);
  work.a_rear_axle_aux3_x = mbgen::fma(z_rear_axle_tz, work.s7_19, s7_192);
  const double s7_193 = mbgen::fnma(zd_rear_axle_tz, work.w_chassis_x, a_rear_axle_aux2_y);
  const double s7_194 = mbgen::fnma(zd_rear_axle_tz, work.w_chassis_x, s7_193);
  work.a_rear_axle_aux3_y = mbgen::fma(z_rear_axle_tz, work.s7_17, s7_194);
  const double s7_195 = derivative.zdd[Coordinate::rear_axle_tz] + a_rear_axle_aux2_z;
  work.a_rear_axle_aux3_z = mbgen::fnma(z_rear_axle_tz, work.s7_14, s7_195);
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double alpha_rear_axle_aux4_x = mbgen::fma(zd_rear_axle_rz, work.w_chassis_y,
      work.alpha_chassis_x);
  const double alpha_rear_axle_aux4_y = mbgen::fnma(zd_rear_axle_rz, work.w_chassis_x,
      work.alpha_chassis_y);
  const double alpha_rear_axle_aux4_z = derivative.zdd[Coordinate::rear_axle_rz] +
      work.alpha_chassis_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zdd_rear_axle_ry = derivative.zdd[Coordinate::rear_axle_ry];
  const double s7_196 = mbgen::fnma(zdd_rear_axle_ry, R_rear_axle_aux4_y_x, alpha_rear_axle_aux4_x);
  const double alpha_rear_axle_aux5_x = mbgen::fnma(w_rear_axle_aux4_z, s4_29, s7_196);
  const double s7_197 = mbgen::fma(zdd_rear_axle_ry, R_rear_axle_aux4_x_x, alpha_rear_axle_aux4_y);
  const double alpha_rear_axle_aux5_y = mbgen::fnma(w_rear_axle_aux4_z, s4_28, s7_197);
  const double s7_198 = mbgen::fma(work.w_chassis_y, s4_28, alpha_rear_axle_aux4_z);
  const double alpha_rear_axle_aux5_z = mbgen::fma(work.w_chassis_x, s4_29, s7_198);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zdd_rear_axle_rx = derivative.zdd[Coordinate::rear_axle_rx];
  const double s7_199 = mbgen::fma(zdd_rear_axle_rx, work.R_rear_axle_aux5_x_x,
      alpha_rear_axle_aux5_x);
  const double s7_200 = mbgen::fnma(w_rear_axle_aux4_z, s4_31, s7_199);
  work.alpha_rear_axle_x = mbgen::fnma(w_rear_axle_aux5_y, s4_32, s7_200);
  const double s7_201 = mbgen::fma(zdd_rear_axle_rx, work.R_rear_axle_aux5_y_x,
      alpha_rear_axle_aux5_y);
  const double s7_202 = mbgen::fma(w_rear_axle_aux4_z, s4_30, s7_201);
  work.alpha_rear_axle_y = mbgen::fma(w_rear_axle_aux5_x, s4_32, s7_202);
  const double s7_203 = mbgen::fnma(zdd_rear_axle_rx, s1_57, alpha_rear_axle_aux5_z);
  const double s7_204 = mbgen::fma(w_rear_axle_aux5_x, s4_31, s7_203);
  work.alpha_rear_axle_z = mbgen::fnma(w_rear_axle_aux5_y, s4_30, s7_204);
}

/// Part 2 of compute_multipliers: step 7: inertias of the bodies and forces on joints.
[[gnu::noinline]] void compute_multipliers_2(const State& state, const double* tau,
    const Derivative& derivative, ConstraintForcesWork& __restrict work,
    ConstraintForces& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_205 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s7_206 = work.w_rear_axle_x*work.w_rear_axle_x;
  const double s7_207 = s7_205 + s7_206;
  const double s7_208 = mbgen::fma(work.w_rear_axle_z, work.w_rear_axle_z, s7_205);
  const double s7_209 = mbgen::fma(work.w_rear_axle_z, work.w_rear_axle_z, s7_206);
  const double s7_210 = mbgen::fma(work.w_rear_axle_y, work.w_rear_axle_z, work.alpha_rear_axle_x);
  const double s7_211 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_z, work.alpha_rear_axle_y);
  const double s7_212 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_y, work.alpha_rear_axle_z);
  const double s7_213 = mbgen::fms(work.w_rear_axle_y, work.w_rear_axle_z, work.alpha_rear_axle_x);
  const double s7_214 = mbgen::fms(work.w_rear_axle_x, work.w_rear_axle_z, work.alpha_rear_axle_y);
  const double s7_215 = mbgen::fms(work.w_rear_axle_x, work.w_rear_axle_y, work.alpha_rear_axle_z);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_216 = mbgen::fma(work.s1_64, s7_211, work.a_rear_axle_aux3_x);
  const double a_wheel_rear_left_x = mbgen::fnma(work.s1_62, s7_208, mbgen::fma(work.s1_63, s7_215,
      s7_216));
  const double s7_217 = mbgen::fma(work.s1_62, s7_212, work.s1_64*s7_213);
  const double a_wheel_rear_left_y = mbgen::fnma(work.s1_63, s7_209,
      work.a_rear_axle_aux3_y + s7_217);
  const double s7_218 = mbgen::fma(work.s1_62, s7_214, work.a_rear_axle_aux3_z);
  const double a_wheel_rear_left_z = mbgen::fnma(work.s1_64, s7_207, mbgen::fma(work.s1_63, s7_210,
      s7_218));
  const double zdd_wheel_rear_left = derivative.zdd[Coordinate::wheel_rear_left];
  const double s7_219 = mbgen::fma(zdd_wheel_rear_left, work.R_rear_axle_x_y,
      work.alpha_rear_axle_x);
  const double s7_220 = mbgen::fma(work.w_rear_axle_y, work.s4_35, s7_219);
  const double alpha_wheel_rear_left_x = mbgen::fnma(work.w_rear_axle_z, work.s4_34, s7_220);
  const double s7_221 = mbgen::fma(zdd_wheel_rear_left, work.R_rear_axle_y_y,
      work.alpha_rear_axle_y);
  const double s7_222 = mbgen::fma(work.w_rear_axle_z, work.s4_33, s7_221);
  const double alpha_wheel_rear_left_y = mbgen::fnma(work.w_rear_axle_x, work.s4_35, s7_222);
  const double s7_223 = mbgen::fma(zdd_wheel_rear_left, work.R_rear_axle_z_y,
      work.alpha_rear_axle_z);
  const double s7_224 = mbgen::fma(work.w_rear_axle_x, work.s4_34, s7_223);
  const double alpha_wheel_rear_left_z = mbgen::fnma(work.w_rear_axle_y, work.s4_33, s7_224);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_225 = (-p_arb_rear_left_x)*work.s7_15;
  const double s7_226 = mbgen::fnma((-p_arb_rear_left_z), work.s7_19, s7_225);
  const double a_arb_rear_left_x = work.s7_87 + s7_226;
  const double s7_227 = (-p_arb_rear_left_z)*work.s7_17;
  const double s7_228 = mbgen::fma((-p_arb_rear_left_x), work.s7_20, s7_227);
  const double a_arb_rear_left_y = mbgen::fnma(p_arb_front_left_y, work.s7_16,
      work.a_chassis_y) - s7_228;
  const double s7_229 = (-p_arb_rear_left_z)*work.s7_14;
  const double s7_230 = mbgen::fnma((-p_arb_rear_left_x), work.s7_22, s7_229);
  const double a_arb_rear_left_z = work.s7_92 + s7_230;
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double alpha_arb_rear_left_x = mbgen::fnma(zd_arb_rear_left, work.w_chassis_z,
      work.alpha_chassis_x);
  const double alpha_arb_rear_left_y = derivative.zdd[Coordinate::arb_rear_left] +
      work.alpha_chassis_y;
  const double alpha_arb_rear_left_z = mbgen::fma(zd_arb_rear_left, work.w_chassis_x,
      work.alpha_chassis_z);
  const double s7_231 = mbgen::fma(work.w_chassis_x, work.w_chassis_z, alpha_arb_rear_left_y);
  const double s7_232 = mbgen::fms(work.w_chassis_x, work.w_chassis_z, alpha_arb_rear_left_y);
  const double s7_233 = mbgen::fma(work.w_arb_rear_left_y, work.w_arb_rear_left_y, work.s7_13);
  const double s7_234 = mbgen::fma(work.w_arb_rear_left_y, work.w_arb_rear_left_y, work.s7_12);
  const double s7_235 = mbgen::fma(work.w_chassis_x, work.w_arb_rear_left_y, alpha_arb_rear_left_z);
  const double s7_236 = mbgen::fma(work.w_chassis_z, work.w_arb_rear_left_y, alpha_arb_rear_left_x);
  const double s7_237 = mbgen::fms(work.w_chassis_x, work.w_arb_rear_left_y, alpha_arb_rear_left_z);
  const double s7_238 = mbgen::fms(work.w_chassis_z, work.w_arb_rear_left_y, alpha_arb_rear_left_x);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_239 = mbgen::fma(work.s1_62, s7_208, work.a_rear_axle_aux3_x);
  const double a_wheel_rear_right_x = mbgen::fnma(work.s1_63, s7_215, mbgen::fnma(work.s1_64,
      s7_211, s7_239));
  const double a_wheel_rear_right_y = mbgen::fma(work.s1_63, s7_209,
      work.a_rear_axle_aux3_y) - s7_217;
  const double s7_240 = mbgen::fma(work.s1_64, s7_207, work.a_rear_axle_aux3_z);
  const double a_wheel_rear_right_z = mbgen::fnma(work.s1_63, s7_210, mbgen::fnma(work.s1_62,
      s7_214, s7_240));
  const double zdd_wheel_rear_right = derivative.zdd[Coordinate::wheel_rear_right];
  const double s7_241 = mbgen::fma(zdd_wheel_rear_right, work.R_rear_axle_x_y,
      work.alpha_rear_axle_x);
  const double s7_242 = mbgen::fma(work.w_rear_axle_y, work.s4_38, s7_241);
  const double alpha_wheel_rear_right_x = mbgen::fnma(work.w_rear_axle_z, work.s4_37, s7_242);
  const double s7_243 = mbgen::fma(zdd_wheel_rear_right, work.R_rear_axle_y_y,
      work.alpha_rear_axle_y);
  const double s7_244 = mbgen::fma(work.w_rear_axle_z, work.s4_36, s7_243);
  const double alpha_wheel_rear_right_y = mbgen::fnma(work.w_rear_axle_x, work.s4_38, s7_244);
  const double s7_245 = mbgen::fma(zdd_wheel_rear_right, work.R_rear_axle_z_y,
      work.alpha_rear_axle_z);
  const double s7_246 = mbgen::fma(work.w_rear_axle_x, work.s4_37, s7_245);
  const double alpha_wheel_rear_right_z = mbgen::fnma(work.w_rear_axle_y, work.s4_36, s7_246);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double a_arb_rear_right_x = mbgen::fnma(p_arb_front_left_y, work.s7_21,
      work.a_chassis_x + s7_226);
  const double a_arb_rear_right_y = mbgen::fma(p_arb_front_left_y, work.s7_16,
      work.a_chassis_y) - s7_228;
  const double a_arb_rear_right_z = mbgen::fnma(p_arb_front_left_y, work.s7_18,
      work.a_chassis_z + s7_230);
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double alpha_arb_rear_right_x = mbgen::fnma(zd_arb_rear_right, work.w_chassis_z,
      work.alpha_chassis_x);
  const double alpha_arb_rear_right_y = derivative.zdd[Coordinate::arb_rear_right] +
      work.alpha_chassis_y;
  const double alpha_arb_rear_right_z = mbgen::fma(zd_arb_rear_right, work.w_chassis_x,
      work.alpha_chassis_z);
  const double s7_247 = mbgen::fma(work.w_chassis_x, work.w_chassis_z, alpha_arb_rear_right_y);
  const double s7_248 = mbgen::fms(work.w_chassis_x, work.w_chassis_z, alpha_arb_rear_right_y);
  const double s7_249 = mbgen::fma(work.w_arb_rear_right_y, work.w_arb_rear_right_y, work.s7_13);
  const double s7_250 = mbgen::fma(work.w_arb_rear_right_y, work.w_arb_rear_right_y, work.s7_12);
  const double s7_251 = mbgen::fma(work.w_chassis_x, work.w_arb_rear_right_y,
      alpha_arb_rear_right_z);
  const double s7_252 = mbgen::fma(work.w_chassis_z, work.w_arb_rear_right_y,
      alpha_arb_rear_right_x);
  const double s7_253 = mbgen::fms(work.w_chassis_x, work.w_arb_rear_right_y,
      alpha_arb_rear_right_z);
  const double s7_254 = mbgen::fms(work.w_chassis_z, work.w_arb_rear_right_y,
      alpha_arb_rear_right_x);
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_255 = (-p_arb_link_front_left_from_x)*R_arb_front_left_x_z;
  work.s7_256 = mbgen::fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s7_255);
  const double s7_257 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s7_258 = mbgen::fnma((-p_arb_link_front_left_from_x), R_arb_front_left_x_x, s7_257);
  const double s7_259 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s7_260 = work.s1_12 + work.R_carrier_left_x_z;
  work.s7_261 = mbgen::fma((-p_arb_link_front_left_to_y), s7_260, s7_259);
  const double s7_262 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s7_263 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s7_264 = mbgen::fma((-p_arb_link_front_left_to_y), s7_262, s7_263);
  const double s7_265 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s7_266 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s7_267 = mbgen::fma((-p_arb_link_front_left_to_y), s7_265, s7_266);
  const double s7_268 = mbgen::fnma(p_arb_link_front_left_from_y, work.s7_16,
      work.a_arb_front_left_y);
  const double s7_269 = mbgen::fma(work.s7_97, work.s7_258, s7_268);
  work.s7_270 = 0.3333333333333333*mbgen::fma(work.s7_100, work.s7_256, s7_269);
  const double s7_271 = mbgen::fma(p_arb_link_front_left_from_y, work.s7_98,
      work.a_arb_front_left_z);
  const double s7_272 = mbgen::fma(work.s7_94, work.s7_258, s7_271);
  work.s7_273 = 0.3333333333333333*mbgen::fnma(work.s7_95, work.s7_256, s7_272);
  const double s7_274 = mbgen::fma(p_arb_link_front_left_from_y, work.s7_99,
      work.a_arb_front_left_x);
  const double s7_275 = mbgen::fma(work.s7_93, work.s7_256, s7_274);
  work.s7_276 = 0.3333333333333333*mbgen::fnma(work.s7_96, work.s7_258, s7_275);
  const double s7_277 = mbgen::fma(work.s7_62, work.s7_264, work.a_carrier_left_aux1_z);
  const double s7_278 = mbgen::fma(work.s7_63, work.s7_261, s7_277);
  const double s7_279 = 0.3333333333333333*mbgen::fnma(work.s7_59, work.s7_267, s7_278);
  const double s7_280 = mbgen::fma(work.s7_64, work.s7_264, work.a_carrier_left_aux1_x);
  const double s7_281 = mbgen::fma(work.s7_60, work.s7_267, s7_280);
  const double s7_282 = 0.3333333333333333*mbgen::fnma(work.s7_57, work.s7_261, s7_281);
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_283 = (-p_arb_link_front_right_from_x)*R_arb_front_right_x_z;
  work.s7_284 = mbgen::fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s7_283);
  const double s7_285 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s7_286 = mbgen::fnma((-p_arb_link_front_right_from_x), R_arb_front_right_x_x, s7_285);
  const double s7_287 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s7_288 = work.R_carrier_right_x_z - work.s1_38;
  work.s7_289 = mbgen::fma((-p_arb_link_front_left_to_y), s7_288, s7_287);
  const double s7_290 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s7_291 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s7_292 = mbgen::fma((-p_arb_link_front_left_to_y), s7_290, s7_291);
  const double s7_293 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s7_294 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s7_295 = mbgen::fma((-p_arb_link_front_left_to_y), s7_293, s7_294);
  const double s7_296 = mbgen::fma(p_arb_link_front_left_from_y, work.s7_16,
      work.a_arb_front_right_y);
  const double s7_297 = mbgen::fma(work.s7_156, work.s7_286, s7_296);
  const double s7_298 = 0.3333333333333333*mbgen::fma(work.s7_159, work.s7_284, s7_297);
  const double s7_299 = mbgen::fma(work.s7_153, work.s7_286, work.a_arb_front_right_z);
  const double s7_300 = mbgen::fnma(work.s7_154, work.s7_284, s7_299);
  const double s7_301 = mbgen::fnma((-p_arb_link_front_right_from_y), work.s7_157, s7_300);
  const double s7_302 = 0.3333333333333333*s7_301;
  const double s7_303 = mbgen::fma(work.s7_152, work.s7_284, work.a_arb_front_right_x);
  const double s7_304 = mbgen::fnma(work.s7_155, work.s7_286, s7_303);
  const double s7_305 = mbgen::fnma((-p_arb_link_front_right_from_y), work.s7_158, s7_304);
  const double s7_306 = 0.3333333333333333*s7_305;
  const double s7_307 = mbgen::fma(work.s7_132, work.s7_292, work.a_carrier_right_aux1_z);
  const double s7_308 = mbgen::fma(work.s7_133, work.s7_289, s7_307);
  const double s7_309 = 0.3333333333333333*mbgen::fnma(work.s7_129, work.s7_295, s7_308);
  const double s7_310 = mbgen::fma(work.s7_134, work.s7_292, work.a_carrier_right_aux1_x);
  const double s7_311 = mbgen::fma(work.s7_130, work.s7_295, s7_310);
  const double s7_312 = 0.3333333333333333*mbgen::fnma(work.s7_127, work.s7_289, s7_311);
  // drag_link
  const double R_pitman_arm_x_z = work.sines[15];
  work.s7_313 = (-p_drag_link_from_z)*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s7_314 = (-p_drag_link_from_z)*R_pitman_arm_x_x;
  const double R_bell_crank_y_x = work.sines[16];
  work.s7_315 = p_drag_link_to_y*R_bell_crank_y_x;
  const double R_bell_crank_x_x = work.cosines[16];
  const double s7_316 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s7_317 = mbgen::fma(work.s7_168, work.s7_313, work.a_pitman_arm_x);
  const double s7_318 = 1.5*mbgen::fnma(work.s7_165, work.s7_314, s7_317);
  const double s7_319 = mbgen::fma(work.s7_178, s7_316, work.a_bell_crank_z);
  const double s7_320 = 1.5*mbgen::fnma(work.s7_179, work.s7_315, s7_319);
  const double s7_321 = mbgen::fma(work.s7_176, work.s7_315, work.a_bell_crank_x);
  const double s7_322 = 1.5*mbgen::fma(work.s7_175, s7_316, s7_321);
  const double s7_323 = mbgen::fnma(work.s7_169, work.s7_313, work.a_pitman_arm_y);
  const double s7_324 = 1.5*mbgen::fnma(work.s7_170, work.s7_314, s7_323);
  // tie_rod_left
  work.s7_325 = (-p_tie_rod_left_to_y)*work.R_carrier_left_aux2_z_y;
  work.s7_326 = (-p_tie_rod_left_to_y)*work.R_carrier_left_aux2_y_y;
  const double s7_327 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s7_328 = (-p_tie_rod_left_from_x)*R_bell_crank_y_x;
  work.s7_329 = mbgen::fma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s7_327);
  work.s7_330 = mbgen::fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_328);
  work.s7_331 = (-p_tie_rod_left_to_y)*work.s1_12;
  const double s7_332 = mbgen::fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, work.s7_331);
  work.s7_333 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_x_x, s7_332);
  const double s7_334 = mbgen::fms(p_tie_rod_left_to_z, work.R_carrier_left_y_z, work.s7_326);
  work.s7_335 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_y_x, s7_334);
  const double s7_336 = mbgen::fms(p_tie_rod_left_to_z, work.R_carrier_left_z_z, work.s7_325);
  work.s7_337 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_z_x, s7_336);
  const double s7_338 = mbgen::fma(work.s7_178, work.s7_330, work.a_bell_crank_z);
  work.s7_339 = 1.1666666666666667*mbgen::fnma(work.s7_179, work.s7_329, s7_338);
  const double s7_340 = mbgen::fma(work.s7_176, work.s7_329, work.a_bell_crank_x);
  work.s7_341 = 1.1666666666666667*mbgen::fma(work.s7_175, work.s7_330, s7_340);
  const double s7_342 = mbgen::fnma(work.s7_174, work.s7_329, work.a_bell_crank_y);
  work.s7_343 = 1.1666666666666667*mbgen::fnma(work.s7_177, work.s7_330, s7_342);
  const double s7_344 = mbgen::fma(work.s7_61, work.s7_333, work.a_carrier_left_aux1_y);
  const double s7_345 = mbgen::fma(work.s7_65, work.s7_337, s7_344);
  const double s7_346 = 1.1666666666666667*mbgen::fnma(work.s7_58, work.s7_335, s7_345);
  const double s7_347 = mbgen::fma(work.s7_64, work.s7_335, work.a_carrier_left_aux1_x);
  const double s7_348 = mbgen::fma(work.s7_60, work.s7_337, s7_347);
  const double s7_349 = 1.1666666666666667*mbgen::fnma(work.s7_57, work.s7_333, s7_348);
  // tie_rod_right
  work.s7_350 = mbgen::fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_328);
  work.s7_351 = p_tie_rod_right_to_y*work.s1_38;
  work.s7_352 = mbgen::fnma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s7_327);
  const double s7_353 = mbgen::fms(p_tie_rod_right_to_z, work.R_carrier_right_x_z, work.s7_351);
  work.s7_354 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_x_x, s7_353);
  work.s7_355 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s7_356 = mbgen::fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, work.s7_355);
  work.s7_357 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_y_x, s7_356);
  work.s7_358 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s7_359 = mbgen::fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, work.s7_358);
  work.s7_360 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_z_x, s7_359);
  const double s7_361 = mbgen::fma(work.s7_174, work.s7_352, work.a_bell_crank_y);
  const double s7_362 = 1.1666666666666667*mbgen::fma(work.s7_177, work.s7_350, s7_361);
  const double s7_363 = mbgen::fma(work.s7_179, work.s7_352, work.a_bell_crank_z);
  const double s7_364 = 1.1666666666666667*mbgen::fnma(work.s7_178, work.s7_350, s7_363);
  const double s7_365 = mbgen::fnma(work.s7_176, work.s7_352, work.a_bell_crank_x);
  const double s7_366 = 1.1666666666666667*mbgen::fnma(work.s7_175, work.s7_350, s7_365);
  const double s7_367 = mbgen::fma(work.s7_134, work.s7_357, work.a_carrier_right_aux1_x);
  const double s7_368 = mbgen::fma(work.s7_130, work.s7_360, s7_367);
  const double s7_369 = 1.1666666666666667*mbgen::fnma(work.s7_127, work.s7_354, s7_368);
  const double s7_370 = mbgen::fma(work.s7_131, work.s7_354, work.a_carrier_right_aux1_y);
  const double s7_371 = mbgen::fma(work.s7_135, work.s7_360, s7_370);
  const double s7_372 = 1.1666666666666667*mbgen::fnma(work.s7_128, work.s7_357, s7_371);
  // long_rod_left
  const double s1_57 = work.sines[18];
  const double s7_373 = p_long_rod_left_to_x*s1_57;
  const double s7_374 = mbgen::fma((-p_long_rod_left_to_z), work.R_rear_axle_z_z, s7_373);
  const double s7_375 = (-p_long_rod_left_from_x)*work.s7_20;
  const double s7_376 = mbgen::fma((-p_long_rod_left_from_z), work.s7_17, s7_375);
  work.s7_377 = mbgen::fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_374);
  const double s7_378 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_379 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_x_z, s7_378);
  work.s7_380 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_379);
  const double s7_381 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_382 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_y_z, s7_381);
  work.s7_383 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_382);
  const double s7_384 = (-p_long_rod_left_from_z)*work.s7_14;
  const double s7_385 = mbgen::fnma((-p_long_rod_left_from_x), work.s7_22, s7_384);
  const double s7_386 = work.a_chassis_z + s7_385;
  const double s7_387 = 3.0*mbgen::fma(p_long_rod_left_from_y, work.s7_18, s7_386);
  const double s7_388 = (-p_long_rod_left_from_x)*work.s7_15;
  const double s7_389 = mbgen::fnma((-p_long_rod_left_from_z), work.s7_19, s7_388);
  const double s7_390 = work.a_chassis_x + s7_389;
  const double s7_391 = 3.0*mbgen::fma(p_long_rod_left_from_y, work.s7_21, s7_390);
  const double s7_392 = mbgen::fnma(p_long_rod_left_from_y, work.s7_16, work.a_chassis_y);
  const double s7_393 = 3.0*(s7_392 - s7_376);
  // diag_rod_left
  const double s7_394 = (-p_diag_rod_left_from_x)*work.s7_20;
  const double s7_395 = mbgen::fma((-p_diag_rod_left_from_z), work.s7_17, s7_394);
  const double s7_396 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  work.s7_397 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s7_396);
  const double s7_398 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  work.s7_399 = mbgen::fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_398);
  const double s7_400 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  work.s7_401 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_400);
  const double s7_402 = (-p_diag_rod_left_from_z)*work.s7_14;
  const double s7_403 = mbgen::fnma((-p_diag_rod_left_from_x), work.s7_22, s7_402);
  const double s7_404 = 2.6666666666666665*(work.s7_30 + s7_403);
  const double s7_405 = (-p_diag_rod_left_from_x)*work.s7_15;
  const double s7_406 = mbgen::fnma((-p_diag_rod_left_from_z), work.s7_19, s7_405);
  const double s7_407 = 2.6666666666666665*(work.s7_25 + s7_406);
  const double s7_408 = mbgen::fnma(p_lower_arm_left_y, work.s7_16, work.a_chassis_y) - s7_395;
  const double s7_409 = 2.6666666666666665*s7_408;
  // arb_link_rear_left
  const double R_arb_rear_left_x_z = work.sines[20];
  work.s7_410 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_z;
  const double s7_411 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_y_x;
  const double s7_412 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_y_z, s7_411);
  const double s7_413 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_x_x;
  const double s7_414 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_x_z, s7_413);
  const double R_arb_rear_left_x_x = work.cosines[20];
  work.s7_415 = p_arb_link_rear_left_from_x*R_arb_rear_left_x_x;
  const double s7_416 = (-p_arb_link_rear_left_to_x)*s1_57;
  const double s7_417 = mbgen::fnma((-p_arb_link_rear_left_to_z), work.R_rear_axle_z_z, s7_416);
  work.s7_418 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s7_417);
  work.s7_419 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_414);
  work.s7_420 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_412);
  const double s7_421 = mbgen::fma(p_arb_link_rear_left_from_y, s7_236, a_arb_rear_left_z);
  const double s7_422 = mbgen::fma(s7_232, work.s7_415, mbgen::fma(s7_233, work.s7_410, s7_421));
  const double s7_423 = 0.3333333333333333*s7_422;
  const double s7_424 = mbgen::fma(p_arb_link_rear_left_from_y, s7_237, a_arb_rear_left_x);
  const double s7_425 = mbgen::fnma(s7_231, work.s7_410, s7_424);
  const double s7_426 = 0.3333333333333333*mbgen::fnma(s7_234, work.s7_415, s7_425);
  const double s7_427 = mbgen::fnma(p_arb_link_rear_left_from_y, work.s7_16, a_arb_rear_left_y);
  const double s7_428 = mbgen::fma(s7_235, work.s7_415, s7_427);
  const double s7_429 = 0.3333333333333333*mbgen::fnma(s7_238, work.s7_410, s7_428);
  const double s7_430 = mbgen::fma(s7_210, work.s7_420, work.a_rear_axle_aux3_z);
  const double s7_431 = mbgen::fma(s7_214, work.s7_419, s7_430);
  const double s7_432 = 0.3333333333333333*mbgen::fnma(s7_207, work.s7_418, s7_431);
  const double s7_433 = mbgen::fma(s7_215, work.s7_420, work.a_rear_axle_aux3_x);
  const double s7_434 = mbgen::fma(s7_211, work.s7_418, s7_433);
  const double s7_435 = 0.3333333333333333*mbgen::fnma(s7_208, work.s7_419, s7_434);
  // long_rod_right
  work.s7_436 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_374);
  work.s7_437 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_379);
  work.s7_438 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_382);
  const double s7_439 = mbgen::fma(p_long_rod_left_from_y, work.s7_16, work.a_chassis_y);
  const double s7_440 = 3.0*(s7_439 - s7_376);
  const double s7_441 = 3.0*mbgen::fnma(p_long_rod_left_from_y, work.s7_18, s7_386);
  const double s7_442 = 3.0*mbgen::fnma(p_long_rod_left_from_y, work.s7_21, s7_390);
  // diag_rod_right
  work.s7_443 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s7_396);
  work.s7_444 = mbgen::fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_398);
  work.s7_445 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_400);
  const double s7_446 = mbgen::fma(p_lower_arm_left_y, work.s7_16, work.a_chassis_y) - s7_395;
  const double s7_447 = 2.6666666666666665*s7_446;
  const double s7_448 = mbgen::fnma(p_lower_arm_left_y, work.s7_18, work.a_chassis_z + s7_403);
  const double s7_449 = 2.6666666666666665*s7_448;
  const double s7_450 = mbgen::fnma(p_lower_arm_left_y, work.s7_21, work.a_chassis_x + s7_406);
  const double s7_451 = 2.6666666666666665*s7_450;
  // arb_link_rear_right
  work.s7_452 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_412);
  work.s7_453 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_414);
  const double R_arb_rear_right_x_z = work.sines[21];
  work.s7_454 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_z;
  work.s7_455 = mbgen::fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s7_417);
  const double R_arb_rear_right_x_x = work.cosines[21];
  work.s7_456 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_x;
  const double s7_457 = mbgen::fma(s7_208, work.s7_453, work.a_rear_axle_aux3_x);
  const double s7_458 = mbgen::fma(s7_211, work.s7_455, s7_457);
  const double s7_459 = 0.3333333333333333*mbgen::fnma(s7_215, work.s7_452, s7_458);
  const double s7_460 = mbgen::fnma(s7_210, work.s7_452, work.a_rear_axle_aux3_z);
  const double s7_461 = mbgen::fnma(s7_207, work.s7_455, s7_460);
  const double s7_462 = 0.3333333333333333*mbgen::fnma(s7_214, work.s7_453, s7_461);
  const double s7_463 = mbgen::fma(p_arb_link_rear_left_from_y, work.s7_16, a_arb_rear_right_y);
  const double s7_464 = mbgen::fma(s7_251, work.s7_456, s7_463);
  const double s7_465 = 0.3333333333333333*mbgen::fnma(s7_254, work.s7_454, s7_464);
  const double s7_466 = mbgen::fma(s7_249, work.s7_454, a_arb_rear_right_z);
  const double s7_467 = mbgen::fma(s7_248, work.s7_456, s7_466);
  const double s7_468 = mbgen::fnma((-p_arb_link_rear_right_from_y), s7_252, s7_467);
  const double s7_469 = 0.3333333333333333*s7_468;
  const double s7_470 = mbgen::fnma((-p_arb_link_rear_right_from_y), s7_253, a_arb_rear_right_x);
  const double s7_471 = mbgen::fnma(s7_247, work.s7_454, s7_470);
  const double s7_472 = 0.3333333333333333*mbgen::fnma(s7_250, work.s7_456, s7_471);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_473 = c_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s7_474 = c_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s7_475 = mbgen::fnma((-c_arb_rear_right_y), s7_253, a_arb_rear_right_x);
  const double s7_476 = mbgen::fnma(s7_250, s7_474, mbgen::fnma(s7_247, s7_473, s7_475));
  const double s7_477 = mbgen::fma(s7_249, s7_473, a_arb_rear_right_z);
  const double s7_478 = mbgen::fma(s7_248, s7_474, s7_477);
  const double s7_479 = R_arb_rear_right_x_x*work.w_chassis_x;
  const double s7_480 = mbgen::fnma(R_arb_rear_right_x_z, work.w_chassis_z, s7_479);
  const double s7_481 = I_arb_rear_right_xy*work.w_arb_rear_right_y;
  const double s7_482 = R_arb_rear_right_x_x*alpha_arb_rear_right_x;
  const double s7_483 = R_arb_rear_right_x_z*work.w_chassis_x;
  const double s7_484 = mbgen::fma(R_arb_rear_right_x_x, work.w_chassis_z, s7_483);
  const double s7_485 = mbgen::fnma(R_arb_rear_right_x_z, alpha_arb_rear_right_z, s7_482);
  const double s7_486 = I_arb_rear_right_yy*alpha_arb_rear_right_y;
  const double s7_487 = mbgen::fma(I_arb_rear_right_xx, s7_480, s7_481);
  const double s7_488 = mbgen::fma(I_arb_rear_right_xy, s7_485, s7_486);
  const double s7_489 = mbgen::fma(s7_487, s7_484, s7_488);
  const double s7_490 = mbgen::fnma(s7_480, I_arb_rear_right_zz*s7_484, s7_489);
  const double s7_491 = m_arb_rear_right*mbgen::fnma((-c_arb_rear_right_y), s7_252, s7_478);
  const double s7_492 = mbgen::fnma(s7_473, m_arb_rear_right*s7_476, s7_490);
  const double s7_493 = mbgen::fnma(work.s7_454, s7_459, mbgen::fnma(s7_474, s7_491, s7_492));
  const double n_arb_rear_right_y = mbgen::fnma(work.s7_456, s7_462, s7_493);
  result.missing[21] = tau[Coordinate::arb_rear_right] - n_arb_rear_right_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double f_wheel_rear_right_x = m_wheel_rear_right*a_wheel_rear_right_x;
  const double f_wheel_rear_right_y = m_wheel_rear_right*a_wheel_rear_right_y;
  const double f_wheel_rear_right_z = m_wheel_rear_right*a_wheel_rear_right_z;
  const double s7_494 = work.R_rear_axle_y_y*alpha_wheel_rear_right_y;
  const double s7_495 = mbgen::fma(work.R_rear_axle_z_y, alpha_wheel_rear_right_z, s7_494);
  const double s7_496 = work.R_rear_axle_y_z*work.w_wheel_rear_right_y;
  const double s7_497 = mbgen::fma(work.R_rear_axle_z_z, work.w_wheel_rear_right_z, s7_496);
  const double s7_498 = mbgen::fma(work.R_rear_axle_x_z, work.w_wheel_rear_right_x, s7_497);
  const double s7_499 = work.R_rear_axle_aux5_y_x*work.w_wheel_rear_right_y;
  const double s7_500 = mbgen::fma(work.R_rear_axle_aux5_x_x, work.w_wheel_rear_right_x, s7_499);
  const double s7_501 = mbgen::fnma(s1_57, work.w_wheel_rear_right_z, s7_500);
  const double s7_502 = I_wheel_rear_right_xx*s7_501;
  const double s7_503 = I_wheel_rear_right_zz*s7_498;
  const double s7_504 = mbgen::fma(work.R_rear_axle_x_y, alpha_wheel_rear_right_x, s7_495);
  const double s7_505 = mbgen::fma(s7_498, s7_502, I_wheel_rear_right_yy*s7_504);
  const double s7_506 = mbgen::fnma(s7_501, s7_503, s7_505);
  const double s7_507 = work.R_rear_axle_aux5_y_x*alpha_wheel_rear_right_y;
  const double s7_508 = mbgen::fma(work.R_rear_axle_aux5_x_x, alpha_wheel_rear_right_x, s7_507);
  const double s7_509 = work.R_rear_axle_y_y*work.w_wheel_rear_right_y;
  const double s7_510 = mbgen::fma(work.R_rear_axle_z_y, work.w_wheel_rear_right_z, s7_509);
  const double s7_511 = mbgen::fma(work.R_rear_axle_x_y, work.w_wheel_rear_right_x, s7_510);
  const double s7_512 = I_wheel_rear_right_yy*s7_511;
  const double s7_513 = mbgen::fnma(s1_57, alpha_wheel_rear_right_z, s7_508);
  const double s7_514 = mbgen::fma(s7_503, s7_511, I_wheel_rear_right_xx*s7_513);
  const double s7_515 = mbgen::fnma(s7_498, s7_512, s7_514);
  const double s7_516 = work.R_rear_axle_y_z*alpha_wheel_rear_right_y;
  const double s7_517 = mbgen::fma(work.R_rear_axle_z_z, alpha_wheel_rear_right_z, s7_516);
  const double s7_518 = mbgen::fma(work.R_rear_axle_x_z, alpha_wheel_rear_right_x, s7_517);
  const double s7_519 = mbgen::fma(s7_501, s7_512, I_wheel_rear_right_zz*s7_518);
  const double s7_520 = mbgen::fnma(s7_502, s7_511, s7_519);
  const double s7_521 = work.R_rear_axle_x_y*s7_506;
  const double s7_522 = mbgen::fma(work.R_rear_axle_aux5_x_x, s7_515, s7_521);
  const double n_wheel_rear_right_x = mbgen::fma(work.R_rear_axle_x_z, s7_520, s7_522);
  const double s7_523 = work.R_rear_axle_y_y*s7_506;
  const double s7_524 = mbgen::fma(work.R_rear_axle_aux5_y_x, s7_515, s7_523);
  const double n_wheel_rear_right_y = mbgen::fma(work.R_rear_axle_y_z, s7_520, s7_524);
  const double s7_525 = mbgen::fma(work.R_rear_axle_z_z, s7_520, work.R_rear_axle_z_y*s7_506);
  const double n_wheel_rear_right_z = mbgen::fnma(s1_57, s7_515, s7_525);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s7_526 = c_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_527 = c_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s7_528 = mbgen::fma(c_arb_rear_left_y, s7_237, a_arb_rear_left_x);
  const double s7_529 = mbgen::fnma(s7_234, s7_527, mbgen::fnma(s7_231, s7_526, s7_528));
  const double s7_530 = mbgen::fma(c_arb_rear_left_y, s7_236, a_arb_rear_left_z);
  const double s7_531 = mbgen::fma(s7_232, s7_527, mbgen::fma(s7_233, s7_526, s7_530));
  const double s7_532 = R_arb_rear_left_x_x*work.w_chassis_x;
  const double s7_533 = mbgen::fnma(R_arb_rear_left_x_z, work.w_chassis_z, s7_532);
  const double s7_534 = I_arb_rear_left_xx*s7_533;
  const double s7_535 = R_arb_rear_left_x_x*alpha_arb_rear_left_x;
  const double s7_536 = R_arb_rear_left_x_z*work.w_chassis_x;
  const double s7_537 = mbgen::fma(R_arb_rear_left_x_x, work.w_chassis_z, s7_536);
  const double s7_538 = mbgen::fnma(R_arb_rear_left_x_z, alpha_arb_rear_left_z, s7_535);
  const double s7_539 = I_arb_rear_left_yy*alpha_arb_rear_left_y;
  const double s7_540 = mbgen::fnma((-I_arb_rear_left_xy), work.w_arb_rear_left_y, s7_534);
  const double s7_541 = mbgen::fnma((-I_arb_rear_left_xy), s7_538, s7_539);
  const double s7_542 = mbgen::fma(s7_540, s7_537, s7_541);
  const double s7_543 = mbgen::fnma(s7_533, I_arb_rear_left_zz*s7_537, s7_542);
  const double s7_544 = mbgen::fnma(s7_526, m_arb_rear_left*s7_529, s7_543);
  const double s7_545 = mbgen::fnma(s7_527, m_arb_rear_left*s7_531, s7_544);
  const double s7_546 = mbgen::fnma(work.s7_410, s7_435, s7_545);
  const double n_arb_rear_left_y = mbgen::fnma(work.s7_415, s7_432, s7_546);
  result.missing[20] = tau[Coordinate::arb_rear_left] - n_arb_rear_left_y;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double f_wheel_rear_left_x = m_wheel_rear_left*a_wheel_rear_left_x;
  const double f_wheel_rear_left_y = m_wheel_rear_left*a_wheel_rear_left_y;
  const double f_wheel_rear_left_z = m_wheel_rear_left*a_wheel_rear_left_z;
  const double s7_547 = work.R_rear_axle_y_y*alpha_wheel_rear_left_y;
  const double s7_548 = mbgen::fma(work.R_rear_axle_z_y, alpha_wheel_rear_left_z, s7_547);
  const double s7_549 = work.R_rear_axle_y_z*work.w_wheel_rear_left_y;
  const double s7_550 = mbgen::fma(work.R_rear_axle_z_z, work.w_wheel_rear_left_z, s7_549);
  const double s7_551 = mbgen::fma(work.R_rear_axle_x_z, work.w_wheel_rear_left_x, s7_550);
  const double s7_552 = work.R_rear_axle_aux5_y_x*work.w_wheel_rear_left_y;
  const double s7_553 = mbgen::fma(work.R_rear_axle_aux5_x_x, work.w_wheel_rear_left_x, s7_552);
  const double s7_554 = mbgen::fnma(s1_57, work.w_wheel_rear_left_z, s7_553);
  const double s7_555 = I_wheel_rear_left_xx*s7_554;
  const double s7_556 = I_wheel_rear_left_zz*s7_551;
  const double s7_557 = mbgen::fma(work.R_rear_axle_x_y, alpha_wheel_rear_left_x, s7_548);
  const double s7_558 = mbgen::fma(s7_551, s7_555, I_wheel_rear_left_yy*s7_557);
  const double s7_559 = mbgen::fnma(s7_554, s7_556, s7_558);
  const double s7_560 = work.R_rear_axle_aux5_y_x*alpha_wheel_rear_left_y;
  const double s7_561 = mbgen::fma(work.R_rear_axle_aux5_x_x, alpha_wheel_rear_left_x, s7_560);
  const double s7_562 = work.R_rear_axle_y_y*work.w_wheel_rear_left_y;
  const double s7_563 = mbgen::fma(work.R_rear_axle_z_y, work.w_wheel_rear_left_z, s7_562);
  const double s7_564 = mbgen::fma(work.R_rear_axle_x_y, work.w_wheel_rear_left_x, s7_563);
  const double s7_565 = I_wheel_rear_left_yy*s7_564;
  const double s7_566 = I_wheel_rear_left_xx*mbgen::fnma(s1_57, alpha_wheel_rear_left_z, s7_561);
  const double s7_567 = mbgen::fnma(s7_551, s7_565, mbgen::fma(s7_556, s7_564, s7_566));
  const double s7_568 = work.R_rear_axle_y_z*alpha_wheel_rear_left_y;
  const double s7_569 = mbgen::fma(work.R_rear_axle_z_z, alpha_wheel_rear_left_z, s7_568);
  const double s7_570 = mbgen::fma(work.R_rear_axle_x_z, alpha_wheel_rear_left_x, s7_569);
  const double s7_571 = mbgen::fma(s7_554, s7_565, I_wheel_rear_left_zz*s7_570);
  const double s7_572 = mbgen::fnma(s7_555, s7_564, s7_571);
  const double s7_573 = work.R_rear_axle_x_y*s7_559;
  const double s7_574 = mbgen::fma(work.R_rear_axle_aux5_x_x, s7_567, s7_573);
  const double n_wheel_rear_left_x = mbgen::fma(work.R_rear_axle_x_z, s7_572, s7_574);
  const double s7_575 = work.R_rear_axle_y_y*s7_559;
  const double s7_576 = mbgen::fma(work.R_rear_axle_aux5_y_x, s7_567, s7_575);
  const double n_wheel_rear_left_y = mbgen::fma(work.R_rear_axle_y_z, s7_572, s7_576);
  const double s7_577 = mbgen::fma(work.R_rear_axle_z_z, s7_572, work.R_rear_axle_z_y*s7_559);
  const double n_wheel_rear_left_z = mbgen::fnma(s1_57, s7_567, s7_577);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_578 = c_rear_axle_x*work.R_rear_axle_aux5_y_x;
  const double s7_579 = mbgen::fma(c_rear_axle_z, work.R_rear_axle_y_z, s7_578);
  const double s7_580 = mbgen::fnma(c_rear_axle_x, s1_57, c_rear_axle_z*work.R_rear_axle_z_z);
  const double s7_581 = c_rear_axle_x*work.R_rear_axle_aux5_x_x;
  const double s7_582 = mbgen::fma(c_rear_axle_z, work.R_rear_axle_x_z, s7_581);
  const double s7_583 = mbgen::fma(s7_215, s7_579, work.a_rear_axle_aux3_x);
  const double s7_584 = mbgen::fnma(s7_208, s7_582, mbgen::fma(s7_211, s7_580, s7_583));
  const double s7_585 = m_rear_axle*s7_584;
  const double f_rear_axle_x = s7_407 + (s7_391 + (s7_426 + (s7_442 + (s7_451 + (s7_472 +
      s7_585)))));
  const double s7_586 = mbgen::fma(s7_212, s7_582, work.a_rear_axle_aux3_y);
  const double s7_587 = mbgen::fnma(s7_209, s7_579, mbgen::fma(s7_213, s7_580, s7_586));
  const double s7_588 = m_rear_axle*s7_587;
  const double f_rear_axle_y = s7_409 + (s7_393 + (s7_429 + (s7_440 + (s7_447 + (s7_465 +
      s7_588)))));
  const double s7_589 = mbgen::fma(s7_210, s7_579, work.a_rear_axle_aux3_z);
  const double s7_590 = mbgen::fnma(s7_207, s7_580, mbgen::fma(s7_214, s7_582, s7_589));
  const double s7_591 = m_rear_axle*s7_590;
  const double f_rear_axle_z = s7_404 + (s7_387 + (s7_423 + (s7_441 + (s7_449 + (s7_469 +
      s7_591)))));
  const double s7_592 = work.R_rear_axle_y_y*work.alpha_rear_axle_y;
  const double s7_593 = mbgen::fma(work.R_rear_axle_z_y, work.alpha_rear_axle_z, s7_592);
  const double s7_594 = work.R_rear_axle_y_z*work.w_rear_axle_y;
  const double s7_595 = mbgen::fma(work.R_rear_axle_z_z, work.w_rear_axle_z, s7_594);
  const double s7_596 = mbgen::fma(work.R_rear_axle_x_z, work.w_rear_axle_x, s7_595);
  const double s7_597 = work.R_rear_axle_aux5_y_x*work.w_rear_axle_y;
  const double s7_598 = mbgen::fma(work.R_rear_axle_aux5_x_x, work.w_rear_axle_x, s7_597);
  const double s7_599 = mbgen::fnma(s1_57, work.w_rear_axle_z, s7_598);
  const double s7_600 = mbgen::fnma((-I_rear_axle_xz), s7_596, I_rear_axle_xx*s7_599);
  const double s7_601 = mbgen::fnma((-I_rear_axle_xz), s7_599, I_rear_axle_zz*s7_596);
  const double s7_602 = mbgen::fma(work.R_rear_axle_x_y, work.alpha_rear_axle_x, s7_593);
  const double s7_603 = mbgen::fma(s7_596, s7_600, I_rear_axle_yy*s7_602);
  const double s7_604 = mbgen::fnma(s7_599, s7_601, s7_603);
  const double s7_605 = work.R_rear_axle_aux5_y_x*work.alpha_rear_axle_y;
  const double s7_606 = mbgen::fma(work.R_rear_axle_aux5_x_x, work.alpha_rear_axle_x, s7_605);
  const double s7_607 = mbgen::fnma(s1_57, work.alpha_rear_axle_z, s7_606);
  const double s7_608 = work.R_rear_axle_y_z*work.alpha_rear_axle_y;
  const double s7_609 = mbgen::fma(work.R_rear_axle_z_z, work.alpha_rear_axle_z, s7_608);
  const double s7_610 = mbgen::fma(work.R_rear_axle_x_z, work.alpha_rear_axle_x, s7_609);
  const double s7_611 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s7_612 = mbgen::fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s7_611);
  const double s7_613 = mbgen::fma(work.R_rear_axle_x_y, work.w_rear_axle_x, s7_612);
  const double s7_614 = I_rear_axle_yy*s7_613;
  const double s7_615 = mbgen::fnma((-I_rear_axle_xz), s7_610, I_rear_axle_xx*s7_607);
  const double s7_616 = mbgen::fnma(s7_596, s7_614, mbgen::fma(s7_601, s7_613, s7_615));
  const double s7_617 = mbgen::fnma((-I_rear_axle_xz), s7_607, I_rear_axle_zz*s7_610);
  const double s7_618 = mbgen::fnma(s7_600, s7_613, mbgen::fma(s7_599, s7_614, s7_617));
  const double s7_619 = mbgen::fnma(s7_580, s7_588, s7_579*s7_591);
  const double s7_620 = mbgen::fma(work.R_rear_axle_x_y, s7_604, s7_619);
  const double s7_621 = mbgen::fma(work.R_rear_axle_aux5_x_x, s7_616, s7_620);
  const double s7_622 = mbgen::fma(work.R_rear_axle_x_z, s7_618, s7_621);
  const double s7_623 = mbgen::fnma(work.s7_377, s7_393, s7_622);
  const double s7_624 = mbgen::fma(work.s7_383, s7_387, s7_623);
  const double s7_625 = mbgen::fnma(work.s7_397, s7_409, s7_624);
  const double s7_626 = mbgen::fma(work.s7_401, s7_404, s7_625);
  const double s7_627 = mbgen::fnma(work.s7_418, s7_429, s7_626);
  const double s7_628 = mbgen::fma(work.s7_438, s7_441, mbgen::fma(work.s7_420, s7_423, s7_627));
  const double s7_629 = mbgen::fma(work.s7_436, s7_440, s7_628);
  const double s7_630 = mbgen::fnma(work.s7_443, s7_447, s7_629);
  const double s7_631 = mbgen::fma(work.s7_445, s7_449, s7_630);
  const double s7_632 = mbgen::fnma(work.s7_455, s7_465, s7_631);
  const double n_rear_axle_x = mbgen::fnma(work.s7_452, s7_469, s7_632);
  const double s7_633 = mbgen::fnma(s7_582, s7_591, s7_580*s7_585);
  const double s7_634 = mbgen::fma(work.R_rear_axle_y_y, s7_604, s7_633);
  const double s7_635 = mbgen::fma(work.R_rear_axle_aux5_y_x, s7_616, s7_634);
  const double s7_636 = mbgen::fma(work.R_rear_axle_y_z, s7_618, s7_635);
  const double s7_637 = mbgen::fnma(work.s7_380, s7_387, s7_636);
  const double s7_638 = mbgen::fma(work.s7_377, s7_391, s7_637);
  const double s7_639 = mbgen::fnma(work.s7_399, s7_404, s7_638);
  const double s7_640 = mbgen::fma(work.s7_397, s7_407, s7_639);
  const double s7_641 = mbgen::fnma(work.s7_419, s7_423, s7_640);
  const double s7_642 = mbgen::fma(work.s7_418, s7_426, s7_641);
  const double s7_643 = mbgen::fnma(work.s7_437, s7_441, s7_642);
  const double s7_644 = mbgen::fnma(work.s7_436, s7_442, s7_643);
  const double s7_645 = mbgen::fnma(work.s7_444, s7_449, s7_644);
  const double s7_646 = mbgen::fma(work.s7_455, s7_472, mbgen::fma(work.s7_443, s7_451, s7_645));
  const double n_rear_axle_y = mbgen::fma(work.s7_453, s7_469, s7_646);
  const double s7_647 = mbgen::fnma(s7_579, s7_585, s7_582*s7_588);
  const double s7_648 = mbgen::fma(work.R_rear_axle_z_y, s7_604, s7_647);
  const double s7_649 = mbgen::fma(work.R_rear_axle_z_z, s7_618, s7_648);
  const double s7_650 = mbgen::fnma(work.s7_383, s7_391, mbgen::fnma(s1_57, s7_616, s7_649));
  const double s7_651 = mbgen::fma(work.s7_380, s7_393, s7_650);
  const double s7_652 = mbgen::fnma(work.s7_401, s7_407, s7_651);
  const double s7_653 = mbgen::fma(work.s7_399, s7_409, s7_652);
  const double s7_654 = mbgen::fnma(work.s7_420, s7_426, s7_653);
  const double s7_655 = mbgen::fma(work.s7_419, s7_429, s7_654);
  const double s7_656 = mbgen::fnma(work.s7_438, s7_442, s7_655);
  const double s7_657 = mbgen::fma(work.s7_437, s7_440, s7_656);
  const double s7_658 = mbgen::fnma(work.s7_445, s7_451, s7_657);
  const double s7_659 = mbgen::fma(work.s7_444, s7_447, s7_658);
  const double s7_660 = mbgen::fnma(work.s7_453, s7_465, s7_659);
  const double n_rear_axle_z = mbgen::fma(work.s7_452, s7_472, s7_660);
  const double s7_661 = n_wheel_rear_left_y + (n_wheel_rear_right_y + n_rear_axle_y);
  const double s7_662 = f_wheel_rear_right_z - f_wheel_rear_left_z;
  const double s7_663 = f_wheel_rear_left_x - f_wheel_rear_right_x;
  work.s7_664 = mbgen::fma(work.s1_64, s7_663, mbgen::fma(work.s1_62, s7_662, s7_661));
  const double s7_665 = n_wheel_rear_left_x + (n_wheel_rear_right_x + n_rear_axle_x);
  const double s7_666 = f_wheel_rear_left_z - f_wheel_rear_right_z;
  const double s7_667 = f_wheel_rear_right_y - f_wheel_rear_left_y;
  work.s7_668 = mbgen::fma(work.s1_64, s7_667, mbgen::fma(work.s1_63, s7_666, s7_665));
  const double s7_669 = n_wheel_rear_left_z + (n_wheel_rear_right_z + n_rear_axle_z);
  const double s7_670 = f_wheel_rear_left_y - f_wheel_rear_right_y;
  const double s7_671 = f_wheel_rear_right_x - f_wheel_rear_left_x;
  work.s7_672 = mbgen::fma(work.s1_63, s7_671, mbgen::fma(work.s1_62, s7_670, s7_669));
  const double s7_673 = mbgen::fnma(work.R_rear_axle_aux5_y_x, work.s7_664,
      tau[Coordinate::rear_axle_rx]);
  const double s7_674 = mbgen::fnma(work.R_rear_axle_aux5_x_x, work.s7_668, s7_673);
  result.missing[19] = mbgen::fma(s1_57, work.s7_672, s7_674);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double s7_675 = mbgen::fnma(work.cosines[17], work.s7_664, tau[Coordinate::rear_axle_ry]);
  result.missing[18] = mbgen::fma(work.sines[17], work.s7_668, s7_675);
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  result.missing[17] = tau[Coordinate::rear_axle_rz] - work.s7_672;
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double s7_676 = tau[Coordinate::rear_axle_tz] - f_wheel_rear_right_z;
  work.Q_rear_axle_tz = s7_676 - f_wheel_rear_left_z - f_rear_axle_z;
  result.missing[16] = work.Q_rear_axle_tz;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double s7_677 = tau[Coordinate::rear_axle_ty] - f_wheel_rear_right_y;
  work.Q_rear_axle_ty = s7_677 - f_wheel_rear_left_y - f_rear_axle_y;
  result.missing[15] = work.Q_rear_axle_ty;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double s7_678 = tau[Coordinate::rear_axle_tx] - f_wheel_rear_right_x;
  work.Q_rear_axle_tx = s7_678 - f_wheel_rear_left_x - f_rear_axle_x;
  result.missing[14] = work.Q_rear_axle_tx;
  // bell_crank: bell_crank, revolute, chassis
  const double s7_679 = c_bell_crank_y*R_bell_crank_y_x;
  const double s7_680 = mbgen::fma((-c_bell_crank_x), R_bell_crank_x_x, s7_679);
  const double s7_681 = c_bell_crank_y*R_bell_crank_x_x;
  const double s7_682 = mbgen::fnma((-c_bell_crank_x), R_bell_crank_y_x, s7_681);
  const double s7_683 = mbgen::fma(work.s7_176, s7_680, work.a_bell_crank_x);
  const double s7_684 = mbgen::fnma(work.s7_174, s7_680, work.a_bell_crank_y);
  const double s7_685 = R_bell_crank_x_x*work.w_chassis_y;
  const double s7_686 = mbgen::fnma(R_bell_crank_y_x, work.w_chassis_x, s7_685);
  const double s7_687 = R_bell_crank_y_x*work.w_chassis_y;
  const double s7_688 = mbgen::fma(R_bell_crank_x_x, work.w_chassis_x, s7_687);
  const double s7_689 = mbgen::fnma((-I_bell_crank_xy), s7_688, I_bell_crank_yy*s7_686);
  const double s7_690 = mbgen::fma(s7_688, s7_689, I_bell_crank_zz*work.alpha_bell_crank_z);
  const double s7_691 = mbgen::fnma((-I_bell_crank_xy), s7_686, I_bell_crank_xx*s7_688);
  const double s7_692 = m_bell_crank*mbgen::fnma(work.s7_177, s7_682, s7_684);
  const double s7_693 = mbgen::fnma(s7_680, s7_692, mbgen::fnma(s7_686, s7_691, s7_690));
  const double s7_694 = m_bell_crank*mbgen::fma(work.s7_175, s7_682, s7_683);
  const double s7_695 = mbgen::fnma(work.s7_315, s7_324, mbgen::fnma(s7_682, s7_694, s7_693));
  const double s7_696 = mbgen::fnma(work.s7_330, s7_349, mbgen::fnma(s7_316, s7_318, s7_695));
  const double s7_697 = mbgen::fnma(work.s7_329, s7_346, s7_696);
  const double n_bell_crank_z = mbgen::fma(work.s7_350, s7_369, mbgen::fma(work.s7_352, s7_372,
      s7_697));
  result.missing[13] = tau[Coordinate::bell_crank] - n_bell_crank_z;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s7_698 = (-c_pitman_arm_z)*R_pitman_arm_x_z;
  const double s7_699 = (-c_pitman_arm_z)*R_pitman_arm_x_x;
  const double s7_700 = mbgen::fma(work.s7_168, s7_698, work.a_pitman_arm_x);
  const double s7_701 = mbgen::fma(work.s7_167, s7_699, work.a_pitman_arm_z);
  const double s7_702 = R_pitman_arm_x_x*work.w_chassis_x;
  const double s7_703 = mbgen::fnma(R_pitman_arm_x_z, work.w_chassis_z, s7_702);
  const double s7_704 = R_pitman_arm_x_z*work.w_chassis_x;
  const double s7_705 = mbgen::fma(R_pitman_arm_x_x, work.w_chassis_z, s7_704);
  const double s7_706 = I_pitman_arm_yy*work.alpha_pitman_arm_y;
  const double s7_707 = mbgen::fma(I_pitman_arm_xx*s7_703, s7_705, s7_706);
  const double s7_708 = m_pitman_arm*mbgen::fnma(work.s7_166, s7_698, s7_701);
  const double s7_709 = mbgen::fnma(s7_703, I_pitman_arm_zz*s7_705, s7_707);
  const double s7_710 = m_pitman_arm*mbgen::fnma(work.s7_165, s7_699, s7_700);
  const double s7_711 = mbgen::fnma(s7_699, s7_710, mbgen::fma(s7_698, s7_708, s7_709));
  const double s7_712 = mbgen::fnma(work.s7_314, s7_322, s7_711);
  const double n_pitman_arm_y = mbgen::fma(work.s7_313, s7_320, s7_712);
  work.Q_pitman_arm = tau[Coordinate::pitman_arm] - n_pitman_arm_y;
  result.missing[12] = work.Q_pitman_arm;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s7_713 = (-c_arb_front_right_x)*R_arb_front_right_x_z;
  const double s7_714 = mbgen::fma(c_arb_front_right_z, R_arb_front_right_x_x, s7_713);
  const double s7_715 = c_arb_front_right_z*R_arb_front_right_x_z;
  const double s7_716 = mbgen::fnma((-c_arb_front_right_x), R_arb_front_right_x_x, s7_715);
  const double s7_717 = mbgen::fma(work.s7_152, s7_714, work.a_arb_front_right_x);
  const double s7_718 = mbgen::fnma(work.s7_155, s7_716, s7_717);
  const double s7_719 = mbgen::fnma((-c_arb_front_right_y), work.s7_158, s7_718);
  const double s7_720 = mbgen::fma(work.s7_153, s7_716, work.a_arb_front_right_z);
  const double s7_721 = mbgen::fnma(work.s7_154, s7_714, s7_720);
  const double s7_722 = mbgen::fnma((-c_arb_front_right_y), work.s7_157, s7_721);
  const double s7_723 = R_arb_front_right_x_x*work.alpha_arb_front_right_x;
  const double s7_724 = R_arb_front_right_x_z*work.alpha_arb_front_right_x;
  const double s7_725 = R_arb_front_right_x_x*work.w_chassis_x;
  const double s7_726 = mbgen::fnma(R_arb_front_right_x_z, work.w_chassis_z, s7_725);
  const double s7_727 = R_arb_front_right_x_z*work.w_chassis_x;
  const double s7_728 = mbgen::fma(R_arb_front_right_x_x, work.w_chassis_z, s7_727);
  const double s7_729 = mbgen::fma(I_arb_front_right_xx, s7_726, I_arb_front_right_xz*s7_728);
  const double s7_730 = I_arb_front_right_yz*work.w_arb_front_right_y;
  const double s7_731 = mbgen::fma(I_arb_front_right_xz, s7_726, s7_730);
  const double s7_732 = mbgen::fma(R_arb_front_right_x_x, work.alpha_arb_front_right_z, s7_724);
  const double s7_733 = I_arb_front_right_yy*work.alpha_arb_front_right_y;
  const double s7_734 = mbgen::fnma(R_arb_front_right_x_z, work.alpha_arb_front_right_z, s7_723);
  const double s7_735 = mbgen::fma(I_arb_front_right_yz, s7_732, s7_733);
  const double s7_736 = mbgen::fnma((-I_arb_front_right_xy), work.w_arb_front_right_y, s7_729);
  const double s7_737 = mbgen::fnma((-I_arb_front_right_xy), s7_734, s7_735);
  const double s7_738 = mbgen::fma(I_arb_front_right_zz, s7_728, s7_731);
  const double s7_739 = mbgen::fnma(s7_726, s7_738, mbgen::fma(s7_728, s7_736, s7_737));
  const double s7_740 = mbgen::fma(s7_714, m_arb_front_right*s7_719, s7_739);
  const double s7_741 = mbgen::fnma(s7_716, m_arb_front_right*s7_722, s7_740);
  const double s7_742 = mbgen::fnma(work.s7_286, s7_309, s7_741);
  const double n_arb_front_right_y = mbgen::fma(work.s7_284, s7_312, s7_742);
  work.Q_arb_front_right = tau[Coordinate::arb_front_right] - n_arb_front_right_y;
  result.missing[11] = work.Q_arb_front_right;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_743 = (-c_upper_arm_right_z)*R_upper_arm_right_z_y;
  const double s7_744 = mbgen::fnma((-c_upper_arm_right_y), R_upper_arm_right_y_y, s7_743);
  const double s7_745 = (-c_upper_arm_right_y)*R_upper_arm_right_z_y;
  const double s7_746 = mbgen::fma((-c_upper_arm_right_z), R_upper_arm_right_y_y, s7_745);
  const double s7_747 = mbgen::fnma(work.s7_151, s7_744, work.a_upper_arm_right_y);
  const double f_upper_arm_right_y = m_upper_arm_right*mbgen::fnma(work.s7_149, s7_746, s7_747);
  const double s7_748 = mbgen::fma(work.s7_150, s7_746, work.a_upper_arm_right_z);
  const double f_upper_arm_right_z = m_upper_arm_right*mbgen::fma(work.s7_148, s7_744, s7_748);
  const double s7_749 = R_upper_arm_right_z_y*work.w_chassis_z;
  const double s7_750 = mbgen::fma(R_upper_arm_right_y_y, work.w_chassis_y, s7_749);
  const double s7_751 = R_upper_arm_right_y_y*work.w_chassis_z;
  const double s7_752 = mbgen::fnma(R_upper_arm_right_z_y, work.w_chassis_y, s7_751);
  const double s7_753 = I_upper_arm_right_xx*work.alpha_upper_arm_right_x;
  const double s7_754 = mbgen::fma(s7_750, I_upper_arm_right_zz*s7_752, s7_753);
  const double s7_755 = mbgen::fnma(s7_752, I_upper_arm_right_yy*s7_750, s7_754);
  const double s7_756 = mbgen::fma(s7_746, f_upper_arm_right_y, s7_755);
  const double n_upper_arm_right_x = mbgen::fma(s7_744, f_upper_arm_right_z, s7_756);
  work.Q_upper_arm_right = tau[Coordinate::upper_arm_right] - n_upper_arm_right_x;
  result.missing[10] = work.Q_upper_arm_right;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double f_wheel_front_right_x = m_wheel_front_right*work.a_wheel_front_right_x;
  const double f_wheel_front_right_y = m_wheel_front_right*work.a_wheel_front_right_y;
  const double f_wheel_front_right_z = m_wheel_front_right*work.a_wheel_front_right_z;
  const double s7_757 = work.R_carrier_right_y_z*work.alpha_wheel_front_right_y;
  const double s7_758 = mbgen::fma(work.R_carrier_right_x_z, work.alpha_wheel_front_right_x,
      s7_757);
  const double s7_759 = work.R_carrier_right_y_x*work.w_wheel_front_right_y;
  const double s7_760 = mbgen::fma(work.R_carrier_right_x_x, work.w_wheel_front_right_x, s7_759);
  const double s7_761 = mbgen::fma(work.R_carrier_right_z_x, work.w_wheel_front_right_z, s7_760);
  const double s7_762 = work.R_carrier_right_aux2_y_y*work.w_wheel_front_right_y;
  const double s7_763 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.w_wheel_front_right_z,
      s7_762);
  const double s7_764 = mbgen::fnma(work.s1_38, work.w_wheel_front_right_x, s7_763);
  const double s7_765 = I_wheel_front_right_yy*s7_764;
  const double s7_766 = I_wheel_front_right_xx*s7_761;
  const double s7_767 = mbgen::fma(work.R_carrier_right_z_z, work.alpha_wheel_front_right_z,
      s7_758);
  const double s7_768 = mbgen::fma(s7_761, s7_765, I_wheel_front_right_zz*s7_767);
  const double s7_769 = mbgen::fnma(s7_764, s7_766, s7_768);
  const double s7_770 = work.R_carrier_right_y_x*work.alpha_wheel_front_right_y;
  const double s7_771 = mbgen::fma(work.R_carrier_right_x_x, work.alpha_wheel_front_right_x,
      s7_770);
  const double s7_772 = work.R_carrier_right_y_z*work.w_wheel_front_right_y;
  const double s7_773 = mbgen::fma(work.R_carrier_right_x_z, work.w_wheel_front_right_x, s7_772);
  const double s7_774 = mbgen::fma(work.R_carrier_right_z_z, work.w_wheel_front_right_z, s7_773);
  const double s7_775 = I_wheel_front_right_zz*s7_774;
  const double s7_776 = mbgen::fma(work.R_carrier_right_z_x, work.alpha_wheel_front_right_z,
      s7_771);
  const double s7_777 = mbgen::fma(s7_764, s7_775, I_wheel_front_right_xx*s7_776);
  const double s7_778 = mbgen::fnma(s7_765, s7_774, s7_777);
  const double s7_779 = work.R_carrier_right_aux2_y_y*work.alpha_wheel_front_right_y;
  const double s7_780 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.alpha_wheel_front_right_z,
      s7_779);
  const double s7_781 = mbgen::fnma(work.s1_38, work.alpha_wheel_front_right_x, s7_780);
  const double s7_782 = mbgen::fma(s7_766, s7_774, I_wheel_front_right_yy*s7_781);
  const double s7_783 = mbgen::fnma(s7_761, s7_775, s7_782);
  const double s7_784 = work.R_carrier_right_x_z*s7_769;
  const double s7_785 = mbgen::fma(work.R_carrier_right_x_x, s7_778, s7_784);
  const double n_wheel_front_right_x = mbgen::fnma(work.s1_38, s7_783, s7_785);
  const double s7_786 = work.R_carrier_right_aux2_y_y*s7_783;
  const double s7_787 = mbgen::fma(work.R_carrier_right_y_x, s7_778, s7_786);
  const double n_wheel_front_right_y = mbgen::fma(work.R_carrier_right_y_z, s7_769, s7_787);
  const double s7_788 = work.R_carrier_right_aux2_z_y*s7_783;
  const double s7_789 = mbgen::fma(work.R_carrier_right_z_z, s7_769, s7_788);
  const double n_wheel_front_right_z = mbgen::fma(work.R_carrier_right_z_x, s7_778, s7_789);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_790 = c_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_791 = mbgen::fnma((-c_carrier_right_x), work.R_carrier_right_y_x, s7_790);
  const double s7_792 = mbgen::fnma((-c_carrier_right_y), work.R_carrier_right_aux2_y_y, s7_791);
  const double s7_793 = c_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_794 = mbgen::fnma((-c_carrier_right_x), work.R_carrier_right_z_x, s7_793);
  const double s7_795 = mbgen::fnma((-c_carrier_right_y), work.R_carrier_right_aux2_z_y, s7_794);
  const double s7_796 = (-c_carrier_right_y)*work.s1_38;
  const double s7_797 = mbgen::fma(c_carrier_right_z, work.R_carrier_right_x_z, s7_796);
  const double s7_798 = mbgen::fnma((-c_carrier_right_x), work.R_carrier_right_x_x, s7_797);
  const double s7_799 = mbgen::fma(work.s7_134, s7_792, work.a_carrier_right_aux1_x);
  const double s7_800 = mbgen::fma(work.s7_130, s7_795, s7_799);
  const double s7_801 = m_carrier_right*mbgen::fnma(work.s7_127, s7_798, s7_800);
  const double s7_802 = mbgen::fma(work.s7_131, s7_798, work.a_carrier_right_aux1_y);
  const double s7_803 = mbgen::fma(work.s7_135, s7_795, s7_802);
  const double s7_804 = m_carrier_right*mbgen::fnma(work.s7_128, s7_792, s7_803);
  const double f_carrier_right_y = s7_362 + (s7_298 + s7_804);
  const double s7_805 = mbgen::fma(work.s7_132, s7_792, work.a_carrier_right_aux1_z);
  const double s7_806 = mbgen::fma(work.s7_133, s7_798, s7_805);
  const double s7_807 = m_carrier_right*mbgen::fnma(work.s7_129, s7_795, s7_806);
  const double f_carrier_right_z = s7_364 + (s7_302 + s7_807);
  const double s7_808 = work.R_carrier_right_aux2_y_y*work.alpha_carrier_right_y;
  const double s7_809 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.alpha_carrier_right_z,
      s7_808);
  const double s7_810 = mbgen::fnma(work.s1_38, work.alpha_carrier_right_x, s7_809);
  const double s7_811 = work.R_carrier_right_y_z*work.alpha_carrier_right_y;
  const double s7_812 = mbgen::fma(work.R_carrier_right_x_z, work.alpha_carrier_right_x, s7_811);
  const double s7_813 = mbgen::fma(work.R_carrier_right_z_z, work.alpha_carrier_right_z, s7_812);
  const double s7_814 = work.R_carrier_right_y_x*work.alpha_carrier_right_y;
  const double s7_815 = mbgen::fma(work.R_carrier_right_x_x, work.alpha_carrier_right_x, s7_814);
  const double s7_816 = mbgen::fma(work.R_carrier_right_z_x, work.alpha_carrier_right_z, s7_815);
  const double s7_817 = work.R_carrier_right_y_x*work.w_carrier_right_y;
  const double s7_818 = mbgen::fma(work.R_carrier_right_x_x, work.w_carrier_right_x, s7_817);
  const double s7_819 = mbgen::fma(work.R_carrier_right_z_x, work.w_carrier_right_z, s7_818);
  const double s7_820 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_y;
  const double s7_821 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s7_820);
  const double s7_822 = mbgen::fnma(work.s1_38, work.w_carrier_right_x, s7_821);
  const double s7_823 = work.R_carrier_right_y_z*work.w_carrier_right_y;
  const double s7_824 = mbgen::fma(work.R_carrier_right_x_z, work.w_carrier_right_x, s7_823);
  const double s7_825 = mbgen::fma(work.R_carrier_right_z_z, work.w_carrier_right_z, s7_824);
  const double s7_826 = mbgen::fma(I_carrier_right_yz, s7_825, I_carrier_right_yy*s7_822);
  const double s7_827 = mbgen::fma(I_carrier_right_xy, s7_819, s7_826);
  const double s7_828 = mbgen::fma(I_carrier_right_xx, s7_819, I_carrier_right_xy*s7_822);
  const double s7_829 = mbgen::fnma((-I_carrier_right_xz), s7_825, s7_828);
  const double s7_830 = mbgen::fma(I_carrier_right_zz, s7_813, I_carrier_right_yz*s7_810);
  const double s7_831 = mbgen::fnma((-I_carrier_right_xz), s7_816, s7_830);
  const double s7_832 = mbgen::fnma(s7_822, s7_829, mbgen::fma(s7_819, s7_827, s7_831));
  const double s7_833 = mbgen::fma(I_carrier_right_zz, s7_825, I_carrier_right_yz*s7_822);
  const double s7_834 = mbgen::fnma((-I_carrier_right_xz), s7_819, s7_833);
  const double s7_835 = mbgen::fma(I_carrier_right_xx, s7_816, I_carrier_right_xy*s7_810);
  const double s7_836 = mbgen::fnma((-I_carrier_right_xz), s7_813, s7_835);
  const double s7_837 = mbgen::fnma(s7_825, s7_827, mbgen::fma(s7_822, s7_834, s7_836));
  const double s7_838 = mbgen::fma(I_carrier_right_yz, s7_813, I_carrier_right_yy*s7_810);
  const double s7_839 = mbgen::fma(I_carrier_right_xy, s7_816, s7_838);
  const double s7_840 = mbgen::fnma(s7_819, s7_834, mbgen::fma(s7_825, s7_829, s7_839));
  const double s7_841 = mbgen::fnma(s7_795, s7_804, s7_792*s7_807);
  const double s7_842 = mbgen::fma(work.R_carrier_right_x_z, s7_832, s7_841);
  const double s7_843 = mbgen::fma(work.R_carrier_right_x_x, s7_837, s7_842);
  const double s7_844 = mbgen::fnma(work.s1_38, s7_840, s7_843);
  const double s7_845 = mbgen::fnma(work.s7_295, s7_298, s7_844);
  const double s7_846 = mbgen::fma(work.s7_292, s7_302, s7_845);
  const double s7_847 = mbgen::fnma(work.s7_360, s7_362, s7_846);
  const double n_carrier_right_x = mbgen::fma(work.s7_357, s7_364, s7_847);
  const double s7_848 = mbgen::fnma(s7_798, s7_807, s7_795*s7_801);
  const double s7_849 = mbgen::fma(work.R_carrier_right_aux2_y_y, s7_840, s7_848);
  const double s7_850 = mbgen::fma(work.R_carrier_right_y_x, s7_837, s7_849);
  const double s7_851 = mbgen::fma(work.R_carrier_right_y_z, s7_832, s7_850);
  const double s7_852 = mbgen::fnma(work.s7_289, s7_302, s7_851);
  const double s7_853 = mbgen::fma(work.s7_295, s7_306, s7_852);
  const double s7_854 = mbgen::fnma(work.s7_354, s7_364, s7_853);
  const double n_carrier_right_y = mbgen::fma(work.s7_360, s7_366, s7_854);
  const double s7_855 = mbgen::fnma(s7_792, s7_801, s7_798*s7_804);
  const double s7_856 = mbgen::fma(work.R_carrier_right_aux2_z_y, s7_840, s7_855);
  const double s7_857 = mbgen::fma(work.R_carrier_right_z_z, s7_832, s7_856);
  const double s7_858 = mbgen::fma(work.R_carrier_right_z_x, s7_837, s7_857);
  const double s7_859 = mbgen::fnma(work.s7_292, s7_306, s7_858);
  const double s7_860 = mbgen::fma(work.s7_289, s7_298, s7_859);
  const double s7_861 = mbgen::fnma(work.s7_357, s7_366, s7_860);
  const double n_carrier_right_z = mbgen::fma(work.s7_354, s7_362, s7_861);
  const double s7_862 = n_wheel_front_right_y + n_carrier_right_y;
  const double s7_863 = mbgen::fma(work.s1_56, f_wheel_front_right_x, s7_862);
  work.s7_864 = mbgen::fnma(work.s1_52, f_wheel_front_right_z, s7_863);
  const double s7_865 = n_wheel_front_right_z + n_carrier_right_z;
  const double s7_866 = mbgen::fma(work.s1_52, f_wheel_front_right_y, s7_865);
  work.s7_867 = mbgen::fnma(work.s1_54, f_wheel_front_right_x, s7_866);
  const double s7_868 = n_wheel_front_right_x + n_carrier_right_x;
  const double s7_869 = mbgen::fma(work.s1_54, f_wheel_front_right_z, s7_868);
  work.s7_870 = mbgen::fnma(work.s1_56, f_wheel_front_right_y, s7_869);
  const double s7_871 = mbgen::fnma(work.R_carrier_right_aux2_y_y, work.s7_864,
      tau[Coordinate::carrier_right_ry]);
  const double s7_872 = mbgen::fnma(work.R_carrier_right_aux2_z_y, work.s7_867, s7_871);
  result.missing[9] = mbgen::fma(work.s1_38, work.s7_870, s7_872);
  const double s7_873 = f_wheel_front_right_z + f_carrier_right_z;
  const double s7_874 = f_wheel_front_right_y + f_carrier_right_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s7_875 = mbgen::fnma(work.R_carrier_right_aux1_y_x, work.s7_864,
      tau[Coordinate::carrier_right_rx]);
  const double s7_876 = mbgen::fnma(work.cosines[10], work.s7_870, s7_875);
  result.missing[8] = mbgen::fnma(work.R_carrier_right_aux1_z_x, work.s7_867, s7_876);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s7_877 = mbgen::fnma(R_lower_arm_right_y_y, work.s7_867,
      tau[Coordinate::carrier_right_rz]);
  result.missing[7] = mbgen::fma(R_lower_arm_right_z_y, work.s7_864, s7_877);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_878 = (-c_lower_arm_right_z)*R_lower_arm_right_z_y;
  const double s7_879 = mbgen::fnma((-c_lower_arm_right_y), R_lower_arm_right_y_y, s7_878);
  const double s7_880 = (-c_lower_arm_right_y)*R_lower_arm_right_z_y;
  const double s7_881 = mbgen::fma((-c_lower_arm_right_z), R_lower_arm_right_y_y, s7_880);
  const double s7_882 = mbgen::fnma(work.s7_104, s7_879, work.a_lower_arm_right_y);
  const double f_lower_arm_right_y = m_lower_arm_right*mbgen::fnma(work.s7_102, s7_881, s7_882);
  const double s7_883 = mbgen::fma(work.s7_103, s7_881, work.a_lower_arm_right_z);
  const double f_lower_arm_right_z = m_lower_arm_right*mbgen::fma(work.s7_101, s7_879, s7_883);
  const double s7_884 = R_lower_arm_right_z_y*work.w_chassis_z;
  const double s7_885 = mbgen::fma(R_lower_arm_right_y_y, work.w_chassis_y, s7_884);
  const double s7_886 = R_lower_arm_right_y_y*work.w_chassis_z;
  const double s7_887 = mbgen::fnma(R_lower_arm_right_z_y, work.w_chassis_y, s7_886);
  const double s7_888 = I_lower_arm_right_xx*work.alpha_lower_arm_right_x;
  const double s7_889 = mbgen::fma(s7_885, I_lower_arm_right_zz*s7_887, s7_888);
  const double s7_890 = mbgen::fnma(s7_887, I_lower_arm_right_yy*s7_885, s7_889);
  const double s7_891 = mbgen::fma(s7_881, f_lower_arm_right_y, s7_890);
  const double n_lower_arm_right_x = mbgen::fma(s7_879, f_lower_arm_right_z, s7_891);
  const double s7_892 = tau[Coordinate::lower_arm_right] - work.s7_870 - n_lower_arm_right_x;
  result.missing[6] = mbgen::fnma(work.s1_33, s7_873, mbgen::fnma(work.s1_35, s7_874, s7_892));
  // arb_front_left: arb_front_left, revolute, chassis
  const double s7_893 = (-c_arb_front_left_x)*R_arb_front_left_x_z;
  const double s7_894 = mbgen::fma(c_arb_front_left_z, R_arb_front_left_x_x, s7_893);
  const double s7_895 = c_arb_front_left_z*R_arb_front_left_x_z;
  const double s7_896 = mbgen::fnma((-c_arb_front_left_x), R_arb_front_left_x_x, s7_895);
  const double s7_897 = mbgen::fma(c_arb_front_left_y, work.s7_99, work.a_arb_front_left_x);
  const double s7_898 = mbgen::fnma(work.s7_96, s7_896, mbgen::fma(work.s7_93, s7_894, s7_897));
  const double s7_899 = mbgen::fma(c_arb_front_left_y, work.s7_98, work.a_arb_front_left_z);
  const double s7_900 = mbgen::fnma(work.s7_95, s7_894, mbgen::fma(work.s7_94, s7_896, s7_899));
  const double s7_901 = R_arb_front_left_x_x*work.alpha_arb_front_left_x;
  const double s7_902 = R_arb_front_left_x_z*work.alpha_arb_front_left_x;
  const double s7_903 = R_arb_front_left_x_x*work.w_chassis_x;
  const double s7_904 = mbgen::fnma(R_arb_front_left_x_z, work.w_chassis_z, s7_903);
  const double s7_905 = R_arb_front_left_x_z*work.w_chassis_x;
  const double s7_906 = mbgen::fma(R_arb_front_left_x_x, work.w_chassis_z, s7_905);
  const double s7_907 = I_arb_front_left_xy*work.w_arb_front_left_y;
  const double s7_908 = mbgen::fma(I_arb_front_left_xz, s7_906, s7_907);
  const double s7_909 = mbgen::fma(I_arb_front_left_zz, s7_906, I_arb_front_left_xz*s7_904);
  const double s7_910 = mbgen::fnma(R_arb_front_left_x_z, work.alpha_arb_front_left_z, s7_901);
  const double s7_911 = I_arb_front_left_yy*work.alpha_arb_front_left_y;
  const double s7_912 = mbgen::fma(R_arb_front_left_x_x, work.alpha_arb_front_left_z, s7_902);
  const double s7_913 = mbgen::fma(I_arb_front_left_xy, s7_910, s7_911);
  const double s7_914 = mbgen::fnma((-I_arb_front_left_yz), s7_912, s7_913);
  const double s7_915 = mbgen::fma(I_arb_front_left_xx, s7_904, s7_908);
  const double s7_916 = mbgen::fnma((-I_arb_front_left_yz), work.w_arb_front_left_y, s7_909);
  const double s7_917 = mbgen::fnma(s7_904, s7_916, mbgen::fma(s7_906, s7_915, s7_914));
  const double s7_918 = mbgen::fma(s7_894, m_arb_front_left*s7_898, s7_917);
  const double s7_919 = mbgen::fnma(s7_896, m_arb_front_left*s7_900, s7_918);
  const double s7_920 = mbgen::fnma(work.s7_258, s7_279, s7_919);
  const double n_arb_front_left_y = mbgen::fma(work.s7_256, s7_282, s7_920);
  work.Q_arb_front_left = tau[Coordinate::arb_front_left] - n_arb_front_left_y;
  result.missing[5] = work.Q_arb_front_left;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_921 = c_upper_arm_left_y*R_upper_arm_left_z_y;
  const double s7_922 = mbgen::fnma((-c_upper_arm_left_z), R_upper_arm_left_y_y, s7_921);
  const double s7_923 = (-c_upper_arm_left_z)*R_upper_arm_left_z_y;
  const double s7_924 = mbgen::fma(c_upper_arm_left_y, R_upper_arm_left_y_y, s7_923);
  const double s7_925 = mbgen::fma(work.s7_82, s7_922, work.a_upper_arm_left_y);
  const double f_upper_arm_left_y = m_upper_arm_left*mbgen::fnma(work.s7_84, s7_924, s7_925);
  const double s7_926 = mbgen::fma(work.s7_81, s7_924, work.a_upper_arm_left_z);
  const double f_upper_arm_left_z = m_upper_arm_left*mbgen::fnma(work.s7_83, s7_922, s7_926);
  const double s7_927 = R_upper_arm_left_z_y*work.w_chassis_z;
  const double s7_928 = mbgen::fma(R_upper_arm_left_y_y, work.w_chassis_y, s7_927);
  const double s7_929 = R_upper_arm_left_y_y*work.w_chassis_z;
  const double s7_930 = mbgen::fnma(R_upper_arm_left_z_y, work.w_chassis_y, s7_929);
  const double s7_931 = I_upper_arm_left_xx*work.alpha_upper_arm_left_x;
  const double s7_932 = mbgen::fma(s7_928, I_upper_arm_left_zz*s7_930, s7_931);
  const double s7_933 = mbgen::fnma(s7_930, I_upper_arm_left_yy*s7_928, s7_932);
  const double s7_934 = mbgen::fma(s7_924, f_upper_arm_left_z, s7_933);
  work.n_upper_arm_left_x = mbgen::fnma(s7_922, f_upper_arm_left_y, s7_934);
}

/// Part 3 of compute_multipliers: step 7: inertias of the bodies and forces on joints; step 9:
/// multipliers of the closures and driving forces.
[[gnu::noinline]] void compute_multipliers_3(const State& state, const double* tau,
    ConstraintForcesWork& __restrict work, ConstraintForces& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double Q_upper_arm_left = tau[Coordinate::upper_arm_left] - work.n_upper_arm_left_x;
  result.missing[4] = Q_upper_arm_left;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double f_wheel_front_left_x = m_wheel_front_left*work.a_wheel_front_left_x;
  const double f_wheel_front_left_y = m_wheel_front_left*work.a_wheel_front_left_y;
  const double f_wheel_front_left_z = m_wheel_front_left*work.a_wheel_front_left_z;
  const double s7_935 = work.R_carrier_left_y_z*work.alpha_wheel_front_left_y;
  const double s7_936 = mbgen::fma(work.R_carrier_left_x_z, work.alpha_wheel_front_left_x, s7_935);
  const double s7_937 = work.R_carrier_left_y_x*work.w_wheel_front_left_y;
  const double s7_938 = mbgen::fma(work.R_carrier_left_x_x, work.w_wheel_front_left_x, s7_937);
  const double s7_939 = mbgen::fma(work.R_carrier_left_z_x, work.w_wheel_front_left_z, s7_938);
  const double s7_940 = work.R_carrier_left_aux2_y_y*work.w_wheel_front_left_y;
  const double s7_941 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.w_wheel_front_left_z, s7_940);
  const double s7_942 = mbgen::fnma(work.s1_12, work.w_wheel_front_left_x, s7_941);
  const double s7_943 = I_wheel_front_left_yy*s7_942;
  const double s7_944 = I_wheel_front_left_xx*s7_939;
  const double s7_945 = mbgen::fma(work.R_carrier_left_z_z, work.alpha_wheel_front_left_z, s7_936);
  const double s7_946 = mbgen::fma(s7_939, s7_943, I_wheel_front_left_zz*s7_945);
  const double s7_947 = mbgen::fnma(s7_942, s7_944, s7_946);
  const double s7_948 = work.R_carrier_left_y_x*work.alpha_wheel_front_left_y;
  const double s7_949 = mbgen::fma(work.R_carrier_left_x_x, work.alpha_wheel_front_left_x, s7_948);
  const double s7_950 = work.R_carrier_left_y_z*work.w_wheel_front_left_y;
  const double s7_951 = mbgen::fma(work.R_carrier_left_x_z, work.w_wheel_front_left_x, s7_950);
  const double s7_952 = mbgen::fma(work.R_carrier_left_z_z, work.w_wheel_front_left_z, s7_951);
  const double s7_953 = I_wheel_front_left_zz*s7_952;
  const double s7_954 = mbgen::fma(work.R_carrier_left_z_x, work.alpha_wheel_front_left_z, s7_949);
  const double s7_955 = mbgen::fma(s7_942, s7_953, I_wheel_front_left_xx*s7_954);
  const double s7_956 = mbgen::fnma(s7_943, s7_952, s7_955);
  const double s7_957 = work.R_carrier_left_aux2_y_y*work.alpha_wheel_front_left_y;
  const double s7_958 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.alpha_wheel_front_left_z,
      s7_957);
  const double s7_959 = mbgen::fnma(work.s1_12, work.alpha_wheel_front_left_x, s7_958);
  const double s7_960 = mbgen::fma(s7_944, s7_952, I_wheel_front_left_yy*s7_959);
  const double s7_961 = mbgen::fnma(s7_939, s7_953, s7_960);
  const double s7_962 = work.R_carrier_left_x_z*s7_947;
  const double s7_963 = mbgen::fma(work.R_carrier_left_x_x, s7_956, s7_962);
  const double n_wheel_front_left_x = mbgen::fnma(work.s1_12, s7_961, s7_963);
  const double s7_964 = work.R_carrier_left_aux2_y_y*s7_961;
  const double s7_965 = mbgen::fma(work.R_carrier_left_y_x, s7_956, s7_964);
  const double n_wheel_front_left_y = mbgen::fma(work.R_carrier_left_y_z, s7_947, s7_965);
  const double s7_966 = work.R_carrier_left_aux2_z_y*s7_961;
  const double s7_967 = mbgen::fma(work.R_carrier_left_z_z, s7_947, s7_966);
  const double n_wheel_front_left_z = mbgen::fma(work.R_carrier_left_z_x, s7_956, s7_967);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_968 = c_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_969 = mbgen::fma(c_carrier_left_z, work.R_carrier_left_y_z, s7_968);
  const double s7_970 = mbgen::fnma((-c_carrier_left_x), work.R_carrier_left_y_x, s7_969);
  const double s7_971 = c_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_972 = mbgen::fma(c_carrier_left_z, work.R_carrier_left_z_z, s7_971);
  const double s7_973 = mbgen::fnma((-c_carrier_left_x), work.R_carrier_left_z_x, s7_972);
  const double s7_974 = c_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_975 = mbgen::fnma((-c_carrier_left_x), work.R_carrier_left_x_x, s7_974);
  const double s7_976 = mbgen::fnma(c_carrier_left_y, work.s1_12, s7_975);
  const double s7_977 = mbgen::fma(work.s7_64, s7_970, work.a_carrier_left_aux1_x);
  const double s7_978 = mbgen::fnma(work.s7_57, s7_976, mbgen::fma(work.s7_60, s7_973, s7_977));
  const double s7_979 = m_carrier_left*s7_978;
  const double s7_980 = mbgen::fma(work.s7_61, s7_976, work.a_carrier_left_aux1_y);
  const double s7_981 = mbgen::fnma(work.s7_58, s7_970, mbgen::fma(work.s7_65, s7_973, s7_980));
  const double s7_982 = m_carrier_left*s7_981;
  const double f_carrier_left_y = work.s7_343 + (work.s7_270 + s7_982);
  const double s7_983 = mbgen::fma(work.s7_62, s7_970, work.a_carrier_left_aux1_z);
  const double s7_984 = mbgen::fnma(work.s7_59, s7_973, mbgen::fma(work.s7_63, s7_976, s7_983));
  const double s7_985 = m_carrier_left*s7_984;
  const double f_carrier_left_z = work.s7_339 + (work.s7_273 + s7_985);
  const double s7_986 = work.R_carrier_left_y_z*work.alpha_carrier_left_y;
  const double s7_987 = mbgen::fma(work.R_carrier_left_x_z, work.alpha_carrier_left_x, s7_986);
  const double s7_988 = mbgen::fma(work.R_carrier_left_z_z, work.alpha_carrier_left_z, s7_987);
  const double s7_989 = work.R_carrier_left_y_x*work.alpha_carrier_left_y;
  const double s7_990 = mbgen::fma(work.R_carrier_left_x_x, work.alpha_carrier_left_x, s7_989);
  const double s7_991 = mbgen::fma(work.R_carrier_left_z_x, work.alpha_carrier_left_z, s7_990);
  const double s7_992 = work.R_carrier_left_aux2_y_y*work.alpha_carrier_left_y;
  const double s7_993 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.alpha_carrier_left_z, s7_992);
  const double s7_994 = mbgen::fnma(work.s1_12, work.alpha_carrier_left_x, s7_993);
  const double s7_995 = work.R_carrier_left_y_x*work.w_carrier_left_y;
  const double s7_996 = mbgen::fma(work.R_carrier_left_x_x, work.w_carrier_left_x, s7_995);
  const double s7_997 = mbgen::fma(work.R_carrier_left_z_x, work.w_carrier_left_z, s7_996);
  const double s7_998 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_y;
  const double s7_999 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s7_998);
  const double s7_1000 = mbgen::fnma(work.s1_12, work.w_carrier_left_x, s7_999);
  const double s7_1001 = work.R_carrier_left_y_z*work.w_carrier_left_y;
  const double s7_1002 = mbgen::fma(work.R_carrier_left_x_z, work.w_carrier_left_x, s7_1001);
  const double s7_1003 = mbgen::fma(work.R_carrier_left_z_z, work.w_carrier_left_z, s7_1002);
  const double s7_1004 = mbgen::fnma((-I_carrier_left_yz), s7_1003, I_carrier_left_yy*s7_1000);
  const double s7_1005 = mbgen::fnma((-I_carrier_left_xy), s7_997, s7_1004);
  const double s7_1006 = mbgen::fnma((-I_carrier_left_xz), s7_1003, I_carrier_left_xx*s7_997);
  const double s7_1007 = mbgen::fnma((-I_carrier_left_xy), s7_1000, s7_1006);
  const double s7_1008 = mbgen::fnma((-I_carrier_left_xz), s7_991, I_carrier_left_zz*s7_988);
  const double s7_1009 = mbgen::fnma((-I_carrier_left_yz), s7_994, s7_1008);
  const double s7_1010 = mbgen::fnma(s7_1000, s7_1007, mbgen::fma(s7_997, s7_1005, s7_1009));
  const double s7_1011 = mbgen::fnma((-I_carrier_left_xz), s7_997, I_carrier_left_zz*s7_1003);
  const double s7_1012 = mbgen::fnma((-I_carrier_left_yz), s7_1000, s7_1011);
  const double s7_1013 = mbgen::fnma((-I_carrier_left_xz), s7_988, I_carrier_left_xx*s7_991);
  const double s7_1014 = mbgen::fnma((-I_carrier_left_xy), s7_994, s7_1013);
  const double s7_1015 = mbgen::fnma(s7_1003, s7_1005, mbgen::fma(s7_1000, s7_1012, s7_1014));
  const double s7_1016 = mbgen::fnma((-I_carrier_left_yz), s7_988, I_carrier_left_yy*s7_994);
  const double s7_1017 = mbgen::fnma((-I_carrier_left_xy), s7_991, s7_1016);
  const double s7_1018 = mbgen::fnma(s7_997, s7_1012, mbgen::fma(s7_1003, s7_1007, s7_1017));
  const double s7_1019 = mbgen::fnma(s7_973, s7_982, s7_970*s7_985);
  const double s7_1020 = mbgen::fma(work.R_carrier_left_x_z, s7_1010, s7_1019);
  const double s7_1021 = mbgen::fma(work.R_carrier_left_x_x, s7_1015, s7_1020);
  const double s7_1022 = mbgen::fnma(work.s1_12, s7_1018, s7_1021);
  const double s7_1023 = mbgen::fnma(work.s7_267, work.s7_270, s7_1022);
  const double s7_1024 = mbgen::fma(work.s7_264, work.s7_273, s7_1023);
  const double s7_1025 = mbgen::fnma(work.s7_337, work.s7_343, s7_1024);
  const double n_carrier_left_x = mbgen::fma(work.s7_335, work.s7_339, s7_1025);
  const double s7_1026 = mbgen::fnma(s7_976, s7_985, s7_973*s7_979);
  const double s7_1027 = mbgen::fma(work.R_carrier_left_aux2_y_y, s7_1018, s7_1026);
  const double s7_1028 = mbgen::fma(work.R_carrier_left_y_x, s7_1015, s7_1027);
  const double s7_1029 = mbgen::fma(work.R_carrier_left_y_z, s7_1010, s7_1028);
  const double s7_1030 = mbgen::fnma(work.s7_261, work.s7_273, s7_1029);
  const double s7_1031 = mbgen::fma(work.s7_267, work.s7_276, s7_1030);
  const double s7_1032 = mbgen::fnma(work.s7_333, work.s7_339, s7_1031);
  const double n_carrier_left_y = mbgen::fma(work.s7_337, work.s7_341, s7_1032);
  const double s7_1033 = mbgen::fnma(s7_970, s7_979, s7_976*s7_982);
  const double s7_1034 = mbgen::fma(work.R_carrier_left_aux2_z_y, s7_1018, s7_1033);
  const double s7_1035 = mbgen::fma(work.R_carrier_left_z_z, s7_1010, s7_1034);
  const double s7_1036 = mbgen::fma(work.R_carrier_left_z_x, s7_1015, s7_1035);
  const double s7_1037 = mbgen::fnma(work.s7_264, work.s7_276, s7_1036);
  const double s7_1038 = mbgen::fma(work.s7_261, work.s7_270, s7_1037);
  const double s7_1039 = mbgen::fnma(work.s7_335, work.s7_341, s7_1038);
  const double n_carrier_left_z = mbgen::fma(work.s7_333, work.s7_343, s7_1039);
  const double s7_1040 = n_wheel_front_left_y + n_carrier_left_y;
  const double s7_1041 = mbgen::fma(work.s1_30, f_wheel_front_left_x, s7_1040);
  const double s7_1042 = mbgen::fnma(work.s1_26, f_wheel_front_left_z, s7_1041);
  const double s7_1043 = n_wheel_front_left_z + n_carrier_left_z;
  const double s7_1044 = mbgen::fma(work.s1_26, f_wheel_front_left_y, s7_1043);
  const double s7_1045 = mbgen::fnma(work.s1_28, f_wheel_front_left_x, s7_1044);
  const double s7_1046 = n_wheel_front_left_x + n_carrier_left_x;
  const double s7_1047 = mbgen::fma(work.s1_28, f_wheel_front_left_z, s7_1046);
  const double s7_1048 = mbgen::fnma(work.s1_30, f_wheel_front_left_y, s7_1047);
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double s7_1049 = mbgen::fnma(work.R_carrier_left_aux2_y_y, s7_1042, tau_carrier_left_ry);
  const double s7_1050 = mbgen::fnma(work.R_carrier_left_aux2_z_y, s7_1045, s7_1049);
  result.missing[3] = mbgen::fma(work.s1_12, s7_1048, s7_1050);
  const double s7_1051 = f_wheel_front_left_y + f_carrier_left_y;
  const double s7_1052 = f_wheel_front_left_z + f_carrier_left_z;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s7_1053 = mbgen::fnma(work.R_carrier_left_aux1_y_x, s7_1042, tau_carrier_left_rx);
  const double s7_1054 = mbgen::fnma(R_carrier_left_aux1_x_x, s7_1048, s7_1053);
  result.missing[2] = mbgen::fnma(work.R_carrier_left_aux1_z_x, s7_1045, s7_1054);
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s7_1055 = mbgen::fnma(R_lower_arm_left_y_y, s7_1045, tau_carrier_left_rz);
  result.missing[1] = mbgen::fma(R_lower_arm_left_z_y, s7_1042, s7_1055);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_1056 = c_lower_arm_left_y*R_lower_arm_left_z_y;
  const double s7_1057 = mbgen::fnma((-c_lower_arm_left_z), R_lower_arm_left_y_y, s7_1056);
  const double s7_1058 = (-c_lower_arm_left_z)*R_lower_arm_left_z_y;
  const double s7_1059 = mbgen::fma(c_lower_arm_left_y, R_lower_arm_left_y_y, s7_1058);
  const double s7_1060 = mbgen::fma(work.s7_32, s7_1057, work.a_lower_arm_left_y);
  const double f_lower_arm_left_y = m_lower_arm_left*mbgen::fnma(work.s7_34, s7_1059, s7_1060);
  const double s7_1061 = mbgen::fma(work.s7_31, s7_1059, work.a_lower_arm_left_z);
  const double f_lower_arm_left_z = m_lower_arm_left*mbgen::fnma(work.s7_33, s7_1057, s7_1061);
  const double s7_1062 = R_lower_arm_left_z_y*work.w_chassis_z;
  const double s7_1063 = mbgen::fma(R_lower_arm_left_y_y, work.w_chassis_y, s7_1062);
  const double s7_1064 = R_lower_arm_left_y_y*work.w_chassis_z;
  const double s7_1065 = mbgen::fnma(R_lower_arm_left_z_y, work.w_chassis_y, s7_1064);
  const double s7_1066 = I_lower_arm_left_xx*work.alpha_lower_arm_left_x;
  const double s7_1067 = mbgen::fma(s7_1063, I_lower_arm_left_zz*s7_1065, s7_1066);
  const double s7_1068 = mbgen::fnma(s7_1065, I_lower_arm_left_yy*s7_1063, s7_1067);
  const double s7_1069 = mbgen::fma(s7_1059, f_lower_arm_left_z, s7_1068);
  const double n_lower_arm_left_x = mbgen::fnma(s7_1057, f_lower_arm_left_y, s7_1069);
  const double s7_1070 = tau[Coordinate::lower_arm_left] - s7_1048 - n_lower_arm_left_x;
  const double s7_1071 = mbgen::fnma(work.s1_8, s7_1052, s7_1070);
  const double Q_lower_arm_left = mbgen::fma(work.s1_10, s7_1051, s7_1071);
  result.missing[0] = Q_lower_arm_left;
  // operations: 1146 add, 1359 multiply

  // --- step 9: multipliers of the closures and driving forces ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s9_1 = work.R_carrier_left_aux1_z_x*work.s1_12;
  const double s9_2 = mbgen::fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s9_1);
  const double s9_3 = work.R_carrier_left_aux1_y_x*work.s1_12;
  const double s9_4 = mbgen::fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s9_3);
  const double s9_5 = mbgen::fma(R_lower_arm_left_y_y, s9_4, R_lower_arm_left_z_y*s9_2);
  const double s9_6 = 1.0/s9_5;
  const double s9_7 = work.R_carrier_left_aux1_z_y*s9_6;
  const double s9_8 = work.R_carrier_left_aux1_y_y*s9_6;
  const double s9_9 = s9_4*s9_6;
  const double s9_10 = s9_2*s9_6;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s9_11 = R_lower_arm_right_z_y*work.R_carrier_right_aux1_z_x;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s9_12 = work.R_carrier_right_aux1_z_x*work.s1_38;
  const double s9_13 = mbgen::fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s9_12);
  const double s9_14 = work.R_carrier_right_aux1_y_x*work.s1_38;
  const double s9_15 = mbgen::fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s9_14);
  const double s9_16 = mbgen::fma(R_lower_arm_right_y_y, s9_15, R_lower_arm_right_z_y*s9_13);
  const double s9_17 = 1.0/s9_16;
  const double s9_18 = work.R_carrier_right_aux1_z_y*s9_17;
  const double s9_19 = work.R_carrier_right_aux1_y_y*s9_17;
  const double s9_20 = s9_15*s9_17;
  const double s9_21 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s9_22 = mbgen::fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y,
      s9_21);
  const double s9_23 = s9_17*s9_22;
  const double s9_24 = mbgen::fma(R_lower_arm_right_y_y, work.R_carrier_right_aux1_y_x, s9_11);
  const double s9_25 = s9_24*s9_17;
  const double s9_26 = s9_13*s9_17;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double R_rear_axle_aux4_y_x = work.sines[17];
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double s9_27 = R_rear_axle_aux4_y_x*work.R_rear_axle_aux5_y_x;
  const double s9_28 = mbgen::fma(R_rear_axle_aux4_x_x, work.R_rear_axle_aux5_x_x, s9_27);
  const double s9_29 = 1.0/s9_28;
  const double s9_30 = R_rear_axle_aux4_y_x*s9_29;
  const double s9_31 = R_rear_axle_aux4_x_x*s9_29;
  const double s9_32 = work.R_rear_axle_aux5_y_z*s9_29;
  const double s9_33 = work.R_rear_axle_aux5_x_z*s9_29;
  const double s9_34 = s9_28*s9_29;
  // upper_ball_left
  const double pivot_carrier_left_rx = mbgen::fms(p_carrier_left_upper_ball_z,
      work.R_carrier_left_z_z, work.s7_325);
  const double s9_35 = mbgen::fma(p_carrier_left_upper_ball_z, work.R_carrier_left_x_z,
      work.s7_331);
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s9_36 = (-p_upper_arm_left_ball_z)*R_upper_arm_left_z_y;
  const double s9_37 = mbgen::fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s9_36);
  const double s9_38 = mbgen::fms(p_carrier_left_upper_ball_z, work.R_carrier_left_y_z,
      work.s7_326);
  // upper_ball_right
  const double pivot_carrier_right_rx = mbgen::fma(p_carrier_right_upper_ball_z,
      work.R_carrier_right_z_z, work.s7_358);
  const double s9_39 = mbgen::fma(p_carrier_right_upper_ball_z, work.R_carrier_right_y_z,
      work.s7_355);
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s9_40 = (-p_upper_arm_right_ball_y)*R_upper_arm_right_z_y;
  const double s9_41 = mbgen::fma((-p_upper_arm_right_ball_z), R_upper_arm_right_y_y, s9_40);
  const double s9_42 = mbgen::fms(p_carrier_right_upper_ball_z, work.R_carrier_right_x_z,
      work.s7_351);
  // arb_link_front_left
  const double s9_43 = 0.35 + (work.s7_258 - work.s7_261);
  const double s9_44 = work.s7_256 - work.r_carrier_left_aux1_z - work.s7_267;
  const double s9_45 = s9_44 - (-p_arb_front_left_z);
  const double pivot_arb_front_left = mbgen::fnma(work.s7_258, s9_45, work.s7_256*s9_43);
  const double s9_46 = 0.72 - work.r_carrier_left_aux1_y - work.s7_264;
  const double s9_47 = mbgen::fnma(work.s7_264, s9_43, work.s7_261*s9_46);
  const double s9_48 = mbgen::fnma(work.s7_261, s9_45, work.s7_267*s9_43);
  const double s9_49 = s9_45*(work.s1_8 + work.s7_264);
  const double s9_50 = mbgen::fnma(s9_46, work.s1_10 + work.s7_267, s9_49);
  // arb_link_front_right
  const double s9_51 = 0.35 + (work.s7_286 - work.s7_289);
  const double s9_52 = work.s1_36 + work.s7_284 - work.s7_295 - (-p_arb_front_right_z);
  const double pivot_arb_front_right = mbgen::fnma(work.s7_286, s9_52, work.s7_284*s9_51);
  const double s9_53 = 0.72 + (work.r_carrier_right_aux1_y + work.s7_292);
  const double s9_54 = mbgen::fma(work.s7_292, s9_52, work.s7_295*s9_53);
  const double s9_55 = mbgen::fma(work.s7_292, s9_51, work.s7_289*s9_53);
  const double s9_56 = mbgen::fnma(work.s7_289, s9_52, work.s7_295*s9_51);
  // drag_link
  const double s9_57 = 1.15 + (work.s7_315 - work.s7_313);
  const double pivot_pitman_arm = mbgen::fnma(work.s7_314, s9_57, work.s7_313*(0.2 - work.s7_314));
  // tie_rod_left
  const double s9_58 = (-p_bell_crank_z) + (work.r_carrier_left_aux1_z + work.s7_337);
  const double s9_59 = work.s7_330 - work.r_carrier_left_aux1_y - work.s7_335;
  const double s9_60 = 0.35 + (work.s7_329 + work.s7_333);
  const double s9_61 = mbgen::fnma(work.s7_337, s9_60, work.s7_333*s9_58);
  const double s9_62 = s9_58*(work.s1_8 + work.s7_335);
  const double s9_63 = mbgen::fma(s9_59, work.s1_10 + work.s7_337, s9_62);
  // tie_rod_right
  const double s9_64 = (-p_bell_crank_z) + (work.s7_360 - work.s1_36);
  const double s9_65 = work.s7_350 + (work.r_carrier_right_aux1_y + work.s7_357);
  const double s9_66 = work.s7_352 - work.s7_354 - 0.35;
  const double s9_67 = mbgen::fma(work.s7_360, s9_66, work.s7_354*s9_64);
  const double s9_68 = mbgen::fnma(work.s7_357, s9_64, work.s7_360*s9_65);
  const double s9_69 = 1.0/pivot_carrier_right_rx;
  const double s9_70 = s9_67*s9_69;
  const double s9_71 = mbgen::fma(work.s7_357, s9_66, work.s7_354*s9_65);
  const double pivot_carrier_right_ry = mbgen::fnma(s9_39, s9_70, s9_71);
  const double s9_72 = 1.0/pivot_carrier_right_ry;
  const double s9_73 = s9_42*s9_72;
  const double pivot_carrier_right_rz = mbgen::fms(s9_68, s9_73, pivot_carrier_right_rx);
  const double s9_74 = s9_42*s9_69;
  const double s9_75 = s9_72*(s9_39*s9_74);
  const double s9_76 = 1.0/pivot_carrier_right_rz;
  const double s9_77 = mbgen::fnma(s9_68, s9_75, s9_39)*s9_76;
  const double s9_78 = s9_41*s9_77;
  const double s9_79 = mbgen::fnma((-p_upper_arm_right_ball_z), R_upper_arm_right_z_y, s9_78);
  const double pivot_upper_arm_right = mbgen::fma((-p_upper_arm_right_ball_y),
      R_upper_arm_right_y_y, s9_79);
  const double s9_80 = 1.0/pivot_carrier_left_rx;
  const double s9_81 = s9_61*s9_80;
  const double s9_82 = mbgen::fma(work.s7_335, s9_60, work.s7_333*s9_59);
  const double s9_83 = mbgen::fma(s9_38, s9_81, s9_82);
  const double s9_84 = s9_35*s9_80;
  const double s9_85 = 1.0/s9_83;
  const double s9_86 = s9_38*s9_84*s9_85;
  const double pivot_lower_arm_left = mbgen::fnma(s9_63, s9_86, work.s1_8 + s9_38);
  const double s9_87 = s9_35*s9_85;
  const double s9_88 = 1.0/pivot_lower_arm_left;
  const double s9_89 = (mbgen::fms(s9_63, s9_87, work.s1_10) - pivot_carrier_left_rx)*s9_88;
  const double s9_90 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s9_91 = mbgen::fnma((-p_upper_arm_left_ball_z), R_upper_arm_left_y_y, s9_90);
  const double pivot_upper_arm_left = mbgen::fma(s9_37, s9_89, s9_91);
  const double s9_92 = 16.504892200367603*std::abs(pivot_arb_front_right);
  const double s9_93 = mbgen::min(3.9625229801272064*std::abs(pivot_pitman_arm), s9_92);
  const double s9_94 = mbgen::min(16.679425973935604*std::abs(pivot_arb_front_left), s9_93);
  const double s9_95 = mbgen::min(2.7028647671567816*std::abs(pivot_carrier_right_rx), s9_94);
  const double s9_96 = mbgen::min(s9_95, 6.8514628664707224*std::abs(pivot_carrier_right_ry));
  const double s9_97 = mbgen::min(s9_96, 2.7028647671567816*std::abs(pivot_carrier_right_rz));
  const double s9_98 = mbgen::min(s9_97, 3.405476531191585*std::abs(pivot_upper_arm_right));
  const double s9_99 = mbgen::min(2.7028219055711094*std::abs(pivot_carrier_left_rx), s9_98);
  const double s9_100 = mbgen::min(6.915894223167945*std::abs(s9_83), s9_99);
  const double s9_101 = mbgen::min(2.5101920700758265*std::abs(pivot_lower_arm_left), s9_100);
  const double s9_102 = mbgen::min(3.84681640934729*std::abs(pivot_upper_arm_left), s9_101);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s9_103 = mbgen::min(s9_102, std::abs(s9_5));
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  result.pivot[0] = mbgen::min(s9_103, std::abs(s9_16));
  const double s9_104 = work.Q_arb_front_left*(1.0/pivot_arb_front_left);
  result.lambda[6] = l_arb_link_front_left*s9_104;
  const double s9_105 = work.Q_arb_front_right*(1.0/pivot_arb_front_right);
  result.lambda[7] = l_arb_link_front_right*s9_105;
  result.lambda[8] = l_drag_link*(work.Q_pitman_arm*(1.0/pivot_pitman_arm));
  const double s9_106 = mbgen::fms(tau_carrier_left_ry, s9_8, s7_1042);
  const double s9_107 = mbgen::fma(tau_carrier_left_rx, work.R_carrier_left_aux1_y_x, s9_106);
  const double s9_108 = mbgen::fnma(tau_carrier_left_rz, s9_10, s9_107);
  const double s9_109 = s9_80*mbgen::fma(s9_48, s9_104, s9_108);
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double s9_110 = mbgen::fms(tau_carrier_right_ry, s9_19, work.s7_864);
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s9_111 = mbgen::fma(tau_carrier_right_rx, work.R_carrier_right_aux1_y_x, s9_110);
  const double s9_112 = mbgen::fnma(tau_carrier_right_rz, s9_26, s9_111);
  const double s9_113 = s9_69*mbgen::fma(s9_56, s9_105, s9_112);
  const double s9_114 = mbgen::fms(s9_38, s9_109, s7_1045);
  const double s9_115 = mbgen::fma(tau_carrier_left_ry, s9_7, s9_114);
  const double s9_116 = mbgen::fma(tau_carrier_left_rx, work.R_carrier_left_aux1_z_x, s9_115);
  const double s9_117 = mbgen::fma(s9_47, s9_104, mbgen::fma(tau_carrier_left_rz, s9_9, s9_116));
  const double s9_118 = s9_85*s9_117;
  const double s9_119 = mbgen::fms(s9_39, s9_113, work.s7_867);
  const double s9_120 = mbgen::fma(tau_carrier_right_ry, s9_18, s9_119);
  const double s9_121 = mbgen::fma(tau_carrier_right_rx, work.R_carrier_right_aux1_z_x, s9_120);
  const double s9_122 = mbgen::fma(tau_carrier_right_rz, s9_20, s9_121);
  const double s9_123 = s9_72*mbgen::fnma(s9_55, s9_105, s9_122);
  const double s9_124 = mbgen::fma(s9_50, s9_104, mbgen::fma(s9_63, s9_118, Q_lower_arm_left));
  const double s9_125 = s9_88*s9_124;
  const double s9_126 = mbgen::fms(s9_68, s9_123, work.s7_870);
  const double s9_127 = mbgen::fma(tau_carrier_right_rx, R_carrier_right_aux1_x_x, s9_126);
  const double s9_128 = mbgen::fma(tau_carrier_right_rz, s9_23, s9_127);
  const double s9_129 = mbgen::fnma(tau_carrier_right_ry, s9_25, s9_128);
  const double s9_130 = s9_76*mbgen::fma(s9_54, s9_105, s9_129);
  const double s9_131 = 1.0/pivot_upper_arm_left*mbgen::fma(s9_37, s9_125, Q_upper_arm_left);
  result.lambda[1] = s9_131;
  const double s9_132 = mbgen::fma(s9_41, s9_130, work.Q_upper_arm_right);
  const double s9_133 = 1.0/pivot_upper_arm_right*s9_132;
  result.lambda[5] = s9_133;
  const double s9_134 = mbgen::fnma(s9_89, s9_131, s9_125);
  result.lambda[2] = s9_134;
  const double s9_135 = mbgen::fnma(s9_77, s9_133, s9_130);
  result.lambda[4] = s9_135;
  const double s9_136 = mbgen::fnma(s9_86, s9_134, mbgen::fms(s9_87, s9_131, s9_118));
  result.lambda[9] = l_tie_rod_left*s9_136;
  const double s9_137 = mbgen::fnma(s9_73, s9_135, mbgen::fma(s9_75, s9_133, s9_123));
  result.lambda[10] = l_tie_rod_right*s9_137;
  result.lambda[0] = mbgen::fma(s9_81, s9_136, mbgen::fma(s9_84, s9_134, s9_109));
  result.lambda[3] = mbgen::fma(s9_70, s9_137, mbgen::fma(s9_74, s9_133, s9_113));
  // long_rod_left
  const double s9_138 = (-p_long_rod_left_from_z) + (work.r_rear_axle_aux3_z + work.s7_377);
  const double s9_139 = (-p_long_rod_left_from_x) + (work.r_rear_axle_aux1_x + work.s7_380);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_140 = p_long_rod_left_from_y - z_rear_axle_ty - work.s7_383;
  // diag_rod_left
  const double s9_141 = (-p_diag_rod_left_from_z) + (work.r_rear_axle_aux3_z + work.s7_397);
  const double s9_142 = (-p_diag_rod_left_from_x) + (work.r_rear_axle_aux1_x + work.s7_399);
  const double s9_143 = p_diag_rod_left_from_y - z_rear_axle_ty - work.s7_401;
  // arb_link_rear_left
  const double s9_144 = work.s7_410 + (work.r_rear_axle_aux3_z + work.s7_418);
  const double s9_145 = (-p_arb_rear_left_z) + s9_144;
  const double s9_146 = 0.6 - z_rear_axle_ty - work.s7_420;
  const double s9_147 = work.s7_415 - work.r_rear_axle_aux1_x - work.s7_419;
  const double s9_148 = s9_147 - (-p_arb_rear_left_x);
  // long_rod_right
  const double s9_149 = (-p_long_rod_right_from_y) + (z_rear_axle_ty + work.s7_438);
  const double s9_150 = (-p_long_rod_right_from_z) + (work.r_rear_axle_aux3_z - work.s7_436);
  const double s9_151 = (-p_long_rod_right_from_x) + (work.r_rear_axle_aux1_x + work.s7_437);
  // diag_rod_right
  const double pivot_rear_axle_tx = (-p_diag_rod_right_from_x) + (work.r_rear_axle_aux1_x +
      work.s7_444);
  const double s9_152 = (-p_diag_rod_right_from_z) + (work.r_rear_axle_aux3_z + work.s7_443);
  const double s9_153 = (-p_diag_rod_right_from_y) + (z_rear_axle_ty + work.s7_445);
  const double s9_154 = mbgen::fnma(work.s7_445, s9_152, work.s7_443*s9_153);
  const double s9_155 = mbgen::fnma(work.s7_443, pivot_rear_axle_tx, work.s7_444*s9_152);
  const double s9_156 = mbgen::fnma(work.s7_444, s9_153, work.s7_445*pivot_rear_axle_tx);
  // arb_link_rear_right
  const double s9_157 = 0.6 + (z_rear_axle_ty - work.s7_452);
  const double s9_158 = work.s7_454 + (work.r_rear_axle_aux3_z + work.s7_455);
  const double s9_159 = (-p_arb_rear_right_z) + s9_158;
  const double s9_160 = work.s7_453 + work.s7_456 - work.r_rear_axle_aux1_x;
  const double s9_161 = s9_160 - (-p_arb_rear_right_x);
  const double s9_162 = 1.0/pivot_rear_axle_tx;
  const double s9_163 = s9_142*s9_162;
  const double s9_164 = mbgen::fma(s9_153, s9_163, s9_143);
  const double s9_165 = s9_139*s9_162;
  const double s9_166 = mbgen::fnma(work.s7_401, s9_142, s9_156*s9_163);
  const double s9_167 = mbgen::fnma(work.s7_399, s9_143, s9_166);
  const double s9_168 = 1.0/s9_164;
  const double s9_169 = mbgen::fma(s9_153, s9_165, s9_140)*s9_168;
  const double s9_170 = mbgen::fnma(work.s7_383, s9_139, s9_156*s9_165);
  const double pivot_rear_axle_rx = mbgen::fnma(s9_167, s9_169, mbgen::fnma(work.s7_380, s9_140,
      s9_170));
  const double s9_171 = s9_151*s9_162;
  const double s9_172 = mbgen::fnma(work.s7_399, s9_141, s9_155*s9_163);
  const double s9_173 = mbgen::fma(work.s7_397, s9_142, s9_172);
  const double s9_174 = s9_168*mbgen::fnma(s9_153, s9_171, s9_149);
  const double s9_175 = mbgen::fnma(work.s7_380, s9_138, s9_155*s9_165);
  const double s9_176 = mbgen::fnma(s9_169, s9_173, mbgen::fma(work.s7_377, s9_139, s9_175));
  const double s9_177 = mbgen::fnma(work.s7_438, s9_151, s9_156*s9_171);
  const double s9_178 = 1.0/pivot_rear_axle_rx;
  const double s9_179 = mbgen::fma(s9_167, s9_174, mbgen::fma(work.s7_437, s9_149, s9_177));
  const double s9_180 = s9_179*s9_178;
  const double s9_181 = mbgen::fnma(work.s7_437, s9_150, s9_155*s9_171);
  const double s9_182 = mbgen::fma(s9_173, s9_174, mbgen::fnma(work.s7_436, s9_151, s9_181));
  const double pivot_rear_axle_ry = mbgen::fnma(s9_176, s9_180, s9_182);
  const double s9_183 = mbgen::fma(work.s7_397, s9_143, work.s7_401*s9_141);
  const double s9_184 = mbgen::fma(s9_154, s9_163, s9_183);
  const double s9_185 = s9_161*s9_162;
  const double s9_186 = s9_168*mbgen::fma(s9_153, s9_185, s9_157);
  const double s9_187 = mbgen::fma(work.s7_377, s9_140, work.s7_383*s9_138);
  const double s9_188 = mbgen::fnma(s9_169, s9_184, mbgen::fma(s9_154, s9_165, s9_187));
  const double s9_189 = mbgen::fnma(work.s7_452, s9_161, s9_167*s9_186);
  const double s9_190 = mbgen::fnma(s9_156, s9_185, mbgen::fnma(work.s7_453, s9_157, s9_189));
  const double s9_191 = s9_178*s9_190;
  const double s9_192 = mbgen::fma(work.s7_436, s9_149, work.s7_438*s9_150);
  const double s9_193 = mbgen::fma(s9_174, s9_184, mbgen::fma(s9_154, s9_171, s9_192));
  const double s9_194 = mbgen::fnma(s9_180, s9_188, s9_193);
  const double s9_195 = mbgen::fnma(work.s7_455, s9_161, s9_173*s9_186);
  const double s9_196 = mbgen::fnma(s9_155, s9_185, mbgen::fma(work.s7_453, s9_159, s9_195));
  const double s9_197 = 1.0/pivot_rear_axle_ry;
  const double s9_198 = mbgen::fnma(s9_176, s9_191, s9_196)*s9_197;
  const double s9_199 = mbgen::fnma(work.s7_455, s9_157, s9_184*s9_186);
  const double s9_200 = mbgen::fnma(s9_154, s9_185, mbgen::fnma(work.s7_452, s9_159, s9_199));
  const double pivot_rear_axle_rz = mbgen::fnma(s9_194, s9_198, mbgen::fnma(s9_188, s9_191,
      s9_200));
  const double s9_201 = s9_148*s9_162;
  const double s9_202 = mbgen::fnma(s9_152, s9_163, s9_141);
  const double s9_203 = s9_168*mbgen::fms(s9_153, s9_201, s9_146);
  const double s9_204 = mbgen::fnma(s9_169, s9_202, mbgen::fnma(s9_152, s9_165, s9_138));
  const double s9_205 = mbgen::fnma(work.s7_419, s9_146, s9_167*s9_203);
  const double s9_206 = mbgen::fnma(s9_156, s9_201, mbgen::fma(work.s7_420, s9_148, s9_205));
  const double s9_207 = s9_178*s9_206;
  const double s9_208 = mbgen::fma(s9_174, s9_202, mbgen::fnma(s9_152, s9_171, s9_150));
  const double s9_209 = mbgen::fnma(s9_180, s9_204, s9_208);
  const double s9_210 = mbgen::fnma(work.s7_419, s9_145, s9_173*s9_203);
  const double s9_211 = mbgen::fnma(s9_155, s9_201, mbgen::fnma(work.s7_418, s9_148, s9_210));
  const double s9_212 = s9_197*mbgen::fnma(s9_176, s9_207, s9_211);
  const double s9_213 = mbgen::fma(s9_186, s9_202, mbgen::fma(s9_152, s9_185, s9_159));
  const double s9_214 = mbgen::fnma(s9_198, s9_209, mbgen::fnma(s9_191, s9_204, s9_213));
  const double s9_215 = mbgen::fma(work.s7_418, s9_146, work.s7_420*s9_145);
  const double s9_216 = mbgen::fma(s9_184, s9_203, mbgen::fnma(s9_154, s9_201, s9_215));
  const double s9_217 = 1.0/pivot_rear_axle_rz;
  const double s9_218 = mbgen::fnma(s9_194, s9_212, mbgen::fnma(s9_188, s9_207, s9_216))*s9_217;
  const double s9_219 = mbgen::fma(s9_202, s9_203, mbgen::fma(s9_152, s9_201, s9_145));
  const double s9_220 = mbgen::fnma(s9_209, s9_212, mbgen::fnma(s9_204, s9_207, s9_219));
  const double pivot_rear_axle_tz = mbgen::fnma(s9_214, s9_218, s9_220);
  const double s9_221 = 1.2494533266510743*std::abs(pivot_rear_axle_tx);
  const double s9_222 = mbgen::min(s9_221, 1.665350081353039*std::abs(s9_164));
  const double s9_223 = mbgen::min(s9_222, 2.1234888829989926*std::abs(pivot_rear_axle_rx));
  const double s9_224 = mbgen::min(s9_223, 1.7864443153153613*std::abs(pivot_rear_axle_ry));
  const double s9_225 = mbgen::min(s9_224, 8.176955428452642*std::abs(pivot_rear_axle_rz));
  const double s9_226 = mbgen::min(s9_225, 2.7700489841913827*std::abs(pivot_rear_axle_tz));
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  result.pivot[1] = mbgen::min(s9_226, std::abs(s9_28));
  const double s9_227 = work.Q_rear_axle_tx*s9_162;
  const double s9_228 = s9_168*mbgen::fnma(s9_153, s9_227, work.Q_rear_axle_ty);
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s9_229 = mbgen::fms(s9_167, s9_228, work.s7_672);
  const double s9_230 = mbgen::fma(s9_156, s9_227, mbgen::fma(tau_rear_axle_rz, s9_34, s9_229));
  const double s9_231 = s9_178*s9_230;
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double s9_232 = mbgen::fms(s9_173, s9_228, work.s7_664);
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double s9_233 = mbgen::fma(tau_rear_axle_rx, s9_30, s9_232);
  const double s9_234 = mbgen::fma(tau_rear_axle_ry, R_rear_axle_aux4_x_x, s9_233);
  const double s9_235 = mbgen::fma(s9_155, s9_227, mbgen::fma(tau_rear_axle_rz, s9_32, s9_234));
  const double s9_236 = s9_197*mbgen::fnma(s9_176, s9_231, s9_235);
  const double s9_237 = mbgen::fms(s9_184, s9_228, work.s7_668);
  const double s9_238 = mbgen::fma(tau_rear_axle_rx, s9_31, s9_237);
  const double s9_239 = mbgen::fma(tau_rear_axle_rz, s9_33, s9_238);
  const double s9_240 = mbgen::fnma(tau_rear_axle_ry, R_rear_axle_aux4_y_x, s9_239);
  const double s9_241 = mbgen::fnma(s9_188, s9_231, mbgen::fma(s9_154, s9_227, s9_240));
  const double s9_242 = s9_217*mbgen::fnma(s9_194, s9_236, s9_241);
  const double s9_243 = mbgen::fma(s9_202, s9_228, work.Q_rear_axle_tz);
  const double s9_244 = mbgen::fnma(s9_204, s9_231, mbgen::fnma(s9_152, s9_227, s9_243));
  const double s9_245 = mbgen::fnma(s9_214, s9_242, mbgen::fnma(s9_209, s9_236, s9_244));
  const double s9_246 = 1.0/pivot_rear_axle_tz*s9_245;
  result.lambda[13] = l_arb_link_rear_left*s9_246;
  const double s9_247 = mbgen::fnma(s9_218, s9_246, s9_242);
  result.lambda[16] = l_arb_link_rear_right*s9_247;
  const double s9_248 = mbgen::fnma(s9_212, s9_246, mbgen::fnma(s9_198, s9_247, s9_236));
  result.lambda[14] = l_long_rod_right*s9_248;
  const double s9_249 = mbgen::fnma(s9_191, s9_247, mbgen::fnma(s9_180, s9_248, s9_231));
  const double s9_250 = mbgen::fnma(s9_207, s9_246, s9_249);
  result.lambda[11] = l_long_rod_left*s9_250;
  const double s9_251 = mbgen::fma(s9_186, s9_247, mbgen::fms(s9_203, s9_246, s9_228));
  const double s9_252 = mbgen::fnma(s9_169, s9_250, mbgen::fma(s9_174, s9_248, s9_251));
  result.lambda[12] = l_diag_rod_left*s9_252;
  const double s9_253 = mbgen::fma(s9_185, s9_247, mbgen::fma(s9_201, s9_246, s9_227));
  const double s9_254 = mbgen::fnma(s9_165, s9_250, mbgen::fnma(s9_163, s9_252, s9_253));
  result.lambda[15] = l_diag_rod_right*mbgen::fnma(s9_171, s9_248, s9_254);
  // operations: 264 add, 322 multiply, 20 divide, 38 other
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
      sines[19], cosines[19], s1_20, r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux5_x_x,
      R_rear_axle_aux5_y_x, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z,
      R_rear_axle_z_y, R_rear_axle_z_z, s1_61, s1_62, s1_63, s1_64, s1_65, s1_66, s1_67, s1_68,
      s2_216, s2_226, s2_227, s2_228, s2_230, s2_231, s2_234, s2_240, s2_246, s2_250;
};

/// Part 1 of compute_closure_terms: step 1: poses and axes b; step 2: closure Jacobian Phi_z and
/// its factors (60).
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
  const double s1_2 = (-p_carrier_left_rz_z)*R_lower_arm_left_z_y;
  const double s1_3 = mbgen::fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_2);
  const double r_carrier_left_aux1_y = p_lower_arm_left_y + s1_3;
  const double s1_4 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_5 = mbgen::fnma((-p_carrier_left_rz_z), R_lower_arm_left_y_y, s1_4);
  const double r_carrier_left_aux1_z = s1_5 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_6 = work.cosines[2];
  const double s1_7 = s1_1*s1_6;
  const double s1_8 = work.sines[2];
  const double R_carrier_left_aux2_x_z = s1_1*s1_8;
  const double R_carrier_left_aux2_y_y = mbgen::fnma(R_lower_arm_left_z_y, s1_8,
      R_carrier_left_aux1_y_y*s1_6);
  const double s1_9 = mbgen::fma(R_carrier_left_aux1_y_y, s1_8, R_lower_arm_left_z_y*s1_6);
  const double R_carrier_left_aux2_z_y = mbgen::fma(R_carrier_left_aux1_z_y, s1_6,
      R_lower_arm_left_y_y*s1_8);
  const double R_carrier_left_aux2_z_z = mbgen::fnma(R_carrier_left_aux1_z_y, s1_8,
      R_lower_arm_left_y_y*s1_6);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_10 = work.cosines[3];
  const double s1_11 = work.sines[3];
  const double s1_12 = R_carrier_left_aux1_x_x*s1_10;
  const double R_carrier_left_x_x = mbgen::fnma(R_carrier_left_aux2_x_z, s1_11, s1_12);
  const double s1_13 = R_carrier_left_aux1_x_x*s1_11;
  const double R_carrier_left_x_z = mbgen::fma(R_carrier_left_aux2_x_z, s1_10, s1_13);
  const double R_carrier_left_y_x = mbgen::fma(s1_9, s1_11, R_carrier_left_aux1_y_x*s1_10);
  const double R_carrier_left_y_z = mbgen::fnma(s1_9, s1_10, R_carrier_left_aux1_y_x*s1_11);
  const double s1_14 = R_carrier_left_aux1_z_x*s1_10;
  const double R_carrier_left_z_x = mbgen::fnma(R_carrier_left_aux2_z_z, s1_11, s1_14);
  const double s1_15 = R_carrier_left_aux1_z_x*s1_11;
  const double R_carrier_left_z_z = mbgen::fma(R_carrier_left_aux2_z_z, s1_10, s1_15);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[6];
  const double s1_16 = work.sines[7];
  const double R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_16;
  const double R_carrier_right_aux1_x_x = work.cosines[7];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[6];
  const double R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_16;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_17 = (-p_carrier_right_rz_z)*R_lower_arm_right_z_y;
  const double s1_18 = mbgen::fnma((-p_carrier_right_rz_y), R_lower_arm_right_y_y, s1_17);
  const double r_carrier_right_aux1_y = s1_18 - (-p_lower_arm_right_y);
  const double s1_19 = (-p_carrier_right_rz_y)*R_lower_arm_right_z_y;
  work.s1_20 = mbgen::fma((-p_carrier_right_rz_z), R_lower_arm_right_y_y, s1_19);
  const double s1_21 = (-p_lower_arm_right_z) + work.s1_20;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_22 = work.cosines[8];
  const double s1_23 = s1_16*s1_22;
  const double s1_24 = work.sines[8];
  const double R_carrier_right_aux2_x_z = s1_16*s1_24;
  const double s1_25 = R_carrier_right_aux1_y_y*s1_22;
  const double R_carrier_right_aux2_y_y = mbgen::fnma(R_lower_arm_right_z_y, s1_24, s1_25);
  const double s1_26 = mbgen::fma(R_carrier_right_aux1_y_y, s1_24, R_lower_arm_right_z_y*s1_22);
  const double R_carrier_right_aux2_z_y = mbgen::fma(R_carrier_right_aux1_z_y, s1_22,
      R_lower_arm_right_y_y*s1_24);
  const double s1_27 = R_lower_arm_right_y_y*s1_22;
  const double R_carrier_right_aux2_z_z = mbgen::fnma(R_carrier_right_aux1_z_y, s1_24, s1_27);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_28 = work.cosines[9];
  const double s1_29 = work.sines[9];
  const double s1_30 = R_carrier_right_aux1_x_x*s1_28;
  const double R_carrier_right_x_x = mbgen::fnma(R_carrier_right_aux2_x_z, s1_29, s1_30);
  const double s1_31 = R_carrier_right_aux1_x_x*s1_29;
  const double R_carrier_right_x_z = mbgen::fma(R_carrier_right_aux2_x_z, s1_28, s1_31);
  const double R_carrier_right_y_x = mbgen::fma(s1_26, s1_29, R_carrier_right_aux1_y_x*s1_28);
  const double R_carrier_right_y_z = mbgen::fnma(s1_26, s1_28, R_carrier_right_aux1_y_x*s1_29);
  const double s1_32 = R_carrier_right_aux1_z_x*s1_28;
  const double R_carrier_right_z_x = mbgen::fnma(R_carrier_right_aux2_z_z, s1_29, s1_32);
  const double s1_33 = R_carrier_right_aux1_z_x*s1_29;
  const double R_carrier_right_z_z = mbgen::fma(R_carrier_right_aux2_z_z, s1_28, s1_33);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  const double R_rear_axle_aux5_z_z = work.cosines[15];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_34 = work.sines[15];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_34;
  const double R_rear_axle_aux4_y_x = work.sines[14];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_34;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_35 = work.sines[16];
  const double s1_36 = work.cosines[16];
  work.R_rear_axle_x_y = mbgen::fnma(R_rear_axle_aux4_y_x, s1_36, R_rear_axle_aux5_x_z*s1_35);
  work.R_rear_axle_x_z = mbgen::fma(R_rear_axle_aux5_x_z, s1_36, R_rear_axle_aux4_y_x*s1_35);
  work.R_rear_axle_y_y = mbgen::fma(R_rear_axle_aux5_y_z, s1_35, R_rear_axle_aux4_x_x*s1_36);
  work.R_rear_axle_y_z = mbgen::fnma(R_rear_axle_aux4_x_x, s1_35, R_rear_axle_aux5_y_z*s1_36);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_35;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_36;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double s1_37 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  const double s1_38 = mbgen::fnma(zd_carrier_left_ry, s1_7, s1_37);
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double s1_39 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  const double s1_40 = zd_carrier_left_ry*R_carrier_left_aux2_z_y;
  const double s1_41 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  const double s1_42 = zd_carrier_left_rx*R_carrier_left_aux1_z_x;
  const double s1_43 = s1_41 + s1_42;
  const double s1_44 = s1_40 + s1_43;
  const double s1_45 = zd_carrier_left_ry*R_carrier_left_aux2_y_y;
  const double s1_46 = zd_carrier_left_rx*R_carrier_left_aux1_y_x;
  const double s1_47 = s1_46 - s1_39;
  const double s1_48 = s1_45 + s1_47;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double s1_49 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  const double s1_50 = mbgen::fnma(zd_carrier_right_ry, s1_23, s1_49);
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double s1_51 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  const double s1_52 = zd_carrier_right_ry*R_carrier_right_aux2_z_y;
  const double s1_53 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  const double s1_54 = zd_carrier_right_rx*R_carrier_right_aux1_z_x;
  const double s1_55 = s1_53 + s1_54;
  const double s1_56 = s1_52 + s1_55;
  const double s1_57 = zd_carrier_right_ry*R_carrier_right_aux2_y_y;
  const double s1_58 = zd_carrier_right_rx*R_carrier_right_aux1_y_x;
  const double s1_59 = s1_58 - s1_51;
  const double s1_60 = s1_57 + s1_59;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  work.s1_61 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.s1_62 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  work.s1_63 = work.s1_61 + work.s1_62;
  work.s1_64 = zd_rear_axle_rx*s1_34;
  work.s1_65 = state.zd[Coordinate::rear_axle_rz] - work.s1_64;
  work.s1_66 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  work.s1_67 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  work.s1_68 = work.s1_66 - work.s1_67;
  // operations: 47 add, 95 multiply, 38 sin cos

  // --- step 2: closure Jacobian Phi_z and its factors (60) ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s2_1 = zd_lower_arm_left + s1_38;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  const double s2_2 = zd_lower_arm_right + s1_50;
  const double s2_3 = zd_lower_arm_left + s1_37;
  const double s2_4 = zd_lower_arm_right + s1_49;
  const double s2_5 = mbgen::fnma(s1_39, s1_42, mbgen::fnma(s1_43, s1_45, s1_40*s1_47));
  const double s2_6 = mbgen::fnma(s1_41, s1_46, s2_5);
  const double s2_7 = mbgen::fnma(s1_51, s1_54, mbgen::fnma(s1_55, s1_57, s1_52*s1_59));
  const double s2_8 = mbgen::fnma(s1_53, s1_58, s2_7);
  const double s2_9 = mbgen::fma(zd_carrier_left_ry, s1_7, zd_lower_arm_left);
  const double s2_10 = mbgen::fma(s1_47, s2_9, mbgen::fma(s1_37, s1_39, s1_45*s2_3));
  const double s2_11 = mbgen::fma(zd_carrier_right_ry, s1_23, zd_lower_arm_right);
  const double s2_12 = mbgen::fma(s1_59, s2_11, mbgen::fma(s1_49, s1_51, s1_57*s2_4));
  const double s2_13 = mbgen::fnma(s1_43, s2_9, mbgen::fnma(s1_40, s2_3, s1_37*s1_41));
  const double s2_14 = mbgen::fnma(s1_55, s2_11, mbgen::fnma(s1_52, s2_4, s1_49*s1_53));
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s2_15 = zd_lower_arm_left*zd_lower_arm_left;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s2_16 = s1_3*s2_15;
  const double s2_17 = s1_5*s2_15;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s2_18 = zd_lower_arm_right*zd_lower_arm_right;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s2_19 = work.s1_20*s2_18;
  const double s2_20 = s1_18*s2_18;
  // upper_ball_left
  const double s2_21 = (-p_carrier_left_upper_ball_y)*R_carrier_left_aux2_z_y;
  const double s2_22 = (-p_carrier_left_upper_ball_y)*R_carrier_left_aux2_y_y;
  const double R_upper_arm_left_z_y = work.sines[4];
  const double R_upper_arm_left_y_y = work.cosines[4];
  const double s2_23 = p_upper_arm_left_ball_y*R_upper_arm_left_z_y;
  const double s2_24 = mbgen::fnma((-p_upper_arm_left_ball_z), R_upper_arm_left_y_y, s2_23);
  result.Jz[18] = s2_24;
  const double s2_25 = (-p_carrier_left_upper_ball_y)*s1_7;
  const double s2_26 = mbgen::fma(p_carrier_left_upper_ball_z, R_carrier_left_x_z, s2_25);
  result.Phi[0] = s2_26;
  result.Jz[29] = R_lower_arm_left_z_y*s2_26;
  result.Jz[15] = R_lower_arm_left_y_y*s2_26;
  const double s2_27 = (-p_upper_arm_left_ball_z)*R_upper_arm_left_z_y;
  const double s2_28 = mbgen::fma(p_upper_arm_left_ball_y, R_upper_arm_left_y_y, s2_27);
  result.Jz[32] = -s2_28;
  const double s2_29 = mbgen::fms(p_carrier_left_upper_ball_z, R_carrier_left_z_z, s2_21);
  const double s2_30 = mbgen::fms(p_carrier_left_upper_ball_z, R_carrier_left_y_z, s2_22);
  result.Jz[17] = mbgen::fma(R_carrier_left_aux2_z_y, s2_26, s1_7*s2_29);
  result.Phi[1] = r_carrier_left_aux1_y + s2_30 - s2_28 - p_upper_arm_left_y;
  result.Phi[2] = (-p_upper_arm_left_z) + (r_carrier_left_aux1_z + s2_29 - s2_24);
  const double s2_31 = R_carrier_left_aux1_x_x*s2_30;
  result.Jz[30] = mbgen::fnma(R_carrier_left_aux1_y_x, s2_26, s2_31);
  const double s2_32 = R_carrier_left_aux1_z_x*s2_26;
  result.Jz[16] = mbgen::fnma(R_carrier_left_aux1_x_x, s2_29, s2_32);
  const double s2_33 = R_carrier_left_aux1_y_x*s2_29;
  result.Jz[2] = mbgen::fnma(R_carrier_left_aux1_z_x, s2_30, s2_33);
  const double s2_34 = R_carrier_left_aux2_y_y*s2_29;
  result.Jz[3] = mbgen::fnma(R_carrier_left_aux2_z_y, s2_30, s2_34);
  result.Jz[28] = s1_3 + s2_30;
  result.Jz[14] = -(s1_5 + s2_29);
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  result.Jz[1] = -mbgen::fma(R_lower_arm_left_y_y, s2_30, R_lower_arm_left_z_y*s2_29);
  result.Jz[31] = -mbgen::fma(R_carrier_left_aux2_y_y, s2_26, s1_7*s2_30);
  const double s2_35 = mbgen::fnma(s1_48, s2_26, s2_1*s2_30);
  const double s2_36 = mbgen::fnma(s2_1, s2_29, s1_44*s2_26);
  const double s2_37 = mbgen::fnma(s1_48, s2_35, mbgen::fnma(s2_13, s2_29, s2_10*s2_30));
  result.c[0] = mbgen::fma(s1_44, s2_36, s2_37);
  const double s2_38 = mbgen::fnma(s1_44, s2_30, s1_48*s2_29);
  const double s2_39 = mbgen::fnma(zd_upper_arm_left, zd_upper_arm_left*s2_28, s2_16);
  const double s2_40 = mbgen::fma(s2_6, s2_29, mbgen::fnma(s2_10, s2_26, s2_39));
  result.c[1] = mbgen::fma(s2_1, s2_35, mbgen::fnma(s1_44, s2_38, s2_40));
  const double s2_41 = mbgen::fnma(zd_upper_arm_left, zd_upper_arm_left*s2_24, s2_17);
  const double s2_42 = mbgen::fma(s2_13, s2_26, mbgen::fnma(s2_6, s2_30, s2_41));
  result.c[2] = mbgen::fma(s1_48, s2_38, mbgen::fnma(s2_1, s2_36, s2_42));
  // upper_ball_right
  const double s2_43 = p_carrier_right_upper_ball_y*s1_23;
  const double R_upper_arm_right_z_y = work.sines[10];
  const double R_upper_arm_right_y_y = work.cosines[10];
  const double s2_44 = (-p_upper_arm_right_ball_z)*R_upper_arm_right_z_y;
  const double s2_45 = mbgen::fnma((-p_upper_arm_right_ball_y), R_upper_arm_right_y_y, s2_44);
  const double s2_46 = mbgen::fms(p_carrier_right_upper_ball_z, R_carrier_right_x_z, s2_43);
  result.Phi[3] = s2_46;
  result.Jz[77] = R_lower_arm_right_z_y*s2_46;
  result.Jz[63] = R_lower_arm_right_y_y*s2_46;
  const double s2_47 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_z_y;
  const double s2_48 = mbgen::fma(p_carrier_right_upper_ball_z, R_carrier_right_z_z, s2_47);
  const double s2_49 = p_carrier_right_upper_ball_y*R_carrier_right_aux2_y_y;
  const double s2_50 = mbgen::fma(p_carrier_right_upper_ball_z, R_carrier_right_y_z, s2_49);
  const double s2_51 = (-p_upper_arm_right_ball_y)*R_upper_arm_right_z_y;
  const double s2_52 = mbgen::fma((-p_upper_arm_right_ball_z), R_upper_arm_right_y_y, s2_51);
  result.Jz[66] = -s2_52;
  result.Jz[80] = -s2_45;
  result.Jz[62] = work.s1_20 - s2_48;
  result.Phi[5] = (-p_upper_arm_right_z) + (s2_48 + s2_52 - s1_21);
  result.Jz[65] = mbgen::fma(R_carrier_right_aux2_z_y, s2_46, s1_23*s2_48);
  result.Jz[76] = s1_18 + s2_50;
  result.Phi[4] = (-p_upper_arm_right_y) + (r_carrier_right_aux1_y + s2_50 - s2_45);
  const double s2_53 = R_carrier_right_aux1_x_x*s2_50;
  result.Jz[78] = mbgen::fnma(R_carrier_right_aux1_y_x, s2_46, s2_53);
  const double s2_54 = R_carrier_right_aux1_z_x*s2_46;
  result.Jz[64] = mbgen::fnma(R_carrier_right_aux1_x_x, s2_48, s2_54);
  const double s2_55 = R_carrier_right_aux1_y_x*s2_48;
  result.Jz[50] = mbgen::fnma(R_carrier_right_aux1_z_x, s2_50, s2_55);
  const double s2_56 = R_carrier_right_aux2_y_y*s2_48;
  result.Jz[51] = mbgen::fnma(R_carrier_right_aux2_z_y, s2_50, s2_56);
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  result.Jz[49] = -mbgen::fma(R_lower_arm_right_y_y, s2_50, R_lower_arm_right_z_y*s2_48);
  result.Jz[79] = -mbgen::fma(R_carrier_right_aux2_y_y, s2_46, s1_23*s2_50);
  const double s2_57 = mbgen::fnma(s1_60, s2_46, s2_2*s2_50);
  const double s2_58 = mbgen::fnma(s2_2, s2_48, s1_56*s2_46);
  const double s2_59 = mbgen::fnma(s1_60, s2_57, mbgen::fnma(s2_14, s2_48, s2_12*s2_50));
  result.c[3] = mbgen::fma(s1_56, s2_58, s2_59);
  const double s2_60 = mbgen::fnma(s1_56, s2_50, s1_60*s2_48);
  const double s2_61 = mbgen::fnma(zd_upper_arm_right, zd_upper_arm_right*s2_45, s2_20);
  const double s2_62 = mbgen::fma(s2_8, s2_48, mbgen::fnma(s2_12, s2_46, s2_61));
  result.c[4] = mbgen::fma(s2_2, s2_57, mbgen::fnma(s1_56, s2_60, s2_62));
  const double s2_63 = mbgen::fnma(s2_8, s2_50, mbgen::fms(s2_14, s2_46, s2_19));
  const double s2_64 = mbgen::fma(s1_60, s2_60, mbgen::fnma(s2_2, s2_58, s2_63));
  result.c[5] = mbgen::fma(zd_upper_arm_right, zd_upper_arm_right*s2_52, s2_64);
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[5];
  const double R_arb_front_left_x_x = work.cosines[5];
  const double s2_65 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s2_66 = mbgen::fnma((-p_arb_link_front_left_from_x), R_arb_front_left_x_x, s2_65);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s2_67 = zd_arb_front_left*s2_66;
  const double s2_68 = (-p_arb_link_front_left_from_x)*R_arb_front_left_x_z;
  const double s2_69 = mbgen::fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s2_68);
  const double s2_70 = zd_arb_front_left*s2_69;
  const double s2_71 = p_arb_link_front_left_to_x*R_carrier_left_x_x;
  const double s2_72 = s1_7 + R_carrier_left_x_z;
  const double s2_73 = mbgen::fma((-p_arb_link_front_left_to_y), s2_72, s2_71);
  const double s2_74 = p_arb_link_front_left_to_x*R_carrier_left_z_x;
  const double s2_75 = R_carrier_left_z_z - R_carrier_left_aux2_z_y;
  const double s2_76 = mbgen::fma((-p_arb_link_front_left_to_y), s2_75, s2_74);
  const double s2_77 = mbgen::fnma(s2_1, s2_76, s1_44*s2_73);
  const double s2_78 = mbgen::fnma(zd_lower_arm_left, s1_5, s2_77);
  const double s2_79 = p_arb_link_front_left_to_x*R_carrier_left_y_x;
  const double s2_80 = R_carrier_left_y_z - R_carrier_left_aux2_y_y;
  const double s2_81 = mbgen::fma((-p_arb_link_front_left_to_y), s2_80, s2_79);
  const double s2_82 = mbgen::fnma(s1_48, s2_73, s2_1*s2_81);
  const double s2_83 = s2_67 + mbgen::fma(zd_lower_arm_left, s1_3, s2_82);
  const double s2_84 = 0.72 - r_carrier_left_aux1_y - s2_81;
  const double s2_85 = 3.846153846153846*s2_84;
  const double s2_86 = 0.35 + (s2_66 - s2_73);
  const double s2_87 = 3.846153846153846*s2_86;
  const double s2_88 = s2_69 - r_carrier_left_aux1_z - s2_76 - (-p_arb_front_left_z);
  const double s2_89 = 3.846153846153846*s2_88;
  result.Jz[89] = mbgen::fnma(s2_66, s2_89, s2_69*s2_87);
  const double s2_90 = mbgen::fnma(s1_44, s2_81, s1_48*s2_76);
  const double s2_91 = mbgen::fnma(s2_6, s2_76, mbgen::fms(s2_10, s2_73, s2_16));
  const double s2_92 = mbgen::fnma(s2_76, s2_85, s2_81*s2_89);
  const double s2_93 = mbgen::fnma(s2_81, s2_87, s2_73*s2_85);
  const double s2_94 = mbgen::fnma(s2_73, s2_89, s2_76*s2_87);
  const double s2_95 = mbgen::fma(s2_6, s2_81, mbgen::fms(zd_arb_front_left, s2_70, s2_17));
  const double s2_96 = mbgen::fma(s2_1, s2_77, mbgen::fnma(s2_13, s2_73, s2_95));
  const double s2_97 = mbgen::fma(s2_13, s2_76, zd_arb_front_left*s2_67);
  const double s2_98 = mbgen::fma(s1_48, s2_82, mbgen::fnma(s2_10, s2_81, s2_97));
  result.Jz[84] = mbgen::fnma(s1_3, s2_89, mbgen::fms(s1_5, s2_85, s2_92));
  const double s2_99 = mbgen::fms(s2_84, s2_85, l_arb_link_front_left);
  result.Phi[6] = 0.5*mbgen::fma(s2_88, s2_89, mbgen::fma(s2_86, s2_87, s2_99));
  result.Jz[85] = mbgen::fnma(R_lower_arm_left_y_y, s2_93, R_lower_arm_left_z_y*s2_94);
  const double s2_100 = R_carrier_left_aux1_y_x*s2_94;
  const double s2_101 = mbgen::fma(R_carrier_left_aux1_x_x, s2_92, s2_100);
  result.Jz[86] = -mbgen::fma(R_carrier_left_aux1_z_x, s2_93, s2_101);
  const double s2_102 = mbgen::fnma(R_carrier_left_aux2_y_y, s2_94, s1_7*s2_92);
  result.Jz[87] = mbgen::fnma(R_carrier_left_aux2_z_y, s2_93, s2_102);
  const double s2_103 = s2_70 - s2_90;
  const double s2_104 = mbgen::fma(s2_83, s2_83, mbgen::fma(s2_103, s2_103, s2_78*s2_78));
  const double s2_105 = s2_85*mbgen::fnma(s2_1, s2_82, mbgen::fma(s1_44, s2_90, s2_91));
  const double s2_106 = mbgen::fnma(3.846153846153846, s2_104, s2_105);
  const double s2_107 = mbgen::fma(s2_87, mbgen::fnma(s1_44, s2_77, s2_98), s2_106);
  result.c[6] = mbgen::fma(s2_89, mbgen::fnma(s1_48, s2_90, s2_96), s2_107);
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[11];
  const double R_arb_front_right_x_x = work.cosines[11];
  const double s2_108 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s2_109 = mbgen::fnma((-p_arb_link_front_right_from_x), R_arb_front_right_x_x,
      s2_108);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s2_110 = zd_arb_front_right*s2_109;
  const double s2_111 = (-p_arb_link_front_right_from_x)*R_arb_front_right_x_z;
  const double s2_112 = mbgen::fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s2_111);
  const double s2_113 = zd_arb_front_right*s2_112;
  const double s2_114 = p_arb_link_front_right_to_x*R_carrier_right_y_x;
  const double s2_115 = R_carrier_right_aux2_y_y + R_carrier_right_y_z;
  const double s2_116 = mbgen::fma((-p_arb_link_front_left_to_y), s2_115, s2_114);
  const double s2_117 = 0.72 + (r_carrier_right_aux1_y + s2_116);
  const double s2_118 = p_arb_link_front_right_to_x*R_carrier_right_x_x;
  const double s2_119 = R_carrier_right_x_z - s1_23;
  const double s2_120 = mbgen::fma((-p_arb_link_front_left_to_y), s2_119, s2_118);
  const double s2_121 = p_arb_link_front_right_to_x*R_carrier_right_z_x;
  const double s2_122 = R_carrier_right_aux2_z_y + R_carrier_right_z_z;
  const double s2_123 = mbgen::fma((-p_arb_link_front_left_to_y), s2_122, s2_121);
  const double s2_124 = mbgen::fnma(s2_2, s2_123, s1_56*s2_120);
  const double s2_125 = mbgen::fma(zd_lower_arm_right, work.s1_20, s2_124);
  const double s2_126 = 3.846153846153846*s2_117;
  const double s2_127 = mbgen::fnma(s1_60, s2_120, s2_2*s2_116);
  const double s2_128 = s2_110 + mbgen::fma(zd_lower_arm_right, s1_18, s2_127);
  const double s2_129 = 0.35 + (s2_109 - s2_120);
  const double s2_130 = 3.846153846153846*s2_129;
  const double s2_131 = s1_21 + s2_112 - s2_123 - (-p_arb_front_right_z);
  const double s2_132 = 3.846153846153846*s2_131;
  result.Jz[109] = mbgen::fnma(s2_109, s2_132, s2_112*s2_130);
  const double s2_133 = mbgen::fnma(s1_56, s2_116, s1_60*s2_123);
  const double s2_134 = mbgen::fnma(s2_8, s2_123, mbgen::fms(s2_12, s2_120, s2_20));
  const double s2_135 = mbgen::fma(s2_116, s2_130, s2_120*s2_126);
  const double s2_136 = mbgen::fma(s2_116, s2_132, s2_123*s2_126);
  const double s2_137 = mbgen::fnma(s2_120, s2_132, s2_123*s2_130);
  const double s2_138 = mbgen::fma(s2_8, s2_116, mbgen::fma(zd_arb_front_right, s2_113, s2_19));
  const double s2_139 = mbgen::fma(s2_2, s2_124, mbgen::fnma(s2_14, s2_120, s2_138));
  const double s2_140 = mbgen::fma(s2_14, s2_123, zd_arb_front_right*s2_110);
  const double s2_141 = mbgen::fma(s1_60, s2_127, mbgen::fnma(s2_12, s2_116, s2_140));
  result.Jz[104] = mbgen::fnma(s1_18, s2_132, mbgen::fms(work.s1_20, s2_126, s2_136));
  const double s2_142 = mbgen::fms(s2_117, s2_126, l_arb_link_front_right);
  result.Phi[7] = 0.5*mbgen::fma(s2_131, s2_132, mbgen::fma(s2_129, s2_130, s2_142));
  result.Jz[105] = mbgen::fma(R_lower_arm_right_y_y, s2_135, R_lower_arm_right_z_y*s2_137);
  const double s2_143 = R_carrier_right_aux1_z_x*s2_135;
  const double s2_144 = mbgen::fnma(R_carrier_right_aux1_y_x, s2_137, s2_143);
  result.Jz[106] = mbgen::fnma(R_carrier_right_aux1_x_x, s2_136, s2_144);
  const double s2_145 = mbgen::fnma(R_carrier_right_aux2_y_y, s2_137, s1_23*s2_136);
  result.Jz[107] = mbgen::fma(R_carrier_right_aux2_z_y, s2_135, s2_145);
  const double s2_146 = s2_113 - s2_133;
  const double s2_147 = mbgen::fma(s2_128, s2_128, mbgen::fma(s2_146, s2_146, s2_125*s2_125));
  const double s2_148 = s2_130*mbgen::fnma(s1_56, s2_124, s2_141);
  const double s2_149 = mbgen::fnma(s2_2, s2_127, mbgen::fma(s1_56, s2_133, s2_134));
  const double s2_150 = mbgen::fnma(3.846153846153846, s2_147, s2_148);
  const double s2_151 = mbgen::fnma(s2_126, s2_149, s2_150);
  result.c[7] = mbgen::fma(s2_132, mbgen::fnma(s1_60, s2_133, s2_139), s2_151);
  // drag_link
  const double s2_152 = (-p_drag_link_from_z)*work.sines[12];
  const double s2_153 = (-p_drag_link_from_z)*work.cosines[12];
  const double R_bell_crank_y_x = work.sines[13];
  const double s2_154 = p_drag_link_to_y*R_bell_crank_y_x;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s2_155 = zd_pitman_arm*s2_152;
  const double s2_156 = zd_pitman_arm*s2_153;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s2_157 = zd_bell_crank*s2_154;
  const double R_bell_crank_x_x = work.cosines[13];
  const double s2_158 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s2_159 = zd_bell_crank*s2_158;
  const double s2_160 = p_pitman_arm_y - s2_158;
  const double s2_161 = 0.8565801464479954*s2_160;
  const double s2_162 = 0.2 - s2_153;
  const double s2_163 = 0.8565801464479954*s2_162;
  const double s2_164 = 1.15 + (s2_154 - s2_152);
  const double s2_165 = 0.8565801464479954*s2_164;
  result.Jz[125] = mbgen::fma(s2_158, s2_165, s2_154*s2_161);
  result.Jz[124] = mbgen::fnma(s2_153, s2_165, s2_152*s2_163);
  const double s2_166 = mbgen::fma(s2_162, s2_163, mbgen::fms(s2_160, s2_161, l_drag_link));
  result.Phi[8] = 0.5*mbgen::fma(s2_164, s2_165, s2_166);
  const double s2_167 = s2_159 - s2_156;
  const double s2_168 = mbgen::fma(zd_pitman_arm*s2_156, s2_163, zd_bell_crank*s2_159*s2_161);
  const double s2_169 = mbgen::fnma(zd_bell_crank, s2_157, zd_pitman_arm*s2_155);
  const double s2_170 = mbgen::fma(s2_167, s2_167, mbgen::fma(s2_155, s2_155, s2_157*s2_157));
  const double s2_171 = mbgen::fma(s2_165, s2_169, s2_168);
  result.c[8] = -mbgen::fma(0.8565801464479954, s2_170, s2_171);
  // tie_rod_left
  const double s2_172 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s2_173 = (-p_tie_rod_left_from_x)*R_bell_crank_y_x;
  const double s2_174 = mbgen::fma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s2_172);
  const double s2_175 = zd_bell_crank*s2_174;
  const double s2_176 = mbgen::fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_173);
  const double s2_177 = zd_bell_crank*s2_176;
  const double s2_178 = mbgen::fms(p_tie_rod_left_to_z, R_carrier_left_z_z, s2_21);
  const double s2_179 = mbgen::fnma((-p_tie_rod_left_to_x), R_carrier_left_z_x, s2_178);
  const double s2_180 = (-p_bell_crank_z) + (r_carrier_left_aux1_z + s2_179);
  const double s2_181 = mbgen::fms(p_tie_rod_left_to_z, R_carrier_left_y_z, s2_22);
  const double s2_182 = mbgen::fnma((-p_tie_rod_left_to_x), R_carrier_left_y_x, s2_181);
  const double s2_183 = mbgen::fma(p_tie_rod_left_to_z, R_carrier_left_x_z, s2_25);
  const double s2_184 = mbgen::fnma((-p_tie_rod_left_to_x), R_carrier_left_x_x, s2_183);
  const double s2_185 = mbgen::fnma(s1_48, s2_184, s2_1*s2_182);
  const double s2_186 = mbgen::fma(zd_lower_arm_left, s1_3, s2_185);
  const double s2_187 = mbgen::fnma(s1_44, s2_182, s1_48*s2_179);
  const double s2_188 = s2_177 + s2_187;
  const double s2_189 = 1.262590031797617*s2_180;
  const double s2_190 = s2_176 - r_carrier_left_aux1_y - s2_182;
  const double s2_191 = 1.262590031797617*s2_190;
  const double s2_192 = mbgen::fnma(s2_1, s2_179, s1_44*s2_184);
  const double s2_193 = mbgen::fnma(zd_lower_arm_left, s1_5, s2_175 + s2_192);
  const double s2_194 = 0.35 + (s2_174 + s2_184);
  const double s2_195 = 1.262590031797617*s2_194;
  const double s2_196 = mbgen::fnma(s2_13, s2_184, mbgen::fms(s2_6, s2_182, s2_17));
  result.Jz[139] = mbgen::fnma(s2_174, s2_191, s2_176*s2_195);
  const double s2_197 = mbgen::fma(s2_179, s2_191, s2_182*s2_189);
  const double s2_198 = mbgen::fnma(s2_179, s2_195, s2_184*s2_189);
  const double s2_199 = mbgen::fma(s2_182, s2_195, s2_184*s2_191);
  result.Jz[126] = mbgen::fma(s1_5, s2_191, mbgen::fma(s1_3, s2_189, s2_197));
  const double s2_200 = mbgen::fma(s2_10, s2_184, mbgen::fms(zd_bell_crank, s2_177, s2_16));
  const double s2_201 = mbgen::fma(s1_44, s2_187, mbgen::fnma(s2_6, s2_179, s2_200));
  const double s2_202 = mbgen::fma(s2_180, s2_189, mbgen::fms(s2_190, s2_191, l_tie_rod_left));
  result.Phi[9] = 0.5*mbgen::fma(s2_194, s2_195, s2_202);
  result.Jz[127] = mbgen::fnma(R_lower_arm_left_y_y, s2_199, R_lower_arm_left_z_y*s2_198);
  const double s2_203 = R_carrier_left_aux1_x_x*s2_197;
  const double s2_204 = mbgen::fnma(R_carrier_left_aux1_y_x, s2_198, s2_203);
  result.Jz[128] = mbgen::fnma(R_carrier_left_aux1_z_x, s2_199, s2_204);
  const double s2_205 = mbgen::fma(s1_7, s2_197, R_carrier_left_aux2_y_y*s2_198);
  result.Jz[129] = -mbgen::fma(R_carrier_left_aux2_z_y, s2_199, s2_205);
  const double s2_206 = mbgen::fnma(s2_13, s2_179, zd_bell_crank*s2_175);
  const double s2_207 = mbgen::fnma(s1_48, s2_185, mbgen::fma(s2_10, s2_182, s2_206));
  const double s2_208 = mbgen::fma(s2_193, s2_193, mbgen::fma(s2_188, s2_188, s2_186*s2_186));
  const double s2_209 = s2_191*mbgen::fnma(s2_1, s2_185, s2_201);
  const double s2_210 = mbgen::fnma(s1_48, s2_187, mbgen::fma(s2_1, s2_192, s2_196));
  const double s2_211 = mbgen::fnma(1.262590031797617, s2_208, s2_209);
  const double s2_212 = mbgen::fnma(s2_189, s2_210, s2_211);
  result.c[9] = mbgen::fma(s2_195, mbgen::fma(s1_44, s2_192, s2_207), s2_212);
  // tie_rod_right
  const double s2_213 = mbgen::fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s2_173);
  const double s2_214 = zd_bell_crank*s2_213;
  const double s2_215 = mbgen::fnma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s2_172);
  work.s2_216 = zd_bell_crank*s2_215;
  const double s2_217 = mbgen::fma(p_tie_rod_right_to_z, R_carrier_right_z_z, s2_47);
  const double s2_218 = mbgen::fnma((-p_tie_rod_right_to_x), R_carrier_right_z_x, s2_217);
  const double s2_219 = (-p_bell_crank_z) + (s2_218 - s1_21);
  const double s2_220 = mbgen::fma(p_tie_rod_right_to_z, R_carrier_right_y_z, s2_49);
  const double s2_221 = mbgen::fnma((-p_tie_rod_right_to_x), R_carrier_right_y_x, s2_220);
  const double s2_222 = s2_213 + (r_carrier_right_aux1_y + s2_221);
  const double s2_223 = mbgen::fms(p_tie_rod_right_to_z, R_carrier_right_x_z, s2_43);
  const double s2_224 = mbgen::fnma((-p_tie_rod_right_to_x), R_carrier_right_x_x, s2_223);
  const double s2_225 = mbgen::fnma(s1_60, s2_224, s2_2*s2_221);
  work.s2_226 = mbgen::fma(zd_lower_arm_right, s1_18, s2_225);
  work.s2_227 = 1.262590031797617*s2_219;
  work.s2_228 = 1.262590031797617*s2_222;
  const double s2_229 = s2_215 - s2_224 - 0.35;
  work.s2_230 = 1.262590031797617*s2_229;
  result.Jz[153] = mbgen::fnma(s2_215, work.s2_228, s2_213*work.s2_230);
  work.s2_231 = mbgen::fnma(s2_2, s2_218, s1_56*s2_224);
  const double s2_232 = mbgen::fnma(s1_56, s2_221, s1_60*s2_218);
  const double s2_233 = mbgen::fnma(s2_14, s2_224, mbgen::fma(s2_8, s2_221, s2_19));
  work.s2_234 = mbgen::fnma(s1_60, s2_232, mbgen::fma(s2_2, work.s2_231, s2_233));
  const double s2_235 = mbgen::fma(s2_221, work.s2_230, s2_224*work.s2_228);
  const double s2_236 = mbgen::fnma(s2_221, work.s2_227, s2_218*work.s2_228);
  const double s2_237 = mbgen::fma(s2_218, work.s2_230, s2_224*work.s2_227);
  const double s2_238 = mbgen::fma(s2_14, s2_218, zd_bell_crank*work.s2_216);
  const double s2_239 = mbgen::fma(s1_60, s2_225, mbgen::fnma(s2_12, s2_221, s2_238));
  work.s2_240 = mbgen::fnma(s1_56, work.s2_231, s2_239);
  const double s2_241 = mbgen::fms(s1_18, work.s2_227, s2_236);
  result.Jz[146] = mbgen::fma(work.s1_20, work.s2_228, s2_241);
  const double s2_242 = mbgen::fms(s2_222, work.s2_228, l_tie_rod_right);
  const double s2_243 = mbgen::fma(s2_229, work.s2_230, mbgen::fma(s2_219, work.s2_227, s2_242));
  result.Phi[10] = 0.5*s2_243;
  result.Jz[147] = mbgen::fma(R_lower_arm_right_y_y, s2_235, R_lower_arm_right_z_y*s2_237);
  const double s2_244 = mbgen::fnma(s2_12, s2_224, mbgen::fma(zd_bell_crank, s2_214, s2_20));
  const double s2_245 = mbgen::fnma(s1_56, s2_232, mbgen::fma(s2_8, s2_218, s2_244));
  work.s2_246 = mbgen::fma(s2_2, s2_225, s2_245);
  const double s2_247 = R_carrier_right_aux1_z_x*s2_235;
  const double s2_248 = mbgen::fnma(R_carrier_right_aux1_y_x, s2_237, s2_247);
  result.Jz[148] = mbgen::fnma(R_carrier_right_aux1_x_x, s2_236, s2_248);
  const double s2_249 = mbgen::fnma(R_carrier_right_aux2_y_y, s2_237, s1_23*s2_236);
  result.Jz[149] = mbgen::fma(R_carrier_right_aux2_z_y, s2_235, s2_249);
  work.s2_250 = s2_214 - s2_232;
}

/// Part 2 of compute_closure_terms: step 2: closure Jacobian Phi_z and its factors (60).
[[gnu::noinline]] void compute_closure_terms_2(const State& state,
    ClosureTermsWork& __restrict work, ClosureTerms& __restrict result) noexcept {
  // --- step 2: closure Jacobian Phi_z and its factors (60), continued ---
  // tie_rod_right
  const double s2_251 = mbgen::fnma(state.zd[Coordinate::lower_arm_right], work.s1_20, work.s2_216);
  const double s2_252 = s2_251 - work.s2_231;
  const double s2_253 = mbgen::fma(work.s2_250, work.s2_250, work.s2_226*work.s2_226);
  const double s2_254 = mbgen::fma(s2_252, s2_252, s2_253);
  const double s2_255 = mbgen::fnma(1.262590031797617, s2_254, work.s2_230*work.s2_240);
  const double s2_256 = mbgen::fnma(work.s2_227, work.s2_234, s2_255);
  result.c[10] = mbgen::fma(work.s2_228, work.s2_246, s2_256);
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  const double s2_257 = mbgen::fnma(work.s1_64, work.s1_67, zd_rear_axle_rz*work.s1_68);
  const double s2_258 = mbgen::fma(work.s1_61, work.s1_66, work.s1_62*work.s1_67);
  const double s2_259 = mbgen::fma(zd_rear_axle_rz, work.s1_63, work.s1_61*work.s1_64);
  // long_rod_left
  const double s1_34 = work.sines[15];
  const double s2_260 = p_long_rod_left_to_x*s1_34;
  const double s2_261 = mbgen::fma((-p_long_rod_left_to_z), work.R_rear_axle_z_z, s2_260);
  const double s2_262 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s2_263 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_y_z, s2_262);
  const double s2_264 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_263);
  const double s2_265 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s2_266 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_x_z, s2_265);
  const double s2_267 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_266);
  const double s2_268 = mbgen::fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_261);
  const double s2_269 = (-p_long_rod_left_from_z) + (work.r_rear_axle_aux3_z + s2_268);
  const double s2_270 = (-p_long_rod_left_from_x) + (work.r_rear_axle_aux1_x + s2_267);
  const double s2_271 = mbgen::fnma(work.s1_65, s2_264, work.s1_63*s2_268);
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s2_272 = zd_rear_axle_tx + s2_271;
  const double s2_273 = mbgen::fnma(work.s1_68, s2_268, work.s1_65*s2_267);
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s2_274 = zd_rear_axle_ty + s2_273;
  const double s2_275 = mbgen::fnma(work.s1_63, s2_267, work.s1_68*s2_264);
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double s2_276 = zd_rear_axle_tz + s2_275;
  const double s2_277 = 1.1757385222540735*s2_269;
  result.Jz[156] = s2_277;
  const double s2_278 = 1.1757385222540735*s2_270;
  result.Jz[154] = s2_278;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s2_279 = p_long_rod_left_from_y - z_rear_axle_ty - s2_264;
  const double s2_280 = 1.1757385222540735*s2_279;
  result.Jz[155] = -s2_280;
  const double s2_281 = mbgen::fma(s2_257, s2_268, s2_258*s2_264);
  const double s2_282 = mbgen::fnma(s2_258, s2_267, s2_259*s2_268);
  const double s2_283 = mbgen::fma(s2_268, s2_280, s2_264*s2_277);
  const double s2_284 = mbgen::fma(s2_267, s2_280, s2_264*s2_278);
  result.Jz[157] = -s2_284;
  const double s2_285 = mbgen::fnma(work.s1_63, s2_271, work.s1_68*s2_273);
  const double s2_286 = mbgen::fnma(s2_268, s2_278, s2_267*s2_277);
  const double s2_287 = mbgen::fma(s2_269, s2_277, mbgen::fms(s2_279, s2_280, l_long_rod_left));
  result.Phi[11] = 0.5*mbgen::fma(s2_270, s2_278, s2_287);
  const double R_rear_axle_aux4_y_x = work.sines[14];
  const double R_rear_axle_aux4_x_x = work.cosines[14];
  result.Jz[158] = -mbgen::fma(R_rear_axle_aux4_x_x, s2_286, R_rear_axle_aux4_y_x*s2_283);
  const double s2_288 = mbgen::fnma(work.R_rear_axle_aux5_y_x, s2_286, s1_34*s2_284);
  result.Jz[159] = mbgen::fma(work.R_rear_axle_aux5_x_x, s2_283, s2_288);
  const double s2_289 = mbgen::fnma(work.s1_68, s2_275, mbgen::fma(work.s1_65, s2_271, s2_282));
  const double s2_290 = mbgen::fma(s2_276, s2_276, mbgen::fma(s2_272, s2_272, s2_274*s2_274));
  const double s2_291 = mbgen::fnma(s2_257, s2_267, mbgen::fnma(s2_259, s2_264, s2_285));
  const double s2_292 = mbgen::fnma(1.1757385222540735, s2_290, s2_280*s2_289);
  const double s2_293 = mbgen::fnma(work.s1_65, s2_273, mbgen::fma(work.s1_63, s2_275, s2_281));
  result.c[11] = mbgen::fnma(s2_278, s2_293, mbgen::fnma(s2_277, s2_291, s2_292));
  // diag_rod_left
  const double s2_294 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  const double s2_295 = mbgen::fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_294);
  const double s2_296 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  const double s2_297 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_296);
  const double s2_298 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  const double s2_299 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s2_298);
  const double s2_300 = (-p_diag_rod_left_from_z) + (work.r_rear_axle_aux3_z + s2_299);
  const double s2_301 = (-p_diag_rod_left_from_x) + (work.r_rear_axle_aux1_x + s2_295);
  const double s2_302 = mbgen::fnma(work.s1_65, s2_297, work.s1_63*s2_299);
  const double s2_303 = zd_rear_axle_tx + s2_302;
  const double s2_304 = mbgen::fnma(work.s1_68, s2_299, work.s1_65*s2_295);
  const double s2_305 = zd_rear_axle_ty + s2_304;
  const double s2_306 = mbgen::fnma(work.s1_63, s2_295, work.s1_68*s2_297);
  const double s2_307 = zd_rear_axle_tz + s2_306;
  const double s2_308 = 1.162476387438193*s2_300;
  result.Jz[164] = s2_308;
  const double s2_309 = 1.162476387438193*s2_301;
  result.Jz[162] = s2_309;
  const double s2_310 = p_diag_rod_left_from_y - z_rear_axle_ty - s2_297;
  const double s2_311 = 1.162476387438193*s2_310;
  result.Jz[163] = -s2_311;
  const double s2_312 = mbgen::fma(s2_257, s2_299, s2_258*s2_297);
  const double s2_313 = mbgen::fnma(s2_258, s2_295, s2_259*s2_299);
  const double s2_314 = mbgen::fma(s2_299, s2_311, s2_297*s2_308);
  const double s2_315 = mbgen::fma(s2_295, s2_311, s2_297*s2_309);
  result.Jz[165] = -s2_315;
  const double s2_316 = mbgen::fnma(work.s1_63, s2_302, work.s1_68*s2_304);
  const double s2_317 = mbgen::fnma(s2_299, s2_309, s2_295*s2_308);
  const double s2_318 = mbgen::fma(s2_300, s2_308, mbgen::fms(s2_310, s2_311, l_diag_rod_left));
  result.Phi[12] = 0.5*mbgen::fma(s2_301, s2_309, s2_318);
  result.Jz[166] = -mbgen::fma(R_rear_axle_aux4_x_x, s2_317, R_rear_axle_aux4_y_x*s2_314);
  const double s2_319 = mbgen::fnma(work.R_rear_axle_aux5_y_x, s2_317, s1_34*s2_315);
  result.Jz[167] = mbgen::fma(work.R_rear_axle_aux5_x_x, s2_314, s2_319);
  const double s2_320 = mbgen::fnma(work.s1_68, s2_306, mbgen::fma(work.s1_65, s2_302, s2_313));
  const double s2_321 = mbgen::fma(s2_307, s2_307, mbgen::fma(s2_303, s2_303, s2_305*s2_305));
  const double s2_322 = mbgen::fnma(s2_257, s2_295, mbgen::fnma(s2_259, s2_297, s2_316));
  const double s2_323 = mbgen::fnma(1.162476387438193, s2_321, s2_311*s2_320);
  const double s2_324 = mbgen::fnma(work.s1_65, s2_304, mbgen::fma(work.s1_63, s2_306, s2_312));
  result.c[12] = mbgen::fnma(s2_309, s2_324, mbgen::fnma(s2_308, s2_322, s2_323));
  // arb_link_rear_left
  const double s2_325 = p_arb_link_rear_left_from_x*work.sines[17];
  const double s2_326 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_y_x;
  const double s2_327 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_y_z, s2_326);
  const double s2_328 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_x_x;
  const double s2_329 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_x_z, s2_328);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s2_330 = zd_arb_rear_left*s2_325;
  const double s2_331 = p_arb_link_rear_left_from_x*work.cosines[17];
  const double s2_332 = zd_arb_rear_left*s2_331;
  const double s2_333 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_327);
  const double s2_334 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_329);
  const double s2_335 = (-p_arb_link_rear_left_to_x)*s1_34;
  const double s2_336 = mbgen::fnma((-p_arb_link_rear_left_to_z), work.R_rear_axle_z_z, s2_335);
  const double s2_337 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_336);
  const double s2_338 = (-p_arb_rear_left_z) + (s2_325 + (work.r_rear_axle_aux3_z + s2_337));
  const double s2_339 = mbgen::fnma(work.s1_68, s2_337, work.s1_65*s2_334);
  const double s2_340 = zd_rear_axle_ty + s2_339;
  const double s2_341 = 4.47213595499958*s2_338;
  result.Jz[172] = s2_341;
  const double s2_342 = 0.6 - z_rear_axle_ty - s2_333;
  const double s2_343 = 4.47213595499958*s2_342;
  result.Jz[171] = -s2_343;
  const double s2_344 = s2_331 - work.r_rear_axle_aux1_x - s2_334 - (-p_arb_rear_left_x);
  const double s2_345 = 4.47213595499958*s2_344;
  result.Jz[170] = -s2_345;
  const double s2_346 = mbgen::fnma(work.s1_65, s2_333, work.s1_63*s2_337);
  const double s2_347 = s2_330 + (zd_rear_axle_tx + s2_346);
  const double s2_348 = mbgen::fnma(work.s1_63, s2_334, work.s1_68*s2_333);
  const double s2_349 = s2_332 + (zd_rear_axle_tz + s2_348);
  result.Jz[176] = mbgen::fnma(s2_325, s2_345, s2_331*s2_341);
  const double s2_350 = mbgen::fnma(s2_258, s2_334, s2_259*s2_337);
  const double s2_351 = mbgen::fma(s2_337, s2_343, s2_333*s2_341);
  const double s2_352 = mbgen::fnma(s2_333, s2_345, s2_334*s2_343);
  result.Jz[173] = -s2_352;
  const double s2_353 = mbgen::fma(s2_337, s2_345, s2_334*s2_341);
  const double s2_354 = mbgen::fma(s2_258, s2_333, zd_arb_rear_left*s2_332);
  const double s2_355 = mbgen::fma(work.s1_63, s2_348, mbgen::fma(s2_257, s2_337, s2_354));
  const double s2_356 = mbgen::fms(s2_342, s2_343, l_arb_link_rear_left);
  result.Phi[13] = 0.5*mbgen::fma(s2_344, s2_345, mbgen::fma(s2_338, s2_341, s2_356));
  result.Jz[174] = -mbgen::fma(R_rear_axle_aux4_x_x, s2_353, R_rear_axle_aux4_y_x*s2_351);
  const double s2_357 = mbgen::fnma(work.s1_68, s2_339, zd_arb_rear_left*s2_330);
  const double s2_358 = mbgen::fma(s2_259, s2_333, mbgen::fma(work.s1_63, s2_346, s2_357));
  const double s2_359 = mbgen::fnma(work.R_rear_axle_aux5_y_x, s2_353, s1_34*s2_352);
  result.Jz[175] = mbgen::fma(work.R_rear_axle_aux5_x_x, s2_351, s2_359);
  const double s2_360 = mbgen::fnma(work.s1_68, s2_348, mbgen::fma(work.s1_65, s2_346, s2_350));
  const double s2_361 = mbgen::fma(s2_349, s2_349, mbgen::fma(s2_347, s2_347, s2_340*s2_340));
  const double s2_362 = mbgen::fnma(4.47213595499958, s2_361, s2_343*s2_360);
  const double s2_363 = mbgen::fma(s2_341, mbgen::fma(s2_257, s2_334, s2_358), s2_362);
  result.c[13] = mbgen::fma(s2_345, mbgen::fnma(work.s1_65, s2_339, s2_355), s2_363);
  // long_rod_right
  const double s2_364 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s2_261);
  const double s2_365 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s2_263);
  const double s2_366 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s2_266);
  const double s2_367 = (-p_long_rod_right_from_y) + (z_rear_axle_ty + s2_365);
  const double s2_368 = (-p_long_rod_right_from_z) + (work.r_rear_axle_aux3_z - s2_364);
  const double s2_369 = (-p_long_rod_right_from_x) + (work.r_rear_axle_aux1_x + s2_366);
  const double s2_370 = mbgen::fma(work.s1_65, s2_365, work.s1_63*s2_364);
  const double s2_371 = mbgen::fma(work.s1_65, s2_366, work.s1_68*s2_364);
  const double s2_372 = zd_rear_axle_ty + s2_371;
  const double s2_373 = mbgen::fnma(work.s1_63, s2_366, work.s1_68*s2_365);
  const double s2_374 = zd_rear_axle_tz + s2_373;
  const double s2_375 = zd_rear_axle_tx - s2_370;
  const double s2_376 = 1.1757385222540735*s2_367;
  result.Jz[179] = s2_376;
  const double s2_377 = 1.1757385222540735*s2_368;
  result.Jz[180] = s2_377;
  const double s2_378 = 1.1757385222540735*s2_369;
  result.Jz[178] = s2_378;
  const double s2_379 = mbgen::fma(s2_259, s2_364, s2_258*s2_366);
  const double s2_380 = mbgen::fnma(s2_257, s2_364, s2_258*s2_365);
  const double s2_381 = mbgen::fma(s2_364, s2_376, s2_365*s2_377);
  const double s2_382 = mbgen::fma(work.s1_68, s2_371, work.s1_63*s2_370);
  const double s2_383 = mbgen::fnma(s2_366, s2_376, s2_365*s2_378);
  result.Jz[181] = -s2_383;
  const double s2_384 = mbgen::fma(s2_364, s2_378, s2_366*s2_377);
  const double s2_385 = mbgen::fma(s2_368, s2_377, mbgen::fms(s2_367, s2_376, l_long_rod_right));
  result.Phi[14] = 0.5*mbgen::fma(s2_369, s2_378, s2_385);
  result.Jz[182] = -mbgen::fma(R_rear_axle_aux4_x_x, s2_384, R_rear_axle_aux4_y_x*s2_381);
  const double s2_386 = mbgen::fnma(work.R_rear_axle_aux5_y_x, s2_384, s1_34*s2_383);
  result.Jz[183] = mbgen::fma(work.R_rear_axle_aux5_x_x, s2_381, s2_386);
  const double s2_387 = mbgen::fma(work.s1_68, s2_373, mbgen::fma(work.s1_65, s2_370, s2_379));
  const double s2_388 = mbgen::fma(s2_375, s2_375, mbgen::fma(s2_374, s2_374, s2_372*s2_372));
  const double s2_389 = mbgen::fnma(s2_257, s2_366, mbgen::fnma(s2_259, s2_365, s2_382));
  const double s2_390 = mbgen::fnma(1.1757385222540735, s2_388, s2_376*s2_387);
  const double s2_391 = mbgen::fnma(work.s1_65, s2_371, mbgen::fma(work.s1_63, s2_373, s2_380));
  result.c[14] = mbgen::fnma(s2_378, s2_391, mbgen::fnma(s2_377, s2_389, s2_390));
  // diag_rod_right
  const double s2_392 = mbgen::fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s2_294);
  const double s2_393 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s2_296);
  const double s2_394 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s2_298);
  const double s2_395 = (-p_diag_rod_right_from_z) + (work.r_rear_axle_aux3_z + s2_394);
  const double s2_396 = (-p_diag_rod_right_from_y) + (z_rear_axle_ty + s2_393);
  const double s2_397 = (-p_diag_rod_right_from_x) + (work.r_rear_axle_aux1_x + s2_392);
  const double s2_398 = mbgen::fnma(work.s1_65, s2_393, work.s1_63*s2_394);
  const double s2_399 = zd_rear_axle_tx + s2_398;
  const double s2_400 = mbgen::fnma(work.s1_68, s2_394, work.s1_65*s2_392);
  const double s2_401 = zd_rear_axle_ty + s2_400;
  const double s2_402 = mbgen::fnma(work.s1_63, s2_392, work.s1_68*s2_393);
  const double s2_403 = zd_rear_axle_tz + s2_402;
  const double s2_404 = 1.162476387438193*s2_395;
  result.Jz[188] = s2_404;
  const double s2_405 = 1.162476387438193*s2_396;
  result.Jz[187] = s2_405;
  const double s2_406 = 1.162476387438193*s2_397;
  result.Jz[186] = s2_406;
  const double s2_407 = mbgen::fma(s2_257, s2_394, s2_258*s2_393);
  const double s2_408 = mbgen::fnma(s2_258, s2_392, s2_259*s2_394);
  const double s2_409 = mbgen::fnma(work.s1_63, s2_398, work.s1_68*s2_400);
  const double s2_410 = mbgen::fnma(s2_392, s2_405, s2_393*s2_406);
  result.Jz[189] = -s2_410;
  const double s2_411 = mbgen::fnma(s2_394, s2_406, s2_392*s2_404);
  const double s2_412 = mbgen::fnma(s2_393, s2_404, s2_394*s2_405);
  const double s2_413 = mbgen::fma(s2_395, s2_404, mbgen::fms(s2_396, s2_405, l_diag_rod_right));
  result.Phi[15] = 0.5*mbgen::fma(s2_397, s2_406, s2_413);
  result.Jz[190] = mbgen::fnma(R_rear_axle_aux4_x_x, s2_411, R_rear_axle_aux4_y_x*s2_412);
  const double s2_414 = mbgen::fnma(work.R_rear_axle_aux5_y_x, s2_411, s1_34*s2_410);
  result.Jz[191] = mbgen::fnma(work.R_rear_axle_aux5_x_x, s2_412, s2_414);
  const double s2_415 = mbgen::fma(s2_403, s2_403, mbgen::fma(s2_399, s2_399, s2_401*s2_401));
  const double s2_416 = mbgen::fnma(work.s1_68, s2_402, mbgen::fma(work.s1_65, s2_398, s2_408));
  const double s2_417 = mbgen::fnma(s2_257, s2_392, mbgen::fnma(s2_259, s2_393, s2_409));
  const double s2_418 = mbgen::fma(s2_405, s2_416, 1.162476387438193*s2_415);
  const double s2_419 = mbgen::fnma(work.s1_65, s2_400, mbgen::fma(work.s1_63, s2_402, s2_407));
  result.c[15] = -mbgen::fma(s2_406, s2_419, mbgen::fma(s2_404, s2_417, s2_418));
  // arb_link_rear_right
  const double s2_420 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s2_327);
  const double s2_421 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s2_329);
  const double s2_422 = p_arb_link_rear_right_from_x*work.sines[18];
  const double s2_423 = mbgen::fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s2_336);
  const double s2_424 = 0.6 + (z_rear_axle_ty - s2_420);
  const double s2_425 = mbgen::fma(work.s1_68, s2_423, work.s1_65*s2_421);
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s2_426 = zd_arb_rear_right*s2_422;
  const double s2_427 = p_arb_link_rear_right_from_x*work.cosines[18];
  const double s2_428 = zd_arb_rear_right*s2_427;
  const double s2_429 = (-p_arb_rear_right_z) + (s2_422 + (work.r_rear_axle_aux3_z + s2_423));
  const double s2_430 = zd_rear_axle_ty - s2_425;
  const double s2_431 = 4.47213595499958*s2_424;
  result.Jz[195] = s2_431;
  const double s2_432 = mbgen::fma(work.s1_63, s2_423, work.s1_65*s2_420);
  const double s2_433 = s2_426 + (zd_rear_axle_tx + s2_432);
  const double s2_434 = mbgen::fnma(work.s1_68, s2_420, work.s1_63*s2_421);
  const double s2_435 = s2_428 + (zd_rear_axle_tz + s2_434);
  const double s2_436 = 4.47213595499958*s2_429;
  result.Jz[196] = s2_436;
  const double s2_437 = s2_421 + s2_427 - work.r_rear_axle_aux1_x - (-p_arb_rear_right_x);
  const double s2_438 = 4.47213595499958*s2_437;
  result.Jz[194] = -s2_438;
  const double s2_439 = mbgen::fma(s2_258, s2_421, s2_259*s2_423);
  result.Jz[201] = mbgen::fnma(s2_422, s2_438, s2_427*s2_436);
  const double s2_440 = mbgen::fma(s2_257, s2_423, zd_arb_rear_right*s2_428);
  const double s2_441 = mbgen::fma(work.s1_65, s2_425, mbgen::fnma(s2_258, s2_420, s2_440));
  const double s2_442 = mbgen::fma(s2_421, s2_431, s2_420*s2_438);
  result.Jz[197] = -s2_442;
  const double s2_443 = mbgen::fnma(s2_421, s2_436, s2_423*s2_438);
  const double s2_444 = mbgen::fma(s2_420, s2_436, s2_423*s2_431);
  const double s2_445 = mbgen::fnma(s2_257, s2_421, zd_arb_rear_right*s2_426);
  const double s2_446 = mbgen::fma(work.s1_68, s2_425, mbgen::fnma(s2_259, s2_420, s2_445));
  const double s2_447 = mbgen::fms(s2_424, s2_431, l_arb_link_rear_right);
  result.Phi[16] = 0.5*mbgen::fma(s2_437, s2_438, mbgen::fma(s2_429, s2_436, s2_447));
  result.Jz[198] = mbgen::fnma(R_rear_axle_aux4_x_x, s2_443, R_rear_axle_aux4_y_x*s2_444);
  const double s2_448 = mbgen::fnma(work.R_rear_axle_aux5_y_x, s2_443, s1_34*s2_442);
  result.Jz[199] = mbgen::fnma(work.R_rear_axle_aux5_x_x, s2_444, s2_448);
  const double s2_449 = mbgen::fma(s2_435, s2_435, mbgen::fma(s2_433, s2_433, s2_430*s2_430));
  const double s2_450 = s2_436*mbgen::fma(work.s1_63, s2_432, s2_446);
  const double s2_451 = mbgen::fnma(work.s1_68, s2_434, mbgen::fma(work.s1_65, s2_432, s2_439));
  const double s2_452 = mbgen::fnma(4.47213595499958, s2_449, s2_450);
  const double s2_453 = mbgen::fma(work.s1_63, s2_434, s2_441);
  result.c[16] = mbgen::fma(s2_438, s2_453, mbgen::fnma(s2_431, s2_451, s2_452));
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
      R_carrier_right_aux1_y_x, R_carrier_right_aux1_z_x, s1_23, r_carrier_right_aux1_y, s1_25,
      s1_26, s1_28, R_carrier_right_aux2_y_y, R_carrier_right_aux2_z_y, R_carrier_right_x_x,
      R_carrier_right_x_z, R_carrier_right_y_x, R_carrier_right_y_z, R_carrier_right_z_x,
      R_carrier_right_z_z, r_rear_axle_aux1_x, r_rear_axle_aux3_z, R_rear_axle_aux5_x_x,
      R_rear_axle_aux5_y_x, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y, R_rear_axle_y_z,
      R_rear_axle_z_y, R_rear_axle_z_z, s5_1, w_chassis_x, s5_2, s5_3, w_chassis_y, s5_4, s5_5,
      w_chassis_z, s5_6, s5_7, s5_8, s5_9, s5_10, s5_11, s5_12, s5_13, s5_14, s5_15, s5_16, s5_17,
      s5_18, s5_19, s5_25, s5_27, s5_28, s5_29, s5_30, s5_31, s5_70, s4_1, s4_2, s4_3, s4_4, s4_5,
      s4_6, s4_7, s4_8, s4_9, s4_10, s4_11, s4_12, s4_13, s4_14, s4_15, s4_16, s4_17, s4_18, s4_19,
      w_carrier_left_x, w_carrier_left_y, w_carrier_left_z, w_carrier_right_x, w_carrier_right_y,
      w_carrier_right_z, w_rear_axle_x, w_rear_axle_y, w_rear_axle_z, s7_3, s7_6, s7_9, s7_11,
      s7_13, s7_16, s7_19, s7_22, s7_25, s7_28, s7_31, s7_34, s7_36, s8_14, s8_15, s8_16, s3_2,
      s3_4, s3_5, s3_6, s3_8, s3_10, s6_4, s6_8, s6_12, s7_38, s7_40, s7_41, s7_52, s7_59, s7_61,
      s7_63, s7_65, s7_66, s7_67, s7_68, s7_69, s7_70, s7_71, s7_74, s7_75, s7_76, s7_77, s7_79,
      s7_80, s7_81, s7_82, s7_85, s7_86, s7_87, s7_88, s8_17, s8_18, s8_19, s8_20, s8_21, s8_22,
      s8_25, s8_26, s8_27, s8_28, s8_29, s8_30, s8_31, s8_33, s8_34, s8_35, s8_37, s8_39, s8_40,
      s8_41, s8_44, s8_47, s8_48, s8_49, s8_50, s8_51, s8_53, s8_54, s8_55, s8_56, s8_58, s8_59,
      s8_60, s8_61, s8_63, s8_64, s8_65, s8_66, s8_70, s8_72, s8_73, s8_74, s8_75, s8_76, s8_77,
      s8_85, s8_88, s8_101, s8_126, s8_127, s8_128, s8_133, s8_138, s8_154, s8_176, s8_177, s8_178,
      s8_447, s8_466, s8_471, s8_484, s8_496, s8_508, s8_512, s8_516, s8_520, s8_554, s8_629,
      s8_630, s8_633, s8_634, s8_635, s8_636, s8_637, s8_639, s8_640, s8_653, s8_654, s8_666,
      s8_667, s8_680, s8_681, s8_682, s8_698, s8_701, s8_702, s8_705, s8_706, s8_709, s8_710,
      s8_730, s8_731, s8_752, s8_753, s8_768, s8_769, s8_770, s8_771, s8_772, s8_773, s8_774,
      s8_775, s8_776, s8_777, s8_778, s8_779, s8_780, s8_781, s8_782, s8_783, s8_784, s8_785,
      s8_786, s8_787, s8_788, s8_789, s3_12, s3_14, s3_16, s3_18, s3_20, s3_22, s3_25, s3_28, s3_31,
      s3_34, s3_37, s3_40, s3_43, s3_46, s3_49, s3_52, s3_55, s3_58, s6_13, s6_14, s6_15, s6_18,
      s6_19, s6_40, s6_47, s6_53, s6_59, s7_91, s7_93, s7_98, s7_99, s7_100, s7_101, s7_102, s7_105,
      s7_108, s7_111, s7_126, s7_135, s7_138, s7_141, s7_144, s7_145, s7_146, s7_148, s7_150,
      s7_155, s7_156, s7_157, s7_158, s7_161, s7_163, s7_165, s7_167, s7_172, s7_173, s7_174,
      s7_175, s7_178, s7_180, s7_185, s7_186, s7_187, s7_188, s7_192, s7_195, s7_198, s7_213,
      s7_222, s7_225, s7_227, s7_230, s7_231, s7_234, s7_236, s7_241, s7_242, s7_243, s7_244,
      s7_247, s7_249, s7_251, s7_253, s7_258, s7_259, s7_260, s7_261, s7_263, s7_264, s7_267,
      s7_268, s7_269, s7_270, s7_273, s7_278, s7_280, s7_281, s7_284, s7_285, s7_286, s8_820,
      s8_821, s8_822, s8_823, s8_824, s8_825, s8_826, s8_827, s8_828, s8_829, s8_830, s8_831,
      s8_832, s8_833, s8_834, s8_835, s8_836, s8_837, s8_838, s8_839, s8_840, s8_841, s8_842,
      s8_843, s8_844, s8_845, s8_846, s8_848, s8_849, s8_850, s8_852, s8_853, s8_854, s8_855,
      s8_856, s8_857, s8_858, s8_859, s8_860, s8_861, s8_862, s8_863, s8_864, s8_865, s8_866,
      s8_867, s8_869, s8_870, s8_871, s8_873, s8_874, s8_875, s8_876, s8_877, s8_878, s8_879,
      s8_881, s8_883, s8_884, s8_885, s8_886, s8_887, s8_888, s8_889, s8_890, s8_892, s8_893,
      s8_895, s8_896, s8_897, s8_898, s8_899, s8_900, s8_901, s8_902, s8_904, s8_906, s8_908,
      s8_909, s8_910, s8_911, s8_912, s8_913, s8_916, s8_917, s8_919, s8_920, s8_921, s8_922,
      s8_923, s8_924, s8_925, s8_928, s8_931, s8_932, s8_933, s8_939, s8_942, f_carrier_right_x,
      s8_955, f_carrier_right_y, f_carrier_right_z, n_carrier_right_x, n_carrier_right_y,
      n_carrier_right_z, s8_984, s8_985, s8_986, s8_987, s8_989, s8_991, s8_993, s8_995, s8_997,
      s8_999, s8_1000, s8_1001, s8_1002, s8_1006, s8_1009, s8_1012, s8_1016, s8_1019, s8_1022,
      s8_1027, s8_1031, s8_1035, s8_1036, s8_1037, s8_1038, s8_1039, s8_1040, s8_1041, s8_1042,
      s8_1044, s8_1045, s8_1046, s8_1047, s8_1049, s8_1050, s8_1051, s8_1052, s8_1053, s8_1054,
      s8_1055, s8_1056, s8_1057, s8_1058, s8_1059, s8_1060, s8_1061, s8_1062, s8_1064, s8_1065,
      s8_1066, s8_1067, s8_1068, s8_1069, s8_1071, s8_1072, s8_1074, s8_1075, s8_1076, s8_1078,
      s8_1079, s8_1081, s8_1082, s8_1083, s8_1084, s8_1085, s8_1086, s8_1087, s8_1088, s8_1089,
      s8_1090, s8_1091, s8_1097, s8_1100, f_carrier_left_x, s8_1112, f_carrier_left_y,
      f_carrier_left_z, n_carrier_left_x, n_carrier_left_y, n_carrier_left_z, s8_1145, s8_1146,
      s8_1147, s8_1149, s8_1151, s8_1153, s8_1155, s8_1157, s8_1159, s8_1161, s8_1162, s8_1163,
      s8_1164, s8_1165, s8_1166, s8_1170, s8_1173, s8_1176, s8_1180, s8_1183, s8_1191, s8_1195,
      s8_1201, s8_1206, s8_1210, s8_1214, s8_1215, s8_1216, s8_1218, s8_1219, s8_1221, s8_1223,
      s8_1241, s8_1243, s8_1246, s8_1247, s8_1251, s8_1252, s8_1253, s8_1254, s8_1259, s8_1262,
      s8_1267, s8_1269, s8_1282, s8_1292, s8_1304, s8_1314, s8_1324, s8_1326, s8_1329, s8_1330,
      s8_1331, s8_1332, s8_1333, s8_1338, s8_1341, s8_1346, s8_1348, s8_1362, s8_1371, s8_1383,
      s8_1392, s8_1393, s8_1395, s8_1396, s8_1398, s8_1399, s8_1400, s8_1401, s8_1402, s8_1403,
      s8_1404, s8_1405, s8_1410, s8_1424, s8_1431, s8_1437, s8_1447, s8_1457, s8_1459, s8_1465,
      s8_1467, s8_1470, s8_1471, s8_1472, s8_1473, s8_1478, s8_1481, s8_1485, s8_1494, s8_1503,
      s8_1514, s8_1522, s8_1526, s8_1533, s8_1535, s8_1538, s8_1539, s8_1540, s8_1541, s8_1543,
      s8_1545, s8_1569, s8_1574, s8_1577, s8_1603, s8_1632, s8_1664, s8_1695, s8_1726, s8_1757,
      s8_1784, s8_1795, s8_1804, s8_1815, s8_1820, s8_1825, s8_1832, s8_1837, s8_1842, s8_1849,
      s8_1854, s8_1859, s8_1860, s8_1861, s8_1862, s8_1863, s8_1897, s8_1899, s8_1908, s8_1914,
      s8_1923, s8_1926, s8_1927, s8_1930, s8_1940, s8_1949, s8_1958, s8_1960, s8_1966, s8_1969,
      s8_1972, s8_1980, s8_1988, s8_1989, s8_1990;
};

/// Part 1 of compute_chosen_accelerations: step 1: poses and axes b; step 5: applied forces Q (48);
/// step 4: velocities; step 7: inertias of the bodies and forces on joints; step 8: elimination
/// from the leaves to the root (63); step 3: Rz (61), long_rod_left .. arb_link_rear_right; step 6:
/// c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right; step 7: inertias of the bodies and
/// forces on joints, long_rod_left .. arb_link_rear_right; step 8: elimination from the leaves to
/// the root (63), long_rod_left .. arb_link_rear_right.
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
  work.R_chassis_x_y = mbgen::fnma(R_chassis_aux4_y_x, s1_4, R_chassis_aux4_x_x*s1_3);
  const double s1_5 = s1_1*s1_4;
  work.R_chassis_x_z = mbgen::fma(R_chassis_aux4_x_x, s1_5, R_chassis_aux4_y_x*s1_2);
  work.R_chassis_y_y = mbgen::fma(R_chassis_aux4_y_x, s1_3, R_chassis_aux4_x_x*s1_4);
  work.R_chassis_y_z = mbgen::fnma(R_chassis_aux4_x_x, s1_2, R_chassis_aux4_y_x*s1_5);
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
  const double s1_7 = (-p_carrier_left_rz_z)*R_lower_arm_left_z_y;
  work.s1_8 = mbgen::fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_7);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + work.s1_8;
  const double s1_9 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  work.s1_10 = mbgen::fnma((-p_carrier_left_rz_z), R_lower_arm_left_y_y, s1_9);
  work.r_carrier_left_aux1_z = work.s1_10 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_11 = work.cosines[5];
  work.s1_12 = s1_6*s1_11;
  const double s1_13 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_6*s1_13;
  work.R_carrier_left_aux2_y_y = mbgen::fnma(R_lower_arm_left_z_y, s1_13,
      R_carrier_left_aux1_y_y*s1_11);
  const double s1_14 = mbgen::fma(R_carrier_left_aux1_y_y, s1_13, R_lower_arm_left_z_y*s1_11);
  work.R_carrier_left_aux2_z_y = mbgen::fma(R_carrier_left_aux1_z_y, s1_11,
      R_lower_arm_left_y_y*s1_13);
  const double R_carrier_left_aux2_z_z = mbgen::fnma(R_carrier_left_aux1_z_y, s1_13,
      R_lower_arm_left_y_y*s1_11);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_15 = work.cosines[6];
  const double s1_16 = work.sines[6];
  const double s1_17 = R_carrier_left_aux1_x_x*s1_15;
  work.R_carrier_left_x_x = mbgen::fnma(R_carrier_left_aux2_x_z, s1_16, s1_17);
  const double s1_18 = R_carrier_left_aux1_x_x*s1_16;
  work.R_carrier_left_x_z = mbgen::fma(R_carrier_left_aux2_x_z, s1_15, s1_18);
  work.R_carrier_left_y_x = mbgen::fma(s1_14, s1_16, work.R_carrier_left_aux1_y_x*s1_15);
  work.R_carrier_left_y_z = mbgen::fnma(s1_14, s1_15, work.R_carrier_left_aux1_y_x*s1_16);
  const double s1_19 = work.R_carrier_left_aux1_z_x*s1_15;
  work.R_carrier_left_z_x = mbgen::fnma(R_carrier_left_aux2_z_z, s1_16, s1_19);
  const double s1_20 = work.R_carrier_left_aux1_z_x*s1_16;
  work.R_carrier_left_z_z = mbgen::fma(R_carrier_left_aux2_z_z, s1_15, s1_20);
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_21 = work.sines[10];
  work.R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_21;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[9];
  work.R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_21;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_22 = (-p_carrier_right_rz_z)*R_lower_arm_right_z_y;
  work.s1_23 = mbgen::fnma((-p_carrier_right_rz_y), R_lower_arm_right_y_y, s1_22);
  work.r_carrier_right_aux1_y = work.s1_23 - (-p_lower_arm_right_y);
  const double s1_24 = (-p_carrier_right_rz_y)*R_lower_arm_right_z_y;
  work.s1_25 = mbgen::fma((-p_carrier_right_rz_z), R_lower_arm_right_y_y, s1_24);
  work.s1_26 = (-p_lower_arm_right_z) + work.s1_25;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_27 = work.cosines[11];
  work.s1_28 = s1_21*s1_27;
  const double s1_29 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_21*s1_29;
  const double s1_30 = R_carrier_right_aux1_y_y*s1_27;
  work.R_carrier_right_aux2_y_y = mbgen::fnma(R_lower_arm_right_z_y, s1_29, s1_30);
  const double s1_31 = mbgen::fma(R_carrier_right_aux1_y_y, s1_29, R_lower_arm_right_z_y*s1_27);
  work.R_carrier_right_aux2_z_y = mbgen::fma(R_carrier_right_aux1_z_y, s1_27,
      R_lower_arm_right_y_y*s1_29);
  const double s1_32 = R_lower_arm_right_y_y*s1_27;
  const double R_carrier_right_aux2_z_z = mbgen::fnma(R_carrier_right_aux1_z_y, s1_29, s1_32);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_33 = work.cosines[12];
  const double s1_34 = work.sines[12];
  const double s1_35 = R_carrier_right_aux1_x_x*s1_33;
  work.R_carrier_right_x_x = mbgen::fnma(R_carrier_right_aux2_x_z, s1_34, s1_35);
  const double s1_36 = R_carrier_right_aux1_x_x*s1_34;
  work.R_carrier_right_x_z = mbgen::fma(R_carrier_right_aux2_x_z, s1_33, s1_36);
  work.R_carrier_right_y_x = mbgen::fma(s1_31, s1_34, work.R_carrier_right_aux1_y_x*s1_33);
  work.R_carrier_right_y_z = mbgen::fnma(s1_31, s1_33, work.R_carrier_right_aux1_y_x*s1_34);
  const double s1_37 = work.R_carrier_right_aux1_z_x*s1_33;
  work.R_carrier_right_z_x = mbgen::fnma(R_carrier_right_aux2_z_z, s1_34, s1_37);
  const double s1_38 = work.R_carrier_right_aux1_z_x*s1_34;
  work.R_carrier_right_z_z = mbgen::fma(R_carrier_right_aux2_z_z, s1_33, s1_38);
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.r_rear_axle_aux3_z = state.z[Coordinate::rear_axle_tz] - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_39 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_39;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_39;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_40 = work.sines[19];
  const double s1_41 = work.cosines[19];
  work.R_rear_axle_x_y = mbgen::fnma(R_rear_axle_aux4_y_x, s1_41, R_rear_axle_aux5_x_z*s1_40);
  work.R_rear_axle_x_z = mbgen::fma(R_rear_axle_aux5_x_z, s1_41, R_rear_axle_aux4_y_x*s1_40);
  work.R_rear_axle_y_y = mbgen::fma(R_rear_axle_aux5_y_z, s1_40, R_rear_axle_aux4_x_x*s1_41);
  work.R_rear_axle_y_z = mbgen::fnma(R_rear_axle_aux4_x_x, s1_40, R_rear_axle_aux5_y_z*s1_41);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_40;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_41;
  // operations: 38 add, 88 multiply, 44 sin cos

  // --- step 5: applied forces Q (48) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  work.s5_1 = zd_chassis_rz*s1_1;
  work.w_chassis_x = state.zd[Coordinate::chassis_rx] - work.s5_1;
  work.s5_2 = zd_chassis_rz*work.R_chassis_z_y;
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.s5_3 = zd_chassis_ry*s1_4;
  work.w_chassis_y = work.s5_2 + work.s5_3;
  work.s5_4 = zd_chassis_rz*work.R_chassis_z_z;
  work.s5_5 = zd_chassis_ry*s1_2;
  work.w_chassis_z = work.s5_4 - work.s5_5;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  work.s5_6 = zd_carrier_left_rz*R_lower_arm_left_z_y;
  work.s5_7 = zd_carrier_left_rz*R_lower_arm_left_y_y;
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  work.s5_8 = zd_carrier_left_rx*R_carrier_left_aux1_x_x;
  work.s5_9 = zd_carrier_left_rx*work.R_carrier_left_aux1_y_x;
  work.s5_10 = zd_carrier_left_rx*work.R_carrier_left_aux1_z_x;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.s5_11 = zd_carrier_left_ry*work.R_carrier_left_aux2_y_y;
  work.s5_12 = zd_carrier_left_ry*work.R_carrier_left_aux2_z_y;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  work.s5_13 = zd_carrier_right_rz*R_lower_arm_right_z_y;
  work.s5_14 = zd_carrier_right_rz*R_lower_arm_right_y_y;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  work.s5_15 = zd_carrier_right_rx*R_carrier_right_aux1_x_x;
  work.s5_16 = zd_carrier_right_rx*work.R_carrier_right_aux1_y_x;
  work.s5_17 = zd_carrier_right_rx*work.R_carrier_right_aux1_z_x;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.s5_18 = zd_carrier_right_ry*work.R_carrier_right_aux2_y_y;
  work.s5_19 = zd_carrier_right_ry*work.R_carrier_right_aux2_z_y;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double s5_20 = zd_rear_axle_ry*R_rear_axle_aux4_y_x;
  const double s5_21 = zd_rear_axle_ry*R_rear_axle_aux4_x_x;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  const double s5_22 = zd_rear_axle_rx*work.R_rear_axle_aux5_x_x;
  const double s5_23 = zd_rear_axle_rx*work.R_rear_axle_aux5_y_x;
  const double s5_24 = zd_rear_axle_rx*s1_39;
  // chassis: chassis_rx, revolute, chassis_aux5
  work.s5_25 = mbgen::fma(s1_4, work.R_chassis_z_z, s1_2*work.R_chassis_z_y);
  const double s5_26 = 1.0/work.s5_25;
  work.s5_27 = s1_2*s5_26;
  work.s5_28 = s1_4*s5_26;
  work.s5_29 = s1_3*s5_26;
  work.s5_30 = s1_5*s5_26;
  work.s5_31 = work.s5_25*s5_26;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s5_32 = R_lower_arm_left_z_y*work.R_carrier_left_aux1_z_x;
  const double s5_33 = work.R_carrier_left_aux1_z_x*work.s1_12;
  const double s5_34 = mbgen::fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_z_y, s5_33);
  const double s5_35 = work.R_carrier_left_aux1_y_x*work.s1_12;
  const double s5_36 = mbgen::fma(R_carrier_left_aux1_x_x, work.R_carrier_left_aux2_y_y, s5_35);
  const double s5_37 = 1.0/mbgen::fma(R_lower_arm_left_y_y, s5_36, R_lower_arm_left_z_y*s5_34);
  const double s5_38 = R_carrier_left_aux1_z_y*s5_37;
  const double s5_39 = R_carrier_left_aux1_y_y*s5_37;
  const double s5_40 = s5_36*s5_37;
  const double s5_41 = work.R_carrier_left_aux1_y_x*work.R_carrier_left_aux2_z_y;
  const double s5_42 = mbgen::fnma(work.R_carrier_left_aux1_z_x, work.R_carrier_left_aux2_y_y,
      s5_41);
  const double s5_43 = s5_37*s5_42;
  const double s5_44 = mbgen::fma(R_lower_arm_left_y_y, work.R_carrier_left_aux1_y_x, s5_32);
  const double s5_45 = s5_44*s5_37;
  const double s5_46 = s5_34*s5_37;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s5_47 = R_lower_arm_right_z_y*work.R_carrier_right_aux1_z_x;
  const double s5_48 = work.R_carrier_right_aux1_z_x*work.s1_28;
  const double s5_49 = mbgen::fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_z_y, s5_48);
  const double s5_50 = work.R_carrier_right_aux1_y_x*work.s1_28;
  const double s5_51 = mbgen::fma(R_carrier_right_aux1_x_x, work.R_carrier_right_aux2_y_y, s5_50);
  const double s5_52 = mbgen::fma(R_lower_arm_right_y_y, s5_51, R_lower_arm_right_z_y*s5_49);
  const double s5_53 = 1.0/s5_52;
  const double s5_54 = R_carrier_right_aux1_z_y*s5_53;
  const double s5_55 = R_carrier_right_aux1_y_y*s5_53;
  const double s5_56 = s5_51*s5_53;
  const double s5_57 = work.R_carrier_right_aux1_y_x*work.R_carrier_right_aux2_z_y;
  const double s5_58 = mbgen::fnma(work.R_carrier_right_aux1_z_x, work.R_carrier_right_aux2_y_y,
      s5_57);
  const double s5_59 = s5_53*s5_58;
  const double s5_60 = mbgen::fma(R_lower_arm_right_y_y, work.R_carrier_right_aux1_y_x, s5_47);
  const double s5_61 = s5_60*s5_53;
  const double s5_62 = s5_49*s5_53;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s5_63 = R_rear_axle_aux4_y_x*work.R_rear_axle_aux5_y_x;
  const double s5_64 = mbgen::fma(R_rear_axle_aux4_x_x, work.R_rear_axle_aux5_x_x, s5_63);
  const double s5_65 = 1.0/s5_64;
  const double s5_66 = R_rear_axle_aux4_y_x*s5_65;
  const double s5_67 = R_rear_axle_aux4_x_x*s5_65;
  const double s5_68 = R_rear_axle_aux5_y_z*s5_65;
  const double s5_69 = R_rear_axle_aux5_x_z*s5_65;
  work.s5_70 = s5_64*s5_65;
  // operations: 15 add, 70 multiply, 4 divide

  // --- step 4: velocities ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s4_1 = work.s5_7 + work.s5_10;
  work.s4_2 = work.s5_12 + work.s4_1;
  work.s4_3 = work.s5_9 - work.s5_6;
  work.s4_4 = work.s5_11 + work.s4_3;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s4_5 = work.s5_14 + work.s5_17;
  work.s4_6 = work.s5_19 + work.s4_5;
  work.s4_7 = work.s5_16 - work.s5_13;
  work.s4_8 = work.s5_18 + work.s4_7;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.s4_9 = s5_21 + s5_23;
  const double zd_rear_axle_rz = state.zd[Coordinate::rear_axle_rz];
  work.s4_10 = zd_rear_axle_rz - s5_24;
  work.s4_11 = s5_22 - s5_20;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s4_12 = zd_lower_arm_left + work.s5_8;
  work.s4_13 = mbgen::fnma(zd_carrier_left_ry, work.s1_12, work.s4_12);
  work.s4_14 = zd_lower_arm_left*work.s1_8;
  work.s4_15 = zd_lower_arm_left*work.s1_10;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s4_16 = zd_lower_arm_right + work.s5_15;
  work.s4_17 = mbgen::fnma(zd_carrier_right_ry, work.s1_28, work.s4_16);
  work.s4_18 = zd_lower_arm_right*work.s1_23;
  work.s4_19 = zd_lower_arm_right*work.s1_25;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.w_carrier_left_x = work.w_chassis_x + work.s4_13;
  work.w_carrier_left_y = work.w_chassis_y + work.s4_4;
  work.w_carrier_left_z = work.w_chassis_z + work.s4_2;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.w_carrier_right_x = work.w_chassis_x + work.s4_17;
  work.w_carrier_right_y = work.w_chassis_y + work.s4_8;
  work.w_carrier_right_z = work.w_chassis_z + work.s4_6;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  work.w_rear_axle_x = work.w_chassis_x + work.s4_11;
  work.w_rear_axle_y = work.w_chassis_y + work.s4_9;
  work.w_rear_axle_z = work.w_chassis_z + work.s4_10;
  // operations: 24 add, 6 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  // chassis_aux3: chassis_tz, prismatic, chassis_aux2
  const double tau_chassis_tz = tau[Coordinate::chassis_tz];
  const double tau_chassis_ty = tau[Coordinate::chassis_ty];
  const double s7_1 = work.R_chassis_z_y*tau_chassis_tz;
  const double tau_chassis_tx = tau[Coordinate::chassis_tx];
  const double s7_2 = mbgen::fma(work.R_chassis_y_y, tau_chassis_ty, s7_1);
  work.s7_3 = mbgen::fma(work.R_chassis_x_y, tau_chassis_tx, s7_2);
  const double s7_4 = work.R_chassis_z_z*tau_chassis_tz;
  const double s7_5 = mbgen::fma(work.R_chassis_x_z, tau_chassis_tx, s7_4);
  work.s7_6 = mbgen::fma(work.R_chassis_y_z, tau_chassis_ty, s7_5);
  const double s7_7 = work.R_chassis_aux5_y_x*tau_chassis_ty;
  const double s7_8 = mbgen::fma(work.R_chassis_aux5_x_x, tau_chassis_tx, s7_7);
  work.s7_9 = mbgen::fnma(s1_1, tau_chassis_tz, s7_8);
  // chassis: chassis_rx, revolute, chassis_aux5
  const double tau_chassis_rx = tau[Coordinate::chassis_rx];
  const double tau_chassis_ry = tau[Coordinate::chassis_ry];
  const double tau_chassis_rz = tau[Coordinate::chassis_rz];
  const double s7_10 = mbgen::fma(s1_4, tau_chassis_ry, tau_chassis_rx*work.s5_29);
  work.s7_11 = mbgen::fma(tau_chassis_rz, work.s5_27, s7_10);
  const double s7_12 = mbgen::fma(tau_chassis_rz, work.s5_28, tau_chassis_rx*work.s5_30);
  work.s7_13 = mbgen::fnma(s1_2, tau_chassis_ry, s7_12);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double tau_carrier_left_ry = tau[Coordinate::carrier_left_ry];
  const double tau_carrier_left_rx = tau[Coordinate::carrier_left_rx];
  const double s7_14 = tau_carrier_left_ry*s5_38;
  const double tau_carrier_left_rz = tau[Coordinate::carrier_left_rz];
  const double s7_15 = mbgen::fma(work.R_carrier_left_aux1_z_x, tau_carrier_left_rx, s7_14);
  work.s7_16 = mbgen::fma(tau_carrier_left_rz, s5_40, s7_15);
  const double s7_17 = tau_carrier_left_ry*s5_39;
  const double s7_18 = mbgen::fma(work.R_carrier_left_aux1_y_x, tau_carrier_left_rx, s7_17);
  work.s7_19 = mbgen::fnma(tau_carrier_left_rz, s5_46, s7_18);
  const double s7_20 = R_carrier_left_aux1_x_x*tau_carrier_left_rx;
  const double s7_21 = mbgen::fma(tau_carrier_left_rz, s5_43, s7_20);
  work.s7_22 = mbgen::fnma(tau_carrier_left_ry, s5_45, s7_21);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double tau_carrier_right_ry = tau[Coordinate::carrier_right_ry];
  const double tau_carrier_right_rx = tau[Coordinate::carrier_right_rx];
  const double s7_23 = tau_carrier_right_ry*s5_54;
  const double tau_carrier_right_rz = tau[Coordinate::carrier_right_rz];
  const double s7_24 = mbgen::fma(work.R_carrier_right_aux1_z_x, tau_carrier_right_rx, s7_23);
  work.s7_25 = mbgen::fma(tau_carrier_right_rz, s5_56, s7_24);
  const double s7_26 = tau_carrier_right_ry*s5_55;
  const double s7_27 = mbgen::fma(work.R_carrier_right_aux1_y_x, tau_carrier_right_rx, s7_26);
  work.s7_28 = mbgen::fnma(tau_carrier_right_rz, s5_62, s7_27);
  const double s7_29 = R_carrier_right_aux1_x_x*tau_carrier_right_rx;
  const double s7_30 = mbgen::fma(tau_carrier_right_rz, s5_59, s7_29);
  work.s7_31 = mbgen::fnma(tau_carrier_right_ry, s5_61, s7_30);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double tau_rear_axle_rx = tau[Coordinate::rear_axle_rx];
  const double tau_rear_axle_ry = tau[Coordinate::rear_axle_ry];
  const double s7_32 = tau_rear_axle_rx*s5_66;
  const double tau_rear_axle_rz = tau[Coordinate::rear_axle_rz];
  const double s7_33 = mbgen::fma(R_rear_axle_aux4_x_x, tau_rear_axle_ry, s7_32);
  work.s7_34 = mbgen::fma(tau_rear_axle_rz, s5_68, s7_33);
  const double s7_35 = mbgen::fma(tau_rear_axle_rz, s5_69, tau_rear_axle_rx*s5_67);
  work.s7_36 = mbgen::fnma(R_rear_axle_aux4_y_x, tau_rear_axle_ry, s7_35);
  // operations: 26 add, 39 multiply

  // --- step 8: elimination from the leaves to the root (63) ---
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s8_1 = work.R_rear_axle_y_y*work.w_rear_axle_x;
  const double s8_2 = mbgen::fnma(work.R_rear_axle_x_y, work.w_rear_axle_y, s8_1);
  const double s8_3 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s8_4 = mbgen::fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s8_3);
  const double s8_5 = mbgen::fma(work.R_rear_axle_x_y, work.w_rear_axle_x, s8_4);
  const double s8_6 = state.zd[Coordinate::wheel_rear_right] + s8_5;
  const double s8_7 = work.R_rear_axle_x_y*work.w_rear_axle_z;
  const double s8_8 = mbgen::fnma(work.R_rear_axle_z_y, work.w_rear_axle_x, s8_7);
  const double s8_9 = work.R_rear_axle_z_y*work.w_rear_axle_y;
  const double s8_10 = mbgen::fnma(work.R_rear_axle_y_y, work.w_rear_axle_z, s8_9);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s8_11 = tau[Coordinate::wheel_rear_left] + tau[Coordinate::wheel_rear_right];
  const double s8_12 = s8_6 + (state.zd[Coordinate::wheel_rear_left] + s8_5);
  const double s8_13 = I_wheel_rear_right_polar*s8_12;
  work.s8_14 = mbgen::fma(s8_2, s8_13, work.R_rear_axle_z_y*s8_11);
  work.s8_15 = mbgen::fma(s8_8, s8_13, work.R_rear_axle_y_y*s8_11);
  work.s8_16 = mbgen::fma(s8_10, s8_13, work.R_rear_axle_x_y*s8_11);

  // --- step 3: Rz (61), long_rod_left .. arb_link_rear_right ---
  const double s3_1 = R_rear_axle_aux4_x_x*projection.Rz[50];
  work.s3_2 = mbgen::fma(work.R_rear_axle_aux5_y_x, projection.Rz[52], s3_1);
  const double s3_3 = R_rear_axle_aux4_x_x*projection.Rz[51];
  work.s3_4 = mbgen::fma(work.R_rear_axle_aux5_y_x, projection.Rz[53], s3_3);
  work.s3_5 = mbgen::fnma(s1_39, projection.Rz[52], projection.Rz[48]);
  work.s3_6 = mbgen::fnma(s1_39, projection.Rz[53], projection.Rz[49]);
  const double s3_7 = work.R_rear_axle_aux5_x_x*projection.Rz[52];
  work.s3_8 = mbgen::fnma(R_rear_axle_aux4_y_x, projection.Rz[50], s3_7);
  const double s3_9 = work.R_rear_axle_aux5_x_x*projection.Rz[53];
  work.s3_10 = mbgen::fnma(R_rear_axle_aux4_y_x, projection.Rz[51], s3_9);
  // operations: 6 add, 10 multiply

  // --- step 6: c and dRz/dt zd (62), long_rod_left .. arb_link_rear_right ---
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s6_1 = zd_arb_rear_left*zd_arb_rear_left;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s6_2 = zd_arb_rear_right*zd_arb_rear_right;
  const double s6_3 = mbgen::fnma(s1_39, projection.zdd_star[19], projection.zdd_star[17]);
  work.s6_4 = mbgen::fnma(s5_21, s5_22, mbgen::fnma(s5_20, s5_23, s6_3));
  const double s6_5 = work.R_rear_axle_aux5_y_x*projection.zdd_star[19];
  const double s6_6 = mbgen::fnma(s5_20, s5_24, s6_5);
  const double s6_7 = mbgen::fma(R_rear_axle_aux4_x_x, projection.zdd_star[18], s6_6);
  work.s6_8 = mbgen::fma(zd_rear_axle_rz, work.s4_11, s6_7);
  const double s6_9 = work.R_rear_axle_aux5_x_x*projection.zdd_star[19];
  const double s6_10 = mbgen::fnma(R_rear_axle_aux4_y_x, projection.zdd_star[18], s6_9);
  const double s6_11 = mbgen::fnma(s5_21, s5_24, s6_10);
  work.s6_12 = mbgen::fnma(zd_rear_axle_rz, work.s4_9, s6_11);
  // operations: 9 add, 13 multiply

  // --- step 7: inertias of the bodies and forces on joints, long_rod_left .. arb_link_rear_right
  // ---
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_37 = h_rear_axle_x*work.R_rear_axle_aux5_y_x;
  work.s7_38 = mbgen::fma(h_rear_axle_z, work.R_rear_axle_y_z, s7_37);
  const double s7_39 = h_rear_axle_x*work.R_rear_axle_aux5_x_x;
  work.s7_40 = mbgen::fma(h_rear_axle_z, work.R_rear_axle_x_z, s7_39);
  work.s7_41 = mbgen::fnma(h_rear_axle_x, s1_39, h_rear_axle_z*work.R_rear_axle_z_z);
  const double s7_42 = K_rear_axle_xx*work.R_rear_axle_aux5_y_x;
  const double s7_43 = mbgen::fma(K_rear_axle_xz, work.R_rear_axle_y_z, s7_42);
  const double s7_44 = K_rear_axle_xx*work.R_rear_axle_aux5_x_x;
  const double s7_45 = mbgen::fma(K_rear_axle_xz, work.R_rear_axle_x_z, s7_44);
  const double s7_46 = K_rear_axle_yy*work.R_rear_axle_y_y;
  const double s7_47 = mbgen::fnma((-K_rear_axle_yz), work.R_rear_axle_y_z, s7_46);
  const double s7_48 = K_rear_axle_xz*work.R_rear_axle_aux5_y_x;
  const double s7_49 = mbgen::fma(K_rear_axle_zz, work.R_rear_axle_y_z, s7_48);
  const double s7_50 = mbgen::fnma((-K_rear_axle_yz), work.R_rear_axle_y_y, s7_49);
  const double s7_51 = mbgen::fma(work.R_rear_axle_z_z, s7_50, work.R_rear_axle_z_y*s7_47);
  work.s7_52 = mbgen::fnma(s1_39, s7_43, s7_51);
  const double s7_53 = K_rear_axle_yy*work.R_rear_axle_x_y;
  const double s7_54 = mbgen::fnma((-K_rear_axle_yz), work.R_rear_axle_x_z, s7_53);
  const double s7_55 = K_rear_axle_xz*work.R_rear_axle_aux5_x_x;
  const double s7_56 = mbgen::fma(K_rear_axle_zz, work.R_rear_axle_x_z, s7_55);
  const double s7_57 = mbgen::fnma((-K_rear_axle_yz), work.R_rear_axle_x_y, s7_56);
  const double s7_58 = mbgen::fma(work.R_rear_axle_z_z, s7_57, work.R_rear_axle_z_y*s7_54);
  work.s7_59 = mbgen::fnma(s1_39, s7_45, s7_58);
  const double s7_60 = mbgen::fma(work.R_rear_axle_aux5_y_x, s7_45, work.R_rear_axle_y_y*s7_54);
  work.s7_61 = mbgen::fma(work.R_rear_axle_y_z, s7_57, s7_60);
  const double s7_62 = mbgen::fma(work.R_rear_axle_aux5_y_x, s7_43, work.R_rear_axle_y_y*s7_47);
  work.s7_63 = mbgen::fma(work.R_rear_axle_y_z, s7_50, s7_62);
  const double s7_64 = mbgen::fma(work.R_rear_axle_aux5_x_x, s7_45, work.R_rear_axle_x_y*s7_54);
  work.s7_65 = mbgen::fma(work.R_rear_axle_x_z, s7_57, s7_64);
  work.s7_66 = K_rear_axle_trace - work.s7_65 - work.s7_63;
  work.s7_67 = work.s7_65 + (work.s7_63 + work.s7_66);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_x = work.cosines[20];
  work.s7_68 = K_arb_rear_left_xy*R_arb_rear_left_x_x;
  work.s7_69 = h_arb_rear_left_x*R_arb_rear_left_x_x;
  const double R_arb_rear_left_x_z = work.sines[20];
  work.s7_70 = K_arb_rear_left_xy*R_arb_rear_left_x_z;
  work.s7_71 = h_arb_rear_left_x*R_arb_rear_left_x_z;
  const double s7_72 = K_arb_rear_left_zz*R_arb_rear_left_x_z;
  const double s7_73 = K_arb_rear_left_xx*R_arb_rear_left_x_x;
  work.s7_74 = mbgen::fnma(R_arb_rear_left_x_z, s7_73, R_arb_rear_left_x_x*s7_72);
  work.s7_75 = mbgen::fma(R_arb_rear_left_x_x, s7_73, R_arb_rear_left_x_z*s7_72);
  work.s7_76 = 0.4224999999999999 - work.s7_75;
  work.s7_77 = work.s7_75 + work.s7_76;
  const double s7_78 = K_arb_rear_left_yy + work.s7_77;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double R_arb_rear_right_x_z = work.sines[21];
  work.s7_79 = (-K_arb_rear_right_xy)*R_arb_rear_right_x_z;
  const double R_arb_rear_right_x_x = work.cosines[21];
  work.s7_80 = h_arb_rear_right_x*R_arb_rear_right_x_x;
  work.s7_81 = h_arb_rear_right_x*R_arb_rear_right_x_z;
  work.s7_82 = (-K_arb_rear_right_xy)*R_arb_rear_right_x_x;
  const double s7_83 = K_arb_rear_right_zz*R_arb_rear_right_x_z;
  const double s7_84 = K_arb_rear_right_xx*R_arb_rear_right_x_x;
  work.s7_85 = mbgen::fnma(R_arb_rear_right_x_z, s7_84, R_arb_rear_right_x_x*s7_83);
  work.s7_86 = mbgen::fma(R_arb_rear_right_x_x, s7_84, R_arb_rear_right_x_z*s7_83);
  work.s7_87 = 0.4224999999999999 - work.s7_86;
  work.s7_88 = work.s7_86 + work.s7_87;
  const double s7_89 = K_arb_rear_right_yy + work.s7_88;
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
  work.s8_26 = mbgen::fma(work.w_chassis_z, work.w_chassis_z, s8_23);
  work.s8_27 = mbgen::fma(work.w_chassis_z, work.w_chassis_z, s8_24);
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.s8_28 = projection.Rz[56]*work.s7_81;
  work.s8_29 = projection.Rz[56]*work.s7_80;
  work.s8_30 = projection.Rz[57]*work.s7_81;
  work.s8_31 = projection.Rz[57]*work.s7_80;
  const double s8_32 = s7_89 - K_arb_rear_right_yy;
  work.s8_33 = projection.Rz[56]*s8_32;
  work.s8_34 = projection.Rz[57]*s8_32;
  work.s8_35 = mbgen::fma(zd_arb_rear_right, work.s8_17, s6_2);
  const double s8_36 = 2.025 + work.s7_81;
  work.s8_37 = zd_arb_rear_right*work.s8_19;
  const double s8_38 = work.s7_80 - 14.85;
  work.s8_39 = mbgen::fma(work.s7_80, work.s8_35, projection.zdd_star[21]*work.s7_81);
  work.s8_40 = zd_arb_rear_right*work.s8_18;
  work.s8_41 = mbgen::fnma(work.s7_81, work.s8_37, work.s7_80*work.s8_40);
  const double s8_42 = (-p_arb_rear_right_x)*work.s8_26;
  const double s8_43 = mbgen::fnma((-p_arb_rear_right_z), work.s8_22, s8_42);
  work.s8_44 = mbgen::fnma((-p_arb_rear_right_y), work.s8_20, s8_43);
  const double s8_45 = (-p_arb_rear_right_z)*work.s8_25;
  const double s8_46 = mbgen::fnma((-p_arb_rear_right_x), work.s8_22, s8_45);
  work.s8_47 = mbgen::fnma((-p_arb_rear_right_z), work.s8_21, s8_46);
  work.s8_48 = mbgen::fnma(projection.zdd_star[21], work.s7_80, work.s7_81*work.s8_35);
  work.s8_49 = work.s8_25 - work.s8_26;
  work.s8_50 = work.s7_87 - work.s7_86;
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.s8_51 = work.s7_69 + work.s7_80 - 59.4;
  const double s8_52 = 2.025 + work.s7_71;
  work.s8_53 = projection.Rz[54]*work.s7_71;
  work.s8_54 = projection.Rz[55]*work.s7_71;
  work.s8_55 = mbgen::fma(zd_arb_rear_left, work.s8_17, s6_1);
  work.s8_56 = 8.1 + (work.s7_71 + work.s7_81);
  const double s8_57 = work.s7_69 - 14.85;
  work.s8_58 = mbgen::fma((-p_arb_rear_right_y), work.s8_20, s8_43);
  work.s8_59 = zd_arb_rear_left*work.s8_19;
  work.s8_60 = zd_arb_rear_left*work.s8_18;
  work.s8_61 = mbgen::fnma(work.s7_71, work.s8_59, work.s7_69*work.s8_60);
  const double s8_62 = s7_78 - K_arb_rear_left_yy;
  work.s8_63 = projection.Rz[54]*s8_62;
  work.s8_64 = projection.Rz[55]*s8_62;
  work.s8_65 = mbgen::fma((-p_arb_rear_right_z), work.s8_21, s8_46);
  work.s8_66 = mbgen::fnma(projection.zdd_star[20], work.s7_69, work.s7_71*work.s8_55);
  const double s8_67 = s8_36 + s8_52;
  const double s8_68 = mbgen::fnma((-p_arb_rear_right_y), s8_38, work.s7_74 + work.s7_85);
  const double s8_69 = mbgen::fnma(p_arb_rear_left_y, s8_57, s8_68);
  work.s8_70 = mbgen::fma((-p_arb_rear_right_x), s8_67, s8_69);
  const double s8_71 = mbgen::fma(p_arb_rear_left_y, s8_57, work.s7_68);
  work.s8_72 = mbgen::fnma((-p_arb_rear_right_y), s8_38, s8_71) - work.s7_82;
  work.s8_73 = mbgen::fma(p_carrier_left_rz_y, s8_36 - s8_52, work.s7_79 - work.s7_70);
  work.s8_74 = mbgen::fma(work.s7_69, work.s8_55, projection.zdd_star[20]*work.s7_71);
  work.s8_75 = mbgen::fma(0.9, s8_67, work.s7_76 + work.s7_87);
  work.s8_76 = s8_38 + s8_57;
}

/// Part 2 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// long_rod_left .. arb_link_rear_right.
[[gnu::noinline]] void compute_chosen_accelerations_2(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), long_rod_left .. arb_link_rear_right,
  // continued ---
  // arb_rear_left: arb_rear_left, revolute, chassis
  work.s8_77 = mbgen::fnma(6.6, work.s8_76, work.s7_75 + work.s7_86);
  const double s8_78 = work.s7_76 - work.s7_75;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_tz = state.zd[Coordinate::rear_axle_tz];
  const double zd_rear_axle_ty = state.zd[Coordinate::rear_axle_ty];
  const double s8_79 = mbgen::fma(zd_rear_axle_tz, work.s8_17, projection.zdd_star[14]);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s8_80 = mbgen::fnma(zd_rear_axle_ty, work.s8_19, s8_79);
  const double s8_81 = mbgen::fma(z_rear_axle_ty, work.s8_20, s8_80);
  const double s8_82 = mbgen::fma(work.r_rear_axle_aux3_z, work.s8_22, s8_81);
  const double s8_83 = mbgen::fnma(work.r_rear_axle_aux1_x, work.s8_26, s8_82);
  const double s8_84 = mbgen::fnma(work.w_chassis_y, work.s4_11, work.w_chassis_x*work.s4_9);
  work.s8_85 = work.s6_4 + s8_84;
  const double s8_86 = mbgen::fms(work.w_rear_axle_x, work.w_rear_axle_y, work.s8_85);
  const double s8_87 = mbgen::fnma(work.w_chassis_x, work.s4_10, work.w_chassis_z*work.s4_11);
  work.s8_88 = work.s6_8 + s8_87;
  const double s8_89 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_z, work.s8_88);
  const double s8_90 = work.w_rear_axle_y*work.w_rear_axle_y;
  const double s8_91 = work.w_rear_axle_z*work.w_rear_axle_z;
  const double s8_92 = s8_90 + s8_91;
  const double s8_93 = mbgen::fma(work.s7_38, s8_86, m_rear_axle_2*s8_83);
  const double f_rear_axle_x = mbgen::fnma(work.s7_40, s8_92, mbgen::fma(work.s7_41, s8_89, s8_93));
  const double zd_rear_axle_tx = state.zd[Coordinate::rear_axle_tx];
  const double s8_94 = mbgen::fma(zd_rear_axle_tx, work.s8_19, projection.zdd_star[15]);
  const double s8_95 = mbgen::fnma(zd_rear_axle_tz, work.s8_18, s8_94);
  const double s8_96 = mbgen::fma(work.r_rear_axle_aux1_x, work.s8_20, s8_95);
  const double s8_97 = mbgen::fma(work.r_rear_axle_aux3_z, work.s8_21, s8_96);
  const double s8_98 = mbgen::fnma(z_rear_axle_ty, work.s8_27, s8_97);
  const double s8_99 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_y, work.s8_85);
  const double s8_100 = mbgen::fnma(work.w_chassis_z, work.s4_9, work.w_chassis_y*work.s4_10);
  work.s8_101 = work.s6_12 + s8_100;
  const double s8_102 = mbgen::fms(work.w_rear_axle_y, work.w_rear_axle_z, work.s8_101);
  const double s8_103 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_x, s8_91);
  const double s8_104 = mbgen::fma(work.s7_40, s8_99, m_rear_axle_2*s8_98);
  const double f_rear_axle_y = mbgen::fnma(work.s7_38, s8_103, mbgen::fma(work.s7_41, s8_102,
      s8_104));
  const double s8_105 = mbgen::fma(zd_rear_axle_ty, work.s8_18, projection.zdd_star[16]);
  const double s8_106 = mbgen::fnma(zd_rear_axle_tx, work.s8_17, s8_105);
  const double s8_107 = mbgen::fma(z_rear_axle_ty, work.s8_21, s8_106);
  const double s8_108 = mbgen::fma(work.r_rear_axle_aux1_x, work.s8_22, s8_107);
  const double s8_109 = mbgen::fnma(work.r_rear_axle_aux3_z, work.s8_25, s8_108);
  const double s8_110 = mbgen::fma(work.w_rear_axle_y, work.w_rear_axle_z, work.s8_101);
  const double s8_111 = mbgen::fms(work.w_rear_axle_x, work.w_rear_axle_z, work.s8_88);
  const double s8_112 = mbgen::fma(work.w_rear_axle_x, work.w_rear_axle_x, s8_90);
  const double s8_113 = mbgen::fma(work.s7_38, s8_110, m_rear_axle_2*s8_109);
  const double f_rear_axle_z = mbgen::fnma(work.s7_41, s8_112, mbgen::fma(work.s7_40, s8_111,
      s8_113));
  const double s8_114 = mbgen::fma(work.s7_38, s8_109, work.s8_16);
  const double s8_115 = mbgen::fma(work.s7_63, s8_110, mbgen::fnma(work.s7_41, s8_98, s8_114));
  const double s8_116 = mbgen::fnma(work.s7_59, s8_99, mbgen::fma(work.s7_61, s8_111, s8_115));
  const double s8_117 = mbgen::fnma(work.s7_66, s8_102, s8_116);
  const double n_rear_axle_x = mbgen::fma(work.s7_52, s8_103 - s8_112, s8_117);
  const double s8_118 = mbgen::fma(work.s7_41, s8_83, work.s8_15);
  const double s8_119 = mbgen::fma(work.s7_52, s8_86, mbgen::fnma(work.s7_40, s8_109, s8_118));
  const double s8_120 = mbgen::fnma(work.s7_61, s8_110, mbgen::fma(work.s7_66, s8_89, s8_119));
  const double s8_121 = mbgen::fnma(work.s7_65, s8_111, s8_120);
  const double n_rear_axle_y = mbgen::fma(work.s7_59, s8_112 - s8_92, s8_121);
  const double s8_122 = mbgen::fma(work.s7_40, s8_98, work.s8_14);
  const double s8_123 = mbgen::fma(work.s7_59, s8_102, mbgen::fnma(work.s7_38, s8_83, s8_122));
  const double s8_124 = mbgen::fnma(work.s7_63, s8_86, mbgen::fma(work.s7_65, s8_99, s8_123));
  const double s8_125 = mbgen::fnma(work.s7_52, s8_89, s8_124);
  const double n_rear_axle_z = mbgen::fma(work.s7_61, s8_92 - s8_103, s8_125);
  work.s8_126 = mbgen::fma(m_rear_axle_2, z_rear_axle_ty, work.s7_38);
  work.s8_127 = mbgen::fma(m_rear_axle_2, work.r_rear_axle_aux1_x, work.s7_40);
  work.s8_128 = mbgen::fma(m_rear_axle_2, work.r_rear_axle_aux3_z, work.s7_41);
  const double s8_129 = mbgen::fma(work.s3_2, work.s7_41, m_rear_axle_2*projection.Rz[42]);
  const double s8_130 = mbgen::fnma(work.s3_5, work.s7_38, s8_129);
  const double s8_131 = mbgen::fma(work.s3_4, work.s7_41, m_rear_axle_2*projection.Rz[43]);
  const double s8_132 = mbgen::fnma(work.s3_6, work.s7_38, s8_131);
  work.s8_133 = s8_132 - work.s8_30 - work.s8_54;
  const double s8_134 = mbgen::fma(work.s3_8, work.s7_38, m_rear_axle_2*projection.Rz[46]);
  const double s8_135 = mbgen::fnma(work.s3_2, work.s7_40, s8_134);
  const double s8_136 = mbgen::fma(work.s3_10, work.s7_38, m_rear_axle_2*projection.Rz[47]);
  const double s8_137 = mbgen::fnma(work.s3_4, work.s7_40, s8_136);
  work.s8_138 = mbgen::fnma(projection.Rz[55], work.s7_69, s8_137 - work.s8_31);
  const double s8_139 = mbgen::fma(593.0, work.r_rear_axle_aux3_z, work.s7_41);
  const double s8_140 = mbgen::fma(593.0, z_rear_axle_ty, work.s7_38);
  const double s8_141 = mbgen::fma(593.0, work.r_rear_axle_aux1_x, work.s7_40);
  const double s8_142 = work.s7_67 - work.s7_65;
  const double s8_143 = mbgen::fnma(projection.Rz[44], work.s7_41, projection.Rz[46]*work.s7_38);
  const double s8_144 = mbgen::fma(work.s3_8, s8_142, s8_143);
  const double s8_145 = mbgen::fnma(work.s3_5, work.s7_59, s8_144);
  const double s8_146 = mbgen::fnma(work.s3_2, work.s7_61, s8_145);
  const double s8_147 = mbgen::fma(work.s3_5, work.s7_40, m_rear_axle_2*projection.Rz[44]);
  const double s8_148 = mbgen::fnma(work.s3_8, work.s7_41, s8_147);
  const double s8_149 = mbgen::fnma(projection.Rz[45], work.s7_41, projection.Rz[47]*work.s7_38);
  const double s8_150 = mbgen::fma(work.s3_10, s8_142, s8_149);
  const double s8_151 = mbgen::fnma(work.s3_6, work.s7_59, s8_150);
  const double s8_152 = mbgen::fnma(work.s3_4, work.s7_61, s8_151);
  const double s8_153 = mbgen::fma(work.s3_6, work.s7_40, m_rear_axle_2*projection.Rz[45]);
  work.s8_154 = mbgen::fnma(work.s3_10, work.s7_41, s8_153);
  const double s8_155 = work.s7_67 - work.s7_66;
  const double s8_156 = mbgen::fnma(projection.Rz[42], work.s7_38, projection.Rz[44]*work.s7_40);
  const double s8_157 = mbgen::fma(work.s3_5, s8_155, s8_156);
  const double s8_158 = mbgen::fnma(work.s3_8, work.s7_59, s8_157);
  const double s8_159 = mbgen::fnma(work.s3_2, work.s7_52, s8_158);
  const double s8_160 = mbgen::fnma(projection.Rz[43], work.s7_38, projection.Rz[45]*work.s7_40);
  const double s8_161 = mbgen::fma(work.s3_6, s8_155, s8_160);
  const double s8_162 = mbgen::fnma(work.s3_10, work.s7_59, s8_161);
  const double s8_163 = mbgen::fnma(work.s3_4, work.s7_52, s8_162);
  const double s8_164 = work.s7_67 - work.s7_63;
  const double s8_165 = mbgen::fnma(projection.Rz[46], work.s7_40, projection.Rz[42]*work.s7_41);
  const double s8_166 = mbgen::fma(work.s3_2, s8_164, s8_165);
  const double s8_167 = mbgen::fnma(work.s3_5, work.s7_52, s8_166);
  const double s8_168 = mbgen::fnma(work.s3_8, work.s7_61, s8_167);
  const double s8_169 = mbgen::fnma(projection.Rz[47], work.s7_40, projection.Rz[43]*work.s7_41);
  const double s8_170 = mbgen::fma(work.s3_4, s8_164, s8_169);
  const double s8_171 = mbgen::fnma(work.s3_6, work.s7_52, s8_170);
  const double s8_172 = mbgen::fnma(work.s3_10, work.s7_61, s8_171);
  const double s8_173 = work.r_rear_axle_aux3_z + work.r_rear_axle_aux3_z;
  const double s8_174 = z_rear_axle_ty + z_rear_axle_ty;
  const double s8_175 = work.r_rear_axle_aux1_x + work.r_rear_axle_aux1_x;
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  work.s8_176 = (-p_rear_axle_tx_z)*work.s8_21;
  work.s8_177 = (-p_rear_axle_tx_z)*work.s8_22;
  work.s8_178 = (-p_rear_axle_tx_z)*work.s8_25;
  // long_rod_left
  const double s1_39 = work.sines[18];
  const double s8_179 = p_long_rod_left_to_x*s1_39;
  const double s8_180 = mbgen::fma((-p_long_rod_left_to_z), work.R_rear_axle_z_z, s8_179);
  const double s8_181 = mbgen::fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s8_180);
  const double s8_182 = (-p_long_rod_left_from_z) + (work.r_rear_axle_aux3_z + s8_181);
  const double s8_183 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s8_184 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_x_z, s8_183);
  const double s8_185 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s8_184);
  const double s8_186 = (-p_long_rod_left_from_x) + (work.r_rear_axle_aux1_x + s8_185);
  const double s8_187 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s8_188 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_y_z, s8_187);
  const double s8_189 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s8_188);
  const double s8_190 = mbgen::fnma(work.s4_10, s8_189, work.s4_9*s8_181);
  const double s8_191 = zd_rear_axle_tx + s8_190;
  const double s8_192 = mbgen::fnma(work.s4_11, s8_181, work.s4_10*s8_185);
  const double s8_193 = zd_rear_axle_ty + s8_192;
  const double s8_194 = mbgen::fnma(work.s4_9, s8_185, work.s4_11*s8_189);
  const double s8_195 = zd_rear_axle_tz + s8_194;
  const double s8_196 = mbgen::fma(work.s3_2, s8_181, projection.Rz[42]);
  const double s8_197 = mbgen::fnma(work.s3_5, s8_189, s8_196);
  const double s8_198 = mbgen::fma(work.s3_4, s8_181, projection.Rz[43]);
  const double s8_199 = mbgen::fnma(work.s3_6, s8_189, s8_198);
  const double s8_200 = mbgen::fma(work.s3_5, s8_185, projection.Rz[44]);
  const double s8_201 = mbgen::fnma(work.s3_8, s8_181, s8_200);
  const double s8_202 = mbgen::fma(work.s3_6, s8_185, projection.Rz[45]);
  const double s8_203 = mbgen::fnma(work.s3_10, s8_181, s8_202);
  const double s8_204 = mbgen::fma(work.s3_8, s8_189, projection.Rz[46]);
  const double s8_205 = mbgen::fnma(work.s3_2, s8_185, s8_204);
  const double s8_206 = mbgen::fma(work.s3_10, s8_189, projection.Rz[47]);
  const double s8_207 = mbgen::fnma(work.s3_4, s8_185, s8_206);
  const double s8_208 = p_long_rod_left_from_y - z_rear_axle_ty - s8_189;
  const double s8_209 = 3.0*s8_208;
  const double s8_210 = 3.0*s8_186;
  const double s8_211 = 3.0*s8_182;
  const double s8_212 = mbgen::fms(work.s8_20, s8_208, projection.zdd_star[14]);
  const double s8_213 = mbgen::fnma(work.s8_22, s8_182, mbgen::fma(work.s8_26, s8_186, s8_212));
  const double s8_214 = mbgen::fnma(work.s8_17, s8_195, mbgen::fma(work.s8_19, s8_193, s8_213));
  const double s8_215 = mbgen::fma(work.s6_4, s8_189, mbgen::fnma(work.s6_8, s8_181, s8_214));
  const double s8_216 = mbgen::fma(work.s4_10, s8_192, mbgen::fnma(work.s4_9, s8_194, s8_215));
  const double s8_217 = 3.0*s8_216;
  const double s8_218 = mbgen::fms(work.s8_21, s8_208, projection.zdd_star[16]);
  const double s8_219 = mbgen::fnma(work.s8_22, s8_186, mbgen::fma(work.s8_25, s8_182, s8_218));
  const double s8_220 = mbgen::fnma(work.s8_18, s8_193, mbgen::fma(work.s8_17, s8_191, s8_219));
  const double s8_221 = mbgen::fma(work.s6_8, s8_185, mbgen::fnma(work.s6_12, s8_189, s8_220));
  const double s8_222 = mbgen::fma(work.s4_9, s8_190, mbgen::fnma(work.s4_11, s8_192, s8_221));
  const double s8_223 = 3.0*s8_222;
  const double s8_224 = mbgen::fms(work.s8_18, s8_195, projection.zdd_star[15]);
  const double s8_225 = mbgen::fnma(work.s6_4, s8_185, mbgen::fnma(work.s8_19, s8_191, s8_224));
  const double s8_226 = mbgen::fnma(work.s4_10, s8_190, mbgen::fma(work.s6_12, s8_181, s8_225));
  const double s8_227 = mbgen::fnma(work.s8_27, s8_208, mbgen::fma(work.s4_11, s8_194, s8_226));
  const double s8_228 = mbgen::fnma(work.s8_21, s8_182, mbgen::fnma(work.s8_20, s8_186, s8_227));
  const double s8_229 = 3.0*s8_228;
  // diag_rod_left
  const double s8_230 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  const double s8_231 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s8_230);
  const double s8_232 = (-p_diag_rod_left_from_z) + (work.r_rear_axle_aux3_z + s8_231);
  const double s8_233 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  const double s8_234 = mbgen::fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s8_233);
  const double s8_235 = (-p_diag_rod_left_from_x) + (work.r_rear_axle_aux1_x + s8_234);
  const double s8_236 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  const double s8_237 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s8_236);
  const double s8_238 = mbgen::fnma(work.s4_10, s8_237, work.s4_9*s8_231);
  const double s8_239 = zd_rear_axle_tx + s8_238;
  const double s8_240 = mbgen::fnma(work.s4_11, s8_231, work.s4_10*s8_234);
  const double s8_241 = zd_rear_axle_ty + s8_240;
  const double s8_242 = mbgen::fnma(work.s4_9, s8_234, work.s4_11*s8_237);
  const double s8_243 = zd_rear_axle_tz + s8_242;
  const double s8_244 = mbgen::fma(work.s3_2, s8_231, projection.Rz[42]);
  const double s8_245 = mbgen::fnma(work.s3_5, s8_237, s8_244);
  const double s8_246 = mbgen::fma(work.s3_4, s8_231, projection.Rz[43]);
  const double s8_247 = mbgen::fnma(work.s3_6, s8_237, s8_246);
  const double s8_248 = mbgen::fma(work.s3_5, s8_234, projection.Rz[44]);
  const double s8_249 = mbgen::fnma(work.s3_8, s8_231, s8_248);
  const double s8_250 = mbgen::fma(work.s3_6, s8_234, projection.Rz[45]);
  const double s8_251 = mbgen::fnma(work.s3_10, s8_231, s8_250);
  const double s8_252 = mbgen::fma(work.s3_8, s8_237, projection.Rz[46]);
  const double s8_253 = mbgen::fnma(work.s3_2, s8_234, s8_252);
  const double s8_254 = mbgen::fma(work.s3_10, s8_237, projection.Rz[47]);
  const double s8_255 = mbgen::fnma(work.s3_4, s8_234, s8_254);
  const double s8_256 = p_diag_rod_left_from_y - z_rear_axle_ty - s8_237;
  const double s8_257 = 2.6666666666666665*s8_256;
  const double s8_258 = 2.6666666666666665*s8_235;
  const double s8_259 = 2.6666666666666665*s8_232;
  const double s8_260 = mbgen::fms(work.s8_20, s8_256, projection.zdd_star[14]);
  const double s8_261 = mbgen::fnma(work.s8_22, s8_232, mbgen::fma(work.s8_26, s8_235, s8_260));
  const double s8_262 = mbgen::fnma(work.s8_17, s8_243, mbgen::fma(work.s8_19, s8_241, s8_261));
  const double s8_263 = mbgen::fma(work.s6_4, s8_237, mbgen::fnma(work.s6_8, s8_231, s8_262));
  const double s8_264 = mbgen::fma(work.s4_10, s8_240, mbgen::fnma(work.s4_9, s8_242, s8_263));
  const double s8_265 = 2.6666666666666665*s8_264;
  const double s8_266 = mbgen::fms(work.s8_21, s8_256, projection.zdd_star[16]);
  const double s8_267 = mbgen::fnma(work.s8_22, s8_235, mbgen::fma(work.s8_25, s8_232, s8_266));
  const double s8_268 = mbgen::fnma(work.s8_18, s8_241, mbgen::fma(work.s8_17, s8_239, s8_267));
  const double s8_269 = mbgen::fma(work.s6_8, s8_234, mbgen::fnma(work.s6_12, s8_237, s8_268));
  const double s8_270 = mbgen::fma(work.s4_9, s8_238, mbgen::fnma(work.s4_11, s8_240, s8_269));
  const double s8_271 = 2.6666666666666665*s8_270;
  const double s8_272 = mbgen::fms(work.s8_18, s8_243, projection.zdd_star[15]);
  const double s8_273 = mbgen::fnma(work.s6_4, s8_234, mbgen::fnma(work.s8_19, s8_239, s8_272));
  const double s8_274 = mbgen::fnma(work.s4_10, s8_238, mbgen::fma(work.s6_12, s8_231, s8_273));
  const double s8_275 = mbgen::fnma(work.s8_27, s8_256, mbgen::fma(work.s4_11, s8_242, s8_274));
  const double s8_276 = mbgen::fnma(work.s8_21, s8_232, mbgen::fnma(work.s8_20, s8_235, s8_275));
  const double s8_277 = 2.6666666666666665*s8_276;
  // arb_link_rear_left
  const double s8_278 = p_arb_link_rear_left_from_x*work.sines[20];
  const double s8_279 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_y_x;
  const double s8_280 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_y_z, s8_279);
  const double s8_281 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_x_x;
  const double s8_282 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_x_z, s8_281);
  const double zd_arb_rear_left = state.zd[Coordinate::arb_rear_left];
  const double s8_283 = zd_arb_rear_left*s8_278;
  const double s8_284 = p_arb_link_rear_left_from_x*work.cosines[20];
  const double s8_285 = zd_arb_rear_left*s8_284;
  const double s8_286 = (-p_arb_link_rear_left_to_x)*s1_39;
  const double s8_287 = mbgen::fnma((-p_arb_link_rear_left_to_z), work.R_rear_axle_z_z, s8_286);
  const double s8_288 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s8_287);
  const double s8_289 = (-p_arb_rear_left_z) + (s8_278 + (work.r_rear_axle_aux3_z + s8_288));
  const double s8_290 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s8_282);
  const double s8_291 = mbgen::fnma(work.s4_11, s8_288, work.s4_10*s8_290);
  const double s8_292 = zd_rear_axle_ty + s8_291;
  const double s8_293 = mbgen::fma(work.s3_5, s8_290, projection.Rz[44]);
  const double s8_294 = mbgen::fnma(work.s3_8, s8_288, s8_293);
  const double s8_295 = mbgen::fma(work.s3_6, s8_290, projection.Rz[45]);
  const double s8_296 = mbgen::fnma(work.s3_10, s8_288, s8_295);
  const double s8_297 = s8_284 - work.r_rear_axle_aux1_x - s8_290 - (-p_arb_rear_left_x);
  const double s8_298 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s8_280);
  const double s8_299 = 0.6 - z_rear_axle_ty - s8_298;
  const double s8_300 = 0.3333333333333333*s8_299;
  const double s8_301 = 0.3333333333333333*s8_297;
  const double s8_302 = mbgen::fnma(work.s4_10, s8_298, work.s4_9*s8_288);
  const double s8_303 = s8_283 + (zd_rear_axle_tx + s8_302);
  const double s8_304 = mbgen::fnma(work.s4_9, s8_290, work.s4_11*s8_298);
  const double s8_305 = s8_285 + (zd_rear_axle_tz + s8_304);
  const double s8_306 = mbgen::fma(projection.Rz[54], s8_278, projection.Rz[42]);
  const double s8_307 = mbgen::fnma(work.s3_5, s8_298, mbgen::fma(work.s3_2, s8_288, s8_306));
  const double s8_308 = mbgen::fma(projection.Rz[54], s8_284, projection.Rz[46]);
  const double s8_309 = mbgen::fnma(work.s3_2, s8_290, mbgen::fma(work.s3_8, s8_298, s8_308));
  const double s8_310 = mbgen::fma(projection.Rz[55], s8_278, projection.Rz[43]);
  const double s8_311 = mbgen::fnma(work.s3_6, s8_298, mbgen::fma(work.s3_4, s8_288, s8_310));
  const double s8_312 = mbgen::fma(projection.Rz[55], s8_284, projection.Rz[47]);
  const double s8_313 = mbgen::fnma(work.s3_4, s8_290, mbgen::fma(work.s3_10, s8_298, s8_312));
  const double s8_314 = 0.3333333333333333*s8_289;
  const double s8_315 = mbgen::fms(work.s8_21, s8_299, projection.zdd_star[16]);
  const double s8_316 = mbgen::fma(work.s8_25, s8_289, mbgen::fma(work.s8_22, s8_297, s8_315));
  const double s8_317 = mbgen::fma(zd_arb_rear_left, s8_283, s8_316);
  const double s8_318 = mbgen::fma(work.s4_9, s8_302, mbgen::fnma(work.s4_11, s8_291, s8_317));
  const double s8_319 = mbgen::fnma(projection.zdd_star[20], s8_284, s8_318);
  const double s8_320 = mbgen::fma(work.s6_8, s8_290, mbgen::fnma(work.s6_12, s8_298, s8_319));
  const double s8_321 = mbgen::fnma(work.s8_18, s8_292, mbgen::fma(work.s8_17, s8_303, s8_320));
  const double s8_322 = 0.3333333333333333*s8_321;
  const double s8_323 = mbgen::fms(work.s8_20, s8_299, projection.zdd_star[14]);
  const double s8_324 = mbgen::fnma(work.s8_26, s8_297, mbgen::fnma(work.s8_22, s8_289, s8_323));
  const double s8_325 = mbgen::fnma(work.s8_17, s8_305, mbgen::fma(work.s8_19, s8_292, s8_324));
  const double s8_326 = mbgen::fnma(projection.zdd_star[20], s8_278, s8_325);
  const double s8_327 = mbgen::fma(work.s6_4, s8_298, mbgen::fnma(work.s6_8, s8_288, s8_326));
  const double s8_328 = mbgen::fnma(zd_arb_rear_left, s8_285, s8_327);
  const double s8_329 = mbgen::fma(work.s4_10, s8_291, mbgen::fnma(work.s4_9, s8_304, s8_328));
  const double s8_330 = 0.3333333333333333*s8_329;
  const double s8_331 = mbgen::fms(work.s8_20, s8_297, projection.zdd_star[15]);
  const double s8_332 = mbgen::fnma(work.s8_27, s8_299, mbgen::fnma(work.s8_21, s8_289, s8_331));
  const double s8_333 = mbgen::fnma(work.s8_19, s8_303, mbgen::fma(work.s8_18, s8_305, s8_332));
  const double s8_334 = mbgen::fma(work.s6_12, s8_288, mbgen::fnma(work.s6_4, s8_290, s8_333));
  const double s8_335 = mbgen::fma(work.s4_11, s8_304, mbgen::fnma(work.s4_10, s8_302, s8_334));
  const double s8_336 = 0.3333333333333333*s8_335;
  // long_rod_right
  const double s8_337 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s8_180);
  const double s8_338 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s8_188);
  const double s8_339 = (-p_long_rod_right_from_y) + (z_rear_axle_ty + s8_338);
  const double s8_340 = (-p_long_rod_right_from_z) + (work.r_rear_axle_aux3_z - s8_337);
  const double s8_341 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s8_184);
  const double s8_342 = (-p_long_rod_right_from_x) + (work.r_rear_axle_aux1_x + s8_341);
  const double s8_343 = mbgen::fma(work.s4_10, s8_338, work.s4_9*s8_337);
  const double s8_344 = mbgen::fma(work.s4_10, s8_341, work.s4_11*s8_337);
  const double s8_345 = zd_rear_axle_ty + s8_344;
  const double s8_346 = mbgen::fnma(work.s4_9, s8_341, work.s4_11*s8_338);
  const double s8_347 = zd_rear_axle_tz + s8_346;
  const double s8_348 = mbgen::fma(work.s3_8, s8_337, projection.Rz[44]);
  const double s8_349 = mbgen::fma(work.s3_5, s8_341, s8_348);
  const double s8_350 = mbgen::fma(work.s3_10, s8_337, projection.Rz[45]);
  const double s8_351 = mbgen::fma(work.s3_6, s8_341, s8_350);
  const double s8_352 = mbgen::fma(work.s3_8, s8_338, projection.Rz[46]);
  const double s8_353 = mbgen::fnma(work.s3_2, s8_341, s8_352);
  const double s8_354 = mbgen::fma(work.s3_10, s8_338, projection.Rz[47]);
  const double s8_355 = mbgen::fnma(work.s3_4, s8_341, s8_354);
  const double s8_356 = zd_rear_axle_tx - s8_343;
  const double s8_357 = mbgen::fnma(work.s3_2, s8_337, projection.Rz[42]);
  const double s8_358 = mbgen::fnma(work.s3_5, s8_338, s8_357);
  const double s8_359 = mbgen::fnma(work.s3_4, s8_337, projection.Rz[43]);
  const double s8_360 = mbgen::fnma(work.s3_6, s8_338, s8_359);
  const double s8_361 = 3.0*s8_339;
  const double s8_362 = 3.0*s8_342;
  const double s8_363 = 3.0*s8_340;
  const double s8_364 = mbgen::fms(work.s8_27, s8_339, projection.zdd_star[15]);
  const double s8_365 = mbgen::fnma(work.s8_21, s8_340, mbgen::fnma(work.s8_20, s8_342, s8_364));
  const double s8_366 = mbgen::fma(work.s4_11, s8_346, mbgen::fma(work.s4_10, s8_343, s8_365));
  const double s8_367 = mbgen::fnma(work.s6_4, s8_341, mbgen::fnma(work.s6_12, s8_337, s8_366));
  const double s8_368 = mbgen::fnma(work.s8_19, s8_356, mbgen::fma(work.s8_18, s8_347, s8_367));
  const double s8_369 = 3.0*s8_368;
  const double s8_370 = mbgen::fms(work.s8_25, s8_340, projection.zdd_star[16]);
  const double s8_371 = mbgen::fnma(work.s8_21, s8_339, mbgen::fnma(work.s8_22, s8_342, s8_370));
  const double s8_372 = mbgen::fnma(work.s8_18, s8_345, mbgen::fma(work.s8_17, s8_356, s8_371));
  const double s8_373 = mbgen::fma(work.s6_8, s8_341, mbgen::fnma(work.s6_12, s8_338, s8_372));
  const double s8_374 = mbgen::fnma(work.s4_11, s8_344, mbgen::fnma(work.s4_9, s8_343, s8_373));
  const double s8_375 = 3.0*s8_374;
  const double s8_376 = mbgen::fms(work.s8_26, s8_342, projection.zdd_star[14]);
  const double s8_377 = mbgen::fnma(work.s8_20, s8_339, mbgen::fnma(work.s8_22, s8_340, s8_376));
  const double s8_378 = mbgen::fnma(work.s8_17, s8_347, mbgen::fma(work.s8_19, s8_345, s8_377));
  const double s8_379 = mbgen::fma(work.s6_4, s8_338, mbgen::fma(work.s6_8, s8_337, s8_378));
  const double s8_380 = mbgen::fma(work.s4_10, s8_344, mbgen::fnma(work.s4_9, s8_346, s8_379));
  const double s8_381 = 3.0*s8_380;
  // diag_rod_right
  const double s8_382 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s8_230);
  const double s8_383 = (-p_diag_rod_right_from_z) + (work.r_rear_axle_aux3_z + s8_382);
  const double s8_384 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s8_236);
  const double s8_385 = (-p_diag_rod_right_from_y) + (z_rear_axle_ty + s8_384);
  const double s8_386 = mbgen::fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s8_233);
  const double s8_387 = (-p_diag_rod_right_from_x) + (work.r_rear_axle_aux1_x + s8_386);
  const double s8_388 = mbgen::fnma(work.s4_10, s8_384, work.s4_9*s8_382);
  const double s8_389 = zd_rear_axle_tx + s8_388;
  const double s8_390 = mbgen::fnma(work.s4_11, s8_382, work.s4_10*s8_386);
  const double s8_391 = zd_rear_axle_ty + s8_390;
  const double s8_392 = mbgen::fnma(work.s4_9, s8_386, work.s4_11*s8_384);
  const double s8_393 = zd_rear_axle_tz + s8_392;
  const double s8_394 = mbgen::fma(work.s3_2, s8_382, projection.Rz[42]);
  const double s8_395 = mbgen::fnma(work.s3_5, s8_384, s8_394);
  const double s8_396 = mbgen::fma(work.s3_4, s8_382, projection.Rz[43]);
  const double s8_397 = mbgen::fnma(work.s3_6, s8_384, s8_396);
  const double s8_398 = mbgen::fma(work.s3_5, s8_386, projection.Rz[44]);
  const double s8_399 = mbgen::fnma(work.s3_8, s8_382, s8_398);
  const double s8_400 = mbgen::fma(work.s3_6, s8_386, projection.Rz[45]);
  const double s8_401 = mbgen::fnma(work.s3_10, s8_382, s8_400);
  const double s8_402 = mbgen::fma(work.s3_8, s8_384, projection.Rz[46]);
  const double s8_403 = mbgen::fnma(work.s3_2, s8_386, s8_402);
  const double s8_404 = mbgen::fma(work.s3_10, s8_384, projection.Rz[47]);
  const double s8_405 = mbgen::fnma(work.s3_4, s8_386, s8_404);
  const double s8_406 = 2.6666666666666665*s8_385;
  const double s8_407 = 2.6666666666666665*s8_387;
  const double s8_408 = 2.6666666666666665*s8_383;
  const double s8_409 = mbgen::fms(work.s8_27, s8_385, projection.zdd_star[15]);
  const double s8_410 = mbgen::fnma(work.s8_21, s8_383, mbgen::fnma(work.s8_20, s8_387, s8_409));
  const double s8_411 = mbgen::fnma(work.s8_19, s8_389, mbgen::fma(work.s8_18, s8_393, s8_410));
  const double s8_412 = mbgen::fma(work.s6_12, s8_382, mbgen::fnma(work.s6_4, s8_386, s8_411));
  const double s8_413 = mbgen::fma(work.s4_11, s8_392, mbgen::fnma(work.s4_10, s8_388, s8_412));
  const double s8_414 = 2.6666666666666665*s8_413;
  const double s8_415 = mbgen::fms(work.s8_25, s8_383, projection.zdd_star[16]);
  const double s8_416 = mbgen::fnma(work.s8_21, s8_385, mbgen::fnma(work.s8_22, s8_387, s8_415));
  const double s8_417 = mbgen::fnma(work.s8_18, s8_391, mbgen::fma(work.s8_17, s8_389, s8_416));
  const double s8_418 = mbgen::fma(work.s6_8, s8_386, mbgen::fnma(work.s6_12, s8_384, s8_417));
  const double s8_419 = mbgen::fma(work.s4_9, s8_388, mbgen::fnma(work.s4_11, s8_390, s8_418));
  const double s8_420 = 2.6666666666666665*s8_419;
  const double s8_421 = mbgen::fms(work.s8_26, s8_387, projection.zdd_star[14]);
  const double s8_422 = mbgen::fnma(work.s8_20, s8_385, mbgen::fnma(work.s8_22, s8_383, s8_421));
  const double s8_423 = mbgen::fnma(work.s8_17, s8_393, mbgen::fma(work.s8_19, s8_391, s8_422));
  const double s8_424 = mbgen::fma(work.s6_4, s8_384, mbgen::fnma(work.s6_8, s8_382, s8_423));
  const double s8_425 = mbgen::fma(work.s4_10, s8_390, mbgen::fnma(work.s4_9, s8_392, s8_424));
  const double s8_426 = 2.6666666666666665*s8_425;
  // arb_link_rear_right
  const double s8_427 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s8_280);
  const double s8_428 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s8_282);
  const double s8_429 = p_arb_link_rear_right_from_x*work.sines[21];
  const double s8_430 = 0.6 + (z_rear_axle_ty - s8_427);
  const double s8_431 = mbgen::fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, s8_287);
  const double s8_432 = mbgen::fma(work.s4_11, s8_431, work.s4_10*s8_428);
  const double zd_arb_rear_right = state.zd[Coordinate::arb_rear_right];
  const double s8_433 = zd_arb_rear_right*s8_429;
  const double s8_434 = p_arb_link_rear_right_from_x*work.cosines[21];
  const double s8_435 = zd_arb_rear_right*s8_434;
  const double s8_436 = (-p_arb_rear_right_z) + (s8_429 + (work.r_rear_axle_aux3_z + s8_431));
  const double s8_437 = zd_rear_axle_ty - s8_432;
  const double s8_438 = mbgen::fnma(work.s3_5, s8_428, projection.Rz[44]);
  const double s8_439 = mbgen::fnma(work.s3_8, s8_431, s8_438);
  const double s8_440 = mbgen::fnma(work.s3_6, s8_428, projection.Rz[45]);
  const double s8_441 = mbgen::fnma(work.s3_10, s8_431, s8_440);
  const double s8_442 = 0.3333333333333333*s8_430;
  const double s8_443 = mbgen::fma(z_rear_axle_ty, s8_139, work.s7_52);
  const double s8_444 = mbgen::fma(work.r_rear_axle_aux3_z, s8_140, s8_443);
  const double s8_445 = mbgen::fma(s8_232, s8_257, mbgen::fma(s8_182, s8_209, s8_444));
  const double s8_446 = mbgen::fnma(s8_340, s8_361, mbgen::fma(s8_289, s8_300, s8_445));
  work.s8_447 = mbgen::fnma(s8_436, s8_442, mbgen::fnma(s8_383, s8_406, s8_446));
  const double s8_448 = mbgen::fma(work.s4_9, s8_431, work.s4_10*s8_427);
  const double s8_449 = s8_433 + (zd_rear_axle_tx + s8_448);
  const double s8_450 = mbgen::fnma(work.s4_11, s8_427, work.s4_9*s8_428);
  const double s8_451 = s8_435 + (zd_rear_axle_tz + s8_450);
  const double s8_452 = mbgen::fma(projection.Rz[56], s8_429, projection.Rz[42]);
  const double s8_453 = mbgen::fma(work.s3_2, s8_431, mbgen::fma(work.s3_5, s8_427, s8_452));
  const double s8_454 = mbgen::fma(projection.Rz[56], s8_434, projection.Rz[46]);
  const double s8_455 = mbgen::fnma(work.s3_8, s8_427, mbgen::fma(work.s3_2, s8_428, s8_454));
  const double s8_456 = mbgen::fma(projection.Rz[57], s8_429, projection.Rz[43]);
  const double s8_457 = mbgen::fma(work.s3_4, s8_431, mbgen::fma(work.s3_6, s8_427, s8_456));
  const double s8_458 = mbgen::fma(projection.Rz[57], s8_434, projection.Rz[47]);
  const double s8_459 = mbgen::fnma(work.s3_10, s8_427, mbgen::fma(work.s3_4, s8_428, s8_458));
  const double s8_460 = s8_428 + s8_434 - work.r_rear_axle_aux1_x - (-p_arb_rear_right_x);
  const double s8_461 = 0.3333333333333333*s8_460;
  const double s8_462 = mbgen::fma(work.r_rear_axle_aux1_x, s8_139, work.s7_59);
  const double s8_463 = mbgen::fma(work.r_rear_axle_aux3_z, s8_141, s8_462);
  const double s8_464 = mbgen::fnma(s8_232, s8_258, mbgen::fnma(s8_182, s8_210, s8_463));
  const double s8_465 = mbgen::fnma(s8_340, s8_362, mbgen::fma(s8_289, s8_301, s8_464));
  work.s8_466 = mbgen::fma(s8_436, s8_461, mbgen::fnma(s8_383, s8_407, s8_465));
  const double s8_467 = mbgen::fma(z_rear_axle_ty, s8_141, work.s7_61);
  const double s8_468 = mbgen::fma(work.r_rear_axle_aux1_x, s8_140, s8_467);
  const double s8_469 = mbgen::fma(s8_256, s8_258, mbgen::fma(s8_208, s8_210, s8_468));
  const double s8_470 = mbgen::fnma(s8_339, s8_362, mbgen::fnma(s8_299, s8_301, s8_469));
  work.s8_471 = mbgen::fma(s8_430, s8_461, mbgen::fnma(s8_385, s8_407, s8_470));
  const double s8_472 = 0.3333333333333333*s8_436;
  const double s8_473 = mbgen::fma(projection.Rz[57], work.s7_82, s8_152);
  const double s8_474 = mbgen::fnma(projection.Rz[55], work.s7_68, s8_473);
  const double s8_475 = mbgen::fma(z_rear_axle_ty, s8_137, s8_474);
  const double s8_476 = mbgen::fnma(work.r_rear_axle_aux3_z, work.s8_154, s8_475);
  const double s8_477 = mbgen::fma(s8_207, s8_209, mbgen::fma(s8_203, s8_211, s8_476));
  const double s8_478 = mbgen::fma(s8_255, s8_257, mbgen::fma(s8_251, s8_259, s8_477));
  const double s8_479 = mbgen::fma(s8_300, s8_313, mbgen::fma(s8_296, s8_314, s8_478));
  const double s8_480 = mbgen::fnma(s8_355, s8_361, mbgen::fma(s8_351, s8_363, s8_479));
  const double s8_481 = mbgen::fnma(s8_405, s8_406, mbgen::fma(s8_401, s8_408, s8_480));
  const double s8_482 = mbgen::fnma(s8_442, s8_459, mbgen::fma(s8_441, s8_472, s8_481));
  const double s8_483 = mbgen::fnma(projection.Rz[55], work.s7_69, work.s8_31);
  work.s8_484 = mbgen::fma(p_carrier_left_rz_y, s8_483, s8_482);
  const double s8_485 = mbgen::fma((-p_arb_rear_left_z), work.s8_54, s8_163);
  const double s8_486 = mbgen::fnma((-p_arb_rear_right_z), work.s8_30, s8_485);
  const double s8_487 = mbgen::fma(projection.Rz[55], work.s7_70, s8_486);
  const double s8_488 = mbgen::fnma(projection.Rz[57], work.s7_79, s8_487);
  const double s8_489 = mbgen::fma(work.r_rear_axle_aux1_x, work.s8_154, s8_488);
  const double s8_490 = mbgen::fnma(s8_203, s8_210, mbgen::fnma(z_rear_axle_ty, s8_132, s8_489));
  const double s8_491 = mbgen::fnma(s8_251, s8_258, mbgen::fnma(s8_199, s8_209, s8_490));
  const double s8_492 = mbgen::fma(s8_296, s8_301, mbgen::fnma(s8_247, s8_257, s8_491));
  const double s8_493 = mbgen::fma(s8_360, s8_361, mbgen::fnma(s8_300, s8_311, s8_492));
  const double s8_494 = mbgen::fma(s8_397, s8_406, mbgen::fnma(s8_351, s8_362, s8_493));
  const double s8_495 = mbgen::fma(s8_442, s8_457, mbgen::fnma(s8_401, s8_407, s8_494));
  work.s8_496 = mbgen::fma(s8_441, s8_461, s8_495);
  const double s8_497 = work.s8_64 + mbgen::fma((-p_arb_rear_left_z), work.s8_54, s8_172);
  const double s8_498 = mbgen::fma((-p_arb_rear_right_z), work.s8_30, work.s8_34 + s8_497);
  const double s8_499 = mbgen::fma(work.r_rear_axle_aux3_z, s8_132, s8_498);
  const double s8_500 = mbgen::fnma(work.r_rear_axle_aux1_x, s8_137, s8_499);
  const double s8_501 = mbgen::fnma(s8_199, s8_211, mbgen::fma(s8_207, s8_210, s8_500));
  const double s8_502 = mbgen::fnma(s8_247, s8_259, mbgen::fma(s8_255, s8_258, s8_501));
  const double s8_503 = mbgen::fnma(s8_301, s8_313, mbgen::fnma(s8_311, s8_314, s8_502));
  const double s8_504 = mbgen::fnma(s8_360, s8_363, mbgen::fma(s8_355, s8_362, s8_503));
  const double s8_505 = mbgen::fnma(s8_397, s8_408, mbgen::fma(s8_405, s8_407, s8_504));
  const double s8_506 = mbgen::fnma(s8_459, s8_461, mbgen::fnma(s8_457, s8_472, s8_505));
  const double s8_507 = mbgen::fma(projection.Rz[55], work.s7_69, work.s8_31);
  work.s8_508 = mbgen::fnma((-p_arb_rear_right_x), s8_507, s8_506);
  const double s8_509 = mbgen::fnma(s8_182, s8_211, mbgen::fma(s8_139, s8_173, work.s7_66));
  const double s8_510 = mbgen::fnma(s8_289, s8_314, mbgen::fnma(s8_232, s8_259, s8_509));
  const double s8_511 = mbgen::fnma(s8_383, s8_408, mbgen::fnma(s8_340, s8_363, s8_510));
  work.s8_512 = mbgen::fnma(s8_436, s8_472, s8_511);
  const double s8_513 = mbgen::fnma(s8_208, s8_209, mbgen::fma(s8_140, s8_174, work.s7_63));
  const double s8_514 = mbgen::fnma(s8_299, s8_300, mbgen::fnma(s8_256, s8_257, s8_513));
  const double s8_515 = mbgen::fnma(s8_385, s8_406, mbgen::fnma(s8_339, s8_361, s8_514));
  work.s8_516 = mbgen::fnma(s8_430, s8_442, s8_515);
  const double s8_517 = mbgen::fnma(s8_186, s8_210, mbgen::fma(s8_141, s8_175, work.s7_65));
  const double s8_518 = mbgen::fnma(s8_297, s8_301, mbgen::fnma(s8_235, s8_258, s8_517));
  const double s8_519 = mbgen::fnma(s8_387, s8_407, mbgen::fnma(s8_342, s8_362, s8_518));
  work.s8_520 = mbgen::fnma(s8_460, s8_461, s8_519);
  const double s8_521 = mbgen::fma(s8_205, s8_205, mbgen::fma(s8_197, s8_197, s8_201*s8_201));
  const double s8_522 = mbgen::fma(s8_353, s8_353, mbgen::fma(s8_349, s8_349, s8_521));
  const double s8_523 = mbgen::fma(s8_253, s8_253, mbgen::fma(s8_245, s8_245, s8_249*s8_249));
  const double s8_524 = mbgen::fma(s8_395, s8_395, mbgen::fma(s8_399, s8_399, s8_523));
  const double s8_525 = mbgen::fma(s8_309, s8_309, mbgen::fma(s8_307, s8_307, s8_294*s8_294));
  const double s8_526 = mbgen::fma(s8_453, s8_453, mbgen::fma(s8_439, s8_439, s8_525));
  const double s8_527 = mbgen::fma(projection.Rz[54], work.s8_63, projection.Rz[56]*work.s8_33);
  const double s8_528 = mbgen::fma(projection.Rz[44], s8_148, s8_527);
  const double s8_529 = mbgen::fma(projection.Rz[42], s8_130, s8_528);
  const double s8_530 = mbgen::fma(projection.Rz[46], s8_135, s8_529);
  const double s8_531 = mbgen::fma(work.s3_5, s8_159, mbgen::fma(work.s3_2, s8_168, s8_530));
  const double s8_532 = mbgen::fma(work.s3_8, s8_146, s8_531);
  const double s8_533 = mbgen::fnma(3.0, mbgen::fma(s8_358, s8_358, s8_522), s8_532);
  const double s8_534 = mbgen::fma(s8_403, s8_403, s8_524);
  const double s8_535 = mbgen::fnma(2.6666666666666665, s8_534, s8_533);
  const double s8_536 = mbgen::fma(s8_455, s8_455, s8_526);
  const double s8_537 = mbgen::fnma(0.3333333333333333, s8_536, s8_535);
  const double s8_538 = mbgen::fma(s8_205, s8_207, mbgen::fma(s8_197, s8_199, s8_201*s8_203));
  const double s8_539 = mbgen::fma(s8_353, s8_355, mbgen::fma(s8_349, s8_351, s8_538));
  const double s8_540 = mbgen::fma(s8_253, s8_255, mbgen::fma(s8_245, s8_247, s8_249*s8_251));
  const double s8_541 = mbgen::fma(s8_395, s8_397, mbgen::fma(s8_399, s8_401, s8_540));
  const double s8_542 = mbgen::fma(s8_309, s8_313, mbgen::fma(s8_307, s8_311, s8_294*s8_296));
  const double s8_543 = mbgen::fma(s8_453, s8_457, mbgen::fma(s8_439, s8_441, s8_542));
  const double s8_544 = mbgen::fma(projection.Rz[54], work.s8_64, projection.Rz[56]*work.s8_34);
  const double s8_545 = mbgen::fma(projection.Rz[44], work.s8_154, s8_544);
  const double s8_546 = mbgen::fma(projection.Rz[42], s8_132, s8_545);
  const double s8_547 = mbgen::fma(projection.Rz[46], s8_137, s8_546);
  const double s8_548 = mbgen::fma(work.s3_5, s8_163, mbgen::fma(work.s3_2, s8_172, s8_547));
  const double s8_549 = mbgen::fma(work.s3_8, s8_152, s8_548);
  const double s8_550 = mbgen::fnma(3.0, mbgen::fma(s8_358, s8_360, s8_539), s8_549);
  const double s8_551 = mbgen::fma(s8_403, s8_405, s8_541);
  const double s8_552 = mbgen::fnma(2.6666666666666665, s8_551, s8_550);
  const double s8_553 = mbgen::fma(s8_455, s8_459, s8_543);
  work.s8_554 = mbgen::fnma(0.3333333333333333, s8_553, s8_552);
  const double s8_555 = mbgen::fma(s8_207, s8_207, mbgen::fma(s8_199, s8_199, s8_203*s8_203));
  const double s8_556 = mbgen::fma(s8_355, s8_355, mbgen::fma(s8_351, s8_351, s8_555));
  const double s8_557 = mbgen::fma(s8_255, s8_255, mbgen::fma(s8_247, s8_247, s8_251*s8_251));
  const double s8_558 = mbgen::fma(s8_397, s8_397, mbgen::fma(s8_401, s8_401, s8_557));
  const double s8_559 = mbgen::fma(s8_313, s8_313, mbgen::fma(s8_311, s8_311, s8_296*s8_296));
  const double s8_560 = mbgen::fma(s8_457, s8_457, mbgen::fma(s8_441, s8_441, s8_559));
  const double s8_561 = mbgen::fma(projection.Rz[55], work.s8_64, projection.Rz[57]*work.s8_34);
  const double s8_562 = mbgen::fma(projection.Rz[45], work.s8_154, s8_561);
  const double s8_563 = mbgen::fma(projection.Rz[43], s8_132, s8_562);
  const double s8_564 = mbgen::fma(projection.Rz[47], s8_137, s8_563);
  const double s8_565 = mbgen::fma(work.s3_6, s8_163, mbgen::fma(work.s3_4, s8_172, s8_564));
  const double s8_566 = mbgen::fma(work.s3_10, s8_152, s8_565);
  const double s8_567 = mbgen::fnma(3.0, mbgen::fma(s8_360, s8_360, s8_556), s8_566);
  const double s8_568 = mbgen::fma(s8_405, s8_405, s8_558);
  const double s8_569 = mbgen::fnma(2.6666666666666665, s8_568, s8_567);
  const double s8_570 = mbgen::fma(s8_459, s8_459, s8_560);
  const double s8_571 = mbgen::fnma(0.3333333333333333, s8_570, s8_569);
  const double s8_572 = mbgen::fms(work.s8_27, s8_430, projection.zdd_star[15]);
  const double s8_573 = mbgen::fnma(work.s8_21, s8_436, mbgen::fma(work.s8_20, s8_460, s8_572));
  const double s8_574 = mbgen::fnma(work.s8_19, s8_449, mbgen::fma(work.s8_18, s8_451, s8_573));
  const double s8_575 = mbgen::fma(work.s6_12, s8_431, mbgen::fma(work.s6_4, s8_428, s8_574));
  const double s8_576 = mbgen::fma(work.s4_11, s8_450, mbgen::fnma(work.s4_10, s8_448, s8_575));
  const double s8_577 = 0.3333333333333333*s8_576;
  const double s8_578 = mbgen::fms(work.s8_22, s8_460, projection.zdd_star[16]);
  const double s8_579 = mbgen::fnma(work.s8_21, s8_430, mbgen::fma(work.s8_25, s8_436, s8_578));
  const double s8_580 = mbgen::fma(zd_arb_rear_right, s8_433, s8_579);
  const double s8_581 = mbgen::fma(work.s4_9, s8_448, mbgen::fma(work.s4_11, s8_432, s8_580));
  const double s8_582 = mbgen::fnma(projection.zdd_star[21], s8_434, s8_581);
  const double s8_583 = mbgen::fma(work.s6_12, s8_427, mbgen::fnma(work.s6_8, s8_428, s8_582));
  const double s8_584 = mbgen::fnma(work.s8_18, s8_437, mbgen::fma(work.s8_17, s8_449, s8_583));
  const double s8_585 = 0.3333333333333333*s8_584;
  const double s8_586 = mbgen::fms(work.s8_19, s8_437, projection.zdd_star[14]);
  const double s8_587 = mbgen::fnma(work.s8_17, s8_451, s8_586);
  const double s8_588 = mbgen::fnma(projection.zdd_star[21], s8_429, s8_587);
  const double s8_589 = mbgen::fnma(work.s6_8, s8_431, mbgen::fnma(work.s6_4, s8_427, s8_588));
  const double s8_590 = mbgen::fnma(zd_arb_rear_right, s8_435, s8_589);
  const double s8_591 = mbgen::fnma(work.s4_9, s8_450, mbgen::fnma(work.s4_10, s8_432, s8_590));
  const double s8_592 = mbgen::fnma(work.s8_22, s8_436, mbgen::fnma(work.s8_20, s8_430, s8_591));
  const double s8_593 = 0.3333333333333333*mbgen::fnma(work.s8_26, s8_460, s8_592);
  const double s8_594 = tau[Coordinate::rear_axle_tx] - f_rear_axle_x;
  const double s8_595 = tau[Coordinate::rear_axle_ty] - f_rear_axle_y;
  const double s8_596 = tau[Coordinate::rear_axle_tz] - f_rear_axle_z;
  const double s8_597 = mbgen::fnma(projection.zdd_star[20], work.s7_77,
      tau[Coordinate::arb_rear_left]);
  const double s8_598 = mbgen::fma(work.s7_70, work.s8_20, s8_597);
  const double s8_599 = mbgen::fma(work.s7_68, work.s8_21, s8_598);
  const double s8_600 = mbgen::fma(work.s7_71, work.s8_58, s8_599);
  const double s8_601 = mbgen::fma(work.s7_69, work.s8_65, s8_600);
  const double s8_602 = mbgen::fnma(work.s7_74, work.s8_49, s8_601);
  const double s8_603 = mbgen::fnma(work.s8_22, s8_78, s8_602);
  const double s8_604 = mbgen::fnma(projection.zdd_star[21], work.s7_88,
      tau[Coordinate::arb_rear_right]);
  const double s8_605 = mbgen::fnma(work.s7_79, work.s8_20, s8_604);
  const double s8_606 = mbgen::fnma(work.s7_82, work.s8_21, s8_605);
  const double s8_607 = mbgen::fma(work.s7_81, work.s8_44, s8_606);
  const double s8_608 = mbgen::fma(work.s7_80, work.s8_47, s8_607);
  const double s8_609 = mbgen::fnma(work.s7_85, work.s8_49, s8_608);
  const double s8_610 = mbgen::fnma(work.s8_22, work.s8_50, s8_609);
  const double s8_611 = work.s7_34 - n_rear_axle_y;
  const double s8_612 = mbgen::fms(tau[Coordinate::rear_axle_rz], work.s5_70, n_rear_axle_z);
  const double s8_613 = work.s7_36 - n_rear_axle_x;
  const double s8_614 = mbgen::fnma(s8_203, s8_229, projection.Rz[43]*s8_594);
  const double s8_615 = mbgen::fnma(s8_207, s8_223, mbgen::fnma(s8_199, s8_217, s8_614));
  const double s8_616 = mbgen::fnma(s8_247, s8_265, mbgen::fnma(s8_251, s8_277, s8_615));
  const double s8_617 = mbgen::fnma(s8_296, s8_336, mbgen::fnma(s8_255, s8_271, s8_616));
  const double s8_618 = mbgen::fnma(s8_313, s8_322, mbgen::fnma(s8_311, s8_330, s8_617));
  const double s8_619 = mbgen::fnma(s8_355, s8_375, mbgen::fnma(s8_351, s8_369, s8_618));
  const double s8_620 = mbgen::fnma(s8_401, s8_414, mbgen::fnma(s8_360, s8_381, s8_619));
  const double s8_621 = mbgen::fnma(s8_405, s8_420, mbgen::fnma(s8_397, s8_426, s8_620));
  const double s8_622 = mbgen::fnma(s8_457, s8_593, mbgen::fnma(s8_441, s8_577, s8_621));
  const double s8_623 = mbgen::fnma(s8_459, s8_585, s8_622);
  const double s8_624 = mbgen::fma(projection.Rz[45], s8_595, s8_623);
  const double s8_625 = mbgen::fma(projection.Rz[47], s8_596, s8_624);
  const double s8_626 = mbgen::fma(projection.Rz[55], s8_603, s8_625);
  const double s8_627 = mbgen::fma(projection.Rz[57], s8_610, s8_626);
  const double s8_628 = mbgen::fma(work.s3_6, s8_612, mbgen::fma(work.s3_4, s8_611, s8_627));
  work.s8_629 = mbgen::fma(work.s3_10, s8_613, s8_628);
  result.inertia[12] = mbgen::fnma(1e-12, s8_571, s8_571);
  work.s8_630 = 1.0/s8_571;
  const double s8_631 = work.s8_554*work.s8_630;
  const double s8_632 = mbgen::fnma(work.s8_554, s8_631, s8_537);
  result.inertia[11] = mbgen::fnma(1e-12, s8_537, s8_632);
  work.s8_633 = mbgen::fnma(work.s8_154, s8_631, s8_148);
  work.s8_634 = 1.0/s8_632;
  work.s8_635 = work.s8_633*work.s8_634;
  work.s8_636 = mbgen::fnma(work.s8_133, s8_631, s8_130 - work.s8_28 - work.s8_53);
  work.s8_637 = work.s8_634*work.s8_636;
  const double s8_638 = mbgen::fnma(projection.Rz[54], work.s7_69, s8_135 - work.s8_29);
  work.s8_639 = mbgen::fnma(work.s8_138, s8_631, s8_638);
  work.s8_640 = work.s8_634*work.s8_639;
  const double s8_641 = mbgen::fma(projection.Rz[56], work.s7_82, s8_146);
  const double s8_642 = mbgen::fnma(projection.Rz[54], work.s7_68, s8_641);
  const double s8_643 = mbgen::fma(z_rear_axle_ty, s8_135, s8_642);
  const double s8_644 = mbgen::fnma(work.r_rear_axle_aux3_z, s8_148, s8_643);
  const double s8_645 = mbgen::fma(s8_205, s8_209, mbgen::fma(s8_201, s8_211, s8_644));
  const double s8_646 = mbgen::fma(s8_253, s8_257, mbgen::fma(s8_249, s8_259, s8_645));
  const double s8_647 = mbgen::fma(s8_300, s8_309, mbgen::fma(s8_294, s8_314, s8_646));
  const double s8_648 = mbgen::fnma(s8_353, s8_361, mbgen::fma(s8_349, s8_363, s8_647));
  const double s8_649 = mbgen::fnma(s8_403, s8_406, mbgen::fma(s8_399, s8_408, s8_648));
  const double s8_650 = mbgen::fnma(s8_442, s8_455, mbgen::fma(s8_439, s8_472, s8_649));
  const double s8_651 = mbgen::fnma(projection.Rz[54], work.s7_69, work.s8_29);
  const double s8_652 = mbgen::fnma(work.s8_484, s8_631, s8_650);
  work.s8_653 = mbgen::fma(p_carrier_left_rz_y, s8_651, s8_652);
  work.s8_654 = work.s8_634*work.s8_653;
  const double s8_655 = mbgen::fma((-p_arb_rear_left_z), work.s8_53, s8_159);
  const double s8_656 = mbgen::fnma((-p_arb_rear_right_z), work.s8_28, s8_655);
  const double s8_657 = mbgen::fma(projection.Rz[54], work.s7_70, s8_656);
  const double s8_658 = mbgen::fnma(projection.Rz[56], work.s7_79, s8_657);
  const double s8_659 = mbgen::fma(work.r_rear_axle_aux1_x, s8_148, s8_658);
  const double s8_660 = mbgen::fnma(s8_201, s8_210, mbgen::fnma(z_rear_axle_ty, s8_130, s8_659));
  const double s8_661 = mbgen::fnma(s8_249, s8_258, mbgen::fnma(s8_197, s8_209, s8_660));
  const double s8_662 = mbgen::fma(s8_294, s8_301, mbgen::fnma(s8_245, s8_257, s8_661));
  const double s8_663 = mbgen::fma(s8_358, s8_361, mbgen::fnma(s8_300, s8_307, s8_662));
  const double s8_664 = mbgen::fma(s8_395, s8_406, mbgen::fnma(s8_349, s8_362, s8_663));
  const double s8_665 = mbgen::fma(s8_442, s8_453, mbgen::fnma(s8_399, s8_407, s8_664));
  work.s8_666 = mbgen::fnma(work.s8_496, s8_631, mbgen::fma(s8_439, s8_461, s8_665));
  work.s8_667 = work.s8_634*work.s8_666;
  const double s8_668 = work.s8_63 + mbgen::fma((-p_arb_rear_left_z), work.s8_53, s8_168);
  const double s8_669 = mbgen::fma((-p_arb_rear_right_z), work.s8_28, work.s8_33 + s8_668);
  const double s8_670 = mbgen::fma(work.r_rear_axle_aux3_z, s8_130, s8_669);
  const double s8_671 = mbgen::fnma(work.r_rear_axle_aux1_x, s8_135, s8_670);
  const double s8_672 = mbgen::fnma(s8_197, s8_211, mbgen::fma(s8_205, s8_210, s8_671));
  const double s8_673 = mbgen::fnma(s8_245, s8_259, mbgen::fma(s8_253, s8_258, s8_672));
  const double s8_674 = mbgen::fnma(s8_301, s8_309, mbgen::fnma(s8_307, s8_314, s8_673));
  const double s8_675 = mbgen::fnma(s8_358, s8_363, mbgen::fma(s8_353, s8_362, s8_674));
  const double s8_676 = mbgen::fnma(s8_395, s8_408, mbgen::fma(s8_403, s8_407, s8_675));
  const double s8_677 = mbgen::fnma(s8_455, s8_461, mbgen::fnma(s8_453, s8_472, s8_676));
  const double s8_678 = mbgen::fma(projection.Rz[54], work.s7_69, work.s8_29);
  const double s8_679 = mbgen::fnma(work.s8_508, s8_631, s8_677);
  work.s8_680 = mbgen::fnma((-p_arb_rear_right_x), s8_678, s8_679);
  work.s8_681 = work.s8_634*work.s8_680;
  work.s8_682 = work.s8_154*work.s8_630;
  const double s8_683 = mbgen::fnma(s8_201, s8_229, projection.Rz[42]*s8_594);
  const double s8_684 = mbgen::fnma(s8_205, s8_223, mbgen::fnma(s8_197, s8_217, s8_683));
  const double s8_685 = mbgen::fnma(s8_245, s8_265, mbgen::fnma(s8_249, s8_277, s8_684));
  const double s8_686 = mbgen::fnma(s8_294, s8_336, mbgen::fnma(s8_253, s8_271, s8_685));
  const double s8_687 = mbgen::fnma(s8_309, s8_322, mbgen::fnma(s8_307, s8_330, s8_686));
  const double s8_688 = mbgen::fnma(s8_353, s8_375, mbgen::fnma(s8_349, s8_369, s8_687));
  const double s8_689 = mbgen::fnma(s8_399, s8_414, mbgen::fnma(s8_358, s8_381, s8_688));
  const double s8_690 = mbgen::fnma(s8_403, s8_420, mbgen::fnma(s8_395, s8_426, s8_689));
  const double s8_691 = mbgen::fnma(s8_453, s8_593, mbgen::fnma(s8_439, s8_577, s8_690));
  const double s8_692 = mbgen::fnma(work.s8_629, s8_631, mbgen::fnma(s8_455, s8_585, s8_691));
  const double s8_693 = mbgen::fma(projection.Rz[44], s8_595, s8_692);
  const double s8_694 = mbgen::fma(projection.Rz[46], s8_596, s8_693);
  const double s8_695 = mbgen::fma(projection.Rz[54], s8_603, s8_694);
  const double s8_696 = mbgen::fma(projection.Rz[56], s8_610, s8_695);
  const double s8_697 = mbgen::fma(work.s3_5, s8_612, mbgen::fma(work.s3_2, s8_611, s8_696));
  work.s8_698 = mbgen::fma(work.s3_8, s8_613, s8_697);
  const double s8_699 = work.s8_41 + work.s8_61;
  const double s8_700 = mbgen::fma(work.s8_629, work.s8_682, f_rear_axle_y + s8_699);
  work.s8_701 = mbgen::fma(work.s8_635, work.s8_698, s8_700);
  work.s8_702 = work.s8_133*work.s8_630;
  const double s8_703 = f_rear_axle_x - work.s8_39 - work.s8_74;
  const double s8_704 = mbgen::fma(work.s8_629, work.s8_702, s8_703);
  work.s8_705 = mbgen::fma(work.s8_637, work.s8_698, s8_704);
  work.s8_706 = work.s8_138*work.s8_630;
  const double s8_707 = work.s8_48 + work.s8_66;
  const double s8_708 = mbgen::fma(work.s8_629, work.s8_706, f_rear_axle_z + s8_707);
  work.s8_709 = mbgen::fma(work.s8_640, work.s8_698, s8_708);
  work.s8_710 = work.s8_484*work.s8_630;
  const double s8_711 = mbgen::fma(work.s8_629, work.s8_710, n_rear_axle_x);
  const double s8_712 = mbgen::fma(projection.zdd_star[21], work.s7_82, s8_711);
  const double s8_713 = mbgen::fnma(work.s7_79, work.s8_35, s8_712);
  const double s8_714 = mbgen::fnma(work.s7_85, work.s8_40, s8_713);
  const double s8_715 = mbgen::fnma(work.s7_87, work.s8_37, s8_714);
  const double s8_716 = mbgen::fma(work.s7_70, work.s8_55, s8_715);
  const double s8_717 = mbgen::fnma(projection.zdd_star[20], work.s7_68, s8_716);
  const double s8_718 = mbgen::fnma(work.s7_74, work.s8_60, s8_717);
  const double s8_719 = mbgen::fnma(work.s7_76, work.s8_59, s8_718);
  const double s8_720 = mbgen::fma(z_rear_axle_ty, f_rear_axle_z, s8_719);
  const double s8_721 = mbgen::fnma(work.r_rear_axle_aux3_z, f_rear_axle_y, s8_720);
  const double s8_722 = mbgen::fnma(s8_182, s8_229, mbgen::fnma(s8_208, s8_223, s8_721));
  const double s8_723 = mbgen::fnma(s8_232, s8_277, mbgen::fnma(s8_256, s8_271, s8_722));
  const double s8_724 = mbgen::fnma(s8_289, s8_336, mbgen::fnma(s8_299, s8_322, s8_723));
  const double s8_725 = mbgen::fnma(s8_340, s8_369, mbgen::fma(s8_339, s8_375, s8_724));
  const double s8_726 = mbgen::fnma(s8_383, s8_414, mbgen::fma(s8_385, s8_420, s8_725));
  const double s8_727 = mbgen::fnma(s8_436, s8_577, mbgen::fma(s8_430, s8_585, s8_726));
  const double s8_728 = work.s8_41 + (work.s8_61 + work.s8_66) - work.s8_48;
  const double s8_729 = mbgen::fma(work.s8_654, work.s8_698, s8_727);
  work.s8_730 = mbgen::fma(p_carrier_left_rz_y, s8_728, s8_729);
  work.s8_731 = work.s8_496*work.s8_630;
  const double s8_732 = mbgen::fma((-p_arb_rear_left_z), work.s8_74, n_rear_axle_z);
  const double s8_733 = mbgen::fnma((-p_arb_rear_right_z), work.s8_39, s8_732);
  const double s8_734 = mbgen::fma(work.s8_629, work.s8_731, s8_733);
  const double s8_735 = mbgen::fma(work.s7_86, work.s8_40, s8_734);
  const double s8_736 = mbgen::fma(work.s7_85, work.s8_37, s8_735);
  const double s8_737 = mbgen::fnma(projection.zdd_star[21], work.s7_79, s8_736);
  const double s8_738 = mbgen::fnma(work.s7_82, work.s8_35, s8_737);
  const double s8_739 = mbgen::fma(projection.zdd_star[20], work.s7_70, s8_738);
  const double s8_740 = mbgen::fma(work.s7_68, work.s8_55, s8_739);
  const double s8_741 = mbgen::fma(work.s7_75, work.s8_60, s8_740);
  const double s8_742 = mbgen::fma(work.s7_74, work.s8_59, s8_741);
  const double s8_743 = mbgen::fma(work.r_rear_axle_aux1_x, f_rear_axle_y, s8_742);
  const double s8_744 = mbgen::fnma(z_rear_axle_ty, f_rear_axle_x, s8_743);
  const double s8_745 = mbgen::fma(s8_186, s8_229, mbgen::fma(s8_208, s8_217, s8_744));
  const double s8_746 = mbgen::fma(s8_235, s8_277, mbgen::fma(s8_256, s8_265, s8_745));
  const double s8_747 = mbgen::fnma(s8_297, s8_336, mbgen::fma(s8_299, s8_330, s8_746));
  const double s8_748 = mbgen::fnma(s8_339, s8_381, mbgen::fma(s8_342, s8_369, s8_747));
  const double s8_749 = mbgen::fnma(s8_385, s8_426, mbgen::fma(s8_387, s8_414, s8_748));
  const double s8_750 = mbgen::fnma(s8_430, s8_593, mbgen::fnma(s8_460, s8_577, s8_749));
  const double s8_751 = mbgen::fma(work.s8_667, work.s8_698, s8_750);
  work.s8_752 = mbgen::fnma((-p_arb_rear_right_x), s8_699, s8_751);
  work.s8_753 = work.s8_508*work.s8_630;
  const double s8_754 = mbgen::fma((-p_arb_rear_left_z), work.s8_74, n_rear_axle_y);
  const double s8_755 = mbgen::fma(projection.zdd_star[20], work.s7_77, s8_754);
  const double s8_756 = mbgen::fma(projection.zdd_star[21], work.s7_88, s8_755);
  const double s8_757 = mbgen::fma((-p_arb_rear_right_z), work.s8_39, s8_756);
  const double s8_758 = mbgen::fma(work.s8_629, work.s8_753, s8_757);
  const double s8_759 = mbgen::fma(work.r_rear_axle_aux3_z, f_rear_axle_x, s8_758);
  const double s8_760 = mbgen::fnma(work.r_rear_axle_aux1_x, f_rear_axle_z, s8_759);
  const double s8_761 = mbgen::fnma(s8_186, s8_223, mbgen::fma(s8_182, s8_217, s8_760));
  const double s8_762 = mbgen::fnma(s8_235, s8_271, mbgen::fma(s8_232, s8_265, s8_761));
  const double s8_763 = mbgen::fma(s8_289, s8_330, mbgen::fma(s8_297, s8_322, s8_762));
  const double s8_764 = mbgen::fnma(s8_342, s8_375, mbgen::fma(s8_340, s8_381, s8_763));
  const double s8_765 = mbgen::fnma(s8_387, s8_420, mbgen::fma(s8_383, s8_426, s8_764));
  const double s8_766 = mbgen::fma(s8_436, s8_593, mbgen::fma(s8_460, s8_585, s8_765));
  const double s8_767 = mbgen::fma(work.s8_681, work.s8_698, s8_766);
  work.s8_768 = mbgen::fma((-p_arb_rear_right_x), s8_707, s8_767);
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
  work.s8_769 = mbgen::fma(work.s8_154, work.s8_682, work.s8_633*work.s8_635);
  work.s8_770 = mbgen::fma(work.s8_154, work.s8_702, work.s8_633*work.s8_637);
  work.s8_771 = mbgen::fma(work.s8_133, work.s8_702, work.s8_636*work.s8_637);
  work.s8_772 = mbgen::fma(work.s8_138, work.s8_682, work.s8_635*work.s8_639);
  work.s8_773 = mbgen::fma(work.s8_138, work.s8_702, work.s8_637*work.s8_639);
  work.s8_774 = mbgen::fma(work.s8_138, work.s8_706, work.s8_639*work.s8_640);
  work.s8_775 = mbgen::fma(work.s8_484, work.s8_682, work.s8_635*work.s8_653);
  work.s8_776 = mbgen::fma(work.s8_484, work.s8_702, work.s8_637*work.s8_653);
  work.s8_777 = mbgen::fma(work.s8_484, work.s8_706, work.s8_640*work.s8_653);
  work.s8_778 = mbgen::fma(work.s8_484, work.s8_710, work.s8_653*work.s8_654);
  work.s8_779 = mbgen::fma(work.s8_496, work.s8_682, work.s8_635*work.s8_666);
  work.s8_780 = mbgen::fma(work.s8_496, work.s8_702, work.s8_637*work.s8_666);
  work.s8_781 = mbgen::fma(work.s8_496, work.s8_706, work.s8_640*work.s8_666);
  work.s8_782 = mbgen::fma(work.s8_496, work.s8_710, work.s8_654*work.s8_666);
  work.s8_783 = mbgen::fma(work.s8_496, work.s8_731, work.s8_666*work.s8_667);
  work.s8_784 = mbgen::fma(work.s8_496, work.s8_753, work.s8_666*work.s8_681);
  work.s8_785 = mbgen::fma(work.s8_508, work.s8_682, work.s8_635*work.s8_680);
  work.s8_786 = mbgen::fma(work.s8_508, work.s8_702, work.s8_637*work.s8_680);
  work.s8_787 = mbgen::fma(work.s8_508, work.s8_706, work.s8_640*work.s8_680);
  work.s8_788 = mbgen::fma(work.s8_508, work.s8_710, work.s8_654*work.s8_680);
  work.s8_789 = mbgen::fma(work.s8_508, work.s8_753, work.s8_680*work.s8_681);
  // operations: 943 add, 988 multiply, 2 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s8_790 = work.s1_28*work.w_carrier_right_z;
  const double s8_791 = work.s1_28*work.w_carrier_right_y;
  const double s8_792 = mbgen::fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_y,
      state.zd[Coordinate::wheel_front_right]);
  const double s8_793 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s8_792);
  const double s8_794 = mbgen::fnma(work.s1_28, work.w_carrier_right_x, s8_793);
  const double s8_795 = I_wheel_front_right_polar*s8_794;
  const double tau_wheel_front_right = tau[Coordinate::wheel_front_right];
  const double s8_796 = mbgen::fma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_x, s8_791);
  const double s8_797 = work.R_carrier_right_aux2_z_y*tau_wheel_front_right;
  const double s8_798 = mbgen::fma(s8_796, s8_795, s8_797);
  const double s8_799 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_x, s8_790);
  const double s8_800 = work.R_carrier_right_aux2_y_y*tau_wheel_front_right;
  const double s8_801 = mbgen::fnma(s8_799, s8_795, s8_800);
  const double s8_802 = work.R_carrier_right_aux2_z_y*work.w_carrier_right_y;
  const double s8_803 = mbgen::fnma(work.R_carrier_right_aux2_y_y, work.w_carrier_right_z, s8_802);
  const double s8_804 = mbgen::fnma(work.s1_28, tau_wheel_front_right, s8_795*s8_803);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s8_805 = work.s1_12*work.w_carrier_left_z;
  const double s8_806 = work.s1_12*work.w_carrier_left_y;
  const double s8_807 = mbgen::fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_y,
      state.zd[Coordinate::wheel_front_left]);
  const double s8_808 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s8_807);
  const double s8_809 = mbgen::fnma(work.s1_12, work.w_carrier_left_x, s8_808);
  const double s8_810 = I_wheel_front_left_polar*s8_809;
  const double tau_wheel_front_left = tau[Coordinate::wheel_front_left];
  const double s8_811 = mbgen::fma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_x, s8_806);
  const double s8_812 = work.R_carrier_left_aux2_z_y*tau_wheel_front_left;
  const double s8_813 = mbgen::fma(s8_811, s8_810, s8_812);
  const double s8_814 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_x, s8_805);
  const double s8_815 = work.R_carrier_left_aux2_y_y*tau_wheel_front_left;
  const double s8_816 = mbgen::fnma(s8_814, s8_810, s8_815);
  const double s8_817 = work.R_carrier_left_aux2_z_y*work.w_carrier_left_y;
  const double s8_818 = mbgen::fnma(work.R_carrier_left_aux2_y_y, work.w_carrier_left_z, s8_817);
  const double s8_819 = mbgen::fnma(work.s1_12, tau_wheel_front_left, s8_810*s8_818);

  // --- step 3: Rz (61), upper_ball_left .. tie_rod_right ---
  const double R_carrier_left_aux1_x_x = work.cosines[4];
  const double s3_11 = R_carrier_left_aux1_x_x*projection.Rz[6];
  work.s3_12 = mbgen::fnma(work.s1_12, projection.Rz[9], s3_11);
  const double s3_13 = R_carrier_left_aux1_x_x*projection.Rz[7];
  work.s3_14 = mbgen::fnma(work.s1_12, projection.Rz[10], s3_13);
  const double s3_15 = R_carrier_left_aux1_x_x*projection.Rz[8];
  work.s3_16 = mbgen::fnma(work.s1_12, projection.Rz[11], s3_15);
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double s3_17 = R_carrier_right_aux1_x_x*projection.Rz[24];
  work.s3_18 = mbgen::fnma(work.s1_28, projection.Rz[27], s3_17);
  const double s3_19 = R_carrier_right_aux1_x_x*projection.Rz[25];
  work.s3_20 = mbgen::fnma(work.s1_28, projection.Rz[28], s3_19);
  const double s3_21 = R_carrier_right_aux1_x_x*projection.Rz[26];
  work.s3_22 = mbgen::fnma(work.s1_28, projection.Rz[29], s3_21);
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s3_23 = work.R_carrier_left_aux2_z_y*projection.Rz[9];
  const double s3_24 = mbgen::fma(R_lower_arm_left_y_y, projection.Rz[3], s3_23);
  work.s3_25 = mbgen::fma(work.R_carrier_left_aux1_z_x, projection.Rz[6], s3_24);
  const double s3_26 = work.R_carrier_left_aux2_z_y*projection.Rz[10];
  const double s3_27 = mbgen::fma(R_lower_arm_left_y_y, projection.Rz[4], s3_26);
  work.s3_28 = mbgen::fma(work.R_carrier_left_aux1_z_x, projection.Rz[7], s3_27);
  const double s3_29 = work.R_carrier_left_aux2_z_y*projection.Rz[11];
  const double s3_30 = mbgen::fma(R_lower_arm_left_y_y, projection.Rz[5], s3_29);
  work.s3_31 = mbgen::fma(work.R_carrier_left_aux1_z_x, projection.Rz[8], s3_30);
  const double s3_32 = work.R_carrier_left_aux2_y_y*projection.Rz[9];
  const double R_lower_arm_left_z_y = work.sines[3];
  const double s3_33 = mbgen::fma(work.R_carrier_left_aux1_y_x, projection.Rz[6], s3_32);
  work.s3_34 = mbgen::fnma(R_lower_arm_left_z_y, projection.Rz[3], s3_33);
  const double s3_35 = work.R_carrier_left_aux2_y_y*projection.Rz[10];
  const double s3_36 = mbgen::fma(work.R_carrier_left_aux1_y_x, projection.Rz[7], s3_35);
  work.s3_37 = mbgen::fnma(R_lower_arm_left_z_y, projection.Rz[4], s3_36);
  const double s3_38 = work.R_carrier_left_aux2_y_y*projection.Rz[11];
  const double s3_39 = mbgen::fma(work.R_carrier_left_aux1_y_x, projection.Rz[8], s3_38);
  work.s3_40 = mbgen::fnma(R_lower_arm_left_z_y, projection.Rz[5], s3_39);
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s3_41 = work.R_carrier_right_aux2_z_y*projection.Rz[27];
  const double s3_42 = mbgen::fma(R_lower_arm_right_y_y, projection.Rz[21], s3_41);
  work.s3_43 = mbgen::fma(work.R_carrier_right_aux1_z_x, projection.Rz[24], s3_42);
  const double s3_44 = work.R_carrier_right_aux2_z_y*projection.Rz[28];
  const double s3_45 = mbgen::fma(R_lower_arm_right_y_y, projection.Rz[22], s3_44);
  work.s3_46 = mbgen::fma(work.R_carrier_right_aux1_z_x, projection.Rz[25], s3_45);
  const double s3_47 = work.R_carrier_right_aux2_z_y*projection.Rz[29];
  const double s3_48 = mbgen::fma(R_lower_arm_right_y_y, projection.Rz[23], s3_47);
  work.s3_49 = mbgen::fma(work.R_carrier_right_aux1_z_x, projection.Rz[26], s3_48);
  const double s3_50 = work.R_carrier_right_aux2_y_y*projection.Rz[27];
  const double R_lower_arm_right_z_y = work.sines[9];
  const double s3_51 = mbgen::fma(work.R_carrier_right_aux1_y_x, projection.Rz[24], s3_50);
  work.s3_52 = mbgen::fnma(R_lower_arm_right_z_y, projection.Rz[21], s3_51);
  const double s3_53 = work.R_carrier_right_aux2_y_y*projection.Rz[28];
  const double s3_54 = mbgen::fma(work.R_carrier_right_aux1_y_x, projection.Rz[25], s3_53);
  work.s3_55 = mbgen::fnma(R_lower_arm_right_z_y, projection.Rz[22], s3_54);
  const double s3_56 = work.R_carrier_right_aux2_y_y*projection.Rz[29];
  const double s3_57 = mbgen::fma(work.R_carrier_right_aux1_y_x, projection.Rz[26], s3_56);
  work.s3_58 = mbgen::fnma(R_lower_arm_right_z_y, projection.Rz[23], s3_57);
  // operations: 30 add, 48 multiply

  // --- step 6: c and dRz/dt zd (62), upper_ball_left .. tie_rod_right ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  work.s6_13 = zd_lower_arm_left*zd_lower_arm_left;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s6_14 = work.s1_8*work.s6_13;
  work.s6_15 = work.s1_10*work.s6_13;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double zd_upper_arm_left = state.zd[Coordinate::upper_arm_left];
  const double s6_16 = zd_upper_arm_left*zd_upper_arm_left;
  // arb_front_left: arb_front_left, revolute, chassis
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s6_17 = zd_arb_front_left*zd_arb_front_left;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double zd_lower_arm_right = state.zd[Coordinate::lower_arm_right];
  work.s6_18 = zd_lower_arm_right*zd_lower_arm_right;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s6_19 = work.s1_23*work.s6_18;
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double zd_upper_arm_right = state.zd[Coordinate::upper_arm_right];
  const double s6_20 = zd_upper_arm_right*zd_upper_arm_right;
  // arb_front_right: arb_front_right, revolute, chassis
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s6_21 = zd_arb_front_right*zd_arb_front_right;
  // pitman_arm: pitman_arm, revolute, chassis
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s6_22 = zd_pitman_arm*zd_pitman_arm;
  // bell_crank: bell_crank, revolute, chassis
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s6_23 = zd_bell_crank*zd_bell_crank;
  const double s6_24 = mbgen::fnma(work.s5_11, work.s4_1, work.s5_12*work.s4_3);
  const double s6_25 = mbgen::fma(R_carrier_left_aux1_x_x, projection.zdd_star[2], s6_24);
  const double s6_26 = mbgen::fnma(work.s5_6, work.s5_10, s6_25);
  const double s6_27 = mbgen::fnma(work.s5_7, work.s5_9, s6_26);
  const double s6_28 = mbgen::fnma(work.s1_12, projection.zdd_star[3], s6_27);
  const double s6_29 = mbgen::fnma(work.s5_18, work.s4_5, work.s5_19*work.s4_7);
  const double s6_30 = mbgen::fma(R_carrier_right_aux1_x_x, projection.zdd_star[8], s6_29);
  const double s6_31 = mbgen::fnma(work.s5_13, work.s5_17, s6_30);
  const double s6_32 = mbgen::fnma(work.s5_14, work.s5_16, s6_31);
  const double s6_33 = mbgen::fnma(work.s1_28, projection.zdd_star[9], s6_32);
  const double s6_34 = mbgen::fma(state.zd[Coordinate::carrier_left_ry], work.s1_12,
      zd_lower_arm_left);
  const double s6_35 = work.s5_11*work.s4_12;
  const double s6_36 = mbgen::fma(work.R_carrier_left_aux2_z_y, projection.zdd_star[3], s6_35);
  const double s6_37 = mbgen::fma(work.s5_6, work.s5_8, s6_36);
  const double s6_38 = mbgen::fma(work.R_carrier_left_aux1_z_x, projection.zdd_star[2], s6_37);
  const double s6_39 = mbgen::fma(R_lower_arm_left_y_y, projection.zdd_star[1], s6_38);
  work.s6_40 = mbgen::fma(work.s4_3, s6_34, s6_39);
  const double s6_41 = mbgen::fma(state.zd[Coordinate::carrier_right_ry], work.s1_28,
      zd_lower_arm_right);
  const double s6_42 = work.s5_18*work.s4_16;
  const double s6_43 = mbgen::fma(work.R_carrier_right_aux2_z_y, projection.zdd_star[9], s6_42);
  const double s6_44 = mbgen::fma(work.s5_13, work.s5_15, s6_43);
  const double s6_45 = mbgen::fma(work.R_carrier_right_aux1_z_x, projection.zdd_star[8], s6_44);
  const double s6_46 = mbgen::fma(R_lower_arm_right_y_y, projection.zdd_star[7], s6_45);
  work.s6_47 = mbgen::fma(work.s4_7, s6_41, s6_46);
  const double s6_48 = work.R_carrier_left_aux2_y_y*projection.zdd_star[3];
  const double s6_49 = mbgen::fma(work.s5_7, work.s5_8, s6_48);
  const double s6_50 = mbgen::fma(work.R_carrier_left_aux1_y_x, projection.zdd_star[2], s6_49);
  const double s6_51 = mbgen::fnma(R_lower_arm_left_z_y, projection.zdd_star[1], s6_50);
  const double s6_52 = mbgen::fnma(work.s5_12, work.s4_12, s6_51);
  work.s6_53 = mbgen::fnma(work.s4_1, s6_34, s6_52);
  const double s6_54 = work.R_carrier_right_aux2_y_y*projection.zdd_star[9];
  const double s6_55 = mbgen::fma(work.s5_14, work.s5_15, s6_54);
  const double s6_56 = mbgen::fma(work.R_carrier_right_aux1_y_x, projection.zdd_star[8], s6_55);
  const double s6_57 = mbgen::fnma(R_lower_arm_right_z_y, projection.zdd_star[7], s6_56);
  const double s6_58 = mbgen::fnma(work.s5_19, work.s4_16, s6_57);
  work.s6_59 = mbgen::fnma(work.s4_5, s6_41, s6_58);
  // operations: 32 add, 49 multiply

  // --- step 7: inertias of the bodies and forces on joints, upper_ball_left .. tie_rod_right ---
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s7_90 = (-h_lower_arm_left_z)*R_lower_arm_left_z_y;
  work.s7_91 = mbgen::fma(h_lower_arm_left_y, R_lower_arm_left_y_y, s7_90);
  const double s7_92 = h_lower_arm_left_y*R_lower_arm_left_z_y;
  work.s7_93 = mbgen::fnma((-h_lower_arm_left_z), R_lower_arm_left_y_y, s7_92);
  const double s7_94 = K_lower_arm_left_zz*R_lower_arm_left_z_y;
  const double s7_95 = mbgen::fma((-K_lower_arm_left_yz), R_lower_arm_left_y_y, s7_94);
  const double s7_96 = (-K_lower_arm_left_yz)*R_lower_arm_left_z_y;
  const double s7_97 = mbgen::fma(K_lower_arm_left_yy, R_lower_arm_left_y_y, s7_96);
  work.s7_98 = mbgen::fnma(R_lower_arm_left_y_y, s7_95, R_lower_arm_left_z_y*s7_97);
  work.s7_99 = mbgen::fma(R_lower_arm_left_y_y, s7_97, R_lower_arm_left_z_y*s7_95);
  work.s7_100 = 1.825625 - work.s7_99;
  work.s7_101 = work.s7_99 + work.s7_100;
  work.s7_102 = K_lower_arm_left_xx + work.s7_101;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_103 = h_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_104 = mbgen::fma(h_carrier_left_z, work.R_carrier_left_z_z, s7_103);
  work.s7_105 = mbgen::fnma((-h_carrier_left_x), work.R_carrier_left_z_x, s7_104);
  const double s7_106 = h_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_107 = mbgen::fma(h_carrier_left_z, work.R_carrier_left_y_z, s7_106);
  work.s7_108 = mbgen::fnma((-h_carrier_left_x), work.R_carrier_left_y_x, s7_107);
  const double s7_109 = h_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_110 = mbgen::fnma((-h_carrier_left_x), work.R_carrier_left_x_x, s7_109);
  work.s7_111 = mbgen::fnma(h_carrier_left_y, work.s1_12, s7_110);
  const double s7_112 = K_carrier_left_yz*work.R_carrier_left_x_z;
  const double s7_113 = mbgen::fma(K_carrier_left_xy, work.R_carrier_left_x_x, s7_112);
  const double s7_114 = mbgen::fnma(K_carrier_left_yy, work.s1_12, s7_113);
  const double s7_115 = K_carrier_left_yy*work.R_carrier_left_aux2_y_y;
  const double s7_116 = mbgen::fma(K_carrier_left_xy, work.R_carrier_left_y_x, s7_115);
  const double s7_117 = mbgen::fma(K_carrier_left_yz, work.R_carrier_left_y_z, s7_116);
  const double s7_118 = K_carrier_left_yz*work.R_carrier_left_aux2_y_y;
  const double s7_119 = mbgen::fma(K_carrier_left_zz, work.R_carrier_left_y_z, s7_118);
  const double s7_120 = mbgen::fnma((-K_carrier_left_xz), work.R_carrier_left_y_x, s7_119);
  const double s7_121 = K_carrier_left_xy*work.R_carrier_left_aux2_y_y;
  const double s7_122 = mbgen::fma(K_carrier_left_xx, work.R_carrier_left_y_x, s7_121);
  const double s7_123 = mbgen::fnma((-K_carrier_left_xz), work.R_carrier_left_y_z, s7_122);
  const double s7_124 = work.R_carrier_left_aux2_z_y*s7_117;
  const double s7_125 = mbgen::fma(work.R_carrier_left_z_z, s7_120, s7_124);
  work.s7_126 = mbgen::fma(work.R_carrier_left_z_x, s7_123, s7_125);
  const double s7_127 = K_carrier_left_zz*work.R_carrier_left_x_z;
  const double s7_128 = mbgen::fnma((-K_carrier_left_xz), work.R_carrier_left_x_x, s7_127);
  const double s7_129 = mbgen::fnma(K_carrier_left_yz, work.s1_12, s7_128);
  const double s7_130 = K_carrier_left_xx*work.R_carrier_left_x_x;
  const double s7_131 = mbgen::fnma((-K_carrier_left_xz), work.R_carrier_left_x_z, s7_130);
  const double s7_132 = mbgen::fnma(K_carrier_left_xy, work.s1_12, s7_131);
  const double s7_133 = work.R_carrier_left_aux2_z_y*s7_114;
  const double s7_134 = mbgen::fma(work.R_carrier_left_z_z, s7_129, s7_133);
  work.s7_135 = mbgen::fma(work.R_carrier_left_z_x, s7_132, s7_134);
  const double s7_136 = work.R_carrier_left_aux2_y_y*s7_114;
  const double s7_137 = mbgen::fma(work.R_carrier_left_y_x, s7_132, s7_136);
  work.s7_138 = mbgen::fma(work.R_carrier_left_y_z, s7_129, s7_137);
  const double s7_139 = work.R_carrier_left_aux2_y_y*s7_117;
  const double s7_140 = mbgen::fma(work.R_carrier_left_y_x, s7_123, s7_139);
  work.s7_141 = mbgen::fma(work.R_carrier_left_y_z, s7_120, s7_140);
  const double s7_142 = work.R_carrier_left_x_z*s7_129;
  const double s7_143 = mbgen::fma(work.R_carrier_left_x_x, s7_132, s7_142);
  work.s7_144 = mbgen::fnma(work.s1_12, s7_114, s7_143);
  work.s7_145 = K_carrier_left_trace - work.s7_144 - work.s7_141;
  work.s7_146 = work.s7_144 + (work.s7_141 + work.s7_145);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_147 = (-h_upper_arm_left_z)*R_upper_arm_left_z_y;
  work.s7_148 = mbgen::fma(h_upper_arm_left_y, R_upper_arm_left_y_y, s7_147);
  const double s7_149 = h_upper_arm_left_y*R_upper_arm_left_z_y;
  work.s7_150 = mbgen::fnma((-h_upper_arm_left_z), R_upper_arm_left_y_y, s7_149);
  const double s7_151 = K_upper_arm_left_zz*R_upper_arm_left_z_y;
  const double s7_152 = mbgen::fma((-K_upper_arm_left_yz), R_upper_arm_left_y_y, s7_151);
  const double s7_153 = (-K_upper_arm_left_yz)*R_upper_arm_left_z_y;
  const double s7_154 = mbgen::fma(K_upper_arm_left_yy, R_upper_arm_left_y_y, s7_153);
  work.s7_155 = mbgen::fnma(R_upper_arm_left_y_y, s7_152, R_upper_arm_left_z_y*s7_154);
  work.s7_156 = mbgen::fma(R_upper_arm_left_y_y, s7_154, R_upper_arm_left_z_y*s7_152);
  work.s7_157 = 0.539 - work.s7_156;
  work.s7_158 = work.s7_156 + work.s7_157;
  const double s7_159 = K_upper_arm_left_xx + work.s7_158;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_160 = (-K_arb_front_left_xy)*R_arb_front_left_x_z;
  work.s7_161 = mbgen::fma(K_arb_front_left_yz, R_arb_front_left_x_x, s7_160);
  const double s7_162 = (-h_arb_front_left_x)*R_arb_front_left_x_z;
  work.s7_163 = mbgen::fma(h_arb_front_left_z, R_arb_front_left_x_x, s7_162);
  const double s7_164 = K_arb_front_left_yz*R_arb_front_left_x_z;
  work.s7_165 = mbgen::fnma((-K_arb_front_left_xy), R_arb_front_left_x_x, s7_164);
  const double s7_166 = h_arb_front_left_z*R_arb_front_left_x_z;
  work.s7_167 = mbgen::fnma((-h_arb_front_left_x), R_arb_front_left_x_x, s7_166);
  const double s7_168 = K_arb_front_left_zz*R_arb_front_left_x_z;
  const double s7_169 = mbgen::fnma((-K_arb_front_left_xz), R_arb_front_left_x_x, s7_168);
  const double s7_170 = K_arb_front_left_xx*R_arb_front_left_x_x;
  const double s7_171 = mbgen::fnma((-K_arb_front_left_xz), R_arb_front_left_x_z, s7_170);
  work.s7_172 = mbgen::fnma(R_arb_front_left_x_z, s7_171, R_arb_front_left_x_x*s7_169);
  work.s7_173 = mbgen::fma(R_arb_front_left_x_x, s7_171, R_arb_front_left_x_z*s7_169);
  work.s7_174 = 0.3477 - work.s7_173;
  work.s7_175 = work.s7_173 + work.s7_174;
  const double s7_176 = K_arb_front_left_yy + work.s7_175;
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double s7_177 = (-h_lower_arm_right_z)*R_lower_arm_right_z_y;
  work.s7_178 = mbgen::fnma((-h_lower_arm_right_y), R_lower_arm_right_y_y, s7_177);
  const double s7_179 = (-h_lower_arm_right_y)*R_lower_arm_right_z_y;
  work.s7_180 = mbgen::fma((-h_lower_arm_right_z), R_lower_arm_right_y_y, s7_179);
  const double s7_181 = K_lower_arm_right_yy*R_lower_arm_right_y_y;
  const double s7_182 = mbgen::fnma(K_lower_arm_right_yz, R_lower_arm_right_z_y, s7_181);
  const double s7_183 = K_lower_arm_right_yz*R_lower_arm_right_y_y;
  const double s7_184 = mbgen::fnma(K_lower_arm_right_zz, R_lower_arm_right_z_y, s7_183);
  work.s7_185 = mbgen::fma(R_lower_arm_right_y_y, s7_184, R_lower_arm_right_z_y*s7_182);
  work.s7_186 = mbgen::fnma(R_lower_arm_right_z_y, s7_184, R_lower_arm_right_y_y*s7_182);
  work.s7_187 = 1.825625 - work.s7_186;
  work.s7_188 = work.s7_186 + work.s7_187;
  const double s7_189 = K_lower_arm_right_xx + work.s7_188;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_190 = (-h_carrier_right_y)*work.s1_28;
  const double s7_191 = mbgen::fma(h_carrier_right_z, work.R_carrier_right_x_z, s7_190);
  work.s7_192 = mbgen::fnma((-h_carrier_right_x), work.R_carrier_right_x_x, s7_191);
  const double s7_193 = h_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_194 = mbgen::fnma((-h_carrier_right_x), work.R_carrier_right_z_x, s7_193);
  work.s7_195 = mbgen::fnma((-h_carrier_right_y), work.R_carrier_right_aux2_z_y, s7_194);
  const double s7_196 = h_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_197 = mbgen::fnma((-h_carrier_right_x), work.R_carrier_right_y_x, s7_196);
  work.s7_198 = mbgen::fnma((-h_carrier_right_y), work.R_carrier_right_aux2_y_y, s7_197);
  const double s7_199 = K_carrier_right_yy*work.s1_28;
  const double s7_200 = mbgen::fma((-K_carrier_right_yz), work.R_carrier_right_x_z, s7_199);
  const double s7_201 = mbgen::fma((-K_carrier_right_xy), work.R_carrier_right_x_x, s7_200);
  const double s7_202 = K_carrier_right_yy*work.R_carrier_right_aux2_y_y;
  const double s7_203 = mbgen::fnma((-K_carrier_right_xy), work.R_carrier_right_y_x, s7_202);
  const double s7_204 = mbgen::fnma((-K_carrier_right_yz), work.R_carrier_right_y_z, s7_203);
  const double s7_205 = K_carrier_right_zz*work.R_carrier_right_y_z;
  const double s7_206 = mbgen::fnma((-K_carrier_right_xz), work.R_carrier_right_y_x, s7_205);
  const double s7_207 = mbgen::fnma((-K_carrier_right_yz), work.R_carrier_right_aux2_y_y, s7_206);
  const double s7_208 = K_carrier_right_xx*work.R_carrier_right_y_x;
  const double s7_209 = mbgen::fnma((-K_carrier_right_xz), work.R_carrier_right_y_z, s7_208);
  const double s7_210 = mbgen::fnma((-K_carrier_right_xy), work.R_carrier_right_aux2_y_y, s7_209);
  const double s7_211 = work.R_carrier_right_aux2_z_y*s7_204;
  const double s7_212 = mbgen::fma(work.R_carrier_right_z_z, s7_207, s7_211);
  work.s7_213 = mbgen::fma(work.R_carrier_right_z_x, s7_210, s7_212);
  const double s7_214 = (-K_carrier_right_yz)*work.s1_28;
  const double s7_215 = mbgen::fma(K_carrier_right_zz, work.R_carrier_right_x_z, s7_214);
  const double s7_216 = mbgen::fnma((-K_carrier_right_xz), work.R_carrier_right_x_x, s7_215);
  const double s7_217 = (-K_carrier_right_xy)*work.s1_28;
  const double s7_218 = mbgen::fma(K_carrier_right_xx, work.R_carrier_right_x_x, s7_217);
  const double s7_219 = mbgen::fnma((-K_carrier_right_xz), work.R_carrier_right_x_z, s7_218);
  const double s7_220 = work.R_carrier_right_z_z*s7_216;
  const double s7_221 = mbgen::fma(work.R_carrier_right_z_x, s7_219, s7_220);
  work.s7_222 = mbgen::fnma(work.R_carrier_right_aux2_z_y, s7_201, s7_221);
  const double s7_223 = work.R_carrier_right_y_x*s7_219;
  const double s7_224 = mbgen::fma(work.R_carrier_right_y_z, s7_216, s7_223);
  work.s7_225 = mbgen::fnma(work.R_carrier_right_aux2_y_y, s7_201, s7_224);
  const double s7_226 = mbgen::fma(work.R_carrier_right_x_z, s7_216, work.s1_28*s7_201);
  work.s7_227 = mbgen::fma(work.R_carrier_right_x_x, s7_219, s7_226);
  const double s7_228 = work.R_carrier_right_aux2_y_y*s7_204;
  const double s7_229 = mbgen::fma(work.R_carrier_right_y_x, s7_210, s7_228);
  work.s7_230 = mbgen::fma(work.R_carrier_right_y_z, s7_207, s7_229);
  work.s7_231 = K_carrier_right_trace - work.s7_227 - work.s7_230;
  const double s7_232 = work.s7_230 + (work.s7_227 + work.s7_231);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_233 = (-h_upper_arm_right_z)*R_upper_arm_right_z_y;
  work.s7_234 = mbgen::fnma((-h_upper_arm_right_y), R_upper_arm_right_y_y, s7_233);
  const double s7_235 = (-h_upper_arm_right_y)*R_upper_arm_right_z_y;
  work.s7_236 = mbgen::fma((-h_upper_arm_right_z), R_upper_arm_right_y_y, s7_235);
  const double s7_237 = K_upper_arm_right_yy*R_upper_arm_right_y_y;
  const double s7_238 = mbgen::fnma(K_upper_arm_right_yz, R_upper_arm_right_z_y, s7_237);
  const double s7_239 = K_upper_arm_right_yz*R_upper_arm_right_y_y;
  const double s7_240 = mbgen::fnma(K_upper_arm_right_zz, R_upper_arm_right_z_y, s7_239);
  work.s7_241 = mbgen::fma(R_upper_arm_right_y_y, s7_240, R_upper_arm_right_z_y*s7_238);
  work.s7_242 = mbgen::fnma(R_upper_arm_right_z_y, s7_240, R_upper_arm_right_y_y*s7_238);
  work.s7_243 = 0.539 - work.s7_242;
  work.s7_244 = work.s7_242 + work.s7_243;
  const double s7_245 = K_upper_arm_right_xx + work.s7_244;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_246 = (-h_arb_front_right_x)*R_arb_front_right_x_z;
  work.s7_247 = mbgen::fma(h_arb_front_right_z, R_arb_front_right_x_x, s7_246);
  const double s7_248 = h_arb_front_right_z*R_arb_front_right_x_z;
  work.s7_249 = mbgen::fnma((-h_arb_front_right_x), R_arb_front_right_x_x, s7_248);
  const double s7_250 = K_arb_front_right_xy*R_arb_front_right_x_x;
  work.s7_251 = mbgen::fnma((-K_arb_front_right_yz), R_arb_front_right_x_z, s7_250);
  const double s7_252 = K_arb_front_right_xy*R_arb_front_right_x_z;
  work.s7_253 = mbgen::fma((-K_arb_front_right_yz), R_arb_front_right_x_x, s7_252);
  const double s7_254 = K_arb_front_right_zz*R_arb_front_right_x_z;
  const double s7_255 = mbgen::fnma((-K_arb_front_right_xz), R_arb_front_right_x_x, s7_254);
  const double s7_256 = K_arb_front_right_xx*R_arb_front_right_x_x;
  const double s7_257 = mbgen::fnma((-K_arb_front_right_xz), R_arb_front_right_x_z, s7_256);
  work.s7_258 = mbgen::fnma(R_arb_front_right_x_z, s7_257, R_arb_front_right_x_x*s7_255);
  work.s7_259 = mbgen::fma(R_arb_front_right_x_x, s7_257, R_arb_front_right_x_z*s7_255);
  work.s7_260 = 0.3477 - work.s7_259;
  work.s7_261 = work.s7_259 + work.s7_260;
  const double s7_262 = K_arb_front_right_yy + work.s7_261;
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  work.s7_263 = (-h_pitman_arm_z)*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  work.s7_264 = (-h_pitman_arm_z)*R_pitman_arm_x_x;
  const double s7_265 = K_pitman_arm_zz*R_pitman_arm_x_z;
  const double s7_266 = K_pitman_arm_xx*R_pitman_arm_x_x;
  work.s7_267 = mbgen::fnma(R_pitman_arm_x_z, s7_266, R_pitman_arm_x_x*s7_265);
  work.s7_268 = mbgen::fma(R_pitman_arm_x_x, s7_266, R_pitman_arm_x_z*s7_265);
  work.s7_269 = 0.3504 - work.s7_268;
  work.s7_270 = work.s7_268 + work.s7_269;
  const double s7_271 = K_pitman_arm_yy + work.s7_270;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_x_x = work.cosines[16];
  const double R_bell_crank_y_x = work.sines[16];
  const double s7_272 = h_bell_crank_y*R_bell_crank_x_x;
  work.s7_273 = mbgen::fnma((-h_bell_crank_x), R_bell_crank_y_x, s7_272);
  const double s7_274 = (-K_bell_crank_xy)*R_bell_crank_y_x;
  const double s7_275 = (-K_bell_crank_xy)*R_bell_crank_x_x;
  const double s7_276 = mbgen::fma(K_bell_crank_yy, R_bell_crank_y_x, s7_275);
  const double s7_277 = h_bell_crank_y*R_bell_crank_y_x;
  work.s7_278 = mbgen::fma((-h_bell_crank_x), R_bell_crank_x_x, s7_277);
  const double s7_279 = mbgen::fma(K_bell_crank_xx, R_bell_crank_x_x, s7_274);
  work.s7_280 = mbgen::fnma(R_bell_crank_x_x, s7_276, R_bell_crank_y_x*s7_279);
  work.s7_281 = mbgen::fma(R_bell_crank_x_x, s7_279, R_bell_crank_y_x*s7_276);
  const double s7_282 = R_bell_crank_y_x*mbgen::fms(K_bell_crank_xx, R_bell_crank_y_x, s7_275);
  const double s7_283 = mbgen::fms(K_bell_crank_yy, R_bell_crank_x_x, s7_274);
  work.s7_284 = mbgen::fma(R_bell_crank_x_x, s7_283, s7_282);
  work.s7_285 = K_bell_crank_trace - work.s7_281 - work.s7_284;
  work.s7_286 = work.s7_281 + work.s7_284;
  const double s7_287 = work.s7_285 + work.s7_286;
  // operations: 140 add, 188 multiply

  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_820 = projection.Rz[0] + work.s3_12;
  work.s8_821 = work.s1_8*projection.Rz[0];
  work.s8_822 = work.s1_10*projection.Rz[0];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_823 = projection.Rz[18] + work.s3_18;
  work.s8_824 = work.s1_23*projection.Rz[18];
  work.s8_825 = work.s1_25*projection.Rz[18];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_826 = projection.Rz[1] + work.s3_14;
  work.s8_827 = work.s1_8*projection.Rz[1];
  work.s8_828 = work.s1_10*projection.Rz[1];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_829 = projection.Rz[19] + work.s3_20;
  work.s8_830 = work.s1_23*projection.Rz[19];
  work.s8_831 = work.s1_25*projection.Rz[19];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_832 = projection.Rz[2] + work.s3_16;
  work.s8_833 = work.s1_8*projection.Rz[2];
  work.s8_834 = work.s1_10*projection.Rz[2];
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_835 = projection.Rz[20] + work.s3_22;
  work.s8_836 = work.s1_23*projection.Rz[20];
  work.s8_837 = work.s1_25*projection.Rz[20];
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  work.s8_838 = projection.zdd_star[0] + s6_28;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  work.s8_839 = projection.zdd_star[6] + s6_33;
  work.s8_840 = work.s1_23*projection.zdd_star[6];
  // bell_crank: bell_crank, revolute, chassis
  work.s8_841 = projection.Rz[39]*work.s7_273;
  work.s8_842 = projection.Rz[40]*work.s7_273;
  work.s8_843 = projection.Rz[41]*work.s7_273;
  work.s8_844 = projection.Rz[39]*work.s7_278;
  work.s8_845 = projection.Rz[40]*work.s7_278;
  work.s8_846 = projection.Rz[41]*work.s7_278;
  const double s8_847 = s7_287 - work.s7_285;
  work.s8_848 = projection.Rz[39]*s8_847;
  work.s8_849 = projection.Rz[40]*s8_847;
  work.s8_850 = projection.Rz[41]*s8_847;
  const double s8_851 = mbgen::fma(zd_bell_crank, work.s8_19, s6_23);
  work.s8_852 = mbgen::fma(p_bell_crank_x, work.s8_26, (-p_bell_crank_z)*work.s8_22);
  work.s8_853 = zd_bell_crank*work.s8_18;
  work.s8_854 = zd_bell_crank*work.s8_17;
  work.s8_855 = 33.31250000000001 - work.s7_278;
  work.s8_856 = mbgen::fnma((-p_bell_crank_z), work.s8_21, p_bell_crank_x*work.s8_20);
  work.s8_857 = mbgen::fnma(work.s7_278, work.s8_853, work.s7_273*work.s8_854);
  work.s8_858 = mbgen::fnma(projection.zdd_star[13], work.s7_273, work.s7_278*s8_851);
  work.s8_859 = mbgen::fma(work.s7_273, s8_851, projection.zdd_star[13]*work.s7_278);
  work.s8_860 = work.s7_281 - work.s7_284;
  work.s8_861 = work.s8_26 - work.s8_27;
  // pitman_arm: pitman_arm, revolute, chassis
  work.s8_862 = projection.Rz[36]*work.s7_263;
  work.s8_863 = projection.Rz[36]*work.s7_264;
  work.s8_864 = projection.Rz[37]*work.s7_263;
  work.s8_865 = projection.Rz[37]*work.s7_264;
  work.s8_866 = projection.Rz[38]*work.s7_263;
  work.s8_867 = projection.Rz[38]*work.s7_264;
  const double s8_868 = mbgen::fma(zd_pitman_arm, work.s8_17, s6_22);
  work.s8_869 = 2.1 + work.s7_264;
  work.s8_870 = zd_pitman_arm*work.s8_18;
  work.s8_871 = zd_pitman_arm*work.s8_19;
  const double s8_872 = s7_271 - K_pitman_arm_yy;
  work.s8_873 = projection.Rz[36]*s8_872;
  work.s8_874 = projection.Rz[37]*s8_872;
  work.s8_875 = projection.Rz[38]*s8_872;
  work.s8_876 = mbgen::fma(work.s7_264, work.s8_871, work.s7_263*work.s8_870);
  work.s8_877 = 23.1 - work.s7_263;
  work.s8_878 = mbgen::fma(work.s7_264, s8_868, projection.zdd_star[12]*work.s7_263);
  work.s8_879 = mbgen::fnma(projection.zdd_star[12], work.s7_264, work.s7_263*s8_868);
  const double s8_880 = mbgen::fma((-p_pitman_arm_z), work.s8_25, work.s8_176);
  work.s8_881 = mbgen::fma(p_pitman_arm_x, work.s8_22, s8_880);
  const double s8_882 = mbgen::fnma((-p_pitman_arm_z), work.s8_22, p_pitman_arm_y*work.s8_20);
  work.s8_883 = mbgen::fnma(p_pitman_arm_x, work.s8_26, s8_882);
  work.s8_884 = work.s7_269 - work.s7_268;
  // arb_front_right: arb_front_right, revolute, chassis
  work.s8_885 = projection.Rz[33]*work.s7_249;
  work.s8_886 = projection.Rz[34]*work.s7_249;
  work.s8_887 = projection.Rz[35]*work.s7_249;
  work.s8_888 = projection.Rz[33]*work.s7_247;
  work.s8_889 = projection.Rz[34]*work.s7_247;
  work.s8_890 = projection.Rz[35]*work.s7_247;
  const double s8_891 = mbgen::fma(p_arb_front_right_x, work.s8_26, work.s8_177);
  work.s8_892 = mbgen::fma(zd_arb_front_right, work.s8_17, s6_21);
  work.s8_893 = work.s7_247 - 2.25;
  const double s8_894 = s7_262 - K_arb_front_right_yy;
  work.s8_895 = projection.Rz[33]*s8_894;
  work.s8_896 = projection.Rz[34]*s8_894;
  work.s8_897 = projection.Rz[35]*s8_894;
  work.s8_898 = zd_arb_front_right*work.s8_19;
  work.s8_899 = zd_arb_front_right*work.s8_18;
  work.s8_900 = mbgen::fma(work.s7_249, work.s8_899, work.s7_247*work.s8_898);
  work.s8_901 = mbgen::fma((-p_arb_rear_right_y), work.s8_20, s8_891);
  work.s8_902 = 17.775 + work.s7_249;
  const double s8_903 = projection.zdd_star[11]*work.s7_247;
  work.s8_904 = mbgen::fnma(work.s7_249, work.s8_892, s8_903);
  const double s8_905 = projection.zdd_star[11]*work.s7_249;
  work.s8_906 = mbgen::fma(work.s7_247, work.s8_892, s8_905);
  const double s8_907 = mbgen::fma(p_arb_front_right_x, work.s8_22, work.s8_178);
  work.s8_908 = mbgen::fnma((-p_arb_rear_right_z), work.s8_21, s8_907);
  work.s8_909 = work.s7_260 - work.s7_259;
  // upper_arm_right: upper_arm_right, revolute, chassis
  work.s8_910 = projection.Rz[30]*work.s7_236;
  work.s8_911 = projection.Rz[31]*work.s7_236;
  work.s8_912 = projection.Rz[32]*work.s7_236;
  work.s8_913 = 2.1 + work.s7_236;
  const double s8_914 = p_upper_arm_right_x*work.s8_26;
  const double s8_915 = mbgen::fma(zd_upper_arm_right, work.s8_18, s6_20);
  work.s8_916 = work.s7_234 - 3.75;
  work.s8_917 = zd_upper_arm_right*work.s8_19;
  const double s8_918 = s7_245 - K_upper_arm_right_xx;
  work.s8_919 = projection.Rz[30]*s8_918;
  work.s8_920 = projection.Rz[31]*s8_918;
  work.s8_921 = projection.Rz[32]*s8_918;
  work.s8_922 = zd_upper_arm_right*work.s8_17;
  work.s8_923 = mbgen::fnma(work.s7_236, work.s8_917, work.s7_234*work.s8_922);
  work.s8_924 = mbgen::fnma(work.s7_234, s8_915, projection.zdd_star[10]*work.s7_236);
  work.s8_925 = mbgen::fma(work.s7_236, s8_915, projection.zdd_star[10]*work.s7_234);
  const double s8_926 = p_upper_arm_right_x*work.s8_20;
  const double s8_927 = mbgen::fnma((-p_upper_arm_right_z), work.s8_21, s8_926);
  work.s8_928 = mbgen::fma(p_pitman_arm_y, work.s8_27, s8_927);
  const double s8_929 = p_upper_arm_right_x*work.s8_22;
  const double s8_930 = mbgen::fma((-p_upper_arm_right_z), work.s8_25, s8_929);
  work.s8_931 = s8_930 - work.s8_176;
  work.s8_932 = work.s7_242 - work.s7_243;
  work.s8_933 = work.s8_27 - work.s8_25;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s8_934 = mbgen::fms(work.s4_18, work.s8_17, s8_914);
  const double s8_935 = mbgen::fnma(work.s4_19, work.s8_19, s8_934);
  const double s8_936 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_20, s8_935);
  const double s8_937 = mbgen::fnma(work.s1_26, work.s8_22, s8_936);
  const double s8_938 = mbgen::fnma(work.w_chassis_y, work.s4_17, work.w_chassis_x*work.s4_8);
  work.s8_939 = work.s6_47 + s8_938;
  const double s8_940 = mbgen::fms(work.w_carrier_right_x, work.w_carrier_right_y, work.s8_939);
  const double s8_941 = mbgen::fnma(work.w_chassis_x, work.s4_6, work.w_chassis_z*work.s4_17);
  work.s8_942 = work.s6_59 + s8_941;
  const double s8_943 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_z, work.s8_942);
  const double s8_944 = work.w_carrier_right_y*work.w_carrier_right_y;
  const double s8_945 = work.w_carrier_right_z*work.w_carrier_right_z;
  const double s8_946 = s8_944 + s8_945;
  const double s8_947 = mbgen::fma(work.s7_198, s8_940, m_carrier_right_2*s8_937);
  const double s8_948 = mbgen::fma(work.s7_195, s8_943, s8_947);
  work.f_carrier_right_x = mbgen::fnma(work.s7_192, s8_946, s8_948);
  const double s8_949 = mbgen::fma(work.s1_25, projection.zdd_star[6], s8_926) - work.s6_19;
  const double s8_950 = mbgen::fnma(work.s1_26, work.s8_21, s8_949);
  const double s8_951 = mbgen::fnma(work.r_carrier_right_aux1_y, work.s8_27, s8_950);
  const double s8_952 = mbgen::fnma(work.s4_18, work.s8_18, s8_951);
  const double s8_953 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_y, work.s8_939);
  const double s8_954 = mbgen::fnma(work.w_chassis_z, work.s4_8, work.w_chassis_y*work.s4_6);
  work.s8_955 = work.s8_839 + s8_954;
  const double s8_956 = mbgen::fms(work.w_carrier_right_y, work.w_carrier_right_z, work.s8_955);
  const double s8_957 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_945);
  const double s8_958 = mbgen::fma(work.s7_192, s8_953, m_carrier_right_2*s8_952);
  const double s8_959 = mbgen::fma(work.s7_195, s8_956, s8_958);
  work.f_carrier_right_y = mbgen::fnma(work.s7_198, s8_957, s8_959);
  const double s8_960 = work.s8_840 + mbgen::fma(work.s1_25, work.s6_18, s8_929);
  const double s8_961 = mbgen::fma(work.s4_19, work.s8_18, s8_960);
  const double s8_962 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_21, s8_961);
  const double s8_963 = mbgen::fma(work.s1_26, work.s8_25, s8_962);
  const double s8_964 = mbgen::fma(work.w_carrier_right_y, work.w_carrier_right_z, work.s8_955);
  const double s8_965 = mbgen::fms(work.w_carrier_right_x, work.w_carrier_right_z, work.s8_942);
  const double s8_966 = mbgen::fma(work.w_carrier_right_x, work.w_carrier_right_x, s8_944);
  const double s8_967 = mbgen::fma(work.s7_198, s8_964, m_carrier_right_2*s8_963);
  const double s8_968 = mbgen::fma(work.s7_192, s8_965, s8_967);
  work.f_carrier_right_z = mbgen::fnma(work.s7_195, s8_966, s8_968);
  const double s8_969 = mbgen::fma(work.s7_198, s8_963, s8_804);
  const double s8_970 = mbgen::fnma(work.s7_195, s8_952, s8_969);
  const double s8_971 = mbgen::fma(work.s7_225, s8_965, mbgen::fma(work.s7_230, s8_964, s8_970));
  const double s8_972 = mbgen::fnma(work.s7_222, s8_953, s8_971);
  const double s8_973 = mbgen::fnma(work.s7_231, s8_956, s8_972);
  work.n_carrier_right_x = mbgen::fma(work.s7_213, s8_957 - s8_966, s8_973);
  const double s8_974 = mbgen::fma(work.s7_195, s8_937, s8_801);
  const double s8_975 = mbgen::fnma(work.s7_192, s8_963, s8_974);
  const double s8_976 = mbgen::fma(work.s7_231, s8_943, mbgen::fma(work.s7_213, s8_940, s8_975));
  const double s8_977 = mbgen::fnma(work.s7_225, s8_964, s8_976);
  const double s8_978 = mbgen::fnma(work.s7_227, s8_965, s8_977);
  work.n_carrier_right_y = mbgen::fma(work.s7_222, s8_966 - s8_946, s8_978);
  const double s8_979 = mbgen::fma(work.s7_192, s8_952, s8_798);
  const double s8_980 = mbgen::fnma(work.s7_198, s8_937, s8_979);
  const double s8_981 = mbgen::fma(work.s7_222, s8_956, mbgen::fma(work.s7_227, s8_953, s8_980));
  const double s8_982 = mbgen::fnma(work.s7_230, s8_940, s8_981);
  const double s8_983 = mbgen::fnma(work.s7_213, s8_943, s8_982);
  work.n_carrier_right_z = mbgen::fma(work.s7_225, s8_946 - s8_957, s8_983);
  work.s8_984 = work.s1_26 + work.s1_26;
  work.s8_985 = mbgen::fnma(work.s3_43, work.s7_198, work.s3_52*work.s7_195);
  work.s8_986 = mbgen::fnma(work.s3_46, work.s7_198, work.s3_55*work.s7_195);
  work.s8_987 = mbgen::fnma(work.s3_49, work.s7_198, work.s3_58*work.s7_195);
  const double s8_988 = mbgen::fma(work.s7_198, work.s8_823, m_carrier_right_2*work.s8_824);
  work.s8_989 = mbgen::fnma(work.s3_52, work.s7_192, s8_988);
  const double s8_990 = mbgen::fma(work.s7_198, work.s8_829, m_carrier_right_2*work.s8_830);
  work.s8_991 = mbgen::fnma(work.s3_55, work.s7_192, s8_990);
  const double s8_992 = mbgen::fma(work.s7_198, work.s8_835, m_carrier_right_2*work.s8_836);
  work.s8_993 = mbgen::fnma(work.s3_58, work.s7_192, s8_992);
  const double s8_994 = mbgen::fma(work.s3_43, work.s7_192, m_carrier_right_2*work.s8_825);
  work.s8_995 = mbgen::fnma(work.s7_195, work.s8_823, s8_994);
  const double s8_996 = mbgen::fma(work.s3_46, work.s7_192, m_carrier_right_2*work.s8_831);
  work.s8_997 = mbgen::fnma(work.s7_195, work.s8_829, s8_996);
  const double s8_998 = mbgen::fma(work.s3_49, work.s7_192, m_carrier_right_2*work.s8_837);
  work.s8_999 = mbgen::fnma(work.s7_195, work.s8_835, s8_998);
  work.s8_1000 = 395.1 + work.s7_192;
  work.s8_1001 = mbgen::fma(109.75, work.r_carrier_right_aux1_y, work.s7_198);
  work.s8_1002 = mbgen::fnma(109.75, work.s1_26, work.s7_195);
  const double s8_1003 = s7_232 - work.s7_231;
  const double s8_1004 = mbgen::fma(work.s3_43, s8_1003, work.s7_192*work.s8_825);
  const double s8_1005 = mbgen::fnma(work.s7_222, work.s8_823, s8_1004);
  work.s8_1006 = mbgen::fnma(work.s3_52, work.s7_213, s8_1005);
  const double s8_1007 = mbgen::fma(work.s3_46, s8_1003, work.s7_192*work.s8_831);
  const double s8_1008 = mbgen::fnma(work.s7_222, work.s8_829, s8_1007);
  work.s8_1009 = mbgen::fnma(work.s3_55, work.s7_213, s8_1008);
  const double s8_1010 = mbgen::fma(work.s3_49, s8_1003, work.s7_192*work.s8_837);
  const double s8_1011 = mbgen::fnma(work.s7_222, work.s8_835, s8_1010);
  work.s8_1012 = mbgen::fnma(work.s3_58, work.s7_213, s8_1011);
  const double s8_1013 = s7_232 - work.s7_230;
  const double s8_1014 = mbgen::fnma(work.s3_43, work.s7_213, work.s3_52*s8_1013);
  const double s8_1015 = mbgen::fnma(work.s7_225, work.s8_823, s8_1014);
  work.s8_1016 = mbgen::fnma(work.s7_192, work.s8_824, s8_1015);
  const double s8_1017 = mbgen::fnma(work.s3_46, work.s7_213, work.s3_55*s8_1013);
  const double s8_1018 = mbgen::fnma(work.s7_225, work.s8_829, s8_1017);
  work.s8_1019 = mbgen::fnma(work.s7_192, work.s8_830, s8_1018);
  const double s8_1020 = mbgen::fnma(work.s3_49, work.s7_213, work.s3_58*s8_1013);
  const double s8_1021 = mbgen::fnma(work.s7_225, work.s8_835, s8_1020);
  work.s8_1022 = mbgen::fnma(work.s7_192, work.s8_836, s8_1021);
  const double s8_1023 = s7_232 - work.s7_227;
  const double s8_1024 = mbgen::fnma(work.s7_195, work.s8_825, work.s7_198*work.s8_824);
  const double s8_1025 = mbgen::fma(work.s8_823, s8_1023, s8_1024);
  const double s8_1026 = mbgen::fnma(work.s3_43, work.s7_222, s8_1025);
  work.s8_1027 = mbgen::fnma(work.s3_52, work.s7_225, s8_1026);
  const double s8_1028 = mbgen::fnma(work.s7_195, work.s8_831, work.s7_198*work.s8_830);
  const double s8_1029 = mbgen::fma(work.s8_829, s8_1023, s8_1028);
  const double s8_1030 = mbgen::fnma(work.s3_46, work.s7_222, s8_1029);
  work.s8_1031 = mbgen::fnma(work.s3_55, work.s7_225, s8_1030);
  const double s8_1032 = mbgen::fnma(work.s7_195, work.s8_837, work.s7_198*work.s8_836);
  const double s8_1033 = mbgen::fma(work.s8_835, s8_1023, s8_1032);
  const double s8_1034 = mbgen::fnma(work.s3_49, work.s7_222, s8_1033);
  work.s8_1035 = mbgen::fnma(work.s3_58, work.s7_225, s8_1034);
  work.s8_1036 = work.r_carrier_right_aux1_y + work.r_carrier_right_aux1_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s8_1037 = projection.Rz[18]*work.s7_178;
  work.s8_1038 = projection.Rz[19]*work.s7_178;
  work.s8_1039 = projection.Rz[20]*work.s7_178;
  work.s8_1040 = projection.Rz[18]*work.s7_180;
  work.s8_1041 = projection.Rz[19]*work.s7_180;
  work.s8_1042 = projection.Rz[20]*work.s7_180;
  const double s8_1043 = mbgen::fma(zd_lower_arm_right, work.s8_18, work.s6_18);
  work.s8_1044 = 7.75 + work.s7_180;
  work.s8_1045 = zd_lower_arm_right*work.s8_19;
  work.s8_1046 = zd_lower_arm_right*work.s8_17;
  work.s8_1047 = mbgen::fnma(work.s7_180, work.s8_1045, work.s7_178*work.s8_1046);
  const double s8_1048 = s7_189 - K_lower_arm_right_xx;
  work.s8_1049 = projection.Rz[18]*s8_1048;
  work.s8_1050 = projection.Rz[19]*s8_1048;
  work.s8_1051 = projection.Rz[20]*s8_1048;
  work.s8_1052 = work.s7_178 - 5.0;
  work.s8_1053 = mbgen::fnma(work.s7_178, s8_1043, projection.zdd_star[6]*work.s7_180);
  work.s8_1054 = mbgen::fma(work.s7_180, s8_1043, projection.zdd_star[6]*work.s7_178);
  work.s8_1055 = mbgen::fnma((-p_lower_arm_right_z), work.s8_21, s8_926);
  work.s8_1056 = mbgen::fma((-p_lower_arm_right_y), work.s8_27, work.s8_1055);
  work.s8_1057 = mbgen::fma((-p_lower_arm_right_z), work.s8_25, s8_929);
  work.s8_1058 = mbgen::fnma((-p_pitman_arm_z), work.s8_21, work.s8_1057);
  work.s8_1059 = work.s7_186 - work.s7_187;
  // arb_front_left: arb_front_left, revolute, chassis
  work.s8_1060 = work.s7_163 - 2.25;
  work.s8_1061 = mbgen::fma(zd_arb_front_left, work.s8_17, s6_17);
  work.s8_1062 = 17.775 + work.s7_167;
  const double s8_1063 = s7_176 - K_arb_front_left_yy;
  work.s8_1064 = projection.Rz[15]*s8_1063;
  work.s8_1065 = projection.Rz[16]*s8_1063;
  work.s8_1066 = projection.Rz[17]*s8_1063;
  work.s8_1067 = zd_arb_front_left*work.s8_19;
  work.s8_1068 = zd_arb_front_left*work.s8_18;
  work.s8_1069 = mbgen::fma(work.s7_167, work.s8_1068, work.s7_163*work.s8_1067);
  const double s8_1070 = projection.zdd_star[5]*work.s7_163;
  work.s8_1071 = mbgen::fnma(work.s7_167, work.s8_1061, s8_1070);
  work.s8_1072 = mbgen::fms((-p_arb_rear_right_y), work.s8_20, s8_891);
  const double s8_1073 = projection.zdd_star[5]*work.s7_167;
  work.s8_1074 = mbgen::fma(work.s7_163, work.s8_1061, s8_1073);
  work.s8_1075 = mbgen::fma((-p_arb_rear_right_z), work.s8_21, s8_907);
  work.s8_1076 = work.s7_174 - work.s7_173;
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s8_1077 = mbgen::fma(zd_upper_arm_left, work.s8_18, s6_16);
  work.s8_1078 = 3.75 + work.s7_148;
  work.s8_1079 = work.s7_150 - 2.1;
  const double s8_1080 = s7_159 - K_upper_arm_left_xx;
  work.s8_1081 = projection.Rz[12]*s8_1080;
  work.s8_1082 = projection.Rz[13]*s8_1080;
  work.s8_1083 = projection.Rz[14]*s8_1080;
  work.s8_1084 = zd_upper_arm_left*work.s8_17;
  work.s8_1085 = zd_upper_arm_left*work.s8_19;
  work.s8_1086 = mbgen::fma(work.s7_150, work.s8_1085, work.s7_148*work.s8_1084);
  work.s8_1087 = mbgen::fnma(work.s7_150, s8_1077, projection.zdd_star[4]*work.s7_148);
  work.s8_1088 = work.s8_176 + s8_930;
  work.s8_1089 = mbgen::fma(work.s7_148, s8_1077, projection.zdd_star[4]*work.s7_150);
  work.s8_1090 = mbgen::fnma(p_pitman_arm_y, work.s8_27, s8_927);
  work.s8_1091 = work.s7_156 - work.s7_157;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_1092 = mbgen::fms(work.s4_14, work.s8_17, s8_914);
  const double s8_1093 = mbgen::fma(work.s4_15, work.s8_19, s8_1092);
  const double s8_1094 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_20, s8_1093);
  const double s8_1095 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_22, s8_1094);
  const double s8_1096 = mbgen::fnma(work.w_chassis_y, work.s4_13, work.w_chassis_x*work.s4_4);
  work.s8_1097 = work.s6_40 + s8_1096;
  const double s8_1098 = mbgen::fms(work.w_carrier_left_x, work.w_carrier_left_y, work.s8_1097);
  const double s8_1099 = mbgen::fnma(work.w_chassis_x, work.s4_2, work.w_chassis_z*work.s4_13);
  work.s8_1100 = work.s6_53 + s8_1099;
  const double s8_1101 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_z, work.s8_1100);
  const double s8_1102 = work.w_carrier_left_y*work.w_carrier_left_y;
  const double s8_1103 = work.w_carrier_left_z*work.w_carrier_left_z;
  const double s8_1104 = s8_1102 + s8_1103;
  const double s8_1105 = mbgen::fma(work.s7_108, s8_1098, m_carrier_left_2*s8_1095);
  const double s8_1106 = mbgen::fma(work.s7_105, s8_1101, s8_1105);
  work.f_carrier_left_x = mbgen::fnma(work.s7_111, s8_1104, s8_1106);
  const double s8_1107 = mbgen::fnma(work.s1_10, projection.zdd_star[0], s8_926 - work.s6_14);
  const double s8_1108 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_21, s8_1107);
  const double s8_1109 = mbgen::fnma(work.r_carrier_left_aux1_y, work.s8_27, s8_1108);
  const double s8_1110 = mbgen::fnma(work.s4_14, work.s8_18, s8_1109);
  const double s8_1111 = mbgen::fnma(work.w_chassis_z, work.s4_4, work.w_chassis_y*work.s4_2);
  work.s8_1112 = work.s8_838 + s8_1111;
  const double s8_1113 = mbgen::fms(work.w_carrier_left_y, work.w_carrier_left_z, work.s8_1112);
  const double s8_1114 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_y, work.s8_1097);
  const double s8_1115 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_1103);
  const double s8_1116 = mbgen::fma(work.s7_105, s8_1113, m_carrier_left_2*s8_1110);
  const double s8_1117 = mbgen::fma(work.s7_111, s8_1114, s8_1116);
  work.f_carrier_left_y = mbgen::fnma(work.s7_108, s8_1115, s8_1117);
  const double s8_1118 = mbgen::fma(work.s1_8, projection.zdd_star[0], s8_929) - work.s6_15;
  const double s8_1119 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_21, s8_1118);
  const double s8_1120 = mbgen::fnma(work.r_carrier_left_aux1_z, work.s8_25, s8_1119);
  const double s8_1121 = mbgen::fnma(work.s4_15, work.s8_18, s8_1120);
  const double s8_1122 = mbgen::fma(work.w_carrier_left_y, work.w_carrier_left_z, work.s8_1112);
  const double s8_1123 = mbgen::fms(work.w_carrier_left_x, work.w_carrier_left_z, work.s8_1100);
  const double s8_1124 = mbgen::fma(work.w_carrier_left_x, work.w_carrier_left_x, s8_1102);
  const double s8_1125 = mbgen::fma(work.s7_108, s8_1122, m_carrier_left_2*s8_1121);
  const double s8_1126 = mbgen::fma(work.s7_111, s8_1123, s8_1125);
  work.f_carrier_left_z = mbgen::fnma(work.s7_105, s8_1124, s8_1126);
  const double s8_1127 = mbgen::fma(work.s7_108, s8_1121, s8_819);
  const double s8_1128 = mbgen::fnma(work.s7_105, s8_1110, s8_1127);
  const double s8_1129 = mbgen::fma(work.s7_141, s8_1122, s8_1128);
  const double s8_1130 = mbgen::fma(work.s7_138, s8_1123, s8_1129);
  const double s8_1131 = mbgen::fnma(work.s7_135, s8_1114, s8_1130);
  const double s8_1132 = mbgen::fnma(work.s7_145, s8_1113, s8_1131);
  work.n_carrier_left_x = mbgen::fma(work.s7_126, s8_1115 - s8_1124, s8_1132);
  const double s8_1133 = mbgen::fma(work.s7_105, s8_1095, s8_816);
  const double s8_1134 = mbgen::fnma(work.s7_111, s8_1121, s8_1133);
  const double s8_1135 = mbgen::fma(work.s7_126, s8_1098, s8_1134);
  const double s8_1136 = mbgen::fma(work.s7_145, s8_1101, s8_1135);
  const double s8_1137 = mbgen::fnma(work.s7_138, s8_1122, s8_1136);
  const double s8_1138 = mbgen::fnma(work.s7_144, s8_1123, s8_1137);
  work.n_carrier_left_y = mbgen::fma(work.s7_135, s8_1124 - s8_1104, s8_1138);
  const double s8_1139 = mbgen::fma(work.s7_111, s8_1110, s8_813);
  const double s8_1140 = mbgen::fnma(work.s7_108, s8_1095, s8_1139);
  const double s8_1141 = mbgen::fma(work.s7_135, s8_1113, s8_1140);
  const double s8_1142 = mbgen::fma(work.s7_144, s8_1114, s8_1141);
  const double s8_1143 = mbgen::fnma(work.s7_141, s8_1098, s8_1142);
  const double s8_1144 = mbgen::fnma(work.s7_126, s8_1101, s8_1143);
  work.n_carrier_left_z = mbgen::fma(work.s7_138, s8_1104 - s8_1115, s8_1144);
  work.s8_1145 = mbgen::fnma(work.s3_25, work.s7_108, work.s3_34*work.s7_105);
  work.s8_1146 = mbgen::fnma(work.s3_28, work.s7_108, work.s3_37*work.s7_105);
  work.s8_1147 = mbgen::fnma(work.s3_31, work.s7_108, work.s3_40*work.s7_105);
  const double s8_1148 = work.s8_987 + mbgen::fma(projection.Rz[17], work.s7_163, work.s8_1147);
  work.s8_1149 = work.s8_890 + s8_1148 - work.s8_843 - work.s8_867;
  const double s8_1150 = mbgen::fma(work.s7_108, work.s8_820, m_carrier_left_2*work.s8_821);
  work.s8_1151 = mbgen::fnma(work.s3_34, work.s7_111, s8_1150);
  const double s8_1152 = mbgen::fma(work.s7_108, work.s8_826, m_carrier_left_2*work.s8_827);
  work.s8_1153 = mbgen::fnma(work.s3_37, work.s7_111, s8_1152);
  const double s8_1154 = mbgen::fma(work.s7_108, work.s8_832, m_carrier_left_2*work.s8_833);
  work.s8_1155 = mbgen::fnma(work.s3_40, work.s7_111, s8_1154);
  const double s8_1156 = mbgen::fnma(work.s7_105, work.s8_820, work.s3_25*work.s7_111);
  work.s8_1157 = mbgen::fnma(m_carrier_left_2, work.s8_822, s8_1156);
  const double s8_1158 = mbgen::fnma(work.s7_105, work.s8_826, work.s3_28*work.s7_111);
  work.s8_1159 = mbgen::fnma(m_carrier_left_2, work.s8_828, s8_1158);
  const double s8_1160 = mbgen::fnma(work.s7_105, work.s8_832, work.s3_31*work.s7_111);
  work.s8_1161 = mbgen::fnma(m_carrier_left_2, work.s8_834, s8_1160);
  work.s8_1162 = mbgen::fma(109.75, work.r_carrier_left_aux1_z, work.s7_105);
  work.s8_1163 = mbgen::fma(109.75, work.r_carrier_left_aux1_y, work.s7_108);
  work.s8_1164 = 395.1 + work.s7_111;
  work.s8_1165 = work.r_carrier_left_aux1_z + work.r_carrier_left_aux1_z;
  work.s8_1166 = work.r_carrier_left_aux1_y + work.r_carrier_left_aux1_y;
  const double s8_1167 = work.s7_146 - work.s7_145;
  const double s8_1168 = mbgen::fnma(work.s7_135, work.s8_820, work.s3_25*s8_1167);
  const double s8_1169 = mbgen::fnma(work.s3_34, work.s7_126, s8_1168);
  work.s8_1170 = mbgen::fnma(work.s7_111, work.s8_822, s8_1169);
  const double s8_1171 = mbgen::fnma(work.s7_135, work.s8_826, work.s3_28*s8_1167);
  const double s8_1172 = mbgen::fnma(work.s3_37, work.s7_126, s8_1171);
  work.s8_1173 = mbgen::fnma(work.s7_111, work.s8_828, s8_1172);
  const double s8_1174 = mbgen::fnma(work.s7_135, work.s8_832, work.s3_31*s8_1167);
  const double s8_1175 = mbgen::fnma(work.s3_40, work.s7_126, s8_1174);
  work.s8_1176 = mbgen::fnma(work.s7_111, work.s8_834, s8_1175);
}

/// Part 4 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right.
[[gnu::noinline]] void compute_chosen_accelerations_4(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s8_1177 = work.s7_146 - work.s7_141;
  const double s8_1178 = mbgen::fnma(work.s3_25, work.s7_126, work.s3_34*s8_1177);
  const double s8_1179 = mbgen::fnma(work.s7_138, work.s8_820, s8_1178);
  work.s8_1180 = mbgen::fnma(work.s7_111, work.s8_821, s8_1179);
  const double s8_1181 = mbgen::fnma(work.s3_28, work.s7_126, work.s3_37*s8_1177);
  const double s8_1182 = mbgen::fnma(work.s7_138, work.s8_826, s8_1181);
  work.s8_1183 = mbgen::fnma(work.s7_111, work.s8_827, s8_1182);
  const double s8_1184 = mbgen::fnma(work.s3_31, work.s7_126, work.s3_40*s8_1177);
  const double s8_1185 = mbgen::fnma(work.s7_138, work.s8_832, s8_1184);
  const double s8_1186 = mbgen::fnma(work.s7_111, work.s8_833, s8_1185);
  const double s8_1187 = work.s7_146 - work.s7_144;
  const double s8_1188 = mbgen::fma(work.s7_108, work.s8_821, work.s7_105*work.s8_822);
  const double s8_1189 = mbgen::fma(work.s8_820, s8_1187, s8_1188);
  const double s8_1190 = mbgen::fnma(work.s3_25, work.s7_135, s8_1189);
  work.s8_1191 = mbgen::fnma(work.s3_34, work.s7_138, s8_1190);
  const double s8_1192 = mbgen::fma(work.s7_108, work.s8_827, work.s7_105*work.s8_828);
  const double s8_1193 = mbgen::fma(work.s8_826, s8_1187, s8_1192);
  const double s8_1194 = mbgen::fnma(work.s3_28, work.s7_135, s8_1193);
  work.s8_1195 = mbgen::fnma(work.s3_37, work.s7_138, s8_1194);
  const double s8_1196 = mbgen::fma(work.s7_108, work.s8_833, work.s7_105*work.s8_834);
  const double s8_1197 = mbgen::fma(work.s8_832, s8_1187, s8_1196);
  const double s8_1198 = mbgen::fnma(work.s3_31, work.s7_135, s8_1197);
  const double s8_1199 = mbgen::fnma(work.s3_40, work.s7_138, s8_1198);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double s8_1200 = work.s7_273 + (work.s7_234 + (work.s7_178 + (work.s7_91 + work.s7_148)));
  work.s8_1201 = 5.25 + s8_1200;
  const double s8_1202 = mbgen::fma(projection.Rz[2], work.s7_91, work.s8_1155);
  const double s8_1203 = work.s8_1039 + mbgen::fma(projection.Rz[14], work.s7_148, s8_1202);
  const double s8_1204 = mbgen::fma(projection.Rz[32], work.s7_234, work.s8_993 + s8_1203);
  const double s8_1205 = work.s8_866 + s8_1204 - work.s8_887;
  work.s8_1206 = mbgen::fnma(projection.Rz[17], work.s7_167, s8_1205);
  const double s8_1207 = work.s8_1042 + work.s8_1161;
  const double s8_1208 = work.s8_912 + (work.s8_999 + s8_1207) - work.s8_846;
  const double s8_1209 = mbgen::fnma(projection.Rz[14], work.s7_150, s8_1208);
  work.s8_1210 = mbgen::fnma(projection.Rz[2], work.s7_93, s8_1209);
  const double zd_lower_arm_left = state.zd[Coordinate::lower_arm_left];
  const double s8_1211 = mbgen::fma(zd_lower_arm_left, work.s8_18, work.s6_13);
  const double s8_1212 = 5.0 + work.s7_91;
  const double s8_1213 = work.s7_93 - 7.75;
  work.s8_1214 = zd_lower_arm_left*work.s8_17;
  work.s8_1215 = zd_lower_arm_left*work.s8_19;
  work.s8_1216 = mbgen::fma(work.s7_93, work.s8_1215, work.s7_91*work.s8_1214);
  const double s8_1217 = work.s7_102 - K_lower_arm_left_xx;
  work.s8_1218 = projection.Rz[0]*s8_1217;
  work.s8_1219 = projection.Rz[1]*s8_1217;
  const double s8_1220 = projection.Rz[2]*s8_1217;
  work.s8_1221 = mbgen::fnma(work.s7_93, s8_1211, projection.zdd_star[0]*work.s7_91);
  const double s8_1222 = mbgen::fma((-p_pitman_arm_z), work.s8_21, work.s8_1057);
  work.s8_1223 = mbgen::fma(work.s7_91, s8_1211, projection.zdd_star[0]*work.s7_93);
  const double s8_1224 = mbgen::fnma((-p_lower_arm_right_y), work.s8_27, work.s8_1055);
  const double s8_1225 = work.s7_99 - work.s7_100;
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s8_1226 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  const double s8_1227 = mbgen::fnma((-p_arb_link_front_left_from_x), R_arb_front_left_x_x,
      s8_1226);
  const double zd_arb_front_left = state.zd[Coordinate::arb_front_left];
  const double s8_1228 = zd_arb_front_left*s8_1227;
  const double s8_1229 = (-p_arb_link_front_left_from_x)*R_arb_front_left_x_z;
  const double s8_1230 = mbgen::fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s8_1229);
  const double s8_1231 = zd_arb_front_left*s8_1230;
  const double s8_1232 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s8_1233 = work.s1_12 + work.R_carrier_left_x_z;
  const double s8_1234 = mbgen::fma((-p_arb_link_front_left_to_y), s8_1233, s8_1232);
  const double s8_1235 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s8_1236 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  const double s8_1237 = mbgen::fma((-p_arb_link_front_left_to_y), s8_1235, s8_1236);
  const double s8_1238 = mbgen::fnma(work.s4_13, s8_1237, work.s4_2*s8_1234);
  const double s8_1239 = s8_1238 - work.s4_15;
  const double s8_1240 = mbgen::fms(work.s3_25, s8_1234, work.s8_822);
  work.s8_1241 = mbgen::fnma(work.s8_820, s8_1237, s8_1240);
  const double s8_1242 = mbgen::fms(work.s3_28, s8_1234, work.s8_828);
  work.s8_1243 = mbgen::fnma(work.s8_826, s8_1237, s8_1242);
  const double s8_1244 = mbgen::fms(work.s3_31, s8_1234, work.s8_834);
  const double s8_1245 = mbgen::fnma(work.s8_832, s8_1237, s8_1244);
  work.s8_1246 = s8_1230 - work.r_carrier_left_aux1_z - s8_1237 - (-p_arb_front_left_z);
  work.s8_1247 = 0.35 + (s8_1227 - s8_1234);
  const double s8_1248 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s8_1249 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  const double s8_1250 = mbgen::fma((-p_arb_link_front_left_to_y), s8_1248, s8_1249);
  work.s8_1251 = 0.72 - work.r_carrier_left_aux1_y - s8_1250;
  work.s8_1252 = 0.3333333333333333*work.s8_1251;
  work.s8_1253 = 0.3333333333333333*work.s8_1247;
  work.s8_1254 = 0.3333333333333333*work.s8_1246;
  const double s8_1255 = mbgen::fnma(work.s4_4, s8_1234, work.s4_13*s8_1250);
  const double s8_1256 = s8_1228 + (work.s4_14 + s8_1255);
  const double s8_1257 = mbgen::fma(projection.Rz[15], s8_1227, work.s8_821);
  const double s8_1258 = mbgen::fma(work.s8_820, s8_1250, s8_1257);
  work.s8_1259 = mbgen::fnma(work.s3_34, s8_1234, s8_1258);
  const double s8_1260 = mbgen::fma(projection.Rz[16], s8_1227, work.s8_827);
  const double s8_1261 = mbgen::fma(work.s8_826, s8_1250, s8_1260);
  work.s8_1262 = mbgen::fnma(work.s3_37, s8_1234, s8_1261);
  const double s8_1263 = mbgen::fma(projection.Rz[17], s8_1227, work.s8_833);
  const double s8_1264 = mbgen::fma(work.s8_832, s8_1250, s8_1263);
  const double s8_1265 = mbgen::fnma(work.s3_40, s8_1234, s8_1264);
  const double s8_1266 = mbgen::fnma(work.s3_34, s8_1237, projection.Rz[15]*s8_1230);
  work.s8_1267 = mbgen::fma(work.s3_25, s8_1250, s8_1266);
  const double s8_1268 = mbgen::fnma(work.s3_37, s8_1237, projection.Rz[16]*s8_1230);
  work.s8_1269 = mbgen::fma(work.s3_28, s8_1250, s8_1268);
  const double s8_1270 = mbgen::fnma(work.s3_40, s8_1237, projection.Rz[17]*s8_1230);
  const double s8_1271 = mbgen::fma(work.s3_31, s8_1250, s8_1270);
  const double s8_1272 = mbgen::fnma(work.s4_2, s8_1250, work.s4_4*s8_1237);
  const double s8_1273 = s8_1231 - s8_1272;
  const double s8_1274 = mbgen::fma(work.s8_22, work.s8_1246, work.s8_20*work.s8_1251);
  const double s8_1275 = mbgen::fnma(work.s8_26, work.s8_1247, s8_1274);
  const double s8_1276 = mbgen::fma(projection.zdd_star[5], s8_1230, s8_1275);
  const double s8_1277 = mbgen::fnma(work.s6_53, s8_1237, s8_1276);
  const double s8_1278 = mbgen::fma(work.s6_40, s8_1250, s8_1277);
  const double s8_1279 = mbgen::fnma(zd_arb_front_left, s8_1228, s8_1278);
  const double s8_1280 = mbgen::fma(work.s4_2, s8_1238, mbgen::fnma(work.s4_4, s8_1255, s8_1279));
  const double s8_1281 = mbgen::fma(work.s8_19, s8_1239, s8_1280);
  work.s8_1282 = 0.3333333333333333*mbgen::fnma(work.s8_17, s8_1256, s8_1281);
  const double s8_1283 = mbgen::fma(work.s1_10, projection.zdd_star[0], work.s6_14);
  const double s8_1284 = mbgen::fma(work.s8_20, work.s8_1247, s8_1283);
  const double s8_1285 = mbgen::fma(work.s8_21, work.s8_1246, s8_1284);
  const double s8_1286 = mbgen::fnma(work.s8_27, work.s8_1251, s8_1285);
  const double s8_1287 = mbgen::fma(work.s8_18, s8_1256, s8_1286);
  const double s8_1288 = mbgen::fma(work.s8_19, s8_1273, s8_1287);
  const double s8_1289 = mbgen::fnma(work.s6_40, s8_1234, s8_1288);
  const double s8_1290 = mbgen::fma(work.s8_838, s8_1237, s8_1289);
  const double s8_1291 = mbgen::fnma(work.s4_2, s8_1272, s8_1290);
  work.s8_1292 = 0.3333333333333333*mbgen::fma(work.s4_13, s8_1255, s8_1291);
  const double s8_1293 = mbgen::fnma(work.s1_8, projection.zdd_star[0], work.s6_15);
  const double s8_1294 = mbgen::fma(work.s8_21, work.s8_1251, s8_1293);
  const double s8_1295 = mbgen::fma(work.s8_22, work.s8_1247, s8_1294);
  const double s8_1296 = mbgen::fnma(work.s8_25, work.s8_1246, s8_1295);
  const double s8_1297 = mbgen::fnma(work.s8_18, s8_1239, s8_1296);
  const double s8_1298 = mbgen::fnma(work.s8_17, s8_1273, s8_1297);
  const double s8_1299 = mbgen::fnma(projection.zdd_star[5], s8_1227, s8_1298);
  const double s8_1300 = mbgen::fnma(work.s8_838, s8_1250, s8_1299);
  const double s8_1301 = mbgen::fma(work.s6_53, s8_1234, s8_1300);
  const double s8_1302 = mbgen::fnma(zd_arb_front_left, s8_1231, s8_1301);
  const double s8_1303 = mbgen::fnma(work.s4_13, s8_1238, s8_1302);
  work.s8_1304 = 0.3333333333333333*mbgen::fma(work.s4_4, s8_1272, s8_1303);
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s8_1305 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  const double s8_1306 = mbgen::fnma((-p_arb_link_front_right_from_x), R_arb_front_right_x_x,
      s8_1305);
  const double zd_arb_front_right = state.zd[Coordinate::arb_front_right];
  const double s8_1307 = zd_arb_front_right*s8_1306;
  const double s8_1308 = (-p_arb_link_front_right_from_x)*R_arb_front_right_x_z;
  const double s8_1309 = mbgen::fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s8_1308);
  const double s8_1310 = zd_arb_front_right*s8_1309;
  const double s8_1311 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s8_1312 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  const double s8_1313 = mbgen::fma((-p_arb_link_front_left_to_y), s8_1311, s8_1312);
  work.s8_1314 = 0.72 + (work.r_carrier_right_aux1_y + s8_1313);
  const double s8_1315 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s8_1316 = work.R_carrier_right_x_z - work.s1_28;
  const double s8_1317 = mbgen::fma((-p_arb_link_front_left_to_y), s8_1316, s8_1315);
  const double s8_1318 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s8_1319 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  const double s8_1320 = mbgen::fma((-p_arb_link_front_left_to_y), s8_1318, s8_1319);
  const double s8_1321 = mbgen::fnma(work.s4_17, s8_1320, work.s4_6*s8_1317);
  const double s8_1322 = work.s4_19 + s8_1321;
  const double s8_1323 = mbgen::fma(work.s3_43, s8_1317, work.s8_825);
  work.s8_1324 = mbgen::fnma(work.s8_823, s8_1320, s8_1323);
  const double s8_1325 = mbgen::fma(work.s3_46, s8_1317, work.s8_831);
  work.s8_1326 = mbgen::fnma(work.s8_829, s8_1320, s8_1325);
  const double s8_1327 = mbgen::fma(work.s3_49, s8_1317, work.s8_837);
  const double s8_1328 = mbgen::fnma(work.s8_835, s8_1320, s8_1327);
  work.s8_1329 = work.s1_26 + s8_1309 - s8_1320 - (-p_arb_front_right_z);
  work.s8_1330 = 0.35 + (s8_1306 - s8_1317);
  work.s8_1331 = 0.3333333333333333*work.s8_1330;
  work.s8_1332 = 0.3333333333333333*work.s8_1329;
  work.s8_1333 = 0.3333333333333333*work.s8_1314;
  const double s8_1334 = mbgen::fnma(work.s4_8, s8_1317, work.s4_17*s8_1313);
  const double s8_1335 = s8_1307 + (work.s4_18 + s8_1334);
  const double s8_1336 = mbgen::fma(projection.Rz[33], s8_1306, work.s8_824);
  const double s8_1337 = mbgen::fma(work.s8_823, s8_1313, s8_1336);
  work.s8_1338 = mbgen::fnma(work.s3_52, s8_1317, s8_1337);
  const double s8_1339 = mbgen::fma(projection.Rz[34], s8_1306, work.s8_830);
  const double s8_1340 = mbgen::fma(work.s8_829, s8_1313, s8_1339);
  work.s8_1341 = mbgen::fnma(work.s3_55, s8_1317, s8_1340);
  const double s8_1342 = mbgen::fma(projection.Rz[35], s8_1306, work.s8_836);
  const double s8_1343 = mbgen::fma(work.s8_835, s8_1313, s8_1342);
  const double s8_1344 = mbgen::fnma(work.s3_58, s8_1317, s8_1343);
  const double s8_1345 = mbgen::fnma(work.s3_52, s8_1320, projection.Rz[33]*s8_1309);
  work.s8_1346 = mbgen::fma(work.s3_43, s8_1313, s8_1345);
  const double s8_1347 = mbgen::fnma(work.s3_55, s8_1320, projection.Rz[34]*s8_1309);
  work.s8_1348 = mbgen::fma(work.s3_46, s8_1313, s8_1347);
  const double s8_1349 = mbgen::fnma(work.s3_58, s8_1320, projection.Rz[35]*s8_1309);
  const double s8_1350 = mbgen::fma(work.s3_49, s8_1313, s8_1349);
  const double s8_1351 = mbgen::fnma(work.s4_6, s8_1313, work.s4_8*s8_1320);
  const double s8_1352 = s8_1310 - s8_1351;
  const double s8_1353 = mbgen::fnma(work.s1_25, projection.zdd_star[6], work.s6_19);
  const double s8_1354 = mbgen::fma(work.s8_27, work.s8_1314, s8_1353);
  const double s8_1355 = mbgen::fma(work.s8_20, work.s8_1330, s8_1354);
  const double s8_1356 = mbgen::fma(work.s8_21, work.s8_1329, s8_1355);
  const double s8_1357 = mbgen::fma(work.s8_18, s8_1335, s8_1356);
  const double s8_1358 = mbgen::fma(work.s8_19, s8_1352, s8_1357);
  const double s8_1359 = mbgen::fnma(work.s6_47, s8_1317, s8_1358);
  const double s8_1360 = mbgen::fma(work.s8_839, s8_1320, s8_1359);
  const double s8_1361 = mbgen::fnma(work.s4_6, s8_1351, s8_1360);
  work.s8_1362 = 0.3333333333333333*mbgen::fma(work.s4_17, s8_1334, s8_1361);
  const double s8_1363 = mbgen::fnma(work.s8_26, work.s8_1330, work.s8_22*work.s8_1329);
  const double s8_1364 = mbgen::fnma(work.s8_20, work.s8_1314, s8_1363);
  const double s8_1365 = mbgen::fma(projection.zdd_star[11], s8_1309, s8_1364);
  const double s8_1366 = mbgen::fnma(work.s6_59, s8_1320, s8_1365);
  const double s8_1367 = mbgen::fma(work.s6_47, s8_1313, s8_1366);
  const double s8_1368 = mbgen::fnma(zd_arb_front_right, s8_1307, s8_1367);
  const double s8_1369 = mbgen::fma(work.s4_6, s8_1321, mbgen::fnma(work.s4_8, s8_1334, s8_1368));
  const double s8_1370 = mbgen::fma(work.s8_19, s8_1322, s8_1369);
  work.s8_1371 = 0.3333333333333333*mbgen::fnma(work.s8_17, s8_1335, s8_1370);
  const double s8_1372 = mbgen::fms(work.s8_22, work.s8_1330, work.s8_840);
  const double s8_1373 = mbgen::fnma(work.s1_25, work.s6_18, s8_1372);
  const double s8_1374 = mbgen::fnma(work.s8_25, work.s8_1329, s8_1373);
  const double s8_1375 = mbgen::fnma(work.s8_21, work.s8_1314, s8_1374);
  const double s8_1376 = mbgen::fnma(work.s8_18, s8_1322, s8_1375);
  const double s8_1377 = mbgen::fnma(work.s8_17, s8_1352, s8_1376);
  const double s8_1378 = mbgen::fnma(projection.zdd_star[11], s8_1306, s8_1377);
  const double s8_1379 = mbgen::fnma(work.s8_839, s8_1313, s8_1378);
  const double s8_1380 = mbgen::fma(work.s6_59, s8_1317, s8_1379);
  const double s8_1381 = mbgen::fnma(zd_arb_front_right, s8_1310, s8_1380);
  const double s8_1382 = mbgen::fnma(work.s4_17, s8_1321, s8_1381);
  work.s8_1383 = 0.3333333333333333*mbgen::fma(work.s4_8, s8_1351, s8_1382);
  // drag_link
  const double s8_1384 = (-p_drag_link_from_z)*work.sines[15];
  const double s8_1385 = (-p_drag_link_from_z)*work.cosines[15];
  const double R_bell_crank_y_x = work.sines[16];
  const double s8_1386 = p_drag_link_to_y*R_bell_crank_y_x;
  const double zd_pitman_arm = state.zd[Coordinate::pitman_arm];
  const double s8_1387 = zd_pitman_arm*s8_1384;
  const double s8_1388 = zd_pitman_arm*s8_1385;
  const double zd_bell_crank = state.zd[Coordinate::bell_crank];
  const double s8_1389 = zd_bell_crank*s8_1386;
  const double R_bell_crank_x_x = work.cosines[16];
  const double s8_1390 = p_drag_link_to_y*R_bell_crank_x_x;
  const double s8_1391 = zd_bell_crank*s8_1390;
  work.s8_1392 = projection.Rz[36]*s8_1384;
  work.s8_1393 = projection.Rz[37]*s8_1384;
  const double s8_1394 = projection.Rz[38]*s8_1384;
  work.s8_1395 = projection.Rz[39]*s8_1386;
  work.s8_1396 = projection.Rz[40]*s8_1386;
  const double s8_1397 = projection.Rz[41]*s8_1386;
  work.s8_1398 = p_pitman_arm_y - s8_1390;
  work.s8_1399 = 1.5*work.s8_1398;
  work.s8_1400 = 0.2 - s8_1385;
  work.s8_1401 = 1.15 + (s8_1386 - s8_1384);
  work.s8_1402 = 1.5*work.s8_1400;
  work.s8_1403 = 1.5*work.s8_1401;
  work.s8_1404 = mbgen::fnma(projection.Rz[36], s8_1385, projection.Rz[39]*s8_1390);
  work.s8_1405 = mbgen::fnma(projection.Rz[37], s8_1385, projection.Rz[40]*s8_1390);
  const double s8_1406 = mbgen::fnma(projection.Rz[38], s8_1385, projection.Rz[41]*s8_1390);
  const double s8_1407 = mbgen::fma(work.s8_1392, work.s8_1392, work.s8_1395*work.s8_1395);
  const double s8_1408 = mbgen::fma(work.s8_1404, work.s8_1404, s8_1407);
  const double s8_1409 = mbgen::fma(work.s8_1392, work.s8_1393, work.s8_1395*work.s8_1396);
  work.s8_1410 = mbgen::fma(work.s8_1404, work.s8_1405, s8_1409);
  const double s8_1411 = mbgen::fma(work.s8_1392, s8_1394, work.s8_1395*s8_1397);
  const double s8_1412 = mbgen::fma(work.s8_1404, s8_1406, s8_1411);
  const double s8_1413 = mbgen::fma(work.s8_1393, work.s8_1393, work.s8_1396*work.s8_1396);
  const double s8_1414 = mbgen::fma(work.s8_1405, work.s8_1405, s8_1413);
  const double s8_1415 = mbgen::fma(work.s8_1393, s8_1394, work.s8_1396*s8_1397);
  const double s8_1416 = mbgen::fma(work.s8_1405, s8_1406, s8_1415);
  const double s8_1417 = mbgen::fma(s8_1394, s8_1394, s8_1397*s8_1397);
  const double s8_1418 = mbgen::fma(s8_1406, s8_1406, s8_1417);
  const double s8_1419 = mbgen::fma(work.s8_22, work.s8_1400, work.s8_20*work.s8_1398);
  const double s8_1420 = mbgen::fnma(work.s8_26, work.s8_1401, s8_1419);
  const double s8_1421 = mbgen::fma(projection.zdd_star[13], s8_1390, s8_1420);
  const double s8_1422 = mbgen::fnma(projection.zdd_star[12], s8_1385, s8_1421);
  const double s8_1423 = mbgen::fma(s8_1387, zd_pitman_arm + work.s8_17, s8_1422);
  work.s8_1424 = 1.5*mbgen::fnma(s8_1389, zd_bell_crank + work.s8_19, s8_1423);
  const double s8_1425 = s8_1391 - s8_1388;
  const double s8_1426 = mbgen::fma(work.s8_22, work.s8_1401, work.s8_21*work.s8_1398);
  const double s8_1427 = mbgen::fnma(work.s8_25, work.s8_1400, s8_1426);
  const double s8_1428 = mbgen::fma(projection.zdd_star[12], s8_1384, s8_1427);
  const double s8_1429 = mbgen::fma(zd_pitman_arm, s8_1388, s8_1428);
  const double s8_1430 = mbgen::fma(work.s8_18, s8_1389, s8_1429);
  work.s8_1431 = 1.5*mbgen::fnma(work.s8_17, s8_1425, s8_1430);
  const double s8_1432 = mbgen::fma(zd_bell_crank, s8_1391, projection.zdd_star[13]*s8_1386);
  const double s8_1433 = mbgen::fma(work.s8_19, s8_1425, s8_1432);
  const double s8_1434 = mbgen::fnma(work.s8_18, s8_1387, s8_1433);
  const double s8_1435 = mbgen::fma(work.s8_20, work.s8_1401, s8_1434);
  const double s8_1436 = mbgen::fma(work.s8_21, work.s8_1400, s8_1435);
  work.s8_1437 = 1.5*mbgen::fnma(work.s8_27, work.s8_1398, s8_1436);
  // tie_rod_left
  const double s8_1438 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s8_1439 = (-p_tie_rod_left_from_x)*R_bell_crank_y_x;
  const double s8_1440 = mbgen::fma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s8_1438);
  const double s8_1441 = zd_bell_crank*s8_1440;
  const double s8_1442 = mbgen::fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s8_1439);
  const double s8_1443 = zd_bell_crank*s8_1442;
  const double s8_1444 = p_tie_rod_left_to_z*work.R_carrier_left_z_z;
  const double s8_1445 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_z_x, s8_1444);
  const double s8_1446 = mbgen::fnma((-p_tie_rod_left_to_y), work.R_carrier_left_aux2_z_y, s8_1445);
  work.s8_1447 = (-p_bell_crank_z) + (work.r_carrier_left_aux1_z + s8_1446);
  const double s8_1448 = p_tie_rod_left_to_z*work.R_carrier_left_y_z;
  const double s8_1449 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_y_x, s8_1448);
  const double s8_1450 = mbgen::fnma((-p_tie_rod_left_to_y), work.R_carrier_left_aux2_y_y, s8_1449);
  const double s8_1451 = (-p_tie_rod_left_to_y)*work.s1_12;
  const double s8_1452 = mbgen::fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, s8_1451);
  const double s8_1453 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_x_x, s8_1452);
  const double s8_1454 = mbgen::fnma(work.s4_4, s8_1453, work.s4_13*s8_1450);
  const double s8_1455 = work.s4_14 + s8_1454;
  const double s8_1456 = mbgen::fma(work.s8_820, s8_1450, work.s8_821);
  work.s8_1457 = mbgen::fnma(work.s3_34, s8_1453, s8_1456);
  const double s8_1458 = mbgen::fma(work.s8_826, s8_1450, work.s8_827);
  work.s8_1459 = mbgen::fnma(work.s3_37, s8_1453, s8_1458);
  const double s8_1460 = mbgen::fma(work.s8_832, s8_1450, work.s8_833);
  const double s8_1461 = mbgen::fnma(work.s3_40, s8_1453, s8_1460);
  const double s8_1462 = mbgen::fnma(work.s4_2, s8_1450, work.s4_4*s8_1446);
  const double s8_1463 = s8_1443 + s8_1462;
  const double s8_1464 = mbgen::fma(work.s3_34, s8_1446, projection.Rz[39]*s8_1442);
  work.s8_1465 = mbgen::fnma(work.s3_25, s8_1450, s8_1464);
  const double s8_1466 = mbgen::fma(work.s3_37, s8_1446, projection.Rz[40]*s8_1442);
  work.s8_1467 = mbgen::fnma(work.s3_28, s8_1450, s8_1466);
  const double s8_1468 = mbgen::fma(work.s3_40, s8_1446, projection.Rz[41]*s8_1442);
  const double s8_1469 = mbgen::fnma(work.s3_31, s8_1450, s8_1468);
  work.s8_1470 = 0.35 + (s8_1440 + s8_1453);
  work.s8_1471 = s8_1442 - work.r_carrier_left_aux1_y - s8_1450;
  work.s8_1472 = 1.1666666666666667*work.s8_1471;
  work.s8_1473 = 1.1666666666666667*work.s8_1470;
  const double s8_1474 = mbgen::fnma(work.s4_13, s8_1446, work.s4_2*s8_1453);
  const double s8_1475 = s8_1441 + s8_1474 - work.s4_15;
  const double s8_1476 = mbgen::fms(projection.Rz[39], s8_1440, work.s8_822);
  const double s8_1477 = mbgen::fma(work.s3_25, s8_1453, s8_1476);
  work.s8_1478 = mbgen::fnma(work.s8_820, s8_1446, s8_1477);
  const double s8_1479 = mbgen::fms(projection.Rz[40], s8_1440, work.s8_828);
  const double s8_1480 = mbgen::fma(work.s3_28, s8_1453, s8_1479);
  work.s8_1481 = mbgen::fnma(work.s8_826, s8_1446, s8_1480);
  const double s8_1482 = mbgen::fms(projection.Rz[41], s8_1440, work.s8_834);
  const double s8_1483 = mbgen::fma(work.s3_31, s8_1453, s8_1482);
  const double s8_1484 = mbgen::fnma(work.s8_832, s8_1446, s8_1483);
  work.s8_1485 = 1.1666666666666667*work.s8_1447;
  const double s8_1486 = mbgen::fma(work.s8_21, work.s8_1471, s8_1293);
  const double s8_1487 = mbgen::fnma(work.s8_22, work.s8_1470, s8_1486);
  const double s8_1488 = mbgen::fma(work.s8_25, work.s8_1447, s8_1487);
  const double s8_1489 = mbgen::fma(work.s8_17, s8_1463, s8_1488);
  const double s8_1490 = mbgen::fnma(work.s8_18, s8_1475, s8_1489);
  const double s8_1491 = mbgen::fnma(work.s8_838, s8_1450, s8_1490);
  const double s8_1492 = mbgen::fma(work.s6_53, s8_1453, s8_1491);
  const double s8_1493 = mbgen::fnma(work.s4_13, s8_1474, s8_1492);
  work.s8_1494 = 1.1666666666666667*mbgen::fma(work.s4_4, s8_1462, s8_1493);
  const double s8_1495 = mbgen::fnma(work.s8_22, work.s8_1447, work.s8_20*work.s8_1471);
  const double s8_1496 = mbgen::fma(work.s8_26, work.s8_1470, s8_1495);
  const double s8_1497 = mbgen::fma(zd_bell_crank, s8_1441, s8_1496);
  const double s8_1498 = mbgen::fma(work.s4_2, s8_1474, mbgen::fnma(work.s4_4, s8_1454, s8_1497));
  const double s8_1499 = mbgen::fnma(projection.zdd_star[13], s8_1442, s8_1498);
  const double s8_1500 = mbgen::fnma(work.s6_53, s8_1446, s8_1499);
  const double s8_1501 = mbgen::fma(work.s6_40, s8_1450, s8_1500);
  const double s8_1502 = mbgen::fma(work.s8_19, s8_1475, s8_1501);
  work.s8_1503 = 1.1666666666666667*mbgen::fnma(work.s8_17, s8_1455, s8_1502);
  const double s8_1504 = mbgen::fnma(work.s8_20, work.s8_1470, s8_1283);
  const double s8_1505 = mbgen::fnma(work.s8_21, work.s8_1447, s8_1504);
  const double s8_1506 = mbgen::fnma(work.s8_27, work.s8_1471, s8_1505);
  const double s8_1507 = mbgen::fma(work.s8_18, s8_1455, s8_1506);
  const double s8_1508 = mbgen::fnma(work.s8_19, s8_1463, s8_1507);
  const double s8_1509 = mbgen::fnma(projection.zdd_star[13], s8_1440, s8_1508);
  const double s8_1510 = mbgen::fnma(work.s6_40, s8_1453, s8_1509);
  const double s8_1511 = mbgen::fma(work.s8_838, s8_1446, s8_1510);
  const double s8_1512 = mbgen::fnma(zd_bell_crank, s8_1443, s8_1511);
  const double s8_1513 = mbgen::fnma(work.s4_2, s8_1462, s8_1512);
  work.s8_1514 = 1.1666666666666667*mbgen::fma(work.s4_13, s8_1454, s8_1513);
  // tie_rod_right
  const double s8_1515 = mbgen::fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s8_1439);
  const double s8_1516 = zd_bell_crank*s8_1515;
  const double s8_1517 = mbgen::fnma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s8_1438);
  const double s8_1518 = zd_bell_crank*s8_1517;
  const double s8_1519 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s8_1520 = mbgen::fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, s8_1519);
  const double s8_1521 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_z_x, s8_1520);
  work.s8_1522 = (-p_bell_crank_z) + (s8_1521 - work.s1_26);
  const double s8_1523 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s8_1524 = mbgen::fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, s8_1523);
  const double s8_1525 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_y_x, s8_1524);
  work.s8_1526 = s8_1515 + (work.r_carrier_right_aux1_y + s8_1525);
  const double s8_1527 = p_tie_rod_right_to_z*work.R_carrier_right_x_z;
  const double s8_1528 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_x_x, s8_1527);
  const double s8_1529 = mbgen::fnma(p_tie_rod_right_to_y, work.s1_28, s8_1528);
  const double s8_1530 = mbgen::fnma(work.s4_8, s8_1529, work.s4_17*s8_1525);
  const double s8_1531 = work.s4_18 + s8_1530;
  const double s8_1532 = mbgen::fma(work.s8_823, s8_1525, work.s8_824);
  work.s8_1533 = mbgen::fnma(work.s3_52, s8_1529, s8_1532);
  const double s8_1534 = mbgen::fma(work.s8_829, s8_1525, work.s8_830);
  work.s8_1535 = mbgen::fnma(work.s3_55, s8_1529, s8_1534);
  const double s8_1536 = mbgen::fma(work.s8_835, s8_1525, work.s8_836);
  const double s8_1537 = mbgen::fnma(work.s3_58, s8_1529, s8_1536);
  work.s8_1538 = s8_1517 - s8_1529 - 0.35;
  work.s8_1539 = 1.1666666666666667*work.s8_1538;
  work.s8_1540 = 1.1666666666666667*work.s8_1526;
  work.s8_1541 = 1.1666666666666667*work.s8_1522;
  const double s8_1542 = mbgen::fnma(work.s3_52, s8_1521, projection.Rz[39]*s8_1515);
  work.s8_1543 = mbgen::fma(work.s3_43, s8_1525, s8_1542);
  const double s8_1544 = mbgen::fnma(work.s3_55, s8_1521, projection.Rz[40]*s8_1515);
  work.s8_1545 = mbgen::fma(work.s3_46, s8_1525, s8_1544);
  const double s8_1546 = mbgen::fnma(work.s3_58, s8_1521, projection.Rz[41]*s8_1515);
  const double s8_1547 = mbgen::fma(work.s3_49, s8_1525, s8_1546);
  const double s8_1548 = work.s8_897 + (work.s8_875 + (work.s8_1022 + (work.s8_1066 + s8_1186)));
  const double s8_1549 = mbgen::fma((-p_bell_crank_z), work.s8_843, s8_1548);
  const double s8_1550 = mbgen::fma((-p_pitman_arm_z), work.s8_867, s8_1549);
  const double s8_1551 = mbgen::fnma(p_pitman_arm_x, work.s8_866, s8_1550);
  const double s8_1552 = mbgen::fnma(work.s1_26, work.s8_987, s8_1551);
  const double s8_1553 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_1147, s8_1552);
  const double s8_1554 = mbgen::fnma(work.s8_1254, s8_1271, s8_1553);
  const double s8_1555 = mbgen::fnma(work.s8_1253, s8_1265, s8_1554);
  const double s8_1556 = mbgen::fnma(work.s8_1332, s8_1350, s8_1555);
  const double s8_1557 = mbgen::fnma(work.s8_1331, s8_1344, s8_1556);
  const double s8_1558 = mbgen::fma(s8_1394, work.s8_1403, s8_1557);
  const double s8_1559 = mbgen::fnma(work.s8_1402, s8_1406, s8_1558);
  const double s8_1560 = mbgen::fnma(s8_1469, work.s8_1485, s8_1559);
  const double s8_1561 = mbgen::fma(s8_1461, work.s8_1473, s8_1560);
  const double s8_1562 = mbgen::fma(work.s8_1541, s8_1547, s8_1561);
  const double s8_1563 = work.s8_993 + mbgen::fma(projection.Rz[32], work.s7_234, s8_1203);
  const double s8_1564 = mbgen::fnma(s8_1537, work.s8_1539, s8_1562);
  const double s8_1565 = mbgen::fma(projection.Rz[17], work.s7_163, work.s8_890);
  const double s8_1566 = mbgen::fnma(p_lower_arm_left_x, s8_1563, s8_1564);
  const double s8_1567 = mbgen::fma(projection.Rz[17], work.s7_167, work.s8_887);
  const double s8_1568 = mbgen::fnma((-p_rear_axle_tx_z), s8_1565, s8_1566);
  work.s8_1569 = mbgen::fma(p_arb_front_right_x, s8_1567, s8_1568);
  const double s8_1570 = mbgen::fnma(work.s4_17, s8_1521, work.s4_6*s8_1529);
  const double s8_1571 = mbgen::fnma(work.s4_6, s8_1525, work.s4_8*s8_1521);
  const double s8_1572 = mbgen::fms(projection.Rz[39], s8_1517, work.s8_825);
  const double s8_1573 = mbgen::fnma(work.s3_43, s8_1529, s8_1572);
  work.s8_1574 = mbgen::fma(work.s8_823, s8_1521, s8_1573);
  const double s8_1575 = mbgen::fms(projection.Rz[40], s8_1517, work.s8_831);
  const double s8_1576 = mbgen::fnma(work.s3_46, s8_1529, s8_1575);
  work.s8_1577 = mbgen::fma(work.s8_829, s8_1521, s8_1576);
  const double s8_1578 = mbgen::fms(projection.Rz[41], s8_1517, work.s8_837);
  const double s8_1579 = mbgen::fnma(work.s3_49, s8_1529, s8_1578);
  const double s8_1580 = mbgen::fma(work.s8_835, s8_1521, s8_1579);
  const double s8_1581 = work.s8_999 + (work.s8_912 + s8_1207);
  const double s8_1582 = mbgen::fnma(projection.Rz[14], work.s7_150, s8_1581);
  const double s8_1583 = work.s8_1012 + (work.s8_850 + work.s8_1176);
  const double s8_1584 = mbgen::fnma(p_bell_crank_x, work.s8_846, s8_1583);
  const double s8_1585 = mbgen::fma(p_pitman_arm_y, work.s8_867, s8_1584);
  const double s8_1586 = mbgen::fma(projection.Rz[35], work.s7_253, s8_1585);
  const double s8_1587 = mbgen::fnma(work.r_carrier_right_aux1_y, work.s8_987, s8_1586);
  const double s8_1588 = mbgen::fnma(projection.Rz[17], work.s7_161, s8_1587);
  const double s8_1589 = mbgen::fnma(work.r_carrier_left_aux1_y, work.s8_1147, s8_1588);
  const double s8_1590 = mbgen::fma(work.s8_1252, s8_1271, s8_1589);
  const double s8_1591 = mbgen::fma(s8_1245, work.s8_1253, s8_1590);
  const double s8_1592 = mbgen::fma(s8_1328, work.s8_1331, s8_1591);
  const double s8_1593 = mbgen::fnma(work.s8_1333, s8_1350, s8_1592);
  const double s8_1594 = mbgen::fma(work.s8_1399, s8_1406, s8_1593);
  const double s8_1595 = mbgen::fnma(s8_1397, work.s8_1403, s8_1594);
  const double s8_1596 = mbgen::fnma(work.s8_1473, s8_1484, s8_1595);
  const double s8_1597 = mbgen::fnma(s8_1469, work.s8_1472, s8_1596);
  const double s8_1598 = mbgen::fnma(work.s8_1539, s8_1580, s8_1597);
  const double s8_1599 = mbgen::fnma(projection.Rz[2], work.s7_93, s8_1582);
  const double s8_1600 = mbgen::fnma(work.s8_1540, s8_1547, s8_1598);
  const double s8_1601 = mbgen::fnma(projection.Rz[17], work.s7_163, work.s8_890);
  const double s8_1602 = mbgen::fma(p_lower_arm_left_x, s8_1599, s8_1600);
  work.s8_1603 = mbgen::fma(p_carrier_left_rz_y, s8_1601, s8_1602);
  const double s8_1604 = mbgen::fma(projection.Rz[14], work.s7_148, work.s8_866);
  const double s8_1605 = work.s8_921 + (work.s8_1051 + (work.s8_1083 + (s8_1199 + s8_1220)));
  const double s8_1606 = mbgen::fnma((-p_bell_crank_z), work.s8_846, work.s8_1035 + s8_1605);
  const double s8_1607 = mbgen::fnma(projection.Rz[35], work.s7_251, s8_1606);
  const double s8_1608 = mbgen::fma(work.s1_26, work.s8_999, s8_1607);
  const double s8_1609 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_993, s8_1608);
  const double s8_1610 = mbgen::fnma(projection.Rz[17], work.s7_165, s8_1609);
  const double s8_1611 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_1155, s8_1610);
  const double s8_1612 = mbgen::fnma(work.r_carrier_left_aux1_z, work.s8_1161, s8_1611);
  const double s8_1613 = mbgen::fma(work.s8_1252, s8_1265, s8_1612);
  const double s8_1614 = mbgen::fnma(s8_1245, work.s8_1254, s8_1613);
  const double s8_1615 = mbgen::fnma(work.s8_1333, s8_1344, s8_1614);
  const double s8_1616 = mbgen::fnma(s8_1328, work.s8_1332, s8_1615);
  const double s8_1617 = mbgen::fma(s8_1397, work.s8_1402, s8_1616);
  const double s8_1618 = mbgen::fnma(s8_1394, work.s8_1399, s8_1617);
  const double s8_1619 = mbgen::fma(s8_1484, work.s8_1485, s8_1618);
  const double s8_1620 = mbgen::fma(s8_1461, work.s8_1472, s8_1619);
  const double s8_1621 = mbgen::fnma(s8_1537, work.s8_1540, s8_1620);
  const double s8_1622 = mbgen::fnma(projection.Rz[32], work.s7_234, s8_1604);
  const double s8_1623 = mbgen::fnma(work.s8_1541, s8_1580, s8_1621);
  const double s8_1624 = mbgen::fms(projection.Rz[2], work.s7_91, work.s8_1039);
  const double s8_1625 = mbgen::fma((-p_rear_axle_tx_z), s8_1622, s8_1623);
  const double s8_1626 = mbgen::fnma(projection.Rz[17], work.s7_167, work.s8_887);
  const double s8_1627 = mbgen::fma(p_lower_arm_left_y, s8_1624, s8_1625);
  const double s8_1628 = mbgen::fnma(projection.Rz[2], work.s7_93, work.s8_1042);
  const double s8_1629 = mbgen::fma(p_carrier_left_rz_y, s8_1626, s8_1627);
  const double s8_1630 = mbgen::fnma(projection.Rz[14], work.s7_150, work.s8_912);
  const double s8_1631 = mbgen::fma((-p_lower_arm_left_z), s8_1628, s8_1629);
  work.s8_1632 = mbgen::fma((-p_upper_arm_right_z), s8_1630, s8_1631);
  const double s8_1633 = s8_1518 - work.s4_19 - s8_1570;
  const double s8_1634 = mbgen::fma(work.s8_1267, work.s8_1267, work.s8_1241*work.s8_1241);
  const double s8_1635 = mbgen::fma(work.s8_1259, work.s8_1259, s8_1634);
  const double s8_1636 = mbgen::fma(work.s8_1324, work.s8_1324, s8_1635);
  const double s8_1637 = mbgen::fma(work.s8_1346, work.s8_1346, s8_1636);
  const double s8_1638 = mbgen::fma(work.s8_1465, work.s8_1465, work.s8_1457*work.s8_1457);
  const double s8_1639 = mbgen::fma(work.s8_1478, work.s8_1478, s8_1638);
  const double s8_1640 = mbgen::fma(work.s8_1533, work.s8_1533, s8_1639);
  const double s8_1641 = mbgen::fma(work.s8_1543, work.s8_1543, s8_1640);
  const double s8_1642 = projection.Rz[39]*work.s8_848;
  const double s8_1643 = mbgen::fma(projection.Rz[36], work.s8_873, s8_1642);
  const double s8_1644 = mbgen::fma(projection.Rz[33], work.s8_895, s8_1643);
  const double s8_1645 = mbgen::fma(projection.Rz[30], work.s8_919, s8_1644);
  const double s8_1646 = mbgen::fma(work.s8_825, work.s8_995, s8_1645);
  const double s8_1647 = mbgen::fma(work.s8_824, work.s8_989, s8_1646);
  const double s8_1648 = mbgen::fma(work.s3_52, work.s8_1016, s8_1647);
  const double s8_1649 = mbgen::fma(work.s3_43, work.s8_1006, s8_1648);
  const double s8_1650 = mbgen::fma(work.s8_823, work.s8_1027, s8_1649);
  const double s8_1651 = mbgen::fma(projection.Rz[18], work.s8_1049, s8_1650);
  const double s8_1652 = mbgen::fma(projection.Rz[15], work.s8_1064, s8_1651);
  const double s8_1653 = mbgen::fma(projection.Rz[12], work.s8_1081, s8_1652);
  const double s8_1654 = mbgen::fma(work.s8_821, work.s8_1151, s8_1653);
  const double s8_1655 = mbgen::fnma(work.s8_822, work.s8_1157, s8_1654);
  const double s8_1656 = mbgen::fma(work.s3_34, work.s8_1180, s8_1655);
  const double s8_1657 = mbgen::fma(work.s3_25, work.s8_1170, s8_1656);
  const double s8_1658 = mbgen::fma(work.s8_820, work.s8_1191, s8_1657);
  const double s8_1659 = mbgen::fma(projection.Rz[0], work.s8_1218, s8_1658);
  const double s8_1660 = mbgen::fma(work.s8_1338, work.s8_1338, s8_1637);
  const double s8_1661 = mbgen::fnma(1.5, s8_1408, s8_1659);
  const double s8_1662 = mbgen::fnma(0.3333333333333333, s8_1660, s8_1661);
  const double s8_1663 = mbgen::fma(work.s8_1574, work.s8_1574, s8_1641);
  work.s8_1664 = mbgen::fnma(1.1666666666666667, s8_1663, s8_1662);
  const double s8_1665 = mbgen::fma(work.s8_1267, s8_1271, work.s8_1241*s8_1245);
  const double s8_1666 = mbgen::fma(work.s8_1259, s8_1265, s8_1665);
  const double s8_1667 = mbgen::fma(work.s8_1324, s8_1328, s8_1666);
  const double s8_1668 = mbgen::fma(work.s8_1346, s8_1350, s8_1667);
  const double s8_1669 = mbgen::fma(work.s8_1465, s8_1469, work.s8_1457*s8_1461);
  const double s8_1670 = mbgen::fma(work.s8_1478, s8_1484, s8_1669);
  const double s8_1671 = mbgen::fma(work.s8_1533, s8_1537, s8_1670);
  const double s8_1672 = mbgen::fma(work.s8_1543, s8_1547, s8_1671);
  const double s8_1673 = projection.Rz[39]*work.s8_850;
  const double s8_1674 = mbgen::fma(projection.Rz[36], work.s8_875, s8_1673);
  const double s8_1675 = mbgen::fma(projection.Rz[33], work.s8_897, s8_1674);
  const double s8_1676 = mbgen::fma(projection.Rz[30], work.s8_921, s8_1675);
  const double s8_1677 = mbgen::fma(work.s8_825, work.s8_999, s8_1676);
  const double s8_1678 = mbgen::fma(work.s8_824, work.s8_993, s8_1677);
  const double s8_1679 = mbgen::fma(work.s3_52, work.s8_1022, s8_1678);
  const double s8_1680 = mbgen::fma(work.s3_43, work.s8_1012, s8_1679);
  const double s8_1681 = mbgen::fma(work.s8_823, work.s8_1035, s8_1680);
  const double s8_1682 = mbgen::fma(projection.Rz[18], work.s8_1051, s8_1681);
  const double s8_1683 = mbgen::fma(projection.Rz[15], work.s8_1066, s8_1682);
  const double s8_1684 = mbgen::fma(projection.Rz[12], work.s8_1083, s8_1683);
  const double s8_1685 = mbgen::fma(work.s8_821, work.s8_1155, s8_1684);
  const double s8_1686 = mbgen::fnma(work.s8_822, work.s8_1161, s8_1685);
  const double s8_1687 = mbgen::fma(work.s3_34, s8_1186, s8_1686);
  const double s8_1688 = mbgen::fma(work.s3_25, work.s8_1176, s8_1687);
  const double s8_1689 = mbgen::fma(work.s8_820, s8_1199, s8_1688);
  const double s8_1690 = mbgen::fma(projection.Rz[0], s8_1220, s8_1689);
  const double s8_1691 = mbgen::fma(work.s8_1338, s8_1344, s8_1668);
  const double s8_1692 = mbgen::fnma(1.5, s8_1412, s8_1690);
  const double s8_1693 = mbgen::fnma(0.3333333333333333, s8_1691, s8_1692);
  const double s8_1694 = mbgen::fma(work.s8_1574, s8_1580, s8_1672);
  work.s8_1695 = mbgen::fnma(1.1666666666666667, s8_1694, s8_1693);
  const double s8_1696 = mbgen::fma(work.s8_1269, work.s8_1269, work.s8_1243*work.s8_1243);
  const double s8_1697 = mbgen::fma(work.s8_1262, work.s8_1262, s8_1696);
  const double s8_1698 = mbgen::fma(work.s8_1326, work.s8_1326, s8_1697);
  const double s8_1699 = mbgen::fma(work.s8_1348, work.s8_1348, s8_1698);
  const double s8_1700 = mbgen::fma(work.s8_1467, work.s8_1467, work.s8_1459*work.s8_1459);
  const double s8_1701 = mbgen::fma(work.s8_1481, work.s8_1481, s8_1700);
  const double s8_1702 = mbgen::fma(work.s8_1535, work.s8_1535, s8_1701);
  const double s8_1703 = mbgen::fma(work.s8_1545, work.s8_1545, s8_1702);
  const double s8_1704 = projection.Rz[40]*work.s8_849;
  const double s8_1705 = mbgen::fma(projection.Rz[37], work.s8_874, s8_1704);
  const double s8_1706 = mbgen::fma(projection.Rz[34], work.s8_896, s8_1705);
  const double s8_1707 = mbgen::fma(projection.Rz[31], work.s8_920, s8_1706);
  const double s8_1708 = mbgen::fma(work.s8_831, work.s8_997, s8_1707);
  const double s8_1709 = mbgen::fma(work.s8_830, work.s8_991, s8_1708);
  const double s8_1710 = mbgen::fma(work.s3_55, work.s8_1019, s8_1709);
  const double s8_1711 = mbgen::fma(work.s3_46, work.s8_1009, s8_1710);
  const double s8_1712 = mbgen::fma(work.s8_829, work.s8_1031, s8_1711);
  const double s8_1713 = mbgen::fma(projection.Rz[19], work.s8_1050, s8_1712);
  const double s8_1714 = mbgen::fma(projection.Rz[16], work.s8_1065, s8_1713);
  const double s8_1715 = mbgen::fma(projection.Rz[13], work.s8_1082, s8_1714);
  const double s8_1716 = mbgen::fma(work.s8_827, work.s8_1153, s8_1715);
  const double s8_1717 = mbgen::fnma(work.s8_828, work.s8_1159, s8_1716);
  const double s8_1718 = mbgen::fma(work.s3_37, work.s8_1183, s8_1717);
  const double s8_1719 = mbgen::fma(work.s3_28, work.s8_1173, s8_1718);
  const double s8_1720 = mbgen::fma(work.s8_826, work.s8_1195, s8_1719);
  const double s8_1721 = mbgen::fma(projection.Rz[1], work.s8_1219, s8_1720);
  const double s8_1722 = mbgen::fma(work.s8_1341, work.s8_1341, s8_1699);
  const double s8_1723 = mbgen::fnma(1.5, s8_1414, s8_1721);
  const double s8_1724 = mbgen::fnma(0.3333333333333333, s8_1722, s8_1723);
  const double s8_1725 = mbgen::fma(work.s8_1577, work.s8_1577, s8_1703);
  work.s8_1726 = mbgen::fnma(1.1666666666666667, s8_1725, s8_1724);
  const double s8_1727 = mbgen::fma(work.s8_1269, s8_1271, work.s8_1243*s8_1245);
  const double s8_1728 = mbgen::fma(work.s8_1262, s8_1265, s8_1727);
  const double s8_1729 = mbgen::fma(work.s8_1326, s8_1328, s8_1728);
  const double s8_1730 = mbgen::fma(work.s8_1348, s8_1350, s8_1729);
  const double s8_1731 = mbgen::fma(work.s8_1467, s8_1469, work.s8_1459*s8_1461);
  const double s8_1732 = mbgen::fma(work.s8_1481, s8_1484, s8_1731);
  const double s8_1733 = mbgen::fma(work.s8_1535, s8_1537, s8_1732);
  const double s8_1734 = mbgen::fma(work.s8_1545, s8_1547, s8_1733);
  const double s8_1735 = projection.Rz[40]*work.s8_850;
  const double s8_1736 = mbgen::fma(projection.Rz[37], work.s8_875, s8_1735);
  const double s8_1737 = mbgen::fma(projection.Rz[34], work.s8_897, s8_1736);
  const double s8_1738 = mbgen::fma(projection.Rz[31], work.s8_921, s8_1737);
  const double s8_1739 = mbgen::fma(work.s8_831, work.s8_999, s8_1738);
  const double s8_1740 = mbgen::fma(work.s8_830, work.s8_993, s8_1739);
  const double s8_1741 = mbgen::fma(work.s3_55, work.s8_1022, s8_1740);
  const double s8_1742 = mbgen::fma(work.s3_46, work.s8_1012, s8_1741);
  const double s8_1743 = mbgen::fma(work.s8_829, work.s8_1035, s8_1742);
  const double s8_1744 = mbgen::fma(projection.Rz[19], work.s8_1051, s8_1743);
  const double s8_1745 = mbgen::fma(projection.Rz[16], work.s8_1066, s8_1744);
  const double s8_1746 = mbgen::fma(projection.Rz[13], work.s8_1083, s8_1745);
  const double s8_1747 = mbgen::fma(work.s8_827, work.s8_1155, s8_1746);
  const double s8_1748 = mbgen::fnma(work.s8_828, work.s8_1161, s8_1747);
  const double s8_1749 = mbgen::fma(work.s3_37, s8_1186, s8_1748);
  const double s8_1750 = mbgen::fma(work.s3_28, work.s8_1176, s8_1749);
  const double s8_1751 = mbgen::fma(work.s8_826, s8_1199, s8_1750);
  const double s8_1752 = mbgen::fma(projection.Rz[1], s8_1220, s8_1751);
  const double s8_1753 = mbgen::fma(work.s8_1341, s8_1344, s8_1730);
  const double s8_1754 = mbgen::fnma(1.5, s8_1416, s8_1752);
  const double s8_1755 = mbgen::fnma(0.3333333333333333, s8_1753, s8_1754);
  const double s8_1756 = mbgen::fma(work.s8_1577, s8_1580, s8_1734);
  work.s8_1757 = mbgen::fnma(1.1666666666666667, s8_1756, s8_1755);
  const double s8_1758 = mbgen::fma(s8_1271, s8_1271, s8_1245*s8_1245);
  const double s8_1759 = mbgen::fma(s8_1328, s8_1328, mbgen::fma(s8_1265, s8_1265, s8_1758));
  const double s8_1760 = mbgen::fma(s8_1469, s8_1469, s8_1461*s8_1461);
  const double s8_1761 = mbgen::fma(s8_1537, s8_1537, mbgen::fma(s8_1484, s8_1484, s8_1760));
  const double s8_1762 = projection.Rz[41]*work.s8_850;
  const double s8_1763 = mbgen::fma(projection.Rz[38], work.s8_875, s8_1762);
  const double s8_1764 = mbgen::fma(projection.Rz[35], work.s8_897, s8_1763);
  const double s8_1765 = mbgen::fma(projection.Rz[32], work.s8_921, s8_1764);
  const double s8_1766 = mbgen::fma(work.s8_837, work.s8_999, s8_1765);
  const double s8_1767 = mbgen::fma(work.s8_836, work.s8_993, s8_1766);
  const double s8_1768 = mbgen::fma(work.s3_58, work.s8_1022, s8_1767);
  const double s8_1769 = mbgen::fma(work.s3_49, work.s8_1012, s8_1768);
  const double s8_1770 = mbgen::fma(work.s8_835, work.s8_1035, s8_1769);
  const double s8_1771 = mbgen::fma(projection.Rz[20], work.s8_1051, s8_1770);
  const double s8_1772 = mbgen::fma(projection.Rz[17], work.s8_1066, s8_1771);
  const double s8_1773 = mbgen::fma(projection.Rz[14], work.s8_1083, s8_1772);
  const double s8_1774 = mbgen::fma(work.s8_833, work.s8_1155, s8_1773);
  const double s8_1775 = mbgen::fnma(work.s8_834, work.s8_1161, s8_1774);
  const double s8_1776 = mbgen::fma(work.s3_40, s8_1186, s8_1775);
  const double s8_1777 = mbgen::fma(work.s3_31, work.s8_1176, s8_1776);
  const double s8_1778 = mbgen::fma(work.s8_832, s8_1199, s8_1777);
  const double s8_1779 = mbgen::fma(projection.Rz[2], s8_1220, s8_1778);
  const double s8_1780 = mbgen::fma(s8_1344, s8_1344, mbgen::fma(s8_1350, s8_1350, s8_1759));
  const double s8_1781 = mbgen::fnma(1.5, s8_1418, s8_1779);
  const double s8_1782 = mbgen::fma(s8_1580, s8_1580, mbgen::fma(s8_1547, s8_1547, s8_1761));
  const double s8_1783 = mbgen::fnma(0.3333333333333333, s8_1780, s8_1781);
  work.s8_1784 = mbgen::fnma(1.1666666666666667, s8_1782, s8_1783);
  const double s8_1785 = s8_1516 - s8_1571;
  const double s8_1786 = mbgen::fms(work.s8_22, work.s8_1538, work.s8_840);
  const double s8_1787 = mbgen::fnma(work.s1_25, work.s6_18, s8_1786);
  const double s8_1788 = mbgen::fma(work.s8_25, work.s8_1522, s8_1787);
  const double s8_1789 = mbgen::fnma(work.s8_21, work.s8_1526, s8_1788);
  const double s8_1790 = mbgen::fma(work.s8_18, s8_1633, s8_1789);
  const double s8_1791 = mbgen::fnma(work.s8_17, s8_1785, s8_1790);
  const double s8_1792 = mbgen::fnma(work.s8_839, s8_1525, s8_1791);
  const double s8_1793 = mbgen::fma(work.s6_59, s8_1529, s8_1792);
  const double s8_1794 = mbgen::fnma(work.s4_17, s8_1570, s8_1793);
  work.s8_1795 = 1.1666666666666667*mbgen::fma(work.s4_8, s8_1571, s8_1794);
  const double s8_1796 = mbgen::fnma(work.s6_59, s8_1521, projection.zdd_star[13]*s8_1515);
  const double s8_1797 = mbgen::fma(work.s6_47, s8_1525, s8_1796);
  const double s8_1798 = mbgen::fnma(zd_bell_crank, s8_1518, s8_1797);
  const double s8_1799 = mbgen::fma(work.s4_6, s8_1570, mbgen::fnma(work.s4_8, s8_1530, s8_1798));
  const double s8_1800 = mbgen::fnma(work.s8_17, s8_1531, s8_1799);
  const double s8_1801 = mbgen::fnma(work.s8_19, s8_1633, s8_1800);
  const double s8_1802 = mbgen::fnma(work.s8_20, work.s8_1526, s8_1801);
  const double s8_1803 = mbgen::fnma(work.s8_22, work.s8_1522, s8_1802);
  work.s8_1804 = 1.1666666666666667*mbgen::fnma(work.s8_26, work.s8_1538, s8_1803);
  const double s8_1805 = mbgen::fma(work.s8_27, work.s8_1526, s8_1353);
  const double s8_1806 = mbgen::fma(work.s8_20, work.s8_1538, s8_1805);
  const double s8_1807 = mbgen::fnma(work.s8_21, work.s8_1522, s8_1806);
  const double s8_1808 = mbgen::fma(work.s8_18, s8_1531, s8_1807);
  const double s8_1809 = mbgen::fma(work.s8_19, s8_1785, s8_1808);
  const double s8_1810 = mbgen::fma(projection.zdd_star[13], s8_1517, s8_1809);
  const double s8_1811 = mbgen::fnma(work.s6_47, s8_1529, s8_1810);
  const double s8_1812 = mbgen::fma(work.s8_839, s8_1521, s8_1811);
  const double s8_1813 = mbgen::fma(zd_bell_crank, s8_1516, s8_1812);
  const double s8_1814 = mbgen::fnma(work.s4_6, s8_1571, s8_1813);
  work.s8_1815 = 1.1666666666666667*mbgen::fma(work.s4_17, s8_1530, s8_1814);
  const double s8_1816 = mbgen::fnma(projection.zdd_star[0], work.s7_101,
      tau[Coordinate::lower_arm_left]);
  const double s8_1817 = mbgen::fnma(work.s7_91, s8_1222, s8_1816);
  const double s8_1818 = mbgen::fma(work.s7_93, s8_1224, s8_1817);
  const double s8_1819 = mbgen::fnma(work.s8_21, s8_1225, s8_1818);
  work.s8_1820 = mbgen::fnma(work.s7_98, work.s8_933, s8_1819);
  const double s8_1821 = mbgen::fnma(projection.zdd_star[4], work.s7_158,
      tau[Coordinate::upper_arm_left]);
  const double s8_1822 = mbgen::fnma(work.s7_148, work.s8_1088, s8_1821);
  const double s8_1823 = mbgen::fma(work.s7_150, work.s8_1090, s8_1822);
  const double s8_1824 = mbgen::fnma(work.s8_21, work.s8_1091, s8_1823);
  work.s8_1825 = mbgen::fnma(work.s7_155, work.s8_933, s8_1824);
  const double s8_1826 = mbgen::fnma(projection.zdd_star[5], work.s7_175,
      tau[Coordinate::arb_front_left]);
  const double s8_1827 = mbgen::fnma(work.s7_163, work.s8_1072, s8_1826);
  const double s8_1828 = mbgen::fma(work.s7_167, work.s8_1075, s8_1827);
  const double s8_1829 = mbgen::fnma(work.s8_20, work.s7_161, s8_1828);
  const double s8_1830 = mbgen::fma(work.s8_21, work.s7_165, s8_1829);
  const double s8_1831 = mbgen::fnma(work.s8_22, work.s8_1076, s8_1830);
  work.s8_1832 = mbgen::fnma(work.s8_49, work.s7_172, s8_1831);
  const double s8_1833 = mbgen::fnma(projection.zdd_star[6], work.s7_188,
      tau[Coordinate::lower_arm_right]);
  const double s8_1834 = mbgen::fnma(work.s7_180, work.s8_1056, s8_1833);
  const double s8_1835 = mbgen::fnma(work.s7_178, work.s8_1058, s8_1834);
  const double s8_1836 = mbgen::fnma(work.s8_21, work.s8_1059, s8_1835);
  work.s8_1837 = mbgen::fnma(work.s7_185, work.s8_933, s8_1836);
  const double s8_1838 = mbgen::fnma(projection.zdd_star[10], work.s7_244,
      tau[Coordinate::upper_arm_right]);
  const double s8_1839 = mbgen::fnma(work.s7_236, work.s8_928, s8_1838);
  const double s8_1840 = mbgen::fnma(work.s7_234, work.s8_931, s8_1839);
  const double s8_1841 = mbgen::fnma(work.s8_21, work.s8_932, s8_1840);
  work.s8_1842 = mbgen::fnma(work.s7_241, work.s8_933, s8_1841);
  const double s8_1843 = mbgen::fnma(projection.zdd_star[11], work.s7_261,
      tau[Coordinate::arb_front_right]);
  const double s8_1844 = mbgen::fma(work.s8_20, work.s7_253, s8_1843);
  const double s8_1845 = mbgen::fma(work.s8_21, work.s7_251, s8_1844);
  const double s8_1846 = mbgen::fma(work.s7_247, work.s8_901, s8_1845);
  const double s8_1847 = mbgen::fma(work.s7_249, work.s8_908, s8_1846);
  const double s8_1848 = mbgen::fnma(work.s8_22, work.s8_909, s8_1847);
  work.s8_1849 = mbgen::fnma(work.s8_49, work.s7_258, s8_1848);
  const double s8_1850 = mbgen::fnma(projection.zdd_star[12], work.s7_270,
      tau[Coordinate::pitman_arm]);
  const double s8_1851 = mbgen::fnma(work.s7_263, work.s8_881, s8_1850);
  const double s8_1852 = mbgen::fma(work.s7_264, work.s8_883, s8_1851);
  const double s8_1853 = mbgen::fnma(work.s8_22, work.s8_884, s8_1852);
  work.s8_1854 = mbgen::fnma(work.s8_49, work.s7_267, s8_1853);
  const double s8_1855 = mbgen::fnma(projection.zdd_star[13], work.s7_286,
      tau[Coordinate::bell_crank]);
  const double s8_1856 = mbgen::fnma(work.s7_273, work.s8_852, s8_1855);
  const double s8_1857 = mbgen::fma(work.s7_278, work.s8_856, s8_1856);
  const double s8_1858 = mbgen::fnma(work.s8_20, work.s8_860, s8_1857);
  work.s8_1859 = mbgen::fnma(work.s7_280, work.s8_861, s8_1858);
  work.s8_1860 = work.s7_16 - work.n_carrier_left_z;
  work.s8_1861 = work.s7_19 - work.n_carrier_left_y;
  work.s8_1862 = work.s7_25 - work.n_carrier_right_z;
  work.s8_1863 = work.s7_28 - work.n_carrier_right_y;
  const double s8_1864 = mbgen::fma(work.s7_22, work.s3_16, work.s7_31*work.s3_22);
  const double s8_1865 = mbgen::fnma(work.s8_837, work.f_carrier_right_y, s8_1864);
  const double s8_1866 = mbgen::fnma(work.s8_836, work.f_carrier_right_z, s8_1865);
  const double s8_1867 = mbgen::fnma(work.s8_835, work.n_carrier_right_x, s8_1866);
  const double s8_1868 = mbgen::fnma(work.s8_833, work.f_carrier_left_z, s8_1867);
  const double s8_1869 = mbgen::fma(work.s8_834, work.f_carrier_left_y, s8_1868);
  const double s8_1870 = mbgen::fnma(work.s8_832, work.n_carrier_left_x, s8_1869);
  const double s8_1871 = mbgen::fnma(s8_1245, work.s8_1292, s8_1870);
  const double s8_1872 = mbgen::fnma(s8_1265, work.s8_1304, s8_1871);
  const double s8_1873 = mbgen::fma(s8_1271, work.s8_1282, s8_1872);
  const double s8_1874 = mbgen::fnma(s8_1328, work.s8_1362, s8_1873);
  const double s8_1875 = mbgen::fnma(s8_1344, work.s8_1383, s8_1874);
  const double s8_1876 = mbgen::fma(s8_1350, work.s8_1371, s8_1875);
  const double s8_1877 = mbgen::fma(s8_1397, work.s8_1437, s8_1876);
  const double s8_1878 = mbgen::fma(s8_1394, work.s8_1431, s8_1877);
  const double s8_1879 = mbgen::fma(s8_1406, work.s8_1424, s8_1878);
  const double s8_1880 = mbgen::fnma(s8_1461, work.s8_1494, s8_1879);
  const double s8_1881 = mbgen::fnma(s8_1469, work.s8_1503, s8_1880);
  const double s8_1882 = mbgen::fnma(s8_1484, work.s8_1514, s8_1881);
  const double s8_1883 = mbgen::fnma(s8_1537, work.s8_1795, s8_1882);
  const double s8_1884 = mbgen::fma(s8_1547, work.s8_1804, s8_1883);
  const double s8_1885 = mbgen::fma(s8_1580, work.s8_1815, s8_1884);
  const double s8_1886 = mbgen::fma(projection.Rz[2], work.s8_1820, s8_1885);
  const double s8_1887 = mbgen::fma(projection.Rz[14], work.s8_1825, s8_1886);
  const double s8_1888 = mbgen::fma(projection.Rz[17], work.s8_1832, s8_1887);
  const double s8_1889 = mbgen::fma(projection.Rz[20], work.s8_1837, s8_1888);
  const double s8_1890 = mbgen::fma(projection.Rz[32], work.s8_1842, s8_1889);
  const double s8_1891 = mbgen::fma(projection.Rz[35], work.s8_1849, s8_1890);
  const double s8_1892 = mbgen::fma(projection.Rz[38], work.s8_1854, s8_1891);
  const double s8_1893 = mbgen::fma(projection.Rz[41], work.s8_1859, s8_1892);
  const double s8_1894 = mbgen::fma(work.s3_31, work.s8_1860, s8_1893);
  const double s8_1895 = mbgen::fma(work.s3_40, work.s8_1861, s8_1894);
  const double s8_1896 = mbgen::fma(work.s3_49, work.s8_1862, s8_1895);
  work.s8_1897 = mbgen::fma(work.s3_58, work.s8_1863, s8_1896);
  const double s8_1898 = work.s8_51 + (work.s7_167 + work.s7_249) - work.s7_278 - work.s7_263;
  work.s8_1899 = 471.925 + s8_1898;
  const double s8_1900 = work.s8_902 + work.s8_1062;
  const double s8_1901 = work.s7_267 + (work.s8_70 + (work.s7_172 + work.s7_258)) - 90.9075;
  const double s8_1902 = mbgen::fnma((-p_pitman_arm_z), work.s8_877, s8_1901);
  const double s8_1903 = mbgen::fnma(p_pitman_arm_x, work.s8_869, s8_1902);
  const double s8_1904 = mbgen::fnma((-p_bell_crank_z), work.s8_855, s8_1903);
  const double s8_1905 = work.s8_1079 + s8_1213 - work.s8_913 - work.s8_1044;
  const double s8_1906 = mbgen::fma(p_lower_arm_left_x, s8_1905, s8_1904);
  const double s8_1907 = mbgen::fnma((-p_rear_axle_tx_z), s8_1900, s8_1906);
  work.s8_1908 = mbgen::fma(p_arb_front_right_x, work.s8_893 + work.s8_1060, s8_1907);
  const double s8_1909 = 11.55 + (work.s7_280 + (work.s8_72 + (work.s7_165 + work.s7_251)));
  const double s8_1910 = mbgen::fma(p_bell_crank_x, work.s7_273, s8_1909);
  const double s8_1911 = work.s8_1052 + (work.s8_916 + (work.s8_1078 + s8_1212));
  const double s8_1912 = mbgen::fma(p_pitman_arm_y, work.s8_877, s8_1910);
  const double s8_1913 = mbgen::fma(p_lower_arm_left_x, s8_1911, s8_1912);
  work.s8_1914 = mbgen::fma(p_carrier_left_rz_y, work.s8_1062 - work.s8_902, s8_1913);
  const double s8_1915 = work.s7_241 + (work.s7_185 + (work.s7_161 + (work.s7_98 + work.s7_155)));
  const double s8_1916 = work.s8_73 + s8_1915 - work.s7_253 - 1.05;
  const double s8_1917 = mbgen::fnma((-p_bell_crank_z), work.s7_273, s8_1916);
  const double s8_1918 = work.s8_913 + work.s8_1079 - work.s8_869;
  const double s8_1919 = mbgen::fma((-p_rear_axle_tx_z), s8_1918, s8_1917);
  const double s8_1920 = mbgen::fma(p_lower_arm_left_y, work.s8_1044 + s8_1213, s8_1919);
  const double s8_1921 = mbgen::fma(p_carrier_left_rz_y, work.s8_1060 - work.s8_893, s8_1920);
  const double s8_1922 = mbgen::fnma((-p_lower_arm_left_z), work.s8_1052 + s8_1212, s8_1921);
  work.s8_1923 = mbgen::fnma((-p_upper_arm_right_z), work.s8_916 + work.s8_1078, s8_1922);
  const double s8_1924 = work.r_carrier_left_aux1_y + work.r_carrier_right_aux1_y;
  const double s8_1925 = work.s7_198 + (work.s8_126 + work.s7_108);
  work.s8_1926 = mbgen::fma(m_carrier_right_2, s8_1924, s8_1925);
  work.s8_1927 = 1580.4 + (work.s7_192 + (work.s8_127 + work.s7_111));
  const double s8_1928 = work.s7_195 + (work.s8_128 + work.s7_105);
  const double s8_1929 = work.r_carrier_left_aux1_z - work.s1_26;
  work.s8_1930 = mbgen::fma(m_carrier_right_2, s8_1929, s8_1928);
  const double s8_1931 = work.s7_213 + (work.s8_447 + work.s7_126);
  const double s8_1932 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_1002, s8_1931);
  const double s8_1933 = mbgen::fnma(work.s1_26, work.s8_1001, s8_1932);
  const double s8_1934 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_1162, s8_1933);
  const double s8_1935 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_1163, s8_1934);
  const double s8_1936 = mbgen::fnma(work.s8_1246, work.s8_1252, s8_1935);
  const double s8_1937 = mbgen::fma(work.s8_1329, work.s8_1333, s8_1936);
  const double s8_1938 = mbgen::fnma(work.s8_1399, work.s8_1400, s8_1937);
  const double s8_1939 = mbgen::fma(work.s8_1447, work.s8_1472, s8_1938);
  work.s8_1940 = mbgen::fnma(work.s8_1522, work.s8_1540, s8_1939);
  const double s8_1941 = work.s7_222 + (work.s8_466 + work.s7_135);
  const double s8_1942 = mbgen::fnma(work.s1_26, work.s8_1000, s8_1941);
  const double s8_1943 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_1164, s8_1942);
  const double s8_1944 = mbgen::fnma(work.s8_1246, work.s8_1253, s8_1943);
  const double s8_1945 = mbgen::fnma(work.s8_1329, work.s8_1331, s8_1944);
  const double s8_1946 = mbgen::fnma(work.s8_1400, work.s8_1403, s8_1945);
  const double s8_1947 = mbgen::fnma(work.s8_1447, work.s8_1473, s8_1946);
  const double s8_1948 = mbgen::fma(work.s8_1522, work.s8_1539, s8_1947);
  work.s8_1949 = mbgen::fma(p_lower_arm_left_x, work.s8_1002 + work.s8_1162, s8_1948);
  const double s8_1950 = work.s7_225 + (work.s8_471 + work.s7_138);
  const double s8_1951 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_1000, s8_1950);
  const double s8_1952 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_1164, s8_1951);
  const double s8_1953 = mbgen::fnma(work.s8_1251, work.s8_1253, s8_1952);
  const double s8_1954 = mbgen::fma(work.s8_1314, work.s8_1331, s8_1953);
  const double s8_1955 = mbgen::fnma(work.s8_1398, work.s8_1403, s8_1954);
  const double s8_1956 = mbgen::fma(work.s8_1471, work.s8_1473, s8_1955);
  const double s8_1957 = mbgen::fma(work.s8_1526, work.s8_1539, s8_1956);
  work.s8_1958 = mbgen::fma(p_lower_arm_left_x, work.s8_1001 + work.s8_1163, s8_1957);
  const double s8_1959 = work.s7_247 + (work.s7_163 + (work.s7_93 + work.s7_150)) - work.s7_264;
  work.s8_1960 = s8_1959 - work.s7_236 - work.s7_180 - work.s8_56 - 64.9;
  result.inertia[8] = mbgen::fnma(1e-12, work.s8_1784, work.s8_1784);
  const double s8_1961 = work.s7_187 + (work.s7_174 + (work.s7_100 + work.s7_157));
  const double s8_1962 = work.s8_75 + (work.s7_269 + (work.s7_260 + (work.s7_243 + s8_1961)));
  const double s8_1963 = 7.380000000000001 + (work.s7_285 + s8_1962 - work.s8_893 - work.s8_1060);
  const double s8_1964 = mbgen::fma(0.8, work.s8_869, s8_1963);
  const double s8_1965 = mbgen::fma(0.56, work.s8_913 - work.s8_1079, s8_1964);
  work.s8_1966 = mbgen::fma(1.24, work.s8_1044 - s8_1213, s8_1965);
  const double s8_1967 = work.s7_186 + (work.s7_156 + (work.s7_99 + work.s8_1078));
  const double s8_1968 = 12.8518 + (work.s7_284 + (work.s7_242 + s8_1967) - work.s8_916);
  work.s8_1969 = mbgen::fma(0.8, s8_1212 - work.s8_1052, s8_1968);
  const double s8_1970 = work.s7_281 + (work.s8_77 + (work.s7_268 + (work.s7_173 + work.s7_259)));
  const double s8_1971 = mbgen::fma(6.5, work.s8_855, 1037.4 + s8_1970);
  work.s8_1972 = mbgen::fma(7.9, s8_1900, mbgen::fma(8.8, work.s8_877, s8_1971));
  const double s8_1973 = work.s7_231 + (work.s8_512 + work.s7_145);
  const double s8_1974 = mbgen::fnma(work.s8_984, work.s8_1002, s8_1973);
  const double s8_1975 = mbgen::fma(work.s8_1162, work.s8_1165, s8_1974);
  const double s8_1976 = mbgen::fnma(work.s8_1246, work.s8_1254, s8_1975);
  const double s8_1977 = mbgen::fnma(work.s8_1329, work.s8_1332, s8_1976);
  const double s8_1978 = mbgen::fnma(work.s8_1400, work.s8_1402, s8_1977);
  const double s8_1979 = mbgen::fnma(work.s8_1447, work.s8_1485, s8_1978);
  work.s8_1980 = mbgen::fnma(work.s8_1522, work.s8_1541, s8_1979);
  const double s8_1981 = work.s7_230 + (work.s8_516 + work.s7_141);
  const double s8_1982 = mbgen::fma(work.s8_1001, work.s8_1036, s8_1981);
  const double s8_1983 = mbgen::fma(work.s8_1163, work.s8_1166, s8_1982);
  const double s8_1984 = mbgen::fnma(work.s8_1251, work.s8_1252, s8_1983);
  const double s8_1985 = mbgen::fnma(work.s8_1314, work.s8_1333, s8_1984);
  const double s8_1986 = mbgen::fnma(work.s8_1398, work.s8_1399, s8_1985);
  const double s8_1987 = mbgen::fnma(work.s8_1471, work.s8_1472, s8_1986);
  work.s8_1988 = mbgen::fnma(work.s8_1526, work.s8_1540, s8_1987);
  work.s8_1989 = work.s8_1000 + work.s8_1164;
  work.s8_1990 = work.s8_520 + work.s7_144;
}

/// Part 5 of compute_chosen_accelerations: step 8: elimination from the leaves to the root (63),
/// upper_ball_left .. tie_rod_right; step 8: elimination from the leaves to the root (63); step 9:
/// accelerations from the root to the leaves (63), (62).
[[gnu::noinline]] void compute_chosen_accelerations_5(const State& state, const double* tau,
    const Projection& projection, ChosenAccelerationsWork& __restrict work,
    ChosenAccelerations& __restrict result) noexcept {
  // --- step 8: elimination from the leaves to the root (63), upper_ball_left .. tie_rod_right,
  // continued ---
  const double s8_1991 = mbgen::fnma(work.s8_1247, work.s8_1253, work.s7_227 + work.s8_1990);
  const double s8_1992 = mbgen::fnma(work.s8_1330, work.s8_1331, s8_1991);
  const double s8_1993 = mbgen::fnma(work.s8_1401, work.s8_1403, s8_1992);
  const double s8_1994 = mbgen::fnma(work.s8_1470, work.s8_1473, s8_1993);
  const double s8_1995 = mbgen::fnma(work.s8_1538, work.s8_1539, s8_1994);
  const double s8_1996 = mbgen::fma(7.2, work.s8_1989, s8_1995);
  const double s8_1997 = 1.0/work.s8_1784;
  const double s8_1998 = work.s8_1757*s8_1997;
  const double s8_1999 = mbgen::fnma(work.s8_1757, s8_1998, work.s8_1726);
  result.inertia[7] = mbgen::fnma(1e-12, work.s8_1726, s8_1999);
  const double s8_2000 = work.s8_1695*s8_1997;
  const double s8_2001 = mbgen::fma(work.s8_1267, work.s8_1269, work.s8_1241*work.s8_1243);
  const double s8_2002 = mbgen::fma(work.s8_1259, work.s8_1262, s8_2001);
  const double s8_2003 = mbgen::fma(work.s8_1324, work.s8_1326, s8_2002);
  const double s8_2004 = mbgen::fma(work.s8_1346, work.s8_1348, s8_2003);
  const double s8_2005 = mbgen::fma(work.s8_1465, work.s8_1467, work.s8_1457*work.s8_1459);
  const double s8_2006 = mbgen::fma(work.s8_1478, work.s8_1481, s8_2005);
  const double s8_2007 = mbgen::fma(work.s8_1533, work.s8_1535, s8_2006);
  const double s8_2008 = mbgen::fma(work.s8_1543, work.s8_1545, s8_2007);
  const double s8_2009 = projection.Rz[39]*work.s8_849;
  const double s8_2010 = mbgen::fma(projection.Rz[36], work.s8_874, s8_2009);
  const double s8_2011 = mbgen::fma(projection.Rz[33], work.s8_896, s8_2010);
  const double s8_2012 = mbgen::fma(projection.Rz[30], work.s8_920, s8_2011);
  const double s8_2013 = mbgen::fma(work.s8_825, work.s8_997, s8_2012);
  const double s8_2014 = mbgen::fma(work.s8_824, work.s8_991, s8_2013);
  const double s8_2015 = mbgen::fma(work.s3_52, work.s8_1019, s8_2014);
  const double s8_2016 = mbgen::fma(work.s3_43, work.s8_1009, s8_2015);
  const double s8_2017 = mbgen::fma(work.s8_823, work.s8_1031, s8_2016);
  const double s8_2018 = mbgen::fma(projection.Rz[18], work.s8_1050, s8_2017);
  const double s8_2019 = mbgen::fma(projection.Rz[15], work.s8_1065, s8_2018);
  const double s8_2020 = mbgen::fma(projection.Rz[12], work.s8_1082, s8_2019);
  const double s8_2021 = mbgen::fma(work.s8_821, work.s8_1153, s8_2020);
  const double s8_2022 = mbgen::fnma(work.s8_822, work.s8_1159, s8_2021);
  const double s8_2023 = mbgen::fma(work.s3_34, work.s8_1183, s8_2022);
  const double s8_2024 = mbgen::fma(work.s3_25, work.s8_1173, s8_2023);
  const double s8_2025 = mbgen::fma(work.s8_820, work.s8_1195, s8_2024);
  const double s8_2026 = mbgen::fma(projection.Rz[0], work.s8_1219, s8_2025);
  const double s8_2027 = mbgen::fnma(1.5, work.s8_1410, s8_2026);
  const double s8_2028 = mbgen::fma(work.s8_1338, work.s8_1341, s8_2004);
  const double s8_2029 = mbgen::fnma(work.s8_1695, s8_1998, s8_2027);
  const double s8_2030 = mbgen::fnma(0.3333333333333333, s8_2028, s8_2029);
  const double s8_2031 = mbgen::fma(work.s8_1574, work.s8_1577, s8_2008);
  const double s8_2032 = mbgen::fnma(1.1666666666666667, s8_2031, s8_2030);
  const double s8_2033 = 1.0/s8_1999;
  const double s8_2034 = s8_2032*s8_2033;
  const double s8_2035 = mbgen::fnma(work.s8_1695, s8_2000, work.s8_1664);
  const double s8_2036 = mbgen::fnma(s8_2032, s8_2034, s8_2035);
  result.inertia[6] = mbgen::fnma(1e-12, work.s8_1664, s8_2036);
  const double s8_2037 = work.s8_986 + mbgen::fma(projection.Rz[16], work.s7_163, work.s8_1146);
  const double s8_2038 = work.s8_889 + s8_2037 - work.s8_842 - work.s8_865;
  const double s8_2039 = mbgen::fnma(work.s8_1149, s8_1998, s8_2038);
  const double s8_2040 = work.s8_985 + mbgen::fma(projection.Rz[15], work.s7_163, work.s8_1145);
  const double s8_2041 = work.s8_888 + s8_2040 - work.s8_841 - work.s8_863;
  const double s8_2042 = mbgen::fnma(work.s8_1149, s8_2000, s8_2041);
  const double s8_2043 = mbgen::fnma(s8_2034, s8_2039, s8_2042);
  const double s8_2044 = 1.0/s8_2036;
  const double s8_2045 = s8_2043*s8_2044;
  const double s8_2046 = mbgen::fma(projection.Rz[1], work.s7_91, work.s8_1153);
  const double s8_2047 = work.s8_1038 + mbgen::fma(projection.Rz[13], work.s7_148, s8_2046);
  const double s8_2048 = mbgen::fma(projection.Rz[31], work.s7_234, work.s8_991 + s8_2047);
  const double s8_2049 = work.s8_864 + s8_2048 - work.s8_886;
  const double s8_2050 = mbgen::fnma(projection.Rz[16], work.s7_167, s8_2049);
  const double s8_2051 = mbgen::fnma(work.s8_1206, s8_1998, s8_2050);
  const double s8_2052 = mbgen::fma(projection.Rz[0], work.s7_91, work.s8_1151);
  const double s8_2053 = work.s8_1037 + mbgen::fma(projection.Rz[12], work.s7_148, s8_2052);
  const double s8_2054 = mbgen::fma(projection.Rz[30], work.s7_234, work.s8_989 + s8_2053);
  const double s8_2055 = work.s8_862 + s8_2054 - work.s8_885;
  const double s8_2056 = mbgen::fnma(projection.Rz[15], work.s7_167, s8_2055);
  const double s8_2057 = mbgen::fnma(work.s8_1206, s8_2000, s8_2056);
  const double s8_2058 = mbgen::fnma(s8_2034, s8_2051, s8_2057);
  const double s8_2059 = s8_2044*s8_2058;
  const double s8_2060 = work.s8_1041 + work.s8_1159;
  const double s8_2061 = work.s8_911 + (work.s8_997 + s8_2060) - work.s8_845;
  const double s8_2062 = mbgen::fnma(projection.Rz[13], work.s7_150, s8_2061);
  const double s8_2063 = mbgen::fnma(projection.Rz[1], work.s7_93, s8_2062);
  const double s8_2064 = mbgen::fnma(work.s8_1210, s8_1998, s8_2063);
  const double s8_2065 = work.s8_1040 + work.s8_1157;
  const double s8_2066 = work.s8_910 + (work.s8_995 + s8_2065) - work.s8_844;
  const double s8_2067 = mbgen::fnma(projection.Rz[12], work.s7_150, s8_2066);
  const double s8_2068 = mbgen::fnma(projection.Rz[0], work.s7_93, s8_2067);
  const double s8_2069 = mbgen::fnma(work.s8_1210, s8_2000, s8_2068);
  const double s8_2070 = mbgen::fnma(s8_2034, s8_2064, s8_2069);
  const double s8_2071 = s8_2044*s8_2070;
  const double s8_2072 = work.s8_874 + (work.s8_1019 + (work.s8_1065 + work.s8_1183));
  const double s8_2073 = mbgen::fma((-p_bell_crank_z), work.s8_842, work.s8_896 + s8_2072);
  const double s8_2074 = mbgen::fma((-p_pitman_arm_z), work.s8_865, s8_2073);
  const double s8_2075 = mbgen::fnma(p_pitman_arm_x, work.s8_864, s8_2074);
  const double s8_2076 = mbgen::fnma(work.s1_26, work.s8_986, s8_2075);
  const double s8_2077 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_1146, s8_2076);
  const double s8_2078 = mbgen::fnma(work.s8_1254, work.s8_1269, s8_2077);
  const double s8_2079 = mbgen::fnma(work.s8_1253, work.s8_1262, s8_2078);
  const double s8_2080 = mbgen::fnma(work.s8_1332, work.s8_1348, s8_2079);
  const double s8_2081 = mbgen::fnma(work.s8_1331, work.s8_1341, s8_2080);
  const double s8_2082 = mbgen::fma(work.s8_1393, work.s8_1403, s8_2081);
  const double s8_2083 = mbgen::fnma(work.s8_1402, work.s8_1405, s8_2082);
  const double s8_2084 = mbgen::fnma(work.s8_1467, work.s8_1485, s8_2083);
  const double s8_2085 = mbgen::fma(work.s8_1459, work.s8_1473, s8_2084);
  const double s8_2086 = mbgen::fma(work.s8_1541, work.s8_1545, s8_2085);
  const double s8_2087 = mbgen::fnma(work.s8_1535, work.s8_1539, s8_2086);
  const double s8_2088 = work.s8_991 + mbgen::fma(projection.Rz[31], work.s7_234, s8_2047);
  const double s8_2089 = mbgen::fnma(work.s8_1569, s8_1998, s8_2087);
  const double s8_2090 = mbgen::fma(projection.Rz[16], work.s7_163, work.s8_889);
  const double s8_2091 = mbgen::fnma(p_lower_arm_left_x, s8_2088, s8_2089);
  const double s8_2092 = mbgen::fma(projection.Rz[16], work.s7_167, work.s8_886);
  const double s8_2093 = mbgen::fnma((-p_rear_axle_tx_z), s8_2090, s8_2091);
  const double s8_2094 = mbgen::fma(p_arb_front_right_x, s8_2092, s8_2093);
  const double s8_2095 = work.s8_873 + (work.s8_1016 + (work.s8_1064 + work.s8_1180));
  const double s8_2096 = mbgen::fma((-p_bell_crank_z), work.s8_841, work.s8_895 + s8_2095);
  const double s8_2097 = mbgen::fma((-p_pitman_arm_z), work.s8_863, s8_2096);
  const double s8_2098 = mbgen::fnma(p_pitman_arm_x, work.s8_862, s8_2097);
  const double s8_2099 = mbgen::fnma(work.s1_26, work.s8_985, s8_2098);
  const double s8_2100 = mbgen::fma(work.r_carrier_left_aux1_z, work.s8_1145, s8_2099);
  const double s8_2101 = mbgen::fnma(work.s8_1254, work.s8_1267, s8_2100);
  const double s8_2102 = mbgen::fnma(work.s8_1253, work.s8_1259, s8_2101);
  const double s8_2103 = mbgen::fnma(work.s8_1332, work.s8_1346, s8_2102);
  const double s8_2104 = mbgen::fnma(work.s8_1331, work.s8_1338, s8_2103);
  const double s8_2105 = mbgen::fma(work.s8_1392, work.s8_1403, s8_2104);
  const double s8_2106 = mbgen::fnma(work.s8_1402, work.s8_1404, s8_2105);
  const double s8_2107 = mbgen::fnma(work.s8_1465, work.s8_1485, s8_2106);
  const double s8_2108 = mbgen::fma(work.s8_1457, work.s8_1473, s8_2107);
  const double s8_2109 = mbgen::fma(work.s8_1541, work.s8_1543, s8_2108);
  const double s8_2110 = mbgen::fnma(work.s8_1533, work.s8_1539, s8_2109);
  const double s8_2111 = mbgen::fnma(work.s8_1569, s8_2000, s8_2110);
  const double s8_2112 = work.s8_989 + mbgen::fma(projection.Rz[30], work.s7_234, s8_2053);
  const double s8_2113 = mbgen::fnma(s8_2034, s8_2094, s8_2111);
  const double s8_2114 = mbgen::fma(projection.Rz[15], work.s7_163, work.s8_888);
  const double s8_2115 = mbgen::fnma(p_lower_arm_left_x, s8_2112, s8_2113);
  const double s8_2116 = mbgen::fma(projection.Rz[15], work.s7_167, work.s8_885);
  const double s8_2117 = mbgen::fnma((-p_rear_axle_tx_z), s8_2114, s8_2115);
  const double s8_2118 = mbgen::fma(p_arb_front_right_x, s8_2116, s8_2117);
  const double s8_2119 = s8_2044*s8_2118;
  const double s8_2120 = mbgen::fma(projection.Rz[13], work.s7_148, work.s8_864);
  const double s8_2121 = work.s8_1050 + (work.s8_1082 + (work.s8_1195 + work.s8_1219));
  const double s8_2122 = work.s8_1031 + (work.s8_920 + s8_2121);
  const double s8_2123 = mbgen::fnma((-p_bell_crank_z), work.s8_845, s8_2122);
  const double s8_2124 = mbgen::fnma(projection.Rz[34], work.s7_251, s8_2123);
  const double s8_2125 = mbgen::fma(work.s1_26, work.s8_997, s8_2124);
  const double s8_2126 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_991, s8_2125);
  const double s8_2127 = mbgen::fnma(projection.Rz[16], work.s7_165, s8_2126);
  const double s8_2128 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_1153, s8_2127);
  const double s8_2129 = mbgen::fnma(work.r_carrier_left_aux1_z, work.s8_1159, s8_2128);
  const double s8_2130 = mbgen::fma(work.s8_1252, work.s8_1262, s8_2129);
  const double s8_2131 = mbgen::fnma(work.s8_1243, work.s8_1254, s8_2130);
  const double s8_2132 = mbgen::fnma(work.s8_1333, work.s8_1341, s8_2131);
  const double s8_2133 = mbgen::fnma(work.s8_1326, work.s8_1332, s8_2132);
  const double s8_2134 = mbgen::fma(work.s8_1396, work.s8_1402, s8_2133);
  const double s8_2135 = mbgen::fnma(work.s8_1393, work.s8_1399, s8_2134);
  const double s8_2136 = mbgen::fma(work.s8_1481, work.s8_1485, s8_2135);
  const double s8_2137 = mbgen::fma(work.s8_1459, work.s8_1472, s8_2136);
  const double s8_2138 = mbgen::fnma(work.s8_1535, work.s8_1540, s8_2137);
  const double s8_2139 = mbgen::fnma(work.s8_1541, work.s8_1577, s8_2138);
  const double s8_2140 = mbgen::fnma(projection.Rz[31], work.s7_234, s8_2120);
  const double s8_2141 = mbgen::fnma(work.s8_1632, s8_1998, s8_2139);
  const double s8_2142 = mbgen::fms(projection.Rz[1], work.s7_91, work.s8_1038);
  const double s8_2143 = mbgen::fma((-p_rear_axle_tx_z), s8_2140, s8_2141);
  const double s8_2144 = mbgen::fnma(projection.Rz[16], work.s7_167, work.s8_886);
  const double s8_2145 = mbgen::fma(p_lower_arm_left_y, s8_2142, s8_2143);
  const double s8_2146 = mbgen::fnma(projection.Rz[1], work.s7_93, work.s8_1041);
  const double s8_2147 = mbgen::fma(p_carrier_left_rz_y, s8_2144, s8_2145);
  const double s8_2148 = mbgen::fnma(projection.Rz[13], work.s7_150, work.s8_911);
  const double s8_2149 = mbgen::fma((-p_lower_arm_left_z), s8_2146, s8_2147);
  const double s8_2150 = mbgen::fma((-p_upper_arm_right_z), s8_2148, s8_2149);
  const double s8_2151 = mbgen::fma(projection.Rz[12], work.s7_148, work.s8_862);
  const double s8_2152 = work.s8_1049 + (work.s8_1081 + (work.s8_1191 + work.s8_1218));
  const double s8_2153 = work.s8_1027 + (work.s8_919 + s8_2152);
  const double s8_2154 = mbgen::fnma((-p_bell_crank_z), work.s8_844, s8_2153);
  const double s8_2155 = mbgen::fnma(projection.Rz[33], work.s7_251, s8_2154);
  const double s8_2156 = mbgen::fma(work.s1_26, work.s8_995, s8_2155);
  const double s8_2157 = mbgen::fma(work.r_carrier_right_aux1_y, work.s8_989, s8_2156);
  const double s8_2158 = mbgen::fnma(projection.Rz[15], work.s7_165, s8_2157);
  const double s8_2159 = mbgen::fma(work.r_carrier_left_aux1_y, work.s8_1151, s8_2158);
  const double s8_2160 = mbgen::fnma(work.r_carrier_left_aux1_z, work.s8_1157, s8_2159);
  const double s8_2161 = mbgen::fma(work.s8_1252, work.s8_1259, s8_2160);
  const double s8_2162 = mbgen::fnma(work.s8_1241, work.s8_1254, s8_2161);
  const double s8_2163 = mbgen::fnma(work.s8_1333, work.s8_1338, s8_2162);
  const double s8_2164 = mbgen::fnma(work.s8_1324, work.s8_1332, s8_2163);
  const double s8_2165 = mbgen::fma(work.s8_1395, work.s8_1402, s8_2164);
  const double s8_2166 = mbgen::fnma(work.s8_1392, work.s8_1399, s8_2165);
  const double s8_2167 = mbgen::fma(work.s8_1478, work.s8_1485, s8_2166);
  const double s8_2168 = mbgen::fma(work.s8_1457, work.s8_1472, s8_2167);
  const double s8_2169 = mbgen::fnma(work.s8_1533, work.s8_1540, s8_2168);
  const double s8_2170 = mbgen::fnma(work.s8_1541, work.s8_1574, s8_2169);
  const double s8_2171 = mbgen::fnma(work.s8_1632, s8_2000, s8_2170);
  const double s8_2172 = mbgen::fnma(projection.Rz[30], work.s7_234, s8_2151);
  const double s8_2173 = mbgen::fnma(s8_2034, s8_2150, s8_2171);
  const double s8_2174 = mbgen::fms(projection.Rz[0], work.s7_91, work.s8_1037);
  const double s8_2175 = mbgen::fma((-p_rear_axle_tx_z), s8_2172, s8_2173);
  const double s8_2176 = mbgen::fnma(projection.Rz[15], work.s7_167, work.s8_885);
  const double s8_2177 = mbgen::fma(p_lower_arm_left_y, s8_2174, s8_2175);
  const double s8_2178 = mbgen::fnma(projection.Rz[0], work.s7_93, work.s8_1040);
  const double s8_2179 = mbgen::fma(p_carrier_left_rz_y, s8_2176, s8_2177);
  const double s8_2180 = mbgen::fnma(projection.Rz[12], work.s7_150, work.s8_910);
  const double s8_2181 = mbgen::fma((-p_lower_arm_left_z), s8_2178, s8_2179);
  const double s8_2182 = mbgen::fma((-p_upper_arm_right_z), s8_2180, s8_2181);
  const double s8_2183 = s8_2044*s8_2182;
  const double s8_2184 = work.s8_997 + (work.s8_911 + s8_2060);
  const double s8_2185 = mbgen::fnma(projection.Rz[13], work.s7_150, s8_2184);
  const double s8_2186 = work.s8_1009 + (work.s8_849 + work.s8_1173);
  const double s8_2187 = mbgen::fnma(p_bell_crank_x, work.s8_845, s8_2186);
  const double s8_2188 = mbgen::fma(p_pitman_arm_y, work.s8_865, s8_2187);
  const double s8_2189 = mbgen::fma(projection.Rz[34], work.s7_253, s8_2188);
  const double s8_2190 = mbgen::fnma(work.r_carrier_right_aux1_y, work.s8_986, s8_2189);
  const double s8_2191 = mbgen::fnma(projection.Rz[16], work.s7_161, s8_2190);
  const double s8_2192 = mbgen::fnma(work.r_carrier_left_aux1_y, work.s8_1146, s8_2191);
  const double s8_2193 = mbgen::fma(work.s8_1252, work.s8_1269, s8_2192);
  const double s8_2194 = mbgen::fma(work.s8_1243, work.s8_1253, s8_2193);
  const double s8_2195 = mbgen::fma(work.s8_1326, work.s8_1331, s8_2194);
  const double s8_2196 = mbgen::fnma(work.s8_1333, work.s8_1348, s8_2195);
  const double s8_2197 = mbgen::fma(work.s8_1399, work.s8_1405, s8_2196);
  const double s8_2198 = mbgen::fnma(work.s8_1396, work.s8_1403, s8_2197);
  const double s8_2199 = mbgen::fnma(work.s8_1473, work.s8_1481, s8_2198);
  const double s8_2200 = mbgen::fnma(work.s8_1467, work.s8_1472, s8_2199);
  const double s8_2201 = mbgen::fnma(work.s8_1539, work.s8_1577, s8_2200);
  const double s8_2202 = mbgen::fnma(work.s8_1540, work.s8_1545, s8_2201);
  const double s8_2203 = mbgen::fnma(projection.Rz[1], work.s7_93, s8_2185);
  const double s8_2204 = mbgen::fnma(work.s8_1603, s8_1998, s8_2202);
  const double s8_2205 = mbgen::fnma(projection.Rz[16], work.s7_163, work.s8_889);
  const double s8_2206 = mbgen::fma(p_lower_arm_left_x, s8_2203, s8_2204);
  const double s8_2207 = mbgen::fma(p_carrier_left_rz_y, s8_2205, s8_2206);
  const double s8_2208 = work.s8_995 + (work.s8_910 + s8_2065);
  const double s8_2209 = mbgen::fnma(projection.Rz[12], work.s7_150, s8_2208);
  const double s8_2210 = work.s8_1006 + (work.s8_848 + work.s8_1170);
  const double s8_2211 = mbgen::fnma(p_bell_crank_x, work.s8_844, s8_2210);
  const double s8_2212 = mbgen::fma(p_pitman_arm_y, work.s8_863, s8_2211);
  const double s8_2213 = mbgen::fma(projection.Rz[33], work.s7_253, s8_2212);
  const double s8_2214 = mbgen::fnma(work.r_carrier_right_aux1_y, work.s8_985, s8_2213);
  const double s8_2215 = mbgen::fnma(projection.Rz[15], work.s7_161, s8_2214);
  const double s8_2216 = mbgen::fnma(work.r_carrier_left_aux1_y, work.s8_1145, s8_2215);
  const double s8_2217 = mbgen::fma(work.s8_1252, work.s8_1267, s8_2216);
  const double s8_2218 = mbgen::fma(work.s8_1241, work.s8_1253, s8_2217);
  const double s8_2219 = mbgen::fma(work.s8_1324, work.s8_1331, s8_2218);
  const double s8_2220 = mbgen::fnma(work.s8_1333, work.s8_1346, s8_2219);
  const double s8_2221 = mbgen::fma(work.s8_1399, work.s8_1404, s8_2220);
  const double s8_2222 = mbgen::fnma(work.s8_1395, work.s8_1403, s8_2221);
  const double s8_2223 = mbgen::fnma(work.s8_1473, work.s8_1478, s8_2222);
  const double s8_2224 = mbgen::fnma(work.s8_1465, work.s8_1472, s8_2223);
  const double s8_2225 = mbgen::fnma(work.s8_1539, work.s8_1574, s8_2224);
  const double s8_2226 = mbgen::fnma(work.s8_1540, work.s8_1543, s8_2225);
  const double s8_2227 = mbgen::fnma(work.s8_1603, s8_2000, s8_2226);
  const double s8_2228 = mbgen::fnma(projection.Rz[0], work.s7_93, s8_2209);
  const double s8_2229 = mbgen::fnma(s8_2034, s8_2207, s8_2227);
  const double s8_2230 = mbgen::fnma(projection.Rz[15], work.s7_163, work.s8_888);
  const double s8_2231 = mbgen::fma(p_lower_arm_left_x, s8_2228, s8_2229);
  const double s8_2232 = mbgen::fma(p_carrier_left_rz_y, s8_2230, s8_2231);
  const double s8_2233 = s8_2044*s8_2232;
  const double s8_2234 = s8_2033*s8_2039;
  const double s8_2235 = s8_2033*s8_2051;
  const double s8_2236 = s8_2033*s8_2064;
  const double s8_2237 = s8_2033*s8_2094;
  const double s8_2238 = s8_2033*s8_2150;
  const double s8_2239 = s8_2033*s8_2207;
  const double s8_2240 = work.s8_1149*s8_1997;
  const double s8_2241 = work.s8_1206*s8_1997;
  const double s8_2242 = work.s8_1210*s8_1997;
  const double s8_2243 = work.s8_1569*s8_1997;
  const double s8_2244 = work.s8_1632*s8_1997;
  const double s8_2245 = work.s8_1603*s8_1997;
  const double s8_2246 = mbgen::fma(work.s7_22, work.s3_14, work.s7_31*work.s3_20);
  const double s8_2247 = mbgen::fnma(work.s8_831, work.f_carrier_right_y, s8_2246);
  const double s8_2248 = mbgen::fnma(work.s8_830, work.f_carrier_right_z, s8_2247);
  const double s8_2249 = mbgen::fnma(work.s8_829, work.n_carrier_right_x, s8_2248);
  const double s8_2250 = mbgen::fnma(work.s8_827, work.f_carrier_left_z, s8_2249);
  const double s8_2251 = mbgen::fma(work.s8_828, work.f_carrier_left_y, s8_2250);
  const double s8_2252 = mbgen::fnma(work.s8_826, work.n_carrier_left_x, s8_2251);
  const double s8_2253 = mbgen::fnma(work.s8_1243, work.s8_1292, s8_2252);
  const double s8_2254 = mbgen::fnma(work.s8_1262, work.s8_1304, s8_2253);
  const double s8_2255 = mbgen::fma(work.s8_1269, work.s8_1282, s8_2254);
  const double s8_2256 = mbgen::fnma(work.s8_1326, work.s8_1362, s8_2255);
  const double s8_2257 = mbgen::fnma(work.s8_1341, work.s8_1383, s8_2256);
  const double s8_2258 = mbgen::fma(work.s8_1348, work.s8_1371, s8_2257);
  const double s8_2259 = mbgen::fma(work.s8_1396, work.s8_1437, s8_2258);
  const double s8_2260 = mbgen::fma(work.s8_1393, work.s8_1431, s8_2259);
  const double s8_2261 = mbgen::fma(work.s8_1405, work.s8_1424, s8_2260);
  const double s8_2262 = mbgen::fnma(work.s8_1459, work.s8_1494, s8_2261);
  const double s8_2263 = mbgen::fnma(work.s8_1467, work.s8_1503, s8_2262);
  const double s8_2264 = mbgen::fnma(work.s8_1481, work.s8_1514, s8_2263);
  const double s8_2265 = mbgen::fnma(work.s8_1535, work.s8_1795, s8_2264);
  const double s8_2266 = mbgen::fma(work.s8_1545, work.s8_1804, s8_2265);
  const double s8_2267 = mbgen::fma(work.s8_1577, work.s8_1815, s8_2266);
  const double s8_2268 = mbgen::fnma(work.s8_1897, s8_1998, s8_2267);
  const double s8_2269 = mbgen::fma(projection.Rz[1], work.s8_1820, s8_2268);
  const double s8_2270 = mbgen::fma(projection.Rz[13], work.s8_1825, s8_2269);
  const double s8_2271 = mbgen::fma(projection.Rz[16], work.s8_1832, s8_2270);
  const double s8_2272 = mbgen::fma(projection.Rz[19], work.s8_1837, s8_2271);
  const double s8_2273 = mbgen::fma(projection.Rz[31], work.s8_1842, s8_2272);
  const double s8_2274 = mbgen::fma(projection.Rz[34], work.s8_1849, s8_2273);
  const double s8_2275 = mbgen::fma(projection.Rz[37], work.s8_1854, s8_2274);
  const double s8_2276 = mbgen::fma(projection.Rz[40], work.s8_1859, s8_2275);
  const double s8_2277 = mbgen::fma(work.s3_28, work.s8_1860, s8_2276);
  const double s8_2278 = mbgen::fma(work.s3_37, work.s8_1861, s8_2277);
  const double s8_2279 = mbgen::fma(work.s3_46, work.s8_1862, s8_2278);
  const double s8_2280 = mbgen::fma(work.s3_55, work.s8_1863, s8_2279);
  const double s8_2281 = mbgen::fma(work.s7_22, work.s3_12, work.s7_31*work.s3_18);
  const double s8_2282 = mbgen::fnma(work.s8_825, work.f_carrier_right_y, s8_2281);
  const double s8_2283 = mbgen::fnma(work.s8_824, work.f_carrier_right_z, s8_2282);
  const double s8_2284 = mbgen::fnma(work.s8_823, work.n_carrier_right_x, s8_2283);
  const double s8_2285 = mbgen::fnma(work.s8_821, work.f_carrier_left_z, s8_2284);
  const double s8_2286 = mbgen::fma(work.s8_822, work.f_carrier_left_y, s8_2285);
  const double s8_2287 = mbgen::fnma(work.s8_820, work.n_carrier_left_x, s8_2286);
  const double s8_2288 = mbgen::fnma(work.s8_1241, work.s8_1292, s8_2287);
  const double s8_2289 = mbgen::fnma(work.s8_1259, work.s8_1304, s8_2288);
  const double s8_2290 = mbgen::fma(work.s8_1267, work.s8_1282, s8_2289);
  const double s8_2291 = mbgen::fnma(work.s8_1324, work.s8_1362, s8_2290);
  const double s8_2292 = mbgen::fnma(work.s8_1338, work.s8_1383, s8_2291);
  const double s8_2293 = mbgen::fma(work.s8_1346, work.s8_1371, s8_2292);
  const double s8_2294 = mbgen::fma(work.s8_1395, work.s8_1437, s8_2293);
  const double s8_2295 = mbgen::fma(work.s8_1392, work.s8_1431, s8_2294);
  const double s8_2296 = mbgen::fma(work.s8_1404, work.s8_1424, s8_2295);
  const double s8_2297 = mbgen::fnma(work.s8_1457, work.s8_1494, s8_2296);
  const double s8_2298 = mbgen::fnma(work.s8_1465, work.s8_1503, s8_2297);
  const double s8_2299 = mbgen::fnma(work.s8_1478, work.s8_1514, s8_2298);
  const double s8_2300 = mbgen::fnma(work.s8_1533, work.s8_1795, s8_2299);
  const double s8_2301 = mbgen::fma(work.s8_1543, work.s8_1804, s8_2300);
  const double s8_2302 = mbgen::fma(work.s8_1574, work.s8_1815, s8_2301);
  const double s8_2303 = mbgen::fnma(work.s8_1897, s8_2000, s8_2302);
  const double s8_2304 = mbgen::fnma(s8_2034, s8_2280, s8_2303);
  const double s8_2305 = mbgen::fma(projection.Rz[0], work.s8_1820, s8_2304);
  const double s8_2306 = mbgen::fma(projection.Rz[12], work.s8_1825, s8_2305);
  const double s8_2307 = mbgen::fma(projection.Rz[15], work.s8_1832, s8_2306);
  const double s8_2308 = mbgen::fma(projection.Rz[18], work.s8_1837, s8_2307);
  const double s8_2309 = mbgen::fma(projection.Rz[30], work.s8_1842, s8_2308);
  const double s8_2310 = mbgen::fma(projection.Rz[33], work.s8_1849, s8_2309);
  const double s8_2311 = mbgen::fma(projection.Rz[36], work.s8_1854, s8_2310);
  const double s8_2312 = mbgen::fma(projection.Rz[39], work.s8_1859, s8_2311);
  const double s8_2313 = mbgen::fma(work.s3_25, work.s8_1860, s8_2312);
  const double s8_2314 = mbgen::fma(work.s3_34, work.s8_1861, s8_2313);
  const double s8_2315 = mbgen::fma(work.s3_43, work.s8_1862, s8_2314);
  const double s8_2316 = mbgen::fma(work.s3_52, work.s8_1863, s8_2315);
  const double s8_2317 = work.s8_1053 + (work.s8_1069 + work.f_carrier_left_y);
  const double s8_2318 = work.s8_701 + (work.s8_924 + (work.f_carrier_right_y + s8_2317));
  const double s8_2319 = work.s8_900 + s8_2318 - work.s8_859 - work.s8_876 - work.s8_1089;
  const double s8_2320 = mbgen::fma(work.s8_1897, s8_2242, s8_2319 - work.s8_1223);
  const double s8_2321 = mbgen::fma(s8_2071, s8_2316, mbgen::fma(s8_2236, s8_2280, s8_2320));
  const double s8_2322 = work.s8_1071 + (work.s8_1086 + (work.f_carrier_left_x + work.s8_1216));
  const double s8_2323 = work.s8_923 + (work.f_carrier_right_x + (work.s8_1047 + s8_2322));
  const double s8_2324 = work.s8_858 + (work.s8_705 + (work.s8_879 + (work.s8_904 + s8_2323)));
  const double s8_2325 = mbgen::fma(s8_2234, s8_2280, mbgen::fma(work.s8_1897, s8_2240, s8_2324));
  const double s8_2326 = mbgen::fma(s8_2045, s8_2316, s8_2325);
  const double s8_2327 = work.s8_1054 + (work.s8_1087 + (work.f_carrier_left_z + work.s8_1221));
  const double s8_2328 = work.s8_878 + (work.s8_925 + (work.f_carrier_right_z + s8_2327));
  const double s8_2329 = work.s8_857 + (work.s8_709 + s8_2328) - work.s8_906 - work.s8_1074;
  const double s8_2330 = mbgen::fma(s8_2235, s8_2280, mbgen::fma(work.s8_1897, s8_2241, s8_2329));
  const double s8_2331 = mbgen::fma(s8_2059, s8_2316, s8_2330);
  const double s8_2332 = work.s8_900 + (work.s8_878 + (work.s8_1069 + work.s8_1087));
  const double s8_2333 = mbgen::fma(projection.zdd_star[0], work.s7_101, work.n_carrier_left_x);
  const double s8_2334 = mbgen::fma(projection.zdd_star[4], work.s7_158, s8_2333);
  const double s8_2335 = mbgen::fma(projection.zdd_star[6], work.s7_188, s8_2334);
  const double s8_2336 = work.s8_730 + (work.n_carrier_right_x + s8_2335);
  const double s8_2337 = mbgen::fma(projection.zdd_star[10], work.s7_244, s8_2336);
  const double s8_2338 = mbgen::fma(s8_2238, s8_2280, mbgen::fma(work.s8_1897, s8_2244, s8_2337));
  const double s8_2339 = mbgen::fma(work.s7_284, work.s8_854, s8_2338);
  const double s8_2340 = mbgen::fma(work.s7_280, work.s8_853, s8_2339);
  const double s8_2341 = mbgen::fnma((-p_bell_crank_z), work.s8_859, s8_2340);
  const double s8_2342 = mbgen::fnma(work.s7_267, work.s8_870, s8_2341);
  const double s8_2343 = mbgen::fnma(work.s7_269, work.s8_871, s8_2342);
  const double s8_2344 = mbgen::fma(work.s7_253, work.s8_892, s8_2343);
  const double s8_2345 = mbgen::fnma(projection.zdd_star[11], work.s7_251, s8_2344);
  const double s8_2346 = mbgen::fnma(work.s7_258, work.s8_899, s8_2345);
  const double s8_2347 = mbgen::fnma(work.s7_260, work.s8_898, s8_2346);
  const double s8_2348 = mbgen::fma(work.s1_26, work.f_carrier_right_y, s8_2347);
  const double s8_2349 = mbgen::fma(work.r_carrier_right_aux1_y, work.f_carrier_right_z, s8_2348);
  const double s8_2350 = mbgen::fnma(projection.zdd_star[5], work.s7_165, s8_2349);
  const double s8_2351 = mbgen::fnma(work.s7_161, work.s8_1061, s8_2350);
  const double s8_2352 = mbgen::fnma(work.s7_172, work.s8_1068, s8_2351);
  const double s8_2353 = mbgen::fnma(work.s7_174, work.s8_1067, s8_2352);
  const double s8_2354 = mbgen::fma(work.r_carrier_left_aux1_y, work.f_carrier_left_z, s8_2353);
  const double s8_2355 = mbgen::fnma(work.r_carrier_left_aux1_z, work.f_carrier_left_y, s8_2354);
  const double s8_2356 = mbgen::fma(work.s8_1246, work.s8_1292, s8_2355);
  const double s8_2357 = mbgen::fnma(work.s8_1251, work.s8_1304, s8_2356);
  const double s8_2358 = mbgen::fma(work.s8_1329, work.s8_1362, s8_2357);
  const double s8_2359 = mbgen::fma(work.s8_1314, work.s8_1383, s8_2358);
  const double s8_2360 = mbgen::fma(work.s8_1400, work.s8_1437, s8_2359);
  const double s8_2361 = mbgen::fnma(work.s8_1398, work.s8_1431, s8_2360);
  const double s8_2362 = mbgen::fnma(work.s8_1471, work.s8_1494, s8_2361);
  const double s8_2363 = mbgen::fnma(work.s8_1447, work.s8_1514, s8_2362);
  const double s8_2364 = mbgen::fma(work.s8_1526, work.s8_1795, s8_2363);
  const double s8_2365 = mbgen::fnma(work.s8_1522, work.s8_1815, s8_2364);
  const double s8_2366 = mbgen::fma(s8_2183, s8_2316, s8_2365);
  const double s8_2367 = mbgen::fma((-p_rear_axle_tx_z), s8_2332 - work.s8_925, s8_2366);
  const double s8_2368 = work.s8_1221 - work.s8_876 - work.s8_1054;
  const double s8_2369 = mbgen::fma(p_lower_arm_left_y, s8_2368, s8_2367);
  const double s8_2370 = mbgen::fma(p_carrier_left_rz_y, work.s8_906 - work.s8_1074, s8_2369);
  const double s8_2371 = mbgen::fma((-p_lower_arm_left_z), work.s8_1053 - work.s8_1223, s8_2370);
  const double s8_2372 = mbgen::fma((-p_upper_arm_right_z), work.s8_924 - work.s8_1089, s8_2371);
  const double s8_2373 = work.s8_924 + (work.s8_1053 + work.f_carrier_left_y);
  const double s8_2374 = work.s8_752 + (work.n_carrier_right_z + work.n_carrier_left_z);
  const double s8_2375 = mbgen::fma(projection.zdd_star[13], work.s7_286, s8_2374);
  const double s8_2376 = mbgen::fma(s8_2239, s8_2280, mbgen::fma(work.s8_1897, s8_2245, s8_2375));
  const double s8_2377 = mbgen::fnma(p_bell_crank_x, work.s8_859, s8_2376);
  const double s8_2378 = mbgen::fma(work.s7_268, work.s8_870, s8_2377);
  const double s8_2379 = mbgen::fma(work.s7_267, work.s8_871, s8_2378);
  const double s8_2380 = mbgen::fnma(p_pitman_arm_x, work.s8_876, s8_2379);
  const double s8_2381 = mbgen::fma(projection.zdd_star[11], work.s7_253, s8_2380);
  const double s8_2382 = mbgen::fma(work.s7_251, work.s8_892, s8_2381);
  const double s8_2383 = mbgen::fma(work.s7_259, work.s8_899, s8_2382);
  const double s8_2384 = mbgen::fma(work.s7_258, work.s8_898, s8_2383);
  const double s8_2385 = mbgen::fnma(work.s7_241, work.s8_917, s8_2384);
  const double s8_2386 = mbgen::fnma(work.s7_242, work.s8_922, s8_2385);
  const double s8_2387 = mbgen::fnma(work.r_carrier_right_aux1_y, work.f_carrier_right_x, s8_2386);
  const double s8_2388 = mbgen::fnma(work.s7_185, work.s8_1045, s8_2387);
  const double s8_2389 = mbgen::fnma(work.s7_186, work.s8_1046, s8_2388);
  const double s8_2390 = mbgen::fma(work.s7_173, work.s8_1068, s8_2389);
  const double s8_2391 = mbgen::fma(work.s7_172, work.s8_1067, s8_2390);
  const double s8_2392 = mbgen::fnma(projection.zdd_star[5], work.s7_161, s8_2391);
  const double s8_2393 = mbgen::fma(work.s7_165, work.s8_1061, s8_2392);
  const double s8_2394 = mbgen::fnma(work.s7_156, work.s8_1084, s8_2393);
  const double s8_2395 = mbgen::fnma(work.s7_155, work.s8_1085, s8_2394);
  const double s8_2396 = mbgen::fnma(work.r_carrier_left_aux1_y, work.f_carrier_left_x, s8_2395);
  const double s8_2397 = mbgen::fnma(work.s7_99, work.s8_1214, s8_2396);
  const double s8_2398 = mbgen::fnma(work.s7_98, work.s8_1215, s8_2397);
  const double s8_2399 = mbgen::fma(work.s8_1251, work.s8_1282, s8_2398);
  const double s8_2400 = mbgen::fnma(work.s8_1247, work.s8_1292, s8_2399);
  const double s8_2401 = mbgen::fnma(work.s8_1330, work.s8_1362, s8_2400);
  const double s8_2402 = mbgen::fnma(work.s8_1314, work.s8_1371, s8_2401);
  const double s8_2403 = mbgen::fma(work.s8_1398, work.s8_1424, s8_2402);
  const double s8_2404 = mbgen::fnma(work.s8_1401, work.s8_1437, s8_2403);
  const double s8_2405 = mbgen::fma(work.s8_1471, work.s8_1503, s8_2404);
  const double s8_2406 = mbgen::fma(work.s8_1470, work.s8_1514, s8_2405);
  const double s8_2407 = mbgen::fnma(work.s8_1538, work.s8_1815, s8_2406);
  const double s8_2408 = mbgen::fnma(work.s8_1526, work.s8_1804, s8_2407);
  const double s8_2409 = work.f_carrier_right_y + s8_2373 - work.s8_1089 - work.s8_1223;
  const double s8_2410 = mbgen::fma(s8_2233, s8_2316, s8_2408);
  const double s8_2411 = mbgen::fma(p_lower_arm_left_x, s8_2409, s8_2410);
  const double s8_2412 = work.s8_923 - work.s8_879 - work.s8_1086;
  const double s8_2413 = mbgen::fma((-p_rear_axle_tx_z), s8_2412, s8_2411);
  const double s8_2414 = mbgen::fma(p_lower_arm_left_y, work.s8_1047 - work.s8_1216, s8_2413);
  const double s8_2415 = mbgen::fma(p_carrier_left_rz_y, work.s8_904 - work.s8_1071, s8_2414);
  const double s8_2416 = mbgen::fma(p_arb_front_right_x, work.s8_900 + work.s8_1069, s8_2415);
  const double s8_2417 = mbgen::fma(projection.zdd_star[5], work.s7_175, work.n_carrier_left_y);
  const double s8_2418 = work.n_carrier_right_y + s8_2417;
  const double s8_2419 = work.s8_768 + mbgen::fma(projection.zdd_star[11], work.s7_261, s8_2418);
  const double s8_2420 = mbgen::fma(projection.zdd_star[12], work.s7_270, s8_2419);
  const double s8_2421 = mbgen::fma(s8_2237, s8_2280, mbgen::fma(work.s8_1897, s8_2243, s8_2420));
  const double s8_2422 = mbgen::fnma((-p_pitman_arm_z), work.s8_879, s8_2421);
  const double s8_2423 = mbgen::fnma(p_pitman_arm_x, work.s8_878, s8_2422);
  const double s8_2424 = mbgen::fnma(work.s7_281, work.s8_853, s8_2423);
  const double s8_2425 = mbgen::fnma(work.s7_280, work.s8_854, s8_2424);
  const double s8_2426 = mbgen::fnma((-p_bell_crank_z), work.s8_858, s8_2425);
  const double s8_2427 = mbgen::fnma(p_bell_crank_x, work.s8_857, s8_2426);
  const double s8_2428 = mbgen::fma(work.s7_241, work.s8_922, s8_2427);
  const double s8_2429 = mbgen::fma(work.s7_243, work.s8_917, s8_2428);
  const double s8_2430 = mbgen::fnma(work.s1_26, work.f_carrier_right_x, s8_2429);
  const double s8_2431 = mbgen::fma(work.s7_185, work.s8_1046, s8_2430);
  const double s8_2432 = mbgen::fma(work.s7_187, work.s8_1045, s8_2431);
  const double s8_2433 = mbgen::fma(work.s7_155, work.s8_1084, s8_2432);
  const double s8_2434 = mbgen::fma(work.s7_157, work.s8_1085, s8_2433);
  const double s8_2435 = mbgen::fma(work.r_carrier_left_aux1_z, work.f_carrier_left_x, s8_2434);
  const double s8_2436 = mbgen::fma(work.s7_98, work.s8_1214, s8_2435);
  const double s8_2437 = mbgen::fma(work.s7_100, work.s8_1215, s8_2436);
  const double s8_2438 = mbgen::fma(work.s8_1247, work.s8_1304, s8_2437);
  const double s8_2439 = mbgen::fnma(work.s8_1246, work.s8_1282, s8_2438);
  const double s8_2440 = mbgen::fma(work.s8_1330, work.s8_1383, s8_2439);
  const double s8_2441 = mbgen::fnma(work.s8_1329, work.s8_1371, s8_2440);
  const double s8_2442 = mbgen::fma(work.s8_1401, work.s8_1431, s8_2441);
  const double s8_2443 = mbgen::fnma(work.s8_1400, work.s8_1424, s8_2442);
  const double s8_2444 = mbgen::fnma(work.s8_1470, work.s8_1494, s8_2443);
  const double s8_2445 = mbgen::fma(work.s8_1447, work.s8_1503, s8_2444);
  const double s8_2446 = mbgen::fma(work.s8_1538, work.s8_1795, s8_2445);
  const double s8_2447 = mbgen::fma(work.s8_1522, work.s8_1804, s8_2446);
  const double s8_2448 = work.f_carrier_right_z + (work.s8_925 + s8_2327);
  const double s8_2449 = mbgen::fma(s8_2119, s8_2316, s8_2447);
  const double s8_2450 = mbgen::fnma(p_lower_arm_left_x, s8_2448, s8_2449);
  const double s8_2451 = mbgen::fnma((-p_lower_arm_left_z), work.s8_1047 + work.s8_1216, s8_2450);
  const double s8_2452 = mbgen::fnma((-p_rear_axle_tx_z), work.s8_904 + work.s8_1071, s8_2451);
  const double s8_2453 = mbgen::fnma((-p_upper_arm_right_z), work.s8_923 + work.s8_1086, s8_2452);
  const double s8_2454 = mbgen::fma(p_arb_front_right_x, work.s8_906 + work.s8_1074, s8_2453);
  const double s8_2455 = mbgen::fma(s8_2064, s8_2236, mbgen::fma(s8_2070, s8_2071, work.s8_769));
  const double s8_2456 = mbgen::fma(work.s8_1210, s8_2242, s8_2455);
  const double s8_2457 = mbgen::fma(s8_2064, s8_2234, mbgen::fma(s8_2045, s8_2070, work.s8_770));
  const double s8_2458 = mbgen::fma(work.s8_1210, s8_2240, s8_2457);
  const double s8_2459 = mbgen::fma(s8_2039, s8_2234, mbgen::fma(s8_2043, s8_2045, work.s8_771));
  const double s8_2460 = mbgen::fma(work.s8_1149, s8_2240, s8_2459);
  const double s8_2461 = mbgen::fma(s8_2051, s8_2236, mbgen::fma(s8_2058, s8_2071, work.s8_772));
  const double s8_2462 = mbgen::fma(work.s8_1206, s8_2242, s8_2461);
  const double s8_2463 = mbgen::fma(s8_2051, s8_2234, mbgen::fma(s8_2045, s8_2058, work.s8_773));
  const double s8_2464 = mbgen::fma(work.s8_1206, s8_2240, s8_2463);
  const double s8_2465 = mbgen::fma(s8_2051, s8_2235, mbgen::fma(s8_2058, s8_2059, work.s8_774));
  const double s8_2466 = mbgen::fma(work.s8_1206, s8_2241, s8_2465);
  const double s8_2467 = mbgen::fma(s8_2150, s8_2236, mbgen::fma(s8_2071, s8_2182, work.s8_775));
  const double s8_2468 = mbgen::fma(work.s8_1632, s8_2242, s8_2467);
  const double s8_2469 = mbgen::fma(s8_2150, s8_2234, mbgen::fma(s8_2045, s8_2182, work.s8_776));
  const double s8_2470 = mbgen::fma(work.s8_1632, s8_2240, s8_2469);
  const double s8_2471 = mbgen::fma(s8_2150, s8_2235, mbgen::fma(s8_2059, s8_2182, work.s8_777));
  const double s8_2472 = mbgen::fma(work.s8_1632, s8_2241, s8_2471);
  const double s8_2473 = mbgen::fma(s8_2150, s8_2238, mbgen::fma(s8_2182, s8_2183, work.s8_778));
  const double s8_2474 = mbgen::fma(work.s8_1632, s8_2244, s8_2473);
  const double s8_2475 = mbgen::fma(s8_2207, s8_2236, mbgen::fma(s8_2071, s8_2232, work.s8_779));
  const double s8_2476 = mbgen::fma(work.s8_1603, s8_2242, s8_2475);
  const double s8_2477 = mbgen::fma(s8_2207, s8_2234, mbgen::fma(s8_2045, s8_2232, work.s8_780));
  const double s8_2478 = mbgen::fma(work.s8_1603, s8_2240, s8_2477);
  const double s8_2479 = mbgen::fma(s8_2207, s8_2235, mbgen::fma(s8_2059, s8_2232, work.s8_781));
  const double s8_2480 = mbgen::fma(work.s8_1603, s8_2241, s8_2479);
  const double s8_2481 = mbgen::fma(s8_2207, s8_2238, mbgen::fma(s8_2183, s8_2232, work.s8_782));
  const double s8_2482 = mbgen::fma(work.s8_1603, s8_2244, s8_2481);
  const double s8_2483 = mbgen::fma(s8_2207, s8_2239, mbgen::fma(s8_2232, s8_2233, work.s8_783));
  const double s8_2484 = mbgen::fma(work.s8_1603, s8_2245, s8_2483);
  const double s8_2485 = mbgen::fma(s8_2207, s8_2237, mbgen::fma(s8_2119, s8_2232, work.s8_784));
  const double s8_2486 = mbgen::fma(work.s8_1603, s8_2243, s8_2485);
  const double s8_2487 = mbgen::fma(s8_2094, s8_2236, mbgen::fma(s8_2071, s8_2118, work.s8_785));
  const double s8_2488 = mbgen::fma(work.s8_1569, s8_2242, s8_2487);
  const double s8_2489 = mbgen::fma(s8_2094, s8_2234, mbgen::fma(s8_2045, s8_2118, work.s8_786));
  const double s8_2490 = mbgen::fma(work.s8_1569, s8_2240, s8_2489);
  const double s8_2491 = mbgen::fma(s8_2094, s8_2235, mbgen::fma(s8_2059, s8_2118, work.s8_787));
  const double s8_2492 = mbgen::fma(work.s8_1569, s8_2241, s8_2491);
  const double s8_2493 = mbgen::fma(s8_2094, s8_2238, mbgen::fma(s8_2118, s8_2183, work.s8_788));
  const double s8_2494 = mbgen::fma(work.s8_1569, s8_2244, s8_2493);
  const double s8_2495 = mbgen::fma(s8_2094, s8_2237, mbgen::fma(s8_2118, s8_2119, work.s8_789));
  const double s8_2496 = mbgen::fma(work.s8_1569, s8_2243, s8_2495);
  // operations: 1747 add, 1692 multiply, 3 divide

  // --- step 8: elimination from the leaves to the root (63), continued ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s8_2497 = h_chassis_y + work.s8_1201;
  const double s8_2498 = K_chassis_xz + work.s8_1908;
  const double s8_2499 = K_chassis_xy + work.s8_1914;
  const double s8_2500 = h_chassis_z + work.s8_1960;
  const double s8_2501 = work.s8_1899 - (-h_chassis_x);
  const double s8_2502 = K_chassis_zz + work.s8_1966;
  const double s8_2503 = K_chassis_yy + work.s8_1969;
  const double s8_2504 = K_chassis_xx + work.s8_1972;
  const double s8_2505 = 15306.0 - s8_2460;
  const double s8_2506 = work.s8_1926 + s8_2497;
  const double s8_2507 = s8_2478 + s8_2506;
  const double s8_2508 = work.s8_1980 + s8_2502;
  const double s8_2509 = work.s8_1988 + s8_2503;
  const double s8_2510 = s8_1996 + s8_2504;
  const double s8_2511 = s8_2509 + (s8_2508 + s8_2510);
  const double pivot_chassis_rx = s8_2511 - s8_2508 - s8_2484;
  const double s8_2512 = 1.0/pivot_chassis_rx;
  const double s8_2513 = s8_2507*s8_2512;
  const double s8_2514 = work.s8_1930 + s8_2500;
  const double s8_2515 = s8_2486 + (work.s8_1923 + work.s8_1940);
  const double s8_2516 = s8_2512*s8_2515;
  const double s8_2517 = mbgen::fnma(s8_2507, s8_2516, s8_2514 - s8_2490);
  const double s8_2518 = s8_2511 - s8_2509 - s8_2496;
  const double pivot_chassis_ry = mbgen::fnma(s8_2515, s8_2516, s8_2518);
  const double s8_2519 = 1.0/pivot_chassis_ry;
  const double s8_2520 = s8_2517*s8_2519;
  const double s8_2521 = s8_2482 + (work.s8_1949 + s8_2498);
  const double s8_2522 = mbgen::fma(s8_2516, s8_2521, s8_2494 + (work.s8_1958 + s8_2499));
  const double s8_2523 = s8_2519*s8_2522;
  const double s8_2524 = s8_2512*s8_2521;
  const double s8_2525 = mbgen::fnma(s8_2507, s8_2524, mbgen::fms(s8_2517, s8_2523, s8_2470));
  const double s8_2526 = s8_2511 - s8_2510 - s8_2474;
  const double pivot_chassis_rz = mbgen::fnma(s8_2522, s8_2523, mbgen::fnma(s8_2521, s8_2524,
      s8_2526));
  const double s8_2527 = 1.0/pivot_chassis_rz;
  const double s8_2528 = s8_2525*s8_2527;
  const double s8_2529 = work.s8_1927 + s8_2501;
  const double s8_2530 = mbgen::fma(s8_2480, s8_2516, s8_2492 + s8_2529);
  const double s8_2531 = s8_2519*s8_2530;
  const double s8_2532 = s8_2480*s8_2512;
  const double s8_2533 = mbgen::fnma(s8_2480, s8_2524, s8_2506 - s8_2472);
  const double s8_2534 = mbgen::fnma(s8_2523, s8_2530, s8_2533);
  const double s8_2535 = s8_2527*s8_2534;
  const double s8_2536 = mbgen::fnma(s8_2507, s8_2532, mbgen::fms(s8_2517, s8_2531, s8_2464));
  const double s8_2537 = mbgen::fnma(s8_2525, s8_2535, s8_2536);
  const double s8_2538 = 15306.0 - s8_2466;
  const double s8_2539 = mbgen::fnma(s8_2530, s8_2531, mbgen::fnma(s8_2480, s8_2532, s8_2538));
  const double pivot_chassis_tz = mbgen::fnma(s8_2534, s8_2535, s8_2539);
  const double s8_2540 = 1.0/pivot_chassis_tz;
  const double s8_2541 = s8_2537*s8_2540;
  const double s8_2542 = s8_2529 - s8_2476;
  const double s8_2543 = s8_2512*s8_2542;
  const double s8_2544 = mbgen::fms(s8_2516, s8_2542, s8_2488);
  const double s8_2545 = s8_2519*s8_2544;
  const double s8_2546 = mbgen::fms(s8_2524, s8_2542, s8_2468) - s8_2514;
  const double s8_2547 = mbgen::fma(s8_2523, s8_2544, s8_2546);
  const double s8_2548 = s8_2527*s8_2547;
  const double s8_2549 = mbgen::fma(s8_2531, s8_2544, mbgen::fms(s8_2532, s8_2542, s8_2462));
  const double s8_2550 = mbgen::fnma(s8_2535, s8_2547, s8_2549);
  const double s8_2551 = s8_2540*s8_2550;
  const double s8_2552 = mbgen::fnma(s8_2517, s8_2545, mbgen::fms(s8_2507, s8_2543, s8_2458));
  const double s8_2553 = mbgen::fnma(s8_2537, s8_2551, mbgen::fnma(s8_2525, s8_2548, s8_2552));
  const double s8_2554 = 15306.0 - s8_2456;
  const double s8_2555 = mbgen::fnma(s8_2544, s8_2545, mbgen::fnma(s8_2542, s8_2543, s8_2554));
  const double pivot_chassis_ty = mbgen::fnma(s8_2550, s8_2551, mbgen::fnma(s8_2547, s8_2548,
      s8_2555));
  const double s8_2556 = 1.0/pivot_chassis_ty;
  const double s8_2557 = s8_2553*s8_2556;
  const double s8_2558 = mbgen::fnma(s8_2517, s8_2520, mbgen::fnma(s8_2507, s8_2513, s8_2505));
  const double s8_2559 = mbgen::fnma(s8_2537, s8_2541, mbgen::fnma(s8_2525, s8_2528, s8_2558));
  const double pivot_chassis_tx = mbgen::fnma(s8_2553, s8_2557, s8_2559);
  result.inertia[5] = mbgen::fnma(1e-12, pivot_chassis_rx, pivot_chassis_rx);
  const double s8_2560 = mbgen::fnma(work.s8_21, s8_2498, work.s7_13 - s8_2416);
  const double s8_2561 = mbgen::fma(work.s8_22, work.s8_1923, s8_2560);
  const double s8_2562 = mbgen::fma(work.s8_20, s8_2503 - s8_2504, s8_2561);
  const double s8_2563 = mbgen::fma(s8_2499, work.s8_27 - work.s8_26, s8_2562);
  const double s8_2564 = mbgen::fnma(1e-12, s8_2518, pivot_chassis_ry);
  const double s8_2565 = mbgen::fma(s8_2516, s8_2563, work.s7_11 - s8_2454);
  const double s8_2566 = mbgen::fnma(work.s8_20, work.s8_1923, s8_2565);
  const double s8_2567 = mbgen::fma(work.s8_21, s8_2499, s8_2566);
  const double s8_2568 = mbgen::fma(work.s8_22, s8_2504 - s8_2502, s8_2567);
  const double s8_2569 = mbgen::fma(s8_2498, work.s8_26 - work.s8_25, s8_2568);
  result.inertia[3] = mbgen::fnma(1e-12, s8_2526, pivot_chassis_rz);
  result.inertia[2] = mbgen::fnma(1e-12, s8_2538, pivot_chassis_tz);
  result.inertia[1] = mbgen::fnma(1e-12, s8_2554, pivot_chassis_ty);
  const double s8_2570 = mbgen::fms(tau[Coordinate::chassis_rx], work.s5_31, s8_2372);
  const double s8_2571 = mbgen::fma(s8_2524, s8_2563, mbgen::fma(s8_2523, s8_2569, s8_2570));
  const double s8_2572 = mbgen::fnma(work.s8_22, s8_2499, s8_2571);
  const double s8_2573 = mbgen::fma(work.s8_20, s8_2498, s8_2572);
  const double s8_2574 = mbgen::fma(work.s8_21, s8_2502 - s8_2503, s8_2573);
  const double s8_2575 = mbgen::fma(work.s8_1923, work.s8_25 - work.s8_27, s8_2574);
  const double s8_2576 = mbgen::fma(s8_2531, s8_2569, work.s7_6 - s8_2331);
  const double s8_2577 = mbgen::fnma(work.s8_21, s8_2497, mbgen::fma(s8_2532, s8_2563, s8_2576));
  const double s8_2578 = mbgen::fnma(work.s8_22, s8_2501, s8_2577);
  const double s8_2579 = mbgen::fnma(s8_2535, s8_2575, mbgen::fma(work.s8_25, s8_2500, s8_2578));
  const double s8_2580 = mbgen::fnma(work.s8_20, s8_2501, work.s7_3 - s8_2321);
  const double s8_2581 = mbgen::fnma(work.s8_21, s8_2500, s8_2580);
  const double s8_2582 = mbgen::fnma(s8_2543, s8_2563, mbgen::fma(work.s8_27, s8_2497, s8_2581));
  const double s8_2583 = mbgen::fnma(s8_2548, s8_2575, mbgen::fnma(s8_2545, s8_2569, s8_2582));
  const double s8_2584 = mbgen::fnma(s8_2551, s8_2579, s8_2583);
  const double s8_2585 = mbgen::fma(s8_2513, s8_2563, work.s7_9 - s8_2326);
  const double s8_2586 = mbgen::fnma(work.s8_20, s8_2497, s8_2585);
  const double s8_2587 = mbgen::fnma(work.s8_22, s8_2500, s8_2586);
  const double s8_2588 = mbgen::fnma(s8_2520, s8_2569, mbgen::fma(work.s8_26, s8_2501, s8_2587));
  const double s8_2589 = mbgen::fnma(s8_2541, s8_2579, mbgen::fnma(s8_2528, s8_2575, s8_2588));
  const double s8_2590 = mbgen::fnma(s8_2557, s8_2584, s8_2589);
  result.inertia[0] = mbgen::fnma(1e-12, s8_2505, pivot_chassis_tx);
  const double s8_2591 = 1.0/pivot_chassis_tx;
  // operations: 156 add, 141 multiply, 6 divide

  // --- step 9: accelerations from the root to the leaves (63), (62) ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double a_chassis_x = s8_2590*s8_2591;
  const double a_chassis_y = s8_2556*mbgen::fnma(s8_2553, a_chassis_x, s8_2584);
  const double s9_1 = mbgen::fnma(s8_2537, a_chassis_x, s8_2579);
  const double a_chassis_z = s8_2540*mbgen::fnma(s8_2550, a_chassis_y, s9_1);
  const double s9_2 = mbgen::fnma(s8_2525, a_chassis_x, s8_2575);
  const double s9_3 = mbgen::fnma(s8_2547, a_chassis_y, s9_2);
  const double alpha_chassis_x = s8_2527*mbgen::fnma(s8_2534, a_chassis_z, s9_3);
  const double s9_4 = mbgen::fnma(s8_2517, a_chassis_x, s8_2569);
  const double s9_5 = mbgen::fnma(s8_2544, a_chassis_y, s9_4);
  const double s9_6 = mbgen::fma(s8_2530, a_chassis_z, s9_5);
  const double alpha_chassis_y = s8_2519*mbgen::fma(s8_2522, alpha_chassis_x, s9_6);
  const double s9_7 = mbgen::fma(s8_2507, a_chassis_x, s8_2563);
  const double s9_8 = mbgen::fnma(s8_2542, a_chassis_y, s9_7);
  const double s9_9 = mbgen::fma(s8_2480, a_chassis_z, s9_8);
  const double s9_10 = mbgen::fma(s8_2521, alpha_chassis_x, s9_9);
  const double alpha_chassis_z = s8_2512*mbgen::fma(s8_2515, alpha_chassis_y, s9_10);
  const double s1_1 = work.sines[1];
  const double s9_11 = mbgen::fma((-g_z), s1_1, a_chassis_x);
  const double s9_12 = mbgen::fnma((-g_z), work.R_chassis_z_y, a_chassis_y);
  const double s9_13 = mbgen::fnma((-g_z), work.R_chassis_z_z, a_chassis_z);
  const double s9_14 = mbgen::fma(work.R_chassis_z_z, s9_13, work.R_chassis_z_y*s9_12);
  result.zdd[Coordinate::chassis_tz] = mbgen::fnma(s1_1, s9_11, s9_14);
  const double s9_15 = mbgen::fma(work.R_chassis_aux5_y_x, s9_11, work.R_chassis_y_y*s9_12);
  result.zdd[Coordinate::chassis_ty] = mbgen::fma(work.R_chassis_y_z, s9_13, s9_15);
  const double s9_16 = mbgen::fma(work.R_chassis_aux5_x_x, s9_11, work.R_chassis_x_y*s9_12);
  result.zdd[Coordinate::chassis_tx] = mbgen::fma(work.R_chassis_x_z, s9_13, s9_16);
  result.inertia[4] = mbgen::min(s8_2564, mbgen::fms(work.s5_25, work.s5_25, 1e-12));
  const double zd_chassis_rx = state.zd[Coordinate::chassis_rx];
  const double s9_17 = mbgen::fma(work.s5_1, work.s5_5, alpha_chassis_y);
  const double s9_18 = mbgen::fnma(zd_chassis_rx, work.w_chassis_z, s9_17);
  const double s9_19 = mbgen::fma(zd_chassis_rx, work.w_chassis_y, alpha_chassis_z);
  const double s9_20 = mbgen::fma(work.s5_1, work.s5_3, s9_19);
  result.zdd[Coordinate::chassis_rz] = mbgen::fma(work.s5_28, s9_20, work.s5_27*s9_18);
  result.zdd[Coordinate::chassis_ry] = mbgen::fnma(work.sines[2], s9_20, work.cosines[2]*s9_18);
  const double s9_21 = mbgen::fma(work.s5_2, work.s5_5, alpha_chassis_x);
  const double s9_22 = mbgen::fma(work.s5_30, s9_20, work.s5_29*s9_18);
  result.zdd[Coordinate::chassis_rx] = mbgen::fma(work.s5_31, mbgen::fma(work.s5_3, work.s5_4,
      s9_21), s9_22);
  // bell_crank: bell_crank, revolute, chassis
  const double s9_23 = mbgen::fnma(s8_2070, a_chassis_y, s8_2316);
  const double s9_24 = mbgen::fnma(s8_2043, a_chassis_x, s9_23);
  const double s9_25 = mbgen::fnma(s8_2058, a_chassis_z, s9_24);
  const double s9_26 = mbgen::fnma(s8_2118, alpha_chassis_y, s9_25);
  const double s9_27 = mbgen::fnma(s8_2232, alpha_chassis_z, s9_26);
  const double s9_28 = s8_2044*mbgen::fnma(s8_2182, alpha_chassis_x, s9_27);
  const double s9_29 = mbgen::fnma(s8_2064, a_chassis_y, s8_2280);
  const double s9_30 = mbgen::fnma(s8_2039, a_chassis_x, s9_29);
  const double s9_31 = mbgen::fnma(s8_2051, a_chassis_z, s9_30);
  const double s9_32 = mbgen::fnma(s8_2094, alpha_chassis_y, s9_31);
  const double s9_33 = mbgen::fnma(s8_2207, alpha_chassis_z, s9_32);
  const double s9_34 = mbgen::fnma(s8_2150, alpha_chassis_x, s9_33);
  const double s9_35 = s8_2033*mbgen::fnma(s8_2032, s9_28, s9_34);
  const double s9_36 = mbgen::fnma(work.s8_1210, a_chassis_y, work.s8_1897);
  const double s9_37 = mbgen::fnma(work.s8_1149, a_chassis_x, s9_36);
  const double s9_38 = mbgen::fnma(work.s8_1206, a_chassis_z, s9_37);
  const double s9_39 = mbgen::fnma(work.s8_1569, alpha_chassis_y, s9_38);
  const double s9_40 = mbgen::fnma(work.s8_1603, alpha_chassis_z, s9_39);
  const double s9_41 = mbgen::fnma(work.s8_1632, alpha_chassis_x, s9_40);
  const double s9_42 = mbgen::fnma(work.s8_1695, s9_28, s9_41);
  const double s9_43 = s8_1997*mbgen::fnma(work.s8_1757, s9_35, s9_42);
  const double s9_44 = mbgen::fma(projection.Rz[0], s9_28, projection.zdd_star[0]);
  const double s9_45 = mbgen::fma(projection.Rz[1], s9_35, s9_44);
  result.zdd[Coordinate::lower_arm_left] = mbgen::fma(projection.Rz[2], s9_43, s9_45);
  const double s9_46 = mbgen::fma(projection.Rz[3], s9_28, projection.zdd_star[1]);
  const double s9_47 = mbgen::fma(projection.Rz[4], s9_35, s9_46);
  result.zdd[Coordinate::carrier_left_rz] = mbgen::fma(projection.Rz[5], s9_43, s9_47);
  const double s9_48 = mbgen::fma(projection.Rz[6], s9_28, projection.zdd_star[2]);
  const double s9_49 = mbgen::fma(projection.Rz[7], s9_35, s9_48);
  result.zdd[Coordinate::carrier_left_rx] = mbgen::fma(projection.Rz[8], s9_43, s9_49);
  const double s9_50 = mbgen::fma(projection.Rz[9], s9_28, projection.zdd_star[3]);
  const double s9_51 = mbgen::fma(projection.Rz[10], s9_35, s9_50);
  result.zdd[Coordinate::carrier_left_ry] = mbgen::fma(projection.Rz[11], s9_43, s9_51);
  const double s9_52 = mbgen::fma(projection.Rz[12], s9_28, projection.zdd_star[4]);
  const double s9_53 = mbgen::fma(projection.Rz[13], s9_35, s9_52);
  result.zdd[Coordinate::upper_arm_left] = mbgen::fma(projection.Rz[14], s9_43, s9_53);
  const double s9_54 = mbgen::fma(projection.Rz[15], s9_28, projection.zdd_star[5]);
  const double s9_55 = mbgen::fma(projection.Rz[16], s9_35, s9_54);
  result.zdd[Coordinate::arb_front_left] = mbgen::fma(projection.Rz[17], s9_43, s9_55);
  const double s9_56 = mbgen::fma(projection.Rz[18], s9_28, projection.zdd_star[6]);
  const double s9_57 = mbgen::fma(projection.Rz[19], s9_35, s9_56);
  result.zdd[Coordinate::lower_arm_right] = mbgen::fma(projection.Rz[20], s9_43, s9_57);
  const double s9_58 = mbgen::fma(projection.Rz[21], s9_28, projection.zdd_star[7]);
  const double s9_59 = mbgen::fma(projection.Rz[22], s9_35, s9_58);
  result.zdd[Coordinate::carrier_right_rz] = mbgen::fma(projection.Rz[23], s9_43, s9_59);
  const double s9_60 = mbgen::fma(projection.Rz[24], s9_28, projection.zdd_star[8]);
  const double s9_61 = mbgen::fma(projection.Rz[25], s9_35, s9_60);
  result.zdd[Coordinate::carrier_right_rx] = mbgen::fma(projection.Rz[26], s9_43, s9_61);
  const double s9_62 = mbgen::fma(projection.Rz[27], s9_28, projection.zdd_star[9]);
  const double s9_63 = mbgen::fma(projection.Rz[28], s9_35, s9_62);
  result.zdd[Coordinate::carrier_right_ry] = mbgen::fma(projection.Rz[29], s9_43, s9_63);
  const double s9_64 = mbgen::fma(projection.Rz[30], s9_28, projection.zdd_star[10]);
  const double s9_65 = mbgen::fma(projection.Rz[31], s9_35, s9_64);
  result.zdd[Coordinate::upper_arm_right] = mbgen::fma(projection.Rz[32], s9_43, s9_65);
  const double s9_66 = mbgen::fma(projection.Rz[33], s9_28, projection.zdd_star[11]);
  const double s9_67 = mbgen::fma(projection.Rz[34], s9_35, s9_66);
  result.zdd[Coordinate::arb_front_right] = mbgen::fma(projection.Rz[35], s9_43, s9_67);
  const double s9_68 = mbgen::fma(projection.Rz[36], s9_28, projection.zdd_star[12]);
  const double s9_69 = mbgen::fma(projection.Rz[37], s9_35, s9_68);
  result.zdd[Coordinate::pitman_arm] = mbgen::fma(projection.Rz[38], s9_43, s9_69);
  const double s9_70 = mbgen::fma(projection.Rz[39], s9_28, projection.zdd_star[13]);
  const double s9_71 = mbgen::fma(projection.Rz[40], s9_35, s9_70);
  result.zdd[Coordinate::bell_crank] = mbgen::fma(projection.Rz[41], s9_43, s9_71);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s9_72 = mbgen::fma(work.s8_832, s9_43, work.s8_1112 + alpha_chassis_x);
  const double alpha_carrier_left_x = mbgen::fma(work.s8_820, s9_28, mbgen::fma(work.s8_826, s9_35,
      s9_72));
  const double s9_73 = mbgen::fma(work.s3_40, s9_43, work.s8_1100 + alpha_chassis_y);
  const double alpha_carrier_left_y = mbgen::fma(work.s3_34, s9_28, mbgen::fma(work.s3_37, s9_35,
      s9_73));
  const double s9_74 = mbgen::fma(work.s3_31, s9_43, work.s8_1097 + alpha_chassis_z);
  const double alpha_carrier_left_z = mbgen::fma(work.s3_25, s9_28, mbgen::fma(work.s3_28, s9_35,
      s9_74));
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s9_75 = mbgen::fma(work.s8_835, s9_43, work.s8_955 + alpha_chassis_x);
  const double alpha_carrier_right_x = mbgen::fma(work.s8_823, s9_28, mbgen::fma(work.s8_829, s9_35,
      s9_75));
  const double s9_76 = mbgen::fma(work.s3_58, s9_43, work.s8_942 + alpha_chassis_y);
  const double alpha_carrier_right_y = mbgen::fma(work.s3_52, s9_28, mbgen::fma(work.s3_55, s9_35,
      s9_76));
  const double s9_77 = mbgen::fma(work.s3_49, s9_43, work.s8_939 + alpha_chassis_z);
  const double alpha_carrier_right_z = mbgen::fma(work.s3_43, s9_28, mbgen::fma(work.s3_46, s9_35,
      s9_77));
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s9_78 = 0.09090909090909091*tau[Coordinate::wheel_front_left];
  const double s9_79 = mbgen::fnma(work.R_carrier_left_aux2_y_y, alpha_carrier_left_y, s9_78);
  const double s9_80 = mbgen::fnma(work.R_carrier_left_aux2_z_y, alpha_carrier_left_z, s9_79);
  result.zdd[Coordinate::wheel_front_left] = mbgen::fma(work.s1_12, alpha_carrier_left_x, s9_80);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s9_81 = 0.09090909090909091*tau[Coordinate::wheel_front_right];
  const double s9_82 = mbgen::fnma(work.R_carrier_right_aux2_y_y, alpha_carrier_right_y, s9_81);
  const double s9_83 = mbgen::fnma(work.R_carrier_right_aux2_z_y, alpha_carrier_right_z, s9_82);
  result.zdd[Coordinate::wheel_front_right] = mbgen::fma(work.s1_28, alpha_carrier_right_x, s9_83);
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s9_84 = mbgen::fnma(work.s8_633, a_chassis_y, work.s8_698);
  const double s9_85 = mbgen::fnma(work.s8_636, a_chassis_x, s9_84);
  const double s9_86 = mbgen::fnma(work.s8_639, a_chassis_z, s9_85);
  const double s9_87 = mbgen::fnma(work.s8_680, alpha_chassis_y, s9_86);
  const double s9_88 = mbgen::fnma(work.s8_653, alpha_chassis_x, s9_87);
  const double s9_89 = work.s8_634*mbgen::fnma(work.s8_666, alpha_chassis_z, s9_88);
  const double s9_90 = mbgen::fnma(work.s8_154, a_chassis_y, work.s8_629);
  const double s9_91 = mbgen::fnma(work.s8_133, a_chassis_x, s9_90);
  const double s9_92 = mbgen::fnma(work.s8_138, a_chassis_z, s9_91);
  const double s9_93 = mbgen::fnma(work.s8_508, alpha_chassis_y, s9_92);
  const double s9_94 = mbgen::fnma(work.s8_484, alpha_chassis_x, s9_93);
  const double s9_95 = mbgen::fnma(work.s8_496, alpha_chassis_z, s9_94);
  const double s9_96 = work.s8_630*mbgen::fnma(work.s8_554, s9_89, s9_95);
  const double s9_97 = mbgen::fma(projection.Rz[42], s9_89, projection.zdd_star[14]);
  result.zdd[Coordinate::rear_axle_tx] = mbgen::fma(projection.Rz[43], s9_96, s9_97);
  const double s9_98 = mbgen::fma(projection.Rz[44], s9_89, projection.zdd_star[15]);
  result.zdd[Coordinate::rear_axle_ty] = mbgen::fma(projection.Rz[45], s9_96, s9_98);
  const double s9_99 = mbgen::fma(projection.Rz[46], s9_89, projection.zdd_star[16]);
  result.zdd[Coordinate::rear_axle_tz] = mbgen::fma(projection.Rz[47], s9_96, s9_99);
  const double s9_100 = mbgen::fma(projection.Rz[48], s9_89, projection.zdd_star[17]);
  result.zdd[Coordinate::rear_axle_rz] = mbgen::fma(projection.Rz[49], s9_96, s9_100);
  const double s9_101 = mbgen::fma(projection.Rz[50], s9_89, projection.zdd_star[18]);
  result.zdd[Coordinate::rear_axle_ry] = mbgen::fma(projection.Rz[51], s9_96, s9_101);
  const double s9_102 = mbgen::fma(projection.Rz[52], s9_89, projection.zdd_star[19]);
  result.zdd[Coordinate::rear_axle_rx] = mbgen::fma(projection.Rz[53], s9_96, s9_102);
  const double s9_103 = mbgen::fma(projection.Rz[54], s9_89, projection.zdd_star[20]);
  result.zdd[Coordinate::arb_rear_left] = mbgen::fma(projection.Rz[55], s9_96, s9_103);
  const double s9_104 = mbgen::fma(projection.Rz[56], s9_89, projection.zdd_star[21]);
  result.zdd[Coordinate::arb_rear_right] = mbgen::fma(projection.Rz[57], s9_96, s9_104);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s9_105 = mbgen::fma(work.s3_10, s9_96, work.s8_101 + alpha_chassis_x);
  const double alpha_rear_axle_x = mbgen::fma(work.s3_8, s9_89, s9_105);
  const double s9_106 = mbgen::fma(work.s3_4, s9_96, work.s8_88 + alpha_chassis_y);
  const double alpha_rear_axle_y = mbgen::fma(work.s3_2, s9_89, s9_106);
  const double s9_107 = mbgen::fma(work.s3_6, s9_96, work.s8_85 + alpha_chassis_z);
  const double alpha_rear_axle_z = mbgen::fma(work.s3_5, s9_89, s9_107);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s9_108 = work.R_rear_axle_y_y*alpha_rear_axle_y;
  const double s9_109 = mbgen::fma(work.R_rear_axle_z_y, alpha_rear_axle_z, s9_108);
  const double s9_110 = mbgen::fma(work.R_rear_axle_x_y, alpha_rear_axle_x, s9_109);
  result.zdd[Coordinate::wheel_rear_left] = mbgen::fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_left], s9_110);
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  result.zdd[Coordinate::wheel_rear_right] = mbgen::fms(0.045454545454545456,
      tau[Coordinate::wheel_rear_right], s9_110);
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
      r_wheel_front_left_z, r_carrier_right_aux1_y, s1_32, s1_34, R_carrier_right_aux2_y_y,
      R_carrier_right_aux2_z_y, R_carrier_right_x_x, R_carrier_right_x_z, R_carrier_right_y_x,
      R_carrier_right_y_z, R_carrier_right_z_x, R_carrier_right_z_z, r_wheel_front_right_x,
      r_wheel_front_right_y, r_wheel_front_right_z, r_rear_axle_aux1_x, r_rear_axle_aux3_z,
      R_rear_axle_aux5_x_x, R_rear_axle_aux5_y_x, R_rear_axle_x_y, R_rear_axle_x_z, R_rear_axle_y_y,
      R_rear_axle_y_z, R_rear_axle_z_y, R_rear_axle_z_z, r_wheel_rear_left_x, r_wheel_rear_left_y,
      r_wheel_rear_left_z, r_wheel_rear_right_x, r_wheel_rear_right_y, r_wheel_rear_right_z,
      v_chassis_x, v_chassis_y, v_chassis_z, w_chassis_x, w_chassis_y, w_chassis_z, s4_7,
      v_lower_arm_left_x, v_lower_arm_left_y, s4_9, v_lower_arm_left_z, w_lower_arm_left_x,
      v_carrier_left_aux1_x, v_carrier_left_aux1_y, v_carrier_left_aux1_z, w_carrier_left_x,
      w_carrier_left_y, w_carrier_left_z, v_wheel_front_left_x, v_wheel_front_left_y,
      v_wheel_front_left_z, w_wheel_front_left_x, w_wheel_front_left_y, w_wheel_front_left_z,
      v_upper_arm_left_x, v_upper_arm_left_y, v_upper_arm_left_z, w_upper_arm_left_x,
      v_arb_front_left_x, v_arb_front_left_y, v_arb_front_left_z, w_arb_front_left_y, s4_19,
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
  const double R_chassis_x_y = mbgen::fnma(R_chassis_aux4_y_x, s1_4, R_chassis_aux4_x_x*s1_3);
  const double s1_5 = s1_1*s1_4;
  const double R_chassis_x_z = mbgen::fma(R_chassis_aux4_x_x, s1_5, R_chassis_aux4_y_x*s1_2);
  const double R_chassis_y_y = mbgen::fma(R_chassis_aux4_y_x, s1_3, R_chassis_aux4_x_x*s1_4);
  const double R_chassis_y_z = mbgen::fnma(R_chassis_aux4_x_x, s1_2, R_chassis_aux4_y_x*s1_5);
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
  const double s1_7 = (-p_carrier_left_rz_z)*R_lower_arm_left_z_y;
  const double s1_8 = mbgen::fma(p_carrier_left_rz_y, R_lower_arm_left_y_y, s1_7);
  work.r_carrier_left_aux1_y = p_lower_arm_left_y + s1_8;
  const double s1_9 = p_carrier_left_rz_y*R_lower_arm_left_z_y;
  const double s1_10 = mbgen::fnma((-p_carrier_left_rz_z), R_lower_arm_left_y_y, s1_9);
  work.r_carrier_left_aux1_z = s1_10 - (-p_lower_arm_left_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double s1_11 = work.cosines[5];
  work.s1_12 = s1_6*s1_11;
  const double s1_13 = work.sines[5];
  const double R_carrier_left_aux2_x_z = s1_6*s1_13;
  work.R_carrier_left_aux2_y_y = mbgen::fnma(R_lower_arm_left_z_y, s1_13,
      R_carrier_left_aux1_y_y*s1_11);
  const double s1_14 = mbgen::fma(R_carrier_left_aux1_y_y, s1_13, R_lower_arm_left_z_y*s1_11);
  work.R_carrier_left_aux2_z_y = mbgen::fma(R_carrier_left_aux1_z_y, s1_11,
      R_lower_arm_left_y_y*s1_13);
  const double R_carrier_left_aux2_z_z = mbgen::fnma(R_carrier_left_aux1_z_y, s1_13,
      R_lower_arm_left_y_y*s1_11);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s1_15 = work.cosines[6];
  const double s1_16 = work.sines[6];
  const double s1_17 = R_carrier_left_aux1_x_x*s1_15;
  work.R_carrier_left_x_x = mbgen::fnma(R_carrier_left_aux2_x_z, s1_16, s1_17);
  const double s1_18 = R_carrier_left_aux1_x_x*s1_16;
  work.R_carrier_left_x_z = mbgen::fma(R_carrier_left_aux2_x_z, s1_15, s1_18);
  work.R_carrier_left_y_x = mbgen::fma(s1_14, s1_16, R_carrier_left_aux1_y_x*s1_15);
  work.R_carrier_left_y_z = mbgen::fnma(s1_14, s1_15, R_carrier_left_aux1_y_x*s1_16);
  const double s1_19 = R_carrier_left_aux1_z_x*s1_15;
  work.R_carrier_left_z_x = mbgen::fnma(R_carrier_left_aux2_z_z, s1_16, s1_19);
  const double s1_20 = R_carrier_left_aux1_z_x*s1_16;
  work.R_carrier_left_z_z = mbgen::fma(R_carrier_left_aux2_z_z, s1_15, s1_20);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s1_21 = p_wheel_front_left_z*work.R_carrier_left_x_z;
  const double s1_22 = mbgen::fnma(p_wheel_front_left_y, work.s1_12, s1_21);
  work.r_wheel_front_left_x = p_lower_arm_left_x + s1_22;
  const double s1_23 = p_wheel_front_left_y*work.R_carrier_left_aux2_y_y;
  const double s1_24 = mbgen::fma(p_wheel_front_left_z, work.R_carrier_left_y_z, s1_23);
  work.r_wheel_front_left_y = work.r_carrier_left_aux1_y + s1_24;
  const double s1_25 = p_wheel_front_left_y*work.R_carrier_left_aux2_z_y;
  const double s1_26 = mbgen::fma(p_wheel_front_left_z, work.R_carrier_left_z_z, s1_25);
  work.r_wheel_front_left_z = work.r_carrier_left_aux1_z + s1_26;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s1_27 = work.sines[10];
  const double R_carrier_right_aux1_y_x = R_lower_arm_right_y_y*s1_27;
  const double R_carrier_right_aux1_x_x = work.cosines[10];
  const double R_carrier_right_aux1_y_y = R_lower_arm_right_y_y*R_carrier_right_aux1_x_x;
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_carrier_right_aux1_z_x = R_lower_arm_right_z_y*s1_27;
  const double R_carrier_right_aux1_z_y = R_lower_arm_right_z_y*R_carrier_right_aux1_x_x;
  const double s1_28 = (-p_carrier_right_rz_z)*R_lower_arm_right_z_y;
  const double s1_29 = mbgen::fnma((-p_carrier_right_rz_y), R_lower_arm_right_y_y, s1_28);
  work.r_carrier_right_aux1_y = s1_29 - (-p_lower_arm_right_y);
  const double s1_30 = (-p_carrier_right_rz_y)*R_lower_arm_right_z_y;
  const double s1_31 = mbgen::fma((-p_carrier_right_rz_z), R_lower_arm_right_y_y, s1_30);
  work.s1_32 = (-p_lower_arm_right_z) + s1_31;
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double s1_33 = work.cosines[11];
  work.s1_34 = s1_27*s1_33;
  const double s1_35 = work.sines[11];
  const double R_carrier_right_aux2_x_z = s1_27*s1_35;
  const double s1_36 = R_carrier_right_aux1_y_y*s1_33;
  work.R_carrier_right_aux2_y_y = mbgen::fnma(R_lower_arm_right_z_y, s1_35, s1_36);
  const double s1_37 = mbgen::fma(R_carrier_right_aux1_y_y, s1_35, R_lower_arm_right_z_y*s1_33);
  work.R_carrier_right_aux2_z_y = mbgen::fma(R_carrier_right_aux1_z_y, s1_33,
      R_lower_arm_right_y_y*s1_35);
  const double s1_38 = R_lower_arm_right_y_y*s1_33;
  const double R_carrier_right_aux2_z_z = mbgen::fnma(R_carrier_right_aux1_z_y, s1_35, s1_38);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s1_39 = work.cosines[12];
  const double s1_40 = work.sines[12];
  const double s1_41 = R_carrier_right_aux1_x_x*s1_39;
  work.R_carrier_right_x_x = mbgen::fnma(R_carrier_right_aux2_x_z, s1_40, s1_41);
  const double s1_42 = R_carrier_right_aux1_x_x*s1_40;
  work.R_carrier_right_x_z = mbgen::fma(R_carrier_right_aux2_x_z, s1_39, s1_42);
  work.R_carrier_right_y_x = mbgen::fma(s1_37, s1_40, R_carrier_right_aux1_y_x*s1_39);
  work.R_carrier_right_y_z = mbgen::fnma(s1_37, s1_39, R_carrier_right_aux1_y_x*s1_40);
  const double s1_43 = R_carrier_right_aux1_z_x*s1_39;
  work.R_carrier_right_z_x = mbgen::fnma(R_carrier_right_aux2_z_z, s1_40, s1_43);
  const double s1_44 = R_carrier_right_aux1_z_x*s1_40;
  work.R_carrier_right_z_z = mbgen::fma(R_carrier_right_aux2_z_z, s1_39, s1_44);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s1_45 = (-p_wheel_front_right_y)*work.s1_34;
  const double s1_46 = mbgen::fma(p_wheel_front_right_z, work.R_carrier_right_x_z, s1_45);
  work.r_wheel_front_right_x = p_lower_arm_right_x + s1_46;
  const double s1_47 = p_wheel_front_right_z*work.R_carrier_right_y_z;
  const double s1_48 = mbgen::fnma((-p_wheel_front_right_y), work.R_carrier_right_aux2_y_y, s1_47);
  work.r_wheel_front_right_y = work.r_carrier_right_aux1_y + s1_48;
  const double s1_49 = p_wheel_front_right_z*work.R_carrier_right_z_z;
  const double s1_50 = mbgen::fnma((-p_wheel_front_right_y), work.R_carrier_right_aux2_z_y, s1_49);
  work.r_wheel_front_right_z = s1_50 - work.s1_32;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  work.r_rear_axle_aux1_x = state.z[Coordinate::rear_axle_tx] - (-p_rear_axle_tx_x);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  const double z_rear_axle_tz = state.z[Coordinate::rear_axle_tz];
  work.r_rear_axle_aux3_z = z_rear_axle_tz - (-p_rear_axle_tx_z);
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double R_rear_axle_aux4_x_x = work.cosines[17];
  const double R_rear_axle_aux5_z_z = work.cosines[18];
  work.R_rear_axle_aux5_x_x = R_rear_axle_aux4_x_x*R_rear_axle_aux5_z_z;
  const double s1_51 = work.sines[18];
  const double R_rear_axle_aux5_x_z = R_rear_axle_aux4_x_x*s1_51;
  const double R_rear_axle_aux4_y_x = work.sines[17];
  work.R_rear_axle_aux5_y_x = R_rear_axle_aux4_y_x*R_rear_axle_aux5_z_z;
  const double R_rear_axle_aux5_y_z = R_rear_axle_aux4_y_x*s1_51;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s1_52 = work.sines[19];
  const double s1_53 = work.cosines[19];
  work.R_rear_axle_x_y = mbgen::fnma(R_rear_axle_aux4_y_x, s1_53, R_rear_axle_aux5_x_z*s1_52);
  work.R_rear_axle_x_z = mbgen::fma(R_rear_axle_aux5_x_z, s1_53, R_rear_axle_aux4_y_x*s1_52);
  work.R_rear_axle_y_y = mbgen::fma(R_rear_axle_aux5_y_z, s1_52, R_rear_axle_aux4_x_x*s1_53);
  work.R_rear_axle_y_z = mbgen::fnma(R_rear_axle_aux4_x_x, s1_52, R_rear_axle_aux5_y_z*s1_53);
  work.R_rear_axle_z_y = R_rear_axle_aux5_z_z*s1_52;
  work.R_rear_axle_z_z = R_rear_axle_aux5_z_z*s1_53;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s1_54 = p_wheel_rear_left_y*work.R_rear_axle_x_y;
  work.r_wheel_rear_left_x = work.r_rear_axle_aux1_x + s1_54;
  const double s1_55 = p_wheel_rear_left_y*work.R_rear_axle_y_y;
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  work.r_wheel_rear_left_y = z_rear_axle_ty + s1_55;
  const double s1_56 = p_wheel_rear_left_y*work.R_rear_axle_z_y;
  work.r_wheel_rear_left_z = work.r_rear_axle_aux3_z + s1_56;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  work.r_wheel_rear_right_x = work.r_rear_axle_aux1_x - s1_54;
  work.r_wheel_rear_right_y = z_rear_axle_ty - s1_55;
  work.r_wheel_rear_right_z = work.r_rear_axle_aux3_z - s1_56;
  // operations: 57 add, 103 multiply, 44 sin cos

  // --- step 4: velocities ---
  // chassis: chassis_rx, revolute, chassis_aux5
  const double zd_chassis_tx = state.zd[Coordinate::chassis_tx];
  const double zd_chassis_ty = state.zd[Coordinate::chassis_ty];
  const double s4_1 = zd_chassis_tx*R_chassis_aux5_x_x;
  const double zd_chassis_tz = state.zd[Coordinate::chassis_tz];
  const double s4_2 = mbgen::fma(zd_chassis_ty, R_chassis_aux5_y_x, s4_1);
  work.v_chassis_x = mbgen::fnma(zd_chassis_tz, s1_1, s4_2);
  const double s4_3 = zd_chassis_tz*work.R_chassis_z_y;
  const double s4_4 = mbgen::fma(zd_chassis_tx, R_chassis_x_y, s4_3);
  work.v_chassis_y = mbgen::fma(zd_chassis_ty, R_chassis_y_y, s4_4);
  const double s4_5 = zd_chassis_tz*work.R_chassis_z_z;
  const double s4_6 = mbgen::fma(zd_chassis_tx, R_chassis_x_z, s4_5);
  work.v_chassis_z = mbgen::fma(zd_chassis_ty, R_chassis_y_z, s4_6);
  const double zd_chassis_rz = state.zd[Coordinate::chassis_rz];
  work.w_chassis_x = mbgen::fnma(zd_chassis_rz, s1_1, state.zd[Coordinate::chassis_rx]);
  const double zd_chassis_ry = state.zd[Coordinate::chassis_ry];
  work.w_chassis_y = mbgen::fma(zd_chassis_ry, s1_4, zd_chassis_rz*work.R_chassis_z_y);
  work.w_chassis_z = mbgen::fnma(zd_chassis_ry, s1_2, zd_chassis_rz*work.R_chassis_z_z);
  // lower_arm_left: lower_arm_left, revolute, chassis
  work.s4_7 = mbgen::fnma(p_lower_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_lower_arm_left_x = mbgen::fnma((-p_lower_arm_left_z), work.w_chassis_y, work.s4_7);
  const double s4_8 = mbgen::fma(p_lower_arm_left_x, work.w_chassis_z, work.v_chassis_y);
  work.v_lower_arm_left_y = mbgen::fma((-p_lower_arm_left_z), work.w_chassis_x, s4_8);
  work.s4_9 = mbgen::fma(p_lower_arm_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_lower_arm_left_z = mbgen::fnma(p_lower_arm_left_x, work.w_chassis_y, work.s4_9);
  work.w_lower_arm_left_x = state.zd[Coordinate::lower_arm_left] + work.w_chassis_x;
  // carrier_left_aux1: carrier_left_rz, revolute, lower_arm_left
  const double s4_10 = mbgen::fma(s1_10, work.w_chassis_y, work.v_lower_arm_left_x);
  work.v_carrier_left_aux1_x = mbgen::fnma(s1_8, work.w_chassis_z, s4_10);
  work.v_carrier_left_aux1_y = mbgen::fnma(s1_10, work.w_lower_arm_left_x, work.v_lower_arm_left_y);
  work.v_carrier_left_aux1_z = mbgen::fma(s1_8, work.w_lower_arm_left_x, work.v_lower_arm_left_z);
  const double zd_carrier_left_rz = state.zd[Coordinate::carrier_left_rz];
  const double w_carrier_left_aux1_y = mbgen::fnma(zd_carrier_left_rz, R_lower_arm_left_z_y,
      work.w_chassis_y);
  const double w_carrier_left_aux1_z = mbgen::fma(zd_carrier_left_rz, R_lower_arm_left_y_y,
      work.w_chassis_z);
  // carrier_left_aux2: carrier_left_rx, revolute, carrier_left_aux1
  const double zd_carrier_left_rx = state.zd[Coordinate::carrier_left_rx];
  const double w_carrier_left_aux2_x = mbgen::fma(zd_carrier_left_rx, R_carrier_left_aux1_x_x,
      work.w_lower_arm_left_x);
  const double w_carrier_left_aux2_y = mbgen::fma(zd_carrier_left_rx, R_carrier_left_aux1_y_x,
      w_carrier_left_aux1_y);
  const double w_carrier_left_aux2_z = mbgen::fma(zd_carrier_left_rx, R_carrier_left_aux1_z_x,
      w_carrier_left_aux1_z);
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double zd_carrier_left_ry = state.zd[Coordinate::carrier_left_ry];
  work.w_carrier_left_x = mbgen::fnma(zd_carrier_left_ry, work.s1_12, w_carrier_left_aux2_x);
  work.w_carrier_left_y = mbgen::fma(zd_carrier_left_ry, work.R_carrier_left_aux2_y_y,
      w_carrier_left_aux2_y);
  work.w_carrier_left_z = mbgen::fma(zd_carrier_left_ry, work.R_carrier_left_aux2_z_y,
      w_carrier_left_aux2_z);
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s4_11 = mbgen::fma(s1_26, work.w_carrier_left_y, work.v_carrier_left_aux1_x);
  work.v_wheel_front_left_x = mbgen::fnma(s1_24, work.w_carrier_left_z, s4_11);
  const double s4_12 = mbgen::fma(s1_22, work.w_carrier_left_z, work.v_carrier_left_aux1_y);
  work.v_wheel_front_left_y = mbgen::fnma(s1_26, work.w_carrier_left_x, s4_12);
  const double s4_13 = mbgen::fma(s1_24, work.w_carrier_left_x, work.v_carrier_left_aux1_z);
  work.v_wheel_front_left_z = mbgen::fnma(s1_22, work.w_carrier_left_y, s4_13);
  const double zd_wheel_front_left = state.zd[Coordinate::wheel_front_left];
  work.w_wheel_front_left_x = mbgen::fnma(zd_wheel_front_left, work.s1_12, work.w_carrier_left_x);
  work.w_wheel_front_left_y = mbgen::fma(zd_wheel_front_left, work.R_carrier_left_aux2_y_y,
      work.w_carrier_left_y);
  work.w_wheel_front_left_z = mbgen::fma(zd_wheel_front_left, work.R_carrier_left_aux2_z_y,
      work.w_carrier_left_z);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double s4_14 = mbgen::fnma((-p_upper_arm_left_z), work.w_chassis_y, work.v_chassis_x);
  work.v_upper_arm_left_x = mbgen::fnma(p_upper_arm_left_y, work.w_chassis_z, s4_14);
  work.v_upper_arm_left_y = mbgen::fma((-p_upper_arm_left_z), work.w_chassis_x, s4_8);
  const double s4_15 = mbgen::fma(p_upper_arm_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_upper_arm_left_z = mbgen::fnma(p_lower_arm_left_x, work.w_chassis_y, s4_15);
  work.w_upper_arm_left_x = state.zd[Coordinate::upper_arm_left] + work.w_chassis_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double s4_16 = mbgen::fnma((-p_arb_front_left_z), work.w_chassis_y, work.v_chassis_x);
  work.v_arb_front_left_x = mbgen::fnma(p_arb_front_left_y, work.w_chassis_z, s4_16);
  const double s4_17 = mbgen::fma(p_upper_arm_left_y, work.w_chassis_x, work.v_chassis_y);
  work.v_arb_front_left_y = mbgen::fma(p_arb_front_left_x, work.w_chassis_z, s4_17);
  const double s4_18 = mbgen::fma(p_arb_front_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_arb_front_left_z = mbgen::fnma(p_arb_front_left_x, work.w_chassis_y, s4_18);
  work.w_arb_front_left_y = state.zd[Coordinate::arb_front_left] + work.w_chassis_y;
  // lower_arm_right: lower_arm_right, revolute, chassis
  work.s4_19 = mbgen::fma(p_lower_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_lower_arm_right_x = mbgen::fnma((-p_lower_arm_left_z), work.w_chassis_y, work.s4_19);
  const double s4_20 = mbgen::fnma(p_lower_arm_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_lower_arm_right_z = mbgen::fnma(p_lower_arm_left_x, work.w_chassis_y, s4_20);
  work.w_lower_arm_right_x = state.zd[Coordinate::lower_arm_right] + work.w_chassis_x;
  // carrier_right_aux1: carrier_right_rz, revolute, lower_arm_right
  const double s4_21 = mbgen::fnma(s1_31, work.w_chassis_y, work.v_lower_arm_right_x);
  work.v_carrier_right_aux1_x = mbgen::fnma(s1_29, work.w_chassis_z, s4_21);
  work.v_carrier_right_aux1_y = mbgen::fma(s1_31, work.w_lower_arm_right_x,
      work.v_lower_arm_left_y);
  work.v_carrier_right_aux1_z = mbgen::fma(s1_29, work.w_lower_arm_right_x,
      work.v_lower_arm_right_z);
  const double zd_carrier_right_rz = state.zd[Coordinate::carrier_right_rz];
  const double w_carrier_right_aux1_y = mbgen::fnma(zd_carrier_right_rz, R_lower_arm_right_z_y,
      work.w_chassis_y);
  const double w_carrier_right_aux1_z = mbgen::fma(zd_carrier_right_rz, R_lower_arm_right_y_y,
      work.w_chassis_z);
  // carrier_right_aux2: carrier_right_rx, revolute, carrier_right_aux1
  const double zd_carrier_right_rx = state.zd[Coordinate::carrier_right_rx];
  const double w_carrier_right_aux2_x = mbgen::fma(zd_carrier_right_rx, R_carrier_right_aux1_x_x,
      work.w_lower_arm_right_x);
  const double w_carrier_right_aux2_y = mbgen::fma(zd_carrier_right_rx, R_carrier_right_aux1_y_x,
      w_carrier_right_aux1_y);
  const double w_carrier_right_aux2_z = mbgen::fma(zd_carrier_right_rx, R_carrier_right_aux1_z_x,
      w_carrier_right_aux1_z);
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double zd_carrier_right_ry = state.zd[Coordinate::carrier_right_ry];
  work.w_carrier_right_x = mbgen::fnma(zd_carrier_right_ry, work.s1_34, w_carrier_right_aux2_x);
  work.w_carrier_right_y = mbgen::fma(zd_carrier_right_ry, work.R_carrier_right_aux2_y_y,
      w_carrier_right_aux2_y);
  work.w_carrier_right_z = mbgen::fma(zd_carrier_right_ry, work.R_carrier_right_aux2_z_y,
      w_carrier_right_aux2_z);
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s4_22 = mbgen::fma(s1_50, work.w_carrier_right_y, work.v_carrier_right_aux1_x);
  work.v_wheel_front_right_x = mbgen::fnma(s1_48, work.w_carrier_right_z, s4_22);
  const double s4_23 = mbgen::fma(s1_46, work.w_carrier_right_z, work.v_carrier_right_aux1_y);
  work.v_wheel_front_right_y = mbgen::fnma(s1_50, work.w_carrier_right_x, s4_23);
  const double s4_24 = mbgen::fma(s1_48, work.w_carrier_right_x, work.v_carrier_right_aux1_z);
  work.v_wheel_front_right_z = mbgen::fnma(s1_46, work.w_carrier_right_y, s4_24);
  const double zd_wheel_front_right = state.zd[Coordinate::wheel_front_right];
  work.w_wheel_front_right_x = mbgen::fnma(zd_wheel_front_right, work.s1_34,
      work.w_carrier_right_x);
  work.w_wheel_front_right_y = mbgen::fma(zd_wheel_front_right, work.R_carrier_right_aux2_y_y,
      work.w_carrier_right_y);
  work.w_wheel_front_right_z = mbgen::fma(zd_wheel_front_right, work.R_carrier_right_aux2_z_y,
      work.w_carrier_right_z);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double s4_25 = mbgen::fma(p_upper_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_upper_arm_right_x = mbgen::fnma((-p_upper_arm_left_z), work.w_chassis_y, s4_25);
  const double s4_26 = mbgen::fnma(p_lower_arm_left_x, work.w_chassis_y, work.v_chassis_z);
  work.v_upper_arm_right_z = mbgen::fnma(p_upper_arm_left_y, work.w_chassis_x, s4_26);
  work.w_upper_arm_right_x = state.zd[Coordinate::upper_arm_right] + work.w_chassis_x;
  // arb_front_right: arb_front_right, revolute, chassis
  const double s4_27 = mbgen::fma(p_arb_front_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_arb_front_right_x = mbgen::fnma((-p_arb_front_left_z), work.w_chassis_y, s4_27);
  const double s4_28 = mbgen::fnma(p_arb_front_left_y, work.w_chassis_x, work.v_chassis_z);
  work.v_arb_front_right_z = mbgen::fnma(p_arb_front_left_x, work.w_chassis_y, s4_28);
  work.w_arb_front_right_y = state.zd[Coordinate::arb_front_right] + work.w_chassis_y;
  // pitman_arm: pitman_arm, revolute, chassis
  const double s4_29 = mbgen::fnma(p_upper_arm_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_pitman_arm_x = mbgen::fnma((-p_pitman_arm_z), work.w_chassis_y, s4_29);
  const double s4_30 = mbgen::fma(p_lower_arm_left_y, work.w_chassis_x, work.v_chassis_y);
  work.v_pitman_arm_y = mbgen::fma(p_pitman_arm_x, work.w_chassis_z, s4_30);
  work.v_pitman_arm_z = mbgen::fnma(p_pitman_arm_x, work.w_chassis_y, s4_15);
  work.w_pitman_arm_y = state.zd[Coordinate::pitman_arm] + work.w_chassis_y;
  // bell_crank: bell_crank, revolute, chassis
  work.v_bell_crank_x = mbgen::fnma((-p_bell_crank_z), work.w_chassis_y, work.v_chassis_x);
  const double s4_31 = mbgen::fma((-p_bell_crank_z), work.w_chassis_x, work.v_chassis_y);
  work.v_bell_crank_y = mbgen::fma(p_bell_crank_x, work.w_chassis_z, s4_31);
  work.v_bell_crank_z = mbgen::fnma(p_bell_crank_x, work.w_chassis_y, work.v_chassis_z);
  work.w_bell_crank_z = state.zd[Coordinate::bell_crank] + work.w_chassis_z;
  // rear_axle_aux1: rear_axle_tx, prismatic, chassis
  const double s4_32 = state.zd[Coordinate::rear_axle_tx] + work.v_chassis_x;
  const double v_rear_axle_aux1_x = mbgen::fnma((-p_arb_front_left_z), work.w_chassis_y, s4_32);
  const double v_rear_axle_aux1_y = mbgen::fma(work.r_rear_axle_aux1_x, work.w_chassis_z, s4_17);
  const double v_rear_axle_aux1_z = mbgen::fnma(work.r_rear_axle_aux1_x, work.w_chassis_y,
      work.v_chassis_z);
  // rear_axle_aux2: rear_axle_ty, prismatic, rear_axle_aux1
  const double v_rear_axle_aux2_x = mbgen::fnma(z_rear_axle_ty, work.w_chassis_z,
      v_rear_axle_aux1_x);
  const double v_rear_axle_aux2_y = state.zd[Coordinate::rear_axle_ty] + v_rear_axle_aux1_y;
  const double v_rear_axle_aux2_z = mbgen::fma(z_rear_axle_ty, work.w_chassis_x,
      v_rear_axle_aux1_z);
  // rear_axle_aux3: rear_axle_tz, prismatic, rear_axle_aux2
  work.v_rear_axle_aux3_x = mbgen::fma(z_rear_axle_tz, work.w_chassis_y, v_rear_axle_aux2_x);
  work.v_rear_axle_aux3_y = mbgen::fnma(z_rear_axle_tz, work.w_chassis_x, v_rear_axle_aux2_y);
  work.v_rear_axle_aux3_z = state.zd[Coordinate::rear_axle_tz] + v_rear_axle_aux2_z;
  // rear_axle_aux4: rear_axle_rz, revolute, rear_axle_aux3
  const double w_rear_axle_aux4_z = state.zd[Coordinate::rear_axle_rz] + work.w_chassis_z;
  // rear_axle_aux5: rear_axle_ry, revolute, rear_axle_aux4
  const double zd_rear_axle_ry = state.zd[Coordinate::rear_axle_ry];
  const double w_rear_axle_aux5_x = mbgen::fnma(zd_rear_axle_ry, R_rear_axle_aux4_y_x,
      work.w_chassis_x);
  const double w_rear_axle_aux5_y = mbgen::fma(zd_rear_axle_ry, R_rear_axle_aux4_x_x,
      work.w_chassis_y);
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double zd_rear_axle_rx = state.zd[Coordinate::rear_axle_rx];
  work.w_rear_axle_x = mbgen::fma(zd_rear_axle_rx, work.R_rear_axle_aux5_x_x, w_rear_axle_aux5_x);
  work.w_rear_axle_y = mbgen::fma(zd_rear_axle_rx, work.R_rear_axle_aux5_y_x, w_rear_axle_aux5_y);
  work.w_rear_axle_z = mbgen::fnma(zd_rear_axle_rx, s1_51, w_rear_axle_aux4_z);
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s4_33 = mbgen::fma(s1_56, work.w_rear_axle_y, work.v_rear_axle_aux3_x);
  work.v_wheel_rear_left_x = mbgen::fnma(s1_55, work.w_rear_axle_z, s4_33);
  const double s4_34 = mbgen::fma(s1_54, work.w_rear_axle_z, work.v_rear_axle_aux3_y);
  work.v_wheel_rear_left_y = mbgen::fnma(s1_56, work.w_rear_axle_x, s4_34);
  const double s4_35 = mbgen::fma(s1_55, work.w_rear_axle_x, work.v_rear_axle_aux3_z);
  work.v_wheel_rear_left_z = mbgen::fnma(s1_54, work.w_rear_axle_y, s4_35);
  const double zd_wheel_rear_left = state.zd[Coordinate::wheel_rear_left];
  work.w_wheel_rear_left_x = mbgen::fma(zd_wheel_rear_left, work.R_rear_axle_x_y,
      work.w_rear_axle_x);
  work.w_wheel_rear_left_y = mbgen::fma(zd_wheel_rear_left, work.R_rear_axle_y_y,
      work.w_rear_axle_y);
  work.w_wheel_rear_left_z = mbgen::fma(zd_wheel_rear_left, work.R_rear_axle_z_y,
      work.w_rear_axle_z);
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double s4_36 = mbgen::fnma(p_arb_front_left_y, work.w_chassis_z, work.v_chassis_x);
  work.v_arb_rear_left_x = mbgen::fnma((-p_arb_rear_left_z), work.w_chassis_y, s4_36);
  const double s4_37 = mbgen::fma(p_arb_front_left_y, work.w_chassis_x, work.v_chassis_y);
  work.v_arb_rear_left_y = mbgen::fnma((-p_arb_rear_left_x), work.w_chassis_z, s4_37);
  work.v_arb_rear_left_z = mbgen::fma((-p_arb_rear_left_x), work.w_chassis_y, s4_18);
  work.w_arb_rear_left_y = state.zd[Coordinate::arb_rear_left] + work.w_chassis_y;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s4_38 = mbgen::fma(s1_55, work.w_rear_axle_z, work.v_rear_axle_aux3_x);
  work.v_wheel_rear_right_x = mbgen::fnma(s1_56, work.w_rear_axle_y, s4_38);
  const double s4_39 = mbgen::fma(s1_56, work.w_rear_axle_x, work.v_rear_axle_aux3_y);
  work.v_wheel_rear_right_y = mbgen::fnma(s1_54, work.w_rear_axle_z, s4_39);
  const double s4_40 = mbgen::fma(s1_54, work.w_rear_axle_y, work.v_rear_axle_aux3_z);
  work.v_wheel_rear_right_z = mbgen::fnma(s1_55, work.w_rear_axle_x, s4_40);
  const double zd_wheel_rear_right = state.zd[Coordinate::wheel_rear_right];
  work.w_wheel_rear_right_x = mbgen::fma(zd_wheel_rear_right, work.R_rear_axle_x_y,
      work.w_rear_axle_x);
  work.w_wheel_rear_right_y = mbgen::fma(zd_wheel_rear_right, work.R_rear_axle_y_y,
      work.w_rear_axle_y);
  work.w_wheel_rear_right_z = mbgen::fma(zd_wheel_rear_right, work.R_rear_axle_z_y,
      work.w_rear_axle_z);
  // arb_rear_right: arb_rear_right, revolute, chassis
  work.v_arb_rear_right_x = mbgen::fnma((-p_arb_rear_left_z), work.w_chassis_y, s4_27);
  const double s4_41 = mbgen::fma((-p_arb_rear_left_x), work.w_chassis_y, work.v_chassis_z);
  work.v_arb_rear_right_z = mbgen::fnma(p_arb_front_left_y, work.w_chassis_x, s4_41);
  work.w_arb_rear_right_y = state.zd[Coordinate::arb_rear_right] + work.w_chassis_y;
  // operations: 141 add, 132 multiply

  // --- step 7: inertias of the bodies and forces on joints ---
  // arb_link_front_left
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_1 = (-p_arb_link_front_left_from_x)*R_arb_front_left_x_z;
  work.s7_2 = mbgen::fma(p_arb_link_front_left_from_z, R_arb_front_left_x_x, s7_1);
  const double s7_3 = p_arb_link_front_left_from_z*R_arb_front_left_x_z;
  work.s7_4 = mbgen::fnma((-p_arb_link_front_left_from_x), R_arb_front_left_x_x, s7_3);
  const double s7_5 = p_arb_link_front_left_to_x*work.R_carrier_left_x_x;
  const double s7_6 = work.s1_12 + work.R_carrier_left_x_z;
  work.s7_7 = mbgen::fma((-p_arb_link_front_left_to_y), s7_6, s7_5);
  const double s7_8 = work.R_carrier_left_y_z - work.R_carrier_left_aux2_y_y;
  const double s7_9 = p_arb_link_front_left_to_x*work.R_carrier_left_y_x;
  work.s7_10 = mbgen::fma((-p_arb_link_front_left_to_y), s7_8, s7_9);
  const double s7_11 = work.R_carrier_left_z_z - work.R_carrier_left_aux2_z_y;
  const double s7_12 = p_arb_link_front_left_to_x*work.R_carrier_left_z_x;
  work.s7_13 = mbgen::fma((-p_arb_link_front_left_to_y), s7_11, s7_12);
  // arb_link_front_right
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_14 = (-p_arb_link_front_right_from_x)*R_arb_front_right_x_z;
  work.s7_15 = mbgen::fma(p_arb_link_front_right_from_z, R_arb_front_right_x_x, s7_14);
  const double s7_16 = p_arb_link_front_right_from_z*R_arb_front_right_x_z;
  work.s7_17 = mbgen::fnma((-p_arb_link_front_right_from_x), R_arb_front_right_x_x, s7_16);
  const double s7_18 = p_arb_link_front_right_to_x*work.R_carrier_right_x_x;
  const double s7_19 = work.R_carrier_right_x_z - work.s1_34;
  work.s7_20 = mbgen::fma((-p_arb_link_front_left_to_y), s7_19, s7_18);
  const double s7_21 = work.R_carrier_right_aux2_y_y + work.R_carrier_right_y_z;
  const double s7_22 = p_arb_link_front_right_to_x*work.R_carrier_right_y_x;
  work.s7_23 = mbgen::fma((-p_arb_link_front_left_to_y), s7_21, s7_22);
  const double s7_24 = work.R_carrier_right_aux2_z_y + work.R_carrier_right_z_z;
  const double s7_25 = p_arb_link_front_right_to_x*work.R_carrier_right_z_x;
  work.s7_26 = mbgen::fma((-p_arb_link_front_left_to_y), s7_24, s7_25);
  // drag_link
  work.s7_27 = (-p_drag_link_from_z)*work.sines[15];
  work.s7_28 = (-p_drag_link_from_z)*work.cosines[15];
  const double R_bell_crank_y_x = work.sines[16];
  work.s7_29 = p_drag_link_to_y*R_bell_crank_y_x;
  const double R_bell_crank_x_x = work.cosines[16];
  work.s7_30 = p_drag_link_to_y*R_bell_crank_x_x;
  // tie_rod_left
  const double s7_31 = p_tie_rod_left_from_y*R_bell_crank_y_x;
  const double s7_32 = (-p_tie_rod_left_from_x)*R_bell_crank_y_x;
  work.s7_33 = mbgen::fma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s7_31);
  work.s7_34 = mbgen::fms(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_32);
  const double s7_35 = (-p_tie_rod_left_to_y)*work.s1_12;
  const double s7_36 = mbgen::fma(p_tie_rod_left_to_z, work.R_carrier_left_x_z, s7_35);
  work.s7_37 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_x_x, s7_36);
  const double s7_38 = p_tie_rod_left_to_z*work.R_carrier_left_y_z;
  const double s7_39 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_y_x, s7_38);
  work.s7_40 = mbgen::fnma((-p_tie_rod_left_to_y), work.R_carrier_left_aux2_y_y, s7_39);
  const double s7_41 = p_tie_rod_left_to_z*work.R_carrier_left_z_z;
  const double s7_42 = mbgen::fnma((-p_tie_rod_left_to_x), work.R_carrier_left_z_x, s7_41);
  work.s7_43 = mbgen::fnma((-p_tie_rod_left_to_y), work.R_carrier_left_aux2_z_y, s7_42);
  // tie_rod_right
  work.s7_44 = mbgen::fma(p_tie_rod_left_from_y, R_bell_crank_x_x, s7_32);
  work.s7_45 = mbgen::fnma((-p_tie_rod_left_from_x), R_bell_crank_x_x, s7_31);
  const double s7_46 = p_tie_rod_right_to_z*work.R_carrier_right_x_z;
  const double s7_47 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_x_x, s7_46);
  work.s7_48 = mbgen::fnma(p_tie_rod_right_to_y, work.s1_34, s7_47);
  const double s7_49 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_y_y;
  const double s7_50 = mbgen::fma(p_tie_rod_right_to_z, work.R_carrier_right_y_z, s7_49);
  work.s7_51 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_y_x, s7_50);
  const double s7_52 = p_tie_rod_right_to_y*work.R_carrier_right_aux2_z_y;
  const double s7_53 = mbgen::fma(p_tie_rod_right_to_z, work.R_carrier_right_z_z, s7_52);
  work.s7_54 = mbgen::fnma((-p_tie_rod_right_to_x), work.R_carrier_right_z_x, s7_53);
  // long_rod_left
  const double s7_55 = p_long_rod_left_to_x*s1_51;
  const double s7_56 = mbgen::fma((-p_long_rod_left_to_z), work.R_rear_axle_z_z, s7_55);
  work.s7_57 = mbgen::fms(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_56);
  const double s7_58 = p_long_rod_left_to_x*work.R_rear_axle_aux5_x_x;
  const double s7_59 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_x_z, s7_58);
  work.s7_60 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_59);
  const double s7_61 = p_long_rod_left_to_x*work.R_rear_axle_aux5_y_x;
  const double s7_62 = mbgen::fnma((-p_long_rod_left_to_z), work.R_rear_axle_y_z, s7_61);
  work.s7_63 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_62);
  // diag_rod_left
  const double s7_64 = p_diag_rod_left_to_y*work.R_rear_axle_z_y;
  work.s7_65 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s7_64);
  const double s7_66 = p_diag_rod_left_to_z*work.R_rear_axle_x_z;
  work.s7_67 = mbgen::fma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_66);
  const double s7_68 = p_diag_rod_left_to_y*work.R_rear_axle_y_y;
  work.s7_69 = mbgen::fma(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_68);
  // arb_link_rear_left
  work.s7_70 = p_arb_link_rear_left_from_x*work.sines[20];
  const double s7_71 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_y_x;
  const double s7_72 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_y_z, s7_71);
  const double s7_73 = (-p_arb_link_rear_left_to_x)*work.R_rear_axle_aux5_x_x;
  const double s7_74 = mbgen::fma((-p_arb_link_rear_left_to_z), work.R_rear_axle_x_z, s7_73);
  work.s7_75 = p_arb_link_rear_left_from_x*work.cosines[20];
  const double s7_76 = (-p_arb_link_rear_left_to_x)*s1_51;
  work.s7_77 = mbgen::fnma((-p_arb_link_rear_left_to_z), work.R_rear_axle_z_z, s7_76);
  work.s7_78 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, work.s7_77);
  work.s7_79 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_74);
  work.s7_80 = mbgen::fms(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_72);
  // long_rod_right
  work.s7_81 = mbgen::fma(p_long_rod_left_to_y, work.R_rear_axle_z_y, s7_56);
  work.s7_82 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_x_y, s7_59);
  work.s7_83 = mbgen::fnma(p_long_rod_left_to_y, work.R_rear_axle_y_y, s7_62);
  // diag_rod_right
  work.s7_84 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_z_z, s7_64);
  work.s7_85 = mbgen::fnma(p_diag_rod_left_to_y, work.R_rear_axle_x_y, s7_66);
  work.s7_86 = mbgen::fms(p_diag_rod_left_to_z, work.R_rear_axle_y_z, s7_68);
  // arb_link_rear_right
  work.s7_87 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_y_y, s7_72);
  work.s7_88 = mbgen::fma(p_arb_link_rear_left_to_y, work.R_rear_axle_x_y, s7_74);
}

/// Part 2 of compute_outputs: step 7: inertias of the bodies and forces on joints; step 9: outputs,
/// energies, power.
[[gnu::noinline]] void compute_outputs_2(const State& state, const double* tau,
    OutputsWork& __restrict work, Outputs& __restrict result) noexcept {
  // --- step 7: inertias of the bodies and forces on joints, continued ---
  // arb_link_rear_right
  const double R_arb_rear_right_x_z = work.sines[21];
  const double s7_89 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_z;
  const double s7_90 = mbgen::fnma(p_arb_link_rear_left_to_y, work.R_rear_axle_z_y, work.s7_77);
  const double R_arb_rear_right_x_x = work.cosines[21];
  const double s7_91 = p_arb_link_rear_right_from_x*R_arb_rear_right_x_x;
  // arb_rear_right: arb_rear_right, revolute, chassis
  const double s7_92 = c_arb_rear_right_x*R_arb_rear_right_x_z;
  const double s7_93 = c_arb_rear_right_x*R_arb_rear_right_x_x;
  const double s7_94 = R_arb_rear_right_x_x*work.w_chassis_x;
  const double s7_95 = mbgen::fnma(R_arb_rear_right_x_z, work.w_chassis_z, s7_94);
  const double s7_96 = I_arb_rear_right_yy*work.w_arb_rear_right_y;
  const double s7_97 = mbgen::fma(I_arb_rear_right_xy, s7_95, s7_96);
  const double s7_98 = I_arb_rear_right_xy*work.w_arb_rear_right_y;
  const double s7_99 = mbgen::fma(I_arb_rear_right_xx, s7_95, s7_98);
  const double s7_100 = R_arb_rear_right_x_z*work.w_chassis_x;
  const double s7_101 = mbgen::fma(R_arb_rear_right_x_x, work.w_chassis_z, s7_100);
  const double s7_102 = I_arb_rear_right_zz*s7_101;
  // wheel_rear_right: wheel_rear_right, revolute, rear_axle
  const double s7_103 = work.R_rear_axle_y_z*work.w_wheel_rear_right_y;
  const double s7_104 = mbgen::fma(work.R_rear_axle_z_z, work.w_wheel_rear_right_z, s7_103);
  const double s7_105 = mbgen::fma(work.R_rear_axle_x_z, work.w_wheel_rear_right_x, s7_104);
  const double s7_106 = work.R_rear_axle_aux5_y_x*work.w_wheel_rear_right_y;
  const double s1_51 = work.sines[18];
  const double s7_107 = mbgen::fma(work.R_rear_axle_aux5_x_x, work.w_wheel_rear_right_x, s7_106);
  const double s7_108 = mbgen::fnma(s1_51, work.w_wheel_rear_right_z, s7_107);
  const double s7_109 = I_wheel_rear_right_xx*s7_108;
  const double s7_110 = I_wheel_rear_right_zz*s7_105;
  const double s7_111 = work.R_rear_axle_y_y*work.w_wheel_rear_right_y;
  const double s7_112 = mbgen::fma(work.R_rear_axle_z_y, work.w_wheel_rear_right_z, s7_111);
  const double s7_113 = mbgen::fma(work.R_rear_axle_x_y, work.w_wheel_rear_right_x, s7_112);
  const double s7_114 = I_wheel_rear_right_yy*s7_113;
  // arb_rear_left: arb_rear_left, revolute, chassis
  const double R_arb_rear_left_x_z = work.sines[20];
  const double s7_115 = c_arb_rear_left_x*R_arb_rear_left_x_z;
  const double R_arb_rear_left_x_x = work.cosines[20];
  const double s7_116 = c_arb_rear_left_x*R_arb_rear_left_x_x;
  const double s7_117 = R_arb_rear_left_x_x*work.w_chassis_x;
  const double s7_118 = mbgen::fnma(R_arb_rear_left_x_z, work.w_chassis_z, s7_117);
  const double s7_119 = I_arb_rear_left_yy*work.w_arb_rear_left_y;
  const double s7_120 = mbgen::fnma((-I_arb_rear_left_xy), s7_118, s7_119);
  const double s7_121 = I_arb_rear_left_xx*s7_118;
  const double s7_122 = mbgen::fnma((-I_arb_rear_left_xy), work.w_arb_rear_left_y, s7_121);
  const double s7_123 = R_arb_rear_left_x_z*work.w_chassis_x;
  const double s7_124 = mbgen::fma(R_arb_rear_left_x_x, work.w_chassis_z, s7_123);
  const double s7_125 = I_arb_rear_left_zz*s7_124;
  // wheel_rear_left: wheel_rear_left, revolute, rear_axle
  const double s7_126 = work.R_rear_axle_y_z*work.w_wheel_rear_left_y;
  const double s7_127 = mbgen::fma(work.R_rear_axle_z_z, work.w_wheel_rear_left_z, s7_126);
  const double s7_128 = mbgen::fma(work.R_rear_axle_x_z, work.w_wheel_rear_left_x, s7_127);
  const double s7_129 = work.R_rear_axle_aux5_y_x*work.w_wheel_rear_left_y;
  const double s7_130 = mbgen::fma(work.R_rear_axle_aux5_x_x, work.w_wheel_rear_left_x, s7_129);
  const double s7_131 = mbgen::fnma(s1_51, work.w_wheel_rear_left_z, s7_130);
  const double s7_132 = I_wheel_rear_left_xx*s7_131;
  const double s7_133 = I_wheel_rear_left_zz*s7_128;
  const double s7_134 = work.R_rear_axle_y_y*work.w_wheel_rear_left_y;
  const double s7_135 = mbgen::fma(work.R_rear_axle_z_y, work.w_wheel_rear_left_z, s7_134);
  const double s7_136 = mbgen::fma(work.R_rear_axle_x_y, work.w_wheel_rear_left_x, s7_135);
  const double s7_137 = I_wheel_rear_left_yy*s7_136;
  // rear_axle: rear_axle_rx, revolute, rear_axle_aux5
  const double s7_138 = c_rear_axle_x*work.R_rear_axle_aux5_y_x;
  const double s7_139 = mbgen::fma(c_rear_axle_z, work.R_rear_axle_y_z, s7_138);
  const double s7_140 = mbgen::fnma(c_rear_axle_x, s1_51, c_rear_axle_z*work.R_rear_axle_z_z);
  const double s7_141 = c_rear_axle_x*work.R_rear_axle_aux5_x_x;
  const double s7_142 = mbgen::fma(c_rear_axle_z, work.R_rear_axle_x_z, s7_141);
  const double s7_143 = work.R_rear_axle_y_z*work.w_rear_axle_y;
  const double s7_144 = mbgen::fma(work.R_rear_axle_z_z, work.w_rear_axle_z, s7_143);
  const double s7_145 = mbgen::fma(work.R_rear_axle_x_z, work.w_rear_axle_x, s7_144);
  const double s7_146 = work.R_rear_axle_aux5_y_x*work.w_rear_axle_y;
  const double s7_147 = mbgen::fma(work.R_rear_axle_aux5_x_x, work.w_rear_axle_x, s7_146);
  const double s7_148 = mbgen::fnma(s1_51, work.w_rear_axle_z, s7_147);
  const double s7_149 = mbgen::fnma((-I_rear_axle_xz), s7_145, I_rear_axle_xx*s7_148);
  const double s7_150 = mbgen::fnma((-I_rear_axle_xz), s7_148, I_rear_axle_zz*s7_145);
  const double s7_151 = work.R_rear_axle_y_y*work.w_rear_axle_y;
  const double s7_152 = mbgen::fma(work.R_rear_axle_z_y, work.w_rear_axle_z, s7_151);
  const double s7_153 = mbgen::fma(work.R_rear_axle_x_y, work.w_rear_axle_x, s7_152);
  const double s7_154 = I_rear_axle_yy*s7_153;
  // bell_crank: bell_crank, revolute, chassis
  const double R_bell_crank_y_x = work.sines[16];
  const double R_bell_crank_x_x = work.cosines[16];
  const double s7_155 = c_bell_crank_y*R_bell_crank_y_x;
  const double s7_156 = mbgen::fma((-c_bell_crank_x), R_bell_crank_x_x, s7_155);
  const double s7_157 = c_bell_crank_y*R_bell_crank_x_x;
  const double s7_158 = mbgen::fnma((-c_bell_crank_x), R_bell_crank_y_x, s7_157);
  const double s7_159 = R_bell_crank_x_x*work.w_chassis_y;
  const double s7_160 = mbgen::fnma(R_bell_crank_y_x, work.w_chassis_x, s7_159);
  const double s7_161 = I_bell_crank_zz*work.w_bell_crank_z;
  const double s7_162 = R_bell_crank_y_x*work.w_chassis_y;
  const double s7_163 = mbgen::fma(R_bell_crank_x_x, work.w_chassis_x, s7_162);
  const double s7_164 = mbgen::fnma((-I_bell_crank_xy), s7_163, I_bell_crank_yy*s7_160);
  const double s7_165 = mbgen::fnma((-I_bell_crank_xy), s7_160, I_bell_crank_xx*s7_163);
  // pitman_arm: pitman_arm, revolute, chassis
  const double R_pitman_arm_x_z = work.sines[15];
  const double s7_166 = (-c_pitman_arm_z)*R_pitman_arm_x_z;
  const double R_pitman_arm_x_x = work.cosines[15];
  const double s7_167 = (-c_pitman_arm_z)*R_pitman_arm_x_x;
  const double s7_168 = R_pitman_arm_x_x*work.w_chassis_x;
  const double s7_169 = mbgen::fnma(R_pitman_arm_x_z, work.w_chassis_z, s7_168);
  const double s7_170 = I_pitman_arm_yy*work.w_pitman_arm_y;
  const double s7_171 = I_pitman_arm_xx*s7_169;
  const double s7_172 = R_pitman_arm_x_z*work.w_chassis_x;
  const double s7_173 = mbgen::fma(R_pitman_arm_x_x, work.w_chassis_z, s7_172);
  const double s7_174 = I_pitman_arm_zz*s7_173;
  // arb_front_right: arb_front_right, revolute, chassis
  const double R_arb_front_right_x_z = work.sines[14];
  const double R_arb_front_right_x_x = work.cosines[14];
  const double s7_175 = (-c_arb_front_right_x)*R_arb_front_right_x_z;
  const double s7_176 = mbgen::fma(c_arb_front_right_z, R_arb_front_right_x_x, s7_175);
  const double s7_177 = c_arb_front_right_z*R_arb_front_right_x_z;
  const double s7_178 = mbgen::fnma((-c_arb_front_right_x), R_arb_front_right_x_x, s7_177);
  const double s7_179 = R_arb_front_right_x_x*work.w_chassis_x;
  const double s7_180 = mbgen::fnma(R_arb_front_right_x_z, work.w_chassis_z, s7_179);
  const double s7_181 = R_arb_front_right_x_z*work.w_chassis_x;
  const double s7_182 = mbgen::fma(R_arb_front_right_x_x, work.w_chassis_z, s7_181);
  const double s7_183 = I_arb_front_right_yy*work.w_arb_front_right_y;
  const double s7_184 = mbgen::fma(I_arb_front_right_yz, s7_182, s7_183);
  const double s7_185 = mbgen::fnma((-I_arb_front_right_xy), s7_180, s7_184);
  const double s7_186 = mbgen::fma(I_arb_front_right_xx, s7_180, I_arb_front_right_xz*s7_182);
  const double s7_187 = mbgen::fnma((-I_arb_front_right_xy), work.w_arb_front_right_y, s7_186);
  const double s7_188 = I_arb_front_right_yz*work.w_arb_front_right_y;
  const double s7_189 = mbgen::fma(I_arb_front_right_xz, s7_180, s7_188);
  const double s7_190 = mbgen::fma(I_arb_front_right_zz, s7_182, s7_189);
  // upper_arm_right: upper_arm_right, revolute, chassis
  const double R_upper_arm_right_z_y = work.sines[13];
  const double R_upper_arm_right_y_y = work.cosines[13];
  const double s7_191 = (-c_upper_arm_right_z)*R_upper_arm_right_z_y;
  const double s7_192 = mbgen::fnma((-c_upper_arm_right_y), R_upper_arm_right_y_y, s7_191);
  const double s7_193 = (-c_upper_arm_right_y)*R_upper_arm_right_z_y;
  const double s7_194 = mbgen::fma((-c_upper_arm_right_z), R_upper_arm_right_y_y, s7_193);
  const double s7_195 = R_upper_arm_right_z_y*work.w_chassis_z;
  const double s7_196 = mbgen::fma(R_upper_arm_right_y_y, work.w_chassis_y, s7_195);
  const double s7_197 = R_upper_arm_right_y_y*work.w_chassis_z;
  const double s7_198 = mbgen::fnma(R_upper_arm_right_z_y, work.w_chassis_y, s7_197);
  const double s7_199 = I_upper_arm_right_zz*s7_198;
  const double s7_200 = I_upper_arm_right_yy*s7_196;
  const double s7_201 = I_upper_arm_right_xx*work.w_upper_arm_right_x;
  // wheel_front_right: wheel_front_right, revolute, carrier_right
  const double s7_202 = work.R_carrier_right_y_x*work.w_wheel_front_right_y;
  const double s7_203 = mbgen::fma(work.R_carrier_right_x_x, work.w_wheel_front_right_x, s7_202);
  const double s7_204 = mbgen::fma(work.R_carrier_right_z_x, work.w_wheel_front_right_z, s7_203);
  const double s7_205 = work.R_carrier_right_aux2_y_y*work.w_wheel_front_right_y;
  const double s7_206 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.w_wheel_front_right_z,
      s7_205);
  const double s7_207 = mbgen::fnma(work.s1_34, work.w_wheel_front_right_x, s7_206);
  const double s7_208 = I_wheel_front_right_yy*s7_207;
  const double s7_209 = I_wheel_front_right_xx*s7_204;
  const double s7_210 = work.R_carrier_right_y_z*work.w_wheel_front_right_y;
  const double s7_211 = mbgen::fma(work.R_carrier_right_x_z, work.w_wheel_front_right_x, s7_210);
  const double s7_212 = mbgen::fma(work.R_carrier_right_z_z, work.w_wheel_front_right_z, s7_211);
  const double s7_213 = I_wheel_front_right_zz*s7_212;
  // carrier_right: carrier_right_ry, revolute, carrier_right_aux2
  const double s7_214 = c_carrier_right_z*work.R_carrier_right_y_z;
  const double s7_215 = mbgen::fnma((-c_carrier_right_x), work.R_carrier_right_y_x, s7_214);
  const double s7_216 = mbgen::fnma((-c_carrier_right_y), work.R_carrier_right_aux2_y_y, s7_215);
  const double s7_217 = c_carrier_right_z*work.R_carrier_right_z_z;
  const double s7_218 = mbgen::fnma((-c_carrier_right_x), work.R_carrier_right_z_x, s7_217);
  const double s7_219 = mbgen::fnma((-c_carrier_right_y), work.R_carrier_right_aux2_z_y, s7_218);
  const double s7_220 = (-c_carrier_right_y)*work.s1_34;
  const double s7_221 = mbgen::fma(c_carrier_right_z, work.R_carrier_right_x_z, s7_220);
  const double s7_222 = mbgen::fnma((-c_carrier_right_x), work.R_carrier_right_x_x, s7_221);
  const double s7_223 = work.R_carrier_right_y_x*work.w_carrier_right_y;
  const double s7_224 = mbgen::fma(work.R_carrier_right_x_x, work.w_carrier_right_x, s7_223);
  const double s7_225 = mbgen::fma(work.R_carrier_right_z_x, work.w_carrier_right_z, s7_224);
  const double s7_226 = work.R_carrier_right_aux2_y_y*work.w_carrier_right_y;
  const double s7_227 = mbgen::fma(work.R_carrier_right_aux2_z_y, work.w_carrier_right_z, s7_226);
  const double s7_228 = mbgen::fnma(work.s1_34, work.w_carrier_right_x, s7_227);
  const double s7_229 = work.R_carrier_right_y_z*work.w_carrier_right_y;
  const double s7_230 = mbgen::fma(work.R_carrier_right_x_z, work.w_carrier_right_x, s7_229);
  const double s7_231 = mbgen::fma(work.R_carrier_right_z_z, work.w_carrier_right_z, s7_230);
  const double s7_232 = mbgen::fma(I_carrier_right_yz, s7_231, I_carrier_right_yy*s7_228);
  const double s7_233 = mbgen::fma(I_carrier_right_xy, s7_225, s7_232);
  const double s7_234 = mbgen::fma(I_carrier_right_xx, s7_225, I_carrier_right_xy*s7_228);
  const double s7_235 = mbgen::fnma((-I_carrier_right_xz), s7_231, s7_234);
  const double s7_236 = mbgen::fma(I_carrier_right_zz, s7_231, I_carrier_right_yz*s7_228);
  const double s7_237 = mbgen::fnma((-I_carrier_right_xz), s7_225, s7_236);
  // lower_arm_right: lower_arm_right, revolute, chassis
  const double R_lower_arm_right_z_y = work.sines[9];
  const double R_lower_arm_right_y_y = work.cosines[9];
  const double s7_238 = (-c_lower_arm_right_z)*R_lower_arm_right_z_y;
  const double s7_239 = mbgen::fnma((-c_lower_arm_right_y), R_lower_arm_right_y_y, s7_238);
  const double s7_240 = (-c_lower_arm_right_y)*R_lower_arm_right_z_y;
  const double s7_241 = mbgen::fma((-c_lower_arm_right_z), R_lower_arm_right_y_y, s7_240);
  const double s7_242 = R_lower_arm_right_z_y*work.w_chassis_z;
  const double s7_243 = mbgen::fma(R_lower_arm_right_y_y, work.w_chassis_y, s7_242);
  const double s7_244 = R_lower_arm_right_y_y*work.w_chassis_z;
  const double s7_245 = mbgen::fnma(R_lower_arm_right_z_y, work.w_chassis_y, s7_244);
  const double s7_246 = I_lower_arm_right_zz*s7_245;
  const double s7_247 = I_lower_arm_right_yy*s7_243;
  const double s7_248 = I_lower_arm_right_xx*work.w_lower_arm_right_x;
  // arb_front_left: arb_front_left, revolute, chassis
  const double R_arb_front_left_x_z = work.sines[8];
  const double R_arb_front_left_x_x = work.cosines[8];
  const double s7_249 = (-c_arb_front_left_x)*R_arb_front_left_x_z;
  const double s7_250 = mbgen::fma(c_arb_front_left_z, R_arb_front_left_x_x, s7_249);
  const double s7_251 = c_arb_front_left_z*R_arb_front_left_x_z;
  const double s7_252 = mbgen::fnma((-c_arb_front_left_x), R_arb_front_left_x_x, s7_251);
  const double s7_253 = R_arb_front_left_x_x*work.w_chassis_x;
  const double s7_254 = mbgen::fnma(R_arb_front_left_x_z, work.w_chassis_z, s7_253);
  const double s7_255 = R_arb_front_left_x_z*work.w_chassis_x;
  const double s7_256 = mbgen::fma(R_arb_front_left_x_x, work.w_chassis_z, s7_255);
  const double s7_257 = I_arb_front_left_yy*work.w_arb_front_left_y;
  const double s7_258 = mbgen::fma(I_arb_front_left_xy, s7_254, s7_257);
  const double s7_259 = mbgen::fnma((-I_arb_front_left_yz), s7_256, s7_258);
  const double s7_260 = I_arb_front_left_xy*work.w_arb_front_left_y;
  const double s7_261 = mbgen::fma(I_arb_front_left_xz, s7_256, s7_260);
  const double s7_262 = mbgen::fma(I_arb_front_left_xx, s7_254, s7_261);
  const double s7_263 = mbgen::fma(I_arb_front_left_zz, s7_256, I_arb_front_left_xz*s7_254);
  const double s7_264 = mbgen::fnma((-I_arb_front_left_yz), work.w_arb_front_left_y, s7_263);
  // upper_arm_left: upper_arm_left, revolute, chassis
  const double R_upper_arm_left_z_y = work.sines[7];
  const double R_upper_arm_left_y_y = work.cosines[7];
  const double s7_265 = c_upper_arm_left_y*R_upper_arm_left_z_y;
  const double s7_266 = mbgen::fnma((-c_upper_arm_left_z), R_upper_arm_left_y_y, s7_265);
  const double s7_267 = (-c_upper_arm_left_z)*R_upper_arm_left_z_y;
  const double s7_268 = mbgen::fma(c_upper_arm_left_y, R_upper_arm_left_y_y, s7_267);
  const double s7_269 = R_upper_arm_left_z_y*work.w_chassis_z;
  const double s7_270 = mbgen::fma(R_upper_arm_left_y_y, work.w_chassis_y, s7_269);
  const double s7_271 = R_upper_arm_left_y_y*work.w_chassis_z;
  const double s7_272 = mbgen::fnma(R_upper_arm_left_z_y, work.w_chassis_y, s7_271);
  const double s7_273 = I_upper_arm_left_zz*s7_272;
  const double s7_274 = I_upper_arm_left_yy*s7_270;
  const double s7_275 = I_upper_arm_left_xx*work.w_upper_arm_left_x;
  // wheel_front_left: wheel_front_left, revolute, carrier_left
  const double s7_276 = work.R_carrier_left_y_x*work.w_wheel_front_left_y;
  const double s7_277 = mbgen::fma(work.R_carrier_left_x_x, work.w_wheel_front_left_x, s7_276);
  const double s7_278 = mbgen::fma(work.R_carrier_left_z_x, work.w_wheel_front_left_z, s7_277);
  const double s7_279 = work.R_carrier_left_aux2_y_y*work.w_wheel_front_left_y;
  const double s7_280 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.w_wheel_front_left_z, s7_279);
  const double s7_281 = mbgen::fnma(work.s1_12, work.w_wheel_front_left_x, s7_280);
  const double s7_282 = I_wheel_front_left_yy*s7_281;
  const double s7_283 = I_wheel_front_left_xx*s7_278;
  const double s7_284 = work.R_carrier_left_y_z*work.w_wheel_front_left_y;
  const double s7_285 = mbgen::fma(work.R_carrier_left_x_z, work.w_wheel_front_left_x, s7_284);
  const double s7_286 = mbgen::fma(work.R_carrier_left_z_z, work.w_wheel_front_left_z, s7_285);
  const double s7_287 = I_wheel_front_left_zz*s7_286;
  // carrier_left: carrier_left_ry, revolute, carrier_left_aux2
  const double s7_288 = c_carrier_left_y*work.R_carrier_left_aux2_y_y;
  const double s7_289 = mbgen::fma(c_carrier_left_z, work.R_carrier_left_y_z, s7_288);
  const double s7_290 = mbgen::fnma((-c_carrier_left_x), work.R_carrier_left_y_x, s7_289);
  const double s7_291 = c_carrier_left_y*work.R_carrier_left_aux2_z_y;
  const double s7_292 = mbgen::fma(c_carrier_left_z, work.R_carrier_left_z_z, s7_291);
  const double s7_293 = mbgen::fnma((-c_carrier_left_x), work.R_carrier_left_z_x, s7_292);
  const double s7_294 = c_carrier_left_z*work.R_carrier_left_x_z;
  const double s7_295 = mbgen::fnma((-c_carrier_left_x), work.R_carrier_left_x_x, s7_294);
  const double s7_296 = mbgen::fnma(c_carrier_left_y, work.s1_12, s7_295);
  const double s7_297 = work.R_carrier_left_y_x*work.w_carrier_left_y;
  const double s7_298 = mbgen::fma(work.R_carrier_left_x_x, work.w_carrier_left_x, s7_297);
  const double s7_299 = mbgen::fma(work.R_carrier_left_z_x, work.w_carrier_left_z, s7_298);
  const double s7_300 = work.R_carrier_left_aux2_y_y*work.w_carrier_left_y;
  const double s7_301 = mbgen::fma(work.R_carrier_left_aux2_z_y, work.w_carrier_left_z, s7_300);
  const double s7_302 = mbgen::fnma(work.s1_12, work.w_carrier_left_x, s7_301);
  const double s7_303 = work.R_carrier_left_y_z*work.w_carrier_left_y;
  const double s7_304 = mbgen::fma(work.R_carrier_left_x_z, work.w_carrier_left_x, s7_303);
  const double s7_305 = mbgen::fma(work.R_carrier_left_z_z, work.w_carrier_left_z, s7_304);
  const double s7_306 = mbgen::fnma((-I_carrier_left_yz), s7_305, I_carrier_left_yy*s7_302);
  const double s7_307 = mbgen::fnma((-I_carrier_left_xy), s7_299, s7_306);
  const double s7_308 = mbgen::fnma((-I_carrier_left_xz), s7_305, I_carrier_left_xx*s7_299);
  const double s7_309 = mbgen::fnma((-I_carrier_left_xy), s7_302, s7_308);
  const double s7_310 = mbgen::fnma((-I_carrier_left_xz), s7_299, I_carrier_left_zz*s7_305);
  const double s7_311 = mbgen::fnma((-I_carrier_left_yz), s7_302, s7_310);
  // lower_arm_left: lower_arm_left, revolute, chassis
  const double R_lower_arm_left_z_y = work.sines[3];
  const double R_lower_arm_left_y_y = work.cosines[3];
  const double s7_312 = c_lower_arm_left_y*R_lower_arm_left_z_y;
  const double s7_313 = mbgen::fnma((-c_lower_arm_left_z), R_lower_arm_left_y_y, s7_312);
  const double s7_314 = (-c_lower_arm_left_z)*R_lower_arm_left_z_y;
  const double s7_315 = mbgen::fma(c_lower_arm_left_y, R_lower_arm_left_y_y, s7_314);
  const double s7_316 = R_lower_arm_left_z_y*work.w_chassis_z;
  const double s7_317 = mbgen::fma(R_lower_arm_left_y_y, work.w_chassis_y, s7_316);
  const double s7_318 = R_lower_arm_left_y_y*work.w_chassis_z;
  const double s7_319 = mbgen::fnma(R_lower_arm_left_z_y, work.w_chassis_y, s7_318);
  const double s7_320 = I_lower_arm_left_zz*s7_319;
  const double s7_321 = I_lower_arm_left_yy*s7_317;
  const double s7_322 = I_lower_arm_left_xx*work.w_lower_arm_left_x;
  // chassis: chassis_rx, revolute, chassis_aux5
  const double s7_323 = I_chassis_zz*work.w_chassis_z;
  const double s7_324 = mbgen::fnma((-I_chassis_xz), work.w_chassis_x, s7_323);
  const double s7_325 = I_chassis_yy*work.w_chassis_y;
  const double s7_326 = I_chassis_xx*work.w_chassis_x;
  const double s7_327 = mbgen::fnma((-I_chassis_xz), work.w_chassis_z, s7_326);
  // operations: 181 add, 334 multiply

  // --- step 9: outputs, energies, power ---
  const double s9_1 = state.zd[Coordinate::arb_rear_right]*tau[Coordinate::arb_rear_right];
  const double s9_2 = mbgen::fma(state.zd[Coordinate::wheel_rear_right],
      tau[Coordinate::wheel_rear_right], s9_1);
  const double s9_3 = mbgen::fma(state.zd[Coordinate::arb_rear_left],
      tau[Coordinate::arb_rear_left], s9_2);
  const double s9_4 = mbgen::fma(state.zd[Coordinate::wheel_rear_left],
      tau[Coordinate::wheel_rear_left], s9_3);
  const double s9_5 = mbgen::fma(state.zd[Coordinate::rear_axle_rx], tau[Coordinate::rear_axle_rx],
      s9_4);
  const double s9_6 = mbgen::fma(state.zd[Coordinate::rear_axle_ry], tau[Coordinate::rear_axle_ry],
      s9_5);
  const double s9_7 = mbgen::fma(state.zd[Coordinate::rear_axle_rz], tau[Coordinate::rear_axle_rz],
      s9_6);
  const double s9_8 = mbgen::fma(state.zd[Coordinate::rear_axle_tz], tau[Coordinate::rear_axle_tz],
      s9_7);
  const double s9_9 = mbgen::fma(state.zd[Coordinate::rear_axle_ty], tau[Coordinate::rear_axle_ty],
      s9_8);
  const double s9_10 = mbgen::fma(state.zd[Coordinate::rear_axle_tx], tau[Coordinate::rear_axle_tx],
      s9_9);
  const double s9_11 = mbgen::fma(state.zd[Coordinate::bell_crank], tau[Coordinate::bell_crank],
      s9_10);
  const double s9_12 = mbgen::fma(state.zd[Coordinate::pitman_arm], tau[Coordinate::pitman_arm],
      s9_11);
  const double s9_13 = mbgen::fma(state.zd[Coordinate::arb_front_right],
      tau[Coordinate::arb_front_right], s9_12);
  const double s9_14 = mbgen::fma(state.zd[Coordinate::upper_arm_right],
      tau[Coordinate::upper_arm_right], s9_13);
  const double s9_15 = mbgen::fma(state.zd[Coordinate::wheel_front_right],
      tau[Coordinate::wheel_front_right], s9_14);
  const double s9_16 = mbgen::fma(state.zd[Coordinate::carrier_right_ry],
      tau[Coordinate::carrier_right_ry], s9_15);
  const double s9_17 = mbgen::fma(state.zd[Coordinate::carrier_right_rx],
      tau[Coordinate::carrier_right_rx], s9_16);
  const double s9_18 = mbgen::fma(state.zd[Coordinate::carrier_right_rz],
      tau[Coordinate::carrier_right_rz], s9_17);
  const double s9_19 = mbgen::fma(state.zd[Coordinate::lower_arm_right],
      tau[Coordinate::lower_arm_right], s9_18);
  const double s9_20 = mbgen::fma(state.zd[Coordinate::arb_front_left],
      tau[Coordinate::arb_front_left], s9_19);
  const double s9_21 = mbgen::fma(state.zd[Coordinate::upper_arm_left],
      tau[Coordinate::upper_arm_left], s9_20);
  const double s9_22 = mbgen::fma(state.zd[Coordinate::wheel_front_left],
      tau[Coordinate::wheel_front_left], s9_21);
  const double s9_23 = mbgen::fma(state.zd[Coordinate::carrier_left_ry],
      tau[Coordinate::carrier_left_ry], s9_22);
  const double s9_24 = mbgen::fma(state.zd[Coordinate::carrier_left_rx],
      tau[Coordinate::carrier_left_rx], s9_23);
  const double s9_25 = mbgen::fma(state.zd[Coordinate::carrier_left_rz],
      tau[Coordinate::carrier_left_rz], s9_24);
  const double s9_26 = mbgen::fma(state.zd[Coordinate::lower_arm_left],
      tau[Coordinate::lower_arm_left], s9_25);
  const double s9_27 = mbgen::fma(state.zd[Coordinate::chassis_rx], tau[Coordinate::chassis_rx],
      s9_26);
  const double s9_28 = mbgen::fma(state.zd[Coordinate::chassis_ry], tau[Coordinate::chassis_ry],
      s9_27);
  const double s9_29 = mbgen::fma(state.zd[Coordinate::chassis_rz], tau[Coordinate::chassis_rz],
      s9_28);
  const double s9_30 = mbgen::fma(state.zd[Coordinate::chassis_tz], tau[Coordinate::chassis_tz],
      s9_29);
  const double s9_31 = mbgen::fma(state.zd[Coordinate::chassis_tx], tau[Coordinate::chassis_tx],
      s9_30);
  result.applied_power = mbgen::fma(state.zd[Coordinate::chassis_ty], tau[Coordinate::chassis_ty],
      s9_31);
  const double s9_32 = work.s7_75 + (work.s7_20 + (work.s7_17 + (work.s7_4 + work.s7_7)));
  const double s9_33 = work.s7_79 + (work.r_rear_axle_aux1_x + s9_32);
  const double s9_34 = work.r_rear_axle_aux1_x + (work.r_rear_axle_aux1_x + work.s7_82);
  const double s9_35 = work.r_rear_axle_aux1_x + (work.r_rear_axle_aux1_x + work.s7_85);
  const double s9_36 = work.r_rear_axle_aux1_x + s7_142;
  const double s9_37 = mbgen::fma(m_rear_axle, s9_36, 231.99999999999997);
  const double s9_38 = mbgen::fma(m_bell_crank, p_bell_crank_x - s7_156, s9_37);
  const double s9_39 = 8.5 + (s7_91 + (work.r_rear_axle_aux1_x + s9_33 - work.s7_88));
  const double s9_40 = mbgen::fma(m_pitman_arm, p_pitman_arm_x - s7_166, s9_38);
  const double s9_41 = 13.7 + (work.s7_45 + (work.s7_48 + (work.s7_37 - work.s7_33)));
  const double s9_42 = mbgen::fma(0.3333333333333333, s9_39, s9_40);
  const double s9_43 = 1.3 + (s7_116 + (s7_93 + (s7_178 + s7_252)));
  const double s9_44 = mbgen::fma(1.1666666666666667, s9_41, s9_42);
  const double s9_45 = mbgen::fma(m_arb_rear_right, s9_43, s9_44);
  const double s9_46 = mbgen::fma(1.5, 7.65 - work.s7_29 - work.s7_27, s9_45);
  const double s9_47 = mbgen::fma(3.0, work.s7_60 + s9_34, s9_46);
  const double s9_48 = mbgen::fma(2.6666666666666665, work.s7_67 + s9_35, s9_47);
  const double s9_49 = work.r_wheel_rear_left_x + work.r_wheel_rear_right_x;
  const double s9_50 = work.r_wheel_front_left_x + work.r_wheel_front_right_x;
  const double s9_51 = mbgen::fma(m_wheel_rear_right, s9_49, s9_48);
  const double s9_52 = mbgen::fma(m_wheel_front_right, s9_50, s9_51);
  const double s9_53 = mbgen::fma(work.w_chassis_x, s7_89, work.v_arb_rear_left_y);
  const double s9_54 = mbgen::fnma(work.w_rear_axle_z, work.s7_88, work.v_rear_axle_aux3_y);
  const double s9_55 = mbgen::fma(work.w_rear_axle_y, work.s7_88, work.v_rear_axle_aux3_z);
  const double s9_56 = mbgen::fnma((-p_diag_rod_left_from_z), work.w_chassis_x,
      work.v_arb_rear_right_z);
  const double s9_57 = mbgen::fma(work.w_rear_axle_z, work.s7_87, work.v_rear_axle_aux3_x);
  const double s9_58 = mbgen::fma(p_arb_link_rear_left_from_y, work.w_chassis_z,
      work.v_arb_rear_right_x);
  const double s9_59 = mbgen::fma((-p_diag_rod_left_from_z), work.w_chassis_x, work.v_chassis_y);
  const double s9_60 = mbgen::fma(work.w_rear_axle_z, work.s7_85, work.v_rear_axle_aux3_y);
  const double s9_61 = mbgen::fma((-p_diag_rod_left_from_x), work.w_chassis_y, work.v_chassis_z);
  const double s9_62 = mbgen::fma(work.w_rear_axle_x, work.s7_86, work.v_rear_axle_aux3_z);
  const double s9_63 = mbgen::fma(work.w_rear_axle_y, work.s7_84, work.v_rear_axle_aux3_x);
  const double s9_64 = mbgen::fma((-p_long_rod_left_from_z), work.w_chassis_x, work.v_chassis_y);
  const double s9_65 = mbgen::fma(work.w_rear_axle_x, work.s7_81, work.v_rear_axle_aux3_y);
  const double s9_66 = mbgen::fma((-p_long_rod_left_from_x), work.w_chassis_y, work.v_chassis_z);
  const double s9_67 = mbgen::fma(work.w_rear_axle_x, work.s7_83, work.v_rear_axle_aux3_z);
  const double s9_68 = mbgen::fma(p_long_rod_left_from_y, work.w_chassis_z, work.v_chassis_x);
  const double s9_69 = mbgen::fnma(work.w_rear_axle_y, work.s7_81, work.v_rear_axle_aux3_x);
  const double s9_70 = mbgen::fma(work.w_rear_axle_z, work.s7_79, work.v_rear_axle_aux3_y);
  const double s9_71 = mbgen::fma(work.w_chassis_x, work.s7_70, work.v_arb_rear_left_y);
  const double s9_72 = mbgen::fma(work.w_rear_axle_x, work.s7_80, work.v_rear_axle_aux3_z);
  const double s9_73 = mbgen::fma((-p_diag_rod_left_from_z), work.w_chassis_x,
      work.v_arb_rear_left_z);
  const double s9_74 = mbgen::fma(work.w_rear_axle_y, work.s7_78, work.v_rear_axle_aux3_x);
  const double s9_75 = mbgen::fnma(p_arb_link_rear_left_from_y, work.w_chassis_z,
      work.v_arb_rear_left_x);
  const double s9_76 = mbgen::fma(work.w_rear_axle_z, work.s7_67, work.v_rear_axle_aux3_y);
  const double s9_77 = mbgen::fma(work.w_rear_axle_x, work.s7_69, work.v_rear_axle_aux3_z);
  const double s9_78 = mbgen::fma(work.w_rear_axle_y, work.s7_65, work.v_rear_axle_aux3_x);
  const double s9_79 = mbgen::fma(work.w_rear_axle_z, work.s7_60, work.v_rear_axle_aux3_y);
  const double s9_80 = mbgen::fma(work.w_rear_axle_x, work.s7_63, work.v_rear_axle_aux3_z);
  const double s9_81 = mbgen::fma(work.w_rear_axle_y, work.s7_57, work.v_rear_axle_aux3_x);
  const double s9_82 = mbgen::fnma((-p_long_rod_left_from_z), work.w_chassis_y, work.v_chassis_x);
  const double s9_83 = mbgen::fma(work.w_carrier_right_z, work.s7_48, work.v_carrier_right_aux1_y);
  const double s9_84 = mbgen::fma(work.w_carrier_right_y, work.s7_54, work.v_carrier_right_aux1_x);
  const double s9_85 = mbgen::fma(work.w_carrier_right_x, work.s7_51, work.v_carrier_right_aux1_z);
  const double s9_86 = mbgen::fnma(work.w_chassis_x, work.s7_44, work.v_bell_crank_z);
  const double s9_87 = mbgen::fma(work.w_carrier_left_z, work.s7_37, work.v_carrier_left_aux1_y);
  const double s9_88 = mbgen::fma(work.w_carrier_left_y, work.s7_43, work.v_carrier_left_aux1_x);
  const double s9_89 = mbgen::fma(work.w_carrier_left_x, work.s7_40, work.v_carrier_left_aux1_z);
  const double s9_90 = mbgen::fma(work.w_chassis_y, work.s7_33, work.v_bell_crank_z);
  const double s9_91 = mbgen::fma(work.w_chassis_x, work.s7_28, work.v_pitman_arm_y);
  const double s9_92 = mbgen::fma(work.w_chassis_y, work.s7_29, work.v_bell_crank_z);
  const double s9_93 = mbgen::fnma(work.w_bell_crank_z, work.s7_29, work.v_bell_crank_y);
  const double s9_94 = mbgen::fnma(work.w_pitman_arm_y, work.s7_28, work.v_pitman_arm_x);
  const double s9_95 = mbgen::fnma(work.w_bell_crank_z, work.s7_30, work.v_bell_crank_x);
  const double s9_96 = s9_93*mbgen::fnma(work.w_chassis_z, work.s7_27, s9_91);
  const double s9_97 = mbgen::fma(work.w_pitman_arm_y, work.s7_27, work.v_pitman_arm_z);
  const double s9_98 = mbgen::fma(work.w_chassis_x, work.s7_30, s9_92);
  const double s9_99 = mbgen::fma(work.w_carrier_left_z, work.s7_7, work.v_carrier_left_aux1_y);
  const double s9_100 = mbgen::fma(work.w_chassis_z, work.s7_4, work.v_arb_front_left_y);
  const double s9_101 = mbgen::fma(work.w_carrier_left_x, work.s7_10, work.v_carrier_left_aux1_z);
  const double s9_102 = mbgen::fma(p_arb_link_front_left_from_y, work.w_chassis_x,
      work.v_arb_front_left_z);
  const double s9_103 = mbgen::fma(work.w_carrier_left_y, work.s7_13, work.v_carrier_left_aux1_x);
  const double s9_104 = mbgen::fnma(p_arb_link_front_left_from_y, work.w_chassis_z,
      work.v_arb_front_left_x);
  const double s9_105 = mbgen::fma(work.w_chassis_z, work.s7_17, work.v_arb_front_left_y);
  const double s9_106 = mbgen::fma(work.w_carrier_right_z, work.s7_20, work.v_carrier_right_aux1_y);
  const double s9_107 = mbgen::fma(work.w_carrier_right_x, work.s7_23, work.v_carrier_right_aux1_z);
  const double s9_108 = mbgen::fnma(p_arb_link_front_left_from_y, work.w_chassis_x,
      work.v_arb_front_right_z);
  const double s9_109 = mbgen::fma(work.w_carrier_right_y, work.s7_26, work.v_carrier_right_aux1_x);
  const double s9_110 = mbgen::fma(p_arb_link_front_left_from_y, work.w_chassis_z,
      work.v_arb_front_right_x);
  const double s9_111 = mbgen::fma(work.w_chassis_x, s7_92, work.v_arb_rear_left_y);
  const double s9_112 = mbgen::fma(work.w_chassis_z, s7_93, s9_111);
  const double s9_113 = mbgen::fma(c_arb_rear_left_y, work.w_chassis_z, work.v_arb_rear_right_x);
  const double s9_114 = mbgen::fnma(work.w_arb_rear_right_y, s7_92, s9_113);
  const double s9_115 = mbgen::fnma(c_arb_rear_left_y, work.w_chassis_x, work.v_arb_rear_right_z);
  const double s9_116 = mbgen::fnma(work.w_arb_rear_right_y, s7_93, s9_115);
  const double s9_117 = mbgen::fma(work.w_chassis_x, s7_115, work.v_arb_rear_left_y);
  const double s9_118 = mbgen::fma(work.w_chassis_z, s7_116, s9_117);
  const double s9_119 = mbgen::fma(c_arb_rear_left_y, work.w_chassis_x, work.v_arb_rear_left_z);
  const double s9_120 = mbgen::fnma(work.w_arb_rear_left_y, s7_116, s9_119);
  const double s9_121 = mbgen::fnma(c_arb_rear_left_y, work.w_chassis_z, work.v_arb_rear_left_x);
  const double s9_122 = mbgen::fnma(work.w_arb_rear_left_y, s7_115, s9_121);
  const double s9_123 = mbgen::fma(work.w_rear_axle_z, s7_142, work.v_rear_axle_aux3_y);
  const double s9_124 = mbgen::fnma(work.w_rear_axle_x, s7_140, s9_123);
  const double s9_125 = mbgen::fma(work.w_rear_axle_x, s7_139, work.v_rear_axle_aux3_z);
  const double s9_126 = mbgen::fnma(work.w_rear_axle_y, s7_142, s9_125);
  const double s9_127 = mbgen::fma(work.w_rear_axle_y, s7_140, work.v_rear_axle_aux3_x);
  const double s9_128 = mbgen::fnma(work.w_rear_axle_z, s7_139, s9_127);
  const double s9_129 = mbgen::fnma(work.w_bell_crank_z, s7_156, work.v_bell_crank_y);
  const double s9_130 = mbgen::fnma(work.w_bell_crank_z, s7_158, work.v_bell_crank_x);
  const double s9_131 = mbgen::fma(work.w_chassis_y, s7_156, work.v_bell_crank_z);
  const double s9_132 = mbgen::fma(work.w_chassis_x, s7_158, s9_131);
  const double s9_133 = mbgen::fma(work.w_pitman_arm_y, s7_166, work.v_pitman_arm_z);
  const double s9_134 = mbgen::fnma(work.w_pitman_arm_y, s7_167, work.v_pitman_arm_x);
  const double s9_135 = mbgen::fma(work.w_chassis_x, s7_167, work.v_pitman_arm_y);
  const double s9_136 = mbgen::fnma(work.w_chassis_z, s7_166, s9_135);
  const double s9_137 = mbgen::fma(work.w_chassis_z, s7_178, work.v_arb_front_left_y);
  const double s9_138 = mbgen::fnma(work.w_chassis_x, s7_176, s9_137);
  const double s9_139 = mbgen::fma(c_arb_front_left_y, work.w_chassis_z, work.v_arb_front_right_x);
  const double s9_140 = mbgen::fma(work.w_arb_front_right_y, s7_176, s9_139);
  const double s9_141 = mbgen::fnma(c_arb_front_left_y, work.w_chassis_x, work.v_arb_front_right_z);
  const double s9_142 = mbgen::fnma(work.w_arb_front_right_y, s7_178, s9_141);
  const double s9_143 = mbgen::fma(work.w_upper_arm_right_x, s7_194, work.v_upper_arm_left_y);
  const double s9_144 = mbgen::fma(work.w_upper_arm_right_x, s7_192, work.v_upper_arm_right_z);
  const double s9_145 = mbgen::fnma(work.w_chassis_y, s7_194, work.v_upper_arm_right_x);
  const double s9_146 = mbgen::fnma(work.w_chassis_z, s7_192, s9_145);
  const double s9_147 = mbgen::fma(work.w_carrier_right_z, s7_222, work.v_carrier_right_aux1_y);
  const double s9_148 = mbgen::fnma(work.w_carrier_right_x, s7_219, s9_147);
  const double s9_149 = mbgen::fma(work.w_carrier_right_x, s7_216, work.v_carrier_right_aux1_z);
  const double s9_150 = mbgen::fnma(work.w_carrier_right_y, s7_222, s9_149);
  const double s9_151 = mbgen::fma(work.w_carrier_right_y, s7_219, work.v_carrier_right_aux1_x);
  const double s9_152 = mbgen::fnma(work.w_carrier_right_z, s7_216, s9_151);
  const double s9_153 = mbgen::fma(work.w_lower_arm_right_x, s7_241, work.v_lower_arm_left_y);
  const double s9_154 = mbgen::fma(work.w_lower_arm_right_x, s7_239, work.v_lower_arm_right_z);
  const double s9_155 = mbgen::fnma(work.w_chassis_y, s7_241, work.v_lower_arm_right_x);
  const double s9_156 = mbgen::fnma(work.w_chassis_z, s7_239, s9_155);
  const double s9_157 = mbgen::fma(work.w_chassis_z, s7_252, work.v_arb_front_left_y);
  const double s9_158 = mbgen::fnma(work.w_chassis_x, s7_250, s9_157);
  const double s9_159 = mbgen::fma(c_arb_front_left_y, work.w_chassis_x, work.v_arb_front_left_z);
  const double s9_160 = mbgen::fnma(work.w_arb_front_left_y, s7_252, s9_159);
  const double s9_161 = mbgen::fnma(c_arb_front_left_y, work.w_chassis_z, work.v_arb_front_left_x);
  const double s9_162 = mbgen::fma(work.w_arb_front_left_y, s7_250, s9_161);
  const double s9_163 = mbgen::fnma(work.w_upper_arm_left_x, s7_266, work.v_upper_arm_left_y);
  const double s9_164 = mbgen::fma(work.w_upper_arm_left_x, s7_268, work.v_upper_arm_left_z);
  const double s9_165 = mbgen::fma(work.w_chassis_y, s7_266, work.v_upper_arm_left_x);
  const double s9_166 = mbgen::fnma(work.w_chassis_z, s7_268, s9_165);
  const double s9_167 = mbgen::fma(work.w_carrier_left_z, s7_296, work.v_carrier_left_aux1_y);
  const double s9_168 = mbgen::fnma(work.w_carrier_left_x, s7_293, s9_167);
  const double s9_169 = mbgen::fma(work.w_carrier_left_x, s7_290, work.v_carrier_left_aux1_z);
  const double s9_170 = mbgen::fnma(work.w_carrier_left_y, s7_296, s9_169);
  const double s9_171 = mbgen::fma(work.w_carrier_left_y, s7_293, work.v_carrier_left_aux1_x);
  const double s9_172 = mbgen::fnma(work.w_carrier_left_z, s7_290, s9_171);
  const double s9_173 = mbgen::fma((-c_chassis_x), work.w_chassis_y, work.v_chassis_z);
  const double s9_174 = mbgen::fma(c_chassis_z, work.w_chassis_y, work.v_chassis_x);
  const double s9_175 = mbgen::fnma((-c_chassis_x), work.w_chassis_z, work.v_chassis_y);
  const double s9_176 = mbgen::fnma(c_chassis_z, work.w_chassis_x, s9_175);
  const double s9_177 = mbgen::fnma(work.w_lower_arm_left_x, s7_313, work.v_lower_arm_left_y);
  const double s9_178 = mbgen::fma(work.w_lower_arm_left_x, s7_315, work.v_lower_arm_left_z);
  const double s9_179 = mbgen::fma(work.w_chassis_y, s7_313, work.v_lower_arm_left_x);
  const double s9_180 = mbgen::fnma(work.w_chassis_z, s7_315, s9_179);
  const double s9_181 = mbgen::fma(s9_162, s9_162, mbgen::fma(s9_160, s9_160, s9_158*s9_158));
  const double s9_182 = mbgen::fma(s9_140, s9_140, mbgen::fma(s9_138, s9_138, s9_181));
  const double s9_183 = mbgen::fma(s9_112, s9_112, mbgen::fma(s9_142, s9_142, s9_182));
  const double s9_184 = mbgen::fma(s9_116, s9_116, mbgen::fma(s9_114, s9_114, s9_183));
  const double s9_185 = mbgen::fma(s9_120, s9_120, mbgen::fma(s9_118, s9_118, s9_184));
  const double s9_186 = mbgen::fnma(work.w_carrier_right_x, work.s7_26, s9_106);
  const double s9_187 = mbgen::fnma(work.w_arb_front_right_y, work.s7_17, s9_108);
  const double s9_188 = mbgen::fnma(work.w_chassis_x, work.s7_15, s9_105)*s9_186;
  const double s9_189 = mbgen::fnma(work.w_carrier_right_y, work.s7_20, s9_107);
  const double s9_190 = mbgen::fma(work.w_arb_front_right_y, work.s7_15, s9_110);
  const double s9_191 = mbgen::fnma(work.w_carrier_right_z, work.s7_23, s9_109);
  const double s9_192 = mbgen::fma(s9_191, s9_190, mbgen::fma(s9_189, s9_187, s9_188));
  const double s9_193 = mbgen::fnma(work.w_carrier_left_x, work.s7_13, s9_99);
  const double s9_194 = mbgen::fnma(work.w_chassis_x, work.s7_2, s9_100);
  const double s9_195 = mbgen::fnma(work.w_arb_front_left_y, work.s7_4, s9_102);
  const double s9_196 = mbgen::fnma(work.w_carrier_left_y, work.s7_7, s9_101);
  const double s9_197 = mbgen::fma(s9_196, s9_195, mbgen::fma(s9_193, s9_194, s9_192));
  const double s9_198 = mbgen::fnma(work.w_carrier_left_z, work.s7_10, s9_103);
  const double s9_199 = mbgen::fma(work.w_arb_front_left_y, work.s7_2, s9_104);
  const double s9_200 = mbgen::fnma(work.w_rear_axle_x, s7_90, s9_54);
  const double s9_201 = mbgen::fma(work.w_chassis_z, s7_91, s9_53);
  const double s9_202 = mbgen::fma(s9_201, s9_200, mbgen::fma(s9_198, s9_199, s9_197));
  const double s9_203 = mbgen::fnma(work.w_rear_axle_x, work.s7_87, s9_55);
  const double s9_204 = mbgen::fnma(work.w_arb_rear_right_y, s7_91, s9_56);
  const double s9_205 = mbgen::fnma(work.w_arb_rear_right_y, s7_89, s9_58);
  const double s9_206 = mbgen::fma(work.w_rear_axle_y, s7_90, s9_57);
  const double s9_207 = mbgen::fma(s9_206, s9_205, mbgen::fma(s9_203, s9_204, s9_202));
  const double s9_208 = mbgen::fnma(work.w_rear_axle_x, work.s7_78, s9_70);
  const double s9_209 = mbgen::fma(work.w_chassis_z, work.s7_75, s9_71);
  const double s9_210 = mbgen::fnma(work.w_arb_rear_left_y, work.s7_75, s9_73);
  const double s9_211 = mbgen::fnma(work.w_rear_axle_y, work.s7_79, s9_72);
  const double s9_212 = mbgen::fma(s9_211, s9_210, mbgen::fma(s9_208, s9_209, s9_207));
  const double s9_213 = mbgen::fnma(work.w_arb_rear_left_y, work.s7_70, s9_75);
  const double s9_214 = mbgen::fnma(work.w_rear_axle_z, work.s7_80, s9_74);
  const double s9_215 = work.v_wheel_rear_right_y*work.v_wheel_rear_right_y;
  const double s9_216 = mbgen::fma(work.v_wheel_rear_right_z, work.v_wheel_rear_right_z, s9_215);
  const double s9_217 = mbgen::fma(work.v_wheel_rear_right_x, work.v_wheel_rear_right_x, s9_216);
  const double s9_218 = mbgen::fma(work.v_wheel_rear_left_y, work.v_wheel_rear_left_y, s9_217);
  const double s9_219 = mbgen::fma(work.v_wheel_rear_left_z, work.v_wheel_rear_left_z, s9_218);
  const double s9_220 = mbgen::fma(s9_146, s9_146, mbgen::fma(s9_144, s9_144, s9_143*s9_143));
  const double s9_221 = mbgen::fma(s9_164, s9_164, mbgen::fma(s9_163, s9_163, s9_220));
  const double s9_222 = work.v_wheel_front_right_y*work.v_wheel_front_right_y;
  const double s9_223 = mbgen::fma(work.v_wheel_front_right_z, work.v_wheel_front_right_z, s9_222);
  const double s9_224 = mbgen::fma(work.v_wheel_front_right_x, work.v_wheel_front_right_x, s9_223);
  const double s9_225 = mbgen::fma(work.v_wheel_front_left_y, work.v_wheel_front_left_y, s9_224);
  const double s9_226 = mbgen::fma(work.v_wheel_front_left_z, work.v_wheel_front_left_z, s9_225);
  const double s9_227 = mbgen::fma(s9_152, s9_152, mbgen::fma(s9_150, s9_150, s9_148*s9_148));
  const double s9_228 = mbgen::fma(s9_170, s9_170, mbgen::fma(s9_168, s9_168, s9_227));
  const double s9_229 = mbgen::fma(s9_156, s9_156, mbgen::fma(s9_154, s9_154, s9_153*s9_153));
  const double s9_230 = mbgen::fma(s9_178, s9_178, mbgen::fma(s9_177, s9_177, s9_229));
  const double s9_231 = mbgen::fnma(work.w_rear_axle_x, work.s7_84, s9_60);
  const double s9_232 = mbgen::fnma(p_lower_arm_left_y, work.w_chassis_x, s9_61);
  const double s9_233 = mbgen::fnma((-p_diag_rod_left_from_z), work.w_chassis_y, work.s4_19);
  const double s9_234 = s9_232*mbgen::fnma(work.w_rear_axle_y, work.s7_85, s9_62);
  const double s9_235 = mbgen::fnma(work.w_rear_axle_z, work.s7_86, s9_63);
  const double s9_236 = mbgen::fma((-p_diag_rod_left_from_x), work.w_chassis_y, work.s4_9);
  const double s9_237 = mbgen::fnma(work.w_rear_axle_y, work.s7_67, s9_77);
  const double s9_238 = mbgen::fnma((-p_diag_rod_left_from_z), work.w_chassis_y, work.s4_7);
  const double s9_239 = mbgen::fma(s9_236, s9_237, mbgen::fma(s9_233, s9_235, s9_234));
  const double s9_240 = mbgen::fnma(work.w_rear_axle_z, work.s7_69, s9_78);
  const double s9_241 = mbgen::fnma((-p_diag_rod_left_from_x), work.w_chassis_z, s9_59);
  const double s9_242 = s9_231 + mbgen::fnma(work.w_rear_axle_x, work.s7_65, s9_76);
  const double s9_243 = mbgen::fnma(work.w_rear_axle_x, work.s7_57, s9_79);
  const double s9_244 = mbgen::fnma((-p_long_rod_left_from_z), work.w_chassis_x, s9_66);
  const double s9_245 = mbgen::fnma((-p_long_rod_left_from_z), work.w_chassis_y, s9_68);
  const double s9_246 = s9_244*mbgen::fnma(work.w_rear_axle_y, work.s7_82, s9_67);
  const double s9_247 = mbgen::fnma(work.w_rear_axle_z, work.s7_83, s9_69);
  const double s9_248 = mbgen::fma((-p_long_rod_left_from_z), work.w_chassis_x, s9_66);
  const double s9_249 = mbgen::fnma(work.w_rear_axle_y, work.s7_60, s9_80);
  const double s9_250 = mbgen::fma(s9_248, s9_249, mbgen::fma(s9_245, s9_247, s9_246));
  const double s9_251 = mbgen::fnma(p_long_rod_left_from_y, work.w_chassis_z, s9_82);
  const double s9_252 = mbgen::fnma(work.w_rear_axle_z, work.s7_63, s9_81);
  const double s9_253 = mbgen::fnma((-p_long_rod_left_from_x), work.w_chassis_z, s9_64);
  const double s9_254 = mbgen::fma(work.w_rear_axle_z, work.s7_82, s9_65) + s9_243;
  const double s9_255 = mbgen::fma(work.w_bell_crank_z, work.s7_45, work.v_bell_crank_y);
  const double s9_256 = mbgen::fma(work.w_bell_crank_z, work.s7_44, work.v_bell_crank_x);
  const double s9_257 = s9_255*mbgen::fnma(work.w_carrier_right_x, work.s7_54, s9_83);
  const double s9_258 = mbgen::fnma(work.w_carrier_right_z, work.s7_51, s9_84);
  const double s9_259 = mbgen::fnma(work.w_carrier_right_y, work.s7_48, s9_85);
  const double s9_260 = mbgen::fnma(work.w_chassis_y, work.s7_45, s9_86);
  const double s9_261 = mbgen::fnma(work.w_bell_crank_z, work.s7_33, work.v_bell_crank_y);
  const double s9_262 = mbgen::fma(s9_259, s9_260, mbgen::fma(s9_256, s9_258, s9_257));
  const double s9_263 = mbgen::fnma(work.w_carrier_left_x, work.s7_43, s9_87);
  const double s9_264 = mbgen::fnma(work.w_bell_crank_z, work.s7_34, work.v_bell_crank_x);
  const double s9_265 = mbgen::fnma(work.w_carrier_left_z, work.s7_40, s9_88);
  const double s9_266 = mbgen::fma(s9_264, s9_265, mbgen::fma(s9_261, s9_263, s9_262));
  const double s9_267 = mbgen::fnma(work.w_carrier_left_y, work.s7_37, s9_89);
  const double s9_268 = mbgen::fma(work.w_chassis_x, work.s7_34, s9_90);
  const double s9_269 = 3.0*mbgen::fma(s9_97, s9_98, mbgen::fma(s9_94, s9_95, s9_96));
  const double s9_270 = mbgen::fma(work.w_arb_rear_right_y, s7_97, s9_269);
  const double s9_271 = mbgen::fma(s7_95, s7_99, mbgen::fma(s7_101, s7_102, s9_270));
  const double s9_272 = mbgen::fma(s7_108, s7_109, mbgen::fma(s7_113, s7_114, s9_271));
  const double s9_273 = mbgen::fma(s7_105, s7_110, s9_272);
  const double s9_274 = mbgen::fma(work.w_arb_rear_left_y, s7_120, s9_273);
  const double s9_275 = mbgen::fma(s7_118, s7_122, mbgen::fma(s7_124, s7_125, s9_274));
  const double s9_276 = mbgen::fma(s7_131, s7_132, mbgen::fma(s7_136, s7_137, s9_275));
  const double s9_277 = mbgen::fma(s7_153, s7_154, mbgen::fma(s7_128, s7_133, s9_276));
  const double s9_278 = mbgen::fma(s9_128, s9_128, mbgen::fma(s9_126, s9_126, s9_124*s9_124));
  const double s9_279 = mbgen::fma(s7_145, s7_150, mbgen::fma(s7_148, s7_149, s9_277));
  const double s9_280 = mbgen::fma(s7_160, s7_164, mbgen::fma(m_rear_axle, s9_278, s9_279));
  const double s9_281 = mbgen::fma(work.w_bell_crank_z, s7_161, s9_280);
  const double s9_282 = mbgen::fma(s9_132, s9_132, mbgen::fma(s9_130, s9_130, s9_129*s9_129));
  const double s9_283 = mbgen::fma(m_bell_crank, s9_282, mbgen::fma(s7_163, s7_165, s9_281));
  const double s9_284 = mbgen::fma(work.w_pitman_arm_y, s7_170, s9_283);
  const double s9_285 = mbgen::fma(s9_136, s9_136, mbgen::fma(s9_134, s9_134, s9_133*s9_133));
  const double s9_286 = mbgen::fma(s7_169, s7_171, mbgen::fma(s7_173, s7_174, s9_284));
  const double s9_287 = mbgen::fma(m_pitman_arm, s9_285, s9_286);
  const double s9_288 = mbgen::fma(work.w_arb_front_right_y, s7_185, s9_287);
  const double s9_289 = mbgen::fma(s7_180, s7_187, mbgen::fma(s7_182, s7_190, s9_288));
  const double s9_290 = mbgen::fma(s7_196, s7_200, s9_289);
  const double s9_291 = mbgen::fma(work.w_upper_arm_right_x, s7_201, s9_290);
  const double s9_292 = mbgen::fma(s7_207, s7_208, mbgen::fma(s7_198, s7_199, s9_291));
  const double s9_293 = mbgen::fma(s7_212, s7_213, mbgen::fma(s7_204, s7_209, s9_292));
  const double s9_294 = mbgen::fma(s7_225, s7_235, mbgen::fma(s7_228, s7_233, s9_293));
  const double s9_295 = mbgen::fma(s7_243, s7_247, mbgen::fma(s7_231, s7_237, s9_294));
  const double s9_296 = mbgen::fma(work.w_lower_arm_right_x, s7_248, s9_295);
  const double s9_297 = mbgen::fma(s7_245, s7_246, s9_296);
  const double s9_298 = mbgen::fma(work.w_arb_front_left_y, s7_259, s9_297);
  const double s9_299 = mbgen::fma(s7_254, s7_262, mbgen::fma(s7_256, s7_264, s9_298));
  const double s9_300 = mbgen::fma(s7_270, s7_274, s9_299);
  const double s9_301 = mbgen::fma(work.w_upper_arm_left_x, s7_275, s9_300);
  const double s9_302 = mbgen::fma(s7_281, s7_282, mbgen::fma(s7_272, s7_273, s9_301));
  const double s9_303 = mbgen::fma(s7_286, s7_287, mbgen::fma(s7_278, s7_283, s9_302));
  const double s9_304 = mbgen::fma(s7_299, s7_309, mbgen::fma(s7_302, s7_307, s9_303));
  const double s9_305 = mbgen::fma(s7_317, s7_321, mbgen::fma(s7_305, s7_311, s9_304));
  const double s9_306 = mbgen::fma(work.w_lower_arm_left_x, s7_322, s9_305);
  const double s9_307 = mbgen::fma(work.w_chassis_y, s7_325, mbgen::fma(s7_319, s7_320, s9_306));
  const double s9_308 = mbgen::fma(work.w_chassis_x, s7_327, s9_307);
  const double s9_309 = mbgen::fma(s9_176, s9_176, mbgen::fma(s9_174, s9_174, s9_173*s9_173));
  const double s9_310 = mbgen::fma(work.w_chassis_z, s7_324, s9_308);
  const double s9_311 = mbgen::fma(m_chassis, s9_309, s9_310);
  const double s9_312 = mbgen::fma(m_arb_rear_right, mbgen::fma(s9_122, s9_122, s9_185), s9_311);
  const double s9_313 = mbgen::fma(s9_214, s9_213, s9_212);
  const double s9_314 = mbgen::fma(work.v_wheel_rear_left_x, work.v_wheel_rear_left_x, s9_219);
  const double s9_315 = mbgen::fma(0.6666666666666666, s9_313, s9_312);
  const double s9_316 = mbgen::fma(m_wheel_rear_right, s9_314, s9_315);
  const double s9_317 = mbgen::fma(s9_166, s9_166, s9_221);
  const double s9_318 = mbgen::fma(work.v_wheel_front_left_x, work.v_wheel_front_left_x, s9_226);
  const double s9_319 = mbgen::fma(m_upper_arm_right, s9_317, s9_316);
  const double s9_320 = mbgen::fma(m_wheel_front_right, s9_318, s9_319);
  const double s9_321 = mbgen::fma(m_carrier_right, mbgen::fma(s9_172, s9_172, s9_228), s9_320);
  const double s9_322 = mbgen::fma(s9_180, s9_180, s9_230);
  const double s9_323 = mbgen::fma(s9_241, s9_242, mbgen::fma(s9_240, s9_238, s9_239));
  const double s9_324 = mbgen::fma(m_lower_arm_right, s9_322, s9_321);
  const double s9_325 = mbgen::fma(s9_253, s9_254, mbgen::fma(s9_252, s9_251, s9_250));
  const double s9_326 = mbgen::fma(6.0, s9_325, mbgen::fma(5.333333333333333, s9_323, s9_324));
  const double s9_327 = mbgen::fma(s9_267, s9_268, s9_266);
  result.kinetic_energy = 0.5*mbgen::fma(2.3333333333333335, s9_327, s9_326);
  const double z_rear_axle_ty = state.z[Coordinate::rear_axle_ty];
  const double s9_328 = work.r_carrier_right_aux1_y + (work.r_carrier_left_aux1_y + work.s7_10);
  const double s9_329 = z_rear_axle_ty + (z_rear_axle_ty + (work.s7_23 + s9_328) - work.s7_87);
  const double s9_330 = work.s7_51 + (work.r_carrier_right_aux1_y + work.s7_34);
  const double s9_331 = work.r_carrier_left_aux1_y + (work.r_carrier_right_aux1_y + s7_216);
  const double s9_332 = mbgen::fma(1.5, work.s7_30, 5.25);
  const double s9_333 = mbgen::fma(m_rear_axle, z_rear_axle_ty + s7_139, s9_332);
  const double s9_334 = mbgen::fma(m_bell_crank, s7_158, s9_333);
  const double s9_335 = work.s7_40 + (work.r_carrier_left_aux1_y + s9_330) - work.s7_44;
  const double s9_336 = mbgen::fma(0.3333333333333333, work.s7_80 + s9_329, s9_334);
  const double s9_337 = work.s7_63 + (z_rear_axle_ty + (z_rear_axle_ty + work.s7_83));
  const double s9_338 = mbgen::fma(3.0, s9_337, mbgen::fma(1.1666666666666667, s9_335, s9_336));
  const double s9_339 = work.s7_69 + (z_rear_axle_ty + (z_rear_axle_ty + work.s7_86));
  const double s9_340 = work.r_wheel_rear_left_y + work.r_wheel_rear_right_y;
  const double s9_341 = mbgen::fma(2.6666666666666665, s9_339, s9_338);
  const double s9_342 = mbgen::fma(m_wheel_rear_right, s9_340, s9_341);
  const double s9_343 = work.r_wheel_front_left_y + work.r_wheel_front_right_y;
  const double s9_344 = mbgen::fma(m_upper_arm_right, s7_192 + s7_268, s9_342);
  const double s9_345 = mbgen::fma(m_wheel_front_right, s9_343, s9_344);
  const double s9_346 = mbgen::fma(m_carrier_right, s7_290 + s9_331, s9_345);
  const double s9_347 = work.s7_15 + (work.s7_13 + (work.r_carrier_left_aux1_z + work.s7_2));
  const double s9_348 = s7_90 + (work.r_rear_axle_aux3_z + (work.s7_26 + s9_347 - work.s1_32));
  const double s9_349 = work.s7_78 + (work.r_rear_axle_aux3_z + s9_348) - work.s7_70 - s7_89;
  const double s9_350 = work.r_rear_axle_aux3_z + (work.r_rear_axle_aux3_z - work.s7_81);
  const double s9_351 = work.r_rear_axle_aux3_z + (work.r_rear_axle_aux3_z + work.s7_84);
  const double s9_352 = mbgen::fma(m_rear_axle, work.r_rear_axle_aux3_z + s7_140, 3350.4);
  const double s9_353 = mbgen::fnma(m_pitman_arm, (-p_pitman_arm_z) + s7_167, s9_352);
  const double s9_354 = mbgen::fnma(1.5, (-p_pitman_arm_z) + work.s7_28, s9_353);
  const double s9_355 = mbgen::fma(0.3333333333333333, s9_349 - 1.9, s9_354);
  const double s9_356 = s7_176 + s7_250 - s7_115 - s7_92 - 1.9;
  const double s9_357 = work.s7_43 + (work.r_carrier_left_aux1_z + (work.s7_54 - work.s1_32));
  const double s9_358 = mbgen::fma(m_arb_rear_right, s9_356, s9_355);
  const double s9_359 = mbgen::fma(1.1666666666666667, s9_357, s9_358);
  const double s9_360 = mbgen::fma(3.0, work.s7_57 + s9_350, s9_359);
  const double s9_361 = mbgen::fma(2.6666666666666665, work.s7_65 + s9_351, s9_360);
  const double s9_362 = work.r_wheel_rear_left_z + work.r_wheel_rear_right_z;
  const double s9_363 = mbgen::fma(m_wheel_rear_right, s9_362, s9_361);
  const double s9_364 = mbgen::fma(m_upper_arm_right, s7_266 - s7_194 - 0.56, s9_363);
  const double s9_365 = work.r_wheel_front_left_z + work.r_wheel_front_right_z;
  const double s9_366 = s7_293 + (work.r_carrier_left_aux1_z + (s7_219 - work.s1_32));
  const double s9_367 = mbgen::fma(m_wheel_front_right, s9_365, s9_364);
  const double s9_368 = mbgen::fma(m_carrier_right, s9_366, s9_367);
  const double s9_369 = mbgen::fma(m_lower_arm_right, s7_239 + s7_315, s9_346);
  const double s9_370 = 15305.999999999998*work.r_chassis_aux3_z;
  const double s9_371 = mbgen::fma(m_lower_arm_right, s7_313 - s7_241 - 1.24, s9_368);
  const double s9_372 = mbgen::fma(work.R_chassis_z_y, s9_369, s9_370);
  const double s9_373 = mbgen::fma(m_carrier_right, 7.2 + (s7_222 + s7_296), s9_52);
  const double s9_374 = mbgen::fma(work.R_chassis_z_z, s9_371, s9_372);
  result.potential_energy = (-g_z)*mbgen::fnma(work.sines[1], s9_373, s9_374);
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
